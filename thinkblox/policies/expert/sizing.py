"""Other sizes of what is to be placed, where its own is too large for a place."""

from thinkblox.value import Vec3

SHRINK = (1.0, 0.85, 0.7, 0.6)
"""Sizes tried, as shares, for what is too large."""


def scaled(size: Vec3, share: float) -> Vec3:
    """A share of a size, to the millimetre [m]."""
    x, y, z = (round(extent * share, 3) for extent in size)
    return (x, y, z)
