import pytest

from tests.judged_rooms import demands
from thinkblox.brief import Brief, Relation, Request
from thinkblox.evaluation.annotations import RoomDemand
from thinkblox.evaluation.brief_judge import judge_brief


def asked(category, count=1, phrase=""):
    return Request(key=category, category=category, count=count, phrase=phrase)


def stands(kind, subject, *anchors, each=False):
    return Relation(kind=kind, subject=subject, anchors=anchors, each=each)


BRIEF = Brief(
    prompt="",
    room_type="bedroom",
    width=4.0,
    depth=5.0,
    requests=(
        asked("bed", phrase="a double bed"),
        asked("nightstand", 2),
        asked("table_lamp", 2),
        asked("mirror"),
        asked("desk"),
        asked("armchair", phrase="a recliner"),
    ),
    relations=(
        stands("next_to", "nightstand", "bed"),
        stands("on", "table_lamp", "nightstand", each=True),
        stands("against_wall", "bed", "wall"),
        stands("near", "desk", "window"),
        stands("under", "desk", "mirror"),
    ),
    missing=("a hoverboard",),
)


@pytest.mark.parametrize(
    ("row", "met"),
    [
        (["eq", 2, "next_to", 0, "bed", "nightstand"], True),
        (["eq", 2, "next_to", 1, "nightstand", "bed"], True),
        (["eq", 3, "next_to", 0, "bed", "nightstand"], False),
        (["eq", 2, "on_top", 0, "nightstand", "lamp"], True),
        (["eq", 2, "on_top", 0, "lamp", "nightstand"], False),
        (["eq", 1, "above", 0, "desk", "mirror"], True),
        (["eq", 1, "under", 0, "desk", "mirror"], False),
        (["eq", 0, "next_to", 0, "bed", "desk"], True),
        (["eq", 0, "next_to", 0, "bed", "nightstand"], False),
        (["eq", 1, "next_to", 0, "bed", "hoverboard"], False),
    ],
)
def test_relations_between_objects(row, met):
    (judged,) = judge_brief(demands(objects=[row]), BRIEF)
    assert judged.met is met, judged.says


@pytest.mark.parametrize(
    ("row", "met"),
    [
        (["eq", 1, "against_wall", "bed", "wall"], True),
        (["eq", 1, "against_wall", "desk", "wall"], False),
        (["eq", 1, "near", "desk", "window"], True),
        (["eq", 1, "near", "desk", "door"], False),
        (["eq", 1, "on_wall", "mirror", "wall"], True),
        (["eq", 0, "corner_room", "bed", "room"], True),
        (["eq", 0, "against_wall", "bed", "wall"], False),
    ],
)
def test_relations_to_parts_of_the_room(row, met):
    """What hangs by its nature, such as a mirror, needs no relation to say so."""
    (judged,) = judge_brief(demands(elements=[row]), BRIEF)
    assert judged.met is met, judged.says


def test_counts_and_absences():
    rows = [["eq", 2, "nightstand"], ["eq", 1, "nightstand"], ["ge", 1, "recliner"], ["eq", 1, "hoverboard"]]
    judged = judge_brief(demands(counts=rows, absent=["rug", "desk"]), BRIEF)
    assert [row.met for row in judged] == [True, False, True, False, True, False]
    assert "missing has 'a hoverboard'" in judged[3].says
    assert [row.extra for row in judged[:2]] == [0, 1]


def test_the_room():
    demand = RoomDemand(kind="guest bedroom", size=(5.0, 4.0), shape="L")
    judged = judge_brief(demands(room=demand), BRIEF)
    assert [(row.about, row.met) for row in judged] == [("kind", True), ("size", True), ("shape", False)]
