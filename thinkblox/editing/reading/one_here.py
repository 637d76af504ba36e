"""So many of a kind, each with its own place: "two plants, one by the sofa and one in the corner"."""

from collections.abc import Sequence
from itertools import pairwise

from msgspec import structs

from thinkblox.assets.plurals import singular
from thinkblox.editing.grammar import longest
from thinkblox.editing.reading.clause import ENDS
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token, tokenise

_NEW = ("add", "want", "ensure", "put")
_KNOWN = ("put", "move")
_JOINS = (",", ":", "and", "with")
_REST = ("the other", "another", "the third", "the last", "the second")
MOST_LOOKS = 4
"""Most words between how many there are and what they are."""


def one_here_one_there(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The tokens with what each of several is to have as orders with a thing of their own, where the numbers add up.

    "Add two plants, one by the sofa and one in the corner" adds a plant by the sofa and a plant in the corner; "move
    the two chairs, one to the door and one to the desk" moves one chair there, and the other one.
    """
    left = list(tokens)
    for at in reversed(range(len(left))):
        begun = longest("verbs", left, at)
        begin = at + begun[1] if begun is not None else at
        the = begin < len(left) and left[begin].text in ("the", "both", "my", "our")
        if begun is None or begun[0] not in (_KNOWN if the else _NEW):
            continue
        end = next((n for n in range(begin, len(left)) if left[n].text in ENDS), len(left))
        shared = _shared(lexicon, left[begin:end], known=the)
        if shared:
            left[begin:end] = shared
    return left


def _shared(lexicon: Lexicon, said: Sequence[Token], *, known: bool) -> list[Token]:
    """The things with the place of each; none where the words do not share out as many as there are."""
    both = known and said[0].text == "both"
    counted = int(known and not both)
    whole = 2 if both else _count(said, counted)
    heads = (n for n in range(counted + 1, counted + 1 + MOST_LOOKS) if n < len(said))
    head = next(((n, found.length) for n in heads if (found := lexicon.longest(list(said), n)).entry("object")), None)
    if whole < 2 or head is None:
        return []
    thing = list(said[counted + 1 : head[0] + head[1]])
    rest = head[0] + head[1]
    begins = [n for n in range(rest + 1, len(said) - 1) if said[n - 1].text in _JOINS and _share(said, n)[0]]
    joined = bool(begins) and all(token.text in _JOINS for token in said[rest : begins[0]])
    each = any(token.text in ("each", "either") for token in said[rest:])
    if len(begins) < 2 or not joined or each:
        return []
    parts = [_without_joins(said[a:b]) for a, b in pairwise([*begins, len(said)])]
    shares = [_share(part, 0) for part in parts]
    others = whole - sum(count for count, _ in shares if count > 0)
    counts = [count if count > 0 else others for count, _ in shares]
    if sum(counts) != whole or min(counts) < 1 or (known and whole != len(parts)):
        return []
    places = _with_whole([part[length:] for part, (_, length) in zip(parts, shares, strict=True)])
    if not all(place and _is_place(place) for place in places):
        return []
    named = [_named(thing, count, number if known else None) for number, count in enumerate(counts)]
    joins = [[], *([structs.replace(tokenise("and")[0], start=-1)] for _ in parts[1:])]
    return [t for join, name, place in zip(joins, named, places, strict=True) for t in (*join, *name, *place)]


def _count(said: Sequence[Token], at: int) -> int:
    """How many a number there says; 0 for no number."""
    if at >= len(said):
        return 0
    if said[at].kind == "number":
        return int(said[at].value)
    found = grammar().at(said, at, "count")
    return int(found.value) if found is not None and found.length == 1 and found.value.isdigit() else 0


def _share(said: Sequence[Token], at: int) -> tuple[int, int]:
    """How many a share is, -1 for what is left, and how many tokens say it; (0, 0) where none begins there."""
    for phrase in _REST:
        words = phrase.split()
        if [token.text for token in said[at : at + len(words)]] == words:
            one = at + len(words) < len(said) and said[at + len(words)].text in ("one", "ones")
            return -1, len(words) + one
    count = _count(said, at)
    return (count, 1) if count else (0, 0)


def _is_place(said: Sequence[Token]) -> bool:
    return said[0].text in ("to", "onto", "into") or grammar().at(said, 0, "prepositions") is not None


def _without_joins(part: Sequence[Token]) -> list[Token]:
    left = list(part)
    while left and left[-1].text in _JOINS:
        left.pop()
    return left


def _with_whole(places: Sequence[list[Token]]) -> list[list[Token]]:
    """The places, with "on the left" and "on the right of the sofa" both of the sofa."""
    of = next((n for n, token in enumerate(places[-1]) if token.text == "of"), None)
    sides = ("left", "right")
    if of is None or not of or places[-1][of - 1].text not in sides:
        return list(places)
    tail = [structs.replace(token, start=-1) for token in places[-1][of:]]
    return [place + tail if place and place[-1].text in sides else place for place in places]


def _named(thing: Sequence[Token], count: int, number: int | None) -> list[Token]:
    """So many of a thing: "a plant", "two plants"; of known ones "one chair" and "the other chair"."""
    *looks, last = (structs.replace(token, start=token.start if not number else -1) for token in thing)
    if count == 1:
        one = singular(last.text)
        last = structs.replace(last, text=one, shown=one)
    said = str(count) if count > 1 else ("a" if number is None else "the other" if number else "one")
    return [*(structs.replace(token, start=-1) for token in tokenise(said)), *looks, last]
