"""What is told in passing of things: "its door is open", "tucked in", "from glass", "who owns three guitars"."""

from collections.abc import Sequence
from dataclasses import replace

from msgspec import structs

from thinkblox.assets.repaint import MATERIALS
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, Stray, chunk_at
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.moved_parts import MOVED
from thinkblox.reading.english.said import is_link
from thinkblox.reading.tokens import Token

_OWNING = {"owns": "has", "own": "have", "collects": "has", "collect": "have", "possesses": "has"}
_OWNERS = ("who", "that", "i", "we", "they", "you", "she", "he")
_TUCKED = "pushed in"
_USING = ("use", "using", "choose", "take", "pick")
_BLOCKING = ("block", "obstruct", "blocking", "obstructing")
_FOR = 3
"""How many chunks after "use" it is said what for."""
_TURNED = 3
"""How many chunks before "toward" it is said what a thing faces away from."""
_LYING = ("lies", "lie", "lying", "lay", "laid", "rests", "resting", "is lying", "are lying", "tipped", "turned")
"""What says that a thing lies, before which of its sides that is on."""
_LEANING = ("leans", "lean", "leaning")


def with_owners(tokens: Sequence[Token]) -> list[Token]:
    """The tokens, with "has" for what people own or collect."""
    return [
        structs.replace(token, text=_OWNING[token.text]) if _is_owning(tokens, at) else token
        for at, token in enumerate(tokens)
    ]


def _is_owning(tokens: Sequence[Token], at: int) -> bool:
    who = tokens[at - 1].text if at and tokens[at].text in _OWNING else ""
    return who in _OWNERS or (bool(who) and not tokens[at - 1].owner and grammar().knows(who, "people"))


def with_passing(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which it is told of the things themselves, or said not to be understood."""
    made: list[Chunk] = []
    chunks, at = _seated(_without_past(_without_making(chunks))), 0
    while at < len(chunks):
        chunk = chunks[at]
        if _is_own_door(chunks, at):
            made.append(Noun("pronoun", "it", chunk.start, chunk.end, "it"))
        elif state := _lying_state(chunks, at):
            made.append(Adjective(chunk.start, chunks[at + 1].end, state, states=[state]))
            at += 1
        elif length := _not_understood(chunks, at):
            words = " ".join(getattr(c, "text", "") for c in chunks[at : at + length])
            made.append(Stray(chunk.start, chunks[at + length - 1].end, words))
            at += length - 1
        elif isinstance(chunk, Noun) and (material := _material(chunks, at)):
            made.append(replace(chunk, end=chunks[at + 2].end, attributes=[*chunk.attributes, material]))
            at += 2
        elif _is_made_of(chunks, at) and isinstance(looks := chunks[at + _FOR - 2], Adjective):
            thing = chunks[at + _FOR]
            if isinstance(thing, Noun):
                words = " ".join((looks.text, thing.text.split()[-1]))
                told = [*thing.attributes, *looks.attributes]
                looked = [*looks.attributes]
                made.append(replace(thing, start=looks.start, attributes=told, looks=looked, text=f"the {words}"))
            at += _FOR
        elif _is_in_way(chunks, at):
            made += [Connector("verbs", "leave", chunk.start, chunk.start, "keep"), chunks[at + 2]]
            made.append(Adjective(chunks[at + 1].start, chunks[at + 1].end, "free", states=["free"]))
            at += 2
        elif isinstance(chunk, Connector) and (where := _where_meant(chunk, chunks, at)):
            made.append(replace(chunk, value=where))
        else:
            made.append(chunk)
        at += 1
    return made


def _without_making(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which "is made of" and "made from" say of what a thing is, and not that a bed is made."""
    made = list(chunks)
    for at in range(len(made) - 1):
        said, link = made[at : at + 2]
        if str(getattr(said, "text", "")).lower() == "made" and is_link(link, "prepositions", "of", "from"):
            made[at] = Connector("fillers", "words", said.start, said.end, "made")
            made[at + 1] = Connector("prepositions", "of", link.start, link.end, "of")
    return made


def _where_meant(link: Connector, chunks: Sequence[Chunk], at: int) -> str:
    """What a preposition stands for after what was said before it; empty where it is what it is."""
    if _is_hung_from(link, chunks, at):
        return "on"
    return "next_to" if _is_leant_on(chunks, at) else "facing" if _is_turned_to(link, chunks, at) else ""


def _is_hung_from(link: Connector, chunks: Sequence[Chunk], at: int) -> bool:
    """Whether something "hangs from" a hook or a rack, which it is on."""
    hook = chunk_at(chunks, at + 1)
    hung = at > 0 and (is_link(chunks[at - 1], "verbs", "hang") or is_link(chunks[at - 1], "participles", "hang"))
    return hung and link.value == "from" and isinstance(hook, Noun) and hook.kind == "thing"


def _is_turned_to(link: Connector, chunks: Sequence[Chunk], at: int) -> bool:
    """Whether it goes on with how a thing is turned: "(faces away from the window and) toward the fireplace"."""
    if at < _TURNED or link.text.lower() not in ("toward", "towards") or not is_link(chunks[at - 1], "joins"):
        return False
    return is_link(chunks[at - _TURNED], "verbs", "face", "face_away") or is_link(
        chunks[at - _TURNED], "prepositions", "facing", "facing_away"
    )


def _without_past(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which what a thing was once asks for nothing: "two mirrors that used to be mine"."""
    made = list(chunks)
    for at in range(len(made) - 3, 0, -1):
        that, was, told = made[at : at + 3]
        if not isinstance(was, Connector) or was.text.lower() != "used to be":
            continue
        before = made[at - 2] if at > 1 and is_link(made[at - 1], "mark", "comma") else made[at - 1]
        led = isinstance(that, (Noun, Connector)) and that.text.lower() in ("that", "which")
        led &= isinstance(before, Noun) and before.kind == "thing"
        here = isinstance(told, Noun) and told.kind == "place" and told.det != "a"
        if led and isinstance(told, (Noun, Adjective)) and not here:
            made[at : at + 3] = [Connector("fillers", "words", that.start, told.end, "that used to be so")]
    return made


def _is_own_door(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "its door is open" comes after a thing that has doors of its own."""
    door, state = chunks[at], chunk_at(chunks, at + 2)
    own = isinstance(door, Noun) and door.kind in ("place", "thing") and door.det == "my" and door.word in MOVED
    told = own and is_link(chunks[at + 1], "verbs", "be") if state is not None else False
    if not told or not isinstance(state, Adjective) or not state.states:
        return False
    return at > 0 and (is_link(chunks[at - 1], "joins") or is_link(chunks[at - 1], "mark"))


def _lying_state(chunks: Sequence[Chunk], at: int) -> str:
    """How a thing is said to be by "tucked in", or by "on its side" after "lies"; empty where neither comes."""
    if _is_on_its_side(chunks, at):
        return f"on {str(getattr(chunks[at + 1], 'text', '')).lower()}"
    return _TUCKED if _is_tucked(chunks, at) else ""


def _is_on_its_side(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "on its side" comes after "lies", which tells how a thing lies and not where."""
    lies, side = chunks[at - 1] if at else None, chunk_at(chunks, at + 1)
    after = chunk_at(chunks, at + 2)
    if not is_link(chunks[at], "prepositions", "on") or not isinstance(side, Noun) or side.kind != "part":
        return False
    lying = isinstance(lies, Connector) and lies.sort in ("verbs", "participles") and lies.text.lower() in _LYING
    own = side.det == "my" and side.word in ("side", "back", "edge") and not is_link(after, "prepositions", "of")
    return lying and own


def _is_tucked(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "tucked in" comes, and nothing that it would be in."""
    link, after = chunks[at], chunk_at(chunks, at + 2)
    if not isinstance(link, Connector) or link.text.lower() != "tucked" or at + 1 >= len(chunks):
        return False
    ends = after is None or is_link(after, "mark") or is_link(after, "joins")
    return ends and is_link(chunks[at + 1], "prepositions", "in")


def _is_left_out(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "except the top one" comes after how all are, of which the one left out is something else."""
    said, one = chunks[at - 1] if at else None, chunk_at(chunks, at + 1)
    if not isinstance(said, Adjective) or not said.states or not is_link(chunks[at], "prepositions", "except"):
        return False
    return isinstance(one, Noun) and one.kind == "number" and bool(one.unshown)


def _not_understood(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks say what is not understood; 0 where none do."""
    if _is_left_out(chunks, at) or _is_of_opening(chunks, at):
        return 2
    return 3 if _is_missing(chunks, at) else 0


def _is_of_opening(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "between them" is said of a window or door, which is where the room has it."""
    opening, them = (chunks[at - 1] if at else None), (chunk_at(chunks, at + 1))
    new = isinstance(opening, Noun) and opening.kind == "place" and opening.value.split()[0] in ("window", "door")
    new = new and isinstance(opening, Noun) and not opening.definite
    pointed = isinstance(them, Noun) and them.kind == "pronoun"
    return new and pointed and is_link(chunks[at], "prepositions", "between")


def _is_missing(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "the two missing ones" comes."""
    some, ones = chunks[at], chunk_at(chunks, at + 2)
    if not isinstance(some, Noun) or not isinstance(ones, Noun) or some.kind not in ("number", "pronoun"):
        return False
    return is_link(chunks[at + 1], "negations", "gone") and ones.word == "one" and not ones.named


def _material(chunks: Sequence[Chunk], at: int) -> str:
    """The material of "a table from glass"; empty where none follows."""
    thing, matter = chunks[at], chunk_at(chunks, at + 2)
    if not isinstance(thing, Noun) or thing.kind != "thing" or not isinstance(matter, Noun):
        return ""
    bare = not (matter.det or matter.count or matter.plural or matter.attributes)
    from_it = is_link(chunks[at + 1], "prepositions", "from") and bare
    return matter.value if from_it and matter.value in MATERIALS and matter.word == matter.value else ""


def _is_made_of(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "use oak for the table" comes, or "and linen for the curtains" after it."""
    if at + _FOR >= len(chunks):
        return False
    use, looks, link, thing = chunks[at : at + _FOR + 1]
    if not isinstance(looks, Adjective) or not isinstance(thing, Noun):
        return False
    first = isinstance(use, Connector) and use.sort == "verbs" and use.text.lower() in _USING
    again = is_link(use, "joins", "and") and any(
        isinstance(c, Connector) and c.text.lower() in _USING for c in chunks[max(0, at - _FOR - 1) : at]
    )
    known = thing.kind == "thing" and thing.det in ("the", "my", "all")
    told = bool(looks.attributes) and is_link(link, "prepositions", "for")
    return (first or again) and known and told


def _is_in_way(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "must not block the door" comes."""
    if not is_link(chunks[at], "negations", "not", "exclude"):
        return False
    block, place = (*chunks[at + 1 : at + 3], None, None)[:2]
    blocks = isinstance(block, Noun) and not block.det and block.text.lower() in _BLOCKING
    return blocks and isinstance(place, Noun) and place.kind == "place" and place.definite


def _seated(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks with "seats six and has two benches" for "seats six on two benches"."""
    made = list(chunks)
    for at, chunk in enumerate(chunks):
        if isinstance(chunk, Connector) and _is_seated_on(chunks, at):
            made[at + 2] = replace(chunk, sort="verbs", value="have")
    return made


def _is_seated_on(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "seats six on two benches" comes: so many are seated, and it has two benches."""
    if not is_link(chunks[at], "verbs", "seat"):
        return False
    number, link, seats = (*chunks[at + 1 : at + 4], None, None, None)[:3]
    counted = isinstance(number, Noun) and number.kind == "number" and bool(number.count)
    seated = counted and is_link(link, "prepositions", "on", "with")
    return seated and isinstance(seats, Noun) and seats.kind == "thing" and not seats.definite


def _is_leant_on(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether something leans against a thing, beside which it then is."""
    leans = chunks[at - 1] if at else None
    leant = isinstance(leans, Connector) and leans.text.lower() in _LEANING
    after = chunk_at(chunks, at + 1)
    return (
        leant and is_link(chunks[at], "prepositions", "against") and isinstance(after, Noun) and after.kind == "thing"
    )
