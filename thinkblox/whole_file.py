"""Writing a file whole or not at all."""

import os
import tempfile
from pathlib import Path

from thinkblox.errors import InputError


def write_whole(path: Path, data: bytes) -> None:
    """Write a file; one that is there is replaced at once, or stays as it was after any failure.

    Raises:
        InputError: it cannot be written.
    """
    try:
        handle, name = tempfile.mkstemp(prefix=f".{path.name}"[:20], suffix=".tmp", dir=path.parent)
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(data)
            Path(name).chmod(0o644)
            Path(name).replace(path)
        except BaseException:
            Path(name).unlink(missing_ok=True)
            raise
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror}") from error
