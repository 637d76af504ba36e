"""What people say of rooms that exist: told by what is wrong with a thing, by rows, ends, corners and the others."""

import math

import pytest
from msgspec import structs

from tests.edited_rooms import OPENINGS, bedroom, built, dining, living, room
from tests.test_editing_guard import classroom, done
from thinkblox import Scene, edit_room
from thinkblox.assets.source import ProceduralAssets
from thinkblox.editing.reading import read_instruction
from thinkblox.errors import InputError
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.relations import measure
from thinkblox.scene.room import Opening, rectangle
from thinkblox.scene.support import placed_at

pytestmark = pytest.mark.slow


def gap(scene: Scene, one: str, other: str) -> float:
    return ground_gap(things(scene, one)[0], things(scene, other)[0])


def row(number: int) -> list[str]:
    """Desks and chairs of a row of the classroom."""
    return [f"{kind}_{3 * number + n}" for kind in ("school_desk", "chair") for n in (-2, -1, 0)]


def test_stand_it_there_is_an_order_of_its_own() -> None:
    before = built(room(), ("stool_1", 1.5, 2.5, 0.0, "floor"), ("stool_2", 2.1, 2.5, 0.0, "floor"))
    after = done(before, "Remove stool 1 and stand stool 2 there").scene
    assert [p.id for p in after.placements] == ["stool_2"]
    assert math.dist(after["stool_2"].position, before["stool_1"].position) < 0.3
    with pytest.raises(InputError, match="begins another order"):
        read_instruction("Remove stool_1 and stand stools there")


def test_what_is_too_near_or_too_far_says_from_what_and_to_what() -> None:
    for text, nearer in (
        ("The armchair is too far from the sofa, bring it closer", True),
        ("The armchair is too close to the sofa, so move it away a bit", False),
    ):
        (order,) = read_instruction(text).orders
        assert [(near, phrase.noun.value) for near, phrase in order.closer] == [(nearer, "sofa")], text
        assert order.slight == ("a bit" in text)
    before = living()
    after = done(before, "The armchair is too far from the desk, bring it closer").scene
    assert gap(after, "armchair_1", "desk_1") < gap(before, "armchair_1", "desk_1") - 0.1
    assert read_instruction("The rug is too small, get a bigger one").orders[0].doing == "replace"


def test_rows_are_told_by_two_numbers() -> None:
    before = classroom()
    wide = done(before, "Make the aisle between the first and second row 20 cm wider").scene
    now, then = (gap(scene, "school_desk_1", "chair_1") for scene in (wide, before))
    assert now == pytest.approx(then, abs=0.02)
    moved = [id for id in row(1) + row(2) if wide[id] != before[id]]
    assert sorted(moved) in (sorted(row(1)), sorted(row(2)))
    assert gap(wide, "chair_1", "school_desk_4") == pytest.approx(
        gap(before, "chair_1", "school_desk_4") + 0.2, abs=0.02
    )
    after = done(before, "Swap the front and back rows").scene
    assert {round(after[id].position[0], 1) for id in row(1)[:3]} == {round(before["school_desk_4"].position[0], 1)}


def test_a_row_goes_back_with_those_in_the_way_first() -> None:
    before = classroom()
    after = done(before, "Move the last row 15 cm back").scene
    assert all(before[id].position[0] - after[id].position[0] == pytest.approx(0.15, abs=0.01) for id in row(2))


def test_the_end_of_a_sideboard_is_on_it_and_the_other_end_too() -> None:
    vases = [("vase_1", 5.7, 2.4, 180.0, "sideboard_1"), ("vase_2", 5.7, 2.6, 180.0, "sideboard_1")]
    before = built(room(), ("sideboard_1", 5.7, 2.5, 180.0, "floor"), *vases)
    after = done(before, "Move vase 1 to the left end of the sideboard and vase 2 to the right end").scene
    assert [after[id].support for id in ("vase_1", "vase_2")] == ["sideboard_1"] * 2
    left = [after["sideboard_1"].to_local(after[id].position[:2])[1] for id in ("vase_1", "vase_2")]
    assert left[0] > 0.1 > -0.1 > left[1]


def test_opposite_corners_are_those_farthest_apart() -> None:
    before = built(room(), ("stool_1", 1.5, 2.5, 0.0, "floor"), ("stool_2", 2.1, 2.5, 0.0, "floor"))
    after = done(before, "Put the stools in opposite corners").scene
    assert math.dist(after["stool_1"].position, after["stool_2"].position) > 6.0


def test_halfway_and_centred_are_at_the_middle() -> None:
    before = living()
    after = done(before, "Put the armchair halfway between the sideboard and the desk").scene
    middle = (before["sideboard_1"].position[0] + before["desk_1"].position[0]) / 2
    assert after["armchair_1"].position[0] == pytest.approx(middle, abs=0.11)
    after = done(bedroom(), "Centre the wardrobe in front of the bed").scene
    assert after["wardrobe_1"].position[0] == pytest.approx(bedroom()["bed_1"].position[0], abs=0.11)


def test_along_two_walls_is_at_either() -> None:
    before = built(room(), *((f"desk_{n}", 0.6 + 1.5 * n, 2.5, 90.0, "floor") for n in (1, 2, 3)))
    after = done(before, "Line up all desks along the north and east wall").scene
    walls = ("north_wall", "east_wall")
    assert all(any(measure(after, "against_wall", f"desk_{n}", (w,)).holds for w in walls) for n in (1, 2, 3))


def test_the_remaining_ones_are_those_that_were_not_spoken_of() -> None:
    before = dining(4)
    after = done(before, "Take away two chairs and move the remaining ones 10 cm to the south").scene
    left = [p.id for p in after.placements if p.category == "chair"]
    assert len(left) == 2
    assert all(before[id].position[1] - after[id].position[1] == pytest.approx(0.1, abs=0.01) for id in left)


def test_where_the_bigger_one_stood_is_of_those_that_were_named() -> None:
    before = living()
    after = done(before, "Remove the armchair and the desk and put a stool where the bigger one stood").scene
    new = next(p for p in after.placements if p.id not in before)
    assert math.dist(new.position[:2], before["desk_1"].position[:2]) < 0.8


def test_a_lamp_on_each_new_table_and_a_table_beside_what_was_named() -> None:
    (order,) = read_instruction("Add a side table on each side of the sofa, with a lamp on each").orders
    assert [where.word for where in order.things[0].places] == ["on", "with"]
    before = living()
    after = done(before, "Have the armchair face the desk and put a stool with a pillow beside it").scene
    stool = next(p.id for p in after.placements if p.category == "stool")
    assert gap(after, stool, "armchair_1") < 0.6


def test_what_rests_on_one_of_two_that_change_places_goes_with_it() -> None:
    before = built(
        room(),
        ("sideboard_1", 5.7, 2.5, 180.0, "floor"),
        ("vase_1", 5.7, 2.5, 180.0, "sideboard_1"),
        ("bookcase_1", 0.2, 2.5, 0.0, "floor"),
    )
    after = done(before, "Swap the sideboard and the vase with the bookcase").scene
    assert after["vase_1"].support == "sideboard_1"
    assert after["sideboard_1"].position[0] < 1.0 < 5.0 < after["bookcase_1"].position[0]


def test_a_shorter_wardrobe_is_a_lower_one() -> None:
    before = bedroom()
    after = done(before, "Make the wardrobe 20 cm shorter").scene
    assert after["wardrobe_1"].size[2] == pytest.approx(before["wardrobe_1"].size[2] - 0.2, abs=0.01)
    assert done(before, "Make the bed 10 cm shorter").scene["bed_1"].size[2] == before["bed_1"].size[2]


def test_twenty_centimetres_wider_is_by_so_much() -> None:
    before = living()
    after = edit_room(before, "Make the aisle between the sofa and the coffee table 10 cm wider").scene
    assert gap(after, "coffee_table_1", "sofa_1") == pytest.approx(
        gap(before, "coffee_table_1", "sofa_1") + 0.1, abs=0.02
    )


def test_what_faces_a_thing_is_so_far_from_that() -> None:
    (order,) = read_instruction("Move the armchair so that it faces the desk and is 2 m away from it").orders
    assert [(away, phrase.noun.value) for away, phrase in order.apart] == [(2.0, "desk")]


def test_seats_that_are_in_the_way_go_along_with_their_table_and_others_are_told_of() -> None:
    rows = [("dining_table_1", 3.0, 2.5, 90.0, "floor")]
    rows += [(f"chair_{n}", 2.6 + 0.8 * (n % 2), 1.75 if n < 3 else 3.25, 90.0 if n < 3 else 270.0, "floor")
             for n in (1, 2, 3, 4)]  # fmt: skip
    before = built(room(), *rows)
    seats = [f"chair_{n}" for n in (1, 2, 3, 4)]
    for said in ("Move the dining table 60 cm to the north", "Rotate the dining table by 15 degrees"):
        result = done(before, said)
        assert all(measure(result.scene, "at", id, ("dining_table_1",)).holds for id in seats), said
        assert any("went along, as dining_table_1" in note for note in result.report.notes), said
    result = done(dining(2), "Move the dining table 80 cm to the north")
    assert any("chair_1, chair_2 stayed, away from dining_table_1" in note for note in result.report.notes)
    assert result.scene["chair_1"] == dining(2)["chair_1"]
    kept = edit_room(before, "Move the dining table 60 cm to the north but don't touch the chairs")
    assert all(kept.scene[id] == before[id] for id in seats)


def test_another_row_is_like_the_last_and_as_far_from_it() -> None:
    rows: list[tuple[str, float, float, float, str]] = []
    for number, (x, y) in enumerate(((5.9, 2.0), (5.9, 3.2), (4.3, 2.0), (4.3, 3.2))):
        rows += [
            (f"school_desk_{number + 1}", x, y, 180.0, "floor"),
            (f"chair_{number + 1}", x - 0.45, y, 0.0, "floor"),
        ]
    before = built(room(7.0, 5.0), *rows)
    after = done(before, "Add another row of desks with chairs at the back").scene
    new = [p for p in after.placements if p.id not in before]
    assert sorted(p.category for p in new) == ["chair", "chair", "school_desk", "school_desk"]
    assert {round(p.position[0], 2) for p in new} == {2.7, 2.25}
    behind = edit_room(before, "Add four more rows of desks behind the last row")
    assert any("another row was not added" in text for text in behind.failed)
    with pytest.raises(InputError, match="nothing stands in rows"):
        edit_room(living(), "Add another row of chairs")


def test_the_pupils_desks_are_all_but_the_teachers() -> None:
    before = classroom()
    after = done(before, "Put a laptop on each pupil's desk").scene
    assert {p.support for p in after.placements if p.category == "laptop"} == {f"school_desk_{n}" for n in range(1, 7)}


def test_what_is_spread_evenly_is_far_from_each_other() -> None:
    stools = [
        ("stool_1", 1.5, 2.5, 0.0, "floor"),
        ("stool_2", 2.1, 2.5, 0.0, "floor"),
        ("stool_3", 1.8, 3.1, 0.0, "floor"),
    ]
    before = built(room(), *stools)
    for said, least in (
        ("Spread the stools evenly around the room", 2.0),
        ("Space the stools evenly along the east wall", 1.4),
    ):
        after = done(before, said).scene
        spots = [after[id].position[:2] for id, *_ in stools]
        assert min(math.dist(a, b) for a in spots for b in spots if a != b) > least, said
    assert all(x > 5.5 for x, _ in spots)
    pictures = [(f"picture_{n}", 2.0 + n, 4.984, 270.0, "wall") for n in (1, 2)]
    after = done(built(room(), *pictures), "Spread the pictures evenly along the north wall").scene
    assert all(not 3.6 - 0.38 < after[id].position[0] < 5.2 + 0.38 for id, *_ in pictures)
    assert edit_room(before, "Spread the stools out a bit").complete


def test_what_is_announced_before_a_colon_is_what_follows() -> None:
    before = bedroom()
    after = done(before, "I'd like more light: add a floor lamp").scene
    assert len(after.placements) == len(before.placements) + 1
    assert [
        o.doing for o in read_instruction("Two changes: remove the rug, and turn the bed by 45 degrees").orders
    ] == [
        "remove",
        "turn",
    ]
    assert len(read_instruction("Remove the bed: put a stool by the door").orders) == 2


def test_what_alone_is_to_stay_on_a_thing_says_nothing_of_the_rest_of_the_room() -> None:
    small = [("bowl_1", 3.0, 2.5, 0.0, "dining_table_1"), ("vase_1", 3.4, 2.5, 0.0, "dining_table_1")]
    before = built(room(), ("dining_table_1", 3.0, 2.5, 90.0, "floor"), ("sofa_1", 3.0, 0.6, 90.0, "floor"), *small)
    for said in (
        "Clear the dining table: only the bowl should stay",
        "Only a bowl should stay on the dining table",
        "Keep only the bowl on the dining table",
    ):
        after = done(before, said).scene
        assert {p.id for p in after.placements} == {"dining_table_1", "sofa_1", "bowl_1"}, said


def test_what_is_no_name_of_a_thing_is_not_added() -> None:
    with pytest.raises(InputError, match="how large 'big enough' is is not said"):
        edit_room(dining(2), "Add a cabinet by the table that is big enough for the plates")


def test_a_things_own_is_that_at_it() -> None:
    before = bedroom()
    after = done(before, "Move the left nightstand's lamp 5 cm to the left").scene
    moved = [p.id for p in before.placements if after[p.id] != p]
    assert moved == ["table_lamp_1"]
    assert whose_desk("Remove the teacher's desk") == "desk"


def whose_desk(text: str) -> str:
    return read_instruction(text).orders[0].things[0].noun.value


def test_each_that_has_none_gets_one() -> None:
    desks = [("desk_1", 2.6, 0.5, 90.0, "floor"), ("desk_2", 4.6, 0.5, 90.0, "floor")]
    before = built(room(), *desks, ("chair_1", 4.6, 1.1, 270.0, "floor"))
    after = done(before, "Put a chair at every desk that has none").scene
    new = [p.id for p in after.placements if p.id not in before]
    assert len(new) == 1
    assert measure(after, "at", new[0], ("desk_1",)).holds


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ("Turn the armchairs so they look at each other", ("turn", "facing")),
        ("Push the sofa back until it touches the wall", ("move", "")),
        ("Seat only six people at the table", ("ensure", "")),
    ],
)
def test_other_words_for_the_same(said: str, words: tuple[str, str]) -> None:
    (order,) = read_instruction(said).orders
    assert (order.doing, order.mutual) == words
    assert not read_instruction(said).unknown


def test_away_is_more_than_a_hair() -> None:
    before = built(room(), ("stool_1", 5.75, 4.75, 0.0, "floor"))
    result = edit_room(before, "Move the stool away from the window")
    assert not result.complete or math.dist(result.scene["stool_1"].position, before["stool_1"].position) >= 0.1


def test_what_is_taken_down_or_out_of_a_corner() -> None:
    (order, other) = read_instruction("Take the lamp and the vase away, the bowl can stay").orders
    assert (order.doing, len(order.things), other.doing) == ("remove", 2, "keep")
    (order, other) = read_instruction(
        "Take plant_1 and plant_2 away, plant_3 can stay", ["plant_1", "plant_2", "plant_3"]
    ).orders
    assert ([p.id for p in order.things], [p.id for p in other.things]) == (["plant_1", "plant_2"], ["plant_3"])
    assert read_instruction("Take the picture down").orders[0].doing == "remove"
    before = built(room(), ("stool_1", 5.75, 4.75, 0.0, "floor"))
    for said in ("Get the stool out of the corner", "Take the stool out of the corner"):
        after = done(before, said).scene
        assert not measure(after, "in_corner", "stool_1", ("corner",)).holds, said


def test_a_back_that_comes_to_be_against_a_wall_is_at_it_also_where_it_turns() -> None:
    before = bedroom()
    after = done(before, "Turn the wardrobe so its back is against the south wall").scene
    assert measure(after, "against_wall", "wardrobe_1", ("south_wall",)).holds


def test_a_sixth_one_is_another_and_what_hangs_from_the_ceiling_is_hung_there() -> None:
    before = dining(2)
    after = done(before, "Add a third chair like the others").scene
    assert [p.category for p in after.placements].count("chair") == 3
    after = done(before, "Hang a chandelier").scene
    assert next(p for p in after.placements if p.category == "chandelier").support == "ceiling"


def test_a_row_goes_to_its_left_as_one() -> None:
    before = classroom()
    after = done(before, "Move the last row 10 cm to the left").scene
    off = {id: round(after[id].position[1] - before[id].position[1], 2) for id in row(2)}
    assert set(off.values()) in ({0.1}, {-0.1})


def test_what_is_excepted_stays_where_the_rest_is_rearranged() -> None:
    before = bedroom()
    for said in ("Rearrange the room except the bed", "Rearrange everything but the bed"):
        result = edit_room(before, said)
        assert result.scene["bed_1"] == before["bed_1"], said
        assert any(change.id != "bed_1" for change in result.changes), said


def test_so_many_at_each_side_are_taken_away() -> None:
    rows = [("dining_table_1", 3.0, 2.5, 90.0, "floor")]
    rows += [(f"chair_{n}", 2.6 + 0.8 * (n % 2), 1.75 if n < 3 else 3.25, 90.0 if n < 3 else 270.0, "floor")
             for n in (1, 2, 3, 4)]  # fmt: skip
    before = built(room(), *rows)
    after = done(before, "Remove one chair on each side of the table").scene
    left = [p.position[1] for p in after.placements if p.category == "chair"]
    assert sorted(y > 2.5 for y in left) == [False, True]
    after = done(before, "Pull out the chairs on the north side of the table by 15 cm").scene
    assert [round(after[f"chair_{n}"].position[1] - before[f"chair_{n}"].position[1], 2) for n in (1, 2, 3, 4)] == [
        0,
        0,
        0.15,
        0.15,
    ]


def test_a_red_one_and_a_blue_one_are_the_two() -> None:
    before = living()
    after = done(before, "Add two pillows to the sofa, a red one and a blue one").scene
    new = [p for p in after.placements if p.id not in before]
    assert [after.asset_of(p).attributes for p in new] == [("red",), ("blue",)]


def test_what_is_not_wanted_somewhere_is_what_goes_elsewhere() -> None:
    (order,) = read_instruction("I don't want the vase next to the plant, move it to the desk").orders
    assert (order.doing, order.things[0].noun.value) == ("move", "vase")
    (order,) = read_instruction(
        "Move desk_1 next to desk_2 so that they stand side by side", ["desk_1", "desk_2"]
    ).orders
    assert order.abreast
    assert not order.mutual


def test_two_that_are_to_be_larger_and_smaller_are_both_made_so() -> None:
    before = bedroom()
    after = done(before, "Give me a bigger wardrobe and a smaller bed").scene
    assert after["wardrobe_1"].size[1] > before["wardrobe_1"].size[1]
    assert after["bed_1"].size[1] < before["bed_1"].size[1]


def test_another_that_is_fetched_is_added_and_both_are_meant_then() -> None:
    before = living()
    after = done(before, "Get a second armchair and move both 10 cm to the south").scene
    assert "armchair_2" in after
    assert after["armchair_1"] != before["armchair_1"]


@pytest.mark.parametrize(
    "said", ["Remove the nightstand that is further from the door", "Remove the nightstand farther from the door"]
)
def test_the_further_of_two_is_told(said: str) -> None:
    before = bedroom()
    gaps = {id: gap(before, id, "door") for id in ("nightstand_1", "nightstand_2")}
    assert max(gaps, key=lambda id: gaps[id]) not in edit_room(before, said).scene


def test_beside_the_head_of_a_bed_is_at_that_end() -> None:
    before = bedroom()
    after = done(before, "Turn the bed around and put the nightstands beside its head").scene
    bed = after["bed_1"]
    assert all(bed.to_local(after[id].position[:2])[0] < 0.0 for id in ("nightstand_1", "nightstand_2"))


def test_more_chairs_come_to_the_table_of_the_others() -> None:
    after = done(dining(2), "Add two more chairs").scene
    assert all(measure(after, "at", p.id, ("dining_table_1",)).holds for p in after.placements if p.category == "chair")


def test_to_the_left_and_right_is_on_both_sides() -> None:
    before = bedroom()
    after = done(before, "Put a lamp to the left and right of the wardrobe").scene
    new = [p for p in after.placements if p.id not in before]
    assert [p.support for p in new] == ["floor", "floor"]


def test_the_north_side_of_a_table_is_where_seats_of_it_are() -> None:
    rows = [("dining_table_1", 3.0, 2.5, 90.0, "floor")]
    rows += [(f"chair_{n}", 2.6 + 0.8 * (n % 2), 1.75 if n < 3 else 3.25, 90.0 if n < 3 else 270.0, "floor")
             for n in (1, 2, 3, 4)]  # fmt: skip
    after = done(built(room(), *rows), "Remove the chairs on the north side and put a bench there").scene
    assert {"chair_1", "chair_2"} == {p.id for p in after.placements if p.category == "chair"}
    assert next(p for p in after.placements if p.category == "bench").position[1] > 3.0


def test_every_corner_but_one_is_told_by_what_is_beside_it() -> None:
    before = built(room(), ("stool_1", 3.0, 2.5, 0.0, "floor"))
    after = edit_room(before, "Put a plant in every corner except the one by the door").scene
    plants = [p for p in after.placements if p.category == "plant"]
    assert len(plants) == 3
    assert not any(p.position[0] < 1.5 and p.position[1] < 1.5 for p in plants)


def test_what_gets_more_room_stays_at_its_wall() -> None:
    before = bedroom()
    after = done(before, "I need more space between the bed and the wardrobe").scene
    moved = [p.id for p in before.placements if after[p.id] != p and p.support == "floor"]
    assert all(after[id].yaw == before[id].yaw for id in moved)
    assert gap(after, "bed_1", "wardrobe_1") > gap(before, "bed_1", "wardrobe_1")


def test_a_row_goes_to_the_wall_behind_it_as_it_stands() -> None:
    rows = [(f"school_desk_{n}", 4.0 - 1.2 * (n > 2), 2.0 + 1.2 * (n % 2), 180.0, "floor") for n in (1, 2, 3, 4)]
    before = built(room(), *rows)
    after = done(before, "Move the last row to the back wall").scene
    assert all(after[f"school_desk_{n}"].yaw == 180.0 for n in (3, 4))
    assert all(gap(after, f"school_desk_{n}", "west_wall") < 0.1 for n in (3, 4))


def test_it_is_no_wall_where_a_thing_was_named_before() -> None:
    (order,) = read_instruction("Put a lamp on the desk and a picture on the wall above it").orders
    assert [(w.word, w.noun.value) for w in order.things[1].places if w.noun] == [("on", "wall"), ("above", "desk")]


@pytest.mark.parametrize("said", ["remove the rest", "get rid of the others"])
def test_the_rest_of_so_many_that_stay_is_of_their_kind(said: str) -> None:
    after = done(dining(4), f"Keep two chairs and {said}").scene
    assert sorted(p.category for p in after.placements) == ["chair", "chair", "dining_table"]


def test_all_the_rows_and_the_middle_one_are_told_and_turn_with_their_seats() -> None:
    before = classroom()
    assert len(edit_room(before, "Remove the rows").changes) == 12
    result = edit_room(before, "Turn the last row around")
    there = [id for id in row(2) if result.scene[id].yaw != before[id].yaw]
    assert {id.replace("school_desk", "chair") for id in there} == {id for id in there if id.startswith("chair")}
    with pytest.raises(InputError, match="none is in the middle"):
        edit_room(before, "Remove the middle row")


def test_two_lengths_are_the_size_of_what_is_new() -> None:
    for said in (
        "Add a blue rug of 1 m by 1.5 m in front of the wardrobe",
        "Put a rug, 1 m x 1.5 m, in front of the bed",
    ):
        (order,) = read_instruction(said).orders
        size = order.things[0].noun.size
        assert size is not None
        assert [length.metres for length in size.lengths] == [1.0, 1.5]
        assert (order.lengths, order.apart) == ([], [])


def test_towards_the_one_on_the_right() -> None:
    (order,) = read_instruction("Turn the TV towards the armchair on the right").orders
    assert [noun.side for noun in order.facing] == ["right"]


def with_lamps() -> Scene:
    """The classroom with a table lamp on each school desk."""
    rooms = classroom()
    desks = [p for p in rooms.placements if p.category == "school_desk"]
    asset = ProceduralAssets().make("desk_lamp", seed=3)
    for desk in desks:
        top = max(s.position[2] for s in rooms.asset_of(desk).surfaces)
        id = desk.id.replace("school_desk", "desk_lamp")
        spot = (desk.position[0], desk.position[1], top)
        lamp = placed_at(rooms, asset, id=id, position=spot, yaw=180.0)
        rooms = rooms.with_placement(lamp, asset)
    return rooms


def test_what_rests_on_things_is_in_their_row() -> None:
    before = with_lamps()
    for rest in ("", " but keep them in the back row"):
        said = f"Remove the desk lamps from the front row{rest}"
        gone = {c.id for c in done(before, said).changes}
        assert gone == {"desk_lamp_1", "desk_lamp_2", "desk_lamp_3"}, said


def test_those_of_what_was_named_are_told_by_row_or_place() -> None:
    before = classroom()
    said = "Move all school desks 10 cm to the west, except those in the front row"
    assert {id for id in row(2) if id.startswith("school")} <= {c.id for c in done(before, said).changes}
    assert "school_desk_1" not in {c.id for c in done(before, said).changes}
    rooms = built(room(), ("bookcase_1", 5.7, 1.5, 180.0, "floor"),
                  ("bookcase_2", 5.7, 4.0, 180.0, "floor"), ("stool_1", 5.0, 1.4, 0.0, "floor"))  # fmt: skip
    white = done(rooms, "Make the bookcases white, but leave the one closest to the stool as it is")
    assert [c.id for c in white.changes] == ["bookcase_2"]


def test_the_other_one_is_another_of_what_was_named_with_the_place() -> None:
    before = built(room(), ("sideboard_1", 0.4, 2.0, 0.0, "floor"), ("sideboard_2", 5.6, 2.0, 180.0, "floor"),
                   ("vase_1", 0.4, 2.0, 0.0, "sideboard_1"))  # fmt: skip
    for said in (
        "Take the vase off the sideboard and put it on the other one",
        "Put the vase on the other sideboard",
    ):
        assert done(before, said).scene["vase_1"].support == "sideboard_2", said
    gone = done(before, "Don't remove the sideboard with the vase on it, only the other one").changes
    assert [c.id for c in gone] == ["sideboard_2"]


def test_only_what_is_named_last_goes_where_something_is_not_to_go() -> None:
    gone = done(living(), "Don't remove the sofa, only the armchair").changes
    assert [(c.id, c.what) for c in gone] == [("armchair_1", "removed")]


def test_chairs_around_it_stay_around_what_the_sentence_before_changes() -> None:
    after = done(dining(), "Make the dining table black and keep the chairs around it")
    assert [c.id for c in after.changes] == ["dining_table_1"]


def test_a_look_that_is_ruled_out_is_not_taken_for_one_that_is_wanted() -> None:
    table = done(dining(0), "Make the dining table square, not round, and 1.2 m wide").scene
    asset = table.asset_of(table["dining_table_1"])
    assert "square" in asset.attributes
    assert "round" not in asset.attributes
    assert asset.size[:2] == pytest.approx((1.2, 1.2), abs=0.01)
    with pytest.raises(InputError, match="names no size, colour"):
        edit_room(living(), "Make the sofa not red")


def test_what_stands_in_a_corner_is_no_neighbour_of_it_and_a_lamp_there_stands_on_the_floor() -> None:
    before = built(room(), ("plant_1", 5.65, 4.65, 0.0, "floor"), ("bookcase_1", 5.7, 3.6, 180.0, "floor"))
    after = done(before, "Get rid of whatever is standing in the north-east corner and put a reading lamp there").scene
    assert sorted(p.id for p in after.placements) == ["bookcase_1", "floor_lamp_1"]
    assert [c.id for c in done(before, "Remove what stands in the north-east corner").changes] == ["plant_1"]


def test_everything_that_is_there() -> None:
    after = done(living(), "Put everything that's on the coffee table onto the sideboard instead").scene
    assert after["vase_1"].support == "sideboard_1"


def test_more_of_the_chairs_at_a_table_go_to_it_or_nowhere() -> None:
    for said in ("Add two more matching chairs", "I'd like seating for four at the table: add two more chairs"):
        after = done(dining(), said).scene
        assert all(measure(after, "at", f"chair_{n}", ("dining_table_1",)).holds for n in (3, 4)), said
    rows = [("side_table_1", 0.5, 0.5, 0.0, "floor"), ("dining_table_1", 5.0, 4.0, 90.0, "floor")]
    crowded = built(room(), *rows, ("chair_1", 5.0, 3.2, 90.0, "floor"), ("bookcase_1", 3.6, 4.0, 0.0, "floor"))
    edit = edit_room(crowded, "Add nine more matching chairs")
    new = [c.id for c in edit.changes]
    assert edit.failed
    assert all(measure(edit.scene, "at", id, ("dining_table_1",)).holds for id in new)


def test_the_place_of_an_announcement_is_where_the_thing_goes() -> None:
    (order,) = read_instruction("I need more storage in the corner by the window: add a bookcase").orders
    assert [(w.word, w.noun.value) for w in order.things[0].places if w.noun is not None] == [("in", "corner")]
    (order,) = read_instruction("I'd like more light in here: add a lamp by the door").orders
    assert [w.noun.value for w in order.things[0].places if w.noun is not None] == ["door"]


def test_one_on_each_side_uses_the_one_that_is_there() -> None:
    before = built(room(), ("bed_1", 3.0, 3.9, 270.0, "floor"), ("nightstand_1", 4.1, 4.75, 270.0, "floor"),
                   ("table_lamp_1", 4.1, 4.75, 0.0, "nightstand_1"))  # fmt: skip
    for lead in ("", "Make the bed black and "):
        said = f"{lead}put a nightstand on each side of the bed"
        after = done(before, said).scene
        assert sorted(p.id for p in after.placements if p.category == "nightstand") == ["nightstand_1", "nightstand_2"]
        assert after["table_lamp_1"].support == "nightstand_1"
        sides = [after["bed_1"].to_local(after[f"nightstand_{n}"].position[:2])[1] > 0 for n in (1, 2)]
        assert sorted(sides) == [False, True], said


def test_a_side_of_the_thing_that_is_to_be_at_a_wall_is_not_passed_over() -> None:
    edit = edit_room(bedroom(), "Turn the bed by 90 degrees so that its long side is against the north wall")
    assert any("its long side" in word for word in edit.unknown)


def test_the_head_of_a_bed_is_at_its_end() -> None:
    before = built(room(), ("bed_1", 3.0, 3.9, 270.0, "floor"), ("nightstand_1", 4.2, 3.8, 270.0, "floor"))
    after = done(before, "Put the nightstand at the head of the bed").scene
    bed = after["bed_1"]
    assert bed.to_local(after["nightstand_1"].position[:2])[0] < -0.25 * bed.size[0]


def test_the_others_of_so_many_that_are_enough_go_elsewhere() -> None:
    for said in ("Two chairs are enough at the table; put the other two along the west wall",
                 "Keep two chairs at the table and put the others along the west wall"):  # fmt: skip
        after = done(dining(2), "Add two more chairs at the table").scene
        moved = done(after, said).scene
        at = [p.id for p in moved.placements if measure(moved, "at", p.id, ("dining_table_1",)).holds]
        assert len([id for id in at if id.startswith("chair")]) == 2, said
        assert len(moved.placements) == len(after.placements)


def test_the_benches_of_a_workshop_are_the_workbenches() -> None:
    before = built(room(), ("workbench_1", 3.0, 4.6, 270.0, "floor"), ("keyboard_1", 3.0, 4.6, 270.0, "workbench_1"))
    edit = edit_room(before, "Make the bench black")
    assert "workbench_1" in {c.id for c in edit.changes}
    assert any("is taken to be workbench_1" in text for text in edit.done)
    with pytest.raises(InputError, match="no board"):
        edit_room(before, "Remove the board")


def test_what_is_still_to_face_something_is_no_name_of_a_thing() -> None:
    (order,) = read_instruction("Have the armchair still face the sofa").orders
    assert [phrase.noun.value for phrase in order.things] == ["armchair"]


def test_what_is_longer_slides_along_its_wall_and_is_as_long_as_is_said() -> None:
    before = built(room(), ("workbench_1", 3.0, 4.6, 270.0, "floor"), ("stool_1", 3.0, 4.1, 90.0, "floor"))
    width = before["workbench_1"].size[1]
    before = built(room(), ("workbench_1", 5.95 - width / 2, 4.6, 270.0, "floor"),
                   ("stool_1", 5.95 - width / 2, 4.1, 90.0, "floor"))  # fmt: skip
    after = done(before, f"Replace the workbench by a longer one, at least {width + 0.3:.2f} m").scene
    assert after["workbench_1"].size[1] == pytest.approx(width + 0.3, abs=0.01)
    assert measure(after, "against_wall", "workbench_1", ("north_wall",)).holds
    with pytest.raises(InputError, match="not longer than"):
        edit_room(before, f"Replace the workbench by a longer one of {width - 0.2:.2f} m")


def test_a_colour_of_two_words_and_a_reason_are_understood() -> None:
    assert done(living(), "Make the sofa navy blue").changes
    assert [c.id for c in done(living(), "There's no party here any more, so clear the coffee table").changes] == [
        "vase_1"
    ]


def test_how_a_thing_looks_and_where_it_is_are_two_orders() -> None:
    edit = done(living(), "The rug should be green and round and lie in front of the desk")
    asset = edit.scene.asset_of(edit.scene["rug_1"])
    assert {"green", "round"} <= {*asset.attributes}
    assert measure(edit.scene, "in_front_of", "rug_1", ("desk_1",)).holds


def test_in_between_is_between_what_was_named_before() -> None:
    put, between = read_instruction("I want the two armchairs facing each other with the side table in between").orders
    assert (put.mutual, between.things[0].noun.value) == ("facing", "side_table")
    assert [(w.word, w.noun.value) for w in between.things[0].places if w.noun is not None] == [("between", "them")]


def test_what_is_too_high_for_a_window_is_told_by_its_figures() -> None:
    before = built(room(), ("bookcase_1", 5.7, 1.5, 180.0, "floor"))
    edit = edit_room(before, "Put the bookcase under the window")
    assert any("middle of window_1 at 1.50 m" in text for text in edit.failed)


def test_none_of_that_but_something_instead() -> None:
    edit = done(bedroom(), "No wardrobe please; a bookcase instead")
    assert {(c.id, c.what) for c in edit.changes} == {("wardrobe_1", "removed"), ("bookcase_1", "added")}


def test_either_side_of_one_window_is_beside_that_one_and_what_hangs_comes_there() -> None:
    windows = (OPENINGS[0], Opening(id="window_1", kind="window", wall=2, offset=2.0, width=1.6, height=1.2, sill=0.9),
               Opening(id="window_2", kind="window", wall=3, offset=1.5, width=1.6, height=1.2, sill=0.9))  # fmt: skip
    before = built(rectangle(6.0, 5.0, openings=windows), ("desk_1", 3.0, 2.5, 90.0, "floor"))
    after = done(before, "Add two wall lamps, one on either side of the north window").scene
    assert [after[f"wall_lamp_{n}"].support for n in (1, 2)] == ["north_wall", "north_wall"]
    assert sorted(after[f"wall_lamp_{n}"].position[0] < 3.2 for n in (1, 2)) == [False, True]


def test_what_somebody_is_given_comes_to_the_desk_that_is_called_theirs() -> None:
    before = classroom()
    asset = before.asset_of(before["desk_1"]).called("teacher's desk")
    called = before.without("desk_1").with_placement(structs.replace(before["desk_1"], asset=asset.id), asset)
    after = done(called, "Give the teacher a chair").scene
    new = next(p for p in after.placements if p.id not in before)
    assert measure(after, "at", new.id, ("desk_1",)).holds
    with pytest.raises(InputError, match="of one"):
        edit_room(before, "Give the doctor a chair")


def test_what_belongs_to_a_thing_stands_by_it() -> None:
    before = built(room(), ("desk_1", 5.5, 1.5, 180.0, "floor"), ("chair_1", 1.0, 4.3, 0.0, "floor"))
    with pytest.raises(InputError, match="none of chair_1 stands within"):
        edit_room(before, "Remove the desk together with its chair")
    near = built(room(), ("desk_1", 5.5, 1.5, 180.0, "floor"), ("chair_1", 4.8, 1.5, 0.0, "floor"))
    assert len(done(near, "Remove the desk together with its chair").changes) == 2


def test_a_change_of_size_that_is_ruled_out_is_none() -> None:
    deep, wide, _ = living()["coffee_table_1"].size
    edit = done(living(), "Make the coffee table longer but not wider")
    assert edit.scene["coffee_table_1"].size[0] == pytest.approx(deep, abs=0.001)
    assert edit.scene["coffee_table_1"].size[1] > wide + 0.05


def test_something_small_goes_to_what_usually_carries_it_before_a_seat() -> None:
    full = built(room(), ("nightstand_1", 0.5, 3.0, 0.0, "floor"), ("table_lamp_1", 0.5, 3.0, 0.0, "nightstand_1"),
                 ("chair_1", 2.0, 3.0, 0.0, "floor"), ("dresser_1", 5.7, 2.0, 180.0, "floor"))  # fmt: skip
    assert done(full, "Add a table lamp").scene["table_lamp_2"].support != "chair_1"


def test_the_left_one_that_is_excepted_is_one_of_those_that_are_meant() -> None:
    before = built(room(), ("bookcase_1", 3.4, 4.75, 270.0, "floor"), ("bookcase_2", 4.6, 4.75, 270.0, "floor"),
                   ("bookcase_3", 0.3, 3.0, 0.0, "floor"))  # fmt: skip
    gone = done(before, "Remove all bookcases along the north wall except the left one").changes
    assert [c.id for c in gone] == ["bookcase_2"]


def test_what_is_added_at_each_of_a_row_is_at_that_row_alone() -> None:
    after = done(classroom(), "Add a laptop on each school desk in the first row").scene
    assert sorted(p.support for p in after.placements if p.category == "laptop") == row(1)[:3]


def test_what_stays_on_a_thing_that_moves_goes_along() -> None:
    after = done(living(), "Move the coffee table 20 cm to the north but keep the vase on it").scene
    assert after["vase_1"].support == "coffee_table_1"
    assert after["vase_1"].position[1] == pytest.approx(living()["vase_1"].position[1] + 0.2, abs=0.02)


def test_the_other_side_of_a_desk_is_not_the_one_that_the_chair_is_at() -> None:
    before = built(room(), ("desk_1", 0.5, 2.6, 0.0, "floor"), ("chair_1", 1.2, 2.6, 180.0, "floor"))
    assert edit_room(before, "Put the chair on the other side of the desk").failed


def test_everything_from_two_things_leaves_both_where_they_are() -> None:
    before = built(room(), ("sideboard_1", 5.7, 2.5, 180.0, "floor"), ("coffee_table_1", 3.0, 1.9, 90.0, "floor"),
                   ("vase_1", 3.0, 1.9, 0.0, "coffee_table_1"), ("stool_1", 1.0, 4.0, 0.0, "floor"),
                   ("table_lamp_1", 5.7, 2.5, 0.0, "sideboard_1"))  # fmt: skip
    gone = {c.id for c in done(before, "Remove everything from the sideboard and the coffee table").changes}
    assert gone == {"vase_1", "table_lamp_1"}
    gone = {c.id for c in done(before, "Remove everything on the coffee table and the stool").changes}
    assert gone == {"vase_1", "stool_1"}
    with pytest.raises(InputError, match="in two orders"):
        edit_room(before, "Remove everything on the sideboard and the coffee table")


def test_next_to_the_others_is_next_to_those_of_its_kind() -> None:
    before = built(room(), ("bookcase_1", 3.4, 4.75, 270.0, "floor"))
    after = done(before, "Add another bookcase next to the others").scene
    assert gap(after, "bookcase_1", "bookcase_2") < 0.5


def test_a_chair_behind_a_desk_is_drawn_up_to_it() -> None:
    before = built(room(), ("desk_1", 0.5, 2.6, 0.0, "floor"))
    after = done(before, "Put a chair behind the desk").scene
    assert measure(after, "at", "chair_1", ("desk_1",)).holds


def test_what_is_its_own_is_said_once() -> None:
    (order,) = read_instruction("Remove the table closest to the counter, including its chairs and vase.").orders
    assert [(p.noun.value, p.noun.det) for p in order.company] == [("chair", "my"), ("vase", "my")]
    assert len(order.things) == 1


def test_nothing_is_taken_away_of_what_is_not_wholly_understood() -> None:
    with pytest.raises(InputError, match="not understood"):
        edit_room(dining(2), "Get rid of the chairs that don't fit")


def test_a_smaller_table_can_come_with_fewer_chairs_at_its_sides() -> None:
    before = built(
        room(),
        ("dining_table_1", 3.0, 2.5, 90.0, "floor"),
        ("chair_1", 2.6, 1.75, 90.0, "floor"),
        ("chair_2", 3.4, 1.75, 90.0, "floor"),
        ("chair_3", 2.6, 3.25, 270.0, "floor"),
    )
    after = done(before, "I want a smaller table with only two chairs, one on each side").scene
    table, chairs = after["dining_table_1"], [p for p in after.placements if p.category == "chair"]
    ahead = sorted(table.to_local(p.position[:2])[0] for p in chairs)
    assert len(chairs) == 2
    assert ahead[0] < 0.0 < ahead[1]


def test_what_goes_by_a_thing_that_was_not_added_is_told() -> None:
    edit = edit_room(dining(2), "Hang a clock over the table and a wall shelf to the left of it")
    assert len(edit.failed) == 2
    assert not edit.changes


def test_the_other_orders_are_told_where_one_is_refused() -> None:
    with pytest.raises(InputError, match="'rotate the coffee table 90 degrees' neither"):
        edit_room(living(), "Get rid of the piano and rotate the coffee table 90 degrees")


@pytest.mark.parametrize(
    ("said", "doing", "thing"),
    [
        ("We got a new side table - can you squeeze it in between the sofa and the desk?", "put", "side_table"),
        ("We bought a plant, please put it next to the sofa", "put", "plant"),
        ("Leave at least a metre of free space in front of the sofa", "free", ""),
        ("Split the bunk bed into two single beds", "replace", "bunk_bed"),
        ("Don't put the desk near the window; put it by the sofa", "put", "desk"),
    ],
)
def test_other_ways_to_say_an_order(said: str, doing: str, thing: str) -> None:
    (order,) = read_instruction(said).orders
    assert order.doing == doing
    assert not thing or order.things[0].noun.value == thing


def test_what_somebody_would_rather_have_comes_in_place() -> None:
    after = done(bedroom(), "I'd rather have a single bed").scene
    assert [p.id for p in after.placements if p.category == "bed"] == ["bed_1"]


def test_not_to_face_a_thing_is_held() -> None:
    (order,) = read_instruction("Turn the armchair so it looks at the desk, not at the sofa").orders
    assert [noun.value for noun in order.facing] == ["desk"]
    assert [(w.noun.value, w.negated) for w in order.things[0].places if w.noun] == [("sofa", True)]
