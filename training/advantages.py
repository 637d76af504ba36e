"""Tier-Decoupled GDPO: from rewards in tiers to one advantage for each rollout."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thinkblox.errors import InputError

STD_FLOOR = 1e-6
"""Rewards that differ by no more than this teach nothing: their advantages are 0."""
Floats = NDArray[np.float64]


class Advantages(NamedTuple):
    """What came out, and what each tier said.

    Attributes:
        total: (n,) the advantages.
        by_tier: (n, tiers) before they are weighted: normalised within the group; 0 where a tier says nothing.
        live: (tiers,) groups in which the tier tells its rollouts apart.
    """

    total: Floats
    by_tier: Floats
    live: NDArray[np.int64]


def tiered_advantages(
    rewards: ArrayLike, tiers: Sequence[Sequence[int]], weights: Sequence[float], group_size: int
) -> Advantages:
    """The advantages of the rollouts of a batch, in float64.

    With r[k, i] the sum of the rewards of tier k for rollout i of a group G:

        A[k, i] = (r[k, i] - mean over G of r[k]) / std over G of r[k]
        A[i]    = sum over k of w[k] A[k, i]
        A'[i]   = (A[i] - mean over the batch of A) / std over the batch of A

    (ThinkBLOX, Tier-Decoupled GDPO; with a tier for each reward it is GDPO, arXiv 2601.05242; with one tier of all it
    is GRPO, normalised over the batch besides.) Standard deviations have n - 1 below; where one is at most `STD_FLOOR`,
    or where there is nothing to compare, the advantage is 0. A reward that no rollout of a group has is left out of its
    tier there; a rollout that lacks one that others have says nothing in that tier, and its advantage there is 0.

    Args:
        rewards: (n, rewards) of all rollouts of the batch, a group after the other; NaN where there is none.
        tiers: for each tier the columns of its rewards.
        weights: of the tiers.
        group_size: rollouts of one prompt.

    Raises:
        InputError: shapes that do not fit each other, or a reward that is infinite.
    """
    table = np.asarray(rewards, np.float64)
    _check(table, tiers, weights, group_size)
    grouped = table.reshape(-1, group_size, table.shape[1])
    by_tier = np.stack([_tier(grouped[:, :, list(columns)]) for columns in tiers], -1)
    flat = by_tier.reshape(len(table), len(tiers))
    total = normalised(flat @ np.asarray(weights, np.float64), axis=0)
    return Advantages(total, flat, np.count_nonzero(np.any(by_tier != 0.0, axis=1), axis=0))


def _tier(members: Floats) -> Floats:
    """The advantages (groups, size) of one tier from its rewards (groups, size, members)."""
    missing = np.isnan(members)
    nowhere = missing.min(axis=1, keepdims=True)
    sums = np.where(missing & nowhere, 0.0, members).sum(axis=2)
    return normalised(sums, axis=1)


def normalised(values: Floats, *, axis: int) -> Floats:
    """Values less their mean, by their standard deviation (n - 1) along an axis; what is NaN counts for nothing."""
    known = ~np.isnan(values)
    count = known.sum(axis=axis, keepdims=True)
    mean = np.where(known, values, 0.0).sum(axis=axis, keepdims=True) / np.maximum(count, 1)
    apart = np.where(known, values - mean, 0.0)
    std = np.sqrt((apart**2).sum(axis=axis, keepdims=True) / np.maximum(count - 1, 1))
    return np.where(std > STD_FLOOR, apart / np.maximum(std, STD_FLOOR), 0.0)


def _check(rewards: Floats, tiers: Sequence[Sequence[int]], weights: Sequence[float], group_size: int) -> None:
    if rewards.ndim != 2:
        raise InputError(f"rewards have the shape {rewards.shape}; they must be a table, rollouts by rewards")
    if group_size < 1 or len(rewards) % group_size:
        raise InputError(f"{len(rewards)} rollouts are no whole number of groups of {group_size}")
    columns = [column for tier in tiers for column in tier]
    if not tiers or not all(tiers) or not set(columns) <= set(range(rewards.shape[1])):
        raise InputError(
            f"tiers {list(map(list, tiers))} must each name some of the rewards 0 to {rewards.shape[1] - 1}"
        )
    if len(weights) != len(tiers):
        raise InputError(f"{len(tiers)} tiers have {len(weights)} weights; each needs one")
    if np.isinf(rewards).any() or not np.isfinite(np.asarray(weights, np.float64)).all():
        raise InputError("a reward or a weight is infinite")
