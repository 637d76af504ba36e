"""Instructions on finished rooms: what is named changes and is measured, all else stays as it was."""

import math
from contextlib import suppress
from pathlib import Path

import pytest
from msgspec import structs

from tests.edited_rooms import OPENINGS, bedroom, built, bytes_of, dining, living, room, same_but
from thinkblox import Edit, Scene, World, edit_room, load_scene, read_episode, save_room, undo_edit, verify
from thinkblox.cli import main
from thinkblox.editing.reading import MAX_INSTRUCTION, read_instruction
from thinkblox.errors import InputError
from thinkblox.generate import generate_room
from thinkblox.policies.expert import ExpertPolicy
from thinkblox.scene.asset import Asset
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.room import rectangle
from thinkblox.sim.verdict.verify import reverify
from thinkblox.value import to_json
from thinkblox.verdict import Verdict


def gap(scene: Scene, one: str, other: str) -> float:
    return ground_gap(things(scene, one)[0], things(scene, other)[0])


def done(scene: Scene, instruction: str, **more: object) -> Edit:
    result = edit_room(scene, instruction, **more)  # type: ignore[arg-type]
    assert result.report.valid, [str(v) for v in result.report.objects if not v.valid]
    assert result.complete, (result.failed, result.unknown)
    return result


# --- the kinds of instructions


def test_a_thing_is_added_at_the_side_that_is_said() -> None:
    before = living()
    after = done(before, "Add a floor lamp to the left of the sofa.").scene
    assert measure(after, "left_of", "floor_lamp_1", ("sofa_1",)).holds
    assert same_but(before, after)


def test_a_desk_goes_under_the_window_and_faces_the_room() -> None:
    before = living()
    after = done(before, "Move the desk under the window and turn it to face the room.").scene
    desk, wall = after["desk_1"], after.room.wall("north_wall")
    assert measure(after, "under", "desk_1", ("window_1",)).holds
    assert abs((desk.yaw - wall.yaw + 180) % 360 - 180) <= 45
    assert same_but(before, after, "desk_1")


def test_another_thing_comes_in_place_of_one() -> None:
    before = living()
    after = done(before, "Replace the armchair with a rocking chair.").scene
    assert after["armchair_1"].category == "rocking_chair"
    assert math.dist(after["armchair_1"].position, before["armchair_1"].position) < 0.8
    assert same_but(before, after, "armchair_1")


def test_a_thing_is_taken_away() -> None:
    before = living()
    after = done(before, "Remove the rug.").scene
    assert "rug_1" not in after
    assert same_but(before, after, "rug_1")


def test_a_small_thing_goes_on_what_is_said_and_not_on_what_it_was() -> None:
    before = living()
    after = done(before, "Put the vase on the sideboard, not on the table.").scene
    assert after["vase_1"].support == "sideboard_1"
    assert same_but(before, after, "vase_1")


def test_two_things_change_places() -> None:
    before = bedroom()
    after = done(before, "Swap the bed and the wardrobe.").scene
    for one, other in (("bed_1", "wardrobe_1"), ("wardrobe_1", "bed_1")):
        assert math.dist(after[one].position, before[other].position) < 1.2
    assert same_but(before, after, "bed_1", "wardrobe_1")


@pytest.mark.parametrize(
    ("said", "turns"),
    [
        ("by 90 degrees", (90, 270)),
        ("by 90° clockwise", (270,)),
        ("anticlockwise by a quarter turn", (90,)),
        ("by forty five degrees counterclockwise", (45,)),
        ("around", (180,)),
    ],
)
def test_a_thing_is_turned_by_what_is_said(said: str, turns: tuple[int, ...]) -> None:
    before = living()
    after = done(before, f"Rotate the coffee table {said}.").scene
    turn = (after["coffee_table_1"].yaw - before["coffee_table_1"].yaw) % 360
    assert any(abs(turn - wanted) < 2 for wanted in turns)
    assert same_but(before, after, "coffee_table_1", "vase_1")


def test_both_come_closer_and_carry_their_lamps() -> None:
    before = bedroom()
    result = done(before, "Move both nightstands closer to the bed.")
    for number in (1, 2):
        assert gap(result.scene, f"nightstand_{number}", "bed_1") < gap(before, f"nightstand_{number}", "bed_1") - 0.01
        assert result.scene[f"table_lamp_{number}"].support == f"nightstand_{number}"
    carried = [change.id for change in result.changes if change.what == "carried"]
    assert carried == ["table_lamp_1", "table_lamp_2"]
    assert any("table_lamp_1, table_lamp_2 went along" in text for text in result.done)
    assert same_but(before, result.scene, "nightstand_1", "nightstand_2", "table_lamp_1", "table_lamp_2")


def test_the_centre_is_kept_free() -> None:
    before = dining()
    after = done(before, "Rearrange the room so that the centre stays free.").scene
    width, depth = (side / 6 for side in after.room.extent)
    for placement in after.placements:
        x, y = placement.position[:2]
        assert abs(x - 3.0) > width or abs(y - 2.5) > depth


def test_a_corner_becomes_a_reading_corner_and_the_rest_stays() -> None:
    before = bedroom()
    result = done(before, "Rearrange only the corner by the window into a reading corner.")
    seat = next(c.id for c in result.changes if c.id.startswith("armchair"))
    lamp = next(c.id for c in result.changes if "lamp" in c.id)
    assert gap(result.scene, seat, lamp) < 0.5
    assert measure(result.scene, "in_corner", seat, ("west_wall",)).holds
    assert same_but(before, result.scene)


def test_more_of_the_same_sit_around_the_table() -> None:
    before = dining()
    after = done(before, "Add four more chairs around the dining table.").scene
    new = [p.id for p in after.placements if p.id not in before]
    assert new == ["chair_3", "chair_4", "chair_5", "chair_6"]
    assert {after[id].asset for id in new} == {before["chair_1"].asset}
    assert all(measure(after, "at", id, ("dining_table_1",)).holds for id in new)
    assert same_but(before, after)


def test_the_room_grows_and_everything_stays_where_it_is() -> None:
    before = living()
    result = done(before, "Make the room one metre longer and keep everything else where it is.")
    after = result.scene
    assert after.room.extent == (7.0, 5.0)
    assert same_but(before, after, "picture_1")
    assert after["picture_1"].position[0] == pytest.approx(before["picture_1"].position[0] + 1.0)
    assert any("picture_1 hangs on east_wall" in text for text in result.done)
    wall = after.room.walls[2]
    window = after.room.openings[1]
    assert wall.point(window.offset)[0] == pytest.approx(before.room.walls[2].point(before.room.openings[1].offset)[0])


# --- other words for them


@pytest.mark.parametrize(
    ("instruction", "way"),
    [
        ("Move the coffee table 20 cm to the left.", (-0.2, 0.0)),
        ("Shift the coffee table 0.3 m forward", (0.0, 0.3)),
        ("Push the coffee table ten centimetres east", (0.1, 0.0)),
    ],
)
def test_a_thing_is_moved_by_so_much(instruction: str, way: tuple[float, float]) -> None:
    before = living()
    after = done(before, instruction).scene
    moved = [b - a for a, b in zip(before["coffee_table_1"].position, after["coffee_table_1"].position, strict=True)]
    assert moved[:2] == pytest.approx(way, abs=0.02)
    assert after["vase_1"].support == "coffee_table_1"


@pytest.mark.parametrize(
    ("instruction", "kind", "id", "anchors"),
    [
        ("Push the sideboard against the south wall.", "against_wall", "sideboard_1", ("south_wall",)),
        ("Move the armchair into the corner.", "in_corner", "armchair_1", ("corner",)),
        ("Turn the armchair so that it faces the sofa.", "facing", "armchair_1", ("sofa_1",)),
        ("Move the armchair next to the sofa", "next_to", "armchair_1", ("sofa_1",)),
        ("Add a plant by the window", "next_to", "plant_1", ("window_1",)),
        ("Put a bowl on the desk.", "on", "bowl_1", ("desk_1",)),
        ("Hang the picture above the sofa.", "above", "picture_1", ("sofa_1",)),
    ],
)
def test_places_are_understood_as_in_prompts(instruction: str, kind: str, id: str, anchors: tuple[str, ...]) -> None:
    before = living()
    after = done(before, instruction).scene
    assert measure(after, kind, id, anchors).holds  # type: ignore[arg-type]
    assert same_but(before, after, id)


def test_further_from_and_somewhere_else() -> None:
    before = living()
    assert gap(done(before, "Move the coffee table further from the sofa").scene, "coffee_table_1", "sofa_1") > gap(
        before, "coffee_table_1", "sofa_1"
    )
    elsewhere = done(before, "Find another place for the armchair.").scene
    assert math.dist(elsewhere["armchair_1"].position, before["armchair_1"].position) > 0.7


def test_an_id_names_one_of_several() -> None:
    after = done(dining(), "Remove chair_2.").scene
    assert "chair_1" in after
    assert "chair_2" not in after


def test_kept_things_stay_when_the_room_is_rearranged() -> None:
    before = living()
    result = edit_room(before, "Rearrange the room, but keep the sofa where it is.")
    assert result.scene["sofa_1"] == before["sofa_1"]
    assert any(c.what == "moved" for c in result.changes)


def test_several_orders_are_carried_out_one_after_the_other() -> None:
    after = done(
        living(), "Remove the rug. Add a plant next to the sofa and turn the coffee table by 90 degrees."
    ).scene
    assert "rug_1" not in after
    assert "plant_1" in after
    assert after["coffee_table_1"].yaw % 180 == 0


def test_what_stood_on_what_goes_is_placed_anew() -> None:
    result = done(living(), "Remove the coffee table.")
    assert result.scene["vase_1"].support in ("sideboard_1", "desk_1")
    assert any(text.startswith("vase_1, which rested on coffee_table_1, placed anew") for text in result.done)


# --- what is not so


def test_one_of_several_alike_is_asked_for() -> None:
    with pytest.raises(InputError, match=r"'the chair' could be chair_1 .*chair_2 .*say which"):
        edit_room(dining(), "Remove the chair.")


def test_context_tells_one_of_several() -> None:
    scene = living()
    vase = scene.asset_of(scene["vase_1"])
    top = max(s.position[2] for s in scene.asset_of(scene["desk_1"]).surfaces if not s.inner)
    second = structs.replace(scene["vase_1"], id="vase_2", position=(0.5, 2.6, top))
    after = done(scene.with_placement(second, vase), "Put the vase on the sideboard, not on the coffee table.").scene
    assert after["vase_1"].support == "sideboard_1"
    assert after["vase_2"].support == "desk_1"


@pytest.mark.parametrize(
    "instruction", ["Remove the piano.", "Move the desk next to the piano", "Swap it with the sofa"]
)
def test_what_is_not_there_is_said_with_what_there_is(instruction: str) -> None:
    with pytest.raises(InputError, match=r"no piano; there are 1 |points at nothing"):
        edit_room(living(), instruction)


def test_what_cannot_be_done_is_not_done_and_says_the_numbers() -> None:
    before = living()
    result = edit_room(before, "Move the sofa 1 m back.")
    assert result.scene == before
    assert not result.complete
    assert "reaches" in result.failed[0]
    assert " mm outside the room" in result.failed[0]


def test_a_room_is_not_made_too_small_for_what_is_in_it() -> None:
    before = living()
    result = edit_room(before, "Make the room 60 cm shorter.")
    assert to_json(result.scene) == to_json(before)
    assert "sideboard_1: reaches" in result.failed[0]
    assert "end 0.20 m before the far edge of window_1" in edit_room(before, "Make the room 5 m long.").failed[0]


def test_words_that_mean_nothing_are_said() -> None:
    result = edit_room(living(), "Remove the rug frobnicatedly.")
    assert result.unknown == ("frobnicatedly",)
    assert not result.complete
    assert "rug_1" not in result.scene


@pytest.mark.parametrize(
    ("instruction", "says"),
    [
        ("", "is empty"),
        (" \n", "is empty"),
        ("Remove the rug. " * 6250, "has 100000 characters"),
        ("x" * MAX_INSTRUCTION, "does not say what to do"),
        ("Make the sofa happier", "cannot be made otherwise"),
        ("Move the sofa", "does not say where to"),
        ("Rotate the sofa", "does not say how far"),
        ("Replace the sofa", "does not say what comes instead"),
        ("Swap the sofa", "must name two things"),
        ("\ud800", "not valid text"),
    ],
)
def test_an_instruction_that_cannot_be_used_says_why(instruction: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        edit_room(living(), instruction)


@pytest.mark.parametrize("text", ["Add the", "and and and", "Swap and", "turn , by", "make the room", "Put on", "?!"])
def test_bits_of_instructions_are_clear_errors_or_done(text: str) -> None:
    with suppress(InputError):
        assert edit_room(dining(), text).report.valid


# --- the report


def test_the_report_on_what_changed_is_that_of_the_whole() -> None:
    before = bedroom()
    known = verify(before)
    source = edit_room(before, "Keep the bed where it is")
    source = Edit(before, known, source.episode, "")
    result = edit_room(source, "Turn the wardrobe by 90 degrees and remove nightstand_1")
    whole = verify(result.scene)
    assert result.report.valid == whole.valid
    assert [(v.id, v.reasons, v.reachable) for v in result.report.objects] == [
        (v.id, v.reasons, v.reachable) for v in whole.objects
    ]


@pytest.mark.parametrize(("x", "opens_less"), [(4.9, True), (4.3, False)])
def test_what_stands_about_a_change_is_measured_anew_only_where_doors_open_less(
    x: float, opens_less: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = built(room(), ("wardrobe_1", 5.65, 2.0, 180.0, "floor"), ("armchair_1", 3.0, 2.0, 0.0, "floor"))
    known, after = verify(before), before.moved("armchair_1", position=(x, 2.0, 0.0))
    whole = verify(after)
    measured: list[str] = []
    check = World.check

    def checked(world: World, candidates: list[Placement], asset: Asset, **more: bool) -> list[Verdict]:
        measured.extend(p.id for p in candidates)
        return check(world, candidates, asset, **more)

    monkeypatch.setattr(World, "check", checked)
    anew = reverify(after, before, known)
    assert anew.objects == whole.objects
    assert any(v.swings for v in anew.objects) == opens_less
    assert ("wardrobe_1" in measured) == opens_less


def test_every_change_is_measured_like_a_placement() -> None:
    result = done(living(), "Move the armchair next to the sofa")
    placement = result.scene["armchair_1"]
    assert World(result.scene).check([placement], result.scene.asset_of(placement))[0].valid
    assert any(t.verdict is not None for r in result.trace for t in r.tries)


# --- other policies


class Told(ExpertPolicy):
    """Writes down what it is asked."""

    def __init__(self) -> None:
        self.seen: list[tuple[str, str]] = []

    def propose(self, observation, n, rng):
        self.seen.append((observation.target.id, observation.text()))
        return super().propose(observation, n, rng)


def test_what_loses_its_place_stands_where_there_is_room_and_nobody_is_asked() -> None:
    policy = Told()
    result = done(living(), "Remove the coffee table", policy=policy)
    assert result.scene["vase_1"].support in ("sideboard_1", "desk_1")
    assert not policy.seen


def test_what_is_made_larger_where_it_stands_is_nobody_asked_about() -> None:
    policy = Told()
    before = built(rectangle(1.95, 2.4, openings=OPENINGS[:1]), ("dining_table_1", 0.975, 1.6, 90.0, "floor"))
    assert edit_room(before, "Make the table 2 m wide", policy=policy).failed
    assert not policy.seen


def test_any_policy_is_asked_for_the_target_and_sees_the_rest() -> None:
    policy = Told()
    done(living(), "Add a floor lamp to the left of the sofa and move the armchair next to the desk.", policy=policy)
    assert [id for id, _ in policy.seen] == ["floor_lamp_1", "armchair_1"]
    assert "Now: Add a floor lamp" in policy.seen[0][1]
    assert "left_of(sofa_1)" in policy.seen[0][1]


class Raises:
    def propose(self, observation, n, rng):
        raise RuntimeError("out of order")


class Prose:
    def propose(self, observation, n, rng):
        return ["Somewhere nice.", 7, "<think></think><answer>{}</answer>"]


@pytest.mark.parametrize("policy", [Raises(), Prose()])
def test_a_policy_that_is_of_no_use_leaves_the_rest_as_it_is(policy: object) -> None:
    before = living()
    result = edit_room(before, "Move the armchair next to the sofa", policy=policy)  # type: ignore[arg-type]
    assert same_but(before, result.scene, "armchair_1")
    assert any(t.rejection is not None for r in result.trace for t in r.tries)


# --- the history


def test_edits_are_a_history_that_can_be_undone(tmp_path: Path) -> None:
    before = living()
    first = done(before, "Remove the rug.")
    save_room(first, tmp_path / "one", pictures=False, formats=())
    second = done(tmp_path / "one", "Put the vase on the desk.")  # type: ignore[arg-type]
    save_room(second, tmp_path / "two", pictures=False, formats=())
    assert [e.instruction for e in read_episode(tmp_path / "two").standing] == [
        "Remove the rug.",
        "Put the vase on the desk.",
    ]
    assert to_json(read_episode(tmp_path / "two").scene) == (tmp_path / "two" / "scene.json").read_bytes()
    back = undo_edit(tmp_path / "two")
    assert to_json(back.scene) == to_json(first.scene)
    save_room(back, tmp_path / "three", pictures=False, formats=())
    start = undo_edit(tmp_path / "three")
    assert to_json(start.scene) == to_json(before)
    save_room(start, tmp_path / "four", pictures=False, formats=())
    with pytest.raises(InputError, match="no edit to undo"):
        undo_edit(tmp_path / "four")
    assert len(read_episode(tmp_path / "four").edits) == 4


def test_a_room_that_was_changed_otherwise_is_not_undone() -> None:
    first = done(living(), "Remove the rug.")
    other = Edit(first.scene.without("vase_1"), first.report, first.episode, "")
    with pytest.raises(InputError, match="has been changed since edit 1"):
        undo_edit(other)


def test_an_edit_of_another_version_is_not_read(tmp_path: Path) -> None:
    save_room(done(living(), "Remove the rug."), tmp_path / "room", pictures=False, formats=())
    trace = tmp_path / "room" / "trace.jsonl"
    trace.write_bytes(trace.read_bytes().replace(b'"line":"edit","version":1', b'"line":"edit","version":9'))
    with pytest.raises(InputError, match="edit version 9 is not known"):
        read_episode(trace)


# --- the command


def test_the_command_edits_and_takes_back(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    room_at, out, back = (str(tmp_path / name) for name in ("room", "out", "back"))
    save_room(done(living(), "Keep the sofa where it is."), room_at, pictures=False, formats=())
    assert main(["edit", room_at, "Remove the rug.", "--out", out, "--no-pictures"]) == 0
    said = capsys.readouterr().out
    assert "rug_1 taken away" in said
    assert "1 changed, 7 as they were" in said
    assert "rug_1" not in load_scene(out)
    assert main(["edit", out, "--undo", "--out", back, "--no-pictures"]) == 0
    assert Path(back, "scene.json").read_bytes() == Path(room_at, "scene.json").read_bytes()


@pytest.mark.parametrize(
    ("words", "status", "written"),
    [
        (["Move the sofa 1 m back."], 1, True),
        (["Remove the piano."], 2, False),
        ([""], 2, False),
        ([], 2, False),
        (["Remove the rug.", "--undo"], 2, False),
    ],
)
def test_the_status_says_what_became_of_it(tmp_path: Path, words: list[str], status: int, written: bool) -> None:
    save_room(done(living(), "Keep the sofa where it is."), tmp_path / "room", pictures=False, formats=())
    assert main(["edit", str(tmp_path / "room"), *words, "--out", str(tmp_path / "out"), "--no-pictures"]) == status
    assert (tmp_path / "out").exists() == written


def test_reading_needs_no_room() -> None:
    order = read_instruction("Please move the two chairs by the window closer to the table.").orders[0]
    assert order.doing == "move"
    assert order.things[0].noun.count == 2
    assert order.closer[0][0] is True


def test_an_empty_room_can_be_furnished() -> None:
    after = done(built(room()), "Add a bed.").scene
    assert [p.id for p in after.placements] == ["bed_1"]
    assert bytes_of(after)


def test_who_places_can_be_said_in_a_word() -> None:
    made = generate_room("A study with a desk and a chair", seed=3)
    said, usual = (edit_room(made, "Add a bookcase against a wall.", policy=who) for who in ("expert", None))
    assert said.scene == usual.scene
    with pytest.raises(InputError, match="'somebody' names nobody"):
        edit_room(made, "Add a bookcase.", policy="somebody")


@pytest.mark.parametrize("instruction", ["Remove the rug, the rug and the rug", "Remove the vase and the coffee table"])
def test_what_is_named_twice_or_with_its_carrier_is_done_once(instruction: str) -> None:
    result = done(living(), instruction)
    assert len(result.done) == len({change.id for change in result.changes})


def test_a_thing_named_twice_is_turned_once() -> None:
    after = done(living(), "Rotate the coffee table and the coffee table by 90 degrees clockwise").scene
    assert (living()["coffee_table_1"].yaw - after["coffee_table_1"].yaw) % 360 == pytest.approx(90)


def test_an_id_of_the_same_kind_is_that_very_thing() -> None:
    before = dining(4)
    result = edit_room(before, "Turn chair_1 so that it faces chair_3.")
    assert "chair_3" in " ".join((*result.done, *result.failed))
    moved = done(before, "Move chair_1 closer to chair_3.").done[0]
    assert "from chair_3" in moved
    with pytest.raises(InputError, match="chair_9"):
        edit_room(before, "Put chair_1 on chair_9.")


@pytest.mark.parametrize(
    ("instruction", "left"),
    [
        ("Clear the room", set()),
        ("Clear the coffee table", {"rug", "sofa", "coffee_table", "sideboard", "desk", "armchair", "picture"}),
        ("Remove everything except the sofa and keep the rug", {"sofa", "rug"}),
        ("Keep the sofa and remove everything else", {"sofa"}),
        ("Clear the room of furniture", {"picture"}),
    ],
)
def test_clear_takes_away_what_is_there(instruction: str, left: set[str]) -> None:
    after = done(living(), instruction).scene
    assert {p.category for p in after.placements} == left


def test_clear_says_what_cannot_go_and_what_is_clear_already() -> None:
    result = edit_room(living(), "Clear the room of furniture but keep the vase")
    assert {p.id for p in result.scene.placements} == {"coffee_table_1", "vase_1", "picture_1"}
    assert "vase_1, which is to stay, rests on it" in result.failed[0]
    assert "so already" in done(living(), "Clear the desk").done[0]
    assert done(living(), "Clear the coffee table and the coffee table").done == ("vase_1 taken away",)


def test_it_is_what_the_same_clause_named() -> None:
    after = done(living(), "Move the armchair opposite the sofa and 2 m away from it").scene
    assert gap(after, "armchair_1", "sofa_1") == pytest.approx(2.0, abs=0.03)
    after = done(living(), "Remove the coffee table and what is on it").scene
    assert "vase_1" not in after
    after = done(living(), "Add a bookcase and a plant next to it").scene
    assert measure(after, "next_to", "plant_1", ("bookcase_1",)).holds


@pytest.mark.parametrize("excepted", ["two", "chair_1 and chair_2"])
def test_all_but_some_are_removed(excepted: str) -> None:
    after = done(dining(4), f"Remove all chairs except {excepted}").scene
    assert {p.id for p in after.placements} == {"dining_table_1", "chair_1", "chair_2"}


def test_an_address_loses_nothing() -> None:
    assert "rug_1" not in done(living(), "Remove the rug please, my dear").scene
    assert len(done(dining(3), "Remove all chairs except one").scene.placements) == 2
    result = edit_room(living(), "Remove the rug, my frobnix")
    assert (result.unknown, "rug_1" in result.scene) == (("my frobnix",), False)


@pytest.mark.slow
def test_what_was_missing_stays_missing_after_an_edit_and_an_undo() -> None:
    prompt = "A tiny room of 2 m by 2 m with a king size bed, a wardrobe, a grand piano and a stool next to the door"
    made = generate_room(prompt)
    assert made.report.absent
    assert not made.report.complete
    gone = next(p.id for p in made.scene.placements)
    edited = edit_room(made, f"Remove {gone}")
    assert {a.id for a in edited.report.absent} == {a.id for a in made.report.absent}
    assert edited.report.demands
    assert not edited.report.complete
    back = undo_edit(edited)
    assert {a.id for a in back.report.absent} >= {a.id for a in made.report.absent}
    assert (back.report.demands, back.report.relations) == (made.report.demands, made.report.relations)
    assert not back.report.complete


def test_the_left_one_is_said_to_be_seen_from_the_door() -> None:
    before = built(room(), ("crib_1", 1.5, 4.0, 270.0, "floor"), ("crib_2", 4.5, 4.0, 270.0, "floor"))
    result = done(before, "Remove the left crib")
    assert "crib_1" not in result.scene
    assert "the left crib is crib_1, seen from the door" in result.done


def test_what_is_not_on_a_thing_is_said_in_plain_words() -> None:
    failed = edit_room(living(), "Put the armchair on the sideboard").failed[0]
    assert "armchair_1 not over sideboard_1, 0." in failed
    assert " mm" not in failed


def test_what_nobody_knows_cannot_come_instead() -> None:
    with pytest.raises(InputError, match="'a quintessence' is nothing that is known"):
        edit_room(living(), "Replace the sofa with a quintessence")
    with pytest.raises(InputError, match="find another place for") as raised:
        edit_room(living(), "frobnicate")
    assert "re place" not in str(raised.value)
