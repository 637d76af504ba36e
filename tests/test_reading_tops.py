"""Where on a top things lie, what is stacked two by two, grids of rows and columns, and rooms that nobody knows."""

import os
import subprocess
import sys

import pytest

from tests.test_reading_plain_words import _asked
from tests.test_reading_turns import related
from thinkblox.generate import generate_room
from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("A desk with a lamp on its left side.", "1 desk_lamp on desk, 1 desk_lamp left_of desk"),
        ("A counter; on its right end a cash register.", "1 cash_register right_of counter"),
        (
            "A desk with a lamp in the back left corner of the desk.",
            "1 desk_lamp on desk, 1 desk_lamp behind desk, 1 desk_lamp left_of desk",
        ),
        (
            "A desk with a plant on the right corner of the desk.",
            "1 potted_plant on desk, 1 potted_plant right_of desk",
        ),
        ("A kitchen with a long counter; a toaster at the far left of the counter.", "1 toaster left_of base_cabinet"),
        ("A sideboard with a vase at each end.", "1 vase left_of sideboard, 1 vase-2 right_of sideboard"),
        ("A long dining table with a candle at either end of it.", "1 candle left_of dining_table"),
        (
            "A desk with a lamp at one end and a printer at the other end.",
            "1 desk_lamp left_of desk, 1 printer right_of desk",
        ),
        ("A console table with a lamp at one end and a vase at the other.", "1 vase on console_table"),
        ("A sofa with a cushion on the left side.", "1 pillow on sofa, 1 pillow left_of sofa"),
        ("On the left side of the desk is a laptop; on the right side a stack of books.", "1 book_stack right_of desk"),
        ("A table with a red cube on the left third.", "1 cube on dining_table, 1 cube left_of dining_table"),
        ("A cafe with three tables, each with two chairs, by the window.", "6 chair around dining_table"),
        ("A cafe with three tables each with two chairs by the window.", "3 dining_table next_to window"),
        ("Ten boxes, half on the floor and the other half on shelves.", "5 box on floor, 5 box-2 on shelving_unit"),
        (
            "An island in the middle, sinks at both ends.",
            "1 sink left_of kitchen_island, 1 sink-2 right_of kitchen_island",
        ),
        ("A desk with a lamp to the left of it.", "1 floor_lamp left_of desk"),
        (
            "A desk carries a monitor and, in front of the monitor, a keyboard.",
            "1 keyboard on desk, 1 keyboard in_front_of monitor",
        ),
        ("A studio with a camera on a tripod.", "1 camera on tripod"),
        ("A studio with two cameras on tripods.", "2 camera on tripod"),
        (
            "A shop with two cupboards. One of them holds ten tins, the other one four teapots.",
            "10 tin_can inside cabinet, 4 teapot inside cabinet-2",
        ),
        ("The TV stands on a cabinet. A plant is to the left of the TV.", "1 plant left_of tv"),
        ("A bench at the left end of the table.", "1 bench left_of dining_table"),
        ("A kitchen with an island, three stools on one side of the island.", "3 bar_stool in_front_of kitchen_island"),
        (
            "A table, one chair on one side and two chairs on the opposite side.",
            "1 chair in_front_of dining_table, 2 chair-2 behind dining_table",
        ),
        (
            "A living room with a sofa on one side and a television on the opposite side.",
            "1 sofa against_wall left_wall",
        ),
    ],
)
def test_what_is_at_a_side_of_a_top_is_there(prompt: str, relations: str) -> None:
    brief = read_brief(prompt)
    assert set(relations.split(", ")) <= set(related(brief))
    assert brief.unknown == ()


def test_a_table_with_something_at_one_end_stands_where_it_will() -> None:
    brief = read_brief("A long table with a vase at one end.")
    assert not any("wall" in relation for relation in related(brief))


@pytest.mark.parametrize(
    "prompt",
    [
        "A laundry with a stacked washer and dryer.",
        "A laundry: stacked washer/dryer, a sink.",
        "A laundry with a washer and a dryer stacked on top of each other in the corner.",
        "A laundry with a washer and dryer, stacked, and a basket.",
        "A laundry with a dryer stacked on a washer.",
    ],
)
def test_a_washer_and_a_dryer_are_stacked(prompt: str) -> None:
    brief = read_brief(prompt)
    assert "1 dryer on washing_machine" in related(brief)
    assert brief.unknown == ()
    assert not any(request.states for request in brief.requests)


@pytest.mark.parametrize(
    ("prompt", "asked"),
    [
        ("A classroom with 24 chairs in 4 rows and 6 columns.", "24 chair"),
        ("A classroom with chairs in 4 rows and 6 columns.", "24 chair"),
        ("A classroom with desks in four columns and five rows.", "20 school_desk"),
        ("A hall with chairs arranged in five rows by eight columns.", "40 chair"),
        ("A meeting room with chairs in 3 rows of 5.", "15 chair"),
        ("A hall where twelve chairs form three rows.", "12 chair"),
        ("A temple with four columns and two rows of three benches.", "6 bench, 4 column"),
    ],
)
def test_rows_and_columns_are_counted(prompt: str, asked: str) -> None:
    brief = read_brief(prompt)
    assert _asked(brief) == asked
    assert brief.unknown == ()


def test_so_many_in_each_row_are_counted_and_where_is_asked() -> None:
    brief = read_brief("A greenhouse with three rows of three planters and two plants in each row.")
    assert _asked(brief) == "6 plant, 9 planter"
    assert brief.unknown == ("in each row",)


def test_a_first_word_that_nobody_knows_is_said() -> None:
    assert read_brief("A glorp with a clock on the wall.").unknown == ("A glorp (no such room or thing is known)",)


def test_a_mug_in_the_corner_is_doubted() -> None:
    brief = read_brief("The desk is by the window. There is a mug at the front right corner.")
    assert brief.unknown == ("a mug in the corner (of what?)",)


def test_what_is_outside_of_the_room_is_said() -> None:
    brief = read_brief("A garage workshop with a workbench; the car stays outside.")
    assert not any("outside" in relation for relation in related(brief))
    assert brief.unknown == ("outside",)


def test_things_lie_where_on_the_top_they_were_asked_for() -> None:
    made = generate_room(
        "An office with a desk with a lamp in the back left corner of the desk and a stack of books on its right side.",
        fill="named",
    )
    (desk,) = (p for p in made.scene.placements if p.category == "desk")
    lamp, books = (
        next(desk.to_local((p.position[0], p.position[1])) for p in made.scene.placements if p.category == category)
        for category in ("desk_lamp", "book_stack")
    )
    assert lamp[0] < -desk.size[0] / 6
    assert lamp[1] > desk.size[1] / 6
    assert books[1] < -desk.size[1] / 6
    assert all(relation.holds for relation in made.report.relations)


def test_the_two_sides_of_a_corner_come_in_one_order_in_every_process() -> None:
    code = "from thinkblox.reading import read_brief; from thinkblox.value import to_json; import sys; "
    code += "sys.stdout.buffer.write(to_json(read_brief('A desk with a lamp in the back left corner of the desk.')))"
    seeds = [os.environ | {"PYTHONHASHSEED": seed} for seed in ("1", "3")]
    one, other = (subprocess.run([sys.executable, "-c", code], capture_output=True, env=e, check=True) for e in seeds)
    assert one.stdout == other.stdout != b""


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("A desk with a lamp on the left corner.", {("desk_lamp", "on", "desk"), ("desk_lamp", "left_of", "desk")}),
        ("A bed in the left corner.", {("bed", "in_corner", "left_wall")}),
        (
            "A bar in the corner with four stools.",
            {("bar_counter", "in_corner", "corner"), ("bar_stool", "at", "bar_counter")},
        ),
        ("A closet next to the bed.", {("wardrobe", "next_to", "bed")}),
        ("A toilet next to the tub with a plant.", {("toilet", "next_to", "bathtub")}),
    ],
)
def test_corners_of_tops_and_things_that_name_rooms_as_well(prompt: str, relations: set[tuple[str, str, str]]) -> None:
    brief = read_brief(prompt)
    assert {(r.subject, r.kind, r.anchors[0]) for r in brief.relations if r.asked} >= relations
    assert not brief.unknown


@pytest.mark.parametrize(
    ("prompt", "relations"),
    [
        ("A mug stands at the front edge of the table.", {"on": "cup", "in_front_of": "cup"}),
        ("A mug on the left edge of the table.", {"on": "cup", "left_of": "cup"}),
        ("A cube near the left edge of the table.", {"on": "cube", "left_of": "cube"}),
        ("A cube along the back edge of the table.", {"on": "cube", "behind": "cube"}),
        ("Near the right edge of the table stands a vase.", {"on": "vase", "right_of": "vase"}),
        ("A table with a red block near the left edge.", {"on": "block", "left_of": "block"}),
        ("A chair near the left edge of the table.", {"left_of": "chair"}),
    ],
)
def test_small_things_near_an_edge_of_a_top_are_on_it(prompt: str, relations: dict[str, str]) -> None:
    brief = read_brief(prompt)
    assert {r.kind: r.subject for r in brief.relations if r.asked} == relations
    assert {r.anchors for r in brief.relations if r.asked} == {("dining_table",)}
    assert brief.unknown == ()


def test_the_near_edge_is_of_the_desk_that_was_named() -> None:
    brief = read_brief("A monitor at the far edge of the desk and a keyboard at the near edge.")
    assert {("monitor", "behind", ("desk",)), ("keyboard", "in_front_of", ("desk",))} <= {
        (r.subject, r.kind, r.anchors) for r in brief.relations
    }
    assert brief.unknown == ()


@pytest.mark.parametrize("where", ["in each corner", "at each corner of the table", "on each corner"])
def test_each_corner_of_a_table_has_one_and_there_is_one_table(where: str) -> None:
    brief = read_brief(f"A table with a bottle {where}.")
    assert _asked(brief) == "4 bottle, 1 dining_table"
    assert brief.unknown == (where,)
