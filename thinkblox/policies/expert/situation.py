"""The situation in which ideas are had: what stands, what is to come, and the floor that is spoken for."""

import math
from collections.abc import Collection
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from msgspec import structs

from thinkblox.assets import Facts, facts_of, kind_of, revision
from thinkblox.assets.sizing import size_for
from thinkblox.knowledge.uses import uses
from thinkblox.observe import Kind, Layout, Observation
from thinkblox.plan import Target, Tie, carries, is_object
from thinkblox.policies.expert.needs import BEFORE_BOARD, Need, need, seat_need
from thinkblox.policies.expert.sizing import SHRINK
from thinkblox.scene.asset import AssetCard, Mount
from thinkblox.scene.free_parts import parts
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Rects, outside, overlap_depth
from thinkblox.scene.room import Opening, Room, turn_between
from thinkblox.scene.support import ON_FLOOR
from thinkblox.scene.zones import beside, joined
from thinkblox.value import Vec2, Vec3

WINDOW_DEPTH = 0.3
"""How far into the room a window is kept free of tall furniture [m]."""

FULL = 0.45
"""Share of a floor that furniture takes at most for it to be used."""
EYES = 1.1
"""Height of the eyes of who sits in a lounge seat [m]."""

WITHIN = 0.01
"""Depth from which the box of one thing reaches into that of another [m]."""


@dataclass(frozen=True)
class Situation:
    """An observation with what the ideas need worked out once."""

    observation: Observation

    def without(self, ids: Collection[str]) -> "Situation":
        """The situation as it would be had some of what stands not come yet."""
        layout = self.observation.layout
        others = tuple(p for p in layout.placements if p.id not in ids)
        if len(others) == len(layout.placements):
            return self
        return Situation(structs.replace(self.observation, layout=structs.replace(layout, placements=others)))

    @property
    def scene(self) -> Layout:
        """The layout so far."""
        return self.observation.layout

    @property
    def room(self) -> Room:
        """The room."""
        return self.observation.layout.room

    @property
    def asset(self) -> AssetCard:
        """What is to be placed."""
        return self.observation.asset

    @property
    def target(self) -> Target:
        """The plan's entry for it."""
        return self.observation.target

    @cached_property
    def facts(self) -> Facts:
        """What is known of its kind."""
        return facts_of(self.target.category)

    @cached_property
    def mount(self) -> Mount:
        """What it is placed on: another thing, where the plan puts it on or into one that has a place for it."""
        carriers = (p for tie in self.target.ties if carries(tie) for p in self.placed(tie.anchors))
        lifted = any(self._has_room(self.scene.asset_of(p)) for p in carriers)
        return "surface" if self.asset.mount == "floor" and self.asset.collides and lifted else self.asset.mount

    def _has_room(self, carrier: AssetCard) -> bool:
        """Whether some surface of a carrier is large enough for it, if need be for a smaller one on its foot alone."""
        x0, y0, x1, y1 = self.asset.foot or (0.0, 0.0, *self.size[:2])
        short, long = sorted((SHRINK[-1] * (x1 - x0), SHRINK[-1] * (y1 - y0)))
        return carrier.collides and any(short <= min(s.size) and long <= max(s.size) for s in carrier.surfaces)

    @property
    def size(self) -> Vec3:
        """Its size [m]."""
        return self.asset.size

    @cached_property
    def solid(self) -> tuple[Placement, ...]:
        """What it could bump into: everything but rugs."""
        return tuple(p for p in self.scene.placements if self.scene.asset_of(p).collides)

    @cached_property
    def solids(self) -> Rects:
        """The bounding boxes of `solid`."""
        return Rects.of_placements(self.solid)

    @cached_property
    def siblings(self) -> tuple[Placement, ...]:
        """Placed members of its own request."""
        ids = {t.id for t in self.observation.plan.targets if t.request == self.target.request}
        return tuple(p for p in self.scene.placements if p.id in ids)

    @cached_property
    def door_zones(self) -> Rects:
        """The floor that each door swings over, or is entered by, and must stay free."""
        return Rects.of(
            [
                zone_before(self.room, opening, depth=opening.swept, bottom=0.0, top=opening.height)
                for opening in self.room.openings
                if opening.kind == "door"
            ]
        )

    @cached_property
    def window_zones(self) -> Rects:
        """The space right before each window."""
        return Rects.of(
            [
                zone_before(self.room, o, depth=WINDOW_DEPTH, bottom=o.sill, top=o.sill + o.height)
                for o in self.room.openings
                if o.kind == "window"
            ]
        )

    @cached_property
    def large(self) -> tuple[Placement, ...]:
        """What one walks round: standing on the floor, and neither flat nor small."""
        return tuple(p for p in self.solid if p.position[2] < 0.3 and is_large(p.size))

    @cached_property
    def seats(self) -> tuple[str, ...]:
        """Seats, whose boxes reach over a table that they are drawn up to, though they themselves do not."""
        return tuple(p.id for p in self.solid if is_seat(p.category))

    @cached_property
    def relatives(self) -> frozenset[str]:
        """What the plan puts close to the target: its anchors, what shares one of them, and the rest of its rows."""
        anchors = _objects(self.target)
        shared = (t.id for t in self.observation.plan.targets if anchors & _objects(t))
        lined = any(tie.kind == "in_rows" for tie in self.target.ties)
        return frozenset(anchors).union(shared, (p.id for p in self.siblings) if lined else ())

    @cached_property
    def clearances(self) -> Rects:
        """The floor that people need who use what stands here, for doors, drawers and themselves."""
        case = self.facts.is_in("cases")
        beside_it = {p.id for p in self.solid if case and facts_of(p.category).is_in("cases")}
        others = [p for p in self.solid if p.id not in self.relatives or p.id in beside_it]
        boards = Rects.of_placements(tuple(p for p in others if p.position[2] >= 0.5 and is_board(p.category)))
        written_at = beside(boards, "front", BEFORE_BOARD)
        hung = [(p, use) for p in others if p.position[2] >= 0.5 for use in facts_of(p.category).uses]
        before = [beside(Rects.of_placements((p,)), "front", use.depth) for p, use in hung]
        return joined([written_at, *before, *(self._in_use(p) for p in others if p.position[2] < 0.5)])

    def _in_use(self, placement: Placement) -> Rects:
        asset, rect = self.scene.asset_of(placement), Rects.of_placements((placement,))
        zones: list[Rects] = []
        for use in uses(placement.category, placement.size, asset.front, asset.clearance):
            sides = [beside(rect, side, use.depth) for side in use.sides]
            taken = [float(overlap_depth(zone, self.solids).max(initial=0.0)) for zone in sides]
            taken = [t + float(outside(z, self.room.polygon)[0]) for t, z in zip(taken, sides, strict=True)]
            zones += [sides[i] for i in sorted(range(len(sides)), key=lambda i: taken[i])[: use.number]]
        return joined(zones)

    @cached_property
    def looked_across(self) -> tuple[tuple[Placement, Placement], ...]:
        """Lounge seats that stand, each with what the plan has it look at, or look at it: a screen, a fire."""
        found = []
        for target in self.observation.plan.targets:
            looks = (a for tie in target.ties if tie.kind in ("opposite", "facing") for a in tie.anchors)
            for other in self.placed(tuple(looks)) if target.id in self.scene else ():
                pair = sorted((self.scene[target.id], other), key=lambda p: not is_lounge(p.category))
                if [is_lounge(p.category) for p in pair] == [True, False] and pair[0].position[2] < ON_FLOOR:
                    found.append((pair[0], pair[1]))
        return tuple(found)

    @cached_property
    def views(self) -> Rects:
        """The floor between lounge seats and what they look at across the room, where both stand."""
        return Rects.of([_between(seat, other) for seat, other in self.looked_across])

    @cached_property
    def promised(self) -> Rects:
        """The floor by placed objects that is meant for what is still to come, other than the target."""
        zones: list[Rects] = []
        done: set[tuple[str, str]] = set()
        for later in self.observation.plan.targets:
            if later.id in self.scene or later.request == self.target.request:
                continue
            for tie in later.ties:
                kin = self.siblings if tie.kind == "in_front_of" else ()
                for anchor in (p for p in self.placed(tie.anchors) if p not in kin):
                    if anchor.id not in _objects(self.target) and (later.request, anchor.id) not in done:
                        done.add((later.request, anchor.id))
                        size = self.kind(later).size
                        wanted = seat_need(tie, of=anchor.size, size=size)
                        wanted = wanted or need(later, tie, of=anchor.category, size=size)
                        zones += _sides_meant(anchor, wanted)
                        if tie.kind == "opposite" and self.kind(later).mount == "floor":
                            zones.append(Rects.of(_across(self.room, anchor, size)))
        return joined(zones)

    @cached_property
    def kept_free(self) -> Rects:
        """The parts of the room that are to stay free, where the target is not itself called there."""
        own = {anchor for tie in self.target.ties if tie.asked for anchor in tie.anchors}
        named = zip(self.observation.plan.brief.free, self.observation.plan.free, strict=False)
        wanted = [part for place, part in named if own.isdisjoint((place, part))]
        return joined([parts(self.room, place)[0].boxes for place in wanted if parts(self.room, place)])

    @cached_property
    def reserved(self) -> Rects:
        """The middle of the room, when something later belongs there: asked for, or a table with its seats."""
        x, y = self.room.polygon.centroid.coords[0]
        later = [
            t for t in self.observation.plan.targets if t.id not in self.scene and t.request != self.target.request
        ]
        about = ("around", "at_long_side", "at_short_side")
        seated = {a for t in later for tie in t.ties if tie.kind in about for a in tie.anchors}
        rows = []
        for t in later:
            if not kind_of(t.category).flat and any(_is_amid(tie) and (tie.asked or t.id in seated) for tie in t.ties):
                side = max(self.kind(t).size[:2]) + 0.9
                rows.append(((x, y), (side, side), 0.0, 0.0, 1.5))
        loose = [t for t in later if t.id in seated and not any(map(_is_amid, t.ties))]
        amid = any(map(_is_amid, self.target.ties))
        if loose and not rows and not amid and not self._is_looked_across:
            rows.append(_in_the_middle(self.room, len(loose), self.kind(loose[0]).size))
        return Rects.of(rows)

    @cached_property
    def _is_looked_across(self) -> bool:
        """Whether lounge seats look at something across the room: the middle is theirs."""
        lounges = {t.id for t in self.observation.plan.targets if facts_of(t.category).is_in("lounges")}
        ties = (tie for t in self.observation.plan.targets for tie in t.ties if t.id not in lounges)
        return any(tie.kind in ("opposite", "facing") and not lounges.isdisjoint(tie.anchors) for tie in ties)

    @cached_property
    def is_mere_worktop(self) -> bool:
        """Whether nobody asked for it, and it is there for what is let into it: who uses that stands before it."""
        on = [t for t in self.followers if any(tie.kind == "on" and self.target.id in tie.anchors for tie in t.ties)]
        return not self.target.asked and any(facts_of(t.category).is_in("built_in") for t in on)

    @cached_property
    def spare(self) -> float:
        """How freely the furniture of the plan can stand: 0 where it takes FULL of the floor, 1 where half of that."""
        kinds = map(self.kind, self.observation.plan.targets)
        taken = sum(k.size[0] * k.size[1] for k in kinds if k.mount == "floor" and is_large(k.size))
        return min(1.0, max(0.0, 2.0 * (1.0 - taken / self.room.polygon.area / FULL)))

    @cached_property
    def followers(self) -> tuple[Target, ...]:
        """Later targets that refer to this one, or to what will stand on it."""
        ids = {self.target.id}
        found = []
        for target in self.observation.plan.targets:
            if ids & {anchor for tie in target.ties for anchor in tie.anchors}:
                found.append(target)
                if target.ties and target.ties[0].kind == "on":
                    ids.add(target.id)
        return tuple(found)

    def enclosing(self, anchor: Placement) -> tuple[str, ...]:
        """Ids of what the box of a placed thing reaches into: the bed above it, the shelf that it stands in.

        What it carries itself, as on its shelves, is none of that.
        """
        carried = {p.id for p in self.scene.riders(anchor.id)}
        depth = overlap_depth(Rects.of_placements((anchor,)), self.solids)[0]
        into = (p.id for p, deep in zip(self.solid, depth, strict=True) if deep > WITHIN and p.id != anchor.id)
        return tuple(id for id in into if id not in carried)

    def inside(self, anchor: Placement) -> tuple[Placement, ...]:
        """What is within the box of a placed thing: its middle over the other's outline, its base below its top."""
        found = []
        for p in self.solid:
            x, y = anchor.to_local((p.position[0], p.position[1]))
            within = abs(x) < anchor.size[0] / 2 and abs(y) < anchor.size[1] / 2
            if p.id != anchor.id and within and anchor.position[2] < p.position[2] < anchor.top:
                found.append(p)
        return tuple(found)

    def in_run(self, other: Target | Placement) -> bool:
        """Whether the target and another thing form one row along a wall."""
        return self.facts.runs_with(facts_of(other.category))

    def kind(self, later: Target) -> Kind:
        """What is known of a target that is yet to come: an ordinary one, as large as what is said of it makes it."""
        usual = self.observation.kinds[later.category]
        if not later.attributes and not any(later.size):
            return usual
        shares = _shares(later.category, later.attributes, revision())
        x, y, z = (asked or size * share for asked, size, share in zip(later.size, usual.size, shares, strict=True))
        return Kind(size=(x, y, z), mount=usual.mount)

    def alike(self, id: str) -> tuple[Placement, ...]:
        """The placed others of an object's request."""
        targets = self.observation.plan.targets
        request = next((t.request for t in targets if t.id == id), "")
        return self.placed(tuple(t.id for t in targets if t.request == request and t.id != id))

    def placed(self, ids: tuple[str, ...]) -> tuple[Placement, ...]:
        """Those of the ids that stand in the scene."""
        return tuple(self.scene[id] for id in ids if id in self.scene)


@lru_cache(maxsize=512)
def _shares(category: str, attributes: tuple[str, ...], revision: int) -> Vec3:
    """By what words about a thing change its size, along each axis."""
    kind = kind_of(category)
    said = size_for(kind, frozenset(attributes), np.random.default_rng(0))
    usual = size_for(kind, frozenset(), np.random.default_rng(0))
    return (said[0] / usual[0], said[1] / usual[1], said[2] / usual[2])


def _across(room: Room, anchor: Placement, size: Vec3) -> list[tuple[Vec2, Vec2, float, float, float]]:
    """The floor by the wall that a thing looks at, for what is to stand there, as rows of `Rects.of`."""
    rows = []
    for wall in room.walls:
        along, inward = wall.coordinates((anchor.position[0], anchor.position[1]))
        if turn_between(wall.yaw, anchor.yaw) > 179.0 and inward > 1.0 and 0.0 < along < wall.length:
            half = size[1] / 2
            middle = min(max(along, half), max(half, wall.length - half))
            rows.append((wall.point(middle, size[0] / 2), (size[0], size[1]), wall.yaw, 0.0, 1.5))
    return rows[:1]


def _between(one: Placement, other: Placement) -> tuple[Vec2, Vec2, float, float, float]:
    """The floor between two things, as wide as the narrower of them, as a row of `Rects.of`."""
    (ax, ay, _), (bx, by, _) = one.position, other.position
    length = math.hypot(bx - ax, by - ay)
    yaw = math.degrees(math.atan2(by - ay, bx - ax))
    return ((ax + bx) / 2, (ay + by) / 2), (length, min(one.size[1], other.size[1])), yaw, 0.0, EYES


def _is_amid(tie: Tie) -> bool:
    """Whether it belongs in the middle of the room, not of a table."""
    return tie.kind == "in_centre" and not any(map(is_object, tie.anchors))


def _in_the_middle(room: Room, count: int, size: Vec3) -> tuple[Vec2, Vec2, float, float, float]:
    """The floor of some tables with their seats in the middle of a room, as a row of `Rects.of`."""
    length, width = count * (max(size[:2]) + 1.2), min(size[:2]) + 1.6
    ex, ey = room.extent
    half = (min(length, ex - 1.0), min(width, ey - 1.0)) if ex >= ey else (min(width, ex - 1.0), min(length, ey - 1.0))
    x, y = room.polygon.centroid.coords[0]
    return ((x, y), half, 0.0, 0.0, 1.5)


def is_seat(category: str) -> bool:
    """Whether people sit on such a thing."""
    return facts_of(category).is_in("seating")


def is_lounge(category: str) -> bool:
    """Whether people lean back in such a thing."""
    return facts_of(category).is_in("lounges")


def is_board(category: str) -> bool:
    """Whether one stands before such a thing to write on it."""
    return facts_of(category).is_in("written_on")


def is_large(size: Vec3) -> bool:
    """Whether one has to walk round a thing of that size."""
    return min(size[:2]) > 0.25 and max(size[:2]) > 0.45 and size[2] > 0.25


def _objects(target: Target) -> set[str]:
    """The objects that a target's ties name, without the places of the room."""
    return set(target.depends_on)


def _sides_meant(anchor: Placement, wanted: Need | None) -> list[Rects]:
    if wanted is None or wanted.number < len(wanted.sides):
        return []
    rect = Rects.of_placements((anchor,))
    return [beside(rect, side, wanted.depth, width=wanted.width) for side in wanted.sides]


def zone_before(
    room: Room, opening: Opening, *, depth: float, bottom: float, top: float
) -> tuple[Vec2, Vec2, float, float, float]:
    """The box before an opening, as a row of `Rects.of`."""
    wall = room.walls[opening.wall]
    centre = wall.point(opening.offset + opening.width / 2, depth / 2)
    return (centre, (depth, opening.width), wall.yaw, bottom, top)
