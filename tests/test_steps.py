import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.bench.texts import outcomes
from thinkblox.steps import MAX_TEXT, Rejection, Step, parse, write_step

GOOD = '<think>1. Here.</think><answer>{"id": "bed_1", "position": [1, 2, 0], "yaw": 90, "size": [2, 1.6, 1]}</answer>'


def test_a_good_text_becomes_a_step():
    step = parse(GOOD)
    assert step == Step(think="1. Here.", id="bed_1", position=(1, 2, 0), yaw=90, size=(2, 1.6, 1))


def test_white_space_around_the_tags_is_fine():
    spaced = GOOD.replace("</think>", "</think>\n\n")
    assert isinstance(parse(f"\n {spaced} \n"), Step)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "format"),
        ("put the bed there", "format"),
        (GOOD + GOOD, "format"),
        (GOOD + " and that is all", "format"),
        (GOOD.replace("<think>1. Here.</think>", ""), "format"),
        (GOOD.replace("</answer>", ""), "format"),
        ("<think><think></think></think><answer>{}</answer>", "format"),
        ("x" * (MAX_TEXT + 1), "format"),
        (GOOD.replace('{"id"', '{id"'), "json"),
        (GOOD.replace("}</answer>", "} {}</answer>"), "json"),
        (GOOD.replace("90", "NaN"), "json"),
        (GOOD.replace("[1, 2, 0]", "[1, 2, Infinity]"), "json"),
        (f"<think></think><answer>{'[' * 9000}</answer>", "fields"),
        (GOOD.replace('"bed_1"', "7"), "fields"),
        (GOOD.replace('"bed_1"', '"Bed one"'), "fields"),
        (GOOD.replace("[1, 2, 0]", "[1, 2]"), "fields"),
        (GOOD.replace("[1, 2, 0]", '["1", 2, 0]'), "fields"),
        (GOOD.replace("[1, 2, 0]", "[1e9, 2, 0]"), "fields"),
        (GOOD.replace("[2, 1.6, 1]", "[2, 0, 1]"), "fields"),
        (GOOD.replace("[2, 1.6, 1]", "[2, -1.6, 1]"), "fields"),
        (GOOD.replace('"yaw"', '"rotation"'), "fields"),
        (GOOD.replace('"yaw": 90', '"yaw": 90, "colour": "red"'), "fields"),
        ("<think></think><answer>[1, 2]</answer>", "fields"),
        ("<think></think><answer>__import__('os').system('true')</answer>", "json"),
    ],
)
def test_everything_else_is_a_rejection_with_its_reason(text, reason):
    result = parse(text)
    assert isinstance(result, Rejection)
    assert result.reason == reason
    assert result.message


@given(st.text())
def test_parse_never_raises_on_any_text(text):
    assert isinstance(parse(text), Step | Rejection)


@given(st.text(), st.text())
def test_parse_never_raises_inside_the_tags(think, answer):
    assert isinstance(parse(f"<think>{think}</think><answer>{answer}</answer>"), Step | Rejection)


@given(
    st.tuples(*[st.floats(-100, 100)] * 3),
    st.floats(-720, 720),
    st.tuples(*[st.floats(0.001, 50)] * 3),
)
def test_what_is_written_is_read_back(position, yaw, size):
    step = parse(write_step(["It stands there."], id="chair_12", position=position, yaw=yaw, size=size))
    assert isinstance(step, Step)
    assert step.position == pytest.approx(position, abs=1e-4)
    assert abs((step.yaw - yaw + 180) % 360 - 180) <= 0.006
    assert step.size == pytest.approx(size, abs=1e-4)


def test_generated_texts_are_steps_or_rejections_with_a_reason():
    assert sum(outcomes(1500, seed=1).values()) == 1500
