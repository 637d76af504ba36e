"""A stack is several things of which one lies on the other, and all of them are where the lowest one is."""

import pytest

from tests.briefs import counted
from thinkblox.brief import Brief
from thinkblox.evaluation.annotations import Annotation, Count, ObjectRelation
from thinkblox.evaluation.brief_judge import judge_brief
from thinkblox.reading import read_brief


def _lying(brief: Brief) -> list[str]:
    counts = {request.key: request.count for request in brief.requests}
    found = (r for r in brief.relations if r.kind in ("on", "inside", "in_corner"))
    return [f"{counts[r.subject]} {r.subject} {'on each' if r.each else r.kind} {r.anchors[0]}" for r in found]


@pytest.mark.parametrize(
    ("prompt", "lying"),
    [
        (
            "A counter with a stack of plates on it.",
            ["1 plate on counter", "1 plate-2 on plate", "1 plate-3 on plate-2"],
        ),
        ("A desk with a stack of two books.", ["1 book on desk", "1 book-2 on book"]),
        (
            "Three tables, each with a stack of two magazines on it.",
            ["3 magazine on each dining_table", "3 magazine-2 on each magazine"],
        ),
        ("A counter with two stacks of two trays.", ["2 tray on counter", "2 tray-2 on each tray"]),
        ("A sofa, stacked boxes in the corner.", ["1 box in_corner corner", "1 box-2 on box", "1 box-3 on box-2"]),
        (
            "A table. On it, a stack of two magazines, and on the magazines a cup.",
            ["1 magazine on dining_table", "1 cup on magazine-2", "1 magazine-2 on magazine"],
        ),
        ("A crate with three vinyl records in it.", ["3 vinyl_record inside crate"]),
    ],
)
def test_a_stack_is_one_thing_on_the_other(prompt: str, lying: list[str]) -> None:
    brief = read_brief(prompt)
    assert not brief.unknown
    assert _lying(brief) == lying
    assert not any(request.states for request in brief.requests)


def test_what_does_not_stay_on_others_of_its_kind_is_only_said_to_be_stacked() -> None:
    brief = read_brief("A shelf with three chairs stacked by it.")
    assert counted(brief)["chair"] == 3


def test_all_of_a_stack_are_where_the_lowest_is() -> None:
    wanted = Annotation(
        id="stack",
        style="tiny",
        prompt="A counter with a stack of plates on it.",
        counts=(Count(quantifier="gt", number=1, category="plate"),),
        object_relations=(
            ObjectRelation(quantifier="gt", number=1, relation="on_top", anchor="counter", subjects=("plate",)),
        ),
    )
    assert all(row.met for row in judge_brief(wanted, read_brief(wanted.prompt)))
