"""Where something that fails might be valid: poses by distance from where it is, shifted and never turned."""

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from msgspec import structs
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement, apart, to_micrometres
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import ON_FLOOR
from thinkblox.sim.geometry.free_space import (
    FlatPiece,
    Plane,
    carried_within,
    floor_plane,
    free_space,
    pieces_of,
    wall_plane,
    zone_pieces,
)
from thinkblox.sim.settings import Walking

REACH = 2.0
"""How far away poses are looked for [m]."""
NEAR = 0.3
"""How far from the object the tops are that it might be put on [m]."""
RADII = 0.01 * 1.35 ** np.arange(18)
SPOKES = 12
LEAST = 1e-4
"""Shifts below this are none [m]."""

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Shift:
    """A pose to try: the placement there, how far it is from where it was [m], and how much of that is across.

    Attributes:
        placement: at the new position.
        distance: from the old one [m].
        across: displacement out of the plane in which it can be moved freely: off a wall, up or down on floors [m].
    """

    placement: Placement
    distance: float
    across: tuple[float, float, float]


def shifts(
    scene: Scene,
    placement: Placement,
    riders: Sequence[Placement],
    walking: Walking,
    *,
    past: Collection[str] = (),
    gently: bool = False,
) -> list[Shift]:
    """Poses, nearest first, at which an object seems to be inside, clear of the others and carried.

    Args:
        scene: with the object in it.
        placement: of the object that fails.
        riders: what moves with it.
        walking: says which zones of doors and windows stay free.
        past: ids that are looked past.
        gently: only where what carries it does so still; and besides the least shift into the room alone, and out of
            each other object alone: what is wrong by a little is mended by little, though it then stands as near to a
            third as is tolerated.
    """
    asset = scene.asset_of(placement)
    plane = _plane(scene, placement, asset)
    group = [placement, *riders]
    mine = [piece for p in group if scene.asset_of(p).collides for piece in pieces_of(plane, p, scene.asset_of(p))]
    gone = {p.id for p in group} | set(past)
    others = [p for p in scene.placements if p.id not in gone and asset.collides and scene.asset_of(p).collides]
    near = [p for p in others if apart(p, placement) < REACH]
    each = [pieces_of(plane, p, scene.asset_of(p)) for p in near]
    obstacles = [piece for pieces in each for piece in pieces]
    zones = zone_pieces(scene.room, walking, windows=asset.mount == "floor") if plane.upright and asset.collides else ()
    own = pieces_of(plane, placement, asset)
    mover = _Mover(plane, placement, asset, own, mine or own, obstacles)
    found: list[Shift] = []
    for step in _steps(scene, plane, placement, own, _carriers(placement, near, each) if gently else obstacles):
        found += mover.shifts(obstacles, zones, step)
    if gently:
        for alone in ((), *each):
            found += mover.shifts(alone, (), 0.0, rings=False)
    return sorted(found, key=lambda shift: (round(shift.distance, 5), shift.placement.position))


def _carriers(placement: Placement, near: Sequence[Placement], each: Sequence[Sequence[FlatPiece]]) -> list[FlatPiece]:
    """The pieces of what an object is on or over: of anything near where it floats over none."""
    floats = placement.support == "floor" and placement.position[2] > ON_FLOOR
    chosen = (pieces for p, pieces in zip(near, each, strict=True) if floats or p.id == placement.support)
    return [piece for pieces in chosen for piece in pieces]


def _plane(scene: Scene, placement: Placement, asset: Asset) -> Plane:
    walls = {wall.name: wall for wall in scene.room.walls}
    if asset.mount == "wall" and placement.support in walls:
        return wall_plane(scene.room, walls[placement.support])
    return floor_plane(scene.room)


def _steps(
    scene: Scene, plane: Plane, placement: Placement, own: Sequence[FlatPiece], obstacles: Iterable[FlatPiece]
) -> tuple[float, ...]:
    """By how much it is shifted across the plane: onto the wall, the ceiling, the floor, or tops that are near [m].

    What belongs on the floor is not put on top of other things.
    """
    asset, low, high = scene.asset_of(placement), min(piece.low for piece in own), max(piece.high for piece in own)
    if not plane.upright or not asset.free:
        return (scene.room.height - high if asset.mount == "ceiling" else -low,)
    if asset.mount == "floor" and placement.support not in scene:
        return (0.0, -low)
    footprint = shapely.MultiPoint(np.vstack([piece.corners for piece in own])).convex_hull
    near = [p for p in obstacles if shapely.dwithin(shapely.MultiPoint(p.corners).convex_hull, footprint, NEAR)]
    tops = {round(piece.high - low, 6) for piece in near}
    return (0.0, *sorted({-low, *tops}, key=lambda step: (abs(step), step)))


@dataclass(frozen=True)
class _Mover:
    """An object to be shifted: its pieces, those of all that moves with it, and those of what may carry it."""

    plane: Plane
    placement: Placement
    asset: Asset
    own: Sequence[FlatPiece]
    mine: Sequence[FlatPiece]
    beneath: Sequence[FlatPiece]

    def shifts(
        self, obstacles: Sequence[FlatPiece], zones: Sequence[FlatPiece], step: float, *, rings: bool = True
    ) -> list[Shift]:
        """Poses clear of some obstacles after one step across the plane: the nearest, and with `rings` others."""
        plane, placement = self.plane, self.placement
        u, v, w = plane.coordinates(np.array([placement.position]))[0]
        raised = [FlatPiece(piece.corners, piece.low + step, piece.high + step) for piece in self.mine]
        space = free_space(plane, np.array([u, v]), raised, obstacles if self.asset.collides else (), zones)
        base = min(piece.low for piece in self.own) + step
        if plane.upright and self.asset.free and base > ON_FLOOR:
            space = carried_within(space, self.beneath, base)
        across = (plane.axes[2] * step).tolist()
        places = [plane.point(np.array([*at, w + step])) for at in _places(space, np.array([u, v]), rings)]
        found = [(place, float(np.linalg.norm(place - placement.position))) for place in places]
        return [
            Shift(
                structs.replace(placement, position=to_micrometres(place)), distance, (across[0], across[1], across[2])
            )
            for place, distance in found
            if distance > LEAST
        ]


def _places(space: BaseGeometry, at: Array, rings: bool) -> Array:
    """The point of a space nearest to `at`, and points on rings round `at` (n, 2)."""
    if space.is_empty:
        return np.zeros((0, 2))
    nearest = np.array([shapely.get_coordinates(shapely.shortest_line(space, shapely.Point(at)))[0]])
    if not rings:
        return nearest
    turns = 2 * np.pi * np.arange(SPOKES) / SPOKES
    spokes = np.stack([np.cos(turns), np.sin(turns)], 1)
    ringed = (at + RADII[:, None, None] * spokes[None]).reshape(-1, 2)
    return np.concatenate([nearest, ringed[shapely.contains_xy(space, ringed)]])


__all__ = ["REACH", "Shift", "shifts"]
