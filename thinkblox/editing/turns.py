"""In which turn orders are carried out: what is to stand where another thing stands comes after that one leaves."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.editing.finding import Finder
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.telling import named
from thinkblox.errors import InputError

_LEAVING = ("put", "move", "remove", "resite", "replace")


def in_turn(orders: Sequence[Order], finder: Finder) -> list[Order]:
    """The orders, where one that names the place of a thing follows the one by which that thing leaves it.

    Two things of which each is to stand where the other stands change places.
    """
    left, finder = list(orders), replace(finder, seen=[])
    for order in orders:
        if order not in left:
            continue
        held = _spots(order, finder)
        later = [o for o in left[left.index(order) + 1 :] if o.doing in _LEAVING and held & _movers(o, finder)]
        if not held or not later:
            continue
        other, mine = later[0], _movers(order, finder)
        if len(mine) == len(held) == 1 and mine == _spots(other, finder):
            left[left.index(order)] = Order("swap", order.text, things=[*_bare(order), *_bare(other)])
            left.remove(other)
        else:
            left.remove(order)
            left.insert(left.index(other) + 1, order)
    return _turned_first(left, finder)


def _turned_first(orders: list[Order], finder: Finder) -> list[Order]:
    """The orders, where what comes nearer to a thing does so after that is turned, as turning may move it."""
    left = list(orders)
    for order in orders:
        near = {id for nearer, phrase in order.closer if nearer for id in _known(phrase, finder)}
        later = [o for o in left[left.index(order) + 1 :] if o.doing == "turn" and near & _turners(o, finder)]
        if order.doing == "move" and near and later:
            left.remove(order)
            left.insert(left.index(later[-1]) + 1, order)
    return left


def _turners(order: Order, finder: Finder) -> set[str]:
    return {id for phrase in order.things for id in _known(phrase, finder)}


def _known(phrase: NounPhrase, finder: Finder) -> tuple[str, ...]:
    """The thing that a bare phrase means; none of what is told by more, or by what was named before."""
    bare = phrase.noun.kind == "thing" and phrase.noun.definite and not phrase.places
    return _ids(phrase, finder) if bare else ()


def _spots(order: Order, finder: Finder) -> set[str]:
    """What stands where an order says that something is to stand."""
    nouns = [w.noun for phrase in order.things for w in (*phrase.places, *order.places) if w.word == "spot"]
    return {id for noun in nouns if noun is not None for id in _ids(NounPhrase(noun, id=noun.id), finder)}


def _movers(order: Order, finder: Finder) -> set[str]:
    return {id for phrase in _bare(order) for id in _ids(phrase, finder)}


def _bare(order: Order) -> list[NounPhrase]:
    return [NounPhrase(p.noun, id=p.id, rank=p.rank, along=p.along, member=p.member) for p in order.things]


def _ids(phrase: NounPhrase, finder: Finder) -> tuple[str, ...]:
    try:
        return named(finder, phrase, ())
    except InputError:
        return ()
