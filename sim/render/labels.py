"""Where the names go on a plan: inside their objects where they fit, beside them with a line where they do not."""

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.placement import Placement

Box = tuple[float, float, float, float]
"""left, top, right, bottom [pixels]."""
Measure = Callable[[str, int], tuple[float, float]]
"""Width and height of a text at a font size [pixels]."""


_OVER = 0.5
"""Share of a thing that lies over its like where both have one label."""
_HALO = 1 / 6
"""Of a font's size is the width of the light line about a text."""
CROWD = 7
"""From this many of a kind on, their names are short."""


@dataclass(frozen=True)
class Labelled:
    """Something to be named: its names from the fullest to the shortest, and its place in the picture [pixels]."""

    id: str
    names: tuple[str, ...]
    box: Box

    @property
    def centre(self) -> tuple[float, float]:
        """Middle of its box."""
        return (self.box[0] + self.box[2]) / 2, (self.box[1] + self.box[3]) / 2

    @property
    def area(self) -> float:
        """Area of its box."""
        return (self.box[2] - self.box[0]) * (self.box[3] - self.box[1])


@dataclass(frozen=True)
class Label:
    """A name at a place: the centre of the text, its font size, and where a line to the object ends, if one is due."""

    id: str
    text: str
    at: tuple[float, float]
    font: int
    line_to: tuple[float, float] | None = None


def names_of(placements: Sequence[Placement]) -> dict[str, tuple[str, ...]]:
    """What each object can be called, by id: "bed"; "dining chair 3", "chair 3" or "3" where there are several."""
    counts = Counter(p.category for p in placements)
    return {p.id: _names(p, counts[p.category]) for p in placements}


def _names(placement: Placement, count: int) -> tuple[str, ...]:
    words = placement.category.replace("_", " ").split()
    if count == 1:
        return (" ".join(words), "\n".join(words)) if len(words) > 1 else (words[0],)
    number = placement.id.rsplit("_", 1)[-1]
    full, last = " ".join(words), words[-1]
    if count >= CROWD:
        return f"{last} {number}", number
    names = (f"{full} {number}", "\n".join([*words[:-1], f"{last} {number}"]), f"{last} {number}", number)
    return tuple(dict.fromkeys(names))


def one_over_another(placements: Sequence[Placement]) -> list[tuple[Placement, ...]]:
    """The placements, alike ones together that lie over each other: the bins on the boards of a shelf."""
    stacks: list[list[Placement]] = []
    for placement in placements:
        alike = (s for s in stacks if (s[0].category, s[0].support) == (placement.category, placement.support))
        over = (s for s in alike if placement.support != "floor" and _share_over(placement, s[0]) > _OVER)
        stack = next(over, None)
        if stack is None:
            stacks.append([placement])
        else:
            stack.append(placement)
    return [tuple(stack) for stack in stacks]


def _share_over(placement: Placement, other: Placement) -> float:
    """Share of a thing's footprint that lies over or under another's."""
    return float(placement.footprint.intersection(other.footprint).area / placement.footprint.area)


def name_of_all(members: Sequence[Placement]) -> tuple[str, ...]:
    """What several of a kind are called together: "storage bin 1, 2, 4"."""
    words = members[0].category.replace("_", " ").split()
    numbers = ", ".join(member.id.rsplit("_", 1)[-1] for member in members)
    names = (f"{' '.join(words)} {numbers}", "\n".join([*words[:-1], f"{words[-1]} {numbers}"]), numbers)
    return tuple(dict.fromkeys(names))


def laid_out(
    things: Sequence[Labelled], measure: Measure, *, size: int, fonts: Sequence[int], reserved: Sequence[Box] = ()
) -> tuple[Label, ...]:
    """A label for every thing, small things first, none on another as far as there is room.

    Args:
        things: what is named.
        measure: how large a text is.
        size: width and height of the picture [pixels].
        fonts: font sizes to try, largest first.
        reserved: boxes that are written on already.
    """
    labels: list[Label] = []
    taken: list[Box] = list(reserved)
    for thing in sorted(things, key=lambda t: (t.area, t.id)):
        label, box = _placed(thing, things, measure, taken, size, fonts)
        labels.append(label)
        taken.append(box)
    return tuple(labels)


def _placed(
    thing: Labelled, things: Sequence[Labelled], measure: Measure, taken: list[Box], size: int, fonts: Sequence[int]
) -> tuple[Label, Box]:
    """The cheapest of all places, fonts and names."""
    best: tuple[float, Label, Box] | None = None
    for rank, (name, font) in enumerate((name, font) for name in thing.names for font in fonts):
        width, height = measure(name, font)
        spots = _spots(thing, width, height)
        half = np.array([width / 2 + 1, height / 2]) + font * _HALO
        cost = _cost(spots, half, thing, things, taken, size) + 9.0 * rank
        least = int(np.argmin(cost))
        if best is None or cost[least] < best[0] - 1e-9:
            at = (float(spots[least, 0]), float(spots[least, 1]))
            box = (at[0] - half[0], at[1] - half[1], at[0] + half[0], at[1] + half[1])
            best = (float(cost[least]), Label(thing.id, name, at, font, _line_end(thing, at, half)), box)
    if best is None:
        raise ValueError(f"{thing.id} has no name to show")
    return best[1], best[2]


def _spots(thing: Labelled, width: float, height: float) -> NDArray[np.float64]:
    """Centres to try (n, 2): the middle, a grid inside the object, rings round it."""
    (x, y), (left, top, right, bottom) = thing.centre, thing.box
    roam_x, roam_y = max(right - left - width, 0.0) / 2, max(bottom - top - height, 0.0) / 2
    steps = np.linspace(-1, 1, 5)
    inside = [(x + i * roam_x, y + j * roam_y) for i in steps for j in steps]
    out_x, out_y = (right - left + width) / 2, (bottom - top + height) / 2
    turns = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    ring = np.stack([np.cos(turns), np.sin(turns)], 1)
    ring /= np.abs(ring).max(1, keepdims=True)
    rings = [np.array([x, y]) + ring * [out_x + gap, out_y + gap] for gap in (4, 14, 30, 52, 80)]
    return np.concatenate([[(x, y)], inside, *rings])


def _cost(
    spots: NDArray[np.float64],
    half: NDArray[np.float64],
    thing: Labelled,
    things: Sequence[Labelled],
    taken: list[Box],
    size: int,
) -> NDArray[np.float64]:
    low, high = spots - half, spots + half
    cost = 0.35 * np.linalg.norm(spots - thing.centre, axis=1)
    cost += 1e4 * ((low < 4).any(1) | (high > size - 4).any(1))
    overhang = np.maximum(thing.box[0] - low[:, 0], 0) + np.maximum(high[:, 0] - thing.box[2], 0)
    overhang += np.maximum(thing.box[1] - low[:, 1], 0) + np.maximum(high[:, 1] - thing.box[3], 0)
    cost += 0.25 * overhang + 6.0 * (overhang > 6)
    cost += 4.0 * _overlap(low, high, taken)
    others = [t.box for t in things if t.id != thing.id and t.area < 0.7 * thing.area]
    return np.asarray(cost + 60.0 * _overlap(low, high, others) / (4 * half[0] * half[1]))


def _overlap(low: NDArray[np.float64], high: NDArray[np.float64], boxes: Sequence[Box]) -> NDArray[np.float64]:
    """Area that each of n boxes shares with all of `boxes` [square pixels]."""
    if not boxes:
        return np.zeros(len(low))
    other = np.array(boxes)
    width = np.minimum(high[:, None, 0], other[:, 2]) - np.maximum(low[:, None, 0], other[:, 0])
    height = np.minimum(high[:, None, 1], other[:, 3]) - np.maximum(low[:, None, 1], other[:, 1])
    return np.asarray((np.maximum(width, 0) * np.maximum(height, 0)).sum(1))


def _line_end(thing: Labelled, at: tuple[float, float], half: NDArray[np.float64]) -> tuple[float, float] | None:
    """Where a line from the text meets the object; None when the text touches it."""
    left, top, right, bottom = thing.box
    gap_x = max(left - (at[0] + half[0]), (at[0] - half[0]) - right)
    gap_y = max(top - (at[1] + half[1]), (at[1] - half[1]) - bottom)
    return thing.centre if max(gap_x, gap_y) > 7 else None
