"""Advantages of tiers: against the paper's equations written out, against TRL's own, and where nothing can be told."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from thinkblox import InputError
from thinkblox.training.advantages import tiered_advantages
from thinkblox.training.tiers import HARD, tiers_of

TIERS = [[0, 1, 2], [3, 4], [5]]
WEIGHTS = [1.0, 0.5, 0.25]


def random_rewards(seed: int, groups: int = 4, size: int = 8) -> np.ndarray:
    return np.random.default_rng(seed).normal(size=(groups * size, 6))


def transcribed(rewards: np.ndarray, tiers: list[list[int]], weights: list[float], size: int) -> list[float]:
    """The three equations, one rollout at a time."""
    sums = []
    for start in range(0, len(rewards), size):
        group = rewards[start : start + size]
        rows = [0.0] * size
        for tier, weight in zip(tiers, weights, strict=True):
            said = [sum(row[column] for column in tier) for row in group]
            mean = sum(said) / size
            std = (sum((s - mean) ** 2 for s in said) / (size - 1)) ** 0.5
            rows = [row + weight * (s - mean) / std for row, s in zip(rows, said, strict=True)]
        sums += rows
    mean = sum(sums) / len(sums)
    std = (sum((s - mean) ** 2 for s in sums) / (len(sums) - 1)) ** 0.5
    return [(s - mean) / std for s in sums]


@given(st.integers(0, 2**32 - 1))
def test_it_is_what_the_paper_says(seed: int) -> None:
    rewards = random_rewards(seed)
    assert tiered_advantages(rewards, TIERS, WEIGHTS, 8).total == pytest.approx(
        transcribed(rewards, TIERS, WEIGHTS, 8), abs=1e-9
    )


@given(st.integers(0, 2**32 - 1))
def test_it_agrees_with_trl_on_sums_of_tiers(seed: int) -> None:
    torch = pytest.importorskip("torch")
    from trl.trainer.utils import nanstd

    rewards = random_rewards(seed, groups=8)
    sums = torch.tensor(np.stack([rewards[:, tier].sum(1) for tier in TIERS], -1))
    grouped = sums.view(-1, 8, 3)
    each = (grouped - grouped.nanmean(dim=1, keepdim=True)) / (nanstd(grouped, dim=1, keepdim=True) + 1e-4)
    total = (each.view(-1, 3) * torch.tensor(WEIGHTS)).nansum(dim=1)
    theirs = (total - total.nanmean()) / (nanstd(total) + 1e-4)
    assert tiered_advantages(rewards, TIERS, WEIGHTS, 8).total == pytest.approx(theirs.numpy(), abs=1e-3)


def test_equal_rewards_teach_nothing() -> None:
    found = tiered_advantages(np.full((16, 6), np.float32(0.6)), TIERS, WEIGHTS, 8)
    assert not found.total.any()
    assert found.live.tolist() == [0, 0, 0]


def test_a_dead_tier_leaves_the_others_alone() -> None:
    rewards = random_rewards(1)
    rewards[:, 5] = -1.0
    both = tiered_advantages(rewards, TIERS, WEIGHTS, 8)
    assert both.total == pytest.approx(tiered_advantages(rewards, TIERS[:2], WEIGHTS[:2], 8).total)
    assert both.live.tolist() == [4, 4, 0]


def test_a_reward_that_no_rollout_of_a_group_has_is_left_out() -> None:
    rewards = random_rewards(2)
    rewards[:8, 3] = np.nan
    filled = rewards.copy()
    filled[:8, 3] = 0.0
    assert tiered_advantages(rewards, TIERS, WEIGHTS, 8).total == pytest.approx(
        tiered_advantages(filled, TIERS, WEIGHTS, 8).total
    )


def test_a_rollout_that_lacks_what_others_have_says_nothing_in_that_tier() -> None:
    rewards = random_rewards(3)
    rewards[2, 4] = np.nan
    found = tiered_advantages(rewards, TIERS, WEIGHTS, 8)
    assert found.by_tier[2, 1] == 0.0
    assert found.by_tier[3, 1] != 0.0
    assert np.isfinite(found.total).all()


def test_small_differences_of_one_tier_count_as_much_as_large_ones_of_another() -> None:
    """What tiers are for: the hard tier is not drowned by soft rewards of a larger spread."""
    rewards = random_rewards(4)
    louder = rewards.copy()
    louder[:, 3:5] *= 100.0
    assert tiered_advantages(louder, TIERS, WEIGHTS, 8).total == pytest.approx(
        tiered_advantages(rewards, TIERS, WEIGHTS, 8).total
    )


@pytest.mark.parametrize(
    ("rewards", "tiers", "weights", "size", "says"),
    [
        (np.zeros((7, 2)), [[0, 1]], [1.0], 8, "7 rollouts are no whole number of groups of 8"),
        (np.zeros((8, 2)), [[0, 2]], [1.0], 8, "0 to 1"),
        (np.zeros((8, 2)), [[0], []], [1.0, 1.0], 8, "must each name"),
        (np.zeros((8, 2)), [[0, 1]], [1.0, 2.0], 8, "1 tiers have 2 weights"),
        (np.zeros(8), [[0]], [1.0], 8, "rollouts by rewards"),
        (np.full((8, 1), np.inf), [[0]], [1.0], 8, "infinite"),
    ],
)
def test_what_does_not_fit_is_refused(rewards, tiers, weights, size, says) -> None:
    with pytest.raises(InputError, match=says):
        tiered_advantages(rewards, tiers, weights, size)


def test_schemes_are_tables_of_tiers() -> None:
    soft, cons = ("align", "rules"), ("cons",)
    assert tiers_of("tiered", HARD["paper"], soft, cons) == {
        "hard": ("format", "coll", "layout"),
        "soft": soft,
        "cons": cons,
    }
    assert list(tiers_of("gdpo", HARD["paper"], soft, cons)) == ["format", "coll", "layout", "align", "rules", "cons"]
    assert len(tiers_of("grpo", HARD["paper"], soft, cons)["all"]) == 6
    assert list(tiers_of("tiered", HARD["paper"], (), cons)) == ["hard", "cons"]
    with pytest.raises(InputError, match="'coll' is in two tiers"):
        tiers_of("tiered", HARD["paper"], ("coll",), cons)
