"""Clearance: the floor that people need who use what stands there, and that doors swing over."""

from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from thinkblox.assets import Use
from thinkblox.knowledge.uses import uses
from thinkblox.scene.rectangles import Array, Rects
from thinkblox.scene.zones import beside, joined
from thinkblox.scoring.rating import Case, Rating, rated
from thinkblox.scoring.standing import Furnishing, Standing, rects_of

ENOUGH = 0.8
"""Share of such floor that is enough: a nightstand takes a part of the floor beside its bed."""
_AT_ONCE = 1_000_000
"""Most pairs of a spot and a box that are looked at together: what bounds the memory."""
_GRID = (np.arange(5) + 0.5) / 5 * 2.0 - 1.0
_SPOTS = np.stack(np.meshgrid(_GRID, _GRID), -1).reshape(-1, 2)


def clearance(standing: Standing) -> Rating:
    """How free the floor is that is needed before wardrobes and drawers, beside beds, and in the swing of doors.

    Merrell et al. 2011, clearance; Neufert: 0.6 m to get out of a bed, the depth of a door or drawer and 0.6 m, at
    least 0.75 m, before storage, the width of a door before it. Each needs some sides: its score is the mean share
    of their floor that is in the room and free of what is not drawn aside, over ENOUGH, at most 1; where any of
    several sides will do, the freest count. The score is the mean over things and doors.
    """
    wanted = [(thing, use) for thing in standing.on_floor for use in _uses(thing)]
    swings = _swings(standing)
    zones = [beside(rects_of((thing,)), side, use.depth) for thing, use in wanted for side in use.sides]
    owners = [thing for thing, use in wanted for _ in use.sides] + [None] * len(swings)
    free = _free(standing, joined([*zones, swings]), owners)
    cases, at = [], 0
    for thing, use in wanted:
        best = np.sort(free[at : at + len(use.sides)])[-use.number :]
        at += len(use.sides)
        says = f"{best.mean():.0%} of the floor that {thing.id} needs is free"
        cases.append(Case(min(1.0, float(best.mean()) / ENOUGH), says))
    doors = [opening for opening in standing.room.openings if opening.kind == "door"]
    for opening, share in zip(doors, free[at:], strict=True):
        cases.append(Case(float(share), f"{share:.0%} of the floor before {opening.id} is free"))
    return rated(cases, doors=len(doors))


def _uses(thing: Furnishing) -> tuple[Use, ...]:
    if not thing.is_turned and thing.asset.front == "one":
        return ()
    return uses(thing.placement.category, thing.placement.size, thing.asset.front, thing.asset.clearance)


def _swings(standing: Standing) -> Rects:
    room = standing.room
    rows = []
    for opening in room.openings:
        if opening.kind == "door":
            wall, width = room.walls[opening.wall], opening.width
            centre = wall.point(opening.offset + width / 2, width / 2)
            rows.append((centre, (width, width), wall.yaw, 0.05, opening.height))
    return Rects.of(rows)


def _free(standing: Standing, zones: Rects, owners: list[Furnishing | None]) -> Array:
    """Share of each zone that is inside the room and in nothing that stays where it is, (n,)."""
    if not len(zones):
        return np.zeros(0)
    points = zones.centre[:, None] + (_SPOTS[None] * zones.half[:, None]) @ zones.axes
    shapely.prepare(standing.room.polygon)
    free = shapely.contains_xy(standing.room.polygon, points[..., 0], points[..., 1])
    solid = [thing for thing in standing.on_floor if not thing.is_moved]
    column = {thing.id: n for n, thing in enumerate(solid)}
    own = [-1 if owner is None else column.get(owner.id, -1) for owner in owners]
    boxes, step = rects_of(solid), max(1, _AT_ONCE // (len(_SPOTS) * max(1, len(solid))))
    for start in range(0, len(zones), step):
        part = slice(start, start + step)
        free[part] &= ~_within(points[part], boxes, own[part])
    return np.asarray(free.mean(-1))


def _within(points: Array, boxes: Rects, own: Sequence[int]) -> NDArray[np.bool_]:
    """Which points (n, m, 2) lie in a box that is not the `own` one of their row, -1 being none, (n, m)."""
    local = np.abs(np.einsum("zpbk,bjk->zpbj", points[:, :, None] - boxes.centre[None, None], boxes.axes))
    inside = (local < boxes.half[None, None] - 1e-6).all(-1)
    for row, column in enumerate(own):
        if column >= 0:
            inside[row, :, column] = False
    return np.asarray(inside.any(-1))
