"""Numbers that are told of others' share: "ten pens between them", "six on each of two of them", "twelve more"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, filler
from thinkblox.reading.english.said import is_holding, is_link

_CARRYING = ("on", "on_top", "in", "inside", "at", "under", "above")


def with_shared_out(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks with the number there are in all in place of the number each of some has, and the noun after "more"."""
    made = list(chunks)
    for at, chunk in enumerate(chunks):
        if not isinstance(chunk, Noun):
            continue
        if chunk.kind == "pronoun" and _is_between_them(chunks, at):
            made[at - 1], made[at] = filler(chunks[at - 1]), filler(chunk)
        elif chunk.kind == "number" and _is_each_of_some(chunk) and at > 1:
            _multiply(made, at)
        elif chunk.kind == "number" and (same := _more_of(chunks, at)) is not None:
            text = f"{chunk.text} {same.text.split()[-1]}"
            made[at] = replace(chunk, kind="thing", value=same.value, called=same.called, text=text, plural=chunk.many)
    return made


def _is_between_them(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether several hold so many "between them", which says how many there are in all, and not where."""
    between, held = chunks[at - 1] if at else None, chunks[at - 2] if at > 1 else None
    them = chunks[at]
    told = isinstance(them, Noun) and them.value == "them" and is_link(between, "prepositions", "between")
    if not told or not isinstance(held, Noun) or held.kind != "thing":
        return False
    verb = next((n for n in range(at - 3, 0, -1) if not _is_listed(chunks[n])), 0)
    who = chunks[:verb][::-1]
    holders = next((c for c in who if isinstance(c, Noun) and c.kind == "thing"), None)
    return is_holding(chunks[verb]) and holders is not None and (held.count or 1) > (holders.count or 1)


def _is_listed(chunk: Chunk) -> bool:
    return isinstance(chunk, Noun) or is_link(chunk, "joins", "and") or is_link(chunk, "mark", "comma")


def _is_each_of_some(noun: Noun) -> bool:
    """Whether "each of two of them", "each of the other two" comes."""
    return (noun.count or 0) > 1 and noun.text.lower().startswith("each of ") and (noun.of_known or noun.det == "other")


def _multiply(made: list[Chunk], at: int) -> None:
    """Let what is on each of so many be so many times as many."""
    each, link, there = made[at], made[at - 1], made[at - 2]
    if not (isinstance(each, Noun) and isinstance(there, Noun) and there.kind == "thing"):
        return
    if is_link(link, "prepositions", *_CARRYING) and not there.definite and not there.each:
        made[at - 2] = replace(there, count=(there.count or 1) * (each.count or 1), plural=True, det="")


def _more_of(chunks: Sequence[Chunk], at: int) -> Noun | None:
    """Of what "the table carries twelve more": of the small things that were counted last."""
    more = chunks[at]
    told = isinstance(more, Noun) and more.text.lower().endswith(" more") and not more.attributes
    held = at > 0 and (is_holding(chunks[at - 1]) or is_link(chunks[at - 1], "prepositions", "with"))
    ends = at + 1 >= len(chunks) or isinstance(chunks[at + 1], Connector)
    if not (told and held and ends):
        return None
    named = (c for c in chunks[:at][::-1] if isinstance(c, Noun) and c.kind == "thing" and c.count and c.plural)
    return next((noun for noun in named if load_habits().is_in(noun.value, "small")), None)
