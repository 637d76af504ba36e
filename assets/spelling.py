"""Which of many phrases are spelt much like another one."""

import difflib
from collections.abc import Iterable

import numpy as np

_CLOSE = 0.75
"""Least ratio of `difflib.SequenceMatcher` of what is spelt alike."""
_CODES = 128
"""Characters that are counted by themselves; all others count as one."""


class Spelling:
    """The phrases to choose from, with the letters of each counted once."""

    def __init__(self, phrases: Iterable[str]) -> None:
        self._phrases = list(dict.fromkeys(phrases))
        counts = np.zeros((len(self._phrases), _CODES), np.int16)
        for row, phrase in zip(counts, self._phrases, strict=True):
            row += _letters(phrase)
        self._used = np.flatnonzero(counts.any(axis=0))
        self._counts = np.ascontiguousarray(counts[:, self._used])
        self._lengths = np.array([len(phrase) for phrase in self._phrases], np.int64)

    def close(self, phrase: str, most: int) -> list[str]:
        """At most so many phrases that are spelt much like this one, the closest first."""
        shared = np.minimum(self._counts, _letters(phrase)[self._used]).sum(axis=1)
        # No order of the letters matches more of them than both have: what falls short here need not be compared.
        near = np.flatnonzero(2 * shared >= _CLOSE * (self._lengths + len(phrase)))
        return difflib.get_close_matches(phrase, [self._phrases[k] for k in near], n=most, cutoff=_CLOSE)


def _letters(phrase: str) -> np.ndarray:
    """How often each character stands in a phrase."""
    codes = np.minimum(np.frombuffer(phrase.encode("utf-32-le"), np.uint32), _CODES - 1)
    return np.bincount(codes, minlength=_CODES).astype(np.int16)
