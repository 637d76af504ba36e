"""Anchors: what a relation is to ("the bed", "it", "each corner", "the foot of the bed"), and who its subject is."""

from thinkblox.brief import RelationKind
from thinkblox.reading.attach import FLANKS, bind, place_bond, relation_kind, subjects_of
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.memory import Memory, Waiting
from thinkblox.reading.phrases import Phrase


class Anchors(Memory):
    """Finds what relations refer to and binds the two."""

    @property
    def listed(self) -> list[Mention]:
        """The list that what is said of its last member is said of: "a vase and two candles", not "a rug, a lamp"."""
        return self.run if self.joined else []

    def resolve(self, phrase: Phrase, waiting: Waiting) -> tuple[str, tuple[Mention | str, ...]]:
        """Return the relation and anchors that a noun phrase after a preposition means; no anchors when none."""
        kind, subject = waiting.kind, waiting.subject
        match phrase.kind:
            case "pronoun" if phrase.value == "it":
                return kind, self.antecedent(subject, kind, self._noun_ahead() if waiting.fronted else "")
            case "pronoun" if phrase.value == "each":
                return kind, self.references.shared(subject)
            case "other" | "number":
                return kind, self.references.shared(subject)
            case "pronoun":
                return kind, self.references.several(subject, kind)
            case "place" if (thing := self._whole(phrase)) is not None:
                return ("on" if phrase.value == "centre" else "next_to"), (thing,)
            case "place":
                return kind, (phrase.value,)
            case "part":
                laid = kind == "on" and subject is not None and self.habits.is_in(subject.noun, "small")
                means = "on" if laid else self._part_of(phrase)
                return means, self.antecedent(subject, means if means == "at_foot_of" else "")
            case "object" if kind == "between" and self._and_opening(subject):
                return "next_to", self.named(phrase, waiting)
            case "object":
                return kind, self.named(phrase, waiting)
        return kind, ()

    def _noun_ahead(self) -> str:
        """The noun whose relation stands in front of it: "on it a lamp"."""
        ahead = (self.next_item(n) for n in (1, 2))
        return next((p.value for p in ahead if isinstance(p, Phrase) and p.kind == "object"), "")

    def _whole(self, phrase: Phrase) -> Mention | None:
        """The object of "the middle of the table"; None where it is the room's."""
        second = self.next_item(2)
        if not self.object_of() or not isinstance(second, Phrase):
            return None
        self.items[self.at + 2] = Phrase("ignored", "")
        return self.references.named(second) or self.new_thing(second)

    def _and_opening(self, subject: Mention | None) -> bool:
        """Read the second half of "between the sofa and the window"; whether there is one."""
        second = self.next_item(2)
        if not self.next_is("and") or not isinstance(second, Phrase) or second.value not in ("window", "door"):
            return False
        self.attach_place("near", second.value, subject, each=False)
        self.items[self.at + 2] = Phrase("ignored", "")
        return True

    def _part_of(self, phrase: Phrase) -> str:
        return {"foot": "at_foot_of", "side": "next_to", "head": "next_to", "top": "on"}[phrase.value]

    def named(self, phrase: Phrase, waiting: Waiting) -> tuple[Mention | str, ...]:
        """The thing an anchor phrase names, and a second one after "between ... and"."""
        kind = waiting.kind
        pointing = phrase.definite or phrase.each or phrase.whose or kind == "per" or phrase.bare
        known = self.references.named(phrase, besides=waiting.subject) if pointing else None
        thing = known or self.new_thing(phrase)
        if waiting.shared and known is None and waiting.subject is not None and thing.count == 1:
            thing.count = waiting.subject.count
        second = self.next_item(2)
        paired = kind == "between" and not thing.many and self.next_is("and")
        if not paired or not isinstance(second, Phrase) or second.kind != "object":
            return (thing,)
        other = self.references.named(second) if second.definite else None
        self.items[self.at + 2] = Phrase("ignored", "")
        return (thing, other or self.new_thing(second))

    def attach(
        self,
        kind: str,
        anchors: tuple[Mention | str, ...],
        *,
        subject: Mention | None,
        pronoun: bool = False,
        each: bool = False,
    ) -> None:
        """Bind what the words relate; a place of the room may belong to a door or window just mentioned."""
        if not anchors:
            return
        if isinstance(anchors[0], str):
            self.attach_place(kind, anchors[0], subject, each=each)
            return
        if subject is None or (kind == "per" and not isinstance(anchors[0], Mention)):
            return
        if kind in ("per", "for"):
            tie = self.habits.tie(subject.noun, anchors[0].noun) or "next_to"
            bind(self.draft, Bond(tie, subject, anchors, each=kind == "per" or each))
            return
        if kind == "in" and not self.habits.is_in(anchors[0].noun, "surfaces"):
            kind = "on"
        relation = self._flanked(kind, subject, anchors[0]) if kind in FLANKS else relation_kind(kind)
        if relation == "between" and self.chain is not None:
            subject = self.chain
        known = pronoun and relation != "between"
        for one in self.everyone or subjects_of(self.draft, subject, kind, anchors, self.listed, pronoun=known):
            bind(self.draft, Bond(relation, one, anchors, each=each))
            if len(anchors) == 1 and relation in ("next_to", "facing", "opposite", "left_of", "right_of"):
                self.references.pairs.append((one, anchors[0]))

    def _flanked(self, kind: str, subject: Mention, anchor: Mention) -> RelationKind:
        """One of a thing "on either side" is two, two seats "on each side" are four; seats are drawn up to a table."""
        seats = self.habits.is_in(subject.noun, "seats")
        if subject.count == 1 or (seats and kind == "flank_each" and subject.count):
            subject.count = 2 * (subject.count or 1)
        usual = self.habits.tie(subject.noun, anchor.noun)
        return usual if usual in ("at", "around") else relation_kind(kind)

    def attach_place(self, kind: str, place: str, subject: Mention | None, *, each: bool, places: int = 1) -> None:
        """Bind a thing, or the door or window just mentioned, to a place of the room, or to so many of them."""
        if self.opening is not None and place.endswith("_wall") and " " not in place and subject is None:
            self.opening.wall = place
            return
        if subject is not None and place == "ceiling":
            subject.attributes.append("hanging")
        meant = place_bond(kind, place)
        if subject is None or meant is None:
            return
        if places > 1 and subject.count == 1 and kind != "between":
            subject.count = places
        for one in self.everyone or subjects_of(self.draft, subject, meant[0], (place,), self.listed, pronoun=False):
            bind(self.draft, Bond(meant[0], one, meant[1], each=each))
