"""From what was measured to a Verdict: every tolerance that was exceeded becomes a reason."""

from collections.abc import Mapping
from typing import get_args

from thinkblox.asset import Asset
from thinkblox.scene import Placement, Scene
from thinkblox.sim.boundary import distance_outside
from thinkblox.sim.mounting import hangs
from thinkblox.sim.openings import blocked_openings
from thinkblox.sim.overlap import overlap_ratio
from thinkblox.sim.settings import Tolerances, Walking
from thinkblox.sim.solid import solid_of
from thinkblox.value import Value
from thinkblox.verdict import Collision, Reason, Support, Verdict

ORDER: tuple[Reason, ...] = get_args(Reason)
GATE = frozenset({"collision", "outside", "size"})
"""After any of these a settle would measure an explosion, so none is run."""


class Motion(Value, kw_only=True, frozen=True):
    """What an object did while settling [m, degrees]; `unstable` when the engine gave up."""

    drift: float = 0.0
    drop: float = 0.0
    tilt: float = 0.0
    unstable: bool = False


class Static(Value, kw_only=True, frozen=True):
    """What can be said of a pose before any simulation."""

    reasons: frozenset[Reason]
    collisions: tuple[Collision, ...]
    outside: float
    blocked: tuple[str, ...]

    @property
    def gated(self) -> bool:
        """Whether the pose is so wrong that it is not worth settling."""
        return bool(self.reasons & GATE)


def judge_pose(
    scene: Scene,
    placement: Placement,
    asset: Asset,
    depths: Mapping[str, float],
    tolerances: Tolerances,
    walking: Walking,
) -> Static:
    """Collision, boundary, openings and size of one placement against the others of a scene.

    `depths` are the deepest contacts with each other object [m].
    """
    solid = solid_of(asset)
    collisions = _collisions(scene, placement, asset, depths, tolerances)
    outside = round(distance_outside(scene.room, placement, solid), 6)
    doors, windows = blocked_openings(scene.room, placement, asset, solid, walking)
    found: dict[Reason, bool] = {
        "collision": bool(collisions),
        "outside": outside > tolerances.outside,
        "unsupported": not asset.free and not hangs(scene.room, placement, solid, tolerances.touching),
        "blocks_door": bool(doors),
        "blocks_window": bool(windows),
        "size": any(abs(a - b) > tolerances.size for a, b in zip(placement.size, asset.size, strict=True)),
    }
    reasons = frozenset(reason for reason, holds in found.items() if holds)
    return Static(reasons=reasons, collisions=collisions, outside=outside, blocked=doors + windows)


def _collisions(
    scene: Scene, placement: Placement, asset: Asset, depths: Mapping[str, float], tolerances: Tolerances
) -> tuple[Collision, ...]:
    found = []
    for other, depth in depths.items():
        if depth > tolerances.penetration and other in scene:
            theirs = scene[other]
            ratio = overlap_ratio(solid_of(asset), placement, solid_of(scene.asset_of(theirs)), theirs)
            found.append(Collision(other=other, depth=round(depth, 6), overlap=round(ratio, 6)))
    return tuple(sorted(found, key=lambda c: (-c.depth, c.other)))


def judge_motion(motion: Motion, tolerances: Tolerances) -> frozenset[Reason]:
    """The reasons that a settle gives."""
    found: dict[Reason, bool] = {
        "drift": motion.drift > tolerances.drift,
        "drop": motion.drop > tolerances.drop + tolerances.clearance,
        "tilt": motion.tilt > tolerances.tilt,
        "unstable": motion.unstable,
    }
    return frozenset(reason for reason, holds in found.items() if holds)


def verdict(
    placement: Placement,
    static: Static,
    *,
    motion: Motion | None = None,
    supports: tuple[Support, ...] = (),
    more: frozenset[Reason] = frozenset(),
    cut_off: tuple[str, ...] = (),
) -> Verdict:
    """Put together what was measured.

    `more` are the reasons that settling gave, `cut_off` the ids that have no walkable way because of this object.
    """
    found = static.reasons | more | ({"blocks_way"} if cut_off else set())
    reasons = tuple(reason for reason in ORDER if reason in found)
    moved = motion or Motion()
    return Verdict(
        id=placement.id,
        valid=not reasons,
        reasons=reasons,
        depth=max((c.depth for c in static.collisions), default=0.0),
        overlap=round(sum(c.overlap for c in static.collisions), 6),
        boundary=static.outside,
        collisions=static.collisions,
        supports=supports,
        settled=motion is not None,
        drift=moved.drift,
        drop=moved.drop,
        tilt=moved.tilt,
        blocked=static.blocked + cut_off,
    )


def fixed_supports(placement: Placement, asset: Asset, static: Static) -> tuple[Support, ...]:
    """What holds up something that cannot move: what it hangs on, or for a rug the floor it lies on."""
    if "unsupported" in static.reasons:
        return ()
    by = placement.support if asset.mount in ("wall", "ceiling") else "floor"
    return (Support(by=by, share=1.0),)
