"""Drake drives a case: python drive_drake.py CASE; prints JSON. What is flat touches by hydroelastic contact."""

import json
import sys
import time
from pathlib import Path
from typing import Any

from pydrake.common.eigen_geometry import Quaternion
from pydrake.geometry import DefaultProximityProperties, SceneGraphConfig
from pydrake.math import RigidTransform
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph, ContactModel, DiscreteContactApproximation
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

STIFF = 1e8
"""Of everything [Pa]: what is ten times as soft, as things are unless told otherwise, sinks by 7 mm."""


def plant_of(case: dict[str, Any], gravity: Any) -> tuple[Any, Any]:
    builder = DiagramBuilder()
    plant, graph = AddMultibodyPlantSceneGraph(builder, case["timestep"])
    soft = DefaultProximityProperties(compliance_type="compliant", hydroelastic_modulus=STIFF)
    graph.set_config(SceneGraphConfig(default_proximity_properties=soft))
    plant.set_contact_model(ContactModel.kHydroelasticWithFallback)
    plant.set_discrete_contact_approximation(DiscreteContactApproximation.kSap)
    plant.mutable_gravity_field().set_gravity_vector(gravity)
    return builder, plant


def simulator_of(builder: Any, plant: Any) -> tuple[Any, Any]:
    plant.Finalize()
    diagram = builder.Build()
    simulator = Simulator(diagram)
    return simulator, plant.GetMyContextFromRoot(simulator.get_mutable_context())


def placed(thing: dict[str, Any]) -> Any:
    return RigidTransform(Quaternion(thing["quat"]), thing["position"])


def main() -> None:
    case = json.loads(Path(sys.argv[1]).read_text())
    builder, plant = plant_of(case, case["gravity"])
    Parser(plant).AddModels(str(Path(case["folder"], "scene.sdf")))
    simulator, context = simulator_of(builder, plant)
    masses, bodies = {}, {}
    for thing in case["things"]:
        model = plant.GetModelInstanceByName(thing["name"])
        indices = plant.GetBodyIndices(model)
        masses[thing["name"]] = sum(plant.get_body(index).default_mass() for index in indices)
        if thing["free"]:
            bodies[thing["name"]] = plant.get_body(indices[0])
            plant.SetFreeBodyPose(context, bodies[thing["name"]], placed(thing))
    begun = time.perf_counter()
    simulator.AdvanceTo(case["seconds"])
    took = time.perf_counter() - begun
    poses = {}
    for name, body in bodies.items():
        found = plant.EvalBodyPoseInWorld(context, body)
        poses[name] = [found.translation().tolist(), found.rotation().ToQuaternion().wxyz().tolist()]
    swings: dict[str, dict[str, list[float]]] = {}
    for thing in case["swinging"]:
        builder, plant = plant_of(case, case["tilted"])
        (model,) = Parser(plant).AddModels(thing["model"])
        base = plant.get_body(plant.GetBodyIndices(model)[0])
        plant.WeldFrames(plant.world_frame(), base.body_frame())
        simulator, context = simulator_of(builder, plant)
        seen: dict[str, list[float]] = {}
        for at in case["times"]:
            simulator.AdvanceTo(at)
            for joint in thing["joints"]:
                start = plant.GetJointByName(joint, model).position_start()
                seen.setdefault(joint, []).append(float(plant.GetPositions(context)[start]))
        swings[thing["asset"]] = seen
    print(json.dumps({"masses": masses, "poses": poses, "swings": swings, "took": took}))


main()
