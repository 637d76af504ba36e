"""Where the colliding pieces of placed objects are, as boxes along the room's axes, and who is near whom."""

from collections.abc import Collection, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.geometry.solid import Solid, pose, solid_of

Array = NDArray[np.float64]


class Boxes(NamedTuple):
    """Boxes along the axes: lowest and highest corners [m], each (n, 3)."""

    low: Array
    high: Array

    def meets(self, other: "Boxes", margin: float) -> NDArray[np.bool_]:
        """Which of these come within `margin` [m] of which of the others, (n, m)."""
        below = self.low[:, None, :] - margin <= other.high[None, :, :]
        above = self.high[:, None, :] + margin >= other.low[None, :, :]
        return np.asarray((below & above).all(axis=2))

    def whole(self) -> "Boxes":
        """The one box round all of these."""
        return Boxes(self.low.min(axis=0, keepdims=True), self.high.max(axis=0, keepdims=True))


def piece_boxes(solid: Solid, placement: Placement) -> Boxes:
    """A box round each colliding piece of a placed asset."""
    (points, starts), matrix = solid.cloud, pose(placement)
    placed = points @ matrix[:, :3].T + matrix[:, 3]
    return Boxes(np.minimum.reduceat(placed, starts, axis=0), np.maximum.reduceat(placed, starts, axis=0))


class Neighbours:
    """The objects of a scene that can be touched, found by place."""

    def __init__(self, scene: Scene) -> None:
        entries = [(p, scene.asset_of(p)) for p in scene.placements]
        self._placements = [p for p, asset in entries if asset.collides]
        self._solids = [solid_of(asset) for _, asset in entries if asset.collides]
        self._around = _around(self._placements, self._solids)
        self._number = {p.id: number for number, p in enumerate(self._placements)}
        self._boxes: dict[int, Boxes] = {}

    def with_object(self, placement: Placement, solid: Solid) -> "Neighbours":
        """These and one object more."""
        more = Neighbours.__new__(Neighbours)
        more.__dict__.update(self.__dict__)
        if solid.asset.collides:
            more._number = {**self._number, placement.id: len(self._placements)}
            more._placements, more._solids = [*self._placements, placement], [*self._solids, solid]
            more._boxes = dict(self._boxes)
            new = _around([placement], [solid])
            more._around = Boxes(np.vstack([self._around.low, new.low]), np.vstack([self._around.high, new.high]))
        return more

    def without(self, id: str) -> "Neighbours":
        """These, looking past one of them."""
        fewer = Neighbours.__new__(Neighbours)
        fewer.__dict__.update(self.__dict__)
        if id in self._number:
            low = self._around.low.copy()
            low[self._number[id]] = np.inf
            fewer._around = Boxes(low, self._around.high)
        return fewer

    def meetings(self, boxes: Boxes, margin: float) -> dict[str, NDArray[np.bool_]]:
        """Which of the boxes (n) come within `margin` [m] of which pieces (m) of an object, (n, m), by id."""
        found = {}
        for number in np.flatnonzero(boxes.whole().meets(self._around, margin)[0]).tolist():
            meets = boxes.meets(self._boxes_of(number), margin)
            if meets.any():
                found[self._placements[number].id] = meets
        return found

    def hanging_together(self, ids: Collection[str], margin: float) -> frozenset[str]:
        """These objects and all that hang together with them through free objects less than `margin` [m] apart."""
        found, ahead = set(ids), list(ids)
        while ahead:
            number = self._number[ahead.pop()]
            if self._solids[number].asset.free:
                more = self.meetings(self._boxes_of(number), margin).keys() - found
                found |= more
                ahead += more
        return frozenset(found)

    def falling_on(self, boxes: Boxes, margin: float) -> frozenset[str]:
        """Free objects over these boxes that nothing within `margin` [m] carries: they fall on what is put below."""
        column, found = boxes.whole(), frozenset[str]()
        column = Boxes(column.low, np.array([[*column.high[0, :2], np.inf]]))
        for number in np.flatnonzero(column.meets(self._around, margin)[0]).tolist():
            id = self._placements[number].id
            if id not in found and self._floats(number, margin):
                group = self.hanging_together((id,), margin)
                if id not in self._carried(group, margin):
                    found |= group
        return found

    def _carried(self, group: Collection[str], margin: float) -> set[str]:
        """Those of a group that stand on the floor, are fixed, or touch one of these that begins no higher."""
        carried = {id for id in group if not self._floats(self._number[id], margin)}
        ahead = list(carried)
        while ahead:
            number = self._number[ahead.pop()]
            highest = self._around.low[number, 2] - margin
            touching = self.meetings(self._boxes_of(number), margin).keys() & set(group)
            new = {id for id in touching - carried if self._around.low[self._number[id], 2] >= highest}
            carried |= new
            ahead += sorted(new)
        return carried

    def _floats(self, number: int, margin: float) -> bool:
        return self._solids[number].asset.free and bool(self._around.low[number, 2] > margin)

    def _boxes_of(self, number: int) -> Boxes:
        if number not in self._boxes:
            self._boxes[number] = piece_boxes(self._solids[number], self._placements[number])
        return self._boxes[number]


def _around(placements: Sequence[Placement], solids: Sequence[Solid]) -> Boxes:
    """A box round each object, from the turned box of its asset."""
    own = np.array([(solid.low, solid.high) for solid in solids]).reshape(-1, 2, 3)
    placed = placed_bounds(own, placements)
    return Boxes(placed[:, 0], placed[:, 1])


def placed_bounds(bounds: Array, placements: Sequence[Placement]) -> Array:
    """Boxes along the room's axes round boxes (n, 2, 3) in the frames of placements (n); empty ones stay empty [m]."""
    position = np.array([placement.position for placement in placements]).reshape(-1, 3)
    turn = np.radians([placement.yaw for placement in placements])
    c, s, zero, one = np.cos(turn), np.sin(turn), np.zeros_like(turn), np.ones_like(turn)
    rotation = np.array([[c, -s, zero], [s, c, zero], [zero, zero, one]]).transpose(2, 0, 1)
    some = np.asarray(np.isfinite(bounds).all(axis=(1, 2), keepdims=True))
    low, high = np.where(some, bounds, 0.0).transpose(1, 0, 2)
    middle = position + np.einsum("nij,nj->ni", rotation, (low + high) / 2)
    half = np.einsum("nij,nj->ni", np.abs(rotation), (high - low) / 2)
    half = np.where(some[:, 0], half, -np.inf)
    return np.stack([middle - half, middle + half], axis=1)
