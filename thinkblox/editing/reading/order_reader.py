"""The words of one clause as an order."""

from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import cast

from thinkblox.assets.plurals import singular
from thinkblox.editing.grammar import means
from thinkblox.editing.orders import Doing, Order
from thinkblox.editing.reading.clause import Clause
from thinkblox.editing.reading.cutting import ClauseCutter, Item, OrderMark
from thinkblox.editing.reading.draft import OrderDraft
from thinkblox.editing.reading.finishing import finish
from thinkblox.editing.reading.links import read_connector
from thinkblox.editing.reading.looks import read_adjective
from thinkblox.editing.reading.marks import read_mark
from thinkblox.editing.reading.nouns import read_noun
from thinkblox.reading.english.chunks import Adjective, Connector, Measured, Noun
from thinkblox.reading.lexicon import Lexicon

MOST_OF_VERB, MOST_BEFORE_ONLY = 4, 6
"""Among so many words at the beginning "only" says what alone is kept, or how many there are to be in all."""
_MAKING = ("make", "leave", "keep")
"""Verbs of "make room", "leave some space"."""


def read_order(lexicon: Lexicon, clause: Clause, named: Mapping[int, str], kinds: Collection[str] = ()) -> Order:
    """The order of a clause.

    Args:
        lexicon: of English.
        clause: the words after a verb.
        named: ids of objects by where the words for them begin.
        kinds: what is in the room, as the beginnings of ids.

    Raises:
        InputError: it says what cannot be followed.
    """
    draft = _begun(lexicon, clause, named, kinds)
    while (item := draft.ahead()) is not None:
        draft.at += 1
        match item:
            case OrderMark():
                read_mark(draft, item)
            case Noun():
                read_noun(draft, item)
            case Connector():
                read_connector(draft, item)
            case Measured() if (sized := draft.sized()) is not None:
                sized.size = item.size
            case Measured():
                draft.order.lengths += [(length.metres, length.axis) for length in item.size.lengths]
            case Adjective():
                read_adjective(draft, item)
            case _:
                draft.lose(item)
    finish(draft)
    return draft.order


def _begun(lexicon: Lexicon, clause: Clause, named: Mapping[int, str], kinds: Collection[str]) -> OrderDraft:
    """An order of which only the verb is read."""
    words = clause.text.lower().split() or [clause.doing]
    verb = next((word for word in words if means("drawing", word)), words[0])
    order = Order(cast(Doing, clause.doing), clause.text, change=clause.change)
    most = MOST_BEFORE_ONLY if clause.doing == "ensure" else MOST_OF_VERB
    told = [word.lower() for word in clause.text.split()[:most]]
    order.space = (
        clause.doing == "free" and told[0] in _MAKING and any(means("distances", word) == "gap" for word in told)
    )
    only = any(means("markers", w) == "only" for w in told) and not any(w.startswith("anything") for w in told)
    order.total = clause.doing in ("keep", "ensure") and only
    cutter = ClauseCutter(lexicon, clause.doing, verb, named)
    drawn = clause.doing == "move" and bool(means("drawing", verb)) and clause.tokens[:1]
    order.seated = means("drawn", clause.tokens[0].text) if drawn else ""
    tokens = clause.tokens[1:] if order.seated else clause.tokens
    return OrderDraft(
        order,
        [_of_kind(item, kinds) for item in cutter.items(tokens)],
        lexicon,
        cutter,
        clears=clause.doing == "free",
        centring=bool(means("centring", words[0])),
        piling=bool(means("piling", words[0])),
        had=any(token.text == "to" and token.start < 0 for token in clause.tokens),
    )


def _of_kind(item: Item, kinds: Collection[str]) -> Item:
    """A noun as the thing of the room that is called so, where it could be a room: "the changing room"."""
    if not isinstance(item, Noun) or item.kind != "room":
        return item
    words = [word for word in item.text.lower().split() if word != item.text.lower().split()[0] or not item.det]
    kind = "_".join([*words[:-1], singular(words[-1])]) if words else ""
    return (
        replace(item, kind="thing", value=kind, named=True, plural=words[-1] != singular(words[-1]))
        if kind in kinds
        else item
    )
