"""What is spelt alike is found as `difflib` finds it, whatever is left out beforehand."""

import difflib

import pytest

from thinkblox.assets.names import known_phrases
from thinkblox.assets.spelling import Spelling


@pytest.mark.parametrize("phrase", ["wardrob", "wooden rocking hors", "espresso machine", "théière", "xylem", "aa", ""])
def test_it_finds_what_a_comparison_with_each_finds(phrase: str) -> None:
    known = sorted(known_phrases())
    assert Spelling(known).close(phrase, 8) == difflib.get_close_matches(phrase, known, n=8, cutoff=0.75)


def test_nothing_is_like_anything_where_there_is_nothing() -> None:
    assert Spelling(()).close("chair", 3) == []
