"""Supervised fine-tuning on demonstrations: python -m thinkblox.training.sft CONFIG."""

import sys
from pathlib import Path
from typing import Any

from thinkblox.training.config import SftConfig, section
from thinkblox.training.models import adapter_for, save_trained, starting_model
from thinkblox.training.rows import rows_of
from thinkblox.training.running import common_arguments, finished, resuming, run


def train_sft(config: SftConfig) -> Path:
    """Train a model to say what the demonstrations say; goes on from the last checkpoint in `config.out`.

    Where the last update is done and the model written, nothing is done.

    Returns:
        The folder of the trained model, which `hf:` loads.

    Raises:
        InputError: the configuration, the dataset or the model cannot be used; said before anything is trained.
    """
    if (done := finished(config)) is not None:
        return done
    rows = rows_of(config.data, "train")
    start = starting_model(config)
    trainer = sft_trainer(config, start.model, start.processor, rows)
    run(trainer, config)
    return save_trained(trainer.accelerator.unwrap_model(trainer.model), start.processor, config)


def sft_trainer(config: SftConfig, model: Any, processor: Any, rows: Any) -> Any:
    """An SFTTrainer of TRL for rows of a dataset."""
    from trl import SFTConfig, SFTTrainer

    arguments = SFTConfig(
        **common_arguments(config),
        weight_decay=config.weight_decay,
        max_length=None,
        completion_only_loss=True,
        train_sampling_strategy="group_by_length",
    )
    trainer = resuming(SFTTrainer)(
        model=model,
        args=arguments,
        train_dataset=_with_lengths(rows.select_columns(["prompt", "completion", "images"])),
        processing_class=processor,
        peft_config=adapter_for(config.lora),
    )
    if config.reading:
        trainer.add_callback(_reading_first(trainer.data_collator, config.reading))
    return trainer


def _reading_first(collator: Any, steps: int) -> Any:
    """Sets what the loss is on by the number of updates that are done."""
    from transformers import TrainerCallback

    class ReadingFirst(TrainerCallback):  # type: ignore[misc]
        def on_train_begin(self, args: Any, state: Any, control: Any, **_: Any) -> None:
            collator.completion_only_loss = state.global_step >= steps

        def on_step_end(self, args: Any, state: Any, control: Any, **_: Any) -> None:
            # The batch of the next update is made already.
            collator.completion_only_loss = state.global_step >= steps - 1

    return ReadingFirst()


def _with_lengths(rows: Any) -> Any:
    """Rows with how long each is in characters: those of one batch are about as long, so that little is padded."""
    lengths = [
        sum(len(block["text"] or "") for message in (*prompt, *completion) for block in message["content"])
        for prompt, completion in zip(rows["prompt"], rows["completion"], strict=True)
    ]
    return rows.add_column("length", lengths)


if __name__ == "__main__":
    print(train_sft(section(sys.argv[1], "sft")))  # noqa: T201
