"""Blender draws a file from one of its cameras: python draw.py FILE CAMERA PICTURE; prints what it read as JSON."""

import json
import sys
from pathlib import Path

import bpy

LIGHTS = 0.01
"""How much of the lights' intensity Blender takes, which has no exposure of a camera to divide it by."""
SAMPLES = 24
"""Rays through each pixel."""
WATTS, HIGH = 150.0, 2.2
"""Of the lamp of a file without lights, and its height [m]."""


def main() -> None:
    file, camera, picture = sys.argv[1:]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if Path(file).suffix == ".glb":
        bpy.ops.import_scene.gltf(filepath=file)
    else:
        bpy.ops.wm.usd_import(filepath=file, light_intensity_scale=LIGHTS)
    scene, things = bpy.context.scene, bpy.data.objects
    if not any(thing.type == "LIGHT" for thing in things):
        # glTF has no lights: one lamp under the ceiling, over the middle of all that is there.
        lamp = bpy.data.lights.new("lamp", "POINT")
        lamp.energy = WATTS
        scene.collection.objects.link(shining := things.new("lamp", lamp))
        places = [thing.matrix_world.translation for thing in things if thing.type == "MESH"]
        shining.location = (*(sum(place[axis] for place in places) / len(places) for axis in range(2)), HIGH)
    scene.camera = next(thing for thing in things if thing.type == "CAMERA" and thing.name.startswith(camera))
    scene.render.engine, scene.cycles.samples, scene.cycles.device = "CYCLES", SAMPLES, "CPU"
    scene.render.resolution_x, scene.render.resolution_y = 640, 480
    scene.render.filepath = picture
    bpy.ops.render.render(write_still=True)
    kinds = {kind: sum(thing.type == kind for thing in things) for kind in ("MESH", "LIGHT", "CAMERA")}
    print(json.dumps({**kinds, "materials": len(bpy.data.materials), "images": len(bpy.data.images)}))


main()
