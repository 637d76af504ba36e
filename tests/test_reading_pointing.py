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
