"""Turns of speech that are cut out as a whole, since nobody here follows them; and corrections that can be followed."""

from collections.abc import Sequence

from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.tokens import Token

TAKEN_BACK = "taken_back"
"""What stands before what is not to be there after all: "on second thought, no rug"."""
_LONGEST_TURN = 40
"""Most tokens of a turn that goes on to the end of a clause."""
_PLACING = ("let", "put", "place", "move", "have", "make", "set", "hang", "turn")
"""Orders after which it is told where something is to be."""
_IT = ("it", "them")
_STOPS = ".;!?)\n"
_AFTER = ("and", "but", "or", "oh", "well", "then", "now", "please")


def correction_at(tokens: Sequence[Token], at: int) -> int:
    """How many tokens the words before what corrects the last thing have: "no, make that", "actually,"; 0 for none."""
    if not _begins(tokens, at):
        return 0
    end = at
    if _is_no(tokens, at):
        end = at + 2
    while (found := grammar().at(tokens, end, "turns")) is not None and found.value in ("correction", "remake"):
        end += found.length
        if end < len(tokens) and tokens[end].text in (",", ":"):
            end += 1
    return end - at if end > at and not _is_placing(tokens, at) else 0


def moved_at(tokens: Sequence[Token], at: int) -> int:
    """How many tokens "no, let it" has after a correction, where it is told where that is to be; 0 for none."""
    start, end = at, at
    while end < len(tokens) and tokens[end].text in ("no", "nope", ","):
        end += 1
    words = [token.text for token in tokens[end : end + 2]]
    if len(words) < len(("let", "it")) or words[0] not in _PLACING or words[1] not in ("it", "them"):
        return 0
    end += len(words)
    said = grammar().at(tokens, end, "verbs", "prepositions") if end < len(tokens) else None
    placed = said is not None and (said.sort == "prepositions" or said.value in ("face", "face_away", "stand", "hang"))
    return end - start if placed else 0


def turn_at(tokens: Sequence[Token], at: int) -> int:
    """Read corrections, "the same on the other side", "where the desk would usually be"."""
    begins = _begins(tokens, at)
    if begins and _is_no(tokens, at):
        return _until(tokens, at + 1, sentence=_is_new_sentence(tokens, at)) + 1
    found = grammar().at(tokens, at, "turns")
    if found is not None and not _is_placing(tokens, at) and not _is_filler(tokens, at, found.length):
        after = grammar().at(tokens, at + found.length, "determiners", "count")
        if found.value == "phrase":
            link = grammar().at(tokens, at, "prepositions")
            return found.length if link is None or link.length <= found.length else 0
        if found.value == "clause":
            return _until(tokens, at, sentence=False)
        if begins and not _is_goal(tokens, at) and (found.value != "remake" or (after is not None and at > 0)):
            return _until(tokens, at, sentence=_is_new_sentence(tokens, at))
    if tokens[at].text in grammar().lists["turned"] and (at + 1 == len(tokens) or tokens[at + 1].kind == "mark"):
        return 1
    if tokens[at].text == "where":
        end = _until(tokens, at, sentence=False)
        said = next((i for i in range(at, at + end) if tokens[i].text in grammar().lists["supposing"]), None)
        if said is None:
            return end if _is_place_of_it(tokens, at, at + end) else 0
        being = (i for i in range(said, at + end) if tokens[i].text in ("be", "stand", "go"))
        return next(being, at + end - 1) + 1 - at
    if tokens[at].text in ("out", "of", "in") and (length := _of_every(tokens, at)):
        return length
    return 0


def _is_place_of_it(tokens: Sequence[Token], start: int, end: int) -> bool:
    """Whether it is told what a place is good for: "where the pupils can see it", "where it gives good light"."""
    if end - start < len(("where", "it", "shines")):
        return False
    reached = tokens[end - 1].text in _IT and grammar().at(tokens, end - 2, "prepositions") is None
    return tokens[start + 1].text in _IT or reached


def _is_goal(tokens: Sequence[Token], at: int) -> bool:
    """Whether it is told what somebody is to do: "Task: move the box"."""
    return at > 1 and tokens[at - 1].text == ":" and tokens[at - 2].text in grammar().lists["goals"]


def _is_filler(tokens: Sequence[Token], at: int, length: int) -> bool:
    """Whether more words than these say nothing: "wherever you like"."""
    filler = grammar().at(tokens, at, "fillers")
    return filler is not None and filler.length > length


def _is_placing(tokens: Sequence[Token], at: int) -> bool:
    """Whether "hang on the wall" says where something is, rather than "hang on" that something was wrong."""
    verb, link = grammar().at(tokens, at, "verbs"), grammar().at(tokens, at + 1, "prepositions")
    after = at + 1 + link.length if link is not None else 0
    return verb is not None and bool(after) and grammar().at(tokens, after, "determiners", "count") is not None


def _is_no(tokens: Sequence[Token], at: int) -> bool:
    """Whether a correction begins: "no, make that three", "no, three"."""
    if tokens[at].text not in ("no", "nope") or at + 2 >= len(tokens) or (at and tokens[at - 1].text == "?"):
        return False
    if tokens[at + 1].text not in (",", ":", "–", "—"):
        return False
    after = grammar().all_at(tokens, at + 2, "determiners", "count", "turns", "negations", "verbs")
    return any(f.sort in ("count", "turns") or f.value in ("a", "the", "another", "not", "put") for f in after) or (
        tokens[at + 2].kind == "number"
    )


def _of_every(tokens: Sequence[Token], at: int) -> int:
    """Read "out of every five", "in every five", without a noun after it."""
    start = at + 1 if tokens[at].text != "out" else at + 2
    if start + 1 >= len(tokens) or tokens[start].text not in ("every", "each"):
        return 0
    number = grammar().at(tokens, start + 1, "count")
    length = 1 if tokens[start + 1].kind == "number" else number.length if number is not None else 0
    return start + 1 + length - at if length else 0


def _until(tokens: Sequence[Token], at: int, *, sentence: bool) -> int:
    """The length up to the end of the sentence, or to the next mark."""
    for end in range(at + 1, min(len(tokens), at + _LONGEST_TURN)):
        if tokens[end].kind == "mark" and (not sentence or tokens[end].text in _STOPS):
            return end - at
        if not sentence and tokens[end].text == "and" and _is_new_thing(tokens, end + 1):
            return end - at
    return min(len(tokens), at + _LONGEST_TURN) - at


def _is_new_thing(tokens: Sequence[Token], at: int) -> bool:
    """Whether "a", "two" comes, and with it something new."""
    found = grammar().all_at(tokens, at, "determiners", "count")
    return any(f.sort == "count" or f.value in ("a", "another") for f in found)


def _begins(tokens: Sequence[Token], at: int) -> bool:
    """Whether a clause may begin at `at`."""
    return at == 0 or tokens[at - 1].kind == "mark" or tokens[at - 1].text in _AFTER


def _is_new_sentence(tokens: Sequence[Token], at: int) -> bool:
    while at and tokens[at - 1].text in _AFTER:
        at -= 1
    return at == 0 or tokens[at - 1].text in _STOPS
