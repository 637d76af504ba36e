"""Three prompts through the command line, and every file read back by the program it is for."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any, NamedTuple

import mujoco
import numpy as np
import pytest
from PIL import Image
from pxr import Usd, UsdGeom, UsdPhysics

from thinkblox.episode import read_episode
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene, load_scene

PROMPTS = {
    "bedroom": "A calm bedroom, 4 m by 5 m, with a double bed, two nightstands with a lamp on each and a wardrobe.",
    "dining": "A dining room with a round table with four chairs around it, a sideboard and a lamp above the table.",
    "office": "An L-shaped office with a desk, an office chair, a bookcase, a laptop on the desk and a wall clock.",
}


class Written(NamedTuple):
    folder: Path
    scene: Scene
    model: Any
    settled: Any
    stage: Any


def generate(prompt: str, out: Path, *options: str, hash_seed: str = "0") -> None:
    command = [sys.executable, "-m", "thinkblox", "generate", prompt, "--out", str(out), *options]
    environment = os.environ | {"PYTHONHASHSEED": hash_seed}
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.fixture(
    scope="module",
    params=[
        pytest.param(prompt, id=name, marks=[] if name == "bedroom" else [pytest.mark.slow])
        for name, prompt in PROMPTS.items()
    ],
)
def written(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Written:
    folder = tmp_path_factory.mktemp("rooms") / "room"
    generate(request.param, folder)
    model = mujoco.MjModel.from_xml_path(str(folder / "scene.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    mujoco.mj_forward(model, data)
    return Written(folder, load_scene(folder), model, data, Usd.Stage.Open(str(folder / "scene.usda")))


def bodies(stage: Any) -> dict[str, Any]:
    """Rigid bodies of the stage by the id of their object; the main part of what has doors or drawers."""
    found = {}
    for prim in stage.Traverse():
        if prim.HasAPI(UsdPhysics.RigidBodyAPI) and prim.GetName() not in ("",):
            path = str(prim.GetPath()).removeprefix("/World/Objects/").split("/")
            if len(path) == 1 or path[1] == path[0]:
                found[path[0]] = prim
    return found


def test_every_file_is_there(written: Written) -> None:
    names = {path.name for path in written.folder.iterdir()}
    assert names == {
        "scene.json", "scene.xml", "scene.usda", "report.json", "trace.jsonl", "preview.png", "top.png",
        "manifest.json", "assets",
    }  # fmt: skip


def test_scene_json_has_the_published_keys(written: Written) -> None:
    document = json.loads((written.folder / "scene.json").read_text())
    assert all(len(corner) == 2 for corner in document["room"]["floor"])
    assert document["room"]["height"] > 2.0
    assert {opening["kind"] for opening in document["room"]["openings"]} == {"door", "window"}
    for placement in document["placements"]:
        assert set(placement) == {"id", "category", "asset", "position", "yaw", "size", "support"}


def test_the_report_and_the_trace_agree_with_the_scene(written: Written) -> None:
    report = json.loads((written.folder / "report.json").read_text())
    ids = [placement.id for placement in written.scene.placements]
    assert [verdict["id"] for verdict in report["objects"]] == ids
    episode = read_episode(written.folder)
    assert {r.id for r in episode.rounds} == set(ids)
    assert episode.scene == written.scene
    assert report["versions"]["mujoco"] == mujoco.__version__


def test_plain_mujoco_finds_no_deep_contact_and_nothing_moves(written: Written) -> None:
    model, data = written.model, written.settled
    assert min([0.0, *data.contact.dist]) > -0.001
    free = [int(model.jnt_bodyid[j]) for j in range(model.njnt) if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE]
    start, turn = data.xpos[free].copy(), data.xquat[free].copy()
    model.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    moving = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, moving, model.key("settled").id)
    for _ in range(round(5.0 / model.opt.timestep)):
        mujoco.mj_step(model, moving)
    assert np.linalg.norm(moving.xpos[free] - start, axis=1).max() < 0.01
    cosine = np.clip(np.abs((moving.xquat[free] * turn).sum(1)), 0.0, 1.0)
    assert np.degrees(2 * np.arccos(cosine)).max() < 2.0
    assert not any(warning.number for warning in moving.warning)


def test_mjcf_has_a_body_of_the_right_mass_and_pose_for_every_object(written: Written) -> None:
    for placement in written.scene.placements:
        body = written.model.body(placement.id)
        asset = written.scene.asset_of(placement)
        if asset.free:
            assert written.model.body_subtreemass[body.id] == pytest.approx(asset.mass, rel=1e-4)
        assert written.settled.xpos[body.id] == pytest.approx(placement.position, abs=0.012)


def test_usd_and_mjcf_agree_on_bodies_masses_and_poses(written: Written) -> None:
    found = bodies(written.stage)
    free = {p.id for p in written.scene.placements if written.scene.asset_of(p).free}
    assert set(found) == free
    for id, prim in found.items():
        body = written.model.body(id)
        assert UsdPhysics.MassAPI(prim).GetMassAttr().Get() == pytest.approx(float(body.mass[0]), rel=1e-5)
        matrix = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())
        assert np.array(matrix.ExtractTranslation()) == pytest.approx(written.settled.xpos[body.id], abs=1e-5)
        quat = matrix.ExtractRotationQuat()
        turned = np.abs(np.dot([quat.real, *quat.imaginary], written.settled.xquat[body.id]))
        assert turned == pytest.approx(1.0, abs=1e-8)


@pytest.mark.slow
def test_pictures_are_pictures_of_something(written: Written) -> None:
    for name in ("preview.png", "top.png"):
        image = Image.open(written.folder / name)
        assert image.size == (1024, 1024)
        assert np.asarray(image.convert("L")).std() > 8


def test_the_relations_of_the_bedroom_hold(tmp_path: Path) -> None:
    generate(PROMPTS["bedroom"], tmp_path / "room", "--no-pictures")
    scene = load_scene(tmp_path / "room")
    for number in (1, 2):
        assert measure(scene, "on", f"table_lamp_{number}", [f"nightstand_{number}"]).holds
        assert measure(scene, "next_to", f"nightstand_{number}", ["bed_1"]).holds


@pytest.mark.slow
def test_the_same_prompt_and_seed_give_the_same_bytes_in_another_process(tmp_path: Path) -> None:
    for name, hash_seed in (("a", "1"), ("b", "2")):
        generate(PROMPTS["dining"], tmp_path / name, "--seed", "7", "--no-pictures", hash_seed=hash_seed)
    for file in ("scene.json", "scene.xml", "scene.usda", "report.json"):
        assert (tmp_path / "a" / file).read_bytes() == (tmp_path / "b" / file).read_bytes()
