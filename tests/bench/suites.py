"""How long the suites of published criteria take on a room of 60 objects with doors and drawers, in CPU time.

python -m tests.bench.suites [--rooms N] [--objects N] [--suites molmospaces,sceneeval]
"""

import argparse
import os
import platform
import statistics
import time
from importlib.metadata import version

import numpy as np

from thinkblox.assets import make_asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.sim.subject import subject_of
from thinkblox.sim.suites import SUITES, run_suite
from thinkblox.suite import SuiteResult

JOINTED = ("wardrobe", "dresser", "cabinet", "sideboard", "nightstand", "fridge", "filing_cabinet", "desk")
PLAIN = ("bed", "armchair", "chair", "sofa", "bookcase", "stool", "office_chair", "bench")
TABLES = ("table", "dining_table", "console_table", "workbench", "display_table", "coffee_table")
SMALL = ("vase", "bowl", "book", "book_stack", "bottle", "cup", "table_lamp", "plate", "toaster", "laptop", "basket")
PITCH = 3.2
"""From one piece of furniture to the next [m]."""


def room(objects: int, seed: int) -> Scene:
    """A third with doors and drawers, a sixth plain, a sixth tables and a third on the tables, drawn from a seed."""
    rng = np.random.default_rng(seed)
    count = objects // 6
    kinds = [*_drawn(JOINTED, 2 * count, rng), *_drawn(PLAIN, count, rng), *_drawn(TABLES, count, rng)]
    columns = int(np.ceil(np.sqrt(len(kinds))))
    side = columns * PITCH
    door = Opening(id="door_1", kind="door", wall=0, offset=0.5, width=0.9, height=2.05)
    scene = Scene(room=rectangle(side, side, openings=(door,)), seed=seed)
    for number, kind in enumerate(kinds):
        x, y = (number % columns + 0.5) * PITCH, (number // columns + 0.5) * PITCH
        scene = _with(scene, kind, number, (x, y, 0.0), float(rng.integers(4)) * 90.0, "floor", seed)
    carriers = scene.placements[-count:]
    for number in range(objects - len(kinds)):
        carrier = carriers[number % count]
        surface = scene.asset_of(carrier).surfaces[0]
        along = surface.position[1] + surface.size[1] * (0.25 if number // count % 2 else -0.25)
        x, y = carrier.to_room((surface.position[0], along))
        height = carrier.position[2] + surface.position[2]
        scene = _with(scene, str(rng.choice(SMALL)), len(kinds) + number, (x, y, height), carrier.yaw, carrier.id, seed)
    return scene


def _drawn(kinds: tuple[str, ...], count: int, rng: np.random.Generator) -> list[str]:
    return [str(kind) for kind in rng.choice(kinds, count)]


def _with(
    scene: Scene, kind: str, number: int, position: tuple[float, float, float], yaw: float, on: str, seed: int
) -> Scene:
    asset = make_asset(kind, seed=seed + number)
    placement = Placement(
        id=f"{kind}_{number}", category=kind, asset=asset.id, position=position, yaw=yaw, size=asset.size, support=on
    )
    return scene.with_placement(placement, asset)


def measured(name: str, scene: Scene) -> tuple[float, float, SuiteResult]:
    """CPU seconds of building the model and of the suite, and the suite's result."""
    before = time.process_time()
    subject = subject_of(scene)
    built = time.process_time()
    result = run_suite(name, subject)
    return built - before, time.process_time() - built, result


def main() -> int:
    """Print a line for each suite: CPU seconds by room, and which criteria failed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rooms", type=int, default=5)
    parser.add_argument("--objects", type=int, default=60)
    parser.add_argument("--suites", default=",".join(SUITES))
    arguments = parser.parse_args()
    scenes = [room(arguments.objects, seed) for seed in range(arguments.rooms)]
    models = [subject_of(scene).model for scene in scenes]
    joints = statistics.median(sum(m.jnt_type >= 2) for m in models)
    geoms = statistics.median(m.ngeom for m in models)
    print(f"{len(scenes)} rooms of {arguments.objects} objects; median {joints} hinges and slides, {geoms} geoms")
    print(f"{'suite':14} {'median s':>9} {'worst s':>9} {'build s':>9}  rooms passed; criteria that failed")
    for name in arguments.suites.split(","):
        runs = [measured(name, scene) for scene in scenes]
        seconds = [run[1] for run in runs]
        failed = sorted({c.name for run in runs for c in run[2].criteria if c.passed is False})
        print(
            f"{name:14} {statistics.median(seconds):9.2f} {max(seconds):9.2f}"
            f" {statistics.median(run[0] for run in runs):9.2f}"
            f"  {sum(run[2].passed for run in runs)}; {', '.join(failed) or 'none'}"
        )
    print(
        f"CPU time; python {platform.python_version()}, mujoco {version('mujoco')}, python-fcl {version('python-fcl')},"
        f" {platform.machine()}, {os.cpu_count()} cores"
    )
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
