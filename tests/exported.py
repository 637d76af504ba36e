"""Rooms that were exported, read by libraries that are not ours, as rows that can be compared."""

import json
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import mujoco
import numpy as np
import trimesh
from pxr import Usd, UsdGeom, UsdPhysics, UsdShade

from thinkblox.exporters.inventory import Inventory

FORMATS = ("mjcf", "usd", "usdc", "usdz", "glb", "urdf", "sdf")


@dataclass
class Row:
    """One body, as far as a format tells.

    Attributes:
        mass: [kg]; None where the format says none, as of what is fixed.
        inertia: moments about the principal axes, sorted [kg m2].
        matrix: its pose in the room (4, 4).
        joint: lower, upper [rad or m], friction, damping.
        friction: of what can be touched.
    """

    mass: float | None = None
    inertia: np.ndarray | None = None
    matrix: np.ndarray | None = None
    joint: tuple[float, ...] | None = None
    friction: float | None = None


def measured(inventory: Inventory) -> dict[str, Row]:
    """What every export must hold: the inventory, whose masses and poses other tests hold against the model."""
    rows = {}
    for item in inventory.objects:
        for body in item.bodies:
            friction = next((geom.friction[0] for geom in body.geoms if geom.collides), None)
            rows[body.name] = Row(body.mass, np.sort(body.inertia), _matrix(*body.settled), friction=friction)
            if body.joint is not None:
                ends = [body.joint.lower, body.joint.upper]
                ends = np.radians(ends).tolist() if body.joint.kind == "hinge" else ends
                rows[body.name].joint = (*ends, body.joint.friction, body.joint.damping)
    return rows


def _matrix(position: Any, quat_wxyz: Any) -> np.ndarray:
    turn, matrix = np.zeros(9), np.eye(4)
    mujoco.mju_quat2Mat(turn, np.asarray(quat_wxyz, np.float64))
    matrix[:3, :3], matrix[:3, 3] = turn.reshape(3, 3), position
    return matrix


def read_mujoco(path: Path, names: set[str]) -> dict[str, Row]:
    """MJCF or URDF as MuJoCo reads it; of a URDF the friction is not known, and doors are shut."""
    model = mujoco.MjModel.from_xml_path(str(path))
    data, urdf, rows = mujoco.MjData(model), path.suffix == ".urdf", {}
    if not urdf:
        mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    mujoco.mj_kinematics(model, data)
    for i in range(1, model.nbody):
        if model.body(i).name not in names:
            continue
        row = Row(float(model.body_mass[i]), np.sort(model.body_inertia[i]), _matrix(data.xpos[i], data.xquat[i]))
        first, dofs = int(model.body_jntadr[i]), int(model.body_dofnum[i])
        if dofs == 1:
            dof = int(model.jnt_dofadr[first])
            row.joint = (*model.jnt_range[first], float(model.dof_frictionloss[dof]), float(model.dof_damping[dof]))
            row.matrix = None if urdf else row.matrix
        solid = [g for g in range(model.ngeom) if model.geom_bodyid[g] == i and model.geom_contype[g]]
        row.friction = float(model.geom_friction[solid[0], 0]) if solid and not urdf else None
        rows[str(model.body(i).name)] = row
    return rows


def read_usd(path: Path, names: set[str]) -> dict[str, Row]:
    """USD as OpenUSD reads it."""
    stage = Usd.Stage.Open(str(path))
    cache, rows, joints = UsdGeom.XformCache(), {}, {}
    for prim in stage.Traverse():
        if prim.IsA(UsdPhysics.RevoluteJoint) or prim.IsA(UsdPhysics.PrismaticJoint):
            hinge = prim.IsA(UsdPhysics.RevoluteJoint)
            ends = [prim.GetAttribute(f"physics:{side}Limit").Get() for side in ("lower", "upper")]
            scale = np.degrees(1.0) if hinge else 1.0
            ends = np.radians(ends).tolist() if hinge else ends
            damping = prim.GetAttribute("newton:damping").Get() * scale
            joints[prim.GetName()] = (*ends, prim.GetAttribute("newton:friction").Get(), damping)
    for prim in stage.GetPrimAtPath("/World/Objects").GetChildren():
        jointed = prim.HasAPI(UsdPhysics.ArticulationRootAPI)
        for body in prim.GetChildren() if jointed else [prim]:
            if body.GetName() in names:
                rows[body.GetName()] = _usd_row(body, cache, joints.get(body.GetName()))
    return rows


def _usd_row(prim: Any, cache: Any, joint: tuple[float, ...] | None) -> Row:
    row = Row(matrix=np.array(cache.GetLocalToWorldTransform(prim)).T, joint=joint)
    if prim.HasAPI(UsdPhysics.MassAPI):
        mass = UsdPhysics.MassAPI(prim)
        row.mass, row.inertia = mass.GetMassAttr().Get(), np.sort(np.array(mass.GetDiagonalInertiaAttr().Get()))
    for child in Usd.PrimRange(prim):
        if child.HasAPI(UsdPhysics.CollisionAPI):
            material, _ = UsdShade.MaterialBindingAPI(child).ComputeBoundMaterial("physics")
            row.friction = UsdPhysics.MaterialAPI(material.GetPrim()).GetDynamicFrictionAttr().Get()
            break
    return row


def read_glb(path: Path, names: set[str]) -> dict[str, Row]:
    """GLB: poses as trimesh composes them, masses and joints from the extras."""
    scene = trimesh.load_scene(str(path))
    data = path.read_bytes()
    (length,) = struct.unpack_from("<I", data, 12)
    nodes = {node["name"]: node for node in json.loads(data[20 : 20 + length])["nodes"]}
    upright = np.linalg.inv(scene.graph.get("thinkblox")[0])
    rows = {}
    for name in names & set(nodes):
        extras = nodes[name]["extras"]
        row = Row(extras["mass"], matrix=upright @ scene.graph.get(name)[0])
        if "joint" in extras:
            joint = extras["joint"]
            ends = [joint["lower"], joint["upper"]]
            ends = np.radians(ends).tolist() if joint["kind"] == "hinge" else ends
            row.joint = (*ends, joint["friction"], joint["damping"])
        rows[name] = row
    return rows


def read_sdf(path: Path, names: set[str]) -> dict[str, Row]:
    """SDF as its XML has it; doors are shut."""
    rows = {}
    for model in ElementTree.parse(path).getroot().iterfind("world/model"):
        where = _sdf_pose(model)
        for link in model.iterfind("link"):
            name = link.get("name", "")
            if name in names:
                i = {tag: float(link.findtext(f"inertial/inertia/{tag}", "nan")) for tag in ("ixx", "iyy", "izz")}
                i |= {tag: float(link.findtext(f"inertial/inertia/{tag}", "nan")) for tag in ("ixy", "ixz", "iyz")}
                tensor = [
                    [i["ixx"], i["ixy"], i["ixz"]],
                    [i["ixy"], i["iyy"], i["iyz"]],
                    [i["ixz"], i["iyz"], i["izz"]],
                ]
                mu = link.findtext("collision/surface/friction/ode/mu")
                joined = link.find("pose") is not None
                rows[name] = Row(
                    float(link.findtext("inertial/mass", "nan")), np.linalg.eigvalsh(tensor),
                    None if joined else where, friction=None if mu is None else float(mu),
                )  # fmt: skip
        for joint in model.iterfind("joint"):
            if joint.get("type") != "fixed":
                row = rows[joint.findtext("child", "")]
                row.joint = tuple(
                    float(joint.findtext(f"axis/{tag}", "nan"))
                    for tag in ("limit/lower", "limit/upper", "dynamics/friction", "dynamics/damping")
                )
    return rows


def _sdf_pose(element: ElementTree.Element) -> np.ndarray:
    x, y, z, a, b, c, w = map(float, element.findtext("pose", "0 0 0 0 0 0 1").split())
    return _matrix((x, y, z), (w, a, b, c))


READERS = {
    "scene.xml": read_mujoco, "scene.usda": read_usd, "scene.usdc": read_usd, "scene.usdz": read_usd,
    "scene.glb": read_glb, "scene.urdf": read_mujoco, "scene.sdf": read_sdf,
}  # fmt: skip


def compare(name: str, row: Row, expected: Row) -> None:
    """Hold a body against the measured one, in all that its format tells."""
    _near(row.mass, expected.mass, 1e-6, 0.0, name)
    _near(row.inertia, expected.inertia, 1e-4, 0.0, name)
    _near(row.matrix, expected.matrix, 0.0, 1e-6, name)
    assert (row.joint is None) == (expected.joint is None), name
    _near(row.joint, expected.joint, 1e-6, 1e-6, name)
    _near(row.friction, expected.friction, 1e-6, 0.0, name)


def _near(found: Any, expected: Any, rtol: float, atol: float, name: str) -> None:
    if found is not None:
        np.testing.assert_allclose(found, expected, rtol=rtol, atol=atol, err_msg=name)
