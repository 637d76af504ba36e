"""How far the things of a model are inside or outside a room, where one is known."""

import mujoco
import numpy as np

from thinkblox.scene.asset import Asset, Link, Shape
from thinkblox.scene.placement import Placement
from thinkblox.sim.foreign.triangles import colliding, geom_triangles
from thinkblox.sim.geometry.boundary import boundary_distance
from thinkblox.sim.geometry.solid import Solid
from thinkblox.sim.subject import Subject, Thing


def boundary_of(subject: Subject, data: mujoco.MjData) -> tuple[float, ...]:
    """Signed distance of every thing to the room's boundary [m]; 0 where there is no room or nothing to touch."""
    room = subject.room
    if room is None:
        return (0.0,) * len(subject.things)
    solids = (_solid(subject.model, data, thing) for thing in subject.things)
    return tuple(0.0 if solid is None else boundary_distance(room, _ORIGIN, solid) for solid in solids)


_ORIGIN = Placement(
    id="thing",
    category="thing",
    asset="thing",
    position=(0.0, 0.0, 0.0),
    yaw=0.0,
    size=(1.0, 1.0, 1.0),
    support="floor",
)


def _solid(model: mujoco.MjModel, data: mujoco.MjData, thing: Thing) -> Solid | None:
    """What of a thing can be touched, where it is, as an asset's shapes."""
    geoms = np.flatnonzero(np.isin(model.geom_bodyid, thing.bodies) & colliding(model))
    clouds = [geom_triangles(model, data, [geom]).vertices for geom in geoms.tolist()]
    shapes = tuple(
        Shape(kind="hull", size=(1.0, 1.0, 1.0), position=(0.0, 0.0, 0.0), points=tuple(map(tuple, cloud.tolist())))
        for cloud in clouds
        if len(cloud)
    )
    if not shapes:
        return None
    return Solid(
        Asset(
            id="thing",
            category="thing",
            description=thing.id,
            size=(1.0, 1.0, 1.0),
            mass=1.0,
            friction=0.5,
            mount="floor",
            links=(Link(name="thing", shapes=shapes),),
        )
    )
