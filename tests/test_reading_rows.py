"""What is said of one in each row, and of so many seats at each of several."""

import pytest

from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "category", "count"),
    [
        ("Four tables in two rows. The first table of each row has a vase.", "vase", 2),
        ("Ten pews in two columns. The last pew in each column has a book.", "book", 2),
        ("Two rows of three tables. The middle table of each row has a candelabra.", "candelabra", 2),
    ],
)
def test_one_of_each_row(prompt: str, category: str, count: int) -> None:
    brief = read_brief(prompt)
    assert brief.request(category).count == count
    assert any("of each row" in said or "in each column" in said for said in brief.unknown)


@pytest.mark.parametrize(
    ("prompt", "category", "count"),
    [
        ("Two rows of three tables. Each table seats six on two benches, one on either long side.", "bench", 12),
        ("Six tables. Each table has two benches, one on each side.", "bench", 12),
        ("Four desks. Each desk has two lamps, one at either end.", "desk_lamp", 8),
        ("A table that seats four on four stools.", "stool", 4),
    ],
)
def test_all_that_each_has_is_counted(prompt: str, category: str, count: int) -> None:
    brief = read_brief(prompt)
    assert brief.request(category).count == count
    assert not brief.unknown


@pytest.mark.parametrize(
    "prompt", ["Three toy trucks on the rug, one behind the other.", "Toy trucks: three, in single file."]
)
def test_one_behind_the_other(prompt: str) -> None:
    brief = read_brief(prompt)
    behind = [(r.subject, *r.anchors) for r in brief.relations if r.kind == "behind"]
    assert behind == [("toy_truck-2", "toy_truck"), ("toy_truck-3", "toy_truck-2")]
    assert all(r.count == 1 for r in brief.requests if r.category == "toy_truck")
    assert not brief.unknown


@pytest.mark.parametrize(
    ("prompt", "category", "count", "spread"),
    [
        ("Wine racks line three walls, two racks per wall.", "wine_rack", 6, 3),
        ("Six wine racks on three walls, two per wall.", "wine_rack", 6, 3),
        ("Cabinets line the two long walls, three on each wall.", "cabinet", 6, 2),
    ],
)
def test_so_many_at_each_wall(prompt: str, category: str, count: int, spread: int) -> None:
    brief = read_brief(prompt)
    assert brief.request(category).count == count
    assert {r.spread for r in brief.relations if r.subject == category} == {spread}
    assert not brief.unknown


@pytest.mark.parametrize(
    ("prompt", "category", "count"),
    [
        ("A room with two desks. Put a chair at both desks.", "chair", 2),
        ("Two sofas; on both sofas lie two pillows.", "pillow", 4),
        ("Two beds, four pillows on both beds.", "pillow", 4),
        ("Ten pews face the altar; there is a hymn book on each of them but the last two.", "hymn_book", 8),
    ],
)
def test_at_both_and_at_all_but_some(prompt: str, category: str, count: int) -> None:
    brief = read_brief(prompt)
    assert brief.request(category).count == count
    assert not brief.unknown


def test_far_side_is_of_what_carries_something_small() -> None:
    brief = read_brief("Office: a desk with a printer on the far right and a lamp on the left.")
    relations = {(r.subject, r.kind) for r in brief.relations if r.asked}
    assert relations >= {("printer", "on"), ("printer", "right_of"), ("desk_lamp", "left_of")}
    assert not any(subject == "desk" for subject, _ in relations)


def test_contracted_verb_is_no_name() -> None:
    brief = read_brief("The wardrobe they'd share stands between the beds.")
    assert [(r.category, r.count) for r in brief.requests if r.asked] == [("wardrobe", 1), ("bed", 2)]
    assert not brief.unknown


@pytest.mark.parametrize(
    ("prompt", "counts"),
    [
        ("Cabinets line the left and the right wall, three on each.", {"left_wall": 3, "right_wall": 3}),
        ("Cabinets stand along the left wall and the right wall, two on each.", {"left_wall": 2, "right_wall": 2}),
        ("Four cabinets along the left and the right wall.", {"left_wall": 2, "right_wall": 2}),
    ],
)
def test_left_and_right_wall(prompt: str, counts: dict[str, int]) -> None:
    brief = read_brief(prompt)
    numbers = {r.key: r.count for r in brief.requests}
    assert {r.anchors[0]: numbers[r.subject] for r in brief.relations if r.kind == "against_wall"} == counts
    assert not brief.unknown


def test_rows_told_between_dashes() -> None:
    brief = read_brief("Rows of chairs - four rows of five - face the lectern. Every seat has a catalogue on it.")
    assert (brief.request("chair").count, brief.request("magazine").count) == (20, 20)
    assert not brief.unknown


def test_booths_at_windows_have_all_their_benches() -> None:
    brief = read_brief("Along the windows run four booths, each consisting of a table and two benches.")
    assert (brief.request("dining_table").count, brief.request("bench").count) == (4, 8)
    assert not brief.unknown


def test_verb_is_left_out_before_just() -> None:
    brief = read_brief("Two desks. The one on the left has two lamps, the one on the right just a typewriter.")
    assert ("typewriter", "on", ("desk-2",)) in {(r.subject, r.kind, r.anchors) for r in brief.relations}


@pytest.mark.parametrize(
    ("prompt", "category", "count"),
    [
        ("Five rows of two desks. Every desk in the first row has a microscope on it.", "microscope", 2),
        ("Two rows of three desks. Put a lamp on each desk of the first row.", "desk_lamp", 3),
    ],
)
def test_those_of_one_row(prompt: str, category: str, count: int) -> None:
    brief = read_brief(prompt)
    assert brief.request(category).count == count
    assert any("the first row" in said for said in brief.unknown)


def test_looks_of_one_row() -> None:
    brief = read_brief("Three rows of four chairs. The chairs in the last row are red.")
    assert {r.attributes: r.count for r in brief.requests} == {("red",): 4, (): 8}
    assert any("the last row" in said for said in brief.unknown)


@pytest.mark.parametrize(
    ("prompt", "untold"),
    [
        ("A small cinema with three rows of five seats, the back row raised.", "raised"),
        ("A hall with three rows of red seats, the front row blue.", "the front row"),
        ("An auditorium with ten rows of twelve seats with an aisle in the middle.", "an aisle in the middle"),
    ],
)
def test_what_is_told_of_one_row_is_not_lost(prompt: str, untold: str) -> None:
    brief = read_brief(prompt)
    assert untold in "; ".join(brief.unknown)
    assert {r.kind for r in brief.relations if r.asked} == {"in_rows"}


@pytest.mark.parametrize(
    ("prompt", "category", "count", "rows"),
    [
        ("A table with a 3x3 grid of cubes.", "cube", 9, 3),
        ("A table with a three by three grid of red cubes.", "cube", 9, 3),
        ("Six cups in a 2x3 grid on the table.", "cup", 6, 2),
        ("Six cups are on the table in 2 rows of 3.", "cup", 6, 2),
        ("A classroom with desks in a 4 by 5 grid.", "school_desk", 20, 4),
    ],
)
def test_a_grid_is_so_many_rows_of_so_many(prompt: str, category: str, count: int, rows: int) -> None:
    brief = read_brief(prompt)
    assert brief.request(category).count == count
    assert [(r.subject, r.rows) for r in brief.relations if r.kind == "in_rows"] == [(category, rows)]
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "category", "count", "rows"),
    [
        ("There are three rows, each with four desks.", "desk", 12, 3),
        ("Each row has four desks, and there are three rows.", "desk", 12, 3),
        ("A hall with ten rows of chairs, each with twelve chairs.", "chair", 120, 10),
        ("A classroom with three rows of desks. Each row has four desks.", "school_desk", 12, 3),
        ("A classroom with three rows; each has four desks.", "school_desk", 12, 3),
    ],
)
def test_how_many_each_row_has_is_told_of_each(prompt: str, category: str, count: int, rows: int) -> None:
    brief = read_brief(prompt)
    assert {r.category: r.count for r in brief.requests if r.asked} == {category: count}
    assert [r.rows for r in brief.relations if r.kind == "in_rows"] == [rows]
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "untold"),
    [
        ("A supermarket with four aisles.", "four aisles"),
        ("The aisle between the shelves is one meter wide.", "one meter wide"),
        ("A shop with shelves and aisles 1.2 m wide.", "1.2 m wide"),
        ("A library with bookcases and 1.5 m wide aisles between them.", "1.5 m wide"),
    ],
)
def test_how_many_and_how_wide_aisles_are_is_said_not_to_be_seen_to(prompt: str, untold: str) -> None:
    brief = read_brief(prompt)
    assert brief.unknown == (untold,)
    assert brief.width is brief.depth is None
    assert all(r.size == (None, None, None) for r in brief.requests)


@pytest.mark.parametrize(
    ("prompt", "counts", "untold"),
    [
        ("An office with six cubicles in two rows.", {"desk_booth": 6}, ()),
        (
            "An office with eight cubicles, each with a desk, a chair and a computer.",
            {"desk": 8, "chair": 8, "computer": 8},
            ("eight cubicles",),
        ),
        (
            "An office with four cubicles. Each cubicle has a desk and a monitor on the desk.",
            {"desk": 4, "monitor": 4},
            ("four cubicles",),
        ),
    ],
)
def test_cubicles_are_places_to_work_in_an_office(prompt: str, counts: dict[str, int], untold: tuple[str, ...]) -> None:
    brief = read_brief(prompt)
    assert {r.category: r.count for r in brief.requests if r.asked} == counts
    assert brief.room_type == "office"
    assert brief.unknown == untold


def test_the_desk_of_the_teacher_is_none_of_those_of_the_class() -> None:
    brief = read_brief("A classroom with ten desks. A globe stands on the teacher's desk.")
    assert {r.category: r.count for r in brief.requests if r.asked} == {"school_desk": 10, "desk": 1, "globe": 1}
    assert ("globe", "on", ("desk",)) in {(r.subject, r.kind, r.anchors) for r in brief.relations}
    assert brief.unknown == ()


def test_students_who_sit_at_desks_do_not_live_there() -> None:
    assert read_brief("Students sit at ten desks.").room_type == "room"
    assert read_brief("A room for a student with a desk.").room_type == "dorm_room"


@pytest.mark.parametrize(
    ("prompt", "room"),
    [
        ("A classroom with ten desks. The teacher's desk faces the students.", "classroom"),
        ("A classroom with three rows of desks and the teacher's desk at the front, facing the class.", "classroom"),
    ],
)
def test_who_faces_people_faces_where_they_sit(prompt: str, room: str) -> None:
    brief = read_brief(prompt)
    assert ("desk", "facing", ("school_desk",)) in {(r.subject, r.kind, r.anchors) for r in brief.relations}
    assert brief.room_type == room
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "untold"),
    [
        ("The desk faces the students.", "faces the students"),
        ("A lectern facing the audience.", "facing the audience"),
        ("A classroom with desks facing the teacher.", "facing the teacher"),
    ],
)
def test_people_who_sit_nowhere_are_not_faced(prompt: str, untold: str) -> None:
    brief = read_brief(prompt)
    assert brief.unknown == (untold,)
    assert brief.room_type in ("room", "classroom")


def test_two_things_in_two_places_are_not_doubted() -> None:
    brief = read_brief("The cups are on the tray and the plates are on the table.")
    assert {(r.subject, r.kind, r.anchors) for r in brief.relations if r.asked} == {
        ("cup", "on", ("tray",)),
        ("plate", "on", ("dining_table",)),
    }
    assert brief.unknown == ()
