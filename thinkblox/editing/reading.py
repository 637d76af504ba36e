"""Instructions to orders: the reader's noun phrases and prepositions, and a grammar of what is done with them."""

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import cast

from thinkblox.editing.grammar import is_filler, longest, means, verbs
from thinkblox.editing.orders import Doing, Instruction, NounPhrase, Order
from thinkblox.errors import InputError
from thinkblox.reading.english.chunker import cut
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Measured, Noun, SaidSurface
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.english.slips import meant_by
from thinkblox.reading.lexicon import Lexicon, load
from thinkblox.reading.sizes import read_size
from thinkblox.reading.tokens import Token

MAX_INSTRUCTION = 2000
"""Longest instruction that is read [characters]."""
_ID = re.compile(r"\b[A-Za-z][A-Za-z0-9_.-]*_[0-9]+\b")
_POINTERS = frozenset(
    "the a an both all it them my every each that this these those another some only just its their our any no more"
    " everything nothing".split()
)
"""Words after a verb in the middle of a sentence, by which it is told from a noun."""
_ENDS = (".", ";", "!", "?", "\n")
_DEGREES = ("degrees", "degree", "deg", "°")
_ANYWHERE = ("nearer", "farther", "clockwise", "anticlockwise", "elsewhere", "rest", "as_is", "so", "places")
_AT_END = ("round", "away", "places_of_both")
_OF_ROOM = ("make", "rearrange", "free", "keep")
_ON_KNOWN = ("move", "turn", "replace", "remove", "swap", "free", "resite")
"""Orders whose things are in the room already."""
_FREE = ("free", "empty", "clear", "open", "uncluttered", "unobstructed")


@dataclass
class _Mark:
    """A phrase of an instruction's own grammar: its section and key, and the angle or the lengths that it names."""

    sort: str
    key: str
    value: float = 0.0
    lengths: tuple[tuple[float, str], ...] = ()


_Item = Chunk | _Mark


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
    plain, named = _without_ids(text, ids)
    tokens = [_corrected(lexicon, token) for token in lexicon.tokens(plain)]
    orders: list[Order] = []
    unknown: list[str] = []
    for doing, change, part in _clauses(tokens, unknown):
        shown = " ".join(token.shown for token in part)
        reader = _OrderReader(lexicon, Order(cast(Doing, doing), shown, change=change), part, named)
        orders += reader.read()
        unknown += reader.unknown
    if not orders:
        words = ", ".join(verbs())
        raise InputError(f"{_short(text)!r} does not say what to do with the room; an instruction begins with {words}")
    return Instruction(text, tuple(orders), tuple(unknown))


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


def _corrected(lexicon: Lexicon, token: Token) -> Token:
    known = token.kind != "word" or any(means(s, token.text) for s in ("verbs", "fillers", "comparatives", "resizing"))
    meant = "" if known else meant_by(lexicon, token.text)
    return replace(token, text=meant) if meant else token


def _clauses(tokens: Sequence[Token], unknown: list[str]) -> Iterator[tuple[str, str, list[Token]]]:
    """The orders of a text: what is done, how the room changes by that, and the words after the verb."""
    starts: list[tuple[int, int, str, str]] = []
    index, fresh, first = 0, True, True
    while index < len(tokens):
        token = tokens[index]
        found = _verb(tokens, index, first=first) if fresh else None
        if found is not None:
            key, change, length = found
            starts.append((index, index + length, key, change))
            index, fresh, first = index + length, False, False
            continue
        filler = longest("fillers", tokens, index) if fresh else None
        if token.text in _ENDS:
            fresh = first = True
        elif token.text in (",", "and", "then", "but", "also", "while"):
            fresh = True
        elif filler is not None:
            index += filler[1]
            continue
        else:
            fresh = first = False
        index += 1
    lead = tokens[: starts[0][0]] if starts else tokens
    unknown += [t.shown for t in lead if t.kind == "word" and not _is_filler(lead, t)]
    for number, (_, begin, key, change) in enumerate(starts):
        end = starts[number + 1][0] if number + 1 < len(starts) else len(tokens)
        yield key, change, list(tokens[begin:end])


def _is_filler(tokens: Sequence[Token], token: Token) -> bool:
    at = tokens.index(token)
    spans = ((start, longest("fillers", tokens, start)) for start in range(at + 1))
    return any(found is not None and start + found[1] > at for start, found in spans)


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
    pointed = after is not None and (after.text in _POINTERS or after.kind == "number")
    pointed |= after is not None and grammar().at([after], 0, "count") is not None
    if not first and not pointed:
        return None
    return found[0], change[0] if change else "", found[1]


class _OrderReader:
    """Reads the words after one verb."""

    def __init__(self, lexicon: Lexicon, order: Order, tokens: list[Token], named: dict[int, str]) -> None:
        self.order = order
        self.orders = [order]
        self.unknown: list[str] = []
        self._lexicon, self._named = lexicon, named
        self._ranks: dict[int, int] = {}
        self._rank: dict[int, int] = {}
        self._items = list(self._cut(tokens))
        self._at = 0
        self._mode = "things"
        self._so: list[NounPhrase] = []
        self._negated = False
        self._pending: bool | None = None
        self._clears = order.doing == "free"
        self._anchors: list[Noun] = []
        self._excepted: NounPhrase | None = None

    def read(self) -> list[Order]:
        """Read everything."""
        while self._at < len(self._items):
            item = self._items[self._at]
            self._at += 1
            match item:
                case _Mark():
                    self._mark(item)
                case Noun():
                    self._noun(item)
                case Connector():
                    self._connector(item)
                case Measured():
                    self.order.lengths += [(length.metres, length.axis) for length in item.size.lengths]
                case Adjective() if self._mode == "so" and item.text.lower() in _FREE:
                    self.order.free += [phrase.noun for phrase in self._so]
                case Adjective() if self.order.doing == "keep" and item.text.lower() in _FREE:
                    self.order.doing = "free"
                    self.order.free += [phrase.noun for phrase in self.order.things]
                    self.order.things.clear()
                case _:
                    self._lose(item)
        if self._pending is not None:
            self.order.together = self._pending
        if self._clears and self.order.doing == "free" and not self.order.free:
            self.order.doing = "clear"
        return self.orders

    def _lose(self, item: Chunk) -> None:
        text = item.request.phrase if isinstance(item, SaidSurface) else getattr(item, "text", "")
        words = [w for w in text.split() if not means("fillers", w.lower())]
        if words:
            self.unknown.append(" ".join(words))

    # --- cutting

    def _cut(self, tokens: list[Token]) -> Iterator[_Item]:
        run: list[Token] = []
        index = 0
        while index < len(tokens):
            rank = means("sizes", tokens[index].text) if run and run[-1].text in ("the", "my", "that") else ""
            if rank and self.order.doing != "add" and index + 1 < len(tokens) and tokens[index + 1].kind == "word":
                self._ranks[tokens[index + 1].start] = int(rank)
                index += 1
                continue
            found = self._marked(tokens, index)
            if found is None:
                run.append(tokens[index])
                index += 1
                continue
            yield from self._chunks(run)
            run = []
            yield found[0]
            index += found[1]
        yield from self._chunks(run)

    def _chunks(self, run: list[Token]) -> Iterator[Chunk]:
        if not run:
            return
        chunks, _ = cut(self._lexicon, run)
        for chunk in chunks:
            if isinstance(chunk, Noun):
                ids = [self._named[t.start] for t in run[chunk.start : chunk.end] if t.start in self._named]
                if ids:
                    chunk.id = ids[0]
                ranks = [self._ranks[t.start] for t in run[chunk.start : chunk.end] if t.start in self._ranks]
                self._rank[id(chunk)] = ranks[0] if ranks else 0
            yield chunk

    def _marked(self, tokens: list[Token], at: int) -> tuple[_Mark, int] | None:
        """The phrase of the instruction's grammar that begins at a token, and its length."""
        measure = _angle(tokens, at) or self._lengths(tokens, at)
        if measure is not None:
            return measure
        if self.order.doing == "make":
            for sort in ("comparatives", "absolutes"):
                found = longest(sort, tokens, at)
                if found is not None:
                    return _Mark(sort, found[0]), found[1]
        found = longest("directions", tokens, at)
        if found is not None and self.order.doing in ("move", "put", "turn") and _ends(tokens, at + found[1]):
            return _Mark("directions", found[0]), found[1]
        found = longest("markers", tokens, at)
        if found is None:
            return None
        key, length = found
        if key in _ANYWHERE and not (key in ("rest", "as_is") and self.order.doing not in ("keep", "remove", "free")):
            return _Mark("markers", key), length
        if key in _AT_END and _ends(tokens, at + length):
            return _Mark("markers", key), length
        return None

    def _lengths(self, tokens: list[Token], at: int) -> tuple[_Mark, int] | None:
        """How far a thing is moved, or by how much the room changes; of other orders it is the size of a thing."""
        if self.order.doing not in ("move", "put", "make") or not _is_number(tokens[at]):
            return None
        size = read_size(self._lexicon, tokens, at)
        if size is None:
            return None
        lengths = tuple((part.metres, part.axis) for part in size[0].lengths)
        return _Mark("lengths", "", lengths=lengths), size[1] - at

    # --- reading

    def _mark(self, mark: _Mark) -> None:
        order = self.order
        match mark.sort:
            case "lengths":
                order.lengths += mark.lengths
            case "turn":
                order.turn = mark.value
            case "directions":
                order.direction = mark.key
            case "comparatives" | "absolutes":
                order.change = mark.key if mark.sort == "comparatives" else f"{mark.key}="
            case _:
                self._marker(mark.key)

    def _marker(self, key: str) -> None:
        order = self.order
        if key in ("nearer", "farther"):
            self._pending = key == "nearer"
        elif key in ("clockwise", "anticlockwise"):
            order.sense = -1 if key == "clockwise" else 1
        elif key == "round" and order.doing == "turn" and order.turn is None:
            order.turn = 180.0
        elif key == "elsewhere":
            order.doing = "resite"
        elif key == "away":
            order.away = True
        elif key == "rest":
            order.rest = True
        elif key == "so":
            self._mode, self._so = "so", []

    def _noun(self, noun: Noun) -> None:
        order = self.order
        if self._is_address(noun):
            return
        phrase = NounPhrase(noun, id=noun.id, rank=self._rank.get(id(noun), 0))
        if self._pending is not None:
            self._compared(phrase)
        elif self._excepted is not None:
            (order.things[-1].spared if order.things else order.spared).append(phrase)
            self._excepted = phrase
        elif self._mode == "so":
            self._so.append(phrase)
        elif self._mode == "instead" and noun.kind in ("thing", "number"):
            order.instead.append(phrase)
        elif (noun.kind == "room" or noun.word in ("furniture", "layout")) and order.doing in _OF_ROOM:
            order.room = True
        elif noun.kind in ("place", "part") and noun.value == "ceiling" and order.doing == "make":
            order.room = order.ceiling = True
        elif order.doing == "free" and noun.kind in ("place", "part"):
            order.free.append(noun)
        elif noun.kind in ("thing", "pronoun", "number", "place", "part"):
            order.things.append(phrase)
            self._anchors = []
        else:
            self._lose(noun)

    def _compared(self, phrase: NounPhrase) -> None:
        """Read what a thing comes nearer to; "opposite the piano and 2 m away from it" is how far it is to be."""
        order, again = self.order, bool(self._anchors) and _is_it(phrase.noun)
        if again:
            phrase = NounPhrase(self._anchors[-1])
        if again and not self._pending and order.lengths:
            order.apart.append((order.lengths.pop()[0], phrase))
        else:
            order.closer.append((bool(self._pending), phrase))
        self._pending = None

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
            case "negations":
                self._negated |= link.value == "not"
            case "verbs" if link.value == "face":
                self._face()
            case "verbs" if link.value in ("be", "stand", "hang", "put", "leave", "have"):
                if self._mode == "so" and self._is_free_next():
                    self.order.free += [phrase.noun for phrase in self._so]
            case "joins" | "mark" | "fillers" | "participles" | "mutual":
                pass
            case _:
                self._lose(link)

    def _is_free_next(self) -> bool:
        item = self._items[self._at] if self._at < len(self._items) else None
        free = isinstance(item, Connector | Noun) and item.text.lower() in _FREE
        self._at += free
        return free

    def _face(self) -> None:
        """Read "to face the room", "so that it faces the door"."""
        noun = self._next_noun()
        if noun is not None:
            self.order.facing.append(noun)

    def _next_noun(self) -> Noun | None:
        item = self._items[self._at] if self._at < len(self._items) else None
        if not isinstance(item, Noun):
            return None
        self._at += 1
        return item

    def _preposition(self, link: Connector) -> None:
        order, following = self.order, self._items[self._at] if self._at < len(self._items) else None
        if not isinstance(following, Noun):
            waits = isinstance(following, _Mark | Measured | Connector)
            if not waits and following is not None:
                self._lose(link)
            return
        if self._comes_instead(link, following):
            self._mode = "instead"
            return
        if order.doing == "swap" and link.value in ("with", "for", "and"):
            return
        if order.doing in ("rearrange", "make", "replace") and following.kind == "room" and link.value in ("in", "as"):
            order.into = following.value if order.doing != "make" else ""
            self._at += 1
            return
        if following.kind == "room" and link.value in ("in", "of", "from", "to", "around"):
            self._at += 1
            return
        towards = link.text.lower() in ("towards", "toward")
        if towards and order.doing in ("move", "put"):
            self._pending = True
            return
        if order.doing == "turn" and (towards or link.value in ("to", "facing", "at", "in_front_of")):
            self._face()
            return
        if following.kind in ("part", "place") and following.value == "ceiling" and order.doing == "make":
            return
        self._placed(self._where(link))

    def _placed(self, where: Where) -> None:
        order = self.order
        if where.word == "except" and where.noun is not None:
            self._excepted = NounPhrase(where.noun, id=where.noun.id)
            (order.things[-1].spared if order.things else order.spared).append(self._excepted)
            return
        self._refer(where)
        self._attach(where)

    def _refer(self, where: Where) -> None:
        """Let "it" mean what the same clause named before: an anchor of the thing, or another thing that is there."""
        noun, things = where.noun, self.order.things
        if noun is not None and _is_it(noun):
            if self._anchors:
                where.noun = self._anchors[-1]
            elif len(things) > 1 and self.order.doing in _ON_KNOWN and things[-2].noun.kind == "thing":
                where.noun = things[-2].noun
        self._anchors += [n for n in (where.noun, where.whole, where.second) if n and n.kind in ("thing", "place")]

    def _comes_instead(self, link: Connector, following: Noun) -> bool:
        """Whether what follows comes in place of the thing: "replace A with a B", "swap A for a B"."""
        order = self.order
        if following.kind not in ("thing", "number") or not order.things:
            return False
        new = following.det in ("a", "another", "") or following.kind == "number"
        if order.doing == "replace":
            return link.value in ("with", "by", "for") or (link.value in ("in", "to") and new)
        if order.doing == "swap" and (link.value == "for" or (link.value == "with" and new)) and new:
            order.doing = "replace"
            return True
        return False

    def _where(self, link: Connector) -> Where:
        where = Where(link.value, None, negated=self._negated, text=link.text)
        self._negated = False
        where.noun = self._next_noun()
        item = self._items[self._at] if self._at < len(self._items) else None
        if isinstance(item, Connector) and item.value == "of" and where.noun is not None:
            self._at += 1
            where.whole = self._next_noun()
        if link.value == "between" and self._is_and():
            self._at += 1
            where.second = self._next_noun()
        return where

    def _is_and(self) -> bool:
        item = self._items[self._at] if self._at < len(self._items) else None
        after = self._items[self._at + 1] if self._at + 1 < len(self._items) else None
        return isinstance(item, Connector) and item.sort == "joins" and isinstance(after, Noun)

    def _attach(self, where: Where) -> None:
        if self._mode == "so":
            self._of_result(where)
        elif self._excepted is not None:
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
        return alone and bool(things) and things[-1].noun.kind == "thing" and self.order.doing in _ON_KNOWN

    def _of_result(self, where: Where) -> None:
        """Read "so that it is next to the bed", "so that nothing stands in the centre", "so there is room in it"."""
        said = self._so[-1].noun if self._so else None
        kept_clear = said is None or said.kind in ("room", "abstract") or said.text.lower().startswith(("no", "more"))
        if kept_clear and where.noun is not None:
            self.order.free.append(where.noun)
        elif self.order.things:
            self.order.things[-1].places.append(where)


def _is_it(noun: Noun) -> bool:
    return noun.kind == "pronoun" and noun.value in ("it", "them")


def _is_number(token: Token) -> bool:
    return token.kind == "number" or grammar().at([token], 0, "count") is not None


def _ends(tokens: Sequence[Token], at: int) -> bool:
    """Whether an order ends at a token, or goes on with how far or why."""
    if at >= len(tokens):
        return True
    token = tokens[at]
    return token.kind in ("mark", "number") or token.text in ("by", "and", "so", "about", "a", "one", "half", "please")


def _angle(tokens: Sequence[Token], at: int) -> tuple[_Mark, int] | None:
    """The angle that begins at a token: "90 degrees", "a quarter turn"."""
    found = longest("turns", tokens, at)
    if found is not None:
        return _Mark("turn", "degrees", float(found[0])), found[1]
    if tokens[at].kind == "number":
        value, length = tokens[at].value, 1
    else:
        count = grammar().at(tokens, at, "count")
        if count is None:
            return None
        value, length = float(count.value), count.length
        tens = grammar().at(tokens, at + length, "count") if at + length < len(tokens) else None
        if tens is not None and value >= 20 and float(tens.value) < 10:
            value, length = value + float(tens.value), length + tens.length
    after = tokens[at + length].text if at + length < len(tokens) else ""
    return (_Mark("turn", "degrees", value), length + 1) if after in _DEGREES else None
