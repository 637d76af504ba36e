"""Rooms have what belongs together: seats at what one sits at, beds for who sleeps there, and a view from the sofa."""

import pytest

from thinkblox.assets import kind_of, make_asset
from thinkblox.knowledge.keepers import load_keepers
from thinkblox.knowledge.rooms import room_type
from thinkblox.planning import fitted, plan_brief, plan_room, relieved, varied, with_sizes
from thinkblox.reading import read_brief


def counts(prompt: str) -> dict[str, int]:
    found: dict[str, int] = {}
    for request in read_brief(prompt).requests:
        found[request.category] = found.get(request.category, 0) + request.count
    return found


def attributes(prompt: str, category: str) -> tuple[str, ...]:
    return next(r.attributes for r in read_brief(prompt).requests if r.category == category)


def ties(prompt: str) -> dict[str, list[tuple[str, tuple[str, ...]]]]:
    brief = read_brief(prompt)
    plan = plan_brief(brief, plan_room(brief, rng=1))
    return {target.id: [(tie.kind, tie.anchors) for tie in target.ties] for target in plan.targets}


@pytest.mark.parametrize(
    ("prompt", "seat", "number"),
    [
        ("A country kitchen with a big table for eight", "chair", 8),
        ("A classroom with 20 desks and chairs for the pupils", "chair", 20),
        ("An office with six desks and chairs", "chair", 6),
        ("A restaurant with ten tables and chairs and a bar", "chair", 40),
        ("A room for two children with two beds and two desks", "chair", 2),
        ("A CEO's office with a large desk, a meeting table with chairs and a sofa", "office_chair", 1),
        ("A restaurant with tables for four", "chair", 12),
        ("A canteen with long tables for thirty guests", "chair", 30),
        ("A hall with three long tables for thirty guests", "chair", 30),
        ("A playroom with low tables and small chairs", "child_chair", 8),
        ("A chemistry lab for 20 students with a fume hood", "stool", 20),
        ("A chemistry lab for 20 students with a demonstration bench", "stool", 20),
        ("A two-person home office with back-to-back desks and a printer", "office_chair", 2),
        ("A one-room flat with a dining table for two and a sofa", "chair", 2),
        ("A dining room for six with a high chair", "chair", 6),
        ("An art classroom with six tables, stools and a sink", "stool", 24),
        ("A home library with bookshelves and a desk", "bookcase", 5),
        ("A barbershop with four chairs, mirrors and a waiting bench", "mirror", 4),
        ("An open office with twelve desks, a printer, a plant and a meeting corner", "conference_table", 1),
        ("A dining room with a high chair and a rug", "chair", 4),
        ("A computer classroom for 16 students with a teacher's desk", "desk", 17),
        ("She needs a room with a bed and a desk", "office_chair", 1),
        ("A kitchen with a breakfast bar, three stools and a pantry cupboard", "base_cabinet", 3),
        ("A cafe with a counter, four tables for two and a bar with stools", "coffee_machine", 1),
        ("A barbershop with three chairs, mirrors, a bench, a cash desk and a coat rack", "cash_register", 1),
        ("A bookshop with a checkout, a till and an armchair", "cash_register", 1),
        ("A nail salon with four manicure tables", "chair", 8),
        ("A playroom with a tent", "play_tent", 1),
        ("A biology lab with four benches, microscopes and a sink", "lab_bench", 4),
        ("An office for six with a meeting table", "desk", 6),
        ("An office for six with a meeting table", "office_chair", 12),
        ("An office for six with a large table", "chair", 6),
    ],
)
def test_there_are_seats_for_what_one_sits_at(prompt, seat, number):
    assert counts(prompt)[seat] == number


@pytest.mark.parametrize(
    ("prompt", "category"),
    [
        ("A server room with two rows of five racks", "server_rack"),
        ("A storage room with three racks along the wall", "shelving_unit"),
        ("A server room with a shelving unit", "shelving_unit"),
        ("A hair salon with two dryers behind the chairs", "hair_dryer_chair"),
        ("A laundry room with a washer and a dryer", "dryer"),
        ("A sauna with a stove in the corner", "sauna_heater"),
        ("A kitchen with a stove", "stove"),
        ("A pottery studio with shelves full of drying pots and a sink", "pottery_piece"),
        ("A board room with a table", "conference_table"),
        ("A dining room with a buffet", "sideboard"),
        ("A buffet restaurant with a buffet", "counter"),
        ("A gym with a rack and a bench", "squat_rack"),
        ("A gym with a rack and a bench", "weight_bench"),
        ("A hair salon with two chairs in front of a mirror", "salon_chair"),
        ("A hallway with a spot for coats", "console_table"),
        ("A physiotherapy room with a treatment table", "massage_table"),
        ("A patio room with a picnic table and a cooler under it", "cooler"),
    ],
)
def test_a_word_means_what_such_a_room_has(prompt, category):
    assert category in counts(prompt)


def test_pupils_that_are_listed_have_desks():
    assert counts("A classroom with a teacher's desk, 24 pupils and a whiteboard")["school_desk"] == 24


def test_a_sofa_is_not_drawn_up_to_a_meeting_table():
    brief = read_brief("A CEO's office with a large desk, a meeting table with six chairs and a sofa")
    assert not any(relation.subject == "sofa" for relation in brief.relations)


@pytest.mark.parametrize(("prompt", "number"), [("students", 2), ("teenagers", 2), ("friends", 2), ("people", 1)])
def test_a_couple_shares_a_bed_and_students_do_not(prompt: str, number: int):
    assert counts(f"A bedroom for two {prompt}")["bed"] == number


@pytest.mark.parametrize(
    ("prompt", "goods"),
    [
        ("A bookshop with ten bookcases along the walls, a display table in the middle and a counter", "book_stack"),
        ("A shoe shop with two benches, a counter, a mirror on the wall and a display table", "shoes"),
    ],
)
def test_a_shop_has_goods_on_its_tables_and_a_till_on_its_counter(prompt: str, goods: str):
    brief = read_brief(prompt)
    on = {(r.subject.partition("-")[0], r.anchors) for r in brief.relations if r.kind == "on"}
    assert {(goods, ("display_table",)), ("cash_register", ("counter",))} <= on


def test_a_display_table_that_is_empty_stays_so():
    brief = read_brief("A shop with an empty display table and a counter with a lamp on it")
    assert not any("display_table" in r.anchors for r in brief.relations if r.kind == "on")


def test_people_who_are_named_after_things_are_those_of_the_room():
    office = counts("An office with desks and computers for five people")
    assert (office["desk"], office["computer"], office["office_chair"]) == (5, 5, 5)


@pytest.mark.parametrize("prompt", ["A room for two children", "A bedroom for two boys"])
def test_a_room_for_children_is_a_childrens_room(prompt):
    assert read_brief(prompt).room_type == "kids_room"


def test_children_and_those_who_share_a_room_have_single_beds():
    assert "single" in attributes("A girl's bedroom with a bed and a doll house", "bed")
    assert "single" in attributes("A hotel room with twin beds and a desk", "bed")
    assert "single" not in attributes("A bedroom with a bed and a wardrobe", "bed")
    assert "single" not in attributes("A bedroom with two king beds", "bed")


@pytest.mark.parametrize("prompt", ["A powder room, 1 m by 2 m", "A WC of 1.2 by 2 m", "A guest toilet, 1.2 by 2 m"])
def test_a_toilet_is_a_room(prompt):
    brief = read_brief(prompt)
    assert (brief.room_type, brief.depth) == ("toilet_room", 2.0)
    assert "bathtub" not in counts(prompt)


def test_a_toilet_is_a_thing_too():
    brief = read_brief("A bathroom with a WC and a shower")
    assert (brief.room_type, counts(brief.prompt)["toilet"]) == ("bathroom", 1)


def test_a_kitchenette_is_a_room_or_a_thing():
    assert read_brief("A kitchenette with a fridge and a table for two").room_type == "kitchenette"
    brief = read_brief("A studio flat with a kitchenette, a bed and a sofa")
    assert brief.room_type == "studio"
    assert not brief.unknown
    assert "kitchenette" in counts(brief.prompt)


def test_booths_have_tables_of_their_own():
    found = counts("A diner with six booths")
    assert (found["booth"], "dining_table" in found) == (6, False)
    tops = [s for s in make_asset("booth", seed=0).surfaces if s.position[2] > 0.7]
    assert len(tops) == 1


def test_every_basin_has_a_mirror():
    assert counts("A bathroom with two sinks and a bathtub")["mirror"] == 2
    assert counts("A bathroom with a double vanity")["mirror"] == 1


def test_a_case_is_empty_for_what_is_asked_to_be_in_it():
    brief = read_brief("A museum room with a display case and a vase in the display case")
    plan = plan_brief(brief, plan_room(brief, rng=1))
    assert "empty" in next(t.attributes for t in plan.targets if t.category == "display_case")


def test_no_table_to_eat_at_claims_the_middle_before_a_screen():
    found = ties("A living room with a sofa, a TV and a dining table for six")
    assert ("in_centre", ("centre",)) not in found["dining_table_1"]
    order = list(found)
    assert order.index("tv_stand_1") < order.index("dining_table_1")
    assert ("in_centre", ("centre",)) in ties("A dining room for six")["dining_table_1"]


def test_a_second_sofa_joins_the_low_table():
    found = ties("A living room with two sofas, a coffee table and a television")
    assert found["sofa_2"] == [("next_to", ("coffee_table_1",))]
    assert list(found).index("tv_stand_1") < list(found).index("sofa_2")


def test_what_has_no_room_in_a_room_of_a_given_size_is_left_out_and_said():
    brief = read_brief("A bedroom, 2.4 by 2.6 m")
    less = fitted(brief)
    assert {r.category for r in less.requests} < {r.category for r in brief.requests}
    assert any(r.category == "bed" for r in less.requests)
    assert set(less.left_out) <= set(plan_brief(less, plan_room(less, rng=1)).notes)


def test_a_shower_does_where_a_bathtub_has_no_room():
    brief = read_brief("A bathroom of 2 by 2.2 m")
    while (less := relieved(brief)) is not None and "bathtub" in {r.category for r in brief.requests}:
        brief = less
    assert "shower_cabin" in {r.category for r in brief.requests}


def test_what_is_named_and_what_it_needs_stays():
    brief = read_brief("A living room, 2 by 3 m, with a sofa, a TV, a dining table and four chairs")
    assert {r.category for r in brief.requests} == {r.category for r in fitted(brief).requests}


def test_open_rooms_leave_nothing_out():
    brief = read_brief("A bathroom")
    assert fitted(brief) == brief
    assert room_type("bathroom").instead["bathtub"] == "shower_cabin"


def test_furniture_is_as_large_as_the_seed_has_it():
    brief = read_brief("A living room with a sofa, a bookcase and two armchairs")
    sizes = {with_sizes(brief, seed).request("sofa").drawn for seed in range(6)}
    assert len(sizes) == 6
    assert with_sizes(brief, 3) == with_sizes(brief, 3)


def test_a_size_that_is_asked_for_is_kept():
    brief = with_sizes(read_brief("A room with a table, 2 m long"), 5)
    plan = plan_brief(brief, plan_room(brief, rng=1))
    assert 2.0 in next(t.size for t in plan.targets if "table" in t.category)


def test_in_a_room_of_a_given_size_furniture_is_hardly_larger_than_usual():
    sized, free = (with_sizes(read_brief(p), 2) for p in ("A bedroom, 3 m by 3 m", "A bedroom"))
    wide = [b.request("wardrobe").drawn[1] or 0.0 for b in (sized, free)]
    assert wide[0] <= wide[1]


def test_every_size_that_is_drawn_can_be_made() -> None:
    brief = read_brief("A bathroom with a toilet, a bathtub, a bidet, a stool, a sofa, a desk and a wardrobe")
    for seed in range(60):
        for request in with_sizes(brief, seed).requests:
            least, most = kind_of(request.category).size_range
            told = zip(least, request.drawn, most, strict=True)
            assert all(low <= side <= high for low, side, high in told if side is not None), (seed, request)


@pytest.mark.parametrize(
    ("prompt", "keepers"),
    [
        ("A hallway with a place for shoes, umbrellas and coats", {"shoe_rack", "umbrella_stand", "coat_rack"}),
        ("A bedroom with somewhere to put her books and a bed", {"bookcase", "bed"}),
        ("A hallway with a bench and a spot for my umbrellas", {"bench", "umbrella_stand"}),
    ],
)
def test_a_place_for_things_is_what_they_are_kept_in(prompt, keepers):
    assert {request.category for request in read_brief(prompt).requests if request.asked} == keepers


def test_what_is_named_for_itself_is_not_kept():
    assert counts("A hallway with three umbrellas and a coat rack")["umbrella"] == 3


def test_every_keeper_can_be_made():
    assert all(kind_of(keeper).mount == "floor" or keeper == "towel_rail" for keeper in load_keepers().keepers.values())


def test_a_sofa_bed_is_a_bed_and_a_crowd_brings_nothing_of_its_own():
    assert "bed" not in counts("A studio with a sofa bed and a dining table for two")
    assert "backpack" not in counts("A chemistry lab for 20 students")


@pytest.mark.parametrize(
    "prompt",
    [
        "A lounge with a sofa, a TV stand, two bookcases, an armchair, a clock and a plant",
        "A flat with a bed, a kitchen table with two chairs, a sofa, a TV stand and a wardrobe",
    ],
)
def test_a_stand_has_its_screen_and_a_sofa_its_table(prompt: str):
    for seed in range(4):
        there = {r.category for r in varied(read_brief(prompt), seed).requests}
        assert {"tv", "coffee_table"} <= there


def test_what_a_room_may_hold_is_no_second_of_what_it_has():
    for prompt, other in (
        ("A living room with a grand piano and two armchairs", "piano"),
        ("A photo studio with a backdrop and two softboxes", "studio_light"),
    ):
        brief = read_brief(prompt)
        assert not any(other == r.category for seed in range(12) for r in varied(brief, seed).requests)
