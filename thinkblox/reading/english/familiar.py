"""How much of a text consists of English words that we know."""

from collections.abc import Sequence

from thinkblox.knowledge.vocabulary import is_abstract, is_person
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token


def known_share(lexicon: Lexicon, tokens: Sequence[Token]) -> float:
    """The share of the words that the grammar, the lexicon or the vocabulary knows; 0 where there are no words."""
    tokens = list(tokens)
    words = known = at = 0
    while at < len(tokens):
        if tokens[at].kind != "word":
            at += 1
            continue
        length = _known_at(lexicon, tokens, at)
        step = max(1, length)
        count = sum(token.kind == "word" for token in tokens[at : at + step])
        words += count
        known += count if length else 0
        at += step
    return known / words if words else 0.0


def _known_at(lexicon: Lexicon, tokens: list[Token], at: int) -> int:
    """How many tokens the longest phrase at `at` has; 0 where the word is unknown."""
    found = grammar().at(tokens, at, *grammar().sorts)
    lexeme = lexicon.longest(tokens, at)
    length = max(found.length if found is not None else 0, lexeme.length if lexeme.entries else 0)
    word = tokens[at].text
    return length or int(is_abstract(word) or is_person(word))
