"""Who is measured: a policy, how it is asked, and what it is shown."""

from functools import lru_cache
from pathlib import Path
from typing import Literal, NamedTuple

from msgspec import structs

from thinkblox.chat import ChatModel
from thinkblox.errors import InputError
from thinkblox.modes import Mode
from thinkblox.observe import Sight
from thinkblox.orders import Order
from thinkblox.players import EXPERT, FORMS, chat_model, is_learned, learned_folder, model_policy
from thinkblox.policies import Policy
from thinkblox.policies.expert import ExpertPolicy
from thinkblox.policies.hf import trained_sight
from thinkblox.value import Value

Mark = Literal["grid", "ids", "fronts", "target", "pictures"]
"""What a model can be shown less of: metres along the walls, names, arrows at fronts, the object alone, any picture."""


class NoPolicyError(InputError):
    """A policy, or a judge, cannot be had or cannot go on: says who, why, and what to do."""


class Contender(Value, frozen=True, kw_only=True):
    """One row of a table.

    Attributes:
        name: of the row.
        policy: who places, by its specification.
        mode: whether a model is asked for one object after the other, or once for all of them.
        order: in which objects are placed.
        without: what a model is not shown.
    """

    name: str
    policy: str
    mode: Mode = "progressive"
    order: Order = "plan"
    without: tuple[Mark, ...] = ()

    def check(self) -> None:
        """Raise InputError for what nobody can play; no model is loaded."""
        kind = self.policy.partition(":")[0]
        if self.mode == "one-shot" and self.without:
            raise InputError(f"{self.name}: at once a model is shown no pictures; there is nothing to leave out")
        if self.policy == EXPERT and (self.mode == "one-shot" or self.without):
            raise InputError(f"{self.name}: the expert answers step by step and looks at nothing; measure a model")
        if kind == "replay":
            raise InputError(f"{self.name}: a trace plays one room again, and cannot be measured on others")
        if kind == "openai":
            chat_model(self.policy)
        elif is_learned(self.policy):
            learned_folder(self.policy)
        elif kind != "hf" and self.policy != EXPERT:
            raise InputError(f"{self.name}: {self.policy[:20]!r} names nobody; give {FORMS}")
        if self.policy != EXPERT:
            self.sight()

    @property
    def folders(self) -> list[Path]:
        """Where a model on this machine is, and then its adapter."""
        if is_learned(self.policy):
            return [learned_folder(self.policy)]
        kind, _, rest = self.policy.partition(":")
        model, _, adapter = (rest, "", "") if Path(rest).is_dir() else rest.rpartition("+")
        return [Path(part) for part in (model, adapter) if kind == "hf" and part and Path(part).is_dir()]

    @property
    def stamp(self) -> str:
        """Of when the files of a model on this machine are: what was measured of others is not of these."""
        files = [file for folder in self.folders for file in sorted(folder.glob("*.safetensors"))]
        return " ".join(f"{file.name}:{file.stat().st_size}:{file.stat().st_mtime_ns}" for file in files)

    @property
    def trained(self) -> Sight | None:
        """What a model was shown in training, where its folder says so; raises InputError."""
        return next((sight for folder in self.folders[:1] if (sight := trained_sight(folder))), None)

    def sight(self) -> Sight:
        """What a model is shown; raises InputError where it is not shown what is to be left out."""
        whole = self.trained or Sight()
        less = [mark for mark in self.without if not getattr(whole, mark) or not whole.pictures]
        if less:
            raise InputError(f"{self.name}: {self.policy} was trained without {less[0]}; there is nothing to leave out")
        return structs.replace(whole, **dict.fromkeys(self.without, False))


class Spent(NamedTuple):
    """Tokens that a model read and wrote."""

    read: int
    written: int


class Player:
    """Who plays for a contender, its model loaded once."""

    def __init__(self, contender: Contender) -> None:
        """Load the model; raises InputError."""
        self._contender = contender
        self._model = None if contender.policy == EXPERT else _loaded(contender.policy)

    def policy(self) -> Policy:
        """A policy for one room, that knows nothing of others."""
        if self._model is None:
            return ExpertPolicy()
        return model_policy(self._model, mode=self._contender.mode, sight=self._contender.sight())

    @property
    def spent(self) -> Spent | None:
        """Tokens so far; None where nobody counts them."""
        counts = getattr(self._model, "counts", None)
        return None if counts is None else Spent(counts.prompt, counts.made)


@lru_cache(maxsize=1)
def _loaded(spec: str) -> ChatModel:
    return chat_model(spec)
