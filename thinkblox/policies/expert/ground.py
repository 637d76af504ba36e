"""What the floor says against a place: no room to use the thing, in the room that others need, or in the way."""

import numpy as np

from thinkblox.knowledge.uses import uses
from thinkblox.policies.expert.situation import Situation
from thinkblox.policies.expert.ways import in_the_way
from thinkblox.scene.rectangles import Array, Rects, outside, overlap_depth, separation
from thinkblox.scene.zones import beside, fewest

TOUCH = 0.001
"""Overlap that is only contact [m]."""
WIDE = 0.45
"""What is narrower than this does not darken a window [m]."""
NARROW_SHARE, LOW_SHARE = 0.01, 0.016
"""How much it counts what is narrow, or little higher than the sill, against what hides a window."""
BARELY = 0.2
"""How far above the sill a head of a bed may reach before a window, where no wall is free [m]."""
SEEN_OVER, IN_VIEW = 0.6, 4.0
"""Height over which one looks from a sofa [m], and cost per metre of what is higher between it and a screen."""
HIGH, AT_WALL, BARE_BACK = 1.2, 0.06, 2.5
"""Storage that is higher than this shows its back [m], unless a wall is as near as this [m]; and the cost of that."""
_BACKED = ("in_rows", "back_to_back", "between", "behind")
"""Relations of storage that does not stand against a wall."""
MOVABLE = 15.0
"""What is lighter than this is moved aside when the floor is needed [kg]."""


def ground_costs(situation: Situation, rects: Rects) -> Array:
    """What the floor says against each box: no room to use it, in the room others need, or in the way."""
    costs = used_costs(situation, rects)
    movable = situation.asset.mass < MOVABLE and not situation.facts.is_in("plants", "in_corners")
    weight = 2.0 if movable else 5.0
    costs += weight * overlap_depth(rects, situation.clearances).sum(-1)
    costs += 4.0 * overlap_depth(rects, situation.reserved).sum(-1)
    costs += 4.0 * overlap_depth(rects, situation.promised).sum(-1)
    costs += in_the_way(situation, rects) + _back_in_room(situation, rects)
    if situation.size[2] > SEEN_OVER:
        costs += IN_VIEW * overlap_depth(rects, situation.views).max(-1, initial=0.0)
    if len(situation.door_zones) and max(situation.size[:2]) > 0.5:
        near = separation(rects, situation.door_zones)
        costs += 0.8 * np.maximum(0.0, 0.35 - near).max(-1)
    return costs


def used_costs(situation: Situation, rects: Rects) -> Array:
    """How much of the floor is missing that the object needs to be used."""
    asset, costs = situation.asset, np.zeros(len(rects))
    for use in uses(situation.target.category, situation.size, asset.front, asset.clearance):
        zones = [beside(rects, side, use.depth) for side in use.sides]
        missing = [zone_costs(situation, zone, weight=5.0) + _promised(situation, zone) for zone in zones]
        costs += fewest(missing, use.number)
    return costs


def _promised(situation: Situation, zone: Rects) -> Array:
    """What will be missing of a zone when those come who are promised floor there."""
    return np.asarray(2.0 * overlap_depth(zone, situation.promised).max(-1, initial=0.0))


def _back_in_room(situation: Situation, rects: Rects) -> Array:
    """What it costs that the bare back of high storage is seen; rows and what parts the room have none to hide."""
    stands = any(tie.kind in _BACKED for tie in situation.target.ties) or situation.asset.front != "one"
    if stands or situation.size[2] < HIGH or not situation.facts.is_in("storage"):
        return np.zeros(len(rects))
    against = outside(beside(rects, "back", AT_WALL), situation.room.polygon) > 0.0
    return np.where(against, 0.0, BARE_BACK)


def zone_costs(situation: Situation, zone: Rects, *, weight: float) -> Array:
    """How much of a zone is occupied or outside the room, times `weight` per metre of its depth."""
    reach = 2 * np.minimum(zone.half[:, 0], zone.half[:, 1])
    blocked = overlap_depth(zone, situation.solids).max(-1, initial=0.0)
    blocked = np.maximum(blocked, overlap_depth(zone, situation.door_zones).max(-1, initial=0.0))
    return np.asarray(weight * (blocked + outside(zone, situation.room.polygon) * reach))


def darkens(situation: Situation, rects: Rects) -> Array:
    """How much it speaks against each box that it is before a window: 1 cannot be.

    It is little for what is narrow, or no more than a hand's breadth higher than the sill.
    """
    hangs = situation.asset.mount == "wall"
    covered = overlap_depth(rects, situation.window_zones) > (TOUCH if hangs else 0.02)
    low = situation.window_zones.bottom[None] + (0.0 if hangs else BARELY) >= rects.top[:, None]
    narrow = 2.0 * rects.half.max(-1, keepdims=True) <= (0.0 if hangs else WIDE)
    shares = np.where(narrow, NARROW_SHARE, np.where(low, LOW_SHARE, 1.0))
    return np.asarray(np.where(covered, shares, 0.0).max(-1, initial=0.0))
