"""Taking the inventory of a scene from the model that was measured."""

import re
from collections.abc import Iterator
from typing import Any

import mujoco
import numpy as np
from msgspec import structs
from numpy.typing import NDArray

from thinkblox.exporters.hung import with_doors
from thinkblox.exporters.inventory import (
    Inventory,
    InventoryBody,
    InventoryGeom,
    InventoryJoint,
    InventoryLook,
    InventoryObject,
    InventoryWall,
)
from thinkblox.exporters.looks import covering_look, finish_look, look_of
from thinkblox.exporters.naming import Names
from thinkblox.scene.asset import Link, Shape
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import MAX_EXTENT
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import GROUND, build_spec, compiled
from thinkblox.sim.geometry.solid import solid_of, weighing
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.settle import Pose, SettledState, settle
from thinkblox.value import Quat, Vec3

_NO_WORD = re.compile(r"[\d\W_]+")


def inventory_of(
    scene: Scene, *, settled: SettledState | None = None, physics: Physics | None = None, doors: bool = False
) -> Inventory:
    """What a scene is made of, where it stands and where it comes to rest.

    Args:
        scene: what to take stock of.
        settled: the state at rest, where it is known already; worked out otherwise.
        physics: the engine's options.
        doors: with a leaf on a hinge in each door and a pane in each window, which were not measured.
    """
    physics = physics or Physics()
    settled = settled or settle(scene, physics=physics)
    if doors:
        scene, settled = with_doors(scene, settled, physics)
    return _Stocktaking(scene, physics, settled, doors=doors).inventory()


class _Stocktaking:
    """A compiled scene at its proposed and at its settled pose, and the looks found so far."""

    def __init__(self, scene: Scene, physics: Physics, settled: SettledState, *, doors: bool) -> None:
        self._scene, self._physics, self._settled, self._doors = scene, physics, settled, doors
        self._model = compiled(build_spec(scene, physics=physics))
        self._start, self._rest = (_state(self._model, qpos) for qpos in (self._model.qpos0, settled.qpos))
        self._looks: dict[str, InventoryLook] = {}
        # Of two frictions the engine takes the larger, others the mean or the product: so floor and walls have the
        # least of any object's, which is never more than the engine took.
        kinds = [scene.asset_of(placement) for placement in scene.placements]
        self._least = min((kind.friction for kind in kinds if kind.collides), default=0.0)
        room = scene.room
        self._names = Names(("world", GROUND, "ceiling", *(w.name for w in room.walls), *(o.id for o in room.openings)))
        self._objects = self._names.give_all(placement.id for placement in scene.placements)

    def inventory(self) -> Inventory:
        """All of it."""
        walls = tuple(self._walls())
        objects = tuple(self._object(placement) for placement in self._scene.placements)
        return Inventory(self._scene, self._physics, walls, objects, self._looks, self._settled, self._doors)

    def _walls(self) -> Iterator[InventoryWall]:
        surfaces, room = self._scene.surfaces, self._scene.room
        coverings = {GROUND: surfaces.floor} | {w.name: surfaces.of_wall(i) for i, w in enumerate(room.walls)}
        boxes: dict[str, list[InventoryGeom]] = {name: [] for name in (GROUND, *(wall.name for wall in room.walls))}
        for number in range(int(self._model.body_geomnum[0])):
            geom = self._model.geom(number)
            boxes[geom.name.partition("/")[0]].append(self._slab(number))
        for name, geoms in boxes.items():
            label = "floor" if name == GROUND else "wall"
            yield InventoryWall(name, label, self._known(covering_look(coverings[name])), tuple(geoms))

    def _slab(self, number: int) -> InventoryGeom:
        model = self._model
        box = Shape(
            kind="box",
            # Under the walls of the largest room the floor ends with the room: no shape is larger.
            size=_vec3(np.minimum(2.0 * model.geom_size[number], MAX_EXTENT)),
            position=_vec3(model.geom_pos[number]),
            quat_wxyz=_quat(model.geom_quat[number]),
        )
        sliding, torsion, rolling = _vec3(model.geom_friction[number])
        return InventoryGeom(shape=box, collides=True, friction=(max(sliding, self._least), torsion, rolling))

    def _object(self, placement: Placement) -> InventoryObject:
        asset, id, name = self._scene.asset_of(placement), placement.id, self._objects[placement.id]
        first, *rest = zip(asset.links, solid_of(asset).masses, strict=True)
        fixed = [first, *((link, masses) for link, masses in rest if link.joint is None)]
        bodies = [self._body(placement, id, fixed)]
        for link, masses in rest:
            if link.joint is not None:
                bodies.append(self._body(placement, f"{id}/{link.name}", [(link, masses)]))
        category, free = placement.category, asset.free
        return InventoryObject(id, name, category, asset.id, asset.licence, asset.author, free, tuple(bodies))

    def _body(self, placement: Placement, source: str, links: list[tuple[Link, tuple[float, ...]]]) -> InventoryBody:
        model, body, link = self._model, int(self._model.body(source).id), links[0][0]
        root, name = int(model.body(placement.id).id), self._objects[placement.id]
        # Which friction a geom has, the model says: its geoms are those shapes that collide or weigh, in their order.
        friction = iter(model.geom_friction[model.geom_bodyid == body])
        origin = np.zeros(3) if link.joint is None else np.asarray(link.joint.anchor)
        return InventoryBody(
            name=name if body == root else self._names.give(f"{name}_{link.name}"),
            source=source,
            link=link.name,
            label=placement.category if body == root else _plain(link.name),
            parent=None if body == root else name,
            joint=self._joint(source, link),
            proposed=_pose(self._start, body, origin),
            settled=_pose(self._rest, body, origin),
            in_object=_relative(self._rest, body, root, origin),
            mass=float(model.body_mass[body]),
            centre=_vec3(model.body_ipos[body] - origin),
            inertia=_vec3(model.body_inertia[body]),
            axes=_quat(model.body_iquat[body]),
            geoms=tuple(geom for link, masses in links for geom in self._geoms(link, masses, friction, origin)),
        )

    def _joint(self, source: str, link: Link) -> InventoryJoint | None:
        if link.joint is None:
            return None
        dof = int(self._model.joint(source).dofadr[0])
        return InventoryJoint(
            kind=link.joint.kind,
            axis=link.joint.axis,
            anchor=link.joint.anchor,
            lower=link.joint.lower,
            upper=link.joint.upper,
            friction=float(self._model.dof_frictionloss[dof]),
            damping=float(self._model.dof_damping[dof]),
        )

    def _geoms(
        self,
        link: Link,
        masses: tuple[float, ...],
        friction: Iterator[NDArray[np.float64]],
        origin: NDArray[np.float64],
    ) -> Iterator[InventoryGeom]:
        mass_of = dict(zip(map(id, weighing(link)), masses, strict=True))
        for shape in link.shapes:
            mass = mass_of.get(id(shape), 0.0)
            rubbing = next(friction) if shape.collide or mass else np.zeros(3)
            look = None if link.visuals else self._known(finish_look(shape.material, shape.colour))
            yield InventoryGeom(
                shape=_moved(shape, origin),
                look=look,
                collides=shape.collide,
                mass=mass,
                friction=_vec3(rubbing) if shape.collide else (0.0, 0.0, 0.0),
            )
        for visual in link.visuals:
            yield InventoryGeom(mesh=visual.mesh, look=self._known(look_of(visual.look)), offset=_vec3(0.0 - origin))

    def _known(self, look: InventoryLook) -> str:
        self._looks.setdefault(look.name, look)
        return look.name


def _state(model: mujoco.MjModel, qpos: Any) -> mujoco.MjData:
    data = mujoco.MjData(model)
    data.qpos[:] = qpos
    mujoco.mj_kinematics(model, data)
    return data


def _pose(data: mujoco.MjData, body: int, origin: NDArray[np.float64]) -> Pose:
    """Pose in the room of a body whose frame begins at a point of the model's [m]."""
    return _vec3(data.xpos[body] + data.xmat[body].reshape(3, 3) @ origin), _quat(data.xquat[body])


def _relative(data: mujoco.MjData, body: int, root: int, origin: NDArray[np.float64]) -> Pose:
    """The same in the frame of another body."""
    back, position, turn = np.zeros(4), np.zeros(3), np.zeros(4)
    mujoco.mju_negQuat(back, data.xquat[root])
    mujoco.mju_rotVecQuat(position, _pose(data, body, origin)[0] - data.xpos[root], back)
    mujoco.mju_mulQuat(turn, back, data.xquat[body])
    return _vec3(position), _quat(turn)


def _moved(shape: Shape, origin: NDArray[np.float64]) -> Shape:
    """A shape in a frame that begins at a point of its own [m]."""
    return structs.replace(shape, position=_vec3(shape.position - origin)) if origin.any() else shape


def _plain(link: str) -> str:
    """What a link is, without its number: "door 1.1" is a door."""
    return _NO_WORD.sub(" ", link).strip().lower() or "part"


def _vec3(values: Any) -> Vec3:
    x, y, z = (float(value) for value in values)
    return (x, y, z)


def _quat(values: Any) -> Quat:
    w, x, y, z = (float(value) for value in values)
    return (w, x, y, z)
