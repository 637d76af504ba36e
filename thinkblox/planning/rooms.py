"""The room of a brief: its floor, height, doors and windows."""

import math

import numpy as np
from msgspec.structs import replace

from thinkblox.brief import Brief
from thinkblox.knowledge.rooms import MAX_SIDE, room_type
from thinkblox.planning.openings import with_openings
from thinkblox.planning.space import across_limit, across_need, depth_need, needed_area, run_length, wall_needs
from thinkblox.planning.walls import speaks_of_sides
from thinkblox.scene.room import Room, rectangle
from thinkblox.value import Vec2

_NOTCH = 0.4
"""Share of each side that the missing corner of an L takes."""
_SCALES = {"tiny": 0.75, "small": 0.85, "large": 1.25}
_PROPORTIONS = {"hallway": (0.4, 0.45)}
_USUAL_PROPORTION = (0.55, 1.0)
_SPREAD, _HALLS = 1.5, 1.2
"""By how much a room whose size is left open may be larger than it needs to be, and one that is a hall anyway."""
_TOLD, _FITTED = 5, 1.2
"""Of how many kinds of things that are named a room is a fitting one, and by how much larger it may be."""
_CLOSE = 1.1
"""By how much one that is said to be small may."""
_CLOSET = 4.0
"""A type of room that is usually smaller than this is no larger than it must be [m2]."""
_SMALL, _LARGE = 20.0, 40.0
"""Floors of rooms that vary most, and from which they vary as halls do [m2]."""
_LEAST_SIDE = 1.8
_TO_RUN = 1.5
"""Length of a narrow room besides the runs along both of its walls, for the door at its end [m]."""
_NOT_NARROWER = 0.6
"""Least proportion of a room that is longer for what is to be far apart in it."""
_NARROWEST = 0.75
"""Least shorter side of a room that is narrowed for what is across it, as a share of that of a square one."""
_CLOSE_ROOMS = frozenset({"tiny", "small"})
"""What is said of rooms that do not grow."""


def plan_room(brief: Brief, *, rng: np.random.Generator | int) -> Room:
    """A room for the brief: as large as it says, or as its furniture needs; the same `rng` gives the same room.

    Raises:
        InputError: the brief's size is not that of a room.
    """
    draw = np.random.default_rng(rng)
    brief = replace(brief, relations=tuple(r for r in brief.relations if not r.negated))
    width, depth = _sides(brief, draw)
    height = brief.height or room_type(brief.room_type).height
    room = _l_shape(width, depth, height) if brief.shape == "L" else rectangle(width, depth, height=height)
    return with_openings(room, brief, draw)


def is_open(brief: Brief) -> bool:
    """Whether a brief leaves it open how large the room is, so that it may grow."""
    given = brief.area is not None or (brief.width is not None and brief.depth is not None)
    return not given and _CLOSE_ROOMS.isdisjoint(brief.style)


def larger(brief: Brief, room: Room, factor: float) -> Brief:
    """The brief for a room with `factor` times the floor of `room`, in its proportions; a side that it gives stays."""
    if brief.width is not None or brief.depth is not None:
        sides = zip((brief.width, brief.depth), room.extent, strict=True)
        width, depth = (given or min(MAX_SIDE, round(side * factor, 1)) for given, side in sides)
        return replace(brief, width=width, depth=depth)
    width, depth = (min(MAX_SIDE, round(side * math.sqrt(factor), 1)) for side in room.extent)
    return replace(brief, width=width, depth=depth)


def _sides(brief: Brief, rng: np.random.Generator) -> Vec2:
    """Sides of the floor's bounding box along x and y [m]; the longer lies along x where the prompt leaves it open.

    It leads away from a gate that is in the near wall: cars stand straight before it.
    """
    proportion = _proportion(brief, rng)
    if brief.width is not None and brief.depth is not None:
        return brief.width, brief.depth
    least = needed_area(brief) * _scale(brief)
    told = len({request.category for request in brief.requests if request.asked}) >= _TOLD
    spread = min(_spread(least), _FITTED if told else _SPREAD) if _CLOSE_ROOMS.isdisjoint(brief.style) else _CLOSE
    spread = min(spread, _CLOSE) if room_type(brief.room_type).area < _CLOSET else spread
    area = brief.area if brief.area is not None else least * rng.uniform(1.0, spread)
    if brief.shape == "L":
        area /= 1.0 - _NOTCH**2
    digits = 2 if brief.area is not None else 1
    kind = room_type(brief.room_type)
    if (side := kind.across) is not None:
        if (given := brief.width or brief.depth) is not None:
            other = round(float(rng.uniform(*side)), 1) if given > side[1] else round(max(given, area / given), 1)
            return (given, other) if brief.width is not None else (other, given)
        narrow = round(float(rng.uniform(*side)), digits)
        run = run_length(brief) / 2 + _TO_RUN
        long = area / narrow if brief.area is not None or (kind.run == "sides" and area > run * narrow) else run
        return round(min(MAX_SIDE, max(narrow, long)), digits), narrow
    if (given := brief.width or brief.depth) is not None:
        other = round(min(MAX_SIDE, max(_LEAST_SIDE, _NOT_NARROWER * given, area / given)), 1)
        return (given, other) if brief.width is not None else (other, given)
    depth = round(min(MAX_SIDE, max(min(_LEAST_SIDE, math.sqrt(area)), math.sqrt(area * proportion))), digits)
    limit = max(across_limit(brief), round(_NARROWEST * math.sqrt(area), 1))
    depth = min(depth, limit) if brief.area is None else depth
    width = round(min(MAX_SIDE, area / depth), digits)
    if kind.entrance is not None and speaks_of_sides(brief):
        width, depth = min(width, depth), max(width, depth)
    if brief.area is not None:
        return width, depth
    least_width, least_depth = wall_needs(brief)
    across = across_need(brief)
    if across > width:
        depth = max(depth, round(_NOT_NARROWER * across, 1))
    deep = depth_need(brief)
    return max(width, least_width, across, deep), max(depth, least_depth, deep)


def _spread(area: float) -> float:
    """How much larger than it needs to be a room may be that needs so much floor [m2]."""
    share = min(1.0, max(0.0, (_LARGE - area) / (_LARGE - _SMALL)))
    return _HALLS + share * (_SPREAD - _HALLS)


def _proportion(brief: Brief, rng: np.random.Generator) -> float:
    if "square" in brief.style:
        return 1.0
    low, high = _PROPORTIONS.get(brief.room_type, _USUAL_PROPORTION)
    if {"long", "narrow"} & set(brief.style):
        low, high = 0.4, 0.5
    return float(rng.uniform(low, high))


def _scale(brief: Brief) -> float:
    return next((scale for word, scale in _SCALES.items() if word in brief.style), 1.0)


def _l_shape(width: float, depth: float, height: float) -> Room:
    """An L whose missing corner is the north-east one, where it hides nothing from a camera in the south."""
    x, y = round(width * (1.0 - _NOTCH), 3), round(depth * (1.0 - _NOTCH), 3)
    floor = ((0.0, 0.0), (width, 0.0), (width, y), (x, y), (x, depth), (0.0, depth))
    return Room(floor=floor, height=height)
