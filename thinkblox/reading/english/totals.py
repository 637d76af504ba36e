"""Numbers that only sum up what was said: "four chairs at each of three tables, twelve chairs in all"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_SUMMED = ("in all", "in total", "altogether", "all told", "all together", "overall", "combined")
_TOTAL = "a total of "


def with_totals(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a sum of things that were named is a number, and asks for no more of them."""
    made = list(chunks)
    named: set[str] = set()
    for at, noun in enumerate(made):
        if not isinstance(noun, Noun) or noun.kind != "thing":
            continue
        after = chunk_at(made, at + 1)
        summed = noun.text.lower().startswith(_TOTAL)
        summed |= isinstance(after, Connector) and after.text.lower() in _SUMMED
        if summed and noun.count and noun.value in named and not noun.of_known:
            made[at] = replace(noun, kind="number", value="", det="", attributes=[], unshown=[], states=[])
            link = made[at - 1]
            if isinstance(link, Connector) and is_link(link, "prepositions", "for"):
                made[at - 1] = Connector("mark", "comma", link.start, link.end, link.text)
        named.add(noun.value)
    return made
