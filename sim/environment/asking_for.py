"""What of a room can be asked for by name: things, doors and drawers, and surfaces that carry."""

import difflib
from collections.abc import Container, Iterable, Sequence
from dataclasses import dataclass

from thinkblox.errors import InputError
from thinkblox.exporters.inventory import InventoryBody, InventoryObject
from thinkblox.exporters.naming import safe_name
from thinkblox.scene.asset import Surface
from thinkblox.sim.environment.room_source import OpenRoom

LIGHT = 2.0
"""What weighs no more can be carried by a robot's arm [kg]."""
SMALL = 0.35
"""What is no larger in any direction can be carried [m]."""
OPENS = 0.05
"""A door or drawer whose range is less is none [rad or m]."""


@dataclass(frozen=True)
class Moving:
    """A door or drawer of a thing, called "<id>/<link>"."""

    name: str
    item: InventoryObject
    body: InventoryBody


@dataclass(frozen=True)
class Carrying:
    """A surface of a thing that is open to above, called "<id>/<surface>"."""

    name: str
    item: InventoryObject
    surface: Surface


def things(room: OpenRoom) -> dict[str, InventoryObject]:
    """Everything that can be touched, by its id."""
    scene = room.scene
    touched = {p.id for p in scene.placements if scene.asset_of(p).collides}
    return {item.id: item for item in room.inventory.objects if item.id in touched}


def small_things(room: OpenRoom) -> dict[str, InventoryObject]:
    """What an arm can carry, by its id."""
    scene = room.scene
    light = {
        p.id
        for p in scene.placements
        if max(p.size) <= SMALL and scene.asset_of(p).mass <= LIGHT and scene.asset_of(p).free
    }
    return {id: item for id, item in things(room).items() if id in light}


def moving(room: OpenRoom) -> dict[str, Moving]:
    """All doors and drawers, by "<id>/<link>"."""
    every = [
        Moving(body.source, item, body)
        for item in room.inventory.objects
        for body in item.bodies
        if body.joint is not None and body.joint.upper > OPENS
    ]
    return {each.name: each for each in every}


def surfaces(room: OpenRoom) -> dict[str, Carrying]:
    """All surfaces that are open to above, by "<id>/<surface>"."""
    found = {}
    for item, placement in zip(room.inventory.objects, room.scene.placements, strict=True):
        for surface in room.scene.asset_of(placement).surfaces:
            if not surface.inner:
                name = f"{item.id}/{surface.name}"
                found[name] = Carrying(name, item, surface)
    return found


def check_fit(asked: str | None, room: OpenRoom, fit: Container[str], why: str) -> None:
    """Raise InputError when someone asks for what is in the room, but is nothing of the kind that is wanted.

    Args:
        asked: an id, as in the scene or in the files, a part of one, a category, or None.
        room: whose things these are.
        fit: ids of what is wanted.
        why: the others are not, as what follows their name: "has no doors or drawers".
    """
    if asked is None:
        return
    named = [
        p.id
        for p in room.scene.placements
        if asked in (p.id, p.category, safe_name(p.id)) or asked.startswith(f"{p.id}/")
    ]
    if named and not any(id in fit for id in named):
        others = sorted(p.id for p in room.scene.placements if p.id in fit)
        does = f"; {', '.join(others[:4])} would do" if others else ""
        raise InputError(f"{room.name}: {', '.join(named[:4])} {why}{does}")


def meant(asked: str | None, there: Sequence[str], categories: Iterable[str], *, what: str, room: str) -> list[str]:
    """Which of the names that there are someone means: one, all of a thing, all of a category, or all.

    Args:
        asked: a name, the part of one before "/", a category, or None.
        there: names, by which the things are called.
        categories: of the things, in the same order.
        what: is asked for, in the plural: "doors and drawers".
        room: whose things these are.

    Raises:
        InputError: there are none, or none of that name; says which are nearest.
    """
    if not there:
        raise InputError(f"{room}: the room has no {what}")
    if asked is None:
        return list(there)
    kinds = list(categories)
    whole = [name for name in there if name == asked] or [name for name in there if name.partition("/")[0] == asked]
    # In the files they have safe names.
    whole = whole or [name for name in there if safe_name(name) == asked]
    alike = whole or [name for name, kind in zip(there, kinds, strict=True) if kind == asked]
    if not alike:
        known = list(dict.fromkeys((*there, *(name.partition("/")[0] for name in there), *kinds)))
        near = difflib.get_close_matches(asked, known, n=4, cutoff=0.4) or known[:8]
        raise InputError(f"{room}: no {what} called {asked!r}; the nearest are {', '.join(near)}")
    return alike
