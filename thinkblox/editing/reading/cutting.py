"""The words of one clause cut to pieces: the reader's noun phrases and connectors, and phrases of instructions' own."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from msgspec import structs

from thinkblox.assets.plurals import singular
from thinkblox.editing.grammar import longest, means
from thinkblox.editing.lengths import angle_at, is_number, lengths_at
from thinkblox.errors import InputError
from thinkblox.reading.english.chunker import cut
from thinkblox.reading.english.chunks import Chunk, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token

_ANYWHERE = (
    "nearer", "farther", "clockwise", "anticlockwise", "elsewhere", "rest", "as_is", "so", "places", "present",
    "centred",
)  # fmt: skip
_AT_END = ("round", "away", "places_of_both", "together", "there")
_AFTER_TOGETHER = ("for", "against", "along", "at", "by", "under", "near")
_PUTTING = ("add", "put", "move", "ensure")
_TO_A_PLACE = ("put", "move", "turn", "add")
"""Orders in which "the nearest corner" is that which is nearest to what they are about."""
_RANKED = ("the", "my", "that", "two", "both")
_POINTING = ("the", "these", "those", "them", "my", "our")
_SPACED = ("move", "put", "make", "keep", "free", "gap", "turn")
"""Orders in which a length by itself is a distance, or how large something is to be."""
_MORE_BY = ("another", "further")
"""Before a length by which something goes on."""
_AFTER_ORDER = (
    "by", "and", "so", "about", "a", "one", "half", "please", "then", "too", "now", "two", "but", "without", "while",
    "plus", "also", "with",
)  # fmt: skip
_BRINGING = ("add", "ensure", "put")
"""Orders in which two lengths are the size of a new thing."""
_CLEARED = ("keep", "put", "ensure", "make", "free", "add")
"""Orders in which "free" at the end is how something is to be."""
_DISTANT = ("away", "off", "apart", "from", "to", "in", "closer", "nearer", "further", "farther")
_NEW = ("a", "an", "another", "some")
"""Words before a comparative that is of a new thing."""
_BEFORE_LENGTH = ("by", "to", "of")


@dataclass
class OrderMark:
    """A phrase of the instructions' own grammar: its section and key, and the angle or the lengths that it names."""

    sort: str
    key: str
    value: float = 0.0
    lengths: tuple[tuple[float, str], ...] = ()


Item = Chunk | OrderMark


class ClauseCutter:
    """Cuts one clause.

    Attributes:
        ranks: which of several a noun means by its size, "1 height", by the noun's identity.
        shares: which part of several, whichever of them, likewise; below 0 all but so many.
    """

    def __init__(self, lexicon: Lexicon, doing: str, verb: str, named: Mapping[int, str]) -> None:
        self.ranks: dict[int, str] = {}
        self.shares: dict[int, float] = {}
        self._lexicon, self._doing, self._verb, self._named = lexicon, doing, verb, named
        self._ranked: dict[int, str] = {}
        self._near: dict[int, str] = {}
        self._shared: dict[int, float] = {}

    def items(self, tokens: Sequence[Token]) -> list[Item]:
        """The pieces in their order."""
        return list(self._cut(tokens if self._doing in _SPACED else _excepting(tokens)))

    def _cut(self, tokens: Sequence[Token]) -> Iterator[Item]:
        run: list[Token] = []
        index = 0
        while index < len(tokens):
            if [token.text for token in tokens[index : index + 3]] == ["back", "to", "back"]:
                run += tokens[index : index + 3]
                index += 3
                continue
            found = self._marked(tokens, index)
            taken = 0 if found is not None else self._rank(tokens, index, run) or self._share(tokens, index)
            taken = taken or (0 if found is not None else self._nearest(tokens, index, run))
            if taken:
                index += taken
                continue
            if found is None:
                run.append(tokens[index])
                index += 1
                continue
            yield from self._chunks(run)
            run = []
            yield found[0]
            index += found[1]
        yield from self._chunks(run)

    def _rank(self, tokens: Sequence[Token], at: int, run: Sequence[Token]) -> int:
        """Read "larger" of "the larger table", "the larger of the two tables"; returns the tokens that it takes."""
        before = run[-1].text if run else ""
        counted = before == "two" and (len(run) < 2 or run[-2].text not in _RANKED)
        rank = means("sizes", tokens[at].text) if before in _RANKED and not counted else ""
        after = at + 1
        if not rank or self._doing == "add" or after >= len(tokens) or tokens[after].kind != "word":
            return 0
        if tokens[after].text in ("one", "ones"):
            return 0
        if tokens[after].text == "of":
            after += 1
            after += sum(t.text in ("the", "these", "those") for t in tokens[after : after + 1])
            after += sum(is_number(t) for t in tokens[after : after + 1])
        if after >= len(tokens) or tokens[after].kind != "word":
            return 0
        links = [token.text for token in tokens[after + 1 : after + 3]]
        if tokens[at + 1].text == "of" and "and" in links and singular(tokens[after].text) == tokens[after].text:
            raise InputError(
                f"'{tokens[at].shown} of' two things of different kinds is not told; name the one that is meant"
            )
        self._ranked[tokens[after].start] = rank
        return after - at

    def _nearest(self, tokens: Sequence[Token], at: int, run: Sequence[Token]) -> int:
        """Read "nearest" of "the nearest corner", which is the one that is so to what is moved."""
        key, pointed = means("nearest", tokens[at].text), bool(run) and run[-1].text in ("the", "its", "their")
        after = tokens[at + 1] if at + 1 < len(tokens) else None
        if not key or not pointed or after is None or after.kind != "word" or self._doing not in _TO_A_PLACE:
            return 0
        if grammar().at(tokens, at + 1, "prepositions") is not None or after.text == "one":
            return 0
        self._near[after.start] = key
        return 1

    def _share(self, tokens: Sequence[Token], at: int) -> int:
        """Read "all but two of", "most of" before a noun phrase; returns the tokens that it takes."""
        found = longest("shares", tokens, at)
        if found is None:
            return 0
        key, after = found[0], at + found[1]
        value = 0.0
        if key == "left":
            count = grammar().at(tokens, after, "count")
            number = tokens[after].value if after < len(tokens) and tokens[after].kind == "number" else 0.0
            value = -number if number else -float(count.value) if count is not None else 0.0
            after += 1 if number else count.length if count is not None else 0
            after += sum(t.text == "of" for t in tokens[after : after + 1])
        else:
            pointed = after < len(tokens) and tokens[after].text in _POINTING
            value = float(key) if pointed else 0.0
        if after >= len(tokens) or not value or tokens[after].kind != "word":
            return 0
        self._shared[tokens[after].start] = value
        return after - at

    def _chunks(self, run: list[Token]) -> Iterator[Chunk]:
        if not run:
            return
        chunks, _ = cut(self._lexicon, run)
        for chunk in chunks:
            if isinstance(chunk, Noun):
                starts = [token.start for token in run[chunk.start : chunk.end]]
                chunk.id = next((self._named[s] for s in starts if s in self._named), chunk.id)
                self.ranks[id(chunk)] = next((self._ranked[s] for s in starts if s in self._ranked), "")
                if chunk.kind == "number" and chunk.det in _RANKED and means("sizes", chunk.degree):
                    chunk.unshown = [word for word in chunk.unshown if word != chunk.degree]
                    self.ranks[id(chunk)] = chunk.degree = means("sizes", chunk.degree)
                chunk.degree = chunk.degree or self.ranks[id(chunk)]
                chunk.degree = next((self._near[s] for s in starts if s in self._near), chunk.degree)
                self.shares[id(chunk)] = next((self._shared[s] for s in starts if s in self._shared), 0.0)
            yield chunk

    def _marked(self, tokens: Sequence[Token], at: int) -> tuple[OrderMark, int] | None:
        """The phrase of the instructions' grammar that begins at a token, and its length."""
        lengths = self._lengths(tokens, at)
        if lengths is not None:
            return lengths
        angle = angle_at(tokens, at, words=self._doing == "turn")
        if angle is not None:
            return OrderMark("turn", "degrees", angle[0]), angle[1]
        of_length = lengths_at(self._lexicon, tokens, at + 1) is not None if at + 1 < len(tokens) else False
        part = longest("fractions", tokens, at) if self._doing == "make" and not of_length else None
        if part is not None:
            return OrderMark("fractions", part[0], float(part[0])), part[1]
        times = longest("multiples", tokens, at) if self._doing == "make" else None
        if times is not None:
            return OrderMark("multiples", times[0], float(times[0])), times[1]
        if self._doing in ("make", "put") and not (at and tokens[at - 1].text in (*_NEW, "the")):
            for sort in ("comparatives", "absolutes"):
                found = longest(sort, tokens, at)
                if found is not None and (self._doing == "make" or self._ends(tokens, at + found[1])):
                    return OrderMark(sort, found[0]), found[1]
        row = longest("rows", tokens, at)
        placed = any(grammar().at(tokens, n, "prepositions") is not None for n in range(at))
        if row is not None and (placed or self._doing not in ("add", "ensure")):
            return OrderMark("rows", row[0]), row[1]
        clear = longest("clear", tokens, at)
        if clear is not None and self._doing in _CLEARED and at and self._ends(tokens, at + clear[1]):
            return OrderMark("clear", "free"), clear[1]
        return self._moving(tokens, at) or self._marker(tokens, at)

    def _moving(self, tokens: Sequence[Token], at: int) -> tuple[OrderMark, int] | None:
        if self._doing not in ("move", "put", "turn", "make"):
            return None
        flank = longest("flanks", tokens, at)
        if flank is not None and at and self._ends(tokens, at + flank[1]):
            return OrderMark("flanks", flank[0]), flank[1]
        few = longest("few", tokens, at)
        if few is not None:
            return OrderMark("few", few[0]), few[1]
        seated = longest("seated", tokens, at)
        drawn = bool(means("drawing", self._verb))
        if seated is not None and drawn and self._ends(tokens, at + seated[1]):
            return OrderMark("seated", seated[0]), seated[1]
        found = longest("directions", tokens, at)
        pointed = at > 0 and tokens[at - 1].text == "the"
        if found is not None and self._doing != "make" and not pointed and self._ends(tokens, at + found[1]):
            return OrderMark("directions", found[0]), found[1]
        return None

    def _marker(self, tokens: Sequence[Token], at: int) -> tuple[OrderMark, int] | None:
        found = longest("markers", tokens, at)
        if found is None:
            return None
        key, length = found
        if key in _ANYWHERE and not (
            key in ("rest", "as_is") and self._doing not in ("keep", "remove", "free", "rearrange")
        ):
            return OrderMark("markers", key), length
        if key == "unblock" and self._doing in _PUTTING:
            return OrderMark("markers", key), length
        if key == "there" and self._doing not in _PUTTING:
            key = "as_is"
        followed = at + length < len(tokens) and key == "together" and tokens[at + length].text in _AFTER_TOGETHER
        if key in _AT_END and (followed or self._ends(tokens, at + length)):
            return OrderMark("markers", key), length
        return None

    def _lengths(self, tokens: Sequence[Token], at: int) -> tuple[OrderMark, int] | None:
        """How far a thing is moved or stands, or by how much something changes; elsewhere it is the size of a thing."""
        bound = longest("bounds", tokens, at)
        start = at + (bound[1] if bound is not None else int(tokens[at].text in _MORE_BY))
        if start >= len(tokens):
            return None
        said = lengths_at(self._lexicon, tokens, start)
        if said is None:
            return None
        if self._doing in _BRINGING and (len(said.lengths) > 1 or self._is_second(tokens, at)):
            return None
        end = start + said.tokens
        distance = self._is_distance(tokens, end)
        if not (self._doing in _SPACED and (distance or not self._is_of_noun(tokens, end))) and not (
            self._doing in ("add", "ensure") and distance and end < len(tokens)
        ):
            return None
        before = tokens[at - 1].text if at else ""
        key = (bound[0] if bound is not None else "") + (f" {before}" if before in ("by", "to") else "")
        while end < len(tokens) and tokens[end].text == "of":
            end += 1
        return OrderMark("lengths", key.strip(), lengths=said.lengths), end - at

    def _is_second(self, tokens: Sequence[Token], at: int) -> bool:
        """Whether a length is the second of a size: "1 m by 1.5 m"."""
        joined = at > 2 and tokens[at - 1].text in ("by", "x")
        return joined and any(
            (said := lengths_at(self._lexicon, tokens, begin)) is not None and begin + said.tokens > at
            for begin in range(max(0, at - 4), at - 1)
        )

    def _is_distance(self, tokens: Sequence[Token], at: int) -> bool:
        """Whether a length goes on as a distance: "1 m from", "1 m to the left of", or ends there."""
        if self._ends(tokens, at):
            return True
        after = tokens[at]
        preposition = grammar().at(tokens, at, "prepositions")
        return (
            after.text in _DISTANT
            or (preposition is not None and preposition.value not in ("of", "with", "as"))
            or longest("directions", tokens, at) is not None
            or longest("markers", tokens, at) is not None
        )

    def _is_of_noun(self, tokens: Sequence[Token], at: int) -> bool:
        """Whether a noun follows of which it is the size: "a 2 m wide sofa"."""
        if self._doing == "make":
            return False
        while at < len(tokens) and longest("absolutes", tokens, at) is not None:
            at += 1
        return at < len(tokens) and tokens[at].kind == "word" and tokens[at].text not in ("and", "of")

    @staticmethod
    def _ends(tokens: Sequence[Token], at: int) -> bool:
        """Whether an order ends at a token, or goes on with how far or why."""
        if at >= len(tokens):
            return True
        token = tokens[at]
        if token.kind in ("mark", "number") or longest("few", tokens, at) is not None:
            return True
        return token.text in _AFTER_ORDER


def _excepting(tokens: Sequence[Token]) -> list[Token]:
    """The tokens with "apart from" as "except", of what is not moved."""
    left: list[Token] = []
    for token in tokens:
        if token.text == "from" and left and left[-1].text == "apart":
            left[-1] = structs.replace(left[-1], text="except", shown=f"{left[-1].shown} {token.shown}")
        else:
            left.append(token)
    return left
