"""Adjectives, and words that hyphens join."""

from thinkblox.assets.plurals import singular
from thinkblox.assets.repaint import TOPPED
from thinkblox.assets.sizing import COUNTED_PARTS
from thinkblox.brief import Fate
from thinkblox.reading.adjectives import adjective_kinds
from thinkblox.reading.english.chunks import Adjective, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.quantities import Quantities
from thinkblox.reading.english.words import Known, Unit, Units


class Modifiers(Quantities):
    """Reads modifiers of nouns."""

    def adjective(self, start: int) -> Adjective | None:
        """Adjectives without a noun at `start`, or None."""
        noun = Noun("abstract", "", start, start)
        at = start
        while at < len(self.tokens) and (length := self._adjective(noun, at)):
            at += length
        if at == start:
            return None
        return Adjective(start, at, self._text(start, at), noun.attributes, noun.styles, noun.unshown, noun.states)

    def _adjective(self, noun: Noun, at: int) -> int:
        """Take an adjective; returns the tokens it takes."""
        known = self._known(at, "attribute", "style")
        state = grammar().at(self.tokens, at, "states")
        evaluative = grammar().at(self.tokens, at, "evaluative")
        longest = max((f.length for f in (state, evaluative) if f), default=0)
        thing = self.thing_at(at)
        if thing is not None and thing.length >= max(longest, known.length if known else 0):
            as_long = known is not None and known.length == thing.length
            if not as_long or not self._starts_noun(at + thing.length):
                return 0
        if topped := self._topped(noun, at, known):
            return topped
        if known is not None and known.length >= longest:
            self._describe(noun, at, known, is_state=state is not None and state.length == known.length)
            return known.length
        if state is not None and state.length >= (evaluative.length if evaluative else 0):
            noun.states.append(self._text(at, at + state.length).lower())
            return state.length
        if evaluative is None:
            return 0
        self._idle(noun, at, at + evaluative.length)
        return evaluative.length

    def _topped(self, noun: Noun, at: int, known: Known | None) -> int:
        """Read "marble-topped", "glass top" before a noun."""
        if known is None:
            return 0
        end = at + known.length
        word = f"{known.entry.value}-topped"
        if self._text(end, end + 1).lower() not in ("topped", "top") or word not in TOPPED:
            return 0
        if not self._starts_noun(end + 1):
            return 0
        noun.attributes.append(word)
        return known.length + 1

    def _describe(self, noun: Noun, at: int, known: Known, *, is_state: bool) -> None:
        """Take what the lexicon knows as an adjective."""
        if known.entry.sort == "style":
            self._idle(noun, at, at + known.length, "style")
        for entry in (known.entry, *known.others):
            if entry.sort == "attribute" and is_state:
                noun.states.append(self._text(at, at + known.length).lower())
                break
            if entry.sort == "attribute":
                noun.attributes.append(entry.value)
            elif entry.sort == "style":
                noun.styles.append(entry.value)
                word = self._text(at, at + known.length).lower()
                noun.unshown += [word] if "pattern" in adjective_kinds(word) else []
                noun.states += [word] if is_state else []

    def _forget(self, noun: Noun) -> None:
        noun.attributes.clear()
        noun.styles.clear()
        noun.states.clear()
        noun.fates.clear()

    def _idle(self, noun: Noun, start: int, end: int, fate: Fate = "filler") -> None:
        """Note words of the phrase that ask for nothing."""
        noun.fates.update(dict.fromkeys(range(start, end), fate))

    def _continues(self, noun: Noun, at: int) -> bool:
        return bool(noun.det or noun.count is not None) and self._starts_noun(at)

    def _side(self, noun: Noun, at: int) -> int:
        """Read the "left" of "the left nightstand", the "left two" of "the left two beds"."""
        text = self.tokens[at].text
        if noun.det not in ("the", "my") or text not in ("left", "right", "middle") or noun.side:
            told = bool(noun.side) and noun.side in (text, {"rear": "back"}.get(text))
            return 1 + self._how_many_there(noun, at + 1) if told else 0
        following = self._known(at + 1, "object", "missing")
        if following is None and not self._is_one(at + 1):
            return 0
        noun.side = text
        return 1

    def _how_many_there(self, noun: Noun, at: int) -> int:
        """Take the number of "the left two beds"; returns its tokens, 0 where none comes."""
        number = self._number(at) if noun.count is None and not self._is_one(at) else None
        if number is None or not self._starts_noun(at + number[1]):
            return 0
        noun.count, noun.plural, noun.of_known = number[0], number[0] > 1, True
        return number[1]

    def _glued(self, noun: Noun, at: int, units: Units) -> int:
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
        state = grammar().at(self.tokens, at, "states")
        if state is not None and state.length > end - at:
            return 0
        name = "-".join(token.shown for token in self.tokens[at : end + 1]).lower()
        if self._seats(noun, at, end) or self._counts_parts(noun, at, end):
            return end + 1 - at
        topped = self._topped(noun, at, self._known(at, "attribute")) > 0
        if topped or (last is not None and last.entry.sort == "attribute"):
            noun.attributes += [last.entry.value] if last is not None and not topped else []
            units.adjectives += 1
        elif self._starts_noun(end + 1) and self._has_noun(end + 1):
            evaluative = grammar().at(self.tokens, at, "evaluative")
            if evaluative is None or evaluative.length <= end - at:
                noun.unshown.append(name)
            else:
                self._idle(noun, at, end + 1)
            units.adjectives += 1
        elif self._known(end, "object") is not None:
            return end - at
        else:
            units.nouns.append(Unit(name))
        return end + 1 - at

    def _counts_parts(self, noun: Noun, at: int, end: int) -> bool:
        """Read "three-drawer", "two-door"."""
        number, word = self._number(at), singular(self.tokens[end].text)
        if number is None or word not in COUNTED_PARTS or not self._starts_noun(end + 1):
            return False
        noun.attributes.append(f"{number[0]}-{word}s")
        return True

    def _seats(self, noun: Noun, at: int, end: int) -> bool:
        number = self._number(at)
        word = self.tokens[end].text
        if number is None or word not in ("person", "seat", "seater", "people", "place"):
            return False
        noun.seats = number[0]
        noun.attributes.append(f"for-{number[0]}")
        return True
