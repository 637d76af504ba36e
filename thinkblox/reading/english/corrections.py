"""What is said anew of the thing named last: "two armchairs, no, three"; "actually, make it a bunk bed"."""

from thinkblox.reading.draft import Mention
from thinkblox.reading.english.chunks import Connector, Noun
from thinkblox.reading.english.nodes import Node
from thinkblox.reading.english.pronouns import Pronouns
from thinkblox.reading.english.referents import last_word

_KINS = ("beds", "seats", "tables", "desks", "lamps", "storage", "shelves", "screens", "lounges", "plants", "covers")
"""Groups of things of which one can be put right as another."""
_TURNED = ("facing", "facing_away", "opposite")
"""Relations that say which way a thing is turned rather than where it stands."""
_BACK = 3
"""How many things back a correction reaches."""


class Corrections(Pronouns):
    """Reads corrections."""

    def _correct(self, link: Connector) -> None:
        """Say the number or the kind of the last thing anew, or where it is; what is corrected has to be plain."""
        if link.value == "move":
            self._move_again(link)
            return
        noun = self._next_noun()
        if noun is None:
            self._lose(link.start, link.end)
            return
        self._go_past(noun)
        self._spend(noun)
        thing = self._corrected(noun)
        if thing is None:
            self._lose(link.start, noun.end)
            return
        thing.count = noun.count if noun.count is not None else (None if noun.plural else 1)
        thing.plural, thing.least, thing.most = noun.plural or (noun.count or 1) > 1, noun.least, noun.most
        if noun.kind == "thing":
            thing.noun, thing.text, thing.called = noun.value, noun.text, noun.called
            self.named_by[thing] = noun
        if not self.frontier:
            self.clause.members.append(thing)
            self.frontier = [Node([thing], self.clause, known=True)]
        if noun.attributes or noun.unshown:
            thing.attributes, thing.unshown = [*noun.attributes], [*noun.unshown]

    def _move_again(self, link: Connector) -> None:
        """Forget where the last thing was said to be, or what it was said to face: that is told anew."""
        recent = [t for t in (*self.referents.topics[-1:], *self.referents.spoken[::-1]) if t in self.draft.things]
        thing = recent[0] if recent else None
        facing = self._is_link(self.peek(), "verbs", "face", "face_away")
        facing |= self._is_link(self.peek(), "prepositions", *_TURNED)
        said = self.draft.bonds_of(thing) if thing is not None else []
        old = [b for b in said if not (b.implied or b.negated) and (b.kind in _TURNED) == facing]
        if thing is None or not old:
            self._lose(link.start, link.end)
            return
        self.draft.bonds = [bond for bond in self.draft.bonds if bond not in old]
        self.clause.members.append(thing)
        self.subject, self.predicate = Node([thing], self.clause, known=True), True
        self.frontier = [self.subject]

    def _corrected(self, noun: Noun) -> Mention | None:
        """The thing that a correction is about, unless it was parted, or others are like it."""
        kept = set(map(id, self.draft.things))
        spoken = list(dict.fromkeys(t for t in reversed(self.referents.spoken) if id(t) in kept and t.asked))[:_BACK]
        if noun.kind == "number":
            told = bool(noun.attributes) or (noun.count or 1) > 1
            found = spoken[0] if spoken and (told or (spoken[0].count or 1) > 1) else None
        else:
            found = next((t for t in spoken if self._is_kin(t, noun)), None)
        if found is None or len(self.referents.family(found)) > 1 or found.groups or found.rows:
            return None
        return found

    def _is_kin(self, thing: Mention, noun: Noun) -> bool:
        if thing.noun == noun.value or last_word(thing) == noun.word:
            return True
        return any(self._belongs(thing.noun, group) and self._belongs(noun.value, group) for group in _KINS)
