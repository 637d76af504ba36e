"""One room, written down in the convention of each generator by formulas of its own, not by the readers' matrices.

Each writer takes things in our conventions (position = middle of the base, yaw counter-clockwise from +x, size = along
the front, across, up) and works out the foreign numbers with plain trigonometry.
"""

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import trimesh

from thinkblox.value import Vec2, Vec3


@dataclass(frozen=True)
class Thing:
    """Something in the room, in our conventions."""

    name: str
    position: Vec3
    yaw: float
    size: Vec3

    @property
    def middle(self) -> Vec3:
        x, y, z = self.position
        return (x, y, z + self.size[2] / 2)


@dataclass(frozen=True)
class Plan:
    """A rectangular room and what is in it."""

    width: float
    depth: float
    height: float
    things: tuple[Thing, ...]

    @property
    def corners(self) -> tuple[Vec2, ...]:
        return ((0.0, 0.0), (self.width, 0.0), (self.width, self.depth), (0.0, self.depth))


BEDROOM = Plan(
    width=4.0,
    depth=5.0,
    height=2.8,
    things=(
        # Head at the west wall, feet to the east; away from every axis of symmetry of the room.
        Thing("bed", (1.05, 3.6, 0.0), 0.0, (2.0, 1.6, 0.5)),
        # In the north-east corner, with its back to the north wall: it faces south.
        Thing("wardrobe", (3.35, 4.65, 0.0), 270.0, (0.6, 1.2, 2.1)),
        # At the south wall, facing north.
        Thing("desk", (1.2, 0.4, 0.0), 90.0, (0.7, 1.4, 0.75)),
        # Askew, so that the sense of rotation shows.
        Thing("chair", (1.9, 1.6, 0.0), 240.0, (0.5, 0.45, 0.9)),
        # On the desk, near its west end.
        Thing("lamp", (0.8, 0.35, 0.75), 90.0, (0.2, 0.25, 0.4)),
    ),
)


def write(folder: Path, format: str, plan: Plan = BEDROOM) -> Path:
    """Write the room in a format; returns the file to read. Meshes, where the format needs them, go beside it."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{format}.json"
    path.write_text(json.dumps(WRITERS[format](plan, folder)))
    return path


def layoutvlm(plan: Plan, folder: Path | None = None) -> dict[str, Any]:
    return {
        "task_description": "a bedroom",
        "boundary": {"floor_vertices": [[x, y, 0.0] for x, y in plan.corners], "wall_height": plan.height},
        "assets": {
            f"{t.name}-0": {
                "category": t.name,
                "assetMetadata": {"boundingBox": {"x": t.size[0], "y": t.size[1], "z": t.size[2]}},
            }
            for t in plan.things
        },
        "layout": {
            f"{t.name}-0": {"position": list(t.middle), "rotation": [0.0, 0.0, t.yaw]} for t in plan.things
        },
    }  # fmt: skip


def idesign(plan: Plan, folder: Path | None = None) -> list[Any]:
    def part(name: str, kind: str, length: float, x: float, y: float, angle: float) -> dict[str, Any]:
        return {
            "new_object_id": name, "itemType": kind, "position": {"x": x, "y": y, "z": plan.height / 2},
            "size_in_meters": {"length": length, "width": 0.0, "height": plan.height}, "rotation": {"z_angle": angle},
        }  # fmt: skip

    def bearing(yaw: float) -> float:
        east, north = math.cos(math.radians(yaw)), math.sin(math.radians(yaw))
        return math.degrees(math.atan2(east, north)) % 360.0

    things = [
        {
            "new_object_id": f"{t.name}_1",
            "size_in_meters": {"length": t.size[1], "width": t.size[0], "height": t.size[2]},
            "is_on_the_floor": t.position[2] == 0.0,
            "rotation": {"z_angle": bearing(t.yaw)},
            "position": dict(zip("xyz", t.middle, strict=True)),
            "placement": {"room_layout_elements": [], "objects_in_room": []},
        }
        for t in plan.things
    ]
    w, d = plan.width, plan.depth
    return [
        *things,
        part("south_wall", "wall", w, w / 2, 0.0, 0.0),
        part("north_wall", "wall", w, w / 2, d, 180.0),
        part("east_wall", "wall", d, w, d / 2, 270.0),
        part("west_wall", "wall", d, 0.0, d / 2, 90.0),
        part("middle of the room", "floor", w, w / 2, d / 2, 0.0),
        part("ceiling", "ceiling", w, w / 2, d / 2, 0.0),
    ]


def layoutgpt(plan: Plan, folder: Path | None = None) -> list[Any]:
    """In metres; `left` and `top` are counted from the north-west corner, `top` southwards."""

    def box(t: Thing) -> dict[str, float]:
        x, y, z = t.middle
        # At orientation 0 the front faces south; it turns counter-clockwise with the yaw.
        return {
            "length": t.size[1], "width": t.size[0], "height": t.size[2], "left": x, "top": plan.depth - y, "depth": z,
            "orientation": t.yaw + 90.0,
        }  # fmt: skip

    prompt = f"Room Type: bedroom\nRoom Size: max length {plan.width:.2f}m, max width {plan.depth:.2f}m\n"
    return [{"query_id": "r", "iter": 0, "prompt": prompt, "object_list": [[t.name, box(t)] for t in plan.things]}]


def il3d(plan: Plan, folder: Path | None = None) -> dict[str, Any]:
    """x east, z south, y up; the origin at the room's north-west corner."""
    w, d = plan.width, plan.depth
    return {
        "dataset": "3D-FRONT",
        "meshes": [
            {
                "type": "floor",
                "xyz": [[w, 0.0, d], [w, 0.0, 0.0], [0.0, 0.0, d], [0.0, 0.0, 0.0]],
                "faces": [[0, 1, 2], [1, 3, 2]],
            }
        ],
        "objects": [
            {
                "object_name": t.name,
                "category": t.name,
                "position": [t.position[0], t.position[2], d - t.position[1]],
                "rotation": [0.0, t.yaw + 90.0, 0.0],
                "scale": [1.0, 1.0, 1.0],
                "bbox": [t.size[1], t.size[0], t.size[2]],
            }
            for t in plan.things
        ],
    }


def holodeck(plan: Plan, folder: Path) -> dict[str, Any]:
    """x east, z north, y up; rotation clockwise from north. Sizes stand in objathor's annotations beside the file."""
    sizes = {
        t.name: {"assetMetadata": {"boundingBox": {"x": t.size[1], "y": t.size[2], "z": t.size[0]}}}
        for t in plan.things
    }
    (folder / "annotations.json").write_text(json.dumps(sizes))
    clockwise = [plan.corners[0], *plan.corners[:0:-1]]
    return {
        "query": "a bedroom",
        "wall_height": plan.height,
        "rooms": [{"id": "bedroom", "floorPolygon": [{"x": x, "y": 0, "z": y} for x, y in clockwise]}],
        "walls": [],
        "doors": [],
        "windows": [],
        "objects": [
            {
                "id": f"{t.name}-0 (bedroom)",
                "object_name": f"{t.name}-0",
                "assetId": t.name,
                "roomId": "bedroom",
                "position": {"x": t.middle[0], "y": t.middle[2], "z": t.middle[1]},
                "rotation": {"x": 0, "y": (90.0 - t.yaw) % 360.0, "z": 0},
            }
            for t in plan.things
        ],
    }


def sceneeval(plan: Plan, folder: Path) -> dict[str, Any]:
    """Meshes are boxes in glTF's axes, standing on their origin; a transform's columns are where x, y and z go."""

    def columns(t: Thing) -> list[float]:
        c, s = math.cos(math.radians(t.yaw)), math.sin(math.radians(t.yaw))
        left, up, front = (-s, c, 0.0), (0.0, 0.0, 1.0), (c, s, 0.0)
        return [*left, 0.0, *up, 0.0, *front, 0.0, *t.position, 1.0]

    for t in plan.things:
        place = trimesh.transformations.translation_matrix((0.0, t.size[2] / 2, 0.0))
        box = trimesh.creation.box((t.size[1], t.size[2], t.size[0]), place)
        (folder / t.name).mkdir(exist_ok=True)
        box.export(folder / t.name / f"{t.name}.glb")
    corners = [[x, y, 0.0] for x, y in plan.corners]
    walls = [
        {"type": "Wall", "id": i, "roomId": "0", "height": plan.height, "points": [a, b], "holes": []}
        for i, (a, b) in enumerate(zip(corners, [*corners[1:], corners[0]], strict=True))
    ]
    return {
        "format": "sceneState",
        "scene": {
            "unit": 1.0,
            "up": [0, 0, 1],
            "arch": {"scaleToMeters": 1, "elements": [{"type": "Floor", "roomId": "0", "points": corners}, *walls]},
            "object": [
                {"index": i, "modelId": f"objaverse.{t.name}", "transform": {"data": columns(t)}}
                for i, t in enumerate(plan.things)
            ],
        },
    }


WRITERS: dict[str, Any] = {
    "layoutvlm": layoutvlm,
    "idesign": idesign,
    "metaspatial": idesign,
    "layoutgpt": layoutgpt,
    "il3d": il3d,
    "holodeck": holodeck,
    "sceneeval": sceneeval,
}


def chair_mesh() -> Any:
    """A chair in glTF's axes: y up, facing +z, so that its back is at -z; standing on the origin, its box 0.5 square.

    The left armrest, at +x, is there and the right one is not, so that a mirror image shows.
    """

    def box(size: Vec3, middle: Vec3) -> Any:
        return trimesh.creation.box(size, trimesh.transformations.translation_matrix(middle))

    return trimesh.util.concatenate(
        [
            box((0.5, 0.4, 0.5), (0.0, 0.2, 0.0)),
            box((0.5, 0.5, 0.1), (0.0, 0.65, -0.2)),
            box((0.1, 0.2, 0.3), (0.2, 0.5, 0.0)),
        ]
    )


def distance(a: Any, b: Any) -> float:
    """Largest difference of two arrays."""
    return float(np.abs(np.asarray(a) - np.asarray(b)).max())
