"""Cutting a shape down to a rectangle with sides along the axes."""

from typing import Any

import shapely


def clip_to(geometry: Any, x0: float, y0: float, x1: float, y1: float) -> Any:
    """What of a shape, or of each of an array of them, is within a rectangle [m].

    The quick way may give what is not valid, as `shapely.clip_by_rect` says.
    """
    try:
        return shapely.clip_by_rect(geometry, x0, y0, x1, y1)
    except shapely.errors.GEOSException:
        # GEOS clips to a ring of three points where an edge is folded back on itself.
        return shapely.intersection(geometry, shapely.box(x0, y0, x1, y1))
