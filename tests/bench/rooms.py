"""How well the main job is done: every prompt of prompts.txt, several seeds, re-read by plain MuJoCo.

python -m tests.bench.rooms [--seeds N] [--prompts FILE] [--fill named|essentials|lived-in] [--save DIR]
"""

import argparse
import os
import platform
import sys
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import get_args

from thinkblox.errors import InputError
from thinkblox.fills import Fill

PROMPTS = Path(__file__).with_name("prompts.txt")


@dataclass(frozen=True)
class Row:
    """What one prompt and seed gave; lengths in mm, angles in degrees."""

    prompt: str
    seed: int
    seconds: float
    asked: int
    placed: int
    listed: bool
    objects: int
    relations: int
    hold: int
    valid: bool
    depth: float
    drift: float
    tilt: float
    faults: tuple[str, ...]


def run(job: tuple[str, int, Fill, Path]) -> Row | str:
    """Generate, write without pictures, and read the files back."""
    prompt, seed, fill, out = job
    from thinkblox.generate import generate_room
    from thinkblox.saving import save_room

    start = time.perf_counter()
    try:
        result = generate_room(prompt, seed=seed, fill=fill)
    except InputError as error:
        return f"{prompt[:50]}: {error}"
    save_room(result, out, pictures=False, overwrite=True)
    seconds = time.perf_counter() - start
    asked = [t for t in result.plan.targets if t.asked]
    missing = len(result.plan.brief.missing) + len(result.plan.brief.beyond)
    placed = [t for t in asked if t.id in result.scene]
    absent = {a.id for a in result.report.absent}
    depth, drift, tilt = hold(out / "scene.xml")
    faults = [f"absent {a.id}: {a.reason}" for a in result.report.absent]
    faults += [str(v) for v in result.report.objects if not v.valid]
    faults += [f"{r.subject} {r.kind} {r.anchors}: {r.measured}" for r in result.report.relations if not r.holds]
    if result.report.walker is not None:
        faults += [f"unreachable {id}" for id in result.report.walker.unreachable]
    return Row(
        prompt,
        seed,
        seconds,
        len(asked) + missing,
        len(placed),
        all(t.id in result.scene or t.id in absent for t in result.plan.targets),
        len(result.scene.placements),
        len(result.report.relations),
        sum(r.holds for r in result.report.relations),
        result.report.valid,
        depth,
        drift,
        tilt,
        tuple(faults),
    )


def hold(path: Path, *, seconds: float = 5.0) -> tuple[float, float, float]:
    """Plain MuJoCo on the written file: deepest contact [mm], largest motion [mm] and turn [degrees] of any body."""
    import mujoco
    import numpy as np

    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    mujoco.mj_forward(model, data)
    depth = max([0.0, *(-data.contact.dist)]) * 1000.0
    free = [j for j in range(model.njnt) if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE]
    bodies = [int(model.jnt_bodyid[j]) for j in free]
    if not bodies:
        return depth, 0.0, 0.0
    before, turned = data.xpos[bodies].copy(), data.xquat[bodies].copy()
    for _ in range(round(seconds / model.opt.timestep)):
        mujoco.mj_step(model, data)
    drift = np.linalg.norm(data.xpos[bodies] - before, axis=1).max() * 1000.0
    cosine = np.clip(np.abs((data.xquat[bodies] * turned).sum(1)), 0.0, 1.0)
    return depth, float(drift), float(np.degrees(2 * np.arccos(cosine)).max())


def main() -> int:
    """Print a row for every prompt, the totals, and every fault."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--prompts", type=Path, default=PROMPTS)
    parser.add_argument("--fill", choices=get_args(Fill), default="essentials")
    parser.add_argument("--save", type=Path)
    parser.add_argument("--workers", type=int, default=2)
    arguments = parser.parse_args()
    prompts = [line for line in arguments.prompts.read_text().splitlines() if line.strip()]
    with tempfile.TemporaryDirectory() as scratch:
        home = arguments.save or Path(scratch)
        home.mkdir(parents=True, exist_ok=True)
        seeds, fill = range(arguments.seeds), arguments.fill
        jobs = [(p, s, fill, home / f"{n:02d}-{s}") for n, p in enumerate(prompts, 1) for s in seeds]
        with ProcessPoolExecutor(arguments.workers) as pool:
            results = list(pool.map(run, jobs))
    for result in results:
        if isinstance(result, str):
            print(f"REFUSED {result}")
    report([result for result in results if isinstance(result, Row)])
    return 0


def report(rows: list[Row]) -> None:
    """Print the table."""
    print(f"{'prompt':42} seed  placed  objects  relations  depth mm  drift mm  tilt deg  valid     s")
    for r in rows:
        relations = f"{r.hold}/{r.relations}"
        print(
            f"{r.prompt[:42]:42} {r.seed:4d} {r.placed:3d}/{r.asked:<3d} {r.objects:8d} {relations:>9}  {r.depth:8.3f}"
            f"  {r.drift:8.3f}  {r.tilt:8.3f}  {'yes' if r.valid else 'NO':>5} {r.seconds:5.2f}"
        )
        for fault in r.faults:
            print(f"      {fault}")
    asked, placed = sum(r.asked for r in rows), sum(r.placed for r in rows)
    named, found = sum(r.relations for r in rows), sum(r.hold for r in rows)
    print(f"placed {placed} of {asked} asked for ({placed / max(1, asked):.1%})")
    print(f"every target placed or listed with a reason: {all(r.listed for r in rows)}")
    print(f"relations {found} of {named} ({found / max(1, named):.1%})")
    worst = [max(getattr(r, name) for r in rows) for name in ("depth", "drift", "tilt")]
    print("deepest contact {:.3f} mm; largest motion in 5 s {:.3f} mm, {:.3f} degrees".format(*worst))
    print(f"valid {sum(r.valid for r in rows)} of {len(rows)} rooms")
    objects = sorted(r.objects for r in rows)
    print(f"objects a room: {objects[0]} to {objects[-1]}, median {objects[len(objects) // 2]}")
    seconds = sorted(r.seconds for r in rows)
    print(f"seconds a room: median {seconds[len(seconds) // 2]:.2f}, longest {seconds[-1]:.2f}")
    print(
        f"python {platform.python_version()}, mujoco {version('mujoco')}, {platform.machine()}, {os.cpu_count()} cores"
    )


if __name__ == "__main__":
    sys.exit(main())
