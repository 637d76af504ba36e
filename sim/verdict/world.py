"""A room with what stands in it, ready to measure candidates for the next object one after the other."""

import math
from collections.abc import Sequence
from functools import cached_property, partial
from typing import NamedTuple

from msgspec import structs

from thinkblox.errors import InputError
from thinkblox.scene.actions import Action, Add, Move, Remove, Replace, Swap, outcome
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import MAX_EXTENT, MAX_HEIGHT, rectangle
from thinkblox.scene.scene import Scene, scene_given
from thinkblox.scene.support import ON_FLOOR, placed_at
from thinkblox.sim.build import add_placement, build_spec
from thinkblox.sim.geometry.access import FreeFloor
from thinkblox.sim.geometry.bounds import Boxes, Neighbours, piece_boxes
from thinkblox.sim.geometry.solid import solid_of
from thinkblox.sim.geometry.swings import Surroundings, surroundings
from thinkblox.sim.settings import Physics, Tolerances, Walking
from thinkblox.sim.verdict.blame import LeftAlone, blamed, left_alone
from thinkblox.sim.verdict.gate import Gate
from thinkblox.sim.verdict.judge import (
    Static,
    disturbs,
    fixed_supports,
    judge_motion,
    judge_pose,
    verdict,
    with_pressed,
    with_riders,
)
from thinkblox.sim.verdict.requirement import Requirement, check_requirements, unmet_by
from thinkblox.sim.verdict.stage import Settled, Stage
from thinkblox.verdict import Collision, Push, Reason, Swing, Unmet, Verdict

CANDIDATE = "//candidate"
"""Name of the candidate's body; no placement can be called so."""
PARKED = 50.0
"""Height above the ceiling at which the candidate waits [m]."""


class Cut(NamedTuple):
    """How much of a room a candidate is settled in.

    Attributes:
        reach: what comes within this of the candidate is there [m], with all that hangs together with it.
        gap: free objects nearer than this to each other hang together [m].
    """

    reach: float
    gap: float

    def holds(self, settled: Settled) -> bool:
        """Whether nothing moved so far that it might have touched what was left out."""
        return settled.moved <= self.reach - self.gap / 2 and settled.stirred <= self.gap / 2


NARROW, WHOLE = Cut(0.01, 0.01), Cut(math.inf, math.inf)
SOON = 0.5
"""How long a candidate is let go among sleepers, to see whether it stands squarely or falls [s]."""
KEPT = 32
"""Compiled parts of a room that a world keeps."""
MUCH = 0.25
"""What moves by this share of what is tolerated is let go again with everything awake."""
ROOMY = 4.0
"""An empty room is so much wider than what stands in it by itself, and so much higher [m]."""
WIDER = 0.05
"""How much wider than the way that the candidate went the second cut is [m]."""


class World:
    """The objects of a scene, still and asleep; `check` measures candidates for one object more among them.

    A candidate is measured among what it can touch and what that hangs together with. When anything moves so far that
    it might touch more, it is measured again in a wider part of the room, at last in all of it. The verdict is the one
    that the whole room gives.

    Args:
        scene: what stands there.
        tolerances: where the lines are drawn.
        physics: the engine's options.
        walking: what a walkable way is.
        requirements: what the user requires of every placement besides.
    """

    def __init__(
        self,
        scene: Scene,
        *,
        tolerances: Tolerances | None = None,
        physics: Physics | None = None,
        walking: Walking | None = None,
        requirements: Sequence[Requirement] = (),
    ) -> None:
        self.scene = scene_given(scene)
        self._tolerances = tolerances or Tolerances()
        self._physics = physics or Physics()
        self._walking = walking or Walking()
        self._requirements = check_requirements(requirements)
        self._stages: dict[tuple[Asset, frozenset[str], bool], Stage] = {}
        self._alone: dict[frozenset[str], LeftAlone] = {}
        self._without: dict[str, World] = {}

    def check(self, candidates: Sequence[Placement], asset: Asset, *, way: bool = True) -> list[Verdict]:
        """Measure every candidate placement of one object, each by itself among the scene's objects.

        Args:
            candidates: placements of `asset`. An object of the same id in the scene is looked past; where things rest
                on it and the candidate puts it elsewhere, they ride along and are measured with it.
            asset: what they all place.
            way: whether the room must keep a walkable way to its doors and large objects.

        Raises:
            InputError: the engine cannot build the asset; says what it said.
        """
        if isinstance(candidates, Placement | Asset):
            raise InputError("World.check takes a list of placements, and then the asset that they all place")
        verdicts: dict[int, Verdict] = {}
        grouped = [number for number, candidate in enumerate(candidates) if self._takes_along(candidate)]
        for number in grouped:
            verdicts[number] = self.measure(self._as_action(candidates[number], asset), way=way)
        for id in dict.fromkeys(candidate.id for candidate in candidates):
            numbers = [n for n, candidate in enumerate(candidates) if candidate.id == id and n not in verdicts]
            world = self._looking_past(id)
            verdicts.update(zip(numbers, world._check([candidates[n] for n in numbers], asset, way), strict=True))
        return [verdicts[number] for number in range(len(candidates))]

    def measure(self, action: Action, *, way: bool = True) -> Verdict:
        """Measure an action: what it moves where that goes, what rides along, and what it leaves without its support.

        The verdict is that on the object that the action names, and holds those on the others as `riders`; for a
        removal it is about what rested on it, and for a swap the other object is among the riders.

        Args:
            action: of ids that the scene has.
            way: as for `check`.

        Raises:
            KeyError, InputError: as `Scene.apply`; the engine cannot build an asset.
        """
        after, carried, left = outcome(self.scene, action)
        if isinstance(action, Add):
            return self.check([after[action.id]], action.asset, way=way)[0]
        if after == self.scene:
            return self._standing(action.id, way)
        world = self.with_scene(after)
        moved = (action.id, *((action.other,) if isinstance(action, Swap) else ()), *carried)
        others = dict.fromkeys((*moved[1:], *left, *(id for gone in moved for id in self._leaning_on(gone))))
        others.pop(action.id, None)
        riders = [world._standing(id, way) for id in others]
        if isinstance(action, Remove):
            return with_riders(Verdict(id=action.id, valid=True), riders)
        return with_riders(world._standing(action.id, way), riders)

    def ruled_out(self, action: Action) -> Verdict | None:
        """The verdict on an action by outlines alone, where these rule it out; None where it has to be measured.

        Args:
            action: of ids that the scene has, as for `measure`.

        Returns:
            As `measure`, of what was found first: the object that the action names, what it changes places with, or
            what rides along reaches outside the room or deep into something.
        """
        after, carried, _ = outcome(self.scene, action)
        world = self.with_scene(after)
        for id in (action.id, *((action.other,) if isinstance(action, Swap) else ()), *carried):
            placement, alone = after[id], world._looking_past(id)
            asset = after.asset_of(placement)
            gate = Gate(alone.scene, alone._neighbours, asset, [placement], self._physics) if asset.collides else None
            if (static := alone._static(placement, asset, gate)).gated:
                found = alone._judge(placement, asset, gate, static, ())
                return found if id == action.id else with_riders(Verdict(id=action.id, valid=True), [found])
        return None

    def by_itself(self, asset: Asset) -> Verdict:
        """The verdict on an asset on an empty level floor, by the same lines: whether it stands if nothing holds it."""
        side = min(MAX_EXTENT, ROOMY * (1.0 + max(asset.size)))
        empty = Scene(room=rectangle(side, side, height=min(MAX_HEIGHT, ROOMY + asset.size[2])))
        there = placed_at(empty, asset, id=asset.category, position=(side / 2, side / 2, 0.0), yaw=0.0)
        world = self.with_scene(empty)
        return world._judge(there, asset, None, world._static(there, asset, None), ())

    def stands_firmly(self, id: str) -> bool:
        """Whether an object of the scene that is let go where it stands is seen to stay at once.

        What is not, such as a pencil that lies on its edge, may stay as well; it has to be watched whenever anything
        that hangs together with it is measured.
        """
        placement = self.scene[id]
        asset = self.scene.asset_of(placement)
        if not asset.free:
            return True
        world, boxes = self._looking_past(id), piece_boxes(solid_of(asset), placement)
        near = world._hanging_together(boxes, NARROW, frozenset())
        stage = world._stage(asset, near, awake=False)
        return stage.settle(CANDIDATE, placement, seconds=min(SOON, self._physics.settle_time)).decided

    def swings(self, id: str) -> tuple[Swing, ...]:
        """The doors and drawers that do not simply open because of where an object stands, as a Verdict has them."""
        placement = self.scene[id]
        asset = self.scene.asset_of(placement)
        return self._surroundings.swings(placement, asset) if asset.collides else ()

    def _leaning_on(self, id: str) -> list[str]:
        """Whatever free and not on the floor is near enough to an object that it may stand on it, in part at least."""
        placement = self.scene[id]
        asset = self.scene.asset_of(placement)
        if not asset.collides:
            return []
        near = self._neighbours.meetings(piece_boxes(solid_of(asset), placement), NARROW.reach)
        there = [self.scene[other] for other in near if other != id]
        return [p.id for p in there if self.scene.asset_of(p).free and p.position[2] > ON_FLOOR]

    def _standing(self, id: str, way: bool) -> Verdict:
        """The verdict on an object where it stands."""
        placement = self.scene[id]
        return self.check([placement], self.scene.asset_of(placement), way=way)[0]

    def _takes_along(self, candidate: Placement) -> bool:
        """Whether a candidate puts an object of the scene elsewhere, and others stand on that."""
        if candidate.id not in self.scene:
            return False
        old = self.scene[candidate.id]
        if (old.position, old.yaw, old.asset) == (candidate.position, candidate.yaw, candidate.asset):
            return False
        return bool(self.scene.resting_on(candidate.id) or self._leaning_on(candidate.id))

    def _as_action(self, candidate: Placement, asset: Asset) -> Action:
        """Another pose of an object that the scene has, and maybe another asset, as an action."""
        if self.scene[candidate.id].asset == asset.id:
            return Move(id=candidate.id, position=candidate.position, yaw=candidate.yaw)
        return Replace(id=candidate.id, asset=asset, position=candidate.position, yaw=candidate.yaw)

    def with_placement(self, placement: Placement, asset: Asset) -> "World":
        """The world of a scene with one object more, made out of this one: cheaper than a new one, and the same."""
        grown = self.with_scene(self.scene.with_placement(placement, asset))
        if placement.id not in self.scene:
            grown._neighbours = self._neighbours.with_object(placement, solid_of(asset))
            grown._floor = self._floor.with_object(placement, solid_of(asset))
            grown._surroundings = self._surroundings.with_objects([(placement, asset)])
        return grown

    def _looking_past(self, id: str) -> "World":
        if id not in self.scene:
            return self
        if id not in self._without:
            world = self.with_scene(self.scene.without(id))
            world._neighbours, world._surroundings = self._neighbours.without(id), self._surroundings
            self._without = {id: world}
        return self._without[id]

    def with_scene(self, scene: Scene) -> "World":
        """The world of another scene, with the same settings."""
        return World(
            scene,
            tolerances=self._tolerances,
            physics=self._physics,
            walking=self._walking,
            requirements=self._requirements,
        )

    def _check(self, candidates: Sequence[Placement], asset: Asset, way: bool) -> list[Verdict]:
        gate = Gate(self.scene, self._neighbours, asset, candidates, self._physics) if asset.collides else None
        statics = [self._static(candidate, asset, gate) for candidate in candidates]
        possible = [candidate for candidate, static in zip(candidates, statics, strict=True) if not static.gated]
        lost = iter(self._floor.cut_off(possible, solid_of(asset)) if way and possible else [()] * len(possible))
        return [
            self._judge(candidate, asset, gate, static, () if static.gated else next(lost))
            for candidate, static in zip(candidates, statics, strict=True)
        ]

    def _static(self, candidate: Placement, asset: Asset, gate: Gate | None) -> Static:
        collisions = () if gate is None else gate.collisions(candidate, self._tolerances.penetration)
        swings = self._surroundings.swings(candidate, asset) if asset.collides else ()
        return judge_pose(
            self.scene.room,
            candidate,
            asset,
            self._tolerances,
            self._walking,
            collisions=collisions,
            swings=swings,
        )

    def _judge(
        self, candidate: Placement, asset: Asset, gate: Gate | None, static: Static, cut_off: tuple[str, ...]
    ) -> Verdict:
        said = partial(verdict, candidate, cut_off=cut_off, unmet=self._unmet(candidate, asset))
        if not asset.free:
            pushed = () if gate is None or static.gated else self._pushed_by(candidate, asset, gate)
            more: frozenset[Reason] = frozenset({"pushes"} if disturbs(pushed, self._tolerances) else ())
            fixed = said(static, supports=fixed_supports(candidate, asset, static), more=more)
            return structs.replace(fixed, pushed=pushed)
        if static.gated:
            return said(static)
        boxes = piece_boxes(solid_of(asset), candidate) if gate is None else gate.boxes[candidate]
        settled = self._settled(candidate, asset, boxes)
        static = with_pressed(static, self._pressed(settled))
        moved = judge_motion(settled.motion, self._tolerances)
        loose = sum(support.share for support in settled.supports) < self._tolerances.carried and not moved
        more = moved | (frozenset({"unsupported"}) if loose else frozenset())
        return said(static, motion=settled.motion, supports=settled.supports, more=more)

    def _pushed_by(self, candidate: Placement, asset: Asset, gate: Gate) -> tuple[Push, ...]:
        """How far a fixed object moves what it reaches into by less than is tolerated, and what would stand without."""
        reached = [other for other, touch in gate.touches(candidate).items() if touch.depth > 0.0]
        free = [other for other in reached if self.scene.asset_of(self.scene[other]).free]
        if not free:
            return ()
        world = self.with_placement(candidate, asset)
        found = []
        for other in free:
            moved = world._standing(other, way=False)
            if not moved.valid and self._standing(other, way=False).valid:
                found.append(Push(other=other, distance=moved.drift, tilt=moved.tilt))
        return tuple(found)

    def _unmet(self, candidate: Placement, asset: Asset) -> tuple[Unmet, ...]:
        if not self._requirements:
            return ()
        return unmet_by(self._requirements, self.scene.with_placement(candidate, asset), candidate)

    def _settled(self, candidate: Placement, asset: Asset, boxes: Boxes) -> Settled:
        """Let the candidate come to rest in the narrowest part of the room that turns out to be wide enough.

        What lies or stands for good soon, and what falls far, is measured among sleepers. What is still undecided then
        is near an edge, leans, wobbles or trembles: it is watched from the beginning with everything awake. So is what
        moves or presses too much, for sleepers do not give way as they do awake, and what has something floating over
        it, for a sleeper does not fall.
        """
        falling = self._neighbours.falling_on(boxes, NARROW.gap)
        asleep, near = not falling, self._hanging_together(boxes, NARROW, falling)
        settled, there = self._wide_enough(candidate, asset, boxes, near, awake=not asleep)
        if asleep and (not settled.decided or self._doubtful(settled)):
            settled, there = self._wide_enough(candidate, asset, boxes, near, awake=True)
        blames = settled.motion.restless or disturbs(settled.motion.pushed, self._tolerances) or self._pressed(settled)
        if not blames:
            return settled
        return blamed(settled, self._left_alone(there))

    def _doubtful(self, settled: Settled) -> bool:
        """Whether it moved much or fails, and not by so much that nothing can change that.

        What falls and strikes ends elsewhere for each hair's breadth by which a sleeper lies higher.
        """
        motion, limits = settled.motion, self._tolerances
        if max(motion.drift, motion.drop) > self._physics.lost:
            return False
        far = motion.drift > MUCH * limits.drift or motion.drop > MUCH * (limits.drop + limits.clearance)
        return far or bool(judge_motion(motion, limits) or self._pressed(settled))

    def _wide_enough(
        self, candidate: Placement, asset: Asset, boxes: Boxes, there: frozenset[str], *, awake: bool
    ) -> tuple[Settled, frozenset[str]]:
        """How it settles, and among what, beginning with what a narrow cut holds."""
        cut = NARROW
        seconds = self._physics.settle_time if awake else min(SOON, self._physics.settle_time)
        settled = self._stage(asset, there, awake).settle(CANDIDATE, candidate, seconds=seconds)
        while cut is not WHOLE and not cut.holds(settled):
            cut = WHOLE if cut is not NARROW else _wider(settled)
            before, there = there, self._within(boxes, cut)
            if there != before:
                settled = self._stage(asset, there, awake).settle(CANDIDATE, candidate, seconds=seconds)
        return settled, there

    def _pressed(self, settled: Settled) -> tuple[Collision, ...]:
        """What is pressed deeper than tolerated into the candidate, or by it into something else, at rest."""
        deepest: dict[str, float] = {}
        for pair, depth in settled.depths.items():
            if depth > self._tolerances.penetration:
                other = self._pressed_of(pair)
                deepest[other] = max(depth, deepest.get(other, 0.0))
        return tuple(Collision(other=other, depth=round(depth, 6), overlap=0.0) for other, depth in deepest.items())

    def _pressed_of(self, pair: tuple[str, str]) -> str:
        """The name of what gives way: what touches the candidate, or the lighter of two others, as its contacts do."""
        others = [name for name in pair if name != CANDIDATE]
        placed = [name for name in others if name in self.scene]
        return min(placed, key=lambda id: self.scene.asset_of(self.scene[id]).mass, default=others[0])

    def _left_alone(self, there: frozenset[str]) -> LeftAlone:
        if there not in self._alone:
            if len(self._alone) >= KEPT:
                del self._alone[next(iter(self._alone))]
            self._alone[there] = left_alone(build_spec(self.scene, physics=self._physics, only=there), self._physics)
        return self._alone[there]

    def _within(self, boxes: Boxes, cut: Cut) -> frozenset[str]:
        """The objects that a cut holds."""
        return self._hanging_together(boxes, cut, self._neighbours.falling_on(boxes, cut.gap))

    def _hanging_together(self, boxes: Boxes, cut: Cut, falling: frozenset[str]) -> frozenset[str]:
        near = self._neighbours.meetings(boxes, cut.reach).keys() | falling
        return self._neighbours.hanging_together(near, cut.gap)

    def _stage(self, asset: Asset, there: frozenset[str], awake: bool) -> Stage:
        key = (asset, there, awake)
        if key not in self._stages:
            if len(self._stages) >= KEPT:
                del self._stages[next(iter(self._stages))]
            spec = build_spec(self.scene, physics=self._physics, sleeping=not awake, only=there)
            add_placement(spec, _parked(asset, self.scene.room.height + PARKED), asset, free=True, name=CANDIDATE)
            self._stages[key] = Stage(spec, self._physics)
        return self._stages[key]

    @cached_property
    def _neighbours(self) -> Neighbours:
        return Neighbours(self.scene)

    @cached_property
    def _surroundings(self) -> Surroundings:
        return surroundings(self.scene, self._walking)

    @cached_property
    def _floor(self) -> FreeFloor:
        return FreeFloor.of(self.scene, self._walking)


def _wider(settled: Settled) -> Cut:
    return Cut(settled.moved + WIDER, WIDER)


def _parked(asset: Asset, height: float) -> Placement:
    return Placement(
        id="candidate", category=asset.category, asset=asset.id, position=(0.0, 0.0, height), yaw=0.0, size=asset.size,
    )  # fmt: skip
