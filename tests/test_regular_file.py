"""Only regular files of a bounded size are read, and for nothing else is waited."""

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from thinkblox.checking import verify_file
from thinkblox.cli import main
from thinkblox.episode import read_episode
from thinkblox.errors import InputError
from thinkblox.importing.document import read_document
from thinkblox.regular_file import read_lines, read_regular
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene, load_scene
from thinkblox.value import read_json, to_json

READERS = (
    load_scene,
    read_episode,
    read_document,
    read_regular,
    verify_file,
    lambda path: read_json(path, Room),
)


@pytest.fixture(params=["pipe", "device", "link to a device", "6 GB", "folder"])
def odd(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    path = tmp_path / "odd.json"
    if request.param == "pipe":
        os.mkfifo(path)
    elif request.param == "device":
        return Path("/dev/zero")
    elif request.param == "link to a device":
        path.symlink_to("/dev/zero")
    elif request.param == "folder":
        path.mkdir()
    else:
        with path.open("wb") as file:
            file.truncate(6_000_000_000)
    return path


@pytest.mark.parametrize("read", READERS)
def test_what_is_no_small_regular_file_is_refused_at_once(odd: Path, read: Callable[[Path], object]) -> None:
    with pytest.raises(InputError, match=str(odd)):
        read(odd)


def test_a_room_that_is_a_device_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["generate", "A room with a chair", "--out", str(tmp_path / "out"), "--room", "/dev/zero"]) == 2
    assert "/dev/zero: cannot be read: it is a device, not a file" in capsys.readouterr().err


def test_a_name_that_no_file_can_have_is_refused() -> None:
    with pytest.raises(InputError, match="null"):
        read_regular(Path("a\0b"))


def test_a_file_that_grows_while_it_is_read_is_refused(tmp_path: Path) -> None:
    (tmp_path / "log").write_bytes(b"12345")
    assert read_regular(tmp_path / "log", most=5) == b"12345"
    with pytest.raises(InputError, match="larger"):
        read_regular(tmp_path / "log", most=4)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-be"])
def test_texts_as_editors_save_them_are_read_alike(tmp_path: Path, encoding: str) -> None:
    path = tmp_path / "prompts.txt"
    mark = "\ufeff" if encoding == "utf-16-be" else ""
    path.write_text(f"{mark}A küche\n\n  A bedroom \r\n", encoding=encoding)
    assert read_lines(path) == ("A küche", "A bedroom")


@pytest.mark.parametrize(("data", "says"), [(b"\xff\xfeabc", "is not UTF-16"), (b"a\xe4b", "is not UTF-8")])
def test_bytes_that_are_no_text_are_said(tmp_path: Path, data: bytes, says: str) -> None:
    (tmp_path / "prompts.txt").write_bytes(data)
    with pytest.raises(InputError, match=rf"prompts\.txt: {says}"):
        read_lines(tmp_path / "prompts.txt")


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16"])
def test_a_scene_that_an_editor_has_saved_is_still_ours(tmp_path: Path, encoding: str) -> None:
    scene = Scene(prompt="", room=Room(floor=((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0))))
    path = tmp_path / "scene.json"
    path.write_text(to_json(scene).decode(), encoding=encoding)
    assert load_scene(path) == scene
    assert verify_file(path).valid
