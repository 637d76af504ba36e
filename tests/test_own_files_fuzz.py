"""Files of ours, mutated: each is read as what it says, or refused with a sentence."""

import contextlib
import json
import random
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import thinkblox
from thinkblox.cli import main
from thinkblox.episode import read_episode
from thinkblox.errors import InputError
from thinkblox.exporters.folder import check_folder
from thinkblox.scene.room import Room
from thinkblox.scene.scene import load_scene
from thinkblox.value import read_json

ODD: tuple[Any, ...] = (
    None, True, -1, 0, 1e300, -1e300, 1e-300, 2**63, 10**400, -1e-17, float("nan"), float("inf"), "", "floor", "a\nb",
    "chair_1\n", "\x1b[2J", "../../etc/passwd", "x" * 100_000, [], {}, [[]], [0, 0, 0], {"a": 1},
)  # fmt: skip


def places(document: Any) -> Iterator[tuple[Any, Any]]:
    """Everything in a document, as what holds it and the key under which it does."""
    keys = document if isinstance(document, dict) else range(len(document)) if isinstance(document, list) else ()
    for key in list(keys):
        yield document, key
        yield from places(document[key])


def mutated(text: bytes, rng: random.Random) -> bytes:
    """A text with one thing wrong: a value, a key, an entry too many or too few, or bytes."""
    if rng.random() < 0.25:
        data = bytearray(text)
        at = rng.randrange(len(data))
        data[at : at + rng.choice((0, 1, 1, 50))] = rng.choice((b"", b"\0", b'"', b"{", b"9", b"\xff", b",", b"-"))
        return bytes(data)
    document = json.loads(text)
    holder, key = rng.choice(list(places(document)))
    match rng.randrange(4):
        case 0:
            del holder[key]
        case 1 if isinstance(holder, list):
            holder += [holder[key]] * rng.choice((1, 5, 3000))
        case 2 if isinstance(holder, dict):
            holder[rng.choice(("", "extra", "id\n", "x" * 1000))] = holder.pop(key)
        case _:
            holder[key] = rng.choice(ODD)
    return json.dumps(document).encode("utf-8", "surrogatepass")


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
                lines[at] = mutated(lines[at], rng)
                path.write_bytes(b"\n".join(lines))
            else:
                path.write_bytes(mutated(whole, rng))
            with contextlib.suppress(InputError):
                read(room)
    finally:
        path.write_bytes(text)


@pytest.mark.slow
def test_a_mutated_scene_is_measured_or_refused(room: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rng, file = random.Random(7), tmp_path / "scene.json"
    whole = (room / "scene.json").read_bytes()
    for _ in range(100):
        file.write_bytes(mutated(whole, rng))
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
