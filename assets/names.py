"""Which English nouns name a thing of the catalogue, in the singular or the plural."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

from msgspec import Struct

from thinkblox.assets.catalogue import CATALOGUE, GENERAL_WORDS, revision
from thinkblox.assets.plurals import singulars

_LONGEST = 6
"""Most words that the name of a thing has."""


@dataclass(frozen=True, slots=True)
class ThingName:
    """The name of a thing at the end of a noun phrase.

    Attributes:
        category: what it names: a category of the catalogue, or a general word such as "any_table".
        length: how many of the trailing words it takes.
        plural: whether it is said in the plural.
        attribute: what the name says of the thing besides ("two-seat" of a loveseat); mostly empty.
        name: the category to ask for, which is `category` unless that is a plain one by another word: a samovar has
            the size of the "tea_urn" and keeps its own name, "samovar".
    """

    category: str
    length: int
    plural: bool
    attribute: str
    name: str


class _Meaning(Struct, frozen=True, gc=False):
    """What a phrase means; `singular` is empty where it is the phrase itself."""

    category: str
    singular: str = ""
    plural: bool = False
    regular: bool = True
    attribute: str = ""


def name_of(words: Sequence[str]) -> ThingName | None:
    """The longest name of a thing that the last of these words make up, singular or plural; None where there is none.

    Words are in lower case; a hyphen in them is as good as a space.
    """
    for length in range(min(len(words), _LONGEST), 0, -1):
        if found := thing_called(" ".join(words[len(words) - length :]), length):
            return found
    return None


def thing_called(phrase: str, length: int = 1) -> ThingName | None:
    """What a whole phrase in lower case names, singular or plural; `length` is its number of words."""
    return _called(phrase, length, revision())


@lru_cache(maxsize=4096)
def _called(phrase: str, length: int, revision: int) -> ThingName | None:
    known = _phrases(revision)
    phrase = phrase.replace("-", " ")
    first, several, _ = phrase.partition(" ")
    if several and first not in _beginnings(revision):
        return None
    if found := known.get(phrase):
        return _named(found, found.singular or phrase, length, plural=found.plural)
    head, space, last = phrase.rpartition(" ")
    for singular in singulars(last):
        found = known.get(f"{head}{space}{singular}")
        if found is not None and found.regular and not found.plural:
            return _named(found, f"{head}{space}{singular}", length, plural=True)
    return None


def identifier_of(noun: str) -> str:
    """The name of a category for a noun phrase of letters, digits and spaces; it begins with a letter, as ids do."""
    name = noun.replace(" ", "_")
    return name if name[:1].isalpha() else f"thing_{name}"


def begins_name(word: str) -> bool:
    """Whether any name of several words begins with a word in lower case."""
    return word in _beginnings(revision())


def known_phrases() -> Collection[str]:
    """Every phrase that names a thing; of regular plurals only the singular."""
    return _phrases(revision()).keys()


def _named(found: _Meaning, singular: str, length: int, *, plural: bool) -> ThingName:
    kind = CATALOGUE.get(found.category)
    name = identifier_of(singular) if kind is not None and kind.plain else found.category
    return ThingName(found.category, length, plural, found.attribute, name)


@lru_cache(maxsize=1)
def _phrases(revision: int) -> dict[str, _Meaning]:
    """What every phrase means that names a thing; what has a shape counts before what is plain."""
    found: dict[str, _Meaning] = {}
    shaped = {**GENERAL_WORDS, **{name: kind for name, kind in CATALOGUE.items() if not kind.plain}}
    plain = {name: kind for name, kind in CATALOGUE.items() if kind.plain}
    for name, kind in (*plain.items(), *shaped.items()):
        if _is_simple(kind.words):
            found |= dict.fromkeys(kind.words.split(", "), _Meaning(name))
        else:
            found.update(_read(name, kind.words))
    return found


@lru_cache(maxsize=1)
def _beginnings(revision: int) -> frozenset[str]:
    """The first words of the names that have several."""
    return frozenset(phrase.partition(" ")[0] for phrase in _phrases(revision) if " " in phrase)


def _is_simple(words: str) -> bool:
    """Whether a list of words has nothing but phrases with regular plurals in it, each after a comma and a space."""
    return words.islower() and not any(mark in words for mark in ("|", ":", "-", "  ", "\n"))


def _read(category: str, words: str) -> Iterator[tuple[str, _Meaning]]:
    """The phrases of a list of words, the irregular plurals with them."""
    for item in words.split(","):
        forms, _, attribute = item.strip().partition(":")
        singular, mark, plural = forms.lower().replace("-", " ").partition("|")
        if plural and plural != singular:
            yield plural, _Meaning(category, singular, plural=True, regular=False, attribute=attribute)
        if singular:
            alone = plural == singular and singular.endswith("s")
            yield singular, _Meaning(category, plural=alone, regular=not mark, attribute=attribute)
