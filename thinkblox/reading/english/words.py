"""The words of one text: what the lexicon and the grammar know of them."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import takewhile

from thinkblox.assets.names import ThingName, begins_name
from thinkblox.assets.plurals import singular
from thinkblox.knowledge.vocabulary import thing_called
from thinkblox.reading.adjectives import adjective_kinds
from thinkblox.reading.english.grammar import Function, grammar
from thinkblox.reading.lexicon import LONGEST, Entry, Lexicon, Sort
from thinkblox.reading.sizes import Size, read_size
from thinkblox.reading.tokens import Token

STOPS = ("mutual", "negations", "inverses", "prepositions", "verbs", "joins", "determiners", "quantifiers")
"""Sections of the grammar whose words end a noun phrase."""


@dataclass(frozen=True)
class Known:
    """A phrase of the lexicon."""

    entry: Entry
    length: int
    others: tuple[Entry, ...] = ()


@dataclass
class Unit:
    """A word or phrase of a noun phrase, besides its determiner and quantity; `owner`: with a genitive ending."""

    text: str
    known: Known | None = None
    owner: bool = False


@dataclass
class Units:
    """What was read between the quantity and the end of a noun phrase."""

    nouns: list[Unit] = field(default_factory=list)
    adjectives: int = 0


class Words:
    """Looks words up."""

    def __init__(self, lexicon: Lexicon, tokens: Sequence[Token]) -> None:
        self.lexicon = lexicon
        self.tokens = list(tokens)
        self.group = False
        self._seen: dict[tuple[int, tuple[str, ...]], Known | None] = {}
        self._begun: dict[int, list[tuple[int, tuple[Entry, ...]]]] = {}
        self._names: dict[str, ThingName | None] = {}
        self._sizes: dict[int, tuple[Size, int] | None] = {}
        self._unread: dict[int, int] = {}

    def size_at(self, at: int) -> tuple[Size, int] | None:
        """The size that begins at `at`, and the token after it."""
        if at not in self._sizes:
            self._sizes[at] = read_size(self.lexicon, self.tokens, at)
        return self._sizes[at]

    def thing_at(self, at: int) -> Known | None:
        """The longest name of a thing that begins at `at`."""
        return self._known(at, "object", "missing")

    def _known(self, at: int, *sorts: Sort) -> Known | None:
        """The longest phrase of the lexicon at `at` that has a meaning of one of these sorts, the first of them."""
        if at >= len(self.tokens) or self.tokens[at].kind != "word":
            return None
        if (at, sorts) not in self._seen:
            self._seen[at, sorts] = self._look_up(at, sorts)
        return self._seen[at, sorts]

    def _look_up(self, at: int, sorts: tuple[Sort, ...]) -> Known | None:
        if at not in self._begun:
            self._begun[at] = self._phrases_from(at)
        found: Known | None = None
        for length, meanings in self._begun[at]:
            entries = [e for e in meanings if e.sort in sorts] if meanings else []
            if not entries and length == 1 and self.tokens[at].owner:
                bare = self.tokens[at].text.removesuffix("s")
                entries = [e for e in self.lexicon.phrases.get((bare,), ()) if e.sort in sorts]
            if entries:
                entry = min(entries, key=lambda e: sorts.index(e.sort)) if len(entries) > 1 else entries[0]
                found = Known(entry, length, tuple(e for e in meanings if e is not entry))
        return self._plain(at, found) if "object" in sorts else found

    def _phrases_from(self, at: int) -> list[tuple[int, tuple[Entry, ...]]]:
        """How many words the phrases of the lexicon have that begin at `at`, one among them, and what they mean."""
        found: list[tuple[int, tuple[Entry, ...]]] = []
        key: tuple[str, ...] = ()
        for index in range(at, min(at + LONGEST, len(self.tokens))):
            text = self.tokens[index].text
            if self.tokens[index].owner and index > at:
                text = text.removesuffix("s") if (*key, text) not in self.lexicon.prefixes else text
            key = (*key, text)
            meanings = self.lexicon.phrases.get(key, ())
            if meanings or index == at:
                found.append((index + 1 - at, meanings))
            if key not in self.lexicon.prefixes:
                break
        return found

    def _named(self, phrase: str, length: int) -> ThingName | None:
        if phrase not in self._names:
            self._names[phrase] = thing_called(phrase, length)
        return self._names[phrase]

    def _plain(self, at: int, found: Known | None) -> Known | None:
        """The name of a thing that the catalogue only has a stand-in for, where it is longer than what was found."""
        most = LONGEST if begins_name(self.tokens[at].text) else 1
        words = [token.text for token in takewhile(_is_word, self.tokens[at : at + most])]
        least = found.length if found is not None else 0
        for length in range(len(words), least, -1):
            named = self._named(" ".join(words[:length]), length)
            if named is not None and not self._is_described(words[:length]):
                others = self.lexicon.phrases.get(tuple(words[:length]), ())
                entry = Entry("object", named.name or named.category, named.plural, named.attribute)
                return Known(entry, length, tuple(e for e in others if e.sort in ("attribute", "room")))
        return found

    def _is_decade(self, at: int) -> bool:
        """Whether a number says when: "the 1920s"."""
        after = self.tokens[at + 1] if at + 1 < len(self.tokens) else None
        token = self.tokens[at]
        return after is not None and after.text == "s" and after.start == token.start + len(token.shown)

    def _is_described(self, words: list[str]) -> bool:
        """Whether a name is an adjective and a name: "wooden bucket", "folded blanket"."""
        rest = " ".join(words[1:])
        if len(words) < 2 or thing_called(rest, len(words) - 1) is None:
            return False
        if " ".join([*words[:-1], singular(words[-1])]) in grammar().lists["compounds"]:
            return False
        looks = any(e.sort in ("attribute", "style") for e in self.lexicon.phrases.get((words[0],), ()))
        if words[0] == "wood":
            whole, head = thing_called(" ".join(words), len(words)), thing_called(rest, len(words) - 1)
            looks &= whole is None or head is None or whole.category == head.category
        return looks or bool({"state", "size"} & adjective_kinds(words[0]))

    def _number(self, at: int) -> tuple[int, int] | None:
        """A whole number and how many tokens it takes."""
        if not 0 <= at < len(self.tokens):
            return None
        token = self.tokens[at]
        if token.kind == "number" and (self._is_inner_number(at) or self._is_decade(at)):
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
        unit = grammar().at(self.tokens, at + length, "count") if value >= 20 and value % 10 == 0 else None
        if unit is not None and 0 < int(unit.value) < 10 and unit.length == 1:
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

    def _starts_noun(self, at: int) -> bool:
        """Whether nouns or their modifiers come at `at`."""
        if at >= len(self.tokens) or self.tokens[at].kind != "word":
            return False
        if self._known(at, "object", "room", "missing", "attribute", "style") is not None:
            return True
        if grammar().at(self.tokens, at, *STOPS, "fillers", "participles", "pronouns") is not None:
            return self._known(at, "place") is not None and self.tokens[at].text not in ("in", "on", "at")
        return True

    def _has_noun(self, at: int) -> bool:
        """Whether the phrase goes on to a noun within a few words."""
        for index in range(at, min(at + 4, len(self.tokens))):
            if self.tokens[index].kind != "word" or grammar().at(self.tokens, index, *STOPS):
                return False
            if self._known(index, "object", "missing", "room"):
                return True
            if not self._known(index, "attribute", "style"):
                return True
        return False

    def _longest_part(self, at: int) -> Function | None:
        if at >= len(self.tokens):
            return None
        return grammar().at(self.tokens, at, "parts")

    def _is_one(self, at: int) -> bool:
        return at < len(self.tokens) and self.tokens[at].text in ("one", "ones")

    def _text(self, start: int, end: int) -> str:
        return " ".join(token.shown for token in self.tokens[start:end])


def _is_word(token: Token) -> bool:
    return token.kind == "word"
