"""Pronouns as what a clause is about."""

from dataclasses import replace

from thinkblox.reading.draft import Mention
from thinkblox.reading.english.chunks import Adjective, Connector, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.nodes import Node
from thinkblox.reading.english.numbers import Numbers

_PAIR = 2
_EVERYTHING = "everything"
_CARRIED = ("on", "inside", "above")
"""Relations of what does not stand by itself."""
_STOP = Connector("mark", "stop", 0, 0)
"""What ends a text."""


class Pronouns(Numbers):
    """Reads pronouns."""

    def _pronoun(self, noun: Noun) -> None:
        match noun.value:
            case "each":
                self._each(self.peek())
            case "former" | "latter":
                found = self.referents.of_two(noun.value)
                self._resume([found] if found is not None else [], noun)
            case "it":
                self._resume(self._it(noun), noun)
            case "them" if noun.text.lower().startswith("both"):
                joined = self.clause.last_joined() or self.referents.joined
                two = joined if len(joined) == _PAIR else self.referents.both(())
                self._resume([*(two or self.referents.several([], ""))], noun)
                if self.frontier and not self._is_on_one():
                    self.frontier[0].each = self.each = True
            case "them":
                self._them_of(noun)
            case "all" if (rest := self._rest_of_named()) is not None:
                self._resume([rest], noun)
                self.each = True
            case "all":
                self._all(noun)
            case "one" | "other" | "half" | "none":
                self._one_of_several(noun)

    def _it(self, noun: Noun) -> list[Mention]:
        """What "it" is: what was spoken of, unless that cannot be as is said of it."""
        found = self.referents.single(None, "", self._spoken_of())
        if found is not None and self.habits.is_in(found.noun, "covers") and self._is_link(self.peek(1), "inverses"):
            found = self._lain_under(found) or found
        if found is not None and (states := self._states_next()):
            found = self.antecedents.bearer(noun.start, states, found)
        return [found] if found is not None else []

    def _lain_under(self, rug: Mention) -> Mention | None:
        """The bed of "a rug lies beneath it, and it is flanked by two nightstands"."""
        anchors = (a for b in self.draft.bonds_of(rug) if b.kind == "under" and not b.negated for a in b.anchors)
        return next((a for a in anchors if isinstance(a, Mention)), None)

    def _states_next(self) -> list[str]:
        """The states of "(it) is switched on", "(it) has been neatly folded"."""
        at = 0
        while self._is_link(self.peek(at), "fillers") or self._is_link(self.peek(at), "verbs", "be"):
            at += 1
        said = self.peek(at)
        return said.states if at and isinstance(said, Adjective) else []

    def _is_on_one(self) -> bool:
        """Whether "on a desk" comes, which is one for both: "two screens, both on a desk"."""
        verb = int(self._is_link(self.peek(), "verbs", "be", "stand"))
        noun, after = self._next_noun(verb + 1), self.peek(verb + 2)
        carried = self._is_link(self.peek(verb), "prepositions", "on", "on_top", "in")
        one = noun is not None and noun.kind == "thing" and noun.det == "a" and not noun.many
        return carried and one and not (isinstance(after, Noun) and after.value == "each")

    def _them_of(self, noun: Noun) -> None:
        """Speak of several; of nothing where "they" are people."""
        if self._are_people(noun):
            self._spend(noun)
            self._begin()
        elif every := self._all_counted(noun):
            self._resume(every, noun)
            self.each = True
        else:
            self._resume(self._they(), noun)

    def _all_counted(self, noun: Noun) -> list[Mention]:
        """All of several of which some were told apart: "two of the four desks ..., all four have a chair"."""
        if noun.det != "all" or not noun.count:
            return []
        families = (self.referents.family(thing) for thing in reversed(self.draft.things))
        return next((f for f in families if len(f) > 1 and sum(t.count or 1 for t in f) == noun.count), [])

    def _are_people(self, noun: Noun) -> bool:
        """Whether "they" are those whom the room is for, and who share something."""
        shared = noun.text.lower() == "they" and self._is_link(self.peek(), "verbs", "share")
        return shared and self.draft.people > 0

    def _they(self) -> list[Mention]:
        """What "they" are: several, or else the single things that "and" joined: "A sofa and a lamp. They are ..."."""
        found = list(self.referents.several([], ""))
        joined = self.clause.last_joined() or self.referents.joined
        if len(found) == 1 and not found[0].many and joined:
            return list(joined)
        several = [thing for thing in found if thing.many]
        return several if len(several) == 1 and not set(several) & set(joined) else found

    def _all(self, noun: Noun) -> None:
        """Speak of all that the clause named; "all of them have a lamp" of what was named before."""
        if noun.text.lower() == _EVERYTHING and not self.clause.members:
            self._everything(noun)
            return
        members = [t for t in self.clause.members if t in self.draft.things]
        if self._is_link(self.peek(), "fillers") or isinstance(self.peek(), Adjective):
            members = self._listed_last(members, both=noun.det == "both")
        parts = [t for member in members for t in self.referents.family(member)]
        things = list(dict.fromkeys(parts)) if noun.text.lower() == "all" else members
        things = [thing for thing in things if thing is not self._looked_at()] if len(things) > 1 else things
        if things:
            self.frontier = [Node(things, self.clause, known=True)]
            self.separator = ""
            self.each |= any(thing.many for thing in things)
        elif self._is_link(self.peek(), "verbs"):
            self._resume(self.referents.listed or list(self.referents.several([], "")), noun)
            self.each = any(thing.many for node in self.frontier for thing in node.things)

    def _everything(self, noun: Noun) -> None:
        """Speak of all that stands by itself, but for what is excepted; of what comes where a colon lists that."""
        excepted = self._excepted()
        carried = {b.subject for b in self.draft.bonds if b.kind in _CARRIED and not b.negated}
        things = [t for t in self.draft.things if t not in excepted and t not in carried]
        if things and not self._lists_after_colon():
            self._resume(things, noun)
            self.each = any(thing.many for thing in things)

    def _excepted(self) -> list[Mention]:
        """What is named after "everything but", known or new; goes past it."""
        found: list[Mention] = []
        link = self.peek()
        while self._is_link(link, "joins", "but") or self._is_link(link, "prepositions", "except") or found:
            noun = self._next_noun(1)
            joined = not found or self._is_link(link, "joins", "and") or self._is_link(link, "mark", "comma")
            if not joined or noun is not self.peek(1) or noun is None or noun.kind != "thing":
                break
            self._go_past(noun)
            found += self._known(noun) or [self._new(noun)]
            link = self.peek()
        return found

    def _lists_after_colon(self) -> bool:
        marks = (c for c in self.chunks[self.at :] if isinstance(c, Connector) and c.sort == "mark")
        first = next(marks, None)
        return first is not None and first.value == "colon"

    def _listed_last(self, members: list[Mention], *, both: bool) -> list[Mention]:
        """What "all red" is said of: the innermost list that is several; "both" are its last two single things."""
        frame = self.frontier[-1].frame if self.frontier else None
        listed = [t for t in frame.members if t in self.draft.things] if frame is not None else []
        if len(listed) < _PAIR and not any(thing.many for thing in listed):
            listed = members
        last = listed[-_PAIR:]
        return last if both and not any(thing.many for thing in last) else listed

    def _looked_at(self) -> Mention | None:
        """The television of "a TV and two sofas, all facing the TV"."""
        said = self._next_noun(1) if self._is_link(self.peek(), "prepositions") else None
        return self.referents.named(said) if said is not None and said.kind == "thing" and said.det == "the" else None

    def _rest_of_named(self) -> Mention | None:
        """What "all but one of the chairs" are; goes past it."""
        barred = self._next_noun(1) if self._is_link(self.peek(), "joins", "but") else None
        whole = self.referents.named(barred) if barred is not None and barred.kind == "thing" else None
        if barred is None or whole is None or not barred.of_known or not barred.count:
            return None
        if (whole.count or 0) <= barred.count:
            return None
        self._go_past(barred)
        self.referents.leave_out(whole, barred.count)
        self._look_so(whole, barred)
        return whole

    def _one_of_several(self, noun: Noun) -> None:
        """Read "one", "another", "the other", "half", "none" of what was named."""
        if noun.value == "one" and (self._shares_out(replace(noun, count=1)) or self._repeats(noun)):
            return
        if noun.value == "none" and self._is_link(self._before(), "verbs", "be", "stand", "hang") and self.predicate:
            self.negating = True
            return
        if noun.value == "none" and self.barred is not None and self._is_link(self.peek() or _STOP, "mark"):
            return
        if self._is_somebodys(noun) or (noun.text.lower() == "another" and self._is_besides(_one_more(noun))):
            return
        following = self.peek()
        if noun.text.lower() == "neither" and self.frontier and self._is_link(following, "prepositions"):
            self.negating, self.separator = True, ""
        elif noun.text.lower() == "neither" and isinstance(following, Noun) and following.kind == "thing":
            self.excluding = not following.definite
        elif noun.value == "half" and self._is_link(self.peek(), "prepositions", "as"):
            self._lose_comparison(noun)
        elif (whole := self._left_of(noun) or self._of_owners(noun) or self._whole([])) is not None:
            self._speak_of_some(whole, noun)
        elif noun.value != "half" and not (noun.text.lower() == "another" and self._repeat()):
            self._lose(noun.start, noun.end)

    def _left_of(self, noun: Noun) -> Mention | None:
        return self._left_over() if noun.value == "other" else self._left_for(noun)

    def _is_somebodys(self, noun: Noun) -> bool:
        """Read "two armchairs, hers and his", and "my desk is here, his is there": one more of the same."""
        if not _is_owned(noun):
            return False
        if before := self._owned_before(noun):
            self._resume(before, noun)
            return True
        owned = grammar().lists["owned"]
        theirs = self._next_noun(1) if self._is_link(self.peek(), "joins", "and") else None
        if theirs is not None and theirs.text.lower() in owned:
            self._spend(theirs)
            self._go_past(theirs)
            return True
        several = self.referents.left_over() is not None or self._whole([]) is not None
        return not several and self._is_besides(_one_more(noun))

    def _owned_before(self, noun: Noun) -> list[Mention]:
        """What was said before to be theirs: "Anna's is by the door. Anna's is red."."""
        same = (c for c in self.chunks[: self.at - 1] if isinstance(c, Noun) and c.kind == "pronoun")
        told = [self.meant.get(c.start, []) for c in same if c.text.lower() == noun.text.lower() and c is not noun]
        return [t for t in (told[-1] if told else []) if t in self.draft.things]

    def _speak_of_some(self, whole: Mention, noun: Noun) -> None:
        """Speak of one, another, the other, half or none of several."""
        match noun.value:
            case "none":
                self._resume([whole], noun)
                self.negating = True
            case "other" if noun.text.lower() == "another":
                last = self.clause.members[-1:]
                apart = self.referents.parted is None or not (
                    last and last[0] in self.referents.family(self.referents.parted)
                )
                if apart and self._repeat():
                    return
                said = self.verb
                self._part_of(whole, 1, noun)
                self._again(said)
            case "other" if _is_owned(noun) and (whole.many or not self.referents.parts.get(whole)):
                self._part_of(whole, 1, noun)
            case "other":
                self.referents.parted = None
                said = self.said or self.verb
                self._resume(self._others(whole), noun)
                self.each |= noun.shared
                self._again(said)
            case "half":
                parts = self.referents.parts.get(whole, ()) if whole is self.referents.parted else ()
                total = (whole.count or 2) + sum(part.count or 0 for part in parts)
                self._part_of(whole, max(1, min(total // 2, whole.count or total)), noun)
            case _:
                self._part_of(whole, noun.count or 1)

    def _repeats(self, noun: Noun) -> bool:
        """Whether "one" is one more of the same."""
        if self._more_of(noun):
            return True
        before = self._one_before()
        if before is not None:
            again = self._copy_of(before)
            if before in self.named_by:
                self.named_by[again] = self.named_by[before]
            self._take(again, noun)
        return before is not None

    def _lose_comparison(self, noun: Noun) -> None:
        """Go past "half as long as the sofa": it parts nothing."""
        end = noun.end
        while (chunk := self.peek()) is not None and not self._is_link(chunk, "mark"):
            self.at += 1
            end = chunk.end
            if isinstance(chunk, Noun):
                break
        self._lose(noun.start, end)

    def _one_before(self) -> Mention | None:
        """The single thing that "one" repeats: "one bin on its left and one on its right"."""
        if self.referents.parted is not None or not self.clause.members:
            return None
        last = self.clause.members[-1]
        again = last.text.lower().startswith("one ") or self._is_told_alike(last)
        return last if last.count == 1 and again else None

    def _is_told_alike(self, thing: Mention) -> bool:
        """Whether one more is told of as the single thing before: "a plant in the corner and one by the door"."""
        link, named = self.peek(), self.named_by.get(thing)
        if not isinstance(link, Connector) or link.sort != "prepositions" or link.value == "of" or not self.separator:
            return False
        if named is None or named.det != "a" or any(t.many for node in self.frontier for t in node.things):
            return False
        bonds = [bond for bond in self.draft.bonds_of(thing) if not bond.implied]
        after = next((c for c in self.cut if c.start == named.end), None)
        alike = isinstance(after, Connector) and after.sort == link.sort and after.value == link.value
        return (alike or bool(bonds)) and not any(bond.each for bond in bonds)

    def _spoken_of(self) -> list[Mention]:
        recent = self.clause.members[-1:] if self.separator else []
        return [t for t in (*recent, *self.referents.topics[-1:]) if not t.many]


def _one_more(noun: Noun) -> Noun:
    """What says of a pronoun that it is one besides those that were named."""
    return replace(noun, det="another", count=1)


def _is_owned(noun: Noun) -> bool:
    """Whether it means what is somebody's: "mine", "Mrs Olsen's"."""
    text = noun.text.lower()
    return text in grammar().lists["owned"] or text.endswith(("'s", "\u2019s"))
