"""Whether a finished room is what its prompt demands, row by row."""

from collections.abc import Sequence
from itertools import chain
from math import comb
from typing import Any

from thinkblox.evaluation import element_rules, object_rules
from thinkblox.evaluation.annotations import Annotation, Attribute, Count, ElementRelation, ObjectRelation, RoomDemand
from thinkblox.evaluation.attributes import NOT_SHOWN, shows, what_shows
from thinkblox.evaluation.bodies import Body
from thinkblox.evaluation.matching import is_kind_of, match, names_of
from thinkblox.evaluation.relation_words import ObjectRule, element, element_rule
from thinkblox.evaluation.relation_words import object_rules as rules_for
from thinkblox.evaluation.resting import lies_on
from thinkblox.evaluation.room_file import SceneRecord
from thinkblox.evaluation.ruling import Ruling
from thinkblox.evaluation.tallies import JudgedRow
from thinkblox.evaluation.vocabulary import load_vocabulary
from thinkblox.evaluation.walls import Enclosure

SIZE_TOLERANCE = 0.06
"""By how much a side of the floor may differ, for feet that were rounded [m]."""
_LISTED = 4


def judge_room(annotation: Annotation, scene: SceneRecord) -> tuple[JudgedRow, ...]:
    """A row for everything that the prompt demands, but for the kind of room, which no geometry shows."""
    judge = _RoomJudge(scene, annotation)
    rows = [judge.count(row) for row in annotation.counts]
    rows += [judge.attribute(row) for row in annotation.attributes]
    rows += [judge.object_relation(row) for row in annotation.object_relations]
    rows += [judge.element_relation(row) for row in annotation.element_relations]
    rows += [judge.absence(category) for category in annotation.absent]
    return (*rows, *_floor_rows(annotation.room, scene))


class _RoomJudge:
    def __init__(self, scene: SceneRecord, annotation: Annotation) -> None:
        self._room = Enclosure(scene.room)
        self._bodies = {p.id: Body(p, scene.assets[p.asset]) for p in scene.placements}
        self._names = {b.id: names_of(b.asset.category, b.asset.description) for b in self._bodies.values()}
        self._vocabulary = load_vocabulary()
        self._of = match(self._names, annotation, self._vocabulary)

    def count(self, row: Count) -> JudgedRow:
        """How many objects count for the category."""
        ids = self._of[row.category]
        extra = max(0, len(ids) - row.most) if row.most is not None else 0
        says = f"{len(ids)} there" + (f": {_list(ids)}" if ids else "")
        found = min(len(ids), row.least)
        return JudgedRow(
            kind="count",
            demand=str(row),
            met=row.met_by(len(ids)),
            says=says,
            asked=row.least,
            found=found,
            extra=extra,
        )

    def attribute(self, row: Attribute) -> JudgedRow:
        """How many objects of the category have all the attributes that can be seen."""
        seen = {
            b.id: [shows(b, word, row.category, self._room) for word in row.attributes] for b in self._all(row.category)
        }
        shown_by, demand = [what_shows(word) for word in row.attributes], str(row)
        about = " and ".join(sorted(set(shown_by))) if all(shown_by) else "state or style"
        if not all(shown_by) or any(s.holds is None for s in chain.from_iterable(seen.values())):
            return JudgedRow(kind="attribute", about=about, demand=demand, met=None, says=NOT_SHOWN)
        if not seen:
            return JudgedRow(kind="attribute", about=about, demand=demand, met=False, says="none there")
        having = [id for id, shown in seen.items() if all(s.holds for s in shown)]
        lacking = [f"{id}: {'; '.join(s.says for s in shown)}" for id, shown in seen.items() if id not in having]
        says = f"{len(having)} of {len(seen)}" + (f" ({_list(lacking)})" if lacking else "")
        return JudgedRow(kind="attribute", about=about, demand=demand, met=row.met_by(len(having)), says=says)

    def object_relation(self, row: ObjectRelation) -> JudgedRow:
        """In how many groups of one anchor and its subjects the relation holds, counted as SceneEval counts them."""
        rules = rules_for(row.relation)
        if not rules:
            return _relation_row("object relation", row, None, "no rule for this relation")
        needed = (row.anchor, *row.subjects)
        missing = [
            c for c in dict.fromkeys(needed) if len(self._of[c]) < (1 if c == row.anchor else row.subjects.count(c))
        ]
        if missing:
            return _relation_row("object relation", row, False, f"not there: {', '.join(missing)}")
        wanted = {category: row.subjects.count(category) for category in dict.fromkeys(row.subjects)}
        groups, found = 0, []
        for anchor in self._all(row.anchor):
            others = {c: [b for b in self._all(c) if b is not anchor] for c in wanted}
            look = _round_about if "surround" in rules else _one_by_one
            number, seen = look(rules, anchor, others, wanted, self._room)
            groups += number
            found += seen
        return _counted("object relation", row, groups, found)

    def element_relation(self, row: ElementRelation) -> JudgedRow:
        """Of how many objects the relation to the part of the room holds."""
        part = element(row.element)
        rule = element_rule(row.relation, part)
        if rule is None:
            return _relation_row("architecture", row, None, "no rule for this relation")
        if not self._of[row.category]:
            return _relation_row("architecture", row, False, f"not there: {row.category}")
        found = [(b.id, element_rules.holds(rule, b, part, self._room)) for b in self._all(row.category)]
        return _counted("architecture", row, sum(ruling.holds for _, ruling in found), found)

    def absence(self, category: str) -> JudgedRow:
        """Whether nothing is there that is of the category and counts for no demanded one."""
        demanded = {id for ids in self._of.values() for id in ids}
        there = [
            id
            for id, names in self._names.items()
            if id not in demanded and is_kind_of(names, category, self._vocabulary)
        ]
        says = f"there: {_list(there)}" if there else "not there"
        return JudgedRow(kind="absent", demand=f"no {category}", met=not there, says=says)

    def _all(self, category: str) -> list[Body]:
        return [self._bodies[id] for id in self._of[category]]


Seen = list[tuple[str, Ruling]]
"""What was looked at, in words, and what came of it."""


def _one_by_one(
    rules: Sequence[ObjectRule],
    anchor: Body,
    others: dict[str, list[Body]],
    wanted: dict[str, int],
    room: Enclosure,
) -> tuple[int, Seen]:
    """In how many ways the wanted subjects can be chosen so that each stands in the relation to the anchor."""
    seen: Seen = []
    groups = 1
    for category, bodies in others.items():
        rulings = [(f"{b.id} -> {anchor.id}", _all_hold(rules, anchor, (b,), room)) for b in bodies]
        rulings = _with_stacked(rulings, bodies) if tuple(rules) == ("on_top",) else rulings
        groups *= comb(sum(ruling.holds for _, ruling in rulings), wanted[category])
        seen += rulings
    return groups, seen


def _with_stacked(rulings: Seen, bodies: Sequence[Body]) -> Seen:
    """The rulings, in which what lies on another of its kind is where that one is, as in a stack."""
    found = list(rulings)
    there: list[Body] = []
    for at in sorted(range(len(bodies)), key=lambda at: bodies[at].low):
        body, (who, ruling) = bodies[at], found[at]
        below = None if ruling.holds else next((b for b in there if lies_on(body, b).holds), None)
        if below is not None:
            found[at] = (who, Ruling(True, f"on {below.id}, which is"))
        there += [body] if found[at][1].holds else []
    return found


def _round_about(
    rules: Sequence[ObjectRule],
    anchor: Body,
    others: dict[str, list[Body]],
    wanted: dict[str, int],
    room: Enclosure,
) -> tuple[int, Seen]:
    """Whether the nearest of the wanted subjects stand round the anchor.

    Of sixteen chairs at four tables, four can be chosen in 1820 ways, none of which but one is meant for a table.
    """
    chosen = [body for category, bodies in others.items() for body in _nearest(anchor, bodies, wanted[category])]
    if len(chosen) < sum(wanted.values()):
        return 0, []
    ruling = _all_hold(rules, anchor, chosen, room)
    return int(ruling.holds), [(f"{', '.join(body.id for body in chosen)} -> {anchor.id}", ruling)]


def _nearest(anchor: Body, bodies: Sequence[Body], number: int) -> list[Body]:
    def away(body: Body) -> float:
        return float(anchor.footprint.distance(body.footprint))

    return sorted(bodies, key=away)[:number]


def _all_hold(rules: Sequence[ObjectRule], anchor: Body, subjects: Sequence[Body], room: Enclosure) -> Ruling:
    found = [object_rules.holds(rule, anchor, subjects, room) for rule in rules]
    return Ruling(all(f.holds for f in found), "; ".join(f.says for f in found))


def _counted(kind: Any, row: ObjectRelation | ElementRelation, number: int, found: Seen) -> JudgedRow:
    holding = [who for who, ruling in found if ruling.holds]
    met = row.met_by(number)
    others = [f"{who}: {ruling.says}" for who, ruling in found if not ruling.holds]
    says = f"holds for {number}" + (f" ({_list(holding)})" if holding else "")
    if not met and others:
        says += f"; not for {_list(others)}"
    return _relation_row(kind, row, met, says)


def _relation_row(kind: Any, row: ObjectRelation | ElementRelation, met: bool | None, says: str) -> JudgedRow:
    return JudgedRow(kind=kind, about=row.relation, demand=str(row), met=met, says=says)


def _list(items: Sequence[str]) -> str:
    shown = ", ".join(items[:_LISTED])
    return shown if len(items) <= _LISTED else f"{shown} and {len(items) - _LISTED} more"


def _floor_rows(demand: RoomDemand, scene: SceneRecord) -> list[JudgedRow]:
    rows: list[JudgedRow] = []
    x0, y0, x1, y1 = Enclosure(scene.room).floor.bounds
    if demand.size is not None:
        pairs = zip(sorted(demand.size), sorted((x1 - x0, y1 - y0)), strict=True)
        met = all(abs(asked - made) <= SIZE_TOLERANCE for asked, made in pairs)
        wanted = " x ".join(f"{side:g}" for side in demand.size)
        rows.append(
            JudgedRow(kind="room", about="size", demand=f"{wanted} m", met=met, says=f"{x1 - x0:g} x {y1 - y0:g} m")
        )
    if demand.shape is not None:
        corners = len(scene.room.floor)
        shape = {4: "rectangle", 6: "L"}.get(corners, f"{corners} corners")
        square = shape == "rectangle" and abs((x1 - x0) - (y1 - y0)) <= SIZE_TOLERANCE
        met = shape == demand.shape or (square and demand.shape == "square")
        says = "square" if square else shape
        rows.append(JudgedRow(kind="room", about="shape", demand=demand.shape, met=met, says=says))
    return rows
