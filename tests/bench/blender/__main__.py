"""What Blender makes of a room's stage and of its glTF, each drawn from a corner, beside our preview.

python -m tests.bench.blender ROOM [--camera corner_1] [--home DIR] [--out docs/pictures/blender.jpg]
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from PIL import Image

from tests.bench.venvs import interpreter
from thinkblox.exporters.exporting import export_scene
from thinkblox.scene.scene import load_scene
from thinkblox.sim.render import render_preview

NEEDS = ("bpy==5.0.1",)
FILES = ("scene.usdc", "scene.glb")
SIDE = 480
"""Height of a picture in pixels."""


def drawn(file: Path, camera: str, picture: Path, home: Path) -> dict[str, Any]:
    """What Blender read of a file, which it draws as `picture`.

    Raises:
        RuntimeError: it cannot be installed, or fails; says how.
    """
    python = interpreter(home / "blender", NEEDS)
    command: list[str | Path] = [python, Path(__file__).with_name("draw.py"), file, camera, picture]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=1200)
    if done.returncode or not picture.exists():
        raise RuntimeError((done.stderr.strip().splitlines() or ["ends without a picture"])[-1][:200])
    return json.loads(done.stdout.splitlines()[-1])  # type: ignore[no-any-return]


def main() -> int:
    """Draw the sheet, and print what was read of each file."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("room", type=Path)
    parser.add_argument("--camera", default="corner_1")
    parser.add_argument("--home", type=Path, default=Path("out/engines"))
    parser.add_argument("--out", type=Path, default=Path("docs/pictures/blender.jpg"))
    arguments = parser.parse_args()
    scene = load_scene(arguments.room / "scene.json")
    pictures = [render_preview(scene, size=SIDE).convert("RGB")]
    with tempfile.TemporaryDirectory(prefix="blender-") as folder:
        room = export_scene(scene, Path(folder, "room"), formats=("usdc", "glb"))
        for file in FILES:
            picture = Path(folder, f"{file}.png")
            read = drawn(room / file, arguments.camera, picture, arguments.home.absolute())
            print(f"{file}: " + ", ".join(f"{count} {kind.lower()}" for kind, count in read.items()))
            pictures.append(Image.open(picture).convert("RGB"))
    sheet = Image.new("RGB", (sum(p.width for p in pictures), SIDE))
    left = 0
    for each in pictures:
        sheet.paste(each, (left, 0))
        left += each.width
    sheet.save(arguments.out, quality=88, optimize=True)
    print(f"written to {arguments.out}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
