"""What things usually measure and weigh, by the words that name them: the catalogue's ordinary sizes and masses."""

import re
from collections.abc import Iterator, Mapping
from functools import lru_cache

from thinkblox.assets.catalogue import CATALOGUE, GENERAL_WORDS, phrases, revision
from thinkblox.assets.category import Category
from thinkblox.value import Vec3

DENSITY = 40.0
"""Of the bounding box of furniture that is not known [kg/m3]: published weights of used furniture give 24 to 61."""
FRICTION = 0.5
RUGS = frozenset({"rug", "carpet", "mat", "doormat", "runner", "rugs", "carpets"})
RUG_HEIGHT = 0.12
"""What is called a rug and is no thicker than this is walked on [m]: generators give a carpet 0.10."""


def words_of(kind: str) -> list[str]:
    """The lower-case words of a name: "Coffee Tables-0 (bedroom)" gives coffee, tables."""
    return re.findall(r"[a-z]+", re.sub(r"\(.*\)", "", kind[:200]).lower())


def category_name(kind: str) -> str:
    """A category's name in snake_case: "coffee_tables"; "object" where there are no words."""
    return "_".join(words_of(kind))[:60] or "object"


def usual(kind: str) -> Category | None:
    """The catalogue's category that the last words of a name say, the longest first; None where it has none."""
    return _usual(kind, revision())


@lru_cache(maxsize=1024)
def _usual(kind: str, revision: int) -> Category | None:
    known = _by_words(revision)
    return next((known[form] for form in _endings(kind) if form in known), None)


@lru_cache(maxsize=4)
def _by_words(revision: int) -> Mapping[str, Category]:
    """The categories by their names and by all the words that mean them."""
    called = {"_".join(words_of(phrase)): kind for kind in CATALOGUE.values() for phrase in phrases(kind)}
    return called | dict(CATALOGUE)


def _endings(kind: str) -> Iterator[str]:
    """The last words of a name, the longest ending first, each as it is and without the ending of a plural."""
    words = words_of(kind)
    for start in range(len(words)):
        name = "_".join(words[start:])
        yield from (name, name.removesuffix("s"), name.removesuffix("es"))


def hangs(kind: str) -> bool:
    """Whether such a thing hangs from the ceiling as a rule: a pendant lamp, a chandelier."""
    category = usual(kind)
    return category is not None and category.mount == "ceiling"


def is_lamp(kind: str) -> bool:
    """Whether it is called a lamp, of whatever kind."""
    lamps = set(phrases(GENERAL_WORDS["any_lamp"]))
    return any(form in lamps for form in _endings(kind))


def usual_size(kind: str) -> Vec3 | None:
    """What such a thing measures as a rule [m]; None where it is not known."""
    category = usual(kind)
    return category.size if category else None


def usual_mass(kind: str, size: Vec3) -> float:
    """What such a thing of a size weighs [kg]: the usual mass by the ratio of volumes, held within 0.4 and 2.5."""
    volume, category = size[0] * size[1] * size[2], usual(kind)
    if category is None:
        return max(DENSITY * volume, 0.01)
    ratio = volume / (category.size[0] * category.size[1] * category.size[2])
    return category.mass * min(max(ratio, 0.4), 2.5)


def is_rug(kind: str, height: float) -> bool:
    """Whether it is walked on."""
    return height <= RUG_HEIGHT and bool(RUGS & set(words_of(kind)))
