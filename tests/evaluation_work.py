"""What the processes of an evaluation are given to do in tests; another process finds it by its name."""

import os
import signal
import time


def worked(thing: str) -> str:
    """Do what the thing says; otherwise give it back in capitals."""
    if thing == "die":
        os.kill(os.getpid(), signal.SIGKILL)
    if thing == "leave":
        os._exit(3)
    if thing == "hang":
        time.sleep(3600.0)
    if thing == "raise":
        raise ValueError("it was asked to")
    return thing.upper()
