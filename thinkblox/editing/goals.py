"""What an order wants of one object, measured on the scene before and after: geometry alone, metres and degrees."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal, Protocol

from shapely import LineString, Point, Polygon, unary_union
from shapely.ops import nearest_points

from thinkblox.assets import facts_of
from thinkblox.brief import RelationKind
from thinkblox.plan import Tie
from thinkblox.scene.bearings import bearing, ground_gap, place_of
from thinkblox.scene.free_parts import parts, takers
from thinkblox.scene.landmarks import Landmark, corners, things, walls
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.room import turn_between
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2, Vec3

EXACT = 0.02
"""How far a thing may stand from where it was to go [m]."""
ASIDE = 1.5
"""How many times as far as it comes nearer, or goes away, a thing may be moved that is to do so by a length."""
TURN_EXACT = 2.0
"""The same for its yaw [degrees]."""
TO_WALL = 20.0
"""Largest angle between a gaze and the way to the wall that is looked at [degrees]."""
MID_WALL = 0.1
"""How far from the middle of a wall something stands at most that is to be there [m]."""
CENTRAL = 0.6
"""How far from the middle of the room something stands at most that is to be there [m]."""
SNUG = 0.15
"""How far from its corner what is put into it stands at most [m]."""
BESIDE_LINE = 0.3
"""How far from the line between two things something stands at most that is centred between them [m]."""
STRAIGHT = 5.0
"""Largest angle between a front and the way to what it looks straight at [degrees]."""
BY_SMALL = 0.15
"""How far from a small thing another one on the same top is at most that is next to it [m]."""
SAME_TOP = 0.05
"""How much higher or lower than another one a small thing stands at most that is next to it on the same top [m]."""
OFF_BETWEEN = 0.1
"""How far out of the space between two things the middle of something between them is at most [m]."""
SEAT_DEPTH, SEAT_WIDTH, SEAT_HEIGHT = 0.75, 0.6, 1.2
"""How much floor somebody takes who sits at a thing, and up to which height that is to be free [m]."""
LEVEL = 0.2
"""How far before or behind a thing something stands at most that is beside it [m]."""
HEAD = 0.25
"""How far behind the middle of a bed is at its head, as a part of its length."""
BEFORE_SEAT = 0.9
"""How far from the middle of a seat what lies before it is at most [m]."""
TOUCHES = 0.005
"""From how far two things have a gap between them [m]."""
LEAST = 0.02
"""Least by which something comes nearer or goes away, where there is so much room [m]."""
AWAY = 0.1
"""Least by which something goes away that is to do so, and not only a bit [m]."""
INTO_ROOM = 45.0
"""Largest angle between a front and the way into the room [degrees]."""
BACK_TO = 20.0
"""Largest angle between a back and the way to what it is to be to [degrees]."""
ELSEWHERE, ELSEWHERE_SMALL = 0.75, 0.15
"""Least distance of another place from the one before: on the floor, and on a surface or a wall [m]."""

ENTERED = 0.002
"""Floor that may be taken of what is to be free [m2]."""

BEFORE_SHARE, LAID_AT = 0.5, 0.5
"""How much of the narrower of two things is across from the other where one is before it; how far off a mat is [m]."""
Finding = tuple[bool, str]
"""Whether it is so, and what was measured."""


class Goal(Protocol):
    """Anything that can be measured of an object after a change."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Whether it is so, and what was measured."""
        ...

    @property
    def tie(self) -> Tie | None:
        """The same as a policy is told it; None where the language of plans has no word for it."""
        ...


@dataclass(frozen=True)
class Related:
    """It stands in a relation of a brief to ids or Places, or does not."""

    kind: RelationKind
    anchors: tuple[str, ...] = ()
    negated: bool = False
    index: int = 0
    count: int = 1
    measured: RelationKind | None = None

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """As `thinkblox.scene.relations` measures it; of several around a table, each by itself."""
        found = measure(after, self.measured or self.kind, id, self.anchors, negated=self.negated)
        over_edge = self.kind == "on" and after[id].support == "floor" and after[id].position[2] > OVER_FLOOR
        return found.holds and not (over_edge and not self.negated), found.measured

    @property
    def tie(self) -> Tie | None:
        """The relation itself."""
        return None if self.negated else Tie(kind=self.kind, anchors=self.anchors, index=self.index, count=self.count)


LOW_HUNG = 0.25
"""How far above the floor the lower edge is at least of what is hung beside or between others [m]."""
OVER_FLOOR = 0.02
"""From how high up nothing stands on the floor [m]: it is over the edge of what it is to be on."""
PartOfTop = Literal["left", "right", "front", "back", "end"]
OFF_MIDDLE = 0.12
"""From which share of a top's length on its one half is left, and twice that its end."""
TO_END = 0.12
"""How much of a top's length is free at most between one end of it and what stands at that end."""


@dataclass(frozen=True)
class OnPart(Related):
    """It stands on a part of the top of a thing, as that thing's front shows its sides; `end`: at its end."""

    part: PartOfTop = "end"
    end: bool = False

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """On it, and how far from the middle of its top, as a share of its length."""
        held, says = super().check(before, after, id)
        carrier = after[self.anchors[0]]
        ahead, left = (
            at / side for at, side in zip(carrier.to_local(after[id].position[:2]), carrier.size[:2], strict=True)
        )
        far = {"left": left, "right": -left, "front": ahead, "back": -ahead}.get(self.part)
        if far is None:
            far = abs(ahead if carrier.size[0] > carrier.size[1] else left) / 2
        axis = 1 if self.part in ("left", "right") else 0
        outer = 0.5 - TO_END - min(after[id].size[:2]) / carrier.size[axis] / 2 if self.end else 0.0
        return held and far >= max(OFF_MIDDLE, outer), f"{says}, {far:.0%} of it from its middle to the {self.part}"


@dataclass(frozen=True)
class OnWall(Related):
    """It hangs on a wall."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """By what it is fixed to."""
        named = {wall.name for name in self.anchors for wall in walls(after.room, name)}
        if after.asset_of(after[id]).mount != "wall":
            return super().check(before, after, id)
        return (after[id].support in named) != self.negated, f"{id} on {after[id].support}"


@dataclass(frozen=True)
class MidWall(Related):
    """It stands with its back to a wall, at the middle of it."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Both: how far along the wall its middle is from that of the wall."""
        held, says = super().check(before, after, id)
        named = {wall.name for name in self.anchors for wall in walls(after.room, name)}
        along = [(w.coordinates(after[id].position[:2]), w.length) for w in after.room.walls if w.name in named]
        off = min(((away, abs(far - length / 2)) for (far, away), length in along), default=(0.0, math.inf))[1]
        return held and off <= MID_WALL, f"{says}, {off:.2f} m from its middle"


@dataclass(frozen=True)
class Central:
    """It stands about the middle of the room."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """How far from it."""
        x, y = after.room.polygon.centroid.coords[0]
        off = math.dist(after[id].position[:2], (x, y))
        return off <= CENTRAL, f"{id} {off:.2f} m from the middle of the room"

    @property
    def tie(self) -> Tie | None:
        """None: the relation beside it says so."""
        return None


@dataclass(frozen=True)
class MidOf:
    """Its middle is on the line through the middle of a thing, along that thing's front or across."""

    anchor: str
    across: bool = False

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """How far it is off that line."""
        ahead, left = things(after, self.anchor)[0].to_local(after[id].position[:2])
        off = abs(ahead if self.across else left)
        return off <= MID_WALL, f"{id} {off:.2f} m off the middle of {self.anchor}"

    @property
    def tie(self) -> Tie | None:
        """None: the language of plans has no word for it."""
        return None


@dataclass(frozen=True)
class Midway(Related):
    """It is as far from one thing as from another, seen along the line between them, and across that at that line."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """How far it is off the middle of that line, and how far its outline is from the line."""
        off, _ = self.off(after, after[id].position[:2])
        one, other = (things(after, name)[0].centre for name in self.anchors)
        aside = after[id].footprint.distance(LineString((one, other)))
        says = f"{id} {abs(off):.2f} m off the middle between {' and '.join(self.anchors)}"
        return abs(off) <= MID_WALL and aside <= BESIDE_LINE, f"{says}, {aside:.2f} m from the line"

    def off(self, scene: Scene, point: Vec2) -> tuple[float, Vec2]:
        """How far a point is past the middle towards the second thing [m], and the unit vector to that."""
        (ax, ay), (bx, by) = (things(scene, name)[0].centre for name in self.anchors)
        length = math.dist((ax, ay), (bx, by)) or 1.0
        way = ((bx - ax) / length, (by - ay) / length)
        return (point[0] - (ax + bx) / 2) * way[0] + (point[1] - (ay + by) / 2) * way[1], way


@dataclass(frozen=True)
class Amid(Related):
    """It is between two things: its middle in the gap that is between them, and not before or beside that."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """The relation, how far its middle is off the gap along the way between them, and how far beside it."""
        held, says = super().check(before, after, id)
        one, other = (things(after, name)[0] for name in self.anchors)
        if one.kind != "object" or other.kind != "object":
            return held, says
        (ax, ay), (bx, by) = (point.coords[0] for point in nearest_points(one.footprint, other.footprint))
        gap = math.dist((ax, ay), (bx, by))
        beside = unary_union([one.footprint, other.footprint]).convex_hull.distance(Point(after[id].position[:2]))
        if gap < TOUCHES:
            return False, f"{says}; {' and '.join(self.anchors)} touch each other"
        x, y, _ = after[id].position
        along = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / gap
        off = max(0.0, -along, along - gap)
        says += f", {gap:.2f} m apart" if off else ""
        return held and off <= EXACT and beside <= OFF_BETWEEN, says


@dataclass(frozen=True)
class Straight(Related):
    """It looks straight at something, within so many degrees."""

    within: float = STRAIGHT

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Between its gaze and the way to that."""
        held, says = super().check(before, after, id)
        mark = things(after, id)[0]
        if mark.front == "any":
            return held, says
        ways = [bearing(mark.centre, m.centre) for name in self.anchors for m in things(after, name)]
        return held and min(turn_between(mark.gaze, way) for way in ways) <= self.within, says


@dataclass(frozen=True)
class BySmall(Related):
    """It is next to something small on the same top, and nearer to that than to any other such thing."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """How far it is from that, and which of its kind is nearest."""
        held, says = super().check(before, after, id)
        if self.anchors[0] not in after:
            return held, says
        anchor, mark = after[self.anchors[0]], things(after, id)[0]
        alike = [p.id for p in after.placements if p.category == anchor.category and p.support == anchor.support]
        away = {name: ground_gap(mark, things(after, name)[0]) for name in (*alike, anchor.id) if name != id}
        nearest = min(away, key=lambda name: (away[name], name != anchor.id))
        says += f"; nearer to {nearest}" if nearest != anchor.id else ""
        level = abs(after[id].position[2] - anchor.position[2])
        says += f"; {level:.2f} m higher or lower" if level > SAME_TOP else ""
        return held and away[anchor.id] <= BY_SMALL and nearest == anchor.id and level <= SAME_TOP, says


@dataclass(frozen=True)
class AcrossEnd(Related):
    """It stands before or behind a thing: across from that at least in part, and what lies on the floor right at it."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """The relation, how much of the narrower of the two is across from the other, and how far it is off."""
        held, says = super().check(before, after, id)
        if not held:
            return held, says
        anchor, thing = things(after, self.anchors[0])[0], after[id]
        lefts = [anchor.to_local((x, y))[1] for x, y in list(thing.footprint.exterior.coords)]
        across = min(max(lefts), anchor.half[1]) - max(min(lefts), -anchor.half[1])
        share = max(0.0, across) / min(max(lefts) - min(lefts), 2 * anchor.half[1])
        far = facts_of(thing.category).is_in("covers") and ground_gap(things(after, id)[0], anchor) > LAID_AT
        says += "" if share >= BEFORE_SHARE else f", {share:.0%} of it across from that"
        return share >= BEFORE_SHARE and not far, says


@dataclass(frozen=True)
class Abreast(Related):
    """It stands beside a thing and looks the same way."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Both, and how far it is before or behind that thing."""
        held, says = super().check(before, after, id)
        thing = after[self.anchors[0]]
        ahead, left = thing.to_local(after[id].position[:2])
        turn = turn_between(after[id].yaw, thing.yaw)
        there = abs(ahead) <= LEVEL and abs(left) > abs(ahead) and turn <= TURN_EXACT
        return held and there, f"{says}, {abs(ahead):.2f} m before or behind it, turned {turn:.0f} degrees otherwise"


@dataclass(frozen=True)
class Across(Related):
    """It stands opposite a thing: turned to it, and before the middle of it."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Both, and how far it is beside the line ahead of that thing."""
        held, says = super().check(before, after, id)
        _, left = things(after, self.anchors[0])[0].to_local(after[id].position[:2])
        return held and abs(left) <= BESIDE_LINE, f"{says}, {abs(left):.2f} m beside its middle"


@dataclass(frozen=True)
class IntoCorner(Related):
    """It stands right in a corner, not only near it."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """How far from the corner it is, at most SNUG."""
        held, says = super().check(before, after, id)
        mark = things(after, id)[0]
        away = min((ground_gap(mark, corner) for corner in corners(after.room, self.anchors)), default=math.inf)
        return held and away <= SNUG, says


@dataclass(frozen=True)
class AtHead(Related):
    """It stands beside the end of a thing that is behind, as the head of a bed is."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Both, and how far behind the middle of that thing it is."""
        held, says = super().check(before, after, id)
        ahead, left = after[self.anchors[0]].to_local(after[id].position[:2])
        aside = abs(left) > after[self.anchors[0]].size[1] / 2
        at_end = -ahead >= HEAD * after[self.anchors[0]].size[0]
        return held and at_end and aside, f"{says}, {-ahead:.2f} m behind its middle"


@dataclass(frozen=True)
class Laid(Related):
    """It lies on a table before a seat of it."""

    seat: str = ""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """On it, and where from the seat."""
        held, says = super().check(before, after, id)
        ahead, left = after[self.seat].to_local(after[id].position[:2])
        there = 0.0 < ahead <= BEFORE_SEAT and abs(left) <= after[self.seat].size[1] / 2 + LEVEL / 2
        return held and there, f"{says}, {ahead:.2f} m before {self.seat} and {abs(left):.2f} m aside"


@dataclass(frozen=True)
class DrawnUp(Related):
    """A seat is drawn up to a table at one side of it."""

    side: RelationKind = "left_of"

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Both."""
        held, says = super().check(before, after, id)
        there = measure(after, self.side, id, self.anchors)
        table = after[self.anchors[0]]
        ahead, left = table.to_local(after[id].position[:2])
        at_side = {"in_front_of": ahead > 0, "behind": ahead < 0, "left_of": left > 0}.get(self.side, left < 0)
        return held and there.holds and at_side, f"{says}; {there.measured}"


@dataclass(frozen=True)
class Untied:
    """What has no word in the language of plans."""

    @property
    def tie(self) -> Tie | None:
        """None."""
        return None


@dataclass(frozen=True)
class Unhidden(Untied):
    """A screen stands neither before nor behind another one on the same top."""

    screens: tuple[str, ...]

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """How far it stands beside each of them, less than half of both."""
        mine = after[id]
        there = [after[name] for name in self.screens if name in after and after[name].support == mine.support]
        for other in there:
            turn = math.radians(mine.yaw - other.yaw)
            wide = abs(math.cos(turn)) * mine.size[1] + abs(math.sin(turn)) * mine.size[0]
            lacking = (wide + other.size[1]) / 2 - abs(other.to_local(mine.position[:2])[1])
            if lacking > LEAST:
                return False, f"{id} hides {lacking:.2f} m of {other.id}, or is hidden by it"
            if (off := turn_between(mine.yaw, other.yaw)) > INTO_ROOM:
                return False, f"{id} is turned {off:.0f} degrees otherwise than {other.id}"
        return True, f"{id} beside {', '.join(p.id for p in there) or 'no other screen'}"


@dataclass(frozen=True)
class SeatRoom(Untied):
    """Somebody can sit before it."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """How much floor of the room is free before its middle, of seats and what lies flat aside [m]."""
        mine, half = after[id], after[id].size[0] / 2
        solid = [p for p in after.placements if after.asset_of(p).collides and p.position[2] < SEAT_HEIGHT]
        solid = [p for p in solid if p.id != id and not facts_of(p.category).is_in("seating") and p.support == "floor"]
        near, far, aside = half, half + SEAT_DEPTH, SEAT_WIDTH / 2
        ends = [mine.to_room(end) for end in ((near, -aside), (far, -aside), (far, aside), (near, aside))]
        strip = Polygon(ends)
        taken = float(strip.difference(after.room.polygon).area)
        taken += sum(float(p.footprint.intersection(strip).area) for p in solid)
        free = SEAT_DEPTH - taken / SEAT_WIDTH
        return free >= SEAT_DEPTH - EXACT, f"{free:.2f} m to sit before {id}"


@dataclass(frozen=True)
class Nearing(Untied):
    """It comes nearer to something or goes away from it, by so much [m] where that is said, or a bit."""

    anchors: tuple[str, ...]
    nearer: bool
    by: float | None = None
    slight: bool = False

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """The distance between the outlines, and where these touch that between the middles."""
        old, new = self.of(before, id), self.of(after, id)
        change = old - new if self.nearer else new - old
        if self.by is not None and not self.nearer and old < LEAST and self._is_less_over(before, after, id):
            change = max(change, min(self.by, math.dist(before[id].position[:2], after[id].position[:2])))
        least = LEAST if self.slight else AWAY
        wanted = self.by - EXACT if self.by is not None else min(LEAST, old / 3) if self.nearer else least
        step = math.dist(before[id].position[:2], after[id].position[:2])
        turn = turn_between(before[id].yaw, after[id].yaw)
        exact = self.by is None or (change <= self.by + EXACT and step <= ASIDE * self.by and turn <= TURN_EXACT)
        says = f"{old:.2f} m from {', '.join(self.anchors)} before, {new:.2f} m now"
        if self.by is not None and not exact:
            says += f", {step:.2f} m from where it was"
        return change >= max(wanted, 1e-3) and exact, says

    def _is_less_over(self, before: Scene, after: Scene, id: str) -> bool:
        """Whether something stands less over or under the others than before."""
        shares = [
            sum(
                float(scene[id].footprint.intersection(scene[name].footprint).area)
                for name in self.anchors
                if name in scene
            )
            for scene in (before, after)
        ]
        return shares[1] < shares[0]

    def of(self, scene: Scene, id: str) -> float:
        """The distance now [m]."""
        marks = [mark for name in self.anchors for mark in things(scene, name)]
        return min((ground_gap(things(scene, id)[0], mark) for mark in marks), default=math.inf)

    @property
    def tie(self) -> Tie | None:
        """Near it, or far from it."""
        return Tie(kind="near" if self.nearer else "far", anchors=self.anchors)


@dataclass(frozen=True)
class Apart(Untied):
    """It stands so far from something [m], or at least ("ge") or at most ("le") so far."""

    anchors: tuple[str, ...]
    away: float
    bound: str = ""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """The distance between the outlines, within EXACT."""
        now = self.of(after, id)
        off = {"ge": self.away - now, "le": now - self.away}.get(self.bound, abs(now - self.away))
        return off <= EXACT, f"{id} {now:.2f} m from {', '.join(self.anchors)}"

    def of(self, scene: Scene, id: str) -> float:
        """The distance now [m]."""
        return Nearing(self.anchors, nearer=False).of(scene, id)


@dataclass(frozen=True)
class Turned(Untied):
    """It is turned to one of these yaws [degrees]."""

    yaws: tuple[float, ...]

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Within TURN_EXACT."""
        turn = min(turn_between(after[id].yaw, yaw) for yaw in self.yaws)
        return turn <= TURN_EXACT, f"yaw {before[id].yaw:g} before, {after[id].yaw:g} now" if id in before else ""


@dataclass(frozen=True)
class ToWall(Untied):
    """It looks straight at a wall."""

    wall: str

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Between its gaze and the way to the wall, within TO_WALL degrees."""
        if after.asset_of(after[id]).front == "any":
            return True, f"{id} faces every way"
        turn = turn_between(things(after, id)[0].gaze, after.room.wall(self.wall).yaw + 180.0)
        return turn <= TO_WALL, f"front of {id} {turn:.0f} degrees off the way to {self.wall}"


@dataclass(frozen=True)
class BackTo(Untied):
    """Its back is to something."""

    anchors: tuple[str, ...]

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Between its gaze and the way away from what is behind it, within BACK_TO degrees."""
        if after.asset_of(after[id]).front == "any":
            return True, f"{id} has no back"
        mark = things(after, id)[0]
        behind = min((m for name in self.anchors for m in things(after, name)), key=lambda m: ground_gap(mark, m))
        x, y = nearest_points(place_of(behind), Point(mark.centre))[0].coords[0]
        away = math.degrees(math.atan2(mark.centre[1] - y, mark.centre[0] - x))
        turn = turn_between(mark.gaze, away)
        return turn <= BACK_TO, f"back of {id} {turn:.0f} degrees off {', '.join(self.anchors)}"


@dataclass(frozen=True)
class Hung(Untied):
    """It hangs on its wall, and does not stand on the floor before it."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Its lower edge is at least LOW_HUNG above the floor; nothing is said of that."""
        return after[id].position[2] >= LOW_HUNG, ""


@dataclass(frozen=True)
class Level(Untied):
    """Its middle is as high up as that of something else."""

    anchor: str

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Between the two, within EXACT."""
        off = middle_height(after[id]) - middle_height(after[self.anchor])
        return abs(off) <= EXACT, f"middle of {id} {off:+.2f} m above that of {self.anchor}"


def middle_height(placement: Placement) -> float:
    """How high up the middle of something is [m]."""
    return placement.position[2] + placement.size[2] / 2


@dataclass(frozen=True)
class IntoRoom(Untied):
    """Its front points away from the wall that it is nearest to, or to the middle of the room."""

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Within INTO_ROOM degrees."""
        placement = after[id]
        if after.asset_of(placement).front == "any":
            return True, f"{id} faces every way"
        mark = things(after, id)[0]
        wall = min(things(after, "wall"), key=lambda w: ground_gap(mark, w))
        x, y = after.room.polygon.centroid.coords[0]
        middle = math.degrees(math.atan2(y - placement.position[1], x - placement.position[0]))
        turn = min(turn_between(placement.yaw, wall.yaw), turn_between(placement.yaw, middle))
        return turn <= INTO_ROOM, f"front of {id} {turn:.0f} degrees off the way into the room"


@dataclass(frozen=True)
class At(Untied):
    """Its middle is so near to a point [m]."""

    point: Vec2
    reach: float = EXACT
    height: float | None = None

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """The distance, and of what hangs that of its height."""
        x, y, z = after[id].position
        away = math.dist((x, y), self.point)
        if self.height is not None:
            away = max(away, abs(z - self.height))
        return away <= self.reach, f"{id} {away:.2f} m from ({self.point[0]:.2f}, {self.point[1]:.2f})"


@dataclass(frozen=True)
class Spot(At):
    """It stands where another thing stood."""

    old: Placement | None = None

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """The distance between their middles, which may differ by half of what one is longer than the other."""
        old = self.old
        more = abs(max(after[id].size[:2]) - max(old.size[:2])) / 2 if old is not None else 0.0
        away = max(math.dist(after[id].position[:2], self.point), self.higher(after[id]))
        return away <= self.reach + more, f"{id} {away:.2f} m from where {old.id if old is not None else 'it'} was"

    def higher(self, placement: Placement) -> float:
        """How much higher or lower than the other its middle hangs, where both hang on a wall [m]; else 0."""
        old = self.old
        if old is None or not (old.support.endswith("_wall") and placement.support.endswith("_wall")):
            return 0.0
        return abs(placement.position[2] + placement.size[2] / 2 - old.position[2] - old.size[2] / 2)


@dataclass(frozen=True)
class Traded(Untied):
    """It stands nearer to where another thing stood than to where it stood itself."""

    point: Vec2

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """How far it is from either place."""
        old, new = before[id].position[:2], after[id].position[:2]
        says = f"{id} {math.dist(new, self.point):.2f} m from there and {math.dist(new, old):.2f} m from where it was"
        return math.dist(new, self.point) < math.dist(new, old), says


@dataclass(frozen=True)
class Raised(Untied):
    """It stands higher than before, or lower."""

    up: bool = True

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """By at least LEAST."""
        step = after[id].position[2] - before[id].position[2]
        return step * (1.0 if self.up else -1.0) >= LEAST, f"{id} {abs(step):.2f} m {'higher' if step > 0 else 'lower'}"


@dataclass(frozen=True)
class OnSide(Untied):
    """It stands in the half of the room that is at a wall."""

    wall: str

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """How far its middle is from the wall, which is less than that of the room is."""
        wall = after.room.wall(self.wall)
        away = wall.coordinates(after[id].position[:2])[1]
        x, y = after.room.polygon.centroid.coords[0]
        _, half = wall.coordinates((x, y))
        return away < half, f"{id} {away:.2f} m from {self.wall}, the middle of the room {half:.2f} m"


@dataclass(frozen=True)
class Along(Untied):
    """It has moved in a direction of the room (unit vector), further than to either side of it."""

    direction: Vec3

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """How far along it."""
        step = [b - a for a, b in zip(before[id].position, after[id].position, strict=True)]
        along = sum(s * d for s, d in zip(step, self.direction, strict=True))
        aside = math.sqrt(max(0.0, sum(s * s for s in step) - along * along))
        return along >= LEAST and aside <= along, f"{id} has moved {along:.2f} m that way and {aside:.2f} m aside"


@dataclass(frozen=True)
class Elsewhere(Untied):
    """It stands at another place than before."""

    least: float = ELSEWHERE

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """The distance between the two."""
        away = math.dist(before[id].position, after[id].position)
        return away >= self.least, f"{id} {away:.2f} m from where it was"


@dataclass(frozen=True)
class Free(Untied):
    """It does not stand in a part of the room."""

    place: str

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """Whether any box of the part is taken by it or by what rests on it."""
        mine = {id, *(rider.id for rider in after.riders(id))}
        others = frozenset(p.id for p in after.placements if p.id not in mine)
        found = [takers(after, part, besides=others) for part in parts(after.room, self.place)]
        taken = min(found, key=len, default=())
        return not taken, f"{', '.join(taken) or id} {'in' if taken else 'out of'} the {self.place}"


@dataclass(frozen=True)
class OutOf(Untied):
    """It takes nothing of a stretch of floor."""

    outline: Polygon
    name: str

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """How much of it is taken by the footprint [m2]."""
        taken = float(after[id].footprint.intersection(self.outline).area)
        return (
            taken <= ENTERED,
            f"{id} takes {taken:.2f} m2 of {self.name}" if taken > ENTERED else f"{id} out of {self.name}",
        )


@dataclass(frozen=True)
class Region:
    """A round part of the floor [m]."""

    centre: Vec2
    reach: float
    name: str

    def holds(self, mark: Landmark) -> bool:
        """Whether the middle of something is in it."""
        return math.dist(mark.centre, self.centre) <= self.reach


@dataclass(frozen=True)
class Within(Untied):
    """Its middle is in a region, or is not."""

    region: Region
    inside: bool = True

    def check(self, before: Scene, after: Scene, id: str) -> Finding:
        """The distance from the middle of the region."""
        mark = things(after, id)[0]
        away = math.dist(mark.centre, self.region.centre)
        return self.region.holds(mark) == self.inside, f"{id} {away:.2f} m from the middle of {self.region.name}"


def overruled(goal: Goal, later: Iterable[Goal]) -> bool:
    """Whether what is asked of the same object later may undo a goal: another step, another way to face."""
    if _is_turn(goal):
        return any(_is_turn(other) for other in later)
    if isinstance(goal, At | Along | Nearing | Elsewhere):
        return any(not _is_turn(other) for other in later)
    return False


def _is_turn(goal: Goal) -> bool:
    return isinstance(goal, Turned | IntoRoom | ToWall | BackTo | SeatRoom) or (
        isinstance(goal, Related) and goal.kind in ("facing", "opposite")
    )
