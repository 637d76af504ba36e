"""What the guidelines look at: the things on the floor of a room, with what is known of each."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from thinkblox.assets import Facts, facts_of
from thinkblox.scene.arrangement import Arrangement
from thinkblox.scene.asset import FRONT_UNKNOWN, Asset, AssetCard
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Rects
from thinkblox.scene.room import Room
from thinkblox.scene.support import ON_FLOOR

_WALKED_ROUND = (0.25, 0.45, 0.25)
"""Least depth, width and height of what one has to walk round [m]."""
_MOVED = 15.0
"""What is lighter than this is moved aside where it is in the way of use [kg]."""


@dataclass(frozen=True)
class Furnishing:
    """A placed thing and what is known of it."""

    placement: Placement
    asset: Asset | AssetCard
    facts: Facts

    @property
    def id(self) -> str:
        """Its id."""
        return self.placement.id

    @property
    def is_turned(self) -> bool:
        """Whether it has a front that is known."""
        return self.asset.front == "one" and not (isinstance(self.asset, Asset) and FRONT_UNKNOWN in self.asset.flags)

    @property
    def gaze(self) -> float:
        """Where one looks who uses it [degrees]."""
        return self.placement.yaw + (180.0 if self.asset.gaze == "back" else 0.0)

    @property
    def is_large(self) -> bool:
        """Whether one has to walk round it."""
        low, high = sorted(self.placement.size[:2])
        return low > _WALKED_ROUND[0] and high > _WALKED_ROUND[1] and self.placement.size[2] > _WALKED_ROUND[2]

    @property
    def is_moved(self) -> bool:
        """Whether it is drawn aside by whoever needs the floor."""
        seat = self.facts.is_in("seating") and not self.facts.is_in("lounges")
        return self.facts.is_in("drawn_aside") or (seat and self.asset.mass < _MOVED)


@dataclass(frozen=True)
class Standing:
    """A room and its things, worked out once for all guidelines."""

    scene: Arrangement

    @property
    def room(self) -> Room:
        """The room."""
        return self.scene.room

    @cached_property
    def things(self) -> tuple[Furnishing, ...]:
        """All that can be touched."""
        found = ((p, self.scene.asset_of(p)) for p in self.scene.placements)
        return tuple(Furnishing(p, asset, facts_of(p.category)) for p, asset in found if asset.collides)

    @cached_property
    def on_floor(self) -> tuple[Furnishing, ...]:
        """What stands on the floor."""
        return tuple(thing for thing in self.things if thing.placement.position[2] <= ON_FLOOR)

    @cached_property
    def large(self) -> tuple[Furnishing, ...]:
        """What one walks round, and does not draw aside."""
        return tuple(thing for thing in self.on_floor if thing.is_large and not thing.is_moved)

    def of(self, *groups: str) -> tuple[Furnishing, ...]:
        """What belongs to one of some groups of categories."""
        return tuple(thing for thing in self.things if thing.facts.is_in(*groups))


def rects_of(things: Sequence[Furnishing]) -> Rects:
    """The boxes around some things."""
    return Rects.of_placements(tuple(thing.placement for thing in things))
