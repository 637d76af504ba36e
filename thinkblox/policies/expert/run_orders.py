"""In which order what is built in one line stands: as one cooks, with worktop beside hob and sink."""

from collections import Counter
from collections.abc import Sequence
from functools import lru_cache
from itertools import islice, pairwise, permutations
from typing import NamedTuple

from thinkblox.value import Vec3

TALL = 1.2
"""What is higher than this stands at an end of the run [m]."""
HOT_BY_WET, NO_WORKTOP, APPLIANCES, PARTED = 3.0, 1.0, 0.5, 8.0
"""Costs of a hob beside a sink, of one with no worktop at a side, of two appliances side by side, and of parting two
that are asked to be side by side."""
WASHED_UP = 0.1
"""What it is worth that a dishwasher is beside the sink."""
HOT_IN_CORNER, HOT_BY_COLD, AT_END = 0.4, 0.5, 0.3
"""Costs of a hob right beside a corner, of one that is nearer to what is tall than the sink is, and of an appliance at
an end of the run."""
ORDERS = 12
"""Ways to line up a run that are tried, each from either end."""
MOST_TRIED = 8000
"""Orders of a run that are compared."""


class RunMember(NamedTuple):
    """One thing of a run.

    Attributes:
        size: along its front axis, across and up [m].
        cabinet: whether it has a worktop.
        walls: the numbers of the walls that it may stand against.
        window: whether it, or what is built into it, is to be by a window.
        hot: whether one cooks on it; no window is above that, and no water beside.
        wet: whether a sink is built into it.
        beside: those that it is asked to stand beside.
        left_of: those of them to whose left it is asked to be.
        right_of: the same for their right.
        corner: whether it fills a corner that the run goes round.
        open: whether its width follows from the wall.
    """

    id: str
    size: Vec3
    cabinet: bool
    walls: frozenset[int]
    window: bool
    hot: bool = False
    wet: bool = False
    beside: frozenset[str] = frozenset()
    left_of: frozenset[str] = frozenset()
    right_of: frozenset[str] = frozenset()
    corner: bool = False
    open: bool = False

    @property
    def is_free(self) -> bool:
        """Whether its top is there to work on."""
        return self.cabinet and not (self.hot or self.wet)

    @property
    def is_machine(self) -> bool:
        """Whether it is an appliance that nobody cooks on."""
        return not (self.cabinet or self.hot)

    @property
    def is_tall(self) -> bool:
        """Whether it stands at an end."""
        return self.size[2] > TALL


Line = list[RunMember]


def orders(low: Line, tall: Line) -> list[tuple[Line, float]]:
    """The best ways to line up what is low, seen from either end, with what each costs; some stay in turn.

    What is asked to be beside what is tall stands at an end.
    """
    named = {id for member in tall for id in member.beside}
    last = frozenset(m.id for m in low if m.id in named or any(member.id in m.beside for member in tall))
    return [([*line], cost) for line, cost in _orders(tuple(low), last)]


@lru_cache(maxsize=64)
def _orders(members: tuple[RunMember, ...], last: frozenset[str]) -> tuple[tuple[Line, float], ...]:
    """The same, with some at an end; every thing of a run asks for it again."""
    low = list(members)
    plain = _in_turn(low)
    special = [m for m in low if m not in plain]
    found: list[tuple[float, Line]] = []
    for places in islice(permutations(range(len(low)), len(special)), MOST_TRIED):
        at = dict(zip(places, special, strict=True))
        rest = iter(plain)
        line = [at[n] if n in at else next(rest) for n in range(len(low))]
        found.append((order_cost(line) + PARTED * sum(m.id in last for m in line[1:-1]), line))
    found.sort(key=lambda pair: pair[0])
    least = found[0][0] if found else 0.0
    best = found[:ORDERS] or [(0.0, [])]
    return tuple(
        (order, cost - least) for cost, line in best for order in ((line, line[::-1]) if len(line) > 1 else (line,))
    )


def _in_turn(low: Line) -> Line:
    """What need not change places: plain cabinets, or where there are none the most that are alike."""
    loose = [m for m in low if not (m.beside or m.window)]
    plain = [m for m in loose if m.is_free]
    alike = Counter(m._replace(id="") for m in loose).most_common(1)
    return plain or [m for m in loose if alike and m._replace(id="") == alike[0][0]]


def order_cost(line: Line) -> float:
    """What is wrong with a line: a hob by the sink or without worktop, appliances in a heap, a dishwasher far off.

    Where nobody cooks, machines stand together: a washing machine and a dryer.
    """
    cost, cooks = 0.0, any(member.hot for member in line)
    for one, other in pairwise(line):
        cost += HOT_BY_WET * ((one.hot and other.wet) or (one.wet and other.hot))
        cost += APPLIANCES * ((not one.cabinet and not other.cabinet) if cooks else one.cabinet != other.cabinet)
        cost -= WASHED_UP * (
            (one.wet and not (other.cabinet or other.hot)) or (other.wet and not (one.cabinet or one.hot))
        )
        cost += HOT_IN_CORNER * ((one.hot and other.corner) or (one.corner and other.hot))
    for n, member in enumerate(line):
        near = [line[k] for k in (n - 1, n + 1) if 0 <= k < len(line)]
        cost += NO_WORKTOP * member.hot * (2 - sum(m.is_free for m in near))
        cost += NO_WORKTOP / 2 * member.wet * (not any(m.is_free for m in near))
        cost += AT_END * (cooks and len(near) < 2 and not member.cabinet and not member.is_tall)
        beside = {m.id for m in near}
        cost += PARTED * len((member.beside & {m.id for m in line}) - beside)
    return cost


def ways_cost(line: Line) -> float:
    """What it costs that one carries from the fridge past the hob to the sink: they follow as one works."""
    at = {name: [n for n, m in enumerate(line) if getattr(m, name)] for name in ("is_tall", "wet", "hot")}
    if not all(at.values()):
        return 0.0
    cold = at["is_tall"][0]
    return HOT_BY_COLD * (min(abs(n - cold) for n in at["hot"]) < min(abs(n - cold) for n in at["wet"]))


def neighbours_cost(line: Line) -> float:
    """What it costs that something tall is not beside what it is asked to be, and that any is on its wrong side."""
    at = {member.id: n for n, member in enumerate(line)}
    pairs = {frozenset((m.id, other)) for m in line for other in m.beside if other in at and other != m.id}
    tall = ([at[id] for id in pair] for pair in pairs if any(line[at[id]].is_tall for id in pair))
    parted = sum(max(places) - min(places) > 1 for places in tall)
    wrong = sum(at[other] < n for n, m in enumerate(line) for other in m.left_of if other in at)
    wrong += sum(at[other] > n for n, m in enumerate(line) for other in m.right_of if other in at)
    return PARTED * (parted + wrong)


def ends(tall: Line) -> list[tuple[Line, Line]]:
    """Ways to share what is tall between the beginning and the end."""
    return [([], tall), (tall, [])] if tall else [([], [])]


def with_corners(parts: Sequence[Line], corners: Line) -> Line:
    """The parts of a run in one line, with what fills the corners between them."""
    line = list(parts[0])
    for part, corner in zip(parts[1:], corners, strict=False):
        line += [corner, *part]
    return line
