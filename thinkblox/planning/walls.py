"""Left, right, far and near walls, as seen by somebody who comes in by the door, and the corners between walls."""

from collections.abc import Iterator, Mapping

from msgspec.structs import replace

from thinkblox.assets import kind_of
from thinkblox.brief import Brief, Relation
from thinkblox.scene.room import Room

COMPASS = ("north_wall", "east_wall", "south_wall", "west_wall")
"""Clockwise, as on a plan."""
SIDES = ("far_wall", "right_wall", "near_wall", "left_wall")
"""Clockwise too, from the wall opposite the door."""
_FAR, _NEAR = "far_wall", "near_wall"


def wall_meant(name: str, room: Room) -> str:
    """The wall of the compass that a name means in a room; other names stay as they are.

    A room without a door is looked at from the south, as in its pictures.
    """
    if name not in SIDES:
        return name
    door = next((o for o in room.openings if o.kind == "door"), None)
    near = "_".join(room.walls[door.wall].name.split("_")[:2]) if door else "south_wall"
    far = COMPASS.index(near) + 2 if near in COMPASS else 0
    return COMPASS[(far + SIDES.index(name)) % 4]


def speaks_of_sides(brief: Brief) -> bool:
    """Whether a brief names a wall by how it is seen from the door."""
    named = {anchor for relation in brief.relations for anchor in relation.anchors} | {o.wall for o in brief.openings}
    return not named.isdisjoint(SIDES)


def _hangs(brief: Brief, key: str) -> bool:
    return kind_of(brief.request(key).category).mount == "wall"


def _is_board(brief: Brief, key: str) -> bool:
    return kind_of(brief.request(key).category).is_in("boards")


def relations_in(brief: Brief, room: Room, chosen: Mapping[str, str]) -> Iterator[Relation]:
    """The relations of a brief in a room, those that are asked for first; a named corner is one near its walls.

    Args:
        brief: where they are from.
        room: where they are to hold.
        chosen: walls of the compass by the names that leave them open.
    """
    back_taken = any(r.asked and _FAR in r.anchors and not _hangs(brief, r.subject) for r in brief.relations)
    for relation in sorted(brief.relations, key=lambda r: not r.asked):
        if back_taken and not relation.asked and relation.kind == "against_wall" and _is_board(brief, relation.subject):
            relation = replace(relation, anchors=(_NEAR,))  # What is at the back is behind those who look at the board.
        meant = replace(relation, anchors=tuple(wall_meant(chosen.get(a, a), room) for a in relation.anchors))
        walls = [anchor for anchor in meant.anchors if anchor in COMPASS]
        if relation.kind == "in_corner" and walls and not relation.negated:
            yield replace(meant, anchors=("corner",))
            for wall in walls:
                yield replace(meant, kind="near", anchors=(wall,))
        else:
            yield meant
