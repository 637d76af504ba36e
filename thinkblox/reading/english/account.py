"""What became of every word of a text: asked for, related, a constraint, style, filler, or not understood."""

import re
from collections.abc import Sequence
from unicodedata import normalize

from msgspec import structs

from thinkblox.brief import Fate, Word
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Measured, Noun, NounKind, SaidSurface, Stray
from thinkblox.reading.tokens import Token

_LINKS: dict[str, Fate] = {
    "prepositions": "related",
    "inverses": "related",
    "participles": "related",
    "mutual": "related",
    "verbs": "related",
    "negations": "constraint",
    "corrections": "constraint",
}
"""What becomes of words between noun phrases, by section of the grammar; the others are filler."""
_PARTS = re.compile(r"[^/]+")
"""What is one word, where "w/o" is two."""
_WRITTEN = re.compile(r"[^\W_]+(?:['\u2019-][^\W_]+)*")
"""A word as it is written."""
_IDLE = ("be", "other", "put", "serve")
"""Verbs that say nothing themselves."""
_BARRING = ("without", "except", "instead")
"""Prepositions that say what is not wanted."""
_NOUNS: dict[NounKind, Fate] = {
    "thing": "requested",
    "number": "requested",
    "room": "requested",
    "place": "related",
    "part": "related",
    "pronoun": "related",
    "people": "filler",
    "abstract": "filler",
}


class Account:
    """The fate of each token of one text.

    A chunk has the fate that such a chunk usually has, until the reader of clauses says that it was put to other use,
    or to none.
    """

    def __init__(self, tokens: Sequence[Token], chunks: Sequence[Chunk]) -> None:
        self._tokens = list(tokens)
        self._fates: list[Fate] = ["filler"] * len(self._tokens)
        for chunk in chunks:
            self.mark(chunk.start, chunk.end, _usual(chunk))
            if isinstance(chunk, Noun):
                for at, fate in chunk.fates.items():
                    self._fates[at] = fate

    def mark(self, start: int, end: int, fate: Fate) -> None:
        """Say what became of the tokens from `start` to before `end`."""
        for at in range(start, min(end, len(self._tokens))):
            self._fates[at] = fate

    def is_lost(self, start: int, end: int) -> bool:
        """Whether all of these tokens were said not to be understood."""
        return all(fate == "not_understood" for fate in self._fates[start:end])

    def is_any_lost(self, start: int, end: int) -> bool:
        """Whether any of these tokens was said not to be understood."""
        return any(fate == "not_understood" for fate in self._fates[start:end])

    def text(self, start: int, end: int) -> str:
        """The tokens from `start` to before `end` as they were written."""
        return " ".join(token.shown for token in self._tokens[start:end] if token.shown)

    def all_words(self) -> list[str]:
        """All tokens as they were written, marks among them."""
        return [token.shown for token in self._tokens]

    def words(self) -> tuple[Word, ...]:
        """Every word and number in order, each once."""
        pairs = zip(self._tokens, self._fates, strict=True)
        told = [(t, part, fate) for t, fate in pairs if t.kind != "mark" for part in _PARTS.finditer(t.shown)]
        return tuple(Word(text=part[0], start=t.start + part.start(), fate=fate) for t, part, fate in told)


def of_all_words(words: Sequence[Word], text: str, told: Sequence[str]) -> tuple[Word, ...]:
    """The words of an account as they stand in a text, with those of it that were read as others, or left out.

    Args:
        words: of the account.
        text: as it was written.
        told: what of it was said not to be followed.
    """
    lost = {
        at for said in told for found in re.finditer(_loosely(said), text, re.IGNORECASE) for at in range(*found.span())
    }
    kept = [_as_written(word, text) for word in words if _is_written(word, text)]
    covered = {at for word in kept for at in range(word.start, word.start + len(word.text))}
    fates = {word.start: word.fate for word in words}
    left = (found for found in _WRITTEN.finditer(text) if covered.isdisjoint(range(*found.span())))
    more = [
        Word(
            text=found[0],
            start=found.start(),
            fate="not_understood" if found.start() in lost else fates.get(found.start(), "filler"),
        )
        for found in left
    ]
    return tuple(sorted([*kept, *more], key=lambda word: word.start))


def _is_written(word: Word, text: str) -> bool:
    """Whether a word stands in a text where it is said to, be it in other code points or in capitals."""
    forms = (normalize("NFKC", part).casefold() for part in (_written_at(word, text), word.text))
    return len(set(forms)) == 1


def _as_written(word: Word, text: str) -> Word:
    """A word that was read in small letters, in those that it stands in."""
    there = _written_at(word, text)
    read = word.text != there and word.text.casefold() == there.casefold()
    return structs.replace(word, text=there) if read else word


def _written_at(word: Word, text: str) -> str:
    return text[word.start : word.start + len(word.text)]


def _loosely(said: str) -> str:
    """A pattern for words, whatever space or comma is between them."""
    return r"[\s,]+".join(map(re.escape, said.split()))


def _usual(chunk: Chunk) -> Fate:
    match chunk:
        case Noun():
            return "constraint" if chunk.det == "no" else _NOUNS[chunk.kind]
        case Connector():
            idle = chunk.sort == "verbs" and chunk.value in _IDLE
            if chunk.sort == "prepositions" and chunk.value in _BARRING:
                return "constraint"
            return "filler" if idle else _LINKS.get(chunk.sort, "filler")
        case Adjective():
            said = chunk.attributes or chunk.states or chunk.unshown
            return "requested" if said else "style" if chunk.styles else "filler"
        case Measured():
            return "constraint"
        case SaidSurface():
            return "requested"
        case Stray():
            return "not_understood"
