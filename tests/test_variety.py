"""Rooms of one prompt differ from seed to seed in what the prompt leaves open, and in nothing else."""

from typing import get_args

import numpy as np
import pytest

from thinkblox.assets import CATALOGUE
from thinkblox.brief import Place
from thinkblox.knowledge.variety import varieties
from thinkblox.planning import plan_room, varied, with_forms, with_sizes, with_surfaces
from thinkblox.planning.space import furniture_area
from thinkblox.reading import GrammarBriefer, read_brief
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene

SEEDS = range(10)


def kinds(prompt, seed):
    return frozenset(request.category for request in varied(read_brief(prompt), seed).requests)


def test_a_mere_name_of_a_room_is_furnished_in_many_ways():
    assert len({kinds("A cosy living room", seed) for seed in SEEDS}) >= 6


@pytest.mark.parametrize("prompt", ["A cosy living room", "A bedroom", "A kitchen", "An office"])
def test_what_every_such_room_has_stays(prompt):
    from thinkblox.knowledge.rooms import room_type

    brief = read_brief(prompt)
    essential = {usual.category for usual in room_type(brief.room_type).expected}
    assert all(essential <= kinds(prompt, seed) for seed in SEEDS)


def test_what_a_sketch_names_stays_as_it_is_said_and_what_comes_besides_differs():
    read = read_brief("A bedroom with a double bed, two nightstands and a wardrobe")
    rooms = [varied(read, seed) for seed in SEEDS]
    assert all(set(read.requests) <= set(room.requests) for room in rooms)
    assert all(set(read.relations) <= set(room.relations) for room in rooms)
    assert not any(r.asked for room in rooms for r in set(room.requests) - set(read.requests))
    assert len({frozenset(request.category for request in room.requests) for room in rooms}) >= 8
    assert all(any("lamp" in request.category for request in room.requests) for room in rooms)


def test_who_names_many_gets_these_and_bare_walls_and_floors_are_dressed():
    read = read_brief("A bedroom with a bed, a desk, a chair, a wardrobe, a rug and a dresser")
    rooms = [varied(read, seed) for seed in SEEDS]
    assert all(furniture_area(room) == furniture_area(read) for room in rooms)
    came = set.union(*({r.category for r in room.requests} for room in rooms))
    assert {"picture"} <= came <= {*(request.category for request in read.requests), "picture"}


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("A bedroom with a king bed, a bench and a dresser with a mirror above it", "nightstand wardrobe rug"),
        ("A bedroom with a double bed, two nightstands and a lamp on each", "wardrobe rug picture"),
        ("A home office with two desks facing each other", "office_chair monitor keyboard"),
        ("A hotel room with two double beds", "nightstand wardrobe desk"),
        ("A studio apartment", "bed wardrobe fridge"),
    ],
)
def test_what_everybody_expects_of_a_room_is_there_although_some_things_are_arranged(prompt, expected):
    assert all(set(expected.split()) <= kinds(prompt, seed) for seed in SEEDS)


def test_a_kitchen_of_which_only_small_things_are_named_is_a_kitchen():
    prompt = "A kitchen for a small flat, with toaster, kettle, microwave and a folding table with two chairs"
    assert all(kinds(prompt, seed) >= {"base_cabinet", "sink", "hob", "fridge"} for seed in SEEDS)


def test_a_room_has_one_television():
    prompt = "Living room with a big TV on the wall, a brown leather couch in front of it and a coffee table in between"
    assert not any(kinds(prompt, seed) & {"tv", "tv_stand"} for seed in SEEDS)


def test_who_wants_only_some_things_has_no_others():
    read = read_brief("A bedroom with only a king bed, a bench and a dresser with a mirror above it")
    assert all(varied(read, seed) == read for seed in SEEDS)


def test_a_room_has_so_much_as_its_floor_is_for():
    from thinkblox.planning.space import least_area

    rooms = [varied(read_brief("A robotics lab with a workbench"), seed) for seed in SEEDS]
    assert np.mean([furniture_area(room) / least_area(room) for room in rooms]) > 0.7


def test_who_wants_little_gets_that():
    read = read_brief("A bedroom with only a bed and a wardrobe")
    assert all(varied(read, seed) == read for seed in SEEDS)
    needed = {"bed", "nightstand", "table_lamp", "floor_lamp", "wardrobe", "dresser"}
    assert all(kinds("A minimalist bedroom with a bed", seed) <= needed for seed in SEEDS)


def test_a_floor_that_is_given_is_not_filled_up():
    close, wide = (read_brief(f"A bedroom of {area} m2 with a bed and a wardrobe") for area in (9, 30))
    taken = furniture_area(close)
    assert taken > 1.3 * 9.0
    assert all(furniture_area(varied(close, seed)) == taken for seed in SEEDS)
    assert any(furniture_area(varied(wide, seed)) > taken for seed in SEEDS)


def test_what_comes_besides_has_what_it_belongs_to():
    for room, choices in varieties().rooms.items():
        things = [usual for option in choices.options for usual in option]
        things += [usual for need in choices.needs for option in need.options for usual in option]
        for usual in things:
            known = {usual.category, *(a for _, anchors, _ in usual.relations for a in anchors.split("|"))}
            assert known <= CATALOGUE.keys() | set(get_args(Place)), (room, known)


def test_what_is_named_stays():
    assert all("piano" in kinds("A living room with a piano", seed) for seed in SEEDS)


def test_what_is_not_wanted_does_not_come():
    assert not any("plant" in kinds("A living room without any plants", seed) for seed in SEEDS)


def test_named_alone_is_named_alone():
    brief = GrammarBriefer("named").brief("A cosy living room")
    assert all(varied(brief, seed) == brief for seed in SEEDS)


def test_relations_of_what_is_left_out_go_too():
    for seed in SEEDS:
        brief = varied(read_brief("A cosy living room"), seed)
        keys = {request.key for request in brief.requests}
        assert all(relation.subject in keys for relation in brief.relations)
        assert len(keys) == len(brief.requests)


def test_the_same_seed_gives_the_same():
    brief = read_brief("A dining room for six")
    once, again = (with_sizes(with_forms(varied(brief, 4), 4), 4) for _ in range(2))
    assert once == again


def round_tables(prompt):
    """How many of the rooms have a round table of which nobody said so."""
    rooms = [with_forms(varied(read_brief(prompt), seed), seed) for seed in SEEDS]
    return sum("round" in request.attributes for room in rooms for request in room.requests)


def test_a_table_that_is_only_assumed_is_round_in_some_rooms():
    assert 0 < round_tables("A dining room for six") < len(SEEDS)


@pytest.mark.parametrize(
    "prompt",
    [
        "A dining room with a dining table and six chairs",
        "A dining room for ten",
        "A dining room for six, 3 m by 4 m",
        "A study with a desk",
    ],
)
def test_a_table_that_is_named_or_too_large_or_in_a_given_room_has_its_usual_form(prompt):
    assert round_tables(prompt) == 0


def test_rooms_differ_in_size_and_openings():
    brief = read_brief("A home office with a desk and a chair")
    rooms = [plan_room(brief, rng=np.random.default_rng((seed, 0))) for seed in SEEDS]
    areas = [room.polygon.area for room in rooms]
    assert max(areas) > 1.1 * min(areas)
    assert len({opening.wall for room in rooms for opening in room.openings if opening.kind == "door"}) > 1
    assert len({opening.wall for room in rooms for opening in room.openings if opening.kind == "window"}) > 1


def test_a_size_that_is_given_is_kept():
    brief = read_brief("A bedroom, 4 m by 5 m, with a bed")
    assert {plan_room(brief, rng=np.random.default_rng((seed, 0))).extent for seed in SEEDS} == {(4.0, 5.0)}


def test_the_bench_measures_a_distance():
    from tests.bench.variety import distance

    one, other = Scene(room=rectangle(4.0, 3.0), seed=0), Scene(room=rectangle(8.0, 3.0), seed=0)
    assert distance(one, one).room == 0.0
    assert distance(one, other).room == pytest.approx(np.log(2.0) / 2)


def test_rough_rooms_are_not_papered_for_an_old_thing_in_them():
    brief = read_brief("A workshop where somebody restores old bicycles")
    surfaces = [with_surfaces(rectangle(4.0, 3.0), brief, seed).surfaces for seed in SEEDS]
    assert {each.floor.laying for each in surfaces if each is not None} == {"concrete"}


def test_beds_side_by_side_have_a_nightstand_between_them_and_nothing_at_the_foot_of_one():
    for seed in SEEDS:
        counts = {r.category: r.count for r in varied(read_brief("A guest bedroom with twin beds"), seed).requests}
        assert counts["nightstand"] == 1
        assert {"bench", "trunk_large"}.isdisjoint(counts)


@pytest.mark.parametrize(
    ("prompt", "others"),
    [
        ("A bedroom with a bed and a reading chair", {"rocking_chair"}),
        ("An office with a desk and three framed certificates", {"picture", "poster"}),
        ("A storage room with a bucket", {"mop_bucket"}),
        ("A living room with a sofa and three plants", {"tree_small"}),
    ],
)
def test_who_names_a_thing_gets_no_other_that_is_called_alike(prompt, others):
    assert all(kinds(prompt, seed).isdisjoint(others) for seed in SEEDS)


def test_who_names_a_shower_wants_no_bathtub_unless_it_is_named_too():
    assert all("bathtub" not in kinds("A guest bathroom with a shower", seed) for seed in SEEDS)
    assert {"bathtub", "shower_cabin"} <= kinds("A bathroom with a bathtub and a shower", 0)
