"""The plan of a room: an orthographic picture from above with names, measures and doors."""

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.render.camera import Camera, plan_camera
from thinkblox.sim.render.interior import THICKNESS, Shell, add_room
from thinkblox.sim.render.labels import Box, Label, Labelled, laid_out, name_of_all, names_of, one_over_another
from thinkblox.sim.render.legend import MOST_NAMED, Legend, legend_of, numbered
from thinkblox.sim.render.lighting import lights
from thinkblox.sim.render.materials import linear
from thinkblox.sim.render.picture import Settings, paint
from thinkblox.sim.render.picture_size import check_picture_size
from thinkblox.sim.render.plan_marks import INK, Marks, mark_measures, mark_north, mark_openings, mark_scale
from thinkblox.sim.render.rays import Tracer
from thinkblox.sim.render.soup import Pose, Soup, add_objects
from thinkblox.value import Vec2

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

CUT_HEIGHT = 1.1
"""Where the walls are cut [m]."""
_CUT = (0.36, 0.335, 0.315)
_PAPER = (0.972, 0.965, 0.950)
_MARGIN = 0.095
_HALO = (252, 250, 246)


def render_top(scene: Scene, *, size: int = 1024, poses: Mapping[str, Pose] | None = None) -> "Image":
    """The plan, north up: objects with their names, door swings, windows, measures, a scale.

    What hangs from the ceiling is outlined only, so that it hides nothing. Many objects have numbers in place of names,
    and a list below the plan says what they mean, unless it would take more than half of the picture.

    Args:
        scene: what to show.
        size: width and height [pixels].
        poses: poses of asset origins that go before those in the scene, by placement id, as after settling.

    Raises:
        InputError: a size that no picture has.
    """
    from PIL import Image, ImageDraw

    check_picture_size(size)
    if len(scene.placements) <= MOST_NAMED:
        return _plan(scene, size, poses, None)
    legend = legend_of(scene.placements, text_size, size, _font_size(size, 15))
    if legend.height > size // 2:
        return _plan(scene, size, poses, None)
    small = _plan(scene, size - legend.height, poses, legend)
    paper = tuple(int(c) for c in np.asarray(small)[0, 0])
    whole = Image.new("RGB", (size, size), paper)
    whole.paste(small, ((size - small.width) // 2, 0))
    draw = ImageDraw.Draw(whole)
    for text, (x, y) in legend.places(size):
        _write(draw, text, (x, small.height + y), legend.font, anchor="lm")
    return whole


def _plan(scene: Scene, size: int, poses: Mapping[str, Pose] | None, legend: Legend | None) -> "Image":
    from PIL import Image, ImageDraw

    camera = plan_of(scene.room)
    picture = Image.fromarray(_painted(scene, camera, size, poses))
    marks = Marks(camera, size)
    mark_openings(marks, scene.room)
    for placement in overhead(scene):
        marks.dashes(_round_outline(placement))
    notes = _frame_marks(marks, scene.room, camera)
    picture = marks.over(picture)
    draw = ImageDraw.Draw(picture)
    for text, at in notes:
        _write(draw, text, _pixel(camera, at, size), _font_size(size, 15))
    reserved = [_text_box(text, _pixel(camera, at, size), _font_size(size, 15)) for text, at in notes]
    named = None if legend is None else plan_numbers(scene, camera, size, legend, reserved)
    for label in plan_labels(scene, camera, size, reserved) if named is None else named:
        _write_label(draw, label, size)
    return picture


def plan_of(room: Room, *, margin: float = _MARGIN) -> Camera:
    """The camera that looks down at a whole room, and at the doors that turn out of it."""
    corners = np.array(room.floor)
    outward = [
        room.walls[door.wall].point(along, -door.width)
        for door in room.openings
        if door.opens == "out"
        for along in (door.offset, door.offset + door.width)
    ]
    outer = np.concatenate([corners - THICKNESS, corners + THICKNESS, np.array(outward).reshape(-1, 2)])
    return plan_camera(outer, margin=margin)


def plan_labels(scene: Scene, camera: Camera, size: int, reserved: Sequence[Box] = ()) -> tuple[Label, ...]:
    """One label for each object, or for alike ones over each other, clear of the `reserved` boxes [pixels]."""
    names = names_of(scene.placements)
    things = [
        Labelled(members[0].id, names[members[0].id] if len(members) == 1 else name_of_all(members), _box_of(boxes))
        for members in one_over_another(scene.placements)
        if (boxes := [pixel_box(camera, member, size) for member in members])
    ]
    fonts = [_font_size(size, points) for points in (17, 14, 12)]
    return laid_out(things, text_size, size=size, fonts=fonts, reserved=reserved)


def plan_numbers(scene: Scene, camera: Camera, size: int, legend: Legend, reserved: Sequence[Box]) -> tuple[Label, ...]:
    """One number for each object, or for all of a kind on one thing."""
    things = []
    for number, members in numbered(scene.placements, legend):
        boxes = [pixel_box(camera, member, size) for member in members]
        things.append(Labelled(members[0].id, (number,), _box_of(boxes)))
    return laid_out(things, text_size, size=size, fonts=[_font_size(size, 14), _font_size(size, 11)], reserved=reserved)


def _box_of(boxes: Sequence[Box]) -> Box:
    """The box about all of these."""
    lefts, tops, rights, bottoms = zip(*boxes, strict=True)
    return min(lefts), min(tops), max(rights), max(bottoms)


def _painted(scene: Scene, camera: Camera, size: int, poses: Mapping[str, Pose] | None) -> NDArray[np.uint8]:
    soup = Soup()
    standing = (True,) * len(scene.room.walls)
    shell = Shell(standing, top=min(CUT_HEIGHT, scene.room.height), cut=_CUT)
    add_room(soup, scene.room, scene.surfaces, shell)
    add_objects(soup, scene, poses, hidden={p.id for p in overhead(scene)})
    tracer = Tracer(soup.triangles())
    light = lights(tracer, np.array([-0.30, 0.34, 1.0], np.float32), gather=8, sun_rays=4, spread=6.0, strength=0.75)
    paper = np.broadcast_to(np.array(linear(_PAPER), np.float32), (size, size, 3))
    return paint(tracer, camera, size, light, Settings(1.12, paper, coarse=3, edge_rays=5))


def overhead(scene: Scene) -> list[Placement]:
    """What hangs from the ceiling."""
    return [p for p in scene.placements if scene.asset_of(p).mount == "ceiling"]


def _round_outline(placement: Placement) -> list[Vec2]:
    half_x, half_y = placement.size[0] / 2, placement.size[1] / 2
    turns = [2 * math.pi * i / 24 for i in range(24)]
    return [placement.to_room((half_x * math.cos(t), half_y * math.sin(t))) for t in turns]


def _frame_marks(marks: Marks, room: Room, camera: Camera) -> list[tuple[str, Vec2]]:
    """Measures, scale and north in the margin; returns the texts that go with them."""
    width, depth = room.extent
    edge = _MARGIN * 2 * camera.reach
    places = mark_measures(marks, room, edge * 0.3)
    left, low = camera.position[0] - camera.reach, camera.position[1] - camera.reach
    unit = next((u for u in (10.0, 5.0, 2.0, 1.0, 0.5) if u < camera.reach / 2), 0.25)
    corner = (left + edge * 0.45, low + edge * 0.22)
    mark_scale(marks, corner, unit)
    tip = (left + 2 * camera.reach - edge * 0.5, low + 2 * camera.reach - edge * 0.18)
    mark_north(marks, tip, edge * 0.42)
    return [
        (f"{width:.2f} m", places["width"]),
        (f"{depth:.2f} m", places["depth"]),
        (f"{unit:g} m", (corner[0] + unit + edge * 0.32, corner[1] + unit * 0.045)),
        ("N", (tip[0], tip[1] - edge * 0.58)),
    ]


def _pixel(camera: Camera, at: Vec2, size: int) -> tuple[float, float]:
    x, y = camera.project(np.array([[at[0], at[1], 0.0]]), size)[0]
    return float(x), float(y)


def pixel_box(camera: Camera, placement: Placement, size: int) -> tuple[float, float, float, float]:
    """Left, top, right and bottom of an object's footprint in the picture [pixels]."""
    x0, y0, x1, y1 = placement.footprint.bounds
    (left, top), (right, bottom) = _pixel(camera, (x0, y1), size), _pixel(camera, (x1, y0), size)
    return left, top, right, bottom


def _font_size(size: int, points: int) -> int:
    """A font size for a picture of another width than 1024."""
    return max(round(points * size / 1024), 7)


def text_size(text: str, font: int) -> tuple[float, float]:
    """Width and height of a text at a font size [pixels]."""
    from PIL import ImageFont

    lines = text.split("\n")
    face = ImageFont.load_default(font)
    return max(face.getlength(line) for line in lines), font * 1.18 * len(lines)


def _text_box(text: str, at: tuple[float, float], font: int) -> Box:
    width, height = text_size(text, font)
    return at[0] - width / 2, at[1] - height / 2, at[0] + width / 2, at[1] + height / 2


def _write_label(draw: "ImageDraw", label: Label, size: int) -> None:
    if label.line_to is not None:
        draw.line([label.at, label.line_to], fill=_HALO, width=3)
        draw.line([label.at, label.line_to], fill=INK, width=1)
        x, y = label.line_to
        draw.ellipse([x - 2, y - 2, x + 2, y + 2], fill=INK)
    _write(draw, label.text, label.at, label.font)


def _write(draw: "ImageDraw", text: str, at: tuple[float, float], font: int, *, anchor: str = "mm") -> None:
    from PIL import ImageFont

    face = ImageFont.load_default(font)
    halo = max(round(font / 6), 1)
    draw.multiline_text(
        at, text, fill=INK, font=face, anchor=anchor, align="center", spacing=1, stroke_width=halo, stroke_fill=_HALO
    )
