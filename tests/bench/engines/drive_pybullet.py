"""Bullet drives a case: python drive_pybullet.py CASE; prints JSON."""

import json
import sys
import time
from pathlib import Path
from typing import Any

import pybullet as bullet


def client_of(case: dict[str, Any], gravity: Any) -> int:
    client: int = bullet.connect(bullet.DIRECT)
    bullet.setGravity(*gravity, physicsClientId=client)
    bullet.setPhysicsEngineParameter(fixedTimeStep=case["timestep"], physicsClientId=client)
    return client


def xyzw(quat: Any) -> list[float]:
    return [*quat[1:], quat[0]]


def loaded(client: int, thing: dict[str, Any], position: Any, quat: Any, *, fixed: bool) -> int:
    """With the inertias of its file, and what rubs in its joints as motors that hold still with that much force."""
    body: int = bullet.loadURDF(
        thing["model"], position, xyzw(quat), useFixedBase=fixed, flags=bullet.URDF_USE_INERTIA_FROM_FILE,
        physicsClientId=client,
    )  # fmt: skip
    for link in range(-1, bullet.getNumJoints(body, physicsClientId=client)):
        bullet.changeDynamics(body, link, linearDamping=0.0, angularDamping=0.0, physicsClientId=client)
        if link >= 0:
            friction = bullet.getJointInfo(body, link, physicsClientId=client)[7]
            bullet.setJointMotorControl2(
                body, link, bullet.VELOCITY_CONTROL, targetVelocity=0.0, force=friction, physicsClientId=client
            )
    return body


def mass_of(thing: dict[str, Any]) -> float:
    """Of the model by itself: of what is fixed the engine says none."""
    client = bullet.connect(bullet.DIRECT)
    body = bullet.loadURDF(thing["model"], flags=bullet.URDF_USE_INERTIA_FROM_FILE, physicsClientId=client)
    links = range(-1, bullet.getNumJoints(body, physicsClientId=client))
    mass = sum(bullet.getDynamicsInfo(body, link, physicsClientId=client)[0] for link in links)
    bullet.disconnect(client)
    return float(mass)


def pose(client: int, body: int) -> Any:
    """Of the frame of the model; the engine says that of the centre of mass."""
    place, turn = bullet.getBasePositionAndOrientation(body, physicsClientId=client)
    known = bullet.getDynamicsInfo(body, -1, physicsClientId=client)
    place, turn = bullet.multiplyTransforms(place, turn, *bullet.invertTransform(known[3], known[4]))
    return [list(place), [turn[3], *turn[:3]]]


def main() -> None:
    case = json.loads(Path(sys.argv[1]).read_text())
    client, bodies, masses = client_of(case, case["gravity"]), {}, {}
    for box in case["boxes"]:
        shape = bullet.createCollisionShape(
            bullet.GEOM_BOX, halfExtents=[side / 2 for side in box["size"]], physicsClientId=client
        )
        wall = bullet.createMultiBody(
            0.0, shape, basePosition=box["position"], baseOrientation=xyzw(box["quat"]), physicsClientId=client
        )
        bullet.changeDynamics(wall, -1, lateralFriction=box["friction"], physicsClientId=client)
    for thing in case["things"]:
        masses[thing["name"]] = mass_of(thing)
        body = loaded(client, thing, thing["position"], thing["quat"], fixed=not thing["free"])
        if thing["free"]:
            bodies[thing["name"]] = body
    begun = time.perf_counter()
    for _ in range(round(case["seconds"] / case["timestep"])):
        bullet.stepSimulation(physicsClientId=client)
    took = time.perf_counter() - begun
    poses = {name: pose(client, body) for name, body in bodies.items()}
    swings: dict[str, dict[str, list[float]]] = {}
    for thing in case["swinging"]:
        client = client_of(case, case["tilted"])
        body = loaded(client, thing, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0), fixed=True)
        joints = range(bullet.getNumJoints(body, physicsClientId=client))
        numbers = {bullet.getJointInfo(body, joint, physicsClientId=client)[1].decode(): joint for joint in joints}
        seen, steps = dict[str, list[float]](), 0
        for at in case["times"]:
            while steps * case["timestep"] < at - 1e-9:
                bullet.stepSimulation(physicsClientId=client)
                steps += 1
            for joint in thing["joints"]:
                seen.setdefault(joint, []).append(bullet.getJointState(body, numbers[joint], physicsClientId=client)[0])
        swings[thing["asset"]] = seen
        bullet.disconnect(client)
    print(json.dumps({"masses": masses, "poses": poses, "swings": swings, "took": took}))


main()
