"""Instructions to orders: the reader's noun phrases and prepositions, and a grammar of what is done with them."""

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import cast

from thinkblox.assets import facts_of
from thinkblox.assets.plurals import singular
from thinkblox.editing.accounting import unaccounted
from thinkblox.editing.clauses import Clause, clauses, without_announcements, without_reasons
from thinkblox.editing.corrections import corrected
from thinkblox.editing.cutting import ClauseCutter, Item, OrderMark
from thinkblox.editing.ellipsis import each_order, stand_between
from thinkblox.editing.grammar import is_filler, means, sections, verbs
from thinkblox.editing.heeding import SAID, check_heeded
from thinkblox.editing.lengths import is_number
from thinkblox.editing.orders import AWAY_SIDE, BEARS, BORE, INSTEAD, SAME, Doing, Instruction, NounPhrase, Order
from thinkblox.editing.rewording import (
    in_between,
    reworded,
    something_instead,
    uncontracted,
    with_heads,
    with_ids,
    with_owners,
)
from thinkblox.editing.rows import MIDDLE_ROW
from thinkblox.errors import InputError
from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.english.chunker import cut
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Measured, Noun, SaidSurface
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.english.rooms import COMPASS
from thinkblox.reading.english.slips import meant_by
from thinkblox.reading.lexicon import Lexicon, load
from thinkblox.reading.sizes import Length, Size
from thinkblox.reading.tokens import Token, tokenise

MAX_INSTRUCTION = 2000
"""Longest instruction that is read [characters]."""
_ID = re.compile(r"\b[A-Za-z][A-Za-z0-9_.-]*_[0-9]+\b")
_DASH = re.compile(r" [-–—] ")
_OF_ROOM = ("make", "rearrange", "free", "keep", "only")
_ON_KNOWN = ("move", "turn", "replace", "remove", "swap", "free", "resite", "make", "keep", "only")
"""Orders whose things are in the room already."""
_MAKING = ("make", "leave", "keep")
"""Verbs of "make room", "leave some space"."""
_OF_ALL = ("remove", "keep", "move", "put", "free", "turn", "rearrange")
"""Orders that "everything" can be said with."""
_BEING = ("be", "stand", "hang", "put", "leave", "have")
_ROW = "row_of_"
"""How things begin that are one thing in the catalogue, and a row where it is said which."""
_SPOT = ("where", "to where")
"""Words before what stood at a place: "where the wardrobe was"."""
_IN_ROW = ("middle", "left", "right")
_LESS = ("smaller", "shorter", "narrower", "lower")
_SHAPES = ("round",)
_OF_LOOKS = ("make", "replace", "add", "put", "ensure")
"""Orders in which "in grey" is how something is to look."""
"""Prepositions that are looks where nothing follows."""
_WITH_ALONG = ("move", "put", "turn", "resite", "swap")
"""Orders on which other things can go along: "the table with its chairs"."""
_OWN_WORDS = ("verbs", "fillers", "comparatives", "resizing", "sizes", "distances", "asked", "done", "obtained")
_ASIDE = ("by", "next_to", "near", "at", "of", "beside", "to")
_AT_BACK = (*_ASIDE, "on", "against", "under")
_TOWARDS = ("to", "to face", "facing", "face", "towards", "toward")
_OF_THOSE = ("remove", "replace", "make")
"""Orders whose places say which things are meant."""
_SIDED = ("end", "side", "long_side", "short_side")
"""Parts that a thing has two of."""
_IT = ("it", "them", "this", "that", "these", "those")
_OF_TWO = {"face to face": "face_to_face", "back to back": "back_to_back"}
"""How two things stand that are brought together so."""
_THE_ONES = ("the one", "the ones", "those", "that")
"""What is said to be where of what was just named."""
_INTO = ("to", "onto", "into")
_STANDING = ("verbs", "participles")
"""Words between a thing and what it stands on."""
_STOOD = ("was", "were", "stood", "sat", "lay", "rested", "used")
"""Those of them that speak of before."""
_TO_WALL = ("put", "move", "turn")
"""Orders by which a back comes to be against a wall."""
_AREAS = ("area", "zone")
"""Words for the surroundings of a thing."""
_OF_WALL = ("opposite", "behind", "facing")
_ACROSS = ("opposite", "far", "facing")


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
    read = corrected(lexicon, [_corrected(lexicon, token) for token in lexicon.tokens(plain)])
    said = something_instead(reworded(with_owners(lexicon, with_heads(lexicon, read))))
    tokens = without_reasons(lexicon, without_announcements(_without_commas(_included(in_between(said)))))
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
        return _OrderReader(lexicon, clause, named, kinds).read()

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


def _without_commas(tokens: list[Token]) -> list[Token]:
    """The tokens with rows as they are read, and no comma between two adjectives: "a bigger, round one"."""
    read = _with_rows(tokens)
    return [token for at, token in enumerate(read) if not (token.text == "," and _is_of_adjectives(read, at))]


def _is_of_adjectives(tokens: Sequence[Token], at: int) -> bool:
    if at < 2 or at + 2 > len(tokens):
        return False
    adjective = means("comparatives", tokens[at - 1].text) or means("sizes", tokens[at - 1].text)
    begun = tokens[at - 2].text in ("a", "an", "the", "another", "some")
    return bool(adjective) and begun and tokens[at + 1].kind == "word" and tokens[at + 1].text not in ("and", "please")


def _included(tokens: list[Token]) -> list[Token]:
    """The tokens, where "turn the table, chairs included" says that it is turned with its chairs."""
    read = list(tokens)
    for at in reversed([n for n, token in enumerate(tokens) if means("included", token.text) or _is_too(tokens, n)]):
        comma = next((n for n in range(at - 1, max(at - 4, 0), -1) if read[n].text == ","), None)
        if comma is not None and comma < at - 1:
            own = () if read[comma + 1].text in ("the", "its", "their") else tokenise("its")
            said = [replace(token, start=-1) for token in (*tokenise("with"), *own)]
            read[comma : at + 1] = [*said, *read[comma + 1 : at]]
    return read


def _is_too(tokens: Sequence[Token], at: int) -> bool:
    """Whether it is that of ", chairs too": a bare word between a comma and it."""
    return tokens[at].text == "too" and at > 1 and tokens[at - 2].text == "," and tokens[at - 1].text not in _IT


def _with_rows(tokens: list[Token]) -> list[Token]:
    """Read "the front row" and "the back row" as the first and the last, and "a round one" as no preposition."""
    words = {"front": "first", "back": "last", "rear": "last", "final": "last"}
    tokens = _one_more(_each_row(tokens))
    read = list(tokens)
    for index, token in enumerate(tokens[:-1]):
        rows = tokens[index + 2].text == "rows" if index + 2 < len(tokens) and is_number(tokens[index + 1]) else False
        if token.text in words and (tokens[index + 1].text == "row" or rows):
            read[index] = replace(token, text=words[token.text])
    for index in range(len(tokens) - 2):
        if (tokens[index + 1].text, tokens[index + 2].text) == ("round", "one"):
            read[index + 1] = replace(tokens[index + 1], text="circular")
        if tokens[index].text in ("a", "an", "another") and tokens[index + 1].text == "lower":
            read[index + 1] = replace(tokens[index + 1], text="lowest")
    return read


def _each_row(tokens: list[Token]) -> list[Token]:
    """The tokens with "row" behind each of two numbers: "the first and the last row", "the front and back rows"."""
    read = list(tokens)
    for at in range(len(tokens) - 4, -1, -1):
        second = at + 2 + (tokens[at + 2].text == "the")
        row = tokens[second + 1] if second + 1 < len(tokens) else None
        if row is None or row.text not in ("row", "rows") or tokens[at + 1].text != "and":
            continue
        if _is_ordinal(tokens[at]) and _is_ordinal(tokens[second]):
            the = tokens[at + 2] if second > at + 2 else Token("the", "the", "word", start=-1)
            read[second + 1] = replace(row, text="row")
            read[at + 1 : second] = [replace(row, text="row", start=-1), tokens[at + 1], the]
    return read


def _one_more(tokens: list[Token]) -> list[Token]:
    """The tokens with "a sixth table" as another one, of which it is not a part."""
    read = list(tokens)
    for at in reversed(range(len(tokens) - 2)):
        counted = tokens[at].text == "a" and _is_ordinal(tokens[at + 1]) and tokens[at + 1].text != "last"
        if counted and tokens[at + 2].kind == "word" and tokens[at + 2].text not in ("of", "one"):
            words = f"{tokens[at].shown} {tokens[at + 1].shown}"
            read[at : at + 2] = [replace(tokens[at], text="another", shown=words)]
    return read


def _is_ordinal(token: Token) -> bool:
    return token.text in ("front", "back", "rear") or grammar().at([token], 0, "ordinal") is not None


def _corrected(lexicon: Lexicon, token: Token) -> Token:
    if side := means("synonyms", token.text):
        return replace(token, text=side)
    known = token.kind != "word" or any(means(s, token.text) for s in _OWN_WORDS)
    meant = "" if known else meant_by(lexicon, token.text, _of_orders())
    return replace(token, text=meant) if meant else token


@lru_cache(maxsize=1)
def _of_orders() -> frozenset[str]:
    """The words of instructions that may be meant by one with a slip: "repalce", "teh"."""
    of_verbs = frozenset(word for words in sections()["verbs"] for word in words)
    return of_verbs | frozenset(word for words in grammar().phrases for word in words)


class _OrderReader:
    """Reads the words after one verb."""

    def __init__(self, lexicon: Lexicon, clause: Clause, named: Mapping[int, str], kinds: Collection[str] = ()) -> None:
        words = clause.text.lower().split()
        verb = next((word for word in words if means("drawing", word)), words[0])
        self.order = Order(cast(Doing, clause.doing), clause.text, change=clause.change)
        told = [word.lower() for word in clause.text.split()[:4]]
        self.order.space = (
            clause.doing == "free" and told[0] in _MAKING and any(means("distances", word) == "gap" for word in told)
        )
        only = any(means("markers", w) == "only" for w in told) and not any(w.startswith("anything") for w in told)
        self.order.total = clause.doing in ("keep", "ensure") and only
        self._lexicon = lexicon
        self._cutter = ClauseCutter(lexicon, clause.doing, verb, named)
        drawn = clause.doing == "move" and bool(means("drawing", verb)) and clause.tokens[:1]
        self.order.seated = means("drawn", clause.tokens[0].text) if drawn else ""
        tokens = clause.tokens[1:] if self.order.seated else clause.tokens
        self._items = [_of_kind(item, kinds) for item in self._cutter.items(tokens)]
        self._at = 0
        self._mode = "things"
        self._so: list[NounPhrase] = []
        self._negated = False
        self._pending: bool | None = None
        self._clears = clause.doing == "free"
        self._anchors: list[Noun] = []
        self._former: list[Noun] = []
        self._excepted: NounPhrase | None = None
        self._distance = False
        self._around = False
        self._shared = False
        self._whole: Noun | None = None
        self._left: Noun | None = None
        self._more = False
        self._up_to = False
        self._only = False
        self._eached = False
        self._fraction = 0.0
        self._centring = bool(means("centring", words[0]))
        self._piling = bool(means("piling", words[0]))
        self._had = any(token.text == "to" and token.start < 0 for token in clause.tokens)

    def read(self) -> Order:
        """Read everything."""
        while self._at < len(self._items):
            item = self._items[self._at]
            self._at += 1
            match item:
                case OrderMark():
                    self._mark(item)
                case Noun():
                    self._noun(item)
                case Connector():
                    self._connector(item)
                case Measured() if self._sized() is not None:
                    self._sized().size = item.size  # type: ignore[union-attr]
                case Measured():
                    self.order.lengths += [(length.metres, length.axis) for length in item.size.lengths]
                case Adjective():
                    self._adjective(item)
                case _:
                    self._lose(item)
        self._finish()
        return self.order

    def _sized(self) -> Noun | None:
        """The new thing of which a size by itself speaks: "a round one that is 1.5 m wide"."""
        order = self.order
        new = order.instead if order.doing == "replace" else order.things if order.doing in ("add", "ensure") else []
        new = order.things if order.doing == "put" and self._new_thing() is not None else new
        return new[-1].noun if new and new[-1].noun.size is None else None

    def _finish(self) -> None:
        order = self.order
        order.slight &= not order.lengths
        if self._fraction and order.change and not order.change.endswith("="):
            order.times = 1.0 + (-self._fraction if order.change in _LESS else self._fraction)
        elif self._fraction:
            order.lost.append("by a part of it")
        self._by_verb()
        self._closer_around()
        if self._pending is False and order.direction:
            self._pending = None
        if self._pending is not None:
            order.together, order.scatter = self._pending, not self._pending
        self._spaced()
        if self._up_to and order.doing == "make" and order.change and not order.by:
            order.change = f"{order.change.removesuffix('=')}="
        somewhere = order.places and not order.things and not order.rest and not order.room
        if self._clears and order.doing == "free" and not order.free and not order.space and not somewhere:
            order.doing = "clear"
        if order.doing == "keep" and order.total:
            order.doing = "only"
        if order.doing == "add" and self._is_had_by_each():
            order.doing = "ensure"
        self._along()
        if order.doing in ("add", "put", "ensure"):
            self._comes_along(each=self._eached)
        self._nearer_one()
        self._beside_one()
        self._looked()

    def _along(self) -> None:
        """Read "take the chair along" as what goes with that which was moved before it."""
        order = self.order
        if order.doing == "move" and order.things and order.lost == ["along"] and not self._places():
            order.lost = []
            order.things[-1].places.append(Where("with", Noun("pronoun", "it", 0, 0, "it"), text="along"))

    def _nearer_one(self) -> None:
        """Read "(remove) the lamp closer to the door" as the one of several that is so."""
        order = self.order
        for nearer, phrase in order.closer if order.doing in ("remove", "replace") and order.things else ():
            text = "nearest to" if nearer else "farthest from"
            order.things[-1].places.append(Where("near", phrase.noun, text=text))
        order.closer = [] if order.doing in ("remove", "replace") and order.things else order.closer

    def _beside_one(self) -> None:
        """Read "(next to the desk) so that they stand side by side" as how one thing comes to stand beside another."""
        order, beside = self.order, [w for w in self._places() if w.word == "next_to" and not w.negated]
        if order.mutual == "next_to" and order.abreast and len(order.things) == 1 and beside:
            order.mutual = ""

    def _by_verb(self) -> None:
        """What a verb says of the place: "centre the table" in the room, and "stack the books" is not followed."""
        order = self.order
        order.centred |= self._centring and order.doing in ("move", "put")
        if order.centred and order.things and not (self._places() or order.closer or order.direction):
            middle = Noun("place", "centre", 0, 0, "the middle of the room", det="the")
            order.things[-1].places.append(Where("in", middle, text="in"))
        if self._piling and (len(order.things) > 1 or any(map(_are_several, order.things))):
            order.lost.append(order.text.split(" ", 1)[0].lower())

    def _closer_around(self) -> None:
        """Read "closer around the table" as closer to it."""
        around = next((w for w in self._places() if w.word == "around" and w.noun is not None), None)
        if not self._pending or around is None or around.noun is None:
            return
        self.order.closer.append((True, NounPhrase(around.noun)))
        for held in (self.order.places, *(phrase.places for phrase in self.order.things)):
            held[:] = [w for w in held if w is not around]
        self._pending = None

    def _looked(self) -> None:
        """Tell a wish about looks, and what is to face something, from an order to move."""
        order = self.order
        if order.doing == "put" and order.things and self._is_about_looks():
            order.doing = "make"
        if order.doing == "make" and self._is_other_count():
            order.doing, order.things, order.total = "ensure", order.things[1:], True
        if order.doing == "make" and (order.facing or order.backs or order.mutual) and order.things and not order.room:
            order.doing = "turn"
        if self._around and order.facing:
            order.turn = None
        if self._around and order.backs:
            order.turn = None
        if order.doing == "remove" and order.facing and order.things:
            order.things[-1].places += [Where("facing", noun, text="facing") for noun in order.facing]
            order.facing = []
        if order.doing == "turn" and order.closer and not order.lengths and not any(near for near, _ in order.closer):
            order.backs += [phrase.noun for _, phrase in order.closer]
            order.closer = []
        if order.doing == "put" and self._only_looks():
            order.doing = "turn"

    def _is_other_count(self) -> bool:
        """Whether it is said how many there are to be: "make it three chairs"."""
        phrases = [phrase.noun for phrase in self.order.things]
        pointed = len(phrases) == 2 and phrases[0].kind == "pronoun" and phrases[0].value in ("it", "them", "that")
        return pointed and phrases[1].kind == "thing" and bool(phrases[1].count) and not phrases[1].definite

    def _spaced(self) -> None:
        """Read what is said of the space between things, or of more space at one of them."""
        order = self.order
        about = [w for w in (*order.places, *(w for p in order.things for w in p.places)) if w.word == "between"]
        if (
            order.doing in ("free", "keep", "make", "move", "put")
            and about
            and (order.space or order.lengths)
            and (not order.things or order.doing in ("free", "keep"))
        ):
            order.doing, order.places = "gap", about[:1]
            more = self._more and not order.lengths and not order.change
            order.change = "wider" if more else order.change
            compared = bool(order.change) and not order.change.endswith("=") and not self._up_to
            order.by |= compared and bool(order.lengths) and not order.bound
        measured = order.doing in ("keep", "free", "make") and order.space and order.places and not order.things
        if measured and len(order.apart) == 1:
            order.lengths, order.apart = [(order.apart[0][0], "")], []
        if (order.doing == "put" or measured) and order.space and order.places and not order.things:
            order.doing = "free"

    def _is_had_by_each(self) -> bool:
        """Whether it is said how many each of several has: "every table should have four chairs"."""
        counted = any((phrase.noun.count or 1) > 1 for phrase in self.order.things)
        return self._had and counted and any(w.noun is not None and w.noun.each for w in self._places())

    def _places(self) -> list[Where]:
        return [*self.order.places, *(where for phrase in self.order.things for where in phrase.places)]

    def _only_looks(self) -> bool:
        """Whether all that is asked of things is what they face: they are turned, and not moved far for that."""
        order = self.order
        said = any(
            getattr(order, field) for field in SAID if field not in ("facing", "backs", "company", "rest", "spared")
        )
        whole = ("each", "all", "both")
        known = all(phrase.noun.definite or phrase.id or phrase.noun.det in whole for phrase in order.things)
        placed = any(phrase.places for phrase in order.things)
        return bool((order.facing or order.backs) and order.things) and known and not placed and not said

    def _is_about_looks(self) -> bool:
        """Whether a wish is about how a thing is, not where: "I want the sofa bigger"."""
        order = self.order
        placed = order.places or order.closer or order.direction or order.facing or any(p.places for p in order.things)
        return not placed and bool(order.looks or order.ruled_out or order.change)

    def _adjective(self, said: Adjective) -> None:
        order, free = self.order, bool(means("clear", said.text.lower()))
        spot = self._places()[-1].noun if self._places() else None
        if free and self._mode != "so" and order.doing in ("put", "add", "ensure") and spot is not None:
            if spot.kind == "place" and order.things and not order.things[-1].noun.definite:
                spot.states = ["empty"]
            else:
                order.lost.append(said.text)
        elif free and self._mode == "so":
            order.free += [phrase.noun for phrase in self._so]
        elif free and order.doing in ("keep", "put", "make", "ensure"):
            order.doing = "free"
            order.free += [phrase.noun for phrase in order.things if phrase.noun.kind in ("place", "part")]
            order.places += [where for phrase in order.things for where in phrase.places]
            things = [phrase for phrase in order.things if phrase.noun.kind not in ("place", "part")]
            self._clears = bool(things) and not order.free
            order.things[:] = things
        elif (new := self._new_thing()) is not None and said.attributes and not said.unshown:
            new.attributes += said.attributes
        elif order.doing in ("make", "put") and self._negated and said.attributes:
            self._negated = False
            order.ruled_out += said.attributes
        elif order.doing in ("make", "put") and order.things and said.attributes and not said.unshown:
            order.looks += said.attributes
        else:
            self._lose(said)

    def _new_thing(self) -> Noun | None:
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

    def _lose(self, item: Chunk) -> None:
        text = item.request.phrase if isinstance(item, SaidSurface) else getattr(item, "text", "")
        words = [w for w in text.split() if not means("fillers", w.lower())]
        if words and not is_filler(text):
            self.order.lost.append(" ".join(words))

    # --- reading

    def _mark(self, mark: OrderMark) -> None:
        order = self.order
        match mark.sort:
            case "few" | "seated" | "flanks":
                self._how(mark)
            case "lengths":
                self._length(mark)
            case "fractions":
                self._fraction = mark.value
            case "turn" | "multiples":
                setattr(order, "turn" if mark.sort == "turn" else "times", mark.value)
            case "directions":
                if order.direction:
                    order.lost.append(mark.key)
                order.direction = order.direction or mark.key
            case "clear":
                self._adjective(Adjective(0, 0, "free"))
            case "rows":
                self._row(MIDDLE_ROW if mark.key == "middle" else int(mark.key))
            case "comparatives" | "absolutes":
                self._change(mark)
            case _:
                self._marker(mark.key)

    def _change(self, mark: OrderMark) -> None:
        """Take how the size of a thing changes; of two ways the first is lost."""
        order = self.order
        if self._negated:
            self._negated = False
            order.ruled_out.append(mark.key)
            return
        absolute = mark.sort == "absolutes" and order.lengths
        if order.change and not absolute and order.change.removesuffix("=") != mark.key:
            order.lost.append(order.change.removesuffix("="))
        order.change = mark.key if mark.sort == "comparatives" else f"{mark.key}="

    def _how(self, mark: OrderMark) -> None:
        order = self.order
        order.slight |= mark.sort == "few"
        order.seated = mark.key if mark.sort == "seated" else order.seated
        if mark.sort == "flanks":
            self._flank(mark.key)

    def _flank(self, side: str) -> None:
        """Read "next to the laptop, on its left"; where nothing was named but the thing itself, it is a direction."""
        anchors = self._anchors or ([] if self._places_of_last() else self._former)
        if anchors and self.order.things:
            self.order.things[-1].places.append(Where(f"{side}_of", anchors[-1], text=f"to the {side} of"))
        elif self.order.doing == "put" and self.order.things and not self.order.lengths and not self._places_of_last():
            it = Noun("pronoun", "it", 0, 0, "it")
            self.order.things[-1].places.append(Where(f"{side}_of", it, text=f"to the {side} of"))
        else:
            self.order.direction = self.order.direction or side

    def _places_of_last(self) -> list[Where]:
        return self.order.things[-1].places if self.order.things else []

    def _row(self, number: int) -> None:
        """Read "in the front row" of what was named last."""
        phrase = self._excepted or (self.order.things[-1] if self.order.things else None)
        last = phrase.places[-1] if phrase is not None and phrase.places else None
        if last is not None and last.whole is not None and last.whole.kind == "thing":
            last.whole = replace(last.whole, rows=1, ordinal=number, plural=last.whole.many or last.whole.each)
        elif last is not None and last.noun is not None and last.noun.kind == "thing":
            several = last.noun.many or last.noun.each
            last.noun = replace(last.noun, rows=1, ordinal=number, plural=several)
        elif phrase is not None and phrase.noun.kind == "pronoun" and phrase.noun.value == "them":
            phrase.noun = replace(phrase.noun, rows=1, ordinal=number)
        elif phrase is None or phrase.noun.kind != "thing":
            self.order.lost.append("row")
        else:
            phrase.member = phrase.noun.ordinal
            middle = [w for w in phrase.places if w.noun is not None and w.noun.kind == "part" and not w.whole]
            side = next((w.noun.value for w in middle if w.noun is not None and w.noun.value in _IN_ROW), "")
            phrase.places = [w for w in phrase.places if w not in middle] if side else phrase.places
            phrase.noun = replace(phrase.noun, rows=1, ordinal=number, side=side or phrase.noun.side)

    def _length(self, mark: OrderMark) -> None:
        order, new = self.order, self._sized()
        if new is not None and order.doing != "replace" and all(axis for _, axis in mark.lengths):
            new.size = Size(tuple(Length(metres, axis, "m") for metres, axis in mark.lengths), order.text)
            return
        order.lengths += mark.lengths
        bound, _, by = mark.key.partition(" ")
        order.bound = bound if bound in ("ge", "le") else order.bound
        order.by |= by == "by" or bound == "by"
        self._up_to |= "to" in (by, bound)
        self._distance = len(mark.lengths) == 1 and not mark.lengths[0][1]

    def _marker(self, key: str) -> None:
        order = self.order
        match key:
            case "nearer" | "farther":
                self._pending = key == "nearer"
            case "clockwise" | "anticlockwise":
                order.sense = -1 if key == "clockwise" else 1
            case "round":
                self._round()
            case "elsewhere":
                order.doing = "resite"
            case "away" | "rest" | "there" | "centred":
                setattr(order, key, True)
            case "so" | "unblock":
                self._mode, self._so = key, []
            case "together":
                order.mutual = "next_to"
            case _:
                pass

    def _round(self) -> None:
        """Read "turn it round", "make the table round"."""
        order = self.order
        if order.doing == "turn" and order.turn is None:
            order.turn, self._around = 180.0, True
        elif order.doing == "make" and self._negated:
            self._negated = False
            order.ruled_out.append("round")
        elif order.doing == "make" or (order.doing == "put" and order.looks):
            order.looks.append("round")
        elif order.doing != "swap":
            order.lost.append("round")

    def _noun(self, noun: Noun) -> None:
        order = self.order
        if noun.kind == "thing" and noun.value == "enough":
            raise InputError(f"'{order.text}': how large '{noun.text}' is is not said; say a size, such as '2 by 3 m'")
        if (
            self._is_address(noun)
            or self._is_apposition(noun)
            or self._told_by_rider(noun)
            or self._is_each_of_new(noun)
            or self._is_one_of_company(noun)
        ):
            return
        noun = self._another(self._merged(noun))
        negated, self._negated = self._negated, False
        phrase = self._phrase(noun)
        if negated and order.doing == "turn" and order.facing and order.things:
            self._not_faced(noun)
        elif negated and order.things and self._mode == "things":
            order.things[-1].spared.append(phrase)
            self._excepted = phrase
        elif negated:
            order.lost.append(f"not {noun.text}")
        elif self._pending is not None and (self._mode != "so" or self._so):
            self._compared(phrase)
        elif self._excepted is not None:
            (order.things[-1].spared if order.things else order.spared).append(phrase)
            self._excepted = phrase
        elif not self._in_mode(phrase) and not self._is_of_room(noun):
            self._thing(phrase)

    def _is_apposition(self, noun: Noun) -> bool:
        """Whether it says of what was just named which of them that are: "two of the desks, the ones by the door"."""
        before = self._items[self._at - 2] if self._at > 1 else None
        following = self._items[self._at] if self._at < len(self._items) else None
        last = self.order.things[-1] if self.order.things else None
        bare = noun.kind in ("number", "pronoun") and noun.text.lower() in _THE_ONES
        told = isinstance(following, Connector) and following.sort == "prepositions"
        paused = isinstance(before, Connector) and before.sort == "mark"
        known = last is not None and last.noun.kind == "thing" and (last.noun.definite or bool(last.noun.of_known))
        return bare and told and paused and known and last is not None and not last.places

    def _told_by_rider(self, noun: Noun) -> bool:
        """Take "(the table) the printer was standing on", "it stands on", by which that is told; whether it was so.

        Raises:
            InputError: it is not said how the second of two things is to the first: "remove the desk the lamp".
        """
        before = self._items[self._at - 2] if self._at > 1 else None
        following = self._items[self._at] if self._at < len(self._items) else None
        if isinstance(before, Noun) and isinstance(following, Noun) and noun.text.lower() in ("that", "which"):
            del self._items[self._at - 1]
            self._at -= 1
            return True
        if not isinstance(before, Noun) or before.kind != "thing" or noun.kind not in ("thing", "pronoun"):
            return False
        if not (noun.definite or noun.id or _is_it(noun)) or before.det not in ("the", "my", "all", "each", "both"):
            return False
        at, past = self._at, False
        while at < len(self._items):
            verb = self._items[at]
            if not isinstance(verb, Connector) or verb.sort not in _STANDING:
                break
            past |= verb.text.lower() in _STOOD
            at += 1
        link = self._items[at] if at < len(self._items) else None
        after = self._items[at + 1] if at + 1 < len(self._items) else None
        on = isinstance(link, Connector) and link.value in ("on", "in", "inside", "on_top") and at > self._at
        if on and not isinstance(after, Noun):
            held = self._owner_of(before)
            if held is None:
                return False
            held.append(Where("with", noun, text=BORE if past else BEARS))
            self._at = at + 1
            return True
        if self.order.doing == "remove" and noun.kind == "thing":
            raise InputError(
                f"'{self.order.text}': how '{noun.text}' is to '{before.text}' is not understood; name what is to go"
            )
        return False

    def _owner_of(self, noun: Noun) -> list[Where] | None:
        """The places of the phrase that a noun is the head of; None where it is none."""
        held = [p.places for p in self.order.things if p.noun is noun or p.noun.text == noun.text]
        held += [p.places for p in self.order.things if p.places and p.places[-1].noun is noun]
        return held[0] if held else None

    def _in_mode(self, phrase: NounPhrase) -> bool:
        """Take what is said of a result, of what is not to be blocked or comes instead; whether it was one of these."""
        order, noun = self.order, phrase.noun
        if (self._is_back(noun) or self._is_head(noun)) and (behind := self._behind()) is not None:
            at_it = behind.text == "against" or behind.word == "under"
            if at_it and behind.noun is not None and order.doing in _TO_WALL and order.things:
                order.doing = "move" if order.doing == "turn" else order.doing
                order.things[-1].places.append(behind)
                order.backs += [behind.noun] if behind.word == "under" else []
            elif behind.noun is not None:
                order.backs.append(behind.noun)
        elif self._mode == "so":
            self._so.append(phrase)
        elif self._mode == "unblock" and noun.kind in ("place", "part"):
            order.free.append(noun)
            self._mode = "things"
        elif self._mode == "instead" and noun.kind in ("thing", "number"):
            order.instead.append(phrase)
        else:
            return False
        return True

    @staticmethod
    def _is_back(item: Item | None) -> bool:
        """Whether it is the back of what is spoken of."""
        named = isinstance(item, Noun) and item.det == "my" and item.value in ("back", "head")
        return named and isinstance(item, Noun) and item.kind in ("part", "thing")

    def _is_head(self, noun: Noun) -> bool:
        """Whether it is the head or the back of what is turned: "so that the head is at the wall"."""
        return (
            self._mode == "so" and self.order.doing == "turn" and noun.det == "the" and noun.value in ("back", "head")
        )

    def _behind(self) -> Where | None:
        """Read "(its back) is to the window", "against the wall"."""
        at = self._at
        verb = self._items[at] if at < len(self._items) else None
        at += isinstance(verb, Connector) and verb.sort in ("verbs", "participles")
        link, noun = (self._items[n] if n < len(self._items) else None for n in (at, at + 1))
        if not isinstance(link, Connector) or link.value not in _AT_BACK or not isinstance(noun, Noun):
            return None
        self._at = at + 2
        return Where(link.value, self._merged(noun), text=link.text.lower().removeprefix("up ").removeprefix("right "))

    def _is_of_room(self, noun: Noun) -> bool:
        """Take a noun that names the room, a space or part of it, or how something looks; whether it was one."""
        order, part = self.order, noun.kind in ("place", "part")
        about = self._about(noun)
        if about is not None:
            order.places.append(Where("around", about, text="around"))
        elif self._is_space(noun):
            order.space = True
            self._more |= noun.text.lower().startswith("more ")
        elif (noun.kind == "room" or noun.word in ("furniture", "layout")) and order.doing in _OF_ROOM:
            order.room = True
        elif part and noun.value == "ceiling" and order.doing == "make":
            order.room = order.ceiling = True
        elif order.doing == "free" and part:
            where = self._cornered(Where("in", noun, text="in"))
            if where.whole is None and where.second is None:
                order.free.append(noun)
            else:
                order.places.append(where)
        elif self._mode == "instead" and order.instead and noun.word == "size" and "same" in noun.text.split():
            order.instead[-1].noun = replace(order.instead[-1].noun, degree=SAME)
        elif noun.word == "size" and "same" in noun.text.lower().split() and (new := self._new_thing()) is not None:
            new.degree = SAME
        elif noun.kind in ("abstract", "part") and order.doing in ("make", "replace") and means("looks", noun.word):
            self._look_of(noun)
        else:
            return False
        return True

    def _about(self, noun: Noun) -> Noun | None:
        """The thing of which a phrase names the surroundings: "the sofa area"; None where it names none.

        Raises:
            InputError: it names a part of the room by what is no thing.
        """
        words = noun.text.lower().split()
        if noun.kind != "room" or self.order.doing not in ("rearrange", "free") or words[-1] not in _AREAS:
            return None
        if words[:-1] == [noun.det] or not words[:-1]:
            return None
        chunks, _ = cut(self._lexicon, self._lexicon.tokens(" ".join(words[:-1])))
        found = [chunk for chunk in chunks if isinstance(chunk, Noun) and chunk.kind == "thing" and chunk.named]
        if len(found) != 1:
            raise InputError(f"'{noun.text}': which part of the room that is is not known; name a thing that is there")
        return replace(found[0], det="the")

    def _thing(self, phrase: NounPhrase) -> None:
        order, noun = self.order, phrase.noun
        everything = noun.kind == "abstract" and noun.text.lower() == "anything" and order.doing == "keep"
        if everything or (noun.kind == "pronoun" and noun.value == "all" and order.doing in _OF_ALL):
            order.rest = True
        elif (order.things and _is_theirs(noun) and order.doing in _WITH_ALONG) or self._is_theirs_too(noun):
            order.company.append(replace(phrase, noun=self._theirs(noun)))
        elif self._is_within(noun):
            order.apart.append((order.lengths.pop()[0], phrase))
            self._distance, self._anchors = False, [noun]
        elif order.doing == "add" and order.things and noun.kind == "pronoun" and noun.det in ("both", "all", "each"):
            self._comes_along(each=True)
        elif self._is_one_of_them(noun):
            self._told_apart(noun)
        elif self._shares_out(noun):
            self._shared = True
        elif noun.kind in ("thing", "pronoun", "number", "place", "part"):
            if order.things and _is_theirs(order.things[-1].noun) and noun.kind == "thing" and not noun.det:
                phrase.noun = replace(noun, det="my", text=f"{order.things[-1].noun.text.split()[0]} {noun.text}")
            if order.things and order.things[-1].noun.rows and noun.kind == "thing" and not (noun.det or noun.count):
                phrase.noun = replace(noun, det="my", text=f"their {noun.text}")
            order.things.append(self._at_another(phrase))
            self._anchors, self._former = [], self._anchors
        else:
            self._lose(noun)

    def _theirs(self, noun: Noun) -> Noun:
        """What goes along as that of what was named before, also where its "its" is said of another: "its vase"."""
        if _is_theirs(noun) or not self.order.company:
            return noun
        return replace(noun, det="my", text=f"{self.order.company[-1].noun.text.split()[0]} {noun.text}")

    def _is_theirs_too(self, noun: Noun) -> bool:
        """Whether a bare noun belongs to what was named before as well: "(with its chairs and) vase"."""
        before = self._items[self._at - 2] if self._at > 1 else None
        joined = isinstance(before, Connector) and before.text.lower() == "and"
        bare = noun.kind == "thing" and not (noun.det or noun.count or noun.id)
        theirs = bool(self.order.company) and _is_theirs(self.order.company[-1].noun)
        return joined and bare and theirs and self.order.doing in (*_WITH_ALONG, "remove")

    def _is_each_of_new(self, noun: Noun) -> bool:
        """Whether it says of every one of what is added what comes with it: "two desks, each with a chair"."""
        new = self.order.doing in ("add", "put", "ensure") and bool(self.order.things)
        following = self._items[self._at] if self._at < len(self._items) else None
        linked = isinstance(following, Connector) and following.value == "with"
        said = new and linked and noun.kind == "pronoun" and noun.det in ("each", "both", "all")
        self._eached |= said
        return said

    def _is_one_of_company(self, noun: Noun) -> bool:
        """Take where each of what goes along is to be: "(two chairs,) one on each side"; whether it was that."""
        company = self.order.company if self.order.doing in ("add", "put", "ensure") else []
        one = noun.kind == "pronoun" and noun.value == "one" and not noun.det
        if not (company and one and (company[-1].noun.count or 0) > 1 and self._each_follows()):
            return False
        link = cast(Connector, self._items[self._at])
        self._at += 1
        company[-1].places.append(self._where(link))
        return True

    def _comes_along(self, *, each: bool) -> None:
        """Read "(two desks with a chair and) a monitor each" as what comes with every one of what is added.

        Where nobody says "each", what usually rests on such a thing does.
        """
        things = self.order.things
        head = next((n for n, p in enumerate(things) if any(w.word == "with" for w in p.places)), None)
        if head is None or things[head].noun.definite:
            return
        later, kind = things[head + 1 :], things[head].noun.value
        new = all(p.noun.kind == "thing" and not (p.noun.definite or p.places or p.id) for p in later)
        usual = all(
            any(habit.kind == "on" and kind in habit.anchors for habit in load_habits().of(p.noun.value)) for p in later
        )
        usual |= facts_of(kind).is_in("seating") and all(facts_of(p.noun.value).is_in("small") for p in later)
        if later and new and (each or usual):
            things[head].places += [Where("with", p.noun, text="with") for p in later]
            del things[head + 1 :]

    def _is_one_of_them(self, noun: Noun) -> bool:
        """Whether it tells how one of several new things looks: "two cushions, a red one and a blue one"."""
        last = self.order.things[-1].noun if self.order.things else None
        looks = noun.text.lower().split()[-1:] == ["one"] and bool(noun.attributes)
        new = self.order.doing in ("add", "put", "ensure") and last is not None and last.kind == "thing"
        several = last is not None and ((last.count or 0) > 1 or last is self._left)
        return new and looks and several and last is not None and not last.definite

    def _told_apart(self, noun: Noun) -> None:
        """Take one thing out of several that are added, which looks as is said."""
        phrase = self.order.things.pop()
        count = (phrase.noun.count or 1) - 1
        looks = [*phrase.noun.attributes, *noun.attributes]
        one = replace(phrase.noun, count=1, plural=False, det="a", attributes=looks)
        self._left = replace(phrase.noun, count=count, plural=count > 1)
        self.order.things.append(replace(phrase, noun=one, places=list(phrase.places)))
        self.order.things += [replace(phrase, noun=self._left)] if count else []

    def _is_within(self, noun: Noun) -> bool:
        """Whether a noun is that of which something is to be within a length."""
        order, before = self.order, self._items[self._at - 2] if self._at > 1 else None
        measured = isinstance(before, OrderMark) and before.sort == "lengths" and order.bound == "le"
        known = noun.kind in ("thing", "place") and bool(order.things) and len(order.lengths) == 1
        return measured and known and self._distance and order.doing in ("move", "put", "add")

    def _at_another(self, phrase: NounPhrase) -> NounPhrase:
        """Read "the monitors on desk 2 and desk 3" as those on either, where both are of one kind."""
        last = self.order.things[-1] if self.order.things else None
        before = self._items[self._at - 2] if self._at > 1 else None
        joined = isinstance(before, Connector) and before.sort in ("joins", "mark")
        if last is None or not last.places or not joined or self.order.doing not in _OF_THOSE or phrase.places:
            return phrase
        where, noun = last.places[-1], phrase.noun
        same = where.noun is not None and noun.kind == where.noun.kind == "thing" and noun.value == where.noun.value
        if not same or where.second is not None or where.whole is not None or last.noun.value == noun.value:
            return phrase
        return replace(last, noun=replace(last.noun), places=[*last.places[:-1], replace(where, noun=noun)], spared=[])

    def _shares_out(self, noun: Noun) -> bool:
        """Whether a number says how many of what is added go to each of several places: "two plants, one in each"."""
        last = self.order.things[-1] if self.order.things else None
        one = noun.kind == "pronoun" and noun.value == "one"
        bare = one or (noun.kind == "number" and not noun.det and not noun.ordinal and not noun.rows)
        return (
            self.order.doing in ("add", "put")
            and last is not None
            and bare
            and (last.noun.count or 0) > 1
            and (not last.places or self._each_follows())
        )

    def _each_follows(self) -> bool:
        """Whether a place at each of several things or sides comes next."""
        link, noun = (self._items[n] if n < len(self._items) else None for n in (self._at, self._at + 1))
        return isinstance(link, Connector) and link.sort == "prepositions" and isinstance(noun, Noun) and noun.each

    def _another(self, noun: Noun) -> Noun:
        """Read "and another on the shelf" as one more of what was named last."""
        last = self.order.things[-1].noun if self.order.things else None
        new = self.order.doing in ("add", "put") and last is not None and last.kind == "thing" and not last.definite
        bare = (
            noun.kind == "pronoun" and noun.value == "one" and not noun.det and (last is None or (last.count or 1) == 1)
        )
        if not (noun.kind == "pronoun" and (noun.det == "another" or bare) and new) or last is None:
            return noun
        return replace(last, det="another", count=noun.count, plural=False, text=f"another {last.word}")

    def _phrase(self, noun: Noun) -> NounPhrase:
        rank, _, along = self._cutter.ranks.get(id(noun), "").partition(" ")
        share = self._cutter.shares.get(id(noun), 0.0)
        if noun.det == "half":
            share = 0.5
        if noun.value.startswith(_ROW) and noun.ordinal:
            value = singular(noun.value.removeprefix(_ROW))
            noun = replace(noun, value=value, rows=1, plural=True, count=None)
        if noun.fraction[1]:
            share = noun.fraction[0] / noun.fraction[1]
        left = int(-share) if share < 0 else 0
        return NounPhrase(noun, id=noun.id, rank=int(rank or 0), along=along, share=max(share, 0.0), left=left)

    def _merged(self, noun: Noun) -> Noun:
        """Read "the last two chairs", "the largest of the tables" as one phrase; "the one" as the thing before it."""
        following = self._items[self._at] if self._at < len(self._items) else None
        whole = isinstance(following, Noun) and following.kind == "thing" and not following.det
        if noun.kind == "number" and noun.ordinal and whole and isinstance(following, Noun):
            self._at += 1
            return replace(following, ordinal=noun.ordinal, det="the", text=f"{noun.text} {following.text}")
        if noun.kind == "pronoun" and noun.value == "all" and noun.text.lower() == "all" and whole:
            self._at += 1
            return replace(cast(Noun, following), det="all", plural=True, text=f"{noun.text} {following.text}")  # type: ignore[union-attr]
        if noun.kind == "number" and noun.ordinal and isinstance(following, Noun) and following.rows > 1:
            self._at += 1
            return replace(noun, rows=following.rows, text=f"{noun.text} {following.text}")
        located = isinstance(following, Connector) and following.sort == "prepositions"
        if noun.kind == "pronoun" and noun.value == "them" and noun.count and located:
            noun = replace(noun, kind="number", det="the")
        things = [phrase.noun for phrase in self.order.things if phrase.noun.kind == "thing"]
        head = self._anchors[-1] if self._anchors and self._anchors[-1].kind == "thing" else None
        known = things[-1] if things else head
        pointed = noun.kind == "number" and (noun.det in ("the", "other", "any", "a") or noun.ordinal or noun.of_known)
        if pointed and known is not None and self._mode != "instead":
            return replace(
                noun, kind="thing", value=known.value, named=known.named, plural=(noun.count or 1) > 1,
                det=noun.det or "the", id="",
            )  # fmt: skip
        return noun

    def _is_space(self, noun: Noun) -> bool:
        """Whether a noun is the room between or before things: "the gap between", "the area in front of"."""
        following = self._items[self._at] if self._at < len(self._items) else None
        located = isinstance(following, Connector) and following.sort == "prepositions"
        waits = isinstance(following, OrderMark) and following.sort == "lengths"
        whole_room = noun.kind == "room" and noun.word == "room" and bool(noun.det)
        known = means("distances", noun.word) == "gap" or noun.value == "space"
        spoken = noun.kind in ("abstract", "room") and not whole_room and known
        whole = isinstance(following, Connector) and following.value in ("of", "with", "to", "as", "by")
        after = self._items[self._at + 1] if self._at + 1 < len(self._items) else None
        whole &= not (isinstance(after, OrderMark) and after.sort == "lengths")
        return (
            spoken
            and self.order.doing in ("free", "keep", "make", "put", "move")
            and ((located and not whole) or waits or self._is_free_noun(following))
        )

    def _is_free_noun(self, following: Item | None) -> bool:
        return self.order.space and following is None

    def _look_of(self, noun: Noun) -> None:
        """Go past "the colour of" in "change the colour of the sofa to blue", "the width of" in "to 2 m"."""
        axis = means("looks", noun.word)
        self.order.change = f"{axis}=" if axis != "words" else self.order.change
        link = self._items[self._at] if self._at < len(self._items) else None
        self._at += isinstance(link, Connector) and link.value == "of"
        self.order.doing = "make"

    def _compared(self, phrase: NounPhrase) -> None:
        """Read what a thing comes nearer to; "opposite the piano and 2 m away from it" is how far it is to be."""
        if self._is_side_towards(phrase.noun):
            return
        order, again = self.order, bool(self._anchors) and _is_it(phrase.noun)
        if again:
            phrase = NounPhrase(self._anchors[-1])
        elif phrase.noun.kind == "pronoun" and phrase.noun.value == "each":
            order.lost.append(phrase.noun.text)
        self._anchors += [phrase.noun] if phrase.noun.kind in ("thing", "place") else []
        if again and not self._pending and order.lengths:
            order.apart.append((order.lengths.pop()[0], phrase))
        else:
            order.closer.append((bool(self._pending), phrase))
        self._pending = None

    def _is_side_towards(self, noun: Noun) -> bool:
        """Take "(next to the fridge,) on the side away from the stove" as one of its sides; whether it was that."""
        places = self.order.things[-1].places if self.order.things else []
        side, anchors = places[-1] if places else None, [n for n in self._anchors if n.kind == "thing"]
        part = side is not None and side.noun is not None and side.noun.kind == "part" and side.noun.value == "side"
        if not part or side is None or side.whole is not None or not anchors or noun.kind not in ("thing", "place"):
            return False
        side.whole, side.second = anchors[-1], noun
        side.text = "on the side towards" if self._pending else AWAY_SIDE
        self._pending = None
        return True

    def _is_address(self, noun: Noun) -> bool:
        """Whether a noun speaks to somebody: "please, my dear"; one that nobody knows after a comma is lost alone."""
        if is_filler(noun.text):
            return True
        before = self._items[self._at - 2] if self._at > 1 else None
        after_comma = isinstance(before, Connector) and before.sort == "mark"
        own = noun.kind == "thing" and not noun.named and noun.det in ("my", "our", "") and not noun.id
        if after_comma and own and self.order.things and self.order.doing != "add" and self._at == len(self._items):
            self._lose(noun)
            return True
        return False

    def _connector(self, link: Connector) -> None:
        match link.sort:
            case "prepositions":
                self._preposition(link)
            case "negations" if link.value == "not":
                self._negated = True
            case "negations" if link.value == "only" and self._mode == "instead":
                self._only = True
            case "negations" if link.value == "only" and self.order.doing in ("keep", "ensure"):
                self.order.total |= not self.order.rest
            case "verbs" if link.value in ("face", *_BEING):
                self._verb(link)
            case "mutual":
                self._mutual(link)
            case "joins" if link.text.lower() in _SPOT and (noun := self._spot()) is not None:
                self._attach(Where("spot", noun, text=link.text))
            case "joins" if link.value in ("or", "stop", "but"):
                self._join(link)
            case "joins" | "mark" | "participles" | "fillers":
                pass
            case _:
                self._lose(link)

    def _spot(self) -> Noun | None:
        """Read "(where) the bookcase stands"; None where something else follows."""
        noun, verb = (self._items[n] if n < len(self._items) else None for n in (self._at, self._at + 1))
        told = (
            isinstance(verb, Connector) and verb.sort in ("verbs", "participles") and verb.value in (*_BEING, "stand")
        )
        if not isinstance(noun, Noun) or noun.kind not in ("thing", "pronoun", "number") or not told:
            return None
        self._at += 2
        return self._merged(noun) if noun.kind == "thing" else noun

    def _verb(self, link: Connector) -> None:
        if link.value == "face":
            self._face()
        elif self._mode == "so" and self._is_free_next():
            self.order.free += [phrase.noun for phrase in self._so]
        elif self._is_other_order(link):
            raise InputError(f"'{self.order.text}': '{link.text}' begins another order; give each as a sentence")

    def _is_other_order(self, link: Connector) -> bool:
        """Whether a verb behind "and" would begin an order of another kind: "remove this and stand that there"."""
        before = self._items[self._at - 2] if self._at > 1 else None
        joined = isinstance(before, Connector) and before.text.lower() in ("and", "then")
        return joined and self.order.doing in _OF_THOSE and means("verbs", link.text.lower()) == "put"

    def _join(self, link: Connector) -> None:
        """Read "all of the chairs but one"; "or" and reasons are not followed."""
        if link.value != "but":
            self._lose(link)
        elif self._is_exception() and (noun := self._next_noun()) is not None:
            self._placed(Where("except", self._merged(noun), text=link.text))

    def _is_exception(self) -> bool:
        noun = self._items[self._at] if self._at < len(self._items) else None
        said = self.order.things[-1].noun if self.order.things else None
        if said is None and self.order.rest:
            return isinstance(noun, Noun) and noun.kind == "thing"
        every = said is not None and (said.det in ("all", "each") or said.plural)
        counted = isinstance(noun, Noun) and noun.kind in ("thing", "number", "pronoun")
        return every and counted and self._mode in ("things", "instead")

    def _mutual(self, link: Connector) -> None:
        """Read "so that they face each other", "next to each other", or not so."""
        things = self.order.things
        if self._negated:
            self._negated = False
            if link.value != "next_to" or len(things) != 2 or self.order.doing not in ("move", "put"):
                self.order.lost.append(f"not {link.text}")
                return
            things[0].places.append(Where("next_to", things.pop().noun, negated=True, text=link.text))
        elif link.text.lower() in _OF_TWO:
            self._of_two(_OF_TWO[link.text.lower()], link)
        elif (link.value == "facing" and self.order.doing in ("move", "put", "turn", "rearrange", "make")) or (
            link.value == "next_to" and self.order.doing in ("move", "put")
        ):
            self.order.mutual = link.value
            self.order.abreast |= link.text.lower() == "side by side"
        elif link.value == "next_to" and self.order.doing == "replace" and self._mode == "instead":
            self.order.abreast = True
        else:
            self._lose(link)

    def _of_two(self, mutual: str, link: Connector) -> None:
        """Read "face to face", "back to back" of two things that are moved; such things are not turned alone.

        Raises:
            InputError: the order is no such.
        """
        if self.order.doing not in ("move", "put"):
            raise InputError(
                f"'{self.order.text}': how things stand '{link.text}' is followed where two are put so; say 'put'"
            )
        self.order.mutual = mutual

    def _is_free_next(self) -> bool:
        item = self._items[self._at] if self._at < len(self._items) else None
        free = isinstance(item, Connector | Noun) and bool(means("clear", item.text.lower()))
        self._at += free
        return free

    def _face(self) -> None:
        """Read "to face the room", "so that it faces the door", "(the wardrobe,) not at the bed"."""
        following = self._items[self._at] if self._at < len(self._items) else None
        if self._negated and self.order.facing and isinstance(following, Noun):
            self._at += 1
            self._not_faced(following)
            return
        if isinstance(following, OrderMark) and following.key == "farther":
            return
        if self._faces_by_compass(following):
            return
        noun = self._next_noun()
        if noun is None:
            self.order.lost.append("face")
        elif noun.kind == "pronoun" and noun.value == "each":
            self.order.mutual = "facing"
        else:
            self.order.facing.append(self._sided(self._merged(noun)))
            self._anchors = self.order.facing[-1:]

    def _not_faced(self, noun: Noun) -> None:
        """Take "(so that it faces the wardrobe,) not the bed" as what it is not to face."""
        self._negated = False
        for phrase in self.order.things:
            phrase.places.append(Where("facing", self._merged(noun), negated=True, text="not facing"))

    def _sided(self, noun: Noun) -> Noun:
        """Take "(towards) the chair on the right" as the right one."""
        link, side = (self._items[n] if n < len(self._items) else None for n in (self._at, self._at + 1))
        on = isinstance(link, Connector) and link.value == "on"
        if noun.kind != "thing" or not on or not isinstance(side, Noun) or side.kind != "part":
            return noun
        if side.value not in ("left", "right") or side.det != "the" or side.owner:
            return noun
        self._at += 2
        return replace(noun, side=side.value)

    def _faces_by_compass(self, following: Item | None) -> bool:
        """Take "(facing) north" as the wall that is there; whether it is that."""
        if not isinstance(following, OrderMark) or following.key not in COMPASS:
            return False
        self._at += 1
        self.order.facing.append(Noun("place", f"{following.key}_wall", 0, 0, following.key))
        return True

    def _next_noun(self) -> Noun | None:
        item = self._items[self._at] if self._at < len(self._items) else None
        if not isinstance(item, Noun):
            return None
        self._at += 1
        return item

    def _preposition(self, link: Connector) -> None:
        order, following = self.order, self._items[self._at] if self._at < len(self._items) else None
        if not isinstance(following, Noun):
            self._without_noun(link, following)
            return
        self._narrowed()
        if self._with_own(link, following):
            return
        towards = link.text.lower() in ("towards", "toward")
        if self._comes_instead(link, following):
            self._mode = "instead"
        elif order.doing == "swap" and link.value in ("with", "for", "and"):
            order.split = order.split or len(order.things)
        elif self._becomes(link, following) or self._is_purpose(link, following):
            self._at += 1
        elif towards and order.doing in ("move", "put"):
            self._pending = True
        elif order.doing == "turn" and link.value == "at" and not towards and (self._excepted or self._faces_later()):
            self._placed(self._where(link))
        elif order.doing == "turn" and (towards or link.value in ("to", "facing", "at", "in_front_of")):
            self._face()
        elif not (following.kind in ("part", "place") and following.value == "ceiling" and order.doing == "make"):
            self._placed(self._where(link))

    def _with_own(self, link: Connector, following: Noun) -> bool:
        """Take "with its back (to it)", "with its long side along it", "with everything on it"; whether it was that."""
        if link.value == "with" and self._with_side(following):
            return True
        return (link.value in ("with", "so") and self._is_back(following)) or self._with_all_on_it(link, following)

    def _faces_later(self) -> bool:
        """Whether what things are to face is still to come: "turn the chairs at the table towards the door"."""
        later = self._items[self._at :]
        return any(isinstance(item, Connector) and item.text.lower() in _TOWARDS for item in later)

    def _becomes(self, link: Connector, following: Noun) -> bool:
        """Read "into a reading corner"; "in the room" says nothing."""
        order = self.order
        into = link.text.lower() == "into" and order.doing in ("turn", "make")
        if into and following.kind == "thing" and order.things:
            order.doing, self._mode = "replace", "instead"
            self._at -= 1
            return True
        if following.kind != "room":
            return False
        turned = order.doing == "turn" and following.det == "the"
        if link.text.lower() == "into" and order.doing in ("move", "put") and order.lengths and not order.closer:
            order.closer.append((False, NounPhrase(Noun("place", "wall", 0, 0, "the wall", det="the"))))
            return True
        if order.doing in ("rearrange", "make", "replace", "turn") and link.value in ("in", "as") and not turned:
            order.into = following.value if order.doing != "make" else ""
            order.doing = "rearrange" if order.doing in ("turn", "replace") else order.doing
            return True
        return link.value in ("in", "of", "from", "to", "around")

    def _is_purpose(self, link: Connector, following: Noun) -> bool:
        """Whether words say what for: "make room for a wheelchair", "a chair for the teacher"."""
        if link.value != "for":
            return False
        if following.text.lower().startswith(("a group of ", "a party of ")):
            self.order.purpose.append(following)
            return True
        if following.kind == "people":
            self.order.lost.append(f"{link.text} {following.text}")
        elif self.order.doing in ("free", "gap"):
            self.order.purpose.append(following)
        return following.kind == "people" or self.order.doing in ("free", "gap")

    def _without_noun(self, link: Connector, following: Item | None) -> None:
        """A preposition that no noun follows says how a thing is, waits for a length, or is lost."""
        order, text = self.order, link.text.lower()
        if isinstance(following, Connector) and following.text.lower() in _SPOT:
            return
        if link.value == "facing" and self._faces_by_compass(following):
            return
        if text in _SHAPES and order.doing in ("make", "put") and order.things:
            order.looks.append(text)
        elif (isinstance(following, Adjective) and order.doing in _OF_LOOKS and link.value in ("to", "in")) or (
            link.value == "of" and isinstance(following, Noun | OrderMark)
        ):
            pass
        elif not isinstance(following, OrderMark | Measured | Connector) or (
            isinstance(following, Connector) and following.sort not in ("prepositions", "verbs", "fillers", "mutual")
        ):
            self._lose(link)

    def _placed(self, where: Where) -> None:
        order = self.order
        if where.word == "except" and where.noun is not None:
            noun = where.noun
            self._excepted = NounPhrase(noun, id=noun.id)
            if order.doing in ("add", "put", "ensure") and any(w.noun and w.noun.each for w in self._places()):
                order.besides.append(self._excepted)
                return
            (order.things[-1].spared if order.things else order.spared).append(self._excepted)
            return
        if where.word == "instead" and where.noun is not None:
            self._instead_of(where, where.noun)
            return
        if where.word == "as" and where.noun is not None and where.noun.value == "possible":
            self._utmost(self._places()[-1] if self._places() else where)
            return
        if "possible" in where.text.lower().split():
            self._utmost(where)
        said = (self._is_on_new(where), self._is_on_what_bears(where), self._is_like_those(where))
        if any(said) or self._is_without_gap(where):
            return
        order.centred |= where.word == "between" and bool(means("halfway", where.text.lower().split()[0]))
        on_it = where.noun is not None and _is_it(where.noun)
        self._refer(where)
        if self._goes_along(where) or (on_it and self._rides(where)):
            return
        if self._distance and where.noun is not None and order.lengths and where.word not in ("between", "to", "along"):
            self._distance = False
            phrase = NounPhrase(where.noun, id=where.noun.id)
            order.apart.append((order.lengths.pop()[0], phrase))
            self._anchors = [where.noun]
            if where.word in ("from", "far", "near", "next_to", "by"):
                return
        self._attach(where)

    def _is_on_new(self, where: Where) -> bool:
        """Whether what comes along with a new thing is said to be on that: "two tables with a lamp on each"."""
        order, noun = self.order, where.noun
        said = order.things[-1].places[-1:] if order.things and not order.company else []
        along = bool(order.company) or (bool(said) and said[0].word == "with")
        new = order.doing in ("add", "put", "ensure") and along and bool(order.things)
        it = noun is not None and noun.kind == "pronoun" and noun.value in ("it", "them", "each")
        return new and it and where.word in ("on", "on_top") and not order.things[-1].noun.definite

    def _is_on_what_bears(self, where: Where) -> bool:
        """Whether it is the end of "(keep) the sideboard with the vase on it", which is told by that."""
        said = self.order.things[-1].places[-1:] if self.order.things else []
        bears = bool(said) and said[0].word == "with" and said[0].noun is not None and said[0].noun.kind == "thing"
        return bears and where.word in ("on", "on_top") and where.noun is not None and _is_it(where.noun)

    def _is_like_those(self, where: Where) -> bool:
        """Whether a new thing is to be "like the others", as it is anyway."""
        other = where.noun is not None and where.noun.det == "other"
        return where.word == "as" and other and self.order.doing == "add"

    def _is_without_gap(self, where: Where) -> bool:
        """Take "(side by side) without a gap"; whether it was that."""
        gap = where.noun is not None and means("distances", where.noun.word) == "gap"
        self.order.touching |= where.word == "without" and gap
        return where.word == "without" and gap

    def _narrowed(self) -> None:
        """After "but only" places say which things are meant: "change the chairs for stools but only at a desk"."""
        if self._mode == "instead" and self._only:
            self._mode, self._only = "things", False

    def _rides(self, where: Where) -> bool:
        """Take "the cabinet and the printer on it" as the cabinet, with which the printer goes along."""
        order = self.order
        if where.word not in ("on", "in", "inside") or order.doing not in _WITH_ALONG or len(order.things) != 2:
            return False
        head, rider = order.things
        if rider.places or head.places or not rider.noun.definite or where.noun is not head.noun:
            return False
        order.company.append(order.things.pop())
        return True

    def _utmost(self, where: Where) -> None:
        """Read "as far from it as possible" as the corner farthest from it, "as near as possible" as beside it."""
        if where.word == "far" and where.noun is not None and where.noun.kind in ("thing", "place"):
            where.word, where.second, where.text = "in", where.noun, "in"
            where.noun = Noun("place", "corner", 0, 0, "the corner", det="the")
        elif where.word in ("near", "next_to", "by"):
            where.word = "next_to"
        else:
            self.order.lost.append("as possible")

    def _with_all_on_it(self, said: Connector, noun: Noun) -> bool:
        """Whether "with everything on it" says that what rests on the thing is meant too."""
        everything = said.value == "with" and noun.kind == "pronoun" and noun.value == "all"
        link, it = (self._items[n] if n < len(self._items) else None for n in (self._at + 1, self._at + 2))
        on_it = isinstance(link, Connector) and link.value == "on" and isinstance(it, Noun) and _is_it(it)
        if not everything or not on_it or not self.order.things:
            return False
        self._at += 3
        for phrase in self.order.things:
            phrase.laden = True
        return True

    def _instead_of(self, where: Where, noun: Noun) -> None:
        """Read "on the stand instead of the table", "add a stool instead of the chair"."""
        order = self.order
        places = order.things[-1].places if order.things else order.places
        known = bool(order.things) and (order.things[-1].noun.definite or bool(order.things[-1].id))
        if "place" in where.text.lower().split() and known and not places and order.doing in ("put", "move"):
            places.append(Where("spot", noun, text="where"))
        elif places:
            places.append(Where(places[-1].word, noun, negated=True, text=INSTEAD))
        elif order.doing in ("add", "put", "ensure") and order.things and self._is_other_number(noun):
            order.doing, order.total = "ensure", True
        elif order.doing in ("add", "put", "ensure") and order.things and noun.kind == "thing":
            order.doing, order.instead, order.things = "replace", order.things, [NounPhrase(noun, id=noun.id)]
        else:
            order.lost.append(f"{where.text} {noun.text}")

    def _is_other_number(self, noun: Noun) -> bool:
        """Whether there are to be so many of one kind, not another number of them: "four chairs instead of two"."""
        last = self.order.things[-1].noun
        of_them = noun.kind == "number" or (noun.kind == "thing" and noun.value == last.value and not noun.attributes)
        return of_them and bool(noun.count and last.count) and last.kind == "thing" and not last.definite

    def _goes_along(self, where: Where) -> bool:
        """Take "with its chairs", "and the chairs with it" as what goes along."""
        order, noun = self.order, where.noun
        if where.word != "with" or noun is None or order.doing not in (*_WITH_ALONG, "remove") or not order.things:
            return False
        if _is_it(noun) and len(order.things) > 1:
            order.company.append(order.things.pop())
            return True
        if _is_it(noun) and order.company and _is_theirs(order.company[-1].noun):
            return True
        if noun.kind == "thing":
            order.company.append(NounPhrase(noun, id=noun.id))
            return True
        return False

    def _refer(self, where: Where) -> None:
        """Let "it" mean what the same clause named before: an anchor of the thing, or another thing that is there."""
        noun, things = where.noun, self.order.things
        if noun is not None and _is_it(noun) and where.word != "with":
            walled = bool(self._anchors) and self._anchors[-1].kind == "place" and bool(self._former)
            if walled and "wall" in self._anchors[-1].value:
                where.noun = self._former[-1]
            elif self._anchors[-1:] and self._anchors[-1].value == "floor":
                pass
            elif self._anchors:
                where.noun = self._anchors[-1]
            elif len(things) > 1 and self.order.doing in _ON_KNOWN and things[-2].noun.kind == "thing":
                where.noun = things[-2].noun
        if where.word != "with" or self.order.doing not in ("add", "put"):
            self._anchors += [n for n in (where.noun, where.whole, where.second) if n and n.kind in ("thing", "place")]

    def _comes_instead(self, link: Connector, following: Noun) -> bool:
        """Whether what follows comes in place of the thing: "replace A with a B", "swap A for a B"."""
        order = self.order
        if following.kind not in ("thing", "number") or not order.things:
            return False
        pointed = following.of_known or following.definite or following.id or following.det in ("the", "other")
        new = not pointed and (
            following.det in ("a", "another", "") or (following.kind == "number" and not following.rows)
        )
        if order.doing == "replace":
            return link.value in ("with", "by", "for") or (link.value in ("in", "to") and new)
        if order.doing == "swap" and (link.value == "for" or (link.value == "with" and new)) and new:
            order.doing = "replace"
            return True
        return False

    def _where(self, link: Connector) -> Where:
        word = "from" if link.text.lower() == "out of" else link.value
        where = Where(word, None, negated=self._negated, text=link.text)
        self._negated = False
        noun = self._next_noun()
        where.noun = self._merged(noun) if noun is not None else None
        if link.value == "per" and where.noun is not None:
            where.word, where.noun = "to", replace(where.noun, det="each")
        item = self._items[self._at] if self._at < len(self._items) else None
        if isinstance(item, Connector) and item.value == "of" and where.noun is not None:
            self._at += 1
            whole = self._next_noun()
            where.whole = self._merged(whole) if whole is not None and whole.kind == "number" else whole
        elif self._is_side_of_it(where.noun):
            where.whole = Noun("pronoun", "it", 0, 0, "it")
        elif self._is_other_part(where.noun):
            where.whole = self._whole
        self._whole = where.whole or self._whole
        if link.value == "between" and self._is_and():
            self._at += 1
            where.second = self._next_noun()
        return self._cornered(where)

    def _is_other_part(self, noun: Noun | None) -> bool:
        """Whether it is a part of what another thing goes to a part of: "to the left end of it, the lamp to the right".

        What is said of one thing alone is a part of the room.
        """
        part = noun is not None and noun.kind == "part" and noun.value in (*_IN_ROW, *_SIDED) and not noun.owner
        return part and self._whole is not None and len(self.order.things) > 1

    def _is_side_of_it(self, noun: Noun | None) -> bool:
        """Whether an order to add names sides or ends, and not of what: "add two chairs at the ends"."""
        sided = noun is not None and noun.kind == "part" and noun.value in _SIDED and not noun.owner
        return sided and self.order.doing in ("add", "put") and noun is not None and (noun.plural or noun.each)

    def _cornered(self, where: Where) -> Where:
        """Read "the corner by the window", "the corner opposite the door" as one place."""
        noun, link = where.noun, self._items[self._at] if self._at < len(self._items) else None
        beside = self._items[self._at + 1] if self._at + 1 < len(self._items) else None
        cornered = noun is not None and noun.kind == "place" and noun.value.split()[0] in ("corner", "wall")
        if where.word == "from" and isinstance(link, Connector) and link.text.lower() == "to":
            return where
        if not cornered or noun is None or where.whole is not None or self._told_by(where, noun, link, beside):
            return where
        each = noun.each or noun.plural
        if each and (
            not isinstance(link, Connector) or link.value not in _ASIDE or not noun.value.startswith("corner")
        ):
            return where
        if noun.value.startswith("wall") and (not isinstance(link, Connector) or link.value not in _OF_WALL):
            return where
        if (
            not isinstance(link, Connector)
            or not isinstance(beside, Noun)
            or link.value not in (*_ASIDE, *_ACROSS, "behind")
        ):
            return where
        if beside.kind in ("number", "pronoun"):
            beside = self._merged(beside)
        if beside.kind not in ("place", "thing"):
            return where
        if each and beside.kind != "place":
            return where
        self._at += 2
        if link.value in _ACROSS:
            where.second = beside
        else:
            where.whole = beside
        return where

    def _told_by(self, where: Where, noun: Noun, link: Item | None, beside: Item | None) -> bool:
        """Read "the corner where the plant is", "the wall with the window"; whether it was that."""
        if isinstance(link, Connector) and link.text.lower() in _SPOT:
            self._at += 1
            where.whole = self._spot()
            self._at -= where.whole is None
            return True
        if not noun.value.startswith("wall") or not self._is_wall_of(noun, link, beside):
            return False
        self._at += 2
        where.noun = replace(noun, text="the wall with", states=[], unshown=[])
        where.whole = cast(Noun, beside)
        return True

    @staticmethod
    def _is_wall_of(wall: Noun, link: Item | None, item: Item | None) -> bool:
        """Whether a wall is told by what is at it: "the same wall as the door", "the wall with the window"."""
        word = "as" if "same" in wall.text.lower().split() else "with"
        if not isinstance(link, Connector) or link.value != word or not isinstance(item, Noun):
            return False
        opening = item.kind == "place" and item.value.split()[0] in ("window", "door")
        return opening or (item.kind == "thing" and item.definite)

    def _is_and(self) -> bool:
        item = self._items[self._at] if self._at < len(self._items) else None
        after = self._items[self._at + 1] if self._at + 1 < len(self._items) else None
        return isinstance(item, Connector) and item.sort == "joins" and isinstance(after, Noun)

    def _attach(self, where: Where) -> None:
        noun = where.noun
        if self.order.room and self.order.doing == "make" and noun is not None and where.whole is None:
            side = next((side for side in COMPASS if noun.value in (side, f"{side}_wall")), "")
            if side and not self.order.direction:
                self.order.direction = side
                return
        if self._shared and where.noun is not None and where.noun.each:
            where.noun = replace(where.noun, det="all", plural=True)
        if self._mode == "so":
            self._of_result(where)
        elif self._excepted is not None and not (where.text.lower() in _INTO and self.order.doing in ("move", "put")):
            self._excepted.places.append(where)
        elif self._is_laden(where):
            self.order.things[-1].laden, self.order.rest = True, False
        elif self.order.closer and not self.order.closer[-1][1].places and where.word not in ("to", "on"):
            self.order.closer[-1][1].places.append(where)
        elif self._mode == "instead" and self.order.instead:
            self.order.instead[-1].places.append(where)
        elif self.order.things:
            self.order.things[-1].places.append(where)
        else:
            self.order.places.append(where)

    def _is_laden(self, where: Where) -> bool:
        """Whether this is what rests on the thing itself: "the table and what is on it"."""
        things = self.order.things
        alone = where.noun is not None and _is_it(where.noun) and where.word in ("on", "in", "inside", "on_top")
        told = self.order.rest if self.order.doing == "keep" else self.order.doing in _ON_KNOWN
        alone &= self._mode != "instead"
        return alone and bool(things) and things[-1].noun.kind == "thing" and told

    def _of_result(self, where: Where) -> None:
        """Read "so that it is next to the bed", "so that nothing stands in the centre", "so there is room in it"."""
        said = self._so[-1].noun if self._so else None
        apart = where.word == "between" and where.second is not None and where.noun is not None and _is_it(where.noun)
        if apart and self.order.lengths and where.second is not None:
            self.order.apart.append((self.order.lengths.pop()[0], NounPhrase(where.second, id=where.second.id)))
            return
        if said is not None and self._is_lengthwise(said, where):
            return
        if said is not None and said.kind == "part" and said.value in (*_SIDED, *_IN_ROW, "front"):
            self.order.lost.append(f"{said.text} {where.text} {where.noun.text if where.noun else ''}".strip())
            return
        if self._is_borne(where):
            return
        kept_clear = said is None or said.kind in ("room", "abstract") or said.text.lower().startswith(("no", "more"))
        if kept_clear and where.noun is not None:
            self.order.free.append(where.noun)
        elif self.order.things:
            self.order.things[-1].places.append(where)

    def _is_borne(self, where: Where) -> bool:
        """Take "(make the rug bigger so that) the sofa and both armchairs are on it"; whether it was that."""
        order = self.order
        it = where.noun is not None and _is_it(where.noun) and where.word in ("on", "on_top") and not where.negated
        known = bool(self._so) and all(p.noun.kind == "thing" and (p.noun.definite or p.id) for p in self._so)
        if not (it and known and order.doing == "make" and len(order.things) == 1):
            return False
        order.bears += self._so
        return True

    def _with_side(self, said: Noun) -> bool:
        """Take "with its long side along the west wall"; whether it was that."""
        link, wall = (self._items[n] if n < len(self._items) else None for n in (self._at + 1, self._at + 2))
        if said.kind != "part" or not isinstance(link, Connector) or not isinstance(wall, Noun):
            return False
        if not self._is_lengthwise(said, Where(link.value, wall, text=link.text)):
            return False
        self._at += 3
        return True

    def _is_lengthwise(self, said: Noun, where: Where) -> bool:
        """Take "(so that) its long side is along the west wall" as how it comes to stand there; whether it was that."""
        order, wall = self.order, where.noun
        at_wall = (
            wall is not None and wall.kind == "place" and "wall" in wall.value and where.word in (*_AT_BACK, "along")
        )
        if said.value not in ("long_side", "short_side") or not at_wall or order.doing not in _TO_WALL or where.negated:
            return False
        if len(order.things) != 1 or order.turn is not None:
            return False
        order.doing = "move"
        order.things[0].places.append(replace(where, word="along", text=said.value))
        return True


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


def _is_theirs(noun: Noun) -> bool:
    """Whether it belongs to what was named before: "its chairs"."""
    words = [word for word in noun.text.lower().split() if word not in ("all", "both", "of")]
    return noun.det in ("my", "all", "both") and words[:1] in (["its"], ["their"], ["her"], ["his"])


def _are_several(phrase: NounPhrase) -> bool:
    return phrase.noun.many or (phrase.noun.kind == "pronoun" and phrase.noun.value == "them")


def _is_it(noun: Noun) -> bool:
    return noun.kind == "pronoun" and noun.value in ("it", "them")
