"""SceneEval's OpeningClearance: what stands before a door, as deep as the door is wide, or before a window."""

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from thinkblox.scene.room import Opening, Room, Wall
from thinkblox.sim.suites.criteria import criterion, number
from thinkblox.sim.suites.meshes import MeshedThing, Meshes
from thinkblox.suite import Criterion, Finding

WINDOW_DEPTH = 0.5
"""Of the box that stays free before a window [m]; before a door it is as deep as the door is wide."""
GRAZE = 1e-6
"""What reaches less far into the box only touches it [m]."""


def clearance(meshes: Meshes) -> Criterion:
    """Every door and window of the room, and every object that covers a share of one."""
    name = "opening_clearance"
    says = "nothing is before a door within the door's width, or before a window within 0.5 m, inside the room"
    room = meshes.room
    if room is None or not room.openings:
        note = "the room's openings are not known" if room is None else "the room has no openings"
        return criterion(name, says, [], unit="share", limit=0.0, note=note)
    found = [finding for opening in room.openings for finding in _findings(room, opening, meshes.bodies)]
    return criterion(name, says, found, unit="share", limit=0.0)


def _findings(room: Room, opening: Opening, bodies: tuple[MeshedThing, ...]) -> list[Finding]:
    shares = {body.id: share for body in bodies if (share := covered(room, opening, body)) > 0.0}
    if not shares:
        return [Finding(object=opening.id, value=0.0, passed=True)]
    return [
        Finding(object=f"{opening.id} + {id}", value=number(share), passed=False, note="share of the opening covered")
        for id, share in shares.items()
    ]


def covered(room: Room, opening: Opening, body: MeshedThing) -> float:
    """Share of an opening that an object in the box before it hides, seen at right angles to the wall."""
    wall = room.walls[opening.wall]
    depth = opening.width if opening.kind == "door" else WINDOW_DEPTH
    if not _in_box(wall, opening, depth, body):
        return 0.0
    corners = _in_wall(wall, body.triangles.corners)
    inward = corners[:, :, 1]
    before = (inward.min(axis=1) < depth - GRAZE) & (inward.max(axis=1) > GRAZE)
    shadow = shapely.union_all(shapely.buffer(shapely.polygons(corners[before][:, :, [0, 2]]), 0.0))
    hole = _hole(opening)
    return float(shapely.area(shapely.intersection(shadow, hole)) / shapely.area(hole))


def _in_box(wall: Wall, opening: Opening, depth: float, body: MeshedThing) -> bool:
    """Whether the object's box and the one before the opening share any space."""
    if min(body.top, opening.sill + opening.height) - max(body.base, opening.sill) <= GRAZE:
        return False
    start, end = opening.offset, opening.offset + opening.width
    zone = [wall.point(start), wall.point(end), wall.point(end, depth), wall.point(start, depth)]
    shared = shapely.intersection(shapely.Polygon(zone), body.footprint)
    return bool(shapely.area(shared) > GRAZE**2)


def _hole(opening: Opening) -> BaseGeometry:
    """The opening in its wall: along it, and up."""
    return shapely.box(
        opening.offset, opening.sill, opening.offset + opening.width, opening.sill + opening.height
    )  # fmt: skip


def _in_wall(wall: Wall, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points as (along the wall, into the room, up) [m]."""
    axes = np.array([[*wall.along, 0.0], [*wall.inward, 0.0], [0.0, 0.0, 1.0]])
    return np.asarray((points - (*wall.start, 0.0)) @ axes.T, np.float64)
