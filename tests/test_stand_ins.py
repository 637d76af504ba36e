import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.test_catalogue import kind
from thinkblox.assets import CATALOGUE, facts_of, fit_asset, kind_of, make_thing, register, stand_in, unregister
from thinkblox.assets.names import thing_called
from thinkblox.assets.stand_ins import _heads, noun_of
from thinkblox.knowledge.habits import load_habits


@pytest.mark.parametrize(
    ("name", "how", "like"),
    [
        ("bed", "catalogue", "bed"),
        ("wok", "table", "wok"),
        ("slush_machine", "table", "ice_cream_machine"),
        ("samovar", "table", "tea_urn"),
        ("dental throne", "head", "throne"),
        ("grandfather chair", "head", "chair"),
        ("cheese board", "table", "cheese_board"),
        ("jungle lamp", "head", "floor_lamp"),
        ("sack of staples", "head", "sack"),
        ("gum dispenser", "head", "soap_dispenser"),
        ("nebuliser", "spelling", "humidifier"),
        ("quern", "plain", ""),
        ("日本", "plain", ""),
        ("", "plain", ""),
    ],
)
def test_how_it_was_found_is_said(name: str, how: str, like: str) -> None:
    found = stand_in(name)
    assert (found.how, found.like) == (how, like)
    assert (found.similarity == 1.0) == (how in ("catalogue", "table"))
    if like and found.category.name not in CATALOGUE:
        assert (found.category.size, found.category.mass) == (CATALOGUE[like].size, CATALOGUE[like].mass)
        assert found.category.mount == CATALOGUE[like].mount
        assert found.category.plain


def test_it_keeps_its_own_name() -> None:
    asset = make_thing("dental throne", seed=1)
    assert (asset.category, asset.description) == ("dental_throne", "dental throne")
    assert fit_asset(asset, asset.size) == asset


def test_what_is_like_a_board_is_no_whiteboard() -> None:
    assert kind_of("ouija board").mount == "surface"


def test_a_modifier_says_where_an_unknown_thing_is() -> None:
    assert kind_of("wall quern").mount == "wall"
    assert kind_of("hanging quern").mount == "ceiling"
    assert kind_of("quern").mount == "surface"


def test_habits_and_groups_hold_for_it() -> None:
    assert load_habits().is_in("brass samovar", "small")
    assert load_habits().tie("brass samovar", "kitchen_island") == load_habits().tie("tea_urn", "kitchen_island")
    assert not load_habits().is_in("window", "small")
    assert facts_of("any_table").senses


def test_what_is_registered_wins() -> None:
    assert stand_in("orrery").how != "catalogue"
    register(kind())
    try:
        assert stand_in("orrery").how == "catalogue"
        assert stand_in("brass orrery").like == "orrery"
    finally:
        unregister("orrery")


def test_what_is_registered_takes_its_name_and_words_from_plain_things() -> None:
    plain = CATALOGUE["wok"]
    register(kind(name="wok", noun="wok", words="wok, baking tray"))
    try:
        assert [stand_in(name).how for name in ("wok", "cookie_sheet")] == ["catalogue", "table"]
        found = thing_called("baking trays")
        assert found is not None
        assert found.name == "wok"
    finally:
        unregister("wok")
    assert CATALOGUE["wok"] is plain


def test_every_head_leads_to_a_thing() -> None:
    assert [head for head, phrase in _heads().items() if thing_called(phrase) is None] == []
    assert [head for head in _heads() if thing_called(head) is not None and head not in ("board", "stand")] == []


@settings(max_examples=200, deadline=None)
@given(st.text(max_size=300))
def test_any_text_has_one_that_can_be_made(text: str) -> None:
    found = stand_in(text)
    name = found.category.name
    assert name.isascii()
    assert name[0].isalpha()
    assert len(name) <= 80
    assert stand_in(text) is found
    assert noun_of(noun_of(text)) == noun_of(text)
    assert stand_in(name).category.size == found.category.size
    assert make_thing(text, seed=0).category == name
