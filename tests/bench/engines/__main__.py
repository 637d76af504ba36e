"""Exported rooms in other engines, beside MuJoCo; `--out` writes the page that docs/engines.md is.

python -m tests.bench.engines ROOMS [--engines rapier3d,dartpy] [--home DIR] [--out FILE]
"""

import argparse
import json
import math
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from tests.bench.engines.case import moved, write_case
from tests.bench.engines.marble import marble_case, marble_told
from tests.bench.engines.page import page
from tests.bench.venvs import interpreter
from thinkblox.sim.environment import rooms_of

HERE = Path(__file__).parent
PINS: dict[str, dict[str, Any]] = tomllib.loads((HERE / "pins.toml").read_text())
COLUMNS = (
    "room", "engine", "masses off [%]", "moved in 2 s [mm]", "turned [degrees]", "hinges off [degrees]",
    "drawers off [mm]", "seconds",
)  # fmt: skip
MARBLE_COLUMNS = ("engine", "marble over the mug's bottom [mm]", "mug moved [mm]", "seconds")


def driven(engine: str, case: Path, home: Path) -> dict[str, Any]:
    """What a driver prints of a case.

    Raises:
        RuntimeError: it fails, or takes too long; says how.
    """
    pin = PINS[engine]
    solver = [pin["solver"]] if "solver" in pin else []
    python = interpreter(home / str(pin.get("place", engine)), pin["needs"])
    command = [python, HERE / f"drive_{pin.get('driver', engine)}.py", case, *solver]
    patience = pin.get("takes", 300)
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=patience)
    except subprocess.TimeoutExpired:
        raise RuntimeError(f"takes over {patience // 60} minutes") from None
    if done.returncode:
        last = (done.stderr.strip().splitlines() or [f"ends with status {done.returncode}"])[-1]
        raise RuntimeError(last[:160])
    return json.loads(done.stdout.splitlines()[-1])  # type: ignore[no-any-return]


def row(room: str, engine: str, case: dict[str, Any], told: dict[str, Any]) -> str:
    """A line of the table: the largest of each difference."""
    # What does not collide, such as a rug, weighs nothing in the engine, nor does what is fixed in USD.
    kept = [t for t in case["things"] if t["mass"] > 0.0 and (t["free"] or t["name"] in told["masses"])]
    off = max((100.0 * abs(told["masses"].get(t["name"], 0.0) / t["mass"] - 1.0) for t in kept), default=0.0)
    away, turned, which = moved(case, told["poses"])
    hinges, drawers = _swung(case["swings"], told["swings"])
    if told["swings"] and not PINS[engine].get("rubs", True):
        slipping = _swung(case["slipping"], told["swings"])
        hinges, drawers = f"{hinges} ({slipping[0]})", f"{drawers} ({slipping[1]})"
    far = f"{away:.2f} {which}" if away > 5.0 else f"{away:.2f}"
    cells = (room, engine, f"{off:.4f}", far, f"{turned:.2f}", hinges, drawers, f"{told['took']:.1f}")
    return f"| {' | '.join(cells)} |"


def _swung(wanted: Any, found: Any) -> tuple[str, str]:
    """The largest differences of hinges [degrees] and drawers [mm], where there are any."""
    hinges, drawers = [0.0], [0.0]
    if not found:
        return "-", "-"
    for asset, joints in wanted.items():
        for joint, values in joints.items():
            apart = np.abs(np.subtract(values, found[asset][joint])).max()
            if "drawer" in joint:
                drawers.append(1000.0 * float(apart))
            else:
                hinges.append(float(np.degrees(apart)))
    return f"{max(hinges):.1f}", f"{max(drawers):.1f}"


def room_lines(rooms: list[str], engines: list[str], home: Path) -> Iterator[str]:
    """The table of rooms, line by line, failures included."""
    yield from _head(COLUMNS)
    for number, source in enumerate(source for room in rooms for source in rooms_of(room)):
        scene = source.load()
        with tempfile.TemporaryDirectory(prefix="engines-") as folder:
            case = write_case(scene, Path(folder, "room"))
            for engine in [engine for engine in engines if number < PINS[engine].get("rooms", math.inf)]:
                try:
                    told = driven(engine, Path(folder, "room", "case.json"), home)
                    yield row(source.name, engine, case, told)
                except RuntimeError as error:
                    yield f"| {source.name} | {engine} | {error} | | | | | |"


def marble_lines(engines: list[str], home: Path) -> Iterator[str]:
    """The table of a marble in a mug, MuJoCo first."""
    yield from _head(MARBLE_COLUMNS)
    with tempfile.TemporaryDirectory(prefix="engines-") as folder:
        case = marble_case(Path(folder, "room"))
        rests = {thing["name"]: [thing["rests"], thing["quat"]] for thing in case["things"]}
        yield f"| MuJoCo | {marble_told(case, rests)} | 0.00 | |"
        for engine in engines:
            try:
                told = driven(engine, Path(folder, "room", "case.json"), home)
                mug = {name: pose for name, pose in told["poses"].items() if name.startswith("cup")}
                stayed = f"{moved(case, mug)[0]:.2f}"
                yield f"| {engine} | {marble_told(case, told['poses'])} | {stayed} | {told['took']:.1f} |"
            except RuntimeError as error:
                yield f"| {engine} | {error} | | |"


def _head(columns: tuple[str, ...]) -> Iterator[str]:
    yield f"| {' | '.join(columns)} |"
    yield "|---" * len(columns) + "|"


def _printed(lines: Iterator[str]) -> list[str]:
    """All lines, each printed as it comes."""
    found = []
    for line in lines:
        print(line, flush=True)
        found.append(line)
    return found


def main() -> int:
    """Print the tables, and write the page where asked to."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rooms", nargs="+")
    usual = ",".join(engine for engine, pin in PINS.items() if not pin.get("opt_in", False))
    parser.add_argument("--engines", default=usual, help=f"of {', '.join(PINS)}; {usual} unless told otherwise")
    parser.add_argument("--home", type=Path, default=Path("out/engines"))
    parser.add_argument("--out", type=Path)
    arguments = parser.parse_args()
    engines, home = arguments.engines.split(","), arguments.home.absolute()
    rooms = _printed(room_lines(arguments.rooms, engines, home))
    marbles = _printed(marble_lines(engines, home))
    if arguments.out is not None:
        arguments.out.write_text(page(PINS, rooms, marbles), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
