"""Which English nouns name a thing, which a person, and which nothing that could stand in a room."""

import tomllib
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path

from thinkblox.assets.names import ThingName, name_of, thing_called
from thinkblox.assets.plurals import singulars

__all__ = ["ThingName", "is_abstract", "is_person", "name_of", "thing_called"]

_SUFFIXES = ("ness", "ity", "ment", "tion", "sion", "ance", "ence", "ism", "ship", "hood", "acy", "dom")
"""What ends an abstract noun, unless it is known to be a thing."""
_SHORTEST_STEM = 3
"""Letters before such an ending: "nation" has an ending and "cushion" none."""


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
