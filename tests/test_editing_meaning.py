"""What instructions mean beyond their words: what belongs together, which of several, where from, and how many."""

import math

import pytest
from msgspec import structs

from tests.edited_rooms import OPENINGS, bedroom, built, dining, living, placed, room
from tests.test_editing_guard import classroom, done
from thinkblox import edit_room
from thinkblox.editing.reading import read_instruction
from thinkblox.errors import InputError
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.relations import measure
from thinkblox.scene.room import rectangle, turn_between
from thinkblox.scene.scene import Scene

OFFICE = ("desk_1", "desk_2", "office_chair_1", "office_chair_2", "laptop_1", "whiteboard_1")


def gap(scene: Scene, one: str, other: str) -> float:
    return ground_gap(things(scene, one)[0], things(scene, other)[0])


def test_seats_stay_at_a_table_that_is_turned_or_moved_with_them() -> None:
    before = dining(2)
    seated = [p.id for p in before.placements if measure(before, "at", p.id, ("dining_table_1",)).holds]
    assert seated
    for said in (
        "Turn the table by 30 degrees together with the chairs",
        "Move the table and chairs 40 cm to the left",
    ):
        after = done(before, said).scene
        assert all(measure(after, "at", id, ("dining_table_1",)).holds for id in seated), said


def test_what_belongs_to_a_row_is_at_it_and_nothing_else() -> None:
    before = classroom()
    for said, gone in (
        ("Remove the last row of desks with their chairs", {"school_desk", "chair"}),
        ("Remove every other desk in the front row", {"school_desk"}),
    ):
        after = done(before, said).scene
        lost = {p.id for p in before.placements} - {p.id for p in after.placements}
        assert {id.rpartition("_")[0] for id in lost} == gone, said
        assert len(lost) == (6 if "last" in said else 1), said
    desks, chairs = read_instruction("Shift the front row of desks and chairs 20 cm forward").orders[0].things
    assert (desks.noun.rows, chairs.noun.det) == (1, "my")


def test_wider_and_longer_are_two_sides_of_the_room() -> None:
    grown = done(bedroom(), "Make the room 1.2 m wider and 10 cm longer").scene.room.extent
    old = bedroom().room.extent
    assert sorted(round(new - was, 3) for new, was in zip(grown, old, strict=True)) == [0.1, 1.2]


def test_what_comes_instead_takes_the_place_and_what_was_there_goes() -> None:
    before = built(room(), ("dining_table_1", 3.0, 2.5, 0.0, "floor"), ("vase_1", 3.0, 2.5, 0.0, "dining_table_1"))
    after = done(before, "Put a bowl in the centre of the table instead of the vase").scene
    assert [p.support for p in after.placements if p.category == "bowl"] == ["dining_table_1"]
    assert "vase_1" not in after


def test_what_loses_what_carries_it_is_told() -> None:
    before = built(room(), ("dining_table_1", 3.0, 2.5, 0.0, "floor"), ("vase_1", 3.0, 2.5, 0.0, "dining_table_1"))
    edit = edit_room(before, "Replace the table with a rug")
    assert "vase_1" in edit.scene or any("vase_1" in text for text in edit.failed)
    assert not edit.complete or "vase_1" in edit.scene


def test_turned_by_an_angle_towards_something() -> None:
    before = living()
    after = done(before, "Rotate the armchair 20 degrees towards the sofa").scene
    assert turn_between(before["armchair_1"].yaw, after["armchair_1"].yaw) == pytest.approx(20.0, abs=0.1)


def test_what_people_say_is_read_whole() -> None:
    for text, doing in (
        ("Make it three office chairs", "ensure"),
        ("Turn desk 2 and its chair around", "turn"),
        ("make desks 1 and 2 white", "make"),
        ("Group the two desks together in the middle of the room", "move"),
        ("spread the desks apart a bit", "move"),
        ("turn each office chair away from its desk", "turn"),
        ("push desk_1 into the nearest corner", "move"),
        ("Put the laptop on the desk that's closer to the door", "put"),
        ("swap desk 1 with desk 2 and its chair", "swap"),
        ("Replace the whiteboard with a blackboard of the same size", "replace"),
        ("centre the whiteboard on the wall", "move"),
        ("add a plant to each desk except desk 2", "add"),
        ("shrink desk 1 by a third", "make"),
        ("Duplicate desk 1", "add"),
        ("move everything on desk 1 to desk 2", "move"),
        ("turn the desks so that I face the window when sitting", "turn"),
        ("I want desk 1 on the same wall as the door", "put"),
        ("put a chair in the corner where the whiteboard is", "put"),
    ):
        read = read_instruction(text, OFFICE)
        assert not read.unknown, (text, read.unknown)
        assert read.orders[0].doing == doing, (text, read.orders[0].doing)
    numbered = read_instruction("Turn desk 2 by 90 degrees", OFFICE).orders[0]
    assert [phrase.id for phrase in numbered.things] == ["desk_2"]
    assert read_instruction("Move the desk 2 m to the left", OFFICE).orders[0].lengths == [(2.0, "")]


def test_what_cannot_be_followed_changes_nothing() -> None:
    scene = classroom()
    for text in (
        "Take out the first column of desks",
        "Remove all wobbly",
        "Put the chairs 50 cm apart along the north wall",
        "Move desk_1 to the windowsill",
    ):
        try:
            edit = edit_room(scene, text)
        except InputError:
            continue
        assert not edit.complete, text
        assert edit.scene == scene, text


# --- what was read and done otherwise than it was said


def test_one_of_those_that_are_there_is_meant_where_the_others_stay() -> None:
    before = built(
        room(),
        ("sideboard_1", 5.7, 2.5, 180.0, "floor"),
        ("desk_1", 0.5, 2.6, 0.0, "floor"),
        ("dining_table_1", 3.0, 2.5, 90.0, "floor"),
        ("vase_1", 0.5, 2.3, 0.0, "desk_1"),
        ("vase_2", 5.7, 2.2, 0.0, "sideboard_1"),
        ("vase_3", 5.7, 2.8, 0.0, "sideboard_1"),
    )
    for said, moved in (
        ("Put one vase on the table and leave the others where they are", 1),
        ("Put one vase on the table and leave the others on the sideboard", 1),
        ("Put two vases on the table and leave the other where it is", 2),
    ):
        after = done(before, said).scene
        there = [p.id for p in after.placements if p.support == "dining_table_1"]
        assert len(after.placements) == len(before.placements), said
        assert len(there) == moved, said
        assert "on the sideboard" not in said or there == ["vase_1"], said


def test_a_back_against_a_wall_is_at_it() -> None:
    after = done(bedroom(), "I want the bed with its headboard against the south wall").scene
    assert measure(after, "against_wall", "bed_1", ("south_wall",)).holds


@pytest.mark.parametrize(
    ("said", "size"),
    [
        ("Replace the rug with a round one, 2 m in diameter", (2.0, 2.0)),
        ("Replace the rug with a 2 m by 1.4 m one", (1.4, 2.0)),
        ("Remove the rug. Add a round rug, 1.2 m in diameter", (1.2, 1.2)),
        ("Make the rug longer by half a metre", None),
    ],
)
def test_a_size_is_what_it_comes_to(said: str, size: tuple[float, float] | None) -> None:
    before = living()
    old = before["rug_1"].size
    wanted = size or (old[0], old[1] + 0.5)
    new = next(p for p in done(before, said).scene.placements if p.category == "rug")
    assert new.size[:2] == pytest.approx(wanted, abs=0.01)


def test_a_size_that_nothing_is_made_of_is_refused() -> None:
    for said in ("Add a round rug, 0.2 m in diameter", "Replace the rug with a round one, 0.2 m in diameter"):
        with pytest.raises(InputError, match=r"cannot be made|the nearest is"):
            edit_room(living(), said)


def test_a_single_thing_far_before_the_rows_is_in_none_and_a_row_goes_to_one_wall() -> None:
    seats = [(f"chair_{n + 1}", 2.0 + 0.9 * (n // 3), 1.5 + 1.0 * (n % 3), 0.0, "floor") for n in range(6)]
    before = built(room(), *seats, ("chair_7", 5.4, 2.5, 0.0, "floor"))
    after = done(before, "Remove the chairs in the front row").scene
    assert {p.id for p in before.placements} - {p.id for p in after.placements} == {"chair_4", "chair_5", "chair_6"}
    after = done(before, "Move the back row closer to the wall").scene
    assert {before[f"chair_{n}"].position[1] - after[f"chair_{n}"].position[1] for n in (1, 2, 3)} == {0.0}


def test_which_is_told_by_what_it_is_at_or_from_which_side() -> None:
    before = built(
        room(),
        ("bookcase_1", 1.0, 4.8, 270.0, "floor"),
        ("bookcase_2", 2.2, 4.8, 270.0, "floor"),
        ("sideboard_1", 5.7, 2.5, 180.0, "floor"),
        ("desk_1", 0.5, 1.6, 0.0, "floor"),
        ("plant_1", 0.5, 3.9, 0.0, "floor"),
        ("plant_2", 5.6, 0.5, 0.0, "floor"),
        ("vase_1", 0.5, 1.3, 0.0, "desk_1"),
        ("alarm_clock_1", 0.5, 1.9, 0.0, "desk_1"),
        ("alarm_clock_2", 5.7, 2.9, 0.0, "sideboard_1"),
    )
    assert "plant_1" not in done(before, "Remove the plant next to the bookcase").scene
    after = done(before, "Put the vase on the sideboard, next to the alarm clock").scene
    assert after["vase_1"].support == "sideboard_1"
    chairs = built(room(), *[(f"chair_{n + 1}", 4.0 - n, 4.7, 270.0, "floor") for n in range(3)])
    west = done(chairs, "Remove the first chair from the left").scene
    east = done(chairs, "Remove the first chair from the right").scene
    assert {p.id for p in west.placements} ^ {p.id for p in east.placements} == {"chair_1", "chair_3"}
    beside = done(bedroom(), "Put a book on the nightstand on the right").scene
    assert beside["book_1"].support == "nightstand_2"
    with pytest.raises(InputError, match="off the north wall"):
        edit_room(living(), "Take the picture off the north wall")


def test_each_of_several_may_be_told_by_a_part_of_the_room() -> None:
    tables = [(f"side_table_{n + 1}", 4.4, 4.4 - 3.6 * n, 0.0, "floor") for n in range(2)]
    after = done(built(room(), *tables), "Add a vase to every table by the window").scene
    assert [p.support for p in after.placements if p.category == "vase"] == ["side_table_1"]


def test_what_rests_on_a_shelf_goes_with_its_wall() -> None:
    before = built(room(), ("wall_shelf_1", 5.88, 2.5, 180.0, "wall"), ("vase_1", 5.88, 2.5, 0.0, "wall_shelf_1"))
    after = done(before, "Make the room 50 cm longer").scene
    assert after["vase_1"].support == "wall_shelf_1"
    assert after["vase_1"].position[0] - before["vase_1"].position[0] == pytest.approx(0.5, abs=0.01)


def test_a_bit_towards_a_thing_is_no_more_than_a_bit() -> None:
    before = living()
    after = done(before, "Turn the armchair a bit towards the desk").scene
    assert turn_between(before["armchair_1"].yaw, after["armchair_1"].yaw) == pytest.approx(15.0, abs=0.1)


def test_what_faces_each_other_comes_together_too() -> None:
    before = built(room(), ("armchair_1", 1.0, 2.5, 90.0, "floor"), ("armchair_2", 5.0, 2.5, 90.0, "floor"))
    after = done(before, "Bring both armchairs closer together so that they face each other").scene
    for one, other in (("armchair_1", "armchair_2"), ("armchair_2", "armchair_1")):
        assert measure(after, "facing", one, (other,)).holds
    assert after["armchair_2"].position[0] - after["armchair_1"].position[0] < 3.5


@pytest.mark.parametrize(
    "said",
    [
        "Move the desk to the window so that I can look outside when I work",
        "I don't like where the armchair is, put it next to the sideboard",
        "Get the armchair out of the corner and put it next to the sideboard",
        "Add two chairs at the ends of the desk",
    ],
)
def test_what_people_say_besides_is_understood(said: str) -> None:
    read = read_instruction(said, ["desk_1", "armchair_1", "sideboard_1"])
    assert not read.unknown
    assert all(not order.lost for order in read.orders)


def test_left_of_what_hangs_is_seen_by_who_looks_at_the_wall() -> None:
    before = built(room(), ("picture_1", 5.984, 1.5, 180.0, "wall"), ("picture_2", 5.984, 3.5, 180.0, "wall"))
    after = done(before, "Remove the left picture").scene
    assert [p.id for p in after.placements] == ["picture_1"]


def test_what_leaves_a_part_of_the_room_does_not_stay_there() -> None:
    before = built(room(), ("plant_1", 0.5, 4.5, 0.0, "floor"))
    for said in ("Move the plant from the corner to the window", "Move the plant from the north wall to the window"):
        assert done(before, said).scene["plant_1"].position != before["plant_1"].position


def test_what_stands_on_its_own_goes_where_something_was_taken_away() -> None:
    before = placed(placed(living(), "plant", 5.5, 0.5), "waste_bin", 0.3, 4.7)
    after = done(before, "Remove the plant and put the bin there").scene
    assert math.dist(after["waste_bin_1"].position[:2], (5.5, 0.5)) < 0.75


def test_nothing_small_is_put_on_the_thing_by_which_a_corner_is_told() -> None:
    before = built(room(), ("wardrobe_1", 0.35, 4.4, 0.0, "floor"), ("desk_1", 0.4, 1.5, 0.0, "floor"),
                   ("vase_1", 0.4, 1.5, 0.0, "desk_1"))  # fmt: skip
    edit = edit_room(before, "Put the vase in the corner by the wardrobe")
    assert edit.scene["vase_1"].support != "wardrobe_1"
    assert edit.complete == (edit.scene != before)


@pytest.mark.parametrize(
    ("said", "field", "count"),
    [
        ("Remove everything from the desk apart from the lamp", "spared", 1),
        ("Turn the chairs so they face away from the table", "backs", 1),
        ("Move the table and all its chairs to the window", "company", 1),
        ("Move the sofa another 20 cm to the left", "lengths", 1),
        ("Take the lamp, the book and the vase off the desk", "things", 3),
        ("Separate the desks in the front row by another 20 cm", "lengths", 1),
    ],
)
def test_what_an_order_says_is_taken_as_that(said: str, field: str, count: int) -> None:
    read = read_instruction(said)
    assert not read.unknown
    assert len(getattr(read.orders[0], field)) == count


def test_the_other_is_not_the_one_that_tells_which_is_meant() -> None:
    before = bedroom().without("table_lamp_2")
    after = done(before, "Put the lamp that is on the left nightstand on the other nightstand").scene
    moved = [p.id for p in after.placements if p.support != before[p.id].support]
    assert moved == ["table_lamp_1"]
    assert after["table_lamp_1"].support == "nightstand_2"


def test_what_stands_on_a_shelf_says_nothing_of_left_and_right() -> None:
    before = built(
        room(),
        ("bookcase_1", 1.0, 4.8, 270.0, "floor"),
        ("bookcase_2", 2.2, 4.8, 270.0, "floor"),
        ("alarm_clock_1", 1.0, 4.8, 270.0, "bookcase_1"),
    )
    assert "bookcase_1" not in done(before, "Remove the left bookcase and the alarm clock").scene


def test_objects_are_named_by_number_before_an_angle_and_as_number_two() -> None:
    for said in ("Turn desk 2 45 degrees", "Turn desk number 2 by 45 degrees"):
        order = read_instruction(said, OFFICE).orders[0]
        assert [phrase.noun.id for phrase in order.things] == ["desk_2"], said
        assert order.turn == 45.0


def test_what_is_at_either_of_two_is_meant_and_not_the_second_of_them() -> None:
    for said in ("Remove the monitors on desk_1 and desk_2", "Replace the monitors on desks 1 and 2 with laptops"):
        order = read_instruction(said, OFFICE).orders[0]
        assert [phrase.noun.value for phrase in order.things] == ["monitor", "monitor"], said
        assert [phrase.places[0].noun.id for phrase in order.things if phrase.places[0].noun] == ["desk_1", "desk_2"]


def test_its_left_is_that_of_what_the_thing_before_stands_by() -> None:
    order = read_instruction("Move the bin to the left of the desk and the cabinet to its right").orders[0]
    assert not order.direction
    (where,) = order.things[1].places
    assert (where.word, where.noun.value if where.noun else "") == ("right_of", "desk")


def test_in_the_middle_is_of_what_it_stands_on() -> None:
    before = built(room(), ("dining_table_1", 1.5, 3.8, 90.0, "floor"), ("desk_1", 5.5, 1.5, 180.0, "floor"),
                   ("vase_1", 5.5, 1.5, 0.0, "desk_1"))  # fmt: skip
    after = done(before, "Put the vase on the table, in the middle").scene
    assert math.dist(after["vase_1"].position[:2], (1.5, 3.8)) < 0.3


def test_away_from_the_wall_is_away_from_the_one_behind() -> None:
    before = built(rectangle(6.0, 5.0), ("bed_1", 5.2, 3.9, 270.0, "floor"))
    after = done(before, "Move the bed 20 cm away from the wall").scene
    x, y, _ = before["bed_1"].position
    assert after["bed_1"].position[:2] == pytest.approx((x, y - 0.2), abs=0.01)


def test_all_that_could_be_meant_stays_where_one_is_to_stay() -> None:
    before = built(room(), ("desk_1", 0.5, 2.6, 0.0, "floor"), ("sideboard_1", 5.7, 2.5, 180.0, "floor"),
                   ("vase_1", 0.5, 2.3, 0.0, "desk_1"), ("vase_2", 5.7, 2.2, 0.0, "sideboard_1"),
                   ("bowl_1", 0.5, 2.9, 0.0, "desk_1"))  # fmt: skip
    after = done(before, "Clear the desk but leave the vase").scene
    assert {p.id for p in before.placements} - {p.id for p in after.placements} == {"bowl_1"}


def test_what_stands_at_a_wall_is_on_it_and_a_corner_that_is_still_empty_is_empty() -> None:
    before = built(room(), ("chair_1", 0.28, 2.5, 0.0, "floor"), ("chair_2", 3.0, 0.28, 90.0, "floor"))
    assert "chair_1" not in done(before, "Remove the chair on the west wall").scene
    with pytest.raises(InputError, match="on the east wall"):
        edit_room(before, "Remove the chair on the east wall")
    for said in ("Add a plant in every corner that is still empty", "Add a plant in every empty corner"):
        order = read_instruction(said).orders[0]
        assert [phrase.noun.value for phrase in order.things] == ["plant"], said
        assert [w.noun.states for w in order.things[0].places if w.noun] == [["empty"]], said


def test_what_is_centred_between_two_things_stays_as_far_from_the_wall_as_it_was_put() -> None:
    before = bedroom().moved("bed_1", position=(2.9, 3.9, 0.0))
    after = done(before, "Move the bed 20 cm away from the wall and centre it between the nightstands").scene
    assert after["bed_1"].position[:2] == pytest.approx((3.0, 3.7), abs=0.03)


def test_all_that_stands_in_rows_goes_to_the_front_or_the_back_that_it_looks_to() -> None:
    before = classroom()
    after = done(before, "Move every desk 10 cm to the back").scene
    moved = {
        (round(new.position[0] - old.position[0], 2), round(new.position[1] - old.position[1], 2))
        for old, new in zip(before.placements, after.placements, strict=True)
        if old.category == "school_desk"
    }
    assert moved == {(-0.1, 0.0)}


def test_what_moves_with_a_row_moves_once() -> None:
    before = classroom()
    after = done(before, "Move the first row 20 cm forward, chairs included").scene
    steps = {
        round(math.dist(old.position, new.position), 3)
        for old, new in zip(before.placements, after.placements, strict=True)
    }
    assert steps == {0.0, 0.2}


def test_what_is_taken_along_stands_where_it_stood_beside() -> None:
    before = built(room(), ("desk_1", 0.4, 2.5, 0.0, "floor"), ("chair_1", 1.0, 2.5, 180.0, "floor"))
    after = done(before, "Move the desk 30 cm to the left and take the chair along").scene
    steps = [math.dist(before[id].position, after[id].position) for id in ("desk_1", "chair_1")]
    assert steps == pytest.approx([0.3, 0.3], abs=0.03)


@pytest.mark.parametrize(
    ("said", "yaw"), [("Turn the armchair to face north", 90.0), ("Turn the armchair so that it faces west", 180.0)]
)
def test_a_thing_faces_what_the_compass_says(said: str, yaw: float) -> None:
    before = built(room(), ("armchair_1", 3.0, 2.5, 0.0, "floor"))
    assert turn_between(done(before, said).scene["armchair_1"].yaw, yaw) <= 20.0


def test_so_far_into_the_room_is_away_from_the_wall() -> None:
    before = built(room(), ("sofa_1", 3.0, 0.6, 270.0, "floor"))
    after = done(before, "Move the sofa one metre into the room").scene
    assert after["sofa_1"].position[1] == pytest.approx(1.6, abs=0.03)


def test_the_window_wall_is_the_wall_with_the_window_where_one_has_windows() -> None:
    after = done(living(), "Move the sideboard to the window wall").scene
    assert measure(after, "against_wall", "sideboard_1", ("north_wall",)).holds
    several = rectangle(6.0, 5.0, openings=(*OPENINGS, structs.replace(OPENINGS[1], id="window_2", wall=3)))
    with pytest.raises(InputError, match="in north_wall and in west_wall"):
        edit_room(built(several, ("desk_1", 3.0, 0.5, 90.0, "floor")), "Move the desk to the window wall")


def test_the_other_end_is_not_that_at_which_a_thing_stands() -> None:
    before = built(room(), ("sofa_1", 3.0, 0.6, 90.0, "floor"), ("floor_lamp_1", 1.7, 0.5, 0.0, "floor"))
    after = done(before, "Put the lamp at the other end of the sofa").scene
    assert after["floor_lamp_1"].position[0] > 3.9


def test_one_sits_at_the_long_sides_of_a_table() -> None:
    before = built(room(), ("dining_table_1", 3.0, 2.5, 90.0, "floor"))
    after = done(before, "Add a chair at each side of the table").scene
    assert {round(abs(after["dining_table_1"].to_local(after[id].position[:2])[1]), 1) for id in
            ("chair_1", "chair_2")} == {0.0}  # fmt: skip


def _with_lamps(*carriers: str) -> Scene:
    rows = [("desk_1", 0.5, 2.5, 0.0, "floor"), ("sideboard_1", 5.7, 2.5, 180.0, "floor")]
    spots = {"desk_1": (0.5, 2.5), "sideboard_1": (5.7, 2.5)}
    lamps = [(f"table_lamp_{n + 1}", *spots[on], 0.0, on) for n, on in enumerate(carriers)]
    return built(room(), *rows, *lamps, ("vase_1", 5.7, 3.0, 0.0, "sideboard_1"))


def test_what_is_on_two_things_is_not_one_of_these() -> None:
    said = "Remove the lamps on the desk and the sideboard"
    after = done(_with_lamps("desk_1", "sideboard_1"), said).scene
    assert [p.id for p in after.placements] == ["desk_1", "sideboard_1", "vase_1"]
    with pytest.raises(InputError, match="in two orders"):
        edit_room(_with_lamps("desk_1"), said)


def test_the_lower_of_two_that_hang_is_told_by_how_high_it_hangs() -> None:
    before = built(room(), ("picture_1", 5.984, 1.0, 180.0, "wall"), ("picture_2", 5.984, 3.0, 180.0, "wall"))
    before = before.moved("picture_2", position=(5.984, 3.0, 0.6))
    assert "picture_2" not in done(before, "Remove the lower picture").scene


def test_the_left_of_those_at_one_wall_is_that_seen_by_who_looks_at_it() -> None:
    before = built(room(), ("bookcase_1", 2.0, 0.2, 90.0, "floor"), ("bookcase_2", 4.0, 0.2, 90.0, "floor"))
    assert "bookcase_2" not in done(before, "Remove the left bookcase").scene


@pytest.mark.parametrize("said", ["Clear the sideboard except the vase", "Clear the sideboard apart from the vase"])
def test_what_is_excepted_stays_on_what_is_cleared(said: str) -> None:
    after = done(_with_lamps("sideboard_1", "desk_1"), said).scene
    assert [p.id for p in after.placements] == ["desk_1", "sideboard_1", "table_lamp_2", "vase_1"]


def test_one_of_several_that_are_cleared_is_excepted() -> None:
    before = built(room(), ("desk_1", 0.5, 2.2, 0.0, "floor"), ("desk_2", 0.5, 4.0, 0.0, "floor"),
                   ("table_lamp_1", 0.5, 2.2, 0.0, "desk_1"), ("table_lamp_2", 0.5, 4.0, 0.0, "desk_2"))  # fmt: skip
    assert "table_lamp_2" in done(before, "Clear all desks except desk 2").scene


def test_where_things_go_is_not_what_is_excepted() -> None:
    order = read_instruction("Move everything on the desk except the lamp onto the shelf").orders[0]
    assert [(w.word, w.noun.word) for w in order.places if w.noun] == [("on", "desk"), ("on", "shelf")]
    assert [phrase.places for phrase in order.spared] == [[]]


def test_within_a_length_of_a_thing_and_facing_it() -> None:
    before = built(room(), ("armchair_1", 1.0, 4.3, 0.0, "floor"), ("coffee_table_1", 3.0, 2.0, 90.0, "floor"))
    after = done(before, "Bring the armchair within half a metre of the coffee table, facing it").scene
    assert gap(after, "armchair_1", "coffee_table_1") <= 0.52
    assert measure(after, "facing", "armchair_1", ("coffee_table_1",)).holds


def test_two_that_are_added_both_face_what_is_said() -> None:
    after = done(built(room(), ("desk_1", 0.4, 2.5, 0.0, "floor")), "Add two chairs, both facing the desk").scene
    assert all(measure(after, "facing", id, ("desk_1",)).holds for id in ("chair_1", "chair_2"))


def test_its_company_may_come_behind_a_comma() -> None:
    order = read_instruction("Move the desk to the middle of the room, its chair with it").orders[0]
    assert [phrase.noun.word for phrase in order.company] == ["chair"]
    assert [w.word for w in order.things[0].places] == ["to"]


def test_a_round_one_is_another_of_what_was_taken_away() -> None:
    after = done(living(), "Take the rug away and put a round one under the coffee table").scene
    assert [p.id for p in after.placements if p.category == "rug"] == ["rug_2"]
    assert "round" in after.asset_of(after["rug_2"]).attributes


def test_every_other_chair_is_counted_around_the_table() -> None:
    seats = ((2.6, 1.7, 90.0), (3.4, 1.7, 90.0), (2.6, 3.3, 270.0), (3.4, 3.3, 270.0))
    rows = [(f"chair_{n + 1}", x, y, yaw, "floor") for n, (x, y, yaw) in enumerate(seats)]
    after = done(built(room(), ("dining_table_1", 3.0, 2.5, 90.0, "floor"), *rows), "Remove every other chair").scene
    left = [after[id].position[:2] for id in ("chair_1", "chair_2", "chair_3", "chair_4") if id in after]
    assert len({y for _, y in left}) == len({x for x, _ in left}) == 2


def test_of_two_that_are_as_near_none_is_taken() -> None:
    before = built(room(), ("bookcase_1", 0.2, 1.0, 0.0, "floor"), ("armchair_1", 3.0, 1.5, 0.0, "floor"),
                   ("armchair_2", 3.0, 0.5, 0.0, "floor"))  # fmt: skip
    with pytest.raises(InputError, match="as near as each other"):
        edit_room(before, "Remove the armchair nearest the bookcase")


def test_to_its_left_is_beside_what_was_named_before() -> None:
    before = built(room(), ("tv_stand_1", 3.0, 0.3, 90.0, "floor"), ("plant_1", 5.0, 4.0, 90.0, "floor"))
    after = done(before, "Move the TV stand 20 cm forward and put the plant to its left").scene
    assert measure(after, "left_of", "plant_1", ("tv_stand_1",)).holds
    order = read_instruction("Move the plant 20 cm to its left").orders[0]
    assert (order.direction, order.lengths) == ("left", [(0.2, "")])


def test_so_many_at_each_place_are_so_many_at_each() -> None:
    before = dining(4)
    table = before["dining_table_1"]
    after = done(before, "Put two of the chairs on each side of the table").scene
    sides = [table.to_local(after[f"chair_{n + 1}"].position[:2])[0] > 0 for n in range(4)]
    assert sorted(sides) == [False, False, True, True]


def test_several_that_turn_to_face_something_are_one_order() -> None:
    read = read_instruction("Turn chair 1 and chair 2 to face the wall", ["chair_1", "chair_2"])
    assert [[phrase.id for phrase in order.things] for order in read.orders] == [["chair_1", "chair_2"]]


def test_an_order_may_begin_with_an_id_behind_and() -> None:
    read = read_instruction("Move plant 1 to where plant 2 is and remove plant 2", ["plant_1", "plant_2"])
    assert [order.doing for order in read.orders] == ["move", "remove"]
    assert not read.unknown


def test_chairs_too_go_along() -> None:
    assert read_instruction("Turn the table by 90 degrees, chairs too").orders[0].company


def test_a_range_of_numbers_is_all_of_them() -> None:
    ids = [f"chair_{n}" for n in range(1, 5)]
    for said in ("Remove chairs 1 to 4", "Remove chairs 1-4", "Replace chairs 1 through 4 with stools"):
        assert [phrase.id for phrase in read_instruction(said, ids).orders[0].things] == ids, said


@pytest.mark.parametrize("verb", ["put", "place", "hang", "push"])
def test_what_is_put_in_place_of_what_goes_does_not_go_itself(verb: str) -> None:
    read = read_instruction(f"Remove plant 1 and {verb} plant 2 there", ["plant_1", "plant_2"])
    assert [[phrase.id for phrase in order.things] for order in read.orders] == [["plant_1"], ["plant_2"]]


def test_a_verb_that_is_passed_over_is_told() -> None:
    read = read_instruction("Remove plant 1 and stand plant 2 there", ["plant_1", "plant_2"])
    assert len(read.orders) == 2 or read.unknown


def test_a_chair_stays_at_its_side_of_a_desk_that_is_turned_with_it() -> None:
    before = built(room(), ("desk_1", 5.6, 2.5, 180.0, "floor"), ("chair_1", 5.1, 2.5, 0.0, "floor"))
    edit = edit_room(before, "Turn the desk and its chair by 180 degrees")
    turned = edit.scene["desk_1"].to_local(edit.scene["chair_1"].position[:2])
    assert edit.failed or turned[0] > abs(turned[1])


def test_the_middle_row_is_that_of_an_odd_number() -> None:
    with pytest.raises(InputError, match="none is in the middle"):
        edit_room(classroom(), "Turn the desks in the middle row around")


@pytest.mark.parametrize(
    ("said", "says"),
    [
        ("Move the last school desk on the left by 20 cm to the north", "counted in several ways"),
        ("Move desk 1 to the front", "how far"),
        ("Put a lamp on each desk, in the back left corner", "could be a corner of the room"),
    ],
)
def test_what_can_be_meant_in_several_ways_is_asked(said: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        edit_room(classroom(), said)


def test_a_number_before_a_length_that_says_by_how_much_is_of_the_thing() -> None:
    ids = ["bookcase_1", "bookcase_2", "desk_1"]
    order = read_instruction("Move the desk away from bookcase 1 by 15 cm", ids).orders[0]
    assert ([phrase.id for _, phrase in order.closer], order.lengths) == (["bookcase_1"], [(0.15, "")])
    assert read_instruction("Add a desk 2 by 1 m", ["desk_2"]).orders[0].things[0].id == ""


def test_what_stands_side_by_side_somewhere_is_all_there() -> None:
    before = built(room(), ("bench_1", 1.0, 0.5, 90.0, "floor"), ("bench_2", 3.0, 0.5, 90.0, "floor"))
    edit = edit_room(before, "Put bench 1 and bench 2 side by side against the east wall")
    at = [measure(edit.scene, "against_wall", id, ("east_wall",)).holds for id in ("bench_1", "bench_2")]
    assert edit.failed or all(at)


def test_the_head_of_a_bed_is_at_the_wall_that_is_said() -> None:
    before = built(rectangle(6.0, 6.0, openings=OPENINGS[:1]), ("bed_1", 3.0, 3.0, 0.0, "floor"))
    after = done(before, "Turn the bed so that the head is at the north wall").scene
    assert turn_between(after["bed_1"].yaw, 270.0) < 2.0


def test_it_is_what_was_cleared_of_everything_else() -> None:
    after = done(_with_lamps("desk_1"), "Remove everything from the desk and put a bowl on it").scene
    assert [p.support for p in after.placements if p.category == "bowl"] == ["desk_1"]
