"""Ideas at the long or the short sides of something: seats drawn up to them, other things beside them."""

from collections.abc import Iterator
from dataclasses import replace

from thinkblox.plan import Tie
from thinkblox.policies.expert.around import Place, free_places, seats, side_places
from thinkblox.policies.expert.beside import sides_of
from thinkblox.policies.expert.idea import Idea
from thinkblox.policies.expert.situation import Situation, is_seat
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Rects

TAKEN = 3.0
"""Cost of the side that has its share already."""


def long_sides(anchor: Placement) -> tuple[str, str]:
    """The two longer sides of a thing, seen from above."""
    return ("front", "back") if anchor.size[1] >= anchor.size[0] else ("left", "right")


def short_sides(anchor: Placement) -> tuple[str, str]:
    """The two shorter sides."""
    return ("left", "right") if anchor.size[1] >= anchor.size[0] else ("front", "back")


def at_sides(situation: Situation, anchor: Placement, tie: Tie, sides: tuple[str, str]) -> Iterator[Idea]:
    """At one of two sides, as many at each: seats at places of their own, other things beside them."""
    if not is_seat(situation.target.category):
        for side in sides:
            for idea in sides_of(situation, anchor, (side,)):
                yield replace(idea, cost=idea.cost + TAKEN * _is_full(situation, anchor, tie, side))
        return
    counts = ((tie.count + 1) // 2, tie.count // 2)
    for order, (first, second) in enumerate({counts, counts[::-1]}):
        places = [
            *side_places(anchor, sides[0], first),
            *side_places(anchor, sides[1], second),
        ]
        yield from _free(situation, anchor, places, dear=0.2 * order)


def _free(situation: Situation, anchor: Placement, places: list[Place], *, dear: float) -> Iterator[Idea]:
    free, strays, tucks = free_places(situation, anchor, places)
    for place in free:
        yield from seats(situation, anchor, place, cost=dear + 2.0 * strays, tucks=tucks)


def _is_full(situation: Situation, anchor: Placement, tie: Tie, side: str) -> bool:
    """Whether half of those that share the anchor are at this side of it."""
    axis, sign = {"front": (0, 1), "back": (0, -1), "left": (1, 1), "right": (1, -1)}[side]
    here = 0
    for p in situation.siblings:
        local = anchor.to_local((p.position[0], p.position[1]))
        here += sign * local[axis] > anchor.size[axis] / 2
    return here >= (tie.count + 1) // 2


def far_from(rects: Rects, ideas: list[Idea]) -> list[Idea]:
    """The ideas, the dearer the nearer they are to any of the boxes."""
    return [replace(idea, cost=idea.cost - 0.4 * _distance(rects, idea)) for idea in ideas]


def _distance(rects: Rects, idea: Idea) -> float:
    gaps = abs(rects.centre - (idea.position[0], idea.position[1]))
    return float((gaps**2).sum(-1).min() ** 0.5) if len(rects) else 0.0
