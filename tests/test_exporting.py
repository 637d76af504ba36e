"""Exports as a user asks for them: by ending, by command, with flavors, and with what cannot be written."""

import json
import shutil
import struct
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import mujoco
import numpy as np
import pytest
from msgspec import structs
from pxr import Usd, UsdPhysics

import thinkblox
from tests.export_rooms import sample_scene
from tests.sim_rooms import asset, box, put, scene
from thinkblox.cli import main
from thinkblox.errors import InputError
from thinkblox.exporters.exporting import export_file, export_scene
from thinkblox.exporters.manifest import Manifest
from thinkblox.exporters.saving import write_scene
from thinkblox.scene.asset import Joint, Link
from thinkblox.scene.scene import Scene, load_scene
from thinkblox.sim.build import build_spec
from thinkblox.value import read_json

ALL = ("mjcf", "usd", "usdc", "usdz", "glb", "urdf", "sdf")
ODD = ("a.b", "a-b", "a_b", "Chair", "chair", "CHAIR", "room", "top", "x" * 100)
LINKS = ("Tür/links", 'he said "hi"', "🪑🪑", "x" * 200, "Door 1", "door 1", "door_1", "-", "]]>\n\x0b")


def odd_scene() -> Scene:
    """Things with names that hardly any reader takes; what an id may be is stricter than what a link may be called."""
    flaps = tuple(
        Link(
            name=name,
            shapes=(box((0.02, 0.02, 0.1), (0.1, 0.03 * i - 0.12, 0.2)),),
            joint=Joint(kind="hinge", axis=(0.0, 0.0, 1.0), anchor=(0.1, 0.03 * i - 0.11, 0.2), lower=0.0, upper=9.0),
        )
        for i, name in enumerate(LINKS)
    )
    chest = structs.replace(asset("chest", (0.2, 0.3, 0.3), mass=9.0, links=flaps), id="Küche/🪑 'x'")
    chest = structs.replace(chest, author='"Ä" ]]> \0 <&>')
    stood = [(put(chest, 0.5 + 0.3 * i, 2.0, id=name), chest) for i, name in enumerate(ODD)]
    return structs.replace(scene(None, *stood), prompt='ein "Zimmer" ]]> \0\x0b 🪑')


@pytest.fixture(scope="module")
def sample(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("sample") / "room.json"
    write_scene(sample_scene(), path)
    return path


def test_the_command_writes_all_formats(sample: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "deep" / "out"
    assert main(["export", str(sample), "--to", ",".join(ALL), "--out", str(out), "--json"]) == 0
    paths = [Path(path) for path in json.loads(capsys.readouterr().out)]
    assert [path.name for path in paths] == [
        "scene.xml", "scene.usda", "scene.usdc", "scene.usdz", "scene.glb", "scene.urdf", "scene.sdf",
    ]  # fmt: skip
    assert all(path.stat().st_size > 1000 for path in paths)
    assert read_json(out / "manifest.json", Manifest).formats == ALL
    assert load_scene(out) == load_scene(sample)
    assert main(["export", str(out), "--out", str(out)]) == 2
    assert main(["export", str(out), "--out", str(out), "--overwrite"]) == 0
    assert not (out / "scene.glb").exists()


@pytest.mark.parametrize("name", ["room.xml", "room.usda", "room.usdz", "room.GLB", "room.urdf", "room.sdf", "r.usd"])
def test_a_scene_writes_itself_by_the_ending(name: str, tmp_path: Path) -> None:
    path = sample_scene().export(tmp_path / "new" / name)
    assert path.is_file()
    with pytest.raises(InputError, match="already"):
        sample_scene().export(path)
    before = {file: file.read_bytes() for file in tmp_path.rglob("*") if file.is_file()}
    assert sample_scene().export(path, overwrite=True) == path
    assert {file: file.read_bytes() for file in tmp_path.rglob("*") if file.is_file()} == before


def test_endings_that_nobody_knows(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"the endings are \.xml, .*\.sdf"):
        sample_scene().export(tmp_path / "room.step")
    with pytest.raises(InputError, match="no format is named"):
        raise_main(["export", "x.json", "--to", ",", "--out", str(tmp_path / "out")])


def raise_main(argv: list[str]) -> None:
    from thinkblox.cli.running import _parser

    arguments = _parser().parse_args(argv)
    arguments.run(arguments)


def test_an_output_that_cannot_be_leaves_nothing(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    for out in (tmp_path / "file", tmp_path / "file" / "below"):
        with pytest.raises(InputError):
            export_scene(sample_scene(), out)
    with pytest.raises(InputError):
        export_file(sample_scene(), tmp_path / "file" / "room.glb")
    (tmp_path / "room.glb").mkdir()
    with pytest.raises(InputError, match="is no file"):
        export_file(sample_scene(), tmp_path / "room.glb", overwrite=True)
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["file", "room.glb"]


def test_a_full_disk_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(path: Path, data: bytes) -> int:
        raise OSError(28, "No space left on device", str(path))

    monkeypatch.setattr(Path, "write_bytes", full)
    for name in ("room.glb", "room.xml", "room.usdz", "room.urdf"):
        with pytest.raises(InputError, match="No space left"):
            export_file(sample_scene(), tmp_path / "new" / name)
    with pytest.raises(InputError, match="No space left"):
        export_scene(sample_scene(), tmp_path / "out", formats=ALL)
    assert list(tmp_path.iterdir()) == []


def test_odd_names_are_safe_and_the_same_everywhere(tmp_path: Path) -> None:
    out = export_scene(odd_scene(), tmp_path / "out", formats=ALL)
    model = mujoco.MjModel.from_xml_path(str(out / "scene.xml"))
    names = [model.body(i).name for i in range(1, model.nbody)]
    assert len({name.casefold() for name in names}) == len(ODD) * (len(LINKS) + 1)
    assert all(name.isascii() and name.replace("_", "a").isalnum() and len(name) <= 100 for name in names)
    urdf = mujoco.MjModel.from_xml_path(str(out / "scene.urdf"))
    assert set(names) <= {urdf.body(i).name for i in range(urdf.nbody)}
    roots = [model.body(i).name for i in range(1, model.nbody) if model.body_parentid[i] == 0]
    text = (out / "scene.usda").read_text()
    assert all(f'def Xform "{name}"' in text for name in names)
    assert all(f'<model name="{name}">' in (out / "scene.sdf").read_text() for name in roots)
    data = model.text_data if isinstance(model.text_data, bytes) else bytes(np.asarray(model.text_data))
    texts = [data[a : a + n - 1] for a, n in zip(model.text_adr, model.text_size, strict=True)]
    said = next(json.loads(text) for text in texts if text.startswith(b'{"'))
    assert {value["id"] for value in said.values()} == set(ODD)
    assert all(set(value["links"].values()) == set(LINKS) for value in said.values())
    for file, part in (("scene.urdf", "thinkblox"), ("scene.sdf", "{urn:thinkblox}object")):
        found = list(ElementTree.parse(out / file).iter(part))
        assert [element.get("id") for element in found] == list(ODD)
        assert [p.get("called") for p in found[0]] == [name.replace("\x0b", "\\u000b") for name in LINKS]
    data = (out / "scene.glb").read_bytes()
    nodes = json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])["nodes"]
    assert len({node["name"] for node in nodes}) == len(nodes)
    assert [node["extras"]["id"] for node in nodes if "id" in node.get("extras", {})] == list(ODD)


@pytest.mark.parametrize("extent", [0.001, 50.0])
def test_tiny_and_huge_things(extent: float, tmp_path: Path) -> None:
    kind = asset("cube", (extent,) * 3, mass=max(extent**3 * 500, 1e-6))
    room = thinkblox.Room(floor=((0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)), height=50.0)
    out = export_scene(scene(room, (put(kind, 50.0, 50.0), kind)), tmp_path / "out", formats=(*ALL, "mjcf-mjx"))
    for name in ("scene.xml", "scene.urdf", "scene.mjx.xml"):
        model = mujoco.MjModel.from_xml_path(str(out / name))
        assert model.body("cube_1").mass[0] == pytest.approx(kind.mass)


def test_rotations_in_gltf_are_within_their_range() -> None:
    from thinkblox.exporters.glb import _Book

    book = _Book({}, {})
    root = book.node("root", rotation=[0.0, 0.0, 0.0, 1.0000000000000004])
    data = book.bytes(root, {})
    assert json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])["nodes"][0]["rotation"][3] == 1.0


def test_an_unseen_and_an_untouchable_thing(tmp_path: Path) -> None:
    ghost = asset("ghost", (0.5, 0.5, 0.01), box((0.5, 0.5, 0.01), (0.0, 0.0, 0.005), collide=False))
    out = export_scene(scene(None, (put(ghost, 1.0, 1.0), ghost)), tmp_path / "out", formats=ALL)
    assert mujoco.MjModel.from_xml_path(str(out / "scene.xml")).body("ghost_1").id > 0


def test_a_door_that_nothing_can_touch(tmp_path: Path) -> None:
    hinge = Joint(kind="hinge", axis=(0.0, 0.0, 1.0), anchor=(0.25, 0.2, 0.2), lower=0.0, upper=90.0)
    shape = box((0.02, 0.4, 0.4), (0.26, 0.0, 0.25), collide=False)
    chest = asset("chest", (0.5, 0.5, 0.5), links=(Link(name="veil", shapes=(shape,), joint=hinge),))
    out = export_scene(scene(None, (put(chest, 1.0, 1.0), chest)), tmp_path / "out", formats=ALL)
    mass = mujoco.MjModel.from_xml_path(str(out / "scene.xml")).body("chest_1_veil").mass[0]
    stage = Usd.Stage.Open(str(out / "scene.usda"))
    prim = stage.GetPrimAtPath("/World/Objects/chest_1/chest_1_veil")
    assert UsdPhysics.MassAPI(prim).GetMassAttr().Get() == pytest.approx(mass)


def test_robosuite_has_its_groups_and_sites(sample: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert main(["export", str(sample), "--to", "mjcf", "--flavor", "robosuite", "--out", str(out)]) == 0
    model = mujoco.MjModel.from_xml_path(str(out / "scene.robosuite.xml"))
    assert set(model.geom_group[model.geom_contype > 0]) == {0}
    assert set(model.geom_group[model.geom_contype == 0]) == {1}
    for placement in load_scene(sample).placements:
        height = placement.size[2]
        top, bottom, side = (
            model.site(f"{placement.id}_{kind}_site").pos for kind in ("top", "bottom", "horizontal_radius")
        )
        np.testing.assert_allclose(top - bottom, (0.0, 0.0, height))
        assert side[0] == pytest.approx(placement.size[0] / 2)


def test_mjx_gets_only_pairs_that_it_knows(tmp_path: Path) -> None:
    out = export_scene(sample_scene(), tmp_path / "out", formats=("mjcf", "urdf"), flavor="mjx")
    assert (out / "scene.urdf").is_file()
    model = mujoco.MjModel.from_xml_path(str(out / "scene.mjx.xml"))
    measured = build_spec(sample_scene()).compile()
    solid = {int(kind) for kind in model.geom_type[model.geom_contype > 0]}
    assert not solid & {int(mujoco.mjtGeom.mjGEOM_CYLINDER), int(mujoco.mjtGeom.mjGEOM_ELLIPSOID)}
    np.testing.assert_allclose(model.body_mass, measured.body_mass, rtol=1e-6)
    np.testing.assert_allclose(model.body_inertia, measured.body_inertia, rtol=1e-4)
    assert not model.opt.enableflags & int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    before = data.qpos.copy()
    mujoco.mj_step(model, data, nstep=500)
    assert np.abs(data.qpos - before).max() < 0.02
    with pytest.raises(InputError, match="none of usd has a flavor"):
        export_scene(sample_scene(), tmp_path / "other", formats=("usd",), flavor="mjx")


def test_a_robot_is_attached_in_ten_lines() -> None:
    spec = thinkblox.to_mjspec(sample_scene())
    robot = mujoco.MjSpec.from_string(
        '<mujoco><worldbody><body name="base"><freejoint/><geom name="hull" size=".2 .1" type="cylinder"/>'
        "</body></worldbody></mujoco>"
    )
    spec.attach(robot, prefix="robot_", frame=spec.worldbody.add_frame(pos=(1.0, 1.0, 0.11)))
    model = spec.compile()
    assert model.body("robot_base").mass[0] > 0
    assert model.opt.cone == mujoco.mjtCone.mjCONE_ELLIPTIC
    plain = thinkblox.to_mjmodel(sample_scene())
    assert model.nbody == plain.nbody + 1
    assert plain.nkey == 2


@pytest.mark.parametrize("ending", [".xml", ".usda", ".usdz", ".glb", ".urdf", ".sdf"])
def test_a_file_whose_texture_is_gone_is_not_written(ending: str, tmp_path: Path) -> None:
    from tests.textured import crate, crate_scene

    body, lid = crate().links
    look = structs.replace(body.visuals[0].look, texture="0" * 64)
    faded = structs.replace(body, visuals=(structs.replace(body.visuals[0], look=look),))
    with pytest.raises(InputError, match="crate-0"):
        crate_scene(structs.replace(crate(), links=(faded, lid))).export(tmp_path / f"room{ending}")
    assert list(tmp_path.iterdir()) == []


def test_a_name_with_a_nul_is_refused() -> None:
    with pytest.raises(InputError, match=r"Link\.name"):
        Link(name="a\0b", shapes=(box((1.0, 1.0, 1.0), (0.0, 0.0, 0.5)),))


def test_names_of_a_texture_that_is_gone(tmp_path: Path) -> None:
    from tests.textured import crate_scene

    write_scene(crate_scene(), tmp_path / "room.json")
    next((tmp_path / "assets").glob("*.png")).unlink()
    code = (
        "import sys; from thinkblox.cli import main; "
        f"sys.exit(main(['export', {str(tmp_path / 'room.json')!r}, '--out', {str(tmp_path / 'out')!r}]))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 2
    assert ".png" in done.stderr
    assert not (tmp_path / "out").exists()


def test_two_rooms_in_one_folder_share_what_is_the_same(tmp_path: Path) -> None:
    sample_scene().export(tmp_path / "one.usda")
    first = {path.name for path in (tmp_path / "assets").iterdir()}
    again = structs.replace(sample_scene(), prompt="another")
    again.export(tmp_path / "two.usda")
    assert {path.name for path in (tmp_path / "assets").iterdir()} == first
    shutil.rmtree(tmp_path / "assets")
