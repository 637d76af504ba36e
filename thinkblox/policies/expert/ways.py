"""Ways through the room and balance: gaps that are neither closed nor a way, and weight on one side of the room.

After Merrell et al. 2011, "Interactive Furniture Layout Using Interior Design Guidelines", where these are the terms
of circulation and of visual balance; 1 is a clear drawback.
"""

import numpy as np

from thinkblox.assets import facts_of
from thinkblox.knowledge.uses import MAIN_WAY, SIDE_WAY
from thinkblox.observe import Kind
from thinkblox.policies.expert.situation import Situation, is_large
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Array, Rects, separation
from thinkblox.scene.room import Room

CLOSED = 0.07
"""A gap up to this is no gap: backs to walls, rows of cupboards [m]."""
DEAD = 0.3
"""A gap from CLOSED up to this is of no use at all [m]."""
NARROW, SNUG = 0.8, 0.15
"""Cost of a gap that nobody walks through, and of one that is merely not comfortable."""
TOUCHING = 0.9
"""Cost of standing close up to something that needs air, or of needing air oneself."""
BESIDE_WALL = 0.35
"""Share of a gap's cost where the other side is a wall and the thing stands against another one."""
ACROSS_GATE = 6.0
"""Cost of standing across the gate by which a thing leaves the room."""
CROWDS_WALL = 0.5
"""Cost of a wall close up to something that people sit or play around."""
UNBALANCED = 0.9
"""Cost per metre from the middle of the room to the middle of what stands in it, by floor area."""


def gap_cost(gaps: Array) -> Array:
    """What free distances cost that are too wide to be closed and too narrow to walk through [m]."""
    narrow = NARROW * np.clip((SIDE_WAY - gaps) / (SIDE_WAY - DEAD), 0.0, 1.0)
    snug = SNUG * np.clip((MAIN_WAY - gaps) / (MAIN_WAY - SIDE_WAY), 0.0, 1.0)
    return np.where(gaps > CLOSED, narrow + snug, 0.0)


def in_the_way(situation: Situation, rects: Rects, *, beside: frozenset[str] = frozenset()) -> Array:
    """What the gaps to other large pieces and to the walls cost; `beside` names what they do not count for."""
    if not is_large(situation.size) or situation.facts.is_in("drawn_aside"):
        return np.zeros(len(rects))
    near = beside | situation.relatives
    others = tuple(p for p in situation.large if p.id not in near)
    gaps = separation(rects, Rects.of_placements(others))
    costs = gap_cost(gaps) + _touching(situation, gaps, others)
    return np.asarray(costs.sum(-1)) + _walls(situation.room, rects, free=situation.facts.is_in("sat_around"))


def across_gates(situation: Situation, rects: Rects) -> Array:
    """What it costs that a car stands across the gate by which it leaves, where there is one that is wide enough."""
    room, width = situation.room, min(situation.size[:2])
    gates = [room.walls[o.wall] for o in room.openings if o.kind == "door" and o.width > width]
    if not gates or not situation.facts.is_in("driven_out"):
        return np.zeros(len(rects))
    out = np.abs(rects.axes[:, 0] @ np.array([wall.inward for wall in gates]).T)
    return np.asarray(ACROSS_GATE * (1.0 - out.max(-1)))


def _touching(situation: Situation, gaps: Array, others: tuple[Placement, ...]) -> Array:
    case = situation.facts.is_in("cases")
    airy = np.array([not case or not facts_of(p.category).is_in("cases") for p in others], dtype=bool)
    return np.where((gaps <= CLOSED) & airy[None], TOUCHING, 0.0)


def _walls(room: Room, rects: Rects, *, free: bool) -> Array:
    """Gaps to walls; for what stands against some wall, a gap at its end is no way and matters less."""
    gaps = separation(rects, wall_rects(room))
    against = (gaps <= CLOSED).any(-1)
    costs = np.where(against, BESIDE_WALL, 1.0) * gap_cost(gaps).sum(-1)
    return np.asarray(costs + np.where(against & free, CROWDS_WALL, 0.0))


def wall_rects(room: Room) -> Rects:
    """Each wall as a thin box just outside the room."""
    thick = 0.02
    return Rects.of(
        [
            (wall.point(wall.length / 2, -thick / 2), (thick, wall.length), wall.yaw, 0.0, room.height)
            for wall in room.walls
        ]
    )


def imbalance(situation: Situation, moments: Array) -> Array:
    """How far from the middle of the room the furniture would weigh, given the moments (n, 2) of what is added.

    A moment is the floor area of a thing times its offset from the middle of the room [m3].
    """
    planned = sum(_area(situation.kind(t)) for t in situation.observation.plan.targets)
    if planned <= 0.0:
        return np.zeros(len(moments))
    standing = sum(
        (moment(situation.room, Rects.of_placements((p,)))[0] for p in situation.large), start=np.zeros(2, dtype=float)
    )
    return np.asarray(UNBALANCED * np.linalg.norm(moments + standing, axis=-1) / planned)


def moment(room: Room, rects: Rects) -> Array:
    """Floor area times offset from the middle of the room, (n, 2) [m3]."""
    area = 4.0 * rects.half[:, 0] * rects.half[:, 1]
    middle = np.array(room.polygon.centroid.coords[0])
    return np.asarray(area[:, None] * (rects.centre - middle))


def _area(kind: Kind) -> float:
    return kind.size[0] * kind.size[1] if kind.mount == "floor" and is_large(kind.size) else 0.0
