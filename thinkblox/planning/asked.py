"""Relations of a brief to ties of the very objects: who stands at which table, who faces whom."""

import math

from thinkblox.assets import facts_of
from thinkblox.brief import Brief, Relation, RelationKind
from thinkblox.knowledge.habits import load_habits
from thinkblox.plan import Tie
from thinkblox.planning.members import Member, Members

_TOGETHER = ("between", "above", "around", "facing", "opposite", "behind", "under", "near", "far")
"""Relations that one object can have to several anchors at once."""
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
    elif len(keys) > 1 and relation.kind not in _TOGETHER:
        _share_out(relation, subjects, [member for key in keys for member in members.by_request[key]], members)
    elif len(keys) > 1 or relation.kind == "between":
        anchors = [member for key in keys for member in members.by_request[key]]
        for index, subject in enumerate(subjects):
            _add(members, subject, anchors, relation, index, len(subjects))
    elif keys:
        _share_out(relation, subjects, members.by_request[keys[0]], members)


def _tie_to_place(relation: Relation, subjects: list[Member]) -> None:
    rows = (relation.rows or rows_for(len(subjects))) if relation.kind == "in_rows" else 0
    for index, subject in enumerate(subjects):
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


def rows_for(count: int) -> int:
    """Rows for so many alike when nobody says: the nearest to half as many rows as places in a row."""
    divisors = [n for n in range(1, count + 1) if count % n == 0 and n * n <= count]
    even = divisors[-1] if divisors else 1
    return even if even > 1 or count < 5 else max(1, round(math.sqrt(count / 2.0)))


def _tie_among(relation: Relation, subjects: list[Member]) -> None:
    """Objects related to each other: side by side in a chain; facing in pairs, or row to row."""
    rows = next((tie.rows for tie in subjects[0].ties if tie.kind == "in_rows"), 0)
    paired = relation.kind in ("facing", "opposite", "back_to_back") and (rows == 2 or len(subjects) > 1)
    half = len(subjects) // 2 if paired else 0
    for index, subject in enumerate(subjects):
        if half:
            partner = subjects[index - half] if index >= half else None
        else:
            partner = subjects[index - 1] if index else None
        anchors = (partner.id,) if partner else ()
        subject.ties.append(
            Tie(kind=relation.kind, anchors=anchors, index=index, count=len(subjects), asked=relation.asked)
        )


def _share_out(relation: Relation, subjects: list[Member], anchors: list[Member], members: Members) -> None:
    """Spread subjects evenly over the anchors, in order; a few may have them all."""
    if relation.kind in ("on", "next_to") and len(subjects) < len(anchors):
        anchors = sorted(anchors, key=lambda anchor: _load(members, anchor, relation.kind))
    together = relation.kind in _TOGETHER and not relation.each and len(subjects) < len(anchors)
    for number, subject in enumerate(subjects):
        if together:
            _add(members, subject, anchors, relation, number, len(subjects))
            continue
        which = share(number, len(subjects), len(anchors))
        alike = [n for n in range(len(subjects)) if share(n, len(subjects), len(anchors)) == which]
        _add(members, subject, [anchors[which]], relation, alike.index(number), len(alike))


def _is_backing(relation: Relation, subject: Member, anchors: list[Member]) -> bool:
    """Whether shelves behind a counter have to be placed before it, so that somebody fits in between."""
    habits = load_habits()
    shelves = habits.is_in(subject.category, "storage") and subject.mount == "floor"
    return relation.kind == "behind" and shelves and habits.is_in(anchors[0].category, "counters")


def _back(shelves: Member, counter: Member) -> None:
    """Put shelves against the wall with the counter before them; more of them join the first."""
    first = next((tie.anchors for tie in counter.ties if tie.kind == "in_front_of"), ())
    if first:
        shelves.ties.append(Tie(kind="next_to", anchors=first, asked=False))
    else:
        shelves.ties.append(Tie(kind="against_wall", anchors=("wall",), asked=False))
        counter.ties.append(Tie(kind="in_front_of", anchors=(shelves.id,)))


def _load(members: Members, anchor: Member, kind: str) -> int:
    """How many things the anchor carries (or has beside it) already."""
    return sum(tie.kind == kind and anchor.id in tie.anchors for member in members.all for tie in member.ties)


def share(number: int, count: int, anchors: int) -> int:
    """Which anchor the `number`-th of `count` alike goes to."""
    return number * anchors // count if count >= anchors else number


def _add(members: Members, subject: Member, anchors: list[Member], relation: Relation, index: int, count: int) -> None:
    """Add a tie, or its mirror image to the anchor where the anchor already waits for the subject."""
    if _is_backing(relation, subject, anchors):
        _back(subject, anchors[0])
        return
    if relation.kind in ("between", "in_front_of", "opposite") or subject.mount == "floor":
        anchors = [members.support(anchor) or anchor for anchor in anchors]
    anchors = [anchor for anchor in dict.fromkeys(anchors) if anchor is not subject]
    free = [anchor for anchor in anchors if not members.depends(anchor, subject)]
    for anchor in anchors:
        mirrored = _MIRRORED.get(relation.kind)
        if (
            anchor not in free
            and mirrored
            and not any(subject.id in tie.anchors and tie.kind == mirrored for tie in anchor.ties)
        ):
            anchor.ties.append(Tie(kind=mirrored, anchors=(subject.id,), asked=relation.asked))
    if free:
        ids = tuple(anchor.id for anchor in free)
        kind = _meant(relation, subject, free, members)
        subject.ties.append(Tie(kind=kind, anchors=ids, index=index, count=count, asked=relation.asked))
        if kind in ("at_long_side", "at_short_side") and load_habits().is_in(subject.category, "seating"):
            subject.ties.append(Tie(kind="facing", anchors=ids, index=index, count=count, asked=relation.asked))


def _meant(relation: Relation, subject: Member, anchors: list[Member], members: Members) -> RelationKind:
    """A lone seat before or behind a desk that has none yet is the one that somebody works in: drawn up to it."""
    habits, desk = load_habits(), anchors[0]
    if relation.kind not in ("in_front_of", "behind") or len(anchors) > 1 or subject.request.count > 1:
        return relation.kind
    works = habits.is_in(subject.category, "chairs") and facts_of(desk.category).gaze == "back"
    taken = any(tie.kind == "at" and desk.id in tie.anchors for other in members.all for tie in other.ties)
    return "at" if works and not taken else relation.kind
