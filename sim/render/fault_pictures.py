"""Pictures of a scene with the faults of its report: what is drawn where, in pixels, for any way of drawing it."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPoint
from shapely.geometry.base import BaseGeometry

from thinkblox.sim.render.drawn import Badge, FaultPicture, Mark, Point, Ring, Silhouette
from thinkblox.sim.render.fault_labels import badges_of, with_texts
from thinkblox.sim.render.faults import Fault, faults_of
from thinkblox.sim.render.labels import Box
from thinkblox.sim.render.lighting import lights
from thinkblox.sim.render.materials import linear
from thinkblox.sim.render.picture import Settings, paint
from thinkblox.sim.render.plan_marks import Marks, mark_openings
from thinkblox.sim.render.sights import Framing, Scenery, Sighted, from_above, scenery_of, three_quarter
from thinkblox.sim.render.tessellate import Ints
from thinkblox.sim.settings import Walking
from thinkblox.sim.subject import Subject
from thinkblox.verdict import Report

if TYPE_CHECKING:
    from PIL.Image import Image

Array = NDArray[np.float64]
PAPER = (0.972, 0.965, 0.950)
FADED = 0.55
"""How much of its colour the picture loses, so that what is drawn on it stands out."""
SHORTEST = 20.0
"""Arrows that would be shorter are drawn this long [pixels]."""
SPECK = 3.0
"""Areas thinner than this get a ring round them [pixels]."""
PADDING = 26.0


def fault_pictures(
    report: Report, subject: Subject, numbers: Mapping[str, int], *, size: int = 900, walking: Walking | None = None
) -> tuple[FaultPicture, FaultPicture]:
    """The room from above one corner and from straight above.

    Args:
        report: whose faults are drawn.
        subject: what was measured.
        numbers: of the objects that get one, by id.
        size: width and height of the pictures before they are trimmed [pixels].
        walking: says how deep the zones of doors and windows are.
    """
    scenery = scenery_of(subject)
    faults = faults_of(report, scenery, walking)
    sights = (three_quarter(scenery, numbers.keys()), from_above(scenery))
    first, second = (_pictured(scenery, sight, faults, numbers, size) for sight in sights)
    return first, second


def _pictured(
    scenery: Scenery, sight: Framing, faults: Sequence[Fault], numbers: Mapping[str, int], size: int
) -> FaultPicture:
    owners = sight.numbers(size)
    shown = {body.id for body in scenery.in_sight}
    outlines = [_outline(body, n, sight, owners, size) for n, body in enumerate(scenery.bodies) if body.id in shown]
    marks = [mark for fault in faults if fault.id in shown and (mark := _mark(fault, sight, size)) is not None]
    badges = badges_of([o for o in outlines if o.id in numbers], numbers, marks, size)
    box = _trimmed(sight.camera.project(scenery.bounds.corners, size), outlines, badges, size)
    return FaultPicture(
        image=_image(scenery, sight, size),
        box=box,
        outlines=tuple(outlines),
        marks=tuple(with_texts(marks, badges, box)),
        badges=tuple(badges),
    )


def _image(scenery: Scenery, sight: Framing, size: int) -> "Image":
    """The picture in pale colours, with doors and windows where it is a plan."""
    from PIL import Image

    paper = np.broadcast_to(np.array(linear(PAPER), np.float32), (size, size, 3))
    light = lights(sight.tracer, sight.sun, gather=10, sun_rays=4, spread=6.0, strength=0.8)
    colour = paint(sight.tracer, sight.camera, size, light, Settings(1.08, paper, coarse=3, edge_rays=5))
    grey = colour @ np.array([0.30, 0.59, 0.11])
    pale = colour * (1 - FADED) + grey[..., None] * FADED
    image = Image.fromarray(np.asarray(np.rint(pale * 0.9 + 25.5), np.uint8))
    if sight.camera.perspective or scenery.room is None:
        return image
    marks = Marks(sight.camera, size)
    mark_openings(marks, scenery.room)
    return marks.over(image)


def _outline(body: Sighted, number: int, sight: Framing, owners: Ints, size: int) -> Silhouette:
    hull = _hull(sight, body.points, size)
    seen = _region(owners == number)
    hidden = shapely.area(seen) < shapely.area(hull) / 3
    return Silhouette(body.id, _rings(seen), _rings(hull)[0] if _rings(hull) else (), bool(hidden))


def _hull(sight: Framing, points: Array, size: int) -> BaseGeometry:
    return MultiPoint(sight.camera.project(points, size)).convex_hull


def _region(mask: NDArray[np.bool_]) -> BaseGeometry:
    """The pixels of a mask as an area with smooth edges."""
    rows, columns = np.nonzero(np.diff(np.pad(mask, ((0, 0), (1, 1))).astype(np.int8), axis=1))
    starts, ends, tops = columns[::2], columns[1::2], rows[::2]
    runs = shapely.box(starts, tops - 0.01, ends, tops + 1.01)
    return shapely.simplify(shapely.union_all(runs), 1.4)


def _rings(area: BaseGeometry) -> tuple[Ring, ...]:
    """Outer and inner rings of an area, specks left out."""
    found: list[Ring] = []
    for part in shapely.get_parts(area):
        if isinstance(part, shapely.Polygon) and part.area > 4.0:
            found += [_ring(ring) for ring in (part.exterior, *part.interiors)]
    return tuple(found)


def _ring(line: BaseGeometry) -> Ring:
    return tuple((round(float(x), 1), round(float(y), 1)) for x, y in shapely.get_coordinates(line))


def _mark(fault: Fault, sight: Framing, size: int) -> Mark | None:
    """A fault as this camera sees it; None when it sees nothing of it."""
    area = shapely.union_all([_hull(sight, solid, size) for solid in fault.solids])
    dashes = tuple(_pixels(sight, line, size) for line in fault.dashes)
    arrow = _long_enough(*_pixels(sight, fault.arrow, size)) if fault.arrow is not None else None
    circles: tuple[Point, ...] = ()
    if fault.kind in ("contact", "unreachable"):
        circles = tuple(_pixels(sight, solid, size)[0] for solid in fault.solids)
    elif fault.solids and shapely.area(shapely.buffer(area, -SPECK / 2)) == 0.0:
        circles = (_point(shapely.get_coordinates(shapely.centroid(area))[0]),)
    rings = () if fault.kind in ("contact", "unreachable") else _rings(area)
    at = arrow[1] if arrow else circles[0] if circles else None
    if at is None and not shapely.is_empty(area):
        at = _point(shapely.get_coordinates(shapely.point_on_surface(area))[0])
    if at is None:
        return None
    return Mark(fault.kind, fault.id, rings, circles, arrow, tuple((a, b) for a, b in dashes), fault.text, at)


def _pixels(sight: Framing, points: Array, size: int) -> tuple[Point, ...]:
    return tuple(_point(pixel) for pixel in sight.camera.project(points, size))


def _point(pixel: Array) -> Point:
    return (round(float(pixel[0]), 1), round(float(pixel[1]), 1))


def _long_enough(start: Point, end: Point) -> tuple[Point, Point] | None:
    """An arrow that can be seen, pointing the same way; None when it points at the viewer."""
    length = float(np.hypot(end[0] - start[0], end[1] - start[1]))
    if length < 0.3:
        return None
    stretch = max(SHORTEST / length, 1.0)
    tip = (start[0] + (end[0] - start[0]) * stretch, start[1] + (end[1] - start[1]) * stretch)
    return start, _point(np.array(tip))


def _trimmed(frame: Array, outlines: Sequence[Silhouette], badges: Sequence[Badge], size: int) -> Box:
    """What of the picture is worth showing: the room, the objects and their numbers."""
    points = np.concatenate(
        [frame, *(np.array(o.hull) for o in outlines if o.hull), *(np.array([b.at]) for b in badges)]
    )
    low, high = points.min(0) - PADDING, points.max(0) + PADDING
    left, top = (float(np.clip(np.floor(c), 0, size)) for c in low)
    right, bottom = (float(np.clip(np.ceil(c), 0, size)) for c in high)
    return left, top, right, bottom
