"""What somebody takes back in the middle of a sentence: "to the window, no wait, to the door" is to the door."""

from collections.abc import Sequence

from thinkblox.editing.grammar import longest, means
from thinkblox.editing.lengths import lengths_at
from thinkblox.reading.english.grammar import grammar, is_count
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token

_ENDS = (".", ";", "!", "?", "\n")
_PAUSES = (",", "–", "—", "…", "(", ":")
_ARTICLES = ("the", "a", "an", "my", "our", "both", "all", "every", "each", "another", "this", "that")
_PRONOUNS = ("it", "them", "that")
_OF_MANNERS = ("for", "about")
"""Prepositions behind "sorry" by which nothing is taken back: "sorry for the trouble"."""
_LIKE = ("directions", "comparatives", "absolutes", "sizes")
"""Sorts of words of the instructions' grammar, of which one corrects another."""


def corrected(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The tokens with what is said anew in place of what is taken back; as they are where it is not known what that is.

    Args:
        lexicon: of its language.
        tokens: of the instruction.
    """
    left = list(tokens)
    for at in range(len(left)):
        found = _begins(left, at)
        if found is None:
            continue
        begin, end = found
        start = next((n + 1 for n in range(begin - 1, -1, -1) if left[n].text in _ENDS), 0)
        stop = _stop(left, end)
        said, anew = left[start:begin], left[end:stop]
        mended = _mended(lexicon, said, anew) if said and anew else None
        if mended is not None:
            rest = left[stop:]
            joined = rest[1:] if rest[:1] and rest[0].text == "," and _is_place(rest, 1) else rest
            return corrected(lexicon, [*left[:start], *mended, *joined])
    return left


def _begins(tokens: Sequence[Token], at: int) -> tuple[int, int] | None:
    """Where what is said before a correction ends, and where that begins which is said anew; None where it is none."""
    found = longest("corrections", tokens, at)
    if found is None or not at:
        return None
    key, end = found[0], at + found[1]
    paused = tokens[at - 1].text in (*_PAUSES, *_ENDS)
    after = end < len(tokens) and tokens[end].text in _PAUSES
    if not paused or (key == "weak" and tokens[at - 1].text in _ENDS) or (key == "bare" and not after):
        return None
    begin = at
    while begin and tokens[begin - 1].text in (*_PAUSES, *_ENDS):
        begin -= 1
    while end < len(tokens) and tokens[end].text in _PAUSES:
        end += 1
    return begin, end


def _stop(tokens: Sequence[Token], at: int) -> int:
    """Where what is said anew ends: at the end of the sentence, or before what goes on after it."""
    for index in range(at, len(tokens)):
        if tokens[index].text in (*_ENDS, *_PAUSES):
            return index
        if index > at and tokens[index].text in ("and", "then", "but") and _is_verb(tokens, index + 1):
            return index
    return len(tokens)


def _is_verb(tokens: Sequence[Token], at: int) -> bool:
    return at < len(tokens) and (
        longest("verbs", tokens, at) is not None or longest("resizing", tokens, at) is not None
    )


def _is_place(tokens: Sequence[Token], at: int) -> bool:
    return at < len(tokens) and grammar().at(tokens, at, "prepositions") is not None


def _mended(lexicon: Lexicon, said: list[Token], anew: list[Token]) -> list[Token] | None:
    """What was said, with what is said anew in place of the part of it that is like that."""
    order = _last_order(said)
    if _is_verb(anew, 0) and len(anew) > 1:
        return _other_order(lexicon, said, anew, order)
    length = lengths_at(lexicon, anew, 0)
    if length is not None:
        return _other_length(lexicon, said, anew, order)
    if is_count(anew, 0):
        return _other_number(said, anew, order)
    if _like(lexicon, anew, 0) and len(anew) <= 2:
        at = next(
            (n for n in range(len(said) - 1, order, -1) if _like(lexicon, said, n) & _like(lexicon, anew, 0)), None
        )
        if at is not None:
            return [*said[:at], *anew, *said[at + 1 :]]
    if _is_place(anew, 0) and anew[0].text not in _OF_MANNERS:
        return _other_place(said, anew, order)
    if anew[0].text in _ARTICLES:
        return _other_thing(said, anew, order)
    return None


def _last_order(said: Sequence[Token]) -> int:
    """Where the verb of the last order of a sentence is."""
    links = (",", "and", "then", "but")
    begun = (n for n in range(len(said) - 1, 0, -1) if said[n - 1].text in links and _is_verb(said, n))
    return next(begun, 0)


def _other_order(lexicon: Lexicon, said: list[Token], anew: list[Token], order: int) -> list[Token] | None:
    """Another order in place of the last; "it" in it is what that was about."""
    verb = longest("verbs", said, order) or longest("resizing", said, order)
    if verb is None:
        return None
    begin = order + verb[1]
    end = next((n for n in range(begin, len(said)) if _is_place(said, n)), len(said))
    while end > begin + 1 and _like(lexicon, said, end - 1):
        end -= 1
    thing = said[begin:end]
    if thing and thing[0].text not in _PRONOUNS:
        at = next((n for n, token in enumerate(anew) if token.text in _PRONOUNS[:2]), None)
        anew = [*anew[:at], *thing, *anew[at + 1 :]] if at is not None else anew
    return [*said[:order], *anew]


def _other_length(lexicon: Lexicon, said: list[Token], anew: list[Token], order: int) -> list[Token] | None:
    for at in range(len(said) - 1, order, -1):
        old, new = lengths_at(lexicon, said, at), lengths_at(lexicon, anew, 0)
        if old is not None and new is not None:
            rest = said[at + old.tokens :] if new.tokens == len(anew) else []
            return [*said[:at], *anew, *rest]
    return None


def _other_number(said: list[Token], anew: list[Token], order: int) -> list[Token] | None:
    for at in range(len(said) - 1, order, -1):
        count = grammar().at(said, at, "count")
        if said[at].kind == "number" or count is not None or said[at].text in ("a", "an"):
            rest = said[at + 1 :] if len(anew) == 1 else []
            place = next((n for n in range(at, len(said)) if _is_place(said, n)), len(said))
            return [*said[:at], *anew, *(rest if len(anew) == 1 else said[place:])]
    return None


def _other_place(said: list[Token], anew: list[Token], order: int) -> list[Token] | None:
    """From the last preposition that is the same on, or else from the last of all on."""
    words = [n for n in range(order + 1, len(said)) if _is_place(said, n)]
    same = [n for n in words if said[n].text == anew[0].text]
    at = (same or words)[-1:]
    return [*said[: at[0]], *anew] if at else None


def _other_thing(said: list[Token], anew: list[Token], order: int) -> list[Token] | None:
    """From the last article on: "on the desk, sorry, the sideboard"."""
    at = next((n for n in range(len(said) - 1, order, -1) if said[n].text in _ARTICLES), None)
    return [*said[:at], *anew] if at is not None else None


def _like(lexicon: Lexicon, tokens: Sequence[Token], at: int) -> set[str]:
    """As what a single word can be set right by another: a look, a direction, a size."""
    found = {sort for sort in _LIKE if means(sort, tokens[at].text)}
    named = lexicon.longest(list(tokens), at)
    return found | ({"attribute"} if named.entry("attribute") is not None else set())
