"""What a verdict costs: CPU time from a Scene to eight verdicts, cut down, and with the whole room built.

python -m tests.bench.verdicts [--scenes N]
"""

import argparse
import platform
import statistics
import time
from collections.abc import Callable
from importlib.metadata import version

from tests.bench.hull_rooms import Step, step
from tests.whole_room import whole_room
from thinkblox.scene.scene import Scene
from thinkblox.sim.verdict.world import World

SIZES = (10, 50, 200)
EXPECTED = [True] * 4 + [False] * 4


def cpu(make: Callable[[Scene], World], case: Step) -> float:
    """CPU time of one prompt [ms]; the verdicts must be those that the room was made for."""
    start = time.process_time()
    verdicts = make(case.scene).check(case.candidates, case.asset)
    taken = time.process_time() - start
    if [verdict.valid for verdict in verdicts] != EXPECTED:
        raise SystemExit(f"seed {case.scene.seed}: {[str(verdict) for verdict in verdicts]}")
    return 1000 * taken


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=24)
    scenes = parser.parse_args().scenes
    print(f"8 candidates, 4 valid and 4 not, objects of 8 convex meshes; medians over {scenes} scenes [ms of CPU time]")
    print("objects  first sight  known assets  whole room anew  ratio")
    known = {}
    cpu(World, step(10, 10**6))
    for size in SIZES:
        cases = [step(size, seed) for seed in range(scenes)]
        first = statistics.median(cpu(World, case) for case in cases)
        known[size] = statistics.median(cpu(World, case) for case in cases)
        whole = statistics.median(cpu(whole_room, case) for case in cases)
        print(f"{size:7d}  {first:11.1f}  {known[size]:12.1f}  {whole:15.1f}  {whole / known[size]:5.1f}")
    print(f"growth from 50 to 200 objects: x{known[200] / known[50]:.2f}")
    print(f"python {platform.python_version()}, mujoco {version('mujoco')}, {platform.machine()}")


if __name__ == "__main__":
    main()
