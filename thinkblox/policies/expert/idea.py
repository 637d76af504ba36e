"""One idea of where an object could go, and the words that say where it is."""

from dataclasses import dataclass

from thinkblox.phrases import Constraint
from thinkblox.scene.agreement import wall_gap
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.value import Vec2, Vec3

WALL_GAP = 0.02
"""Left free between furniture and the wall behind it, for the skirting board [m]."""


@dataclass(frozen=True)
class Idea:
    """A pose, the words that led to it, and what speaks against it from the start.

    Attributes:
        words: what the reasoning says about the pose, in the phrases of the step language.
        against: walls it stands or hangs against; the distance from the next wall is then said as well.
        why: the reason, as a clause ("its head belongs to a wall").
        cost: how far it is from the best of its kind; about 1 is a clear drawback.
        ignore: ids that it may overlap as seen from above (the table a seat is tucked under).
        size: another size than the asset's, where the idea is to fit it.
    """

    position: Vec3
    yaw: float
    words: tuple[Constraint, ...]
    why: str
    cost: float = 0.0
    ignore: tuple[str, ...] = ()
    size: Vec3 | None = None
    against: tuple[str, ...] = ()


def pose_words(room: Room, placement: Placement, *, beyond: tuple[str, ...] = ()) -> tuple[Constraint, ...]:
    """Distances from the two nearest walls at right angles, else the coordinates: enough to find the place again."""
    gaps = sorted((wall_gap(wall, placement), wall.name) for wall in room.walls if wall.name not in beyond)
    gaps = [(gap, name) for gap, name in gaps if gap >= 0.0]
    for gap, name in gaps:
        inward = room.wall(name).inward
        if all(abs(_dot(inward, room.wall(other).inward)) < 0.01 for other in beyond):
            return (Constraint(kind="from_wall", anchors=(name,), values=(round(gap, 3),)),)
    return (Constraint(kind="at", values=(round(placement.position[0], 3), round(placement.position[1], 3))),)


def _dot(a: Vec2, b: Vec2) -> float:
    return a[0] * b[0] + a[1] * b[1]


def turned(yaw: float) -> Constraint:
    """The words for a yaw."""
    return Constraint(kind="turned", values=(round(yaw % 360.0, 2) % 360.0,))
