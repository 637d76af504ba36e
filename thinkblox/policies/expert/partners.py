"""Two things with a third between them: the second leaves just the room beside the first that the third needs."""

from collections.abc import Iterator
from itertools import pairwise

from thinkblox.phrases import Constraint
from thinkblox.plan import Target, is_object
from thinkblox.policies.expert.beside import beside_at, sides_of
from thinkblox.policies.expert.idea import Idea
from thinkblox.policies.expert.needs import Need
from thinkblox.policies.expert.situation import Situation, is_seat
from thinkblox.scene.placement import Placement
from thinkblox.value import Vec3

AIRS = (0.08, 0.15, 0.25)
"""Left on either side of what comes between, the best first [m]."""
ROOMY = 0.42
"""Left on either side of what comes between a seat and what it looks at: it is next to both, knees have room [m]."""
PARTED, IN_LINE = 12.0, 4.0
"""Cost per metre that is missing beside the first of a pair, as the second stands across the room then; in a run."""


def partner_ideas(situation: Situation, *, built: bool = False) -> Iterator[Idea]:
    """Beside a placed partner, or before it where the two look at each other, with room for what comes between.

    Where the target is `built` in one line, what is of that has its place there.
    """
    for later, partner in _shared(situation):
        if built and situation.in_run(later):
            continue
        size = situation.kind(later).size
        looking = partner.id in _looked_at(situation.target)
        if looking or situation.target.id in _looked_at_by(situation, partner):
            if not _comes_between(later):
                continue  # What is beside both of two that look at each other is at their ends.
            yield from _before(situation, partner, max(size[:2]), later)
        else:
            gaps = tuple(round(size[1] + 2 * air, 3) for air in AIRS)
            why = f"{later.id} comes between it and {partner.id}"
            yield from sides_of(situation, partner, ("left", "right"), gaps=gaps, why=why)


def parted_on(situation: Situation, carrier: Placement) -> Iterator[tuple[float, Placement]]:
    """How wide that is which comes between the target and another thing on its carrier, and that thing [m]."""
    own = situation.target.id
    for later in situation.followers:
        sharers = _sharers(later)
        if _comes_between(later) and own in sharers:
            for other in situation.scene.resting_on(carrier.id):
                if other.id in sharers and other.id != own:
                    yield situation.kind(later).size[1], other


def between_on(situation: Situation, carrier: Placement) -> tuple[Placement, Placement] | None:
    """The two things on a carrier between which the target is to be; None where it is between no such two."""
    if not _comes_between(situation.target):
        return None
    found = [p for p in situation.scene.resting_on(carrier.id) if p.id in _sharers(situation.target)]
    return (found[0], found[1]) if len(found) == 2 else None


def gaps_in_row(situation: Situation) -> tuple[float, ...]:
    """Free distances that neighbours in a row leave for what is to come between them [m]; none where nothing does."""
    alike = {t.id for t in situation.observation.plan.targets if t.request == situation.target.request}
    between = (t for t in situation.observation.plan.targets if alike.issuperset(_sharers(t)) and _sharers(t))
    width = max((situation.kind(t).size[1] for t in between if _takes_floor(situation, t)), default=0.0)
    return tuple(round(width + 2 * air, 3) for air in AIRS) if width else ()


def shared_gaps(situation: Situation) -> frozenset[int]:
    """After which members of a request something comes between them and the next."""
    alike = [t.id for t in situation.observation.plan.targets if t.request == situation.target.request]
    pairs = {frozenset(_sharers(t)) for t in situation.observation.plan.targets if _takes_floor(situation, t)}
    return frozenset(n for n, pair in enumerate(pairwise(alike)) if frozenset(pair) in pairs)


def beside_each(situation: Situation) -> float:
    """Free distance that neighbours in a row need for what stands next to each of them alone [m]; 0 for nothing."""
    alike = {t.id for t in situation.observation.plan.targets if t.request == situation.target.request}
    widths: dict[str, float] = {}
    for later in situation.observation.plan.targets:
        by = {a for tie in later.ties if tie.kind == "next_to" and tie.asked for a in tie.anchors if a in alike}
        by -= {a for tie in later.ties if tie.kind == "at" for a in tie.anchors}
        if len(by) == 1 and situation.kind(later).mount == "floor":
            (own,) = by
            widths[own] = widths.get(own, 0.0) + situation.kind(later).size[1] + AIRS[0]
    return round(max(widths.values()) + AIRS[0], 3) if widths else 0.0


def room_between(situation: Situation, other: str) -> float:
    """Free distance at which what was asked to come between the target and another stands next to both [m]; or 0.

    Where the other lies on something, that may be what it comes between.
    """
    pair = {situation.target.id, other}
    for later in situation.observation.plan.targets:
        asked = any(tie.kind == "between" and tie.asked and pair == set(tie.anchors) for tie in later.ties)
        if asked and _takes_floor(situation, later):
            return round(min(situation.kind(later).size[:2]) + 2 * ROOMY, 3)
    return 0.0


def _takes_floor(situation: Situation, target: Target) -> bool:
    return situation.kind(target).mount in ("floor", "surface")


def pair_need(situation: Situation, follower: Target, size: Vec3) -> Need | None:
    """Floor beside the first of a pair: for what comes between them, and the second; None where there is no second."""
    own, weight = situation.target, IN_LINE if situation.facts.is_in("built_in_line") else PARTED
    for other in situation.observation.plan.targets:
        if other.id == own.id or other.id in situation.scene or other.id not in _sharers(follower):
            continue
        if not _makes_pair(situation, own, other.id):
            return None
        if own.id in _looked_at(other) or other.id in _looked_at(own):
            if not _comes_between(follower):
                return None
            return Need(("front",), max(size[:2]) + 2 * AIRS[1] + situation.kind(other).size[0], None, 1, weight)
        return Need(("left", "right"), size[1] + 2 * AIRS[0] + situation.kind(other).size[1], None, 1, weight)
    return None


def _shared(situation: Situation) -> Iterator[tuple[Target, Placement]]:
    """Things on the floor that are to come between the target and something that stands, with what that is."""
    own = situation.target.id
    for later in situation.followers:
        sharers = _sharers(later)
        if not _takes_floor(situation, later) or own not in sharers:
            continue
        for other in situation.placed(sharers):
            if other.id != own and other.position[2] < 0.1 and _makes_pair(situation, situation.target, other.id):
                yield later, other


def _makes_pair(situation: Situation, one: Target, other: str) -> bool:
    """Whether two things stand by each other; a seat that looks at something, and that, keep their distance."""
    target = next((t for t in situation.observation.plan.targets if t.id == other), None)
    if target is None:
        return False
    return is_seat(one.category) == is_seat(target.category) or not (_looked_at(one) or _looked_at(target))


def _sharers(target: Target) -> tuple[str, ...]:
    """The two things that a third is between, or next to both of; none where it is not so."""
    between = next((tie.anchors for tie in target.ties if tie.kind == "between" and len(tie.anchors) == 2), ())
    if between:
        return between
    beside = tuple(tie.anchors[0] for tie in target.ties if tie.kind == "next_to" and len(tie.anchors) == 1)
    objects = tuple(anchor for anchor in beside if is_object(anchor))
    return objects if len(objects) == 2 else ()


def _comes_between(target: Target) -> bool:
    return any(tie.kind == "between" for tie in target.ties)


def _looked_at(target: Target) -> tuple[str, ...]:
    return tuple(a for tie in target.ties if tie.kind in ("facing", "opposite") for a in tie.anchors)


def _looked_at_by(situation: Situation, partner: Placement) -> tuple[str, ...]:
    return next((_looked_at(t) for t in situation.observation.plan.targets if t.id == partner.id), ())


def _before(situation: Situation, partner: Placement, width: float, later: Target) -> Iterator[Idea]:
    for rank, air in enumerate(AIRS):
        gap = round(width + 2 * air, 3)
        local = (partner.size[0] / 2 + gap + situation.size[0] / 2, 0.0)
        words = (Constraint(kind="beside", anchors=(partner.id,), side="front", values=(gap,)),)
        why = f"it looks at {partner.id}, with {later.id} between them"
        yield beside_at(situation, partner, local, yaw=partner.yaw + 180.0, words=words, why=why, cost=0.15 * rank)
