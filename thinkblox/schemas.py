"""The published shapes of everything that is read or written as JSON."""

from thinkblox.brief import Brief
from thinkblox.episode import Round
from thinkblox.exporters.manifest import Manifest
from thinkblox.plan import Plan
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.steps import Answer
from thinkblox.value import Value
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
