"""Who plays which role, said in a word: "expert", "learned", "hf:PATH", "openai:URL#MODEL" or "replay:TRACE"."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.assets.source import AssetSource
from thinkblox.chat import ChatModel
from thinkblox.errors import InputError
from thinkblox.fills import FILLS, Fill
from thinkblox.modes import MODES, Mode
from thinkblox.observe import Sight
from thinkblox.planning import ExpertPlanner
from thinkblox.policies import Briefer, Planner, Policy
from thinkblox.policies.expert import ExpertPolicy
from thinkblox.policies.model import ModelPolicy
from thinkblox.policies.one_shot import OneShotPolicy
from thinkblox.policies.understanding import ModelBriefer, ModelPlanner
from thinkblox.reading import GrammarBriefer
from thinkblox.replaying import Replay

if TYPE_CHECKING:
    from thinkblox.policies.openai_server import Asking, OpenAiModel

EXPERT, LEARNED = "expert", "learned"
FORMS = "expert, learned[:FOLDER], hf:PATH_OR_ID[+ADAPTER], openai:BASE_URL#MODEL or replay:TRACE"
"""What there is, for help and errors."""
LEARNED_FOLDER = Path("out/small/gdpo/model")
"""Where `learned` is looked for: there `thinkblox train gdpo --config training/configs/small.yaml` writes it."""
LEARNED_TOKENS = 200
"""Longest answer of it."""


@dataclass(frozen=True)
class Players:
    """Who plays the three roles.

    Attributes:
        rounds: how often the policy has something to say about one object; None for as often as it is asked.
        once: the room is not begun anew.
    """

    policy: Policy
    briefer: Briefer
    planner: Planner
    rounds: int | None = None
    once: bool = False


def players(
    policy: Policy | str | None = None,
    *,
    briefer: Briefer | str | None = None,
    planner: Planner | str | None = None,
    mode: Mode = "progressive",
    fill: Fill = "essentials",
    seed: int = 0,
    source: AssetSource | None = None,
    sight: Sight | None = None,
) -> Players:
    """Those who play the roles that are named.

    Args:
        policy: who proposes places. The specification of a model gives it the other roles as well, but "learned", which
            can do nothing else.
        briefer: who understands the prompt; who is named as the policy, or else the grammar, where it is left out.
        planner: who decides on the room and the order; likewise, or else the embedded expert.
        mode: whether a model is asked for one object after the other, or once for all of them.
        fill: for who reads, how much is added to what the prompt names.
        seed: for the samples of models that read and plan.
        source: for models that plan.
        sight: for models that place.

    Raises:
        InputError: a specification that is none, a model that cannot be had, a trace that cannot be read, or a mode
            for somebody who is no model.
    """
    if mode not in MODES:
        raise InputError(f"mode is {mode!r}; it must be one of {', '.join(MODES)}")
    if fill not in FILLS:
        raise InputError(f"fill is {fill!r}; it must be one of {', '.join(FILLS)}")
    said = policy if isinstance(policy, str) and not is_learned(policy) else EXPERT
    made: dict[str, ChatModel | Replay | None] = {}

    def who(spec: str) -> ChatModel | Replay | None:
        if spec not in made:
            made[spec] = _player(spec)
        return made[spec]

    places = _policy(policy, who, mode, sight)
    return Players(
        policy=places,
        briefer=_briefer(said if briefer is None else briefer, who, fill, seed),
        planner=_planner(said if planner is None else planner, who, seed, source),
        rounds=1 if mode == "one-shot" else None,
        once=isinstance(places, Replay),
    )


def chat_model(spec: str) -> ChatModel:
    """The model that a specification names.

    Raises:
        InputError: it names none, or one that cannot be had.
    """
    found = _player(spec)
    if found is None or isinstance(found, Replay):
        raise InputError(f"{spec!r} is no model; give hf:PATH_OR_ID[+ADAPTER] or openai:BASE_URL#MODEL")
    return found


def judging_server(spec: str, *, asking: "Asking | None" = None) -> "OpenAiModel":
    """The model behind a server that a specification names, for who needs more of it than answers.

    Raises:
        InputError: it names none, or one whose address cannot be used.
    """
    from thinkblox.policies.openai_server import OpenAiModel

    kind, _, rest = spec.partition(":")
    if kind != "openai":
        raise InputError("a judge of pictures is a model behind a server: openai:BASE_URL#MODEL")
    url, _, model = rest.strip().partition("#")
    return OpenAiModel(url, model, asking=asking)


def _player(spec: str) -> ChatModel | Replay | None:
    """Who a specification names; None for the expert."""
    if spec == EXPERT:
        return None
    if is_learned(spec):
        return _learned(spec)
    kind, colon, rest = spec.partition(":")
    if colon and kind in _MADE:
        return _MADE[kind](rest.strip())
    # Somebody may have put a key there.
    raise InputError(f"{spec[:20]!r}{'...' if len(spec) > 20 else ''} names nobody; give {FORMS}")


def _openai(rest: str) -> ChatModel:
    from thinkblox.policies.openai_server import OpenAiModel

    url, _, model = rest.partition("#")
    return OpenAiModel(url, model)


def _hf(rest: str) -> ChatModel:
    if not rest:
        raise InputError("hf: which model? Give its folder or id, as in hf:Qwen/Qwen2.5-VL-3B-Instruct")
    path, plus, adapter = (rest, "", "") if Path(rest).is_dir() else rest.rpartition("+")
    if plus and not (path and adapter):
        raise InputError("hf: give the model before the +, and its adapter behind it")
    from thinkblox.policies.hf import HfModel

    return HfModel(path or adapter, adapter if plus else None)


def is_learned(spec: str) -> bool:
    """Whether a specification names the learned policy."""
    return spec == LEARNED or spec.startswith(f"{LEARNED}:")


def learned_folder(spec: str) -> Path:
    """Where the learned policy is that a specification names; raises InputError where there is none."""
    rest = spec.partition(":")[2].strip()
    folder = Path(rest) if rest else LEARNED_FOLDER
    if not (folder / "config.json").is_file():
        config = "--config training/configs/small.yaml"
        raise InputError(
            f"learned: there is no model in {folder}; train one on a CPU: thinkblox data build {config} --out"
            f" out/small/data, thinkblox train sft {config}, thinkblox train gdpo {config}; or give learned:FOLDER"
        )
    return folder


def _learned(spec: str) -> ChatModel:
    folder = learned_folder(spec)
    from thinkblox.policies.hf import HfModel

    return HfModel(folder, max_new_tokens=LEARNED_TOKENS)


def _replay(rest: str) -> Replay:
    if not rest:
        raise InputError("replay: which trace? Give a trace.jsonl, or the folder of a room that holds one")
    return Replay(rest)


_MADE: dict[str, Callable[[str], ChatModel | Replay]] = {"openai": _openai, "hf": _hf, "replay": _replay}
_Who = Callable[[str], ChatModel | Replay | None]


def _policy(policy: Policy | str | None, who: _Who, mode: Mode, sight: Sight | None) -> Policy:
    found = who(policy) if isinstance(policy, str) else None
    is_model = found is not None and not isinstance(found, Replay)
    if mode == "one-shot" and not is_model:
        raise InputError("the mode one-shot is for models; give one as the policy, by its specification")
    if found is None:
        return ExpertPolicy() if policy is None or isinstance(policy, str) else policy
    if isinstance(found, Replay):
        return found
    return model_policy(found, mode=mode, sight=sight)


def model_policy(model: ChatModel, *, mode: Mode, sight: Sight | None = None) -> Policy:
    """The policy of a model, asked for one object after the other or once for all of them."""
    return OneShotPolicy(model) if mode == "one-shot" else ModelPolicy(model, sight=sight)


def _briefer(briefer: Briefer | str, who: _Who, fill: Fill, seed: int) -> Briefer:
    if not isinstance(briefer, str):
        return briefer
    found = who(briefer)
    if found is None:
        return GrammarBriefer(fill)
    return found if isinstance(found, Replay) else ModelBriefer(found, fill=fill, seed=seed)


def _planner(planner: Planner | str, who: _Who, seed: int, source: AssetSource | None) -> Planner:
    if not isinstance(planner, str):
        return planner
    found = who(planner)
    if found is None:
        return ExpertPlanner()
    return found if isinstance(found, Replay) else ModelPlanner(found, source=source, seed=seed)
