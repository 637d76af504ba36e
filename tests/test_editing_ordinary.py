"""What people ordinarily type: sides of a table, counts that come to a number, rows, and what an edit is for."""

import math

import pytest

from tests.edited_rooms import bedroom, built, dining, living, room, same_but
from tests.test_editing_guard import classroom, done
from thinkblox import Scene, edit_room
from thinkblox.editing.goals import Laid
from thinkblox.editing.reading import read_instruction
from thinkblox.editing.remarks import LEGS, legroom
from thinkblox.errors import InputError
from thinkblox.scene.bearings import bearing
from thinkblox.scene.landmarks import things
from thinkblox.scene.relations import measure
from thinkblox.scene.room import turn_between


def seated() -> Scene:
    """A long table with two chairs at each long side, one at its west end, and a window in the north."""
    rows = [("dining_table_1", 3.0, 2.5, 90.0, "floor")]
    rows += [(f"chair_{n + 1}", 2.6 + 0.8 * n, 1.75, 90.0, "floor") for n in range(2)]
    rows += [(f"chair_{n + 3}", 2.6 + 0.8 * n, 3.25, 270.0, "floor") for n in range(2)]
    return built(room(), *rows, ("chair_5", 1.6, 2.5, 0.0, "floor"))


def ids(scene: Scene, category: str) -> set[str]:
    return {p.id for p in scene.placements if p.category == category}


# --- which are meant


def test_seats_are_told_by_the_side_of_their_table() -> None:
    before = seated()
    assert ids(done(before, "Remove the chairs on the side facing the window").scene, "chair") == {
        "chair_1", "chair_2", "chair_5"}  # fmt: skip
    assert ids(done(before, "Remove the chairs from the long sides of the table").scene, "chair") == {"chair_5"}
    with pytest.raises(InputError, match="there is no chair at the ends"):
        edit_room(before.without("chair_5"), "Remove the chairs at the ends of the table")


def test_seats_that_are_told_by_their_side_go_to_a_wall() -> None:
    before = seated()
    after = done(before, "Move the chairs at the short ends of the table against the wall").scene
    assert measure(after, "against_wall", "chair_5", ("wall",)).holds
    assert same_but(before, after, "chair_5")


def test_one_at_each_side_is_taken_from_each() -> None:
    before = seated().without("chair_5")
    for said in ("Remove a chair on each side of the table", "I want one chair less on each side"):
        left = done(before, said).scene
        sides = [left[id].position[1] > 2.5 for id in ids(left, "chair")]
        assert sorted(sides) == [False, True]


def test_two_that_are_taken_go_one_to_each_end() -> None:
    before = seated().without("chair_5")
    after = done(before, "Take two chairs from the long sides and put one at each end of the table").scene
    ends = [p.id for p in after.placements if p.category == "chair" and abs(p.position[0] - 3.0) > 0.9]
    assert len(ends) == 2
    assert same_but(before, after, *ends)


def test_a_thing_is_called_by_what_it_carries() -> None:
    before = built(room(), ("cabinet_1", 0.5, 4.7, 270.0, "floor"), ("cabinet_2", 5.5, 4.7, 270.0, "floor"),
                   ("printer_1", 5.5, 4.7, 270.0, "cabinet_2"), ("stool_1", 3.0, 1.5, 0.0, "floor"))  # fmt: skip
    after = done(before, "Move the stool next to the printer cabinet").scene
    assert measure(after, "next_to", "stool_1", ("cabinet_2",)).holds


def test_the_wall_of_a_thing() -> None:
    before = living()
    after = done(before, "Remove the picture on the sideboard wall").scene
    assert "picture_1" not in after


def test_what_lacks_a_thing_gets_one() -> None:
    before = bedroom().without("table_lamp_1")
    after = done(before, "Put a vase on each nightstand that doesn't have a lamp").scene
    assert [p.support for p in after.placements if p.category == "vase"] == ["nightstand_1"]
    with pytest.raises(InputError, match="without"):
        edit_room(bedroom(), "Put a vase on each nightstand without a lamp")


# --- how many


@pytest.mark.parametrize(
    "said",
    [
        "Only two chairs please, one on each side of the table.",
        "only two chairs, one on each side of the table",
        "There should only be two chairs, one on each side of the table.",
        "I want only one chair on each side of the table",
    ],
)
def test_only_so_many_one_on_each_side(said: str) -> None:
    after = done(seated(), said).scene
    chairs = [after[id] for id in ids(after, "chair")]
    assert sorted(p.position[1] > 2.5 for p in chairs) == [False, True]
    assert all(measure(after, "at", p.id, ("dining_table_1",)).holds for p in chairs)


@pytest.mark.parametrize(
    "said",
    ["Reduce the number of chairs to three", "We only need three chairs", "I want only three chairs",
     "Cut the chairs down to three"],
)  # fmt: skip
def test_there_come_to_be_so_many(said: str) -> None:
    assert len(ids(done(seated(), said).scene, "chair")) == 3


def test_so_many_each_instead_of_more_takes_the_rest_away() -> None:
    rows = [(f"dining_table_{n}", 1.5 + 3.0 * (n - 1), 2.5, 90.0, "floor") for n in (1, 2)]
    rows += [(f"chair_{n + 1}", 1.1 + 0.8 * (n % 2) + 3.0 * (n // 2), 1.75, 90.0, "floor") for n in range(4)]
    after = done(built(room(), *rows), "Give each table one chair instead of two").scene
    for table in ("dining_table_1", "dining_table_2"):
        assert sum(measure(after, "at", id, (table,)).holds for id in ids(after, "chair")) == 1


def test_what_was_added_is_spread_with_those_that_were_there() -> None:
    before = built(room(), ("bar_counter_1", 3.0, 3.0, 270.0, "floor"), ("bar_stool_1", 2.4, 3.6, 270.0, "floor"),
                   ("bar_stool_2", 3.4, 3.6, 270.0, "floor"))  # fmt: skip
    after = done(before, "Add a third bar stool and space them evenly along the counter").scene
    x = sorted(after[id].position[0] for id in ids(after, "bar_stool"))
    assert len(x) == 3
    assert math.isclose(x[1] - x[0], x[2] - x[1], abs_tol=0.02)


def test_what_comes_with_each_of_those_that_come_instead() -> None:
    after = done(living(), "Replace the sofa with two armchairs with a cushion on each").scene
    came = [p.support for p in after.placements if p.category == "pillow"]
    assert len(came) == len(set(came)) == 2


# --- where, and which way


def test_a_thing_that_is_turned_looks_straight_at_what_it_faces() -> None:
    before = built(room(), ("armchair_1", 4.0, 1.5, 180.0, "floor"), ("bookcase_1", 1.0, 4.8, 270.0, "floor"))
    after = done(before, "Face the armchair to the bookcase").scene
    to = bearing(after["armchair_1"].position[:2], after["bookcase_1"].position[:2])
    assert turn_between(things(after, "armchair_1")[0].gaze, to) < 5.0


def test_a_back_is_to_what_is_behind_it() -> None:
    before = built(room(), ("armchair_1", 2.5, 3.0, 180.0, "floor"), ("bookcase_1", 4.8, 0.2, 90.0, "floor"))
    after = done(before, "Turn the armchair so that I sit with my back to the bookcase").scene
    away = bearing(after["bookcase_1"].position[:2], after["armchair_1"].position[:2])
    assert turn_between(things(after, "armchair_1")[0].gaze, away) < 25.0


def test_two_face_each_other_across_what_is_between_them() -> None:
    before = built(room(), ("armchair_1", 1.5, 2.5, 20.0, "floor"), ("armchair_2", 4.5, 2.5, 160.0, "floor"),
                   ("coffee_table_1", 3.0, 2.5, 90.0, "floor"), ("plant_1", 3.0, 4.4, 0.0, "floor"))  # fmt: skip
    after = done(before, "Turn the armchairs so they face each other across the coffee table").scene
    assert turn_between(after["armchair_1"].yaw, 0.0) < 3.0
    assert turn_between(after["armchair_2"].yaw, 180.0) < 3.0
    other = edit_room(before, "Turn the armchairs so they face each other across the plant")
    assert any("plant_1 is not between" in says for says in other.failed)


def test_what_hangs_level_has_its_middle_as_high() -> None:
    before = done(built(room(), ("picture_1", 0.016, 3.6, 0.0, "wall")), "Hang a clock on the east wall").scene
    for said in (
        "Hang the clock next to the picture at the same height",
        "Hang a mirror by the picture level with it",
    ):
        after = done(before, said).scene
        new = next(p for p in after.placements if p.category in ("clock", "mirror") and p != before["clock_1"])
        middle = [p.position[2] + p.size[2] / 2 for p in (new, after["picture_1"])]
        assert math.isclose(*middle, abs_tol=0.02)


def test_the_new_wall_is_the_one_that_was_moved() -> None:
    after = done(living(), "Make the room 1 m wider and put a piano along the new wall").scene
    assert measure(after, "against_wall", "piano_1", ("north_wall",)).holds
    with pytest.raises(InputError, match="no wall has moved"):
        edit_room(living(), "Put the armchair at the new wall")


def test_rows_are_pulled_apart_as_they_are() -> None:
    before = classroom()
    after = done(before, "Pull the rows 20 cm further apart").scene
    first, second = (after[id].position[0] - before[id].position[0] for id in ("school_desk_1", "school_desk_4"))
    assert math.isclose(first - second, 0.2, abs_tol=0.01)
    assert after["desk_1"] == before["desk_1"]


def test_two_rows_of_seats_face_each_other() -> None:
    rows = [(f"chair_{n + 1}", 1.0 + 0.7 * n, 4.6, 270.0, "floor") for n in range(6)]
    after = done(built(room(), *rows), "Arrange the chairs in two rows facing each other").scene
    yaws = [after[f"chair_{n + 1}"].yaw for n in range(6)]
    assert sorted(sum(turn_between(yaw, other) < 1.0 for other in yaws) for yaw in yaws) == [3] * 6
    one, other = (next(p for p in after.placements if p.yaw == yaw) for yaw in sorted({*yaws}))
    ahead = [one.to_local(other.position[:2])[0], other.to_local(one.position[:2])[0]]
    assert min(ahead) > 0.9


def test_several_hang_in_a_row() -> None:
    after = done(dining(), "Hang three pendant lamps in a row above the table").scene
    lamps = [p.position for p in after.placements if p.category == "pendant_lamp"]
    assert len(lamps) == 3
    assert max(y for _, y, _ in lamps) - min(y for _, y, _ in lamps) < 0.1


def test_lamps_that_stand_give_way_to_some_that_hang() -> None:
    before = bedroom()
    after = done(before, "Replace both table lamps with wall lamps above the nightstands").scene
    assert not ids(after, "table_lamp")
    lamps = ids(after, "wall_lamp")
    above = {id: [measure(after, "above", lamp, (id,)).holds for lamp in lamps] for id in ids(after, "nightstand")}
    assert len(lamps) == 2
    assert all(any(held) for held in above.values())


def test_a_rug_that_is_large_enough_lies_under_all_of_them() -> None:
    after = done(seated(), "Put a rug under the table that is big enough for the chairs").scene
    assert all(after["rug_1"].footprint.buffer(0.02).covers(after[id].footprint) for id in ids(after, "chair"))


def test_something_small_comes_beside_what_is_let_in_on_the_side_that_is_said() -> None:
    before = built(room(), ("base_cabinet_1", 2.5, 4.65, 270.0, "floor"), ("stove_1", 3.2, 4.65, 270.0, "floor"),
                   ("base_cabinet_2", 3.9, 4.65, 270.0, "floor"))  # fmt: skip
    for side, cabinet in (("left", "base_cabinet_2"), ("right", "base_cabinet_1")):
        after = done(before, f"Put a knife block to the {side} of the stove").scene
        assert after["knife_block_1"].support == cabinet


# --- what it is for


def test_room_that_is_made_comes_first() -> None:
    before = built(room(3.0, 2.6), ("armchair_1", 0.5, 2.1, 315.0, "floor"))
    result = done(before, "Add a desk in the corner by the window, and take out the armchair to make space.")
    assert "armchair_1" not in result.scene
    assert ids(result.scene, "desk")


def test_a_purpose_that_says_how_is_not_passed_over() -> None:
    with pytest.raises(InputError, match="not understood"):
        edit_room(living(), "Rearrange the seating area so that people can talk to each other.")
    assert not read_instruction("Remove the rug to make a dance floor").unknown
    assert read_instruction("Move the sofa so that guests feel welcome").unknown


def test_a_vase_with_flowers_is_one_thing_also_where_each_has_one() -> None:
    after = done(bedroom().without("table_lamp_1").without("table_lamp_2"),
                 "Every nightstand should have a small vase with flowers on it.").scene  # fmt: skip
    new = [p.category for p in after.placements if p.support.startswith("nightstand")]
    assert len(new) == 2
    assert set(new) == {"vase_with_flowers"}


# --- what was wrong in silence


def test_a_seat_that_comes_to_face_a_window_stands_off_its_wall() -> None:
    before = built(room(), ("sofa_1", 4.4, 4.5, 270.0, "floor"))
    for said in ("The sofa should look at the window", "Move the sofa so that it faces the window"):
        after = done(before, said).scene
        assert measure(after, "facing", "sofa_1", ("window_1",)).holds
        assert legroom(after, "sofa_1") >= LEGS


def test_out_of_the_way_and_where_to_is_to_that_place() -> None:
    before = living().without("vase_1")
    after = done(before, "Move the coffee table out of the way, against the wall.").scene
    assert measure(after, "against_wall", "coffee_table_1", ("wall",)).holds
    assert same_but(before, after, "coffee_table_1")


def test_where_a_thing_is_taken_is_not_where_it_goes() -> None:
    before = built(room(), ("sofa_1", 3.0, 0.6, 90.0, "floor"), ("plant_1", 1.5, 0.6, 0.0, "floor"),
                   ("plant_2", 5.4, 4.4, 0.0, "floor"), ("bookcase_1", 0.3, 3.0, 0.0, "floor"))  # fmt: skip
    after = done(before, "Take the plant next to the sofa and put it next to the bookcase.").scene
    assert measure(after, "next_to", "plant_1", ("bookcase_1",)).holds
    assert same_but(before, after, "plant_1")


def test_two_are_taken_away_one_from_each_side() -> None:
    after = done(seated().without("chair_5"), "Take away two chairs, one from each side of the table.").scene
    assert sorted(after[id].position[1] > 2.5 for id in ids(after, "chair")) == [False, True]


def test_so_many_that_are_wanted_two_on_each_side_are_all_there_are() -> None:
    before = seated().without("chair_5").without("chair_3")
    after = done(before, "I want four chairs, two on each side of the table.").scene
    assert sorted(after[id].position[1] > 2.5 for id in ids(after, "chair")) == [False, False, True, True]


def test_a_heap_of_things_is_told() -> None:
    assert "in a pile" in read_instruction("Put the books in a stack on the table").unknown


def test_the_back_ones_are_those_farthest_from_the_door() -> None:
    rows = [("round_table", x, y) for y in (1.8, 3.8) for x in (1.5, 4.5)]
    before = built(room(), *((f"dining_table_{n + 1}", x, y, 0.0, "floor") for n, (_, x, y) in enumerate(rows)))
    assert ids(done(before, "Remove the two back tables").scene, "dining_table") == {"dining_table_1", "dining_table_2"}
    with pytest.raises(InputError, match="could be"):
        edit_room(before, "Remove the front table")


def test_the_same_one_of_every_row() -> None:
    before = classroom()
    for said in ("Remove the desk in the middle of each row", "Remove the second desk in every row"):
        gone = {p.id for p in before.placements} - {p.id for p in done(before, said).scene.placements}
        assert gone == {"school_desk_2", "school_desk_5"}


def test_a_gap_is_widened_with_the_seats_of_the_table() -> None:
    before = built(room(), ("dining_table_1", 3.0, 2.5, 90.0, "floor"), ("chair_1", 2.6, 1.75, 90.0, "floor"),
                   ("chair_2", 2.6, 3.25, 270.0, "floor"), ("fridge_1", 0.4, 2.5, 0.0, "floor"))  # fmt: skip
    after = done(before, "Widen the gap between the table and the fridge by 20 cm.").scene
    gaps = [s["dining_table_1"].footprint.distance(s["fridge_1"].footprint) for s in (before, after)]
    assert math.isclose(gaps[1] - gaps[0], 0.2, abs_tol=0.02)
    assert all(measure(after, "at", id, ("dining_table_1",)).holds for id in ("chair_1", "chair_2"))


def test_no_gap_between_them() -> None:
    before = built(room(), ("bookcase_1", 3.0, 4.8, 270.0, "floor"), ("bookcase_2", 0.3, 1.5, 0.0, "floor"))
    after = done(before, "Move bookcase_2 to the left of bookcase_1, no gap between them.").scene
    assert after["bookcase_1"].footprint.distance(after["bookcase_2"].footprint) <= 0.07
    assert measure(after, "left_of", "bookcase_2", ("bookcase_1",)).holds


def test_what_is_made_smaller_makes_space() -> None:
    after = done(bedroom(), "Make the bed narrower so that there is more space next to it.").scene
    assert after["bed_1"].size[1] < bedroom()["bed_1"].size[1]


def two_tables() -> Scene:
    """Two square tables with two chairs each, one at either side."""
    rows = [(f"dining_table_{n}", 1.6 + 2.8 * (n - 1), 2.8, 0.0, "floor") for n in (1, 2)]
    for n, (x, y, yaw) in enumerate(((1.6, 1.95, 90.0), (1.6, 3.65, 270.0), (4.4, 1.95, 90.0), (4.4, 3.65, 270.0))):
        rows.append((f"chair_{n + 1}", x, y, yaw, "floor"))
    return built(room(), *rows)


def test_one_of_each_of_several_is_moved_or_replaced() -> None:
    before = two_tables()
    after = done(before, "Take one chair from each table and line them up along the north wall").scene
    moved = [id for id in ids(after, "chair") if after[id] != before[id]]
    assert {int(id[-1]) > 2 for id in moved} == {False, True}
    assert len(moved) == 2
    after = done(before, "Replace one chair at each table with a stool").scene
    assert len(ids(after, "stool")) == len(ids(after, "chair")) == 2


def test_the_other_side_of_several_is_that_of_its_own() -> None:
    before = built(room(), ("sofa_1", 3.6, 0.6, 90.0, "floor"), ("sofa_2", 3.6, 4.4, 270.0, "floor"),
                   ("side_table_1", 5.2, 0.4, 90.0, "floor"), ("side_table_2", 2.1, 4.6, 270.0, "floor"))  # fmt: skip
    after = done(before.without("side_table_1"), "Move the side table to the other side of the sofas").scene
    assert measure(after, "next_to", "side_table_2", ("sofa_2",)).holds
    assert after["side_table_2"].position[0] > 3.6


def test_too_many_and_so_many_are_enough() -> None:
    assert len(ids(done(seated(), "There are too many chairs, four are enough.").scene, "chair")) == 4


def test_the_other_half_of_the_room_is_across_from_where_it_stands() -> None:
    before = built(room(), ("sofa_1", 3.0, 0.6, 90.0, "floor"))
    assert done(before, "Move the sofa to the other half of the room").scene["sofa_1"].position[1] > 2.5


def test_only_the_front_row_is_kept() -> None:
    left = done(classroom(), "Keep only the front row, remove the other desks and chairs.").scene
    assert ids(left, "school_desk") == {"school_desk_1", "school_desk_2", "school_desk_3"}
    assert "desk_1" in left


def test_the_opposite_side_of_the_room_from_a_door() -> None:
    before = built(room(), ("sideboard_1", 5.7, 2.5, 180.0, "floor"))
    after = done(before, "Move the sideboard to the opposite side of the room from the door").scene
    assert measure(after, "against_wall", "sideboard_1", ("north_wall",)).holds


@pytest.mark.parametrize("said", ["Pair up the desks", "Push the desks together in pairs"])
def test_desks_are_paired_up(said: str) -> None:
    rows = [(f"desk_{n + 1}", 1.2 + 1.8 * (n % 2), 1.5 + 2.0 * (n // 2), 90.0, "floor") for n in range(4)]
    after = done(built(room(7.0, 6.0), *rows), said).scene
    desks = [after[f"desk_{n + 1}"].footprint for n in range(4)]
    assert all(sum(one.distance(other) < 0.05 for other in desks if other is not one) == 1 for one in desks)


def test_one_comes_before_each_of_two_seats_that_are_named() -> None:
    before = seated()
    for said in ("Add a plate in front of {}", "Add a plate on the table in front of {}"):
        after = done(before, said.format("chair_1 and chair_5")).scene
        plates = [p.id for p in after.placements if p.category == "plate"]
        held = [Laid("on", ("dining_table_1",), seat=seat).check(after, after, id)[0]
                for id, seat in zip(plates, ("chair_1", "chair_5"), strict=True)]  # fmt: skip
        assert held == [True, True]
