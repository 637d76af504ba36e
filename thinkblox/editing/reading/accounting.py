"""Every word of an instruction counts: one without which it is read just the same has asked for nothing."""

import dataclasses
from collections.abc import Callable, Sequence

from thinkblox.editing.grammar import longest, sections, whose
from thinkblox.editing.orders import Order
from thinkblox.editing.reading.leads import told_before
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.sizes import read_size
from thinkblox.reading.tokens import Token

Signature = tuple[object, ...]
Read = Callable[[Sequence[Token]], Sequence[Order]]

_AS_WRITTEN = frozenset(("text", "start", "end", "fates", "lost"))
_OF_FORM = frozenset(("its", "their", "his", "her", "opposite", "furniture", "no", "more"))
"""Words of a noun phrase that are looked at as they were written."""
_SORTS = (
    "fillers",
    "verbs",
    "markers",
    "wishes",
    "asked",
    "bare",
    "few",
    "directions",
    "turns",
    "shares",
    "done",
    "conditions",
    "all_over",
)
"""Phrases of the instructions' grammar that may be said in other words, or go without saying."""
_OF_READER = ("prepositions", "joins", "verbs", "fillers", "mutual", "pronouns", "parts", "people")
_NAMING = ("object", "room", "attribute")
"""What a name of several words can be of, all of which it needs."""
_BEFORE_VERBS = (",", ".", ";", "!", "?", "and", "then", "but", "to")
MOST = 80
"""Longest instruction of which the words are tried [tokens]; longer ones are read order by order by their users."""


def unaccounted(
    lexicon: Lexicon, tokens: Sequence[Token], orders: Sequence[Order], unknown: Sequence[str], read: Read
) -> list[str]:
    """Words that change nothing about how an instruction is read, besides those that only join or are polite.

    Args:
        lexicon: of its language.
        tokens: of the instruction.
        orders: as it was read.
        unknown: words that are known to mean nothing already.
        read: reads tokens as orders.
    """
    said, known = signature(orders), {word for text in unknown for word in text.lower().split()}
    known |= {word for order in orders for text in order.lost for word in text.lower().split()}
    named, passed = _named(orders), _passed(lexicon, tokens) | _of_names(lexicon, tokens)
    found: list[str] = []
    for index, token in enumerate(tokens if len(tokens) <= MOST else ()):
        if token.kind != "word" or index in passed or token.text in known | named or token.shown.lower() in known:
            continue
        try:
            same = signature(read([*tokens[:index], *tokens[index + 1 :]])) == said
        except InputError:
            same = False
        found += [token.shown] if same else []
    return [*found, *(word for word in _unseen(orders) if word not in found and word not in known)]


def _unseen(orders: Sequence[Order]) -> list[str]:
    """What is said of new things that nothing of ours shows: "striped"."""
    new = [noun for noun in _nouns(orders) if noun.kind == "thing" and noun.named and not noun.definite and not noun.id]
    return [word for noun in new for word in (*noun.unshown, *noun.states) if word != noun.degree]


def signature(value: object) -> object:
    """What is read, without how it was written."""
    if isinstance(value, Noun):
        shown = tuple(word for word in value.text.lower().split() if word in _OF_FORM or whose(word))
        return (*_fields(value), shown)
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return _fields(value)
    if isinstance(value, list | tuple):
        return tuple(signature(item) for item in value)
    return value


def _fields(value: object) -> Signature:
    names = (field.name for field in dataclasses.fields(value))  # type: ignore[arg-type]
    return tuple((name, signature(getattr(value, name))) for name in names if name not in _AS_WRITTEN)


def _named(orders: Sequence[Order]) -> set[str]:
    """The words of the names of all things that are read: "cash register" as one thing, also where "register" is."""
    return {
        word for noun in _nouns(orders) for name in (noun.value, noun.id) for word in name.replace("_", " ").split()
    }


def _of_names(lexicon: Lexicon, tokens: Sequence[Token]) -> set[int]:
    """The tokens of names of several words: "dining chair" as a chair, "navy blue" as navy."""
    found: set[int] = set()
    for index in range(len(tokens)):
        name = lexicon.longest(list(tokens), index)
        if name.length > 1 and any(entry.sort in _NAMING for entry in name.entries):
            found |= set(range(index, index + name.length))
    return found


def _nouns(orders: Sequence[Order]) -> list[Noun]:
    """Every noun phrase of some orders."""
    nouns: list[Noun] = []
    pending: list[object] = list(orders)
    while pending:
        value = pending.pop(0)
        if isinstance(value, Noun):
            nouns.append(value)
        elif isinstance(value, list | tuple):
            pending += value
        elif dataclasses.is_dataclass(value) and not isinstance(value, type):
            pending += [getattr(value, field.name) for field in dataclasses.fields(value)]
    return nouns


def _is_of_new(tokens: Sequence[Token], at: int) -> bool:
    """Whether it is the "new" of "a new chair", which says no more than "a"."""
    before = tokens[at - 1] if at else None
    counted = before is not None and (before.kind == "number" or grammar().at([before], 0, "count") is not None)
    return (
        tokens[at].text in ("new", "fresh") and before is not None and (counted or before.text in ("a", "some", "my"))
    )


def _passed(lexicon: Lexicon, tokens: Sequence[Token]) -> set[int]:
    """The tokens that need not change what is asked: articles, words that join, courtesies, other words for verbs."""
    passed = set(range(told_before(tokens)))
    functional = sections()["functional"]
    for index in range(len(tokens)):
        if (size := read_size(lexicon, list(tokens), index)) is not None:
            passed |= set(range(index, size[1]))
        bound = longest("bounds", tokens, index)
        if bound is not None and read_size(lexicon, list(tokens), index + bound[1]) is not None:
            passed |= set(range(index, index + bound[1]))
        begins = not index or tokens[index - 1].text in _BEFORE_VERBS or index - 1 in passed
        sorts = _SORTS if begins else tuple(sort for sort in _SORTS if sort != "verbs")
        lengths = [found[1] for sort in sorts if (found := longest(sort, tokens, index)) is not None]
        phrase = grammar().at(tokens, index, *_OF_READER)
        lengths += [phrase.length] if phrase is not None else []
        lengths += [1] if (tokens[index].text,) in functional or _is_of_new(tokens, index) else []
        passed |= set(range(index, index + max(lengths, default=0)))
    return passed
