"""How long a user waits: whole processes, from start to exit.

python -m tests.bench.startup [--runs N]
"""

import argparse
import platform
import statistics
import subprocess
import sys
import tempfile
import time
from importlib.metadata import version
from pathlib import Path

from tests.bench.rooms import PROMPTS

HEAVY = ("torch", "mujoco", "pxr", "numpy")


def seconds(command: list[str], runs: int) -> list[float]:
    """Wall seconds of each run, after one that is not counted; the command must succeed."""
    taken = []
    for _ in range(runs + 1):
        start = time.perf_counter()
        subprocess.run(command, check=True, capture_output=True)
        taken.append(time.perf_counter() - start)
    return sorted(taken[1:])


def main() -> int:
    """Print a row for each command."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=5)
    runs = parser.parse_args().runs
    prompt = PROMPTS.read_text().splitlines()[0]
    thinkblox = [sys.executable, "-m", "thinkblox"]
    with tempfile.TemporaryDirectory() as scratch:
        generate = [*thinkblox, "generate", prompt, "--overwrite", "--out"]
        rows = {
            "python -c pass": [sys.executable, "-c", "pass"],
            "import thinkblox": [sys.executable, "-c", "import thinkblox"],
            "thinkblox --help": [*thinkblox, "--help"],
            "generate, without pictures": [*generate, str(Path(scratch) / "plain"), "--no-pictures"],
            "generate, with both pictures": [*generate, str(Path(scratch) / "pictures")],
            "render, both pictures": [*thinkblox, "render", str(Path(scratch) / "pictures")],
        }
        print(f"{'command':30}     min  median     max   [s, {runs} runs]")
        for name, command in rows.items():
            taken = seconds(command, runs)
            print(f"{name:30} {taken[0]:7.2f} {statistics.median(taken):7.2f} {taken[-1]:7.2f}")
    code = f"import sys, thinkblox; print([m for m in {HEAVY} if m in sys.modules])"
    loaded = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout.strip()
    print(f"heavy modules loaded by import thinkblox: {loaded}")
    print(f"python {platform.python_version()}, mujoco {version('mujoco')}, {platform.machine()}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
