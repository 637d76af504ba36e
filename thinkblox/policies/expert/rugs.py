"""Ideas for rugs: under the group they belong to, parallel to it, no larger than the floor allows."""

from collections.abc import Iterator, Sequence

from thinkblox.assets import facts_of
from thinkblox.phrases import Constraint
from thinkblox.policies.expert.idea import Idea
from thinkblox.policies.expert.situation import Situation
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import turn_between
from thinkblox.scene.saying import turned
from thinkblox.value import Vec2, Vec3

SEATED, DRAWN_BACK = ("around", "at_long_side", "at_short_side"), 0.65
"""Relations of seats to a table, and how far a rug reaches past it for them [m]."""
IN_LINE, PAIRED = 0.3, 1.2
"""Beds so nearly in one line, with no more floor between them than this, are a pair [m]."""
PAST_MIDDLE = 0.2
"""How far a rug reaches past the middles of several that are all on it [m]."""
BEYOND_BED = 0.6
"""How far a rug reaches past the sides and the foot of a bed [m]."""


def under(situation: Situation, anchor: Placement) -> Iterator[Idea]:
    """Centred under the anchor; under a bed it lies towards the foot, and on the axis of two that stand together."""
    bed = facts_of(anchor.category).is_in("foot_rugs")
    middle = _aside_of_pair(situation, anchor) if bed else 0.0
    for rank, size in enumerate(_sizes(situation, anchor)):
        shift = 0.25 * anchor.size[0] if bed else 0.0
        for turn in (0.0, 90.0):
            reach = size[0] if turn == 0.0 else size[1]
            locals_: tuple[Vec2, ...] = ((shift, 0.0), (0.0, 0.0))
            if bed:
                locals_ = ((anchor.size[0] / 2 + BEYOND_BED - reach / 2, 0.0), *locals_)
            if middle:
                locals_ = (*((along, middle) for along, _ in locals_), *locals_)
            for step, local in enumerate(dict.fromkeys(locals_)):
                yield _lie(situation, anchor, local, turn, size, 0.3 * rank + 0.2 * step + _along(anchor, size, turn))


def under_all(situation: Situation, anchor: Placement, others: Sequence[Placement]) -> Iterator[Idea]:
    """In the middle of several, so large that more than half of each is on it, where it can be made so."""
    if not others[1:]:
        return
    spots = [anchor.to_local(other.position[:2]) for other in others]
    (x0, y0), (x1, y1) = (tuple(pick(spot[axis] for spot in spots) for axis in (0, 1)) for pick in (min, max))
    sizes = situation.observation.sizes
    most = sizes[1] if sizes is not None else situation.size
    needed = (x1 - x0 + 2 * PAST_MIDDLE, y1 - y0 + 2 * PAST_MIDDLE)
    for turn, (deep, wide) in ((0.0, needed), (90.0, needed[::-1])):
        depth, width = min(max(situation.size[0], deep), most[0]), min(max(situation.size[1], wide), most[1])
        if situation.size[0] == situation.size[1]:
            depth = width = max(depth, width)  # A round one stays round.
        size = (depth, width, situation.size[2])
        yield _lie(situation, anchor, ((x0 + x1) / 2, (y0 + y1) / 2), turn, size, 0.0)


def _aside_of_pair(situation: Situation, bed: Placement) -> float:
    """How far to the left of a bed the middle between it and the one beside it is [m]; 0 where it stands alone."""
    for other in situation.alike(bed.id):
        along, aside = bed.to_local(other.position[:2])
        beside = abs(along) < IN_LINE and abs(aside) - bed.size[1] < PAIRED
        if other.id != bed.id and beside and turn_between(other.yaw, bed.yaw) < 1.0:
            return aside / 2
    return 0.0


def _along(anchor: Placement, size: Vec3, turn: float) -> float:
    """The long side of a rug lies across a bed, and along everything else that is long."""
    depth, width = (size[0], size[1]) if turn == 0.0 else (size[1], size[0])
    if abs(depth - width) < 0.1:
        return 0.0
    wide = facts_of(anchor.category).is_in("foot_rugs") or anchor.size[1] >= anchor.size[0]
    return 0.0 if (width > depth) == wide else 0.5


def _sizes(situation: Situation, anchor: Placement) -> tuple[Vec3, ...]:
    size = situation.size
    if seated := _under_seats(situation, anchor):
        return (seated, size)
    larger = (size[0] * 1.25, size[1] * 1.25, size[2])
    smaller = (size[0] * 0.8, size[1] * 0.8, size[2])
    covers = max(size[0], size[1]) >= max(anchor.size[0], anchor.size[1]) + 0.3
    return (size, smaller) if covers else (larger, size, smaller)


def _under_seats(situation: Situation, table: Placement) -> Vec3 | None:
    """So large that the chairs about a table stay on it when they are drawn back; None where nobody sits there."""
    targets, sizes = situation.observation.plan.targets, situation.observation.sizes
    around = any(tie.kind in SEATED and table.id in tie.anchors for t in targets for tie in t.ties)
    if not around or sizes is None or any(situation.target.size) or situation.asset.front == "any":
        return None
    short, long = sorted(side + 2 * DRAWN_BACK for side in table.size[:2])
    wanted = (short, long) if situation.size[0] <= situation.size[1] else (long, short)
    fits = (min(max(want, low), high) for want, low, high in zip(wanted, sizes[0], sizes[1], strict=False))
    depth, width = fits
    return (depth, width, situation.size[2])


def _lie(situation: Situation, anchor: Placement, local: Vec2, turn: float, size: Vec3, cost: float) -> Idea:
    x, y = anchor.to_room(local)
    yaw = (anchor.yaw + turn) % 360.0
    words = (
        Constraint(kind="under", anchors=(anchor.id,)),
        Constraint(kind="offset", anchors=(anchor.id,), values=(round(local[0], 3), round(local[1], 3))),
        turned(yaw),
    )
    rounded = (round(size[0], 3), round(size[1], 3), size[2])
    return Idea((x, y, 0.0), yaw, words, f"{anchor.id} stands on it", cost, size=rounded)
