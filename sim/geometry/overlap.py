"""How much of one object is inside another."""

from collections.abc import Collection

from manifold3d import Manifold, OpType

from thinkblox.scene.placement import Placement
from thinkblox.sim.geometry.solid import Solid, pose


def overlap_volume(
    solid: Solid,
    placement: Placement,
    other: Solid,
    other_placement: Placement,
    *,
    pieces: tuple[Collection[int], Collection[int]] | None = None,
) -> float:
    """Volume shared by the colliding shapes of two placed assets [m3].

    `pieces` are the indices of those of each that can share any; without, all of them are looked at.
    """
    chosen = pieces or (range(len(solid.pieces)), range(len(other.pieces)))
    mine, theirs = _union(solid, chosen[0]), _union(other, chosen[1])
    shared = mine.transform(pose(placement)) ^ theirs.transform(pose(other_placement))
    return max(0.0, float(shared.volume()))


def overlap_ratio(solid: Solid, placement: Placement, other: Solid, other_placement: Placement) -> float:
    """Share of the first object's volume that is inside the second, 0 to 1: the normalised overlap rho."""
    return min(1.0, overlap_volume(solid, placement, other, other_placement) / solid.volume)


def _union(solid: Solid, pieces: Collection[int]) -> Manifold:
    if len(pieces) == len(solid.pieces):
        return solid.manifold
    chosen = [solid.pieces[piece] for piece in sorted(pieces)]
    return chosen[0] if len(chosen) == 1 else Manifold.batch_boolean(chosen, OpType.Add)
