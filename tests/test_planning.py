"""From a brief to a room and to an order of placing."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests import sim_rooms as sims
from tests.test_reading import OWN, SHARED
from tests.test_reading_hostile import WORDS
from thinkblox.assets import kind_of
from thinkblox.brief import Brief, OpeningRequest, Relation, Request
from thinkblox.errors import InputError
from thinkblox.plan import Plan
from thinkblox.planning import plan_brief, plan_room, with_sizes
from thinkblox.planning.variety import varied
from thinkblox.reading import read_brief
from thinkblox.reporting import relations_of
from thinkblox.scene.room import rectangle

ROOM = rectangle(6.0, 5.0)


def plan_of(prompt: str) -> Plan:
    return plan_brief(read_brief(prompt), ROOM)


def ties_of(plan: Plan, id: str) -> list[tuple[str, ...]]:
    return [(tie.kind, *tie.anchors) for tie in plan.target(id).ties]


def check_plan(plan: Plan, brief: Brief) -> None:
    ids = [target.id for target in plan.targets]
    assert len(set(ids)) == len(ids)
    for request in brief.requests:
        assert sum(target.request == request.key for target in plan.targets) == request.count
    placed: set[str] = set()
    for target in plan.targets:
        assert set(target.depends_on) <= placed, target.id
        placed.add(target.id)
        assert all(0 <= tie.index < tie.count for tie in target.ties)


@pytest.mark.parametrize("prompt", SHARED | OWN)
def test_order_is_topological_and_complete(prompt: str) -> None:
    brief = read_brief(prompt)
    check_plan(plan_brief(brief, plan_room(brief, rng=0)), brief)


@pytest.mark.parametrize("prompt", SHARED | OWN)
def test_every_asked_relation_becomes_a_tie(prompt: str) -> None:
    brief = read_brief(prompt)
    plan = plan_brief(brief, ROOM)
    tied = {(target.request, tie.kind) for target in plan.targets for tie in target.ties if tie.asked}
    request = {target.id: target.request for target in plan.targets}
    tied |= {(request[due.subject], due.tie.kind) for target in plan.targets for due in target.due}
    assert {(r.subject, r.kind) for r in brief.relations if r.asked} <= tied


@settings(max_examples=200, deadline=None)
@given(st.lists(st.sampled_from(WORDS), max_size=40).map(" ".join))
@example("a bed next to a desk . the desk next to the bed")
@example("a lamp on a table on a lamp . the table on the lamp")
def test_any_brief_can_be_planned(text: str) -> None:
    try:
        brief = read_brief(text)
    except InputError:
        return
    room = plan_room(brief, rng=1)
    check_plan(plan_brief(brief, room), brief)


def test_a_lamp_for_each_nightstand() -> None:
    plan = plan_of("A bed, two nightstands with a lamp on each.")
    assert ties_of(plan, "table_lamp_1") == [("on", "nightstand_1")]
    assert ties_of(plan, "table_lamp_2") == [("on", "nightstand_2")]
    assert ties_of(plan, "nightstand_2") == [("next_to", "bed_1")]
    assert not plan.target("nightstand_1").ties[0].asked


def test_chairs_are_shared_out_over_tables() -> None:
    plan = plan_of("A restaurant with five square tables with four chairs each.")
    tie = plan.target("chair_10").ties[0]
    assert (tie.kind, tie.anchors, tie.index, tie.count) == ("around", ("dining_table_3",), 1, 4)


def test_chairs_are_shared_out_over_tables_of_which_one_was_told_apart() -> None:
    plan = plan_of("Three round tables with four chairs each. Two of the tables have a lamp, the third a vase.")
    at = [tie.anchors for target in plan.targets if target.category == "chair" for tie in target.ties]
    assert [at.count((f"dining_table_{n}",)) for n in (1, 2, 3)] == [4, 4, 4]


def test_plants_are_shared_out_without_each() -> None:
    plan = plan_of("A florist with fifteen potted plants on three tiered tables.")
    assert [plan.target(f"potted_plant_{n}").ties[0].anchors for n in (1, 5, 6, 15)] == [
        ("tiered_table_1",),
        ("tiered_table_1",),
        ("tiered_table_2",),
        ("tiered_table_3",),
    ]


def test_rows_face_each_other() -> None:
    plan = plan_of("Two rows of five chairs facing each other.")
    assert ties_of(plan, "chair_1") == [("in_rows",), ("facing",)]
    assert ties_of(plan, "chair_6") == [("in_rows",), ("facing", "chair_1")]
    assert plan.target("chair_6").ties[0].rows == 2


def test_habits_tie_what_nobody_mentions() -> None:
    plan = plan_of("bed, nightstand, desk, office chair, monitor, sofa, coffee table, TV, TV stand, wardrobe, picture")
    assert ties_of(plan, "nightstand_1") == [("next_to", "bed_1")]
    assert ties_of(plan, "office_chair_1") == [("at", "desk_1")]
    assert ties_of(plan, "monitor_1") == [("on", "desk_1")]
    assert ties_of(plan, "coffee_table_1") == [("in_front_of", "sofa_1")]
    assert ties_of(plan, "tv_1") == [("on", "tv_stand_1")]
    assert ties_of(plan, "tv_stand_1") == [("opposite", "sofa_1")]
    assert ties_of(plan, "wardrobe_1") == [("against_wall", "wall")]
    assert ties_of(plan, "picture_1") == [("above", "sofa_1")]


def test_things_stand_on_what_carries_them_in_such_a_room() -> None:
    plan = plan_of("A biology lab with two benches, microscopes and stools")
    assert {ties_of(plan, f"microscope_{number}")[0][1] for number in (1, 2, 3)} == {"lab_bench_1", "lab_bench_2"}


def test_a_cup_next_to_a_laptop_is_on_its_desk() -> None:
    plan = plan_of("A desk with a laptop, a coffee table, and a cup next to the laptop.")
    assert ties_of(plan, "cup_1") == [("on", "desk_1"), ("next_to", "laptop_1")]


def test_things_spread_over_cabinets() -> None:
    plan = plan_of("Base cabinets along one wall carrying a sink, a stove and a microwave.")
    anchors = {plan.target(id).ties[0].anchors for id in ("sink_1", "hob_1", "microwave_1")}
    assert anchors == {("base_cabinet_1",), ("base_cabinet_2",), ("base_cabinet_3",)}


def test_relations_in_a_circle_keep_an_order() -> None:
    brief = Brief(
        prompt="",
        requests=(Request(key="a", category="bed"), Request(key="b", category="desk")),
        relations=(
            Relation(kind="left_of", subject="a", anchors=("b",)),
            Relation(kind="behind", subject="b", anchors=("a",)),
        ),
    )
    plan = plan_brief(brief, ROOM)
    check_plan(plan, brief)
    assert ("in_front_of", "desk_1") in ties_of(plan, "bed_1")


def test_who_sits_around_a_table_may_face_it_as_well() -> None:
    said = "Two wicker chairs and a loveseat are grouped around a coffee table, and the loveseat faces the table."
    brief = read_brief(f"A sunroom. {said}")
    check_plan(plan_brief(brief, plan_room(brief, rng=0)), brief)


def test_large_things_come_first_and_small_things_last() -> None:
    plan = plan_of("A vase, a chair, a rug, a dining table, a sideboard and a wardrobe.")
    ids = [target.id for target in plan.targets]
    for earlier, later in pairwise(["dining_table_1", "chair_1", "vase_1"]):
        assert ids.index(earlier) < ids.index(later)


def test_a_board_that_desks_face_is_placed_before_them() -> None:
    plan = plan_of("A classroom with twelve school desks in three rows facing a whiteboard, and a bookcase.")
    ids = [target.id for target in plan.targets]
    assert ids.index("whiteboard_1") < ids.index("school_desk_1")


@pytest.mark.parametrize("prompt", SHARED)
@pytest.mark.parametrize("seed", range(3))
def test_rooms_have_a_door_and_are_neither_tiny_nor_halls(prompt: str, seed: int) -> None:
    room = plan_room(read_brief(prompt), rng=np.random.default_rng(seed))
    assert [o.kind for o in room.openings].count("door") == 1
    assert 5.0 <= room.polygon.area <= 70.0


def test_closets_have_narrow_doors_that_open_outwards() -> None:
    tiny, usual = (
        plan_room(read_brief(f"A {size} room with a stool."), rng=0) for size in ("1.2 by 1.5 m", "3 by 3 m")
    )
    (door,) = (o for o in tiny.openings if o.kind == "door")
    assert (door.opens, door.width) == ("out", 0.7)
    assert door.swept < 0.5
    assert {o.opens for o in usual.openings if o.kind == "door"} == {"in"}


def test_a_room_is_as_large_as_it_is_said_to_be() -> None:
    assert plan_room(read_brief("a bedroom, 4 m by 5 m"), rng=0).extent == (4.0, 5.0)
    assert plan_room(read_brief("a studio of 18 square metres"), rng=0).polygon.area == pytest.approx(18.0, abs=0.05)
    assert plan_room(read_brief("a bedroom 4 x 5 x 3 m"), rng=0).height == 3.0


def test_chairs_for_the_tables_of_a_prompt_have_floor_around_these() -> None:
    told, untold = (
        plan_room(read_brief(f"An office with two long tables {how} six chairs"), rng=1) for how in ("and", "with")
    )
    assert told.polygon.area > 24.0
    assert untold.polygon.area > 24.0


def test_an_l_has_six_corners_and_its_area() -> None:
    room = plan_room(read_brief("An L-shaped office of 20 m2 with a desk."), rng=0)
    assert len(room.floor) == 6
    assert room.polygon.area == pytest.approx(20.0, abs=0.1)


def test_more_furniture_needs_a_larger_room() -> None:
    few = plan_room(read_brief("A classroom with six school desks."), rng=0)
    many = plan_room(read_brief("A classroom with forty school desks."), rng=0)
    assert many.polygon.area > few.polygon.area + 20.0


def test_openings_go_where_they_are_asked() -> None:
    room = plan_room(read_brief("A bedroom with two windows on the north wall and a door in the west wall."), rng=0)
    assert sorted((o.kind, room.walls[o.wall].name) for o in room.openings) == [
        ("door", "west_wall"),
        ("window", "north_wall"),
        ("window", "north_wall"),
    ]


def test_no_windows_where_none_are_wanted_and_one_where_one_is_named() -> None:
    assert {o.kind for o in plan_room(read_brief("A bedroom without windows."), rng=0).openings} == {"door"}
    laundry = plan_room(read_brief("A laundry room with a washing machine by the window."), rng=0)
    assert "window" in {o.kind for o in laundry.openings}


def test_more_openings_than_the_walls_hold_are_left_out() -> None:
    brief = Brief(prompt="", width=2.0, depth=2.0, openings=(OpeningRequest(kind="window", count=20),))
    assert 1 <= sum(o.kind == "window" for o in plan_room(brief, rng=0).openings) < 20


def test_the_same_seed_gives_the_same_room() -> None:
    brief = read_brief("A bedroom.")
    assert plan_room(brief, rng=5) == plan_room(brief, rng=5)
    assert plan_room(brief, rng=5) != plan_room(brief, rng=6)


def test_a_door_leaves_room_for_a_plant_in_each_corner() -> None:
    for prompt in (
        "A waiting room with a plant in each corner.",
        "A waiting room with four plants in the four corners.",
    ):
        room = plan_room(read_brief(prompt), rng=0)
        for opening in room.openings:
            length = room.walls[opening.wall].length
            assert min(opening.offset, length - opening.offset - opening.width) >= 0.85, prompt


def test_windows_of_a_garage_are_aside_of_its_gate_and_leave_the_back_wall_free() -> None:
    brief = read_brief("A garage of 7 m by 6 m with a car. Against the back wall is a workbench with a pegboard above.")
    room = plan_room(brief, rng=0)
    (gate,) = (o.wall for o in room.openings if o.kind == "door")
    windows = {o.wall for o in room.openings if o.kind == "window"}
    assert windows
    assert windows.isdisjoint((gate, (gate + 2) % 4))


def test_walls_are_seen_from_the_door() -> None:
    plan = plan_of(
        "A bedroom with a bed against the far wall, a desk along the left wall and a plant in the near right corner."
    )
    assert ties_of(plan, "bed_1") == [("against_wall", "north_wall")]
    assert ties_of(plan, "desk_1") == [("against_wall", "west_wall")]
    assert ties_of(plan, "plant_1") == [("in_corner", "corner"), ("near", "south_wall"), ("near", "east_wall")]
    brief = read_brief("A bedroom with a door in the east wall and a bed against the left wall.")
    room = plan_room(brief, rng=0)
    assert plan_brief(brief, room).target("bed_1").ties[0].anchors == ("south_wall",)


def test_a_tv_on_the_wall_hangs_opposite_the_seat_that_looks_at_it() -> None:
    plan = plan_of("A living room with a sofa, a coffee table and a TV on the wall.")
    assert ties_of(plan, "wall_tv_1")[0] == ("opposite", "sofa_1")


def test_appliances_take_any_place_in_their_run() -> None:
    plan = plan_of("A kitchen with a fridge, a stove, an oven, a dishwasher and a table.")
    found = [ties_of(plan, id) for id in ("stove_1", "oven_1", "dishwasher_1")]
    assert found == [[("against_wall", "wall")]] * 3


def test_small_things_stay_on_the_floor_where_they_are_said_to_be() -> None:
    plan = plan_of("A storage room with a shelving unit, a box on the floor and a basket next to the shelving unit.")
    assert ties_of(plan, "box_1") == [("on", "floor")]
    assert ties_of(plan, "basket_1") == [("next_to", "shelving_unit_1"), ("on", "floor")]


def test_what_is_beside_a_thing_on_furniture_is_measured_by_that_thing() -> None:
    plan = plan_of("A desk with a printer on it; a bin to the right of the printer and a stool facing the printer.")
    assert ("right_of", "desk_1") in ties_of(plan, "waste_bin_1")
    assert all(tie.means for tie in plan.target("waste_bin_1").ties if tie.kind == "right_of")
    due = {(due.subject, due.tie.kind, *due.tie.anchors) for due in plan.target("printer_1").due}
    assert {("waste_bin_1", "right_of", "printer_1"), ("stool_1", "facing", "printer_1")} <= due

    desk, printer = sims.asset("desk", (0.7, 1.6, 0.75)), sims.asset("printer", (0.4, 0.4, 0.3))
    rest = [(sims.put(sims.asset(name, (0.3, 0.3, 0.4)), x, y), sims.asset(name, (0.3, 0.3, 0.4)))
            for name, x, y in (("waste_bin", 1.0, 1.0), ("stool", 2.0, 2.2))]  # fmt: skip
    for along, so in ((2.4, True), (0.8, False)):
        on_it = sims.put(printer, 1.0, along, 0.75, on="desk_1")
        scene = sims.scene(ROOM, (sims.put(desk, 1.0, 2.0), desk), (on_it, printer), *rest)
        found = {r.subject: r for r in relations_of(scene, plan) if r.anchors == ("printer_1",)}
        assert found["waste_bin_1"].holds is so


def test_what_has_a_place_of_its_own_is_not_presumed_to_be_carried() -> None:
    plan = plan_of("A large aquarium is against the wall with an armchair to its left. A TV is on a sideboard.")
    assert ("left_of", "aquarium_1") in ties_of(plan, "armchair_1")


def test_counters_are_long_enough_for_who_sits_at_them() -> None:
    width = plan_of("A bar counter with six stools.").target("bar_counter_1").size[1]
    assert width is not None
    assert width >= 6 * 0.6


def test_what_cannot_be_is_said() -> None:
    brief = read_brief("A 2 m by 3 m room with ten windows in the north wall and a 12 m long sofa.")
    notes = plan_brief(brief, plan_room(brief, rng=0)).notes
    assert any("sofa" in note and "12 m" in note for note in notes)
    assert any("windows in the north wall did not fit" in note for note in notes)


def test_benches_at_which_people_sit_stand_in_rows_and_look_at_the_board() -> None:
    plan = plan_of("A biology classroom with lab tables for 24 pupils")
    assert ties_of(plan, "lab_table_12") == [("in_rows",), ("facing", "whiteboard_1")]
    assert sum(target.category == "stool" for target in plan.targets) == 24
    assert ("against_wall", "wall") in ties_of(plan_of("A workshop with four workbenches"), "workbench_4")


@pytest.mark.parametrize(
    ("prompt", "id"),
    [
        ("A nursery for twins with two cribs", "crib_2"),
        ("A restroom with three washbasins and three toilet cubicles", "toilet_cubicle_3"),
        ("A rehearsal room with two guitar amps", "guitar_amp_2"),
        ("A clothes shop with two fitting rooms", "changing_cubicle_2"),
        ("A hair salon with four styling stations", "styling_station_4"),
        ("An open plan office for six people", "desk_6"),
        ("A chemistry laboratory with two lab benches", "lab_bench_2"),
    ],
)
def test_alike_things_stand_together(prompt: str, id: str) -> None:
    assert ties_of(plan_of(prompt), id)[0] == ("in_rows",)


def test_two_that_are_asked_to_look_at_each_other_stand_in_no_row() -> None:
    assert ("in_rows",) not in ties_of(plan_of("A small office with two desks facing each other"), "desk_2")


def test_two_beds_stand_in_line() -> None:
    for prompt, second in (
        ("A hotel room with two double beds and a desk", "bed_2"),
        ("A hospital room for two patients with visitor chairs", "hospital_bed_2"),
    ):
        assert ties_of(plan_of(prompt), second) == [("in_rows",)]


@pytest.mark.parametrize(
    ("prompt", "stool", "least", "most"),
    [
        ("A laboratory with a lab bench and two stools at it", "stool_1", 0.58, 0.72),
        ("A bar with a bar counter and two bar stools at it", "bar_stool_1", 0.7, 0.9),
        ("A kitchen with a dining table and two stools at it", "stool_1", 0.4, 0.52),
        ("A music room with a piano and a stool at it", "stool_1", 0.4, 0.52),
    ],
)
def test_a_stool_is_as_high_as_the_top_that_it_is_drawn_up_to_asks(
    prompt: str, stool: str, least: float, most: float
) -> None:
    target = plan_of(prompt).target(stool)
    assert least <= (target.size[2] or kind_of(target.category).size[2]) <= most


def test_who_waits_sits_in_a_row_with_the_magazines_before_its_middle() -> None:
    plan = plan_of("A dentist's waiting room with ten chairs and magazines on a table")
    assert ties_of(plan, "chair_10") == [("in_rows",), ("against_wall", "wall")]
    assert ties_of(plan, "coffee_table_1")[0] == ("in_front_of", "chair_6")


@pytest.mark.parametrize("desk", ["librarian's desk", "help desk", "circulation desk"])
def test_a_desk_across_which_people_are_served_is_worked_at_from_behind(desk: str) -> None:
    plan = plan_of(f"A public library with four bookcases and a {desk} near the door")
    assert any(target.category == "reception_desk" for target in plan.targets)


def test_a_kitchen_called_by_its_shape_is_one_of_cabinets() -> None:
    brief = read_brief("An L-shaped kitchen with an oven and a breakfast bar with two stools")
    assert brief.shape == "rectangle"
    assert {"base_cabinet", "sink", "hob", "fridge"} <= {request.category for request in varied(brief, 1).requests}
    assert 2.2 <= plan_room(read_brief("a galley kitchen"), rng=0).extent[1] <= 2.6


def test_what_is_across_the_room_at_a_wall_each_is_not_too_far_away() -> None:
    for seed in range(4):
        brief = read_brief(
            "A game room with a pool table in the center. Against one wall is an arcade machine. "
            "A dartboard is hung on the wall across from the arcade machine."
        )
        assert min(plan_room(brief, rng=seed).extent) < 4.9


def test_furniture_is_small_in_a_room_whose_size_is_tight_for_it() -> None:
    furniture = "a bed against the wall, a desk with a chair and a wardrobe next to the door."
    cabins = (read_brief(f"A cabin, {size}: {furniture}") for size in ("2.2 m by 2.6 m", "6 m by 5 m"))
    tight, wide = ([r.drawn[1] or 0.0 for r in with_sizes(brief, 0).requests] for brief in cabins)
    assert all(small <= usual for small, usual in zip(tight, wide, strict=True))
    assert sum(tight) < sum(wide)
