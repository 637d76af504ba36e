"""What stands by a window or door that was just named, and places told by an end of a bed."""

import pytest

from tests.briefs import asked, related, told
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("A bedroom with a window on the north wall and a bench below it.", "bench under window"),
        ("A living room with a big window. Under it stands a bench.", "bench under window"),
        ("A reading corner by the bay window with a bench under it.", "bench next_to window"),
        ("A kitchen with a sink and a window above it.", "sink next_to window"),
        ("A hall with a door and a mirror next to it.", "mirror next_to door"),
    ],
)
def test_it_is_the_opening_that_was_named(prompt: str, relation: str) -> None:
    brief = read_brief(prompt)
    assert not brief.unknown
    assert relation in related(brief)


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("A bathroom where a tub stands under the window, with a stool next to it.", "stool next_to bathtub"),
        ("A bedroom with a bed, a window and a rug under it.", "rug under bed"),
        ("A study with a desk, a window, and a lamp on it.", "desk_lamp on desk"),
    ],
)
def test_it_is_the_thing_where_the_opening_only_says_where(prompt: str, relation: str) -> None:
    assert relation in related(read_brief(prompt))


@pytest.mark.parametrize("where", ["opposite the foot of", "across from the foot of"])
def test_what_is_opposite_the_foot_is_opposite_the_bed(where: str) -> None:
    assert told(f"A bedroom with a bed and a dresser {where} the bed.") == (
        {"bed": 1, "dresser": 1},
        {"dresser opposite bed"},
    )


def test_what_is_angled_to_something_faces_it() -> None:
    _, relations = told("A lounge with two armchairs angled toward each other.")
    assert relations == {"armchair facing armchair"}
    _, relations = told("A living room with a sofa and an armchair angled toward the sofa.")
    assert relations == {"armchair facing sofa"}
    assert read_brief("A living room with a sofa and an armchair slightly angled toward it.").unknown


def test_how_a_thing_is_found_does_not_change_its_name() -> None:
    things, relations = told("A gym with three gym bags stacked in the corner.")
    assert (things, relations) == ({"gym_bag": 3}, {"gym_bag in_corner corner"})
    rolled = read_brief("A gym with three yoga mats rolled up in the corner.")
    assert [(r.count, r.called) for r in rolled.requests if "mat" in r.category] == [(3, "yoga mat")]


@pytest.mark.parametrize(
    ("prompt", "looks"),
    [("A studio with a two-person table.", "for-2"), ("A room with a two-person bed.", "double"),
     ("A room with a two-person sofa.", "two-seat")],
)  # fmt: skip
def test_for_how_many_people_something_is(prompt: str, looks: str) -> None:
    brief = read_brief(prompt)
    (request,) = [r for r in brief.requests if r.asked]
    assert request.attributes == (looks,)
    assert sum(asked(brief).values()) == 1


@pytest.mark.parametrize(
    ("prompt", "kind"),
    [
        ("A bedroom with a table under the window and a vase on it.", "table"),
        ("A sewing room with a sewing machine on a table.", "table"),
        ("A bedroom with a table and two chairs.", "dining_table"),
        ("A greenhouse with a table for two.", "dining_table"),
        ("A dining room with a table.", "dining_table"),
        ("A restaurant with a table.", "dining_table"),
    ],
)
def test_a_table_is_one_to_eat_at_where_people_eat_or_sit(prompt: str, kind: str) -> None:
    (table,) = [r for r in read_brief(prompt).requests if r.asked and r.category.endswith("table")]
    assert table.category == kind


def test_what_stands_on_the_floor_is_beside_what_carries_a_thing() -> None:
    _, relations = told("A sewing room with a sewing machine on a table, and a dress form next to it.")
    assert "dress_form next_to table" in relations


def test_what_is_turned_away_and_toward_faces_both_as_said() -> None:
    _, relations = told("A living room where the sofa faces away from the window and toward the fireplace.")
    assert relations == {"sofa facing_away window", "sofa facing fireplace"}


@pytest.mark.parametrize(
    ("prompt", "kind"),
    [
        ("A kitchen with six pots.", "cooking_pot"),
        ("A kitchen with a pot of basil by the window.", "potted_plant"),
        ("A living room with six pots.", "potted_plant"),
    ],
)
def test_pots_of_a_kitchen_are_to_cook_in(prompt: str, kind: str) -> None:
    assert kind in {r.category for r in read_brief(prompt).requests if r.asked}


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("The window is next to the bed.", ("bed", "next_to", ("window",))),
        ("The window is to the left of the bed.", ("bed", "right_of", ("window",))),
        ("The door is opposite the desk.", ("desk", "opposite", ("door",))),
        ("The window is behind the desk.", ("desk", "in_front_of", ("window",))),
        ("A window is to the right of the wardrobe.", ("wardrobe", "left_of", ("window",))),
    ],
)
def test_where_an_opening_is_tells_where_a_thing_is(prompt: str, relation: tuple[str, str, tuple[str, ...]]) -> None:
    brief = read_brief(prompt)
    assert [(r.subject, r.kind, r.anchors) for r in brief.relations if r.asked] == [relation]
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "openings"),
    [
        ("A bed. The door is on the left.", [("door", "left_wall")]),
        ("A bed. The door is at the back.", [("door", "far_wall")]),
        (
            "A room with a window on the left and a door on the right.",
            [("window", "left_wall"), ("door", "right_wall")],
        ),
    ],
)
def test_an_opening_on_the_left_is_in_that_wall(prompt: str, openings: list[tuple[str, str]]) -> None:
    brief = read_brief(prompt)
    assert [(o.kind, o.wall) for o in brief.openings] == openings
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "unknown"),
    [
        ("A bed and a desk. The door is between the bed and the desk.", "is between the bed"),
        ("A bed and a desk. The window is between the bed and the desk.", "is between the bed"),
    ],
)
def test_what_is_not_made_of_an_opening_is_told(prompt: str, unknown: str) -> None:
    brief = read_brief(prompt, fill="named")
    assert brief.unknown == (unknown,)
    assert {r.category for r in brief.requests} == {"bed", "desk"}
