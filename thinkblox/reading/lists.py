"""Lists of what a thing has: "a desk with a lamp, a laptop and a chair", and where such a list ends."""

from thinkblox.brief import RelationKind
from thinkblox.knowledge.things import are_alike
from thinkblox.reading.anchors import Anchors
from thinkblox.reading.attach import bind, relation_kind
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.memory import OpenList

_LISTED = ("on", "at", "around")
"""Relations that keep a list open after a comma."""


class Lists(Anchors):
    """Ties new things to the list or the fronted relation they belong to."""

    def take_front(self, thing: Mention) -> None:
        """Give a thing the relation that stood before it ("on the desk a lamp and a vase")."""
        front = self.front
        if front is None:
            return
        listed = self.separator in ("and", "comma") and self.run
        off = front.kind == "on" and not self.habits.is_in(thing.noun, "small", "fitted")
        if listed and (off or (front.kind == "along" and self.separator == "comma")):
            self.front = None
            return
        self.attach(front.kind, front.anchors, subject=thing, pronoun=True, each=front.each)
        if front.kind not in ("on", "above", "along"):
            self.front = None

    def take_member(self, thing: Mention) -> None:
        """Take a thing into the open list, or close the list when it does not belong to its head."""
        frame = self.frame
        if frame is None:
            return
        tie = self._tie(thing, frame)
        first = not frame.members
        thing.host = frame.head if first or tie is not None else None
        if tie is None or (not first and self.separator == "comma" and tie not in _LISTED):
            self.frame = frame if first and self.separator == "having" and tie is None and frame.each else None
            return
        if "shared" in thing.attributes and tie == "next_to" and frame.head.many:
            tie = "between"
        thing.owner = frame.head
        frame.members.append(thing)
        each = tie != "between" and (frame.each or _shares(thing, frame.head, tie))
        bind(self.draft, Bond(tie, thing, (frame.head,), each=each, implied=True))

    def _tie(self, thing: Mention, frame: OpenList) -> RelationKind | None:
        """How a listed thing belongs to the head; None when it does not, which ends the list."""
        usual = self.habits.tie(thing.noun, frame.head.noun)
        small = self.habits.is_in(thing.noun, "small")
        match frame.kind:
            case "carry" if usual in ("at", "around"):
                return usual
            case "carry":
                fits = small or self.habits.is_in(thing.noun, "fitted")
                return "on" if fits or not frame.members or usual == "on" else None
            case "with":
                carries = self.habits.is_in(frame.head.noun, "surfaces")
                laid = small and carries and thing.noun != "tv" and (not frame.members or self.separator == "and")
                return usual or ("on" if laid else "next_to" if frame.each else None)
        return relation_kind(frame.kind) if not frame.members or self.separator == "and" else None


def _shares(thing: Mention, head: Mention, tie: str) -> bool:
    """Whether "two desks with a chair" means a chair at each."""
    if head.count is None or head.count < 2 or thing.vague or "shared" in thing.attributes:
        return False
    if thing.count is None:
        return tie in ("on", "at", "around")
    few = thing.count < 2 * head.count and not are_alike(thing.noun, head.noun)
    return thing.count == 1 or (tie == "around" and few)
