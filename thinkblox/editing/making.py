"""Orders that make something otherwise: the room longer, a thing larger, blue or round, a picture higher."""

import dataclasses
from functools import partial

from thinkblox.editing.finding import Finder
from thinkblox.editing.grammar import means
from thinkblox.editing.moving import move
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.remaking import factors, looks_of, otherwise
from thinkblox.editing.replacing import replace_one
from thinkblox.editing.reseating import with_seats
from thinkblox.editing.resizing import resize
from thinkblox.editing.spreading_under import spread_under
from thinkblox.editing.telling import named
from thinkblox.editing.work import Work
from thinkblox.errors import InputError

LIKE = {"wider": "width", "longer": "length", "deeper": "depth", "higher": "height"}
"""In what one thing is made like another, by the words for it."""
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


def as_larger_one(finder: Finder, order: Order) -> Order | None:
    """The order that makes the one there is so: "get a bigger wardrobe, 1.5 m wide"; None where it is not that."""
    noun = order.things[0].noun if len(order.things) == 1 else None
    change = means("comparatives", noun.degree) if noun is not None and noun.det == "a" and noun.degree else ""
    if noun is None or not change or noun.kind != "thing" or order.things[0].places or noun.size is not None:
        return None
    one = dataclasses.replace(noun, det="the", degree="", attributes=[], unshown=[])
    if len(finder.matching(one)) != 1:
        return None
    looks = [*order.looks, *noun.attributes]
    return dataclasses.replace(order, doing="make", things=[NounPhrase(one)], change=change, looks=looks)


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
    order = _as_another(work, finder, order)
    if not (order.looks or order.change or order.lengths):
        raise InputError(
            f"'{order.things[0].noun.text}' cannot be made otherwise by that: '{order.text}' names no size, colour,"
            " material or shape; it can be replaced by another thing"
        )
    found = (id for phrase in order.things for id in named(finder, phrase, phrase.places))
    ids = work.touched(dict.fromkeys(found))
    for id in ids:
        with_seats(work, id, partial(_remake_one, work, id, order), asked=bool(order.company))
    finder.recent = list(ids)


def _as_another(work: Work, finder: Finder, order: Order) -> Order:
    """An order by which things are to be "as wide as the bed", with that width.

    Raises:
        InputError: it is not said in what they are to be alike, or as which of several.
    """
    likes = [w for phrase in order.things for w in phrase.places if w.word == "as" and w.noun is not None]
    if not likes:
        return order
    ids = [id for w in likes if w.noun is not None for id in finder.ids(NounPhrase(w.noun, id=w.noun.id))]
    axis = LIKE.get(order.change.removesuffix("="), "")
    if len(ids) != 1 or not axis or order.lengths or order.times:
        raise InputError(f"'{order.text}': say of one thing in what it is to be like it, such as 'as wide as the bed'")
    deep, wide, high = work.scene[ids[0]].size
    metres = {"width": wide, "depth": deep, "height": high}.get(axis, max(deep, wide))
    things = [dataclasses.replace(p, places=[w for w in p.places if w not in likes]) for p in order.things]
    return dataclasses.replace(
        order, things=things, lengths=[(metres, axis)], change=f"{order.change.removesuffix('=')}="
    )


def _remake_one(work: Work, id: str, order: Order) -> bool:
    """Let one thing be otherwise where it stands; less so, where there is no room for more and nobody says how much."""
    before, said = work.asset_of(id), len(work.failed)
    for factor in factors(order):
        try:
            asset = otherwise(work, before, order, factor)
        except InputError as error:
            if len(work.failed) == said:
                work.failed.append(f"{id} was left as it is: {error}")
            return False
        if asset.id == before.id:
            work.done.append(f"{id} stays: it is {looks_of(before)} already")
            return True
        tried = len(work.failed)
        if replace_one(work, id, asset, stays=True):
            del work.failed[said:tried]
            return True
        del work.failed[said + 1 :]
    return False
