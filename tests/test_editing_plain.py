"""How people speak of a room without thinking of orders: why, what for, without a verb, and of what belongs."""

import math

import pytest

from tests.edited_rooms import SOURCE, bedroom, built, dining, living, room, same_but
from tests.test_editing_guard import done
from thinkblox import edit_room
from thinkblox.editing.reading import read_instruction
from thinkblox.errors import InputError
from thinkblox.scene.landmarks import things
from thinkblox.scene.nearby import BACK_GAP
from thinkblox.scene.relations import measure
from thinkblox.scene.support import placed_at


@pytest.mark.parametrize(
    "text",
    [
        "Add a lamp by the sofa, so that I can read there in the evening",
        "Add a lamp by the sofa so the kids can draw",
        "Add a lamp by the sofa because it is dark there",
        "Because it is so dark there, add a lamp by the sofa",
        "Add a lamp by the sofa so I can put my book under it",
    ],
)
def test_what_for_and_why_ask_for_nothing(text: str) -> None:
    read = read_instruction(text)
    assert [order.doing for order in read.orders] == ["add"]
    assert not read.unknown
    assert not read.orders[0].free
    assert [(w.word, w.noun and w.noun.value) for w in read.orders[0].things[0].places] == [("by", "sofa")]


def test_what_people_are_to_get_to_is_no_mere_purpose() -> None:
    (order,) = read_instruction("Move the bed so that I can get to the window").orders
    assert [noun.value for noun in order.free] == ["window"]


@pytest.mark.parametrize(
    ("text", "things"),
    [
        ("Turn the bed so that I can see the door from it", ["bed"]),
        ("I can't see the door from the bed, turn it please", ["bed"]),
        ("Turn the desk so that the person sitting there sees the door", ["desk"]),
        ("Turn the sofa so we can watch the door", ["sofa"]),
    ],
)
def test_what_somebody_is_to_see_is_what_a_thing_is_to_face(text: str, things: list[str]) -> None:
    read = read_instruction(text)
    (order,) = read.orders
    assert (order.doing, [p.noun.value for p in order.things]) == ("turn", things)
    assert [noun.value for noun in order.facing] == ["door"]
    assert not read.unknown


def test_a_wide_thing_is_faced_wherever_it_is_looked_at() -> None:
    before = built(room(), ("desk_1", 3.9, 4.55, 270.0, "floor"))
    edit = edit_room(before, "Turn the desk so that I look out of the window when I work")
    assert edit.complete
    assert edit.scene == before


def test_what_is_said_without_a_verb_is_where_a_known_thing_goes() -> None:
    before = bedroom()
    after = done(before, "wardrobe next to the door").scene
    assert [p.id for p in after.placements] == [p.id for p in before.placements]
    assert measure(after, "next_to", "wardrobe_1", ("door",)).holds
    read = read_instruction("Desk under the window, bookcase to its right")
    assert [[w.word for w in p.places] for p in read.orders[0].things] == [["under"], ["right_of"]]
    assert read.orders[0].things[1].places[0].noun == read.orders[0].things[0].noun
    for text in ("The room is too dark", "What is on the table?", "hello there"):
        with pytest.raises(InputError):
            read_instruction(text)


def test_away_from_one_place_and_into_another() -> None:
    (order,) = read_instruction("Move the bed away from the window, into the corner").orders
    assert [p.noun.value for _, p in order.closer] == ["window"]
    assert not order.closer[0][1].places
    before = living()
    after = done(before, "Move the armchair away from the sideboard, into the corner").scene
    assert measure(after, "in_corner", "armchair_1", ("corner",)).holds


def test_what_comes_where_something_stood_stands_on_the_floor_as_that_did() -> None:
    before = built(room(), ("side_table_1", 2.0, 2.5, 0.0, "floor"), ("armchair_1", 2.6, 2.5, 0.0, "floor"))
    after = done(before, "Take away the side table and put a plant there").scene
    (new,) = [p for p in after.placements if p.id not in before]
    assert new.support == "floor"
    assert math.dist(new.position, before["side_table_1"].position) < 0.1


def test_what_is_new_on_what_is_moved_is_added() -> None:
    read = read_instruction("Put the chair by the bed with an alarm clock on it")
    assert [order.doing for order in read.orders] == ["put", "add"]


def test_seats_are_drawn_up_to_what_their_table_becomes() -> None:
    before = dining(2)
    after = done(before, "Make the table round").scene
    assert after["dining_table_1"].size[0] == pytest.approx(after["dining_table_1"].size[1], abs=0.05)
    for id in ("chair_1", "chair_2"):
        mark, table = things(after, id)[0], things(after, "dining_table_1")[0]
        way = math.degrees(math.atan2(table.centre[1] - mark.centre[1], table.centre[0] - mark.centre[0]))
        assert abs((mark.gaze - way + 180.0) % 360.0 - 180.0) < 30.0
        assert measure(after, "at", id, ("dining_table_1",)).holds
    black = done(before, "Make the table black and keep the chairs around it").scene
    assert same_but(before, black, "dining_table_1")


def test_a_hood_goes_where_its_stove_goes() -> None:
    before = built(
        room(), ("stove_1", 3.0, 0.33, 90.0, "floor"), ("fridge_1", 5.0, 0.37, 90.0, "floor"),
    )  # fmt: skip
    hood = SOURCE.make("range_hood", seed=3)
    place = placed_at(before, hood, id="range_hood_1", position=(3.0, hood.size[0] / 2 + BACK_GAP, 1.65), yaw=90.0)
    before = before.with_placement(place, hood)
    assert measure(before, "above", "range_hood_1", ("stove_1",)).holds
    for text in ("Swap the fridge and the stove", "Move the stove 50 cm to the left"):
        after = done(before, text).scene
        assert after["stove_1"] != before["stove_1"]
        assert measure(after, "above", "range_hood_1", ("stove_1",)).holds


def test_two_things_that_cannot_change_places_stay() -> None:
    before = built(
        room(), ("bathtub_1", 4.0, 4.55, 270.0, "floor"), ("toilet_1", 0.35, 2.5, 0.0, "floor"),
        ("washbasin_1", 0.3, 1.9, 0.0, "floor"), ("laundry_basket_1", 0.25, 3.1, 0.0, "floor"),
        ("wardrobe_1", 0.4, 4.0, 0.0, "floor"),
    )  # fmt: skip
    edit = edit_room(before, "Swap the toilet and the bathtub")
    assert edit.failed
    assert edit.scene == before
