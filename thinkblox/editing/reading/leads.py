"""What stands before an order: what is told of a thing, announced, disliked or new, and why."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.assets.plurals import singular
from thinkblox.editing.grammar import longest, means
from thinkblox.editing.reading.clause import (
    AGAIN,
    ENDS,
    LINKS,
    NEWS,
    POINTERS,
    TO,
    ClauseStart,
    after_fillers,
    is_filler_at,
)
from thinkblox.editing.reading.clause_starts import start_at, starts_of
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.lexicon import Lexicon, load
from thinkblox.reading.tokens import Token

_PLACING = ("at", "around", "by", "next_to", "near", "on", "in", "behind", "in_front_of", "against", "above", "under")
"""Prepositions by which an announcement says where what it is about is to come."""
MOST_NAMED = 6
"""Most words of a place that an announcement ends with."""
_ANNOUNCING = ("want", "make", "rearrange", "ensure", "clear", "free")
_IS = Token("is", "is", "word", start=-1)
_ON = Token("on", "on", "word", start=-1)
_FROM = Token("from", "from", "word", start=-1)


def without_announcements(tokens: Sequence[Token]) -> list[Token]:
    """The tokens without what only announces the orders behind a colon: "I'd like more light: add two wall lamps".

    A place that it names is that of what is added then: "I want more seats at the table: add two chairs". Of "clear the
    table: only the vase should stay" the second part is of what is on the table.
    """
    at = next((n for n, token in enumerate(tokens) if token.text == ":"), None)
    if at is None:
        return list(tokens)
    begin = next((n + 1 for n in range(at - 1, -1, -1) if tokens[n].text in ENDS), 0)
    lead, rest = list(tokens[begin:at]), without_announcements(tokens[at + 1 :])
    first, said = (
        after_fillers(rest),
        start_at(lead, after_fillers(lead), first=True) if after_fillers(lead) < len(lead) else None,
    )
    start = start_at(rest, first, first=True) if first < len(rest) else None
    if start is None and said is not None and _is_list_of_new(lead, said, rest):
        return [*tokens[:begin], structs.replace(tokens[at], text="add", kind="word"), *rest]
    if start is None:
        return [*tokens[:begin], *lead, *rest]
    end = next((n for n in range(first, len(rest)) if rest[n].text in ENDS), len(rest))
    everything = bool(start.before) and start.before[0].text == "everything"
    if said is not None and said.doing in ("clear", "free", "rearrange") and everything:
        return [*tokens[:begin], *rest[: first + 1], _ON, *lead[said.body :], *rest[first + 1 :]]
    again = any(token.text in AGAIN for token in rest[first:end])
    if again or (said is not None and said.doing not in _ANNOUNCING):
        return [*tokens[:begin], *lead, structs.replace(tokens[at], text="."), *rest]
    if said is not None and start.doing == "keep" and start.before:
        subject = first + len(start.before)
        return [*tokens[:begin], *rest[:subject], _ON, *lead[said.body :], *rest[subject:]]
    alone = not any(grammar().at(rest, n, "prepositions") for n in range(first, end))
    where = _place_at_end(lead) if start.doing in ("add", "put") and alone else []
    return [*tokens[:begin], *rest[:end], *where, *rest[end:]]


def _is_list_of_new(lead: Sequence[Token], said: ClauseStart, rest: Sequence[Token]) -> bool:
    """Whether a colon leads from what is to be done to what is to come for it: "Set the table: a glass for each"."""
    whole = said.doing in NEWS and said.body < len(lead) and lead[said.body].text in ("the", "my", "our")
    new = bool(rest) and (rest[0].text in ("a", "an", "some") or rest[0].kind == "number")
    new = new or grammar().at(rest, 0, "count") is not None
    return whole and new and not any(grammar().at(lead, n, "prepositions") for n in range(said.body, len(lead)))


def without_reasons(lexicon: Lexicon, tokens: Sequence[Token]) -> list[Token]:
    """The tokens without what somebody tells of people before the first order, which names no thing.

    "We hired two more people, add two desks" is to add two desks.
    """
    left = list(tokens)
    while left and means("persons", left[0].text):
        end = next((n for n, token in enumerate(left) if token.text in (*ENDS, ",", "–")), len(left))
        told, rest = left[:end], left[end + 1 :]
        things = any(lexicon.longest(told, n).entry("object") is not None for n in range(len(told)))
        if things or not rest or list(starts_of(told)) or longest("dislikes", told, 0):
            break
        left = rest[1:] if rest[0].text in ("so", "and") else rest
    return left


def _place_at_end(lead: Sequence[Token]) -> list[Token]:
    """The place that an announcement ends with, which names a thing that is known: "at the table"."""
    for at in range(1, len(lead) - 2):
        found = grammar().at(lead, at, "prepositions")
        named = lead[at + found.length :] if found is not None and found.value in _PLACING else []
        if named and named[0].text in ("the", "my", "our"):
            return list(lead[at:]) if len(named) <= MOST_NAMED else []
    return []


def without_unwanted(
    tokens: Sequence[Token], starts: list[ClauseStart], lead: Sequence[Token]
) -> tuple[list[ClauseStart], Sequence[Token]]:
    """The clauses without "I don't want the lamp by the door, (move it)", which tells what the next one is about."""
    if len(starts) < 2 or starts[0].doing != "unwanted" or tokens[starts[1].body].text not in ("it", "them"):
        return starts, lead
    said = tokens[starts[0].body : starts[1].begin]
    placed = next((n for n in range(len(said)) if grammar().at(said, n, "prepositions") is not None), None)
    if placed is None or not placed:
        return starts, lead
    return starts[1:], [*said[:placed], _IS, *said[placed:]]


def told_about(lead: Sequence[Token]) -> tuple[Token, ...]:
    """What a statement before an order is about, which "it" means there: "the desk is too close, move it back"."""
    first = after_fillers(lead)
    told = next((n for n in range(first, len(lead)) if means("statements", lead[n].text)), first)
    told = told if told > first else _named_first(lead, first)
    pointed = told > first and lead[first].text in POINTERS
    return tuple(lead[first:told]) if pointed else ()


def one_of(about: Sequence[Token], body: Sequence[Token]) -> tuple[Token, ...]:
    """An order with what a statement before it is about in place of "one": "(the plants are too many,) keep one"."""
    if [token.text for token in body[:2]] not in (["the", "one"], ["the", "ones"]):
        return tuple(body)
    name = singular(about[-1].text) if body[1].text == "one" else about[-1].text
    return (body[0], *about[1:-1], structs.replace(body[1], text=name), *body[2:])


def _named_first(lead: Sequence[Token], first: int) -> int:
    """Where the thing that a sentence begins with ends, if more is told of it: "the big clock (ticks too loudly)"."""
    if first >= len(lead) or lead[first].text not in ("the", "my", "our", "that", "this"):
        return first
    lexicon = load("en")
    for at in range(first + 1, min(first + MOST_NAMED, len(lead))):
        named = lexicon.longest(list(lead), at)
        if named.entry("object") is not None:
            end = at + named.length
            told = [token for token in lead[end:] if token.kind == "word"]
            placed = grammar().at(lead, end, "prepositions") is not None if end < len(lead) else True
            return end if told and not placed else first
    return first


def blocked_in(lead: Sequence[Token]) -> tuple[Token, ...]:
    """What a thing is said to be in the way of: "the wardrobe blocks the window"."""
    for at in range(len(lead)):
        if (found := longest("blocking", lead, at)) is not None:
            return tuple(token for token in lead[at + found[1] :] if token.text not in (*ENDS, *LINKS))
    return ()


def compared_with(told: Sequence[Token], body: Sequence[Token]) -> tuple[Token, ...]:
    """An order with from what, or to what, a thing goes that is too close to it, or too far from it: "move it away"."""
    for last, token in enumerate(body):
        way, end = means("ways_off", token.text), last + 1
        few = longest("few", body, end)
        end += few[1] if few is not None else 0
        if not way or not all(t.text in (*ENDS, *LINKS) for t in body[end:]):
            continue
        for at in range(len(told)):
            found = longest("too_far" if way == "nearer" else "too_near", told, at)
            if found is not None:
                known = (token for token in told[at + found[1] :] if token.text not in (*ENDS, *LINKS))
                link = TO if way == "nearer" else _FROM
                return (*body[: last + 1], link, *known, *body[last + 1 : end])
    return tuple(body)


def is_of_other(start: ClauseStart, body: Sequence[Token]) -> bool:
    """Whether another one of what was told of is asked for: "the rug is too small, get a bigger one"."""
    new = bool(body) and body[0].text in ("a", "an", "another")
    one = any(token.text == "one" for token in body) and not any(token.text in LINKS for token in body)
    return new and one and start.doing in (*NEWS, "move")


def obtained_in(lead: Sequence[Token]) -> tuple[Token, ...]:
    """What a sentence says to be new: "we got a new side table"; empty where it is another."""
    for at in range(len(lead)):
        if (found := longest("obtained", lead, at)) is not None:
            end = at + found[1] - (2 if lead[at + found[1] - 1].text == "new" else 0)
            said = [token for token in lead[end:] if token.text not in (*ENDS, *LINKS, "so", "new")]
            fits = bool(said) and (said[0].text in ("a", "an", "some", "another") or said[0].kind == "number")
            return tuple(token for token in said if not is_filler_at(lead, token)) if fits else ()
    return ()


def disliked_in(lead: Sequence[Token]) -> tuple[Token, ...]:
    """What is said not to be liked before an order."""
    first = after_fillers(lead)
    found = longest("dislikes", lead, first)
    said = [t for t in lead[first + found[1] :] if t.text not in (*ENDS, *LINKS)] if found is not None else []
    if said[:1] and said[0].text == "where" and means("statements", said[-1].text):
        said = said[1:-1]
    return tuple(said)


def told_before(tokens: Sequence[Token]) -> int:
    """How many tokens tell of a thing before the first order says what is to be done with it."""
    starts = list(starts_of(tokens))
    begun = starts[0].begin if starts else 0
    starts, lead = without_unwanted(tokens, starts, tokens[:begun])
    if starts and starts[0].begin > begun:
        return starts[0].begin
    return len(lead) if told_about(lead) or disliked_in(lead) or obtained_in(lead) or is_reason(lead) else 0


def is_reason(lead: Sequence[Token]) -> bool:
    """Whether it only tells why: "there's no computer here any more, so (clear the desk)"."""
    return [token.text for token in lead[-2:]] == [",", "so"]
