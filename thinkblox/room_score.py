"""How good a room is by the published guidelines of interior layout: a total, and the parts that it is made of."""

from thinkblox.value import Value


class ScorePart(Value, frozen=True, kw_only=True):
    """What one guideline says of a room.

    Attributes:
        name: of the guideline, such as "clearance".
        score: from 0 to 1; None where the room has nothing that the guideline speaks of.
        weight: of this part in the total.
        numbers: what the score was made of, by name; metres, degrees, shares and counts.
        worst: the thing that costs most and what was measured of it, in words; empty where nothing costs anything.
    """

    name: str
    score: float | None
    weight: float
    numbers: dict[str, float] = {}
    worst: str = ""


class RoomScore(Value, frozen=True, kw_only=True):
    """The parts of a score and their weighted mean.

    Attributes:
        total: from 0 to 1, over the parts that have a score; None where nothing stands in the room.
        parts: one of each guideline, in the order of `thinkblox.scoring.WEIGHTS`.
    """

    total: float | None
    parts: tuple[ScorePart, ...] = ()

    def part(self, name: str) -> ScorePart:
        """The part of a guideline; raises KeyError that lists those that there are."""
        for part in self.parts:
            if part.name == name:
                return part
        raise KeyError(f"no part {name!r}; there are {', '.join(part.name for part in self.parts)}")

    def __str__(self) -> str:
        """For people: "0.82: clearance 0.90, circulation 1.00, daylight -"."""
        if self.total is None:
            return "nothing to score"
        parts = (f"{p.name} {'-' if p.score is None else format(p.score, '.2f')}" for p in self.parts)
        return f"{self.total:.2f}: {', '.join(parts)}"
