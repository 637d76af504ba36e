"""A clause in other words, as one of the orders that are carried out: "give the desk a lamp" adds one to it."""

from collections.abc import Sequence
from dataclasses import replace

from msgspec import structs

from thinkblox.editing.grammar import longest, means
from thinkblox.editing.reading.clause import BRINGS, ENDS, LINKS, TO, WANTS, Clause, ends_at
from thinkblox.editing.reading.clause_starts import wished_at
from thinkblox.errors import InputError
from thinkblox.reading.english.grammar import grammar, is_count
from thinkblox.reading.lexicon import load
from thinkblox.reading.tokens import Token, tokenise

_CHAIRS = Token("chairs", "chairs", "word", start=-1)
_PLATES = Token("plates", "plates", "word", start=-1)
_LAID = ("the", "it", "my", "our", "each", "every", "both", "them")
_TOGETHER = Token("together", "together", "word", start=-1)
_APART = Token("apart", "apart", "word", start=-1)
_OF = Token("of", "of", "word", start=-1)
MOST_OF_NAME = 3
"""Most words of a name before the last that joins it."""
_IN = frozenset(("in", "inside", "with"))
_BY_WALL = frozenset(("against", "along", "under"))
"""Where things that are pushed "together" can come to stand so."""


def of_lacking(clause: Clause) -> Clause:
    """A clause by which something is added to those that have none, as one by which each is to have it."""
    lacking = _without(clause.tokens, "lacking") if clause.doing in ("add", "put") else None
    if lacking is None:
        return clause
    at = next(n for n in range(len(clause.tokens)) if longest("lacking", clause.tokens, n) is not None)
    the = next((n for n in range(at - 1, max(at - 4, 0), -1) if lacking[n].text == "the"), None)
    if the is not None:
        lacking = (*lacking[:the], structs.replace(lacking[the], text="every"), *lacking[the + 1 :])
    return Clause("ensure", "", lacking, clause.text)


def turned_about(clause: Clause) -> Clause:
    """A clause as one of the orders that are carried out: "give the desk a lamp" adds one to it."""
    tokens = clause.tokens
    if clause.doing == "unwanted":
        if any(grammar().at(tokens, n, "prepositions") is not None for n in range(len(tokens))):
            raise InputError(f"'{clause.text}' says what is not to be done; say what is")
        return Clause("remove", "", tokens, clause.text)
    if clause.doing in ("seat", "put"):
        return _seated(clause) if clause.doing == "seat" else _laid(clause) or _fewer(clause) or clause
    if clause.doing == "copy":
        if not tokens or tokens[0].text in ("all", "both", "every", "each", "everything"):
            raise InputError(f"'{clause.text}' does not say of what there is to be another one; name one thing")
        pointed = tokens[0].text in ("the", "this", "that")
        body = (structs.replace(tokens[0], text="another"), *tokens[1:]) if pointed else tokens
        return Clause("add", "", body, clause.text)
    if clause.doing in ("gather", "spread"):
        return _gathered_or_spread(clause)
    if clause.doing in (*BRINGS, "give") and (fewer := _fewer(clause)) is not None:
        return fewer
    if clause.doing != "give":
        return clause
    linked = next((n for n, t in enumerate(tokens) if t.text == "with"), None)
    given = next((n for n in range(1, len(tokens)) if _is_given(tokens, n)), None)
    linked = None if given is not None and linked is not None and given < linked else linked
    at = linked if linked is not None else given
    if at is None:
        raise InputError(f"'{clause.text}' does not say what is added to what")
    return Clause("add", "", had_by(tokens[at + (linked is not None) :], tokens[:at]), clause.text)


def _is_counted_only(tokens: Sequence[Token]) -> bool:
    """Whether it says how many there are to be in all: "(I want) only three chairs"."""
    only = len(tokens) > 1 and tokens[0].text in ("only", "just")
    return only and is_count(tokens, 1)


def given_as(clause: Clause) -> Clause:
    """The clause, where "get it a chair" gives it one, and "(I want) only three chairs" is how many there are to be."""
    if clause.doing in WANTS and _is_counted_only(clause.tokens):
        return replace(clause, doing="ensure", tokens=clause.tokens[1:])
    words = [token.text for token in clause.tokens[:2]]
    got = clause.doing == "move" and clause.text.lower().split()[:1] == ["get"]
    gives = words[:1] in (["it"], ["them"]) and words[1:] in (["a"], ["an"], ["another"], ["some"])
    return replace(clause, doing="give") if got and gives else clause


def _laid(clause: Clause) -> Clause | None:
    """Read "set the table with six plates", "lay the table for four", as what comes onto that; None where it is other.

    What is set for so many gets a plate for each.
    """
    tokens = [token for token in clause.tokens if token.text not in ENDS]
    at = next((n for n, token in enumerate(tokens) if token.text in ("with", "for")), 0)
    verb, pointed = clause.text.lower().split(" ", 1)[0], tokens[:1] and tokens[0].text in _LAID
    if verb not in ("set", "lay") or not at or not pointed or len(tokens) < at + 2:
        return None
    counted = is_count(tokens, at + 1)
    if tokens[at].text == "with" and (counted or tokens[at + 1].text in ("a", "an", "some")):
        return Clause("add", "", (*tokens[at + 1 :], TO, *tokens[:at]), clause.text)
    people = tokens[at + 2 :] and grammar().knows(tokens[at + 2].text, "people")
    if tokens[at].text == "for" and counted and (len(tokens) == at + 2 or people):
        return Clause("add", "", (tokens[at + 1], _PLATES, TO, *tokens[:at]), clause.text)
    return None


def _gathered_or_spread(clause: Clause) -> Clause:
    """Things that come together, or further apart, as an order to move them.

    Raises:
        InputError: they are to be spread over somewhere.
    """
    tokens = [t for t in clause.tokens if t.text not in ("together", "apart", "out")]
    in_rows = {m for n in range(len(tokens)) if (row := longest("rows", tokens, n)) for m in range(n, n + row[1])}
    said = (grammar().at(tokens, n, "prepositions") for n in range(len(tokens)) if n not in in_rows)
    placed = {str(found.value) for found in said if found is not None} - {"of"}
    if clause.doing == "gather" and clause.text.lower().startswith("pair"):
        of_two = (structs.replace(token, start=-1) for token in tokenise("into groups of two"))
        return Clause("move", "", (*(token for token in tokens if token.text not in ENDS), *of_two), clause.text)
    if clause.doing == "gather":
        faced = any(grammar().at(tokens, n, "mutual") is not None for n in range(len(tokens)))
        kept = _BY_WALL if _says_together(clause) else frozenset()
        word = () if placed - _IN - kept or faced else (_TOGETHER,)
        return Clause("move", "", (*tokens, *word), clause.text)
    if clause.doing == "spread" and (over := _without(tokens, "all_over")) is not None:
        return Clause("spread", "", over, clause.text)
    if placed - {"by", "from"}:
        raise InputError(f"'{clause.text}': how things are spread over a place is not followed; say where each goes")
    return Clause("move", "", (*tokens, _APART), clause.text)


def _says_together(clause: Clause) -> bool:
    """Whether its verb is that of "push together"."""
    return "together" in clause.text.lower().split()


def _without(tokens: Sequence[Token], section: str) -> tuple[Token, ...] | None:
    """The tokens without the phrases of a section; None where there is none of them."""
    left: list[Token] = []
    index, found = 0, False
    while index < len(tokens):
        phrase = longest(section, tokens, index)
        found |= phrase is not None
        left += tokens[index : index + 1] if phrase is None else []
        index += phrase[1] if phrase is not None else 1
    return tuple(left) if found else None


def _fewer(clause: Clause) -> Clause | None:
    """Read "I want two tables fewer", "one chair less", as an order to take so many away.

    Raises:
        InputError: it says that of each of several, or of what is nothing that can be counted.
    """
    tokens = clause.tokens
    at = next((n for n, t in enumerate(tokens) if t.text in ("less", "fewer") and not _is_bound(tokens, n)), None)
    if at is None:
        return None
    if any(t.text == "all" for t in tokens) or (at + 1 < len(tokens) and tokens[at + 1].text == "than"):
        raise InputError(f"'{clause.text}' does not say which go; say 'remove two of the tables'")
    return Clause("remove", "", (*tokens[:at], *tokens[at + 1 :]), clause.text)


def _is_bound(tokens: Sequence[Token], at: int) -> bool:
    """Whether it belongs to "no less than"."""
    return any(start <= at < start + found[1] for start in range(max(0, at - 2), at + 1)
               if (found := longest("bounds", tokens, start)) is not None)  # fmt: skip


def _seated(clause: Clause) -> Clause:
    """So many chairs as people are to sit there.

    Raises:
        InputError: it is not said how many.
    """
    people = next((n for n, t in enumerate(clause.tokens) if grammar().knows(t.text, "people")), None)
    if clause.tokens and means("markers", clause.tokens[0].text) == "only":
        clause = replace(clause, tokens=clause.tokens[1:])
        people = people - 1 if people is not None else None
    counted = is_count(clause.tokens, 0)
    if not counted:
        raise InputError(f"'{clause.text}' does not say how many are to sit there; say 'six people'")
    rest = clause.tokens[1 if people is None else people + 1 :]
    return Clause("ensure", "", (clause.tokens[0], _CHAIRS, *rest), clause.text)


def _is_given(tokens: Sequence[Token], at: int) -> bool:
    """Whether what is given begins there: "a lamp", "two more books"; not in "give the desk by a window ..."."""
    counted = is_count(tokens, at)
    begins = counted or tokens[at].text in ("a", "an", "another", "some", "more", "its", "their")
    return begins and grammar().at(tokens, at - 1, "prepositions") is None and tokens[at - 1].text not in LINKS


def _is_part(tokens: Sequence[Token], at: int) -> bool:
    """Whether part of a thing is all that follows: "(on its) left side"."""
    found = grammar().at(tokens, at, "parts")
    return found is not None and at + found.length >= len(tokens)


def had_by(body: Sequence[Token], whose: Sequence[Token]) -> tuple[Token, ...]:
    """What is to be added to things that "should have" it: "a plant on it" is on them, "four chairs" go to them."""
    rest = [token for token in body if token.text not in ENDS]
    own = next((n for n, t in enumerate(rest) if t.text in ("its", "their") and _is_part(rest, n + 1)), None)
    if own is not None:
        return (*rest[:own], structs.replace(rest[own], text="the"), *rest[own + 1 :], _OF, *whose)
    along = next((n for n, token in enumerate(rest) if n and token.text == "with" and not _is_in_name(rest, n)), None)
    if along is not None:
        return (*rest[:along], TO, *whose, *rest[along:])
    if rest and rest[-1].text in ("it", "them"):
        return (*rest[:-1], *whose)
    spared = next((n for n in range(len(rest)) if _spares(rest, n)), len(rest))
    return (*rest[:spared], TO, *whose, *rest[spared:])


def _is_in_name(tokens: Sequence[Token], at: int) -> bool:
    """Whether a word belongs to the name of a thing: "with" of "a vase with flowers"."""
    names = ((n, load("en").longest(list(tokens), n)) for n in range(max(0, at - MOST_OF_NAME), at))
    return any(found.entry("object") is not None and at < n + found.length for n, found in names)


def _spares(tokens: Sequence[Token], at: int) -> bool:
    """Whether what is excepted begins there."""
    found = grammar().at(tokens, at, "prepositions")
    return found is not None and found.value == "except"


def settled(clause: Clause) -> Clause:
    """A clause by what it says is to have been done ("the rug removed") and how a thing is to be ("to be blue")."""
    tokens, doing = list(clause.tokens), clause.doing
    if doing in WANTS:
        doing = "put"
        for index in range(1, len(tokens)):
            found = longest("wishes", tokens, index)
            if found is None:
                continue
            start = wished_at(tokens, 0, index, *found)
            doing, tokens = start.doing, [*start.before, *tokens[start.body :]]
            tokens = list(had_by(tokens, start.whose)) if start.whose else tokens
            break
    if doing == "put" and clause.doing in ("put", *WANTS):
        for index in range(1, len(tokens)):
            done = longest("done", tokens, index) if tokens[index - 1].text != "," else None
            if done is not None and _goes_on(tokens, index + done[1]):
                _check_one(clause, tokens[:index])
                return Clause(done[0], "", tuple(tokens[:index] + tokens[index + done[1] :]), clause.text)
    return Clause(doing, clause.change, tuple(tokens), clause.text)


def _check_one(clause: Clause, tokens: Sequence[Token]) -> None:
    """Refuse "I want the tv on the wall and the rug gone", of which only the last may be meant to be gone.

    Raises:
        InputError: several things are named, of which the first have a place.
    """
    links = [n for n, token in enumerate(tokens) if token.text in (",", "and")]
    placed = any(grammar().at(tokens, n, "prepositions") is not None for n in range(links[-1] if links else 0))
    if placed:
        raise InputError(f"'{clause.text}' can be read in two ways; give an order for each of the things")


def _goes_on(tokens: Sequence[Token], at: int) -> bool:
    """Whether a participle ends there: at the end, or before how or where to."""
    if ends_at(tokens, at):
        return True
    after = tokens[at]
    return (
        after.kind == "number"
        or after.text in ("by", "with", "to", "from", "out", "so", "a", "half", "closer", "nearer", "further")
        or grammar().at(tokens, at, "prepositions", "count") is not None
        or longest("directions", tokens, at) is not None
        or longest("markers", tokens, at) is not None
    )
