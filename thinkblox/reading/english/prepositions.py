"""Prepositions that say something else than where: "of", "for", "as", "without"."""

from thinkblox.assets.plurals import singular
from thinkblox.reading.english.chunks import Link
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.negation import Negation
from thinkblox.reading.english.nodes import Node
from thinkblox.reading.english.referents import is_small


class Prepositions(Negation):
    """Reads prepositions."""

    def _preposition(self, link: Link) -> None:
        match link.value:
            case "with":
                self._open("with")
                return
            case "without":
                self._exclude_next()
                return
            case "instead":
                self._exclude_next()
                return
            case "except":
                self.excepting, self.negating, self.excluding = True, False, False
                return
            case "of":
                self._of()
                return
            case "for":
                self._for()
                return
            case "as":
                self._as()
                return
            case "among":
                if (noun := self._next_noun()) is not None and noun.kind in ("room", "abstract", "place"):
                    self.at = self.chunks.index(noun) + 1
                return
        self._began = self.at - 1
        self._where(self._read_where(link))

    def _of(self) -> None:
        """Read "shelves of bottles", "a vase of tulips", "the drawers of the cabinet"."""
        noun = self._next_noun()
        if noun is None:
            return
        index = self.chunks.index(noun, self.at)
        if not self.frontier and not self.clause.members and noun.kind == "thing":
            known, _ = self.anchors(noun, [])
            self.whole = known[0] if known else None
            self.at = index + 1
            return
        head = self.frontier[-1].thing if self.frontier else None
        if noun.kind != "thing" or head is None:
            self.at = index + 1
            if noun.kind == "people" and noun.count:
                self._people(noun)
            return
        word = singular(head.text.rpartition(" ")[2].lower())
        contents = noun.plural or noun.count is not None
        if contents and (word in grammar().lists["boxes"] or self.habits.is_in(head.noun, "shelves")):
            self._open("inside")
            return
        if noun.definite and not is_small(head):
            self.at = index + 1
            return
        self.at = index + 1
        head.text = f"{head.text} of {noun.text}"

    def _for(self) -> None:
        noun = self._next_noun()
        if noun is None:
            return
        index = self.chunks.index(noun, self.at)
        thing = self.frontier[-1].thing if self.frontier else None
        if noun.kind in ("people", "number") and noun.count and thing is not None:
            if self.habits.is_in(thing.noun, "tables", "desks"):
                thing.seats = noun.count
            self.at = index + 1
        elif noun.kind in ("people", "number") and noun.count and not self.draft.things:
            self.draft.people = noun.count
            self.at = index + 1
        elif noun.kind == "thing" and thing is not None and (noun.count or noun.plural) and not noun.definite:
            self._open("hold")
        elif noun.kind == "thing" and not self.referents.named(noun) and (noun.named or noun.det == "the"):
            found = self._new(noun)
            self.frontier = [Node([found], self.clause)]
            self.clause.members.append(found)
            self.at = index + 1
            self.leaving = False
        else:
            self.at = index + 1

    def _as(self) -> None:
        noun = self._next_noun()
        if noun is not None and noun.kind in ("thing", "room", "abstract") and noun.count in (None, 1):
            self.at = self.chunks.index(noun, self.at) + 1
