"""From a target's relations to ideas: the first tie decides where to look, the room itself is the last resort."""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import product

from msgspec import structs

from thinkblox.assets import facts_of
from thinkblox.knowledge.habits import load_habits
from thinkblox.phrases import Constraint
from thinkblox.plan import Target, Tie, carries, is_object
from thinkblox.policies.expert import (
    around,
    beneath,
    beside,
    hung,
    open_floor,
    partners,
    rows,
    rugs,
    runs,
    sides,
    spreading,
    surfaces,
    uppers,
    walls,
)
from thinkblox.policies.expert.idea import WALL_GAP, Idea
from thinkblox.policies.expert.needs import WORKING, backs_worker
from thinkblox.policies.expert.sight import BACK_TO_VIEW, comes_across
from thinkblox.policies.expert.situation import Situation, is_lounge, is_seat
from thinkblox.scene.asset import Mount
from thinkblox.scene.landmarks import Landmark, corners, things
from thinkblox.scene.pairs import FACING, NEAR
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Rects
from thinkblox.scene.room import turn_between
from thinkblox.scene.saying import turned
from thinkblox.scene.support import ON_FLOOR

AT_COUNTER = (0.1, 0.2, 0.3)
"""Free distance of a stool to the counter that it stands at, the best first [m]."""
BEFORE_LOUNGE = (0.4, 0.35, 0.5)
"""Free distance to a lounge seat of what stands before it, for the legs of who sits there [m]."""
OUT_OF_LINE = 2.0
"""Cost of a place before something that is none of those that are shared out among several."""
TURNED_AWAY = 8.0
"""Cost of looking elsewhere than asked."""
BESIDE_INSTEAD = 3.0
"""Cost of standing beside what cannot carry or hold it."""
AMID, AMID_INSTEAD = 2.0, 5.0
"""Cost of standing amid the room of what has no reason to, and of what belongs to a wall or into a corner."""
LIES_ABOUT = 0.8
"""Several things that are smaller than this may be on the floor before a door or window, and not at the walls [m]."""
_SIDED = ("in_front_of", "behind", "left_of", "right_of")
BEHIND_IT, IN_USE = 3.0, 6.0
"""Cost of standing behind or before what has a front, instead of beside it."""
EYE_LEVEL = 1.4
"""What is higher bars a front that it stands before, rather than being in the way of it [m]."""
RECEIVING = -2.5
"""Cost of a desk that looks into the room where people are received across it."""
UNSERVED = 2.0
"""Cost of a counter with no room behind it for who serves."""
ROUND_CORNER, SEAT_DEPTH = 1.3, 1.0
"""Depth from which a sofa goes round a corner, and that of its seats without that part [m]."""
WITHIN_CORNER = 3.0
"""How much better a low table stands within such a sofa than before all of it, which is not before it as measured."""
BACK_TO_CLASS = 4.0
"""Cost of another place near a board than before it, over which one looks at the class."""
SIDE_BY_SIDE = 4.0
"""Cost of two alike one behind the other that are to be next to each other."""
CROWDED_SIDE = 6.0
"""Cost of a second of two at the same side, where one belongs to each."""
ASKEW = 4.0
"""Cost of turning a thing against what carries it, by whose sides others stand."""
BY_ANOTHER = 2.0
"""Cost of standing by another of the anchor's kind than its own."""
UNPAIRED = 3.0
"""Cost of a place that leaves no room for what comes between it and its partner, or too much."""
MIDDLE_OF_RUN = -2.5
"""Cost of standing before the middle of a run, besides what it costs not to be before the very part that is named."""
OUT_OF_RUN = 20.0
"""Cost of a place that breaks the run that is built in one line, or is not over it."""
_TURNED = ("facing", "facing_away")
"""Relations that say how a thing is turned, not where it stands."""
_PLACED_TOGETHER = ("in_rows", "around", "at_long_side", "at_short_side", "at")
"""Relations that decide where those stand who look at each other."""
SIDE_GAP, SEATED_BEFORE = 0.01, 0.8
"""Free distance between cases side by side, and least free floor for a chair between them and a desk [m]."""
BEYOND_DESK = 2.5
"""Cost of standing on the visitors' side of a desk, where it is to be behind who works there."""
OFF_MIDDLE = 0.3
"""Cost of standing beside the middle of a rug, besides the distance."""
PILED = 4.0
"""Cost of lying on what is inside a container, rather than on its bottom."""
SEATED = 0.2
"""Free floor behind a seat that is drawn up to a table by the wall [m]."""
_OPEN_SIDES, _DRAWN_UP = 2, 0.5
"""Seats at the sides of a table in a corner that are open, and floor for one between the table and a wall [m]."""
GATHERED = 1.0
"""Cost per metre from a low table to a lounge seat that stands by a wall instead of before the table."""
OFF_CENTRE = 1.0
"""Cost per metre away from the middle of the room, besides the usual, of what is asked to be there."""
OFF_USUAL = 5.0
"""Cost of standing on the floor, by what it is asked to be by, for what is usually carried: that is better kept."""
ELSEWHERE = 12.0
"""Cost of a place that gives up the relation that decides where a thing goes."""


def from_ties(situation: Situation) -> list[Idea]:
    """Ideas from each tie of the target in its order; who is faced by its like stands free for that."""
    ties = tuple(sorted(situation.target.ties, key=lambda tie: not _is_turned_first(situation, tie)))
    seated = {tie.anchors for tie in ties if tie.kind in ("at_long_side", "at_short_side")}
    drawn_up = {tie.anchors for tie in ties if tie.kind == "at"}
    ties = tuple(tie for tie in ties if tie.kind != "next_to" or tie.anchors not in drawn_up)
    in_rows = any(tie.kind == "in_rows" for tie in ties)
    if in_rows:  # A row has its walls among its places.
        ties = tuple(sorted(ties, key=lambda tie: tie.kind == "against_wall"))
    ties = tuple(tie for tie in ties if tie.kind != "facing" or not (in_rows or tie.anchors in seated))
    if any(tie.kind == "above" and situation.placed(tie.anchors) for tie in ties):
        ties = tuple(tie for tie in ties if tie.kind != "on" or tie.anchors not in (("wall",), ("ceiling",)))
    ties = tuple(sorted(ties, key=lambda tie: tie.kind == "on" and tie.anchors == ("wall",)))
    if not situation.asset.collides:  # What stands on a rug decides where that lies, and then what it lies before.
        ties = tuple(sorted(ties, key=lambda tie: tie.kind != "under"))
    like = {t.id for t in _company(situation)}
    mutual = tuple(tie for tie in ties if tie.kind == "facing" and like.issuperset(tie.anchors))
    if mutual and not any(tie.kind in _PLACED_TOGETHER for tie in ties):
        ties = mutual
    lined = in_rows and partners.gaps_in_row(situation)
    if lined:
        ties = tuple(tie for tie in ties if tie.kind == "in_rows")
    seated_round = any(tie.kind == "around" for tie in ties)
    lined_up = list(runs.run_ideas(situation)) if runs.is_built(situation) else []
    paired = [] if lined or seated_round else list(partners.partner_ideas(situation, built=bool(lined_up)))
    lined_up += list(uppers.upper_ideas(situation)) if uppers.hangs_over_run(situation) else []
    lined_up += list(uppers.hood_ideas(situation))
    dear = OUT_OF_RUN if lined_up else UNPAIRED if paired else 0.0
    paired += lined_up
    ideas = [_dearer(idea, 2.0 * rank + dear) for rank, tie in enumerate(ties) for idea in _from_tie(situation, tie)]
    ideas += _receiving(situation)
    carried = [tie for tie in ties if carries(tie) and situation.placed(tie.anchors)]
    if situation.asset.mount == "surface" and carried:
        down = ELSEWHERE if any(tie.asked for tie in carried) else OFF_USUAL
        ideas = [_dearer(idea, down if idea.position[2] <= ON_FLOOR else 0.0) for idea in ideas]
    return [*paired, *ideas, *(_dearer(idea, dear) for idea in _before_staff(situation))]


def _is_turned_first(situation: Situation, tie: Tie) -> bool:
    """Whether what it looks at decides before any habit where it stands.

    That is what is across the room, where one is asked to look at it a door, a window or a wall, and for a lounge seat
    what is no seat: a screen, a fire.
    """
    if tie.kind == "opposite":
        return bool(situation.placed(tie.anchors))
    if tie.kind not in _TURNED or not tie.asked or not tie.anchors:
        return False
    if not any(map(is_object, tie.anchors)):
        return True
    return is_lounge(situation.target.category) and not any(is_seat(p.category) for p in situation.placed(tie.anchors))


def _before_staff(situation: Situation) -> Iterator[Idea]:
    """Off the walls by what is to stand behind it."""
    own = situation.target.id
    behind = [later for later in situation.followers if _is_behind(later, own)]
    behind = [later for later in behind if not backs_worker(facts_of(later.category), situation.facts)]
    together = any(tie.kind in _PLACED_TOGETHER for tie in situation.target.ties)
    if not behind or together or situation.asset.mount != "floor":
        return
    kinds = [situation.kind(later) for later in behind]
    deepest = max((kind.size[0] for kind in kinds if kind.mount in ("floor", "surface")), default=0.0)
    served = situation.facts.is_in("counters")
    gaps = beside.SERVED_BEHIND if served else beside.BEHIND_GAPS
    yield from walls.off_walls(situation, max(walls.BEHIND if served or not deepest else 0.0, deepest + gaps[0]))
    if deepest and not served:
        yield from walls.off_walls(situation, deepest + gaps[-1])


def _receiving(situation: Situation) -> Iterator[Idea]:
    """A desk across which people are received, or with things behind it: who works there looks into the room.

    Behind them is the wall, or what stands there.
    """
    visits = (
        tie.kind == "in_front_of" and situation.target.id in tie.anchors and facts_of(later.category).is_in("visits")
        for later in situation.followers
        for tie in later.ties
    )
    own = situation.target.id
    backing = [t for t in situation.followers if _is_behind(t, own) and situation.kind(t).mount == "floor"]
    backing = [t for t in backing if backs_worker(facts_of(t.category), situation.facts)]
    if situation.asset.gaze == "back" and situation.asset.mount == "floor" and (backing or any(visits)):
        deepest = max((situation.kind(later).size[0] + WALL_GAP for later in backing), default=-0.1)
        for idea in walls.off_walls(situation, walls.BEHIND + deepest, turned_round=True):
            yield _dearer(idea, RECEIVING)


def _is_behind(later: Target, own: str) -> bool:
    return any(tie.kind == "behind" and own in tie.anchors for tie in later.ties)


def from_room(situation: Situation) -> list[Idea]:
    """Ideas from the room as a whole; dear, where a tie says that the object belongs somewhere."""
    dearer = ELSEWHERE if situation.target.ties else 0.0
    return [_dearer(idea, dearer) for idea in _BY_MOUNT[situation.asset.mount](situation)]


def _dearer(idea: Idea, cost: float) -> Idea:
    return idea if cost == 0.0 else replace(idea, cost=idea.cost + cost)


def anywhere(situation: Situation) -> Iterator[Idea]:
    """Along the walls, in the corners and, for what may stand free, on the open floor."""
    free = situation.facts.is_in("stands_free") or not situation.asset.collides
    corner = situation.facts.is_in("in_corners")
    watched = hung.is_watched(situation)
    for idea in walls.along_walls(situation):
        yield _dearer(idea, 0.8 if free or corner else 0.0)
    for idea in walls.corners(situation):
        yield _dearer(idea, 3.0 if watched else 0.8 if free else 0.0 if corner else 0.3)
    walled = any(tie.kind in ("against_wall", "in_corner") for tie in situation.target.ties)
    for idea in open_floor.grid(situation):
        yield _dearer(idea, 0.0 if free else AMID_INSTEAD if walled else AMID)


def _strewn(situation: Situation) -> Iterator[Idea]:
    """Small things on the floor lie about where people walk and sit, rather than along the walls."""
    for idea in open_floor.grid(situation):
        yield replace(idea, cost=0.0)
    for idea in walls.along_walls(situation):
        yield _dearer(idea, AMID)


def _any_surface(situation: Situation) -> Iterator[Idea]:
    """On whatever furniture no other thing is still to come onto; what is asked for, there rather than on the floor."""
    later = [t for t in situation.observation.plan.targets if t.id not in situation.scene and t != situation.target]
    promised = {a for t in later for tie in t.ties if carries(tie) for a in tie.anchors}
    for anchor in situation.solid:
        meant = anchor.id in promised
        if (meant and not situation.target.asked) or situation.scene.asset_of(anchor).mount == "surface":
            continue
        if situation.facts.is_in("built_in") and not facts_of(anchor.category).is_in("takes_built_in"):
            continue
        if any(not surface.within for surface in situation.scene.asset_of(anchor).surfaces):
            for idea in surfaces.on_surfaces(situation, anchor, Tie(kind="on", anchors=(anchor.id,))):
                yield _dearer(idea, ELSEWHERE / 4 if meant else 0.0)
    if situation.target.asked or not situation.facts.is_in("built_in"):
        for idea in anywhere(situation):
            yield _dearer(idea, ELSEWHERE / 2)


def _from_tie(situation: Situation, tie: Tie) -> Iterable[Idea]:
    if tie.kind == "in_rows":
        return _rows(situation, tie)
    anchors = situation.placed(tie.anchors)
    places = [a for a in tie.anchors if not is_object(a)]
    if places and not anchors:
        ideas = _far_from_place(situation, places[0]) if tie.kind == "far" else _at_place(situation, tie, places[0])
        return spreading.spread_out(situation, tie, ideas) if tie.spread else ideas
    if not tie.anchors and tie.kind in _WITHOUT_ANCHOR:
        return _WITHOUT_ANCHOR[tie.kind](situation)
    if not anchors:
        return ()
    if tie.kind == "between" and len(anchors) > 1:
        return beside.between(situation, anchors)
    return _BY_ANCHOR.get(tie.kind, _next_to)(situation, anchors[0], tie)


def _rows(situation: Situation, tie: Tie) -> Iterator[Idea]:
    facing = [t for t in situation.target.ties if t.kind in ("facing", "opposite")]
    siblings = {t.id for t in _company(situation)}
    mutual = any(set(t.anchors) & siblings or not t.anchors for t in facing) and tie.rows == 2
    looked_at = tuple(a for t in facing for a in t.anchors if a not in siblings)
    return rows.in_rows(situation, tie, facing=looked_at, mutual=mutual)


def _at_place(situation: Situation, tie: Tie, place: str) -> Iterable[Idea]:
    if situation.asset.mount == "wall":
        dresses = situation.facts.hanging.windows != "no"
        by = hung.at_openings(situation, tie.kind, place) if place in ("door", "window") and not dresses else ()
        return (*by, *hung.on_walls(situation, place))
    if situation.asset.mount == "ceiling":
        return _over_corner(situation, tie) if tie.kind == "in_corner" else hung.from_ceiling(situation)
    if not situation.asset.collides and place == "door":
        return open_floor.at_doors(situation)
    if tie.kind == "in_corner" or place == "corner":
        return _in_corner(situation, tie)
    if not situation.asset.collides or place == "centre":
        return _amid_room(situation)
    if place == "floor":
        return _strewn(situation) if situation.asset.mount == "surface" else anywhere(situation)
    if tie.kind == "opposite" and place in ("window", "door"):
        return walls.across_from(situation, place)
    if tie.kind in _TURNED:
        return _turned_to(situation, things(situation.scene, place), tie.kind)
    if place in ("window", "door"):
        return _near_openings(situation, place)
    return _by_wall(situation, tie, place)


def _by_wall(situation: Situation, tie: Tie, place: str) -> Iterator[Idea]:
    """Against the walls that a place means; a counter that is by a wall rather has room behind it for who serves.

    One with a sink beside a kitchen's appliance is worked at like the rest of the kitchen, from the room.
    A seat from which something across the room is to be seen stands free before it where the walls are too far apart.
    """
    served = tie.kind == "near" and situation.facts.is_in("served_over") and not _is_of_kitchen(situation)
    if served:
        yield from walls.off_walls(situation)
    for idea in walls.in_line(situation, place):
        yield _dearer(idea, UNSERVED if served else 0.0)
    seen = [t for t in situation.followers if comes_across(situation, t)]
    if seen and not tie.asked:
        yield from open_floor.across_from_walls(situation, situation.kind(seen[0]).size[0])


def _is_of_kitchen(situation: Situation) -> bool:
    """Whether a counter is there for its sink, or has one, and what is built into a kitchen's run stands next to it."""
    own = situation.target.id
    if situation.is_mere_worktop:
        return True
    on = [t for t in situation.followers if any(tie.kind == "on" and own in tie.anchors for tie in t.ties)]
    beside = [t for t in situation.followers if any(tie.kind == "next_to" and own in tie.anchors for tie in t.ties)]
    sunk = any(facts_of(t.category).is_in("built_in") for t in on)
    return sunk and any(facts_of(t.category).is_in("built_in_line") for t in beside)


def _in_corner(situation: Situation, tie: Tie) -> Iterator[Idea]:
    """In the corners that the tie means: any, those of one wall, or the one where two walls meet."""
    meant = {corner.name for corner in corners(situation.room, tie.anchors)}
    for idea in walls.corners(situation):
        if f"corner of {' and '.join(idea.words[0].anchors)}" not in meant:
            continue
        if _is_sat_round(situation):
            yield _out_of_corner(situation, idea)
        if tie.count > 1 and not tie.spread and max(situation.size) < LIES_ABOUT:
            yield from _gathered(situation, idea)
        else:
            yield idea


def _gathered(situation: Situation, flush: Idea) -> Iterator[Idea]:
    """Several small things in a corner: side by side along its walls, all in the corner that the first has taken."""
    apart = [math.dist(flush.position[:2], p.position[:2]) for p in situation.siblings]
    elsewhere = spreading.ELSEWHERE if apart and min(apart) > NEAR else 0.0
    wall = next((wall for wall in situation.room.walls if wall.name in flush.against), None)
    if wall is None:
        yield _dearer(flush, elsewhere)
        return
    along, out = wall.coordinates((flush.position[0], flush.position[1]))
    _, (depth, width) = walls.oriented(situation.size, situation.asset.front)
    way = 1.0 if along < wall.length / 2 else -1.0
    for i, j in product(range(3), repeat=2):
        x, y = wall.point(along + way * i * (width + SIDE_GAP), out + j * (depth + SIDE_GAP))
        words = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(flush.yaw))
        beside_it = replace(flush, position=(x, y, 0.0), words=(flush.words[0], *words), against=())
        yield _dearer(flush if i == j == 0 else beside_it, elsewhere + 0.3 * (i + j))


def _over_corner(situation: Situation, tie: Tie) -> Iterator[Idea]:
    """From the ceiling, with room between it and the walls of a corner."""
    z = round(situation.room.height - situation.size[2], 3)
    above = Constraint(kind="above", anchors=("floor",), values=(z,))
    for flush in _in_corner(situation, tie):
        x, y, _ = (idea := _out_of_corner(situation, flush)).position
        yield replace(idea, position=(x, y, z), words=(*idea.words, above), why="it hangs in the corner")


def _is_sat_round(situation: Situation) -> bool:
    """Whether more will sit about it than have room at the two sides that a corner leaves open."""
    ties = (tie for t in situation.followers for tie in t.ties if situation.target.id in tie.anchors)
    return any(tie.kind == "around" and tie.count > _OPEN_SIDES for tie in ties)


def _out_of_corner(situation: Situation, idea: Idea) -> Idea:
    """As far from both walls of the corner as the seats on these sides take."""
    inward = [wall.inward for wall in situation.room.walls if wall.name in idea.words[0].anchors]
    x, y = (at + _DRAWN_UP * sum(way[axis] for way in inward) for axis, at in enumerate(idea.position[:2]))
    words = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(idea.yaw))
    return Idea((x, y, 0.0), idea.yaw, words, "seats fit between it and both walls of the corner", idea.cost - AMID)


def _turned_to(situation: Situation, marks: Sequence[Landmark], kind: str) -> Iterator[Idea]:
    """Along the walls and on the floor, whichever way looks at what is marked, or has its back to that."""
    away = 180.0 if (situation.asset.gaze == "back") != (kind == "facing_away") else 0.0
    along = UNSERVED if situation.facts.is_in("served_over") else 0.0
    flush = (_dearer(idea, along) for idea in walls.along_walls(situation))
    amid = AMID if situation.facts.is_in("served_over") else 0.0
    free = (_dearer(idea, amid) for idea in open_floor.grid(situation))
    for idea in (*flush, *walls.off_walls(situation), *free):
        x, y, _ = idea.position
        turns = [
            turn_between(idea.yaw + away, math.degrees(math.atan2(m.centre[1] - y, m.centre[0] - x))) for m in marks
        ]
        yield _dearer(idea, TURNED_AWAY if min(turns, default=0.0) > FACING else 0.0)


def _near_openings(situation: Situation, kind: str) -> Iterator[Idea]:
    """Along the walls, the nearer to such an opening the better."""
    room = situation.room
    centres = [room.walls[o.wall].point(o.offset + o.width / 2) for o in room.openings if o.kind == kind]
    before = [room.walls[o.wall] for o in room.openings if o.kind == kind == "window"]
    walled = situation.facts.is_in("walled")
    off = () if walled else walls.clear_of_windows(situation, before)
    served = situation.facts.is_in("served_over")
    flush = (_dearer(idea, UNSERVED if served else 0.0) for idea in walls.along_walls(situation))
    behind = walls.BEHIND if served else max(_seats_behind(situation), _room_behind(situation))
    candidates = [*flush, *walls.corners(situation), *off, *(walls.off_walls(situation, behind) if behind else ())]
    candidates += walls.end_on_beside(situation, kind) if served else ()
    if situation.target.count > 1 and max(situation.size) < LIES_ABOUT:
        candidates += [replace(idea, cost=AMID) for idea in open_floor.grid(situation, step=0.2)]
    if kind == "window" and load_habits().tie(situation.target.category, "window") == "facing":
        candidates = [_dearer(idea, TURNED_AWAY) for idea in candidates]
        candidates += [_turned_round(idea) for idea in walls.clear_of_windows(situation, before)]
    for idea in candidates:
        if not centres:
            yield idea
            continue
        x, y, _ = idea.position
        distance = min(((x - cx) ** 2 + (y - cy) ** 2) ** 0.5 for cx, cy in centres)
        yield _dearer(idea, max(0.0, 0.9 * (distance - situation.size[0] / 2 - 0.2)))


def _turned_round(idea: Idea) -> Idea:
    yaw = (idea.yaw + 180.0) % 360.0
    return replace(idea, yaw=yaw, words=(*idea.words[:-1], turned(yaw)), why="it looks out of the window")


def _seats_behind(situation: Situation) -> float:
    """How much floor those need who sit all round what is placed [m]; 0 where nobody does."""
    own = situation.target.id
    round_it = (t for t in situation.followers for tie in t.ties if tie.kind == "around" and own in tie.anchors)
    return max((situation.kind(t).size[0] + SEATED for t in round_it), default=0.0)


def _room_behind(situation: Situation) -> float:
    """How much floor who stands behind what is placed needs [m]; 0 where nobody does."""
    return max((use.depth for use in situation.facts.uses if use.sides == ("back",)), default=0.0)


def _far_from_place(situation: Situation, place: str) -> Iterable[Idea]:
    marks = [(thing.centre, (0.1, 0.1), 0.0, 0.0, 1.0) for thing in things(situation.scene, place)]
    return sides.far_from(Rects.of(marks), list(_BY_MOUNT[situation.asset.mount](situation)))


def _far(situation: Situation, anchor: Placement, tie: Tie) -> Iterable[Idea]:
    marks = Rects.of_placements(situation.placed(tie.anchors) or (anchor,))
    return sides.far_from(marks, list(_BY_MOUNT[situation.asset.mount](situation)))


def _gathers(situation: Situation, anchor: Placement) -> bool:
    """Whether a lounge seat gathers with others around a low table."""
    return is_lounge(situation.target.category) and facts_of(anchor.category).is_in("lounged_at")


def _around(situation: Situation, anchor: Placement, tie: Tie) -> Iterable[Idea]:
    if _gathers(situation, anchor) and tie.count <= len(around.SIDES):
        return open_floor.about_low_table(situation, anchor)
    return around.around(situation, anchor, tie)


def _at_side(situation: Situation, anchor: Placement, side: str) -> Iterator[Idea]:
    if situation.asset.mount == "wall":
        yield from hung.beside(situation, anchor, (side,))
    else:
        yield from beside.sides_of(situation, anchor, (side,))


def _next_to(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    if situation.asset.mount == "wall":
        yield from hung.beside(situation, anchor, ("left", "right"))
    if _gathers(situation, anchor):
        yield from open_floor.about_low_table(situation, anchor)
    sides: tuple[str, ...] = ("left", "right")
    if tie.count > 1:
        sides = (sides[tie.index % 2], sides[1 - tie.index % 2])
    for rank, side in enumerate(sides):
        taken = CROWDED_SIDE if tie.count == 2 and _has_sibling(situation, anchor, side) else 0.0
        for idea in beside.sides_of(situation, anchor, (side,)):
            yield _dearer(idea, taken + (0.3 * rank if tie.count > 1 else 0.0))
    used = situation.scene.asset_of(anchor).front == "one"
    alike = SIDE_BY_SIDE if used and anchor.category == situation.target.category else 0.0
    tall = situation.mount == "floor" and situation.size[2] > EYE_LEVEL
    barred = not tie.asked or (tall and not facts_of(anchor.category).is_in("lain_on"))
    before = (ELSEWHERE * barred + IN_USE) if used else 2.5
    over_it = not tie.asked and situation.scene.asset_of(anchor).gaze == "back"
    behind = (BEHIND_IT if used else 1.5) + (ELSEWHERE if over_it else 0.0)
    for side, dear in (("back", behind), ("front", before)):
        for idea in beside.sides_of(situation, anchor, (side,)):
            yield _dearer(idea, dear + alike)
    for other in situation.alike(anchor.id):
        for idea in beside.sides_of(situation, other, sides):
            yield _dearer(idea, BY_ANOTHER)


def _has_sibling(situation: Situation, anchor: Placement, side: str) -> bool:
    """Whether another of the target's request stands at a side of the anchor."""
    spots = (anchor.to_local((p.position[0], p.position[1])) for p in situation.siblings)
    sign = 1.0 if side == "left" else -1.0
    return any(abs(x) < anchor.size[0] / 2 and 0.0 < sign * y < anchor.size[1] / 2 + 1.0 for x, y in spots)


def _front(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    face = situation.facts.is_in("seating")
    if not tie.asked and (unit := runs.middle_unit(situation, anchor)) != anchor:
        for idea in _front(situation, unit, structs.replace(tie, anchors=(unit.id,), asked=True)):
            yield _dearer(idea, MIDDLE_OF_RUN)
    if face and situation.scene.asset_of(anchor).gaze == "back" and _is_worked_at(situation, anchor):
        yield from _visiting(situation, anchor, tie)
        return
    if facts_of(anchor.category).is_in("boards") and situation.asset.gaze == "back":
        yield from open_floor.presenting(situation, anchor)
    gaps = situation.facts.gaps or (0.6, 0.4, 0.9, 0.2)
    standing = situation.asset.collides and not is_seat(situation.target.category)
    if standing and is_lounge(anchor.category) and max(gaps) < BEFORE_LOUNGE[0]:
        gaps = BEFORE_LOUNGE
    why = f"it belongs before {anchor.id}"
    if situation.facts.is_in("low_tables") and anchor.size[0] > ROUND_CORNER and not tie.asked:
        yield from _within_corner(situation, anchor, gaps, why)
    if face and facts_of(anchor.category).is_in("counters"):
        gaps = AT_COUNTER
    if tie.count > 1:
        yield from beside.before_several(situation, anchor, tie, gaps=gaps, face=face, why=why)
    middle = runs.middle_of_run(situation, anchor)
    face = face or (situation.facts.is_in("stands_free") and situation.facts.is_in("worktops"))
    for idea in beside.before(situation, anchor, gaps=gaps, face=face, why=why, middle=middle):
        yield _dearer(idea, OUT_OF_LINE if tie.count > 1 else 0.0)


def _within_corner(situation: Situation, anchor: Placement, gaps: tuple[float, ...], why: str) -> Iterator[Idea]:
    """Before the seats of a sofa that goes round a corner, beside its longer part, whichever side that is on."""
    for rank, gap in enumerate(gaps):
        for aside in (0.2, -0.2, 0.25, -0.25):
            local = (-anchor.size[0] / 2 + SEAT_DEPTH + gap + situation.size[0] / 2, aside * anchor.size[1])
            words = (Constraint(kind="beside", anchors=(anchor.id,), side="front", values=(gap,)),)
            ignore = (anchor.id,)
            cost = 0.15 * rank - WITHIN_CORNER
            yield beside.beside_at(
                situation, anchor, local, yaw=anchor.yaw, words=words, why=why, cost=cost, ignore=ignore
            )


def _is_worked_at(situation: Situation, desk: Placement) -> bool:
    """Whether somebody has a seat at the desk."""
    return any(
        tie.kind == "at" and desk.id in tie.anchors for t in situation.observation.plan.targets for tie in t.ties
    )


def _visiting(situation: Situation, desk: Placement, tie: Tie) -> Iterator[Idea]:
    """Across the desk from who works at it, side by side."""
    pitch = situation.size[1] + 0.2
    aside = ((tie.index + 0.5) - tie.count / 2) * pitch
    for rank, gap in enumerate((0.35, 0.2, 0.6, 0.9)):
        for shift in (0.0, 0.15, -0.15):
            local = (-(desk.size[0] / 2 + gap + situation.size[0] / 2), aside + shift)
            words = (Constraint(kind="beside", anchors=(desk.id,), side="back", values=(gap,)),)
            yield beside.beside_at(
                situation,
                desk,
                local,
                yaw=desk.yaw,
                words=words,
                why=f"visitors sit across {desk.id}",
                cost=0.2 * rank + abs(shift),
            )


def _behind(situation: Situation, anchor: Placement, tie: Tie) -> Iterable[Idea]:
    if situation.asset.mount == "wall":
        return hung.behind(situation, anchor, index=tie.index, count=tie.count)
    if backs_worker(situation.facts, facts_of(anchor.category)) and _is_worked_at(situation, anchor):
        return _backing(situation, anchor, tie)
    return beside.behind(situation, anchor, index=tie.index, count=tie.count)


def _backing(situation: Situation, desk: Placement, tie: Tie) -> Iterator[Idea]:
    """Behind who works at a desk, side by side, up to the wall there where it is near; else beyond the desk's back."""
    depth, width = situation.size[:2]
    aside = (tie.index - (tie.count - 1) / 2) * (width + SIDE_GAP)
    free = [
        wall.coordinates(desk.position[:2])[1] - desk.size[0] / 2 - depth - WALL_GAP
        for wall in situation.room.walls
        if turn_between(wall.yaw, desk.yaw + 180.0) < 1.0
    ]
    near = [round(gap, 3) for gap in free if SEATED_BEFORE <= gap <= NEAR]
    for rank, gap in enumerate((*near, WORKING, 0.9, 1.1, 1.25)):
        for step, shift in enumerate((0.0, 0.2, -0.2, 0.4, -0.4)):
            local = (desk.size[0] / 2 + gap + depth / 2, aside + shift)
            words = (Constraint(kind="beside", anchors=(desk.id,), side="front", values=(round(gap, 3),)),)
            why = f"it is behind who works at {desk.id}"
            cost = 0.2 * rank + 0.15 * step
            yield beside.beside_at(situation, desk, local, yaw=desk.yaw + 180.0, words=words, why=why, cost=cost)
    for idea in beside.behind(situation, desk, index=tie.index, count=tie.count):
        yield _dearer(idea, BEYOND_DESK)


def _foot(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    gaps = (0.06, 0.12, 0.02, 0.25)
    yield from beside.before(situation, anchor, gaps=gaps, face=False, why=f"it stands at the foot of {anchor.id}")


def _on(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    aligned = _is_looked_from(situation)
    for idea in _carried(situation, anchor, tie):
        yield _dearer(idea, ASKEW if aligned and turn_between(idea.yaw, anchor.yaw) > 1.0 else 0.0)


def _carried(situation: Situation, anchor: Placement, tie: Tie) -> Iterable[Idea]:
    if not situation.scene.asset_of(anchor).collides or situation.mount == "floor":
        return _on_rug(situation, anchor, tie)
    return _on_top(situation, anchor, tie)


def _on_top(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    """On it; where it has nothing to stand on, close beside it, which the report says is not on it."""
    ideas = list(surfaces.on_surfaces(situation, anchor, tie))
    yield from ideas
    if not ideas and not situation.scene.asset_of(anchor).surfaces and anchor.position[2] < 0.1:
        for idea in beside.sides_of(situation, anchor, ("left", "right", "front", "back")):
            yield _dearer(idea, BESIDE_INSTEAD)


def _is_looked_from(situation: Situation) -> bool:
    """Whether something is asked to stand on one side of it: what carries it has been placed with that in mind."""
    brief = situation.observation.plan.brief
    return any(r.kind in _SIDED and situation.target.request in r.anchors and not r.negated for r in brief.relations)


def _inside(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    """Within it, on its bottom or on what lies there; where it has no inside, on or beside it, which is not inside."""
    ideas = list(surfaces.on_surfaces(situation, anchor, tie))
    yield from ideas
    piled = Tie(kind="on", anchors=(anchor.id,))
    for content in situation.inside(anchor) if ideas else ():
        for idea in (*surfaces.on_surfaces(situation, content, piled), *surfaces.on_its_like(situation, content)):
            yield _dearer(replace(idea, why=f"it lies on what is in {anchor.id}"), PILED)
    if not ideas:
        yield from surfaces.on_surfaces(situation, anchor, Tie(kind="on", anchors=(anchor.id,)))
        for idea in beside.sides_of(situation, anchor, ("left", "right", "front")):
            yield _dearer(idea, BESIDE_INSTEAD)


def _in_middle_of(situation: Situation, anchor: Placement, tie: Tie) -> Iterable[Idea]:
    if not situation.scene.asset_of(anchor).collides or situation.mount == "floor":
        return _on_rug(situation, anchor, tie)
    return surfaces.on_surfaces(situation, anchor, tie)


def _amid_room(situation: Situation) -> Iterator[Idea]:
    """On the floor, the nearer to the middle the better, and more so where it is asked to be there."""
    middle = situation.room.polygon.centroid.coords[0]
    asked = any(tie.asked and tie.kind == "in_centre" for tie in situation.target.ties)
    for idea in open_floor.grid(situation, step=0.1):
        yield _dearer(idea, OFF_CENTRE * math.dist(idea.position[:2], middle) if asked else 0.0)


def _outside(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    """On the floor by any of its sides."""
    yield from beside.sides_of(situation, anchor, ("front", "left", "right", "back"), gaps=(0.08, 0.18, 0.3))


def _back_to_back(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    for rank, gap in enumerate((0.03, 0.1, 0.25, 0.4)):
        local = (-(anchor.size[0] / 2 + gap + situation.size[0] / 2), 0.0)
        words = (Constraint(kind="beside", anchors=(anchor.id,), side="back", values=(gap,)),)
        why = f"their backs are to each other, {anchor.id} and this"
        yield beside.beside_at(situation, anchor, local, yaw=anchor.yaw + 180.0, words=words, why=why, cost=0.1 * rank)


def _on_rug(situation: Situation, rug: Placement, tie: Tie) -> Iterator[Idea]:
    why = f"it stands on {rug.id}"
    for idea in beside.between(situation, (rug,)):
        yield replace(idea, words=idea.words[1:], why=why, ignore=(rug.id,))
    for share_x, share_y in product((-0.3, -0.15, 0.0, 0.15, 0.3), repeat=2):
        local = (share_x * rug.size[0], share_y * rug.size[1])
        cost = OFF_MIDDLE + math.hypot(*local)
        for turn in (0.0, 90.0):
            yield beside.beside_at(
                situation, rug, local, yaw=rug.yaw + turn, words=(), why=why, cost=cost, ignore=(rug.id,)
            )


def _under(situation: Situation, anchor: Placement, tie: Tie) -> Iterable[Idea]:
    if not situation.asset.collides:
        every = [a for t in situation.target.ties if t.kind == tie.kind for a in situation.placed(t.anchors)]
        return (*rugs.under_all(situation, anchor, every), *rugs.under(situation, anchor))
    if situation.scene.asset_of(anchor).mount == "wall":
        return beneath.under_hung(situation, anchor)
    return beneath.under_standing(situation, anchor, tie)


def _above(situation: Situation, anchor: Placement, tie: Tie) -> Iterable[Idea]:
    return hung.above(situation, situation.placed(tie.anchors) or (anchor,), index=tie.index, count=tie.count)


def _facing(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    if situation.asset.mount == "wall":
        yield from hung.opposite(situation, anchor)
        return
    if tie.count > 1 and anchor.id not in {t.id for t in _company(situation)}:
        yield from open_floor.side_by_side(situation, anchor, tie)
    for idea in open_floor.looking_at(situation, anchor):
        yield _dearer(idea, AMID_INSTEAD if situation.facts.is_in("beds") else 0.0)
    yield from walls.opposite(situation, anchor)


def _company(situation: Situation) -> list[Target]:
    """The members of the target's own request."""
    return [t for t in situation.observation.plan.targets if t.request == situation.target.request]


def _opposite(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    if situation.asset.mount == "wall":
        yield from hung.opposite(situation, anchor)
        return
    pair = situation.placed(tie.anchors)
    mutual = len(pair) > 1 and walls.look_at_each_other(pair[0], pair[1])
    if mutual:
        yield from walls.beside_pair(situation, pair[0], pair[1])
    for idea in walls.opposite(situation, anchor):
        yield _dearer(idea, BACK_TO_VIEW if mutual else 0.0)


def _near(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    presents = facts_of(anchor.category).is_in("boards") and situation.asset.gaze == "back"
    if presents:
        yield from open_floor.presenting(situation, anchor)
    if _gathers(situation, anchor):
        yield from open_floor.about_low_table(situation, anchor)
    along, apart = (2.0, GATHERED) if _gathers(situation, anchor) else (0.2, 0.0)
    for idea in beside.sides_of(situation, anchor, ("left", "right", "front", "back")):
        yield _dearer(idea, along)
    for idea in (*walls.along_walls(situation), *walls.corners(situation)):
        turned_away = BACK_TO_CLASS if presents else 0.0
        yield _dearer(idea, turned_away + apart * math.dist(idea.position[:2], anchor.position[:2]))


_WITHOUT_ANCHOR: dict[str, Callable[[Situation], Iterable[Idea]]] = {
    "against_wall": lambda s: hung.on_walls(s) if s.asset.mount == "wall" else walls.in_line(s),
    "in_corner": walls.corners,
    "facing": open_floor.grid,
    "back_to_back": open_floor.grid,
    "in_centre": lambda s: hung.from_ceiling(s) if s.asset.mount == "ceiling" else _amid_room(s),
}
_BY_MOUNT: dict[Mount, Callable[[Situation], Iterable[Idea]]] = {
    "floor": anywhere,
    "wall": hung.on_walls,
    "ceiling": hung.from_ceiling,
    "surface": _any_surface,
}
_BY_ANCHOR: dict[str, Callable[[Situation, Placement, Tie], Iterable[Idea]]] = {
    "on": _on,
    "inside": _inside,
    "in_centre": _in_middle_of,
    "outside": _outside,
    "back_to_back": _back_to_back,
    "far": _far,
    "at_long_side": lambda s, a, t: sides.at_sides(s, a, t, sides.long_sides(a)),
    "at_short_side": lambda s, a, t: sides.at_sides(s, a, t, sides.short_sides(a)),
    "under": _under,
    "above": _above,
    "next_to": _next_to,
    "left_of": lambda s, a, t: _at_side(s, a, "left"),
    "right_of": lambda s, a, t: _at_side(s, a, "right"),
    "in_front_of": _front,
    "behind": _behind,
    "at_foot_of": _foot,
    "at": around.at_desk,
    "around": _around,
    "facing": _facing,
    "facing_away": lambda s, a, t: _turned_to(s, things(s.scene, a.id), t.kind),
    "opposite": _opposite,
    "near": _near,
}
