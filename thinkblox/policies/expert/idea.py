"""One idea of where an object could go, and the words that say where it is."""

from dataclasses import dataclass

from thinkblox.phrases import Constraint
from thinkblox.value import Vec3

WALL_GAP = 0.02
"""Left free between furniture and the wall behind it, for the skirting board [m]."""


@dataclass(frozen=True)
class Idea:
    """A pose, the words that led to it, and what speaks against it from the start.

    Attributes:
        words: what the reasoning says about the pose, in the phrases of the step language.
        against: walls it stands or hangs against; the distance from the next wall is then said as well.
        why: the reason, as a clause ("its head belongs to a wall").
        cost: how far it is from the best of its kind; about 1 is a clear drawback.
        ignore: ids that it may overlap as seen from above (the table a seat is tucked under).
        size: another size than the asset's, where the idea is to fit it.
    """

    position: Vec3
    yaw: float
    words: tuple[Constraint, ...]
    why: str
    cost: float = 0.0
    ignore: tuple[str, ...] = ()
    size: Vec3 | None = None
    against: tuple[str, ...] = ()
