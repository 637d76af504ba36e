"""Who does what in a verdict pool: a line of jobs that wait, and for each worker a hand, a thread with its process."""

import threading
from collections import deque
from collections.abc import Sequence
from queue import SimpleQueue

import msgspec

from thinkblox.errors import ThinkBloxError
from thinkblox.sim.workers.child import StartError
from thinkblox.sim.workers.parcel import Parcel
from thinkblox.sim.workers.process import LostError, WorkerProcess
from thinkblox.sim.workers.wire import Reply, WorkerSettings, unmeasured
from thinkblox.verdict import Verdict

STARTS = 3
"""Worker processes in a row that may fail to start by themselves before their hand gives up."""
KILLED = 12
"""Those in a row that may be killed while they start: want of memory, or somebody's hand, may pass."""
PAUSE, LONGEST_PAUSE = 0.2, 5.0
"""Before the second attempt, then twice as long each time, but no longer than that [s]."""
GUILTY = 2
"""When so many candidates of a job each cost a worker, and none was measured, the rest is not tried."""
OWNED = 10_000
"""Scenes of which it is remembered who has them."""


class WaitingLine:
    """Jobs that wait. A scene goes to the hand that was given it before, but none is idle while anything waits.

    At most `length` jobs wait: then `put` does, so that jobs are made no faster than they are done.
    """

    def __init__(self, length: int) -> None:
        self._length = length
        self._lock = threading.RLock()
        self._room = threading.Condition(self._lock)
        self._waiting: deque[Parcel] = deque()
        self._hands: list[Hand] = []
        self._idle: list[Hand] = []
        self._owners: dict[bytes, Hand] = {}
        self._over: ThinkBloxError | None = None

    def join(self, hand: "Hand") -> None:
        """Count a hand in, before it starts to work."""
        self._hands.append(hand)

    def put(self, parcel: Parcel) -> None:
        """Give a job to an idle hand, first to one that knows its scene, or let it wait.

        Raises:
            ThinkBloxError: the line is closed, or no hand is left.
        """
        with self._lock:
            while len(self._waiting) >= self._length and self._over is None:
                self._room.wait()
            self.check_open()
            self._place(parcel)

    def work_for(self, hand: "Hand") -> Parcel | None:
        """The next job of a hand, for which it may have to wait; None when there will be none."""
        with self._lock:
            over, parcel = self._over, self._chosen(hand)
            if parcel is not None:
                self._room.notify()
            elif over is None:
                self._idle.append(hand)
        # Only now, so that a job that follows from the answer finds the hand that knows its scene.
        hand.deliver()
        return parcel if parcel is not None or over is not None else hand.mail.get()

    def leave(self, hand: "Hand", why: ThinkBloxError, unfinished: Parcel | None = None) -> None:
        """Count a hand out; what it could not finish goes to another, and the last one to leave closes the line."""
        with self._lock:
            self._hands.remove(hand)
            self._owners = {key: owner for key, owner in self._owners.items() if owner is not hand}
            if not self._hands:
                self.close(why)
            if unfinished is not None:
                self._place(unfinished, first=True)
            while self._over and self._waiting:
                self._waiting.popleft().fail(self._over)

    def close(self, why: ThinkBloxError) -> None:
        """Let nothing more in and send the hands home; what still waits fails with `why`."""
        with self._lock:
            self._over = self._over or why
            self._room.notify_all()
            # What waits is left to the hands: this may run in the midst of anything, as a finaliser.
            for hand in self._hands:
                hand.mail.put(None)

    def check_open(self) -> None:
        """Raise why the line is closed, if it is."""
        if self._over is not None:
            raise ThinkBloxError(str(self._over)) from self._over

    def _place(self, parcel: Parcel, *, first: bool = False) -> None:
        if self._idle and not self._over:
            owner = self._owner(parcel)
            hand = owner if owner in self._idle else self._idle[0]
            self._idle.remove(hand)
            self._own(hand, parcel)
            hand.mail.put(parcel)
        elif first:
            self._waiting.appendleft(parcel)
        else:
            self._waiting.append(parcel)

    def _chosen(self, hand: "Hand") -> Parcel | None:
        """What a hand does next: a scene of its own, else one of nobody's, else the latest of another's."""
        if not self._waiting or self._over:
            return None
        # However busy a hand is with scenes of its own, the first job in the line gets its turn.
        chosen = first = self._waiting[0]
        first.passed += 1
        if first.passed <= self._length:
            owned = [(parcel, self._owner(parcel)) for parcel in self._waiting]
            mine = (parcel for parcel, owner in owned if owner is hand)
            new = (parcel for parcel, owner in owned if owner is None)
            chosen = next(mine, None) or next(new, None) or self._waiting[-1]
        self._waiting.remove(chosen)
        self._own(hand, chosen)
        return chosen

    def _owner(self, parcel: Parcel) -> "Hand | None":
        """Who was first given this scene or, if nobody was, the scene without its last object."""
        return next((self._owners[key] for key in reversed(parcel.keys[-2:]) if key in self._owners), None)

    def _own(self, hand: "Hand", parcel: Parcel) -> None:
        self._owners.setdefault(parcel.keys[-1], hand)
        if len(self._owners) > OWNED:
            del self._owners[next(iter(self._owners))]


class Hand:
    """A thread with a worker process, which it replaces when it is lost.

    Attributes:
        mail: the job it gets while it is idle; None to go home.
    """

    def __init__(self, line: WaitingLine, settings: WorkerSettings) -> None:
        """Start the process; raises StartError when the system refuses."""
        self.mail: SimpleQueue[Parcel | None] = SimpleQueue()
        self._line = line
        self._settings = settings
        self._answers = msgspec.msgpack.Decoder(Reply)
        self._lock = threading.RLock()
        self._stopped = threading.Event()
        self._done: tuple[Parcel, list[Verdict]] | None = None
        self._process = WorkerProcess(settings)
        self._thread = threading.Thread(target=self._work, name=f"verdicts of {self._process.pid}", daemon=True)

    @property
    def pid(self) -> int | None:
        """Process id of its worker; None when that was lost and is not yet replaced."""
        process = self._process
        return process.pid if process.alive else None

    def start(self) -> None:
        """Start the thread."""
        self._thread.start()

    def stop(self) -> None:
        """End the process and start no other; the thread then ends by itself, once the line is closed."""
        with self._lock:
            self._stopped.set()
            self._process.kill()

    def wait(self) -> None:
        """Wait until the thread has ended, and its process with it."""
        if self._thread.ident is None:
            self._process.end()
        elif self._thread is not threading.current_thread():
            self._thread.join(10.0)

    def deliver(self) -> None:
        """Let whoever waits for what was done last have it."""
        if self._done is not None:
            parcel, verdicts = self._done
            self._done = None
            parcel.answer.set_result(verdicts)

    def _work(self) -> None:
        why, parcel = ThinkBloxError("the pool is closed"), None
        try:
            self._live()
            while (parcel := self._line.work_for(self)) is not None:
                self._do(parcel)
                parcel = None
                if not self._process.alive:
                    self.deliver()
                    self._live()
        except StartError as error:
            why = error
        finally:
            self.deliver()
            self._line.leave(self, why, parcel)
            self._process.end()

    def _do(self, parcel: Parcel) -> None:
        if not parcel.begin():
            return
        try:
            self._done = parcel, self._verdicts(parcel)
        except StartError:
            raise
        except Exception as error:  # whoever waits for the answer is told of anything
            parcel.fail(error)

    def _verdicts(self, parcel: Parcel) -> list[Verdict]:
        if not parcel.lost:
            try:
                return self._ask(parcel, range(len(parcel.ids)))
            except LostError:
                parcel.lost = True
        return self._one_by_one(parcel)

    def _one_by_one(self, parcel: Parcel) -> list[Verdict]:
        """Try the candidates each by itself, so that only those that cost a worker once more go without a verdict."""
        verdicts: list[Verdict] = []
        lost, hopeless = 0, False
        for place, id in enumerate(parcel.ids):
            hopeless = hopeless or lost == place == GUILTY
            if hopeless:
                verdicts.append(unmeasured(id, f"{id} was not tried: every candidate before it cost a worker process"))
                continue
            try:
                verdicts += self._ask(parcel, [place])
            except LostError as error:
                verdicts.append(unmeasured(id, f"{id} could not be measured: {error}"))
                lost += 1
        return verdicts

    def _ask(self, parcel: Parcel, chosen: Sequence[int]) -> list[Verdict]:
        process = self._live()
        answer = self._answers.decode(process.ask(parcel.task(process.known, chosen)))
        verdicts = parcel.verdicts(answer, process.known, chosen)
        if answer.full:
            process.end()
        return verdicts

    def _live(self) -> WorkerProcess:
        """The worker process, ready to be asked; a new one when it was lost. Raises StartError when none starts."""
        failed = killed = 0
        while True:
            try:
                if not self._process.alive:
                    self._replace()
                self._process.wait_until_ready()
            except StartError as error:
                if self._stopped.is_set():
                    raise
                failed, killed = failed + (not error.killed), killed + error.killed
                if failed == STARTS or killed == KILLED:
                    attempts = f"{failed + killed} attempts to start a worker failed"
                    raise StartError(f"{attempts}; the last: {error}") from error
                self._stopped.wait(min(LONGEST_PAUSE, PAUSE * 2 ** (failed + killed - 1)))
            else:
                return self._process

    def _replace(self) -> None:
        self._process.end()
        with self._lock:
            if self._stopped.is_set():
                raise StartError("the pool is closed")
            self._process = WorkerProcess(self._settings)
