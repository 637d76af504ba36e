"""Words that are read as others: "the left third" is the left side, "the opposite end" the other end."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.knowledge.vocabulary import thing_called
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.tokens import Token

_SIDES = ("left", "right", "front", "back", "leftmost", "rightmost")
SHARES = ("third", "half", "part", "portion")
"""Parts of a top that are at a side of it."""
_ONE = ("a", "one", "each", "every")
_AT = ("at", "on", "for")
_SEATS = {"places": "place", "seats": "seat", "settings": "setting"}
_PARTED = (["low", "hanging"], ["high", "hanging"])
"""Words that are read as two, also where a hyphen joins them."""
_SEVERAL = ("these", "those", "both", "all", "they")
_NO_PLACE = ("of", "for", "with", "without", "as", "per", "to", "from")
"""Prepositions that say nothing of where things are."""
_SHORTEST, _LONGEST = 3, 6
"""So many words before "stand" at least, and at most back to the "and" before its last subject."""
_OF_ROOM = ["of", "the", "room"]


def reworded(tokens: Sequence[Token]) -> list[Token]:
    """Tokens with the words that they are read as; what was written stays as it is."""
    words = [token.text for token in tokens]
    read = list(words)
    for at, word in enumerate(words):
        before, after = words[at - 1] if at else "", words[at + 1 : at + 5]
        if word in SHARES and before in _SIDES and after[:3] != _OF_ROOM:
            read[at] = "side"
        elif (
            word == "opposite" and after[:1] in (["side"], ["end"]) and (after[1:2] != ["of"] or after[1:] == _OF_ROOM)
        ):
            read[at] = "other"
        elif word in ("form", "forms", "forming") and after[1:2] == ["rows"]:
            read[at] = "in"
        elif [word, *after[:1]] == ["other", "half"] and before == "the" and after[1:2] != ["of"]:
            read[at : at + 2] = ["others", "there"]
        elif word == "a" and after[:1] == ["side"] and before.endswith("s") and _ends(tokens[at + 2 : at + 3]):
            read[at] = "per"
        elif word == "all" and before in _AT and after[:1] and after[0] in _SEATS:
            read[at : at + 2] = ["every", _SEATS[after[0]]]
        elif word == "stand" and (verb := _verb(tokens, at)):
            read[at] = verb
        elif word == "light" and before not in _ONE and after[:1] and after[0] in grammar().lists["shines"]:
            read[at] = "daylight"
    parted = [words[at : at + 2] in _PARTED for at in range(len(words))]
    return [
        structs.replace(token, text=new, glued=token.glued and not apart) if new != token.text or apart else token
        for token, new, apart in zip(tokens, read, parted, strict=True)
    ]


def _verb(tokens: Sequence[Token], at: int) -> str:
    """The verb that "stand" is read as; empty where it may be a thing."""
    if at and tokens[at - 1].text in _SEVERAL and _goes_on(tokens, at + 1):
        return "are"
    return "stands" if _is_verb_of_each(tokens, at) or _is_verb_of_two(tokens, at) else ""


def _goes_on(tokens: Sequence[Token], at: int) -> bool:
    """Whether it is told where or how several stand."""
    return at < len(tokens) and grammar().at(tokens, at, "prepositions", "mutual", "fillers") is not None


def _is_verb_of_each(tokens: Sequence[Token], at: int) -> bool:
    """Whether "stand" tells what is there: "on each stand two lamps"."""
    return at > 0 and tokens[at - 1].text == "each" and grammar().at(tokens, at + 1, "count") is not None


def _is_verb_of_two(tokens: Sequence[Token], at: int) -> bool:
    """Whether "stand" tells where two are: "a bowl and a glass stand on the table", but not "and a music stand in"."""
    link = grammar().at(tokens, at + 1, "prepositions") if at + 1 < len(tokens) else None
    if at < _SHORTEST or link is None or link.value in _NO_PLACE:
        return False
    thing = tokens[at - 1].text
    if thing_called(f"{thing} stand", 2) is not None or thing_called(thing, 1) is None:
        return False
    start = next((n for n in range(at - 1, -1, -1) if tokens[n].text in ".;!?"), -1) + 1
    joint = next((n for n in range(at - 2, max(start, at - _LONGEST), -1) if tokens[n].text == "and"), 0)
    before = tokens[start:joint]
    counted = joint and grammar().at(tokens, joint + 1, "determiners", "count") is not None
    return bool(counted and before) and not any(t.text == "with" or grammar().knows(t.text, "verbs") for t in before)


def _ends(after: Sequence[Token]) -> bool:
    return all(token.kind == "mark" or token.text in ("and", "with", "plus") for token in after)
