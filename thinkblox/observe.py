"""What a policy sees when it is asked where the next object goes: one record, and no more than it holds."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

import msgspec
from msgspec import structs

from thinkblox.assets.source import AssetSource
from thinkblox.brief import Relation
from thinkblox.chat import Chat, Message
from thinkblox.errors import InputError
from thinkblox.plan import Plan, Target, Tie
from thinkblox.scene.arrangement import Arrangement, Known
from thinkblox.scene.asset import Asset, AssetCard, Mount
from thinkblox.scene.free_spots import free_spots
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.value import Value, Vec3

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
Walls are listed counter-clockwise, wall i from corner i of the floor to corner i + 1; an opening begins "offset" from
its wall's start. "free" lists [x, y, radius] of free circles on a surface, "opens" doors and drawers that need space.
The object must not collide, must stay inside the room, must rest on something and stand still, and must leave doors and
ways free; all of this is measured in a physics simulation."""
SPOTS = 2
"""Free spots that the text names for each surface."""


class Sight(Value, frozen=True, kw_only=True):
    """How much of a room a policy is shown.

    Attributes:
        size: width and height of each picture [pixels].
        pictures: whether there are any.
    """

    size: int = 336
    pictures: bool = True


class Kind(Value, frozen=True, kw_only=True):
    """What is known of a category of the plan before it is there: the size of an ordinary one [m], and its mount."""

    size: Vec3
    mount: Mount


class Layout(Arrangement, frozen=True, kw_only=True):
    """A scene as a policy sees it: what stands where, and of each asset its card."""

    room: Room
    placements: tuple[Placement, ...] = ()
    cards: dict[str, AssetCard] = {}

    @staticmethod
    def of(scene: Scene) -> "Layout":
        """The layout of a scene."""
        cards = {id: asset.card for id, asset in scene.assets.items()}
        return Layout(room=scene.room, placements=tuple(scene.placements), cards=cards)

    def asset_of(self, placement: Placement) -> AssetCard:
        """The card of the asset that a placement shows."""
        return self.cards[placement.asset]

    def with_placement(self, placement: Placement, asset: Known) -> "Layout":
        """Return this layout and one object more, or that object replaced in its place in the order."""
        card = asset.card if isinstance(asset, Asset) else asset
        kept = [placement if p.id == placement.id else p for p in self.placements]
        if placement.id not in self:
            kept.append(placement)
        return structs.replace(self, placements=tuple(kept), cards={**self.cards, card.id: card})


class Observation(Value, frozen=True, kw_only=True, dict=True):
    """One decision: the prompt, the layout so far, the object to place, and what was measured in the last round.

    It is a value: written as JSON and read back it says the same, and a policy answers the same. Its pictures can be
    had where it was made by `observe`.

    Attributes:
        plan: everything that is to be placed; a policy may leave room for what comes later.
        kinds: what is known of the categories of the plan.
        layout: the room, and what stands in it.
        target: the object of this decision, one of the plan's.
        asset: what it is, at the size that is proposed for it.
        sizes: smallest and largest size that it can have [m]; None where it has only this one.
        round: how often the policy has been asked for this object before.
        feedback: a line for each candidate of the round before: its pose, what was measured, what would help.
    """

    plan: Plan
    kinds: dict[str, Kind] = {}
    layout: Layout
    target: Target
    asset: AssetCard
    sizes: tuple[Vec3, Vec3] | None = None
    round: int = 0
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
            f"Plan: {_json([self._planned(target) for target in self.plan.targets])}",
            f"Layout: {_json([self._object(p) for p in self.layout.placements])}",
            f"Step: {self._number()} of {len(self.plan.targets)}",
            f"Place: {_json(self._target())}",
        ]
        if self.feedback:
            parts.append("Measured in the last round:\n" + "\n".join(f"- {line}" for line in self.feedback))
        return "\n".join(parts)

    def chat(self, sight: Sight | None = None) -> Chat:
        """The observation as it is said to a model."""
        sight = sight or Sight()
        pictures = self.images(size=sight.size) if sight.pictures else ()
        return (Message("user", (self.text(), *pictures)),)

    def images(self, *, size: int = 448) -> tuple["Image", "Image"]:
        """The layout so far with its objects marked, and the object to place [pixels along a side].

        Raises:
            InputError: the observation was read from a file, which holds no shapes; `observe` the scene again.
        """
        from thinkblox.sim.render import render_asset, render_marked

        shown: tuple[Scene, Asset] | None = self.__dict__.get("shown")
        if shown is None:
            raise InputError("this observation was not made by observe(), and knows no shapes to draw")
        return render_marked(shown[0], size=size), render_asset(shown[1], size=size // 2)

    def _number(self) -> int:
        return 1 + next((n for n, t in enumerate(self.plan.targets) if t.id == self.target.id), 0)

    def _room(self) -> dict[str, object]:
        room = self.layout.room
        openings = [
            {
                "id": o.id,
                "kind": o.kind,
                "wall": room.walls[o.wall].name,
                "offset": o.offset,
                "width": o.width,
                "sill": o.sill,
                "height": o.height,
            }
            for o in room.openings
        ]
        return {
            "floor": room.floor,
            "height": room.height,
            "walls": [wall.name for wall in room.walls],
            "openings": openings,
        }

    def _planned(self, target: Target) -> dict[str, object]:
        planned: dict[str, object] = {"id": target.id}
        if target.id in self.layout:
            planned["done"] = True
        elif target.category in self.kinds:
            planned["size"] = self.kinds[target.category].size
        if target.ties:
            planned["wanted"] = [describe_tie(tie) for tie in target.ties]
        return planned

    def _object(self, placement: Placement) -> dict[str, object]:
        p = placement
        seen: dict[str, object] = {"id": p.id, "position": p.position, "yaw": p.yaw, "size": p.size, "on": p.support}
        card = self.layout.asset_of(p)
        if card.opens:
            seen["opens"] = card.opens
        surfaces = [
            {
                "name": surface.name,
                "z": round(p.position[2] + surface.position[2], 4),
                "size": surface.size,
                "free": [[*spot.position[:2], spot.clear] for spot in free_spots(self.layout, p, surface, count=SPOTS)],
            }
            for surface in card.surfaces
        ]
        return {**seen, "surfaces": surfaces} if surfaces else seen

    def _target(self) -> dict[str, object]:
        asset = self.asset
        return {
            "id": self.target.id,
            "description": asset.description,
            "mount": asset.mount,
            "mass": round(asset.mass, 2),
            "front": asset.front,
            "size": asset.size,
            "sizes": self.sizes,
            "opens": asset.opens,
            "surface_heights": [surface.position[2] for surface in asset.surfaces],
            "wanted": [describe_tie(tie) for tie in self.target.ties],
            **({"unwanted": [describe_tie(tie) for tie in self.target.denied]} if self.target.denied else {}),
            **({"keep_free": self.plan.free} if self.plan.free else {}),
        }


def kinds_of(plan: Plan, source: AssetSource) -> dict[str, Kind]:
    """What is known of the categories of a plan before anything of them is there; raises InputError as the source."""
    found = {target.category: source.usual(target.category) for target in plan.targets}
    return {category: Kind(size=size, mount=mount) for category, (size, mount) in found.items()}


def observe(
    scene: Scene,
    plan: Plan,
    target: Target,
    asset: Asset,
    *,
    kinds: Mapping[str, Kind],
    sizes: tuple[Vec3, Vec3] | None = None,
    round: int = 0,
    feedback: tuple[str, ...] = (),
) -> Observation:
    """The one way in which an observation is made, at run time and from a saved episode alike."""
    observation = Observation(
        plan=plan,
        kinds=dict(kinds),
        layout=Layout.of(scene),
        target=target,
        asset=asset.card,
        sizes=sizes,
        round=round,
        feedback=feedback,
    )
    observation.__dict__["shown"] = (scene, asset)
    return observation


def describe_tie(tie: Tie | Relation) -> str:
    """A relation as a term, "next_to(bed_1)": no phrase of the step language, for it says what is wanted, not where."""
    return f"{tie.kind}({', '.join(tie.anchors)})" if tie.anchors else tie.kind


def _json(value: object) -> str:
    return msgspec.json.encode(value).decode()
