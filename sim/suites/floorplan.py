"""SceneEval's Navigability and Accessibility: the free floor, by boxes drawn on a plan of the room."""

from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from thinkblox.scene.room import Room
from thinkblox.sim.suites.criteria import criterion, exempt, number
from thinkblox.sim.suites.meshes import GROUNDED, MeshedThing, Meshes
from thinkblox.suite import Criterion, Finding

ROBOT, PIXELS, MARGIN = 0.2, 256, 0.2
"""Width of the robot [m], side of the picture, and what it shows beyond the room [m]."""
OVERHEAD = 2.0
"""What has its middle higher is not in the way [m]."""
STRIP, GAP = 0.2, 0.05
"""Depth of the strip before a functional side, and how far off the side it begins [m]."""
NAVIGABLE, ACCESSIBLE = 0.9, 0.25
"""The source has no thresholds. A chair that is pushed in covers about half of a table's side."""
_UNKNOWN = "the floor's outline is not known"
_SIDES = ("front", "back", "left", "right")
_ALL_SIDES = ("chair", "stool")
_THREE_SIDES = ("bed",)


def navigability(meshes: Meshes) -> Criterion:
    """Share of the free floor that hangs together; what cuts it off is not known, so the scene is what fails."""
    name, says = "navigability", "at least 90 % of the floor that is free for a robot 0.2 m wide hangs together"
    if meshes.room is None:
        return criterion(name, says, [], unit="share", limit=NAVIGABLE, note=_UNKNOWN)
    sizes = components(_free(meshes.room, [b.footprint for b in meshes.bodies if b.middle <= OVERHEAD]))
    share = max(sizes, default=0) / max(1, sum(sizes))
    finding = Finding(object="scene", value=number(share), passed=share >= NAVIGABLE, note=f"{len(sizes)} parts")
    return criterion(name, says, [finding], unit="share", limit=NAVIGABLE, least=True)


def _free(room: Room, boxes: Sequence[BaseGeometry]) -> NDArray[np.bool_]:
    """The picture of where the robot's middle can be."""
    x0, y0, x1, y1 = room.polygon.bounds
    scale = max(x1 - x0, y1 - y0) / 2 + MARGIN
    line = ((np.arange(PIXELS) + 0.5) / PIXELS * 2.0 - 1.0) * scale
    x, y = np.meshgrid(line + (x0 + x1) / 2, line + (y0 + y1) / 2)
    floor = shapely.buffer(room.polygon, -ROBOT / 2, join_style="mitre")
    taken = shapely.union_all([shapely.buffer(box, ROBOT / 2, join_style="mitre") for box in boxes])
    shapely.prepare(floor)
    shapely.prepare(taken)
    free: NDArray[np.bool_] = shapely.contains_xy(floor, x, y) & ~shapely.contains_xy(taken, x, y)
    return free


def components(picture: NDArray[np.bool_]) -> list[int]:
    """Sizes of the parts of a picture that hang together, corners included, in pixels."""
    parents: list[int] = []
    sizes: list[int] = []

    def root(k: int) -> int:
        while parents[k] != k:
            k = parents[k]
        return k

    before: list[tuple[int, int, int]] = []
    for row in picture:
        steps = np.flatnonzero(np.diff(np.concatenate([[0], row.astype(np.int8), [0]])))
        now = []
        for start, end in steps.reshape(-1, 2).tolist():
            label = len(parents)
            parents.append(label)
            sizes.append(end - start)
            for other_start, other_end, other in before:
                if other_start <= end and start <= other_end:
                    parents[root(other)] = root(label)
            now.append((start, end, label))
        before = now
    totals: dict[int, int] = {}
    for label, size in enumerate(sizes):
        totals[root(label)] = totals.get(root(label), 0) + size
    return sorted(totals.values(), reverse=True)


def accessibility(meshes: Meshes) -> Criterion:
    """How much of the floor before each object's best functional side is free."""
    name, says = "accessibility", "at least a quarter of the strip before one of its functional sides is free floor"
    if meshes.room is None:
        found: list[Finding] = [exempt(body.id, _UNKNOWN) for body in meshes.bodies]
        return criterion(name, says, found, unit="share", limit=ACCESSIBLE, note=_UNKNOWN)
    boxes = [body.footprint for body in meshes.bodies if body.middle <= OVERHEAD]
    free = shapely.difference(meshes.room.polygon, shapely.union_all(boxes))
    found = [_access(body, free) for body in meshes.bodies]
    return criterion(name, says, [*found, *meshes.soft], unit="share", limit=ACCESSIBLE, least=True)


def _access(body: MeshedThing, free: BaseGeometry) -> Finding:
    sides = functional_sides(body)
    if not sides:
        return exempt(body.id, "it does not stand on the floor")
    shares = {side: _share(strip(body, side), free) for side in sides}
    best = max(shares, key=lambda side: shares[side])
    note = "; ".join(f"{side} {share:.2f}" for side, share in shares.items())
    return Finding(object=body.id, value=number(shares[best]), passed=shares[best] >= ACCESSIBLE, note=note)


def functional_sides(body: MeshedThing) -> tuple[str, ...]:
    """From which sides an object is used; none for what does not stand on the floor."""
    if body.placement is None or body.asset is None:
        return _SIDES if body.base < GROUNDED else ()
    if body.support != "ground":
        return ()
    words = body.asset.category.replace("-", "_").split("_")
    if body.asset.front != "one" or any(word in words for word in _ALL_SIDES):
        return _SIDES
    return ("front", "left", "right") if any(word in words for word in _THREE_SIDES) else ("front",)


def strip(body: MeshedThing, side: str) -> BaseGeometry:
    """The floor before one side of an object's box."""
    (x0, y0), (x1, y1) = body.extents
    ranges = {
        "front": ((x1 + GAP, x1 + GAP + STRIP), (y0, y1)),
        "back": ((x0 - GAP - STRIP, x0 - GAP), (y0, y1)),
        "left": ((x0, x1), (y1 + GAP, y1 + GAP + STRIP)),
        "right": ((x0, x1), (y0 - GAP - STRIP, y0 - GAP)),
    }
    return body.rectangle(*ranges[side])


def _share(area: BaseGeometry, free: BaseGeometry) -> float:
    return float(shapely.area(shapely.intersection(area, free)) / shapely.area(area))
