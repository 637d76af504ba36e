"""Moving what fails by the least that mends it: shifted, never turned, and measured like any other placement."""

import math
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import islice
from typing import get_args

import numpy as np
from msgspec import structs

from thinkblox.errors import InputError
from thinkblox.scene.placement import Placement, apart, to_micrometres
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import ON_FLOOR
from thinkblox.sim.geometry.parting import parted
from thinkblox.sim.geometry.shifts import Shift, shifts
from thinkblox.sim.settings import Physics, Tolerances, Walking
from thinkblox.sim.verdict.world import World
from thinkblox.strictness import Rules
from thinkblox.value import Vec3
from thinkblox.verdict import MendingMove, Reason, Verdict

FINE = 0.00025
"""How finely the least shift is found [m]."""
TIGHTER = 0.02
"""How much further something is moved to leave it so [m]."""
CLOSE = 0.05
"""Whatever is nearer than this to something that moves is measured again [m]."""
ANY: frozenset[Reason] = frozenset(get_args(Reason))
SEATING: frozenset[Reason] = frozenset({"outside", "unsupported", "drop"})
"""Faults against the room and the floor: mended first, and then the collisions, which burst apart in a settle."""
ROUNDS = 2
"""How often all that fails yet is tried."""
ACCEPTED = 8
"""How many valid poses are tried for one that spoils nothing else."""
FURTHEST = 0.3
"""How far something is moved at most [m]."""
BEYOND = 12
"""How many poses that are further away are measured, to say how far it would have to be."""
ON_TOP = 0.01
"""What is this near to a top that it overlaps stands on it [m]."""


def mend(
    scene: Scene,
    *,
    tolerances: Tolerances | None = None,
    physics: Physics | None = None,
    walking: Walking | None = None,
    tries: int = 160,
    furthest: float = FURTHEST,
) -> tuple[Scene, tuple[MendingMove, ...]]:
    """Move what fails by the least that makes it valid; returns the mended scene and every move.

    Nothing is turned, and nothing is put on anything else than what it is on or over. What rests on something that
    moves, moves with it, also where it hangs over its edge. Of two that collide the lighter one is moved, the heavier
    one only when that cannot be. Whatever is valid stays where it is and stays valid; what cannot be mended stays
    where it is, and its move says so, and how far it would have to go where that is too far. Only where something is
    left that way, all on the floor are moved apart together, valid things too, each by as little as lets the others
    be mended; that counts where more is valid then.

    Args:
        scene: at the poses that are to be mended; itself not changed.
        tolerances: where the lines are drawn. What is moved is moved until it just touches, not until it is tolerated.
        physics: the engine's options.
        walking: what a walkable way is.
        tries: poses that are measured at most for one object.
        furthest: how far anything is moved at most [m].

    Raises:
        InputError: `furthest` is no distance above 0.
    """
    if not 0.0 < furthest < math.inf:
        raise InputError(f"furthest is {furthest:g} m; it must be a distance above 0")
    rules = Rules(tolerances or Tolerances(), physics or Physics(), walking or Walking(), tries, furthest)
    alone = _Mending(scene, rules)
    alone.mend_one_by_one()
    together = None if alone.is_whole else alone.together()
    if together is not None:
        together.mend_one_by_one()
        together.put_back_what_need_not_move()
    best = together if together is not None and together.is_better_than(alone) else alone
    best.look_beyond()
    return best.scene, best.moves()


@dataclass
class _Mending:
    """The scene as mended so far, what it was before each move, and the verdicts at the start and now."""

    scene: Scene
    rules: Rules
    steps: list[Scene] = field(default_factory=list)
    needs: dict[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.start = self.scene
        self.before = self.now = self._verdicts(self.scene)

    @property
    def is_whole(self) -> bool:
        """Whether everything is valid."""
        return all(verdict.valid for verdict in self.now.values())

    def is_better_than(self, other: "_Mending") -> bool:
        """Whether more is valid, nothing of which was valid at the start is not, and everything is where it may be."""
        count, others = (sum(v.valid for v in each.now.values()) for each in (self, other))
        kept = all(self.now[id].valid for id, verdict in self.before.items() if verdict.valid)
        near = self._furthest(self.scene, self.now) <= self.rules.furthest + FINE
        carried = all(self._carried_as_before(self.scene, p) for p in self.scene.placements)
        return count > others and kept and near and carried

    def together(self) -> "_Mending | None":
        """The same at its start with everything on the floor moved apart; None where nothing moves."""
        groups: list[tuple[str, ...]] = []
        for placement in sorted(self.start.placements, key=lambda p: len(self.start.carriers(p.id))):
            asset, taken = self.start.asset_of(placement), {id for group in groups for id in group}
            if asset.mount == "floor" and asset.collides and placement.id not in taken:
                groups.append(tuple(id for id in _group(self.start, placement.id) if id not in taken))
        found = parted(self.start, groups, self.rules.walking, furthest=self.rules.furthest)
        scene = self.start
        for group in groups:
            if group[0] in found:
                old, (east, north) = scene[group[0]], found[group[0]]
                position = to_micrometres(np.add(old.position, (east, north, 0.0)))
                scene = _shifted(scene, group, structs.replace(old, position=position))
        if scene == self.start:
            return None
        other = _Mending(scene, self.rules)
        other.start, other.before = self.start, self.before
        return other

    def put_back_what_need_not_move(self) -> None:
        """What was valid goes back to its start where that spoils nothing; nothing leaves what carries it."""
        for old in self.start.placements:
            below = self.start.carriers(old.id)
            alone = not self.scene.riders(old.id) and all(self.scene[id] == self.start[id] for id in below)
            if alone and self.before[old.id].valid and self.scene[old.id] != old:
                self._put_back(old)

    def mend_one_by_one(self) -> None:
        """Mend what can be mended, one thing after the other."""
        self._mend_all(self._carriers_first(), self._stuck, SEATING)
        self._mend_all(self._lighter_first(frozenset({"collision"})), self._stuck)
        for _ in range(ROUNDS):
            self._mend_all(self._lighter_first(), lambda id: set())
        self._take_back_what_broke()
        self._put_back_what_failed()

    def _mend_all(
        self, order: Sequence[str], past: Callable[[str], set[str]], reasons: frozenset[Reason] = ANY
    ) -> None:
        """Mend some objects one after the other, where what they fail for is among `reasons`.

        `past` gives ids that are looked past while one of them is mended: they will be moved away from it.
        """
        count = len(self.steps)
        for id in order:
            looked_past = past(id)
            if reasons.intersection(self._verdict(id, looked_past).reasons):
                self._mend(id, looked_past)
        if len(self.steps) > count:
            self.now = self._verdicts(self.scene)

    def _verdicts(self, scene: Scene) -> dict[str, Verdict]:
        world = self.rules.world(scene)
        return {p.id: world.check([p], scene.asset_of(p))[0] for p in scene.placements}

    def _verdict(self, id: str, past: set[str]) -> Verdict:
        """The verdict on an object now, without what is looked past, and then without what rests on it either."""
        gone = past | {p.id for p in self.scene.riders(id)} if past else set()
        return self.rules.world(_without(self.scene, gone)).check(
            [self.scene[id]], self.scene.asset_of(self.scene[id])
        )[0]

    def _carriers_first(self) -> list[str]:
        order = self._lighter_first()
        return sorted(order, key=lambda id: len(self.scene.carriers(id)))

    def _lighter_first(self, reasons: frozenset[Reason] = ANY) -> list[str]:
        failing = [v.id for v in self.now.values() if reasons.intersection(v.reasons)]
        return sorted(failing, key=lambda id: (_group_mass(self.scene, id), id))

    def _stuck(self, id: str) -> set[str]:
        """What will be moved away from the others it collides with, save the object itself and what carries it."""
        failing = [v for v in self.now.values() if v.collisions and v.id not in (id, *self.scene.carriers(id))]
        stuck = {v.id for v in failing if any(self._lighter(v.id, c.other) for c in v.collisions)}
        return stuck | {rider.id for other in stuck for rider in self.scene.riders(other)} - {id}

    def _lighter(self, id: str, other: str) -> bool:
        return other in self.scene and _group_mass(self.scene, id) <= _group_mass(self.scene, other)

    def _mend(self, id: str, past: set[str]) -> None:
        """Move one object to the nearest pose that is valid and spoils nothing, if one is found near enough."""
        group = _group(self.scene, id)
        for moved in self._poses(id, group, past):
            shifted = _shifted(self.scene, group, moved)
            after = self._after(shifted, id, group, past)
            if after is None:
                continue
            if (distance := self._furthest(shifted, group)) > self.rules.furthest + FINE:
                self.needs[id] = min(distance, self.needs.get(id, math.inf))
                return
            self.steps.append(self.scene)
            self.scene, self.now = shifted, self.now | after
            return

    def _furthest(self, shifted: Scene, group: Collection[str]) -> float:
        """How far any of a group would be from where it was at the start [m]."""
        return max(math.dist(shifted[id].position, self.start[id].position) for id in group)

    def _poses(self, id: str, group: Sequence[str], past: set[str]) -> Iterator[Placement]:
        """Valid poses among what stays where it is, nearest first, each brought as near as it gets."""
        placement, riders = self.scene[id], [self.scene[rider] for rider in group[1:]]
        rest = _without(self.scene, {*group, *past})
        found = shifts(self.scene, placement, riders, self.rules.walking, past=past, gently=True)
        near = [s for s in found if s.distance <= self.rules.furthest + FINE]
        yield from islice(self._seated_first(rest, placement, near[: self.rules.tries]), ACCEPTED)

    def look_beyond(self) -> None:
        """Find how far what fails yet would have to be moved."""
        for id in [id for id, verdict in self.now.items() if not verdict.valid and id not in self.needs]:
            group = _group(self.scene, id)
            placement, riders = self.scene[id], [self.scene[rider] for rider in group[1:]]
            world = self.rules.world(_without(self.scene, group))
            found = shifts(self.scene, placement, riders, self.rules.walking, gently=True)
            for shift in [s for s in found if s.distance > self.rules.furthest + FINE][:BEYOND]:
                if not world.check([shift.placement], self.scene.asset_of(placement))[0].valid:
                    continue
                shifted = _shifted(self.scene, group, shift.placement)
                if self._after(shifted, id, group, set()) is not None:
                    self.needs[id] = self._furthest(shifted, group)
                    break

    def _seated_first(self, rest: Scene, placement: Placement, near: Sequence[Shift]) -> Iterator[Placement]:
        """Valid poses, nearest first; a tight one, or a still one, goes before one that is a little nearer."""
        usual, *stricter = (self.rules.world(rest, each) for each in (None, self.rules.tight, self.rules.still))
        waiting: list[tuple[int, float, Placement]] = []
        for shift in near:
            if waiting and shift.distance > min(limit for _, limit, _ in waiting):
                yield min(waiting, key=lambda each: each[:2])[2]
                waiting = []
            if not usual.check([shift.placement], self.scene.asset_of(placement))[0].valid:
                continue
            grade, pose = self._best(placement, shift, (*stricter, usual))
            if grade == 0:
                yield pose
            elif all(grade < other for other, _, _ in waiting):
                waiting.append((grade, shift.distance + min(TIGHTER, shift.distance / 2), pose))
        if waiting:
            yield min(waiting, key=lambda each: each[:2])[2]

    def _best(self, placement: Placement, shift: Shift, worlds: Sequence[World]) -> tuple[int, Placement]:
        """By which of the worlds, the strictest first, a shifted pose is valid, and the nearest one on the way."""
        for grade, world in enumerate(worlds):
            pose = self._nearest(world, placement, shift)
            if pose is not None:
                return grade, pose
        return len(worlds), shift.placement

    def _nearest(self, world: World, placement: Placement, shift: Shift) -> Placement | None:
        """The valid pose next to the failing one on the way to a shifted one; None when that one fails too."""
        asset = self.scene.asset_of(placement)

        def check(position: Vec3) -> Placement | None:
            candidate = structs.replace(placement, position=position)
            verdict = world.check([candidate], asset)[0]
            return candidate if verdict.valid else None

        best = check(shift.placement.position)
        if best is None:
            return None
        fails = np.add(placement.position, shift.across)
        while np.linalg.norm(best.position - fails) > FINE:
            middle = (fails + best.position) / 2
            nearer = check(to_micrometres(middle))
            fails, best = (middle, best) if nearer is None else (fails, nearer)
        return best

    def _after(self, shifted: Scene, id: str, group: Collection[str], past: set[str]) -> dict[str, Verdict] | None:
        """The new verdicts of all that a move may concern, or None when it spoils something or does not mend."""
        if not all(self._carried_as_before(shifted, p) for p in shifted.placements):
            return None
        world = self.rules.world(_without(shifted, past))
        found: dict[str, Verdict] = {}
        for placement in _concerned(self.scene, shifted, id, group):
            if placement.id not in past:
                verdict = world.check([placement], shifted.asset_of(placement))[0]
                if not verdict.valid and (placement.id == id or self.now[placement.id].valid):
                    return None
                found[placement.id] = verdict
        return found

    def _carried_as_before(self, shifted: Scene, placement: Placement) -> bool:
        """Whether an object is on what it was on; what sank into a thing, or tips over it, may come to stand there."""
        old, before = self.start[placement.id], self.before[placement.id]
        if old.support == placement.support:
            return True
        if placement.position == old.position and not before.valid:
            return True
        if old.support != "floor" or old.position[2] <= ON_FLOOR or placement.support not in self.start:
            return False
        touched = {c.other for c in before.collisions} | {s.by for s in before.supports}
        return placement.support in touched or _is_on(self.start, old, self.start[placement.support])

    def _take_back_what_broke(self) -> None:
        """Undo the last moves while something fails that was valid at the start."""
        while self.steps and any(self.before[id].valid and not v.valid for id, v in self.now.items()):
            self.scene = self.steps.pop()
            self.now = self._verdicts(self.scene)

    def _put_back_what_failed(self) -> None:
        """What was moved and fails yet goes back, unless that spoils something."""
        for id, verdict in list(self.now.items()):
            old, new = self.start[id], self.scene[id]
            if not (verdict.valid or old == new or self.before[id].valid):
                self._put_back(old)

    def _put_back(self, old: Placement) -> None:
        """Put an object where it was, unless that spoils something."""
        back = self.scene.with_placement(old, self.start.asset_of(old))
        again = self._verdicts(back)
        if all(again[other].valid for other, v in self.now.items() if v.valid):
            self.scene, self.now = back, again

    def moves(self) -> tuple[MendingMove, ...]:
        """What was moved, and what fails yet."""
        return tuple(self._moves())

    def _moves(self) -> Iterator[MendingMove]:
        for old in self.start.placements:
            new = self.scene[old.id]
            dx, dy, dz = (round(b - a, 6) for a, b in zip(old.position, new.position, strict=True))
            if new.position != old.position or not self.now[old.id].valid:
                distance = round(float(np.linalg.norm((dx, dy, dz))), 6)
                why = self.before[old.id].reasons or self._reasons_below(old.id)
                mended = self.now[old.id].valid
                needs = None if mended or old.id not in self.needs else round(self.needs[old.id], 6)
                yield MendingMove(
                    id=old.id, by=(dx, dy, dz), turn=0.0, distance=distance, why=why, mended=mended, needs=needs
                )

    def _reasons_below(self, id: str) -> tuple[Reason, ...]:
        """Why what carries an object was moved."""
        return next((self.before[below].reasons for below in self.start.carriers(id) if self.before[below].reasons), ())


def _group_mass(scene: Scene, id: str) -> float:
    """Mass of an object with all that rests on it [kg]."""
    return sum(scene.asset_of(p).mass for p in (scene[id], *scene.riders(id)))


def _without(scene: Scene, ids: Collection[str]) -> Scene:
    for id in sorted(ids):
        scene = scene.without(id)
    return scene


def _shifted(scene: Scene, group: Sequence[str], moved: Placement) -> Scene:
    """The scene with the first of a group where it is moved to, and the others as far from it as they were."""
    by = np.subtract(moved.position, scene[group[0]].position)
    others = [scene[id] for id in group[1:]]
    return scene.with_placements(
        [moved, *(structs.replace(p, position=to_micrometres(np.add(p.position, by))) for p in others)]
    )


def _concerned(scene: Scene, shifted: Scene, id: str, group: Collection[str]) -> list[Placement]:
    """The moved object and what moved with it, and whatever is near to where one of them was or is."""
    places = [where[member] for where in (scene, shifted) for member in sorted(group)]
    near = [p for p in shifted.placements if p.id in group or any(apart(p, place) < CLOSE for place in places)]
    return [shifted[id], *(p for p in near if p.id != id)]


def _group(scene: Scene, id: str) -> tuple[str, ...]:
    """The ids of an object and of all that moves with it: what rests on it, or stands on it over its edge."""
    found, todo = {id}, [id]
    while todo:
        below = todo.pop()
        new = [p.id for p in scene.placements if p.id not in found and _is_on(scene, p, scene[below])]
        found.update(new)
        todo += new
    return (id, *(p.id for p in scene.placements if p.id in found and p.id != id))


def _is_on(scene: Scene, placement: Placement, below: Placement) -> bool:
    if placement.support == below.id:
        return True
    if not scene.asset_of(placement).free or not scene.asset_of(below).collides:
        return False
    tops = [below.position[2] + s.position[2] for s in scene.asset_of(below).surfaces] or [below.top]
    near = any(abs(placement.position[2] - top) < ON_TOP for top in tops)
    return near and placement.footprint.intersects(below.footprint) and placement.support not in scene
