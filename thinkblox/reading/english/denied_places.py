"""Where things are not to be but elsewhere: "don't put lamps on the tables, they should stand on the floor"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_holding, is_link

_PRONOUNS = ("they", "them", "it", "these", "those", "one")
_REACH = 4
"""So many chunks at most from where a thing is not to be to where it is told to be."""
_PLACES = ("on", "in", "at", "near", "by", "against", "next_to", "under", "along", "on_top", "above", "behind")


def with_denied_places(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which things that are barred from one place and told to be at another are named at both."""
    made = _with_denials(_after_what_is_had(chunks))
    for at in range(len(made) - _REACH):
        no, thing, link, place = made[at : at + 4]
        if not isinstance(no, Connector) or not isinstance(thing, Noun) or not isinstance(place, Noun):
            continue
        barred = no.sort == "negations" and no.value in ("not", "exclude") and thing.kind == "thing"
        if not barred or thing.definite or not _is_place(link) or place.kind not in ("thing", "place", "pronoun"):
            continue
        told = _told_elsewhere(made, at + 4)
        if told < 0:
            continue
        pronoun, words = made[told], f"the {thing.text.split()[-1]}"
        if isinstance(pronoun, Noun) and pronoun.count:
            thing = replace(thing, count=pronoun.count, plural=pronoun.count > 1)
        made[at] = replace(thing, det="", start=min(no.start, thing.start))
        made[at + 1] = Connector("negations", "not", thing.end, thing.end, "are not" if thing.many else "is not")
        made[told] = replace(thing, start=pronoun.start, end=pronoun.end, text=words, det="the")
    return made


def _after_what_is_had(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks, with what something has before what it has not: "has no books but vases"."""
    made = list(chunks)
    for at in range(len(made) - 3):
        having, none = made[at : at + 2]
        if not isinstance(having, Connector) or not isinstance(none, Noun) or not _is_had_none(having, none):
            continue
        start = _past_but(made, at + 2)
        end = _list_end(made, start) if start > at + 2 else start
        if end > start:
            having = having if having.sort == "verbs" else replace(having, value="with", text="with")
            joint = Connector("joins", "and", none.start, none.start, "and")
            made[at:end] = [having, *made[start:end], joint, replace(none, det="no")]
    return made


def _is_had_none(having: Connector, none: Noun) -> bool:
    """Whether it is said that something has none of some things, which are no parts of it."""
    if none.kind != "thing" or none.word in grammar().lists["features"]:
        return False
    if is_holding(having) or is_link(having, "prepositions", "with"):
        return none.det == "no"
    return is_link(having, "prepositions", "without") and having.text.lower() == "with no"


def _list_end(chunks: Sequence[Chunk], start: int) -> int:
    """Where a list of things that are new ends with the sentence; `start` where none comes."""
    end = start
    while end < len(chunks) and not is_link(chunks[end], "mark", "stop", "semicolon"):
        said = chunks[end]
        thing = isinstance(said, Noun) and said.kind == "thing" and not said.definite
        if not (thing or (end > start and (is_link(said, "mark", "comma") or is_link(said, "joins", "and")))):
            return start
        end += 1
    return end


def _past_but(chunks: Sequence[Chunk], at: int) -> int:
    """Where it goes on after "but", ", only", ", just two"; `at` where none of these comes."""
    end = at + is_link(chunks[at], "mark", "comma")
    start = end
    while end < len(chunks) and (is_link(chunks[end], "joins", "but") or is_link(chunks[end], "negations", "only")):
        end += 1
    thing = chunk_at(chunks, end)
    only = isinstance(thing, Noun) and thing.text.lower().startswith(("only ", "just "))
    return end if end > start or only else at


def _with_denials(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks, with "not" before the thing of "no lamp on the table, it stands on the floor"."""
    made: list[Chunk] = []
    for at, chunk in enumerate(chunks):
        denied = isinstance(chunk, Noun) and chunk.kind == "thing" and chunk.det == "no" and at + 2 < len(chunks)
        if denied and isinstance(chunk, Noun) and _is_place(chunks[at + 1]) and _told_elsewhere(chunks, at + 3) > 0:
            made.append(Connector("negations", "not", chunk.start, chunk.start, "no"))
            chunk = replace(chunk, det="a" if not chunk.plural else "")
        made.append(chunk)
    return made


def _is_place(chunk: Chunk) -> bool:
    return is_link(chunk, "prepositions", *_PLACES)


def _told_elsewhere(chunks: Sequence[Chunk], at: int) -> int:
    """Where the pronoun stands of which it is said where it is to be; -1 where there is none."""
    but = is_link(chunk_at(chunks, at), "joins", "but")
    if at >= len(chunks) or not (but or is_link(chunks[at], "mark")):
        return -1
    for told in range(at + 1, min(at + _REACH, len(chunks))):
        said = chunks[told]
        if isinstance(said, Noun):
            counted = said.kind == "number" and said.count is not None and not (said.attributes or said.of_known)
            meant = counted or (said.kind == "pronoun" and said.text.lower() in _PRONOUNS)
            return told if meant and _is_put(chunks, told + 1) else -1
        there = is_link(said, "verbs", "be") and is_link(chunks[told - 1], "joins", "but")
        if not (is_link(said, "joins") or is_link(said, "fillers") or there):
            return -1
    return -1


def _is_put(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether it is said where something is."""
    while at < len(chunks) and (is_link(chunks[at], "fillers") or is_link(chunks[at], "verbs", "be", "stand", "put")):
        at += 1
    at += at < len(chunks) and is_link(chunks[at], "participles")
    return at < len(chunks) and _is_place(chunks[at])
