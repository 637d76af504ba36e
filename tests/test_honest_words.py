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
        ("A room with a rose armchair.", "armchair", ("pink",)),
        ("A room with a glass coffee table.", "coffee_table", ("glass",)),
        ("A room with a gold vase.", "vase", ("yellow",)),
        ("A kitchen with a table and an orange on it.", "orange", ()),
    ],
)
def test_a_colour_that_is_a_thing_too_is_read_by_what_follows(
    prompt: str, category: str, attributes: tuple[str, ...]
) -> None:
    found = {request.category: request.attributes for request in read_brief(prompt).requests if request.asked}
    assert found[category] == attributes
