"""How people speak of a room without thinking of orders: why, what for, without a verb, and of what belongs."""

import math

import pytest

from tests.edited_rooms import OPENINGS, SOURCE, bedroom, built, dining, living, room, same_but
from tests.test_editing_guard import done
from thinkblox import edit_room
from thinkblox.editing.reading import read_instruction
from thinkblox.editing.reading.accounting import signature
from thinkblox.editing.rows import MIDDLE_ROW, rows_of
from thinkblox.errors import InputError
from thinkblox.scene.landmarks import things
from thinkblox.scene.nearby import BACK_GAP
from thinkblox.scene.relations import measure
from thinkblox.scene.room import Opening, rectangle
from thinkblox.scene.support import placed_at


@pytest.mark.parametrize(
    "text",
    [
        "Add a lamp by the sofa, so that I can read there in the evening",
        "Add a lamp by the sofa so the kids can draw",
        "Add a lamp by the sofa because it is dark there",
        "Because it is so dark there, add a lamp by the sofa",
        "Since I work at night, add a lamp by the sofa",
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


def places(text: str, number: int = -1) -> list[list[tuple[str, str]]]:
    """The places of each thing of an order, by relation and what they are of."""
    order = read_instruction(text).orders[number]
    return [[(w.word, w.noun.value if w.noun else "") for w in phrase.places] for phrase in order.things]


def test_things_are_told_by_what_was_said_before() -> None:
    assert places("I need a second desk next to mine") == [[("next_to", "desk")]]
    assert places("I need a second desk for my colleague, next to ours") == [[("next_to", "desk")]]
    (order,) = read_instruction("Put a lamp on each nightstand and a book on the one on the left").orders
    last = order.things[1].places[0].noun
    assert last is not None
    assert (last.value, last.side) == ("nightstand", "left")
    before = built(
        room(), ("desk_1", 1.0, 2.0, 0.0, "floor"), ("bookcase_1", 5.75, 2.5, 180.0, "floor"),
        ("desk_lamp_1", 1.0, 2.0, 0.0, "desk_1"),
    )  # fmt: skip
    after = done(before, "Put the desk lamp on the desk and move both of them next to the bookcase").scene
    assert after["desk_lamp_1"].support == "desk_1"
    assert measure(after, "next_to", "desk_1", ("bookcase_1",)).holds


def test_between_them_is_between_the_two_that_were_named() -> None:
    before = built(
        room(), ("sofa_1", 3.0, 0.6, 90.0, "floor"), ("desk_1", 3.0, 4.5, 270.0, "floor"),
        ("floor_lamp_1", 0.4, 4.6, 0.0, "floor"),
    )  # fmt: skip
    after = done(before, "Make the sofa red and the desk black; then put the lamp between them").scene
    assert measure(after, "between", "floor_lamp_1", ("sofa_1", "desk_1")).holds


def test_the_nearest_one_is_turned_where_it_is() -> None:
    before = built(
        room(), ("armchair_1", 1.5, 1.8, 0.0, "floor"), ("armchair_2", 4.5, 3.8, 0.0, "floor"),
        ("sofa_1", 3.0, 4.4, 270.0, "floor"),
    )  # fmt: skip
    after = done(before, "The armchair closest to the door should look at the sofa").scene
    assert same_but(before, after, "armchair_1")
    assert measure(after, "facing", "armchair_1", ("sofa_1",)).holds


@pytest.mark.parametrize(
    ("text", "doing", "expected"),
    [
        ("Set the table with six plates", "add", [[("to", "any_table")]]),
        ("Lay the table for four people", "add", [[("to", "any_table")]]),
        ("I'd rather have the bench under the window than at the foot of the bed", "put", [[("under", "window")]]),
        ("I'd rather have a bench than a sofa", "replace", [[]]),
        ("Move the toaster onto it", "move", [[("on", "it")]]),
        ("Place the stools to one from each side of the table", "put", [[("on", "side")]]),
        ("Push the bookcases together against the north wall", "move", [[("against", "north_wall")]]),
        ("Add a shelf for toys", "add", [[]]),
    ],
)
def test_other_ways_to_say_it(text: str, doing: str, expected: list[list[tuple[str, str]]]) -> None:
    read = read_instruction(text)
    assert read.orders[0].doing == doing
    assert places(text, 0) == expected
    assert not read.unknown


def test_instead_of_it_is_in_its_place() -> None:
    first, second = read_instruction("Remove the wardrobe; instead of it I want a shelf for toys").orders
    assert (first.doing, second.doing, second.there) == ("remove", "put", True)


def test_two_for_several_go_where_one_of_each_is_said_to_be() -> None:
    (order,) = read_instruction("Replace the chairs with two benches, one on each long side of the table").orders
    assert [p.noun.value for p in order.things] == ["chair"]
    assert [(w.word, w.noun and w.noun.value) for w in order.instead[0].places] == [("on", "long_side")]


def test_a_rug_that_lies_there_is_not_added_again() -> None:
    before = built(room(), ("rug_1", 3.0, 2.5, 0.0, "floor"), ("dining_table_1", 3.0, 2.5, 0.0, "floor"))
    edit = done(before, "Add a rug under the table, and set it with two plates")
    assert [p.category for p in edit.scene.placements] == ["rug", "dining_table", "plate", "plate"]
    assert {p.support for p in edit.scene.placements if p.category == "plate"} == {"dining_table_1"}


def test_the_middle_row_of_desks_is_theirs() -> None:
    (order,) = read_instruction("Remove the middle row of desks").orders
    assert [(p.noun.value, p.noun.rows, p.noun.ordinal) for p in order.things] == [("desk", 1, MIDDLE_ROW)]


def test_beside_a_thing_is_found_in_the_open_floor() -> None:
    before = built(
        room(4.0, 3.3), ("plant_1", 3.6, 2.9, 180.0, "floor"), ("desk_1", 2.6, 2.92, 270.0, "floor"),
        ("armchair_1", 0.53, 2.7, 315.0, "floor"),
    )  # fmt: skip
    after = done(before, "Put the armchair beside the plant").scene
    assert measure(after, "next_to", "armchair_1", ("plant_1",)).holds
    assert same_but(before, after, "armchair_1")


def test_desks_are_arranged_in_rows_and_in_groups() -> None:
    before = built(
        room(7.0, 6.0),
        *((f"school_desk_{n + 1}", 2.0 + 1.0 * n, 3.0, 270.0, "floor") for n in range(4)),
        *((f"chair_{n + 1}", 2.0 + 1.0 * n, 2.55, 90.0, "floor") for n in range(4)),
    )
    rows = done(before, "Arrange the desks in two rows").scene
    desks = [rows[f"school_desk_{n + 1}"] for n in range(4)]
    assert sorted(map(len, rows_of(rows, desks))) == [2, 2]
    for scene in (rows, done(before, "Push the desks together into two groups of two").scene):
        for n in range(4):
            assert measure(scene, "at", f"chair_{n + 1}", (f"school_desk_{n + 1}",)).holds
    again = edit_room(rows, "Arrange the desks in two rows of two")
    assert again.complete
    assert again.scene == rows
    with pytest.raises(InputError, match="there are 4 of them"):
        edit_room(before, "Arrange the desks in two rows of three")


def test_what_stands_on_something_is_put_higher() -> None:
    before = built(
        room(), ("desk_1", 1.0, 2.0, 0.0, "floor"), ("bookcase_1", 5.75, 2.5, 180.0, "floor"),
        ("globe_1", 1.0, 2.0, 0.0, "desk_1"),
    )  # fmt: skip
    after = done(before, "Put the globe somewhere higher").scene
    assert after["globe_1"].position[2] > before["globe_1"].position[2] + 0.1
    assert after["globe_1"].size == before["globe_1"].size


def test_the_end_of_a_sofa_is_beside_it() -> None:
    before = built(room(), ("sofa_1", 3.0, 0.6, 90.0, "floor"), ("coffee_table_1", 3.0, 1.9, 90.0, "floor"))
    after = done(before, "Put the coffee table at the end of the sofa").scene
    assert any(measure(after, side, "coffee_table_1", ("sofa_1",)).holds for side in ("left_of", "right_of"))


@pytest.mark.parametrize(
    ("text", "doing", "things"),
    [
        ("The kids need more space, so move the table to the wall", "move", ["any_table"]),
        ("The kids keep bumping into the table, so move it to the wall", "move", ["any_table"]),
        ("Get rid of the rug and the bench, we never use them", "remove", ["rug", "bench"]),
        ("If there is a plant, move it next to the window", "move", ["plant"]),
        ("Turn the sofa so that it doesn't face the window any more", "turn", ["sofa"]),
        ("Put the candles on the table, one at each end", "put", ["candle"]),
    ],
)
def test_what_is_told_besides_is_no_order(text: str, doing: str, things: list[str]) -> None:
    read = read_instruction(text)
    assert [(order.doing, [p.noun.value for p in order.things]) for order in read.orders] == [(doing, things)]
    assert not read.unknown


def test_it_is_what_the_things_are_for() -> None:
    (order,) = read_instruction("Give me a desk under the window with a chair and a lamp on it").orders
    said = [(w.word, w.noun.value) for w in order.things[0].places if w.noun is not None]
    assert said == [("under", "window"), ("with", "chair"), ("with", "any_lamp")]
    (order,) = read_instruction("Put the table under the window and two of the chairs on each side of it").orders
    assert [w.whole and w.whole.value for w in order.things[1].places] == ["any_table"]


def test_as_many_things_change_places_one_with_one() -> None:
    before = built(
        room(), ("armchair_1", 1.5, 2.2, 0.0, "floor"), ("armchair_2", 4.5, 2.2, 180.0, "floor"),
        ("bookcase_1", 2.0, 4.75, 270.0, "floor"), ("bookcase_2", 5.75, 4.0, 180.0, "floor"),
    )  # fmt: skip
    after = edit_room(before, "Swap the two bookcases with the armchairs").scene
    for n in (1, 2):
        for one, other in ((f"armchair_{n}", f"bookcase_{n}"), (f"bookcase_{n}", f"armchair_{n}")):
            assert math.dist(after[one].position[:2], before[other].position[:2]) < 0.7


def test_back_to_back_where_the_first_has_no_room_behind_it() -> None:
    before = built(room(), ("sofa_1", 3.0, 0.6, 90.0, "floor"), ("desk_1", 0.5, 3.0, 0.0, "floor"))
    after = done(before, "Place the sofa and the desk back to back").scene
    gaze, other = (things(after, id)[0].yaw for id in ("sofa_1", "desk_1"))
    assert abs((gaze - other) % 360.0 - 180.0) < 1.0


def test_a_table_is_made_with_so_many_chairs() -> None:
    edit = edit_room(dining(2), "Make the table square and bigger, with four chairs")
    assert not edit.failed
    assert sum(p.category == "chair" for p in edit.scene.placements) == 4
    theirs = edit_room(dining(2), "Make the table round with its chairs")
    assert theirs.complete


def test_the_other_side_of_the_room_is_its_other_half() -> None:
    before = built(
        room(6.0, 4.0), ("desk_1", 0.5, 2.0, 0.0, "floor"), ("chair_1", 1.0, 2.0, 180.0, "floor"),
        ("bed_1", 4.9, 2.0, 180.0, "floor"), ("nightstand_1", 5.75, 3.3, 180.0, "floor"),
        ("nightstand_2", 5.75, 0.7, 180.0, "floor"),
    )  # fmt: skip
    after = edit_room(before, "Move the desk to the other side of the room and put the chair in front of it").scene
    assert after["desk_1"].position[0] > 3.0
    assert measure(after, "at", "chair_1", ("desk_1",)).holds
    assert same_but(before, after, "desk_1", "chair_1")


def test_what_carries_nothing_is_named() -> None:
    before = built(room(), ("bean_bag_1", 3.0, 3.0, 0.0, "floor"), ("desk_1", 1.0, 1.0, 0.0, "floor"),
                   ("teddy_bear_1", 1.0, 1.0, 0.0, "desk_1"))  # fmt: skip
    (failed,) = edit_room(before, "Put the teddy bear on the bean bag").failed
    assert "bean_bag_1 has no flat top" in failed


def test_what_stands_at_a_wall_comes_closer_along_it() -> None:
    before = built(
        room(), ("sideboard_1", 0.3, 1.5, 0.0, "floor"), ("wardrobe_1", 5.65, 3.0, 180.0, "floor"),
    )  # fmt: skip
    after = done(before, "Move the sideboard closer to the wardrobe").scene
    assert measure(after, "against_wall", "sideboard_1", ("wall",)).holds


def test_the_desk_without_one_is_that_which_has_none() -> None:
    before = built(
        room(), ("desk_1", 2.5, 2.0, 0.0, "floor"), ("chair_1", 3.1, 2.0, 180.0, "floor"),
        ("desk_2", 4.0, 3.5, 0.0, "floor"),
    )  # fmt: skip
    after = done(before, "Put a chair at the desk without one").scene
    assert measure(after, "at", "chair_2", ("desk_2",)).holds


def test_a_row_of_seats_at_a_wall_grows_at_its_ends() -> None:
    before = built(room(), *((f"chair_{n + 1}", 2.2 + 0.5 * n, 4.7, 270.0, "floor") for n in range(3)))
    after = done(before, "Add two more chairs to the row along the wall").scene
    assert sorted(p.category for p in after.placements) == ["chair"] * 5
    assert len({round(p.position[1], 2) for p in after.placements}) == 1


def test_several_things_face_one_window() -> None:
    second = Opening(id="window_2", kind="window", wall=3, offset=1.5, width=1.6, height=1.2, sill=0.9)
    before = built(
        rectangle(6.0, 5.0, openings=(*OPENINGS, second)),
        ("armchair_1", 1.5, 1.6, 0.0, "floor"), ("armchair_2", 2.8, 3.4, 0.0, "floor"),
    )  # fmt: skip
    after = done(before, "Turn both armchairs so that they face the window").scene
    ids, windows = ("armchair_1", "armchair_2"), ("window_1", "window_2")
    assert any(all(measure(after, "facing", id, (window,)).holds for id in ids) for window in windows)


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("Move the plant to the window, it needs light.", "Move the plant to the window."),
        (
            "Move the plant to the window, it needs more sunlight, and remove the rug",
            "Move the plant to the window and remove the rug",
        ),
        ("Move the plant to the window because it needs light.", "Move the plant to the window."),
        ("Put a small table next to the armchair for my tea.", "Put a small table next to the armchair."),
        ("Add a lamp by the bed for reading in the evening", "Add a lamp by the bed"),
        ("Put the towel rack closer to the bathtub so I can reach it.", "Put the towel rack closer to the bathtub."),
    ],
)  # fmt: skip
def test_what_something_is_for_furnishes_nothing(said: str, plain: str) -> None:
    read, meant = read_instruction(said), read_instruction(plain)
    assert signature(list(read.orders)) == signature(list(meant.orders))
    assert read.unknown == meant.unknown == ()


def test_a_sink_goes_along_with_its_cabinet() -> None:
    before = built(room(), ("base_cabinet_1", 1.0, 0.35, 90.0, "floor"), ("sink_1", 1.0, 0.35, 90.0, "base_cabinet_1"))
    edit = done(before, "I would like the sink under the window")
    assert edit.scene["sink_1"].support == "base_cabinet_1"
    assert any("sink_1 is let into base_cabinet_1" in note for note in edit.notes)
    assert measure(edit.scene, "under", "base_cabinet_1", ("window_1",)).holds


def test_a_sink_is_not_put_on_the_floor() -> None:
    before = built(room(), ("base_cabinet_1", 1.0, 0.35, 90.0, "floor"), ("sink_1", 1.0, 0.35, 90.0, "base_cabinet_1"))
    edit = edit_room(before, "Move the sink to the window, but leave the base cabinet where it is")
    assert edit.scene["sink_1"].support == "base_cabinet_1"
    assert edit.failed


def test_that_wall_is_the_one_at_which_stood_what_is_gone() -> None:
    before = built(room(), ("wardrobe_1", 5.65, 4.0, 180.0, "floor"), ("sideboard_1", 0.3, 2.5, 0.0, "floor"))
    after = done(before, "Remove the wardrobe and center the sideboard on that wall").scene
    assert measure(after, "against_wall", "sideboard_1", ("east_wall",)).holds
    assert after["sideboard_1"].position[1] == pytest.approx(2.5, abs=0.1)


def test_what_comes_behind_a_new_thing_is_behind_it() -> None:
    orders = read_instruction("Add an armchair near the window, with a floor lamp behind it").orders
    assert [order.doing for order in orders] == ["add", "add"]
    assert [(w.word, w.noun.text) for w in orders[1].things[0].places if w.noun is not None] == [("behind", "it")]


def test_what_is_beside_what_a_thing_stands_before_is_not_before_it() -> None:
    before = built(room(), ("stove_1", 1.0, 0.35, 90.0, "floor"), ("bath_mat_1", 1.0, 2.0, 90.0, "floor"),
                   ("coffee_table_1", 2.3, 1.8, 0.0, "floor"))  # fmt: skip
    for said, id in (("Put the coffee table in front of the stove", "coffee_table_1"),
                     ("Put the mat in front of the stove", "bath_mat_1")):  # fmt: skip
        after = edit_room(before, said).scene
        assert after[id] != before[id]
        assert abs(after[id].position[0] - 1.0) < 0.5


def test_a_mat_is_the_one_that_there_is_and_it_gets_a_chair() -> None:
    before = built(room(), ("bath_mat_1", 1.0, 2.0, 90.0, "floor"), ("desk_1", 4.6, 1.0, 0.0, "floor"))
    assert same_but(before, done(before, "Remove the mat").scene, "bath_mat_1")
    after = done(before, "Move the desk under the window and get it a chair").scene
    assert measure(after, "at", "chair_1", ("desk_1",)).holds


def test_what_stays_on_a_thing_goes_where_that_goes() -> None:
    before = built(room(), ("desk_1", 1.0, 1.0, 0.0, "floor"), ("table_lamp_1", 1.0, 1.0, 0.0, "desk_1"),
                   ("bookcase_1", 4.6, 3.0, 180.0, "floor"))  # fmt: skip
    for said in ("Move the desk to the middle of the room; the lamp stays on the desk",
                 "Swap the bookcase with the desk; the lamp stays on the desk"):  # fmt: skip
        edit = done(before, said)
        assert edit.scene["table_lamp_1"].support == "desk_1"
        assert "table_lamp_1 stays on desk_1" in edit.done


def test_a_place_before_what_goes_along_is_refused_and_breaks_nothing() -> None:
    before = built(room(), ("desk_1", 1.0, 1.0, 0.0, "floor"), ("chair_1", 1.7, 1.0, 180.0, "floor"))
    edit_room(before, "Move the desk to the middle of the room, with the chair behind it, facing the door.")


@pytest.mark.parametrize("said", ["Add a plant and please no clock.", "Add a plant, but please no clock."])
def test_what_is_not_wanted_is_not_added(said: str) -> None:
    with pytest.raises(InputError, match="no clock"):
        edit_room(built(room(), ("desk_1", 1.0, 1.0, 0.0, "floor")), said)
