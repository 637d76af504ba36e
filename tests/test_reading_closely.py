"""Sentences that were misread in silence, or told as not understood though they are plain: each says what is there."""

import pytest

from tests.briefs import counted
from thinkblox.brief import Brief
from thinkblox.reading import read_brief

Ties = set[tuple[str, str, tuple[str, ...]]]


def ties(brief: Brief) -> Ties:
    """Every relation as its kind, its subject and its anchors."""
    return {(r.kind, r.subject, r.anchors) for r in brief.relations if not r.negated}


@pytest.mark.parametrize(
    ("prompt", "counts", "wanted"),
    [
        (
            "A table with two chairs on each side and one chair at each end.",
            {"chair": 6},
            {("at_long_side", "chair", ("dining_table",)), ("at_short_side", "chair-2", ("dining_table",))},
        ),
        (
            "A low table, two armchairs at one end of the table and a sofa at the other end.",
            {"armchair": 2, "sofa": 1},
            {("at_short_side", "armchair", ("coffee_table",)), ("at_short_side", "sofa", ("coffee_table",))},
        ),
        (
            "A round table, four chairs round it, and every seat laid with a plate and a fork.",
            {"plate": 4, "fork": 4},
            {("on", "plate", ("dining_table",)), ("on", "fork", ("dining_table",))},
        ),
        (
            "In the middle of the table stands a bottle of wine between two candles.",
            {"candle": 2},
            {("on", "candle", ("dining_table",)), ("between", "bottle", ("candle",))},
        ),
        (
            "A table with a vase between two candles.",
            {"dining_table": 1, "candle": 2},
            {("between", "vase", ("candle",)), ("on", "candle", ("dining_table",))},
        ),
        (
            "An office with four desks. Each desk has a monitor and a mouse, and two of them have a lamp too.",
            {"desk": 4, "mouse": 4, "desk_lamp": 2},
            {("on", "mouse", ("desk", "desk-2")), ("on", "desk_lamp", ("desk",))},
        ),
        (
            "A lamp stands on one of the nightstands and an alarm clock on the other.",
            {"nightstand": 2},
            {("on", "table_lamp", ("nightstand",)), ("on", "alarm_clock", ("nightstand-2",))},
        ),
        (
            "A lab: two lab benches. Beakers: six on the left bench and three on the right bench.",
            {"lab_bench": 2, "beaker": 9},
            {("on", "beaker", ("lab_bench",)), ("on", "beaker-2", ("lab_bench-2",))},
        ),
        (
            "The kitchen has an island with three stools. A kettle is on the counter.",
            {"kitchen_island": 1},
            {("on", "kettle", ("base_cabinet",))},
        ),
        (
            "A waiting room with a reception desk. A scale for dogs stands next to the reception desk.",
            {"bathroom_scale": 1},
            {("next_to", "bathroom_scale", ("reception_desk",))},
        ),
        (
            "An island with three bar stools on one side of it and two on the other.",
            {"bar_stool": 5},
            {("in_front_of", "bar_stool", ("kitchen_island",)), ("behind", "bar_stool-2", ("kitchen_island",))},
        ),
        (
            "A sofa facing the fireplace. Actually no, let it face the window and put a chair facing the fire instead.",
            {"sofa": 1, "chair": 1},
            {("facing", "sofa", ("window",)), ("facing", "chair", ("fireplace",))},
        ),
        (
            "A bench against the left wall. Actually, put it against the right wall.",
            {"bench": 1},
            {("against_wall", "bench", ("right_wall",))},
        ),
        (
            "She (my daughter) eats at a small bistro table with two chairs near the window.",
            {"bistro_table": 1, "chair": 2},
            {("near", "bistro_table", ("window",)), ("around", "chair", ("bistro_table",))},
        ),
        (
            "A desk with a lamp on the left and a phone on the right.",
            {"desk_lamp": 1, "phone": 1},
            {("on", "desk_lamp", ("desk",)), ("left_of", "desk_lamp", ("desk",)), ("right_of", "phone", ("desk",))},
        ),
        (
            "On the workbench are a vise at the left end and a drill at the right end.",
            {"vise": 1, "power_drill": 1},
            {("on", "vise", ("workbench",)), ("right_of", "power_drill", ("workbench",))},
        ),
        (
            "Buckets of roses, tulips and sunflowers, one each, stand against the window.",
            {"flower_bucket": 3},
            {("next_to", "flower_bucket-2", ("window",)), ("next_to", "flower_bucket-3", ("window",))},
        ),
        (
            "Twenty desks, a chair at each. The teacher's desk faces the door; the chair of the teacher is behind it.",
            {"chair": 21},
            {("behind", "chair-2", ("executive_desk",))},
        ),
        ("An artist's desk with a palette and a brush.", {"paint_palette": 1}, {("on", "paint_palette", ("desk",))}),
        ("A sofa and two chairs around a low table so people talk to each other.", {"sofa": 1, "chair": 2}, set()),
        ("A charging dock against the wall.", {"charging_dock": 1}, {("against_wall", "charging_dock", ("wall",))}),
        ("A desk with stacks of old books all over the place.", {"book": 6}, set()),
        ("A bathtub with a wooden tray across it.", {"tray": 1}, {("on", "tray", ("bathtub",))}),
        (
            "A table for four. At every seat a plate, a fork and a glass. A sofa by the wall.",
            {"plate": 4, "fork": 4, "sofa": 1},
            {("on", "plate", ("dining_table",)), ("on", "glass", ("dining_table",))},
        ),
        (
            "Two sofas, one against the left wall, one against the right wall, both facing the fire, a rug in between.",
            {"sofa": 2},
            {("between", "rug", ("sofa", "sofa-2"))},
        ),
        (
            "Four bookcases, two along the left wall and two along the right wall, and two reading tables in between.",
            {"bookcase": 4},
            {("between", "dining_table", ("bookcase", "bookcase-2"))},
        ),
        (
            "A bookshelf to the left of the window and a desk to the right of it.",
            {"desk": 1},
            {("left_of", "bookcase", ("window",)), ("right_of", "desk", ("window",))},
        ),
        ("A desk with a lamp, three drawers and a chair.", {"desk": 1, "dresser": 0}, {("at", "chair", ("desk",))}),
        ("Bar: six bar stools line the wall. Hmm, four is enough.", {"bar_stool": 4}, set()),
        ("A counter with menus on it.", {"menu": 3}, {("on", "menu", ("counter",))}),
        ("A sofa by the fire.", {"fireplace": 1}, {("next_to", "sofa", ("fireplace",))}),
    ],
)
def test_what_is_said_is_read(prompt: str, counts: dict[str, int], wanted: Ties) -> None:
    brief = read_brief(prompt)
    assert not brief.unknown
    found = counted(brief)
    assert {name: found.get(name, 0) for name in counts} == counts
    assert wanted <= ties(brief)


@pytest.mark.parametrize(
    "prompt",
    [
        "Four desks, each with a chair. Three chairs are black and one is red.",
        "Four desks. Three of the chairs are black and one is red.",
    ],
)
def test_some_that_look_alike_are_of_those_that_are_there(prompt: str) -> None:
    looks = {r.attributes: r.count for r in read_brief(prompt).requests if r.category == "chair"}
    assert looks == {("black",): 3, ("red",): 1}


@pytest.mark.parametrize(
    "prompt",
    [
        "A workbench with a vise. Nothing else on the workbench.",
        "A table with a bowl. Keep the remaining table top free.",
        "A desk with a lamp. Keep the rest of the desk free.",
        "A coffee table with a bowl and nothing else on it.",
    ],
)
def test_a_top_on_which_nothing_else_is_to_be_gets_nothing_else(prompt: str) -> None:
    brief = read_brief(prompt)
    assert brief.empty
    assert not brief.unknown


def test_the_middle_of_the_room_that_is_left_free_is_no_thing() -> None:
    for prompt in ("The middle of the room should be left free for dancing.", "Leave the middle of the room clear."):
        brief = read_brief(prompt)
        assert brief.free == ("centre",)
        assert not any(r.asked for r in brief.requests)


def test_where_somebody_sits_is_not_where_the_furniture_is() -> None:
    brief = read_brief("My grandmother sits in a wheelchair, so her bedroom must have space to turn: put only the bed.")
    assert counted(brief) == {"wheelchair": 1, "bed": 1}
    assert not brief.relations


def test_a_bed_is_not_called_after_its_article() -> None:
    assert read_brief("The room has a single bed.").request("bed").called == ""


def test_a_fruit_that_is_a_colour_is_one_where_some_are_told_apart_by_it() -> None:
    brief = read_brief("Four cushions on the sofa, two of them orange, one blue.")
    looks = {r.attributes: r.count for r in brief.requests if r.category == "pillow"}
    assert looks == {("orange",): 2, ("blue",): 1, (): 1}
    assert counted(brief) == {"pillow": 4, "sofa": 1}


def test_what_was_moved_is_no_longer_where_it_was() -> None:
    brief = read_brief("A bench against the left wall. Actually, put it against the right wall.")
    assert ("against_wall", "bench", ("left_wall",)) not in ties(brief)


def test_a_stool_that_stands_before_a_bench_is_its_seat() -> None:
    brief = read_brief(
        "Chemistry lab: a lab bench against the wall with three beakers, a lab stool in front of the bench."
    )
    assert "stool" not in counted(brief)


@pytest.mark.parametrize(
    "prompt",
    [
        "A bedroom with a bed. No rug, it stops the wheels.",
        "A bedroom with a bed, without a rug, as it slips.",
        "A bedroom with a bed. Anything on the floor is fine except rugs.",
    ],
)
def test_what_is_not_to_be_there_is_not_there_and_why_asks_for_nothing(prompt: str) -> None:
    brief = read_brief(prompt)
    assert (brief.excluded, brief.unknown, counted(brief)) == (("rug",), (), {"bed": 1})


def test_how_far_off_something_is_is_no_size() -> None:
    brief = read_brief("A table saw is in the middle and a bandsaw is 1 m to its left.")
    assert brief.unknown == ("1 m",)
    assert brief.request("bandsaw").size == (None, None, None)
    assert read_brief("A table 2 m long to the left of the sofa.").request("side_table").size[1] == 2.0


def test_an_age_counts_no_rooms() -> None:
    assert not read_brief("my 15 yo's gaming bedroom, two screens and posters").unknown
