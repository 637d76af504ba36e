"""What instructions can say of which things, how many, how far and how: done as it is said, or said not to be done."""

import math
from itertools import pairwise
from pathlib import Path

import pytest

from tests.edited_rooms import bedroom, bytes_of, dining, living, placed, same_but
from thinkblox import Edit, Scene, edit_room, save_room, undo_edit
from thinkblox.cli import main
from thinkblox.editing.joining import joined
from thinkblox.editing.reading import read_instruction
from thinkblox.errors import InputError, UnavailableError
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.relations import measure

pytestmark = pytest.mark.slow


def gap(scene: Scene, one: str, other: str) -> float:
    return min(ground_gap(things(scene, one)[0], mark) for mark in things(scene, other))


def done(scene: Scene, instruction: str, **more: object) -> Edit:
    result = edit_room(scene, instruction, **more)  # type: ignore[arg-type]
    assert result.complete, (result.failed, result.unknown, [str(v) for v in result.report.objects if not v.valid])
    return result


def chairs(scene: Scene) -> list[str]:
    return [p.id for p in scene.placements if p.category == "chair"]


# --- which of several


@pytest.mark.parametrize(
    ("said", "left"),
    [
        ("Delete half of the chairs.", 2),
        ("Remove a quarter of the chairs", 3),
        ("Remove all but one of the chairs.", 1),
        ("Remove all of the chairs but one.", 1),
        ("Take away every chair except the two at the table", 2),
        ("Remove every second chair", 2),
        ("Remove two of the chairs", 2),
        ("Remove one of the chairs", 3),
        ("Keep only two chairs", 2),
        ("Only two chairs should remain.", 2),
        ("Remove the last two chairs", 2),
        ("Remove the chair closest to the door", 3),
    ],
)
def test_as_many_are_meant_as_is_said(said: str, left: int) -> None:
    assert len(chairs(done(dining(4), said).scene)) == left


def test_which_of_several_were_taken_is_said() -> None:
    result = done(dining(4), "Delete half of the chairs.")
    assert "'half of the chairs' is taken to be chair_3, chair_4, of 4" in result.done
    assert chairs(done(dining(4), "Remove the last two chairs").scene) == ["chair_1", "chair_2"]


@pytest.mark.parametrize(
    ("said", "says"),
    [
        ("Remove all but nine of the chairs", "there are only 4"),
        ("Remove the other chair", "other than which"),
        ("Remove the oldest chair", "not known"),
        ("Remove two of the five chairs", "there are 4"),
        ("Remove the front row of chairs", "do not stand in rows"),
    ],
)
def test_what_cannot_be_told_is_asked_for(said: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        edit_room(dining(4), said)


def test_the_other_is_the_one_that_was_not_spoken_of() -> None:
    after = done(dining(2), "Remove chair_1. Move the other chair 20 cm to the left.").scene
    assert chairs(after) == ["chair_2"]
    after = done(bedroom(), "Turn nightstand_1 around, then remove the other nightstand.").scene
    assert "nightstand_1" in after
    assert "nightstand_2" not in after


def test_theirs_are_those_that_stand_at_them() -> None:
    after = done(bedroom(), "Remove nightstand_1 and its lamp").scene
    assert {"nightstand_2", "table_lamp_2"} <= {p.id for p in after.placements}
    assert not {"nightstand_1", "table_lamp_1"} & {p.id for p in after.placements}


# --- at each of several places


@pytest.mark.parametrize(
    ("said", "supports"),
    [
        ("Put a bowl on every nightstand", {"nightstand_1", "nightstand_2"}),
        ("Put bowls on both nightstands", {"nightstand_1", "nightstand_2"}),
        ("Each nightstand should have a bowl on it", {"nightstand_1", "nightstand_2"}),
    ],
)
def test_each_gets_one(said: str, supports: set[str]) -> None:
    before = bedroom()
    after = done(before, said).scene
    assert {p.support for p in after.placements if p.id not in before} == supports
    assert same_but(before, after)


def test_each_side_and_every_corner_get_one() -> None:
    before = living()
    after = done(before, "Place a stool on each side of the sofa").scene
    new = [p.id for p in after.placements if p.id not in before]
    assert [sum(measure(after, kind, id, ("sofa_1",)).holds for id in new) for kind in ("left_of", "right_of")] == [
        1,
        1,
    ]
    after = edit_room(dining(2), "Put a plant in every corner.").scene
    spots = {tuple(round(v / 3) for v in p.position[:2]) for p in after.placements if p.category == "plant"}
    assert len(spots) >= 3


def test_what_finds_no_place_at_one_of_them_is_said() -> None:
    result = edit_room(living(), "Put a wardrobe in every corner")
    assert not result.complete
    assert any("were added" in text for text in result.failed)


# --- wishes


@pytest.mark.parametrize(
    "said",
    [
        "The sideboard should be against the south wall.",
        "I would like the sideboard against the south wall.",
        "I want the sideboard moved to the south wall",
        "Could the sideboard be against the south wall?",
        "The sideboard must go against the south wall",
        "Let the sideboard stand against the south wall",
    ],
)
def test_a_wish_is_an_order(said: str) -> None:
    before = living()
    after = done(before, said).scene
    assert measure(after, "against_wall", "sideboard_1", ("south_wall",)).holds
    assert same_but(before, after, "sideboard_1")


def test_a_wish_on_what_is_there_adds_nothing() -> None:
    before = living()
    after = done(before, "I would like the armchair closer to the sofa.").scene
    assert gap(after, "armchair_1", "sofa_1") < gap(before, "armchair_1", "sofa_1")
    assert same_but(before, after, "armchair_1")
    assert len(after.placements) == len(before.placements)


@pytest.mark.parametrize(
    ("said", "count"),
    [
        ("There should be six chairs", 6),
        ("There should be four chairs", 4),
        ("There should be only two chairs", 2),
        ("There should be no chairs", 0),
    ],
)
def test_so_many_there_are_to_be(said: str, count: int) -> None:
    assert len(chairs(done(dining(4), said).scene)) == count


def test_what_must_go_goes() -> None:
    assert "rug_1" not in done(living(), "The rug must go.").scene
    assert "rug_1" not in done(living(), "I want the rug removed").scene
    assert "rug_1" not in done(living(), "The rug is no longer needed").scene


# --- how far


@pytest.mark.parametrize(
    ("said", "metres"),
    [
        ("half a metre east", 0.5),
        ("two feet to the east", 0.6096),
        ("6 inches east", 0.1524),
        ("a foot east", 0.3048),
        ("one and a half feet east", 0.4572),
        ("a quarter of a metre east", 0.25),
    ],
)
def test_lengths_in_words_are_exact(said: str, metres: float) -> None:
    before = living()
    after = done(before, f"Move the coffee table {said}").scene
    assert after["coffee_table_1"].position[0] - before["coffee_table_1"].position[0] == pytest.approx(metres, abs=0.02)


def test_a_length_towards_something_is_that_length() -> None:
    before = living()
    after = done(before, "Shift the coffee table half a metre towards the sideboard.").scene
    assert gap(before, "coffee_table_1", "sideboard_1") - gap(after, "coffee_table_1", "sideboard_1") == pytest.approx(
        0.5, abs=0.02
    )


def test_a_bit_is_not_far() -> None:
    before = living()
    for said in ("Move the coffee table a bit to the left", "Move the coffee table slightly closer to the sofa"):
        after = done(before, said).scene
        assert 0.01 < math.dist(after["coffee_table_1"].position, before["coffee_table_1"].position) < 0.45
    after = done(before, "Turn the coffee table a bit to the left").scene
    assert (after["coffee_table_1"].yaw - before["coffee_table_1"].yaw) % 360 == pytest.approx(15.0)


@pytest.mark.parametrize(
    ("said", "least", "most"),
    [
        ("Place the armchair 40 cm from the sideboard", 0.38, 0.42),
        ("Leave at least 80 cm between the sofa and the coffee table", 0.78, 9.0),
        ("Widen the gap between the sofa and the coffee table to 70 cm", 0.68, 0.72),
        ("Make room between the sofa and the coffee table", 0.88, 9.0),
    ],
)
def test_things_stand_as_far_apart_as_is_said(said: str, least: float, most: float) -> None:
    pair = ("armchair_1", "sideboard_1") if "armchair" in said else ("sofa_1", "coffee_table_1")
    assert least <= gap(done(living(), said).scene, *pair) <= most


# --- how a thing is


def test_a_thing_is_made_larger_of_another_colour_or_shape() -> None:
    before = living()
    assert done(before, "Make the rug bigger.").scene["rug_1"].size[1] > before["rug_1"].size[1] + 0.05
    assert done(before, "Make the sofa 2.2 m wide.").scene["sofa_1"].size[1] == pytest.approx(2.2)
    blue = done(before, "Make the sofa blue.").scene
    assert "blue" in blue.asset_of(blue["sofa_1"]).attributes
    assert blue["sofa_1"].size == before["sofa_1"].size
    table = done(before, "Make the coffee table round.").scene
    assert "round" in table.asset_of(table["coffee_table_1"]).attributes
    assert same_but(before, blue, "sofa_1")


def test_a_larger_one_is_larger_than_that_which_is_there() -> None:
    before = living()
    for said in ("Use a larger rug under the coffee table.", "Replace the rug with a larger one."):
        after = done(before, said).scene
        assert [p.id for p in after.placements if p.category == "rug"] == ["rug_1"]
        assert math.prod(after["rug_1"].size[:2]) > 1.1 * math.prod(before["rug_1"].size[:2])


def test_what_no_such_thing_can_be_is_said_with_the_sizes() -> None:
    result = edit_room(living(), "Make the sofa 9 m wide")
    assert "is made from" in result.failed[0]
    assert "9.00" in result.failed[0]


def test_fewer_come_in_place_of_several() -> None:
    after = done(dining(4), "Replace the four chairs with two stools").scene
    assert not chairs(after)
    assert len([p for p in after.placements if p.category == "stool"]) == 2


def test_another_comes_where_one_was() -> None:
    before = living()
    after = done(before, "Remove the armchair and put a floor lamp in its place.").scene
    assert math.dist(after["floor_lamp_1"].position[:2], before["armchair_1"].position[:2]) < 0.8


# --- what goes along


@pytest.mark.parametrize(
    "said",
    ["Move the dining table with its chairs 30 cm east", "Move the dining table and its chairs 30 cm to the east"],
)
def test_company_goes_along_as_it_stands(said: str) -> None:
    before = dining(2)
    after = done(before, said).scene
    for id in ("dining_table_1", "chair_1", "chair_2"):
        assert after[id].position[0] - before[id].position[0] == pytest.approx(0.3, abs=0.02)


def test_chairs_are_kept_around_a_table_that_is_turned() -> None:
    after = done(dining(2), "Rotate the dining table by 90 degrees and keep the chairs around it.").scene
    assert all(measure(after, "at", id, ("dining_table_1",)).holds for id in chairs(after))


def test_chairs_are_pulled_out_and_pushed_in() -> None:
    before = dining(2)
    out = done(before, "Pull the chairs out.").scene
    assert all(gap(out, id, "dining_table_1") > gap(before, id, "dining_table_1") for id in chairs(out))
    so_far = done(before, "Pull the chairs out by 10 cm").scene
    assert all(gap(so_far, id, "dining_table_1") - gap(before, id, "dining_table_1") < 0.13 for id in chairs(out))
    back = done(out, "Push the chairs in").scene
    assert all(measure(back, "at", id, ("dining_table_1",)).holds for id in chairs(back))


# --- what stays


@pytest.mark.parametrize(
    "said",
    [
        "Remove everything but don't touch the sofa",
        "Remove the rug without moving the sofa",
        "Clear the room but leave the sofa",
        "Keep only the sofa",
    ],
)
def test_what_is_kept_is_not_touched(said: str) -> None:
    before = living()
    assert edit_room(before, said).scene["sofa_1"] == before["sofa_1"]


def test_an_order_against_what_is_kept_is_not_done() -> None:
    before = living()
    result = edit_room(before, "Move the coffee table 20 cm east but leave the vase where it is")
    assert same_but(before, result.scene)
    assert any("vase_1 is to stay as it is" in text for text in result.failed)


def test_a_denied_order_changes_nothing() -> None:
    before = living()
    assert bytes_of(edit_room(before, "Don't remove the rug.").scene) == bytes_of(before)


# --- clear words for what is not done


@pytest.mark.parametrize(
    ("said", "says"),
    [
        ("Undo that.", "--undo"),
        ("Add a sofa when the room is empty", "is a condition"),
        ("Unless the rug is red, remove it", "is a condition"),
        ("Add a cat.", "'a cat' is nothing that can be added"),
        ("Don't put the vase on the desk", "what is not to be done"),
        ("Add a lamp with 90 degrees", "an angle"),
        ("Rearrange the room in a circle", "not understood"),
        ("Add the sofa", "is there already"),
        ("Move the sofa 50 cm", "not clear what 0.5 m is|does not say where to"),
        ("Make it cosier.", "cannot be made otherwise|points at nothing"),
    ],
)
def test_what_is_not_done_is_said(said: str, says: str) -> None:
    with pytest.raises(InputError, match=says) as raised:
        edit_room(living(), said)
    assert " ." not in str(raised.value)


def test_an_order_that_finds_nothing_to_do_is_no_success() -> None:
    with pytest.raises(InputError, match="nothing was found in it that could be done"):
        edit_room(living(), "Make sure there is at least 70 cm on both sides of the sofa.")


def test_orders_read_as_they_were_written() -> None:
    texts = [o.text for o in read_instruction("Remove chair_1 and turn the sofa around!", ["chair_1"]).orders]
    assert texts == ["Remove chair_1", "turn the sofa around"]


def test_a_thing_that_is_turned_is_not_carried_off() -> None:
    before = living()
    after = edit_room(before, "Turn the sofa so that it looks at the desk").scene
    assert math.dist(after["sofa_1"].position, before["sofa_1"].position) < 2.3


# --- policies, scores


class OneString:
    def propose(self, observation, n, rng):
        return "<answer>{}</answer>"


class Gone:
    def propose(self, observation, n, rng):
        raise UnavailableError("the server is gone")


def test_one_string_instead_of_a_list_is_rejected_with_a_reason() -> None:
    result = edit_room(living(), "Move the armchair next to the sofa", policy=OneString())
    tries = [t for r in result.trace for t in r.tries if t.rejection is not None]
    assert any("a list of texts is wanted" in t.rejection.message for t in tries if t.rejection is not None)


def test_a_policy_that_cannot_go_on_ends_the_edit() -> None:
    with pytest.raises(UnavailableError, match="the server is gone"):
        edit_room(living(), "Move the armchair next to the sofa", policy=Gone())


@pytest.mark.slow
def test_a_server_that_is_not_there_leaves_nothing_behind(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    save_room(done(living(), "Keep the sofa where it is."), tmp_path / "room", pictures=False, formats=())
    words = ["edit", str(tmp_path / "room"), "Move the armchair next to the sofa", "--out", str(tmp_path / "out")]
    assert main([*words, "--no-pictures", "--policy", "openai:http://127.0.0.1:9#model"]) not in (0, 1)
    assert not (tmp_path / "out").exists()
    assert "127.0.0.1:9" in capsys.readouterr().err


def test_an_edited_room_has_its_score_and_so_has_one_taken_back() -> None:
    result = edit_room(living(), "Remove the rug.")
    assert result.report.score is not None
    assert undo_edit(result).report.score is not None


# --- other ways to say it


@pytest.mark.parametrize(
    ("said", "doing"),
    [
        ("have the lamp and the plant trade places", "swap"),
        ("Could the sofa and the desk switch places?", "swap"),
        ("instead of the armchair I want a bench", "replace"),
        ("a round one instead of the table would be nice", "replace"),
        ("replace the table with a round one", "replace"),
        ("swap the sofa out for a bench", "replace"),
        ("repalce teh sofa with a bench", "replace"),
        ("next to the bed put a stool", "put"),
        ("line the chairs up along the wall", "move"),
        ("throw the rug away", "remove"),
        ("I don't need the trash can anymore", "remove"),
        ("take everything off the desk", "remove"),
        ("one candle is enough", "only"),
        ("give the desk a lamp", "add"),
        ("provide every desk with a lamp", "add"),
        ("make all the chairs face the window", "turn"),
        ("the plant next to the wardrobe please", "put"),
        ("turn the stool into a plant", "replace"),
        ("i'd rather have a bench instead of the sofa", "replace"),
        ("get the stool out of the way", "resite"),
        ("let the sofa face the desk", "turn"),
    ],
)
def test_an_order_is_told_however_it_is_said(said: str, doing: str) -> None:
    read = read_instruction(said)
    assert [order.doing for order in joined(read.orders)] == [doing]
    assert not read.unknown


def test_it_is_what_was_told_of_before() -> None:
    (order,) = read_instruction("The desk is too close to the bed, move it back half a metre").orders
    assert [phrase.noun.value for phrase in order.things] == ["desk"]


@pytest.mark.parametrize(
    "said",
    [
        "I want the sofa by the wall and the rug gone",
        "I don't want the sofa to face the door",
        "rearrange the sofa area so there is more space in the middle",
        "move the harp next to the sofa",
    ],
)
def test_what_can_be_meant_in_two_ways_or_is_not_there_changes_nothing(said: str) -> None:
    with pytest.raises(InputError):
        edit_room(living(), said)


def test_what_is_kept_may_rest_on_something_else() -> None:
    after = done(bedroom(), "Get rid of both nightstands but keep the lamps").scene
    assert {"table_lamp_1", "table_lamp_2"} <= {p.id for p in after.placements}
    assert not {"nightstand_1", "nightstand_2"} & {p.id for p in after.placements}


def test_what_was_taken_back_is_not_told_as_done() -> None:
    result = edit_room(living(), "Remove the sofa. Keep the sofa where it is.")
    assert not any("taken away" in text for text in result.done)
    assert "sofa_1" in result.scene


def test_each_gets_its_own_and_what_comes_along_comes() -> None:
    before = bedroom()
    after = done(before, "Each nightstand should have a bowl").scene
    assert {p.support for p in after.placements if p.id not in before} == {"nightstand_1", "nightstand_2"}
    after = done(living(), "I need a second desk with a chair").scene
    assert {"desk_2", "chair_1"} <= {p.id for p in after.placements}
    assert measure(after, "at", "chair_1", ("desk_2",)).holds


def test_a_chair_at_an_end_looks_at_the_table() -> None:
    before = dining(2)
    after = done(before, "Put a chair at each end of the table").scene
    new = [p.id for p in after.placements if p.id not in before]
    assert len(new) == 2
    assert all(measure(after, "facing", id, ("dining_table_1",)).holds for id in new)


def test_the_other_end_of_a_top_is_the_other_one() -> None:
    before = done(living(), "Put the vase on the left end of the sideboard").scene
    after = done(before, "Put the vase on the other end of the sideboard").scene
    ends = [scene["sideboard_1"].to_local(scene["vase_1"].position[:2])[1] for scene in (before, after)]
    assert ends[0] > 0.1
    assert ends[1] < -0.1


def test_all_neighbours_go_apart() -> None:
    before = dining(0)
    for x in (1.0, 2.0, 3.0):
        before = placed(before, "stool", x, 4.4)
    after = done(before, "Move the stools a bit further apart").scene
    ids = [p.id for p in before.placements if p.category == "stool"]
    assert all(gap(after, a, b) > gap(before, a, b) for a, b in pairwise(ids))


def test_of_two_that_go_away_the_one_in_front_goes_first() -> None:
    before = living()
    after = done(before, "Move the sofa and the coffee table 20 cm away from the door").scene
    assert [after[id].yaw for id in ("sofa_1", "coffee_table_1")] == [90.0, 90.0]


def test_the_other_side_and_the_middle_are_meant() -> None:
    before = placed(living(), "stool", 3.0, 1.25)
    assert measure(before, "behind", "stool_1", ("coffee_table_1",)).holds
    after = done(before, "Move the stool to the other side of the coffee table").scene
    assert measure(after, "in_front_of", "stool_1", ("coffee_table_1",)).holds
    after = done(bedroom(), "Put the bed in the middle of the room").scene
    assert math.dist(after["bed_1"].position[:2], (3.0, 2.5)) < 0.3


def test_a_way_is_as_wide_as_is_said_or_wider() -> None:
    before = living()
    assert done(before, "Leave a path half a metre wide between the sofa and the window").scene == before


def test_what_hangs_hangs() -> None:
    after = done(living(), "Hang a clock").scene
    assert after["clock_1"].support.endswith("wall")
