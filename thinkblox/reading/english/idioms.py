"""Turns of phrase that say the same as plainer words: "one per back corner", "a bit dark", "an overhead camera"."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.tokens import Token

_ENDS = ("back", "front", "rear", "far")
"""What says of corners which two they are."""


_LONGEST = 6
"""Most words of a name before "each"."""


def plainly(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with the plain words for each turn of phrase; what was written stays what they show."""
    return _rows(list(_plain(tokens)))


def _rows(tokens: list[Token]) -> list[Token]:
    """Read "five rows with three desks each" as "five rows of three desks"."""
    for at in range(1, len(tokens) - 2):
        led = tokens[at - 1].text in grammar().lists["ranged"] and tokens[at].text == "with"
        if not led or grammar().at(tokens, at + 1, "count") is None:
            continue
        ends = (n for n in range(at + 2, min(at + _LONGEST, len(tokens))))
        each = next((n for n in ends if tokens[n].text == "each" or tokens[n].kind == "mark"), None)
        if each is not None and tokens[each].text == "each":
            tokens[at] = replace(tokens[at], text="of")
            tokens[each] = replace(tokens[each], text="too")
    return tokens


def _plain(tokens: Sequence[Token]) -> Iterator[Token]:
    at = 0
    while at < len(tokens):
        words = [token.text for token in tokens[at : at + 3]]
        if words[0] == "per" and words[1:2] and words[1] in _ENDS and words[2:] == ["corner"]:
            yield replace(tokens[at], text="in")
            yield replace(tokens[at], text="each", shown="", start=tokens[at].start + len(tokens[at].shown))
        elif words[0] == "overhead" and words[1:] and words[1] in grammar().lists["overhead"]:
            yield replace(tokens[at], text="hanging")
        elif words[:2] == ["a", "bit"] and words[2:] and words[2] != "of" and tokens[at + 2].kind == "word":
            yield replace(tokens[at], text="quite", shown=f"{tokens[at].shown} {tokens[at + 1].shown}")
            at += 1
        elif words[:2] in (["grown", "ups"], ["grown", "up"]) and tokens[at].glued:
            adults = "adults" if words[1] == "ups" else "adult"
            yield replace(tokens[at + 1], text=adults, shown=f"{tokens[at].shown}-{tokens[at + 1].shown}")
            at += 1
        else:
            yield tokens[at]
        at += 1
