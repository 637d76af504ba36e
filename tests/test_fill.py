"""What stands in a room besides what its prompt names: nothing, what makes it one, or all that lies about."""

from collections import Counter
from typing import cast

import numpy as np
import pytest

from thinkblox import Generation, generate_room
from thinkblox.assets import kind_of
from thinkblox.assets.stand_ins import stand_in
from thinkblox.dressing import STAGES
from thinkblox.errors import InputError
from thinkblox.fills import Fill
from thinkblox.furnishing import Furnished, Progress
from thinkblox.judging import asset_for
from thinkblox.knowledge.dressing import dressing
from thinkblox.knowledge.rooms import read_usual
from thinkblox.placing import Effort
from thinkblox.plan import Target
from thinkblox.planning import varied
from thinkblox.planning.dressing import Dresser
from thinkblox.reading import read_brief
from thinkblox.scene.relations import measure
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene

PROMPT = "A bathroom with a red towel rail"


@pytest.fixture(scope="module")
def lived_in() -> Generation:
    return generate_room(PROMPT, fill="lived-in")


@pytest.mark.slow
def test_a_lived_in_room_is_full_and_valid(lived_in: Generation) -> None:
    assert 60 <= len(lived_in.scene.placements) <= 120
    assert lived_in.report.valid
    assert lived_in.report.complete


def test_what_was_added_is_marked_as_assumed(lived_in: Generation) -> None:
    asked = {target.category for target in lived_in.plan.targets if target.asked}
    assert asked == {"towel_rail"}
    assert {verdict.id for verdict in lived_in.report.objects} == {p.id for p in lived_in.scene.placements}
    assert not any(absence.asked for absence in lived_in.report.absent)


def test_the_room_that_was_filled_is_the_one_that_is_given(monkeypatch: pytest.MonkeyPatch) -> None:
    filled: list[Furnished] = []
    monkeypatch.setattr(Furnished, "dress", lambda self: filled.append(self))
    monkeypatch.setattr("thinkblox.generate._is_cramped", lambda made: not filled or made is filled[0])
    assert generate_room(PROMPT, fill="lived-in").scene == filled[0].best.world.scene


def test_small_things_lie_on_what_they_are_kept_on(lived_in: Generation) -> None:
    dressed = {t.id: t.ties[0].anchors[0] for t in lived_in.plan.targets if t.ties and t.ties[0].kind == "on"}
    there = [p for p in lived_in.scene.placements if p.id in dressed]
    assert there
    assert {p.id: p.support for p in there} == {p.id: dressed[p.id] for p in there}


@pytest.mark.slow
def test_few_of_what_one_has_few_of_and_hardly_anything_finds_no_place(lived_in: Generation) -> None:
    there = Counter(p.category for p in lived_in.scene.placements)
    ones = {u.category for u in dressing().on("shelving_unit", "bathroom") if u.count == 1}
    assert {name: there[name] for name in ones if there[name] > 2} == {}
    crowded = [a for a in lived_in.report.absent if "collides" in a.reason]
    assert len(crowded) < 0.1 * len(lived_in.scene.placements)


def test_the_trace_of_a_lived_in_room_leads_to_it(lived_in: Generation) -> None:
    assert lived_in.episode.scene == lived_in.scene


@pytest.mark.slow
def test_a_lived_in_room_is_the_same_for_the_same_seed() -> None:
    one, other = (generate_room("A toilet", room=rectangle(1.5, 1.5), fill="lived-in") for _ in range(2))
    assert len(one.scene.placements) > 8
    assert one.scene == other.scene


@pytest.mark.parametrize("prompt", ["A bathroom", "A bathroom with a towel rail and a plant", "haunted bedroom"])
def test_named_fills_in_nothing(prompt: str) -> None:
    requests = read_brief(prompt, fill="named").requests
    assert all(request.asked for request in requests)


def test_named_keeps_what_carries() -> None:
    brief = read_brief("A room with a laptop", fill="named")
    assert [(request.category, request.asked) for request in brief.requests] == [("laptop", True), ("desk", False)]


def test_each_filling_holds_the_one_before() -> None:
    named, essentials = ({r.category for r in read_brief(PROMPT, fill=f).requests} for f in ("named", "essentials"))
    assert named < essentials


def added_to(prompt: str) -> set[str]:
    """What would be added to make the room of a prompt look lived in."""
    made = generate_room(prompt)
    dresser = Dresser(made.plan, np.random.default_rng(0))
    return {target.category for stage in (dresser.furniture, dresser.things) for target in stage(made.scene)}


def test_nothing_excluded_is_added() -> None:
    assert "towels" in added_to("A bathroom with a shelving unit")
    assert not {"towels", "potted_plant", "plant"} & added_to(
        "A bathroom with a shelving unit but without towels and without plants"
    )


def test_what_is_there_by_another_name_is_not_added_again() -> None:
    assert "wall_map" not in added_to("A classroom with four desks and a world map on the wall")


def test_another_filling_is_refused() -> None:
    with pytest.raises(InputError, match="named, essentials, lived-in"):
        generate_room(PROMPT, fill=cast(Fill, "full"))


def test_the_first_fitting_entry_says_what_is_put_on_a_thing() -> None:
    kitchen, office = (dressing().on("bookcase", room) for room in ("kitchen", "home_office"))
    assert {usual.category for usual in kitchen} & {"plate", "cooking_pot"}
    assert "binder" in {usual.category for usual in office}


@pytest.mark.parametrize(
    ("room", "carrier", "homely"),
    [
        ("church", "sideboard", {"wristwatch", "keys", "jewelry_box", "remote_control"}),
        ("church", "bookcase", {"radio", "alarm_clock", "sewing_box", "board_game"}),
        ("courtroom", "bookcase", {"ship_in_a_bottle", "record_player", "board_game"}),
        ("waiting_room", "coffee_table", {"remote_control", "sunglasses", "chess_board"}),
        ("classroom", "school_desk", {"phone", "sunglasses", "cactus", "desk_fan", "photo_frame"}),
        ("dining_room", "china_cabinet", {"board_game", "book_row", "book", "biscuit_tin"}),
        ("pottery_studio", "shelving_unit", {"potted_plant", "ship_in_a_bottle"}),
        ("recording_studio", "bookcase", {"ship_in_a_bottle", "decanter", "sewing_box", "telephone"}),
        ("teenager_bedroom", "bookcase", {"toy", "stuffed_animal", "doll", "abacus", "sewing_box"}),
    ],
)
def test_a_room_gets_what_lies_about_in_such_rooms(room: str, carrier: str, homely: set[str]) -> None:
    there = {usual.category for usual in dressing().on(carrier, room)}
    assert there
    assert not there & homely


def test_no_shelves_are_put_up_where_there_are_none() -> None:
    assert not {"wall_shelf", "sideboard", "bookcase"} & {usual.category for usual in dressing().furniture("church")}


def test_every_dressing_has_a_shape_and_lies_on_something() -> None:
    things = {usual.category for tops in dressing().tops for usual in read_usual(tops.things)}
    assert {noun for noun in things if stand_in(noun).how not in ("catalogue", "table")} == set()
    assert {noun for noun in things if kind_of(noun).mount != "surface"} == set()


def test_shelves_that_are_hung_carry_things_and_nothing_added_bars_storage(lived_in: Generation) -> None:
    scene, added = lived_in.scene, [t.id for t in lived_in.plan.targets if not t.asked and t.id in lived_in.scene]
    assert all(scene.resting_on(id) for id in added if scene[id].category == "wall_shelf")
    for storage in (p for p in scene.placements if p.category in ("bookcase", "shelving_unit")):
        for plant in (scene[id] for id in added if scene[id].category == "plant"):
            ahead, aside = storage.to_local(plant.position[:2])
            out, width = ahead - (storage.size[0] + plant.size[0]) / 2, (storage.size[1] + plant.size[1]) / 2
            assert abs(aside) > width - 0.05 or out > 0.5 or ahead < 0.0


def test_a_screen_comes_with_what_one_types_on() -> None:
    assert dressing().kits["monitor"].split(", ")[0] == "keyboard"


def test_what_belongs_to_a_wall_is_there_or_left_out(lived_in: Generation) -> None:
    for target in lived_in.plan.targets:
        for tie in target.ties:
            if not target.asked and target.id in lived_in.scene and tie.kind == "against_wall":
                assert measure(lived_in.scene, tie.kind, target.id, tie.anchors).holds, target.id


@pytest.mark.parametrize(
    ("prompt", "assumed"),
    [
        ("A kitchen with an island", {"base_cabinet": 3, "sink": 1, "hob": 1, "fridge": 1}),
        (
            "A small classroom for twelve pupils with a teacher's desk and a whiteboard",
            {"school_desk": 12, "chair": 13},
        ),
        ("A living room with a sofa and a reading corner", {"floor_lamp": 1, "bookcase": 1}),
        ("A classroom with four round tables and 16 chairs", {"school_desk": 0}),
        ("A classroom with 20 desks in rows", {"school_desk": 0}),
    ],
)
def test_what_a_person_would_expect_is_assumed(prompt: str, assumed: dict[str, int]) -> None:
    found: Counter[str] = Counter()
    for request in read_brief(prompt).requests:
        found[request.category] += 0 if request.asked else request.count
    assert {category: found[category] for category in assumed} == assumed


@pytest.mark.slow
def test_progress_counts_what_is_still_to_come():
    told: list[Progress] = []
    generate_room("A small study", fill="lived-in", effort=Effort(restarts=0), on_object=told.append)
    numbers = [progress.number for progress in told]
    assert numbers == list(range(1, len(told) + 1))
    assert told[-1].number == told[-1].total
    # The total is known for each stage as it begins: what the room is furnished with, and what is added in turns.
    ended = [progress for progress in told if progress.number == progress.total]
    assert len(ended) <= 1 + len(STAGES) < len(told) / 4


@pytest.mark.parametrize(
    ("prompt", "room", "held"),
    [
        ("Lobby of a small hotel", "hotel_lobby", {"luggage_cart": 1}),
        ("Waiting room of a dentist with seats for ten", "waiting_room", {"chair": 10}),
        ("A hall with benches for twelve people", "hallway", {"bench": 6}),
        ("A science classroom with lab benches for sixteen pupils", "science_lab", {"lab_bench": 8, "stool": 16}),
        ("Hair salon with four styling chairs", "salon", {"salon_chair": 4, "dressing_table": 4, "mirror": 4}),
        ("An office with six office chairs", "office", {"office_chair": 6, "desk": 6, "monitor": 6}),
        ("Home cinema with two rows of seats", "home_cinema", {"armchair": 6, "sofa": 0}),
        ("A sun room with rattan chairs", "sunroom", {"armchair": 2, "chair": 0}),
        ("A bakery with bread in the display", "bakery", {"display_case": 1, "tv": 0}),
        ("A nursery for two babies", "nursery", {"crib": 2}),
        ("Coffee shop in an old factory with a communal table", "cafe", {"chair": 4, "factory": 0}),
        ("A bakery with a stand mixer on a steel table and two tables with two chairs each", "bakery", {"chair": 4}),
        ("A doctor's consultation room with an examination couch", "clinic", {"hospital_bed": 0}),
    ],
)
def test_a_few_words_are_taken_for_what_they_mean_in_such_a_room(prompt, room, held):
    brief = read_brief(prompt)
    counts = Counter[str]()
    for request in brief.requests:
        counts[request.category] += request.count
    assert brief.room_type == room
    assert {name: counts[name] for name in held} == held


@pytest.mark.parametrize(
    ("prompt", "seed", "there", "absent"),
    [
        ("A chemistry laboratory with two lab benches", 21, {"sink", "fume_hood", "eyewash_station"}, {"skeleton"}),
        ("A doctor's examination room", 23, {"washbasin", "cabinet", "medical_screen", "keyboard"}, set()),
        ("A little cafe with a counter and six tables", 25, {"cash_register", "pastry_case", "menu_board"}, set()),
        ("An open plan office for six people", 19, {"keyboard"}, set()),
        ("A small server room with two rows of racks", 24, {"cooling_unit"}, {"picture", "plant"}),
        ("A Victorian greenhouse with a potting bench", 34, {"potted_plant"}, {"grandfather_clock", "picture"}),
        ("A pet shop", 31, {"rabbit_hutch", "aquarium", "bird_cage"}, set()),
    ],
)
def test_a_room_has_what_it_is_used_with(prompt: str, seed: int, there: set[str], absent: set[str]) -> None:
    found = {request.category for request in varied(read_brief(prompt), seed).requests}
    assert there <= found
    assert not absent & {name.removeprefix("model_") for name in found}


def test_some_things_are_needed_however_much_is_named() -> None:
    said = "A kitchen with an island, three stools, a fridge, an oven, a dishwasher and a sink along one wall"
    found = {request.category for request in varied(read_brief(said), 0).requests}
    assert {"hob", "base_cabinet"} <= found
    assert "hob" not in {r.category for r in varied(read_brief(said, fill="named"), 0, "named").requests}
    piano = read_brief("A music room with a drum kit, a guitar, an amplifier, a rug and a grand piano")
    assert any(request.category == "piano_bench" for request in piano.requests)


def test_few_lie_on_what_one_works_at_or_drinks_coffee_from() -> None:
    known = dressing()
    assert 0 < known.most_on("coffee_table", "living_room") < known.most_on("desk", "office")
    assert 0 < known.most_on("workbench", "workshop") < 10
    assert known.most_on("shelving_unit", "workshop") == 0
    assert "fish_food" in {usual.category for usual in known.on("shelving_unit", "pet_shop")}


def test_no_curtains_are_added_to_those_of_the_room() -> None:
    room = generate_room("A dining room for four", fill="named")
    dresser = Dresser(room.plan, np.random.default_rng(0))
    assert room.scene.surfaces.curtains is not None
    assert "curtain" not in {target.category for target in dresser.furniture(room.scene)}


def test_no_two_pictures_are_the_same() -> None:
    scene = Scene(room=rectangle(4.0, 3.0))
    ids = ("picture_1", "picture_2", "book_row_1", "book_row_2", "chair_1", "chair_2")
    targets = [Target(id=id, category=id[:-2], request=id[:-2]) for id in ids]
    first, second, row, other, chair, same = (asset_for(target, scene) for target in targets)
    assert first.id != second.id
    assert first.size == second.size
    assert row.id != other.id
    assert chair == same
