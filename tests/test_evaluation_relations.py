import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace
from shapely import Polygon
from shapely.affinity import rotate, translate

from tests.judged_rooms import ROOM, WALLS, demands, part, scene, shelf, table, thing
from thinkblox.evaluation import element_rules, object_rules
from thinkblox.evaluation.annotations import RoomDemand
from thinkblox.evaluation.bodies import distance
from thinkblox.evaluation.room_file import RoomRecord
from thinkblox.evaluation.room_judge import judge_room
from thinkblox.evaluation.walls import Enclosure

metres = st.floats(-3.0, 3.0)
extents = st.floats(0.05, 2.0)
yaws = st.floats(0.0, 360.0)
poses = st.tuples(metres, metres, st.floats(0.0, 2.0), yaws, extents, extents, extents)


def boxed(pose):
    x, y, z, yaw, a, b, c = pose
    return thing("box", (x, y, z), (a, b, c), yaw=yaw)


@given(poses, poses)
def test_the_distance_of_boxes_is_that_of_their_outlines_and_heights(first, second):
    def outline(pose):
        x, y, _, yaw, a, b, _ = pose
        square = Polygon([(-a / 2, -b / 2), (a / 2, -b / 2), (a / 2, b / 2), (-a / 2, b / 2)])
        return translate(rotate(square, yaw, origin=(0, 0)), x, y)

    up = max(0.0, first[2] - second[2] - second[6], second[2] - first[2] - first[6])
    expected = math.hypot(outline(first).distance(outline(second)), up)
    assert distance(boxed(first), boxed(second)) == pytest.approx(expected, abs=1e-6)


@given(poses, poses, metres, metres)
def test_distance_does_not_depend_on_order_or_place(first, second, dx, dy):
    moved = [(p[0] + dx, p[1] + dy, *p[2:]) for p in (first, second)]
    there = distance(boxed(moved[0]), boxed(moved[1]))
    assert distance(boxed(second), boxed(first)) == pytest.approx(there, abs=1e-6)


def test_distance_is_between_surfaces_and_not_between_boxes():
    desk = table("desk", (0.0, 0.0), (0.8, 1.6, 0.75))
    assert distance(desk, thing("bin", (0.0, 0.0), (0.3, 0.3, 0.31))) == pytest.approx(0.40, abs=1e-9)


@given(poses, metres, metres)
def test_own_frame_and_room_are_inverse(pose, x, y):
    body = boxed(pose)
    spot = body.to_own(Polygon([body.to_room((x, y)), body.to_room((x + 1, y)), body.to_room((x, y + 1))]))
    assert spot.exterior.coords[0] == pytest.approx((x, y), abs=1e-9)


SOFA = thing("sofa", (3.0, 4.5), (0.9, 2.0, 0.8), yaw=270.0)
"""Its back to the north, so its left is the east."""
DESK = table("desk", (1.0, 1.0))
WIDE = table("table", (3.0, 2.5), (0.9, 2.0, 0.75))
"""Its long sides are to the east and the west."""
BUNK = thing(
    "bunk_bed",
    (1.0, 2.0),
    (1.0, 2.0, 1.7),
    parts=[part((1.0, 2.0, 0.4), (0, 0, 0.2)), part((1.0, 2.0, 0.3), (0, 0, 1.4))],
)
CUP = (0.08, 0.08, 0.1)
STAND, UMBRELLA = thing("stand", (1.0, 1.0), (0.2, 0.2, 0.4)), thing("umbrella", (1.0, 1.0, 0.02), (0.1, 0.1, 0.9))
LOFT = thing("loft_bed", (1.0, 2.0, 1.5), (1.0, 2.0, 0.4))


@pytest.mark.parametrize(
    ("rule", "anchor", "subject", "expected"),
    [
        ("next_to", SOFA, thing("lamp", (4.75, 4.5)), True),
        ("next_to", SOFA, thing("lamp", (4.76, 4.5)), False),
        ("near", SOFA, thing("lamp", (4.1, 4.5), CUP), True),
        ("near", SOFA, thing("lamp", (5.75, 4.5)), True),
        ("near", SOFA, thing("lamp", (5.8, 2.5)), False),
        ("across_from", SOFA, thing("tv", (3.0, 1.0), yaw=90.0), True),
        ("across_from", SOFA, thing("tv", (3.0, 3.3), yaw=90.0), False),
        ("across_from", thing("desk", (1.0, 4.5), yaw=90.0), thing("chair", (4.0, 4.5), yaw=90.0), False),
        ("far", thing("desk", (0.3, 0.3)), thing("chair", (5.0, 4.0)), True),
        ("far", thing("desk", (1.0, 1.0)), thing("chair", (4.0, 1.0)), False),
        ("face_to", SOFA, thing("chair", (3.0, 2.0), yaw=90.0), True),
        ("face_to", SOFA, thing("chair", (3.0, 2.0), yaw=270.0), False),
        ("face_to", SOFA, thing("chair", (1.0, 3.5), yaw=90.0), False),
        ("face_to", SOFA, thing("stool", (3.0, 2.0), yaw=270.0, front="any"), True),
        ("face_to", SOFA, thing("table", (3.0, 2.0), yaw=270.0, front="two"), True),
        ("face_to", SOFA, thing("desk", (3.0, 2.0), yaw=270.0, gaze="back"), True),
        ("face_to", SOFA, thing("desk", (3.0, 2.0), yaw=90.0, gaze="back"), False),
        ("back_of", thing("desk", (3.0, 3.0), gaze="back"), thing("chair", (3.6, 3.0), yaw=180.0), True),
        ("back_of", thing("desk", (3.0, 3.0), gaze="back"), thing("chair", (3.6, 3.0), yaw=0.0), False),
        ("back_of", thing("desk", (3.0, 3.0)), thing("chair", (3.6, 3.0), yaw=180.0), False),
        ("left_of", SOFA, thing("lamp", (4.5, 4.5)), True),
        ("left_of", SOFA, thing("lamp", (1.5, 4.5)), False),
        ("right_of", SOFA, thing("lamp", (1.5, 4.5)), True),
        ("right_of", SOFA, thing("lamp", (4.5, 4.5)), False),
        ("left_of", thing("sofa", (0.0, 0.0), (0.9, 2.0, 0.8)), thing("lamp", (0.0, 5.0)), False),
        ("front_of", SOFA, thing("table", (3.0, 3.5)), True),
        ("front_of", SOFA, thing("table", (4.6, 4.5)), False),
        ("front_of", SOFA, thing("table", (3.0, 0.5)), False),
        ("front_of", DESK, thing("chair", (1.45, 1.0)), True),
        ("back_of", thing("sofa", (3.0, 2.0), (0.9, 2.0, 0.8), yaw=270.0), thing("lamp", (3.0, 2.9)), True),
        ("back_of", SOFA, thing("lamp", (3.0, 3.5)), False),
        ("long_side_of", WIDE, thing("chair", (3.6, 2.9)), True),
        ("long_side_of", WIDE, thing("chair", (3.0, 3.7)), False),
        ("short_side_of", WIDE, thing("chair", (3.0, 3.7)), True),
        ("short_side_of", WIDE, thing("chair", (3.6, 2.9)), False),
        ("short_side_of", WIDE, thing("chair", (3.0, 4.9)), False),
        ("long_side_of", table("table", (3.0, 2.5), (1.0, 1.0, 0.7)), thing("chair", (3.7, 2.5)), False),
        ("on_top", DESK, thing("cup", (1.1, 1.2, 0.75), CUP), True),
        ("on_top", DESK, thing("cup", (1.1, 1.2, 1.3), CUP), False),
        ("on_top", DESK, thing("cup", (1.1, 1.2, 0.0), CUP), False),
        ("on_top", DESK, thing("cup", (2.1, 1.2, 0.75), CUP), False),
        ("on_top", shelf("bookcase", (1.0, 1.0)), thing("cup", (1.0, 1.0, 1.8), CUP), True),
        ("on_top", shelf("bookcase", (1.0, 1.0)), thing("cup", (1.0, 1.0, 0.02), CUP), False),
        ("on_top", BUNK, thing("pillow", (1.0, 2.6, 0.4), (0.4, 0.6, 0.12)), True),
        ("on_top", shelf("shelving_unit", (1.0, 1.0)), thing("cup", (1.0, 1.0, 0.613), CUP), True),
        ("on_top", shelf("shelving_unit", (1.0, 1.0)), thing("cup", (2.0, 1.0, 0.613), CUP), False),
        ("inside_of", shelf("bookcase", (1.0, 1.0)), thing("cup", (1.0, 1.0, 0.613), CUP), True),
        ("inside_of", shelf("bookcase", (1.0, 1.0)), thing("cup", (1.0, 1.0, 1.8), CUP), False),
        ("inside_of", shelf("shelving_unit", (1.0, 1.0)), thing("cup", (1.0, 1.0, 1.8), CUP), True),
        ("inside_of", STAND, UMBRELLA, True),
        ("inside_of", thing("wardrobe", (1.0, 1.0), (0.6, 1.0, 2.0)), thing("safe", (1.0, 2.0)), False),
        ("outside_of", thing("wardrobe", (1.0, 1.0), (0.6, 1.0, 2.0)), thing("safe", (1.0, 2.0)), True),
        ("outside_of", thing("wardrobe", (1.0, 1.0), (0.6, 1.0, 2.0)), thing("safe", (1.0, 1.0)), False),
        ("under", DESK, thing("bin", (1.0, 1.1), (0.3, 0.3, 0.4)), True),
        ("under", DESK, thing("bin", (2.0, 1.0), (0.3, 0.3, 0.4)), False),
        ("under", DESK, thing("cup", (1.1, 1.2, 0.75), CUP), False),
        ("under", thing("clock", (3.0, 4.98, 1.6), (0.05, 0.4, 0.4), yaw=270.0), SOFA, True),
        ("above", SOFA, thing("picture", (3.0, 4.98, 1.3), (0.03, 0.8, 0.6), yaw=270.0), True),
        ("above", SOFA, thing("picture", (5.0, 4.98, 1.3), (0.03, 0.8, 0.6), yaw=270.0), False),
        ("above", SOFA, thing("picture", (3.0, 0.02, 1.3), (0.03, 0.8, 0.6), yaw=90.0), False),
        ("above", thing("desk", (1.0, 2.0), (0.6, 1.2, 0.75)), LOFT, True),
        ("middle_of", DESK, thing("candle", (1.0, 1.2, 0.75), CUP), True),
        ("middle_of", DESK, thing("candle", (1.0, 1.5, 0.75), CUP), False),
    ],
)  # fmt: skip
def test_relations_between_two_objects(rule, anchor, subject, expected):
    found = object_rules.holds(rule, anchor, (subject,), WALLS)
    assert found.holds is expected, found.says
    assert found.says


def test_in_a_small_room_two_metres_are_far():
    small = Enclosure(RoomRecord(floor=((0.0, 0.0), (3.5, 0.0), (3.5, 2.5), (0.0, 2.5))))
    pair = thing("desk", (0.3, 0.3)), thing("chair", (3.0, 2.0))
    assert object_rules.holds("far", pair[0], pair[1:], small).holds
    assert not object_rules.holds("far", pair[0], pair[1:], WALLS).holds


def ring(number, radius=1.0, of=360.0, centre=(3.0, 2.5)):
    turns = [math.radians(k * of / number) for k in range(number)]
    return [
        thing(f"chair_{k}", (centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)), (0.4, 0.4, 0.9))
        for k, t in enumerate(turns)
    ]


@pytest.mark.parametrize("number", [2, 3, 4, 8])
def test_surround(number):
    centre = table("table", (3.0, 2.5), (0.8, 0.8, 0.75))
    assert object_rules.holds("surround", centre, ring(number), WALLS).holds
    assert not object_rules.holds("surround", centre, ring(number, of=60.0), WALLS).holds
    assert not object_rules.holds("surround", centre, ring(number, radius=3.0), WALLS).holds
    assert not object_rules.holds("surround", centre, ring(1), WALLS).holds


L_ROOM = Enclosure(RoomRecord(floor=((0.0, 0.0), (6.0, 0.0), (6.0, 3.0), (3.0, 3.0), (3.0, 5.0), (0.0, 5.0))))


@pytest.mark.parametrize(
    ("rule", "part_of_room", "body", "expected"),
    [
        ("on_wall", "wall", thing("mirror", (5.985, 2.0, 1.0), (0.03, 0.8, 0.6), yaw=180.0), True),
        ("on_wall", "wall", thing("mirror", (5.97, 2.0, 1.0), (0.03, 0.8, 0.6), yaw=180.0), False),
        ("on_wall", "wall", thing("bookcase", (5.75, 2.0), (0.5, 0.8, 1.6), yaw=180.0), False),
        ("against_wall", "wall", thing("bookcase", (5.45, 2.0), (0.5, 0.8, 1.6), yaw=180.0), True),
        ("against_wall", "wall", thing("bookcase", (5.44, 2.0), (0.5, 0.8, 1.6), yaw=180.0), False),
        ("corner_room", "room", thing("plant", (0.9, 0.9)), True),
        ("corner_room", "room", thing("plant", (0.9, 2.5)), False),
        ("hang_ceiling", "ceiling", thing("lamp", (3.0, 2.0, 2.1)), True),
        ("hang_ceiling", "ceiling", thing("lamp", (3.0, 2.0, 2.0)), False),
        ("middle_room", "room", thing("table", (3.5, 2.9)), True),
        ("middle_room", "room", thing("table", (4.7, 2.5)), False),
        ("inside_room", "room", thing("table", (4.7, 2.5)), True),
        ("inside_room", "room", thing("table", (6.2, 2.5)), False),
        ("next_to", "door", thing("bin", (1.5, 0.3)), True),
        ("next_to", "door", thing("bin", (2.0, 0.3)), False),
        ("near", "door", thing("bin", (2.0, 0.3)), True),
        ("near", "door", thing("bin", (4.0, 0.3)), False),
        ("across_from", "door", thing("bin", (3.5, 0.3)), True),
        ("far", "door", thing("bin", (5.7, 3.0)), True),
        ("far", "door", thing("bin", (3.0, 0.3)), False),
        ("next_to", "window", thing("bathtub", (3.2, 4.6), (0.6, 0.6, 0.5)), True),
        ("next_to", "window", thing("bathtub", (0.5, 4.6), (0.6, 0.6, 0.5)), False),
        ("next_to", "corner", thing("bin", (0.5, 0.5)), True),
        ("next_to", "floor", thing("bin", (0.5, 0.5)), True),
        ("next_to", "wall", thing("bin", (3.0, 2.5)), False),
    ],
)
def test_relations_to_parts_of_the_room(rule, part_of_room, body, expected):
    found = element_rules.holds(rule, body, part_of_room, WALLS)
    assert found.holds is expected, found.says


def test_the_corner_that_points_into_an_l_shaped_room_is_none():
    assert len(L_ROOM.corners) == 5
    beside = thing("plant", (3.5, 2.4))
    assert not element_rules.holds("corner_room", beside, "room", L_ROOM).holds


def test_next_to_a_window_that_is_not_there():
    bare = Enclosure(RoomRecord(floor=ROOM.floor))
    assert element_rules.holds("next_to", thing("bin", (1.5, 0.3)), "window", bare) == (False, "there is no window")


TWO_TABLES = scene(
    table("table_1", (1.5, 1.5), (0.8, 0.8, 0.75)),
    table("table_2", (4.5, 3.5), (0.8, 0.8, 0.75)),
    thing("cup_1", (1.5, 1.5, 0.75), CUP),
    thing("cup_2", (4.5, 3.5, 0.75), CUP),
    thing("cup_3", (4.3, 3.5, 0.75), CUP),
    thing("cup_4", (3.0, 0.5), CUP),
)


@pytest.mark.parametrize(
    ("row", "met"),
    [
        (["eq", 3, "on_top", 0, "table", "cup"], True),
        (["eq", 2, "on_top", 0, "table", "cup"], False),
        (["ge", 3, "on_top", 0, "table", "cup"], True),
        (["gt", 3, "on_top", 0, "table", "cup"], False),
        (["lt", 4, "on_top", 0, "table", "cup"], True),
        (["le", 2, "on_top", 0, "table", "cup"], False),
        (["eq", 3, "on_top", 1, "cup", "table"], True),
        (["eq", 0, "under", 0, "table", "cup"], True),
        (["eq", 0, "on_top", 0, "table", "cup"], False),
        (["eq", 0, "on_top", 0, "table", "lamp"], False),
        (["eq", 1, "on_top", 0, "table", "cup", "cup"], True),
        (["eq", 2, "far", 0, "table", "table"], False),
        (["ge", 1, "orbits", 0, "table", "cup"], None),
    ],
)
def test_groups_are_counted_as_sceneeval_counts_them(row, met):
    """Each anchor with each choice of its subjects is one group; a category that is not there meets nothing."""
    (judged,) = judge_room(demands(objects=[row]), TWO_TABLES)
    assert judged.met is met, judged.says


@pytest.mark.parametrize(
    ("row", "met", "found", "extra"),
    [
        (["eq", 4, "cup"], True, 4, 0),
        (["eq", 3, "cup"], False, 3, 1),
        (["ge", 5, "cup"], False, 4, 0),
        (["gt", 3, "cup"], True, 4, 0),
        (["lt", 4, "cup"], False, 0, 1),
        (["le", 1, "bed"], True, 0, 0),
    ],
)
def test_counts(row, met, found, extra):
    (judged,) = judge_room(demands(counts=[row]), TWO_TABLES)
    assert (judged.met, judged.found, judged.extra) == (met, found, extra)


def test_chairs_round_several_tables_are_counted_by_table():
    chairs = [
        thing(f"chair_{k}", body.placement.position[:2], (0.4, 0.4, 0.9))
        for k, body in enumerate([*ring(4, centre=(1.5, 1.5)), *ring(4, centre=(4.5, 3.5))])
    ]
    tables = [table("table_1", (1.5, 1.5), (0.8, 0.8, 0.75)), table("table_2", (4.5, 3.5), (0.8, 0.8, 0.75))]
    (judged,) = judge_room(
        demands(objects=[["eq", 2, "surround", 0, "table", *["chair"] * 4]]), scene(*tables, *chairs)
    )
    assert judged.met, judged.says


def test_what_must_be_absent():
    no_cup = demands(absent=["cup", "rug"])
    assert [row.met for row in judge_room(no_cup, TWO_TABLES)] == [False, True]
    only_armchairs = demands(counts=[["eq", 1, "armchair"]], absent=["chair"])
    assert [row.met for row in judge_room(only_armchairs, scene(thing("armchair", (3.0, 2.0))))] == [True, True]


@pytest.mark.parametrize(("sides", "shape", "met"), [((4, 4), "square", True), ((4, 5), "square", False)])
def test_a_room_of_equal_sides_is_square(sides, shape, met):
    x, y = sides
    made = scene(room=replace(ROOM, floor=((0.0, 0.0), (x, 0.0), (x, y), (0.0, y))))
    (judged,) = judge_room(demands(room=RoomDemand(shape=shape)), made)
    assert judged.met == met
    (judged,) = judge_room(demands(room=RoomDemand(shape="rectangle")), made)
    assert judged.met
