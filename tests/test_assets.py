"""Every category, seed and variant: the shapes fill the box, and everything is plausible."""

from math import isfinite, prod

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from thinkblox.assets import CATALOGUE, Category, fit_asset, make_asset
from thinkblox.assets.palette import CHROME
from thinkblox.assets.repaint import share
from thinkblox.assets.showing import realised
from thinkblox.errors import InputError
from thinkblox.reading import read_brief
from thinkblox.scene.asset import Asset, Shape
from thinkblox.value import Vec3, from_json, to_json

SHAPED = {name: category for name, category in CATALOGUE.items() if not category.plain}
GENERAL = ((2, ("round", "red")), (4, ("small", "low")))


def makes_of(name: str) -> list[tuple[int, tuple[str, ...]]]:
    """Seeds and attributes with which a category is looked at."""
    return [*((seed, ()) for seed in range(3)), *((1, (word,)) for word in SHAPED[name].variants)]


def extent(shape: Shape) -> tuple[np.ndarray, np.ndarray]:
    centre = np.array(shape.position)
    if shape.kind == "hull":
        points = np.array(shape.points) + centre
        return points.min(axis=0), points.max(axis=0)
    size = np.array(shape.size)
    _, x, y, _ = shape.quat_wxyz
    if x or y:
        size = size[[2, 1, 0]] if y else size[[0, 2, 1]]
    return centre - size / 2, centre + size / 2


def shapes_of(asset: Asset) -> list[Shape]:
    return [shape for link in asset.links for shape in link.shapes]


@pytest.mark.parametrize("name", SHAPED)
def test_every_make_fills_its_box_has_sound_surfaces_and_plausible_numbers(name: str) -> None:
    for seed, words in (*makes_of(name), *GENERAL):
        asset = make_asset(name, seed=seed, attributes=words)
        try:
            check_box(asset)
            if (seed, words) not in GENERAL:
                check_surfaces(asset)
                check_numbers(asset)
        except AssertionError as error:
            error.add_note(f"seed {seed}, {words}")
            raise


def check_box(asset: Asset) -> None:
    boxes = [extent(shape) for shape in shapes_of(asset)]
    lo, hi = np.min([b[0] for b in boxes], axis=0), np.max([b[1] for b in boxes], axis=0)
    x, y, z = asset.size
    assert lo == pytest.approx([-x / 2, -y / 2, 0.0], abs=1e-6)
    assert hi == pytest.approx([x / 2, y / 2, z], abs=1e-6)


def check_surfaces(asset: Asset) -> None:
    tops = [extent(shape) for shape in shapes_of(asset)]
    for surface in asset.surfaces:
        x, y, z = surface.position
        assert z <= asset.size[2] + 1e-6
        assert abs(x) + surface.size[0] / 2 <= asset.size[0] / 2 + 2e-4
        assert abs(y) + surface.size[1] / 2 <= asset.size[1] / 2 + 2e-4
        assert surface.headroom is None or surface.headroom > 0.03
        for u, v in ((0.1, 0.1), (0.6, 0.6), (0.6, -0.6), (-0.6, 0.6), (-0.6, -0.6)):
            at = (x + u * surface.size[0] / 2, y + v * surface.size[1] / 2)
            backed = [hi for lo, hi in tops if abs(hi[2] - z) < 6e-4 and _covers(lo, hi, at)]
            assert backed, f"{surface.name} of {asset.id} has nothing under {at}"


def _covers(lo: np.ndarray, hi: np.ndarray, at: tuple[float, float]) -> bool:
    return all(lo[i] - 1e-3 <= at[i] <= hi[i] + 1e-3 for i in range(2))


def check_numbers(asset: Asset) -> None:
    assert 0.05 <= asset.mass <= 600
    assert 0.2 <= asset.friction <= 1.0
    assert 2 <= asset.mass / prod(asset.size) <= 6000
    solid = [s for s in shapes_of(asset) if s.collide]
    assert len(solid) <= 130
    assert all(isfinite(v) for s in shapes_of(asset) for v in (*s.size, *s.position))
    assert all(min(s.size) > 0 for s in shapes_of(asset))
    assert from_json(to_json(asset), Asset) == asset


@pytest.mark.parametrize("name", SHAPED)
def test_only_rugs_and_mats_are_walked_on(name: str) -> None:
    category = CATALOGUE[name]
    assert make_asset(name, seed=0).collides is not category.flat


def test_the_same_seed_gives_the_same_bytes() -> None:
    from thinkblox.assets import make

    first = to_json(make_asset("sofa", seed=7, attributes=("three-seat",)))
    make._made.cache_clear()
    assert to_json(make_asset("sofa", seed=7, attributes=("three-seat",))) == first
    assert make_asset("sofa", seed=7).id != make_asset("sofa", seed=8).id


@st.composite
def category_and_size(draw: st.DrawFn) -> tuple[Category, Vec3]:
    category = CATALOGUE[draw(st.sampled_from(sorted(CATALOGUE)))]
    least, most = category.size_range
    x, y, z = (round(draw(st.floats(lo, hi)), 4) for lo, hi in zip(least, most, strict=True))
    return category, (max(x, least[0]), max(y, least[1]), max(z, least[2]))


@settings(max_examples=150, deadline=None)
@given(category_and_size(), st.integers(0, 50))
@example((CATALOGUE["plant"], (1.0, 1.0, 3.0)), 2)  # a leaf that grows wholly outside
@example((CATALOGUE["soap_dispenser"], (0.1061, 0.0433, 0.1399)), 33)  # round, between two points of the grid
def test_any_size_in_the_range_is_hit(wanted: tuple[Category, Vec3], seed: int) -> None:
    category, size = wanted
    asset = fit_asset(make_asset(category.name, seed=seed), size)
    boxes = [extent(shape) for shape in shapes_of(asset)]
    hi = np.max([b[1] for b in boxes], axis=0) - np.min([b[0] for b in boxes], axis=0)
    assert asset.size == pytest.approx(size, abs=1e-4)
    assert hi == pytest.approx(asset.size, abs=2e-6)


def test_fitting_keeps_seed_and_attributes() -> None:
    bed = make_asset("bed", seed=3, attributes=("double", "oak"))
    assert fit_asset(bed, bed.size) == bed
    longer = fit_asset(bed, (2.2, 1.5, 1.0))
    assert (longer.size, longer.attributes) == ((2.2, 1.5, 1.0), ("double", "oak"))


def test_attributes_change_what_is_made() -> None:
    def size(name: str, *words: str) -> Vec3:
        return make_asset(name, seed=0, attributes=words).size

    assert size("bed", "king")[1] > size("bed", "double")[1] > size("bed", "single")[1]
    assert size("dining_table", "for six")[1] < size("dining_table", "for-10")[1]
    assert size("bookcase", "low")[2] < 1.0 < size("bookcase")[2]
    assert size("sofa", "two-seat")[1] < size("sofa", "three-seat")[1]
    across = size("dining_table", "round")
    assert across[0] == across[1]
    red = make_asset("chair", seed=0, attributes=("red",))
    assert any(s.colour[0] > 2 * s.colour[2] for s in shapes_of(red))
    books = make_asset("bookcase", seed=0, attributes=("filled",))
    assert len(shapes_of(books)) > len(shapes_of(make_asset("bookcase", seed=0))) + 10


@pytest.mark.parametrize("category", ["conference_table", "dining_table", "kitchen_table", "desk", "coffee_table"])
@pytest.mark.parametrize(
    "words", [("round",), ("round", "for-2"), ("round", "for-3"), ("square", "for-4"), ("round", "small")]
)
def test_what_is_round_or_square_on_the_floor_is_as_deep_as_wide(category: str, words: tuple[str, ...]) -> None:
    for seed in range(5):
        depth, width, _ = make_asset(category, seed=seed, attributes=words).size
        assert depth == pytest.approx(width, abs=1e-6)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("category", ["mirror", "clock", "picture"])
def test_what_is_round_or_square_on_a_wall_is_as_high_as_wide(category: str, seed: int) -> None:
    for word in ("round", "square"):
        _, wide, high = make_asset(category, seed=seed, attributes=(word,)).size
        assert wide == pytest.approx(high, rel=0.03)


def test_unknown_attributes_are_ignored() -> None:
    assert make_asset("chair", seed=1, attributes=("quixotic",)).size == make_asset("chair", seed=1).size


def test_seats_go_under_tables() -> None:
    for seed in range(6):
        for table in ("dining_table", "kitchen_table", "desk", "school_desk", "conference_table", "corner_desk"):
            made = make_asset(table, seed=seed)
            under = [extent(s)[0][2] for s in shapes_of(made) if extent(s)[1][2] > made.size[2] - 0.001]
            assert min(under) > 0.6
        for seat in ("chair", "office_chair"):
            surface = make_asset(seat, seed=seed).surfaces[0]
            assert 0.4 < surface.position[2] < 0.5


def test_errors_say_what_to_do() -> None:
    with pytest.raises(InputError, match="wardrobe"):
        make_asset("wardrobes", seed=0)
    with pytest.raises(InputError, match=r"width .* to "):
        make_asset("bed", seed=0, size=(2.0, 9.0, 1.0))
    with pytest.raises(InputError, match="negative"):
        make_asset("bed", seed=-1)


@pytest.mark.parametrize("name", ["treadmill", "exercise_bike", "rowing_machine"])
def test_who_trains_looks_over_the_front(name: str) -> None:
    """The console or the highest part of it is before the middle."""
    asset = make_asset(name, seed=0)
    highest = max(shapes_of(asset), key=lambda shape: extent(shape)[1][2])
    assert highest.position[0] > 0.15 * asset.size[0]


@pytest.mark.parametrize("name", ["piano", "electric_piano", "pipe_organ", "electric_organ"])
def test_a_piano_is_played_from_its_front(name: str) -> None:
    keys = [shape for shape in shapes_of(make_asset(name, seed=0)) if min(shape.colour) > 0.8]
    assert keys
    assert all(shape.position[0] > 0.0 for shape in keys)


@pytest.mark.parametrize("name", ["wall_bicycle", "wall_guitar", "wall_surfboard"])
def test_what_hangs_on_a_wall_lies_flat_against_it(name: str) -> None:
    asset = make_asset(name, seed=0)
    assert asset.mount == "wall"
    assert asset.size[0] < 0.6 * min(asset.size[1:])


@pytest.mark.parametrize(
    ("category", "words"),
    [
        ("floor_lamp", ("brass",)),
        ("locker", ("steel",)),
        ("chest", ("cedar",)),
        ("side_table", ("terrazzo",)),
        ("bed", ("queen", "four-poster")),
        ("nightstand", ("round",)),
        ("dresser", ("6-drawers",)),
        ("base_cabinet", ("3-drawers",)),
        ("cabinet", ("3-drawers", "2-doors")),
        ("wardrobe", ("3-doors",)),
        ("floor_cushion", ("round",)),
        ("monitor", ("ultrawide",)),
        ("guitar", ("electric",)),
        ("washbasin", ("double",)),
    ],
)
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_what_is_said_of_a_thing_is_seen_on_it(category: str, words: tuple[str, ...], seed: int) -> None:
    asset = make_asset(category, seed=seed, attributes=words)
    assert [realised(asset, word) for word in words] == [True] * len(words)


@pytest.mark.parametrize("seed", range(4))
def test_a_wooden_stool_has_no_legs_of_metal(seed: int) -> None:
    asset = make_asset("bar_stool", seed=seed, attributes=("wooden",))
    assert share(asset.links, lambda shape: shape.material == "metal") < 0.12


def test_a_double_washbasin_has_two_basins_and_a_freestanding_bath_stands_by_itself() -> None:
    basins, baths = (
        [
            make_asset(request.category, seed=1, attributes=request.attributes)
            for text in texts
            for request in read_brief(f"A bathroom with a {text}.").requests
            if request.asked
        ]
        for texts in (("washbasin", "double washbasin"), ("bath", "freestanding bath"))
    )
    taps = [sum(shape.colour == CHROME.colour for shape in shapes_of(asset)) for asset in basins]
    assert taps[1] == 2 * taps[0]
    assert basins[1].size[1] > 1.6 * basins[0].size[1]
    assert [reaches_its_corner(bath) for bath in baths] == [True, False]


def reaches_its_corner(asset: Asset) -> bool:
    highest = (extent(shape)[1] / asset.size for shape in shapes_of(asset))
    return any(x > 0.45 and y > 0.45 for x, y, _ in highest)


def test_what_one_washes_or_shows_in_has_a_hollow() -> None:
    for name in ("laundry_sink", "commercial_sink", "cake_display", "pastry_case"):
        assert any(surface.within for surface in make_asset(name, seed=0).surfaces), name


def test_a_mini_fridge_is_small() -> None:
    fridge = next(r for r in read_brief("A bedroom with a mini fridge.").requests if r.asked)
    assert make_asset(fridge.category, seed=1, attributes=fridge.attributes).size[2] < 0.7


def test_for_how_many_a_thing_is_said_after_its_name() -> None:
    table = make_asset("dining_table", seed=0, attributes=("long", "for-6"))
    assert table.description == "long dining table for 6"
    assert table.name == "dining table"
    assert table.called("reading table").description == "long reading table for 6"
    assert make_asset("bed", seed=0, attributes=("white",)).name == "bed"


@pytest.mark.parametrize("name", ["changing_table", "luggage_cart", "brazier"])
def test_what_things_are_put_on_has_a_place_for_them(name: str) -> None:
    asset = make_asset(name, seed=1)
    assert any(not surface.within and min(surface.size) > 0.2 for surface in asset.surfaces)
