"""Prepositions that say something else than where: "of", "for", "as", "without"."""

from dataclasses import replace

from thinkblox.reading.english.chunks import Connector
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.negation import Negation
from thinkblox.reading.english.nodes import Node
from thinkblox.reading.english.referents import is_small, last_word


class Prepositions(Negation):
    """Reads prepositions."""

    def _preposition(self, link: Connector) -> None:
        if link.value == "among" and self._is_on_walls():
            link = replace(link, value="on")
        match link.value:
            case "with":
                self._open("with")
            case "without" | "instead":
                self._exclude_next()
            case "except":
                self._except_next()
            case "of":
                self._of()
            case "for":
                self._for(link)
            case "as":
                self._as()
            case "among":
                self._among()
            case _:
                self._began = self.at - 1
                self._where(self._read_where(link))

    def _except_next(self) -> None:
        if not self._all_but():
            self.excepting, self.negating, self.excluding = True, False, False

    def _among(self) -> None:
        """Go past "throughout the room"."""
        if (noun := self._next_noun()) is not None and noun.kind in ("room", "abstract", "place"):
            self._go_past(noun)

    def _is_on_walls(self) -> bool:
        """Whether "all over the walls" says where things hang."""
        noun = self._next_noun()
        return noun is not None and noun.kind == "place" and "wall" in noun.value

    def _of(self) -> None:
        """Read "shelves of bottles", "a vase of tulips", "the drawers of the cabinet"."""
        noun = self._next_noun()
        if noun is None:
            return
        if not self.frontier and not self.clause.members and noun.kind == "thing":
            known, _ = self.anchors(noun, [])
            self.whole = known[0] if known else None
            self._go_past(noun)
            return
        head = self.frontier[-1].thing if self.frontier else None
        if noun.kind != "thing" or head is None:
            self._go_past(noun)
            if noun.kind == "people" and noun.count:
                self._people(noun)
            return
        word = last_word(head)
        contents = noun.plural or noun.count is not None or (not noun.det and noun.text.lower().endswith("s"))
        if contents and (word in grammar().lists["boxes"] or self.habits.is_in(head.noun, "shelves")):
            self._open("inside")
            return
        if noun.definite and not is_small(head):
            self._go_past(noun)
            return
        self._go_past(noun)
        head.text = f"{head.text} of {noun.text}"

    def _for(self, link: Connector) -> None:
        noun = self._next_noun()
        if noun is None:
            return
        thing = self.frontier[-1].thing if self.frontier else None
        if noun.kind in ("people", "number") and noun.count and thing is not None:
            if self.habits.is_in(thing.noun, "tables", "desks"):
                thing.seats = noun.count
            self._go_past(noun)
        elif noun.kind in ("people", "number") and noun.count and not self.draft.things:
            self.draft.people = noun.count
            self._go_past(noun)
        elif noun.kind == "thing" and thing is not None and (noun.count or noun.plural) and not noun.definite:
            self._open("hold")
        elif noun.kind == "thing" and not self.referents.named(noun) and (noun.named or noun.det == "the"):
            found = self._new(noun)
            self.frontier = [Node([found], self.clause)]
            self.clause.members.append(found)
            self._go_past(noun)
            self.leaving = False
        else:
            self._go_past(noun)
            if noun.kind == "thing" and thing is not None and noun.definite:
                self._lose(link.start, noun.end)

    def _as(self) -> None:
        noun = self._next_noun()
        if noun is not None and noun.kind in ("thing", "room", "abstract") and noun.count in (None, 1):
            self._go_past(noun)
