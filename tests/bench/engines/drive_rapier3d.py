"""Rapier drives a case: python drive_rapier3d.py CASE; prints JSON. It reads MJCF."""

import json
import math
import re
import sys
import time
from pathlib import Path
from typing import Any

import rapier3d as rapier
import rapier3d.loaders.mjcf


class Read:
    """A world with what an MJCF has in it, its bodies by name, at the keyframe "settled"."""

    def __init__(self, case: dict[str, Any], folder: str, gravity: Any) -> None:
        # Rapier 0.36 takes this attribute of a mesh, "true" or "false", for a number.
        text = re.sub(r'smoothnormal="\w+"', "", Path(folder, "scene.xml").read_text())
        robot, _ = rapier.loaders.mjcf.MjcfRobot.from_str(text, None, folder)
        self.world = rapier.PhysicsWorld(gravity)
        self.world.integration_parameters.dt = case["timestep"]
        bodies = self.world.rigid_bodies
        handles = robot.insert_using_impulse_joints(bodies, self.world.colliders, self.world.impulse_joints)
        handles.apply_keyframe(bodies, None, "settled")
        for made in handles.joints:
            self._damp_by_force(made.joint)
        self.handles = {
            name: handles.bodies[i].body for name, i in handles.body_name_to_idx.items() if handles.bodies[i]
        }

    def _damp_by_force(self, handle: Any) -> None:
        """Damp a joint as MJCF means it: the loader's motor would slow what is light and what is heavy alike."""
        joint = self.world.impulse_joints[handle]
        data = joint.data
        for axis in (getattr(rapier.JointAxis, f"{kind}_{name}") for kind in ("LIN", "ANG") for name in "XYZ"):
            if data.motor(axis) is not None:
                data.set_motor_model(axis, rapier.MotorModel.FORCE_BASED)
        joint.data = data

    def body(self, name: str) -> Any:
        return self.world.rigid_bodies[self.handles[name]]

    def run(self, seconds: float) -> None:
        for _ in range(round(seconds / self.world.integration_parameters.dt)):
            self.world.step()


def between(read: Read, parent: str, child: str) -> Any:
    """The pose of a body in another's frame."""
    return read.body(parent).position.inverse() * read.body(child).position


def swung(case: dict[str, Any], thing: dict[str, Any]) -> dict[str, list[float]]:
    """How far the doors and drawers of a thing are open [rad, m], by where they are."""
    read, seen = Read(case, thing["mjcf"], case["tilted"]), dict[str, list[float]]()
    shut = {joint: between(read, parent, child) for joint, (parent, child, _) in thing["links"].items()}
    before = 0.0
    for at in case["times"]:
        read.run(at - before)
        before = at
        for joint, (parent, child, slides) in thing["links"].items():
            away = shut[joint].inverse() * between(read, parent, child)
            place, turn = away.translation, away.rotation
            far = math.hypot(place.x, place.y, place.z)
            angle = 2.0 * math.atan2(math.hypot(turn.i, turn.j, turn.k), abs(turn.w))
            seen.setdefault(joint, []).append(far if slides else angle)
    return seen


def main() -> None:
    case = json.loads(Path(sys.argv[1]).read_text())
    read = Read(case, case["folder"], case["gravity"])
    for thing in case["things"]:
        if thing["position"] != thing["rests"]:
            read.body(thing["name"]).translation = thing["position"]
    begun = time.perf_counter()
    read.run(case["seconds"])
    took = time.perf_counter() - begun
    masses, poses = {}, {}
    for thing in case["things"]:
        own = [name for name in read.handles if name == thing["name"] or name.startswith(thing["name"] + "_")]
        if thing["name"] in read.handles:
            masses[thing["name"]] = sum(read.body(name).mass for name in own)
            body = read.body(thing["name"])
            place, turn = body.translation, body.rotation
            poses[thing["name"]] = [[place.x, place.y, place.z], [turn.w, turn.i, turn.j, turn.k]]
    swings = {thing["asset"]: swung(case, thing) for thing in case["swinging"]}
    print(json.dumps({"masses": masses, "poses": poses, "swings": swings, "took": took}))


main()
