"""Stacks: "a stack of three plates" is a plate, a second one on it, and a third on that."""

from dataclasses import replace

from thinkblox.knowledge.stacks import load_stacks
from thinkblox.reading.draft import Bond, Draft, Mention

STACKED = "stacked"
_ON_TOP = ("on", "in_centre")
"""Relations to a stack that are to what lies on top of it."""


def raise_stacks(draft: Draft) -> None:
    """Put what is said to be stacked on others of its kind, as far as it stays there; counts are settled by now."""
    for thing in list(draft.things):
        piles = _piles(draft, thing)
        high = (thing.count or 0) // piles
        exact = high * piles == thing.count and 1 < high <= load_stacks().most
        if STACKED in thing.states and thing.asked and exact and load_stacks().is_piled(thing.noun):
            _raise(draft, thing, piles, high)


def _piles(draft: Draft, thing: Mention) -> int:
    """How many stacks there are: as many as were said, or one for each of several."""
    shares = (b for b in draft.bonds_of(thing) if b.each and not b.negated)
    holders = [a for b in shares for a in b.anchors if isinstance(a, Mention)]
    return max(1, thing.groups, sum(a.count or 1 for a in holders))


def _raise(draft: Draft, thing: Mention, piles: int, high: int) -> None:
    lying = [b for b in draft.bonds if thing in b.anchors and b.kind in _ON_TOP]
    thing.count, thing.least, thing.most, thing.plural = piles, None, None, piles > 1
    thing.states = [state for state in thing.states if state != STACKED]
    below = thing
    for _ in range(high - 1):
        layer = replace(
            thing,
            attributes=[*thing.attributes],
            unshown=[*thing.unshown],
            states=[*thing.states],
            per=[],
            owner=None,
            host=None,
        )
        draft.things.insert(draft.things.index(below) + 1, layer)
        draft.bonds.append(Bond("on", layer, (below,), each=piles > 1))
        below = layer
    for bond in lying:
        bond.anchors = tuple(below if anchor is thing else anchor for anchor in bond.anchors)
