"""The words that hold English sentences together, from grammar.toml, where "{denying} want" is any word of a list."""

import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, lru_cache
from itertools import chain, product
from pathlib import Path
from typing import NamedTuple

from thinkblox.reading.tokens import Token, texts

_JOINED = (("each other", "eachother"), ("in between", "inbetween"))
"""Words that many write as one."""


class Function(NamedTuple):
    """What a phrase does in a sentence: `sort` is a section of grammar.toml, `value` a key of it."""

    sort: str
    value: str
    length: int


@dataclass(frozen=True)
class Grammar:
    """The words of grammar.toml.

    Attributes:
        phrases: every phrase as a tuple of words, with all that it can be.
        prefixes: what phrases begin with.
        lists: words that are asked for by name, by the key of their list.
        sorts: what phrases can be.
        begun: what phrases that begin with a word can be.
    """

    phrases: dict[tuple[str, ...], list[tuple[str, str]]] = field(default_factory=dict)
    prefixes: set[tuple[str, ...]] = field(default_factory=set)
    lists: dict[str, frozenset[str]] = field(default_factory=dict)
    sorts: set[str] = field(default_factory=set)
    begun: dict[str, set[str]] = field(default_factory=dict)

    def people(self, words: Iterable[str]) -> int:
        """How many people a word among these says by itself ("twins"); 0 where none does."""
        said = (value for word in words for sort, value in self.phrases.get((word,), ()) if sort == "born")
        return int(next(said, 0))

    def at(self, tokens: Sequence[Token], start: int, *sorts: str) -> Function | None:
        """The longest phrase of one of these sorts that begins at `start`; figures are a count as number words are."""
        # No word of a prompt is asked for less than a dozen times, nearly always in vain.
        begun = self.begun.get(tokens[start].text) if start < len(tokens) else None
        if begun is None or begun.isdisjoint(sorts):
            figures = start < len(tokens) and tokens[start].kind == "number" and "count" in sorts
            return Function("count", tokens[start].text, 1) if figures else None
        longest: Function | None = None
        key: tuple[str, ...] = ()
        for index in range(start, len(tokens)):
            key = (*key, tokens[index].text)
            for sort, value in self.phrases.get(key, ()):
                if sort in sorts:
                    longest = Function(sort, value, len(key))
                    break
            if key not in self.prefixes:
                break
        return longest

    def knows(self, word: str, *sorts: str) -> bool:
        """Whether a single folded word can be of one of these sorts."""
        return any(sort in sorts for sort, _ in self.phrases.get((word,), ()))

    def begins(self, word: str, *sorts: str) -> bool:
        """Whether phrases of one of these sorts begin with a word."""
        return word in self.begun and not self.begun[word].isdisjoint(sorts)

    def all_at(self, tokens: Sequence[Token], start: int, *sorts: str) -> list[Function]:
        """Everything of these sorts that begins at `start`, the longest first."""
        found: list[Function] = []
        begun = self.begun.get(tokens[start].text) if start < len(tokens) else None
        if begun is None or begun.isdisjoint(sorts):
            return found
        key: tuple[str, ...] = ()
        for index in range(start, len(tokens)):
            key = (*key, tokens[index].text)
            for sort, value in self.phrases.get(key, ()):
                if sort in sorts:
                    found.append(Function(sort, value, len(key)))
            if key not in self.prefixes:
                break
        return sorted(found, key=lambda function: -function.length) if len(found) > 1 else found


def is_count(tokens: Sequence[Token], at: int) -> bool:
    """Whether a number of things is said there, in figures or in words."""
    return at < len(tokens) and (tokens[at].kind == "number" or grammar().at(tokens, at, "count") is not None)


@lru_cache(maxsize=1)
def grammar() -> Grammar:
    """The grammar words, read once."""
    data = tomllib.loads((Path(__file__).parent / "grammar.toml").read_text(encoding="utf-8"))
    made = Grammar(lists={name: frozenset(_split(words)) for name, words in data.pop("lists").items()})

    @cache
    def meant(word: str) -> list[tuple[str, ...]]:
        if not word.startswith("{"):
            return [texts(word)]
        return [key for said in sorted(made.lists[word[1:-1]]) for key in spelt(said)]

    def spelt(phrase: str) -> Iterator[tuple[str, ...]]:
        return (tuple(chain.from_iterable(parts)) for parts in product(*map(meant, phrase.split())))

    for sort, value, phrase in _phrases(data):
        for key in spelt(phrase):
            _add(made, sort, value, key)
    return made


def _add(made: Grammar, sort: str, value: str, key: tuple[str, ...]) -> None:
    made.sorts.add(sort)
    made.begun.setdefault(key[0], set()).add(sort)
    made.phrases.setdefault(key, []).append((sort, value))
    for end in range(len(key) - 1, 0, -1):
        if key[:end] in made.prefixes:
            return
        made.prefixes.add(key[:end])


def _phrases(data: Mapping[str, Mapping[str, str]]) -> Iterator[tuple[str, str, str]]:
    for sort, section in data.items():
        for value, phrases in section.items():
            for phrase in _split(phrases):
                if sort == "numbers":
                    number, _, words = phrase.partition(" ")
                    yield value, number, words
                else:
                    yield sort, value, phrase


def _split(phrases: str) -> Iterator[str]:
    """The phrases of a list, those with two words that many write as one in both ways."""
    for phrase in (phrase.strip() for phrase in phrases.split(",")):
        yield phrase
        for apart, joined in _JOINED:
            if apart in phrase:
                yield phrase.replace(apart, joined)
