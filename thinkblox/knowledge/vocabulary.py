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


@dataclass(frozen=True, slots=True)
class _Phrase:
    category: str
    attribute: str
    plural: bool
    regular: bool


def name_of(words: Sequence[str]) -> ThingName | None:
    """The longest name of a thing that the last of these words make up, singular or plural; None where there is none.

    Words are in lower case; a hyphen in them is as good as a space.
    """
    known = _phrases(revision())
    for length in range(min(len(words), _LONGEST), 0, -1):
        phrase = " ".join(words[len(words) - length :]).replace("-", " ")
        if found := known.get(phrase):
            return ThingName(found.category, length, found.plural, found.attribute)
        head, space, last = phrase.rpartition(" ")
        for singular in singulars(last):
            found = known.get(f"{head}{space}{singular}")
            if found is not None and found.regular:
                return ThingName(found.category, length, True, found.attribute)
    return None


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
def _phrases(revision: int) -> dict[str, _Phrase]:
    """Every phrase that names a thing; what a category with a shape of its own is called comes first."""
    found: dict[str, _Phrase] = {}
    for name, kind in things().items():
        for phrase, meaning in _read(name, kind.words):
            found.setdefault(phrase, meaning)
    return found


def _read(category: str, words: str) -> Iterator[tuple[str, _Phrase]]:
    """The phrases of a line of words, the irregular plurals with them."""
    for item in words.lower().split(","):
        forms, _, attribute = item.strip().partition(":")
        singular, mark, plural = forms.partition("|")
        if singular:
            own = singular.replace("-", " ")
            same = plural == singular
            yield own, _Phrase(category, attribute, same and own.endswith("s"), not mark)
        if plural and plural != singular:
            yield plural.replace("-", " "), _Phrase(category, attribute, True, False)
