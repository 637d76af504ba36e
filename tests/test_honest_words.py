"""A word means what it names: no thing is served by another one in silence."""

import pytest

from thinkblox.assets.names import thing_called
from thinkblox.reading import read_brief

OTHERS = {
    "cheese board": "cutting_board",
    "sandwich": "food_tray",
    "cake stand": "plate",
    "statue": "trophy",
    "jug": "teapot",
    "newspaper": "magazine",
    "menu": "magazine",
    "notice board": "whiteboard",
    "kitchenette": "base_cabinet",
    "bouquet": "vase",
    "pencil": "pen_holder",
    "space heater": "radiator",
    "shop vacuum": "vacuum_cleaner",
    "desk chair": "chair",
    "soundbar": "speaker",
    "scanner": "printer",
    "wine rack": "shelving_unit",
    "mattress": "bed",
    "bidet": "toilet",
    "stuffed animal": "toy",
}


@pytest.mark.parametrize(("phrase", "other"), OTHERS.items())
def test_it_is_not_taken_for_another_thing(phrase: str, other: str) -> None:
    found = thing_called(phrase, len(phrase.split()))
    assert found is not None
    assert other not in (found.category, found.name)


@pytest.mark.parametrize(
    ("prompt", "category", "attributes"),
    [
        ("A room with two orange cushions.", "pillow", ("orange",)),
        ("A room with a rose armchair.", "armchair", ("rose",)),
        ("A room with a glass coffee table.", "coffee_table", ("glass",)),
        ("A room with a gold vase.", "vase", ("gold",)),
        ("A kitchen with a table and an orange on it.", "orange", ()),
    ],
)
def test_a_colour_that_is_a_thing_too_is_read_by_what_follows(
    prompt: str, category: str, attributes: tuple[str, ...]
) -> None:
    found = {request.category: request.attributes for request in read_brief(prompt).requests if request.asked}
    assert found[category] == attributes


@pytest.mark.parametrize(
    "prompt", ["I just got divorced and need a place to start over", "somewhere I can cry in peace on a sunday"]
)
def test_a_prompt_that_names_nothing_is_said_to(prompt: str) -> None:
    brief = read_brief(prompt)
    assert not [r for r in brief.requests if r.asked]
    assert brief.unknown == ("no room and no thing is named",)


def test_an_empty_room_is_all_that_was_asked() -> None:
    assert read_brief("An empty room.").unknown == ()


def test_verbs_become_no_things() -> None:
    brief = read_brief("A home gym with a treadmill where I can relax, the middle should stay empty")
    assert {r.category for r in brief.requests if r.asked} == {"treadmill"}
    assert brief.free == ("centre",)


def test_a_cat_of_any_colour_is_said_not_to_be_there() -> None:
    assert read_brief("A living room with a black cat sleeping on the rug").unknown == (
        "a black cat sleeping on the rug",
    )


def test_a_twin_bed_is_one() -> None:
    bed = next(r for r in read_brief("A bedroom with a twin bed").requests if r.category == "bed")
    assert (bed.count, bed.attributes) == (1, ("single",))


def test_the_size_that_a_thing_is_said_to_have_is_not_that_of_the_room() -> None:
    brief = read_brief("A bedroom with a bookshelf that is 2 m tall and 80 cm wide")
    assert (brief.width, brief.height) == (None, None)
    assert next(r.size for r in brief.requests if r.category == "bookcase") == (None, 0.8, 2.0)


def test_what_is_not_so_of_the_last_is_not_said_of_all() -> None:
    brief = read_brief("A nursery with two cribs and a changing table but not near the window")
    assert [(r.subject, r.negated) for r in brief.relations if r.asked] == [("changing_table", True)]


def test_no_curtains_are_no_curtains() -> None:
    from thinkblox.generate import generate_room

    surfaces = generate_room("A living room with a sofa and no curtains").scene.room.surfaces
    assert surfaces is not None
    assert surfaces.curtains is None
