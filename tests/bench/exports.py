"""How long exporting takes, and how fast the exported model runs: `python -m tests.bench.exports [SCENE...]`.

Without scenes, 50 objects of 20 assets stand in rows; with scenes (folders or scene.json), those.
"""

import sys
import time
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import mujoco

from tests.sim_rooms import put
from thinkblox.assets import make_asset
from thinkblox.exporters.formats import formats_named
from thinkblox.exporters.stocktaking import inventory_of
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene, load_scene
from thinkblox.sim.verdict.settle import settle

KINDS = (
    "bed", "wardrobe", "nightstand", "desk", "chair", "sofa", "armchair", "bookcase", "dining_table", "stool",
    "cabinet", "floor_lamp", "potted_plant", "fridge", "globe", "bowl", "jug", "pillow", "vase", "desk_lamp",
)  # fmt: skip
STEPS = 2000
SIX = ("mjcf", "usd", "usdz", "glb", "urdf", "sdf")


def fifty() -> Scene:
    """50 objects of 20 assets, on the floor of a large room."""
    assets = [make_asset(kind, seed=0) for kind in KINDS]
    scene = Scene(room=rectangle(25.0, 25.0))
    for number in range(50):
        kind = assets[number % len(assets)]
        x, y = 1.5 + 3.0 * (number % 8), 1.5 + 3.0 * (number // 8)
        scene = scene.with_placement(put(kind, x, y, id=f"{kind.category}_{number // len(assets) + 1}"), kind)
    return scene


def best(call: Callable[[], object], times: int = 3) -> float:
    """The least processor time of a call [s]: what it takes on a machine that does nothing else."""
    taken = []
    for _ in range(times):
        start = time.process_time()
        call()
        taken.append(time.process_time() - start)
    return min(taken)


def steps_a_second(model: mujoco.MjModel, *, sleep: bool) -> float:
    """Steps a second of a room at rest, from its keyframe "settled", after 500 steps in which it may fall asleep."""
    bit = int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    model.opt.enableflags = model.opt.enableflags | bit if sleep else model.opt.enableflags & ~bit
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    mujoco.mj_step(model, data, nstep=500)
    start = time.process_time()
    mujoco.mj_step(model, data, nstep=STEPS)
    return STEPS / (time.process_time() - start)


def main() -> None:
    """Print a row for each scene."""
    scenes = {name: load_scene(Path(name)) for name in sys.argv[1:]} or {"50 objects of 20 assets": fifty()}
    for name, scene in scenes.items():
        print(f"{name}: {row(scene)}")


def row(scene: Scene) -> str:
    """What exporting one scene takes, and what comes of it."""
    state = settle(scene)
    inventory = inventory_of(scene, settled=state)
    with TemporaryDirectory() as folder:
        home, taken = Path(folder), {"inventory": best(lambda: inventory_of(scene, settled=state))}
        for kind in formats_named(SIX):
            taken[kind.name] = best(lambda kind=kind: kind.write(inventory, home / kind.file))  # type: ignore[misc]
        size = sum(file.stat().st_size for file in home.rglob("*") if file.is_file()) / 1e6
        layers = len(list((home / "assets").glob("*.usdc")))
        model = mujoco.MjModel.from_xml_path(str(home / "scene.xml"))
    together = taken["inventory"] + taken["mjcf"] + taken["usd"]
    return (
        f"{len(scene.placements)} objects of {len(scene.assets)} assets, {model.ngeom} geoms; "
        + ", ".join(f"{name} {seconds:.2f} s" for name, seconds in taken.items())
        + f"; inventory, MJCF and USD {together:.2f} s, all {sum(taken.values()):.2f} s; {size:.1f} MB, {layers} layers"
        f" of assets and the room; steps a second {steps_a_second(model, sleep=False):,.0f} awake,"
        f" {steps_a_second(model, sleep=True):,.0f} with sleep"
    )


if __name__ == "__main__":
    main()
