"""Meshes and textures by content: kept, found beside a scene.json, refused when they are not what they should be."""

import os
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from msgspec import structs

from tests.export_rooms import sample_scene
from tests.textured import box_mesh, chequered_png, crate, crate_scene
from thinkblox.errors import InputError
from thinkblox.scene.asset_files import asset_files
from thinkblox.scene.blobs import BLOBS, BlobStore, blob_name
from thinkblox.scene.scene import load_scene
from thinkblox.scene.texture import MAX_SIDE, pixels_of, put_texture
from thinkblox.scene.textured_mesh import TexturedMesh, mesh_of, put_mesh
from thinkblox.scene.visuals import Look, MeshVisual
from thinkblox.value import from_json, to_json


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "assets").mkdir()
    (tmp_path / "scene.json").write_bytes(to_json(crate_scene()))
    for name, data in asset_files([crate()]).items():
        (tmp_path / name).write_bytes(data)
    return tmp_path


def test_a_scene_finds_its_blobs_and_stays_small(folder: Path) -> None:
    scene = load_scene(folder)
    assert scene == load_scene(folder / "scene.json") == crate_scene()
    assert len((folder / "scene.json").read_bytes()) < 4000
    assert sorted(path.suffix for path in (folder / "assets").iterdir()) == [".bin", ".bin", ".png"]
    assert pickle.loads(pickle.dumps(scene)) == scene
    assert hash(crate()) == hash(crate())


def test_scenes_without_meshes_read_and_write_as_before() -> None:
    text = to_json(sample_scene())
    assert b"visuals" not in text
    assert to_json(from_json(text, type(sample_scene()))) == text


def test_equal_bytes_have_one_name() -> None:
    store = BlobStore()
    assert store.put(b"abc") == store.put(b"abc") != store.put(b"abd")
    assert store.get(store.put(b"abc")) == b"abc"
    with pytest.raises(InputError, match="load the scene"):
        BlobStore().get("0" * 64)


def test_a_store_keeps_to_its_size_and_reads_again(folder: Path) -> None:
    store = BlobStore(keep=100)
    blobs = crate().blobs
    for id, kind in blobs:
        store.read(id, kind, folder)
    assert [store.get(id) for id, _ in blobs] == [BLOBS.get(id) for id, _ in blobs]
    (folder / blob_name(*blobs[0])).unlink()
    with pytest.raises(InputError, match=blobs[0][0]):
        store.get(blobs[0][0])


def break_missing(file: Path) -> None:
    file.unlink()


def break_altered(file: Path) -> None:
    file.write_bytes(file.read_bytes()[:-1] + b"!")


def break_folder(file: Path) -> None:
    file.unlink()
    file.mkdir()


def break_outside(file: Path) -> None:
    outside = file.parent.parent.with_name("outside")
    outside.write_bytes(file.read_bytes())
    file.unlink()
    file.symlink_to(outside)


def break_loop(file: Path) -> None:
    file.unlink()
    file.symlink_to(file)


def break_pipe(file: Path) -> None:
    file.unlink()
    os.mkfifo(file)


BREAKING = (break_missing, break_altered, break_folder, break_outside, break_loop, break_pipe)


@pytest.mark.parametrize("breaking", BREAKING)
@pytest.mark.parametrize("kind", ["bin", "png"])
def test_what_is_wrong_names_asset_and_file(tmp_path: Path, folder: Path, breaking: object, kind: str) -> None:
    file = sorted((folder / "assets").glob(f"*.{kind}"))[0]
    breaking(file)  # type: ignore[operator]
    with pytest.raises(InputError, match=f"crate-0.*{file.name}"):
        load_scene(folder)


@pytest.mark.parametrize("name", ["../scene", "0" * 63, "A" * 64, "0" * 64 + "\n", "0" * 63 + "/", ""])
def test_names_that_are_no_hashes_are_refused(name: str) -> None:
    with pytest.raises(InputError, match="SHA-256"):
        MeshVisual(mesh=name)
    with pytest.raises(InputError, match="SHA-256"):
        Look(texture=name)
    with pytest.raises(InputError):
        from_json(to_json(MeshVisual(mesh="0" * 64)).replace(b"0" * 64, name.encode()), MeshVisual)


@pytest.mark.parametrize("field", [{"roughness": 1.5}, {"metallic": float("nan")}, {"base_colour": (0.0, -1.0, 0.0)}])
def test_a_look_has_numbers_from_0_to_1(field: dict[str, float]) -> None:
    with pytest.raises(InputError, match=next(iter(field))):
        Look(**field)  # type: ignore[arg-type]


def test_a_mesh_survives_its_bytes() -> None:
    mesh = box_mesh((1.0, 2.0, 3.0), (0.0, 0.0, 1.5))
    again = mesh_of(put_mesh(mesh))
    for name in ("vertices", "normals", "uv", "faces"):
        np.testing.assert_array_equal(getattr(again, name), getattr(mesh, name))


@pytest.mark.parametrize("cut", [0, 8, 15, 16, 200, -1])
def test_bytes_that_are_no_mesh_are_refused(cut: int) -> None:
    with pytest.raises(InputError, match="no mesh"):
        TexturedMesh.from_bytes(box_mesh((1.0, 1.0, 1.0), (0.0, 0.0, 0.5)).to_bytes()[:cut])
    with pytest.raises(InputError, match="no mesh"):
        mesh_of(BLOBS.put(b"TBMESH01" + b"\xff" * 8))


def test_wrong_meshes_are_refused() -> None:
    good = box_mesh((1.0, 1.0, 1.0), (0.0, 0.0, 0.5))
    wrong: dict[str, dict[str, Any]] = {
        "does not exist": {"faces": good.faces + 1},
        "finite": {"vertices": good.vertices * np.float32("nan")},
        "metres": {"vertices": good.vertices * 1000},
        "unit length": {"normals": good.normals * 0},
        "shape": {"uv": good.uv[:-1]},
    }
    fields = {name: getattr(good, name) for name in ("vertices", "normals", "uv", "faces")}
    for match, change in wrong.items():
        with pytest.raises(InputError, match=match):
            TexturedMesh.of(**{**fields, **change})


def test_textures_are_png_of_a_bearable_size() -> None:
    assert pixels_of(put_texture(chequered_png())).shape == (64, 64, 3)
    data = bytearray(chequered_png())
    for wrong in (b"GIF89a" + bytes(100), bytes(data[:20])):
        with pytest.raises(InputError, match="no PNG"):
            put_texture(wrong)
    with pytest.raises(InputError, match=r"^texture [0-9a-f]{12}: "):
        pixels_of(put_texture(bytes(data[:60])))
    data[16:20] = (MAX_SIDE + 1).to_bytes(4, "big")
    with pytest.raises(InputError, match=str(MAX_SIDE)):
        put_texture(bytes(data))


def test_an_asset_whose_blobs_nobody_gave_says_so() -> None:
    link = crate().links[0]
    lost = structs.replace(crate(), links=(structs.replace(link, visuals=(MeshVisual(mesh="1" * 64),)),))
    with pytest.raises(InputError, match=r"crate-0.*1111"):
        asset_files([lost])
