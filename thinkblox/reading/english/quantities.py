"""What stands before the nouns of a phrase: determiners, numbers, measures."""

from thinkblox.assets import kind_of
from thinkblox.assets.plurals import singular
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.words import Words
from thinkblox.reading.tokens import Token

_OF_EVERY = ("out of every", "out of each", "of every", "in every", "of each")
_SHARES = {"half": 0.5, "twice": 2.0, "two": 2.0, "three": 3.0, "four": 4.0, "five": 5.0}
"""How many of others "half as many", "three times as many" are, by the first word."""
_PILES = 2
"""So many stacks are several, where nobody says how many."""
_STACKS = ("stack", "pile", "heap")
"""Measures that say how the things lie, besides how many they are."""
_OF_MATTER = ("sheet", "ball", "cube", "lump", "slice", "mountain")
"""Measures of things that we know; of others they are things themselves: "a ball of fire"."""
_KINDS = ("kind", "type", "sort")
SHELVES = "bookcase"
"""What stands where a wall is said to be of what lies on it: "a wall of books"."""
_WHOLES = ("roll", "string", "bundle", "piece", *_OF_MATTER[:-1], "loaf", *_KINDS)
"""Measures of which one is one thing: "a roll of paper", "the kind of sofa"."""
_LEADING = ("determiners", "quantifiers", "count", "vague", "measures", "fractions", "ordinal")
"""Sections of the grammar whose words begin a noun phrase."""


class Quantities(Words):
    """Reads determiners and quantities."""

    def _before(self, noun: Noun, at: int) -> int:
        """Where the noun phrase goes on that begins at `at`, after its determiner and quantity."""
        if not self._may_lead(self.tokens[at]):
            return at
        while at < len(self.tokens):
            step = (
                self._fraction(noun, at)
                or self._quantity(noun, at)
                or self._determiner(noun, at)
                or self._measure(noun, at)
                or self._shaped_measure(noun, at)
            )
            step = step or self._ordinal(noun, at) or self._partitive(noun, at) or self._size(noun, at)
            if not step:
                return at
            at += step
        return at

    def _may_lead(self, token: Token) -> bool:
        """Whether a token can be the first of a determiner or quantity."""
        return token.kind == "number" or token.text == "between" or grammar().begins(token.text, *_LEADING)

    def _determiner(self, noun: Noun, at: int) -> int:
        found = grammar().all_at(self.tokens, at, "determiners")
        if not found or noun.count is not None or noun.ordinal or noun.rows:
            return 0
        best = found[0]
        thing = self.thing_at(at)
        if thing is not None and thing.length > best.length:
            return 0
        if noun.det and not (best.value == "other" and noun.det == "the") and best.value not in ("my", "any"):
            return 0
        if best.value == "another" and self._number(at + best.length) is None:
            noun.count = noun.count or 1
        noun.det = noun.det if noun.det in ("each", "both", "half", "none", "no") else best.value
        noun.of_known |= best.value in ("half", "none")
        self._every(noun, at + best.length)
        return best.length + (1 if noun.every == -1 else 0)

    def _fraction(self, noun: Noun, at: int) -> int:
        """Read "three out of every four", "two thirds of the", "a quarter of them"."""
        if noun.of_known:
            return 0
        said = grammar().at(self.tokens, at, "fractions")
        if said is not None and noun.count is None and not noun.det:
            parts, whole = said.value.split("_")
            noun.fraction = (int(parts), int(whole))
            after = self.tokens[at + said.length].text if at + said.length < len(self.tokens) else ""
            known = after in ("the", "these", "those", "them", "which", "my", "our", "all")
            noun.of_known = known
            noun.count = 1 if known else None
            return said.length + 1 if known else 0
        start = next((n for n in (3, 2) if self._words_at(at, n) in _OF_EVERY), 0) if noun.count else 0
        number = self._number(at + start) if start else None
        if number is None or not noun.count or number[0] <= noun.count or not self._starts_noun(at + start + number[1]):
            return 0
        noun.fraction, noun.of_known = (noun.count, number[0]), True
        return start + number[1]

    def _words_at(self, at: int, length: int) -> str:
        return " ".join(token.text for token in self.tokens[at : at + length])

    def _every(self, noun: Noun, at: int) -> None:
        """Read "every second chair", "every two loungers"."""
        if noun.det != "each" or at >= len(self.tokens) or self.tokens[at - 1].text not in ("each", "every"):
            return
        ordinal = grammar().at(self.tokens, at, "ordinal")
        if self.tokens[at].text in ("second", "other"):
            noun.every, noun.counted = 2, False
        elif ordinal is not None and int(ordinal.value) > 2:
            noun.every, noun.counted = int(ordinal.value), False
        elif (number := self._number(at)) is not None and number[0] > 1:
            noun.every, noun.counted = number[0], True

    def _ordinal(self, noun: Noun, at: int) -> int:
        token = self.tokens[at].text
        found = grammar().at(self.tokens, at, "ordinal")
        if noun.every and not noun.counted and (token == "other" or found is not None):
            return 1
        if (
            found is None
            or (noun.det not in ("the", "my", "a") and not noun.of_known)
            or (noun.det == "a" and self._starts_noun(at + found.length))
        ):
            return 0
        noun.ordinal = int(found.value)
        noun.count = noun.count or 1
        return found.length

    def _quantity(self, noun: Noun, at: int) -> int:
        if noun.count is not None and not (noun.det == "a" and noun.vague):
            return 0
        quantifier = next(iter(grammar().all_at(self.tokens, at, "quantifiers")), None)
        if quantifier is not None and quantifier.value == "relative":
            noun.share = _SHARES.get(self.tokens[at].text, 1.0)
            noun.plural = True
            return quantifier.length
        if self.tokens[at].text == "between" and (between := self._between(noun, at)):
            return between
        skip = quantifier.length if quantifier else 0
        if self.size_at(at) is not None:
            return 0
        number = self._number(at + skip)
        if number is None and self.tokens[at].text == "some" and skip == 1 and self._starts_noun(at + 1):
            return 1
        if number is None:
            return 0 if quantifier else self._vague(noun, at)
        value, length = number
        value //= self._halved(at + skip, length)
        prepositional = self.tokens[at].text in ("around", "about", "over", "under", "up") and value < 2
        if quantifier and (prepositional or self.size_at(at + skip) is not None):
            return 0
        if self._is_word_of_compound(at + skip, length) or self._is_twin_bed(noun, at + skip):
            return 0
        noun.count = min(value, 10**6)
        self._bound(noun, quantifier.value if quantifier else "", value)
        length += self._range(noun, at + skip + length)
        length += self._besides(noun, at + skip + length)
        return skip + length + self._times(at + skip + length)

    def _besides(self, noun: Noun, at: int) -> int:
        """Read "two more", "one other", "three others": so many besides those that were named."""
        if noun.det or self._text(at, at + 1).lower() not in grammar().lists["besides"]:
            return 0
        if self._text(at + 1, at + 2) == "than":
            return 0
        noun.det = "another"
        return 1

    def _is_twin_bed(self, noun: Noun, at: int) -> bool:
        """Whether "twin" is a size: "a twin bed"; "twin armchairs" are two."""
        single = bool(noun.det) or not self._text(at + 1, at + 2).lower().endswith("s")
        return self.tokens[at].text == "twin" and single

    def _halved(self, at: int, length: int) -> int:
        """2 for "a pair of scissors", which is one thing; else 1."""
        if not self.tokens[at + length - 2].text.startswith("pair"):
            return 1
        words = {token.text for token in self.tokens[at + length : at + length + 4]}
        return 2 if words & grammar().lists["pairs"] else 1

    def _is_word_of_compound(self, at: int, length: int) -> bool:
        """Whether a number belongs to an adjective: "two-burner stove", "ten-year-old"."""
        last = at + length - 1
        return self.tokens[last].glued and self._number(last + 1) is None

    def _bound(self, noun: Noun, kind: str, value: int) -> None:
        match kind:
            case "ge":
                noun.least = value
            case "gt":
                noun.least = noun.count = value + 1
            case "le":
                noun.most = value
            case "lt":
                noun.most = max(value - 1, 0)
                noun.count = max(1, noun.most)
            case "about":
                noun.vague = True

    def _between(self, noun: Noun, at: int) -> int:
        low = self._number(at + 1)
        if low is None or at + 1 + low[1] >= len(self.tokens) or self.tokens[at + 1 + low[1]].text != "and":
            return 0
        high = self._number(at + 2 + low[1])
        if high is None or high[0] <= low[0]:
            return 0
        noun.least, noun.most, noun.count = low[0], high[0], (low[0] + high[0]) // 2
        return 2 + low[1] + high[1]

    def _range(self, noun: Noun, at: int) -> int:
        """Read "six to eight", "2 or 3", "five or more"."""
        if at >= len(self.tokens) or noun.count is None:
            return 0
        joined = self.tokens[at].text in ("to", "or", "–") or self.tokens[at - 1].glued
        skip = 0 if self.tokens[at - 1].glued else 1
        high = self._number(at + skip) if joined else None
        if high is not None and high[0] > noun.count:
            noun.least, noun.most, noun.count = noun.count, high[0], noun.count
            return skip + high[1]
        if self.tokens[at].text == "or" and at + 1 < len(self.tokens) and self.tokens[at + 1].text == "more":
            noun.least = noun.count
            return 2
        return 0

    def _times(self, at: int) -> int:
        if at >= len(self.tokens) or self.tokens[at].text != "x" or self.tokens[at].glued:
            return 0
        return 1 if self._starts_noun(at + 1) else 0

    def _vague(self, noun: Noun, at: int) -> int:
        found = grammar().at(self.tokens, at, "vague")
        if found is None or not (self._starts_noun(at + found.length)):
            return 0
        noun.count, noun.vague, noun.plural = int(found.value), True, True
        noun.least = 2
        return found.length

    def _measure(self, noun: Noun, at: int) -> int:
        found = grammar().at(self.tokens, at, "measures")
        thing = self.thing_at(at)
        inner_thing = self.thing_at(at + found.length) if found is not None else None
        same = thing is not None and inner_thing is not None and inner_thing.entry.value == thing.entry.value
        same |= found is not None and found.value == "row" and inner_thing is not None
        if found is None or (thing is not None and thing.length > found.length and not same):
            return 0
        word = self.tokens[at].text
        several = word.endswith("s")
        if not (noun.det or noun.count is not None or several) or noun.rows or noun.groups:
            return 0
        if word.rstrip("s") in _OF_MATTER and inner_thing is None:
            return 0
        if found.value == "wall" and not self._lines_a_wall(at + found.length):
            return 0
        outer, noun.count = noun.count, None
        noun.plural = True
        match found.value:
            case "row" | "wall":
                noun.rows, noun.walled = outer or (-1 if several else 1), found.value == "wall"
            case "group":
                noun.groups, noun.group = outer or (-1 if several else 1), singular(word)
            case _:
                self._pile(noun, at, found.length, outer)
        noun.plural = noun.count != 1 or noun.vague
        noun.det = "" if noun.det in ("a", "another") else noun.det
        inner = self._number(at + found.length)
        if found.value == "pile" and noun.vague and outer is None and self._bounds_follow(at + found.length):
            noun.count, noun.vague, noun.least = None, False, None
        if inner is not None and noun.vague and (found.value == "pile" or not (noun.rows or noun.groups)):
            noun.count, noun.vague, noun.least = inner[0] * (outer or noun.groups or 1), False, None
            return found.length + inner[1]
        if inner is not None and noun.rows + noun.groups > 0:
            noun.count = inner[0] * (noun.rows or noun.groups)
            return found.length + inner[1]
        return found.length

    def _lines_a_wall(self, at: int) -> bool:
        """Whether a thing that takes up a wall comes, after its number where it has one."""
        number = self._number(at)
        thing = self.thing_at(at + (number[1] if number is not None else 0))
        return thing is not None and lines_a_wall(thing.entry.value)

    def _bounds_follow(self, at: int) -> bool:
        """Whether "at least three", "several" comes, so that a pile is of as many."""
        bound = next(iter(grammar().all_at(self.tokens, at, "quantifiers")), None)
        counted = bound is not None and self._number(at + bound.length) is not None
        return counted or grammar().at(self.tokens, at, "vague") is not None

    def _pile(self, noun: Noun, at: int, length: int, outer: int | None) -> None:
        """Read "each pair of", "two pairs of", "a stack of", "a piece of"."""
        word = self.tokens[at].text
        several = word.endswith("s")
        if word == "pair" and noun.det == "each":
            noun.every, noun.counted = 2, True
        elif word.startswith("pair"):
            words = [token.text for token in self.tokens[at + length : at + length + 4]]
            noun.count = (1 if set(words) & grammar().lists["pairs"] else 2) * (outer or 1)
        elif word.rstrip("s") in _WHOLES:
            noun.count = outer or (None if several else 1)
            noun.called = "" if word.rstrip("s") in _KINDS else f"{singular(word)} of"
        else:
            outer = _PILES if outer is None and several and singular(word) in _STACKS else outer
            noun.count, noun.vague, noun.least = (outer or 1) * 3, True, 1
            if singular(word) in _STACKS:
                noun.states.append("stacked")
                noun.groups, noun.group = (outer, singular(word)) if outer is not None and outer > 1 else (0, "")

    def _shaped_measure(self, noun: Noun, at: int) -> int:
        """Pass over the adjective of a measure: "two parallel rows of", "a long line of"."""
        if self.tokens[at].text not in grammar().lists["lining"] or not (noun.det or noun.count is not None):
            return 0
        found = grammar().at(self.tokens, at + 1, "measures") if at + 1 < len(self.tokens) else None
        return 1 if found is not None and found.value in ("row", "wall") else 0

    def _partitive(self, noun: Noun, at: int) -> int:
        """Read the "of the" in "two of the towels", "three of them", "half of those"."""
        if noun.count is None and noun.det not in ("each", "both", "half", "none", "all", "no"):
            return 0
        if self.tokens[at].text != "of" or noun.of_known or at + 1 >= len(self.tokens):
            return 0
        after = self.tokens[at + 1].text
        if noun.count == 1 and (number := self._number(at + 1)) is not None and self._starts_noun(at + 1 + number[1]):
            noun.of_known, noun.total = number[0] > 1, number[0]  # "next to one of two bookcases"
            return 1 + number[1] if noun.of_known else 0
        if after in ("the", "these", "those", "my", "our", "their", "his", "her", "its"):
            noun.of_known = True
            number = self._number(at + 2)
            if number is None or (self.thing_at(at + 2) is not None and self._starts_noun(at + 2 + number[1]) is False):
                return 2 + (number[1] if number is not None else 0)
            noun.total = number[0] if noun.count is not None else 0
            return 2 + number[1] if noun.total or not self._starts_noun(at + 2 + number[1]) else 2
        if after in ("them", "which", "whom"):
            noun.of_known = True
            return 2
        return 0

    def _size(self, noun: Noun, at: int) -> int:
        if not noun.det or noun.count is not None or noun.size is not None:
            return 0
        found = self.size_at(at)
        if found is None:
            return 0
        noun.size = found[0]
        return found[1] - at


def lines_a_wall(category: str) -> bool:
    """Whether several of it, or of what it stands on, take up a wall: bookcases, mirrors, books."""
    habits = load_habits()
    usual = habits.of(category) if habits.is_in(category, "storage") else habits.of(category)[:1]
    stands = any(habit.kind == "against_wall" for habit in usual)
    return stands or kind_of(category).mount == "wall" or is_shelved(category)


def is_shelved(category: str) -> bool:
    """Whether a bookcase that is full is full of it."""
    return load_habits().is_in(category, "fills_shelves")
