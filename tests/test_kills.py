"""Commands that are killed or stopped at random times: what they write is whole, as it was before, or not there."""

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from thinkblox.exporters.folder import check_folder
from thinkblox.scene.scene import load_scene

pytestmark = pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="sees when a process heeds stops")
KILLS = int(os.environ.get("THINKBLOX_KILLS", "40"))
"""How often each command is killed, half of it where there is something to replace."""
OLD, NEW, MORE = "A room with a chair.", "A room with a stool.", "Add a stool."
SIGNALS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)


def command(*arguments: object) -> list[str]:
    return [sys.executable, "-m", "thinkblox", *map(str, arguments)]


def done(*arguments: object) -> None:
    subprocess.run(command(*arguments), check=True, capture_output=True)


def killed(arguments: list[str], number: int, after: float) -> tuple[int, str]:
    """The status of a command that gets a signal some seconds after it began to heed them, and what it said."""
    with subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as running:
        while not _heeds_stops(running.pid) and running.poll() is None:
            time.sleep(0.002)
        time.sleep(after)
        running.send_signal(number)
        _, errors = running.communicate(timeout=300)
    return running.returncode, errors


def _heeds_stops(pid: int) -> bool:
    status = Path(f"/proc/{pid}/status").read_text()
    caught = next((int(line.split()[1], 16) for line in status.splitlines() if line.startswith("SigCgt")), 0)
    return bool(caught >> (signal.SIGTERM - 1) & caught >> (signal.SIGINT - 1) & 1)


def seconds_of(arguments: list[str]) -> float:
    begin = time.monotonic()
    subprocess.run(arguments, check=True, capture_output=True)
    return time.monotonic() - begin


def check_status(number: int, status: int, errors: str) -> None:
    # Of a killed process it may be a helper of some library that complains.
    assert number == signal.SIGKILL or "Traceback" not in errors, errors
    expected = {0, -signal.SIGKILL} if number == signal.SIGKILL else {0, 130}
    assert status in expected, errors


def things_in(out: Path) -> str:
    check_folder(out, overwrite=True)  # whole, and nothing else in it
    return " ".join(placement.id for placement in load_scene(out).placements)


@pytest.mark.slow
@pytest.mark.parametrize("overwrite", [False, True], ids=["new", "overwrite"])
def test_a_killed_generate_leaves_the_old_or_the_new_room(tmp_path: Path, overwrite: bool) -> None:
    old, out = tmp_path / "old", tmp_path / "home" / "room"
    done("generate", OLD, "--out", old, "--no-pictures")
    arguments = ["generate", NEW, "--no-pictures"]
    whole = seconds_of(command(*arguments, "--out", tmp_path / "new"))
    the_old_or_the_new(command(*arguments, "--out", out), whole, out, old if overwrite else None, "stool_1")


@pytest.mark.slow
@pytest.mark.parametrize("overwrite", [False, True], ids=["new", "itself"])
def test_a_killed_edit_leaves_the_room_as_it_was_or_as_asked(tmp_path: Path, overwrite: bool) -> None:
    old, out = tmp_path / "old", tmp_path / "home" / "room"
    done("generate", OLD, "--out", old, "--no-pictures")
    whole = seconds_of(command("edit", old, MORE, "--no-pictures", "--out", tmp_path / "new"))
    arguments = command("edit", out if overwrite else old, MORE, "--no-pictures", "--out", out)
    the_old_or_the_new(arguments, whole, out, old if overwrite else None, "chair_1 stool_1")
    assert things_in(old) == "chair_1"


def the_old_or_the_new(arguments: list[str], whole: float, out: Path, old: Path | None, new: str) -> None:
    """Kill a command that takes `whole` seconds again and again; it replaces the room `old`, if any, with other things.

    At the end it is left in peace, and nothing is there but its room.
    """
    rng = random.Random(old is None)
    out.parent.mkdir()
    arguments, was = [*arguments, *(["--overwrite"] if old else [])], things_in(old) if old else "nothing"
    for kill in range(KILLS // 2):
        if old:
            subprocess.run(["cp", "-r", old, out], check=True)
        there = {path.name for path in out.parent.iterdir()}  # with what those left behind that were killed
        number = SIGNALS[kill % len(SIGNALS)]
        # The end, where a room is put in place, is what most of them are to hit.
        after = whole * (rng.random() if kill % 2 else rng.uniform(0.7, 1.0))
        status, errors = killed(arguments, number, after)
        check_status(number, status, errors)
        found = things_in(out) if out.exists() else "nothing"
        assert found in (was, new)
        if status == 130:
            assert ("nothing was written" in errors) == (found != new), errors
        if number != signal.SIGKILL:
            assert {path.name for path in out.parent.iterdir()} <= {*there, "room"}
        whole *= 0.97 if status == 0 else 1.01  # the machine is not always as fast
        subprocess.run(["rm", "-rf", out], check=True)
    if old:
        subprocess.run(["cp", "-r", old, out], check=True)
    subprocess.run(arguments, check=True, capture_output=True)
    assert [path.name for path in out.parent.iterdir()] == ["room"]
    assert things_in(out) == new


@pytest.mark.slow
@pytest.mark.parametrize("overwrite", [False, True], ids=["new", "overwrite"])
def test_a_killed_verify_leaves_the_old_or_the_new_files(tmp_path: Path, overwrite: bool) -> None:
    home, rng = tmp_path / "home", random.Random(overwrite)
    home.mkdir()
    out, page = home / "mended.json", home / "page.html"
    done("generate", NEW, "--out", tmp_path / "room", "--no-pictures")
    arguments = command("verify", tmp_path / "room", "--out", out, "--html", page)
    whole = seconds_of(arguments)
    new = {path: path.read_bytes() for path in (out, page)}
    old = dict.fromkeys(new, b"mine") if overwrite else {}
    for kill in range(KILLS // 2):
        for path in new:
            path.unlink(missing_ok=True)
            if overwrite:
                path.write_bytes(old[path])
        number = SIGNALS[kill % len(SIGNALS)]
        after = whole * (rng.random() if kill % 2 else rng.uniform(0.7, 1.0))
        status, errors = killed([*arguments, *(["--overwrite"] if overwrite else [])], number, after)
        check_status(number, status, errors)
        whole *= 0.97 if status == 0 else 1.01
        found = {path: path.read_bytes() for path in new if path.exists()}
        assert set(found) >= set(old)
        assert all(data in (new[path], old.get(path)) for path, data in found.items())
        if status == 130:
            assert ("nothing was written" in errors) == (found == old)
    done(*arguments[3:], "--overwrite")
    assert {path: path.read_bytes() for path in home.iterdir()} == new


@pytest.mark.slow
@pytest.mark.parametrize("overwrite", [False, True], ids=["new", "overwrite"])
def test_a_killed_render_leaves_the_old_or_the_new_pictures(tmp_path: Path, overwrite: bool) -> None:
    home, rng = tmp_path / "home", random.Random(overwrite)
    home.mkdir()
    done("generate", NEW, "--out", tmp_path / "room", "--no-pictures")
    done("render", tmp_path / "room", "--size", 96)
    names = ("preview.png", "top.png")
    drawn = {name: (tmp_path / "room" / name).read_bytes() for name in names}
    arguments = command("render", tmp_path / "room", "--size", 64, "--out", home)
    whole = seconds_of(arguments)
    new = {name: (home / name).read_bytes() for name in names}
    old = drawn if overwrite else {}
    for kill in range(KILLS // 2):
        for name in names:
            (home / name).unlink(missing_ok=True)
            if overwrite:
                (home / name).write_bytes(old[name])
        there = {path.name for path in home.iterdir()}  # with what those left behind that were killed
        number = SIGNALS[kill % len(SIGNALS)]
        after = whole * (rng.random() if kill % 2 else rng.uniform(0.7, 1.0))
        status, errors = killed(arguments, number, after)
        check_status(number, status, errors)
        whole *= 0.97 if status == 0 else 1.01
        found = {name: (home / name).read_bytes() for name in names if (home / name).exists()}
        assert set(found) >= set(old)
        assert all(data in (new[name], old.get(name)) for name, data in found.items())
        if status == 130:
            assert ("nothing was written" in errors) == (found == old), errors
        if number != signal.SIGKILL:
            assert {path.name for path in home.iterdir()} <= {*there, *names}
    done(*arguments[3:])
    assert {path.name: path.read_bytes() for path in home.iterdir()} == new


@pytest.mark.slow
@pytest.mark.parametrize("name", ["assets list", "assets list --json", "schema scene"])
def test_a_killed_listing_ends_as_stopped(name: str) -> None:
    arguments, rng = command(*name.split()), random.Random(name)
    whole = seconds_of(arguments)
    for kill in range(KILLS // 3):
        number = SIGNALS[kill % len(SIGNALS)]
        check_status(number, *killed(arguments, number, whole * rng.random()))
