"""What kind of adjective a word is: filler, or something that changes the thing it stands before."""

import tomllib
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import Literal, get_args

AdjectiveKind = Literal["filler", "style", "state", "pattern", "size", "age", "build"]

LOOKS_BY_DEGREE: Mapping[str, tuple[str, ...]] = {
    **dict.fromkeys(("big", "large", "huge"), ("large", "big", "huge", "wide", "long", "tall")),
    **dict.fromkeys(("small", "little", "tiny"), ("small", "tiny", "little", "low", "narrow", "short")),
    **dict.fromkeys(("tall", "high"), ("tall", "high")),
    **{word: (word,) for word in "long short wide narrow low old new deep shallow thick thin".split()},
}
"""What is said of the one of several that is meant by a degree: "the larger table" is the one said to be large."""
_NO_DEGREES = ("lower", "latter", "former")
"""Words that look like degrees and say which part or which of two is meant."""


def adjective_kinds(word: str) -> frozenset[AdjectiveKind]:
    """Every kind that an English adjective or participle (in lower case, parts hyphenated) is of; none if unknown."""
    return _kinds().get(word, frozenset())


def degree_of(word: str) -> str:
    """The adjective of size or age that a word in lower case is the comparative or superlative of, or nothing."""
    for ending in ("er", "est"):
        stem = word.removesuffix(ending)
        if stem == word or word in _NO_DEGREES:
            continue
        forms = (
            stem,
            f"{stem}e",
            f"{stem[:-1]}y" if stem.endswith("i") else "",
            stem[:-1] if stem[-2:-1] == stem[-1:] else "",
        )
        found = next((form for form in forms if form and {"size", "age"} & adjective_kinds(form)), "")
        if found:
            return found
    return ""


@lru_cache(maxsize=1)
def _kinds() -> Mapping[str, frozenset[AdjectiveKind]]:
    text = Path(__file__).with_name("lexicon").joinpath("adjectives.toml").read_text(encoding="utf-8")
    lists = tomllib.loads(text)
    kinds: dict[str, frozenset[AdjectiveKind]] = {}
    for kind in get_args(AdjectiveKind):
        for word in lists[kind].split():
            kinds[word] = kinds.get(word, frozenset()) | {kind}
    return kinds
