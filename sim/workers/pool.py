"""Verdicts for trainers: candidates of many scenes in, verdicts in order out, measured by worker processes.

from thinkblox.sim.workers import Job, VerdictPool

with VerdictPool(workers=8) as pool:
    jobs = [Job(scene, asset, candidates) for scene, asset, candidates in batch]
    for job, verdicts in zip(jobs, pool.check(jobs), strict=True):
        rewards = [verdict.r_coll + verdict.r_layout for verdict in verdicts]
"""

import math
import os
import threading
import weakref
from collections import deque
from collections.abc import Generator, Iterable, Sequence
from concurrent.futures import Future
from types import TracebackType
from typing import NamedTuple, Self

import msgspec

from thinkblox.errors import InputError, ThinkBloxError
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.settings import Physics, Tolerances, Walking
from thinkblox.sim.workers.crew import Hand, WaitingLine
from thinkblox.sim.workers.parcel import Keys, Parcel
from thinkblox.sim.workers.wire import Reply, WorkerSettings
from thinkblox.verdict import Verdict

WAITING = 16
"""Jobs for each worker that may wait to be begun."""
AHEAD = 64
"""Jobs for each worker that `VerdictPool.imap` is ahead of its reader, unless told otherwise."""
GIB = 2**30


class Job(NamedTuple):
    """Candidates for one object more in a scene: what World(scene).check takes.

    Attributes:
        scene: what stands there already.
        asset: what all the candidates place.
        candidates: its proposed placements; each is measured by itself.
        way: whether the room must keep a walkable way to its doors and large objects.
    """

    scene: Scene
    asset: Asset
    candidates: Sequence[Placement]
    way: bool = True


class VerdictPool:
    """Measures candidates in worker processes that keep the worlds they have built.

    **What comes out** is what `World(scene, ...).check(candidates, asset, way=way)` gives, to the byte (`to_json`),
    whatever the number of workers, the order of the jobs and what was measured before. A candidate that cannot be
    measured has a verdict too: not valid, with the reason "error" and a `message`. That is so for a mesh that the
    engine refuses, for a candidate over which its worker process died (memory ran out, a fault in the engine), and for
    one that took longer than `timeout`. When a worker is lost, a new one takes its place, and its job is tried once
    more there, candidate by candidate, so that only those to blame go without a measurement.

    **How to feed it.** One prompt of a trainer with its completions is one job if they all place the same asset,
    otherwise one job for each asset; give as many prompts at once as there are. Jobs of one scene, and of scenes that
    grew out of it by one object at the end, go to the worker that has its world as long as no other one is idle. The
    pool may be used from several threads at once; in asyncio, `await asyncio.wrap_future(pool.submit(...))`.

    **Processes.** Workers are fresh interpreters: they import neither your program nor torch, use no GPU, and inherit
    no lock or CUDA context. So a script needs no `if __name__ == "__main__"`, and a notebook will do as well. They
    start when the pool is made, which takes them about a second; a pool is meant to be kept. They are ended by
    `close`, at the end of a `with` block, when the pool is no longer referred to and when the interpreter exits; when
    it is killed they notice, and end as soon as they are done with the job in hand, or hang in it past `timeout`.
    After os.fork the pool belongs to the parent: a child makes its own. Workers need a POSIX system; elsewhere use
    `workers=0`.

    Args:
        workers: processes, each with one thread; best the number of idle cores. With 0 everything is
            measured in this process when it is asked for, to debug: there `timeout` and `memory` do not hold.
        timeout: for one attempt at a job [s]; see above for what happens then. Building the scene's world is part of
            it, a few tenths of a second for a large one.
        tolerances, physics, walking: as World takes them, the same for all jobs.
        worlds: scenes that each worker keeps.
        memory: that each worker may hold between two jobs [GiB]; past it, it lets go of worlds, and is replaced where
            that is not enough (on Linux). The engine alone takes 0.1, a world 0.001 to 0.01.

    Raises:
        InputError: a number out of range.
        ThinkBloxError: the system does not let a process be started.
    """

    def __init__(
        self,
        workers: int = 2,
        *,
        timeout: float = 30.0,
        tolerances: Tolerances | None = None,
        physics: Physics | None = None,
        walking: Walking | None = None,
        worlds: int = 128,
        memory: float = 2.0,
    ) -> None:
        _check(workers, timeout, worlds, memory)
        settings = WorkerSettings(
            tolerances=tolerances or Tolerances(),
            physics=physics or Physics(),
            walking=walking or Walking(),
            timeout=timeout,
            worlds=worlds,
            memory=round(memory * GIB),
        )
        self._keys = Keys()
        self._owner = os.getpid()
        self._ahead = AHEAD * max(1, workers)
        self._hands: list[Hand] = []
        self._line: WaitingLine | _Here = WaitingLine(WAITING * workers) if workers else _Here(settings)
        self._end = weakref.finalize(self, _end, self._line, self._hands, self._owner)
        if isinstance(self._line, WaitingLine):
            self._start(self._line, settings, workers)

    def _start(self, line: WaitingLine, settings: WorkerSettings, workers: int) -> None:
        try:
            for _ in range(workers):
                hand = Hand(line, settings)
                line.join(hand)
                self._hands.append(hand)
        except ThinkBloxError:
            self.close()
            raise
        for hand in self._hands:
            hand.start()

    @property
    def pids(self) -> tuple[int, ...]:
        """Process ids of the workers; one that was lost and is not yet replaced is left out."""
        return tuple(pid for hand in self._hands if (pid := hand.pid) is not None)

    def check(self, jobs: Iterable[Job]) -> list[list[Verdict]]:
        """Measure every candidate of every job; for each job, in order, its candidates' verdicts in order.

        The jobs are read as they are needed, and let go of when they are done: a generator of a million of them never
        has more than a few in memory, beside the verdicts. For a stream without an end there is `imap`.

        Raises:
            ThinkBloxError: the pool is closed, or no worker can be started any more.
            InputError: a job that is not made of a Scene, an Asset and Placements.
        """
        return list(self._ordered(jobs, math.inf))

    def imap(self, jobs: Iterable[Job], *, ahead: int | None = None) -> Generator[list[Verdict]]:
        """As `check`, one job's verdicts after the other, as soon as those before it are there; also without an end.

        Between two of them the workers go on with the jobs after; with at most `ahead` jobs that were read from
        `jobs` and not yet handed out, which is all that is kept. What was begun and is not read to the end is given up.
        """
        return self._ordered(jobs, max(1, self._ahead if ahead is None else ahead))

    def _ordered(self, jobs: Iterable[Job], ahead: float) -> Generator[list[Verdict]]:
        answers: deque[Future[list[Verdict]]] = deque()
        try:
            for job in jobs:
                answers.append(self.submit(*job))
                while answers and (len(answers) >= ahead or answers[0].done()):
                    yield answers.popleft().result()
            while answers:
                yield answers.popleft().result()
        finally:
            _drop(answers)

    def check_one(self, scene: Scene, asset: Asset, candidates: Sequence[Placement], way: bool = True) -> list[Verdict]:
        """The verdicts on the candidates of one job."""
        return self.check([Job(scene, asset, candidates, way)])[0]

    def submit(
        self, scene: Scene, asset: Asset, candidates: Sequence[Placement], way: bool = True
    ) -> Future[list[Verdict]]:
        """Begin one job and have its verdicts later; waits only while `WAITING` jobs for each worker do.

        Raises:
            ThinkBloxError: as `check`; what ends the pool afterwards is raised by the future's `result`.
        """
        if os.getpid() != self._owner:
            raise ThinkBloxError("this pool was made before a fork, by the parent process; make another one here")
        parcel = _parcel(self._keys, Job(scene, asset, candidates, way))
        self._line.put(parcel)
        return parcel.answer

    def close(self) -> None:
        """End the workers at once and wait for that; what is not finished fails with ThinkBloxError."""
        self._end()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()


class _Here:
    """A line without hands: whoever puts a job in has to wait for it to be done."""

    def __init__(self, settings: WorkerSettings) -> None:
        from thinkblox.sim.workers.worker import Worlds

        self._worlds = Worlds(settings)
        self._known: set[bytes] = set()
        self._lock = threading.Lock()
        self._over: ThinkBloxError | None = None

    def put(self, parcel: Parcel) -> None:
        """Do the job."""
        if self._over is not None:
            raise self._over
        every = range(len(parcel.ids))
        with self._lock:
            answer = msgspec.msgpack.decode(self._worlds.answer(parcel.task(self._known, every)), type=Reply)
            parcel.answer.set_result(parcel.verdicts(answer, self._known, every))

    def close(self, why: ThinkBloxError) -> None:
        """Do no more."""
        self._over = why


def _check(workers: int, timeout: float, worlds: int, memory: float) -> None:
    if not 0 <= workers <= 1024:
        raise InputError(f"a pool of {workers} workers cannot be made; give 1 to 1024, or 0 to measure in this process")
    if not (math.isfinite(timeout) and timeout > 0.0):
        raise InputError(f"a timeout of {timeout} s is no time limit; give seconds, more than 0")
    if worlds < 1:
        raise InputError(f"{worlds} worlds are too few; a worker keeps 1 or more")
    if not 0.0 < memory < math.inf:
        raise InputError(
            f"{memory:g} GiB cannot be a worker's memory; give more than 0.1, which the engine alone takes"
        )


def _parcel(keys: Keys, job: Job) -> Parcel:
    parts = ((job.scene, Scene), (job.asset, Asset), *((candidate, Placement) for candidate in job.candidates))
    for part, kind in parts:
        if not isinstance(part, kind):
            raise InputError(f"a job (scene, asset, candidates) has a {type(part).__name__} for its {kind.__name__}")
    return Parcel(keys, *job)


def _drop(answers: Iterable[Future[list[Verdict]]]) -> None:
    for answer in answers:
        answer.cancel()


def _end(line: WaitingLine | _Here, hands: list[Hand], owner: int) -> None:
    # A child that was forked has a copy of the pool, but the processes are not its own.
    if os.getpid() != owner:
        return
    line.close(ThinkBloxError("the pool is closed"))
    for hand in hands:
        hand.stop()
    for hand in hands:
        hand.wait()
