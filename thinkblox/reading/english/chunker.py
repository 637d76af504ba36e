"""Tokens of an English text to chunks, from left to right."""

from collections.abc import Sequence
from functools import cached_property, lru_cache

from thinkblox.assets.names import begins_name
from thinkblox.assets.palette import COLOURS
from thinkblox.brief import SurfaceRequest
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Measured, Noun, SaidSurface, Stray
from thinkblox.reading.english.dimensions import led_size
from thinkblox.reading.english.grammar import Function, grammar, is_count
from thinkblox.reading.english.phrase import PhraseReader
from thinkblox.reading.english.places import begins_two_walls, two_walls_at
from thinkblox.reading.english.surfaces import surface_at
from thinkblox.reading.english.turns import TAKEN_BACK, correction_at, moved_at
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.tokens import Token

_MARKS = {
    ".": "stop",
    "!": "stop",
    "?": "stop",
    "\n": "stop",
    ";": "semicolon",
    ":": "colon",
    ",": "comma",
    "(": "open",
    ")": "close",
    "[": "open",
    "]": "close",
    "–": "dash",
    "—": "dash",
    "/": "comma",
    "&": "and",
    "+": "and",
}
_ITEM_ENDS = ("stop", "semicolon", "colon", "comma", "and")
"""After what a numbered item can begin."""
_QUOTES = ('"', "“", "”", "„", "«", "»")
_BEFORE_NOUNS = ("on", "on_top", "at", "with", "of", "from", "to", "by", "against", "along", "for")
"""Prepositions that a noun has to follow."""
_LINKS = (
    "sequences",
    "mutual",
    "negations",
    "inverses",
    "prepositions",
    "participles",
    "verbs",
    "joins",
    "fillers",
)


_PAIR = 2
_LONGEST_ORDER = 4
"""Most words of an order to take something away."""


class Cutter:
    """Cuts the tokens of one text into chunks."""

    def __init__(self, lexicon: Lexicon, tokens: Sequence[Token]) -> None:
        self.lexicon = lexicon
        self.tokens = list(tokens)
        self.at = 0
        self.made: list[Chunk] = []
        self.noted: list[SurfaceRequest] = []

    @cached_property
    def _phrases(self) -> PhraseReader:
        return PhraseReader(self.lexicon, self.tokens)

    def chunks(self) -> list[Chunk]:
        """All chunks of the text."""
        while self.at < len(self.tokens):
            chunk = self._told_side() or self._next()
            if isinstance(chunk, Noun) and self._is_bare_side(chunk):
                word = "in" if chunk.kind == "place" else "on"
                self.made.append(Connector("prepositions", word, chunk.start, chunk.start))
            if chunk is not None:
                self.at = chunk.end
                self.made.append(self._look_of_rest(chunk) or chunk)
            else:
                self.at += 1
        return self.made

    def _look_of_rest(self, chunk: Chunk) -> Adjective | None:
        """Read "the rest orange" as a colour, where a fruit has the same name."""
        rest = self.made[-1] if self.made else None
        if not isinstance(rest, Noun) or rest.kind != "pronoun" or rest.value != "other":
            return None
        bare = isinstance(chunk, Noun) and not (chunk.det or chunk.count is not None or chunk.plural)
        if not isinstance(chunk, Noun) or not bare or not chunk.material or chunk.called != chunk.material:
            return None
        return Adjective(chunk.start, chunk.end, chunk.text, [chunk.material])

    def _told_side(self) -> Noun | None:
        """Read "one nightstand, right side": between marks, a side and nothing else."""
        if (label := self._label()) is not None:
            return label
        last, before = self.made[-1:], self.made[-2:-1]
        after_mark = bool(last) and isinstance(last[0], Connector) and last[0].value in ("comma", "dash", "open")
        if not after_mark or not before or not isinstance(before[0], Noun) or before[0].kind != "thing":
            return None
        noun = self._phrases.read(self.at, after_preposition=True)
        ends = noun is not None and (noun.end >= len(self.tokens) or self.tokens[noun.end].kind == "mark")
        if noun is None or noun.kind != "part" or not ends:
            return None
        self.made[-1] = Connector("fillers", "words", last[0].start, last[0].end, "")
        self.made.append(Connector("prepositions", "on", noun.start, noun.start))
        return noun

    def _label(self) -> Noun | None:
        """Read the "Front" of "Front: a whiteboard."."""
        last = self.made[-1] if self.made else None
        begins = last is None or (isinstance(last, Connector) and last.value in ("stop", "semicolon"))
        if not begins or self._text_at(self.at + 1) != ":":
            return None
        noun = self._phrases.read(self.at, after_preposition=True)
        side = noun is not None and noun.kind == "part" and noun.value in ("left", "right", "front", "back")
        return noun if side and noun is not None and noun.end == self.at + 1 else None

    def _is_bare_side(self, noun: Noun) -> bool:
        """Whether a noun says where something is without a preposition: "nightstands each side of the bed"."""
        ends = noun.end >= len(self.tokens) or self.tokens[noun.end].kind == "mark"
        goes_on = noun.text.lower().startswith("dead ") or self._text_at(noun.end) == "with"
        if noun.kind == "place" and noun.value == "centre" and (ends or goes_on):
            told = self._after_noun() or (goes_on and self._text_at(self.at - 1) == "," and len(self.made) > 1)
            return told and not noun.det and self._text_at(noun.end) != ":"
        if noun.kind != "part" or noun.det not in ("each", "either", "both") or not self.made:
            return False
        return isinstance(self.made[-1], Noun) and self.made[-1].kind in ("thing", "number", "pronoun")

    def _next(self) -> Chunk | None:
        token = self.tokens[self.at]
        if token.kind == "mark" and token.text in _QUOTES and (quoted := self._quoted()) is not None:
            return quoted
        if (whole := self._surface() or self._correction() or self._removal() or self._unread()) is not None:
            return whole
        if length := self._numbering():
            return Connector("fillers", "words", self.at, self.at + length, token.shown)
        if token.kind == "mark":
            value = _MARKS.get(token.text) if not self._is_asked_where() else ""
            return Connector("mark", value, self.at, self.at + 1, token.shown) if value else None
        if token.shown == "w" and self.at + 1 < len(self.tokens) and self.tokens[self.at + 1].text == "/":
            return Connector("prepositions", "with", self.at, self.at + 2, "w/")
        return self._size() or self._words()

    def _size(self) -> Measured | None:
        """Read a size, with the side that is named before it, or "about"."""
        if (led := led_size(self.lexicon, self.tokens, self.at)) is not None:
            return Measured(led[0], self.at, led[1])
        token, about = self.tokens[self.at], grammar().at(self.tokens, self.at, "quantifiers")
        counted = token.kind == "number" or token.text in ("nan", "inf", "infinity")
        found = self._phrases.size_at(self.at + about.length) if about is not None else None
        if found is None and (counted or grammar().at(self.tokens, self.at, "count")):
            found = self._phrases.size_at(self.at)
        return Measured(found[0], self.at, found[1]) if found is not None else None

    def _is_asked_where(self) -> bool:
        """Whether "On the bench?" is asked, which only says where what follows is."""
        asked = [*self.made[-3:]]
        begins = len(asked) < len(("?", "on", "bench")) or (
            isinstance(asked[0], Connector) and asked[0].value == "stop"
        )
        link, noun = (*asked[-2:], None, None)[:2]
        placing = isinstance(link, Connector) and link.sort == "prepositions"
        more = self.at + 1 < len(self.tokens) and self.tokens[self.at].text == "?"
        return begins and placing and isinstance(noun, Noun) and noun.definite and more

    def _is_said_of_it(self) -> bool:
        """Whether what comes is to be left as it is: "leave the door open"."""
        last = self.made[-1] if self.made else None
        return isinstance(last, Connector) and last.value == "leave"

    def _removal(self) -> Connector | None:
        """Read "take it out", where the sentence named what is to go."""
        for length in range(_LONGEST_ORDER, 1, -1) if self.tokens[self.at].text in _removing() else ():
            words = [token.text for token in self.tokens[self.at : self.at + length]]
            if " ".join(words) in grammar().lists["removals"] and len(words) == length:
                ends = self.at + length >= len(self.tokens) or self.tokens[self.at + length].kind == "mark"
                text = " ".join(token.shown for token in self.tokens[self.at : self.at + length])
                return Connector("negations", "remove", self.at, self.at + length, text) if ends else None
        return None

    def _unread(self) -> Stray | None:
        unread = self._phrases.unread_at(self.at)
        if not unread or self._is_said_of_it() or self._is_exception():
            return None
        text = " ".join(part.shown for part in self.tokens[self.at : self.at + unread])
        return Stray(self.at, self.at + unread, text)

    def _is_exception(self) -> bool:
        """Whether "apart from the table" comes after "nothing": it is what is there all the same."""
        link = grammar().at(self.tokens, self.at, "prepositions")
        said = [chunk for chunk in self.made if isinstance(chunk, Connector) and chunk.sort in ("mark", "negations")]
        return link is not None and link.value == "except" and bool(said) and said[-1].value == "nothing"

    def _correction(self) -> Connector | None:
        """Read "no, make that" where one noun phrase ends the clause: what it corrects may be found."""
        length = correction_at(self.tokens, self.at)
        if not length or not self.made or self.at + length >= len(self.tokens):
            return None
        text = " ".join(token.shown for token in self.tokens[self.at : self.at + length])
        if (moved := moved_at(self.tokens, self.at + length)) > 0:
            text = " ".join(token.shown for token in self.tokens[self.at : self.at + length + moved])
            return Connector("corrections", "move", self.at, self.at + length + moved, text)
        skips = grammar().at(self.tokens, self.at + length, "negations")
        if skips is not None and skips.value == "exclude":
            return Connector("fillers", "words", self.at, self.at + length, text)
        if self._is_taken_back(self.at + length):
            return Connector("fillers", TAKEN_BACK, self.at, self.at + length, text)
        noun = self._phrases.read(self.at + length)
        if noun is None or noun.kind not in ("thing", "number") or noun.definite or not (noun.det or noun.count):
            return None
        ends = noun.end >= len(self.tokens) or self.tokens[noun.end].kind == "mark"
        if not ends and not self._is_named_last(noun):
            return None
        return Connector("corrections", "replace", self.at, self.at + length, text)

    def _is_taken_back(self, at: int) -> bool:
        """Whether it is told anew that something is not there: "actually, no rug", "wait, without the rug"."""
        link = grammar().at(self.tokens, at, "prepositions")
        without = link is not None and link.value == "without"
        noun = self._phrases.read(at + (link.length if link is not None and without else 0))
        return noun is not None and noun.kind == "thing" and (without or noun.det == "no")

    def _is_named_last(self, noun: Noun) -> bool:
        """Whether the same was named last: "two washers, sorry, one washer and a dryer"."""
        named = (chunk for chunk in reversed(self.made) if isinstance(chunk, Noun))
        last = next(named, None)
        return last is not None and noun.kind == "thing" and (last.kind, last.value) == (noun.kind, noun.value)

    def _surface(self) -> SaidSurface | None:
        """Read what floor or walls are like; where they are a place for something, that is noted and they stay one."""
        found = surface_at(self.tokens, self.at, self._is_room_at)
        if found is None:
            return None
        if not self._is_of_place():
            return SaidSurface(self.at, found.end, found.request)
        self.noted.append(found.request)
        return None

    def _is_room_at(self, at: int) -> bool:
        noun = self._phrases.read(at) if at < len(self.tokens) else None
        return noun is not None and (noun.kind == "room" or noun.room != "")

    def _is_of_place(self) -> bool:
        """Whether a floor or wall that comes next is where something is: "on the white wall"."""
        last = self.made[-1] if self.made else None
        if not isinstance(last, Connector):
            return False
        return last.sort in ("prepositions", "inverses", "participles") and last.value not in ("with", "of", "as")

    def _numbering(self) -> int:
        """How many tokens a number has that counts nothing: "(a)", "2.", "the 1950s"."""
        return 3 if self._is_item() else 2 if self._is_decade() or self._is_numbered() else 0

    def _is_numbered(self) -> bool:
        """Whether "2." or "b)" numbers what is listed."""
        token, mark = self.tokens[self.at], self._text_at(self.at + 1)
        last = self.made[-1] if self.made else None
        begins = last is None or (isinstance(last, Connector) and last.value in _ITEM_ENDS)
        if not begins or self.at + 2 >= len(self.tokens) or (mark != ")" and (mark != "." or token.kind != "number")):
            return False
        return not self._counts_what_is_told() and (
            token.kind == "number" or (len(token.text) == 1 and token.text.isalpha())
        )

    def _counts_what_is_told(self) -> bool:
        """Whether "2." ends the entry of a thing, after which another one or nothing comes: "Desk: 1. Chairs: 2."."""
        entry = [*self.made[-2:]]
        if [getattr(chunk, "kind", getattr(chunk, "value", "")) for chunk in entry] != ["thing", "colon"]:
            return False
        rest = [token.text for token in self.tokens[self.at + 2 :]]
        ends = next((at for at, text in enumerate(rest) if text in (".", "\n")), len(rest))
        return not rest or ":" in rest[:ends]

    def _is_item(self) -> bool:
        """Whether "(a)", "(2)" numbers what is listed."""
        inner = self._text_at(self.at + 1)
        brackets = (self.tokens[self.at].text, self._text_at(self.at + 2)) == ("(", ")")
        counts = inner.isdigit() and self._after_noun()
        return brackets and len(inner) == 1 and inner.isalnum() and not counts

    def _is_decade(self) -> bool:
        """Whether a number says when: "the 1950s"."""
        token, after = self.tokens[self.at], self._text_at(self.at + 1)
        short = token.kind == "number" and self._text_at(self.at - 1) == "the" and token.value in range(10, 100, 10)
        return after == "s" and (short or (token.kind == "number" and token.value > 1000))

    def _quoted(self) -> Connector | None:
        """Go past words in quotation marks, unless they name what comes right after."""
        for end in range(self.at + 1, min(self.at + 12, len(self.tokens))):
            if self.tokens[end].text in _QUOTES:
                after = self._phrases.read(end + 1) if end + 1 < len(self.tokens) else None
                if end - self.at < 2 or (after is not None and after.start == end + 1 and not after.det):
                    return None
                return Connector("fillers", "words", self.at, end + 1, "")
        return None

    def _words(self) -> Chunk:
        if (said := self._set_phrase()) is not None:
            return said
        noun = (
            None if self._begins_no_noun() else self._phrases.read(self.at, after_preposition=self._after_preposition())
        )
        noun = None if noun is not None and self._begins_link(noun) else self._other_one(noun)
        of_room = noun is not None and self._names_room()
        link = None if of_room else self._link()
        if self.tokens[self.at].text == "in" and self._after_noun() and self._text_at(self.at + 1) == "which":
            named = self.made[-1]
            if isinstance(named, Noun) and named.kind == "thing":
                return Connector("prepositions", "in", self.at, self.at + 1, "in")
        if (doing := None if of_room else self._participle()) is not None:
            return doing
        if noun is not None and (link is None or (not self._is_placing(link) and self._is_noun(noun, link))):
            return noun
        if link is not None and link.sort == "verbs" and link.value == "other" and self._after_preposition():
            return Stray(self.at, self.at + 1, self.tokens[self.at].shown)
        state = grammar().at(self.tokens, self.at, "states")
        said = next((c for c in reversed(self.made) if not (isinstance(c, Connector) and c.sort == "fillers")), None)
        found = isinstance(said, Connector) and said.value in ("be", "leave") and state is not None
        found |= link is not None and link.value == "face"  # "face down" is how a thing lies.
        if found and state is not None and (link is None or state.length >= link.length):
            link = None
        if link is not None:
            text = " ".join(token.shown for token in self.tokens[self.at : self.at + link.length])
            return Connector(link.sort, link.value, self.at, self.at + link.length, text)
        adjective = self._phrases.adjective(self.at)
        if adjective is not None:
            return adjective
        return Stray(self.at, self.at + 1, self.tokens[self.at].shown)

    def _begins_no_noun(self) -> bool:
        """Whether a word comes that only links others, as two in five do."""
        word = self.tokens[self.at].text
        return word in grammar().lists["linking"] and not begins_name(word)

    def _lack(self) -> Adjective | None:
        """Read a word between marks for what the thing before them lacks: "a dress form - headless - stands"."""
        token = self.tokens[self.at]
        if not token.text.endswith("less") or self._phrases.thing_at(self.at) is not None:
            return None
        around = [self.tokens[n] for n in (self.at - 1, self.at + 1) if n < len(self.tokens)]
        if not self.at or any(t.kind != "mark" for t in around):
            return None
        return Adjective(self.at, self.at + 1, token.shown, unshown=[token.text])

    def _begins_link(self, noun: Noun) -> bool:
        """Whether more words than the noun phrase say no or where: "no room for", "none needed", "a long way from"."""
        found = grammar().all_at(self.tokens, self.at, "negations", "prepositions")
        return bool(found) and found[0].value in ("exclude", "gone", "far") and found[0].length > noun.end - noun.start

    def _other_one(self, noun: Noun | None) -> Noun | None:
        """The pronoun of "one holds three mugs, the other five plates", where a verb is left out."""
        words = [self._text_at(self.at), self._text_at(self.at + 1)]
        if noun is None or noun.kind != "thing" or (words != ["the", "other"] and words[0] != "another"):
            return noun
        said = {chunk.value for chunk in self.made if isinstance(chunk, Noun)}
        if "one" not in said or noun.value in said:
            return noun
        after = self.at + (1 if words[0] == "another" else 2)
        after += self._text_at(after) == "one"
        if after >= noun.end or not (noun.plural or is_count(self.tokens, after)):
            return noun
        return Noun("pronoun", "other", self.at, after, "another" if words[0] == "another" else "the other")

    def _names_room(self) -> bool:
        """Whether words that begin with what is done somewhere are the name of a room: "waiting room"."""
        if self.tokens[self.at].text not in self.lexicon.begun("room"):
            return False
        named = self.lexicon.longest(self.tokens, self.at)
        return named.length > 1 and named.entry("room") is not None

    def _described(self) -> Adjective | None:
        """Read what hyphens join after the noun that it describes: "a TV wall-mounted opposite the sofa"."""
        if not self.tokens[self.at].glued or not self._after_noun() or not self._phrases.is_after_noun(self.at):
            return None
        return self._phrases.adjective(self.at)

    def _set_phrase(self) -> Chunk | None:
        """Read what is told by its first words alone."""
        if self.tokens[self.at].text in grammar().lists["befell"] and self._after_noun():
            return Stray(self.at, self.at + 1, self.tokens[self.at].shown)
        if (said := self._restated()) is not None:
            return said
        place = self._two_walls() or self._two_sides() or self._finish() or self._infinitive() or self._ability()
        look = place or self._lack() or self._after_modal() or self._described()
        return look or self._said_round() or self._shade_of_rest()

    def _restated(self) -> Stray | Connector | None:
        """Read "nine pairs of shoes, that is eighteen": a number once more, or one that nobody can tell of what."""
        if self._text_at(self.at) != "that" or self._text_at(self.at + 1) != "is":
            return None
        last, told = self.made[-1:], self.made[-2:-1]
        noun = self._phrases.read(self.at + 2) if self.at + 2 < len(self.tokens) else None
        bare = noun is not None and noun.kind == "number" and bool(noun.count) and not noun.of_known
        if not bare or noun is None or not last or not isinstance(last[0], Connector) or last[0].value != "comma":
            return None
        if noun.end < len(self.tokens) and self.tokens[noun.end].kind != "mark":
            return None
        said = told[0] if told and isinstance(told[0], Noun) else None
        pairs = said is not None and "pairs" in said.text.lower().split()
        if said is not None and noun.count in (said.count, (said.count or 0) * 2 if pairs else said.count):
            return Connector("fillers", "words", self.at, noun.end, "")
        return Stray(self.at, noun.end, " ".join(token.shown for token in self.tokens[self.at : noun.end]))

    def _two_walls(self) -> Noun | None:
        """Read "the left and right walls"."""
        if not begins_two_walls(self.tokens[self.at].text):
            return None
        value, length = two_walls_at([token.text for token in self.tokens[self.at : self.at + 8]])
        if not length:
            return None
        text = " ".join(token.shown for token in self.tokens[self.at : self.at + length])
        return Noun("place", value, self.at, self.at + length, text, det="the", plural=True)

    def _two_sides(self) -> Noun | None:
        """Read "bedside tables left and right"."""
        if self._text_at(self.at) not in ("left", "right"):
            return None
        words = [self._text_at(self.at + n) for n in range(3)]
        ends = self.at + 3 >= len(self.tokens) or self.tokens[self.at + 3].kind == "mark"
        if words not in (["left", "and", "right"], ["right", "and", "left"]) or not (ends and self._after_noun()):
            return None
        return Noun("part", "side", self.at, self.at + 3, " ".join(words), det="both", plural=True)

    def _finish(self) -> Connector | None:
        """Go past the "painted" of "a dresser painted yellow"."""
        token = self.tokens[self.at]
        if token.text not in grammar().lists["finished"] or not self._after_noun():
            return None
        if self._phrases.adjective(self.at + 1) is None:
            return None
        return Connector("fillers", "words", self.at, self.at + 1, token.shown)

    def _said_round(self) -> Adjective | None:
        """Read "the table is round", where nothing comes that it could be around."""
        if self._text_at(self.at) != "round":
            return None
        ends = self.at + 1 >= len(self.tokens) or self.tokens[self.at + 1].kind == "mark"
        joined = grammar().at(self.tokens, self.at + 1, "joins") is not None
        last = self.made[-1] if self.made else None
        said = isinstance(last, Connector) and (last.sort, last.value) in (("verbs", "be"), ("negations", "not"))
        joined |= said and grammar().at(self.tokens, self.at + 1, "prepositions", "inverses") is not None
        return self._phrases.adjective(self.at) if ends or joined else None

    def _shade_of_rest(self) -> Adjective | None:
        """Read "the remaining ones orange" as their colour, which is a fruit too."""
        last = self.made[-1] if self.made else None
        if not isinstance(last, Noun) or last.kind not in ("number", "pronoun") or last.det != "other":
            return None
        word = self.tokens[self.at]
        noun = self._phrases.read(self.at) if word.text in self.lexicon.begun("attribute") else None
        if noun is None or not noun.material or noun.det or noun.end != self.at + 1:
            return None
        return Adjective(self.at, noun.end, word.shown, attributes=[noun.material])

    def _after_modal(self) -> Connector | None:
        """Read a verb that no list has after "can", "should", "want to": it names nothing."""
        before, token = self._text_at(self.at - 1) if self.at else "", self.tokens[self.at]
        modal = grammar().lists["modals"]
        if token.text in modal and self._asks():
            return Connector("fillers", "words", self.at, self.at + 1, token.shown)
        if token.text in modal and (before in grammar().lists["speakers"] or self._after_people() or self._after_it()):
            return Connector("fillers", "words", self.at, self.at + 1, token.shown)
        if self._is_told_able(modal):
            return Connector("fillers", "words", self.at, self.at + 2, f"{token.shown} {self._text_at(self.at + 1)}")
        if before == "and" and self._goes_on_doing(modal):
            return Connector("fillers", "words", self.at, self.at + 1, token.shown)
        infinitive = before == "to" and self.at > 1 and self._text_at(self.at - 2) in grammar().lists["wishes"]
        if token.kind != "word" or not (before in modal or infinitive):
            return None
        known = self._phrases.thing_at(self.at) is not None and not infinitive
        if known or grammar().at(self.tokens, self.at, *_LINKS, "determiners", "pronouns", "states"):
            return None
        people = isinstance(subject := self.made[-2] if len(self.made) > 1 else None, Noun) and subject.kind == "people"
        return Connector("fillers", "doing" if people else "words", self.at, self.at + 1, token.shown)

    def _asks(self) -> bool:
        """Whether a question begins: "Can the bench be far from the door?"."""
        last = self.made[-1] if self.made else None
        begins = last is None or (isinstance(last, Connector) and last.sort in ("mark", "joins", "fillers"))
        return begins and grammar().at(self.tokens, self.at + 1, "determiners", "pronouns", "fillers") is not None

    def _infinitive(self) -> Connector | None:
        """Read the "to" of "a place to eat", "waiting to be cleared", which is beside nothing."""
        if self._text_at(self.at) == "to" and self._text_at(self.at + 1) == "be":
            done = self._text_at(self.at + 2).endswith("ed") and grammar().at(self.tokens, self.at + 2, *_LINKS) is None
            return Connector("fillers", "words", self.at, self.at + 2 + done, "to be")
        if self._text_at(self.at) == "to" and (length := self._purpose()):
            return Connector("fillers", "words", self.at, self.at + length, "to")
        wished = self.at > 0 and self._text_at(self.at - 1) in grammar().lists["wishes"]
        if not wished or self._text_at(self.at) != "to" or self.at + 1 >= len(self.tokens):
            return None
        after, token = self.at + 1, self.tokens[self.at]
        named = grammar().at(self.tokens, after, "determiners", "pronouns", "count") or self._phrases.read(after)
        if named or self.tokens[after].kind != "word":
            return None
        return Connector("fillers", "words", self.at, after, token.shown)

    def _purpose(self) -> int:
        """How many tokens "to check posture" has, which says what something is for; 0 where it is no such thing."""
        noun = self._phrases.read(self.at + 1) if self.at + 1 < len(self.tokens) and self._after_noun() else None
        if noun is None or noun.kind != "thing" or noun.named or noun.det or noun.count is not None:
            return 0
        return noun.end - self.at if noun.end > self.at + 2 and not (noun.unshown or noun.attributes) else 0

    def _after_people(self) -> bool:
        last = self.made[-1] if self.made else None
        return isinstance(last, Noun) and last.kind == "people"

    def _after_it(self) -> bool:
        """Whether a pronoun comes before, of which "can drive" is said."""
        last = self.made[-1] if self.made else None
        return isinstance(last, Noun) and last.kind == "pronoun" and last.end == self.at

    def _is_told_able(self, modal: frozenset[str]) -> bool:
        """Whether "a lamp that can rotate" goes on, and no verb that has "can" in it."""
        told = self._text_at(self.at) in ("that", "which") and self._text_at(self.at + 1) in modal
        if not told or not self._after_noun():
            return False
        known = (link for at in (self.at, self.at + 1) for link in grammar().all_at(self.tokens, at, *_LINKS))
        return all(link.length < _PAIR for link in known)

    def _ability(self) -> Stray | None:
        """Read what no room shows of a thing: "that can rotate"."""
        if not self._is_told_able(grammar().lists["modals"]) or self.at + _PAIR >= len(self.tokens):
            return None
        doing = self.at + _PAIR
        if self.tokens[doing].kind != "word" or grammar().at(self.tokens, doing, *_LINKS, "determiners", "states"):
            return None
        return Stray(self.at, doing + 1, " ".join(token.shown for token in self.tokens[self.at : doing + 1]))

    def _goes_on_doing(self, modal: frozenset[str]) -> bool:
        """Whether a second verb follows "can work at a desk and": "relax on the sofa"."""
        placed = grammar().at(self.tokens, self.at + 1, "prepositions") is not None
        named = self._phrases.thing_at(self.at) is not None or self.tokens[self.at].text.endswith("s")
        if not placed or named or self.tokens[self.at].kind != "word":
            return False
        start = self.at
        while start and self.tokens[start - 1].text not in ".;:!?":
            start -= 1
        return any(t.text in modal for t in self.tokens[start : self.at])

    def _after_preposition(self) -> bool:
        last = self.made[-1] if self.made else None
        return isinstance(last, Connector) and last.sort in ("prepositions", "inverses")

    def _link(self) -> Function | None:
        found = grammar().all_at(self.tokens, self.at, *_LINKS)
        if not found:
            return None
        found = [function for function in found if not self.tokens[self.at + function.length - 1].glued]
        if not found:
            return None
        found = [function for function in found if not self._takes_bound(function)] or found
        found = [function for function in found if not self._takes_all(function)] or found
        if found[0].value == "surround" and not self._after_noun() and self._is_placed_at(self.at + found[0].length):
            return None  # "ring in the middle"
        longest = [function for function in found if function.length == found[0].length]
        return min(longest, key=lambda function: _LINKS.index(function.sort))

    def _is_placed_at(self, at: int) -> bool:
        """Whether a preposition comes that says where something is."""
        return at < len(self.tokens) and grammar().at(self.tokens, at, "prepositions") is not None

    def _takes_bound(self, function: Function) -> bool:
        """Whether "with no" is cut from "with no more than one lamp", which excludes nothing."""
        end = self.at + function.length
        bound = self._text_at(end) in ("more", "fewer", "less") and self._text_at(end + 1) == "than"
        return bound and function.length > 1 and self._text_at(end - 1) in ("no", "not")

    def _takes_all(self, function: Function) -> bool:
        """Whether "in all" is cut from "in all four corners"."""
        end = self.at + function.length
        cut = function.sort == "fillers" and function.length > 1 and self._text_at(end - 1) == "all"
        return cut and end < len(self.tokens) and self.tokens[end].kind != "mark"

    def _is_placing(self, link: Function) -> bool:
        """Whether "around six" after a noun is around them: "chairs around six tables", "a desk under two lamps"."""
        return link.sort == "prepositions" and link.value in ("around", "under", "above") and self._after_noun()

    def _is_noun(self, noun: Noun, link: Function) -> bool:
        """Whether words that could also link others are a noun phrase: "the stand", "no lamp", "display fridge"."""
        if noun.kind == "pronoun":
            return self._is_pronoun(noun, link)
        if self._is_name_of_verb(noun, link) or noun.share or (link.value == "seat" and not self._number_follows(link)):
            return True
        if link.length > 1 and link.sort in ("verbs", "participles") and self.tokens[self.at].text in ("that", "which"):
            return False
        if noun.det or noun.count is not None:
            return noun.kind != "number" or noun.end - noun.start >= link.length
        first = self._phrases.thing_at(self.at)
        last = self.made[-1] if self.made else None
        if link.sort == "verbs" and isinstance(last, Connector) and last.sort == "prepositions" and first is not None:
            return first.length >= link.length and first.entry.plural and last.value in _BEFORE_NOUNS
        if first is not None and first.length > link.length:
            return True
        if noun.kind == "place" and noun.end - noun.start > link.length and link.value == "opposite":
            return True
        if link.sort == "prepositions" and link.value in ("around",):
            return noun.kind == "thing" and noun.end - noun.start > 1 and not self._after_noun()
        if link.sort in ("fillers", "joins"):
            told = isinstance(last, Connector) and last.sort == "verbs" and last.value == "be"
            return noun.kind in ("thing", "place", "room") and first is not None and not told
        return False

    def _is_name_of_verb(self, noun: Noun, link: Function) -> bool:
        """Whether a verb begins the name of a listed thing: ", and display racks along the wall"."""
        last = self.made[-1] if self.made else None
        if self._is_plural_name(noun, link):
            return True
        listed = isinstance(last, Connector) and (last.sort == "joins" or last.value in ("comma", "with"))
        shown = link.sort == "verbs" and self.tokens[self.at].text in grammar().lists["naming_verbs"]
        first = self._phrases.thing_at(self.at + 1) if self.at + 1 < len(self.tokens) else None
        return listed and shown and first is not None and noun.kind == "thing" and noun.end - noun.start > 1

    def _is_plural_name(self, noun: Noun, link: Function) -> bool:
        """Whether a verb on -s is the plural of a thing: "watches and rings inside"."""
        joint, before = self.made[-1:], self.made[-2:-1]
        joined = bool(joint) and isinstance(joint[0], Connector) and joint[0].sort == "joins"
        bare = bool(before) and isinstance(before[0], Noun) and before[0].kind == "thing" and before[0].plural
        verb = link.sort == "verbs" and self.tokens[self.at].text.endswith("s")
        if not (joined and bare and verb) or grammar().at(self.tokens, self.at + 1, "determiners", "count") is not None:
            return False
        return noun.kind == "thing" and self._phrases.thing_at(self.at) is not None

    def _participle(self) -> Connector | None:
        """Read a verb that no list has: "are chilling in the fridge", "a kiln humming in the corner"."""
        last = self.made[-1] if self.made else None
        token = self.tokens[self.at]
        doing = isinstance(last, Noun) and last.kind == "thing" and self._may_be_verb(last, token.text)
        if doing and self._phrases.thing_at(self.at) is not None:
            return None
        if not doing and not (isinstance(last, Connector) and last.sort == "verbs" and last.value == "be"):
            return None
        if not (doing or token.text.endswith(("ing", "ed"))) or grammar().at(self.tokens, self.at, *_LINKS, "states"):
            return None
        if token.text in COLOURS or grammar().at(self.tokens, self.at + 1, "prepositions") is None:
            return None
        return Connector("participles", "stand", self.at, self.at + 1, token.shown)

    def _may_be_verb(self, subject: Noun, word: str) -> bool:
        """Whether a word that is no noun may say what a thing does: "humming", "a clock ticks"."""
        return word.endswith("ing") or (word.endswith("s") and not word.endswith("ss") and not subject.many)

    def _number_follows(self, link: Function) -> bool:
        return grammar().at(self.tokens, self.at + link.length, "count") is not None or (
            self.at + link.length < len(self.tokens) and self.tokens[self.at + link.length].kind == "number"
        )

    def _is_pronoun(self, noun: Noun, link: Function) -> bool:
        if link.sort == "joins":
            after = grammar().at(self.tokens, noun.end, "verbs")
            return not (self._after_noun() and after is not None) and link.value == "which" and noun.value != "who"
        return link.sort == "fillers" or noun.end - noun.start >= link.length

    def _text_at(self, at: int) -> str:
        return self.tokens[at].text if at < len(self.tokens) else ""

    def _after_noun(self) -> bool:
        return bool(self.made) and isinstance(self.made[-1], Noun)


@lru_cache(maxsize=1)
def _removing() -> frozenset[str]:
    """The first words of those that say that something is to go."""
    return frozenset(phrase.split()[0] for phrase in grammar().lists["removals"])


def cut(lexicon: Lexicon, tokens: Sequence[Token]) -> tuple[list[Chunk], list[SurfaceRequest]]:
    """The chunks of a text, and what it says besides of floors and walls that it names as places."""
    cutter = Cutter(lexicon, tokens)
    return cutter.chunks(), cutter.noted


__all__ = ["Adjective", "cut"]
