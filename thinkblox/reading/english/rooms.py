"""What is said of the room: its kind, its people, its openings and places."""

from dataclasses import replace
from itertools import pairwise

from thinkblox.assets.names import identifier_of
from thinkblox.assets.plurals import singular
from thinkblox.assets.repaint import LOOKS
from thinkblox.assets.sizing import people
from thinkblox.knowledge.rooms import UNKNOWN_ROOM, kinds_of_room, room_type
from thinkblox.reading.draft import Gap
from thinkblox.reading.english.chunks import Adjective, Connector, Measured, Noun
from thinkblox.reading.english.counted_rooms import parts_counted
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.lists import Memberships
from thinkblox.reading.english.meaning import ROOM_SIDES
from thinkblox.reading.english.nodes import Awaited, Listed, Meaning, Node, Where
from thinkblox.reading.english.referents import FURNITURE
from thinkblox.reading.english.said import is_spatial
from thinkblox.reading.lexicon import ENGLISH, load
from thinkblox.reading.sizes import Size

_THEIRS = {"": "kids_room", "room": "kids_room", "bedroom": "kids_room"}
"""What rooms are called that are for children."""
_PARTS = ("wall", "floor", "corner", "ceiling")
"""Parts of a room that words before them tell apart."""
_PAIR = 2
"""How many windows "both windows" and "each window" are where none was named."""
_WITHIN = ("of", "at", "in", "on")
"""Prepositions between a room and what it belongs to."""
_SIDE_ROOMS = (["front"], ["back"], ["main"], ["side"], ["rear"])
"""What is said of a room by where it is: the back room of a pharmacy is a pharmacy."""
COMPASS = ("north", "south", "east", "west")
"""What tells in which wall an opening is."""


_UNFURNISHED = ("empty", "bare")
"""What is said of a room in which nothing is but what is named."""
_OTHER_SIZE = {"large": "small", "small": "large"}
"""What a room is that is not so."""
_WITH_KITCHENS = ("studio", "loft", "cabin", "attic", "camper_van", "houseboat", "living_room", "dining_room")
"""Rooms to live in, where a kitchen is a part of what stands there."""
_OPPOSITE = "opposite"
_HALL = "hallway"
_WALKED_INTO = "walk_in_closet"
_CLOSET = "toilet_room"
"""The room that "a loo under the stairs" is."""


class Rooms(Memberships):
    """Reads what is said of the room."""

    def _room(self, noun: Noun) -> None:
        if noun.plural and (noun.count or 0) > 1:
            self._several_spots(noun)
            return
        if self._is_another_room(noun):
            if noun.value == "kitchen" and self.draft.room in _WITH_KITCHENS:
                self.at -= 1
                self.chunks[self.at] = replace(noun, kind="thing", value=f"{noun.value}ette", room="")
                return
            self.draft.rooms.append(noun.text)
            return
        if self._is_strange_part(noun):
            self.draft.unknown.append(" ".join([*noun.unshown, noun.text.lower().split()[-1]]))
        if not self.draft.room or self.draft.room == "room":
            self.draft.room = self._room_of_whole(noun) or noun.value
        self.draft.rooms += self._rooms_of_home(noun)
        looks = self._looks_of(noun, denied=noun.det == "no" or self.negating)
        looks = self.draft.shape_room(noun.value, looks)
        self.draft.room_attributes += [a for a in looks if not people((a,))]
        owners = grammar().people(word.strip("'\u2019") for word in noun.text.lower().split())
        self.draft.people = self.draft.people or people(noun.attributes) or owners
        self.draft.empty |= "empty" in noun.attributes or any(s in _UNFURNISHED for s in noun.states)
        if noun.size:
            self.draft.sizes.append(noun.size)
        if (place := self._place_of_label(noun)) is not None and not self.draft.things:
            self._lose(noun.end, place.end)
            self._spend(place)
            self._go_past(place)
        if (
            self.draft.things
            and noun.det == "a"
            and self.separator
            and self._is_link(self.peek(), "prepositions", "with")
        ):
            self._begin()
        if not self.draft.things:
            self._pass_whole()
            self.frontier = []
            self.of_room = self._is_link(self.peek(), "inverses") or self._is_link(self.peek(), "prepositions", "with")

    def _rooms_of_home(self, noun: Noun) -> list[str]:
        """The rooms that the name of a home counts: the two bedrooms of "a two-bedroom flat"."""
        said = [parts_counted(word) for word in noun.unshown]
        said += map(parts_counted, map("-".join, pairwise(noun.text.lower().split()))) if not noun.plural else ()
        known = load(ENGLISH).phrases
        rooms = ((n, what) for n, what in said if any(e.sort == "room" for e in known.get((what,), ())))
        return list(dict.fromkeys(f"{count} {what}s" for count, what in rooms if count > 1))

    def _looks_of(self, said: Noun | Adjective, *, denied: bool) -> list[str]:
        """What words tell of the looks of a thing or room: what is denied to be big is small, other looks are said."""
        if not denied:
            return said.attributes
        if not _OTHER_SIZE.keys() >= {*said.attributes}:
            self._lose(said.start, said.end)
        return [_OTHER_SIZE[a] for a in said.attributes if a in _OTHER_SIZE]

    def _room_of_whole(self, noun: Noun) -> str:
        """The hotel lobby of "lobby of a small hotel", as what has both words in its name; empty where nothing has.

        Of a front or back room it is the whole.
        """
        whole = self._next_noun(1) if self._is_link(self.peek(), "prepositions", "of") else None
        if whole is not None and whole.kind == "room" and noun.text.lower().split()[-2:-1] in _SIDE_ROOMS:
            return whole.value
        if whole is not None and whole.kind == "room" and self._is_main_hall(noun, whole.value):
            return whole.value
        words = whole.text.lower().replace("'s", "").split() if whole is not None else []
        for word in reversed(words):
            known = load(ENGLISH)
            tokens = known.tokens(f"{word} {noun.text.lower().split()[-1]}")
            found = known.longest(tokens, 0)
            room = found.entry("room") if found.length == len(tokens) else None
            if room is not None and noun.value in kinds_of_room(room.value):
                return room.value
        return ""

    def _is_main_hall(self, noun: Noun, whole: str) -> bool:
        """Whether a hall is where what its building is for is done: a museum's, a library's; no hall to come in by."""
        words = noun.text.lower().split()
        named = load(ENGLISH).longest(load(ENGLISH).tokens(" ".join(words[-2:])), 0).length == len(words[-2:]) > 1
        lived_in = any(self.habits.is_in(usual.category, "beds") for usual in room_type(whole).expected)
        return noun.value == _HALL and words[-1] == "hall" and whole != UNKNOWN_ROOM and not named and not lived_in

    def _pass_whole(self) -> None:
        """Go past what a room belongs to, which is no thing in it: "the kitchen of a food truck", "at a law firm"."""
        whole = self._next_noun(1) if self._is_link(self.peek(), "prepositions", *_WITHIN) else None
        if whole is None or whole.kind != "thing" or whole.many or whole.det not in ("a", "the", "my"):
            return
        stands = whole.value in self.habits.known() and self.habits.is_in(whole.value, "small", *FURNITURE)
        if not stands and self.referents.named(whole) is None:
            self._spend(whole)
            self._go_past(whole)

    def _go_on_with_room(self) -> None:
        """Let the room have what is told next: "a piano in a living room with a sofa"."""
        if self._is_link(self.peek(), "inverses") or self._is_link(self.peek(), "prepositions", "with"):
            self.frontier, self.subject, self.of_room = [], None, True

    def _several_spots(self, noun: Noun) -> None:
        """Read "four reading spots" as groups, of which each is told later; several rooms are not understood."""
        if noun.word in grammar().lists["groups"]:
            self._take(self._new(replace(noun, kind="thing", value=identifier_of(noun.word))), noun)
        else:
            self._lose(noun.start, noun.end)

    def _is_another_room(self, noun: Noun) -> bool:
        """Whether a second room is asked for: "an apartment with a kitchen and a bathroom"."""
        if not self.draft.room or noun.value == "room" or noun.definite or self.negating or self.excluding:
            return False
        had = self._is_link(self._before(), "prepositions", "with") or self._is_link(self._before(), "verbs", "have")
        if self.draft.room == "room" and not self.draft.things and not had:
            return False
        zone = noun.text.lower().split()[-1] in grammar().lists["zones"]
        sized = noun.size is not None or isinstance(
            self.peek(self._is_link(self.peek(), "prepositions", "of")), Measured
        )
        zone |= sized and not (noun.det or self.draft.sizes)  # "wedding reception, hall of 12 by 12 m"
        listed = (
            noun.det in ("a", "another") or noun.count is not None or self.separator in ("comma", "and", "comma_and")
        )
        return listed and not zone and noun.value != self.draft.room

    def _is_strange_part(self, noun: Noun) -> bool:
        """Whether it is a part of the room for something that we do not know, of which nothing more is told."""
        zone = noun.text.lower().split()[-1] in grammar().lists["zones"]
        told = self._is_link(self.peek(), "prepositions", "with", "for", "of") or self._is_link(self.peek(), "verbs")
        told |= self._is_link(self.peek(), "mark", "colon", "open", "dash")
        strange = bool(self.draft.room) and noun.value == "room" and bool(noun.unshown)
        return strange and zone and not (told or noun.definite or self.negating or self.excluding)

    def _is_label(self, noun: Noun) -> bool:
        """Whether the first noun says what kind of room it is: "Chess club, 7 m x 6 m: ..."."""
        if self.draft.things or self.draft.room or self.front or self.draft.excluded:
            return False
        after = self.peek()
        beside = isinstance(after, Noun) and after.kind == "place" and not after.det and after.start == noun.end
        if beside and not noun.named:
            self.at += 1
            self._room(replace(noun, kind="room", value="room"))
            return True
        stands = isinstance(after, Connector) and is_spatial(after) and noun.det == "a"
        corner = self._next_noun(1) if stands else None
        if noun.room and corner is not None and corner.kind == "place":
            return False
        if noun.room and not self._is_link(after, "joins", "and"):
            self._room(replace(noun, kind="room", value=noun.room))
            return True
        walked_into = self._is_walked_into(noun)
        if walked_into or self._place_of_label(noun) is not None:
            self._room(replace(noun, kind="room", value=_WALKED_INTO if walked_into else _room_of(noun)))
            return True
        introduces = isinstance(after, Measured) or self._is_link(after, "mark", "colon", "open")
        introduces |= self._is_link(after, "mark", "comma") and isinstance(self.peek(1), Measured)
        roomish = noun.text.lower().split()[-1] in (*grammar().lists["rooms"], *grammar().lists["closets"])
        part_of = self._is_link(after, "prepositions", "of", "at", "in", "on", "for") and not noun.det
        whole = self._next_noun(1) if part_of else None
        if whole is not None and self._is_link(self.peek(2), "mark", "comma") and isinstance(self.peek(3), Measured):
            self._spend(whole)
            self.at += 2
            self._room(replace(noun, kind="room", value="room"))
            return True
        with_ = self._is_link(after, "prepositions", "with", "for", "of") or self._is_link(after, "joins", "stop")
        sized = self._is_link(after, "mark", "comma", "open") and isinstance(size := self.peek(1), Measured)
        large = sized and isinstance(size, Measured) and self._is_room_size(size.size)
        large |= roomish and isinstance(after, Measured) and self._is_room_size(after.size)
        of_size = self._is_link(after, "prepositions", "of") and isinstance(size := self.peek(1), Measured)
        whole_room = (sized or of_size) and roomish and isinstance(size, Measured) and self._is_room_size(size.size)
        large = (large and (not noun.det or not noun.named)) or whole_room
        led = not (noun.det or noun.many) and (roomish or not noun.named) and self._colon_ahead()
        named_room = large or led or (roomish and self._is_link(after, "mark", "colon"))
        if named_room and noun.det in ("a", "") and not noun.many:
            self._room(replace(noun, kind="room", value=_room_of(noun)))
            return True
        marked = self._is_link(after, "mark") and not self._is_first_of_list(noun)
        if not noun.named and (roomish or introduces or with_ or marked) and not noun.many:
            if noun.det == "a" and with_ and not roomish:
                self.account.mark(noun.start, noun.end, "not_understood")
                self.draft.unknown.append(f"{noun.text} (no such room or thing is known)")
            self._room(replace(noun, kind="room", value="room"))
            return True
        return False

    def _is_first_of_list(self, noun: Noun) -> bool:
        """Whether another thing follows its comma: "a gizmo, a sofa and a lamp"; what has no article is a heading."""
        other = self._next_noun(1) if self._is_link(self.peek(), "mark", "comma") else None
        return noun.det == "a" and other is not None and other.kind == "thing" and bool(other.det or other.count)

    def _is_walked_into(self, noun: Noun) -> bool:
        """Whether a closet is the room: "the closet has a wardrobe against the wall"."""
        has = self._is_link(self.peek(), "prepositions", "with") or self._is_link(self.peek(), "verbs", "have", "hold")
        other = self._next_noun(1) if has and noun.text.lower().split()[-1] == "closet" and not noun.many else None
        return other is not None and other.kind == "thing" and not self._belongs(other.value, "small")

    def _place_of_label(self, noun: Noun) -> Noun | None:
        """The stairs of "Reading cubby under the stairs, 1.4 m by 2 m": where in a house a room is."""
        rooms = {*grammar().lists["rooms"], *grammar().lists["closets"]}
        roomish = noun.kind == "room" or (noun.text.lower().split()[-1] in rooms and not noun.many)
        place = (
            self.peek(1) if self._is_link(self.peek(), "prepositions", "under", "above", "behind", "next_to") else None
        )
        sized = self._is_link(self.peek(2), "mark") and isinstance(self.peek(3), Measured)
        ended = self._is_link(self.peek(2), "mark", "colon", "stop", "dash") or sized
        ended |= self._is_link(self.peek(2), "prepositions", "with")
        if not isinstance(place, Noun) or place.kind != "thing" or not (roomish and ended):
            return None
        of_house = place.word in grammar().lists["stairs"]
        return None if noun.kind == "thing" and place.named and not of_house else place

    def _is_room_size(self, size: Size) -> bool:
        """Whether a size is that of a room rather than of a thing."""
        sides = [length.metres for length in size.lengths]
        square = isinstance(said := self.peek(2), Adjective) and said.attributes == ["square"]
        return size.area is not None or ((len(sides) > 1 or square) and min(sides) >= 0.8)

    def _colon_ahead(self) -> bool:
        """Whether a colon ends what was begun, before any other mark."""
        marks = (c for c in self.chunks[self.at :] if isinstance(c, Connector) and c.sort == "mark")
        first = next(marks, None)
        return first is not None and first.value == "colon"

    def _people(self, noun: Noun) -> None:
        counted = noun.det == "a" or noun.count is not None
        if self._sits_somewhere(noun):
            return
        if counted and self._is_link(self.peek(), "participles", "stand"):
            self._lose(noun.start, noun.end)
            return
        if noun.count and not noun.each and (not self.draft.things or self._have_places(noun)):
            self._for_people(noun)
        elif counted and self._is_listed_person():
            self._lose(noun.start, noun.end)
            return
        everyone = noun.each or noun.text.lower() in ("everyone", "everybody")
        if everyone and self._is_link(self.peek(), "verbs", "have"):
            seats = (t.seats * (t.count or 1) for t in reversed(self.draft.things) if t.seats)
            self._begin()
            self.crowd = self.draft.people or next(seats, 0) or self._seats_named()
            if not self.crowd:
                self._lose(noun.start, noun.end)
        elif noun.count and not self.frontier and not self.clause.members:
            self.crowd = noun.count

    def _seats_named(self) -> int:
        """How many have a seat, where the seats were counted: ten players on ten gaming chairs."""
        seats = [t for t in self.draft.things if self.habits.is_in(t.noun, "seats", "chairs")]
        counted = all(t.count is not None and not t.vague for t in seats)
        return sum(self.referents.total(t) for t in seats) if counted and len({t.noun for t in seats}) == 1 else 0

    def _sits_somewhere(self, noun: Noun) -> bool:
        """Go past where somebody is, which is where no thing is said to be: "the doctor sits behind the desk, ..."."""
        place = self._next_noun(2) if self._is_link(self.peek(1), "prepositions") else None
        single = noun.det in ("the", "my") and noun.count is None and self._is_link(self.peek(), "verbs", "stand")
        if place is None or not single or place.kind != "thing" or (place.many and not place.definite):
            return False
        self._go_past(place)
        self.frontier = [Node(list(self.anchors(place, [])[0]), None, known=True)]
        return True

    def _for_people(self, noun: Noun) -> None:
        """The room is for so many, or for some; children have one of their own, and a family of six is six."""
        several = self._next_noun(1) if self._is_link(self.peek(), "prepositions", "of") else None
        if noun.count is None and several is not None and several.kind == "number" and several.count:
            self._go_past(several)
            noun.count = several.count
        self.draft.people = noun.count or self.draft.people
        who = noun.text.lower().split()[-1]
        self.draft.apart = who in grammar().lists["roommates"]
        children = who in grammar().lists["children"]
        if children and self.draft.room in _THEIRS:
            self.draft.room = _THEIRS[self.draft.room]

    def _have_places(self, noun: Noun) -> bool:
        """Whether several who are listed among things are those who have places in such a room: pupils in a class."""
        several = (noun.count or 0) > 1 and not self.draft.people and not noun.definite
        return several and bool(self.separator) and bool(room_type(self.draft.room).place)

    def _is_listed_person(self) -> bool:
        """Whether somebody is listed among things: "two saws, with a dust collector between them"."""
        led = self._is_link(self._before(), "prepositions", "with") or self.pending is not None
        listed = bool(self.separator) and any(node.things for node in self.frontier)
        doing = self._is_link(self.peek(), "verbs") or self._is_link(self.peek(), "joins", "which")
        return (led or listed or self.existential) and bool(self.draft.things) and not doing

    def _place(self, noun: Noun) -> None:
        if length := self._stays_free():
            self._free(noun.value)
            self.at += length
            return
        if self.leaving or "empty" in (*noun.attributes, *noun.states) or "free" in noun.text.lower().split():
            self._free(noun.value)
            return
        name = noun.value.split()[0]
        if name in ("centre", "corner") and not self.separator and self._is_link(self.peek(), "mark", "colon"):
            self._label_place(noun)
            return
        self._lose_wall_of(noun)
        looks = [*noun.attributes, *noun.unshown]
        strange = name in ("floor", "wall") and self._strange_word(noun) != ""
        shared = "same" in noun.text.lower().split()
        if shared or (name in ("floor", "wall", "ceiling") and not noun.definite and (looks or strange)):
            self.draft.unknown.append(noun.text.lower())
            return
        if (name in ("window", "door") and noun.det == "no") or (self.excluding and name in ("window", "door")):
            self.draft.openings.append(Gap(name, 0))
        elif name in ("window", "door") and noun.definite and self._stands_on_wall():
            self.at += 1
            same = [gap for gap in self.draft.openings if gap.kind == name and gap.count]
            self.opening = same[-1] if same else Gap(name, noun.count or (2 if noun.plural else 1))
            self.draft.openings += [] if same else [self.opening]
            self.frontier = []
        elif name in ("window", "door") and not noun.definite:
            self._open_gap(name, noun)
        elif not self.separator:
            self.frontier = []
            wall = name.endswith("wall") and isinstance(verb := self._verb_ahead(), Connector)
            if wall and verb is not None and verb.value in ("hold", "carry", "have"):
                self.front = [Awaited(Where("on", noun), Meaning("on", tuple(noun.value.split())))]

    def _stays_free(self) -> int:
        """How many chunks say that what was named is to be free: "(the middle) should stay empty", "is left free"."""
        length = 3 if self._is_link(self.peek(1), "participles", "stand") else 2
        said = self.peek(length - 1)
        free = isinstance(said, Adjective) and said.text.lower() in grammar().lists["uncluttered"]
        return length if free and self._is_link(self.peek(), "verbs", "be", "leave") else 0

    def _is_cleared(self, noun: Noun) -> bool:
        """Read "keep the rest of the desk free": there is nothing on it but what is named."""
        free = self.peek()
        told = isinstance(free, Adjective) and free.text.lower() in grammar().lists["uncluttered"]
        if not (self.leaving and told):
            return False
        whole = replace(noun, kind="thing", text=noun.text.lower().removesuffix(" top"), attributes=[])
        if self.referents.named(replace(whole, value=whole.word)) is None:
            return False
        self._spend(noun)
        self.at += 1
        self.draft.empty = True
        return True

    def _label_place(self, noun: Noun) -> None:
        """Read "Centre: round table"."""
        where = Where("in", noun)
        meaning = self.meanings.of(where, [], [])
        self.frontier, self.front = [], [Awaited(where, meaning)] if meaning is not None else []

    def _open_gap(self, name: str, noun: Noun) -> None:
        """Ask for a door or window."""
        self.opening = Gap(name, noun.count or (2 if noun.plural else 1))
        self.draft.openings.append(self.opening)
        for front in self.front:
            if front.anchors and isinstance(front.anchors[0], str) and front.anchors[0].endswith("_wall"):
                self.opening.wall = front.anchors[0]
        self.frontier = []

    def _lose_wall_of(self, noun: Noun) -> None:
        """Say of "a wall of monitors" that the monitors are no wall."""
        of = self._next_noun(1) if self._is_link(self.peek(), "prepositions", "of") else None
        if noun.value == "wall" and of is not None and of.kind == "thing":
            self._lose(noun.start, of.start)

    def _note_place(self, noun: Noun) -> None:
        """Say of "the third wall", "the adjacent wall" that we do not know which that is."""
        if noun.value in ("window", "door"):
            self._note_side(noun)
            self._note_several(noun)
        strange = self._strange_word(noun)
        if strange and not self.account.is_lost(noun.start, noun.end):
            self._lose(noun.start, noun.end)

    def _strange_word(self, noun: Noun) -> str:
        """A word before "wall", "floor", "corner" that says which or what it is like and means nothing to us."""
        words = noun.text.lower().replace("-", " ").split()
        if not words or noun.value.split()[0] in ("window", "door", "centre"):
            return ""
        last = next((n for n, word in enumerate(words) if singular(word) in _PARTS), 0)
        if singular(words[last]) == "corner" and _OPPOSITE in words[:last]:
            return _OPPOSITE
        known = grammar().lists["place_words"]
        return next((word for word in words[:last] if not self._is_plain_word(word, known)), "")

    def _is_plain_word(self, word: str, known: frozenset[str]) -> bool:
        said = word in known or word in LOOKS or word[:1].isdigit() or "'" in word or "\u2019" in word
        return said or grammar().knows(word, "determiners", "count", "evaluative", "fillers", "vague")

    def _note_several(self, noun: Noun) -> None:
        """Ask for the windows of "between two windows", "under each window"."""
        several = noun.count or (_PAIR if noun.each or noun.det in ("both", "all") else 0)
        if several > sum(gap.count for gap in self.draft.openings if gap.kind == noun.value):
            self.draft.openings = [gap for gap in self.draft.openings if gap.kind != noun.value]
            self.draft.openings.append(Gap(noun.value, several))

    def _note_side(self, noun: Noun) -> None:
        """Ask for the window of "under the east window" in that wall."""
        wall = next((f"{word}_wall" for word in noun.text.lower().split() if word in COMPASS), "")
        same = [gap for gap in self.draft.openings if gap.kind == noun.value and gap.count]
        if not wall or any(gap.wall == wall for gap in same):
            return
        loose = next((gap for gap in same if not gap.wall), None)
        if loose is not None and loose.count == 1:
            loose.wall = wall
        else:
            self.draft.openings.append(Gap(noun.value, 1, wall))

    def _stands_on_wall(self) -> bool:
        """Whether what comes says which wall an opening is in: "the door is on the north wall"."""
        wall = self._next_noun(2)
        said = self._is_link(self.peek(), "verbs", "be") and self._is_link(self.peek(1), "prepositions", "on", "in")
        return said and wall is not None and wall.kind == "place" and wall.value.endswith("_wall")

    def _verb_ahead(self) -> Connector | None:
        """The verb that a place before it is the subject of: "the wall behind it bears six posters"."""
        for chunk in self.chunks[self.at : self.at + 4]:
            if isinstance(chunk, Connector) and chunk.sort == "verbs":
                return chunk
            if isinstance(chunk, Connector) and chunk.sort == "mark":
                return None
        return None

    def _free(self, place: str) -> None:
        self.draft.free.append(place.split()[0])

    def _bare_part(self, noun: Noun) -> None:
        length = self._stays_free()
        if noun.value == "middle" and (self.leaving or length):
            self.at += 0 if self.leaving else length
            self._free("centre")
            return
        wall = ROOM_SIDES.get(noun.value, "")
        if wall and self._is_link(self.peek(), "mark", "colon"):
            self.frontier, self.clause = [], Listed()
            self.front = [
                Awaited(Where("at", noun, start=noun.start, text=noun.text), Meaning("against_wall", (wall,)))
            ]
            return
        self.subject = None
        self.frontier = []


def _room_of(noun: Noun) -> str:
    """The type of room that a label says: that of a closet that is called after what is in it, or any."""
    return _CLOSET if noun.word in grammar().lists["closets"] else "room"
