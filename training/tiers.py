"""Which rewards belong together: GRPO, GDPO and Tier-Decoupled GDPO are one code with another table of tiers."""

from collections.abc import Iterable
from typing import Literal

from thinkblox.errors import InputError

HARD: dict[str, tuple[str, ...]] = {
    "paper": ("format", "coll", "layout"),
    "simulation": ("format", "coll", "layout", "support", "settle"),
    "gate": ("format", "coll", "layout", "support", "settle", "valid"),
}
"""The hard tier: as the paper has it; with what the settle measured; and with the generator's own gate."""
Scheme = Literal["grpo", "gdpo", "tiered"]


def tiers_of(
    scheme: Scheme, hard: Iterable[str], soft: Iterable[str], cons: Iterable[str]
) -> dict[str, tuple[str, ...]]:
    """The tiers of a scheme, by name: all rewards in one, each in its own, or hard, soft and cons."""
    tiers = {"hard": tuple(hard), "soft": tuple(soft), "cons": tuple(cons)}
    tiers = {name: rewards for name, rewards in tiers.items() if rewards}
    every = tuple(reward for rewards in tiers.values() for reward in rewards)
    if len(set(every)) < len(every):
        twice = next(reward for reward in every if every.count(reward) > 1)
        raise InputError(f"the reward {twice!r} is in two tiers; it must be in one")
    match scheme:
        case "grpo":
            return {"all": every}
        case "gdpo":
            return {reward: (reward,) for reward in every}
    return tiers
