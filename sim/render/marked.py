"""A small plan with every object's id on it, for policies that look at pictures."""

from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.scene import Scene
from thinkblox.sim.render.frame import Frame, cast
from thinkblox.sim.render.labels import Label, Labelled, laid_out
from thinkblox.sim.render.plan_marks import Marks, mark_openings
from thinkblox.sim.render.plan_view import overhead, pixel_box, plan_of, text_size
from thinkblox.sim.render.soup import Pose

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

_CHIP = (38, 36, 34)
_TARGET = (196, 74, 36)
_TEXT = (255, 255, 255)


def render_marked(
    scene: Scene,
    *,
    size: int = 448,
    marked: Collection[str] | None = None,
    targets: Collection[str] = (),
    poses: Mapping[str, Pose] | None = None,
) -> "Image":
    """A plan, north up, with ids on the objects and outlines round them.

    Args:
        scene: what to show.
        size: width and height [pixels].
        marked: ids to mark; all of them when None.
        targets: ids that stand out in another colour.
        poses: poses that go before those in the scene, by placement id.
    """
    from PIL import Image, ImageDraw

    camera = plan_of(scene.room, margin=0.06)
    frame = cast(_without_overhead(scene), camera, size=size, poses=poses)
    marks = Marks(camera, size)
    mark_openings(marks, scene.room)
    picture = marks.over(Image.fromarray(_outlined(frame)))
    draw = ImageDraw.Draw(picture)
    chosen = [p for p in scene.placements if marked is None or p.id in marked]
    things = [Labelled(p.id, (p.id,), pixel_box(camera, p, size)) for p in chosen]
    for label in laid_out(things, text_size, size=size, fonts=[max(round(size / 40), 7), max(round(size / 48), 7)]):
        _chip(draw, label, _TARGET if label.id in targets else _CHIP)
    return picture


def _without_overhead(scene: Scene) -> Scene:
    for placement in overhead(scene):
        scene = scene.without(placement.id)
    return scene


def _outlined(frame: Frame) -> NDArray[np.uint8]:
    """The frame's colours, darkened where one object ends and another begins."""
    ids, colour = frame.ids, frame.colour.copy()
    edge = np.zeros(ids.shape, bool)
    edge[1:] |= ids[1:] != ids[:-1]
    edge[:, 1:] |= ids[:, 1:] != ids[:, :-1]
    colour[edge] = colour[edge] // 3
    return colour


def _chip(draw: "ImageDraw", label: Label, colour: tuple[int, int, int]) -> None:
    from PIL import ImageFont

    width, height = text_size(label.text, label.font)
    x, y = label.at
    if label.line_to is not None:
        draw.line([label.at, label.line_to], fill=colour, width=1)
    box = [x - width / 2 - 2, y - height / 2 - 1, x + width / 2 + 2, y + height / 2 + 1]
    draw.rounded_rectangle(box, radius=3, fill=colour)
    draw.text((x, y), label.text, fill=_TEXT, font=ImageFont.load_default(label.font), anchor="mm")
