"""What must not be there, or must not be so."""

from dataclasses import replace

from thinkblox.reading.draft import Mention
from thinkblox.reading.english.chunks import Chunk, Connector, Noun, Stray
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.nodes import Awaited, Meaning, Where
from thinkblox.reading.english.positions import Positions
from thinkblox.reading.english.said import is_spatial
from thinkblox.reading.english.turns import TAKEN_BACK

_TELLING = ("face", "stand", "hang", "surround", "flank", "line", "hold", "carry", "have", "share")
"""Verbs that tell something of what is there."""
_NOT_PLACED = ("with", "without", "of", "for", "as", "except", "instead", "from", "to", "in")
"""Prepositions after which it is not said where things are."""
_SO_FAR = 8
"""So many chunks before "so is" at most it is told what is so."""
_DENIED = ("is not", "are not", "isn't", "aren't", "isnt", "arent")
"""Verbs that deny what follows of their subject."""


def is_denied_verb(link: Connector) -> bool:
    """Whether it is what a clause of its own says of its subject: "is not", "are not"."""
    return link.sort == "negations" and link.text.lower() in _DENIED


def text_is_no(link: Connector) -> bool:
    """Whether it is "no" and nothing else."""
    return link.text.lower() in ("no", "nope")


class Negation(Positions):
    """Reads negations."""

    def _verb(self, link: Connector) -> None:
        """Read a verb."""
        raise NotImplementedError

    def _negation(self, link: Connector) -> None:
        match link.value:
            case "not":
                self._not(link)
            case "nothing":
                self._nothing()
            case "only":
                self._only()
            case "exclude":
                self._refuse(link)
            case "gone":
                self._gone(link)
            case "remove":
                self._remove(link)
            case "moved":
                self._move(link)
            case "so":
                self._so()

    def _refuse(self, link: Connector) -> None:
        """Read "we don't need", "she vetoed": what follows is not to be there, or else what came before.

        Before a place it denies what comes: "the desk can't stand by the bed".
        """
        after = self.peek()
        if self._is_link(after, "prepositions"):
            self._not(link)
        elif after is None or self._is_link(after, "mark"):
            self._gone(link)
        else:
            self.excluding = True

    def _move(self, link: Connector) -> None:
        """Read "was moved to the attic": it is not there; "was moved to the corner" says where it is."""
        noun = self._next_noun(1) if self._is_link(self.peek(), "prepositions") else None
        if noun is None or noun.kind != "room":
            self._verb(replace(link, sort="verbs", value="stand"))
            return
        self._gone(link)
        self._go_past(noun)

    def _not(self, link: Connector) -> None:
        noun = self.peek()
        before = self._before()
        if link.text.lower() == "no" and isinstance(before, Noun) and (noun is None or self._is_link(noun, "mark")):
            self._take_back()
            return
        if self._is_asked(link) and (text_is_no(link) or noun is None or self._is_link(noun, "mark")):
            self._take_back(self.draft.things[-1])
            return
        if isinstance(noun, Noun) and noun.kind == "thing" and not noun.definite:
            self.excluding = True
            return
        text = link.text.lower()
        said_of = " be" in text or text in (*_DENIED, "not", "never")
        if said_of and (absent := self._absent()) is not None:
            self._keep_out(absent)
            return
        if self.relative is not None:
            self.subject, self.relative, self.predicate = self.relative, None, True
        elif text == "not" and self._is_verbless(before, noun):
            self.subject, self.predicate = self.frontier[-1], True
        if said_of and self.subject is None:
            self.subject = self._whole_subject()
            self.predicate = self.subject is not None
        self.negating = True

    def _absent(self) -> Noun | None:
        """What is said not to be in the room: "A car should not be in there"."""
        within = self._is_link(self.peek(), "prepositions", "in", "inside")
        subject, place = self._before(), self.peek(within)
        if not isinstance(subject, Noun) or subject.kind != "thing" or not (within or not subject.definite):
            return None
        here = isinstance(place, Connector) and place.text.lower() in grammar().lists["here"]
        room = within and isinstance(place, Noun) and place.kind == "room"
        end = self.peek(within + 1)
        ends = end is None or self._is_link(end, "mark") or self._is_link(end, "joins")
        return subject if (here or room) and ends else None

    def _keep_out(self, noun: Noun) -> None:
        """Take things out of the room that were named as if they were to be there."""
        fresh = [thing for thing in self.draft.things if self.named_by.get(thing) is noun]
        for thing in fresh or self.meant.get(noun.start, []) or self.clause.members[-1:]:
            self.draft.drop(thing)
            self.draft.excluded.add(thing.noun)
        self.excluded_by[noun.value] = noun
        self.account.mark(noun.start, noun.end, "constraint")
        self.at += 1 + self._is_link(self.peek(), "prepositions")
        self._begin()

    def _is_verbless(self, before: Chunk | None, after: Chunk | None) -> bool:
        """Whether a thing is denied a place without a verb: "the fridge not next to it", "but not on it"."""
        placed = isinstance(before, Noun) and before.kind == "thing" and self._is_link(after, "prepositions")
        return bool(self.frontier) and not self.predicate and (placed or self._is_link(before, "joins", "but"))

    def _is_asked(self, link: Connector) -> bool:
        """Whether it answers whether something is to be there: "A bench? No."."""
        asked = self.account.text(link.start - 1, link.start) == "?" and isinstance(self._before(2), Noun)
        return asked and bool(self.draft.things)

    def _take_back(self, thing: Mention | None = None) -> None:
        """Exclude what was named last: "a bench? No."."""
        thing = thing or (self.frontier[-1].thing if self.frontier else None)
        if thing is not None:
            self.draft.drop(thing)
            self.draft.excluded.add(thing.noun)

    def _gone(self, link: Connector) -> None:
        """Read "The popcorn machine is gone": it must not be there."""
        text = link.text.lower().replace("'", "")
        if text in grammar().lists["leaving"] and self._is_link(self.peek(), "prepositions"):
            self._verb(replace(link, sort="verbs", value="stand"))
            return
        if text in grammar().lists["misfitting"] and self._is_link(self.peek(), "prepositions"):
            self._not(replace(link, text="not"))
            return
        if self._is_asked(link):
            self._take_back(self.draft.things[-1])
            return
        before = next((c for c in self.chunks[self.at - 2 :: -1] if not self._is_link(c, "fillers")), None)
        before = before if self.at > 1 else None
        if self._is_kind_told_gone(before):
            return
        counted = isinstance(before, Noun) and (before.of_known or not before.definite)
        counted &= isinstance(before, Noun) and (before.kind in ("thing", "number") or before.value == "one")
        if counted and before is not None and not self.predicate:
            self._lose_rest(before.start, before.end + 1)
            fresh = self.meant.get(before.start, [])
            for thing in fresh if isinstance(before, Noun) and before.kind == "thing" else ():
                self.draft.drop(thing)
            return
        things = self.subject.things if self.subject is not None and self.predicate else []
        if not things and self.clause.members:
            things = self.clause.members[-1:]
        for thing in things:
            self.draft.drop(thing)
            self.draft.excluded.add(thing.noun)

    def _remove(self, link: Connector) -> None:
        """Read "One of the chairs broke, take it out": what the sentence named last is not to be there."""
        said = self.chunks[self._clause_start() : self.at - 1]
        named = [c for c in said if isinstance(c, Noun) and (c.kind == "number" or (c.kind == "thing" and c.named))]
        things = [t for c in named[-1:] for t in self.meant.get(c.start, []) if t in self.draft.things]
        if not things:
            self._lose(link.start, link.end)
            return
        for thing in things:
            left = [t for t in self.referents.family(thing) if t is not thing]
            self.numbers |= {thing.count or 1, sum(self.referents.total(t) for t in (thing, *left))}
            self.draft.drop(thing)
            self.draft.excluded |= set() if left else {thing.noun}
        for chunk in said:
            if isinstance(chunk, Stray) and chunk.text in self.draft.unknown:
                self.draft.unknown.remove(chunk.text)
                self.account.mark(chunk.start, chunk.end, "constraint")
        self._begin()

    def _is_kind_told_gone(self, before: Chunk | None) -> bool:
        """Read "A rug is out of the question", "Rugs are forbidden", where no such thing was named before."""
        if not isinstance(before, Noun) or before.kind != "thing" or before.definite or self.predicate:
            return False
        things = self.meant.get(before.start, [])
        named = [t for t in self.draft.things if t.noun == before.value and t not in things]
        if not things or named or before.count is not None or self.clause.members != things:
            return False
        for thing in things:
            self.draft.drop(thing)
            self.draft.excluded.add(thing.noun)
        return True

    def _so(self) -> None:
        """Read "and so is the clock" after what is not to be there."""
        before = [c for c in self.chunks[max(0, self.at - _SO_FAR) : self.at - 1] if isinstance(c, Connector)]
        barred = [c for c in before if c.sort not in ("mark", "joins", "fillers")]
        self.excluding = bool(barred) and self._is_link(barred[-1], "negations", "gone", "moved")

    def _nothing(self) -> None:
        after = self.peek()
        but = self.peek(2)
        besides = self._is_link(but, "joins", "but") or self._is_link(but, "prepositions", "except")
        if (
            besides
            and isinstance(after, Connector)
            and self._is_link(after, "prepositions", "on")
            and self._only_on(after)
        ):
            return
        if self._is_link(after, "prepositions", "except") or self._is_nothing_else():
            self.draft.empty = True
        elif isinstance(after, Connector) and self._is_link(after, "prepositions", "on"):
            noun = self._next_noun(1)
            if noun is not None and noun.kind == "place" and "wall" in noun.value:
                self.draft.excluded.update(grammar().lists["on_walls"])
                self.at += 2
                self.excluding = False
                if self._is_link(self.peek(), "joins", "but") or self._is_link(self.peek(), "prepositions", "except"):
                    self.at += 1
                    self.front = [Awaited(Where("on", noun), Meaning("on", (noun.value,)))]
            elif noun is not None and noun.kind in ("number", "pronoun", "part"):
                self._lose(after.start - 1, noun.end)
                self._go_past(noun)
            elif noun is not None and noun.kind == "thing":
                self.at += 1
                self._set_front(self._read_where(after))
        elif isinstance(after, Connector) and is_spatial(after) and self._is_nothing_there(after):
            return
        elif after is None or self._is_link(after, "mark") or self._is_link(after, "prepositions", "in"):
            self.draft.empty = True

    def _is_nothing_else(self) -> bool:
        """Go past "nothing else on it", which ends what is told of what was named."""
        said, noun = self._before(0), self._next_noun(1) if self._is_link(self.peek(), "prepositions", "on") else None
        other = isinstance(said, Connector) and said.text.lower() in ("nothing else", "nothing more")
        if noun is None or not other or not (self.peek(2) is None or self._is_link(self.peek(2), "mark")):
            return False
        known = noun.kind == "thing" and noun.definite and self.referents.named(noun) is not None
        if not known and noun.value != "it":
            return False
        self._spend(noun)
        self._go_past(noun)
        return True

    def _is_nothing_there(self, link: Connector) -> bool:
        """Read "nothing in the corner except a globe"; "nothing by the window" is not understood."""
        noun = self._next_noun(1)
        if noun is None or noun.kind not in ("place", "part", "thing"):
            return False
        self.at += 1
        where = self._read_where(link)
        if self._is_link(self.peek(), "joins", "but") or self._is_link(self.peek(), "prepositions", "except"):
            self.at += 1
            self.excluding = False
            self._set_front(where)
            return True
        self._lose(link.start - 1, self.chunks[self.at - 1].end)
        return True

    def _only_on(self, on: Connector) -> bool:
        """Read "(has) nothing on it but a bowl": what follows is there."""
        if self.subject is not None:
            self.at += 3
            self._open_of_subject("carry")
            return True
        what = self.peek(1)
        if not isinstance(what, Noun) or what.kind != "pronoun":
            return False
        if self.pending is not None:
            self.at += 3
            self.pending.kind = "carry"
        else:
            self.at += 1
            self._set_front(self._read_where(on))
            self.at += 1
        return True

    def _only(self) -> None:
        noun = self._next_noun()
        named = self._next_noun(2) if self._is_link(self.peek(1), "verbs", "be") else None
        if noun is not None and noun.kind == "thing" and named is not None and named.det == "a":
            self._spend(noun)
            self.at += 2
            return
        placed = bool(self.front or self.clause.members) or self.pending is not None
        if noun is not None and noun.kind == "thing" and not placed:
            self.draft.empty = True

    def _exclude_next(self) -> None:
        noun = self.peek()
        if self._is_link(noun, "prepositions"):
            self.negating = True
            return
        if isinstance(noun, Noun) and noun.kind == "part" and noun.det in ("a", "") and self.frontier:
            self._go_past(noun)
            self._lose(noun.start - 1, noun.end)
            return
        if isinstance(noun, Noun) and self._is_missing_part(noun):
            return
        self.excluding = True

    def _is_missing_part(self, noun: Noun) -> bool:
        """Say of "a nightstand without drawers" that we do not see to it: no dresser is barred."""
        thing = self.frontier[-1].thing if self.frontier else None
        part = noun.kind == "thing" and noun.word in grammar().lists["features"] and not noun.definite
        if thing is None or not part or not isinstance(self._before(), Noun):
            return False
        self._spend(noun)
        self._go_past(noun)
        thing.unshown.append(f"without {noun.text.lower()}")
        return True

    def _has_own_place(self) -> bool:
        """Whether a place after what is barred is its own, not that of what lacks it: "no lamp on the desk"."""
        by = self._before()
        if not isinstance(by, Connector) or by.sort != "prepositions":
            return True
        apart = self._is_link(self._before(2), "mark") or by.text.lower().startswith(("and", "but"))
        return by.value == "without" and apart

    def _is_of_barred(self, link: Connector) -> bool:
        """Whether it only says where something is not to be: "no lamp on the desk", "no rug under the bed or in it"."""
        barred = self.barred
        if barred is None or self._chunk_end() not in (barred.end, self.placed_barred):
            return False
        noun = self._next_noun()
        own = self.placed_barred >= 0 or (noun is not None and self._is_head_named(noun))
        if not own:
            return False
        where = self._read_where(link)
        self.placed_barred = link.end
        for said in (where.noun, where.whole, where.second):
            if said is None:
                continue
            self.placed_barred = max(self.placed_barred, said.end)
            self._spend(said)
            if said.kind == "thing" and said.definite:
                self.anchors(said, [])
            elif said.kind == "thing":
                self._lose(link.start, said.end)
        if not barred.named:
            self._lose(barred.start, self.placed_barred)
        return True

    def _is_head_named(self, noun: Noun) -> bool:
        """Whether it is what the clause was about already: "a bench without a mirror above the bench"."""
        known = self.referents.named(noun) if noun.kind == "thing" and noun.definite else None
        return known is not None and any(known in node.things for node in self.frontier)

    def _chunk_end(self) -> int:
        """Where the noun before the chunk that is being read ends, past what joins two places or says how it stands."""
        at = self.at - 2
        while at >= 0 and (
            self._is_link(self.chunks[at], "joins", "or", "and")
            or self._is_link(self.chunks[at], "participles")
            or self._is_link(self.chunks[at], "fillers")
        ):
            at -= 1
        return self.chunks[at].end if at >= 0 else -1

    def _denies(self, noun: Noun) -> bool:
        """Whether something is denied of things that are there: "no desk faces a window"."""
        after, next_after = self.peek(), self.peek(1)
        if self._is_link(after, "verbs", *_TELLING):
            return True
        if self._is_link(after, "verbs", "be"):
            return self._is_link(next_after, "prepositions") or self._is_link(next_after, "participles")
        if self._is_link(after, "prepositions", "facing", "turned"):
            return True
        there = self.referents.named(replace(noun, det="none", plural=True)) is not None
        placed = self._is_link(after, "prepositions") and not self._is_link(after, "prepositions", *_NOT_PLACED)
        return there and (placed or self._is_link(after, "participles", "stand", "hang"))

    def _is_cancelled(self, noun: Noun) -> bool:
        """Whether what was named is taken back: "forget the drape"."""
        said = self._before()
        first = self._before(2) if self._is_link(said, "prepositions", "without") else said
        if self._is_link(first, "fillers", TAKEN_BACK):
            return not self._is_link(self.peek(), "prepositions")
        cancels = isinstance(said, Connector) and said.text.lower() in grammar().lists["cancelling"]
        return cancels and noun.det in ("the", "my") and not self._is_link(self.peek(), "prepositions")

    def _exclude(self, noun: Noun) -> None:
        after = self._next_noun(1) if self._is_link(self.peek(), "prepositions", "except") else None
        if after is not None and after.kind in ("number", "pronoun"):
            self._spend(noun)
            self._go_past(after)
            self._take(self._new(replace(noun, det="a", count=after.count or 1, plural=False)), noun)
            return
        self._spend(noun)
        pointed = replace(noun, det="the") if noun.det == "no" else noun
        known = self.referents.named(pointed) if self._is_cancelled(noun) else None
        if known is not None:
            for thing in self.referents.clan(known):
                self.draft.drop(thing)
            self.draft.excluded.add(known.noun)
        self.draft.excluded.add(noun.value)
        self.excluded_by[noun.value] = noun
        self.account.mark(noun.start, noun.end, "constraint")
        if noun.word in grammar().lists["wide"] and not self._is_link(self.peek(), "prepositions"):
            self._lose(noun.start, noun.end)
        self.pending = None
        self.barred = noun
        self.placed_barred = noun.end if self._has_own_place() else -1
        if self._is_link(self._before(), "prepositions", "instead") and not self._is_link(self.peek(), "joins"):
            self.excluding = False
