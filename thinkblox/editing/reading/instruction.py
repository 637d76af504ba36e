"""Instructions to orders: the reader's noun phrases and prepositions, and a grammar of what is done with them."""

import re
from collections.abc import Callable, Collection, Mapping, Sequence

from thinkblox.editing.grammar import verbs
from thinkblox.editing.heeding import check_heeded
from thinkblox.editing.orders import Instruction, Order
from thinkblox.editing.reading.accounting import unaccounted
from thinkblox.editing.reading.another_one import with_another
from thinkblox.editing.reading.clause import Clause
from thinkblox.editing.reading.clauses import clauses
from thinkblox.editing.reading.corrections import corrected
from thinkblox.editing.reading.ellipsis import each_order, stand_between
from thinkblox.editing.reading.its_own import with_its_own
from thinkblox.editing.reading.leads import without_announcements, without_reasons
from thinkblox.editing.reading.one_here import one_here_one_there
from thinkblox.editing.reading.order_reader import read_order
from thinkblox.editing.reading.purposes import without_purposes
from thinkblox.editing.reading.rewording import (
    counted_to,
    in_between,
    in_its_place,
    included,
    reworded,
    something_instead,
    uncontracted,
    with_borne,
    with_heads,
    with_ids,
    with_its_wall,
    with_new_on_it,
    with_own,
    with_owners,
    without_commas,
    without_rather_than,
)
from thinkblox.editing.reading.row_words import with_rows
from thinkblox.editing.reading.said_more import with_more_said
from thinkblox.editing.reading.seen_from import as_seen
from thinkblox.editing.reading.side_words import with_sides
from thinkblox.editing.reading.slips import without_slip
from thinkblox.editing.reading.table_laying import with_settings
from thinkblox.editing.reading.verbless import with_verbs
from thinkblox.errors import InputError
from thinkblox.reading.lexicon import Lexicon, load
from thinkblox.reading.tokens import Token

MAX_INSTRUCTION = 2000
"""Longest instruction that is read [characters]."""
_ID = re.compile(r"\b[A-Za-z][A-Za-z0-9_.-]*_[0-9]+\b")
_DASH = re.compile(r" [-–—] ")


def read_instruction(text: str, ids: Collection[str] = ()) -> Instruction:
    """What an English instruction asks to be done with a room.

    Args:
        text: the instruction.
        ids: of the objects that are there; it may name them so.

    Raises:
        InputError: it is no text, empty or too long, or says nothing that can be done; says what can.
    """
    _check(text)
    lexicon = load("en")
    plain, named = _without_ids(with_ids(lexicon, uncontracted(_DASH.sub(" , ", text)), ids), ids)
    spelt = [without_slip(lexicon, token) for token in lexicon.tokens(plain)]
    read = one_here_one_there(lexicon, as_seen(corrected(lexicon, with_sides(lexicon, spelt))))
    more = with_settings(with_more_said(lexicon, read))
    again = with_another(lexicon, with_its_own(lexicon, with_verbs(lexicon, without_purposes(more))))
    owned = with_its_wall(lexicon, with_owners(lexicon, with_heads(lexicon, with_own(lexicon, counted_to(again)))))
    said = something_instead(reworded(in_its_place(with_borne(with_new_on_it(without_rather_than(owned))))))
    tokens = without_reasons(lexicon, without_announcements(without_commas(with_rows(included(in_between(said))))))
    kinds = frozenset(id.rpartition("_")[0] for id in ids)
    orders, unknown = _orders(lexicon, tokens, named, kinds)
    if not orders:
        words = ", ".join(verbs())
        raise InputError(f"{_short(text)!r} does not say what to do with the room; an instruction begins with {words}")
    unknown += unaccounted(lexicon, tokens, orders, unknown, lambda left: _orders(lexicon, left, named, kinds)[0])
    for order in orders:
        check_heeded(order)
    return Instruction(text, tuple(orders), tuple(unknown))


def _orders(
    lexicon: Lexicon, tokens: Sequence[Token], named: Mapping[int, str], kinds: Collection[str]
) -> tuple[list[Order], list[str]]:
    """The orders that tokens hold, and what means nothing in them."""
    unknown: list[str] = []

    def read(clause: Clause) -> Order:
        return read_order(lexicon, clause, named, kinds)

    parts = clauses(tokens, named, unknown)
    orders = [order for clause in parts for order in _each(clause, read, [other.text for other in parts])]
    for number, order in enumerate(orders):
        if order.lost == ["in between"] and order.doing in ("add", "put"):
            stand_between(orders[number - 1] if number else None, order)
        unknown += order.lost
    return orders, unknown


def _each(clause: Clause, read: Callable[[Clause], Order], texts: Sequence[str]) -> list[Order]:
    """The orders of one of several clauses.

    Raises:
        InputError: one cannot be read, so that the others are not done either, which it says.
    """
    try:
        return list(each_order(clause, read))
    except InputError as error:
        others = ", ".join(f"'{text}'" for text in dict.fromkeys(texts) if text != clause.text)
        if not others or type(error) is not InputError:
            raise
        raise InputError(f"{error}; nothing was done, {others} neither") from error


def _check(text: object) -> None:
    if not isinstance(text, str):
        raise InputError(f"the instruction is a {type(text).__name__}; it must be a text")
    if text.encode("utf-8", "ignore").decode() != text:
        raise InputError("the instruction is not valid text: it holds bytes that are not UTF-8")
    if not text.strip():
        raise InputError("the instruction is empty; say what to change, such as 'Move the desk under the window.'")
    if len(text) > MAX_INSTRUCTION:
        raise InputError(
            f"the instruction has {len(text)} characters; at most {MAX_INSTRUCTION} are read: give fewer orders at once"
        )


def _short(text: str) -> str:
    return text if len(text) <= 80 else text[:77] + "..."


def _without_ids(text: str, ids: Collection[str]) -> tuple[str, dict[int, str]]:
    """The text with ids of objects as words, and which begins at which character of it.

    Raises:
        InputError: it names an id that is not there, of a kind that is.
    """
    plain, named, end = "", {}, 0
    for match in _ID.finditer(text):
        if match[0] in ids:
            plain += text[end : match.start()]
            named[len(plain)] = match[0]
            plain += re.sub(r"[^A-Za-z]+", " ", match[0].rpartition("_")[0])
            end = match.end()
            continue
        kind = match[0].rpartition("_")[0]
        if alike := [id for id in ids if id.rpartition("_")[0] == kind]:
            raise InputError(f"the room has no {match[0]}; there is {', '.join(alike)}")
    return plain + text[end:], named
