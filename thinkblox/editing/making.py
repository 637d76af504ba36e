"""Orders that make something otherwise: the room longer, a thing larger, blue or round, a picture higher."""

import dataclasses

from thinkblox.editing.finding import Finder
from thinkblox.editing.moving import move
from thinkblox.editing.orders import Order
from thinkblox.editing.remaking import factors, looks_of, otherwise
from thinkblox.editing.replacing import replace_one
from thinkblox.editing.resizing import resize
from thinkblox.editing.spreading_under import spread_under
from thinkblox.editing.wheres import named
from thinkblox.editing.work import Work
from thinkblox.errors import InputError

LOWER, SLIGHT = 0.2, 0.1
"""How much lower or higher a lamp hangs where nobody says by how much, and where it is a bit [m]."""


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
    if order.bears:
        spread_under(work, finder, order)
        return
    if order.change in ("higher", "lower") and not order.looks and _hangs(work, finder, order):
        order.direction, order.change = "up" if order.change == "higher" else "down", ""
        if hangs_down(work, finder, order):
            hang(work, finder, order)
        else:
            move(work, finder, order)
        return
    _remake(work, finder, order)


def hangs_down(work: Work, finder: Finder, order: Order) -> bool:
    """Whether an order takes what hangs from the ceiling up or down, by which its cord becomes shorter or longer."""
    if order.direction not in ("up", "down") or order.closer or order.apart or not order.things:
        return False
    if any(phrase.noun.kind not in ("thing", "pronoun", "number") for phrase in order.things):
        return False
    recent, seen = list(finder.recent), list(finder.seen)
    ids = [id for phrase in order.things for id in named(finder, phrase, phrase.places)]
    finder.recent, finder.seen = recent, seen
    return bool(ids) and all(work.scene[id].support == "ceiling" for id in ids)


def hang(work: Work, finder: Finder, order: Order) -> None:
    """Let what hangs from the ceiling hang lower or higher, on a longer or a shorter cord."""
    step = order.lengths[0][0] if order.lengths else SLIGHT if order.slight else LOWER
    change = "larger" if order.direction == "down" else "smaller"
    longer = dataclasses.replace(order, change=change, lengths=[(step, "height")], direction="", by=True, looks=[])
    _remake(work, finder, longer)


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
