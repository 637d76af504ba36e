"""The floor that people need who use what stands in a room, and the widths of their ways through it.

The figures are those of the handbooks of interior layout (Neufert, Architects' Data; Time-Saver Standards).
"""

from thinkblox.assets import Use, facts_of
from thinkblox.value import Vec3

SIDE_WAY = 0.6
"""Width that one person walks through [m]."""
MAIN_WAY = 0.9
"""Width that is comfortable [m]."""
DOUBLE = 1.3
"""A bed as wide as this is got into from both sides [m]."""


def uses(category: str, size: Vec3, front: str, clearance: float) -> tuple[Use, ...]:
    """The floor that people need who use such a thing; none for seats, which are moved."""
    facts = facts_of(category)
    if facts.uses:
        return facts.uses
    if facts.is_in("seating") or clearance <= 0.0:
        return ()
    if facts.is_in("lain_on"):
        number = 2 if size[1] >= DOUBLE else 1
        at_sides = Use(sides=("left", "right"), depth=SIDE_WAY, number=number)
        return (Use(sides=("front",), depth=SIDE_WAY, number=1), at_sides)
    return (Use(sides=("front",) if front == "one" else ("front", "back"), depth=clearance, number=1),)
