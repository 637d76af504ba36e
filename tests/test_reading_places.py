"""Where many learn, the desk of who teaches is not one of theirs."""

import pytest

from thinkblox.reading import read_brief


@pytest.mark.parametrize("named", ["a teacher's desk", "a teacher's desk and a chair", "a desk for the teacher"])
def test_pupils_have_desks_besides_that_of_who_teaches(named: str):
    brief = read_brief(f"A classroom with {named}")
    counts = {request.category: request.count for request in brief.requests if not request.asked}
    assert counts["school_desk"] == 12
    assert sum(request.count for request in brief.requests if request.category == "chair") >= 13


def test_a_stool_in_front_of_a_bench_is_its_stool():
    brief = read_brief(
        "A lab: a lab bench with three beakers, a lab stool in front of it, a fume hood and a gas bottle"
    )
    assert sum(request.count for request in brief.requests if "stool" in request.category) == 1
