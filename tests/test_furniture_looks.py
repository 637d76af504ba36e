"""What is said of all the furniture of a room at once is seen on what the room is furnished with, and is measured."""

import pytest

from thinkblox.assets import make_asset
from thinkblox.assets.showing import realised
from thinkblox.demands import demands_of
from thinkblox.plan import Plan
from thinkblox.planning import with_looks
from thinkblox.reading import read_brief
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene


@pytest.mark.parametrize(
    ("prompt", "looks", "surfaces"),
    [
        ("An old pub, dark wood", (("walnut",),), ("planks",)),
        ("A barber shop, chrome and red leather", (("chrome",), ("red", "leather")), ()),
        ("A bedroom, dark wood, green velvet", (("walnut",), ("green", "fabric")), ("planks",)),
        ("A nail salon, all pastel pink", (("light-pink",),), ("",)),
        ("A bathroom, white marble, an orchid", (), ("marble",)),
        ("A blue bedroom", (), ("",)),
    ],
)
def test_looks_are_those_of_furniture_or_of_surfaces(prompt, looks, surfaces):
    brief = read_brief(prompt)
    assert brief.looks == looks
    assert tuple(s.laying or "" for s in brief.surfaces) == surfaces
    assert not brief.unknown
    assert not any(r.category in ("marble", "glass_marble") for r in brief.requests)


def test_a_floor_of_stone_has_the_colour_that_is_said_with_it():
    (floor,) = read_brief("A bathroom, white marble, an orchid").surfaces
    assert floor.part == "floor"
    assert floor.colour is not None
    assert min(floor.colour) > 0.9


def test_marbles_are_still_toys():
    assert [r.count for r in read_brief("A playroom with five marbles on the rug").requests if r.count == 5] == [5]


@pytest.mark.parametrize(
    ("prompt", "category", "words"),
    [
        ("An old pub, dark wood", "bar_counter", ("walnut",)),
        ("A dark academia private library", "bookcase", ("walnut",)),
        ("A barber shop, chrome and red leather", "barber_chair", ("chrome", "red", "leather")),
        ("A nail salon, all pastel pink", "counter", ("light-pink",)),
    ],
)
def test_what_is_assumed_shows_them(prompt, category, words):
    brief = with_looks(read_brief(prompt))
    request = next(r for r in brief.requests if r.category == category)
    assert set(words) <= set(request.attributes)
    for seed in range(3):
        made = make_asset(category, seed=seed, attributes=request.attributes)
        assert all(realised(made, word) for word in words)


def test_what_the_prompt_names_keeps_what_is_said_of_it():
    brief = with_looks(read_brief("A dark academia library with a white bookcase"))
    assert next(r for r in brief.requests if r.category == "bookcase").attributes == ("white", "filled")


def test_a_room_without_such_furniture_is_not_as_asked():
    brief = read_brief("A barber shop, red leather")
    room = Room(floor=((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)), height=2.5)
    demands = demands_of(Scene(prompt=brief.prompt, seed=0, room=room), Plan(brief=brief, targets=()))
    assert [(d.wanted, d.holds) for d in demands if d.subject == "furniture"] == [("red leather", False)]
