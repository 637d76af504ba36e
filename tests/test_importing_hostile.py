"""Layouts that are wrong: an InputError that names the file and the place, and nothing else."""

import copy
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from tests.layout_rooms import BEDROOM, WRITERS, write
from thinkblox.errors import InputError
from thinkblox.importing import FORMATS, detect, read_layout
from thinkblox.importing.layout import ForeignLayout
from thinkblox.importing.library import Library

DATA = Path(__file__).parent / "data" / "layouts"
BOXED = [f for f in FORMATS if f not in ("metaspatial", "sceneeval")]


def _refused(path, match, **options):
    with pytest.raises(InputError, match=match) as caught:
        read_layout(path, **options)
    assert path.name in str(caught.value)
    return str(caught.value)


def _written(tmp_path, text):
    path = tmp_path / "room.json"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


@pytest.mark.parametrize(
    ("text", "match"),
    [
        ("", "not JSON"),
        ("{", "not JSON"),
        (b"\xff\xfe\x00", "is not UTF-16"),
        (b'{"a": "\xff"}', "not UTF-8"),
        ("[" * 100_000, "nested too deeply"),
        ('{"a": NaN}', "NaN is not a number"),
        ('{"a": -Infinity}', "not a number"),
        ('{"a": 1e999}', "is no length"),
        ('{"a": ' + "9" * 400 + "}", "400 digits"),
        ('{"a": 1, "a": 2}', "'a' stands twice"),
        ("[]", r"no layout that is read.*--format.*holodeck.*layoutgpt"),
        ("{}", "--format"),
        ("null", "--format"),
        ('{"room": {"floor": []}}', "--format"),
    ],
)
def test_files_that_are_no_layout(tmp_path, text, match):
    _refused(_written(tmp_path, text), match)


def test_a_file_that_is_not_there(tmp_path):
    _refused(tmp_path / "gone.json", "cannot be read")
    _refused(tmp_path, "cannot be read")


def test_a_file_with_the_keys_of_two_formats(tmp_path):
    both = WRITERS["layoutvlm"](BEDROOM) | {"format": "sceneState"}
    message = _refused(_written(tmp_path, json.dumps(both)), "layoutvlm and sceneeval")
    assert message.endswith("--format, one of layoutvlm, sceneeval")
    assert read_layout(tmp_path / "room.json", format="layoutvlm").format == "layoutvlm"
    with pytest.raises(InputError, match="--format"):
        detect(both)


def test_options_that_cannot_be(tmp_path):
    path = write(tmp_path, "layoutvlm")
    with pytest.raises(InputError, match="no layout format 'vlm'; there are holodeck"):
        read_layout(path, format="vlm")
    with pytest.raises(InputError, match="is no folder"):
        read_layout(path, assets=tmp_path / "gone")
    with pytest.raises(InputError, match="m high"):
        read_layout(path, height=0.1)
    with pytest.raises(InputError, match="short side"):
        read_layout(path, short_side=-1.0)


@pytest.mark.parametrize("format", FORMATS)
def test_a_document_of_another_format_is_told_what_is_missing(tmp_path, format):
    other = "layoutvlm" if format != "layoutvlm" else "layoutgpt"
    _refused(write(tmp_path, other), r"`\$", format=format)


SIZES = {
    "layoutvlm": ("assets", "bed-0", "assetMetadata", "boundingBox", "x"),
    "idesign": (0, "size_in_meters", "length"),
    "layoutgpt": (0, "object_list", 0, 1, "length"),
    "il3d": ("objects", 0, "bbox", 0),
}
POSITIONS = {
    "layoutvlm": ("layout", "bed-0", "position", 0),
    "idesign": (0, "position", "x"),
    "layoutgpt": (0, "object_list", 0, 1, "left"),
    "il3d": ("objects", 0, "position", 0),
    "holodeck": ("objects", 0, "position", "x"),
    "sceneeval": ("scene", "object", 0, "transform", "data", 12),
}
TURNS = {
    "layoutvlm": ("layout", "bed-0", "rotation", 2),
    "idesign": (0, "rotation", "z_angle"),
    "layoutgpt": (0, "object_list", 0, 1, "orientation"),
    "il3d": ("objects", 0, "rotation", 1),
    "holodeck": ("objects", 0, "rotation", "y"),
}


def _with(tmp_path, format, place, value):
    path = write(tmp_path, format)
    raw = json.loads(path.read_text())
    target = raw
    for key in place[:-1]:
        target = target[key]
    if value is None:
        del target[place[-1]]
    else:
        target[place[-1]] = value
    path.write_text(json.dumps(raw))
    return path


@pytest.mark.parametrize("value", [0.0, -1.0, 2000.0, 1e12, "1.6", [1.6]])
@pytest.mark.parametrize("format", SIZES)
def test_sizes_that_no_furniture_has(tmp_path, format, value):
    if format == "layoutgpt" and value == 2000.0:
        pytest.skip("pixels may be many; metres are looked at when they are known")
    message = _refused(_with(tmp_path, format, SIZES[format], value), r"`\$", format=format)
    assert str(SIZES[format][-1]) in message


def test_kilometres_in_layoutgpt(tmp_path):
    _refused(_with(tmp_path, "layoutgpt", SIZES["layoutgpt"], 2000.0), r"'bed_0' measures.*object_list\[0\]")


@pytest.mark.parametrize("value", [1e7, "here", True, [], {}])
@pytest.mark.parametrize("format", POSITIONS)
def test_positions_that_no_room_has(tmp_path, format, value):
    _refused(_with(tmp_path, format, POSITIONS[format], value), r"`\$", format=format)


@pytest.mark.parametrize("value", ["east", 1e9, False])
@pytest.mark.parametrize("format", TURNS)
def test_rotations_that_are_no_angle(tmp_path, format, value):
    _refused(_with(tmp_path, format, TURNS[format], value), r"`\$", format=format)


@pytest.mark.parametrize(
    ("format", "place", "match"),
    [
        ("layoutvlm", ("boundary",), "boundary"),
        ("layoutvlm", ("boundary", "floor_vertices"), "floor_vertices"),
        ("layoutvlm", ("layout", "bed-0", "position"), "position"),
        ("idesign", (0, "size_in_meters", "height"), "height"),
        ("idesign", (0, "rotation"), "rotation"),
        ("idesign", (5, "new_object_id"), "new_object_id"),
        ("layoutgpt", (0, "prompt"), "prompt"),
        ("layoutgpt", (0, "object_list", 0, 1, "depth"), "depth"),
        ("il3d", ("objects", 0, "position"), "position"),
        ("il3d", ("objects", 0, "bbox"), "has no size"),
        ("holodeck", ("rooms", 0, "id"), "id"),
        ("holodeck", ("objects", 0, "position"), "position"),
        ("sceneeval", ("scene", "arch"), "arch"),
        ("sceneeval", ("scene", "object", 0, "transform"), "transform"),
    ],
)
def test_missing_keys(tmp_path, format, place, match):
    _refused(_with(tmp_path, format, place, None), match + r".*`\$", format=format)


FLOORS = {
    "layoutvlm": ("boundary", "floor_vertices"),
    "holodeck": ("rooms", 0, "floorPolygon"),
    "il3d": ("meshes", 0, "xyz"),
    "sceneeval": ("scene", "arch", "elements", 0, "points"),
}


def _corner(format, x, y):
    return {"x": x, "y": 0.0, "z": y} if format == "holodeck" else [x, 0.0, y] if format == "il3d" else [x, y, 0.0]


@pytest.mark.parametrize(
    ("corners", "match"),
    [
        ([], "corners"),
        ([(0, 0), (4, 0)], "corners"),
        ([(0, 0), (4, 5), (4, 0), (0, 5)], "simple polygon"),
        ([(0, 0), (4, 0), (4, 0), (0, 5)], "closer than 1 cm"),
        ([(0, 0), (400, 0), (400, 500), (0, 500)], "must be 0.5 to 100 m"),
        ([(0, 0), (0.04, 0), (0.04, 0.05), (0, 0.05)], "must be 0.5 to 100 m"),
        ([(0, 0), (2, 0), (4, 0)], "polygon|area|m by"),
    ],
)
@pytest.mark.parametrize("format", [f for f in FLOORS if f != "il3d"])
def test_floors_that_are_no_room(tmp_path, format, corners, match):
    floor = [_corner(format, x, y) for x, y in corners]
    _refused(_with(tmp_path, format, FLOORS[format], floor), f"{match}.*`\\$", format=format)


@pytest.mark.parametrize(("corners", "match"), [([], "corners"), ([(0, 0), (4, 0)], "corners")])
def test_il3d_floors_that_are_no_room(tmp_path, corners, match):
    floor = [_corner("il3d", x, y) for x, y in corners]
    _refused(_with(tmp_path, "il3d", FLOORS["il3d"], floor), f"{match}.*`\\$")


def test_il3d_floors_of_bad_faces(tmp_path):
    _refused(_with(tmp_path, "il3d", ("meshes", 0, "faces"), [[0, 1, 9]]), "does not exist")
    _refused(_with(tmp_path, "il3d", ("meshes", 0, "faces"), [[0, 0, 0]]), "one piece")


def test_clockwise_floors_are_turned_round_and_said(tmp_path):
    raw = WRITERS["layoutvlm"](BEDROOM)
    raw["boundary"]["floor_vertices"].reverse()
    layout = read_layout(_written(tmp_path, json.dumps(raw)))
    assert layout.scene.room.polygon.exterior.is_ccw
    assert any("clockwise" in note for note in layout.notes)
    straight = read_layout(write(tmp_path, "layoutvlm"))
    assert [p.position for p in layout.scene.placements] == [p.position for p in straight.scene.placements]


def test_floors_are_shifted_to_the_origin_with_what_is_on_them(tmp_path):
    raw = WRITERS["layoutvlm"](BEDROOM)
    for corner in raw["boundary"]["floor_vertices"]:
        corner[:] = [corner[0] - 7.5, corner[1] + 3.25, 1.5]
    for pose in raw["layout"].values():
        x, y, z = pose["position"]
        pose["position"] = [x - 7.5, y + 3.25, z + 1.5]
    moved = read_layout(_written(tmp_path, json.dumps(raw))).scene
    still = read_layout(write(tmp_path, "layoutvlm")).scene
    for a, b in zip(moved.placements, still.placements, strict=True):
        assert a.position == pytest.approx(b.position)
    assert moved.room == still.room


def test_two_objects_of_one_id(tmp_path):
    raw = WRITERS["idesign"](BEDROOM)
    raw[1]["new_object_id"] = "bed_1"
    _refused(_written(tmp_path, json.dumps(raw)), r"second object 'bed_1', as at `\$\[0\]`.*`\$\[1\]`")
    text = json.dumps(WRITERS["layoutvlm"](BEDROOM)).replace("desk-0", "bed-0")
    _refused(_written(tmp_path, text), "'bed-0' stands twice")
    raw = WRITERS["holodeck"](BEDROOM, tmp_path)
    raw["objects"][1]["id"] = raw["objects"][0]["id"]
    _refused(_written(tmp_path, json.dumps(raw)), "second object")


def test_names_that_are_no_ids_are_made_to_fit(tmp_path):
    raw = WRITERS["idesign"](BEDROOM)
    names = ["../../etc/passwd", "沙发", "north wall", "north_wall_", "a\x00b\nc\ud800"]
    for entry, name in zip(raw, names, strict=False):
        entry["new_object_id"] = name
    layout = read_layout(_written(tmp_path, json.dumps(raw)))
    ids = [p.id for p in layout.scene.placements]
    assert ids == ["etc_passwd", "object", "north_wall_2", "north_wall_3", "a_b_c"]
    descriptions = [layout.scene.asset_of(p).description for p in layout.scene.placements]
    assert descriptions[1] == "沙发"
    assert "\x00" not in descriptions[4]


def test_an_opening_that_is_nowhere_is_left_out_and_said(tmp_path):
    house = json.loads((DATA / "holodeck.json").read_text())
    house["windows"].append(dict(copy.deepcopy(house["windows"][0]), id="again"))
    house["windows"][0]["holePolygon"][1]["y"] = 9.0
    layout = read_layout(_written(tmp_path, json.dumps(house)), room="bedroom")
    assert [o.height for o in layout.scene.room.openings if o.kind == "window"] == pytest.approx([1.7])
    assert any("'again' was left out" in note and "overlap" in note for note in layout.notes)
    house["walls"][2]["segment"] = [[16, 5], [16, 1]]
    layout = read_layout(_written(tmp_path, json.dumps(house)), room="bedroom")
    assert any("in no wall" in note for note in layout.notes)


def _vlm_with_path(tmp_path, mesh):
    raw = WRITERS["layoutvlm"](BEDROOM)
    raw["assets"]["bed-0"]["path"] = mesh
    return _written(tmp_path, json.dumps(raw))


def test_a_mesh_outside_the_folders_is_not_opened(tmp_path):
    trimesh.creation.box((2, 0.5, 2)).export(tmp_path / "outside.glb")
    folder = tmp_path / "layout"
    folder.mkdir()
    _refused(_vlm_with_path(folder, "../outside.glb"), r"leads out of.*assets\.bed-0\.path")
    layout = read_layout(_vlm_with_path(folder, str(tmp_path / "outside.glb")))
    assert "bed-0" in layout.substituted
    (folder / "link.glb").symlink_to(tmp_path / "outside.glb")
    assert "bed-0" in read_layout(_vlm_with_path(folder, "link.glb")).substituted
    (folder / "inside.glb").write_bytes((tmp_path / "outside.glb").read_bytes())
    assert "bed-0" not in read_layout(_vlm_with_path(folder, "inside.glb")).substituted


def test_a_pickle_is_never_opened(tmp_path):
    (tmp_path / "bed").mkdir()
    (tmp_path / "bed" / "bed.pkl.gz").write_bytes(b"not even gzip")
    assert "bed-0_bedroom" in read_layout(write(tmp_path, "holodeck")).substituted


def test_a_flat_mesh_becomes_a_box_where_a_size_is_given(tmp_path):
    plane = trimesh.Trimesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]], process=False)
    plane.export(tmp_path / "flat.glb")
    layout = read_layout(_vlm_with_path(tmp_path, "flat.glb"))
    assert "bed-0" in layout.substituted
    assert any("no volume" in note and "flat.glb" in note for note in layout.notes)
    path = write(tmp_path, "sceneeval")
    plane.export(tmp_path / "bed" / "bed.glb")
    _refused(path, r"no volume.*scene\.object\[0\]")


def test_a_mesh_in_millimetres_is_found_out(tmp_path):
    trimesh.creation.box((1600, 500, 2000)).export(tmp_path / "mm.stl")
    _refused(_vlm_with_path(tmp_path, "mm.stl"), "millimetres")


def test_a_broken_mesh_is_no_reason_for_a_box(tmp_path):
    (tmp_path / "bad.glb").write_bytes(b"glTF")
    with pytest.raises(InputError, match=r"bad\.glb"):
        read_layout(_vlm_with_path(tmp_path, "bad.glb"))


def test_a_mesh_that_differs_from_the_given_size_is_said(tmp_path):
    trimesh.creation.box((1.6, 0.5, 1.0)).export(tmp_path / "short.glb")
    layout = read_layout(_vlm_with_path(tmp_path, "short.glb"))
    assert any("the layout says 2 x 1.6 x 0.5 m, its mesh measures 1 x 1.6 x 0.5 m" in note for note in layout.notes)
    assert layout.scene["bed-0"].size == pytest.approx((1.0, 1.6, 0.5))


def test_too_many_objects(tmp_path):
    raw = WRITERS["layoutgpt"](BEDROOM)
    raw[0]["object_list"] *= 401
    _refused(_written(tmp_path, json.dumps(raw)), "2005 objects; at most 2000")


def test_the_mesh_of_one_name_is_looked_for_once(tmp_path, monkeypatch):
    looked = []
    monkeypatch.setattr(Library, "_under", lambda self, relative: looked.append(relative))
    library = Library(roots=(tmp_path,))
    assert [library.asset("bed_1") for _ in range(3)] == [None] * 3
    assert len(looked) == len(set(looked)) > 0


def test_transforms_that_are_none(tmp_path):
    place = ("scene", "object", 0, "transform", "data")
    _refused(_with(tmp_path, "sceneeval", place, [0.0] * 16), "last row")
    _refused(_with(tmp_path, "sceneeval", place, [0.0] * 15 + [1.0]), "flattens")
    _refused(_with(tmp_path, "sceneeval", place, [1.0] * 12), "data")
    _refused(_with(tmp_path, "sceneeval", ("scene", "up"), [0, 1, 0]), "up is")
    _refused(_with(tmp_path, "il3d", ("objects", 0, "rotation"), [0, 0, 0, 0]), "quaternion")


def test_errors_of_a_mesh_name_file_object_and_mesh(tmp_path):
    path = write(tmp_path, "idesign")
    (tmp_path / "bed_1.glb").write_bytes(b"glTF is not this")
    message = _refused(path, "the mesh of 'bed_1'.*bed_1.glb")
    assert "`$[0]`" in message


def test_a_piece_without_volume_names_file_object_and_mesh(tmp_path, monkeypatch):
    path = write(tmp_path, "idesign")
    flat = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
    monkeypatch.setattr("thinkblox.importing.body.convex_pieces", lambda mesh: (flat, flat + np.array([0.0, 0.0, 1.0])))
    trimesh.creation.box((1, 1, 1)).export(tmp_path / "bed_1.glb")
    message = _refused(path, "'bed_1' of .*bed_1.glb: ")
    assert "`$[0]`" in message


# --- fuzzing: any document gives a ForeignLayout or an InputError ----------------------------------------------------

ODD: st.SearchStrategy[Any] = st.sampled_from(
    [None, True, 0, -1, 1e-9, 1e6, 1e17, "", "x", "../x", "\u0000", [], {}, [[]], [1], {"x": 1}]
)
JSON = st.recursive(
    ODD | st.floats(allow_nan=True) | st.integers() | st.text(max_size=8),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=8), inner, max_size=4),
    max_leaves=12,
)
FUZZ = settings(
    max_examples=300, deadline=None, phases=(Phase.explicit, Phase.generate), suppress_health_check=list(HealthCheck)
)


def _only_layouts_and_input_errors(path, format):
    try:
        layout = read_layout(path, format=format, short_side=3.0)
    except InputError:
        return
    assert isinstance(layout, ForeignLayout)
    for placement in layout.scene.placements:
        assert np.isfinite([*placement.position, placement.yaw, *placement.size]).all()


def _places(value, at=()):
    yield at
    if isinstance(value, dict):
        for key in value:
            yield from _places(value[key], (*at, key))
    elif isinstance(value, list):
        for index in range(len(value)):
            yield from _places(value[index], (*at, index))


def _mutated(raw, draw):
    for _ in range(draw(st.integers(1, 3))):
        *above, key = draw(st.sampled_from([place for place in _places(raw) if place]))
        target = raw
        for step in above:
            target = target[step]
        action = draw(st.sampled_from(["replace", "remove", "double"]))
        if action == "remove":
            del target[key]
        elif action == "double" and isinstance(target, list):
            target.insert(key, copy.deepcopy(target[key]))
        else:
            target[key] = copy.deepcopy(draw(JSON))
        if not raw:
            break
    return raw


@pytest.mark.slow
@pytest.mark.parametrize("format", FORMATS)
@FUZZ
@given(data=st.data())
def test_mutated_documents(tmp_path_factory, format, data):
    folder = tmp_path_factory.mktemp("fuzz")
    path = write(folder, format)
    path.write_text(json.dumps(_mutated(json.loads(path.read_text()), data.draw)))
    _only_layouts_and_input_errors(path, format)


@pytest.mark.slow
@pytest.mark.parametrize("format", [None, *FORMATS])
@FUZZ
@given(data=st.binary(max_size=200) | JSON.map(lambda value: json.dumps(value).encode()))
def test_random_documents(tmp_path_factory, format, data):
    path = tmp_path_factory.mktemp("fuzz") / "random.json"
    path.write_bytes(data)
    _only_layouts_and_input_errors(path, format)


@pytest.mark.slow
@pytest.mark.parametrize("suffix", ["glb", "gltf", "obj", "stl", "ply"])
@FUZZ
@given(data=st.data())
def test_mutated_meshes(tmp_path_factory, suffix, data):
    from tests.layout_rooms import chair_mesh
    from thinkblox.assets.mesh_file import read_triangles

    folder = tmp_path_factory.mktemp("mesh")
    chair_mesh().export(folder / f"whole.{'glb' if suffix == 'gltf' else suffix}")
    raw = bytearray(next(folder.glob("whole.*")).read_bytes())
    for _ in range(data.draw(st.integers(1, 8))):
        raw[data.draw(st.integers(0, len(raw) - 1))] = data.draw(st.integers(0, 255))
    path = folder / f"mesh.{suffix}"
    path.write_bytes(bytes(raw[: data.draw(st.integers(1, len(raw)))]) if data.draw(st.booleans()) else bytes(raw))
    try:
        mesh = read_triangles(path)
    except InputError:
        return
    assert np.isfinite(mesh.vertices).all()
