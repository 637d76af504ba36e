"""Relations of a brief to ties of the very objects: who stands at which table, who faces whom."""

import math
from itertools import pairwise

from msgspec.structs import replace

from thinkblox.assets import facts_of
from thinkblox.brief import Brief, Relation, RelationKind
from thinkblox.knowledge.habits import load_habits
from thinkblox.plan import Tie
from thinkblox.planning.groups import bring_near
from thinkblox.planning.members import Member, Members

_TOGETHER = ("between", "above", "around", "facing", "opposite", "behind", "under", "near", "far")
"""Relations that one object can have to several anchors at once."""
_PAIRED = ("facing", "opposite", "back_to_back")
"""Relations among alike that pair them."""
_SUPPORTED = ("between", "in_front_of", "opposite")
"""Relations of things on walls and ceilings to what carries their anchor."""
_HELD = ("on", "inside")
"""Relations to the very thing that was named, whatever carries that."""
_DRAWN_UP = ("around", "at", "at_long_side", "at_short_side", "next_to")
"""Relations by which seats belong to a table."""
_ROW = 3
"""From so many on alike things that are next to each other stand in a row that is laid out as a whole."""
_MIRRORED: dict[str, RelationKind] = {
    "next_to": "next_to",
    "near": "near",
    "far": "far",
    "back_to_back": "back_to_back",
    "opposite": "opposite",
    "facing": "facing",
    "left_of": "right_of",
    "right_of": "left_of",
    "in_front_of": "behind",
    "behind": "in_front_of",
    "above": "under",
    "under": "above",
}


def tie_relation(brief: Brief, relation: Relation, members: Members) -> None:
    """Give every object of the relation's subject its tie."""
    subjects = members.by_request.get(relation.subject, [])
    keys = [anchor for anchor in relation.anchors if anchor in members.by_request]
    if relation.kind == "in_rows" or (relation.anchors and not keys):
        _tie_to_place(relation, subjects)
    elif relation.subject in keys:
        _tie_among(relation, subjects)
    elif len(keys) > 1 and (relation.kind not in _TOGETHER or (relation.each and relation.kind != "between")):
        _share_out(brief, relation, subjects, [member for key in keys for member in members.by_request[key]], members)
    elif relation.kind == "between" and len(keys) == 1 and (gaps := _gaps(brief, relation, subjects, members)):
        _tie_between(relation, subjects, gaps, members)
    elif len(keys) > 1 or relation.kind == "between":
        anchors = [member for key in keys for member in members.by_request[key]]
        for index, subject in enumerate(subjects):
            _add(members, subject, anchors, relation, index, len(subjects))
    elif keys:
        _share_out(brief, relation, subjects, members.by_request[keys[0]], members)
    if relation.kind == "between":
        for subject in subjects:
            _tie_beside_both(brief, subject, members)


def _tie_beside_both(brief: Brief, subject: Member, members: Members) -> None:
    """What stands between two others is next to both, unless one of these looks at the other."""
    tie = next((tie for tie in subject.ties if tie.kind == "between" and tie.asked and len(tie.anchors) == 2), None)
    if tie is None or subject.mount != "floor":
        return
    pair = [member for member in members.all if member.id in tie.anchors]
    if len(pair) == 2 and all(member.mount == "floor" for member in pair) and not _are_opposite(brief, *pair):
        subject.ties += [Tie(kind="next_to", anchors=(member.id,)) for member in pair]


def _are_opposite(brief: Brief, one: Member, other: Member) -> bool:
    """Whether one of two looks at the other, as asked or usually: a sofa and what a television stands on."""
    keys = {one.request.key, other.request.key}
    habits = load_habits()
    usual = {habits.tie(one.category, other.category), habits.tie(other.category, one.category)}
    told = {r.kind for r in brief.relations if r.subject in keys and keys.issuperset(r.anchors) and r.anchors}
    return not (usual | told).isdisjoint(("facing", "opposite"))


def _gaps(brief: Brief, relation: Relation, subjects: list[Member], members: Members) -> list[tuple[Member, Member]]:
    """Which two of its anchors each is between: neighbours in a row, or two of its own; none where it is among all."""
    anchors = members.by_request[relation.anchors[0]]
    if len(anchors) == 2 * len(subjects) > 2 and not relation.each:
        return list(zip(anchors[::2], anchors[1::2], strict=True))
    said = (r.rows for r in brief.relations if r.kind == "in_rows" and r.subject == relation.anchors[0])
    columns = -(-len(anchors) // max(1, next(said, 1)))
    return [pair for at, pair in enumerate(pairwise(anchors), 1) if at % columns] if relation.each else []


def _tie_between(
    relation: Relation, subjects: list[Member], gaps: list[tuple[Member, Member]], members: Members
) -> None:
    """Share subjects out over the gaps."""
    for number, subject in enumerate(subjects):
        which = share(number, len(subjects), len(gaps))
        alike = [n for n in range(len(subjects)) if share(n, len(subjects), len(gaps)) == which]
        _add(members, subject, list(gaps[which]), relation, alike.index(number), len(alike))


def _tie_to_place(relation: Relation, subjects: list[Member]) -> None:
    for index, subject in enumerate(subjects):
        rows = (relation.rows or rows_for(subject.category, len(subjects))) if relation.kind == "in_rows" else 0
        subject.ties.append(
            Tie(
                kind=relation.kind,
                anchors=relation.anchors,
                index=index,
                count=len(subjects),
                rows=rows,
                asked=relation.asked,
                spread=relation.spread,
            )
        )


def rows_for(category: str, count: int) -> int:
    """Rows for so many alike when nobody says.

    As many as leave the usual number abreast; else the nearest to half as many rows as places in a row.
    """
    if abreast := facts_of(category).row.abreast:
        return -(-count // abreast)
    divisors = [n for n in range(1, count + 1) if count % n == 0 and n * n <= count]
    even = divisors[-1] if divisors else 1
    return even if even > 1 or count < 5 else max(1, round(math.sqrt(count / 2.0)))


def _tie_among(relation: Relation, subjects: list[Member]) -> None:
    """Objects related to each other: side by side in a chain; facing in pairs, or row to row; a table's among them."""
    for company in _companies(relation, subjects):
        _tie_company(relation, company)


def _companies(relation: Relation, subjects: list[Member]) -> list[list[Member]]:
    """Those who look at each other: where they are shared out over several tables, those of one table."""
    if relation.kind not in _PAIRED:
        return [subjects]
    tables: dict[tuple[str, ...], list[Member]] = {}
    for subject in subjects:
        anchors = next((tie.anchors for tie in subject.ties if tie.kind in _DRAWN_UP), ())
        tables.setdefault(anchors, []).append(subject)
    return list(tables.values())


def _tie_company(relation: Relation, subjects: list[Member]) -> None:
    rows = next((tie.rows for tie in subjects[0].ties if tie.kind == "in_rows"), 0)
    paired = relation.kind in _PAIRED and (rows == 2 or len(subjects) > 1)
    half = len(subjects) // 2 if paired else 0
    one_row = relation.kind == "next_to" and _is_one_row(subjects)
    for index, subject in enumerate(subjects):
        if half:
            partner = subjects[index - half] if index >= half else None
        else:
            partner = subjects[index - 1] if index else None
        anchors = (partner.id,) if partner else ()
        if one_row:
            subject.ties.append(Tie(kind="in_rows", index=index, count=len(subjects), rows=1, asked=False))
        subject.ties.append(
            Tie(kind=relation.kind, anchors=anchors, index=index, count=len(subjects), asked=relation.asked)
        )


def _is_one_row(subjects: list[Member]) -> bool:
    """Whether so many on the floor are side by side that they need their places, and one direction, at once."""
    first = subjects[0]
    return len(subjects) >= _ROW and first.mount == "floor" and not first.flat and not first.ties


def _share_out(
    brief: Brief, relation: Relation, subjects: list[Member], anchors: list[Member], members: Members
) -> None:
    """Spread subjects evenly over the anchors, in order; a few may have them all."""
    if not relation.asked and relation.kind == "on" and load_habits().is_in(subjects[0].category, "built_in"):
        anchors = members.of_category(anchors[0].category)  # A hob and a sink that nobody puts there share no cabinet.
    if _shared_by_two(relation, subjects, anchors) and not _goes_on(brief, relation, members):
        for number, subject in enumerate(subjects):
            for anchor in anchors[2 * number : 2 * number + 2]:
                _add(members, subject, [anchor], relation, 0, 1)
        return
    if relation.kind in ("on", "next_to", "at") and len(subjects) < len(anchors):
        anchors = sorted(anchors, key=lambda anchor: _load(members, anchor, relation.kind))
    together = relation.kind in _TOGETHER and not relation.each and len(subjects) < len(anchors)
    for number, subject in enumerate(subjects):
        if together:
            _add(members, subject, anchors, relation, number, len(subjects))
            continue
        which = share(number, len(subjects), len(anchors))
        alike = [n for n in range(len(subjects)) if share(n, len(subjects), len(anchors)) == which]
        _add(members, subject, [anchors[which]], relation, alike.index(number), len(alike))


def _shared_by_two(relation: Relation, subjects: list[Member], anchors: list[Member]) -> bool:
    """Whether things on the floor stand next to twice as many alike: each has one of them on either side."""
    alike = len({anchor.request.key for anchor in anchors}) == 1
    floor = all(member.mount == "floor" for member in (*subjects, *anchors))
    twice = len(anchors) == 2 * len(subjects)
    return relation.kind == "next_to" and not relation.each and alike and floor and twice


def _goes_on(brief: Brief, relation: Relation, members: Members) -> bool:
    """Whether others alike stand by the same: three orange chairs and three grey ones by six desks."""
    alike = {member.category for member in members.by_request[relation.subject]}
    others = (r for r in brief.relations if r.subject != relation.subject and r.subject in members.by_request)
    same = (r for r in others if (r.kind, r.anchors) == (relation.kind, relation.anchors))
    return any(alike == {member.category for member in members.by_request[r.subject]} for r in same)


def _load(members: Members, anchor: Member, kind: str) -> int:
    """How many things the anchor carries (or has beside it) already."""
    return sum(tie.kind == kind and anchor.id in tie.anchors for member in members.all for tie in member.ties)


def share(number: int, count: int, anchors: int) -> int:
    """Which anchor the `number`-th of `count` alike goes to."""
    return number * anchors // count if count >= anchors else number


def _add(members: Members, subject: Member, anchors: list[Member], relation: Relation, index: int, count: int) -> None:
    """Add a tie, or its mirror image to the anchor where the anchor already waits for the subject.

    Where that is to other things than were named, or the other way round, what was asked for is due all the same.
    """
    named = [anchor for anchor in dict.fromkeys(anchors) if anchor is not subject]
    if _stands_by_carriers(subject, relation):
        anchors = [_standing(members, anchor, subject, relation) for anchor in anchors]
    anchors = [anchor for anchor in dict.fromkeys(anchors) if anchor is not subject]
    free = [anchor for anchor in anchors if not members.depends(anchor, subject)]
    kind = _meant(relation, subject, free, members, count) if free else relation.kind
    means = free != named and kind == relation.kind
    if means and named:
        ids = tuple(anchor.id for anchor in named)
        members.owe(subject, Tie(kind=kind, anchors=ids, index=index, count=count, asked=relation.asked))
    for anchor in anchors:
        mirrored = _MIRRORED.get(relation.kind)
        if (
            anchor not in free
            and mirrored
            and not any(subject.id in tie.anchors and tie.kind == mirrored for tie in anchor.ties)
        ):
            anchor.ties.append(Tie(kind=mirrored, anchors=(subject.id,), asked=relation.asked, means=True))
    if free:
        ids = tuple(anchor.id for anchor in free)
        tie = Tie(kind=kind, anchors=ids, index=index, count=count, asked=relation.asked, means=means)
        subject.ties.append(tie)
        if kind in ("at_long_side", "at_short_side") and load_habits().is_in(subject.category, "seating"):
            subject.ties.append(replace(tie, kind="facing"))


def _stands_by_carriers(subject: Member, relation: Relation) -> bool:
    """Whether it is placed by what carries a thing, where it is asked for by that thing."""
    if relation.kind in _HELD:
        return False
    return subject.mount == "floor" or (relation.kind in _SUPPORTED and subject.mount != "surface")


def _standing(members: Members, anchor: Member, subject: Member, relation: Relation) -> Member:
    """What a thing on the floor stands by where it is asked to stand by a thing on a counter: the counter."""
    support = members.support(anchor)
    if support is None or support is subject:
        return anchor
    if relation.kind in ("next_to", "near") and anchor.mount == "surface" and not members.depends(subject, anchor):
        bring_near(anchor, subject)
    return support


def _meant(relation: Relation, subject: Member, anchors: list[Member], members: Members, count: int) -> RelationKind:
    """The one seat before or behind a desk that has none yet is the one that somebody works in: drawn up to it.

    One that is worked at from behind has it there.
    """
    habits, desk = load_habits(), anchors[0]
    if relation.kind == "at" and len(anchors) == 1 and habits.is_in(desk.category, "worked_behind"):
        return "behind" if habits.is_in(subject.category, "chairs") else relation.kind
    if relation.kind not in ("in_front_of", "behind") or len(anchors) > 1 or count > 1:
        return relation.kind
    works = habits.is_in(subject.category, "chairs") and facts_of(desk.category).gaze == "back"
    taken = any(tie.kind == "at" and desk.id in tie.anchors for other in members.all for tie in other.ties)
    return "at" if works and not taken else relation.kind
