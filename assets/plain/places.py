"""Where plain things are kept: the last but one column of the table, and what it says of mount, groups and habits."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from thinkblox.assets.facts import Hanging, RowGaps
from thinkblox.scene.asset import Gaze, Mount


@dataclass(frozen=True, kw_only=True)
class Keeping:
    """How a plain thing is kept.

    Attributes:
        clearance: depth to keep free before its front [m].
        large: people walk to it.
        flat: it is walked on.
        gaze: which way one looks who uses it.
        row: how several stand in rows.
    """

    mount: Mount
    habits: tuple[str, ...]
    groups: tuple[str, ...] = ()
    clearance: float = 0.0
    large: bool = False
    flat: bool = False
    hanging: Hanging = field(default_factory=Hanging)
    gaze: Gaze = "front"
    row: RowGaps = field(default_factory=RowGaps)


def _small(*anchors: str, also: tuple[str, ...] = ()) -> Keeping:
    """What is kept on these anchors, or else on any surface."""
    habits = tuple(f"on {anchor}" for anchor in dict.fromkeys((*anchors, "@surfaces")))
    return Keeping(mount="surface", groups=("small",), habits=(*habits, *also))


def _standing(*habits: str, groups: tuple[str, ...] = (), clearance: float = 0.0, large: bool = False) -> Keeping:
    return Keeping(mount="floor", habits=habits, groups=groups, clearance=clearance, large=large)


def _hung(middle: float, above: float = 0.2) -> Keeping:
    hanging = Hanging(middle=middle, above=above)
    return Keeping(mount="wall", habits=("against_wall wall",), groups=("wallpieces",), hanging=hanging)


KEEPING: Mapping[str, Keeping] = {
    "kitchen": _small("@worktops", "@counters", "@meal_tables", "@shelves"),
    "table": _small("@meal_tables", "@counters", "@worktops", "@low_tables"),
    "lounge": _small("@low_tables", "@storage", "@shelves", "@tables"),
    "desk": _small("@desks", "@tables", "@shelves"),
    "shelf": _small("@shelves", "@storage", "@tables"),
    "bath": _small("@basins", "@worktops", "@shelves", "@storage"),
    "night": _small("nightstand", "dresser", "@desks", "@storage"),
    "work": _small("workbench", "@shelves", "@desks", "@tables"),
    "shop": _small("@counters", "display_table", "@shelves"),
    "lab": _small("@worktops", "workbench", "@desks", "@tables", "@shelves"),
    "clothes": _small("@beds", "@storage", "@shelves", "bench"),
    "bed": _small("@beds", "@lounges", "@storage"),
    "toys": _small("play_table", "@shelves", "toy_box", "@storage"),
    "floor": _standing("against_wall wall"),
    "by_seat": _standing("near stool", "near piano_bench", "near chair", "in_corner corner"),
    "door": _standing("near door", "against_wall wall"),
    "corner": _standing("in_corner corner", "against_wall wall", groups=("in_corners",)),
    "middle": _standing("in_centre centre", groups=("stands_free",), large=True),
    "driven": _standing("in_centre centre", groups=("stands_free", "driven_out"), large=True),
    "sanctuary": _standing("near altar", "against_wall wall", clearance=0.4, large=True),
    "furniture": _standing("against_wall wall", clearance=0.6, large=True),
    "machine": _standing("against_wall wall", clearance=0.7, large=True),
    "storage": _standing("against_wall wall", groups=("storage", "surfaces", "cases"), clearance=0.6, large=True),
    "goods": _standing(
        "against_wall wall",
        groups=("storage", "surfaces", "cases", "takes_goods"),
        clearance=0.6,
        large=True,
    ),
    "tables": _standing("in_centre centre", groups=("tables", "surfaces"), clearance=0.4, large=True),
    "benches": Keeping(
        mount="floor",
        habits=("against_wall wall",),
        groups=("worktops", "worked_at", "long_sides", "surfaces"),
        clearance=0.7,
        large=True,
        gaze="back",
        row=RowGaps(beside=(0.6, 0.3, 0.08), aisle=(1.2, 1.0, 0.85)),
    ),
    "islands": Keeping(
        mount="floor",
        habits=("against_wall wall",),
        groups=("worktops", "worked_at", "long_sides", "surfaces", "islands"),
        clearance=0.7,
        large=True,
        gaze="back",
        row=RowGaps(beside=(0.6, 0.3, 0.08), aisle=(1.4, 1.2, 1.0), abreast=1),
    ),
    "window_seats": _standing("near window", "against_wall wall", groups=("seats", "seating"), clearance=0.4),
    "seats": _standing("against_wall wall", groups=("seats", "seating"), clearance=0.4),
    "beds": _standing("against_wall wall", groups=("lain_on",), clearance=0.5, large=True),
    "couches": Keeping(
        mount="floor",
        habits=("against_wall wall",),
        groups=("lain_on", "treated_on"),
        clearance=0.5,
        large=True,
        row=RowGaps(beside=(0.9, 0.7), aisle=(1.1, 0.9)),
    ),
    "wall": _hung(1.5),
    "low_wall": _hung(0.7),
    "high_wall": _hung(2.1),
    "ceiling": Keeping(mount="ceiling", habits=("in_centre centre",), groups=("ceiling",)),
    "cover": Keeping(mount="floor", habits=("in_centre centre",), groups=("covers",), flat=True),
}
"""Every way of keeping a thing that the table knows."""
Front = Literal["one", "two", "any"]
