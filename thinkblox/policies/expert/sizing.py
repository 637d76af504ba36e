"""Other sizes of what is to be placed, where its own is too large for a place."""

from thinkblox.value import Vec3

SHRINK = (1.0, 0.85, 0.7, 0.6)
"""Sizes tried, as shares, for what is too large."""


def scaled(size: Vec3, share: float) -> Vec3:
    """A share of a size, to the millimetre [m]."""
    x, y, z = (round(extent * share, 3) for extent in size)
    return (x, y, z)


def shares_of(size: Vec3, sizes: tuple[Vec3, Vec3] | None) -> tuple[float, ...]:
    """The shares at which a thing is no smaller than it can be, by its least and greatest size; its own among them."""
    least = size if sizes is None else sizes[0]
    fits = (all(a >= min(b, c) for a, b, c in zip(scaled(size, share), least, size, strict=True)) for share in SHRINK)
    return tuple(share for share, possible in zip(SHRINK, fits, strict=True) if possible or share == 1.0)
