"""The published shapes of everything that is read or written as JSON."""

from typing import Any

from thinkblox.brief import Brief
from thinkblox.episode import Round
from thinkblox.errors import InputError
from thinkblox.exporters.manifest import Manifest
from thinkblox.plan import Plan
from thinkblox.scene.room import Room
from thinkblox.scene.scene import SCENE_VERSION, Scene
from thinkblox.steps import Answer
from thinkblox.value import Value, json_schema
from thinkblox.verdict import Report, Verdict

SCHEMAS: dict[str, type[Value]] = {
    "scene": Scene,
    "room": Room,
    "report": Report,
    "verdict": Verdict,
    "trace": Round,
    "answer": Answer,
    "brief": Brief,
    "plan": Plan,
    "manifest": Manifest,
}
"""By name: scene.json, a --room file, report.json and its parts, a line of trace.jsonl, what stands in <answer>, and
manifest.json."""
HOME = f"https://github.com/thinkblox/thinkblox/schema/v{SCENE_VERSION}"
"""Under which the schemas are known; the number is the version of the formats."""


def published_schema(name: str) -> dict[str, Any]:
    """The JSON Schema called `name`, with the address that it is known by.

    Raises:
        InputError: there is no schema of that name.
    """
    if name not in SCHEMAS:
        raise InputError(f"no schema {name!r}; there are {', '.join(SCHEMAS)}")
    schema = json_schema(SCHEMAS[name])
    description = schema["$defs"][SCHEMAS[name].__name__]["description"]
    about = {"$id": f"{HOME}/{name}.schema.json", "title": f"ThinkBLOX {name}", "description": description}
    return {"$schema": schema.pop("$schema")} | about | schema
