"""What the figures of a category must be, so that something can be made by them."""

import math
from collections.abc import Iterator
from typing import get_args

from thinkblox.assets.category import FRONTS, Category
from thinkblox.errors import InputError
from thinkblox.scene.asset import Mount


def check_figures(category: Category, where: str) -> None:
    """Make sure that things can be made by what a category says of them.

    Args:
        category: that somebody made.
        where: what it is called in messages.

    Raises:
        InputError: a size, a mass, a share or a word that cannot be, or a generator that cannot be called.
    """
    fault = next(_faults(category), None)
    if fault is not None:
        raise InputError(f"{where}: {fault}")


def _faults(category: Category) -> Iterator[str]:
    for size in (category.size, *category.variants.values()):
        if len(size) != 3 or not all(map(_is_positive, size)):
            yield f"a size of {size}; give three lengths above 0"
    for name in ("mass", "friction"):
        if not _is_positive(getattr(category, name)):
            yield f"its {name} is {getattr(category, name)!r}; it must be above 0"
    yield from _shares(category)
    for name, known in (("front", FRONTS), ("mount", get_args(Mount))):
        if getattr(category, name) not in known:
            yield f"its {name} is {getattr(category, name)!r}; it must be one of {', '.join(known)}"
    if not callable(category.generator):
        yield f"its generator is {category.generator!r}; give a function"


def _shares(category: Category) -> Iterator[str]:
    for name in ("clearance", "variation"):
        value = getattr(category, name)
        if value != 0.0 and not _is_positive(value):
            yield f"its {name} is {value!r}; it must be 0 or more"
        elif name == "variation" and value >= 1.0:
            yield f"its variation is {value!r}; it is a share, and less than 1"
    for name, fits in (("low", category.low <= 1.0), ("high", category.high >= 1.0)):
        if not (_is_positive(getattr(category, name)) and fits):
            yield f"{name} is {getattr(category, name)!r}; it must be a share that leaves its own size in between"


def _is_positive(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and 0.0 < value < math.inf
