"""Newton drives a case by its own reader of USD: python drive_newton.py CASE [SOLVER]; prints JSON."""

import json
import sys
import time
from contextlib import redirect_stdout
from pathlib import Path
from typing import Any

import newton
import newton.solvers
import warp as wp

SOLVER = sys.argv[2] if len(sys.argv) > 2 else "mujoco"


class Run:
    """A stage in the engine, and its state."""

    def __init__(self, file: str) -> None:
        builder = newton.ModelBuilder()
        newton.solvers.SolverMuJoCo.register_custom_attributes(builder)
        builder.add_usd(file, load_visual_shapes=False)
        self.model = builder.finalize(device="cpu")
        self.state, self._next, self._control = self.model.state(), self.model.state(), self.model.control()
        newton.eval_fk(self.model, self.model.joint_q, self.model.joint_qd, self.state)
        if SOLVER == "mujoco":
            self._solver: Any = newton.solvers.SolverMuJoCo(self.model, use_mujoco_cpu=True)
            self._pipeline = None
        else:
            self._solver = newton.solvers.SolverXPBD(self.model, iterations=20)
            self._pipeline = newton.CollisionPipeline(self.model)

    def step(self, seconds: float) -> None:
        self.state.clear_forces()
        contacts = None
        if self._pipeline is not None:
            contacts = self._pipeline.contacts()
            self._pipeline.collide(self.state, contacts)
        self._solver.step(self.state, self._next, self._control, contacts, seconds)
        self.state, self._next = self._next, self.state

    def openings(self) -> dict[str, float]:
        """How far joints are open, by the path of their prim [rad, m]."""
        if SOLVER != "mujoco":
            newton.eval_ik(self.model, self.state, self.state.joint_q, self.state.joint_qd)
        at, values = self.model.joint_q_start.numpy(), self.state.joint_q.numpy()
        return {label: float(values[at[n]]) for n, label in enumerate(self.model.joint_label)}


def main() -> dict[str, Any]:
    case = json.loads(Path(sys.argv[1]).read_text())
    step = case["timestep"]
    run = Run(case["stage"])
    begun = time.perf_counter()
    for _ in range(round(case["seconds"] / step)):
        run.step(step)
    took = time.perf_counter() - begun
    where = dict(zip(run.model.body_label, run.state.body_q.numpy().astype(float).tolist(), strict=True))
    weighs = dict(zip(run.model.body_label, run.model.body_mass.numpy().astype(float).tolist(), strict=True))
    masses, poses = {}, {}
    for thing in case["things"]:
        prim = thing["prims"][0]
        if prim not in where:
            continue
        px, py, pz, x, y, z, w = where[prim]
        poses[thing["name"]] = [[px, py, pz], [w, x, y, z]]
        masses[thing["name"]] = sum(weighs[part] for part in thing["prims"])
    swings: dict[str, dict[str, list[float]]] = {}
    for thing in case["swinging"]:
        seen, steps, run = dict[str, list[float]](), 0, Run(thing["stage"])
        for at in case["times"]:
            while steps * step < at - 1e-9:
                run.step(step)
                steps += 1
            now = run.openings()
            for joint, prim in thing["joint_prims"].items():
                seen.setdefault(joint, []).append(now[prim])
        swings[thing["asset"]] = seen
    return {"masses": masses, "poses": poses, "swings": swings, "took": took}


wp.config.quiet = True
with redirect_stdout(sys.stderr):
    told = main()
print(json.dumps(told))
