"""What is told of a thing right after its name: "my desk, the white one", "books, six of them", "the stove itself"."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.assets.palette import COLOURS
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, chunk_at, filler
from thinkblox.reading.english.said import is_holding, is_link, part_start

_ITSELF = ("itself", "themselves")
_ONES = (" one", " ones")
_OF_THEM = (" of them", " of those", " of these")


def with_told_besides(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a thing looks, and is as many, as is told after its name; "a cushion each" is one for each."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        thing = made[-1] if made else None
        chunk = chunks[at]
        if not isinstance(thing, Noun) or thing.kind != "thing":
            made.append(chunk)
            at += 1
        elif isinstance(chunk, Noun) and chunk.text.lower() in _ITSELF:
            made.append(filler(chunk))
            at += 1
        elif (told := _told(chunks, at, thing)) is not None:
            made[-1] = told
            at += 2
        elif (upright := _called_so(chunks, at)) is not None:
            made += [chunk, upright]
            at += 2
        else:
            made.append(chunk)
            at += 1
    return _with_each_apart(_with_each_before(_with_new_things(_with_ones_named(_with_ones_there(made)))))


def _told(chunks: Sequence[Chunk], at: int, thing: Noun) -> Noun | None:
    """The thing with the look of ", the white one" or the number of ", six of them"; None for anything else."""
    comma, one, after = (*chunks[at : at + 3], None, None, None)[:3]
    if not is_link(comma, "mark", "comma", "dash") or not isinstance(one, Noun) or one.kind != "number":
        return None
    if not (after is None or is_link(after, "mark") or is_link(after, "joins")):
        return None
    text = one.text.lower()
    if text.endswith(_OF_THEM) and one.count and thing.plural and thing.count is None and not thing.definite:
        return replace(thing, count=one.count)
    plain = one.det == "the" and text.endswith(_ONES) and not (one.ordinal or one.side or one.degree or one.of_known)
    if plain and (one.attributes or one.unshown) and thing.definite and not thing.attributes and not thing.many:
        return replace(
            thing,
            attributes=[*one.attributes],
            unshown=[*thing.unshown, *one.unshown],
            states=[*thing.states, *one.states],
        )
    return None


def _called_so(chunks: Sequence[Chunk], at: int) -> Adjective | None:
    """What ", a black upright," says of the thing before, where nothing is known by that name."""
    comma, other, end = (*chunks[at : at + 3], None, None, None)[:3]
    if not is_link(comma, "mark", "comma") or not is_link(end, "mark", "comma") or not isinstance(other, Noun):
        return None
    strange = other.det == "a" and not other.named and not other.many and other.kind == "thing"
    if not strange or not is_link(chunk_at(chunks, at + 3), "verbs"):
        return None
    return Adjective(
        other.start,
        other.end,
        other.text,
        [*other.attributes],
        [*other.styles],
        [*other.unshown, other.word],
        [*other.states],
    )


def _with_ones_there(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with the chairs of "behind it is a leather chair, and in front of it are two wooden ones"."""
    made = list(chunks)
    there: Noun | None = None
    for at in range(1, len(made)):
        chunk = made[at]
        if not isinstance(chunk, Noun) or not is_link(made[at - 1], "verbs", "be", "stand", "hang"):
            continue
        looks = bool(chunk.attributes or chunk.unshown) and chunk.text.lower().endswith((" one", " ones"))
        plain = (
            looks and chunk.kind == "number" and not (chunk.definite or chunk.of_known or chunk.ordinal or chunk.side)
        )
        if plain and there is not None and is_link(made[part_start(made, at - 1)], "prepositions"):
            text = f"{chunk.text.rpartition(' ')[0]} {there.word}"
            made[at] = replace(
                chunk, kind="thing", value=there.value, called=there.called, named=there.named, text=text
            )
        elif chunk.kind == "thing" and not chunk.definite:
            there = chunk
    return made


def _with_ones_named(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with the rug of "a red rug lies under the table, a blue one in front of the sofa"."""
    made = list(chunks)
    named: list[Noun] = []
    for at, chunk in enumerate(made):
        if is_link(chunk, "mark", "stop", "semicolon"):
            named = []
        elif isinstance(chunk, Noun) and chunk.kind == "thing":
            named.append(chunk)
        elif named and isinstance(chunk, Noun) and _is_another_look(chunk):
            joined = is_link(made[at - 1], "mark", "comma") or is_link(made[at - 1], "joins", "and")
            like = next((noun for noun in named if noun.det in ("a", "one") and _is_coloured(noun)), None)
            if joined and like is not None and not any(noun.many for noun in named):
                text = f"{chunk.text.rpartition(' ')[0]} {like.word}"
                look = replace(like, start=chunk.start, end=chunk.end, text=text, attributes=[*chunk.attributes])
                made[at] = replace(look, unshown=[*chunk.unshown], states=[], styles=[], size=None)
    return made


def _is_coloured(noun: Noun) -> bool:
    return any(look in COLOURS for look in noun.attributes)


def _is_another_look(noun: Noun) -> bool:
    """Whether it is "a blue one"."""
    return noun.kind == "number" and noun.det == "a" and _is_coloured(noun) and noun.text.lower().endswith(" one")


def _with_each_apart(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with a clause of its own for "and each has a plant on top"."""
    made = list(chunks)
    for at in range(1, len(made) - 1):
        each, verb = made[at], made[at + 1]
        if not isinstance(each, Noun) or (each.kind, each.text.lower()) != ("pronoun", "each"):
            continue
        joint = made[at - 1]
        if is_link(joint, "joins", "and") and isinstance(verb, Connector) and verb.sort == "verbs" and is_holding(verb):
            made[at - 1] = Connector("mark", "semicolon", joint.start, joint.end, ";")
    return made


def _with_new_things(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with "a" for the "the" of what is new where a place is told first: "and in front of it the table"."""
    made = list(chunks)
    named: set[str] = set()
    for at, chunk in enumerate(made):
        if not isinstance(chunk, Noun) or chunk.kind != "thing":
            continue
        after = chunk_at(made, at + 1)
        ends = after is None or is_link(after, "mark")
        if (
            chunk.det == "the"
            and ends
            and at > 2
            and chunk.value not in named
            and not chunk.many
            and _is_fronted(made, at)
        ):
            made[at] = replace(chunk, det="a")
        named.add(chunk.value)
    return made


def _is_fronted(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a joint, a preposition and what that is to come right before."""
    joint, link, anchor = chunks[at - 3 : at]
    begins = is_link(joint, "joins", "and") or is_link(joint, "mark")
    return begins and is_link(link, "prepositions") and isinstance(anchor, Noun) and anchor.kind in ("pronoun", "thing")


def _with_each_before(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with "each have a cushion" for "the sofa and the armchair have a cushion each"."""
    made = list(chunks)
    for at in range(len(made) - 6, -1, -1):
        one, joint, other, verb, thing, each = made[at : at + 6]
        two = all(isinstance(noun, Noun) and noun.kind == "thing" for noun in (one, other, thing))
        held = isinstance(verb, Connector) and verb.sort == "verbs" and is_holding(verb)
        after = isinstance(each, Noun) and each.text.lower() in ("each", "apiece")
        if two and held and after and is_link(joint, "joins", "and"):
            made[at + 3 : at + 6] = [replace(each, start=verb.start, end=verb.start), verb, thing]
    return made
