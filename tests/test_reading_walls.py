"""A wall of things is a row of them along one wall."""

import pytest

from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "category", "count"),
    [
        ("A home office with two desks and a wall of bookcases", "bookcase", 4),
        ("A den with a wall of books", "bookcase", 4),
        ("A garage with an entire wall of cabinets", "cabinet", 4),
        ("An office with a whole wall of six filing cabinets", "filing_cabinet", 6),
        ("A gym with one wall of lockers", "locker", 4),
    ],
)
def test_a_wall_of_things_is_a_row_along_a_wall(prompt: str, category: str, count: int):
    brief = read_brief(prompt)
    things = next(request for request in brief.requests if request.asked and request.category == category)
    assert things.count == count
    said = {(relation.kind, relation.anchors) for relation in brief.relations if relation.subject == things.key}
    assert {("in_rows", ()), ("against_wall", ("wall",))} <= said
    assert not [word.text for word in brief.account if word.fate == "not_understood"]


@pytest.mark.parametrize("prompt", ["A hall with a wall of glass", "A control room with a wall of six monitors"])
def test_what_stands_along_no_wall_is_no_wall(prompt: str):
    assert "wall" in [word.text for word in read_brief(prompt).account if word.fate == "not_understood"]


def test_two_walls_of_things_are_shared_out():
    brief = read_brief("A gallery with two walls of pictures")
    assert [r.spread for r in brief.relations if r.kind == "against_wall" and r.subject == "picture"] == [2]


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("The north wall is lined with bookcases.", ("bookcase", "against_wall", ("north_wall",))),
        ("The north wall is occupied by two wardrobes.", ("wardrobe", "against_wall", ("north_wall",))),
        ("The left wall is covered with posters.", ("poster", "against_wall", ("left_wall",))),
        ("The corner is occupied by a lamp.", ("floor_lamp", "in_corner", ("corner",))),
        ("One corner is home to an armchair.", ("armchair", "in_corner", ("corner",))),
        ("The centre of the room is taken up by a pool table.", ("pool_table", "in_centre", ("centre",))),
        ("The middle of the room has a piano.", ("piano", "in_centre", ("centre",))),
        ("The right side is taken up by a sofa.", ("sofa", "against_wall", ("right_wall",))),
        ("A sofa stands at the northern end of the room.", ("sofa", "against_wall", ("north_wall",))),
        ("On the northern wall there is a bookcase.", ("bookcase", "against_wall", ("north_wall",))),
    ],
)
def test_what_a_place_is_lined_with_or_home_to_is_there(prompt: str, relation: tuple[str, str, tuple[str, ...]]):
    brief = read_brief(prompt)
    assert relation in {(r.subject, r.kind, r.anchors) for r in brief.relations if r.asked}
    assert brief.unknown == ()


@pytest.mark.parametrize("words", ["is home to", "is occupied by"])
def test_what_a_room_is_home_to_is_in_it(words: str):
    brief = read_brief(f"The living room {words} two sofas and a piano.")
    assert brief.room_type == "living_room"
    assert {r.category: r.count for r in brief.requests if r.asked} == {"sofa": 2, "piano": 1}
    assert not [r for r in brief.relations if r.asked]


@pytest.mark.parametrize(
    "prompt",
    [
        "A bedroom with the bed's head against the north wall.",
        "There is a bed. Its head is against the north wall.",
        "There is a bed. The bed's head is against the north wall.",
    ],
)
def test_a_bed_stands_where_its_head_does(prompt: str) -> None:
    brief = read_brief(prompt)
    assert not brief.unknown
    assert [(r.kind, r.subject, r.anchors) for r in brief.relations if r.asked] == [
        ("against_wall", "bed", ("north_wall",))
    ]


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("A bench runs the length of the wall.", ("bench", "against_wall", ("wall",))),
        ("A counter running the full length of the left wall.", ("counter", "against_wall", ("left_wall",))),
        ("The walls are decorated with paintings.", ("picture", "against_wall", ("wall",))),
        ("One wall is covered in mirrors.", ("mirror", "against_wall", ("one_wall",))),
        ("A row of lockers lines the hallway.", ("locker", "against_wall", ("wall",))),
    ],
)
def test_what_lines_or_covers_a_wall_is_along_it(prompt: str, relation: tuple[str, str, tuple[str, ...]]):
    brief = read_brief(prompt)
    assert relation in {(r.subject, r.kind, r.anchors) for r in brief.relations if r.asked}
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "walls"),
    [
        (
            "The left side of the room has a bed and the right side has a desk.",
            {("bed", "left_wall"), ("desk", "right_wall")},
        ),
        (
            "The left half of the room has a bed, and the right half has a desk.",
            {("bed", "left_wall"), ("desk", "right_wall")},
        ),
        ("The left has a bed, the right has a desk.", {("bed", "left_wall"), ("desk", "right_wall")}),
        (
            "The front of the room has a blackboard and the back has a wardrobe.",
            {("blackboard", "near_wall"), ("wardrobe", "far_wall")},
        ),
    ],
)
def test_sides_of_the_room_have_what_is_said(prompt: str, walls: set[tuple[str, str]]):
    brief = read_brief(prompt)
    assert {(r.subject, str(r.anchors[0])) for r in brief.relations if r.asked} == walls
    assert brief.unknown == ()


def test_the_left_of_two_things_is_no_side_of_the_room():
    brief = read_brief("The bed has two nightstands. The left has a lamp and the right has a book.")
    told = {(r.subject, r.kind, r.anchors) for r in brief.relations if r.asked}
    assert {("table_lamp", "on", ("nightstand",)), ("book", "on", ("nightstand-2",))} <= told


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("A glass cabinet on the wall.", ("wall_cabinet", "on", ("wall",))),
        ("A display cabinet hangs on the wall.", ("wall_cabinet", "on", ("wall",))),
        ("A glass cabinet against the wall.", ("china_cabinet", "against_wall", ("wall",))),
        ("A trophy cabinet stands on the left wall.", ("china_cabinet", "against_wall", ("left_wall",))),
    ],
)
def test_a_cabinet_on_the_wall_hangs_there(prompt: str, relation: tuple[str, str, tuple[str, ...]]) -> None:
    brief = read_brief(prompt)
    assert [(r.subject, r.kind, r.anchors) for r in brief.relations if r.asked] == [relation]
    assert not brief.unknown
