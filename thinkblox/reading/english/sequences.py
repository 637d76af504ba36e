"""Things named in their order: "along the right wall, from front to back: a bookcase, a desk and a plant"."""

from collections.abc import Iterable

from thinkblox.brief import RelationKind
from thinkblox.reading.draft import Bond, Draft, Mention

_INTO_ROOM: dict[str, dict[str, RelationKind]] = {
    "left_wall": {"behind": "left_of", "in_front_of": "right_of"},
    "right_wall": {"behind": "right_of", "in_front_of": "left_of"},
}
"""At which side of a thing at such a wall, which looks into the room, the next one stands further back, or less far."""


def settle_sequences(draft: Draft, ordered: Iterable[Bond]) -> None:
    """Say of what stands further back along a side wall that it is beside the one before rather than behind it."""
    for bond in ordered:
        anchor = bond.anchors[0]
        walls = _walls(draft, bond.subject) & (_walls(draft, anchor) if isinstance(anchor, Mention) else set())
        for wall in walls & _INTO_ROOM.keys():
            bond.kind = _INTO_ROOM[wall].get(bond.kind, bond.kind)


def _walls(draft: Draft, thing: Mention) -> set[str]:
    return {a for b in draft.bonds_of(thing) if not b.negated for a in b.anchors if isinstance(a, str)}
