"""Prepositions that say something else than where: "of", "for", "as", "without"."""

import math
from dataclasses import replace

from thinkblox.knowledge.seats import places_at
from thinkblox.reading.attach import bind, relation_kind
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Measured, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.heads import is_purpose
from thinkblox.reading.english.naming import SEATERS
from thinkblox.reading.english.negation import Negation
from thinkblox.reading.english.nodes import Node
from thinkblox.reading.english.referents import is_small, last_word
from thinkblox.reading.english.state import LOOKAHEAD

_MOST_AT_ONE = 12
"""Tables for more people than this are for so many together."""
_PAIR = 2
_OWN = ("beds", "desks", "chairs", "storage")
"""What each of several people may have one of."""
_BESIDE_EVERY = ("in_front_of", "behind", "next_to", "near", "by", "opposite", "above")
"""Where one thing can be for every so many others."""
_TOPS = ("tables", "desks", "counters")
"""What "of" says to be full of things that lie on it."""


class Prepositions(Negation):
    """Reads prepositions."""

    def _except(self, whole: Mention, count: int) -> None:
        """Set so many apart of which something is not so."""
        raise NotImplementedError

    def _unlook(self, part: Mention, said: Chunk | None) -> None:
        """Take back what was said of all but these."""
        raise NotImplementedError

    def _preposition(self, link: Connector) -> None:
        meant = self._for_each(link)
        if meant is not None:
            self._follow(meant)

    def _follow(self, link: Connector) -> None:
        """Read what a preposition leads to."""
        match link.value:
            case "with":
                self._open("with")
            case "without" | "instead":
                self._exclude_next()
            case "of":
                self._of()
            case "as":
                self._as()
            case "except" | "for" | "among":
                {"except": self._except_next, "for": self._for, "among": self._among}[link.value](link)
            case "in" if isinstance(self.peek(), Measured):
                self._lose_distance(link)
            case _ if not self._is_of_barred(link):
                self._began = self.at - 1
                self._where(self._read_where(link))

    def _for_each(self, link: Connector) -> Connector | None:
        """The preposition as it is meant; None where "a locker for each person" was read with it."""
        if self._leads_with_every(link) or self._gives_one_for_every(link) or self._gives_one_a_row(link):
            return None
        noun = self.peek()
        if link.value == "per" and isinstance(noun, Noun) and noun.kind == "thing" and not (noun.det or noun.many):
            noun.det = "each"
        thing = self._is_for_everyone(link)
        if thing is not None and not self._read_as_place(thing):
            self._one_for_each(thing, link)
            return None
        if thing is not None or self._leads_with_everyone(link):
            return replace(link, value="at")
        return replace(link, value="on") if link.value == "among" and self._is_on_walls() else link

    def _lose_distance(self, link: Connector) -> None:
        """Say of "within 20 cm of the bed" that no relation of ours is as exact; the bed is asked for."""
        noun = self._next_noun(2) if self._is_link(self.peek(1), "prepositions", "of", "from") else None
        end = self.peek()
        if noun is None or end is None:
            return
        self._go_past(noun)
        if noun.kind == "thing":
            self.anchors(noun, [])
        self._lose(link.start, noun.end)

    def _is_for_everyone(self, link: Connector) -> Mention | None:
        """What there is one of "for each person"; None where no such thing was just named."""
        noun, node = self._next_noun(), self.frontier[-1] if self.frontier else None
        each = noun is not None and noun.kind == "people" and (noun.each or link.value == "per")
        return node.thing if each and link.value in ("for", "per") and node is not None and not node.known else None

    def _gives_one_for_every(self, link: Connector) -> bool:
        """Read "one bench for every two lockers": one for so many of what was named; it is near them."""
        noun, node = self._next_noun(), self.frontier[-1] if self.frontier else None
        thing = node.thing if node is not None and not node.known else None
        if noun is None or noun.kind != "thing" or thing is None:
            return False
        beside = noun.counted and noun.text.lower().startswith("every ") and link.value in _BESIDE_EVERY
        if link.value not in ("for", "per") and not beside:
            return False
        every = noun.every if noun.counted else noun.count if link.text.lower().endswith("every") else None
        lying = [b for b in self.draft.bonds_of(thing) if b.kind in ("on", "inside")]
        told = bool(lying) and not any(b.each for b in lying)
        one = noun.count is None and not noun.every and noun.det in ("each", "")
        placed = link.value == "per" and one and (told or self._is_placed_after(noun))
        every = every or (1 if placed else None)
        if not every or (every < _PAIR and not placed):
            return False
        whole = self.referents.named(replace(noun, every=0, det="the", count=None), besides=[thing])
        whole = whole or (next(iter(self._seats()), None) if noun.word in grammar().lists["seats"] else None)
        self._go_past(noun)
        count = self.referents.total(whole) if whole is not None and whole is not thing else 0
        if whole is None or not count or count % every:
            self._lose(link.start, noun.end)
            return True
        self._spend(noun)
        self.numbers.add(every)
        for one in (thing, *(self._listed_with(thing) if placed else ())):
            one.count, one.per = (one.count or 1) * (count // every), []
        self.draft.bonds = [b for b in self.draft.bonds if b.subject is not thing or whole not in b.anchors]
        if not placed and not any(b.kind == "on" for b in self.draft.bonds_of(thing)):
            tables = self._tables_of([whole]) if is_small(thing) else []
            near = Bond(relation_kind(link.value) if beside else "near", thing, (whole,), implied=not beside)
            bind(self.draft, Bond("on", thing, tuple(tables)) if tables else near)
        return True

    def _gives_one_a_row(self, link: Connector) -> bool:
        """Read "one printer per row" as so many as there are rows; where "in each row" they are is not kept."""
        row, node = self._next_noun(), self.frontier[-1] if self.frontier else None
        thing = node.thing if node is not None and not node.known else None
        within = row is not None and link.value == "in" and row.det in ("each", "every")
        if not (link.value in ("for", "per") or within) or row is None or not row.rows or thing is None:
            return False
        rows = next((t.rows for t in reversed(self.draft.things) if t.rows > 1 and t is not thing), 0)
        rows = rows or next((b.rows for b in reversed(self.draft.bonds) if b.rows > 1 and b.subject is not thing), 0)
        if not rows:
            return False
        self._spend(row)
        self._go_past(row)
        if within:
            self._lose(link.start, row.end)
        thing.count = (thing.count or 1) * rows
        thing.plural = thing.count > 1
        return True

    def _leads_with_every(self, link: Connector) -> bool:
        """Go back to read "for every two stools a bottle" as "a bottle for every two stools"."""
        every, at = self._next_noun(), self.at + 1
        begins = bool(self.separator) or not self.frontier
        if link.value not in ("for", "per") or every is None or every.kind != "thing" or not begins:
            return False
        if not (every.every and every.counted) and not (link.text.lower().endswith("every") and every.many):
            return False
        while at < len(self.chunks) and (
            self._is_link(self.chunks[at], "mark", "comma") or self._is_link(self.chunks[at], "verbs", "be", "stand")
        ):
            at += 1
        thing = self.chunks[at] if at < len(self.chunks) else None
        if not isinstance(thing, Noun) or thing.kind != "thing" or thing.definite:
            return False
        self.at -= 1
        self.chunks[self.at : at + 1] = [thing, link, every]
        return True

    def _listed_with(self, thing: Mention) -> list[Mention]:
        """What is in the same place, one by one, as what there is one of for each: "a bowl and a spoon per stool"."""
        frame = self.frontier[-1].frame
        where = {(b.kind, b.anchors) for b in self.draft.bonds_of(thing)}
        others = [m for m in (frame.members[frame.begun :] if frame is not None else ()) if m is not thing]
        there = [m for m in others if where & {(b.kind, b.anchors) for b in self.draft.bonds_of(m)}]
        return [m for m in there if m.count == 1 and not m.many] if len(there) == len(others) else []

    def _is_placed_after(self, noun: Noun) -> bool:
        """Whether it is told where what there is one of for each is: "one apron per wheel hanging on the wall"."""
        at = self.chunks.index(noun, self.at) + 1 - self.at
        at += self._is_link(self.peek(at), "participles")
        place = self._next_noun(at + 1)
        return self._is_link(self.peek(at), "prepositions") and place is not None and place.kind == "place"

    def _leads_with_everyone(self, link: Connector) -> bool:
        """Whether "for each person" begins what then is at every seat that was named: "for each person: a plate"."""
        noun = self._next_noun()
        if noun is None or noun.kind != "people" or not (noun.each or link.value == "per") or self.draft.people:
            return False
        if link.value not in ("for", "per") or self.frontier or not self._seats():
            return False
        ahead = (c for c in self.chunks[self.at : self.at + LOOKAHEAD] if isinstance(c, Noun) and c is not noun)
        first = next(ahead, None)
        if first is None or first.kind != "thing" or not self._belongs(first.value, "small"):
            return False
        noun.kind, noun.value, noun.det, noun.named = "thing", "seat", "each", False
        return True

    def _read_as_place(self, thing: Mention) -> bool:
        """Read the person as a seat that was named, who has a plate there, or as a desk, at which is the chair."""
        noun, small = self._next_noun(), is_small(thing)
        if noun is None or (self.draft.people and not small):
            return False
        if small:
            places = self._seats()
            told = sum(self.referents.total(place) for place in places)
            places = [] if self.draft.people and told != self.draft.people else places
        else:
            seat = self.habits.is_in(thing.noun, "chairs")
            places = [t for t in self.draft.things if seat and self.habits.is_in(t.noun, "desks") and t.many]
        if not places:
            return False
        value = "seat" if small else places[-1].noun
        noun.kind, noun.value, noun.det, noun.named = "thing", value, "each", False
        return True

    def _one_for_each(self, thing: Mention, link: Connector) -> None:
        """Let there be one for each of the people, and of what is listed with it and people have one of as well."""
        noun, frame = self._next_noun(), self.frontier[-1].frame
        if noun is None:
            return
        self._go_past(noun)
        if not self.draft.people:
            self._lose(link.start, noun.end)
            return
        members = frame.members[frame.begun :] if frame is not None else [thing]
        places = any(self.habits.is_in(member.noun, "desks", "beds") for member in members)
        for member in reversed(members):
            small = is_small(member) or self.habits.is_in(member.noun, "lamps")
            own = self.habits.is_in(member.noun, *_OWN) or (small and places)
            if member is not thing and (member.many or not own):
                break
            member.count = (member.count or 1) * self.draft.people

    def _except_next(self, link: Connector) -> None:
        noun = self._next_noun()
        if self._is_anything_else(noun):
            self.front, self.frontier, self.excluding = [], [], True
            return
        told = noun is not None and noun.kind in ("number", "pronoun") and self._is_link(self.peek(1), "prepositions")
        known = noun is not None and noun.kind == "thing" and noun.definite and self.referents.named(noun) is not None
        if known and noun is not None:
            self._spend(noun)
        place = noun is not None and noun.kind == "place" and noun.det == "the"
        if noun is not None and (known or place or (told and not noun.of_known)):
            self._lose_rest(link.start, noun.end)
            if self._is_link(self.peek(), "mark", "comma") and self._is_link(self.peek(1), "joins", "which"):
                self.at += 1
                self._lose_rest(self.chunks[self.at].start, self.chunks[self.at].end)
        elif not self._excepted_of_subject(noun) and not self._all_but():
            self.excepting, self.negating, self.excluding = True, False, False

    def _is_anything_else(self, noun: Noun | None) -> bool:
        """Whether what comes is all that is not to be there: "anything on the walls is fine except mirrors"."""
        if noun is None or noun.kind != "thing" or noun.definite:
            return False
        said = (chunk for chunk in self.chunks[self._clause_start() : self.at] if isinstance(chunk, Noun))
        return any(chunk.text.lower() in ("anything", "everything", "whatever") for chunk in said)

    def _excepted_of_subject(self, noun: Noun | None) -> bool:
        """Take "every bench has a scale except the last one" for so many of the benches, of which that is not so."""
        node = self.subject if self.predicate else None
        if node is None and self.frontier and isinstance(self._before(), Adjective):
            node = self.frontier[-1]
        whole = node.thing if node is not None else None
        if noun is None or whole is None or noun.kind not in ("number", "pronoun") or noun.of_known:
            return False
        count = noun.count or 1
        if (whole.count or 0) <= count:
            return False
        said = self._before()
        self._go_past(noun)
        self._except(whole, count)
        part = self.frontier[-1].things[-1]
        self._unlook(part, said)
        if noun.ordinal or noun.side:
            self.ordinals.setdefault(whole, {})[noun.ordinal] = part
        return True

    def _bar(self, noun: Noun) -> Noun | None:
        """Exclude a thing; or the phrase as one for things that are there, of which something is denied.

        What is denied of things that nobody named, or of what they have, is not understood.
        """
        link = self._before()
        lacks = isinstance(link, Connector) and link.value == "without" and link.text.lower().startswith("with")
        if lacks and self.frontier and self._is_link(self.peek(), "verbs"):
            self._exclude(noun)
            self.excluding = False
            return None
        if not self._denies(noun):
            self._exclude(noun)
            return None
        several = replace(noun, det="none", plural=True)
        self.excluding = False
        owning = self._is_link(self.peek(), "verbs", "have", "hold", "carry", "share")
        if not owning and self.referents.named(several) is not None:
            if self._is_link(self.peek(), "verbs"):
                self._begin()
            return several
        self._spend(noun)
        self._lose_rest(noun.start, noun.end)
        return None

    def _among(self, link: Connector) -> None:
        """Go past "throughout the room", which nobody sees to."""
        if (noun := self._next_noun()) is not None and noun.kind in ("room", "abstract", "place"):
            self._go_past(noun)
            if self.frontier and noun.kind != "abstract":
                self._lose(link.start, noun.end)

    def _is_on_walls(self) -> bool:
        """Whether "all over the walls" says where things hang."""
        noun = self._next_noun()
        return noun is not None and noun.kind == "place" and "wall" in noun.value

    def _of(self) -> None:
        """Read "shelves of bottles", "a vase of tulips", "the drawers of the cabinet"."""
        if self._is_link(self.peek(), "joins", "which") and isinstance(self.peek(1), Noun):
            self.at += 1
            return
        noun = self._next_noun()
        if noun is None:
            return
        if noun.kind == "room" and noun.det in ("this", "my") and self._is_for_room(noun):
            self._spend(noun)
            self._go_past(noun)
            return
        if not self.frontier and not self.clause.members and noun.kind == "thing":
            known, _ = self.anchors(noun, [])
            self.whole = known[0] if known else None
            self._spend(noun)
            self._go_past(noun)
            return
        head = self.frontier[-1].thing if self.frontier else None
        if noun.kind != "thing" or head is None:
            if noun.kind == "abstract":
                self._hold_matter(noun)
            self._of_no_thing(noun)
            return
        self._of_thing(noun, head)

    def _of_thing(self, noun: Noun, head: Mention) -> None:
        """Say of a thing what it is made or full of, or to what it belongs."""
        if self._is_of_material(noun, head) or self._is_made_of_others(noun, head):
            return
        if carried := self._carried_by(head, noun):
            noun.plural |= noun.count is None and not noun.text.lower().endswith("s")
            self._open(carried)
            if self.pending is not None:
                self.pending.contents = True
            return
        if noun.definite and not is_small(head):
            self._spend(noun)
            before = self._before()
            each = isinstance(before, Noun) and before.each
            self._go_past(noun)
            if before is not None and (each or self.referents.named(noun) is None):
                self._lose(before.start if each else noun.start, noun.end)
            return
        self._go_past(noun)
        self._spend(noun)
        head.text = f"{head.text} of {noun.text}"
        if self._holds_things(head) and noun.plural:
            head.unshown.append(f"of {noun.text}")
        if not is_small(head) and self.habits.is_in(head.noun, "shelves", *_TOPS):
            self._lose(noun.start, noun.end)

    def _is_of_material(self, noun: Noun, head: Mention) -> bool:
        """Take "a table of dark glass" for a glass table."""
        plain = noun.material and not (noun.det or noun.plural or noun.count is not None)
        if plain:
            head.attributes.append(noun.material)
            head.unshown += noun.unshown
            self._spend(noun)
            self._go_past(noun)
        return bool(plain)

    def _is_made_of_others(self, noun: Noun, head: Mention) -> bool:
        """Note what we show of no thing: "a table made of crates"."""
        said = self._before()
        made = isinstance(said, Connector) and said.sort == "fillers" and said.text.lower().split()[-1] == "made"
        if made:
            head.unshown.append(f"made of {noun.text.lower()}")
            self._spend(noun)
            self._go_past(noun)
        return made

    def _carried_by(self, head: Mention, noun: Noun) -> str:
        """How what "shelves of bottles", "tables of books" name is carried; empty where it is no thing to be made."""
        several = noun.plural or noun.count is not None or (not noun.det and noun.text.lower().endswith("s"))
        if not several and (noun.det or not noun.named):
            return ""
        if last_word(head) in grammar().lists["boxes"] or self.habits.is_in(head.noun, "shelves"):
            return "inside"
        if self._holds_things(head) and several and noun.named:
            return "inside"
        return "on" if self.habits.is_in(head.noun, *_TOPS) and not noun.definite else ""

    def _holds_things(self, head: Mention) -> bool:
        """Whether what it is full of are things of their own, as pens in a mug; a vase of tulips is one thing."""
        word = last_word(head)
        return word in grammar().lists["containers"] and word not in grammar().lists["vases"]

    def _of_no_thing(self, noun: Noun) -> None:
        """Go past "of the room", "of four people"; "every pew of the left column" is not understood."""
        self._spend(noun)
        before = self._before()
        each = isinstance(before, Noun) and before.each
        self._go_past(noun)
        if each and noun.kind in ("number", "part", "abstract") and noun.det in ("the", "my"):
            self._lose(before.start if before is not None else noun.start, noun.end)
        thing = self.frontier[-1].thing if self.frontier else None
        if noun.kind == "number" and noun.count and thing is not None and self.habits.is_in(thing.noun, *_TOPS):
            self._serve(thing, noun.count)
        elif noun.kind == "people" and noun.count:
            self._people(noun)

    def _is_for_room(self, noun: Noun) -> bool:
        """Take the room of "for my bedroom I'd like a bed", "seven desks for an office", where none was told."""
        if noun.kind != "room" or noun.value == "room" or noun.many or self.draft.room not in ("", "room"):
            return False
        self.draft.room = ""
        self._room(noun)
        return True

    def _for(self, link: Connector) -> None:
        noun = self._next_noun()
        if noun is None:
            self.at += isinstance(self.peek(), Adjective) and isinstance(self._before(), Noun)
            return
        thing = self.frontier[-1].thing if self.frontier else None
        awaited = [a for f in self.front[-1:] for a in f.anchors if isinstance(a, Mention)]
        thing = awaited[0] if awaited and not self.frontier else thing
        if self._is_purpose(noun) or self._is_for_room(noun):
            self._spend(noun)
            self._go_past(noun)
            return
        if noun.kind in ("people", "number") and noun.count and thing is not None:
            if thing.seats and thing.seats != noun.count:
                self._lose(link.start, noun.end)
            else:
                self._serve(thing, noun.count)
            self._go_past(noun)
        elif noun.kind in ("people", "number") and (noun.count or noun.kind == "people") and not self.draft.things:
            self._go_past(noun)
            self._for_people(noun)
        elif noun.kind == "thing" and noun.word in grammar().lists["animals"]:
            self._spend(noun)
            self._go_past(noun)
        elif noun.kind == "thing" and thing is not None and self._is_contents(noun):
            self._open("with" if noun.det == "the" else "hold")
        elif noun.kind == "thing" and not self.referents.named(noun) and (noun.named or noun.det == "the"):
            found = self._new(noun)
            self.frontier = [Node([found], self.clause)]
            self.clause.members.append(found)
            self._go_past(noun)
            self.leaving = False
        else:
            self._spend(noun)
            self._go_past(noun)
            if noun.kind == "thing" and thing is not None and noun.definite:
                self._lose(link.start, noun.end)

    def _is_purpose(self, noun: Noun) -> bool:
        """Whether it only says what something is for: "a bin for paper", "a place for umbrellas"."""
        before = self._before()
        doing = noun.text.lower().split()[0]
        if noun.kind == "thing" and doing.endswith("ing") and is_purpose(doing):
            return not noun.det and isinstance(before, Noun) and before.kind == "room"
        matter = not (noun.det or noun.plural) and noun.count is None and noun.text.lower()[-1:] != "s"
        matter |= noun.text.lower() == noun.material
        if noun.kind != "thing" or not isinstance(before, Noun) or noun.definite:
            return False
        if before.kind in ("room", "abstract") and self.draft.things and noun.plural and not noun.count:
            self._lose(before.start, noun.end)
            return True
        return before.kind in ("thing", "pronoun", "number") and matter and self.referents.named(noun) is None

    def _serve(self, thing: Mention, people: int) -> None:
        """Let it be for so many: a table has as many places, and there are enough of what each has one of."""
        if self._are_places(thing):
            thing.count = math.ceil(people / places_at(thing.noun))
        elif thing.count is None and thing.plural and self.habits.is_in(thing.noun, "covers", "own_bed"):
            thing.count = people
        elif self.habits.is_in(thing.noun, "lounges") and not thing.many and f"for-{people}" in SEATERS:
            thing.attributes.append(SEATERS[f"for-{people}"])
            self.numbers.add(people)
        elif self.habits.is_in(thing.noun, "tables", "desks"):
            together = thing.plural and people > _MOST_AT_ONE
            if together and thing.count is None:
                thing.count = math.ceil(people / places_at(thing.noun))
            thing.seats = math.ceil(people / (thing.count or 1)) if together else people
        elif thing.count is None and thing.plural:
            self.draft.people = self.draft.people or people

    def _are_places(self, thing: Mention) -> bool:
        """Whether it is seats, or what people work at, of which nobody says how many: "chairs for eight people"."""
        bare = thing.count is None and thing.plural
        return bare and self.habits.is_in(thing.noun, "seats", "worked_at")

    def _is_contents(self, noun: Noun) -> bool:
        """Whether it is what something is for and holds: "a mug for pens"."""
        several = noun.count or noun.plural or (not noun.det and noun.text.lower().endswith("s"))
        own = noun.det == "my" or (noun.det == "the" and noun.plural and self._belongs(noun.value, "small"))
        return (not noun.definite or (own and self.referents.named(noun) is None)) and bool(several)

    def _as(self) -> None:
        noun = self._next_noun()
        thing = self.frontier[-1].thing if self.frontier else None
        if noun is not None and thing is not None and noun.word in grammar().lists["serving"]:
            self.tables.add(thing)
        if noun is not None and noun.kind in ("thing", "room", "abstract") and noun.count in (None, 1):
            self._spend(noun)
            self._go_past(noun)
