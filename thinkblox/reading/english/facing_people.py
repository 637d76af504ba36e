"""People whom things face: "the teacher's desk faces the students", who sit at desks; others are not understood."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, Stray
from thinkblox.reading.english.said import is_link

_SEATED = ("desks", "seats", "chairs", "tables")
_TOGETHER = ("class", "audience", "congregation", "crowd", "public", "room")
"""Words for several people, besides those for people."""


def with_facing_people(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what faces several people faces the desks or chairs that were named for these."""
    made = list(chunks)
    for at in range(len(made) - 1):
        link, people = made[at : at + 2]
        if not isinstance(link, Connector) or not isinstance(people, Noun) or not _is_facing(link, people):
            continue
        seats = _seats_of(made, at) if _are_several(people) else None
        if seats is None:
            made[at] = Stray(link.start, people.end, f"{link.text} {people.text}")
            made[at + 1] = Connector("fillers", "words", people.end, people.end)
        else:
            text = f"the {seats.text.split()[-1]}"
            told = replace(seats, start=people.start, end=people.end, det="the", text=text, count=None, plural=True)
            made[at + 1] = replace(told, rows=0, states=[], unshown=[], size=None)
    return made


def _is_facing(link: Connector, people: Noun) -> bool:
    facing = is_link(link, "verbs", "face") or is_link(link, "prepositions", "facing")
    several = people.kind == "abstract" and people.word in _TOGETHER
    return facing and people.definite and (people.kind == "people" or several)


def _are_several(people: Noun) -> bool:
    return people.word in _TOGETHER or people.text.lower().endswith(("s", "children", "people"))


def _seats_of(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """The several desks or chairs that were named before, besides what faces them."""
    named = [c for c in chunks[:at] if isinstance(c, Noun) and c.kind == "thing"]
    seats = (c for c in named[:-1] if c.many and load_habits().is_in(c.value, *_SEATED))
    return next(seats, None)
