"""What a generator is asked to make."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from thinkblox.assets.palette import ASH, MARBLE, WALNUT, WICKER, Style, colour_of, wood_of
from thinkblox.assets.part import Finish
from thinkblox.value import Vec3

T = TypeVar("T")


@dataclass(frozen=True)
class Spec:
    """One piece of furniture to make.

    Attributes:
        category: its name in the catalogue.
        size: the box to fill (along the front axis, across, up) [m].
        words: attributes, in lower case.
        rng: draws the details.
    """

    category: str
    size: Vec3
    words: frozenset[str]
    style: Style
    rng: np.random.Generator

    def has(self, *words: str) -> bool:
        """Whether any of `words` was asked for."""
        return any(word in self.words for word in words)

    def choice(self, options: Sequence[T]) -> T:
        """Draw one of `options`."""
        return options[int(self.rng.integers(len(options)))]

    def between(self, low: float, high: float) -> float:
        """Draw a number."""
        return float(self.rng.uniform(low, high))

    def main(self, usual: Finish) -> Finish:
        """Return the finish of its main parts: `usual` unless a colour or a wood was asked for."""
        named, colour = wood_of(self.words), colour_of(self.words)
        if colour:
            return Finish(colour, named.material if named else usual.material)
        if named:
            return named
        return self._of_material(usual) if usual.material == "wood" else usual

    def _of_material(self, usual: Finish) -> Finish:
        """What stands for wood when another material, or a tone of wood, was asked for."""
        tones = {"metal": self.style.metal, "stone": MARBLE, "wicker": WICKER, "dark": WALNUT, "light": ASH}
        tones["plastic"] = Finish(usual.colour, "plastic")
        return next((finish for word, finish in tones.items() if word in self.words), usual)

    @property
    def wood(self) -> Finish:
        """Main finish of a wooden piece."""
        return self.main(self.style.wood)

    @property
    def paint(self) -> Finish:
        """Main finish of a cabinet."""
        return self.main(self.style.paint)

    @property
    def fabric(self) -> Finish:
        """Main finish of an upholstered piece."""
        if self.has("leather"):
            return Finish(colour_of(self.words) or (0.48, 0.29, 0.18), "leather")
        colour = colour_of(self.words)
        return Finish(colour, "fabric") if colour else self.style.fabric
