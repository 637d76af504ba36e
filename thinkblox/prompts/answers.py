"""What a model answers to the templates that ask for more than one step: an object set, a plan, an edit, a whole room.

Each answer stands as one JSON object in <answer>, after the reasoning in <think>. `read_answer` is total: any text
gives the answer or a Rejection.
"""

from collections.abc import Callable
from typing import Annotated, Literal, TypeVar

from msgspec import Meta, structs

from thinkblox.brief import (
    Brief,
    Count,
    Measures,
    Name,
    OpeningRequest,
    Ordinal,
    Place,
    Relation,
    RelationKind,
    Request,
)
from thinkblox.checked import AboveZero, CheckedValue, ObjectId
from thinkblox.errors import InputError
from thinkblox.plan import Plan, Target, Tie, in_order
from thinkblox.steps import Answer, Rejection, decoded, tagged
from thinkblox.value import Value

MOST_OBJECTS = 400
"""Most objects of one answer."""
MAX_ANSWER = 200_000
"""Longest text of these that is read [characters]."""
Text = Annotated[str, Meta(max_length=1000)]
Texts = Annotated[tuple[Text, ...], Meta(max_length=200)]
A = TypeVar("A", bound=Value)


class ListedRoom(CheckedValue, frozen=True, kw_only=True):
    """What the prompt says of the room; lengths in metres, None where it does not say."""

    type: Name = "room"
    shape: Literal["rectangle", "L"] = "rectangle"
    width: AboveZero | None = None
    depth: AboveZero | None = None
    area: AboveZero | None = None
    height: AboveZero | None = None


class ListedObject(CheckedValue, frozen=True, kw_only=True):
    """One entry of an object set: `count` things of a kind.

    Attributes:
        id: unique in its set; relations refer to it.
        size: depth, width and height [m]; None for what is left open.
        asked: the prompt names it.
    """

    id: Name
    category: Name
    count: Count = 1
    description: Text = ""
    attributes: Texts = ()
    size: Measures = (None, None, None)
    asked: bool = True


class ListedRelation(CheckedValue, frozen=True, kw_only=True):
    """A relation between entries of an object set, or to a Place; as `brief.Relation`."""

    subject: Name
    kind: RelationKind
    anchors: Annotated[tuple[Name, ...], Meta(max_length=8)] = ()
    each: bool = False
    asked: bool = True
    rows: Ordinal = 0
    negated: bool = False


class ObjectSet(CheckedValue, frozen=True, kw_only=True):
    """The answer to "objects": what belongs into a room, with descriptions; `brief` makes a Brief of it."""

    room: ListedRoom = ListedRoom()
    style: Texts = ()
    objects: Annotated[tuple[ListedObject, ...], Meta(max_length=MOST_OBJECTS)]
    relations: Annotated[tuple[ListedRelation, ...], Meta(max_length=1000)] = ()
    doors: Annotated[int, Meta(ge=0, le=20)] | None = None
    windows: Annotated[int, Meta(ge=0, le=20)] | None = None
    excluded: Annotated[tuple[Name, ...], Meta(max_length=200)] = ()
    free: Annotated[tuple[Place, ...], Meta(max_length=20)] = ()
    not_understood: Texts = ()

    def brief(self, prompt: str, *, category: Callable[[str], str | None] = lambda noun: noun) -> Brief:
        """The brief that this is for a prompt.

        Args:
            prompt: what was asked for.
            category: the category for a noun of the answer; of None, the thing is listed as missing.

        Raises:
            InputError: more objects than a room is given, an id twice, or a relation to what is not there.
        """
        if (total := sum(listed.count for listed in self.objects)) > MOST_OBJECTS:
            raise InputError(f"the object set names {total} objects; at most {MOST_OBJECTS} are placed in a room")
        ids = [listed.id for listed in self.objects]
        if twice := next((id for id in ids if ids.count(id) > 1), ""):
            raise InputError(f"the object set has the id {twice!r} twice; ids must differ")
        found = {listed.id: category(listed.category) for listed in self.objects}
        made = {id for id, known in found.items() if known is not None}
        whole = self.room.width is not None and self.room.depth is not None
        return Brief(
            prompt=prompt,
            room_type=self.room.type,
            shape=self.room.shape,
            width=self.room.width if whole else None,
            depth=self.room.depth if whole else None,
            area=None if whole else self.room.area,
            height=self.room.height,
            openings=tuple(_openings(self.doors, self.windows)),
            requests=tuple(_request(listed, known) for listed in self.objects if (known := found[listed.id])),
            relations=tuple(self._relations(made, set(ids))),
            style=self.style,
            missing=tuple(f"{o.count} {o.category}" for o in self.objects if o.id not in made and o.asked),
            unknown=self.not_understood,
            excluded=self.excluded,
            free=self.free,
            empty=all(listed.asked for listed in self.objects),
        )

    def _relations(self, made: set[str], ids: set[str]) -> list[Relation]:
        for said in self.relations:
            for name in (said.subject, *(a for a in said.anchors if a not in PLACES)):
                if name not in ids:
                    raise InputError(
                        f"the object set relates {said.subject!r} {said.kind} {name!r}, which is neither one of its"
                        " ids nor a place of the room"
                    )
        return [
            Relation(**structs.asdict(said))
            for said in self.relations
            if made.issuperset({said.subject, *(a for a in said.anchors if a not in PLACES)})
        ]


class PlannedRelation(CheckedValue, frozen=True, kw_only=True):
    """What an object needs of others: ids of objects, or a Place."""

    kind: RelationKind
    anchors: Annotated[tuple[Name, ...], Meta(max_length=8)] = ()


class PlannedObject(CheckedValue, frozen=True, kw_only=True):
    """One object of a planned order."""

    id: ObjectId
    relations: Annotated[tuple[PlannedRelation, ...], Meta(max_length=8)] = ()


class PlannedOrder(CheckedValue, frozen=True, kw_only=True):
    """The answer to "plan": anchors, the order from coarse to fine, and what depends on what."""

    anchors: Annotated[tuple[ObjectId, ...], Meta(max_length=MOST_OBJECTS)] = ()
    order: Annotated[tuple[PlannedObject, ...], Meta(max_length=MOST_OBJECTS)]

    def plan(self, known: Plan) -> Plan:
        """A plan of the same objects in this order; what the brief asks for stays required.

        Raises:
            InputError: an object is missing, named twice or not known, or objects wait for each other.
        """
        targets = {target.id: target for target in known.targets}
        ids = [planned.id for planned in self.order]
        if wrong := [id for id in ids if id not in targets or ids.count(id) > 1]:
            raise InputError(f"the plan names {wrong[0]!r}, which is not one of the objects, or twice")
        if absent := [id for id in targets if id not in ids]:
            raise InputError(f"the plan leaves out {', '.join(absent[:5])}")
        tied = [_tied(targets[planned.id], planned, targets) for planned in self.order]
        return structs.replace(known, targets=tuple(in_order(tied)))


class EditAnswer(Value, frozen=True, kw_only=True):
    """The answer to "edit": what the instruction speaks of, and what is done.

    Attributes:
        named: ids of the objects that are meant.
        could_mean: ids of all that it could mean, where that is not clear.
        actions: in the order in which they are done.
    """

    named: Annotated[tuple[ObjectId, ...], Meta(max_length=MOST_OBJECTS)] = ()
    could_mean: Annotated[tuple[ObjectId, ...], Meta(max_length=MOST_OBJECTS)] = ()
    actions: Annotated[tuple[Answer, ...], Meta(max_length=MOST_OBJECTS)] = ()


class WholeRoom(Value, frozen=True, kw_only=True):
    """The answer to "one_shot": where every object of the plan goes."""

    objects: Annotated[tuple[Answer, ...], Meta(max_length=MOST_OBJECTS)]


PLACES: tuple[str, ...] = Place.__args__  # type: ignore[attr-defined]
RELATIONS: tuple[str, ...] = RelationKind.__args__  # type: ignore[attr-defined]


def read_answer(text: str, kind: type[A]) -> A | Rejection:
    """Read `kind` from a model's text; never raises, whatever the text."""
    parts = tagged(text, most=MAX_ANSWER)
    return parts if isinstance(parts, Rejection) else decoded(parts[1], kind)


def _openings(doors: int | None, windows: int | None) -> list[OpeningRequest]:
    asked = [OpeningRequest(kind="door", count=doors)] if doors is not None else []
    return asked + ([OpeningRequest(kind="window", count=windows)] if windows is not None else [])


def _request(listed: ListedObject, category: str) -> Request:
    return Request(
        key=listed.id,
        category=category,
        count=listed.count,
        asked=listed.asked,
        attributes=listed.attributes,
        phrase=listed.description if listed.asked else "",
        size=listed.size,
    )


def _tied(target: Target, planned: PlannedObject, targets: dict[str, Target]) -> Target:
    """The target with what the plan says of it, which decides where it goes unless the prompt does."""
    said: list[Tie] = []
    for relation in planned.relations:
        if strange := next((a for a in relation.anchors if a not in targets and a not in PLACES), ""):
            raise InputError(f"the plan ties {target.id} to {strange!r}, which is neither an object nor a place")
        said.append(Tie(kind=relation.kind, anchors=relation.anchors, asked=False))
    known = {(tie.kind, tie.anchors) for tie in target.ties}
    new = [tie for tie in said if (tie.kind, tie.anchors) not in known and target.id not in tie.anchors]
    asked = [tie for tie in target.ties if tie.asked]
    implied = [tie for tie in target.ties if not tie.asked]
    return structs.replace(target, ties=(*asked, *new, *implied))
