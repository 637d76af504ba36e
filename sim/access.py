"""The walkable way: where somebody who comes in by a door can stand, and what that person can reach."""

from collections.abc import Iterable
from functools import lru_cache

import shapely
from shapely.geometry.base import BaseGeometry

from thinkblox.room import Room
from thinkblox.scene import Placement, Scene
from thinkblox.sim.openings import STANDING, door_zone
from thinkblox.sim.settings import Walking
from thinkblox.sim.solid import Solid, on_floor, solid_of
from thinkblox.verdict import Access

ROUNDNESS = 3
"""Segments of a quarter circle where an outline is widened."""


class FreeFloor:
    """Where a walker's middle can be, between the obstacles so far."""

    def __init__(self, room: Room, walking: Walking) -> None:
        self._room, self._walking = room, walking
        self._free: BaseGeometry = shapely.buffer(room.polygon, -walking.width / 2, quad_segs=ROUNDNESS)
        self._goals: dict[str, BaseGeometry] = {
            door.id: door_zone(room, door, walking) for door in room.openings if door.kind == "door"
        }
        self._doors = tuple(self._goals)

    def with_objects(self, objects: Iterable[tuple[Placement, Solid]]) -> "FreeFloor":
        """This floor with more objects on it."""
        more = FreeFloor.__new__(FreeFloor)
        more.__dict__.update(self.__dict__)
        more._goals = dict(self._goals)
        obstacles = []
        for placement, solid in objects:
            if is_large(placement, solid, self._walking):
                more._goals[placement.id] = on_floor(solid.outline(), placement)
            if bars_way(placement, solid, self._walking):
                obstacles.append(on_floor(_widened(solid, placement.position[2], self._walking), placement))
        if obstacles:
            more._free = shapely.difference(self._free, shapely.union_all(obstacles))
        return more

    def access(self) -> Access:
        """How much hangs together with a door, and what does not; without doors, with the largest free part."""
        parts = [part for part in shapely.get_parts(self._free) if part.area > 1e-4]
        if not parts:
            return Access(width=self._walking.width, reach=0.0, unreachable=tuple(self._goals))
        main = max(parts, key=lambda part: (self._touches_door(part), part.area))
        far = [id for id, goal in self._goals.items() if not self._within_reach(main, id, goal)]
        share = main.area / sum(part.area for part in parts)
        return Access(width=self._walking.width, reach=round(share, 4), unreachable=tuple(far))

    def _touches_door(self, part: BaseGeometry) -> bool:
        return any(shapely.intersects(part, self._goals[door]) for door in self._doors)

    def _within_reach(self, main: BaseGeometry, id: str, goal: BaseGeometry) -> bool:
        if id in self._doors:
            return bool(shapely.intersects(main, goal))
        return bool(shapely.dwithin(main, goal, self._walking.reach))


def is_large(placement: Placement, solid: Solid, walking: Walking) -> bool:
    """Whether the object must be reachable: it stands on the floor and covers more than `walking.large`."""
    asset = solid.asset
    on_ground = asset.mount == "floor" and placement.position[2] < STANDING
    return on_ground and asset.collides and asset.size[0] * asset.size[1] > walking.large


def bars_way(placement: Placement, solid: Solid, walking: Walking) -> bool:
    """Whether the object is in a walker's way: it is no light thing to push aside, nor out of the walker's height."""
    heavy = not solid.asset.free or solid.asset.mass >= walking.movable
    base = placement.position[2]
    return solid.asset.collides and heavy and base < walking.headroom and base + solid.highest > walking.step


def _widened(solid: Solid, base: float, walking: Walking) -> BaseGeometry:
    return _widened_at(solid, round(base, 3), walking)


@lru_cache(maxsize=1024)
def _widened_at(solid: Solid, base: float, walking: Walking) -> BaseGeometry:
    outline = solid.outline(above=walking.step - base, below=walking.headroom - base)
    return shapely.buffer(shapely.simplify(outline, 0.005), walking.width / 2, quad_segs=ROUNDNESS)


def free_floor(scene: Scene, walking: Walking) -> FreeFloor:
    """The free floor of a scene."""
    return FreeFloor(scene.room, walking).with_objects((p, solid_of(scene.asset_of(p))) for p in scene.placements)


def access(scene: Scene, walking: Walking | None = None) -> Access:
    """What somebody who comes in by a door can walk to and reach."""
    return free_floor(scene, walking or Walking()).access()
