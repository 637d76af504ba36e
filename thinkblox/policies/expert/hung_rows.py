"""Things that hang in a row on one wall: a wall of mirrors, or a mirror before each of several seats."""

from collections.abc import Iterator
from typing import NamedTuple

from thinkblox.policies.expert.situation import Situation
from thinkblox.policies.expert.sizing import scaled, shares_of
from thinkblox.scene.rectangles import Rects, overlap_depth
from thinkblox.scene.room import Wall
from thinkblox.value import Vec3

BETWEEN = 0.05
"""Between things that hang side by side [m]."""
HIGH = 1.2
"""What is higher is hung edge to edge where several are [m]."""
ELBOWS, ROOM_BEFORE = 0.5, 1.6
"""Seats before what hangs stand so far apart, and take so much floor before the wall [m]."""
SHIFTS = (0.0, 0.3, -0.3, 0.6, -0.6, 0.9, -0.9, 1.2, -1.2, 1.6, -1.6, 2.0, -2.0, 2.5, -2.5)
"""How far a row is from the middle of its wall [m]."""
WORTH, BROKEN, SMALLER = 1.0, 0.6, 0.5
"""What hanging in a row is worth; what each place costs that is at a window or a door; what being smaller costs."""


class RowPlace(NamedTuple):
    """Where along a wall something hangs [m], what it costs, and its size [m] where that is not its own."""

    along: float
    cost: float
    size: Vec3 | None


def places(situation: Situation, wall: Wall, z: float) -> Iterator[RowPlace]:
    """Beside those of its like that hang on the wall; for the first, where the whole row hangs about its middle.

    None where its like need not hang in a row.
    """
    target = situation.target
    seats = [situation.kind(t).size[1] for t in situation.followers if any(tie.kind == "in_front_of" for tie in t.ties)]
    edge_to_edge = situation.size[2] > HIGH and any(
        tie.kind in ("against_wall", "on") and tie.asked for tie in target.ties
    )
    if target.count < 2 or not (seats or edge_to_edge):
        return
    hung = [p for p in situation.siblings if wall.yaw == p.yaw and wall.coordinates(p.position[:2])[1] <= p.size[0]]
    if bool(hung) != bool(situation.siblings):
        return
    sizes = situation.observation.sizes
    for share in (1.0,) if any(target.size) else shares_of(situation.size, sizes):
        size = None if share == 1.0 else scaled(situation.size, share)
        width = (size or situation.size)[1]
        pitch = max(width + BETWEEN, *(seat + ELBOWS for seat in seats), 0.0)
        if hung:
            alongs = [wall.coordinates(p.position[:2])[0] for p in hung]
            spots = [(min(alongs) - pitch, 0.0), (max(alongs) + pitch, 0.0)]
        else:
            first = wall.length / 2 - (target.count - 1) / 2 * pitch
            spots = [(first + shift, 0.2 * abs(shift)) for shift in SHIFTS]
        for along, cost in spots:
            row = [along] if hung else [along + k * pitch for k in range(target.count)]
            if width / 2 < row[0] and row[-1] < wall.length - width / 2:
                broken = _broken(situation, wall, row, width, z) + _before_doors(situation, wall, row, seats)
                yield RowPlace(along, cost + BROKEN * broken + SMALLER * (1.0 - share) - WORTH, size)


def _broken(situation: Situation, wall: Wall, row: list[float], width: float, z: float) -> int:
    """How many of a row would hang over a window or a door."""
    number = situation.room.walls.index(wall)
    openings = [o for o in situation.room.openings if o.wall == number and o.sill < z + situation.size[2]]
    return sum(any(o.offset - width / 2 < at < o.offset + o.width + width / 2 for o in openings) for at in row)


def _before_doors(situation: Situation, wall: Wall, row: list[float], seats: list[float]) -> int:
    """How many of a row would have their seats where a door swings."""
    if not seats or not len(situation.door_zones):
        return 0
    size = (ROOM_BEFORE, max(seats))
    rects = Rects.of([(wall.point(at, ROOM_BEFORE / 2), size, wall.yaw, 0.0, 1.0) for at in row])
    return int((overlap_depth(rects, situation.door_zones) > 0.0).any(axis=1).sum())
