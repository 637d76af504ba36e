"""Room for what comes later and refers to the object in question."""

from collections.abc import Sequence

import numpy as np

from thinkblox.assets import facts_of
from thinkblox.assets.mounting import WALL_MOUNTED
from thinkblox.plan import Target, Tie
from thinkblox.policies.expert.ground import TOUCH, zone_costs
from thinkblox.policies.expert.needs import BEFORE_BOARD, need, seat_need
from thinkblox.policies.expert.partners import pair_need
from thinkblox.policies.expert.situation import Situation
from thinkblox.policies.expert.walls import VIEW_RANGE
from thinkblox.scene.pairs import ACROSS
from thinkblox.scene.rectangles import Array, Rects, overlap_depth
from thinkblox.scene.support import ON_FLOOR
from thinkblox.scene.zones import beside, fewest, joined
from thinkblox.value import Vec3

ABREAST = 0.15
"""Left between things that stand side by side [m]."""
END_OF_RUN = 0.75
"""Length of a fridge or the like at the end of a run [m]."""
FAR_VIEW = 1.2
"""Cost per metre by which one sits farther from what is to be looked at across the room than is good."""
TOO_DEEP = 2.0
"""Cost of looking across the room at a wall from which what stands there is too far away."""
DARKENS = 0.85
"""What is higher than this does not stand before a window [m]."""
HIDES, HIDDEN, NOT_WRITTEN_ON = 0.5, 2.0, 30.0
"""How far before a hung thing nothing of its height stands [m], and the cost of what does; before a board, of that."""
OVER_HEADS, LEANS_OUT, UNDER_LEAVES = 30.0, 0.15, 0.4
"""Cost of a shelf over a bed or a seat, how far before it one is not to be either, and free height over a plant [m]."""
AT_WALL, OFF_WALL = 0.15, 8.0
"""So near a wall stands what something is to hang above on it [m], and the cost of standing farther off."""
BY_FRAME, NO_PLACE_BY = 0.05, 8.0
"""Left between a door or window and what stands next to it [m], and the cost of taking its last place there."""
AGAINST_LIGHT = 1.2
"""Cost of a screen before a window, against whose light one looks."""
FACES_LIGHT = 0.8
"""Cost of a seat from which a screen will be seen against a window across the room, where there is floor to choose."""
_HEADS = ("lain_on", "treated_on", "seating", "clear_above")
"""Groups of things under which no shelf hangs."""
_AT_SIDE = ("left_of", "right_of")
BESIDE_WALL = 0.15
"""Air behind a seat that stands aside of a sofa by the wall [m]."""
LEG_ROOM, AT_END = 0.4, 5.0
"""Floor between a low table and those who lean back at it [m], and cost per metre that is missing for a seat there."""
IN_USE = 4.0
"""Cost per metre by which a follower would stand in the floor that others need."""


def follower_costs(situation: Situation, rects: Rects) -> Array:
    """Room for what comes later and refers to this: nightstands beside a bed, chairs about a table, a view."""
    costs = _room_for_run(situation, rects) + _room_beside(situation, rects) + _against_light(situation, rects)
    costs += _room_about_table(situation, rects) + _room_for_chain(situation, rects)
    costs += _room_by_openings(situation, rects)
    done: set[tuple[str, str]] = set()
    for follower in situation.followers:
        for tie in follower.ties:
            key = (follower.request, tie.kind)
            if key not in done and (situation.target.id in tie.anchors or tie.kind in ("facing", "opposite")):
                done.add(key)
                costs += _room_for(situation, rects, follower, tie)
                if tie.kind == "opposite" and situation.target.id in tie.anchors:
                    costs += _too_deep(situation, rects, situation.kind(follower).size[0])
                    costs += _faces_light(situation, rects, follower)
    return costs


def _against_light(situation: Situation, rects: Rects) -> Array:
    """What it costs that a screen that comes onto it would be before a window."""
    own = situation.target.id
    on_it = [t for t in situation.followers for tie in t.ties if tie.kind == "on" and own in tie.anchors]
    screens = [situation.kind(t).size[2] for t in on_it if facts_of(t.category).is_in("screens")]
    if not screens or situation.facts.is_in("worked_at"):
        return np.zeros(len(rects))
    tall = Rects(rects.centre, rects.half, rects.yaw, rects.bottom, rects.top + max(screens))
    return np.where((overlap_depth(tall, situation.window_zones) > 0.0).any(-1), AGAINST_LIGHT, 0.0)


def _faces_light(situation: Situation, rects: Rects, follower: Target) -> Array:
    """What it costs that a window is across the room where a screen is to stand or hang."""
    later = situation.observation.plan.targets
    on_it = [t.category for t in later for tie in t.ties if tie.kind == "on" and follower.id in tie.anchors]
    if not any(facts_of(category).is_in("screens") for category in (follower.category, *on_it)):
        return np.zeros(len(rects))
    room, half = situation.room, situation.kind(follower).size[1] / 2
    front = np.stack([np.cos(rects.yaw), np.sin(rects.yaw)], axis=-1)
    lit = np.zeros(len(rects), dtype=bool)
    for window in (opening for opening in room.openings if opening.kind == "window"):
        wall = room.walls[window.wall]
        along = (rects.centre - np.array(wall.start)) @ np.array(wall.along)
        middle = window.offset + window.width / 2
        lit |= (front @ np.array(wall.inward) < -0.9) & (np.abs(along - middle) < half + window.width / 2)
    return np.where(lit, FACES_LIGHT * max(0.0, 2.0 * situation.spare - 1.0), 0.0)


def _too_deep(situation: Situation, rects: Rects, depth: float) -> Array:
    """The wall across the room is too far away for what is to stand there in sight."""
    front = np.stack([np.cos(rects.yaw), np.sin(rects.yaw)], axis=-1)
    ahead = np.full(len(rects), np.inf)
    for wall in situation.room.walls:
        inward = np.array(wall.inward)
        away = (rects.centre - np.array(wall.start)) @ inward - rects.half[:, 0]
        ahead = np.where((front @ inward < -0.9) & (away > 0.0), np.minimum(ahead, away), ahead)
    free = np.where(np.isfinite(ahead), ahead - depth, 0.0)
    beyond = free - ACROSS[1]
    costs = np.where(beyond > 0.0, TOO_DEEP + beyond, 0.0)
    return costs + FAR_VIEW * np.maximum(0.0, free - VIEW_RANGE[1]) * situation.facts.is_in("seating")


def _room_beside(situation: Situation, rects: Rects) -> Array:
    """Where two different things come beside it, they need a side each."""
    ties = [(t, tie) for t in situation.followers for tie in t.ties if situation.target.id in tie.anchors]
    kinds = {t.request: t for t, tie in ties if tie.kind == "next_to"}
    if len(kinds) < 2:
        return np.zeros(len(rects))
    narrowest = min(situation.kind(t).size[1] for t in kinds.values())
    zones = [beside(rects, side, narrowest) for side in ("left", "right")]
    return fewest([zone_costs(situation, zone, weight=2.0) for zone in zones], 2)


def _room_about_table(situation: Situation, rects: Rects) -> Array:
    """Other seats will be around the low table before this one: they need the floor at the ends of the table."""
    later, costs = situation.observation.plan.targets, np.zeros(len(rects))
    low = [t for t in situation.followers if facts_of(t.category).is_in("lounged_at")]
    for table in (t for t in low if any(tie.kind == "in_front_of" for tie in t.ties)):
        about = [t for t in later if any(tie.kind == "around" and table.id in tie.anchors for tie in t.ties)]
        if not about:
            continue
        (depth, width, _), (reach, across, _) = situation.kind(table).size, situation.kind(about[0]).size
        front, left = rects.axes[:, 0], rects.axes[:, 1]
        middle = rects.centre + front * (rects.half[:, :1] + LEG_ROOM + depth / 2)
        reach += BESIDE_WALL
        half = np.tile([across / 2, reach / 2], (len(rects), 1))
        aside = width / 2 + LEG_ROOM + reach / 2
        ends = [Rects(middle + way * aside * left, half, rects.yaw, rects.bottom, rects.top) for way in (-1.0, 1.0)]
        costs += fewest([zone_costs(situation, end, weight=AT_END) for end in ends], min(len(about), 2))
    return costs


def _room_for_run(situation: Situation, rects: Rects) -> Array:
    """The first of a run leaves room for the rest to one side, and to the other for what comes next to it."""
    later = [t for t in situation.observation.plan.targets if t.id not in situation.scene and situation.in_run(t)]
    if len(later) < 2 or any(situation.in_run(p) for p in situation.solid):
        return np.zeros(len(rects))
    ends = [t for t in situation.followers if situation.in_run(t) and t.request != situation.target.request]
    lengths = ((len(later) - 1 - len(ends)) * situation.size[1], len(ends) * END_OF_RUN)
    ways = (("left", "right"), ("right", "left"))
    return np.minimum(*(_along(situation, rects, sides, lengths) for sides in ways))


def _room_for_chain(situation: Situation, rects: Rects) -> Array:
    """The first of several that stand side by side leaves room for the others to its sides."""
    chained = (tie.count - 1 for tie in situation.target.ties if tie.kind == "next_to" and not tie.anchors)
    others = next(chained, 0)
    if not others or situation.siblings:
        return np.zeros(len(rects))
    pitch = situation.size[1] + ABREAST
    splits = [(k * pitch, (others - k) * pitch) for k in range(others + 1)]
    ways = [_along(situation, rects, ("left", "right"), lengths) for lengths in splits]
    return np.asarray(np.min(ways, axis=0))


def _room_by_openings(situation: Situation, rects: Rects) -> Array:
    """What is asked to stand next to a door or a window later has a place by it."""
    costs = np.zeros(len(rects))
    plan, own = situation.observation.plan, situation.target.request
    later = [t for t in plan.targets if t.id not in situation.scene and t.request != own]
    for place in ("door", "window"):
        by = [t for t in later for tie in t.ties if tie.asked and (tie.kind, tie.anchors) == ("next_to", (place,))]
        sizes = [situation.kind(t).size for t in by if situation.kind(t).mount == "floor"]
        zones = _free_by(situation, place, sizes) if sizes else Rects.of([])
        if len(zones):
            left = len(zones) - (overlap_depth(rects, zones) > TOUCH).sum(-1)
            costs += NO_PLACE_BY * np.clip(min(len(sizes), len(zones)) - left, 0.0, None)
    return costs


def _free_by(situation: Situation, place: str, sizes: Sequence[Vec3]) -> Rects:
    """The floor on either side of each door or window that is free for the widest of some things."""
    room, (depth, width, height) = situation.room, (max(side) for side in zip(*sizes, strict=True))
    rows = []
    for opening in (o for o in room.openings if o.kind == place):
        wall, reach = room.walls[opening.wall], width / 2 + BY_FRAME
        sides = (opening.offset - reach, opening.offset + opening.width + reach)
        places = (along for along in sides if width / 2 <= along <= wall.length - width / 2)
        rows += [(wall.point(along, depth / 2), (depth, width), wall.yaw, 0.0, height) for along in places]
    zones = Rects.of(rows)
    blocked = overlap_depth(zones, joined([situation.solids, situation.door_zones])).max(-1, initial=0.0)
    return zones.take(blocked <= TOUCH)


def _along(situation: Situation, rects: Rects, sides: tuple[str, str], lengths: tuple[float, float]) -> Array:
    """What is missing of two stretches of a run, one to each side."""
    costs = np.zeros(len(rects))
    for side, length in zip(sides, lengths, strict=True):
        if length > 0.0:
            costs += zone_costs(situation, beside(rects, side, length), weight=2.0)
    return costs


def _room_for(situation: Situation, rects: Rects, follower: Target, tie: Tie) -> Array:
    size = situation.kind(follower).size
    pair = pair_need(situation, follower, size)
    wanted = (
        pair
        or seat_need(tie, of=situation.size, size=size)
        or need(follower, tie, of=situation.target.category, size=size)
    )
    if wanted is None:
        on_wall = situation.kind(follower).mount == "wall" or WALL_MOUNTED in follower.attributes
        in_line = situation.facts.is_in("built_in_line") and facts_of(follower.category).is_in("over_run")
        hung_above = tie.kind == "above" and on_wall and not in_line
        if not hung_above:
            return np.zeros(len(rects))
        return _wall_behind_taken(situation, rects) + (_off_walls(situation, rects) if tie.asked else 0.0)
    zones = [beside(rects, side, wanted.depth, width=wanted.width) for side in wanted.sides]
    missing = [zone_costs(situation, zone, weight=wanted.weight) + _in_use(situation, zone) for zone in zones]
    beside_it = facts_of(follower.category) if tie.kind in _AT_SIDE else None
    tall, high = (situation.facts, situation.size[2]) if pair else (beside_it, size[2])
    if tall is not None and high > DARKENS and tall.hanging.windows == "no":
        upright = [Rects(z.centre, z.half, z.yaw, z.bottom, z.bottom + high) for z in zones]
        dark = [(overlap_depth(zone, situation.window_zones) > 0.0).any(-1) for zone in upright]
        missing = [cost + np.where(taken, 4.0, 0.0) for cost, taken in zip(missing, dark, strict=True)]
    return fewest(missing, wanted.number)


def _in_use(situation: Situation, zone: Rects) -> Array:
    """What it costs that the follower would stand where others need the floor."""
    return np.asarray(IN_USE * overlap_depth(zone, situation.clearances).max(-1, initial=0.0))


def _wall_behind_taken(situation: Situation, rects: Rects) -> Array:
    """A window behind leaves nothing to hang something on."""
    tall = Rects(rects.centre, rects.half + 0.05, rects.yaw, rects.top, rects.top + 1.0)
    return np.where((overlap_depth(tall, situation.window_zones) > 0.0).any(-1), 4.0, 0.0)


def _off_walls(situation: Situation, rects: Rects) -> Array:
    """No side is at a wall, on which something is asked to hang above it."""
    nearest = np.full(len(rects), np.inf)
    for wall in situation.room.walls:
        inward, along = np.array(wall.inward), np.array(wall.along)
        half = (np.abs(rects.axes @ inward) * rects.half).sum(-1)
        away = (rects.centre - np.array(wall.start)) @ inward - half
        beside = (rects.centre - np.array(wall.start)) @ along
        before = (away > -TOUCH) & (beside > 0.0) & (beside < wall.length)
        nearest = np.where(before, np.minimum(nearest, away), nearest)
    return np.where(nearest > AT_WALL, OFF_WALL, 0.0)


def _wall_below_taken(situation: Situation, rects: Rects) -> Array:
    """Who writes on a board or throws darts stands before it: furniture there, with its chair, is in the way."""
    if situation.facts.is_in("written_on"):
        return zone_costs(situation, beside(rects, "front", BEFORE_BOARD), weight=3.0)
    costs = np.zeros(len(rects))
    for use in situation.facts.uses:
        costs += zone_costs(situation, beside(rects, "front", use.depth), weight=3.0)
    return costs


def _hidden(situation: Situation, rects: Rects) -> Array:
    """What it costs that something stands right before what hangs: a mirror behind a coat rack."""
    before = beside(rects, "front", HIDES)
    seen = Rects(before.centre, before.half, before.yaw, rects.bottom, rects.top)
    cost = NOT_WRITTEN_ON if situation.facts.is_in("written_on") else HIDDEN
    return np.asarray(cost * (overlap_depth(seen, situation.solids) > 0.01).any(-1))


def _behind_seats(situation: Situation, rects: Rects) -> Array:
    """What it costs that a screen hangs over a seat, from which nobody sees it."""
    if not situation.facts.is_in("watched"):
        return np.zeros(len(rects))
    seats = tuple(p for p in situation.solid if facts_of(p.category).is_in("seating"))
    below = Rects(rects.centre, rects.half + LEANS_OUT, rects.yaw, np.zeros(len(rects)), rects.bottom)
    return np.asarray(HIDDEN * (overlap_depth(below, Rects.of_placements(seats)) > TOUCH).any(-1))


def _over_heads(situation: Situation, rects: Rects) -> Array:
    """What it costs that a shelf with things on it hangs over where people lie, sit, play or cook, or a plant grows."""
    costs = np.zeros(len(rects))
    if not situation.asset.surfaces:
        return costs
    above = {anchor for tie in situation.target.ties if tie.kind == "above" for anchor in tie.anchors}
    around, before = (
        Rects(rects.centre, rects.half + out, rects.yaw, np.zeros(len(rects)), rects.bottom)
        for out in (LEANS_OUT, (LEANS_OUT, 0.0))
    )
    for p in situation.solid:
        facts = facts_of(p.category)
        under = before if facts.is_in("clear_above") else around  # Who cooks leans over the hob, not aside.
        grows = facts.is_in("plants") & (rects.bottom - p.top < UNDER_LEAVES)
        below = facts.is_in(*_HEADS) and not facts.is_in("drawn_aside")
        if p.id not in above and (p.position[2] < ON_FLOOR or facts.is_in("built_in")):
            there = overlap_depth(under, Rects.of_placements((p,))).max(-1, initial=0.0) > TOUCH
            costs += OVER_HEADS * (there & (grows | below))
    return costs


def costs_below(situation: Situation, rects: Rects) -> Array:
    """Room on the floor below a hung thing for what is to stand under it, and that it is seen."""
    costs = _wall_below_taken(situation, rects) + _hidden(situation, rects) + _over_heads(situation, rects)
    costs += _behind_seats(situation, rects)
    for follower in situation.followers:
        before = next((t for t in follower.ties if t.kind == "in_front_of" and situation.target.id in t.anchors), None)
        if before is not None and before.index == 0:
            costs += _room_for(situation, rects, follower, before)
        if any(tie.kind == "under" and situation.target.id in tie.anchors for tie in follower.ties):
            depth, width, height = situation.kind(follower).size
            out = depth / 2 - rects.half[:, 0] + 0.02
            front = np.stack([np.cos(rects.yaw), np.sin(rects.yaw)], axis=-1)
            half = np.tile([depth / 2, width / 2], (len(rects), 1))
            low = np.zeros(len(rects))
            zone = Rects(rects.centre + front * out[:, None], half, rects.yaw, low, low + height)
            costs += zone_costs(situation, zone, weight=10.0)
    return costs
