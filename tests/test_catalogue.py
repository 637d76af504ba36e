import ast
from collections.abc import Iterator
from pathlib import Path

import pytest
from msgspec import structs

from thinkblox.assets import (
    CATALOGUE,
    GENERAL_WORDS,
    AssetSource,
    Category,
    ProceduralAssets,
    facts_of,
    fit_asset,
    make_asset,
    make_thing,
    register,
    stand_in,
    unregister,
)
from thinkblox.assets.families import category_from
from thinkblox.assets.groups import GROUPS
from thinkblox.assets.part import Build
from thinkblox.assets.shapes import box
from thinkblox.assets.spec import Spec
from thinkblox.errors import InputError
from thinkblox.generate import generate_room
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import room_types
from thinkblox.reading import read_brief
from thinkblox.reading.lexicon import load
from thinkblox.scene.asset import Asset
from thinkblox.value import from_json, to_json

ROOT = Path(__file__).parent.parent
ASKED = "A bedroom with a bed, a desk and an orrery on the desk."


def orrery(spec: Spec) -> Build:
    x, y, z = spec.size
    foot = box(spec.wood, (-x / 2, x / 2), (-y / 2, y / 2), (0.0, 0.2 * z))
    tube = box(spec.wood, (-x / 2, x / 2), (-y / 6, y / 6), (0.2 * z, z))
    return Build(body=[foot, tube])


def kind(**more: object) -> Category:
    fields: dict[str, object] = {
        "name": "orrery",
        "noun": "orrery",
        "generator": orrery,
        "size": (0.3, 0.2, 0.4),
        "mass": 2.0,
        "mount": "surface",
        "words": "orrery, tellurion|tellurions",
        "groups": ("small",),
        "habits": ("on @desks", "on @surfaces", "near window"),
    }
    return Category(**(fields | more))  # type: ignore[arg-type]


@pytest.fixture
def registered() -> Iterator[None]:
    register(kind(rooms={"bedroom": "2 : on dresser"}))
    yield
    unregister("orrery")


def test_without_it_something_plain_stands_for_an_orrery() -> None:
    brief = read_brief(ASKED)
    assert brief.missing == ()
    assert brief.unknown == ("an orrery (no such thing is known)",)
    assert "orrery" in {request.category for request in brief.requests}
    assert "orrery" not in CATALOGUE
    assert make_thing("orrery", seed=0).provenance.startswith("stand_in:orrery:")


@pytest.mark.usefixtures("registered")
def test_a_registered_category_is_read_planned_made_and_placed() -> None:
    room = generate_room(ASKED, seed=0)
    assert room.report.complete
    placed = room.scene["orrery_1"]
    assert placed.support == "desk_1"
    assert room.scene.asset_of(placed).provenance.startswith("procedural:orrery:")


@pytest.mark.usefixtures("registered")
def test_its_words_habits_groups_and_rooms_are_known_at_once() -> None:
    assert [r.category for r in read_brief("A study with three tellurions.").requests][:1] == ["orrery"]
    assert load_habits().tie("orrery", "desk") == "on"
    assert "orrery" in load_habits().group("small")
    assert {r.category: r.count for r in read_brief("A bedroom.").requests}["orrery"] == 2


def test_taken_away_again_it_is_forgotten() -> None:
    register(kind())
    made = make_asset("orrery", seed=1)
    unregister("orrery")
    assert "tellurion" in {request.category for request in read_brief("A study with three tellurions.").requests}
    assert load_habits().of("orrery") == load_habits().of("gizmo")
    with pytest.raises(InputError, match="orrery"):
        fit_asset(made, made.size)
    register(kind(mass=4.0))
    heavier = make_asset("orrery", seed=1)
    unregister("orrery")
    assert heavier.mass == pytest.approx(2 * made.mass, rel=0.01)


def test_a_registered_category_may_turn_into_another() -> None:
    register(kind(senses=("globe if room:library",)))
    try:
        assert "globe" in {r.category for r in read_brief("A library with an orrery.").requests}
    finally:
        unregister("orrery")


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"name": "bed"}, "exists already"),
        ({"name": "any_lamp"}, "exists already"),
        ({"name": "Orrery"}, "snake_case"),
        ({"name": "or rery"}, "snake_case"),
        ({"name": "orrery\n"}, "snake_case"),
        ({"words": "orrery, Fish Tank"}, "'fish tank' means 'aquarium' already"),
        ({"mass": 0.0}, "its mass is 0.0; it must be above 0"),
        ({"mass": float("nan")}, "its mass is nan"),
        ({"size": (0.0, 0.5, 1.0)}, "a size of"),
        ({"size": (0.5, 1.0)}, "three lengths"),
        ({"variants": {"big": (1.0, -1.0, 1.0)}}, "a size of"),
        ({"front": "left"}, "its front is 'left'; it must be one of one, two, any"),
        ({"mount": "table"}, "its mount is 'table'; it must be one of floor, wall, ceiling"),
        ({"friction": -0.1}, "its friction is -0.1"),
        ({"clearance": float("inf")}, "its clearance is inf"),
        ({"variation": 1.0}, "its variation is 1.0"),
        ({"low": 0.0}, "low is 0.0"),
        ({"high": 0.5}, "high is 0.5"),
        ({"generator": None}, "its generator is None; give a function"),
        ({"words": "lamp"}, "'lamp' means 'any_lamp' already"),
        ({"words": "scope|knives"}, "'knives' means 'knife' already"),
        ({"habits": ("on desc",)}, "names 'desc'"),
        ({"habits": ("on desk if teevee",)}, "names 'teevee'"),
        ({"senses": ("glob if room:library",)}, "names 'glob'"),
    ],
)
def test_what_cannot_be_registered_is_refused(more: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        register(kind(**more))
    assert "orrery" not in CATALOGUE


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"groups": ("smal",)}, "no group 'smal'; there are"),
        ({"groups": ("surfaces:first",)}, "whole number"),
        ({"habits": ("upon desk",)}, "no relation 'upon'; there are"),
        ({"habits": ("on @desk",)}, "no group 'desk'"),
        ({"rooms": {"bedroom": "two : on desk"}}, "the count before ':' must be a whole number"),
        ({"rooms": {"bedroom": "2 : upon desk"}}, "no relation 'upon'; there are"),
    ],
)
def test_facts_that_name_nothing_are_refused(more: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        kind(**more)


def test_a_room_that_is_not_known_is_refused_with_those_that_are() -> None:
    register(kind(rooms={"bedrom": "1 : on desk"}))
    try:
        with pytest.raises(InputError, match=r"no type of room 'bedrom'; there are .*bedroom"):
            room_types()
    finally:
        unregister("orrery")


def test_what_was_not_registered_cannot_be_taken_away() -> None:
    with pytest.raises(InputError, match="registered are: none"):
        unregister("bed")


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ({"colour": "red"}, "no field colour; it has .*clearance"),
        ({"mass": "much"}, "category 'stand_in': .*mass"),
        ({"groups": ["bed"]}, "no group 'bed'"),
    ],
)
def test_a_wrong_entry_of_a_family_says_what_is_wrong(entry: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        category_from("stand_in", {"make": "beds.bed", "size": [1.0, 1.0, 1.0], "mass": 5} | entry)


def test_every_group_has_members_and_every_entry_can_be_meant() -> None:
    known = {**CATALOGUE, **GENERAL_WORDS}
    assert {group for group in GROUPS if not any(facts.is_in(group) for facts in known.values())} == set()
    assert all(facts.senses and facts.words for facts in GENERAL_WORDS.values())
    objects = {e.value for entries in load("en").phrases.values() for e in entries if e.sort == "object"}
    plain = {name for name, kind in CATALOGUE.items() if kind.plain}
    assert objects == {name for name, facts in known.items() if facts.words} - plain


def test_what_nobody_knows_has_the_facts_of_its_stand_in() -> None:
    assert facts_of("widget") == stand_in("widget").category
    assert not facts_of("widget").runs_with(facts_of("gadget"))
    assert facts_of("fridge").runs_with(facts_of("stove"))


def test_an_asset_source_finds_makes_and_fits() -> None:
    source: AssetSource = ProceduralAssets()
    assert source.find("two-seat Couches")[0] == "sofa"
    assert source.find("old bedside lamp")[0] == "table_lamp"
    assert source.find("floor_lamp")[0] == "floor_lamp"
    assert "wardrobe" in source.find("wardrob")
    assert source.find("xylem") == ()
    sofa = source.make("sofa", seed=3, attributes=("red",))
    assert sofa == make_asset("sofa", seed=3, attributes=("red",))
    least, most = source.size_range("sofa")
    assert source.fit(sofa, most).size == most
    assert source.make("sofa", seed=3, size=least).size == least
    assert source.facts("sofa").is_in("seating")
    assert source.usual("samovar")[1] == "surface"
    assert source.make("samovar", seed=3, size=source.size_range("samovar")[1]).category == "samovar"


@pytest.mark.parametrize(("name", "gaze"), [("desk", "back"), ("school_desk", "back"), ("sofa", "front")])
def test_an_asset_says_which_way_one_looks_who_uses_it(name: str, gaze: str) -> None:
    assert make_asset(name, seed=0).gaze == gaze


def test_an_asset_written_before_it_said_so_is_looked_over_from_its_back_to_its_front() -> None:
    desk = make_asset("desk", seed=0)
    old = to_json(desk).replace(b'  "gaze": "back",\n', b"")
    assert old != to_json(desk)
    assert from_json(old, Asset) == structs.replace(desk, gaze="front")


def test_no_module_outside_the_assets_lists_categories() -> None:
    folders = ("policies", "planning", "reading", "knowledge", "importing")
    shaped = {name for name, category in CATALOGUE.items() if not category.plain}
    found = []
    for path in (p for folder in folders for p in (ROOT / "thinkblox" / folder).rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            items = node.keys if isinstance(node, ast.Dict) else getattr(node, "elts", ())
            named = [i.value for i in items if isinstance(i, ast.Constant) and i.value in shaped]
            if len(named) > 1:
                found.append(f"{path.name}: {named}")
    assert found == []
