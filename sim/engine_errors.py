"""What the engine raises on models that it cannot build, and what it says."""

import mujoco

ENGINE_ERRORS = (ValueError, RuntimeError, IndexError, OverflowError, mujoco.FatalError)
"""ValueError where it knows what is wrong; the others where its own code failed over the model."""


def said(error: BaseException) -> str:
    """What the engine said, on one line."""
    text = " ".join(str(error).split())
    return "its reader failed without saying where" if "unknown exception" in text else text
