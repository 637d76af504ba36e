"""Which English nouns name a thing, which a person, and which nothing that could stand in a room."""

import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from thinkblox.assets import revision
from thinkblox.assets.plurals import singulars
from thinkblox.knowledge.things import things

_LONGEST = 6
"""Most words that the name of a thing has."""
_SUFFIXES = ("ness", "ity", "ment", "tion", "sion", "ance", "ence", "ism", "ship", "hood", "acy", "dom")
"""What ends an abstract noun, unless it is known to be a thing."""
_SHORTEST_STEM = 3
"""Letters before such an ending: "nation" has an ending and "cushion" none."""


@dataclass(frozen=True, slots=True)
class ThingName:
    """The name of a thing at the end of a noun phrase.

    Attributes:
        category: what it names: a category of the catalogue, or a general word such as "any_table".
        length: how many of the trailing words it takes.
        plural: whether it is said in the plural.
        attribute: what the name says of the thing besides ("two-seat" of a loveseat); mostly empty.
    """

    category: str
    length: int
    plural: bool
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
    known = _phrases(revision())
    phrase = phrase.replace("-", " ")
    if found := known.get(phrase):
        return _named(found, length, plural=False)
    head, space, last = phrase.rpartition(" ")
    for singular in singulars(last):
        found = known.get(f"{head}{space}{singular}")
        if found is not None and "|" not in found[1]:
            return _named(found, length, plural=True)
    return None


def _named(found: tuple[str, str], length: int, *, plural: bool) -> ThingName:
    """The name of the thing that an entry of `_phrases` is about."""
    category, said = found
    forms, _, attribute = said.partition(":")
    return ThingName(category, length, plural or forms.startswith("|"), attribute)


def is_abstract(word: str) -> bool:
    """Whether a noun (in lower case, singular or plural) is never a thing: "atmosphere", "functionality", "morning"."""
    if _is_among("abstract", word):
        return True
    endings = tuple(ending for form in (word, *singulars(word)) for ending in _SUFFIXES if _ends(form, ending))
    return bool(endings) and not _is_among("things", word) and name_of([word]) is None


def is_person(word: str) -> bool:
    """Whether a noun (in lower case, singular or plural) means people: "guest", "children", "cashier"."""
    return _is_among("persons", word)


def _ends(word: str, ending: str) -> bool:
    return word.endswith(ending) and len(word) >= len(ending) + _SHORTEST_STEM


def _is_among(section: str, word: str) -> bool:
    known = _nouns()[section]
    return word in known or any(form in known for form in singulars(word))


@lru_cache(maxsize=1)
def _nouns() -> Mapping[str, frozenset[str]]:
    """The word lists of nouns.toml."""
    text = Path(__file__).with_name("nouns.toml").read_text(encoding="utf-8")
    return {section: frozenset(words.split()) for section, words in tomllib.loads(text).items()}


@lru_cache(maxsize=1)
def _phrases(revision: int) -> dict[str, tuple[str, str]]:
    """The category of every phrase that names a thing, and what is said of the phrase.

    That is "" of an ordinary singular, "|" of a plural, "x|" of a singular without a regular plural, and after a colon
    an attribute. What comes first in the catalogue counts.
    """
    found: dict[str, tuple[str, str]] = {}
    for name, kind in reversed(tuple(things().items())):
        words = kind.words.lower()
        if _is_simple(words):
            found |= dict.fromkeys(words.split(", "), (name, ""))
        else:
            found.update(_read(name, words))
    return found


def _is_simple(words: str) -> bool:
    """Whether a list of words has nothing but phrases with regular plurals in it, each after a comma and a space."""
    return not any(mark in words for mark in "|:-\n") and "  " not in words and words != ""


def _read(category: str, words: str) -> Iterator[tuple[str, tuple[str, str]]]:
    """The phrases of a list of words, the irregular plurals with them."""
    for item in words.split(","):
        forms, _, attribute = item.strip().partition(":")
        singular, mark, plural = forms.partition("|")
        said = f":{attribute}" if attribute else ""
        if plural and plural != singular:
            yield plural.replace("-", " "), (category, "|" + said)
        if singular:
            alone = plural == singular and singular.endswith("s")
            yield singular.replace("-", " "), (category, ("|" if alone else "x|" if mark else "") + said)
