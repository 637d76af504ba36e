"""How lounge seats stand to what people look at across a room: on its axis, near enough, and no back to it."""

import numpy as np

from thinkblox.assets import facts_of
from thinkblox.plan import Target
from thinkblox.policies.expert.ground import BARELY, TOUCH
from thinkblox.policies.expert.situation import Situation, is_lounge, is_seat
from thinkblox.policies.expert.walls import ASIDE, VIEW_RANGE
from thinkblox.scene.asset import Mount
from thinkblox.scene.rectangles import Array, Rects, outside, overlap_depth

BACK_TO_VIEW, BEHIND_ONE, WATCHED_FROM = 5.0, -0.25, 6.0
"""Cost of a back to what others look at, the cosine of the angle from which it is that, and from how far [m]."""
OFF_AXIS, MOST_ASIDE, FAR_OFF = 1.5, 1.5, 1.2
"""Cost per metre beside the axis of what one looks at, up to how many, and per metre farther away than is good."""
SHIFTS = (0.0, -0.3, 0.3, -0.6, 0.6, -1.0, 1.0)
"""How far aside of the axis of a seat what stands across the room may come, if it must [m]."""
NOWHERE = 4.0
"""Cost of a seat across from which there is no place for what is to stand there."""


def sight_costs(situation: Situation, rects: Rects) -> Array:
    """What each box has against it as a seat from which something is to be seen across the room, or as that."""
    if not is_lounge(situation.target.category):
        return _behind_backs(situation, rects)
    later = [t for t in situation.followers if comes_across(situation, t, mounts=("floor", "wall"))]
    costs = _turned_from_view(situation, rects) + _off_axis(situation, rects)
    return costs + _no_place_across(situation, rects, later[0]) if later else costs


def comes_across(situation: Situation, follower: Target, mounts: tuple[Mount, ...] = ("floor",)) -> bool:
    """Whether something that is no seat is to stand, or to hang, across the room from the target."""
    across = any(tie.kind == "opposite" and situation.target.id in tie.anchors for tie in follower.ties)
    return across and not is_seat(follower.category) and situation.kind(follower).mount in mounts


def _turned_from_view(situation: Situation, rects: Rects) -> Array:
    """What it costs that the back is to what others look at from near by."""
    costs = np.zeros(len(rects))
    for p in {other.id: other for _, other in situation.looked_across}.values():
        to = np.array(p.position[:2]) - rects.centre
        away = np.linalg.norm(to, axis=-1)
        behind = (rects.axes[:, 0] * to).sum(-1) < BEHIND_ONE * away
        costs = np.maximum(costs, np.where(behind & (away < WATCHED_FROM), BACK_TO_VIEW, 0.0))
    return costs


def _behind_backs(situation: Situation, rects: Rects) -> Array:
    """What it costs that what people usually look at across a room is behind those who lean back near by."""
    costs = np.zeros(len(rects))
    if not any(habit.startswith("opposite") for habit in situation.facts.habits):
        return costs
    for seat in (p for p in situation.large if is_lounge(p.category)):
        to = rects.centre - np.array(seat.position[:2])
        away = np.linalg.norm(to, axis=-1)
        front = np.array([np.cos(np.radians(seat.yaw)), np.sin(np.radians(seat.yaw))])
        costs += np.where((to @ front < BEHIND_ONE * away) & (away < WATCHED_FROM), BACK_TO_VIEW, 0.0)
    return costs


def _off_axis(situation: Situation, rects: Rects) -> Array:
    """What it costs to look past what is to be looked at, or at it from too far away."""
    costs = np.zeros(len(rects))
    looks = {a for tie in situation.target.ties if tie.kind in ("opposite", "facing") for a in tie.anchors}
    front = rects.axes[:, 0]
    for p in situation.placed(tuple(looks)):
        if not is_seat(p.category):
            to = np.array(p.position[:2]) - rects.centre
            aside = np.abs(front[:, 0] * to[:, 1] - front[:, 1] * to[:, 0])
            free = (front * to).sum(-1) - rects.half[:, 0] - p.size[0] / 2
            costs += OFF_AXIS * np.minimum(aside, MOST_ASIDE) + FAR_OFF * np.maximum(0.0, free - VIEW_RANGE[1])
    return costs


def _no_place_across(situation: Situation, rects: Rects, follower: Target) -> Array:
    """What it costs that what is to stand or hang at the wall across the room finds its place on the axis taken."""
    depth, width, height = situation.kind(follower).size
    hangs = situation.kind(follower).mount == "wall"
    front, left = rects.axes[:, 0], rects.axes[:, 1]
    ahead = _wall_ahead(situation, rects)
    found = np.isfinite(ahead)
    middle = rects.centre + front * (np.where(found, ahead, 0.0) - depth / 2 - 0.02)[:, None]
    half = np.tile([depth / 2, width / 2], (len(rects), 1))
    low = np.full(len(rects), facts_of(follower.category).hanging.middle - height / 2 if hangs else 0.0)
    best = np.full(len(rects), NOWHERE)
    for shift in SHIFTS:
        place = Rects(middle + shift * left, half, rects.yaw, low, low + height)
        taken = overlap_depth(place, situation.solids).max(-1, initial=0.0) > TOUCH
        taken |= overlap_depth(place, situation.door_zones).max(-1, initial=0.0) > TOUCH
        seen = place if hangs else Rects(place.centre, half, rects.yaw, low, low + height - BARELY)
        taken |= overlap_depth(seen, situation.window_zones).max(-1, initial=0.0) > TOUCH
        taken |= outside(place, situation.room.polygon) > TOUCH
        best = np.where(taken | ~found, best, np.minimum(best, ASIDE * abs(shift)))
    return best


def _wall_ahead(situation: Situation, rects: Rects) -> Array:
    """How far the wall is that each box looks at from its middle [m]; infinite where it looks at none squarely."""
    ahead = np.full(len(rects), np.inf)
    for wall in situation.room.walls:
        away = (rects.centre - np.array(wall.start)) @ np.array(wall.inward)
        along = (rects.centre - np.array(wall.start)) @ np.array(wall.along)
        faced = (rects.axes[:, 0] @ np.array(wall.inward) < -0.99) & (along > 0.0) & (along < wall.length)
        ahead = np.where(faced & (away > 0.0), np.minimum(ahead, away), ahead)
    return ahead
