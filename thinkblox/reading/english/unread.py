"""Stretches of words that ask for what no room shows: comparisons, money, animals, states of parts, painted walls.

They are cut out as a whole, so that no word of them becomes a thing or a size, and are said not to be understood.
"""

from collections.abc import Sequence

from thinkblox.assets.repaint import LOOKS
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.turns import turn_at
from thinkblox.reading.tokens import Token

_LONGEST = 10
"""Most tokens of a stretch."""


def unread_at(tokens: Sequence[Token], at: int) -> int:
    """How many tokens a stretch that begins at `at` has; 0 where none does."""
    if length := turn_at(tokens, at):
        return length
    words = [token.text for token in tokens[at : at + _LONGEST]]
    if _is_use(words) and grammar().at(tokens, at + 2, "verbs") is None:
        return next((n for n, token in enumerate(tokens[at:]) if token.kind == "mark"), len(tokens) - at)
    if length := _degrees(words):
        return _to_end(tokens, at, length)
    for reader in (_comparison, _money, _height, _state, _painted, _of_all):
        if length := reader(words):
            return _to_end(tokens, at, length) if reader is _painted else length
    before = tokens[at - 1].text if at else ""
    if grammar().lists["animals"].isdisjoint(words) or _is_in(before, "before_animals"):
        return 0
    return _animal(tokens, at, words)


def _is_in(word: str, name: str) -> bool:
    return word in grammar().lists[name]


def _next_is(words: list[str], at: int, name: str) -> bool:
    return at < len(words) and _is_in(words[at], name)


def _comparison(words: list[str]) -> int:
    """Read "taller than", "twice as long as", "more comfortable than", "the same height as"."""
    if len(words) > 1 and words[1] == "than" and words[0].endswith("er") and not _is_in(words[0], "no_comparatives"):
        return 2
    if words[:1] in (["more"], ["less"]) and words[2:3] == ["than"] and words[1] != "or":
        return 3
    same = words[1:] if words[:1] == ["the"] else words
    if same[:1] == ["same"] and same[2:3] == ["as"] and _is_in(same[1], "measures_of_things"):
        return 3 + len(words) - len(same)
    for start in range(3) if "as" in words[:3] else ():
        if words[start : start + 1] == ["as"] and words[start + 2 : start + 3] == ["as"]:
            fits = all(_is_in(word, "times") or word.isdigit() for word in words[:start])
            return start + 3 if fits and _is_in(words[start + 1], "comparable") else 0
    return 0


def _degrees(words: list[str]) -> int:
    """Read "at 45 degrees to the wall", "rotated by 30 degrees"."""
    if words[0] not in ("at", "rotated", "turned", "angled", "tilted"):
        return 0
    start = next((n for n, word in enumerate(words[:3]) if word[:1].isdigit()), 0)
    if not start:
        return 0
    return start + 2 if words[start + 1 : start + 2] in (["degrees"], ["degree"], ["\u00b0"]) else 0


def _money(words: list[str]) -> int:
    """Read "2000 euros", "€ 2000"."""
    if len(words) > 1 and _is_in(words[0], "money_signs") and words[1][:1].isdigit():
        return 2
    if words[:1] and words[0][:1].isdigit():
        for end in (1, 2):
            if _next_is(words, end, "money_signs") or _next_is(words, end, "money"):
                return end + 1
    return 0


def _height(words: list[str]) -> int:
    """Read "1.5 m above the floor"."""
    if not words or not words[0][:1].isdigit():
        return 0
    for at in (2, 3) if _next_is(words, 1, "length_units") else ():
        if _next_is(words, at, "over_levels"):
            level = at + 2 if words[at + 1 : at + 2] == ["the"] else at + 1
            return level + 1 if _next_is(words, level, "levels") else 0
    return 0


def _state(words: list[str]) -> int:
    """Read "lid up", "drawer open"; "the tap running" is a tap."""
    if words[:1] == ["running"]:
        return 1 if _ends(words, 1) else 0
    fits = len(words) > 1 and _is_in(words[0], "movable") and _is_in(words[1], "moved")
    return 2 if fits and _ends(words, 2) else 0


def _painted(words: list[str]) -> int:
    """Read "walls painted dark blue", "the walls are blue"."""
    if not _next_is(words, 0, "paintable"):
        return 0
    at = 2 if words[1:2] in (["is"], ["are"]) else 1
    if _next_is(words, at, "painted"):
        return at + 1 if at + 1 < len(words) and not _is_in(words[at + 1], "before_other_than_paint") else 0
    shade = words[at + 1 : at + 2] if _next_is(words, at, "before_paint") else words[at : at + 1]
    return at + 1 if at == 2 and shade and shade[0] in LOOKS else 0


def _is_use(words: list[str]) -> bool:
    """Whether it is told what the room is for: "used to train a robot"."""
    return words[:2] == ["used", "to"] and words[2:3] not in ([], ["be"], ["the"], ["it"])


def _of_all(words: list[str]) -> int:
    """Read "everything orange", "everything in white", "orange everything"."""
    if words[1:2] == ["everything"] and words[0] in LOOKS:
        return 2
    at = 2 if words[1:2] in (["in"], ["is"]) else 1
    return at + 1 if words[:1] == ["everything"] and at < len(words) and words[at] in LOOKS else 0


def _animal(tokens: Sequence[Token], at: int, words: list[str]) -> int:
    """Read "a cat sleeping on the sofa", not "a cat bed"."""
    first = grammar().at(tokens, at, "determiners", "count")
    start = first.length if first is not None and first.value not in ("no", "none") else 0
    while start and start < len(words) - 1 and _is_in(words[start], "coats"):
        start += 1
    if start >= len(words) or not _is_in(words[start], "animals") or tokens[at + start].owner:
        return 0
    after = at + start + 1
    if after < len(tokens) and tokens[after].text == "with":
        return start + 1
    if after >= len(tokens) or tokens[after].kind == "mark" or grammar().at(tokens, after, "joins"):
        return start + 1
    doing = grammar().at(tokens, after, "verbs", "participles", "prepositions", "states")
    if doing is None and not tokens[after].text.endswith("ing"):
        return 0
    length = _to_end(tokens, at, start + 1)
    links = ((n, grammar().at(tokens, n, "prepositions")) for n in range(after, at + length))
    # Where it lies is a thing like others, and is asked for.
    return next((n + link.length - at for n, link in links if link is not None), length)


def _ends(words: list[str], at: int) -> bool:
    """Whether a clause ends at `at`."""
    return at >= len(words) or not words[at][:1].isalnum() or _is_in(words[at], "clause_ends")


def _to_end(tokens: Sequence[Token], at: int, length: int) -> int:
    """The length up to the next mark, "and" or "with", or to a thing that is new."""
    end = at + length
    while end < min(len(tokens), at + _LONGEST) and tokens[end].kind != "mark":
        if grammar().at(tokens, end, "joins") or _is_in(tokens[end].text, "stretch_ends"):
            break
        end += 1
    return end - at
