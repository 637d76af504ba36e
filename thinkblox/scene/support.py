"""What things rest on or hang from, always read off the geometry: a picture moved to another wall hangs on that one."""

import math
from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING

from msgspec import structs

from thinkblox.errors import InputError
from thinkblox.scene.arrangement import Arrangement, Known
from thinkblox.scene.placement import Placement
from thinkblox.value import Vec2, Vec3

if TYPE_CHECKING:
    from thinkblox.scene.room import Room

ON_FLOOR = 0.02
"""A base lower than this stands on the floor [m]."""
LEVEL = 0.001
"""How near the bottom of what it lies in such a base is [m]."""


def placed_at(scene: Arrangement, asset: Known, *, id: str, position: Vec3, yaw: float) -> Placement:
    """The asset at a pose, with the support that lies under it or the wall it hangs on."""
    if len(position) != 3:
        raise InputError(f"{id} cannot be put at {position!r}: a position is three numbers [m]")
    placement = Placement(
        id=id,
        category=asset.category,
        asset=asset.id,
        position=(float(position[0]), float(position[1]), float(position[2])),
        yaw=(yaw % 360.0) % 360.0,
        size=asset.size,
    )
    return structs.replace(placement, support=support_of(scene, asset, placement))


def support_of(scene: Arrangement, asset: Known, placement: Placement) -> str:
    """Name the support: "floor", "ceiling", a wall, or the id whose surface is nearest below the middle of the base."""
    if asset.mount == "ceiling":
        return "ceiling"
    if asset.mount == "wall":
        return _nearest_wall(scene, placement)
    if placement.position[2] < ON_FLOOR:
        return (_holder(scene, placement) if placement.position[2] > 0.0 else None) or "floor"
    return _carrier(scene, placement) or "floor"


class Supported(tuple[Placement, ...]):
    """Placements with supports that were derived for one room and its assets, save for those of `changed`.

    It lets a scene that differs from another in one object derive anew only what that concerns.
    """

    room: "Room"
    assets: Mapping[str, Known]
    changed: Collection[str]

    @classmethod
    def of(
        cls,
        placements: Sequence[Placement],
        room: "Room",
        assets: Mapping[str, Known],
        changed: Collection[str] = (),
    ) -> "Supported":
        """Placements of which those called as in `changed` came, went or moved."""
        made = cls(placements)
        made.room, made.assets, made.changed = room, assets, changed
        return made


def supported(scene: Arrangement, room: "Room", assets: Mapping[str, Known]) -> Supported:
    """The placements of a scene, each with the support that it has by geometry."""
    old = scene.placements
    if isinstance(old, Supported) and old.room is room and old.assets is assets:
        if not old.changed:
            return old
        new = [p for p in old if p.id in old.changed]
        found = [_derived(scene, p) if _concerned(p, old.changed, new) else p for p in old]
    else:
        found = [_derived(scene, p) for p in old]
    return Supported.of(found, room, assets)


def _concerned(placement: Placement, changed: Collection[str], new: Sequence[Placement]) -> bool:
    return placement.id in changed or placement.support in changed or any(_is_under(p, placement) for p in new)


def _derived(scene: Arrangement, placement: Placement) -> Placement:
    support = support_of(scene, scene.asset_of(placement), placement)
    return placement if support == placement.support else structs.replace(placement, support=support)


def _nearest_wall(scene: Arrangement, placement: Placement) -> str:
    back = placement.to_room((-placement.size[0] / 2, 0.0))

    def badness(index: int) -> float:
        wall = scene.room.walls[index]
        along, inward = wall.coordinates(back)
        return abs(inward) + max(0.0, -along, along - wall.length)

    return scene.room.walls[min(range(len(scene.room.walls)), key=badness)].name


def _carrier(scene: Arrangement, placement: Placement) -> str | None:
    """Who has a surface right under the middle of the base, or failing that the nearest height below it."""
    found: list[tuple[float, str]] = []
    for other in scene.placements:
        if other.id == placement.id or not _is_under(other, placement) or not scene.asset_of(other).collides:
            continue
        heights = [other.position[2] + s.position[2] for s in scene.asset_of(other).surfaces] or [other.top]
        found += [(abs(placement.position[2] - h), other.id) for h in heights if h < placement.position[2] + ON_FLOOR]
    nearest, id = min(found, default=(math.inf, ""))
    return id if nearest < math.inf else None


def _holder(scene: Arrangement, placement: Placement) -> str | None:
    """Who has the bottom of a hollow right under the middle of what is next to the floor, as a box and a basket have.

    It is the smallest of those, where one stands in another.
    """
    over = (p for p in scene.placements if p.id != placement.id and _is_under(p, placement))
    found = [
        (p.size[0] * p.size[1], p.id)
        for p in over
        if any(
            s.within and abs(p.position[2] + s.position[2] - placement.position[2]) <= LEVEL
            for s in scene.asset_of(p).surfaces
        )
    ]
    return min(found, default=(0.0, ""))[1] or None


def _is_under(other: Placement, placement: Placement) -> bool:
    """Whether the middle of a placement is over another's footprint."""
    (x, y, z), (ox, oy, oz) = placement.position, other.position
    half_x, half_y = other.size[0] / 2, other.size[1] / 2
    reach = half_x + half_y
    if abs(x - ox) > reach or abs(y - oy) > reach or oz > z + ON_FLOOR:
        return False
    centre: Vec2 = (x, y)
    local = other.to_local(centre)
    return abs(local[0]) <= half_x and abs(local[1]) <= half_y
