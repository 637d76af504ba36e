"""Ideas by the sides of one anchor: beside it, before it, behind it, at its foot, and between two."""

import math
from collections.abc import Iterator

from thinkblox.assets import facts_of
from thinkblox.phrases import Constraint
from thinkblox.plan import Tie
from thinkblox.policies.expert.idea import Idea
from thinkblox.policies.expert.situation import Situation
from thinkblox.scene.pairs import NEXT_TO
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import turn_between
from thinkblox.scene.saying import turned
from thinkblox.value import Vec2, Vec3

USUAL_GAPS = (0.1, 0.25, 0.4)
_ELBOW, _BEHIND_EACH = 0.12, 0.35
"""Free width between several before one anchor, and free depth between their rows [m]."""
BEHIND_GAPS = (0.6, 0.3, 0.15, 0.05)
"""Free distance behind a thing to what stands there, the best first [m]."""
SERVED_BEHIND = (0.65, 0.75, 0.9, 0.5)
"""The same behind a counter, where somebody serves [m]."""
SEATED_BEHIND = (0.15, 0.3, 0.05, 0.6)
"""The same of a chair, for who works there."""
ALIGNED = 0.5
"""How much better it is to be before the middle of a whole run than of one of its parts."""
APART = 4.0
"""Cost per metre by which what comes between two is further from one of them than it needs to be."""
OPPOSITE = {"left": "right", "right": "left", "front": "back", "back": "front"}


def sides_of(
    situation: Situation,
    anchor: Placement,
    sides: tuple[str, ...],
    *,
    gaps: tuple[float, ...] | None = None,
    why: str = "",
) -> Iterator[Idea]:
    """Beside the anchor: backs in line, centres in line, or fronts in line; long thin things run along its side."""
    for side in sides:
        for rank, gap in enumerate(gaps or situation.facts.gaps or USUAL_GAPS):
            for turn, dear in _turns(situation, side):
                size = situation.size[:2] if turn == 0.0 else (situation.size[1], situation.size[0])
                for align, penalty in _alignments(situation, anchor, side, size):
                    cost = 0.15 * rank + penalty + dear
                    yield _side_idea(situation, anchor, side, gap, align, size, turn, why=why, cost=cost)


def _turns(situation: Situation, side: str) -> tuple[tuple[float, float], ...]:
    """Turns against the anchor's yaw with their costs; at the left and right a screen runs along, facing the anchor."""
    inwards = {"left": 270.0, "right": 90.0}.get(side)
    thin = situation.size[1] > max(1.2, 2.0 * situation.size[0])
    if inwards is None or not thin:
        return ((0.0, 0.0),)
    return ((inwards, 0.0), (0.0, 0.8))


def _alignments(situation: Situation, anchor: Placement, side: str, size: Vec2) -> tuple[tuple[float, float], ...]:
    """Offsets along the side with their costs: flush backs for what stands beside, centres for what stands before."""
    along = 0 if side in ("left", "right") else 1
    room = (anchor.size[along] - size[along]) / 2
    if along == 0:
        small_round = situation.asset.front == "any" and situation.size[0] < 0.6
        back, centre = (0.1, 0.0) if small_round else (0.0, 0.3)
        from_head = 4.0 if facts_of(anchor.category).is_in("lain_on") else 0.0
        usual = ((-room, 0.0 if from_head else back), (0.0, centre + from_head), (room, 0.5 + from_head))
        behind = max((use.depth for use in situation.facts.uses if use.sides == ("back",)), default=0.0)
        return ((behind - room, 0.2), *usual) if behind else usual
    return ((0.0, 0.0), (-room / 2, 0.4), (room / 2, 0.4), (-room, 0.7), (room, 0.7))


def _side_idea(
    situation: Situation,
    anchor: Placement,
    side: str,
    gap: float,
    align: float,
    size: Vec2,
    turn: float,
    *,
    why: str,
    cost: float,
) -> Idea:
    if side in ("left", "right"):
        local = (align, (anchor.size[1] / 2 + gap + size[1] / 2) * (1 if side == "left" else -1))
    else:
        local = ((anchor.size[0] / 2 + gap + size[0] / 2) * (1 if side == "front" else -1), align)
    return beside_at(
        situation,
        anchor,
        local,
        yaw=anchor.yaw + turn,
        words=(Constraint(kind="beside", anchors=(anchor.id,), side=side, values=(gap,)),),
        why=why or f"it belongs beside {anchor.id}",
        cost=cost,
    )


def beside_at(
    situation: Situation,
    anchor: Placement,
    local: Vec2,
    *,
    yaw: float,
    words: tuple[Constraint, ...],
    why: str,
    cost: float,
    ignore: tuple[str, ...] = (),
) -> Idea:
    """An idea at a point of the anchor's own frame, with the words that find it again."""
    x, y = anchor.to_room(local)
    offset = Constraint(kind="offset", anchors=(anchor.id,), values=(round(local[0], 3), round(local[1], 3)))
    return Idea((x, y, 0.0), yaw % 360.0, (*words, offset, turned(yaw)), why, cost, ignore)


def before(
    situation: Situation,
    anchor: Placement,
    *,
    gaps: tuple[float, ...],
    face: bool,
    why: str,
    middle: float = 0.0,
) -> Iterator[Idea]:
    """In front of the anchor, centred or a little aside; facing it, or turned the same way.

    It is rather before the `middle` of what the anchor is a part of, as far aside of its own middle as that is [m],
    but still before the anchor.
    """
    turn = 180.0 if face else 0.0
    for rank, gap in enumerate(gaps):
        room = max(0.0, anchor.size[1] - situation.size[1]) / 2
        reach = anchor.size[1] / 2 + gap
        whole = min(max(middle, -reach), reach)
        for shift, penalty in (
            *(((whole, -ALIGNED),) if middle else ()),
            (0.0, 0.0),
            (0.5 * room, 0.3),
            (-0.5 * room, 0.3),
            (0.9 * room, 0.5),
            (-0.9 * room, 0.5),
        ):
            local = (anchor.size[0] / 2 + gap + situation.size[0] / 2, shift)
            words = (Constraint(kind="beside", anchors=(anchor.id,), side="front", values=(gap,)),)
            yield beside_at(
                situation, anchor, local, yaw=anchor.yaw + turn, words=words, why=why, cost=0.2 * rank + penalty
            )


def behind(situation: Situation, anchor: Placement, *, index: int = 0, count: int = 1) -> Iterator[Idea]:
    """Behind the anchor, turned the same way; several side by side, and a little aside where the middle is taken."""
    pitch = situation.size[1] + _ELBOW
    own = (index - (count - 1) / 2) * pitch
    room = max(0.0, anchor.size[1] - situation.size[1]) / 2
    gaps = SERVED_BEHIND if facts_of(anchor.category).is_in("counters") else BEHIND_GAPS
    gaps = SEATED_BEHIND if situation.facts.is_in("chairs") else gaps
    for rank, gap in enumerate(gaps):
        for step, aside in enumerate(dict.fromkeys((own, 0.0, 0.5 * room, -0.5 * room, room, -room))):
            local = (-(anchor.size[0] / 2 + gap + situation.size[0] / 2), aside)
            words = (Constraint(kind="beside", anchors=(anchor.id,), side="back", values=(gap,)),)
            why = f"it stands behind {anchor.id}"
            cost = 0.1 * rank + 0.15 * step
            yield beside_at(situation, anchor, local, yaw=anchor.yaw, words=words, why=why, cost=cost)


def between(situation: Situation, anchors: tuple[Placement, ...]) -> Iterator[Idea]:
    """In the middle of the room that the anchors leave, lengthwise or across, parallel to the first.

    Where it can be next to both, it costs to be further from one.
    """
    points = [p.position for p in anchors]
    x = sum(p[0] for p in points) / len(points)
    y = sum(p[1] for p in points) / len(points)
    first, last = anchors[0], max(anchors, key=lambda p: math.dist(p.position, anchors[0].position))
    length = math.dist(first.position[:2], last.position[:2]) or 1.0
    ux, uy = (last.position[0] - first.position[0]) / length, (last.position[1] - first.position[1]) / length
    words = Constraint(kind="between", anchors=(first.id, last.id))
    ends = [_half_along(anchor.size, anchor.yaw, (ux, uy)) for anchor in (first, last)]
    middle = (ends[0] - ends[1]) / 2 if len(anchors) == 2 else 0.0
    x, y = x + ux * middle, y + uy * middle
    flush = _flush(situation, first, last)
    for shift in (0.0, 0.1, -0.1, 0.2, -0.2, 0.35, -0.35):
        for aside in (0.0, 0.15, -0.15, 0.3, -0.3):
            for turn in (0.0, 90.0):
                px, py = x + ux * shift - uy * aside, y + uy * shift + ux * aside
                yaw = (first.yaw + turn) % 360.0
                place = Constraint(kind="at", values=(round(px, 3), round(py, 3)))
                spare = (length - sum(ends)) / 2 - _half_along(situation.size, yaw, (ux, uy))
                apart = max(0.0, spare + abs(shift) - NEXT_TO) if spare <= NEXT_TO else 0.0
                cost = 1.2 * abs(shift) + 4.0 * abs(aside) + (0.4 if turn and situation.asset.front != "any" else 0.0)
                cost += APART * apart
                yield Idea((px, py, 0.0), yaw, (words, place, turned(yaw)), "it belongs to both", cost)
        if flush is not None:
            px, py = x + ux * shift + flush[0], y + uy * shift + flush[1]
            place = Constraint(kind="at", values=(round(px, 3), round(py, 3)))
            pose = (words, place, turned(first.yaw))
            yield Idea((px, py, 0.0), first.yaw, pose, "their backs are in one line", 1.2 * abs(shift) - 0.1)


def _half_along(size: Vec3, yaw: float, direction: Vec2) -> float:
    """How far the outline of a thing reaches from its middle along a direction of the room [m]."""
    along = math.atan2(direction[1], direction[0]) - math.radians(yaw)
    return (abs(math.cos(along)) * size[0] + abs(math.sin(along)) * size[1]) / 2


def _flush(situation: Situation, first: Placement, last: Placement) -> Vec2 | None:
    """From the middle of two that stand side by side to where a thing's back is in line with the first's [m]."""
    if first is last or situation.asset.front == "any" or turn_between(first.yaw, last.yaw) > 10.0:
        return None
    back = -(first.size[0] - situation.size[0]) / 2
    angle = math.radians(first.yaw)
    return (back * math.cos(angle), back * math.sin(angle))


def before_several(
    situation: Situation, anchor: Placement, tie: Tie, *, gaps: tuple[float, ...], face: bool, why: str
) -> Iterator[Idea]:
    """Places of their own for several in front of the anchor: side by side along it, then in rows behind each other.

    Where one of these is taken, there are two more at the ends of the first row.
    Nobody is so far aside that they are past the anchor's corner rather than before it.
    """
    depth, width = situation.size[0], situation.size[1]
    pitch, turn = width + _ELBOW, 180.0 if face else 0.0
    for rank, gap in enumerate(gaps):
        reach = anchor.size[1] / 2 + 0.8 * (gap + depth / 2)
        fit = 1 + int(2 * max(0.0, reach - 0.2) / pitch)
        rows = math.ceil(tie.count / fit)
        columns = math.ceil(tie.count / rows)
        spread = max(pitch, min(1.5 * pitch, anchor.size[1] / columns))
        slots = [(number, *divmod(number, columns)) for number in range(tie.count)]
        slots += [(tie.count, 0, column) for column in (-1, columns) if (columns + 1) * spread / 2 < reach]
        for number, row, column in slots:
            there = min(columns, tie.count - row * columns)
            out = anchor.size[0] / 2 + gap + depth / 2 + row * (depth + _BEHIND_EACH)
            local = (out, (column - (there - 1) / 2) * spread)
            side = Constraint(kind="beside", anchors=(anchor.id,), side="front", values=(round(gap, 3),))
            words = (side,) if row == 0 else ()
            cost = 0.3 * rank + (0.0 if number == tie.index else 0.6)
            yield beside_at(situation, anchor, local, yaw=anchor.yaw + turn, words=words, why=why, cost=cost)
