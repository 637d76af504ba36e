"""What a prompt says of floors and walls, and what only sounds like it."""

import pytest

from thinkblox.brief import Brief
from thinkblox.reading import GrammarBriefer


def read(prompt: str) -> Brief:
    return GrammarBriefer().brief(prompt)


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("A bedroom with white walls and a carpeted floor, with a bed.", "walls:paint? floor:carpet"),
        ("A loft with brick walls, a wooden floor and a sofa.", "walls:brick floor:planks"),
        ("A kitchen with a marble floor, painted walls and a table.", "floor:marble walls:paint"),
        ("The walls are painted green and the floor is oak parquet. A desk.", "walls:paint floor:parquet"),
        ("A study with a desk and floral wallpaper.", "walls:flowers"),
        ("A carpeted office with two desks.", "floor:carpet"),
        ("A brick-walled cafe with polished concrete floors and four tables.", "walls:brick floor:concrete"),
        ("A living room with an exposed brick wall and a sofa against the brick wall.", "wall:brick"),
        ("A room with terracotta tiles on the floor; a bed.", "floor:tiles"),
        ("A kitchen with a black and white checkered floor and a stove.", "floor:checker"),
        ("A hallway with wall-to-wall carpet and a console table.", "floor:carpet"),
        ("Walls painted dark blue, light oak floorboards, a bed.", "walls:paint floor:planks"),
        ("A blue room with a bed.", "walls:paint?"),
    ],
)
def test_floors_and_walls_are_understood(prompt: str, asked: str) -> None:
    brief = read(prompt)
    wanted = {part: laying for part, _, laying in (pair.partition(":") for pair in asked.split())}
    found = {request.part: request.laying or "paint?" for request in brief.surfaces}
    assert found == wanted
    assert not brief.unknown
    assert not brief.missing


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("A room with a wooden floor lamp and a white wall clock.", "clock floor_lamp"),
        ("A living room with a sofa and a rug on the floor.", "rug sofa"),
        ("A study with a desk, without wallpaper.", "desk"),
        ("A room with a brick fireplace and a marble table.", "fireplace table"),
        ("A room with a red wall cabinet.", "wall_cabinet"),
    ],
)
def test_what_only_sounds_like_a_floor_or_wall_is_none(prompt: str, things: str) -> None:
    brief = read(prompt)
    assert brief.surfaces == ()
    named = {word for r in brief.requests if r.asked for word in (r.category, r.category.rpartition("_")[2])}
    assert all(thing in named for thing in things.split())


def test_a_wall_that_carries_something_keeps_its_look() -> None:
    brief = read("A living room with a sofa. A picture hangs on the white wall.")
    assert [(s.part, s.phrase) for s in brief.surfaces] == [("wall", "white wall")]
    assert ("picture", ("wall",)) in [(r.subject, r.anchors) for r in brief.relations]


def test_what_is_not_drawn_is_said() -> None:
    assert any("ceiling" in said for said in read("A bedroom with a painted ceiling and a bed.").unknown)
