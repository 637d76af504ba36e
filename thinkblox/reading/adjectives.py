"""What kind of adjective a word is: filler, or something that changes the thing it stands before."""

import tomllib
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import Literal, get_args

AdjectiveKind = Literal["filler", "style", "state", "pattern", "size", "age", "build"]


def adjective_kinds(word: str) -> frozenset[AdjectiveKind]:
    """Every kind that an English adjective or participle (in lower case, parts hyphenated) is of; none if unknown."""
    return _kinds().get(word, frozenset())


@lru_cache(maxsize=1)
def _kinds() -> Mapping[str, frozenset[AdjectiveKind]]:
    text = Path(__file__).with_name("lexicon").joinpath("adjectives.toml").read_text(encoding="utf-8")
    lists = tomllib.loads(text)
    kinds: dict[str, frozenset[AdjectiveKind]] = {}
    for kind in get_args(AdjectiveKind):
        for word in lists[kind].split():
            kinds[word] = kinds.get(word, frozenset()) | {kind}
    return kinds
