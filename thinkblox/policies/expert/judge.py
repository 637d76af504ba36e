"""Taste: what speaks against an idea, seen from above. Physics has the last word; this decides what is worth proposing.

The figures are the handbook guidelines of interior layout (Neufert; Time-Saver Standards; Merrell et al. 2011,
"Interactive Furniture Layout Using Interior Design Guidelines"), as costs: about 1 is a clear drawback, HOPELESS is
what cannot be.
"""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from thinkblox.assets import facts_of
from thinkblox.observe import Layout
from thinkblox.plan import Tie, is_object
from thinkblox.policies.expert.followers import costs_below, follower_costs
from thinkblox.policies.expert.ground import TOUCH, darkens, ground_costs
from thinkblox.policies.expert.hung import is_among_people
from thinkblox.policies.expert.idea import Idea
from thinkblox.policies.expert.sight import sight_costs
from thinkblox.policies.expert.situation import Situation, is_large
from thinkblox.policies.expert.ways import imbalance, moment
from thinkblox.scene.bearings import bearing
from thinkblox.scene.landmarks import things
from thinkblox.scene.pairs import NEXT_TO
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Array, Rects, outside, overlap_depth
from thinkblox.scene.relations import measure
from thinkblox.scene.room import turn_between
from thinkblox.scene.support import ON_FLOOR
from thinkblox.value import Vec3

HOPELESS = 50.0
MOOD = 0.25
"""How much a seed may prefer one part of the room to another."""
ZONED = 4.0
"""How much more that is for large things that stand by no other, as far as floor is to spare: they make the zones."""
LEADING = 4.5
"""How quickly that changes over the room for them, as a share of it: what is slow keeps them in the middle of walls."""
UNMET_ASKED, UNMET_HABIT = 8.0, 1.5
BARELY_BESIDE, _SURELY_BESIDE = 3.0, 0.3
"""Cost of being next to a thing only by the boxes around both, which their surfaces are inside of [m]."""
BARELY_FACING, _SURELY_FACING = 2.0, 27.0
"""Cost of looking at a side of a thing rather than its middle, by more than so much [degrees]."""
BY_CHANCE = 3.0
"""Cost of a relation that only others of its kind are to have."""
_SIDE = 2.5
"""How far from a thing people say of another that it is to the left of it [m]."""
_PLACING = ("left_of", "right_of", "in_front_of", "behind", "next_to")
"""Relations that say at which side of one thing another is."""
MISSED_BY, FAR_OFF = 0.4, 3.0
"""Cost per metre by which it misses what it is to be close by, and the most of it."""
SWING, IN_SWING = 0.5, 8.0
"""Free floor all round what hangs among people [m], and the cost per metre of what is in it."""
STOOD_ON, STOOD_PARTLY_ON = 8.0, 3.0
"""Cost per metre by which furniture stands on a rug that is a place of its own, and on one that is there for looks."""
ON_ANOTHER = (6.0, 30.0)
"""Cost per metre by which a rug lies on another, and a mat for people to lie on."""
HALF_UNDER, OFF_TABLE = 3.0, 1.5
"""Cost of a rug of which only a part is under a table, and per metre from its middle to that of one on it."""
DENIED, KEPT_FREE = 14.0, 16.0
"""Cost of a relation that must not hold, and of standing where it is to stay free: more than to stand elsewhere."""
CASING, ON_CASING = 0.1, 4.0
"""How wide the frame of a door is around it [m], and what it costs to hang something on it."""
FINALISTS, MOST_LOOKED_AT = 40, 400
"""How many ideas are held against what the plan wants, and at most where most have what they must not."""
OF_EACH_SORT = 10
"""How many ideas of each sort are looked at besides: a place by the second relation may meet the first as well."""


def ranked(situation: Situation, ideas: Sequence[Idea], rng: np.random.Generator) -> list[tuple[float, Idea]]:
    """Every idea with its cost, the best first; `rng` breaks near ties, so that seeds differ."""
    if not ideas:
        return []
    rects = boxes(situation, ideas)
    costs = np.array([idea.cost for idea in ideas])
    costs += _impossible(situation, ideas, rects)
    if situation.asset.mount == "floor" and situation.asset.collides:
        ground = ground_costs(situation, rects) + follower_costs(situation, rects) + sight_costs(situation, rects)
        if is_large(situation.size):
            ground += imbalance(situation, moment(situation.room, rects))
        costs += np.where(_carried(ideas), 0.0, ground)
    if situation.asset.mount == "wall":
        costs += costs_below(situation, rects)
    if is_among_people(situation):
        costs += _costs_around(situation, rects)
    costs += _mood(situation, rects, rng)
    order = np.argsort(costs, kind="stable")
    finalists: list[int] = []
    spared = 0
    of_its_sort: dict[str, int] = {}
    for i in map(int, order[:MOST_LOOKED_AT]):
        sort = ideas[i].why
        of_its_sort[sort] = of_its_sort.get(sort, 0) + 1
        if spared >= FINALISTS and (of_its_sort[sort] > OF_EACH_SORT or costs[i] >= HOPELESS):
            continue
        denied = _denied(situation, ideas[i])
        spared += denied == 0.0
        if denied and len(finalists) - spared >= FINALISTS:
            continue
        costs[i] += denied + _unmet(situation, ideas[i]) + _by_chance(situation, ideas[i])
        finalists.append(i)
    return [(float(costs[i]), ideas[i]) for i in sorted(finalists, key=lambda i: costs[i])]


def _costs_around(situation: Situation, rects: Rects) -> Array:
    """What the floor below says against what hangs among people, who move about it on all sides."""
    around = Rects(rects.centre, rects.half + SWING, rects.yaw, np.zeros(len(rects)), rects.top)
    taken = overlap_depth(around, situation.solids).max(-1, initial=0.0) + outside(around, situation.room.polygon)
    return np.asarray(ground_costs(situation, around) + IN_SWING * taken)


def _mood(situation: Situation, rects: Rects, rng: np.random.Generator) -> Array:
    """A preference for some parts of the room and for some directions, other with every seed.

    It varies slowly over the room: ideas that differ in detail keep their order, so that what is even stays even.
    """
    built = situation.facts.is_in("built_in_line")
    leads = is_large(situation.size) and not situation.target.depends_on and not built
    waves = rng.standard_normal((3, 2)) * (LEADING if leads else 2.0) / max(situation.room.extent)
    field = np.sin(rects.centre @ waves.T + rng.uniform(0.0, 2 * np.pi, 3)).mean(-1)
    turned = np.cos(rects.yaw - rng.uniform(0.0, 2 * np.pi))
    mood = MOOD * (1.0 + ZONED * situation.spare if leads else 1.0)
    return np.asarray(mood * (field + 0.5 * turned) + 0.002 * rng.standard_normal(len(rects)))


def placement_of(situation: Situation, idea: Idea) -> Placement:
    """The idea as a placement."""
    target = situation.target
    return Placement(
        id=target.id,
        category=target.category,
        asset=situation.asset.id,
        position=idea.position,
        yaw=idea.yaw,
        size=idea.size or situation.size,
        support=idea.ignore[0] if situation.mount == "surface" and idea.ignore and _carried([idea])[0] else "floor",
    )


def boxes(situation: Situation, ideas: Sequence[Idea]) -> Rects:
    """The box of each idea."""
    return Rects.of(
        [
            (
                (i.position[0], i.position[1]),
                _flat(i.size or situation.size),
                i.yaw,
                i.position[2],
                i.position[2] + (i.size or situation.size)[2],
            )
            for i in ideas
        ]
    )


def _flat(size: Vec3) -> tuple[float, float]:
    return (size[0], size[1])


def _impossible(situation: Situation, ideas: Sequence[Idea], rects: Rects) -> Array:
    """Outside, in something, in a door's swing, before a window."""
    out = outside(rects, situation.room.polygon)
    costs = np.where(out > 0.0005, HOPELESS + 50.0 * out, 0.0)
    if not situation.asset.collides:
        apart = ON_ANOTHER[situation.facts.is_in("lain_out")]
        return (
            costs + apart * _other_rugs(situation, rects) + _stood_on(situation, rects) + _half_under(situation, rects)
        )
    costs += np.where(overlap_depth(rects, situation.kept_free).max(-1, initial=0.0) > TOUCH, KEPT_FREE, 0.0)
    worst = depth_in_others(situation, ideas, rects)
    costs += np.where(worst > TOUCH, HOPELESS + 50.0 * worst, 0.0)
    if situation.asset.mount == "surface":
        return costs
    swing = overlap_depth(rects, situation.door_zones).max(-1, initial=0.0)
    zones = np.where(swing > TOUCH, HOPELESS + 20.0 * swing, 0.0)
    if situation.facts.hanging.windows == "no":
        zones += HOPELESS * darkens(situation, rects)
    if situation.asset.mount == "wall":
        framed = Rects(rects.centre, rects.half + CASING, rects.yaw, rects.bottom - CASING, rects.top)
        on_frame = overlap_depth(framed, situation.door_zones).max(-1, initial=0.0) > TOUCH
        zones += ON_CASING * on_frame
    return costs + np.where(_carried(ideas) & (situation.asset.mount == "floor"), 0.0, zones)


def _carried(ideas: Sequence[Idea]) -> NDArray[np.bool_]:
    """Which ideas stand on something that is not the floor."""
    return np.array([idea.position[2] > ON_FLOOR for idea in ideas])


def depth_in_others(situation: Situation, ideas: Sequence[Idea], rects: Rects) -> Array:
    """How deep the box of each idea is in what stands, other than what it may overlap [m]."""
    depth = overlap_depth(rects, situation.solids)
    return np.asarray(_except_ignored(depth, ideas, situation.solid).max(-1, initial=0.0))


def _except_ignored(depth: Array, ideas: Sequence[Idea], others: Sequence[Placement]) -> Array:
    """Strike out what each idea may overlap."""
    column = {p.id: n for n, p in enumerate(others)}
    kept = depth.copy()
    for row, idea in enumerate(ideas):
        for id in idea.ignore:
            if id in column:
                kept[row, column[id]] = 0.0
    return kept


def _stood_on(situation: Situation, rects: Rects) -> Array:
    """What it costs that something stands on what lies in a corner or for people to lie on, to be used as it is.

    A rug that nobody asked for, and that is for nothing that stands, is better off where it is clear of all.
    """
    ties = situation.target.ties
    used = situation.facts.is_in("lain_out") or any(tie.kind == "in_corner" for tie in ties)
    loose = not situation.target.asked and not any(tie.kind == "under" for tie in ties)
    if not (used or loose):
        return np.zeros(len(rects))
    return np.asarray(
        (STOOD_ON if used else STOOD_PARTLY_ON) * overlap_depth(rects, situation.solids).max(-1, initial=0.0)
    )


def _half_under(situation: Situation, rects: Rects) -> Array:
    """What it costs that a rug is half under a table at which people sit, and so neither its own nor another."""
    costs = np.zeros(len(rects))
    for p in situation.solid:
        if not facts_of(p.category).is_in("sat_around") or p.position[2] > ON_FLOOR:
            continue
        to = np.array(p.position[:2]) - rects.centre
        off = np.abs((rects.axes @ to[:, :, None])[:, :, 0])
        reach = max(p.size[:2]) / 2
        apart, within = (off - reach > rects.half).any(-1), (off + reach <= rects.half).all(-1)
        costs += np.where(apart, 0.0, np.where(within, OFF_TABLE * np.linalg.norm(off, axis=-1), HALF_UNDER))
    return costs


def _other_rugs(situation: Situation, rects: Rects) -> Array:
    rugs = tuple(p for p in situation.scene.placements if not situation.scene.asset_of(p).collides)
    return np.asarray(overlap_depth(rects, Rects.of_placements(rugs)).max(-1, initial=0.0))


def _denied(situation: Situation, idea: Idea) -> float:
    """What this idea has and must not have."""
    if not situation.target.denied:
        return 0.0
    scene = situation.scene.with_placement(placement_of(situation, idea), situation.asset)
    cost = 0.0
    for tie in situation.target.denied:
        anchors = tuple(a for a in tie.anchors if a in scene or not is_object(a))
        if anchors or not tie.anchors:
            cost += DENIED * (not measure(scene, tie.kind, situation.target.id, anchors, negated=True).holds)
    return cost


def _unmet(situation: Situation, idea: Idea) -> float:
    """What the plan wants of it and this idea does not give."""
    scene = situation.scene.with_placement(placement_of(situation, idea), situation.asset)
    cost = 0.0
    ties = situation.target.ties
    if any(tie.kind in ("facing", "facing_away") and tie.asked for tie in ties):
        ties = tuple(tie for tie in ties if tie.asked or tie.kind != "against_wall")
    for tie in ties:
        if (
            tie.kind in ("around", "in_rows")
            or not tie.anchors
            or any(a not in scene and is_object(a) for a in tie.anchors)
        ):
            continue
        if not measure(scene, tie.kind, situation.target.id, tie.anchors, rows=tie.rows).holds:
            other = _holds_with_another(situation, scene, tie)
            cost += UNMET_HABIT * (tie.asked or not other) if other or not tie.asked else UNMET_ASKED
            cost += _away(scene, situation.target.id, tie)
        elif tie.asked and tie.kind == "next_to" and all(is_object(a) for a in tie.anchors):
            own = scene[situation.target.id].footprint
            apart = max(float(own.distance(scene[a].footprint)) for a in tie.anchors)
            cost += BARELY_BESIDE * (apart > _SURELY_BESIDE)
        elif tie.asked and tie.kind == "facing" and len(tie.anchors) == 1 and is_object(tie.anchors[0]):
            cost += BARELY_FACING * (_off_middle(scene, situation.target.id, tie.anchors[0]) > _SURELY_FACING)
    for due in situation.target.due:
        if all(id in scene for id in (due.subject, *due.tie.anchors)):
            cost += UNMET_ASKED * (not measure(scene, due.tie.kind, due.subject, due.tie.anchors).holds)
    return cost


def _off_middle(scene: Layout, id: str, anchor: str) -> float:
    """By how much a thing looks past the middle of another [degrees]; 0 where it looks every way."""
    (one,), (other,) = things(scene, id), things(scene, anchor)
    if one.front == "any" or other.hung:
        return 0.0
    turn = turn_between(one.gaze, bearing(one.centre, other.centre))
    return min(turn, 180.0 - turn) if one.front == "two" else turn


def _by_chance(situation: Situation, idea: Idea) -> float:
    """What it costs to stand as only others of its kind are to: one armchair to the left of the aquarium is not two."""
    target, plan = situation.target, situation.observation.plan
    own = {anchor for tie in target.ties for anchor in tie.anchors}
    others = (t for t in plan.targets if t.category == target.category and t.request != target.request)
    ties = {(tie.kind, tie.anchors) for t in others for tie in t.ties if tie.asked and tie.kind in _PLACING}
    ties = {(kind, a) for kind, a in ties if len(a) == 1 and a[0] in situation.scene and a[0] not in own}
    if not ties:
        return 0.0
    stands = placement_of(situation, idea)
    return BY_CHANCE * sum(_is_at_side(stands, situation.scene[anchors[0]], kind) for kind, anchors in sorted(ties))


def _is_at_side(stands: Placement, anchor: Placement, kind: str) -> bool:
    """Whether something is next to another, or by and large on a side of it: in what opens like a fan from there."""
    if kind == "next_to":
        return float(stands.footprint.distance(anchor.footprint)) <= NEXT_TO
    x, y = anchor.to_local(stands.position[:2])
    out, aside = (x, y) if kind in ("in_front_of", "behind") else (y, x)
    half, wide = anchor.size[kind in ("left_of", "right_of")] / 2, anchor.size[kind in ("in_front_of", "behind")] / 2
    away = (out if kind in ("in_front_of", "left_of") else -out) - half
    return -half / 2 <= away <= _SIDE and abs(aside) <= 1.25 * wide + max(away, 0.0)


def _away(scene: Layout, id: str, tie: Tie) -> float:
    """What it costs by how much a thing misses what it is to be close by: better two metres than ten."""
    if tie.kind == "in_centre" and tie.anchors == ("centre",):
        middle = scene.room.polygon.centroid.coords[0]
        return min(FAR_OFF, MISSED_BY * math.dist(scene[id].position[:2], middle))
    if tie.kind not in ("next_to", "near", "in_front_of") or not all(anchor in scene for anchor in tie.anchors):
        return 0.0
    own = scene[id].footprint
    return min(FAR_OFF, MISSED_BY * min(float(own.distance(scene[anchor].footprint)) for anchor in tie.anchors))


def _holds_with_another(situation: Situation, scene: Layout, tie: Tie) -> bool:
    """Whether it is next to another of the anchor's request, which is what was asked for too."""
    if tie.kind not in ("next_to", "near") or len(tie.anchors) != 1:
        return False
    own = {anchor for each in situation.target.ties for anchor in each.anchors}
    others = tuple(p.id for p in situation.alike(tie.anchors[0]) if p.id not in own)
    return bool(others) and measure(scene, tie.kind, situation.target.id, others).holds
