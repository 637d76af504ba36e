"""Instructions as people say them, in which one thing is said of several, or by words that stand for other words."""

import pytest

from tests.edited_rooms import bedroom, built, dining, living, placed, room
from tests.test_editing_guard import done
from thinkblox import Scene, edit_room
from thinkblox.editing.reading import read_instruction
from thinkblox.errors import InputError
from thinkblox.scene.relations import measure


def ids(scene: Scene, category: str) -> list[str]:
    return [p.id for p in scene.placements if p.category == category]


def set_out() -> Scene:
    """A table with two chairs at either of its long sides."""
    chairs = [(f"chair_{n + 1}", 2.6 + 0.8 * (n % 2), 1.75 if n < 2 else 3.25, 90.0 if n < 2 else 270.0, "floor")
              for n in range(4)]  # fmt: skip
    return built(room(), ("dining_table_1", 3.0, 2.5, 90.0, "floor"), *chairs)


def test_what_comes_there_stands_on_what_carried_what_is_gone() -> None:
    after = done(bedroom(), "Remove the lamp on the left nightstand and put an alarm clock there instead").scene
    (clock,) = ids(after, "alarm_clock")
    (lamp,) = ids(after, "table_lamp")
    assert {after[clock].support, after[lamp].support} == {"nightstand_1", "nightstand_2"}


def test_what_comes_with_something_that_has_a_place_is_on_it() -> None:
    after = done(bedroom(), "Add a bench at the foot of the bed with a blanket on it").scene
    assert after["blanket_1"].support == "bench_1"


def test_a_known_thing_is_put_where_it_is_said_to_be_to_another() -> None:
    before = built(room(), ("armchair_1", 3.0, 2.5, 90.0, "floor"), ("floor_lamp_1", 5.0, 4.0, 0.0, "floor"))
    after = done(before, "Put the armchair in the middle of the room with the lamp behind it").scene
    assert measure(after, "behind", "floor_lamp_1", ("armchair_1",)).holds
    (first, second) = read_instruction(
        "Put the armchair by the window with the lamp on its left", ["armchair_1"]
    ).orders
    assert [phrase.noun.text for phrase in (*first.things, *second.things)] == ["the armchair", "the lamp"]


def test_the_place_of_what_comes_along_is_that_of_what_it_comes_with() -> None:
    after = done(built(room(7.0, 6.0)), "Add two desks with chairs and monitors along the east wall").scene
    assert all(measure(after, "against_wall", id, ("east_wall",)).holds for id in ids(after, "desk"))
    assert sorted(after[id].support for id in ids(after, "monitor")) == ["desk_1", "desk_2"]


def test_a_bare_noun_behind_and_belongs_to_the_same_place() -> None:
    (order,) = read_instruction("lay a rug under the armchair and side table", ["armchair_1", "side_table_1"]).orders
    assert [where.noun.text for where in order.things[0].places if where.noun] == ["the armchair", "side table"]
    assert len(order.things) == 1


def test_why_something_is_taken_away_brings_nothing() -> None:
    before = placed(living(), "floor_lamp", 1.0, 4.5)
    after = done(before, "Remove the floor lamp, we want more light").scene
    assert not ids(after, "floor_lamp")


def test_light_is_one_lamp() -> None:
    assert len(ids(done(living(), "I need more light on the desk").scene, "desk_lamp")) == 1


def test_books_are_rows_and_stacks_of_books_too() -> None:
    before = built(room(), ("desk_1", 0.5, 2.6, 0.0, "floor"), ("book_1", 0.5, 2.2, 0.0, "desk_1"),
                   ("book_stack_1", 0.5, 3.0, 0.0, "desk_1"))  # fmt: skip
    after = done(before, "Throw out all the books").scene
    assert not ids(after, "book")
    assert not ids(after, "book_stack")


def test_a_table_is_set_before_its_seats() -> None:
    after = done(set_out(), "Set the table for four with plates, glasses and a candle in the middle").scene
    plates = ids(after, "plate")
    assert len(plates) == len(ids(after, "glass")) == 4
    for chair in ids(after, "chair"):
        assert any(measure(after, "in_front_of", plate, (chair,)).holds for plate in plates)
    assert measure(after, "in_centre", "candle_1", ("dining_table_1",)).holds


def test_a_table_for_so_many_is_one() -> None:
    after = done(dining(), "Replace the table with a round one that seats six").scene
    assert "for-6" in after.asset_of(after["dining_table_1"]).attributes


def test_so_that_eight_can_sit_there_asks_for_their_chairs() -> None:
    after = done(set_out(), "Make the table longer so that six can sit at it and add the chairs").scene
    assert len(ids(after, "chair")) == 6


def test_what_a_sentence_tells_of_is_it_whatever_it_does() -> None:
    before = placed(living(), "grandfather_clock", 0.4, 4.4)
    after = done(before, "The big clock ticks too loudly, get rid of it and put a plant there").scene
    assert not ids(after, "grandfather_clock")
    assert len(after.placements) == len(before.placements)


def test_left_of_who_looks_at_a_thing_is_to_its_own_right() -> None:
    after = done(living(), "Put a plant to the left of the sideboard as seen when standing in front of it").scene
    (plant,) = [p.id for p in after.placements if "plant" in p.category]
    assert measure(after, "right_of", plant, ("sideboard_1",)).holds


def test_what_is_said_more_of_the_same_things_is_done_to_them() -> None:
    after = done(living(), "I want the desk under the window and painted white").scene
    assert "white" in after.asset_of(after["desk_1"]).attributes
    assert measure(after, "under", "desk_1", ("window_1",)).holds


def test_some_of_those_named_before_stay_as_they_are() -> None:
    after = done(set_out(), "Paint the chairs green, but leave two of them as they are").scene
    assert sum("green" in after.asset_of(after[id]).attributes for id in ids(after, "chair")) == 2


def test_closer_has_a_bound() -> None:
    before = living()
    after = done(before, "Move the armchair closer to the sofa but not closer than 50 cm").scene
    assert after["armchair_1"] != before["armchair_1"]
    (order,) = read_instruction("move it closer to the sofa but not closer than 50 cm").orders
    assert order.bound == "ge"
    assert order.apart[0][0] == pytest.approx(0.5)


def test_all_but_one_of_the_places_get_something() -> None:
    desk = built(room(), ("desk_1", 0.5, 2.6, 0.0, "floor"))
    two = placed(placed(desk, "dining_table", 2.5, 4.0), "dining_table", 4.5, 1.0)
    after = done(two, "Put a vase on every dining table but the one nearest to the desk").scene
    assert [after[id].support for id in ids(after, "vase")] == ["dining_table_2"]


def test_a_thing_that_is_told_by_its_colour_alone_is_found() -> None:
    red = done(living(), "Make the armchair red").scene
    after = done(red, "Remove the red one").scene
    assert not ids(after, "armchair")
    with pytest.raises(InputError, match="purple one"):
        edit_room(red, "Remove the purple one")


def test_several_new_things_stand_side_by_side() -> None:
    after = done(
        built(room(7.0, 6.0), ("sofa_1", 3.5, 0.6, 90.0, "floor")), "two armchairs side by side opposite the sofa"
    )
    first, second = ids(after.scene, "armchair")
    assert measure(after.scene, "next_to", second, (first,)).holds
    assert all(measure(after.scene, "facing", id, ("sofa_1",)).holds for id in (first, second))


def test_a_layout_is_not_mirrored_and_says_so() -> None:
    with pytest.raises(InputError, match="not mirrored"):
        edit_room(living(), "Mirror the layout")


def on_desk() -> Scene:
    """A desk at the west wall with a laptop in its middle and a lamp on its left."""
    rows = [("desk_1", 0.45, 2.6, 0.0, "floor"), ("laptop_1", 0.45, 2.6, 0.0, "desk_1")]
    return built(room(), *rows, ("desk_lamp_1", 0.35, 3.05, 0.0, "desk_1"))


def test_left_and_right_in_one_sentence_are_those_of_one_thing() -> None:
    before = on_desk()
    after = done(before, "Move the laptop to the left side of the desk and the lamp to the right").scene
    across = [after["desk_1"].to_local(after[id].position[:2])[1] for id in ("laptop_1", "desk_lamp_1")]
    assert across[0] * across[1] < 0
    places = [w for o in read_instruction("Put the chair left of the sofa and the lamp right of it").orders
              for phrase in o.things for w in phrase.places]  # fmt: skip
    assert [where.noun.text for where in places if where.noun] == ["the sofa", "the sofa"]


def test_what_is_hung_by_what_hangs_is_at_its_height() -> None:
    rows = [("picture_1", 5.984, 1.0, 180.0, "wall"), ("picture_2", 5.984, 4.0, 180.0, "wall")]
    before = built(room(), *rows)
    after = done(before, "Hang a picture between the two pictures").scene
    assert after["picture_3"].position[2] == pytest.approx(before["picture_1"].position[2], abs=0.05)


def test_what_is_excepted_has_to_be_there() -> None:
    with pytest.raises(InputError, match="'the plant' is not on coffee_table_1"):
        edit_room(placed(living(), "plant", 0.6, 4.3), "Clear the coffee table except for the plant")


def test_the_edge_of_a_top_is_on_it() -> None:
    after = done(living(), "Put a candle at the edge of the coffee table").scene
    assert after["candle_1"].support == "coffee_table_1"


def test_instead_of_a_place_is_not_there() -> None:
    (order,) = read_instruction("Put the rug in front of the wardrobe instead of under the bed").orders
    assert [(where.word, where.negated) for where in order.things[0].places] == [
        ("in_front_of", False),
        ("under", True),
    ]


def test_what_goes_along_does_not_tell_the_wall() -> None:
    (order,) = read_instruction("Move the bed to the opposite wall with both nightstands").orders
    assert [where.noun.text for where in order.things[0].places if where.noun] == ["the opposite wall"]
    assert [phrase.noun.text for phrase in order.company] == ["both nightstands"]


def test_before_it_is_before_what_carries_it() -> None:
    after = done(living(), "Put a plate on the sideboard and a stool in front of it").scene
    assert measure(after, "in_front_of", "stool_1", ("sideboard_1",)).holds


def test_what_somebody_thinks_of_a_thing_asks_for_nothing() -> None:
    after = done(living(), "Get rid of the armchair, it's ugly. Put a stool there").scene
    assert not ids(after, "armchair")
    assert len(ids(after, "stool")) == 1


def test_what_is_closer_together_is_told_by_its_place() -> None:
    with pytest.raises(InputError, match="no chair by the window"):
        edit_room(dining(), "Bring the chairs by the window closer together")


def test_it_is_faced_where_it_went() -> None:
    after = done(living(), "Move the armchair closer to the sofa and turn it to face it").scene
    assert measure(after, "facing", "armchair_1", ("sofa_1",)).holds


def test_another_place_is_not_where_it_is_said_not_to_be() -> None:
    after = done(living(), "The desk is in a bad spot, find a better one for it, but not in front of the window").scene
    assert after["desk_1"] != living()["desk_1"]
    assert not measure(after, "in_front_of", "desk_1", ("window_1",)).holds
    (order,) = read_instruction("Find another place for the desk, not by the window").orders
    assert [where.negated for where in order.things[0].places] == [True]


def test_what_is_announced_is_of_everything_there() -> None:
    before = built(room(), ("desk_1", 0.5, 2.6, 0.0, "floor"), ("cup_1", 0.5, 2.3, 0.0, "desk_1"),
                   ("book_1", 0.5, 2.9, 0.0, "desk_1"), ("sideboard_1", 5.7, 2.5, 180.0, "floor"))  # fmt: skip
    after = done(before, "Tidy the desk: everything except the book goes onto the sideboard").scene
    assert (after["cup_1"].support, after["book_1"].support) == ("sideboard_1", "desk_1")


def test_seats_that_are_left_by_what_is_pushed_together_are_told() -> None:
    rows = [("dining_table_1", 1.5, 2.5, 90.0, "floor"), ("dining_table_2", 4.4, 2.5, 90.0, "floor")]
    before = built(room(), *rows, ("chair_1", 4.4, 1.75, 90.0, "floor"), ("chair_2", 1.5, 1.75, 90.0, "floor"))
    edit = done(before, "Push the two tables together to make one long table")
    assert any("stayed, away from dining_table" in note for note in edit.notes)


def test_a_rug_under_them_is_under_each() -> None:
    before = built(room(), ("armchair_1", 4.0, 3.0, 180.0, "floor"))
    after = done(before, "Put two stools on the floor next to the armchair and a rug under them").scene
    assert all(measure(after, "under", "rug_1", (stool,)).holds for stool in ids(after, "stool"))


def test_several_across_from_one_thing_stand_beside_each_other() -> None:
    before = built(room(7.0, 6.0), ("sofa_1", 3.5, 0.6, 90.0, "floor"))
    after = done(before, "We often have guests, add two armchairs opposite the sofa").scene
    first, second = ids(after, "armchair")
    assert measure(after, "next_to", second, (first,)).holds
