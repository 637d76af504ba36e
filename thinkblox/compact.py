"""An observation in few words: whole centimetres and degrees, one line for each thing; for models that are small."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from thinkblox.scene.asset import Surface
from thinkblox.scene.free_spots import free_spots
from thinkblox.scene.placement import Placement
from thinkblox.value import Vec3

if TYPE_CHECKING:
    from thinkblox.observe import Observation

_SPOTS = 3
_CARRIERS = 4
"""Things of which the free spots are named, at most."""


def compact_text(observation: "Observation") -> str:
    """The room, what stands in it, what is to be placed and what is wanted of it.

    Lengths in centimetres, angles in degrees, heights of surfaces in metres. "room": the floor's corners and the
    height; openings: wall, offset along it, width, sill; objects: x y z, yaw, depth width height, what carries them;
    "free": a surface, with spots x y radius.
    """
    return "\n".join(_lines(observation))


def _lines(seen: "Observation") -> Iterator[str]:
    room = seen.layout.room
    corners = " ".join(f"{_cm(x)} {_cm(y)}" for x, y in room.floor)
    yield f"room {corners} high {_cm(room.height)}"
    for o in room.openings:
        yield f"{o.kind} {room.walls[o.wall].name} {_cm(o.offset)} {_cm(o.width)} {_cm(o.sill)}"
    for p in seen.layout.placements:
        yield f"{p.id} {_cms(p.position)} {round(p.yaw) % 360} {_cms(p.size)} on {p.support}"
    yield from _free(seen)
    target, asset = seen.target, seen.asset
    yield f"place {target.id} {_cms(asset.size)} {asset.mount} {asset.front}"
    wanted = [f"{tie.kind} {' '.join(tie.anchors)}{_share(tie.index, tie.count)}".strip() for tie in target.ties]
    if wanted:
        yield "wanted " + ", ".join(wanted)
    yield from (f"measured {line}" for line in seen.feedback[:1])


def _free(seen: "Observation") -> Iterator[str]:
    """Free spots of what carries things: of what is wanted, else of the first few, for what stands on surfaces."""
    if seen.asset.mount != "surface":
        return
    wanted = [a for tie in seen.target.ties for a in tie.anchors if a in seen.layout]
    carriers = [seen.layout[id] for id in wanted] or [p for p in seen.layout.placements if _surfaces(seen, p)]
    for placement in carriers[:_CARRIERS]:
        for surface in _surfaces(seen, placement):
            spots = free_spots(seen.layout, placement, surface, count=_SPOTS)
            height = round(placement.position[2] + surface.position[2], 3)
            said = " ".join(f"{_cm(s.position[0])} {_cm(s.position[1])} {_cm(s.clear)}" for s in spots)
            yield f"free {placement.id} at {height} {said}".rstrip()


def _surfaces(seen: "Observation", placement: Placement) -> tuple[Surface, ...]:
    return seen.layout.asset_of(placement).surfaces


def _share(index: int, count: int) -> str:
    return f" {index + 1}/{count}" if count > 1 else ""


def _cm(length: float) -> int:
    return round(length * 100)


def _cms(lengths: Vec3) -> str:
    return " ".join(str(_cm(length)) for length in lengths)
