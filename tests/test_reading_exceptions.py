"""Some of several that are otherwise than the rest, and what holds nothing but what is named."""

import pytest

from thinkblox.brief import Brief
from thinkblox.reading import read_brief


def looks(prompt: str, category: str) -> dict[str, int]:
    """How many of a kind have which looks."""
    found = [r for r in read_brief(prompt).requests if r.category == category and r.asked]
    return {" ".join(r.attributes): r.count for r in found}


def relations(brief: Brief) -> set[str]:
    """What was asked of how things stand to each other, in words."""
    counts = {r.key: r.count for r in brief.requests}
    asked = [r for r in brief.relations if r.asked and not r.negated]
    return {f"{counts[r.subject]} {r.subject} {r.kind} {' '.join(r.anchors)}" for r in asked}


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("Ten chairs. The chairs are white except for one, which is black.", {"black": 1, "white": 9}),
        ("Six chairs, all blue except two, which are red.", {"red": 2, "blue": 4}),
        ("Six chairs, all blue except one.", {"": 1, "blue": 5}),
        ("Six blue chairs; one of them is red and tall.", {"red tall": 1, "blue": 5}),
        ("Eight chairs. All of them are black but one, which is white.", {"white": 1, "black": 7}),
        ("Four oak chairs. Two of them are made of metal.", {"metal": 2, "oak": 2}),
    ],
)
def test_some_look_otherwise(prompt: str, expected: dict[str, int]) -> None:
    assert looks(prompt, "chair") == expected
    assert not read_brief(prompt).unknown


def test_colour_that_all_have_is_kept_by_some() -> None:
    assert looks("Six blue chairs; one of them is metal.", "chair") == {"blue metal": 1, "blue": 5}


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("The counter is bare except for two vases.", "2 vase on counter"),
        ("The fridge is empty except for a milk bottle.", "1 milk_bottle inside fridge"),
        ("A basket, empty apart from two balls.", "2 ball inside basket"),
        ("Two desks. Both are empty except for a lamp.", "2 desk_lamp on desk"),
        ("A nightstand. On the nightstand there's nothing but a glass.", "1 glass on nightstand"),
    ],
)
def test_empty_but_for(prompt: str, expected: str) -> None:
    brief = read_brief(prompt)
    assert relations(brief) == {expected}
    assert not brief.unknown
    assert not brief.empty


def test_ones_at_a_side_are_those_at_that_wall() -> None:
    brief = read_brief(
        "Two benches along the left wall and one along the right. The two on the left carry six pots each; "
        "the other one is empty apart from a watering can."
    )
    assert {"12 potted_plant on bench", "1 watering_can on bench-2"} <= relations(brief)
    assert {"2 bench against_wall left_wall", "1 bench-2 against_wall right_wall"} <= relations(brief)


def test_number_after_a_side_begins_something_new() -> None:
    brief = read_brief("Two shelves: the one on the left holds six books, the one on the right three vases.")
    assert [(r.category, r.count) for r in brief.requests if r.category in ("book", "vase")] == [
        ("book", 6),
        ("vase", 3),
    ]


@pytest.mark.parametrize("said", ["The walls are bare.", "Keep the walls bare.", "It has bare walls."])
def test_bare_walls_have_no_pictures(said: str) -> None:
    brief = read_brief(f"A study with a desk. {said}")
    assert {"picture", "mirror"} <= set(brief.excluded)
    assert not brief.free


def test_what_alone_hangs_on_the_walls_is_not_excluded() -> None:
    brief = read_brief("A study with a desk. The walls are bare except for a painting.")
    assert "1 picture on wall" in relations(brief)
    assert "mirror" in brief.excluded
    assert "picture" not in brief.excluded


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("Apart from a bed and a wardrobe, the room is empty.", {"bed", "wardrobe"}),
        ("The room is empty apart from a bed.", {"bed"}),
        ("The room is completely bare except for a chair.", {"chair"}),
        ("A bare room with a single chair in the middle.", {"chair"}),
        ("The only furniture is a table with four chairs.", {"dining_table", "chair"}),
        ("The only piece of furniture in the room is a bed.", {"bed"}),
        ("A sofa is the only furniture.", {"sofa"}),
    ],
)
def test_a_room_that_is_empty_but_for_what_is_named(prompt: str, things: set[str]) -> None:
    brief = read_brief(prompt)
    assert brief.empty
    assert {r.category for r in brief.requests} == things
    assert not any("empty" in r.states for r in brief.requests)
    assert brief.unknown == ()


@pytest.mark.parametrize("said", ["is free of objects", "is clear of clutter", "is free of any clutter"])
def test_what_is_free_of_clutter_is_empty(said: str) -> None:
    brief = read_brief(f"An office with a desk. The desk {said}.")
    assert brief.request("desk").states == ("empty",)
    assert not brief.empty


@pytest.mark.parametrize(
    ("prompt", "expected", "barred"),
    [
        ("A kitchen with everything except a dishwasher.", set(), "dishwasher"),
        ("A room with everything but a TV: a sofa and a rug.", set(), "tv"),
        ("The bookcase has no books, only vases.", {"3 vase inside bookcase"}, "book"),
        ("The sofa has no cushions but a blanket.", {"1 blanket on sofa"}, "pillow"),
        ("A table with no chairs, just two benches.", {"2 bench around dining_table"}, "chair"),
        (
            "The desk has no lamp, but a monitor and a keyboard.",
            {"1 monitor on desk", "1 keyboard on desk"},
            "any_lamp",
        ),
    ],
)
def test_what_is_not_there_and_what_is_instead(prompt: str, expected: set[str], barred: str) -> None:
    brief = read_brief(prompt)
    assert relations(brief) == expected
    assert brief.excluded == (barred,)
    assert barred not in {r.category for r in brief.requests}
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("There's no lamp on the desk, but there is one on the nightstand.", "1 table_lamp on nightstand"),
        ("There are no lamps on the desk, but there are two on the shelf.", "2 table_lamp on shelving_unit"),
        ("There is no clock on the wall but one on the desk.", "1 clock on desk"),
        ("No chair at the desk, but one by the window.", "1 chair next_to window"),
    ],
)
def test_what_is_not_here_but_there_is_there(prompt: str, expected: str) -> None:
    brief = read_brief(prompt)
    assert relations(brief) == {expected}
    assert [r.subject for r in brief.relations if r.negated] == [expected.split()[1]]
    assert brief.excluded == brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "kept", "barred"),
    [
        ("A living room with a TV. On second thought, no TV.", {}, ("tv",)),
        ("A bedroom with a bed and a desk. Wait, no desk.", {"bed": 1}, ("desk",)),
        ("A room with a sofa and two armchairs. Actually, without the armchairs.", {"sofa": 1}, ("armchair",)),
        ("A living room with a sofa, or better yet, two sofas.", {"sofa": 2}, ()),
        ("A study with a lamp. Even better: two lamps.", {"desk_lamp": 2}, ()),
        ("A bedroom with a double bed. No wait, a single bed.", {"bed": 1}, ()),
        ("Two armchairs are enough.", {"armchair": 2}, ()),
    ],
)
def test_second_thoughts(prompt: str, kept: dict[str, int], barred: tuple[str, ...]) -> None:
    brief = read_brief(prompt)
    assert {r.category: r.count for r in brief.requests if r.asked} == kept
    assert brief.excluded == barred
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("The sofa has three chairs. Two are red. One is blue.", {"red": 2, "blue": 1}),
        ("Five chairs. Three are red. Two are blue.", {"red": 3, "blue": 2}),
        ("There are three chairs. One is blue. Two are red.", {"red": 2, "blue": 1}),
        ("Six chairs. Two are red. Two are blue. Two are green.", {"red": 2, "blue": 2, "green": 2}),
        ("Three chairs. One is red. It stands by the door. Two are blue.", {"red": 1, "blue": 2}),
    ],
)
def test_a_number_after_some_were_told_of_is_of_the_rest(prompt: str, expected: dict[str, int]) -> None:
    assert looks(prompt, "chair") == expected


def test_what_some_have_is_no_part_of_their_name() -> None:
    brief = read_brief("There are four desks. One has a lamp. Two have computers. One is empty.")
    assert relations(brief) == {"1 desk_lamp on desk", "2 computer on desk-2"}
    assert sorted(r.count for r in brief.requests if r.category == "desk") == [1, 1, 2]
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "least", "most"),
    [
        ("A room with two chairs at most.", None, 2),
        ("A room with two chairs at the very least and a table.", 2, None),
        ("Two chairs or fewer.", None, 2),
        ("Two chairs maximum.", None, 2),
        ("Some chairs, two at most.", None, 2),
    ],
)
def test_what_bounds_a_number_may_come_after_it(prompt: str, least: int | None, most: int | None) -> None:
    brief = read_brief(prompt)
    assert [(r.count, r.least, r.most) for r in brief.requests if r.category == "chair"] == [(2, least, most)]
    assert brief.unknown == ()


def test_not_too_many_are_some() -> None:
    brief = read_brief("A room with not too many plants and a bench, but don't overdo it.")
    assert brief.excluded == brief.unknown == ()
    assert {r.category for r in brief.requests} == {"plant", "bench"}


def test_what_is_asked_about_is_as_is_answered() -> None:
    assert looks("The table? It should be round. And the chairs? Wooden, please.", "chair") == {"wooden": 4}
    assert looks("A sofa and two chairs. The chairs? Green and by the window.", "chair") == {"green": 2}


@pytest.mark.parametrize(
    ("prompt", "chairs"),
    [("Neither of the two chairs has a cushion.", 2), ("None of the four chairs has a cushion on it.", 4)],
)
def test_what_none_of_those_has_that_nobody_named_is_not_there(prompt: str, chairs: int) -> None:
    brief = read_brief(prompt)
    assert {r.category: r.count for r in brief.requests if r.asked} == {"chair": chairs}
    assert brief.excluded == ("pillow",)
    assert brief.unknown == ()


def test_what_has_no_drawers_bars_no_dresser() -> None:
    brief = read_brief("A nightstand without drawers.")
    assert brief.excluded == ()
    assert brief.request("nightstand").unshown == ("without drawers",)
