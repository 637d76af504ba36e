"""The things of a subject as SceneEval sees them: triangle meshes, boxes turned about z, and what they stand on."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from shapely import Polygon

from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.sim.foreign.triangles import Triangles, colliding, geom_triangles, triangles_of
from thinkblox.sim.subject import Subject, Thing
from thinkblox.sim.suites.criteria import exempt
from thinkblox.suite import Finding

Floats = NDArray[np.float64]
Support = Literal["ground", "object", "wall", "ceiling", "unknown"]
GROUNDED = 0.05
"""In models that do not say what rests on what, lower things stand on the floor [m]."""


@dataclass(frozen=True)
class MeshedThing:
    """One thing with geometry.

    Attributes:
        id: the thing's.
        triangles: what of it can be touched.
        yaw: of its frame, about z [rad].
        support: what it is held by.
        placement, asset: where the subject was built of a scene.
    """

    id: str
    triangles: Triangles
    yaw: float
    support: Support
    placement: Placement | None = None
    asset: Asset | None = None

    @property
    def axes(self) -> Floats:
        """Rows: its front axis and its left axis on the floor."""
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        return np.array([[c, s], [-s, c]])

    @cached_property
    def extents(self) -> tuple[Floats, Floats]:
        """Lowest and highest (along the front axis, across) of its corners [m], measured from the world's origin."""
        local = self.triangles.vertices[:, :2] @ self.axes.T
        return local.min(axis=0), local.max(axis=0)

    @property
    def footprint(self) -> Polygon:
        """The box that holds it, seen from above, turned as it is."""
        low, high = self.extents
        return self.rectangle((low[0], high[0]), (low[1], high[1]))

    def rectangle(self, ahead: tuple[float, float], across: tuple[float, float]) -> Polygon:
        """A rectangle along its axes, in the terms of `extents` [m]."""
        (a, b), (c, d) = ahead, across
        return Polygon(np.array([[a, c], [b, c], [b, d], [a, d]]) @ self.axes)

    @property
    def base(self) -> float:
        """Height of its lowest point [m]."""
        return float(self.triangles.bounds[0][2])

    @property
    def top(self) -> float:
        """Height of its highest point [m]."""
        return float(self.triangles.bounds[1][2])

    @property
    def middle(self) -> float:
        """Height of its box's centre [m]."""
        return (self.base + self.top) / 2

    @property
    def box_volume(self) -> float:
        """Volume of the box that holds it, turned about z as it is [m3]."""
        low, high = self.extents
        return float(np.prod(high - low)) * (self.top - self.base)


class Meshes:
    """All things of a subject at its start, and the geometry of its world."""

    def __init__(self, subject: Subject) -> None:
        self.subject, self.room, self.data = subject, subject.room, subject.data()
        found = [self._body(thing) for thing in subject.things]
        self.bodies = tuple(body for body in found if not body.triangles.empty)
        self.soft: tuple[Finding, ...] = tuple(
            exempt(body.id, "nothing of it collides") for body in found if body.triangles.empty
        )

    def _body(self, thing: Thing) -> MeshedThing:
        model, scene = self.subject.model, self.subject.scene
        placement = scene[thing.id] if scene is not None and thing.id in scene else None
        return MeshedThing(
            id=thing.id,
            triangles=triangles_of(model, self.data, thing),
            yaw=_yaw(self.data.xmat[thing.root].reshape(3, 3)),
            support=self._support(thing, placement),
            placement=placement,
            asset=scene.asset_of(placement) if scene is not None and placement is not None else None,
        )

    def _support(self, thing: Thing, placement: Placement | None) -> Support:
        if placement is None:
            return "ground" if thing.free else "unknown"
        if placement.support == "floor":
            return "ground"
        if placement.support == "ceiling":
            return "ceiling"
        walls = {wall.name for wall in self.room.walls} if self.room is not None else set()
        return "wall" if placement.support in walls else "object"

    @cached_property
    def world(self) -> tuple[Triangles, ...]:
        """Floor, walls and what else belongs to no thing, geom by geom; planes as squares of 200 m."""
        model = self.subject.model
        owned = [body for thing in self.subject.things for body in thing.bodies]
        free = np.flatnonzero(~np.isin(model.geom_bodyid, owned) & colliding(model))
        parts = (geom_triangles(model, self.data, [int(geom)], plane=100.0) for geom in free)
        return tuple(part for part in parts if not part.empty)


def _yaw(matrix: Floats) -> float:
    """Heading of a frame [rad]: of its x axis, or of its y axis less a quarter turn where that one is more level."""
    x, y = matrix[:, 0], matrix[:, 1]
    if np.hypot(x[0], x[1]) >= np.hypot(y[0], y[1]) - 1e-9:
        return float(np.arctan2(x[1], x[0]))
    return float(np.arctan2(y[1], y[0]) - np.pi / 2)
