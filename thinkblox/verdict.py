"""What physics measured: a Verdict on one placement, a Report on a whole scene. Metres, degrees, seconds."""

import math
from typing import Literal

from thinkblox.measurement import Measurement
from thinkblox.room_score import RoomScore
from thinkblox.suite import SuiteResult
from thinkblox.value import Value, Vec3

Reason = Literal[
    "collision",  # deeper in another object than tolerated, where it is put or once it rests
    "outside",  # outside the room or above its ceiling
    "unsupported",  # nothing carries it, or a mounted thing does not touch what it hangs on
    "faces_wall",  # hangs with its front to the wall
    "drift",  # slid while settling
    "drop",  # fell further than its clearance
    "tilt",  # leaned or toppled
    "restless",  # did not come to rest, or left something else moving
    "pushes",  # moved or tilted something else while settling
    "blocks_door",  # stands in a door's swing or way
    "blocks_window",  # stands higher than the sill right in front of a window
    "blocks_opening",  # keeps a door or drawer of furniture shut, its own or another's
    "blocks_way",  # leaves no walkable way from a door to a large object
    "riders",  # what rests on it, or rested on it, fails where the action leaves that
    "requirement",  # does not meet what the user requires of it
    "size",  # asks for a size that the asset cannot have
    "unstable",  # the simulation itself failed
    "error",  # no verdict could be had; `message` says why
]


class Collision(Measurement, frozen=True, kw_only=True):
    """How deep an object is inside another [m], and the share of its volume that is inside the other.

    Where an object is pressed in only once everything rests, the depth is that at rest, and the share is 0; where it
    presses another into what carries that, `other` is the one that is pressed.
    """

    other: str
    depth: float
    overlap: float


class Support(Measurement, frozen=True, kw_only=True):
    """Who carries an object ("floor", a wall, "ceiling" or an id) and which share of its weight."""

    by: str
    share: float


class Push(Measurement, frozen=True, kw_only=True):
    """How far another object was moved [m] and turned [degrees] by this one's settling, against where it would be."""

    other: str
    distance: float
    tilt: float = 0.0


class PushedAside(Measurement, frozen=True, kw_only=True):
    """What a door or drawer pushes aside on its way, and the force that slides it with all that it carries [N]."""

    other: str
    force: float


class Swing(Measurement, frozen=True, kw_only=True):
    """How far a door or drawer opens.

    Attributes:
        of: id of the object it belongs to.
        link: its name in the asset.
        opens: share of its range that is free, 0 to 1.
        hits: what ends it, or is pushed aside on the way: ids and names of walls.
        pushes: those of them that are pushed aside: what is free and light (`Walking.movable`).
    """

    of: str
    link: str
    opens: float
    hits: tuple[str, ...] = ()
    pushes: tuple[PushedAside, ...] = ()

    def __str__(self) -> str:
        """Such as "door of wardrobe_1 (27%, hits wall, pushes chair_1 aside with 18 N)"."""
        aside = {push.other: push.force for push in self.pushes}
        ends = ", ".join(other for other in self.hits if other not in aside)
        pushes = ", ".join(f"{other} aside with {force:.0f} N" for other, force in aside.items())
        facts = [f"{self.opens:.0%}", ends and f"hits {ends}", pushes and f"pushes {pushes}"]
        return f"{self.link} of {self.of} ({', '.join(fact for fact in facts if fact)})"


class Unmet(Value, frozen=True, kw_only=True):
    """A requirement of the user's that a placement does not meet, and what it says of that."""

    requirement: str
    says: str


class Pose(Measurement, frozen=True, kw_only=True):
    """Where an object stands: position [m] and yaw [degrees], as of a Placement."""

    position: Vec3
    yaw: float


class Verdict(Measurement, frozen=True, kw_only=True):
    """What physics measured about one placement.

    Attributes:
        valid: no reasons.
        reasons: every tolerance that was exceeded, in the order of `Reason`.
        depth: deepest contact with anything that it does not merely rest on [m]; 0 when free.
        overlap: sum of the overlap ratios over `collisions`.
        boundary: signed distance to walls, floor and ceiling, all that is outside being solid [m]: the least
            distance it must be moved to be inside, or, less than 0, the free distance to the nearest wall.
        supports: what carries it, largest share first.
        settled: whether a settle was run; it is not after a failed collision or boundary gate.
        drift: horizontal distance moved in the settle [m].
        drop: distance sunk in the settle [m].
        tilt: change of orientation in the settle [degrees].
        rest: when it came to rest in the settle [s]; None when it did not, or no settle was run. What moved by more
            than `Physics.lost` or tilted by more than `Physics.toppled` is not followed any further: `drift`, `drop`
            and `tilt` are then how far it had come, which is told as the least that they are.
        settled_pose: where the settle left it; None when none was run, or it did not come to rest.
        pushed: what it moved while settling, furthest first.
        swings: its own doors and drawers that do not open through all of their range, or only by pushing something
            aside, and those of others that it keeps from opening so far.
        blocked: ids of the openings it stands in the way of, or of the objects it cuts off.
        reachable: whether the robot of `Report.robot` comes within reach of it from a door; None where that was not
            measured, or for what does not stand on the floor.
        riders: verdicts on what rests on it, or rested on it, where an action moved or left that.
        unmet: requirements of the user's that it does not meet.
        message: why there is no verdict.
    """

    id: str
    valid: bool
    reasons: tuple[Reason, ...] = ()
    depth: float = 0.0
    overlap: float = 0.0
    boundary: float = 0.0
    collisions: tuple[Collision, ...] = ()
    supports: tuple[Support, ...] = ()
    settled: bool = False
    drift: float = 0.0
    drop: float = 0.0
    tilt: float = 0.0
    rest: float | None = None
    settled_pose: Pose | None = None
    pushed: tuple[Push, ...] = ()
    swings: tuple[Swing, ...] = ()
    blocked: tuple[str, ...] = ()
    reachable: bool | None = None
    riders: tuple["Verdict", ...] = ()
    unmet: tuple[Unmet, ...] = ()
    message: str = ""

    @property
    def outside(self) -> float:
        """How far it reaches out of the room [m]; 0 when inside."""
        return max(0.0, self.boundary)

    @property
    def r_coll(self) -> float:
        """Collision reward of the ThinkBLOX paper, -tanh(5 sum rho), rho being the overlap ratios; -1 to 0."""
        return 0.0 - math.tanh(5.0 * self.overlap)

    @property
    def r_layout(self) -> float:
        """Boundary reward of the ThinkBLOX paper, -tanh of the distance outside in metres; -1 to 0."""
        return 0.0 - math.tanh(self.outside)

    def __str__(self) -> str:
        """One line a person or a policy can act on: every failed measure with its number and its counterpart."""
        if self.valid:
            carried = ", ".join(s.by for s in self.supports)
            return f"{self.id}: valid" + (f", carried by {carried}" if carried else "")
        return f"{self.id}: " + "; ".join(self._explain(reason) for reason in self.reasons)

    def _explain(self, reason: Reason) -> str:
        blocked = ", ".join(self.blocked)
        shut = ", ".join(str(swing) for swing in self.swings if swing.opens < 1.0)
        least = "at least " if self.rest is None else ""
        texts: dict[Reason, str] = {
            "collision": "collides with "
            + ", ".join(
                f"{c.other} ({c.depth * 1000:.1f} mm deep, {c.overlap:.1%} of its volume)" for c in self.collisions
            ),
            "outside": f"reaches {self.outside * 1000:.1f} mm outside the room",
            "unsupported": "nothing supports it",
            "faces_wall": "hangs with its front to the wall",
            "drift": f"slid {least}{self.drift * 1000:.1f} mm while settling",
            "drop": f"fell {least}{self.drop * 1000:.1f} mm while settling",
            "tilt": f"tilted {least}{self.tilt:.1f} degrees while settling",
            "restless": "did not come to rest",
            "riders": "what rests on it fails: " + "; ".join(str(rider) for rider in self.riders if not rider.valid),
            "pushes": "pushed "
            + ", ".join(f"{p.other} ({p.distance * 1000:.1f} mm, {p.tilt:.1f} degrees)" for p in self.pushed),
            "blocks_door": f"stands in the way of {blocked}",
            "blocks_window": f"stands in front of {blocked}",
            "blocks_opening": f"does not let open: {shut}",
            "blocks_way": f"leaves no way to {blocked}",
            "requirement": "; ".join(f"{u.requirement}: {u.says}" for u in self.unmet),
            "size": "asks for a size that it cannot have",
            "unstable": "the simulation failed",
            "error": self.message or "it could not be measured",
        }
        return texts[reason]


class Absence(Value, frozen=True, kw_only=True):
    """Something asked for that is not in the room, and why."""

    id: str
    category: str
    asked: bool
    reason: str


class RelationResult(Value, frozen=True, kw_only=True):
    """Whether a relation that the prompt names holds in the scene, in words and with what was measured.

    Attributes:
        holds: it is as the prompt wants it; where it is `negated`, that it does not hold.
    """

    kind: str
    subject: str
    anchors: tuple[str, ...]
    holds: bool
    measured: str
    negated: bool = False


class Demand(Value, frozen=True, kw_only=True):
    """Something asked for that is no relation: how many, how large, of what look, not at all, or a part left free.

    Attributes:
        kind: what is asked about.
        subject: of what: a noun, or a part of the room.
        wanted: what was asked, in words.
        holds: whether it is so. An "attribute" or "state" holds when it can be seen.
        measured: what was found.
    """

    kind: Literal["count", "size", "room", "opening", "attribute", "state", "excluded", "free"]
    subject: str
    wanted: str
    holds: bool
    measured: str


class Access(Measurement, frozen=True, kw_only=True):
    """What can be walked to, or driven to by a robot.

    Attributes:
        width: of the walker or robot [m].
        reach: share of the floor on which its middle can be that hangs together with the doors, 0 to 1.
        unreachable: ids of large objects and doors to which there is no way from a door.
    """

    width: float
    reach: float
    unreachable: tuple[str, ...] = ()


class MendingMove(Measurement, frozen=True, kw_only=True):
    """How an object was moved to mend a fault.

    Attributes:
        by: where it went [m].
        turn: by how much it was turned [degrees].
        distance: length of `by` [m].
        why: the reasons it was moved for; none where it moved for another.
        mended: whether they are gone.
        needs: how far it would have to be moved, where that is further than it may be [m].
    """

    id: str
    by: tuple[float, float, float]
    turn: float
    distance: float
    why: tuple[Reason, ...]
    mended: bool
    needs: float | None = None


class PlainThing(Measurement, frozen=True, kw_only=True):
    """Something that is there as a plain solid of its size and mass, for want of a shape of its own.

    Attributes:
        name: what it is called ("popcorn machine").
        ids: of the objects.
        how: its size is that of an entry of its own ("table"), of what its head noun names ("head"), of what is
            spelled almost the same ("spelling"), or a middling one ("plain").
        like: what has the size that it was given, where that is something else ("throne").
        similarity: how sure that is, 0 to 1.
    """

    name: str
    ids: tuple[str, ...]
    how: Literal["table", "head", "spelling", "plain"] = "table"
    like: str = ""
    similarity: float = 1.0

    def __str__(self) -> str:
        """For people: "dental throne (size of: throne)"."""
        unsure = f", {self.similarity:.0%} sure" if self.how == "spelling" else ""
        size = f"size of: {self.like}{unsure}" if self.like else "size not known" if self.how == "plain" else ""
        return f"{self.name} ({size})" if size else self.name


class Report(Measurement, frozen=True, kw_only=True):
    """The verdict on a whole scene.

    Attributes:
        valid: every placement is valid, and the whole stands still; of an empty room too.
        complete: besides, everything asked for is there, is as it was asked to be and stands as it was asked to, and
            every word that names or changes a thing was understood. That is what a prompt wants.
        depth: deepest contact between any two bodies [m].
        drift, tilt: the largest motion of any free object over `simulated` seconds, everything free [m, degrees].
        walker: what can be walked to, light things being pushed aside; None where no floor is known.
        robot: what a robot can drive to, 0.2 m wide, that pushes nothing aside; every object on the floor counts.
        source: what was read: "thinkblox", "mjcf", "urdf", or a generator whose layout it is.
        unusual: options of a foreign model that make it stand better than it would, in sentences.
        substituted: ids that are measured as boxes, for want of a mesh.
        stand_ins: what is there as a plain solid of its size and mass, for want of a shape of its own.
        score: how good the room is by the guidelines of interior layout; None where that was not looked at, as for
            models, which have no floor plan.
        suites: the published criteria that were asked for.
        moves: what was moved to mend faults.
        demands: what else the prompt asks for, and whether it is so.
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
    demands: tuple[Demand, ...] = ()
    depth: float = 0.0
    drift: float = 0.0
    tilt: float = 0.0
    simulated: float = 0.0
    walker: Access | None = None
    robot: Access | None = None
    source: str = "thinkblox"
    unusual: tuple[str, ...] = ()
    substituted: tuple[str, ...] = ()
    stand_ins: tuple[PlainThing, ...] = ()
    score: RoomScore | None = None
    suites: tuple[SuiteResult, ...] = ()
    moves: tuple[MendingMove, ...] = ()
    notes: tuple[str, ...] = ()
