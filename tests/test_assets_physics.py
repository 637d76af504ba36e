"""In MuJoCo: free things stand still, and doors and drawers open without touching the rest."""

from math import prod

import mujoco
import numpy as np
import pytest

from thinkblox.assets import CATALOGUE, make_asset
from thinkblox.scene.asset import Asset, Link, Shape

SHAPED = [name for name, category in CATALOGUE.items() if not category.plain]
FREE = [name for name in SHAPED if make_asset(name, seed=0).free]
JOINTED = [name for name in SHAPED if len(make_asset(name, seed=0).links) > 1]
_FILL = {"box": 1.0, "cylinder": np.pi / 4, "capsule": 0.7, "sphere": np.pi / 6, "ellipsoid": np.pi / 6, "hull": 0.6}


def _model(asset: Asset, *, fixed_joints: bool, check_family: bool = False) -> mujoco.MjModel:
    spec = mujoco.MjSpec()
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[5, 5, 0.1], friction=[0.6, 0.005, 0.0001])
    if check_family:
        spec.option.disableflags |= mujoco.mjtDisableBit.mjDSBL_FILTERPARENT
    body = spec.worldbody.add_body(name="asset")
    body.add_freejoint()
    density = asset.mass / sum(prod(s.size) * _FILL[s.kind] for link in asset.links for s in link.shapes if s.collide)
    for number, link in enumerate(asset.links):
        part = body if number == 0 else body.add_body(name=link.name)
        if link.joint and not fixed_joints:
            _add_joint(part, link)
        for index, shape in enumerate(link.shapes):
            if shape.collide:
                _add_geom(spec, part, shape, f"{number}_{index}", density)
    return spec.compile()


def _add_joint(body: mujoco.MjsBody, link: Link) -> None:
    joint = link.joint
    assert joint
    hinge = joint.kind == "hinge"
    upper = np.radians(joint.upper) if hinge else joint.upper
    kind = mujoco.mjtJoint.mjJNT_HINGE if hinge else mujoco.mjtJoint.mjJNT_SLIDE
    body.add_joint(type=kind, axis=joint.axis, pos=joint.anchor, range=[0, upper], limited=True, damping=0.5)


def _add_geom(spec: mujoco.MjSpec, body: mujoco.MjsBody, shape: Shape, name: str, density: float) -> None:
    x, y, z = shape.size
    halves = {"cylinder": [x / 2, z / 2, 0], "capsule": [x / 2, (z - x) / 2, 0], "sphere": [x / 2, 0, 0]}
    kind = (
        mujoco.mjtGeom.mjGEOM_MESH if shape.kind == "hull" else getattr(mujoco.mjtGeom, f"mjGEOM_{shape.kind.upper()}")
    )
    geom = body.add_geom(type=kind, pos=shape.position, quat=shape.quat_wxyz, density=density)
    geom.size = halves.get(shape.kind, [x / 2, y / 2, z / 2])
    if shape.kind == "hull":
        mesh = spec.add_mesh(name=name)
        mesh.uservert = np.array(shape.points).ravel()
        mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
        geom.meshname = name


@pytest.mark.slow
@pytest.mark.parametrize("name", FREE)
def test_stands_still_for_a_second(name: str) -> None:
    for seed in (0, 1):
        model = _model(make_asset(name, seed=seed), fixed_joints=False)
        data = mujoco.MjData(model)
        while data.time < 1.0:
            mujoco.mj_step(model, data)
        turned = 2 * np.degrees(np.arccos(min(1.0, abs(data.qpos[3]))))
        assert np.linalg.norm(data.qpos[:3]) < 0.002
        assert turned < 0.5
        assert np.all(np.abs(data.qpos[7:]) < 0.01), "a door or drawer moved by itself"


@pytest.mark.parametrize("name", JOINTED)
def test_doors_and_drawers_open_freely(name: str) -> None:
    model = _model(make_asset(name, seed=0), fixed_joints=False, check_family=True)
    data = mujoco.MjData(model)
    assert _own_depth(model, data) < 1e-4
    for joint in range(1, model.njnt):
        for share in (0.1, 0.5, 1.0):
            mujoco.mj_resetData(model, data)
            data.qpos[model.jnt_qposadr[joint]] = share * model.jnt_range[joint][1]
            assert _own_depth(model, data) < 1e-4, f"joint {joint} at {share}"


def _own_depth(model: mujoco.MjModel, data: mujoco.MjData) -> float:
    """Deepest overlap between two links [m]."""
    mujoco.mj_forward(model, data)
    depths = [-c.dist for c in data.contact[: data.ncon] if _between_links(model, c)]
    return max(depths, default=0.0)


def _between_links(model: mujoco.MjModel, contact: mujoco.MjContact) -> bool:
    first, second = model.geom_bodyid[contact.geom1], model.geom_bodyid[contact.geom2]
    return bool(first and second and first != second)


def test_a_drawer_opens_to_the_front_and_a_door_to_100_degrees() -> None:
    drawer = make_asset("dresser", seed=0).links[1].joint
    assert drawer
    assert drawer.axis == (1.0, 0.0, 0.0)
    assert drawer.upper > 0.2
    doors = [link.joint for link in make_asset("wardrobe", seed=0).links[1:]]
    assert all(joint and joint.kind == "hinge" and joint.upper == 100.0 for joint in doors)
