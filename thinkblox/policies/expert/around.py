"""Ideas for seats at tables: drawn up to a desk, or evenly around a table."""

import math
from collections.abc import Iterator
from itertools import pairwise

from thinkblox.phrases import Constraint
from thinkblox.plan import Tie
from thinkblox.policies.expert.beside import beside_at
from thinkblox.policies.expert.idea import Idea, Situation
from thinkblox.scene import Placement
from thinkblox.value import Vec2

PLACE_WIDTH = 0.6
"""Edge of a table that one person needs [m]; Neufert, Architects' Data."""
TUCKS = {"office_chair": (0.08, 0.0, -0.1), "armchair": (-0.15, -0.3), "bar_stool": (0.08, 0.0, -0.05)}
"""How far a seat goes under the table, the best first [m]; negative leaves a gap."""
USUAL_TUCKS = (0.15, 0.05, -0.05)
AXES: dict[str, Vec2] = {"front": (1.0, 0.0), "back": (-1.0, 0.0), "left": (0.0, 1.0), "right": (0.0, -1.0)}


def is_round(situation: Situation, anchor: Placement) -> bool:
    """Whether the anchor's top is an ellipse."""
    surfaces = situation.scene.asset_of(anchor).surfaces
    return bool(surfaces) and surfaces[0].round


def at_desk(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    """Drawn up to the working side of a desk (its front), or to any side of a table without a front."""
    asset = situation.scene.asset_of(anchor)
    sides = ("front",) if asset.front == "one" else ("front", "back", "left", "right")
    for rank, side in enumerate(sides):
        width = anchor.size[1] if side in ("front", "back") else anchor.size[0]
        slots = _slots(width, tie.count) if tie.count > 1 else (0.0, 0.15 * width, -0.15 * width)
        for slot in slots if tie.count == 1 else (slots[tie.index % tie.count],):
            for step, tuck in enumerate(TUCKS.get(situation.target.category, USUAL_TUCKS)):
                cost = 0.3 * rank + 0.15 * step + abs(slot) * (0.8 if tie.count == 1 else 0.0)
                yield _seat(situation, anchor, side, slot, tuck, cost=cost)


def around(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    """Every arrangement of the whole company about the anchor; from each, the seat that this one would take."""
    if is_round(situation, anchor) and abs(anchor.size[0] - anchor.size[1]) < 0.2:
        yield from _ring(situation, anchor, tie)
        return
    taken = _taken_sides(situation, anchor)
    for order, company in enumerate(_companies(anchor, tie.count)):
        for side, count in company.items():
            width = anchor.size[1] if side in ("front", "back") else anchor.size[0]
            have = taken.get(side, 0)
            if have >= count:
                continue
            # Pairs fill first: the side opposite to the one last taken.
            imbalance = have - taken.get(_across(side), 0)
            for number, slot in enumerate(_slots(width, count)):
                for step, tuck in enumerate(TUCKS.get(situation.target.category, USUAL_TUCKS)):
                    cost = 0.5 * order + 0.2 * step + 0.05 * number + 0.1 * imbalance
                    yield _seat(situation, anchor, side, slot, tuck, cost=cost)


def _across(side: str) -> str:
    return {"front": "back", "back": "front", "left": "right", "right": "left"}[side]


def _taken_sides(situation: Situation, anchor: Placement) -> dict[str, int]:
    taken: dict[str, int] = {}
    for p in situation.siblings:
        x, y = anchor.to_local((p.position[0], p.position[1]))
        if max(abs(x) - anchor.size[0] / 2, abs(y) - anchor.size[1] / 2) > 1.0:
            continue
        beyond = {
            side: (x * ax + y * ay) - abs(anchor.size[0] * ax + anchor.size[1] * ay) / 2
            for side, (ax, ay) in AXES.items()
        }
        side = max(beyond, key=lambda s: beyond[s])
        taken[side] = taken.get(side, 0) + 1
    return taken


def _slots(width: float, count: int) -> tuple[float, ...]:
    """Offsets of the middles of `count` equal places along an edge [m]."""
    return tuple(width * ((i + 0.5) / count - 0.5) for i in range(count))


def _companies(anchor: Placement, count: int) -> list[dict[str, int]]:
    """Ways to seat `count` people about a rectangle, the best first: pairs on the long sides, then heads."""
    depth, width = anchor.size[0], anchor.size[1]
    long, short = (("front", "back"), ("left", "right")) if width >= depth else (("left", "right"), ("front", "back"))
    fit_long = max(1, int(max(width, depth) / PLACE_WIDTH + 0.15))
    fit_short = max(1, int(min(width, depth) / PLACE_WIDTH + 0.15))
    ranked: list[tuple[float, int, dict[str, int]]] = []
    for at_heads in range(min(count, 2 * fit_short) + 1):
        rest = count - at_heads
        if rest > 2 * fit_long:
            continue
        company = {long[0]: (rest + 1) // 2, long[1]: rest // 2, short[0]: (at_heads + 1) // 2, short[1]: at_heads // 2}
        crowded = max(0.0, (rest + 1) // 2 * PLACE_WIDTH - max(width, depth)) + max(
            0.0, (at_heads + 1) // 2 * PLACE_WIDTH - min(width, depth)
        )
        odd = abs(rest % 2) + abs(at_heads % 2)
        square = max(width, depth) < 1.2 * min(width, depth)
        heads = abs(at_heads - count / 2) * 0.3 if square else at_heads * 0.1
        ranked.append((3.0 * crowded + 0.2 * odd + heads, len(ranked), company))
    if not ranked:
        each = -(-count // 4)
        ranked = [(0.0, 0, {"front": each, "back": each, "left": each, "right": each})]
    return [{s: n for s, n in company.items() if n} for _, _, company in sorted(ranked, key=lambda r: r[:2])][:3]


def _seat(situation: Situation, anchor: Placement, side: str, slot: float, tuck: float, *, cost: float) -> Idea:
    ax, ay = AXES[side]
    half = abs(anchor.size[0] * ax + anchor.size[1] * ay) / 2
    out = half + situation.size[0] / 2 - tuck
    local = (ax * out + (slot if ay else 0.0), ay * out + (slot if ax else 0.0))
    yaw = anchor.yaw + math.degrees(math.atan2(-ay, -ax))
    return beside_at(
        situation,
        anchor,
        local,
        yaw=yaw,
        words=(),
        why=f"a person sits there at {anchor.id}, with a place of their own",
        cost=cost,
        ignore=(anchor.id,),
    )


def _ring(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    radius = max(anchor.size[0], anchor.size[1]) / 2
    placed = [anchor.to_local((p.position[0], p.position[1])) for p in situation.siblings]
    angles = [math.degrees(math.atan2(y, x)) for x, y in placed if math.hypot(x, y) < radius + 1.2]
    step = 360.0 / tie.count
    phases = (angles[0] % step,) if angles else tuple(step * k / 4 for k in range(4))
    for rank, phase in enumerate(phases):
        for number in range(tie.count):
            angle = phase + number * step
            if any(abs((angle - a + 180.0) % 360.0 - 180.0) < step / 2 for a in angles):
                continue
            for k, tuck in enumerate(TUCKS.get(situation.target.category, USUAL_TUCKS)):
                out = radius + situation.size[0] / 2 - tuck
                local = (out * math.cos(math.radians(angle)), out * math.sin(math.radians(angle)))
                yield beside_at(
                    situation,
                    anchor,
                    local,
                    yaw=round(anchor.yaw + angle + 180.0, 2),
                    words=(Constraint(kind="facing", anchors=(anchor.id,)),),
                    why=f"the seats stand evenly around {anchor.id}",
                    cost=0.1 * rank + 0.2 * k + 0.03 * number,
                    ignore=(anchor.id,),
                )


def largest_gap(angles: list[float]) -> float:
    """The largest angle between neighbours round a full turn [degrees]."""
    ordered = sorted(a % 360.0 for a in angles)
    return max((b - a for a, b in pairwise([*ordered, ordered[0] + 360.0])), default=360.0)
