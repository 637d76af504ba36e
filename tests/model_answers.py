"""What a model would answer to each of our prompts, for a room with a table, a chair and a rug."""

import json
import re
from typing import Any

OBJECTS: dict[str, Any] = {
    "room": {"type": "room", "width": 4.0, "depth": 3.0},
    "objects": [
        {"id": "table", "category": "table"},
        {"id": "seat", "category": "chair"},
        {"id": "rug", "category": "rug", "asked": False},
    ],
    "relations": [{"subject": "seat", "kind": "near", "anchors": ["table"]}],
    "windows": 0,
}
PLACES = {"table": (2.0, 1.5, 0), "chair": (2.0, 2.5, 0), "rug": (2.0, 1.5, 0)}
"""Where things go in a room of 4 m by 3 m."""


def said(answer: object, think: str = "1. So.") -> str:
    return f"<think>{think}</think><answer>{json.dumps(answer)}</answer>"


def answer_to(text: str) -> str:
    """The answer to a prompt, told by its first line."""
    if text.startswith("You list what belongs"):
        return said(OBJECTS)
    if text.startswith("You decide in which order"):
        return said({"order": [{"id": id} for id in _listed(text, "Objects:")]})
    if text.startswith("You furnish a whole room"):
        return said({"objects": [_placed(id, size) for id, size in _listed(text, "Plan:").items()]}, "1. All at once.")
    place = json.loads(re.findall(r"^Place: (\{.*\})$", text, re.MULTILINE)[-1])
    return said(_placed(place["id"], place["size"]))


def asked_of(body: dict[str, Any]) -> str:
    """All that a request to a server says."""
    contents = [message["content"] for message in body["messages"]]
    parts = [[{"text": said}] if isinstance(said, str) else said for said in contents]
    return "\n".join(part["text"] for said in parts for part in said if "text" in part)


def _listed(text: str, heading: str) -> dict[str, list[float]]:
    lines = text.partition(f"{heading}\n")[2].splitlines()
    found = [json.loads(line) for line in lines if line.startswith("{")]
    return {entry["id"]: entry.get("size") for entry in found}


def _placed(id: str, size: list[float]) -> dict[str, Any]:
    position = next((at for kind, at in PLACES.items() if kind in id), (1.0, 1.0, 0.0))
    return {"id": id, "position": position, "yaw": 270, "size": size}
