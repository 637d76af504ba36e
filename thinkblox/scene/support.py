"""What a pose would rest on or hang from, read off the geometry before physics confirms it."""

import math

from msgspec import structs

from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2, Vec3

ON_FLOOR = 0.02
"""A base lower than this stands on the floor [m]."""


def placed_at(scene: Scene, asset: Asset, *, id: str, position: Vec3, yaw: float) -> Placement:
    """The asset at a pose, with the support that lies under it or the wall it hangs on."""
    placement = Placement(
        id=id,
        category=asset.category,
        asset=asset.id,
        position=position,
        yaw=yaw % 360.0,
        size=asset.size,
        support="floor",
    )
    return structs.replace(placement, support=support_of(scene, asset, placement))


def support_of(scene: Scene, asset: Asset, placement: Placement) -> str:
    """Name the support: "floor", "ceiling", a wall, or the id whose surface is nearest below the middle of the base."""
    if asset.mount == "ceiling":
        return "ceiling"
    if asset.mount == "wall":
        return _nearest_wall(scene, placement)
    if placement.position[2] < ON_FLOOR:
        return "floor"
    return _carrier(scene, placement) or "floor"


def _nearest_wall(scene: Scene, placement: Placement) -> str:
    back = placement.to_room((-placement.size[0] / 2, 0.0))

    def badness(index: int) -> float:
        wall = scene.room.walls[index]
        along, inward = wall.coordinates(back)
        return abs(inward) + max(0.0, -along, along - wall.length)

    return scene.room.walls[min(range(len(scene.room.walls)), key=badness)].name


def _carrier(scene: Scene, placement: Placement) -> str | None:
    """Who has a surface right under the middle of the base, or failing that the nearest height below it."""
    centre: Vec2 = (placement.position[0], placement.position[1])
    found: list[tuple[float, str]] = []
    for other in scene.placements:
        if other.id == placement.id or not scene.asset_of(other).collides:
            continue
        x, y = other.to_local(centre)
        if abs(x) > other.size[0] / 2 or abs(y) > other.size[1] / 2:
            continue
        heights = [other.position[2] + s.position[2] for s in scene.asset_of(other).surfaces] or [other.top]
        found += [(abs(placement.position[2] - h), other.id) for h in heights if h < placement.position[2] + ON_FLOOR]
    nearest, id = min(found, default=(math.inf, ""))
    return id if nearest < math.inf else None
