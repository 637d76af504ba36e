"""What stands on what: whatever rests on an object goes where that goes."""

from collections.abc import Iterable

import numpy as np

from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec3


def riders(scene: Scene, id: str) -> tuple[Placement, ...]:
    """What rests on an object, and on that."""
    found: dict[str, Placement] = {}
    todo = [id]
    while todo:
        for placement in scene.resting_on(todo.pop()):
            if placement.id not in found and placement.id != id:
                found[placement.id] = placement
                todo.append(placement.id)
    return tuple(found.values())


def carriers(scene: Scene, id: str) -> tuple[str, ...]:
    """Ids of what is below an object, the nearest first."""
    found: list[str] = []
    below = scene[id].support
    while below in scene and below not in (id, *found):
        found.append(below)
        below = scene[below].support
    return tuple(found)


def group_mass(scene: Scene, id: str) -> float:
    """Mass of an object with all that rests on it [kg]."""
    return sum(scene.asset_of(p).mass for p in (scene[id], *riders(scene, id)))


def without(scene: Scene, ids: Iterable[str]) -> Scene:
    """The scene without some objects."""
    for id in sorted(ids):
        scene = scene.without(id)
    return scene


def with_shifted(scene: Scene, moved: Placement) -> Scene:
    """The scene with one object at another place, and what rests on it shifted alike."""
    by = np.subtract(moved.position, scene[moved.id].position)
    for rider in riders(scene, moved.id):
        scene = scene.moved(rider.id, position=to_micrometres(rider.position + by))
    return scene.with_placement(moved, scene.asset_of(moved))


def apart(a: Placement, b: Placement) -> float:
    """Horizontal distance between the circles round two footprints: their own distance is no less [m]."""
    radii = (np.hypot(*a.size[:2]) + np.hypot(*b.size[:2])) / 2
    return float(np.hypot(a.position[0] - b.position[0], a.position[1] - b.position[1]) - radii)


def to_micrometres(position: np.ndarray) -> Vec3:
    """A position rounded as it is written."""
    x, y, z = (round(float(c), 6) for c in position)
    return (x, y, z)
