"""What instructions mean beyond their words: what belongs together, which of several, where from, and how many."""

import pytest

from tests.edited_rooms import bedroom, built, dining, living, room
from tests.test_editing_guard import classroom, done
from thinkblox import edit_room
from thinkblox.editing.reading import read_instruction
from thinkblox.errors import InputError
from thinkblox.scene.relations import measure
from thinkblox.scene.room import turn_between

OFFICE = ("desk_1", "desk_2", "office_chair_1", "office_chair_2", "laptop_1", "whiteboard_1")


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
        "spread the chairs around the room",
    ):
        try:
            edit = edit_room(scene, text)
        except InputError:
            continue
        assert not edit.complete, text
        assert edit.scene == scene, text
