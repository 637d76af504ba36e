"""Orders that make something otherwise: the room longer, a thing larger, blue or round, a picture higher."""

from thinkblox.editing.finding import Finder
from thinkblox.editing.moving import move
from thinkblox.editing.orders import Order
from thinkblox.editing.remaking import factors, looks_of, otherwise
from thinkblox.editing.replacing import replace_one
from thinkblox.editing.resizing import resize
from thinkblox.editing.wheres import named
from thinkblox.editing.work import Work
from thinkblox.errors import InputError


def make(work: Work, finder: Finder, order: Order) -> None:
    """Change the size of the room, or how a thing is.

    Raises:
        InputError: it is not said what, or how.
    """
    if order.room:
        if order.things or order.looks:
            raise InputError(f"'{order.text}' speaks of the room and of more; only the size of a room can be changed")
        resize(work, finder, order)
        return
    if not order.things:
        raise InputError(f"'{order.text}' does not say what is to be made otherwise; there {finder.listed()}")
    if order.change in ("higher", "lower") and not order.looks and _hangs(work, finder, order):
        order.direction, order.change = "up" if order.change == "higher" else "down", ""
        move(work, finder, order)
        return
    _remake(work, finder, order)


def _hangs(work: Work, finder: Finder, order: Order) -> bool:
    ids = [id for phrase in order.things for id in named(finder, phrase, phrase.places)]
    return all(not work.asset_of(id).free for id in ids)


def _remake(work: Work, finder: Finder, order: Order) -> None:
    """Let things be of another size, colour, material or shape.

    Raises:
        InputError: it is not said how.
    """
    if not (order.looks or order.change or order.lengths):
        raise InputError(
            f"'{order.things[0].noun.text}' cannot be made otherwise by that: '{order.text}' names no size, colour,"
            " material or shape; it can be replaced by another thing"
        )
    found = (id for phrase in order.things for id in named(finder, phrase, phrase.places))
    ids = work.touched(dict.fromkeys(found))
    for id in ids:
        _remake_one(work, id, order)
    finder.recent = list(ids)


def _remake_one(work: Work, id: str, order: Order) -> None:
    """Let one thing be otherwise where it stands; less so, where there is no room for more and nobody says how much."""
    before, said = work.asset_of(id), len(work.failed)
    for factor in factors(order):
        try:
            asset = otherwise(work, before, order, factor)
        except InputError as error:
            if len(work.failed) == said:
                work.failed.append(f"{id} was left as it is: {error}")
            return
        if asset.id == before.id:
            work.done.append(f"{id} stays: it is {looks_of(before)} already")
            return
        tried = len(work.failed)
        if replace_one(work, id, asset, stays=True):
            del work.failed[said:tried]
            return
        del work.failed[said + 1 :]
