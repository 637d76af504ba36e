"""What is worked out once from something and kept as long as that: never let go of too early, never kept too long.

A table of the latest few hundred assets would forget all that it is about to be asked for when scenes with a few more
assets than it has places come by in turn.
"""

from collections.abc import Callable
from functools import lru_cache, wraps
from typing import Any, Concatenate, ParamSpec, TypeVar

from thinkblox.scene.asset import Asset

Owner = TypeVar("Owner")
P = ParamSpec("P")
T = TypeVar("T")
SHARED = 512
"""Of how many assets a result is found again by content, for equal assets that were made apart."""


def kept(make: Callable[Concatenate[Owner, P], T]) -> Callable[Concatenate[Owner, P], T]:
    """Make a function remember its results on its first argument, by the others."""
    key = f"{make.__module__}.{make.__qualname__}"

    @wraps(make)
    def remembered(owner: Owner, /, *rest: P.args, **named: P.kwargs) -> T:
        results: dict[Any, T] = owner.__dict__.setdefault(key, {})
        arguments = (rest, *sorted(named.items()))
        if arguments not in results:
            results[arguments] = make(owner, *rest, **named)
        return results[arguments]

    return remembered


def kept_by_content(make: Callable[[Asset], T]) -> Callable[[Asset], T]:
    """Make a function of an asset remember its result on the asset, and find it again for an equal asset."""
    return kept(wraps(make)(lru_cache(maxsize=SHARED)(make)))
