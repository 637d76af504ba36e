"""Makes bonds: which relation really holds, who its subject is, and what a place of the room means for it."""

from thinkblox.assets import kind_of
from thinkblox.brief import RelationKind
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.draft import MISSING, Bond, Draft, Mention

_KINDS: dict[str, RelationKind] = {
    "in": "on",
    "along": "against_wall",
    "flank": "next_to",
    "flank_each": "next_to",
    "sides": "next_to",
}
FLANKS = ("flank", "flank_each")
"""Both sides of something: "on either side of the bed", and "on each side", where a number is that of one side."""
_BY_OWNER = ("next_to", "near", "in_front_of", "behind", "left_of", "right_of", "at_foot_of", "between", "opposite")
_JOINED = {"on": "small", "against_wall": "wallpieces", "above": "wallpieces", "around": "seats"}
"""Relations that all of a list can share, and what kind of things then do."""


_LOW = 0.6
"""Height up to which a seat goes under a table of usual height [m]."""
_BESIDE = ("left_of", "right_of", "in_front_of", "behind", "next_to", "near", "between", "facing", "in_centre")
"""Relations that say where on its surface a thing lies."""


def place_bond(kind: str, place: str) -> tuple[RelationKind, tuple[str, ...]] | None:
    """The relation and places that "<kind> the <place>" means; None when it says nothing ("on the ceiling")."""
    name, *walls = place.split()
    if name == "corner":
        return ("in_corner", tuple(walls) or (name,))
    if name == "centre":
        return ("in_centre", (name,))
    if name == "floor":
        return ("on", (name,)) if kind in ("on", "in") else None
    if name in ("window", "door"):
        keep = kind in ("facing", "facing_away", "opposite", "left_of", "right_of", "above")
        return (relation_kind(kind) if keep else "near", (name,))
    if name.endswith("wall"):
        return (relation_kind(kind) if kind in ("facing", "opposite") else "against_wall", (name,))
    return None


def relation_kind(kind: str) -> RelationKind:
    """The relation a preposition stands for before an object ("in" a basket is "on" it)."""
    return _KINDS.get(kind, kind)  # type: ignore[arg-type]


def bind(draft: Draft, bond: Bond) -> None:
    """Add a bond, turned the right way round, in place of a weaker one that it makes more exact."""
    anchor = bond.anchors[0] if bond.anchors else None
    if isinstance(anchor, Mention):
        if anchor is bond.subject and bond.kind not in ("facing", "next_to", "back_to_back"):
            return
        if bond.kind == "between" and (neighbours := _neighbours(bond)):
            draft.bonds += neighbours[1:]
            bond = neighbours[0]
        else:
            bond = _turned(bond, anchor)
    if bond.subject.owner is not None and not bond.implied:
        vaguer = [old for old in draft.bonds_of(bond.subject) if _is_sharper(bond, old)]
        bond.each |= bond.kind != "between" and any(old.each and old.anchors == bond.anchors for old in vaguer)
        draft.unsay(vaguer)
    draft.bonds.append(bond)


def _turned(bond: Bond, anchor: Mention) -> Bond:
    """The bond that is meant: chairs "under" a desk are at it, a bed "on" a rug has the rug under it."""
    habits = load_habits()
    usual = habits.tie(bond.subject.noun, anchor.noun)
    if bond.kind == "under" and _hangs_over(anchor, bond):
        return Bond("above", anchor, (bond.subject,), each=bond.each)
    if bond.kind == "on" and habits.is_in(anchor.noun, "covers") and not habits.is_in(bond.subject.noun, "covers"):
        if habits.is_in(bond.subject.noun, "small"):
            return bond
        return Bond("under", anchor, (bond.subject,), each=bond.each)
    if bond.kind in ("against_wall", "under") and usual in ("at", "around"):
        at = usual if bond.subject.many or bond.each else "at"
        bond.kind = bond.kind if _slides_under(bond, anchor) else at
    elif bond.kind == "against_wall":
        bond.kind = "next_to"
    elif bond.kind == "next_to" and habits.is_in(bond.subject.noun, "wallpieces"):
        bond.kind = "near" if habits.is_in(anchor.noun, "amid_room") else bond.kind
    return bond


def _hangs_over(anchor: Mention, bond: Bond) -> bool:
    """Whether what stands on the floor is said to be under one thing that hangs above it: a lamp, a television."""
    if bond.negated or len(bond.anchors) > 1 or kind_of(bond.subject.noun).mount != "floor":
        return False
    if load_habits().tie(anchor.noun, bond.subject.noun) == "on":
        return False
    above = any(sense.endswith(" if rel:above") for sense in kind_of(anchor.noun).senses)
    return kind_of(anchor.noun).mount == "ceiling" or above


def _slides_under(bond: Bond, anchor: Mention) -> bool:
    """Whether one seat without a back is said to be under a table: "a stool tucked under the desk"."""
    if bond.kind != "under" or (not bond.each and (bond.subject.count or 2) > (anchor.count or 1)):
        return False
    low = kind_of(bond.subject.noun).size[2] <= _LOW
    return low and load_habits().is_in(anchor.noun, "desks", "tables")


def _neighbours(bond: Bond) -> list[Bond]:
    """The bed "between two nightstands" or the fridge between two appliances comes first, what is beside it then."""
    tie = load_habits().tie
    things = [a for a in bond.anchors if isinstance(a, Mention) and tie(a.noun, bond.subject.noun) == "next_to"]
    return [Bond("next_to", a, (bond.subject,)) for a in things] if len(things) == len(bond.anchors) else []


def _is_sharper(bond: Bond, old: Bond) -> bool:
    """Whether `bond` says better what `old` of the same subject only supposed ("a bed with a lamp next to it")."""
    if old.kind in ("on", "inside") and bond.kind in _BESIDE and bond.anchors != old.anchors:
        return False
    return old.implied and bond.kind not in ("facing", "in_rows")


def subjects_of(
    draft: Draft,
    current: Mention,
    kind: str,
    anchors: tuple[Mention | str, ...],
    run: list[Mention],
    *,
    pronoun: bool,
) -> list[Mention]:
    """Which things a relation that follows `current` is about.

    "a desk with a chair by the window": the desk. "a vase and two candles on the table": both.
    """
    habits = load_habits()
    owner = current.owner
    place = bool(anchors) and isinstance(anchors[0], str)
    if owner is not None and owner not in anchors and (not pronoun or kind in _BY_OWNER):
        if place and not (habits.is_in(current.noun, "wallpieces", "ceiling")):
            return [owner]
        if kind in _BY_OWNER and habits.is_in(current.noun, "small", "seats", "lamps") and kind != "facing":
            return [owner]
    group = _JOINED.get(kind, "")
    taken = [thing for thing in run if draft.bonds_of(thing)] if group else []
    if group and (current.noun == MISSING or habits.is_in(current.noun, group)):
        free = (t for t in run if t.owner is owner and t not in anchors and (t is current or t not in taken))
        return [t for t in free if habits.is_in(t.noun, group)] or [current]
    return [current]
