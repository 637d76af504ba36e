"""What lies on, in and over what, by heights and outlines."""

from shapely import union_all

from thinkblox.evaluation.bodies import Body, share_within, shared
from thinkblox.evaluation.matching import names_of
from thinkblox.evaluation.ruling import Ruling
from thinkblox.evaluation.vocabulary import Vocabulary

SINKS, RISES = 0.06, 0.04
"""By how much a base may lie below and above the top of the part that carries it: cushions give, seats slope [m]."""
HEADROOM = 0.6
"""What lies lower than this under a part of its carrier is in the carrier, as on a shelf, and not on top [m]."""
CAUGHT = 0.02
"""How far below the rim of a container the base of something in it lies at least [m]."""
BEFORE = 0.3
"""How far before a wall thing something may stand that is under it: a sofa does not touch the wall [m]."""
OVERLAP = 0.05
"""By how much the upper of two things may reach below the top of the lower one [m]."""
MAJORITY = 0.5
SHELVES = ("shelf", "rack")
"""What holds things on its topmost board as well as within."""
CLOSED = "bookcase"
"""What is a shelf too, and has a top that is no board of it."""


def carries(carrier: Body, load: Body) -> bool:
    """Whether the base of one object lies on a part of another."""
    tops = [p.outline for p in carrier.parts if load.low - RISES <= p.high <= load.low + SINKS]
    return bool(tops) and union_all(tops).intersection(load.footprint).area > 0.1 * min(
        load.footprint.area, carrier.footprint.area
    )


def lies_on_or_board(load: Body, carrier: Body, vocabulary: Vocabulary) -> Ruling:
    """Whether something lies on top of something else or, of a shelf or rack, on any of its boards."""
    found = lies_on(load, carrier)
    boards = not found.holds and _is_shelf(carrier, vocabulary) and shared(load.footprint, carrier.footprint) > MAJORITY
    return Ruling(True, "on a board of it") if boards and carries(carrier, load) else found


def lies_on(load: Body, carrier: Body) -> Ruling:
    """Whether something lies on top of something else, and not in a compartment of it."""
    over = shared(load.footprint, carrier.footprint)
    if over <= MAJORITY:
        return Ruling(False, f"{over:.0%} over it".replace("%", " %"))
    if not carries(carrier, load):
        return Ruling(False, f"its base {load.low:.2f} m up is on no part of it")
    return Ruling(not _roofed(load, carrier), "on it, under another part of it" if _roofed(load, carrier) else "on it")


def _roofed(load: Body, carrier: Body) -> bool:
    """Whether a part of the carrier hangs low over most of the load."""
    roofs = [p.outline for p in carrier.parts if load.low + CAUGHT < p.low < load.low + HEADROOM]
    return bool(roofs) and share_within(load.footprint, union_all(roofs)) > MAJORITY


def is_in(thing: Body, container: Body, vocabulary: Vocabulary) -> Ruling:
    """Whether most of something is in the box round a container, or it stands in it and sticks out.

    Of a shelf, also what stands on its topmost board.
    """
    aside = share_within(thing.footprint, container.footprint)
    tall = max(thing.high - thing.low, 1e-6)
    inside = aside * max(0.0, min(thing.high, container.high) - max(thing.low, container.low)) / tall
    stands_in = aside > 0.8 and container.low - CAUGHT <= thing.low < container.high - CAUGHT
    on_shelf = _is_shelf(container, vocabulary) and aside > MAJORITY and carries(container, thing)
    return Ruling(inside > MAJORITY or stands_in or on_shelf, f"{inside:.0%} of it within".replace("%", " %"))


def _is_shelf(container: Body, vocabulary: Vocabulary) -> bool:
    names = names_of(container.asset.category, container.asset.description)
    open_ones = any(vocabulary.steps(name, shelf) is not None for name in names for shelf in SHELVES)
    return open_ones and all(vocabulary.steps(name, CLOSED) is None for name in names)


def is_over(upper: Body, lower: Body) -> Ruling:
    """Whether something hangs or stands over something else, as a picture over a sofa or a loft bed over a desk."""
    straight = shared(upper.footprint, lower.footprint)
    gap = float(upper.footprint.distance(lower.footprint))
    along = max(_along(upper, lower), _along(lower, upper))
    below = _clears(upper, lower)
    height = "higher" if below else "not higher"
    says = f"{height}, {straight * 100:.0f} % straight over it, {gap:.2f} m aside"
    return Ruling(below and (straight > MAJORITY or (gap <= BEFORE and along > MAJORITY)), says)


def _clears(upper: Body, lower: Body) -> bool:
    if upper.low >= lower.high - OVERLAP or (upper.middle > lower.high and upper.low > lower.middle):
        return True
    roofs = [p.outline for p in upper.parts if p.low >= lower.high - OVERLAP]
    return bool(roofs) and share_within(lower.footprint, union_all(roofs)) > MAJORITY


def _along(a: Body, b: Body) -> float:
    """How much of the narrower of two objects the other covers, measured across the first one's front."""
    _, low, _, high = a.to_own(b.footprint).bounds
    both = min(high, a.half[1]) - max(low, -a.half[1])
    narrower = min(high - low, 2 * a.half[1])
    return max(0.0, both) / narrower if narrower > 0 else 0.0
