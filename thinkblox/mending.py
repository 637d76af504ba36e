"""Moving what fails by the least that mends it: shifted, never turned, and measured like any other placement."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from itertools import islice
from typing import get_args

import numpy as np
from msgspec import structs

from thinkblox.scene import Placement, Scene
from thinkblox.shifts import Shift, shifts
from thinkblox.sim.settings import Physics, Tolerances, Walking
from thinkblox.sim.world import World
from thinkblox.value import Vec3
from thinkblox.verdict import Move, Reason, Verdict

FINE = 0.00025
"""How finely the least shift is found [m]."""
TIGHT = 0.0005
"""What was moved is left within this of touching what it rests on or hangs on [m]."""
STILL = 0.1
"""What was moved tilts less than this while settling [degrees]: nothing is left on the brink."""
CLOSE = 0.05
"""Whatever is nearer than this to something that moves is measured again [m]."""
ROUNDS: tuple[frozenset[Reason], ...] = (
    frozenset({"outside", "unsupported"}),
    frozenset({"collision"}),
    frozenset(get_args(Reason)),
    frozenset(get_args(Reason)),
)
"""Which faults are mended when: those against the room, then those that would burst apart in a settle, then all."""


def mend(
    scene: Scene,
    *,
    tolerances: Tolerances | None = None,
    physics: Physics | None = None,
    walking: Walking | None = None,
    tries: int = 160,
) -> tuple[Scene, tuple[Move, ...]]:
    """Move what fails by the least that makes it valid; returns the mended scene and every move.

    Nothing is turned. What rests on something that moves, moves with it. Of two that collide the lighter one is moved,
    the heavier one only when that cannot be. Whatever is valid stays where it is and stays valid; what cannot be
    mended stays where it is, and its move says so.

    Args:
        scene: at the poses that are to be mended; itself not changed.
        tolerances: where the lines are drawn. What is moved is moved until it just touches, not until it is tolerated.
        physics: the engine's options.
        walking: what a walkable way is.
        tries: poses that are measured at most for one object.
    """
    rules = _Rules(tolerances or Tolerances(), physics or Physics(), walking or Walking(), tries)
    return _Mending(scene, rules).run()


@dataclass(frozen=True)
class _Rules:
    tolerances: Tolerances
    physics: Physics
    walking: Walking
    tries: int

    @property
    def still(self) -> Tolerances:
        """Tolerances for what is moved, so that it is not left on the brink."""
        usual = self.tolerances
        return structs.replace(usual, drift=min(usual.drift, TIGHT), tilt=min(usual.tilt, STILL))

    @property
    def tight(self) -> Tolerances:
        """Besides, so that it just touches what it rests on, hangs on and stands beside."""
        usual = self.still
        return structs.replace(
            usual,
            penetration=min(usual.penetration, TIGHT / 5),
            outside=min(usual.outside, TIGHT / 5),
            touching=min(usual.touching, TIGHT),
            clearance=min(usual.clearance, TIGHT),
            drop=min(usual.drop, TIGHT),
        )

    def world(self, scene: Scene, tolerances: Tolerances | None = None) -> World:
        """The scene, ready to measure in."""
        return World(scene, tolerances=tolerances or self.tolerances, physics=self.physics, walking=self.walking)


@dataclass
class _Mending:
    """The scene as mended so far, what it was before each move, and the verdicts at the start and now."""

    scene: Scene
    rules: _Rules
    steps: list[Scene] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.start = self.scene
        self.before = self.now = self._verdicts(self.scene)

    def run(self) -> tuple[Scene, tuple[Move, ...]]:
        """Mend what can be mended."""
        for number, reasons in enumerate(ROUNDS):
            count = len(self.steps)
            for id in self._order(reasons, early=number == 0):
                if not self._verdict(id).valid:
                    self._mend(id, early=number == 0)
            if len(self.steps) > count:
                self.now = self._verdicts(self.scene)
        self._take_back_what_broke()
        self._put_back_what_failed()
        return self.scene, tuple(self._moves())

    def _verdicts(self, scene: Scene) -> dict[str, Verdict]:
        world = self.rules.world(scene)
        return {p.id: world.check([p], scene.asset_of(p))[0] for p in scene.placements}

    def _verdict(self, id: str) -> Verdict:
        placement = self.scene[id]
        return self.rules.world(self.scene).check([placement], self.scene.asset_of(placement))[0]

    def _order(self, reasons: frozenset[Reason], *, early: bool) -> list[str]:
        """Ids that fail so: carriers before what they carry when the room is concerned, else the lighter ones first."""
        failing = [v for v in self.now.values() if reasons.intersection(v.reasons)]
        order = sorted((self._mass(v.id), v.id) for v in failing)
        return [id for _, id in (sorted(order, key=lambda item: self._depth(item[1])) if early else order)]

    def _mass(self, id: str) -> float:
        """Mass of an object with all that rests on it [kg]."""
        group = [self.scene[id], *_riders(self.scene, id)]
        return sum(self.scene.asset_of(p).mass for p in group)

    def _depth(self, id: str) -> int:
        """How many objects are below it."""
        below, seen = self.scene[id].support, {id}
        while below in self.scene and below not in seen:
            seen.add(below)
            below = self.scene[below].support
        return len(seen)

    def _mend(self, id: str, *, early: bool) -> None:
        """Move one object to the nearest pose that is valid and spoils nothing, if one is found."""
        later = self._mended_later(id) if early else set()
        for moved in self._poses(id, later):
            shifted = _shifted(self.scene, id, moved)
            after = self._after(shifted, id, later)
            if after is not None:
                self.steps.append(self.scene)
                self.scene, self.now = shifted, self.now | after
                return

    def _mended_later(self, id: str) -> set[str]:
        """Lighter objects that it collides with: they will be moved away from it."""
        return {
            c.other
            for c in self.now[id].collisions
            if not self.now[c.other].valid and self._mass(c.other) < self._mass(id)
        }

    def _poses(self, id: str, later: set[str]) -> Iterator[Placement]:
        """Valid poses among what stays where it is, nearest first, each brought as near as it gets."""
        placement, riders = self.scene[id], _riders(self.scene, id)
        rest = _without(self.scene, {p.id for p in riders} | later)
        near = shifts(self.scene, placement, riders, self.rules.walking, past=later)[: self.rules.tries]
        for strictness in ((self.rules.tight, self.rules.still), (self.rules.tolerances,)):
            worlds = [self.rules.world(rest, tolerances) for tolerances in strictness]
            found = (self._nearest(world, placement, shift) for shift in near for world in worlds)
            yield from islice((pose for pose in found if pose is not None), 4)

    def _nearest(self, world: World, placement: Placement, shift: Shift) -> Placement | None:
        """The valid pose next to the failing one on the way to a shifted one; None when that one fails too."""
        asset = world.scene.asset_of(placement)

        def check(position: Vec3) -> Placement | None:
            candidate = structs.replace(placement, position=position)
            verdict = world.check([candidate], asset)[0]
            return _carried(candidate, verdict, world.scene) if verdict.valid else None

        best = check(shift.placement.position)
        if best is None:
            return None
        fails = np.add(placement.position, shift.across)
        while np.linalg.norm(best.position - fails) > FINE:
            middle = (fails + best.position) / 2
            nearer = check(_rounded(middle))
            fails, best = (middle, best) if nearer is None else (fails, nearer)
        return best

    def _after(self, shifted: Scene, id: str, later: set[str]) -> dict[str, Verdict] | None:
        """The new verdicts of all that a move may concern, or None when it spoils something or does not mend."""
        world = self.rules.world(shifted)
        found: dict[str, Verdict] = {}
        for placement in _concerned(self.scene, shifted, id):
            verdict = world.check([placement], shifted.asset_of(placement))[0]
            mended = placement.id == id and {c.other for c in verdict.collisions} <= later
            if not verdict.valid and (self.now[placement.id].valid or (placement.id == id and not (later and mended))):
                return None
            found[placement.id] = verdict
        return found

    def _take_back_what_broke(self) -> None:
        """Undo the last moves while something fails that was valid at the start."""
        while self.steps and any(self.before[id].valid and not v.valid for id, v in self.now.items()):
            self.scene = self.steps.pop()
            self.now = self._verdicts(self.scene)

    def _put_back_what_failed(self) -> None:
        """What was moved and fails yet goes back, unless that spoils something."""
        for id, verdict in list(self.now.items()):
            old, new = self.start[id], self.scene[id]
            if verdict.valid or old == new or self.before[id].valid:
                continue
            back = self.scene.with_placement(old, self.start.asset_of(old))
            again = self._verdicts(back)
            if all(again[other].valid for other, v in self.now.items() if v.valid):
                self.scene, self.now = back, again

    def _moves(self) -> Iterator[Move]:
        for old in self.start.placements:
            new = self.scene[old.id]
            dx, dy, dz = (round(b - a, 6) for a, b in zip(old.position, new.position, strict=True))
            if new.position != old.position or not self.now[old.id].valid:
                distance = round(float(np.linalg.norm((dx, dy, dz))), 6)
                why = self.before[old.id].reasons or self._reasons_below(old)
                yield Move(
                    id=old.id, by=(dx, dy, dz), turn=0.0, distance=distance, why=why, mended=self.now[old.id].valid
                )

    def _reasons_below(self, placement: Placement) -> tuple[Reason, ...]:
        """Why what carries an object was moved."""
        seen: set[str] = set()
        while placement.support in self.start and placement.support not in seen:
            seen.add(placement.support)
            placement = self.start[placement.support]
            if self.before[placement.id].reasons:
                return self.before[placement.id].reasons
        return ()


def _riders(scene: Scene, id: str) -> tuple[Placement, ...]:
    """What rests on an object, and on that."""
    found: dict[str, Placement] = {}
    todo = [id]
    while todo:
        for placement in scene.resting_on(todo.pop()):
            if placement.id not in found and placement.id != id:
                found[placement.id] = placement
                todo.append(placement.id)
    return tuple(found.values())


def _without(scene: Scene, ids: Iterable[str]) -> Scene:
    for id in sorted(ids):
        scene = scene.without(id)
    return scene


def _shifted(scene: Scene, id: str, moved: Placement) -> Scene:
    """The scene with one object at another pose, and what rests on it shifted alike."""
    by = np.subtract(moved.position, scene[id].position)
    for rider in _riders(scene, id):
        scene = scene.moved(rider.id, position=_rounded(rider.position + by))
    return scene.with_placement(moved, scene.asset_of(moved))


def _carried(candidate: Placement, verdict: Verdict, scene: Scene) -> Placement:
    """The candidate with the support that carries it now, where that is another one than before."""
    carriers = [s.by for s in verdict.supports if s.by == "floor" or s.by in scene]
    if not verdict.settled or not carriers or candidate.support in carriers:
        return candidate
    return structs.replace(candidate, support=carriers[0])


def _concerned(scene: Scene, shifted: Scene, id: str) -> list[Placement]:
    """The moved object and its riders, and whatever is near to where one of them was or is."""
    group = {id, *(p.id for p in _riders(scene, id))}
    places = [where[member] for where in (scene, shifted) for member in sorted(group)]
    return [shifted[id]] + [
        p
        for p in shifted.placements
        if p.id != id and (p.id in group or any(_gap(p, place) < CLOSE for place in places))
    ]


def _gap(a: Placement, b: Placement) -> float:
    """Least distance between the circles round two footprints [m]."""
    radii = (np.hypot(*a.size[:2]) + np.hypot(*b.size[:2])) / 2
    return float(np.hypot(a.position[0] - b.position[0], a.position[1] - b.position[1]) - radii)


def _rounded(position: np.ndarray) -> Vec3:
    x, y, z = (round(float(c), 6) for c in position)
    return (x, y, z)
