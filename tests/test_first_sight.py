"""What looked wrong at first sight in whole rooms: things before what they belong to, clear of each other, in line."""

from functools import cache

import numpy as np
import pytest

from thinkblox.assets import make_asset
from thinkblox.furnishing import Generation
from thinkblox.generate import generate_room
from thinkblox.plan import Plan
from thinkblox.planning import ExpertPlanner, plan_brief, varied
from thinkblox.reading import read_brief
from thinkblox.scene.placement import Placement
from thinkblox.scene.rectangles import Rects, overlap_depth
from thinkblox.scene.room import turn_between


@cache
def made(prompt: str) -> Generation:
    return generate_room(prompt, seed=0)


def planned(prompt: str) -> Plan:
    brief = varied(read_brief(prompt), 0)
    return plan_brief(brief, ExpertPlanner().room(brief, np.random.default_rng(0)))


def placed(room: Generation, category: str) -> list[Placement]:
    return [p for p in room.scene.placements if p.category == category]


@pytest.mark.parametrize(
    ("prompt", "room"),
    [
        ("The reading hall of a public library with ten bookcases", "library"),
        ("A hall of a natural history museum with ten display cases", "museum"),
        ("Assembly hall with five rows of eight chairs facing a podium", "lecture_hall"),
        ("The entrance hall of a library with a bench", "hallway"),
        ("A hall with a bench and a coat rack", "hallway"),
    ],
)
def test_the_hall_of_a_building_is_where_its_work_is_done(prompt, room):
    assert read_brief(prompt).room_type == room


def test_a_hob_and_a_sink_that_nobody_puts_there_share_no_cabinet():
    plan = planned("Kitchen with an induction cooktop and an oven but no microwave and no dishwasher.")
    carriers = {t.category: tie.anchors for t in plan.targets for tie in t.ties if tie.kind == "on"}
    assert carriers["hob"] != carriers["sink"]


def test_a_cabinet_of_a_run_is_as_deep_as_the_others_whatever_is_on_it():
    plan = planned("A kitchen with a base cabinet; a sink, a hob, a bread bin and a kettle are on the cabinet.")
    depths = {t.size[0] for t in plan.targets if t.category == "base_cabinet" and t.size[0] is not None}
    usual = make_asset("base_cabinet", seed=0).size[0]
    assert all(abs(depth - usual) < 0.03 for depth in depths)


def test_chairs_around_a_pedestal_table_sit_at_a_table_for_people():
    seated = read_brief("Around the pedestal table are three chairs.")
    assert any(r.category == "bistro_table" for r in seated.requests)
    beside = read_brief("A sofa with a pedestal table next to it.")
    assert any(r.category == "side_table" for r in beside.requests)


def test_a_sauna_has_benches_of_bare_wood():
    (bench,) = [r.category for r in read_brief("A sauna with a bench and a stove").requests if "bench" in r.category]
    for seed in range(6):
        materials = {shape.material for link in make_asset(bench, seed=seed).links for shape in link.shapes}
        assert materials == {"wood"}


def test_nobody_makes_pots_in_a_gallery():
    shown = {r.category for r in read_brief("A ceramics gallery with three vases on three pedestals").requests}
    assert "pottery_wheel" not in shown
    assert "pottery_wheel" in {r.category for r in read_brief("A potter's studio").requests}


def test_an_arm_stands_on_its_foot():
    for seed, size in ((0, None), (1, (1.6, 0.36, 1.2)), (2, (1.11, 0.35, 1.21))):
        arm = make_asset("robot_arm", seed=seed, size=size)
        shapes = [s for link in arm.links for s in link.shapes if s.collide]
        bulks = np.array([np.prod(s.size) for s in shapes])
        middle = (bulks[:, None] * np.array([s.position for s in shapes])).sum(0) / bulks.sum()
        x0, _, x1, _ = arm.card.foot or (0.0, 0.0, 0.0, 0.0)
        assert x0 + 0.05 < middle[0] < x1 - 0.05


@pytest.mark.slow
def test_each_of_a_row_of_salon_chairs_looks_into_a_mirror_over_its_own_cabinet():
    room = made(
        "A hair salon with four stations in a row. Each station consists of a styling chair, a mirror on the wall and, "
        "below the mirror, a small cabinet with a hair dryer on it."
    )
    assert room.report.complete
    chairs, mirrors = placed(room, "salon_chair"), placed(room, "mirror")
    assert len(chairs) == len(mirrors) == 4
    for chair in chairs:
        before = [m.to_local(chair.position[:2]) for m in mirrors if turn_between(m.yaw, chair.yaw) > 170.0]
        assert min(abs(aside) for away, aside in before if 0.3 < away < 2.0) < 0.3


@pytest.mark.slow
def test_nothing_stands_on_mats_that_people_lie_on():
    room = made("A hotel gym, 7 by 6 m, with two treadmills and a mirror on the wall. Three yoga mats in front of it.")
    mats = placed(room, "yoga_mat")
    assert len(mats) == 3
    others = [p for p in room.scene.placements if room.scene.asset_of(p).collides and p.position[2] < 0.1]
    assert overlap_depth(Rects.of_placements(tuple(mats)), Rects.of_placements(tuple(others))).max() < 0.02


@pytest.mark.slow
def test_nobody_sits_with_the_back_to_the_fire():
    room = made("A living room. Two sofas face each other, a marble fireplace is against the wall.")
    (fire,) = placed(room, "fireplace")
    for sofa in placed(room, "sofa"):
        away, aside = sofa.to_local(fire.position[:2])
        assert not (away < 0.0 and abs(aside) < -away)


@pytest.mark.slow
def test_a_clothes_rail_to_the_right_of_a_dressing_table_stands_beside_it():
    room = made(
        "Backstage dressing room (about 15 m2): a dressing table against the wall with a mirror above it, a chair "
        "facing the dressing table, a clothes rail to the right of it."
    )
    (rail,), (table,) = placed(room, "clothes_rack"), placed(room, "dressing_table")
    assert rail.footprint.distance(table.footprint) < 0.5


def test_all_that_is_built_in_one_line_is_along_the_wall_that_ends_its_list():
    brief = read_brief("A small kitchen with a refrigerator, a stove, and a sink along one wall.")
    there = {r.subject for r in brief.relations if r.asked and r.anchors == ("one_wall",)}
    assert {"fridge", "stove"} <= there
    assert len(there) == 3


@pytest.mark.parametrize(
    ("prompt", "there"),
    [
        ("A meeting room with a table and a screen on the wall.", {"projector_screen"}),
        ("A kitchen with a table and a shelf on the wall.", {"wall_shelf"}),
        ("A bar with a dartboard and a shelf on the wall.", {"dart_board", "wall_shelf"}),
    ],
)
def test_only_what_hangs_is_on_a_wall(prompt, there):
    relations = read_brief(prompt).relations
    assert {r.subject for r in relations if r.asked and r.anchors == ("wall",)} == there


def test_what_is_at_the_back_of_a_cinema_is_behind_who_looks_at_the_screen():
    plan = planned("A home cinema, six recliners and a popcorn machine at the back")
    walls = {t.category: a for t in plan.targets for tie in t.ties if tie.kind == "against_wall" for a in tie.anchors}
    across = {
        "north_wall": "south_wall",
        "south_wall": "north_wall",
        "east_wall": "west_wall",
        "west_wall": "east_wall",
    }
    assert walls["projector_screen"] == across[walls["popcorn_machine"]]


@pytest.mark.slow
def test_two_beds_with_a_nightstand_between_them_stand_together_though_a_rug_lies_in_the_middle():
    room = made(
        "A children's room with two single beds and a nightstand between them. A toy chest is at the foot of one bed. "
        "There is a round rug in the middle of the room."
    )
    one, other = placed(room, "bed")
    assert turn_between(one.yaw, other.yaw) < 1.0
    assert one.footprint.distance(other.footprint) < 1.0


@pytest.mark.slow
def test_one_sits_in_the_angle_of_a_desk_with_a_wing():
    room = made("An office with an L-shaped desk against the wall, a computer on it and a bookcase.")
    (desk,), (chair,) = placed(room, "corner_desk"), placed(room, "office_chair")
    assert desk.footprint.contains(chair.footprint.centroid)


@pytest.mark.slow
def test_every_two_that_share_a_table_stand_in_a_row_with_it_between_them():
    room = made(
        "The relaxation room of a spa. Four loungers, every two loungers share a low table with a candle on it."
    )
    assert room.report.complete
    loungers, tables = placed(room, "lounger"), placed(room, "coffee_table")
    assert (len(loungers), len(tables)) == (4, 2)
    for table in tables:
        near = sorted(float(table.footprint.distance(lounger.footprint)) for lounger in loungers)
        assert near[1] < 0.5 < near[2]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("prompt", "category"),
    [
        ("A hotel gym with three treadmills side by side and two exercise bikes behind them.", "treadmill"),
        ("A lounge with three armchairs side by side and a coffee table.", "armchair"),
    ],
)
def test_alike_things_side_by_side_look_one_way_and_stand_in_one_line(prompt, category):
    row = placed(made(prompt), category)
    assert len(row) == 3
    assert all(turn_between(row[0].yaw, other.yaw) < 1.0 for other in row)
    assert all(abs(row[0].to_local(other.position[:2])[0]) < 0.05 for other in row)
