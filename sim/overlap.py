"""How much of one object is inside another."""

from thinkblox.scene import Placement
from thinkblox.sim.solid import Solid, pose


def overlap_volume(solid: Solid, placement: Placement, other: Solid, other_placement: Placement) -> float:
    """Volume shared by the colliding shapes of two placed assets [m3]."""
    mine = solid.manifold.transform(pose(placement))
    theirs = other.manifold.transform(pose(other_placement))
    return max(0.0, float((mine ^ theirs).volume()))


def overlap_ratio(solid: Solid, placement: Placement, other: Solid, other_placement: Placement) -> float:
    """Share of the first object's volume that is inside the second, 0 to 1."""
    return min(1.0, overlap_volume(solid, placement, other, other_placement) / solid.volume)
