"""From what was measured to a Verdict: every tolerance that was exceeded becomes a reason."""

from collections.abc import Sequence
from typing import get_args

from msgspec import structs

from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.sim.geometry.boundary import boundary_distance
from thinkblox.sim.geometry.mounting import faces_its_wall, hangs
from thinkblox.sim.geometry.openings import blocked_openings
from thinkblox.sim.geometry.solid import solid_of
from thinkblox.sim.settings import Tolerances, Walking
from thinkblox.value import Value
from thinkblox.verdict import Collision, Pose, Push, Reason, Support, Swing, Unmet, Verdict

ORDER: tuple[Reason, ...] = get_args(Reason)
GATE = frozenset({"collision", "outside", "size"})
"""After any of these a settle would measure an explosion, so none is run."""


class Motion(Value, kw_only=True, frozen=True):
    """What an object did while settling [m, degrees].

    Attributes:
        rest: when it came to rest [s]; None when it did not.
        restless: something still moved when the time was over.
        pose: where it came to rest.
        pushed: what else it moved, furthest first.
        unstable: the engine gave up, and the numbers mean nothing.
    """

    drift: float = 0.0
    drop: float = 0.0
    tilt: float = 0.0
    rest: float | None = None
    restless: bool = False
    pose: Pose | None = None
    pushed: tuple[Push, ...] = ()
    unstable: bool = False


class Static(Value, kw_only=True, frozen=True):
    """What can be said of a pose before any simulation."""

    reasons: frozenset[Reason]
    collisions: tuple[Collision, ...]
    boundary: float
    blocked: tuple[str, ...]
    swings: tuple[Swing, ...] = ()

    @property
    def gated(self) -> bool:
        """Whether the pose is so wrong that it is not worth settling."""
        return bool(self.reasons & GATE)


def judge_pose(
    room: Room,
    placement: Placement,
    asset: Asset,
    tolerances: Tolerances,
    walking: Walking,
    *,
    collisions: tuple[Collision, ...] = (),
    swings: tuple[Swing, ...] = (),
) -> Static:
    """Boundary, openings and size of one placement, beside the collisions and swings that were measured of it."""
    solid = solid_of(asset)
    boundary = round(boundary_distance(room, placement, solid), 6)
    doors, windows = blocked_openings(room, placement, asset, solid, walking)
    found: dict[Reason, bool] = {
        "collision": bool(collisions),
        "outside": boundary > tolerances.outside,
        "unsupported": not asset.free and not hangs(room, placement, solid, tolerances.touching),
        "faces_wall": faces_its_wall(room, placement, asset),
        "blocks_door": bool(doors),
        "blocks_window": bool(windows),
        "blocks_opening": any(swing.opens < tolerances.opens for swing in swings),
        "size": any(abs(a - b) > tolerances.size for a, b in zip(placement.size, asset.size, strict=True)),
    }
    reasons = frozenset(reason for reason, holds in found.items() if holds)
    return Static(reasons=reasons, collisions=collisions, boundary=boundary, blocked=doors + windows, swings=swings)


def with_pressed(static: Static, pressed: tuple[Collision, ...]) -> Static:
    """The same with what is found too deep once everything rests."""
    if not pressed:
        return static
    collisions = tuple(sorted((*static.collisions, *pressed), key=lambda c: (-c.depth, c.other)))
    return structs.replace(static, collisions=collisions, reasons=static.reasons | {"collision"})


def judge_motion(motion: Motion, tolerances: Tolerances) -> frozenset[Reason]:
    """The reasons that a settle gives."""
    found: dict[Reason, bool] = {
        "drift": motion.drift > tolerances.drift,
        "drop": motion.drop > tolerances.drop + tolerances.clearance,
        "tilt": motion.tilt > tolerances.tilt,
        "restless": motion.restless,
        "pushes": disturbs(motion.pushed, tolerances),
        "unstable": motion.unstable,
    }
    return frozenset(reason for reason, holds in found.items() if holds)


def disturbs(pushed: Sequence[Push], tolerances: Tolerances) -> bool:
    """Whether anything was moved or tilted further than tolerated."""
    return any(push.distance > tolerances.pushed or push.tilt > tolerances.tilt for push in pushed)


def verdict(
    placement: Placement,
    static: Static,
    *,
    motion: Motion | None = None,
    supports: tuple[Support, ...] = (),
    more: frozenset[Reason] = frozenset(),
    cut_off: tuple[str, ...] = (),
    unmet: tuple[Unmet, ...] = (),
) -> Verdict:
    """Put together what was measured.

    `more` are the reasons that settling gave, `cut_off` the ids that have no walkable way because of this object, and
    `unmet` the requirements of the user's that it does not meet.
    """
    found = static.reasons | more | ({"blocks_way"} if cut_off else set()) | ({"requirement"} if unmet else set())
    reasons = tuple(reason for reason in ORDER if reason in found)
    moved = motion or Motion()
    return Verdict(
        id=placement.id,
        valid=not reasons,
        reasons=reasons,
        depth=max((c.depth for c in static.collisions), default=0.0),
        overlap=round(sum(c.overlap for c in static.collisions), 6),
        boundary=static.boundary,
        collisions=static.collisions,
        supports=supports,
        settled=motion is not None,
        drift=moved.drift,
        drop=moved.drop,
        tilt=moved.tilt,
        rest=moved.rest,
        settled_pose=moved.pose,
        pushed=moved.pushed,
        swings=static.swings,
        blocked=static.blocked + cut_off,
        unmet=unmet,
    )


def with_riders(verdict: Verdict, riders: Sequence[Verdict]) -> Verdict:
    """The verdict on an object together with those on what an action carried along with it, or left behind."""
    found = set(verdict.reasons) | ({"riders"} if any(not rider.valid for rider in riders) else set())
    reasons = tuple(reason for reason in ORDER if reason in found)
    return structs.replace(verdict, valid=not reasons, reasons=reasons, riders=tuple(riders))


def fixed_supports(placement: Placement, asset: Asset, static: Static) -> tuple[Support, ...]:
    """What holds up something that cannot move: what it hangs on, or for a rug the floor it lies on."""
    if "unsupported" in static.reasons:
        return ()
    by = placement.support if asset.mount in ("wall", "ceiling") else "floor"
    return (Support(by=by, share=1.0),)
