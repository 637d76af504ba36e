"""What the guidelines say of walls and windows: things in line with the walls, backs against them, windows free."""

import math

import numpy as np

from thinkblox.scene.rectangles import Array, Rects, overlap_depth
from thinkblox.scene.room import turn_between
from thinkblox.scoring.rating import Case, Rating, plateau, rated
from thinkblox.scoring.standing import Furnishing, Standing, rects_of

WINDOW_DEPTH = 0.3
"""How far into the room a window is kept free of what is higher than its sill [m]."""
IN_CORNER = 0.6
"""A seat may look into the room at 45 degrees where its nearest edge is no further from two walls [m]."""
FREE_BACK = 0.15
"""Something within this behind a thing is a back to it too: shelves back to back [m]."""


def alignment(standing: Standing) -> Rating:
    """How far large things are parallel to the walls, and those that belong to a wall have their backs to one.

    Merrell et al. 2011, alignment: cos 4(theta_i - theta_wall) from -1 to 1, here brought to 0 to 1; round things and
    seats that look out of a corner at 45 degrees are not asked. To a wall (Yu et al. 2011, distance to the nearest
    wall): 1 up to 0.1 m, falling to 0 at 0.6 m; or something else right behind. The score is the mean of all of these.
    """
    cases = [_parallel(standing, thing) for thing in standing.large if thing.asset.front != "any"]
    square = [case for case in cases if case is not None]
    boxes = rects_of(standing.large)
    backs = [_backed(standing, n, boxes) for n, thing in enumerate(standing.large) if _belongs_to_wall(thing)]
    return rated([*square, *backs], squared=_mean(square), backed=_mean(backs))


def _mean(cases: list[Case]) -> float:
    return sum(case.score for case in cases) / len(cases) if cases else 1.0


def _parallel(standing: Standing, thing: Furnishing) -> Case | None:
    placement, walls = thing.placement, standing.room.walls
    turn = min(turn_between(placement.yaw, wall.yaw, period=90.0) for wall in walls)
    near = [wall for wall in walls if min(wall.coordinates(c)[1] for c in placement.corners) < IN_CORNER]
    if turn > 10.0 and thing.facts.is_in("seating") and len(near) > 1:
        return None
    says = f"{thing.id} is {turn:.0f} degrees out of line with the walls"
    return Case((1.0 + math.cos(math.radians(4.0 * turn))) / 2, says)


def _belongs_to_wall(thing: Furnishing) -> bool:
    first = next(iter(thing.facts.habits), "")
    return thing.is_turned and first.startswith("against_wall")


def _backed(standing: Standing, number: int, boxes: Rects) -> Case:
    """Of the large thing of that number, given the boxes of all."""
    thing = standing.large[number]
    placement = thing.placement
    back = placement.to_room((-placement.size[0] / 2, 0.0))
    behind = [wall for wall in standing.room.walls if turn_between(placement.yaw, wall.yaw) < 60.0]
    behind = behind or list(standing.room.walls)
    away = min(max(0.0, wall.coordinates(back)[1]) for wall in behind)
    depth, across, _ = placement.size
    centre = placement.to_room((-(depth + FREE_BACK) / 2, 0.0))
    strip = Rects.of([(centre, (FREE_BACK, 0.8 * across), placement.yaw, 0.05, placement.size[2])])
    behind_it = overlap_depth(strip, boxes)[0]
    behind_it[number] = 0.0
    if behind_it.max() > 0.0:
        away = 0.0
    return Case(plateau(away, -1.0, 0.0, 0.1, 0.6), f"the back of {thing.id} is {away:.2f} m off the wall")


def daylight(standing: Standing) -> Rating:
    """The share of each window that nothing higher than its sill stands or hangs before.

    Neufert: before a window only what is lower than its sill. The score is the mean share over the windows, of what is
    within WINDOW_DEPTH of them; curtains, blinds and what is thinner than 0.1 m count for nothing.
    """
    windows = [opening for opening in standing.room.openings if opening.kind == "window"]
    thick = [t for t in standing.things if min(t.placement.size[:2]) > 0.1 and t.facts.hanging.windows == "no"]
    boxes, cases = rects_of(thick), []
    for opening in windows:
        wall, sill = standing.room.walls[opening.wall], opening.sill
        top = sill + opening.height
        alongs = opening.offset + opening.width * (np.arange(20) + 0.5) / 20
        strips = Rects.of(
            [
                (wall.point(float(along), WINDOW_DEPTH / 2), (WINDOW_DEPTH, opening.width / 20), wall.yaw, sill, top)
                for along in alongs
            ]
        )
        dark = _hidden(strips, boxes)
        cases.append(Case(1.0 - float(dark.mean()), f"{dark.mean():.0%} of {opening.id} is behind furniture"))
    return rated(cases, windows=len(windows))


def _hidden(strips: Rects, boxes: Rects) -> Array:
    """How much of the height of each strip is hidden, from 0 to 1, (n,)."""
    if not len(boxes):
        return np.zeros(len(strips))
    low = np.maximum(strips.bottom[:, None], boxes.bottom[None])
    high = np.minimum(strips.top[:, None], boxes.top[None])
    share = np.clip(high - low, 0.0, None) / (strips.top - strips.bottom)[:, None]
    return np.asarray(np.where(overlap_depth(strips, boxes) > 0.0, share, 0.0).max(-1))
