"""The state of a room while it is edited, and what a policy is told of what is to be done."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
from msgspec import structs

from thinkblox.assets.source import AssetSource
from thinkblox.brief import Brief
from thinkblox.editing.goals import Apart, Goal, Nearing, overruled
from thinkblox.episode import Round
from thinkblox.observe import Kind
from thinkblox.placing import Effort
from thinkblox.plan import Plan, Target, Tie, is_object
from thinkblox.policies import Policy
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.verdict.world import World

Saved = tuple[World, int, int]
"""A room, and how much was done and wished for by then."""
_PLAIN_ID = "abcdefghijklmnopqrstuvwxyz0123456789_"


@dataclass(frozen=True)
class Wish:
    """What an order asks of one object, which is held against the finished room.

    Attributes:
        order: which order of the instruction, from 0.
        text: the order as it was written.
        before: the room before it.
    """

    order: int
    text: str
    id: str
    goal: Goal
    before: Scene


@dataclass
class Work:
    """A room that is being edited, with everything that was tried.

    Attributes:
        world: the room as it is now.
        start: the room before the instruction.
        before: the room before the order that is being done.
        planned: the plan that the room was made by, where that is known: what belongs to what.
        rounds: every round of tries.
        assets: of everything that was tried.
        done: what was done, in sentences.
        failed: what could not be done, with what was measured.
        notes: what else there is to say.
        left: which things left which seats behind.
        freed: Places that are kept free.
        kept: ids that must not be touched.
        wishes: what was asked of each object and done.
        order: number and text of the order that is being done.
    """

    world: World
    prompt: str
    planned: Plan | None
    policy: Policy
    source: AssetSource
    effort: Effort
    rng: np.random.Generator
    seed: int
    rounds: list[Round] = field(default_factory=list)
    assets: dict[str, Asset] = field(default_factory=dict)
    done: list[str] = field(default_factory=list)
    failed: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    left: list[tuple[str, list[str]]] = field(default_factory=list)
    freed: tuple[str, ...] = ()
    kept: frozenset[str] = frozenset()
    wishes: list[Wish] = field(default_factory=list)
    order: tuple[int, str] = (0, "")

    def __post_init__(self) -> None:
        self.start = self.before = self.world.scene

    @property
    def scene(self) -> Scene:
        """The room as it is now."""
        return self.world.scene

    def asset_of(self, id: str) -> Asset:
        """The asset of an object that is there."""
        return self.scene.asset_of(self.scene[id])

    def touched(self, ids: Iterable[str]) -> tuple[str, ...]:
        """Those of some objects that may be touched; where none is left, that is noted as not done."""
        ids = tuple(ids)
        left = tuple(id for id in ids if id not in self.kept)
        if ids and not left:
            self.failed.append(f"{', '.join(ids)} was not touched: it is to stay as it is")
        return left

    def saved(self) -> Saved:
        """What `restore` needs to take back what was done since."""
        return self.world, len(self.done), len(self.wishes)

    def restore(self, saved: Saved) -> None:
        """Take back what was done since; what was tried stays noted."""
        self.world = saved[0]
        del self.done[saved[1] :], self.wishes[saved[2] :]

    def wish(self, id: str, goals: Iterable[Goal]) -> None:
        """Note what was asked of an object and is so now."""
        number, text = self.order
        self.wishes += [Wish(number, text, id, goal, self.before) for goal in goals]

    def standing(self, id: str, goals: Sequence[Goal]) -> list[Goal]:
        """What earlier orders asked of an object and new goals do not ask otherwise."""
        return [
            wish.goal
            for wish in self.wishes
            if wish.id == id
            and wish.order < self.order[0]
            and wish.goal not in goals
            and not overruled(wish.goal, goals)
        ] + list(self._distances(id, goals))

    def _distances(self, id: str, goals: Sequence[Goal]) -> Iterator[Goal]:
        """The distances to which earlier orders brought an object, and which new goals may undo where they have to."""
        for wish in self.wishes:
            goal = wish.goal
            stepped = isinstance(goal, Nearing) and goal.by is not None and wish.order < self.order[0]
            if wish.id == id and stepped and isinstance(goal, Nearing) and overruled(goal, goals):
                yield Apart(goal.anchors, goal.of(self.scene, id))

    def unkept(self) -> Iterator[str]:
        """What was asked and done and is not so any more, by what came after it in the same instruction."""
        for wish in self.wishes:
            later = [w.goal for w in self.wishes if w.id == wish.id and w.order > wish.order]
            anchors = getattr(wish.goal, "anchors", ())
            there = wish.id in self.scene and not any(is_object(a) and a not in self.scene for a in anchors)
            if there and not overruled(wish.goal, later):
                held, says = wish.goal.check(wish.before, self.scene, wish.id)
                if not held:
                    yield f"'{wish.text}' is not so any more after what was done then: {says}"

    def plan(self, target: Target) -> Plan:
        """What is there and what is to be placed, as a policy is told it."""
        brief = self.planned.brief if self.planned is not None else Brief(prompt=self.scene.prompt or "a room")
        old = {t.id: t for t in self.planned.targets} if self.planned is not None else {}
        targets = [
            old[p.id] if p.id in old and old[p.id].category == p.category else _bare_target(p)
            for p in self.scene.placements
            if p.id != target.id and set(p.id) <= set(_PLAIN_ID) and is_object(p.id)
        ]
        told = structs.replace(brief, prompt=self.prompt, free=self.freed)
        return Plan(brief=told, targets=(*targets, target), free=self.freed)

    def kinds(self, plan: Plan) -> dict[str, Kind]:
        """What is known of the categories of a plan: the sizes of those that are there."""
        found = {p.category: Kind(size=p.size, mount=self.scene.asset_of(p).mount) for p in self.scene.placements}
        for target in plan.targets:
            if target.category not in found:
                size, mount = self.source.usual(target.category)
                found[target.category] = Kind(size=size, mount=mount)
        return found

    def request_of(self, category: str) -> str:
        """The key under which things of a category are planned: that of those that are there."""
        targets = self.planned.targets if self.planned is not None else ()
        return next((t.request for t in targets if t.category == category), category)

    def new_id(self, category: str) -> str:
        """An id that nothing has or had."""
        taken = {p.id for p in (*self.scene.placements, *self.start.placements)}
        number = 1 + max((int(n) for n in _numbers(category, taken)), default=0)
        return f"{category}_{number}"

    def target(self, id: str, category: str, ties: Sequence[Tie], attributes: tuple[str, ...] = ()) -> Target:
        """A target of an edit."""
        return Target(
            id=id, category=category, request=self.request_of(category), ties=tuple(ties), attributes=attributes
        )

    def usual_ties(self, id: str) -> tuple[Tie, ...]:
        """The relations that an object was planned with and whose anchors are there."""
        targets = self.planned.targets if self.planned is not None else ()
        ties = next((t.ties for t in targets if t.id == id), ())
        return tuple(tie for tie in ties if all(a in self.scene or not is_object(a) for a in tie.anchors))


def _numbers(category: str, ids: set[str]) -> list[str]:
    tails = (id.removeprefix(f"{category}_") for id in ids if id.startswith(f"{category}_"))
    return [tail for tail in tails if tail.isdecimal()]


def _bare_target(placement: Placement) -> Target:
    on = (Tie(kind="on", anchors=(placement.support,), asked=False),) if is_object(placement.support) else ()
    return Target(id=placement.id, category=placement.category, request=placement.category, asked=False, ties=on)
