"""Things that are pointed at before anybody tells of them."""

import pytest

from thinkblox.reading import read_brief


@pytest.mark.parametrize(
    ("prompt", "category", "count", "looks"),
    [
        ("Set the table for four. A round table in the dining room.", "dining_table", 1, {"round", "for-4"}),
        ("A study. Use black for the chairs. Two chairs stand by the window.", "chair", 2, {"black"}),
        ("Use oak for the desks and linen for the curtains. Three desks.", "desk", 3, {"oak"}),
        ("Two chairs stand by the window. Use black for the chairs.", "chair", 2, {"black"}),
    ],
)
def test_told_of_later(prompt: str, category: str, count: int, looks: set[str]) -> None:
    brief = read_brief(prompt)
    found = [r for r in brief.requests if r.category == category]
    assert [r.count for r in found] == [count]
    assert looks <= set(found[0].attributes)
    assert not brief.unknown


def test_one_that_may_have_been_pointed_at_is_asked_about() -> None:
    assert any("again?" in said for said in read_brief("The desk is by the window. A desk of oak.").unknown)


def test_another_in_another_place_is_not_asked_about() -> None:
    brief = read_brief("The desk is by the window. A desk for the children stands by the door.")
    assert not brief.unknown
    assert sum(r.count for r in brief.requests if r.category == "desk") == 2


def test_long_one_is_the_table_that_is_long() -> None:
    brief = read_brief("Ten round tables and a long table. On every round table is a vase, on the long one a book.")
    assert not brief.unknown
    assert brief.request("vase").count == 10
    assert ("book", "on", ("dining_table-2",)) in {(r.subject, r.kind, r.anchors) for r in brief.relations}


@pytest.mark.parametrize(
    ("prompt", "carrier"),
    [
        ("A sink cabinet against the wall and a mirror above the sink.", "sink_cabinet"),
        ("A bathroom with a vanity unit and a mirror above the sink.", "vanity"),
        ("A washbasin cabinet by the door and a mirror above the basin.", "sink_cabinet"),
    ],
)
def test_sink_of_what_has_one_is_no_other(prompt: str, carrier: str) -> None:
    brief = read_brief(prompt)
    assert [request.category for request in brief.requests if request.asked] == [carrier, "mirror"]
    assert ("mirror", "above", (carrier,)) in {(r.subject, r.kind, r.anchors) for r in brief.relations}


def test_what_a_comma_with_tells_is_in_the_subject() -> None:
    text = "A shelf against the wall holds six books. A toy basket is to the left of the shelf, with four balls in it."
    brief = read_brief(text)
    assert ("inside", "ball", ("toy_box",)) in {(r.kind, r.subject, r.anchors) for r in brief.relations if r.asked}
    assert not brief.unknown


def test_a_garage_for_two_cars_has_those_that_are_named() -> None:
    cars = [r.count for r in read_brief("A two-car garage with a car and a bench.").requests if r.category == "car"]
    assert cars == [1]


@pytest.mark.parametrize(
    ("prompt", "states"),
    [
        ("The desk has a lamp. It is switched on.", {"desk_lamp": "switched on"}),
        ("The nightstand has a lamp on it. It is lit.", {"table_lamp": "lit"}),
        ("A table with a candle. It is burning.", {"candle": "burning"}),
        ("The bed has a blanket. It is neatly folded.", {"blanket": "folded"}),
        ("The bed has a blanket. It is unmade.", {"bed": "unmade"}),
        ("The desk has a chair. It is pushed in.", {"chair": "pushed in"}),
        ("The shelf has a book. It is open.", {"book": "open"}),
        ("The cabinet has a vase on it. It is open.", {"cabinet": "open"}),
        ("The kitchen has an oven and a table. It is switched on.", {"oven": "switched on"}),
        ("The basket has a towel in it. It is full.", {"basket": "full"}),
    ],
)
def test_it_is_what_can_be_so(prompt: str, states: dict[str, str]) -> None:
    brief = read_brief(prompt)
    assert {r.category: " ".join(r.states) for r in brief.requests if r.states} == states
    assert brief.unknown == ()


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("A bed with a nightstand and a lamp on it.", ("table_lamp", "on", "nightstand")),
        ("Two beds, each with a nightstand and a lamp on it.", ("table_lamp", "on", "nightstand")),
        ("A sofa with a coffee table in front of it and a vase on it.", ("vase", "on", "coffee_table")),
        ("An armchair with a side table and a book on it.", ("book", "on", "side_table")),
        ("A bed with a nightstand and two pillows on it.", ("pillow", "on", "bed")),
        ("A sofa with a side table and a blanket on it.", ("blanket", "on", "sofa")),
    ],
)
def test_what_nobody_puts_on_a_bed_is_on_what_stands_beside_it(prompt: str, relation: tuple[str, str, str]) -> None:
    brief = read_brief(prompt)
    assert relation in {(r.subject, r.kind, r.anchors[0]) for r in brief.relations}
    assert brief.unknown == ()


@pytest.mark.parametrize(
    "prompt",
    [
        "A dining table. Around it are six chairs, each with a cushion. On it is a vase.",
        "A dining table with six chairs, each with a cushion on it. A vase stands on it.",
    ],
)
def test_it_is_none_of_several_that_a_sentence_before_told_of_each(prompt: str) -> None:
    brief = read_brief(prompt)
    assert ("vase", "on", ("dining_table",)) in {(r.subject, r.kind, r.anchors) for r in brief.relations}
    assert brief.unknown == ()


def test_these_stand_somewhere() -> None:
    brief = read_brief("A wardrobe and a dresser. These stand side by side against the left wall.")
    assert {r.category for r in brief.requests if r.asked} == {"wardrobe", "dresser"}
    assert ("dresser", "next_to", ("wardrobe",)) in {(r.subject, r.kind, r.anchors) for r in brief.relations}
    assert brief.unknown == ()
