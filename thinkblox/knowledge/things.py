"""Everything that a noun can name: the categories of the catalogue, and general words such as "any_table"."""

from collections.abc import Mapping
from functools import lru_cache
from types import MappingProxyType

from thinkblox.assets import CATALOGUE, GENERAL_WORDS, Facts, revision


def things() -> Mapping[str, Facts]:
    """What is known of each category and general word, by name, as the catalogue is now."""
    return _things(revision())


@lru_cache(maxsize=1)
def _things(revision: int) -> Mapping[str, Facts]:
    return MappingProxyType({**CATALOGUE, **GENERAL_WORDS})


def counts_as(category: str, name: str) -> bool:
    """Whether a <category> is one of what is called <name>: an office chair is a chair, "any_table" is every table."""
    general = name in GENERAL_WORDS and are_alike(category, name)
    return category == name or general or category.endswith(f"_{name}")


def are_alike(one: str, other: str) -> bool:
    """Whether "the <other>" can point at a <one>: a dining table is a table."""
    known = things()
    if one == other or one not in known or other not in known:
        return one == other
    return not set(known[one].like).isdisjoint(known[other].like)


def is_surface(called: str) -> bool:
    """Whether a thing is called by its top alone, which may be that of many in one line: "the worktop", "a counter"."""
    return called.lower().rpartition(" ")[2].rstrip("s").endswith(_SURFACES)


_SURFACES = ("top", "counter", "surface")
