"""Ideas on the open floor: a grid over the room, and places that look at something."""

import math
from collections.abc import Iterator
from dataclasses import replace

from thinkblox.knowledge.uses import SIDE_WAY
from thinkblox.phrases import Constraint
from thinkblox.plan import Tie
from thinkblox.policies.expert.idea import Idea
from thinkblox.policies.expert.needs import BEFORE_BOARD
from thinkblox.policies.expert.partners import room_between
from thinkblox.policies.expert.situation import Situation, is_seat
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import turn_between
from thinkblox.scene.saying import turned
from thinkblox.value import Vec2

TALKING = (1.45, 1.3, 1.6, 1.8, 2.1)
"""Free distance between seats that look at each other, with a low table between them, the best first [m]."""
BETWEEN_SEATS = 0.3
"""Free distance between seats side by side [m]."""
HALF_TURNED = 20.0
"""How far a seat at the end of a low table is turned from it to what others look at [degrees]."""
WIDER, BESIDE_END = 0.4, 0.5
"""Cost per metre by which a seat reaches farther past the side of a low table that it stands at than so far [m]."""
PAST_ANOTHER = (0.0, 0.15, -0.15, 0.3, -0.3, 0.45, -0.45)
"""How far aside of the middle of an end of a low table a seat stands, to keep off the sofa at its long side [m]."""
FLOATING = 0.4
"""Cost of a seat with nothing behind it, where it could have a wall."""
ACROSS_FLOOR = (2.6, 3.0, 2.2)
"""Free distance between a seat that stands free and what is to stand before a wall across from it [m]."""
CLOSER = 0.08
"""So much nearer is tried too where something comes between [m]."""
USUAL_VIEWING = (0.6, 0.9, 1.3, 1.8, 2.4, 0.3)
"""Free distance to what a thing looks at, the best first, unless its category says otherwise [m]."""


def grid(situation: Situation, *, step: float = 0.25, why: str = "it stands free in the room") -> Iterator[Idea]:
    """Places on a grid over the floor, parallel to the walls; the middle of the room costs least."""
    room = situation.room
    x0, y0, x1, y1 = room.polygon.bounds
    cx, cy = room.polygon.centroid.coords[0]
    step = max(step, max(x1 - x0, y1 - y0) / 24)
    turns: tuple[float, ...] = (0.0,) if situation.asset.front == "any" else (0.0, 90.0)
    if situation.asset.front == "one":
        turns = (0.0, 90.0, 180.0, 270.0)
    nx, ny = int((x1 - x0) / 2 / step), int((y1 - y0) / 2 / step)
    for i in range(-nx, nx + 1):
        for j in range(-ny, ny + 1):
            x, y = cx + i * step, cy + j * step
            for turn in turns:
                words = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(turn))
                cost = 0.5 * math.hypot(i * step, j * step) + _across_room(situation, turn)
                yield Idea((x, y, 0.0), turn, words, why, cost)


def across_from_walls(situation: Situation, depth: float) -> Iterator[Idea]:
    """Before each wall, looking at what is to stand there, so deep [m], with a way behind."""
    own = situation.size[0]
    for wall in situation.room.walls:
        deep = max(wall.coordinates(corner)[1] for corner in situation.room.floor)
        yaw = (wall.yaw + 180.0) % 360.0
        half = max(situation.size[1] / 2, wall.length / 2 - SIDE_WAY)
        for rank, distance in enumerate(ACROSS_FLOOR):
            if deep - depth - distance - own < SIDE_WAY:
                continue
            for i in range(17):
                along = wall.length / 2 + (i / 8 - 1.0) * (half - situation.size[1] / 2)
                x, y = wall.point(along, depth + distance + own / 2)
                words = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(yaw))
                aside = abs(along - wall.length / 2) / max(0.5, wall.length / 2)
                cost = FLOATING + 0.15 * rank + 0.9 * aside
                yield Idea((x, y, 0.0), yaw, words, "it looks at a wall across the room from near enough", cost)


def at_doors(situation: Situation) -> Iterator[Idea]:
    """Just inside each door, along it, as a mat lies."""
    room = situation.room
    for opening in room.openings:
        if opening.kind != "door":
            continue
        wall = room.walls[opening.wall]
        across = situation.size[1] > situation.size[0] or situation.asset.front == "one"
        depth, width = situation.size[:2] if across else (situation.size[1], situation.size[0])
        yaw = (wall.yaw + (0.0 if across else 90.0)) % 360.0
        for rank, gap in enumerate((0.05, 0.15, 0.3)):
            middle = opening.offset + opening.width / 2
            along = min(max(middle, width / 2 + 0.01), max(wall.length - width / 2 - 0.01, width / 2))
            x, y = wall.point(along, gap + depth / 2)
            words = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(yaw))
            yield Idea((x, y, 0.0), yaw, words, f"it lies inside {opening.id}", 0.1 * rank)


def _across_room(situation: Situation, yaw: float) -> float:
    """A long thing lies along the long side of the room."""
    depth, width = situation.size[0], situation.size[1]
    ex, ey = situation.room.extent
    if max(depth, width) < 1.2 * min(depth, width) or abs(ex - ey) < 0.3:
        return 0.0
    along_x = (depth > width) == (yaw % 180.0 == 0.0)
    return 0.0 if along_x == (ex > ey) else 0.4


def presenting(situation: Situation, board: Placement) -> Iterator[Idea]:
    """Before a board, its front and whoever sits there towards it: over the desk one looks at the class."""
    yaw = (board.yaw + 180.0) % 360.0
    for rank, gap in enumerate((BEFORE_BOARD, BEFORE_BOARD - 0.15)):
        for aside in (0.0, 0.6, -0.6, 1.2, -1.2, 1.8, -1.8):
            x, y = board.to_room((board.size[0] / 2 + gap + situation.size[0] / 2, aside))
            words = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(yaw))
            cost = 0.2 * rank + 0.2 * abs(abs(aside) - 1.2)
            yield Idea((x, y, 0.0), yaw, words, f"whoever sits there has {board.id} behind", cost)


def side_by_side(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    """Straight before the anchor, in one line with the others that look at it."""
    pitch = situation.size[1] + BETWEEN_SEATS
    aside = (tie.index - (tie.count - 1) / 2) * pitch
    for rank, distance in enumerate(_distances(situation, anchor)):
        x, y = anchor.to_room((anchor.size[0] / 2 + distance + situation.size[0] / 2, aside))
        yaw = (anchor.yaw + 180.0) % 360.0
        words = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(yaw))
        why = f"it looks at {anchor.id}, beside the others that do"
        yield Idea((x, y, 0.0), yaw, words, why, 0.15 * rank - 0.3)


def _distances(situation: Situation, anchor: Placement) -> tuple[float, ...]:
    if situation.facts.is_in("seating") and is_seat(anchor.category):
        return TALKING
    usual = situation.facts.viewing or USUAL_VIEWING
    needed = room_between(situation, anchor.id)
    if not needed and (below := next(iter(situation.placed((anchor.support,))), None)) is not None:
        # Between a sofa and the stand of the television that it faces.
        needed = room_between(situation, below.id)
        needed = needed and round(needed + (below.size[0] - anchor.size[0]) / 2, 3)
    return (needed, round(needed - CLOSER, 3)) if needed else usual


def looking_at(situation: Situation, anchor: Placement) -> Iterator[Idea]:
    """Places about the anchor from which the front points at it; straight before its own front costs least."""
    seen = 180.0 if situation.scene.asset_of(anchor).gaze == "back" else 0.0
    has_front = situation.scene.asset_of(anchor).front == "one"
    floats = FLOATING if situation.facts.is_in("seating") and not is_seat(anchor.category) else 0.0
    for turn in range(0, 360, 15):
        away = turn_between(turn, seen) if has_front else 0.0
        for rank, distance in enumerate(_distances(situation, anchor)):
            cost = 0.02 * away + 0.25 * rank + (0.3 if turn % 90 else 0.0) + floats
            yield _looking(situation, anchor, float(turn), distance, cost)


def about_low_table(situation: Situation, table: Placement) -> Iterator[Idea]:
    """Before any side of a low table, looking at it; where a sofa has one long side, the ends are for the others.

    At an end it may be turned a little to what people look at across the room.
    """
    seen = [table.to_local(other.position[:2]) for _, other in situation.looked_across]
    for turn in (90.0, 270.0, 0.0, 180.0):
        at_end = turn % 180.0 != 0.0
        wide = WIDER * max(0.0, situation.size[1] - BESIDE_END - table.size[0 if at_end else 1])
        for rank, distance in enumerate((0.4, 0.3, 0.48)):
            for aside in PAST_ANOTHER if at_end else (0.0,):
                cost = 0.1 * rank + wide + 0.3 * abs(aside) + (0.0 if at_end else 0.15)
                idea = _looking(situation, table, turn, distance, cost, aside)
                yield idea
                if at_end and seen:
                    towards = -1.0 if (turn == 90.0) == (seen[0][0] < 0.0) else 1.0
                    idea = _looking(situation, table, turn, distance + _nearer(situation), cost - 0.1, aside)
                    yaw = (idea.yaw + towards * HALF_TURNED) % 360.0
                    yield replace(idea, yaw=yaw, words=(*idea.words[:-1], turned(yaw)))


def _nearer(situation: Situation) -> float:
    """How much nearer a corner of the target comes when it is half turned [m]."""
    angle = math.radians(HALF_TURNED)
    depth, width = situation.size[:2]
    return width / 2 * math.sin(angle) - depth / 2 * (1.0 - math.cos(angle))


def _looking(
    situation: Situation, anchor: Placement, turn: float, distance: float, cost: float, aside: float = 0.0
) -> Idea:
    angle = math.radians(turn)
    direction = (math.cos(angle), math.sin(angle))
    edge = _reach(anchor, direction)
    out = edge + distance + situation.size[0] / 2
    x, y = anchor.to_room((direction[0] * out + abs(direction[1]) * aside, direction[1] * out))
    yaw = (anchor.yaw + turn + (0.0 if situation.asset.gaze == "back" else 180.0)) % 360.0
    looks = () if situation.asset.gaze == "back" else (Constraint(kind="facing", anchors=(anchor.id,)),)
    words = (*looks, Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(yaw))
    seat = situation.facts.is_in("seating")
    why = f"whoever sits in it looks at {anchor.id}" if seat else f"it is turned to {anchor.id}"
    return Idea((x, y, 0.0), yaw, words, why, cost)


def _reach(anchor: Placement, direction: Vec2) -> float:
    """Distance from the anchor's centre to its edge in a direction of its own frame [m]."""
    dx, dy = abs(direction[0]), abs(direction[1])
    return min(anchor.size[0] / 2 / max(dx, 1e-9), anchor.size[1] / 2 / max(dy, 1e-9))
