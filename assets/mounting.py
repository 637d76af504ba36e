"""What a thing is placed on: as its category says, or on a wall or the ceiling where the words say so."""

from collections.abc import Collection

from thinkblox.assets.category import Category
from thinkblox.scene.asset import Mount

WALL_MOUNTED, HANGING, PROPPED = "wall-mounted", "hanging", "propped"
_CAN_HANG = frozenset(
    {
        "bedside_cabinet",
        "bookcase",
        "cabinet",
        "credenza",
        "dresser",
        "fan",
        "monitor",
        "nightstand",
        "shelving_unit",
        "shoe_rack",
        "sideboard",
        "speaker",
        "standing_mirror",
        "tv_stand",
    }
)
"""Categories that usually stand, and are hung on walls too, besides plain things and those that lie on others."""

_FROM_CEILING = frozenset({"security_camera", "smoke_detector"})
"""Categories that usually are on a wall, and are fixed to the ceiling too."""


def mount_of(category: Category, words: Collection[str]) -> Mount:
    """What one of a category that the words describe is placed on."""
    said = {word.lower().replace("_", "-") for word in words}
    light = category.plain or category.mount == "surface"
    if HANGING in said and (light or category.name in _FROM_CEILING):
        return "ceiling"
    if PROPPED in said and category.mount == "wall":
        return "surface"
    if WALL_MOUNTED in said and (light or category.name in _CAN_HANG) and category.mount != "ceiling":
        return "wall"
    return category.mount
