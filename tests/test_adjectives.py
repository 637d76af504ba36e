import tomllib
from pathlib import Path
from typing import get_args

import pytest

from thinkblox.reading import adjectives
from thinkblox.reading.adjectives import AdjectiveKind, adjective_kinds

LISTS = tomllib.loads(
    Path(adjectives.__file__).with_name("lexicon").joinpath("adjectives.toml").read_text(encoding="utf-8")
)


@pytest.mark.parametrize(
    ("word", "kinds"),
    [
        ("lovely", {"filler"}),
        ("ample", {"filler"}),
        ("well-designed", {"filler"}),
        ("rolled-up", {"state"}),
        ("drawn", {"state"}),
        ("tartan", {"pattern"}),
        ("striped", {"pattern"}),
        ("clawfoot", {"build"}),
        ("victorian", {"style"}),
        ("vintage", {"style", "age"}),
        ("oversized", {"size"}),
        ("brand-new", {"age"}),
        ("chair", set()),
    ],
)
def test_the_kinds_of_an_adjective(word: str, kinds: set[str]) -> None:
    assert adjective_kinds(word) == kinds


def test_the_file_has_every_kind_and_no_word_twice_in_one() -> None:
    assert set(LISTS) == set(get_args(AdjectiveKind))
    for kind, words in LISTS.items():
        listed = words.split()
        assert len(listed) == len(set(listed)), kind
        assert all(word == word.lower() and word.replace("-", "").isalpha() for word in listed), kind
    assert sum(len(words.split()) for words in LISTS.values()) > 800
