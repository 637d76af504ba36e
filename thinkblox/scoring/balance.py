"""Balance: whether what stands in a room weighs in its middle."""

import math

from thinkblox.scoring.rating import Rating
from thinkblox.scoring.standing import Standing

FAR_OFF = 0.5
"""Share of half the room's diagonal by which the middle of all that stands is off, where the score is 0."""


def balance(standing: Standing) -> Rating:
    """How near the middle of the furniture, by floor area, is to the middle of the floor.

    Merrell et al. 2011, visual balance: the distance between the centroids of the furniture and of the room; 1 where
    they are one, falling linearly to 0 at FAR_OFF of half the room's diagonal. One thing alone balances nothing.
    """
    large = standing.large
    areas = [thing.placement.size[0] * thing.placement.size[1] for thing in large]
    if len(large) < 2:
        return Rating(None, {"things": float(len(large))})
    middle = standing.room.polygon.centroid
    x, y = (
        sum(area * thing.placement.position[axis] for area, thing in zip(areas, large, strict=True)) / sum(areas)
        for axis in (0, 1)
    )
    off = math.hypot(x - middle.x, y - middle.y)
    share = off / (math.hypot(*standing.room.extent) / 2)
    worst = f"the furniture weighs {off:.2f} m beside the middle of the room" if share > 0.1 * FAR_OFF else ""
    return Rating(1.0 - share / FAR_OFF, {"things": len(large), "offset": off, "share": share}, worst)
