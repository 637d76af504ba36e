"""Chunks of an English text to a draft, clause by clause."""

from collections.abc import Callable, Mapping
from itertools import pairwise

from thinkblox.assets.catalogue import CATALOGUE
from thinkblox.assets.palette import COLOURS
from thinkblox.assets.plurals import singular
from thinkblox.knowledge.vocabulary import is_person
from thinkblox.reading.draft import Draft
from thinkblox.reading.english.audit import Audit
from thinkblox.reading.english.chunks import (
    Adjective,
    Connector,
    Measured,
    Noun,
    NounKind,
    SaidSurface,
    Stray,
)
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.named_again import join_named_again
from thinkblox.reading.english.negation import is_denied_verb
from thinkblox.reading.english.nodes import Awaited, Listed, Meaning, Node, Where
from thinkblox.reading.english.referents import FURNITURE, is_small
from thinkblox.reading.english.serial_commas import is_of_several, next_listed
from thinkblox.reading.english.state import LOOKAHEAD
from thinkblox.reading.stacks import STACKED


def _sorts(text: str) -> list[tuple[str, str]]:
    """What the grammar says of a word, as its section and the word."""
    return [(sort, text) for sort, _ in grammar().phrases.get(tuple(text.split()[-1:]), ())]


_TURNING = ("against", "facing", "to")
"""Prepositions that say how a thing stands by one of its sides."""
_END = Connector("mark", "stop", 0, 0)
"""What ends a text."""
_ANGLED = "angled"
"""What is said of what is turned to something, unless it is so only slightly."""
_LOOSE = ("scattered", "strewn", "dotted")
"""How things lie that are in no order, as all do of which nothing is said."""


class Clauses(Audit):
    """Reads the chunks of one text."""

    def read(self) -> Draft:
        """Read everything."""
        while self.at < len(self.chunks):
            chunk = self.chunks[self.at]
            self.at += 1
            match chunk:
                case Noun():
                    self._noun(chunk)
                case Connector():
                    self._link(chunk)
                case Adjective():
                    self._adjective(chunk)
                case Measured():
                    self._measured(chunk)
                case Stray():
                    self._stray(chunk)
                case SaidSurface():
                    self.draft.surfaces.append(chunk.request)
        self._begin()
        self._settle_ends()
        self._drop_groups()
        self.referents.gather()
        join_named_again(self.draft, self.referents, self.named_by, self.meant)
        self._audit()
        self.draft.account = self.account.words()
        return self.draft

    def _stray(self, stray: Stray) -> None:
        """Note a word that means nothing to us; a lone article or letter names and changes nothing."""
        if (
            len(stray.text) == 1
            or _is_mere_adverb(stray.text.lower())
            or grammar().knows(stray.text.lower().replace("'", ""), "determiners", "pronouns")
        ):
            self.account.mark(stray.start, stray.end, "filler")
        else:
            following = self.peek()
            if self._is_link(self._before(), "prepositions"):
                self.pending = None
            self._lose(stray.start, stray.end)
            last = self.account.text(stray.start, stray.end).rpartition(" ")[2].lower()
            if isinstance(following, Noun) and (last in ("than", "as") or grammar().knows(last, "prepositions")):
                self.draft.unknown[-1] = self.account.text(stray.start, following.end)

    def _link(self, link: Connector) -> None:
        if link.sort in ("verbs", "participles", "prepositions"):
            self._say_manner(link)
        match link.sort:
            case "mark":
                self._mark(link)
            case "joins":
                self._join(link)
            case "prepositions":
                self._preposition(link)
            case "sequences":
                self._order(link)
            case "inverses":
                self._open(link.value)
            case "participles":
                self._participle(link.value)
            case "verbs":
                self._verb(link)
            case "negations":
                self._negation(link)
            case _:
                self._say_of_all(link)

    def _order(self, link: Connector) -> None:
        """Read in which order things are that come, or that the statement listed, where it ends."""
        self.sequence, self.separator = link, ""
        listed = [t for t in self.clause.members if t in self.draft.things]
        if self._is_link(self.peek() or _END, "mark", "stop", "semicolon") and not any(t.many for t in listed):
            for before, thing in pairwise(listed):
                self._come_after(thing, before)

    def _say_manner(self, link: Connector) -> None:
        """Note how things are said to be where they are: "slightly angled towards the fire", "stacked on the bed"."""
        words = [word.lower() for word in link.text.split()]
        said = next((at for at, word in enumerate(words) if word in grammar().lists["manners"]), None)
        named = self.frontier or self.subject is not None or self.clause.members
        if said is None or not named:
            return
        node = self.frontier[-1] if self.frontier else self.subject
        after = self.peek()
        if words[said] == STACKED and isinstance(after, Noun) and after.kind == "thing" and after.many:
            after.states += [STACKED] if STACKED not in after.states else []
            return
        on = self._is_link(after, "prepositions", "on", "on_top")
        if words[said] == STACKED and on and node is not None and not any(thing.many for thing in node.things):
            return
        if words[said] in _LOOSE or (words[said] == STACKED and node is not None):
            states = [] if words[said] in _LOOSE or node is None else [thing.states for thing in node.things]
            for told in states:
                told += [STACKED] if STACKED not in told else []
            return
        if words[said] in grammar().lists["leaning"] and self._stands_leaning(node):
            return
        if words[said] in ("grouped", "clustered") and self._is_link(self.peek(), "prepositions", "around"):
            return
        before, start = self._before(), link.start
        if (
            said == 0
            and isinstance(before, Connector)
            and before.sort == "fillers"
            and before.text.lower()[-2:] == "ly"
        ):
            start = before.start
        elif words[said] == _ANGLED and link.value == "facing":
            return
        self._lose(start, link.start + (len(words) if link.sort != "prepositions" else said + 1))

    def _stands_leaning(self, node: Node | None) -> bool:
        """Whether what leans against something is what stands there: a ladder, but no clock and no picture.

        A mirror that leans against a wall is one that stands.
        """
        by = self._next_noun(1) if self._is_link(self.peek(), "prepositions", "against", "on") else None
        at_wall = by is not None and by.kind == "place" and by.value.split()[-1] == "wall"
        if node is None or by is None or not (at_wall or by.kind in ("thing", "number", "pronoun")):
            return False
        for thing in node.things if at_wall else ():
            standing = f"standing_{thing.noun}"
            thing.noun = standing if standing in CATALOGUE else thing.noun
        return not any(self._belongs(t.noun, "wallpieces") or (not at_wall and is_small(t)) for t in node.things)

    def _say_of_all(self, link: Connector) -> None:
        """Read a correction, or how several stand to each other."""
        if link.sort == "corrections":
            self._correct(link)
        elif link.sort == "mutual":
            self._mutual(link)
            self.predicate |= link.text.lower().startswith(("face ", "are ", "stand "))

    def _noun(self, noun: Noun) -> None:
        self._as_seat(noun)
        if self._is_place_at_table(noun) or self._is_cleared(noun):
            return
        self._as_shade(noun)
        self._as_cubicle(noun)
        self.draft.style += noun.styles if not self.excluding else []
        if noun.kind == "thing" and (self._is_label(noun) or self._is_for_every(noun)):
            self._spend(noun)
            return
        readers: Mapping[NounKind, Callable[[Noun], None]] = {
            "thing": self._thing,
            "place": self._place,
            "room": self._room,
            "people": self._people,
            "number": self._number,
            "pronoun": self._pronoun,
            "part": self._part,
            "abstract": self._abstract,
        }
        readers[noun.kind](noun)
        if noun.kind != "room":
            self.separator = ""

    def _is_place_at_table(self, noun: Noun) -> bool:
        """Read "a table for four: each place has a plate", where no seats are named, as so many on the table."""
        place = noun.kind in ("abstract", "room") and noun.each and noun.word in grammar().lists["seats"]
        if not place or not self._is_link(self.peek(), "verbs", "have"):
            return False
        table = next((t for t in reversed(self.draft.things) if t.seats and not t.many), None)
        if table is None:
            self._lose(noun.start, noun.end)
            return False
        self._begin()
        self.crowd = table.seats
        self.front = [Awaited(Where("on", None), Meaning("on", (table,), told=True))]
        return True

    def _is_for_every(self, noun: Noun) -> bool:
        """Read "a lamp every two seats" as one for every two of them."""
        if not (noun.every and noun.counted) or self.separator or not isinstance(self._before(), Noun):
            return False
        self.at -= 1
        if self._gives_one_for_every(Connector("prepositions", "per", noun.start, noun.start, "every")):
            return True
        self.at += 1
        return False

    def _part(self, noun: Noun) -> None:
        """Read a part without a preposition: "a flag either side of the door"."""
        sides = noun.value == "side" and noun.det in ("either", "both", "each")
        having = self._is_link(self.peek(), "verbs", "have") or self._is_link(self.peek(), "prepositions", "with")
        if sides and having:
            self._side_has(noun)
        elif sides and self.frontier:
            self.at -= 1
            self._where(self._read_where(Connector("prepositions", "on", 0, 0)))
        elif not self._is_turned_part(noun):
            self._bare_part(noun)

    def _side_has(self, side: Noun) -> None:
        """Read "each side has a bed" as a bed on each side of what was named, or two of which nobody knows where."""
        self._begin()
        if self.draft.things:
            self.chunks[self.at] = side
            self._where(self._read_where(Connector("prepositions", "on", side.start, side.start)))
        else:
            self.at += 1
            self.clause = Listed(None, "list", times=2, each=True)
            self._lose(side.start, side.end)

    def _is_turned_part(self, noun: Noun) -> bool:
        """Whether it tells how the thing before it stands: "a bed, its headboard against the wall"."""
        own = noun.det == "my" or (noun.det == "the" and noun.text.lower().endswith("headboard"))
        if not own or not self.frontier or not self._is_link(self.peek(), "prepositions", *_TURNING):
            return False
        self._turn_by_part(noun)
        return True

    def _thing(self, noun: Noun) -> None:
        if noun.det == "no" or (self.excluding and not self.excepting):
            denied = self._bar(noun)
            if denied is None:
                return
            noun = denied
        if self._names_nothing(noun):
            self._spend(noun)
            return
        word = noun.text.rpartition(" ")[2].lower()
        if noun.definite and word in grammar().lists["parts"] and self._is_link(self.peek(), "prepositions", "of"):
            whole = self._next_noun(1)
            if whole is not None and whole.kind == "thing":
                self._spend(noun)
                self._go_past(whole)
                noun = whole
        if self._is_said_of_subject(noun):
            return
        if self.separator and (self._is_verb_left_out(noun) or self._begins_subjects() or self._is_new_clause(noun)):
            kept = self.separator
            topic = self.clause.members[:1] or (self.subject.things[:1] if self.subject else [])
            self.referents.topics += topic
            self._begin()
            self.separator = kept
        if self._is_definition(noun):
            self._define(noun)
            return
        self._take_thing(noun)

    def _take_thing(self, noun: Noun) -> None:
        """Take what was named before, or something new; it has what follows where a verb is left out."""
        elided = self._verb_left_out(noun)
        if elided:
            self._begin()
        if known := self._known(noun):
            self._take_known(noun, known)
        else:
            self._take_new(noun)
        if elided:
            self._again(elided)
        if known:
            last = self._before()
            put = isinstance(last, Connector) and last.sort == "negations" and last.text.lower().endswith(" put")
            self.negating = noun.det == "none" or (self.negating and put)

    def _verb_left_out(self, noun: Noun) -> str:
        """The verb of "the sofa has two cushions, the table three books" that is left out the second time."""
        listed = self.peek()
        new = isinstance(listed, Noun) and listed.kind == "thing" and (listed.det == "a" or listed.count is not None)
        said = self.said or self.verb
        return said if noun.det == "the" and new and self.separator in ("", "comma") and not self.front else ""

    def _as_cubicle(self, noun: Noun) -> None:
        """Take the fitting rooms of a shop for cubicles in it rather than for another room."""
        if noun.kind == "room" and noun.value == "fitting_room" and self.draft.room not in ("", "room", noun.value):
            noun.kind, noun.value, noun.called = "thing", "changing_cubicle", "fitting room"

    def _as_shade(self, noun: Noun) -> None:
        """Take a colour that is a fruit too for one where it parts several: "three chairs, one orange and two grey"."""
        coloured = noun.kind == "thing" and noun.value == noun.material and noun.value in COLOURS
        of_them = coloured and noun.of_known and " them " in noun.text.lower()
        several = self._whole([]) if of_them else self.frontier[-1].thing if self.frontier else None
        if several is None or not coloured or noun.det or noun.count is None:
            return
        other = self._next_noun(1)
        parted = self.referents.parted is not None and self._is_link(self._before(), "joins", "and")
        if parted and noun.count == self.referents.total(self.referents.parted or several):
            noun.kind, noun.value, noun.attributes = "number", "", [noun.material]
        if of_them and noun.count <= self.referents.total(several) and not noun.text.endswith("s"):
            noun.kind, noun.value, noun.attributes = "number", "", [noun.material]
        if other is not None and other.kind in ("number", "pronoun") and noun.count < self.referents.total(several):
            noun.kind, noun.value, noun.attributes = "number", "", [noun.material]

    def _take_new(self, noun: Noun) -> None:
        """Ask for a thing that was not named before; a share of nothing is not understood."""
        if noun.fraction[1]:
            self._lose(noun.start, noun.end)
            return
        if self._is_listed_feature(noun):
            return
        self.barred = None
        if self.pending is None and self._is_verb_of_before():
            self.subject = self.frontier[0]
            self._open_of_subject("with" if self.verb == "have" else self.verb)
        thing = self._new(noun)
        self._take(thing, noun)
        if self._holds_more(noun):
            self.frontier.append(Node([], Listed(self.frontier[-1], "inside", contents=True)))
        self.negating |= noun.det == "none"

    def _is_verb_of_before(self) -> bool:
        """Whether a verb is left out: "the one by the window has a vase, the one in the corner a lamp"."""
        placed = isinstance(self._before(), Noun) and self._is_link(self._before(2), "prepositions")
        told = self.verb in ("have", "hold", "carry") and not self.predicate and not self.separator
        return placed and told and bool(self.frontier) and self.frontier[0].known

    def _holds_more(self, noun: Noun) -> bool:
        """Whether more of what a thing is named by holding comes: "buckets of roses, tulips and lilies"."""
        held, _, contents = noun.text.lower().partition(" of ")
        more = self._next_noun(1)
        if not contents or singular(held.split()[-1]) not in grammar().lists["containers"] or more is None:
            return False
        listed = self._is_link(self.peek(), "mark", "comma") or self._is_link(self.peek(), "joins", "and")
        bare = more.kind == "thing" and not more.det and more.count is None
        bare &= noun.many or not self._lists_other_things()
        return listed and bare and not self.habits.is_in(more.value, *FURNITURE)

    def _lists_other_things(self) -> bool:
        """Whether a list that comes has things of its own: "a jar of pickles, salt and a stack of paper"."""
        for chunk in self.chunks[self.at : self.at + LOOKAHEAD]:
            if isinstance(chunk, Noun):
                if chunk.det or chunk.count is not None:
                    return True
            elif not (self._is_link(chunk, "mark", "comma") or self._is_link(chunk, "joins", "and")):
                return isinstance(chunk, Connector) and chunk.sort in ("prepositions", "participles", "verbs")
        return False

    def _names_nothing(self, noun: Noun) -> bool:
        """Whether it only says how large, how, or of which kind something is: "(3 seats)", "Obstacles: ..."."""
        done = self._is_link(self._before(), "fillers", "doing") and noun.count is None and not noun.det
        if self._is_capacity(noun) or done:
            return True
        label = not noun.named or noun.word in grammar().lists["labels"]
        after = self.peek()
        numbered = isinstance(after, Noun) and after.kind == "number" and noun.word in grammar().lists["labels"]
        ends = 1 if numbered or (isinstance(after, Noun) and after.kind == "abstract") else 0
        if not noun.det and label and noun.count is None and self._is_link(self.peek(ends), "mark", "colon"):
            if numbered and isinstance(after, Noun):
                self.numbers.add(after.count or 0)
                self._go_past(after)
            return True
        if self._is_what_somebody_does(noun):
            return True
        if not (self._is_mood(noun) or self._is_of_room(noun)):
            return False
        (self.draft.style if not noun.named else self.draft.unknown).append(noun.text.lower())
        return True

    def _is_what_somebody_does(self, noun: Noun) -> bool:
        """Whether it is what the writer does rather than what is there: "I teach art"."""
        who = self._before(2)
        speaks = isinstance(who, Connector) and who.text.lower() in ("i", "we")
        return speaks and self._is_link(self._before(), "verbs", "other") and not noun.det and noun.count is None

    def _is_of_room(self, noun: Noun) -> bool:
        """Whether words that nobody knows only say what kind of room comes: "an instagram ready kitchen"."""
        room = self._next_noun()
        return not noun.named and not self.draft.things and room is not None and room.kind == "room"

    def _is_mood(self, noun: Noun) -> bool:
        """Whether words that nobody knows only say how it is to feel: "nail salon, instagram ready"."""
        matter = ("abstract", noun.text.lower()) in _sorts(noun.text.lower())
        if (noun.named and not matter) or noun.det or noun.count is not None or noun.plural or self.pending is not None:
            return False
        told = self._is_link(self.peek(), "prepositions") and not self._is_link(
            self.peek(), "prepositions", "of", "for"
        )
        return not self.front and not told and not self.draft.things

    def _is_capacity(self, noun: Noun) -> bool:
        """Whether "(3 seats)" only says how large the sofa before it is."""
        last = self._before()
        thing = self.frontier[-1].thing if self.frontier else None
        if not self._is_link(last, "mark", "open") or thing is None or not noun.count:
            return False
        if noun.text.lower().split()[-1] not in ("seats", "seat", "seater"):
            return False
        thing.attributes.append(f"{noun.count}-seat")
        return True

    def _is_adjective(self, noun: Noun) -> bool:
        """Whether a noun without an article says what something is made of: "the second is glass"."""
        last = self._before()
        bare = not noun.det and noun.count is None and not noun.plural and noun.material != ""
        return bare and self._is_link(last, "verbs", "be") and self.predicate

    def _is_verb_left_out(self, noun: Noun) -> bool:
        """Whether a known thing is where a preposition says: "the sofa is by the wall, and the desk by the window"."""
        placed = self.predicate and self.verb in ("be", "stand", "hang") and noun.definite and not noun.each
        placed |= self._is_told_more_of(noun)
        link = self.peek(1) if self._is_link(self.peek(), "participles", "stand") else self.peek()
        if not placed or self.subject is None or not self._is_link(link, "prepositions"):
            return False
        if self._is_link(link, "prepositions", "with", "of", "for", "as", "without"):
            return False
        told = self._is_told_more_of(noun)
        told |= any(not b.implied for t in self.subject.things for b in self.draft.bonds_of(t))
        known = self.referents.named(noun)
        one_of_several = len(self.subject.things) > 1 and not noun.many
        return told and known is not None and (known not in self.subject.things or one_of_several)

    def _is_told_more_of(self, noun: Noun) -> bool:
        """Whether it tells of what the sentence named where it is: "has a skull and a lamp, the lamp left of ..."."""
        known = self.referents.named(noun) if noun.det == "the" and self.separator == "comma" else None
        if known is None:
            return False
        here = (t for chunk in self.chunks[self._clause_start() : self.at - 1] for t in self.meant.get(chunk.start, ()))
        return known in here

    def _is_said_of_subject(self, noun: Noun) -> bool:
        """Take "a recliner", "glass" after "is" for what the subject is."""
        if self._is_kind_told(noun):
            self._take_kind(noun)
            return True
        if self._is_adjective(noun):
            self._spend(noun)
            self._adjective(Adjective(noun.start, noun.end, noun.text, [noun.material]))
            return True
        return False

    def _is_kind_told(self, noun: Noun) -> bool:
        """Whether it says of which kind the subject is: "two of which are recliners", "the bed is a cot"."""
        thing = self.subject.thing if self.subject is not None and len(self.subject.things) == 1 else None
        if thing is None or not self.predicate or not self._is_link(self._before(), "verbs", "be") or self.negating:
            return False
        if noun.definite or noun.each or noun.det == "another" or noun.count not in (None, 1, thing.count):
            return False
        said = self.named_by.get(thing)
        told = (said is None or said.kind == "thing") and thing.asked and thing not in self.groups.values()
        return told and thing.many == noun.many and self._is_kin(thing, noun)

    def _take_kind(self, noun: Noun) -> None:
        """Call the subject what it is said to be."""
        self._spend(noun)
        things = self.subject.things if self.subject is not None else []
        for thing in things:
            thing.noun, thing.text = noun.value, noun.text
            thing.size = thing.size or noun.size
            self._look(thing, noun)

    def _is_new_clause(self, noun: Noun) -> bool:
        """Whether a verb of its own follows the noun: ", and two guitars hang on the wall"."""
        fresh = not self.predicate and not self.existential
        if (self.separator == "and" and fresh) or (self.separator == "comma" and fresh and not self.front):
            return False
        index = self.at
        while index < min(len(self.chunks), self.at + LOOKAHEAD):
            chunk = self.chunks[index]
            if isinstance(chunk, Connector):
                if chunk.sort == "verbs" or is_denied_verb(chunk):
                    text = chunk.text.lower()
                    return chunk.value != "put" and not text.startswith("there")
                if chunk.sort == "mark" or (chunk.sort == "joins" and chunk.value != "and") or chunk.sort == "mutual":
                    return False
                if chunk.sort == "joins" and not isinstance(self.chunks[min(index + 1, len(self.chunks) - 1)], Noun):
                    return False
                told = not fresh or (self.separator == "comma_and" and (self.verb == "have" or bool(self.front)))
                having = ("stand", "hang", *(("hold", "carry", "inside") if told else ()))
                if chunk.sort in ("inverses", "participles") and chunk.value not in having:
                    return False
                if chunk.sort == "prepositions" and chunk.value == "with" and not told:
                    return False
            elif isinstance(chunk, (Measured, Stray)):
                return False
            index += 1
        return False

    def _begins_subjects(self) -> bool:
        """Whether a list of new things with a verb of their own begins: ", and a book, a vase and a lamp are on it"."""
        index, parts = self.at, 1
        if self.separator != "comma_and" or not (self.predicate or self.existential):
            return False
        while index + 1 < len(self.chunks) and (after := next_listed(self.chunks, index)):
            index, parts = after, parts + 1
        return parts > 1 and index < len(self.chunks) and is_of_several(self.chunks[index])


def _is_mere_adverb(word: str) -> bool:
    """Whether a word that no list has only says how gracefully or proudly something stands."""
    adverb = word.endswith("ly") and word.isalpha() and len(word) > len("early")
    return adverb and word not in grammar().lists["seen_adverbs"] and not is_person(word)
