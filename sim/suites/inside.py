"""SceneEval's OutOfBound: from how much of an object's surface does a ray downwards meet the floor."""

import numpy as np
import shapely

from thinkblox.sim.suites.criteria import criterion, exempt, number
from thinkblox.sim.suites.meshes import MeshedThing, Meshes
from thinkblox.suite import Criterion, Finding

LEAST = 0.99
DENSITY, FEWEST, MOST = 5000.0, 1000, 100_000
"""Samples: so many for a cubic metre of the object's box, within these bounds."""
THICK, EDGE = 0.05, 1e-6
"""Thickness of the floor, and by how much its edge is widened against rounding [m]."""
SAYS = "from at least 99 % of the points on its surface a ray downwards meets the floor"


def out_of_bound(meshes: Meshes, generator: np.random.Generator) -> Criterion:
    """Every object against the floor's polygon."""
    if meshes.room is None:
        found: list[Finding] = [exempt(body.id, "the floor's outline is not known") for body in meshes.bodies]
        note = "the floor's outline is not known"
    else:
        floor, note = shapely.buffer(meshes.room.polygon, EDGE), ""
        shapely.prepare(floor)
        found = [_finding(body, floor, generator) for body in meshes.bodies]
    return criterion(
        "out_of_bound", SAYS, [*found, *meshes.soft], unit="share", limit=LEAST, least=True, note=note
    )  # fmt: skip


def _finding(body: MeshedThing, floor: shapely.Geometry, generator: np.random.Generator) -> Finding:
    count = int(min(max(body.box_volume * DENSITY, FEWEST), MOST))
    points = body.triangles.sample(count, generator)
    met = shapely.intersects_xy(floor, points[:, 0], points[:, 1]) & (points[:, 2] >= -THICK)
    share = float(np.mean(met))
    return Finding(object=body.id, value=number(share), passed=share >= LEAST, note=f"{count} points")
