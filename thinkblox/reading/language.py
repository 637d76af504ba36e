"""Which language a prompt is written in, by how many of its words we know in each."""

from thinkblox.errors import InputError
from thinkblox.reading.chunker import Chunker
from thinkblox.reading.english import known_share
from thinkblox.reading.lexicon import ENGLISH, LANGUAGES, Lexicon, load

_CLEAR = 0.72
"""Share of known words from which on English is taken without a look at the other languages."""
_FOREIGN, _SENTENCE = 0.4, 6
"""A text of so many words of which a smaller share is known is in a language that we do not read."""
_SAMPLE = 2_000
"""The language is told by the beginning of a prompt [characters]."""


def lexicon_of(prompt: str) -> Lexicon:
    """The lexicon of the prompt's language; raises InputError when hardly a word is known in any."""
    sample = prompt[:_SAMPLE]
    if not any(character.isalpha() for character in prompt):
        raise InputError("the prompt has no words; say in words what the room is and what is in it")
    best, found = 0.0, load(ENGLISH)
    for code in LANGUAGES:
        lexicon = load(code)
        share = _share(sample, lexicon)
        if share > best:
            best, found = share, lexicon
        if best >= _CLEAR:
            break
    names = ", ".join(LANGUAGES.values())
    if best <= 0.0:
        raise InputError(f"no word of the prompt was understood; write it in one of: {names}")
    if best < _FOREIGN and len(sample.split()) >= _SENTENCE:
        raise InputError(f"hardly a word of the prompt was understood; write it in one of: {names}")
    return found


def _share(text: str, lexicon: Lexicon) -> float:
    tokens = lexicon.tokens(text)
    if lexicon.code == ENGLISH:
        return known_share(lexicon, tokens)
    words = sum(token.kind == "word" for token in tokens)
    if not words:
        return 0.0
    chunker = Chunker(lexicon, tokens)
    for _ in chunker.items():
        pass
    return chunker.known / words
