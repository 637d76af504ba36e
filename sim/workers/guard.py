"""A fence round foreign input: what reads or simulates it runs in a process of its own, which may crash or hang."""

import multiprocessing
import os
import pickle
import signal
import sys
import threading
import traceback
import types
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from pathlib import Path
from typing import Any, ParamSpec, TypeVar

from thinkblox.errors import InputError

P = ParamSpec("P")
T = TypeVar("T")
MEMORY = 8 * 2**30
"""What a child may ask for unless told otherwise [bytes]."""
START_TIME = 120.0
"""What a child may take to start up and load its modules before its seconds count [s]."""
_STARTED, _DONE, _FAILED, _OUT_OF_MEMORY = "started", "done", "failed", "out of memory"


def guarded(
    function: Callable[..., T], *args: object, seconds: float, memory: int | None = MEMORY, doing: str = ""
) -> T:
    """Call a function in a child process and hand back what it returns; the child is gone when this returns or raises.

    The function, its arguments and its result must be picklable, and what it writes to the terminal is lost. The
    caller's main module is loaded in the child only when the function lives there, so that scripts need no
    `if __name__ == "__main__"`.

    Args:
        function: what to call.
        args: its arguments.
        seconds: how long it may take, not counting the start of the process.
        memory: address space it may use [bytes]; None for no limit. Not every system enforces it.
        doing: what it does, for messages; without it "reading NAME" after the first path in `args`.

    Raises:
        InputError: raised by the function itself; or it crashed the process, took too long, or ran out of memory.
    """
    doing = doing or _activity(function, args)
    payload = pickle.dumps((function, args))
    with _child(payload, memory, own_main=getattr(function, "__module__", "") == "__main__") as (process, channel):
        try:
            answer = _receive(process, channel, START_TIME)
            if answer == (_STARTED, None):
                answer = _receive(process, channel, seconds)
        except TimeoutError as error:
            raise InputError(
                f"It took longer than {seconds:g} s and was stopped while {doing}: make it smaller, or allow more time."
            ) from error
        except EOFError as error:
            process.join(START_TIME)
            raise InputError(_death(process.exitcode or 0, doing, memory)) from error
    result: T = _outcome(answer, doing, memory)
    return result


def _outcome(answer: tuple[str, Any], doing: str, memory: int | None) -> Any:
    kind, value = answer
    if kind == _OUT_OF_MEMORY:
        raise InputError(f"The memory allowed{_amount(memory)} ran out while {doing}: make it smaller, or allow more.")
    if kind == _FAILED:
        raise value
    return value


def _activity(function: Callable[..., object], args: tuple[object, ...]) -> str:
    path = next((arg for arg in args if isinstance(arg, Path)), None)
    return f"reading {path.name}" if path else f"running {getattr(function, '__name__', 'a function')}"


def _amount(memory: int | None) -> str:
    return "" if memory is None else f", {memory / 2**30:.2g} GiB,"


def _death(code: int, doing: str, memory: int | None) -> str:
    if code >= 0:
        return f"The process ended by itself (exit status {code}) while {doing}."
    name = signal.Signals(-code).name if -code in signal.valid_signals() else "unknown"
    if name == "SIGKILL":
        return f"The process was killed (signal {-code}) while {doing}, most likely because memory ran out."
    hint = f" It was allowed {memory / 2**30:.2g} GiB of memory." if memory is not None and name == "SIGABRT" else ""
    return f"MuJoCo crashed (signal {-code}, {name}) while {doing}: the file breaks the engine.{hint}"


def _receive(process: SpawnProcess, channel: Connection, seconds: float) -> tuple[str, Any]:
    """The child's next message; raises EOFError when it died and TimeoutError when the time is over."""
    if not wait([channel, process.sentinel], timeout=seconds):
        raise TimeoutError
    if not channel.poll():
        raise EOFError
    try:
        message: tuple[str, Any] = pickle.loads(channel.recv_bytes())
    except ConnectionError as error:
        raise EOFError from error
    return message


@contextmanager
def _child(payload: bytes, memory: int | None, *, own_main: bool) -> Iterator[tuple[SpawnProcess, Connection]]:
    context = multiprocessing.get_context("spawn")
    here, there = context.Pipe(duplex=False)
    process = context.Process(target=_run, args=(there, payload, memory, os.getpid()), daemon=True)
    try:
        if own_main:
            process.start()
        else:
            with _bare_main():
                process.start()
        there.close()
        yield process, here
    finally:
        there.close()
        if process.pid is not None:
            process.kill()
            process.join()
        here.close()


@contextmanager
def _bare_main() -> Iterator[None]:
    """Hide the main module while a process is spawned: it would be run again in the child."""
    main = sys.modules["__main__"]
    sys.modules["__main__"] = types.ModuleType("__main__")
    try:
        yield
    finally:
        sys.modules["__main__"] = main


def _run(channel: Connection, payload: bytes, memory: int | None, parent: int) -> None:
    """What the child does: limit itself, call, answer."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _be_quiet()
    _die_with(parent)
    _limit(memory)
    try:
        function, args = pickle.loads(payload)
        channel.send_bytes(pickle.dumps((_STARTED, None)))
        answer = pickle.dumps((_DONE, function(*args)))
    except MemoryError:
        answer = pickle.dumps((_OUT_OF_MEMORY, None))
    except Exception as error:
        answer = _failure(error)
    channel.send_bytes(answer)


def _be_quiet() -> None:
    """Turn off the terminal, also for libraries in C: Qhull writes a page about every flat mesh."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (1, 2):
        os.dup2(nowhere, stream)


def _failure(error: Exception) -> bytes:
    if not isinstance(error, InputError):
        error.add_note("In a guarded process:\n" + "".join(traceback.format_exception(error)))
    try:
        message = pickle.dumps((_FAILED, error))
        pickle.loads(message)
    except Exception:
        message = pickle.dumps((_FAILED, RuntimeError("".join(traceback.format_exception(error)))))
    return message


def _limit(memory: int | None) -> None:
    if sys.platform == "win32":
        return
    import resource

    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if memory is not None:
        _, hard = resource.getrlimit(resource.RLIMIT_AS)
        soft = memory if hard == resource.RLIM_INFINITY else min(memory, hard)
        resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


def _die_with(parent: int) -> None:
    """See to it that this process ends when its parent does, even if that is killed."""
    if sys.platform == "linux":
        _ask_kernel()
    else:
        threading.Thread(target=_watch, daemon=True).start()
    if os.getppid() != parent:
        os._exit(1)


def _ask_kernel() -> None:
    """prctl(PR_SET_PDEATHSIG, SIGKILL): works even while the engine holds the interpreter."""
    import ctypes

    ctypes.CDLL(None, use_errno=True).prctl(1, signal.SIGKILL, 0, 0, 0)


def _watch() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(1)
