"""What lengths said of a thing mean for it: "a 2 m long sofa", "a 65-inch TV", "a rug of 2 by 3 m"."""

from thinkblox.brief import Measures
from thinkblox.errors import InputError
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.sizes import Length, Size

_WIDE, _TALL = 0.872, 0.49
"""Sides of a 16:9 screen as shares of its diagonal."""
_LONGEST = 50.0
"""Longest extent that a prompt may give a thing [m]."""
_STAND = 0.06
"""What the foot of a screen adds to its height [m]."""
_LENGTHWISE = 1.85
"""From here on a single length of a bed is its length, not its width [m]."""


def object_size(category: str, size: Size | None) -> Measures:
    """Depth, width and height that a prompt gives a thing [m], in the order of an asset's size; None where it does not.

    Without a named axis the longer side of a table or rug lies across its front, that of a bed along it; a thing on the
    wall is given by width and height; the length of a screen is its diagonal.
    """
    if size is None or size.area is not None:
        return (None, None, None)
    if not all(0.0 < length.metres <= _LONGEST for length in size.lengths):
        raise InputError(f"the size {size.text!r} of a {category} cannot be used: it is not 0 to {_LONGEST:g} m")
    if load_habits().is_in(category, "screens") and len(size.lengths) == 1 and not size.lengths[0].axis:
        diagonal = size.lengths[0].metres
        return (None, round(_WIDE * diagonal, 3), round(_TALL * diagonal + _STAND, 3))
    depth, width, height = _unnamed(category, [length for length in size.lengths if not length.axis])
    named = {length.axis: round(length.metres, 4) for length in size.lengths}
    across = named.get("diameter")
    long = named.get("length")
    if load_habits().is_in(category, "lengthwise"):
        depth, long = long or depth, None
    elif long and "width" in named and "depth" not in named:
        depth, named["width"] = named["width"], long
    return (
        named.get("depth") or across or depth,
        named.get("width") or across or long or width,
        named.get("height") or height,
    )


def _unnamed(category: str, lengths: list[Length]) -> Measures:
    sides = [round(length.metres, 4) for length in lengths]
    lengthwise = load_habits().is_in(category, "lengthwise")
    if not sides:
        return (None, None, None)
    if len(sides) == 1:
        if load_habits().is_in(category, "upright"):
            return (None, None, sides[0])
        return (sides[0], None, None) if lengthwise and sides[0] > _LENGTHWISE else (None, sides[0], None)
    if load_habits().is_in(category, "wallpieces"):
        return (None, sides[0], sides[1])
    short, long = sorted(sides[:2])
    height = sides[2] if len(sides) == 3 else None
    return (long, short, height) if lengthwise else (short, long, height)
