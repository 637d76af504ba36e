"""The inner side of `guarded`: a process that limits itself, calls one function and tells what became of it.

Started by thinkblox.sim.workers.guard as a `Child`.
"""

import pickle
import socket
import sys
import traceback
from collections.abc import Sequence
from multiprocessing import spawn

from thinkblox.errors import InputError
from thinkblox.sim.workers.calls import Call, Outcome
from thinkblox.sim.workers.frames import receive_frame, send_frame
from thinkblox.sim.workers.inside import attached, be_quiet, die_with, limit_memory


def main(arguments: Sequence[str]) -> None:
    """Read the Call, and answer with two Outcomes: when all is loaded, and when the function returned or raised."""
    channel, parent = attached(arguments)
    be_quiet()
    die_with(parent)
    try:
        call: Call = pickle.loads(receive_frame(channel))
        send_frame(channel, _answer(call, channel))
    except (EOFError, OSError):
        return


def _answer(call: Call, channel: socket.socket) -> bytes:
    limit_memory(call.memory)
    try:
        spawn.prepare(dict(call.main))
        function, args = pickle.loads(call.function)
        send_frame(channel, pickle.dumps(Outcome("started")))
        return pickle.dumps(Outcome("done", function(*args)))
    except MemoryError:
        return pickle.dumps(Outcome("out of memory"))
    except Exception as error:  # whoever called is told of anything
        return _failure(error)


def _failure(error: Exception) -> bytes:
    if not isinstance(error, InputError):
        error.add_note("In a guarded process:\n" + "".join(traceback.format_exception(error)))
    try:
        message = pickle.dumps(Outcome("failed", error))
        pickle.loads(message)
    except Exception:  # an exception may refuse to be pickled in any way
        message = pickle.dumps(Outcome("failed", RuntimeError("".join(traceback.format_exception(error)))))
    return message


if __name__ == "__main__":
    main(sys.argv[1:])
