"""What a policy sees when it is asked where the next object goes."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import msgspec

from thinkblox.brief import Relation
from thinkblox.plan import Plan, Target, Tie
from thinkblox.scene.asset import Asset
from thinkblox.scene.scene import Scene

if TYPE_CHECKING:
    from PIL.Image import Image

INSTRUCTIONS = """\
You furnish a room one object at a time. Metres; x east, y north, z up; yaw in degrees counter-clockwise, 0 = the front
faces +x; position = the centre of the footprint at the object's base; size = (along the front axis, across, up).
Reason in numbered lines inside <think>, then answer with one JSON object inside <answer>:
<think>
1. ...
</think>
<answer>{"id": "...", "position": [x, y, z], "yaw": degrees, "size": [depth, width, height]}</answer>
The object must not collide, must stay inside the room, must rest on something and stand still, and must leave doors and
ways free; all of this is measured in a physics simulation."""


@dataclass(frozen=True)
class Observation:
    """One decision: the prompt, the layout so far, the object to place, and what was measured on earlier tries.

    Attributes:
        plan: everything that is to be placed; a policy may leave room for what comes later.
        feedback: one line for each earlier try at this object, with its measured failure.
    """

    plan: Plan
    scene: Scene
    target: Target
    asset: Asset
    feedback: tuple[str, ...] = ()

    @property
    def prompt(self) -> str:
        """The prompt the room is made for."""
        return self.plan.brief.prompt

    def text(self) -> str:
        """The observation in words and JSON, as a language model reads it."""
        parts = [
            INSTRUCTIONS,
            f"Prompt: {self.prompt}",
            f"Room: {_json(self._room())}",
            f"Layout: {_json([self._object(p.id) for p in self.scene.placements])}",
            f"Place: {_json(self._target())}",
        ]
        if self.feedback:
            parts.append("Earlier tries failed:\n" + "\n".join(f"- {line}" for line in self.feedback))
        return "\n".join(parts)

    def images(self, *, size: int = 448) -> tuple["Image", "Image"]:
        """The layout so far with its objects marked, and the object to place [pixels along a side]."""
        from thinkblox.sim.render import render_asset, render_marked

        return render_marked(self.scene, size=size), render_asset(self.asset, size=size // 2)

    def _room(self) -> dict[str, object]:
        room = self.scene.room
        openings = [
            {"id": o.id, "wall": room.walls[o.wall].name, "offset": o.offset, "width": o.width, "sill": o.sill}
            for o in room.openings
        ]
        return {
            "floor": room.floor,
            "height": room.height,
            "walls": [wall.name for wall in room.walls],
            "openings": openings,
        }

    def _object(self, id: str) -> dict[str, object]:
        p = self.scene[id]
        return {"id": p.id, "position": p.position, "yaw": p.yaw, "size": p.size, "on": p.support}

    def _target(self) -> dict[str, object]:
        asset = self.asset
        surfaces = [surface.position[2] for surface in asset.surfaces]
        ties = [describe_tie(tie) for tie in self.target.ties]
        return {
            "id": self.target.id,
            "description": asset.description,
            "mount": asset.mount,
            "size": asset.size,
            "surface_heights": surfaces,
            "wanted": ties,
        }


def describe_tie(tie: Tie | Relation) -> str:
    """A relation as a term, "next_to(bed_1)": no phrase of the step language, for it says what is wanted, not where."""
    return f"{tie.kind}({', '.join(tie.anchors)})" if tie.anchors else tie.kind


def _json(value: object) -> str:
    return msgspec.json.encode(value).decode()
