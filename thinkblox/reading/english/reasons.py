"""Why something is not to be there, which asks for nothing: "no rug, it stops the wheels", "as it slips"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Chunk, Connector, Noun, chunk_at, filler
from thinkblox.reading.english.said import is_link

_SUBJECTS = ("it", "they", "that", "this")
_GIVING = ("because", "since", "as")
"""Words that begin a reason."""


def with_reasons(chunks: Sequence[Chunk]) -> list[Chunk]:
    """The chunks, where a reason after what is not to be there is filler, up to the end of its clause."""
    made = list(chunks)
    for at, chunk in enumerate(chunks):
        if isinstance(chunk, Noun) and _is_reason(chunks, at):
            end = next((n for n in range(at, len(chunks)) if is_link(chunks[n], "mark")), len(chunks))
            made[at:end] = [filler(said) for said in chunks[at:end]]
            made[at - 1] = filler(chunks[at - 1]) if not is_link(chunks[at - 1], "mark") else made[at - 1]
        elif isinstance(chunk, Connector) and chunk.text.lower() == "because" and _is_of_unknown(chunks, at + 1):
            end = next((n for n in range(at, len(chunks)) if is_link(chunks[n], "mark")), len(chunks))
            made[at:end] = [filler(said) for said in chunks[at:end]]
    return made


def _is_of_unknown(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "of my allergy" comes, which is nothing that could be there."""
    of, what = (*chunks[at : at + 2], None, None)[:2]
    named = isinstance(what, Noun) and (what.named and what.kind == "thing")
    return is_link(of, "prepositions", "of") and isinstance(what, Noun) and not named


def _is_of_getting(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether "the wheels get stuck" comes after what was denied: how something gets is nothing that could be there."""
    subject, verb, how, end = (*chunks[at : at + 4], None, None, None, None)[:4]
    if not at or not is_link(chunks[at - 1], "mark", "comma") or not isinstance(subject, Noun):
        return False
    gets = isinstance(verb, Connector) and verb.text.lower() in ("get", "gets", "would get", "will get")
    so = not isinstance(how, Noun) or not (how.named or how.det or how.count)
    before = chunks[at - 2] if at > 1 else None
    denied = isinstance(before, Noun) and before.kind == "thing" and _is_denied(chunks, before)
    return denied and subject.definite and gets and so and (end is None or is_link(end, "mark"))


def _is_reason(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether a clause about what was denied begins at its subject, with a verb that nobody knows, or after "as"."""
    if _is_of_getting(chunks, at):
        return True
    subject, led = chunks[at], chunks[at - 1] if at else None
    if not isinstance(subject, Noun) or subject.text.lower() not in _SUBJECTS or not isinstance(led, Connector):
        return False
    giving = led.text.lower() in _GIVING
    verb = chunk_at(chunks, at + 1)
    unknown = isinstance(verb, Noun) and verb.kind == "thing" and not (verb.det or verb.named or verb.count)
    if not (giving or (is_link(led, "mark", "comma") and unknown)):
        return False
    before = chunks[at - 2] if at > 1 else None
    before = chunks[at - 3] if is_link(before, "mark", "comma") and at > len(("rug", ",")) else before
    return isinstance(before, Noun) and before.kind == "thing" and _is_denied(chunks, before)


def _is_denied(chunks: Sequence[Chunk], noun: Noun) -> bool:
    """Whether a thing is not to be there."""
    at = next(n for n, chunk in enumerate(chunks) if chunk is noun)
    led = chunks[at - 1] if at else None
    return noun.det == "no" or is_link(led, "prepositions", "without") or is_link(led, "negations", "exclude")
