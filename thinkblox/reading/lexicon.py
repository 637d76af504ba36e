"""What the words of one language mean, read from lexicon/<code>.toml; English nouns come with their categories."""

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import takewhile
from pathlib import Path
from typing import Literal

from msgspec import Struct
from msgspec.structs import replace

from thinkblox.assets import CATALOGUE, revision
from thinkblox.knowledge.things import things
from thinkblox.knowledge.vocabulary import thing_called
from thinkblox.reading.tokens import Token, fold, tokenise

Sort = Literal[
    "object",
    "room",
    "place",
    "missing",
    "relation",
    "having",
    "adverb",
    "measure",
    "count",
    "vague",
    "attribute",
    "style",
    "unit",
    "part",
    "word",
]
_SORTS: Mapping[str, Sort] = {
    "objects": "object",
    "rooms": "room",
    "places": "place",
    "relations": "relation",
    "having": "having",
    "adverbs": "adverb",
    "measures": "measure",
    "attributes": "attribute",
    "styles": "style",
    "units": "unit",
    "parts": "part",
    "words": "word",
}
LANGUAGES: Mapping[str, str] = {
    "en": "English",
    "de": "German",
    "fr": "French",
    "es": "Spanish",
    "it": "Italian",
    "pt": "Portuguese",
    "nl": "Dutch",
}
"""The languages that can be read, by code."""
ENGLISH = "en"
"""The language of the words that categories bring with them."""
LONGEST = 6
"""Most words that a phrase of the lexicon has."""
_LONGEST_COMPOUND = 60
"""Letters of a compound that are looked at."""


class Entry(Struct, frozen=True, gc=False):
    """One meaning of a phrase: `value` is a category, room type, relation, ..., according to `sort`."""

    sort: Sort
    value: str
    plural: bool = False
    attribute: str = ""


@dataclass(frozen=True, slots=True)
class Lexeme:
    """A stretch of tokens and what it can mean; no entries when it is unknown."""

    shown: str
    entries: tuple[Entry, ...]
    length: int
    first: Token

    def entry(self, *sorts: Sort, value: str | None = None) -> Entry | None:
        """Its meaning of one of these sorts (and with this value), if it has one."""
        for entry in self.entries:
            if entry.sort in sorts and (value is None or entry.value == value):
                return entry
        return None


@dataclass(frozen=True)
class Lexicon:
    """The phrases of one language, each as a tuple of folded words."""

    code: str
    name: str
    adjectives_after: bool
    endings: tuple[str, ...]
    compounds: bool
    complement: tuple[str, ...]
    contractions: Mapping[str, tuple[str, ...]]
    phrases: dict[tuple[str, ...], tuple[Entry, ...]] = field(default_factory=dict)
    prefixes: set[tuple[str, ...]] = field(default_factory=set)
    _begun: dict[Sort, frozenset[str]] = field(default_factory=dict, repr=False, compare=False)

    def tokens(self, text: str) -> list[Token]:
        """The tokens of a text, with contractions ("zum", "du") spelt out, and whole phrases that say one look named.

        "Floor to ceiling" would otherwise be a place of the room, and where something leads.
        """
        tokens, named, at = self._spelt_out(text), list[Token](), 0
        begun = self.begun("attribute")
        while at < len(tokens):
            look, length = self._look_at(tokens, at) if tokens[at].text in begun else ("", 0)
            whole = tokens[at : at + max(1, length)]
            shown = "-".join(token.shown for token in whole)
            words = look.split("-") if look else []
            named += [replace(whole[0], text=word, shown=shown, glued=False) for word in words] or whole
            at += len(whole)
        return named

    def _spelt_out(self, text: str) -> list[Token]:
        tokens: list[Token] = []
        for token in tokenise(text):
            whole = self.contractions.get(token.text)
            tokens += [Token(word, token.shown, "word") for word in whole] if whole else [token]
        return tokens

    def _look_at(self, tokens: list[Token], at: int) -> tuple[str, int]:
        """The attribute that three or more words say which begin with a thing or a place, and how many they are."""
        for length in range(min(LONGEST, len(tokens) - at), 2, -1):
            key = tuple(token.text for token in tokens[at : at + length])
            looks = [e.value for e in self.phrases.get(key, ()) if e.sort == "attribute"]
            if looks and any(e.sort in ("place", "object") for e in self.phrases.get(key[:1], ())):
                return looks[0], length
        return "", 0

    def begun(self, sort: Sort) -> frozenset[str]:
        """The first words of the phrases that have a meaning of such a sort."""
        if sort not in self._begun:
            self._begun[sort] = frozenset(
                key[0] for key, entries in self.phrases.items() if any(entry.sort == sort for entry in entries)
            )
        return self._begun[sort]

    def longest(self, tokens: list[Token], start: int, most: int = LONGEST) -> Lexeme:
        """The longest phrase that begins at `start`, or a single token without a meaning."""
        found, length = self._single(tokens[start]), 1
        key: tuple[str, ...] = (tokens[start].text,)
        for end in range(start + 1, min(start + most, len(tokens)) + 1):
            if end > start + 1:
                key = (*key, tokens[end - 1].text)
            if entries := self.phrases.get(key):
                found, length = entries, end - start
            if key not in self.prefixes:
                break
        if self.code == ENGLISH:
            found, length = self._plain(tokens[start : start + most], found, length)
        shown = " ".join(token.shown for token in tokens[start : start + length])
        return Lexeme(shown, found, length, tokens[start])

    def _plain(self, tokens: list[Token], found: tuple[Entry, ...], length: int) -> tuple[tuple[Entry, ...], int]:
        """The plain thing that the tokens begin with, where its name is longer than what was found.

        The thousands of names of plain things are looked up rather than added one by one, which would take long.
        """
        shortest = length + 1 if found else length
        words = list(takewhile(lambda token: token.kind == "word", tokens))
        for count in range(len(words), shortest - 1, -1):
            name = thing_called(" ".join(token.text for token in words[:count]), count)
            if name is not None and _is_plain(name.category):
                return (Entry("object", name.name, name.plural, name.attribute),), count
        return found, length

    def _single(self, token: Token) -> tuple[Entry, ...]:
        if token.kind == "number":
            return (Entry("count", token.text),)
        if token.kind != "word":
            return ()
        for stem in self._stems(token.text):
            entries = tuple(e for e in self.phrases.get((stem,), ()) if e.sort in ("attribute", "style", "object"))
            if entries:
                return entries
        return self._compound(token.text) if self.compounds else ()

    def _stems(self, word: str) -> Iterator[str]:
        for ending in self.endings:
            if word.endswith(ending) and len(word) - len(ending) >= 3:
                yield word[: len(word) - len(ending)]

    def _compound(self, word: str) -> tuple[Entry, ...]:
        for cut in range(3, min(len(word), _LONGEST_COMPOUND) - 3):
            entries = tuple(e for e in self.phrases.get((word[cut:],), ()) if e.sort in ("object", "room"))
            if entries:
                return entries
        return ()

    def _key(self, phrase: str) -> tuple[str, ...]:
        if phrase.isascii() and not self.contractions and phrase.replace(" ", "").isalpha():
            return tuple(phrase.lower().split())
        return tuple(token.text for token in self._spelt_out(phrase))

    def add(self, phrase: str, entry: Entry) -> None:
        """Let `phrase` mean `entry`, besides what it means already."""
        key = self._key(phrase)
        if not key or entry in self.phrases.get(key, ()):
            return
        self.phrases[key] = (*self.phrases.get(key, ()), entry)
        self._begun.clear()
        for end in range(1, len(key)):
            self.prefixes.add(key[:end])


def load(code: str) -> Lexicon:
    """The lexicon of a language of LANGUAGES, as the catalogue is now."""
    return _load(code, revision() if code == ENGLISH else 0)


@lru_cache(maxsize=2 * len(LANGUAGES))
def _load(code: str, revision: int) -> Lexicon:
    path = Path(__file__).parent / "lexicon" / f"{code}.toml"
    data = tomllib.loads(path.read_text(encoding="utf-8"))
    if code == ENGLISH:
        data["objects"] = {name: kind.words for name, kind in things().items() if not _is_plain(name)}
    contractions = {fold(short): tuple(fold(whole).split()) for short, whole in data.get("contractions", {}).items()}
    lexicon = Lexicon(
        code=code,
        name=data["language"],
        adjectives_after=data["adjectives_after"],
        endings=tuple(data.get("endings", "").split()),
        compounds=data.get("compounds", False),
        complement=tuple(data.get("complement", "").split()),
        contractions=contractions,
    )
    plurals = data.get("plural", "")
    for section, sort in _SORTS.items():
        for value, phrases in data.get(section, {}).items():
            _add_all(lexicon, phrases, sort, value, plurals)
    for sort in ("count", "vague"):
        for item in _split(data["numbers"].get(sort, "")):
            number, _, phrase = item.partition(" ")
            lexicon.add(phrase, Entry("count" if sort == "count" else "vague", number))
    return lexicon


def _is_plain(name: str) -> bool:
    return name in CATALOGUE and CATALOGUE[name].plain


def _split(phrases: str) -> Iterator[str]:
    return (phrase.strip() for phrase in phrases.split(",") if phrase.strip())


def _add_all(lexicon: Lexicon, phrases: str, sort: Sort, value: str, plurals: str) -> None:
    for item in _split(phrases):
        item, _, attribute = item.partition(":")
        singular, irregular, plural = item.partition("|")
        lexicon.add(singular, Entry(sort, value, False, attribute))
        if plural and plural != singular:
            lexicon.add(plural, Entry(sort, value, True, attribute))
        elif not irregular and sort in ("object", "room", "place"):
            for form in _plural_forms(singular, plurals):
                lexicon.add(form, Entry(sort, value, True, attribute))


def _plural_forms(phrase: str, rule: str) -> Iterator[str]:
    head, _, last = phrase.rpartition(" ")
    before = f"{head} " if head else ""
    match rule:
        case "english":
            yield before + _english_plural(last)
        case "french":
            yield before + last + ("x" if last.endswith(("eau", "eu")) else "" if last.endswith("s") else "s")
            if head:
                first, _, rest = phrase.partition(" ")
                yield f"{first}{'x' if first.endswith('eau') else 's'} {rest}"
        case "spanish":
            first, _, rest = phrase.partition(" ")
            yield f"{_spanish_plural(first)} {rest}".strip()
            yield before + _spanish_plural(last)
        case "italian":
            first, _, rest = phrase.partition(" ")
            yield f"{_italian_plural(first)} {rest}".strip()
            yield before + _italian_plural(last)
        case "dutch":
            yield from (before + form for form in _dutch_plurals(last))


def _english_plural(word: str) -> str:
    if word.endswith("y") and word[-2:-1] not in "aeiou":
        return word[:-1] + "ies"
    if word.endswith(("s", "x", "ch", "sh", "z")):
        return word + "es"
    return word + "s"


def _italian_plural(word: str) -> str:
    if word.endswith("a"):
        return word[:-1] + ("he" if word.endswith(("ca", "ga")) else "e")
    return word[:-1] + "i" if word[-1:] in "oe" else word


def _dutch_plurals(word: str) -> Iterator[str]:
    """Every plural that the spelling allows: "tafels", "stoelen", "bedden", "vazen"."""
    yield word + "s"
    yield word + "en"
    yield word + word[-1] + "en"
    open_syllable = word[:-2] + word[-1] if word[-3:-2] == word[-2:-1] else word
    soft = {"f": "v", "s": "z"}.get(word[-1], word[-1])
    yield open_syllable[:-1] + soft + "en"


def _spanish_plural(word: str) -> str:
    if word.endswith("z"):
        return word[:-1] + "ces"
    return word + ("s" if word[-1:] in "aeiouáéó" else "es")
