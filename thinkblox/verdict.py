"""What physics measured: a Verdict on one placement, a Report on a whole scene. Metres, degrees, seconds."""

from typing import Literal

from thinkblox.value import Value

Reason = Literal[
    "collision",  # deeper in another object than tolerated
    "outside",  # outside the room or above its ceiling
    "unsupported",  # nothing carries it, or a mounted thing does not touch what it hangs on
    "drift",  # slid while settling
    "drop",  # fell further than its clearance
    "tilt",  # leaned or toppled
    "blocks_door",  # stands in a door's swing or way
    "blocks_window",  # stands higher than the sill right in front of a window
    "blocks_way",  # leaves no walkable way from a door to a large object
    "size",  # asks for a size that the asset cannot have
    "unstable",  # the simulation itself failed
]


class Collision(Value, frozen=True, kw_only=True):
    """How deep an object is inside another [m], and the share of its volume that is inside the other."""

    other: str
    depth: float
    overlap: float


class Support(Value, frozen=True, kw_only=True):
    """Who carries an object ("floor", a wall, "ceiling" or an id) and which share of its weight."""

    by: str
    share: float


class Verdict(Value, frozen=True, kw_only=True):
    """What physics measured about one placement.

    Attributes:
        valid: no reasons.
        reasons: every tolerance that was exceeded, in the order of `Reason`.
        depth: deepest contact with anything that it does not merely rest on [m]; 0 when free.
        overlap: sum of the overlap ratios over `collisions`.
        outside: how far its footprint or top reaches out of the room [m]; 0 when inside.
        supports: what carries it, largest share first.
        settled: whether a settle was run; it is not after a failed collision or boundary gate.
        drift: horizontal distance moved in the settle [m].
        drop: distance sunk in the settle [m].
        tilt: change of orientation in the settle [degrees].
        blocked: ids of the openings it stands in the way of, or of the objects it cuts off.
    """

    id: str
    valid: bool
    reasons: tuple[Reason, ...] = ()
    depth: float = 0.0
    overlap: float = 0.0
    outside: float = 0.0
    collisions: tuple[Collision, ...] = ()
    supports: tuple[Support, ...] = ()
    settled: bool = False
    drift: float = 0.0
    drop: float = 0.0
    tilt: float = 0.0
    blocked: tuple[str, ...] = ()

    def __str__(self) -> str:
        """One line a person or a policy can act on: every failed measure with its number and its counterpart."""
        if self.valid:
            carried = ", ".join(s.by for s in self.supports)
            return f"{self.id}: valid" + (f", carried by {carried}" if carried else "")
        return f"{self.id}: " + "; ".join(self._explain(reason) for reason in self.reasons)

    def _explain(self, reason: Reason) -> str:
        blocked = ", ".join(self.blocked)
        texts: dict[Reason, str] = {
            "collision": "collides with "
            + ", ".join(
                f"{c.other} ({c.depth * 1000:.1f} mm deep, {c.overlap:.1%} of its volume)" for c in self.collisions
            ),
            "outside": f"reaches {self.outside * 1000:.1f} mm outside the room",
            "unsupported": "nothing supports it",
            "drift": f"slid {self.drift * 1000:.1f} mm while settling",
            "drop": f"fell {self.drop * 1000:.1f} mm while settling",
            "tilt": f"tilted {self.tilt:.1f} degrees while settling",
            "blocks_door": f"stands in the way of {blocked}",
            "blocks_window": f"stands in front of {blocked}",
            "blocks_way": f"leaves no way to {blocked}",
            "size": "asks for a size that it cannot have",
            "unstable": "the simulation failed",
        }
        return texts[reason]


class Absence(Value, frozen=True, kw_only=True):
    """Something asked for that is not in the room, and why."""

    id: str
    category: str
    asked: bool
    reason: str


class RelationResult(Value, frozen=True, kw_only=True):
    """Whether a relation that the prompt names holds in the scene, in words and with what was measured."""

    kind: str
    subject: str
    anchors: tuple[str, ...]
    holds: bool
    measured: str


class Report(Value, frozen=True, kw_only=True):
    """The verdict on a whole scene.

    Attributes:
        valid: every placement is valid, and the whole stands still; of an empty room too.
        complete: besides, everything asked for is there, and stands as it was asked to. That is what a prompt wants.
        depth: deepest contact between any two bodies [m].
        drift, tilt: the largest motion of any free object over `simulated` seconds, everything free [m, degrees].
        reach: share of the free floor that hangs together with the doors, for a walker of `way` metres.
        unreachable: large objects with no walkable way from a door.
        absent: what could not be placed, with reasons; `unknown` the words of the prompt that mean nothing to us.
        notes: what a reader should know besides, in sentences.
    """

    valid: bool
    complete: bool = False
    prompt: str = ""
    seed: int = 0
    versions: dict[str, str] = {}
    objects: tuple[Verdict, ...] = ()
    absent: tuple[Absence, ...] = ()
    unknown: tuple[str, ...] = ()
    relations: tuple[RelationResult, ...] = ()
    depth: float = 0.0
    drift: float = 0.0
    tilt: float = 0.0
    simulated: float = 0.0
    way: float = 0.0
    reach: float = 1.0
    unreachable: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
