"""What a picture of anybody's scene shows: its objects as convex pieces, its room opened towards the camera."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPoint
from shapely.geometry.base import BaseGeometry

from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.render.camera import Camera, framed, plan_camera
from thinkblox.sim.render.interior import RIM, SLAB, THICKNESS, Shell, add_room
from thinkblox.sim.render.model_soup import add_model
from thinkblox.sim.render.open_room import Bounds, bounds_of, opened
from thinkblox.sim.render.plan_view import CUT_HEIGHT, overhead
from thinkblox.sim.render.preview import ELEVATION, best_view
from thinkblox.sim.render.rays import Tracer
from thinkblox.sim.render.soup import ROOM, Patch, Soup, add_objects
from thinkblox.sim.render.surfels import see
from thinkblox.sim.render.tessellate import Floats, Ints, Mesh
from thinkblox.sim.subject import Subject

Array = NDArray[np.float64]
CUT_THROUGH = (0.42, 0.40, 0.38)
"""Colour of walls that are cut through, on a plan."""
ABOVE: Floats = np.array([-0.30, 0.34, 1.0], np.float32)
"""The sun of a plan: nearly overhead, so that shadows are short."""
MARGIN = 0.06
"""Share of a picture left free round the room."""
STRAY = 1.0
"""What is further out of the room than this share of its size is not in the picture."""
_THUMBNAIL = 72
_CORNERS = (225.0, 315.0, 135.0, 45.0)


@dataclass(frozen=True)
class Sighted:
    """An object as a picture needs it: its id, and the points (n, 3) of each of its pieces [m]."""

    id: str
    pieces: tuple[Array, ...]

    @cached_property
    def points(self) -> Array:
        """All its points (n, 3)."""
        return np.concatenate(self.pieces) if self.pieces else np.zeros((1, 3))

    @cached_property
    def footprint(self) -> BaseGeometry:
        """What it covers of the floor."""
        return shapely.union_all([MultiPoint(piece[:, :2]).convex_hull for piece in self.pieces])

    @property
    def low(self) -> float:
        """Height of its lowest point [m]."""
        return float(self.points[:, 2].min())

    @property
    def high(self) -> float:
        """Height of its highest point [m]."""
        return float(self.points[:, 2].max())

    @property
    def middle(self) -> Array:
        """Middle of its bounding box."""
        return np.asarray((self.points.min(0) + self.points.max(0)) / 2)


@dataclass(frozen=True)
class Scenery:
    """Everything there is to see of a subject.

    Attributes:
        bodies: its objects, in the order of `subject.things`.
        rest: what belongs to no object: the room, where it came with the model.
        bounds: of the room, or of what stands for one.
    """

    subject: Subject
    soup: Soup
    bodies: tuple[Sighted, ...]
    rest: Sighted
    bounds: Bounds

    @property
    def room(self) -> Room | None:
        """The room, where one is known."""
        return self.subject.room

    @property
    def scene(self) -> Scene | None:
        """The scene, where the subject is one of ours."""
        return self.subject.scene

    def body(self, id: str) -> Sighted | None:
        """The object of this id, if there is one."""
        return next((body for body in self.bodies if body.id == id), None)

    @property
    def in_sight(self) -> tuple[Sighted, ...]:
        """The objects that are not so far out of the room that a picture of both would show neither."""
        low, high = self.bounds.low - STRAY * self.bounds.size, self.bounds.high + STRAY * self.bounds.size
        return tuple(b for b in self.bodies if b.pieces and bool(((b.points >= low) & (b.points <= high)).all()))


def scenery_of(subject: Subject) -> Scenery:
    """All triangles of a subject at its start."""
    soup = Soup()
    if subject.scene is not None:
        add_objects(soup, subject.scene)
        ids = [p.id for p in subject.scene.placements]
    else:
        add_model(soup, subject.model, subject.data(), subject.things)
        ids = [thing.id for thing in subject.things]
    pieces: dict[int, list[Array]] = {}
    for mesh, patch in zip(soup.meshes, soup.patches, strict=True):
        pieces.setdefault(patch.owner, []).append(_thinned(mesh.vertices))
    bodies = tuple(Sighted(id, tuple(pieces.get(number, ()))) for number, id in enumerate(ids))
    rest = Sighted("", tuple(pieces.get(ROOM, ())))
    bounds = _room_bounds(subject.room) if subject.room else bounds_of([b.points for b in bodies], rest.pieces)
    return Scenery(subject, soup, bodies, rest, bounds)


def _thinned(vertices: Floats, most: int = 4000) -> Array:
    """Points of which at most some thousand are kept, those that reach furthest along the axes among them."""
    points = np.asarray(vertices, np.float64)
    if len(points) <= most:
        return points
    extreme = np.concatenate([points.argmin(0), points.argmax(0)])
    kept = np.unique(np.concatenate([extreme, np.arange(0, len(points), len(points) // most + 1)]))
    return np.asarray(points[kept])


def _room_bounds(room: Room) -> Bounds:
    x0, y0, x1, y1 = room.polygon.bounds
    return Bounds(np.array([x0, y0, 0.0]), np.array([x1, y1, room.height]))


@dataclass(frozen=True)
class Framing:
    """A camera and what it sees: triangles to be cast, and for each patch the number of its object."""

    camera: Camera
    tracer: Tracer
    owners: Ints
    sun: Floats

    def numbers(self, size: int) -> Ints:
        """The number of the object in each pixel, ROOM or below for none (size, size)."""
        y, x = (axis.ravel().astype(np.float32) + np.float32(0.5) for axis in np.mgrid[0:size, 0:size])
        front = see(self.tracer, self.camera, x, y, size).front
        return np.asarray(np.where(front < 0, ROOM, self.owners[front]).reshape(size, size), np.int32)


def three_quarter(scenery: Scenery, wanted: Collection[str] = ()) -> Framing:
    """From above one corner, with the near walls cut away; what hung on them is left out unless it is `wanted`."""
    if scenery.scene is not None:
        return _of_scene(scenery, scenery.scene, wanted)
    sights = [_of_model(scenery, azimuth) for azimuth in _CORNERS]
    return max(sights, key=lambda sight: _seen(sight, len(scenery.bodies)))


def from_above(scenery: Scenery) -> Framing:
    """Straight down, north up, the walls cut at breast height, what hangs overhead left out."""
    seen = [scenery.bounds.corners, *(body.points for body in scenery.in_sight)]
    points = np.concatenate(seen)
    outer = np.concatenate([points - THICKNESS, points + THICKNESS])
    camera = plan_camera(outer, margin=MARGIN, height=float(points[:, 2].max()) + 50.0)
    soup, scene = Soup(), scenery.scene
    if scene is not None:
        standing = (True,) * len(scene.room.walls)
        shell = Shell(standing, top=min(CUT_HEIGHT, scene.room.height), cut=CUT_THROUGH)
        add_room(soup, scene.room, scene.surfaces, shell)
        above = {p.id for p in overhead(scene)}
        _add(soup, scenery, {n for n, body in enumerate(scenery.bodies) if body.id in above})
    else:
        _add_opened(soup, scenery, None)
    return _sight(camera, soup, ABOVE)


def _of_scene(scenery: Scenery, scene: Scene, wanted: Collection[str]) -> Framing:
    view = best_view(scene)
    cut = {wall.name for wall, stands in zip(scene.room.walls, view.standing, strict=True) if not stands}
    mounted = {p.id for p in scene.placements if scene.asset_of(p).mount == "wall" and p.support in cut}
    soup = Soup()
    shell = Shell(view.standing)
    add_room(soup, scene.room, scene.surfaces, shell)
    _add(soup, scenery, {n for n, b in enumerate(scenery.bodies) if b.id in mounted and b.id not in wanted})
    points = np.concatenate([_outline(scene.room, view.standing), *(body.points for body in scenery.in_sight)])
    camera = framed(points, azimuth=view.azimuth, elevation=ELEVATION, margin=MARGIN)
    return _sight(camera, soup, _beside(view.azimuth))


def _outline(room: Room, standing: Sequence[bool]) -> Array:
    points = []
    for wall, stands in zip(room.walls, standing, strict=True):
        for along in (-THICKNESS, wall.length + THICKNESS):
            x, y = wall.point(along, -THICKNESS)
            points += [(x, y, -SLAB), (x, y, room.height if stands else RIM)]
    return np.array(points)


def _of_model(scenery: Scenery, azimuth: float) -> Framing:
    soup = Soup()
    _add_opened(soup, scenery, azimuth)
    points = np.concatenate([scenery.bounds.corners, *(body.points for body in scenery.in_sight)])
    return _sight(framed(points, azimuth=azimuth, elevation=ELEVATION, margin=MARGIN), soup, _beside(azimuth))


def _add(soup: Soup, scenery: Scenery, hidden: Collection[int]) -> None:
    """Add the objects but those whose numbers are hidden."""
    for mesh, patch in zip(scenery.soup.meshes, scenery.soup.patches, strict=True):
        if patch.owner not in hidden:
            _append(soup, mesh, patch)


def _add_opened(soup: Soup, scenery: Scenery, azimuth: float | None) -> None:
    """Add objects and room without what would hide them from a camera at this azimuth, or from above for None."""
    free = {number for number, thing in enumerate(scenery.subject.things) if thing.free}
    for mesh, patch in zip(scenery.soup.meshes, scenery.soup.patches, strict=True):
        kept = mesh if patch.owner in free else opened(mesh, scenery.bounds, azimuth, CUT_HEIGHT)
        if kept is not None:
            _append(soup, kept, patch)


def _append(soup: Soup, mesh: Mesh, patch: Patch) -> None:
    soup.meshes.append(mesh)
    soup.patches.append(patch)


def _sight(camera: Camera, soup: Soup, sun: Floats) -> Framing:
    triangles = soup.triangles()
    return Framing(camera, Tracer(triangles), np.array([p.owner for p in triangles.patches], np.int32), sun)


def _beside(azimuth: float) -> Floats:
    """A sun behind the left shoulder of who looks from this azimuth [degrees]."""
    turn, high = np.radians(azimuth - 21.0), np.radians(55.0)
    return np.array([np.cos(high) * np.cos(turn), np.cos(high) * np.sin(turn), np.sin(high)], np.float32)


def _seen(sight: Framing, count: int) -> float:
    """How much is seen: every object counts."""
    numbers = sight.numbers(_THUMBNAIL)
    pixels = np.bincount(numbers[numbers >= 0], minlength=count)
    return float(np.sqrt(pixels).sum())
