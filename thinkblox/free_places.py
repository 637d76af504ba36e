"""Where in a room there is space for a thing: lines along walls, by its anchors, on what carries it, on the open floor.

For whoever cannot work that out from outlines alone, such as a small model; what is found is a hint, and no verdict.
"""

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thinkblox.assets import facts_of
from thinkblox.plan import Target, Tie, carries
from thinkblox.scene.arrangement import Arrangement, Known
from thinkblox.scene.asset import Asset, AssetCard, Surface
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Array, Rects, outside, overlap_depth
from thinkblox.scene.room import Opening, Room, Wall
from thinkblox.scene.zones import beside, joined
from thinkblox.value import Vec2, Vec3

STEP = 0.05
"""Between places that are looked at along a line [m]."""
GAP, HUNG = 0.02, 0.002
"""Left between a thing and the wall behind it: one that stands, one that hangs [m]."""
BESIDE = (0.02, 1.5)
"""Nearest and farthest free distance from an anchor that is looked at [m]."""
DRAWN_UP = 0.05
"""Free distance of what is drawn up to a side of its anchor [m]."""
WINDOW_DEPTH = 0.3
OPENING_DEPTH = 0.5
"""Floor kept free before a window that a thing would darken, and before doors and drawers of furniture [m]."""
TOUCH = 0.001
"""Boxes that are in each other no deeper are apart [m]."""
MOST_EACH, MOST_CARRIERS, MOST = 3, 3, 14
"""Stretches named of one line, things on which they are looked for, and stretches in all."""
_TOWARDS = ("around", "at", "at_long_side", "at_short_side", "facing", "opposite", "in_front_of")
"""Relations by which a thing is turned to its anchor; otherwise it is turned as that is."""
_BY = (*_TOWARDS, "next_to", "near", "behind", "between", "beside", "at_foot_of", "left_of", "right_of")
_LONG_SIDES = ("around", "at", "at_long_side", "at_short_side")
"""Relations by which several share a side of the anchor."""
_ALSO_BY_WALLS = frozenset(("against_wall", "in_corner", "near", "facing", "opposite", "behind"))
_IN_THE_OPEN = frozenset(("in_centre", "in_rows", "facing"))
"""Relations that a thing by a wall may have though it has an anchor, and those that one on the open floor may."""
_SIDES: tuple[tuple[str, float], ...] = (("front", 0.0), ("left", 90.0), ("back", 180.0), ("right", 270.0))


class Stretch(NamedTuple):
    """Places in a line at which a thing, turned to one yaw, is in nothing.

    Attributes:
        by: the wall behind it, "on bed_1", "left of bed_1", or "open" for the open floor or ceiling.
        yaw: of the thing [degrees].
        start, end: of its base's centre [m].
    """

    by: str
    yaw: float
    start: Vec3
    end: Vec3

    def distance(self, place: Vec3) -> float:
        """How far a place is from the line [m]."""
        a, b, p = np.array(self.start), np.array(self.end), np.array(place)
        length = float(np.dot(b - a, b - a))
        share = min(max(float(np.dot(p - a, b - a)) / length, 0.0), 1.0) if length else 0.0
        return float(np.linalg.norm(p - (a + share * (b - a))))


class _Line(NamedTuple):
    by: str
    yaw: float
    start: Vec3
    end: Vec3
    within: frozenset[str]
    """What it may reach into: the box of a shelf holds what stands in it."""


class _Taken(NamedTuple):
    """What stands in the way: the boxes of solid things, and these with the floor that is kept free."""

    solid: Rects
    all: Rects


def free_places(scene: Arrangement, target: Target, asset: AssetCard) -> tuple[Stretch, ...]:
    """Stretches of free places for a thing of this size, those of one line with the longest first.

    Args:
        scene: what stands so far.
        target: what is wanted of it; only what stands already can be an anchor.
        asset: what it is.
    """
    found: list[Stretch] = []
    taken: dict[frozenset[str], _Taken] = {}
    for line in _lines(scene, target, asset):
        if line.within not in taken:
            taken[line.within] = _taken(scene, line.within)
        free = sorted(_free(scene.room, asset, line, taken[line.within]), key=lambda s: -math.dist(s.start, s.end))
        found += free[:MOST_EACH]
    return tuple(found[:MOST])


def _lines(scene: Arrangement, target: Target, asset: AssetCard) -> Iterator[_Line]:
    if asset.mount == "wall":
        yield from _hung(scene.room, target, asset)
        return
    if asset.mount == "ceiling":
        yield from _overhead(scene, target, asset)
        return
    wanted = [scene[a] for tie in target.ties if carries(tie) for a in tie.anchors if a in scene]
    wanted = [carrier for carrier in wanted if scene.asset_of(carrier).surfaces]
    by_wall = any(tie.kind == "against_wall" for tie in target.ties)
    any_carriers = asset.mount == "surface" and not by_wall
    others = [p for p in scene.placements if any_carriers and scene.asset_of(p).surfaces][:MOST_CARRIERS]
    for carrier in wanted or others:
        yield from _on(scene, carrier, asset)
    if not wanted:
        yield from _on_floor(scene, target, asset)


def _on_floor(scene: Arrangement, target: Target, asset: AssetCard) -> Iterator[_Line]:
    close = [(tie, scene[a]) for tie in target.ties if tie.kind in _BY for a in tie.anchors if a in scene]
    for tie, anchor in close[:2]:
        yield from _by(anchor, asset, tie)
    kinds = {tie.kind for tie in target.ties}
    if "in_rows" in kinds:
        siblings = [p for p in scene.placements if p.category == target.category]
        for sibling in siblings[-1:]:
            yield from _outward(sibling, asset, same=True)
    if not close or kinds & _ALSO_BY_WALLS:
        yield from _standing(scene.room, target, asset)
    if not kinds or kinds & _IN_THE_OPEN:
        yield from _open(scene.room, asset, 0.0)


def _named(room: Room, target: Target) -> tuple[Wall, ...]:
    """The walls that its ties name by the compass; all where they name none."""
    places = {anchor for tie in target.ties for anchor in tie.anchors}
    return tuple(wall for wall in room.walls if wall.name in places) or room.walls


def _standing(room: Room, target: Target, asset: AssetCard) -> Iterator[_Line]:
    turned = asset.front != "one" and asset.size[0] > asset.size[1]
    depth, width = (asset.size[1], asset.size[0]) if turned else asset.size[:2]
    for wall in _named(room, target):
        yaw = (wall.yaw + (90.0 if turned else 0.0)) % 360.0
        yield from _along(wall, yaw, depth, width, GAP, 0.0)


def _hung(room: Room, target: Target, asset: AssetCard) -> Iterator[_Line]:
    middle = facts_of(target.category).hanging.middle - asset.size[2] / 2
    z = round(min(max(0.0, middle), room.height - asset.size[2]), 3)
    for wall in _named(room, target):
        yield from _along(wall, wall.yaw, asset.size[0], asset.size[1], HUNG, z)


def _along(wall: Wall, yaw: float, depth: float, width: float, gap: float, z: float) -> Iterator[_Line]:
    low, high = width / 2 + gap, wall.length - width / 2 - gap
    if high >= low:
        ends = (wall.point(along, gap + depth / 2) for along in (low, high))
        start, end = ((x, y, z) for x, y in ends)
        yield _Line(wall.name, yaw, start, end, frozenset())


def _overhead(scene: Arrangement, target: Target, asset: AssetCard) -> Iterator[_Line]:
    z = scene.room.height - asset.size[2]
    for anchor in (scene[a] for tie in target.ties for a in tie.anchors if a in scene):
        x, y, _ = anchor.position
        yield _Line(f"above {anchor.id}", anchor.yaw, (x, y, z), (x, y, z), frozenset())
    yield from _open(scene.room, asset, z)


def _open(room: Room, asset: AssetCard, z: float) -> Iterator[_Line]:
    x0, y0, x1, y1 = room.polygon.bounds
    longer = 0.0 if (asset.size[0] > asset.size[1]) == (x1 - x0 > y1 - y0) else 90.0
    half = max(asset.size[:2]) / 2
    for share in (0.5, 0.25, 0.75):
        y = y0 + share * (y1 - y0)
        yield _Line("open", longer, (x0 + half, y, z), (x1 - half, y, z), frozenset())


def _by(anchor: Placement, asset: AssetCard, tie: Tie) -> Iterator[_Line]:
    if tie.kind not in _LONG_SIDES:
        yield from _outward(anchor, asset, same=tie.kind not in _TOWARDS)
        return
    for side, turn in _SIDES:
        out, wide = (0, 1) if side in ("front", "back") else (1, 0)
        far = anchor.size[out] / 2 + DRAWN_UP + asset.size[0] / 2
        aside = max(anchor.size[wide] / 2 - asset.size[1] / 2, 0.0)
        start, end = (_turned((far, along), turn) for along in (-aside, aside))
        yield _line_by(anchor, side, start, end, (anchor.yaw + turn + _back(asset)) % 360.0, _base(anchor, asset))


def _outward(anchor: Placement, asset: AssetCard, *, same: bool) -> Iterator[_Line]:
    for side, turn in _SIDES:
        out = 0 if side in ("front", "back") else 1
        reach = asset.size[out] if same else asset.size[0]
        start, end = (_turned((anchor.size[out] / 2 + gap + reach / 2, 0.0), turn) for gap in BESIDE)
        yaw = anchor.yaw if same else (anchor.yaw + turn + _back(asset)) % 360.0
        yield _line_by(anchor, side, start, end, yaw, _base(anchor, asset))


def _base(anchor: Placement, asset: AssetCard) -> float:
    """At which height it stands by an anchor [m]."""
    return anchor.position[2] if asset.mount == "surface" else 0.0


def _back(asset: AssetCard) -> float:
    """By how much it is turned against the way out of its anchor's side [degrees]."""
    return 0.0 if asset.gaze == "back" else 180.0


def _line_by(anchor: Placement, side: str, start: Vec2, end: Vec2, yaw: float, z: float) -> _Line:
    (ax, ay), (bx, by) = anchor.to_room(start), anchor.to_room(end)
    return _Line(f"{side} of {anchor.id}", yaw, (ax, ay, z), (bx, by, z), frozenset())


def _turned(point: Vec2, turn: float) -> Vec2:
    c, s = round(math.cos(math.radians(turn))), round(math.sin(math.radians(turn)))
    return (point[0] * c - point[1] * s, point[0] * s + point[1] * c)


def _on(scene: Arrangement, carrier: Placement, asset: AssetCard) -> Iterator[_Line]:
    """On each surface along its longer side: in the middle, and before and behind that where it is deep enough."""
    held = frozenset([carrier.id, *scene.carriers(carrier.id)])
    for surface in sorted(scene.asset_of(carrier).surfaces, key=lambda s: s.headroom is not None)[:MOST_CARRIERS]:
        if surface.headroom is not None and surface.headroom < asset.size[2]:
            continue
        for depth, width, turn in ((*asset.size[:2], 0.0), (asset.size[1], asset.size[0], 90.0)):
            if depth <= surface.size[0] + 0.04 and width <= surface.size[1]:
                yield from _lengthwise(carrier, surface, depth, width, turn, held)
                break


def _lengthwise(
    carrier: Placement, surface: Surface, depth: float, width: float, turn: float, held: frozenset[str]
) -> Iterator[_Line]:
    x, y, z = surface.position
    height = round(carrier.position[2] + z, 4)
    long = 1 if surface.size[1] >= surface.size[0] else 0
    own = (depth, width)
    along = max(surface.size[long] / 2 - own[long] / 2, 0.0) * (0.7 if surface.round else 1.0)
    across = surface.size[1 - long] / 2 - own[1 - long] / 2
    for share in (0.0, -0.6, 0.6) if across > own[1 - long] / 2 else (0.0,):
        ends = []
        for sign in (-1.0, 1.0):
            local = [0.0, 0.0]
            local[long], local[1 - long] = sign * along, share * across
            ends.append((*carrier.to_room((x + local[0], y + local[1])), height))
        yield _Line(f"on {carrier.id}", (carrier.yaw + turn) % 360.0, ends[0], ends[1], held)


def _free(room: Room, asset: AssetCard, line: _Line, taken: _Taken) -> Iterator[Stretch]:
    """The parts of a line at which a thing is in nothing."""
    count = max(1, math.ceil(math.dist(line.start, line.end) / STEP - 1e-6)) + 1
    points = np.linspace(line.start, line.end, count)
    good = _is_free(room, asset, line, points, taken)
    start = None
    for index in range(count + 1):
        if index < count and good[index]:
            start = index if start is None else start
        elif start is not None:
            yield Stretch(line.by, line.yaw, _vec(points[start]), _vec(points[index - 1]))
            start = None


def _vec(point: Array) -> Vec3:
    x, y, z = (round(float(c), 4) for c in point)
    return (x, y, z)


def _is_free(room: Room, asset: AssetCard, line: _Line, points: Array, taken: _Taken) -> NDArray[np.bool_]:
    depth, width, height = asset.size
    boxes = Rects.of([((x, y), (depth, width), line.yaw, z, z + height) for x, y, z in points.tolist()])
    free = outside(boxes, room.polygon) <= 1e-6
    if not asset.collides:
        return free
    free &= (overlap_depth(boxes, taken.all) <= TOUCH).all(-1)
    if asset.opens:
        before = beside(boxes, "front", OPENING_DEPTH)
        free &= (overlap_depth(before, taken.solid) <= TOUCH).all(-1)
    return np.asarray(free)


def _taken(scene: Arrangement, within: frozenset[str]) -> _Taken:
    """What a thing must not reach into that may be in some of what is there."""
    solid = tuple(p for p in scene.placements if p.id not in within and scene.asset_of(p).collides)
    boxes = Rects.of_placements(solid)
    return _Taken(boxes, joined([boxes, *_kept(scene, solid)]))


def _kept(scene: Arrangement, solid: Sequence[Placement]) -> list[Rects]:
    """The floor that is kept free before doors, windows, and what opens."""
    zones = []
    for opening in scene.room.openings:
        door = opening.kind == "door"
        zones.append(Rects.of([_zone(scene.room, opening, opening.width if door else WINDOW_DEPTH)]))
    opening_things = tuple(p for p in solid if _opens(scene.asset_of(p)))
    if opening_things:
        zones.append(beside(Rects.of_placements(opening_things), "front", OPENING_DEPTH))
    return zones


def _opens(known: Known) -> bool:
    return bool((known.card if isinstance(known, Asset) else known).opens)


def _zone(room: Room, opening: Opening, depth: float) -> tuple[Vec2, Vec2, float, float, float]:
    wall = room.walls[opening.wall]
    centre = wall.point(opening.offset + opening.width / 2, depth / 2)
    return (centre, (depth, opening.width), wall.yaw, opening.sill, opening.sill + opening.height)
