"""Ties that nobody has to mention: a nightstand stands by the bed, a lamp on the nightstand."""

from collections.abc import Collection

from msgspec.structs import replace

from thinkblox.assets import facts_of
from thinkblox.knowledge.habits import Habit, load_habits
from thinkblox.knowledge.rooms import room_type
from thinkblox.plan import Tie, carries
from thinkblox.planning.asked import rows_for, share
from thinkblox.planning.members import Member, Members

_PLACES = ("wall", "long_wall", "short_wall", "corner", "window", "door", "centre")
_WITHOUT_PLACE = ("facing", "facing_away", "opposite")
"""Relations that say where a thing looks, not where it stands."""
_EXCLUSIVE = ("at", "above", "under", "in_front_of", "at_foot_of", "opposite", "in_centre", "in_corner")
"""Relations whose space is taken by whatever came first."""
_CAPACITY = {"at": 1, "above": 1, "under": 1, "in_front_of": 1, "at_foot_of": 1, "opposite": 1, "in_centre": 1}
_CAPACITY |= {"next_to": 2, "in_corner": 4, "around": 12, "near": 4}
_UNLIMITED = 1000
_VISITORS = 3
"""So many are received at once across a desk."""
_MANY_DESKS, _MANY_SEATS, _MANY_ISLANDS = 4, 12, 2
"""From so many on desks, chairs at no table, and islands stand amid the room rather than along the walls."""
_WAITING = 4
"""From so many on chairs at no table are those of people who wait."""
_MOST_ABREAST = 6
"""More of them do not wait in a single row."""
_MANY_BENCHES = 4
"""From so many on benches at which people sit stand in rows."""
_LINE, _BED_LINE = 2, 2
"""From so many on alike things stand in line, and beds."""
_ALL_ROUND = ("behind", "around", "back_to_back", "at_long_side")
"""Relations of things that stand where an anchor with its back to a wall leaves no room."""
_BESIDE = ("left_of", "right_of", "between")
"""Relations of things that stand where an anchor in a corner may leave no room."""
_CLOSE = ("next_to", "left_of", "right_of")
_BY_RUG = ("in_front_of", "at_foot_of")
"""Relations by which a rug lies where people gather."""
_APART = ("seating", "lounges", "plants", "lamps", "in_corners", "stands_free", "visits", "attended", "beds")
"""Groups of things of which several do not stand side by side at a wall, or do so by other rules."""


def imply(members: Members, windows: bool, free: Collection[str] = ()) -> None:
    """Complete the ties of every object that has none that says where it stands; nobody is sent to a `free` part."""
    _stand_where_rugs_lie(members)
    for request in members.by_request.values():
        for member in request:
            _stay_on_floor(members, member)
        _leave_walls(request)
        _stand_before_own(members, request)
        waiting = [member for member in request if _needs_place(member)]
        if waiting and all(member.mount == "surface" for member in waiting):
            waiting = [member for member in waiting if not _join_neighbour(members, member)]
        whole = len(waiting) == len(request)
        if whole:
            waiting = _together(members, waiting)
        for habit in _habits_of(members, request[0]):
            if habit.kind == "against_wall" and len(waiting) >= _crowd(members, request[0]):
                waiting = _in_rows(waiting)
            if habit.kind == "against_wall" and len(waiting) >= _WAITING and _is_chair(request[0]):
                waiting = _side_by_side(waiting)
            if waiting and not _is_forbidden(waiting[0], habit, free) and not _hems_in(members, waiting[0], habit):
                waiting = _follow(members, waiting, habit, windows=windows)
        _look_ahead(members, request)
        _number(request)


def _stand_where_rugs_lie(members: Members) -> None:
    """What is asked to be on a rug that lies before a sofa stands before the sofa itself, where nobody says more.

    So does in the middle what is on a rug that lies there; several on a rug of which no more is told keep together.
    """
    for rug in [member for member in members.all if member.flat]:
        before = [tie for tie in rug.ties if tie.asked and tie.kind in _BY_RUG and len(tie.anchors) == 1]
        on = [members.by_id.get(a) for tie in rug.ties if tie.asked and tie.kind == "under" for a in tie.anchors]
        amid = [tie for tie in rug.ties if tie.asked and tie.kind == "in_centre" and tie.anchors == ("centre",)]
        free = [member for member in on if member is not None and member.mount == "floor" and not member.ties]
        if free[1:] and not before:
            in_corner = any(tie.kind == "in_corner" for tie in rug.ties)
            free[0].ties += [Tie(kind="in_corner", anchors=("corner",), asked=False)] if in_corner else []
            for other in free[1:]:
                other.ties.append(Tie(kind="next_to", anchors=(free[0].id,), asked=False))
        for member in on:
            if member is not None and amid and member.mount == "floor" and not member.ties:
                member.ties.append(Tie(kind="in_centre", anchors=("centre",), asked=False))
            if member is not None and before and member.mount == "floor" and not member.ties:
                anchor = members.by_id.get(before[0].anchors[0])
                if anchor is not None and not members.depends(anchor, member):
                    member.ties.append(Tie(kind=before[0].kind, anchors=before[0].anchors, asked=False))


def _stand_before_own(members: Members, request: list[Member]) -> None:
    """A row of seats stands before what each of them usually looks into, where one for each hangs on a wall."""
    if {tie.kind for member in request for tie in member.ties} != {"in_rows"}:
        return
    habits = load_habits().of(request[0].category)
    looked_into = [a for habit in habits if habit.kind == "in_front_of" and not habit.company for a in habit.anchors]
    for category in looked_into:
        own = [m for m in members.of_category(category) if m.mount == "wall" and m not in request]
        if len(own) == len(request) and not any(members.depends(a, m) for a in own for m in request):
            for member, anchor in zip(request, own, strict=True):
                below = (m for m in members.all if m.mount == "floor" and not members.depends(m, member))
                under = (m for m in below if any(t.kind == "under" and anchor.id in t.anchors for t in m.ties))
                member.ties.insert(0, Tie(kind="in_front_of", anchors=(next(under, anchor).id,), asked=False))
                member.ties.append(Tie(kind="facing", anchors=(anchor.id,), asked=False))
            return


def _together(members: Members, waiting: list[Member]) -> list[Member]:
    """Put all of a request into rows, where such things stand so; returns those that still wait for a place."""
    if len(waiting) > 1 and _is_sat_about(members, waiting[0]):
        return _in_rows(waiting)
    if _is_lined_up(waiting):
        return _in_rows(waiting)
    if _is_set(waiting) and not any(member.ties for member in waiting) and len(waiting) < _crowd(members, waiting[0]):
        return _side_by_side(waiting)
    return waiting


def _habits_of(members: Members, member: Member) -> tuple[Habit, ...]:
    """Its habits; chairs that are asked for are for the tables that are, before those that are only assumed."""
    habits = (*_usual_carriers(members, member), *load_habits().of(member.category))
    if not member.request.asked or not load_habits().is_in(member.category, "chairs"):
        return habits
    tables = {m.category for m in members.all if m.request.asked}
    named = tuple(h for h in habits if h.kind in ("at", "around") and not tables.isdisjoint(h.anchors))
    return (*named, *(habit for habit in habits if habit not in named))


def _usual_carriers(members: Members, member: Member) -> tuple[Habit, ...]:
    """What such a thing stands on in that type of room: a microscope on the benches of a laboratory."""
    ties = [
        tie for usual in room_type(members.room).usual if usual.category == member.category for tie in usual.relations
    ]
    return tuple(Habit("on", tuple(anchors.split("|"))) for kind, anchors, _ in ties if kind == "on")


def _leave_walls(request: list[Member]) -> None:
    """Several that stand in line, or side by side, need not each be told to stand against a wall."""
    lined = load_habits().is_in(request[0].category, "in_line", "beds")
    if len(request) >= _BED_LINE and (lined or (_is_set(request) and not facts_of(request[0].category).is_in("desks"))):
        for member in request:
            if all(not tie.asked and (tie.kind, tie.anchors) == ("against_wall", ("wall",)) for tie in member.ties):
                member.ties.clear()


def _is_lined_up(waiting: list[Member]) -> bool:
    """Whether they are what stands in line, and enough."""
    habits, first = load_habits(), next(iter(waiting), None)
    if first is None or not habits.is_in(first.category, "in_line"):
        return False
    return len(waiting) >= (_BED_LINE if habits.is_in(first.category, "beds") else _LINE)


def _is_chair(member: Member) -> bool:
    return load_habits().is_in(member.category, "chairs")


def _before_waiting(habit: Habit, anchors: list[Member]) -> tuple[Habit, list[Member]]:
    """What usually is between two seats is before the middle of a row of those who wait."""
    walled = [m for m in anchors if any(tie.kind == "against_wall" for tie in m.ties)]
    if habit.kind != "between" or len(walled) < _WAITING:
        return habit, anchors
    return Habit("in_front_of", habit.anchors), walled[len(walled) // 2 :][:1]


def _is_set(waiting: list[Member]) -> bool:
    """Whether they are alike things that belong to a wall, and so beside each other; not those that have runs."""
    if len(waiting) < _LINE or waiting[0].mount != "floor" or waiting[0].flat:
        return False
    facts = facts_of(waiting[0].category)
    habits = [habit for habit in facts.habits if " if " not in habit]
    return habits[:1] == ["against_wall wall"] and not facts.run and not facts.is_in(*_APART, "in_line")


def _side_by_side(waiting: list[Member]) -> list[Member]:
    """In one row at a wall, or in two where those who wait are many, or else at the walls."""
    rows = 2 if _is_chair(waiting[0]) and len(waiting) > _MOST_ABREAST else 1
    for index, member in enumerate(waiting):
        member.ties.append(Tie(kind="in_rows", index=index, count=len(waiting), rows=rows, asked=False))
        member.ties.append(Tie(kind="against_wall", anchors=("wall",), asked=False))
    return []


def _crowd(members: Members, first: Member) -> int:
    """From how many on alike things stand in rows rather than along the walls."""
    habits, category = load_habits(), first.category
    if habits.is_in(category, "islands"):
        return _MANY_ISLANDS
    seated = any(tie.kind == "at" and first.id in tie.anchors for other in members.all for tie in other.ties)
    if habits.is_in(category, "long_sides") and facts_of(category).gaze == "back" and seated:
        return _MANY_BENCHES
    if habits.is_in(category, "in_blocks"):
        return _MANY_DESKS
    return _MANY_SEATS if habits.is_in(category, "chairs") else _UNLIMITED


def _look_ahead(members: Members, request: list[Member]) -> None:
    """Rows of seats or of desks look at the board, or at what they attend to, where nobody says at what."""
    habits, first = load_habits(), request[0]
    rows = [tie for member in request for tie in member.ties if tie.kind == "in_rows"]
    in_rows = len(rows) >= len(request)
    kinds = ("lined_up", "seating", "long_sides", *(("in_blocks",) if any(tie.asked for tie in rows) else ()))
    looking = any(tie.kind in _WITHOUT_PLACE for tie in first.ties)
    if not in_rows or looking or not habits.is_in(first.category, *kinds):
        return
    for category in (*habits.group("boards"), *habits.group("attended")):
        boards = (m for m in members.of_category(category) if not any(members.depends(m, w) for w in request))
        board = next(boards, None)
        if board is not None and not any(board.id in tie.anchors for tie in first.denied):
            for index, member in enumerate(request):
                tie = Tie(kind="facing", anchors=(board.id,), index=index, count=len(request), asked=False)
                member.ties.append(tie)
            return


def _is_sat_about(members: Members, table: Member) -> bool:
    """Whether people sit all around it: several such tables stand in rows with ways between them."""
    about = ("around", "at_long_side")
    return any(tie.kind in about and table.id in tie.anchors for other in members.all for tie in other.ties)


def _is_forbidden(member: Member, habit: Habit, free: Collection[str]) -> bool:
    """Whether the habit is what must not be, or leads to where nothing is to stand."""
    places = set(habit.anchors) or {"wall" if habit.kind == "against_wall" else habit.kind.removeprefix("in_")}
    denied = any(tie.kind == habit.kind and (not tie.anchors or places & set(tie.anchors)) for tie in member.denied)
    off_walls = any(tie.kind == "against_wall" and "wall" in tie.anchors for tie in member.denied)
    denied |= habit.kind == "in_corner" and off_walls
    return denied or ("centre" in free and "centre" in places)


def _hems_in(members: Members, member: Member, habit: Habit) -> bool:
    """Whether the habit leads to where there is no room at a side at which others are asked to stand."""
    place = habit.anchors[0] if habit.anchors else ""
    walled = habit.kind == "in_corner" or place == "corner"
    backed = walled or habit.kind == "against_wall" or place in ("wall", "long_wall", "short_wall")
    sides: tuple[str, ...] = _ALL_ROUND if backed else ()
    sides = (*sides, *_BESIDE) if walled else sides
    sides = ("in_front_of",) if habit.kind == "above" else sides
    floor = (other for other in members.all if other.mount in ("floor", "surface") and not other.flat)
    return any(tie.asked and tie.kind in sides and member.id in tie.anchors for other in floor for tie in other.ties)


def _stay_on_floor(members: Members, member: Member) -> None:
    """Small things that may stand on the floor do so beside furniture, in a corner or by a window."""
    outside = any(tie.kind == "outside" for tie in member.ties) or _is_beyond_reach(members, member)
    floor = outside or any(habit.kind != "on" for habit in load_habits().of(member.category))
    if member.mount != "surface" or not floor or any(tie.kind == "on" or carries(tie) for tie in member.ties):
        return
    anchors = [members.by_id.get(anchor) for tie in member.ties if tie.asked for anchor in tie.anchors]
    if outside or (anchors and all(anchor is None or anchor.mount == "floor" for anchor in anchors)):
        member.ties.append(Tie(kind="on", anchors=("floor",), asked=False))


def _is_beyond_reach(members: Members, member: Member) -> bool:
    """Whether it is asked to be close by what stands on the floor, and nothing that usually stands there carries it."""
    close = [tie for tie in member.ties if tie.asked and tie.kind in _CLOSE]
    anchors = [members.by_id.get(anchor) for tie in close for anchor in tie.anchors]
    if not anchors or any(anchor is None or anchor.mount != "floor" for anchor in anchors):
        return False
    names = {name for habit in load_habits().of(member.category) if habit.kind == "on" for name in habit.anchors}
    carriers = [other for other in members.all if other.category in names and other not in anchors]
    return not any(anchor and _are_close(anchor, other) for anchor in anchors for other in carriers)


def _are_close(one: Member, other: Member) -> bool:
    """Whether two things stand beside each other, as asked or usually."""
    asked = any(b.id in tie.anchors and tie.kind in _CLOSE for a, b in ((one, other), (other, one)) for tie in a.ties)
    habits = load_habits()
    kinds = {habits.tie(one.category, other.category), habits.tie(other.category, one.category)}
    return asked or not kinds.isdisjoint((*_CLOSE, "in_front_of", "near"))


def _needs_place(member: Member) -> bool:
    if load_habits().is_in(member.category, "watched") and all(tie.anchors == ("wall",) for tie in member.ties):
        return True
    if member.mount == "surface":
        return not any(tie.kind == "on" or carries(tie) for tie in member.ties)
    return all(tie.kind in _WITHOUT_PLACE and not _is_of_pair(member, tie) for tie in member.ties)


def _is_of_pair(member: Member, tie: Tie) -> bool:
    """Whether it looks at one of its like, and so stands where the two can talk."""
    kind = member.category
    alike = any(anchor.rsplit("_", 1)[0] == kind for anchor in tie.anchors)
    return tie.asked and alike and load_habits().is_in(kind, "seating")


def _join_neighbour(members: Members, member: Member) -> bool:
    """A cup next to a laptop stands on the laptop's desk."""
    for anchor in (members.by_id.get(a) for tie in member.ties for a in tie.anchors):
        support = members.support(anchor) if anchor else None
        if support is not None and not members.depends(support, member):
            member.ties.insert(0, Tie(kind="on", anchors=(support.id,), asked=False))
            return True
    return False


def _follow(members: Members, waiting: list[Member], habit: Habit, *, windows: bool) -> list[Member]:
    """Tie as many as the habit has room for; returns the others."""
    if waiting[0].mount == "surface" and habit.kind != "on" and waiting[0].ties:
        return waiting
    if habit.kind in _WITHOUT_PLACE and any(tie.kind == habit.kind for tie in waiting[0].ties):
        return waiting
    if not _applies(members, waiting, habit):
        return waiting
    if not habit.anchors:
        return _in_rows(waiting) if habit.kind == "in_rows" else waiting
    if habit.anchors[0] in _PLACES:
        return _at_place(members, waiting, habit, windows=windows)
    for category in habit.anchors:
        anchors = [m for m in members.of_category(category) if not any(members.depends(m, w) for w in waiting)]
        anchors = [m for m in anchors if m.request is not waiting[0].request and not _is_its_own(m, waiting[0], habit)]
        if habit.kind == "near" and load_habits().is_in(waiting[0].category, "lounges"):
            anchors = [m for m in anchors if not _is_sat_about(members, m)]
        if habit.kind == "on" and load_habits().is_in(waiting[0].category, "built_in"):
            anchors.sort(key=lambda anchor: _built_into(members, anchor))
        waiting = _at_anchors(members, waiting, *_before_waiting(habit, anchors))
        if not waiting:
            break
    return waiting


def _built_into(members: Members, anchor: Member) -> tuple[int, int]:
    """How many things are built into it, and how many are asked to stand on it."""
    on = [(m, tie) for m in members.all for tie in m.ties if tie.kind == "on" and anchor.id in tie.anchors]
    built_in = sum(load_habits().is_in(member.category, "built_in") for member, _ in on)
    return built_in, sum(tie.asked for _, tie in on)


def _is_its_own(anchor: Member, member: Member, habit: Habit) -> bool:
    """Whether the anchor is no company: it usually stands next to the other itself, or is drawn up to a table."""
    if habit.kind == "next_to" and load_habits().is_in(anchor.category, "seats"):
        return any(tie.kind in ("at", "around", "at_long_side", "at_short_side") for tie in anchor.ties)
    return habit.kind == "near" and load_habits().tie(anchor.category, member.category) == "next_to"


def _applies(members: Members, waiting: list[Member], habit: Habit) -> bool:
    """Whether the habit's company is there, and nobody has been told to look at what would have to look at others."""
    company = members.of_category(habit.company) if habit.company else []
    if habit.kind == "opposite":
        company = [other for other in company if members.support(other) in waiting]
    if habit.company and not company:
        return False
    if habit.kind != "opposite":
        return True
    shown = {member.id for member in waiting}
    shown |= {m.id for m in members.all if (support := members.support(m)) and support.id in shown}
    return not any(tie.kind in _WITHOUT_PLACE and shown & set(tie.anchors) for m in members.all for tie in m.ties)


def _at_place(members: Members, waiting: list[Member], habit: Habit, *, windows: bool) -> list[Member]:
    place = habit.anchors[0]
    if place == "window" and not windows:
        return waiting
    if place == "centre" and any(_stands_amid(m) for m in members.all):
        return waiting
    if place == "centre" and len(waiting) > 1:
        return _in_rows(waiting)
    free = _free(members, waiting[0], habit, place)
    for member in waiting[:free]:
        _put(member, habit, place)
    return waiting[free:]


def _stands_amid(member: Member) -> bool:
    """Whether it stands in rows amid the room, rather than along a wall."""
    kinds = {tie.kind for tie in member.ties}
    return "in_rows" in kinds and "against_wall" not in kinds


def _in_rows(waiting: list[Member]) -> list[Member]:
    rows = rows_for(waiting[0].category, len(waiting))
    for index, member in enumerate(waiting):
        tie = Tie(kind="in_rows", index=index, count=len(waiting), rows=rows, asked=False)
        member.ties.append(tie)
    return []


def _at_anchors(members: Members, waiting: list[Member], habit: Habit, anchors: list[Member]) -> list[Member]:
    """Spread over the anchors in order, as far as each has space."""
    space = {anchor.id: _free(members, waiting[0], habit, anchor.id) for anchor in anchors}
    open_anchors = [anchor for anchor in anchors if space[anchor.id] > 0]
    if not open_anchors:
        return waiting
    left: list[Member] = []
    for number, member in enumerate(waiting):
        first = share(number, len(waiting), len(open_anchors))
        order = [*open_anchors[first:], *open_anchors[:first]]
        anchor = next((a for a in order if space[a.id] > 0), None)
        if anchor is None:
            left.append(member)
        else:
            space[anchor.id] -= 1
            _put(member, habit, anchor.id)
    return left


def _put(member: Member, habit: Habit, anchor: str) -> None:
    tie = Tie(kind=habit.kind, anchors=(anchor,), asked=False)
    if habit.kind == "on" or member.ties:
        member.ties.insert(0, tie)
    else:
        member.ties.append(tie)


def _free(members: Members, member: Member, habit: Habit, anchor: str) -> int:
    """How many more can have this relation to the anchor."""
    capacity = _CAPACITY.get(habit.kind, _UNLIMITED)
    if habit.kind == "at" and load_habits().is_in(anchor.rsplit("_", 1)[0], "long_sides"):
        capacity = _UNLIMITED
    if habit.kind == "in_front_of" and load_habits().is_in(member.category, "visits"):
        capacity = _VISITORS
    rivals = (m for m in members.all if m.mount == member.mount and m.flat == member.flat)
    if habit.kind not in _EXCLUSIVE:
        rivals = (m for m in rivals if m.category == member.category)
    return max(0, capacity - sum(any(t.kind == habit.kind and anchor in t.anchors for t in m.ties) for m in rivals))


def _number(members: list[Member]) -> None:
    """Count off those of a request that share an implied tie."""
    groups: dict[tuple[str, tuple[str, ...]], list[tuple[Member, int]]] = {}
    for member in members:
        for place, tie in enumerate(member.ties):
            if not tie.asked and tie.kind != "in_rows":
                groups.setdefault((tie.kind, tie.anchors), []).append((member, place))
    for group in groups.values():
        for index, (member, place) in enumerate(group):
            member.ties[place] = replace(member.ties[place], index=index, count=len(group))
