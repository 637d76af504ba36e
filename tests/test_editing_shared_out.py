"""So many of a kind with a place for each, what goes to a wall as it stands, and what is laid where somebody sits."""

import pytest

from tests.edited_rooms import built, dining, living, room
from tests.test_editing_guard import done
from tests.test_editing_unseen import ids
from thinkblox.editing.reading import read_instruction
from thinkblox.editing.wheres import walls_of
from thinkblox.scene.relations import measure


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Add two plants, one by the sofa and one in the corner", ["a plant", "a plant"]),
        ("Add two tall plants: one next to the sofa, the other by the desk", ["a tall plant", "a tall plant"]),
        ("Add three vases, one on the desk, one on the table and one on the sideboard", ["a vase"] * 3),
        ("Add 3 pictures, two on the north wall and one above the desk", ["2 pictures", "a picture"]),
        ("Add three books to the sideboard and one to the desk", ["three books", "one book"]),
        ("Move the two chairs, one to the door and the other to the desk", ["one chair", "the other chair"]),
    ],
)
def test_each_of_several_has_its_own_place(text: str, said: list[str]) -> None:
    read = read_instruction(text)
    phrases = [phrase for order in read.orders for phrase in order.things]
    assert [phrase.noun.text for phrase in phrases] == said
    assert all(phrase.places for phrase in phrases)
    assert not read.unknown


@pytest.mark.parametrize(
    "text",
    ["Add two plants, one by the sofa, one in the corner and one by the desk", "Add three plants, one by the sofa"],
)
def test_numbers_that_do_not_add_up_are_not_shared_out(text: str) -> None:
    phrases = [phrase for order in read_instruction(text).orders for phrase in order.things]
    assert [phrase.noun.text for phrase in phrases] != ["a plant"] * len(phrases)


def test_the_left_and_the_right_are_both_of_what_is_named_last() -> None:
    after = done(living(), "Add two stools, one on the left and one on the right of the coffee table").scene
    first, second = ids(after, "stool")
    assert measure(after, "left_of", first, ("coffee_table_1",)).holds
    assert measure(after, "right_of", second, ("coffee_table_1",)).holds


@pytest.mark.parametrize("where", ["at every seat", "by each chair", "in front of every chair"])
def test_what_is_put_at_a_seat_lies_before_it(where: str) -> None:
    after = done(dining(), f"Put a plate {where}").scene
    for plate, chair in zip(ids(after, "plate"), ids(after, "chair"), strict=True):
        assert after[plate].support == "dining_table_1"
        assert abs(after[chair].to_local(after[plate].position[:2])[1]) <= 0.25


def test_what_is_pushed_to_the_wall_keeps_its_back_to_it() -> None:
    before = built(room(), ("sofa_1", 2.8, 2.5, 0.0, "floor"), ("bookcase_1", 2.0, 4.8, 270.0, "floor"))
    after = done(before, "Push the sofa against the wall").scene
    assert after["sofa_1"].yaw == before["sofa_1"].yaw
    assert measure(after, "against_wall", "sofa_1", ("west_wall",)).holds


def test_corners_of_a_side_are_those_and_no_others() -> None:
    before = built(room(), ("plant_1", 5.5, 4.5, 270.0, "floor"), ("plant_2", 0.5, 0.5, 0.0, "floor"))
    far = walls_of(before, "far_wall")
    assert [measure(before, "in_corner", id, (far,)).holds for id in ("plant_1", "plant_2")].count(True) == 1
    after = done(before, "Move the plants to the back corners").scene
    assert all(measure(after, "in_corner", id, (far,)).holds for id in ("plant_1", "plant_2"))
    desk = built(room(), ("desk_1", 3.0, 2.5, 0.0, "floor"))
    assert len(ids(done(desk, "Add a stool in the back corners").scene, "stool")) == 2
