"""Virtual environments of programs that exported rooms are read by, made when they are first needed."""

import subprocess
import venv
from collections.abc import Sequence
from pathlib import Path


def interpreter(place: Path, needs: Sequence[str]) -> Path:
    """The Python of a virtual environment with some packages, which is made at `place` when it is not there.

    Raises:
        RuntimeError: they cannot be installed; says why.
    """
    python = place / "bin" / "python"
    if not (place / "ready").exists():
        venv.create(place, with_pip=True, clear=True)
        command: list[str | Path] = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *needs]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            raise RuntimeError(f"cannot be installed: {done.stderr.strip().splitlines()[-1]}")
        (place / "ready").touch()
    return python
