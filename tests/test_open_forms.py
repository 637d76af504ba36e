"""Things that hold others: the open form that they are made in for that, and long things that stand in narrow ones."""

import pytest

from tests.test_assets import check_box, check_surfaces
from thinkblox.assets import make_asset, make_thing
from thinkblox.assets.catalogue import CATALOGUE
from thinkblox.assets.make import fit_asset
from thinkblox.assets.states import shows_state
from thinkblox.generate import generate_room
from thinkblox.headline import shortfalls
from thinkblox.placing import Effort
from thinkblox.plan import Plan
from thinkblox.planning import plan_brief, with_sizes
from thinkblox.reading import read_brief
from thinkblox.scene.room import rectangle

HOLDING = sorted(name for name, kind in CATALOGUE.items() if "holds" in kind.forms)
SHAPED = [name for name in HOLDING if not CATALOGUE[name].plain]


def plan(prompt: str) -> Plan:
    return plan_brief(read_brief(prompt), rectangle(6.0, 5.0))


@pytest.mark.slow
def test_what_is_told_to_hold_things_has_room_for_them() -> None:
    for name in HOLDING:
        asset = make_asset(name, seed=0, attributes=(CATALOGUE[name].forms["holds"],))
        assert any(surface.inner for surface in asset.surfaces), name


@pytest.mark.parametrize("name", [*SHAPED, *HOLDING[::40]])
def test_open_forms_fill_their_box_and_carry_where_they_say(name: str) -> None:
    kind = CATALOGUE[name]
    for role in ("holds", "carries"):
        if role in kind.forms:
            asset = make_asset(name, seed=1, attributes=(kind.forms[role],))
            check_box(asset)
            check_surfaces(asset)


@pytest.mark.parametrize("name", ["zorgle", "brass frimble"])
def test_what_nobody_knows_is_open_when_it_holds_something(name: str) -> None:
    planned = plan(f"A hall with a {name} with two books in it.")
    book = next(t for t in planned.targets if t.ties and t.ties[0].kind == "inside")
    assert "open" in planned.target(book.ties[0].anchors[0]).attributes
    assert any(s.within for s in make_thing(name, seed=0, attributes=("open",)).surfaces)


def test_a_thing_is_closed_unless_it_holds_something_or_is_said_to_be_open() -> None:
    assert not any(s.inner for s in make_thing("toolbox", seed=0).surfaces)
    assert "open" in plan("A workshop with an open toolbox.").target("toolbox_1").attributes
    assert "open" not in plan("A workshop with a toolbox.").target("toolbox_1").attributes
    assert shows_state(make_thing("suitcase", seed=0, attributes=("open",)), "open")
    assert not shows_state(make_thing("suitcase", seed=0), "open")


@pytest.mark.parametrize(
    ("prompt", "stands"),
    [
        ("A study with a desk with a mug with three pencils in it.", True),
        ("A study with a desk and a toolbox with two screwdrivers in it.", False),
        ("A kitchen with a counter and a jar with two wooden spoons in it.", True),
        ("A kitchen with a table with three spoons on it.", False),
    ],
)
def test_long_things_stand_in_what_is_too_narrow_for_them_to_lie_in(prompt: str, stands: bool) -> None:
    target = next(t for t in plan(prompt).targets if t.count > 1)
    assert ("upright" in target.attributes) is stands
    made = make_thing(target.category, seed=0, attributes=target.attributes)
    assert (made.size[2] > 2 * max(made.size[:2])) is stands


def test_what_stands_on_its_end_can_be_made_larger_and_smaller() -> None:
    pencil = make_thing("pencil", seed=0, attributes=("upright",))
    x, y, z = pencil.size
    smaller = fit_asset(pencil, (0.7 * x, 0.7 * y, 0.7 * z))
    assert smaller.size == pytest.approx((0.7 * x, 0.7 * y, 0.7 * z), abs=1e-4)
    check_box(smaller)


@pytest.mark.parametrize(
    ("prompt", "id", "axis", "least"),
    [
        ("A studio with three wooden stands, each with four zinc buckets on it.", "stand_1", 0, 0.5),
        ("A hall with a wall shelf with eight helmets on it.", "wall_shelf_1", 1, 1.8),
        ("A kitchen with a dish rack with four plates in it.", "dish_rack_1", 1, 0.8),
    ],
)
def test_what_carries_or_holds_several_is_made_large_enough(prompt: str, id: str, axis: int, least: float) -> None:
    size = plan(prompt).target(id).size[axis]
    assert size is not None
    assert size >= least


def test_the_open_form_has_a_size_of_its_own_and_a_long_thing_its_length_upwards() -> None:
    rack = "A games room with a pool table and a cue rack with four cues in it."
    for seed in range(3):
        done = plan_brief(with_sizes(read_brief(rack), seed), rectangle(6.0, 5.0))
        cue = done.target("cue_1")
        made = make_thing("cue", seed=0, attributes=cue.attributes)
        depth, width, height = (said or own for said, own in zip(cue.size, made.size, strict=True))
        assert height > 1.2 > 0.2 > max(depth, width)
    chest = plan("A playroom with a toy chest with four dolls in it.").target("toy_box_1")
    assert chest.size[2] is None or chest.size[2] > 0.6


@pytest.mark.parametrize(
    ("prompt", "most"),
    [
        ("A shop with a counter and a jar with five frimbles in it.", 0.1),
        ("A hall with a tray with four frimbles on it on a table.", 0.25),
        ("A hall with three frimbles.", None),
    ],
)
def test_what_nobody_knows_is_no_larger_than_what_it_is_put_into(prompt: str, most: float | None) -> None:
    size = plan(prompt).target("frimble_1").size
    assert (size[0] is None) if most is None else (size[0] is not None and max(filter(None, size)) <= most)


def test_a_dresser_holds_things_in_its_drawers() -> None:
    drawers = [s for s in make_asset("dresser", seed=0).surfaces if s.within]
    assert len(drawers) >= 4
    assert all(s.headroom and s.headroom > 0.08 for s in drawers)


@pytest.mark.slow
@pytest.mark.parametrize(
    "things",
    [
        "a toy box with six toy cars in it",
        "a cardboard box with ten books in it",
        "a vase with five roses in it on a table",
        "a bin with three umbrellas in it",
        "a table with a plate with six cookies",
        "a wine rack with ten bottles in it",
        "an open suitcase with a folded sweater in it",
        "a phone booth with a stool inside",
        "a dresser with four folded shirts in its drawers",
        "a zinc bucket with two bouquets in it",
    ],
)
def test_rooms_have_the_things_in_what_holds_them(things: str) -> None:
    done = generate_room(f"A room with {things}.", fill="named", seed=0, effort=Effort(restarts=1))
    assert not shortfalls(done.report)
    assert done.report.valid
    ids = {t.id: t.ties[0].anchors[0] for t in done.plan.targets if t.ties and t.ties[0].kind == "inside"}
    for id, holder in ids.items():
        carried = {p.id for p in done.scene.riders(holder)}
        assert id in carried, f"{id} is in {holder} and would not go with it"
