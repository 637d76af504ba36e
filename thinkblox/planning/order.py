"""Brief to Plan: anchors first, then what belongs to them, then small things."""

import heapq
from collections.abc import Sequence

from msgspec.structs import replace

from thinkblox.assets import facts_of, kind_of
from thinkblox.brief import Brief
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.things import counts_as, is_surface
from thinkblox.plan import Due, Plan, Target, Tie, is_object
from thinkblox.planning.asked import tie_relation
from thinkblox.planning.denied import deny
from thinkblox.planning.groups import bring_along, carry_to_opening, carry_to_wall, count_off, lower, turn_stands
from thinkblox.planning.implied import imply
from thinkblox.planning.loads import words_of
from thinkblox.planning.members import Member, Members
from thinkblox.planning.openings import opening_notes
from thinkblox.planning.parts import chosen_walls, free_parts
from thinkblox.planning.sizes import size_note, size_of
from thinkblox.planning.surfaces import surface_notes
from thinkblox.planning.views import gather, keep_views, seat_about
from thinkblox.planning.walls import relations_in
from thinkblox.scene.room import Room

_PLACED = ("against_wall", "in_corner", "in_centre", "near", "in_rows")
_BESIDE = ("next_to", "left_of", "right_of")
_LATER = 10.0
"""How much later than by its size comes what is only assumed, where what is asked for is arranged [m2]."""
_NAMED_PLACE_BONUS = 1.0
"""What a place that the prompt names counts for, as footprint, in the order of anchors [m2]."""
_ASKED_BONUS = 1.0
"""What being asked to stand by something counts for: nothing that is only usual there parts the two [m2]."""
_COUNTER_BONUS = 2.0
"""What a counter counts for: there is room behind it before tables take the floor [m2]."""
_SCREEN_BONUS = 1.0
"""What a screen counts for on a desk: the rest lies about it [m2]."""
_BUILT_IN_BONUS = 2.0
"""What counts for what is let into a worktop: things stand about it, and it is not fitted in between them [m2]."""
_OVER_BONUS = 2.0
"""What counts for what hangs over a thing: a mirror over its basin comes before a rail on any wall [m2]."""
_BESIDE_BONUS = 1.0
"""What counts for what belongs beside a thing before all else: a nightstand comes before a chair for visitors [m2]."""
_COMPANION_BONUS = 0.5
"""What counts for what keeps its place by another on a surface: it comes next after that, before the rest [m2]."""
_BEFORE, _AT_END = 10_000, 1.2
"""Puts parts of a run before all others of it, and how high those are that stand at its end [m]."""
_LOW, _WIDE = 0.6, 1.2
"""What hangs lower and is wider and higher than that takes a wall as large furniture does [m]."""
_STAGES = {"floor": 0, "wall": 3, "ceiling": 4, "surface": 5}
_Rank = tuple[int, float, int]


def plan_brief(brief: Brief, room: Room) -> Plan:
    """Who is placed in which order, tied to whom; every relation of the brief becomes ties.

    Two ties may have no anchors: "in_rows", and "facing" or "next_to" of the first among its like.
    """
    brief = _dressed(without_excluded(brief), room)
    members = Members(brief)
    relations = list(relations_in(brief, room, chosen_walls(brief, room)))
    for relation in relations:
        if not relation.negated:
            tie_relation(brief, relation, members)
    deny((relation for relation in relations if relation.negated), members)
    imply(members, windows=any(opening.kind == "window" for opening in room.openings), free=brief.free)
    _join_runs(members)
    gather(members)
    seat_about(members)
    keep_views(members)
    lower(members)
    bring_along(members)
    carry_to_wall(members)
    carry_to_opening(members)
    turn_stands(members)
    count_off(members)
    _leave_middles(members)
    _keep_together(members)
    ordered = _ordered(members)
    due = _due(members, ordered)
    targets = tuple(_target(member, members, room.height, due.get(member.id, ())) for member in ordered)
    sizes = (size_note(request) for request in brief.requests)
    notes = (*filter(None, sizes), *brief.left_out, *opening_notes(brief, room), *surface_notes(brief, room))
    return Plan(brief=brief, targets=targets, notes=notes, free=free_parts(brief, room))


def without_excluded(brief: Brief) -> Brief:
    """The brief without what it only assumes and what must not be there."""
    gone = {
        request.key
        for request in brief.requests
        if not request.asked and any(counts_as(request.category, name) for name in brief.excluded)
    }
    if not gone:
        return brief
    relations = (r for r in brief.relations if r.subject not in gone and gone.isdisjoint(r.anchors))
    return replace(brief, requests=tuple(r for r in brief.requests if r.key not in gone), relations=tuple(relations))


def _dressed(brief: Brief, room: Room) -> Brief:
    """The brief with no more of the curtains that it only assumes than the room has windows."""
    windows = sum(opening.kind == "window" for opening in room.openings)
    drapes = {r.key for r in brief.requests if not r.asked and facts_of(r.category).hanging.windows != "no"}
    if not drapes:
        return brief
    fewer = (replace(r, count=min(r.count, windows)) if r.key in drapes and windows else r for r in brief.requests)
    kept = tuple(r for r in fewer if windows or r.key not in drapes)
    keys = {r.key for r in kept}
    relations = (r for r in brief.relations if r.subject in keys and (drapes - keys).isdisjoint(r.anchors))
    return replace(brief, requests=kept, relations=tuple(relations))


def _due(members: Members, ordered: Sequence[Member]) -> dict[str, list[Due]]:
    """What is due, by the id of who is placed last of those it is about."""
    number = {member.id: number for number, member in enumerate(ordered)}
    found: dict[str, list[Due]] = {}
    for due in members.due:
        found.setdefault(max((due.subject, *due.tie.anchors), key=number.__getitem__), []).append(due)
    return found


def _target(member: Member, members: Members, room_height: float, due: Sequence[Due]) -> Target:
    request = member.request
    return Target(
        id=member.id,
        category=request.category,
        request=request.key,
        asked=request.asked,
        attributes=words_of(member, members),
        index=member.index,
        count=request.count,
        ties=tuple(dict.fromkeys(member.ties)),
        denied=tuple(dict.fromkeys(member.denied)),
        due=tuple(due),
        size=size_of(member, members, room_height),
        called=request.called,
    )


def _ordered(members: Members) -> list[Member]:
    """A topological order that takes the highest-ranking object that waits for nobody."""
    needs = {
        m.id: {a for tie in m.ties for a in tie.anchors if a in members.by_id} | (m.waits & members.by_id.keys())
        for m in members.all
    }
    ranks = _ranks(members, needs)
    users: dict[str, list[str]] = {m.id: [] for m in members.all}
    for id, anchors in needs.items():
        for anchor in anchors:
            users[anchor].append(id)
    ready = [(ranks[id], id) for id, anchors in needs.items() if not anchors]
    heapq.heapify(ready)
    order: list[Member] = []
    while len(order) < len(members.all):
        if not ready:
            id = _set_free(members, needs, ranks)
            heapq.heappush(ready, (ranks[id], id))
        _, id = heapq.heappop(ready)
        del needs[id]
        order.append(members.by_id[id])
        for user in users[id]:
            if needs.get(user):
                needs[user].discard(id)
                if not needs[user]:
                    heapq.heappush(ready, (ranks[user], user))
    return order


def _set_free(members: Members, needs: dict[str, set[str]], ranks: dict[str, _Rank]) -> str:
    """Let one of those that all wait for one another wait no more: its ties to the others are due when these stand."""

    def asked(id: str) -> bool:
        return any(tie.asked for tie in members.by_id[id].ties if not needs[id].isdisjoint(tie.anchors))

    id = min(needs, key=lambda id: (asked(id), ranks[id]))
    member = members.by_id[id]
    for tie in [tie for tie in member.ties if not needs[id].isdisjoint(tie.anchors)]:
        member.ties.remove(tie)
        members.owe(member, tie)
    needs[id] = set()
    return id


def _ranks(members: Members, needs: dict[str, set[str]]) -> dict[str, _Rank]:
    """Rank of every object, smallest first; an object comes as early as what waits for it needs it."""
    arranged = any(_is_dependent(m) and m.request.asked and _STAGES[m.mount] == 0 for m in members.all)
    ranks = {
        member.id: _rank(
            member,
            number,
            arranged=arranged,
            with_anchor=_is_with_anchor(member, members),
            companion=_companion(member, members),
            belongs=_belongs_beside(member, members),
            before=_lain_before(member, members),
            let_in=_is_let_in(member, members),
        )
        for number, member in enumerate(members.all)
    }
    for run in _runs(members):
        first = min(ranks[id][:2] for id in run)
        whole = sum(members.by_id[id].footprint for id in run)
        stage = 0 if any(members.by_id[id].request.asked for id in run) else first[0]
        weight, parts = min(first[1], -round(whole, 6)), (members.by_id[id] for id in run)
        ranks |= {part.id: (stage, weight, ranks[part.id][2] - _BEFORE * _fixes_run(part)) for part in parts}
    queue = list(ranks)
    while queue:
        id = queue.pop()
        for anchor in needs[id]:
            early = members.by_id[id].mount == "floor" or _is_over(members.by_id[id])
            if early and ranks[id][:2] < ranks[anchor][:2]:
                ranks[anchor] = (*ranks[id][:2], ranks[anchor][2])
                queue.append(anchor)
    return ranks


def _is_over(member: Member) -> bool:
    """Whether it hangs on the wall over a thing: a hood over its hob."""
    over = any(tie.kind == "above" and is_object(a) for tie in member.ties for a in tie.anchors)
    return over and member.mount == "wall"


def _fixes_run(part: Member) -> int:
    """How much of a run follows from where a part of it stands: what fills a corner, then what is at an end."""
    if facts_of(part.category).is_in("fills_corner"):
        return 2
    return int(kind_of(part.category).size[2] > _AT_END)


def _runs(members: Members) -> list[list[str]]:
    """Ids of what is built in one line, where nothing else is asked to stand by a part of it: one after the other."""
    runs: dict[str, list[str]] = {}
    for member in members.all:
        facts = facts_of(member.category)
        if facts.is_in("built_in_line") and member.mount == "floor":
            runs.setdefault(facts.run, []).append(member.id)
    beside = {
        anchor
        for member in members.all
        if member.mount == "floor" and not facts_of(member.category).is_in("built_in_line")
        for tie in member.ties
        if tie.asked and tie.kind in _BESIDE
        for anchor in tie.anchors
    }
    return [run for run in runs.values() if len(run) > 1 and beside.isdisjoint(run)]


def _join_runs(members: Members) -> None:
    """What is only assumed to stand next to a part of its run stands anywhere in it, as the run is best lined up."""
    for run in _runs(members):
        _wait_for(members, run)
        for member in (members.by_id[id] for id in run):
            kept = [
                tie for tie in member.ties if tie.asked or tie.kind != "next_to" or not set(run).issuperset(tie.anchors)
            ]
            if len(kept) < len(member.ties):
                member.ties[:] = kept or [Tie(kind="against_wall", anchors=("wall",), asked=False)]


def _wait_for(members: Members, run: Sequence[str]) -> None:
    """What stands before a part of a run comes when all of that stands: it is before its middle."""
    parts = [members.by_id[id] for id in run]
    for member in members.all:
        before = any(tie.kind == "in_front_of" and not set(run).isdisjoint(tie.anchors) for tie in member.ties)
        if before and member.mount == "floor" and not any(members.depends(part, member) for part in parts):
            member.waits.update(run)


def _leave_middles(members: Members) -> None:
    """What is only asked to be on a thing comes after what is asked to be in the middle of that."""
    for central in members.all:
        tops = {a for tie in central.ties if tie.asked and tie.kind == "in_centre" for a in tie.anchors if is_object(a)}
        _have_wait(members, central, tops, [m.id for m in members.all if m.request is central.request])


def _keep_together(members: Members) -> None:
    """What else is on a top comes after what is asked to be between two things there, which takes one stretch of it."""
    for middle in members.all:
        pairs = [tie.anchors for tie in middle.ties if tie.asked and tie.kind == "between" and len(tie.anchors) == 2]
        for pair in pairs:
            tops = {a for m in (members.by_id.get(p) for p in pair) if m for a in _tops(m)}
            let_in = [m.id for m in members.all if facts_of(m.category).is_in("built_in")] if tops else []
            _have_wait(members, middle, tops, [middle.id, *pair, *let_in])


def _have_wait(members: Members, first: Member, tops: set[str], besides: Sequence[str]) -> None:
    """Have all that is on some tops come after one of them, besides those named and what that one itself needs."""
    for other in members.all if tops else ():
        if other.id not in besides and tops & _tops(other) and not members.depends(first, other):
            other.waits.add(first.id)


def _tops(member: Member) -> set[str]:
    """What it is on."""
    return {a for tie in member.ties if tie.kind == "on" for a in tie.anchors if is_object(a)}


def _is_dependent(member: Member) -> bool:
    return any(is_object(anchor) for tie in member.ties for anchor in tie.anchors)


def _is_wall_wide(member: Member) -> bool:
    """Whether it hangs as wide and low as large furniture stands, which would leave no wall for it: a mirror wall."""
    kind = kind_of(member.category)
    _, width, height = kind.size
    return member.mount == "wall" and kind.hanging.middle - height / 2 < _LOW and min(width, height) > _WIDE


def _lain_before(member: Member, members: Members) -> float:
    """How much floor is taken by what is asked to lie before it, as the mats before a mirror do [m2]."""
    lying = (m for m in members.all if m.flat and m.request.asked)
    return sum(m.footprint for m in lying if any(t.kind == "in_front_of" and member.id in t.anchors for t in m.ties))


def _is_with_anchor(member: Member, members: Members) -> bool:
    """Whether it takes its place before what stands free, as that does by which it stands: a run, or a counter.

    So does a bed that only looks at what hangs on a wall: it needs the wall across from that.
    """
    ties = [tie for tie in member.ties if any(map(is_object, tie.anchors))]
    anchors = [members.by_id[anchor].category for tie in ties for anchor in tie.anchors if anchor in members.by_id]
    kinds = {tie.kind for tie in ties}
    own = facts_of(member.category)
    if own.is_in("beds") and kinds and kinds <= {"facing", "opposite"}:
        return all(kind_of(category).mount == "wall" for category in anchors)
    if not anchors or (kinds == {"next_to"} and (own.is_in("built_in_line") or not own.is_in("surfaces", "tops"))):
        return False
    group = {"in_front_of": "built_in_line", "next_to": "served_over"}.get(next(iter(kinds)), "")
    return len(kinds) == 1 and all(facts_of(category).is_in(group) for category in anchors)


def _belongs_beside(member: Member, members: Members) -> bool:
    """Whether it is asked to be next to what it usually is next to, and stands on the floor."""
    first = next(iter(load_habits().of(member.category)), None)
    if first is None or first.kind != "next_to" or not facts_of(member.category).is_in("cases"):
        return False
    asked = (tie for tie in member.ties if tie.kind == "next_to" and tie.asked)
    beside = (anchor for tie in asked for anchor in tie.anchors if anchor in members.by_id)
    return any(members.by_id[anchor].category in first.anchors for anchor in beside)


def _companion(member: Member, members: Members) -> Member | None:
    """What a thing on a surface keeps its place by, as a keyboard does by the screen; None where that is not there."""
    companion = facts_of(member.category).companion
    if companion is None or member.mount != "surface":
        return None
    return next(iter(members.of_category(companion.category)), None)


def _is_let_in(member: Member, members: Members) -> bool:
    """Whether it is let into a worktop before others stand on this: asked, or in a top rather than one of cabinets."""
    if not facts_of(member.category).is_in("built_in") or member.mount != "surface":
        return False
    carriers = (members.by_id[a] for tie in member.ties for a in tie.anchors if a in members.by_id)
    return member.request.asked or any(is_surface(carrier.request.called) for carrier in carriers)


def _rank(
    member: Member,
    number: int,
    *,
    arranged: bool,
    with_anchor: bool,
    companion: Member | None,
    belongs: bool,
    before: float,
    let_in: bool,
) -> _Rank:
    """Large before small, floor before walls; what is only assumed comes after what is asked to stand by something.

    What stands before a run, or is one with a counter, comes with it.
    """
    wall = _is_wall_wide(member)
    stage = 0 if wall else 2 if member.flat else _STAGES[member.mount]
    dependent = _is_dependent(member) and not with_anchor
    named = any(tie.asked and tie.kind in _PLACED for tie in member.ties)
    shared_out = any(tie.spread for tie in member.ties)
    beside = any(tie.asked and is_object(anchor) for tie in member.ties for anchor in tie.anchors)
    weight = member.footprint + _NAMED_PLACE_BONUS * (named + shared_out) + _ASKED_BONUS * beside
    weight += (_NAMED_PLACE_BONUS + before) * wall
    case = with_anchor and any(tie.kind == "next_to" for tie in member.ties)
    weight += _COUNTER_BONUS * (stage == 0 and (case or load_habits().is_in(member.category, "served_over")))
    weight += _OVER_BONUS * _is_over(member)
    weight += _SCREEN_BONUS * (member.mount == "surface" and load_habits().is_in(member.category, "screens"))
    weight += _BUILT_IN_BONUS * let_in
    weight += _COMPANION_BONUS * (companion is not None) + _BESIDE_BONUS * belongs
    late = arranged and not (let_in or any(m.request.asked for m in (member, companion) if m is not None))
    return (stage + int((dependent or late) and stage == 0), (_LATER if late else 0.0) - round(weight, 6), number)
