"""The walkable way: where somebody who comes in by a door can stand, and what that person can reach."""

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from thinkblox.scene.asset import Asset
from thinkblox.scene.derived import kept
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.geometry.clipping import clip_to
from thinkblox.sim.geometry.openings import STANDING, door_zone
from thinkblox.sim.geometry.solid import Solid, solid_of
from thinkblox.sim.settings import Walking
from thinkblox.verdict import Access

ROUNDNESS = 2
"""Segments of a quarter circle where an outline is widened."""
BRIM = 0.02
"""What is nearer to an obstacle than this is beside it [m]."""
SPECK = 1e-4
"""Free floor smaller than this is none [m2]."""


class FreeFloor:
    """Where a walker's middle can be, between the obstacles so far, and what must be within reach from there."""

    def __init__(self, room: Room, walking: Walking) -> None:
        self._walking = walking
        self._free: BaseGeometry = shapely.buffer(room.polygon, -walking.width / 2, quad_segs=ROUNDNESS)
        self._goals: dict[str, BaseGeometry] = {
            door.id: door_zone(room, door, walking) for door in room.openings if door.kind == "door"
        }
        self._doors = frozenset(self._goals)

    @classmethod
    def of(cls, scene: Scene, walking: Walking) -> "FreeFloor":
        """The free floor of a scene."""
        empty = cls(scene.room, walking)
        return empty._with_objects([(p, solid_of(scene.asset_of(p))) for p in scene.placements])

    def with_object(self, placement: Placement, solid: Solid) -> "FreeFloor":
        """This floor with one object more on it."""
        return self._with_objects([(placement, solid)])

    def access(self) -> Access:
        """How much hangs together with a door, and what does not; without doors, with the largest free part."""
        free = sum(part.area for part in self._parts)
        reach = 0.0 if self._main is None else self._main.area / free
        return Access(width=self._walking.width, reach=round(reach, 4), unreachable=self._unreachable)

    def cut_off(self, placements: Sequence[Placement], solid: Solid) -> list[tuple[str, ...]]:
        """For each of some places of an object the ids that have no way from a door once it stands there.

        What had none before is left out; the object itself may be among them.
        """
        there = [(p, solid) for p in placements]
        large = [is_large(p, solid, self._walking) for p in placements]
        obstacles = [_obstacles([one], self._walking) if bars_way(*one, self._walking) else _NOTHING for one in there]
        outlines = _outlines([one for one, is_goal in zip(there, large, strict=True) if is_goal]).tolist()
        goals = [{p.id: outlines.pop(0)} if is_goal else {} for p, is_goal in zip(placements, large, strict=True)]
        plain = self._go_round(goals, obstacles)
        return [
            () if clear else self._lost(goal, bars) for goal, bars, clear in zip(goals, obstacles, plain, strict=True)
        ]

    def _lost(self, goals: Mapping[str, BaseGeometry], obstacles: NDArray[np.object_]) -> tuple[str, ...]:
        """What more of this and what had a way before has none with this in the way."""
        after = self._with(goals, obstacles)._unreachable
        return tuple(id for id in after if id not in self._unreachable)

    def _go_round(
        self, goals: Sequence[Mapping[str, BaseGeometry]], obstacles: Sequence[NDArray[np.object_]]
    ) -> list[bool]:
        """For each of some places whether it is plain from its surroundings that nothing is cut off.

        If the free floor beside an obstacle hangs together without leaving its surroundings, every way through where it
        stands can lead round it. Then only what lies near can have lost the place from which it was reached.
        """
        main, reach = self._main, self._walking.reach
        if main is None:
            return [not goal and not len(bars) for goal, bars in zip(goals, obstacles, strict=True)]
        plain = [
            not len(bars) and all(bool(shapely.dwithin(main, each, reach)) for each in goal.values())
            for goal, bars in zip(goals, obstacles, strict=True)
        ]
        single = [number for number, bars in enumerate(obstacles) if len(bars) == 1]
        if not single:
            return plain
        taken = np.array([obstacles[number][0] for number in single], dtype=object)
        wide = np.array([-1.0, -1.0, 1.0, 1.0]) * (reach + 2 * BRIM)
        windows = shapely.bounds(taken) + wide
        left = shapely.difference(clipped(main, windows), taken)
        parts, of = shapely.get_parts(left, return_index=True)
        beside = shapely.dwithin(parts, taken[of], BRIM)
        counts = np.bincount(of[beside], minlength=len(single)).tolist()
        areas = np.bincount(of[beside], shapely.area(parts[beside]), minlength=len(single)).tolist()
        meets = _meet(self._goal_bounds, windows).tolist()
        for number, floor, count, area, near in zip(single, left.tolist(), counts, areas, meets, strict=True):
            plain[number] = (
                count == 1
                and area >= SPECK
                and all(bool(shapely.dwithin(floor, goal, reach)) for goal in goals[number].values())
                and all(
                    self._within_reach(floor, id) or not self._within_reach(main, id)
                    for id, meet in zip(self._goals, near, strict=True)
                    if meet
                )
            )
        return plain

    def _with_objects(self, objects: Sequence[tuple[Placement, Solid]]) -> "FreeFloor":
        large = [(p, s) for p, s in objects if is_large(p, s, self._walking)]
        bars = [(p, s) for p, s in objects if bars_way(p, s, self._walking)]
        goals = dict(zip((p.id for p, _ in large), _outlines(large), strict=True))
        return self._with(goals, _obstacles(bars, self._walking))

    def _with(self, goals: Mapping[str, BaseGeometry], obstacles: NDArray[np.object_]) -> "FreeFloor":
        """This floor with more that must be reached, and more in the way."""
        more = FreeFloor.__new__(FreeFloor)
        more._walking, more._doors, more._free = self._walking, self._doors, self._free
        more._goals = {**self._goals, **goals}
        if len(obstacles):
            taken = obstacles[0] if len(obstacles) == 1 else shapely.disjoint_subset_union_all(obstacles)
            more._free = shapely.difference(self._free, taken)
        return more

    @cached_property
    def _parts(self) -> list[BaseGeometry]:
        parts = shapely.get_parts(self._free)
        found: list[BaseGeometry] = parts[shapely.area(parts) > SPECK].tolist()
        return found

    @cached_property
    def _main(self) -> BaseGeometry | None:
        doors = [self._goals[id] for id in self._doors]
        main = max(
            self._parts,
            key=lambda part: (any(shapely.intersects(part, door) for door in doors), part.area),
            default=None,
        )
        if main is not None:
            shapely.prepare(main)
        return main

    @cached_property
    def _goal_bounds(self) -> NDArray[np.float64]:
        return shapely.bounds(list(self._goals.values())).reshape(-1, 4)

    @cached_property
    def _unreachable(self) -> tuple[str, ...]:
        if self._main is None:
            return tuple(self._goals)
        goals = list(self._goals.values())
        reach = np.array([0.0 if id in self._doors else self._walking.reach for id in self._goals])
        near = np.asarray(shapely.dwithin(self._main, goals, reach))  # type: ignore[call-overload]
        return tuple(id for id, within in zip(self._goals, near.tolist(), strict=True) if not within)

    def _within_reach(self, floor: BaseGeometry, id: str) -> bool:
        reach = 0.0 if id in self._doors else self._walking.reach
        return bool(shapely.dwithin(floor, self._goals[id], reach))


def stands_on_floor(placement: Placement, asset: Asset) -> bool:
    """Whether it is a solid thing that stands on the floor."""
    return asset.mount == "floor" and asset.collides and placement.position[2] < STANDING


def is_large(placement: Placement, solid: Solid, walking: Walking) -> bool:
    """Whether the object must be reachable: it stands on the floor and covers more than `walking.large`."""
    size = solid.asset.size
    return stands_on_floor(placement, solid.asset) and size[0] * size[1] > walking.large


def bars_way(placement: Placement, solid: Solid, walking: Walking) -> bool:
    """Whether the object is in a walker's way: it is no light thing to push aside, nor out of the walker's height."""
    heavy = not solid.asset.free or solid.asset.mass >= walking.movable
    base = placement.position[2]
    return solid.asset.collides and heavy and base < walking.headroom and base + solid.highest > walking.step


def access(scene: Scene, walking: Walking | None = None) -> Access:
    """What somebody who comes in by a door can walk to and reach."""
    return FreeFloor.of(scene, walking or Walking()).access()


def _obstacles(objects: Sequence[tuple[Placement, Solid]], walking: Walking) -> NDArray[np.object_]:
    """The floor on which a walker's middle cannot be because of the objects, part by part, holes filled."""
    return _placed([(p, ring) for p, solid in objects for ring in _widened(solid, round(p.position[2], 3), walking)])


def _outlines(objects: Sequence[tuple[Placement, Solid]]) -> NDArray[np.object_]:
    """What each object covers of the floor, its hull where that is in parts."""
    return _placed([(p, _hull(solid)) for p, solid in objects])


_NOTHING = np.array([], dtype=object)


def _placed(rings: Sequence[tuple[Placement, NDArray[np.float64]]]) -> NDArray[np.object_]:
    """Polygons of rings (n, 2) that are given in the frames of placements."""
    if not rings:
        return _NOTHING
    if len(rings) == 1:
        ((placement, ring),) = rings
        return np.array([shapely.polygons(_turned(ring, *placement.front) + placement.position[:2])], dtype=object)
    which = np.repeat(np.arange(len(rings)), [len(ring) for _, ring in rings])
    c, s = np.array([placement.front for placement, _ in rings])[which].T
    place = np.array([placement.position[:2] for placement, _ in rings])[which]
    placed = _turned(np.vstack([ring for _, ring in rings]), c, s) + place
    polygons: NDArray[np.object_] = shapely.polygons(shapely.linearrings(placed, indices=which))
    return polygons


def _turned(ring: NDArray[np.float64], c: Any, s: Any) -> NDArray[np.float64]:
    """Points (n, 2) turned by angles of such cosines and sines, all by one or each by its own."""
    x, y = ring[:, 0], ring[:, 1]
    turned = np.empty_like(ring)
    turned[:, 0], turned[:, 1] = c * x - s * y, s * x + c * y
    return turned


@kept
def _hull(solid: Solid) -> NDArray[np.float64]:
    outline = solid.outline()
    whole = outline if isinstance(outline, Polygon) else shapely.convex_hull(outline)
    corners: NDArray[np.float64] = shapely.get_coordinates(shapely.get_exterior_ring(whole))
    return corners


@kept
def _widened(solid: Solid, base: float, walking: Walking) -> tuple[NDArray[np.float64], ...]:
    """Corners (n, 2) of each part of the outline in the walker's height, widened, in the asset's frame."""
    outline = solid.outline(above=walking.step - base, below=walking.headroom - base)
    wide = shapely.buffer(shapely.simplify(outline, 0.005), walking.width / 2, quad_segs=ROUNDNESS)
    parts = [part for part in shapely.get_parts(wide) if not part.is_empty]
    return tuple(shapely.get_coordinates(shapely.simplify(part.exterior, 0.01)) for part in parts)


def clipped(area: BaseGeometry, windows: NDArray[np.float64]) -> NDArray[np.object_]:
    """The part of an area in each of some windows (n, 4); the quick way may give what is not valid."""
    parts = np.array([clip_to(area, *window) for window in windows.tolist()], dtype=object)
    broken = ~shapely.is_valid(parts)
    if broken.any():
        parts[broken] = shapely.intersection(area, shapely.box(*windows[broken].T))
    return parts


def _meet(bounds: NDArray[np.float64], windows: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which boxes (n, 4) meet which windows (m, 4), (m, n)."""
    inside = (bounds[:, :2] <= windows[:, None, 2:]) & (bounds[:, 2:] >= windows[:, None, :2])
    return np.asarray(inside.all(axis=2))
