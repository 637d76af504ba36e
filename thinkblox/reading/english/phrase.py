"""Noun phrases with any noun: determiner, quantity, modifiers, head."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from thinkblox.assets.names import identifier_of
from thinkblox.assets.palette import COLOURS
from thinkblox.assets.repaint import MATERIALS
from thinkblox.assets.stand_ins import noun_of
from thinkblox.knowledge.vocabulary import is_abstract, is_person, thing_called
from thinkblox.reading.english.chunks import Adjective, Noun
from thinkblox.reading.english.grammar import Function, grammar
from thinkblox.reading.english.plurals import PAIRS, singular
from thinkblox.reading.lexicon import LONGEST, Entry, Lexicon, Sort
from thinkblox.reading.sizes import read_size
from thinkblox.reading.tokens import Token

_STOPS = ("mutual", "negations", "inverses", "prepositions", "verbs", "joins", "determiners", "quantifiers")
_MOST = 200
"""Largest number that is taken for a count; a larger one is cut to it where it is used."""
_NAMES = 5
"""Most unknown words that one name has."""


@dataclass(frozen=True)
class Known:
    """A phrase of the lexicon."""

    entry: Entry
    length: int
    others: tuple[Entry, ...] = ()


@dataclass
class _Unit:
    """A word or phrase of a noun phrase, besides its determiner and quantity."""

    text: str
    known: Known | None = None
    owner: bool = False


@dataclass
class _Units:
    """What was read between the quantity and the end of a noun phrase."""

    nouns: list[_Unit] = field(default_factory=list)
    adjectives: int = 0


class PhraseReader:
    """Reads noun phrases of one text."""

    def __init__(self, lexicon: Lexicon, tokens: Sequence[Token]) -> None:
        self.lexicon = lexicon
        self.tokens = list(tokens)
        self.group = False
        self._seen: dict[tuple[int, tuple[str, ...]], Known | None] = {}

    def read(self, start: int, *, after_preposition: bool = False) -> Noun | None:
        """The noun phrase that begins at `start`, or None."""
        noun = Noun("abstract", "", start, start)
        pronoun = grammar().at(self.tokens, start, "pronouns")
        if pronoun is not None and pronoun.value in ("former", "latter"):
            noun.kind, noun.value, noun.end = "pronoun", pronoun.value, start + pronoun.length
            return self._finished(noun)
        at = self._before(noun, start)
        if noun.ordinal and self._number(at) is not None:
            noun.kind, noun.end = "number", at
            return self._finished(noun)
        self.group = noun.det in ("all", "both", "other", "half", "none")
        if self._part(noun, at, after_preposition=after_preposition):
            return self._finished(noun)
        units = _Units()
        end = self._units(noun, at, units)
        if not units.nouns:
            return self._headless(noun, at, end, units)
        noun.end = end
        self._head(noun, units)
        self._size_after(noun)
        return self._finished(noun)

    def adjective(self, start: int) -> Adjective | None:
        """Adjectives without a noun at `start`, or None."""
        noun = Noun("abstract", "", start, start)
        at = start
        while at < len(self.tokens) and (length := self._adjective(noun, at)):
            at += length
        if at == start:
            return None
        return Adjective(start, at, self._text(start, at), noun.attributes, noun.styles, noun.unshown, noun.states)

    def thing_at(self, at: int) -> Known | None:
        """The longest name of a thing that begins at `at`."""
        return self._known(at, "object", "missing")

    # --- what stands before the nouns

    def _before(self, noun: Noun, at: int) -> int:
        while at < len(self.tokens):
            step = self._quantity(noun, at) or self._determiner(noun, at) or self._measure(noun, at)
            step = step or self._ordinal(noun, at) or self._partitive(noun, at) or self._size(noun, at)
            if not step:
                return at
            at += step
        return at

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
        if best.value == "another":
            noun.count = noun.count or 1
        noun.det = noun.det if noun.det in ("each", "both", "half", "none", "no") else best.value
        noun.of_known |= best.value in ("half", "none")
        self._every(noun, at + best.length)
        return best.length + (1 if noun.every == -1 else 0)

    def _every(self, noun: Noun, at: int) -> None:
        """Read "every second chair", "every two loungers"."""
        if noun.det != "each" or at >= len(self.tokens) or self.tokens[at - 1].text not in ("each", "every"):
            return
        if self.tokens[at].text in ("second", "other"):
            noun.every, noun.counted = 2, False
        elif (number := self._number(at)) is not None and number[0] > 1:
            noun.every, noun.counted = number[0], True

    def _ordinal(self, noun: Noun, at: int) -> int:
        token = self.tokens[at].text
        if noun.every == 2 and token in ("second", "other"):
            return 1
        found = grammar().at(self.tokens, at, "ordinal")
        if (
            found is None
            or noun.det not in ("the", "my", "a")
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
            noun.share = {"half": 0.5, "twice": 2.0}.get(self.tokens[at].text, 1.0)
            noun.plural = True
            return quantifier.length
        if self.tokens[at].text == "between" and (between := self._between(noun, at)):
            return between
        skip = quantifier.length if quantifier else 0
        if read_size(self.lexicon, self.tokens, at) is not None:
            return 0
        number = self._number(at + skip)
        if number is None:
            return 0 if quantifier else self._vague(noun, at)
        value, length = number
        prepositional = self.tokens[at].text in ("around", "about", "over", "under", "up") and value < 2
        if quantifier and (prepositional or read_size(self.lexicon, self.tokens, at + skip) is not None):
            return 0
        if self._is_word_of_compound(at + skip, length):
            return 0
        noun.count = min(value, 10**6)
        self._bound(noun, quantifier.value if quantifier else "", value)
        length += self._range(noun, at + skip + length)
        return skip + length + self._times(at + skip + length)

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
        if at >= len(self.tokens) or self.tokens[at].text != "x":
            return 0
        return 1 if self._starts_noun(at + 1) else 0

    def _number(self, at: int) -> tuple[int, int] | None:
        """A whole number and how many tokens it takes."""
        if not 0 <= at < len(self.tokens):
            return None
        token = self.tokens[at]
        if token.kind == "number" and self._is_inner_number(at):
            return None
        if token.kind == "number":
            whole = token.value == int(token.value) and 0 <= token.value < 10**9
            return (int(token.value), 1) if whole else None
        found = grammar().at(self.tokens, at, "count")
        if found is None:
            return None
        thing = self.thing_at(at)
        if thing is not None and thing.length > found.length and (token.glued or not thing.entry.plural):
            return None
        value, length = int(found.value), found.length
        if value >= 20 and value % 10 == 0 and (unit := grammar().at(self.tokens, at + length, "count")):
            if 0 < int(unit.value) < 10 and unit.length == 1:
                return value + int(unit.value), length + 1
        if at + length < len(self.tokens) and self.tokens[at + length].text == "dozen":
            return value * 12, length + 1
        return value, length

    def _is_inner_number(self, at: int) -> bool:
        """Whether a number is the end of a word: "CO2"."""
        before = self.tokens[at - 1] if at else None
        return (
            before is not None
            and before.kind == "word"
            and before.text != "x"
            and before.start + len(before.shown) == self.tokens[at].start
        )

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
        if found is None or (thing is not None and thing.length > found.length and not same):
            return 0
        word = self.tokens[at].text
        several = word.endswith("s")
        if not (noun.det or noun.count is not None or several) or noun.rows or noun.groups:
            return 0
        outer, noun.count = noun.count, None
        noun.plural = True
        match found.value:
            case "row":
                noun.rows = outer or (-1 if several else 1)
            case "group":
                noun.groups, noun.group = outer or (-1 if several else 1), singular(word)
            case _ if word.startswith("pair"):
                words = [token.text for token in self.tokens[at + found.length : at + found.length + 4]]
                noun.count = (1 if set(words) & set(PAIRS) else 2) * (outer or 1)
            case _:
                noun.count, noun.vague = (outer or 1) * 3, True
                noun.least = 1
        noun.det = "" if noun.det in ("a", "another") else noun.det
        inner = self._number(at + found.length)
        if inner is not None and noun.rows + noun.groups > 0:
            noun.count = inner[0] * (noun.rows or noun.groups)
            return found.length + inner[1]
        return found.length

    def _partitive(self, noun: Noun, at: int) -> int:
        """Read the "of the" in "two of the towels", "three of them", "half of those"."""
        if noun.count is None and noun.det not in ("each", "both", "half", "none", "all", "no"):
            return 0
        if self.tokens[at].text != "of" or noun.of_known or at + 1 >= len(self.tokens):
            return 0
        after = self.tokens[at + 1].text
        if after in ("the", "these", "those", "my", "our", "their", "his", "her", "its"):
            noun.of_known = True
            number = self._number(at + 2)
            bare = number is not None and not self._starts_noun(at + 2 + number[1])
            return 2 + number[1] if number is not None and bare else 2
        if after in ("them", "which", "whom"):
            noun.of_known = True
            return 2
        return 0

    def _size(self, noun: Noun, at: int) -> int:
        if not noun.det or noun.count is not None or noun.size is not None:
            return 0
        found = read_size(self.lexicon, self.tokens, at)
        if found is None:
            return 0
        noun.size = found[0]
        return found[1] - at

    # --- parts

    def _part(self, noun: Noun, at: int, *, after_preposition: bool) -> bool:
        part = self._longest_part(at)
        if part is None or not (noun.det or noun.count is not None or after_preposition or noun.ordinal):
            return False
        place = self._known(at, "place")
        after = at + part.length
        if place is not None and place.length > part.length:
            return False
        if part.value in ("left", "right", "middle", "back", "front", "side", "end", "top", "inside", "head", "foot"):
            if self._verb_follows(after) or self._adjective_ends(after):
                pass
            elif self._starts_noun(after) or self._is_one(after):
                noun.side = part.value if part.value in ("left", "right", "middle") else ""
                return False
        if part.value == "in_shelf" and part.length < 2:
            return False
        noun.kind, noun.value, noun.end = "part", part.value, after
        noun.plural = self.tokens[after - 1].text.endswith("s")
        if noun.det == "no":
            return False
        return True

    def _adjective_ends(self, at: int) -> bool:
        """Whether only an adjective comes: "leave the middle free for ..."."""
        state = grammar().at(self.tokens, at, "states")
        return state is not None and not self._starts_noun(at + state.length)

    def _verb_follows(self, at: int) -> bool:
        """Whether a verb and then another noun phrase come: "in the middle stand two tables"."""
        verb = grammar().at(self.tokens, at, "verbs")
        if verb is None:
            return False
        return grammar().at(self.tokens, at + verb.length, "determiners", "quantifiers", "count", "vague") is not None

    def _longest_part(self, at: int) -> Function | None:
        if at >= len(self.tokens):
            return None
        return grammar().at(self.tokens, at, "parts")

    def _is_one(self, at: int) -> bool:
        return at < len(self.tokens) and self.tokens[at].text in ("one", "ones")

    def _starts_noun(self, at: int) -> bool:
        """Whether nouns or their modifiers come at `at`."""
        if at >= len(self.tokens) or self.tokens[at].kind != "word":
            return False
        if self._known(at, "object", "room", "missing", "attribute", "style") is not None:
            return True
        if grammar().at(self.tokens, at, *_STOPS, "fillers", "participles", "pronouns") is not None:
            return self._known(at, "place") is not None and self.tokens[at].text not in ("in", "on", "at")
        return True

    # --- nouns and their modifiers

    def _units(self, noun: Noun, at: int, units: _Units) -> int:
        if noun.ordinal and grammar().at(self.tokens, at, "verbs", "participles") is not None:
            return at
        while at < len(self.tokens) and self.tokens[at].kind != "mark":
            length = self._unit(noun, at, units)
            if not length:
                break
            at += length
        return at

    def _unit(self, noun: Noun, at: int, units: _Units) -> int:
        if self.tokens[at].text in ("x", "one", "ones") and (units.nouns or units.adjectives or noun.det):
            return 0
        if self.tokens[at].text == "x":
            return 0
        if units.nouns and units.nouns[-1].owner and (part := self._longest_part(at)) is not None:
            units.nouns.append(_Unit(self._text(at, at + part.length)))
            return part.length
        known = self._without_verb(noun, at, self._known(at, "object", "missing", "room", "place"))
        stop = grammar().at(self.tokens, at, *_STOPS)
        if not units.nouns and (length := self._side(noun, at)):
            return length
        if self.tokens[at].glued and (known is None or not self._covers(at, known.length)):
            if length := self._glued(noun, at, units):
                return length
        if known is not None and not units.nouns and self._is_shade(at, known.length):
            known = None
        if known is not None and self._is_better(known, stop, units):
            if known.entry.sort == "place" and units.nouns:
                if known.entry.value != "centre" or known.length > 1 or noun.det == "the":
                    return 0
                units.nouns.append(_Unit(self.tokens[at].shown))
                return 1
            last = at + known.length - 1
            units.nouns.append(_Unit(self._text(at, at + known.length), known, self.tokens[last].owner))
            return known.length
        if not units.nouns and (length := self._adjective(noun, at)):
            if stop is None or length > stop.length or self._continues(noun, at + length):
                units.adjectives += 1
                return length
            self._forget(noun)
            return 0
        if stop is not None:
            return self._despite(noun, at, stop, units)
        return self._open(noun, at, units)

    def _is_shade(self, at: int, length: int) -> bool:
        """Whether what names a thing too is the colour or material of what follows: "orange cushions", "a glass table"."""
        said = self._known(at, "attribute")
        return (
            said is not None and said.length == length and _is_look(said.entry.value) and self._starts_noun(at + length)
        )

    def _covers(self, at: int, length: int) -> bool:
        """Whether a phrase covers all that hyphens join at `at`."""
        return not self.tokens[at + length - 1].glued

    def _without_verb(self, noun: Noun, at: int, known: Known | None) -> Known | None:
        """Part "a tall plant | stands near the door" from "two plant stands"."""
        if known is None or known.length < 2 or not known.entry.plural:
            return known
        if noun.count not in (None, 1) or (noun.count is None and noun.det not in ("a", "each", "another")):
            return known
        if grammar().at(self.tokens, at + known.length - 1, "verbs") is None:
            return known
        shorter = self.lexicon.longest(self.tokens, at, known.length - 1)
        entry = shorter.entry("object", "missing", "room", "place")
        return Known(entry, shorter.length) if entry is not None else known

    def _forget(self, noun: Noun) -> None:
        noun.attributes.clear()
        noun.styles.clear()
        noun.states.clear()

    def _is_better(self, known: Known, stop: Function | None, units: _Units) -> bool:
        if stop is None or known.length > stop.length:
            return True
        if known.length < stop.length:
            return False
        if stop.sort in ("verbs", "participles"):
            return not units.nouns and not self.group
        return stop.sort not in ("prepositions", "joins", "inverses", "determiners", "negations")

    def _side(self, noun: Noun, at: int) -> int:
        """Read the "left" of "the left nightstand"."""
        text = self.tokens[at].text
        if noun.det not in ("the", "my") or text not in ("left", "right", "middle") or noun.side:
            return 1 if noun.side == text else 0
        following = self._known(at + 1, "object", "missing")
        if following is None and not self._is_one(at + 1):
            return 0
        noun.side = text
        return 1

    def _despite(self, noun: Noun, at: int, stop: Function, units: _Units) -> int:
        """Take a verb for a noun or adjective where a noun has to come: "the stand", "a hanging lamp"."""
        if stop.sort not in ("verbs", "participles") or units.nouns or not (noun.det or noun.count is not None):
            return 0
        if noun.det in ("other", "both", "all", "half", "none"):
            return 0
        if self.tokens[at - 1].text in ("this", "that", "these", "those"):
            return 0
        if stop.sort == "verbs" and grammar().at(self.tokens, at + stop.length, "determiners", "count", "quantifiers"):
            return 0
        if self._starts_noun(at + stop.length):
            units.adjectives += 1
            return stop.length
        if (
            stop.length > 1
            or stop.value == "be"
            or self.tokens[at].text in ("is", "are", "was", "has", "have", "needs", "gets")
        ):
            return 0
        units.nouns.append(_Unit(self.tokens[at].shown))
        return 1

    def _open(self, noun: Noun, at: int, units: _Units) -> int:
        """Take a word that no list has."""
        token = self.tokens[at]
        filler = grammar().at(self.tokens, at, "fillers")
        if filler is not None:
            can = (noun.det or noun.count is not None or units.adjectives) and not units.nouns
            return filler.length if can and self._starts_noun(at + filler.length) else 0
        if grammar().at(self.tokens, at, "participles", "pronouns") is not None:
            can = (noun.det or noun.count is not None) and not units.nouns and self._starts_noun(at + 1)
            return 1 if can else 0
        if token.kind == "number" and self._is_inner_number(at) and units.nouns:
            return 1
        if token.kind != "word":
            return 0
        if token.owner:
            units.nouns.append(_Unit(token.shown, None, True))
            return 1
        if token.text.endswith("ly") and len(token.text) > 4 and self._known(at + 1, "object") is None:
            return 1 if self._starts_noun(at + 1) and not units.nouns else 0
        if units.nouns and self._is_verb(at, units):
            return 0
        if units.nouns and units.nouns[-1].known is not None and not units.nouns[-1].owner:
            if not self._ends_name(at, units):
                return 0
        if len(units.nouns) >= _NAMES:
            return 0
        if not units.nouns and token.text.endswith(("ed", "ing", "en", "ous", "ful", "ic", "less", "ish", "ive", "ly")):
            if self._starts_noun(at + 1) and self._has_noun(at + 1):
                noun.unshown.append(token.shown.lower())
                units.adjectives += 1
                return 1
        units.nouns.append(_Unit(token.shown))
        return 1

    def _ends_name(self, at: int, units: _Units) -> bool:
        """Whether an unknown word after a known noun is the head of a longer name: "popcorn machine"."""
        word = self.tokens[at].text
        if grammar().at(self.tokens, at, "abstract", "people") or self._known(at, "attribute", "style"):
            return False
        after = at + 1
        ends = after >= len(self.tokens) or self.tokens[after].kind != "word"
        return ends or word in _HEADS or not self._starts_noun(after) or self._known(after, "object") is None

    def _is_verb(self, at: int, units: _Units) -> bool:
        """Whether an unknown word looks like the verb of the noun before it."""
        word = self.tokens[at].text
        if not word.endswith(("s", "ed", "ing")) or word.endswith("ss"):
            return False
        return (
            at + 1 < len(self.tokens)
            and (
                grammar().at(self.tokens, at + 1, "determiners", "prepositions", "quantifiers", "count", "pronouns")
                is not None
            )
            and units.nouns[-1].known is not None
        )

    def _has_noun(self, at: int) -> bool:
        """Whether the phrase goes on to a noun within a few words."""
        for index in range(at, min(at + 4, len(self.tokens))):
            if self.tokens[index].kind != "word" or grammar().at(self.tokens, index, *_STOPS):
                return False
            if self._known(index, "object", "missing", "room"):
                return True
            if not self._known(index, "attribute", "style"):
                return True
        return False

    def _continues(self, noun: Noun, at: int) -> bool:
        return bool(noun.det or noun.count is not None) and self._starts_noun(at)

    def _glued(self, noun: Noun, at: int, units: _Units) -> int:
        """Read words that hyphens join: "bottle-green", "butcher-block", "two-burner"."""
        end = at
        while end < len(self.tokens) and self.tokens[end].glued:
            end += 1
        if end == at or end >= len(self.tokens):
            return 0
        last = self._known(end, "attribute", "style")
        whole = self._known(at, "object", "missing", "attribute", "style", "room", "place")
        if whole is not None and at + whole.length > end:
            return 0
        if grammar().at(self.tokens, at, "states") and grammar().at(self.tokens, at, "states").length > end - at:  # type: ignore[union-attr]
            return 0
        name = "-".join(token.shown for token in self.tokens[at : end + 1]).lower()
        if self._seats(noun, at, end):
            return end + 1 - at
        if last is not None and last.entry.sort == "attribute":
            noun.attributes.append(last.entry.value)
            units.adjectives += 1
        elif self._starts_noun(end + 1) and self._has_noun(end + 1):
            evaluative = grammar().at(self.tokens, at, "evaluative")
            if evaluative is None or evaluative.length <= end - at:
                noun.unshown.append(name)
            units.adjectives += 1
        elif self._known(end, "object") is not None:
            return end - at
        else:
            units.nouns.append(_Unit(name))
        return end + 1 - at

    def _seats(self, noun: Noun, at: int, end: int) -> bool:
        number = self._number(at)
        word = self.tokens[end].text
        if number is None or word not in ("person", "seat", "seater", "people", "place"):
            return False
        noun.seats = number[0]
        noun.attributes.append(f"for-{number[0]}")
        return True

    def _adjective(self, noun: Noun, at: int) -> int:
        """Take an adjective; returns the tokens it takes."""
        known = self._known(at, "attribute", "style")
        state = grammar().at(self.tokens, at, "states")
        evaluative = grammar().at(self.tokens, at, "evaluative")
        longest = max((f.length for f in (state, evaluative) if f), default=0)
        thing = self.thing_at(at)
        if thing is not None and thing.length >= max(longest, known.length if known else 0):
            if not (known and known.length == thing.length and self._starts_noun(at + thing.length)):
                return 0
        if known is not None and known.length >= longest:
            state = state if state is not None and state.length == known.length else None
            for entry in (known.entry, *known.others):
                if entry.sort == "attribute" and state is not None:
                    noun.states.append(self._text(at, at + known.length).lower())
                    state = None
                    break
                if entry.sort == "attribute":
                    noun.attributes.append(entry.value)
                elif entry.sort == "style":
                    noun.styles.append(entry.value)
            return known.length
        if state is not None and state.length >= (evaluative.length if evaluative else 0):
            noun.states.append(self._text(at, at + state.length).lower())
            return state.length
        return evaluative.length if evaluative is not None else 0

    # --- heads

    def _head(self, noun: Noun, units: _Units) -> None:
        nouns = units.nouns
        while len(nouns) > 1 and nouns[-1].owner:
            nouns.pop()
        for unit in nouns[:-1]:
            if unit.owner and unit.known is not None and unit.known.entry.sort == "object":
                noun.owner = unit.known.entry.value
        last = nouns[-1]
        part = grammar().phrases.get(tuple(last.text.lower().split()), ())
        if len(nouns) > 1 and nouns[-2].owner and nouns[-2].known is not None and dict(part).get("parts"):
            noun.kind, noun.value, noun.owner = "part", dict(part)["parts"], nouns[-2].known.entry.value
            return
        if len(nouns) > 1 and last.text.lower() in PARTS_OF_THINGS and (whole := nouns[-2].known) is not None:
            if whole.entry.sort == "object":
                self._known_head(noun, whole)
                noun.within = True
                return
        named = [unit for unit in nouns if not unit.owner] or [last]
        if last.known is not None:
            self._known_head(noun, last.known)
            self._modifiers(noun, named[:-1])
            return
        words = list(dict.fromkeys(word for unit in named for word in unit.text.lower().split()))
        if self._people_or_abstract(noun, words):
            return
        noun.kind, noun.named = "thing", False
        noun.plural |= singular(words[-1]) != words[-1]
        noun.value = identifier_of(noun_of(" ".join([*words[:-1], singular(words[-1])])))

    def _known_head(self, noun: Noun, known: Known) -> None:
        entry = known.entry
        noun.value = entry.value
        noun.plural |= entry.plural
        noun.kind = "thing" if entry.sort in ("object", "missing") else entry.sort  # type: ignore[assignment]
        if entry.sort == "missing":
            words = self._text(noun.end - known.length, noun.end).lower().split()
            noun.value = identifier_of(noun_of(" ".join([*words[:-1], singular(words[-1])])))
            noun.plural |= singular(words[-1]) != words[-1]
            noun.named = False
        if entry.attribute:
            noun.attributes.append(entry.attribute)
        noun.material = next((other.value for other in known.others if other.sort == "attribute"), "")
        noun.room = next((other.value for other in known.others if other.sort == "room"), "")

    def _modifiers(self, noun: Noun, units: list[_Unit]) -> None:
        """Nouns before the head tell what it is for; a word that nobody knows may change it."""
        for unit in units:
            words = unit.text.lower().split()
            if unit.known is None and not grammar().phrases.get(tuple(words)):
                noun.unshown.append(unit.text.lower())

    def _people_or_abstract(self, noun: Noun, words: list[str]) -> bool:
        if words[-1] in ("rows", "row", "lines", "columns") and len(words) == 1:
            noun.kind, noun.rows, noun.count = "number", noun.count or -1, None
            return True
        for end in (len(words), 1):
            key = tuple(words[-end:])
            found = dict(grammar().phrases.get(key, ()))
            if "people" in found:
                noun.kind, noun.value = "people", "people"
                return True
            if "abstract" in found:
                noun.kind, noun.value = "abstract", " ".join(words)
                return True
        if is_person(words[-1]):
            noun.kind, noun.value = "people", "people"
            return True
        if is_abstract(words[-1]) and noun.count is None:
            noun.kind, noun.value = "abstract", " ".join(words)
            return True
        return False

    def _size_after(self, noun: Noun) -> None:
        """Read the count of "armchair x2"."""
        at = noun.end
        if at + 1 < len(self.tokens) and self.tokens[at].text == "x" and self.tokens[at + 1].kind == "number":
            noun.count, noun.end = int(self.tokens[at + 1].value), at + 2

    def _headless(self, noun: Noun, at: int, end: int, units: _Units) -> Noun | None:
        """A number, "the left one", or a pronoun."""
        if self._is_one(end) and noun.det == "each":
            noun.kind, noun.value, noun.end = "pronoun", "each", end + 1
            return self._finished(noun)
        if self._is_one(end) and (noun.det or units.adjectives) and not noun.of_known:
            noun.kind, noun.end = "number", end + 1
            noun.plural = self.tokens[end].text == "ones"
            noun.count = noun.count or (None if noun.plural else 1)
            return self._finished(noun)
        if noun.det == "each" and noun.count == 1 and not units.adjectives:
            noun.kind, noun.value, noun.end = "pronoun", "each", max(end, at)
            return self._finished(noun)
        pronoun = grammar().at(self.tokens, noun.start, "pronouns")
        longest = max(end, at)
        if pronoun is not None and noun.start + pronoun.length >= longest and not units.adjectives:
            if noun.count is None or pronoun.value in ("one", "other", "them") or pronoun.length > 1:
                noun.kind, noun.value, noun.end = "pronoun", pronoun.value, noun.start + pronoun.length
                return self._finished(noun)
        if noun.count is not None or noun.rows or noun.of_known:
            noun.kind, noun.end = "number", longest
            return self._finished(noun)
        if noun.det in ("other", "half") and units.adjectives:
            noun.kind, noun.end = "number", longest
            return self._finished(noun)
        if noun.det == "each":
            noun.kind, noun.value, noun.end = "pronoun", "each", longest
            return self._finished(noun)
        if noun.det in ("a", "the", "another", "no", "my") and units.adjectives == 1 and len(noun.attributes) == 1:
            noun.kind, noun.named, noun.end = "thing", False, longest
            noun.value = identifier_of(noun_of(self.tokens[longest - 1].text))
            noun.attributes.clear()
            return self._finished(noun)
        return None

    def _finished(self, noun: Noun) -> Noun:
        noun.text = self._text(noun.start, noun.end)
        if noun.every and noun.counted:
            noun.count = None
        return noun

    # --- words

    def _text(self, start: int, end: int) -> str:
        return " ".join(token.shown for token in self.tokens[start:end])

    def _known(self, at: int, *sorts: Sort) -> Known | None:
        """The longest phrase of the lexicon at `at` that has a meaning of one of these sorts, the first of them."""
        if at >= len(self.tokens) or self.tokens[at].kind != "word":
            return None
        if (at, sorts) not in self._seen:
            self._seen[at, sorts] = self._look_up(at, sorts)
        return self._seen[at, sorts]

    def _look_up(self, at: int, sorts: tuple[Sort, ...]) -> Known | None:
        found: Known | None = None
        key: tuple[str, ...] = ()
        for index in range(at, min(at + LONGEST, len(self.tokens))):
            text = self.tokens[index].text
            if self.tokens[index].owner and index > at:
                text = text.removesuffix("s") if (*key, text) not in self.lexicon.prefixes else text
            key = (*key, text)
            entries = [e for e in self.lexicon.phrases.get(key, ()) if e.sort in sorts]
            if not entries and index == at and self.tokens[index].owner:
                entries = [e for e in self.lexicon.phrases.get((text.removesuffix("s"),), ()) if e.sort in sorts]
            if entries:
                entries.sort(key=lambda entry: sorts.index(entry.sort))
                others = tuple(e for e in self.lexicon.phrases.get(key, ()) if e is not entries[0])
                found = Known(entries[0], index + 1 - at, others)
            if key not in self.lexicon.prefixes:
                break
        if "object" in sorts:
            found = self._plain(at, found)
        return found

    def _plain(self, at: int, found: Known | None) -> Known | None:
        """The name of a thing that the catalogue only has a stand-in for, where it is longer than what was found."""
        words: list[str] = []
        for token in self.tokens[at : at + LONGEST]:
            if token.kind != "word":
                break
            words.append(token.text)
        least = found.length if found is not None else 0
        for length in range(len(words), least, -1):
            named = thing_called(" ".join(words[:length]), length)
            if named is not None:
                others = self.lexicon.phrases.get(tuple(words[:length]), ())
                entry = Entry("object", named.name or named.category, named.plural, named.attribute)
                return Known(entry, length, tuple(e for e in others if e.sort in ("attribute", "room")))
        return found


PARTS_OF_THINGS = (
    "handle", "handles", "lid", "door", "doors", "drawer", "drawers", "leg", "legs", "rim", "edge", "base", "armrest",
    "armrests", "backrest", "wheels", "wheel", "castors", "knob", "knobs", "hook", "hooks", "frame", "compartment",
    "compartments", "burner", "burners", "tier", "tiers", "pages", "cushioned seat", "headrest", "footrest",
)  # fmt: skip
"""Words for parts that things come with."""
_HEADS = (
    "machine",
    "rack",
    "stand",
    "holder",
    "set",
    "box",
    "board",
    "dispenser",
    "organizer",
    "organiser",
    "unit",
    "station",
    "cart",
    "case",
    "tray",
    "press",
    "bench",
    "table",
    "kit",
    "block",
    "rail",
    "bar",
    "screen",
    "panel",
    "light",
    "head",
    "skeleton",
    "arm",
    "jack",
    "bin",
    "cage",
    "pole",
    "frame",
    "tower",
    "cabinet",
    "bottle",
    "pot",
)
"""Words that make a name of the noun before them."""


def _is_look(attribute: str) -> bool:
    """Whether an attribute is a colour or a material."""
    return attribute in COLOURS or attribute in MATERIALS
