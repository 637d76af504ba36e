"""The room itself as triangles: floor, walls with their doors and windows, skirting, and the ground round it."""

import math
from dataclasses import dataclass

import numpy as np
from shapely import Polygon, constrained_delaunay_triangles, get_coordinates, orient_polygons

from thinkblox.scene.room import Opening, Room, Wall
from thinkblox.sim.render.materials import CUT, GROUND, MATERIALS, TRIM, Colour, Palette, linear
from thinkblox.sim.render.soup import ROOM, Patch, Soup
from thinkblox.sim.render.tessellate import Floats, Mesh, rounded_box
from thinkblox.value import Vec3

THICKNESS = 0.12
"""Thickness of the walls, outside the floor polygon [m]."""
RIM = 0.08
"""What is left of a wall that is cut away [m]."""
SLAB = 0.14
"""Thickness of the floor [m]."""
_SKIRTING = (0.09, 0.014)
_PANE: Colour = (0.80, 0.90, 1.0)
_LEAF: Colour = (0.84, 0.81, 0.76)
_HANDLE: Colour = (0.55, 0.53, 0.50)


@dataclass(frozen=True)
class Shell:
    """How a room is drawn.

    Attributes:
        standing: for each wall, whether it is drawn at full height; the others leave a rim.
        accent: index of the wall in the accent colour, or None.
        ground: what is drawn of the ground that the room stands on; None for nothing.
        top: height of the standing walls [m], the room's when None.
        cut: colour of the walls' upper faces.
    """

    standing: tuple[bool, ...]
    accent: int | None = None
    ground: Polygon | None = None
    top: float | None = None
    cut: Colour = CUT


def add_room(soup: Soup, room: Room, palette: Palette, shell: Shell) -> None:
    """Add floor, walls, openings and ground."""
    add_floor(soup, room, palette)
    for index, wall in enumerate(room.walls):
        colour = palette.accent if index == shell.accent and shell.standing[index] else palette.wall
        openings = [o for o in room.openings if o.wall == index]
        _add_wall(_WallFrame(soup, room, index, shell), wall, openings, colour)
    if shell.ground is not None:
        add_ground(soup, shell.ground, -SLAB - 0.002)


def accent_wall(room: Room, standing: tuple[bool, ...]) -> int:
    """The wall for the accent colour: of those at full height, the longest one after its openings are taken off."""
    free = [wall.length if stands else 0.0 for wall, stands in zip(room.walls, standing, strict=True)]
    for opening in room.openings:
        free[opening.wall] -= 1.2 * opening.width
    return int(np.argmax(np.round(free, 6)))


@dataclass(frozen=True)
class _WallFrame:
    """Adds boxes given by (along the wall, towards the room, up) [m]."""

    soup: Soup
    room: Room
    index: int
    shell: Shell

    @property
    def wall(self) -> Wall:
        return self.room.walls[self.index]

    def box(
        self,
        along: tuple[float, float],
        inward: tuple[float, float],
        up: tuple[float, float],
        colour: Colour,
        material: str,
        radius: float = 0.0,
        slant: tuple[float, float] = (0.0, 0.0),
    ) -> None:
        """One box from lower to upper bounds; nothing when it has no extent.

        `slant` says how much further its outer face runs at the start and at the end [m].
        """
        low = np.array([along[0], inward[0], up[0]])
        size = np.array([along[1], inward[1], up[1]]) - low
        if size.min() > 1e-6:
            mesh = rounded_box((float(size[0]), float(size[1]), float(size[2])), radius)
            self.soup.add(
                _slanted(mesh, slant), self.patch(low + size / 2, (size[0], size[1], size[2]), colour, material)
            )

    def patch(self, centre: np.ndarray, size: Vec3, colour: Colour, material: str) -> Patch:
        """A patch whose frame is along the wall, into the room, up, centred at a point given in that order."""
        (ax, ay), (nx, ny) = self.wall.along, self.wall.inward
        turn = np.array([[ax, nx, 0.0], [ay, ny, 0.0], [0.0, 0.0, 1.0]])
        start = np.array([*self.wall.start, 0.0])
        return Patch(linear(colour), MATERIALS.index(material), ROOM, turn, start + turn @ centre, size)


def _slanted(mesh: Mesh, slant: tuple[float, float]) -> Mesh:
    if slant == (0.0, 0.0):
        return mesh
    vertices = mesh.vertices.copy()
    outer = vertices[:, 1] < 0
    vertices[:, 0] += outer * np.where(vertices[:, 0] < 0, -slant[0], slant[1]).astype(np.float32)
    return Mesh(vertices, mesh.normals, mesh.faces)


def _add_wall(frame: _WallFrame, wall: Wall, openings: list[Opening], colour: Colour) -> None:
    standing = frame.shell.standing[frame.index]
    top = (frame.shell.top or frame.room.height) if standing else RIM
    low, high = _end(frame, -1), _end(frame, 1)
    first, last = -low.run, wall.length + high.run
    for start, end, bottom, ceiling in _solid_parts(openings, first, last, top):
        slant = (low.slant if start == first else 0.0, high.slant if end == last else 0.0)
        frame.box((start, end), (-THICKNESS, 0.0), (bottom, ceiling), colour, "wall", slant=slant)
        if ceiling == top:
            cap = (top, top + 0.004)
            frame.box((start, end), (-THICKNESS, 0.0), cap, frame.shell.cut, "cut", slant=slant)
    for bare, at in ((low.bare, first - 0.003), (high.bare, last)):
        if bare:
            frame.box((at, at + 0.003), (-THICKNESS, 0.0), (-SLAB, top + 0.004), frame.shell.cut, "cut")
    for opening in openings:
        if opening.kind == "window" and top >= opening.sill + opening.height:
            _add_window(frame, opening)
        elif opening.kind == "door":
            _add_door(frame, opening, top)
    if standing:
        _add_skirting(frame, wall, openings)


def _solid_parts(
    openings: list[Opening], low: float, high: float, top: float
) -> list[tuple[float, float, float, float]]:
    """The wall less its openings as (from, to, bottom, top) along its run."""
    parts, at = [], low
    for opening in sorted(openings, key=lambda o: o.offset):
        start, end = opening.offset, opening.offset + opening.width
        parts.append((at, start, -SLAB, top))
        parts.append((start, end, -SLAB, min(opening.sill, top)))
        parts.append((start, end, min(opening.sill + opening.height, top), top))
        at = max(at, end)
    parts.append((at, high, -SLAB, top))
    return [part for part in parts if part[1] - part[0] > 1e-6 and part[3] - part[2] > 1e-6]


@dataclass(frozen=True)
class _End:
    """How a wall's body ends: how far past its corner it runs, how much further its outer face runs, and whether the
    end is bare because the neighbour is lower.
    """

    run: float = 0.0
    slant: float = 0.0
    bare: bool = False


def _end(frame: _WallFrame, side: int) -> _End:
    """One end: mitred with a neighbour of the same height, covering the corner beside a lower one."""
    walls, standing = frame.room.walls, frame.shell.standing
    other = (frame.index + side) % len(walls)
    corner = _corner(*(walls[i] for i in ((frame.index, other) if side > 0 else (other, frame.index))))
    if standing[frame.index] == standing[other]:
        return _End(slant=corner)
    return _End(run=max(corner, 0.0), bare=True) if standing[frame.index] else _End()


def _corner(first: Wall, second: Wall) -> float:
    """How far two walls' outer faces run past their common corner [m]; negative where it points into the room."""
    (ax, ay), (bx, by) = first.along, second.along
    turn = math.atan2(ax * by - ay * bx, ax * bx + ay * by)
    return THICKNESS * min(max(math.tan(turn / 2), -1.0), 2.0)


def _add_window(frame: _WallFrame, opening: Opening) -> None:
    start, end = opening.offset, opening.offset + opening.width
    bottom, top = opening.sill, opening.sill + opening.height
    bar, depth = min(0.05, opening.width / 8), (-0.085, -0.035)
    frame.box((start, end), (-0.075, -0.07), (bottom, top), _PANE, "pane")
    frame.box((start, start + bar), depth, (bottom, top), TRIM, "trim", 0.003)
    frame.box((end - bar, end), depth, (bottom, top), TRIM, "trim", 0.003)
    frame.box((start, end), depth, (bottom, bottom + bar), TRIM, "trim", 0.003)
    frame.box((start, end), depth, (top - bar, top), TRIM, "trim", 0.003)
    lights = max(round(opening.width / 0.75), 1)
    for i in range(1, lights):
        middle = start + opening.width * i / lights
        frame.box((middle - bar / 2, middle + bar / 2), depth, (bottom, top), TRIM, "trim", 0.003)
    if bottom > 0.15:
        frame.box((start - 0.04, end + 0.04), (-THICKNESS, 0.05), (bottom - 0.03, bottom + 0.004), TRIM, "trim", 0.003)


def _add_door(frame: _WallFrame, opening: Opening, top: float) -> None:
    start, end = opening.offset, opening.offset + opening.width
    if top < opening.height:
        return
    bar, height = 0.07, opening.height
    frame.box((start - bar, start), (-0.02, 0.018), (0.0, height + bar), TRIM, "trim", 0.003)
    frame.box((end, end + bar), (-0.02, 0.018), (0.0, height + bar), TRIM, "trim", 0.003)
    frame.box((start, end), (-0.02, 0.018), (height, height + bar), TRIM, "trim", 0.003)
    frame.box((start + 0.004, end - 0.004), (-0.07, -0.03), (0.004, height - 0.004), _LEAF, "trim", 0.002)
    _add_panels(frame, opening)
    away = end - 0.09 if opening.hinge == "start" else start + 0.09
    lever = -0.06 if opening.hinge == "start" else 0.06
    frame.box((away - 0.01, away + 0.01), (-0.03, 0.02), (0.99, 1.01), _HANDLE, "metal", 0.003)
    frame.box(
        (min(away, away + 2 * lever), max(away, away + 2 * lever)), (0.01, 0.025), (0.99, 1.01), _HANDLE, "metal", 0.003
    )


def _add_panels(frame: _WallFrame, opening: Opening) -> None:
    """Two raised fields on the door's leaf."""
    start, end = opening.offset + 0.13, opening.offset + opening.width - 0.13
    for bottom, top in ((0.20, 0.88), (1.10, opening.height - 0.15)):
        frame.box((start, end), (-0.03, -0.022), (bottom, top), _LEAF, "trim", 0.004)


def _add_skirting(frame: _WallFrame, wall: Wall, openings: list[Opening]) -> None:
    height, depth = _SKIRTING
    at = 0.0
    doors = sorted((o.offset - 0.07, o.offset + o.width + 0.07) for o in openings if o.sill < height)
    for start, end in [*doors, (wall.length, wall.length)]:
        frame.box((at, min(start, wall.length)), (0.0, depth), (0.0, height), TRIM, "trim", 0.003)
        at = max(at, end)


def add_floor(soup: Soup, room: Room, palette: Palette) -> None:
    """Add the floor, its planks along the longer side."""
    width, depth = room.extent
    turn = np.eye(3) if width >= depth else np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    flat = _flat(room.polygon, 0.0) @ turn
    patch = Patch(linear(palette.floor), MATERIALS.index("floor"), ROOM, turn, np.zeros(3), (width, depth, SLAB))
    soup.add(_level(flat), patch)


def add_ground(soup: Soup, outline: Polygon, height: float) -> None:
    """Add level ground of some outline at a height [m]; it shows shadows only."""
    x0, y0, x1, y1 = outline.bounds
    size = (x1 - x0, y1 - y0, SLAB)
    patch = Patch(linear(GROUND), MATERIALS.index("ground"), ROOM, np.eye(3), np.zeros(3), size)
    soup.add(_level(_flat(outline, height)), patch)


def _flat(outline: Polygon, height: float) -> np.ndarray:
    """Corners (3 n, 3) of the triangles that fill a polygon at a height [m], counter-clockwise."""
    triangles = constrained_delaunay_triangles(outline).geoms
    corners = np.concatenate([get_coordinates(orient_polygons(triangle))[:3] for triangle in triangles])
    return np.pad(corners, ((0, 0), (0, 1)), constant_values=height)


def _level(corners: np.ndarray) -> Mesh:
    up: Floats = np.tile(np.array([[0.0, 0.0, 1.0]], np.float32), (len(corners), 1))
    return Mesh(corners.astype(np.float32), up, np.arange(len(corners), dtype=np.int32).reshape(-1, 3))
