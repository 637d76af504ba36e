"""The verdict pool with real worker processes: what comes out, what becomes of lost ones, what is left behind."""

import asyncio
import contextlib
import gc
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from pathlib import Path

import numpy as np
import pytest
from msgspec import structs

from tests.sim_rooms import asset, put, scene, table, vase, wardrobe
from thinkblox.errors import InputError, ThinkBloxError
from thinkblox.scene.asset import Asset, Shape
from thinkblox.scene.scene import Scene
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.world import World
from thinkblox.sim.workers import crew
from thinkblox.sim.workers.parcel import Keys, Parcel
from thinkblox.sim.workers.pool import WAITING, Job, VerdictPool
from thinkblox.sim.workers.process import WorkerProcess
from thinkblox.sim.workers.wire import WorkerSettings
from thinkblox.value import from_json, to_json
from thinkblox.verdict import Verdict

CRATE = asset("crate", (0.5, 0.5, 0.5))
ENDLESS = Physics(timestep=1e-9, settle_time=1e9, lost=1e9)
"""What is let go in the air falls for hours."""
SLOW = Physics(timestep=1e-4, settle_time=1e9, lost=1e9)
"""What is let go in the air falls for some tenths of a second."""


@pytest.fixture(scope="module")
def pool() -> Iterator[VerdictPool]:
    with VerdictPool(workers=2) as shared:
        yield shared


def jobs() -> list[Job]:
    """Scenes that grow out of one another and scenes that do not, of one object and of several."""
    found: list[Job] = []
    grown = scene()
    for kind, x, y in ((table(), 2.0, 2.0), (CRATE, 0.6, 0.6), (wardrobe(), 0.31, 4.0), (CRATE, 3.4, 4.4)):
        grown = grown.with_placement(put(kind, x, y, id=f"{kind.category}_{len(grown.placements)}"), kind)
        heights = (0.75, 0.7501, 0.70, 0.9)
        found.append(Job(grown, vase(), [put(vase(), 1.6 + 0.3 * n, 2.0, z) for n, z in enumerate(heights)]))
        found.append(Job(grown, CRATE, [put(CRATE, x, 3.0, id="crate_9") for x in (0.6, 1.5, 3.4)]))
    found += [Job(scene(None, (put(CRATE, x, 2.0), CRATE)), table(), [put(table(), 2.0, 2.0)]) for x in (1.0, 2.0, 3.0)]
    return found


def crates(count: int, *, of: Scene | None = None, height: float = 0.0) -> Job:
    return Job(of or scene(), CRATE, [put(CRATE, 0.5 + 0.01 * n, 2.0, height) for n in range(count)])


def directly(job: Job, physics: Physics | None = None) -> list[bytes]:
    return encoded(World(job.scene, physics=physics).check(job.candidates, job.asset, way=job.way))


def encoded(verdicts: list[Verdict]) -> list[bytes]:
    # Read again first: a whole number that stands for a length is the same length.
    return [to_json(from_json(to_json(verdict), Verdict)) for verdict in verdicts]


def within(seconds: float, happens: Callable[[], bool]) -> bool:
    until = time.monotonic() + seconds
    while not (done := happens()) and time.monotonic() < until:
        time.sleep(0.02)
    return done


def gone(pids: tuple[int, ...] | list[int]) -> bool:
    """Neither running nor a zombie."""
    return not any(exists(pid) for pid in pids)


def exists(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


@pytest.mark.parametrize("workers", [0, 1, 3])
def test_any_number_of_workers_in_any_order_gives_the_bytes_of_a_world(workers: int) -> None:
    every = jobs()
    expected = [directly(job) for job in every]
    order = np.random.default_rng(workers).permutation(len(every))
    with VerdictPool(workers=workers, worlds=3) as pool:
        for turn in (range(len(every)), order, order[::-1]):
            got = pool.check(every[n] for n in turn)
            assert [encoded(verdicts) for verdicts in got] == [expected[n] for n in turn]


def test_a_stream_keeps_the_order_and_is_not_far_ahead(pool: VerdictPool) -> None:
    every, read = jobs(), [0]
    out: list[list[bytes]] = []

    def counted() -> Iterator[Job]:
        for job in every * 3:
            read[0] += 1
            yield job

    for verdicts in pool.imap(counted(), ahead=4):
        assert read[0] - len(out) <= 4
        out.append(encoded(verdicts))
        if len(out) == 5:
            assert encoded(pool.check_one(*every[0])) == directly(every[0])
    assert out == [directly(job) for job in every] * 3


def test_a_long_generator_never_has_many_jobs_in_memory() -> None:
    begun: list[Future[list[Verdict]]] = []
    most = [0]

    class Watched(VerdictPool):
        def submit(self, *job, **more):
            begun.append(super().submit(*job, **more))
            return begun[-1]

    def many() -> Iterator[Job]:
        for n in range(400):
            most[0] = max(most[0], sum(not answer.done() for answer in begun[-200:]))
            yield Job(scene(), CRATE, [put(CRATE, 1.0 + n / 1000, 2.0, 0.0 if n % 2 else -0.1)])

    with Watched(workers=2) as pool:
        verdicts = pool.check(many())
    assert [v[0].valid for v in verdicts] == [n % 2 == 1 for n in range(400)]
    assert most[0] <= 2 * WAITING + 2


def test_threads_share_a_pool(pool: VerdictPool) -> None:
    every = jobs()
    got: dict[int, list[list[bytes]]] = {}

    def ask(n: int) -> None:
        got[n] = [encoded(verdicts) for verdicts in pool.check(every[n:] + every[:n])]

    threads = [threading.Thread(target=ask, args=(n,)) for n in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    expected = [directly(job) for job in every]
    assert got == {n: expected[n:] + expected[:n] for n in range(4)}


def test_it_can_be_awaited(pool: VerdictPool) -> None:
    async def ask() -> list[list[Verdict]]:
        return await asyncio.gather(*(asyncio.wrap_future(pool.submit(*job)) for job in jobs()[:3]))

    assert [encoded(verdicts) for verdicts in asyncio.run(ask())] == [directly(job) for job in jobs()[:3]]


def test_a_job_without_candidates_has_no_verdicts(pool: VerdictPool) -> None:
    assert pool.check([]) == []
    assert pool.check([Job(scene(), CRATE, []), crates(1)])[0] == []


def test_assets_of_one_id_are_told_apart_by_what_they_are(pool: VerdictPool) -> None:
    low, high = (asset("box", (0.5, 0.5, height)) for height in (0.3, 0.6))
    assert low.id == high.id
    for _ in range(2):
        for kind, other in ((low, high), (high, low)):
            job = Job(scene(None, (put(kind, 2.0, 2.0), kind)), vase(), [put(vase(), 2.0, 2.0, z) for z in (0.3, 0.6)])
            assert encoded(pool.check_one(*job)) == directly(job)
            job = Job(scene(), other, [put(other, 2.0, 2.0)])
            assert encoded(pool.check_one(*job)) == directly(job)


def test_numbers_of_numpy_are_numbers(pool: VerdictPool) -> None:
    x = np.float64(2.0)
    there = structs.replace(put(CRATE, 0.0, 0.0), position=(x, np.float32(2.0), np.int64(0)), yaw=np.float64(90.0))
    plain = put(CRATE, 2.0, 2.0, 0.0, 90.0)
    assert pool.check_one(scene(), CRATE, [there]) == pool.check_one(scene(), CRATE, [plain])


def test_only_the_candidate_that_cannot_be_read_goes_without_a_verdict(pool: VerdictPool) -> None:
    far = put(CRATE, 2.0, 2.0, id="far")
    structs.force_setattr(far, "position", (1e9, 0.0, 0.0))
    good = put(CRATE, 2.0, 2.0)
    first, second, third = pool.check_one(scene(), CRATE, [good, far, good])
    assert first == third
    assert first.valid
    assert (second.id, second.valid, second.reasons) == ("far", False, ("error",))
    assert "position" in second.message


def test_a_mesh_that_the_engine_refuses_is_an_error_verdict(pool: VerdictPool) -> None:
    tiny = crumb()
    verdicts = pool.check_one(scene(), tiny, [put(tiny, 2.0, 2.0), put(tiny, 1.0, 1.0, id="other")])
    assert [v.id for v in verdicts] == ["crumb_1", "other"]
    assert {v.reasons for v in verdicts} == {("error",)}
    assert all("volume" in v.message for v in verdicts), verdicts
    assert encoded(pool.check_one(*crates(2))) == directly(crates(2))


def crumb() -> Asset:
    corners = ((0.0, 0.0, 0.0), (3e-6, 0.0, 0.0), (0.0, 3e-6, 0.0), (0.0, 0.0, 3e-6))
    return asset("crumb", (0.3, 0.3, 0.3), Shape(kind="hull", size=(3e-6,) * 3, position=(0.0,) * 3, points=corners))


def test_what_is_no_job_is_refused_to_whoever_gave_it(pool: VerdictPool) -> None:
    with pytest.raises(InputError, match="str for its Asset"):
        pool.check_one(scene(), "crate", [])  # type: ignore[arg-type]
    odd = put(CRATE, 2.0, 2.0)
    structs.force_setattr(odd, "support", object())
    with pytest.raises(InputError, match="object"):
        pool.check_one(scene(), CRATE, [odd])


def test_an_iterator_that_fails_leaves_the_pool_as_it_was(pool: VerdictPool) -> None:
    def broken() -> Iterator[Job]:
        yield from jobs()
        raise LookupError("the caller's own")

    with pytest.raises(LookupError, match="own"):
        pool.check(broken())
    with pytest.raises(LookupError, match="own"):
        list(pool.imap(broken()))
    begun = pool.imap(jobs())
    next(begun)
    begun.close()
    assert encoded(pool.check_one(*crates(2))) == directly(crates(2))


def test_a_worker_that_is_killed_is_replaced_and_its_job_done_again() -> None:
    job = crates(5, height=0.5)
    with VerdictPool(workers=1, physics=SLOW) as pool:
        (first,) = pool.pids
        answer = pool.submit(*job)
        assert within(60.0, answer.running)
        time.sleep(0.1)
        assert not answer.done()
        os.kill(first, signal.SIGKILL)
        assert encoded(answer.result()) == directly(job, SLOW)
        (second,) = pool.pids
        assert second != first
        os.kill(second, signal.SIGKILL)
        assert within(5.0, lambda: not pool.pids)
        assert encoded(pool.check_one(*job)) == directly(job, SLOW), "one that dies while idle is replaced too"
    assert gone([first, second])


@pytest.mark.slow
def test_a_worker_that_stands_still_is_replaced_while_the_others_go_on() -> None:
    every = jobs()
    with VerdictPool(workers=2, timeout=2.0) as pool:
        assert within(60.0, lambda: bool(pool.check(every)) and all(hand._process.known for hand in pool._hands))
        stopped = pool.pids[0]
        os.kill(stopped, signal.SIGSTOP)
        start = time.monotonic()
        got = pool.check(every * 2)
        assert 2.0 <= time.monotonic() - start < 60.0
        assert [encoded(verdicts) for verdicts in got] == [directly(job) for job in every] * 2
        assert stopped not in pool.pids
        assert gone([stopped])


@pytest.mark.slow
def test_only_the_candidate_that_hangs_goes_without_a_verdict() -> None:
    room = scene(None, (put(CRATE, 2.0, 2.0), CRATE))
    hangs = put(CRATE, 1.0, 1.0, 1.0, id="crate_7")
    gated = [put(CRATE, x, 2.0, id=f"crate_{n}") for n, x in ((3, 2.1), (4, 1.9), (5, -1.0))]
    with VerdictPool(workers=1, timeout=1.0, physics=ENDLESS) as pool:
        verdicts = pool.check_one(room, CRATE, [gated[0], hangs, *gated[1:]])
    assert [v.id for v in verdicts] == ["crate_3", "crate_7", "crate_4", "crate_5"]
    assert [v.reasons[0] for v in verdicts] == ["collision", "error", "collision", "outside"]
    assert "no answer for 1 s" in verdicts[1].message


@pytest.mark.slow
def test_a_job_of_which_nothing_can_be_measured_ends_soon(monkeypatch: pytest.MonkeyPatch) -> None:
    started: list[int] = []

    class Counted(WorkerProcess):
        def __init__(self, settings: WorkerSettings) -> None:
            super().__init__(settings)
            started.append(self.pid)

    monkeypatch.setattr(crew, "WorkerProcess", Counted)
    with VerdictPool(workers=1, timeout=0.5, physics=ENDLESS) as pool:
        verdicts = pool.check_one(*crates(8, height=1.0))
        # One is lost over all of them, one each over the first two; a fourth may be there for what comes next.
        assert len(started) <= 4
    assert {v.reasons for v in verdicts} == {("error",)}
    assert [v.id for v in verdicts] == ["crate_1"] * 8
    assert "was not tried" in verdicts[-1].message


def test_workers_that_all_die_at_once_are_an_error_and_nothing_waits(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", "/bin/false")
    with VerdictPool(workers=2) as pool:
        with pytest.raises(ThinkBloxError, match="exit status 1"):
            pool.check(jobs() * 20)
        with pytest.raises(ThinkBloxError, match="exit status 1"):
            pool.check_one(*crates(1))
        assert pool.pids == ()


def test_no_process_at_all_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", "/no/such/python")
    with pytest.raises(ThinkBloxError, match="/no/such/python"):
        VerdictPool(workers=2)


@pytest.mark.slow
def test_a_pool_that_loses_the_means_to_replace_a_worker_goes_on_with_the_others(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with VerdictPool(workers=2) as pool:
        pool.check(jobs())
        monkeypatch.setattr(sys, "executable", "/no/such/python")
        os.kill(pool.pids[0], signal.SIGKILL)
        got = pool.check(jobs() * 2)
        assert [encoded(verdicts) for verdicts in got] == [directly(job) for job in jobs()] * 2
        assert len(pool.pids) == 1
        os.kill(pool.pids[0], signal.SIGKILL)
        with pytest.raises(ThinkBloxError, match="attempts to start a worker failed"):
            pool.check(jobs())


def test_closing_ends_everything_at_once_even_in_the_midst_of_a_job() -> None:
    pool = VerdictPool(workers=2, physics=ENDLESS)
    pids = pool.pids
    answers = [pool.submit(*crates(1, height=1.0)) for _ in range(5)]
    assert within(60.0, answers[0].running)
    start = time.monotonic()
    pool.close()
    assert time.monotonic() - start < 20.0
    assert gone(pids)
    for answer in answers:
        with pytest.raises(ThinkBloxError, match="closed"):
            answer.result(timeout=3.0)
    with pytest.raises(ThinkBloxError, match="closed"):
        pool.check_one(*crates(1))
    pool.close()


def test_a_pool_that_nobody_refers_to_is_ended() -> None:
    pool = VerdictPool(workers=1)
    pids = pool.pids
    answer = pool.submit(*crates(1))
    answer.result()
    del pool
    gc.collect()
    assert gone(pids)


def test_a_worker_that_holds_too_much_memory_lets_go_of_it_and_is_replaced() -> None:
    pids: list[int] = []
    with VerdictPool(workers=1, memory=0.001) as pool:
        for job in jobs()[:2]:
            assert within(60.0, lambda: bool(pool.pids))
            pids += pool.pids
            assert encoded(pool.check_one(*job)) == directly(job)
        assert len({*pids}) == 2
        assert within(60.0, lambda: gone(pids))
        assert not any(hand._process.known for hand in pool._hands)


@pytest.mark.slow
def test_whatever_happens_to_the_workers_every_job_is_answered_and_no_measure_is_wrong() -> None:
    every = jobs() * 40
    expected = [directly(job) for job in jobs()] * 40
    rng = np.random.default_rng(3)
    over = threading.Event()

    def harm() -> None:
        while not over.wait(float(rng.uniform(0.2, 1.0))):
            if pids := [hand._process.pid for hand in hurt._hands if hand._process.known]:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(int(rng.choice(pids)), signal.SIGSTOP if rng.random() < 0.2 else signal.SIGKILL)

    with VerdictPool(workers=3, timeout=1.0) as hurt:
        harmful = threading.Thread(target=harm)
        harmful.start()
        try:
            got = list(hurt.imap(every))
        finally:
            over.set()
            harmful.join()
    assert len(got) == len(every)
    measured = 0
    for verdicts, right in zip(got, expected, strict=True):
        for verdict, one in zip(verdicts, right, strict=True):
            assert verdict.reasons == ("error",) or encoded([verdict]) == [one]
            measured += verdict.reasons != ("error",)
    assert measured > 0.8 * sum(len(right) for right in expected)


def test_numbers_out_of_range_are_refused() -> None:
    for wrong in ({"workers": -1}, {"timeout": 0.0}, {"timeout": float("nan")}, {"worlds": 0}, {"memory": 0.0}):
        with pytest.raises(InputError):
            VerdictPool(**wrong)


START = """
import os, signal, sys, time
from tests.test_pool import ENDLESS, crates
from thinkblox.sim.workers.pool import VerdictPool
# What is started in the background of a script ignores it.
signal.signal(signal.SIGINT, signal.default_int_handler)
pool = VerdictPool(workers=2)
pool.check([crates(1), crates(2)])
print(*pool.pids, flush=True)
"""


def ended_script(body: str, send: signal.Signals | None = None) -> tuple[int, list[int], str]:
    """Run a script, from standard input as in a shell, that makes a pool: exit status, the workers, stderr."""
    process = subprocess.Popen(
        [sys.executable, "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stdin is not None
    assert process.stdout is not None
    process.stdin.write(START + textwrap.dedent(body))
    process.stdin.close()
    pids = [int(pid) for pid in process.stdout.readline().split()]
    assert len(pids) == 2
    if send is not None:
        time.sleep(0.2)
        process.send_signal(send)
    process.stdout.read()
    assert process.stderr is not None
    return process.wait(timeout=20.0), pids, process.stderr.read()


def ended(pids: list[int]) -> bool:
    """None runs; one whose parent was killed may still be a zombie, until the first process sees to it."""
    return all(not exists(pid) or state(pid) in "ZX" for pid in pids)


def state(pid: int) -> str:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    except FileNotFoundError:
        return "X"


@pytest.mark.parametrize(
    ("body", "send", "status"),
    [
        ("", None, 0),
        pytest.param("raise LookupError", None, 1, marks=pytest.mark.slow),
        ("pool.check(crates(1) for _ in range(10**9))", signal.SIGINT, -signal.SIGINT),
        pytest.param("time.sleep(60)", signal.SIGTERM, -signal.SIGTERM, marks=pytest.mark.slow),
        ("pool.check(crates(1) for _ in range(10**9))", signal.SIGKILL, -signal.SIGKILL),
    ],
    ids=["end", "error", "Ctrl-C", "SIGTERM", "SIGKILL"],
)
def test_a_script_leaves_no_process_behind(body: str, send: signal.Signals | None, status: int) -> None:
    code, pids, _ = ended_script(body, send)
    assert code == status
    assert within(5.0, lambda: ended(pids) if send else gone(pids))


def test_a_forked_child_leaves_its_parents_workers_alone() -> None:
    code, pids, stderr = ended_script("""
        from thinkblox.errors import ThinkBloxError
        child = os.fork()
        if not child:
            try:
                pool.check([crates(1)])
            except ThinkBloxError as error:
                sys.exit(7 if "fork" in str(error) else 8)
        assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7
        before = pool.pids
        pool.check([crates(3)])
        assert pool.pids == before
    """)
    assert code == 0, stderr
    assert within(5.0, lambda: gone(pids))


def test_a_scene_is_sent_once_and_then_only_what_came_to_it() -> None:
    keys, known = Keys(), set[bytes]()
    first = scene(None, (put(table(), 2.0, 2.0), table()), (put(wardrobe(), 0.31, 4.0), wardrobe()))
    grown = first.with_placement(put(CRATE, 3.0, 3.0), CRATE)

    def size(of: Scene, kind: Asset) -> int:
        parcel = Parcel(keys, of, kind, [put(kind, 1.0, 1.0, id="new")], True)
        sent = len(parcel.task(known, [0]))
        known.update((parcel.keys[-1], *(keys.of_asset(a) for a in (*of.assets.values(), kind))))
        return sent

    whole, again, more = size(first, vase()), size(first, vase()), size(grown, CRATE)
    assert again < 250 < 1000 < whole
    assert more < 800
    assert size(structs.replace(first, prompt="another prompt", seed=3), vase()) == again


def test_a_scene_stays_with_the_worker_that_knows_it_and_what_grows_out_of_it_too() -> None:
    found = [scene(None, (put(CRATE, 0.5 + 0.1 * n, 1.0), CRATE)) for n in range(4)]
    found += [room.with_placement(put(table(), 2.0, 3.0), table()) for room in found]
    with VerdictPool(workers=2) as pool:
        for job in [crates(2, of=room) for room in found for _ in range(4)]:
            pool.check_one(*job)
        having = [[hand for hand in pool._hands if key in hand._process.known] for key in map(last_key, found)]
    assert [len(hands) for hands in having] == [1] * 8
    assert having[:4] == having[4:]


def last_key(of: Scene) -> bytes:
    return Keys().of_scene(of)[-1]


def test_more_scenes_than_are_kept_are_built_again() -> None:
    rooms = [scene(None, (put(CRATE, 0.5 + 0.05 * n, 1.0), CRATE)) for n in range(5)]
    every = [crates(1, of=room) for room in rooms] * 3
    with VerdictPool(workers=1, worlds=2) as pool:
        got = [encoded(pool.check_one(*job)) for job in every]
        assert len({key for hand in pool._hands for key in hand._process.known}) <= 3
    assert got == [directly(job) for job in every]
