"""One idea of where an object could go, and the situation in which ideas are had."""

from dataclasses import dataclass
from functools import cached_property

from thinkblox.asset import Asset
from thinkblox.assets import CATALOGUE
from thinkblox.consistency import wall_gap
from thinkblox.observe import Observation
from thinkblox.phrases import Constraint
from thinkblox.plan import Target
from thinkblox.rects import Rects
from thinkblox.room import Opening, Room, Wall
from thinkblox.scene import Placement, Scene
from thinkblox.value import Vec2, Vec3

SEATS = frozenset("chair office_chair armchair rocking_chair sofa bench bean_bag child_chair stool bar_stool".split())
"""What people sit on."""
WALL_GAP = 0.02
"""Left free between furniture and the wall behind it, for the skirting board [m]."""
WINDOW_DEPTH = 0.3
"""How far into the room a window is kept free of tall furniture [m]."""


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


@dataclass(frozen=True)
class Situation:
    """An observation with what the ideas need worked out once."""

    observation: Observation

    @property
    def scene(self) -> Scene:
        """The layout so far."""
        return self.observation.scene

    @property
    def room(self) -> Room:
        """The room."""
        return self.observation.scene.room

    @property
    def asset(self) -> Asset:
        """What is to be placed."""
        return self.observation.asset

    @property
    def target(self) -> Target:
        """The plan's entry for it."""
        return self.observation.target

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
        """The floor that each door swings over, and must stay free."""
        return Rects.of(
            [
                zone_before(self.room, opening, depth=opening.width, bottom=0.0, top=opening.height)
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
    def used(self) -> tuple[Placement, ...]:
        """What needs free floor before its front."""
        return tuple(
            p
            for p in self.solid
            if self.scene.asset_of(p).clearance > 0.0 and p.position[2] < 0.5 and p.category not in SEATS
        )

    @cached_property
    def clearances(self) -> Rects:
        """The floor that each of `used` needs, for doors, drawers and whoever stands there."""
        rows = []
        for p in self.used:
            depth = self.scene.asset_of(p).clearance
            rows.append((p.to_room((p.size[0] / 2 + depth / 2, 0.0)), (depth, p.size[1]), p.yaw, 0.05, 1.8))
        return Rects.of(rows)

    @cached_property
    def reserved(self) -> Rects:
        """The middle of the room, when something later is asked to stand there."""
        x, y = self.room.polygon.centroid.coords[0]
        rows = []
        for t in self.observation.plan.targets:
            central = any(tie.kind == "in_centre" and tie.asked for tie in t.ties)
            if central and t.id not in self.scene and t.request != self.target.request:
                size = CATALOGUE[t.category].size
                rows.append(((x, y), (max(size[:2]) + 0.9, max(size[:2]) + 0.9), 0.0, 0.0, 1.5))
        return Rects.of(rows)

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

    def placed(self, ids: tuple[str, ...]) -> tuple[Placement, ...]:
        """Those of the ids that stand in the scene."""
        return tuple(self.scene[id] for id in ids if id in self.scene)


def zone_before(
    room: Room, opening: Opening, *, depth: float, bottom: float, top: float
) -> tuple[Vec2, Vec2, float, float, float]:
    """The box before an opening, as a row of `Rects.of`."""
    wall = room.walls[opening.wall]
    centre = wall.point(opening.offset + opening.width / 2, depth / 2)
    return (centre, (depth, opening.width), wall.yaw, bottom, top)


def pose_words(room: Room, placement: Placement, *, beyond: tuple[str, ...] = ()) -> tuple[Constraint, ...]:
    """Distances from the two nearest walls at right angles, else the coordinates: enough to find the place again."""
    gaps = sorted((wall_gap(wall, placement), wall.name) for wall in room.walls if wall.name not in beyond)
    gaps = [(gap, name) for gap, name in gaps if gap >= 0.0]
    for gap, name in gaps:
        inward = room.wall(name).inward
        if all(abs(_dot(inward, room.wall(other).inward)) < 0.01 for other in beyond):
            return (Constraint(kind="from_wall", anchors=(name,), values=(round(gap, 3),)),)
    return (Constraint(kind="at", values=(round(placement.position[0], 3), round(placement.position[1], 3))),)


def _dot(a: Vec2, b: Vec2) -> float:
    return a[0] * b[0] + a[1] * b[1]


def turned(yaw: float) -> Constraint:
    """The words for a yaw."""
    return Constraint(kind="turned", values=(round(yaw % 360.0, 2) % 360.0,))


def opposite_yaw(wall: Wall) -> float:
    """Yaw of an object that faces a wall [degrees]."""
    return (wall.yaw + 180.0) % 360.0
