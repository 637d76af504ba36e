"""What a draughtsman adds to a plan: doors and windows, measures, a scale and the north."""

import math
from typing import TYPE_CHECKING

import numpy as np

from thinkblox.scene.room import Opening, Room, Wall
from thinkblox.sim.render.camera import Camera
from thinkblox.sim.render.interior import THICKNESS
from thinkblox.value import Vec2

if TYPE_CHECKING:
    from PIL.Image import Image

INK = (58, 54, 50)
_PALE = (150, 144, 136)
_PAPER = (250, 248, 244)
_FINE = 2


class Marks:
    """Draws over a plan, in metres of the room, twice as fine as the picture."""

    def __init__(self, camera: Camera, size: int) -> None:
        from PIL import Image, ImageDraw

        self._camera, self._size = camera, size * _FINE
        self._sheet = Image.new("RGBA", (self._size, self._size), (0, 0, 0, 0))
        self._draw = ImageDraw.Draw(self._sheet)
        self._pen = max(round(size / 512), 1)

    def over(self, picture: "Image") -> "Image":
        """The picture with the marks on it."""
        small = self._sheet.reduce(_FINE)
        picture.paste(small.convert("RGB"), (0, 0), small.getchannel("A"))
        return picture

    def line(self, points: list[Vec2], *, colour: tuple[int, int, int] = INK, width: float = 1.0) -> None:
        """A line through points of the room."""
        self._draw.line(self._pixels(points), fill=(*colour, 255), width=round(self._pen * _FINE * width))

    def area(self, points: list[Vec2], *, colour: tuple[int, int, int], alpha: int = 255) -> None:
        """A filled polygon."""
        self._draw.polygon(self._pixels(points), fill=(*colour, alpha))

    def dashes(self, points: list[Vec2], *, colour: tuple[int, int, int] = INK) -> None:
        """A dashed line round a polygon: something overhead."""
        for start, end in zip(points, points[1:] + points[:1], strict=True):
            count = max(int(math.dist(start, end) / 0.08) // 2 * 2 + 1, 1)
            ends = [_between(start, end, i / count) for i in range(count + 1)]
            for i in range(0, count, 2):
                self.line(ends[i : i + 2], colour=colour)

    def _pixels(self, points: list[Vec2]) -> list[tuple[float, float]]:
        flat = np.array([(x, y, 0.0) for x, y in points])
        return [(float(x), float(y)) for x, y in self._camera.project(flat, self._size)]


def _between(start: Vec2, end: Vec2, share: float) -> Vec2:
    return (start[0] + (end[0] - start[0]) * share, start[1] + (end[1] - start[1]) * share)


def mark_openings(marks: Marks, room: Room) -> None:
    """Doors with their swing, windows with their panes."""
    for opening in room.openings:
        wall = room.walls[opening.wall]
        if opening.kind == "door":
            _mark_door(marks, wall, opening)
        else:
            _mark_window(marks, wall, opening)


def _gap(wall: Wall, opening: Opening) -> list[Vec2]:
    start, end = opening.offset, opening.offset + opening.width
    depth = -THICKNESS - 0.01
    return [wall.point(start), wall.point(end), wall.point(end, depth), wall.point(start, depth)]


def _mark_door(marks: Marks, wall: Wall, opening: Opening) -> None:
    start, end = opening.offset, opening.offset + opening.width
    hinge, away = (start, end) if opening.hinge == "start" else (end, start)
    step = 1 if away > hinge else -1
    turns = [math.pi / 2 * i / 24 for i in range(25)]
    deep = opening.width if opening.opens == "in" else -opening.width
    arc = [wall.point(hinge + step * opening.width * math.cos(t), deep * math.sin(t)) for t in turns]
    marks.area(_gap(wall, opening), colour=(214, 204, 190))
    marks.area([wall.point(hinge), *arc], colour=_PAPER, alpha=46)
    marks.line(arc, colour=INK, width=0.8)
    leaf = [wall.point(hinge), wall.point(hinge, deep), wall.point(hinge + 0.04 * step, deep)]
    marks.area([*leaf, wall.point(hinge + 0.04 * step)], colour=INK)


def _mark_window(marks: Marks, wall: Wall, opening: Opening) -> None:
    start, end = opening.offset, opening.offset + opening.width
    marks.area(_gap(wall, opening), colour=_PAPER)
    for depth in (0.0, -THICKNESS * 0.4, -THICKNESS * 0.6, -THICKNESS):
        marks.line([wall.point(start, depth), wall.point(end, depth)], width=0.8)
    for along in (start, end):
        marks.line([wall.point(along), wall.point(along, -THICKNESS)], width=0.8)


def mark_measures(marks: Marks, room: Room, gap: float) -> dict[str, Vec2]:
    """Lines with ticks under and beside the room; returns where to write which measure, "width" and "depth"."""
    width, depth = room.extent
    low, side, tick = -THICKNESS - gap, -THICKNESS - gap, gap * 0.25
    marks.line([(0.0, low), (width, low)], colour=_PALE)
    marks.line([(side, 0.0), (side, depth)], colour=_PALE)
    for x in (0.0, width):
        marks.line([(x - tick, low - tick), (x + tick, low + tick)], colour=INK)
    for y in (0.0, depth):
        marks.line([(side - tick, y - tick), (side + tick, y + tick)], colour=INK)
    return {"width": (width / 2, low), "depth": (side, depth / 2)}


def mark_scale(marks: Marks, corner: Vec2, unit: float) -> float:
    """A bar of four fields, alternately filled, its lower left corner given; returns its length [m]."""
    height = unit * 0.09
    for i in range(4):
        low, high = corner[0] + unit * i / 4, corner[0] + unit * (i + 1) / 4
        box = [(low, corner[1]), (high, corner[1]), (high, corner[1] + height), (low, corner[1] + height)]
        marks.area(box, colour=INK if i % 2 == 0 else _PAPER)
        marks.line([*box, box[0]], width=0.6)
    return unit


def mark_north(marks: Marks, tip: Vec2, length: float) -> None:
    """An arrow that points up the picture, its tip given."""
    x, y = tip
    marks.area([(x, y), (x - length * 0.28, y - length), (x, y - length * 0.78)], colour=INK)
    marks.area([(x, y), (x + length * 0.28, y - length), (x, y - length * 0.78)], colour=_PALE)
