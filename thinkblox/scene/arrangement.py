"""What a scene and the view that a policy has of one share: a room, and known things placed in it."""

from typing import TYPE_CHECKING, Self

from thinkblox.scene.asset import Asset, AssetCard
from thinkblox.scene.placement import Placement
from thinkblox.value import Value

if TYPE_CHECKING:
    from thinkblox.scene.room import Room


Known = Asset | AssetCard
"""What is known of a thing: all of it, or what a policy may know."""


class Arrangement(Value, frozen=True):
    """Placements in a room, in the order in which they were placed, by id."""

    if TYPE_CHECKING:
        room: Room
        placements: tuple[Placement, ...]

    def asset_of(self, placement: Placement) -> Known:
        """What is known of the thing that a placement shows."""
        raise NotImplementedError

    def with_placement(self, placement: Placement, asset: Known) -> Self:
        """Return the arrangement with one object more, or with that object replaced in its place in the order."""
        raise NotImplementedError

    def __contains__(self, id: str) -> bool:
        return any(p.id == id for p in self.placements)

    def __getitem__(self, id: str) -> Placement:
        """The placement called `id`; raises KeyError that lists the ids that exist."""
        for placement in self.placements:
            if placement.id == id:
                return placement
        raise KeyError(f"no object {id!r}; there are {', '.join(p.id for p in self.placements) or 'none'}")

    def resting_on(self, id: str) -> tuple[Placement, ...]:
        """The placements directly supported by `id`."""
        return tuple(p for p in self.placements if p.support == id)

    def riders(self, id: str) -> tuple[Placement, ...]:
        """What rests on an object, and on that, in the order of the placements."""
        found, todo = {id}, [id]
        while todo:
            new = [p.id for p in self.resting_on(todo.pop()) if p.id not in found]
            found.update(new)
            todo += new
        return tuple(p for p in self.placements if p.id in found and p.id != id)

    def carriers(self, id: str) -> tuple[str, ...]:
        """Ids of what is below an object, the nearest first."""
        found: list[str] = []
        below = self[id].support
        while below in self and below not in (id, *found):
            found.append(below)
            below = self[below].support
        return tuple(found)
