"""DART drives a case: python drive_dartpy.py CASE; prints JSON."""

import json
import sys
import time
from pathlib import Path
from typing import Any

import dartpy as dart
import numpy as np


def isometry(position: Any, quat: Any) -> Any:
    found, turn = dart.math.Isometry3(), dart.math.Quaternion()
    turn.set_wxyz(*quat)
    found.set_rotation(turn.to_rotation_matrix())
    found.set_translation(position)
    return found


def world_of(case: dict[str, Any], gravity: Any) -> Any:
    world = dart.simulation.World()
    world.setTimeStep(case["timestep"])
    world.setGravity(gravity)
    world.getConstraintSolver().setCollisionDetector(dart.collision.OdeCollisionDetector())
    return world


def loaded(thing: dict[str, Any], *, fixed: bool) -> Any:
    kinds = dart.utils.DartLoaderRootJointType
    options = dart.utils.DartLoaderOptions()
    options.mDefaultRootJointType = kinds.FIXED if fixed else kinds.FLOATING
    loader = dart.utils.DartLoader()
    loader.setOptions(options)
    model = loader.parseSkeleton(thing["model"])
    model.setName(thing["name"])
    model.disableSelfCollisionCheck()
    for body in (model.getBodyNode(i) for i in range(model.getNumBodyNodes())):
        for shape in (body.getShapeNode(i) for i in range(body.getNumShapeNodes())):
            if shape.hasDynamicsAspect():
                shape.getDynamicsAspect().setFrictionCoeff(thing["friction"])
    return model


def pose(model: Any) -> Any:
    found = model.getBodyNode(0).getWorldTransform()
    return [np.ravel(found.translation()).tolist(), np.ravel(found.quaternion().wxyz()).tolist()]


def main() -> None:
    case = json.loads(Path(sys.argv[1]).read_text())
    world, models, masses = world_of(case, case["gravity"]), {}, {}
    for number, box in enumerate(case["boxes"]):
        wall = dart.dynamics.Skeleton(f"wall_{number}")
        joint, body = wall.createWeldJointAndBodyNodePair()
        shape = body.createShapeNode(dart.dynamics.BoxShape(box["size"]))
        shape.createCollisionAspect()
        shape.createDynamicsAspect().setFrictionCoeff(box["friction"])
        joint.setTransformFromParentBodyNode(isometry(box["position"], box["quat"]))
        world.addSkeleton(wall)
    for thing in case["things"]:
        model = loaded(thing, fixed=not thing["free"])
        masses[thing["name"]] = model.getMass()
        place = isometry(thing["position"], thing["quat"])
        if thing["free"]:
            model.getJoint(0).setPositions(dart.dynamics.FreeJoint.convertToPositions(place))
            models[thing["name"]] = model
        else:
            model.getJoint(0).setTransformFromParentBodyNode(place)
        world.addSkeleton(model)
    begun = time.perf_counter()
    for _ in range(round(case["seconds"] / case["timestep"])):
        world.step()
    took = time.perf_counter() - begun
    poses = {name: pose(model) for name, model in models.items()}
    swings: dict[str, dict[str, list[float]]] = {}
    for thing in case["swinging"]:
        world, model = world_of(case, case["tilted"]), loaded(thing, fixed=True)
        for joint in thing["joints"]:
            model.getJoint(joint).setLimitEnforcement(True)
        world.addSkeleton(model)
        seen: dict[str, list[float]] = {}
        for at in case["times"]:
            while world.getTime() < at - 1e-9:
                world.step()
            for joint in thing["joints"]:
                seen.setdefault(joint, []).append(model.getJoint(joint).getPosition(0))
        swings[thing["asset"]] = seen
    print(json.dumps({"masses": masses, "poses": poses, "swings": swings, "took": took}))


main()
