"""What pronouns stand for that the same instruction names: "those in the first row", "the other one", "around it"."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from thinkblox.assets import facts_of
from thinkblox.editing.finding import Finder
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.telling import named
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where

_STAYING = ("keep", "only")
"""Orders that are looked at before anything is done, when nothing was spoken of yet."""
_GOING = ("put", "move")
_IT = ("pronoun", "it")
_OF_SOME = ("remove", "replace", "make")
"""Orders after which "keep them on the table" says which of them stay as they are."""


def with_antecedents(orders: Sequence[Order], finder: Finder) -> list[Order]:
    """The orders with the thing that was named before in place of a pronoun that says which of several is meant.

    Raises:
        InputError: nothing was named before that it could stand for.
    """
    orders = _others_moved(orders, finder)
    head: Noun | None = None
    mentions: list[Noun] = []
    last = ""
    for order in orders:
        before, staying = head, order.doing in _STAYING
        order.things[:] = [one for phrase in order.things for one in _each_of_two(phrase, mentions)]
        for number, phrase in enumerate(order.things):
            _of_bearer(phrase, order.things[number - 1] if number else None)
            _of_head(phrase, before, by_place=staying and last in _OF_SOME, one=staying)
            head = phrase.noun if phrase.noun.kind == "thing" else head
            for spared in phrase.spared:
                _of_head(spared, phrase.noun if phrase.noun.kind == "thing" else before, by_place=True)
            mentions += [phrase.noun] if phrase.noun.kind == "thing" else []
            for where in phrase.places:
                _between_two(where, [noun for noun in mentions if noun is not phrase.noun])
                _of_others(where, phrase.noun, order, finder)
                _of_carrier(where, phrase.noun, before, mentions)
                _of_place(where, before, order, mentions, finder)
                mentions += [noun for noun in _nouns(where) if noun.kind == "thing"]
        for where in order.places:
            _of_place(where, before, order, mentions, finder)
            mentions += [noun for noun in _nouns(where) if noun.kind == "thing"]
        last = order.doing
    return orders


def _two(mentions: Sequence[Noun]) -> tuple[Noun, Noun] | None:
    """The last two things that were named, where each is one."""
    if len(mentions) < 2 or any(noun.many or noun.det in ("a", "an", "another") for noun in mentions[-2:]):
        return None
    first, second = (replace(noun, det="the") for noun in mentions[-2:])
    return (first, second) if first.text != second.text else None


def _each_of_two(phrase: NounPhrase, mentions: Sequence[Noun]) -> list[NounPhrase]:
    """Read "(put the lamp on the desk and move) both of them" as both things that were named last."""
    noun, two = phrase.noun, _two(mentions)
    both = noun.kind == "pronoun" and noun.value == "them" and "both" in noun.text.lower().split()
    if not both or two is None:
        return [phrase]
    return [replace(phrase, noun=two[0], places=list(phrase.places)), replace(phrase, noun=two[1])]


def _between_two(where: Where, mentions: Sequence[Noun]) -> None:
    """Read "(make the sofa red and the chair black and put the lamp) between them" as between these two."""
    noun, two = where.noun, _two(mentions)
    them = noun is not None and noun.kind == "pronoun" and noun.value == "them"
    if where.word == "between" and them and where.second is None and two is not None:
        where.noun, where.second = two


def _others_moved(orders: Sequence[Order], finder: Finder) -> list[Order]:
    """The orders without "one bin is enough on the shelf" before "put the other three on the floor", which says it too.

    Raises:
        InputError: there are not so many others.
    """
    left: list[Order] = []
    for order in orders:
        stays, others = left[-1] if left else None, [p for p in order.things if p.noun.det == "other"]
        noun = stays.things[0].noun if stays is not None and len(stays.things) == 1 else None
        counted = noun is not None and noun.kind == "thing" and bool(noun.count) and not noun.definite
        bare = len(others) == len(order.things) == 1 and others[0].noun.kind in ("number", "pronoun")
        if stays is None or noun is None or stays.doing not in _STAYING or order.doing not in _GOING:
            left.append(order)
            continue
        if counted and bare:
            left.pop()
            _without_kept(others[0], stays.things[0], finder)
            at = stays.things[0].places[-1].noun if stays.things[0].places else None
            for where in others[0].places:
                if at is not None and where.noun is not None and (where.noun.kind, where.noun.value) == _IT:
                    where.noun = replace(at, det="the")
        left.append(order)
    return left


def _without_kept(others: NounPhrase, kept: NounPhrase, finder: Finder) -> None:
    """Let "the other three" be all but those that stay.

    Raises:
        InputError: there are not so many.
    """
    noun, said = kept.noun, others.noun
    every = [p.id for p in finder.matching(replace(noun, plural=True, count=None))]
    stay = named(finder, kept, kept.places)
    rest = [id for id in every if id not in stay]
    if not rest or (said.count and said.count != len(rest)):
        raise InputError(f"'{said.text}': besides {', '.join(stay)} there is {', '.join(rest) or 'none'}")
    others.noun = replace(noun, det="all", count=None, plural=True, text=f"the other {noun.text.partition(' ')[2]}")
    others.spared = [NounPhrase(noun, id=id) for id in stay]


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
    some = noun.kind in ("number", "pronoun") and noun.count and noun.text.lower().endswith("of them")
    number = one and noun.kind == "number" and not noun.rows and (noun.det == "the" or some)
    if not (them and told) and not number:
        return
    if head is None:
        raise InputError(f"'{noun.text}' points at nothing that was named before; name what you mean")
    phrase.noun = replace(
        head, det="" if some else "the", of_known=bool(some), plural=them or (noun.count or 1) > 1, count=noun.count,
        rows=noun.rows, ordinal=noun.ordinal, side=noun.side, degree=noun.degree, every=0, fraction=(0, 0), id="",
    )  # fmt: skip


def _of_others(where: Where, noun: Noun, order: Order, finder: Finder) -> None:
    """Read "(add two chairs) next to the others" as next to those of the kind that are there."""
    other = where.noun
    new = order.doing in ("add", "put", "ensure") and noun.kind == "thing" and not noun.definite
    bare = other is not None and other.det == "other" and other.kind in ("pronoun", "number")
    if other is None or not (new and bare) or not other.text.lower().endswith(("others", "ones")):
        return
    if finder.matching(replace(noun, attributes=[], unshown=[], det="the", count=None, plural=True)):
        where.noun = Noun("thing", noun.value, 0, 0, f"the other {noun.word}s", det="the", plural=True)


def _of_carrier(where: Where, noun: Noun, head: Noun | None, mentions: Sequence[Noun]) -> None:
    """Read "(add a rug under the table and put a vase) on it" as on the table: nothing is put on a rug there."""
    it = where.noun
    onto = it is not None and (it.kind, it.value) == _IT and where.word in ("on", "on_top", "to")
    if not onto or head is None or not facts_of(head.value).is_in("covers") or not facts_of(noun.value).is_in("small"):
        return
    others = [other for other in mentions if other is not noun and not facts_of(other.value).is_in("covers")]
    if others:
        where.noun = replace(others[-1], det="the")


def _of_bearer(phrase: NounPhrase, last: NounPhrase | None) -> None:
    """Read "(a vase on the dresser and a stool) in front of it" as before the dresser: a stool stands on the floor."""
    on = [w for w in last.places if w.word in ("on", "on_top") and not w.negated] if last is not None else []
    known = on[0].noun if len(on) == 1 else None
    small = facts_of(phrase.noun.value).is_in("small") or phrase.noun.kind != "thing"
    if last is None or known is None or known.kind != "thing" or small or not facts_of(last.noun.value).is_in("small"):
        return
    for where in phrase.places:
        it = where.noun is not None and (where.noun.kind, where.noun.value) == _IT
        if it and where.word in ("in_front_of", "behind", "left_of", "right_of", "next_to", "at", "by"):
            where.noun = replace(known, det="the")


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
