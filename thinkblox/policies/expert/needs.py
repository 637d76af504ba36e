"""How much floor things need: for the people who use them, and for what will come and stand by them.

The figures are those of the handbooks of interior layout (Neufert, Architects' Data; Time-Saver Standards).
"""

from typing import NamedTuple

from thinkblox.assets import CATALOGUE
from thinkblox.plan import Target, Tie
from thinkblox.policies.expert.idea import SEATS
from thinkblox.scene.landmarks import WORKED_AT
from thinkblox.value import Vec3

ALL_ROUND = ("front", "back", "left", "right")
BEDS = frozenset(("bed", "bunk_bed", "crib", "hospital_bed", "massage_table"))
BEHIND_SEAT = 0.35
"""Floor behind a seat, to draw it back [m]."""
VIEW = 2.0
"""Floor between a seat and the screen or fire that it looks at [m]."""
TALK = 1.4
"""Floor between seats that look at each other, with a low table between them [m]."""
SIDE_WAY = 0.6
"""Width that one person walks through [m]."""
MAIN_WAY = 0.9
"""Width that is comfortable [m]."""
BOARDS = frozenset(("whiteboard", "blackboard", "projector_screen"))
BEFORE_BOARD = 1.0
"""Floor between a board and the desk of who teaches before it, to sit and to write [m]."""
DOUBLE = 1.3
"""A bed as wide as this is got into from both sides [m]."""


class Use(NamedTuple):
    """Floor that stays free by some sides of a thing, `depth` out [m]; `number` of the sides are needed."""

    sides: tuple[str, ...]
    depth: float
    number: int


_ROUND_ABOUT = (Use(ALL_ROUND, MAIN_WAY, 4),)
_USES: dict[str, tuple[Use, ...]] = {
    "pool_table": (Use(ALL_ROUND, 1.2, 4),),
    "table_tennis": (Use(("left", "right"), 1.5, 2), Use(("front", "back"), 0.8, 2)),
    "table_football": (Use(("front", "back"), 0.8, 2),),
    "display_table": _ROUND_ABOUT,
    "kitchen_island": _ROUND_ABOUT,
    "conference_table": _ROUND_ABOUT,
    "clothes_rack": (Use(("front", "back"), 0.7, 2),),
    "treadmill": (Use(("back",), 1.0, 1), Use(("left", "right"), 0.5, 1)),
    "massage_table": (Use(ALL_ROUND, SIDE_WAY, 3),),
    "hospital_bed": (Use(("front",), 0.6, 1), Use(("left", "right"), 0.8, 2)),
}


def uses(category: str, size: Vec3, front: str, clearance: float) -> tuple[Use, ...]:
    """The floor that people need who use such a thing; none for seats, which are moved."""
    if category in _USES:
        return _USES[category]
    if category in SEATS or clearance <= 0.0:
        return ()
    if category in BEDS:
        number = 2 if size[1] >= DOUBLE else 1
        return (Use(("front",), SIDE_WAY, 1), Use(("left", "right"), SIDE_WAY, number))
    return (Use(("front",) if front == "one" else ("front", "back"), clearance, 1),)


class Need(NamedTuple):
    """Floor by some sides of an object that a follower will take.

    Attributes:
        sides: where it may be.
        depth: out from the side [m].
        width: along the side [m]; None for the whole side.
        number: how many of the sides are needed.
        weight: cost per metre of depth that is missing.
    """

    sides: tuple[str, ...]
    depth: float
    width: float | None
    number: int
    weight: float


def need(follower: Target, tie: Tie, *, of: str) -> Need | None:
    """What a follower will need of the surroundings of its anchor, an `of`; None where it needs no floor."""
    depth, width, _ = CATALOGUE[follower.category].size
    match tie.kind:
        case "next_to":
            return Need(("left", "right"), width + 0.1, None, min(tie.count, 2), 4.0)
        case "left_of" | "right_of":
            return Need((tie.kind.removesuffix("_of"),), width + 0.1, None, 1, 4.0)
        case "around":
            return Need(ALL_ROUND, depth + BEHIND_SEAT, None, 2 if tie.count <= 2 else 4, 2.5)
        case "at":
            return Need(("front",), depth + BEHIND_SEAT, width, 1, 4.0)
        case "in_front_of" | "at_foot_of":
            return Need(("front",), depth + 0.5, width, 1, 4.0)
        case "behind":
            return Need(("back",), depth + 0.3, width, 1, 4.0)
        case "facing" if of in WORKED_AT:
            return Need(("back",), depth + MAIN_WAY, None, 1, 4.0)
        case "facing":
            apart = TALK if of in SEATS else VIEW
            return Need(("front",), apart + depth, min(width, 1.2), 1, 2.0)
        case "near" if of in BOARDS and follower.category in WORKED_AT:
            return Need(("front",), BEFORE_BOARD + depth, None, 1, 1.0)
        case _:
            return None
