"""The words of instructions, read from grammar.toml."""

import tomllib
from collections.abc import Mapping, Sequence
from functools import lru_cache
from pathlib import Path

from thinkblox.reading.tokens import Token, texts

Phrases = Mapping[tuple[str, ...], str]
"""What each phrase means, by its folded words."""


@lru_cache(maxsize=1)
def sections() -> Mapping[str, Phrases]:
    """Every section of grammar.toml: its phrases as tuples of words, with the key that each stands for."""
    data = tomllib.loads((Path(__file__).parent / "grammar.toml").read_text(encoding="utf-8"))
    return {name: _phrases(section) for name, section in data.items()}


def _phrases(section: Mapping[str, str]) -> Phrases:
    return {texts(phrase): key for key, phrases in section.items() for phrase in phrases.split(",")}


def longest(section: str, tokens: Sequence[Token], start: int) -> tuple[str, int] | None:
    """The key and length [tokens] of the longest phrase of a section that begins at `start`; None when none does."""
    phrases = sections()[section]
    words = tuple(token.text for token in tokens[start : start + _longest(section)])
    for length in range(len(words), 0, -1):
        if (key := phrases.get(words[:length])) is not None:
            return key, length
    return None


@lru_cache(maxsize=64)
def _longest(section: str) -> int:
    return max(map(len, sections()[section]), default=0)


def means(section: str, word: str) -> str:
    """What a single folded word means in a section; empty when nothing."""
    return sections()[section].get((word,), "")


def is_filler(text: str) -> bool:
    """Whether a phrase asks for nothing."""
    return texts(text) in sections()["fillers"]


def verbs() -> tuple[str, ...]:
    """The verbs that an instruction can begin with, one for each thing that can be done."""
    first: dict[str, str] = {}
    for words, key in sections()["verbs"].items():
        if key in ("unwanted", "seat", "gather", "spread", "copy"):
            continue
        first.setdefault(key, " ".join(words))
    return tuple(first.values())


def whose(text: str) -> str:
    """Of whom a thing is said to be, as it is written: "teacher's" of "the teacher's desk"; empty where nobody's."""
    return next((word for word in text.lower().replace("’", "'").split() if word.endswith(("'s", "s'"))), "")


def rank_of(key: str) -> tuple[int, str]:
    """Which of several a key of the section "sizes" means: 1 the largest, and by what it is; 0 for none."""
    rank, _, along = key.partition(" ")
    return (int(rank), along) if rank in ("1", "-1") else (0, "")
