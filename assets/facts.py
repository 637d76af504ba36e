"""What is known of a kind of thing besides its shape: its words, its company and how people live with it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal, get_args

from thinkblox.assets.groups import GROUPS
from thinkblox.brief import RelationKind
from thinkblox.errors import InputError
from thinkblox.scene.asset import Gaze
from thinkblox.value import Vec2

Role = Literal["holds", "carries", "over", "inside", "under", "below"]
"""What a thing is to another one on, in, under or above it."""
_LAST = 10**6
_RELATIONS: tuple[str, ...] = get_args(RelationKind)


@dataclass(frozen=True, kw_only=True)
class Hanging:
    """How a thing hangs on a wall.

    Attributes:
        middle: height of its middle above the floor [m].
        above: free height over what it hangs above [m].
        windows: whether it belongs to windows, and then over each or, where narrower, at both of its sides.
    """

    middle: float = 1.5
    above: float = 0.2
    windows: Literal["no", "over", "beside"] = "no"


@dataclass(frozen=True, kw_only=True)
class Use:
    """Floor that people need by some sides of a thing.

    Attributes:
        sides: of "front", "back", "left" and "right".
        depth: how far out it stays free [m].
        number: how many of the sides are needed.
    """

    sides: tuple[Literal["front", "back", "left", "right"], ...]
    depth: float
    number: int


@dataclass(frozen=True, kw_only=True)
class Companion:
    """What a thing keeps its place by, rather than by the surface they share.

    Attributes:
        category: the companion's.
        side: the side of it that the thing takes, forward and to the left, from -1 to 1.
    """

    category: str
    side: Vec2


@dataclass(frozen=True, kw_only=True)
class RowGaps:
    """How several stand in rows.

    Attributes:
        beside: free distance to the neighbour, the best first [m].
        aisle: free distance to the next row, the best first [m].
        abreast: how many form a row where nobody says so; 0 where that depends on how many there are.
    """

    beside: tuple[float, ...] = (0.08, 0.03)
    aisle: tuple[float, ...] = (1.0, 0.8)
    abreast: int = 0


@dataclass(frozen=True, kw_only=True)
class Facts:
    """All that reader, planner and expert know of a kind of thing; the defaults are those of a thing nobody knows.

    Attributes:
        words: the English words that mean it, as in a lexicon file: "desk, loveseat:two-seat, mouse|mice".
        groups: what it belongs to, of GROUPS; "surfaces:120" gives its place among the anchors that a habit means by
            "@surfaces", the lowest first; without a place it comes last.
        like: kinds of thing whose members can be meant by each other's name ("the table" by a dining table).
        habits: where it usually stands, the best first: "<relation> <anchor>", where the anchor is a category, a
            "@group" or a place of the room, and "if <category>" may follow.
        senses: what else its word can mean: "<category> if <conditions>", the first that holds; conditions are
            "attr:", "room:", "usual:" (what such a room holds), "rel:", "to:", "from:", "behind_it:", "before_it:",
            "has:" with values joined by "|", "many" and "few".
        rooms: rooms that it is usual in: how many and where, "2 : on desk each", by the type of room.
        plenty: how many a bare plural means; 0 where the usual number will do.
        each: how many a bare plural means for each of several things that have them.
        hanging: how it hangs on a wall.
        spots: where on a surface, from its centre (0) to its edge (1): towards the user, and to the surface's own
            left; the best first. Somebody sitting in front sees that left as their right.
        setting: at a table, from its edge to the thing, and from the middle of a person to their right [m].
        companion: what it keeps its place by.
        gaps: free distance to what it stands beside or before, the best first [m].
        tucks: how far it goes under the table it is drawn up to, the best first; negative leaves a gap [m].
        viewing: free distance to what it looks at, the best first [m].
        row: how several stand in rows.
        run: what it forms a row along a wall with, side by side; a name that its company shares.
        uses: floor that people need around it, where its clearance does not say enough.
        forms: words for the variant in which it "holds", "carries" or stands "over" other things, or is itself "inside"
            or "under" one, or "below" what hangs over it: an umbrella in a stand is upright, a stand that is told to
            hold some is empty before.
        states: words for how it can be made besides as usual, where a prompt wants to find it so: a book is shut, or
            "open".
        gaze: which way one looks who uses it: over its front (a sofa), or over its back (a desk).
    """

    words: str = ""
    groups: tuple[str, ...] = ()
    like: tuple[str, ...] = ()
    habits: tuple[str, ...] = ()
    senses: tuple[str, ...] = ()
    rooms: Mapping[str, str] = field(default_factory=dict)
    plenty: int = 0
    each: int = 1
    hanging: Hanging = Hanging()
    spots: tuple[Vec2, ...] = ()
    setting: Vec2 | None = None
    companion: Companion | None = None
    gaps: tuple[float, ...] = ()
    tucks: tuple[float, ...] = ()
    viewing: tuple[float, ...] = ()
    row: RowGaps = RowGaps()
    run: str = ""
    uses: tuple[Use, ...] = ()
    forms: Mapping[Role, str] = field(default_factory=dict)
    states: tuple[str, ...] = ()
    gaze: Gaze = "front"

    def __post_init__(self) -> None:
        for group in self.groups:
            name, _, place = group.partition(":")
            _check_group(name)
            if place and not place.isdecimal():
                raise InputError(f"group {group!r}: the place after ':' must be a whole number")
        for habit in self.habits:
            _check_relation(habit, habit.partition(" if ")[0])
        for line in self.rooms.values():
            count, _, how = line.rpartition(":")
            if count.strip() and not count.strip().isdecimal():
                raise InputError(f"rooms {line!r}: the count before ':' must be a whole number")
            for relation in filter(None, how.strip().split(", ")):
                _check_relation(line, relation)

    @cached_property
    def places(self) -> Mapping[str, int]:
        """Its groups, each with its place among the members of it."""
        parts = (group.partition(":") for group in self.groups)
        return {name: int(place) if place else _LAST for name, _, place in parts}

    def is_in(self, *groups: str) -> bool:
        """Whether it belongs to one of these groups."""
        return any(group in self.places for group in groups)

    def runs_with(self, other: "Facts") -> bool:
        """Whether the two form one row along a wall."""
        return bool(self.run) and self.run == other.run


def _check_group(name: str) -> None:
    if name not in GROUPS:
        raise InputError(f"no group {name!r}; there are {', '.join(sorted(GROUPS))}")


def _check_relation(where: str, relation: str) -> None:
    """Raise InputError where "<relation> <anchor>" names no relation, or no group after "@"."""
    kind, _, anchor = relation.partition(" ")
    if kind not in _RELATIONS:
        raise InputError(f"{where!r}: no relation {kind!r}; there are {', '.join(_RELATIONS)}")
    if anchor.startswith("@"):
        _check_group(anchor[1:])
