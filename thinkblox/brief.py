"""What a prompt asks for. The values only; `thinkblox.reading` makes them from text."""

from typing import Annotated, Literal

from msgspec import Meta

from thinkblox.checked import AboveZero, CheckedValue, Extent
from thinkblox.layings import Colour, Laying

RelationKind = Literal[
    "on",  # rests on the anchor
    "above",  # over the anchor without touching it
    "under",  # below the anchor, or beneath it (a rug under a bed)
    "next_to",  # beside it, a hand's breadth to half a metre away
    "left_of",  # to the anchor's own left, as somebody sitting in it would say
    "right_of",
    "in_front_of",
    "behind",
    "at_foot_of",  # at the end of a bed away from its head
    "at",  # a seat at its place: facing a desk or table and drawn up to it
    "around",  # several, evenly about the anchor and facing it
    "between",  # between two anchors, or between the members of one
    "facing",  # its front points at the anchor
    "facing_away",  # its back points at the anchor
    "opposite",  # across the room from the anchor, facing it
    "near",  # within 1.5 m
    "far",  # well away from it: over 4 m, or over 2 m in a room too small for that
    "inside",  # within a container: a rack, a shelf, a cupboard, a basket
    "at_long_side",  # beside one of the anchor's two longer sides
    "at_short_side",  # beside one of the anchor's two shorter sides
    "outside",  # on the floor beside a container rather than in it
    "back_to_back",  # the backs against each other
    "against_wall",
    "in_corner",
    "in_centre",
    "in_rows",
]
Place = Literal[
    "wall",
    "long_wall",
    "short_wall",
    "north_wall",
    "east_wall",
    "south_wall",
    "west_wall",
    "left_wall",
    "right_wall",
    "far_wall",
    "near_wall",
    "floor",
    "corner",
    "window",
    "door",
    "centre",
    "ceiling",
    "one_wall",
    "opposite_wall",
]
"""Parts of the room that a relation can name as its anchor. Left, right, far and near are as seen by somebody who comes
in by the door; a plan names the walls they mean. "one_wall" is any wall, the same for all that name it, and
"opposite_wall" the one across from it. "in_corner" names one of these walls, or the two that meet there."""


Measures = tuple[Extent | None, Extent | None, Extent | None]
"""Depth, width and height in the order of an asset's size [m]; None for what the prompt leaves open."""
Name = Annotated[str, Meta(min_length=1, max_length=200)]
Count = Annotated[int, Meta(ge=1, le=200)]
"""How many of a kind are asked for."""
Ordinal = Annotated[int, Meta(ge=0, le=1_000_000)]


class Request(CheckedValue, frozen=True, kw_only=True):
    """Objects of one kind that belong to the room.

    Attributes:
        key: unique in its brief ("lamp", "lamp-2"); relations refer to it.
        category: one of the catalogue's, or the name of what has a plain stand-in.
        asked: named in the prompt; False when assumed from what such a room usually holds.
        attributes: what the prompt says of it, in the catalogue's words ("round", "double", "low").
        phrase: the words it was read from; empty when assumed.
        called: what the prompt calls one of them, where that is not our own word for it ("tote", "teacher's desk").
        size: what the prompt says of its size.
        drawn: how large it is where the prompt leaves that open, as the seed has it.
        least, most: how many there may be, where the prompt leaves that open ("at least three"); `count` lies within.
        unshown: what the prompt says of it that no shape, colour or material of ours shows ("clawfoot", "tartan").
        states: how the prompt wants to find it ("open", "folded", "rolled up"); shown where a thing can be
            made so, else noted.
    """

    key: Name
    category: Name
    count: Count = 1
    asked: bool = True
    attributes: tuple[str, ...] = ()
    phrase: str = ""
    called: Annotated[str, Meta(max_length=200)] = ""
    size: Measures = (None, None, None)
    drawn: Measures = (None, None, None)
    least: Annotated[int, Meta(ge=0, le=200)] | None = None
    most: Annotated[int, Meta(ge=0, le=200)] | None = None
    unshown: tuple[str, ...] = ()
    states: tuple[str, ...] = ()

    @property
    def bounds(self) -> tuple[int, int]:
        """Fewest and most of them that are as asked."""
        if self.least is None and self.most is None:
            return self.count, self.count
        return self.least or 0, self.most if self.most is not None else max(self.count, 10**6)


class Relation(CheckedValue, frozen=True, kw_only=True):
    """`subject` stands in this relation to `anchors`: keys of requests, or a Place.

    Attributes:
        each: one share of the subject for every member of the anchor ("a lamp on each"; "a plant in each corner").
        asked: named in the prompt; False when it is only what such things usually do.
        rows: number of rows for "in_rows"; 0 when the prompt does not say.
        spread: over how many walls or corners they are shared out ("shelves on two walls"); 0 when it does not say.
        negated: it must not hold.
    """

    kind: RelationKind
    subject: Name
    anchors: tuple[str, ...] = ()
    each: bool = False
    asked: bool = True
    rows: Ordinal = 0
    spread: Ordinal = 0
    negated: bool = False


Look = tuple[Name, ...]
"""What is said of all the furniture of a room at once, in the words of attributes: ("red", "leather")."""
Fate = Literal["requested", "related", "constraint", "style", "filler", "not_understood"]
"""What became of a word of the prompt."""


class Word(CheckedValue, frozen=True, kw_only=True):
    """A word of the prompt and what became of it; `start` is where it begins [characters]."""

    text: str
    start: Ordinal
    fate: Fate


class OpeningRequest(CheckedValue, frozen=True, kw_only=True):
    """A door or window that the prompt asks for, or does not want: then `count` is 0."""

    kind: Literal["door", "window"]
    wall: str = ""
    count: Annotated[int, Meta(ge=0, le=200)] = 1


class SurfaceRequest(CheckedValue, frozen=True, kw_only=True):
    """What the prompt says of the floor, of all walls, or of one of them.

    Attributes:
        laying: what it is made of; None where it only has a colour.
        colour: sRGB; None where it only has a material.
        second: the colour of every other tile or stripe.
        phrase: the words it was read from.
    """

    part: Literal["floor", "walls", "wall"]
    laying: Laying | None = None
    colour: Colour | None = None
    second: Colour | None = None
    phrase: str = ""


class Brief(CheckedValue, frozen=True, kw_only=True):
    """What the prompt asks for.

    Attributes:
        room_type: "bedroom", "classroom", ...; "room" when the prompt does not say.
        shape: of the floor.
        width, depth: of the floor [m], where the prompt gives them; the other side is open where it gives one.
        area: of the floor [m2], where the prompt gives that.
        height: of the room [m], where the prompt gives it.
        people: how many the room is said to be for; 0 where that is not said.
        style: adjectives about the whole ("calm", "cosy").
        surfaces: what floor and walls are to be like.
        looks: what the furniture as a whole is to be like.
        missing: things asked for that are not made, with their count in words.
        beyond: things asked for that are more than one room is given, with their count in words.
        left_out: what goes without saying and has no room in a room of the given size, in sentences.
        unknown: words that meant nothing to us, or that we can do nothing about, and that name or change a thing.
        empty: the prompt wants nothing besides what it names.
        excluded: categories that must not be there.
        free: parts of the room that are to stay free of furniture.
        account: every word of the prompt and what became of it; empty where the reader keeps no account.
    """

    prompt: str
    language: str = "en"
    room_type: str = "room"
    shape: Literal["rectangle", "L"] = "rectangle"
    width: AboveZero | None = None
    depth: AboveZero | None = None
    area: AboveZero | None = None
    height: AboveZero | None = None
    people: Ordinal = 0
    openings: tuple[OpeningRequest, ...] = ()
    requests: tuple[Request, ...] = ()
    relations: tuple[Relation, ...] = ()
    style: tuple[str, ...] = ()
    surfaces: tuple[SurfaceRequest, ...] = ()
    looks: tuple[Look, ...] = ()
    missing: tuple[str, ...] = ()
    beyond: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()
    unknown: tuple[str, ...] = ()
    empty: bool = False
    excluded: tuple[Name, ...] = ()
    free: tuple[Place, ...] = ()
    account: tuple[Word, ...] = ()

    def request(self, key: str) -> Request:
        """The request called `key`; raises KeyError."""
        return next(r for r in self.requests if r.key == key)
