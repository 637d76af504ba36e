"""An instruction cut to clauses: what each asks to be done, and the words that it says it with."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from msgspec import structs

from thinkblox.editing.grammar import longest, means
from thinkblox.editing.reading.clause import (
    AGAIN,
    BRINGS,
    ENDS,
    LINKS,
    NEWS,
    NOT,
    POINTERS,
    TO,
    WITH,
    Clause,
    ClauseStart,
    after_fillers,
    ends_at,
    is_filler_at,
    rest_of_sentence,
    spoken,
)
from thinkblox.editing.reading.clause_senses import given_as, had_by, of_lacking, settled, turned_about
from thinkblox.editing.reading.clause_starts import start_at, starts_of, starts_with_verb, verb_at
from thinkblox.editing.reading.leads import (
    blocked_in,
    compared_with,
    disliked_in,
    is_of_other,
    is_reason,
    obtained_in,
    one_of,
    told_about,
    without_unwanted,
)
from thinkblox.errors import InputError
from thinkblox.reading.english.grammar import grammar, is_count
from thinkblox.reading.tokens import Token

_COMMA = Token(",", ",", "mark", start=-1)
_THE = Token("the", "the", "word", start=-1)
_OUT_OF_WAY = tuple(Token(word, word, "word", start=-1) for word in ("out", "of", "the", "way", "of"))


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
    told, about, blocked, disliked = lead, told_about(lead), blocked_in(lead), disliked_in(lead)
    new = obtained_in(lead)
    lead = [] if about or disliked or new or is_reason(lead) else lead
    unknown += [t.shown for t in lead if t.kind == "word" and not is_filler_at(lead, t)]
    made = []
    refused: tuple[Token, ...] = ()
    for number, start in enumerate(starts):
        end = starts[number + 1].begin if number + 1 < len(starts) else len(tokens)
        text = spoken(tokens[start.begin : end], named)
        body = (*start.before, *tokens[start.body : end])
        if not number and about:
            body = one_of(about, compared_with(told, body))
        if not number and new and body[:1] and body[0].text in ("it", "them") and start.doing in ("move", "put"):
            body, start = (*new, *body[1:]), replace(start, doing="put")
        elif not number and (about or disliked) and body[:1] and body[0].text in ("it", "them"):
            alone = ends_at(body, 1) and start.doing in ("move", "put")
            body = (
                *(about or disliked),
                *(_OUT_OF_WAY if alone and blocked else ()),
                *(blocked if alone else ()),
                *body[1:],
            )
        elif not number and ((disliked and start.doing in NEWS) or (about and is_of_other(start, body))):
            body = (*(about or disliked), WITH, *(token for token in body if token.text != "instead"))
            start = replace(start, doing="replace")
        if start.whose:
            body = had_by(body, start.whose)
        clause = settled(turned_about(given_as(of_lacking(Clause(start.doing, start.change, body, text)))))
        if start.denied and start.doing in BRINGS:
            continue
        clause, refused = _not_there(clause, refused), ()
        if start.denied and clause.doing == "put" and number + 1 < len(starts) and _is_known_at(clause.tokens):
            refused = clause.tokens
            continue
        if start.denied and clause.doing in ("put", "keep", "make", "free"):
            raise InputError(f"'{text}' says what is not to be done; say what is")
        made += _denied(clause) if start.denied else [clause]
    return made


def _begun(tokens: Sequence[Token]) -> tuple[list[ClauseStart], Sequence[Token]]:
    """Where the clauses begin, and what comes before the first."""
    starts = _going_on(tokens, list(starts_of(tokens))) or _asked_for(tokens)
    lead: Sequence[Token] = tokens[: starts[0].begin] if starts else tokens
    if starts and _is_terse(lead):
        starts = [ClauseStart(after_fillers(lead), after_fillers(lead), "want"), *starts]
        lead = tokens[: starts[0].begin]
    return without_unwanted(tokens, starts, lead)


def _going_on(tokens: Sequence[Token], starts: list[ClauseStart]) -> list[ClauseStart]:
    """The clauses, where "(the armchair should be red) and face the door" says more of what the wish is about."""
    left: list[ClauseStart] = []
    for start in starts:
        wished = bool(left) and left[-1].doing == "put" and bool(left[-1].before)
        linked = start.begin > 0 and tokens[start.begin - 1].text == "and" and tokens[start.begin].text == "face"
        if wished and linked and start.doing == "turn" and start.body == start.begin + 1:
            it = structs.replace(TO, text="it", shown="it")
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
    return replace(clause, tokens=(*said[:at], *body, _COMMA, NOT, *said[at:]))


def _denied(clause: Clause) -> list[Clause]:
    """What is not to be done, by which things stay as they are: "don't remove the sofa, only the rug" takes the rug."""
    tokens = clause.tokens
    at = next((n for n in range(1, len(tokens) - 1) if tokens[n].text in ("only", "just", "rather")
               and tokens[n - 1].text in (",", "but")), None)  # fmt: skip
    if at is None:
        return [Clause("keep", "", tokens, clause.text)]
    end = next(n for n in range(at, 0, -1) if tokens[n - 1].text not in (",", "but"))
    return [Clause("keep", "", tokens[:end], clause.text), replace(clause, tokens=tokens[at + 1 :])]


def _pointed(tokens: Sequence[Token], named: Mapping[int, str]) -> list[Token]:
    """The tokens with "the" before an id that a verb stands before, by which that is told from a noun: "stand it_2"."""
    left: list[Token] = []
    for index, token in enumerate(tokens):
        verb = longest("verbs", tokens, index - 1) if index else None
        if token.start in named and verb is not None and verb[1] == 1:
            left.append(_THE)
        left.append(token)
    return left


def _asked_for(tokens: Sequence[Token]) -> list[ClauseStart]:
    """What is asked for without a verb: "a bigger bed please", "floor lamp behind the sofa", "only two chairs"."""
    asked = any(token.text in ("please", "pls", "plz") for token in tokens) or _is_terse(tokens)
    first = after_fillers(tokens)
    if first >= len(tokens):
        return []
    counted = is_count(tokens, first)
    if counted and any(token.text in ("only", "just") for token in tokens[:first]):
        return [ClauseStart(0, first, "ensure")]
    return [ClauseStart(first, first, "want")] if asked else []


def _is_terse(tokens: Sequence[Token]) -> bool:
    """Whether words name a thing and where or how it is to be, and no more: "bigger mirror", "desk under the window".

    What tells or asks something has a verb, what names nothing but a place begins with that.
    """
    first = after_fillers(tokens)
    said = [token for token in tokens[first:] if token.text not in (*ENDS, ",", "and")]
    person = said[0].text != "one" and means("anybody", said[0].text) if said else ""
    if len(said) < 2 or grammar().at(said, 0, "prepositions") is not None or person:
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
        if before not in (*ENDS, *LINKS) and not (index and is_filler_at(left[:index], left[index - 1])):
            continue
        for after in range(index + 2, len(left)):
            joined = left[after].text in LINKS and not starts_with_verb(left, after + 1)
            if left[after].text in (*ENDS, *LINKS) and not joined:
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
    return ends_at(tokens, after + 1) or grammar().at(tokens, after + 1, "prepositions") is not None


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
    first = after_fillers(sentence)
    leads = first < len(sentence) and grammar().at(sentence, first, "prepositions") is not None
    if not leads or start_at(sentence, first, first=True) is not None:
        return list(sentence)
    for at in range(first + 2, len(sentence)):
        start = verb_at(sentence, at, first=False)
        if start is not None and sentence[at - 1].text not in (*LINKS[1:], *POINTERS):
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
    first = after_fillers(tokens)
    if (found := longest("mirroring", tokens, first)) is not None:
        says = spoken(tokens[first : first + found[1]], named)
        raise InputError(f"'{says}': a layout is not mirrored; say what goes where, or 'swap the bed and the desk'")
    if longest("undo", tokens, first) is not None:
        raise InputError(
            f"'{spoken(tokens, named)}' is not an edit of its own: the last edit is taken back with --undo, or with"
            " thinkblox.undo_edit"
        )


def _compares(tokens: Sequence[Token], at: int) -> bool:
    """Whether "as long as the sideboard" says how long something is to be: no verb follows it."""
    rest = [tokens[n] for n in rest_of_sentence(tokens, at)]
    words = [token.text for token in rest]
    own = words[:3] == ["as", "long", "as"] and at > 0 and tokens[at - 1].kind == "word"
    return own and not any(
        grammar().at(rest, n, "verbs") is not None or rest[n].text in AGAIN for n in range(3, len(rest))
    )
