"""Supervised fine-tuning on demonstrations: python -m thinkblox.training.sft CONFIG."""

import sys
from pathlib import Path
from typing import Any

from thinkblox.training.config import SftConfig, section
from thinkblox.training.models import adapter_for, save_trained, starting_model
from thinkblox.training.rows import rows_of
from thinkblox.training.running import common_arguments, resuming, run


def train_sft(config: SftConfig) -> Path:
    """Train a model to say what the demonstrations say; goes on from the last checkpoint in `config.out`.

    Returns:
        The folder of the trained model, which `hf:` loads.

    Raises:
        InputError: the configuration, the dataset or the model cannot be used; said before anything is trained.
    """
    rows = rows_of(config.data, "train")
    start = starting_model(config)
    trainer = _trainer(config, start.model, start.processor, rows)
    run(trainer, config)
    return save_trained(trainer.accelerator.unwrap_model(trainer.model), start.processor, config)


def _trainer(config: SftConfig, model: Any, processor: Any, rows: Any) -> Any:
    from trl import SFTConfig, SFTTrainer

    arguments = SFTConfig(
        **common_arguments(config),
        weight_decay=config.weight_decay,
        max_length=None,
        completion_only_loss=config.loss == "completion",
        train_sampling_strategy="group_by_length",
    )
    return resuming(SFTTrainer)(
        model=model,
        args=arguments,
        train_dataset=_with_lengths(rows.select_columns(["prompt", "completion", "images"])),
        processing_class=processor,
        peft_config=adapter_for(config.lora),
    )


def _with_lengths(rows: Any) -> Any:
    """Rows with how long each is in characters: those of one batch are about as long, so that little is padded."""
    lengths = [
        sum(len(block["text"] or "") for message in (*prompt, *completion) for block in message["content"])
        for prompt, completion in zip(rows["prompt"], rows["completion"], strict=True)
    ]
    return rows.add_column("length", lengths)


if __name__ == "__main__":
    print(train_sft(section(sys.argv[1], "sft")))  # noqa: T201
