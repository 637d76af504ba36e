"""Arguments as callers give them: taken where they can be meant, refused with what to give instead."""

import operator
from collections.abc import Sequence

from thinkblox.errors import InputError

MOST_SEED = 2**63 - 1


def seed_given(seed: object) -> int:
    """A seed, also one of NumPy's whole numbers; raises InputError for anything else than 0 to 2^63 - 1."""
    try:
        whole = None if isinstance(seed, bool) else operator.index(seed)  # type: ignore[arg-type]
    except TypeError:
        whole = None
    if whole is None or not 0 <= whole <= MOST_SEED:
        raise InputError(f"the seed is {seed!r}; it must be a whole number from 0 to 2^63 - 1")
    return whole


def names_given(names: Sequence[str], what: str) -> Sequence[str]:
    """Names as a tuple or list; raises InputError for one text, whose letters would be taken for names."""
    if isinstance(names, str):
        raise InputError(f"{what} is the text {names!r}; give a tuple of names, such as ({names!r},)")
    return names
