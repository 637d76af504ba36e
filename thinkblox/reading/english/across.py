"""The wall across from what was named before: "a crib by the window and a wardrobe on the opposite wall"."""

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.draft import Bond, Draft, Mention

_OPPOSITE = ("opposite_wall",)
ACROSS = {
    "left_wall": "right_wall", "right_wall": "left_wall", "far_wall": "near_wall", "near_wall": "far_wall",
    "north_wall": "south_wall", "south_wall": "north_wall", "east_wall": "west_wall", "west_wall": "east_wall",
}  # fmt: skip
"""The walls that face each other."""
_AT_WALL = ("on", "against_wall", "in_centre")
"""Relations to a wall."""
_BESIDE = ("next_to", "left_of", "right_of", "between")
_OPENINGS = ("window", "door")


def settle_opposite_walls(draft: Draft) -> None:
    """Say of every "opposite wall" which it is: across from the wall, opening or thing that was named before."""
    if any(bond.anchors == ("one_wall",) for bond in draft.bonds):
        return
    opposite = [b for b in draft.bonds if b.anchors == _OPPOSITE and not b.negated]
    if len(opposite) > 1 and _named_before(draft, opposite[0].subject) is None:
        opposite[0].anchors = ("one_wall",)
        return
    for bond in opposite:
        before = _named_before(draft, bond.subject)
        if before is not None:
            _settle(draft, bond, before)


def _named_before(draft: Draft, subject: Mention) -> Mention | None:
    """The piece of furniture that was named before something."""
    at = next((n for n, thing in enumerate(draft.things) if thing is subject), 0)
    standing = (t for t in reversed(draft.things[:at]) if t.asked and not load_habits().is_in(t.noun, "small"))
    found = next((t for t in standing if not any(b.anchors == _OPPOSITE for b in draft.bonds_of(t))), None)
    while found is not None and found.owner is not None and found.owner is not subject:
        found = found.owner
    return _leader(draft, found, subject) if found is not None else None


def _leader(draft: Draft, thing: Mention, subject: Mention) -> Mention:
    """The bed of a nightstand that is beside it: what something is beside is what it is across from."""
    beside = (b.anchors[0] for b in draft.bonds_of(thing) if b.kind in _BESIDE and b.asked and not b.negated)
    leader = next((a for a in beside if isinstance(a, Mention) and a is not subject), None)
    return leader or thing


def _settle(draft: Draft, bond: Bond, before: Mention) -> None:
    for told in draft.bonds_of(before):
        place = told.anchors[0] if told.anchors else ""
        if not isinstance(place, str) or told.negated or told.spread > 1:
            continue
        if place in ACROSS and told.kind in _AT_WALL:
            bond.anchors = (ACROSS[place],)
            return
        if place == "wall" and told.kind in _AT_WALL:
            told.anchors = ("one_wall",)
            return
        if place in _OPENINGS and told.kind in ("next_to", "near", "facing"):
            bond.anchors = ("wall",)
            draft.bonds.append(Bond("opposite", bond.subject, (place,)))
            return
        if told.kind == "in_corner":
            bond.anchors = ("wall",)
            draft.bonds.append(Bond("far", bond.subject, (before,)))
            return
    placed = any(isinstance(told.anchors[0], str) for told in draft.bonds_of(before) if told.anchors)
    if not placed and any(habit.kind == "against_wall" for habit in load_habits().of(before.noun)):
        draft.bonds.append(Bond("against_wall", before, ("one_wall",), asked=False))
        return
    bond.anchors = ("wall",)
    draft.bonds.append(Bond("opposite", bond.subject, (before,)))
