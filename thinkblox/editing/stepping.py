"""Things that are moved by so much in a direction."""

import math
from collections.abc import Iterator

from thinkblox.editing.goals import (
    Along,
    At,
    Goal,
)
from thinkblox.editing.orders import Order
from thinkblox.editing.rows import looks_to
from thinkblox.editing.spots import (
    Pose,
    shifted,
)
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.scene.placement import Placement
from thinkblox.value import Vec3

SLIGHT = 0.45
"""How far something is moved at most that is moved a bit [m]."""
STEPS = (0.3, 0.5, 0.2, 0.4, 0.7, 1.0, 0.1, 0.05)
"""How far something is moved where nobody says it [m]."""
SLIGHT_STEPS = (0.15, 0.1, 0.2, 0.05, 0.25)
"""The same for "a bit" [m]."""
_FAR_OFF = ("to the front", "to the back")
"""What is no step, but the other end of the room, which nothing says of which."""
_OF_ROW = {"forward": 0.0, "left": 90.0, "back": 180.0, "right": 270.0}
"""By how much a direction of a row is turned against where it looks to [degrees]."""


def ways_of(placement: Placement) -> dict[str, Vec3]:
    """The unit vectors of directions: its own left, right, front and back, up and down, and the compass."""
    (fx, fy), (lx, ly) = placement.front, placement.left
    return {
        "left": (lx, ly, 0.0),
        "right": (-lx, -ly, 0.0),
        "forward": (fx, fy, 0.0),
        "back": (-fx, -fy, 0.0),
        "up": (0.0, 0.0, 1.0),
        "down": (0.0, 0.0, -1.0),
        "north": (0.0, 1.0, 0.0),
        "south": (0.0, -1.0, 0.0),
        "east": (1.0, 0.0, 0.0),
        "west": (-1.0, 0.0, 0.0),
    }


def way_of(work: Work, order: Order, placement: Placement) -> Vec3:
    """The unit vector of the direction of an order for one thing; of what is of a row by where it looks to."""
    if order.direction in _OF_ROW and any(phrase.noun.rows for phrase in order.things):
        way = math.radians(looks_to(work.scene, placement) + _OF_ROW[order.direction])
        return (math.cos(way), math.sin(way), 0.0)
    return ways_of(placement)[order.direction]


def by_step(work: Work, order: Order, placement: Placement) -> tuple[Iterator[Pose], list[Goal]]:
    """In a direction: its own left, right, front and back; up and down; or by the compass."""
    way = way_of(work, order, placement)
    if order.direction in ("up", "down") and work.asset_of(placement.id).free:
        raise InputError(
            f"{placement.id} stands on {placement.support}; only what hangs can be moved {order.direction}"
        )
    if not (order.lengths or order.slight) and any(words in order.text.lower() for words in _FAR_OFF):
        raise InputError(f"'{order.text}': how far, or to which wall? Say '30 cm forward', or 'to the north wall'")
    if not order.lengths:
        return iter(
            [(shifted(placement, _scaled(way, s)), placement.yaw) for s in (SLIGHT_STEPS if order.slight else STEPS)]
        ), [Along(way)]
    goal = shifted(placement, _scaled(way, order.lengths[0][0]))
    return iter([(goal, placement.yaw)]), [At(goal[:2], height=goal[2] if way[2] else None)]


def _scaled(way: Vec3, length: float) -> Vec3:
    return (way[0] * length, way[1] * length, way[2] * length)
