"""What is told of each of several just named: "two nightstands, each of which holds a lamp" is each with a lamp."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_holding, is_link

_EACH = "each of which"
_STANDING = ("be", "stand", "hang")
_TURNED = {"face": "facing", "face_away": "facing_away"}
_PAIR = 2


def with_each_of_which(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "each of which" is each of the several named right before, and of no more of their list."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        chunk, verb = chunks[at], chunk_at(chunks, at + 1)
        several = _several_before(made) if isinstance(chunk, (Noun, Connector)) else None
        if (length := _both_look(chunks, at, made)) > 0:
            looks = _look_of(chunks[at : at + length])
            made = [_looking(c, looks) if n in (len(made) - 2, len(made) - 4) else c for n, c in enumerate(made)][:-1]
            at += length
            continue
        length = _looks(chunks, at, several)
        if several is not None and length:
            made[-2] = replace(several, attributes=[*several.attributes, *_look_of(chunks[at : at + length])])
            at += length
            if is_link(chunk_at(chunks, at), "joins", "and"):
                made.append(Noun("pronoun", "each", chunk.start, chunk.start + 1, "each", det="each"))
                at += 1
            else:
                del made[-1]
        elif several is not None and isinstance(chunk, Noun) and chunk.text.lower() == _EACH:
            made += [replace(chunk, text="each"), *_plainly(verb, chunks[at + 2 : at + 3])]
            at += 2
        else:
            made.append(chunk)
            at += 1
    return made


def _both_look(chunks: Sequence[Chunk], at: int, made: Sequence[Chunk]) -> int:
    """How many chunks "both of which are white" has, after two single things that "and" joined; 0 where not so."""
    both, be, look = (*chunks[at : at + 3], None, None)[:3]
    told = isinstance(both, Noun) and both.text.lower() == "both of which" and is_link(be, "verbs", "be")
    if not told or not isinstance(look, Adjective) or len(made) < len(("one", "and", "other", ",")):
        return 0
    one, joint, other, comma = made[-4:]
    two = [c for c in (one, other) if isinstance(c, Noun) and c.kind == "thing" and not c.many]
    joined = is_link(joint, "joins", "and") and is_link(comma, "mark", "comma") and len(two) == _PAIR
    ends = at + 3 >= len(chunks) or is_link(chunks[at + 3], "mark")
    return 3 if joined and ends and _look_of(chunks[at : at + 3]) else 0


def _looking(chunk: Chunk, looks: list[str]) -> Chunk:
    return replace(chunk, attributes=[*chunk.attributes, *looks]) if isinstance(chunk, Noun) else chunk


def _several_before(made: Sequence[Chunk]) -> Noun | None:
    """The several that were named right before a comma; None where none were."""
    several = made[-2] if len(made) > 1 and is_link(made[-1], "mark", "comma") else None
    return several if isinstance(several, Noun) and several.kind == "thing" and several.many else None


def _looks(chunks: Sequence[Chunk], at: int, several: Noun | None) -> int:
    """How many chunks say what each of them is like, and nothing else: "each white", "each of which is white"."""
    chunk = chunks[at]
    if several is None:
        return 0
    if isinstance(chunk, Noun) and chunk.kind == "pronoun" and chunk.value == "each":
        length = 1 if chunk.attributes else 3 if is_link(chunk_at(chunks, at + 1), "verbs", "be") else 0
    else:
        both = isinstance(chunk, Connector) and chunk.sort == "fillers" and chunk.text.lower() == "both"
        length = _PAIR if both and several.count == _PAIR else 0
    more = is_link(chunk_at(chunks, at + length), "joins", "and") and not isinstance(
        chunk_at(chunks, at + length + 1), Noun
    )
    ends = is_link(chunk_at(chunks, at + length), "mark") or more or at + length >= len(chunks)
    return length if length and ends and _look_of(chunks[at : at + length]) else 0


def _look_of(chunks: Sequence[Chunk]) -> list[str]:
    last = chunks[-1]
    plain = isinstance(last, (Adjective, Noun)) and not (last.unshown or last.states or last.styles)
    alone = isinstance(last, Adjective) or (isinstance(last, Noun) and last.kind == "pronoun")
    return last.attributes if plain and alone and isinstance(last, (Adjective, Noun)) else []


def _plainly(verb: Chunk | None, after: Sequence[Chunk]) -> list[Chunk]:
    """What says the same as a verb without one: "with" for "has", nothing for "is" before where that is."""
    if not isinstance(verb, Connector):
        return [verb] if verb is not None else []
    if is_holding(verb):
        return [replace(verb, sort="prepositions", value="with")]
    if is_link(verb, "verbs", *_TURNED):
        return [replace(verb, sort="prepositions", value=_TURNED[verb.value])]
    placed = bool(after) and (is_link(after[0], "prepositions") or is_link(after[0], "participles"))
    return [] if is_link(verb, "verbs", *_STANDING) and placed else [verb]
