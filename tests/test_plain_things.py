"""The table of plain things: each is made at its size, of solids of a sane density, and stays upright."""

from collections import Counter

import mujoco
import numpy as np
import pytest

from tests.test_assets import extent, shapes_of
from thinkblox.assets import CATALOGUE, GENERAL_WORDS, make_asset
from thinkblox.assets.catalogue import phrases
from thinkblox.assets.palette import MIRROR, PAPER, PORCELAIN
from thinkblox.assets.part import Finish
from thinkblox.assets.plain import SHAPES, plain_categories, plain_generator, table_lines, words_of_line
from thinkblox.assets.plain.places import KEEPING
from thinkblox.assets.repaint import share
from thinkblox.assets.stand_ins import stand_in
from thinkblox.errors import InputError
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec
from thinkblox.sim.geometry.solid import solid_of
from thinkblox.value import Vec3, from_json, to_json

PLAIN = {name: category for name, category in CATALOGUE.items() if category.plain}
FREE = [name for name, category in PLAIN.items() if category.mount in ("floor", "surface") and not category.flat]
SPACING = 6.0
HOLLOW = {"balloon_bunch", "swim_ring", "tunnel"}
"""Full of air, and so lighter than anything solid."""


def test_there_are_many() -> None:
    assert len(PLAIN) >= 900


def test_every_word_of_the_table_stands_in_it_once() -> None:
    forms = [
        form for _, columns in table_lines() for word in words_of_line(columns) for form in set(word.split("|")) - {""}
    ]
    assert [form for form, count in Counter(forms).items() if count > 1] == []
    assert [form for form in forms if form != form.lower() or "_" in form] == []


def test_every_shape_and_every_place_is_used() -> None:
    lines = [columns for _, columns in table_lines()]
    assert {columns[3].split()[0] for columns in lines} == set(SHAPES)
    assert {columns[4] for columns in lines} == set(KEEPING)


def test_no_word_of_it_means_something_that_has_a_shape() -> None:
    shaped = {**GENERAL_WORDS, **{name: kind for name, kind in CATALOGUE.items() if not kind.plain}}
    owned = {phrase for kind in shaped.values() for phrase in phrases(kind)}
    owned |= {kind.noun for kind in CATALOGUE.values() if not kind.plain}
    assert {phrase for kind in PLAIN.values() for phrase in (*phrases(kind), kind.noun)} & owned == set()
    assert PLAIN.keys() & shaped.keys() == set()


def test_what_is_given_a_shape_is_taken_from_the_table() -> None:
    kinds = {kind.name: kind for kind in plain_categories({"wok", "skillet"}, {"kettle"})}
    assert "wok" not in kinds
    assert "frying_pan" in kinds
    assert "skillet" not in set(phrases(kinds["frying_pan"]))
    renamed = {kind.name for kind in plain_categories({"frying pan"}, ())}
    assert "frying_pan" not in renamed
    assert "skillet" in renamed


def misfit(name: str, size: Vec3 | None) -> float:
    """How far the shapes of one are from filling their box [m]."""
    asset = make_asset(name, seed=1, size=size)
    boxes = [extent(shape) for shape in shapes_of(asset)]
    lo, hi = np.min([b[0] for b in boxes], axis=0), np.max([b[1] for b in boxes], axis=0)
    x, y, z = asset.size
    return float(np.abs([*(lo - (-x / 2, -y / 2, 0.0)), *(hi - (x / 2, y / 2, z))]).max())


def test_each_fills_its_box_at_its_least_or_greatest_size() -> None:
    some = list(PLAIN.items())[::4]
    misfits = {name: misfit(name, kind.size_range[n % 2]) for n, (name, kind) in enumerate(some)}
    assert {name for name, by in misfits.items() if by > 2e-6} == set()


@pytest.mark.slow
def test_each_fills_its_box_at_any_of_its_sizes() -> None:
    sizes = {name: (None, kind.size, kind.size_range[0], kind.size_range[1]) for name, kind in PLAIN.items()}
    assert {name for name in PLAIN if max(misfit(name, size) for size in sizes[name]) > 2e-6} == set()


EVERY = pytest.mark.parametrize("step", [5, pytest.param(1, marks=pytest.mark.slow)])
"""Every so many of the plain things."""


@EVERY
def test_each_has_its_mass_and_a_sane_density(step: int) -> None:
    dense = {}
    for name, kind in list(PLAIN.items())[::step]:
        asset = make_asset(name, seed=1, size=kind.size)
        assert asset.mass == pytest.approx(kind.mass, rel=0.01)
        assert asset.collides is not kind.flat
        assert len(shapes_of(asset)) <= 64
        dense[name] = asset.mass / (1.0 if kind.flat else solid_of(asset).volume)
    least = {name: 2 if name in HOLLOW else 20 for name in dense}
    assert {n: d for n, d in dense.items() if not least[n] <= d <= 12_000 and not PLAIN[n].flat} == {}


@EVERY
def test_their_surfaces_are_within_them_and_backed(step: int) -> None:
    for name in list(PLAIN)[::step]:
        asset = make_asset(name, seed=1)
        tops = [extent(shape) for shape in shapes_of(asset)] if asset.surfaces else []
        for surface in asset.surfaces:
            x, y, z = surface.position
            assert abs(x) + surface.size[0] / 2 <= asset.size[0] / 2 + 2e-4, name
            assert abs(y) + surface.size[1] / 2 <= asset.size[1] / 2 + 2e-4, name
            backed = [hi for lo, hi in tops if abs(hi[2] - z) < 6e-4 and lo[0] - 1e-3 <= x <= hi[0] + 1e-3]
            assert backed, f"{name}: {surface.name} has nothing under it"


def settled(names: list[str]) -> dict[str, tuple[float, float]]:
    """How far each has moved [m] and turned [degrees] after a second on the floor, all in one room."""
    side = int(np.ceil(np.sqrt(len(names))))
    extent = side * SPACING
    placements, assets = [], {}
    for number, name in enumerate(names):
        asset = make_asset(name, seed=1)
        assets[asset.id] = asset
        at = ((number % side + 0.5) * SPACING, (number // side + 0.5) * SPACING, 0.0)
        placements.append(
            Placement(id=f"{name}_1", category=name, asset=asset.id, position=at, yaw=0.0, size=asset.size)
        )
    room = Room(floor=((0.0, 0.0), (extent, 0.0), (extent, extent), (0.0, extent)), height=4.0)
    scene = Scene(prompt="", seed=0, room=room, assets=assets, placements=tuple(placements))
    model = build_spec(scene).compile()
    data = mujoco.MjData(model)
    start = None
    while data.time < 1.0:
        mujoco.mj_step(model, data)
        start = data.qpos.copy() if start is None else start
    poses = data.qpos.reshape(-1, 7)
    moved = np.linalg.norm((data.qpos - start).reshape(-1, 7)[:, :3], axis=1)
    turned = 2 * np.degrees(np.arccos(np.clip(np.abs(poses[:, 3]), 0.0, 1.0)))
    return {name: (float(m), float(t)) for name, m, t in zip(names, moved, turned, strict=True)}


def fallen(names: list[str]) -> dict[str, tuple[float, float]]:
    return {name: how for name, how in settled(names).items() if how[0] > 0.002 or how[1] > 0.5}


def test_a_sample_of_them_stays_upright() -> None:
    assert fallen(FREE[::25]) == {}


@pytest.mark.slow
@pytest.mark.parametrize("start", range(0, len(FREE), 50))
def test_all_of_them_stay_upright(start: int) -> None:
    assert fallen(FREE[start : start + 50]) == {}


def test_they_survive_being_written_and_read() -> None:
    for name in list(PLAIN)[::40]:
        asset = make_asset(name, seed=2, attributes=("red",))
        assert from_json(to_json(asset), Asset) == asset


def test_a_colour_that_is_asked_for_is_shown() -> None:
    red = make_asset("grill_pan", seed=0, attributes=("red",))
    assert any(shape.colour[0] > 2 * shape.colour[2] for shape in shapes_of(red))


def test_a_solid_or_finish_that_there_is_not_is_refused() -> None:
    with pytest.raises(InputError, match=r"no plain shape 'blob'; there are .*wedge"):
        plain_generator("blob", "red")
    with pytest.raises(InputError, match=r"no colour or finish 'puce'; there are .*walnut"):
        plain_generator("ball", "puce")
    with pytest.raises(InputError, match="no material 'jam'; there are wood"):
        plain_generator("ball", "red.jam")


@pytest.mark.parametrize(
    ("name", "finish"),
    [
        ("styling station", MIRROR),
        ("changing cubicle", MIRROR),
        ("shampoo basin", PORCELAIN),
        ("grandfather clock", PORCELAIN),
        ("examination table", PAPER),
        ("hymn board", PAPER),
    ],
)
def test_things_show_what_they_are_known_by(name: str, finish: Finish) -> None:
    links = make_asset(stand_in(name).category.name, seed=0).links
    assert share(links, lambda shape: shape.colour == finish.colour) > 0.01


def test_stained_glass_has_many_colours() -> None:
    window = make_asset("stained_glass_window", seed=0)
    assert len({shape.colour for link in window.links for shape in link.shapes}) >= 5


def test_a_skeleton_has_bones_whatever_it_is_called() -> None:
    for name in ("skeleton", "model skeleton", "anatomical skeleton"):
        assert stand_in(name).like == "skeleton"
