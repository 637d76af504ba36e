"""What a policy sees when it is asked where the next object goes: one record, and no more than it holds."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Literal

from msgspec import Meta, structs

from thinkblox.assets.source import AssetSource
from thinkblox.chat import Chat, Message
from thinkblox.compact import compact_text
from thinkblox.errors import InputError
from thinkblox.plan import Plan, Target
from thinkblox.prompts import filled, one_line, template
from thinkblox.scene.arrangement import Arrangement, Known
from thinkblox.scene.asset import Asset, AssetCard, Mount
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.value import Value, Vec3
from thinkblox.wording import compact, describe_tie, free_words, layout_text, planned_line, room_words, shortened

if TYPE_CHECKING:
    from PIL.Image import Image


class Sight(Value, frozen=True, kw_only=True):
    """How much of a room a policy is shown; each kind of mark can be left out, for ablations.

    Attributes:
        size: width and height of each picture [pixels].
        pictures: whether there are any.
        views: pictures of the room: one from above, and the others from corners of it.
        target: whether the object to place has a picture of its own.
        grid: whether the pictures have a grid with metres along the walls.
        ids: whether they name the objects.
        fronts: whether arrows show which way they face.
        layout: characters of the layout in the text; what matters least beyond that is counted only.
        words: all that is known with what it means, or the numbers alone, in few words, for models that are small.
    """

    size: Annotated[int, Meta(ge=32, le=2048)] = 336
    pictures: bool = True
    views: Annotated[int, Meta(ge=0, le=5)] = 3
    target: bool = True
    grid: bool = True
    ids: bool = True
    fronts: bool = True
    layout: Annotated[int, Meta(ge=0)] = 12_000
    words: Literal["full", "compact"] = "full"


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

    def text(self, sight: Sight | None = None) -> str:
        """The observation in words and JSON, as a language model reads it: instructions, then what is the case."""
        first, changing = self._words(sight or Sight())
        return f"{template('step')}\n\n{first}\n{changing}"

    def lasting_text(self, sight: Sight | None = None) -> str:
        """The part of the text with which the next step's begins too, as long as nothing that stands is moved: up to
        the end of the layout, or of its first half where there is more than `sight.layout` allows.
        """
        sight = sight or Sight()
        layout = layout_text(self.layout, self.target, sight.layout)
        return f"{template('step')}\n\n{self._beginning()}" + (f"\n{layout.head}" if layout.head else "")

    def chat(self, sight: Sight | None = None) -> Chat:
        """The observation as it is said to a model: what never changes, what grows at its end, what changes, and the
        pictures, each with its caption before it.

        Raises:
            InputError: pictures of an observation that was read from a file; `observe` the scene again.
        """
        sight = sight or Sight()
        if sight.words == "compact":
            pictures = self.pictures(sight) if sight.pictures else ()
            return (Message("user", (compact_text(self), *(picture for _, picture in pictures))),)
        first, changing = self._words(sight)
        parts: list[str | Image] = [f"{first}\n{changing}"]
        if sight.pictures:
            for caption, picture in self.pictures(sight):
                parts += [caption, picture]
        return (Message("system", (template("step"),)), Message("user", tuple(parts)))

    def images(self, sight: Sight | None = None, *, size: int | None = None) -> tuple["Image", ...]:
        """The pictures of the room with its marks, the first from above, and then of the object to place.

        Args:
            sight: what is shown.
            size: width and height of each [pixels], before that of `sight`.

        Raises:
            InputError: the observation was read from a file, which holds no shapes; `observe` the scene again.
        """
        sight = sight or Sight()
        seen = self.pictures(sight if size is None else structs.replace(sight, size=size))
        return tuple(picture for _, picture in seen)

    def pictures(self, sight: Sight | None = None) -> list[tuple[str, "Image"]]:
        """The same, each with what it shows in words; where numbers stand for ids, the first says which."""
        from thinkblox.sim.render.views import Marking, render_target, room_views

        sight = sight or Sight()
        shown: tuple[Scene, Asset] | None = self.__dict__.get("shown")
        if shown is None:
            raise InputError("this observation was not made by observe(), and knows no shapes to draw")
        marking = Marking(grid=sight.grid, ids=sight.ids, fronts=sight.fronts)
        views = room_views(shown[0], size=sight.size, count=sight.views, marking=marking)
        found = []
        for view in views:
            less = f" ({len(view.unmarked)} small things have no mark here)" if view.unmarked else ""
            found.append((f"The room {view.name}{less}:", view.picture))
        if views and views[0].legend:
            found[0] = (f"Numbers in the pictures: {'; '.join(views[0].legend)}\n{found[0][0]}", found[0][1])
        if sight.target:
            picture = render_target(shown[1], size=max(sight.size // 2, 32), front=sight.fronts)
            front = ", the arrow at its front" if sight.fronts and shown[1].front == "one" else ""
            found.append((f"{self.target.id}, the object to place{front}:", picture))
        return found

    def _number(self) -> int:
        return 1 + next((n for n, t in enumerate(self.plan.targets) if t.id == self.target.id), 0)

    def _words(self, sight: Sight) -> tuple[str, str]:
        """What stays, and what changes from step to step."""
        layout = layout_text(self.layout, self.target, sight.layout).whole
        changing = [f"Step: {self._number()} of {len(self.plan.targets)}", f"Place: {compact(self._target())}"]
        if self.asset.mount == "surface":
            changing.insert(0, f"Free: {compact(free_words(self.layout, self.target))}")
        if self.feedback:
            changing.append(filled("revision", feedback="\n".join(f"- {line}" for line in self.feedback)))
        return self._beginning() + (f"\n{layout}" if layout else ""), "\n".join(changing)

    def _beginning(self) -> str:
        plan = [self._planned(target) for target in self.plan.targets]
        free = [f"Keep free: {', '.join(self.plan.free)}"] if self.plan.free else []
        said = [f"Prompt: {one_line(self.prompt)}", f"Room: {room_words(self.layout.room)}", *free]
        return "\n".join([*said, "Plan:", *plan, "Layout:"])

    def _planned(self, target: Target) -> str:
        kind = self.kinds.get(target.category)
        return planned_line(target, kind.size if kind else None, kind.mount if kind else None)

    def _target(self) -> dict[str, object]:
        asset = self.asset
        said: dict[str, object] = {
            "id": self.target.id,
            "category": asset.category,
            "description": asset.description,
            "mount": asset.mount,
            "mass": shortened(asset.mass, 2),
            "front": asset.front,
            "size": [shortened(extent) for extent in asset.size],
        }
        if self.sizes is not None:
            said["sizes"] = [[shortened(extent) for extent in size] for size in self.sizes]
        if asset.opens:
            said["opens"] = asset.opens
        if asset.surfaces:
            said["surface_heights"] = [shortened(surface.position[2]) for surface in asset.surfaces]
        said["wanted"] = [describe_tie(tie) for tie in self.target.wanted]
        if self.target.denied:
            said["unwanted"] = [describe_tie(tie) for tie in self.target.denied]
        return said


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
