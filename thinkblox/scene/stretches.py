"""The stretches of a wall that furniture can stand along: between its corners, doors and low windows."""

from collections.abc import Iterator

from thinkblox.scene.room import Opening, Room, Wall

Stretch = tuple[float, float]
"""Where along a wall it begins and ends [m]."""
BESIDE_DOOR = 0.04
"""Left between furniture and the frame or the swing of a door [m]."""
ABOVE_SILL = 0.2
"""How far above a sill furniture may reach before a window [m]."""
_TOUCH = 0.001


def stretches(room: Room, number: int, *, depth: float, height: float) -> list[Stretch]:
    """The free stretches of wall `number` for furniture of that depth and height [m], in order along it."""
    wall = room.walls[number]
    taken = sorted(_taken(room, wall, number, depth, height))
    found, start = [], 0.0
    for low, high in taken:
        if low - start > _TOUCH:
            found.append((start, low))
        start = max(start, high)
    if wall.length - start > _TOUCH:
        found.append((start, wall.length))
    return found


def is_inner_corner(room: Room, number: int) -> bool:
    """Whether the walls `number` and the next meet at a right angle that furniture can stand in."""
    one, other = room.walls[number].along, room.walls[(number + 1) % len(room.walls)].along
    return one[0] * other[1] - one[1] * other[0] > 1.0 - _TOUCH


def _taken(room: Room, wall: Wall, number: int, depth: float, height: float) -> Iterator[Stretch]:
    """What doors, those of other walls that swing there too, and windows take of a wall."""
    for opening in room.openings:
        if opening.kind == "door":
            low, high, near = _swing(room, opening, wall)
            aside = BESIDE_DOOR if opening.wall == number else 0.0
            if near < depth - _TOUCH and high > 0.0 and low < wall.length:
                yield max(0.0, low - aside), min(wall.length, high + aside)
        elif opening.wall == number and height > opening.sill + ABOVE_SILL:
            yield opening.offset, opening.offset + opening.width


def _swing(room: Room, opening: Opening, wall: Wall) -> tuple[float, float, float]:
    """Where the floor that a door needs begins and ends along a wall, and how near it comes to that [m]."""
    own = room.walls[opening.wall]
    ends = (opening.offset, opening.offset + opening.width)
    seen = [wall.coordinates(own.point(along, inward)) for along in ends for inward in (0.0, opening.swept)]
    return min(x for x, _ in seen), max(x for x, _ in seen), min(y for _, y in seen)
