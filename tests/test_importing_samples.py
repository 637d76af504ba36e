"""Small files as the generators write them: rooms, openings, sizes, mounts and what is said about them."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from thinkblox.errors import InputError
from thinkblox.importing import read_layout
from thinkblox.sim.verdict.verify import verify

DATA = Path(__file__).parent / "data" / "layouts"


def _mounts(scene):
    return [scene.asset_of(p).mount for p in scene.placements]


def test_holodeck_room_with_its_door_and_window():
    layout = read_layout(DATA / "holodeck.json", room="bedroom")
    room = layout.scene.room
    assert sorted(room.floor) == [(0.0, 0.0), (0.0, 4.0), (4.0, 0.0), (4.0, 4.0)]
    assert room.height == 2.7
    door, window = room.openings
    # The door is 2.9 to 3.8 m along the east wall from the north-east corner, so 0.2 to 1.1 m from the south.
    east = room.walls[door.wall]
    assert (door.kind, east.name, door.sill, door.height) == ("door", "east_wall", 0.0, 2.1)
    ends = sorted(east.point(along)[1] for along in (door.offset, door.offset + door.width))
    assert ends == pytest.approx([0.2, 1.1])
    north = room.walls[window.wall]
    assert (window.kind, north.name, window.sill, round(window.height, 9)) == ("window", "north_wall", 1.0, 1.1)
    ends = sorted(north.point(along)[0] for along in (window.offset, window.offset + window.width))
    assert ends == pytest.approx([1.0, 2.2])


def test_holodeck_bed_sized_by_its_footprint():
    layout = read_layout(DATA / "holodeck.json", room="bedroom")
    (bed,) = layout.scene.placements
    assert bed.position == pytest.approx((1.0, 1.6, 0.0))
    assert bed.yaw == 0.0, "Unity's 90 is clockwise from north: east"
    assert bed.size == pytest.approx((2.0, 1.6, 0.5)), "its front is along the footprint's longer side"
    assert layout.substituted == ("bed-0_bedroom",)
    assert any("footprints" in note for note in layout.notes)
    assert any("other rooms" in note for note in layout.notes)


def test_holodeck_footprint_of_a_thing_that_is_not_turned(tmp_path):
    text = (DATA / "holodeck.json").read_text().replace('"y": 90,', '"y": 0,')
    (tmp_path / "house.json").write_text(text)
    (bed,) = read_layout(tmp_path / "house.json", room="bedroom").scene.placements
    assert bed.yaw == 90.0
    assert bed.size == pytest.approx((1.6, 2.0, 0.5))


def test_holodeck_house_of_several_rooms_asks_which():
    with pytest.raises(InputError, match=r"2 rooms: say which.*bedroom, hall"):
        read_layout(DATA / "holodeck.json")
    hall = read_layout(DATA / "holodeck.json", room="hall").scene
    assert [p.category for p in hall.placements] == ["desk"]
    assert hall.room.walls[hall.room.openings[0].wall].name == "west_wall"


def test_layoutgpt_in_pixels_with_a_known_short_side():
    scene = read_layout(DATA / "layoutgpt.json", room="Bedroom-803", short_side=3.2).scene
    assert scene.room.extent == pytest.approx((3.2, 4.0))
    bed, nightstand, wardrobe = scene.placements
    # Heads are at the top of the page, the north; fronts look down it.
    assert bed.position == pytest.approx((1.6, 3.0, 0.0))
    assert (bed.yaw, nightstand.yaw) == (270.0, 270.0)
    assert bed.size == pytest.approx((2.0, 1.6, 0.9))
    assert nightstand.position[0] < bed.position[0]
    assert nightstand.position[1] > bed.position[1]
    assert wardrobe.yaw == 180.0, "at the east wall, looking west"


def test_layoutgpt_scale_is_guessed_and_said_when_it_is_not_given():
    layout = read_layout(DATA / "layoutgpt.json", room="Bedroom-803")
    assert 2.7 < min(layout.scene.room.extent) < 4.2
    assert any("guessed" in note for note in layout.notes)


def test_layoutgpt_scale_is_one_for_all_rooms_of_a_file(tmp_path):
    rooms = [read_layout(DATA / "layoutgpt.json", room=f"Bedroom-80{n}").scene.room.extent for n in (3, 4)]
    assert rooms[0][0] == pytest.approx(rooms[1][1]), "both are 256 pixels, and nothing in the second is usual"
    assert rooms[0][1] / rooms[1][0] == pytest.approx(320 / 300)
    unusual = json.loads((DATA / "layoutgpt.json").read_text())[1]
    (tmp_path / "one.json").write_text(json.dumps(unusual))
    with pytest.raises(InputError, match="pixels"):
        read_layout(tmp_path / "one.json")


@pytest.mark.parametrize(
    ("depth", "base"), [(35.0, 0.0), (35.5, 0.0), (36.5, 0.0), (37.0, 0.0), (38.0, 2.0), (34.0, -2.0)]
)
def test_layoutgpt_bases_within_a_pixel_of_the_floor_stand_on_it(tmp_path, depth, base):
    text = (DATA / "layoutgpt.json").read_text().replace('"depth": 36.0', f'"depth": {depth}')
    (tmp_path / "layout.json").write_text(text)
    bed = read_layout(tmp_path / "layout.json", room="Bedroom-803", short_side=2.56).scene.placements[0]
    assert bed.position[2] == pytest.approx(base / 100)


def test_layoutgpt_file_of_several_rooms_asks_which():
    with pytest.raises(InputError, match=r"2 layouts: say which.*Bedroom-803, Bedroom-804"):
        read_layout(DATA / "layoutgpt.json")


def test_idesign_mounts_come_from_its_scene_graph():
    layout = read_layout(DATA / "idesign.json")
    scene = layout.scene
    assert _mounts(scene) == ["floor", "floor", "surface", "wall", "ceiling"]
    assert [p.support for p in scene.placements] == ["floor", "floor", "nightstand_1", "west_wall", "ceiling"]
    assert scene["queen_bed_1"].yaw == 270.0, "bearing 180 is south"
    assert scene["painting_1"].yaw == 0.0, "bearing 90 is east"
    assert layout.unplaced == ("bookshelf_1",)


def test_il3d_l_shaped_floor_in_either_rotation():
    layout = read_layout(DATA / "il3d.json")
    scene = layout.scene
    assert scene.room.polygon.area == pytest.approx(14.0)
    assert scene.room.extent == (4.0, 5.0)
    assert not scene.room.polygon.covers(_point(3.0, 1.0)), "the arm that is missing is the south-east one"
    bed, nightstand = scene.placements
    assert bed.yaw == nightstand.yaw == 0.0, "both spellings of a quarter turn"
    assert bed.position == pytest.approx((1.1, 4.1, 0.0))
    assert bed.size == pytest.approx((2.0, 1.6, 0.5)), "the box times the scale"
    assert nightstand.position == pytest.approx((1.0, 1.0, 0.0))
    assert nightstand.size == pytest.approx((0.4, 0.5, 0.5))


def _point(x, y):
    from shapely import Point

    return Point(x, y)


def test_il3d_as_its_generator_writes_it(tmp_path):
    text = (
        '{"meshes": {"xyz": [[4, 0, 3], [4, 0, 0], [0, 0, 3], [0, 0, 0]]}, "objects": {"Chairs": ['
        '{"object_name": "infer_c", "path": "3D-FRONT/Chairs/chair.usdz", "position": [1, 0, 1],'
        ' "rotation": [0, 0, 0]}]}}'
    )
    path = tmp_path / "scene.json"
    path.write_text(text)
    with pytest.raises(InputError, match=r"has no size.*chair\.usdz.*\$\.objects\.Chairs\[0\]"):
        read_layout(path)
    layout = read_layout(path, assets=DATA)
    (chair,) = layout.scene.placements
    assert (chair.yaw, chair.category, layout.substituted) == (270.0, "chairs", ())
    assert chair.position == pytest.approx((1.0, 2.0, 0.0))


def test_what_hangs_on_a_wall_is_not_judged_by_a_front_that_no_layout_gives(tmp_path):
    room, other = tmp_path / "room", tmp_path / "other"
    for folder in (room, other):
        shutil.copytree(DATA / "layoutvlm", folder)
    poses = json.loads((room / "layout.json").read_text())
    poses["painting-0"]["rotation"][2] += 180.0
    (other / "layout.json").write_text(json.dumps(poses))
    for layout in (read_layout(folder / "layout.json") for folder in (room, other)):
        verdict = next(v for v in verify(layout.scene).objects if v.id == "painting-0")
        assert "faces_wall" not in verdict.reasons
        assert any("has its front to the room is not judged" in note for note in layout.notes)
    assert not any("front" in note for note in read_layout(DATA / "layoutgpt.json", room="Bedroom-803").notes)


def test_layoutvlm_poses_find_their_scene_file_beside_them():
    layout = read_layout(DATA / "layoutvlm" / "layout.json")
    scene = layout.scene
    assert layout.format == "layoutvlm"
    assert _mounts(scene) == ["floor", "wall", "floor"]
    assert scene["painting-0"].support == "east_wall"
    assert layout.unplaced == ("chair-0",)
    assert any("scene.json" in note for note in layout.notes)
    assert not scene.asset_of(scene["rug-0"]).collides, "a rug is walked on"
    assert scene.asset_of(scene["bed-0"]).collides


def test_layoutvlm_poses_alone_are_refused(tmp_path):
    shutil.copy(DATA / "layoutvlm" / "layout.json", tmp_path / "layout.json")
    with pytest.raises(InputError, match="poses alone"):
        read_layout(tmp_path / "layout.json")


def test_layoutvlm_benchmark_scene_takes_its_records_from_the_assets(tmp_path):
    record = (
        '{"annotations": {"category": "Arm Chair", "onFloor": true, "onWall": false, "onCeiling": false,'
        ' "onObject": false}, "assetMetadata": {"boundingBox": {"x": 0.6, "y": 0.8, "z": 0.9}}}'
    )
    (tmp_path / "elsewhere" / "u1").mkdir(parents=True)
    (tmp_path / "elsewhere" / "u1" / "data.json").write_text(record)
    (tmp_path / "scene.json").write_text(
        '{"boundary": {"floor_vertices": [[0,0,0],[4,0,0],[4,5,0],[0,5,0]], "wall_height": 1.8},'
        ' "assets": {"u1-0": {}, "u1-1": {}}}'
    )
    (tmp_path / "layout.json").write_text(
        '{"arm_chair-0": {"position": [1, 1, 0.45], "rotation": [0, 0, 0]},'
        ' "arm_chair-1": {"position": [3, 3, 0.45], "rotation": [0, 0, 90]}}'
    )
    with pytest.raises(InputError, match="only uids"):
        read_layout(tmp_path / "layout.json")
    scene = read_layout(tmp_path / "layout.json", assets=tmp_path / "elsewhere").scene
    assert [p.size for p in scene.placements] == [(0.8, 0.6, 0.9)] * 2, "data.json's y is along the front"


def test_sceneeval_with_its_holes_and_a_mesh_that_is_found():
    with pytest.raises(InputError, match=r"1 of 1 meshes were not found.*objaverse\.sofa"):
        _sceneeval_with("sofa")
    layout = read_layout(DATA / "sceneeval.json")
    (chair,) = layout.scene.placements
    assert chair.yaw == 180.0, "the third column says where the mesh's +z goes: west"
    assert chair.position == pytest.approx((3.0, 2.7, 0.0))
    door, window = layout.scene.room.openings
    room = layout.scene.room
    assert room.walls[door.wall].name == "west_wall"
    assert sorted(room.walls[door.wall].point(a)[1] for a in (door.offset, door.offset + door.width)) == pytest.approx(
        [3.0, 3.9]
    )
    east = room.walls[window.wall]
    assert sorted(east.point(a)[1] for a in (window.offset, window.offset + window.width)) == pytest.approx([4.5, 5.5])


def _sceneeval_with(model):
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.json"
        path.write_text((DATA / "sceneeval.json").read_text().replace("objaverse.chair", f"objaverse.{model}"))
        return read_layout(path)


def test_a_rotation_that_is_no_yaw_goes_into_the_shapes():
    """A mirror of 1 m turned about its own x, as Holodeck lays thin things down: what was its height lies north."""
    layout = _holodeck_with('{"x": 90, "y": 0, "z": 0}', y=0.03)
    (thing,) = layout.scene.placements
    assert thing.size == pytest.approx((0.5, 1.0, 0.06))
    assert thing.position[2] == pytest.approx(0.0)
    shapes = layout.scene.asset_of(thing).links[0].shapes
    assert np.ptp(np.array(shapes[0].points), axis=0) == pytest.approx((0.5, 1.0, 0.06))


def _holodeck_with(rotation, y):
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "house.json"
        path.write_text(
            '{"wall_height": 2.5, "rooms": [{"id": "r", "floorPolygon": [{"x":0,"y":0,"z":0},{"x":4,"y":0,"z":0},'
            '{"x":4,"y":0,"z":4},{"x":0,"y":0,"z":4}]}], "objects": [{"id": "mirror", "assetId": "m",'
            f' "position": {{"x": 2, "y": {y}, "z": 2}}, "rotation": {rotation}}}]}}'
        )
        (Path(folder) / "annotations.json").write_text(
            '{"m": {"assetMetadata": {"boundingBox": {"x": 0.5, "y": 1.0, "z": 0.06}}}}'
        )
        return read_layout(path)


def test_masses_are_those_of_the_usual_thing_and_names_are_kept():
    scene = read_layout(DATA / "idesign.json").scene
    masses = {p.id: scene.asset_of(p).mass for p in scene.placements}
    assert 30 < masses["queen_bed_1"] < 120
    assert 5 < masses["nightstand_1"] < 20
    assert scene.asset_of(scene["lamp_1"]).description == "lamp_1"


def test_what_floats_is_left_floating(tmp_path):
    text = (DATA / "layoutvlm" / "scene.json").read_text()
    (tmp_path / "scene.json").write_text(text)
    (tmp_path / "layout.json").write_text('{"chair-0": {"position": [2, 2, 1.2], "rotation": [0, 0, 0]}}')
    (chair,) = read_layout(tmp_path / "layout.json").scene.placements
    assert chair.position[2] == pytest.approx(0.75)
    assert chair.support == "floor"


def test_the_same_file_gives_the_same_bytes():
    from thinkblox.value import to_json

    assert to_json(read_layout(DATA / "sceneeval.json")) == to_json(read_layout(DATA / "sceneeval.json"))


def test_naming_the_formats_loads_no_engine_and_no_mesh_library():
    code = (
        "import sys, thinkblox.importing as i; i.FORMATS; "
        "print(sorted({'mujoco', 'trimesh', 'coacd', 'fcl', 'pxr', 'manifold3d'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def _json(path, value):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(value))
    return path


@pytest.mark.parametrize(("height", "flat"), [(0.02, True), (0.1, True), (0.12, True), (0.15, False)])
def test_a_carpet_of_ten_centimetres_is_walked_on(tmp_path, height, flat):
    graph = json.loads((DATA / "idesign.json").read_text())
    sofa = {
        "new_object_id": "sofa_1", "size_in_meters": {"length": 1.6, "width": 0.8, "height": 0.8},
        "rotation": {"z_angle": 0.0}, "is_on_the_floor": True, "position": {"x": 2.0, "y": 2.5, "z": 0.4},
    }  # fmt: skip
    carpet = sofa | {
        "new_object_id": "carpet_1", "size_in_meters": {"length": 2.0, "width": 1.5, "height": height},
        "position": {"x": 2.0, "y": 2.5, "z": height / 2},
    }  # fmt: skip
    walls = [part for part in graph if part["new_object_id"].endswith("_wall")]
    scene = read_layout(_json(tmp_path / "graph.json", [sofa, carpet, *walls])).scene
    assert scene.asset_of(scene["carpet_1"]).collides != flat


def test_idesign_without_walls_needs_the_size_of_its_room(tmp_path):
    graph = [part for part in json.loads((DATA / "idesign.json").read_text()) if "itemType" not in part]
    path = _json(tmp_path / "graph.json", graph)
    with pytest.raises(InputError, match="give the room's size"):
        read_layout(path)
    room = read_layout(path, room_size=(4.0, 5.0)).scene.room
    assert (room.extent, room.height) == ((4.0, 5.0), 2.6)
    assert read_layout(path, room_size=(4.0, 5.0, 3.0)).scene.room.height == 3.0
    for wrong in ((4.0,), (4.0, -1.0), (4.0, 5.0, 2.0, 1.0), (float("nan"), 2.0)):
        with pytest.raises(InputError, match="two or three lengths"):
            read_layout(path, room_size=wrong)


def test_metaspatial_answers_find_their_scene_graph_beside_them(tmp_path):
    graph = json.loads((DATA / "idesign.json").read_text())
    answer = _json(tmp_path / "answer.json", [{"new_object_id": "queen_bed_1", "x": 1.5, "y": 1.25, "z": 0.3}])
    with pytest.raises(InputError, match=r"positions alone.*there is none"):
        read_layout(answer)
    _json(tmp_path / "scene_graph-backtracked.json", graph)
    layout = read_layout(answer)
    whole = read_layout(DATA / "idesign.json").scene
    (bed,) = layout.scene.placements
    assert bed.position[:2] == (1.5, 1.25)
    assert (bed.size, bed.yaw) == (whole["queen_bed_1"].size, whole["queen_bed_1"].yaw)
    assert set(layout.unplaced) >= {"nightstand_1", "lamp_1"}
    _json(answer, [{"new_object_id": "tub_1", "x": 1.5, "y": 1.25, "z": 0.3}])
    with pytest.raises(InputError, match=r"holds no 'tub_1' - at `\$\[0\]`"):
        read_layout(answer)


def test_layoutvlm_tasks_without_records_take_a_table_of_sizes(tmp_path):
    _json(
        tmp_path / "scene.json",
        {
            "boundary": {"floor_vertices": [[0, 0, 0], [4, 0, 0], [4, 5, 0], [0, 5, 0]]},
            "assets": {"u1-0": {}, "u2-0": {}},
        },
    )
    poses = {"arm_chair-0": {"position": [1, 1, 0.45], "rotation": [0, 0, 0]}}
    path = _json(tmp_path / "layout.json", poses | {"bed-0": {"position": [3, 3, 0.5], "rotation": [0, 0, 90]}})
    with pytest.raises(InputError, match="table of sizes"):
        read_layout(path)
    sizes = _json(tmp_path / "tables" / "sizes.json", {"arm_chair": [0.8, 0.6, 0.9], "bed-0": [2.0, 1.6, 1.0]})
    layout = read_layout(path, sizes=sizes)
    assert [p.size for p in layout.scene.placements] == [(0.8, 0.6, 0.9), (2.0, 1.6, 1.0)]
    assert [p.position[2] for p in layout.scene.placements] == pytest.approx([0.0, 0.0])
    assert read_layout(tmp_path / "scene.json", sizes=sizes).unplaced == ("u1-0", "u2-0"), (
        "the task alone places nothing"
    )
    _json(sizes, {"arm_chair": [0.8, 0.6, 0.9]})
    with pytest.raises(InputError, match="'bed-0' has no size"):
        read_layout(path, sizes=sizes)


@pytest.mark.parametrize(
    "table", [[1, 2, 3], {"bed": 2.0}, {"bed": [1.0, 2.0]}, {"bed": [1.0, 0.0, 1.0]}, {"bed": [1, 1, 1e9]}]
)
def test_a_table_that_holds_no_sizes_is_refused(tmp_path, table):
    sizes = _json(tmp_path / "sizes.json", table)
    with pytest.raises(InputError, match=r"sizes\.json"):
        read_layout(DATA / "idesign.json", sizes=sizes)


def test_sceneeval_without_meshes_is_boxes_of_its_annotations(tmp_path):
    state = json.loads((DATA / "sceneeval.json").read_text())
    (thing,) = state["scene"]["object"]
    for model, box in (
        ("objaverse.u", {"x": 0.5, "y": 0.9, "z": 0.6}),
        ("layoutvlm-objaverse.u", {"x": 0.5, "y": 0.6, "z": 0.9}),
    ):
        thing["modelId"] = model
        path = _json(tmp_path / model / "scene.json", state)
        _json(tmp_path / model / "u" / "data.json", {"assetMetadata": {"boundingBox": box}, "category": "chair"})
        layout = read_layout(path)
        (chair,) = layout.scene.placements
        assert layout.substituted == (chair.id,)
        assert chair.size == pytest.approx((0.6, 0.5, 0.9)), "along the front, across, up"
        assert chair.yaw == 180.0
        assert chair.position[2] == pytest.approx(0.0)
    thing["modelId"] = "objaverse.v"
    path = _json(tmp_path / "v.json", state)
    (chair,) = read_layout(path, sizes=_json(tmp_path / "sizes.json", {"v": [0.6, 0.5, 0.9]})).scene.placements
    assert chair.size == pytest.approx((0.6, 0.5, 0.9))
