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
