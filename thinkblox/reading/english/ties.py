"""Which list a thing belongs to, and how its members stand to the head."""

from collections.abc import Sequence

from thinkblox.assets import kind_of
from thinkblox.reading.draft import Mention
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun, Stray
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.nodes import Listed
from thinkblox.reading.english.referents import FURNITURE, is_furniture, is_small, last_word
from thinkblox.reading.english.relating import Relating

_ON_IT = ("prepositions", "on", "in", "inside", "on_top")
"""How a list ends of which all lies on, or in, what has it."""
_CARRIED = ("on", "inside", "at", "around", "at_long_side", "at_short_side")
_TELLING_NO_PLACE = ("with", "of", "for", "per")
"""Prepositions that say nothing of where a thing is."""
_BY_THEM = ("next_to", "near", "by", "between", "behind", "in_front_of", "opposite", "around", "above")
"""Prepositions after which "them" are several together."""
_CARRYING_NOTHING = ("lamps", "ceiling", "screens", "plants", "wallpieces", "covers", "lounges")
"""What things are beside rather than on."""
_HELD = ("with", "hold", "carry", "inside")
_SMALL = 0.6
"""So large at most is what lies with other things on something [m]."""
_PAIR = 2
"""Of a longer list that was closed by "and", nothing more comes."""
"""How things stand to what they belong to more closely than to be beside it."""


class Ties(Relating):
    """Tells what continues a list."""

    def _frame_for(self, thing: Mention, noun: Noun) -> Listed:
        """The list that a thing after a comma or "and" goes on with: the innermost that it belongs to."""
        nodes = [node for node in reversed(self.frontier) if node.frame is not None]
        for node in nodes:
            frame = node.frame
            if frame is None or frame.head is None or self._is_too_large(thing, frame):
                continue
            if self._is_at_other_side(frame) or self._goes_on(frame, thing, noun):
                frame.closing |= self.separator in ("and", "comma_and")
                return frame
        if self.aside is not None and (tie := self._tie(thing, self.aside[1])) is not None and not self._told_apart():
            (head, frame), self.aside = self.aside, None
            if tie in _CARRIED or tie == "next_to":
                self.frontier = [head]
                return frame
        if self.clause.times > 1 and self.separator in ("comma", "comma_and") and self._is_group_told():
            self.clause = Listed()
        if self.separator in ("and", "comma_and"):
            self.clause.closing = True
        return self.clause

    def _is_too_large(self, thing: Mention, frame: Listed) -> bool:
        """Whether it goes into no small holder that is one of several things: a laptop, listed after a mug of pens."""
        head = frame.head.thing if frame.head is not None else None
        if head is None or not is_small(head) or frame.kind not in _HELD:
            return False
        stands = self._is_link(self.peek(), "prepositions", "under")
        if stands and frame.each and (self._next_noun(1) is None or self._is_told_by_pronoun()):
            return False
        if self._is_told_by_pronoun():
            return frame.each and is_furniture(thing) and not self.habits.is_in(thing.noun, "lamps")
        if self.habits.is_in(thing.noun, "covers"):
            return False
        inner, outer = sorted(kind_of(thing.noun).size), sorted(kind_of(head.noun).size)
        narrow = last_word(head) in grammar().lists["holders"]
        return inner[0] > outer[0 if narrow else 1] or inner[1] > outer[1 if self._contains(head) else 2]

    def _is_group_told(self) -> bool:
        """Whether what each of a group is was told to its end: "each a desk with a lamp and a chair, a sink"."""
        inner = [n.frame for n in self.frontier if n.frame is not None and n.frame is not self.clause]
        closed = [frame for frame in inner if frame.closing]
        return self.clause.closing or any(len(f.members) > _PAIR or self._told_apart() for f in closed)

    def _told_apart(self) -> bool:
        """Whether what comes says that the thing just named is somewhere by itself."""
        noun = self._next_noun(1) if self._is_told_next() else None
        return noun is not None and noun.kind == "place"

    def _is_at_other_side(self, frame: Listed) -> bool:
        """Whether what comes is the second of two that flank something."""
        return frame.kind == "sides" and self.separator == "and" and [m.many for m in frame.members] == [False]

    def _goes_on(self, frame: Listed, thing: Mention, noun: Noun) -> bool:
        if self._is_told_of_one(frame, noun):
            return True
        return not self._stands_apart_from(frame, thing, noun) and self._goes_on_with(frame, thing, noun)

    def _stands_apart_from(self, frame: Listed, thing: Mention, noun: Noun) -> bool:
        """Whether it is one for all, or lies where the head does, or there are as many as of what has the list."""
        if self.separator == "comma_and" and self._is_as_many(frame, thing):
            return True
        return self._is_of_all_together(frame, thing) or self._is_one_more_there(frame, noun)

    def _goes_on_with(self, frame: Listed, thing: Mention, noun: Noun) -> bool:
        told = self._told_of(frame, thing)
        bare = not noun.det and noun.count is None and noun.plural and self.separator == "and"
        if frame.contents and bare and told is not None and not self._is_told_by_pronoun():
            return True
        holder = frame.head.thing if frame.head is not None else None
        apart = self.separator in ("comma", "comma_and") or (holder is not None and is_small(holder))
        if ((frame.contents and apart) or self._is_past_contents(frame)) and (noun.det or noun.count is not None):
            return False
        if frame.each and noun.det == "the" and not noun.many and not self._is_told_by_pronoun():
            return False
        if told and frame.closing and frame.each and self.separator == "comma" and not self._is_told_by_pronoun():
            return False
        if frame.kind == "with" and not (frame.each or frame.closing) and self._is_link(self._told_at_end(), *_ON_IT):
            return True
        inverse = frame.kind not in ("with", "list", "hold", "carry", "inside", "on")
        if inverse and self.separator in ("comma", "comma_and") and (told or self._is_of_its_own(frame, thing)):
            return False
        if told is not None:
            return told
        if inverse and self.separator == "comma" and self._is_told_next():
            return False
        head = frame.head.thing if frame.head is not None else None
        return frame.times > 1 if head is None else self._is_one_more_of_list(frame, head, thing)

    def _is_one_more_there(self, frame: Listed, noun: Noun) -> bool:
        """Whether it lies where the head does: "on it, a plate with a sandwich, a glass of water"."""
        head = frame.head.thing if frame.head is not None else None
        alone = frame.kind == "with" and self.separator == "comma" and bool(noun.det or noun.count is not None)
        small = head is not None and is_small(head) and bool(self.front) and len(frame.members) == 1
        listed = self._is_listed_on() or self._told_at_end() is not None
        return alone and small and not frame.each and not listed and not self._is_told_by_pronoun()

    def _is_of_all_together(self, frame: Listed, thing: Mention) -> bool:
        """Whether it is one for all of several: "two bunks, each with a pillow on it, a ladder next to them"."""
        place = self._next_noun(1) if self._is_link(self.peek(), "prepositions") else None
        them = place is not None and place.kind == "pronoun" and place.text.lower() == "them"
        if not (them and frame.each and self.separator in ("comma", "comma_and")):
            return False
        return not thing.many and not any(member.many for member in frame.members if member is not thing)

    def _is_told_of_one(self, frame: Listed, noun: Noun) -> bool:
        """Whether a verb comes that can be said of the one head only: "a shelf with a box and two mats runs there"."""
        head = frame.head.thing if frame.head is not None else None
        verb = self.peek()
        if head is None or head.many or not noun.many or self.separator != "and" or not isinstance(verb, Connector):
            return False
        said = verb.text.lower().split()[:1]
        return verb.sort == "verbs" and bool(said) and said[0].endswith("s") and not said[0].endswith("ss")

    def _is_of_its_own(self, frame: Listed, thing: Mention) -> bool:
        """Whether it is a piece of furniture unlike what surrounds or parts something: "by six chairs, a cabinet"."""
        others = [member for member in frame.members if member is not thing]
        seats = bool(others) and all(self.habits.is_in(t.noun, "seats") for t in (others[0], thing))
        alike = bool(others) and (others[0].noun == thing.noun or seats)
        stands = kind_of(thing.noun).mount == "floor"
        return bool(others) and not alike and (not stands or self.habits.is_in(thing.noun, *FURNITURE))

    def _is_one_more_of_list(self, frame: Listed, head: Mention, thing: Mention) -> bool:
        return self._is_listed_for_each(frame, thing) or self._fits_in(frame, head, thing)

    def _is_listed_for_each(self, frame: Listed, thing: Mention) -> bool:
        """Whether a list of what each has goes on with it: "each has six chairs, a power strip and a lamp"."""
        if not frame.each or (self.verb != "have" and frame.kind != "with") or self.separator != "comma":
            return False
        inner = frame.closing and frame.told and frame.joined == len(frame.members) - 1
        if self.verb != "have" and not inner:
            return False
        if self.habits.is_in(thing.noun, *FURNITURE) or (frame.closing and not inner):
            return False
        return self._is_listed_on() or (inner and self._told_at_end() is not None)

    def _is_as_many(self, frame: Listed, thing: Mention) -> bool:
        """Whether there is one for each of several in all: "four desks, each with a laptop, and four chairs"."""
        head = frame.head.thing if frame.head is not None else None
        return frame.each and head is not None and (head.count or 0) > 1 and thing.count == self.referents.total(head)

    def _is_past_contents(self, frame: Listed) -> bool:
        """Whether one thing was said to be all over or in another: "a fridge covered with postcards, a sink"."""
        first = self.named_by.get(frame.members[0]) if frame.members else None
        bare = first is not None and first.plural and not first.det and first.count is None
        return bare and frame.kind in ("on", "inside") and self.separator == "comma"

    def _fits_in(self, frame: Listed, head: Mention, thing: Mention) -> bool:
        """Whether a thing of which nothing is told may be one more of what the head has."""
        tie = self._tie(thing, frame)
        if frame.each and not frame.closing and self.separator in ("comma", "and") and self._told_at_end() is not None:
            return tie is not None
        if frame.told and frame.each and not frame.closing and self.verb == "have" and self._is_listed_on():
            return True
        if frame.closing and self.separator in ("comma", "comma_and"):
            return frame.each and self.separator == "comma_and" and tie in ("at", "around") and not self._told_apart()
        if tie is None or (self.separator == "comma_and" and len(frame.members) <= 1 and not frame.each):
            return False
        pair = frame.each and self.separator == "and" and not self._told_apart()
        pair &= len(frame.members) == 1 or not (frame.told or frame.closing or self._is_told_next())
        if tie == "next_to" and not self.habits.tie(thing.noun, head.noun) and frame.members and not pair:
            return False
        if frame.told and is_small(head) and (not frame.each or head.per):
            return False
        if frame.told and self.separator == "comma":
            return frame.each and tie in _CARRIED
        alone = self.separator == "comma_and" and len(frame.members) == 1
        if frame.each and tie not in _CARRIED and alone:
            return False
        if frame.told and tie not in _CARRIED:
            return pair
        return not (self.separator == "comma_and" and tie not in _CARRIED and not frame.each)

    def _is_listed_on(self) -> bool:
        """Whether a list goes on to its "and" and its end: "each has a locker on its left, | a table and a chair"."""
        listed = self.chunks[self.at :]
        ends = next((at for at, c in enumerate(listed) if self._stops(c)), len(listed))
        plain = all(
            isinstance(c, Noun) or self._is_link(c, "mark", "comma") or self._is_link(c, "joins", "and")
            for c in listed[:ends]
        )
        return plain and (self.separator == "and" or any(self._is_link(c, "joins", "and") for c in listed[:ends]))

    def _stops(self, chunk: Chunk) -> bool:
        """Whether a sentence ends, or what is not understood comes."""
        return isinstance(chunk, Stray) or self._is_link(chunk, "mark", "stop", "semicolon")

    def _told_at_end(self) -> Connector | None:
        """How a list ends that says where each is to its head: "each with a desk, a chair and a bin under it"."""
        at, joined = self.at, self.separator == "and"
        while at < len(self.chunks) and not joined:
            comma = self._is_link(self.chunks[at], "mark", "comma")
            joined = self._is_link(self.chunks[at], "joins", "and")
            after = self.chunks[at + 1] if at + 1 < len(self.chunks) else None
            if not (comma or joined) or not isinstance(after, Noun) or after.kind != "thing" or after.definite:
                return None
            at = self._past_modifiers(at + 2 - self.at) + self.at
        link, noun = (*self.chunks[at : at + 2], None, None)[:2]
        if not isinstance(link, Connector) or link.sort != "prepositions" or not isinstance(noun, Noun):
            return None
        return link if noun.value in ("it", "each") else None

    def _is_told_by_pronoun(self) -> bool:
        """Whether "on it", "above them" comes."""
        at = self._past_place(1 if self._is_link(self.peek(), "participles") else 0)
        noun = self._next_noun(at + 1) if self._is_link(self.peek(at), "prepositions") else None
        return noun is not None and noun.kind == "pronoun"

    def _past_place(self, at: int) -> int:
        """How many chunks ahead it goes on after a place: after "on the wall" of "a shelf on the wall above it"."""
        place = self._next_noun(at + 1) if self._is_link(self.peek(at), "prepositions") else None
        goes_on = place is not None and place.kind == "place" and self._is_link(self.peek(at + 2), "prepositions")
        return at + 2 if goes_on else at

    def _past_modifiers(self, at: int) -> int:
        """How many chunks ahead it goes on after "of toys", "plugged in"."""
        while self._is_link(self.peek(at), "prepositions", "of") and isinstance(self.peek(at + 1), Noun):
            at += 2
        return at + isinstance(self.peek(at), Adjective)

    def _told_of(self, frame: Listed, thing: Mention) -> bool | None:
        """Whether what follows the noun ties it to the head of a list in words, or to something else."""
        index = 1 if self._is_link(self.peek(), "participles") else 0
        index = self._past_modifiers(index)
        index = self._past_place(index) if frame.each and self._is_told_by_pronoun() else index
        link = self.peek(index)
        noun = self._next_noun(index + 1)
        if not isinstance(link, Connector) or link.sort != "prepositions":
            return None
        if noun is None and link.value in ("above", "under", "behind", "opposite") and self.separator == "and":
            return True
        if noun is None:
            return None
        if link.value in ("with", "of", "for"):
            return None
        if frame.head is None:
            return frame.times > 1
        match noun.kind:
            case "pronoun":
                return noun.value != "other" and not (
                    self._are_all(frame, noun, thing) or self._is_of_another(frame, noun)
                )
            case "thing" if noun.definite:
                return self._is_beside_with(frame, thing, noun) or self._is_of(frame, thing, noun)
            case "part":
                of_head = self._lies_by_part(frame, thing, index) or self._is_part_of(frame, thing, index, noun)
                return not self._is_part_of_another(frame, index + 2) and of_head
            case "place" if noun.value.split()[0] in ("corner", "window", "door", "wall", "ceiling", "floor"):
                return None if self._may_share_place(frame, noun, thing) else False
        return None

    def _is_part_of_another(self, frame: Listed, at: int) -> bool:
        """Whether a part is told to be of something that is not the head: "a bench at the foot of the bed"."""
        whole = self._next_noun(at + 1) if self._is_link(self.peek(at), "prepositions", "of") else None
        head = frame.head.thing if frame.head is not None else None
        if whole is None or whole.kind != "thing" or whole.det != "the" or self.separator == "and" or head is None:
            return False
        return whole.value != head.noun and self.referents.named(whole) not in (head, *frame.members)

    def _is_beside_with(self, frame: Listed, thing: Mention, noun: Noun) -> bool:
        """Whether the owner is beside furniture: "a table with a jug and two glasses beside the swing"."""
        head = frame.head.thing if frame.head is not None else None
        pair = (
            head is not None and self.separator == "and" and not frame.each and not self._belongs(noun.value, "small")
        )
        lies = pair and is_small(thing) and head is not None and self._carries_before(thing, head, frame)
        return lies and not frame.closing and self.referents.named(noun) not in frame.members

    def _lies_among(self, frame: Listed, thing: Mention) -> bool:
        """Whether it lies where what was listed before does: "a desk with a laptop, a lamp left of the laptop"."""
        return not frame.each and is_small(thing) and self._tie(thing, frame) in ("on", "inside")

    def _may_share_place(self, frame: Listed, place: Noun, thing: Mention) -> bool:
        """Whether seats after "and" are still of the table that stands there: "a table with a clock and two chairs"."""
        head = frame.head.thing if frame.head is not None else None
        seated = head is not None and self.habits.tie(thing.noun, head.noun) in ("at", "around")
        on_it = self._is_link(self.peek(), "prepositions", "on", "in", "on_top") and not _is_whole_place(place)
        if head is not None and not (frame.each or on_it) and self._lies_with(thing, head, frame, place):
            return True
        if frame.each:
            return place.value.split()[0] == "wall" and not place.plural
        return seated and self.separator == "and" and frame.kind == "with"

    def _lies_by_part(self, frame: Listed, thing: Mention, index: int) -> bool:
        """Whether a part of another thing tells where the head is: "a bench with a vise and a saw left of the car"."""
        head = frame.head.thing if frame.head is not None else None
        link, part, whole = self.peek(index), self._next_noun(index + 1), self._next_noun(index + 3)
        if head is None or part is None or frame.each or frame.kind != "with" or self.separator != "and":
            return False
        if not is_small(thing) or not self._carries_before(thing, head, frame):
            return False
        if self._is_link(self.peek(index + 2), "prepositions", "of") and whole is not None and whole.kind == "thing":
            named = self.referents.named(whole) if whole.definite else None
            return named is not None and not is_small(named) and named not in (head, *frame.members)
        return (
            part.det == "the" and part.value in ("end", "back", "front") and self._is_link(link, "prepositions", "at")
        )

    def _lies_with(self, thing: Mention, head: Mention, frame: Listed, place: Noun) -> bool:
        """Whether it lies where the thing before it lies: "an altar with a statue and incense opposite the door"."""
        standing = self._is_beside_place() and max(kind_of(thing.noun).size) <= _SMALL
        low = standing or (is_small(thing) and not self.habits.is_in(thing.noun, "wallpieces", "ceiling"))
        upright = place.value.split()[0] not in ("wall", "floor", "ceiling") or _is_whole_place(place)
        pair = self.separator == "and" and frame.kind == "with"
        pair &= upright or standing or self._are_both_bare(thing, frame)
        return pair and low and self._carries_before(thing, head, frame)

    def _are_both_bare(self, thing: Mention, frame: Listed) -> bool:
        """Whether it and what it is joined to are several without a number: "hooks with sausages and hams"."""
        said = [self.named_by.get(t) for t in (*frame.members[-1:], thing)]
        return len(said) > 1 and all(n is not None and n.plural and not n.det and n.count is None for n in said)

    def _are_all(self, frame: Listed, noun: Noun, thing: Mention) -> bool:
        """Whether "them" are all that have something: "crates, each with a lid, and a van next to them"."""
        head = frame.head.thing if frame.head is not None else None
        if not frame.each or noun.value != "them" or head is None or not head.many:
            return False
        carried = frame.kind in ("on", "hold", "carry", "inside") and not is_small(thing)
        apart = self.separator == "comma_and" and not any(member.many for member in frame.members)
        return carried or apart or (self.separator != "and" and thing.rows != 0)

    def _is_of_another(self, frame: Listed, noun: Noun) -> bool:
        """Whether "it" cannot be the head, which is several: "a bench, four hooks with coats, boots under it"."""
        head = frame.head
        if noun.value != "it" or head is None or head.thing is None or frame.each or not head.thing.many:
            return False
        return not (head.thing.rows or head.thing.groups or head.thing in self.referents.shared)

    def _is_part_of(self, frame: Listed, thing: Mention, index: int, part: Noun) -> bool | None:
        """Whether "on the side" is of the head: not "of the bed", and not "at the front", which is of the room."""
        if not self._is_link(self.peek(index + 2), "prepositions", "of"):
            of_room = part.det == "the" and part.value in ("front", "back", "end")
            return not (of_room and self._is_link(self.peek(index), "prepositions", "at", "in"))
        whole = self._next_noun(index + 3)
        return self._is_of(frame, thing, whole) if whole is not None and whole.kind == "thing" else None

    def _is_of(self, frame: Listed, thing: Mention, noun: Noun) -> bool | None:
        found = self.referents.named(noun)
        if found in frame.members and self._lies_among(frame, thing):
            return True
        if frame.head is not None and found in frame.head.things:
            several = noun.plural or noun.word != noun.text.lower().rpartition(" ")[2]
            each = frame.each or any(b.each for m in frame.members for b in self.draft.bonds_of(m))
            together = each and noun.det == "the" and several and self.separator in ("comma", "comma_and")
            return not (noun.ordinal or noun.degree or together)
        outside = found is not None and not found.many and found not in frame.members
        carriers = [
            a for t in (frame.head.things if frame.head else ()) for b in self.draft.bonds_of(t) for a in b.anchors
        ]
        outside = outside and found not in carriers
        return None if frame.each and not outside else False

    def _is_told_next(self) -> bool:
        """Whether the relation of the thing just named to something is told in words."""
        link = self.peek()
        return self._is_link(link, "prepositions") and not self._is_link(link, "prepositions", *_TELLING_NO_PLACE)

    def _shares(self, thing: Mention, head: Mention, tie: str, frame: Listed) -> bool:
        """Whether "two desks with a chair" means a chair at each."""
        if head.per and frame.kind == "with" and is_small(thing):
            return True
        if head.count is None or head.count < 2 or thing.vague or "shared" in thing.attributes:
            return False
        if frame.kind in ("hold", "carry") or (not frame.each and self._is_beside_all()):
            return False
        if thing.count is None:
            return tie in ("on", "at", "around", "above", "next_to")
        if any(1 < (member.count or 0) < head.count for member in frame.members if member is not thing):
            return False
        if thing.count == 1 and any(m.count is None or m.plural for m in frame.members):
            return False
        if tie in ("around", "at") and self._share_others(thing, head):
            return True
        few = thing.count < 2 * head.count and thing.noun != head.noun
        if tie == "on" and thing.count < head.count and self._lies_on_each(frame.members, head):
            return True
        return thing.count == 1 or (tie in ("around", "at") and few)

    def _lies_on_each(self, members: Sequence[Mention], head: Mention) -> bool:
        """Whether each has one of what was listed before: "six tables with a vase and two cups on them"."""
        bonds = (b for member in members for b in self.draft.bonds_of(member) if member.count == 1)
        return any(b.kind == "on" and b.each and head in b.anchors for b in bonds)

    def _share_others(self, thing: Mention, head: Mention) -> bool:
        """Whether others that were told from these have so many each: "three with two chairs and two with four"."""
        others = [t for t in self.referents.family(head) if t is not head]
        alike = (b for b in self.draft.bonds if b.each and b.subject.noun == thing.noun and b.subject is not thing)
        return any(a in others for bond in alike for a in bond.anchors)

    def _is_beside_all(self) -> bool:
        """Whether it is told to be beside "them": "three buckets with a can beside them" are beside one can."""
        noun = self._next_noun(1) if self._is_link(self.peek(), "prepositions", *_BY_THEM) else None
        return noun is not None and noun.kind == "pronoun" and noun.value == "them"

    def _tie(self, thing: Mention, frame: Listed, *, first: bool = False) -> str | None:
        """How a listed thing belongs to the head; None when it does not, which ends the list."""
        head = frame.head.thing if frame.head is not None else None
        if head is None:
            return None
        first = first or not frame.members
        usual = self.habits.tie(thing.noun, head.noun)
        lies = self._belongs(thing.noun, "small")
        lies |= self.habits.is_in(thing.noun, "fitted") and (first or frame.kind in ("carry", "hold", "on"))
        lies &= not (self.habits.is_in(thing.noun, "fitted") and is_small(head))
        soft = self.habits.is_in(head.noun, "beds", "lounges") and frame.kind == "with"
        lies &= not (soft and self.habits.is_in(thing.noun, "screens", "lamps"))
        lies_here = lies or first or usual == "on"
        match frame.kind:
            case "hold" | "carry" | "inside" if usual in ("at", "around"):
                return usual
            case "hold" | "carry" | "inside" | "on" if not lies_here and self._ends_held_list(thing, frame):
                return "inside" if frame.kind == "inside" or (frame.kind != "on" and self._contains(head)) else "on"
            case "hold" if lies_here:
                return "inside" if self._contains(head) or _goes_into_cup(thing, head) else "on"
            case "carry" if lies_here:
                return "inside" if self._has_shelves(head) else "on"
            case "inside":
                return "inside" if lies or first else None
            case "on" if lies_here:
                return "on"
            case "with":
                return self._tie_with(thing, head, usual, frame, lies=lies, first=first)
            case "hold" | "carry" | "on" | "list":
                return None
        return frame.kind

    def _ends_held_list(self, thing: Mention, frame: Listed) -> bool:
        """Whether it ends a list of what something holds, and nothing else is said of it: "a dish and a sabre"."""
        ends = self._is_end(self.peek()) or self._is_link(self.peek(), "verbs")
        last = self.separator == "and" and len(frame.members) > 0 and ends
        return last and not self.habits.is_in(thing.noun, *FURNITURE)

    def _tie_with(
        self, thing: Mention, head: Mention, usual: str | None, frame: Listed, *, lies: bool, first: bool
    ) -> str | None:
        """How a thing belongs to another "with" it."""
        if usual == "on" and lies and (self._has_shelves(head) or last_word(head) in grammar().lists["showing"]):
            return "inside"
        if usual:
            return usual
        basin = self.habits.is_in(head.noun, "basins") or last_word(head) in grammar().lists["basins"]
        if basin and self.habits.is_in(thing.noun, "wallpieces"):
            return "above"
        upright = not self.habits.is_in(thing.noun, "lounges") or self.habits.is_in(head.noun, "lounged_at")
        if upright and self.habits.is_in(thing.noun, "seats", "chairs") and (seated := self._seated(head)):
            return seated
        contains = self._contains(head) or _goes_into_cup(thing, head)
        if contains and self.habits.is_in(thing.noun, "built_in", "basins"):
            return "next_to" if frame.each else None
        seats = (first or frame.each) and self.habits.is_in(head.noun, "seats")
        flat = last_word(head) in grammar().lists["flat"] or head in self.tables
        carries = contains or seats or flat or self.habits.is_in(head.noun, "surfaces", "beds", "lounges")
        lies |= last_word(thing) in grammar().lists["set_on"] and frame.kind == "with"
        lies |= self._ends_small_list(thing, head, frame)
        stands = kind_of(head.noun).plain and not any(h.kind == "on" for h in self.habits.of(thing.noun))
        carries |= (
            lies
            and not stands
            and (self._stands_there(head) if first or frame.each else self._carries_before(thing, head, frame))
        )
        if lies and carries and thing.noun != "tv":
            return "inside" if contains else "on"
        if first and lies and is_small(head) and not head.many:
            return "next_to"
        return "next_to" if frame.each else None

    def _ends_small_list(self, thing: Mention, head: Mention, frame: Listed) -> bool:
        """Whether it is small and ends a list of what lies there: "a counter with a till and a ticket dispenser"."""
        ends = self.separator == "and" and (self._is_end(self.peek()) or self._is_beside_place())
        low = max(kind_of(thing.noun).size) <= _SMALL or self.habits.is_in(thing.noun, "plants")
        ends |= self._has_shelves(head) and kind_of(thing.noun).plain and self.separator in ("comma", "and")
        ends |= kind_of(thing.noun).plain and self._is_before_small()
        return ends and low and self._carries_before(thing, head, frame)

    def _is_before_small(self) -> bool:
        """Whether a list goes on with what lies on things: "a vise, a truing stand, two screwdrivers and a tin"."""
        joined = self._is_link(self.peek(), "mark", "comma") or self._is_link(self.peek(), "joins", "and")
        after = self.peek(1)
        small = isinstance(after, Noun) and after.kind == "thing" and after.named and not after.definite
        ends = self.peek(2)
        listed = ends is None or self._is_link(ends, "mark") or self._is_link(ends, "joins", "and")
        return joined and small and listed and isinstance(after, Noun) and self._belongs(after.value, "small")

    def _is_beside_place(self) -> bool:
        """Whether what comes says where furniture stands: "a cabinet with gloves and masks along the wall"."""
        place = self._next_noun(1) if self._is_link(self.peek(), "prepositions", "along", "against", "by") else None
        return place is not None and place.kind == "place"

    def _carries_before(self, thing: Mention, head: Mention, frame: Listed) -> bool:
        """Whether what was listed before lies on the head."""
        lying = (b for m in frame.members if m is not thing for b in self.draft.bonds_of(m) if head in b.anchors)
        return any(bond.kind in ("on", "inside") for bond in lying)

    def _is_end(self, chunk: Chunk | None) -> bool:
        return chunk is None or self._is_link(chunk, "mark")

    def _stands_there(self, head: Mention) -> bool:
        """Whether it stands, or hangs at a wall, and carries what it is said to have: "a pedestal with a bust"."""
        return not (is_small(head) or self.habits.is_in(head.noun, *_CARRYING_NOTHING))

    def _has_shelves(self, head: Mention) -> bool:
        return self.habits.is_in(head.noun, *[g for g in ("shelves", "containers") if g in self.habits.groups])

    def _contains(self, head: Mention) -> bool:
        """Whether what a thing holds lies within it."""
        return self._has_shelves(head) or last_word(head) in grammar().lists["containers"]


def _goes_into_cup(thing: Mention, head: Mention) -> bool:
    """Whether it stands in what one also drinks from: the pencils of "a cup with two pencils", but no saucer."""
    sides, opening = sorted(kind_of(thing.noun).size), sorted(kind_of(head.noun).size)
    return last_word(head) in grammar().lists["cups"] and sides[1] < opening[1]


def _is_whole_place(place: Noun) -> bool:
    """Whether furniture stands there rather than that small things hang: "in the corner", "on the opposite wall"."""
    words = place.text.lower().split()
    return place.value.split()[0] == "corner" or (words[-1] == "wall" and len(words) > len(("the", "wall")))
