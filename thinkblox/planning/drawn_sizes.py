"""How large the furniture of a room is that a prompt gives no size: it follows the seed, alike things are alike."""

from zlib import crc32

import numpy as np
from msgspec.structs import replace

from thinkblox.assets import kind_of
from thinkblox.assets.category import Category
from thinkblox.assets.sizing import size_for
from thinkblox.brief import Brief, Measures, Request
from thinkblox.planning.rooms import is_open
from thinkblox.planning.tightness import is_tight

_Range = tuple[float, float]
_USUAL: tuple[_Range, _Range, _Range] = ((0.83, 1.2), (0.75, 1.32), (0.89, 1.14))
"""Times the ordinary depth, width and height of furniture."""
_SEAT: tuple[_Range, _Range, _Range] = ((0.88, 1.16), (0.86, 1.18), (0.91, 1.11))
"""Of what one person sits on: bodies differ less than rooms."""
_BED: tuple[_Range, _Range, _Range] = ((0.98, 1.03), (0.93, 1.2), (0.88, 1.15))
"""Of beds, whose mattresses are made in a few lengths."""
_TABLE: tuple[_Range, _Range, _Range] = ((0.84, 1.24), (0.82, 1.4), (0.96, 1.05))
"""Of tables and desks, at which people sit upright."""
_CARRIED = ("inside", "on", "under")
"""Relations to what is not to come out small: it must hold what is named."""
_ONE = 0.75
"""What is narrower than this is a seat for one [m]."""
_SAID = 0.35
"""How much of that is left where words say how large it is ("a king bed", "a table for six")."""
_CLOSE = 0.25
"""How much larger than usual things may be in a room of a given size, as a share of what they may be elsewhere."""
_CARRYING = 0.9
"""Times its ordinary size of what is to hold something in a room that is tight for all that it is to have."""
_SALT = 3_000_017


def with_sizes(brief: Brief, seed: int) -> Brief:
    """The brief with sizes for the furniture that it gives none; the same seed gives the same."""
    close, tight = not is_open(brief), is_tight(brief)
    carriers = {anchor for r in brief.relations if r.kind in _CARRIED and not r.negated for anchor in r.anchors}
    requests = (
        replace(r, drawn=_drawn(r, seed, close=close, tight=tight, carries=r.key in carriers)) for r in brief.requests
    )
    return replace(brief, requests=tuple(requests))


def _drawn(request: Request, seed: int, *, close: bool, tight: bool, carries: bool) -> Measures:
    kind = kind_of(request.category)
    if kind.mount != "floor" or kind.flat or not kind.variation or any(request.size) or kind.is_in("built_in_line"):
        return request.drawn
    rng = np.random.default_rng((seed, _SALT, crc32(request.category.encode())))
    shares = rng.uniform(size=3) * (not tight)
    words = frozenset(word.lower() for word in request.attributes)
    told = not words.isdisjoint(kind.variants) or any(not word.isalpha() for word in words)
    factors = [_factor(low, high, share, close=close) for (low, high), share in zip(_ranges(kind), shares, strict=True)]
    usual, plain = (size_for(kind, said, np.random.default_rng(0)) for said in (words, frozenset[str]()))
    factors = [max(_CARRYING if tight else 1.0, factor) for factor in factors] if carries else factors
    factors = [_as_said(factor, side, of) for factor, side, of in zip(factors, usual, plain, strict=True)]
    if usual[0] == usual[1]:
        factors[1] = factors[0]  # What is square or round stays so.
    least, most = kind.size_range
    x, y, z = (
        min(max(round(side * factor ** (_SAID if told else 1.0), 2), a), b)
        for side, factor, a, b in zip(usual, factors, least, most, strict=True)
    )
    return (x, y, z)


def _factor(low: float, high: float, share: float, *, close: bool) -> float:
    top = 1.0 + _CLOSE * (high - 1.0) if close else high
    return float(low * (top / low) ** share)


def _as_said(factor: float, side: float, ordinary: float) -> float:
    """A factor that leaves what is called large no smaller than that, and what is called small no larger."""
    if side == ordinary:
        return factor
    return max(1.0, factor) if side > ordinary else min(1.0, factor)


def _ranges(kind: Category) -> tuple[_Range, _Range, _Range]:
    if kind.is_in("lain_on", "own_bed"):
        return _BED
    if kind.is_in("seating") and kind.size[1] < _ONE:
        return _SEAT
    return _TABLE if kind.is_in("tables", "desks", "meal_tables", "counters") else _USUAL
