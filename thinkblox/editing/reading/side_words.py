"""Things that are told by a side: "the northern desk", "(from the left nightstand) to the right one"."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.assets.plurals import singular
from thinkblox.editing.by_compass import WAYS
from thinkblox.editing.reading.clause import ENDS
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token

_ENDINGS = ("ern", "ernmost", "most")
_SIDES = (*WAYS, "left", "right")
_GOING = ("to", "onto", "on", "into", "in")
_HERE = ("from", "on", "in", "off", "at")


def with_sides(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "the northern desk" as "the north desk", and what "the left one" is called in place of "one".

    "To the left one" would else be a direction.
    """
    left = [_plain(lexicon, tokens, at) for at in range(len(tokens))]
    for at in range(3, len(left)):
        side = left[at - 1].text in _SIDES and left[at - 2].text == "the" and left[at - 3].text in _GOING
        if side and left[at].text == "one" and (head := _named_here(lexicon, left[: at - 3])) is not None:
            left[at] = structs.replace(head, text=singular(head.text), start=-1)
    return left


def _plain(lexicon: Lexicon, tokens: Sequence[Token], at: int) -> Token:
    """A token, of "northern" before a thing "north"; the half of a room is the side of it."""
    token, after = tokens[at], list(tokens[at + 1 : at + 4])
    if token.text == "half" and [word.text for word in after] == ["of", "the", "room"]:
        return structs.replace(token, text="side", shown="side")
    side = next((side for side in WAYS if token.text in [side + ending for ending in _ENDINGS]), "")
    named = bool(after) and (after[0].text == "one" or lexicon.longest(after, 0).entry("object") is not None)
    return structs.replace(token, text=side, shown=side) if side and named else token


def _named_here(lexicon: Lexicon, tokens: Sequence[Token]) -> Token | None:
    """The last word of the last thing in the sentence that something is said to be at: "from the left nightstand"."""
    for at in reversed(range(len(tokens))):
        if tokens[at].text in ENDS:
            return None
        begin = next((n for n in range(at + 1, len(tokens)) if tokens[n].text not in ("the", *_SIDES)), len(tokens))
        if tokens[at].text not in _HERE or begin == at + 1 or begin >= len(tokens):
            continue
        found = lexicon.longest(list(tokens), begin)
        if found.entry("object") is not None:
            return tokens[begin + found.length - 1]
    return None
