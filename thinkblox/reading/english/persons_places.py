"""What each person has or has beside them: "a mirror in front of each customer", "every employee has a headset"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_LYING = ("patient", "resident", "child", "infant", "baby", "newborn", "guest", "occupant", "soldier", "casualty")
"""Who may be in a bed."""
_SIDES = ("in_front_of", "behind", "next_to", "near", "at", "left_of", "right_of", "above")


def with_persons_places(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which each seat, desk or bed stands for whoever is at it, where there are several of those."""
    made = list(chunks)
    for at, person in enumerate(made):
        if not isinstance(person, Noun) or person.kind != "people":
            continue
        link, after = made[at - 1] if at else None, chunk_at(made, at + 1)
        owns = person.each and is_link(after, "verbs", "have")
        beside = person.each and is_link(link, "prepositions", *_SIDES)
        per = is_link(link, "prepositions", "per")
        place = _place(person, made[:at], owns=owns) if owns or beside or per else None
        # "A plate for each guest" is told of the seats of a table, or of so many people, by whoever reads clauses.
        if place is not None and (not per or _is(place, "beds")):
            text = f"{person.det} {place.word}".strip()
            made[at] = replace(person, kind="thing", value=place.value, called=place.called, text=text)
    return made


def _place(person: Noun, before: Sequence[Chunk], *, owns: bool) -> Noun | None:
    """What each of them is at: the last of several beds, desks or seats that were named."""
    several = [c for c in reversed(before) if isinstance(c, Noun) and c.kind == "thing" and c.many]
    if owns and any(_is(noun, "seats") or _is(noun, "chairs") for noun in several):
        return None  # Of what is told of seats so, whoever reads clauses makes one for each.
    groups: tuple[str, ...] = ("beds",) if person.word in _LYING else ()
    groups += ("desks",) if owns else ("seats", "chairs", "desks")
    return next((noun for group in groups for noun in several if _is(noun, group)), None)


def _is(noun: Noun, group: str) -> bool:
    return load_habits().is_in(noun.value, group)
