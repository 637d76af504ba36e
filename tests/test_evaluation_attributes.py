import pytest

from tests.judged_rooms import WALLS, demands, part, scene, table, thing
from thinkblox.assets import palette
from thinkblox.evaluation.appearance import patches
from thinkblox.evaluation.attributes import shows
from thinkblox.evaluation.bodies import Body
from thinkblox.evaluation.colours import is_colour_word, lch, looks
from thinkblox.evaluation.room_file import (
    JointRecord,
    LinkRecord,
    LookRecord,
    MeshRecord,
    PlacementRecord,
    SeenAsset,
    ShapeRecord,
)
from thinkblox.evaluation.room_judge import judge_room


def test_lightness_chroma_and_hue_of_known_colours():
    assert lch((1.0, 1.0, 1.0)) == pytest.approx((100.0, 0.0, lch((1.0, 1.0, 1.0))[2]), abs=0.02)
    assert lch((0.0, 0.0, 0.0))[:2] == pytest.approx((0.0, 0.0), abs=0.02)
    assert lch((1.0, 0.0, 0.0)) == pytest.approx((53.24, 104.55, 40.0), abs=0.05)
    assert lch((0.0, 0.0, 1.0)) == pytest.approx((32.30, 133.81, 306.29), abs=0.05)


@pytest.mark.parametrize(
    ("srgb", "words", "others"),
    [
        ((0.9, 0.1, 0.1), {"red", "crimson"}, {"blue", "pink", "brown", "orange"}),
        ((0.15, 0.35, 0.75), {"blue", "royal blue", "dark blue"}, {"green", "purple", "light blue"}),
        ((0.7, 0.82, 0.95), {"blue", "light blue"}, {"dark blue", "white", "navy"}),
        ((0.95, 0.95, 0.93), {"white"}, {"black", "grey", "yellow", "beige"}),
        ((0.05, 0.05, 0.06), {"black"}, {"white", "grey", "brown"}),
        ((0.5, 0.5, 0.5), {"grey", "gray"}, {"black", "white", "beige"}),
        ((0.93, 0.74, 0.2), {"yellow", "golden"}, {"red", "green", "white"}),
        ((0.13, 0.42, 0.30), {"green", "dark green", "bottle green"}, {"blue", "yellow"}),
        ((0.43, 0.29, 0.20), {"brown"}, {"red", "grey", "black"}),
        ((0.95, 0.65, 0.72), {"pink"}, {"red", "purple", "white"}),
        ((0.45, 0.15, 0.60), {"purple", "violet"}, {"blue", "pink"}),
        ((0.45, 0.08, 0.15), {"burgundy", "maroon"}, {"pink", "orange"}),
        ((0.1, 0.45, 0.45), {"teal"}, {"red", "yellow", "purple"}),
        ((0.95, 0.5, 0.1), {"orange"}, {"blue", "pink"}),
    ],
)
def test_words_of_colour(srgb, words, others):
    assert {word for word in words if looks(word, srgb)} == words
    assert {word for word in others if looks(word, srgb)} == set()


def test_what_is_no_colour():
    assert not is_colour_word("round")
    assert not is_colour_word("light")
    with pytest.raises(KeyError):
        looks("round", (0.0, 0.0, 0.0))


@pytest.mark.parametrize(
    ("finish", "word"),
    [
        (palette.OAK, "oak"),
        (palette.WALNUT, "walnut"),
        (palette.BRASS, "brass"),
        (palette.CHROME, "chrome"),
        (palette.COGNAC, "leather"),
        (palette.MARBLE, "marble"),
        (palette.PORCELAIN, "ceramic"),
        (palette.WICKER, "wicker"),
        (palette.NAVY_WOOL, "navy"),
        (palette.MUSTARD_WOOL, "mustard"),
        (palette.SAGE_WOOL, "green"),
        (palette.TEAL_GLAZE, "teal"),
        (palette.WHITE_PAINT, "white"),
        (palette.IRON, "black"),
        (palette.GREY_WOOL, "grey"),
    ],
)
def test_finishes_are_what_their_names_say(finish, word):
    body = thing(
        "thing", (3.0, 2.0), parts=[part((0.5, 0.5, 0.5), (0, 0, 0.25), colour=finish.colour, material=finish.material)]
    )
    assert shows(body, word, "thing", WALLS).holds, shows(body, word, "thing", WALLS)


def dressed(*looks):
    """An object of equal boxes, each of a colour and a material."""
    return thing("sofa", (3.0, 2.0), (1.0, 1.0, 1.0), parts=[
        part((1.0, 1.0, 0.2), (0.0, 0.0, 0.1), colour=colour, material=material) for colour, material in looks
    ])  # fmt: skip


RED, BLUE = (0.8, 0.1, 0.1), (0.1, 0.2, 0.7)


def test_a_colour_of_the_smaller_part_is_none_of_the_whole():
    mostly_blue = dressed((BLUE, "fabric"), (BLUE, "fabric"), (BLUE, "fabric"), (RED, "wood"))
    assert shows(mostly_blue, "blue", "sofa", WALLS).holds
    assert not shows(mostly_blue, "red", "sofa", WALLS).holds
    assert shows(mostly_blue, "wooden", "sofa", WALLS).holds
    assert not shows(mostly_blue, "leather", "sofa", WALLS).holds


def test_a_mesh_lends_its_colour():
    shape = ShapeRecord("box", (1.0, 1.0, 1.0), (0.0, 0.0, 0.5), colour=RED)
    link = LinkRecord((shape,), visuals=(MeshRecord(LookRecord(BLUE)),))
    body = Body(PlacementRecord("a_1", "a", "a", (0.0, 0.0, 0.0), 0.0, (1.0,) * 3), SeenAsset("a", (1.0,) * 3, (link,)))
    assert [patch.colour for patch in patches(body)] == [BLUE]


def disc(size):
    return thing("table", (3.0, 2.0), size, parts=[ShapeRecord("cylinder", size, (0.0, 0.0, size[2] / 2))])


L_SHAPE = thing("sofa", (3.0, 2.0), (2.0, 2.4, 0.8), parts=[
    part((0.9, 2.4, 0.8), (-0.55, 0.0, 0.4)), part((2.0, 0.9, 0.8), (0.0, 0.75, 0.4))
])  # fmt: skip
LOFT = thing("loft_bed", (3.0, 2.0), (2.0, 1.0, 1.7), parts=[
    part((2.0, 1.0, 0.3), (0.0, 0.0, 1.5)), part((0.1, 0.1, 1.7), (0.9, 0.4, 0.85))
])  # fmt: skip
ROUND_MIRROR = thing("mirror", (3.0, 4.98, 1.2), (0.03, 0.6, 0.6), mount="wall", yaw=270.0, parts=[
    ShapeRecord("cylinder", (0.6, 0.6, 0.03), (0.0, 0.0, 0.3), (0.5**0.5, 0.0, 0.5**0.5, 0.0))
])  # fmt: skip


@pytest.mark.parametrize(
    ("body", "word", "expected"),
    [
        (disc((0.8, 0.8, 0.4)), "round", True),
        (disc((0.8, 0.8, 0.4)), "square", False),
        (disc((0.7, 1.4, 0.4)), "oval", True),
        (disc((0.7, 1.4, 0.4)), "round", False),
        (table("table", (3.0, 2.0), (0.8, 0.8, 0.7)), "square", True),
        (table("table", (3.0, 2.0), (0.8, 0.8, 0.7)), "round", False),
        (table("table", (3.0, 2.0), (0.8, 1.6, 0.7)), "rectangular", True),
        (table("table", (3.0, 2.0), (0.8, 1.6, 0.7)), "long", True),
        (table("table", (3.0, 2.0), (0.8, 1.0, 0.7)), "long", False),
        (ROUND_MIRROR, "round", True),
        (ROUND_MIRROR, "wall-mounted", True),
        (L_SHAPE, "L-shaped", True),
        (thing("sofa", (3.0, 2.0), (0.9, 2.0, 0.8)), "L-shaped", False),
        (thing("bed", (3.0, 2.0), (2.0, 1.6, 0.9)), "queen", True),
        (thing("bed", (3.0, 2.0), (2.0, 1.6, 0.9)), "king", False),
        (thing("bed", (3.0, 2.0), (2.0, 0.9, 0.9)), "single", True),
        (thing("vanity", (3.0, 2.0), (0.55, 1.5, 0.9)), "double", True),
        (thing("vanity", (3.0, 2.0), (0.55, 0.9, 0.9)), "double", False),
        (thing("sink", (3.0, 2.0), (0.48, 0.54, 0.3)), "double", False),
        (thing("desk", (3.0, 2.0), (0.6, 1.2, 0.75)), "single", True),
        (thing("desk", (3.0, 2.0), (0.6, 1.8, 0.75)), "single", False),
        (thing("hoverboard", (3.0, 2.0)), "double", None),
        (thing("table_lamp", (3.0, 2.0), (0.15, 0.15, 0.3)), "small", True),
        (thing("table_lamp", (3.0, 2.0), (0.15, 0.15, 0.3)), "big", False),
        (thing("bookcase", (3.0, 2.0), (0.3, 0.9, 2.2)), "tall", True),
        (thing("cabinet", (3.0, 2.0), (0.4, 0.9, 0.5)), "low", True),
        (thing("cabinet", (3.0, 2.0), (0.4, 0.9, 1.2)), "low", False),
        (thing("plant", (3.0, 2.0), (0.6, 0.6, 1.8)), "large", True),
        (thing("mirror", (3.0, 2.0), (0.03, 0.5, 1.6)), "full-length", True),
        (thing("monitor", (3.0, 2.0), (0.2, 1.0, 0.4)), "ultrawide", True),
        (thing("piano", (3.0, 2.0), (0.6, 1.5, 1.2)), "grand", False),
        (thing("piano", (3.0, 2.0), (1.6, 1.5, 1.0)), "grand", True),
        (thing("bed", (3.0, 2.0), (2.0, 1.6, 2.0)), "four-poster", True),
        (thing("bed", (3.0, 2.0), (2.0, 1.6, 0.9)), "four-poster", False),
        (thing("rug", (3.0, 2.0), (1.6, 2.3, 0.01)), "rolled up", False),
        (LOFT, "loft", True),
        (thing("bed", (3.0, 2.0), (2.0, 1.6, 1.6)), "loft", False),
        (L_SHAPE, "sectional", True),
        (thing("hoverboard", (3.0, 2.0)), "small", None),
        (thing("sofa", (3.0, 2.0)), "chesterfield", None),
        (thing("laptop", (3.0, 2.0)), "open", None),
    ],
)
def test_words_of_shape_and_size(body, word, expected):
    shown = shows(body, word, body.asset.category, WALLS)
    assert shown.holds is expected, shown.says


def test_drawers_are_counted():
    links = tuple(
        LinkRecord((ShapeRecord("box", (0.4, 0.4, 0.1), (0.0, 0.0, 0.05)),), JointRecord(kind))
        for kind in ("slide", "slide", "slide", "hinge")
    )
    record = PlacementRecord("a_1", "a", "a", (0.0, 0.0, 0.0), 0.0, (0.4, 0.4, 0.4))
    body = Body(record, SeenAsset("base_cabinet", (0.4, 0.4, 0.4), links))
    assert shows(body, "three drawers", "base cabinet", WALLS).holds
    assert not shows(body, "2 drawers", "base cabinet", WALLS).holds


def test_rows_of_attributes():
    room = scene(
        thing("chair_1", (1.0, 1.0), parts=[part((0.5, 0.5, 0.5), (0, 0, 0.25), colour=RED)]),
        thing("chair_2", (3.0, 1.0), parts=[part((0.5, 0.5, 0.5), (0, 0, 0.25), colour=BLUE)]),
    )
    rows = [
        ["eq", 1, "chair", "red"],
        ["eq", 2, "chair", "red"],
        ["ge", 1, "chair", "red", "wooden"],
        ["eq", 1, "chair", "red", "leather"],
        ["eq", 1, "chair", "comfortable"],
        ["eq", 1, "sofa", "red"],
        ["eq", 1, "sofa", "comfortable"],
    ]
    assert [row.met for row in judge_room(demands(attributes=rows), room)] == [
        True,
        False,
        True,
        False,
        None,
        False,
        None,
    ]
