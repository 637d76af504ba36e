"""What is said once more of a thing between commas, and what is begun and said otherwise."""

import pytest

from thinkblox.reading import read_brief


def told(prompt: str) -> tuple[dict[str, int], set[str]]:
    """What is asked for, and how it stands."""
    brief = read_brief(prompt)
    assert not brief.unknown
    relations = {f"{r.subject} {r.kind} {' '.join(r.anchors)}" for r in brief.relations if r.asked}
    return {r.category: r.count for r in brief.requests if r.asked}, relations


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "His stool, the only seat in there, is tucked under the bench.",
            {"stool": 1, "bench": 1},
            {"stool under bench"},
        ),
        (
            "A fish tank, the one with the castle inside, goes on a cabinet by the window.",
            {"aquarium": 1, "castle": 1, "cabinet": 1},
            {"aquarium on cabinet", "castle inside aquarium", "cabinet next_to window"},
        ),
        (
            "A dress form leans... no, stands by the window. Next to the dress form is a rocking horse.",
            {"dress_form": 1, "rocking_horse": 1},
            {"dress_form next_to window", "rocking_horse next_to dress_form"},
        ),
        ("A bookcase dominates the back wall.", {"bookcase": 1}, {"bookcase against_wall far_wall"}),
        ("A long counter spans the right wall.", {"counter": 1}, {"counter against_wall right_wall"}),
    ],
)
def test_told_once(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


def test_what_is_taken_back_is_not_made() -> None:
    brief = read_brief("A butcher shop with a counter. Cold-room door... skip that. A stool by the door.")
    assert {r.category for r in brief.requests if r.asked} == {"counter", "stool"}


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        ("An office with two lamps, both on a desk.", {"desk_lamp": 2, "desk": 1}, {"desk_lamp on desk"}),
        (
            "Six lockers. The bench in front of the lockers has a towel on it and two bags underneath.",
            {"locker": 6, "bench": 1, "towels": 1, "handbag": 2},
            {"bench in_front_of locker", "towels on bench", "handbag under bench"},
        ),
    ],
)
def test_one_thing_for_all_that_is_told(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    ("prompt", "things", "relations"),
    [
        (
            "A sock lies in the drawer of the dresser opposite the bed.",
            {"sock": 1, "dresser": 1, "bed": 1},
            {"sock inside dresser", "dresser opposite bed"},
        ),
        (
            "The drawer of the dresser, which stands opposite the bed, is open.",
            {"dresser": 1, "bed": 1},
            {"dresser opposite bed"},
        ),
        ("Two keys hang on a hook of the coat rack.", {"key": 2, "coat_rack": 1}, {"key on coat_rack"}),
        ("The lid of the box on the desk is open.", {"box": 1, "desk": 1}, {"box on desk"}),
    ],
)
def test_part_stands_for_the_thing(prompt: str, things: dict[str, int], relations: set[str]) -> None:
    assert told(prompt) == (things, relations)


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("A bedroom for my daughter who loves horses: a bed and a desk.", {"bed", "desk"}),
        ("A room for a boy who likes dinosaurs and trains, with a bed.", {"bed"}),
        ("My son is into dinosaurs; he needs a bed and a desk.", {"bed", "desk"}),
        ("The kids love books, toys and puzzles. There is a sofa.", {"sofa"}),
        ("A bedroom for a fan of trains with a bed.", {"bed"}),
        ("He likes to read, so there is an armchair.", {"armchair"}),
        ("Grandma likes flowers and has a rocking chair.", {"rocking_chair"}),
        ("I'd love two armchairs and a sofa.", {"armchair", "sofa"}),
        ("The owner collects clocks. The room has a sofa.", {"clock", "sofa"}),
        ("A living room with a view of the garden and a sofa.", {"sofa"}),
        ("A study with a window onto the courtyard and a desk.", {"desk"}),
        ("A kitchen that opens onto the garden, with a stove.", {"stove"}),
        ("A hallway leading to the kitchen with a console table.", {"console_table"}),
        ("A room on the second floor with a bed.", {"bed"}),
        ("There is a door to the balcony and a bench next to it.", {"bench"}),
    ],
)
def test_what_people_like_and_what_is_outside_asks_for_nothing(prompt: str, things: set[str]) -> None:
    brief = read_brief(prompt)
    assert {r.category for r in brief.requests if r.asked} == things
    assert not brief.unknown


@pytest.mark.parametrize("words", ["faces the garden", "stands by the lake", "is on the first floor of the dollhouse"])
def test_what_stands_by_what_is_outside_is_told(words: str) -> None:
    brief = read_brief(f"A sofa {words}.")
    assert {r.category for r in brief.requests if r.asked} == {"sofa"}
    assert brief.unknown


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("A bed and a desk. Done.", {"bed": 1, "desk": 1}),
        ("A desk by the window with a bag on the floor next to the desk.", {"desk": 1, "handbag": 1}),
        ("A bicycle by the wall with an umbrella on the floor next to the bicycle.", {"bicycle": 1, "umbrella": 1}),
        ("A table saw with a dust collector next to it.", {"table_saw": 1, "dust_collector": 1}),
        ("Go on to the corner and you meet a grandfather clock.", {"grandfather_clock": 1}),
        ("A glass shower cabin and a bath mat in front of the cabin.", {"shower_cabin": 1, "bath_mat": 1}),
    ],
)
def test_only_what_is_named_is_asked_for(prompt: str, things: dict[str, int]) -> None:
    assert told(prompt)[0] == things


@pytest.mark.parametrize(
    "prompt", ["There is one sofa: blue, long, against the wall.", "A sofa: blue, long, against the wall."]
)
def test_looks_after_a_colon_are_of_the_thing(prompt: str) -> None:
    brief = read_brief(prompt)
    assert brief.request("sofa").attributes == ("blue", "long")
    assert [(r.kind, r.subject) for r in brief.relations if r.asked] == [("against_wall", "sofa")]
    assert not brief.unknown


def test_an_office_under_the_stairs_has_no_stairs() -> None:
    brief = read_brief("I squeezed an office under the stairs, it's only 1.4 by 2.2 m. A desk against the wall.")
    assert (brief.room_type, brief.width, brief.depth) == ("office", 1.4, 2.2)
    assert [r.category for r in brief.requests if r.asked] == ["desk"]
    assert brief.unknown == ("under the stairs",)


@pytest.mark.parametrize(
    ("prompt", "things", "excluded"),
    [
        ("A rocking chair, yes; a changing table, no.", {"rocking_chair": 1}, ("changing_table",)),
        ("A bed, yes; a desk, no; a chair, yes.", {"bed": 1, "chair": 1}, ("desk",)),
        ("A bed. No rug, because of my allergy.", {"bed": 1}, ("rug",)),
        ("Laundry pick-up test in a bedroom. A bed by the wall.", {"bed": 1}, ()),
        ("The kitchen begins with the stove.", {"stove": 1}, ()),
    ],
)
def test_yes_and_no_and_reasons(prompt: str, things: dict[str, int], excluded: tuple[str, ...]) -> None:
    assert told(prompt)[0] == things
    assert read_brief(prompt).excluded == excluded


@pytest.mark.parametrize("said", ["but don't put it", "but do not place it", "and never put it"])
def test_what_is_ordered_not_to_be_is_denied(said: str) -> None:
    brief = read_brief(f"A fireplace. There is one floor lamp, {said} next to the fireplace.")
    near = [r for r in brief.relations if r.subject == "floor_lamp" and r.asked]
    assert [(r.kind, r.anchors, r.negated) for r in near] == [("next_to", ("fireplace",), True)]


def test_a_projector_screen_is_no_monitor() -> None:
    brief = read_brief("Two desks, each with a monitor. A lectern stands next to the projector screen.")
    assert {"monitor", "projector_screen"} <= {r.category for r in brief.requests if r.asked}
    assert ("podium", ("projector_screen",)) in {(r.subject, r.anchors) for r in brief.relations if r.asked}


@pytest.mark.parametrize(
    "said",
    [
        "A suitcase blocks the way",
        "A suitcase that blocks the door",
        "A suitcase obstructs the passage",
        "A suitcase blocking the window",
    ],
)
def test_what_blocks_the_way_is_no_block(said: str) -> None:
    brief = read_brief(f"A bedroom with a bed. {said}.")
    assert {r.category: r.count for r in brief.requests if r.asked} == {"bed": 1, "suitcase": 1}
    assert brief.unknown == ("in the way",)
