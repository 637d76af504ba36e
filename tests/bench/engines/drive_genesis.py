"""Genesis drives a case by its own reader of USD: python drive_genesis.py CASE; prints JSON."""

import json
import sys
import time
from collections.abc import Sequence
from contextlib import redirect_stdout
from pathlib import Path
from typing import Any

import genesis as gs


def built(file: str, gravity: Sequence[float], step: float) -> tuple[Any, dict[str, Any], dict[str, Any]]:
    """A scene from a stage, and its links and joints by their prims."""
    scene = gs.Scene(sim_options=gs.options.SimOptions(dt=step, gravity=tuple(gravity)), show_viewer=False)
    # The pieces are convex already.
    morph = gs.morphs.USD(file=file, decompose_object_error_threshold=float("inf"))
    entities = scene.add_stage(morph=morph, vis_mode="collision")
    scene.build()
    links = {link.name: link for entity in entities for link in entity.links}
    joints = {joint.name: (entity, joint) for entity in entities for joint in entity.joints}
    return scene, links, joints


def main() -> dict[str, Any]:
    case = json.loads(Path(sys.argv[1]).read_text())
    gs.init(backend=gs.cpu, logging_level="error", seed=0)
    step = case["timestep"]
    scene, links, _ = built(case["stage"], case["gravity"], step)
    scene.step()
    scene.reset()
    begun = time.perf_counter()
    for _ in range(round(case["seconds"] / step)):
        scene.step()
    took = time.perf_counter() - begun
    masses, poses = {}, {}
    for thing in case["things"]:
        link = links.get(thing["prims"][0])
        if link is None or not thing["free"]:
            continue
        poses[thing["name"]] = [link.get_pos().tolist(), link.get_quat().tolist()]
        masses[thing["name"]] = float(link.entity.get_mass())
    swings: dict[str, dict[str, list[float]]] = {}
    for thing in case["swinging"]:
        scene, _, joints = built(thing["stage"], case["tilted"], step)
        seen, steps = dict[str, list[float]](), 0
        for at in case["times"]:
            while steps * step < at - 1e-9:
                scene.step()
                steps += 1
            for joint, prim in thing["joint_prims"].items():
                entity, moved = joints[prim]
                seen.setdefault(joint, []).append(float(entity.get_dofs_position(moved.dofs_idx_local)[0]))
        swings[thing["asset"]] = seen
    return {"masses": masses, "poses": poses, "swings": swings, "took": took}


with redirect_stdout(sys.stderr):
    told = main()
print(json.dumps(told))
