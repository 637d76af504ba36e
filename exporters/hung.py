"""Doors and windows as things: a leaf on a hinge in its frame, and a pane in its frame, all within the walls.

What is verified has holes in its walls where doors and windows are. These are for who wants more than that: they stand
behind the inner side of the walls, so that nothing in the room touches them, and leaves open into the zone that is
kept free of furniture.
"""

import hashlib
import math

import msgspec
import shapely
from shapely import Polygon

from thinkblox.scene.asset import Asset, Joint, Link, Shape
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, Room, Wall
from thinkblox.scene.scene import Scene
from thinkblox.scene.surfaces import Surfaces
from thinkblox.sim.build import yaw_quat
from thinkblox.sim.geometry.materials import usual_weight
from thinkblox.sim.geometry.solid import shape_area, shape_volume
from thinkblox.sim.geometry.walls import wall_depth, wall_slabs
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.settle import SettledState
from thinkblox.value import Vec2

LEAF = "door leaf"
"""The link that turns."""
OPENS = 90.0
"""How far [degrees]; further and it would meet its own frame."""
_LINING, _GAP, _THICK = 0.02, 0.004, 0.04
"""Of a frame's boards, round a leaf and of a leaf, where an opening is large enough [m]."""
_LEVER = 1.0
"""Height of a lever [m]."""
_HOLLOW = 0.5
"""Of what a leaf of solid wood weighs, what one of boards on a core does."""
_BAR, _LIGHT = 0.05, 0.75
"""Widths of a window's bars and of one of its lights [m]."""
_METAL, _PANE = (0.55, 0.53, 0.50), (0.80, 0.90, 1.0)
_MEETS = 1e-6
"""Two areas that share less do not meet [m2]."""


def with_doors(scene: Scene, state: SettledState, physics: Physics) -> tuple[Scene, SettledState]:
    """The scene with a thing in each of its openings, after all others, and the state at rest with all leaves shut.

    They are called "door_1_frame" in the opening "door_1". Nothing is put where a narrow part of the floor plan leaves
    no wall, and a leaf that would meet another wall at a corner does not turn.
    """
    ids, qpos, poses = {placement.id for placement in scene.placements}, list(state.qpos), dict(state.poses)
    placements, assets = list(scene.placements), dict(scene.assets)
    for opening in scene.room.openings:
        wall = scene.room.walls[opening.wall]
        depth = wall_depth(scene.room, wall, physics.wall_thickness)
        if depth <= 0.0:
            continue
        shut = _meets_wall(scene.room, wall, opening, physics.wall_thickness)
        asset = _asset(opening, depth, scene.surfaces, shut=shut)
        x, y = wall.point(opening.offset + opening.width / 2, -depth / 2)
        placement = Placement(
            id=_free_id(f"{opening.id}_frame", ids), category=opening.kind, asset=asset.id,
            position=(x, y, opening.sill), yaw=wall.yaw, size=asset.size,
        )  # fmt: skip
        ids.add(placement.id)
        placements.append(placement)
        assets[asset.id] = asset
        if asset.made_of[2]:
            qpos.append(0.0)
            poses[f"{placement.id}/{LEAF}"] = (placement.position, yaw_quat(placement.yaw))
    whole = msgspec.structs.replace(scene, placements=tuple(placements), assets=assets)
    return whole, msgspec.structs.replace(state, qpos=tuple(qpos), poses=poses)


def _free_id(wanted: str, taken: set[str]) -> str:
    id, number = wanted, 1
    while id in taken:
        number += 1
        id = f"{wanted}_{number}"
    return id


def _asset(opening: Opening, depth: float, surfaces: Surfaces, *, shut: bool) -> Asset:
    """What fills an opening; `shut` is a door whose leaf does not turn."""
    if opening.kind == "window":
        links: tuple[Link, ...] = (Link(name="frame", shapes=_window(opening, depth, surfaces)),)
    else:
        links = _door(opening, depth, surfaces)
        if shut:
            links = (links[0], msgspec.structs.replace(links[1], joint=None))
    shapes = [shape for link in links for shape in link.shapes]
    weight = sum(usual_weight(shape.material, shape_volume(shape), shape_area(shape)) for shape in shapes)
    content = hashlib.sha256(msgspec.json.encode(links)).hexdigest()
    return Asset(
        id=f"{opening.kind}-{content[:8]}", category=opening.kind, description=f"a {opening.kind} in its frame",
        size=(depth, opening.width, opening.height), mass=_HOLLOW * weight, friction=0.5, mount="wall", links=links,
    )  # fmt: skip


def _meets_wall(room: Room, wall: Wall, opening: Opening, thickness: float) -> bool:
    """Whether another wall is where a leaf would be, as beside a corner that points into the room."""
    ends = (opening.offset, opening.offset + opening.width)
    own = Polygon([wall.point(along, inward) for along, inward in zip(
        (ends[0], ends[1], ends[1], ends[0]), (-thickness, -thickness, 0.0, 0.0), strict=True)])  # fmt: skip
    for slab in wall_slabs(room, thickness):
        (x, y, _), (long, deep, _) = slab.position, slab.size
        c, s = math.cos(math.radians(slab.yaw)) / 2, math.sin(math.radians(slab.yaw)) / 2
        corners = [(x + i * long * c - j * deep * s, y + i * long * s + j * deep * c) for i, j in _ROUND]
        level = slab.position[2] + slab.size[2] / 2 > opening.sill + _GAP
        level = level and slab.position[2] - slab.size[2] / 2 < opening.sill + opening.height - _GAP
        if level and shapely.area(shapely.intersection(own, Polygon(corners))) > _MEETS:
            return True
    return False


_ROUND = ((-1, -1), (1, -1), (1, 1), (-1, 1))


class _Boxes:
    """Boxes by their ends in an opening: into the room and up [m], and from its middle to the left."""

    def __init__(self, depth: float) -> None:
        self._depth = depth

    def box(
        self,
        inward: tuple[float, float],
        left: tuple[float, float],
        up: tuple[float, float],
        colour: tuple[float, float, float],
        **more: str,
    ) -> Shape:
        """One box; `inward` is in parts of the wall's depth, 0 on its inner side and -1 on its outer one."""
        ends = [((inward[0] + 0.5) * self._depth, (inward[1] + 0.5) * self._depth), left, up]
        x, y, z = ((low + high) / 2 for low, high in ends)
        a, b, c = (high - low for low, high in ends)
        return Shape(kind="box", size=(a, b, c), position=(x, y, z), colour=colour, **more)  # type: ignore[arg-type]


def _door(opening: Opening, depth: float, surfaces: Surfaces) -> tuple[Link, Link]:
    boxes, half, high = _Boxes(depth), opening.width / 2, opening.height
    lining, gap = min(_LINING, opening.width / 10, high / 10), min(_GAP, opening.width / 50, high / 50)
    within, trim = (-0.9, -0.05), surfaces.trim
    frame = (
        boxes.box(within, (half - lining, half), (0.0, high), trim),
        boxes.box(within, (-half, lining - half), (0.0, high), trim),
        boxes.box(within, (lining - half, half - lining), (high - lining, high), trim),
    )
    side = half - lining - gap
    # Its far corner turns clear of the frame.
    thick = min(_THICK, 0.4 * depth, math.sqrt(3.0 * gap * side)) / depth
    face, top = -0.3, high - lining - gap
    # A wall runs to its right, seen from within: its start is on the left of who faces the room.
    sign = 1.0 if opening.hinge == "start" else -1.0
    lever = min(_LEVER, high / 2)
    away = sorted((-sign * (side - 0.2 * min(side, 0.3)), -sign * (side - 0.7 * min(side, 0.3))))
    rose = sorted((-sign * (side - 0.2 * min(side, 0.3)), -sign * (side - 0.3 * min(side, 0.3))))
    inward = opening.opens == "in"

    def deep(low: float, high: float) -> Vec2:
        """A range of depths within the wall, from the face that the leaf turns out of."""
        return (low, high) if inward else (-1.0 - high, -1.0 - low)

    leaf = (
        boxes.box(deep(face - thick, face), (-side, side), (gap, top), surfaces.door),
        boxes.box(deep(face, -0.14), (rose[0], rose[1]), (lever - 0.01, lever + 0.01), _METAL, material="metal"),
        boxes.box(deep(-0.14, -0.02), (away[0], away[1]), (lever - 0.01, lever + 0.01), _METAL, material="metal"),
    )
    out = 1.0 if inward else -1.0
    joint = Joint(
        kind="hinge",
        axis=(0.0, 0.0, sign * out),
        anchor=(out * (face + 0.5) * depth, sign * side, 0.0),
        lower=0.0,
        upper=OPENS,
    )
    return Link(name="frame", shapes=frame), Link(name=LEAF, shapes=leaf, joint=joint)


def _window(opening: Opening, depth: float, surfaces: Surfaces) -> tuple[Shape, ...]:
    boxes, half, high = _Boxes(depth), opening.width / 2, opening.height
    bar, within, trim = min(_BAR, opening.width / 8, high / 8), (-0.85, -0.35), surfaces.trim
    lights = max(round(opening.width / _LIGHT), 1)
    middles = [half - bar / 2 - i * (opening.width - bar) / lights for i in range(lights + 1)]
    return (
        *(boxes.box(within, (middle - bar / 2, middle + bar / 2), (0.0, high), trim) for middle in middles),
        boxes.box(within, (bar - half, half - bar), (0.0, bar), trim),
        boxes.box(within, (bar - half, half - bar), (high - bar, high), trim),
        boxes.box((-0.75, -0.7), (bar - half, half - bar), (bar, high - bar), _PANE, material="glass"),
    )
