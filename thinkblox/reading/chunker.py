"""Tokens to items, from left to right in one pass."""

from collections.abc import Iterator

from thinkblox.assets.palette import COLOURS
from thinkblox.reading.lexicon import LONGEST, Entry, Lexeme, Lexicon
from thinkblox.reading.phrases import Connective, Item, Phrase, PhraseKind, Unknown
from thinkblox.reading.sizes import Size, read_size
from thinkblox.reading.tokens import Token

_STOPS = {".": "stop", "!": "stop", "?": "stop", ";": "stop", ":": "colon", ",": "comma", "\n": "stop"}
_LINKS = ("mutual", "no", "only", "nothing", "but", "and", "or", "of", "which")
_LONGEST_UNKNOWN = 4


class Chunker:
    """Cuts tokens into items, from left to right in one pass."""

    def __init__(self, lexicon: Lexicon, tokens: list[Token]) -> None:
        self.lexicon = lexicon
        self.tokens = tokens
        self.at = 0
        self.known = 0
        self._seen: dict[tuple[int, int], Lexeme] = {}

    def items(self) -> Iterator[Item]:
        """The items of the text; `known` counts the tokens that meant something."""
        while self.at < len(self.tokens):
            yield from self._next()

    def _next(self) -> Iterator[Item]:
        if size := self.size():
            yield size
            return
        start = self.at
        phrase = _NounPhrase(self)
        if phrase.read():
            yield from phrase.unknown
            yield phrase.result()
            return
        self.at = start
        yield from self._link(self.peek())

    def _shortened(self, lexeme: Lexeme, ahead: int) -> Lexeme:
        """Leave "side table" whole in "on each side table", and "left wall" in "on the left wall"."""
        last = self.peek(ahead + lexeme.length - 1)
        whole = last.length > 1 and last.entry("object", "place")
        return self.peek(ahead, lexeme.length - 1) if whole else lexeme

    def size(self) -> Size | None:
        """The size at the current token, if there is one; goes past it."""
        found = read_size(self.lexicon, self.tokens, self.at)
        if found is None:
            return None
        self.known += found[1] - self.at
        self.at = found[1]
        return found[0]

    def _link(self, lexeme: Lexeme) -> Iterator[Item]:
        self.take(lexeme)
        if lexeme.first.kind == "mark":
            if lexeme.first.text in _STOPS:
                yield Connective(_STOPS[lexeme.first.text])
            elif lexeme.first.text in "()[]–—/":
                yield Connective("comma", lexeme.first.text)
        elif entry := lexeme.entry("adverb", "having", "relation"):
            yield Connective(entry.sort, entry.value)
        elif entry := next((e for e in lexeme.entries if e.sort == "word" and e.value in _LINKS), None):
            yield Connective(entry.value)
        elif not lexeme.entries and lexeme.first.kind == "word" and not is_owner(lexeme):
            yield Unknown(lexeme.shown)

    def peek(self, ahead: int = 0, most: int = LONGEST) -> Lexeme:
        """The lexeme at the current token, `ahead` tokens on, of at most `most` tokens; an empty one at the end."""
        if self.at + ahead >= len(self.tokens):
            return _END
        if (self.at + ahead, most) not in self._seen:
            self._seen[self.at + ahead, most] = self._longest(ahead, most)
        return self._seen[self.at + ahead, most]

    def _longest(self, ahead: int, most: int) -> Lexeme:
        lexeme = self.lexicon.longest(self.tokens, self.at + ahead, most)
        return self._shortened(lexeme, ahead) if lexeme.length > 1 and lexeme.entry("adverb", "relation") else lexeme

    def take(self, lexeme: Lexeme) -> None:
        """Go past a lexeme."""
        self.at += lexeme.length
        if lexeme.entries and lexeme.first.kind == "word":
            self.known += lexeme.length


_END = Lexeme("", (), 0, Token("", "", "end"))
_HEADS: dict[str, PhraseKind] = {
    "it": "pronoun",
    "them": "pronoun",
    "people": "people",
    "ignored": "ignored",
    "gap": "gap",
    "other": "other",
    "all": "all",
}
_POINTING = ("them", "other", "all")
"""Heads that stand alone where the same word can be a determiner: "both", but not "both lamps"."""


class _NounPhrase:
    """Reads one noun phrase at the chunker's position: determiner, count, measures, modifiers, head."""

    def __init__(self, chunker: Chunker) -> None:
        self.chunker = chunker
        self.phrase = Phrase("ignored", "")
        self.unknown: list[Unknown] = []
        self.words: list[str] = []
        self.determined = False
        self.multiplier = 1

    def read(self) -> bool:
        """Whether there is a noun phrase; the chunker then stands behind it."""
        lexeme = self.chunker.peek()
        while self._before_head(lexeme):
            lexeme = self.chunker.peek()
        if self._head(lexeme):
            self._after_head()
            return True
        return bool(self.words) and self._without_head()

    def result(self) -> Phrase:
        """The phrase that was read."""
        self.phrase.text = " ".join(self.words)
        self.phrase.bare = not self.determined
        if self.multiplier > 1:
            self.phrase.count = self.multiplier * (self.phrase.count or 1)
        return self.phrase

    def _before_head(self, lexeme: Lexeme) -> bool:
        return (
            self._determiner(lexeme)
            or self._size()
            or self._amount(lexeme)
            or self._modifier(lexeme)
            or self._stranger(lexeme)
            or self._filler(lexeme)
        )

    def _take(self, lexeme: Lexeme) -> bool:
        self.words.append(lexeme.shown)
        self.chunker.take(lexeme)
        return True

    def _determiner(self, lexeme: Lexeme) -> bool:
        entry = _determiner_of(lexeme)
        if (
            entry is None
            or self._stands_alone(lexeme)
            or (self.determined and entry.value not in ("indefinite", "definite"))
            or self.unknown
        ):
            return False
        if self.phrase.attributes and self.determined:
            return False
        self.determined = True
        self.phrase.definite |= entry.value in ("definite", "other")
        self.phrase.each |= entry.value == "each"
        self.phrase.whose |= entry.value == "possessive"
        return self._take(lexeme)

    def _stands_alone(self, lexeme: Lexeme) -> bool:
        """Whether "both", "all" or "the other" comes without a noun."""
        pointing = any(e.sort == "word" and e.value in _POINTING for e in lexeme.entries)
        following = self.chunker.peek(lexeme.length)
        counted = following.entry("count") is not None and _continues(self.chunker.peek(lexeme.length + 1))
        return pointing and not counted and not _continues(following)

    def _amount(self, lexeme: Lexeme) -> bool:
        if entry := lexeme.entry("count"):
            return self._count(lexeme, entry)
        if entry := lexeme.entry("vague"):
            self.phrase.count, self.phrase.vague, self.phrase.plural = int(entry.value), True, True
        elif (entry := lexeme.entry("measure")) and not lexeme.entry("object"):
            self._measure(entry)
        else:
            return False
        self.determined = True
        return self._take(lexeme)

    def _count(self, lexeme: Lexeme, entry: Entry) -> bool:
        value = lexeme.first.value if lexeme.first.kind == "number" else float(entry.value)
        previous = self.phrase.count
        if value != int(value) or value < 0:
            return False
        tens = previous is not None and previous >= 20 and previous % 10 == 0 and 0 < value < 10
        self.phrase.count = int(value) + (previous or 0) if tens else int(value)
        self.phrase.vague = False
        self.determined = True
        self._take(lexeme)
        self._places()
        self._times()
        return True

    def _times(self) -> None:
        """Go past the "x" of "2x bookcase"."""
        lexeme = self.chunker.peek()
        if lexeme.entry("unit", value="by") and _continues(self.chunker.peek(lexeme.length)):
            self._take(lexeme)

    def _places(self) -> None:
        """Read "8-person" before a noun as what the thing is for, not as how many there are."""
        lexeme = self.chunker.peek()
        named = lexeme.entry("word", value="people") or lexeme.first.text in ("seat", "seater", "place")
        if named and lexeme.length == 1 and _continues(self.chunker.peek(1)) and self.phrase.count:
            self.phrase.attributes.append(f"for-{self.phrase.count}")
            self.phrase.seats, self.phrase.count = self.phrase.count, None
            self._take(lexeme)

    def _measure(self, entry: Entry) -> None:
        count, self.phrase.count = self.phrase.count, None
        match entry.value:
            case "row":
                self.phrase.rows = count or (-1 if entry.plural else 1)
            case "pair":
                self.multiplier *= 2 * (count or 1)
            case "dozen":
                self.multiplier *= 12 * (count or 1)
            case _:
                self.phrase.count = count if count and count > 1 else None
        self.phrase.plural = True

    def _size(self) -> bool:
        """A size before the noun it belongs to: "a 4 m by 5 m bedroom", "a 2 m sofa"."""
        if not self.determined or self.phrase.count is not None or self.phrase.size:
            return False
        self.phrase.size = self.chunker.size()
        return self.phrase.size is not None

    def _modifier(self, lexeme: Lexeme) -> bool:
        following = self.chunker.peek(lexeme.length)
        noun = lexeme.entry("object", "room", "place")
        adjectives = [e for e in lexeme.entries if e.sort in ("attribute", "style")]
        if adjectives and (not noun or _continues(following)):
            for entry in adjectives:
                (self.phrase.attributes if entry.sort == "attribute" else self.phrase.styles).append(entry.value)
        elif not self._compounds(lexeme, noun, following):
            return False
        return self._take(lexeme)

    def _compounds(self, lexeme: Lexeme, noun: Entry | None, following: Lexeme) -> bool:
        """Whether a noun only describes the one after it: "a bedroom chair", "a glass table", "the top shelf"."""
        if self.chunker.lexicon.adjectives_after:
            return False
        if lexeme.entry("part") or lexeme.entry("place", value="centre"):
            return self.determined and following.entry("object") is not None
        if noun is None or noun.sort == "place":
            return False
        return following.entry("object", "room") is not None and (
            noun.sort == "room" or bool(following.entry("object"))
        )

    def _stranger(self, lexeme: Lexeme) -> bool:
        if not self.determined or lexeme.entries or lexeme.first.kind != "word":
            return False
        if len(self.unknown) >= _LONGEST_UNKNOWN:
            return False
        if not is_owner(lexeme):
            self.unknown.append(Unknown(lexeme.shown))
        return self._take(lexeme)

    def _filler(self, lexeme: Lexeme) -> bool:
        if not self.determined or lexeme.entry("word", value="filler") is None:
            return False
        following = self.chunker.peek(lexeme.length)
        return _continues(following) and lexeme.entry("relation", "having") is None and self._take(lexeme)

    def _head(self, lexeme: Lexeme) -> bool:
        lexeme = self._without_verb(lexeme)
        bare = not self.determined and self.phrase.count is None
        verb = not self.determined and lexeme.entry("word", value="filler") is not None
        shade = lexeme.entry("attribute")
        said_of = bare and shade is not None and shade.value in COLOURS  # "the sofa is orange" names no fruit
        noun = None if verb or said_of else lexeme.entry("object") or lexeme.entry("room", "place")
        entry = noun or self._part(lexeme) or self._word(lexeme)
        if entry is None:
            return False
        self.phrase.kind = _HEADS[entry.value] if entry.sort == "word" else entry.sort  # type: ignore[assignment]
        self.phrase.value = entry.value
        self.phrase.plural |= entry.plural
        if entry.attribute:
            self.phrase.attributes.append(entry.attribute)
        if entry.sort == "object" and (room := lexeme.entry("room")):
            self.phrase.room = room.value
        return self._take(lexeme)

    def _without_verb(self, lexeme: Lexeme) -> Lexeme:
        """Part "a TV | stands opposite ..." from "two TV stands"."""
        last = lexeme.shown.rpartition(" ")[2].lower()
        if lexeme.length < 2 or last not in _VERBS or self.phrase.count not in (None, 1):
            return lexeme
        following = self.chunker.peek(lexeme.length)
        return self.chunker.peek(0, lexeme.length - 1) if following.entry("relation", "adverb") else lexeme

    def _part(self, lexeme: Lexeme) -> Entry | None:
        return lexeme.entry("part") if self.determined else None

    def _word(self, lexeme: Lexeme) -> Entry | None:
        entry = next((e for e in lexeme.entries if e.sort == "word" and e.value in _HEADS), None)
        if entry is None or (entry.value in ("it", *_POINTING) and self.determined):
            return None
        if entry.value in _POINTING and _determiner_of(lexeme) and not self._stands_alone(lexeme):
            return None
        return None if entry.value == "ignored" and not self.determined else entry

    def _without_head(self) -> bool:
        phrase = self.phrase
        if self.unknown:
            phrase.kind, self.unknown = "missing", []
        elif phrase.rows:
            phrase.kind = "rows"
        elif phrase.each:
            phrase.kind, phrase.value = "pronoun", "each"
        elif phrase.attributes or phrase.styles:
            phrase.kind = "adjective"
        elif phrase.count is not None and phrase.definite:
            phrase.kind, phrase.value = "pronoun", "them"
        elif phrase.count is not None:
            phrase.kind = "number"
        return True

    def _after_head(self) -> None:
        self._times_after()
        if not self.chunker.lexicon.adjectives_after:
            return
        while (lexeme := self.chunker.peek()).entry("attribute", "style") and not lexeme.entry("object"):
            for entry in lexeme.entries:
                if entry.sort in ("attribute", "style"):
                    (self.phrase.attributes if entry.sort == "attribute" else self.phrase.styles).append(entry.value)
            self._take(lexeme)
        self._complement()

    def _times_after(self) -> None:
        """Read the count of "armchair x2"."""
        sign, number = self.chunker.peek(), self.chunker.peek(1)
        value = number.first.value
        if sign.entry("unit", value="by") and number.first.kind == "number" and value == int(value) > 0:
            self._take(sign)
            self._take(number)
            self.phrase.count = int(value)

    def _complement(self) -> None:
        """Skip what follows "de" without an article, as it only describes: "table de bois", "silla de madera"."""
        lexeme = self.chunker.peek()
        if lexeme.first.text not in self.chunker.lexicon.complement or lexeme.length != 1:
            return
        following = self.chunker.peek(1)
        if following.entry("object", "room", "attribute") or (not following.entries and following.first.kind == "word"):
            self._take(lexeme)
            self._take(following)


def is_owner(lexeme: Lexeme) -> bool:
    """Whether an unknown word only says whose something is ("grandmother's")."""
    return lexeme.shown.lower().endswith(("'s", "’s", "s'", "s’"))


_VERBS = ("stands",)
_DETERMINERS = ("indefinite", "definite", "possessive", "each", "other")


def _determiner_of(lexeme: Lexeme) -> Entry | None:
    return next((e for e in lexeme.entries if e.sort == "word" and e.value in _DETERMINERS), None)


def _continues(lexeme: Lexeme) -> bool:
    return lexeme.entry("attribute", "style", "object", "room", "place") is not None
