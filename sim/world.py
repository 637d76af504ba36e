"""A room with what stands in it, ready to measure candidates for the next object one after the other."""

from collections.abc import Sequence
from functools import cached_property

import mujoco

from thinkblox.asset import Asset
from thinkblox.scene import Placement, Scene
from thinkblox.sim.access import Access, FreeFloor, free_floor
from thinkblox.sim.build import FREE_SUFFIX, add_placement, build_spec, yaw_quat
from thinkblox.sim.contacts import Contacts, shares
from thinkblox.sim.judge import Static, fixed_supports, judge_motion, judge_pose, verdict
from thinkblox.sim.settings import Physics, Tolerances, Walking
from thinkblox.sim.settle import settle_body
from thinkblox.sim.solid import solid_of
from thinkblox.verdict import Reason, Support, Verdict

PARKED = 50.0
"""Height at which the candidate waits while the model is compiled [m]."""


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
        self._stages: dict[str, _Stage] = {}

    def check(self, candidates: Sequence[Placement], asset: Asset, *, way: bool = True) -> list[Verdict]:
        """Measure every candidate placement of one object, each by itself among the scene's objects.

        Args:
            candidates: placements with one id; an object of that id in the scene is looked past.
            asset: what they all place.
            way: whether the room must keep a walkable way to its doors and large objects.
        """
        return [self._check(candidate, asset, way) for candidate in candidates]

    def _check(self, candidate: Placement, asset: Asset, way: bool) -> Verdict:
        if candidate.id in self.scene:
            others = World(
                self.scene.without(candidate.id),
                tolerances=self._tolerances,
                physics=self._physics,
                walking=self._walking,
            )
            return others._check(candidate, asset, way)
        stage = self._stage(asset) if asset.collides else None
        depths = stage.touch(candidate) if stage else {}
        static = judge_pose(self.scene, candidate, asset, depths, self._tolerances, self._walking)
        cut_off = self._cut_off(candidate, asset) if way and not static.gated else ()
        blocked: frozenset[Reason] = frozenset({"blocks_way"} if cut_off else ())
        if stage is None or not asset.free:
            supports = fixed_supports(self.scene.room, candidate, asset, static)
            return verdict(candidate, static, supports=supports, more=blocked, cut_off=cut_off)
        if static.gated:
            return verdict(candidate, static, more=blocked, cut_off=cut_off)
        return self._settle(stage, candidate, static, blocked, cut_off)

    def _settle(
        self,
        stage: "_Stage",
        candidate: Placement,
        static: Static,
        blocked: frozenset[Reason],
        cut_off: tuple[str, ...],
    ) -> Verdict:
        motion = settle_body(stage.model, stage.data, stage.address, self._physics)
        moved = judge_motion(motion, self._tolerances)
        supports = () if motion.unstable else stage.supports()
        carried = sum(support.share for support in supports)
        loose: frozenset[Reason] = frozenset(
            {"unsupported"} if carried < self._tolerances.carried and not moved else ()
        )
        return verdict(
            candidate, static, motion=motion, supports=supports, more=moved | loose | blocked, cut_off=cut_off
        )

    def _cut_off(self, candidate: Placement, asset: Asset) -> tuple[str, ...]:
        after = self._floor.with_objects([(candidate, solid_of(asset))]).access()
        return tuple(id for id in after.unreachable if id not in self._access.unreachable)

    @cached_property
    def _floor(self) -> FreeFloor:
        return free_floor(self.scene, self._walking)

    @cached_property
    def _access(self) -> Access:
        return self._floor.access()

    def _stage(self, asset: Asset) -> "_Stage":
        if asset.id not in self._stages:
            self._stages[asset.id] = _Stage(self.scene, asset, self._physics)
        return self._stages[asset.id]


class _Stage:
    """A compiled scene in which one more object, parked out of the way, is put wherever it is to be measured."""

    NAME = "//candidate"

    def __init__(self, scene: Scene, asset: Asset, physics: Physics) -> None:
        spec = build_spec(scene, physics=physics, sleeping=True)
        parked = Placement(
            id=self.NAME,
            category=asset.category,
            asset=asset.id,
            position=(0.0, 0.0, PARKED + scene.room.height),
            yaw=0.0,
            size=asset.size,
            support="",
        )
        add_placement(spec, parked, asset, free=True)
        self.model = spec.compile()
        self.data = mujoco.MjData(self.model)
        self.address = int(self.model.joint(self.NAME + FREE_SUFFIX).qposadr[0])
        self._body = int(self.model.body(self.NAME).id)
        self._contacts = Contacts(self.model)

    def touch(self, candidate: Placement) -> dict[str, float]:
        """Put the candidate where it is proposed; the deepest contact with each other thing [m]."""
        mujoco.mj_resetData(self.model, self.data)
        self.data.qpos[self.address : self.address + 7] = (*candidate.position, *yaw_quat(candidate.yaw))
        mujoco.mj_forward(self.model, self.data)
        return self._contacts.depths_of(self.data, self.NAME)

    def supports(self) -> tuple[Support, ...]:
        """What carries the candidate now; sleeping contacts are woken for it."""
        flags = self.model.opt.enableflags
        self.model.opt.enableflags = flags & ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
        mujoco.mj_forward(self.model, self.data)
        self.model.opt.enableflags = flags
        weight = float(self.model.body_subtreemass[self._body]) * -float(self.model.opt.gravity[2])
        return shares(self._contacts.carriers(self.data).get(self.NAME, {}), weight)
