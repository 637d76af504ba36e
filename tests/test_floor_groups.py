"""What stands on the floor in groups, asked of whole rooms: each is where a person would put it."""

import math
from functools import cache

import numpy as np
import pytest
from shapely import Point

from thinkblox.furnishing import Generation
from thinkblox.generate import generate_room
from thinkblox.placing import Effort
from thinkblox.planning import is_open, larger, plan_brief
from thinkblox.planning.rooms import plan_room
from thinkblox.reading import read_brief
from thinkblox.scene.pairs import NEXT_TO
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import rectangle, turn_between

pytestmark = pytest.mark.slow


@cache
def made(prompt: str) -> Generation:
    return generate_room(prompt, seed=0, effort=Effort(restarts=1))


def of(prompt: str, category: str) -> list[Placement]:
    return [p for p in made(prompt).scene.placements if p.category == category]


def unmet(prompt: str) -> list[str]:
    return [f"{r.kind}: {r.measured}" for r in made(prompt).report.relations if not r.holds]


def apart(one: Placement, other: Placement) -> float:
    return float(one.footprint.distance(other.footprint))


def ties(prompt: str, id: str) -> list[tuple[str, tuple[str, ...]]]:
    brief = read_brief(prompt)
    plan = plan_brief(brief, rectangle(6.0, 5.0))
    return [(tie.kind, tie.anchors) for tie in plan.target(id).ties]


@pytest.mark.parametrize(
    ("prompt", "pair", "middle"),
    [
        ("A nursery. Two cribs stand against the wall with a dresser between them.", "crib", "dresser"),
        ("A lobby, two armchairs face each other with a round marble table between them.", "armchair", "coffee_table"),
        ("Two single beds against the wall and a nightstand between them.", "bed", "nightstand"),
    ],
)
def test_a_pair_leaves_just_the_room_between_that_a_third_needs(prompt: str, pair: str, middle: str):
    assert unmet(prompt) == []
    assert all(apart(of(prompt, middle)[0], each) <= NEXT_TO for each in of(prompt, pair))


def test_a_table_in_a_corner_is_as_far_from_the_walls_as_the_seats_all_round_it_need():
    assert unmet("A kitchen with only a breakfast table in the corner and three stools around it.") == []


def test_what_dries_lies_on_the_airer_and_a_sponge_on_the_sink():
    assert unmet("A laundry with only a utility sink with a sponge on it and a drying rack with two towels on it") == []


@pytest.mark.slow
def test_what_comes_between_every_two_of_a_row_has_its_gap():
    prompt = "A spa with four recliners in a row and a side table between every two recliners."
    assert unmet(prompt) == []
    tables, recliners = of(prompt, "side_table"), of(prompt, "recliner")
    assert [sum(apart(table, each) <= NEXT_TO for each in recliners) for table in tables] == [2, 2, 2]


def test_what_is_between_two_of_its_own_has_these():
    prompt = "A hall with three booths, each with a table between two benches."
    assert ("between", ("bench_3", "bench_4")) in ties(prompt, "dining_table_2")


def test_every_two_share_what_there_are_half_as_many_of():
    prompt = "A spa, 7 m by 5 m, with four loungers; two small round tables stand next to the loungers."
    assert unmet(prompt) == []
    for table in of(prompt, "dining_table"):
        assert sum(apart(table, lounger) <= NEXT_TO for lounger in of(prompt, "lounger")) == 2


def test_those_who_face_each_other_sit_at_the_same_table():
    prompt = "A bistro with two square tables, each with two chairs facing each other."
    assert ("facing", ("chair_1",)) in ties(prompt, "chair_2")
    assert ("facing", ("chair_3",)) in ties(prompt, "chair_4")
    assert unmet(prompt) == []


@pytest.mark.slow
def test_a_table_is_as_long_as_those_who_share_its_long_sides_need():
    prompt = "A party room with a long table with five chairs on each long side."
    assert unmet(prompt) == []
    table = of(prompt, "dining_table")[0]
    assert table.size[1] >= 3.0
    assert all(apart(table, chair) < 0.3 for chair in of(prompt, "chair"))


def test_stools_stand_in_one_line_along_the_counter():
    prompt = "A bar with a counter and six stools in front of it."
    assert unmet(prompt) == []
    counter = of(prompt, "counter")[0]
    out = [counter.to_local((s.position[0], s.position[1])) for s in of(prompt, "stool") + of(prompt, "bar_stool")]
    assert len(out) == 6
    assert np.ptp([x for x, _ in out]) < 0.05
    assert np.ptp(np.diff(sorted(y for _, y in out))) < 0.05


@pytest.mark.slow
@pytest.mark.parametrize(
    "prompt",
    ["A chapel with an altar, a lectern and five rows of pews.", "A church, 6 m by 9 m, with an altar and ten pews."],
)
def test_pews_stand_on_both_sides_of_an_aisle_and_look_at_the_altar(prompt: str):
    assert unmet(prompt) == []
    altar, pews = of(prompt, "altar")[0], of(prompt, "pew")
    assert len(pews) == 10
    assert all(turn_between(pew.yaw, altar.yaw + 180.0) < 1.0 for pew in pews)
    sides = [altar.to_local((pew.position[0], pew.position[1]))[1] for pew in pews]
    assert sum(side > 0.0 for side in sides) == 5
    assert min(map(abs, sides)) - max(pew.size[1] for pew in pews) / 2 > 0.25
    for lectern in of(prompt, "podium"):
        assert apart(lectern, altar) <= NEXT_TO


def test_shelves_behind_a_counter_leave_room_to_serve():
    prompt = "A bakery with a counter and two shelves behind it."
    assert unmet(prompt) == []
    counter = of(prompt, "counter")[0]
    for shelf in of(prompt, "shelving_unit") + of(prompt, "bookcase"):
        assert 0.4 <= apart(shelf, counter) <= 1.5


def test_an_armchair_with_something_behind_and_beside_it_stands_in_no_corner():
    prompt = "An armchair with a floor lamp behind it, a side table to its right and a pouffe in front of it."
    assert unmet(prompt) == []
    assert all(kind != "in_corner" for kind, _ in ties(prompt, "armchair_1"))


def test_what_stands_next_to_a_sink_stands_by_its_counter_with_the_sink_near():
    prompt = "The dishwasher stands next to the sink; four plates are on the counter."
    assert ("next_to", ("base_cabinet_1",)) in ties(prompt, "dishwasher_1")
    assert ("next_to", ("dishwasher_1",)) in ties(prompt, "sink_1")
    assert apart(of(prompt, "sink")[0], of(prompt, "dishwasher")[0]) <= NEXT_TO


def test_a_small_thing_next_to_what_carries_nothing_stands_on_the_floor():
    prompt = "A gym with an exercise bike, a bottle next to the bike and a shelf."
    assert of(prompt, "bottle")[0].support == "floor"
    assert unmet(prompt) == []


def test_what_is_right_of_a_table_is_right_of_it_as_it_stands():
    prompt = "A wooden table and a blue plastic bin on the floor to the right of the table."
    table, blue = of(prompt, "dining_table")[0], of(prompt, "storage_bin")[0]
    assert table.to_local((blue.position[0], blue.position[1]))[1] < -table.size[1] / 2


def test_a_mat_at_the_door_lies_inside_it():
    prompt = "An entryway with a doormat at the door."
    assert unmet(prompt) == []


def test_what_is_opposite_the_door_looks_at_it():
    prompt = "A music room with a piano opposite the door."
    room = made(prompt).scene.room
    door = next(o for o in room.openings if o.kind == "door")
    assert unmet(prompt) == []
    assert turn_between(of(prompt, "piano")[0].yaw, room.walls[door.wall].yaw + 180.0) < 1.0


def test_a_board_hangs_on_the_wall_behind_the_counter():
    prompt = "A café with a counter; on the wall behind the counter is a chalkboard."
    assert unmet(prompt) == []


@pytest.mark.slow
def test_rows_of_desks_look_at_the_board_in_lines_with_aisles():
    prompt = "A classroom with a blackboard and nine desks in three rows, each with a chair."
    assert unmet(prompt) == []
    board, desks = of(prompt, "blackboard")[0], of(prompt, "school_desk")
    local = [board.to_local((d.position[0], d.position[1])) for d in desks]
    assert all(x > 1.0 for x, _ in local)
    assert len({round(x, 1) for x, _ in local}) == 3
    assert all(turn_between(d.yaw, board.yaw) < 1.0 for d in desks)


def test_a_chair_behind_each_desk_is_drawn_up_to_it():
    prompt = "An office with four desks in two rows, each with a chair behind it."
    assert unmet(prompt) == []
    desks, chairs = of(prompt, "executive_desk"), of(prompt, "office_chair") + of(prompt, "chair")
    assert len(desks) == len(chairs) == 4
    assert all(turn_between(d.yaw, desks[0].yaw) % 180.0 < 1.0 for d in desks)
    assert all(min(apart(chair, desk) for desk in desks) < 0.3 for chair in chairs)


def test_seats_round_a_small_thing_form_a_circle_as_wide_as_they_need():
    prompt = "A museum room with a pedestal in the middle and four benches around it."
    assert unmet(prompt) == []
    pedestal = of(prompt, "pedestal")[0]
    turns = sorted(
        math.degrees(math.atan2(b.position[1] - pedestal.position[1], b.position[0] - pedestal.position[0]))
        for b in of(prompt, "bench")
    )
    assert np.allclose(np.diff(turns), 90.0, atol=2.0)


def test_far_apart_asks_for_a_room_that_is_long_enough():
    room = plan_room(read_brief("A nursery with a crib far from the window."), rng=0)
    assert max(room.extent) > 4.5


def test_only_rooms_whose_size_is_left_open_grow():
    assert is_open(read_brief("A café with a counter."))
    assert not is_open(read_brief("A café, 4 m by 5 m, with a counter."))
    assert not is_open(read_brief("A tiny café with a counter."))
    brief = read_brief("A café with a counter.")
    room = plan_room(brief, rng=0)
    wider = plan_room(larger(brief, room, 1.35), rng=0)
    assert math.isclose(wider.polygon.area / room.polygon.area, 1.35, rel_tol=0.05)


@pytest.mark.parametrize("seed", range(3))
def test_somebody_can_stand_behind_the_counter_by_a_door(seed: int):
    scene = generate_room("A shop with a counter by the door and two shelving units.", fill="named", seed=seed).scene
    counter = scene["counter_1"]
    assert scene.room.polygon.contains(Point(counter.to_room((-counter.size[0] / 2 - 0.8, 0.0))))


@pytest.mark.parametrize("seed", range(2))
def test_a_telescope_at_the_window_looks_out(seed: int):
    room = generate_room("A room with a bed and a telescope at the window.", fill="named", seed=seed)
    telescope = room.scene["telescope_1"]
    outward = [room.scene.room.walls[o.wall].yaw + 180.0 for o in room.scene.room.openings if o.kind == "window"]
    assert min(turn_between(telescope.yaw, yaw) for yaw in outward) < 1.0
    assert room.report.complete
