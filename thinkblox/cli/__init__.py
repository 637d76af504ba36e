"""The command line: `thinkblox COMMAND`, a module for each command.

Exit status 0: all as asked; 1: done, but something was not placed or did not pass; 2: unusable input; 70: a fault of
ours or of the system; 74: the output could not be written; 130: stopped; 141: nobody read the output to its end.
"""

import atexit
import gc
import os
from collections.abc import Sequence

from thinkblox.cli.stopping import STOPPED, say_stopped, stoppable


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status.

    Args:
        argv: what stands behind `thinkblox`; that of the process when left out, which is then expected to end.
    """
    if argv is None:
        _hurry()
    stops: list[int] = []
    try:
        # Whatever takes its time can be stopped, the loading of modules too.
        with stoppable(to_the_end=argv is None) as stops:
            from thinkblox.cli.running import run

            return run(argv, stops)
    except (KeyboardInterrupt, Exception):
        # A compiled function that is stopped while it loads or is called makes another error of it.
        if not stops:
            raise
    say_stopped()
    return STOPPED


def _hurry() -> None:
    """Spare a process of ours what only costs it time."""
    # No command draws by OpenGL; the engine would look for a display each time.
    os.environ.setdefault("MUJOCO_GL", "disable")
    # What a command makes it keeps: looking through it for garbage so often, and once more at the end, finds nothing.
    gc.set_threshold(500_000)
    atexit.register(gc.freeze)
