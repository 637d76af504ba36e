"""What "it" is after another edit or a statement, what is taken back in a sentence, and short names."""

import math

import pytest

from tests.edited_rooms import bedroom, built, living, room
from tests.test_editing_guard import done
from thinkblox import edit_room
from thinkblox.editing.joining import joined
from thinkblox.editing.reading import read_instruction
from thinkblox.errors import InputError


def test_it_is_what_the_edit_before_was_about() -> None:
    first = done(living(), "Move the armchair to the corner by the window")
    again = edit_room(first, "Turn it to face the desk and make it blue")
    assert {c.id for c in again.changes} == {"armchair_1"}
    assert any("of the edit before" in text for text in again.done)
    third = edit_room(again, "Put a stool next to it")
    assert math.dist(third.scene["stool_1"].position, third.scene["armchair_1"].position) < 1.5
    with pytest.raises(InputError, match="points at nothing"):
        edit_room(first.scene, "Turn it to face the desk")
    with pytest.raises(InputError, match="--undo"):
        edit_room(first, "Move it back")


def test_what_is_named_in_the_same_instruction_comes_before_the_edit_before() -> None:
    first = done(living(), "Turn the armchair around")
    again = edit_room(first, "Move the vase to the sideboard and turn it by 90 degrees")
    assert {c.id for c in again.changes} == {"vase_1"}


def test_there_is_where_the_edit_before_took_something_away() -> None:
    first = done(living(), "Remove the armchair")
    after = edit_room(first, "Put a floor lamp there instead").scene
    assert math.dist(after["floor_lamp_1"].position[:2], living()["armchair_1"].position[:2]) < 0.8


def test_where_it_was_is_where_what_was_moved_before_stood() -> None:
    after = done(living(), "Move the armchair next to the desk and put a stool where it was").scene
    assert math.dist(after["stool_1"].position[:2], living()["armchair_1"].position[:2]) < 0.8


@pytest.mark.parametrize(
    "said", ["The picture hangs too low, raise it 15 cm", "The picture hangs too low. Raise it by 15 cm."]
)
def test_it_is_what_a_statement_tells_of(said: str) -> None:
    after = done(living(), said).scene
    assert after["picture_1"].position[2] == pytest.approx(living()["picture_1"].position[2] + 0.15, abs=0.01)


@pytest.mark.parametrize(
    "said", ["Remove the sideboard the lamp was standing on", "Remove the sideboard it was standing on"]
)
def test_what_something_was_standing_on_is_known_from_the_edit_before(said: str) -> None:
    before = built(room(), ("sideboard_1", 5.7, 1.2, 180.0, "floor"), ("sideboard_2", 0.3, 2.6, 0.0, "floor"),
                   ("table_lamp_1", 5.7, 1.2, 0.0, "sideboard_1"))  # fmt: skip
    moved = done(before, "Move the lamp to sideboard 2")
    assert {c.id for c in edit_room(moved, said).changes} == {"sideboard_1"}
    assert "sideboard_2" not in edit_room(moved, "Remove the sideboard that the lamp stands on").scene
    one = done(before, "Move the lamp to sideboard 2 and remove the sideboard it was standing on").changes
    assert {c.id for c in one} == {"table_lamp_1", "sideboard_1"}
    with pytest.raises(InputError, match="is not understood"):
        edit_room(before, "Remove the sideboard the lamp")


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        (
            "Slide the wardrobe 40 cm towards the bed, no sorry, towards the door",
            "Slide the wardrobe 40 cm towards the door",
        ),
        ("Make the stool white and the rug black, no wait, yellow", "Make the stool white and the rug yellow"),
        ("Move the armchair 20 cm, make that 30 cm to the north", "Move the armchair 30 cm to the north"),
        ("Put the vase on the desk, I mean the shelf", "Put the vase on the shelf"),
        ("Move the sofa to the left of the bed, no, to the right of the bed", "Move the sofa to the right of the bed"),
        ("Remove the armchair, no wait, remove the desk", "Remove the desk"),
        ("Paint the wardrobe white, actually make it green", "Make the wardrobe green"),
        ("Add two stools, sorry, three stools next to the desk", "Add three stools next to the desk"),
        ("Turn the lamp, I mean the chair, to the door", "Turn the chair to the door"),
        ("Remove the rug. No wait, keep it", "Keep the rug"),
    ],
)
def test_what_is_taken_back_is_as_if_it_was_not_said(said: str, meant: str) -> None:
    def told(text: str) -> list[tuple[object, ...]]:
        read = read_instruction(text)
        assert not read.unknown, read
        return [
            (o.doing, [(p.noun.value, p.noun.count) for p in o.things], o.lengths, o.direction, o.looks,
             [(w.word, w.noun and w.noun.value) for p in o.things for w in p.places],
             [(near, p.noun.value) for near, p in o.closer], [n.value for n in o.facing])
            for o in read.orders
        ]  # fmt: skip

    assert told(said) == told(meant)


def test_a_word_of_courtesy_takes_nothing_back() -> None:
    (order,) = read_instruction("Actually, move the armchair 20 cm to the north").orders
    assert (order.doing, order.direction) == ("move", "north")
    for said in (
        "Move the desk to the window, sorry for the trouble",
        "Move the desk to the window, better for reading",
    ):
        (order,) = read_instruction(said).orders
        assert ("to", "window") in [(w.word, w.noun and w.noun.value) for p in order.things for w in p.places], said


def test_things_are_called_by_what_they_hold_and_whose_they_are() -> None:
    before = built(room(), ("sink_cabinet_1", 5.6, 2.0, 180.0, "floor"), ("fridge_1", 5.6, 4.0, 180.0, "floor"))
    assert {c.id for c in done(before, "Swap the fridge and the sink").changes} == {"sink_cabinet_1", "fridge_1"}
    read = read_instruction("Put a laptop on every second school desk and a globe on the teacher's")
    assert [w.noun.text for w in read.orders[0].things[-1].places if w.noun] == ["the teacher's desk"]
    with pytest.raises(InputError, match="no coffee"):
        edit_room(living(), "Remove the coffee")


def test_the_first_one_is_one_of_those_that_are_there() -> None:
    before = built(room(), ("stool_1", 3.0, 2.5, 90.0, "floor"))
    after = done(before, "Add a second stool to the left of the first one").scene
    assert after["stool_2"].position[0] < after["stool_1"].position[0]
    after = done(before, "Add a second stool beside the first one, same size").scene
    assert after["stool_2"].size == after["stool_1"].size


def test_looks_and_what_more_is_to_be_there_are_two_orders() -> None:
    after = done(living(), "I want the sofa in dark green and a couple of cushions on it").scene
    assert "green" in " ".join(after.asset_of(after["sofa_1"]).attributes)
    assert [p.support for p in after.placements if p.category == "pillow"] == ["sofa_1", "sofa_1"]


def test_a_list_behind_a_colon_is_added() -> None:
    read = read_instruction("Set the table: a glass and a fork next to every plate")
    assert [(o.doing, [p.noun.value for p in o.things]) for o in read.orders] == [("add", ["glass", "fork"])]
    assert not read.unknown


def test_kept_facing_is_turned_so_after_it_was_replaced() -> None:
    read = read_instruction("Replace both stools with chairs but keep them facing the desk")
    assert [o.doing for o in joined(read.orders)] == ["replace", "turn"]


def test_what_is_told_of_people_asks_for_nothing() -> None:
    read = read_instruction("We hired two more people, add two desks")
    assert (len(read.orders), read.unknown) == (1, ())
    assert read_instruction("We sat by the lamp, add a stool").unknown


def test_the_lamp_is_still_the_one_on_the_nightstand() -> None:
    assert {c.id for c in done(bedroom(), "Remove the left nightstand and its lamp").changes} == {
        "nightstand_1",
        "table_lamp_1",
    }
