"""One object to where an order wants it: proposed, held against the goals, measured, committed; or searched for."""

import math
import time
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import chain, islice

from msgspec import structs

from thinkblox.assets import facts_of
from thinkblox.committing import commit
from thinkblox.editing.goals import Goal
from thinkblox.editing.spots import Pose, whole_floor
from thinkblox.editing.work import Work
from thinkblox.episode import Round, RoundKind
from thinkblox.feedback import feedback_line
from thinkblox.judging import Proposal, Try, answers, rejected, size_range, understand
from thinkblox.observe import observe
from thinkblox.phrases import phrase
from thinkblox.plan import Target, Tie
from thinkblox.scene.actions import Action, Add, Move, Replace
from thinkblox.scene.asset import Asset
from thinkblox.scene.nearby import nearest_poses
from thinkblox.scene.placement import Placement
from thinkblox.scene.saying import place_words
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import ON_FLOOR, placed_at
from thinkblox.scene.windows import covered_openings
from thinkblox.steps import Rejection, write_step
from thinkblox.value import Vec3
from thinkblox.verdict import Verdict

SEARCHED = 24
"""Poses around the best start that are measured when nothing that was proposed will do."""
LOOKED_AT = 250
"""Poses nearby, and on the whole floor, that are held against the goals for that."""
MORE = 200
"""Poses at what the order names that are held against the goals."""
GROUPS = 4
"""Poses at which something is measured with all that rests on it; before that it is measured by itself."""
DIRECT = 16
"""Poses that follow from the order itself that are measured."""


@dataclass
class Reaching:
    """The rounds for one object. `run` does it and says whether it could; `why` says what spoke against it.

    Attributes:
        target: with the relations that the policy is told.
        asset: what it shows then.
        goals: all of them hold of what is committed.
        direct: poses that follow from the order itself, the best first; tried before anybody is asked.
        ask: whether the policy is asked.
        search: whether the surroundings of what came nearest are searched when nothing else will do.
        begin: where that search begins when nothing was proposed.
        more: poses that are tried when nobody that was asked knew one.
        tries: how many of the direct poses are looked at.
    """

    work: Work
    target: Target
    asset: Asset
    goals: Sequence[Goal]
    direct: Iterable[Pose] = ()
    ask: bool = True
    search: bool = True
    begin: Pose | None = None
    more: Iterable[Pose] = ()
    tries: int = DIRECT
    failed: list[tuple[Proposal, Verdict]] = field(default_factory=list)
    missed: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.there = self.target.id in self.work.scene
        gone = [self.target.id, *(p.id for p in self.work.scene.riders(self.target.id))] if self.there else []
        self.empty = without(self.work.scene, gone)
        self.alone = self.work.world.with_scene(self.empty)
        self.groups = 0
        self.barred = ""

    def run(self) -> bool:
        """Place the object; False where nothing that was found both passes and meets the goals."""
        direct = (self._proposal(pose, "It follows from the order.") for pose in islice(self.direct, self.tries))
        if self._try("repair", direct):
            return True
        feedback: tuple[str, ...] = ()
        for number in range(self.work.effort.rounds if self.ask else 0):
            done, feedback = self._ask(number, feedback)
            if done:
                return True
        more = (self._proposal(pose, "It is where the order says.") for pose in islice(self.more, MORE))
        if self._try("repair", more, most=DIRECT):
            return True
        return self.search and self._try("repair", self._around(), most=SEARCHED)

    @property
    def why(self) -> str:
        """What spoke against it: the failure of the try that came nearest, or what was missed."""
        if self.failed:
            return str(min(self.failed, key=_badness)[1])
        return self.barred or (self.missed[-1] if self.missed else "") or f"{self.target.id}: no free place was found"

    def action(self, position: Vec3, yaw: float, asset: Asset) -> Action:
        """What puts the object at a pose."""
        id = self.target.id
        if not self.there:
            return Add(id=id, asset=asset, position=position, yaw=yaw)
        if self.work.scene[id].asset == asset.id:
            return Move(id=id, position=position, yaw=yaw)
        return Replace(id=id, asset=asset, position=position, yaw=yaw)

    def _proposal(self, pose: Pose, why: str) -> Proposal:
        (x, y, z), yaw = pose
        place = placed_at(self.empty, self.asset, id=self.target.id, position=(x, y, z), yaw=yaw)
        words = ", ".join(phrase(word) for word in place_words(self.empty, self.asset, place))
        lines = (why, f"So it goes {words}.")
        id, position = self.target.id, place.position
        action = self.action(position, place.yaw, self.asset)
        if isinstance(action, Add):
            text = write_step(lines, id=id, position=position, yaw=place.yaw, size=self.asset.size)
        elif isinstance(action, Move):
            text = write_step(lines, action="move", id=id, position=position, yaw=place.yaw)
        else:
            size, category = self.asset.size, self.asset.category
            text = write_step(
                lines, action="replace", id=id, position=position, yaw=place.yaw, size=size, category=category
            )
        return Proposal(text, action, place, self.asset)

    def _ask(self, number: int, feedback: tuple[str, ...]) -> tuple[bool, tuple[str, ...]]:
        work = self.work
        plan = work.plan(self.target)
        observation = observe(
            self.empty,
            plan,
            self.target,
            self.asset,
            kinds=work.kinds(plan),
            sizes=None if self._is_sized else size_range(self.asset, work.source),
            round=number,
            feedback=feedback,
        )
        start = time.perf_counter()
        texts = answers(work.policy, observation, work.effort.candidates, work.rng)
        seconds = time.perf_counter() - start
        read = [t if isinstance(t, Try) else self._understood(t) for t in texts]
        done = self._try("policy", read, propose_seconds=seconds, tell=True, number=number)
        return done, tuple(t.feedback for t in work.rounds[-1].tries if t.feedback)

    @property
    def _is_sized(self) -> bool:
        """Whether its size is known, so that nobody may choose another: it is there, or a size was asked for."""
        return self.there or any(self.target.size)

    def _understood(self, text: object) -> Proposal | Try:
        found = understand(self.empty, self.target, text, asset=self.asset, source=self.work.source)
        if isinstance(found, Rejection):
            return rejected(text, found)
        if found.placement is None or found.asset is None:
            return rejected(text, Rejection(reason="action", message=f"{self.target.id} is to be placed"))
        if found.asset.id != self.asset.id and (self._is_sized or self.target.id in self.work.before):
            return rejected(text, Rejection(reason="size", message=f"{self.target.id} is there, and has its size"))
        action = self.action(found.placement.position, found.placement.yaw, found.asset)
        return Proposal(found.text, action, found.placement, found.asset)

    def _try(
        self,
        kind: RoundKind,
        read: Iterable[Proposal | Try],
        *,
        propose_seconds: float = 0.0,
        tell: bool = False,
        number: int = 0,
        most: int = 256,
    ) -> bool:
        """Measure what meets the goals, and commit the first that passes."""
        start = time.perf_counter()
        work = self.work
        tries: list[Try] = []
        chosen: int | None = None
        committed: tuple[Placement, ...] = ()
        measured = 0
        for item in read:
            if self.groups >= GROUPS:
                break
            if isinstance(item, Try):
                tries.append(item)
                continue
            missed = self._missed(item)
            if missed:
                self.missed.append(missed)
                if tell:
                    tries.append(rejected(item.text, Rejection(reason="action", message=missed)))
                continue
            verdict = self._measured(item)
            measured += 1
            tries.append(Try(text=item.text, placement=item.placement, verdict=verdict))
            if verdict.valid:
                grown, committed = commit(work.world, item, verdict)
                if not self._missed_in(grown.scene):
                    work.world, chosen = grown, len(tries) - 1
                    break
                committed = ()
            else:
                self.failed.append((item, verdict))
            if measured >= most:
                break
        if tries:
            told = [self._told(t) for t in tries] if tell and chosen is None else tries
            self._record(kind, told, chosen, committed, propose_seconds, time.perf_counter() - start, number)
        return chosen is not None

    def _missed(self, proposal: Proposal) -> str:
        return self._missed_in(self.work.scene.apply(proposal.action))

    def _missed_in(self, after: Scene) -> str:
        """Which goal a scene does not meet, with what was measured; empty where it meets all."""
        for goal in self.goals:
            holds, text = goal.check(self.work.before, after, self.target.id)
            if not holds:
                return f"{self.target.id} would not be as asked: {text}"
        return self._darkened(after) or self._unheld(after)

    def _unheld(self, after: Scene) -> str:
        """What it would be let into that takes no such thing, for a sink or hob; empty where all is well."""
        id = self.target.id
        if not facts_of(self.asset.category).is_in("built_in") or self.asset.mount != "surface":
            return ""
        on = after[id].support
        taken = on in after and facts_of(after[on].category).is_in("takes_built_in")
        if taken or (id in self.work.before and self.work.before[id].support == on):
            return ""
        self.barred = f"{id} is let into a worktop, which {'the floor' if on == 'floor' else on} has not"
        return self.barred

    def _darkened(self, after: Scene) -> str:
        """Which window it would hang on and did not before, where nobody said so; empty where there is none."""
        id = self.target.id
        kept = self.asset.mount != "wall" or facts_of(self.asset.category).hanging.windows != "no"
        if kept or any(_is_of_window(name) for goal in self.goals for name in getattr(goal, "anchors", ())):
            return ""
        old = covered_openings(self.work.before.room, self.work.before[id]) if id in self.work.before else ()
        new = [opening.id for opening in covered_openings(after.room, after[id]) if opening not in old]
        if new:
            self.barred = f"{id} would hang on {' and '.join(new)}"
        return self.barred if new else ""

    def _measured(self, proposal: Proposal) -> Verdict:
        action, world = proposal.action, self.work.world
        if self.there and proposal.placement is not None and self.work.scene.riders(self.target.id):
            alone = self.alone.check([proposal.placement], proposal.asset or self.asset)[0]
            if not alone.valid:
                return alone
            if (ruled_out := world.ruled_out(action)) is not None:
                return ruled_out
            self.groups += 1
        if isinstance(action, Add) or (isinstance(action, Move) and proposal.placement is not None):
            asset = proposal.asset or self.asset
            return world.check([world.scene.apply(action)[action.id]], asset)[0]
        return world.measure(action)

    def _told(self, tried: Try) -> Try:
        line = feedback_line(self.empty, self.target.id, tried, self.asset) if tried.verdict is not None else ""
        said = line or (tried.rejection.message if tried.rejection is not None else "")
        return structs.replace(tried, feedback=said)

    def _around(self) -> Iterator[Proposal]:
        """Poses around what came nearest, or where it is to be, or where it is."""
        best, _ = min(self.failed, key=_badness, default=(None, None))
        start = best.placement if best is not None else None
        if start is None and self.begin is not None:
            position, yaw = self.begin
            start = placed_at(self.empty, self.asset, id=self.target.id, position=position, yaw=yaw)
        if start is None and self.there:
            start = self.work.scene[self.target.id]
        if start is None:
            return
        near = ((pose.position, pose.yaw) for pose in nearest_poses(self.empty, self.asset, start))
        on_floor = self.asset.mount == "floor" and start.position[2] < ON_FLOOR
        far = whole_floor(self.empty, self.asset, start) if on_floor else iter(())
        for position, yaw in chain(islice(near, LOOKED_AT), islice(far, LOOKED_AT)):
            place = placed_at(self.empty, self.asset, id=self.target.id, position=position, yaw=yaw)
            missed = self._missed_in(self.empty.with_placement(place, self.asset))
            if missed:
                self.missed = self.missed or [missed]
                continue
            away = math.dist(position, start.position)
            yield self._proposal((position, yaw), f"{away:.2f} m from there it may be free.")

    def _record(
        self,
        kind: RoundKind,
        tries: Sequence[Try],
        chosen: int | None,
        committed: tuple[Placement, ...],
        propose_seconds: float,
        check_seconds: float,
        number: int,
    ) -> None:
        work = self.work
        work.assets[self.asset.id] = self.asset
        for placement in committed:
            work.assets[placement.asset] = work.scene.assets[placement.asset]
        work.rounds.append(
            Round(
                id=self.target.id,
                number=number,
                kind=kind,
                asset=self.asset.id,
                tries=tuple(tries),
                chosen=chosen,
                committed=committed,
                propose_seconds=round(propose_seconds, 4),
                check_seconds=round(check_seconds, 4),
            )
        )


def _is_of_window(name: str) -> bool:
    return name.startswith("window")


def ties_of(goals: Iterable[Goal]) -> tuple[Tie, ...]:
    """The goals as a policy is told them."""
    return tuple(tie for goal in goals if (tie := goal.tie) is not None)


def without(scene: Scene, ids: Iterable[str]) -> Scene:
    """A scene without some of its objects."""
    for id in ids:
        scene = scene.without(id)
    return scene


def _badness(failure: tuple[Proposal, Verdict]) -> float:
    v = failure[1]
    return len(v.reasons) + v.depth + v.outside + v.drift + v.drop + v.tilt / 90.0
