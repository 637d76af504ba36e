import math

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec import structs

from tests.sim_rooms import asset, box, put
from thinkblox.assets import make_asset
from thinkblox.scene.asset import Asset, Shape
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room, rectangle
from thinkblox.sim.geometry.boundary import boundary_distance, least_move_inside
from thinkblox.sim.geometry.footprint import footprint_of, in_room
from thinkblox.sim.geometry.solid import solid_of

CRATE = asset("crate", (0.5, 0.4, 0.3))
PLANK = asset("plank", (1.0, 0.1, 0.1))
DRUM = asset("drum", (0.6, 0.6, 0.5), Shape(kind="cylinder", size=(0.6, 0.6, 0.5), position=(0.0, 0.0, 0.25)))
FRAME = asset(
    "frame", (1.0, 1.0, 0.3), box((1.0, 0.2, 0.3), (0.0, -0.4, 0.15)), box((0.2, 1.0, 0.3), (-0.4, 0.0, 0.15))
)
RECTANGLE = rectangle(4.0, 5.0)
L_ROOM = Room(floor=((0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)))
SPUR = Room(floor=((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.1, 3.0), (2.1, 1.0), (1.9, 1.0), (1.9, 3.0), (0.0, 3.0)))
SPIKE = Room(floor=((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.001, 3.0), (2.0, 1.0), (1.999, 3.0), (0.0, 3.0)))
SLANTED = Room(floor=((0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 4.0), (0.0, 4.0)))
COLLINEAR = Room(floor=((0.0, 0.0), (1.0, 0.0), (2.5, 0.0), (4.0, 0.0), (4.0, 5.0), (2.0, 5.0), (0.0, 5.0), (0.0, 1.0)))
STAR = Room(floor=tuple(
    ((1.0 + k % 2) * 2 * math.cos(k * math.pi / 5), (1.0 + k % 2) * 2 * math.sin(k * math.pi / 5)) for k in range(10)
))  # fmt: skip
CONVEX, CONCAVE = (RECTANGLE, SLANTED, COLLINEAR), (L_ROOM, SPUR, SPIKE, STAR)
angle = st.floats(0.0, 360.0)


def distance(room: Room, placement: Placement, kind: Asset) -> float:
    return boundary_distance(room, placement, solid_of(kind))


def shifted(placement: Placement, by: tuple[float, float, float]) -> Placement:
    x, y, z = (a + b for a, b in zip(placement.position, by, strict=True))
    return structs.replace(placement, position=(x, y, z))


@settings(max_examples=100, deadline=None)
@given(st.floats(-1.0, 5.0), st.floats(-1.0, 6.0), angle)
def test_a_rectangle_in_closed_form(x: float, y: float, yaw: float) -> None:
    placement = put(CRATE, x, y, yaw=yaw)
    corners = np.array(placement.corners)
    low, high = corners.min(axis=0), (4.0, 5.0) - corners.max(axis=0)
    past = np.maximum(0.0, np.maximum(-low, -high))
    expected = math.hypot(*past) if past.any() else -min(*low, *high)
    for room in (RECTANGLE, COLLINEAR):
        assert distance(room, placement, CRATE) == pytest.approx(expected, abs=1e-6)


@settings(max_examples=50, deadline=None)
@given(st.floats(-1.0, 3.0), st.floats(0.3, 1.7), angle)
def test_a_round_thing_is_round(x: float, y: float, yaw: float) -> None:
    placement = put(DRUM, x, y, yaw=yaw)
    for room in (rectangle(5.0, 2.0), L_ROOM):
        beyond = math.hypot(max(0.0, 2.0 - x), 2.0 - y) if room is L_ROOM else 2.0 - y
        expected = -min(x - 0.3, y - 0.3, beyond - 0.3)
        assert distance(room, placement, DRUM) == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize(
    ("room", "placement", "kind", "expected"),
    [
        (L_ROOM, put(CRATE, 1.75, 1.8), CRATE, 0.0),
        (L_ROOM, put(CRATE, 1.80, 1.85), CRATE, 0.05),
        (L_ROOM, put(CRATE, 1.95, 1.95, yaw=45.0), CRATE, 0.25 - 0.05 * 2**0.5),
        (SLANTED, put(CRATE, 3.0, 3.0, yaw=45.0), CRATE, 0.25),
        (SLANTED, put(CRATE, 2.0, 2.0, yaw=45.0), CRATE, 0.25 - 2**0.5),
        (SLANTED, put(DRUM, 3.0, 3.0), DRUM, 0.3),
        (SPUR, put(PLANK, 2.0, 2.0), PLANK, 0.6),
        (SPUR, put(PLANK, 2.0, 1.4), PLANK, 0.45),
        (SPUR, put(PLANK, 2.0, 0.5), PLANK, -0.45),
        (SPUR, put(PLANK, 0.45, 2.9), PLANK, 0.05),
        (SPIKE, put(PLANK, 2.0, 1.3), PLANK, 0.35),
        (SPIKE, put(PLANK, 2.0, 0.94), PLANK, -0.01),
        (RECTANGLE, put(CRATE, 2.0, 2.0, 2.4), CRATE, 0.1),
        (RECTANGLE, put(CRATE, 2.0, 2.0, -0.02), CRATE, 0.02),
        (RECTANGLE, put(CRATE, 0.21, 2.0, -0.03), CRATE, 0.05),
        (RECTANGLE, put(CRATE, 0.25, 2.0), CRATE, 0.0),
        (RECTANGLE, put(CRATE, -900.0, 2.0), CRATE, 900.25),
    ],
)  # fmt: skip
def test_situations_in_closed_form(room: Room, placement: Placement, kind: Asset, expected: float) -> None:
    assert distance(room, placement, kind) == pytest.approx(expected, abs=1e-6)


def test_an_angle_round_the_inner_corner_of_an_l_is_free() -> None:
    """Two planks joined to an L stand round the corner, which is inside their hull and touches neither."""
    around = put(FRAME, 2.0, 2.0)
    assert distance(L_ROOM, around, FRAME) == pytest.approx(-0.3, abs=1e-6)
    assert distance(L_ROOM, put(FRAME, 2.0 + 0.35, 2.0), FRAME) == pytest.approx(0.05, abs=1e-6)
    assert distance(L_ROOM, put(FRAME, 2.32, 2.33), FRAME) == pytest.approx(math.hypot(0.02, 0.03), abs=1e-6)


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(CONVEX + CONCAVE), st.sampled_from((CRATE, PLANK, FRAME, DRUM)), st.data())
def test_the_least_move_brings_it_inside_and_no_shorter_one_does(room: Room, kind: Asset, data: st.DataObject) -> None:
    x0, y0, x1, y1 = room.polygon.bounds
    placement = put(
        kind, data.draw(st.floats(x0 - 0.5, x1 + 0.5)), data.draw(st.floats(y0 - 0.5, y1 + 0.5)), yaw=data.draw(angle)
    )
    move, measured = least_move_inside(room, placement, solid_of(kind)), distance(room, placement, kind)
    assert move is not None
    assert reaching_out(room, shifted(placement, move), kind) < 1e-8
    assert math.hypot(*move) == pytest.approx(max(0.0, measured), abs=1e-6)
    assert distance(room, shifted(placement, move), kind) <= 1e-8
    for turn in np.linspace(0.0, 2 * math.pi, 60, endpoint=False):
        for share in (0.3, 0.9, 0.999):
            by = (share * measured * math.cos(turn), share * measured * math.sin(turn), 0.0)
            assert measured < 1e-4 or reaching_out(room, shifted(placement, by), kind) > 0.0


def reaching_out(room: Room, placement: Placement, kind: Asset) -> float:
    """Area of the object outside the room, with outlines less fine [m2]."""
    pieces = [shapely.Polygon(in_room(piece, placement)) for piece in footprint_of(solid_of(kind)).pieces]
    return max(float(shapely.difference(piece, room.polygon).area) for piece in pieces)


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(CONVEX + CONCAVE), st.sampled_from((CRATE, FRAME, DRUM)), st.data())
def test_the_free_distance_is_that_to_the_nearest_wall(room: Room, kind: Asset, data: st.DataObject) -> None:
    x0, y0, x1, y1 = room.polygon.bounds
    placement = put(kind, data.draw(st.floats(x0, x1)), data.draw(st.floats(y0, y1)), yaw=data.draw(angle))
    measured = distance(room, placement, kind)
    pieces = [shapely.Polygon(in_room(piece, placement)) for piece in footprint_of(solid_of(kind)).pieces]
    if reaching_out(room, placement, kind) == 0.0:
        assert -measured == pytest.approx(min(p.distance(room.polygon.exterior) for p in pieces), abs=1e-9)
    else:
        assert measured > -1e-8


@pytest.mark.parametrize("room", CONVEX)
@settings(max_examples=15, deadline=None)
@given(st.floats(-0.5, 4.5), st.floats(-0.5, 5.5), angle)
def test_convex_rooms_measure_the_same_with_a_dent_far_away(room: Room, x: float, y: float, yaw: float) -> None:
    """A dent of a tenth of a millimetre makes a floor concave, so that it is measured in the other way."""
    first, second = room.floor[0], room.floor[1]
    middle = ((first[0] + second[0]) / 2, (first[1] + second[1]) / 2 + 1e-4)
    dented = structs.replace(room, floor=(first, middle, *room.floor[1:]))
    placement = put(CRATE, x, y, yaw=yaw)
    assert distance(dented, placement, CRATE) == pytest.approx(distance(room, placement, CRATE), abs=4e-4)


def test_what_fits_exactly_fits() -> None:
    exact = asset("runner", (4.0, 5.0, 0.5))
    assert distance(RECTANGLE, put(exact, 2.0, 2.5), exact) == pytest.approx(0.0, abs=1e-8)
    assert least_move_inside(RECTANGLE, put(exact, 2.3, 2.1), solid_of(exact)) == pytest.approx((-0.3, 0.4, 0.0))
    arm = asset("runner", (2.0, 2.0, 2.6))
    assert least_move_inside(L_ROOM, put(arm, 1.2, 3.0), solid_of(arm)) == pytest.approx((-0.2, 0.0, 0.0), abs=1e-6)


@pytest.mark.parametrize("room", [RECTANGLE, L_ROOM, SPUR])
def test_what_fits_nowhere_is_further_outside_the_further_it_is_away(room: Room) -> None:
    huge = asset("huge", (6.0, 6.0, 1.0))
    measured = [distance(room, put(huge, x, 1.5), huge) for x in (3.0, 4.0, 6.0, 9.0, 20.0)]
    assert measured == sorted(measured)
    assert measured[0] > 0.5
    assert least_move_inside(room, put(huge, 2.0, 1.5), solid_of(huge)) is None


def test_what_is_too_high_for_the_room_fits_nowhere() -> None:
    pole = asset("pole", (0.1, 0.1, 3.0))
    assert distance(RECTANGLE, put(pole, 2.0, 2.0), pole) == pytest.approx(0.4)
    assert distance(RECTANGLE, put(pole, 2.0, 2.0, 0.5), pole) == pytest.approx(0.9)
    assert least_move_inside(RECTANGLE, put(pole, 2.0, 2.0), solid_of(pole)) is None


def test_the_move_of_what_is_sunk_and_outside_goes_up_and_in() -> None:
    sunk = put(CRATE, 0.15, 2.0, -0.02)
    assert least_move_inside(RECTANGLE, sunk, solid_of(CRATE)) == pytest.approx((0.1, 0.0, 0.02))
    assert least_move_inside(RECTANGLE, put(CRATE, 2.0, 2.0, 2.5), solid_of(CRATE)) == pytest.approx((0.0, 0.0, -0.2))
    assert least_move_inside(RECTANGLE, put(CRATE, 2.0, 2.0), solid_of(CRATE)) == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("category", ["chair", "office_chair", "floor_lamp", "sofa", "plant"])
@pytest.mark.parametrize("room", [RECTANGLE, L_ROOM, SPUR])
def test_furniture_moves_inside(room: Room, category: str) -> None:
    kind = make_asset(category, seed=1)
    placement = put(kind, 2.0, 2.0, yaw=25.0)
    move = least_move_inside(room, placement, solid_of(kind))
    if move is not None:
        assert distance(room, shifted(placement, move), kind) <= 1e-8
        assert math.hypot(*move) == pytest.approx(max(0.0, distance(room, placement, kind)), abs=1e-6)


def test_tilted_cylinders_and_ellipsoids_reach_as_far_as_they_do() -> None:
    """The half extent of a tilted cylinder is h/2 sin + r cos, that of an ellipsoid the root of the sum of squares."""
    half = math.radians(15.0)
    leaning = (math.cos(half), 0.0, math.sin(half), 0.0)
    rod = Shape(kind="cylinder", size=(0.1, 0.1, 1.0), position=(0.0, 0.0, 0.5), quat_wxyz=leaning)
    egg = Shape(kind="ellipsoid", size=(0.2, 0.3, 0.6), position=(0.0, 0.0, 0.5), quat_wxyz=leaning)
    pill = Shape(kind="capsule", size=(0.1, 0.1, 1.0), position=(0.0, 0.0, 0.5), quat_wxyz=leaning)
    for shape, reach in (
        (rod, 0.5 * 0.5 + 0.05 * math.cos(math.pi / 6)),
        (egg, math.hypot(0.1 * math.cos(math.pi / 6), 0.3 * 0.5)),
        (pill, 0.45 * 0.5 + 0.05),
    ):
        kind = asset("leaning", (0.5, 0.5, 1.0), shape)
        assert distance(RECTANGLE, put(kind, 0.1, 2.5), kind) == pytest.approx(reach - 0.1, abs=1e-6)
        assert distance(L_ROOM, put(kind, 0.1, 2.5), kind) == pytest.approx(reach - 0.1, abs=1e-6)
