"""What is held closely: between, next to a plate, whose a thing is, straight at it, face to face, lengthwise."""

import math

import pytest
from shapely import LineString

from tests.edited_rooms import bedroom, built, living, placed, room
from tests.test_editing_guard import done
from thinkblox import Scene, edit_room
from thinkblox.errors import InputError
from thinkblox.scene.bearings import bearing, ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.relations import measure
from thinkblox.scene.room import turn_between


def gap(scene: Scene, one: str, other: str) -> float:
    return ground_gap(things(scene, one)[0], things(scene, other)[0])


def off(scene: Scene, id: str, other: str) -> float:
    """How far a thing looks past another [degrees]."""
    return turn_between(scene[id].yaw, bearing(scene[id].position[:2], scene[other].position[:2]))


def table() -> Scene:
    """A round table with four chairs and a plate before each."""
    rows = [("dining_table_1", 3.0, 2.5, 90.0, "floor")]
    rows += [("chair_1", 2.6, 1.75, 90.0, "floor"), ("chair_2", 3.4, 1.75, 90.0, "floor")]
    rows += [("plate_1", 2.6, 2.2, 0.0, "dining_table_1"), ("plate_2", 3.4, 2.2, 0.0, "dining_table_1")]
    return built(room(), *rows)


def office() -> Scene:
    """Two desks with a chair each, at the east and the west wall."""
    rows = [("desk_1", 0.4, 2.5, 0.0, "floor"), ("chair_1", 0.95, 2.5, 180.0, "floor")]
    rows += [("desk_2", 5.6, 2.5, 180.0, "floor"), ("chair_2", 5.05, 2.5, 0.0, "floor")]
    return built(room(), *rows)


@pytest.mark.parametrize(
    "said",
    ["Angle the armchair towards the vase", "Point the armchair at the vase", "Turn the armchair straight to it"],
)
def test_what_is_angled_looks_straight_at_its_mark(said: str) -> None:
    before = placed(built(room(), ("stool_1", 3.0, 2.5, 0.0, "floor")), "armchair", 1.0, 1.6, 0.0)
    after = done(before, said.replace("it", "the stool").replace("the vase", "the stool")).scene
    assert off(before, "armchair_1", "stool_1") > 20.0
    assert off(after, "armchair_1", "stool_1") < 5.0
    assert math.dist(after["armchair_1"].position, before["armchair_1"].position) < 0.1


def test_what_looks_about_there_is_left_where_it_cannot_look_straight() -> None:
    before = built(room(), ("sofa_1", 3.0, 0.6, 90.0, "floor"), ("stool_1", 3.3, 3.5, 0.0, "floor"))
    after = done(before, "Turn the sofa to face the stool").scene
    assert after["sofa_1"] == before["sofa_1"]


def test_between_two_things_is_in_the_gap_between_them() -> None:
    before = built(room(), ("armchair_1", 0.5, 3.2, 0.0, "floor"), ("armchair_2", 0.5, 1.8, 0.0, "floor"),
                   ("stool_1", 4.0, 2.5, 0.0, "floor"))  # fmt: skip
    after = done(before, "Put the stool between the two armchairs").scene
    assert after["stool_1"].position[:2] == pytest.approx((0.5, 2.5), abs=0.15)
    assert {c.id for c in done(before, "The stool should stand between the armchairs").changes} == {"stool_1"}


def test_two_things_without_a_gap_are_moved_apart_for_what_comes_between() -> None:
    before = built(room(), ("armchair_1", 0.5, 2.6, 0.0, "floor"), ("armchair_2", 0.5, 1.8, 0.0, "floor"),
                   ("stool_1", 4.0, 2.5, 0.0, "floor"))  # fmt: skip
    edit = done(before, "Put the stool in between armchair 1 and armchair 2")
    spots = [edit.scene[id].position[1] for id in ("armchair_2", "stool_1", "armchair_1")]
    assert spots == sorted(spots)
    assert any("to make room for stool_1" in text for text in edit.done)
    kept = edit_room(before, "Put the stool between the armchairs, but keep both armchairs where they are")
    assert kept.failed


def test_what_is_next_to_a_plate_is_nearest_to_that_plate() -> None:
    after = done(table(), "Add a glass and a fork next to every plate").scene
    for kind in ("glass", "fork"):
        for n in (1, 2):
            own, other = (gap(after, f"{kind}_{n}", f"plate_{m}") for m in (n, 3 - n))
            assert own < 0.16, f"{kind}_{n}"
            assert own < other, f"{kind}_{n}"


@pytest.mark.parametrize(
    ("said", "gone"),
    [("Remove chair 1 and its plate", {"chair_1", "plate_1"}),
     ("Take away chair 2 and the plate in front of it", {"chair_2", "plate_2"}),
     ("Remove chairs 1 and 2 and their plates", {"chair_1", "chair_2", "plate_1", "plate_2"})],
)  # fmt: skip
def test_its_plate_is_the_one_that_lies_before_the_chair(said: str, gone: set[str]) -> None:
    assert {c.id for c in done(table(), said).changes} == gone


@pytest.mark.parametrize(
    ("said", "desks"),
    [("Add two desks with a chair and a table lamp each", 2), ("Add two desks, each with a chair and a table lamp", 2),
     ("Add a desk with a chair and a table lamp", 1)],
)  # fmt: skip
def test_what_comes_with_each_new_thing_is_at_it(said: str, desks: int) -> None:
    before = built(room(), ("desk_1", 0.4, 2.5, 0.0, "floor"))
    after = done(before, said).scene
    new = [f"desk_{n + 2}" for n in range(desks)]
    assert sorted(p.support for p in after.placements if p.category == "table_lamp") == new
    assert all(any(measure(after, "at", f"chair_{n + 1}", (id,)).holds for n in range(desks)) for id in new)


def test_face_to_face_in_the_middle_the_desks_meet_with_their_chairs_outside() -> None:
    for said in ("Bring desks 1 and 2 together face to face in the middle of the room",
                 "Put desks 1 and 2 back to back in the centre"):  # fmt: skip
        after = done(office(), said).scene
        assert gap(after, "desk_1", "desk_2") < 0.03, said
        assert all(math.dist(after[f"desk_{n}"].position[:2], (3.0, 2.5)) < 1.0 for n in (1, 2)), said
        assert turn_between(after["desk_1"].yaw, after["desk_2"].yaw) > 178.0, said
        for n in (1, 2):
            assert measure(after, "at", f"chair_{n}", (f"desk_{n}",)).holds, said
            assert gap(after, f"chair_{n}", f"desk_{3 - n}") > 0.3, said


def test_face_to_face_two_seats_look_at_each_other_and_stand_apart() -> None:
    before = built(room(), ("armchair_1", 1.0, 4.2, 270.0, "floor"), ("armchair_2", 5.0, 0.8, 90.0, "floor"))
    after = done(before, "Put the armchairs face to face").scene
    assert after["armchair_1"] == before["armchair_1"]
    assert off(after, "armchair_1", "armchair_2") < 2.0
    assert off(after, "armchair_2", "armchair_1") < 2.0
    assert gap(after, "armchair_1", "armchair_2") == pytest.approx(1.0, abs=0.5)
    with pytest.raises(InputError, match="back to back"):
        edit_room(before, "Turn the armchairs back to back")


def test_what_turns_with_its_chair_is_pulled_out_from_its_wall() -> None:
    after = done(office(), "Turn all the desks and their chairs around").scene
    for n, yaw in ((1, 180.0), (2, 0.0)):
        assert turn_between(after[f"desk_{n}"].yaw, yaw) < 2.0
        assert measure(after, "at", f"chair_{n}", (f"desk_{n}",)).holds
    assert after["chair_1"].position[0] < after["desk_1"].position[0]


def test_a_long_or_short_side_comes_along_a_wall() -> None:
    after = done(
        built(room(), ("desk_1", 3.0, 2.5, 0.0, "floor")), "Turn the desk so that its long side is along the north wall"
    ).scene
    assert turn_between(after["desk_1"].yaw, 270.0) < 2.0
    after = done(
        built(room(), ("desk_1", 3.0, 2.5, 0.0, "floor")), "Put the desk with its short side against the east wall"
    ).scene
    assert turn_between(after["desk_1"].yaw, 0.0, period=180.0) > 80.0
    assert after["desk_1"].footprint.bounds[2] > 5.9


def test_an_angle_and_what_the_back_is_to_may_both_be_said() -> None:
    before = built(room(), ("bathtub_1", 1.0, 4.4, 270.0, "floor"))
    after = done(before, "Rotate the bathtub by 90 degrees so that its back is to the west wall").scene
    assert turn_between(after["bathtub_1"].yaw, 0.0) < 2.0
    with pytest.raises(InputError, match="both how far and what to face"):
        edit_room(before, "Rotate the bathtub by 30 degrees so that its back is to the west wall")


def test_centred_on_what_hangs_is_before_the_middle_of_it() -> None:
    before = built(room(), ("desk_1", 4.6, 1.0, 0.0, "floor"), ("picture_1", 5.984, 2.5, 180.0, "wall"))
    after = done(before, "Slide the desk so that it is centred on the picture").scene
    assert after["desk_1"].position[1] == pytest.approx(2.5, abs=0.1)
    assert after["desk_1"].position[0] == pytest.approx(4.6, abs=0.1)


def test_only_what_is_along_a_wall_is_rearranged() -> None:
    before = living()
    edit = done(before, "Rearrange the things along the east wall")
    assert {c.id for c in edit.changes} <= {"sideboard_1", "armchair_1"}


def test_a_rug_is_made_so_large_that_what_is_named_is_on_it() -> None:
    after = done(living(), "Make the rug bigger so that the sofa and the coffee table are on it").scene
    lies = after["rug_1"].footprint.buffer(0.03)
    assert all(lies.covers(after[id].footprint) for id in ("sofa_1", "coffee_table_1"))
    assert after["sofa_1"] == living()["sofa_1"]


def test_what_hangs_from_the_ceiling_hangs_lower_on_a_longer_cord() -> None:
    before = done(living(), "Hang a pendant lamp above the coffee table").scene
    after = done(before, "Hang the pendant lamp 30 cm lower").scene
    assert before["pendant_lamp_1"].position[2] - after["pendant_lamp_1"].position[2] == pytest.approx(0.3, abs=0.01)
    after = done(before, "Raise the pendant lamp by 20 cm").scene
    assert after["pendant_lamp_1"].position[2] - before["pendant_lamp_1"].position[2] == pytest.approx(0.2, abs=0.01)


def test_boxes_find_room_on_the_floor_beside_a_thing() -> None:
    before = built(room(), ("wardrobe_1", 5.65, 2.0, 180.0, "floor"), ("desk_1", 0.5, 2.6, 0.0, "floor"),
                   ("vase_1", 0.5, 2.6, 0.0, "desk_1"))  # fmt: skip
    after = done(before, "Put the vase on the floor next to the wardrobe").scene
    assert after["vase_1"].support == "floor"
    assert gap(after, "vase_1", "wardrobe_1") < 0.5


def test_the_lamp_of_each_of_both_goes_with_it() -> None:
    gone = {c.id for c in done(bedroom(), "Remove both nightstands and their lamps").changes}
    assert gone == {"nightstand_1", "nightstand_2", "table_lamp_1", "table_lamp_2"}


def test_what_comes_with_what_is_given_is_at_that() -> None:
    after = done(living(), "Give the armchair a side table with a table lamp on it").scene
    assert after["table_lamp_1"].support == "side_table_1"
    assert gap(after, "side_table_1", "armchair_1") < 0.5


def test_the_ones_behind_a_comma_tell_which_of_them() -> None:
    before = built(room(), ("stool_1", 1.5, 1.5, 0.0, "floor"), ("stool_2", 3.0, 4.3, 0.0, "floor"),
                   ("stool_3", 5.0, 4.3, 0.0, "floor"), ("stool_4", 2.4, 1.5, 0.0, "floor"))  # fmt: skip
    gone = {c.id for c in done(before, "Two of the stools could go, the ones nearest the door").changes}
    assert gone == {"stool_1", "stool_4"}


def test_large_enough_is_no_thing_that_is_added() -> None:
    with pytest.raises(InputError, match="how large"):
        edit_room(living(), "There should be a cabinet beside the desk, big enough for the books")


def test_where_it_stands_tells_the_place_of_what_is_moved() -> None:
    before = built(room(), ("sideboard_1", 5.7, 1.2, 180.0, "floor"), ("sideboard_2", 0.3, 2.6, 0.0, "floor"),
                   ("table_lamp_1", 5.7, 1.2, 0.0, "sideboard_1"), ("stool_1", 3.0, 4.0, 0.0, "floor"))  # fmt: skip
    after = done(before, "Put the stool next to the sideboard the lamp stands on").scene
    assert gap(after, "stool_1", "sideboard_1") < 0.5


def test_a_thing_is_made_as_wide_as_another() -> None:
    after = done(living(), "Make the coffee table as long as the sideboard").scene
    assert max(after["coffee_table_1"].size[:2]) == pytest.approx(max(after["sideboard_1"].size[:2]), abs=0.02)


def test_two_things_that_touch_come_apart_by_what_is_said() -> None:
    before = built(room(), ("bookcase_1", 2.0, 4.75, 270.0, "floor"), ("bookcase_2", 2.93, 4.75, 270.0, "floor"))
    edit = edit_room(before, "Move the bookcases 50 cm apart")
    assert edit.failed or gap(edit.scene, "bookcase_1", "bookcase_2") > 0.45


def test_back_from_a_thing_is_away_from_it() -> None:
    before = built(room(), ("sofa_1", 3.0, 0.6, 90.0, "floor"), ("coffee_table_1", 3.0, 1.9, 90.0, "floor"))
    after = done(before, "Move the coffee table 20 cm back from the sofa").scene
    assert after["coffee_table_1"].position[1] == pytest.approx(2.1, abs=0.02)


def test_across_from_a_thing_is_before_its_middle() -> None:
    before = built(room(), ("sofa_1", 0.6, 2.5, 0.0, "floor"), ("armchair_1", 3.0, 4.4, 270.0, "floor"))
    after = done(before, "Put the armchair across from the sofa").scene
    assert abs(after["armchair_1"].position[1] - 2.5) < 0.3
    assert off(after, "armchair_1", "sofa_1") < 20.0


def test_plates_come_before_seats_and_not_on_them() -> None:
    before = built(room(), ("dining_table_1", 3.0, 2.5, 90.0, "floor"), ("chair_1", 2.6, 1.75, 90.0, "floor"))
    after = done(before, "Add two more chairs at the table with plates").scene
    plates = [p for p in after.placements if p.category == "plate"]
    assert [p.support for p in plates] == ["dining_table_1"] * 2


def test_what_comes_between_two_that_replace_one_is_between_them() -> None:
    before = built(room(7.0, 5.0), ("sofa_1", 3.5, 4.5, 270.0, "floor"))
    after = done(before, "Replace the sofa by two armchairs with a coffee table between them").scene
    table = next(p for p in after.placements if p.category == "coffee_table")
    sides = sorted(p.position[0] for p in after.placements if p.category == "armchair")
    assert sides[0] < table.position[0] < sides[1]


def test_a_second_screen_hides_no_other() -> None:
    before = built(room(), ("desk_1", 3.0, 2.5, 90.0, "floor"), ("monitor_1", 3.0, 2.4, 90.0, "desk_1"))
    edit = edit_room(before, "Give the desk a second monitor")
    for screen in (p for p in edit.scene.placements if p.id not in before):
        _, left = before["monitor_1"].to_local(screen.position[:2])
        assert abs(left) >= before["monitor_1"].size[1] - 0.05
    assert edit.failed or len(edit.scene.placements) == 3


def test_who_is_to_sit_with_the_back_to_a_wall_has_room_there() -> None:
    before = built(room(), ("desk_1", 4.0, 0.45, 90.0, "floor"))
    after = done(before, "Turn the desk round so I sit with my back to the wall").scene
    desk = after["desk_1"]
    assert desk.yaw == pytest.approx(270.0)
    assert desk.position[1] - desk.size[0] / 2 > 0.7


def test_a_wider_rug_grows_across() -> None:
    before = built(room(), ("rug_1", 3.0, 2.5, 0.0, "floor"))
    old, new = before["rug_1"].size, done(before, "Make the rug 30 cm wider but not longer").scene["rug_1"].size
    assert min(new[:2]) == pytest.approx(min(old[:2]) + 0.3, abs=0.02)
    assert max(new[:2]) == pytest.approx(max(old[:2]), abs=0.02)


def test_space_before_a_window_is_cleared_of_low_things() -> None:
    before = built(room(), ("armchair_1", 4.4, 4.5, 270.0, "floor"))
    after = done(before, "Make some space in front of the window").scene
    assert after["armchair_1"].footprint.distance(LineString([(3.6, 5.0), (5.2, 5.0)])) > 0.55


def test_as_many_chairs_as_are_said_come_around_what_replaces_a_thing() -> None:
    before = built(room(), ("sideboard_1", 3.0, 2.5, 90.0, "floor"))
    after = done(before, "Replace the sideboard by a dining table with four chairs around it").scene
    assert sum(p.category == "chair" for p in after.placements) == 4
