"""The doors and drawers of an asset on their way from shut to open, worked out once per asset."""

import math
from dataclasses import dataclass
from functools import cached_property

import fcl
import numpy as np
from manifold3d import Manifold

from thinkblox.scene.asset import Asset, Joint, Link, Shape
from thinkblox.scene.corners import rotation
from thinkblox.scene.derived import kept
from thinkblox.sim.geometry.collider import collider
from thinkblox.sim.geometry.solid import Array, Solid, shape_points

STEP = 0.015
"""How far the tip of a door moves between two looks [m]; what stands in its way is thicker, together with the door."""
FINEST = 0.005
"""To which share of its range the end of an opening is found."""
TOLERATED = 0.001
"""How deep a door may graze something on its way [m]."""
_CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])


@dataclass(frozen=True)
class Piece:
    """One convex shape: its geometry, where that is in the asset's frame, and the shape's bounding box there [m]."""

    geometry: fcl.CollisionGeometry
    turn: Array
    shift: Array
    bounds: Array


class Sweep:
    """One door or drawer, looked at in steps from shut (step 0) to open.

    Attributes:
        link: what opens.
        values: of its joint at each step, shape (k,) [degrees or m].
        bounds: bounding boxes of its shapes at each step in the asset's frame, shape (k, s, 2, 3) [m].
    """

    def __init__(self, link: Link, joint: Joint) -> None:
        self.link, self._joint = link, joint
        shapes = [shape for shape in link.shapes if shape.collide]
        self._bodies = [body_of(shape, less=TOLERATED) for shape in shapes]
        points = [shape_points(shape) for shape in shapes]
        end = joint.upper if abs(joint.upper) >= abs(joint.lower) else joint.lower
        self.values = np.linspace(0.0, end, 1 + _steps(joint, np.vstack(points), end)) if shapes else np.zeros(1)
        poses = [self._pose(value) for value in self.values]
        placed = [[p @ turn.T + shift for p in points] for turn, shift in poses]
        self.bounds = np.array(
            [[[p.min(axis=0) + TOLERATED, p.max(axis=0) - TOLERATED] for p in row] for row in placed]
        )
        self._objects = [fcl.CollisionObject(body.geometry) for body in self._bodies]

    def put(self, value: float) -> list[fcl.CollisionObject]:
        """Its shapes, less the tolerated depth all round, in the asset's frame where the joint is at a value."""
        turn, shift = self._pose(value)
        for body, moved in zip(self._bodies, self._objects, strict=True):
            moved.setTransform(fcl.Transform(turn @ body.turn, turn @ body.shift + shift))
        return self._objects

    def share(self, value: float) -> float:
        """The share of the range that a value opens, 0 to 1."""
        return float(value / self.values[-1]) if self.values[-1] else 1.0

    def _pose(self, value: float) -> tuple[Array, Array]:
        axis = np.asarray(self._joint.axis)
        if self._joint.kind == "slide":
            return np.eye(3), axis * value
        half, anchor = math.radians(value) / 2, np.asarray(self._joint.anchor)
        turn = rotation((math.cos(half), *(axis * math.sin(half)).tolist()))
        return turn, anchor - turn @ anchor


class Swept:
    """All that an asset collides with and opens."""

    def __init__(self, asset: Asset) -> None:
        self._asset = asset

    @cached_property
    def bodies(self) -> tuple[Piece, ...]:
        """Its colliding shapes, shut."""
        return tuple(body_of(shape) for link in self._asset.links for shape in link.shapes if shape.collide)

    @cached_property
    def bounds(self) -> Array:
        """Bounding box of those in its own frame, shape (2, 3) [m]."""
        return _around([body.bounds for body in self.bodies])

    @cached_property
    def sweeps(self) -> tuple[Sweep, ...]:
        """Its doors and drawers."""
        jointed = ((link, link.joint) for link in self._asset.links)
        found = (Sweep(link, joint) for link, joint in jointed if joint is not None)
        return tuple(sweep for sweep in found if sweep.values[-1] != 0.0)

    @cached_property
    def reach(self) -> Array:
        """Bounding box of all that its doors and drawers sweep in its own frame, shape (2, 3) [m]; empty if none."""
        return _around([box for sweep in self.sweeps for box in sweep.bounds.reshape(-1, 2, 3)])


@kept
def moving_of(solid: Solid) -> Swept:
    """The one `Swept` of a solid."""
    return Swept(solid.asset)


def body_of(shape: Shape, *, less: float = 0.0) -> Piece:
    """A shape for boolean collision tests, `less` thick a skin taken off it [m].

    Thin shapes keep a tenth of their thickness; a hull is drawn in along its axes.
    """
    half = np.asarray(shape.size) / 2
    drawn = np.maximum(half - less, half / 10)
    turn, shift, points = rotation(shape.quat_wxyz), np.asarray(shape.position), shape_points(shape)
    if shape.kind == "hull":
        local = np.asarray(collider(shape).points)
        middle = (local.min(axis=0) + local.max(axis=0)) / 2
        geometry = _convex((local - middle) * (drawn / half))
        shift = shift + turn @ middle
    else:
        geometry = _primitive(shape, drawn)
    return Piece(geometry, turn, shift, np.array([points.min(axis=0), points.max(axis=0)]))


def _primitive(shape: Shape, half: Array) -> fcl.CollisionGeometry:
    x, y, z = half.tolist()
    if shape.kind == "box":
        return fcl.Box(2 * x, 2 * y, 2 * z)
    if shape.kind == "cylinder":
        return fcl.Cylinder(x, 2 * z)
    if shape.kind == "capsule":
        return fcl.Capsule(x, 2 * (z - x))
    return fcl.Ellipsoid(x, y, z)


def _convex(points: Array) -> fcl.CollisionGeometry:
    mesh = Manifold.hull_points(points).to_mesh64()
    corners, faces = np.asarray(mesh.vert_properties)[:, :3], np.asarray(mesh.tri_verts)
    rows = np.column_stack([np.full(len(faces), 3), faces]).ravel()
    return fcl.Convex(corners, len(faces), rows)


def _steps(joint: Joint, points: Array, end: float) -> int:
    if joint.kind == "slide":
        return max(1, math.ceil(abs(end) / STEP))
    arms = points - np.asarray(joint.anchor)
    radius = float(np.linalg.norm(np.cross(arms, np.asarray(joint.axis)), axis=1).max())
    return max(1, math.ceil(abs(math.radians(end)) * radius / STEP))


def _around(boxes: list[Array]) -> Array:
    if not boxes:
        return np.array([[math.inf] * 3, [-math.inf] * 3])
    return np.array([np.min([box[0] for box in boxes], axis=0), np.max([box[1] for box in boxes], axis=0)])


def turned_bounds(bounds: Array, turn: Array, shift: Array) -> Array:
    """Bounding boxes, shape (..., 2, 3), of boxes after a rotation and a shift."""
    low, high = bounds[..., None, 0, :], bounds[..., None, 1, :]
    corners = (low + _CORNERS * (high - low)) @ turn.T + shift
    return np.stack([corners.min(axis=-2), corners.max(axis=-2)], axis=-2)
