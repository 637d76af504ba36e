"""What pool and guard stand on: children that end with all they started, and nothing held longer than it is needed."""

import gc
import os
import signal
import subprocess
import sys
import textwrap
import time
import weakref
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.sim_rooms import asset, put, scene
from thinkblox.errors import InputError
from thinkblox.scene.placement import Placement
from thinkblox.sim.settings import Physics, Tolerances, Walking
from thinkblox.sim.workers import crew, pool
from thinkblox.sim.workers.child import Child, EndedError
from thinkblox.sim.workers.guard import guarded
from thinkblox.sim.workers.parcel import Parcel
from thinkblox.sim.workers.pool import Job, VerdictPool
from thinkblox.sim.workers.process import WorkerProcess
from thinkblox.sim.workers.wire import WorkerSettings

CRATE = asset("crate", (0.5, 0.5, 0.5))


def job(n: int = 0) -> Job:
    return Job(scene(), CRATE, [put(CRATE, 1.0 + n / 1000, 2.0)])


def within(seconds: float, happens: Callable[[], bool]) -> bool:
    until = time.monotonic() + seconds
    while not (done := happens()) and time.monotonic() < until:
        time.sleep(0.01)
    return done


def runs(pid: int) -> bool:
    """Whether a process is there, and no zombie that waits for the first process to see to it."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except FileNotFoundError:
        return False


def start_another() -> int:
    return subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"]).pid


def fork_and_leave(status: int, note: Path) -> None:
    """End, while a copy of this process that holds all it held goes on."""
    child = os.fork()
    if not child:
        time.sleep(600.0)
    note.write_text(str(child))
    os._exit(status)


def test_what_a_guarded_function_starts_ends_with_it() -> None:
    pid = guarded(start_another, seconds=60)
    assert within(5.0, lambda: not runs(pid))


def test_a_death_is_seen_though_somebody_else_holds_the_socket(tmp_path: Path) -> None:
    begun = time.monotonic()
    with pytest.raises(InputError, match=r"exit status 3\)"):
        guarded(fork_and_leave, 3, tmp_path / "pid", seconds=300)
    assert time.monotonic() - begun < 60.0
    left = int((tmp_path / "pid").read_text())
    assert within(5.0, lambda: not runs(left))


def test_a_child_that_is_gone_says_how_and_can_be_ended_again() -> None:
    child = Child("thinkblox.sim.workers.no_such_module")
    for _ in range(2):
        with pytest.raises(EndedError, match="exit status 1") as caught:
            child.receive(until=time.monotonic() + 60.0)
    assert not caught.value.killed
    assert not child.alive
    child.end()
    child.end()
    child.kill()


def test_a_child_that_says_nothing_in_time_is_still_there() -> None:
    child = Child("thinkblox.sim.workers.fence")
    with pytest.raises(TimeoutError):
        child.receive(until=time.monotonic() + 0.05)
    assert child.alive
    child.end()
    assert not child.alive


MAIN = """
from thinkblox.errors import InputError
from thinkblox.sim.workers.guard import guarded

def double(number):
    return 2 * number

def quadruple(number):
    return guarded(double, 2 * number, seconds=60)
"""


def script(tmp_path: Path, body: str) -> tuple[int, str]:
    """Exit status and output of a script."""
    file = tmp_path / "script.py"
    file.write_text(MAIN + textwrap.dedent(body))
    done = subprocess.run([sys.executable, str(file)], capture_output=True, text=True, timeout=60, check=False)
    return done.returncode, done.stdout


def test_a_function_of_the_script_itself_can_be_guarded_also_from_within(tmp_path: Path) -> None:
    body = """
    if __name__ == "__main__":
        print(guarded(double, 21, seconds=60), guarded(quadruple, 21, seconds=60))
    """
    assert script(tmp_path, body) == (0, "42 84\n")


def test_a_script_that_would_call_itself_for_ever_is_told_so(tmp_path: Path) -> None:
    body = """
    try:
        print(guarded(double, 21, seconds=60))
    except InputError as error:
        print("told:", error)
        raise
    """
    status, said = script(tmp_path, body)
    assert status == 1
    assert said.startswith("told: double is to be called")
    assert 'put the call under `if __name__ == "__main__":`' in said


def test_a_worker_that_is_killed_again_and_again_while_it_starts_does_not_close_the_pool(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(crew, "PAUSE", 0.01)
    with VerdictPool(workers=1) as only:
        killed: set[int] = set()
        while len(killed) < crew.STARTS + 2:
            assert within(20.0, lambda: bool({*only.pids} - killed))
            (pid,) = only.pids
            os.kill(pid, signal.SIGKILL)
            killed.add(pid)
        assert only.check_one(*job())[0].valid


@pytest.mark.slow
def test_a_pool_whose_workers_are_killed_for_ever_says_so(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    killed = tmp_path / "python"
    killed.write_text("#!/bin/sh\nkill -9 $$\n")
    killed.chmod(0o755)
    monkeypatch.setattr(sys, "executable", str(killed))
    monkeypatch.setattr(crew, "PAUSE", 0.001)
    with (
        VerdictPool(workers=1) as doomed,
        pytest.raises(Exception, match=rf"{crew.KILLED} attempts to start a worker failed.*SIGKILL"),
    ):
        doomed.check_one(*job())


def test_a_pool_is_closed_at_once_while_it_waits_to_start_a_worker_again(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(sys, "executable", "/bin/false")
    monkeypatch.setattr(crew, "PAUSE", 60.0)
    monkeypatch.setattr(crew, "LONGEST_PAUSE", 60.0)
    waiting = VerdictPool(workers=1)
    assert within(20.0, lambda: not waiting.pids)
    begun = time.monotonic()
    waiting.close()
    assert time.monotonic() - begun < 30.0


def test_a_worker_that_has_ended_knows_nothing() -> None:
    settings = WorkerSettings(Tolerances(), Physics(), Walking(), timeout=30.0, worlds=1, memory=2**30)
    process = WorkerProcess(settings)
    process.known.add(b"a scene")
    process.end()
    assert not process.known


class Watched(list[Placement]):
    """Candidates of which it can be told whether anybody holds them."""


@pytest.mark.slow
@pytest.mark.parametrize("workers", [0, 1])
@pytest.mark.parametrize("ask", ["check", "imap"])
def test_a_job_is_held_no_longer_than_it_is_needed(monkeypatch: pytest.MonkeyPatch, workers: int, ask: str) -> None:
    held: list[weakref.ref[object]] = []
    most = [0]
    make = pool._parcel

    def watched(*parts) -> Parcel:
        parcel = make(*parts)
        held.append(weakref.ref(parcel))
        held.append(weakref.ref(parcel.answer))
        return parcel

    def jobs() -> Iterator[Job]:
        for n in range(200):
            candidates = Watched(job(n).candidates)
            held.append(weakref.ref(candidates))
            most[0] = max(most[0], sum(ref() is not None for ref in held))
            yield Job(scene(), CRATE, candidates)
            del candidates

    monkeypatch.setattr(pool, "_parcel", watched)
    with VerdictPool(workers=workers) as asked:
        got = sum(len(verdicts) for verdicts in getattr(asked, ask)(jobs()))
        assert got == 200
        gc.collect()
        assert most[0] <= 3 * (pool.WAITING + 4), "not one of each for each of the jobs"
        assert within(5.0, lambda: not any(ref() is not None for ref in held))


def test_a_stream_without_an_end_is_read_no_further_than_asked() -> None:
    read = [0]

    def endless() -> Iterator[Job]:
        while True:
            read[0] += 1
            yield job(read[0])

    with VerdictPool(workers=1) as asked:
        stream = asked.imap(endless(), ahead=3)
        for n in range(20):
            assert next(stream)[0].valid
            assert read[0] <= n + 1 + 3
        stream.close()
