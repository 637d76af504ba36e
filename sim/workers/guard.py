"""A fence round foreign input: what reads or simulates it runs in a process of its own, which may crash or hang."""

import pickle
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

from thinkblox.errors import InputError
from thinkblox.sim.workers.calls import Call, Outcome
from thinkblox.sim.workers.child import START, Child, EndedError, StartError, signal_name

T = TypeVar("T")
MEMORY = 8 * 2**30
"""What a child may ask for unless told otherwise [bytes]."""
FENCE = "thinkblox.sim.workers.fence"
"""The module that a child runs."""
_MAIN, _MAIN_AGAIN = "__main__", "__mp_main__"
"""What the caller's main module is called, and what it is called where it is loaded once more."""


def guarded(
    function: Callable[..., T], *args: object, seconds: float, memory: int | None = MEMORY, doing: str = ""
) -> T:
    """Call a function in a child process and hand back what it returns; the child is gone when this returns or raises.

    The function, its arguments and its result must be picklable, and what it writes to the terminal is lost. The
    caller's main module is loaded in the child only when the function lives there, so that scripts need no
    `if __name__ == "__main__"` otherwise. What the function starts itself ends with it. It needs a POSIX system.

    Args:
        function: what to call.
        args: its arguments.
        seconds: how long it may take, not counting the start of the process.
        memory: address space it may use [bytes]; None for no limit. Not every system enforces it.
        doing: what it does, for messages; without it "reading NAME" after the first path in `args`.

    Raises:
        InputError: raised by the function itself; or it crashed the process, took too long, or ran out of memory.
        StartError: the system does not let a process be started.
    """
    doing, main = doing or _activity(function, args), _main_of(function)
    call = Call(pickle.dumps((function, args)), memory, main)
    try:
        outcome = _called(call, seconds)
    except TimeoutError as error:
        raise InputError(
            f"It took longer than {seconds:g} s and was stopped while {doing}: make it smaller, or allow more time."
        ) from error
    except EndedError as error:
        raise InputError(_death(error.status, doing, memory)) from error
    result: T = _value(outcome, doing, memory)
    return result


def _called(call: Call, seconds: float) -> Outcome:
    child = Child(FENCE)
    try:
        outcome = _begun(child, call)
        return _received(child, seconds) if outcome.kind == "started" else outcome
    finally:
        child.end()


def _begun(child: Child, call: Call) -> Outcome:
    """What comes of loading the function."""
    try:
        child.send(pickle.dumps(call), until=time.monotonic() + START)
        return _received(child, START)
    except TimeoutError as error:
        raise StartError(f"a process did not load what it was to run within {START:g} s") from error


def _received(child: Child, seconds: float) -> Outcome:
    outcome: Outcome = pickle.loads(child.receive(until=time.monotonic() + seconds))
    return outcome


def _main_of(function: Callable[..., object]) -> dict[str, str]:
    """Where the main module is, if the function lives there."""
    home = getattr(function, "__module__", None)
    if home not in (_MAIN, _MAIN_AGAIN):
        return {}
    main = sys.modules[_MAIN]
    if sys.modules.get(home) is not main:
        raise InputError(
            f"{function.__qualname__} is to be called in a process of its own while the script that defines it is"
            f' being loaded there; put the call under `if __name__ == "{_MAIN}":`'
        )
    name, file = getattr(main.__spec__, "name", None), getattr(main, "__file__", None)
    if name is not None:
        return {"init_main_from_name": name}
    return {} if file is None else {"init_main_from_path": str(Path(file).absolute())}


def _value(outcome: Outcome, doing: str, memory: int | None) -> Any:
    if outcome.kind == "out of memory":
        raise InputError(f"The memory allowed{_amount(memory)} ran out while {doing}: make it smaller, or allow more.")
    if outcome.kind == "failed":
        raise outcome.value
    return outcome.value


def _activity(function: Callable[..., object], args: tuple[object, ...]) -> str:
    path = next((arg for arg in args if isinstance(arg, Path)), None)
    return f"reading {path.name}" if path else f"running {getattr(function, '__name__', 'a function')}"


def _amount(memory: int | None) -> str:
    return "" if memory is None else f", {memory / 2**30:.2g} GiB,"


def _death(status: int | None, doing: str, memory: int | None) -> str:
    if status is None or status >= 0:
        how = "" if status is None else f" (exit status {status})"
        return f"The process ended by itself{how} while {doing}."
    name = signal_name(-status)
    if name == "SIGKILL":
        return f"The process was killed (signal {-status}) while {doing}, most likely because memory ran out."
    hint = f" It was allowed {memory / 2**30:.2g} GiB of memory." if memory is not None and name == "SIGABRT" else ""
    return f"MuJoCo crashed (signal {-status}, {name}) while {doing}: the file breaks the engine.{hint}"
