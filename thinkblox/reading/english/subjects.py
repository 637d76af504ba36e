"""Whom a relation is about, and what a pronoun then means."""

from collections.abc import Sequence
from itertools import takewhile

from thinkblox.assets import kind_of
from thinkblox.assets.mounting import WALL_MOUNTED, mount_of
from thinkblox.knowledge.senses import senses_of
from thinkblox.reading.draft import Bond, Mention
from thinkblox.reading.english.chunks import Connector, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.having import Having
from thinkblox.reading.english.nodes import Listed, Meaning, Node, Where
from thinkblox.reading.english.parts import SIDES
from thinkblox.reading.english.referents import FURNITURE, is_loose_lamp, is_small, last_word
from thinkblox.reading.english.state import LOOKAHEAD

_PAIR = 2
_NO_PLACE = ("with", "of", "for", "per", "as")
"""Prepositions that say nothing of where a thing is."""
_ROOM_PARTS = ("front", "back", "end")
"""Parts that rooms have too."""
_SLIM = 0.3
"""So large at most is the second side of what lies on things though it is long [m]."""
_PLATE = 0.3
"""So large at most is what holds a meal, and no drink besides [m]."""
_THIN = 0.4
"""So much at most of its longest side is the shortest of what can lean against something."""
_BONDS = 20
"""Most bonds of a thing that tell what a pronoun after it means."""
_BY_OWNER = (
    "next_to", "near", "in_front_of", "behind", "left_of", "right_of", "at_foot_of", "between", "opposite", "far",
)  # fmt: skip
"""Relations that are rather about what has a thing than about the thing."""
_STOOD = ("storage", "tables", "desks", "counters", "worktops", "seats", "lounges", "beds")
"""Groups of what stands, though some of it could be fixed to a wall."""
_STANDING = ("along", "against")
"""Prepositions before a wall that say where things stand rather than hang."""
_SHARED = (
    "next_to", "near", "by", "against", "along", "facing", "opposite", "in_front_of", "behind", "left_of", "right_of",
)  # fmt: skip
"""Prepositions after two joined things that tell where both are."""
_JOINED = {"on": "small", "inside": "small", "against_wall": "wallpieces", "above": "wallpieces", "around": "seats"}
"""Relations that all of a list share, and what kind of things then do."""

_BESIDE_SMALL = ("next_to", "near", "by", "behind", "in_front_of", "left_of", "right_of")
"""Where small things that are listed together stand to another, all of them."""
_SET_AROUND = ("around", "at", "facing", "opposite")
_SAT_ON = ("seats", "chairs", "lounges")
"""What is set around a table, or faces something, with what lies on it: "chairs with cushions around a table"."""


class Subjects(Having):
    """Finds the subjects of relations."""

    def _whole_subject(self) -> Node | None:
        """Everything that the clause named before its verb."""
        node = next((n for n in self.frontier if n.frame is not None and n.things and n.frame.head is None), None)
        node = node or next((n for n in self.frontier if n.frame is not None and n.things), None)
        if node is None:
            return None
        things = [t for t in self.clause.members if t in self.draft.things]
        if node.known or not things:
            things = [t for t in node.things if t in self.draft.things] or things
            things = list(dict.fromkeys([*[m for m in self.clause.members if m in self.draft.things], *things]))
        return Node(things, self.clause, known=node.known, each=node.each or self.each) if things else None

    def _subject_of(self, where: Where) -> Node | None:
        """What a relation that follows is about; None when nothing was named yet."""
        nodes = [node for node in reversed(self.frontier) if node.things]
        if not nodes:
            return self.subject
        if self.predicate and self.subject is not None and len(self.frontier) <= 1:
            return self.subject
        if where.text.lower().startswith("all ") and self.separator:
            every = [t for m in self.clause.members if m in self.draft.things for t in self.referents.family(m)]
            last = nodes[0].things[-1]
            rows = last.many and (last.rows != 0 or any(b.kind == "in_rows" for b in self.draft.bonds_of(last)))
            if len(every) > 1 and not rows:
                return Node(list(dict.fromkeys(every)), self.clause)
        inner = nodes[0]
        if len(run := self._run_to(inner.things[-1], where)) > 1:
            return Node(run, self.clause)
        if (alike := self._told_apart_by_looks(inner)) is not None:
            return alike
        if inner.frame is None:
            return self._past_anchor(nodes, where)
        head = inner.frame.head
        if head is not None and head.things and self._lie_together(inner, inner.frame, head, where):
            holds = self._contains(head.things[-1]) or self._is_served_there(inner.things[-1], inner.frame)
            return self._joined(head, where) if holds else Node([*head.things, *inner.things], head.frame)
        floor = where.word == "on" and where.noun is not None and where.noun.value == "floor"
        if head is not None and head.things and not floor and self._is_of_head(inner, inner.frame, head, where):
            return self._joined(head, where) if inner.frame.contents and head.frame is not None else head
        return self._joined(inner, where)

    def _run_to(self, last: Mention, where: Where) -> list[Mention]:
        """All of "a fridge, a stove and a sink along one wall", which are built in one line."""
        wall = where.noun is not None and where.noun.kind == "place" and "wall" in where.noun.value
        if not wall or where.word not in _STANDING:
            return []
        named = (t for t in self.clause.members if self.habits.is_in(t.noun, "built_in_line", "built_in"))
        run = [t for t in named if t in self.draft.things and all(b.implied for b in self.draft.bonds_of(t))]
        return run if last in run else []

    def _told_apart_by_looks(self, node: Node) -> Node | None:
        """All of "two armchairs, one green and one blue, facing it", "two boxes, one on the other, by the door"."""
        comma = self._is_link(self.chunks[self._began - 1] if self._began else None, "mark", "comma")
        family = self.referents.family(node.things[-1])
        parted = comma and len(family) > 1 and len(node.things) == 1
        among = parted and all(set(b.anchors) <= set(family) for t in family for b in self.draft.bonds_of(t))
        if among and any(self.draft.bonds_of(t) for t in family):
            return Node(list(family), node.frame)
        if not parted or any(not b.implied for t in family for b in self.draft.bonds_of(t)):
            return None
        looks = [tuple(t.attributes) for t in family]
        return Node(list(family), node.frame) if len(set(looks)) == len(looks) else None

    def _lie_together(self, inner: Node, frame: Listed, head: Node, where: Where) -> bool:
        """Whether both lie there: "a pitcher with glasses on a side table"."""
        noun, owner = where.noun, head.things[-1]
        if noun is None or noun.kind != "thing" or where.word not in ("on", "on_top") or frame.each:
            return False
        small = is_small(owner) and is_small(inner.things[-1])
        return small and all(bond.implied for bond in self.draft.bonds_of(owner)) and not self._is_head(noun, head)

    def _is_of_head(self, inner: Node, frame: Listed, head: Node, where: Where) -> bool:
        """Whether a relation after the last thing of a list is about what has the list."""
        thing, noun = inner.things[-1], where.noun
        held = self._is_held(thing, frame) or frame.kind == "with"
        if self._is_at_room_part(where) and held and not (frame.each or self._is_end_of_top(where, thing, head)):
            return True
        if frame.contents and (len(frame.members) == 1 or frame.closing):
            return True
        held = frame.kind in ("hold", "carry", "inside") and self._is_held(thing, frame)
        if held and not frame.each and self._is_side_of_room(where):
            return True
        if where.word == "facing" and any(b.told and b.anchors == (head.thing,) for b in self.draft.bonds_of(thing)):
            return not frame.each and not self.habits.is_in(thing.noun, "seats")
        middle = noun is not None and noun.value in ("centre", "middle") and where.whole is None
        if middle and (thing.many or self._is_told_of(thing, head)) and not frame.each:
            return True
        if not self._is_pronominal(where):
            return noun is not None and self._is_said_of_head(thing, frame, head, where)
        if self._is_rather_of_head(thing, frame, head, where) or self._is_beside_outer(thing, frame, head, where):
            return True
        if where.word == "between" and self._belongs(thing.noun, "small") and not head.things[-1].many:
            return self._is_between_others(thing, frame, head, where)
        if where.word not in (*_BY_OWNER, "above", "under") or noun is None or noun.kind != "pronoun":
            return False
        lying = [b for b in self.draft.bonds_of(thing) if b.implied and b.kind in ("on", "inside")]
        within = bool(lying) and lying[0].kind == "inside" and len(self.clause.members) > 1
        within &= where.word in _BY_OWNER and not self.habits.is_in(thing.noun, "plants", "lamps")
        return bool(lying) and (within or self._behind_its_carrier(head, where))

    def _is_at_foot_of_another(self, thing: Mention, frame: Listed, head: Node, where: Where) -> bool:
        """Whether "its foot" is that of a bed at which the head stands: "a bench with a blanket at its foot"."""
        end = where.noun is not None and where.noun.kind == "part" and where.noun.value in ("foot", "head")
        its = end and where.whole is None and not self.habits.is_in(head.things[-1].noun, "beds", "tables")
        return its and self._is_held(thing, frame) and not frame.each

    def _is_other_side_of_before(self, thing: Mention, frame: Listed, where: Where) -> bool:
        """Whether "its right" is of what has its left: "a stool on its left and a cart with jars on its right"."""
        side, sided = where.noun, self.meanings.sided
        its = side is not None and side.kind == "part" and side.det == "my" and where.whole is None
        across = side is not None and sided is not None and {side.value, sided[0]} == {"left", "right"}
        across &= frame.head is None or sided is None or sided[1] not in frame.head.things
        return its and across and self._is_held(thing, frame) and not frame.each

    def _is_said_of_head(self, thing: Mention, frame: Listed, head: Node, where: Where) -> bool:
        """Whether what is told without a pronoun is about what has the list."""
        if where.noun is None or self._is_of_member(where, frame):
            return False
        if where.word in _SET_AROUND and is_small(thing) and self.habits.is_in(head.things[-1].noun, *_SAT_ON):
            return True
        if self._is_beside_whole(thing, frame, head, where) or self._is_place_of_head(thing, frame, where, where.noun):
            return True
        return self._is_beside_head(thing, frame, head, where, where.noun)

    def _is_of_member(self, where: Where, frame: Listed) -> bool:
        """Whether it is to something of the same list: "a desk with a monitor, a keyboard in front of the monitor"."""
        anchor = where.whole or where.noun
        named = anchor is not None and anchor.kind == "thing" and anchor.definite
        return named and anchor is not None and self.referents.named(anchor) in frame.members

    def _is_beside_outer(self, thing: Mention, frame: Listed, head: Node, where: Where) -> bool:
        """Whether "its right" is of what has the head: "each with a stool and a trolley with towels on its right"."""
        if self._is_other_side_of_before(thing, frame, where) or self._is_at_foot_of_another(thing, frame, head, where):
            return True
        outer = head.frame.head if head.frame is not None else None
        side = where.noun is not None and where.noun.kind == "part" and where.noun.det == "my" and where.whole is None
        side = side and where.noun is not None and where.noun.value in SIDES
        return outer is not None and bool(outer.things) and side and self._is_held(thing, frame)

    def _is_between_others(self, thing: Mention, frame: Listed, head: Node, where: Where) -> bool:
        """Whether what has a small thing stands between two others: "racks, barrels, a table with a jug in between"."""
        others = [m for m in self.clause.members if m not in head.things]
        apart = where.noun is None and len(others) >= _PAIR
        return apart or not any(member.many for member in frame.members if member is not thing)

    def _is_rather_of_head(self, thing: Mention, frame: Listed, head: Node, where: Where) -> bool:
        """Whether "it" is neither the head nor in its list, or not said: "three crates with parcels under it"."""
        noun = where.noun
        seated = any(b.implied and b.kind in ("at", "around") for b in self.draft.bonds_of(thing))
        if noun is None:
            return where.word in ("opposite", "behind", "between") and seated and not frame.each
        inside = any(b.kind == "inside" and b.told and b.anchors == (head.thing,) for b in self.draft.bonds_of(thing))
        if noun.kind == "pronoun" and inside and where.word in _BY_OWNER and not frame.each:
            return True
        owner = head.things[-1]
        if noun.value == "them" and where.word == "between" and seated and not (owner.many or frame.each):
            return True
        if noun.kind != "pronoun" or frame.each or not self._is_held(thing, frame):
            return False
        if noun.value == "them" and where.word in _BY_OWNER and len(frame.members) == 1 and not owner.many:
            them = self.referents.several([thing], where.word)
            return bool(them) and not any(is_small(t) or t is owner for t in them)
        if noun.value != "it":
            return False
        nested = head.frame is not None and head.frame.head is not None and self._contains(owner) and is_small(owner)
        if where.word in ("on", "on_top") and nested and len(frame.members) == 1:
            return True
        outer = head.frame.head if head.frame is not None else None
        if where.word in _BY_OWNER and frame.kind in ("hold", "carry", "inside") and outer is not None and outer.things:
            return True
        several = owner.many and not (owner.rows or owner.groups or owner in self.referents.shared)
        return several and where.word not in ("on", "in") and len(frame.members) == 1

    def _is_at_room_part(self, where: Where) -> bool:
        """Whether "at the front", "at the other" says where in the room something stands."""
        noun = where.noun
        if noun is None or where.word not in ("at", "in", "to"):
            return False
        if noun.kind == "part":
            whole = where.whole is None or where.whole.kind in ("room", "place", "abstract")
            of_thing = noun.det == "my" or noun.plural or noun.det in ("each", "either", "both")
            return whole and not of_thing and not self.meanings.is_other_end(noun) and noun.value in _ROOM_PARTS
        return noun.kind in ("pronoun", "number") and "other" in noun.text.lower().split() and not noun.of_known

    def _is_beside_whole(self, thing: Mention, frame: Listed, head: Node, where: Where) -> bool:
        """Whether the owner is at a side of another thing: "a nightstand with a clock on the left of the bed"."""
        whole = where.whole
        if whole is None and where.noun is not None and where.noun.owner:
            whole = Noun("thing", where.noun.owner, where.noun.start, where.noun.end, where.noun.owner, det="the")
        if whole is None or whole.kind not in ("thing", "place") or where.noun is None or where.noun.kind != "part":
            return False
        if where.noun.value in ("top", "inside", "in_shelf"):
            return False
        if where.noun.value == "middle" and not is_small(head.things[-1]):
            return False
        held = (self._is_held(thing, frame) or self._is_told_of(thing, head)) and not frame.each
        within = is_small(head.things[-1]) and any(b.kind == "inside" for b in self.draft.bonds_of(thing))
        return held and not self._is_head(whole, head) and (within or not self.habits.is_in(whole.value, "small"))

    def _is_end_of_top(self, where: Where, thing: Mention, head: Node) -> bool:
        """Whether "at one end" is of what something lies on: "a sideboard with a lamp at one end"."""
        ends = where.noun is not None and where.noun.value == "end" and where.whole is None
        lies = any(b.kind == "on" and b.anchors == (head.thing,) for b in self.draft.bonds_of(thing))
        return ends and lies and self._belongs(head.things[-1].noun, "surfaces")

    def _is_side_of_room(self, where: Where) -> bool:
        """Whether "on the left" says where furniture stands: "shelves for shoes on the left"."""
        noun = where.noun
        side = noun is not None and noun.kind == "part" and noun.value in SIDES and noun.det == "the"
        return side and where.whole is None and noun is not None and not noun.owner

    def _is_told_of(self, thing: Mention, head: Node) -> bool:
        """Whether a pronoun told where it is to the head: "a bench with a can under it by the door"."""
        return any(b.told and not b.negated and b.anchors == (head.thing,) for b in self.draft.bonds_of(thing))

    def _is_place_of_head(self, thing: Mention, frame: Listed, where: Where, noun: Noun) -> bool:
        """Whether a place is where the owner stands: "a desk with a chair by the window"."""
        if self._is_link(self.peek(), "prepositions") and self._is_pronoun_next():
            return False
        if noun.kind != "place" or (noun.value == "centre" and where.whole is None):
            return False
        if frame.each and not self._goes_with_its_head(thing, frame):
            return False
        on_surface = noun.value in ("wall", "floor", "ceiling") and where.word == "on"
        within = any(b.told and b.kind == "inside" for b in self.draft.bonds_of(thing))
        on_surface = on_surface and not self._is_held(thing, frame) and not within
        hung = self.habits.is_in(thing.noun, "wallpieces", "ceiling")
        heads = frame.head.things if frame.head is not None else []
        hung &= where.word not in _STANDING or any(self.habits.is_in(t.noun, "wallpieces") for t in heads)
        return not on_surface and not (hung and not self._hangs_over_head(thing, heads, noun))

    def _hangs_over_head(self, thing: Mention, heads: list[Mention], noun: Noun) -> bool:
        """Whether furniture stands at a wall above which its own hangs: "a sofa with a picture on the back wall"."""
        free = len(heads) == 1 and not heads[0].many and not self.draft.bonds_of(heads[0])
        certain = noun.value.endswith("_wall") and not thing.many
        return free and certain and self.habits.tie(thing.noun, heads[0].noun) == "above"

    def _goes_with_its_head(self, thing: Mention, frame: Listed) -> bool:
        """Whether each stands at what has it, or lies on it: "three tables each with two chairs by the window"."""
        heads = frame.head.things if frame.head is not None else []
        kinds = ("around", "at", "on", "inside")
        return any(b.implied and b.kind in kinds and set(b.anchors) & set(heads) for b in self.draft.bonds_of(thing))

    def _is_pronoun_next(self) -> bool:
        """Whether "it" comes after the next preposition: "with four screens on the wall above it"."""
        noun = self._next_noun(1)
        return noun is not None and noun.kind == "pronoun" and noun.value == "it"

    def _is_within(self, noun: Noun, frame: Listed) -> bool:
        """Whether it is something of the same list."""
        return self.referents.named(noun) in frame.members

    def _is_held(self, thing: Mention, frame: Listed) -> bool:
        """Whether it lies on or in what has it: "a shelf with six toys above the table"."""
        heads = frame.head.things if frame.head is not None else []
        held = (
            b for b in self.draft.bonds_of(thing) if b.kind in ("on", "inside") and (b.implied or frame.kind != "with")
        )
        return any(a in heads for bond in held for a in bond.anchors)

    def _is_served_there(self, thing: Mention, frame: Listed) -> bool:
        """Whether it lies on what has it, as cups on a tray; the glass of "a plate with a roll and a glass" not."""
        head, first = frame.head, frame.members[0]
        plate = head is not None and max(kind_of(head.things[-1].noun).size) <= _PLATE
        drink = plate and first is not thing and _is_cup(thing) and not _is_cup(first)
        return self._is_held(thing, frame) and not drink

    def _is_listed(self, noun: Noun, frame: Listed) -> bool:
        """Whether "each chair" is of the list itself: "a table with two chairs and a plate in front of each chair"."""
        return any(found in frame.members for found in self.referents.every(noun))

    def _stands_at(self, noun: Noun, head: Node) -> bool:
        """Whether "each chair" is one of those at what has a thing: "two benches at a table with a cup at each"."""
        seats = noun.value == "seat" and not noun.named
        several = self._seats() if seats else self.referents.every(noun)
        return any(set(b.anchors) & set(head.things) for thing in several for b in self.draft.bonds_of(thing))

    def _is_beside_head(self, thing: Mention, frame: Listed, head: Node, where: Where, noun: Noun) -> bool:
        """Whether the owner is beside another thing: "a desk with a chair next to the bed"."""
        held_there = held = self._is_held(thing, frame) and not frame.each
        held = held and where.word in ("above", "under", "against", "by", "at")
        if where.word == "on" and self.habits.is_in(noun.value, "covers") and self.habits.is_in(thing.noun, "seats"):
            return not frame.each
        told = where.word in _BY_OWNER and noun.kind == "thing" and not frame.each and self._is_told_of(thing, head)
        if told and not (self._is_head(noun, head) or self._is_within(noun, frame)):
            return True
        if noun.kind != "thing" or self._is_head(noun, head):
            return False
        if self._is_over_wall_thing(thing, frame, where, noun):
            return True
        if not (where.word in _BY_OWNER or held):
            return False
        lying = self.habits.is_in(noun.value, "small") and not self.habits.is_in(noun.value, "built_in")
        if held and (lying or self._is_within(noun, frame)):
            return False
        if held_there and where.word == "between" and lying:
            return False
        listed = noun.each and thing.owner is not None and self._is_listed(noun, frame)
        if listed or (noun.each and self._stands_at(noun, head)):
            return False
        beside = held_there and where.word in _BY_OWNER and not lying
        return beside or self.habits.is_in(thing.noun, "small", "seats", "lamps")

    def _is_over_wall_thing(self, thing: Mention, frame: Listed, where: Where, noun: Noun) -> bool:
        """Whether the owner is below what hangs on a wall: "a table with four chairs under the clock"."""
        known = self.referents.named(noun) if noun.definite else None
        if known is None or frame.each or where.word not in ("above", "under"):
            return False
        hangs = kind_of(known.noun).mount == "wall" or any(
            str(a).endswith("wall") for b in self.draft.bonds_of(known) if b.kind == "on" for a in b.anchors
        )
        return hangs and all(bond.implied for bond in self.draft.bonds_of(thing))

    def _behind_its_carrier(self, head: Node, where: Where) -> bool:
        """Whether "it" is something before the shelves: "a counter, shelves with bottles behind it"."""
        before = [m for m in self.clause.members if m not in head.things]
        if where.word in ("above", "under"):
            held = self.habits.is_in(head.things[-1].noun, "wallpieces", "shelves")
            return bool(before) and held and where.noun is not None and where.noun.value == "it"
        counter = self.habits.is_in(head.things[-1].noun, "counters", "desks", "tables")
        return where.word in ("behind", "in_front_of", "opposite") and bool(before) and not counter

    def _is_head(self, noun: Noun, head: Node) -> bool:
        found = self.referents.named(noun) if noun.definite or noun.each else None
        return found in head.things

    def _is_pronominal(self, where: Where) -> bool:
        noun = where.noun
        if noun is None:
            return True
        if noun.kind == "pronoun":
            return True
        if noun.kind == "part":
            return (where.whole is None and not noun.owner) or (
                where.whole is not None and where.whole.kind == "pronoun"
            )
        return False

    def _is_first_named(self, anchor: Node, where: Where) -> bool:
        """Whether a thing follows that was just named for the first time: "a sign above the shelves behind ..."."""
        thing = where.noun is not None and where.noun.kind == "thing" and where.word not in ("facing", "opposite")
        index = self._began - 1
        while index > 1 and self._is_link(self.chunks[index - 1], "prepositions", "of"):
            index -= 2
        before = self.chunks[index] if index >= 0 else None
        named = self.named_by.get(anchor.things[-1])
        return thing and not self.separator and named is not None and named is before

    def _is_faced_there(self, anchor: Node, where: Where) -> bool:
        """Whether a place follows where what is faced is, named for the first time: "facing the altar at the front"."""
        place = where.noun is not None and where.noun.kind == "place"
        before = self.chunks[self._began - 1] if self._began else None
        if not (place or self._is_at_room_part(where)):
            return False
        link = self.chunks[self._began - 2] if self._began > 1 else None
        faced = self._is_link(link, "prepositions", "facing", "opposite") or self._is_link(link, "verbs", "face")
        return faced and before is not None and self.named_by.get(anchor.things[-1]) is before

    def _past_anchor(self, nodes: list[Node], where: Where) -> Node:
        """After an anchor: "a vase on a table by the window", "a chair next to the bed by the window"."""
        inner = nodes[0]
        subject = next((n for n in nodes if n.frame is not None), None) or self.subject
        if subject is None or self._is_faced_there(inner, where):
            return inner
        carries = any(
            b.kind in ("on", "inside") and inner.things[-1] in b.anchors
            for b in self.draft.bonds_of(subject.things[-1])
        )
        if carries and self._is_between_small(where, inner):
            return subject
        apart = self.separator == "comma" and inner.known and not self._is_pronominal(where)
        known = inner.known and not (carries or is_small(subject.things[-1]) or self._is_first_named(inner, where))
        if inner.told or where.negated or apart or known:
            return subject
        thing = inner.things[-1]
        if carries and self._is_at_room_part(where):
            return inner
        lying = carries and is_small(subject.things[-1]) and not is_small(thing)
        between = self._is_pronominal(where) and where.word == "between"
        if between and lying:
            return inner
        if between or self.habits.is_in(thing.noun, "covers"):
            return subject
        if (
            where.noun is not None
            and where.noun.kind == "part"
            and where.noun.value == "middle"
            and not is_small(thing)
        ):
            return inner
        if self._is_pronominal(where) and where.noun is not None:
            aside = not is_small(thing) and is_small(subject.things[-1])
            beside = where.word in _BY_OWNER or where.noun.value in SIDES
            return subject if aside and (inner.known or not beside) else inner
        return inner

    def _is_between_small(self, where: Where, carrier: Node) -> bool:
        """Whether what lies on something is between small things there: "a book on the shelf between two bookends"."""
        noun = where.noun
        small = where.word == "between" and noun is not None and noun.kind == "thing"
        small = small and noun is not None and self._belongs(noun.value, "small")
        return small and not is_small(carrier.things[-1])

    def _joined(self, node: Node, where: Where) -> Node:
        """A list that shares what is said of its last member: "a vase and two candles on the table"."""
        thing = node.things[-1]
        frame = node.frame
        together = self._under_raised(node, where) or self._named_with(node) or self._laid_with(node, where)
        if together:
            return Node(together, frame)
        of_member = frame is not None and where.whole is not None and self._is_of_member(where, frame)
        if frame is None or len(frame.members) < 2 or not frame.closing or len(node.things) > 1 or of_member:
            return node
        if untied := self._untied_before(node, frame, where) or self._between_too(node, frame, where):
            return Node([*untied, *node.things], frame)
        if where.noun is not None and where.noun.kind == "place" and "same" in where.noun.text.lower().split():
            return Node([m for m in frame.members if m in self.draft.things], frame)
        middle = where.noun is not None and where.noun.value in ("middle", "centre")
        several = len(frame.members) > _PAIR or (is_small(thing) and any(m.many for m in frame.members))
        if (several and middle) or not self._ends_list(node):
            return node
        kind = "on" if where.word == "on" else "inside" if where.word == "in" else where.word
        kind = (
            "against_wall"
            if where.noun is not None and where.noun.kind == "place" and "wall" in where.noun.value
            else kind
        )
        lies = kind in ("on_top", "inside") or (kind == "at" and where.noun is not None and where.noun.each)
        group = _JOINED.get("on" if lies else kind)
        hung = where.word == "on" and kind == "against_wall" and _hangs(thing.noun)
        any_kind = kind == "against_wall" and not hung and not self._belongs(thing.noun, "wallpieces")
        on_thing = kind in ("on", "inside") and where.noun is not None and where.noun.kind == "thing"
        on_thing |= kind == "inside" and where.noun is None
        any_kind |= on_thing and not self._is_furniture(thing)
        any_kind |= kind in ("at", "on") and where.noun is not None and where.noun.value == "each"
        corner = where.noun is not None and where.noun.value.startswith("corner")
        two = len(frame.members[frame.begun :]) == _PAIR
        rug = on_thing and two and where.noun is not None and self.habits.is_in(where.noun.value, "covers")
        if (group is None or any_kind or corner or rug) and (pair := self._pair(node, frame, where)) is not None:
            return pair
        if group is None or not (any_kind or hung or self._belongs(thing.noun, group)):
            return node
        each = where.noun is not None and where.noun.kind == "pronoun" and where.noun.value == "each"
        leaning = self._is_leaning()
        taken = self._taken(frame, thing)
        free: list[Mention] = []
        for member in reversed(frame.members[frame.begun :]):
            alike = (
                (leaning and _is_thin(member))
                or self._belongs(member.noun, group)
                or self._may_hang_there(member, where)
            )
            alike |= each and (is_small(member) or not member.many)
            alike |= on_thing and self._may_lie_there(member)
            if member is not thing and (member in taken or not alike or self._is_placed_itself(member)):
                break
            free.insert(0, member)
        return Node(free, frame) if len(free) > 1 else node

    def _laid_with(self, node: Node, where: Where) -> list[Mention]:
        """All of "a plate, a fork and a glass in front of each chair"; empty for what is not laid at seats."""
        noun, frame, last = where.noun, node.frame, node.things[-1]
        seats = noun is not None and noun.each and (noun.value == "seat" or self.habits.is_in(noun.value, "seats"))
        if not seats or frame is None or len(node.things) > 1 or not self._ends_list(node):
            return []
        listed = frame.members[: frame.members.index(last) + 1] if last in frame.members else []
        laid = [*takewhile(self._is_one_to_lay, reversed(listed))]
        return laid[::-1] if len(laid) > 1 else []

    def _is_one_to_lay(self, thing: Mention) -> bool:
        """Whether one small thing was named, and nobody said where it is."""
        untold = all(bond.implied and not bond.each for bond in self.draft.bonds_of(thing))
        return untold and is_small(thing) and thing.count in (None, 1)

    def _is_placed_itself(self, thing: Mention) -> bool:
        """Whether its own words say where it is, though nothing may have been made of that."""
        named = self.named_by.get(thing)
        for at in range(self._began - 1, max(self._began - LOOKAHEAD, 0), -1):
            if self.chunks[at] is named:
                link = self.chunks[at + 1]
                return self._is_link(link, "prepositions") and not self._is_link(link, "prepositions", *_NO_PLACE)
        return False

    def _ends_list(self, node: Node) -> bool:
        """Whether it was named right after an "and", which others are joined by to it."""
        named = self.named_by.get(node.things[-1])
        for at in range(self._began - 1, 0, -1):
            if self.chunks[at] is named:
                return self._is_link(self.chunks[at - 1], "joins") or self._is_link(self.chunks[at - 1], "mark", "and")
        return True

    def _may_lie_there(self, thing: Mention) -> bool:
        """Whether it can stand or lie where other small things do."""
        return _may_lie(thing) or last_word(thing) in grammar().lists["set_on"] or is_loose_lamp(thing)

    def _may_hang_there(self, thing: Mention, where: Where) -> bool:
        """Whether it can hang where it is said to be: a standing mirror "on the walls"."""
        place = where.noun.value if where.noun is not None and where.noun.kind == "place" else ""
        hangs = where.word == "on" and "wall" in place and not self.habits.is_in(thing.noun, *_STOOD)
        return hangs and mount_of(kind_of(thing.noun), (WALL_MOUNTED,)) == "wall"

    def _taken(self, frame: Listed, thing: Mention) -> list[Mention]:
        """What of a list has a place of its own, which it does not share with its last thing."""
        shared = [(b.kind, b.anchors) for b in self.draft.bonds_of(thing) if frame.head is None]
        taken = [
            m
            for m in frame.members
            if any(not b.implied and (b.kind, b.anchors) not in shared for b in self.draft.bonds_of(m))
        ]
        told = [b for b in self.draft.bonds if not b.implied]
        return taken + [m for m in frame.members if any(m in b.anchors and not _is_filled(m, b) for b in told)]

    def _named_with(self, node: Node) -> list[Mention]:
        """Both of "a green and a black chair", which are where the last is said to be; empty for other things."""
        thing, members = node.things[-1], node.frame.members if node.frame is not None else []
        before = reversed(members[: members.index(thing) if thing in members else 0])
        alike = [*takewhile(lambda member: member.noun == thing.noun and self._is_borrowed(member), before)]
        return [*alike[::-1], *node.things] if alike else []

    def _is_borrowed(self, thing: Mention) -> bool:
        """Whether the noun it was named by is that of what came after it."""
        said = self.named_by.get(thing)
        return said is not None and bool(said.looks)

    def _under_raised(self, node: Node, where: Where) -> list[Mention]:
        """The furniture that stands under what is raised over it: "a loft bed, a desk and a chair below it"."""
        noun, things = where.noun, self.draft.things
        if where.word != "under" or len(node.things) > 1 or not self._is_joined_before(self._began):
            return []
        if noun is None or noun.value == "it":
            raised = [at for at, thing in enumerate(things) if is_raised(thing.noun, thing.attributes)]
            since = raised[-1] + 1 if raised else len(things)
        elif noun.kind == "thing" and is_raised(noun.value, noun.attributes):
            since = 0
        else:
            return []
        named = {t for start in self._of_clause() for t in self.meant.get(start, ())}
        return [t for t in things[since:] if t in named and self._is_free(t) and self._is_furniture(t)]

    def _of_clause(self) -> list[int]:
        """The first tokens of what was named since the last mark that ended a sentence."""
        return [chunk.start for chunk in self.chunks[self._clause_start() : self._began]]

    def _untied_before(self, node: Node, frame: Listed, where: Where) -> list[Mention]:
        """What else the head has, where only the last tells how: the cues of "a table with cues and a ball on it"."""
        if frame.head is None or not self._is_pronominal(where):
            return []
        if where.word in _BY_OWNER:
            untied = [thing for thing, head in self.untied if head in frame.head.things and _stands(thing)]
            return untied if untied == frame.members[:-1] and all(map(self._is_free, untied)) else []
        if frame.each:
            return [m for m in frame.members if m not in node.things and self._is_merely_beside(m, frame.head, node)]
        untied = [thing for thing, head in self.untied if head in frame.head.things]
        return [m for m in frame.members if m in untied and m not in node.things and self._is_free(m)]

    def _between_too(self, node: Node, frame: Listed, where: Where) -> list[Mention]:
        """The nightstand of "two beds with a nightstand and a phone between them"."""
        them = where.noun is None or (where.noun.kind == "pronoun" and where.noun.value == "them")
        pair = where.word == "between" and them and frame.head is not None and len(frame.members) == _PAIR
        other = frame.members[0]
        told = any(not b.implied for b in self.draft.bonds_of(other))
        return [other] if pair and not told and other not in node.things and not other.many else []

    def _is_free(self, thing: Mention) -> bool:
        return not self.draft.bonds_of(thing)

    def _is_merely_beside(self, thing: Mention, head: Node, node: Node) -> bool:
        """Whether nothing but that each of several has it says where it is, and it stands as what comes after it."""
        bonds = self.draft.bonds_of(thing)
        usual = self.habits.tie(thing.noun, head.things[-1].noun)
        beside = bool(bonds) and all(b.implied and b.kind == "next_to" for b in bonds)
        may_lie = is_small(thing) or any(self.habits.is_in(sense.category, "small") for sense in senses_of(thing.noun))
        return beside and usual is None and (is_small(thing) == is_small(node.things[-1]) or may_lie)

    def _pair(self, node: Node, frame: Listed, where: Where) -> Node | None:
        """Two that are joined and of which nothing was told: "a scale and a chart next to the door"."""
        alone = self.separator != "and" and self._is_joined_before(self._began)
        other = frame.members[-2]
        if alone and frame.head is None and where.word in _BESIDE_SMALL and self._is_small_list(frame):
            return Node(frame.members[frame.begun :], frame)
        if alone and self._is_pronominal(where) and is_small(other) and is_small(node.things[-1]):
            if self._is_all_beside_head(frame, where):
                return Node(frame.members[frame.begun :], frame)
            known = any(b for b in self.draft.bonds_of(other)) or any(other in b.anchors for b in self.draft.bonds)
            return None if known or frame.head is not None or where.noun is None else Node([other, *node.things], frame)
        wall = where.word == "on" and where.noun is not None and where.noun.value.endswith("wall")
        upright = not is_small(node.things[-1]) or self.habits.is_in(node.things[-1].noun, "built_in")
        shared = where.word in (*_SHARED, "at") or (wall and upright) or self._is_one_phrase(other, node.things[-1])
        shared |= where.noun is not None and where.noun.value.startswith("corner") and self._begins_with(other)
        shared |= where.word == "on" and where.noun is not None and self.habits.is_in(where.noun.value, "covers")
        if not alone or not shared or any(not b.implied for b in self.draft.bonds_of(other)):
            return None
        noun = where.noun
        told = noun is not None and (noun.kind in ("thing", "place") or noun.value == "other")
        if noun is None or not told or frame.head is not None or noun.value == "centre":
            return None
        if other in self.referents.shared or any(other in b.anchors for b in self.draft.bonds):
            return None
        if where.word == "behind" and self.habits.is_in(other.noun, "visits"):
            return None  # Visitors sit across the desk, whatever is behind it.
        anchors = self.referents.named(noun)
        if where.word in _STANDING and self._is_one_list(frame):
            return Node(frame.members[frame.begun :], frame)
        return None if anchors is other else Node([other, *node.things], frame)

    def _is_one_list(self, frame: Listed) -> bool:
        """Whether furniture of which nothing was told begins the statement: "a fridge, a sink and a stove along"."""
        listed = frame.members[frame.begun :]
        free = all(not is_small(m) and all(b.implied for b in self.draft.bonds_of(m)) for m in listed)
        return free and len(listed) > _PAIR and self._begins_with(listed[0])

    def _is_all_beside_head(self, frame: Listed, where: Where) -> bool:
        """Whether small things are said to be beside each small head: "each bowl with a fork and a spoon by it"."""
        head = frame.head.thing if frame.head is not None else None
        free = all(b.implied for member in frame.members for b in self.draft.bonds_of(member))
        it = where.noun is not None and where.noun.value == "it" and where.word in _BESIDE_SMALL
        return it and frame.each and free and head is not None and is_small(head)

    def _is_small_list(self, frame: Listed) -> bool:
        """The same of small things: "a clock, a cup and a phone next to the lamp"."""
        listed = frame.members[frame.begun :]
        lie = all(is_small(m) or self._may_lie_there(m) for m in listed)
        free = lie and all(all(b.implied for b in self.draft.bonds_of(m)) for m in listed)
        return free and len(listed) > _PAIR and self._begins_with(listed[0])

    def _begins_with(self, thing: Mention) -> bool:
        """Whether a statement begins with a thing: "A mop and a broom in the corner."."""
        first = self.chunks[self._clause_start()]
        return isinstance(first, Noun) and first is self.named_by.get(thing)

    def _is_one_phrase(self, one: Mention, other: Mention) -> bool:
        """Whether two have one article: "a steel toilet and sink"."""
        first, second = self.named_by.get(one), self.named_by.get(other)
        if first is None or second is None or second.det or second.count is not None or second.plural:
            return False
        return first.det == "a"

    def _partner(self, node: Node, where: Where, meaning: Meaning) -> Mention | None:
        """What is beside the same thing, as it is joined to it: "a boiler by the door, a mop and a pail beside it"."""
        frame = node.frame
        alone = self.separator != "and" and self._is_joined_before(self._began) and len(node.things) == 1
        if frame is None or frame.head is not None or len(frame.members) < _PAIR or not alone:
            return None
        if where.noun is None or where.noun.kind != "pronoun" or where.word not in _SHARED:
            return None
        other = frame.members[-2]
        told = any(not b.implied for b in self.draft.bonds_of(other)) or any(
            other in b.anchors for b in self.draft.bonds
        )
        return None if told or other in meaning.anchors or other not in self.draft.things else other

    def _is_furniture(self, thing: Mention) -> bool:
        """Whether it stands on the floor."""
        return self.habits.is_in(thing.noun, *FURNITURE)

    def _is_leaning(self) -> bool:
        """Whether they lean where they are: "two brooms and a mop leaning against the wall"."""
        said = self.chunks[self._began - 1] if self._began else None
        return isinstance(said, Connector) and said.text.lower() in grammar().lists["leaning"]

    def _likely(self, node: Node, *, elided: bool = False) -> list[Mention]:
        """What a pronoun means first: the head of the list, then what the clause is about; elided, what came before."""
        found: list[Mention] = []
        frame = node.frame
        if elided and frame is not None and frame.head is None and not self.predicate:
            found += self._elided_by(node, frame)
        for bond in (b for t in node.things for b in self.draft.bonds_of(t)[-_BONDS:]):
            found += [a for a in bond.anchors if isinstance(a, Mention) and not bond.negated]
        found += [t.host for t in node.things if t.host is not None]
        if frame is not None and frame.head is not None:
            found += frame.head.things
        if frame is not None and self._after_and(node):
            found += self._anchor_before(node)
        if self.subject is not None and self.subject is not node:
            found += self.subject.things
        member = next((m for m in reversed(self.clause.members) if m not in node.things), None)
        if member is not None:
            lying = [b for b in self.draft.bonds_of(member) if b.kind in ("on", "inside") and not b.negated]
            found += [a for b in lying for a in b.anchors if isinstance(a, Mention) and a in self.clause.members]
            found.append(member)
        for front in self.front:
            found += [a for a in front.anchors if isinstance(a, Mention)]
        denied = [b for t in node.things for b in self.draft.bonds_of(t)[-_BONDS:] if b.negated]
        found += [a for b in denied for a in b.anchors if isinstance(a, Mention)]
        return list(dict.fromkeys(t for t in found if t not in node.things))

    def _elided_by(self, node: Node, frame: Listed) -> list[Mention]:
        """What "above" is said of in a list: the thing before, or what that one was placed by with a pronoun."""
        before = [m for m in frame.members if m not in node.things][-1:]
        said = [b for m in before for b in self.draft.bonds_of(m) if b.told and not b.negated]
        return [a for b in said[-1:] for a in b.anchors if isinstance(a, Mention)] + before

    def _after_and(self, node: Node) -> bool:
        return node.frame is not None and len(node.frame.members) > 1 and node.frame.head is None

    def _anchor_before(self, node: Node) -> list[Mention]:
        """What the thing before it in the list was related to: "a lamp left of the laptop and a frame right of it"."""
        if node.frame is None:
            return []
        before = [m for m in node.frame.members if m not in node.things][-1:]
        said = [b for m in before for b in self.draft.bonds_of(m) if not b.implied]
        anchors = [a for b in said[-1:] for a in b.anchors if isinstance(a, Mention) and a not in self.fresh]
        return anchors if not (before and is_small(before[0]) and said and said[-1].kind == "on") else []


def is_raised(noun: str, attributes: Sequence[str]) -> bool:
    """Whether it is said to be of such a kind that furniture stands under it."""
    return kind_of(noun).forms.get("over", "") in attributes


def _is_filled(thing: Mention, bond: Bond) -> bool:
    """Whether it only says what a small thing holds, which itself may be anywhere."""
    return is_small(thing) and bond.kind in ("inside", "on")


def _is_cup(thing: Mention) -> bool:
    """Whether one drinks from it, or it is a drink in what one drinks from: "a glass of milk"."""
    return not grammar().lists["cups"].isdisjoint((last_word(thing), thing.noun, thing.noun.partition("_of_")[0]))


def _is_thin(thing: Mention) -> bool:
    """Whether it can lean against something: a broom and a ladder, but no stool."""
    size = kind_of(thing.noun).size
    return min(size) <= _THIN * max(size)


def _may_lie(thing: Mention) -> bool:
    """Whether it is nothing but a slim thing, which lies where others do: a paddle, a cue."""
    kind = kind_of(thing.noun)
    return kind.plain and sorted(kind.size)[1] <= _SLIM


def _hangs(noun: str) -> bool:
    """Whether a thing hangs where it is said to be on a wall, by itself or as what its name means there."""
    there = (sense.category for sense in senses_of(noun) if any("_wall" in said for said in sense.conditions))
    return any(kind_of(category).mount == "wall" for category in (noun, *there))


def _stands(thing: Mention) -> bool:
    return kind_of(thing.noun).mount == "floor"
