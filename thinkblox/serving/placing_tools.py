"""Tools about one room and what stands in it: see the next object, place it, change what stands there."""

from typing import Annotated, Any, ClassVar

import msgspec
from msgspec import Meta

from thinkblox.observe import Sight
from thinkblox.serving.desk import Desk
from thinkblox.serving.room import AgentRoom, AnswerOutcome, pose_words
from thinkblox.serving.said import Said
from thinkblox.serving.tool import Tool
from thinkblox.steps import write_step
from thinkblox.wording import compact, describe_tie

MOST_TEXT = 25_000
"""Longest text of an answer that is taken at all [characters]; beyond `steps.MAX_TEXT` it is rejected."""

Handle = Annotated[str, Meta(description="handle of the room, as start_room or open_room gave it")]
Id = Annotated[str, Meta(description='id of an object, such as "chair_1"')]
Position = Annotated[
    tuple[float, float, float],
    Meta(description="[x, y, z] in metres: the centre of its footprint at its base; x east, y north, z up"),
]
Yaw = Annotated[float, Meta(description="degrees counter-clockwise; at 0 its front faces +x (east)")]
Size = Annotated[
    tuple[float, float, float],
    Meta(description="[along the front axis, across, up] in metres; as proposed if left out"),
]
Reasoning = Annotated[str, Meta(max_length=15_000, description="why, in lines; it is kept in the trace")]
Attributes = Annotated[tuple[Annotated[str, Meta(max_length=60)], ...], Meta(max_length=16)]


class ObserveTool(Tool, frozen=True, kw_only=True):
    """See the room so far and the next object to place: text, and pictures with metres along the walls, ids and fronts.

    After an answer that was not valid it also has what was measured of that.
    """

    reads: ClassVar[bool] = True
    room: Handle
    size: Annotated[int, Meta(ge=64, le=1024, description="of each picture [pixels]")] = 336
    views: Annotated[int, Meta(ge=0, le=5, description="pictures of the room, the first from above")] = 3
    pictures: Annotated[bool, Meta(description="false for the text alone")] = True

    def run(self, desk: Desk) -> Said:
        """Show it."""
        seen = desk.room(self.room).observation()
        sight = Sight(size=self.size, views=self.views, pictures=self.pictures)
        return Said(seen.chat(sight)[-1].parts)


class AnswerTool(Tool, frozen=True, kw_only=True):
    """Answer with one text: <think>numbered reasoning</think><answer>one JSON object</answer>.

    The object adds the next object, {"id", "position", "yaw", "size"}, or has an "action": move, turn, replace, remove
    or swap. It is measured in a physics simulation; what is not valid changes nothing, and you are told why.
    """

    room: Handle
    text: Annotated[str, Meta(max_length=MOST_TEXT)]

    def run(self, desk: Desk) -> Said:
        """Do it, if it may stand."""
        room = desk.room(self.room)
        return told(room, room.answer(self.text))


class PlaceTool(Tool, frozen=True, kw_only=True):
    """Place the next object of the plan, which observe shows. It is measured.

    What is not valid changes nothing, and you are told the numbers and what would help.
    """

    room: Handle
    id: Id
    position: Position
    yaw: Yaw
    size: Size | None = None
    reasoning: Reasoning = ""

    def run(self, desk: Desk) -> Said:
        """Place it, if it may stand."""
        room = desk.room(self.room)
        size = self.size or room.size_of(self.id)
        return _done(room, self.reasoning, id=self.id, position=self.position, yaw=self.yaw, size=size)


class MoveTool(Tool, frozen=True, kw_only=True):
    """Move what stands there elsewhere, turned if a yaw is given; what rests on it rides along. It is measured."""

    room: Handle
    id: Id
    position: Position
    yaw: Yaw | None = None
    reasoning: Reasoning = ""

    def run(self, desk: Desk) -> Said:
        """Move it, if it may stand there."""
        room = desk.room(self.room)
        return _done(room, self.reasoning, action="move", id=self.id, position=self.position, yaw=self.yaw)


class TurnTool(Tool, frozen=True, kw_only=True):
    """Turn what stands in the room about its own middle, with what rests on it. It is measured."""

    room: Handle
    id: Id
    yaw: Yaw
    reasoning: Reasoning = ""

    def run(self, desk: Desk) -> Said:
        """Turn it, if it may stand so."""
        return _done(desk.room(self.room), self.reasoning, action="turn", id=self.id, yaw=self.yaw)


class ReplaceTool(Tool, frozen=True, kw_only=True):
    """Let another thing stand where one stands, under its id: of another category, size or look. It is measured."""

    room: Handle
    id: Id
    category: Annotated[str, Meta(description='such as "armchair"; the same category if left out')] | None = None
    attributes: Annotated[Attributes, Meta(description='such as ["red", "wooden"]')] = ()
    position: Position | None = None
    yaw: Yaw | None = None
    size: Size | None = None
    reasoning: Reasoning = ""

    def run(self, desk: Desk) -> Said:
        """Replace it, if the other may stand there."""
        return _done(
            desk.room(self.room),
            self.reasoning,
            action="replace",
            id=self.id,
            position=self.position,
            yaw=self.yaw,
            size=self.size,
            category=self.category,
            attributes=self.attributes,
        )


class RemoveTool(Tool, frozen=True, kw_only=True):
    """Take away what stands in the room, if what rests on it stays where it is without it.

    An object of the plan is then to be placed again, unless you skip it.
    """

    room: Handle
    id: Id
    reasoning: Reasoning = ""

    def run(self, desk: Desk) -> Said:
        """Take it away."""
        return _done(desk.room(self.room), self.reasoning, action="remove", id=self.id)


class SwapTool(Tool, frozen=True, kw_only=True):
    """Let two things that stand there change places and directions, each with what rests on it. It is measured."""

    room: Handle
    id: Id
    other: Id
    reasoning: Reasoning = ""

    def run(self, desk: Desk) -> Said:
        """Swap them, if both may stand so."""
        return _done(desk.room(self.room), self.reasoning, action="swap", id=self.id, other=self.other)


class AskExpertTool(Tool, frozen=True, kw_only=True):
    """Let the embedded expert place the next object, searching and moving what is in the way if need be."""

    room: Handle

    def run(self, desk: Desk) -> Said:
        """Let it."""
        room = desk.room(self.room)
        return told(room, room.ask_expert())


class WantTool(Tool, frozen=True, kw_only=True):
    """Plan one object more; it is the next to place once all before it are. list_categories shows what there is."""

    room: Handle
    category: Annotated[str, Meta(min_length=1, max_length=60, pattern=r"^[A-Za-z][A-Za-z0-9 _-]*$")]
    attributes: Annotated[Attributes, Meta(description='such as ["red", "wooden"]')] = ()
    size: Size | None = None

    def run(self, desk: Desk) -> Said:
        """Plan it."""
        room = desk.room(self.room)
        target = room.want(self.category, self.attributes, self.size or (None, None, None))
        return Said((f"{target.id} is planned. {next_words(room)}",), {"id": target.id, "next": next_id(room)})


class SkipTool(Tool, frozen=True, kw_only=True):
    """Leave an object of the plan out; the report says so, with your reason."""

    room: Handle
    id: Id
    reason: Annotated[str, Meta(max_length=500)] = "left out by the agent"

    def run(self, desk: Desk) -> Said:
        """Leave it out."""
        room = desk.room(self.room)
        room.skip(self.id, " ".join(self.reason.split()) or "left out by the agent")
        return Said((f"{self.id} is left out. {next_words(room)}",), {"id": self.id, "next": next_id(room)})


def _done(room: AgentRoom, reasoning: str, **said: Any) -> Said:
    """What comes of an answer that is said in the language of all policies."""
    return told(room, room.answer(write_step(reasoning.splitlines() or ["(no reason was given)"], **said)))


def told(room: AgentRoom, outcome: AnswerOutcome) -> Said:
    """What came of an answer, and what is next."""
    lines = [("done: " if outcome.done else "not done, and nothing has changed: ") + outcome.line]
    lines += [f"{p.id} stands {pose_words(p)}" for p in outcome.committed]
    if outcome.unmet:
        lines.append(f"but not as wanted: {', '.join(map(describe_tie, outcome.unmet))}; move it, or leave it so")
    lines.append(next_words(room))
    data: dict[str, Any] = {"done": outcome.done, "id": outcome.id, "says": "\n".join(lines), "next": next_id(room)}
    tried = outcome.tried
    if tried.rejection is not None:
        data["rejection"] = msgspec.to_builtins(tried.rejection)
    if tried.verdict is not None:
        data["verdict"] = plain(tried.verdict)
    data["committed"] = [plain(placement) for placement in outcome.committed]
    data["unmet"] = [describe_tie(tie) for tie in outcome.unmet]
    return Said(("\n".join(lines),), data)


def next_words(room: AgentRoom) -> str:
    """What is to be placed next, in words."""
    target = room.target
    if target is None:
        return "Nothing is left to place: verify the room, change it, or save it."
    wanted = f", wanted {compact([describe_tie(tie) for tie in target.ties])}" if target.ties else ""
    return f"Next is {target.id}{wanted}; {room.to_place} to place. observe shows it."


def next_id(room: AgentRoom) -> str | None:
    """The id of what is to be placed next."""
    return None if room.target is None else room.target.id


def plain(value: object) -> Any:
    """A value as plain JSON values, without what it leaves open."""
    found = msgspec.to_builtins(value)
    return {key: part for key, part in found.items() if part not in (None, "", (), [])}
