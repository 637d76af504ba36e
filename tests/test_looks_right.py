"""What made a person shake the head over a room: one case for each cause."""

import math
from functools import cache

import numpy as np
import pytest

from thinkblox.assets import make_asset
from thinkblox.furnishing import Generation
from thinkblox.generate import generate_room
from thinkblox.plan import Plan, Target
from thinkblox.planning import ExpertPlanner, plan_brief, varied
from thinkblox.reading import read_brief
from thinkblox.scene.placement import Placement

pytestmark = pytest.mark.slow


@cache
def made(prompt: str) -> Generation:
    return generate_room(prompt, seed=0)


@cache
def planned(prompt: str) -> Plan:
    brief = varied(read_brief(prompt), 0)
    return plan_brief(brief, ExpertPlanner().room(brief, np.random.default_rng(0)))


def counts(prompt: str) -> dict[str, int]:
    return {request.category: request.count for request in read_brief(prompt).requests}


def placed(room: Generation, category: str) -> list[Placement]:
    return [p for p in room.scene.placements if p.category == category]


def off_walls(room: Generation, thing: Placement) -> float:
    return min(abs(wall.coordinates(corner)[1]) for wall in room.scene.room.walls for corner in thing.corners)


def targets(plan: Plan, category: str) -> list[Target]:
    return [target for target in plan.targets if target.category == category]


def test_a_hob_is_no_larger_for_the_pans_on_it():
    plan = planned("A kitchen. Two frying pans and a cooking pot are on the hob.")
    (hob,) = targets(plan, "hob")
    assert hob.size[1] is None or hob.size[1] <= 0.6


def test_uncounted_chairs_are_enough_for_the_tables_of_a_cafe():
    found = counts("a coffee shop with mismatched chairs")
    assert found["chair"] == 2 * found["dining_table"]


def test_chairs_that_a_prompt_tells_apart_have_desks_of_their_own():
    plan = planned(
        "Four desks along the wall. Each has a chair; every second chair has a cushion on it, so two in all."
    )
    at = [tie.anchors for chair in targets(plan, "chair") for tie in chair.ties if tie.kind == "at"]
    assert len(at) == len(set(at)) == 4


def test_a_bed_that_looks_at_a_screen_has_its_head_at_the_wall():
    room = made("A hotel room, 4 x 6.5 m, with a king bed facing a wall-mounted TV and an armchair near the window.")
    assert off_walls(room, *placed(room, "bed")) < 0.1


def test_a_vanity_with_sinks_on_it_has_no_basin_of_its_own():
    (vanity,) = targets(planned("A bathroom with a vanity; two vessel sinks are on the vanity."), "vanity")
    assert "plain-top" in vanity.attributes
    (other,) = targets(planned("A bathroom with a vanity; a soap dispenser is on the vanity."), "vanity")
    assert "plain-top" not in other.attributes
    plain = make_asset("vanity", seed=0, attributes=("plain-top",))
    assert max(s.size[1] for s in plain.surfaces) > 0.9 * plain.size[1]


@pytest.mark.parametrize(
    ("said", "thing", "part"),
    [
        ("A bathroom with a toilet; its lid is closed.", "toilet", "lid"),
        ("A study with a filing cabinet; its drawers are closed.", "filing_cabinet", "dresser"),
    ],
)
def test_the_state_of_a_part_is_that_of_its_thing(said: str, thing: str, part: str):
    brief = read_brief(said)
    assert part not in {request.category for request in brief.requests}
    assert next(r for r in brief.requests if r.category == thing).states == ("closed",)
    assert brief.unknown == ()


def test_a_bathroom_has_all_that_one_needs_there():
    named = (
        "Family bathroom: two washbasins side by side, a mirror above each, a bathtub, a cabinet, a towel rail, a rug."
    )
    assert targets(planned(named), "toilet")
    hotel = planned("bathroom like in a five star hotel, white marble, fluffy towels, an orchid")
    assert targets(hotel, "shower_cabin") or targets(hotel, "bathtub")
    assert not targets(planned("A bathroom with a toilet and no bathtub and no shower"), "shower_cabin")


def test_many_recliners_stand_in_rows_before_the_screen():
    plan = planned("home cinema, six recliners and a popcorn machine at the back")
    recliners = targets(plan, "recliner")
    assert {tie.kind for tie in recliners[0].ties} == {"in_rows", "facing"}
    assert not targets(plan, "counter")
    (machine,) = targets(plan, "popcorn_machine")
    (carrier,) = (t for t in plan.targets if any(t.id in tie.anchors for tie in machine.ties if tie.kind == "on"))
    asked = next(tie for tie in machine.ties if tie.asked)
    assert (asked.kind, asked.anchors) in {(tie.kind, tie.anchors) for tie in carrier.ties}


def test_what_is_beside_two_sofas_that_face_each_other_does_not_bring_them_together():
    room = made("An L-shaped living room. Two sofas face each other, a fireplace is against the wall.")
    one, other = placed(room, "sofa")
    assert math.dist(one.position, other.position) > 1.2 + one.size[0]


def test_nothing_tall_stands_before_a_bench_that_it_is_next_to():
    room = made(
        "Chemistry lab: a lab bench against the wall with three beakers on it, a fume hood next to the bench, a lab "
        "stool in front of the bench, two gas cylinders against the wall."
    )
    (bench,), (hood,) = placed(room, "lab_bench"), placed(room, "fume_hood")
    x, y = bench.to_local((hood.position[0], hood.position[1]))
    assert not (x > bench.size[0] / 2 and abs(y) < bench.size[1] / 4)


def test_rows_of_shelves_that_are_asked_for_stand_amid_a_shop():
    room = made("A corner grocery, 10 m x 8 m. Six shelving units stand in two rows of three.")
    assert all(off_walls(room, shelves) > 0.5 for shelves in placed(room, "shelving_unit"))


def test_one_sits_on_both_sides_of_a_manicure_table():
    room = made("a nail salon")
    for table in placed(room, "manicure_table"):
        assert off_walls(room, table) > 0.5


def test_candles_in_a_bedroom_stand_on_a_nightstand():
    found = counts("cosy hygge bedroom with candles")
    assert "side_table" not in found


@pytest.mark.parametrize(
    ("said", "thing"),
    [
        ("A sideboard with a fan on it", "desk_fan"),
        ("A fan in the corner", "fan"),
    ],
)
def test_what_a_word_means_by_its_company(said: str, thing: str):
    assert thing in counts(said)


def test_a_design_studio_is_an_office():
    assert read_brief("A design studio with three desks").room_type == "office"


def test_a_library_at_home_is_furnished_for_one_who_reads_there():
    brief = read_brief("dark academia private library, rolling ladder, leather armchairs, candles")
    assert brief.room_type == "home_library"
    room = {request.category for request in brief.requests}
    assert {"bookcase", "coffee_table"} <= room
    assert not {"dining_table", "computer", "monitor"} & room


def test_what_is_on_a_rug_before_a_sofa_stands_before_the_sofa():
    room = made(
        "Against the long wall there is a leather chesterfield. In front of the chesterfield lies a Persian rug, and "
        "on the rug stands an old wooden chest."
    )
    (sofa,), (chest,), (rug,) = (placed(room, category) for category in ("sofa", "chest", "rug"))
    ahead, aside = sofa.to_local((chest.position[0], chest.position[1]))
    assert ahead > sofa.size[0] / 2
    assert abs(aside) < sofa.size[1] / 4
    assert math.dist(chest.position[:2], rug.position[:2]) < max(rug.size[:2]) / 2


def test_a_rug_that_is_rolled_up_does_not_lie_flat():
    found = counts("A lounge with a sofa. The rug is rolled up in the corner.")
    assert "rolled_rug" in found
    assert "rug" not in found


def test_what_has_no_room_on_a_pedestal_beside_another_stands_on_the_floor():
    plan = planned("A robot arm on a steel pedestal in the middle, one parts bin on its left and one on its right.")
    for bin_ in targets(plan, "storage_bin"):
        assert not any(tie.kind == "on" and "pedestal_1" in tie.anchors for tie in bin_.ties)


def test_a_twin_room_has_two_single_beds():
    bed = next(request for request in read_brief("a twin room in a hotel").requests if request.category == "bed")
    assert bed.count == 2
    assert "single" in bed.attributes


def test_a_counter_with_a_sink_beside_a_dishwasher_stands_at_the_wall():
    room = made("The dishwasher stands next to the sink; four plates are on the counter.")
    counters = placed(room, "base_cabinet")
    assert counters
    assert all(off_walls(room, counter) < 0.1 for counter in counters)


def test_each_bunk_bed_of_a_dorm_has_its_locker_at_its_head_by_the_wall():
    room = made("A hostel dorm with four bunk beds and a locker next to every bed.")
    beds, lockers = placed(room, "bunk_bed"), placed(room, "locker")
    assert len(beds) == len(lockers) == 4
    assert all(off_walls(room, thing) < 0.1 for thing in (*beds, *lockers))


def test_a_narrow_cabin_with_a_bunk_a_desk_and_a_locker_is_valid():
    room = made(
        "Single cabin on a cargo ship, 2.2 m by 3 m: a bunk against the wall, a small desk with a chair, a locker."
    )
    assert room.report.valid
    assert all(verdict.valid for verdict in room.report.objects)


def test_rows_of_desks_look_at_the_board():
    plan = planned("An office with two rows of six desks, each with a chair, and a whiteboard.")
    assert all(any(t.kind == "facing" for t in desk.ties) for desk in targets(plan, "desk"))


def test_pupils_who_have_their_stools_at_the_tables_get_no_benches_besides():
    found = counts("A chemistry classroom for sixteen pupils: four lab tables with four stools at each.")
    assert "lab_bench" not in found
    assert (
        counts("A chemistry classroom for sixteen pupils with two lab tables with two stools at each.")["lab_bench"] > 0
    )


def test_a_sink_in_a_counter_is_let_into_it():
    assert counts("A clinic with a counter with a sink.")["sink"] == 1
    assert counts("A clinic with a sink on the wall.")["washbasin"] == 1


def test_a_nightstand_is_at_the_head_of_a_bed_with_much_beside_it():
    room = made("A hospital room: a hospital bed with a bedside cabinet, an IV stand and a visitor chair next to it.")
    (bed,), (stand,) = placed(room, "hospital_bed"), [*placed(room, "bedside_cabinet"), *placed(room, "nightstand")]
    along, _ = bed.to_local(stand.position[:2])
    assert along < -bed.size[0] / 4


def test_a_car_can_leave_its_garage():
    room = made("A garage with a car in the middle and a workbench against the back wall")
    (car,) = placed(room, "car")
    gate = max((o for o in room.scene.room.openings if o.kind == "door"), key=lambda opening: opening.width)
    assert gate.width > car.size[1]
    assert (car.yaw - room.scene.room.walls[gate.wall].yaw) % 180.0 == pytest.approx(0.0, abs=1.0)


def test_a_tavern_has_its_bar():
    assert counts("a rustic tavern")["bar_counter"] == 1


def test_barriers_that_find_no_room_right_at_a_thing_stand_all_round_it_further_off():
    room = made("A museum hall, 12 by 9 m, with a dinosaur skeleton in the middle surrounded by eight rope stanchions.")
    (ring,) = [r for r in room.report.relations if r.kind == "around"]
    assert ring.holds


def test_no_screen_hangs_over_the_seats_of_those_who_wait():
    room = made("A dentist's waiting room")
    (screen,) = placed(room, "wall_tv")
    below = [p for p in placed(room, "chair") if math.dist(p.position[:2], screen.position[:2]) < screen.size[1] / 2]
    assert not below


def test_the_sofas_of_a_bar_have_a_low_table():
    assert any(t.category == "coffee_table" for t in planned("A bar with two sofas").targets)


def test_a_chest_before_a_sofa_leaves_room_for_legs_and_stands_amid_its_rug():
    room = made(
        "A sofa is against the wall. In front of the sofa lies a rug, and on the rug stands an old wooden chest."
    )
    (sofa,), (rug,), (chest,) = placed(room, "sofa"), placed(room, "rug"), placed(room, "chest")
    assert chest.footprint.distance(sofa.footprint) > 0.3
    assert rug.footprint.contains(chest.footprint)


def test_a_table_with_its_chairs_by_the_fridge_is_the_dining_part_of_the_room():
    found = counts(
        "An open-plan kitchen and dining room. A long oak table with eight chairs stands next to the fridge."
    )
    assert found["chair"] == 8
    assert sum(number for name, number in found.items() if name.endswith("_table")) == 1


def test_a_rug_is_under_the_middle_of_a_round_table_or_away_from_it():
    room = made(
        "A library with six bookcases along the walls, a round table with a globe and a Persian rug on the floor."
    )
    (rug,) = placed(room, "rug")
    for table in placed(room, "dining_table"):
        assert rug.footprint.contains(table.footprint) or not rug.footprint.intersects(table.footprint)


@pytest.mark.parametrize("prompt", ["A nail salon", "A massage room", "A tattoo studio"])
def test_nobody_has_their_hair_washed_where_none_is_cut(prompt: str):
    kinds = {r.category for seed in range(4) for r in varied(read_brief(prompt), seed).requests}
    assert kinds.isdisjoint({"shampoo_basin", "hairdressing_trolley", "hair_dryer_chair"})


@pytest.mark.parametrize(
    ("prompt", "category"),
    [
        ("Four desks along the wall. Each has a chair; every second chair has a cushion on it, so two in all.", "desk"),
        ("A storage room with three racks along the wall", "shelving_unit"),
        ("Six lockers along the wall and three benches along the opposite wall", "locker"),
    ],
)
def test_what_stands_along_the_wall_stands_in_one_line(prompt: str, category: str):
    room = made(prompt)
    things = placed(room, category)
    assert len({thing.yaw for thing in things}) == 1
    assert all(off_walls(room, thing) < 0.1 for thing in things)


@pytest.mark.parametrize(
    ("prompt", "category"),
    [
        ("A table with six chairs and a high chair at one end. Each chair gets a plate, a cup and a party hat.", "cup"),
        ("A birthday table with six chairs; six plates, six cups and six party hats are on it.", "party_hat"),
        ("A round table with four chairs. Four plates, four wine glasses and four forks are on the table.", "fork"),
    ],
)
def test_what_comes_once_for_each_seat_lies_before_it(prompt: str, category: str):
    room = made(prompt)
    chairs = placed(room, "chair")
    near = [min(chairs, key=lambda c: math.dist(c.position[:2], p.position[:2])).id for p in placed(room, category)]
    assert len(set(near)) == len(near) == len(chairs)
    assert all(measured.holds for measured in room.report.relations if category in measured.subject)


def test_no_machine_stands_on_the_mats_before_a_mirror():
    room = made(
        "A gym, 20 by 16 feet, with three treadmills side by side and two exercise bikes behind them. "
        "In front of the mirror on the wall lie five yoga mats."
    )
    mats = placed(room, "yoga_mat")
    machines = (*placed(room, "treadmill"), *placed(room, "exercise_bike"))
    assert len(mats) == 5
    assert not any(mat.footprint.intersection(p.footprint).area > 0.01 for mat in mats for p in machines)


def test_the_first_of_wide_rows_is_not_far_from_the_board():
    room = made("A study hall with two rows of six desks and a whiteboard")
    (board,) = placed(room, "whiteboard")
    ahead = [board.to_local(corner)[0] for desk in placed(room, "school_desk") for corner in desk.corners]
    assert 1.8 < min(ahead) < 3.0


def test_the_counter_between_a_sink_and_a_dishwasher_is_a_kitchens_and_has_its_top_free():
    prompt = "The dishwasher stands next to the sink; four plates and two bowls are on the counter. An oven."
    assert counts(prompt)["base_cabinet"] == 1
    assert counts("A cafe with a counter, an oven and a sink")["counter"] == 1
    room = made(prompt)
    assert all(measured.holds for measured in room.report.relations)
    assert min(math.dist(p.position[:2], placed(room, "oven")[0].position[:2]) for p in placed(room, "sink")) < 2.0
