"""Each, either, at least, not each other: how many are meant, and how they stand to one another."""

import pytest

from thinkblox.brief import Brief
from thinkblox.reading import read_brief


def _counts(brief: Brief) -> dict[str, int]:
    counts: dict[str, int] = {}
    for request in brief.requests:
        if request.asked:
            counts[request.category] = counts.get(request.category, 0) + request.count
    return counts


def _ties(brief: Brief) -> set[tuple[str, str, tuple[str, ...]]]:
    return {(r.kind, r.subject, r.anchors) for r in brief.relations if r.asked and not r.negated}


@pytest.mark.parametrize(
    "prompt",
    [
        "Two desks not facing each other.",
        "Desks not facing each other, two of them.",
        "Two desks. Don't put the desks facing each other.",
    ],
)
def test_what_is_not_to_face_each_other_is_denied(prompt: str) -> None:
    brief = read_brief(prompt)
    assert [(r.kind, r.subject, r.anchors, r.negated) for r in brief.relations if r.asked] == [
        ("facing", "desk", ("desk",), True)
    ]


def test_a_denied_place_stays_denied_after_dont_put() -> None:
    brief = read_brief("A bedroom with a bed and a lamp. Don't put the lamp on the bed.")
    assert [(r.kind, r.subject, r.negated) for r in brief.relations if r.asked] == [("on", "table_lamp", True)]


def test_what_cannot_be_denied_is_not_understood() -> None:
    assert read_brief("Two desks, never in a row.").unknown == ("never in a row",)
