"""What belongs to a thing, said in other words: "with the chair behind it", "everything that belongs to it"."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.assets import facts_of
from thinkblox.editing.grammar import longest
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token, tokenise

_BELONGING = (
    "that belongs to",
    "which belongs to",
    "belonging to",
    "that goes with",
    "that is part of",
    "that comes with",
)
_AT_SEAT = ("behind", "in_front_of", "at", "by", "next_to", "near")
_ASIDE = (*_AT_SEAT, "left_of", "right_of")
_ALONG = ("both", "its", "their", "everything", "all")
_MOVING = ("put", "move", "turn", "want")
MOST = 8
"""Most words from "with" to "it"."""


def with_its_own(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The tokens with what goes along said as "with its chair".

    Of "(put the desk in the middle) with the chair behind it" a seat goes along, and anything else is put there then;
    "the desk and everything that belongs to it" is "the desk with its seats and everything on it"; "lengthwise along
    the window" is "with its long side along the window".
    """
    return _lengthwise(_seated(lexicon, _coming_along(_belonging(_not_of_wall(tokens)))))


def _words(text: str, start: Token | None = None) -> list[Token]:
    said = [structs.replace(token, start=-1) for token in tokenise(text)]
    return [structs.replace(said[0], start=start.start, shown=start.shown), *said[1:]] if start is not None else said


def _not_of_wall(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "to the wall, with both nightstands": what goes along does not tell which wall that is."""
    left: list[Token] = []
    for at, token in enumerate(tokens):
        after = tokens[at + 1].text if at + 1 < len(tokens) else ""
        if token.text == "with" and at and tokens[at - 1].text in ("wall", "corner") and after in _ALONG:
            left.append(Token(",", ",", "mark", start=-1))
        left.append(token)
    return left


def _belonging(tokens: list[Token]) -> list[Token]:
    left = list(tokens)
    for at in reversed(range(1, len(tokens))):
        if left[at].text not in ("everything", "all", "anything"):
            continue
        phrases = [phrase.split() for phrase in _BELONGING]
        found = next((p for p in phrases if [t.text for t in left[at + 1 : at + 1 + len(p)]] == p), None)
        end = at + 1 + len(found) if found is not None else len(left)
        if end < len(left) and left[end].text in ("it", "them") and left[at - 1].text in ("and", "with"):
            left[at - 1 : end + 1] = _words("with its seats and everything on it", left[at - 1])
    return left


def _coming_along(tokens: list[Token]) -> list[Token]:
    """Read "(move the desk to the corner;) the chair comes along" as "keep the chair with it"."""
    left = list(tokens)
    for at in reversed(range(2, len(tokens) - 1)):
        comes = left[at].text in ("comes", "come", "goes", "go") and left[at + 1].text in ("along", "too", "with")
        begin = next((n for n in range(at - 1, max(at - 4, 0), -1) if left[n].text in ("the", "its", "their")), None)
        linked = begin is not None and (left[begin - 1].kind == "mark" or left[begin - 1].text in ("and", "but"))
        if not comes or begin is None or not linked:
            continue
        end = at + 2 + (left[at + 1].text == "along" and [t.text for t in left[at + 2 : at + 4]] == ["with", "it"]) * 2
        end += left[at + 1].text == "with" and [t.text for t in left[at + 2 : at + 3]] == ["it"]
        keep, link = _words("keep with it", left[begin])[:1], _words("with it")
        left[begin:end] = [structs.replace(keep[0], start=-1), *left[begin:at], *link]
    return left


def _seated(lexicon: Lexicon, tokens: list[Token]) -> list[Token]:
    left = list(tokens)
    for at in reversed(range(2, len(tokens) - 3)):
        if left[at].text != "with" or left[at + 1].text not in ("the", "its"):
            continue
        named = lexicon.longest(left, at + 2)
        thing = named.entry("object")
        flank = longest("flanks", left, at + 2 + named.length) if thing is not None else None
        link = grammar().at(left, at + 2 + named.length, "prepositions") if thing is not None else None
        if flank is not None and any(longest("verbs", left, n) for n in range(at)):
            left[at:] = [*_words("and put", left[at]), *_of_head(left[at + 1 :], _head(lexicon, left[:at]))]
        if thing is None or link is None or flank is not None:
            continue
        it = at + 2 + named.length + link.length
        verbs = [found[0] for n in range(at) if (found := longest("verbs", left, n)) is not None]
        again = it < len(left) and it <= at + MOST and left[it].text in ("it", "its", "them")
        if not again or not verbs or verbs[-1] not in _MOVING:
            continue
        if facts_of(thing.value).is_in("seating") and link.value in _AT_SEAT and left[it].text == "it":
            left[at + 1 : it + 1] = [structs.replace(left[at + 1], text="its"), *left[at + 2 : at + 2 + named.length]]
        elif link.value in _ASIDE:
            left[at:] = [*_words("and put", left[at]), *_of_head(left[at + 1 :], _head(lexicon, left[:at]))]
    return left


def _head(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The first known thing that is named, as it is named; empty where none is."""
    for at in range(1, len(tokens)):
        named = lexicon.longest(list(tokens), at)
        if named.entry("object") is not None and tokens[at - 1].text in ("the", "my", "our"):
            return [structs.replace(token, start=-1) for token in tokens[at - 1 : at + named.length]]
    return []


def _of_head(tokens: Sequence[Token], head: Sequence[Token]) -> list[Token]:
    """The rest of a sentence with a thing in place of "it": "the side table to its right" is to the right of that."""
    left: list[Token] = []
    whose = False
    for at, token in enumerate(tokens):
        if token.kind == "mark" and token.text != ",":
            return [*left, *tokens[at:]]
        part = token.text == "its" and grammar().at(tokens, at + 1, "parts") is not None
        if head and part:
            left += [structs.replace(token, text="the")]
        elif head and token.text == "it":
            left += [*head]
        else:
            left += [token, *(_words("of") if whose else ()), *(head if whose else ())]
            part = False
        whose = part
    return left


def _lengthwise(tokens: list[Token]) -> list[Token]:
    left = list(tokens)
    for at in reversed(range(1, len(tokens) - 2)):
        if left[at].text not in ("lengthwise", "lengthways"):
            continue
        link = grammar().at(left, at + 1, "prepositions")
        if link is not None:
            left[at : at + 1 + link.length] = _words("with its long side along", left[at])
    return left
