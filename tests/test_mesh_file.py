"""Mesh files: the four kinds, and everything that is refused."""

import json
import struct

import numpy as np
import pytest
import trimesh
from manifold3d import Manifold, OpType

from tests.layout_rooms import chair_mesh
from thinkblox.assets.components import components, welded
from thinkblox.assets.decompose import FlatMeshError, convex_pieces, is_convex
from thinkblox.assets.imported import hull_shape
from thinkblox.assets.mesh_file import MAX_TRIANGLES, MeshFile, read_triangles
from thinkblox.errors import InputError


def _triangles(mesh):
    return MeshFile(np.asarray(mesh.vertices, float), np.asarray(mesh.faces, np.int64))


@pytest.mark.parametrize("suffix", ["glb", "gltf", "obj", "stl", "ply"])
def test_every_kind_of_file_gives_the_same_shape(tmp_path, suffix):
    path = tmp_path / f"chair.{suffix}"
    if suffix == "gltf":
        for name, data in trimesh.exchange.gltf.export_gltf(trimesh.Scene(chair_mesh())).items():
            (tmp_path / ("chair.gltf" if name == "model.gltf" else name)).write_bytes(data)
    else:
        chair_mesh().export(path)
    mesh = read_triangles(path)
    assert mesh.bounds == pytest.approx(chair_mesh().bounds, abs=1e-6)
    assert len(mesh.faces) == len(chair_mesh().faces)
    assert len(convex_pieces(mesh)) == 3


def test_nodes_of_a_scene_are_put_where_they_belong(tmp_path):
    scene = trimesh.Scene()
    box = trimesh.creation.box((1, 1, 1))
    scene.add_geometry(box, geom_name="box", node_name="a")
    scene.add_geometry(
        box, geom_name="box", node_name="b", transform=trimesh.transformations.translation_matrix((3, 0, 0))
    )
    scene.export(tmp_path / "two.glb")
    mesh = read_triangles(tmp_path / "two.glb")
    assert mesh.bounds.tolist() == [[-0.5, -0.5, -0.5], [3.5, 0.5, 0.5]]
    assert len(components(welded(mesh))) == 2


def _refused(path, match):
    with pytest.raises(InputError, match=match) as caught:
        read_triangles(path)
    assert path.name in str(caught.value)


def test_other_kinds_of_file_are_refused(tmp_path):
    for name in ("asset.pkl.gz", "asset.fbx", "asset"):
        (tmp_path / name).write_bytes(b"\x80\x04K\x01.")
        _refused(tmp_path / name, r"not read; meshes are \.glb")
    _refused(tmp_path / "gone.obj", "cannot be read")


@pytest.mark.parametrize("suffix", [".glb", ".gltf", ".obj", ".stl", ".ply"])
@pytest.mark.parametrize(
    "data", [b"", b"\x00", b"{}", b"[]", b"null", b"glTF\x02\x00\x00\x00", b"ply\n", b"f 1 2 3\n" * 3]
)
def test_broken_and_empty_files_are_refused(tmp_path, suffix, data):
    path = tmp_path / f"broken{suffix}"
    path.write_bytes(data)
    with pytest.raises(InputError, match="broken"):
        read_triangles(path)


def test_a_cut_off_file_is_refused(tmp_path):
    chair_mesh().export(tmp_path / "chair.glb")
    data = (tmp_path / "chair.glb").read_bytes()
    (tmp_path / "cut.glb").write_bytes(data[: len(data) // 2])
    _refused(tmp_path / "cut.glb", "broken")


def test_five_million_triangles_are_refused_by_the_header(tmp_path):
    count = 5_000_000
    (tmp_path / "big.stl").write_bytes(bytes(80) + struct.pack("<I", count) + bytes(50 * count))
    _refused(tmp_path / "big.stl", f"has {count} triangles")
    (tmp_path / "big.ply").write_bytes(
        b"ply\nformat ascii 1.0\nelement vertex 3\nelement face %d\nend_header\n" % count
    )
    _refused(tmp_path / "big.ply", f"has {count} triangles")
    (tmp_path / "big.obj").write_bytes(b"v 0 0 0\nv 1 0 0\nv 0 1 0\n" + b"f 1 2 3\n" * (MAX_TRIANGLES + 1))
    _refused(tmp_path / "big.obj", f"has {MAX_TRIANGLES + 1} triangles")


def test_many_nodes_that_show_one_mesh_are_counted(tmp_path):
    chair_mesh().export(tmp_path / "chair.glb")
    data = (tmp_path / "chair.glb").read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    header, rest = json.loads(data[20 : 20 + length]), data[20 + length :]
    node = next(i for i, n in enumerate(header["nodes"]) if "mesh" in n)
    copies = MAX_TRIANGLES // 36 + 1
    header["nodes"] += [dict(header["nodes"][node]) for _ in range(copies)]
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 4)
    body = struct.pack("<II", len(text), 0x4E4F534A) + text + rest
    (tmp_path / "many.glb").write_bytes(b"glTF" + struct.pack("<II", 2, 12 + len(body)) + body)
    _refused(tmp_path / "many.glb", "triangles; at most")


def test_a_corner_that_is_not_a_number_is_refused(tmp_path):
    mesh = chair_mesh()
    mesh.vertices[3, 1] = np.nan
    mesh.export(tmp_path / "nan.stl")
    _refused(tmp_path / "nan.stl", "not a finite number")


def test_a_face_without_its_corner_is_refused(tmp_path):
    (tmp_path / "face.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")
    _refused(tmp_path / "face.obj", "broken")


def test_nothing_outside_the_folder_is_opened(tmp_path):
    (tmp_path / "secret.bin").write_bytes(bytes(1000))
    folder = tmp_path / "assets"
    folder.mkdir()
    gltf = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"uri": "../secret.bin", "byteLength": 1000}],
    }  # fmt: skip
    (folder / "spy.gltf").write_text(json.dumps(gltf))
    _refused(folder / "spy.gltf", "outside its folder")


def test_a_plane_has_no_volume():
    plane = MeshFile(np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]), np.array([[0, 1, 2], [0, 2, 3]]))
    with pytest.raises(FlatMeshError, match="no volume"):
        convex_pieces(plane)
    line = MeshFile(np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]]), np.array([[0, 1, 2]]))
    with pytest.raises(FlatMeshError, match="no volume"):
        convex_pieces(line)


def test_a_board_without_thickness_in_a_solid_thing_is_kept():
    """A table whose top is one quad."""
    legs = [
        trimesh.creation.box((0.05, 0.7, 0.05), trimesh.transformations.translation_matrix((x, 0.35, z)))
        for x in (-0.5, 0.5)
        for z in (-0.3, 0.3)
    ]
    top = trimesh.Trimesh(
        [[-0.6, 0.7, -0.4], [0.6, 0.7, -0.4], [0.6, 0.7, 0.4], [-0.6, 0.7, 0.4]], [[0, 1, 2], [0, 2, 3]]
    )
    pieces = convex_pieces(_triangles(trimesh.util.concatenate([*legs, top])))
    assert len(pieces) == 5
    assert sorted(round(float(np.ptp(piece[:, 0])), 3) for piece in pieces)[-1] == 1.2


def test_convex_parts_are_not_decomposed():
    assert is_convex(_triangles(trimesh.creation.icosphere(3)))
    assert is_convex(_triangles(trimesh.creation.cylinder(0.2, 1.0)))
    assert not is_convex(_triangles(trimesh.creation.torus(1.0, 0.3)))
    opened = trimesh.creation.box((1, 1, 1))
    opened.update_faces(opened.face_normals[:, 2] < 0.5)
    assert not is_convex(_triangles(opened)), "a box without its lid holds something"


def test_boxes_that_touch_are_two_parts_and_a_doubled_side_is_one():
    beside = trimesh.creation.box((1, 1, 1), trimesh.transformations.translation_matrix((1, 1, 0)))
    both = trimesh.util.concatenate([trimesh.creation.box((1, 1, 1)), beside])
    assert len(components(welded(_triangles(both)))) == 2
    box = trimesh.creation.box((1, 1, 1))
    doubled = trimesh.Trimesh(box.vertices, np.vstack([box.faces, box.faces[:, ::-1]]), process=False)
    assert len(components(welded(_triangles(doubled)))) == 1


def test_a_concave_part_is_decomposed_within_its_own_bounds():
    """An L of 2 x 2 x 0.5 with arms 1 wide: the notch stays free."""
    from shapely import Polygon

    shape = trimesh.creation.extrude_polygon(Polygon([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]), 0.5)
    pieces = convex_pieces(_triangles(shape))
    every = np.vstack(pieces)
    assert every.min(axis=0) == pytest.approx((0, 0, 0), abs=1e-9)
    assert every.max(axis=0) == pytest.approx((2, 2, 0.5), abs=1e-9)
    filled = Manifold.batch_boolean([Manifold.hull_points(piece) for piece in pieces], OpType.Add)
    assert filled.volume() == pytest.approx(1.5, rel=0.05)
    notch = Manifold.cube((0.8, 0.8, 0.4)).translate((1.1, 1.1, 0.05))
    assert (filled ^ notch).volume() < 0.01


def test_the_same_mesh_is_decomposed_once():
    mesh = _triangles(trimesh.creation.torus(1.0, 0.3, 24, 12))
    assert convex_pieces(mesh) is convex_pieces(_triangles(trimesh.creation.torus(1.0, 0.3, 24, 12)))


SLIVERS = {
    "flat": np.array([[0.0, 0.0, 0.9], [0.769, 0.0, 0.9], [0.769, 0.0015, 0.9], [0.0, 0.0015, 0.9]]),
    "nearly flat": np.array([[0, 0, 0.9], [0.7, 0, 0.9], [0.7, 0.5, 0.9], [0, 0.5, 0.9 + 1e-9], [0.3, 0.2, 0.9]]),
    "tilted": np.array([[0.0, 0.0, 0.0], [0.5, 0.0, 0.5], [0.5, 0.5, 0.5], [0.0, 0.5, 0.0]]),
    "a line": np.array([[0.0, 0.0, 0.0], [0.5, 0.0, 0.0], [0.2, 0.0, 0.0], [0.1, 0.0, 0.0]]),
    "a point": np.zeros((5, 3)),
}


@pytest.mark.parametrize("sliver", SLIVERS)
@pytest.mark.parametrize("alone", [True, False])
def test_flat_pieces_of_a_decomposition_are_thickened_or_left_out(monkeypatch, sliver, alone):
    corner = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
    found = [(SLIVERS[sliver], None), *([] if alone else [(corner, None)])]
    monkeypatch.setattr("thinkblox.assets.decompose.coacd.run_coacd", lambda *_, **__: found)
    bowl = trimesh.creation.annulus(0.5, 1.0, 0.6)
    bowl.apply_scale(1.0 + 0.01 * list(SLIVERS).index(sliver) + 0.001 * alone)
    pieces = convex_pieces(_triangles(bowl))
    assert len(pieces) == (1 if alone else 2 - (sliver in ("a line", "a point")))
    for piece in pieces:
        hull_shape(piece, category="bowl")
        assert np.ptp(piece, axis=0).min() > 1e-4
    every = np.vstack(pieces)
    assert np.array([every.min(axis=0), every.max(axis=0)]) == pytest.approx(bowl.bounds, abs=1e-9)
