"""Rapier drives a case: python drive_rapier3d.py CASE; prints JSON. It reads MJCF, and swings nothing."""

import json
import re
import sys
import time
from pathlib import Path

import rapier3d as rapier
import rapier3d.loaders.mjcf


def main() -> None:
    case = json.loads(Path(sys.argv[1]).read_text())
    # Rapier 0.36 takes this attribute of a mesh, "true" or "false", for a number.
    text = re.sub(r'smoothnormal="\w+"', "", Path(case["folder"], "scene.xml").read_text())
    robot, _ = rapier.loaders.mjcf.MjcfRobot.from_str(text, None, case["folder"])
    world = rapier.PhysicsWorld(case["gravity"])
    world.integration_parameters.dt = case["timestep"]
    handles = robot.insert_using_impulse_joints(world.rigid_bodies, world.colliders, world.impulse_joints)
    bodies = {name: handles.bodies[i].body for name, i in handles.body_name_to_idx.items() if handles.bodies[i]}
    handles.apply_keyframe(world.rigid_bodies, None, "settled")
    for thing in case["things"]:
        if thing["position"] != thing["rests"]:
            world.rigid_bodies[bodies[thing["name"]]].translation = thing["position"]
    begun = time.perf_counter()
    for _ in range(round(case["seconds"] / case["timestep"])):
        world.step()
    took = time.perf_counter() - begun
    masses, poses = {}, {}
    for thing in case["things"]:
        own = [name for name in bodies if name == thing["name"] or name.startswith(thing["name"] + "_")]
        if thing["name"] in bodies:
            masses[thing["name"]] = sum(world.rigid_bodies[bodies[name]].mass for name in own)
            body = world.rigid_bodies[bodies[thing["name"]]]
            place, turn = body.translation, body.rotation
            poses[thing["name"]] = [[place.x, place.y, place.z], [turn.w, turn.i, turn.j, turn.k]]
    print(json.dumps({"masses": masses, "poses": poses, "swings": {}, "took": took}))


main()
