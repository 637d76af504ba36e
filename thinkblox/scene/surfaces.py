"""What a room is finished with: floor, walls, trim and curtains. Colours are sRGB, 0 to 1."""

from typing import Annotated

import numpy as np
from msgspec import Meta

from thinkblox.checked import CheckedValue
from thinkblox.layings import Colour, Laying


class Covering(CheckedValue, frozen=True, kw_only=True):
    """A surface.

    Attributes:
        laying: what it is made of, and in which pattern.
        colour: of most of it.
        second: of its joints, chips, stripes or every other tile; what usually goes with its colour, when None.
    """

    laying: Laying
    colour: Colour
    second: Colour | None = None


class Surfaces(CheckedValue, frozen=True, kw_only=True):
    """The finish of a room.

    Attributes:
        palette: what its colours are called together; empty where they were not chosen as one.
        floor: of the floor.
        walls: of all walls.
        accent: of one wall, where that is another.
        accent_wall: index of that wall; wall i runs from floor[i] to floor[i + 1].
        dado: of the lower part of the walls, where that is another.
        dado_height: up to which it reaches [m].
        trim: skirting, frames of doors and windows.
        door: their leaves.
        curtains: at the windows, where there are any.
    """

    palette: str = ""
    floor: Covering
    walls: Covering
    accent: Covering | None = None
    accent_wall: Annotated[int, Meta(ge=0, le=1000)] | None = None
    dado: Covering | None = None
    dado_height: Annotated[float, Meta(gt=0.0, le=50.0)] = 1.2
    trim: Colour = (0.945, 0.935, 0.915)
    door: Colour = (0.84, 0.81, 0.76)
    curtains: Colour | None = None

    def of_wall(self, index: int) -> Covering:
        """The covering of a wall, above its dado."""
        return self.accent if self.accent is not None and index == self.accent_wall else self.walls


_WALLS = ((0.925, 0.910, 0.880), (0.930, 0.920, 0.900), (0.925, 0.900, 0.860), (0.905, 0.905, 0.890))
_FLOORS = ((0.760, 0.650, 0.520), (0.715, 0.590, 0.455), (0.800, 0.710, 0.590), (0.640, 0.510, 0.385))


def plain_surfaces(seed: int) -> Surfaces:
    """Planks and pale walls for a room that does not say what it is finished with; the same seed, the same colours."""
    draw = np.random.default_rng([seed % 2**32, 7]).integers(0, 1 << 16, 2)
    floor, wall = _FLOORS[int(draw[0]) % len(_FLOORS)], _WALLS[int(draw[1]) % len(_WALLS)]
    return Surfaces(floor=Covering(laying="planks", colour=floor), walls=Covering(laying="paint", colour=wall))
