"""Files of ours, mutated: each is read as what it says, or refused with a sentence."""

import contextlib
import json
import random
from collections.abc import Callable
from pathlib import Path

import pytest

import thinkblox
from tests.mutants import mutated_json
from thinkblox.cli import main
from thinkblox.episode import read_episode
from thinkblox.errors import InputError
from thinkblox.exporters.folder import check_folder
from thinkblox.scene.room import Room
from thinkblox.scene.scene import load_scene
from thinkblox.value import read_json


@pytest.fixture(scope="module")
def room(tmp_path_factory: pytest.TempPathFactory) -> Path:
    result = thinkblox.generate_room("A room with a desk, a lamp on it and a wardrobe.", seed=1)
    return thinkblox.save_room(result, tmp_path_factory.mktemp("own") / "room", pictures=False)


def as_room(folder: Path) -> object:
    return read_json(folder / "scene.json", Room)


READERS: dict[str, tuple[str, Callable[[Path], object], int]] = {
    "scene": ("scene.json", load_scene, 2000),
    "room": ("scene.json", as_room, 1000),
    "trace": ("trace.jsonl", read_episode, 1000),
    "manifest": ("manifest.json", lambda folder: check_folder(folder, overwrite=True), 1000),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", READERS)
def test_a_mutated_file_is_read_or_refused(room: Path, name: str) -> None:
    file, read, times = READERS[name]
    rng, path = random.Random(name), room / file
    text = path.read_bytes()
    whole = json.dumps(json.loads(text)["room"]).encode() if name == "room" else text
    try:
        for _ in range(times):
            if name == "trace":
                lines = whole.splitlines()
                at = rng.randrange(len(lines))
                lines[at] = mutated_json(lines[at], rng)
                path.write_bytes(b"\n".join(lines))
            else:
                path.write_bytes(mutated_json(whole, rng))
            with contextlib.suppress(InputError):
                read(room)
    finally:
        path.write_bytes(text)


@pytest.mark.slow
def test_a_mutated_scene_is_measured_or_refused(room: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rng, file = random.Random(7), tmp_path / "scene.json"
    whole = (room / "scene.json").read_bytes()
    for _ in range(100):
        file.write_bytes(mutated_json(whole, rng))
        status, errors = main(["verify", str(file), "--timeout", "60"]), capsys.readouterr().err
        assert status in (0, 1, 2), errors
        assert "Traceback" not in errors
        try:
            load_scene(file)
        except InputError:
            assert status == 2, "not even read, and measured all the same"


@pytest.mark.parametrize("old", ['"chair_1"', '"door_1"'])
def test_no_id_of_any_file_ends_in_a_line_break(tmp_path: Path, old: str) -> None:
    result = thinkblox.generate_room("A room with a chair and a door.", seed=1)
    folder = thinkblox.save_room(result, tmp_path / "room", pictures=False)
    for name, read in (("scene.json", load_scene), ("trace.jsonl", read_episode)):
        text = (folder / name).read_text()
        assert old in text
        (folder / name).write_text(text.replace(old, f'{old[:-1]}\\n"'))
        with pytest.raises(InputError):
            read(folder)


def test_a_key_that_is_not_known_is_named_in_print(tmp_path: Path) -> None:
    file = tmp_path / "room.json"
    file.write_text('{"floor": [], "a\\n\\u001b[2J": 1}')
    with pytest.raises(InputError, match=r"a\\n\\x1b\[2J") as caught:
        read_json(file, Room)
    assert str(caught.value).isprintable()
