import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from thinkblox.phrases import SIDES, Constraint, constraints, phrase, planned_constraints
from thinkblox.scene.agreement import residual
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene
from thinkblox.steps import Step

lengths = st.integers(0, 9000).map(lambda mm: mm / 1000)
ids = st.sampled_from(["bed_1", "tv_stand_12", "any_wall_3"])
walls = st.sampled_from(["north_wall", "south_wall_2", "north_east_wall"])
phrases = st.one_of(
    st.builds(
        lambda a, s, v: Constraint(kind="beside", anchors=(a,), side=s, values=(v,)),
        ids,
        st.sampled_from(sorted(SIDES)),
        lengths,
    ),
    st.builds(lambda w: Constraint(kind="against", anchors=(w,)), walls),
    st.builds(lambda w, v: Constraint(kind="from_wall", anchors=(w,), values=(v,)), walls, lengths),
    st.builds(lambda a, b: Constraint(kind="corner", anchors=(a, b)), walls, walls),
    st.builds(lambda a: Constraint(kind="on", anchors=(a,)), ids),
    st.builds(lambda a: Constraint(kind="under", anchors=(a,)), ids),
    st.builds(lambda a: Constraint(kind="centred", anchors=(a,)), ids),
    st.builds(
        lambda a, u, v: Constraint(kind="offset", anchors=(a,), values=(u, v)), ids, lengths, lengths.map(lambda v: -v)
    ),
    st.builds(lambda a, b: Constraint(kind="between", anchors=(a, b)), ids, ids),
    st.builds(lambda a: Constraint(kind="facing", anchors=(a,)), ids | walls),
    st.builds(lambda d: Constraint(kind="turned", values=(float(d),)), st.integers(0, 359)),
    st.builds(lambda a, v: Constraint(kind="above", anchors=(a,), values=(v,)), ids | st.just("floor"), lengths),
    st.builds(lambda x, y: Constraint(kind="at", values=(x, y)), lengths, lengths),
)


@given(phrases)
def test_every_phrase_is_read_back(constraint):
    found = constraints(f"So it goes {phrase(constraint)}.")
    assert len(found) == 1
    assert found[0].values == pytest.approx(constraint.values)
    assert (found[0].kind, found[0].anchors, found[0].side) == (constraint.kind, constraint.anchors, constraint.side)


@given(st.lists(phrases, min_size=2, max_size=5))
def test_several_phrases_come_back_in_order(many):
    text = ", ".join(phrase(c) for c in many)
    assert [c.kind for c in constraints(text)] == [c.kind for c in many]


@given(st.text())
def test_any_text_can_be_searched(text):
    constraints(text)


def test_the_template_of_a_natural_sentence():
    step = Step(
        think="1. It stands 0.50 m to the left of bed_1, against the north wall, facing desk_1.",
        id="lamp_1",
        position=(0, 0, 0),
        yaw=0,
        size=(1, 1, 1),
    )
    kinds = [(c.kind, c.anchors, c.values) for c in planned_constraints(step)]
    assert kinds == [
        ("beside", ("bed_1",), (0.5,)),
        ("against", ("north_wall",), ()),
        ("facing", ("desk_1",), ()),
    ]


def box(id, position, yaw=0.0, size=(1.0, 1.0, 1.0)):
    return Placement(id=id, category="box", asset="", position=position, yaw=yaw, size=size, support="floor")


@pytest.fixture
def scene(box_asset):
    scene = Scene(room=rectangle(6.0, 4.0))
    return scene.with_placement(
        Placement(
            id="bed_1",
            category="box",
            asset=box_asset.id,
            position=(3, 2, 0),
            yaw=90,
            size=box_asset.size,
            support="floor",
        ),
        box_asset,
    )


@pytest.mark.parametrize(
    ("constraint", "placement", "expected"),
    [
        # bed_1 faces north, so its left is west.
        (Constraint(kind="beside", anchors=("bed_1",), side="left", values=(0.5,)), box("a_1", (1.5, 2, 0)), 0.0),
        (Constraint(kind="beside", anchors=("bed_1",), side="left", values=(0.5,)), box("a_1", (1.3, 2, 0)), 0.2),
        (Constraint(kind="beside", anchors=("bed_1",), side="front", values=(0.1,)), box("a_1", (3, 3.1, 0)), 0.0),
        (Constraint(kind="from_wall", anchors=("west_wall",), values=(1.0,)), box("a_1", (1.5, 2, 0)), 0.0),
        (Constraint(kind="against", anchors=("north_wall",)), box("a_1", (3, 3.48, 0)), 0.0),
        (Constraint(kind="against", anchors=("north_wall",)), box("a_1", (3, 2.4, 0)), 1.0),
        (Constraint(kind="offset", anchors=("bed_1",), values=(0.2, 0.3)), box("a_1", (2.7, 2.2, 1)), 0.0),
        (Constraint(kind="on", anchors=("bed_1",)), box("a_1", (3, 2, 1)), 0.0),
        (Constraint(kind="on", anchors=("bed_1",)), box("a_1", (3, 2, 1.25)), 0.25),
        (Constraint(kind="facing", anchors=("bed_1",)), box("a_1", (1, 2, 0), yaw=0), 0.0),
        (Constraint(kind="facing", anchors=("bed_1",)), box("a_1", (1, 2, 0), yaw=350), 10.0),
        (Constraint(kind="facing", anchors=("north_wall",)), box("a_1", (1, 2, 0), yaw=90), 0.0),
        (Constraint(kind="turned", values=(10.0,)), box("a_1", (1, 2, 0), yaw=350), 20.0),
        (Constraint(kind="above", anchors=("floor",), values=(1.5,)), box("a_1", (1, 2, 1.2)), 0.3),
        (Constraint(kind="at", values=(1.0, 2.0)), box("a_1", (1, 2.4, 0)), 0.4),
        (Constraint(kind="on", anchors=("sofa_9",)), box("a_1", (1, 2.4, 0)), None),
    ],
)
def test_residuals_say_how_far_the_answer_is_from_the_words(scene, constraint, placement, expected):
    found = residual(constraint, scene, placement)
    assert found == (None if expected is None else pytest.approx(expected, abs=1e-9))


def test_residuals_follow_a_turned_anchor(scene):
    turned = scene.moved("bed_1", yaw=45.0)
    bed = turned["bed_1"]
    x, y = bed.to_room((0.0, 0.5 + 0.3 + 0.5))
    beside = Constraint(kind="beside", anchors=("bed_1",), side="left", values=(0.3,))
    assert residual(beside, turned, box("a_1", (x, y, 0), yaw=45.0)) == pytest.approx(0.0, abs=1e-9)
    assert residual(beside, turned, box("a_1", (x, y, 0), yaw=0.0)) == pytest.approx(math.sqrt(0.5) - 0.5)
