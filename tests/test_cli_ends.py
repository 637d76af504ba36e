"""How commands end: the statuses, and what is said, whatever goes wrong."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from thinkblox.cli import main, schema

COMMAND = [sys.executable, "-m", "thinkblox"]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
def test_an_output_that_cannot_be_written_is_said() -> None:
    command = [*COMMAND, "schema", "scene"]
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert done.returncode == 74
    assert done.stderr == "thinkblox: the output could not be written: No space left on device\n"


def test_an_output_that_nobody_reads_to_its_end_is_no_fault() -> None:
    read, write = os.pipe()
    os.close(read)
    done = subprocess.run([*COMMAND, "schema"], stdout=write, stderr=subprocess.PIPE, text=True, check=False)
    assert (done.returncode, done.stderr) == (141, "")


def test_a_closed_output_is_no_fault() -> None:
    done = subprocess.run([*COMMAND, "schema"], stderr=subprocess.PIPE, check=False, preexec_fn=lambda: os.close(1))
    assert (done.returncode, done.stderr) == (0, b"")


def test_a_fault_of_ours_is_told_from_what_did_not_pass(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def broken(arguments: object) -> int:
        raise OSError(5, "a fault of ours")

    monkeypatch.setattr(schema, "_schema", broken)
    assert main(["schema"]) == 70
    errors = capsys.readouterr().err
    assert "in broken" in errors
    assert "a fault of ours, and says nothing about your input" in errors
    assert "issues" in errors


def test_no_message_drives_the_terminal(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["verify", str(tmp_path / "\x1b]0;owned\x07\u202e.json")]) == 2
    assert capsys.readouterr().err.count(r"\x1b]0;owned\x07\u202e.json") == 1


@pytest.mark.parametrize("option", ["--out", "--html"])
class TestWhatVerifyWrites:
    """A file is replaced only when we wrote it, or when that is asked for."""

    @pytest.fixture
    def room(self, tmp_path: Path) -> Path:
        assert main(["generate", "A room with a chair.", "--out", str(tmp_path / "room"), "--no-pictures"]) == 0
        return tmp_path / "room"

    def test_a_strangers_file_is_replaced_only_when_that_is_asked_for(
        self, room: Path, option: str, capsys: pytest.CaptureFixture[str]
    ) -> None:
        file = room.with_name("thesis.tex")
        file.write_text("years of work")
        command = ["verify", str(room), option, str(file)]
        assert main(command) == 2
        assert "is not one that we wrote" in capsys.readouterr().err
        assert file.read_text() == "years of work"
        assert main([*command, "--overwrite"]) == 0
        assert main(command) == 0  # it is ours now

    @pytest.mark.parametrize("name", ["x" * 300, "missing/file", ".", "link", "/dev/null"])
    def test_what_cannot_be_written_is_found_before_any_work(
        self, room: Path, option: str, name: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr("thinkblox.sim.workers.guard.guarded", pytest.fail)
        (room.parent / "link").symlink_to(room / "scene.json")
        before = sorted(room.parent.iterdir())
        assert main(["verify", str(room), option, str(room.parent / name), "--overwrite"]) == 2
        assert len(capsys.readouterr().err) > 30
        assert sorted(room.parent.iterdir()) == before


def test_scene_and_page_are_two_files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = str(tmp_path / "both")
    assert main(["verify", str(tmp_path), "--out", file, "--html", file]) == 2
    assert "cannot be one file" in capsys.readouterr().err


def _run_beside(folder: Path, code: str) -> "subprocess.CompletedProcess[str]":
    """Run a program that finds the modules of a folder first."""
    surroundings = {**os.environ, "PYTHONPATH": os.pathsep.join([str(folder), *filter(None, sys.path)])}
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, env=surroundings)


def test_a_stop_within_an_exec_ends_with_the_status_of_a_stop() -> None:
    code = """
import os, signal, sys
from thinkblox.cli import main, schema
schema._schema = lambda arguments: exec("os.kill(os.getpid(), signal.SIGTERM); signal.pause()")
sys.argv = ["thinkblox", "schema"]
sys.exit(main())
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (130, "thinkblox: stopped; nothing was written\n")


def test_a_stop_while_a_module_loads_waits_until_it_is_loaded(tmp_path: Path) -> None:
    (tmp_path / "slow_module.py").write_text("import os, signal\nos.kill(os.getpid(), signal.SIGTERM)\nloaded = True\n")
    code = """
import sys, time
from thinkblox.cli import main, schema

def loads(arguments):
    import slow_module
    print("loaded", slow_module.loaded, flush=True)
    time.sleep(60.0)

schema._schema = loads
sys.argv = ["thinkblox", "schema"]
sys.exit(main())
"""
    done = _run_beside(tmp_path, code)
    assert (done.returncode, done.stderr) == (130, "thinkblox: stopped; nothing was written\n")


def test_a_stop_that_waits_for_a_module_does_not_end_what_is_held_later(tmp_path: Path) -> None:
    (tmp_path / "slow_module.py").write_text("import os, signal\nos.kill(os.getpid(), signal.SIGTERM)\n")
    code = """
import sys, time
from thinkblox.cli import main, schema
from thinkblox.holding import signals_held

def holds(arguments):
    import slow_module
    with signals_held():
        time.sleep(0.1)
        print("done", flush=True)
    time.sleep(60.0)

schema._schema = holds
sys.argv = ["thinkblox", "schema"]
sys.exit(main())
"""
    done = _run_beside(tmp_path, code)
    assert (done.returncode, done.stdout) == (130, "done\n")
