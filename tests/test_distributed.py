"""Two processes, each with its own rollouts, get the advantages that one process with all of them gets."""

import json
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from tests.two_processes import GROUP, TIERS, WEIGHTS, rewards
from thinkblox.training.advantages import tiered_advantages
from thinkblox.training.gdpo import own_share

ROOT = Path(__file__).parent.parent


def together(world: int, folder: Path) -> list[list[list[float]]]:
    with socket.socket() as line:
        line.bind(("127.0.0.1", 0))
        port = line.getsockname()[1]
    outs = [folder / f"{world}-{rank}.json" for rank in range(world)]
    command = [sys.executable, "-m", "tests.two_processes"]
    running = [
        subprocess.Popen([*command, str(rank), str(world), str(port), str(out)], cwd=ROOT, stderr=subprocess.PIPE)
        for rank, out in enumerate(outs)
    ]
    said = [process.communicate(timeout=240)[1].decode() for process in running]
    assert [process.returncode for process in running] == [0] * world, said
    return [json.loads(out.read_text()) for out in outs]


@pytest.mark.slow
def test_two_gloo_processes_give_the_advantages_of_one(tmp_path: Path) -> None:
    pytest.importorskip("trl")
    ((alone, logged),) = together(1, tmp_path)
    (first, first_logged), (second, second_logged) = together(2, tmp_path)
    assert len(first) == len(second) == len(alone) // 2
    assert len(first) % GROUP, "a group is split between the processes"
    assert first + second == alone
    assert first_logged == second_logged == logged
    expected = tiered_advantages(rewards(), list(TIERS.values()), WEIGHTS, GROUP).total
    assert alone == pytest.approx(expected, abs=1e-6)


def test_each_process_keeps_its_own_share() -> None:
    total = tiered_advantages(rewards(), list(TIERS.values()), WEIGHTS, GROUP).total
    parts = [own_share(total, len(total) // 4, rank) for rank in range(4)]
    assert [value for part in parts for value in part] == total.tolist()
