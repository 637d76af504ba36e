"""The joints of a USD stage as a tree over its bodies: what hangs on what, and along and about which axes it moves."""

from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pxr import UsdPhysics

from thinkblox.errors import InputError
from thinkblox.sim.foreign.usd_frames import Frames, Matrix, owner_of
from thinkblox.sim.foreign.usd_values import number_of, word_of

APART = 0.005
"""How far the frames of a joint may be apart in a direction that it does not leave free [m]."""
BENT = 0.02
"""By how much they may be turned against each other about an axis that it does not leave free [rad]."""
_AXES = {"X": 0, "Y": 1, "Z": 2}
_GENERIC = (*(f"trans{axis}" for axis in _AXES), *(f"rot{axis}" for axis in _AXES))


@dataclass(frozen=True)
class Freedom:
    """One way in which a joint lets its child move.

    Attributes:
        turns: whether it is about the axis and not along it.
        axis: which one of the joint's frame.
        limits: [m, or degrees]; None for none.
    """

    turns: bool
    axis: int
    limits: tuple[float, float] | None


@dataclass(frozen=True)
class Join:
    """What holds a body to another, or to the world.

    Attributes:
        prim: of the joint.
        parent: path of the body that it hangs on; None for the world.
        child: path of the body that hangs.
        at_parent: the joint's frame in the parent's (4, 4).
        at_child: the same in the child's.
        freedoms: how the child moves; none where it is fixed.
        ball: it turns about every axis, whatever `freedoms` says.
        backwards: the stage has it from the child to the parent, so that everything is the other way round.
    """

    prim: Any
    parent: Any
    child: Any
    at_parent: Matrix
    at_child: Matrix
    freedoms: tuple[Freedom, ...]
    ball: bool = False
    backwards: bool = False

    def turned(self) -> "Join":
        """The same with parent and child exchanged."""
        return replace(
            self,
            parent=self.child,
            child=self.parent,
            at_parent=self.at_child,
            at_child=self.at_parent,
            backwards=not self.backwards,
        )


@dataclass(frozen=True)
class Linkage:
    """Bodies in an order in which each comes after what it hangs on.

    Attributes:
        joins: path of each body to what holds it; None for one that nothing does.
        loops: what holds bodies that something else holds already.
    """

    joins: dict[Any, Join | None]
    loops: tuple[Join, ...]


def tree_of(prims: Iterable[Any], bodies: dict[Any, Any], held: Iterable[Any], frames: Frames) -> Linkage:
    """How the bodies of a stage hang together.

    What is joined to the world, or held, comes first; of what is left, each connected part hangs on its first body
    that is no second end of a joint.

    Args:
        prims: of the stage, joints among them.
        bodies: prims of the bodies by path.
        held: paths of those that do not move whatever joins them.
        frames: of the stage.

    Raises:
        InputError: a joint whose limits are in the wrong order, or whose frames are far apart.
    """
    joins = list(_joins(prims, bodies, frames))
    growth = _Growth(joins)
    growth.take(dict.fromkeys(held))
    for join in joins:
        if join.parent is None and join.child not in growth.found:
            growth.take({join.child: join})
    second = {join.child for join in joins}
    for body in sorted(bodies, key=lambda body: body in second):
        if body not in growth.found:
            growth.take({body: None})
    fixed = set(held) | {None}
    return Linkage(
        growth.found, tuple(join for join in growth.left() if not fixed.issuperset({join.parent, join.child}))
    )


class _Growth:
    """A tree that grows from its roots along joints that are given."""

    def __init__(self, joins: list[Join]) -> None:
        self.found: dict[Any, Join | None] = {}
        self._joins, self._used = joins, set[int]()
        self._at: dict[Any, list[Join]] = {}
        for join in joins:
            for end in (join.parent, join.child):
                self._at.setdefault(end, []).append(join)

    def take(self, roots: dict[Any, Join | None]) -> None:
        """Take roots with what holds them, and all that is joined to them, the nearest first."""
        self.found.update(roots)
        self._used.update(id(join) for join in roots.values() if join is not None)
        waiting = deque(roots)
        while waiting:
            body = waiting.popleft()
            for join in self._at.get(body, ()):
                way = join if body == join.parent else join.turned()
                if id(join) not in self._used and way.child is not None and way.child not in self.found:
                    self.found[way.child] = way
                    self._used.add(id(join))
                    waiting.append(way.child)

    def left(self) -> list[Join]:
        """What joins bodies that are in the tree without it."""
        return [join for join in self._joins if id(join) not in self._used]


def _joins(prims: Iterable[Any], bodies: dict[Any, Any], frames: Frames) -> Iterator[Join]:
    for prim in prims:
        if not prim.IsA(UsdPhysics.Joint):
            continue
        joint = UsdPhysics.Joint(prim)
        if joint.GetJointEnabledAttr().Get() is False:
            continue
        ends = ends_of(joint)
        owners = [owner_of(end, bodies) for end in ends]
        if owners[0] == owners[1]:
            continue
        freedoms = freedoms_of(prim, frames)
        if freedoms is None:
            continue
        worlds = [frames.joint(joint, number, end) for number, end in enumerate(ends)]
        ball = prim.IsA(UsdPhysics.SphericalJoint)
        _check_frames(prim, worlds, freedoms)
        local = [
            world if owner is None else np.linalg.inv(frames.pose(bodies[owner])) @ world
            for world, owner in zip(worlds, owners, strict=True)
        ]
        join = Join(prim, owners[0], owners[1], local[0], local[1], freedoms, ball=ball)
        yield join if join.child is not None else join.turned()


def ends_of(joint: Any) -> list[Any]:
    """The two prims that a joint joins; None for an end that is the world, or that does not exist."""
    stage = joint.GetPrim().GetStage()
    targets = [rel.GetTargets()[:1] for rel in (joint.GetBody0Rel(), joint.GetBody1Rel())]
    return [next((prim for prim in map(stage.GetPrimAtPath, paths) if prim), None) for paths in targets]


def freedoms_of(prim: Any, frames: Frames) -> tuple[Freedom, ...] | None:
    """How a joint lets its ends move, none of a ball joint's; None for one that holds nothing.

    Raises:
        InputError: its limits are in the wrong order, or no numbers.
    """
    if prim.IsA(UsdPhysics.FixedJoint) or prim.IsA(UsdPhysics.SphericalJoint):
        return ()
    if prim.IsA(UsdPhysics.DistanceJoint):
        return None
    for schema, turns in ((UsdPhysics.RevoluteJoint, True), (UsdPhysics.PrismaticJoint, False)):
        if prim.IsA(schema):
            kind = schema(prim)
            limits = number_of(kind.GetLowerLimitAttr(), -np.inf), number_of(kind.GetUpperLimitAttr(), np.inf)
            if limits[0] > limits[1]:
                raise InputError(
                    f"{prim.GetPath()}: has its lower limit {limits[0]:g} above its upper one, {limits[1]:g}"
                )
            axis = _AXES[word_of(kind.GetAxisAttr(), _AXES, "X")]
            return (Freedom(turns, axis, _limits(limits, 1.0 if turns else frames.metre)),)
    return _generic(prim, frames)


def _generic(prim: Any, frames: Frames) -> tuple[Freedom, ...] | None:
    """A joint is free in all that no limit speaks of, and locked where the lower limit is above the upper."""
    freedoms = []
    for name in _GENERIC:
        limits = (-np.inf, np.inf)
        if prim.HasAPI(UsdPhysics.LimitAPI, name):
            limit = UsdPhysics.LimitAPI(prim, name)
            limits = number_of(limit.GetLowAttr(), -np.inf), number_of(limit.GetHighAttr(), np.inf)
        if limits[0] >= limits[1]:
            continue
        turns = name.startswith("rot")
        freedoms.append(Freedom(turns, _AXES[name[-1]], _limits(limits, 1.0 if turns else frames.metre)))
    return None if len(freedoms) == len(_GENERIC) else tuple(freedoms)


def _limits(limits: tuple[float, float], unit: float) -> tuple[float, float] | None:
    low, high = limits
    if not (np.isfinite(low) and np.isfinite(high)):
        return None
    # The engine knows no joint without room to move.
    return (low * unit, max(high * unit, low * unit + 1e-6))


def gaps_of(prim: Any, worlds: list[Matrix], freedoms: tuple[Freedom, ...]) -> tuple[float, float]:
    """How far apart [m] and how turned against each other [rad] the frames of a joint are in what it holds.

    Args:
        prim: the joint.
        worlds: its two frames in the world (4, 4).
        freedoms: how it lets its ends move.
    """
    away = np.linalg.inv(worlds[0]) @ worlds[1]
    slides = [freedom.axis for freedom in freedoms if not freedom.turns]
    shift = float(np.linalg.norm(np.delete(away[:3, 3], slides)))
    turning = [freedom.axis for freedom in freedoms if freedom.turns]
    if len(turning) > 1 or prim.IsA(UsdPhysics.SphericalJoint):
        return shift, 0.0
    # Without an axis to turn about, the whole rotation counts; with one, how far the axes differ.
    held = np.eye(3)[:, turning] if turning else np.eye(3)
    return shift, float(np.linalg.norm(away[:3, :3] @ held - held))


def _check_frames(prim: Any, worlds: list[Matrix], freedoms: tuple[Freedom, ...]) -> None:
    """Refuse a joint that would tear its bodies away from where the stage has them."""
    shift, bent = gaps_of(prim, worlds, freedoms)
    if shift > APART:
        raise InputError(f"{prim.GetPath()}: has its two frames {shift:.4g} m apart; engines would snap them")
    if bent > BENT:
        raise InputError(
            f"{prim.GetPath()}: has its two frames turned against each other by {bent:.4g} rad; engines would snap them"
        )


def motion(join: Join, parent: Matrix, child: Matrix) -> NDArray[np.float64]:
    """How far a joint is moved in each of its freedoms [m, or rad].

    Args:
        join: the joint, from parent to child.
        parent: where the parent is (4, 4).
        child: where the child is.
    """
    here, there = parent @ join.at_parent, child @ join.at_child
    away = np.linalg.inv(there) @ here if join.backwards else np.linalg.inv(here) @ there
    angles = _angles(away[:3, :3], [freedom.axis for freedom in join.freedoms if freedom.turns])
    return np.array([angles[way.axis] if way.turns else float(away[way.axis, 3]) for way in join.freedoms])


def _angles(turn: Matrix, axes: list[int]) -> dict[int, float]:
    """About each of the axes [rad], one after another in this order."""
    if len(axes) == 1:
        i, j = (axes[0] + 1) % 3, (axes[0] + 2) % 3
        return {axes[0]: float(np.arctan2(turn[j, i] - turn[i, j], turn[i, i] + turn[j, j]))}
    # turn = Rx(a) Ry(b) Rz(c), where what is not free is 0.
    return {
        0: float(np.arctan2(-turn[1, 2], turn[2, 2])),
        1: float(np.arcsin(np.clip(turn[0, 2], -1.0, 1.0))),
        2: float(np.arctan2(-turn[0, 1], turn[0, 0])),
    }


def filtered_pairs(prims: Iterable[Any], bodies: dict[Any, Any], tree: Linkage) -> set[tuple[Any, Any]]:
    """Bodies that do not touch each other: what a stage filters, and what a joint holds unless it says otherwise."""
    pairs: set[tuple[Any, Any]] = set()

    def add(first: Any, second: Any) -> None:
        if first is not None and second is not None and first != second:
            low, high = sorted((first, second), key=str)
            pairs.add((low, high))

    for prim in prims:
        if prim.HasAPI(UsdPhysics.FilteredPairsAPI):
            owner = owner_of(prim, bodies)
            for target in UsdPhysics.FilteredPairsAPI(prim).GetFilteredPairsRel().GetTargets():
                add(owner, owner_of(prim.GetStage().GetPrimAtPath(target), bodies))
    for join in (*tree.joins.values(), *tree.loops):
        if join is not None and not UsdPhysics.Joint(join.prim).GetCollisionEnabledAttr().Get():
            add(join.parent, join.child)
    return pairs
