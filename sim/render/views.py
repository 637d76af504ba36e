"""Views of a room for policies that look at pictures, with visual marks: metres, ids, and which way things face."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.asset import FRONT_UNKNOWN, Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.render.camera import framed
from thinkblox.sim.render.layers import NOTHING, Canvas, Viewpoint, canvas, cast_alone, outlined, viewpoint
from thinkblox.sim.render.metres import metre_grid
from thinkblox.sim.render.picture_size import check_picture_count, check_picture_size
from thinkblox.sim.render.plan_marks import Marks, mark_openings
from thinkblox.sim.render.spots import Box, Spots, font, text_extent

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

CORNERS = {"south-west": 225.0, "north-east": 45.0, "south-east": 315.0, "north-west": 135.0}
"""From over which corners a room is seen, in this order, and the azimuth of the camera [degrees]."""
_CROWD = 0.1
"""Names cover at most this share of a picture; where they would cover more, there are numbers."""
_FEW = 4
"""More small things of a kind than these on one thing share one number."""
_COVERED = 0.25
"""Names and numbers cover at most this share of the room that is seen; the smallest things have none then."""
_SEEN = 4
"""Objects of fewer pixels are not marked [pixels]."""
_POINTED = 4.0
"""Only objects of so many heads of an arrow squared have one."""
_TRIES = ((1.0, 0.0), (1.0, 0.35), (0.7, 0.0), (0.7, 0.5), (0.7, 0.9))
"""Lengths of an arrow, and how far it is drawn back, each as a share of its usual length, until none is under it."""
_CHIP, _TEXT, _ARROW, _HALO = (38, 36, 34), (255, 255, 255), (232, 84, 24), (255, 250, 240)
_PAPER = (240, 237, 230)
_GRID = 0.38
"""How dark the lines of the grid are."""


@dataclass(frozen=True)
class Marking:
    """Which marks a view has: metres along the walls, ids of the objects, arrows where their fronts are."""

    grid: bool = True
    ids: bool = True
    fronts: bool = True


@dataclass(frozen=True)
class RoomView:
    """A picture of a room with its marks.

    Attributes:
        name: "from above", or "from over the south-west corner".
        legend: what the numbers mean, "1 bed_1"; empty where names are written.
        boxes: where every mark is [pixels].
        unmarked: ids of what is seen and has no name or number, for want of room.
    """

    name: str
    picture: "Image"
    legend: tuple[str, ...]
    boxes: tuple[Box, ...]
    unmarked: tuple[str, ...] = ()


def room_views(scene: Scene, *, size: int, count: int = 3, marking: Marking | None = None) -> list[RoomView]:
    """The room from above and from over `count - 1` of its corners, evenly lit, drawn by one ray a pixel.

    Args:
        scene: what to show.
        size: width and height of each picture [pixels].
        count: how many, 1 to 5.
        marking: which marks; all of them when None.

    Raises:
        InputError: a size or a number of views that there is not.
    """
    check_picture_size(size)
    check_picture_count(count, 1 + len(CORNERS), "the number of views")
    marking = marking or Marking()
    names = _names(scene.placements, size) if marking.ids else {}
    views: list[tuple[str, float | None]] = [("from above", None)]
    views += [(f"from over the {corner} corner", azimuth) for corner, azimuth in CORNERS.items()]
    return [_drawn(scene, name, viewpoint(scene.room, a), size, marking, names) for name, a in views[:count]]


def render_target(asset: Asset, *, size: int = 168, front: bool = True) -> "Image":
    """One object alone, and on the ground before it an arrow that shows where its front is.

    Args:
        asset: what to show.
        size: width and height [pixels].
        front: whether there is an arrow.

    Raises:
        InputError: a size that no picture has.
    """
    from PIL import Image, ImageDraw

    check_picture_size(size)

    x, y, z = (extent / 2 for extent in asset.size)
    reach = x + 0.7 * max(x, y, 0.7 * z)
    corners = [(a, b, c) for a in (-x, x) for b in (-y, y) for c in (0.0, 2 * z)]
    has_front = asset.front == "one" and FRONT_UNKNOWN not in asset.flags
    points = np.array([*corners, (reach, 0.0, 0.0)] if front and has_front else corners)
    camera = framed(points, azimuth=30.0, elevation=27.0, field=24.0, margin=0.07)
    sheet = Image.new("RGB", (size, size), _PAPER)
    if front and has_front:
        wide, neck = 0.45 * (reach - x), x + 0.5 * (reach - x)
        flat = [(x, -wide / 2), (neck, -wide / 2), (neck, -wide), (reach, 0.0)]
        flat += [(neck, wide), (neck, wide / 2), (x, wide / 2)]
        shape = camera.project(np.array([(a, b, 0.0) for a, b in flat]), size)
        ImageDraw.Draw(sheet).polygon([(float(a), float(b)) for a, b in shape], fill=_ARROW)
    colour = np.asarray(sheet).copy()
    layer = cast_alone(asset, (0.0, 0.0, 0.0), 0.0, camera, size)
    if layer is not None:
        height, width = layer.depth.shape
        part = colour[layer.top : layer.top + height, layer.left : layer.left + width]
        there = np.isfinite(layer.depth)
        part[there] = layer.colour[there]
        if layer.clear is not None:
            glass = layer.clear[..., 0] < 1.0
            behind = part[glass] * layer.clear[glass, :1] + 255.0 * layer.clear[glass, 1:]
            part[glass] = np.minimum(behind, 255.0).astype(np.uint8)
    return Image.fromarray(colour)


def _names(placements: Sequence[Placement], size: int) -> dict[str, str]:
    """What is written on each object: its id, or its number in the order of placement where ids take too much room."""
    extents = [text_extent(p.id, _font(size)) for p in placements]
    if sum((w + 2) * (h + 2) for w, h in extents) <= _CROWD * size * size:
        return {p.id: p.id for p in placements}
    return {p.id: str(number) for number, p in enumerate(placements, 1)}


def _font(size: int) -> int:
    return max(round(size / 36), 8)


def _drawn(scene: Scene, name: str, view: Viewpoint, size: int, marking: Marking, names: dict[str, str]) -> RoomView:
    from PIL import Image, ImageDraw

    seen = canvas(scene, view, size)
    colour = outlined(seen)
    if view.azimuth is None:
        _draw_openings(colour, seen, scene.room, view, size)
    spots = Spots(seen.ids)
    grid = metre_grid(scene.room, view, size, _font(size)) if marking.grid else None
    if grid is not None:
        lines = grid.lines & seen.floor
        colour[lines] = (colour[lines] * (1.0 - _GRID)).astype(np.uint8)
    picture = Image.fromarray(colour)
    draw = ImageDraw.Draw(picture)
    boxes: list[Box] = []
    for text, box, ink in grid.numbers if grid is not None else ():
        if not spots.taken[box[1] : box[3], box[0] : box[2]].any():
            spots.take(box)
            boxes.append(box)
            _write(draw, text, box, _font(size), ink)
    marked = _Seen(scene, seen, view, size)
    if marking.fronts:
        boxes += _draw_fronts(draw, marked, spots, size)
    unmarked: tuple[str, ...] = ()
    if names:
        named, unmarked = _draw_names(draw, marked, spots, names, size)
        boxes += named
    return RoomView(name, picture, _legend(scene.placements, names), tuple(boxes), unmarked)


class _Seen:
    """What a picture shows of each object: its pixels' number and the middle of them."""

    def __init__(self, scene: Scene, canvas: Canvas, view: Viewpoint, size: int) -> None:
        self.scene, self.view, self.size, self.ids = scene, view, size, canvas.ids
        flat, count = canvas.ids.ravel(), len(scene.placements)
        mine = np.flatnonzero(flat >= 0)
        numbers = flat[mine]
        self.area = np.bincount(numbers, minlength=count)
        x = np.bincount(numbers, mine % size, minlength=count) / np.maximum(self.area, 1)
        y = np.bincount(numbers, mine // size, minlength=count) / np.maximum(self.area, 1)
        self.middle = np.stack([x, y], 1)
        for number in np.flatnonzero(self.area):
            at_x, at_y = np.rint(self.middle[number]).astype(int)
            if canvas.ids[at_y, at_x] != number:
                own = mine[numbers == number]
                off = np.hypot(own % size - at_x, own // size - at_y)
                pick = int(own[np.argmin(off)])
                self.middle[number] = (pick % size, pick // size)
        if view.azimuth is None:
            self._add_overhead()

    def _add_overhead(self) -> None:
        """What hangs from the ceiling is marked where it hangs, though it is not drawn."""
        self.overhead = [n for n, p in enumerate(self.scene.placements) if self.scene.asset_of(p).mount == "ceiling"]
        for number in self.overhead:
            p = self.scene.placements[number]
            self.middle[number] = self.view.camera.project(np.array([(*p.position[:2], 0.0)]), self.size)[0]
            self.area[number] = _SEEN


def _draw_openings(colour: NDArray[np.uint8], seen: Canvas, room: Room, view: Viewpoint, size: int) -> None:
    """Doors with their swings and windows, under what stands in the room."""
    drawn, alpha = _openings(room, view, size)
    there = (alpha > 0) & (seen.ids < 0)
    share = alpha[there][:, None] / 255.0
    colour[there] = (colour[there] * (1.0 - share) + drawn[there] * share).astype(np.uint8)


@lru_cache(64)
def _openings(room: Room, view: Viewpoint, size: int) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    from PIL import Image

    marks = Marks(view.camera, size)
    mark_openings(marks, room)
    on_black, on_white = (
        np.asarray(marks.over(Image.new("RGB", (size, size), (tone,) * 3)), np.int16) for tone in (0, 255)
    )
    alpha = 255 - np.clip(on_white - on_black, 0, 255).mean(2)
    drawn = np.where(alpha[..., None] > 0, on_black * 255.0 / np.maximum(alpha[..., None], 1), 0)
    return np.clip(drawn, 0, 255).astype(np.uint8), alpha.astype(np.uint8)


def _draw_fronts(draw: "ImageDraw", seen: _Seen, spots: Spots, size: int) -> list[Box]:
    """An arrow on every object that has a front, large ones first, none over another."""
    boxes: list[Box] = []
    for number in np.argsort(-seen.area, kind="stable"):
        placement = seen.scene.placements[number]
        asset = seen.scene.asset_of(placement)
        if seen.area[number] < _POINTED * _head(size) ** 2 or asset.front != "one" or FRONT_UNKNOWN in asset.flags:
            continue
        way = _way(seen, placement)
        long = float(np.hypot(*way))
        if long < 1.0:
            continue
        way *= float(np.clip(long, 6.0, size / 17)) / long
        for share, back in _TRIES:
            start = seen.middle[number] - (0.35 + back) * share * way
            end = start + share * way
            (left, top), (right, bottom) = np.minimum(start, end), np.maximum(start, end)
            box = (int(left) - 2, int(top) - 2, int(right) + 3, int(bottom) + 3)
            if min(box) < 0 or spots.taken[box[1] : box[3], box[0] : box[2]].any():
                continue
            spots.take(box)
            boxes.append(box)
            _arrow(draw, start, end, size)
            break
    return boxes


def _way(seen: _Seen, placement: Placement) -> NDArray[np.float64]:
    """From an object's middle to its front in the picture [pixels]."""
    x, y, z = placement.position
    z += placement.size[2] / 2
    half = placement.size[0] / 2
    fx, fy = placement.front
    ends = np.array([(x, y, z), (x + fx * half, y + fy * half, z)])
    a, b = seen.view.camera.project(ends, seen.size)
    return np.asarray(b - a)


def _head(size: int) -> float:
    """Half the width of an arrow's head [pixels]."""
    return max(size / 84, 2.0)


def _arrow(draw: "ImageDraw", start: NDArray[np.float64], end: NDArray[np.float64], size: int) -> None:
    way = (end - start) / max(float(np.hypot(*(end - start))), 1e-9)
    across = np.array([-way[1], way[0]])
    head = _head(size)
    neck = end - way * head * 1.4
    tips = [tuple(neck + across * head), tuple(end), tuple(neck - across * head)]
    pen = max(round(size / 224), 1)
    for colour, extra in ((_HALO, 2), (_ARROW, 0)):
        draw.line([tuple(start), tuple(neck)], fill=colour, width=pen + extra)
        draw.polygon(tips, fill=colour, outline=colour, width=extra // 2 + 1)


def _draw_names(
    draw: "ImageDraw", seen: _Seen, spots: Spots, names: dict[str, str], size: int
) -> tuple[list[Box], tuple[str, ...]]:
    """Each name on its object or beside it with a line to it, small objects first; and the ids of what has none."""
    face, left = _font(size), _COVERED * float((seen.ids != NOTHING).sum())
    groups = _groups(seen, names, face)
    fitting = 0
    for text, _ in reversed(groups):
        left -= float(np.prod(text_extent(text, face)))
        fitting += left >= 0.0
    placed: list[tuple[str, Box]] = []
    without = [number for _, members in groups[: len(groups) - fitting] for number in members]
    for text, members in groups[len(groups) - fitting :]:
        weights = seen.area[members][:, None]
        middle = (seen.middle[members] * weights).sum(0) / weights.sum()
        box = spots.nearest((float(middle[0]), float(middle[1])), text_extent(text, face))
        if box is None:
            without += members
            continue
        placed.append((text, box))
        _lead(draw, seen, members, middle, box)
    for text, box in placed:
        draw.rectangle([box[0], box[1], box[2] - 1, box[3] - 1], fill=_CHIP)
        _write(draw, text, box, face, _TEXT)
    return [box for _, box in placed], tuple(seen.scene.placements[n].id for n in sorted(without))


def _lead(draw: "ImageDraw", seen: _Seen, members: list[int], middle: NDArray[np.float64], box: Box) -> None:
    """A line from a name to its object, where they do not touch or the object is small."""
    near = seen.ids[max(box[1] - 2, 0) : box[3] + 2, max(box[0] - 2, 0) : box[2] + 2]
    small = seen.area[members].sum() < (box[2] - box[0]) * (box[3] - box[1]) / 2
    if small or not any((near == member).any() for member in members):
        end = (min(max(middle[0], box[0]), box[2] - 1), min(max(middle[1], box[1]), box[3] - 1))
        draw.line([tuple(middle), end], fill=_CHIP, width=1)
        draw.ellipse([middle[0] - 1, middle[1] - 1, middle[0] + 1, middle[1] + 1], fill=_CHIP)


def _groups(seen: _Seen, names: dict[str, str], face: int) -> list[tuple[str, list[int]]]:
    """What is written on which objects, the smallest first: small things of a kind on one thing share a mark."""
    shared: dict[tuple[str, str], list[int]] = {}
    single: list[tuple[str, list[int]]] = []
    for number in np.flatnonzero(seen.area >= _SEEN):
        p = seen.scene.placements[int(number)]
        width, height = text_extent(names[p.id], face)
        if p.support in seen.scene and seen.area[number] < width * height:
            shared.setdefault((p.category, p.support), []).append(int(number))
        else:
            single.append((names[p.id], [int(number)]))
    for members in shared.values():
        ids = [seen.scene.placements[n].id for n in members]
        if len(members) > _FEW:
            single += [(_range([names[ids[a]], names[ids[b]]]), members[a : b + 1]) for a, b in _runs(members)]
        else:
            single += [(names[id], [n]) for id, n in zip(ids, members, strict=True)]
    return sorted(single, key=lambda pair: int(seen.area[pair[1]].sum()))


def _runs(members: list[int]) -> list[tuple[int, int]]:
    """First and last place of each run of following numbers."""
    breaks = [0, *(i for i in range(1, len(members)) if members[i] != members[i - 1] + 1), len(members)]
    return [(a, b - 1) for a, b in pairwise(breaks)]


def _range(ends: list[str]) -> str:
    """12-21, book_3-7, or one name."""
    first, last = ends
    return first if first == last else f"{first}-{last.rpartition('_')[2]}"


def _write(draw: "ImageDraw", text: str, box: Box, face: int, ink: tuple[int, int, int]) -> None:
    at = ((box[0] + box[2]) / 2, (box[1] + box[3]) / 2)
    draw.text(at, text, fill=ink, font=font(face), anchor="mm")


def _legend(placements: Sequence[Placement], names: dict[str, str]) -> tuple[str, ...]:
    """What numbers mean, runs of a kind together: "1 sofa_1", "2-7 chair_1 to chair_6"; none for names."""
    if all(names.get(p.id, p.id) == p.id for p in placements):
        return ()
    entries: list[str] = []
    start = 0
    for end in range(1, len(placements) + 1):
        if end < len(placements) and _follows(placements[end - 1].id, placements[end].id):
            continue
        first, last = placements[start].id, placements[end - 1].id
        both = end - start > 1
        entries.append(f"{start + 1}-{end} {first} to {last}" if both else f"{end} {first}")
        start = end
    return tuple(entries)


def _follows(first: str, second: str) -> bool:
    (a, _, m), (b, _, n) = first.rpartition("_"), second.rpartition("_")
    return a == b and m.isdecimal() and n.isdecimal() and int(n) == int(m) + 1


__all__ = ["CORNERS", "Marking", "RoomView", "render_target", "room_views"]
