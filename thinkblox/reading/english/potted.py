"""Plants in pots, which are one thing: "a fern in a clay pot", "two pots with cacti"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Connector, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link

_POTS = ("pot", "flowerpot")
_ANY = "any_"
"""How general words begin that are taken for one thing or another later."""


def with_potted(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a plant and the pot that it is in are the plant; what that pot is like is not shown."""
    made: list[Chunk] = []
    for chunk in chunks:
        made.append(chunk)
        if len(made) > 2 and (potted := _potted(*made[-3:])) is not None:
            made[-3:] = [potted]
    return made


def _potted(first: Chunk, link: Chunk, second: Chunk) -> Noun | None:
    """The plant of "a fern in a pot", "a pot with a fern"; None for anything else."""
    if not isinstance(first, Noun) or not isinstance(second, Noun) or not isinstance(link, Connector):
        return None
    if _is_plant(first) and _is_pot(second) and is_link(link, "prepositions", "in"):
        return replace(first, end=second.end, unshown=[*first.unshown, *_look(second)])
    holds = is_link(link, "prepositions", "with") or is_link(link, "participles", "inside", "hold")
    if not (_is_pot(first) and _is_plant(second) and (holds or is_link(link, "inverses", "inside"))):
        return None
    if second.count not in (None, 1):
        return None
    seen = [*second.unshown, *_look(first)]
    return replace(second, start=first.start, det=first.det, count=first.count, plural=first.plural, unshown=seen)


def _is_pot(noun: Noun) -> bool:
    growing = noun.value.startswith(_ANY) or load_habits().is_in(noun.value, "plants")
    return noun.kind == "thing" and growing and noun.word in _POTS and not noun.definite


def _is_plant(noun: Noun) -> bool:
    grows = load_habits().is_in(noun.value, "plants") or noun.word in grammar().lists["potted"]
    return noun.kind == "thing" and grows and noun.word not in _POTS


def _look(pot: Noun) -> list[str]:
    """What is said of the pot itself."""
    return [f"in {pot.text.lower()}"] if pot.attributes or pot.unshown or pot.size else []
