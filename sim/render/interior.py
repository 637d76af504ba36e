"""The room itself as triangles: floor, walls with their doors and windows, skirting, and the ground round it."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from shapely import Polygon, constrained_delaunay_triangles, get_coordinates, orient_polygons

from thinkblox.scene.room import Opening, Room, Wall
from thinkblox.scene.surfaces import Covering, Surfaces
from thinkblox.sim.render.curtains import FOLDS, Drape, sides_of, top_of
from thinkblox.sim.render.materials import CUT, GROUND, MATERIALS, Colour, linear
from thinkblox.sim.render.soup import ROOM, CoveredPlane, Patch, Soup
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
_HANDLE: Colour = (0.55, 0.53, 0.50)


@dataclass(frozen=True)
class Shell:
    """How a room is drawn.

    Attributes:
        standing: for each wall, whether it is drawn at full height; the others leave a rim.
        ground: what is drawn of the ground that the room stands on; None for nothing.
        top: height of the standing walls [m], the room's when None.
        cut: colour of the walls' upper faces.
        curtains: how they hang, by the id of their window.
        filled: whether doors have leaves, and windows frames and panes.
    """

    standing: tuple[bool, ...]
    ground: Polygon | None = None
    top: float | None = None
    cut: Colour = CUT
    curtains: Mapping[str, Drape] = field(default_factory=dict)
    filled: bool = True


def add_room(soup: Soup, room: Room, surfaces: Surfaces, shell: Shell) -> None:
    """Add floor, walls, openings and ground."""
    add_floor(soup, room, surfaces)
    for index, wall in enumerate(room.walls):
        openings = [o for o in room.openings if o.wall == index]
        _add_wall(_WallFrame(soup, room, index, shell, surfaces), wall, openings)
    if shell.ground is not None:
        add_ground(soup, shell.ground, -SLAB - 0.002)


@dataclass(frozen=True)
class _WallFrame:
    """Adds boxes given by (along the wall, towards the room, up) [m]."""

    soup: Soup
    room: Room
    index: int
    shell: Shell
    surfaces: Surfaces

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
        covering: Covering | None = None,
    ) -> None:
        """One box from lower to upper bounds; nothing when it has no extent.

        `slant` says how much further its outer face runs at the start and at the end [m].
        """
        low = np.array([along[0], inward[0], up[0]])
        size = np.array([along[1], inward[1], up[1]]) - low
        if size.min() > 1e-6:
            mesh = rounded_box((float(size[0]), float(size[1]), float(size[2])), radius)
            patch = self.patch(low + size / 2, (size[0], size[1], size[2]), colour, material)
            if covering is not None:
                patch = replace(patch, plane=self.plane(covering))
            self.soup.add(_slanted(mesh, slant), patch)

    def plane(self, covering: Covering) -> CoveredPlane:
        """The wall's inner side, with its pattern beginning at its start on the floor."""
        (ax, ay), (x, y) = self.wall.along, self.wall.start
        return CoveredPlane(covering, (x, y, 0.0), (-ax, -ay, 0.0), (0.0, 0.0, 1.0), floor=False)

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


def _add_wall(frame: _WallFrame, wall: Wall, openings: list[Opening]) -> None:
    standing = frame.shell.standing[frame.index]
    top = (frame.shell.top or frame.room.height) if standing else RIM
    low, high = _end(frame, -1), _end(frame, 1)
    first, last = -low.run, wall.length + high.run
    for start, end, bottom, ceiling in _solid_parts(openings, first, last, top):
        slant = (low.slant if start == first else 0.0, high.slant if end == last else 0.0)
        for lower, upper, covering in _courses(frame, bottom, ceiling):
            frame.box(
                (start, end), (-THICKNESS, 0.0), (lower, upper), covering.colour, "wall", slant=slant, covering=covering
            )
        if ceiling == top:
            cap = (top, top + 0.004)
            frame.box((start, end), (-THICKNESS, 0.0), cap, frame.shell.cut, "cut", slant=slant)
    for bare, at in ((low.bare, first - 0.003), (high.bare, last)):
        if bare:
            frame.box((at, at + 0.003), (-THICKNESS, 0.0), (-SLAB, top + 0.004), frame.shell.cut, "cut")
    for opening in openings:
        _add_opening(frame, opening, top)
    if standing:
        _add_skirting(frame, wall, openings)


def _add_opening(frame: _WallFrame, opening: Opening, top: float) -> None:
    if opening.kind == "door":
        _add_door(frame, opening, top)
    elif top >= opening.sill + opening.height:
        _add_window(frame, opening)
        if opening.id in frame.shell.curtains and frame.surfaces.curtains is not None:
            _add_curtains(frame, opening, frame.shell.curtains[opening.id], frame.surfaces.curtains)


def _courses(frame: _WallFrame, bottom: float, top: float) -> list[tuple[float, float, Covering]]:
    """The dado and what is above it of a part of a wall, as (bottom, top, covering)."""
    surfaces, upper = frame.surfaces, frame.surfaces.of_wall(frame.index)
    if surfaces.dado is None or bottom >= surfaces.dado_height:
        return [(bottom, top, upper)]
    if top <= surfaces.dado_height:
        return [(bottom, top, surfaces.dado)]
    return [(bottom, surfaces.dado_height, surfaces.dado), (surfaces.dado_height, top, upper)]


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
    start, end, bottom = opening.offset, opening.offset + opening.width, opening.sill
    if frame.shell.filled:
        _add_pane(frame, opening)
    if bottom > 0.15:
        board = (bottom - 0.03, bottom + 0.004)
        frame.box((start - 0.04, end + 0.04), (-THICKNESS, 0.05), board, frame.surfaces.trim, "trim", 0.003)


def _add_pane(frame: _WallFrame, opening: Opening) -> None:
    start, end = opening.offset, opening.offset + opening.width
    bottom, top = opening.sill, opening.sill + opening.height
    bar, depth = min(0.05, opening.width / 8), (-0.085, -0.035)
    frame.box((start, end), (-0.075, -0.07), (bottom, top), _PANE, "pane")
    frame.box((start, start + bar), depth, (bottom, top), frame.surfaces.trim, "trim", 0.003)
    frame.box((end - bar, end), depth, (bottom, top), frame.surfaces.trim, "trim", 0.003)
    frame.box((start, end), depth, (bottom, bottom + bar), frame.surfaces.trim, "trim", 0.003)
    frame.box((start, end), depth, (top - bar, top), frame.surfaces.trim, "trim", 0.003)
    lights = max(round(opening.width / 0.75), 1)
    for i in range(1, lights):
        middle = start + opening.width * i / lights
        frame.box((middle - bar / 2, middle + bar / 2), depth, (bottom, top), frame.surfaces.trim, "trim", 0.003)


def _add_curtains(frame: _WallFrame, opening: Opening, drape: Drape, colour: Colour) -> None:
    """A pleated curtain on either side of a window, on a rod."""
    top, bottom = top_of(opening, frame.room), drape.bottom
    (first, _), (_, last) = sides = sides_of(opening, drape)
    frame.box((first - 0.03, last + 0.03), (0.055, 0.075), (top - 0.01, top + 0.01), _HANDLE, "metal", 0.008)
    # The folds are of two tones in one plane: their own shadows are finer than the light's grid.
    red, green, blue = (0.9 * channel for channel in colour)
    for start, end in sides:
        for fold in range(FOLDS):
            low, high = (start + (end - start) * (fold + part) / FOLDS for part in (0.0, 1.0))
            tone = (red, green, blue) if fold % 2 else colour
            frame.box((low, high), (0.04, 0.09), (bottom, top - 0.012), tone, "fabric")


def _add_door(frame: _WallFrame, opening: Opening, top: float) -> None:
    start, end = opening.offset, opening.offset + opening.width
    if top < opening.height:
        return
    bar, height = 0.07, opening.height
    frame.box((start - bar, start), (-0.02, 0.018), (0.0, height + bar), frame.surfaces.trim, "trim", 0.003)
    frame.box((end, end + bar), (-0.02, 0.018), (0.0, height + bar), frame.surfaces.trim, "trim", 0.003)
    frame.box((start, end), (-0.02, 0.018), (height, height + bar), frame.surfaces.trim, "trim", 0.003)
    if frame.shell.filled:
        _add_leaf(frame, opening)


def _add_leaf(frame: _WallFrame, opening: Opening) -> None:
    """The leaf of a door with its panels and its lever."""
    start, end, height = opening.offset, opening.offset + opening.width, opening.height
    frame.box((start + 0.004, end - 0.004), (-0.07, -0.03), (0.004, height - 0.004), frame.surfaces.door, "trim", 0.002)
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
        frame.box((start, end), (-0.05, -0.022), (bottom, top), frame.surfaces.door, "trim", 0.004)


def _add_skirting(frame: _WallFrame, wall: Wall, openings: list[Opening]) -> None:
    """A skirting along the floor, but for tiles; and a rail along the top of a dado."""
    surfaces, trim = frame.surfaces, frame.surfaces.trim
    lowest = surfaces.of_wall(frame.index) if surfaces.dado is None else surfaces.dado
    height, depth = _SKIRTING
    if lowest.laying not in ("tiles", "subway", "marble", "stone"):
        for start, end in _free(wall, openings, 0.0, height):
            frame.box((start, end), (0.0, depth), (0.0, height), trim, "trim", 0.003)
    if surfaces.dado is not None and surfaces.dado_height < frame.room.height:
        top = surfaces.dado_height
        for start, end in _free(wall, openings, top - 0.02, top + 0.02):
            frame.box((start, end), (0.0, 0.01), (top - 0.018, top + 0.012), trim, "trim", 0.003)


def _free(wall: Wall, openings: list[Opening], bottom: float, top: float) -> list[tuple[float, float]]:
    """The stretches of a wall that no opening takes between two heights."""
    frame = 0.07
    taken = [o for o in openings if o.sill - frame < top and o.sill + o.height + frame > bottom]
    stretches, at = [], 0.0
    for opening in sorted(taken, key=lambda o: o.offset):
        stretches.append((at, opening.offset - frame))
        at = max(at, opening.offset + opening.width + frame)
    return [(start, end) for start, end in [*stretches, (at, wall.length)] if end - start > 1e-3]


def add_floor(soup: Soup, room: Room, surfaces: Surfaces) -> None:
    """Add the floor, its pattern along the longer side."""
    width, depth = room.extent
    turn = np.eye(3) if width >= depth else np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    flat = _flat(room.polygon, 0.0) @ turn
    # The pattern of a floor turned a quarter runs the other way round, so that it is seen from the same side.
    axes = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)) if width >= depth else ((0.0, 1.0, 0.0), (-1.0, 0.0, 0.0))
    plane = CoveredPlane(surfaces.floor, (0.0, 0.0, 0.0), *axes, floor=True)
    colour, material = linear(surfaces.floor.colour), MATERIALS.index("floor")
    soup.add(_level(flat), Patch(colour, material, ROOM, turn, np.zeros(3), (width, depth, SLAB), plane=plane))


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
