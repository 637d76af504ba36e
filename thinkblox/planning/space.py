"""How much floor a brief needs, from the footprints of what it asks for and the room to use them."""

from functools import lru_cache

import numpy as np

from thinkblox.assets import facts_of, kind_of, revision
from thinkblox.assets.sizing import size_for
from thinkblox.brief import Brief, Request
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import MAX_SIDE, room_type
from thinkblox.planning.asked import rows_for
from thinkblox.planning.sizes import width_for_seats
from thinkblox.planning.walls import COMPASS, SIDES
from thinkblox.scene.pairs import ACROSS
from thinkblox.value import Vec2, Vec3

_DOOR_AREA = 1.6
"""Free floor that a door and the way in take [m2]."""
_WALL_SHARE = 0.6
"""Share of the walls that furniture can stand against; the rest is door, window and corners."""
_WAYS = 1.3
"""Floor for the ways between the pieces, as a factor on what the pieces and their use take."""
_RANKS = 6
"""So many desks in rows have their ways between them."""
_TYPICAL_SHARE = 0.6
"""A room is not made smaller than this share of its type's usual floor."""
_EMPTY_AREA = 10.0
ROUND_TABLES = ("around", "at_long_side", "at_short_side")
"""Relations of seats to the table that they stand about."""
_ON = ("at", "on", "inside")
_SAT_AT = ("at", *ROUND_TABLES)
_ACROSS = 1.9
"""Free floor between things opposite each other, and behind them [m]."""
BEHIND_SEAT, TUCK = 0.35, 0.1
"""Free floor behind a seat at a table, and how far it goes under it [m]."""
_SIT = 0.8
"""Free depth behind a desk for who sits at it [m]."""
_FAR = 4.4
"""Free floor between things that are far from each other [m]."""
_BOARD = 1.8
"""Free depth before a board [m]."""
_BETWEEN_MATS = 0.5
"""Free floor between mats in rows [m]."""
_IN_RUN = 0.03
"""Free width between neighbours in a run [m]."""
_GROWN = 0.4
"""By how much a run may come out longer, for what stands on its worktops [m]."""
_LONG_RUN = 5.0
"""What is longer goes round a corner [m]."""
_LONG_ROW = 9.0
"""What is longer goes along two walls [m]."""
_BEFORE_RUN, _BEHIND_ISLAND = 1.1, 1.0
"""Free floor between a run and an island before it, and behind that [m]."""
_BESIDE, _IN_CORNER = 0.15, 0.9
"""Free width beside a piece along a wall, and beside one in a corner with its seats [m]."""
_WIDE, _DOORWAY = 1.0, 1.2
"""So wide are things of which one hangs beside the other, and what a door takes of a wall on which they do [m]."""


def needed_area(brief: Brief) -> float:
    """Floor that the brief's furniture takes with the space to use it, and not much less than is usual [m2]."""
    if brief.empty:
        return max(_EMPTY_AREA, furniture_area(brief))
    return max(furniture_area(brief), least_area(brief), _walls_area(brief))


def least_area(brief: Brief) -> float:
    """Floor that a room of its type has at least, whatever stands in it [m2]."""
    return _TYPICAL_SHARE * room_type(brief.room_type).area


def furniture_area(brief: Brief) -> float:
    """Floor that the furniture of a brief takes with the space to use it, and the ways between [m2]."""
    areas = (r.count * _own_area(brief, r) * (1.0 if _is_whole(brief, r) else _WAYS) for r in brief.requests)
    return _DOOR_AREA + sum(areas) + _before_board(brief)


def _is_whole(brief: Brief, request: Request) -> bool:
    """Whether the ways are counted with each: one goes along a run where one works at it."""
    return _in_ranks(brief, request) or facts_of(request.category).is_in("built_in_line")


def _in_ranks(brief: Brief, request: Request) -> bool:
    """Whether it is a desk of several that stand in rows: the ways between these are counted with each."""
    rows = any(r.kind == "in_rows" and r.subject == request.key for r in brief.relations)
    return rows and request.count >= _RANKS and load_habits().is_in(request.category, "lined_up")


def _before_board(brief: Brief) -> float:
    """Floor between a board and the first of the rows that look at it, with who teaches in between [m2]."""
    boards = {r.key for r in brief.requests if load_habits().is_in(r.category, "boards", "attended")}
    looking = {r.subject for r in brief.relations if r.kind in ("facing", "opposite")}
    looking |= {r.key for r in brief.requests if boards and load_habits().is_in(r.category, "lined_up", "seating")}
    rows = [r for r in brief.relations if r.kind == "in_rows" and r.subject in looking]
    requests = [(brief.request(r.subject), r.rows) for r in rows]
    desks = [r.subject for r in brief.relations if r.kind in ("in_front_of", "near") and boards & set(r.anchors)]
    depth = _BOARD + max(
        (extent(brief.request(key))[0] + _SIT for key in desks if _stands(brief.request(key))), default=0
    )
    return sum(depth * (extent(q)[1] + 0.6) * q.count / (n or rows_for(q.category, q.count)) for q, n in requests)


def _walls_area(brief: Brief) -> float:
    """Floor whose walls are long enough for what stands against them, at a proportion of 4:5 [m2]."""
    widths = sum(r.count * extent(r)[1] for r in brief.requests if _is_against_wall(brief, r))
    perimeter = widths / _WALL_SHARE
    return (perimeter / 4.0) ** 2


def wall_needs(brief: Brief) -> Vec2:
    """Least sides of a room along x and y, for what the prompt puts against or hangs on a wall that it names [m]."""
    needs, hung = dict.fromkeys((*COMPASS, *SIDES), 0.0), dict.fromkeys((*COMPASS, *SIDES), 0.0)
    requests = {request.key: request for request in brief.requests}
    for relation in brief.relations:
        for wall in relation.anchors:
            if wall in needs and relation.kind in ("against_wall", "in_corner"):
                request = requests[relation.subject]
                gap = _BESIDE if relation.kind == "against_wall" else _IN_CORNER
                needs[wall] += request.count * (extent(request)[1] + gap) if _stands(request) else 0.0
            elif wall in hung and relation.kind == "on" and not relation.negated:
                width = extent(requests[relation.subject])[1]
                hung[wall] += requests[relation.subject].count * (width + _BESIDE) if width >= _WIDE else 0.0
    needs = {wall: max(needs[wall], hung[wall] + _DOORWAY if hung[wall] else 0.0) for wall in needs}
    along = [max(needs[a], needs[b]) for a, b in (("north_wall", "south_wall"), ("east_wall", "west_wall"))]
    seen = [max(needs[a], needs[b]) for a, b in (("far_wall", "near_wall"), ("left_wall", "right_wall"))]
    x, y = (round(min(MAX_SIDE, max(pair)), 1) for pair in zip(along, seen, strict=True))
    return x, y


def across_need(brief: Brief) -> float:
    """Least longer side of a room with things opposite each other, far apart, or with a third between, as asked [m].

    What is built in one line has a wall that it fits along.
    """
    requests = {request.key: request for request in brief.requests}
    asked = [r for r in brief.relations if r.asked and r.anchors and r.subject in requests]
    needs = [0.0]
    for relation in asked:
        pair = [requests[key] for key in (relation.subject, relation.anchors[0]) if key in requests]
        if relation.kind == "opposite":
            needs.append(sum(extent(each)[0] for each in pair) + _ACROSS)
        elif relation.kind == "far":
            needs.append(sum(min(extent(each)[:2]) for each in pair if _stands(each)) + _FAR)
        elif relation.kind == "between" and _stands(requests[relation.subject]):
            beside = [requests[key] for key in relation.anchors if key in requests]
            twice = beside * 2 if len(beside) == 1 else beside
            needs.append(
                sum(extent(each)[1] + _BESIDE for each in (requests[relation.subject], *twice) if _stands(each))
            )
    needs += [length for length in map(_row_length, rows_along_walls(brief)) if length <= _LONG_ROW]
    if run := run_length(brief):
        needs.append(min(run + _GROWN, _LONG_RUN))
    return round(min(MAX_SIDE, max(needs)), 1)


def across_limit(brief: Brief) -> float:
    """Most that the shorter side of a room may be for what is asked to be across it, at a wall each [m]."""
    requests = {request.key: request for request in brief.requests}
    most = MAX_SIDE
    for relation in (r for r in brief.relations if r.asked and r.kind == "opposite" and r.anchors):
        pair = [requests[key] for key in (relation.subject, relation.anchors[0]) if key in requests]
        if len(pair) == 2 and all(kind_of(r.category).mount == "wall" or _is_against_wall(brief, r) for r in pair):
            most = min(most, sum(extent(each)[0] for each in pair) + ACROSS[1] - _BESIDE)
    return round(most, 1)


def rows_along_walls(brief: Brief) -> list[Request]:
    """What stands in one row along a wall."""
    walled = {r.subject for r in brief.relations if r.kind == "against_wall" and not r.negated}
    return [
        brief.request(r.subject) for r in brief.relations if r.kind == "in_rows" and r.rows == 1 and r.subject in walled
    ]


def _row_length(request: Request) -> float:
    return request.count * (extent(request)[1] + _BESIDE) + _GROWN


def depth_need(brief: Brief) -> float:
    """Least shorter side of a room in which something to work at stands before what is built in one line [m]."""
    run = [r for r in brief.requests if facts_of(r.category).is_in("built_in_line") and _stands(r)]
    amid = [r for r in brief.requests if facts_of(r.category).is_in("stands_free") and _is_worktop(r)]
    if not run or not amid:
        return 0.0
    before = max(extent(r)[0] for r in run) + _BEFORE_RUN
    return round(before + max(extent(r)[0] for r in amid) + _BEHIND_ISLAND, 1)


def _is_worktop(request: Request) -> bool:
    return facts_of(request.category).is_in("worktops") and _stands(request)


def run_length(brief: Brief) -> float:
    """How long the longest of the runs is that are built in one line [m]; 0 where there is none."""
    lengths: dict[str, float] = {}
    for request in brief.requests:
        facts = facts_of(request.category)
        if facts.is_in("built_in_line") and _stands(request):
            own = request.count * (extent(request)[1] + _IN_RUN)
            lengths[facts.run] = lengths.get(facts.run, 0.0) + own
    return max(lengths.values(), default=0.0)


def _stands(request: Request) -> bool:
    kind = kind_of(request.category)
    return kind.mount == "floor" and not kind.flat


def _own_area(brief: Brief, request: Request) -> float:
    mats = kind_of(request.category).flat and _in_rows(request)
    if not (mats or _stands(request)) or _belongs_to_seating(brief, request):
        return 0.0
    depth, across, _ = extent(request)
    if mats:
        return (across + _BETWEEN_MATS) * (depth + _BETWEEN_MATS)
    across = max(across, _seated_width(brief, request))
    beside, before = _margins(brief, request)
    return (across + beside) * (depth + max(before, kind_of(request.category).clearance))


def _in_rows(request: Request) -> bool:
    """Whether such things lie in rows: mats, on each of which somebody has a place."""
    return any(habit.kind == "in_rows" for habit in load_habits().of(request.category))


def _seated_width(brief: Brief, request: Request) -> float:
    """Width of what several sit at [m]; 0 where it is not more than usual."""
    sat = [r for r in brief.relations if request.key in r.anchors and len(r.anchors) == 1]
    seats = {
        kind: sum(brief.request(r.subject).count for r in sat if r.kind == kind) // request.count
        for kind in ("at", "in_front_of", "at_long_side")
    }
    before = seats["at"] + seats["in_front_of"]
    words = frozenset(request.attributes)
    kind = kind_of(request.category)
    return width_for_seats(kind, words, before=before, along=seats["at_long_side"]) or 0.0


def _margins(brief: Brief, request: Request) -> tuple[float, float]:
    """Free width beside and free depth before a piece [m]."""
    habits = load_habits()
    name = request.category
    if habits.is_in(name, "built_in_line"):
        return _IN_RUN, 0.9
    drawn_up = [r for r in brief.relations if r.kind in ROUND_TABLES and request.key in r.anchors]
    seats = [brief.request(r.subject) for r in drawn_up] or _seats_for(brief, request)
    about = 2.0 * (max((extent(seat)[0] for seat in seats if _stands(seat)), default=0.0) + BEHIND_SEAT - TUCK)
    if habits.is_in(name, "served_over"):
        return 0.6, 2.1
    if habits.is_in(name, "played_around"):
        return 2.2, 2.2
    if habits.is_in(name, "lined_up") or any(r.kind == "in_rows" and r.subject == request.key for r in brief.relations):
        return max(0.6, about), max(1.0, about)
    if any(r.kind in ROUND_TABLES[1:] for r in drawn_up):
        return max(1.9, about), max(1.9, about)
    if seats:
        return about, about
    if habits.is_in(name, "beds"):
        return 0.9, 0.7
    if habits.is_in(name, "desks"):
        return 0.2, 1.1
    if habits.is_in(name, "sat_before"):
        return 0.4, 1.2
    return 0.25, 0.5


def _seats_for(brief: Brief, table: Request) -> list[Request]:
    """The chairs of a prompt that says of neither these nor the table where they are: they will stand around it."""
    told = {r.subject for r in brief.relations} | {a for r in brief.relations if r.kind in _SAT_AT for a in r.anchors}
    habits = load_habits()
    if table.key in told or not habits.is_in(table.category, "meal_tables"):
        return []
    return [r for r in brief.requests if r.asked and r.key not in told and habits.is_in(r.category, "chairs")]


def _belongs_to_seating(brief: Brief, request: Request) -> bool:
    """Seats drawn up to a table stand on floor that was counted with the table."""
    if any(request in _seats_for(brief, table) for table in brief.requests):
        return True
    return any(r.subject == request.key and r.kind in (*ROUND_TABLES, *_ON) for r in brief.relations)


def _is_against_wall(brief: Brief, request: Request) -> bool:
    if not _stands(request):
        return False
    own = [r for r in brief.relations if r.subject == request.key]
    if own:
        return any(r.kind == "against_wall" for r in own)
    first = next(iter(load_habits().of(request.category)), None)
    return first is not None and first.kind == "against_wall"


def extent(request: Request) -> Vec3:
    """Size of what is requested, as asked or usual (along the front axis, across, up) [m]."""
    x, y, z = _usual_size(request.category, request.attributes, revision())
    depth, width, height = (size or own for size, own in zip(request.size, request.drawn, strict=True))
    return (depth or x, width or y, height or z)


@lru_cache(maxsize=256)
def _usual_size(category: str, attributes: tuple[str, ...], revision: int) -> Vec3:
    return size_for(kind_of(category), frozenset(attributes), np.random.default_rng(0))
