"""Shades of colours, tops and parts of their own material: read as they are said, and seen on what is made."""

from math import dist

import pytest

from thinkblox.assets import make_asset
from thinkblox.assets.palette import COLOURS, SHADES
from thinkblox.assets.repaint import PLAINLY, SAME_COLOUR, share, shows_colour
from thinkblox.assets.showing import realised
from thinkblox.evaluation.colours import is_colour_word, looks
from thinkblox.reading import read_brief


@pytest.mark.parametrize("shade", SHADES)
def test_every_shade_is_read_and_is_what_the_judge_calls_by_its_name(shade: str) -> None:
    (chair,) = read_brief(f"A {shade.replace('-', ' ')} armchair.", fill="named").requests or (None,)
    if shade not in ("rust", "sand"):  # which alone are rust and sand: "rust coloured"
        assert chair is not None
        assert (chair.category, chair.attributes, chair.unshown) == ("armchair", (shade,), ())
    if is_colour_word(name := shade.replace("-", " ")):
        assert looks(name, COLOURS[shade])


def test_a_shade_goes_by_its_general_word_too() -> None:
    brief = read_brief("A burgundy sofa and a grey armchair. The red sofa faces the window.", fill="named")
    assert [(r.category, r.attributes) for r in brief.requests] == [("sofa", ("burgundy",)), ("armchair", ("grey",))]
    assert [(r.kind, r.subject) for r in brief.relations if r.asked] == [("facing", "sofa")]
    assert not brief.unknown


@pytest.mark.parametrize("category", ["stool", "bar_cart", "bicycle", "mirror", "dresser", "ironing_board", "sofa"])
@pytest.mark.parametrize("shade", ["green", "burgundy", "light-blue"])
def test_a_colour_is_plainly_seen(category: str, shade: str) -> None:
    made = make_asset(category, seed=1, attributes=(shade,))
    assert share(made.links, lambda shape: dist(shape.colour, COLOURS[shade]) <= SAME_COLOUR) >= 0.26


@pytest.mark.parametrize(
    ("prompt", "attributes", "unshown"),
    [
        ("A marble-topped counter.", ("marble-topped",), ()),
        ("A counter with a marble top.", ("marble-topped",), ()),
        ("A counter that has a white marble top.", (), ("with a white marble top",)),
        ("A brick counter.", ("brick",), ()),
        ("A counter with brass feet.", (), ("with brass feet",)),
    ],
)  # fmt: skip
def test_tops_and_parts_are_shown_or_told(prompt: str, attributes: tuple[str, ...], unshown: tuple[str, ...]) -> None:
    (counter,) = read_brief(prompt, fill="named").requests
    assert (counter.attributes, counter.unshown) == (attributes, unshown)


@pytest.mark.parametrize(
    ("prompt", "unshown"),
    [
        ("A stool with a red leather seat.", ("with a red leather seat",)),
        ("A floor lamp with a green shade.", ("with a green shade",)),
    ],
)  # fmt: skip
def test_seats_and_shades_are_parts(prompt: str, unshown: tuple[str, ...]) -> None:
    (thing,) = read_brief(prompt, fill="named").requests
    assert thing.unshown == unshown


@pytest.mark.parametrize("category", ["coffee_table", "desk", "dresser", "nightstand"])
def test_a_top_is_of_its_material(category: str) -> None:
    made = make_asset(category, seed=1, attributes=("marble-topped",))
    assert realised(made, "marble-topped")
    assert not realised(make_asset(category, seed=1), "marble-topped")


@pytest.mark.parametrize(("look", "shade"), [("dark green", "dark-green"), ("pastel pink", "light-pink")])
def test_a_room_of_a_shade_has_walls_of_it(look: str, shade: str) -> None:
    brief = read_brief(f"A {look} study.")
    assert [(s.part, s.colour) for s in brief.surfaces] == [("walls", COLOURS[shade])]
    assert not brief.unknown


@pytest.mark.parametrize("category", ["floor_lamp", "wall_lamp", "pendant_lamp", "planter", "motorcycle", "chair"])
@pytest.mark.parametrize("colour", ["red", "black", "white", "beige", "terracotta"])
def test_so_much_has_the_colour_that_anybody_calls_it_so(category: str, colour: str) -> None:
    made = make_asset(category, seed=1, attributes=(colour,))
    assert share(made.links, lambda shape: looks(colour, shape.colour)) >= PLAINLY
    assert realised(made, colour)


def test_little_of_a_colour_does_not_show_it() -> None:
    plant = make_asset("potted_plant", seed=0, attributes=("white",))
    assert 0.0 < share(plant.links, lambda shape: shape.colour == COLOURS["white"]) < PLAINLY
    assert not realised(plant, "white")


def test_a_shade_keeps_its_light_and_chrome_is_not_white() -> None:
    lamp = make_asset("table_lamp", seed=0, attributes=("red",))
    assert any(s.material == "light" and s.colour != COLOURS["red"] for link in lamp.links for s in link.shapes)
    assert not shows_colour(make_asset("bar_stool", seed=0, attributes=("chrome",)).links, COLOURS["white"])
