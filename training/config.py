"""What a training run is told, in YAML: checked whole before anything begins."""

from pathlib import Path
from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta

from thinkblox.errors import InputError
from thinkblox.json_faults import json_fault
from thinkblox.policies.tiny import TinySize
from thinkblox.regular_file import read_text
from thinkblox.training.recipe import Recipe
from thinkblox.training.rewards import REWARDS
from thinkblox.training.tiers import HARD, Scheme, tiers_of
from thinkblox.value import Value

Positive = Annotated[float, Meta(gt=0)]
Count = Annotated[int, Meta(ge=1)]
NamedHard = Literal["paper", "simulation", "gate"]


class Lora(Value, frozen=True, kw_only=True):
    """An adapter on the language layers; the vision tower stays as it is."""

    rank: Count = 16
    alpha: Count = 32
    dropout: Annotated[float, Meta(ge=0, lt=1)] = 0.0


class Training(Value, frozen=True, kw_only=True):
    """What both kinds of training are told.

    Attributes:
        data: folder of a dataset that `thinkblox data build` made.
        out: folder of the checkpoints and of the trained model.
        model: a folder or a repository's id; left out, one is made anew by `size`.
        size: of a model that is made anew.
        lora: train an adapter; all weights when left out.
        seed: of the run.
        steps: updates of the weights.
        batch: rows of one forward pass on each device.
        accumulate: forward passes of one update.
        learning_rate: at its highest.
        warmup: updates until it is reached.
        save: updates between checkpoints.
        log: updates between lines of the log.
        workers: processes that prepare rows.
    """

    data: str
    out: str
    model: str | None = None
    size: TinySize | None = None
    lora: Lora | None = None
    seed: int = 0
    steps: Count
    batch: Count = 8
    accumulate: Count = 1
    learning_rate: Positive = 2e-5
    warmup: Annotated[int, Meta(ge=0)] = 0
    save: Count = 500
    log: Count = 10
    workers: Annotated[int, Meta(ge=0)] = 0


class SftConfig(Training, frozen=True, kw_only=True):
    """Supervised fine-tuning: the model learns to say what the demonstrations say.

    Attributes:
        reading: updates at the start in which the loss is on all that is said; after them it is on the completion
            alone. A model that is made anew has to learn to read before it can answer.
        weight_decay: of all weights.
    """

    reading: Annotated[int, Meta(ge=0)] = 0
    weight_decay: Annotated[float, Meta(ge=0)] = 0.0


class GdpoConfig(Training, frozen=True, kw_only=True):
    """Reinforcement learning with rewards measured in simulation.

    Attributes:
        scheme: "tiered" for Tier-Decoupled GDPO, "gdpo" and "grpo" for what it is compared with.
        hard: rewards of the hard tier: those of the paper, with what the settle measured, or with the gate besides.
        soft: rewards of the soft tier.
        cons: rewards of the tier of consistency.
        weights: of the tiers, by name.
        rollouts: answers to each prompt.
        prompts: prompts of one generation, all processes together.
        beta: weight of the divergence from the model at the start.
        temperature: of the rollouts.
        tokens: longest answer.
        measurers: processes that measure placements.
        judge: a vision-language model that judges pictures, "openai:BASE_URL#MODEL", for the reward "render".
    """

    scheme: Scheme = "tiered"
    hard: NamedHard = "simulation"
    soft: tuple[str, ...] = ("align", "rules")
    cons: tuple[str, ...] = ("cons",)
    weights: dict[str, float] = {}
    rollouts: Annotated[int, Meta(ge=2)] = 8
    prompts: Count = 8
    beta: Annotated[float, Meta(ge=0)] = 0.004
    temperature: Positive = 1.0
    tokens: Count = 400
    measurers: Count = 2
    judge: str | None = None

    @property
    def tiers(self) -> dict[str, tuple[str, ...]]:
        """Names of the rewards of each tier; raises InputError for one in two tiers."""
        return tiers_of(self.scheme, HARD[self.hard], self.soft, self.cons)

    def __post_init__(self) -> None:
        """Raise InputError for what does not go together."""
        known = [*REWARDS, "render"]
        for name, rewards in self.tiers.items():
            unknown = [reward for reward in rewards if reward not in known]
            if unknown:
                raise InputError(f"tier {name!r} names the reward {unknown[0]!r}; there are {', '.join(known)}")
        stray = sorted(set(self.weights) - set(self.tiers))
        if stray:
            raise InputError(f"weights name {stray[0]!r}; the tiers are {', '.join(self.tiers)}")
        if any("render" in rewards for rewards in self.tiers.values()) and not self.judge:
            raise InputError("the reward 'render' needs a judge: judge: openai:BASE_URL#MODEL")
        if self.judge and not any("render" in rewards for rewards in self.tiers.values()):
            raise InputError("a judge is named, but no tier has its reward 'render': soft: [align, render]")
        if (self.rollouts * self.prompts) % self.batch:
            raise InputError(
                f"{self.prompts} prompts of {self.rollouts} rollouts are no whole number of batches of {self.batch};"
                f" choose a batch that divides {self.rollouts * self.prompts}"
            )


class Experiment(Value, frozen=True, kw_only=True):
    """From data to a trained policy, in one file.

    Attributes:
        data: how the dataset is made.
        sft: supervised fine-tuning on it.
        gdpo: reinforcement learning after that.
    """

    data: Recipe | None = None
    sft: SftConfig | None = None
    gdpo: GdpoConfig | None = None


def read_experiment(path: str | Path) -> Experiment:
    """Read a configuration.

    Raises:
        InputError: it cannot be read; a key is not known, missing or wrong; names the file and the place.
    """
    text = read_text(Path(path))
    try:
        return msgspec.yaml.decode(text, type=Experiment)
    except msgspec.ValidationError as error:
        raise InputError(f"{path}: {json_fault(error, text, Experiment)}") from error
    except (msgspec.MsgspecError, InputError, ValueError) as error:
        why = " ".join(str(error).replace('in "<byte string>", ', "").split())
        raise InputError(f"{path}: is not YAML that can be used: {why}") from error
    except ImportError as error:
        raise InputError(f"training needs more than is installed ({error}): pip install 'thinkblox[train]'") from error


def section(path: str | Path, name: Literal["data", "sft", "gdpo"]) -> Any:
    """One section of a configuration; raises InputError as `read_experiment`, and where it has none of that name."""
    found = getattr(read_experiment(path), name)
    if found is None:
        raise InputError(f"{path}: has no section {name!r}")
    return found
