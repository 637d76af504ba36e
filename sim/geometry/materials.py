"""How heavy a part is that is made of something: a skin of full density, and what fills it."""

from dataclasses import dataclass

from thinkblox.scene.asset import Material


@dataclass(frozen=True)
class Stuff:
    """What parts of a material usually are.

    Attributes:
        skin: how thick their walls are, at most [m].
        density: of the walls [kg/m3].
        filling: density of what is within the walls [kg/m3]: nothing much, foam, or the same again.
    """

    skin: float
    density: float
    filling: float


STUFF: dict[Material, Stuff] = {
    "wood": Stuff(0.02, 650.0, 60.0),
    "metal": Stuff(0.0015, 7800.0, 40.0),
    "fabric": Stuff(0.002, 250.0, 45.0),
    "leather": Stuff(0.002, 800.0, 45.0),
    "glass": Stuff(0.004, 2500.0, 0.0),
    "ceramic": Stuff(0.008, 2300.0, 0.0),
    "plastic": Stuff(0.0025, 1050.0, 60.0),
    "paper": Stuff(0.03, 700.0, 100.0),
    "leaf": Stuff(0.001, 700.0, 5.0),
    "stone": Stuff(0.05, 2300.0, 1500.0),
    "light": Stuff(0.0005, 1000.0, 0.0),
    "screen": Stuff(0.002, 2000.0, 300.0),
}
"""What furniture and goods are made of, as they are commonly made: carcasses of boards, tubes and sheets, foam."""


def usual_weight(material: Material, volume: float, area: float) -> float:
    """What a convex part of a volume [m3] and a surface [m2] usually weighs [kg]."""
    stuff = STUFF[material]
    walls = min(volume, area * stuff.skin)
    return walls * stuff.density + (volume - walls) * stuff.filling
