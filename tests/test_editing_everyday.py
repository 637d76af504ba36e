"""What people say every day: one more of something, what to do otherwise, what goes along, words without a verb."""

import math

import pytest

from tests.edited_rooms import built, dining, living, room, same_but
from tests.test_editing_guard import done
from thinkblox import edit_room
from thinkblox.editing.reading import read_instruction
from thinkblox.errors import InputError
from thinkblox.scene.relations import measure


def test_another_one_is_of_what_was_named() -> None:
    before = built(room(), ("sofa_1", 3.0, 4.5, 270.0, "floor"), ("armchair_1", 4.5, 1.5, 90.0, "floor"))
    after = done(before, "Put a plant in the north-east corner and another one next to the armchair.").scene
    new = [p for p in after.placements if p.id not in before]
    assert [p.category for p in new] == ["plant", "plant"]
    assert any(measure(after, "next_to", p.id, ("armchair_1",)).holds for p in new)
    (order,) = read_instruction("Add a second armchair of the same kind next to the sofa").orders
    assert not order.lost
    assert order.things[0].noun.value == "armchair"


def test_looks_and_things_without_a_verb_are_read() -> None:
    (order,) = read_instruction("Red chairs.").orders
    assert (order.doing, order.looks, order.things[0].noun.value) == ("make", ["red"], "chair")
    before = dining()
    after = done(before, "A round table instead, please.").scene
    tables = [p for p in after.placements if "table" in p.category]
    assert [p.id for p in tables] == ["dining_table_1"]
    assert tables[0].size[0] == pytest.approx(tables[0].size[1], abs=0.01)


def test_what_is_to_be_done_otherwise_is_done_only_then() -> None:
    empty = built(room(), ("armchair_1", 3.0, 2.5, 90.0, "floor"))
    first = done(empty, "Put the armchair in the south-east corner, otherwise at the north wall.")
    assert any("was not needed" in note for note in first.notes)
    full = built(room(), ("wardrobe_1", 5.65, 0.62, 180.0, "floor"), ("armchair_1", 3.0, 2.5, 90.0, "floor"))
    second = done(
        full, "Put the armchair in the south-east corner; if it doesn't fit, put it in the north-west corner."
    )
    assert measure(second.scene, "in_corner", "armchair_1", ("north_wall", "west_wall")).holds
    assert any("so 'put it in the north-west corner' was done" in note for note in second.notes)
    third = done(full, "Put the armchair in the south-east corner and remove the wardrobe if it is in the way.")
    assert "wardrobe_1" not in third.scene
    assert measure(third.scene, "in_corner", "armchair_1", ("south_wall", "east_wall")).holds


def test_other_conditions_are_still_refused() -> None:
    with pytest.raises(InputError, match="condition"):
        edit_room(living(), "If the sofa is red, remove it")


def test_seats_go_along_with_a_table_where_that_is_said() -> None:
    before = dining(2)
    moved = done(before, "Move the dining table and its chairs 30 cm to the north").scene
    for id in ("chair_1", "chair_2"):
        assert math.dist(moved[id].position, before[id].position) == pytest.approx(0.3, abs=0.02)
    left = done(before, "Move the dining table 80 cm to the north")
    assert same_but(before, left.scene, "dining_table_1")
    assert any("stayed, away from dining_table_1" in note for note in left.report.notes)
    low = built(room(), ("coffee_table_1", 3.0, 2.5, 0.0, "floor"), ("armchair_1", 3.0, 1.6, 90.0, "floor"))
    after_low = done(low, "Move the coffee table 30 cm to the north").scene
    assert same_but(low, after_low, "coffee_table_1")


def test_what_stays_at_a_thing_follows_it() -> None:
    before = built(room(), ("desk_1", 2.6, 0.5, 90.0, "floor"), ("wardrobe_1", 4.9, 0.4, 90.0, "floor"))
    hung = done(before, "Hang a picture above the desk").scene
    after = done(hung, "Swap the desk and the wardrobe; the picture has to stay above the desk").scene
    assert measure(after, "above", "picture_1", ("desk_1",)).holds


def test_desks_come_to_stand_in_a_u() -> None:
    rows = [(f"desk_{n}", 1.5 + 1.7 * (n % 3), 1.5 + 2.0 * (n // 3), 90.0, "floor") for n in range(6)]
    after = done(built(room(9.0, 8.0), *rows), "Arrange the desks in a U").scene
    yaws = [round(after[f"desk_{n}"].yaw) % 360 for n in range(6)]
    assert sorted(yaws.count(yaw) for yaw in {*yaws}) == [2, 2, 2]


def test_what_goes_into_a_corner_stands_right_in_it() -> None:
    before = built(room(), ("sideboard_1", 4.6, 0.27, 90.0, "floor"))
    after = done(before, "Push the sideboard into the corner").scene
    assert max(x for x, _ in after["sideboard_1"].footprint.exterior.coords) > 5.85


def test_a_length_behind_the_comparison_is_what_the_side_is_to_be() -> None:
    after = done(built(room(), ("sofa_1", 3.0, 4.4, 270.0, "floor")), "Make the sofa longer, 2.5 m").scene
    assert max(after["sofa_1"].size[:2]) == pytest.approx(2.5, abs=0.01)


def test_an_area_that_is_named_by_two_things_is_told() -> None:
    with pytest.raises(InputError, match="no fireplace"):
        edit_room(living(), "Rearrange the sitting area around the fireplace")


def test_another_one_is_of_what_the_edit_before_named() -> None:
    first = done(built(room(), ("sofa_1", 3.0, 4.4, 270.0, "floor")), "Add a stool in the north-east corner")
    second = edit_room(first, "Add another one next to the sofa.")
    assert second.complete
    assert [p.category for p in second.scene.placements].count("stool") == 2
    assert any("taken to be another stool" in says for says in second.done)
