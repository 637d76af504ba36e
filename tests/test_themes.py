"""What everybody expects where a prompt names a mood, an occasion or people."""

import pytest

from tests.briefs import counted
from thinkblox import generate_room
from thinkblox.assets.stand_ins import stand_in
from thinkblox.knowledge.themes import themes, themes_in
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("my 14 yo's gaming bedroom, two screens", {"monitor": 2, "desk": 1, "keyboard": 1}),
        ("Victorian parlour on halloween", {"pumpkin": 3, "candle": 4}),
        ("A living room the morning after the party", {"bottle": 6, "pizza_box": 3}),
        ("the bedroom of a bookworm", {"bookcase": 2, "book": 6}),
        ("studio of a painter", {"easel": 1}),
        ("A living room for my cat", {"cat_tree": 1}),
        ("birthday party for a five-year-old", {"balloon": 5, "cake": 1}),
        ("romantic dinner for two", {"wine_glass": 2, "chair": 2}),
        ("walk in closet. shoes shoes shoes", {"shoes": 5}),
    ],
)
def test_what_goes_with_a_mood_is_there(prompt: str, expected: dict[str, int]) -> None:
    counts = counted(read_brief(prompt))
    assert {noun: counts.get(noun, 0) >= number for noun, number in expected.items()} == dict.fromkeys(expected, True)


def test_what_goes_with_a_mood_is_assumed_and_the_word_is_accounted_for() -> None:
    brief = read_brief("A living room, christmas eve")
    assert not brief.request("christmas_tree").asked
    assert [word.fate for word in brief.account if word.text == "christmas"] == ["style"]


@pytest.mark.parametrize(
    ("prompt", "never"),
    [
        ("A bedroom with a party hat on the desk", "balloon"),
        ("A living room, no party", "balloon"),
        ("A living room, not christmas at all", "christmas_tree"),
        ("A living room with a picture of a cat", "cat_tree"),
        ("A living room for a party, without balloons", "balloon"),
        ("An empty room for a party", "balloon"),
        ("A Victorian parlour", "tv"),
        ("A bedroom where everything is blue", "saxophone"),
    ],
)
def test_a_word_that_tells_no_mood_adds_nothing(prompt: str, never: str) -> None:
    assert counted(read_brief(prompt)).get(never, 0) == 0


def test_people_and_occasions_are_no_things() -> None:
    assert {"bookworm", "sleepover"}.isdisjoint(counted(read_brief("bedroom of a bookworm after a sleepover")))


def test_what_is_named_is_not_assumed_again() -> None:
    counts = counted(read_brief("A man cave for a football fan with a beer fridge"))
    assert (counts["beer_fridge"], counts.get("fridge", 0)) == (1, 0)


def test_a_room_that_is_told_in_full_stays_as_told() -> None:
    prompt = "A living room for a party with a sofa, an armchair, a coffee table, a rug, a floor lamp and a bookcase"
    assert all(request.asked for request in read_brief(prompt).requests)


@pytest.mark.parametrize(
    "prompt",
    [
        "My 15 year old son's room: single bed, desk, two monitors, a chair, a guitar, posters and a shelf.",
        "A bedroom for a 16-year-old girl with a bed, a desk, a chair, a lamp, a bookcase and a rug.",
    ],
)
def test_who_sleeps_in_a_room_tells_its_kind_however_much_is_named(prompt: str) -> None:
    assert read_brief(prompt).room_type == "teenager_bedroom"


def test_the_longest_phrase_tells() -> None:
    found = themes_in("the morning after the party".split())
    assert [(theme.theme, theme.start, theme.end) for theme in found] == [(themes()["after_party"], 1, 5)]


def test_themes_bring_only_things_with_a_shape_of_their_own() -> None:
    known = themes().values()
    expected = {u.category for t in known for room in ("", *t.by_room) for u in t.expected(room)}
    assert {noun for noun in expected if stand_in(noun).how not in ("catalogue", "table")} == set()
    assert len(known) >= 60


@pytest.mark.slow
def test_a_way_round_what_was_cut_off_is_found_where_the_cut_touches_itself() -> None:
    assert generate_room("christmas eve at grandma's living room, cosy and warm").report.valid


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        (
            "A flat with a bed, a desk, a wardrobe, a fridge, a sofa and a place to eat",
            {"kitchen_table": 1, "chair": 2},
        ),
        ("An office with six desks and somewhere to relax", {"sofa": 1}),
        ("A hair salon with three chairs in front of mirrors and a waiting area", {"sofa": 1, "coffee_table": 1}),
        ("A loft with a sofa, a TV, a rug, a coffee table and a bookcase; a space for studying", {"desk": 1}),
        ("A dining area with a round table", {"dining_table": 1}),
        ("A waiting area with six chairs and a plant", {"sofa": 0}),
        ("An office with a sofa and a coffee corner", {"coffee_machine": 1, "sideboard": 1}),
        ("An optician's shop with an eye test corner", {"eye_test_machine": 1, "eye_chart": 1}),
        ("A clinic with a treatment table and exercise equipment", {"massage_table": 1, "exercise_bike": 1}),
        ("A living room with a dining area: a dining table and six chairs", {"dining_table": 1, "chair": 6}),
    ],
)
def test_a_part_of_a_room_is_made_once(prompt: str, expected: dict[str, int]) -> None:
    brief = read_brief(prompt)
    counts = counted(brief)
    assert {noun: counts.get(noun, 0) for noun in expected} == expected
    assert brief.unknown == ()


def test_to_do_something_is_beside_nothing() -> None:
    brief = read_brief("A studio with a bed, a desk and a place to eat")
    assert not [relation for relation in brief.relations if relation.asked]
    assert brief.request("kitchen_table").asked


@pytest.mark.parametrize(
    ("prompt", "unknown"),
    [
        ("A gym with five treadmills and a stretching area", ("stretching area",)),
        ("A salon with a washing area: two basins", ()),
        ("An office with a large play area and a meeting area", ()),
    ],
)
def test_a_part_of_a_room_that_we_do_not_know_is_said_so(prompt: str, unknown: tuple[str, ...]) -> None:
    assert read_brief(prompt).unknown == unknown
