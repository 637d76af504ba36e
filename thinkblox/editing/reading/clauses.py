"""An instruction cut to clauses: what each asks to be done, and the words that it says it with."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from thinkblox.editing.grammar import longest, means
from thinkblox.errors import InputError
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token

ENDS = (".", ";", "!", "?", "\n")
_POINTERS = frozenset(
    "the a an both all it them my every each that this these those another some only just its their our any no more"
    " everything nothing half one".split()
)
"""Words after a verb in the middle of a sentence, by which it is told from a noun."""
_LINKS = (",", "and", "then", "but", "also", "while", "plus")
_PLACING = ("at", "around", "by", "next_to", "near", "on", "in", "behind", "in_front_of", "against", "above", "under")
"""Prepositions by which an announcement says where what it is about is to come."""
MOST_NAMED = 6
"""Most words of a place that an announcement ends with."""
_RELATIVE = ("so", "that", "which", "who")
_GONE = ("go", "leave", "disappear")
_WANTS = ("want",)
_BRINGS = ("add", "want", "ensure")
_NEWS = ("add", "put", "want")
_ANNOUNCING = ("want", "make", "rearrange", "ensure", "clear", "free")
_AGAIN = ("it", "its", "them", "their", "they")
_NOT = Token("not", "not", "word", start=-1)
_COMMA = Token(",", ",", "mark", start=-1)
_TO = Token("to", "to", "word", start=-1)
_NOTHING = ("nothing",)
_WITH = Token("with", "with", "word", start=-1)
_THE = Token("the", "the", "word", start=-1)
_CHAIRS = Token("chairs", "chairs", "word", start=-1)
_PLATES = Token("plates", "plates", "word", start=-1)
_LAID = ("the", "it", "my", "our", "each", "every", "both", "them")
_TOGETHER = Token("together", "together", "word", start=-1)
_APART = Token("apart", "apart", "word", start=-1)
_IS = Token("is", "is", "word", start=-1)
_ON = Token("on", "on", "word", start=-1)
_OF = Token("of", "of", "word", start=-1)
_IN = frozenset(("in", "inside", "with"))
_BY_WALL = frozenset(("against", "along", "under"))
"""Where things that are pushed "together" can come to stand so."""
_FROM = Token("from", "from", "word", start=-1)
_OUT_OF_WAY = tuple(Token(word, word, "word", start=-1) for word in ("out", "of", "the", "way", "of"))


@dataclass(frozen=True)
class Clause:
    """One order of an instruction.

    Attributes:
        doing: what is to be done, a key of the grammar's verbs.
        change: how the room changes by the verb alone ("lengthen").
        tokens: what it says after the verb; of a wish without what makes it one.
        text: the clause as it was written.
    """

    doing: str
    change: str
    tokens: tuple[Token, ...]
    text: str


@dataclass(frozen=True)
class _Start:
    """Where a clause begins and where its words go on, with those that come before."""

    begin: int
    body: int
    doing: str
    change: str = ""
    before: tuple[Token, ...] = ()
    denied: bool = False
    whose: tuple[Token, ...] = ()


def clauses(tokens: Sequence[Token], named: Mapping[int, str], unknown: list[str]) -> list[Clause]:
    """The clauses of an instruction; what comes before the first and means nothing is added to `unknown`.

    Args:
        tokens: of the whole instruction.
        named: ids of objects by where the words for them begin.
        unknown: takes what means nothing.

    Raises:
        InputError: it depends on a condition, asks for an edit to be taken back, or says only what is not to be done.
    """
    tokens = _pointed(_gathered(_without_courtesy(tokens)), named)
    _check(tokens, named)
    tokens = _led(tokens)
    starts, lead = _begun(tokens)
    told, about, blocked, disliked = lead, _about(lead), _blocked(lead), _disliked(lead)
    new = _obtained(lead)
    lead = [] if about or disliked or new or _is_reason(lead) else lead
    unknown += [t.shown for t in lead if t.kind == "word" and not _is_filler(lead, t)]
    made = []
    refused: tuple[Token, ...] = ()
    for number, start in enumerate(starts):
        end = starts[number + 1].begin if number + 1 < len(starts) else len(tokens)
        text = spoken(tokens[start.begin : end], named)
        body = (*start.before, *tokens[start.body : end])
        if not number and about:
            body = _compared_with(told, body)
        if not number and new and body[:1] and body[0].text in ("it", "them") and start.doing in ("move", "put"):
            body, start = (*new, *body[1:]), replace(start, doing="put")
        elif not number and (about or disliked) and body[:1] and body[0].text in ("it", "them"):
            alone = _ends(body, 1) and start.doing in ("move", "put")
            body = (
                *(about or disliked),
                *(_OUT_OF_WAY if alone and blocked else ()),
                *(blocked if alone else ()),
                *body[1:],
            )
        elif not number and ((disliked and start.doing in _NEWS) or (about and _is_of_other(start, body))):
            body = (*(about or disliked), _WITH, *(token for token in body if token.text != "instead"))
            start = replace(start, doing="replace")
        if start.whose:
            body = _had(body, start.whose)
        clause = _settled(_turned_about(_given(_of_lacking(Clause(start.doing, start.change, body, text)))))
        if start.denied and start.doing in _BRINGS:
            continue
        clause, refused = _not_there(clause, refused), ()
        if start.denied and clause.doing == "put" and number + 1 < len(starts) and _is_known_at(clause.tokens):
            refused = clause.tokens
            continue
        if start.denied and clause.doing in ("put", "keep", "make", "free"):
            raise InputError(f"'{text}' says what is not to be done; say what is")
        made += _denied(clause) if start.denied else [clause]
    return made


def _begun(tokens: Sequence[Token]) -> tuple[list[_Start], Sequence[Token]]:
    """Where the clauses begin, and what comes before the first."""
    starts = _going_on(tokens, list(_starts(tokens))) or _asked_for(tokens)
    lead: Sequence[Token] = tokens[: starts[0].begin] if starts else tokens
    if starts and _is_terse(lead):
        starts = [_Start(_first(lead), _first(lead), "want"), *starts]
        lead = tokens[: starts[0].begin]
    return _unwanted(tokens, starts, lead)


def _going_on(tokens: Sequence[Token], starts: list[_Start]) -> list[_Start]:
    """The clauses, where "(the armchair should be red) and face the door" says more of what the wish is about."""
    left: list[_Start] = []
    for start in starts:
        wished = bool(left) and left[-1].doing == "put" and bool(left[-1].before)
        linked = start.begin > 0 and tokens[start.begin - 1].text == "and" and tokens[start.begin].text == "face"
        if wished and linked and start.doing == "turn" and start.body == start.begin + 1:
            it = replace(_TO, text="it", shown="it")
            start = replace(start, doing="put", body=start.begin, before=(it,))
        left.append(start)
    return left


def _is_known_at(tokens: Sequence[Token]) -> bool:
    """Whether it names a thing that is there, and a place: "(don't put) the play table near the window"."""
    placed = _placed_at(tokens)
    return placed is not None and tokens[0].text in ("the", "my", "our", "that", "this")


def _placed_at(tokens: Sequence[Token]) -> int | None:
    return next((n for n in range(1, len(tokens)) if grammar().at(tokens, n, "prepositions") is not None), None)


def _not_there(clause: Clause, refused: Sequence[Token]) -> Clause:
    """What is put "by the bookcase", with where it is not: "don't put the table near the window; put it by the ..."."""
    again = clause.tokens[:1] and clause.tokens[0].text in ("it", "them") and clause.doing in ("put", "move")
    if not refused or not again:
        return clause
    said = [token for token in refused if token.text not in (*ENDS, ",", "but")]
    at = _placed_at(said) or len(said)
    body = [token for token in clause.tokens[1:] if token.text not in ENDS]
    return replace(clause, tokens=(*said[:at], *body, _COMMA, _NOT, *said[at:]))


def _denied(clause: Clause) -> list[Clause]:
    """What is not to be done, by which things stay as they are: "don't remove the sofa, only the rug" takes the rug."""
    tokens = clause.tokens
    at = next((n for n in range(1, len(tokens) - 1) if tokens[n].text in ("only", "just", "rather")
               and tokens[n - 1].text in (",", "but")), None)  # fmt: skip
    if at is None:
        return [Clause("keep", "", tokens, clause.text)]
    end = next(n for n in range(at, 0, -1) if tokens[n - 1].text not in (",", "but"))
    return [Clause("keep", "", tokens[:end], clause.text), replace(clause, tokens=tokens[at + 1 :])]


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
    first, said = _first(rest), _start(lead, _first(lead), first=True) if _first(lead) < len(lead) else None
    start = _start(rest, first, first=True) if first < len(rest) else None
    if start is None and said is not None and _is_list_of_new(lead, said, rest):
        return [*tokens[:begin], replace(tokens[at], text="add", kind="word"), *rest]
    if start is None:
        return [*tokens[:begin], *lead, *rest]
    end = next((n for n in range(first, len(rest)) if rest[n].text in ENDS), len(rest))
    again = any(token.text in _AGAIN for token in rest[first:end])
    if again or (said is not None and said.doing not in _ANNOUNCING):
        return [*tokens[:begin], *lead, replace(tokens[at], text="."), *rest]
    if said is not None and start.doing == "keep" and start.before:
        subject = first + len(start.before)
        return [*tokens[:begin], *rest[:subject], _ON, *lead[said.body :], *rest[subject:]]
    alone = not any(grammar().at(rest, n, "prepositions") for n in range(first, end))
    where = _place_at_end(lead) if start.doing in ("add", "put") and alone else []
    return [*tokens[:begin], *rest[:end], *where, *rest[end:]]


def _is_list_of_new(lead: Sequence[Token], said: _Start, rest: Sequence[Token]) -> bool:
    """Whether a colon leads from what is to be done to what is to come for it: "Set the table: a glass for each"."""
    whole = said.doing in _NEWS and said.body < len(lead) and lead[said.body].text in ("the", "my", "our")
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
        if things or not rest or list(_starts(told)) or longest("dislikes", told, 0):
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


def _unwanted(
    tokens: Sequence[Token], starts: list[_Start], lead: Sequence[Token]
) -> tuple[list[_Start], Sequence[Token]]:
    """The clauses without "I don't want the lamp by the door, (move it)", which tells what the next one is about."""
    if len(starts) < 2 or starts[0].doing != "unwanted" or tokens[starts[1].body].text not in ("it", "them"):
        return starts, lead
    said = tokens[starts[0].body : starts[1].begin]
    placed = next((n for n in range(len(said)) if grammar().at(said, n, "prepositions") is not None), None)
    if placed is None or not placed:
        return starts, lead
    return starts[1:], [*said[:placed], _IS, *said[placed:]]


def _pointed(tokens: Sequence[Token], named: Mapping[int, str]) -> list[Token]:
    """The tokens with "the" before an id that a verb stands before, by which that is told from a noun: "stand it_2"."""
    left: list[Token] = []
    for index, token in enumerate(tokens):
        verb = longest("verbs", tokens, index - 1) if index else None
        if token.start in named and verb is not None and verb[1] == 1:
            left.append(_THE)
        left.append(token)
    return left


def _about(lead: Sequence[Token]) -> tuple[Token, ...]:
    """What a statement before an order is about, which "it" means there: "the desk is too close, move it back"."""
    first = _first(lead)
    told = next((n for n in range(first, len(lead)) if means("statements", lead[n].text)), first)
    pointed = told > first and lead[first].text in _POINTERS
    return tuple(lead[first:told]) if pointed else ()


def _blocked(lead: Sequence[Token]) -> tuple[Token, ...]:
    """What a thing is said to be in the way of: "the wardrobe blocks the window"."""
    for at in range(len(lead)):
        if (found := longest("blocking", lead, at)) is not None:
            return tuple(token for token in lead[at + found[1] :] if token.text not in (*ENDS, *_LINKS))
    return ()


def _compared_with(told: Sequence[Token], body: Sequence[Token]) -> tuple[Token, ...]:
    """An order with from what, or to what, a thing goes that is too close to it, or too far from it: "move it away"."""
    for last, token in enumerate(body):
        way, end = means("ways_off", token.text), last + 1
        few = longest("few", body, end)
        end += few[1] if few is not None else 0
        if not way or not all(t.text in (*ENDS, *_LINKS) for t in body[end:]):
            continue
        for at in range(len(told)):
            found = longest("too_far" if way == "nearer" else "too_near", told, at)
            if found is not None:
                known = (token for token in told[at + found[1] :] if token.text not in (*ENDS, *_LINKS))
                link = _TO if way == "nearer" else _FROM
                return (*body[: last + 1], link, *known, *body[last + 1 : end])
    return tuple(body)


def _is_of_other(start: _Start, body: Sequence[Token]) -> bool:
    """Whether another one of what was told of is asked for: "the rug is too small, get a bigger one"."""
    new = bool(body) and body[0].text in ("a", "an", "another")
    one = any(token.text == "one" for token in body) and not any(token.text in _LINKS for token in body)
    return new and one and start.doing in (*_NEWS, "move")


def _obtained(lead: Sequence[Token]) -> tuple[Token, ...]:
    """What a sentence says to be new: "we got a new side table"; empty where it is another."""
    for at in range(len(lead)):
        if (found := longest("obtained", lead, at)) is not None:
            end = at + found[1] - (2 if lead[at + found[1] - 1].text == "new" else 0)
            said = [token for token in lead[end:] if token.text not in (*ENDS, *_LINKS, "so", "new")]
            fits = bool(said) and (said[0].text in ("a", "an", "some", "another") or said[0].kind == "number")
            return tuple(token for token in said if not _is_filler(lead, token)) if fits else ()
    return ()


def _disliked(lead: Sequence[Token]) -> tuple[Token, ...]:
    """What is said not to be liked before an order."""
    first = _first(lead)
    found = longest("dislikes", lead, first)
    said = [t for t in lead[first + found[1] :] if t.text not in (*ENDS, *_LINKS)] if found is not None else []
    if said[:1] and said[0].text == "where" and means("statements", said[-1].text):
        said = said[1:-1]
    return tuple(said)


def told_before(tokens: Sequence[Token]) -> int:
    """How many tokens tell of a thing before the first order says what is to be done with it."""
    starts = list(_starts(tokens))
    begun = starts[0].begin if starts else 0
    starts, lead = _unwanted(tokens, starts, tokens[:begun])
    if starts and starts[0].begin > begun:
        return starts[0].begin
    return len(lead) if _about(lead) or _disliked(lead) or _obtained(lead) or _is_reason(lead) else 0


def _is_reason(lead: Sequence[Token]) -> bool:
    """Whether it only tells why: "there's no computer here any more, so (clear the desk)"."""
    return [token.text for token in lead[-2:]] == [",", "so"]


def _asked_for(tokens: Sequence[Token]) -> list[_Start]:
    """What is asked for without a verb: "a bigger bed please", "floor lamp behind the sofa"."""
    asked = any(token.text in ("please", "pls", "plz") for token in tokens) or _is_terse(tokens)
    first = _first(tokens)
    return [_Start(first, first, "want")] if asked and first < len(tokens) else []


def _is_terse(tokens: Sequence[Token]) -> bool:
    """Whether words name a thing and where or how it is to be, and no more: "bigger mirror", "desk under the window".

    What tells or asks something has a verb, what names nothing but a place begins with that.
    """
    first = _first(tokens)
    said = [token for token in tokens[first:] if token.text not in (*ENDS, ",", "and")]
    if len(said) < 2 or grammar().at(said, 0, "prepositions") is not None or means("anybody", said[0].text):
        return False
    verbs = any(
        grammar().at(said, n, "verbs", "conditions") is not None
        or any(longest(s, said, n) for s in ("conditions", "statements", "dislikes", "denials", "verbs"))
        for n in range(len(said))
    )
    placed = any(grammar().at(said, n, "prepositions") is not None for n in range(1, len(said) - 1))
    return not verbs and (placed or bool(means("comparatives", said[0].text)))


def _is_last(tokens: Sequence[Token], at: int) -> bool:
    return at >= len(tokens) or tokens[at].text in (*ENDS, ",", "please")


def _of_lacking(clause: Clause) -> Clause:
    """A clause by which something is added to those that have none, as one by which each is to have it."""
    lacking = _without(clause.tokens, "lacking") if clause.doing in ("add", "put") else None
    if lacking is None:
        return clause
    at = next(n for n in range(len(clause.tokens)) if longest("lacking", clause.tokens, n) is not None)
    the = next((n for n in range(at - 1, max(at - 4, 0), -1) if lacking[n].text == "the"), None)
    if the is not None:
        lacking = (*lacking[:the], replace(lacking[the], text="every"), *lacking[the + 1 :])
    return Clause("ensure", "", lacking, clause.text)


def _turned_about(clause: Clause) -> Clause:
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
        body = (replace(tokens[0], text="another"), *tokens[1:]) if pointed else tokens
        return Clause("add", "", body, clause.text)
    if clause.doing in ("gather", "spread"):
        return _gathered_or_spread(clause)
    if clause.doing in (*_BRINGS, "give") and (fewer := _fewer(clause)) is not None:
        return fewer
    if clause.doing != "give":
        return clause
    linked = next((n for n, t in enumerate(tokens) if t.text == "with"), None)
    given = next((n for n in range(1, len(tokens)) if _is_given(tokens, n)), None)
    linked = None if given is not None and linked is not None and given < linked else linked
    at = linked if linked is not None else given
    if at is None:
        raise InputError(f"'{clause.text}' does not say what is added to what")
    return Clause("add", "", _had(tokens[at + (linked is not None) :], tokens[:at]), clause.text)


def _given(clause: Clause) -> Clause:
    """The clause, where "get it a chair" says what something is to have as "give it a chair" does."""
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
    counted = tokens[at + 1].kind == "number" or grammar().at(tokens, at + 1, "count") is not None
    if tokens[at].text == "with" and (counted or tokens[at + 1].text in ("a", "an", "some")):
        return Clause("add", "", (*tokens[at + 1 :], _TO, *tokens[:at]), clause.text)
    people = tokens[at + 2 :] and grammar().knows(tokens[at + 2].text, "people")
    if tokens[at].text == "for" and counted and (len(tokens) == at + 2 or people):
        return Clause("add", "", (tokens[at + 1], _PLATES, _TO, *tokens[:at]), clause.text)
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
    if any(t.text in ("each", "every", "all") for t in tokens) or (
        at + 1 < len(tokens) and tokens[at + 1].text == "than"
    ):
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
    counted = bool(clause.tokens) and (
        clause.tokens[0].kind == "number" or grammar().at(clause.tokens, 0, "count") is not None
    )
    if not counted:
        raise InputError(f"'{clause.text}' does not say how many are to sit there; say 'six people'")
    rest = clause.tokens[1 if people is None else people + 1 :]
    return Clause("ensure", "", (clause.tokens[0], _CHAIRS, *rest), clause.text)


def _is_given(tokens: Sequence[Token], at: int) -> bool:
    """Whether what is given begins there: "a lamp", "two more books"; not in "give the desk by a window ..."."""
    counted = tokens[at].kind == "number" or grammar().at(tokens, at, "count") is not None
    begins = counted or tokens[at].text in ("a", "an", "another", "some", "more", "its", "their")
    return begins and grammar().at(tokens, at - 1, "prepositions") is None and tokens[at - 1].text not in _LINKS


def _is_part(tokens: Sequence[Token], at: int) -> bool:
    """Whether part of a thing is all that follows: "(on its) left side"."""
    found = grammar().at(tokens, at, "parts")
    return found is not None and at + found.length >= len(tokens)


def _had(body: Sequence[Token], whose: Sequence[Token]) -> tuple[Token, ...]:
    """What is to be added to things that "should have" it: "a plant on it" is on them, "four chairs" go to them."""
    rest = [token for token in body if token.text not in ENDS]
    own = next((n for n, t in enumerate(rest) if t.text in ("its", "their") and _is_part(rest, n + 1)), None)
    if own is not None:
        return (*rest[:own], replace(rest[own], text="the"), *rest[own + 1 :], _OF, *whose)
    along = next((n for n, token in enumerate(rest) if n and token.text == "with"), None)
    if along is not None:
        return (*rest[:along], _TO, *whose, *rest[along:])
    if rest and rest[-1].text in ("it", "them"):
        return (*rest[:-1], *whose)
    spared = next((n for n in range(len(rest)) if _spares(rest, n)), len(rest))
    return (*rest[:spared], _TO, *whose, *rest[spared:])


def _spares(tokens: Sequence[Token], at: int) -> bool:
    """Whether what is excepted begins there."""
    found = grammar().at(tokens, at, "prepositions")
    return found is not None and found.value == "except"


def spoken(tokens: Sequence[Token], named: Mapping[int, str]) -> str:
    """Words as they were written, without the marks at their ends."""
    text, skip, end = "", 0, -1
    for token in sorted(tokens, key=lambda token: token.start):
        if token.start < skip:
            continue
        shown = named.get(token.start, token.shown)
        if token.start in named:
            skip = token.start + len(named[token.start].rpartition("_")[0])
        close = token.kind == "mark" or (token.start == end and token.start >= 0) or not text
        text += shown if close else f" {shown}"
        end = token.start + len(token.shown) if token.glued is False else -2
        if token.glued:
            text, end = f"{text}-", token.start + len(token.shown) + 1
    words = text.strip(" ,.;:!?\n").split(" ")
    while len(words) > 1 and words[-1].lower() in _LINKS:
        del words[-1]
    return " ".join(words).strip(" ,.;:!?\n")


def _without_courtesy(tokens: Sequence[Token]) -> list[Token]:
    """The tokens without "if possible" and its like: what cannot be done is said in any case."""
    left: list[Token] = []
    index = 0
    while index < len(tokens):
        found = longest("conditions", tokens, index)
        if found is not None and (found[0] == "polite" or (found[0] == "last" and _is_last(tokens, index + found[1]))):
            index += found[1]
            continue
        left.append(tokens[index])
        index += 1
    return left


def _gathered(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with what belongs to a verb beside it: "throw the rug away" as "throw away the rug"."""
    left = list(tokens)
    for index in range(len(left) - 2):
        before = left[index - 1].text if index else "."
        if before not in (*ENDS, *_LINKS) and not (index and _is_filler(left[:index], left[index - 1])):
            continue
        for after in range(index + 2, len(left)):
            joined = left[after].text in _LINKS and not starts_with_verb(left, after + 1)
            if left[after].text in (*ENDS, *_LINKS) and not joined:
                break
            if means("particles", left[after].text) and _parted(left, index, after):
                left.insert(index + 1, left.pop(after))
                break
    return left


def _parted(tokens: Sequence[Token], at: int, after: int) -> bool:
    """Whether a verb of two words begins and goes on at two places; what brings something is not parted."""
    found = longest("verbs", (tokens[at], tokens[after]), 0)
    if found is None or found[1] < 2 or found[0] == "add" or longest("out_of", tokens, after) is not None:
        return False
    return _ends(tokens, after + 1) or grammar().at(tokens, after + 1, "prepositions") is not None


def _led(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with what leads a sentence put behind its order: "instead of the stool I want a bench"."""
    left: list[Token] = []
    begin = 0
    while begin < len(tokens):
        end = next((n for n in range(begin, len(tokens)) if tokens[n].text in ENDS), len(tokens))
        left += _lead_last(tokens[begin:end])
        left += tokens[end : end + 1]
        begin = end + 1
    return left


def _lead_last(sentence: Sequence[Token]) -> list[Token]:
    first = _first(sentence)
    leads = first < len(sentence) and grammar().at(sentence, first, "prepositions") is not None
    if not leads or _start(sentence, first, first=True) is not None:
        return list(sentence)
    for at in range(first + 2, len(sentence)):
        start = _verb(sentence, at, first=False)
        if start is not None and sentence[at - 1].text not in (*_LINKS[1:], *_POINTERS):
            lead = [t for t in sentence[:at] if t.text != ","]
            return [*sentence[at:], *lead]
    return list(sentence)


def _check(tokens: Sequence[Token], named: Mapping[int, str]) -> None:
    for index in range(len(tokens)):
        found = longest("conditions", tokens, index)
        if found is not None and found[0] == "if" and not _compares(tokens, index):
            rest = next((n for n in range(index, len(tokens)) if tokens[n].text in (*ENDS, ",")), len(tokens))
            says = spoken(tokens[index:rest], named)
            raise InputError(f"'{says}' is a condition, on which no edit can depend; say what is to be done")
    first = _first(tokens)
    if longest("undo", tokens, first) is not None:
        raise InputError(
            f"'{spoken(tokens, named)}' is not an edit of its own: the last edit is taken back with --undo, or with"
            " thinkblox.undo_edit"
        )


def _compares(tokens: Sequence[Token], at: int) -> bool:
    """Whether "as long as the sideboard" says how long something is to be: no verb follows it."""
    rest = [tokens[n] for n in _within(tokens, at)]
    words = [token.text for token in rest]
    own = words[:3] == ["as", "long", "as"] and at > 0 and tokens[at - 1].kind == "word"
    return own and not any(
        grammar().at(rest, n, "verbs") is not None or rest[n].text in _AGAIN for n in range(3, len(rest))
    )


def _first(tokens: Sequence[Token]) -> int:
    index = 0
    while index < len(tokens) and (filler := longest("fillers", tokens, index)) is not None:
        index += filler[1]
    return index


def _is_filler(tokens: Sequence[Token], token: Token) -> bool:
    at = tokens.index(token)
    spans = ((start, longest("fillers", tokens, start)) for start in range(at + 1))
    return any(found is not None and start + found[1] > at for start, found in spans)


# --- where clauses begin


def _starts(tokens: Sequence[Token]) -> list[_Start]:
    starts: list[_Start] = []
    index, fresh, first = 0, True, True
    while index < len(tokens):
        start = _start(tokens, index, first=first) if fresh else _sparing(tokens, index)
        if start is not None:
            starts.append(start)
            index, fresh, first = _coordinated(tokens, start), False, False
            continue
        filler = longest("fillers", tokens, index) if fresh else None
        if tokens[index].text in ENDS:
            fresh = first = True
        elif tokens[index].text in _LINKS or (tokens[index].text == "so" and fresh and _begins(tokens, index + 1)):
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
    return at < len(tokens) and tokens[at].text not in _POINTERS and _verb(tokens, at, first=True) is not None


def _coordinated(tokens: Sequence[Token], start: _Start) -> int:
    """From where on another clause may begin: of "have the lamp and the plant trade places" after the whole wish."""
    if start.doing not in _WANTS:
        return start.body
    for index in _within(tokens, start.body + 1):
        if means("bare", tokens[index].text) or longest("bare", tokens, index) is not None:
            wish = longest("wishes", tokens, index)
            return index + wish[1] if wish is not None else start.body
        if tokens[index].text == "," or longest("wishes", tokens, index) is not None:
            return start.body
        if tokens[index].text in _LINKS and starts_with_verb(tokens, index + 1):
            return start.body
    return start.body


def starts_with_verb(tokens: Sequence[Token], at: int) -> bool:
    """Whether an order may begin there, in the middle of a sentence."""
    return at < len(tokens) and _verb(tokens, at, first=False) is not None


def _start(tokens: Sequence[Token], at: int, *, first: bool) -> _Start | None:
    denied = longest("denials", tokens, at)
    if denied is not None and denied[0] == "not":
        verb = _verb(tokens, at + denied[1], first=True)
        if verb is not None and longest("verbs", tokens, at) is None:
            return _Start(at, at + denied[1] + verb[2], verb[0], verb[1], denied=True)
    if denied is not None and denied[0] == "without":
        return _sparing(tokens, at)
    verb = _verb(tokens, at, first=first)
    filler = longest("fillers", tokens, at)
    if verb is not None and filler is not None and filler[1] > verb[2]:
        return None
    if verb is not None:
        return _Start(at, at + verb[2], verb[0], verb[1])
    return _wish(tokens, at, first=first)


def _sparing(tokens: Sequence[Token], at: int) -> _Start | None:
    """Read "without moving the sofa", in the middle of an order."""
    found = longest("denials", tokens, at)
    if found is None or found[0] != "without":
        return None
    if tokens[at].text == "but":
        return None
    return _Start(at, at + found[1], "keep")


def _verb(tokens: Sequence[Token], at: int, *, first: bool) -> tuple[str, str, int] | None:
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
    pointed = after is not None and (after.text in _POINTERS or after.kind == "number" or found[1] > 1)
    pointed |= after is not None and grammar().at([after], 0, "count") is not None
    pointed |= at > 0 and tokens[at - 1].text == "then"
    pointed |= at > 0 and tokens[at - 1].text in _LINKS and bool(means("plain_verbs", tokens[at].text))
    if not first and not pointed:
        return None
    return found[0], change[0] if change else "", found[1]


def _wish(tokens: Sequence[Token], at: int, *, first: bool) -> _Start | None:
    """Read "the sofa should be against the wall", "could the desk be under the window?"."""
    asked = longest("asked", tokens, at)
    if first and asked is not None and asked[0] == "before" and longest("fillers", tokens, at) is None:
        verb = next((n for n in _within(tokens, at + 1) if _means(tokens, n, "asked") == "after"), None)
        swapped = next((n for n in _within(tokens, at + 1) if _means(tokens, n, "wishes") == "swap"), None)
        if swapped is not None:
            found = longest("wishes", tokens, swapped)
            return replace(_wished(tokens, at + 1, swapped, *found), begin=at) if found is not None else None
        if verb is None:
            return None
        told = verb if tokens[verb].text == "face" else verb + 1
        return _Start(at, told, "put", before=tuple(tokens[at + 1 : verb]))
    for index in _within(tokens, at + 1):
        found = longest("wishes", tokens, index)
        mutual = grammar().at(tokens, index, "mutual")
        found = None if found is not None and mutual is not None and mutual.length > found[1] + 1 else found
        if found is not None and not first and _is_list(tokens[at:index]):
            return None
        if tokens[index].text in _RELATIVE or (found is None and _verb(tokens, index, first=False) is not None):
            return None
        if (
            found is None
            or "to" in (tokens[index].text, tokens[index - 1].text)
            or (found[0] == "block" and tokens[at].text not in _NOTHING)
        ):
            continue
        return _wished(tokens, at, index, *found)
    return None


def _is_list(subject: Sequence[Token]) -> bool:
    """Whether it ends with what follows a comma alone: "(remove the lamp and) the chair, the desk (can stay)"."""
    commas = [n for n, token in enumerate(subject) if token.text == ","]
    return bool(commas) and not any(token.text == "and" for token in subject[commas[-1] :])


def _nearest_of(subject: Sequence[Token]) -> tuple[Token, ...]:
    """What a wish is about, where "(the armchair) closer to the door" is the one that is so."""
    words = {"closer": "nearest", "nearer": "nearest", "further": "farthest", "farther": "farthest"}
    told = [n for n in range(1, len(subject) - 1) if subject[n].text in words and subject[n + 1].text in ("to", "from")]
    return tuple(replace(token, text=words[token.text]) if n in told else token for n, token in enumerate(subject))


def _wished(tokens: Sequence[Token], at: int, index: int, key: str, length: int) -> _Start:
    subject, after = _nearest_of(tokens[at:index]), index + length
    last = tokens[after - 1].text
    if subject[0].text in _NOTHING and key in ("put", "block"):
        return _Start(at, after, "free")
    if key == "have":
        after -= last in ("a", "an", "one", "two")
        return _Start(at, after, "add", before=(), whose=subject)
    if key == "put" and last in _GONE and _ends(tokens, after):
        key = "remove"
    if key == "face":
        after -= 2 if last == "at" else 1
        return _Start(at, after, "put", before=subject)
    if key == "not":
        after -= 1 if last == "face" else 0
        return _Start(at, after, "put", before=(*subject, _NOT))
    return _Start(at, after, key, before=subject)


def _within(tokens: Sequence[Token], at: int) -> list[int]:
    """The tokens up to the end of the sentence."""
    end = next((n for n in range(at, len(tokens)) if tokens[n].text in ENDS), len(tokens))
    return list(range(at, end))


def _means(tokens: Sequence[Token], at: int, section: str) -> str:
    found = longest(section, tokens, at)
    return found[0] if found is not None else ""


def _ends(tokens: Sequence[Token], at: int) -> bool:
    return at >= len(tokens) or tokens[at].text in (*ENDS, *_LINKS, "please", "now", "away")


def _settled(clause: Clause) -> Clause:
    """A clause by what it says is to have been done ("the rug removed") and how a thing is to be ("to be blue")."""
    tokens, doing = list(clause.tokens), clause.doing
    if doing in _WANTS:
        doing = "put"
        for index in range(1, len(tokens)):
            found = longest("wishes", tokens, index)
            if found is None:
                continue
            start = _wished(tokens, 0, index, *found)
            doing, tokens = start.doing, [*start.before, *tokens[start.body :]]
            tokens = list(_had(tokens, start.whose)) if start.whose else tokens
            break
    if doing == "put" and clause.doing in ("put", *_WANTS):
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
    if _ends(tokens, at):
        return True
    after = tokens[at]
    return (
        after.kind == "number"
        or after.text in ("by", "with", "to", "from", "out", "so", "a", "half", "closer", "nearer", "further")
        or grammar().at(tokens, at, "prepositions", "count") is not None
        or longest("directions", tokens, at) is not None
        or longest("markers", tokens, at) is not None
    )
