"""What the floor says against a place: no room to use the thing, in the room that others need, or in the way."""

import numpy as np

from thinkblox.assets import facts_of
from thinkblox.knowledge.uses import SIDE_WAY, uses
from thinkblox.knowledge.zones import zone_of
from thinkblox.policies.expert.situation import Situation
from thinkblox.policies.expert.ways import across_gates, in_the_way
from thinkblox.scene.rectangles import Array, Rects, outside, overlap_depth, separation
from thinkblox.scene.zones import beside, fewest, joined

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
SEATED_ROUND = 0.5
"""How far those who sit around a table reach beyond it [m]."""
HIGH, AT_WALL, BARE_BACK = 1.2, 0.06, 2.5
"""Storage that is higher than this shows its back [m], unless a wall is as near as this [m]; and the cost of that."""
MOVED_ASIDE, KEPT_CLEAR = 4.0, 8.0
"""Cost per metre of what stands in the floor that others need: light things, and any other."""
STAFF, BEHIND_COUNTER, ASIDE = 4.0, 2.0, 1.2
"""Cost of a guest's seat behind a counter, how deep that floor is, and how far past the ends of the counter [m]."""
AT_BACKS, TALKS = 4.0, 3.5
"""Cost of a lounge seat that looks at the back of another, and how far one looks [m]."""
SEVERAL_ZONES, WITHIN_ZONE, ZONE_APART = 2, 1.0, 1.2
"""From how many parts of a room on things keep to theirs, up to how far that is no matter [m], and cost per metre."""
SAME_WAY = 0.7
"""Cosine of the angle up to which two look the same way."""
_BACKED = ("in_rows", "back_to_back", "between", "behind")
"""Relations of storage that does not stand against a wall."""
MOVABLE = 15.0
"""What is lighter than this is moved aside when the floor is needed [kg]."""


NO_ROOM_LEFT, SPARE = 1.5, 0.05
"""Cost of standing so far in the floor that is promised to another that it has no room any more [m]."""


def ground_costs(situation: Situation, rects: Rects) -> Array:
    """What the floor says against each box: no room to use it, in the room others need, or in the way."""
    costs = used_costs(situation, rects)
    movable = situation.asset.mass < MOVABLE and not situation.facts.is_in("plants", "in_corners")
    weight = MOVED_ASIDE if movable else KEPT_CLEAR
    costs += weight * overlap_depth(rects, situation.clearances).sum(-1)
    costs += 4.0 * overlap_depth(rects, situation.reserved).sum(-1)
    promised = overlap_depth(rects, situation.promised)
    costs += (4.0 * promised + NO_ROOM_LEFT * (promised > SPARE)).sum(-1)
    costs += in_the_way(situation, rects) + across_gates(situation, rects) + _back_in_room(situation, rects)
    costs += _among_staff(situation, rects) + _at_their_backs(situation, rects) + _out_of_zone(situation, rects)
    if situation.size[2] > SEEN_OVER:
        seated = SEATED_ROUND if situation.facts.is_in("sat_around") else 0.0
        whole = Rects(rects.centre, rects.half + seated, rects.yaw, rects.bottom, rects.top)
        costs += IN_VIEW * overlap_depth(whole, situation.views).max(-1, initial=0.0)
    if len(situation.door_zones) and max(situation.size[:2]) > 0.5:
        near = separation(rects, situation.door_zones)
        costs += 0.8 * np.maximum(0.0, 0.35 - near).max(-1)
    return costs


def used_costs(situation: Situation, rects: Rects) -> Array:
    """How much of the floor is missing that the object needs to be used; what is shallow is as needful as a way."""
    asset, costs = situation.asset, np.zeros(len(rects))
    for use in uses(situation.target.category, situation.size, asset.front, asset.clearance):
        if use.sides == ("back",) and situation.is_mere_worktop:
            continue
        zones = [beside(rects, side, use.depth) for side in use.sides]
        weight = 5.0 * max(1.0, SIDE_WAY / use.depth)
        missing = [zone_costs(situation, zone, weight=weight) + _promised(situation, zone) for zone in zones]
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


def _among_staff(situation: Situation, rects: Rects) -> Array:
    """What it costs that guests would sit, or have their low table, where those are who serve."""
    own, guests = situation.relatives, ("seating", "low_tables")
    others = [p for p in situation.solid if p.id not in own]
    if situation.facts.is_in("served_over"):
        zone = beside(rects, "back", BEHIND_COUNTER, width=situation.size[1] + 2 * ASIDE)
        seats = [p for p in others if facts_of(p.category).is_in(*guests)]
        return np.asarray(STAFF * (overlap_depth(zone, Rects.of_placements(tuple(seats))) > TOUCH).any(-1))
    if not situation.facts.is_in(*guests):
        return np.zeros(len(rects))
    counters = [p for p in others if facts_of(p.category).is_in("served_over")]
    zones = [beside(Rects.of_placements((p,)), "back", BEHIND_COUNTER, width=p.size[1] + 2 * ASIDE) for p in counters]
    return np.asarray(STAFF * (overlap_depth(rects, joined(zones)) > TOUCH).any(-1))


def _at_their_backs(situation: Situation, rects: Rects) -> Array:
    """What it costs that one lounge seat looks at the back of another from near by, where they form no rows."""
    costs = np.zeros(len(rects))
    if not situation.facts.is_in("lounges") or any(tie.kind == "in_rows" for tie in situation.target.ties):
        return costs
    front = rects.axes[:, 0]
    for p in situation.solid:
        if not facts_of(p.category).is_in("lounges"):
            continue
        angle = np.radians(p.yaw)
        ahead, left = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
        to = np.array(p.position[:2]) - rects.centre
        same = front @ ahead > SAME_WAY
        out, aside = to @ ahead, np.abs(to @ left)
        costs += AT_BACKS * (same & (np.abs(out) > p.size[0]) & (np.abs(out) < TALKS) & (aside < p.size[1] / 2))
    return costs


def _out_of_zone(situation: Situation, rects: Rects) -> Array:
    """What it costs to stand far from the rest of its part of a room that has several: a wardrobe far from the bed."""
    zone = zone_of(situation.target.category)
    kinds = {zone_of(t.category) for t in situation.observation.plan.targets} - {""}
    rest = tuple(p for p in situation.large if zone_of(p.category) == zone)
    if not zone or not rest or len(kinds) < SEVERAL_ZONES:
        return np.zeros(len(rects))
    apart = separation(rects, Rects.of_placements(rest)).min(-1)
    return np.asarray(ZONE_APART * np.clip(apart - WITHIN_ZONE, 0.0, None))


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
