"""Which form a thing has of which only the kind is known: a table that six sit around is oblong, or round."""

import numpy as np
from msgspec.structs import replace

from thinkblox.brief import Brief, Request
from thinkblox.knowledge.variety import varieties
from thinkblox.planning.rooms import is_open

_ROUND = "round"
_OFTEN = 0.4
"""How often a table is round that may be."""
_MOST = 6
"""Round a larger circle than so many need nobody hears the other side."""
_ALL_ROUND = ("around", "on", "above", "under")
"""Relations to a table that has no sides of its own."""
_FREE = ("in_centre", "above")
"""Relations of one that stands amid the room."""
_SALT = 5_000_011


def with_forms(brief: Brief, seed: int) -> Brief:
    """The brief with some of the tables round that it assumes in a room of any size; the same seed gives the same."""
    rng = np.random.default_rng((seed, _SALT))
    requests = (_drawn(brief, request, rng.random()) for request in brief.requests)
    return replace(brief, requests=tuple(requests)) if is_open(brief) else brief


def _drawn(brief: Brief, request: Request, share: float) -> Request:
    if share >= _OFTEN or not _may_be_round(brief, request):
        return request
    return replace(request, attributes=(*request.attributes, _ROUND))


def _may_be_round(brief: Brief, request: Request) -> bool:
    """Whether nothing is said of its form, and nothing stands at a side of it."""
    plain = all(word.startswith("for-") for word in request.attributes) and not any(request.size)
    if request.asked or request.count != 1 or not plain or request.category not in varieties().rounded.split(", "):
        return False
    around = [r for r in brief.relations if request.key in r.anchors]
    seats = sum(brief.request(r.subject).count for r in around if r.kind == "around")
    amid = all(r.kind in _FREE for r in brief.relations if r.subject == request.key)
    return amid and 0 < seats <= _MOST and all(r.kind in _ALL_ROUND for r in around)
