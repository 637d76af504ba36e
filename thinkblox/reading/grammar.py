"""Items to a draft: a small grammar of clauses, read in one pass. This file holds the words that link noun phrases."""

from itertools import pairwise

from thinkblox.reading.attach import bind, relation_kind
from thinkblox.reading.draft import Bond, Draft
from thinkblox.reading.memory import Front, OpenList, Waiting
from thinkblox.reading.nouns import Nouns
from thinkblox.reading.phrases import Connective, Item, Phrase, Unknown
from thinkblox.reading.sizes import Size

_ROOM_SIDES = {"left_of": "left_wall", "right_of": "right_wall"}
"""What "on the left" means of the first thing in a sentence."""


class Walker(Nouns):
    """Reads the items of one prompt into a draft."""

    def walk(self) -> Draft:
        """Read everything."""
        for index, item in enumerate(self.items):
            self.at = index
            if isinstance(item, Unknown):
                self.strays.append(item.text)
                continue
            self._strays(item)
            if isinstance(item, Connective):
                self._link(item)
            elif isinstance(item, Size):
                self._size(item)
            else:
                self._phrase(item)
        self._strays(Connective("stop"))
        self._elided()
        return self.draft

    def _strays(self, item: Item) -> None:
        """Unknown words that fill a place in a list are things we do not have; others are only listed."""
        if not self.strays:
            return
        ends = isinstance(item, Connective) and item.kind in (
            "comma",
            "stop",
            "and",
            "relation",
            "adverb",
            "having",
            "or",
            "colon",
        )
        listed = bool(self.separator) and not (self.separator == "stop" and not self.draft.things)
        words, self.strays = self.strays, []
        if ends and listed and len(words) <= 3 and not self.negating:
            self.draft.missing.append(" ".join(words))
        else:
            self.draft.unknown += words
        self.separator = ""

    def _link(self, link: Connective) -> None:
        match link.kind:
            case "comma" | "stop" | "colon" | "and" | "or" | "but":
                self._separate(link.kind)
            case "no":
                self._elided()
                self.negating = True
            case "nothing":
                self.draft.empty = True
            case "only":
                self.only = True
            case "of":
                self._of()
            case "relation":
                self._relation(link.value)
            case "having":
                self._having(link.value)
            case "adverb":
                self._adverb(link.value)
            case "mutual":
                self._mutual(self.waiting.kind if self.waiting else "facing")
                self.waiting = None

    def _separate(self, kind: str) -> None:
        self._elided()
        if kind in ("stop", "colon"):
            self.frame = self.front = None
            self.run, self.fresh, self.references.topic = [], True, None
            self.begun = len(self.draft.things)
            if kind == "colon" and self.current is not None:
                self.current.general |= self.current.many
            self.current = None if kind == "colon" else self.current
        elif kind == "and" and self.frame is not None:
            self.frame.closing = True
        elif kind == "comma" and self.frame is not None and self.frame.closing:
            self.frame = None
        if kind != "or" and not (kind == "and" and self.negating and self.next_is("or")):
            self.negating = False
        self.chain, self.everyone = None, []
        self.separator = kind if self.separator != "stop" or kind != "comma" else "stop"

    def _relation(self, kind: str) -> None:
        self._elided()
        fronted = self.fresh or (bool(self.separator) and self._leads())
        self.waiting = Waiting(kind, None if fronted else self.current, fronted, self._previous_is_each(alone=True))
        self.separator = ""

    def _leads(self) -> bool:
        """Whether a noun phrase comes right after the anchor: "..., by the window a desk"."""
        anchor, following = self.next_item(), self.next_item(2)
        if not isinstance(anchor, Phrase) or not isinstance(following, Phrase):
            return False
        return following.kind in ("object", "missing") and not following.definite

    def _having(self, kind: str) -> None:
        self._elided()
        self.separator = "having"
        if kind == "full":
            self._full()
            return
        head = self.current
        each = self._previous_is_each()
        if each and head is not None:
            head = next(iter(self.references.several(None, "each")), head) if not head.many else head
        self.front = None
        self.chain = None
        self.run = []
        self.frame = OpenList(head, kind, each=each) if head is not None else None

    def _previous_is_each(self, *, alone: bool = False) -> bool:
        """Whether "each" or, unless it is to stand alone, "each desk" comes just before."""
        previous = self.items[self.at - 1] if self.at else None
        return isinstance(previous, Phrase) and previous.each and not (alone and previous.kind != "pronoun")

    def _of(self) -> None:
        """Read "shelves of bottles" as shelves that carry bottles."""
        contents, head = self.next_item(), self.current
        small = isinstance(contents, Phrase) and self.habits.is_in(contents.value, "small")
        said = isinstance(self.items[self.at - 1], Phrase)
        if small and said and self.waiting is None and head is not None and self.habits.is_in(head.noun, "surfaces"):
            self._having("carry")

    def _full(self) -> None:
        """Tell "a bookcase full of books", which describes it, from "shelves filled with jars", which asks for jars."""
        contents = self.next_item()
        head = self.current
        if head is None:
            self.general = True
            return
        written = isinstance(contents, Phrase) and self.habits.is_in(contents.value, "fills_shelves")
        books = written and self.habits.is_in(head.noun, "takes_books")
        if not isinstance(contents, Phrase) or books or not self.habits.is_in(head.noun, "surfaces"):
            head.attributes.append("filled")
            self.waiting = Waiting("of", head)
        else:
            self.frame = OpenList(head, "carry")

    def _adverb(self, value: str) -> None:
        self._elided()
        if value.startswith("mutual_"):
            self._mutual(value.removeprefix("mutual_"))
        elif value == "per" and self.separator == "having" and self.frame is not None:
            self.frame.each = True
        elif value == "per":
            self.waiting = Waiting("per", self.current)
        elif value == "in_centre" and self.object_of():
            self.waiting = Waiting("on", self.current)
        elif value == "in_centre" and self.fresh:
            self.front = Front("in", ("centre",), each=False)
        elif value == "in_centre":
            self.attach("in", ("centre",), subject=self.current)
        elif value.endswith("_wall"):
            self.attach_place("along", value, self.current, each=False)
        elif value not in ("with", "ignored"):
            self._beside(value)

    def _beside(self, kind: str) -> None:
        """Read an adverb that points back: "a nightstand to its left", "to its left a nightstand"."""
        following = self.next_item()
        if isinstance(following, Phrase) and following.kind == "object" and self.separator:
            self.front = self._side_front(kind) or Front(kind, self.antecedent(None, kind, following.value), each=False)
            self.separator = ""
            return
        current = self.current
        if kind in _ROOM_SIDES and current is not None and current in self.draft.things[self.begun : self.begun + 1]:
            self.attach_place("along", _ROOM_SIDES[kind], current, each=False)
        else:
            self.attach(kind, self.antecedent(self.current, kind), subject=self.current, pronoun=True)

    def _side_front(self, kind: str) -> Front | None:
        """Read "on the left a bathtub, on the right a sink" as sides of the room when nothing came before."""
        side = _ROOM_SIDES.get(kind)
        if side is None or (self.draft.things and not self.sided):
            return None
        self.sided = True
        return Front("along", (side,), each=False)

    def _mutual(self, kind: str) -> None:
        """Read "facing each other", "side by side", "in a row": of one plural thing, or of two that were joined."""
        current = self.current
        if current is None:
            return
        if kind in ("in_rows", "in_row"):
            bind(self.draft, Bond("in_rows", current, rows=1 if kind == "in_row" else 0))
        elif current.many or len(self.run) < 2:
            bind(self.draft, Bond(relation_kind(kind), current, (current,)))
        else:
            for one, other in pairwise(self.run[-2:]):
                bind(self.draft, Bond(relation_kind(kind), other, (one,)))

    def _elided(self) -> None:
        """A relation without an anchor points back: "a whiteboard opposite"."""
        waiting, self.waiting = self.waiting, None
        if waiting is None or waiting.kind in ("of", "for", "in", "at", "on", "per", "along"):
            return
        subject, self.references.topic = waiting.subject, None
        if subject is not None:
            self.attach(waiting.kind, self.antecedent(subject, waiting.kind), subject=subject, pronoun=True)
