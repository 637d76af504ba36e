"""From an outline to a Room: counter-clockwise, its bounding box at the origin, every hole in the wall it lies in."""

import math
import re

from msgspec import structs
from shapely import Polygon

from thinkblox.errors import InputError
from thinkblox.importing.document import Document, plain
from thinkblox.importing.draft import Hole, RoomOutline
from thinkblox.scene.room import Opening, Room, Wall
from thinkblox.value import Vec2, Vec3

IN_WALL = 0.15
"""How far a hole's ends may be from the line of the wall that it is in [m]."""
LEAST = 0.05
"""Smallest width and height of an opening [m]."""


def origin_of(outline: RoomOutline) -> Vec3:
    """By how much a layout is shifted so that its floor's bounding box has its lowest corner at the origin [m]."""
    x, y = (min((corner[axis] for corner in outline.corners), default=0.0) for axis in (0, 1))
    return (-x, -y, -outline.level)


def room_of(document: Document, outline: RoomOutline, *, height: float) -> tuple[Room, tuple[str, ...]]:
    """The room, its floor at the origin, and what to say about it.

    Args:
        document: the file it stands in.
        outline: what the file says.
        height: of the room [m].

    Raises:
        InputError: the floor is not one that a room can have; names file and JSON path.
    """
    corners, notes = _counter_clockwise(_open(outline.corners))
    if len(corners) < 3:
        document.fail(outline.at, f"a floor of {len(corners)} corners; a room has at least 3")
    if not 1.5 <= height <= 50.0:
        document.fail(outline.at, f"a room {height:g} m high; it must be 1.5 to 50 m")
    dx, dy, _ = origin_of(outline)
    try:
        bare = Room(floor=tuple((x + dx, y + dy) for x, y in corners), height=height)
    except InputError as error:
        document.fail(outline.at, str(error))
    openings: list[Opening] = []
    for hole in outline.holes:
        problem = _added(bare, openings, hole, (dx, dy))
        if problem:
            notes.append(f"The {hole.kind} {plain(hole.name)!r} was left out: {problem}.")
    return structs.replace(bare, openings=tuple(openings)), tuple(notes)


def _open(corners: tuple[Vec2, ...]) -> tuple[Vec2, ...]:
    """The corners without a last one that repeats the first."""
    if len(corners) > 1 and math.dist(corners[0], corners[-1]) < 1e-9:
        return corners[:-1]
    return corners


def _counter_clockwise(corners: tuple[Vec2, ...]) -> tuple[tuple[Vec2, ...], list[str]]:
    if len(corners) < 3 or Polygon(corners).exterior.is_ccw:
        return corners, []
    return (corners[0], *corners[:0:-1]), ["The floor's corners run clockwise; they were turned round."]


def _added(room: Room, openings: list[Opening], hole: Hole, shift: Vec2) -> str:
    """Add a hole to the openings; the reason why it was not, or nothing."""
    ends = [(x + shift[0], y + shift[1]) for x, y in hole.ends]
    best = min(range(len(room.walls)), key=lambda index: _off(room.walls[index], ends))
    wall = room.walls[best]
    if _off(wall, ends) > IN_WALL:
        return "it is in no wall of the room"
    start, end = sorted(min(max(wall.coordinates(point)[0], 0.0), wall.length) for point in ends)
    low, high = max(0.0, hole.low), min(hole.high, room.height)
    if end - start < LEAST or high - low < LEAST:
        return "what of it is in the wall is no opening"
    opening = Opening(
        id=_id(hole, {each.id for each in openings}),
        kind=hole.kind,
        wall=best,
        offset=start,
        width=end - start,
        height=high - low,
        sill=low,
    )
    try:
        structs.replace(room, openings=(*openings, opening))
    except InputError as error:
        return str(error)
    openings.append(opening)
    return ""


def _off(wall: Wall, ends: list[Vec2]) -> float:
    """How far the ends are from a wall: off its line, and by how much their middle is past its ends."""
    places = [wall.coordinates(point) for point in ends]
    middle = sum(along for along, _ in places) / len(places)
    return max(abs(inward) for _, inward in places) + max(0.0, -middle, middle - wall.length)


def _id(hole: Hole, taken: set[str]) -> str:
    number = 1
    while f"{hole.kind}_{number}" in taken:
        number += 1
    return re.sub(r"\W", "_", f"{hole.kind}_{number}")
