"""Foreign input is handled in a process of its own: what it does there, a caller sees as a result or an InputError."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from thinkblox.errors import InputError
from thinkblox.sim.foreign.opening import open_model
from thinkblox.sim.workers.guard import guarded

SMALL_ROOM = """<mujoco><worldbody><geom type="plane" size="5 5 .1"/>
<body name="crate" pos="0 0 .1"><freejoint/><geom type="box" size=".1 .1 .1"/></body></worldbody></mujoco>"""


def double(number: int) -> int:
    return 2 * number


def refuse(text: str) -> None:
    raise InputError(text)


def fail(text: str) -> None:
    raise KeyError(text)


def crash(number: int, _path: Path | None = None) -> None:
    os.kill(os.getpid(), number)


def leave(status: int) -> None:
    os._exit(status)


def sleep(seconds: float) -> None:
    time.sleep(seconds)


def devour(_path: Path) -> int:
    return int(np.ones(2**31, dtype=np.float64).sum())


def test_a_result_comes_back() -> None:
    assert guarded(double, 21, seconds=60) == 42


def test_a_subject_comes_back(tmp_path: Path) -> None:
    file = tmp_path / "room.xml"
    file.write_text(SMALL_ROOM)
    subject = guarded(open_model, file, seconds=60)
    assert [thing.id for thing in subject.things] == ["crate"]
    assert subject.model.ngeom == 2


def test_input_errors_are_raised_as_they_are() -> None:
    with pytest.raises(InputError, match=r"^room\.xml:3: no such mesh$"):
        guarded(refuse, "room.xml:3: no such mesh", seconds=60)


def test_other_errors_keep_their_kind_and_tell_where_they_came_from() -> None:
    with pytest.raises(KeyError, match="nothing here") as caught:
        guarded(fail, "nothing here", seconds=60)
    assert "in fail" in caught.value.__notes__[0]


@pytest.mark.parametrize(("number", "name"), [(signal.SIGSEGV, "SIGSEGV"), (signal.SIGABRT, "SIGABRT")])
def test_a_crash_is_an_input_error_that_names_file_and_signal(number: int, name: str) -> None:
    with pytest.raises(InputError, match=rf"crashed \(signal {int(number)}, {name}\) while reading room\.xml"):
        guarded(crash, int(number), Path("models/room.xml"), seconds=60)


def test_a_process_killed_from_outside_is_told_apart() -> None:
    with pytest.raises(InputError, match=r"killed \(signal 9\) while measuring it"):
        guarded(crash, int(signal.SIGKILL), seconds=60, doing="measuring it")


def test_a_process_that_leaves_without_an_answer_is_an_input_error() -> None:
    with pytest.raises(InputError, match=r"exit status 3\) while running leave"):
        guarded(leave, 3, seconds=60)


def test_what_takes_too_long_is_stopped() -> None:
    begin = time.monotonic()
    with pytest.raises(InputError, match=r"longer than 0\.5 s and was stopped while running sleep"):
        guarded(sleep, 60.0, seconds=0.5)
    assert time.monotonic() - begin < 20.0


def test_what_asks_for_too_much_memory_is_an_input_error() -> None:
    with pytest.raises(InputError, match=r"memory allowed, 3 GiB, ran out while reading room\.xml"):
        guarded(devour, Path("room.xml"), seconds=60, memory=3 * 2**30)


SCRIPT = """
import signal, sys, time
from thinkblox.sim.workers.guard import guarded
# What is started in the background of a script ignores it.
signal.signal(signal.SIGINT, signal.default_int_handler)
print("ready", flush=True)
guarded(time.sleep, 600.0, seconds=600.0)
"""


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT, signal.SIGKILL])
def test_the_end_of_the_parent_is_the_end_of_the_child(tmp_path: Path, number: int) -> None:
    script = tmp_path / "script.py"
    script.write_text(SCRIPT)
    with subprocess.Popen([sys.executable, str(script)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as parent:
        assert parent.stdout is not None
        parent.stdout.readline()
        child = _wait_for_child(parent.pid)
        parent.send_signal(number)
        parent.wait(120)
        assert _gone(child)


def _wait_for_child(parent: int) -> int:
    """The child that runs the function, once it runs our module."""
    for _ in range(400):
        for pid in Path(f"/proc/{parent}/task/{parent}/children").read_text().split():
            if b"thinkblox.sim.workers" in Path(f"/proc/{pid}/cmdline").read_bytes():
                time.sleep(1.0)
                return int(pid)
        time.sleep(0.05)
    raise AssertionError("the guarded process did not start")


def _gone(pid: int) -> bool:
    for _ in range(100):
        try:
            if Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] == "Z":
                return True
        except OSError:
            return True
        time.sleep(0.05)
    return False


def test_a_script_without_a_main_guard_may_use_it(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        "import math\nfrom thinkblox.sim.workers.guard import guarded\nprint(guarded(math.sqrt, 2.25, seconds=60))\n"
    )
    done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, timeout=60, check=False)
    assert (done.stdout, done.returncode) == ("1.5\n", 0), done.stderr
