"""What is said more of the same things in one breath: "(I'd like the chairs by the wall) and turned to the door"."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.editing.grammar import longest
from thinkblox.editing.lengths import lengths_at
from thinkblox.editing.reading.clause import ENDS, rest_of_sentence
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token, tokenise

_SIDES = ("left", "right")
_PARTS = ("side", "end", "half", "edge", "corner")
_AT_SIDE = ("to", "on", "at")
_VERBS = {"turn": "turn", "move": "move", "make": "paint"}
"""The order by which a thing comes to be as a participle says."""


def with_more_said(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The tokens with what is said more of the same things as orders of its own.

    Of "I'd like both chairs by the wall and turned to the door" the end is "and turn them to the door", and "closer to
    the window but not closer than 50 cm" is "closer to the window and at least 50 cm from it". In "the laptop to the
    left side of the desk and the lamp to the right" the right is that of the desk.
    """
    return _sided(_bounded(lexicon, _turned(list(tokens))))


def _words(text: str, start: Token | None = None) -> list[Token]:
    said = [structs.replace(token, start=-1) for token in tokenise(text)]
    return [structs.replace(said[0], start=start.start, shown=start.shown), *said[1:]] if start is not None else said


def _turned(tokens: list[Token]) -> list[Token]:
    left = list(tokens)
    for at in reversed(range(3, len(tokens) - 1)):
        done = longest("done", left, at) if left[at - 1].text == "and" else None
        if done is None or done[0] not in _VERBS or at + done[1] >= len(left):
            continue
        begin = next((n + 1 for n in range(at - 1, -1, -1) if left[n].text in ENDS), 0)
        verbs = [found[0] for n in range(begin, at) if (found := longest("verbs", left, n)) is not None]
        wished = any(longest("wishes", left, n) is not None for n in range(begin, at))
        placed = any(
            grammar().at(left, n, "prepositions") is not None or longest("markers", left, n) is not None
            for n in range(begin, at)
        )
        if placed and (verbs == ["want"] or (wished and not verbs)):
            left[at : at + done[1]] = [*_words(_VERBS[done[0]], left[at]), *_words("them")]
    return left


def _sided(tokens: list[Token]) -> list[Token]:
    left = list(tokens)
    for at in reversed(range(6, len(tokens))):
        if left[at].text not in _SIDES or left[at - 1].text != "the" or left[at - 2].text not in _AT_SIDE:
            continue
        end = at + 1 + (at + 1 < len(left) and left[at + 1].text in _PARTS)
        if end < len(left) and left[end].text not in (*ENDS, ",", "and", "please"):
            continue
        begin = next((n + 1 for n in range(at - 1, -1, -1) if left[n].text in ENDS), 0)
        of = next((n for n in range(at - 3, begin, -1) if _is_side_of(left, n)), None)
        stop = next((n for n in range(of or at, at) if left[n].text in ("and", ",")), None) if of is not None else None
        if of is None or stop is None:
            continue
        part = [] if end > at + 1 or left[of - 1].text in _SIDES else [left[of - 1]]
        whole = [structs.replace(token, start=-1) for token in (*part, *left[of:stop])]
        left[end:end] = whole
    return left


def _is_side_of(tokens: Sequence[Token], at: int) -> bool:
    """Whether "of" stands there behind a side: "the left side of"."""
    before = at - 1 - (tokens[at - 1].text in _PARTS)
    return tokens[at].text == "of" and before > 1 and tokens[before].text in _SIDES and tokens[before - 1].text == "the"


def _bounded(lexicon: Lexicon, tokens: list[Token]) -> list[Token]:
    left = list(tokens)
    for at in reversed(range(2, len(tokens) - 3)):
        words = [token.text for token in left[at : at + 3]]
        if words[:1] not in (["not"], ["no"]) or words[1:] not in (["closer", "than"], ["nearer", "than"]):
            continue
        said = lengths_at(lexicon, left, at + 3)
        if said is None or left[at - 1].text not in ("but", "and", ","):
            continue
        end = at + 3 + said.tokens
        length = left[at + 3 : end]
        to = end < len(left) and left[end].text in ("to", "from")
        link = _words("from") if to else _words("from it")
        after = end + 1 if to else end
        if not to and after not in rest_of_sentence(left, at) and after < len(left) and left[after].kind != "mark":
            continue
        left[at - 1 : after] = [*_words("and", left[at - 1]), *_words("at least", left[at]), *length, *link]
    return left
