"""Reinforcement learning with measured rewards: accelerate launch -m thinkblox.training.gdpo CONFIG."""

import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thinkblox.errors import InputError
from thinkblox.sim.workers.pool import VerdictPool
from thinkblox.training.advantages import Advantages, tiered_advantages
from thinkblox.training.config import GdpoConfig, section
from thinkblox.training.episodes import Episodes
from thinkblox.training.models import adapter_for, save_trained, starting_model
from thinkblox.training.outcome import SHARES, Rollout, outcomes
from thinkblox.training.picture_judge import PictureJudge
from thinkblox.training.render_reward import RenderReward
from thinkblox.training.rewards import REWARDS, Reward
from thinkblox.training.rows import rows_of
from thinkblox.training.running import common_arguments, finished, resuming, run


def train_gdpo(config: GdpoConfig) -> Path:
    """Train a model on what is measured of its own answers; goes on from the last checkpoint in `config.out`.

    Where the last update is done and the model written, nothing is done.

    Returns:
        The folder of the trained model, which `hf:` loads.

    Raises:
        InputError: the configuration, the dataset, the model or the judge cannot be used; said before anything is
            trained. Or the judge is gone later on; the checkpoints stay.
    """
    if (done := finished(config)) is not None:
        return done
    judge = None if config.judge is None else PictureJudge(config.judge)
    if judge is not None:
        judge.check()
    rows = rows_of(config.data, "train")
    start = starting_model(config)
    with VerdictPool(workers=config.measurers) as pool:
        measure = Measuring(Episodes(config.data), pool)
        trainer = gdpo_trainer(config, start.model, start.processor, rows, measure, judge=judge)
        run(trainer, config)
    return save_trained(trainer.accelerator.unwrap_model(trainer.model), start.processor, config)


class Measuring:
    """Measures the answers to rows of a dataset."""

    def __init__(self, episodes: Episodes, pool: VerdictPool) -> None:
        self._episodes, self._pool = episodes, pool

    def __call__(self, at: Sequence[str], texts: Sequence[str]) -> list[Rollout]:
        """What becomes of each text, the answer to the decision of the same number in `at`."""
        asked = [(self._episodes.case(place), [text]) for place, text in zip(at, texts, strict=True)]
        return [row[0] for row in outcomes(self._pool, asked)]


def gdpo_trainer(
    config: GdpoConfig,
    model: Any,
    processor: Any,
    rows: Any,
    measure: Callable[..., list[Rollout]],
    *,
    judge: PictureJudge | None = None,
) -> Any:
    """A GRPOTrainer of TRL whose advantages are those of the tiers."""
    from trl import GRPOConfig

    # TRL pads prompts on the left, but takes from the processor, padded its way, which tokens are of pictures.
    processor.tokenizer.padding_side = "left"
    tiers = config.tiers
    names = [name for rewards in tiers.values() for name in rewards]
    arguments = GRPOConfig(
        **common_arguments(config),
        num_generations=config.rollouts,
        generation_batch_size=config.rollouts * config.prompts,
        beta=config.beta,
        temperature=config.temperature,
        max_completion_length=config.tokens,
        scale_rewards="none",
        log_completions=False,
    )
    trainer = _tiered_trainer()(
        model=model,
        args=arguments,
        train_dataset=rows.select_columns(["prompt", "images", "at"]),
        processing_class=processor,
        reward_funcs=[_named(name, judge) for name in names],
        peft_config=adapter_for(config.lora),
    )
    trainer.tiers = {tier: [names.index(name) for name in rewards] for tier, rewards in tiers.items()}
    trainer.tier_weights = [config.weights.get(tier, 1.0) for tier in tiers]
    trainer.measure = measure
    return trainer


def _named(name: str, judge: PictureJudge | None) -> Any:
    """A reward as TRL logs it; its name says who judges."""
    if name in REWARDS:
        reward: Reward = REWARDS[name]
    elif judge is not None:
        reward = RenderReward(judge)
        name = reward.name
    else:
        raise InputError(f"the reward {name!r} needs a judge")

    def rewarded(**columns: Any) -> list[float | None]:
        return reward(**columns)

    rewarded.__name__ = name
    return rewarded


def _tiered_trainer() -> Any:
    from trl import GRPOTrainer

    class TieredTrainer(resuming(GRPOTrainer)):  # type: ignore[misc]
        """Measures every rollout once, and turns rewards into advantages tier by tier.

        TRL has no hook for advantages of one's own: two of its private methods are overridden.
        """

        tiers: dict[str, list[int]]
        tier_weights: list[float]
        measure: Callable[..., list[Rollout]]

        def _calculate_rewards(self, inputs: Any, prompts: Any, completions: Any, completion_ids_list: Any) -> Any:
            texts = [said[-1]["content"] if isinstance(said, list) else said for said in completions]
            found = self.measure([row["at"] for row in inputs], [_text(said) for said in texts])
            self._log_shares(found)
            inputs = [{**row, "outcome": outcome} for row, outcome in zip(inputs, found, strict=True)]
            rewards = super()._calculate_rewards(inputs, prompts, completions, completion_ids_list)
            self._gathered = rewards
            return rewards

        def _generate_and_score_completions(self, inputs: Any) -> Any:
            import torch

            output = super()._generate_and_score_completions(inputs)
            rewards = self._gathered.double().cpu().numpy()
            size = self.num_generations if self.model.training else self.num_generations_eval
            found = tiered_advantages(rewards, list(self.tiers.values()), self.tier_weights, size)
            device = output["advantages"].device
            mine = own_share(found.total, len(inputs), self.accelerator.process_index)
            output["advantages"] = torch.tensor(mine, dtype=output["advantages"].dtype, device=device)
            self._log_advantages(found)
            return output

        def _log_shares(self, found: Sequence[Rollout]) -> None:
            verdicts = [each.tried.verdict for each in found]
            self._log_metric("share/parsed", float(np.mean([each.parsed for each in found])))
            for name, holds in SHARES.items():
                self._log_metric(f"share/{name}", float(np.mean([v is not None and holds(v) for v in verdicts])))

        def _log_advantages(self, found: Advantages) -> None:
            mode = "train" if self.model.training else "eval"
            groups = max(len(found.total) // self.num_generations, 1)
            for number, tier in enumerate(self.tiers):
                self._metrics[mode][f"tiers/{tier}/live"].append(float(found.live[number]) / groups)
                self._metrics[mode][f"tiers/{tier}/spread"].append(float(found.by_tier[:, number].std()))
            logged = self._logs["advantages"]
            for _ in found.total:
                logged.pop()
            logged.extend(found.total.tolist())

    return TieredTrainer


def own_share(total: NDArray[np.float64], count: int, rank: int) -> NDArray[np.float64]:
    """The advantages of a process's own `count` rollouts, of those of all processes in the order of their ranks."""
    return total[rank * count : (rank + 1) * count]


def _text(said: Any) -> str:
    if isinstance(said, str):
        return said
    return "".join(block.get("text") or "" for block in said)


if __name__ == "__main__":
    print(train_gdpo(section(sys.argv[1], "gdpo")))  # noqa: T201
