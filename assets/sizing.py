"""From attributes and a seed to a size."""

import re
from collections.abc import Collection

import numpy as np

from thinkblox.assets.category import Category
from thinkblox.errors import InputError
from thinkblox.value import Vec3

_NUMBERS = {w: n for n, w in enumerate("one two three four five six seven eight nine ten eleven twelve".split(), 1)}
_SCALES: dict[str, Vec3] = {
    "small": (0.75, 0.72, 0.88),
    "little": (0.75, 0.72, 0.88),
    "tiny": (0.6, 0.55, 0.75),
    "large": (1.25, 1.42, 1.15),
    "big": (1.25, 1.42, 1.15),
    "huge": (1.4, 1.65, 1.25),
    "long": (1.0, 1.4, 1.0),
    "wide": (1.0, 1.25, 1.0),
    "short": (1.0, 0.72, 1.0),
    "narrow": (0.84, 0.75, 1.0),
    "slim": (0.85, 0.9, 1.0),
    "deep": (1.2, 1.0, 1.0),
    "shallow": (0.78, 1.0, 1.0),
    "low": (1.0, 1.0, 0.65),
    "tall": (1.0, 1.0, 1.25),
    "high": (1.0, 1.0, 1.25),
    "four-poster": (1.0, 1.0, 2.2),
    "canopy": (1.0, 1.0, 2.2),
    "full-height": (1.0, 1.0, 1.27),
    "child": (0.72, 0.72, 0.72),
    "children": (0.72, 0.72, 0.72),
}


OPEN = "open"
"""What is said of a thing whose doors stand open."""
UPRIGHT = "upright"
"""What is said of a long thing that stands on its end."""
_SMALL_VARIED = 1.8
"""How much more than furniture differs in size what stands on it or hangs."""
COUNTED_PARTS = ("drawer", "door")
"""Parts of which a cabinet is made with as many as are asked for: "3-drawers"."""


def counted(words: Collection[str], part: str) -> int:
    """How many drawers or doors the words ask for ("3-drawers"), 0 if they do not."""
    return next((int(word.partition("-")[0]) for word in sorted(words) if re.fullmatch(rf"[1-9]\d?-{part}s", word)), 0)


def people(words: Collection[str]) -> int:
    """Return for how many people the words ask ("for-6", "for six", "three-seat", "8-person"), 0 if they do not."""
    for word in sorted(words):
        found = re.search(r"\bfor[- ](\w+)|^(\w+?)[- ]?(?:seat|person|people|place)", word)
        token = next((g for g in found.groups() if g), "") if found else ""
        count = int(token) if token.isdigit() else _NUMBERS.get(token, 0)
        if count:
            return count
    return 0


_PLACE, _ENDS = 0.62, 0.65
"""Length of a table for one at its side, who may have more at such tables, and for those at its ends [m]."""
_SAME = 1e-9
"""Lengths that differ by less are the same [m]."""
POLYGONS = {"hexagonal": 6, "octagonal": 8}
"""Words for a top with so many corners."""
_OBLONG = frozenset({"oval", "rectangular"})
_LONGER, _AS_LONG = 1.2, 1.35
"""How many times as long as wide what is oval or oblong is at least, and is made where it usually is not."""
_EVEN = frozenset({"round", "square", "circular"})
"""Words for what is as wide as it is deep, or on a wall as it is high."""


def size_for(category: Category, words: frozenset[str], rng: np.random.Generator) -> Vec3:
    """Return a size for the attributes `words`, varied by `rng`, within what can be made [m]."""
    size = _variant(category, words)
    exact = size is not None
    x, y, z = size or category.size
    seated = _seated(category, size or category.size, people(words), words)
    if not exact or seated[1] > y:
        x, y, z = seated
    for word in sorted(words - set(category.variants)):
        if word in _SCALES:
            sx, sy, sz = _SCALES[word]
            x, y, z = x * sx, y * sy, z * sz
    x, y = _plan(category, x, y, words)
    share = category.variation * (0.35 if exact else 1.0) * (1.0 if category.mount == "floor" else _SMALL_VARIED)
    fx, fy, fz = (1 + share * float(v) for v in rng.uniform(-1, 1, 3))
    if abs(x - y) < _SAME:
        fy = fx
    if category.mount == "wall" and _EVEN & words:
        side = float(np.sqrt(y * z)) * fy
        return _within(category, (x * fx, side, side))
    size = _within(category, (x * fx, y * fy, z * (1 + 0.5 * (fz - 1))))
    if _EVEN & words and abs(x - y) < _SAME:
        size = _within(category, (max(size[:2]), max(size[:2]), size[2]))
    return lain(category, size) if is_stood(category, words) else size


def _variant(category: Category, words: frozenset[str]) -> Vec3 | None:
    """The size that a word stands for; open doors take as much before any other form as before the usual one [m]."""
    named = [word for word in sorted(words) if word in category.variants]
    if len(named) > 1 and OPEN in named and OPEN in category.states:
        x, y, z = category.variants[next(word for word in named if word != OPEN)]
        return (x + category.variants[OPEN][0] - category.size[0], y, z)
    return category.variants[named[0]] if named else None


def is_stood(category: Category, words: Collection[str]) -> bool:
    """Whether a long thing that usually lies, and has no upright form of its own, is stood on its end."""
    return UPRIGHT in words and UPRIGHT not in category.variants and category.long_axis is not None


def sizes_of(category: Category, words: Collection[str]) -> tuple[Vec3, Vec3]:
    """Smallest and largest size that can be made of what the words describe [m]."""
    least, most = category.size_range
    return (lain(category, least), lain(category, most)) if is_stood(category, words) else (least, most)


def lain(category: Category, size: Vec3) -> Vec3:
    """The extents of a long thing lying from those that it has on its end, and the other way round [m]."""
    x, y, z = size
    return (z, y, x) if category.long_axis == 0 else (x, z, y)


def is_degree(word: str) -> bool:
    """Whether a word says how large a thing is, as "small" and "long" do."""
    return word in _SCALES


def scale_of(words: Collection[str]) -> Vec3:
    """How many times the ordinary extents what is called so has; 1 where no word says."""
    scales = np.array([_SCALES[word] for word in words if word in _SCALES] or [(1.0, 1.0, 1.0)])
    x, y, z = scales.prod(axis=0).tolist()
    return (x, y, z)


def _seated(category: Category, size: Vec3, count: int, words: Collection[str]) -> Vec3:
    if not (category.seats and count):
        return size
    x, y, z = size
    if category.front == "one" or category.is_in("seating"):
        return (x, y * (count + 0.35) / (category.seats + 0.35), z)
    if {"round", "circular"} & set(words):
        across = max(0.8, 0.62 * count / np.pi + 0.18)
        return (across, across, z)
    if count <= 2 or (("square" in words or x == y) and count <= 4):
        side = 0.8 if count <= 2 else 0.9
        return (side if x == y else min(x, side), side, z)
    sides = (count - 2) // 2 + (count - 2) % 2
    usual = (category.size[1] - _ENDS) / max(1, (category.seats - 2) // 2)
    return (x, max(_PLACE, usual) * sides + _ENDS, z)


def _plan(category: Category, x: float, y: float, words: Collection[str]) -> tuple[float, float]:
    """Make the plan round, square or oblong where words say so; of a wall thing they say that of its face."""
    corners = next((count for word, count in POLYGONS.items() if word in words), 0)
    if category.mount == "wall" or not (corners or (_EVEN | _OBLONG) & set(words)):
        return x, y
    side = float(np.sqrt(x * y))
    if not corners and not _EVEN & set(words):
        return (x, y) if max(x, y) >= _LONGER * min(x, y) else (side / _AS_LONG**0.5, side * _AS_LONG**0.5)
    return (side, side) if corners % 4 == 0 else (side, side / float(np.cos(np.pi / corners)))


def _within(category: Category, size: Vec3) -> Vec3:
    least, most = category.size_range
    step = 0.01 if max(size) > 0.4 else 0.002
    x, y, z = (
        round(min(max(round(s / step) * step if s > 10 * step else s, lo), hi), 4)
        for s, lo, hi in zip(size, least, most, strict=True)
    )
    return (x, y, z)


def checked_size(category: Category, size: Vec3, words: Collection[str] = ()) -> Vec3:
    """Return `size` to a tenth of a millimetre; raises InputError naming the range when it cannot be made."""
    least, most = sizes_of(category, words)
    x, y, z = (round(float(s), 4) for s in size)
    if not all(lo - 1e-9 <= s <= hi + 1e-9 for s, lo, hi in zip((x, y, z), least, most, strict=True)):
        ranges = ", ".join(
            f"{name} {lo:g} to {hi:g}" for name, lo, hi in zip(("depth", "width", "height"), least, most, strict=True)
        )
        raise InputError(f"a {category.noun} cannot be made {x:g} x {y:g} x {z:g} m; it can have {ranges} m")
    return (x, y, z)
