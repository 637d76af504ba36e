"""Robots in rooms: random actions without a warning, what the scripts solve, and the picture of docs/environment.md.

python -m tests.bench.robots ROOMS [--steps N]
python -m tests.bench.robots --picture FILE
"""

import argparse
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from thinkblox.errors import InputError
from thinkblox.generate import generate_room
from thinkblox.scene.scene import Scene
from thinkblox.sim.environment import (
    Pictures,
    RandomPolicy,
    ScriptedCarry,
    ScriptedDrive,
    ScriptedOpen,
    ScriptedReach,
    make_environment,
    opened,
    rooms_of,
    run_episode,
)
from thinkblox.sim.environment.asking_for import moving, small_things, things
from thinkblox.sim.environment.pictures import Picturing

SHOWN = "A bedroom, 4 m by 4.5 m, with a double bed, two nightstands with a lamp on each, and a wardrobe."
TASKS = (("drive", "base"), ("reach", "jaco"), ("open", "picker"), ("carry", "picker"))
SEED = 1


def random_actions(scene: Scene, task: Any, robot: str, steps: int) -> tuple[float, int]:
    """Control steps a second, and warnings of the engine."""
    environment = make_environment(scene, task, robot=robot, seed=SEED, time_limit=1e6)
    policy, told = RandomPolicy(environment, seed=SEED), environment.reset()
    begun = time.process_time()
    warned = 0
    for _ in range(steps):
        told = environment.step(policy(told))
        warned += int(sum(warning.number for warning in environment.physics.data.ptr.warning))
    return steps / (time.process_time() - begun), warned


def scripted(scene: Scene) -> "Counter[str]":
    """What becomes of driving to and reaching everything, of opening everything, and of carrying what is small."""
    room = opened(rooms_of(scene)[0])
    found: Counter[str] = Counter()
    for task, targets, script in (
        ("drive", things(room), ScriptedDrive),
        ("reach", things(room), ScriptedReach),
        ("open", moving(room), ScriptedOpen),
        ("carry", small_things(room), ScriptedCarry),
    ):
        for target in targets:
            try:
                environment = make_environment(scene, task, target, seed=SEED)  # type: ignore[arg-type]
                done = "reached" if run_episode(environment, script(environment)).reached else "missed"
            except InputError:
                done = "no place"
            found[f"{task} {done}"] += 1
            if done == "missed":
                print(f"  missed: {task} {target}")
    return found


def picture(seed: int = 2) -> Image.Image:
    """What the robot's camera sees at first, which object is where in that, and how it opens a door then."""
    scene = generate_room(SHOWN).scene
    environment = make_environment(scene, "open", "wardrobe_1", seed=seed)
    policy, told = ScriptedOpen(environment), environment.reset()
    errand = environment.task.errand
    draws = Picturing(environment.physics, errand.index, Pictures(size=(360, 480)))
    ahead, labels = draws.draw("eye", "rgb"), draws.draw("eye", "segmentation")
    while environment.task.goal.share < 0.45 and not told.last():
        told = environment.step(policy(told))
    colours = np.vstack([np.random.default_rng(4).integers(40, 230, (len(draws.labels), 3)), [[20, 20, 20]]])
    corners = [f"corner_{number}" for number in range(1, 5)]
    robots = [(draws.draw(corner, "segmentation") == len(draws.labels) - 1).sum() for corner in corners]
    seen = [ahead, colours[labels], draws.draw(corners[int(np.argmax(robots))], "rgb")]
    return Image.fromarray(np.hstack(seen).astype(np.uint8))


def main() -> int:
    """Print a line for each room and task."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rooms", nargs="*")
    parser.add_argument("--steps", type=int, default=1000)
    parser.add_argument("--picture", type=Path)
    arguments = parser.parse_args()
    if arguments.picture is not None:
        picture().save(arguments.picture, optimize=True)
    total: Counter[str] = Counter()
    for source in (source for room in arguments.rooms for source in rooms_of(room)):
        scene = source.load()
        for task, robot in TASKS:
            try:
                fast, warned = random_actions(scene, task, robot, arguments.steps)
                print(f"{source.name} {task} {robot}: {fast:.0f} steps/s, {warned} warnings", flush=True)
                total["warnings"] += warned
                total["random actions"] += arguments.steps
            except InputError as error:
                print(f"{source.name} {task} {robot}: {error}", flush=True)
        total += scripted(scene)
        print(f"{source.name}: so far {dict(total)}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
