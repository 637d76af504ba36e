"""What the catalogue says of a category."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Literal, get_args

from thinkblox.assets.facts import Facts
from thinkblox.assets.part import Build
from thinkblox.assets.spec import Spec
from thinkblox.scene.asset import Mount
from thinkblox.value import Vec3

SLENDER, LONGEST = 2.5, 1.7
"""Times its other sides from which a thing is long and thin, and how long it is at most to be stood on its end [m]."""
Front = Literal["one", "two", "any"]
FRONTS = get_args(Front)
Generator = Callable[[Spec], Build]


@dataclass(frozen=True, kw_only=True)
class Category(Facts):
    """One kind of thing that can be made, and all that is known of it.

    Attributes:
        name: in snake_case, as in ids.
        noun: for people ("floor lamp").
        generator: makes it.
        size: of an ordinary one (along the front axis, across, up) [m].
        mass: of one of that size [kg].
        mount: what it is placed on.
        front: how many ways round look the same.
        friction: sliding coefficient.
        clearance: depth to keep free before its front [m].
        variation: share by which the seed changes each length.
        variants: sizes that attributes stand for.
        seats: how many a reference one seats; 0 where "for six" means nothing.
        large: people walk to it: it needs walkable access.
        flat: a rug or mat, that is walked on.
        low, high: sizes that can be made, as shares of the smallest and largest of its sizes.
        plain: it is a plain stand-in: size, mass and colours are its own, and its shape is only a hint.
    """

    name: str
    noun: str
    generator: Generator
    size: Vec3
    mass: float
    mount: Mount = "floor"
    front: Front = "one"
    friction: float = 0.5
    clearance: float = 0.0
    variation: float = 0.06
    variants: Mapping[str, Vec3] = field(default_factory=dict)
    seats: int = 0
    large: bool = False
    flat: bool = False
    low: float = 0.5
    high: float = 2.0
    plain: bool = False

    @property
    def long_axis(self) -> int | None:
        """Along which level axis it lies where it is long and thin, such as a pencil; None for anything else."""
        axis = 0 if self.size[0] >= self.size[1] else 1
        others = max(self.size[1 - axis], self.size[2])
        small = self.mount in ("floor", "surface") and not self.flat and self.size[axis] <= LONGEST
        return axis if small and self.size[axis] >= SLENDER * others else None

    @property
    def size_range(self) -> tuple[Vec3, Vec3]:
        """Smallest and largest size that can be made [m]."""
        sizes = (self.size, *self.variants.values())
        least = [round(self.low * min(s[i] for s in sizes), 4) for i in range(3)]
        most = [round(self.high * max(s[i] for s in sizes), 4) for i in range(3)]
        return (least[0], least[1], least[2]), (most[0], most[1], most[2])

    @property
    def largest_shut(self) -> Vec3:
        """Largest size that can be made with its doors shut [m]."""
        sizes = (self.size, *(size for name, size in self.variants.items() if name not in self.states))
        most = [round(self.high * max(s[i] for s in sizes), 4) for i in range(3)]
        return (most[0], most[1], most[2])
