"""Curves as a picture: values over the steps of runs, one panel for each quantity."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

Points = Sequence[tuple[float, float]]
"""Steps and values."""
PANEL, MARGIN, COLUMNS = (420, 260), (52, 30, 14, 28), 2
"""Size of a panel [pixels]; free left, above, right and below its axes; panels side by side."""
COLOURS = ("#1f5fa8", "#c8501e", "#2f8f4e", "#8a3fa0", "#7a7a7a", "#b59a00", "#14a3a8", "#d8478f", "#5b3a1e", "#0b1f3a")
SMOOTH = 0.08
"""Share of a curve's points over which its thick line is averaged."""
_INK, _FAINT = "#222222", "#dddddd"


class Panel(NamedTuple):
    """A quantity, and its values in each run by the run's name."""

    title: str
    runs: Mapping[str, Points]


def draw(panels: Sequence[Panel]) -> "Image":
    """Draw the panels, `COLUMNS` side by side, with what each colour is below them."""
    from PIL import Image, ImageDraw

    names = list(dict.fromkeys(name for panel in panels for name in panel.runs))
    rows = -(-len(panels) // COLUMNS)
    columns = min(COLUMNS, len(panels))
    picture = Image.new("RGB", (columns * PANEL[0], rows * PANEL[1] + 24), "white")
    pen = ImageDraw.Draw(picture)
    for number, panel in enumerate(panels):
        corner = (number % COLUMNS * PANEL[0], number // COLUMNS * PANEL[1])
        _panel(pen, panel, corner, names)
    x = MARGIN[0]
    for name in names:
        pen.rectangle((x, rows * PANEL[1] + 6, x + 12, rows * PANEL[1] + 12), fill=_colour(name, names))
        pen.text((x + 18, rows * PANEL[1] + 3), name, fill=_INK)
        x += 36 + int(pen.textlength(name))
    return picture


def smoothed(points: Points, share: float = SMOOTH) -> list[tuple[float, float]]:
    """The same steps, each with the mean of the values around it."""
    reach = max(0, round(len(points) * share / 2))
    found = []
    for index, (step, _) in enumerate(points):
        near = [value for _, value in points[max(0, index - reach) : index + reach + 1]]
        found.append((step, sum(near) / len(near)))
    return found


def _colour(name: str, names: Sequence[str]) -> str:
    return COLOURS[names.index(name) % len(COLOURS)]


def _panel(pen: "ImageDraw", panel: Panel, corner: tuple[int, int], names: Sequence[str]) -> None:
    every = [point for points in panel.runs.values() for point in points]
    left, top, right, bottom = MARGIN
    x0, y0 = corner[0] + left, corner[1] + top
    width, height = PANEL[0] - left - right, PANEL[1] - top - bottom
    pen.text((x0, corner[1] + 9), panel.title, fill=_INK)
    if not every:
        return
    last = max(step for step, _ in every) or 1.0
    low, high = min(value for _, value in every), max(value for _, value in every)
    low, high = (low - 0.5, high + 0.5) if high - low < 1e-9 else (low, high)

    def place(point: tuple[float, float]) -> tuple[float, float]:
        return (x0 + width * point[0] / last, y0 + height * (1 - (point[1] - low) / (high - low)))

    for part in range(5):
        value, step = low + (high - low) * part / 4, last * part / 4
        y = place((0, value))[1]
        pen.line((x0, y, x0 + width, y), fill=_FAINT)
        pen.text((corner[0] + 4, y - 6), f"{value:.3g}", fill=_INK)
        pen.text((place((step, low))[0] - 8, y0 + height + 6), f"{step:.0f}", fill=_INK)
    for name, points in panel.runs.items():
        colour = _colour(name, names)
        if len(points) > 1:
            pen.line([place(point) for point in smoothed(points)], fill=colour, width=2)
        for point in points:
            x, y = place(point)
            pen.point((x, y), fill=colour)
