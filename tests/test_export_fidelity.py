"""Every export, read again by a library that is not ours, holds what was measured; and USD is verified as it is."""

from pathlib import Path

import mujoco
import numpy as np
import pytest

import thinkblox
from tests.export_rooms import sample_scene
from tests.exported import FORMATS, READERS, compare, measured
from tests.sim_rooms import put, scene
from thinkblox.assets import make_asset
from thinkblox.exporters.formats import formats_named
from thinkblox.exporters.stocktaking import inventory_of
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec
from thinkblox.sim.foreign.model_report import model_report
from thinkblox.sim.foreign.opening import open_model

pytestmark = pytest.mark.slow

PROMPTS = Path(__file__).with_name("bench").joinpath("prompts.txt").read_text(encoding="utf-8").splitlines()
KINDS = ("fridge", "office_chair", "table_lamp", "ball", "bean_bag", "cabinet", "bowl")


def furnished() -> Scene:
    """A row of made things, with doors, drawers and round ones."""
    things = [make_asset(name, seed=0) for name in KINDS]
    return scene(None, *((put(kind, 0.6 + 0.9 * (i % 4), 1.0 + 1.2 * (i // 4)), kind) for i, kind in enumerate(things)))


def check_all(room: Scene, folder: Path) -> None:
    """Write a room in every format, and read each again."""
    inventory = inventory_of(room)
    expected = measured(inventory)
    model = build_spec(room).compile()
    assert len(expected) == model.nbody - 1
    sources = {body.name: body.source for item in inventory.objects for body in item.bodies}
    for name, row in expected.items():
        assert row.mass == pytest.approx(float(model.body(sources[name]).mass[0]), rel=1e-9)
    for kind in formats_named(FORMATS):
        kind.write(inventory, folder / kind.file)
        rows = READERS[kind.file](folder / kind.file, set(expected))
        assert set(rows) == set(expected), f"{kind.name}: {sorted(set(rows) ^ set(expected))[:5]}"
        for name, row in rows.items():
            compare(f"{kind.name} {name}", row, expected[name])
    check_verified(folder)


def check_verified(folder: Path) -> None:
    """The MJCF and the USD of a room are one model to `verify`, and pass alike."""
    ours, theirs = (open_model(folder / name) for name in ("scene.xml", "scene.usda"))
    assert {thing.id for thing in ours.things} == {thing.id for thing in theirs.things}
    reports = [model_report(subject, seconds=1.0) for subject in (ours, theirs)]
    verdicts = [{verdict.id: verdict.valid for verdict in report.objects} for report in reports]
    assert verdicts[0] == verdicts[1]
    first, second = (subject.data() for subject in (ours, theirs))
    for body in range(1, ours.model.nbody):
        name = ours.model.body(body).name
        np.testing.assert_allclose(first.body(name).xpos, second.body(name).xpos, atol=1e-6)


def test_a_room_of_everything_is_the_same_in_every_format(tmp_path: Path) -> None:
    check_all(sample_scene(), tmp_path)


def test_made_things_are_the_same_in_every_format(tmp_path: Path) -> None:
    check_all(furnished(), tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("number", range(len(PROMPTS)))
def test_every_room_is_the_same_in_every_format(number: int, tmp_path: Path) -> None:
    check_all(thinkblox.generate_room(PROMPTS[number], seed=0).scene, tmp_path)


def test_the_room_of_a_urdf_is_no_object(tmp_path: Path) -> None:
    subject = open_model(furnished().export(tmp_path / "room.urdf"))
    assert {thing.id for thing in subject.things} == {f"{name}_1" for name in KINDS}
    assert not [note for note in subject.notes if "inertial" in note]


def test_models_of_single_assets_are_read_too(tmp_path: Path) -> None:
    sample_scene().export(tmp_path / "room.urdf")
    models = sorted((tmp_path / "assets").glob("*.urdf"))
    assert len(models) == len(sample_scene().assets)
    masses = sorted(float(mujoco.MjModel.from_xml_path(str(path)).body_mass.sum()) for path in models)
    # MuJoCo makes the root link of a URDF a part of the world, which weighs nothing there, but for its own <inertial>.
    assert masses[-1] > 0.0


@pytest.mark.parametrize("ending", ["usda", "usdc", "usdz"])
def test_verify_reads_usd(ending: str, tmp_path: Path) -> None:
    path = furnished().export(tmp_path / f"room.{ending}")
    report = thinkblox.verify_file(path)
    assert report.valid
    assert report.source == "usd"
    assert {verdict.id for verdict in report.objects} == {f"{name}_1" for name in KINDS}


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("float physics:mass = 25", "float physics:mass = -1", "has a mass of -1"),
        ("float physics:upperLimit = 110", "float physics:upperLimit = -5", "lower limit 0 above its upper one"),
        ("physics:localPos0 = (0.28", "physics:localPos0 = (1.28", "two frames 1 m apart"),
        ("#usda 1.0", "not usd", "no USD that can be read"),
    ],
)  # fmt: skip
def test_verify_tells_the_faults_of_a_stage(old: str, new: str, said: str, tmp_path: Path) -> None:
    path = sample_scene().export(tmp_path / "room.usda")
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    with pytest.raises(thinkblox.InputError, match=said):
        thinkblox.verify_file(path)


def test_an_impossible_inertia_and_a_missing_physics_scene_are_told(tmp_path: Path) -> None:
    path = sample_scene().export(tmp_path / "room.usda")
    text = path.read_text().replace('def PhysicsScene "PhysicsScene"', 'def Scope "PhysicsScene"')
    start = text.index('def Xform "vase_1"')
    line = text.index("float3 physics:diagonalInertia = (", start)
    path.write_text(text[:line] + "float3 physics:diagonalInertia = (9, 1, 1)" + text[text.index("\n", line) :])
    notes = open_model(path).notes
    assert any("No body has the inertia of /World/Objects/vase_1" in note for note in notes)
    assert any("has 0 physics scenes" in note for note in notes)


def test_layers_outside_the_folder_are_not_read(tmp_path: Path) -> None:
    sample_scene().export(tmp_path / "room.usda")
    (tmp_path / "in").mkdir()
    (tmp_path / "in" / "room.usda").write_text("#usda 1.0\n(\n    subLayers = [@../room.usda@]\n)\n")
    with pytest.raises(thinkblox.InputError, match="outside the folder"):
        thinkblox.verify_file(tmp_path / "in" / "room.usda")
