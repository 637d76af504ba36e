"""What is on or off: "the lamp is on", "a screen that is off", "with the radio on"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, chunk_at
from thinkblox.reading.english.said import is_link

_STATES = {"on": "switched on", "off": "switched off"}


def with_switched(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which an "on" or "off" that leads to nothing says that something is switched on or off."""
    made = list(chunks)
    for at in range(1, len(made)):
        if _is_switched(made, at):
            made[at] = _switched(made, at)
            said = made[at - 1]
            if isinstance(said, Noun) and said.det in ("both", "all"):
                made[at - 1] = Connector("fillers", "words", said.start, said.end, said.text)
    return made


def _is_switched(chunks: Sequence[Chunk], at: int) -> bool:
    link = chunks[at]
    if not isinstance(link, Connector) or link.sort != "prepositions" or link.text.lower() not in _STATES or not at:
        return False
    after = chunk_at(chunks, at + 1)
    ends = after is None or is_link(after, "mark", "stop", "semicolon", "comma", "close") or is_link(after, "joins")
    ends |= link.text.lower() == "off" and is_link(after, "prepositions")
    return ends and (_is_said(chunks, at - 1) or _is_had(chunks, at - 1))


def _is_said(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "the lamp is" stands there, and not the "the table the lamp is" of what it is on; or "both", "one"."""
    said, apart = chunks[at], at < 1 or is_link(chunks[at - 1], "mark") or is_link(chunks[at - 1], "joins")
    if isinstance(said, Noun):
        return apart and at > 0 and said.kind in ("pronoun", "number")
    return is_link(said, "verbs", "be") and not (at > 1 and all(isinstance(c, Noun) for c in chunks[at - 2 : at]))


def _is_had(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "with the lamp" stands there."""
    noun = chunks[at]
    known = isinstance(noun, Noun) and noun.kind == "thing" and noun.definite
    return known and at > 0 and is_link(chunks[at - 1], "prepositions", "with")


def _switched(chunks: Sequence[Chunk], at: int) -> Chunk:
    link = chunks[at]
    text = link.text if isinstance(link, Connector) else ""
    return Adjective(link.start, link.end, text, states=[_STATES[text.lower()]])
