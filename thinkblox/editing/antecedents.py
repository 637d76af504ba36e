"""What pronouns stand for that the same instruction names: "those in the first row", "the other one", "around it"."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from thinkblox.editing.finding import Finder
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where

_STAYING = ("keep", "only")
"""Orders that are looked at before anything is done, when nothing was spoken of yet."""
_OF_SOME = ("remove", "replace", "make")
"""Orders after which "keep them on the table" says which of them stay as they are."""


def with_antecedents(orders: Sequence[Order], finder: Finder) -> None:
    """Put the thing that was named before in place of a pronoun that says which of several such things is meant.

    Raises:
        InputError: nothing was named before that it could stand for.
    """
    head: Noun | None = None
    mentions: list[Noun] = []
    last = ""
    for order in orders:
        before, staying = head, order.doing in _STAYING
        for phrase in order.things:
            _of_head(phrase, before, by_place=staying and last in _OF_SOME, one=staying)
            head = phrase.noun if phrase.noun.kind == "thing" else head
            for spared in phrase.spared:
                _of_head(spared, phrase.noun if phrase.noun.kind == "thing" else before, by_place=True)
            mentions += [phrase.noun] if phrase.noun.kind == "thing" else []
            for where in phrase.places:
                _of_place(where, before, order, mentions, finder)
                mentions += [noun for noun in _nouns(where) if noun.kind == "thing"]
        for where in order.places:
            _of_place(where, before, order, mentions, finder)
            mentions += [noun for noun in _nouns(where) if noun.kind == "thing"]
        last = order.doing


def _nouns(where: Where) -> Iterator[Noun]:
    yield from (noun for noun in (where.noun, where.whole, where.second) if noun is not None)


def _of_head(phrase: NounPhrase, head: Noun | None, *, by_place: bool, one: bool = False) -> None:
    """Read "those in the first row", "(keep) the one by the door" as things of the kind that was named last.

    Args:
        phrase: changed where it is such a pronoun.
        head: what was named last.
        by_place: where it is said to be tells which it is.
        one: so does what "the one" says.

    Raises:
        InputError: nothing was named before.
    """
    noun = phrase.noun
    them = noun.kind == "pronoun" and noun.value == "them" and noun.det != "other"
    told = bool(noun.rows or (by_place and phrase.places))
    number = one and noun.kind == "number" and not noun.rows and noun.det == "the"
    if not (them and told) and not number:
        return
    if head is None:
        raise InputError(f"'{noun.text}' points at nothing that was named before; name what you mean")
    phrase.noun = replace(
        head, det="the", plural=them or (noun.count or 1) > 1, count=noun.count, rows=noun.rows, ordinal=noun.ordinal,
        side=noun.side, degree=noun.degree, every=0, fraction=(0, 0), id="",
    )  # fmt: skip


def _of_place(where: Where, head: Noun | None, order: Order, mentions: Sequence[Noun], finder: Finder) -> None:
    """Read "(keep the chairs) around it" as around what was named last, and "on the other one" as on another such."""
    noun = where.noun
    if noun is None or noun.kind != "pronoun":
        return
    if noun.value in ("it", "them") and order.doing in _STAYING and head is not None:
        where.noun = replace(head, det="the", text=noun.text)
    elif noun.det == "other" and (noun.count or 1) == 1 and not noun.text.lower().endswith(("others", "ones")):
        where.noun = _other(noun, mentions, finder) or noun


def _other(noun: Noun, mentions: Sequence[Noun], finder: Finder) -> Noun | None:
    """The other one of that of which there are several, and which was named last; None where there is none."""
    for mention in reversed(mentions):
        kind = replace(mention, id="", side="", degree="", attributes=[], unshown=[], states=[], styles=[], ordinal=0,
                       rows=0, det="other", plural=False, count=1, text=noun.text)  # fmt: skip
        found = [p.id for p in finder.matching(kind)]
        if len(found) < 2:
            continue
        try:
            known = finder.ids(NounPhrase(mention, id=mention.id))
        except InputError:
            return kind
        left = [id for id in found if id not in known]
        return replace(kind, id=left[0]) if len(left) == 1 else kind
    return None
