"""Numbers in place of names on a plan with many objects, and the list that says what they mean."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from thinkblox.scene.placement import Placement
from thinkblox.sim.render.labels import Measure

MOST_NAMED = 25
"""Beyond so many objects a plan has numbers."""

_FEW = 4
"""Up to so many of a kind on one thing each have their number."""


@dataclass(frozen=True)
class Legend:
    """What stands under a plan.

    Attributes:
        numbers: of each category.
        entries: what is written, in the order of the numbers.
        columns, rows: how the entries are arranged, column by column.
        line: height of an entry [pixels].
        font: its size.
    """

    numbers: dict[str, int]
    entries: tuple[str, ...]
    columns: int
    rows: int
    line: float
    font: int

    @property
    def height(self) -> int:
        """Height of the whole [pixels]."""
        return round(self.line * (self.rows + 1))

    def places(self, size: int) -> list[tuple[str, tuple[float, float]]]:
        """Each entry and the middle of its left end, in a picture `size` wide, from the top of the legend [pixels]."""
        wide = size * 0.94 / self.columns
        at = [
            (size * 0.03 + i // self.rows * wide, (i % self.rows + 0.5) * self.line) for i in range(len(self.entries))
        ]
        return list(zip(self.entries, at, strict=True))


def legend_of(placements: Sequence[Placement], measure: Measure, size: int, font: int) -> Legend:
    """A number for each category, the most frequent first, in as many columns as there is room for."""
    counts = sorted(Counter(p.category for p in placements).items(), key=lambda item: (-item[1], item[0]))
    numbers = {category: number for number, (category, _) in enumerate(counts, 1)}
    entries = tuple(
        f"{numbers[category]}  {category.replace('_', ' ')}" + (f" ({count})" if count > 1 else "")
        for category, count in counts
    )
    widest = max(measure(entry, font)[0] for entry in entries) + 2 * font
    columns = max(min(int(size * 0.94 / widest), len(entries)), 1)
    return Legend(numbers, entries, columns, -(-len(entries) // columns), measure("1", font)[1] * 1.1, font)


def numbered(placements: Sequence[Placement], legend: Legend) -> list[tuple[str, tuple[Placement, ...]]]:
    """Each number to be written and what it is written on: one thing, or all of a kind that one thing carries."""
    ids = {p.id for p in placements}
    groups: dict[tuple[str, str], list[Placement]] = {}
    for placement in placements:
        carrier = placement.support if placement.support in ids else placement.id
        groups.setdefault((placement.category, carrier), []).append(placement)
    found: list[tuple[str, tuple[Placement, ...]]] = []
    for (category, _), members in groups.items():
        together = [tuple(members)] if len(members) > _FEW else [(member,) for member in members]
        found += [(str(legend.numbers[category]), some) for some in together]
    return found
