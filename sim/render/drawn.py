"""What is drawn on a picture of faults, in pixels, for any way of drawing it."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from thinkblox.sim.render.faults import Kind
from thinkblox.sim.render.labels import Box

if TYPE_CHECKING:
    from PIL.Image import Image

Point = tuple[float, float]
Ring = tuple[Point, ...]


@dataclass(frozen=True)
class Silhouette:
    """An object in the picture.

    Attributes:
        rings: round what is seen of it.
        hull: round all of it, hidden parts included.
        hidden: whether less than a third of it is seen.
    """

    id: str
    rings: tuple[Ring, ...]
    hull: Ring
    hidden: bool


@dataclass(frozen=True)
class Mark:
    """A fault in the picture; rings are filled, `round` are centres of small circles, `at` is where the text goes."""

    kind: Kind
    id: str
    rings: tuple[Ring, ...] = ()
    circles: tuple[Point, ...] = ()
    arrow: tuple[Point, Point] | None = None
    dashes: tuple[tuple[Point, Point], ...] = ()
    text: str = ""
    at: Point | None = None


@dataclass(frozen=True)
class Badge:
    """An object's number in its disc, with a line to the object where it is beside it."""

    id: str
    number: int
    at: Point
    line_to: Point | None


@dataclass(frozen=True)
class FaultPicture:
    """A picture and what is drawn on it; `box` is left, top, right and bottom of the part worth showing [pixels]."""

    image: "Image"
    box: Box
    outlines: tuple[Silhouette, ...]
    marks: tuple[Mark, ...]
    badges: tuple[Badge, ...]
