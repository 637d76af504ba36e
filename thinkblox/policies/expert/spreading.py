"""Sharing out over walls, corners or windows: each lot goes to a part of the room of its own."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from shapely import Point

from thinkblox.plan import Tie
from thinkblox.policies.expert.idea import Idea
from thinkblox.policies.expert.situation import Situation
from thinkblox.scene.landmarks import Landmark, corners, walls
from thinkblox.scene.landmarks import things as parts_called
from thinkblox.value import Vec2

ELSEWHERE, TOGETHER = 6.0, 5.0
"""Cost of a part that another lot has taken, and of another part than one's own lot has."""


def spread_out(situation: Situation, tie: Tie, ideas: Iterable[Idea]) -> Iterator[Idea]:
    """The ideas, dearer at the walls or corners that are not for the lot of the target."""
    parts = _parts(situation, tie)
    taken = _taken(situation, tie, parts)
    lot = tie.index * tie.spread // tie.count
    for idea in ideas:
        part = _nearest(parts, (idea.position[0], idea.position[1]), idea.against)
        own = taken.get(lot)
        others = {name for number, name in taken.items() if number != lot}
        dear = TOGETHER if own is not None and part != own else ELSEWHERE if own is None and part in others else 0.0
        yield replace(idea, cost=idea.cost + dear)


def _parts(situation: Situation, tie: Tie) -> list[Landmark]:
    if tie.kind == "in_corner":
        return list(corners(situation.room, tie.anchors))
    openings = [
        part for place in tie.anchors for part in parts_called(situation.scene, place) if part.kind == "opening"
    ]
    if openings:
        return openings
    names = [wall.name for place in tie.anchors for wall in walls(situation.room, place)]
    return [part for name in names for part in parts_called(situation.scene, name)]


def _taken(situation: Situation, tie: Tie, parts: list[Landmark]) -> dict[int, str]:
    """The part that each lot has, of those that stand already."""
    found: dict[int, str] = {}
    for target in situation.observation.plan.targets:
        if target.request != situation.target.request or target.id not in situation.scene:
            continue
        for other in target.ties:
            if other.kind == tie.kind and other.spread == tie.spread:
                p = situation.scene[target.id]
                back = p.to_room((-p.size[0] / 2, 0.0))
                found.setdefault(other.index * other.spread // other.count, _nearest(parts, back, ()))
    return found


def _nearest(parts: list[Landmark], point: Vec2, against: tuple[str, ...]) -> str:
    named = next((part.name for part in parts if part.name in against), None)
    return named or min(parts, key=lambda part: part.footprint.distance(Point(point))).name
