"""From where left and right are said to be seen: "to the left of the stove as seen when standing in front of it"."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.editing.grammar import longest
from thinkblox.editing.reading.clause import ENDS
from thinkblox.reading.tokens import Token

_OTHER = {"left": "right", "right": "left", "left-hand": "right-hand", "right-hand": "left-hand"}


def as_seen(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with left and right as those of the thing itself, where they are said to be those of who looks at it.

    What is left of a thing for somebody who stands before it is to its own right.
    """
    left = list(tokens)
    for at in reversed(range(1, len(tokens))):
        found = longest("seen_by", left, at)
        if found is None:
            continue
        end = at + found[1]
        begin = next((n + 1 for n in range(at - 1, -1, -1) if left[n].text in (*ENDS, ",")), 0)
        begin = begin if begin < at else next((n + 1 for n in range(at - 2, -1, -1) if left[n].text in ENDS), 0)
        if found[0] == "front":
            said = [structs.replace(token, text=_OTHER.get(token.text, token.text)) for token in left[begin:at]]
            left[begin:at] = said
        shown = " ".join(token.shown for token in left[at - 1 : end])
        left[at - 1 : end] = [structs.replace(left[at - 1], shown=shown)]
    return left
