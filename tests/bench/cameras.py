"""What MuJoCo's cameras see of exported rooms, beside our preview: one row for each room.

MUJOCO_GL=egl python -m tests.bench.cameras ROOMS [--out docs/pictures/cameras.jpg]
"""

import argparse
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import mujoco
from PIL import Image

from thinkblox.exporters.exporting import export_scene
from thinkblox.scene.scene import Scene
from thinkblox.sim.environment import rooms_of
from thinkblox.sim.render import render_preview

TILE = (240, 180)
"""Width and height of a picture in pixels."""


def seen_of(scene: Scene) -> Iterator[Image.Image]:
    """The preview, and what each camera of the exported model sees when the room is at rest."""
    preview = render_preview(scene, size=2 * TILE[0]).convert("RGB")
    preview.thumbnail(TILE, Image.Resampling.LANCZOS)
    framed = Image.new("RGB", TILE, preview.getpixel((0, 0)))
    framed.paste(preview, ((TILE[0] - preview.width) // 2, (TILE[1] - preview.height) // 2))
    yield framed
    with tempfile.TemporaryDirectory(prefix="cameras-") as folder:
        room = export_scene(scene, Path(folder, "room"), formats=("mjcf",))
        model = mujoco.MjModel.from_xml_path(str(room / "scene.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    mujoco.mj_forward(model, data)
    with mujoco.Renderer(model, 2 * TILE[1], 2 * TILE[0]) as renderer:
        for camera in range(model.ncam):
            renderer.update_scene(data, camera=camera)
            yield Image.fromarray(renderer.render()).resize(TILE, Image.Resampling.LANCZOS)


def main() -> int:
    """Draw the sheet."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rooms", nargs="+")
    parser.add_argument("--out", type=Path, default=Path("docs/pictures/cameras.jpg"))
    arguments = parser.parse_args()
    rows = [list(seen_of(source.load())) for room in arguments.rooms for source in rooms_of(room)]
    sheet = Image.new("RGB", (TILE[0] * max(map(len, rows)), TILE[1] * len(rows)), "white")
    for y, row in enumerate(rows):
        for x, picture in enumerate(row):
            sheet.paste(picture, (x * TILE[0], y * TILE[1]))
    sheet.save(arguments.out, quality=85, optimize=True)
    print(f"written to {arguments.out}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
