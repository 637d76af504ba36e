"""What also is somewhere: "on the desk is a pen. Also on it is a mug", "a sink beside it, also in a corner"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_MORE = ("also", "too", "as well")
_BESIDE = ("next_to", "near", "left_of", "right_of", "in_front_of", "opposite", "under", "above")
_PLACES = ("against", "along", "on", "in", "by", "near", "under", "next_to")
_HAD = 7
"""So many chunks tell of what a thing has where it also is."""
_MOST = 8
"""Most chunks of a sentence that ends with "too"."""


def with_also_there(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "on it", where there is more than was told before, is on the large thing that was named last."""
    made = list(chunks)
    for at in range(2, len(made)):
        it = made[at]
        if (
            not isinstance(it, Noun)
            or it.value != "it"
            or not is_link(made[at - 1], "prepositions", "on", "on_top", "in")
        ):
            continue
        before = at - 2 - _is_more(made[at - 2])
        begins = before >= 0 and is_link(made[before], "mark", "stop", "semicolon")
        if not begins or not (before < at - 2 or _goes_on(made, at + 1)):
            continue
        named = (c for c in reversed(made[:before]) if isinstance(c, Noun) and c.kind == "thing")
        large = next((noun for noun in named if not load_habits().is_in(noun.value, "small")), None)
        if large is not None and not large.many:
            text = f"the {large.word}"
            made[at] = replace(large, start=it.start, end=it.end, det="the", count=None, text=text)
    for at in range(len(made) - _HAD, -1, -1):
        had, thing, beside, it, comma, also, link = made[at : at + _HAD]
        if not (
            (is_link(had, "prepositions", "with") or is_link(had, "verbs", "have"))
            and isinstance(thing, Noun)
            and (thing.kind, thing.det) == ("thing", "a")
            and is_link(beside, "prepositions", *_BESIDE)
            and isinstance(it, Noun)
            and it.value == "it"
            and is_link(comma, "mark", "comma")
            and _is_more(also)
            and is_link(link, "prepositions", *_PLACES)
        ):
            continue
        said = replace(thing, start=also.start, end=also.start, det="the", text=f"the {thing.word}", fates={})
        stop = Connector("mark", "semicolon", comma.start, comma.end, ";")
        made[at + 4 : at + 6] = [stop, said, Connector("verbs", "be", also.start, also.end, "also")]
    return made


def _is_more(chunk: Chunk | None) -> bool:
    return isinstance(chunk, Connector) and chunk.text.lower() in _MORE


def _goes_on(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "also" comes after the verb, or "too" at the end of the sentence."""
    if is_link(chunk_at(chunks, at), "verbs", "be", "stand") and _is_more(chunk_at(chunks, at + 1)):
        return True
    ends = (n for n in range(at, min(at + _MOST, len(chunks))) if is_link(chunks[n], "mark"))
    end = next(ends, len(chunks))
    return _is_more(chunks[end - 1])
