import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec import structs

from tests.sim_rooms import asset, box, put, scene, table, vase
from thinkblox.scene.asset import Asset, Shape
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.sim.geometry.access import access
from thinkblox.sim.geometry.overlap import overlap_ratio, overlap_volume
from thinkblox.sim.geometry.solid import solid_of
from thinkblox.sim.verdict.world import World

CRATE = asset("crate", (0.5, 0.4, 0.3))
coordinate = st.floats(-0.6, 0.6)
angle = st.floats(0.0, 360.0)
L_FLOOR = ((0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0))


@pytest.mark.parametrize(
    ("shape", "volume"),
    [
        (Shape(kind="box", size=(0.2, 0.3, 0.4), position=(0.0, 0.0, 0.2)), 0.024),
        (Shape(kind="cylinder", size=(0.2, 0.2, 0.4), position=(0.1, 0.0, 0.2)), math.pi * 0.01 * 0.4),
        (Shape(kind="sphere", size=(0.2, 0.2, 0.2), position=(0.0, 0.0, 0.2)), math.pi / 6 * 0.008),
        (Shape(kind="ellipsoid", size=(0.2, 0.3, 0.4), position=(0.0, 0.0, 0.2)), math.pi / 6 * 0.024),
        (
            Shape(kind="capsule", size=(0.2, 0.2, 0.5), position=(0.0, 0.0, 0.3)),
            math.pi * 0.01 * 0.3 + math.pi / 6 * 0.008,
        ),
    ],
)
def test_volumes_in_closed_form(shape: Shape, volume: float) -> None:
    assert solid_of(asset("thing", (1.0, 1.0, 1.0), shape)).volume == pytest.approx(volume, rel=1e-6)


def test_overlapping_shapes_count_once() -> None:
    twice = asset(
        "thing", (1.0, 1.0, 1.0), box((0.4, 0.4, 0.4), (0.0, 0.0, 0.2)), box((0.4, 0.4, 0.4), (0.2, 0.0, 0.2))
    )
    assert solid_of(twice).volume == pytest.approx(0.6 * 0.4 * 0.4)


@settings(max_examples=40, deadline=None)
@given(coordinate, coordinate, angle, angle)
def test_overlap_is_symmetric(x: float, y: float, yaw: float, other_yaw: float) -> None:
    desk, crate = table(), CRATE
    a, b = put(desk, 2.0, 2.0, yaw=yaw), put(crate, 2.0 + x, 2.0 + y, 0.6, yaw=other_yaw)
    there = overlap_volume(solid_of(desk), a, solid_of(crate), b)
    back = overlap_volume(solid_of(crate), b, solid_of(desk), a)
    assert there == pytest.approx(back, abs=1e-9)
    ratios = [
        overlap_ratio(solid_of(desk), a, solid_of(crate), b),
        overlap_ratio(solid_of(crate), b, solid_of(desk), a),
    ]
    assert ratios[0] * solid_of(desk).volume == pytest.approx(ratios[1] * solid_of(crate).volume, abs=1e-9)


def turned(point: tuple[float, float], about: float, by: tuple[float, float]) -> tuple[float, float]:
    c, s = math.cos(math.radians(about)), math.sin(math.radians(about))
    return (c * point[0] - s * point[1] + by[0], s * point[0] + c * point[1] + by[1])


def moved_room(room: Room, about: float, by: tuple[float, float]) -> Room:
    return structs.replace(room, floor=tuple(turned(corner, about, by) for corner in room.floor))


def moved(placement: Placement, about: float, by: tuple[float, float]) -> Placement:
    x, y = turned(placement.position[:2], about, by)
    return structs.replace(placement, position=(x, y, placement.position[2]), yaw=placement.yaw + about)


def l_scene() -> tuple[Scene, list[tuple[Placement, Asset]]]:
    door = Opening(id="door_1", kind="door", wall=0, offset=3.0, width=0.9, height=2.0)
    room = scene(Room(floor=L_FLOOR, openings=(door,)), (put(table(), 1.0, 1.0), table()))
    crate, small = CRATE, vase()
    return room, [
        (put(crate, 3.0, 1.5), crate),
        (put(crate, 1.62, 1.0, 0.0), crate),
        (put(crate, 2.1, 2.1, yaw=20.0), crate),
        (put(crate, 3.4, 0.5), crate),
        (put(small, 1.0, 1.0, 0.751), small),
        (put(small, 1.61, 1.0, 0.751), small),
        (put(small, 1.0, 1.0, 1.0), small),
    ]


@pytest.mark.parametrize(("about", "by"), [(90.0, (10.0, 3.0)), (37.0, (-2.0, 5.5)), (200.0, (0.0, 0.0))])
def test_a_scene_turned_and_moved_as_a_whole_has_the_same_verdicts(about: float, by: tuple[float, float]) -> None:
    """Reasons are equal; lengths agree within 0.2 mm, overlaps within 1e-4, angles within 5 %."""
    room, candidates = l_scene()
    other = structs.replace(
        room, room=moved_room(room.room, about, by), placements=tuple(moved(p, about, by) for p in room.placements)
    )
    here, there = World(room), World(other)
    for placement, kind in candidates:
        first = here.check([placement], kind)[0]
        second = there.check([moved(placement, about, by)], kind)[0]
        assert second.reasons == first.reasons, placement
        assert second.blocked == first.blocked
        assert second.depth == pytest.approx(first.depth, abs=2e-4)
        assert second.outside == pytest.approx(first.outside, abs=2e-4)
        assert second.overlap == pytest.approx(first.overlap, abs=1e-4)
        assert second.tilt == pytest.approx(first.tilt, rel=0.05, abs=0.01)


def test_access_of_a_divided_room() -> None:
    door = Opening(id="door_1", kind="door", wall=0, offset=0.5, width=0.9, height=2.0)
    barrier = asset("shelf", (0.4, 4.0, 1.8), mass=40.0)
    room = scene(rectangle(4.0, 6.0, openings=(door,)), (put(barrier, 2.0, 3.0, yaw=90.0), barrier))
    found = access(room)
    assert found.reach == pytest.approx(0.5, abs=0.01)
    assert found.unreachable == ()
    light = structs.replace(barrier, mass=5.0)
    assert access(scene(room.room, (put(light, 2.0, 3.0, yaw=90.0), light))).reach == 1.0


def test_access_with_no_free_floor_at_all() -> None:
    door = Opening(id="door_1", kind="door", wall=0, offset=0.5, width=0.9, height=2.0)
    block = asset("block", (1.9, 1.9, 1.0), mass=100.0)
    found = access(scene(rectangle(2.0, 2.0, openings=(door,)), (put(block, 1.0, 1.0), block)))
    assert found.reach == 0.0
    assert found.unreachable == ("door_1", "block_1")
