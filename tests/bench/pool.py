"""Verdicts of the pool per CPU second, and what a second worker brings.

python -m tests.bench.pool [--scenes N] [--rounds N]
"""

import argparse
import os
import platform
import time
from importlib.metadata import version
from pathlib import Path

from tests.bench.hull_rooms import step
from thinkblox.sim.workers.pool import Job, VerdictPool

OBJECTS = 50


def jobs(scenes: int, start: int = 0) -> list[Job]:
    """One prompt of eight candidates for each scene, four valid and four not."""
    cases = [step(OBJECTS, seed) for seed in range(start, start + scenes)]
    return [Job(case.scene, case.asset, case.candidates) for case in cases]


def cpu(pids: tuple[int, ...]) -> float:
    """CPU time of this process and of others so far [s]; Linux only."""
    tick = os.sysconf("SC_CLK_TCK")
    fields = [Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split() for pid in pids]
    return time.process_time() + sum(int(f[11]) + int(f[12]) for f in fields) / tick


def run(workers: int, work: list[Job], rounds: int) -> tuple[float, float]:
    """Verdicts per second of wall time and of CPU time, once the workers are warm."""
    with VerdictPool(workers=workers) as pool:
        pool.check(jobs(2 * workers, start=10**6))
        begun, used = time.perf_counter(), cpu(pool.pids)
        for _ in range(rounds):
            pool.check(work)
        wall, spent = time.perf_counter() - begun, cpu(pool.pids) - used
    verdicts = rounds * sum(len(job.candidates) for job in work)
    return verdicts / wall, verdicts / spent


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=24)
    parser.add_argument("--rounds", type=int, default=3)
    arguments = parser.parse_args()
    work = jobs(arguments.scenes)
    print(f"{arguments.scenes} scenes of {OBJECTS} objects of 8 convex meshes, 8 candidates each, x{arguments.rounds}")
    print("workers  verdicts/s  verdicts/CPU s")
    rates = {}
    for workers in (1, 2):
        rates[workers], each = run(workers, work, arguments.rounds)
        print(f"{workers:7d}  {rates[workers]:10.0f}  {each:14.0f}")
    print(f"two workers against one: x{rates[2] / rates[1]:.2f}")
    print(
        f"python {platform.python_version()}, mujoco {version('mujoco')}, {platform.machine()}, {os.cpu_count()} cores"
    )


if __name__ == "__main__":
    main()
