"""Colour words, by lightness, chroma and hue in CIELAB."""

import math
import tomllib
from functools import cache
from importlib.resources import files
from typing import Any

from thinkblox.evaluation.room_file import Vec3

_TABLE = "looks.toml"
_SHADES: dict[str, tuple[float, float]] = {
    "dark": (0.0, 52.0),
    "deep": (0.0, 55.0),
    "light": (55.0, 100.0),
    "pale": (65.0, 100.0),
    "pastel": (68.0, 100.0),
    "bright": (40.0, 100.0),
    "warm": (0.0, 100.0),
    "soft": (0.0, 100.0),
    "dusty": (0.0, 100.0),
}
"""Words before a colour, and the lightness that they leave to it."""
_WHITE = (0.95047, 1.0, 1.08883)
_TO_XYZ = (
    (0.4124564, 0.3575761, 0.1804375),
    (0.2126729, 0.7151522, 0.0721750),
    (0.0193339, 0.1191920, 0.9503041),
)


def lch(srgb: Vec3) -> Vec3:
    """Lightness, chroma and hue [degrees] of an sRGB colour, 0 to 1: CIE LCh(ab) under D65."""
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in srgb]
    xyz = [sum(m * c for m, c in zip(row, linear, strict=True)) for row in _TO_XYZ]
    fx, fy, fz = (_cube_root(v / w) for v, w in zip(xyz, _WHITE, strict=True))
    a, b = 500.0 * (fx - fy), 200.0 * (fy - fz)
    return (116.0 * fy - 16.0, math.hypot(a, b), math.degrees(math.atan2(b, a)) % 360.0)


def _cube_root(t: float) -> float:
    return t ** (1 / 3) if t > (6 / 29) ** 3 else t / (3 * (6 / 29) ** 2) + 4 / 29


def is_colour_word(word: str) -> bool:
    """Whether it says a colour, such as "mustard" or "light blue"."""
    return _colour(word) is not None


def looks(word: str, srgb: Vec3) -> bool:
    """Whether a colour is called so; raises KeyError for no colour word."""
    found = _colour(word)
    if found is None:
        raise KeyError(word)
    name, (low, high) = found
    lightness = lch(srgb)[0]
    return low <= lightness <= high and any(in_box(box, srgb) for box in looks_table()["colours"][name])


def in_box(box: dict[str, Any], srgb: Vec3) -> bool:
    """Whether a colour lies in a box of lightness, chroma and hue."""
    lightness, chroma, hue = lch(srgb)
    from_hue, to_hue = box.get("hue", (0.0, 360.0))
    turned = (hue - from_hue) % 360.0 <= (to_hue - from_hue) % 360.0 if "hue" in box else True
    return turned and _between(lightness, box.get("light")) and _between(chroma, box.get("chroma"))


def _between(value: float, limits: list[float] | None) -> bool:
    return limits is None or limits[0] <= value <= limits[1]


def _colour(word: str) -> tuple[str, tuple[float, float]] | None:
    table, word = looks_table(), word.lower().replace("-", " ")
    name = table["colour_names"].get(word, word)
    if name in table["colours"]:
        return name, (0.0, 100.0)
    shade, _, rest = word.partition(" ")
    if shade in _SHADES and (found := _colour(rest)) is not None:
        return found[0], _SHADES[shade]
    return None


@cache
def looks_table() -> dict[str, Any]:
    """Words of colour and material."""
    return tomllib.loads(files("thinkblox.evaluation").joinpath(_TABLE).read_text("utf-8"))
