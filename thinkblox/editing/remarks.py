"""What is as it was asked, and still not what who asked may think: notes on corners that are taken, and blind seats."""

from collections.abc import Iterable, Iterator

from shapely import LineString, Point

from thinkblox.assets import facts_of
from thinkblox.editing.goals import SNUG, Related
from thinkblox.editing.work import Work
from thinkblox.scene.landmarks import corners
from thinkblox.scene.scene import Scene

LEGS = 0.3
"""How much floor there is before a seat at least that somebody can sit down on [m]."""


def beside_corner(work: Work) -> Iterator[str]:
    """Notes on what was to go into a corner in which something else stands."""
    scene = work.scene
    asked = {w.id for w in work.wishes if isinstance(w.goal, Related) and w.goal.kind == "in_corner"}
    asked -= {w.id for w in work.wishes if isinstance(w.goal, Related) and w.goal.negated}
    for id in sorted(id for id in asked if id in scene and scene[id].support == "floor"):
        spots = [Point(corner.centre) for corner in corners(scene.room)]
        spot = min(spots, key=scene[id].footprint.distance)
        away = float(scene[id].footprint.distance(spot))
        others = [p for p in scene.placements if p.id != id and p.support == "floor" and scene.asset_of(p).collides]
        there = [p.id for p in others if p.footprint.distance(spot) < min(away, SNUG)]
        if away > SNUG and there:
            yield f"{id} stands {away:.2f} m from the corner, in which {' and '.join(there)} stands."


def facing_wall(work: Work, ids: Iterable[str]) -> Iterator[str]:
    """Notes on seats that look at a wall now, so close that nobody can sit down on them, and did not before."""
    for id in (id for id in ids if id in work.scene and facts_of(work.scene[id].category).is_in("seating")):
        free = legroom(work.scene, id)
        if free < LEGS and (id not in work.start or legroom(work.start, id) >= LEGS):
            yield f"{id} looks at a wall that is {free:.2f} m before it: nobody can sit down on it there."


def legroom(scene: Scene, id: str) -> float:
    """How far the wall is before a seat [m]; LEGS or more where it is farther, or the seat has no front."""
    seat = scene[id]
    if scene.asset_of(seat).front != "one":
        return LEGS
    way = LineString([seat.to_room((seat.size[0] / 2, 0.0)), seat.to_room((seat.size[0] / 2 + LEGS, 0.0))])
    return round(float(way.intersection(scene.room.polygon).length), 3)
