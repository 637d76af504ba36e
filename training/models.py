"""The model that a run trains: made anew, or read, with an adapter or whole; and where it is kept."""

from pathlib import Path
from typing import Any

from thinkblox.errors import InputError
from thinkblox.policies.hf import SIGHT
from thinkblox.policies.pretrained import Pretrained, load_pretrained, quiet
from thinkblox.policies.tiny import build_tiny
from thinkblox.training.config import Lora, Training
from thinkblox.training.rows import recipe_of, texts_of
from thinkblox.value import to_json
from thinkblox.whole_file import write_whole

LANGUAGE_LAYERS = r".*language_model.*\.(q|k|v|o|gate|up|down)_proj"
"""The layers that an adapter is for. Those of the vision tower have the same names."""
START, MODEL = "start", "model"
"""In the folder of a run: the model made anew, and the trained one."""


def starting_model(config: Training) -> Pretrained:
    """The model to be trained, in full precision, since its weights are what is optimised.

    Raises:
        InputError: it is not there, or cannot be made.
    """
    import torch
    from accelerate import PartialState

    name = config.model
    if name is None:
        if config.size is None:
            raise InputError("the configuration names neither a model nor the size of a new one; give model or size")
        name, state = str(Path(config.out) / START), PartialState()
        if state.is_main_process:
            build_tiny(name, size=config.size, seed=config.seed, texts=texts_of(config.data))
        state.wait_for_everyone()
    read = load_pretrained(name)
    if config.lora is None:
        read.model.to(torch.float32)
    return Pretrained(read.processor, read.model.train())


def adapter_for(lora: Lora | None) -> Any:
    """The settings of an adapter, as PEFT takes them; None for training all weights."""
    if lora is None:
        return None
    from peft import LoraConfig

    return LoraConfig(
        r=lora.rank,
        lora_alpha=lora.alpha,
        lora_dropout=lora.dropout,
        target_modules=LANGUAGE_LAYERS,
        task_type="CAUSAL_LM",
    )


def save_trained(model: Any, processor: Any, config: Training) -> Path:
    """Write a trained model, adapters merged, with its processor and what it is used to be shown, for `hf:`.

    Returns:
        Its folder.
    """
    folder = Path(config.out) / MODEL
    with quiet():
        if hasattr(model, "merge_and_unload"):
            model = model.merge_and_unload()
        model.save_pretrained(folder)
        processor.save_pretrained(folder)
    write_whole(folder / SIGHT, to_json(recipe_of(config.data).sight))
    return folder
