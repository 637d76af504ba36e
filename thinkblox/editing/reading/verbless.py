"""What is asked for without a verb: "red stools", "a round table instead"."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.assets.plurals import singular
from thinkblox.editing.grammar import longest, means
from thinkblox.editing.reading.clause import ENDS
from thinkblox.reading.english.chunker import cut
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token

_NEW = ("a", "an")
_ASKING = ("add", "want", "put")
_COURTESY = ("please", ",", *ENDS)


def with_verbs(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The tokens with what is asked for without a verb as an order.

    "Red stools" is "make the stools red", and "(I want) a round table instead", which nothing was said before, is
    "replace the table with a round table".
    """
    return _made(lexicon, tokens) or _instead(lexicon, tokens) or list(tokens)


def _word(text: str) -> Token:
    return Token(text, text, "word", start=-1)


def _said(tokens: Sequence[Token]) -> list[Token]:
    """The tokens without courtesies and marks at either end."""
    left = list(tokens)
    while left and left[-1].text in _COURTESY:
        left.pop()
    while left and left[0].text in _COURTESY:
        del left[0]
    return left


def _made(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """Read "red stools" as "make the stools red"; empty where it is nothing like that."""
    said = _said(tokens)
    noun = _one_noun(lexicon, said)
    if noun is None or noun.det or noun.count or not noun.plural or not noun.attributes or noun.degree or noun.size:
        return []
    at = next((n for n in range(len(said)) if lexicon.longest(said, n).entry("object") is not None), 0)
    looks, named = said[:at], said[at:]
    if not looks or lexicon.longest(said, at).length != len(named):
        return []
    if len(looks) != len(noun.attributes) or any(longest("verbs", said, n) is not None for n in range(at)):
        return []
    return [_word("make"), _word("the"), *named, *looks]


def _instead(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """Read "a round table instead" as "replace the table with a round table"; empty where it is nothing like that."""
    end = next((n for n, token in enumerate(tokens) if token.text == "instead"), len(tokens))
    said, rest = _said(tokens[: end + 1]), list(tokens[end + 1 :])
    goes_on = not _said(rest) or rest[0].kind == "mark" or rest[0].text == "and"
    if not said or said[-1].text != "instead" or any(token.kind == "mark" for token in said) or not goes_on:
        return []
    begin = next((n for n, token in enumerate(said) if token.text in _NEW), None)
    if begin is None or (begin and not _asks(said, begin)):
        return []
    noun = _one_noun(lexicon, said[begin:-1])
    if noun is None or not (noun.attributes or noun.size or noun.degree):
        return []
    named = [n for n in range(begin, len(said) - 1) if lexicon.longest(said, n).entry("object") is not None]
    last = said[-2]
    one = singular(last.text)
    if not named:
        return []
    head = [*said[named[0] : -2], structs.replace(last, text=one, shown=one, start=-1)]
    head = [structs.replace(token, start=-1) for token in head]
    return [_word("replace"), _word("the"), *head, _word("with"), *said[begin:-1], *rest]


def _asks(said: Sequence[Token], end: int) -> bool:
    """Whether all that comes before is that something is asked for: "I want", "use"."""
    at = 0
    while at < end:
        found = longest("verbs", said, at)
        if found is not None and found[0] in _ASKING:
            at += found[1]
            continue
        filler = longest("fillers", said, at)
        if filler is None and not means("anybody", said[at].text):
            return False
        at += filler[1] if filler is not None else 1
    return at == end


def _one_noun(lexicon: Lexicon, tokens: Sequence[Token]) -> Noun | None:
    """The thing that the tokens name, and nothing else; None where they say more, or no thing."""
    if len(tokens) < 2 or any(token.kind == "mark" for token in tokens):
        return None
    chunks, _ = cut(lexicon, list(tokens))
    one = chunks[0] if len(chunks) == 1 else None
    return one if isinstance(one, Noun) and one.kind == "thing" and one.named else None
