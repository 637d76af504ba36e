"""How a row of the catalogue is written."""

from typing import Any

from thinkblox.assets.category import Category, Generator
from thinkblox.value import Vec3


def row(name: str, size: Vec3, mass: float, make: Generator, **more: Any) -> Category:
    """Return a row: a category that stands on the floor unless `more` says otherwise; its noun is its name."""
    noun = more.pop("noun", name.replace("_", " "))
    return Category(name=name, noun=noun, generator=make, size=size, mass=mass, **more)


def large(name: str, size: Vec3, mass: float, make: Generator, **more: Any) -> Category:
    """Return a row: a category that people walk to."""
    return row(name, size, mass, make, large=True, **more)


def wall(name: str, size: Vec3, mass: float, make: Generator, **more: Any) -> Category:
    """Return a row: a category fixed to a wall."""
    return row(name, size, mass, make, mount="wall", **more)


def small_thing(name: str, size: Vec3, mass: float, make: Generator, **more: Any) -> Category:
    """Return a row: a category that stands on other things."""
    return row(name, size, mass, make, **{"mount": "surface", "variation": 0.08} | more)
