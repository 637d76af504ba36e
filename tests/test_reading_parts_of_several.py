"""What some of several do, in words that are names of things as well."""

import pytest

from thinkblox.reading import read_brief


def told(prompt: str) -> set[str]:
    """What was asked of how things stand to each other, in words."""
    brief = read_brief(prompt)
    assert not brief.unknown
    counts = {r.key: r.count for r in brief.requests}
    return {f"{counts[r.subject]} {r.subject} {r.kind} {' '.join(r.anchors)}" for r in brief.relations if r.asked}


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("A room with four cabinets. Two of them stand against the left wall.", {"2 cabinet against_wall left_wall"}),
        ("Four chairs. Two of them face the window.", {"2 chair facing window"}),
        ("Six pictures, three of which hang on the left wall.", {"3 picture on left_wall"}),
        (
            "Four cabinets. Two of them stand against the left wall, the other two stand by the door; one is empty.",
            {
                "2 cabinet against_wall left_wall",
                "1 cabinet-2 next_to door",
                "1 cabinet-3 next_to door",
            },
        ),
        ("Twelve paintings hang on three walls, four per wall.", {"12 picture on wall"}),
    ],
)
def test_verbs_after_some_of_them(prompt: str, relations: set[str]) -> None:
    assert told(prompt) == relations


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("Next to the old plant stands a lamp.", {"1 floor_lamp next_to plant"}),
        ("In front of the white backdrop stands a stool.", {"1 stool in_front_of backdrop"}),
        ("Two vases are on the plant stands.", {"2 vase on plant_stand"}),
    ],
)
def test_stands_after_what_is_named_in_front(prompt: str, relations: set[str]) -> None:
    assert told(prompt) == relations


def test_goal_speaks_of_what_is_there() -> None:
    brief = read_brief(
        "On the desk: 4 cubes (2 green, 2 yellow), a tray and a bin. "
        "The arm should place green cubes in the tray and yellow cubes in the bin."
    )
    assert sum(r.count for r in brief.requests if r.category == "cube") == 4
    assert not any(r.kind == "inside" for r in brief.relations if r.asked)


@pytest.mark.parametrize(
    ("prompt", "blue"),
    [
        ("A sofa, two armchairs and a rug, all blue.", {"sofa", "armchair", "rug"}),
        ("A bed. A desk and a chair, both blue.", {"desk", "chair"}),
        ("A table, a chair and a stool, both blue.", {"chair", "stool"}),
        ("A table with four chairs, all blue.", {"chair"}),
        ("Two sofas and three chairs, all blue.", {"sofa", "chair"}),
        ("A sofa, two chairs and a blue rug.", {"rug"}),
    ],
)
def test_all_of_a_list_look_so(prompt: str, blue: set[str]) -> None:
    brief = read_brief(prompt)
    assert {r.category for r in brief.requests if "blue" in r.attributes} == blue
    assert not brief.unknown


@pytest.mark.parametrize(
    ("prompt", "states"),
    [
        ("Three dirty and two clean plates.", {"dirty": 3, "clean": 2}),
        ("Two open and one closed box.", {"open": 2, "closed": 1}),
        ("In the sink are four plates, two bowls and a pan, all dirty.", {"dirty": 7}),
    ],
)
def test_states_tell_several_apart(prompt: str, states: dict[str, int]) -> None:
    brief = read_brief(prompt)
    found: dict[str, int] = {}
    for request in brief.requests:
        for state in request.states:
            found[state] = found.get(state, 0) + request.count
    assert found == states
    assert not brief.people
