"""Vision-language models of transformers and their processors, read from a folder or a repository."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from thinkblox.chat import Message
from thinkblox.errors import InputError
from thinkblox.policies.chat_format import encode
from thinkblox.policies.processors import FAMILIES, read_processor

EXTRA = "pip install 'thinkblox[vlm]'"


@dataclass(frozen=True)
class Pretrained:
    """A model and what prepares texts and images for it."""

    processor: Any
    model: Any


def load_pretrained(name: str | Path, *, adapter: str | Path | None = None, device: str | None = None) -> Pretrained:
    """A model of a folder or a repository, bfloat16 on a GPU and float32 on a CPU, in evaluation mode.

    Args:
        name: a folder with a model and its processor, or a repository's id, which is downloaded.
        adapter: a folder or repository with a PEFT adapter, which is merged into the weights.
        device: as torch names it; "cuda" when not given and there is one, else "cpu".

    Raises:
        InputError: what is missing or does not fit, and what to do.
    """
    torch = _torch()
    place = _device(torch, device)
    family = _family(str(name))
    with quiet():
        processor = _processor(family, str(name))
        model = _model(str(name), torch.bfloat16 if place.type == "cuda" else torch.float32)
        if len(processor.tokenizer) > model.get_input_embeddings().num_embeddings:
            raise InputError(f"{name}: its processor has {len(processor.tokenizer)} tokens, its model fewer")
        if adapter is not None:
            model = _adapted(model, str(adapter), str(name))
    return Pretrained(processor, model.to(place).eval())


def _torch() -> Any:
    try:
        import peft  # noqa: F401
        import torch
        import transformers  # noqa: F401
    except ImportError as error:
        raise InputError(f"models on this machine need more than is installed ({error}): {EXTRA}") from error
    return torch


def _device(torch: Any, device: str | None) -> Any:
    if device is None:
        return torch.device("cuda" if torch.cuda.is_available() else "cpu")
    try:
        place = torch.device(device)
    except RuntimeError as error:
        raise InputError(f"there is no device {device!r}: {_first_line(error)}; give cpu, cuda or cuda:N") from error
    if place.type not in ("cpu", "cuda"):
        raise InputError(f"models run on cpu or cuda, not on {device!r}")
    if place.type == "cuda" and (place.index or 0) >= torch.cuda.device_count():
        raise InputError(
            f"there is no {device}: torch {torch.__version__} sees {torch.cuda.device_count()} GPUs; use cpu"
        )
    return place


def _family(name: str) -> str:
    """The family of a model by its config.json."""
    from transformers import AutoConfig

    folder = Path(name)
    if folder.is_dir() and not (folder / "config.json").is_file():
        held = ", ".join(sorted(path.name for path in folder.iterdir())[:8]) or "nothing"
        raise InputError(f"{name}: not a model: the folder has no config.json; it holds {held}")
    if folder.is_file() or (not folder.exists() and (folder.is_absolute() or name.startswith((".", "~")))):
        raise InputError(f"{name}: not a folder with a model")
    try:
        family = str(AutoConfig.from_pretrained(name).model_type)
    except Exception as error:  # the library lets errors of files, JSON and networks through as they come
        raise InputError(f"{name}: no model can be read there: {_first_line(error)}") from error
    if family not in FAMILIES:
        raise InputError(f"{name}: a model of the family {family}; {' and '.join(FAMILIES)} can be run here")
    return family


def _processor(family: str, name: str) -> Any:
    try:
        processor = read_processor(family, name)
    except Exception as error:  # as above
        raise InputError(
            f"{name}: the model has no processor that can be read ({_first_line(error)}); save it into the same folder"
            " with processor.save_pretrained(folder)"
        ) from error
    if not processor.chat_template:
        raise InputError(f"{name}: the model's processor has no chat template")
    _check_writes(processor, name)
    return processor


def _check_writes(processor: Any, name: str) -> None:
    """Raise InputError for a processor by which the model would not see what it is asked."""
    asked = "Where does it go?"
    try:
        tokens = encode(processor, (Message("system", ("Be brief.",)), Message("user", (asked,))))["input_ids"][0]
    except Exception as error:  # a template is anybody's code
        raise InputError(
            f"{name}: the model's chat template cannot write a chat, whose contents are lists of texts and images"
            f" ({_first_line(error)}); save the one of its family into the folder"
        ) from error
    if asked not in processor.tokenizer.decode(tokens):
        raise InputError(
            f"{name}: a question does not come through the model's tokenizer and chat template; save those of its"
            " family into the folder with processor.save_pretrained(folder)"
        )


def _model(name: str, dtype: Any) -> Any:
    from transformers import AutoModelForImageTextToText

    try:
        model, found = AutoModelForImageTextToText.from_pretrained(name, dtype=dtype, output_loading_info=True)
    except Exception as error:  # as above
        raise InputError(f"{name}: the model's weights cannot be read: {_first_line(error)}") from error
    missing = sorted(found["missing_keys"])
    if missing:
        raise InputError(f"{name}: {len(missing)} of the model's weights are missing, the first {missing[0]}")
    return model


def _adapted(model: Any, adapter: str, name: str) -> Any:
    from peft import PeftConfig, PeftModel, get_peft_model_state_dict
    from peft.utils.save_and_load import load_peft_weights

    try:
        said = PeftConfig.from_pretrained(adapter)
        weights = load_peft_weights(adapter, device="cpu")
    except Exception as error:  # as above
        raise InputError(f"{adapter}: no adapter can be read there: {_first_line(error)}") from error
    other = f"{adapter}: not an adapter for {name}"
    if said.base_model_name_or_path:
        other += f" (it was trained on {said.base_model_name_or_path})"
    try:
        with warnings.catch_warnings():  # of missing keys, which are looked at below
            warnings.simplefilter("ignore", UserWarning)
            adapted = PeftModel.from_pretrained(model, adapter)
    except Exception as error:  # as above
        raise InputError(f"{other}: {_first_line(error)}") from error
    differing = sorted(set(get_peft_model_state_dict(adapted)).symmetric_difference(weights))
    if differing:
        raise InputError(f"{other}: {len(differing)} of its weights do not fit, the first {differing[0]}")
    return adapted.merge_and_unload()


def _first_line(error: Exception) -> str:
    said = str(error).strip() or type(error).__name__
    return said.splitlines()[0][:300]


@contextmanager
def quiet() -> Iterator[None]:
    """Without the library's progress bars and its advice; what fails is said by an error."""
    from transformers.utils import logging

    level, bars = logging.get_verbosity(), logging.is_progress_bar_enabled()
    logging.set_verbosity_error()
    logging.disable_progress_bar()
    try:
        yield
    finally:
        logging.set_verbosity(level)
        if bars:
            logging.enable_progress_bar()
