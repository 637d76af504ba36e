"""What can hardly lie on what it is said to be on: a piano on a side table."""

from collections.abc import Iterator

from thinkblox.assets import Category, kind_of
from thinkblox.assets.mounting import mount_of
from thinkblox.reading.draft import Draft, Mention

_CARRIERS = ("tables", "desks", "seats", "storage")
"""What has a top of a known size; pedestals and platforms carry what is larger."""
_MUCH = 1.25
"""How much larger than the top of its carrier something is that cannot stand there."""


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
