"""How many of each: what was said, shared out over anchors, or a sensible number for a bare plural."""

from thinkblox.assets import facts_of
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import UNKNOWN_ROOM, room_type
from thinkblox.reading.draft import Bond, Draft, Mention

MAX_OF_A_KIND = 200
"""Most objects that one request may ask for."""
MAX_OBJECTS = 400
"""Most objects that one prompt may ask for; the rest is listed as beyond it."""
_CORNERS = _WALLS = 4
_COVERS = ("cover", "covers", "covering")
_OVER = ["all", "over"]
_COVERING = 2
"""So many on each wall cover it."""
_PER_ROW, _ROWS = 3, 2
_PAIR = 2
_SET_OUT = ("around", "at", "at_long_side", "at_short_side", "facing")
"""Relations that say in what order several stand."""
_SEVERAL = 2
"""So many of a plural are there at least where something is said to have them."""


def limit_things(draft: Draft) -> None:
    """Keep as many things as can be asked for; the others are listed as beyond that."""
    extra = draft.things[MAX_OBJECTS:]
    if extra:
        kept = draft.things = draft.things[:MAX_OBJECTS]
        known = set(map(id, kept))
        draft.beyond.append(f"{len(extra)} more things, from {extra[0].text!r} on")
        draft.bonds = [
            b for b in draft.bonds if all(id(t) in known for t in (b.subject, *b.anchors) if isinstance(t, Mention))
        ]


def settle_counts(draft: Draft) -> None:
    """Give every thing its final count, anchors before what is counted by them."""
    bonds: dict[int, list[Bond]] = {}
    for bond in draft.bonds:
        bonds.setdefault(id(bond.subject), []).append(bond)
    for thing in _anchors_first(draft.things, bonds):
        _settle(draft, thing, bonds.get(id(thing), []))
    _limit(draft)


def _anchors_first(things: list[Mention], bonds: dict[int, list[Bond]]) -> list[Mention]:
    """Every thing after what it is bound to, as far as there are no circles."""
    order: dict[int, Mention] = {}
    entered: set[int] = set()
    stack = list(reversed(things))
    while stack:
        thing = stack.pop()
        if id(thing) in entered:
            order.setdefault(id(thing), thing)
            continue
        entered.add(id(thing))
        anchors = [a for bond in bonds.get(id(thing), []) for a in bond.anchors if isinstance(a, Mention)]
        anchors += thing.per
        stack += [thing, *(anchor for anchor in anchors if id(anchor) not in entered)]
    return list(order.values())


def _settle(draft: Draft, thing: Mention, bonds: list[Bond]) -> None:
    if thing.per:
        thing.count = (thing.count or facts_of(thing.noun).each) * sum(other.count or 1 for other in thing.per)
        return
    shares = next((bond for bond in bonds if bond.each and thing.asked and bond.anchors != (thing,)), None)
    anchors = shares.anchors if shares else ()
    if (between := next((bond for bond in bonds if _is_of_neighbours(thing, bond)), None)) is not None:
        _settle_between(draft, thing, between)
    elif shares and any(isinstance(a, str) and a == "corner" for a in anchors):
        thing.count = (thing.count or 1) * _CORNERS
    elif shares and any(isinstance(a, str) and a == "wall" for a in shares.anchors):
        thing.count = (thing.count or 1) * _WALLS
    elif shares and any(isinstance(a, Mention) for a in anchors):
        each = thing.count if thing.count is not None else _each(thing, shares.anchors)
        each = max(each, _SEVERAL) if thing.count is None and thing.plural and shares.distributed else each
        thing.count = each * sum((a.count or 1) for a in anchors if isinstance(a, Mention))
    elif thing.count is None and (one_each := _one_each(thing, bonds)):
        one_each.each = True
        thing.count = sum((a.count or 1) for a in one_each.anchors if isinstance(a, Mention))
    elif thing.count is None:
        most = max(_bare(thing, bonds), _usual(draft, thing), _covering(draft, thing))
        thing.count = _one_before_each(draft, thing) or most
    _carriers(draft, thing)


def _is_of_neighbours(thing: Mention, bond: Bond) -> bool:
    """Whether it stands between any two neighbours: "between every two chairs", "screens between the six beds"."""
    anchor = bond.anchors[0] if len(bond.anchors) == 1 else None
    several = isinstance(anchor, Mention) and (anchor.count or 0) > _PAIR
    each = bond.each or (several and thing.count is None and thing.plural)
    return bond.kind == "between" and each and isinstance(anchor, Mention) and (anchor.count or 0) >= _PAIR


def _settle_between(draft: Draft, thing: Mention, bond: Bond) -> None:
    """So many in every gap between neighbours, which stand in a row where nothing else is said of them."""
    anchor = bond.anchors[0]
    if not isinstance(anchor, Mention):
        return
    lined = next((b for b in draft.bonds_of(anchor) if b.kind == "in_rows"), None)
    if lined is None and not any(b.kind in _SET_OUT for b in draft.bonds_of(anchor)):
        lined = Bond("in_rows", anchor, rows=1, asked=False)
        draft.bonds = [lined, *draft.bonds]
    bond.each = True
    thing.count = (thing.count or 1) * max(1, (anchor.count or 1) - max(1, lined.rows if lined else 1))


def _each(thing: Mention, anchors: tuple[Mention | str, ...]) -> int:
    """So many of a bare plural belong to each anchor: "tables with chairs", "desks with chairs"."""
    table = any(isinstance(a, Mention) and load_habits().is_in(a.noun, "meal_tables") for a in anchors)
    return 4 if table and load_habits().is_in(thing.noun, "meal_seats") else facts_of(thing.noun).each


def _one_each(thing: Mention, bonds: list[Bond]) -> Bond | None:
    """The bond by which a bare plural is one for each of several: "pendant lamps above the tables"."""
    lamp = load_habits().is_in(thing.noun, "lamps")
    several = (
        b
        for b in bonds
        if b.kind in ("above", "on")
        and (len(b.anchors) > 1 or any(isinstance(a, Mention) and a.many for a in b.anchors))
    )
    return next(several, None) if lamp and thing.plural else None


def _one_before_each(draft: Draft, thing: Mention) -> int:
    """As many of a bare plural on the wall as there are seats before it: "four styling chairs in front of mirrors"."""
    if not thing.plural or not load_habits().is_in(thing.noun, "wallpieces"):
        return 0
    before = (b.subject for b in draft.bonds if b.asked and b.kind == "in_front_of" and thing in b.anchors)
    return next((s.count for s in before if s.count and load_habits().is_in(s.noun, "seating", "seats")), 0)


def _bare(thing: Mention, bonds: list[Bond]) -> int:
    abreast = facts_of(thing.noun).row.abreast
    if thing.rows:
        several = abreast or (_PER_ROW if thing.rows != 1 else _PER_ROW + 1)
        return (_ROWS if thing.rows < 0 else thing.rows) * several
    rows = next((bond.rows for bond in bonds if bond.kind == "in_rows"), None)
    if rows is not None:
        return max(rows, _ROWS) * (abreast or _PER_ROW)
    tables = [a for b in bonds if b.kind in ("around", "at") for a in b.anchors if isinstance(a, Mention) and a.seats]
    if tables and load_habits().is_in(thing.noun, "seats", "chairs"):
        return sum(table.seats * (table.count or 1) for table in tables)
    return facts_of(thing.noun).plenty or (3 if load_habits().is_in(thing.noun, "small", "plants") else 2)


def _covering(draft: Draft, thing: Mention) -> int:
    """As many of a bare plural as cover the walls: "acoustic panels cover the walls" has some on each."""
    words = thing.text.lower().split()
    if not (words and thing.plural and load_habits().is_in(thing.noun, "wallpieces")):
        return 0
    said = [word.text.lower() for word in draft.account]
    after = (said[at + 1 : at + 5] for at, word in enumerate(said) if word == words[-1])
    covers = any(rest and (rest[0] in _COVERS or rest[:2] == _OVER) and "walls" in rest for rest in after)
    return _COVERING * _WALLS if covers else 0


def _usual(draft: Draft, thing: Mention) -> int:
    """How many of a bare plural such a room usually has: a library with bookcases has more than two."""
    usual = (usual.count for usual in room_type(draft.room).usual if usual.category == thing.noun)
    furniture = (
        thing.plural
        and thing.asked
        and load_habits().is_in(thing.noun, "storage", "shelves", "worked_at", "meal_tables", "from_aisles")
    )
    return next(usual, 0) if furniture and draft.room not in ("", UNKNOWN_ROOM) else 0


def _carriers(draft: Draft, thing: Mention) -> None:
    """Base cabinets that carry a sink, a hob and a microwave are at least three."""
    if thing.noun == "base_cabinet" and thing.plural and thing.text and not _is_counted(thing):
        carried = sum(b.kind == "on" and thing in b.anchors for b in draft.bonds)
        thing.count = max(thing.count or 1, carried)


def _is_counted(thing: Mention) -> bool:
    return thing.count is not None and thing.count != facts_of(thing.noun).plenty and not thing.vague


def _limit(draft: Draft) -> None:
    total = 0
    for thing in list(draft.things):
        wanted = thing.count or 1
        thing.count = max(0, min(wanted, MAX_OF_A_KIND, MAX_OBJECTS - total))
        total += thing.count
        if thing.count < wanted:
            draft.beyond.append(f"{wanted - thing.count} more of {thing.text or thing.noun!r}")
        if thing.count == 0:
            draft.drop(thing)
