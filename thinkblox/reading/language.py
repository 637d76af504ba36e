"""Which language a prompt is written in, by how many of its words each lexicon knows."""

from thinkblox.errors import InputError
from thinkblox.reading.chunker import Chunker
from thinkblox.reading.lexicon import LANGUAGES, Lexicon, load
from thinkblox.reading.phrases import Item

_CLEAR = 0.72
"""Share of known words from which on English is taken without a look at the other languages."""
_FOREIGN, _SENTENCE = 0.4, 6
"""A text of so many words of which a smaller share is known is in a language that we do not read."""


def read_items(prompt: str) -> tuple[Lexicon, list[Item]]:
    """The lexicon of the prompt's language and the items read with it; raises InputError when no word is known."""
    best: tuple[float, Lexicon, list[Item]] | None = None
    for code in LANGUAGES:
        lexicon = load(code)
        share, items = _read(prompt, lexicon)
        if best is None or share > best[0]:
            best = (share, lexicon, items)
        if best[0] >= _CLEAR:
            break
    names = ", ".join(LANGUAGES.values())
    if best is None or best[0] <= 0.0:
        raise InputError(f"no word of the prompt was understood; write it in one of: {names}")
    if best[0] < _FOREIGN and len(prompt.split()) >= _SENTENCE:
        raise InputError(f"hardly a word of the prompt was understood; write it in one of: {names}")
    return best[1], best[2]


def _read(prompt: str, lexicon: Lexicon) -> tuple[float, list[Item]]:
    tokens = lexicon.tokens(prompt)
    chunker = Chunker(lexicon, tokens)
    items = list(chunker.items())
    words = sum(token.kind == "word" for token in tokens)
    return (chunker.known / words if words else 0.0), items
