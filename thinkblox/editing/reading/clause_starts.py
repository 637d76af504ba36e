"""Where the clauses of an instruction begin: with a verb, or with a thing of which it is said how it should be."""

from collections.abc import Sequence
from dataclasses import replace

from msgspec import structs

from thinkblox.editing.grammar import longest, means
from thinkblox.editing.reading.clause import (
    ENDS,
    LINKS,
    NOT,
    POINTERS,
    WANTS,
    ClauseStart,
    ends_at,
    meant_at,
    rest_of_sentence,
)
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.tokens import Token

_RELATIVE = ("so", "that", "which", "who")
_GONE = ("go", "leave", "disappear")
_NOTHING = ("nothing",)


def starts_of(tokens: Sequence[Token]) -> list[ClauseStart]:
    """Where the clauses begin, in their order."""
    starts: list[ClauseStart] = []
    index, fresh, first = 0, True, True
    while index < len(tokens):
        start = start_at(tokens, index, first=first) if fresh else _sparing(tokens, index)
        if start is not None:
            starts.append(start)
            index, fresh, first = _coordinated(tokens, start), False, False
            continue
        filler = longest("fillers", tokens, index) if fresh else None
        if tokens[index].text in ENDS:
            fresh = first = True
        elif tokens[index].text in LINKS or (tokens[index].text == "so" and fresh and _begins(tokens, index + 1)):
            fresh = True
        elif filler is not None:
            index += filler[1]
            continue
        else:
            fresh = first = False
        index += 1
    return starts


def _begins(tokens: Sequence[Token], at: int) -> bool:
    """Whether an order begins with a verb there: "(it is too close, so) move it"."""
    return at < len(tokens) and tokens[at].text not in POINTERS and verb_at(tokens, at, first=True) is not None


def _coordinated(tokens: Sequence[Token], start: ClauseStart) -> int:
    """From where on another clause may begin: of "have the lamp and the plant trade places" after the whole wish."""
    if start.doing not in WANTS:
        return start.body
    for index in rest_of_sentence(tokens, start.body + 1):
        if means("bare", tokens[index].text) or longest("bare", tokens, index) is not None:
            wish = longest("wishes", tokens, index)
            return index + wish[1] if wish is not None else start.body
        if tokens[index].text == "," or longest("wishes", tokens, index) is not None:
            return start.body
        if tokens[index].text in LINKS and starts_with_verb(tokens, index + 1):
            return start.body
    return start.body


def starts_with_verb(tokens: Sequence[Token], at: int) -> bool:
    """Whether an order may begin there, in the middle of a sentence."""
    return at < len(tokens) and verb_at(tokens, at, first=False) is not None


def start_at(tokens: Sequence[Token], at: int, *, first: bool) -> ClauseStart | None:
    """The clause that begins at a token; None where none does.

    Args:
        tokens: of the whole instruction.
        at: the token.
        first: nothing stands before it in its sentence.
    """
    denied = longest("denials", tokens, at)
    if denied is not None and denied[0] == "not":
        verb = verb_at(tokens, at + denied[1], first=True)
        if verb is not None and longest("verbs", tokens, at) is None:
            return ClauseStart(at, at + denied[1] + verb[2], verb[0], verb[1], denied=True)
    if denied is not None and denied[0] == "without":
        return _sparing(tokens, at)
    verb = verb_at(tokens, at, first=first)
    filler = longest("fillers", tokens, at)
    if verb is not None and filler is not None and filler[1] > verb[2]:
        return None
    if verb is not None:
        return ClauseStart(at, at + verb[2], verb[0], verb[1])
    return _wish(tokens, at, first=first)


def _sparing(tokens: Sequence[Token], at: int) -> ClauseStart | None:
    """Read "without moving the sofa", in the middle of an order."""
    found = longest("denials", tokens, at)
    if found is None or found[0] != "without":
        return None
    if tokens[at].text == "but":
        return None
    return ClauseStart(at, at + found[1], "keep")


def verb_at(tokens: Sequence[Token], at: int, *, first: bool) -> tuple[str, str, int] | None:
    """What is done, how the room changes by that, and the length of the verb [tokens]."""
    found = longest("verbs", tokens, at)
    change = longest("resizing", tokens, at)
    if change is not None and (found is None or change[1] > found[1]):
        found = ("make", change[1])
    else:
        change = None
    if found is None:
        return None
    after = tokens[at + found[1]] if at + found[1] < len(tokens) else None
    pointed = after is not None and (after.text in POINTERS or after.kind == "number" or found[1] > 1)
    pointed |= after is not None and grammar().at([after], 0, "count") is not None
    pointed |= at > 0 and tokens[at - 1].text == "then"
    pointed |= at > 0 and tokens[at - 1].text in LINKS and bool(means("plain_verbs", tokens[at].text))
    if not first and not pointed:
        return None
    return found[0], change[0] if change else "", found[1]


def _wish(tokens: Sequence[Token], at: int, *, first: bool) -> ClauseStart | None:
    """Read "the sofa should be against the wall", "could the desk be under the window?"."""
    asked = longest("asked", tokens, at)
    if first and asked is not None and asked[0] == "before" and longest("fillers", tokens, at) is None:
        verb = next((n for n in rest_of_sentence(tokens, at + 1) if meant_at(tokens, n, "asked") == "after"), None)
        swapped = next((n for n in rest_of_sentence(tokens, at + 1) if meant_at(tokens, n, "wishes") == "swap"), None)
        if swapped is not None:
            found = longest("wishes", tokens, swapped)
            return replace(wished_at(tokens, at + 1, swapped, *found), begin=at) if found is not None else None
        if verb is None:
            return None
        told = verb if tokens[verb].text == "face" else verb + 1
        return ClauseStart(at, told, "put", before=tuple(tokens[at + 1 : verb]))
    for index in rest_of_sentence(tokens, at + 1):
        found = longest("wishes", tokens, index)
        mutual = grammar().at(tokens, index, "mutual")
        found = None if found is not None and mutual is not None and mutual.length > found[1] + 1 else found
        if found is not None and not first and _is_list(tokens[at:index]):
            return None
        if tokens[index].text in _RELATIVE or (found is None and verb_at(tokens, index, first=False) is not None):
            return None
        if (
            found is None
            or "to" in (tokens[index].text, tokens[index - 1].text)
            or (found[0] == "block" and tokens[at].text not in _NOTHING)
        ):
            continue
        return wished_at(tokens, at, index, *found)
    return None


def _is_list(subject: Sequence[Token]) -> bool:
    """Whether it ends with what follows a comma alone: "(remove the lamp and) the chair, the desk (can stay)"."""
    commas = [n for n, token in enumerate(subject) if token.text == ","]
    return bool(commas) and not any(token.text == "and" for token in subject[commas[-1] :])


def _nearest_of(subject: Sequence[Token]) -> tuple[Token, ...]:
    """What a wish is about, where "(the armchair) closer to the door" is the one that is so."""
    words = {"closer": "nearest", "nearer": "nearest", "further": "farthest", "farther": "farthest"}
    told = [n for n in range(1, len(subject) - 1) if subject[n].text in words and subject[n + 1].text in ("to", "from")]
    return tuple(
        structs.replace(token, text=words[token.text]) if n in told else token for n, token in enumerate(subject)
    )


def wished_at(tokens: Sequence[Token], at: int, index: int, key: str, length: int) -> ClauseStart:
    """The clause of a thing that begins at `at`, by the wish of a length [tokens] at `index`."""
    subject, after = _nearest_of(tokens[at:index]), index + length
    last = tokens[after - 1].text
    if subject[0].text in _NOTHING and key in ("put", "block"):
        return ClauseStart(at, after, "free")
    if key == "have":
        after -= last in ("a", "an", "one", "two")
        return ClauseStart(at, after, "add", before=(), whose=subject)
    spared = grammar().at(tokens, after, "prepositions") if after < len(tokens) else None
    gone = ends_at(tokens, after) or (spared is not None and spared.value == "except")
    if key == "put" and last in _GONE and gone:
        key = "remove"
    if key == "face":
        after -= 2 if last == "at" else 1
        return ClauseStart(at, after, "put", before=subject)
    if key == "not":
        after -= 1 if last == "face" else 0
        return ClauseStart(at, after, "put", before=(*subject, NOT))
    return ClauseStart(at, after, key, before=subject)
