"""Plain stand-ins for whatever has no entry anywhere: a category for any noun phrase, the same in every process."""

import difflib
import re
import tomllib
import unicodedata
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Literal

from thinkblox.assets.catalogue import CATALOGUE, GENERAL_WORDS, revision
from thinkblox.assets.category import Category
from thinkblox.assets.facts import Facts
from thinkblox.assets.names import ThingName, identifier_of, known_phrases, name_of, thing_called
from thinkblox.assets.plain import plain_generator
from thinkblox.assets.plain.places import KEEPING

_MOST_WORDS, _MOST_LETTERS = 6, 60
_NAMELESS = "thing"
"""What is called by no letter at all."""
_CLOSE = 0.85
"""Share of its letters in order that a name has in common with another, to be taken for another spelling of it."""
_SHORTEST, _MORE = 5, 2
"""Letters that such a name has at least, and how many more or fewer the other may have."""
_LASTS = (
    "book", "box", "table", "chair", "lamp", "bag", "bench", "shelf", "tray", "desk", "pot", "bottle", "basket", "bowl",
    "clock", "card", "brush", "cabinet", "stool", "sofa", "bucket", "case", "glass", "knife",
)  # fmt: skip
"""Second words of names that are written as one word and in no list."""
_FIRST = 3
"""Fewest letters of the word before."""
_SURE, _UNSURE = 0.9, 0.5
"""How sure an unknown modifier leaves us of a head that is a thing by itself, and of one that is none."""
_FINISHES = "oak grey white navy beige brown walnut steel red green".split()
_MIDDLING = (0.3, 0.35, 0.35)
_MIDDLING_MASS = 4.0
_PLACED = {"wall": "wall", "hanging": "ceiling", "ceiling": "ceiling", "floor": "floor", "standing": "floor"}
"""Modifiers that say where an unknown thing is, and the keeping that they mean."""

Finding = Literal["catalogue", "table", "head", "spelling", "plain"]


@dataclass(frozen=True, kw_only=True)
class StandIn:
    """What stands for a noun phrase.

    Attributes:
        category: with the noun phrase for a name; one of the catalogue's own where it has that name already.
        how: by an entry of its own ("catalogue" with a shape, "table" without), by its head noun, by a name that is
            spelled almost the same, or by nothing: a plain box of a middling size.
        like: the category whose size, mass and mount it has; empty for "plain".
        similarity: how sure that is, 0 to 1.
    """

    category: Category
    how: Finding
    like: str
    similarity: float


def stand_in(name: str) -> StandIn:
    """What stands for a noun phrase, whatever it is: the same for the same phrase and catalogue."""
    return _stand_in(noun_of(name), revision())


def kind_of(name: str) -> Category:
    """The category called `name`, or what stands for it."""
    return CATALOGUE[name] if name in CATALOGUE else stand_in(name).category


def facts_of(name: str) -> Facts:
    """What is known of a category, a general word, or of what stands for a name that the catalogue does not have."""
    return GENERAL_WORDS[name] if name in GENERAL_WORDS else kind_of(name)


def noun_of(name: str) -> str:
    """The noun phrase that a name means: letters and digits in lower case, of bounded length, never empty."""
    letters = unicodedata.normalize("NFKD", name[: 4 * _MOST_LETTERS]).encode("ascii", "ignore").decode().lower()
    words = re.sub(r"[^a-z0-9]+", " ", letters.replace("'", "")).split()
    return " ".join(words[-_MOST_WORDS:])[:_MOST_LETTERS].strip() or _NAMELESS


@lru_cache(maxsize=512)
def _stand_in(noun: str, revision: int) -> StandIn:
    name = identifier_of(noun)
    if name in CATALOGUE:
        return StandIn(
            category=CATALOGUE[name], how="table" if CATALOGUE[name].plain else "catalogue", like=name, similarity=1.0
        )
    how, like, similarity = _nearest(noun)
    if how == "plain":
        return StandIn(category=_plain(name, noun), how=how, like="", similarity=0.0)
    made = replace(CATALOGUE[like], name=name, noun=noun, words=noun, senses=(), rooms={}, variants={}, plain=True)
    return StandIn(category=made, how=how, like=like, similarity=similarity)


def _nearest(noun: str) -> tuple[Finding, str, float]:
    """How a noun phrase was found, the category that it is like, and how sure that is."""
    words = noun.split()
    body = words[: words.index("of")] if "of" in words[1:] else words
    found = name_of(words) if len(body) == len(words) else thing_called(noun, len(words)) or name_of(body)
    if found is not None and (category := _thing(found)):
        whole = found.length == len(words)
        return _entry(category) if whole else "head", category, 1.0 if whole else _SURE
    if head := thing_called(_heads().get(body[-1], "")) or _joined(body[-1]):
        return "head", _thing(head), _UNSURE
    close, similarity = _spelled_like(noun)
    return ("spelling", close, similarity) if close else ("plain", "", 0.0)


def _joined(word: str) -> ThingName | None:
    """What the last of two words that are written as one names: a "rulebook" is a book."""
    last = next((last for last in _LASTS if word.endswith(last) and len(word) >= len(last) + _FIRST), "")
    return thing_called(last) if last else None


def _spelled_like(noun: str) -> tuple[str, float]:
    """The category with a name that is spelled almost like a noun phrase, and the share of letters in common."""
    if len(noun) < _SHORTEST:
        return "", 0.0
    near = [phrase for phrase in known_phrases() if phrase[0] == noun[0] and abs(len(phrase) - len(noun)) <= _MORE]
    close = difflib.get_close_matches(noun, near, n=1, cutoff=_CLOSE)
    found = thing_called(close[0]) if close else None
    return (_thing(found), round(difflib.SequenceMatcher(None, noun, close[0]).ratio(), 2)) if found else ("", 0.0)


def _entry(category: str) -> Finding:
    return "table" if CATALOGUE[category].plain else "catalogue"


def _thing(found: ThingName) -> str:
    """The category that a name means by itself; empty for a general word that says too little, such as "stand"."""
    if found.category in CATALOGUE:
        return found.category
    word = found.category.removeprefix("any_")
    return "" if word in _heads() and found.length == 1 else GENERAL_WORDS[found.category].senses[-1].partition(" ")[0]


@lru_cache(maxsize=1)
def _heads() -> Mapping[str, str]:
    text = Path(__file__).with_name("plain").joinpath("heads.toml").read_text(encoding="utf-8")
    heads: Mapping[str, str] = tomllib.loads(text)
    return heads


def _plain(name: str, noun: str) -> Category:
    """A box of a middling size, in a finish that its name decides."""
    place = next((_PLACED[word] for word in noun.split() if word in _PLACED), "shelf")
    kept = KEEPING[place]
    finish = _FINISHES[zlib.crc32(noun.encode()) % len(_FINISHES)]
    flat = place == "wall"
    return Category(
        name=name,
        noun=noun,
        generator=plain_generator("board" if flat else "pendant" if place == "ceiling" else "block", finish, "paper"),
        size=(0.06, 0.5, 0.5) if flat else _MIDDLING,
        mass=_MIDDLING_MASS,
        mount=kept.mount,
        front="one",
        low=0.1,
        high=5.0,
        variation=0.04,
        plain=True,
        words=noun,
        groups=kept.groups,
        habits=(*kept.habits, "in_corner corner") if kept.mount == "surface" else kept.habits,
        hanging=kept.hanging,
        forms={} if flat or place == "ceiling" else {"holds": "open"},
    )
