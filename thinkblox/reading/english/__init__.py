"""English, read with an open vocabulary: noun phrases, clauses, what they refer to, and what became of every word."""

from thinkblox.reading.draft import Draft
from thinkblox.reading.english.chunker import cut
from thinkblox.reading.english.clauses import Clauses
from thinkblox.reading.lexicon import Lexicon

__all__ = ["read_english"]


def read_english(lexicon: Lexicon, text: str) -> Draft:
    """What an English text asks for, before counts and general words are settled."""
    return Clauses(cut(lexicon, lexicon.tokens(text))).read()
