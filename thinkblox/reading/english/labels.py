"""Things that are told apart by letters or numbers: "shelf A and shelf B", "bench 1" are the first and the second."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.assets.plurals import singular
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.tokens import Token

_LETTERS = "ABCDEF"
_LEAST = 2
"""Fewest labels that tell things of one name apart."""
_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth")
_STOPS = ".!?;:\n"
_NO_THINGS = ("groups", "rooms", "zones", "labels")
"""Words for parts of a room, for other rooms and for parts of a text, that have letters or numbers too."""


def with_labels(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "the first shelf" for "shelf A", after how many of them there are."""
    tokens = _apart(tokens)
    labels: dict[str, set[int]] = {}
    for at in range(1, len(tokens)):
        if label := _label(tokens, at):
            labels.setdefault(tokens[at - 1].text, set()).add(label)
    numbered = {noun: len(found) for noun, found in labels.items() if found == {*range(1, len(found) + 1)}}
    made: list[Token] = []
    told: set[str] = set()
    for at, token in enumerate(tokens):
        label = _label(tokens, at) if at else 0
        if not label or numbered.get(noun := tokens[at - 1].text, 0) < _LEAST:
            made.append(token)
            continue
        start = _phrase(made)
        name = made[start:]
        start -= int(start > 0 and made[start - 1].text == "the")
        made[start:] = [*_said(("the", _ORDINALS[label - 1]), made[start].start), *name]
        if made[-1].start < token.start <= made[-1].start + len(made[-1].shown) + 1:
            made[-1] = structs.replace(made[-1], shown=f"{made[-1].shown} {token.shown}")
        if noun not in told:
            told.add(noun)
            sentence = next((n + 1 for n in range(start - 1, -1, -1) if made[n].text in _STOPS), 0)
            count = str(numbered[noun])
            number = Token(count, count, "number", value=numbered[noun], start=name[0].start)
            made[sentence:sentence] = [number, *name, Token(".", ".", "mark", start=name[0].start)]
    return made


def _apart(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "table A and table B" for "tables A and B"."""
    made: list[Token] = []
    for at, token in enumerate(tokens):
        several = token.text.endswith("s")
        one, joint, other = ([t.shown for t in tokens[at + 1 : at + 4]] + [""] * 3)[:3] if several else ("", "", "")
        if joint == "and" and one and other and one in _LETTERS and other in _LETTERS:
            made.append(structs.replace(token, text=singular(token.text)))
        elif at > 2 and made[-1].text == "and" and token.shown in _LETTERS and tokens[at - 3].text.endswith("s"):
            made += [made[-3], token] if tokens[at - 2].shown in _LETTERS else [token]
        else:
            made.append(token)
    return made


def _label(tokens: Sequence[Token], at: int) -> int:
    """Which of several a letter or number after a noun says it is; 0 for other tokens."""
    token, noun = tokens[at], tokens[at - 1]
    if token.kind == "number":
        number = int(token.value) if token.value in range(1, len(_ORDINALS) + 1) else 0
    else:
        number = _LETTERS.find(token.shown) + 1 if len(token.shown) == 1 else 0
    if not number:
        return 0
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    ends = after is None or after.kind == "mark"
    ends |= grammar().at(tokens, at + 1, "verbs", "participles", "joins", "prepositions") is not None
    plain = noun.kind == "word" and not any(noun.text in grammar().lists[name] for name in _NO_THINGS)
    if not plain or not ends or grammar().at(tokens, at - 1, "verbs", "prepositions", "determiners", "joins", "count"):
        return 0
    return number


def _phrase(tokens: Sequence[Token]) -> int:
    """Where the name that these end with begins."""
    start = len(tokens) - 1
    words = ("verbs", "prepositions", "determiners", "joins", "participles", "fillers", "count")
    while start and tokens[start - 1].kind == "word" and grammar().at(tokens, start - 1, *words) is None:
        start -= 1
    return start


def _said(words: Sequence[str], start: int) -> list[Token]:
    return [Token(word, "", "word", start=start) for word in words]
