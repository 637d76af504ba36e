"""Which thing a noun phrase names: a known one, or a new one."""

from dataclasses import replace

from thinkblox.assets import CATALOGUE, kind_of
from thinkblox.assets.palette import with_general
from thinkblox.reading.adjectives import LOOKS_BY_DEGREE, degree_of
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.chunks import Adjective, Connector, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.quantities import SHELVES, is_shelved
from thinkblox.reading.english.referents import last_word
from thinkblox.reading.english.several import Several
from thinkblox.reading.english.state import LOOKAHEAD
from thinkblox.reading.english.tasks import is_tasked

_DRAWN_UP = ("at", "around", "at_long_side", "at_short_side")
"""How seats stand that people take at a table."""
SEATERS = {"for-1": "one-seat", "for-2": "two-seat", "for-3": "three-seat", "for-4": "four-seat"}
"""What a sofa for so many is called."""
_SLEEPERS = {"for-1": "single", "for-2": "double"}
"""What a bed for so many is called."""
_ANGLED = "L-shaped"
"""What a corner sofa is wherever it stands."""

_PLACED = (
    "in", "on", "on_top", "at", "by", "near", "next_to", "against", "along", "under", "above", "behind", "in_front_of",
    "around", "between", "opposite", "left_of", "right_of", "to", "facing",
)  # fmt: skip
"""Prepositions that tell where some of several are."""
_POINTING = ("the", "all")
"""Determiners of what is pointed at, though it may only be told of later."""


class Naming(Several):
    """Finds known things and adds new ones."""

    def _known(self, noun: Noun) -> list[Mention]:
        """The things that a noun phrase points back to."""
        known = self._pointed_at(noun)
        if known:
            self._spend(noun)
        return known

    def _pointed_at(self, noun: Noun) -> list[Mention]:
        among = [t for start in noun.among for t in self.meant.get(start, ()) if t in self.draft.things]
        return list(dict.fromkeys(among)) or self._pointed_at_by_name(noun)

    def _pointed_at_by_name(self, noun: Noun) -> list[Mention]:
        if noun.det == "each" and noun.every:
            return self._every_counted(noun)
        if noun.value == "seat" and noun.each and (seats := self._group_or_seats(noun)):
            return list(seats)
        if noun.det == "each" or (noun.det in ("all", "both", "none") and noun.plural):
            return self._all_named(noun)
        if noun.total > (noun.count or 0) and noun.kind == "thing" and self.referents.named(noun) is None:
            self._new(replace(noun, count=noun.total, plural=True, ordinal=0, side="", of_known=False, total=0))
        if noun.degree and noun.det in ("the", "my"):
            return self._by_degree(noun)
        if some := self._some_of_unnamed(noun) or self._some_told(noun) or self._some_placed(noun):
            return [some]
        if noun.of_known or noun.ordinal or noun.side or noun.det == "other":
            found = self.some_of(noun, besides=[])
            return [found] if found is not None else []
        if told := self._told_later(noun):
            return told
        bare = not noun.det and noun.count is None and not noun.plural and noun.named
        if noun.definite or (bare and self._is_repeated(noun)):
            return self._definite(noun)
        return self._one_and_other(noun)

    def _some_of_unnamed(self, noun: Noun) -> Mention | None:
        """Read "one of the nightstands", where none was named, as one of at least one more."""
        counted = noun.of_known and noun.kind == "thing" and noun.named and noun.count and noun.least is None
        other = noun.total or noun.ordinal or " those " in noun.text.lower()
        if not counted or other or self.referents.named(noun) is not None:
            return None
        whole = self._new(replace(noun, count=None, plural=True, of_known=False, attributes=[], unshown=[]))
        if (places := self._places_told()) and self.habits.is_in(noun.value, "seats", "chairs"):
            whole.count = places
        part = self.referents.part(whole, noun.count or 1)
        part.attributes, part.unshown = [*noun.attributes], [*noun.unshown]
        return part

    def _places_told(self) -> int:
        """How many the tables seat of which that is told; 0 where it is of none."""
        tables = [t for t in self.draft.things if t.seats and self.habits.is_in(t.noun, "tables")]
        return sum(t.seats * (t.count or 1) for t in tables)

    def _some_told(self, noun: Noun) -> Mention | None:
        """Read "three chairs are black", where there are more of them, as some of these."""
        begins = not (self.frontier or self.clause.members) and not noun.det and noun.count and not noun.of_known
        looks = self.peek(1) if self._is_link(self.peek(), "verbs", "be") else None
        if not begins or not isinstance(looks, Adjective) or noun.attributes:
            return None
        if not (looks.attributes or looks.unshown):
            return None
        whole = self.referents.named(noun)
        several = whole is not None and last_word(whole) == noun.word
        if whole is None or not several or self.referents.total(whole) <= (noun.count or 0):
            return None
        noun.of_known = True
        return self.referents.part(whole, noun.count or 1)

    def _some_placed(self, noun: Noun) -> Mention | None:
        """Read "two paintings hang above the sofa", after "there are four paintings", as some of these or the rest."""
        plain = not (noun.det or noun.of_known or noun.attributes or noun.unshown or noun.rows or noun.groups)
        told = self._is_link(self.peek(), "verbs", "be", "stand", "hang") and isinstance(self.peek(1), Connector)
        if not plain or not noun.count or not told or not self._is_link(self.peek(1), "prepositions", *_PLACED):
            return None
        whole = self.referents.named(noun)
        if whole is None or last_word(whole) != noun.word or not whole.plural:
            return None
        bonds = [b for b in self.draft.bonds_of(whole) if not b.implied and b.anchors != ("wall",)]
        left, parted = self.referents.total(whole), len(self.referents.family(whole)) > 1
        if bonds or whole.vague or left < noun.count or (left == noun.count and not parted):
            return None
        noun.of_known = True
        return whole if left == noun.count else self.referents.part(whole, noun.count)

    def _by_degree(self, noun: Noun) -> list[Mention]:
        """What "the larger table" is: one of several; of two that were told apart, the one said to be large."""
        family = self.referents.every(noun)
        looks = LOOKS_BY_DEGREE.get(degree_of(noun.degree), ())
        told = [t for t in family if set(looks) & {*t.attributes, *t.unshown}]
        if len(family) > 1 and len(told) == 1:
            noun.unshown = [word for word in noun.unshown if word != noun.degree]
            return told
        if sum(self.referents.total(t) for t in family) < 2:
            return family
        part = self.some_of(noun, [])
        return [part] if part is not None else []

    def _as_seat(self, noun: Noun) -> None:
        """Read "every place", "each setting" as the seats that were named."""
        if noun.kind in ("abstract", "room") and noun.each and noun.word in grammar().lists["seats"] and self._seats():
            noun.kind, noun.value, noun.named = "thing", "seat", False

    def _told_later(self, noun: Noun) -> list[Mention]:
        """The nightstands of "a lamp on every nightstand, two nightstands": how many they are is told only now.

        So are the tables of "no lamp on the tables. Three tables", and what a task named first.
        """
        plain = not (noun.definite or noun.owner or noun.groups or noun.rows)
        for thing in self.draft.things[-LOOKAHEAD:] if plain else ():
            named = self.named_by.get(thing)
            if named is None or thing in self.told_later or not self._is_anew(noun, thing, named):
                continue
            self.told_later.add(thing)
            thing.count, thing.least, thing.most = noun.count or thing.count, noun.least, noun.most
            thing.plural = noun.plural
            if named.det in _POINTING:
                told = [a for a in thing.attributes if a not in (*named.attributes, *noun.attributes)]
                thing.noun, thing.text = noun.value, noun.text
                thing.attributes = [*named.looks, *noun.attributes, *told]
                thing.unshown = [*dict.fromkeys((*thing.unshown, *noun.unshown))]
                thing.states = [*dict.fromkeys((*thing.states, *noun.states))]
            return [thing]
        return []

    def _is_anew(self, noun: Noun, thing: Mention, named: Noun) -> bool:
        """Whether what was pointed at before anybody told of it is told of now."""
        several = noun.count is not None and noun.count > 1
        if thing.noun == noun.value and named.each:
            return several and not (noun.attributes or noun.unshown)
        if named.det not in _POINTING or thing.count not in (None, 1, noun.count) or named.unshown:
            return False
        if thing.noun != noun.value and last_word(thing) != noun.word:
            return False
        if is_tasked(self.cut, named):
            return named.plural == noun.plural and {*named.attributes} <= {*noun.attributes}
        return (
            several and named.attributes == named.looks and named.plural and named.count is None and thing.count is None
        )

    def _all_named(self, noun: Noun) -> list[Mention]:
        """What "each chair", "both lamps", "all four chairs" are."""
        found = self.referents.every(noun)
        if noun.count is None:
            return found
        exact = [t for t in found if self.referents.total(t) == noun.count]
        total = sum(self.referents.total(t) for t in found)
        fewer = [t for t in found if (t.count or 0) > noun.count]
        if not exact and total > noun.count and fewer and noun.det == "each":
            return [self.referents.part(fewer[-1], noun.count)]
        return (exact[:1] or found) if total >= noun.count else []

    def _definite(self, noun: Noun) -> list[Mention]:
        """What "the chair", "the two chairs" are."""
        first = self.referents.named(noun)
        if first is None:
            return []
        if (told := self._told_by_place(noun, first)) is not None:
            return [told]
        several = first.many or self.referents.total(first) > 1
        if several and not noun.plural and self._is_of_somebody(noun):
            return []
        if noun.plural and noun.definite:
            every = self.referents.every(noun)
            total = sum(self.referents.total(t) for t in every)
            if total == 1 and noun.det == "the" and noun.states and not any(t.many for t in every):
                return []
            if noun.count is None or noun.count == total:
                return every
            return [first] if noun.count < total else []
        if noun.count and first.count and noun.count > first.count:
            return []
        if self._is_one_of_them(noun, first):
            return [self.referents.part(first, 1)]
        return [first]

    def _told_by_place(self, noun: Noun, first: Mention) -> Mention | None:
        """Which of several that were told apart "the desk by the window", "the desk that is in the corner" means."""
        family = self.referents.family(first)
        if noun.plural or noun.det not in ("the", "my") or len(family) < 2:
            return None
        which = self._is_link(self.peek(), "joins", "which")
        at = which + (which and self._is_link(self.peek(1), "verbs", "be", "stand"))
        link, where = self.peek(at), self.peek(at + 1)
        if not self._is_link(link, "prepositions", *_PLACED) or not isinstance(where, Noun) or not where.definite:
            return None
        stands = [(t, a) for t in family for b in self.draft.bonds_of(t) if not b.negated for a in b.anchors]
        there = {t for t, a in stands if where.value == (a.noun if isinstance(a, Mention) else a)}
        if len(there) != 1 or where.kind not in ("place", "thing"):
            return None
        self._go_past(where)
        return there.pop()

    def _is_one_of_them(self, noun: Noun, first: Mention) -> bool:
        """Whether "the nightstand by the door" is one of several; one that nothing tells from the others is noted."""
        single = not noun.plural and noun.count in (None, 1) and noun.det in ("the", "my")
        if not single or (self.referents.total(first) < 2 and not first.many) or first in self.referents.shared:
            return False
        if last_word(first) != noun.word or self._is_of_each(first):
            return False
        if self._is_link(
            self.peek(), "prepositions", "by", "near", "next_to", "at", "against", "far", "opposite", "behind"
        ):
            told = self._next_noun(1)
            return told is not None and told.kind in ("thing", "place") and told.definite
        self.unsure.append((noun, first))
        return False

    def _is_of_each(self, thing: Mention) -> bool:
        """Whether what the sentence says is said of each of those that have such a thing."""
        owners = [a for b in self.draft.bonds_of(thing) if b.each for a in b.anchors]
        spoken = [t for n in self.frontier for t in n.things]
        return self.each or self.clause.times > 1 or any(t in owners for t in spoken)

    def _is_of_somebody(self, noun: Noun) -> bool:
        """Whether it is told from others of its kind by whose it is: "the teacher's desk"."""
        return "'s " in noun.text.replace("\u2019", "'") and not noun.owner

    def _one_and_other(self, noun: Noun) -> list[Mention]:
        """Read "One cot has a bag on it, the other has not": one of those that were named."""
        if not noun.text.lower().startswith("one ") or self.separator:
            return []
        for chunk in self.chunks[self.at : self.at + LOOKAHEAD]:
            if self._is_link(chunk, "mark", "stop"):
                return self._one_named(noun) if self._is_link(self.peek(), "verbs") and not self.clause.members else []
            if isinstance(chunk, Noun) and (chunk.det == "other" or chunk.value == "other"):
                break
        else:
            return self._one_named(noun) if self._is_link(self.peek(), "verbs") and not self.clause.members else []
        whole = self.referents.named(noun)
        family = self.referents.family(whole) if whole is not None else []
        if len(family) > 1:
            self.referents.parted = family[-1]
            return family[:1]
        return self._one_named(noun)

    def _one_named(self, noun: Noun) -> list[Mention]:
        """Read "One side table" of two that were named: "on one side table stands a lamp"."""
        text = noun.text.lower().split()
        if text[:1] != ["one"] or noun.count != 1:
            return []
        whole = self.referents.named(noun)
        if whole is None or self.referents.total(whole) < 2:
            return []
        return [self.referents.part(whole, 1)]

    def _is_repeated(self, noun: Noun) -> bool:
        first = self.referents.named(noun)
        if first is None and noun.value.startswith("wall_"):
            first = next((t for t in self.draft.things if t.asked and noun.value == f"wall_{t.noun}"), None)
        if first is None or first in self.clause.members or first.many:
            return False
        if noun.value == f"wall_{first.noun}" and not self.draft.bonds_of(first):
            first.noun = noun.value
        return first.noun == noun.value and not noun.attributes and not noun.owner and not noun.unshown

    def anchors(self, noun: Noun, besides: list[Mention], *, denied: bool = False) -> tuple[tuple[Mention, ...], bool]:
        """The things that a noun phrase after a preposition means, and whether they were known.

        Args:
            noun: the phrase.
            besides: what it does not mean.
            denied: whether nothing is to be there, so that "a bench" is any of them.
        """
        self._spend(noun)
        if places := self._group_or_seats(noun):
            return places, True
        known = [t for t in self._known(noun) or self._one_named(noun) if t not in besides or noun.plural]
        before = self.referents.named(noun, besides) if not known and noun.det == "the" and besides else None
        known += [before] if before is not None and before not in besides and before.noun == noun.value else []
        if known:
            for thing in known:
                self.referents.speak(thing)
            self.meant[noun.start] = known
            return tuple(known), True
        if same := self._same(noun, besides):
            return same, True
        if denied and (any_of_them := self._any_of(noun, besides)):
            self.meant[noun.start] = any_of_them
            return tuple(any_of_them), True
        thing = self._new(noun)
        self.meant[noun.start] = [thing]
        if not noun.definite:
            self.fresh.add(thing)
        return (thing,), False

    def _any_of(self, noun: Noun, besides: list[Mention]) -> list[Mention]:
        """The benches of "two benches, ... a bin that must not stand next to a bench"."""
        plain = noun.kind == "thing" and noun.det in ("a", "any") and not (noun.attributes or noun.unshown)
        return [t for t in self.referents.every(noun) if t not in besides] if plain else []

    def _group_or_seats(self, noun: Noun) -> tuple[Mention, ...]:
        """What "each station", "every place" are."""
        word = noun.word
        if (noun.det == "each" and not noun.named) or noun.value.rpartition(" ")[2] in grammar().lists["groups"]:
            group = self.groups.get(word)
            if group is not None:
                return (group,)
        single = noun.det == "each" or (not noun.det and noun.count is None and not noun.plural)
        place = noun.value == "seat" or (single and word in grammar().lists["seats"])
        if not place or not (seats := self._seats()):
            return ()
        named = self.referents.named(noun)
        return tuple(seats) if named is None or last_word(named) not in grammar().lists["seats"] else ()

    def _same(self, noun: Noun, besides: list[Mention]) -> tuple[Mention, ...]:
        """Things of that name that were mentioned, where nothing says that others are meant."""
        if not noun.det and noun.plural and noun.count is None and not noun.attributes:
            every = [t for t in self.referents.every(noun) if t not in besides]
            every = [t for t in every if t.noun == noun.value or (t.many and last_word(t) == noun.word)]
            if every:
                return tuple(every)
        if noun.det in ("a", "") and not noun.plural and noun.count in (None, 1):
            found = self.referents.named(noun, besides)
            modest = found is not None and set(noun.attributes) <= with_general(found.attributes) and not noun.unshown
            if found is not None and modest and found.noun == noun.value and (found.many or not noun.det):
                self.referents.speak(found)
                return (found,)
        return ()

    def _seats(self) -> list[Mention]:
        seats = [t for t in self.draft.things if self.habits.is_in(t.noun, "seats", "chairs") and t.asked]
        drawn = [t for t in seats if any(b.kind in _DRAWN_UP for b in self.draft.bonds_of(t))]
        return drawn or seats

    def _every_counted(self, noun: Noun) -> list[Mention]:
        """Read it where these are counted later: "every second desk has a plant; there are eight desks"."""
        unnamed = not noun.counted and self._named_or_seats(noun) is None
        for at in range(self.at, len(self.chunks) if unnamed else 0):
            later = self.chunks[at]
            if not isinstance(later, Noun) or (later.kind, later.value) != (noun.kind, noun.value):
                continue
            if (later.count or 0) < 2 or later.definite or later.det not in ("", "a"):
                break
            self.chunks[at] = replace(later, det="the")
            self._new(replace(later, start=noun.start, end=noun.end))
            break
        return self._every(noun)

    def _new(self, noun: Noun) -> Mention:
        """Add the thing that a phrase asks for."""
        self._spend(noun)
        plain = noun.value in CATALOGUE and not kind_of(noun.value).plain
        several = noun.plural and (plain or not _is_one_made_of_two(noun))
        count = noun.count if noun.count is not None else (None if several else 1)
        if noun.value == "seat" and not noun.named:
            noun.value = "chair"
        if noun.walled and is_shelved(noun.value):
            noun.value = SHELVES
        if noun.share:
            count = self._share_of(noun)
        cornered = "corner" in noun.text.lower().split()[:-1] and not noun.value.startswith("corner")
        noun.attributes = [a for a in noun.attributes if a != "corner" or not cornered]
        thing = Mention(noun.value, count, noun.vague, noun.plural, noun.rows, [*noun.attributes], noun.text)
        thing.least, thing.most = noun.least, noun.most
        thing.vague |= noun.share > 0
        thing.unshown, thing.states = [*noun.unshown], [*noun.states]
        thing.seats, thing.size = noun.seats, noun.size
        called = SEATERS if self.habits.is_in(noun.value, "lounges", "seats", "chairs") else _SLEEPERS
        if noun.seats and (called is SEATERS or self.habits.is_in(noun.value, "beds")):
            thing.seats, thing.attributes = 0, [called.get(a, a) for a in thing.attributes]
        thing.groups, thing.group = noun.groups, noun.group
        thing.called = noun.called
        self.draft.things.append(thing)
        self.named_by[thing] = noun
        word = noun.word
        if word in grammar().lists["groups"]:
            self.groups[word] = thing
        if cornered:
            self.draft.bonds.append(Bond("in_corner", thing, ("corner",), asked=_ANGLED not in noun.attributes))
        if "facing" in noun.text.lower().split()[:-1] and noun.many:
            self.draft.bonds.append(Bond("facing", thing, (thing,)))
        if noun.walled:
            self.draft.bonds.append(Bond("against_wall", thing, ("wall",), spread=noun.rows if noun.rows > 1 else 0))
        if noun.rows and not (noun.walled and noun.rows > 1):
            self.draft.bonds.append(Bond("in_rows", thing, rows=max(noun.rows, 0)))
        self.referents.speak(thing)
        return thing

    def _share_of(self, noun: Noun) -> int | None:
        """Read "half as many dryers", "as many glasses as there are stools"; as many as nobody counted is said."""
        other: Mention | None = None
        told: Noun | None = None
        for index in range(self.at, min(self.at + 8, len(self.chunks))):
            if self._is_link(self.chunks[index], "prepositions", "as"):
                said = next((c for c in self.chunks[index + 1 : index + 4] if isinstance(c, Noun)), None)
                other = self.referents.named(said) if said is not None and said.kind == "thing" else None
                if said is not None:
                    told = said if said.kind == "thing" else None
                    del self.chunks[index : self.chunks.index(said, index) + 1]
                    told = None if self._is_number_told(index) else told
                break
        if told is not None and (other is None or other.count is None):
            self._lose(noun.start, told.end)
        elif other is None:
            counted = [t for t in self.referents.plural() if t.count]
            alike = [t for t in counted if t.noun == noun.value]
            other = next(iter(alike or counted), None)
            if other is None or len(alike) > 1:
                self._lose(noun.start, noun.end)
        family = self.referents.family(other) if other is not None else []
        return max(1, int(sum(map(self.referents.total, family)) * noun.share)) if family else None

    def _is_number_told(self, index: int) -> bool:
        """Whether the number itself comes: "as many mats as there are machines, five"."""
        mark, number = self.chunks[index : index + 2] if index + 1 < len(self.chunks) else (None, None)
        return self._is_link(mark, "mark") and isinstance(number, Noun) and number.kind == "number"

    def another(self, thing: Mention) -> Mention:
        """One more of a kind."""
        return self._copy_of(thing)

    def _copy_of(self, thing: Mention) -> Mention:
        """Another of the same kind."""
        copy = Mention(thing.noun, 1, attributes=[*thing.attributes], unshown=[*thing.unshown], text=thing.text)
        copy.states, copy.size, copy.called = [*thing.states], thing.size, thing.called
        self.draft.things.append(copy)
        self.referents.speak(copy)
        return copy


def _is_one_made_of_two(noun: Noun) -> bool:
    """Whether a plural is one thing: "reading glasses", "pliers"."""
    words = noun.text.lower().split()
    return any(" ".join(words[-length:]) in grammar().lists["pairs"] for length in (1, 2))
