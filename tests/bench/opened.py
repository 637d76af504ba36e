"""How many of the models in a folder of somebody else's are opened, beside what plain MuJoCo loads.

python -m tests.bench.opened FOLDER [FOLDER ...] [--seconds N]

Every MJCF and URDF below a folder is opened as `thinkblox verify FILE --root FOLDER` opens it. MJCF that plain MuJoCo
refuses, most of it parts that others include, does not count. What has nothing in it that could be measured is opened
and told so.
"""

import argparse
import re
from collections import Counter
from collections.abc import Callable, Iterator
from importlib.metadata import version
from pathlib import Path
from typing import NamedTuple

import mujoco

from thinkblox.errors import InputError
from thinkblox.sim.foreign.opening import open_model
from thinkblox.sim.workers.guard import guarded

NOTHING = "nothing to measure"
_ROOT = re.compile(rb"<\s*(mujoco|robot)[\s>]")


class Opening(NamedTuple):
    """What became of a file: whether MuJoCo loads it, and why we refuse it; empty where we do not."""

    loads: bool
    refused: str


def models(folder: Path, kind: str) -> Iterator[Path]:
    """The files of a folder whose root is that of an MJCF ("mujoco") or of a URDF ("robot")."""
    for path in sorted(folder.rglob("*.xml" if kind == "mujoco" else "*.urdf")):
        root = _ROOT.search(path.read_bytes())
        if root and root[1].decode() == kind:
            yield path


def opened(path: Path, folder: Path, seconds: float) -> Opening:
    """Open one file, in processes that a file which does not end takes along."""
    return Opening(_ends(loaded, path, seconds=seconds) == "", _ends(measurable, path, folder, seconds=seconds))


def _ends(open: Callable[..., None], *args: object, seconds: float) -> str:
    try:
        guarded(open, *args, seconds=seconds)
    except InputError as error:
        return str(error)
    return ""


def loaded(path: Path) -> None:
    """Open a file by plain MuJoCo.

    Raises:
        InputError: MuJoCo refuses it.
    """
    try:
        mujoco.MjModel.from_xml_path(str(path))
    except (ValueError, mujoco.FatalError) as error:
        raise InputError(str(error)) from error


def measurable(path: Path, folder: Path) -> None:
    """Open a file as `thinkblox verify` does."""
    open_model(path, folder=folder)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", type=Path, nargs="+")
    parser.add_argument("--seconds", type=float, default=120.0, help="for one file")
    given = parser.parse_args()
    print("folder                  kind    files  MuJoCo loads  opened  nothing in it  refused")
    told: list[str] = []
    for folder in given.folders:
        for kind, name in (("mujoco", "MJCF"), ("robot", "URDF")):
            found = [opened(path, folder.resolve(), given.seconds) for path in models(folder.resolve(), kind)]
            # What plain MuJoCo makes of a URDF says little: it knows no packages.
            counted = [one for one in found if one.loads or kind == "robot"]
            if not counted:
                continue
            sorts = Counter("opened" if not t.refused else NOTHING if NOTHING in t.refused else "" for t in counted)
            loads = sum(one.loads for one in found)
            print(
                f"{folder.name:22s}  {name:5s} {len(found):6d} {loads:13d} {sorts['opened']:7d} {sorts[NOTHING]:14d}"
                f" {sorts['']:8d}"
            )
            refused = [one.refused for one in counted if one.refused and NOTHING not in one.refused]
            told += [why.replace(f"{folder.resolve()}/", "") for why in refused]
    print(*dict.fromkeys(told), sep="\n")
    print(f"mujoco {version('mujoco')}")


if __name__ == "__main__":
    main()
