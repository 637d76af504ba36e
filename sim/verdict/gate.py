"""How deep candidates for one object are in others before anything moves, from one small model of what can touch."""

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.asset import Asset, Shape
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import add_geom, compiled, new_spec, yaw_quat
from thinkblox.sim.geometry.bounds import Neighbours, piece_boxes
from thinkblox.sim.geometry.overlap import overlap_volume
from thinkblox.sim.geometry.solid import solid_of
from thinkblox.sim.settings import Physics
from thinkblox.verdict import Collision

ASIDE = (1.3e-5, -2.1e-5, 1.7e-5)
"""A candidate is measured this far from its place [m]: MuJoCo 3.17 finds no contact at all, or a shallow one, in about
one in a hundred of the poses that are exactly aligned with what is there."""
RANGE = 1e-6
"""Distances above this are not worked out [m]."""
NEAR = 0.001
"""Pieces whose boxes are farther apart than this are not looked at [m]."""


class Touch(NamedTuple):
    """Contact with another object: its depth [m], and the pieces of each that touch."""

    depth: float
    mine: frozenset[int]
    theirs: frozenset[int]


class Gate:
    """Measures contacts between candidate placements of an asset and a scene's objects.

    Attributes:
        boxes: round the pieces of each candidate.
    """

    def __init__(
        self, scene: Scene, neighbours: Neighbours, asset: Asset, candidates: Sequence[Placement], physics: Physics
    ) -> None:
        self._scene, self._asset = scene, asset
        solid = solid_of(asset)
        self.boxes = {candidate: piece_boxes(solid, candidate) for candidate in candidates}
        meetings = [neighbours.meetings(self.boxes[candidate], NEAR) for candidate in candidates]
        self._meetings = dict(zip(candidates, meetings, strict=True))
        self._touches: dict[Placement, dict[str, Touch]] = {}
        self._world = _PieceWorld(scene, asset, meetings, physics) if any(meetings) else None

    def touches(self, candidate: Placement) -> dict[str, Touch]:
        """What one of the candidates touches, by id."""
        if candidate not in self._touches:
            meets = self._meetings[candidate]
            self._touches[candidate] = {} if self._world is None or not meets else self._world.touches(candidate, meets)
        return self._touches[candidate]

    def collisions(self, candidate: Placement, tolerance: float) -> tuple[Collision, ...]:
        """What one of the candidates is in, deeper than `tolerance` [m], deepest first."""
        found = [
            self._collision(candidate, other, touch)
            for other, touch in self.touches(candidate).items()
            if touch.depth > tolerance
        ]
        return tuple(sorted(found, key=lambda c: (-c.depth, c.other)))

    def _collision(self, candidate: Placement, other: str, touch: Touch) -> Collision:
        theirs, mine = self._scene[other], solid_of(self._asset)
        solid = solid_of(self._scene.asset_of(theirs))
        volume = overlap_volume(mine, candidate, solid, theirs, pieces=(touch.mine, touch.theirs))
        ratio = min(1.0, volume / mine.volume)
        return Collision(other=other, depth=round(touch.depth, 6), overlap=round(ratio, 6))


class _PieceWorld:
    """A model of the pieces near the candidates, standing still, and of the asset, which can be put anywhere."""

    def __init__(
        self, scene: Scene, asset: Asset, meetings: Sequence[Mapping[str, NDArray[np.bool_]]], physics: Physics
    ) -> None:
        spec = new_spec(physics)
        spec.option.ccd_iterations = 100
        self._theirs: dict[tuple[str, int], int] = {}
        for placement in scene.placements:
            pieces = _needed(meets[placement.id] for meets in meetings if placement.id in meets)
            if pieces:
                _add_body(spec, placement, [solid_of(scene.asset_of(placement)).colliders[piece] for piece in pieces])
                self._theirs |= {(placement.id, piece): len(self._theirs) + n for n, piece in enumerate(pieces)}
        mine = _needed(meets.T for found in meetings for meets in found.values())
        self._mine = {piece: len(self._theirs) + n for n, piece in enumerate(mine)}
        body = _add_body(spec, None, [solid_of(asset).colliders[piece] for piece in mine])
        body.add_freejoint()
        self._model = compiled(spec)
        self._data = mujoco.MjData(self._model)

    def touches(self, candidate: Placement, meetings: Mapping[str, NDArray[np.bool_]]) -> dict[str, Touch]:
        """What the asset touches where a candidate puts it, by id; `meetings` are the pieces whose boxes meet."""
        data = self._data
        data.qpos[:] = (*np.add(candidate.position, ASIDE), *yaw_quat(candidate.yaw))
        mujoco.mj_kinematics(self._model, data)
        found = {other: self._touch(other, meets) for other, meets in meetings.items()}
        return {other: touch for other, touch in found.items() if touch.mine}

    def _touch(self, other: str, meets: NDArray[np.bool_]) -> Touch:
        depth, mine, theirs = 0.0, set(), set()
        for my, their in np.argwhere(meets).tolist():
            first, second = self._theirs[other, their], self._mine[my]
            dist = mujoco.mj_geomDistance(self._model, self._data, first, second, RANGE, None)
            if dist < 0.0:
                depth = max(depth, -dist)
                mine.add(my)
                theirs.add(their)
        return Touch(depth, frozenset(mine), frozenset(theirs))


def _add_body(spec: mujoco.MjSpec, placement: Placement | None, shapes: Sequence[Shape]) -> mujoco.MjsBody:
    body = spec.worldbody.add_body()
    if placement is not None:
        body.pos, body.quat = placement.position, yaw_quat(placement.yaw)
    for shape in shapes:
        add_geom(spec, body, shape)
    return body


def _needed(meetings: Iterable[NDArray[np.bool_]]) -> list[int]:
    """Numbers of the columns in which any of these has a meeting."""
    found: set[int] = set()
    for meets in meetings:
        found.update(np.flatnonzero(meets.any(axis=0)).tolist())
    return sorted(found)
