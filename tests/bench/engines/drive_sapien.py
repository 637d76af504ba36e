"""SAPIEN drives a case: python drive_sapien.py CASE; prints JSON."""

import json
import re
import sys
import time
import warnings
from pathlib import Path
from typing import Any

warnings.simplefilter("ignore")
import sapien  # noqa: E402


def scene_of(case: dict[str, Any], gravity: Any) -> Any:
    config = sapien.physx.get_scene_config()
    config.gravity = gravity
    sapien.physx.set_scene_config(config)
    scene = sapien.Scene([sapien.physx.PhysxCpuSystem()])
    scene.set_timestep(case["timestep"])
    return scene


def loaded(scene: Any, thing: dict[str, Any], *, fixed: bool) -> Any:
    """Without what is seen, which it cannot load where there is no Vulkan."""
    file = Path(thing["model"])
    bare = file.with_name(f"bare_{file.name}")
    bare.write_text(re.sub(r"<visual>.*?</visual>", "", file.read_text(), flags=re.DOTALL))
    loader = scene.create_urdf_loader()
    loader.fix_root_link = fixed
    loader.set_material(thing["friction"], thing["friction"], 0.0)
    jointed, single = loader.load_multiple(str(bare))[:2]
    bare.unlink()
    return (*jointed, *single)[0]


def mass_of(model: Any) -> float:
    """Of a model with joints, or of one of a single link."""
    if hasattr(model, "get_links"):
        return float(sum(link.mass for link in model.get_links()))
    return float(model.find_component_by_type(sapien.physx.PhysxRigidDynamicComponent).mass)


def put(model: Any, pose: Any) -> None:
    if hasattr(model, "set_root_pose"):
        model.set_root_pose(pose)
    else:
        model.set_pose(pose)


def pose_of(model: Any) -> Any:
    pose = model.get_root_pose() if hasattr(model, "get_root_pose") else model.get_pose()
    return [pose.p.tolist(), pose.q.tolist()]


def main() -> None:
    case = json.loads(Path(sys.argv[1]).read_text())
    scene, models, masses = scene_of(case, case["gravity"]), {}, {}
    for box in case["boxes"]:
        builder = scene.create_actor_builder()
        material = scene.create_physical_material(box["friction"], box["friction"], 0.0)
        builder.add_box_collision(half_size=[side / 2 for side in box["size"]], material=material)
        builder.set_initial_pose(sapien.Pose(box["position"], box["quat"]))
        builder.build_static()
    for thing in case["things"]:
        model = loaded(scene, thing, fixed=not thing["free"])
        masses[thing["name"]] = mass_of(model)
        put(model, sapien.Pose(thing["position"], thing["quat"]))
        models[thing["name"]] = model
    begun = time.perf_counter()
    for _ in range(round(case["seconds"] / case["timestep"])):
        scene.step()
    took = time.perf_counter() - begun
    poses = {name: pose_of(model) for name, model in models.items()}
    swings: dict[str, dict[str, list[float]]] = {}
    for thing in case["swinging"]:
        scene = scene_of(case, case["tilted"])
        model = loaded(scene, thing, fixed=True)
        for joint in model.get_active_joints():
            # Its loader reads no friction in N m, and gives every joint a coefficient of 0.05.
            joint.set_friction(0.0)
        names, seen, steps = [joint.get_name() for joint in model.get_active_joints()], dict[str, list[float]](), 0
        for at in case["times"]:
            while steps * case["timestep"] < at - 1e-9:
                scene.step()
                steps += 1
            for joint in thing["joints"]:
                seen.setdefault(joint, []).append(float(model.get_qpos()[names.index(joint)]))
        swings[thing["asset"]] = seen
    print(json.dumps({"masses": masses, "poses": poses, "swings": swings, "took": took}))


main()
