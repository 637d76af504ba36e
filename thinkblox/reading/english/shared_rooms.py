"""Rooms that are several at once: "living, kitchen and dining area", "a living/dining room"."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.reading.tokens import Token

_USES = {
    "living": "living",
    "lounge": "living",
    "sitting": "living",
    "kitchen": "kitchen",
    "cooking": "kitchen",
    "dining": "dining",
    "eating": "dining",
    "diner": "dining",
    "sleeping": "sleeping",
    "study": "work",
    "working": "work",
    "work": "work",
}
"""What is done in a part of a room, by the words that say so."""
_ROOMS = {"living": "living room", "kitchen": "kitchen", "dining": "dining room", "work": "study"}
"""What the room is by the first of these parts that it has; the others are parts of it."""
_HEADS = frozenset({"room", "rooms", "area", "areas", "space", "spaces", "zone", "zones"})
_JOINS = frozenset({",", "and", "/", "&", "+"})
_HAD = frozenset({"with", "has", "have", "having", "includes", "including", "plus"})
"""After these come the parts of a room that was named before."""
_BETWEEN = frozenset({"a", "an", "separate", "combined", "open", "plan", "small", "large", "spacious", "bright"})
"""Words that may come between."""


def with_parts(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "a living room with a dining area" for such a room, or with each part of the room by itself."""
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        uses, end = _shared(tokens, at)
        if not uses:
            made.append(tokens[at])
            at += 1
            continue
        had = next((t.text for t in reversed(made) if t.text not in _BETWEEN), "") in _HAD
        words = _parts(uses, bare=bool(made) and made[-1].text == "a") if had else _whole(uses)
        made += [Token(word, word, "word", start=tokens[at].start) for word in words]
        if not had and end < len(tokens) and tokens[end].text == "with":
            made.append(structs.replace(tokens[end], text=",", kind="mark"))
            end += 1
        at = end
    return made


def _shared(tokens: Sequence[Token], at: int) -> tuple[list[str], int]:
    """What is done in the several parts of the room that is named at a token, and where its name ends."""
    uses: list[str] = []
    end = at
    joined = headed = False
    while end < len(tokens) and tokens[end].text in _USES:
        uses.append(_USES[tokens[end].text])
        headed = end + 1 < len(tokens) and tokens[end + 1].text in _HEADS and not tokens[end].glued
        end += 1 + headed
        after = end
        while after < len(tokens) and tokens[after].text in _JOINS:
            after += 1
        close = tokens[end - 1].glued or any(token.text == "/" for token in tokens[end:after])
        if not (after > end or close) or after >= len(tokens) or tokens[after].text not in _USES:
            break
        joined |= close
        end = after
    several = len(set(uses)) > 1 and (headed or joined)
    return (list(dict.fromkeys(uses)), end) if several else ([], at)


def _whole(uses: Sequence[str]) -> list[str]:
    """The room by its first part, with the others."""
    if {"living", "sleeping"} <= {*uses}:
        room, rest = "studio apartment", [use for use in uses if use not in ("living", "sleeping")]
    else:
        first = next(use for use in _ROOMS if use in uses)
        room, rest = _ROOMS[first], [use for use in uses if use != first]
    return [*room.split(), *(["with", *_parts(rest, bare=False)] if rest else [])]


def _parts(uses: Sequence[str], *, bare: bool) -> list[str]:
    """Each part by itself, without the first article where that was there."""
    words = [word for use in uses for word in ("and", "a", use, "area")]
    return words[1 + bare :]
