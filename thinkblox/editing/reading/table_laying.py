"""What a table is set with, and for how many: "set the table for six with plates, glasses and two candles"."""

from collections.abc import Sequence

from msgspec import structs

from thinkblox.assets.plurals import singular
from thinkblox.editing.grammar import longest
from thinkblox.editing.reading.clause import ENDS
from thinkblox.reading.english.grammar import grammar, is_count
from thinkblox.reading.tokens import Token, tokenise

_LAYING = ("set", "lay")
_NEW = ("a", "an", "some", "one")


def with_settings(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with what a table is set with as what is added to it: so many of each as people sit there.

    Of "set the table for six with plates, glasses and two candles in the middle" six plates and six glasses are added
    to the table, and two candles in the middle of it. So it is without a verb: "table for four with plates".
    """
    left = list(tokens)
    for at in reversed(range(len(left))):
        found = _for_many(left, at)
        if found is None:
            continue
        begin, end, table, count = found
        stop = next((n for n in range(end, len(left)) if left[n].text in ENDS), len(left))
        stop = next((n for n in range(end, stop) if longest("verbs", left, n) and left[n - 1].text in ("and", "then")),
                    stop)  # fmt: skip
        said = _added(left[end:stop], table, count)
        if said:
            said[0] = structs.replace(
                said[0], shown=" ".join(t.shown for t in left[begin:end]), start=left[begin].start
            )
            left[begin:stop] = said
    return left


def _for_many(tokens: Sequence[Token], at: int) -> tuple[int, int, list[Token], Token] | None:
    """Where "set the table for six with" begins and ends, the table that it names and the number; None elsewhere."""
    if tokens[at].text != "for" or at + 2 >= len(tokens) or not is_count(tokens, at + 1):
        return None
    after = at + 3 if grammar().knows(tokens[at + 2].text, "people") else at + 2
    if after >= len(tokens) or tokens[after].text != "with" or not 0 < at <= 8:
        return None
    verb = next((n for n in range(at) if tokens[n].text in _LAYING), None)
    begun = all(longest("fillers", tokens, n) is not None or tokens[n].kind == "mark" for n in range(verb or 0))
    table = list(tokens[verb + 1 if verb is not None else 0 : at])
    if not begun or not table or any(token.kind == "mark" for token in table):
        return None
    table = table if table[0].text in ("the", "my", "our", "it", "every", "each") else [*tokenise("the"), *table]
    return verb or 0, after + 1, [structs.replace(token, start=-1) for token in table], tokens[at + 1]


def _added(said: Sequence[Token], table: Sequence[Token], count: Token) -> list[Token]:
    """What is added: each item with its number, at the table or where it is said to be on it."""
    items: list[list[Token]] = [[]]
    links: list[Token | None] = [None]
    for token in said:
        if token.text in (",", "and", "plus"):
            items.append([])
            links.append(token)
        else:
            items[-1].append(token)
    orders: list[Token] = []
    for link, item in ((link, item) for link, item in zip(links, items, strict=True) if item):
        counted = item[0].text in _NEW or is_count(item, 0)
        if not counted and singular(item[-1].text) == item[-1].text and not _places(item):
            return []
        where = _places(item)
        if not where:
            place = [*_words("on" if counted else "to"), *table]
        elif grammar().at(item, where + 1, "parts") is not None or item[-1].text in ("middle", "centre", "center"):
            place = [*item[where:], *_words("of"), *table]
        else:
            place = item[where:]
        head = item[: where or len(item)]
        number = [] if counted else [structs.replace(count, start=-1)]
        add = _words("add")[0]
        begin = _words(";") if orders else []
        add = structs.replace(add, start=link.start, shown=link.shown) if orders and link is not None else add
        orders += [*begin, add, *number, *head, *place]
    return orders


def _places(item: Sequence[Token]) -> int:
    """Where the place that an item names begins; 0 where it names none."""
    return next((n for n in range(1, len(item)) if _is_place(item, n)), 0)


def _is_place(item: Sequence[Token], at: int) -> bool:
    found = grammar().at(item, at, "prepositions")
    return found is not None and found.value not in ("of", "with")


def _words(text: str) -> list[Token]:
    return [structs.replace(token, start=-1) for token in tokenise(text)]
