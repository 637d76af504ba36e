"""Spoiled files of every format: none passes that must not, none ends in a traceback, none reaches outside."""

import random

import pytest

from tests.bench.mutations import main
from tests.mutants import (
    XML_NUMBER,
    mutated_json,
    mutated_xml,
    nudged_json,
    nudged_text,
    numberless_json,
    numberless_text,
)

JSON = b'{"a": [1.5, 2.5], "b": {"c": "text", "d": 3}}'
XML = '<a b="1.5 2.5"><c d="3"/></a>'


@pytest.mark.slow
def test_spoiled_files_do_no_harm(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--count", "340", "--commands", "4", "--seed", "3"]) == 0, capsys.readouterr().out


def test_what_spoils_a_text_does_so_again_with_the_same_seed() -> None:
    for seed in range(50):
        for spoil in (mutated_json, numberless_json, lambda text, rng: nudged_json(text, rng, 2)):
            assert spoil(JSON, random.Random(seed)) == spoil(JSON, random.Random(seed))
        for change in (
            lambda text, rng: numberless_text(text, XML_NUMBER, rng),
            lambda text, rng: nudged_text(text, XML_NUMBER, rng, 2),
        ):
            assert change(XML, random.Random(seed)) == change(XML, random.Random(seed)) != XML
        assert mutated_xml(XML, seed, 3) == mutated_xml(XML, seed, 3)
