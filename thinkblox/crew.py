"""The same work on many things in several processes, of which any may crash, hang or be stopped."""

import signal
import time
import traceback
from collections import deque
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import suppress
from multiprocessing import connection, get_context
from multiprocessing.connection import Connection
from typing import Any, Generic, NamedTuple, TypeVar

T = TypeVar("T")
R = TypeVar("R")
_SPAWN = get_context("spawn")
"""Fresh interpreters: nothing of an engine, and no lock, is inherited."""


class Done(NamedTuple, Generic[R]):
    """What became of one thing.

    Attributes:
        number: of the thing, from 0.
        result: what the function returned; None when it did not return.
        fault: why it did not.
    """

    number: int
    result: R | None
    fault: str = ""


def work_through(
    function: Callable[[T], R], things: Sequence[T], *, jobs: int, seconds: float
) -> Generator[Done[R], None, None]:
    """Call a function with each thing, in `jobs` processes, and give what comes of each as it is done.

    A process that dies or takes longer than `seconds` over one thing costs that thing, and another takes its place. All
    are gone when the iterator ends, is closed, or is left by an exception.

    Args:
        function: of a module, so that another process finds it; it, the things and the results are pickled.
        things: what to call it with.
        jobs: how many processes.
        seconds: for one thing.
    """
    waiting = deque(enumerate(things))
    hands = [_Hand(function) for _ in range(min(jobs, len(things)))]
    try:
        while waiting or any(hand.busy for hand in hands):
            for hand in hands:
                if waiting and not hand.busy:
                    hand.give(*waiting.popleft(), until=time.monotonic() + seconds)
            yield from _ready(hands)
    finally:
        for hand in hands:
            hand.end()


def _ready(hands: Sequence["_Hand"]) -> Iterator[Done[Any]]:
    busy = [hand for hand in hands if hand.busy]
    first = min((hand.until for hand in busy), default=0.0)
    ready = connection.wait([hand.line for hand in busy], timeout=max(0.0, first - time.monotonic()))
    for hand in busy:
        if hand.line in ready or time.monotonic() > hand.until:
            yield hand.take(late=hand.line not in ready)


class _Hand:
    """One process, begun anew when it is lost."""

    def __init__(self, function: Callable[[Any], Any]) -> None:
        self._function = function
        self._index = -1
        self.until = 0.0
        self._begin()

    @property
    def busy(self) -> bool:
        return self._index >= 0

    def _begin(self) -> None:
        self.line, other = _SPAWN.Pipe()
        self._process = _SPAWN.Process(target=_serve, args=(other, self._function), daemon=True)
        self._process.start()
        other.close()

    def give(self, index: int, thing: object, *, until: float) -> None:
        self._index, self.until = index, until
        with suppress(BrokenPipeError):  # it is gone already, which is found out where its answer is taken
            self.line.send(thing)

    def take(self, *, late: bool) -> Done[Any]:
        index, self._index = self._index, -1
        if late:
            self._replace()
            return Done(index, None, "it took too long and was stopped")
        try:
            result, fault = self.line.recv()
        except (EOFError, ConnectionResetError):
            self._process.join()
            status = self._process.exitcode
            self._replace()
            return Done(index, None, f"the process ended by itself, with status {status}")
        return Done(index, result, fault)

    def _replace(self) -> None:
        self.end()
        self._begin()

    def end(self) -> None:
        self.line.close()
        self._process.kill()
        self._process.join()


def _serve(line: "Connection[Any, Any]", function: Callable[[Any], Any]) -> None:
    """Answer each thing with what the function returns, until nobody asks any more."""
    # Ctrl-C goes to the whole group of processes; the one that was asked to stop ends the others.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with suppress(EOFError, BrokenPipeError):
        while True:
            thing = line.recv()
            try:
                answer = (function(thing), "")
            except Exception as error:
                answer = (None, "".join(traceback.format_exception_only(error)).strip())
            line.send(answer)
