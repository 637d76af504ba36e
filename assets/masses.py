"""How heavy furniture is. Category masses are averages published for furniture reuse, or common goods' own."""

from math import prod

from thinkblox.assets.category import Category
from thinkblox.value import Vec3


def mass_of(category: Category, size: Vec3) -> float:
    """Return the mass of one of `size`: in proportion to its box, within 0.4 to 2.5 times the category's [kg]."""
    ratio = prod(size) / prod(category.size)
    mass = category.mass * min(2.5, max(0.4, ratio))
    return round(mass, 1) if mass >= 10 else float(f"{mass:.3g}")
