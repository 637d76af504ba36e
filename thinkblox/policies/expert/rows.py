"""Ideas for things that stand in rows: the whole block is laid out, then each member takes its place in it."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from thinkblox.assets import kind_of
from thinkblox.knowledge.uses import MAIN_WAY
from thinkblox.phrases import Constraint
from thinkblox.plan import Tie, is_object
from thinkblox.policies.expert import row_layout
from thinkblox.policies.expert.followers import follower_costs
from thinkblox.policies.expert.ground import darkens, ground_costs
from thinkblox.policies.expert.idea import Idea
from thinkblox.policies.expert.needs import need
from thinkblox.policies.expert.partners import gaps_in_row
from thinkblox.policies.expert.row_layout import RowLayout
from thinkblox.policies.expert.situation import Situation
from thinkblox.policies.expert.wall_rows import belongs_to_wall, wall_rows
from thinkblox.policies.expert.ways import imbalance, moment
from thinkblox.scene.landmarks import things
from thinkblox.scene.pairs import FACING
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Array, Rects, outside, overlap_depth
from thinkblox.scene.saying import turned

FIRST_ROW = 2.0
"""Free distance from a board to the first row that looks at it [m]."""
OFF_FIRST_ROW = 1.2
"""Cost per metre by which the first row is nearer to a board or farther from it than is good."""
OFF_SIGHT = 8.0
"""Cost of a row layout in which nobody sees what the rows look at without turning."""
ANY_OFF_SIGHT = 2.0
"""The same where somebody does not."""
TURNED_HEAD = 45.0
"""How far who sits in a row turns the head to what nobody said they face [deg]."""
REACH = 0.45
"""How far the middle of a block may be from that of the room, as a share of the room's extent."""
STEPS = 7
"""Places tried on each side of the room's middle."""
HARD = 20.0
"""Least cost of a block with a member where none can stand."""
WORTH = 2.0
"""What the best block costs at most, where all members can stand in it: rows are not given up for comfort."""
FINALISTS = 120
"""Blocks of which everything is measured."""
AWAY_FROM_WALL = 9.0
"""Cost of a block amid the room of what belongs to a wall."""
SAME_PLACE = 0.03
"""A member stands in a slot when it is nearer than this [m]."""


@dataclass(frozen=True)
class Blocks:
    """Many ways to lay out all members of a request.

    Attributes:
        centre: of each slot (blocks, slots, 2) [m].
        yaw: of each slot (blocks, slots) [degrees].
        cost: of each layout as such (blocks,).
    """

    centre: Array
    yaw: Array
    cost: Array

    def __len__(self) -> int:
        return len(self.cost)

    def take(self, index: NDArray[np.intp]) -> "Blocks":
        """Return some of them."""
        return Blocks(self.centre[index], self.yaw[index], self.cost[index])

    def rects(self, situation: Situation) -> Rects:
        """Every slot of every block as a box, block by block."""
        n, (depth, width, height) = self.yaw.size, situation.size
        half = np.tile([depth / 2, width / 2], (n, 1))
        return Rects(
            self.centre.reshape(-1, 2), half, np.radians(self.yaw.reshape(-1)), np.zeros(n), np.full(n, height)
        )


def in_rows(situation: Situation, tie: Tie, *, facing: tuple[str, ...], mutual: bool) -> Iterator[Idea]:
    """The best blocks that hold the members placed so far; from each, the next free slot.

    Args:
        situation: the decision.
        tie: its "in_rows" tie.
        facing: ids that the rows look at, when they look at something.
        mutual: two rows look at each other.
    """
    layouts = list(row_layout.layouts(situation, tie, facing=facing, mutual=mutual))
    blocks = _everywhere(situation, layouts, facing)
    order = _in_order(situation)
    walled = any(t.kind == "against_wall" for t in situation.target.ties)
    if walled and not order and not tie.asked and not facing and not mutual:
        blocks = _at_walls(situation, tie)
    elif not facing and not mutual and ((order and walled) or belongs_to_wall(situation)):
        aisles = tie.asked and tie.rows > 1 and situation.facts.is_in("from_aisles")
        blocks = _joined(_at_walls(situation, tie), blocks if aisles else _dearer(blocks, AWAY_FROM_WALL))
    blocks = _holding(situation, blocks, order)
    if not len(blocks):
        return
    before = situation.without({p.id for p in situation.siblings})
    costs = _hard_costs(before, blocks)
    best = np.argsort(costs, kind="stable")[:FINALISTS]
    blocks, costs = blocks.take(best), costs[best]
    costs = costs + _soft_costs(before, blocks)
    if HARD > costs.min() > WORTH:
        costs -= costs.min() - WORTH
    for i in np.argsort(costs, kind="stable")[:12]:
        slot = order[situation.target.id] if order else _free_slot(situation, blocks, int(i))
        if slot is not None:
            yield _idea(blocks, int(i), slot, tie, float(costs[i]))


def _idea(blocks: Blocks, block: int, slot: int, tie: Tie, cost: float) -> Idea:
    x, y = (float(value) for value in blocks.centre[block, slot])
    yaw = float(blocks.yaw[block, slot])
    words = (Constraint(kind="at", values=(round(x, 3), round(y, 3))), turned(yaw))
    return Idea((x, y, 0.0), yaw, words, f"it is number {tie.index + 1} of {tie.count} in rows", cost)


def _everywhere(situation: Situation, layouts: list[RowLayout], facing: tuple[str, ...]) -> Blocks:
    """Each layout at every place of a grid about the middle of the room."""
    middle = np.array(situation.room.polygon.centroid.coords[0])
    ex, ey = situation.room.extent
    steps = np.linspace(-1.0, 1.0, 2 * STEPS + 1) * REACH
    shifts = np.stack(np.meshgrid(steps * ex, steps * ey, indexing="ij"), -1).reshape(-1, 2)
    off = np.abs(shifts).sum(-1) * 0.12
    slots = np.array([layout.slots for layout in layouts])
    centre = (slots[:, None] + (middle + shifts)[None, :, None]).reshape(-1, slots.shape[1], 2)
    yaw = np.repeat(np.array([layout.yaws for layout in layouts]), len(shifts), axis=0)
    cost = (np.array([layout.cost for layout in layouts])[:, None] + off[None]).reshape(-1)
    cost += _first_row_costs(situation, centre, facing) + _place_costs(situation, centre, yaw)
    return Blocks(centre, yaw, cost)


def _place_costs(situation: Situation, centre: Array, yaw: Array) -> Array:
    """What it costs that some do not look at the part of the room that they are to look at."""
    ties = (tie for tie in situation.target.ties if tie.kind == "facing")
    places = [name for tie in ties for name in tie.anchors if not is_object(name)]
    marks = [part.centre for name in places for part in things(situation.scene, name)]
    if not marks:
        return np.zeros(len(centre))
    to = np.array(marks)[None, None] - centre[:, :, None]
    bearing = np.degrees(np.arctan2(to[..., 1], to[..., 0]))
    gaze = yaw + (180.0 if situation.asset.gaze == "back" else 0.0)
    off = np.abs((bearing - gaze[:, :, None] + 180.0) % 360.0 - 180.0).min(-1)
    past = off > FACING - 1.0
    away = np.linalg.norm(to, axis=-1).min(-1).mean(-1)
    return np.asarray(OFF_SIGHT * past.mean(-1) + ANY_OFF_SIGHT * past.any(-1) + 0.3 * away)


def _at_walls(situation: Situation, tie: Tie) -> Blocks:
    """Every way to line them up with their backs to walls."""
    found = list(wall_rows(situation, tie))
    slots, yaws, costs = zip(*found, strict=True) if found else ((), (), ())
    return Blocks(
        np.array(slots, dtype=float).reshape(-1, tie.count, 2),
        np.array(yaws, dtype=float).reshape(-1, tie.count),
        np.array(costs, dtype=float),
    )


def _joined(one: Blocks, other: Blocks) -> Blocks:
    parts = zip((one.centre, one.yaw, one.cost), (other.centre, other.yaw, other.cost), strict=True)
    centre, yaw, cost = (np.concatenate(pair) for pair in parts)
    return Blocks(centre, yaw, cost)


def _dearer(blocks: Blocks, cost: float) -> Blocks:
    return Blocks(blocks.centre, blocks.yaw, blocks.cost + cost)


def _first_row_costs(situation: Situation, centre: Array, facing: tuple[str, ...]) -> Array:
    """The first row keeps its distance from what it looks at, and its middle is straight before it."""
    anchors = situation.placed(facing)
    if not anchors:
        return np.zeros(len(centre))
    anchor, angle = anchors[0], math.radians(anchors[0].yaw)
    offset = centre - np.array(anchor.position[:2])
    ahead = offset @ np.array([math.cos(angle), math.sin(angle)])
    across = offset @ np.array([-math.sin(angle), math.cos(angle)])
    aside = np.abs(across.mean(-1))
    free = ahead.min(-1) - anchor.size[0] / 2 - situation.size[0] / 2
    told = any(tie.asked for tie in situation.target.ties if tie.kind in ("facing", "opposite"))
    past = _past(anchor, ahead, across, told=told)
    return np.asarray(OFF_FIRST_ROW * np.abs(free - _first_row(situation, anchor)) + 0.3 * aside + past)


def _past(anchor: Placement, ahead: Array, across: Array, *, told: bool) -> Array:
    """What it costs that some in the outer places look past what the rows look at: its middle where it hangs.

    Where nobody told them to face it, they turn their heads to some part of it.
    """
    off = np.degrees(np.arctan2(np.abs(across), np.maximum(ahead, 0.01)))
    if not told or kind_of(anchor.category).mount == "floor":
        depth, width = anchor.size[0] / 2, anchor.size[1] / 2
        beside, before = np.maximum(np.abs(across) - width, 0.0), np.maximum(ahead - depth, 0.01)
        off = np.minimum(off, np.degrees(np.arctan2(beside, before)))
    past = off > (FACING - 1.0 if told else TURNED_HEAD)
    return np.asarray(OFF_SIGHT * past.mean(-1) + ANY_OFF_SIGHT * past.any(-1))


def _first_row(situation: Situation, board: Placement) -> float:
    """Distance from a board to the first row, with a way behind whoever has a place before the board [m]."""
    later = [t for t in situation.observation.plan.targets if t.request != situation.target.request]
    wanted = [
        need(t, tie, of=board.category, size=situation.kind(t).size)
        for t in later
        for tie in t.ties
        if board.id in tie.anchors
    ]
    return max([FIRST_ROW, *(n.depth + MAIN_WAY for n in wanted if n is not None)])


def _in_order(situation: Situation) -> dict[str, int]:
    """The slot of each member where something comes between neighbours; none where any may have any."""
    if not gaps_in_row(situation):
        return {}
    alike = (t.id for t in situation.observation.plan.targets if t.request == situation.target.request)
    return {id: slot for slot, id in enumerate(alike)}


def _holding(situation: Situation, blocks: Blocks, order: Mapping[str, int]) -> Blocks:
    """Those in which every placed member has a slot: its own, where there is an order."""
    kept = np.ones(len(blocks), dtype=bool)
    for p in situation.siblings:
        near = np.abs(blocks.centre - np.array(p.position[:2])).max(-1) < SAME_PLACE
        same = np.abs((blocks.yaw - p.yaw + 180.0) % 360.0 - 180.0) < 1.0
        kept &= (near & same)[:, order[p.id]] if order else (near & same).any(-1)
    return blocks.take(np.flatnonzero(kept))


def _free_slot(situation: Situation, blocks: Blocks, block: int) -> int | None:
    taken = [p.position[:2] for p in situation.siblings]
    for number, centre in enumerate(blocks.centre[block]):
        if all(math.dist(centre, t) > 2 * SAME_PLACE for t in taken):
            return number
    return None


def _hard_costs(situation: Situation, blocks: Blocks) -> Array:
    """The layouts' own costs, and how much of each block is outside, in something, or in a door's swing."""
    rects = blocks.rects(situation)
    bad = 2 * HARD * (outside(rects, situation.room.polygon) > 0.0005)
    bad += 2 * HARD * (overlap_depth(rects, situation.solids).max(-1, initial=0.0) > 0.001)
    bad += HARD * (overlap_depth(rects, situation.door_zones).max(-1, initial=0.0) > 0.001)
    if situation.facts.hanging.windows == "no":
        bad += HARD * darkens(situation, rects)
    return np.asarray(blocks.cost + bad.reshape(len(blocks), -1).sum(-1))


def _soft_costs(situation: Situation, blocks: Blocks) -> Array:
    """What the floor says against each member, on the average and at worst, and the balance of the room."""
    rects, count = blocks.rects(situation), blocks.yaw.shape[1]
    ground = (ground_costs(situation, rects) + follower_costs(situation, rects)).reshape(len(blocks), count)
    costs = 0.5 * ground.mean(-1) * math.sqrt(count) + ground.max(-1)
    moments = moment(situation.room, rects).reshape(len(blocks), count, 2).sum(1)
    return np.asarray(costs + imbalance(situation, moments))
