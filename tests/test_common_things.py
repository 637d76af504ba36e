"""The commonest things have a shape of their own, are read as what they are, and stand where they belong."""

import pytest

from thinkblox.assets import make_asset
from thinkblox.furnishing import Generation
from thinkblox.generate import generate_room
from thinkblox.reading import read_brief
from thinkblox.sim import verify

NAMED = {
    "air conditioner": "air_conditioner",
    "loaf of bread": "bread",
    "fork": "fork",
    "frying pan": "frying_pan",
    "can of soup": "tin_can",
    "milk carton": "milk_carton",
    "toolbox": "toolbox",
    "cordless drill": "power_drill",
    "suitcase": "suitcase",
    "bucket": "bucket",
    "pinball machine": "pinball_machine",
    "baby mobile": "mobile",
    "changing table": "changing_table",
    "high chair": "high_chair",
    "dog bed": "pet_bed",
    "oxygen tank": "gas_bottle",
    "treasure chest": "chest",
    "recliner": "recliner",
    "grand piano": "grand_piano",
    "cheese board": "cheese_board",
    "floor cushion": "floor_cushion",
    "glass display case": "display_case",
    "record player": "record_player",
}


@pytest.mark.parametrize(("words", "category"), NAMED.items())
def test_it_is_read_as_what_it_is(words: str, category: str) -> None:
    brief = read_brief(f"A room with a table and a {words}.")
    assert category in {r.category for r in brief.requests if r.asked}
    assert not brief.missing


@pytest.mark.parametrize(
    ("prompt", "wanted", "other"),
    [
        ("A meeting room with a projector on the ceiling.", "ceiling_projector", "projector"),
        ("A living room with a projector on the coffee table.", "projector", "ceiling_projector"),
        ("A hall with a fire extinguisher on the wall.", "wall_extinguisher", "fire_extinguisher"),
        ("A hall with a fire extinguisher next to the door.", "fire_extinguisher", "wall_extinguisher"),
        ("A van with a bed and a surfboard on the wall.", "wall_surfboard", "surfboard"),
        ("A kitchen with a stove and a pot on the stove.", "cooking_pot", "potted_plant"),
        ("A living room with a pot in the corner.", "potted_plant", "cooking_pot"),
        ("A bathroom with a vanity.", "vanity", "dressing_table"),
        ("A bedroom with a vanity.", "dressing_table", "vanity"),
        ("A bedroom with a chest of drawers.", "dresser", "chest"),
        ("An office with a mobile phone on a desk.", "phone", "mobile"),
        ("A kitchen with a table and an orange on it.", "orange", "potted_plant"),
        ("A living room with a sofa. The sofa is orange.", "sofa", "orange"),
        ("A dining room with a table and orange chairs.", "chair", "orange"),
        ("A children's room with a small table and two chairs.", "play_table", "dining_table"),
        ("A children's room with a bed and a small table with two chairs.", "child_chair", "chair"),
        ("A children's room with a bed and a small table next to the bed.", "side_table", "play_table"),
    ],
)
def test_a_word_of_several_meanings_is_read_by_its_company(prompt: str, wanted: str, other: str) -> None:
    asked = {r.category for r in read_brief(prompt).requests if r.asked}
    assert wanted in asked
    assert other not in asked


def test_a_sectional_is_not_straight() -> None:
    request = next(r for r in read_brief("A living room with a sectional sofa.").requests if r.category == "sofa")
    made = make_asset("sofa", seed=0, attributes=request.attributes)
    assert made.size[0] > 1.3 > make_asset("sofa", seed=0).size[0]
    assert "chaise" in {surface.name for surface in made.surfaces}


@pytest.mark.parametrize("name", ["display_cabinet", "display_case", "china_cabinet", "fume_hood"])
def test_things_can_be_put_into_what_shows_them(name: str) -> None:
    assert any(surface.headroom is not None for surface in make_asset(name, seed=0).surfaces)


def _placed(prompt: str) -> Generation:
    room = generate_room(prompt, seed=0)
    assert room.report.valid
    return room


def test_a_mobile_hangs_over_the_crib() -> None:
    scene = _placed("A nursery with a crib and a mobile above the crib.").scene
    mobile, crib = scene["mobile_1"], scene["crib_1"]
    assert mobile.support == "ceiling"
    assert crib.footprint.contains(mobile.footprint.centroid)


def test_an_air_conditioner_hangs_high_and_a_range_hood_over_the_stove() -> None:
    scene = _placed("A kitchen with a stove, a range hood above the stove and an air conditioner.").scene
    assert scene["air_conditioner_1"].position[2] > 1.8
    hood, stove = scene["range_hood_1"], scene["stove_1"]
    assert hood.footprint.distance(stove.footprint) == 0.0
    assert hood.position[2] > stove.position[2] + stove.size[2] + 0.4


@pytest.mark.slow
def test_what_lies_loose_stays_where_it_was_put() -> None:
    room = _placed("A study with a desk with an apple, a banana, a screwdriver, a spoon and a soda can on it.")
    things = [p for p in room.scene.placements if p.support == "desk_1"]
    assert {p.category for p in things} == {"apple", "banana", "screwdriver", "spoon", "soda_can"}
    assert verify(room.scene).valid


def test_an_oven_named_alone_is_as_high_as_the_worktops_beside_it() -> None:
    oven, unit, machine = (make_asset(name, seed=3) for name in ("oven", "base_cabinet", "dishwasher"))
    assert oven.size[2] == unit.size[2] == machine.size[2]
    assert min(shape.position[2] for link in oven.links[1:] for shape in link.shapes) > 0.25
    low = make_asset("oven", seed=3, size=(0.56, 0.59, 0.6))
    assert min(shape.position[2] for link in low.links[1:] for shape in link.shapes) < 0.25


def test_server_racks_are_of_one_size() -> None:
    assert {make_asset("server_rack", seed=seed).size for seed in range(5)} == {(1.0, 0.6, 2.0)}
