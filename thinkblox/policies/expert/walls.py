"""Ideas along walls and in corners: backs to the wall, long sides along it."""

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace

from thinkblox.knowledge.uses import DOUBLE
from thinkblox.phrases import Constraint
from thinkblox.policies.expert.beside import sides_of
from thinkblox.policies.expert.idea import WALL_GAP, Idea
from thinkblox.policies.expert.situation import WINDOW_DEPTH, Situation
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room, Wall, turn_between
from thinkblox.scene.saying import turned
from thinkblox.value import Vec2, Vec3

VIEW_RANGE = (1.8, 3.2)
"""Good distances from a seat to the screen, the fire or the seat that it looks at [m]."""
BESIDE_CORNER = 0.4
"""Left between a seat and its corner for a lamp or a small table [m]."""
BEHIND = 1.1
"""Left between a counter and the wall for those who sit or serve behind it [m]."""
END_ON = (0.45, 0.3, 0.75)
"""Left between a door and a counter that stands end on to the wall beside it [m]."""
ASIDE = 2.0
"""Cost per metre beside the axis of what is looked at across the room."""
WAITING = 2
"""From so many on, seats by the walls stand side by side."""
OUT_OF_ROW, TORN_APART = 1.0, 3.0
"""Cost of a place by the walls, for what stands in a row: beside another of it, but not as the row goes; elsewhere."""
FOCAL, ATTENDED = 0.9, 3.0
"""What it costs to stand at the end of a wall, where the middle is best, and for what rows of seats look at."""
FACE_TO_FACE = 30.0
"""So far may two that face each other be turned from that [deg]."""
STEPS = 14
"""Places tried along one wall besides the marked ones."""


def named_walls(room: Room, place: str) -> tuple[Wall, ...]:
    """The walls a Place means: all, the long or short ones, or those on one side of the room."""
    walls = room.walls
    if place in ("long_wall", "short_wall"):
        lengths = sorted({round(w.length, 2) for w in walls})
        wanted = lengths[-1] if place == "long_wall" else next((n for n in lengths if n > 1.0), lengths[0])
        return tuple(w for w in walls if abs(w.length - wanted) < 0.011)
    if place.endswith("_wall"):
        return tuple(w for w in walls if w.name.startswith(place)) or walls
    return walls


def oriented(size: Vec3, front: str) -> tuple[float, Vec2]:
    """Turn against a wall's yaw, and (depth, width) as seen from the wall; the long side goes along it."""
    if front != "one" and size[0] > size[1]:
        return 90.0, (size[1], size[0])
    return 0.0, (size[0], size[1])


def at_wall(
    situation: Situation, wall: Wall, along: float, *, gap: float = WALL_GAP, why: str = "", cost: float = 0.0
) -> Idea:
    """Back to the wall, the centre of its side `along` metres from the wall's start."""
    turn, (depth, _) = oriented(situation.size, situation.asset.front)
    x, y = wall.point(along, gap + depth / 2)
    yaw = (wall.yaw + turn) % 360.0
    words = (Constraint(kind="against", anchors=(wall.name,)), turned(yaw))
    return Idea((x, y, 0.0), yaw, words, why or "its back belongs to a wall", cost, against=(wall.name,))


def along_walls(situation: Situation, walls: Iterable[Wall] | None = None) -> Iterator[Idea]:
    """Along each wall: its middle, its ends, beside what stands there, before its windows, and evenly between."""
    _, (depth, width) = oriented(situation.size, situation.asset.front)
    single = situation.facts.is_in("lain_on") and situation.size[1] < DOUBLE
    focal = FOCAL if situation.facts.is_in("focal", "seating") and not single else 0.0
    focal = ATTENDED if situation.facts.is_in("attended") else focal
    for wall in situation.room.walls if walls is None else walls:
        low, high = width / 2 + WALL_GAP, wall.length - width / 2 - WALL_GAP
        if high < low:
            continue
        for along in sorted(_places(situation, wall, depth, width, low, high)):
            yield at_wall(situation, wall, along, cost=_place_cost(wall, along, low, high, focal=focal))


def in_line(situation: Situation, place: str = "wall") -> Iterator[Idea]:
    """Along the walls a Place means; what is one of several in a run goes right beside the others."""
    for p in situation.solid:
        if situation.in_run(p):
            for idea in sides_of(situation, p, ("left", "right"), gaps=(0.002,), why=f"it continues the row of {p.id}"):
                yield replace(idea, cost=idea.cost - 1.0)
    in_rows = any(tie.kind == "in_rows" for tie in situation.target.ties)
    seats = situation.facts.is_in("chairs", "lounges")
    if situation.target.count >= WAITING and (seats or in_rows):
        gaps = (0.05,) if seats else situation.facts.row.beside
        for p in situation.siblings:
            for idea in sides_of(situation, p, ("left", "right"), gaps=gaps, why=f"it stands in a row with {p.id}"):
                yield replace(idea, cost=idea.cost + (OUT_OF_ROW if in_rows else -1.0))
    for idea in along_walls(situation, named_walls(situation.room, place)):
        yield replace(idea, cost=idea.cost + TORN_APART) if in_rows else idea


def off_walls(situation: Situation, behind: float = BEHIND, *, turned_round: bool = False) -> Iterator[Idea]:
    """Parallel to a wall with room behind for whoever sits or serves there, or for what stands there [m].

    Turned round, its front is to the wall: that of a desk, over whose back one looks into the room.
    """
    for wall in situation.room.walls:
        for idea in along_walls(situation, (wall,)):
            (x, y), inward = (idea.position[0], idea.position[1]), wall.inward
            x, y = x + inward[0] * behind, y + inward[1] * behind
            yaw = (idea.yaw + (180.0 if turned_round else 0.0)) % 360.0
            words = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(yaw))
            why = "somebody sits between it and the wall" if turned_round else "somebody stands between it and the wall"
            yield Idea((x, y, 0.0), yaw, words, why, idea.cost)


def end_on_beside(situation: Situation, kind: str) -> Iterator[Idea]:
    """Beside each door or window, one end at its wall and the front to who comes in: who serves has the room behind."""
    depth, width, _ = situation.size
    for opening in situation.room.openings:
        if opening.kind != kind:
            continue
        wall = situation.room.walls[opening.wall]
        for way in (1.0, -1.0):
            for apart in END_ON:
                edge = opening.offset + (opening.width if way > 0.0 else 0.0)
                x, y = wall.point(edge + way * (apart + depth / 2), WALL_GAP + width / 2)
                yaw = math.degrees(math.atan2(-way * wall.along[1], -way * wall.along[0])) % 360.0
                words = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(yaw))
                yield Idea((x, y, 0.0), yaw, words, f"who comes in by {opening.id} comes to its front")


def clear_of_windows(situation: Situation, walls: Iterable[Wall]) -> Iterator[Idea]:
    """Before the windows of some walls, with so much air behind that tall things darken none."""
    for wall in dict.fromkeys(walls):
        for idea in along_walls(situation, (wall,)):
            _, (depth, _) = oriented(situation.size, situation.asset.front)
            along, _ = wall.coordinates((idea.position[0], idea.position[1]))
            x, y = wall.point(along, WINDOW_DEPTH + WALL_GAP + depth / 2)
            words = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(idea.yaw))
            yield Idea((x, y, 0.0), idea.yaw, words, "it stands before the window and leaves it free", idea.cost + 0.4)


def across_from(situation: Situation, kind: str) -> Iterator[Idea]:
    """Across the room from each door or window, looking at it: against the wall there, or nearer in a deep room."""
    room = situation.room
    depth = situation.size[0]
    for opening in room.openings:
        if opening.kind != kind:
            continue
        wall = room.walls[opening.wall]
        deep = max(wall.coordinates(corner)[1] for corner in room.floor)
        yaw = (wall.yaw + 180.0) % 360.0
        at_wall_there = deep - WALL_GAP - depth / 2
        outs = [at_wall_there, at_wall_there - WINDOW_DEPTH, *(apart + depth / 2 for apart in (3.8, 3.0, 2.2, 1.6))]
        for rank, out in enumerate(outs):
            if not 1.5 <= out - depth / 2 <= 4.0:
                continue
            for aside in (0.0, 0.2, -0.2, 0.4, -0.4, 0.6, -0.6, 0.9, -0.9):
                x, y = wall.point(opening.offset + opening.width / 2 + aside, out)
                words = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(yaw))
                why = f"it looks at {opening.id} across the room"
                yield Idea((x, y, 0.0), yaw, words, why, 0.3 * rank + 0.5 * abs(aside))


def _places(situation: Situation, wall: Wall, depth: float, width: float, low: float, high: float) -> set[float]:
    places = {low, high, (low + high) / 2}
    places |= {low + (high - low) * i / STEPS for i in range(STEPS + 1)}
    elbows = {use.depth for use in situation.facts.uses if use.sides == ("left", "right")}
    places |= {end for air in elbows for end in (low + air, high - air)}
    index = situation.room.walls.index(wall)
    for opening in situation.room.openings:
        if opening.wall == index:
            places.add(opening.offset + opening.width / 2)
            places |= {opening.offset - width / 2 - 0.05, opening.offset + opening.width + width / 2 + 0.05}
    for p in situation.solid:
        spots = [wall.coordinates(corner) for corner in p.corners]
        if min(inward for _, inward in spots) < depth:
            places |= {min(s for s, _ in spots) - width / 2 - 0.01, max(s for s, _ in spots) + width / 2 + 0.01}
            places |= {min(s for s, _ in spots) - width / 2 - 0.3, max(s for s, _ in spots) + width / 2 + 0.3}
            ends = (min(s for s, _ in spots) - width / 2, max(s for s, _ in spots) + width / 2)
            places |= {end for air in elbows for end in (ends[0] - air - 0.01, ends[1] + air + 0.01)}
    return {round(place, 3) for place in places if low <= place <= high}


def _place_cost(wall: Wall, along: float, low: float, high: float, *, focal: float) -> float:
    middle = wall.length / 2
    if focal:
        return focal * abs(along - middle) / max(0.5, middle)
    end = min(along - low, high - along)
    return min(0.6, 0.35 * end) + (0.2 if 0.05 < end < 0.3 else 0.0)


def corners(situation: Situation) -> Iterator[Idea]:
    """Every convex corner of the room: flush with both walls, or turned to the room where that suits."""
    walls = situation.room.walls
    for before, after in zip(walls[-1:] + walls[:-1], walls, strict=True):
        cross = before.along[0] * after.along[1] - before.along[1] * after.along[0]
        if cross <= 0.5:
            continue
        yield from _corner_ideas(situation, before, after)


def _corner_ideas(situation: Situation, before: Wall, after: Wall) -> Iterator[Idea]:
    _, (_, width) = oriented(situation.size, situation.asset.front)
    words = Constraint(kind="corner", anchors=(before.name, after.name))
    if min(before.length, after.length) < width:
        return
    diagonal = situation.facts.is_in("seating") or situation.asset.front == "any"
    flush = 0.45 if diagonal and situation.asset.front == "one" else 0.0
    for aside, dear in ((0.0, 0.0), (BESIDE_CORNER, 0.15)) if diagonal else ((0.0, 0.0),):
        end = width / 2 + WALL_GAP + aside
        for wall, along in ((after, end), (before, before.length - end)):
            idea = at_wall(situation, wall, along, cost=flush + dear, why="it fills the corner")
            yield replace(idea, words=(words, *idea.words))
    if diagonal and abs(_dot(before, after)) < 0.01:
        yield _diagonal(situation, before, after, words)


def _dot(a: Wall, b: Wall) -> float:
    return a.inward[0] * b.inward[0] + a.inward[1] * b.inward[1]


def _diagonal(situation: Situation, before: Wall, after: Wall, words: Constraint) -> Idea:
    size = situation.size
    reach = (size[0] + size[1]) / 2 * math.sqrt(0.5) + WALL_GAP
    round_thing = situation.asset.front == "any"
    if round_thing:
        reach = max(size[0], size[1]) / 2 + 0.06
    x, y = after.point(reach, reach)
    look = (before.inward[0] + after.inward[0], before.inward[1] + after.inward[1])
    yaw = after.yaw if round_thing else round(math.degrees(math.atan2(look[1], look[0])) % 360.0, 2)
    why = "it fills the corner" if round_thing else "it looks into the room from the corner"
    rest = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(yaw))
    return Idea((x, y, 0.0), yaw, (words, *rest), why)


def _too_far(situation: Situation, anchor: Placement, inward: float) -> float:
    """What a seat's distance from what it looks at costs, across the whole room."""
    if not situation.facts.is_in("seating"):
        return 0.0
    free = inward - anchor.size[0] / 2 - situation.size[0]
    return 1.5 * max(0.0, VIEW_RANGE[0] - free) + 0.6 * max(0.0, free - VIEW_RANGE[1])


def look_at_each_other(one: Placement, other: Placement) -> bool:
    """Whether two stand face to face."""
    ahead = (a.to_local((b.position[0], b.position[1]))[0] for a, b in ((one, other), (other, one)))
    return all(x > 0.0 for x in ahead) and turn_between(one.yaw, other.yaw + 180.0) < FACE_TO_FACE


def beside_pair(situation: Situation, one: Placement, other: Placement) -> Iterator[Idea]:
    """Against a wall to one side of two seats that face each other: both see it, and neither has its back to it."""
    middle = ((one.position[0] + other.position[0]) / 2, (one.position[1] + other.position[1]) / 2)
    for wall in situation.room.walls:
        along, inward = wall.coordinates(middle)
        _, (_, width) = oriented(situation.size, situation.asset.front)
        low, high = width / 2 + WALL_GAP, wall.length - width / 2 - WALL_GAP
        across = abs(math.cos(math.radians(wall.yaw - one.yaw))) < math.cos(math.radians(FACE_TO_FACE))
        if inward < 1.0 or high < low or not across:
            continue
        for shift in (0.0, -0.2, 0.2, -0.4, 0.4):
            place = min(max(along + shift, low), high)
            cost = ASIDE * abs(place - along) + _too_far(situation, one, inward)
            why = f"{one.id} and {other.id}, which face each other, both see it"
            yield at_wall(situation, wall, place, cost=cost, why=why)


def opposite(situation: Situation, anchor: Placement) -> Iterator[Idea]:
    """Against the wall across the room from the anchor, looking at it, as nearly in line with it as can be."""
    for wall in situation.room.walls:
        along, inward = wall.coordinates((anchor.position[0], anchor.position[1]))
        _, (_, width) = oriented(situation.size, situation.asset.front)
        low, high = width / 2 + WALL_GAP, wall.length - width / 2 - WALL_GAP
        if inward < 1.0 or high < low:
            continue
        facing = math.cos(math.radians(wall.yaw - anchor.yaw))
        for shift in (0.0, -0.3, 0.3, -0.6, 0.6):
            place = min(max(along + shift, low), high)
            aside = abs(place - along)
            if aside < 0.5 + inward / 2:
                cost = ASIDE * aside + (0.0 if facing < -0.5 else 2.0) + _too_far(situation, anchor, inward)
                idea = at_wall(situation, wall, place, cost=cost, why=f"it faces {anchor.id} across the room")
                in_line = (Constraint(kind="facing", anchors=(anchor.id,)),) if aside < 0.05 else ()
                yield replace(idea, words=(*idea.words, *in_line))
