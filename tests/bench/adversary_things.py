"""Things that are hard to judge, each made out of a genome: a list of numbers in 0 to 1 that a search can vary."""

import math
from collections.abc import Sequence
from typing import TypeVar

import numpy as np
from msgspec import structs
from numpy.typing import NDArray

from tests.sim_rooms import asset, box
from thinkblox.scene.asset import Asset, Mount, Shape

T = TypeVar("T")
GENES = 96
"""Numbers in a genome; a case that reads more starts over with the first."""


class Genes:
    """Reads a genome from its beginning, one number for every question."""

    def __init__(self, values: NDArray[np.float64]) -> None:
        self._values = values.tolist()
        self._next = 0

    def share(self) -> float:
        """The next number, 0 to 1."""
        value = float(self._values[self._next % len(self._values)])
        self._next += 1
        return value

    def between(self, low: float, high: float) -> float:
        """A number between two others."""
        return low + (high - low) * self.share()

    def magnitude(self, low: float, high: float) -> float:
        """The same, every order of magnitude being as likely."""
        return math.exp(self.between(math.log(low), math.log(high)))

    def among(self, options: Sequence[T]) -> T:
        """One of several."""
        return options[min(int(self.share() * len(options)), len(options) - 1)]

    def gap(self) -> float:
        """Height over what is below: nothing in half of all cases, else up to 12 mm, or half a millimetre in it [m]."""
        kind = self.share()
        size = self.share()
        return 0.0 if kind < 0.5 else (0.012 * size if kind < 0.9 else -0.0005 * size)


def made_of(name: str, shapes: Sequence[Shape], *, mass: float, friction: float, mount: Mount = "floor") -> Asset:
    """An asset of upright boxes, cylinders and balls, moved so that its footprint's middle and base are the origin."""
    low = np.min([np.subtract(s.position, np.divide(s.size, 2)) for s in shapes], axis=0)
    high = np.max([np.add(s.position, np.divide(s.size, 2)) for s in shapes], axis=0)
    middle = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    moved = [structs.replace(s, position=tuple(np.subtract(s.position, middle).tolist())) for s in shapes]
    size = tuple((high - low).tolist())
    return asset(name, size, *moved, mass=mass, friction=friction, mount=mount)


def anything(genes: Genes, name: str, *, wide: tuple[float, float], tall: tuple[float, float]) -> Asset:
    """A block, drum, pole, bust, tripod, table, pair of feet, board or ball: footprint and height within ranges [m]."""
    form = genes.among((block, drum, pole, bust, tripod, legs, feet, board, ball))
    x, y, z = genes.magnitude(*wide), genes.magnitude(*wide), genes.magnitude(*tall)
    mass, friction = genes.magnitude(0.05, 200.0), genes.between(0.2, 1.0)
    return made_of(name, form(genes, x, y, z), mass=mass, friction=friction)


def slab(genes: Genes, name: str, *, wide: tuple[float, float], thick: tuple[float, float]) -> Asset:
    """A flat box or disc that others can lie on, of 0.05 to 200 kg."""
    x, y, z = genes.magnitude(*wide), genes.magnitude(*wide), genes.magnitude(*thick)
    form = genes.among((block, drum))
    mass, friction = genes.magnitude(0.05, 200.0), genes.between(0.2, 1.0)
    return made_of(name, form(genes, x, y, z), mass=mass, friction=friction)


def block(genes: Genes, x: float, y: float, z: float) -> list[Shape]:
    """A box."""
    return [box((x, y, z), (0.0, 0.0, z / 2))]


def drum(genes: Genes, x: float, y: float, z: float) -> list[Shape]:
    """An upright cylinder."""
    return [Shape(kind="cylinder", size=(x, x, z), position=(0.0, 0.0, z / 2))]


def pole(genes: Genes, x: float, y: float, z: float) -> list[Shape]:
    """A mast that stands somewhere on its foot, or past its edge."""
    foot, mast = min(0.05, z / 4), min(x, y) * genes.between(0.2, 0.8)
    dx, dy = genes.between(-0.8, 0.8) * x, genes.between(-0.4, 0.4) * y
    return [box((x, y, foot), (0.0, 0.0, foot / 2)), box((mast, mast, z - foot), (dx, dy, (z + foot) / 2))]


def bust(genes: Genes, x: float, y: float, z: float) -> list[Shape]:
    """A head on a mast on a foot, the head not over the middle."""
    foot, thin, head = z * 0.08, min(x, y) * 0.15, genes.between(0.3, 1.2)
    dx, dy = genes.between(-0.7, 0.7) * x, genes.between(-0.7, 0.7) * y
    size = (x * head, y * head, z * 0.2)
    parts = [box((x, y, foot), (0.0, 0.0, foot / 2)), box((thin, thin, z * 0.8), (0.0, 0.0, z * 0.4))]
    return [*parts, box(size, (dx, dy, z * 0.9))]


def tripod(genes: Genes, x: float, y: float, z: float) -> list[Shape]:
    """A top on three thin legs."""
    leg, turn = min(x, y) * genes.between(0.04, 0.2), genes.between(0.0, 2 * math.pi)
    angles = [turn + i * 2 * math.pi / 3 for i in range(3)]
    top = box((x, y, z * 0.1), (0.0, 0.0, z * 0.95))
    spread = (min(x, y) - leg) / 2 * genes.between(0.3, 1.0)
    places = [(spread * math.cos(a), spread * math.sin(a), z * 0.45) for a in angles]
    return [top, *(box((leg, leg, z * 0.9), place) for place in places)]


def legs(genes: Genes, x: float, y: float, z: float) -> list[Shape]:
    """A table whose legs may be shorter than each other by up to 2 mm."""
    leg = min(x, y) * genes.between(0.05, 0.2)
    top = box((x, y, z * 0.1), (0.0, 0.0, z * 0.95))
    shapes = [top]
    for sx in (-1, 1):
        for sy in (-1, 1):
            short = max(0.0, genes.between(-0.004, 0.002))
            size = (leg, leg, z * 0.9 - short)
            shapes.append(box(size, (sx * (x - leg) / 2, sy * (y - leg) / 2, z * 0.9 - size[2] / 2)))
    return shapes


def feet(genes: Genes, x: float, y: float, z: float) -> list[Shape]:
    """A screen on two narrow feet."""
    thin = min(x * 0.3, 0.04)
    screen = box((thin, y, z * 0.95), (genes.between(-0.5, 0.5) * x, 0.0, z * 0.525))
    return [screen, *(box((x, y * 0.05, z * 0.05), (0.0, s * y * 0.4, z * 0.025)) for s in (-1, 1))]


def board(genes: Genes, x: float, y: float, z: float) -> list[Shape]:
    """A board on its edge."""
    return [box((genes.magnitude(0.005, 0.04), y, z), (0.0, 0.0, z / 2))]


def ball(genes: Genes, x: float, y: float, z: float) -> list[Shape]:
    """A ball, or a capsule that stands on its end."""
    if genes.share() < 0.5:
        return [Shape(kind="sphere", size=(x, x, x), position=(0.0, 0.0, x / 2))]
    return [Shape(kind="capsule", size=(x, x, x + z), position=(0.0, 0.0, (x + z) / 2))]
