"""Noun phrases with any noun: determiner, quantity, modifiers, head."""

from thinkblox.assets.plurals import singular
from thinkblox.assets.repaint import LOOKS
from thinkblox.knowledge.vocabulary import is_person
from thinkblox.reading.adjectives import adjective_kinds, degree_of
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.grammar import Function, grammar
from thinkblox.reading.english.heads import ARTICLES, Heads, is_purpose
from thinkblox.reading.english.unread import unread_at
from thinkblox.reading.english.words import STOPS, Known, Unit, Units

_BESIDE = ("left of", "right of")
"""What a number can be followed by that stands for things: "one left of the bed"."""
_HOLDING = frozenset(
    "holds has contains carries bears stores houses displays holding containing carrying bearing".split()
)
"""What one of several does, of which more is told: "one | holds books"."""
_CLEAR = ("empty", "clear", "free")
"""What the rest of a room is, rather than the rest of several things."""
_NAMES = 5
"""Most unknown words that one name has."""
_ENDINGS = ("ed", "ing", "en", "ous", "ful", "ic", "less", "ish", "ive", "ly")
"""Endings of words that may be adjectives."""

_NAME = 3
"""Most words of somebody's name."""
_PAIR = 2
_BUILT = ("floor", "wall", "ceiling", "window", "door")
"""Places that a noun before them can describe: "a checkerboard floor"."""

_SIZES = ("large", "small")
"""Attributes by words that name things as well: "a grand hotel", "a grand"."""

_FINITE = frozenset("has have had is are was were hold holds carry carries contain contains".split())
"""Verbs that tell of so many what they are or have, and are no part of a name: "two have lamps"."""
_AT_SIDE = ("on", "to", "at", "in")
"""Before a side at which so many stand: "on the left three beds"."""


class PhraseReader(Heads):
    """Reads noun phrases of one text."""

    def read(self, start: int, *, after_preposition: bool = False) -> Noun | None:
        """The noun phrase that begins at `start`, or None."""
        noun = Noun("abstract", "", start, start)
        if owned := self._owned(start):
            return self._finished(Noun("pronoun", "other", start, start + owned))
        pronoun = grammar().at(self.tokens, start, "pronouns")
        if pronoun is not None and pronoun.value in ("former", "latter"):
            noun.kind, noun.value, noun.end = "pronoun", pronoun.value, start + pronoun.length
            return self._finished(noun)
        if pronoun is not None and pronoun.value == "each" and self._ends_with_them(start, start + pronoun.length):
            noun.kind, noun.value, noun.end = "pronoun", pronoun.value, start + pronoun.length
            return self._finished(noun)
        each = pronoun.length if pronoun is not None and pronoun.value == "each" else 0
        if length := self._each_before_number(start, each, after_preposition=after_preposition):
            return self._finished(Noun("pronoun", "each", start, start + length, "each"))
        if pronoun is not None and self._is_rest(start, start + pronoun.length):
            noun.kind, noun.value, noun.end = "pronoun", pronoun.value, start + pronoun.length
            return self._finished(noun)
        at = self._before(noun, start)
        if noun.ordinal and (number := self._number(at)) is not None:
            several = not self._starts_noun(at + number[1])
            counts_next = self._is_one(at) and self._number(at + 1) is not None
            if (noun.ordinal != 1 or counts_next) and not several:
                noun.kind, noun.end = "number", at + self._is_one(at)
                return self._finished(noun)
            noun.end, noun.count, noun.plural = at + number[1], number[0], number[0] > 1
            if several:
                noun.kind = "number"
                return self._finished(noun)
            noun.of_known, at = True, noun.end
        return self._named_at(noun, at, after_preposition=after_preposition)

    def _is_rest(self, start: int, end: int) -> bool:
        """Whether "the rest" is of several things, of which a look is told: "the rest blue", "the rest are blue"."""
        if self._text(start, end).lower() != "the rest":
            return False
        be = self._text(end, end + 1).lower() in ("is", "are")
        after = self._known(end + be, "attribute", "style")
        if after is None:
            return False
        return after.entry.value not in _CLEAR if be else not self._starts_noun(end + after.length)

    def _owned(self, at: int) -> int:
        """How many tokens "his", "Mrs Olsen's" have, where what is theirs is meant without its name; 0 for another."""
        length = 1 if self.tokens[at].text in grammar().lists["owned"] else self._owner(at)
        workplace = length > 1 and self._text(at - 1, at).lower() in ("at", "in") and self._known(at + 1, "room")
        if not length or workplace:
            return 0
        end = at + length
        ends = end >= len(self.tokens) or self.tokens[end].kind == "mark" or self.tokens[end].text == "and"
        ends &= length == 1 and self.tokens[at].text in grammar().lists["owned"]
        return length if ends or grammar().at(self.tokens, end, "verbs") is not None else 0

    def _owner(self, at: int) -> int:
        """How many tokens the name of somebody who owns something has: "Anna's", "my sister's"; 0 for none."""
        named = grammar().at(self.tokens, at, "determiners") is not None
        for end in range(at + named, min(at + named + _NAME, len(self.tokens))):
            token = self.tokens[end]
            somebody = token.shown[:1].isupper() or (named and is_person(token.text))
            if token.kind != "word" or not somebody or self.thing_at(end) is not None:
                return 0
            if token.owner:
                return end + 1 - at
        return 0

    def _is_each_doing(self, start: int) -> bool:
        """Whether "each" is told what it does, though the verb could be a noun: "each stores five boxes"."""
        doing = grammar().at(self.tokens, start + 1, "verbs") if self.tokens[start].text == "each" else None
        if (
            doing is None
            or doing.value not in ("hold", "carry", "have")
            or not self.tokens[start + 1].text.endswith("s")
        ):
            return False
        return grammar().at(self.tokens, start + 1 + doing.length, "count", "determiners", "quantifiers") is not None

    def _ends_with_them(self, start: int, end: int) -> bool:
        """Whether "each of them" ends, and a phrase of its own comes: "on each of them five pots"."""
        ends = self._text(start, end).lower().endswith((" them", " which"))
        return ends and grammar().at(self.tokens, end, "determiners", "count", "vague") is not None

    def _each_before_number(self, start: int, length: int, *, after_preposition: bool) -> int:
        """Length of an "each" after which so many of something new come; 0 where it belongs to what follows."""
        if self._is_each_doing(start) or (after_preposition and self._is_each_of_those(start)):
            return 1
        return length if length and self._counts_after(start, length) else 0

    def _is_each_of_those(self, start: int) -> bool:
        """Whether "each" ends, and a number of something new comes: "under each | one sports bag"."""
        apart = start > 0 and self.tokens[start - 1].text in ("between", "for", "per", "of", "to")
        number = self._number(start + 1) if self.tokens[start].text == "each" and not apart else None
        return number is not None and self._starts_noun(start + 1 + number[1])

    def _counts_after(self, start: int, length: int) -> bool:
        """Whether a number of something new follows: "on each of these | one plate and two glasses"."""
        pointed = self.tokens[start + length - 1].text in ("these", "those", "them")
        return pointed and self._number(start + length) is not None

    def _named_at(self, noun: Noun, at: int, *, after_preposition: bool) -> Noun | None:
        """What the words after determiner and quantity make of the phrase."""
        if noun.ordinal and noun.det == "a" and self._text(at, at + 1) == "," and self._is_plain_adjective(at + 1):
            at, noun.ordinal = at + 1, 0
        self.group = noun.det in ("all", "both", "other", "half", "none")
        if noun.det in ("all", "both") and self._is_finish(at):
            return self._finished(Noun("pronoun", "all", noun.start, at, det=noun.det))
        if self._part(noun, at, after_preposition=after_preposition):
            return self._finished(noun)
        units = Units()
        end = self._units(noun, at, units)
        if not units.nouns or self._is_what_they_do(noun, at, end):
            return self._headless(noun, at, at if units.nouns else end, units)
        noun.end = end
        self._head(noun, units)
        noun.called = f"{noun.called} {self._called(noun, units)}".strip()
        if not noun.det and noun.count is None and self.tokens[noun.start].text in ARTICLES:
            noun.det = "a"
        if noun.ordinal and noun.plural and noun.kind == "thing" and noun.count == 1 and not noun.of_known:
            return self._finished(Noun("number", "", noun.start, at, det=noun.det, count=1, ordinal=noun.ordinal))
        self._size_after(noun)
        if self._is_only_a_look(noun):
            look = Noun("number", "", noun.start, noun.end, det=noun.det, count=noun.count, attributes=[noun.material])
            look.plural = noun.det == "other" and (noun.count or 1) > 1
            return self._finished(look)
        return self._finished(noun)

    def _is_finish(self, at: int) -> bool:
        """Whether "painted white" ends there, which says what those before look like: "all painted white"."""
        if at >= len(self.tokens) or self.tokens[at].text not in grammar().lists["finished"]:
            return False
        end = at + 1
        while end < len(self.tokens) and self._is_plain_adjective(end):
            end += 1
        return end > at + 1 and (end >= len(self.tokens) or self.tokens[end].kind == "mark")

    def _is_only_a_look(self, noun: Noun) -> bool:
        """Whether "one is orange", "the other two orange" says which colour they have, and asks for no fruit."""
        if noun.kind != "thing" or not noun.material:
            return False
        said = bool(noun.count) and self._text(noun.end - 2, noun.end - 1) in ("is", "are")
        ends = noun.end >= len(self.tokens) or self.tokens[noun.end].kind == "mark"
        other = noun.det == "other" and not noun.plural and ends
        return said or (other and noun.called == noun.material)

    def _is_what_they_do(self, noun: Noun, at: int, end: int) -> bool:
        """Whether a verb follows a number that stands for things: "two stand by the window", "one stands there"."""
        if noun.count is None:
            return False
        can = self.tokens[at].text in grammar().lists["modals"]
        if can and grammar().at(self.tokens, at + 1, "verbs") is not None:
            return True
        verb = grammar().at(self.tokens, at, "verbs") if not noun.of_known and end == at + 1 else None
        if verb is None or verb.length != 1 or self.tokens[at].text.endswith("s") != (noun.count == 1):
            return False
        return grammar().at(self.tokens, end, "prepositions", "pronouns", "determiners") is not None

    def _part(self, noun: Noun, at: int, *, after_preposition: bool) -> bool:
        part = self._longest_part(at)
        if part is None or not (noun.det or noun.count is not None or after_preposition or noun.ordinal):
            return False
        bare = noun.count is not None and not noun.det and not noun.ordinal
        if bare and self._text(at, at + 2) in _BESIDE:
            return False
        place = self._known(at, "place")
        after = at + part.length
        if place is not None and place.length > part.length:
            return False
        if grammar().at(self.tokens, at, "mutual") is not None:
            return False
        if part.value in ("left", "right", "middle", "back", "front", "side", "end", "top", "inside", "head", "foot"):
            closed = self._is_led_to_side(noun.start) or self.tokens[after - 1].text in ("side", "end")
            counted = closed and self._number(after) is not None and not self._is_the_one(at, after)
            if counted or self._verb_follows(after) or self._adjective_ends(after):
                pass
            elif self._starts_noun(after) or self._is_one(after):
                outer = ("back", "front") if self._is_one(after) else ()
                noun.side = part.value if part.value in ("left", "right", "middle", *outer) else ""
                return False
        if part.value == "in_shelf" and part.length < 2:
            return False
        noun.kind, noun.value, noun.end = "part", part.value, after
        noun.det = "my" if self.tokens[after - 1].text == "it" else noun.det
        noun.plural = self.tokens[after - 1].text.endswith("s")
        return noun.det != "no"

    def _is_led_to_side(self, start: int) -> bool:
        """Whether "on", "to" or the like stands before, and not "next to"."""
        if not start or self.tokens[start - 1].text not in _AT_SIDE:
            return False
        longer = grammar().at(self.tokens, start - 2, "prepositions") if start > 1 else None
        return longer is None or longer.length == 1

    def _is_the_one(self, at: int, one: int) -> bool:
        """Whether "the left one" is one of those known: "on the left one is a hat", not "on the left one hat"."""
        told = [token.text for token in self.tokens[max(at - 3, 0) : at]] == ["one", "on", "the"]
        return self._is_one(one) and not told and not self._starts_noun(one + 1)

    def _adjective_ends(self, at: int) -> bool:
        """Whether only an adjective comes: "leave the middle free for ..."."""
        state = grammar().at(self.tokens, at, "states")
        return state is not None and not self._starts_noun(at + state.length)

    def _verb_follows(self, at: int) -> bool:
        """Whether a verb and then another noun phrase come: "in the middle stand two tables"."""
        verb = grammar().at(self.tokens, at, "verbs")
        if verb is None:
            return False
        after = at + verb.length
        if grammar().at(self.tokens, after, "determiners", "quantifiers", "count", "vague") is not None:
            return True
        return grammar().at(self.tokens, after, "evaluative") is not None and self._starts_noun(after + 1)

    def _units(self, noun: Noun, at: int, units: Units) -> int:
        of_them = noun.of_known and self.tokens[at - 1].text in ("them", "these", "those", "which")
        if (noun.ordinal or of_them) and grammar().at(self.tokens, at, "verbs", "participles") is not None:
            return at
        while at < len(self.tokens) and self.tokens[at].kind != "mark" and not self._is_unread(at):
            length = self._unit(noun, at, units)
            if not length:
                break
            at += length
            at += self._comma(noun, at, units)
        return at

    def _comma(self, noun: Noun, at: int, units: Units) -> int:
        """1 for the comma of "a large, round table"; 0 where it ends the phrase."""
        described = bool(units.adjectives) and not units.nouns and (bool(noun.det) or noun.count is not None)
        if not described or at + 2 >= len(self.tokens) or self.tokens[at].text != ",":
            return 0
        for after in range(at + 1, min(at + 6, len(self.tokens))):
            if self.tokens[after].text in (",", "and"):
                continue
            thing, looks = self.thing_at(after), self._known(after, "attribute", "style") is not None
            if thing is not None and (not self._is_plain_adjective(after) or (looks and thing.length > 1)):
                return int(after > at + 1 or looks)
            if not self._is_plain_adjective(after):
                return 0
        return 0

    def _is_plain_adjective(self, at: int) -> bool:
        """Whether a word only describes what comes after it."""
        word = self.tokens[at].text
        if self.tokens[at].kind != "word" or grammar().at(self.tokens, at, *STOPS) is not None:
            return False
        said = self._known(at, "attribute", "style") is not None or bool(adjective_kinds(word) or degree_of(word))
        return said or grammar().at(self.tokens, at, "evaluative", "states") is not None

    def unread_at(self, at: int) -> int:
        """How many tokens a stretch that asks for what no room shows has at `at`; 0 where none begins there."""
        if at not in self._unread:
            self._unread[at] = unread_at(self.tokens, at)
        return self._unread[at]

    def _is_unread(self, at: int) -> bool:
        """Whether words begin that nothing is made of; an animal after other words names a thing: "a porcelain dog"."""
        return bool(self.unread_at(at)) and self.tokens[at].text not in grammar().lists["animals"]

    def _unit(self, noun: Noun, at: int, units: Units) -> int:
        """Take the next word or phrase; returns the tokens it takes, 0 where the noun phrase ends."""
        if self._is_figure(noun, at, units):
            units.nouns.append(Unit(self.tokens[at].shown))
            return 1
        if (
            units.nouns
            and self._is_shape(at)
            and all(u.known is None and singular(u.text) == u.text for u in units.nouns)
        ):
            return self._adjective(noun, at)
        return self._word(noun, at, units)

    def _word(self, noun: Noun, at: int, units: Units) -> int:
        if self._ends_early(noun, at, units):
            return 0
        if units.nouns and units.nouns[-1].owner and (part := self._longest_part(at)) is not None:
            units.nouns.append(Unit(self._text(at, at + part.length)))
            return part.length
        if not units.nouns and (length := self._side(noun, at)):
            return length
        known = self._parted(noun, at, self._known(at, "object", "missing", "room", "place"))
        unjoined = known is None or not self._covers(at, known.length)
        if self.tokens[at].glued and unjoined and (length := self._glued(noun, at, units)):
            return length
        stop = grammar().at(self.tokens, at, *STOPS)
        if known is not None and not units.nouns and self._is_one_alone(at + known.length):
            return self._kind_of_one(noun, at, units, known)
        if known is not None and not units.nouns and self._is_shade(at, known.length):
            known = None
        if known is not None and self._is_better(known, stop, units):
            return self._take(noun, at, units, known)
        if not units.nouns and (length := self._adjective(noun, at)):
            if stop is None or length > stop.length or self._continues(noun, at + length) or self._is_shape(at):
                units.adjectives += 1
                return length
            self._forget(noun)
            return 0
        return self._despite(noun, at, stop, units) if stop is not None else self._open(noun, at, units)

    def _take(self, noun: Noun, at: int, units: Units, known: Known) -> int:
        """Take a phrase of the lexicon; a place after nouns ends them, unless it is a word of their name."""
        unknown = not any(unit.owner for unit in units.nouns)
        built = known.entry.value.split()[0] in _BUILT and unknown
        label = not noun.start and noun.det in ("", "a") and self.tokens[at].text in grammar().lists["rooms"]
        if known.entry.sort == "place" and units.nouns and label:
            units.nouns.append(Unit(self.tokens[at].shown))
            return known.length
        if known.entry.sort == "place" and units.nouns and not built:
            after_thing = units.nouns[-1].known is not None and units.nouns[-1].known.entry.sort == "object"
            if known.entry.value != "centre" or known.length > 1 or noun.det == "the" or after_thing:
                return 0
            units.nouns.append(Unit(self.tokens[at].shown))
            return 1
        owner = self.tokens[at + known.length - 1].owner
        units.nouns.append(Unit(self._text(at, at + known.length), known, owner))
        return known.length

    def _is_shape(self, at: int) -> bool:
        """Whether "round" is an adjective: "Centre: round table", not "round the table"."""
        if at >= len(self.tokens) or self.tokens[at].text != "round":
            return False
        follows = self._starts_noun(at + 1) or (self._is_one(at + 1) and self._text(at - 1, at).lower() in ("a", "the"))
        return follows and grammar().at(self.tokens, at + 1, "determiners") is None

    def _is_figure(self, noun: Noun, at: int, units: Units) -> bool:
        """Whether several of a singular noun have to be of a word for people: "seven tin | soldiers"."""
        several = noun.count is not None and noun.count > 1 and len(units.nouns) == 1 and not units.nouns[0].owner
        people = several and self.tokens[at].text.endswith("s") and grammar().knows(self.tokens[at].text, "people")
        return people and singular(units.nouns[0].text.lower()) == units.nouns[0].text.lower()

    def _is_one_alone(self, at: int) -> bool:
        """Whether "one" stands for a noun, rather than before one: "under the bench | one basket"."""
        if not self._is_one(at):
            return False
        return grammar().at(self.tokens, at + 1, "verbs", "participles") is not None or not self._starts_noun(at + 1)

    def _kind_of_one(self, noun: Noun, at: int, units: Units, known: Known) -> int:
        """Take the iron of "a black iron one" for what that is like."""
        said = self._known(at, "attribute")
        if said is not None and said.length == known.length:
            noun.attributes.append(said.entry.value)
        else:
            noun.unshown.append(self._text(at, at + known.length))
        units.adjectives += 1
        return known.length

    def _is_shade(self, at: int, length: int) -> bool:
        """Whether a word for a thing is the colour or material of what follows: "orange cushions", "a glass table"."""
        if length == 1 and self.tokens[at].text in grammar().lists["tints"] and self._is_colour(at + 1):
            return True
        said = self._known(at, "attribute")
        if said is not None and said.length > length and self._starts_noun(at + said.length):
            return said.entry.value in LOOKS
        if said is None or said.length != length or not (self._starts_noun(at + length) or self._is_one(at + length)):
            return False
        return said.entry.value in LOOKS or said.entry.value in _SIZES

    def _covers(self, at: int, length: int) -> bool:
        """Whether a phrase covers all that hyphens join at `at`."""
        return not self.tokens[at + length - 1].glued

    def _parted(self, noun: Noun, at: int, known: Known | None) -> Known | None:
        """Take from a name what belongs to the words after it."""
        described = self._known(at, "attribute") if known is not None and self.tokens[at].glued else None
        if described is not None and known is not None and described.length > known.length:
            return None
        return self._unglued(at, self._without_verb(noun, at, known))

    def _without_verb(self, noun: Noun, at: int, known: Known | None) -> Known | None:
        """Part "a tall plant | stands near the door" from "two plant stands"."""
        if known is None or known.length < 2 or not known.entry.plural:
            return known
        verb = at + known.length - 1
        single = noun.count == 1 or (noun.count is None and noun.det in ("a", "each", "another"))
        again = noun.count is None and noun.det in ("the", "my")
        before = self._is_said_before(at, verb) or self._is_whole_clause(noun.start, verb)
        again &= before or self._is_fronted(noun.start, verb)
        joined = noun.count is None and not noun.det and self._is_joined_to_one(noun.start, verb)
        if not (single or again or joined) or grammar().at(self.tokens, verb, "verbs") is None:
            return known
        shorter = self.lexicon.longest(self.tokens, at, known.length - 1)
        entry = shorter.entry("object", "missing", "room", "place")
        return Known(entry, shorter.length) if entry is not None else known

    def _is_fronted(self, start: int, verb: int) -> bool:
        """Whether something new is said to be where a preposition says: "next to the plant | stands a lamp"."""
        ahead = range(max(start - _NAMES, 0), start)
        links = ((at, grammar().at(self.tokens, at, "prepositions")) for at in ahead)
        led = any(link is not None and at + link.length == start for at, link in links)
        return led and grammar().at(self.tokens, verb + 1, "determiners", "count") is not None

    def _is_joined_to_one(self, start: int, verb: int) -> bool:
        """Whether it ends the subject of a clause: "A cart with a monitor and keyboard | stands by the door."."""
        marks = (n + 1 for n in range(start - 1, -1, -1) if self.tokens[n].kind == "mark")
        before = range(next(marks, 0), start)
        if len(before) < 2 or self.tokens[start - 1].text != "and" or not self._is_whole_clause(before[0], verb):
            return False
        last = self.tokens[start - 2].text
        return singular(last) == last and not any(grammar().at(self.tokens, n, "verbs") for n in before)

    def _is_whole_clause(self, start: int, verb: int) -> bool:
        """Whether a clause begins at `start` that has no other verb: "The piano stands opposite the sofa."."""
        if start and self.tokens[start - 1].kind != "mark":
            return False
        if grammar().at(self.tokens, verb + 1, "prepositions") is None:
            return False
        ends = (n for n in range(verb + 1, len(self.tokens)) if self.tokens[n].kind == "mark")
        rest = range(verb + 1, next(ends, len(self.tokens)))
        return not any(grammar().at(self.tokens, n, "verbs") is not None for n in rest)

    def _is_said_before(self, at: int, end: int) -> bool:
        """Whether the same words came before, and what came after them was another word or none."""
        said, after = [token.text for token in self.tokens[at : end + 1]], end - at
        alike = (n for n in range(at - after) if self.tokens[n].text == said[0])
        before = (self.tokens[n : n + after + 1] for n in alike)
        found = ([token.text for token in tokens] for tokens in before)
        return any(words[:after] == said[:after] and singular(words[after]) != singular(said[after]) for words in found)

    def _ends_early(self, noun: Noun, at: int, units: Units) -> bool:
        """Whether "a bench for four | stands by the door", "a TV | wall-mounted opposite it" is parted here."""
        text = self.tokens[at].text
        if (text == "x" and not self.tokens[at].glued) or text == "there":
            return True
        if text in ("one", "ones") and (units.nouns or units.adjectives or noun.det):
            return True
        if text in _HOLDING and self._text(at - 1, at).lower() == "one" and not units.nouns:
            return True
        if text in grammar().lists["modals"] and units.nouns and is_purpose(units.nouns[-1].text.lower()):
            return True
        if text in grammar().lists["finished"] and units.nouns and self._known(at + 1, "attribute") is not None:
            return True
        if text in grammar().lists["befell"] and units.nouns:
            return True
        if text == "seats" and noun.count == 1 and not noun.det:
            return True
        if text == "measures" and units.nouns and self.size_at(at + 1) is not None:
            return True
        people = noun.count is not None and self._text(noun.start - 1, noun.start).lower() == "for"
        last = units.nouns[-1].known if units.nouns else None
        if last is not None and (self._is_state_at_end(at) or self._lies_on_named(noun, at, last)):
            return True
        stands = text == "stands" and not units.nouns and people
        return stands or (bool(units.nouns) and self.is_after_noun(at))

    def _lies_on_named(self, noun: Noun, at: int, last: Known) -> bool:
        """Whether other things are said to lie on what was named before: "on the changing table | diapers and ..."."""
        if noun.det != "the" or last.length < _PAIR or last.entry.sort != "object":
            return False
        things = self._known(at, "object")
        if things is None or not things.entry.plural:
            return False
        if grammar().at(self.tokens, noun.start - 1, "prepositions") is None:
            return False
        name = [token.text for token in self.tokens[at - last.length : at]]
        before = [token.text for token in self.tokens[: noun.start]]
        return any(before[n : n + len(name)] == name for n in range(len(before) - len(name) + 1))

    def _is_state_at_end(self, at: int) -> bool:
        """Whether only how the thing is to be found comes, and where: "Curtains closed.", "mats | rolled up in ..."."""
        state = grammar().at(self.tokens, at, "states")
        if state is None or grammar().at(self.tokens, at, "prepositions") is not None:
            return False
        end = at + state.length
        placed = state.length > 1 and grammar().at(self.tokens, end, "prepositions") is not None
        return placed or end >= len(self.tokens) or self.tokens[end].kind == "mark"

    def is_after_noun(self, at: int) -> bool:
        """Whether words that hyphens join describe the noun before them: "a TV wall-mounted opposite it"."""
        end = at
        while end + 1 < len(self.tokens) and self.tokens[end].glued:
            end += 1
        return end > at and self.tokens[end].text.endswith("ed") and not self._starts_noun(end + 1)

    def _unglued(self, at: int, known: Known | None) -> Known | None:
        """Part "a TV | wall-mounted opposite it" from "a TV wall"."""
        if known is None or known.length < 2 or not self.tokens[at + known.length - 1].glued:
            return known
        if self.tokens[at].glued or self.tokens[at + known.length].text not in ("mounted", "hung", "fixed"):
            return known
        shorter = self.lexicon.longest(self.tokens, at, known.length - 1)
        entry = shorter.entry("object", "missing", "room", "place")
        return Known(entry, shorter.length) if entry is not None else known

    def _is_better(self, known: Known, stop: Function | None, units: Units) -> bool:
        if stop is None or known.length > stop.length:
            return True
        if known.length < stop.length:
            return False
        if stop.sort in ("verbs", "participles"):
            return not units.nouns and not self.group
        return stop.sort not in ("prepositions", "joins", "inverses", "determiners", "negations")

    def _despite(self, noun: Noun, at: int, stop: Function, units: Units) -> int:
        """Take a verb for a noun or adjective where a noun has to come: "the stand", "a hanging lamp"."""
        if self._is_plural_head(noun, at, stop, units) or self._is_singular_head(noun, at, stop, units):
            units.nouns.append(Unit(self.tokens[at].shown))
            return 1
        if units.nouns or not (noun.det or noun.count is not None) or not self._may_be_doing(noun, at, stop):
            return 0
        if noun.degree and stop.sort == "verbs" and not self._starts_noun(at + stop.length):
            return 0
        if stop.sort == "verbs" and grammar().at(self.tokens, at + stop.length, "determiners", "count", "quantifiers"):
            return 0
        if self._starts_noun(at + stop.length):
            units.adjectives += 1
            return stop.length
        if (
            stop.length > 1
            or stop.value == "be"
            or self.tokens[at].text in ("is", "are", "was", "has", "have", "needs", "gets")
        ):
            return 0
        units.nouns.append(Unit(self.tokens[at].shown))
        return 1

    def _may_be_doing(self, noun: Noun, at: int, stop: Function) -> bool:
        """Whether a verb after what begins a phrase may belong to it: "the facing desks", not "two of them stand"."""
        several = noun.det != "" or noun.count is not None
        facing = self.tokens[at].text == "facing" and several and self._starts_noun(at + 1)
        before = self.tokens[at - 1].text
        ends = noun.det in ("other", "both", "all", "half", "none") or before in ("this", "that", "these", "those")
        ends |= noun.of_known and before in ("them", "which", "whom")
        ends |= noun.count is not None and not noun.det and self.tokens[at].text in _FINITE
        return (facing or stop.sort in ("verbs", "participles")) and not ends

    def _is_plural_head(self, noun: Noun, at: int, stop: Function, units: Units) -> bool:
        """Whether several of a singular noun have to be of the next: "four repair stands", "on repair stands"."""
        several = noun.count is not None and noun.count > 1 and bool(units.nouns)
        if not (noun.det or several or noun.count is not None) and len(units.nouns) == 1:
            after = grammar().at(self.tokens, noun.start - 1, "prepositions") if noun.start else None
            follows = grammar().at(self.tokens, at + 1, "determiners", "count", "quantifiers", "vague")
            several = after is not None and follows is None and units.nouns[0].known is None
        if not several or stop.sort != "verbs" or stop.length > 1 or not self.tokens[at].text.endswith("s"):
            return False
        last = units.nouns[-1]
        return self.tokens[at].text not in ("is", "was", "has") and not last.owner and singular(last.text) == last.text

    def _is_singular_head(self, noun: Noun, at: int, stop: Function, units: Units) -> bool:
        """Whether a verb of several has to be a noun after a single one: "on a repair stand", "a molecule model"."""
        single = noun.det in ("a", "another") and noun.count in (None, 1) and bool(units.nouns)
        if (
            not single
            or stop.sort != "verbs"
            or stop.length > 1
            or self._text(noun.start - 1, noun.start).lower() == "and"
        ):
            return False
        word, last = self.tokens[at].text, units.nouns[-1]
        named = word in grammar().lists["heads"] or self.thing_at(at) is not None
        return named and not word.endswith("s") and not last.owner and last.known is None

    def _open(self, noun: Noun, at: int, units: Units) -> int:
        """Take a word that no list has."""
        token = self.tokens[at]
        if (length := self._between_words(noun, at, units)) is not None:
            return length
        if token.kind == "number" and self._is_inner_number(at) and units.nouns:
            return 1
        if token.kind != "word":
            return 0
        if token.owner:
            units.nouns.append(Unit(token.shown, None, True))
            return 1
        adverb = token.text.endswith("ly") and len(token.text) > 4 and not grammar().knows(token.text, "people")
        if adverb and self._known(at + 1, "object") is None:
            return 1 if self._starts_noun(at + 1) and not units.nouns else 0
        if not units.nouns and token.text in grammar().lists["shades"] and self._is_colour(at + 1):
            self._idle(noun, at, at + 1)
            units.adjectives += 1
            return 1
        ranked = token.text in grammar().lists["ranks"] and self._is_one(at + 1)
        if not units.nouns and (ranked or degree_of(token.text)):
            return self._degree(noun, at, units)
        if units.nouns and self._ends_before(at, units):
            return 0
        if not units.nouns and self._may_describe(noun, at):
            noun.unshown += [] if is_purpose(token.text) else [token.shown.lower()]
            units.adjectives += 1
            return 1
        units.nouns.append(Unit(token.shown))
        return 1

    def _may_describe(self, noun: Noun, at: int) -> bool:
        """Whether a word that no list has is an adjective: "a worn bench", "a fluffy white rug", "a Persian one"."""
        word = self.tokens[at].text
        adjective = word.endswith(_ENDINGS) or word in grammar().lists["turned"]
        adjective |= bool({"size", "build"} & adjective_kinds(word))
        if adjective and self._goes_on_to_noun(at + 1):
            return True
        if self._is_colour(at + 1) and self.thing_at(at + 1) is None and self._goes_on_to_noun(at + 2):
            return True
        named = bool(noun.det) or noun.count is not None
        return named and self._is_one(at + 1) and not noun.of_known

    def _goes_on_to_noun(self, at: int) -> bool:
        """Whether a noun comes, with or without adjectives before it."""
        return self._is_shape(at) or (self._starts_noun(at) and self._has_noun(at))

    def _is_colour(self, at: int) -> bool:
        """Whether a colour or material comes."""
        said = self._known(at, "attribute")
        return said is not None and said.entry.value in LOOKS

    def _degree(self, noun: Noun, at: int, units: Units) -> int:
        """Take "larger", "oldest" before a noun, or for one of several: "the smaller of them"."""
        follows = self._starts_noun(at + 1)
        if not (follows or self._is_one(at + 1) or noun.det in ("the", "my")):
            return 0
        noun.degree = self.tokens[at].text
        noun.unshown.append(noun.degree)
        units.adjectives += 1
        return 1

    def _between_words(self, noun: Noun, at: int, units: Units) -> int | None:
        """How many tokens a filler, participle or pronoun takes before a noun; None where it is none of them."""
        counted = bool(noun.det) or noun.count is not None
        filler = grammar().at(self.tokens, at, "fillers")
        if filler is not None:
            can = ((counted or units.adjectives) and not units.nouns) or (bool(units.nouns) and units.nouns[-1].owner)
            self._idle(noun, at, at + filler.length)
            if can and self.tokens[at].text == "own":
                noun.det = "a"
            return filler.length if can and self._starts_noun(self._past_state(at + filler.length)) else 0
        if (noun.det, self.tokens[at].text) == ("each", "half"):
            units.nouns.append(Unit("half"))
            return 1
        doing = grammar().at(self.tokens, at, "participles", "pronouns")
        if doing is None:
            return None
        if noun.det == "each" and doing.value in ("hold", "carry", "surround", "flank", "line"):
            return 0
        return 1 if counted and not units.nouns and self._starts_noun(at + 1) else 0

    def _past_state(self, at: int) -> int:
        """Where it goes on after "folded" of "a neatly folded towel"."""
        state = grammar().at(self.tokens, at, "states")
        return at + state.length if state is not None else at

    def _ends_before(self, at: int, units: Units) -> bool:
        """Whether the name that was read ends before an unknown word."""
        if self._is_verb(at, units) or len(units.nouns) >= _NAMES:
            return True
        if self.tokens[at].text in grammar().lists["uncluttered"] and not self._starts_noun(at + 1):
            return True
        last = units.nouns[-1]
        return last.known is not None and not last.owner and not self._ends_name(at)

    def _ends_name(self, at: int) -> bool:
        """Whether an unknown word after a known noun is the head of a longer name: "popcorn machine"."""
        word = self.tokens[at].text
        if at < _NAMES and self._text(at + 1, at + 2) in (":", "(") and word in grammar().lists["rooms"]:
            return True
        if grammar().at(self.tokens, at, "abstract", "people") or self._known(at, "attribute", "style", "count"):
            return False
        after = at + 1
        ends = after >= len(self.tokens) or self.tokens[after].kind != "word"
        return (
            ends
            or word in grammar().lists["heads"]
            or not self._starts_noun(after)
            or self._known(after, "object") is None
        )

    def _is_verb(self, at: int, units: Units) -> bool:
        """Whether an unknown word looks like the verb of the noun before it."""
        word, last = self.tokens[at].text, units.nouns[-1].known
        if not word.endswith(("s", "ed", "ing")) or word.endswith("ss"):
            return False
        if last is not None and last.entry.sort == "place" and word.endswith("ing") and self._starts_noun(at + 1):
            return True
        return (
            at + 1 < len(self.tokens)
            and (
                grammar().at(self.tokens, at + 1, "determiners", "prepositions", "quantifiers", "count", "pronouns")
                is not None
            )
            and units.nouns[-1].known is not None
        )
