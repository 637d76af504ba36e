"""Which English nouns name a thing of the catalogue, in the singular or the plural."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

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


def known_phrases() -> Collection[str]:
    """Every phrase that names a thing; of regular plurals only the singular."""
    return _phrases(revision()).keys()


def _named(found: tuple[str, str], length: int, *, plural: bool) -> ThingName:
    """The name of the thing that an entry of `_phrases` is about."""
    category, said = found
    forms, _, attribute = said.partition(":")
    return ThingName(category, length, plural or forms.startswith("|"), attribute)


@lru_cache(maxsize=1)
def _phrases(revision: int) -> dict[str, tuple[str, str]]:
    """The category of every phrase that names a thing, and what is said of the phrase.

    That is "" of an ordinary singular, "|" of a plural, "x|" of a singular without a regular plural, and after a colon
    an attribute. What comes first in the catalogue counts.
    """
    found: dict[str, tuple[str, str]] = {}
    for name, kind in reversed(tuple({**CATALOGUE, **GENERAL_WORDS}.items())):
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
