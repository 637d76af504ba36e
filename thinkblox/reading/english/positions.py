"""Where things are: prepositions with what they are to."""

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile

from thinkblox.assets.mounting import WALL_MOUNTED
from thinkblox.reading.attach import bind, relation_kind
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.chunks import Connector, Measured, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.meaning import ROOM_SIDES
from thinkblox.reading.english.nodes import Awaited, Listed, Meaning, Node, Where
from thinkblox.reading.english.parts import SIDES
from thinkblox.reading.english.referents import is_small
from thinkblox.reading.english.state import LOOKAHEAD
from thinkblox.reading.english.subjects import Subjects

_WITHIN = ("in", "at", "on", "to", "from", "of", "for", "as", "with", "inside")
"""Prepositions that say no more before a room than that things are there."""
_ON_WALL = ("along", "against", "around", "at", "by", "next_to")
"""Prepositions that say where on a wall things hang."""
_FRONTS = 20
"""Most relations that wait for their subject."""
_AROUND_IT = ("next_to", "near", "by", "in_front_of", "behind", "opposite", "to", "at", "left_of", "right_of", "far")
"""Prepositions before a pronoun for what the clause before was about."""
_FACED = ("facing", "opposite", "around", "on", "on_top", "in")
"""Relations that all of several have to a single thing."""
_SHARED_BY_BOTH = (*_FACED, "next_to", "near", "by", "in_front_of", "behind", "at")
"""Relations that two have to a single thing."""
_COLOURS = {"colour", "color"}
"""What several are in that are told apart right after: "six bins in two colours, three red and three blue"."""
_OTHER_SIDE = {"left": "right", "right": "left", "front": "back", "back": "front"}
_AT_SEATS = ("at", "in_front_of", "for", "per", "on")
"""Prepositions before the places at a table."""
_TOPS = ("tables", "desks", "counters", "worktops")
"""What has two ends at which things lie."""
_SIDEWARD = ("left_of", "right_of", "next_to", "in_front_of", "behind", "opposite")
"""Relations after which "on the other side" is one of the same thing."""
_UPON = ("on", "on_top", "in", "inside")


class Positions(Subjects):
    """Reads where things are."""

    def _read_where(self, link: Connector) -> Where:
        """The preposition with what it is to; goes past it."""
        index = self._skip_fillers(self.at)
        chunk = self.chunks[index] if index < len(self.chunks) else None
        where = Where(link.value, None, negated=self.negating, start=link.start, text=link.text)
        which = isinstance(chunk, Connector) and chunk.value == "which" and chunk.text.lower() in ("which", "whom")
        if which and self._is_link(chunk, "joins"):
            self.at = index + 1
            return self._which(where)
        if not isinstance(chunk, Noun) or (chunk.kind == "thing" and chunk.det == "no"):
            return where
        if chunk.every and chunk.counted and not self._are_many_named(chunk):
            several = replace(chunk, det="", every=0, counted=False, count=chunk.every, plural=True)
            self.chunks[index], self.at = several, index
            where.noun = Noun("pronoun", "each", chunk.start, chunk.start + 1, "each")
            return where
        self._as_seat(chunk)
        if chunk.kind == "thing" and (chunk.det == "my" or self._is_within_owner(chunk)):
            chunk = self._as_owned(chunk, index)
        where.noun = chunk
        self.at = index + 1
        self._same_wall(where, chunk)
        if chunk.kind in ("part", "place", "abstract") and self._is_link(self.peek(), "prepositions", "of"):
            where.whole = self._next_noun(1)
            if where.whole is not None:
                self._go_past(where.whole)
                self._note_room(where.whole, negated=where.negated)
        if link.value == "between":
            where.second = self._second(chunk)
        if chunk.kind == "part" and chunk.value in _OTHER_SIDE and chunk.det == "the" and where.whole is None:
            where.whole = self._whole_of_other_side(chunk)
        return where

    def _as_owned(self, noun: Noun, index: int) -> Noun:
        """Take "(each on) its own table" for a new one, and "its shelves" for a part."""
        if "own" in noun.text.lower().split()[:2]:
            self.chunks[index] = owned = replace(noun, det="a")
            return owned
        if noun.text.lower().rpartition(" ")[2] in ("shelves", "drawers"):
            self._spend(noun)
            return replace(noun, kind="part", value="inside")
        return noun

    def _are_many_named(self, noun: Noun) -> bool:
        """Whether several were named of which "every three seats" are some."""
        whole = self._named_or_seats(noun)
        return whole is not None and whole.many

    def _is_within_owner(self, noun: Noun) -> bool:
        """Whether "the shelves" are those of what was just named: "a shoe rack with shoes on the shelves"."""
        owner = next((n.frame.head for n in reversed(self.frontier) if n.frame is not None and n.frame.head), None)
        parts = noun.text.lower().rpartition(" ")[2] in ("shelves", "drawers")
        if owner is None or owner.thing is None or noun.det != "the" or not parts:
            return False
        return self.referents.named(noun) is None and self._contains(owner.thing)

    def _same_wall(self, where: Where, wall: Noun) -> None:
        """Read "on the same wall as the bed": the wall that the bed was said to be on."""
        noun = self._next_noun(1) if self._is_link(self.peek(), "prepositions", "as") else None
        if noun is None or noun.kind != "thing" or wall.kind != "place" or "same" not in wall.text.lower().split():
            return
        thing = self.referents.named(noun)
        walls = [b.anchors[0] for b in self.draft.bonds_of(thing)] if thing is not None else []
        told = next((w for w in walls if isinstance(w, str) and w.endswith("_wall")), "")
        if told:
            self._spend(noun)
            self._go_past(noun)
            where.noun = replace(wall, value=told, text="the wall")

    def _whole_of_other_side(self, side: Noun) -> Noun | None:
        """The tank of "one on the left and one on the right of the tank"."""
        at = 1 if self._is_link(self.peek(), "mark", "comma") else 0
        at += 1 if self._is_link(self.peek(at), "joins", "and") else 0
        other, link, part = self.peek(at), self.peek(at + 1), self.peek(at + 2)
        parted = isinstance(other, Noun) and other.kind in ("number", "pronoun") and self._is_link(link, "prepositions")
        if not at or not parted or not isinstance(part, Noun) or part.value != _OTHER_SIDE[side.value]:
            return None
        if part.text.lower().endswith("of it"):
            return Noun("pronoun", "it", side.start, side.end, "it")
        return self._next_noun(at + 4) if self._is_link(self.peek(at + 3), "prepositions", "of") else None

    def _second(self, first: Noun) -> Noun | None:
        """The other of "between A and B"; goes past it."""
        if first.kind == "pronoun" or not self._is_link(self.peek(), "joins", "and"):
            return None
        second = self._next_noun(1)
        many = first.many or first.rows != 0
        if many and not (second is not None and second.definite and self._ends_after(second)):
            return None
        if second is None or second.kind not in ("thing", "place", "pronoun"):
            return None
        if first.kind == "number" and first.ordinal and second.kind == "thing":
            first.kind, first.value, first.named = "thing", second.value, second.named
            first.text = f"{first.text} {second.word}"
        self._go_past(second)
        return second

    def _stand(self, word: str) -> None:
        """Read what follows as what the subject stands to as `word` says."""
        said, self._began = self._before(0), self.at - 1
        start, text = (said.start, said.text) if isinstance(said, Connector) else (self.at, "")
        self._where(self._read_where(Connector("prepositions", word, start, start, text)))

    def _hang_from(self) -> None:
        """Read "hanging from the beam", which is next to it, and "hung along the wall", which is on it."""
        noun = self._next_noun(1) if self._is_link(self.peek(), "prepositions", "from") else None
        if noun is not None and noun.kind == "thing":
            self.at += 1
            self._stand("on" if self.habits.is_in(noun.value, "seats", "chairs") else "next_to")
            return
        link, wall = self.peek(), self._next_noun(1)
        along = isinstance(link, Connector) and self._is_link(link, "prepositions", *_ON_WALL)
        if along and isinstance(link, Connector) and wall is not None and wall.kind == "place" and "wall" in wall.value:
            self.at += 1
            self._began = self.at - 1
            self._where(self._read_where(replace(link, value="on")))

    def _which(self, where: Where) -> Where:
        """Read "A counter, on which a monitor stands": a clause of its own about what was just named."""
        outer = [n for n in self.frontier if n.things and n.frame is not None and n.frame.head is None]
        named = (outer or [n for n in self.frontier if n.things] or ([self.subject] if self.subject else []))[-1:]
        if not named and (anchors := self._hold_front()) is not None:
            named = [anchors]
        carrier = self._carrier_before(2, named[0].things if named else []) if where.word in _UPON else None
        if named:
            self.referents.topics.append(named[0].things[-1])
            self.outer = named[0]
            self.frontier, self.clause, self.subject, self.predicate = [], Listed(), None, False
            self.front, self.separator = [], ""
        where.noun = Noun("pronoun", "it", self.at, self.at, "which")
        if carrier is not None:
            where.noun = replace(carrier, start=self.at, end=self.at, det="the", count=None, among=(carrier.start,))
        return where

    def _carrier_before(self, back: int, heads: Sequence[Mention]) -> Noun | None:
        """The table of "above the table, on which stand two candlesticks", where it is named right before.

        What the clause is about is meant instead where that carries things, and a comma comes after the other.
        """
        comma = self._is_link(self._before(back), "mark", "comma")
        before = self._before(back + comma)
        things = self.meant.get(before.start, []) if isinstance(before, Noun) and before.kind == "thing" else []
        if not isinstance(before, Noun) or len(things) != 1 or things[0].many:
            return None
        if things[0] not in heads and (not self._may_carry(things[0]) or (comma and any(map(self._may_carry, heads)))):
            return None
        return before

    def _may_carry(self, thing: Mention) -> bool:
        """Whether things usually lie on it or in it."""
        return self._belongs(thing.noun, "surfaces") or self._has_shelves(thing)

    def _where(self, where: Where) -> None:
        """Say where something is; a position that changes nothing is not understood."""
        if where.noun is not None and where.noun.kind == "place":
            if where.noun.det == "my" and where.noun.word == "side":
                self._lose_where(where)
                return
            self._note_place(where.noun)
        before, self.laid = self._state_of_reading(), False
        self._say_where(where)
        if self._state_of_reading() == before and not self.laid:
            self._lose_where(where)

    def _state_of_reading(self) -> tuple[object, ...]:
        """What a position changes: bonds, counts, what waits for its subject, exclusions, openings, the room."""
        draft = self.draft
        bonds = [(b, b.kind, b.each, b.spread, b.anchors) for b in draft.bonds[-_FRONTS:]]
        counts = [(t.count, len(t.per), len(t.unshown)) for t in draft.things[-_FRONTS:]]
        said = (len(draft.bonds), len(draft.things), len(draft.unknown), len(draft.excluded), draft.room)
        return (*said, bonds, counts, list(self.front), [(g.kind, g.wall) for g in draft.openings])

    def _say_where(self, where: Where) -> None:
        """Bind what was named, or what comes, to where it is said to be."""
        self.negating = False
        if where.noun is None and (where.text.lower() in ("in", "into") or self._is_one_of_two_places(where)):
            return
        self._reword(where)
        where.paired = self._is_joined_before(self._began)
        if self._is_side_of_wall(where) or self._is_side_of_top(where) or self._lays_places(where):
            return
        if where.word == "turned":
            self._turned_to(where)
            return
        if self._stands_on_part(where) or self._seats_people(where) or self._shines_from(where):
            return
        if self._is_side_of_owner(where):
            self._lose_where(where)
            return
        noun = where.noun
        if noun is not None and (self._is_inside_label(where, noun) or self._is_elsewhere(where, noun)):
            return
        if not self._is_of_opening(where):
            self._place_there(where)

    def _place_there(self, where: Where) -> None:
        """Say where what was named is, or what comes."""
        if self._qualifies_front():
            anchors = [a for a in self.front[-1].anchors if isinstance(a, Mention)]
            self.front[-1].used = True
            self._place_node(Node(anchors, self.clause, known=True), where)
            self.frontier = []
            return
        goes_on = where.word == "facing" and self.separator == "and" and bool(self.frontier)
        goes_on &= not isinstance(self.peek(), Noun)
        fronted = not goes_on and self._is_fronted()
        node = None if fronted else self._subject_of(where)
        if node is not None:
            self._place_node(node, where)
        elif fronted or where.noun is not None:
            self._set_front(where)

    def _is_one_of_two_places(self, where: Where) -> bool:
        """Say of "pots on and under it" that nobody knows which are where."""
        noun = self.peek(2)
        joined = self._is_link(self.peek(), "joins", "and") and self._is_link(self.peek(1), "prepositions")
        if not joined or not isinstance(noun, Noun) or not where.text:
            return False
        self._go_past(noun)
        self._lose(where.start, noun.end)
        return True

    def _lays_places(self, where: Where) -> bool:
        """Read "a table for four, at every seat a plate", where no seats are named, as so many plates on the table."""
        noun, begins = where.noun, not self.frontier or bool(self.separator)
        if noun is None or not noun.each or noun.word not in grammar().lists["seats"] or where.word not in _AT_SEATS:
            return False
        table = next((t for t in reversed(self.draft.things) if t.seats), None)
        if table is None or self._seats():
            return False
        self._spend(noun)
        if not begins:
            return self._lays_at_places(where, table)
        self._begin()
        self.clause = Listed(None, "list", times=table.seats * (table.count or 1), each=True)
        self.front = [Awaited(Where("on", None), Meaning("on", (table,), told=True))]
        self.at += self._is_link(self.peek(), "mark", "comma", "colon")
        self.laid = True
        return True

    def _lays_at_places(self, where: Where, table: Mention) -> bool:
        """Lay as many as a table seats of what was named: "a table for four with a plate and a cup at each place"."""
        node = self._subject_of(where)
        if node is None:
            return False
        members = node.frame.members[node.frame.begun :] if node.frame is not None else []
        before = members[: members.index(node.things[-1])] if node.things[-1] in members else []
        laid = takewhile(lambda thing: self._is_one_laid(thing, table), reversed(before))
        things = [thing for thing in dict.fromkeys([*laid, *node.things]) if is_small(thing)]
        for thing in things:
            lying = [b for b in self.draft.bonds_of(thing) if b.kind == "on" and table in b.anchors]
            each = any(b.each for b in lying)
            thing.count = (thing.count or 1) * table.seats * (1 if each else table.count or 1)
            self.multiplied.add(thing)
            if not lying:
                bind(self.draft, Bond("on", thing, (table,)))
        self.laid |= bool(things)
        return bool(things)

    def _is_one_laid(self, thing: Mention, table: Mention) -> bool:
        """Whether it is one thing of which nothing is told but on which table it lies."""
        placed = all(b.kind == "on" and table in b.anchors for b in self.draft.bonds_of(thing))
        return placed and thing.count == 1 and is_small(thing) and not self.habits.is_in(thing.noun, "plants", "lamps")

    def _is_side_of_top(self, where: Where) -> bool:
        """Keep in mind at which end of a desk something lies: "a lamp on the left and a phone on the right"."""
        part = where.noun
        side = (
            part is not None and part.kind == "part" and part.value in ("left", "right") and where.word in ("on", "at")
        )
        node = (
            self._subject_of(where)
            if side and part is not None and part.det in ("the", "my") and not part.owner
            else None
        )
        thing = node.thing if node is not None and len(node.things) == 1 else None
        if thing is None or part is None or thing.many or where.negated or self._is_fronted():
            return False
        carried = [a for b in self.draft.bonds_of(thing) if b.kind == "on" for a in b.anchors]
        fronted = [a for f in self.front if f.kind == "on" for a in f.anchors if is_small(thing)]
        carrier = next(iter((*carried, *fronted)), None)
        told = self.referents.named(where.whole) if where.whole is not None else carrier
        if not isinstance(carrier, Mention) or told is not carrier or not self.habits.is_in(carrier.noun, *_TOPS):
            return False
        if not carried:
            bind(self.draft, Bond("on", thing, (carrier,)))
        if where.whole is not None:
            self._spend(where.whole)
        self.at_ends.append((thing, carrier, where))
        self.laid = True
        return True

    def _settle_ends(self) -> None:
        """Let what lies at an end of something be at that side of its top."""
        for thing, carrier, where in self.at_ends:
            if where.noun is not None and {thing, carrier} <= set(self.draft.things):
                for lying in (b for b in self.draft.bonds_of(thing) if b.kind == "on"):
                    lying.implied = False
                bind(self.draft, Bond(relation_kind(SIDES[where.noun.value]), thing, (carrier,)))
            else:
                self._lose_where(where)

    def _is_side_of_wall(self, where: Where) -> bool:
        """Take "on the wall to the right" for the right wall."""
        before, noun = self.chunks[self._began - 1] if self._began else None, where.noun
        wall = (
            isinstance(before, Noun)
            and before.kind == "place"
            and before.value == "wall"
            and where.word in ("to", "on")
        )
        if not wall or noun is None or noun.kind != "part" or where.whole is not None or noun.det == "my":
            return False
        side = ROOM_SIDES.get(noun.value, "")
        bonds = [b for b in self.draft.bonds[-_FRONTS:] if b.anchors == ("wall",) and b.kind in ("on", "against_wall")]
        if not side or not bonds:
            return False
        bonds[-1].anchors = (side,)
        return True

    def _reword(self, where: Where) -> None:
        """Take "leaning on the wall" or on a bookcase for against it, and "halfway down the room" for in its middle."""
        place = where.noun is not None and where.noun.kind == "place"
        if where.word == "to" and place and self._is_mounted():
            where.word = "on"
        if where.word == "on" and self._is_leaning() and (place or self._stands_thing(where)):
            where.word = "against"
        if where.word == "halfway" and not (place and where.noun is not None and "wall" in where.noun.value):
            where.noun = None

    def _stands_thing(self, where: Where) -> bool:
        """Whether it is said of what stands on the floor where it is to another thing."""
        thing = self.frontier[-1].thing if self.frontier else None
        other = where.noun is not None and where.noun.kind in ("thing", "pronoun", "number")
        return other and thing is not None and not is_small(thing)

    def _turned_to(self, where: Where) -> None:
        """Say that nobody sees to "parallel to the shelf"; the shelf is asked for all the same."""
        noun = where.noun
        if noun is None or noun.kind not in ("thing", "number", "place", "part", "pronoun", "room"):
            self._lose(where.start, where.start + len(where.text.split()))
            return
        self._lose(where.start, (where.whole or noun).end)
        anchors = self.anchors(noun, [])[0] if noun.kind == "thing" else ()
        if anchors:
            self.frontier.append(Node(list(anchors), None, known=noun.definite))

    def _stands_on_part(self, where: Where) -> bool:
        """Note what a thing stands on that is a part of it: "a toolbox on wheels", "a stool on three legs"."""
        noun, thing = where.noun, self.frontier[-1].thing if self.frontier else None
        if where.word != "on" or noun is None or thing is None or noun.kind != "thing" or noun.det:
            return False
        if noun.word not in grammar().lists["props"] or self.referents.named(noun) is not None:
            return False
        thing.unshown.append(f"on {noun.text.lower()}")
        self._spend(noun)
        return True

    def _shines_from(self, where: Where) -> bool:
        """Take the lamps of "soft lighting from two floor lamps" for lamps."""
        noun, said = where.noun, self.chunks[self._began - 1] if self._began else None
        light = isinstance(said, Noun) and said.kind == "abstract"
        if where.word != "from" or noun is None or noun.kind != "thing" or not light or noun.det == "no":
            return False
        if not self.habits.is_in(noun.value, "lamps", "ceiling"):
            return False
        things = list(self.anchors(noun, [])[0])
        self.clause.members += [thing for thing in things if thing not in self.clause.members]
        self.frontier = [Node(things, self.clause)]
        return True

    def _seats_people(self, where: Where) -> bool:
        """Share the people of "a room that seats twelve around an oval table", "eight pupils at four desks" out."""
        noun, said = where.noun, self.chunks[self._began - 1] if self._began else None
        people = isinstance(said, Noun) and said.kind in ("people", "number") and self.draft.people > 0
        if not people or where.word not in ("around", "at") or noun is None or noun.kind != "thing":
            return False
        if noun.definite or self.draft.things or self.front:
            return False
        table = self._new(noun)
        table.seats = table.seats or math.ceil(self.draft.people / (table.count or 1))
        self._take(table, noun)
        return True

    def _is_side_of_owner(self, where: Where) -> bool:
        """Whether "the far side" is rather that of what has the thing: "an island with four stools on the far side"."""
        noun, node = where.noun, self.frontier[-1] if self.frontier else None
        if noun is None or noun.kind != "place" or noun.word != "side" or where.whole is not None:
            return False
        return node is not None and node.frame is not None and node.frame.head is not None

    def _stand_in_rows(self, where: Where, noun: Noun) -> None:
        """Let what was named stand in rows, as many as these have where nobody said how many there are."""
        things = [n for n in (*reversed(self.frontier), self.subject) if n is not None and n.things]
        things = [n for n in things if n.frame is not None or n.things[-1].many] or things
        if things:
            frame = things[0].frame
            of_each = frame is not None and frame.each and frame.head is not None and frame.head.things
            rowed = frame.head if of_each and frame is not None and frame.head is not None else things[0]
            bind(self.draft, Bond("in_rows", rowed.things[-1], rows=max(noun.rows, 0)))
            if noun.count and rowed.things[-1].count is None:
                rowed.things[-1].count = noun.count
        else:
            self._lose_where(where)

    def _is_elsewhere(self, where: Where, noun: Noun) -> bool:
        """Take what follows a preposition without being a thing or place that others could stand to."""
        if noun.kind in ("people", "abstract"):
            self._beyond(where)
            return True
        if noun.kind == "number" and noun.rows and where.word not in ("in", "as", "to", "at"):
            self._lose_where(where)
            return True
        if noun.kind == "number" and noun.rows:
            self._stand_in_rows(where, noun)
            return True
        formation = {noun.word, *noun.text.lower().split()[-1:]} & grammar().lists["formations"]
        if noun.kind in ("thing", "part") and formation and where.word in ("in", "into") and noun.det != "the":
            self._spend(noun)
            self._lose(where.start, noun.end)
            return True
        if noun.kind == "room":
            if (noun.count or 1) > 1 or noun.each or where.word not in _WITHIN:
                self._lose(where.start, noun.end)
            elif self._is_setting(where):
                self.draft.room = ""
                self._room(noun)
                self._go_on_with_room()
            else:
                self._note_size(noun)
            return True
        if where.negated and noun.kind == "thing" and noun.det in ("a", "") and not self.referents.named(noun):
            self._spend(noun)
            self.draft.excluded.add(noun.value)
            return True
        return False

    def _note_room(self, whole: Noun, *, negated: bool) -> None:
        """Keep what is told of the room in which something is."""
        if whole.kind == "room" and not self.draft.room and not negated:
            self._room(whole)
        elif whole.kind == "room":
            self._note_size(whole)

    def _note_size(self, room: Noun) -> None:
        """Keep how large the room is where that is said in passing: "Testbed. A table in a 3 by 3 m room."."""
        if room.size is not None and not self.draft.sizes and room.value in ("room", self.draft.room):
            self.draft.sizes.append(room.size)

    def _is_setting(self, where: Where) -> bool:
        """Whether it says in which room all of it is: "in the clinic there is", "at a small cafe: four tables"."""
        begins = not self.draft.room or (self.draft.room == "room" and not self.draft.things)
        return begins and (where.word == "in" or (where.word == "at" and not where.start))

    def _is_inside_label(self, where: Where, noun: Noun) -> bool:
        """Take what a text begins with for the room: "Inside of a photo booth, 1.1 m x 1.7 m: ..."."""
        begins = where.word == "in" and noun.kind == "thing" and not (noun.many or self.draft.things or self.draft.room)
        sized = self._is_link(self.peek(), "mark") and isinstance(self.peek(1), Measured)
        if not (begins and sized) or self.front:
            return False
        self._spend(noun)
        self._room(replace(noun, kind="room", value="room"))
        return True

    def _is_of_opening(self, where: Where) -> bool:
        """Take where a door or window is, when it was named last."""
        noun = where.noun
        if self.opening is None or self.frontier or noun is None or noun.kind not in ("place", "thing"):
            return False
        if noun.kind == "place":
            if noun.value.endswith("_wall"):
                self.opening.wall = noun.value
            return True
        for thing in self.anchors(noun, [])[0]:
            bind(self.draft, Bond("next_to", thing, (self.opening.kind,)))
        return True

    def _qualifies_front(self) -> bool:
        """Whether it says more of what was just named in front: "on the desk against the wall a laptop"."""
        if not self.front or self.clause.members or self.frontier or self.separator or self.subject is not None:
            return False
        before = self.chunks[self._began - 1] if self._began > 0 else None
        named = isinstance(before, Noun) and before.kind in ("thing", "number", "pronoun")
        named &= not (isinstance(before, Noun) and before.value in ("it", "them"))
        return named and isinstance(self.front[-1].anchors[0], Mention)

    def _beyond(self, where: Where) -> None:
        """Words that say where and mean no place that we know; "for each guest" makes so many of what comes."""
        noun, whole = where.noun, where.whole
        if whole is not None and whole.kind in ("thing", "pronoun") and noun is not None:
            self._lose(where.start, whole.end)
        elif noun is not None and self._is_not_kept(where, noun):
            self._lose(where.start, noun.end)
        if noun is not None and noun.kind == "people" and (noun.each or where.word == "per") and self.draft.people:
            self.frontier, self.subject, self.predicate = [], None, False
            self.clause = Listed(None, "list", times=self.draft.people, each=True)
            self.separator = ""
            if self._is_link(self.peek(), "mark", "comma"):
                self.at += 1

    def _is_not_kept(self, where: Where, noun: Noun) -> bool:
        """Whether it says where something is by people, or by what is no place, so that more is meant than is read."""
        people = noun.kind == "people"
        several = people and (noun.of_known or self._is_to_somebody(where, noun))
        told = several or self._is_telling(noun) or where.word == "between"
        return (bool(self.draft.things) and told) or (people and noun.each and not self.draft.people)

    def _is_to_somebody(self, where: Where, noun: Noun) -> bool:
        """Whether something is said to stand behind or beside those who are in a room, who are none of its things."""
        return where.word in _SIDEWARD and (noun.definite or not noun.det) and not noun.each

    def _is_telling(self, noun: Noun) -> bool:
        """Whether a noun that is no thing says how something is to stand: "at right angles", "in three colours"."""
        words = {noun.text.rpartition(" ")[2].lower(), noun.word}
        parts = self._next_noun(1) if self._is_link(self.peek(), "mark", "comma", "colon", "open", "dash") else None
        if words & _COLOURS and parts is not None and parts.kind == "number" and parts.attributes:
            return False
        return noun.kind == "abstract" and not words.isdisjoint(grammar().lists["telling"])

    def _place_node(self, node: Node, where: Where) -> None:
        subjects = node.things
        where.noun = self._any_of_known(node, where.noun)
        likely = self._likely(node, elided=where.noun is None)
        hung = likely and self.habits.is_in(likely[0].noun, "wallpieces", "screens")
        if where.noun is None and where.word == "opposite" and not hung:
            likely = [m for m in self.clause.members[:1] if m not in subjects and not is_small(m)] + likely
        meaning = self.meanings.of(where, subjects, likely)
        if meaning is None or self._is_elsewhere_named(subjects):
            self._lose_where(where)
        if meaning is None:
            self._ask_all_the_same(where)
            return
        self._mount(subjects, where)
        if where.word in ("in", "inside") and isinstance(holder := meaning.anchors[0], Mention):
            self._call_after_content(holder, subjects[-1].noun)
        partner = self._partner(node, where, meaning)
        if partner is not None:
            self._relate([partner], replace(meaning), negated=where.negated)
        self._relate(subjects, meaning, negated=where.negated)
        if meaning.loose:
            self._lose_where(where)
        if not where.negated:
            self._give_each_its_anchor(node, where, meaning)
            self._go_on_from(node, where, meaning)

    def _any_of_known(self, node: Node, noun: Noun | None) -> Noun | None:
        """The tables that were named for "twelve chairs, every one at a table", where there are not as many."""
        each = node.each or self.each
        if noun is None or not each or noun.kind != "thing" or noun.det != "a" or noun.attributes or noun.unshown:
            return noun
        known = [t for t in self.referents.every(noun) if t not in node.things]
        tables, seats = (sum(map(self.referents.total, things)) for things in (known, node.things))
        return replace(noun, det="the", plural=True) if 1 < tables < seats else noun

    def _ask_all_the_same(self, where: Where) -> None:
        """Ask for what a relation that is not understood is to."""
        noun = where.noun if where.word == "from" and not where.negated else None
        if noun is not None and noun.kind == "thing" and noun.det != "no":
            self.anchors(noun, [])

    def _is_mounted(self) -> bool:
        said = self.chunks[self._began - 1] if self._began else None
        words = said.text.lower().split() if isinstance(said, Connector) else []
        return bool(words) and words[-1] in grammar().lists["mounted"]

    def _mount(self, subjects: list[Mention], where: Where) -> None:
        """Note that what else would stand is "mounted on the wall"."""
        place = where.noun.value if where.noun is not None and where.noun.kind == "place" else ""
        wall = where.word == "on" and "wall" in place
        for subject in subjects if self._is_mounted() and wall and not where.negated else ():
            if self.habits.is_in(subject.noun, "storage"):
                subject.attributes.append(WALL_MOUNTED)

    def _go_on_from(self, node: Node, where: Where, meaning: Meaning) -> None:
        """Let what comes be about the things just placed, or about what they were placed by."""
        subjects = node.things
        if node.frame is None or node.frame.head is None:
            self._keep_in_mind(where, meaning)
        if where.second is not None and where.second.kind == "place":
            opening = Meaning("next_to", (where.second.value.split()[0],))
            self._relate(subjects, opening)
        elif where.second is not None and where.second.kind == "thing" and isinstance(meaning.anchors[0], str):
            self._relate(subjects, Meaning("next_to", tuple(self.anchors(where.second, subjects)[0])))
        if meaning.kind in ("on", "inside") and not meaning.told:
            self._place_carrier(subjects, meaning)
        if node in self.frontier:
            del self.frontier[self.frontier.index(node) + 1 :]
        else:
            self.frontier.append(node)
        if node.frame is not None and node.frame.head is not None:
            node.frame.told |= any(t in meaning.anchors for t in node.frame.head.things)
        self._go_to_anchors(where, meaning, subjects)

    def _give_each_its_anchor(self, node: Node, where: Where, meaning: Meaning) -> None:
        """Ask for one of its own for each: "four tables, each with a vase on a tray"."""
        noun, frame = where.noun, node.frame
        if self.each or noun is None or noun.kind != "thing" or noun.definite or noun.each or meaning.told:
            return
        lists = [n.frame for n in self.frontier if n.frame is not None and n.frame.each and n.frame.head is node]
        head = frame.head if frame is not None and frame.each and frame.head is not None else None
        heads = head.things if head is not None else node.things if lists else []
        shared = frame is not None and (frame.grouped or (frame.head is None and frame.each))
        times = frame.times if frame is not None and shared else 1
        for anchor in meaning.anchors if times > 1 else ():
            if isinstance(anchor, Mention) and self.named_by.get(anchor) is noun and anchor.count:
                self.numbers.add(anchor.count)
                anchor.count *= times
        for anchor in meaning.anchors if any(t.many for t in heads) else ():
            if isinstance(anchor, Mention) and self.named_by.get(anchor) is noun and not self.draft.bonds_of(anchor):
                anchor.per += heads

    def _go_to_anchors(self, where: Where, meaning: Meaning, subjects: list[Mention]) -> None:
        """Let what comes be about the anchors as well; one each of what is told of each of several."""
        anchors = [a for a in meaning.anchors if isinstance(a, Mention)]
        if not anchors or where.noun is None:
            return
        together = self._are_told_together(where)
        if meaning.kind == "on" and not meaning.told and where.noun.word in grammar().lists["stands"]:
            alone = len(subjects) == 1 and anchors[0].count is None
            anchors[0].count = subjects[0].count if alone and subjects[0].count else anchors[0].count
        if self.each and not meaning.told and where.noun.det == "a" and not together:
            anchors[0].count = sum(self.referents.total(t) for t in subjects)
            self.each = False
        self.each &= not together
        if where.noun.kind in ("thing", "number") and not meaning.told:
            self.frontier.append(Node(anchors, None, known=where.noun.definite))
        elif where.noun.kind == "thing":
            self.frontier.append(Node(anchors, None, known=True, told=True))

    def _are_told_together(self, where: Where) -> bool:
        """Whether all of them stand so to one thing: "both of them face a mirror", "both are next to a lamp"."""
        said = self.chunks[self._began - 1] if self._began else None
        if self._is_link(said, "verbs", "be", "stand") and self._began > 1:
            said = self.chunks[self._began - 2]
        if not isinstance(said, Noun):
            return False
        both = said.det == "both" or (said.value == "them" and said.text.lower().startswith("both"))
        tables = where.word == "at" and where.noun is not None and self.habits.is_in(where.noun.value, "tables")
        return (both and where.word in _SHARED_BY_BOTH) or (said.value == "all" and (tables or where.word in _FACED))

    def _is_elsewhere_named(self, subjects: list[Mention]) -> bool:
        """Whether the words since the last mark name things that have nothing to do with the subjects."""
        said: list[Mention] = []
        for chunk in reversed(self.chunks[max(0, self._began - _FRONTS) : self._began]):
            if self._is_link(chunk, "mark"):
                break
            if isinstance(chunk, Noun) and chunk.kind in ("pronoun", "number") and chunk.count and not said:
                return False  # "one" is of them: "one to the left of the desk and one to the right of it".
            if isinstance(chunk, Noun):
                said += self.meant.get(chunk.start, [])
        owners = [o for t in said for o in (t.owner, t.host) if o is not None]
        owners += [a for t in said for b in self.draft.bonds_of(t) for a in b.anchors if isinstance(a, Mention)]
        related = {id(k) for t in (*said, *owners) for k in self.referents.family(t)}
        alike = {t.noun for t in said} & {t.noun for t in subjects}
        return bool(said) and not alike and not related & {id(k) for t in subjects for k in self.referents.family(t)}

    def _keep_in_mind(self, where: Where, meaning: Meaning) -> None:
        """Remember what "it" meant: what comes may go on about it."""
        noun = where.noun
        its = noun is None or (noun.kind == "pronoun" and noun.value == "it") or noun.det == "my"
        anchor = meaning.anchors[0]
        if its and meaning.pointed and isinstance(anchor, Mention) and not is_small(anchor):
            self.spoken_of = anchor

    def _place_carrier(self, subjects: list[Mention], meaning: Meaning) -> None:
        """Read "In the middle a vase on a table": it is the table that stands in the middle."""
        carrier = meaning.anchors[0]
        if not isinstance(carrier, Mention) or (is_small(carrier) and carrier.noun in self.habits.known()):
            return
        if self.habits.is_in(carrier.noun, "covers"):
            return
        for bond in self.draft.bonds:
            if bond.subject in subjects and bond.anchors and isinstance(bond.anchors[0], str) and bond.kind != "on":
                self.draft.hand_over(bond, carrier)
        for front in self.front:
            place = isinstance(front.anchors[0], str) and front.kind != "on"
            front.used |= place
            if place and not any(b.kind == front.kind for b in self.draft.bonds_of(carrier)):
                self._relate([carrier], replace(front.meaning), negated=front.where.negated)

    def _set_front(self, where: Where) -> None:
        noun = self._noun_ahead()
        likely = [self.referents.topics[-1]] if self.referents.topics and not self.clause.members else []
        centre = self.referents.centre
        if likely and centre is not None and where.word in _AROUND_IT:
            likely = [centre, *likely]
        if self.frontier and self.frontier[-1].things and not likely:
            outer = [n for n in self.frontier if n.things and n.frame is not None and n.frame.head is None]
            last = next(n for n in reversed(self.frontier) if n.things)
            both_small = noun != "" and self._belongs(noun, "small") and is_small(last.things[-1])
            lying = [n for n in self.frontier if n.things and is_small(n.things[-1])]
            likely = [n.things[-1] for n in (lying[:1] if both_small else outer or [last])]
        sides = ("left", "right", "side", "front", "back")
        side = where.noun is not None and where.noun.kind == "part" and where.noun.value in sides
        before = [a for f in self.front for a in f.anchors if isinstance(a, Mention) and f.kind in _SIDEWARD]
        repeated = [a for f in self.front for a in f.anchors if isinstance(a, Mention) and a.many]
        if repeated and where.noun is not None and where.noun.kind == "pronoun" and where.noun.value == "each":
            likely = repeated
        elif before and (side or where.word in _SIDEWARD or where.word == "on"):
            likely = before if side or where.word != "on" else [*likely, *before]
        if where.noun is not None and where.noun.kind in ("part", "place") and where.whole is None:
            likely = likely if where.noun.det in ("my", "each", "either", "") and where.noun.kind == "part" else []
        meaning = self.meanings.of(where, [], likely, noun)
        if self.separator in ("and", "comma", "comma_and"):
            small = noun != "" and self._belongs(noun, "small") and where.word not in ("on", "in", "on_top")
            small_front = [f for f in self.front if f.kind == "on" and small]
            self.front = [f for f in small_front if f.anchors[0] != "wall" or self._may_be_hung(noun)]
        if meaning is not None:
            self._keep_in_mind(where, meaning)
            self.front = [*self.front[-_FRONTS:], Awaited(where, meaning)]
        else:
            self._lose_where(where)
            self._ask_all_the_same(where)
        self.frontier = []
        self.clause = Listed(times=self.clause.times)
        self.subject = None
        self.separator = ""
        self.pending = None
        if self._is_link(self.peek(), "mark", "comma"):
            self.at += 1

    def _may_be_hung(self, noun: str) -> bool:
        """Whether a small thing may hang on a wall as well: a clock or a photo, not a vase."""
        return self._belongs(noun, "wallpieces") or noun.rpartition("_")[2] in grammar().lists["hung"]

    def _noun_ahead(self) -> str:
        for ahead in range(3):
            chunk = self.peek(ahead)
            if isinstance(chunk, Noun):
                return chunk.value if chunk.kind == "thing" else ""
            if not isinstance(chunk, Connector) or chunk.sort not in ("verbs", "fillers", "mark"):
                return ""
        return ""

    def _past_positions(self) -> int:
        """How many chunks ahead what tells where something is ends: "(far from it), next to the door, | stands"."""
        ahead = 0
        while ahead < LOOKAHEAD:
            comma = int(self._is_link(self.peek(ahead), "mark", "comma"))
            more = self._is_link(self.peek(ahead + comma), "prepositions")
            if not more or not isinstance(self.peek(ahead + comma + 1), Noun):
                break
            ahead += comma + 2
        comma = self._is_link(self.peek(ahead), "mark", "comma")
        told = ahead + 1 if comma and self._is_link(self.peek(ahead + 1), "verbs", "stand", "hang") else ahead
        return self._skip_fillers(self.at + told) - self.at

    def _is_fronted(self) -> bool:
        """Whether what was just read says where something is that comes only now."""
        ahead = self._past_positions()
        after = self.peek(ahead)
        begins = not self.frontier and self.subject is None
        if begins and not self.clause.members:
            return True
        if not self.separator:
            return False
        if isinstance(after, Noun) and after.kind in ("thing",) and not after.definite:
            return True
        if self._is_link(after, "verbs", "be", "stand", "hang", "leave", "put", "have"):
            subject = self._next_noun(ahead + 1)
            return subject is not None and subject.kind == "thing"
        if self._is_link(after, "participles", "stand", "hang"):
            said = self.peek(ahead + 1)
            return isinstance(said, Noun) and said.kind == "thing" and not said.definite
        if self.separator in ("and", "comma_and") and self._is_link(after, "mark", "comma"):
            following = self.peek(ahead + 1)
            led = self.chunks[self._began - 1] if self._began else None
            pointed = isinstance(before := self.peek(-1), Noun) and before.kind == "pronoun"
            comma = self._is_link(led, "mark", "comma") or self.separator == "comma_and" or pointed
            return isinstance(following, Noun) and following.kind == "thing" and comma
        return False
