"""The output folder: whole or not at all, and never over anything that is not ours."""

import os
import shutil
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from tests.export_rooms import Result, Trace, report_on, result
from tests.textured import crate, crate_scene
from thinkblox import workplace
from thinkblox.errors import InputError
from thinkblox.exporters import ExportFormat, register
from thinkblox.exporters.exporting import export_scene
from thinkblox.exporters.folder import _put_in_place, check_folder, whole_folder
from thinkblox.exporters.formats import _FORMATS
from thinkblox.exporters.inventory import Inventory
from thinkblox.exporters.manifest import MANIFEST, PICTURES, Manifest
from thinkblox.exporters.saving import save_pictures, save_scene
from thinkblox.holding import placed, signals_held
from thinkblox.renaming import exchange
from thinkblox.saving import save_room
from thinkblox.scene.scene import load_scene
from thinkblox.value import read_json
from thinkblox.workplace import _claimed

WITHOUT_PICTURES = ["assets", "manifest.json", "report.json", "scene.json", "scene.usda", "scene.xml", "trace.jsonl"]


def names(folder: Path) -> list[str]:
    return sorted(entry.name for entry in folder.iterdir())


def save(made: Result, out: Path, **options: Any) -> Path:
    return save_room(made, out, pictures=False, **options)  # type: ignore[arg-type]


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def left_behind(out: Path) -> Path:
    """The workplace of a process that was killed."""
    folder, lock = _claimed(out)
    os.close(lock)
    return folder


def test_everything_is_written_and_nothing_else(tmp_path: Path) -> None:
    out = save(result(), tmp_path / "deep" / "room")
    assert names(out) == WITHOUT_PICTURES
    assert names(tmp_path / "deep") == ["room"]
    assert load_scene(out) == result().scene
    assert (out / "trace.jsonl").read_text() == "first\nsecond\n"
    assert out.stat().st_mode & 0o077 == (tmp_path / "deep").stat().st_mode & 0o077


def test_the_same_room_twice_gives_the_same_bytes(tmp_path: Path) -> None:
    first, second = (save(result(), tmp_path / name) for name in ("a", "b"))
    files = sorted(path.relative_to(first) for path in first.rglob("*") if path.is_file())
    assert files == sorted(path.relative_to(second) for path in second.rglob("*") if path.is_file())
    for name in files:
        assert (first / name).read_bytes() == (second / name).read_bytes(), name


def test_pictures_come_with_the_room(tmp_path: Path) -> None:
    from PIL import Image

    paths = save_pictures(result().scene, tmp_path / "pictures", size=64)
    assert [path.name for path in paths] == list(PICTURES)
    assert names(tmp_path / "pictures") == sorted(PICTURES)
    assert [Image.open(path).size for path in paths] == [(64, 64), (64, 64)]


def test_ours_is_replaced_only_when_asked(tmp_path: Path) -> None:
    out = save(result(), tmp_path / "room")
    with pytest.raises(InputError, match="already holds a room"):
        check_folder(out)
    other = replace(result(), episode=Trace(()))
    with pytest.raises(InputError, match="already holds a room"):
        save(other, out)
    assert (out / "trace.jsonl").stat().st_size > 0
    save(other, out, overwrite=True)
    assert (out / "trace.jsonl").stat().st_size == 0
    assert names(tmp_path) == ["room"]


@pytest.mark.parametrize("overwrite", [False, True])
@pytest.mark.parametrize("content", [{"thesis.tex": "years of work"}, {"scene.json": "{}"}])
def test_what_is_not_ours_is_left_alone(tmp_path: Path, overwrite: bool, content: dict[str, str]) -> None:
    out = tmp_path / "mine"
    out.mkdir()
    for name, text in content.items():
        (out / name).write_text(text)
    with pytest.raises(InputError, match="choose another"):
        save(result(), out, overwrite=overwrite)
    assert {name: (out / name).read_text() for name in names(out)} == content
    assert names(tmp_path) == ["mine"]


@pytest.mark.parametrize("overwrite", [False, True])
def test_an_empty_folder_is_taken(tmp_path: Path, overwrite: bool) -> None:
    out = tmp_path / "made"
    out.mkdir()
    assert names(save(result(), out, overwrite=overwrite)) == WITHOUT_PICTURES
    assert names(tmp_path) == ["made"]


def test_an_export_takes_the_place_of_an_export_and_of_no_room(tmp_path: Path) -> None:
    """The report and the trace of a room cannot be written anew from its scene."""
    room = save(result(), tmp_path / "room")
    before = names(room)
    with pytest.raises(InputError, match=r"is the room itself, and .* away its report\.json, trace\.jsonl"):
        export_scene(load_scene(room), room, formats=("mjcf",), overwrite=True)
    assert names(room) == before
    export = export_scene(load_scene(room), tmp_path / "export", formats=("mjcf",))
    assert export_scene(load_scene(export), export, formats=("mjcf",), overwrite=True) == export


def test_the_root_is_no_room() -> None:
    for out in ("/", "//"):
        with pytest.raises(InputError, match="holds other files"):
            check_folder(out, overwrite=True)


def test_a_room_with_a_foreign_file_in_it_is_not_replaced(tmp_path: Path) -> None:
    out = save(result(), tmp_path / "room")
    (out / "notes.txt").write_text("mine")
    with pytest.raises(InputError, match=r"notes\.txt"):
        save(result(), out, overwrite=True)
    assert names(out) == sorted([*WITHOUT_PICTURES, "notes.txt"])


def test_a_file_or_a_link_in_the_way(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    room = save(result(), tmp_path / "room")
    (tmp_path / "link").symlink_to(room)
    for out in (tmp_path / "file", tmp_path / "link"):
        with pytest.raises(InputError, match=r"not a folder|symbolic link"):
            check_folder(out, overwrite=True)
    with pytest.raises(InputError, match="file is not a folder"):
        check_folder(tmp_path / "file" / "room")


def test_a_parent_that_cannot_be_written(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="/proc"):
        save(result(), Path("/proc/thinkblox/room"))
    with pytest.raises(InputError, match="too long"):
        save(result(), tmp_path / ("x" * 300))
    assert names(tmp_path) == []


@pytest.fixture
def interrupted() -> Iterator[Callable[[BaseException], str]]:
    """The name of a format whose writer stops the work half-way, when other files are already written."""

    def made(error: BaseException) -> str:
        def write(inventory: Inventory, path: Path) -> None:
            path.write_text("half of it")
            raise error

        register(ExportFormat("interrupted", ".half", write, "nothing whole"), replace=True)
        return "interrupted"

    before = dict(_FORMATS)
    yield made
    _FORMATS.clear()
    _FORMATS.update(before)


Stop = Callable[[BaseException], str]


@pytest.mark.parametrize("error", [KeyboardInterrupt(), RuntimeError("no"), OSError(28, "No space left on device")])
def test_a_failure_leaves_nothing_behind(tmp_path: Path, interrupted: Stop, error: BaseException) -> None:
    expected = InputError if isinstance(error, OSError) else type(error)
    with pytest.raises(expected):
        save(result(), tmp_path / "deep" / "room", formats=("mjcf", interrupted(error)))
    assert names(tmp_path) == []


def test_a_failure_leaves_the_old_room_as_it_was(tmp_path: Path, interrupted: Stop) -> None:
    out = save(result(), tmp_path / "room")
    before = contents(out)
    with pytest.raises(KeyboardInterrupt):
        save(result(), out, overwrite=True, formats=(interrupted(KeyboardInterrupt()),))
    assert contents(out) == before
    assert names(tmp_path) == ["room"]


def test_the_manifest_lists_every_file(tmp_path: Path) -> None:
    out = save_scene(crate_scene(), tmp_path / "room", report_on(crate_scene()), pictures=False)
    manifest = read_json(out / MANIFEST, Manifest)
    found = {path.relative_to(out).as_posix() for path in out.rglob("*") if path.is_file()}
    assert {file.name for file in manifest.files} == found - {MANIFEST}
    kinds = {Path(file.name).suffix: (file.kind, file.format) for file in manifest.files}
    assert kinds[".bin"] == ("asset", None)
    # The scene has its own textures, the format those of floor and walls too.
    assert {(file.kind, file.format) for file in manifest.files if file.name.endswith(".png")} == {
        ("asset", None), ("format", "mjcf"),
    }  # fmt: skip
    assert kinds[".obj"] == kinds[".xml"] == ("format", "mjcf")
    assert kinds[".usda"] == ("format", "usd")
    assert manifest.formats == ("mjcf", "usd")
    (credit,) = manifest.credits
    assert (credit.licence, credit.author, credit.assets) == (crate().licence, crate().author, ("crate-0",))
    assert save_scene(crate_scene(), out, report_on(crate_scene()), pictures=False, overwrite=True) == out


@pytest.mark.parametrize("stranger", ["assets/mine.bin", "assets/deep/mine.bin", "mine", "other/mine"])
def test_what_the_manifest_does_not_list_is_not_ours(tmp_path: Path, stranger: str) -> None:
    out = save_scene(crate_scene(), tmp_path / "room", report_on(crate_scene()), pictures=False)
    (out / stranger).parent.mkdir(exist_ok=True, parents=True)
    (out / stranger).write_text("mine")
    with pytest.raises(InputError, match="holds other files"):
        check_folder(out, overwrite=True)
    assert (out / stranger).read_text() == "mine"


def test_links_belong_to_nobody(tmp_path: Path) -> None:
    out = save(result(), tmp_path / "room")
    (out / "scene.xml").unlink()
    (out / "scene.xml").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(InputError, match=r"scene\.xml"):
        check_folder(out, overwrite=True)


@pytest.mark.parametrize("text", ["{}", "[]", "no json", '{"name": "a web app", "icons": []}'])
def test_a_manifest_of_somebody_else_is_not_ours(tmp_path: Path, text: str) -> None:
    out = save(result(), tmp_path / "room")
    (out / MANIFEST).write_text(text)
    with pytest.raises(InputError, match="not a room that we wrote"):
        check_folder(out, overwrite=True)


def test_pictures_drawn_later_belong_to_the_room(tmp_path: Path) -> None:
    out = save(result(), tmp_path / "room")
    save_pictures(result().scene, out, size=64)
    assert check_folder(out, overwrite=True) == out


def test_a_folder_of_the_older_release_can_be_replaced(tmp_path: Path) -> None:
    out = save(result(), tmp_path / "room")
    (out / MANIFEST).unlink()
    shutil.rmtree(out / "assets")
    with pytest.raises(InputError, match="already holds a room"):
        check_folder(out)
    save(result(), out, overwrite=True)
    assert MANIFEST in names(out)
    (out / MANIFEST).unlink()
    shutil.rmtree(out / "assets")
    (out / "scene.sdf").write_text("of no older release")
    with pytest.raises(InputError, match=r"scene\.sdf"):
        check_folder(out, overwrite=True)


def test_a_manifest_of_a_later_release_is_understood(tmp_path: Path) -> None:
    out = save(result(), tmp_path / "room")
    text = (out / MANIFEST).read_text()
    (out / MANIFEST).write_text(text.replace('"version": 1', '"version": 9, "more": {}'))
    assert check_folder(out, overwrite=True) == out


def test_messages_speak_no_command_line(tmp_path: Path) -> None:
    out = save(result(), tmp_path / "room")
    with pytest.raises(InputError) as raised:
        check_folder(out)
    assert "--" not in str(raised.value)
    assert "overwritten" in str(raised.value)


def test_what_a_killed_process_left_is_swept_up_by_the_next(tmp_path: Path) -> None:
    out, work = tmp_path / "room", left_behind(tmp_path / "room")
    (work / "unfinished" / "assets").mkdir(parents=True)
    (work / "unfinished" / "scene.json").write_text("half")
    left_behind(tmp_path / "another")
    assert save(result(), out) == out
    assert names(tmp_path) == sorted(["room", next(name for name in names(tmp_path) if name.startswith("."))])


def test_what_a_living_process_works_on_stays(tmp_path: Path) -> None:
    with whole_folder(tmp_path / "room", overwrite=False) as room:
        (room / "scene.json").write_text("half")
        save(result(), tmp_path / "room")
        assert (room / "scene.json").read_text() == "half"
        (tmp_path / "room").rename(tmp_path / "first")
    assert names(tmp_path) == ["first", "room"]


def test_a_room_that_was_put_aside_when_its_process_was_killed_comes_back(tmp_path: Path) -> None:
    work = left_behind(tmp_path / "room")
    save(result(), work / "aside")
    with pytest.raises(InputError, match="already holds a room"):
        check_folder(tmp_path / "room")
    assert load_scene(tmp_path / "room") == result().scene
    assert names(tmp_path) == ["room"]


def test_a_replaced_room_with_a_strangers_file_in_it_is_not_swept_up(tmp_path: Path) -> None:
    save(result(), tmp_path / "room")
    work = left_behind(tmp_path / "room")
    (save(result(), work / "finished") / "thesis.tex").write_text("years of work")
    check_folder(tmp_path / "room", overwrite=True)
    assert (work / "finished" / "thesis.tex").read_text() == "years of work"


@pytest.fixture(params=["in one step", "in two steps"])
def system(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    if request.param == "in two steps":
        monkeypatch.setattr("thinkblox.renaming._system_call", lambda: None)


@pytest.mark.usefixtures("system")
def test_a_room_is_replaced_but_not_a_strangers_file_of_meanwhile(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = save(result(), tmp_path / "room")
    save(replace(result(), episode=Trace(())), out, overwrite=True)
    assert (out / "trace.jsonl").stat().st_size == 0
    assert names(tmp_path) == ["room"]

    def after_a_stranger(room: Path, out: Path, aside: Path) -> None:
        (out / "thesis.tex").write_text("years of work")
        _put_in_place(room, out, aside)

    monkeypatch.setattr("thinkblox.exporters.folder._put_in_place", after_a_stranger)
    with pytest.raises(InputError, match="meanwhile"):
        save(result(), out, overwrite=True)
    assert (out / "thesis.tex").read_text() == "years of work"
    assert names(tmp_path) == ["room"]


@pytest.mark.usefixtures("system")
def test_a_name_that_is_taken_meanwhile_is_left_alone(tmp_path: Path) -> None:
    writing = whole_folder(tmp_path / "room", overwrite=False)
    writing.__enter__()
    (tmp_path / "room").mkdir()
    (tmp_path / "room" / "thesis.tex").write_text("years of work")
    with pytest.raises(InputError, match="exists"):
        writing.__exit__(None, None, None)
    assert (tmp_path / "room" / "thesis.tex").read_text() == "years of work"
    assert names(tmp_path) == ["room"]


def test_a_stop_waits_until_the_new_room_stands(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    out = save(result(), tmp_path / "room")

    def stopped(*paths: Path) -> bool:
        signal.raise_signal(signal.SIGINT)
        return exchange(*paths)

    monkeypatch.setattr("thinkblox.exporters.folder.exchange", stopped)
    # What is started in the background of a script ignores it.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    with pytest.raises(KeyboardInterrupt):
        save(replace(result(), episode=Trace(())), out, overwrite=True)
    assert (out / "trace.jsonl").stat().st_size == 0
    assert placed()[-1] == out
    assert names(tmp_path) == ["room"]


@pytest.mark.parametrize("name", ["x" * 255, "ü" * 127])
def test_a_name_may_be_as_long_as_names_can_be(tmp_path: Path, name: str) -> None:
    assert load_scene(save(result(), tmp_path / name)) == result().scene
    with pytest.raises(InputError, match="too long for a name; 255 bytes"):
        check_folder(tmp_path / f"{name}xx")
    with pytest.raises(InputError, match="too long"):
        check_folder(tmp_path / "none" / f"{name}xx" / "room")
    assert names(tmp_path) == [name]


def test_a_stop_just_before_signals_are_held_leaves_no_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    held, calls = signals_held, list[int]()

    @contextmanager
    def late() -> Iterator[None]:
        calls.append(0)
        if len(calls) == 2:
            raise KeyboardInterrupt
        with held():
            yield

    monkeypatch.setattr(workplace, "signals_held", late)
    with pytest.raises(KeyboardInterrupt), workplace.workplace(tmp_path / "out"):
        assert list(tmp_path.iterdir())
    assert not list(tmp_path.iterdir())
