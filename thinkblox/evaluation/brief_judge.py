"""Whether a brief asks for what its prompt demands: the reading alone, before anything is placed."""

import tomllib
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from importlib.resources import files
from typing import Any

from msgspec import structs

from thinkblox.assets.catalogue import CATALOGUE
from thinkblox.brief import Brief, Relation
from thinkblox.evaluation.annotations import Annotation, Count, ElementRelation, ObjectRelation, Row
from thinkblox.evaluation.matching import is_kind_of, match, names_of
from thinkblox.evaluation.relation_words import Element, element, element_rule, object_rules
from thinkblox.evaluation.tallies import JudgedRow
from thinkblox.evaluation.vocabulary import Vocabulary, load_vocabulary, plain
from thinkblox.reading.lexicon import load

_TABLE = "reading_table.toml"
_PLACES: dict[Element, tuple[str, ...]] = {
    "wall": ("wall",),
    "door": ("door",),
    "window": ("window",),
    "ceiling": ("ceiling",),
    "floor": ("floor",),
    "corner": ("corner",),
    "room": ("centre", "middle", "corner", "room", "wall"),
}
_OPENINGS: tuple[Element, ...] = ("door", "window")
"""What a relation to a wall says nothing of."""
_ROOM_TOLERANCE = 0.06
"""By how much a side of a room may differ, for feet that were rounded [m]."""


def judge_brief(annotation: Annotation, brief: Brief) -> tuple[JudgedRow, ...]:
    """A row for each count, relation, exclusion and fact of the room that the prompt demands.

    Whether a demanded relation would hold in a room is not asked here, only whether the brief has it: of these kinds of
    objects, of a kind of relation that asks for it, and for as many.
    """
    reading = _Reading(brief, annotation)
    rows = [reading.count(row) for row in annotation.counts]
    rows += [reading.object_relation(row) for row in annotation.object_relations]
    rows += [reading.element_relation(row) for row in annotation.element_relations]
    rows += [reading.absence(category) for category in annotation.absent]
    return (*rows, *_room_rows(annotation, brief))


@cache
def _table() -> dict[str, Any]:
    return tomllib.loads(files("thinkblox.evaluation").joinpath(_TABLE).read_text("utf-8"))


class _Reading:
    """A brief as seen from the demands: which request is for which demanded category."""

    def __init__(self, brief: Brief, annotation: Annotation) -> None:
        self._brief = brief
        self._vocabulary: Vocabulary = load_vocabulary()
        self._names = {r.key: names_of(r.category, r.phrase) for r in brief.requests}
        self._counts = {r.key: r.count for r in brief.requests}
        self._of = match(self._names, annotation, self._vocabulary)
        self._relations = _with_stacked([r for r in brief.relations if not r.negated], self._names)
        self._assumed = {r.key for r in brief.requests if not r.asked}

    def count(self, row: Count) -> JudgedRow:
        keys = self._of[row.category]
        found = self._amount(keys)
        met = row.met_by(found)
        says = f"asks for {found} ({', '.join(keys)})" if keys else f"asks for none{self._lost(row.category)}"
        extra = max(0, found - row.most) if row.most is not None else 0
        return JudgedRow(
            kind="count",
            demand=str(row),
            met=met,
            says=says,
            asked=row.least,
            found=min(found, row.least),
            extra=extra,
        )

    def absence(self, category: str) -> JudgedRow:
        demanded = {key for keys in self._of.values() for key in keys}
        there = [
            key
            for key, names in self._names.items()
            if key not in demanded and is_kind_of(names, category, self._vocabulary)
        ]
        says = f"asks for {', '.join(there)}" if there else "asks for none"
        return JudgedRow(kind="absent", demand=f"no {category}", met=not there, says=says)

    def object_relation(self, row: ObjectRelation) -> JudgedRow:
        anchors, subjects = self._of[row.anchor], tuple(k for s in row.subjects for k in self._of[s])
        missing = [c for c in dict.fromkeys((row.anchor, *row.subjects)) if not self._of[c]]
        rules = object_rules(row.relation)
        if missing or not rules:
            why = f"not asked for: {', '.join(missing)}" if missing else f"no rule for {row.relation!r}"
            return _relation_row("object relation", row, row.relation, None if not rules else False, why)
        subjects, anchors = self._with_carriers(subjects), self._with_carriers(anchors)
        found = [self._between(_table()["objects"][rule], subjects, anchors) for rule in rules]
        amounts = {amount for relations in found for amount in self._amounts(relations, subjects, anchors)}
        amounts |= {amount // len(row.subjects) for amount in amounts}
        met = not any(found) if row.number == 0 else all(found) and any(row.met_by(a) for a in amounts)
        return _relation_row("object relation", row, row.relation, met, self._says(found, [*subjects, *anchors]))

    def element_relation(self, row: ElementRelation) -> JudgedRow:
        keys, part = self._of[row.category], element(row.element)
        rule = element_rule(row.relation, part)
        if not keys or rule is None or rule not in _table()["elements"]:
            why = f"not asked for: {row.category}" if not keys else f"no rule for {row.relation!r}"
            return _relation_row("architecture", row, row.relation, False if not keys else None, why)
        entry = _table()["elements"][rule]
        placed = [r for r in self._relations if _names_place(r, entry["kinds"], part)]
        keys = keys if any(r.subject in keys for r in placed) else self._with_carriers(keys)
        found = [r for r in placed if r.subject in keys]
        stand = tuple(dict.fromkeys(r.subject for r in found))
        stand += tuple(key for key in keys if key not in stand and self._mount(key) in entry["mounts"])
        amounts = {self._amount(stand), len(found)} if stand else {0}
        met = any(row.met_by(amount) for amount in amounts) if row.number else not found
        return _relation_row("architecture", row, row.relation, met, self._says([found], keys))

    def _with_carriers(self, keys: tuple[str, ...]) -> tuple[str, ...]:
        """What the brief adds to carry these counts for them: a cabinet under a sink stands where the sink does."""
        carriers = [a for r in self._relations if r.kind == "on" and r.subject in keys for a in r.anchors]
        return (*keys, *(a for a in dict.fromkeys(carriers) if a in self._assumed and a not in keys))

    def _between(self, entry: dict[str, list[str]], subjects: Sequence[str], anchors: Sequence[str]) -> list[Relation]:
        return [
            r
            for r in self._relations
            if (r.kind in entry["same"] and r.subject in subjects and set(r.anchors) & set(anchors))
            or (r.kind in entry["inverse"] and r.subject in anchors and set(r.anchors) & set(subjects))
        ]

    def _amounts(self, found: Sequence[Relation], subjects: Sequence[str], anchors: Sequence[str]) -> set[int]:
        """The numbers of pairs that the relations may mean: one for each subject, for each anchor, or for each of both.

        A brief does not say which of several tables a chair stands at.
        """
        named = {key for r in found for key in (r.subject, *r.anchors)}
        of_subjects = self._amount(key for key in dict.fromkeys(subjects) if key in named)
        of_anchors = self._amount(key for key in anchors if key in named)
        return {of_subjects, of_anchors, of_subjects * of_anchors, len(found)}

    def _amount(self, keys: Iterable[str]) -> int:
        return sum(self._counts[key] for key in keys)

    def _mount(self, key: str) -> str:
        category = CATALOGUE.get(self._names[key][0])
        return "" if category is None else category.mount

    def _says(self, found: Sequence[Sequence[Relation]], keys: Iterable[str]) -> str:
        """What of the brief meets the demand, or else everything that it says of these objects."""
        if found and all(found):
            return "; ".join(_in_words(r, self._counts) for relations in found for r in relations)
        others = [r for r in self._relations if r.subject in set(keys)]
        return (
            f"has only {'; '.join(_in_words(r, self._counts) for r in others)}"
            if others
            else "has no relation of these"
        )

    def _lost(self, category: str) -> str:
        """Where a thing that is not asked for ended, if its name is found there."""
        words = set(plain(category).split())
        brief = self._brief
        for where, texts in (("missing", brief.missing), ("beyond", brief.beyond), ("unknown", brief.unknown)):
            for text in texts:
                if words & set(plain(text).split()):
                    return f", {where} has {text!r}"
        return ""


def _with_stacked(relations: list[Relation], names: Mapping[str, Sequence[str]]) -> list[Relation]:
    """The relations, and for what lies on another of its kind those of the other: a stack is where its lowest is."""
    found = list(relations)
    for r in relations:
        below = r.anchors[0] if r.kind == "on" and len(r.anchors) == 1 else ""
        if below in names and names[below][0] == names[r.subject][0]:
            found += [structs.replace(other, subject=r.subject) for other in found if other.subject == below]
    return found


def _relation_row(kind: Any, row: Row, about: str, met: bool | None, says: str) -> JudgedRow:
    return JudgedRow(kind=kind, demand=str(row), met=met, says=says, about=about)


def _names_place(relation: Relation, kinds: Sequence[str], part: Element) -> bool:
    if relation.kind not in kinds:
        return False
    if part not in _OPENINGS and relation.kind.endswith(("_wall", "_corner", "_centre", "_room", "_ceiling")):
        return True
    return any(place in anchor for anchor in relation.anchors for place in _PLACES[part])


def _in_words(relation: Relation, counts: dict[str, int]) -> str:
    each = " each" if relation.each else ""
    subject = f"{counts.get(relation.subject, 1)} {relation.subject}"
    return f"{subject} {relation.kind} {', '.join(relation.anchors)}{each}".rstrip()


def _type_of_room(kind: str) -> str:
    """What type of room a demanded kind is by the words for those: a study is a home office."""
    words = load("en")
    tokens = words.tokens(kind)
    found = words.longest(tokens, 0)
    entry = found.entry("room") if found.length == len(tokens) else None
    return entry.value if entry is not None else kind


def _room_rows(annotation: Annotation, brief: Brief) -> list[JudgedRow]:
    rows, demand = [], annotation.room
    if demand.kind:
        asked, read = plain(demand.kind), plain(brief.room_type)
        met = asked == read or asked.endswith(f" {read}") or read.endswith(f" {asked}")
        met |= plain(_type_of_room(demand.kind)) == read
        rows.append(JudgedRow(kind="room", about="kind", demand=asked, met=met, says=f"reads a {read}"))
    if demand.size is not None:
        sides = sorted(s for s in (brief.width, brief.depth) if s is not None)
        met = len(sides) == 2 and all(
            abs(a - b) <= _ROOM_TOLERANCE for a, b in zip(sorted(demand.size), sides, strict=True)
        )
        says = " x ".join(f"{side:g}" for side in sides) or "no size"
        wanted = " x ".join(f"{side:g}" for side in demand.size)
        rows.append(JudgedRow(kind="room", about="size", demand=wanted, met=met, says=f"reads {says}"))
    if demand.shape is not None:
        met = brief.shape == demand.shape or demand.shape in brief.style
        rows.append(JudgedRow(kind="room", about="shape", demand=demand.shape, met=met, says=f"reads {brief.shape}"))
    return rows
