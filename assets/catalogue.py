"""The table of categories: what can be asked for, how big and how heavy it is, and what makes it."""

from collections.abc import Mapping
from types import MappingProxyType

from thinkblox.assets import accessories, equipment, furniture
from thinkblox.assets.category import Category

_ROWS = (
    *furniture.BEDS,
    *furniture.STORAGE,
    *furniture.TABLES,
    *furniture.SEATS,
    *equipment.APPLIANCES,
    *equipment.ELECTRONICS,
    *equipment.LAMPS,
    *accessories.PLANTS,
    *accessories.SMALL,
    *equipment.BATHROOM,
    *accessories.WALLS,
    *equipment.GAMES,
    *accessories.TEXTILES,
)

CATALOGUE: Mapping[str, Category] = MappingProxyType({row.name: row for row in _ROWS})
"""Every category by name."""
