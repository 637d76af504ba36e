"""One judge for all: a policy's text becomes an action, and that a verdict. Loop, pool, rewards and edits use it."""

from collections.abc import Sequence
from itertools import islice
from typing import TYPE_CHECKING, NamedTuple
from zlib import crc32

from thinkblox.assets.showing import is_look, realised
from thinkblox.assets.sizing import scale_of
from thinkblox.assets.source import AssetSource, ProceduralAssets
from thinkblox.brief import Measures
from thinkblox.errors import InputError, UnavailableError
from thinkblox.plan import Target
from thinkblox.scene.actions import Action, Add, Move, Remove, Replace, Swap, Turn
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import placed_at
from thinkblox.steps import MAX_TEXT, Rejection, Step, parse
from thinkblox.value import Value, Vec3
from thinkblox.verdict import Verdict

if TYPE_CHECKING:
    import numpy as np

    from thinkblox.observe import Observation
    from thinkblox.policies import Policy
    from thinkblox.sim.verdict.world import World
    from thinkblox.sim.workers.pool import VerdictPool

LOOKS_TRIED = 8
"""Assets made at most for one that is not to look like others of its kind."""
SAME_SIZE = 0.002
"""Sizes nearer than this are the same [m]."""


class Try(Value, frozen=True, kw_only=True):
    """A policy's text and what became of it: rejected unread, or measured.

    Attributes:
        text: as the policy gave it; empty where it gave none.
        placement: where its action puts the object, by the asset's id; None where it takes it away, or was rejected.
        rejection: why it cannot be used.
        verdict: what was measured.
        feedback: what the policy is told of it, in a line; empty where it was not told.
    """

    text: str = ""
    placement: Placement | None = None
    rejection: Rejection | None = None
    verdict: Verdict | None = None
    feedback: str = ""

    @property
    def valid(self) -> bool:
        """Whether it was measured, and nothing speaks against it."""
        return self.verdict is not None and self.verdict.valid


class Proposal(NamedTuple):
    """A text that was understood: an action that the scene can take, and where it puts the object."""

    text: str
    action: Action
    placement: Placement | None
    asset: Asset | None


def judge(
    world: "World", target: Target, text: object, *, asset: Asset | None = None, source: AssetSource | None = None
) -> Try:
    """Read a policy's text, do what it says in a world, and measure that.

    Args:
        world: the scene so far.
        target: the object that the policy was asked about; an answer about another one is rejected.
        text: what it answered; anything but a string is rejected too.
        asset: what is to be placed, for an addition; made for the target when left out.
        source: gives other sizes, and what comes instead of something.
    """
    proposal = understand(world.scene, target, text, asset=asset, source=source)
    if isinstance(proposal, Rejection):
        return rejected(text, proposal)
    return measured(world, proposal)


def judge_all(
    pool: "VerdictPool",
    cases: Sequence[tuple[Scene, Target, Sequence[object]]],
    *,
    source: AssetSource | None = None,
) -> list[list[Try]]:
    """What `judge` gives for the texts of many cases, measured by the workers of a pool.

    Args:
        pool: where placements are measured; removals and swaps are measured in this process.
        cases: each a scene, the object that was asked about, and the texts that were answered.
        source: as for `judge`.
    """
    read = [[understand(scene, target, text, source=source) for text in texts] for scene, target, texts in cases]
    usable = [[found for found in row if not isinstance(found, Rejection)] for row in read]
    verdicts = measured_all(pool, [(case[0], row) for case, row in zip(cases, usable, strict=True)])
    return [
        tries_of(texts, found, measures) for (_, _, texts), found, measures in zip(cases, read, verdicts, strict=True)
    ]


def measured_all(pool: "VerdictPool", cases: Sequence[tuple[Scene, Sequence[Proposal]]]) -> list[list[Verdict]]:
    """The verdicts on the proposals of many scenes; removals and swaps are measured in this process."""
    from thinkblox.sim.verdict.world import World
    from thinkblox.sim.workers.pool import Job

    found: list[list[Verdict | None]] = [[None] * len(proposals) for _, proposals in cases]
    jobs, places = [], []
    for row, (scene, proposals) in enumerate(cases):
        for column, proposal in enumerate(proposals):
            if proposal.placement is None or proposal.asset is None or isinstance(proposal.action, Swap):
                found[row][column] = World(scene).measure(proposal.action)
            else:
                jobs.append(Job(scene, proposal.asset, [proposal.placement]))
                places.append((row, column))
    for (row, column), (verdict,) in zip(places, pool.check(jobs), strict=True):
        found[row][column] = verdict
    return [[verdict for verdict in row if verdict is not None] for row in found]


def tries_of(texts: Sequence[object], found: Sequence[Proposal | Rejection], verdicts: Sequence[Verdict]) -> list[Try]:
    """The tries of some texts, from what was understood of each and the verdicts on what could be used."""
    rest = iter(verdicts)
    return [
        rejected(text, each)
        if isinstance(each, Rejection)
        else Try(text=each.text, placement=each.placement, verdict=next(rest))
        for text, each in zip(texts, found, strict=True)
    ]


def understand(
    scene: Scene, target: Target, text: object, *, asset: Asset | None = None, source: AssetSource | None = None
) -> Proposal | Rejection:
    """Read a text and find out what it does to the scene, without measuring it; never raises, whatever the text."""
    if not isinstance(text, str):
        return Rejection(reason="format", message=f"the policy gave a {type(text).__name__}, not a text")
    step = parse(text)
    if isinstance(step, Rejection):
        return step
    if step.id != target.id:
        return Rejection(reason="id", message=f"answered for {step.id}; {target.id} was asked for")
    wrong = _impossible(scene, step)
    if wrong:
        return Rejection(reason="action", message=wrong)
    source = source or ProceduralAssets()
    try:
        action = _action(scene, target, step, asset, source)
        after = scene.apply(action)
    except _SizeError as error:
        return Rejection(reason="size", message=str(error))
    except InputError as error:
        return Rejection(reason="action", message=str(error))
    if step.action == "remove":
        return Proposal(text, action, None, None)
    placement = after[step.id]
    return Proposal(text, action, placement, after.asset_of(placement))


def proposed(scene: Scene, asset: Asset, text: str, *, id: str, position: Vec3, yaw: float) -> Proposal:
    """The proposal to add an object at a known pose, with the text that says it."""
    placement = placed_at(scene, asset, id=id, position=position, yaw=yaw)
    return Proposal(text, Add(id=id, asset=asset, position=placement.position, yaw=placement.yaw), placement, asset)


def measured(world: "World", proposal: Proposal) -> Try:
    """Measure what was understood."""
    return Try(text=proposal.text, placement=proposal.placement, verdict=world.measure(proposal.action))


def rejected(text: object, why: Rejection) -> Try:
    """The try of what cannot be used; of a longer text than is read, as much as would be."""
    said = text[:MAX_TEXT] if isinstance(text, str) else ""
    return Try(text=said.encode("utf-8", "replace").decode(), rejection=why)


def answers(policy: "Policy", observation: "Observation", most: int, rng: "np.random.Generator") -> list[object]:
    """What a policy answers; where it fails, what came before that, and a try that says so.

    Args:
        policy: who proposes.
        observation: what it is shown.
        most: how many answers are taken.
        rng: its random choices follow from it.

    Raises:
        UnavailableError: the policy cannot go on, for this or any other object.
    """
    texts: list[object] = []
    try:
        given = policy.propose(observation, most, rng)
        if isinstance(given, str | bytes):
            raise TypeError(f"it gave one {type(given).__name__}; a list of texts is wanted")
        texts.extend(islice(given, most))
    except UnavailableError:
        raise
    except Exception as error:  # a policy is anybody's code, and the rest of the room can do without it
        texts.append(policy_failed(error))
    return texts


def policy_failed(error: Exception) -> Try:
    """The try of a policy that failed instead of answering."""
    why = " ".join(f"the policy failed: {type(error).__name__}: {error}".split())[:500]
    return rejected("", Rejection(reason="policy", message=why.encode("utf-8", "replace").decode()))


def asset_for(target: Target, scene: Scene, source: AssetSource | None = None) -> Asset:
    """The asset for a target; one seed for a whole scene, so that its furniture is of one style.

    What no two of are the same, as pictures, has a seed for each, and the size of the first. What others of its kind
    are told apart by, as the one that is of oak, it is not by chance.

    Raises:
        InputError: the source cannot make such a thing.
    """
    source = source or ProceduralAssets()
    asset = source.make(target.category, seed=style_seed(scene), attributes=target.attributes)
    if _is_another(target) and source.facts(target.category).is_in("unlike"):
        own = crc32(f"{scene.seed}/{scene.prompt}/{target.id}".encode())
        asset = source.make(target.category, seed=own, attributes=target.attributes, size=asset.size)
    if others := _looks_of_others(target, scene):
        asset = _told_apart(asset, others, target, scene, source)
    return _sized(asset.called(target.called) if target.called else asset, target.size, source, slack=0.0)


def _looks_of_others(target: Target, scene: Scene) -> set[str]:
    """What others of its kind that stand already were asked to be of, colours and materials, and it was not."""
    alike = (p for p in scene.placements if p.category == target.category)
    words = {word for p in alike for word in scene.asset_of(p).attributes if is_look(word)}
    return words - set(target.attributes)


def _told_apart(asset: Asset, others: set[str], target: Target, scene: Scene, source: AssetSource) -> Asset:
    """The asset, or the first of some others of its size that looks like none of `others`, where there is one."""
    seeds = range(style_seed(scene), style_seed(scene) + LOOKS_TRIED)
    made = (source.make(target.category, seed=s, attributes=target.attributes, size=asset.size) for s in seeds)
    apart = (one for one in (asset, *made) if not any(realised(one, word) for word in others))
    return next(apart, asset)


def _is_another(target: Target) -> bool:
    """Whether there are others of its kind before it, by its number."""
    number = target.id.rpartition("_")[2]
    return number.isdigit() and int(number) > 1


def size_range(asset: Asset, source: AssetSource) -> tuple[Vec3, Vec3] | None:
    """The least and greatest extents that an asset may be given [m]; None where there is one size.

    They are those of its category; what is called large or small keeps at least half of what the word makes of it.
    """
    least, most = source.size_range(asset.category)
    if least == most:
        return None
    axes = zip(scale_of(asset.attributes), source.usual(asset.category)[0], least, most, strict=True)
    lows, highs = zip(*(_as_called(*axis) for axis in axes), strict=True)
    return (lows[0], lows[1], lows[2]), (highs[0], highs[1], highs[2])


def _as_called(scale: float, usual: float, low: float, high: float) -> tuple[float, float]:
    halfway = usual * (1.0 + scale) / 2.0
    if scale > 1.0:
        return min(max(low, halfway), high), high
    return low, max(min(high, halfway), low) if scale < 1.0 else high


def style_seed(scene: Scene) -> int:
    """The seed of what is made for a scene."""
    return crc32(f"{scene.seed}/{scene.prompt}".encode())


def _sized(asset: Asset, wanted: Measures, source: AssetSource, *, slack: float = SAME_SIZE) -> Asset:
    x, y, z = (want or usual for want, usual in zip(wanted, asset.size, strict=True))
    same = all(abs(a - b) <= slack for a, b in zip((x, y, z), asset.size, strict=True))
    try:
        return asset if same else source.fit(asset, (x, y, z))
    except InputError as error:
        raise _SizeError(str(error)) from error


class _SizeError(InputError):
    """An asset cannot have the size that is wanted."""


def _impossible(scene: Scene, step: Step) -> str:
    """Why an action cannot be done to a scene; empty where it can."""
    ids = ", ".join(p.id for p in scene.placements) or "nothing"
    if step.action == "add" and step.id in scene:
        return f"{step.id} stands already; move, turn, replace or remove it"
    if step.action != "add" and step.id not in scene:
        return f"cannot {step.action} {step.id}: it is not in the room; there are {ids}"
    if step.other is not None and step.other not in scene:
        return f"cannot swap {step.id} with {step.other}: it is not in the room; there are {ids}"
    return ""


def _action(scene: Scene, target: Target, step: Step, asset: Asset | None, source: AssetSource) -> Action:
    id, position, yaw = step.id, step.position, step.yaw
    match step.action:
        case "move" if position is not None:
            return Move(id=id, position=position, yaw=yaw)
        case "turn" if yaw is not None:
            return Turn(id=id, yaw=yaw)
        case "remove":
            return Remove(id=id)
        case "swap" if step.other is not None:
            return Swap(id=id, other=step.other)
        case "replace":
            old = scene.asset_of(scene[id])
            new = source.make(step.category or old.category, seed=style_seed(scene), attributes=step.attributes)
            return Replace(
                id=id, asset=_sized(new, step.size or (None, None, None), source), position=position, yaw=yaw
            )
    if position is None or yaw is None:
        raise InputError(f"{step.action} {id}: the answer says no position or no yaw")
    made = _sized(asset or asset_for(target, scene, source), step.size or (None, None, None), source)
    return Add(id=id, asset=made, position=position, yaw=yaw)
