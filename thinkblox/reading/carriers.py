"""What lies on what: beside what lies on a table is on the table, and a piano is hardly on a side table."""

import math
from collections.abc import Iterator
from dataclasses import replace

from thinkblox.assets import GENERAL_WORDS, Category, kind_of
from thinkblox.assets.mounting import PROPPED, mount_of
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.senses import senses_of
from thinkblox.reading.draft import Bond, Draft, Mention

_CARRIERS = ("tables", "desks", "seats", "storage")
"""What has a top of a known size; pedestals and platforms carry what is larger."""
_MUCH = 1.25
"""How much larger than the top of its carrier something is that cannot stand there."""
_LOW = 0.4
"""So large at most is what hangs by nature and stands beside small things on a table, as a clock does [m]."""
_BESIDE = ("left_of", "right_of", "in_front_of", "behind", "next_to")
"""What is so to something on a table is on that table as well."""
_PLACING = ("on", "inside", "above", "under", "in_corner", "against_wall", "in_centre", "at", "around")
"""Relations that say where something is by themselves."""


def carry_contents(draft: Draft) -> None:
    """Say of a container where its contents are said to be: "a toolbox with a hammer in it on a workbench".

    Of "armchairs, each with a lamp on a side table", each side table has its lamp.
    """
    for thing in draft.things:
        bonds = [b for b in draft.bonds_of(thing) if _is_carried(b)]
        for bond in bonds if thing.per else ():
            carrier = bond.anchors[0]
            if isinstance(carrier, Mention) and carrier.per == thing.per and bond.kind != "under":
                thing.per, bond.each = [], True
        for held in (b for b in bonds if b.kind == "inside" or len(bonds) > 1):
            container = held.anchors[0]
            assert isinstance(container, Mention)
            for bond in (b for b in bonds if b is not held and _may_carry(b.anchors[0], container)):
                there = [b for b in draft.bonds_of(container) if b.kind in _PLACING and not b.negated]
                if any((b.kind, b.anchors) == (bond.kind, bond.anchors) for b in there):
                    draft.bonds = [b for b in draft.bonds if b is not bond]
                elif held.kind == "inside" and not there:
                    draft.hand_over(bond, container)


def _is_carried(bond: Bond) -> bool:
    """Whether it says on, in or under which thing something is."""
    one = len(bond.anchors) == 1 and isinstance(bond.anchors[0], Mention)
    return bond.kind in ("on", "inside", "under") and one and not bond.negated


def _may_carry(carrier: Mention | str, container: Mention) -> bool:
    """Whether a thing is so large that a container stands on it, in it or under it."""
    if not isinstance(carrier, Mention) or carrier is container:
        return False
    if carrier.noun in GENERAL_WORDS:
        return load_habits().is_in(carrier.noun, *_CARRIERS)
    (x, y, _), (a, b, _) = kind_of(carrier.noun).size, kind_of(container.noun).size
    return x * y > a * b


def share_carriers(draft: Draft) -> None:
    """Put what is beside something on a table on that table: "on it a laptop, and a lamp to the left of the laptop"."""
    beside = [bond for bond in draft.bonds if bond.kind in _BESIDE and not bond.negated]
    between = [bond for bond in draft.bonds if bond.kind == "between" and not bond.negated]
    for bond in [*(b for b in beside if len(b.anchors) == 1), *between]:
        lies = next((b for b in draft.bonds_of(bond.subject) if _lies(b) and not b.each), None)
        for anchor in bond.anchors if lies is not None and not bond.each else ():
            free = isinstance(anchor, Mention) and _can_lie(anchor) and not draft.bonds_of(anchor)
            if not free or not isinstance(anchor, Mention) or lies is None or lies.anchors[0] is anchor:
                continue
            if not _outgrows_carrier(anchor, lies.anchors[0]):
                draft.bonds = [*draft.bonds, replace(lies, subject=anchor)]
    told = [*beside, *between]
    while found := [(bond, lies) for bond in told if (lies := _carrier_of_neighbour(draft, bond)) is not None]:
        for bond, carrier in found:
            if not _is_placed(draft, bond.subject):
                at = draft.bonds.index(bond)
                draft.bonds = [*draft.bonds[:at], replace(carrier, subject=bond.subject), *draft.bonds[at:]]


def _carrier_of_neighbour(draft: Draft, bond: Bond) -> Bond | None:
    """What says on what the thing lies that this one is beside, or all it is between; None where it need not be there.

    Between things that lie on different ones it is on neither.
    """
    one = len(bond.anchors) == 1 or bond.kind == "between"
    neighbours = [a for a in bond.anchors if isinstance(a, Mention) and a is not bond.subject] if one else []
    if not neighbours or _is_placed(draft, bond.subject) or not _can_lie(bond.subject):
        return None
    if bond.kind != "between" and neighbours[0].many and not bond.each:
        return None
    small = _lies_only(bond.subject)
    carriers = [
        next((b for b in draft.bonds_of(beside) if _lies(b, screens=small) and b.anchors[0] is not bond.subject), None)
        for beside in neighbours
    ]
    lies = carriers[0]
    if lies is None or any(other is None or other.anchors != lies.anchors for other in carriers[1:]):
        return None
    return lies if _has_room_for_both(lies, bond.subject) else None


def _lies_only(thing: Mention) -> bool:
    """Whether it is never anywhere but on other things, as a keyboard is."""
    return all(habit.kind == "on" for habit in load_habits().of(thing.noun))


def _has_room_for_both(lies: Bond, thing: Mention) -> bool:
    """Whether what lies on a thing leaves room for another there, which might as well stand on the floor."""
    carrier = lies.anchors[0]
    assert isinstance(carrier, Mention)
    if carrier.noun in GENERAL_WORDS or _lies_only(thing):
        return True
    areas = [math.prod(kind_of(each.noun).size[:2]) for each in (lies.subject, thing, carrier)]
    return areas[0] + areas[1] <= areas[2]


def _outgrows_carrier(thing: Mention, carrier: Mention | str) -> bool:
    """Whether it is larger than what another lies on, or that is a stand for one: a mixing desk is on no such."""
    if not isinstance(carrier, Mention):
        return False
    if carrier.noun in GENERAL_WORDS:
        return carrier.noun == "any_stand"
    area, top = (math.prod(kind_of(each.noun).size[:2]) for each in (thing, carrier))
    return area > top


def _lies(bond: Bond, *, screens: bool = False) -> bool:
    """Whether it says that something small, or a screen too, lies on a thing."""
    under = bond.anchors[0] if len(bond.anchors) == 1 else None
    if bond.kind != "on" or bond.negated or not isinstance(under, Mention):
        return False
    screen = load_habits().is_in(bond.subject.noun, "screens")
    return not load_habits().is_in(under.noun, "covers") and (screens or not screen)


def _can_lie(thing: Mention) -> bool:
    """Whether it lies on others by nature, in one of the senses of its name."""
    nouns = [category for category, _ in senses_of(thing.noun)]
    nouns += [thing.noun] if thing.noun not in GENERAL_WORDS else []
    if any(mount_of(kind_of(noun), thing.attributes) == "surface" for noun in nouns):
        return True
    kinds = [kind_of(noun) for noun in nouns]
    return any(mount_of(k, (PROPPED,)) == "surface" and max(k.size) <= _LOW and not thing.attributes for k in kinds)


def _is_placed(draft: Draft, thing: Mention) -> bool:
    return any(bond.kind in _PLACING and not bond.negated for bond in draft.bonds_of(thing))


def too_large(draft: Draft) -> Iterator[str]:
    """Things that stand on the floor by nature and are larger than what they are asked to be on."""
    for bond in draft.bonds:
        carrier = bond.anchors[0] if len(bond.anchors) == 1 else None
        if bond.kind != "on" or bond.negated or not bond.asked or not isinstance(carrier, Mention):
            continue
        thing, under = kind_of(bond.subject.noun), kind_of(carrier.noun)
        plain = bond.subject.size is None and carrier.size is None and under.is_in(*_CARRIERS)
        if plain and mount_of(thing, bond.subject.attributes) == "floor" and _outgrows(thing, under):
            yield f"{bond.subject.text} on {carrier.text} (hardly)"


def _outgrows(thing: Category, under: Category) -> bool:
    """Whether it is longer and wider than the top of another."""
    sides, top = sorted(thing.size[:2]), sorted(under.size[:2])
    return all(side > _MUCH * room for side, room in zip(sides, top, strict=True))
