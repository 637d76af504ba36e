"""Which parts of a room a brief means where it leaves that open: one wall, the opposite one, a wall that stays free."""

from thinkblox.brief import Brief
from thinkblox.planning.walls import COMPASS, SIDES, wall_meant
from thinkblox.scene.landmarks import walls
from thinkblox.scene.room import Room, Wall

ONE, OPPOSITE = "one_wall", "opposite_wall"
_ANY = ("wall", ONE, OPPOSITE)


def chosen_walls(brief: Brief, room: Room) -> dict[str, str]:
    """The walls of the compass that "one_wall" and "opposite_wall" mean; empty where a brief names neither."""
    named = {anchor for relation in brief.relations for anchor in relation.anchors}
    if named.isdisjoint((ONE, OPPOSITE)):
        return {}
    taken = {wall_meant(name, room) for name in (*named, *brief.free)}
    pairs = [(side, COMPASS[(n + 2) % 4]) for n, side in enumerate(COMPASS)]
    one, opposite = max(pairs, key=lambda pair: (-_taken(pair, taken), _usable(room, pair, both=OPPOSITE in named)))
    return {ONE: one, OPPOSITE: opposite}


def _taken(sides: tuple[str, str], taken: set[str]) -> int:
    return sum(side in taken for side in sides)


def _usable(room: Room, sides: tuple[str, str], *, both: bool) -> float:
    """Length of wall without openings on the first side, or on the shorter of both [m]."""
    lengths = [sum(_solid(room, wall) for wall in walls(room, side)) for side in sides]
    return min(lengths) if both else lengths[0]


def _solid(room: Room, wall: Wall) -> float:
    number = room.walls.index(wall)
    return wall.length - sum(o.width for o in room.openings if o.wall == number)


def free_parts(brief: Brief, room: Room) -> tuple[str, ...]:
    """The parts that a brief wants free, each wall by its name in the room."""
    chosen = chosen_walls(brief, room)
    named = {wall_meant(a, room) for relation in brief.relations for a in relation.anchors} | set(chosen.values())
    found: list[str] = []
    for place in brief.free:
        if place in _ANY:
            spare = [wall for wall in room.walls if wall.name not in found] or list(room.walls)
            found.append(max(spare, key=lambda wall: _spare(room, wall, named)).name)
        else:
            found.append(wall_meant(place, room) if place in SIDES else place)
    return tuple(found)


def _spare(room: Room, wall: Wall, named: set[str]) -> tuple[bool, bool, bool, float]:
    """How well a wall can stay empty: not spoken for, without doors and windows, long."""
    number = room.walls.index(wall)
    kinds = {o.kind for o in room.openings if o.wall == number}
    side = "_".join(wall.name.split("_")[:2])
    return (side not in named, "door" not in kinds, "window" not in kinds, wall.length)
