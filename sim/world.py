"""A room with what stands in it, ready to measure candidates for the next object one after the other."""

from collections.abc import Sequence
from functools import cached_property

import mujoco

from thinkblox.asset import Asset
from thinkblox.scene import Placement, Scene
from thinkblox.sim.access import FreeFloor, free_floor
from thinkblox.sim.build import add_placement, build_spec
from thinkblox.sim.judge import fixed_supports, judge_pose, verdict
from thinkblox.sim.settings import Physics, Tolerances, Walking
from thinkblox.sim.solid import solid_of
from thinkblox.sim.stage import Stage, settled_verdict
from thinkblox.verdict import Access, Verdict

CANDIDATE = "//candidate"
"""Name of the candidate's body; no placement can be called so by the step language."""
PARKED = 50.0
"""Height above the ceiling at which the candidate waits [m]."""


class World:
    """The objects of a scene, still and asleep; `check` measures candidates for one object more among them."""

    def __init__(
        self,
        scene: Scene,
        *,
        tolerances: Tolerances | None = None,
        physics: Physics | None = None,
        walking: Walking | None = None,
    ) -> None:
        self.scene = scene
        self._tolerances = tolerances or Tolerances()
        self._physics = physics or Physics()
        self._walking = walking or Walking()
        self._stages: dict[str, Stage] = {}
        self._without: dict[str, World] = {}

    def check(self, candidates: Sequence[Placement], asset: Asset, *, way: bool = True) -> list[Verdict]:
        """Measure every candidate placement of one object, each by itself among the scene's objects.

        Args:
            candidates: placements of `asset`; an object of the same id in the scene is looked past.
            asset: what they all place.
            way: whether the room must keep a walkable way to its doors and large objects.
        """
        return [self._looking_past(candidate.id)._check(candidate, asset, way) for candidate in candidates]

    def with_placement(self, placement: Placement, asset: Asset) -> "World":
        """The world of a scene with one object more, made out of this one: cheaper than a new one, and the same."""
        grown = self._like(self.scene.with_placement(placement, asset))
        if placement.id not in self.scene:
            grown._base = self._base.copy()
            add_placement(grown._base, placement, asset, asleep=True)
            grown._floor = self._floor.with_objects([(placement, solid_of(asset))])
        return grown

    def cut_off(self, candidate: Placement, asset: Asset) -> tuple[str, ...]:
        """Ids of the doors and large objects, itself among them, that have no walkable way once it stands there."""
        after = self._floor.with_objects([(candidate, solid_of(asset))]).access()
        return tuple(id for id in after.unreachable if id not in self._access.unreachable)

    def _looking_past(self, id: str) -> "World":
        if id not in self.scene:
            return self
        if id not in self._without:
            self._without[id] = self._like(self.scene.without(id))
        return self._without[id]

    def _like(self, scene: Scene) -> "World":
        return World(scene, tolerances=self._tolerances, physics=self._physics, walking=self._walking)

    def _check(self, candidate: Placement, asset: Asset, way: bool) -> Verdict:
        depths = self._touch(candidate, asset) if asset.collides else {}
        static = judge_pose(self.scene, candidate, asset, depths, self._tolerances, self._walking)
        cut_off = self.cut_off(candidate, asset) if way and not static.gated else ()
        if asset.free:
            return settled_verdict(self._stage(asset), CANDIDATE, candidate, static, self._tolerances, cut_off=cut_off)
        supports = fixed_supports(candidate, asset, static)
        return verdict(candidate, static, supports=supports, cut_off=cut_off)

    def _touch(self, candidate: Placement, asset: Asset) -> dict[str, float]:
        stage = self._stage(asset)
        stage.put(CANDIDATE, candidate)
        return stage.touching(CANDIDATE)

    def _stage(self, asset: Asset) -> Stage:
        if asset.id not in self._stages:
            spec = self._base.copy()
            add_placement(spec, _parked(asset, self.scene.room.height + PARKED), asset, free=True)
            self._stages[asset.id] = Stage(spec, self._physics)
        return self._stages[asset.id]

    @cached_property
    def _base(self) -> mujoco.MjSpec:
        return build_spec(self.scene, physics=self._physics, sleeping=True)

    @cached_property
    def _floor(self) -> FreeFloor:
        return free_floor(self.scene, self._walking)

    @cached_property
    def _access(self) -> Access:
        return self._floor.access()


def _parked(asset: Asset, height: float) -> Placement:
    return Placement(
        id=CANDIDATE, category=asset.category, asset=asset.id, position=(0.0, 0.0, height), yaw=0.0, size=asset.size,
        support="",
    )  # fmt: skip
