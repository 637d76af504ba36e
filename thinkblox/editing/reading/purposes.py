"""What somebody says that an order is for, or why: a view is what a thing is to face, all else asks for nothing."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.editing.grammar import longest, means
from thinkblox.editing.reading.clause import ENDS
from thinkblox.editing.reading.clause_starts import starts_with_verb
from thinkblox.reading.english.grammar import grammar, is_count
from thinkblox.reading.tokens import Token, tokenise

MOST_OF_PERSON = 6
"""Most words by which somebody is named before what they do: "the person who sits there"."""
_NAMING = ("the", "my", "our", "a", "an", "each", "both")
_AGAIN = ("it", "them")
_IT = ("it", "they")
_OWN = ("my", "our", "your", "some", "their", "his", "her")
_FROM_IT = ("it", "them", "there", "here")
_NEEDED = ("the", "missing", "needed", "necessary", "extra", "more", "please", ".")
_PARTING = (",", "and", "then", "but")


def without_purposes(tokens: Sequence[Token]) -> list[Token]:
    """The tokens without what an order is for, or why it is given.

    "So that I can see the door (from it)" is "so that it faces the door", "so that I can sit at the window" is "at the
    window"; "so that I can read there", "so that four kids can draw", "because it is dark there", ", it needs light",
    "for my tea" and "for reading" ask for nothing.
    What people are to get to, or through, is left as it is: that asks for space.
    """
    left = _untold(_views_first(_without_told_reason(without_given(tokens))))
    for at in reversed(range(len(left))):
        if at >= len(left):
            continue
        if longest("reasons", left, at) is not None or (_begins(left, at) and left[at].text in ("since", "as")):
            left = _without_reason(left, at)
        elif left[at].text == "so":
            left = _seated(left, at) or _without_purpose(left, at)
        elif left[at].text == "to":
            left = _without_whole(left, at)
        elif left[at].text in _IT:
            left = _without_excess(_without_need(left, at), at)
        elif means("anybody", left[at].text) and at and left[at - 1].text in (",", ":"):
            left = _without_need(left, at)
        elif left[at].text == "for" and at:
            left = _without_use(left, at)
    return left


def _without_need(tokens: list[Token], at: int) -> list[Token]:
    """Without "(move the plant to the window,) it needs light"."""
    needs = longest("needing", tokens, at + 1)
    needed = longest("needed", tokens, at + 1 + needs[1]) if needs is not None else None
    if needs is None or needed is None or not at or not (_begins(tokens, at) or tokens[at - 1].text in _PARTING):
        return tokens
    end = at + 1 + needs[1] + needed[1]
    ends = end == len(tokens) or tokens[end].text in (*ENDS, *_PARTING)
    return _cut(tokens, at, end) if ends else tokens


def _without_excess(tokens: list[Token], at: int) -> list[Token]:
    """Without "(put the lamp next to the armchair), it is too dark there" at the end of an order."""
    words = [token.text for token in tokens[at + 1 : at + 3]]
    told = words[:1] in (["is"], ["are"]) and words[1:] in (["too"], ["so"], ["very"], ["rather"], ["quite"])
    begin = next((n + 1 for n in range(at - 1, -1, -1) if tokens[n].text in ENDS), 0)
    ordered = any(longest("verbs", tokens, n) is not None for n in range(begin, at))
    opinion = longest("opinions", tokens, at + 2) if words[:1] in (["is"], ["are"]) else None
    over = at + 2 + opinion[1] if opinion is not None else 0
    if over and ordered and tokens[at - 1].text in (",", ":") and (over == len(tokens) or tokens[over].kind == "mark"):
        return _cut(tokens, at, over)
    if not told or not ordered or tokens[at - 1].text not in (",", ":"):
        return tokens
    end = _end(tokens, at + 3)
    return tokens if any(token.text == "," for token in tokens[at:end]) else _cut(tokens, at, end)


def _without_use(tokens: list[Token], at: int) -> list[Token]:
    """Without "for reading (in the evening)", "for my tea", where nothing follows that this could be a part of."""
    used = longest("uses", tokens, at + 1 + (at + 1 < len(tokens) and tokens[at + 1].text in _OWN))
    if used is None:
        return tokens
    end = at + 1 + (tokens[at + 1].text in _OWN) + used[1]
    more = longest("when", tokens, end)
    end += more[1] if more is not None else 0
    goes_on = end < len(tokens) and tokens[end].kind == "word" and tokens[end].text not in _PARTING
    return tokens if goes_on and grammar().at(tokens, end, "prepositions") is None else _cut(tokens, at, end)


def _without_reason(tokens: list[Token], at: int) -> list[Token]:
    """Without "because it is dark there"; of "because the desk is too small, replace it" only the first word goes."""
    found = longest("reasons", tokens, at) or ("", 1)
    after = at + found[1]
    comma = next((n for n in range(after, len(tokens)) if tokens[n].text == ","), 0)
    again = any(token.text in _AGAIN for token in tokens[comma : comma + 3])
    if _begins(tokens, at) and _person(tokens, after) and comma and not again:
        return [*tokens[:at], *tokens[comma + 1 :]]
    if _begins(tokens, at):
        return [*tokens[:at], *tokens[after:]]
    return _cut(tokens, at, _end(tokens, at + found[1]))


def _begins(tokens: Sequence[Token], at: int) -> bool:
    """Whether a sentence begins there."""
    return at == 0 or tokens[at - 1].text in ENDS


def _counts_left(tokens: Sequence[Token], at: int) -> bool:
    """Whether what follows says how many then are left: "(so that) only four are left", "there are four left"."""
    end = _end(tokens, at)
    words = [token.text for token in tokens[at:end]]
    counted = any(token.kind == "number" or grammar().at([token], 0, "count") is not None for token in tokens[at:end])
    return counted and len(words) <= MOST_OF_PERSON and bool(words) and words[-1] in ("left", "remain", "remaining")


def _without_purpose(tokens: list[Token], at: int) -> list[Token]:
    said = at + 1 + (tokens[at + 1].text == "that" if at + 1 < len(tokens) else 0)
    if at and _counts_left(tokens, said):
        return _cut(tokens, at, _end(tokens, said))
    person = _person(tokens, said)
    if not person or at == 0:
        return tokens
    done = said + person
    able = longest("able", tokens, done)
    done += able[1] if able is not None else 0
    end = _end(tokens, done)
    if (seen := longest("seeing", tokens, done)) is not None:
        after = [token.text for token in tokens[done + seen[1] : done + seen[1] + 2]]
        if after in (["it", "from"], ["them", "from"]) and done + seen[1] + 2 < end:
            tokens = [*tokens[: done + seen[1]], *tokens[done + seen[1] + 2 :]]
            end -= 2
        words = tokenise("so that it faces")
        shown = " ".join(token.shown for token in tokens[at : done + seen[1]])
        faces = [
            structs.replace(words[0], shown=shown, start=tokens[at].start),
            *(structs.replace(w, start=-1) for w in words[1:]),
        ]
        return [*tokens[:at], *faces, *_without_from(tokens[done + seen[1] : end]), *tokens[end:]]
    if (sits := longest("sitting", tokens, done)) is not None and _placed(tokens, done + sits[1]):
        return [*tokens[:at], *tokens[done + sits[1] :]]
    needs_way = any(means("getting", token.text) for token in tokens[done:end]) or _arranges(tokens, at)
    if [token.text for token in tokens[done:end]] in (["reach", again] for again in _AGAIN):
        return _cut(tokens, at, end)
    return tokens if able is None or needs_way else _cut(tokens, at, end)


def _arranges(tokens: Sequence[Token], at: int) -> bool:
    """Whether what comes before is to be rearranged, of which the purpose is all that says how."""
    begin = next((n + 1 for n in range(at - 1, -1, -1) if tokens[n].text in ENDS), 0)
    verbs = [found[0] for n in range(begin, at) if (found := longest("verbs", tokens, n)) is not None]
    return verbs[-1:] == ["rearrange"]


def _seated(tokens: list[Token], at: int) -> list[Token]:
    """The tokens with "(make it longer) so that eight can sit at it" as so many chairs at it; else empty."""
    said = at + 1 + (tokens[at + 1].text == "that" if at + 1 < len(tokens) else 0)
    if not at or said >= len(tokens) or not is_count(tokens, said):
        return []
    who = said + 1 + (said + 1 < len(tokens) and grammar().knows(tokens[said + 1].text, "people"))
    able = longest("able", tokens, who) if who < len(tokens) else None
    sits = who + able[1] if able is not None else len(tokens)
    end = _end(tokens, said)
    if sits >= end or tokens[sits].text not in ("sit", "eat", "dine", "be") or _placed(tokens, sits + 1):
        return []
    words = [structs.replace(token, start=-1) for token in tokenise(", there should be chairs at it")]
    shown = " ".join(token.shown for token in tokens[at:end])
    there = structs.replace(words[1], start=tokens[at].start, shown=shown)
    rest = tokens[end:]
    more = [token.text for token in rest]
    begun = sum(word in (",", "and", "then") for word in more[:2])
    needless = more[begun : begun + 1] == ["add"] and [w for w in more[begun + 1 :] if w not in _NEEDED] == ["chairs"]
    rest = [] if needless else rest
    return [*tokens[:at], words[0], there, *words[2:4], structs.replace(tokens[said], start=-1), *words[4:], *rest]


def _without_whole(tokens: list[Token], at: int) -> list[Token]:
    """Without "(push two tables together) to make one long table": what comes of it when they stand so.

    Nor with "(take out the armchair) to make space (for it)", which that does by itself.
    """
    begin = next((n + 1 for n in range(at - 1, -1, -1) if tokens[n].text in ENDS), 0)
    verbs = [found[0] for n in range(begin, at) if (found := longest("verbs", tokens, n)) is not None]
    room = longest("making_room", tokens, at + 1)
    if room is not None:
        end = at + 1 + room[1]
        ends = end == len(tokens) or tokens[end].text in (*ENDS, *_PARTING)
        gone = verbs[-1:] == ["remove"] or tokens[at - 1].text in ("out", "away")
        return _cut(tokens, at, end) if ends and gone else tokens
    if verbs[-1:] == ["remove"] and at + 1 < len(tokens) and means("aims", tokens[at + 1].text):
        return _cut(tokens, at, _end(tokens, at + 1))
    words = [token.text for token in tokens[at + 1 : at + 3]]
    makes = words[:1] and words[0] in ("make", "form", "create", "get") and words[1:] and words[1] in ("a", "an", "one")
    joined = any(token.text == "together" for token in tokens[begin:at])
    return _cut(tokens, at, _end(tokens, at + 1)) if makes and joined else tokens


def _person(tokens: Sequence[Token], at: int) -> int:
    """How many tokens name somebody who does something; 0 where it is a thing: "I", "four kids", "whoever sits there".

    Who is named by more than a word is followed to what they can do, or see.
    """
    begun = at
    while at < len(tokens) and (tokens[at].kind == "number" or means("before_persons", tokens[at].text)):
        at += 1
    if at >= len(tokens) or not (means("anybody", tokens[at].text) or grammar().knows(tokens[at].text, "people")):
        return 0
    for after in range(at + 1, min(at + MOST_OF_PERSON, len(tokens))):
        if tokens[after].kind == "mark":
            break
        if any(longest(section, tokens, after) is not None for section in ("able", "unable", "seeing")):
            return after - begun
    return at + 1 - begun


def _placed(tokens: Sequence[Token], at: int) -> bool:
    """Whether a place follows that names a thing: "in front of the mirror", not "at it", "in teams"."""
    found = grammar().at(tokens, at, "prepositions")
    after = at + found.length if found is not None else at
    return found is not None and after < len(tokens) and tokens[after].text in _NAMING


def _without_from(tokens: Sequence[Token]) -> list[Token]:
    """What is seen, without "from it", "from there", "from the desk"."""
    at = next((n for n, token in enumerate(tokens) if token.text == "from"), len(tokens))
    return list(tokens[:at])


def _end(tokens: Sequence[Token], at: int) -> int:
    """Where what begins there ends: with the sentence, or before another order."""
    for end in range(at, len(tokens)):
        if tokens[end].text in ENDS:
            return end
        if tokens[end].text in _PARTING and starts_with_verb(tokens, end + 1):
            return end
    return len(tokens)


def _cut(tokens: Sequence[Token], at: int, end: int) -> list[Token]:
    begin = at - 1 if at and tokens[at - 1].text == "," else at
    return [*tokens[:begin], *tokens[end:]]


def _without_told_reason(tokens: Sequence[Token]) -> list[Token]:
    """The tokens without what people do, before ", so (move it)": "it" is then what they do it with, named last.

    What is told of a thing, "the desk is too small, so", is read with the order.
    """
    person = _person(tokens, 0)
    at = next((n for n in range(1, len(tokens) - 1) if tokens[n].text == "so" and tokens[n - 1].text == ","), 0)
    verb = at + 1 + (tokens[at + 1].text == "please" if at else 0)
    ordered = any(longest(section, tokens, verb) is not None for section in ("verbs", "resizing"))
    read = any(longest(section, tokens, 0) is not None for section in ("verbs", "dislikes", "obtained"))
    if not (person and at and ordered) or read or any(token.text in ENDS for token in tokens[:at]):
        return list(tokens)
    again = next((n for n in range(verb + 1, min(verb + 3, len(tokens))) if tokens[n].text in _AGAIN), None)
    begin = next((n for n in range(at - 2, person - 1, -1) if tokens[n].text in _NAMING), None)
    if again is None:
        return list(tokens[verb:])
    if begin is None:
        return list(tokens)
    return [*tokens[verb:again], *tokens[begin : at - 1], *tokens[again + 1 :]]


def _untold(tokens: list[Token]) -> list[Token]:
    """The tokens without what people are told of at the end of an order: "(remove the rug), we never use it"."""
    left = list(tokens)
    for at in reversed(range(2, len(tokens))):
        told = tokens[at - 1].text == "," and _person(tokens, at) and longest("verbs", tokens, at) is None
        end = next((n for n in range(at, len(tokens)) if tokens[n].text in ENDS), len(tokens))
        if not told or any(token.text == "," for token in tokens[at:end]) or end < at + 3:
            continue
        again = tokens[end - 1].text in (*_FROM_IT, "anymore", "more")
        ordered = any(tokens[n - 1].text in _PARTING and starts_with_verb(tokens, n) for n in range(at + 1, end))
        if again and not ordered:
            del left[at - 1 : end]
    return left


def without_given(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "if there is a plant, move it" as "move the plant": where there is none, that is said."""
    words = [token.text for token in tokens[:4]]
    begin = 4 if words[:1] == ["if"] and words[1:3] in (["there", "is"], ["there", "are"]) else 0
    end = next((n for n, token in enumerate(tokens) if token.text == ","), 0)
    if not begin or words[3] not in ("a", "an", "any", "some", "still") or not begin < end <= begin + MOST_OF_PERSON:
        return list(tokens)
    at = next((n for n in range(end + 1, len(tokens)) if tokens[n].text in _AGAIN), None)
    named = [token for token in tokens[begin:end] if token.text not in ("a", "an", "any", "some", "still")]
    if at is None or any(token.text in (*ENDS, ",") for token in tokens[end + 1 : at]):
        return list(tokens)
    the = structs.replace(tokens[3], text="the")
    return [*tokens[end + 1 : at], the, *named, *tokens[at + 1 :]]


def _views_first(tokens: list[Token]) -> list[Token]:
    """The tokens with "I can't see the TV from the chairs, turn them" as "turn the chairs so that it faces the TV"."""
    person = _person(tokens, 0)
    lacks = longest("unable", tokens, person) if person else None
    seen = longest("seeing", tokens, person + lacks[1]) if lacks is not None else None
    if lacks is None or seen is None:
        return tokens
    begin = person + lacks[1] + seen[1]
    end = next((n for n in range(begin, len(tokens)) if tokens[n].text in (*ENDS, ",")), len(tokens))
    whence = next((n for n in range(begin, end) if tokens[n].text == "from"), None)
    verb = end + 1 + sum(token.text in ("so", "please") for token in tokens[end + 1 : end + 3])
    found = longest("verbs", tokens, verb) if verb < len(tokens) else None
    again = verb + found[1] if found is not None else len(tokens)
    if whence is None or found is None or again >= len(tokens) or tokens[again].text not in _AGAIN:
        return tokens
    faces = [structs.replace(token, start=-1) for token in tokenise("so that it faces")]
    about = tokens[whence + 1 : end]
    return [*tokens[verb:again], *about, *faces, *tokens[begin:whence], *tokens[again + 1 :]]
