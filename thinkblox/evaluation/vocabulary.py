"""Whether an object of some name is what a demanded name means, by tables of the judge's own."""

import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property
from importlib.resources import files

_TABLE = "vocabulary.toml"
_MOST_STEPS = 16
_GROUPS = frozenset(
    "pair pairs set sets stack stacks pile piles bunch bunches row rows group groups couple piece pieces lot lots load "
    "loads heap heaps plenty dozen dozens".split()
)
_LINKS = frozenset("with in for".split())
_ARTICLES = frozenset("a an the some".split())
_IRREGULAR = {
    "shelves": "shelf",
    "knives": "knife",
    "loaves": "loaf",
    "mice": "mouse",
    "cacti": "cactus",
    "people": "person",
    "scarves": "scarf",
    "leaves": "leaf",
    "halves": "half",
    "feet": "foot",
    "torches": "torch",
}
_SAME_AS_PLURAL = frozenset("chess glass gas bus canvas compass dress mattress cactus iris cosmos atlas".split())


@cache
def plain(name: str) -> str:
    """A name in lower case and the singular, words between single spaces, without an article."""
    words = re.sub(r"[^a-z0-9]+", " ", name.lower()).split()
    while words and words[0] in _ARTICLES:
        words.pop(0)
    return " ".join([*words[:-1], _singular(words[-1])]) if words else ""


def _singular(word: str) -> str:
    if word in _IRREGULAR:
        return _IRREGULAR[word]
    if len(word) < 4 or word in _SAME_AS_PLURAL or word.endswith(("ss", "us", "is")):
        return word
    if word.endswith(("ches", "shes", "sses", "xes")):
        return word[:-2]
    if word.endswith("ies"):
        return f"{word[:-3]}y"
    return word[:-1] if word.endswith("s") else word


@dataclass(frozen=True)
class Vocabulary:
    """Names that mean the same, kinds of things, and names that are easily taken for one another."""

    same: dict[str, str]
    kinds: dict[str, frozenset[str]]
    alike: dict[str, frozenset[str]]
    apart: dict[str, frozenset[str]]

    def steps(self, name: str, demanded: str) -> int | None:
        """How many kinds up from `name` what is `demanded` lies: 0 for the thing itself, None for something else.

        An office chair is one step below a chair; a chair is not an office chair.
        """
        goal = self.canonical(demanded)
        seen, level = {self.canonical(name)}, {self.canonical(name)}
        for step in range(_MOST_STEPS):
            if goal in level:
                return step
            level = {parent for one in level for parent in self._parents(one)} - seen
            if not level:
                return None
            seen |= level
        return None

    def is_alike(self, name: str, demanded: str) -> bool:
        """Whether a person may take the one for the other."""
        return self.canonical(demanded) in self.alike.get(self.canonical(name), frozenset())

    def canonical(self, name: str) -> str:
        """The word by which the tables know a name."""
        return self.same.get(plain(name), plain(name))

    def knows(self, name: str) -> bool:
        """Whether the tables have a word for it."""
        return self.canonical(name) in self._words

    @cached_property
    def _words(self) -> frozenset[str]:
        return frozenset(self.same.values()) | frozenset(self.kinds) | frozenset().union(*self.kinds.values())

    def _parents(self, name: str) -> Iterator[str]:
        not_these = self.apart.get(name, frozenset())
        yield from (self.canonical(general) for general in self._above.get(name, ()))
        head, of, rest = name.partition(" of ")
        if of and head.split()[-1] not in _GROUPS:
            yield self.canonical(f"{plain(rest)} {head}")
        words = name.split(" ")
        plainer = (" ".join([*words[:at], *words[at + 1 :]]) for at in range(1, len(words) - 1))
        yield from (self.canonical(less) for less in plainer if not of and not _LINKS.intersection(words))
        general = _shorter(name)
        if general and general not in not_these and self.canonical(general) not in not_these:
            yield self.canonical(general)

    @cached_property
    def _above(self) -> dict[str, tuple[str, ...]]:
        above: dict[str, list[str]] = {}
        for general, special in self.kinds.items():
            for name in special:
                above.setdefault(name, []).append(general)
        return {name: tuple(sorted(generals)) for name, generals in above.items()}


def _shorter(name: str) -> str:
    """A name that says less: a "bowl of apples" is a bowl, a "pair of boots" boots, a "round dining table" a table."""
    head, of, rest = name.partition(" of ")
    if of and head.split()[-1] in _GROUPS:
        return plain(rest)
    for link in (" of ", " with ", " in ", " for "):
        if link in name:
            return plain(name.split(link)[0])
    return name.partition(" ")[2]


@cache
def load_vocabulary() -> Vocabulary:
    """The tables of the judge."""
    table = tomllib.loads(files("thinkblox.evaluation").joinpath(_TABLE).read_text("utf-8"))
    same = {plain(word): plain(name) for name, words in table["same"].items() for word in (name, *words)}

    def known(word: str) -> str:
        return same.get(plain(word), plain(word))

    alike: dict[str, set[str]] = {}
    for group in table["alike"]["groups"]:
        for word in group:
            alike.setdefault(known(word), set()).update(known(other) for other in group if other != word)
    return Vocabulary(
        same=same,
        kinds={known(general): frozenset(map(known, words)) for general, words in table["kinds"].items()},
        alike={word: frozenset(others) for word, others in alike.items()},
        apart={known(name): frozenset(map(plain, words)) for name, words in table["apart"].items()},
    )
