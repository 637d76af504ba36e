"""Things that letters or numbers tell apart."""

import pytest

from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "counts", "relations"),
    [
        (
            "Shelf A and shelf B stand opposite each other. On shelf A there are 5 red boxes. Shelf B is empty.",
            {"shelving_unit": 2, "box": 5},
            {"shelving_unit facing shelving_unit-2", "shelving_unit-2 facing shelving_unit", "box on shelving_unit"},
        ),
        (
            "Bench 1 carries a vise; bench 2 carries a drill press. Bench 3 is empty.",
            {"bench": 3, "vise": 1, "drill_press": 1},
            {"vise on bench", "drill_press on bench-2"},
        ),
        (
            "The server rack A is next to the server rack B.",
            {"server_rack": 2},
            {"server_rack next_to server_rack-2"},
        ),
        (
            "Tables A and B stand side by side. A book is on table B.",
            {"dining_table": 2, "book": 1},
            {"dining_table-2 next_to dining_table", "book on dining_table-2"},
        ),
    ],
)
def test_labels_are_ordinals(prompt: str, counts: dict[str, int], relations: set[str]) -> None:
    brief = read_brief(prompt)
    asked = [r for r in brief.requests if r.asked]
    assert {c: sum(r.count for r in asked if r.category == c) for c in {r.category for r in asked}} == counts
    assert {f"{r.subject} {r.kind} {' '.join(r.anchors)}" for r in brief.relations if r.asked} == relations
    assert not brief.unknown


def test_lone_number_is_no_label() -> None:
    brief = read_brief("A table 2 m long and a desk 1 m wide.")
    assert [r.count for r in brief.requests if r.category in ("dining_table", "desk")] == [1, 1]


@pytest.mark.parametrize(
    "prompt",
    [
        "The scene shows a bathroom with a bathtub.",
        "The scene: a bathroom with a bathtub.",
        "The scene depicts a bathroom with a bathtub.",
        "The scene consists of a bathroom with a bathtub.",
        "Create a scene of a bathroom with a bathtub.",
        "A photo of a bathroom with a bathtub.",
        "The image is of a bathroom with a bathtub.",
        "A 3D model of a bathroom with a bathtub.",
        "A render of a bathroom with a bathtub.",
        "A floor plan of a bathroom with a bathtub.",
        "A simulation of a bathroom with a bathtub.",
        "A design for a bathroom with a bathtub.",
        "A bathroom with the following: a bathtub.",
    ],
)
def test_what_shows_a_room_is_nothing_in_it(prompt: str) -> None:
    brief = read_brief(prompt)
    assert (brief.room_type, brief.unknown) == ("bathroom", ())
    assert [r.category for r in brief.requests if r.asked] == ["bathtub"]


@pytest.mark.parametrize(
    "prompt",
    ["A picture of a kitchen hangs above the sofa.", "A living room with a picture of a kitchen above the sofa."],
)
def test_a_picture_of_a_room_that_hangs_somewhere_is_one(prompt: str) -> None:
    brief = read_brief(prompt)
    assert brief.room_type != "kitchen"
    assert {"picture", "sofa"} <= {r.category for r in brief.requests if r.asked}


@pytest.mark.parametrize(
    "opening",
    [
        "Looking for",
        "We are looking for",
        "In need of",
        "Thinking of",
        "How about",
        "Welcome to",
        "Step into",
        "You find yourself in",
        "Picture",
        "Imagine",
        "You enter",
        "This is",
        "We see",
    ],
)
def test_however_a_text_begins_it_is_of_its_room(opening: str) -> None:
    brief = read_brief(f"{opening} a bathroom with a bathtub.")
    assert (brief.room_type, brief.unknown) == ("bathroom", ())
    assert [r.category for r in brief.requests if r.asked] == ["bathtub"]


@pytest.mark.parametrize(
    "words",
    ["Also present are", "Present in the room are", "Next, there are", "Afterwards, add", "Secondly, there are"],
)
def test_words_that_go_on_name_nothing(words: str) -> None:
    brief = read_brief(f"A table stands in the middle. {words} two chairs.")
    assert [r.category for r in brief.requests if r.asked] == ["dining_table", "chair"]
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "counts"),
    [
        ("A modern office boasting two desks.", {"desk": 2}),
        ("A bedroom outfitted with a bed and a wardrobe.", {"bed": 1, "wardrobe": 1}),
        ("A gym kitted out with three treadmills.", {"treadmill": 3}),
        ("A waiting room populated with twelve chairs.", {"chair": 12}),
        ("A hallway adorned with a mirror and equipped with a shoe rack.", {"mirror": 1, "shoe_rack": 1}),
        ("A nursery centred around a crib.", {"crib": 1}),
        ("The kitchen accommodates a fridge and an oven.", {"fridge": 1, "oven": 1}),
    ],
)
def test_however_it_is_said_the_room_has_it(prompt: str, counts: dict[str, int]) -> None:
    brief = read_brief(prompt)
    assert {r.category: r.count for r in brief.requests if r.asked} == counts
    assert not [r for r in brief.relations if r.asked]
    assert brief.unknown == ()


def test_what_fills_a_room_is_in_nothing_else() -> None:
    brief = read_brief("A bright classroom lined with bookshelves and filled with desks.")
    assert {r.category for r in brief.requests if r.asked} == {"bookcase", "school_desk"}
    assert not [r for r in brief.relations if r.asked]
