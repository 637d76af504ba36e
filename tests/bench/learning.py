"""What learning costs: demonstrations per core and second, and rewards of a batch of rollouts.

python -m tests.bench.learning [--scenes N]
"""

import argparse
import os
import platform
import statistics
import tempfile
import time
from importlib.metadata import version
from pathlib import Path

from tests.bench.hull_rooms import step
from tests.bench.pool import cpu
from thinkblox.observe import Sight
from thinkblox.plan import Target
from thinkblox.sim.workers.pool import VerdictPool
from thinkblox.steps import write_step
from thinkblox.training.outcome import Asked, outcomes
from thinkblox.training.recipe import Recipe
from thinkblox.training.rewards import REWARDS
from thinkblox.training.shard import make_shard

OBJECTS, ROLLOUTS, GROUPS = 20, 8, 8


def demonstrations(scenes: int) -> None:
    """Make one shard, in this process."""
    sights = (Sight(size=112, views=1, words="compact"), Sight(size=168, views=1))
    for sight in sights:
        recipe = Recipe(scenes=scenes, block=scenes, seed=1, sight=sight)
        with tempfile.TemporaryDirectory() as folder:
            begun = time.process_time()
            count = make_shard(recipe, Path(folder), 0)
            spent = time.process_time() - begun
        steps = sum(count.demonstrations.values())
        rate = f"{steps / spent:.1f} per core second"
        print(
            f"{steps} demonstrations of {count.scenes} rooms, {sight.words} words, two views of {sight.size} px: {rate}"
        )


def rewards() -> None:
    """Measure and reward rollouts in rooms of many objects, by two workers."""
    asked = []
    for seed in range(GROUPS):
        found = step(OBJECTS, seed)
        category = found.asset.category
        target = Target(id=found.candidates[0].id, category=category, request=category)
        says = ("It goes here.", "There is room.")
        texts = [
            write_step(says, id=c.id, position=c.position, yaw=c.yaw, size=c.size) for c in found.candidates[:ROLLOUTS]
        ]
        asked.append((Asked(found.scene, target, found.asset), texts))
    with VerdictPool(workers=2) as pool:
        outcomes(pool, asked)
        walls, spent = [], []
        for _ in range(5):
            begun, used = time.perf_counter(), cpu(pool.pids)
            flat = [each for row in outcomes(pool, asked) for each in row]
            for reward in REWARDS.values():
                reward(outcome=flat)
            walls.append(time.perf_counter() - begun)
            spent.append(cpu(pool.pids) - used)
    print(
        f"{len(flat)} rollouts in rooms of {OBJECTS} objects, all rewards: {statistics.median(walls):.2f} s with two"
        f" workers, {statistics.median(spent):.2f} CPU s"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=16)
    arguments = parser.parse_args()
    demonstrations(arguments.scenes)
    rewards()
    print(
        f"python {platform.python_version()}, mujoco {version('mujoco')}, {platform.machine()}, {os.cpu_count()} cores"
    )


if __name__ == "__main__":
    main()
