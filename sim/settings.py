"""Named settings of the physics and of the verdicts, each with its unit."""

from typing import Annotated

from msgspec import Meta

from thinkblox.checked import AboveZero, CheckedValue, NotNegative, Number, Share


class Tolerances(CheckedValue, kw_only=True, frozen=True):
    """Where a verdict draws its lines.

    Attributes:
        penetration: deepest contact that is still resting or touching [m].
        outside: how far an object may reach out of the room [m].
        touching: how near a mounted object must be to the wall or ceiling it hangs on [m].
        clearance: gap above its support that an object may be put down with [m].
        drift: horizontal motion while settling [m].
        drop: sinking while settling, beyond `clearance` [m].
        tilt: change of orientation while settling [degrees].
        pushed: how far it may move another object while settling [m].
        opens: least share of its range that a door or drawer must open.
        carried: least share of its weight that must be borne by something once it has settled.
        hold_drift, hold_tilt: motion of a settled scene's objects in `Physics.hold_time` [m, degrees].
        size: by how much a placement's size may differ from its asset's [m].
    """

    penetration: NotNegative = 0.001
    outside: NotNegative = 0.001
    touching: NotNegative = 0.010
    clearance: NotNegative = 0.003
    drift: NotNegative = 0.005
    drop: NotNegative = 0.010
    tilt: NotNegative = 2.0
    pushed: NotNegative = 0.005
    opens: Share = 0.6
    carried: Share = 0.5
    hold_drift: NotNegative = 0.010
    hold_tilt: NotNegative = 2.0
    size: NotNegative = 0.010


class Physics(CheckedValue, kw_only=True, frozen=True):
    """How the engine is run; the exported model carries the same options.

    Attributes:
        timestep: [s].
        solref: time constant [s] and damping ratio of contacts; at least two timesteps.
        impratio: ratio of frictional to normal constraint impedance, against creep.
        gravity: [m/s2].
        settle_time: how long a candidate may take to come to rest, and everything that it set in motion, and how long
            they are watched where they do not stand squarely [s].
        rest_time: longest settle of a whole scene before its keyframe is taken [s].
        hold_time: how long a settled scene must stand still [s].
        chunk: steps between two looks at what settles.
        lost, toppled: motion [m] and rotation [degrees] past which a settle is given up; what rocks by less may come
            back.
        ground_friction: of floor and walls; below any object's, as the engine takes the larger of the two.
        wall_thickness, floor_thickness: of the slabs round and under the room [m].

    Raises:
        InputError: a field out of range, or a `solref` whose time constant is less than two timesteps, which the engine
            would change without a word, or a `settle_time` of less than one.
    """

    timestep: AboveZero = 0.004
    solref: tuple[AboveZero, AboveZero] = (0.008, 1.0)
    impratio: AboveZero = 10.0
    gravity: tuple[Number, Number, Number] = (0.0, 0.0, -9.81)
    settle_time: AboveZero = 5.0
    rest_time: NotNegative = 2.0
    hold_time: NotNegative = 5.0
    chunk: Annotated[int, Meta(ge=1, le=1_000_000)] = 10
    lost: AboveZero = 0.1
    toppled: AboveZero = 45.0
    ground_friction: NotNegative = 0.2
    wall_thickness: AboveZero = 0.1
    floor_thickness: AboveZero = 0.5

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.solref[0] < 2.0 * self.timestep:
            raise self.refused("solref[0]", f"is {self.solref[0]:g} s; two timesteps are {2 * self.timestep:g} s")
        if self.settle_time < self.timestep:
            raise self.refused("settle_time", f"is {self.settle_time:g} s; one timestep is {self.timestep:g} s")


class Walking(CheckedValue, kw_only=True, frozen=True):
    """What a walkable way and a clear opening are.

    Attributes:
        width: of the walker [m].
        robot: of the robot that must be able to drive wherever the walker can walk [m].
        headroom: what hangs higher than this is walked under [m].
        step: what is flatter than this is walked over [m].
        reach: arm's length, from the walker's middle to an object [m].
        large: footprint from which a standing object must be reachable [m2].
        movable: what weighs less is moved aside (a chair) and bars no way [kg].
        door_zone: depth of the clear zone inside a door, in door widths; of one that opens outwards, in steps.
        window_zone: depth of the zone before a window [m].
        window_share: share of a window's width that may be covered.
        window_width: floor-standing pieces narrower than this leave enough of a window free [m].
        window_excess: how far above the sill a piece before a window may reach [m].
    """

    width: AboveZero = 0.5
    robot: AboveZero = 0.2
    headroom: AboveZero = 1.9
    step: NotNegative = 0.03
    reach: NotNegative = 0.6
    large: NotNegative = 0.3
    movable: NotNegative = 15.0
    door_zone: NotNegative = 1.0
    window_zone: NotNegative = 0.3
    window_share: Share = 0.2
    window_width: NotNegative = 0.45
    window_excess: NotNegative = 0.3
