"""What a verdict costs: CPU time from a Scene to eight verdicts, cut down, and with the whole room built.

python -m tests.bench.verdicts [--scenes N]

Beside the times stands what no machine changes: how much is built and stepped, and what the caches spare.
"""

import argparse
import platform
import statistics
import time
from collections import Counter
from collections.abc import Callable
from importlib.metadata import version
from unittest import mock

import mujoco

from tests.bench.hull_rooms import Step, step
from tests.whole_room import whole_room
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.geometry import solid
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict import world
from thinkblox.sim.verdict.stage import Settled, Stage
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


class CountedStage(Stage):
    """A stage that counts what it builds and steps."""

    counts: Counter[str] = Counter()

    def __init__(self, spec: mujoco.MjSpec, physics: Physics) -> None:
        super().__init__(spec, physics)
        self.counts.update(worlds=1, bodies=self._model.nbody - 1, geoms=self._model.ngeom)

    def settle(self, id: str, placement: Placement, *, seconds: float) -> Settled:
        settled = super().settle(id, placement, seconds=seconds)
        self.counts.update(settles=1, steps=round(self._data.time / self._model.opt.timestep))
        return settled


def counted(cases: list[Step]) -> str:
    """What checking these builds and steps, per prompt, and what its caches spare."""
    CountedStage.counts.clear()
    with mock.patch.object(world, "Stage", CountedStage), mock.patch.object(solid, "Solid", wraps=solid.Solid) as made:
        for case in cases:
            World(case.scene).check(case.candidates, case.asset)
    each = {name: count / len(cases) for name, count in CountedStage.counts.items()}
    cells = "".join(f"{each[name]:9.1f}" for name in ("worlds", "bodies", "geoms", "settles", "steps"))
    return f"{cells}{each['settles'] - each['worlds']:9.1f}{made.call_count / len(cases):9.1f}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=24)
    scenes = parser.parse_args().scenes
    print(f"8 candidates, 4 valid and 4 not, objects of 8 convex meshes; medians over {scenes} scenes [ms of CPU time]")
    print("objects  first sight  known assets  whole room anew  ratio")
    known, counts = {}, {}
    cpu(World, step(10, 10**6))
    for size in SIZES:
        cases = [step(size, seed) for seed in range(scenes)]
        first = statistics.median(cpu(World, case) for case in cases)
        known[size] = statistics.median(cpu(World, case) for case in cases)
        counts[size] = counted(cases)
        whole = statistics.median(cpu(whole_room, case) for case in cases)
        print(f"{size:7d}  {first:11.1f}  {known[size]:12.1f}  {whole:15.1f}  {whole / known[size]:5.1f}")
    print("objects   worlds   bodies    geoms  settles    steps   reused   solids   [each prompt, on any machine]")
    for size, line in counts.items():
        print(f"{size:7d}{line}")
    print(f"growth from 50 to 200 objects: x{known[200] / known[50]:.2f}")
    print(f"python {platform.python_version()}, mujoco {version('mujoco')}, {platform.machine()}")


if __name__ == "__main__":
    main()
