"""Words that are one slip of the pen away from a word that we know: "bedrom", "aroudn"."""

from collections.abc import Iterator
from functools import lru_cache

from thinkblox.knowledge.vocabulary import is_abstract, is_person, thing_called
from thinkblox.reading.adjectives import adjective_kinds
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.lexicon import Lexicon, load

_LEAST = 5
"""Fewest letters of a word with a slip, and of the word that was meant."""
_INFLECTED = ("s", "ed", "er", "y", "ing")
"""Endings of words that may be a form of another word rather than one with a slip."""
_LINKS = ("around", "beside", "under", "between", "against", "behind", "opposite", "facing", "above")
"""Words besides those of the lexicon that may be meant."""


def meant_by(lexicon: Lexicon, word: str, also: frozenset[str] = frozenset()) -> str:
    """The one word that was meant by a word that nothing knows; "" where it is none or could be several.

    Args:
        lexicon: of the language.
        word: folded.
        also: other words that may be meant; of short ones two letters may be swapped.
    """
    if (2 < len(word) < _LEAST and word.isascii() and word.isalpha()) and not _is_word(lexicon, word):
        swapped = {word[:n] + word[n + 1] + word[n] + word[n + 2 :] for n in range(len(word) - 1)} & also
        swapped |= {
            doubled for doubled in _doubled(word) if len(word) + 1 == _LEAST and doubled in _words(lexicon.code)
        }
        return swapped.pop() if len(swapped) == 1 else ""
    if (
        len(word) < _LEAST
        or not word.isascii()
        or not word.isalpha()
        or word.endswith(_INFLECTED)
        or _is_word(lexicon, word)
    ):
        return ""
    known = _words(lexicon.code) | {other for other in also if len(other) >= _LEAST}
    found = {other for other in _slips(word) if other in known and not word.startswith(other)}
    return found.pop() if len(found) == 1 else ""


def _is_word(lexicon: Lexicon, word: str) -> bool:
    if word in _all_words(lexicon.code) or is_abstract(word) or is_person(word):
        return True
    return thing_called(word, 1) is not None or bool(adjective_kinds(word))


@lru_cache(maxsize=1)
def _all_words(code: str) -> frozenset[str]:
    """Every word of the lexicon and the grammar."""
    phrases = (*load(code).phrases, *grammar().phrases)
    return frozenset(word for phrase in phrases for word in phrase) | frozenset().union(*grammar().lists.values())


@lru_cache(maxsize=1)
def _words(code: str) -> frozenset[str]:
    """What may be meant: things, rooms, looks, and where something stands."""
    sorts = ("object", "room", "attribute")
    phrases = load(code).phrases.items()
    single = (key[0] for key, entries in phrases if len(key) == 1 and any(e.sort in sorts for e in entries))
    return frozenset(word for word in (*single, *_LINKS) if len(word) >= _LEAST)


def _doubled(word: str) -> Iterator[str]:
    """The word with one of its letters twice: "smal" is "small"."""
    return (word[:at] + word[at] + word[at:] for at in range(1, len(word)))


def _slips(word: str) -> Iterator[str]:
    """Every word that begins alike and of which this one lacks, doubles, mistakes or swaps a letter."""
    letters = "abcdefghijklmnopqrstuvwxyz"
    for at in range(1, len(word) + 1):
        head, tail = word[:at], word[at:]
        yield from (head + letter + tail for letter in letters)
        if tail:
            yield head + tail[1:]
        if len(tail) > 1:
            yield head + tail[1] + tail[0] + tail[2:]
