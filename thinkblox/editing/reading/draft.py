"""An order while it is read: the pieces of its words, how far they are read, and what was found so far."""

from dataclasses import dataclass, field

from thinkblox.editing.grammar import is_filler, means
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.reading.cutting import ClauseCutter, Item
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, SaidSurface
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.lexicon import Lexicon

ASIDE = ("by", "next_to", "near", "at", "of", "beside", "to")
"""Prepositions by which a thing is beside another."""
BEING = ("be", "stand", "hang", "put", "leave", "have")
SPOT = ("where", "to where")
"""Words before what stood at a place: "where the wardrobe was"."""
IN_ROW = ("middle", "left", "right")
WITH_ALONG = ("move", "put", "turn", "resite", "swap")
"""Orders on which other things can go along: "the table with its chairs"."""
OF_THOSE = ("remove", "replace", "make")
"""Orders whose places say which things are meant."""
SIDED = ("end", "side", "long_side", "short_side")
"""Parts that a thing has two of."""
TO_WALL = ("put", "move", "turn")
"""Orders by which a back comes to be against a wall."""


@dataclass
class OrderDraft:
    """An order while it is read.

    Attributes:
        order: what was read so far.
        items: the pieces of its words; those from `at` on are not read yet.
        mode: what nouns are: "things" that the order is about, what comes "instead" of them, of what a result is told
            ("so"), or what is not to be blocked ("unblock").
        so: of what a result is told.
        told: how many places were said before "out of the way".
        unsaid: how the order was read before that.
        negated: "not" was the last word.
        pending: "closer to" (True) or "away from" (False) waits for its noun.
        clears: it may be an order to clear things.
        anchors: nouns that places of the last thing name, which "it" may mean.
        former: those of the thing before it.
        excepted: what was excepted last.
        distance: a length waits for that from which it is.
        around: "round" is by half a turn.
        shared: several are shared out, "one on each side".
        whole: what a part was said to be of.
        left: those of several new things of which it is not told yet how they look.
        more, up_to: of space or size, "more" of it, or "up to" a length.
        only: "but only" was said.
        eached: something comes with each of what is added.
        fraction: by which part a size changes.
        centring, piling: what the verb says by itself.
        had: what is added is had by things that are there.
        cutter: that of the words, which knows the rank and the share of nouns.
    """

    order: Order
    items: list[Item]
    lexicon: Lexicon
    cutter: ClauseCutter
    clears: bool
    centring: bool
    piling: bool
    had: bool
    at: int = 0
    mode: str = "things"
    so: list[NounPhrase] = field(default_factory=list)
    unsaid: str = ""
    told: int | None = None
    negated: bool = False
    pending: bool | None = None
    anchors: list[Noun] = field(default_factory=list)
    former: list[Noun] = field(default_factory=list)
    excepted: NounPhrase | None = None
    distance: bool = False
    around: bool = False
    shared: bool = False
    whole: Noun | None = None
    left: Noun | None = None
    more: bool = False
    up_to: bool = False
    only: bool = False
    eached: bool = False
    fraction: float = 0.0

    def ahead(self, by: int = 0) -> Item | None:
        """The next piece, or that so many further; None behind the last."""
        at = self.at + by
        return self.items[at] if at < len(self.items) else None

    def before(self) -> Item | None:
        """The piece before the one that was taken last."""
        return self.items[self.at - 2] if self.at > 1 else None

    def sized(self) -> Noun | None:
        """The new thing of which a size by itself speaks: "a round one that is 1.5 m wide"."""
        order = self.order
        new = order.instead if order.doing == "replace" else order.things if order.doing in ("add", "ensure") else []
        new = order.things if order.doing == "put" and self.new_thing() is not None else new
        return new[-1].noun if new and new[-1].noun.size is None else None

    def places(self) -> list[Where]:
        """Every place of the order and of its things."""
        return [*self.order.places, *(where for phrase in self.order.things for where in phrase.places)]

    def new_thing(self) -> Noun | None:
        """The new thing that looks by themselves speak of: "add a rug under the table, grey"."""
        order = self.order
        new = (
            order.instead
            if order.doing == "replace"
            else order.things
            if order.doing in ("add", "ensure", "put")
            else []
        )
        return (
            new[-1].noun
            if new and new[-1].noun.kind != "pronoun" and not new[-1].noun.definite and not new[-1].id
            else None
        )

    def lose(self, item: Chunk) -> None:
        """Note words that mean nothing here."""
        text = item.request.phrase if isinstance(item, SaidSurface) else getattr(item, "text", "")
        words = [w for w in text.split() if not means("fillers", w.lower())]
        if words and not is_filler(text):
            self.order.lost.append(" ".join(words))

    def places_of_last(self) -> list[Where]:
        """The places of what was named last."""
        return self.order.things[-1].places if self.order.things else []

    def each_follows(self) -> bool:
        """Whether a place at each of several things or sides comes next."""
        link, noun = self.ahead(), self.ahead(1)
        return isinstance(link, Connector) and link.sort == "prepositions" and isinstance(noun, Noun) and noun.each

    def next_noun(self) -> Noun | None:
        """Take the noun that comes next; None where none does."""
        item = self.ahead()
        if not isinstance(item, Noun):
            return None
        self.at += 1
        return item


def is_theirs(noun: Noun) -> bool:
    """Whether it belongs to what was named before: "its chairs"."""
    words = [word for word in noun.text.lower().split() if word not in ("all", "both", "of")]
    return noun.det in ("my", "all", "both") and words[:1] in (["its"], ["their"], ["her"], ["his"])


def are_several(phrase: NounPhrase) -> bool:
    """Whether it names more than one."""
    return phrase.noun.many or (phrase.noun.kind == "pronoun" and phrase.noun.value == "them")


def is_it(noun: Noun) -> bool:
    """Whether it is "it" or "them"."""
    return noun.kind == "pronoun" and noun.value in ("it", "them")
