"""Doors and drawers in USD: revolute and prismatic joints whose two frames agree."""

import math
from typing import Any

import numpy as np

from thinkblox.exporters.inventory import InventoryJoint
from thinkblox.exporters.usd_prims import IDENTITY, Prim, T, quaternion, vector
from thinkblox.value import Quat

_AXES = {"X": (1.0, 0.0, 0.0), "Y": (0.0, 1.0, 0.0), "Z": (0.0, 0.0, 1.0)}


def add_joint(parent: Prim, name: str, joint: InventoryJoint, body: Any, link: Any) -> None:
    """Join the links at paths `body` and `link`, whose frames are parallel when the joint is at 0.

    UsdPhysics knows neither friction nor damping of joints: PhysX and Newton have attributes of their own for them.
    """
    hinge = joint.kind == "hinge"
    axis, turn = axis_frame(joint)
    side = "angular" if hinge else "linear"
    apis = [f"PhysxJointAxisAPI:{side}", "NewtonJointAPI"]
    prim = parent.child(name, "PhysicsRevoluteJoint" if hinge else "PhysicsPrismaticJoint", apis=apis)
    prim.link("physics:body0", [body]).link("physics:body1", [link])
    prim.put("physics:axis", T.Token, axis, uniform=True)
    for end, anchor in (("0", joint.anchor), ("1", (0.0, 0.0, 0.0))):
        prim.put(f"physics:localPos{end}", T.Point3f, vector(anchor))
        prim.put(f"physics:localRot{end}", T.Quatf, quaternion(turn))
    prim.put("physics:lowerLimit", T.Float, float(joint.lower)).put("physics:upperLimit", T.Float, float(joint.upper))
    prim.put("physics:collisionEnabled", T.Bool, False)
    # What is damped is a speed in degrees; what rubs is an effort.
    damping = math.radians(joint.damping) if hinge else joint.damping
    for effort in ("staticFrictionEffort", "dynamicFrictionEffort"):
        prim.put(f"physxJointAxis:{side}:{effort}", T.Float, joint.friction)
    prim.put(f"physxJointAxis:{side}:viscousFrictionCoefficient", T.Float, damping)
    prim.put("newton:friction", T.Float, joint.friction).put("newton:damping", T.Float, damping)


def fix_to_room(parent: Prim, body: Any, position: Any, quat_wxyz: Any) -> None:
    """Fix a body where it is: what hangs on a wall and has doors is an articulation with a fixed base."""
    prim = parent.child("mount", "PhysicsFixedJoint").link("physics:body1", [body])
    prim.put("physics:localPos0", T.Point3f, vector(position)).put("physics:localRot0", T.Quatf, quaternion(quat_wxyz))
    prim.put("physics:localPos1", T.Point3f, vector((0, 0, 0))).put("physics:localRot1", T.Quatf, quaternion(IDENTITY))


def axis_frame(joint: InventoryJoint) -> tuple[str, Quat]:
    """The USD axis of a joint and the turn of both its frames; one of the three axes needs no turn."""
    axis = np.asarray(joint.axis, dtype=float) / np.linalg.norm(joint.axis)
    for name, unit in _AXES.items():
        if float(axis @ unit) > 1.0 - 1e-9:
            return name, IDENTITY
    return "X", _turn_from_x(axis)


def _turn_from_x(axis: Any) -> Quat:
    x, y, z = map(float, axis)
    if x < -1.0 + 1e-9:
        return (0.0, 0.0, 0.0, 1.0)
    length = math.sqrt((1.0 + x) ** 2 + z * z + y * y)
    return ((1.0 + x) / length, 0.0, -z / length, y / length)
