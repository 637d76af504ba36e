"""The reference for cut-down worlds: everything in the room is built, and everything is looked at."""

import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.scene import Scene
from thinkblox.sim.geometry.bounds import Boxes, Neighbours
from thinkblox.sim.geometry.solid import solid_of
from thinkblox.sim.verdict.world import World


class Everybody(Neighbours):
    """Neighbours that are all near, wherever they are."""

    def __init__(self, scene: Scene) -> None:
        super().__init__(scene)
        self._pieces = {
            p.id: len(solid_of(scene.asset_of(p)).colliders) for p in scene.placements if scene.asset_of(p).collides
        }

    def meetings(self, boxes: Boxes, margin: float) -> dict[str, NDArray[np.bool_]]:
        return {id: np.ones((len(boxes.low), pieces), dtype=np.bool_) for id, pieces in self._pieces.items()}


def whole_room(scene: Scene) -> World:
    """A world that measures every candidate in the whole room, built from nothing."""
    world = World(scene)
    world._neighbours = Everybody(scene)
    return world
