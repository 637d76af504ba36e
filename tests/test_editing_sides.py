"""Sides, sizes and who sits where: "the northern bench", "2 by 3 metres", stools that are spread along their bar."""

import math

import pytest

from tests.edited_rooms import bedroom, built, dining, living, room, same_but
from tests.test_editing_guard import done
from thinkblox import Scene, edit_room
from thinkblox.editing.reading import read_instruction
from thinkblox.errors import InputError
from thinkblox.scene.relations import measure


def two_benches() -> Scene:
    return built(
        room(),
        ("workbench_1", 3.0, 3.6, 270.0, "floor"),
        ("workbench_2", 3.0, 1.4, 270.0, "floor"),
        ("microscope_1", 3.0, 3.6, 270.0, "workbench_1"),
    )


@pytest.mark.parametrize("word", ["north", "northern", "northernmost"])
def test_one_of_several_is_told_by_its_side_of_the_room(word: str) -> None:
    before = two_benches().without("microscope_1")
    assert "workbench_1" not in done(before, f"Remove the {word} workbench").scene
    assert "workbench_2" not in done(before, "Remove the south workbench").scene
    with pytest.raises(InputError, match="could be"):
        edit_room(before, "Remove the eastern workbench")


def test_so_many_or_half_of_them_are_told_by_a_side() -> None:
    rows = [(f"plant_{n}", 0.8 + 1.4 * n, 2.5, 0.0, "floor") for n in range(4)]
    before = built(room(), *rows)
    assert {p.id for p in done(before, "Remove the western plants").scene.placements} == {"plant_2", "plant_3"}
    assert {p.id for p in done(before, "Remove the three eastern plants").scene.placements} == {"plant_0"}


@pytest.mark.parametrize(
    "said",
    [
        "Move the microscope from the north workbench to the south one",
        "Move the microscope on the northern workbench to the southern one",
        "Put the microscope on the southern workbench",
        "Move the microscope on the northern workbench to the other one",
    ],
)
def test_from_one_to_the_other_of_two(said: str) -> None:
    before = two_benches()
    after = done(before, said).scene
    assert after["microscope_1"].support == "workbench_2"
    assert same_but(before, after, "microscope_1")


def test_to_the_left_one_is_no_direction() -> None:
    before = bedroom().without("table_lamp_1")
    other = done(before, "Move the lamp from the right nightstand to the left one").scene
    back = done(other, "Move the lamp from the left nightstand to the right one").scene
    supports = {before["table_lamp_2"].support, other["table_lamp_2"].support, back["table_lamp_2"].support}
    assert supports == {"nightstand_1", "nightstand_2"}
    (order,) = read_instruction("Move the sofa to the left").orders
    assert order.direction == "left"


@pytest.mark.parametrize(
    "said",
    ["Make the rug 2 by 3 m", "Make the rug bigger, 3 by 2 metres", "The rug should be bigger, it should be 2 by 3 m"],
)
def test_two_lengths_are_the_two_sides_of_a_thing(said: str) -> None:
    rug = done(living(), said).scene["rug_1"]
    assert sorted(rug.size[:2]) == pytest.approx([2.0, 3.0])


def test_a_bigger_one_is_that_which_is_there_made_so() -> None:
    before = bedroom()
    wide = done(before, "Get a bigger wardrobe, 1.5 m wide").scene
    assert wide["wardrobe_1"].size[1] == pytest.approx(1.5)
    assert same_but(before, wide, "wardrobe_1")
    plain = done(before, "Bring in a larger wardrobe").scene["wardrobe_1"]
    assert math.prod(plain.size) > math.prod(before["wardrobe_1"].size)


def test_the_second_of_two_things_is_told_by_what_follows_it() -> None:
    before = built(
        room(),
        ("sofa_1", 3.0, 0.6, 90.0, "floor"),
        ("plant_1", 5.6, 0.4, 0.0, "floor"),
        ("plant_2", 3.0, 4.0, 0.0, "floor"),
        ("stool_1", 4.5, 3.0, 0.0, "floor"),
    )
    after = done(before, "Put the stool between the sofa and the plant in the corner").scene
    assert measure(after, "between", "stool_1", ("sofa_1", "plant_1")).holds


def test_two_stand_side_by_side_across_from_a_third() -> None:
    before = built(
        room(),
        ("sofa_1", 3.0, 4.4, 270.0, "floor"),
        ("armchair_1", 0.6, 2.0, 0.0, "floor"),
        ("armchair_2", 5.4, 2.0, 180.0, "floor"),
    )
    after = done(before, "Put the two armchairs side by side opposite the sofa").scene
    assert measure(after, "next_to", "armchair_1", ("armchair_2",)).holds
    for id in ("armchair_1", "armchair_2"):
        assert after[id].yaw == pytest.approx(90.0, abs=2.0)


def test_so_that_everyone_can_see_it_turns_what_is_arranged() -> None:
    before = built(
        room(),
        ("tv_stand_1", 3.0, 4.7, 270.0, "floor"),
        ("tv_1", 3.0, 4.7, 270.0, "tv_stand_1"),
        ("armchair_1", 2.0, 2.0, 270.0, "floor"),
        ("armchair_2", 4.0, 2.0, 270.0, "floor"),
    )
    after = done(before, "Arrange the armchairs so that everyone can see the TV").scene
    assert all(measure(after, "facing", id, ("tv_1",)).holds for id in ("armchair_1", "armchair_2"))


@pytest.mark.parametrize("where", ["", " along the table", " at the table"])
def test_seats_are_spread_along_the_table_that_they_are_at(where: str) -> None:
    before = dining()
    after = done(before, f"Spread the chairs evenly{where}").scene
    table = before["dining_table_1"]
    lefts = sorted(table.to_local(after[id].position[:2])[1] for id in ("chair_1", "chair_2"))
    assert lefts[0] == pytest.approx(-lefts[1], abs=0.05)
    assert all(measure(after, "at", id, ("dining_table_1",)).holds for id in ("chair_1", "chair_2"))
    assert same_but(before, after, "chair_1", "chair_2")


def test_what_stands_at_a_wall_stands_at_one_beside_another_too() -> None:
    before = built(
        room(),
        ("stove_1", 2.0, 0.33, 90.0, "floor"),
        ("fridge_1", 0.4, 0.4, 90.0, "floor"),
        ("picture_1", 2.9, 0.02, 90.0, "wall"),
    )
    after = done(before, "Put the fridge on the other side of the stove").scene
    assert measure(after, "against_wall", "fridge_1", ("wall",)).holds


@pytest.mark.parametrize("said", ["in facing pairs", "in pairs facing each other", "into groups of two"])
def test_desks_come_in_pairs_that_face_each_other(said: str) -> None:
    rows = [(f"desk_{n}", 1.4 + 1.9 * (n % 2), 1.6 + 1.9 * (n // 2), 90.0, "floor") for n in range(4)]
    after = done(built(room(7.0, 6.0), *rows), f"Arrange the desks {said}").scene
    for n in range(4):
        desk = after[f"desk_{n}"]
        faced = [p for p in after.placements if p.id != desk.id and math.dist(p.position, desk.position) < 1.0]
        assert len(faced) == 1
        assert abs((faced[0].yaw - desk.yaw) % 360.0 - 180.0) < 1.0


@pytest.mark.parametrize("said", ["two plates with glasses", "two plates with a glass each"])
def test_a_glass_comes_beside_each_plate(said: str) -> None:
    before = dining()
    after = done(before, f"Put {said} on the table").scene
    new = [p for p in after.placements if p.id not in before]
    assert sorted(p.category for p in new) == ["glass", "glass", "plate", "plate"]
    assert all(p.support == "dining_table_1" for p in new)


@pytest.mark.slow
def test_room_for_something_is_found_or_told_and_nothing_changes() -> None:
    before = living()
    there = edit_room(before, "Make room for a stool")
    assert same_but(before, there.scene)
    assert len(there.scene.placements) == len(before.placements)
    assert "there is room for a stool" in there.done[0]
    full = edit_room(before, "Make room for 20 pool tables")
    assert full.scene == before
    assert not full.complete
    assert "no room for 20 pool tables" in full.failed[0]
