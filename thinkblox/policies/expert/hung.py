"""Ideas on walls and ceilings."""

import itertools
import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from thinkblox.phrases import Constraint
from thinkblox.policies.expert import hung_rows, open_floor
from thinkblox.policies.expert.hung_rows import BETWEEN
from thinkblox.policies.expert.idea import Idea
from thinkblox.policies.expert.situation import Situation
from thinkblox.policies.expert.sizing import SHRINK, scaled
from thinkblox.policies.expert.walls import named_walls
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, Room, Wall, turn_between
from thinkblox.scene.saying import turned
from thinkblox.value import Vec3

_ROWS = 3
"""Most rows in which things hang over each other above what is narrower than all of them side by side."""
PENDANT = 0.75
"""From a table top to the lower edge of the lamp above it [m]."""
_CLEAR, _SHORTEST = 0.03, 0.15
"""Left at least between a lamp and what it hangs over, and how short a lamp may be for that [m]."""
USED_FROM_ABOVE, FLOATING = 1.1, 0.2
"""Furniture lower than this is used from above; hung on a wall its base is this high [m]."""
HEAD_ROOM = 1.5
"""What hangs lower than this over the floor is walked round [m]."""
UNDER_CEILING = 1.0
"""Cost of hanging smaller than it would over what is so high that the ceiling leaves no more."""
STACKED = 0.4
"""Cost of hanging over or under another of several by a door or window, rather than beside it."""
DRAPED = 0.2
"""How far drapes reach past a window, on either side [m]."""
CEILING_STEP = 0.4
"""Between places on the ceiling for what must not hang just anywhere [m]."""
BACK_GAP = 0.002
"""Between a hung thing and its wall [m]: touching, without cutting in."""


def on_walls(situation: Situation, place: str = "wall") -> Iterator[Idea]:
    """Along each wall at eye height or where such things hang; the middle of a free stretch costs least."""
    z = _height(situation)
    if situation.facts.hanging.windows != "no":
        yield from at_windows(situation)
        if not situation.target.asked:
            return
    watched = is_watched(situation) or situation.facts.is_in("boards")
    for wall in named_walls(situation.room, place):
        for row in hung_rows.places(situation, wall, z):
            yield hang(
                situation, wall, row.along, z, why="it hangs in a row with its like", cost=row.cost, size=row.size
            )
        short_view = 0.5 * (_longest_view(situation.room) - _view(situation.room, wall)) if watched else 0.0
        half = situation.size[1] / 2
        if wall.length < situation.size[1]:
            continue
        for i in range(17):
            along = half + (wall.length - 2 * half) * i / 16
            cost = short_view + (2.0 if watched else 0.6) * abs(along - wall.length / 2) / wall.length
            for lift in (0.0, 0.3, -0.3):
                top = z + lift + situation.size[2]
                if z + lift >= 0.0 and top <= situation.room.height:
                    yield hang(situation, wall, along, z + lift, why="it hangs where it is seen", cost=cost + abs(lift))


def _height(situation: Situation) -> float:
    """Height of the base: the middle at eye level, or low for furniture that is used from above [m]."""
    middle = situation.facts.hanging.middle - situation.size[2] / 2
    stands = situation.kind(situation.target).mount != "wall" and situation.asset.surfaces
    low = stands and situation.size[2] < USED_FROM_ABOVE
    return min(max(0.0, FLOATING if low else middle), situation.room.height - situation.size[2])


def is_watched(situation: Situation) -> bool:
    """Whether something later will face it."""
    return any(tie.kind in ("facing", "opposite") for t in situation.followers for tie in t.ties)


def _view(room: Room, wall: Wall) -> float:
    """How far the room reaches before a wall [m]."""
    return max(wall.coordinates(corner)[1] for corner in room.floor)


def _longest_view(room: Room) -> float:
    return max(_view(room, wall) for wall in room.walls)


def opposite(situation: Situation, anchor: Placement) -> Iterator[Idea]:
    """On the wall across the room from the anchor, in line with it."""
    for wall in situation.room.walls:
        along, inward = wall.coordinates((anchor.position[0], anchor.position[1]))
        half = situation.size[1] / 2
        if abs((wall.yaw - anchor.yaw) % 360.0 - 180.0) > 20.0 or inward < 1.0 or wall.length < 2 * half:
            continue
        z = _height(situation)
        for shift in (0.0, 0.3, -0.3, 0.6, -0.6, 1.0, -1.0, 1.5, -1.5):
            place = min(max(along + shift, half + 0.01), wall.length - half - 0.01)
            yield hang(situation, wall, place, z, why=f"it faces {anchor.id}", cost=0.5 * abs(place - along))


def hang(
    situation: Situation, wall: Wall, along: float, z: float, *, why: str, cost: float, size: Vec3 | None = None
) -> Idea:
    """Flat against the wall, its base at height z; at another size, where one is given [m]."""
    x, y = wall.point(along, (size or situation.size)[0] / 2 + BACK_GAP)
    words = (
        Constraint(kind="against", anchors=(wall.name,)),
        Constraint(kind="above", anchors=("floor",), values=(round(z, 3),)),
        turned(wall.yaw),
    )
    return Idea((x, y, z), wall.yaw, words, why, cost, size=size, against=(wall.name,))


def at_windows(situation: Situation) -> Iterator[Idea]:
    """Over each window, centred; drapes as wide as the window and what hangs beside it, or as a share of it."""
    for opening in situation.room.openings:
        if opening.kind == "window":
            wall = situation.room.walls[opening.wall]
            top = opening.sill + opening.height
            for rank, (along, size) in enumerate(_window_places(situation, wall, opening)):
                for step, drop in enumerate(_drops(situation, opening, size)):
                    z = top + 0.05 if drop < 0.3 else top + 0.1 - drop
                    z = min(max(z, 0.0), situation.room.height - drop)
                    cost = -1.0 + 0.1 * rank + 0.2 * step
                    hung = None if size is None else (size[0], size[1], drop)
                    yield hang(situation, wall, along, z, why=f"it belongs to {opening.id}", cost=cost, size=hung)


def _drops(situation: Situation, opening: Opening, size: Vec3 | None) -> tuple[float, ...]:
    """How far down it hangs [m]: as it is, or to the sill or just short of it, over what stands there."""
    own, sizes = situation.size[2], situation.observation.sizes
    shorter = (round(opening.height + 0.2, 3), round(opening.height + 0.05, 3))
    return (own, *(drop for drop in shorter if size is not None and sizes and sizes[0][2] <= drop < own))


def at_openings(situation: Situation, kind: str, place: str) -> Iterator[Idea]:
    """Above each door or window, below its sill, or beside it at eye level, as the relation says."""
    size = situation.size
    for opening in situation.room.openings:
        if opening.kind != place:
            continue
        wall = situation.room.walls[opening.wall]
        middle, top = opening.offset + opening.width / 2, opening.sill + opening.height
        aside = (opening.width + size[1]) / 2
        if kind == "above":
            spots = [(middle, min(top + 0.12, situation.room.height - size[2] - 0.01), 0.0)]
        elif kind == "under":
            spots = [(middle, opening.sill - size[2] - 0.1, 0.0)]
        else:
            places = [(middle + sign * (aside + gap), gap) for gap in (0.12, 0.3, 0.45) for sign in (1.0, -1.0)]
            spots = [(along, z, gap + dear) for along, gap in places for z, dear in _heights(situation)]
        for along, z, cost in spots:
            fits = 0.0 <= z <= situation.room.height - size[2]
            if size[1] / 2 <= along <= wall.length - size[1] / 2 and fits:
                yield hang(situation, wall, along, z, why=f"it belongs to {opening.id}", cost=cost - 1.0)


def _heights(situation: Situation) -> list[tuple[float, float]]:
    """Heights of the base and what they cost: the usual, and for one of several over or under another there [m]."""
    usual, apart = _height(situation), situation.size[2] + BETWEEN
    if situation.target.count < 2:
        return [(usual, 0.0)]
    return [(usual, 0.0), (usual + apart, STACKED), (usual - apart, STACKED)]


def _window_places(situation: Situation, wall: Wall, opening: Opening) -> list[tuple[float, Vec3 | None]]:
    """Where along the wall it hangs, and at what size: where there are more than windows, they share them."""
    windows = sum(o.kind == "window" for o in situation.room.openings)
    shares = -(-situation.target.count // windows) if situation.target.asked else 1
    sizes = situation.observation.sizes
    if situation.facts.hanging.windows != "beside" or sizes is None or any(situation.target.size):
        shares, sizes = 1, None
    left = max(opening.offset - DRAPED, 0.01)
    right = min(opening.offset + opening.width + DRAPED, wall.length - 0.01)
    wide = situation.size[1] if sizes is None else (right - left) / shares - BETWEEN * (shares > 1)
    if sizes is not None:
        wide = round(min(max(wide, sizes[0][1]), sizes[1][1]), 3)
    size = None if sizes is None else (situation.size[0], wide, situation.size[2])
    low, high = wide / 2 + 0.01, wall.length - wide / 2 - 0.01
    middles = [left + (right - left) * (share + 0.5) / shares for share in range(shares)]
    return [(min(max(middle, low), high), size) for middle in middles] if high > low else []


def above(situation: Situation, anchors: tuple[Placement, ...], *, index: int = 0, count: int = 1) -> Iterator[Idea]:
    """On the wall behind the anchors, centred over them all, or hanging from the ceiling above the first."""
    anchor = anchors[0]
    if situation.asset.mount == "ceiling":
        yield from _pendant(situation, anchor, index=index, count=count)
        return
    gap = situation.facts.hanging.above
    columns = _columns(situation, anchor.size[1], count)
    share, pitch = _pitch(situation, anchor.size[1], columns)
    share = min(share, _share_beside(situation, anchor)) if count == 1 else share
    size = None if share == 1.0 else scaled(situation.size, share)
    row, column = divmod(index, columns)
    abreast = min(columns, count - row * columns)
    higher = row * ((size or situation.size)[2] + BETWEEN)
    top = max(_top(situation, a) for a in anchors)
    eye = situation.facts.hanging.middle - situation.size[2] / 2
    for rank, wall in enumerate(_nearest_walls(situation, anchor)):
        along = sum(wall.coordinates((a.position[0], a.position[1]))[0] for a in anchors) / len(anchors)
        if abreast > 1:
            along += (column - (abreast - 1) / 2) * pitch * (-1.0 if turn_between(wall.yaw, anchor.yaw) > 90.0 else 1.0)
        for step, lift in enumerate((gap, gap + 0.1, gap + 0.3, gap / 2, 0.05)):
            z = max(top + lift, min(eye, top + lift + 0.35)) + higher
            room = situation.room.height - 0.02 - z
            if situation.size[2] > room:
                low = (situation.room.height - 0.02 - top - lift - higher) / situation.size[2]
                if SHRINK[-1] <= low < 1.0 and not any(situation.target.size):
                    small = scaled(situation.size, low)
                    cost = UNDER_CEILING + 1.5 * rank + 2.0 * (1.0 - low)
                    why = f"it belongs over {anchor.id}, under the ceiling"
                    yield hang(situation, wall, along, top + lift + higher, why=why, cost=cost, size=small)
                continue
            half = (size or situation.size)[1] / 2
            beside_it = min(along, wall.length - along) - 0.01
            if SHRINK[-1] * half <= beside_it < half and not any(situation.target.size):
                narrow = scaled(size or situation.size, beside_it / half)
                cost = 1.5 * rank + 0.2 * step
                yield hang(situation, wall, along, z, why=f"it belongs over {anchor.id}", cost=cost, size=narrow)
            for shift in (0.0, 0.15, -0.15, 0.3, -0.3):
                place = min(max(along + shift, half + 0.01), wall.length - half - 0.01)
                cost = 1.5 * rank + 0.2 * step + 2.0 * abs(place - along)
                yield hang(situation, wall, place, z, why=f"it belongs over {anchor.id}", cost=cost, size=size)


def _share_beside(situation: Situation, anchor: Placement) -> float:
    """At which share of its size it hangs beside another that hangs over the nearest of the anchor's like."""
    plan = situation.observation.plan.targets
    others = [t for t in plan if t.request == situation.target.request and t.id != situation.target.id]
    over = {id for t in others for tie in t.ties if tie.kind == "above" for id in tie.anchors if id != anchor.id}
    apart = [math.dist(p.position[:2], anchor.position[:2]) for p in situation.placed(tuple(over))]
    share = (min(apart) - BETWEEN) / situation.size[1] if apart else 1.0
    return 1.0 if any(situation.target.size) else min(1.0, max(SHRINK[-1], share))


def _columns(situation: Situation, width: float, count: int) -> int:
    """How many of so many hang side by side over a width: all, or, where the outermost would be beside it, a row's."""
    own = situation.size[1] * (1.0 if any(situation.target.size) else SHRINK[-1])
    abreast = (-(-count // rows) for rows in range(1, _ROWS + 1))
    return next((n for n in abreast if (n - 1) * (own + BETWEEN) <= 0.95 * width), count)


def _pitch(situation: Situation, width: float, count: int) -> tuple[float, float]:
    """At which share of their size so many hang side by side over a width, and from middle to middle [m].

    The outermost may reach past the ends by less than half; what has a size of its own keeps that.
    """
    own = situation.size[1]
    shares = SHRINK[:1] if any(situation.target.size) else SHRINK
    share = next((s for s in shares if (count - 1) * (own * s + BETWEEN) <= 0.95 * width), shares[-1])
    return share, max(own * share + BETWEEN, width / count)


def behind(situation: Situation, anchor: Placement, *, index: int = 0, count: int = 1) -> Iterator[Idea]:
    """On the wall at the anchor's back, in line with it; several side by side, above what stands there."""
    eye = _height(situation)
    for wall in situation.room.walls:
        if turn_between(wall.yaw, anchor.yaw) > 45.0:
            continue
        along, inward = wall.coordinates((anchor.position[0], anchor.position[1]))
        half = situation.size[1] / 2
        if inward < 0.0 or wall.length < 2 * half + 0.02:
            continue
        own = along + (index - (count - 1) / 2) * (situation.size[1] + 0.15)
        z = max(eye, min(_top(situation, anchor) + 0.1, situation.room.height - situation.size[2] - 0.02))
        for shift in (0.0, 0.15, -0.15, 0.3, -0.3, 0.6, -0.6):
            place = min(max(own + shift, half + 0.01), wall.length - half - 0.01)
            for height, dear in ((z, 0.0), (eye, 0.1), (z + 0.25, 0.2), (z + 0.5, 0.3), (max(0.0, z - 0.3), 0.4)):
                if height + situation.size[2] <= situation.room.height:
                    cost = abs(place - own) + dear + 0.3 * max(0.0, inward - 1.5)
                    yield hang(situation, wall, place, height, why=f"it hangs behind {anchor.id}", cost=cost)


def beside(situation: Situation, anchor: Placement, sides: tuple[str, ...]) -> Iterator[Idea]:
    """On the wall at the anchor's back, or the one beside it, to the left or right of the anchor."""
    half = situation.size[1] / 2
    for side in sides:
        sign = 1.0 if side == "left" else -1.0
        for gap in (0.08, 0.2, 0.35):
            point = anchor.to_room((0.0, sign * (anchor.size[1] / 2 + gap + half)))
            for wall in situation.room.walls:
                along, inward = wall.coordinates(point)
                if turn_between(wall.yaw, anchor.yaw) > 45.0 or not 0.0 <= inward <= 1.5:
                    continue
                if half + 0.01 <= along <= wall.length - half - 0.01:
                    for rank, z in enumerate((_height(situation), max(0.0, anchor.top - situation.size[2]))):
                        why = f"it hangs beside {anchor.id}"
                        yield hang(situation, wall, along, z, why=why, cost=gap + 0.2 * rank + 0.3 * inward)


def _top(situation: Situation, anchor: Placement) -> float:
    """Height of a thing with what stands on it and is nearly as wide [m]."""
    wide = [p.top for p in situation.scene.resting_on(anchor.id) if p.size[1] > 0.6 * anchor.size[1]]
    return max(anchor.top, *wide) if wide else anchor.top


def _nearest_walls(situation: Situation, anchor: Placement) -> list[Wall]:
    centre = (anchor.position[0], anchor.position[1])

    def badness(wall: Wall) -> float:
        along, inward = wall.coordinates(centre)
        behind = 0.0 if turn_between(wall.yaw, anchor.yaw) < 10.0 else 0.5
        past = max(0.0, -along, along - wall.length)
        return abs(inward) + behind + 5.0 * past

    return sorted(situation.room.walls, key=badness)[:2]


def _pendant(situation: Situation, anchor: Placement, *, index: int, count: int) -> Iterator[Idea]:
    height = situation.room.height
    drop = height - (anchor.top + PENDANT)
    size = situation.size
    clear = height - anchor.top - _CLEAR
    sizes = situation.observation.sizes
    least = min(clear, sizes[0][2]) if sizes else 0.0
    if 0.3 <= drop <= 2.0:
        size = (size[0], size[1], round(max(drop, least), 3))
    elif drop < 0.3 and _SHORTEST <= clear < size[2]:
        size = (size[0], size[1], round(clear, 3))
    long = 1 if anchor.size[1] >= anchor.size[0] else 0
    offset = ((index + 0.5) / count - 0.5) * anchor.size[long]
    local = (0.0, offset) if long else (offset, 0.0)
    for option, cost in ((size, 0.0), (situation.size, 0.5)):
        x, y = anchor.to_room(local)
        z = height - option[2]
        words = (
            Constraint(kind="offset", anchors=(anchor.id,), values=(round(local[0], 3), round(local[1], 3))),
            Constraint(kind="above", anchors=(anchor.id,), values=(round(z - anchor.top, 3),)),
            turned(anchor.yaw),
        )
        yield Idea((x, y, z), anchor.yaw, words, f"it lights {anchor.id}", cost, size=option)


def is_among_people(situation: Situation) -> bool:
    """Whether it hangs so low from the ceiling, and over nothing, that people walk round it as round furniture."""
    over = any(tie.kind == "above" for tie in situation.target.ties)
    return situation.asset.mount == "ceiling" and not over and situation.room.height - situation.size[2] < HEAD_ROOM


def from_ceiling(situation: Situation) -> Iterator[Idea]:
    """In the middle of the room, or spread along it when there are several; what people walk round, anywhere."""
    cx, cy = situation.room.polygon.centroid.coords[0]
    ex, ey = situation.room.extent
    z = situation.room.height - situation.size[2]
    if is_among_people(situation):
        for idea in open_floor.grid(situation, why="it hangs where there is room around it"):
            x, y, _ = idea.position
            above = Constraint(kind="above", anchors=("floor",), values=(round(z, 3),))
            yield replace(idea, position=(x, y, z), words=(*idea.words, above))
        return
    count, index = situation.target.count, situation.target.index
    offset = ((index + 0.5) / count - 0.5) * max(ex, ey)
    spots = [(cx + offset + s, cy) if ex >= ey else (cx, cy + offset + s) for s in (0.0, 0.4, -0.4, 0.8, -0.8)]
    if situation.target.denied:
        grid = itertools.product(np.arange(0.25, ex, CEILING_STEP), np.arange(0.25, ey, CEILING_STEP))
        spots += [(round(float(x), 3), round(float(y), 3)) for x, y in grid]
    for x, y in spots:
        words = (
            Constraint(kind="at", values=(round(x, 3), round(y, 3))),
            Constraint(kind="above", anchors=("floor",), values=(round(z, 3),)),
            turned(0.0),
        )
        yield Idea((x, y, z), 0.0, words, "it lights the room", math.dist((x, y), spots[0]))
