"""Prompts that cannot be used are refused with a reason; anything else gives a brief, and soon."""

import contextlib
import time

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from thinkblox.brief import Brief
from thinkblox.errors import InputError
from thinkblox.reading import read_brief
from thinkblox.value import from_json, to_json

WORDS = (
    "a an the two five each it its them with on between facing and , . ; : no nothing but only for six people "
    "bed sofa table lamp desk chairs window corner wall rows of in by 4 m x 5 0 -3 nan km bedroom kitchen "
    "hoverboard full opposite side foot middle room square metres against around under above next to every all "
    "L-shaped ein Bett mit une lampe"
).split()


@pytest.mark.parametrize(
    ("prompt", "says"),
    [
        ("", "empty"),
        (" \n\t ", "empty"),
        ("x" * 20_001, "20001 characters"),
        ("リビングルームにソファとテレビ", "English, German, French, Spanish"),
        ("Небольшая спальня с кроватью", "English"),
        ("12345", "no words"),
        ("🛋🛏", "no words"),
        ("a room of 1 km", "1 km"),
        ("a bedroom 0 m by 5 m", "0 m by 5 m"),
        ("a room -3 m x 4 m", "-3 m x 4 m"),
        ("a room of NaN m by 3 m", "NaN m by 3 m"),
        ("a room of inf m by 3 m", "inf m by 3 m"),
        ("a bedroom of 0 square metres", "0 square metres"),
        ("a bedroom of 1000000 m2", "1000000 m2"),
    ],
)
def test_unusable_prompts_are_refused_with_a_reason(prompt: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        read_brief(prompt)


@settings(max_examples=300, deadline=None)
@given(st.text(max_size=200))
@example("W\u0fac")
@example("A bed \u0fac and a sofa \u0fac")
def test_any_text_gives_a_brief_or_an_input_error(text: str) -> None:
    with contextlib.suppress(InputError):
        assert isinstance(read_brief(text), Brief)


def test_shares_of_shares_without_end_are_read() -> None:
    assert isinstance(read_brief("each with two chairs " * 900), Brief)


@settings(max_examples=300, deadline=None)
@given(st.lists(st.sampled_from(WORDS), max_size=40).map(" ".join))
@example("each with each other between them on it")
@example("on on on the the each bed of of bed")
@example("a bed facing itself and each other on it under it")
def test_any_words_give_a_sound_brief(text: str) -> None:
    try:
        brief = read_brief(text)
    except InputError:
        return
    keys = [request.key for request in brief.requests]
    assert len(set(keys)) == len(keys)
    assert sum(request.count for request in brief.requests) <= 400
    assert all(relation.subject in keys for relation in brief.relations)
    assert from_json(to_json(brief), Brief) == brief


@pytest.mark.parametrize(
    "unit",
    [
        "each ",
        "it ",
        "4 m x ",
        *(
            pytest.param(unit, marks=pytest.mark.slow)
            for unit in ("a bed, ", "a chair on a table on ", "a ", "very ", "with ", "((((", "no ", "aaaa", "foo ")
        ),
    ],
)
def test_long_prompts_do_not_hang(unit: str) -> None:
    text = ("a bedroom " + unit * 20_000)[:20_000]
    start = time.process_time()
    with contextlib.suppress(InputError):
        read_brief(text)
    assert time.process_time() - start < 20.0, "seconds of a processor, whatever else the machine does"


def test_what_has_its_like_in_the_middle_is_read() -> None:
    assert read_brief("chairs with middle chairs").requests
