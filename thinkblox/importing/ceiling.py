"""How high a room is, and what hangs below a ceiling that nobody gave."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from thinkblox.importing.body import ItemBody
from thinkblox.importing.document import plain
from thinkblox.value import Vec3

HEIGHT = 2.6
"""Of a room where the layout has none, unless something in it is higher [m]."""
CORD = 0.004
"""Half the width of the cord that is given to what hangs below an assumed ceiling [m]."""
REACHES = 0.001
"""What ends no lower than this below the ceiling needs no cord [m]."""


def assumed_height(bodies: Sequence[ItemBody]) -> float:
    """Of a room whose layout has none [m]: the usual one, or the top of the highest thing in it."""
    return max([HEIGHT, *(round(body.position[2] + body.size[2] + 1e-9, 9) for body in bodies)])


def corded(body: ItemBody, height: float) -> ItemBody:
    """A thing that hangs, with the cord on which it hangs from a ceiling at a height that nobody gave."""
    gap = height - body.position[2] - body.size[2]
    if gap <= REACHES:
        return body
    x, y, z = body.size
    corners = [(sx * CORD, sy * CORD, up) for sx in (-1, 1) for sy in (-1, 1) for up in (z, z + gap)]
    size: Vec3 = (max(x, 2 * CORD), max(y, 2 * CORD), z + gap)
    return replace(
        body,
        pieces=(*body.pieces, np.array(corners)),
        plain_box=False,
        size=size,
        notes=(
            *body.notes,
            f"{plain(body.item.name)} hangs {gap:.2f} m below a ceiling that is not in the file; it was given a cord.",
        ),
    )
