"""Named settings of the physics and of the verdicts, each with its unit."""

import math
from collections.abc import Iterable

from msgspec.structs import asdict

from thinkblox.errors import InputError
from thinkblox.value import Value, Vec2, Vec3

MOST_STEPS = 1_000_000
"""Of `Physics.chunk`."""


class Tolerances(Value, kw_only=True, frozen=True):
    """Where a verdict draws its lines; raises InputError for one that is less than 0 or no number.

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

    penetration: float = 0.001
    outside: float = 0.001
    touching: float = 0.010
    clearance: float = 0.003
    drift: float = 0.005
    drop: float = 0.010
    tilt: float = 2.0
    pushed: float = 0.005
    opens: float = 0.6
    carried: float = 0.5
    hold_drift: float = 0.010
    hold_tilt: float = 2.0
    size: float = 0.010

    def __post_init__(self) -> None:
        _refuse_less_than_zero(self, asdict(self))


class Physics(Value, kw_only=True, frozen=True):
    """How the engine is run; the exported model carries the same options.

    Raises InputError, which names the field, for what the engine cannot be run with: a time or length that is not
    positive and finite, a settle shorter than a step, a chunk of no steps.

    Attributes:
        timestep: [s].
        solref: time constant [s] and damping ratio of contacts; at least two timesteps.
        impratio: ratio of frictional to normal constraint impedance, against creep.
        gravity: [m/s2].
        settle_time: how long a candidate may take to come to rest, and everything that it set in motion [s].
        least_settle_time: shortest settle of a candidate before stillness is believed [s], unless it stands squarely.
        rest_time: longest settle of a whole scene before its keyframe is taken [s].
        hold_time: how long a settled scene must stand still [s].
        chunk: steps between two looks at what settles.
        lost, toppled: motion [m] and rotation [degrees] past which a settle is given up.
        ground_friction: of floor and walls; below any object's, as the engine takes the larger of the two.
        wall_thickness, floor_thickness: of the slabs round and under the room [m].
    """

    timestep: float = 0.004
    solref: Vec2 = (0.008, 1.0)
    impratio: float = 10.0
    gravity: Vec3 = (0.0, 0.0, -9.81)
    settle_time: float = 5.0
    least_settle_time: float = 0.5
    rest_time: float = 2.0
    hold_time: float = 5.0
    chunk: int = 10
    lost: float = 0.1
    toppled: float = 15.0
    ground_friction: float = 0.2
    wall_thickness: float = 0.1
    floor_thickness: float = 0.5

    def __post_init__(self) -> None:
        positive = ("timestep", "impratio", "settle_time", "lost", "toppled", "wall_thickness", "floor_thickness")
        _refuse_not_positive(self, positive)
        _refuse_less_than_zero(self, ("least_settle_time", "rest_time", "hold_time", "ground_friction"))
        for name, numbers in (("solref", self.solref), ("gravity", self.gravity)):
            if not all(map(math.isfinite, numbers)):
                raise InputError(f"Physics.{name} is {numbers}; every number must be finite")
        if not 1 <= self.chunk <= MOST_STEPS:
            raise InputError(f"Physics.chunk is {self.chunk}; it must be 1 to {MOST_STEPS} steps")
        if self.settle_time < self.timestep:
            raise InputError(
                f"Physics.settle_time is {self.settle_time:g} s; it must be at least one timestep, {self.timestep:g} s"
            )


class Walking(Value, kw_only=True, frozen=True):
    """What a walkable way and a clear opening are; raises InputError for a measure that is less than 0 or no number.

    Attributes:
        width: of the walker [m].
        robot: of the robot that must be able to drive wherever the walker can walk [m].
        headroom: what hangs higher than this is walked under [m].
        step: what is flatter than this is walked over [m].
        reach: arm's length, from the walker's middle to an object [m].
        large: footprint from which a standing object must be reachable [m2].
        movable: what weighs less is moved aside (a chair) and bars no way [kg].
        door_zone: depth of the clear zone inside a door, in door widths.
        window_zone: depth of the zone before a window [m].
        window_share: share of a window's width that may be covered.
        window_width: floor-standing pieces narrower than this leave enough of a window free [m].
        window_excess: how far above the sill a piece before a window may reach [m].
    """

    width: float = 0.5
    robot: float = 0.2
    headroom: float = 1.9
    step: float = 0.03
    reach: float = 0.6
    large: float = 0.3
    movable: float = 15.0
    door_zone: float = 1.0
    window_zone: float = 0.3
    window_share: float = 0.2
    window_width: float = 0.45
    window_excess: float = 0.3

    def __post_init__(self) -> None:
        _refuse_not_positive(self, ("width", "robot"))
        _refuse_less_than_zero(self, asdict(self))


def _refuse_not_positive(settings: Value, names: Iterable[str]) -> None:
    for name in names:
        value = getattr(settings, name)
        if not 0.0 < value < math.inf:
            raise InputError(f"{type(settings).__name__}.{name} is {value}; it must be more than 0, and finite")


def _refuse_less_than_zero(settings: Value, names: Iterable[str]) -> None:
    for name in names:
        value = getattr(settings, name)
        if not value >= 0.0:
            raise InputError(f"{type(settings).__name__}.{name} is {value}; it must be 0 or more")
