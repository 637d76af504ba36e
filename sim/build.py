"""A Scene as one MjSpec: what the verdicts compile is what the exporters dress and write."""

import hashlib
import math
from collections.abc import Container

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.errors import InputError
from thinkblox.scene.asset import Asset, Joint, Link, Shape
from thinkblox.scene.derived import kept
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene, scene_given
from thinkblox.sim.geometry.collider import collider
from thinkblox.sim.geometry.solid import solid_of, weighing
from thinkblox.sim.geometry.walls import wall_slabs
from thinkblox.sim.settings import Physics
from thinkblox.version import package_version as package_version

GROUND = "floor"
"""Name of the floor's geom; the walls' geoms are named after the walls."""
FREE_SUFFIX = "_free"
GEOM_TYPES = {
    "box": mujoco.mjtGeom.mjGEOM_BOX,
    "cylinder": mujoco.mjtGeom.mjGEOM_CYLINDER,
    "capsule": mujoco.mjtGeom.mjGEOM_CAPSULE,
    "sphere": mujoco.mjtGeom.mjGEOM_SPHERE,
    "ellipsoid": mujoco.mjtGeom.mjGEOM_ELLIPSOID,
    "hull": mujoco.mjtGeom.mjGEOM_MESH,
}
COLLISION, VISUAL = "collision", "visual"
"""The default classes of geoms: what is touched, and what weighs or is looked at only."""
COLLISION_GROUP, VISUAL_GROUP = 3, 2
"""Their groups; a viewer shows the first only when asked to."""
ROLLING = ("sphere", "ellipsoid", "capsule")
TORSION, ROLL = 0.005, 0.001
"""Torsional and rolling friction [m]; only what can roll feels the second."""
DOOR_FRICTION, DOOR_DAMPING = 0.2, 0.1
"""Of a hinge with its catch [N m, N m s/rad]."""
DRAWER_FRICTION, DRAWER_DAMPING = 2.0, 5.0
"""Of a drawer's slide [N, N s/m]."""


def build_spec(
    scene: Scene,
    *,
    physics: Physics | None = None,
    sleeping: bool = False,
    only: Container[str] | None = None,
) -> mujoco.MjSpec:
    """The model of a scene: one body per placement, named by its id, in the order of the placements.

    Free things have a freejoint "<id>_free"; the links of an asset are child bodies "<id>/<link>" with a joint of the
    same name. The order and names of bodies and joints do not depend on the options.

    Args:
        scene: the room and what stands in it.
        physics: the engine's options.
        sleeping: every body starts asleep and sleep is enabled: for checks of one object against a still room.
        only: ids of the objects that are built; the others are left out.
    """
    scene, physics = scene_given(scene), physics or Physics()
    spec = new_spec(physics)
    add_room(spec, scene.room, physics)
    for placement in scene.placements:
        if only is None or placement.id in only:
            add_placement(spec, placement, scene.asset_of(placement), asleep=sleeping)
    if sleeping:
        spec.option.enableflags |= mujoco.mjtEnableBit.mjENBL_SLEEP
    return spec


def compiled(spec: mujoco.MjSpec) -> mujoco.MjModel:
    """Compile a spec.

    Raises:
        InputError: the engine cannot build it; says what it said.
    """
    try:
        return spec.compile()
    except ValueError as error:
        raise InputError(f"MuJoCo cannot build the scene: {' '.join(str(error).split())}") from error


def new_spec(physics: Physics) -> mujoco.MjSpec:
    """An empty model with this package's options, default classes and version."""
    spec = mujoco.MjSpec()
    spec.modelname = "thinkblox"
    option = spec.option
    option.timestep, option.gravity, option.impratio = physics.timestep, physics.gravity, physics.impratio
    option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.compiler.usethread = False
    spec.default.geom.solref[:] = physics.solref
    visual = spec.add_default(VISUAL, spec.default).geom
    visual.contype, visual.conaffinity, visual.group, visual.mass = 0, 0, VISUAL_GROUP, 0.0
    spec.add_default(COLLISION, spec.default).geom.group = COLLISION_GROUP
    spec.add_text(name="thinkblox", data=f"thinkblox {package_version()}, mujoco {mujoco.__version__}")
    return spec


def add_room(spec: mujoco.MjSpec, room: Room, physics: Physics) -> None:
    """Add the floor and the walls to the world body, all boxes.

    The floor is no plane: MuJoCo 3.17 throws cylinders up that stand on one upright to within 1e-14 rad, since its
    plane-cylinder collider normalises a difference that is all rounding error.
    """
    world, (x0, y0, x1, y1) = spec.worldbody, room.polygon.bounds
    friction = (physics.ground_friction, TORSION, ROLL)
    solid = spec.find_default(COLLISION)
    floor = world.add_geom(solid, name=GROUND, type=mujoco.mjtGeom.mjGEOM_BOX, friction=friction)
    half, rim = physics.floor_thickness / 2, physics.wall_thickness
    floor.pos = ((x0 + x1) / 2, (y0 + y1) / 2, -half)
    floor.size = ((x1 - x0) / 2 + rim, (y1 - y0) / 2 + rim, half)
    for slab in wall_slabs(room, physics.wall_thickness):
        geom = world.add_geom(solid, name=slab.name, type=mujoco.mjtGeom.mjGEOM_BOX, friction=friction)
        geom.pos, geom.size, geom.quat = slab.position, np.asarray(slab.size) / 2, yaw_quat(slab.yaw)


def yaw_quat(yaw: float) -> tuple[float, float, float, float]:
    """The quaternion wxyz of a turn about z [degrees]."""
    half = math.radians(yaw) / 2
    return (math.cos(half), 0.0, 0.0, math.sin(half))


def add_placement(
    spec: mujoco.MjSpec,
    placement: Placement,
    asset: Asset,
    *,
    free: bool | None = None,
    asleep: bool = False,
    name: str | None = None,
) -> None:
    """Add one object; `free` overrides whether it has a freejoint, and what has one can start asleep.

    Its body is called as the placement is, or `name`.
    """
    id, masses = name or placement.id, solid_of(asset).masses
    root = spec.worldbody.add_body(name=id, pos=placement.position, quat=yaw_quat(placement.yaw))
    if asset.free if free is None else free:
        root.add_freejoint(name=id + FREE_SUFFIX)
        root.sleep = mujoco.mjtSleepPolicy.mjSLEEP_INIT if asleep else mujoco.mjtSleepPolicy.mjSLEEP_AUTO
    bodies = {asset.links[0].name: root}
    for number, (link, link_masses) in enumerate(zip(asset.links, masses, strict=True)):
        body = root
        if number and link.joint is not None:
            body = root.add_body(name=f"{id}/{link.name}")
            _add_joint(body, link.joint, opening_moment(link, link_masses))
            bodies[link.name] = body
        _add_shapes(spec, body, link, link_masses, asset)
    _exclude_each_other(spec, [body.name for body in bodies.values()])


def _exclude_each_other(spec: mujoco.MjSpec, names: list[str]) -> None:
    for i, first in enumerate(names):
        for second in names[i + 1 :]:
            spec.add_exclude(bodyname1=first, bodyname2=second)


def _add_joint(body: mujoco.MjsBody, joint: Joint, moment: float) -> None:
    slide = joint.kind == "slide"
    friction = DRAWER_FRICTION if slide else DOOR_FRICTION
    body.add_joint(
        name=body.name,
        type=mujoco.mjtJoint.mjJNT_SLIDE if slide else mujoco.mjtJoint.mjJNT_HINGE,
        axis=joint.axis,
        pos=joint.anchor,
        limited=True,
        range=(joint.lower, joint.upper),
        frictionloss=friction + 1.5 * max(0.0, moment),
        damping=DRAWER_DAMPING if slide else DOOR_DAMPING,
    )


def opening_moment(link: Link, masses: tuple[float, ...]) -> float:
    """What a link's weight does to its joint at rest [N m, or N for a slide]; positive pulls it open."""
    if link.joint is None:
        return 0.0
    axis, weight = np.asarray(link.joint.axis), np.array([0.0, 0.0, -9.81])
    if link.joint.kind == "slide":
        return float(sum(masses) * axis @ weight)
    arms = [np.asarray(shape.position) - link.joint.anchor for shape in weighing(link)]
    return float(sum(mass * axis @ np.cross(arm, weight) for mass, arm in zip(masses, arms, strict=True)))


def _add_shapes(spec: mujoco.MjSpec, body: mujoco.MjsBody, link: Link, masses: tuple[float, ...], asset: Asset) -> None:
    mass_of = dict(zip(map(id, weighing(link)), masses, strict=True))
    for shape in link.shapes:
        mass = mass_of.get(id(shape), 0.0)
        if shape.collide or mass:
            geom = add_geom(spec, body, shape)
            geom.mass = mass
            if shape.collide:
                geom.friction = (asset.friction, TORSION, ROLL)


def add_geom(spec: mujoco.MjSpec, body: mujoco.MjsBody, shape: Shape) -> mujoco.MjsGeom:
    """Add one shape to a body, in the body's frame.

    The points of a hull are a file of the spec, in memory: what the engine works out of a file is kept, so that a known
    hull compiles in a third of the time.
    """
    kind = COLLISION if shape.collide else VISUAL
    geom = body.add_geom(spec.find_default(kind), type=GEOM_TYPES[shape.kind], pos=shape.position, quat=shape.quat_wxyz)
    if shape.collide:
        geom.condim = 6 if shape.kind in ROLLING else 3
    if shape.kind == "hull":
        geom.meshname = _mesh(spec, collider(shape))
    else:
        geom.size = half_size(shape)
    return geom


def half_size(shape: Shape) -> tuple[float, float, float]:
    """The size of a shape that is no hull, as the engine has it [m]."""
    x, y, z = (extent / 2 for extent in shape.size)
    if shape.kind == "cylinder":
        return (x, z, 0.0)
    if shape.kind == "capsule":
        return (x, max(z - x, 1e-6), 0.0)
    return (x, 0.0, 0.0) if shape.kind == "sphere" else (x, y, z)


def hull_name(shape: Shape) -> str:
    """The name of a hull's mesh, by all that it depends on."""
    return _hull_file(shape)[0]


@kept
def _hull_file(shape: Shape) -> tuple[str, bytes]:
    """The name of a hull's mesh, and its file."""
    points = np.asarray(shape.points, dtype=np.float64)
    return f"hull_{hashlib.sha256(points.tobytes() + bytes([shape.smooth])).hexdigest()}", _msh(points)


def _mesh(spec: mujoco.MjSpec, shape: Shape) -> str:
    name, data = _hull_file(shape)
    if spec.mesh(name) is None:
        mesh = spec.add_mesh(name=name)
        mesh.inertia, mesh.smoothnormal = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX, shape.smooth
        # The engine keeps meshes by the names of their files, so the name must hold all that the mesh depends on.
        mesh.file = f"{name}.msh"
        spec.assets[mesh.file] = data
    return name


def _msh(points: NDArray[np.float64]) -> bytes:
    """Points (n, 3) in MuJoCo's binary format of meshes: four counts, and positions as 32-bit floats [m]."""
    return np.array([len(points), 0, 0, 0], dtype="<i4").tobytes() + points.astype("<f4").tobytes()
