"""What the two pictures of a room cost, against an earlier revision of this repository, in one run.

python -m tests.bench.pictures [--against REVISION] [--rooms N] [--runs N] [--out DIR]

Rooms are made as of the earlier revision, so that both read them, and drawn by both in turn. Printed are CPU seconds of
all threads, the ratio of the sums, and how much the pixels differ (0 to 255).
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image

from tests.bench.rooms import PROMPTS

ROOMS = (0, 2, 7, 13)
"""Lines of prompts.txt that are drawn."""
KINDS = ("render_preview", "render_top")
_MAKE = """
import sys
from pathlib import Path
from thinkblox.generate import generate_room
from thinkblox.value import to_json
for number, prompt in enumerate(sys.argv[2:]):
    Path(sys.argv[1], f"{number}.json").write_bytes(to_json(generate_room(prompt).scene))
"""
_DRAW = """
import json, sys, time
from pathlib import Path
from thinkblox.scene.scene import load_scene
from thinkblox.sim import render
folder, name = Path(sys.argv[1]), sys.argv[2]
taken = {}
for file in sorted(folder.glob("*.json")):
    scene = load_scene(file)
    for kind in ("render_preview", "render_top"):
        draw = getattr(render, kind)
        draw(scene, size=32)
        start = time.process_time()
        picture = draw(scene)
        taken[f"{file.stem} {kind}"] = time.process_time() - start
        picture.save(folder / f"{name}-{file.stem}-{kind}.png")
print(json.dumps(taken))
"""


def run(root: Path, code: str, *arguments: str) -> str:
    """What a script prints that imports the package from a checkout."""
    environment = os.environ | {"PYTHONPATH": str(root)}
    command = [sys.executable, "-c", code, *arguments]
    done = subprocess.run(command, cwd=root, env=environment, check=True, stdout=subprocess.PIPE, text=True)
    return done.stdout


def difference(folder: Path, drawn: str) -> tuple[float, float]:
    """Mean difference of the two pictures, and the share of pixels that differ by more than 8 [of 255]."""
    before, after = (
        np.asarray(Image.open(folder / f"{name}-{drawn.replace(' ', '-')}.png").convert("RGB")).astype(int)
        for name in ("before", "after")
    )
    apart = np.abs(before - after)
    return float(apart.mean()), float((apart.max(-1) > 8).mean())


def main() -> int:
    """Draw, and print a row for each picture."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--against", default="HEAD", help="a git revision")
    parser.add_argument("--rooms", type=int, default=len(ROOMS))
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--out", type=Path, help="where the pictures are kept")
    options = parser.parse_args()
    here = Path(__file__).resolve().parents[2]
    prompts = [PROMPTS.read_text().splitlines()[i] for i in ROOMS[: options.rooms]]
    with tempfile.TemporaryDirectory() as scratch:
        there, folder = Path(scratch) / "tree", options.out or Path(scratch) / "pictures"
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run(["git", "worktree", "add", "--detach", there, options.against], cwd=here, check=True)
        try:
            run(there, _MAKE, str(folder), *prompts)
            taken: dict[str, list[dict[str, float]]] = {"before": [], "after": []}
            for _ in range(options.runs):
                for name, root in (("before", there), ("after", here)):
                    taken[name].append(json.loads(run(root, _DRAW, str(folder), name)))
            report(folder, taken)
        finally:
            subprocess.run(["git", "worktree", "remove", "--force", there], cwd=here, check=True)
    return 0


def report(folder: Path, taken: dict[str, list[dict[str, float]]]) -> None:
    """A row for each picture, the least of its runs."""
    least = {name: {key: min(run[key] for run in runs) for key in runs[0]} for name, runs in taken.items()}
    print(f"{'picture':20} before   after  [CPU s]   ratio   mean difference   over 8")
    for key, before in least["before"].items():
        after = least["after"][key]
        mean, far = difference(folder, key)
        print(f"{key:20} {before:6.2f}  {after:6.2f} {after / before:15.2f} {mean:17.3f} {far:8.4f}")
    for kind in KINDS:
        before, after = (sum(s for key, s in least[name].items() if key.endswith(kind)) for name in ("before", "after"))
        print(f"{kind:20} {before:6.2f}  {after:6.2f} {after / before:15.2f}")


if __name__ == "__main__":
    sys.exit(main())
