"""The floor that belongs to an object: for those who use it, and for what will come and stand by it."""

from typing import NamedTuple

import numpy as np

from thinkblox.assets import CATALOGUE
from thinkblox.plan import Target, Tie
from thinkblox.policies.expert.idea import Situation
from thinkblox.rects import Rects

ALL_ROUND = ("front", "back", "left", "right")
BEHIND_SEAT = 0.35
"""Floor behind a seat, to draw it back [m]."""
VIEW = 2.2
"""Floor between a seat and what it looks at [m]."""


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


def need(follower: Target, tie: Tie) -> Need | None:
    """What a follower will need of its anchor's surroundings; None where it needs no floor."""
    depth, width, _ = CATALOGUE[follower.category].size
    match tie.kind:
        case "next_to":
            return Need(("left", "right"), width + 0.1, None, min(tie.count, 2), 4.0)
        case "left_of" | "right_of":
            return Need((tie.kind.removesuffix("_of"),), width + 0.1, None, 1, 4.0)
        case "around":
            return Need(ALL_ROUND, depth + BEHIND_SEAT, None, min(tie.count, 4), 2.5)
        case "at":
            return Need(("front",), depth + BEHIND_SEAT, width, 1, 4.0)
        case "in_front_of" | "at_foot_of":
            return Need(("front",), depth + 0.5, width, 1, 4.0)
        case "facing":
            return Need(("front",), VIEW + depth, min(width, 1.2), 1, 2.0)
        case _:
            return None


def beside(rects: Rects, side: str, depth: float, *, width: float | None = None) -> Rects:
    """The floor by one side of each box: `depth` out, as wide as it or `width` [m]."""
    axis, sign = {"front": (0, 1), "back": (0, -1), "left": (1, 1), "right": (1, -1)}[side]
    out = rects.axes[:, axis] * sign
    centre = rects.centre + out * (rects.half[:, axis, None] + depth / 2)
    half = rects.half.copy()
    half[:, axis] = depth / 2
    if width is not None:
        half[:, 1 - axis] = width / 2
    return Rects(centre, half, rects.yaw, np.full(len(rects), 0.05), np.full(len(rects), 1.6))


def promised(situation: Situation) -> Rects:
    """The floor by placed objects that is meant for what is still to come, other than the object in question."""
    zones: list[Rects] = []
    done: set[tuple[str, str]] = set()
    own = {anchor for tie in situation.target.ties for anchor in tie.anchors}
    for later in situation.observation.plan.targets:
        if later.id in situation.scene or later.request == situation.target.request:
            continue
        for tie in later.ties:
            wanted = need(later, tie)
            for anchor in situation.placed(tie.anchors) if wanted else ():
                if anchor.id not in own and (later.request, anchor.id) not in done:
                    done.add((later.request, anchor.id))
                    zones += _sides_meant(anchor_rect(situation, anchor.id), wanted)
    return joined(zones)


def anchor_rect(situation: Situation, id: str) -> Rects:
    """One placed object's box."""
    return Rects.of_placements((situation.scene[id],))


def _sides_meant(anchor: Rects, wanted: Need | None) -> list[Rects]:
    if wanted is None or wanted.number < len(wanted.sides):
        return []
    return [beside(anchor, side, wanted.depth, width=wanted.width) for side in wanted.sides]


def joined(parts: list[Rects]) -> Rects:
    """Several sets of boxes as one."""
    if not parts:
        return Rects.of([])
    return Rects(
        np.concatenate([p.centre for p in parts]),
        np.concatenate([p.half for p in parts]),
        np.concatenate([p.yaw for p in parts]),
        np.concatenate([p.bottom for p in parts]),
        np.concatenate([p.top for p in parts]),
    )
