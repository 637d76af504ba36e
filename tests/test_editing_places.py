"""Where things come: on a top rather than on the floor, right where another hung, at the place that a table left."""

import math

import pytest

from tests.edited_rooms import bedroom, built, dining, room, same_but
from tests.test_editing_guard import done
from thinkblox import edit_room
from thinkblox.scene.relations import measure


@pytest.mark.parametrize("place", ["next to the window", "by the window", "at the window"])
def test_something_small_goes_onto_what_stands_by_a_window(place: str) -> None:
    before = built(
        room(),
        ("desk_1", 4.4, 4.6, 270.0, "floor"),
        ("sideboard_1", 0.3, 2.0, 0.0, "floor"),
        ("printer_1", 0.3, 2.0, 0.0, "sideboard_1"),
    )
    after = done(before, f"Put the printer {place}").scene
    assert after["printer_1"].support == "desk_1"
    assert same_but(before, after, "printer_1")


def test_something_small_that_comes_to_the_floor_is_told() -> None:
    before = built(room(), ("sideboard_1", 0.3, 2.0, 0.0, "floor"), ("printer_1", 0.3, 2.0, 0.0, "sideboard_1"))
    low = edit_room(before, "Put the printer next to the door")
    assert low.scene["printer_1"].support == "floor"
    assert any("printer_1 stands on the floor" in note for note in low.notes)
    said = edit_room(before, "Put the printer on the floor")
    assert not any("stands on the floor" in note for note in said.notes)


def test_nothing_goes_up_on_a_wardrobe_unasked() -> None:
    before = bedroom()
    after = edit_room(before, "Put the table lamp on the left by the door").scene
    assert all(after[id].support != "wardrobe_1" for id in ("table_lamp_1", "table_lamp_2"))


def test_what_hangs_takes_the_very_place_of_what_hung_there() -> None:
    before = built(room(), ("picture_1", 5.97, 2.2, 180.0, "wall"), ("clock_1", 5.97, 2.5, 180.0, "wall"))
    high = done(before.without("picture_1"), "Move the clock up by 40 cm").scene
    old = high["clock_1"]
    again = high.with_placement(before["picture_1"], before.asset_of(before["picture_1"]))
    after = done(again, "Take the clock away and put the picture where the clock was").scene["picture_1"]
    assert after.position[1] == pytest.approx(old.position[1], abs=0.02)
    middles = [p.position[2] + p.size[2] / 2 for p in (old, after)]
    assert middles[0] == pytest.approx(middles[1], abs=0.02)


@pytest.mark.parametrize("verb", ["Take {} away", "Remove {}", "Get rid of {}"])
def test_there_is_where_the_table_stood_and_not_one_of_its_chairs(verb: str) -> None:
    before = dining(2)
    table = before["dining_table_1"]
    after = done(before, f"{verb.format('the dining table and its chairs')} and put a rug there").scene
    (rug,) = (p for p in after.placements if p.category == "rug")
    assert math.dist(rug.position[:2], table.position[:2]) < 0.1


BEANBAGS = (("bean_bag_1", 1.0, 1.6, 0.0, "floor"), ("bean_bag_2", 5.0, 1.6, 180.0, "floor"))


@pytest.mark.parametrize(
    "said",
    [
        "The desk should be under the window and the beanbags next to each other",
        "Put the desk under the window and the beanbags side by side",
        "The beanbags should be next to each other and the desk under the window",
        "I want the desk under the window and the two beanbags next to each other",
    ],
)
def test_only_what_is_to_be_side_by_side_is_brought_together(said: str) -> None:
    before = built(room(), ("desk_1", 5.5, 3.4, 180.0, "floor"), *BEANBAGS)
    after = done(before, said).scene
    assert measure(after, "under", "desk_1", ("window_1",)).holds
    assert measure(after, "next_to", "bean_bag_1", ("bean_bag_2",)).holds
    assert not measure(after, "next_to", "bean_bag_1", ("desk_1",)).holds


def test_side_by_side_at_a_part_of_the_room_is_no_fault() -> None:
    before = built(room(), *BEANBAGS)
    edit_room(before, "Put the beanbags side by side by the window")
    edit_room(before, "Put the beanbags side by side by the door")


def test_what_stands_about_a_low_table_stays_when_that_becomes_another() -> None:
    before = built(
        room(),
        ("sofa_1", 3.0, 0.6, 90.0, "floor"),
        ("coffee_table_1", 3.0, 1.6, 90.0, "floor"),
        ("armchair_1", 1.6, 2.2, 330.0, "floor"),
    )
    after = done(before, "Replace the coffee table with a round one").scene
    assert same_but(before, after, "coffee_table_1")


def test_in_its_place_is_right_where_the_other_hung() -> None:
    before = built(room(), ("picture_1", 5.984, 2.5, 180.0, "wall"))
    before = done(before, "Add a clock on the east wall").scene
    old = before["picture_1"]
    after = done(before, "Take the picture down and hang the clock in its place").scene["clock_1"]
    assert after.position[1] == pytest.approx(old.position[1], abs=0.02)
    assert after.position[2] + after.size[2] / 2 == pytest.approx(old.position[2] + old.size[2] / 2, abs=0.02)


def test_turned_so_that_it_is_at_a_wall_is_brought_there() -> None:
    before = built(room(), ("sideboard_1", 3.0, 2.5, 270.0, "floor"))
    after = done(before, "Turn the sideboard by 90 degrees so that it stands against the east wall").scene
    assert measure(after, "against_wall", "sideboard_1", ("east_wall",)).holds


def test_seats_of_a_new_table_stand_at_all_its_sides() -> None:
    after = done(built(room()), "Add a round table with four chairs").scene
    (table,) = (p for p in after.placements if "table" in p.category)
    ways = sorted(round(p.yaw - table.yaw) % 360 for p in after.placements if p.category == "chair")
    assert len(ways) == len(set(ways)) == 4
    again = done(after, "Add another table with chairs").scene
    assert sum(p.category == "chair" for p in again.placements) == 8


def test_one_of_two_is_told_by_what_rests_on_it() -> None:
    before = bedroom().without("table_lamp_1")
    before = done(before, "Add a mug on the nightstand with the lamp").scene
    (mug,) = (p for p in before.placements if p.category == "cup")
    assert mug.support == before["table_lamp_2"].support


def test_the_other_side_of_a_door_is_across_from_where_it_stands() -> None:
    door = room(8.0, 5.0)
    after = done(built(door, ("plant_1", 4.6, 0.5, 0.0, "floor")), "Put the plant next to the window").scene
    assert measure(after, "next_to", "plant_1", ("window_1",)).holds
    other = done(after, "Put the plant on the other side of the window").scene
    assert all(measure(scene, "next_to", "plant_1", ("window_1",)).holds for scene in (after, other))
    middle = 0.5 * (after["plant_1"].position[0] + other["plant_1"].position[0])
    window = next(o for o in door.openings if o.id == "window_1")
    assert abs(middle - door.walls[2].point(window.offset + window.width / 2, 0.0)[0]) < 0.5


def test_a_seat_that_comes_to_look_at_a_wall_and_a_taken_corner_are_told() -> None:
    before = built(room(), ("sofa_1", 4.4, 4.5, 270.0, "floor"))
    blind = edit_room(before, "Turn the sofa around")
    assert any("sofa_1 looks at a wall" in note for note in blind.notes)
    assert not done(before, "Move the sofa to the middle of the room").notes
    full = built(room(), ("plant_1", 5.6, 4.6, 0.0, "floor"), ("stool_1", 3.0, 2.5, 0.0, "floor"))
    near = edit_room(full, "Put the stool in the north-east corner")
    told = [note for note in near.notes if "from the corner, in which plant_1 stands" in note]
    assert bool(told) == (not near.failed)
