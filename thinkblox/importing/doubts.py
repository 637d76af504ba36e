"""What speaks for it that a layout means other units or axes than its format has, in sentences."""

import math
from collections.abc import Callable, Sequence
from statistics import median

from shapely import Point, Polygon

from thinkblox.importing.body import ItemBody
from thinkblox.importing.document import plain
from thinkblox.importing.draft import Item
from thinkblox.importing.usual import usual_size
from thinkblox.scene.room import Room
from thinkblox.value import Vec3

NEAR = 0.3
"""What is no further outside than this may have been meant to be in the room [m]."""
ON_FLOOR = 0.05
"""How far the base of what stands on the floor may be from it [m]."""
HALF, MOST = 0.5, 0.8
"""Less than the one of all things is in the room as it is said, the other at least as it may have been meant."""
SHOWN, SHORT = 3, 40
"""How many names are told, and how much of each."""
CLOSE = 0.006
"""How far numbers may be from quarter turns in radians, which are written with two digits at least [degrees]."""
ODD = 20.0
"""How many times as large or small as usual things are when their sizes are in another unit."""
_UNITS = (("centimetres", 0.01), ("millimetres", 0.001), ("inches", 0.0254), ("feet", 0.3048))


def doubts(room: Room, items: Sequence[Item], bodies: Sequence[ItemBody], shift: Vec3) -> tuple[str, ...]:
    """Notes on units and axes that the numbers speak for.

    Args:
        room: as it was read.
        items: in the layout's own frame.
        bodies: theirs, in the same order.
        shift: from the layout's frame to the room's [m].
    """
    if not items:
        return ("The layout has nothing in it, so there is nothing that could fail.",)
    floor = Polygon(room.floor).buffer(NEAR)

    def within(meant: Callable[[Vec3], Vec3]) -> int:
        """How many things are in the room when their positions are read so."""
        places = [_shifted(meant(item.position), shift) for item in items]
        return sum(floor.contains(Point(x, y)) and -NEAR <= z <= room.height + NEAR for x, y, z in places)

    return (
        *_positions(len(items), within),
        *_axes(items, bodies, shift, within),
        *_sizes(items, bodies),
        *_angles(bodies),
    )


def _positions(count: int, within: Callable[[Callable[[Vec3], Vec3]], int]) -> list[str]:
    now = within(lambda p: p)
    if now >= HALF * count:
        return []
    for unit, factor in _UNITS:
        meant = within(lambda p, factor=factor: (p[0] * factor, p[1] * factor, p[2] * factor))  # type: ignore[misc]
        if meant >= MOST * count and meant > now:
            told = f"{count - now} of {count} objects are outside the room; in it would be {meant}"
            return [f"{told}, were their positions in {unit}: they are read in metres."]
    return []


def _axes(
    items: Sequence[Item], bodies: Sequence[ItemBody], shift: Vec3, within: Callable[[Callable[[Vec3], Vec3]], int]
) -> list[str]:
    """Whether nothing stands on the floor, and most would if the second number of positions were the height."""
    heights = [_shifted(item.position, shift)[2] - body.position[2] for item, body in zip(items, bodies, strict=True)]
    if any(abs(body.position[2]) <= ON_FLOOR for body in bodies):
        return []
    swapped = [_shifted(_swap(item.position), shift)[2] - up for item, up in zip(items, heights, strict=True)]
    standing = sum(abs(base) <= ON_FLOOR for base in swapped)
    if standing < max(2.0, HALF * len(items)) or within(_swap) < MOST * len(items):
        return []
    told = f"No object stands on the floor; were y and z of the positions swapped, {standing} of {len(items)} would"
    return [f"{told}: is another axis up than the format says?"]


def _sizes(items: Sequence[Item], bodies: Sequence[ItemBody]) -> list[str]:
    """What is far larger than such things are, and whether all is far smaller."""
    ratios = {
        plain(item.name)[:SHORT]: max(body.size) / max(usual)
        for item, body in zip(items, bodies, strict=True)
        if (usual := usual_size(item.kind)) is not None
    }
    large = [name for name, ratio in ratios.items() if ratio >= ODD]
    if large:
        more = f" and {len(large) - SHOWN} more" if len(large) > SHOWN else ""
        return [
            f"More than {ODD:g} times as large as usual: {', '.join(large[:SHOWN])}{more}; sizes are read in metres."
        ]
    if ratios and median(ratios.values()) <= 1 / ODD:
        return [f"Most objects are less than 1/{ODD:g} as large as usual; sizes are read in metres."]
    return []


def _angles(bodies: Sequence[ItemBody]) -> list[str]:
    """Whether every turn is, as degrees, what quarter turns are in radians."""
    turns = [abs((body.yaw + 45.0) % 90.0 - 45.0) for body in bodies]
    odd = [turn for turn in turns if turn > CLOSE]
    if not odd or any(min(abs(turn - quarters * math.pi / 2) for quarters in (1, 2, 3, 4)) > CLOSE for turn in odd):
        return []
    return [f"Objects are turned by {odd[0]:.4g} degrees: angles are read in degrees; are these in radians?"]


def _swap(position: Vec3) -> Vec3:
    return (position[0], position[2], position[1])


def _shifted(position: Vec3, shift: Vec3) -> Vec3:
    return (position[0] + shift[0], position[1] + shift[1], position[2] + shift[2])
