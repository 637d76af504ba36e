"""Formats by name, those of users among them, and saving scenes that no loop has made."""

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from msgspec import structs

import thinkblox
from tests.export_rooms import report_on, sample_scene
from thinkblox.errors import InputError
from thinkblox.exporters import ExportFormat, formats, register
from thinkblox.exporters.formats import _FORMATS
from thinkblox.exporters.inventory import Inventory
from thinkblox.exporters.manifest import Manifest
from thinkblox.exporters.saving import save_scene
from thinkblox.scene.scene import load_scene
from thinkblox.value import read_json
from thinkblox.verdict import Report


@pytest.fixture(autouse=True)
def unregistered() -> Iterator[None]:
    before = dict(_FORMATS)
    yield
    _FORMATS.clear()
    _FORMATS.update(before)


def write_list(inventory: Inventory, path: Path) -> None:
    lines = [f"{item.id} {sum(body.mass for body in item.bodies):.3f} kg" for item in inventory.objects]
    path.write_text("\n".join(lines) + "\n")
    (path.parent / "parts").mkdir()
    (path.parent / "parts" / "looks.txt").write_text("\n".join(inventory.looks))


def write_two(inventory: Inventory, path: Path) -> None:
    path.write_text("first")
    path.with_name("beside.two").write_text("second")


OURS = [known.name for known in formats()]
LIST = ExportFormat(name="list", suffix=".txt", write=write_list, says="the names of all objects")


def save(out: Path, *names: str, **options: object) -> Path:
    scene = sample_scene()
    return save_scene(scene, out, report_on(scene), formats=names, pictures=False, **options)  # type: ignore[arg-type]


def test_ours_are_there() -> None:
    assert [(known.name, known.file) for known in formats()] == [
        ("mjcf", "scene.xml"), ("mjcf-single", "scene.single.xml"), ("mjcf-robosuite", "scene.robosuite.xml"),
        ("mjcf-mjx", "scene.mjx.xml"), ("usd", "scene.usda"), ("usdc", "scene.usdc"), ("usdz", "scene.usdz"),
        ("simready", "scene.simready.json"), ("glb", "scene.glb"), ("urdf", "scene.urdf"), ("sdf", "scene.sdf"),
    ]  # fmt: skip
    assert all(known.says for known in formats())


def test_a_user_registers_a_format(tmp_path: Path) -> None:
    register(LIST)
    out = save(tmp_path / "room", "list")
    assert (out / "scene.txt").read_text().startswith("table_1 25.000 kg\nvase_1 1.500 kg\n")
    manifest = read_json(out / "manifest.json", Manifest)
    assert manifest.formats == ("list",)
    assert {(file.name, file.says) for file in manifest.files if file.format == "list"} == {
        ("scene.txt", LIST.says), ("parts/looks.txt", ""),
    }  # fmt: skip
    assert not (out / "scene.xml").exists()
    assert save(out, "usd", overwrite=True) == out
    assert not (out / "scene.txt").exists()


def test_unknown_names_list_what_there_is(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"no format 'step'; there are mjcf, .*, urdf, sdf$"):
        save(tmp_path / "room", "mjcf", "step")
    assert list(tmp_path.iterdir()) == []


def test_names_are_taken_once() -> None:
    register(LIST)
    with pytest.raises(InputError, match="already"):
        register(LIST)
    register(LIST, replace=True)
    assert [known.name for known in formats()] == [*OURS, "list"]


@pytest.mark.parametrize("name", ["", "My Format", "../x", "x" * 50, "1st"])
def test_names_that_cannot_be(name: str) -> None:
    with pytest.raises(InputError, match="cannot name a format"):
        ExportFormat(name=name, suffix=".x", write=write_list, says="")


@pytest.mark.parametrize("suffix", ["", "x", "/x", ".x/y", ".json", ".X", "..", ".x\n"])
def test_suffixes_that_cannot_be(suffix: str) -> None:
    with pytest.raises(InputError, match="cannot end"):
        ExportFormat(name="mine", suffix=suffix, write=write_list, says="")


def test_two_formats_of_one_file(tmp_path: Path) -> None:
    register(ExportFormat(name="other", suffix=".xml", write=write_list, says=""))
    with pytest.raises(InputError, match=r"scene\.xml"):
        save(tmp_path / "room", "mjcf", "other")


def test_a_writer_that_writes_nothing_is_named(tmp_path: Path) -> None:
    register(ExportFormat(name="lazy", suffix=".lazy", write=lambda inventory, path: None, says=""))
    with pytest.raises(InputError, match=r"'lazy' wrote no scene\.lazy"):
        save(tmp_path / "room", "lazy")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("write", [None, "scene.txt"])
def test_a_writer_can_be_called(write: Any) -> None:
    with pytest.raises(InputError, match="'mine' cannot be written by"):
        ExportFormat(name="mine", suffix=".x", write=write, says="")


def test_a_writer_changes_no_file_of_ours(tmp_path: Path) -> None:
    def over(inventory: Inventory, path: Path) -> None:
        path.write_text("mine")
        path.with_name("scene.json").write_text("mine too")

    def away(inventory: Inventory, path: Path) -> None:
        path.write_text("mine")
        path.with_name("report.json").unlink()

    for write, name in ((over, "scene.json"), (away, "report.json")):
        register(ExportFormat(name="greedy", suffix=".x", write=write, says=""), replace=True)
        with pytest.raises(InputError, match=rf"'greedy' changed {name}"):
            save(tmp_path / "room", "greedy")
        assert list(tmp_path.iterdir()) == []


def test_extra_files_are_kept_as_they_are(tmp_path: Path) -> None:
    out = save(tmp_path / "room", extra={"notes.bin": b"\x00\xff"})
    assert (out / "notes.bin").read_bytes() == b"\x00\xff"
    assert read_json(out / "manifest.json", Manifest).files[-1].kind == "extra"


def test_an_extra_file_replaces_none_of_a_format(tmp_path: Path) -> None:
    register(ExportFormat(name="two", suffix=".two", write=write_two, says=""))
    with pytest.raises(InputError, match=r"beside\.two"):
        save(tmp_path / "room", "two", extra={"beside.two": b""})
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["scene.json", "manifest.json", "Top.png", "../x", "a/b", "", ".hidden", "x" * 101])
def test_extra_files_take_no_name_of_ours(tmp_path: Path, name: str) -> None:
    with pytest.raises(InputError, match="extra file"):
        save(tmp_path / "room", extra={name: b""})


def test_an_edited_scene_is_verified_and_saved(tmp_path: Path) -> None:
    scene = sample_scene().without("rug_1").moved("vase_1", position=(2.5, 4.0, 1.0))
    out = thinkblox.save_scene(scene, tmp_path / "room", pictures=False)
    report = read_json(out / "report.json", Report)
    assert load_scene(out) == scene
    assert {verdict.id: verdict.valid for verdict in report.objects}["vase_1"] is False
    assert not report.valid
    assert not (out / "trace.jsonl").exists()


def test_a_report_on_another_scene_is_refused(tmp_path: Path) -> None:
    scene = sample_scene()
    with pytest.raises(InputError, match="rug_1"):
        save_scene(scene.without("rug_1"), tmp_path / "room", report_on(scene))
    other = structs.replace(scene.placements[0], id="table_2")
    more = scene.with_placement(other, scene.asset_of(other))
    with pytest.raises(InputError, match="table_2"):
        save_scene(more, tmp_path / "room", report_on(scene))
    assert list(tmp_path.iterdir()) == []


def test_registering_loads_no_engine() -> None:
    code = (
        "import sys\nfrom thinkblox.exporters import formats, register\nformats()\n"
        "print(sorted({'mujoco', 'pxr', 'numpy', 'shapely'} & set(sys.modules)))"
    )
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "[]\n"
