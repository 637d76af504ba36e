"""How much floor things need: for the people who use them, and for what will come and stand by them.

The figures are those of the handbooks of interior layout (Neufert, Architects' Data; Time-Saver Standards).
"""

from typing import NamedTuple

from thinkblox.assets import Facts, facts_of
from thinkblox.knowledge.uses import MAIN_WAY
from thinkblox.plan import Target, Tie
from thinkblox.value import Vec3

ALL_ROUND = ("front", "back", "left", "right")
BEHIND_SEAT = 0.35
"""Floor behind a seat, to draw it back [m]."""
WORKING = 1.0
"""Floor between a desk and what stands behind who works there, who draws back the chair [m]."""
BEYOND, BEYOND_LOW = 0.5, 0.8
"""Floor before a thing besides that of what stands there, and of a low table, which people walk round [m]."""
VIEW = 2.0
"""Floor between a seat and the screen or fire that it looks at [m]."""
TALK = 1.4
"""Floor between seats that look at each other, with a low table between them [m]."""
BEFORE_BOARD = 1.0
"""Floor between a board and the desk of who teaches before it, to sit and to write [m]."""


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


def seat_need(tie: Tie, *, of: Vec3, size: Vec3) -> Need | None:
    """What seats of some size need at the long or short sides of an anchor of size `of`; None for other relations."""
    if tie.kind not in ("at_long_side", "at_short_side"):
        return None
    along_front = (of[1] >= of[0]) == (tie.kind == "at_long_side")
    sides = ("front", "back") if along_front else ("left", "right")
    return Need(sides, size[0] + BEHIND_SEAT, None, min(tie.count, 2), 4.0)


def need(follower: Target, tie: Tie, *, of: str, size: Vec3) -> Need | None:
    """What a follower of some size will need of the surroundings of its anchor, an `of`; None for no floor."""
    depth, width, _ = size
    anchor, own = facts_of(of), facts_of(follower.category)
    match tie.kind:
        case "next_to":
            return Need(("left", "right"), width + 0.1, None, min(tie.count, 2), 4.0)
        case "left_of" | "right_of":
            return Need((tie.kind.removesuffix("_of"),), width + 0.1, None, 1, 4.0)
        case "around":
            return Need(ALL_ROUND, depth + BEHIND_SEAT, None, 2 if tie.count <= 2 else 4, 2.5)
        case "at":
            return Need(("front",), depth + BEHIND_SEAT, width, 1, 6.0)
        case "in_front_of" | "near" if anchor.is_in("boards") and own.gaze == "back":
            return Need(("front",), BEFORE_BOARD + depth, None, 1, 1.0)
        case "in_front_of" | "at_foot_of":
            received = anchor.gaze == "back" and own.is_in("visits")
            beyond = BEYOND_LOW if own.is_in("low_tables") else BEYOND
            abreast = tie.count if own.is_in("lain_out") else 1
            return _before(tie, (depth, width * abreast, size[2]), received=received, beyond=beyond)
        case "behind" | "back_to_back":
            return _behind(tie, size, worker=tie.kind == "behind" and backs_worker(own, anchor))
        case "facing" if anchor.gaze == "back":
            return Need(("back",), depth + MAIN_WAY, None, 1, 4.0)
        case "facing":
            apart = TALK if anchor.is_in("seating") else VIEW
            return Need(("front",), apart + depth, min(width, 1.2), 1, 2.0)
        case _:
            return None


def _behind(tie: Tie, size: Vec3, *, worker: bool) -> Need:
    """Floor behind a thing, or behind who works at a desk."""
    depth, width, _ = size
    if worker:
        return Need(("front",), depth + WORKING, width * tie.count, 1, 4.0)
    return Need(("back",), depth + 0.3, width * tie.count, 1, 4.0)


def backs_worker(own: Facts, desk: Facts) -> bool:
    """Whether a thing behind a desk is behind who works there, on the side that no visitor sees first."""
    return desk.gaze == "back" and desk.is_in("worked_at") and not own.is_in("seating", "seats")


def _before(tie: Tie, size: Vec3, *, received: bool, beyond: float) -> Need:
    """Floor before a thing, or across a desk for those who are received there."""
    depth, width, _ = size
    if received:
        return Need(("back",), depth + BEHIND_SEAT + 0.3, width * tie.count, 1, 4.0)
    return Need(("front",), depth + beyond, width, 1, 4.0)
