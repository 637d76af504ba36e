"""Words of instructions that are written with a slip, or differently."""

from functools import lru_cache

from msgspec import structs

from thinkblox.editing.grammar import means, sections
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.slips import meant_by
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token

_OWN_WORDS = ("verbs", "fillers", "comparatives", "resizing", "sizes", "distances", "asked", "done", "obtained")


def without_slip(lexicon: Lexicon, token: Token) -> Token:
    """The word that is meant by one with a slip, or by one that is read as another."""
    if side := means("synonyms", token.text):
        return structs.replace(token, text=side)
    known = token.kind != "word" or any(means(s, token.text) for s in _OWN_WORDS)
    meant = "" if known else meant_by(lexicon, token.text, _of_orders())
    return structs.replace(token, text=meant) if meant else token


@lru_cache(maxsize=1)
def _of_orders() -> frozenset[str]:
    """The words of instructions that may be meant by one with a slip: "repalce", "teh"."""
    of_verbs = frozenset(word for words in sections()["verbs"] for word in words)
    return of_verbs | frozenset(word for words in grammar().phrases for word in words)
