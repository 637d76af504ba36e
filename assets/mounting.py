"""What a thing is placed on: as its category says, or on a wall where the words say so and it can hang there."""

from collections.abc import Collection

from thinkblox.assets.category import Category
from thinkblox.scene.asset import Mount

WALL_MOUNTED = "wall-mounted"
_CAN_HANG = frozenset(
    {
        "bedside_cabinet",
        "bicycle",
        "bookcase",
        "cabinet",
        "credenza",
        "dresser",
        "guitar",
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
"""Categories that usually stand, and are hung on walls too."""


def mount_of(category: Category, words: Collection[str]) -> Mount:
    """What one of a category that the words describe is placed on."""
    hangs = category.name in _CAN_HANG and WALL_MOUNTED in {word.lower().replace("_", "-") for word in words}
    return "wall" if hangs else category.mount
