"""scene.xml as plain mujoco reads it."""

import json
import re
from copy import copy
from pathlib import Path
from xml.etree import ElementTree

import mujoco
import numpy as np
import pytest
from msgspec import structs
from pxr import Usd
from shapely import Point

from tests.export_rooms import L_ROOM, drawer_box, sample_scene
from tests.sim_rooms import put, scene, table
from thinkblox.exporters.mjcf import mjcf_text, write_mjcf
from thinkblox.exporters.stocktaking import inventory_of
from thinkblox.exporters.usd import write_usd
from thinkblox.scene.asset import Surface
from thinkblox.scene.room import Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.scene.surfaces import Covering, Surfaces
from thinkblox.sim.build import build_spec
from thinkblox.sim.verdict.settle import settle


@pytest.fixture(scope="module")
def model() -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(mjcf_text(inventory_of(sample_scene())))


def test_it_is_the_model_that_was_measured(model: mujoco.MjModel) -> None:
    measured = build_spec(sample_scene()).compile()
    names = [measured.body(i).name.replace("/", "_") for i in range(measured.nbody)]
    assert [model.body(i).name for i in range(model.nbody)] == names
    np.testing.assert_allclose(model.body_mass, measured.body_mass, rtol=1e-9)
    np.testing.assert_allclose(model.body_inertia, measured.body_inertia, rtol=1e-6, atol=1e-12)
    # The frames of doors and drawers begin at their joints: the same place in the room.
    np.testing.assert_allclose(model.body_pos + model.body_ipos, measured.body_pos + measured.body_ipos, atol=1e-9)
    np.testing.assert_allclose(model.body_quat, measured.body_quat, atol=1e-9)
    np.testing.assert_allclose(model.dof_frictionloss, measured.dof_frictionloss, rtol=1e-9)
    np.testing.assert_allclose(model.dof_damping, measured.dof_damping, rtol=1e-9)
    things, found = (m.geom_friction[(m.geom_contype > 0) & (m.geom_bodyid > 0)] for m in (measured, model))
    np.testing.assert_allclose(found, things)
    np.testing.assert_allclose(model.geom_solref, np.tile(measured.geom_solref[0], (model.ngeom, 1)))
    np.testing.assert_allclose(model.jnt_range, measured.jnt_range, atol=1e-9)
    assert (model.opt.timestep, model.opt.cone, model.opt.integrator) == (
        measured.opt.timestep, measured.opt.cone, measured.opt.integrator,
    )  # fmt: skip


def test_placements_are_its_reference_pose(model: mujoco.MjModel) -> None:
    for placement in sample_scene().placements:
        np.testing.assert_allclose(model.body(placement.id).pos, placement.position, atol=1e-9)


def test_keyframe_settled_rests_without_deep_contacts_or_warnings(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    np.testing.assert_allclose(data.qpos, settle(sample_scene()).qpos, atol=1e-9)
    assert not data.qvel.any()
    mujoco.mj_forward(model, data)
    assert all(contact.dist > -0.001 for contact in data.contact)
    start = data.qpos.copy()
    mujoco.mj_step(model, data, nstep=250)
    assert np.abs(data.qpos - start).max() < 1e-3
    assert not any(warning.number for warning in data.warning)


def test_the_text_stands_by_itself() -> None:
    text = mjcf_text(inventory_of(sample_scene()))
    assert "file=" not in text
    assert "/work" not in text
    assert "/tmp" not in text
    assert '\n  <worldbody>\n    <geom name="floor"' in text
    assert f"mujoco {mujoco.__version__}" in text.partition("<custom>")[2]
    assert text.partition("<mesh ")[2].partition("/>")[0].count("vertex=") == 1


def test_it_moves_as_the_measured_model_does(model: mujoco.MjModel) -> None:
    """Doors and drawers swing alike under gravity that is tilted; both without sleep."""
    ends = []
    for found in (copy(model), build_spec(sample_scene()).compile()):
        found.opt.gravity[:], found.opt.enableflags = (2.0, -2.0, -9.6), 0
        data = mujoco.MjData(found)
        mujoco.mj_step(found, data, nstep=150)
        ends.append(data.qpos.copy())
    assert np.abs(ends[0] - model.qpos0).max() > 0.01
    np.testing.assert_allclose(ends[0], ends[1], atol=1e-4)


def test_contacts_are_those_of_the_measured_model(model: mujoco.MjModel) -> None:
    """Floor and walls rub as much as the smoothest object does, which makes no difference in MuJoCo."""
    found = []
    for one in (model, build_spec(sample_scene()).compile()):
        data = mujoco.MjData(one)
        data.qpos[:] = settle(sample_scene()).qpos
        mujoco.mj_forward(one, data)
        pairs = sorted(tuple(sorted(one.geom_bodyid[g] for g in contact.geom)) for contact in data.contact)
        found.append((pairs, np.sort([contact.friction for contact in data.contact], axis=0)))
    assert found[0][0] == found[1][0]
    assert found[0][0]
    np.testing.assert_allclose(found[0][1], found[1][1])
    assert model.geom("floor").friction[0] == pytest.approx(0.6)


def names_of(path: Path) -> list[str]:
    tree = ElementTree.parse(path)
    return [value for element in tree.iter() for key, value in element.attrib.items() if key in IDENTIFIERS]


IDENTIFIERS = ("name", "class", "mesh", "material", "texture", "body1", "body2", "joint", "site")


def test_every_geom_has_a_name_that_all_readers_take(tmp_path: Path) -> None:
    write_mjcf(inventory_of(named_badly()), tmp_path / "scene.xml")
    assert [name for name in names_of(tmp_path / "scene.xml") if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name)] == []
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "scene.xml"))
    geoms = [model.geom(g).name for g in range(model.ngeom)]
    assert all(geoms)
    assert len({name.casefold() for name in geoms}) == len(geoms)
    bodies = [model.body(b).name for b in range(1, model.nbody)]
    assert {"a_b", "a_b_2", "a_b_3", "World_2", "Lamp_1", "lamp_1_2"} <= set(bodies)
    (text,) = ElementTree.parse(tmp_path / "scene.xml").iterfind("custom/text[@name='objects']")
    said = json.loads(text.attrib["data"])
    assert {entry["id"] for entry in said.values()} == {p.id for p in named_badly().placements}
    assert set(said) <= set(bodies)
    links = {name: link for entry in said.values() for name, link in entry["links"].items()}
    assert set(links.values()) == {'Tür/links "1"', "😀", "x" * 200}
    assert set(links) <= set(bodies)


def named_badly() -> Scene:
    """Ids that differ in case or in their signs alone, and links of any name."""
    kinds = []
    for link in ('Tür/links "1"', "😀", "x" * 200):
        cupboard = drawer_box()
        body, drawer, _ = cupboard.links
        kinds.append(structs.replace(cupboard, links=(body, structs.replace(drawer, name=link))))
    placed = scene(L_ROOM)
    for number, id in enumerate(("a.b", "a_b", "a-b", "World", "Lamp_1", "lamp_1")):
        kind = structs.replace(kinds[number % 3], id=f"kind-{number % 3}")
        placed = placed.with_placement(put(kind, 0.2001, 0.5 + 0.7 * number, 1.2, id=id, on="west_wall"), kind)
    return placed


def test_dm_control_takes_it(tmp_path: Path) -> None:
    mjcf = pytest.importorskip("dm_control.mjcf")
    for number, room in enumerate((sample_scene(), named_badly())):
        write_mjcf(inventory_of(room), tmp_path / f"{number}.xml")
        model = mjcf.from_path(str(tmp_path / f"{number}.xml"))
        robot = mjcf.RootElement(model="robot")
        robot.worldbody.add("body", name="hand", pos=(3.0, 2.0, 2.0)).add("geom", size=(0.05,))
        model.worldbody.attach(robot)
        physics = mjcf.Physics.from_mjcf_model(model)
        physics.step(200)
        assert not physics.data.warning.number.any()


def test_what_is_touched_and_what_is_seen_are_apart(model: mujoco.MjModel) -> None:
    for number in range(model.ngeom):
        geom = model.geom(number)
        if geom.contype[0]:
            assert (int(geom.group[0]), int(geom.matid[0])) == (3, -1), geom.name
        else:
            assert int(geom.group[0]) in (1, 2), geom.name
            assert geom.matid[0] >= 0, geom.name


def test_doors_turn_about_their_own_frames(model: mujoco.MjModel) -> None:
    assert not model.jnt_pos.any()
    np.testing.assert_allclose(model.body("wardrobe_1_door_left").pos, (0.28, 0.5, 0.0), atol=1e-9)


def test_surfaces_become_sites() -> None:
    kind = structs.replace(
        table(), surfaces=(Surface(name="top, left 1.1", position=(0.0, 0.0, 0.75), size=(1.2, 0.8)),)
    )
    model = mujoco.MjModel.from_xml_string(mjcf_text(inventory_of(scene(None, (put(kind, 2.0, 2.0), kind)))))
    np.testing.assert_allclose(model.site("table_1_top_left_1_1").pos, (0.0, 0.0, 0.75))
    np.testing.assert_allclose(model.site("table_1_top_left_1_1").size[:2], (0.6, 0.4))


def test_an_idle_room_sleeps_and_wakes(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    mujoco.mj_step(model, data, nstep=500)
    assert (data.tree_asleep >= 0).all()
    data.body("vase_1").xfrc_applied[2] = 30.0
    mujoco.mj_step(model, data, nstep=50)
    assert data.body("vase_1").xpos[2] > 0.76


def test_keyframe_home_is_as_proposed(model: mujoco.MjModel) -> None:
    np.testing.assert_allclose(model.key("home").qpos, model.qpos0, atol=1e-9)


def test_the_same_scene_gives_the_same_bytes(tmp_path: Path) -> None:
    for name in ("a.xml", "b.xml"):
        write_mjcf(inventory_of(sample_scene()), tmp_path / name)
    assert (tmp_path / "a.xml").read_bytes() == (tmp_path / "b.xml").read_bytes()


def test_the_first_view_shows_the_room(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    camera = model.camera("overview").id
    towards = model.stat.center - data.cam_xpos[camera]
    ahead = -data.cam_xmat[camera].reshape(3, 3)[:, 2]
    np.testing.assert_allclose(ahead, towards / np.linalg.norm(towards), atol=1e-4)
    assert data.cam_xpos[camera][2] > sample_scene().room.height


def test_an_empty_room_is_a_model_too() -> None:
    model = mujoco.MjModel.from_xml_string(mjcf_text(inventory_of(Scene(room=sample_scene().room))))
    assert (model.nbody, model.nkey) == (1, 2)


def test_cameras_stand_free_in_the_corners_and_look_in(model: mujoco.MjModel) -> None:
    """From each corner of the room something of it is seen, and nothing closer than an arm's length hides it all."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    names = [model.camera(number).name for number in range(model.ncam)]
    assert names[:2] == ["overview", "top"]
    assert len(names) == 2 + 5  # one corner of the L points into the room
    for name in names[2:]:
        place, turn = data.camera(name).xpos, data.camera(name).xmat.reshape(3, 3)
        assert L_ROOM.polygon.contains(Point(place[:2]))
        assert 1.4 < place[2] < L_ROOM.height
        np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-6)
        assert turn[2, 1] > 0.0  # upright
        seen = [mujoco.mj_ray(model, data, place, turn @ [x, y, -1.0], None, 1, -1, np.zeros(1, np.int32))
                for x in (-0.4, 0.0, 0.4) for y in (-0.3, 0.0, 0.3)]  # fmt: skip
        assert min(seen) > 0.0
        assert float(np.median(seen)) > 0.7


def test_the_room_is_closed_for_who_stands_in_it(model: mujoco.MjModel) -> None:
    """Walls, doors, windows and ceiling are opaque and in a group of their own, and seen from the room's side only."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    walls = np.zeros(6, np.uint8)
    walls[[1, 2]] = 1
    centre, hit = np.array([1.5, 2.5, 1.2]), np.zeros(1, np.int32)
    rng = np.random.default_rng(0)
    for ray in rng.normal(size=(300, 3)):
        assert mujoco.mj_ray(model, data, centre, ray, walls, 1, -1, hit) > 0.0
        if model.geom_bodyid[hit[0]] == 0:
            assert model.mat_rgba[model.geom_matid[hit[0]], 3] == 1.0
            assert (model.geom(int(hit[0])).name == "floor_visual") == (int(model.geom_group[hit[0]]) == 2)
    for name in ("south_wall_visual", "ceiling_visual"):
        mesh = int(model.geom(name).dataid[0])
        start, count = int(model.mesh_faceadr[mesh]), int(model.mesh_facenum[mesh])
        corners = model.mesh_vert[model.mesh_vertadr[mesh] :][model.mesh_face[start : start + count]]
        turn = data.geom(name).xmat.reshape(3, 3)
        facing = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) @ turn.T
        inward = (0.0, 1.0, 0.0) if name.startswith("south") else (0.0, 0.0, -1.0)
        assert (facing @ inward).min() > -1e-6
    assert model.nlight >= 2


def test_floors_have_the_pattern_of_the_pictures(tmp_path: Path) -> None:
    room = structs.replace(
        rectangle(3.0, 2.0),
        surfaces=Surfaces(
            floor=Covering(laying="checker", colour=(0.9, 0.9, 0.9), second=(0.1, 0.1, 0.1)),
            walls=Covering(laying="paint", colour=(0.4, 0.6, 0.8)),
        ),
    )
    write_mjcf(inventory_of(Scene(room=room)), tmp_path / "scene.xml")
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "scene.xml"))
    floor, wall = model.geom("floor_visual"), model.geom("south_wall_visual")
    texture = int(model.mat_texid[int(floor.matid[0]), int(mujoco.mjtTextureRole.mjTEXROLE_RGB)])
    width, height = int(model.tex_width[texture]), int(model.tex_height[texture])
    picture = model.tex_data[model.tex_adr[texture] :][: 3 * width * height].reshape(height, width, 3)
    # Squares of 0.4 m: 7.5 along the room and 5 across it.
    dark = picture[:, :, 0] < 120
    assert dark.mean() == pytest.approx(0.5, abs=0.1)
    row = dark[height // 2 + int(0.1 * height / 2)]
    assert np.count_nonzero(row[1:] != row[:-1]) in (7, 8)
    assert model.mat_rgba[int(wall.matid[0])] == pytest.approx((0.4, 0.6, 0.8, 1.0), abs=1e-3)


@pytest.mark.parametrize(
    "room",
    [
        Room(floor=((0.0, 0.0), (4.0, 0.0), (0.0, 3.0))),
        Room(floor=((0.0, 0.0), (0.5, 0.0), (0.5, 0.5), (0.0, 0.5)), height=1.5),
        Room(floor=((0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)), height=50.0),
        Room(floor=((0.0, 0.0), (6.0, 0.0), (6.0, 4.0), (4.0, 4.0), (4.0, 1.5), (2.0, 1.5), (2.0, 4.0), (0.0, 4.0))),
    ],
    ids=["triangle", "tiny", "huge", "U"],
)
def test_odd_rooms_are_closed_too(room: Room, tmp_path: Path) -> None:
    inventory = inventory_of(Scene(room=room))
    write_mjcf(inventory, tmp_path / "scene.xml")
    write_usd(inventory, tmp_path / "scene.usda")
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "scene.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    middle = room.polygon.representative_point()
    seen = np.array([0, 1, 1, 0, 0, 0], np.uint8)
    for ray in np.random.default_rng(0).normal(size=(100, 3)):
        start = np.array([middle.x, middle.y, 0.4 * room.height])
        assert mujoco.mj_ray(model, data, start, ray, seen, 1, -1, np.zeros(1, np.int32)) > 0.0
    assert Usd.Stage.Open(str(tmp_path / "scene.usda")).GetPrimAtPath("/World/Room/ceiling")
