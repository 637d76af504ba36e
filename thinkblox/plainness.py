"""What of a scene stands there as a plain solid, for want of a shape of its own."""

from collections.abc import Iterator

from thinkblox.assets import CATALOGUE, StandIn, stand_in
from thinkblox.scene.scene import Scene
from thinkblox.verdict import PlainThing

_MADE_HERE = ("procedural:", "stand_in:")
"""How the provenance of an asset begins that was made by our own generators."""


def plain_things(scene: Scene) -> tuple[PlainThing, ...]:
    """Every kind of thing in the scene that our generators made as a plain solid, in the order of the scene."""
    ids: dict[str, list[str]] = {}
    for placement in scene.placements:
        if scene.asset_of(placement).provenance.startswith(_MADE_HERE):
            ids.setdefault(placement.category, []).append(placement.id)
    return tuple(_plain_of(ids))


def _plain_of(ids: dict[str, list[str]]) -> Iterator[PlainThing]:
    for category, members in ids.items():
        found = stand_in(category)
        if found.how != "catalogue":
            yield PlainThing(
                name=found.category.noun,
                ids=tuple(members),
                how=found.how,
                like=_like(found),
                similarity=found.similarity,
            )


def _like(found: StandIn) -> str:
    """What else it has the size of; empty for what has an entry under its own name."""
    return CATALOGUE[found.like].noun if found.like and found.like != found.category.name else ""
