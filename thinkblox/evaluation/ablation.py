"""The table of the paper's ablations: which models a configuration names for its rows."""

import tomllib
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Annotated

import msgspec
from msgspec import Meta

from thinkblox.errors import InputError
from thinkblox.evaluation.comparing import Told, measured
from thinkblox.evaluation.comparison import ContenderResult
from thinkblox.evaluation.contenders import Contender, Mark, NoPolicyError
from thinkblox.evaluation.policy_run import Trial
from thinkblox.modes import Mode
from thinkblox.orders import Order
from thinkblox.players import EXPERT
from thinkblox.regular_file import read_text
from thinkblox.value import Value

_TABLE = "ablations.toml"


class AblationRow(Value, frozen=True, kw_only=True):
    """A row of the paper's table.

    Attributes:
        models: names in a configuration; the first that is there plays.
        psa: as it was published.
    """

    name: str
    models: tuple[str, ...]
    mode: Mode = "progressive"
    order: Order = "plan"
    without: tuple[Mark, ...] = ()
    psa: float | None = None


class _Table(Value, frozen=True):
    row: tuple[AblationRow, ...]


class Ablation(Value, frozen=True, kw_only=True):
    """What `thinkblox ablate` is told, in YAML.

    Attributes:
        prompts: file of prompts, one a line; as seen from the configuration's folder.
        models: for the rows' models folders, as seen from there, or specifications.
        runs: how often each prompt is furnished.
        seed: of the first run.
        judge: who rates pictures, "openai:BASE_URL#MODEL".
    """

    prompts: str
    models: dict[str, str]
    runs: Annotated[int, Meta(ge=1, le=1000)] = 3
    seed: Annotated[int, Meta(ge=0, le=2**62)] = 0
    judge: str | None = None

    def __post_init__(self) -> None:
        """Raise InputError for models that no row has."""
        known = list(dict.fromkeys(model for row in ablation_rows() for model in row.models))
        if stray := next((name for name in self.models if name not in known), ""):
            raise InputError(f"models name {stray!r}; there are {', '.join(known)}")


@cache
def ablation_rows() -> tuple[AblationRow, ...]:
    """The rows of the paper's table."""
    text = files("thinkblox.evaluation").joinpath(_TABLE).read_text("utf-8")
    return msgspec.convert(tomllib.loads(text), _Table).row


def read_ablation(path: Path) -> Ablation:
    """Read a configuration.

    Raises:
        InputError: it cannot be read; a key is not known, missing or wrong; names the file.
    """
    try:
        return msgspec.yaml.decode(read_text(path), type=Ablation)
    except (msgspec.MsgspecError, InputError, ValueError) as error:
        raise InputError(f"{path}: {error}") from error
    except ImportError as error:
        raise InputError(f"{path}: YAML cannot be read ({error}); pip install 'thinkblox[train]'") from error


def measured_row(
    row: AblationRow, ablation: Ablation, home: Path, trial: Trial, *, jobs: int, on_room: Told
) -> ContenderResult:
    """A row measured, or why it is missing."""
    contender = contender_of(row, ablation.models, home)
    try:
        if not contender.policy:
            raise NoPolicyError(f"models name no {row.models[0]}")
        if why := _not_there(contender.policy):
            raise NoPolicyError(why)
        contender.check()
    except InputError as error:
        return ContenderResult(contender=contender, missing=str(error), published=row.psa)
    try:
        found = measured(contender, trial, jobs=jobs, on_room=on_room)
    except NoPolicyError as error:
        return ContenderResult(contender=contender, missing=str(error), published=row.psa)
    return msgspec.structs.replace(found, published=row.psa)


def contender_of(row: AblationRow, models: dict[str, str], home: Path) -> Contender:
    """Who plays a row; no policy where no model of it is named.

    A model of the row's own, trained without what the row leaves out, is shown what it was trained on.
    """
    name = next((name for name in row.models if name in models), "")
    spec = models.get(name, "")
    policy = spec if not spec or spec == EXPERT or spec.startswith(("hf:", "openai:")) else f"hf:{home / spec}"
    contender = Contender(name=row.name, policy=policy, mode=row.mode, order=row.order, without=row.without)
    sight = contender.trained
    own = name == row.models[0] and sight is not None and not all(getattr(sight, mark) for mark in row.without)
    return msgspec.structs.replace(contender, without=()) if own else contender


def _not_there(policy: str) -> str:
    """That a folder is missing; empty for what is there, or is nowhere on this machine."""
    kind, _, rest = policy.partition(":")
    looks_like_a_folder = kind == "hf" and rest.startswith(("/", "./", "../"))
    return f"{rest} is not there" if looks_like_a_folder and not Path(rest.partition("+")[0]).is_dir() else ""
