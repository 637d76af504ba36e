"""How each material answers to light, and the colours round a room."""

from dataclasses import dataclass
from typing import get_args

from thinkblox.scene.asset import Material
from thinkblox.scene.visuals import Look

Colour = tuple[float, float, float]

MATERIALS: tuple[str, ...] = (*get_args(Material), "wall", "floor", "trim", "cut", "pane", "ground")
"""The materials of assets, and those of the room: "pane" is a window's view, "cut" where a wall was cut open."""


@dataclass(frozen=True)
class Reflectance:
    """Reflection of a material.

    Attributes:
        diffuse: share of its colour that it scatters.
        mirror: reflection straight on (Schlick's F0).
        gloss: exponent of its highlight.
        tinted: whether reflections take the material's colour, as in metal.
        sheen: brightening at grazing angles, as in cloth.
        glow: emitted light as a multiple of its colour.
    """

    diffuse: float = 1.0
    mirror: float = 0.0
    gloss: float = 10.0
    tinted: bool = False
    sheen: float = 0.0
    glow: float = 0.0


FINISHES: dict[str, Reflectance] = {
    "wood": Reflectance(mirror=0.022, gloss=28.0),
    "metal": Reflectance(diffuse=0.45, mirror=0.55, gloss=60.0, tinted=True),
    "fabric": Reflectance(sheen=0.14),
    "leather": Reflectance(mirror=0.03, gloss=18.0),
    "glass": Reflectance(diffuse=0.15, mirror=0.08, gloss=150.0),
    "ceramic": Reflectance(mirror=0.05, gloss=90.0),
    "plastic": Reflectance(mirror=0.03, gloss=35.0),
    "paper": Reflectance(),
    "leaf": Reflectance(mirror=0.02, gloss=14.0, sheen=0.08),
    "stone": Reflectance(mirror=0.03, gloss=30.0),
    "light": Reflectance(diffuse=0.25, glow=1.6),
    "screen": Reflectance(diffuse=0.8, mirror=0.06, gloss=160.0),
    "wall": Reflectance(),
    "floor": Reflectance(mirror=0.028, gloss=36.0),
    "trim": Reflectance(mirror=0.02, gloss=30.0),
    "cut": Reflectance(),
    "pane": Reflectance(diffuse=0.0, glow=1.45),
    "ground": Reflectance(),
}

SILVER: Colour = (0.80, 0.85, 0.88)
"""The colour of metal in which one sees oneself."""
CUT: Colour = (0.80, 0.775, 0.735)
GROUND: Colour = (0.875, 0.855, 0.825)


def linear(colour: Colour) -> Colour:
    """Linear RGB of an sRGB colour."""
    r, g, b = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour)
    return (r, g, b)


def reflectance_of(look: Look) -> Reflectance:
    """The reflection of a metal-rough surface; its highlight is as wide as that of the roughness."""
    metal, rough = look.metallic, max(look.roughness, 0.2)
    mirror = (1.0 - metal) * 0.06 * (1.0 - look.roughness) + metal * FINISHES["metal"].mirror
    diffuse = 1.0 - metal * (1.0 - FINISHES["metal"].diffuse)
    return Reflectance(diffuse=diffuse, mirror=mirror, gloss=max(2.0 / rough**4 - 2.0, 2.0), tinted=metal > 0.5)
