"""English, read with an open vocabulary: noun phrases, clauses, what they refer to, and what became of every word."""

import re
from dataclasses import replace

from thinkblox.reading.draft import Draft
from thinkblox.reading.english.chunker import cut
from thinkblox.reading.english.clauses import Clauses
from thinkblox.reading.english.familiar import known_share
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token

__all__ = ["known_share", "read_english"]
_POINTS = re.compile(r"\b(?:i\.e\.|e\.g\.|etc\.|approx\.|incl\.|ca\.|resp\.|vs\.|max\.|min\.)", re.IGNORECASE)
"""Abbreviations whose points end no sentence."""
_SHORT = {"w": "with", "teh": "the", "n": "and", "pls": "please", "plz": "please", "evrywhere": "everywhere"}
_JOINED = ("its", "thats", "hes", "shes", "whats", "heres")
"""Words with "is" joined to them by an apostrophe."""


def read_english(lexicon: Lexicon, text: str) -> Draft:
    """What an English text asks for, before counts and general words are settled."""
    text = _POINTS.sub(lambda match: match[0].replace(".", " "), text)
    tokens = _spelt_out(lexicon.tokens(text))
    return Clauses(tokens, cut(lexicon, tokens)).read()


def _spelt_out(tokens: list[Token]) -> list[Token]:
<<<<<<< HEAD
    """Words that people shorten, as the lexicon has them."""
    spelt: list[Token] = []
    for token in tokens:
        if len(token.shown) > len(token.text) and token.text in _JOINED:
            head = token.text[:-1]
            spelt += [replace(token, text=head, owner=False), replace(token, text="is", shown="is", owner=False)]
        else:
            spelt.append(replace(token, text=_SHORT.get(token.text, token.text)))
    return spelt
=======
    """Words that people shorten, as the lexicon has them; "it's" as two."""
    whole: list[Token] = []
    for token in tokens:
        if token.text == "its" and token.owner:
            it, rest = token.shown[:2], token.shown[2:]
            whole.append(Token("it", it, "word", start=token.start))
            whole.append(Token("is", rest, "word", start=token.start + len(it)))
        else:
            whole.append(replace(token, text=_SHORT.get(token.text, token.text)))
    return whole
>>>>>>> english
