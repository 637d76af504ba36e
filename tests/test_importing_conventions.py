"""The same room in every generator's convention becomes the same scene."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.layout_rooms import BEDROOM, Plan, Thing, chair_mesh, distance, write
from thinkblox.importing import FORMATS, detect, read_layout
from thinkblox.importing.document import Document
from thinkblox.importing.frames import OWN_FROM_Y_UP, about
from thinkblox.importing.holodeck import read_holodeck
from thinkblox.importing.library import Library
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import turn_between
from thinkblox.sim.geometry.solid import pose, solid_of

DATA = Path(__file__).parent / "data" / "layouts"
MANY = settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])


def _agrees(placement: Placement, thing: Thing) -> bool:
    return (
        distance(placement.position, thing.position) < 1e-6
        and turn_between(placement.yaw, thing.yaw) < 1e-6
        and distance(placement.size, thing.size) < 1e-6
    )


@pytest.mark.parametrize("format", FORMATS)
def test_every_format_gives_the_same_bedroom(tmp_path, format):
    height = BEDROOM.height if format in ("layoutgpt", "il3d") else 2.6
    layout = read_layout(write(tmp_path, format), format=format, height=height)
    assert layout.format == format
    assert sorted(layout.scene.room.floor) == sorted(BEDROOM.corners)
    assert layout.scene.room.height == BEDROOM.height
    for placement, thing in zip(layout.scene.placements, BEDROOM.things, strict=True):
        assert _agrees(placement, thing), (placement, thing)


@pytest.mark.parametrize("format", [f for f in FORMATS if f != "metaspatial"])
def test_formats_are_told_by_their_keys(tmp_path, format):
    assert detect(json.loads(write(tmp_path, format).read_text())) == format


@pytest.mark.parametrize("format", FORMATS)
def test_what_stands_on_what_is_found(tmp_path, format):
    placements = read_layout(write(tmp_path, format), format=format).scene.placements
    desk = placements[2].id
    assert [p.support for p in placements] == ["floor", "floor", "floor", "floor", desk]


@pytest.mark.parametrize("format", FORMATS)
def test_what_is_a_box_for_want_of_a_mesh_is_said(tmp_path, format):
    layout = read_layout(write(tmp_path, format), format=format)
    expected = () if format == "sceneeval" else tuple(p.id for p in layout.scene.placements)
    assert layout.substituted == expected


@pytest.mark.parametrize("format", FORMATS)
def test_options_that_change_nothing_are_named(tmp_path, format):
    sizes = tmp_path / "table" / "sizes.json"
    sizes.parent.mkdir()
    sizes.write_text('{"piano": [1, 1, 1]}')
    given = {"height": 9.0, "short_side": 3.0, "room_size": (4.0, 3.0), "sizes": sizes}
    said = " ".join(read_layout(write(tmp_path, format), format=format, **given).notes)
    assert ("option height was not used" in said) == (format not in ("layoutgpt", "il3d"))
    assert ("option short-side was not used" in said) == (format != "layoutgpt")
    assert ("option room-size was not used" in said) == (format not in ("idesign", "metaspatial"))
    assert "table of sizes was not used" in said
    sizes.write_text('{"desk": [0.7, 1.4, 0.75], "desk_1": [0.7, 1.4, 0.75]}')
    said = " ".join(read_layout(write(tmp_path, format), format=format, sizes=sizes).notes)
    assert "not used" not in said


THINGS = st.builds(
    Thing,
    name=st.just("chair"),
    position=st.tuples(st.floats(-3, 9), st.floats(-3, 9), st.just(0.0) | st.floats(0.011, 2)),
    yaw=st.floats(-720, 720),
    size=st.tuples(*[st.floats(0.01, 5)] * 3),
)


@pytest.mark.parametrize("format", [f for f in FORMATS if f not in ("metaspatial", "sceneeval")])
@MANY
@given(thing=THINGS)
def test_poses_come_back_as_they_went(tmp_path, format, thing):
    plan = Plan(width=4.0, depth=5.0, height=2.8, things=(thing,))
    (placement,) = read_layout(write(tmp_path, format, plan), format=format).scene.placements
    assert _agrees(placement, thing)


@settings(max_examples=10, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(thing=THINGS)
def test_transforms_of_meshes_come_back_as_poses(tmp_path, thing):
    plan = Plan(width=4.0, depth=5.0, height=2.8, things=(thing,))
    (placement,) = read_layout(write(tmp_path, "sceneeval", plan)).scene.placements
    assert _agrees(placement, thing)


def _chair_room(tmp_path, format, yaw):
    """A room with one chair at (1.5, 2) that faces `yaw`, shown by the chair's mesh."""
    plan = Plan(4.0, 5.0, 2.8, (Thing("chair", (1.5, 2.0, 0.0), yaw, (0.5, 0.5, 0.9)),))
    path = write(tmp_path, format, plan)
    raw = json.loads(path.read_text())
    if format == "layoutvlm":
        raw["assets"]["chair-0"]["path"] = "chair.glb"
    if format == "il3d":
        raw["objects"][0]["object_path"] = "3D-FRONT/Chairs/chair.usdz"
    path.write_text(json.dumps(raw))
    for name in ("chair.glb", "chair_1.glb", "chair/chair.glb"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        chair_mesh().export(tmp_path / name)
    return read_layout(path, format=format)


@pytest.mark.parametrize("yaw", [0.0, 90.0, 215.0])
@pytest.mark.parametrize("format", ["layoutvlm", "idesign", "holodeck", "il3d", "sceneeval"])
def test_the_front_of_a_mesh_is_where_the_yaw_says(tmp_path, format, yaw):
    layout = _chair_room(tmp_path, format, yaw)
    (chair,) = layout.scene.placements
    assert layout.substituted == ()
    points = solid_of(layout.scene.asset_of(chair)).points
    in_room = np.column_stack([points, np.ones(len(points))]) @ pose(chair).T
    front = np.array([math.cos(math.radians(yaw)), math.sin(math.radians(yaw))])
    left = np.array([-front[1], front[0]])
    plan = in_room[:, :2] - (1.5, 2.0)
    back, arm = in_room[:, 2] > 0.65, (in_room[:, 2] > 0.55) & (in_room[:, 2] < 0.65)
    assert (plan[back] @ front).max() == pytest.approx(-0.15, abs=1e-6), "the back is behind"
    assert (plan[arm] @ left).min() > 0.1, "the one armrest is at the left"


def test_blender_and_gltf_files_of_one_mesh_agree(tmp_path):
    """STL and PLY are z-up and face -y: what Blender writes of the chair that it opened from a glTF."""
    turned = chair_mesh()
    turned.apply_transform(trimesh_y_up_to_z_up())
    rooms = []
    for suffix, mesh in (("glb", chair_mesh()), ("obj", chair_mesh()), ("stl", turned), ("ply", turned)):
        path = write(tmp_path / suffix, "idesign", Plan(4, 5, 2.8, (Thing("chair", (1, 2, 0), 30.0, (0.5, 0.6, 0.9)),)))
        mesh.export(tmp_path / suffix / f"chair_1.{suffix}")
        layout = read_layout(path)
        rooms.append(np.vstack([shape.points for shape in _shapes(layout)]))
    for other in rooms[1:]:
        assert np.allclose(np.sort(rooms[0], axis=0), np.sort(other, axis=0), atol=1e-6)


def _shapes(layout):
    return layout.scene.asset_of(layout.scene.placements[0]).links[0].shapes


def trimesh_y_up_to_z_up():
    return np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], dtype=float)


@MANY
@given(turn=st.tuples(*[st.floats(-360, 360)] * 3))
def test_holodeck_turns_agree_with_sceneevals_converter(turn):
    """SceneEval's own bridge out of Unity turns a glTF into the room by Rx(90) Ry(180 - y) Rx(x) Rz(-z)."""
    x, y, z = turn
    bridge = about("x", 90.0) @ about("y", 180.0 - y) @ about("x", x) @ about("z", -z)
    (item,) = read_holodeck(Document(Path("house.json"), holodeck_of_one(x, y, z)), Library(())).items
    assert distance(item.linear @ OWN_FROM_Y_UP, bridge) < 1e-9


def holodeck_of_one(x, y, z):
    floor = [{"x": a, "y": 0, "z": b} for a, b in ((0, 0), (0, 4), (4, 4), (4, 0))]
    thing = {"id": "a", "position": {"x": 1, "y": 1, "z": 1}, "rotation": {"x": x, "y": y, "z": z}}
    return {"rooms": [{"id": "r", "floorPolygon": floor}], "objects": [thing]}


def test_sceneeval_example_of_layoutvlm_faces_into_its_room(tmp_path):
    """Poses of SceneEval's published example, converted there from LayoutVLM: at the south wall it faces north."""
    columns = {
        "south": [-1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 3.0, 0.54, 0, 1],
        "west": [0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0.38, 2.2, 0, 1],
    }
    state = json.loads((DATA / "sceneeval.json").read_text())
    state["scene"]["object"] = [
        {"index": i, "modelId": "layoutvlm-objaverse.chair", "transform": {"data": data}}
        for i, data in enumerate(columns.values())
    ]
    path = tmp_path / "scene_0.json"
    path.write_text(json.dumps(state))
    scene = read_layout(path, assets=DATA).scene
    assert [p.yaw for p in scene.placements] == [90.0, 0.0]
