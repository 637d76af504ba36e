"""Where the numbers of objects and the texts of marks go on a picture of faults."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from thinkblox.sim.render.drawn import Badge, Mark, Point, Ring, Silhouette
from thinkblox.sim.render.labels import Box, Labelled, laid_out

BADGE = 11.0
"""Radius of a number's disc [pixels]."""
KEPT_FREE = 9.0
"""How far numbers stay from the tips of arrows and from small circles [pixels]."""
SIGN = 8.0
"""How far texts stay from the middles of small circles [pixels]."""
LETTER, LINE = 7.8, 14.0
"""Width of a letter and height of a line of a mark's text [pixels]."""


def badges_of(
    outlines: Iterable[Silhouette], numbers: Mapping[str, int], marks: Iterable[Mark], size: int
) -> list[Badge]:
    """The numbers, each on or beside its object, none on another or on what is drawn small."""
    things = [Labelled(o.id, (str(numbers[o.id]),), _box(o.hull)) for o in outlines if o.hull]
    spots = [spot for mark in marks for spot in (*mark.circles, *(mark.arrow or ())[1:])]
    kept = [(x - KEPT_FREE, y - KEPT_FREE, x + KEPT_FREE, y + KEPT_FREE) for x, y in spots]
    labels = laid_out(things, lambda text, font: (2 * BADGE, 2 * BADGE), size=size, fonts=(1,), reserved=kept)
    found = [Badge(label.id, numbers[label.id], label.at, label.line_to) for label in labels]
    return sorted(found, key=lambda badge: badge.number)


def _box(ring: Ring) -> Box:
    x, y = np.array(ring).T
    return float(x.min()), float(y.min()), float(x.max()), float(y.max())


def with_texts(marks: Sequence[Mark], badges: Sequence[Badge], within: Box) -> list[Mark]:
    """The marks with their texts at places that are free; a text that finds none is left out: it is in the table."""
    taken = [(b.at[0] - BADGE, b.at[1] - BADGE, b.at[0] + BADGE, b.at[1] + BADGE) for b in badges]
    taken += [(x - SIGN, y - SIGN, x + SIGN, y + SIGN) for mark in marks for x, y in mark.circles]
    found = []
    for mark in marks:
        at = _free_place(mark, taken, within) if mark.at is not None and mark.text else None
        if at is not None:
            taken.append(_text_box(mark.text, at))
        found.append(replace(mark, at=at, text=mark.text if at is not None else ""))
    return found


def _free_place(mark: Mark, taken: Sequence[Box], within: Box) -> Point | None:
    if mark.at is None:
        return None
    aside = len(mark.text) * LETTER / 2 + 12
    for dx, dy in ((0, -16), (0, 17), (aside, 0), (-aside, 0), (aside, 15), (-aside, 15), (0, -31), (0, 32)):
        at = (round(mark.at[0] + dx, 1), round(mark.at[1] + dy, 1))
        box = _text_box(mark.text, at)
        inside = box[0] > within[0] and box[1] > within[1] and box[2] < within[2] and box[3] < within[3]
        if inside and not any(_overlap(box, other) for other in taken):
            return at
    return None


def _text_box(text: str, at: Point) -> Box:
    half = len(text) * LETTER / 2
    return at[0] - half, at[1] - LINE / 2, at[0] + half, at[1] + LINE / 2


def _overlap(a: Box, b: Box) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
