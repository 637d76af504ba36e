"""Which of several things is meant by what rests on it: "on the nightstand with the lamp"."""

import dataclasses
from collections.abc import Sequence

from thinkblox.editing.finding import Finder
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.reading.english.nodes import Where

_COMING = ("put", "move", "add")


def tell_by_load(order: Order, finder: Finder) -> None:
    """Let what is said to come along tell where to instead, where it rests on one of several that could be meant."""
    places = order.things[-1].places if len(order.things) == 1 and order.things[-1].places else order.places
    if order.doing not in _COMING or len(order.company) != 1 or not places:
        return
    noun, one = places[-1].noun, _bearer(finder, places[-1], order.company)
    if one and noun is not None:
        places[-1] = dataclasses.replace(places[-1], noun=dataclasses.replace(noun, id=one))
        order.company = []


def _bearer(finder: Finder, where: Where, company: Sequence[NounPhrase]) -> str:
    """The one of several things on which that rests; empty where it is no such, or rests on none or on several."""
    noun, load = where.noun, company[0]
    told = noun is not None and noun.kind == "thing" and noun.definite and not (noun.id or noun.many or where.negated)
    if noun is None or not told or load.noun.kind != "thing" or not load.noun.definite or load.places:
        return ""
    found = [p.id for p in finder.matching(noun)]
    bearers = {finder.scene[p.id].support for p in finder.matching(load.noun)} & {*found}
    return next(iter(bearers)) if len(found) > 1 and len(bearers) == 1 else ""
