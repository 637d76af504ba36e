"""PhysX drives a case by its own reader of USD: python drive_ovphysx.py CASE; prints JSON."""

import json
import math
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import ovphysx
import ovstage
from ovphysx.samples.python_samples.schema_support import physx_schema_paths
from ovphysx.types import ObjectScope, SimObjectType

schemas = [*physx_schema_paths(), ovphysx.newton_schema_root()]


@contextmanager
def opened(file: str) -> Iterator[Any]:
    """The engine with a stage in it, populated at ordinal 1."""
    stage = ovstage.Stage(Path(file).stem)
    ovstage.population.open_usd(stage, file, ordinal=1, domains=ovstage.PopulationDomain.ALL)
    stage.advance_write_floor(ordinal=1).wait()
    physx = ovphysx.PhysX()
    physx.wait_task(physx.attach_ovstage(stage, read_ordinal=1))
    try:
        yield physx
    finally:
        physx.wait_task(physx.detach_ovstage())
        physx.destroy()
        stage.destroy()


def read(physx: Any, kind: Any, names: Sequence[str]) -> dict[str, dict[str, list[float]]]:
    """The values of some attributes of all prims of a kind, by name and path."""
    found: dict[str, dict[str, list[float]]] = {name: {} for name in names}
    with physx.read_sync(kind, list(names), scope=ObjectScope.ALL) as result:
        for group in result.groups:
            # Joints have a tensor each, bodies one for all.
            values = group.tensors if group.is_array else [row for tensor in group.tensors for row in tensor.numpy()]
            rows = found[result.dictionary.token_to_string(group.attribute)]
            for path, value in zip(result.dictionary.get_path_strings(group.prim_list), values, strict=True):
                rows[path] = np.array(value.numpy() if group.is_array else value, dtype=float).reshape(-1).tolist()
    return found


def main() -> None:
    case = json.loads(Path(sys.argv[1]).read_text())
    ovphysx.PhysX.set_cpu_mode(True)
    ovstage.population.register_usd_schemas([str(root) for root in schemas])
    step = case["timestep"]
    with opened(case["stage"]) as physx:
        begun = time.perf_counter()
        for _ in range(round(case["seconds"] / step)):
            physx.step_sync(step)
        took = time.perf_counter() - begun
        bodies: dict[str, dict[str, list[float]]] = {}
        for kind in (SimObjectType.RIGID_BODY, SimObjectType.ARTICULATION_LINK):
            for name, rows in read(physx, kind, ("position", "orientation", "mass")).items():
                bodies.setdefault(name, {}).update(rows)
    masses, poses = {}, {}
    for thing in case["things"]:
        prim = thing["prims"][0]
        if prim not in bodies["position"]:
            continue
        x, y, z, w = bodies["orientation"][prim]
        poses[thing["name"]] = [bodies["position"][prim], [w, x, y, z]]
        masses[thing["name"]] = sum(bodies["mass"][part][0] for part in thing["prims"])
    swings: dict[str, dict[str, list[float]]] = {}
    for thing in case["swinging"]:
        seen, steps = dict[str, list[float]](), 0
        with opened(thing["stage"]) as physx:
            for at in case["times"]:
                while steps * step < at - 1e-9:
                    physx.step_sync(step)
                    steps += 1
                now = read(physx, SimObjectType.ARTICULATION_JOINT, ("jointPosition",))["jointPosition"]
                for joint, prim in thing["joint_prims"].items():
                    opening = now[prim][0]
                    seen.setdefault(joint, []).append(opening if "drawer" in joint else math.radians(opening))
        swings[thing["asset"]] = seen
    print(json.dumps({"masses": masses, "poses": poses, "swings": swings, "took": took}))


main()
