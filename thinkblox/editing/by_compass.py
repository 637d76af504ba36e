"""Which of several things are meant by a side of the room: "the north workbench", "the two east desks"."""

from collections.abc import Sequence

from thinkblox.reading.english.chunks import Noun
from thinkblox.scene.placement import Placement

WAYS = {"north": (0.0, 1.0), "south": (0.0, -1.0), "east": (1.0, 0.0), "west": (-1.0, 0.0)}
"""The sides of a room, with the way to each."""
LEAST = 0.05
"""By how much one is further that way than another at least that is told so [m]."""


def compass_of(noun: Noun) -> str:
    """The side of the room that a noun phrase names before its head: "north" of "the north desk"; else empty."""
    return next((word for word in noun.text.lower().split()[:-1] if word in WAYS), "")


def by_compass(noun: Noun, found: Sequence[Placement]) -> list[Placement]:
    """Those farthest on the side of the room that is said: as many as are said, or else the half of them there.

    Where none of them is further there than the next, all are left.
    """
    x, y = WAYS[compass_of(noun)]
    ordered = sorted(found, key=lambda p: -(p.position[0] * x + p.position[1] * y))
    away = [p.position[0] * x + p.position[1] * y for p in ordered]
    middle = (away[0] + away[-1]) / 2
    several = noun.many or noun.each or noun.det in ("all", "both")
    count = noun.count or (2 if noun.det == "both" else sum(a > middle for a in away) if several else 1)
    told = 0 < count < len(ordered) and away[count - 1] - away[count] >= LEAST
    return ordered[:count] if told else list(found)
