"""What can be said of a pose, in the phrases of the step language: enough to find the place again."""

from thinkblox.phrases import Constraint
from thinkblox.scene.agreement import wall_gap
from thinkblox.scene.arrangement import Arrangement, Known
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.value import Vec2


def place_words(scene: Arrangement, asset: Known, placement: Placement) -> tuple[Constraint, ...]:
    """What a placement rests on or hangs at, where it is on that, and how it is turned."""
    return (*_where(scene, asset, placement), turned(placement.yaw))


def _where(scene: Arrangement, asset: Known, placement: Placement) -> tuple[Constraint, ...]:
    x, y, z = placement.position
    if asset.mount == "wall":
        wall = placement.support
        height = Constraint(kind="above", anchors=("floor",), values=(round(z, 3),))
        return (Constraint(kind="against", anchors=(wall,)), height, *pose_words(scene.room, placement, beyond=(wall,)))
    at = Constraint(kind="at", values=(round(x, 3), round(y, 3)))
    if placement.support in scene:
        ahead, aside = scene[placement.support].to_local((x, y))
        offset = Constraint(kind="offset", anchors=(placement.support,), values=(round(ahead, 3), round(aside, 3)))
        return (Constraint(kind="on", anchors=(placement.support,)), offset)
    return (at,) if z < 0.001 else (at, Constraint(kind="above", anchors=("floor",), values=(round(z, 3),)))


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
