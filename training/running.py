"""What the trainers share: their arguments, and going on from the last checkpoint."""

from pathlib import Path
from typing import Any

from thinkblox.errors import InputError
from thinkblox.policies.hf import SIGHT
from thinkblox.training.config import Training
from thinkblox.training.models import MODEL
from thinkblox.value import to_json
from thinkblox.whole_file import write_whole

CONFIG = "config.json"


def common_arguments(config: Training) -> dict[str, Any]:
    """The arguments of a trainer of TRL that both kinds of training share."""
    import torch

    return {
        "output_dir": config.out,
        "seed": config.seed,
        "max_steps": config.steps,
        "per_device_train_batch_size": config.batch,
        "gradient_accumulation_steps": config.accumulate,
        "learning_rate": config.learning_rate,
        "lr_scheduler_type": "cosine",
        "warmup_steps": config.warmup,
        "save_steps": config.save,
        "save_total_limit": 2,
        "logging_steps": config.log,
        "bf16": torch.cuda.is_available(),
        "gradient_checkpointing": config.lora is not None,
        "dataloader_pin_memory": torch.cuda.is_available(),
        "dataloader_num_workers": config.workers,
        "report_to": [],
        "remove_unused_columns": False,
        "disable_tqdm": True,
    }


def resuming(trainer_class: Any) -> Any:
    """A trainer of that class that reads whole models back as they were saved.

    transformers writes the weights of some models under other names than they have in memory, and a checkpoint of them
    is read without changing the names back: nothing would be loaded, with a warning alone.
    """

    class ResumingTrainer(trainer_class):  # type: ignore[misc]
        def _load_from_checkpoint(self, resume_from_checkpoint: str, model: Any = None) -> None:
            model = model or self.model
            if hasattr(model, "peft_config"):
                super()._load_from_checkpoint(resume_from_checkpoint, model)
                return
            read = type(model).from_pretrained(resume_from_checkpoint, dtype=model.dtype)
            model.load_state_dict(read.state_dict())

    return ResumingTrainer


def finished(config: Training) -> Path | None:
    """The folder of the trained model, where this very run came to its end; None where there is something to do.

    Raises:
        InputError: the folder holds a run of another configuration.
    """
    last = _last_checkpoint(config)
    model = Path(config.out) / MODEL
    return model if last is not None and _step(last) >= config.steps and (model / SIGHT).is_file() else None


def run(trainer: Any, config: Training) -> None:
    """Train to the end, from the last checkpoint of the same configuration where there is one; keep the log.

    Raises:
        InputError: the folder holds a run of another configuration.
    """
    out, last = Path(config.out), _last_checkpoint(config)
    if last is not None and _step(last) >= config.steps:
        _take_up(trainer, last)
    else:
        if trainer.accelerator.is_main_process:
            out.mkdir(parents=True, exist_ok=True)
            write_whole(out / CONFIG, to_json(config))
        trainer.train(resume_from_checkpoint=None if last is None else str(last))
    trainer.save_state()


def _last_checkpoint(config: Training) -> Path | None:
    from transformers.trainer_utils import get_last_checkpoint

    out = Path(config.out)
    last = get_last_checkpoint(str(out)) if out.is_dir() else None
    file = out / CONFIG
    if last is not None and (not file.is_file() or file.read_bytes() != to_json(config)):
        raise InputError(f"{out}: holds checkpoints of another configuration; choose another folder for this run")
    return None if last is None else Path(last)


def _step(checkpoint: Path) -> int:
    return int(checkpoint.name.rpartition("-")[2])


def _take_up(trainer: Any, checkpoint: Path) -> None:
    """The weights and the log of the last update: a trainer that goes on from there would make another one."""
    from transformers import TrainerState

    trainer._load_from_checkpoint(str(checkpoint))
    trainer.state = TrainerState.load_from_json(str(checkpoint / "trainer_state.json"))
