"""One process of several that train together, without a model: what TRL gathers, and what each keeps of it.

python -m tests.two_processes RANK WORLD PORT OUT. The rewards of all are in `REWARDS`; each process has its own share.
"""

import json
import os
import sys
from collections import defaultdict, deque
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

GROUP = 4
TIERS = {"hard": [0, 1], "soft": [2]}
WEIGHTS = [1.0, 0.5]


def rewards() -> "np.ndarray[Any, Any]":
    """Three groups of four rollouts, of which two processes have six each: the one in the middle is split."""
    table = np.random.default_rng(3).normal(size=(3 * GROUP, 3)).round(2)
    table[2, 2] = np.nan
    return table


def advantages(rank: int, world: int) -> list[list[float]]:
    """What the trainer of this process keeps, and what it logs for all."""
    import torch
    from accelerate import Accelerator
    from trl import GRPOTrainer

    from thinkblox.training.gdpo import _tiered_trainer

    table = rewards()
    count = len(table) // world
    mine = table[rank * count : (rank + 1) * count]

    def generated(self: Any, inputs: Any) -> Any:
        texts = [[{"role": "assistant", "content": "text"}]] * len(inputs)
        gathered = self._calculate_rewards(inputs, ["prompt"] * len(inputs), texts, [[0]] * len(inputs))
        self._logs["advantages"].extend([0.0] * len(gathered))
        return {"advantages": torch.zeros(len(inputs))}

    GRPOTrainer._generate_and_score_completions = generated
    trainer = object.__new__(_tiered_trainer())
    columns = [lambda outcome, column=column, **_: [row[column] for row in outcome] for column in range(3)]
    names = ["format", "coll", "align"]
    trainer.__dict__.update(
        accelerator=Accelerator(cpu=True),
        args=SimpleNamespace(report_to=[]),
        environments=None,
        measure=lambda at, texts: [[float(value) for value in row] for row in mine],
        model=SimpleNamespace(training=True),
        num_generations=GROUP,
        reward_funcs=columns,
        reward_func_names=names,
        reward_processing_classes=[None] * 3,
        state=SimpleNamespace(global_step=0),
        tiers=TIERS,
        tier_weights=WEIGHTS,
        _log_shares=lambda found: None,
        _logs={"advantages": deque(maxlen=len(table))},
        _metrics={"train": defaultdict(list)},
        _pending_extra_logs=defaultdict(list),
        _pending_metrics=defaultdict(list),
    )
    output = trainer._generate_and_score_completions([{"at": str(number)} for number in range(count)])
    return [output["advantages"].tolist(), list(trainer._logs["advantages"])]


def main() -> None:
    rank, world, port, out = sys.argv[1:]
    told = {"RANK": rank, "LOCAL_RANK": rank, "WORLD_SIZE": world, "MASTER_ADDR": "127.0.0.1", "MASTER_PORT": port}
    os.environ.update(told | {"ACCELERATE_USE_CPU": "true", "OMP_NUM_THREADS": "1"})
    import torch.distributed

    if int(world) > 1:
        torch.distributed.init_process_group("gloo")
    Path(out).write_text(json.dumps(advantages(int(rank), int(world))))
    if int(world) > 1:
        torch.distributed.destroy_process_group()


if __name__ == "__main__":
    main()
