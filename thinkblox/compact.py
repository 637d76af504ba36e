"""An observation in few words, for models that are small: metres and degrees, one line for each thing.

Numbers are written as an answer writes them, so that they can be copied: 2.4, 0.05, 90.0.
"""

from collections.abc import Iterator
from itertools import groupby
from typing import TYPE_CHECKING

from thinkblox.free_places import Stretch, free_places
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room

if TYPE_CHECKING:
    from thinkblox.observe import Observation

IT = "it_1"
"""What the object to place is called in these words, and in the answers to them."""
THINGS = 12
"""Things that are named besides those that something is wanted of, the last ones; of the others the number."""


def compact_text(observation: "Observation") -> str:
    """The room, what stands in it, what is to be placed, what is wanted of it, and where there is space for it.

    "room": the floor's width and depth, or its corners, and the height; openings: wall, offset along it, width; things:
    x y, yaw, depth width; "free": the wall behind it, what it is on, or a side of what it is by, its yaw, and the ends
    of lines on which its centre may be (`thinkblox.free_places`); "up": the height above the floor, where it has one.
    """
    return "\n".join(_lines(observation))


def named(text: object, id: str) -> object:
    """An answer to compact words with the object's own id; anything else as it is."""
    return text.replace(f'"{IT}"', f'"{id}"') if isinstance(text, str) else text


def number(value: float, digits: int = 2) -> str:
    """A number as answers have it: no more decimals than needed, at least one."""
    return str(round(value, digits) + 0.0)


def stretch_words(stretch: Stretch) -> str:
    """The ends of a stretch, or the one place that it is."""
    start, end = (f"{number(x)} {number(y)}" for x, y, _ in (stretch.start, stretch.end))
    return start if start == end else f"{start} to {end}"


def _lines(seen: "Observation") -> Iterator[str]:
    room = seen.layout.room
    yield f"room {_floor(room)} high {number(room.height)}"
    for o in room.openings:
        yield f"{o.kind} {room.walls[o.wall].name} {number(o.offset)} {number(o.width)}"
    yield from _things(seen)
    target, asset = seen.target, seen.asset
    yield f'place {target.category} "{IT}" {_numbers(asset.size)} {asset.mount} {asset.front}'
    wanted = [f"{tie.kind} {' '.join(tie.anchors)}{_share(tie.index, tie.count)}".strip() for tie in target.ties]
    if wanted:
        yield "wanted " + ", ".join(wanted)
    stretches = free_places(seen.layout, target, asset)
    for (by, yaw, z), group in groupby(stretches, key=lambda s: (s.by, s.yaw, s.start[2])):
        yield f"free {by} {number(yaw)}{_up(z)} : {', '.join(map(stretch_words, group))}"
    yield from (f"measured {line}" for line in seen.feedback[:1])


def _things(seen: "Observation") -> Iterator[str]:
    wanted = {anchor for tie in seen.target.ties for anchor in tie.anchors}
    placed = seen.layout.placements
    last = {p.id for p in placed[-THINGS:]} | wanted
    kept = [p for p in placed if p.id in last]
    if len(placed) > len(kept):
        yield f"and {len(placed) - len(kept)} more"
    for p in kept:
        yield f"{p.id} {_where(p)}"


def _where(p: Placement) -> str:
    x, y, z = p.position
    return f"{number(x)} {number(y)} {number(p.yaw % 360)} {_numbers(p.size[:2])}{_up(z)}"


def _up(z: float) -> str:
    return f" up {number(z, 3)}" if z > 0.0 else ""


def _floor(room: Room) -> str:
    """Width and depth of a rectangle, the corners of another floor."""
    if len(room.floor) == 4 and room.polygon.equals(room.polygon.envelope):
        return _numbers(room.extent)
    return " ".join(_numbers(corner) for corner in room.floor)


def _share(index: int, count: int) -> str:
    return f" {index + 1}/{count}" if count > 1 else ""


def _numbers(lengths: tuple[float, ...]) -> str:
    return " ".join(number(length) for length in lengths)
