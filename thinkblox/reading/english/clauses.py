"""Chunks of an English text to a draft, clause by clause."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.attach import bind, relation_kind
from thinkblox.reading.draft import Bond, Draft, Gap, Mention
from thinkblox.reading.english.chunks import Adjective, Chunk, Link, Measured, Noun, Stray
from thinkblox.reading.english.meaning import Meanings, Namer
from thinkblox.reading.english.nodes import Frame, Front, Meaning, Node, Where
from thinkblox.reading.english.phrase import PARTS_OF_THINGS
from thinkblox.reading.english.plurals import singular
from thinkblox.reading.english.referents import Referents, is_small
from thinkblox.reading.sizes import Size

_ENDS = ("stop", "semicolon", "colon", "dash")
_GROUPS = (
    "station",
    "workstation",
    "set",
    "setting",
    "group",
    "bay",
    "cubicle",
    "pod",
    "cluster",
    "area",
    "zone",
    "unit",
    "place",
    "half",
    "section",
    "side",
    "wing",
    "row",
    "quarter",
)
"""Words for several things together, where "each" then says which."""
_ROOMY = 3.0
"""Two sides that are both longer than this are a room's, whatever they stand beside [m]."""
_BY_OWNER = (
    "next_to",
    "near",
    "in_front_of",
    "behind",
    "left_of",
    "right_of",
    "at_foot_of",
    "between",
    "opposite",
    "far",
)
_JOINED = {"on": "small", "inside": "small", "against_wall": "wallpieces", "above": "wallpieces", "around": "seats"}
_SIDEWARD = ("left_of", "right_of", "next_to", "in_front_of", "behind", "opposite")
_SEATED = ("at", "around", "at_long_side", "at_short_side", "next_to")
_CARRIED = ("on", "inside", "at", "around", "at_long_side", "at_short_side")


class Clauses(Namer):
    """Reads the chunks of one text."""

    def __init__(self, chunks: Sequence[Chunk]) -> None:
        self.chunks = list(chunks)
        self.at = 0
        self.draft = Draft()
        self.referents = Referents(self.draft)
        self.meanings = Meanings(self.referents, self)
        self.habits = load_habits()
        self.groups: dict[str, Mention] = {}
        self._begin()
        self.opening: Gap | None = None
        self.whole: Mention | None = None
        self.wanting_only = False
        self._began = 0
        self.fresh: set[int] = set()
        self.said = ""
        self.verb = ""
        self.bracket: tuple[list[Node], Frame, Node | None, bool] | None = None
        self.ordinals: dict[int, dict[int, Mention]] = {}

    def _begin(self) -> None:
        """Begin a clause."""
        self.frontier: list[Node] = []
        self.front: list[Front] = []
        self.clause = Frame()
        self.subject: Node | None = None
        self.relative: Node | None = None
        self.pending: Frame | None = None
        self.separator = ""
        self.predicate = False
        self.negating = False
        self.excluding = False
        self.leaving = False
        self.each = False
        self.excepting = False
        self.existential = False
        self.per_group = 0
        self.outer: Node | None = None
        self.crowd = 0
        self.held: list[Front] = []

    def read(self) -> Draft:
        """Read everything."""
        while self.at < len(self.chunks):
            chunk = self.chunks[self.at]
            self.at += 1
            match chunk:
                case Noun():
                    self._noun(chunk)
                case Link():
                    self._link(chunk)
                case Adjective():
                    self._adjective(chunk)
                case Measured():
                    self._measured(chunk.size)
                case Stray():
                    self.draft.unknown.append(chunk.text)
        self._drop_groups()
        return self.draft

    # --- what comes next

    def peek(self, ahead: int = 0) -> Chunk | None:
        """The chunk so many after the next one."""
        index = self.at + ahead
        return self.chunks[index] if 0 <= index < len(self.chunks) else None

    def _next_noun(self, ahead: int = 0) -> Noun | None:
        """The noun that comes next, past fillers."""
        index = self.at + ahead
        while index < len(self.chunks) and self._is_filler(self.chunks[index]):
            index += 1
        chunk = self.chunks[index] if index < len(self.chunks) else None
        return chunk if isinstance(chunk, Noun) else None

    def _is_filler(self, chunk: Chunk) -> bool:
        return (isinstance(chunk, Link) and chunk.sort in ("fillers",)) or (
            isinstance(chunk, Adjective) and not chunk.attributes
        )

    def _is_link(self, chunk: Chunk | None, sort: str, *values: str) -> bool:
        return isinstance(chunk, Link) and chunk.sort == sort and (not values or chunk.value in values)

    def _skip_fillers(self, index: int) -> int:
        while index < len(self.chunks) and self._is_filler(self.chunks[index]):
            index += 1
        return index

    # --- links

    def _link(self, link: Link) -> None:
        match link.sort:
            case "mark":
                self._mark(link)
            case "joins":
                self._join(link)
            case "prepositions":
                self._preposition(link)
            case "inverses":
                self._open(link.value)
            case "participles":
                self._participle(link.value)
            case "verbs":
                self._verb(link)
            case "negations":
                self._negation(link)
            case "mutual":
                self._mutual(link.value)

    def _mark(self, link: Link) -> None:
        match link.value:
            case "stop" | "semicolon" | "colon" | "dash":
                self._end(link.value)
            case "open":
                self.bracket = (list(self.frontier), self.clause, self.subject, self.predicate)
                self._separate("comma")
            case "close" if self.bracket is not None:
                self._close_bracket()
            case "comma" if self.held:
                self._release()
            case "comma" | "close" | "and":
                self._separate("and" if link.value == "and" else "comma")

    def _release(self) -> None:
        """Go on after a relative clause about what was named in front: "over the hearth, which is ..., hangs a head"."""
        front, self.held = self.held, []
        self.frontier, self.clause, self.subject, self.predicate = [], Frame(), None, False
        self.front, self.separator, self.pending = front, "", None

    def _close_bracket(self) -> None:
        """Go on with what was spoken of before the brackets; all its parts together."""
        if self.bracket is None:
            return
        frontier, clause, subject, predicate = self.bracket
        self.bracket = None
        kept = set(map(id, self.draft.things))
        for node in frontier:
            family = [t for thing in node.things for t in self.referents.family(thing)]
            node.things = [t for t in dict.fromkeys(family) if id(t) in kept]
        clause.members = [t for m in clause.members for t in self.referents.family(m) if id(t) in kept]
        self.frontier = [node for node in frontier if node.things]
        self.clause, self.subject, self.predicate = clause, subject, predicate
        self.referents.parted = None
        self.separator = ""

    def _end(self, kind: str) -> None:
        """End a clause; after a colon or dash, what follows may tell the parts of what came last."""
        things = self.clause.members
        front = self.front if kind == "colon" and not things else []
        last = self.frontier[-1].thing if self.frontier else None
        self.whole = last if kind in ("colon", "dash") and last is not None and last.many else None
        if kind == "colon" and last is not None and last.many and not self.predicate:
            last.general = True
        self.said = self.verb if kind == "semicolon" else ""
        self.verb = ""
        if kind == "stop":
            self.referents.parted = None
            self.fresh.clear()
        if self.subject is not None and self.subject.thing is not None:
            self.referents.topics.append(self.subject.thing)
        elif things and not self.excluding:
            self.referents.topics.append(things[0])
        self._begin()
        self.front = front
        self.opening = None

    def _join(self, link: Link) -> None:
        match link.value:
            case "and" | "or":
                keep = self.excluding and link.value == "or"
                self._separate(link.value)
                self.excluding = keep
            case "but":
                negated = self.negating
                self._separate("comma")
                if negated and self.subject is not None:
                    self.predicate = True
            case "stop":
                self._end("stop")
            case "which":
                self.relative = next((n for n in reversed(self.frontier) if n.things), None)
                if self.relative is None and self.front and not self.clause.members:
                    anchors = [a for a in self.front[-1].anchors if isinstance(a, Mention)]
                    self.relative = Node(anchors, None, known=True) if anchors else None
                    self.held, self.front = self.front, []
                self.separator = ""

    def _separate(self, kind: str) -> None:
        self.negating = False
        if self.separator in ("comma", "comma_and") and kind == "and":
            kind = "comma_and"
        elif self.separator in ("and", "comma_and") and kind == "comma":
            kind = self.separator
        if kind in ("and", "comma") and self.excluding and self._next_is_excluded(bare=kind == "comma"):
            return
        self.excluding = False
        self.separator = kind
        self.relative = None
        if self.pending is not None and (self.pending.members or kind != "comma"):
            self.pending = None

    def _next_is_excluded(self, *, bare: bool) -> bool:
        """Whether "without a television and a rug" goes on: a noun without a verb or relation of its own."""
        noun = self._next_noun()
        if noun is None or noun.kind != "thing" or (bare and (noun.det or noun.count is not None)):
            return False
        after = self.peek(1)
        return not isinstance(after, Link) or after.sort == "mark" or after.value in ("or", "and")

    # --- prepositions

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

    def _read_where(self, link: Link, word: str = "") -> Where:
        """The preposition with what it is to; goes past it."""
        index = self._skip_fillers(self.at)
        chunk = self.chunks[index] if index < len(self.chunks) else None
        where = Where(word or link.value, None, negated=self.negating)
        if self._is_link(chunk, "joins", "which") and chunk.text.lower() in ("which", "whom"):  # type: ignore[union-attr]
            self.at = index + 1
            return self._which(where)
        if not isinstance(chunk, Noun) or (chunk.kind == "thing" and chunk.det == "no"):
            return where
        if self._leads(where, chunk, index):
            return where
        where.noun = chunk
        self.at = index + 1
        if chunk.kind in ("part", "place", "abstract") and self._is_link(self.peek(), "prepositions", "of"):
            whole = self._next_noun(1)
            if whole is not None:
                where.whole = whole
                self.at = self.chunks.index(whole, self.at) + 1
        if (
            link.value == "between"
            and self._is_link(self.peek(), "joins", "and")
            and chunk.kind != "pronoun"
            and not chunk.many
        ):
            second = self._next_noun(1)
            if second is not None and second.kind in ("thing", "place", "pronoun"):
                where.second = second
                self.at = self.chunks.index(second, self.at) + 1
        return where

    def _which(self, where: Where) -> Where:
        """ "A counter, on which a monitor stands": a clause of its own about what was just named."""
        outer = [n for n in self.frontier if n.things and n.frame is not None and n.frame.head is None]
        named = (outer or [n for n in self.frontier if n.things] or ([self.subject] if self.subject else []))[-1:]
        if named:
            self.referents.topics.append(named[0].things[-1])
            self.outer = named[0]
            self.frontier, self.clause, self.subject, self.predicate = [], Frame(), None, False
            self.front, self.separator = [], ""
        where.noun = Noun("pronoun", "it", 0, 0, "which")
        return where

    def _leads(self, where: Where, noun: Noun, index: int) -> bool:
        """Whether the noun is the subject of an adverb before it: "above, a lamp", "opposite a sofa" is not."""
        return False

    def _where(self, where: Where) -> None:
        """Say where something is: of what was named, or of what comes."""
        self.negating = False
        if where.word == "halfway":
            where.noun = None
        if where.noun is not None and where.noun.kind in ("people", "abstract", "room") and where.noun.kind != "room":
            self._beyond(where)
            return
        if where.noun is not None and where.noun.kind == "number" and where.noun.rows:
            things = [n for n in reversed(self.frontier) if n.things] or ([self.subject] if self.subject else [])
            if things:
                bind(self.draft, Bond("in_rows", things[0].things[-1], rows=max(where.noun.rows, 0)))
            return
        if where.noun is not None and where.noun.kind == "room":
            if where.word == "in" and not self.draft.room:
                self._room(where.noun)
            return
        if where.negated and where.noun is not None and where.noun.kind == "thing" and where.noun.det in ("a", ""):
            if not self.referents.named(where.noun):
                self.draft.excluded.add(where.noun.value)
                return
        if self.opening is not None and not self.frontier and where.noun is not None and where.noun.kind == "place":
            if where.noun.value.endswith("_wall"):
                self.opening.wall = where.noun.value
            return
        if self.opening is not None and not self.frontier and where.noun is not None and where.noun.kind == "thing":
            for thing in self.anchors(where.noun, [])[0]:
                bind(self.draft, Bond("next_to", thing, (self.opening.kind,)))
            return
        if self._qualifies_front():
            anchors = [a for a in self.front[-1].anchors if isinstance(a, Mention)]
            self._place_node(Node(anchors, self.clause, known=True), where)
            self.frontier = []
            return
        if self._is_fronted():
            self._set_front(where)
            return
        node = self._subject_of(where)
        if node is None:
            if (
                where.noun is not None and where.noun.kind == "thing" and where.noun.det not in ("the", "each", "my")
            ) or where.noun is not None:
                self._set_front(where)
            return
        self._place_node(node, where)

    def _qualifies_front(self) -> bool:
        """Whether it says more of what was just named in front: "on the desk against the wall a laptop"."""
        if not self.front or self.clause.members or self.frontier or self.separator or self.subject is not None:
            return False
        before = self.chunks[self._began - 1] if self._began > 0 else None
        return isinstance(before, Noun) and before.kind == "thing" and isinstance(self.front[-1].anchors[0], Mention)

    def _beyond(self, where: Where) -> None:
        """Words that say where and mean no place that we know; "for each guest" makes so many of what comes."""
        noun = where.noun
        if noun is not None and noun.kind == "people" and (noun.each or where.word == "per") and self.draft.people:
            self.frontier, self.subject, self.predicate = [], None, False
            self.clause = Frame(None, "list", times=self.draft.people, each=True)
            self.separator = ""
            if self._is_link(self.peek(), "mark", "comma"):
                self.at += 1

    def _place_node(self, node: Node, where: Where) -> None:
        subjects = node.things
        meaning = self.meanings.of(where, subjects, self._likely(node))
        if meaning is None:
            return
        self._relate(subjects, meaning, negated=where.negated)
        if where.negated:
            return
        if where.second is not None and where.second.kind == "place":
            opening = Meaning("next_to", (where.second.value.split()[0],))
            self._relate(subjects, opening)
        if meaning.kind in ("on", "inside") and not meaning.told:
            self._place_carrier(subjects, meaning)
        if node in self.frontier:
            del self.frontier[self.frontier.index(node) + 1 :]
        else:
            self.frontier.append(node)
        if node.frame is not None and node.frame.head is not None:
            node.frame.told |= any(t in meaning.anchors for t in node.frame.head.things)
        anchors = [a for a in meaning.anchors if isinstance(a, Mention)]
        if anchors and self.each and not meaning.told and where.noun is not None and where.noun.det == "a":
            anchors[0].count = sum(self.referents.total(t) for t in subjects)
            self.each = False
        if anchors and where.noun is not None and where.noun.kind in ("thing", "number") and not meaning.told:
            self.frontier.append(Node(anchors, None, known=where.noun.definite))
        elif anchors and where.noun is not None and where.noun.kind == "thing":
            self.frontier.append(Node(anchors, None, known=True, told=True))

    def _place_carrier(self, subjects: list[Mention], meaning: Meaning) -> None:
        """ "In the middle a vase on a table": it is the table that stands in the middle."""
        carrier = meaning.anchors[0]
        if not isinstance(carrier, Mention) or is_small(carrier):
            return
        for bond in self.draft.bonds:
            if bond.subject in subjects and bond.anchors and isinstance(bond.anchors[0], str) and bond.kind != "on":
                bond.subject = carrier
        for front in self.front:
            if front.anchors and isinstance(front.anchors[0], str) and front.kind != "on":
                if not any(b.kind == front.kind for b in self.draft.bonds_of(carrier)):
                    self._relate([carrier], replace(front.meaning), negated=front.where.negated)

    def _set_front(self, where: Where) -> None:
        noun = self._noun_ahead()
        likely = [self.referents.topics[-1]] if self.referents.topics and not self.clause.members else []
        if self.frontier and self.frontier[-1].things and not likely:
            outer = [n for n in self.frontier if n.things and n.frame is not None and n.frame.head is None]
            last = next(n for n in reversed(self.frontier) if n.things)
            both_small = noun != "" and self._belongs(noun, "small") and is_small(last.things[-1])
            likely = [n.things[-1] for n in ([last] if both_small else outer or [last])]
        sides = ("left", "right", "side", "front", "back")
        side = where.noun is not None and where.noun.kind == "part" and where.noun.value in sides
        before = [a for f in self.front for a in f.anchors if isinstance(a, Mention) and f.kind in _SIDEWARD]
        repeated = [a for f in self.front for a in f.anchors if isinstance(a, Mention) and a.many]
        if repeated and where.noun is not None and where.noun.kind == "pronoun" and where.noun.value == "each":
            likely = repeated
        elif before and (side or where.word in _SIDEWARD or where.word == "on"):
            likely = before if side or where.word != "on" else [*likely, *before]
        if where.noun is not None and where.noun.kind in ("part", "place") and where.whole is None:
            likely = likely if where.noun.det in ("my", "each", "either", "") and where.noun.kind == "part" else []
        meaning = self.meanings.of(where, [], likely, noun)
        if self.separator in ("and", "comma", "comma_and"):
            small = noun != "" and self._belongs(noun, "small") and where.word not in ("on", "in", "on_top")
            self.front = [f for f in self.front if f.kind == "on" and small]
        if meaning is not None:
            self.front.append(Front(where, meaning))
        self.frontier = []
        self.clause = Frame(times=self.clause.times)
        self.subject = None
        self.separator = ""
        self.pending = None
        if self._is_link(self.peek(), "mark", "comma"):
            self.at += 1

    def _noun_ahead(self) -> str:
        for ahead in range(3):
            chunk = self.peek(ahead)
            if isinstance(chunk, Noun):
                return chunk.value if chunk.kind == "thing" else ""
            if not isinstance(chunk, Link) or chunk.sort not in ("verbs", "fillers", "mark"):
                return ""
        return ""

    def _is_fronted(self) -> bool:
        """Whether what was just read says where something is that comes only now."""
        ahead = 0
        while self._is_link(self.peek(ahead), "prepositions") and isinstance(self.peek(ahead + 1), Noun):
            ahead += 2
        after = self.peek(ahead)
        begins = not self.frontier and self.subject is None
        if begins and not self.clause.members:
            return True
        if not self.separator:
            return False
        if isinstance(after, Noun) and after.kind in ("thing",) and not after.definite:
            return True
        if self._is_link(after, "verbs", "be", "stand", "hang"):
            following = self._next_noun(ahead + 1)
            return following is not None and following.kind == "thing"
        if self.separator in ("and", "comma_and") and self._is_link(after, "mark", "comma"):
            following = self.peek(ahead + 1)
            led = self.chunks[self._began - 1] if self._began else None
            comma = self._is_link(led, "mark", "comma") or self.separator == "comma_and"
            return isinstance(following, Noun) and following.kind == "thing" and comma
        return False

    # --- whom a relation is about

    def _subject_of(self, where: Where) -> Node | None:
        nodes = [node for node in reversed(self.frontier) if node.things]
        if not nodes:
            return self.subject
        if self.predicate and self.subject is not None and len(self.frontier) <= 1:
            return self.subject
        inner = nodes[0]
        noun = where.noun
        if inner.frame is None:
            return self._past_anchor(nodes, where)
        head = inner.frame.head
        if head is not None and head.things and where.word == "between" and self._is_pronominal(where):
            if self._belongs(inner.things[-1].noun, "small") and not head.things[-1].many:
                return head
        if head is not None and head.things and self._is_pronominal(where) and where.word in _BY_OWNER:
            lying = [b for b in self.draft.bonds_of(inner.things[-1]) if b.implied and b.kind in ("on", "inside")]
            within = bool(lying) and lying[0].kind == "inside" and len(self.clause.members) > 1
            if (
                lying
                and noun is not None
                and noun.kind == "pronoun"
                and (within or self._behind_its_carrier(head, where))
            ):
                return head
        middle = noun is not None and noun.value in ("centre", "middle") and where.whole is None
        if head is not None and head.things and middle and inner.things[-1].many and not inner.frame.each:
            return head
        if head is not None and head.things and not self._is_pronominal(where):
            thing = inner.things[-1]
            place = noun is not None and noun.kind == "place" and not (noun.value == "centre" and where.whole is None)
            if place and not self.habits.is_in(thing.noun, "wallpieces", "ceiling") and not inner.frame.each:
                if noun is not None and not (noun.value in ("wall", "floor", "ceiling") and where.word == "on"):
                    return self._node_of(head, nodes)
            same = noun is not None and noun.kind == "thing" and self._is_head(noun, head)
            if where.word in _BY_OWNER and not same and noun is not None and noun.kind == "thing":
                if self.habits.is_in(thing.noun, "small", "seats", "lamps"):
                    return self._node_of(head, nodes)
        return self._joined(inner, where)

    def _behind_its_carrier(self, head: Node, where: Where) -> bool:
        """Whether "it" is something before the shelves: "a counter, shelves with bottles behind it"."""
        before = [m for m in self.clause.members if m not in head.things]
        return where.word in ("behind", "in_front_of", "opposite") and bool(before)

    def _node_of(self, head: Node, nodes: list[Node]) -> Node:
        return head if head.frame is not None or head not in nodes else head

    def _is_head(self, noun: Noun, head: Node) -> bool:
        found = self.referents.named(noun) if noun.definite else None
        return found in head.things

    def _is_pronominal(self, where: Where) -> bool:
        noun = where.noun
        if noun is None:
            return True
        if noun.kind == "pronoun":
            return True
        if noun.kind == "part":
            return where.whole is None or where.whole.kind == "pronoun"
        return False

    def _past_anchor(self, nodes: list[Node], where: Where) -> Node:
        """After an anchor: "a vase on a table by the window", "a chair next to the bed by the window"."""
        inner = nodes[0]
        subject = next((n for n in nodes if n.frame is not None), None) or self.subject
        if subject is None:
            return inner
        if inner.told or where.negated or (inner.known and not is_small(subject.things[-1])):
            return subject
        thing = inner.things[-1]
        if self.habits.is_in(thing.noun, "covers") or (self._is_pronominal(where) and where.word == "between"):
            return subject
        if (
            where.noun is not None
            and where.noun.kind == "part"
            and where.noun.value == "middle"
            and not is_small(thing)
        ):
            return inner
        if self._is_pronominal(where) and where.noun is not None:
            return subject if not is_small(thing) and is_small(subject.things[-1]) else inner
        return inner

    def _joined(self, node: Node, where: Where) -> Node:
        """A list that shares what is said of its last member: "a vase and two candles on the table"."""
        thing = node.things[-1]
        frame = node.frame
        if frame is None or len(frame.members) < 2 or not frame.closing or len(node.things) > 1:
            return node
        kind = "on" if where.word == "on" else "inside" if where.word == "in" else where.word
        kind = (
            "against_wall"
            if where.noun is not None and where.noun.kind == "place" and "wall" in where.noun.value
            else kind
        )
        group = _JOINED.get("on" if kind in ("on_top", "inside") else kind)
        if group is None or not self._belongs(thing.noun, group):
            return node
        taken = [m for m in frame.members if any(not b.implied for b in self.draft.bonds_of(m))]
        free: list[Mention] = []
        for member in reversed(frame.members):
            if (member in taken and member is not thing) or (
                member is not thing and not self._belongs(member.noun, group)
            ):
                break
            free.insert(0, member)
        return Node(free, frame) if len(free) > 1 else node

    def _belongs(self, noun: str, group: str) -> bool:
        """Whether a noun belongs to a group of things; what nobody knows counts as small."""
        return self.habits.is_in(noun, group)

    def _catalogue(self) -> set[str]:
        return set(self.habits.known())

    def _likely(self, node: Node) -> list[Mention]:
        """What a pronoun means first: the head of the list, then what the clause is about."""
        found: list[Mention] = []
        frame = node.frame
        for bond in (b for t in node.things for b in self.draft.bonds_of(t)):
            found += [a for a in bond.anchors if isinstance(a, Mention) and not bond.negated]
        found += [t.host for t in node.things if t.host is not None]
        if frame is not None and frame.head is not None:
            found += frame.head.things
        if frame is not None and self._after_and(node):
            found += self._anchor_before(node)
        if self.subject is not None and self.subject is not node:
            found += self.subject.things
        for member in [m for m in self.clause.members if m not in node.things][-1:]:
            lying = [b for b in self.draft.bonds_of(member) if b.kind in ("on", "inside") and not b.negated]
            found += [a for b in lying for a in b.anchors if isinstance(a, Mention) and a in self.clause.members]
            found.append(member)
        for front in self.front:
            found += [a for a in front.anchors if isinstance(a, Mention)]
        return list(dict.fromkeys(t for t in found if t not in node.things))

    def _after_and(self, node: Node) -> bool:
        return node.frame is not None and len(node.frame.members) > 1 and node.frame.head is None

    def _anchor_before(self, node: Node) -> list[Mention]:
        """What the thing before it in the list was related to: "a lamp left of the laptop and a frame right of it"."""
        if node.frame is None:
            return []
        before = [m for m in node.frame.members if m not in node.things][-1:]
        said = [b for m in before for b in self.draft.bonds_of(m) if not b.implied]
        anchors = [a for b in said[-1:] for a in b.anchors if isinstance(a, Mention) and id(a) not in self.fresh]
        return anchors if not (before and is_small(before[0]) and said and said[-1].kind == "on") else []

    # --- relations

    def _flanks(self, subjects: list[Mention], meaning: Meaning) -> bool:
        """One of two things "on either side" stands at the left, the other at the right."""
        anchor = meaning.anchors[0]
        if not meaning.both or meaning.kind != "next_to" or len(subjects) != 1 or len(meaning.anchors) != 1:
            return False
        if not isinstance(anchor, Mention) or anchor.many or meaning.each:
            return False
        subject = subjects[0]
        self._multiply(subject, meaning)
        if self.referents.total(subject) != 2 or any(b.each for b in self.draft.bonds_of(subject) if not b.implied):
            return False
        for bond in self.draft.bonds_of(subject):
            bond.each &= not bond.implied
        part = self.referents.part(subject, 1)
        self.referents.parted = None
        for one, side in ((part, "left"), (subject, "right")):
            self.draft.bonds = [b for b in self.draft.bonds if b.subject is not one or not b.implied]
            bind(self.draft, Bond(relation_kind(f"{side}_of"), one, (anchor,)))
            one._sides = (side,)  # type: ignore[attr-defined]
        for node in self.frontier:
            if node.things == [subject]:
                node.things = [part, subject]
        return True

    def _relate(self, subjects: list[Mention], meaning: Meaning, *, negated: bool = False) -> None:
        """Bind subjects to what they are related to."""
        if not negated and self._flanks(subjects, meaning):
            return
        anchors = tuple(a for a in meaning.anchors if a not in subjects) or meaning.anchors
        for subject in subjects:
            if subject in anchors and len(anchors) == 1:
                continue
            if meaning.kind in ("in_front_of", "next_to", "near") and self._lies_on(subject, anchors):
                continue
            self._multiply(subject, meaning)
            if self._is_laid(subject, meaning, anchors) and not negated:
                continue
            kind = relation_kind(meaning.kind)
            if kind == "on" and not negated and self._is_seated_on(subject, anchors):
                continue
            if kind == "against_wall" and any(isinstance(a, Mention) for a in anchors):
                kind = "next_to"
            bond = Bond(kind, subject, anchors, each=meaning.each, negated=negated, spread=meaning.spread)
            if kind == "in_centre" and isinstance(anchors[0], Mention) and self._belongs(subject.noun, "small"):
                self._share(lying := Bond("on", subject, anchors, each=meaning.each, negated=negated))
                bind(self.draft, lying)
            if negated:
                self.draft.bonds.append(bond)
                continue
            self._share(bond)
            bind(self.draft, bond)
            for anchor in anchors:
                if isinstance(anchor, Mention) and kind in ("next_to", "facing", "opposite", "left_of", "right_of"):
                    self.referents.pairs.append((subject, anchor))
        if self.opening is not None and not subjects and isinstance(anchors[0], str) and anchors[0].endswith("_wall"):
            self.opening.wall = anchors[0]

    def _is_seated_on(self, table: Mention, seats: tuple[Mention | str, ...]) -> bool:
        """Put the chairs around a table that "seats eight people on eight chairs"."""
        if not self.habits.is_in(table.noun, "tables", "desks"):
            return False
        if not all(isinstance(s, Mention) and self.habits.is_in(s.noun, "seats", "chairs") for s in seats):
            return False
        for seat in seats:
            bind(self.draft, Bond("around", seat, (table,)))  # type: ignore[arg-type]
        return True

    def _lies_on(self, subject: Mention, anchors: tuple[Mention | str, ...]) -> bool:
        """Whether it was said to lie on these, or for each of these: it is in front of them then."""
        said = [b for b in self.draft.bonds_of(subject) if b.kind in ("on", "inside") and not b.implied]
        carriers = [a for b in said for a in b.anchors]
        return any(a in carriers or a in subject.per for a in anchors)

    def _is_laid(self, subject: Mention, meaning: Meaning, anchors: tuple[Mention | str, ...]) -> bool:
        """Lay "a plate at every seat" on the table of the seats, as many as there are seats."""
        seats = [a for a in anchors if isinstance(a, Mention) and self.habits.is_in(a.noun, "seats", "chairs")]
        if len(seats) != len(anchors) or meaning.kind not in ("at", "next_to", "around", "in_front_of", "per", "on"):
            return False
        if self.habits.is_in(subject.noun, "seats", "tables", "lamps") or not meaning.each:
            return False
        if not is_small(subject) or (meaning.kind == "on" and meaning.told):
            return False
        tables = [a for s in seats for b in self.draft.bonds_of(s) if b.kind in _SEATED for a in b.anchors]
        if not tables:
            return False
        subject.per += [s for s in seats if s not in subject.per]
        bind(self.draft, Bond("on", subject, tuple(dict.fromkeys(tables))))
        return True

    def _multiply(self, subject: Mention, meaning: Meaning) -> None:
        """One "on each side" are two; one "in each corner" four."""
        if meaning.both and subject.count == 1 and meaning.times == 1:
            subject.count = 2
        if subject.count and meaning.times > 1 and not getattr(subject, "_told", False):
            subject.count *= meaning.times
            if subject.least:
                subject.least *= meaning.times
        elif meaning.spread > 1 and subject.count == 1:
            subject.count = meaning.spread

    def _share(self, bond: Bond) -> None:
        """Keep the number that "each" gave where the relation to it is told in other words."""
        for old in self.draft.bonds:
            if old.implied and old.each and old.subject is bond.subject and not bond.each:
                heads = [a for a in old.anchors if isinstance(a, Mention)]
                if not old.distributed and bond.anchors != old.anchors:
                    continue
                if tuple(heads) != bond.anchors and not set(map(id, heads)) & set(map(id, bond.anchors)):
                    bond.subject.per += [h for h in heads if h not in bond.subject.per]
                elif set(map(id, bond.anchors)) <= set(map(id, heads)):
                    bond.anchors = tuple(heads)
                    bond.each = bond.kind != "between"

    # --- nouns

    def _noun(self, noun: Noun) -> None:
        self.draft.style += noun.styles if not self.excluding else []
        if noun.kind == "thing" and self._is_label(noun):
            return
        match noun.kind:
            case "thing":
                self._thing(noun)
            case "place":
                self._place(noun)
            case "room":
                self._room(noun)
            case "people":
                self._people(noun)
            case "number":
                self._number(noun)
            case "pronoun":
                self._pronoun(noun)
            case "part":
                self._bare_part(noun)
            case "abstract":
                self._abstract(noun)
        if noun.kind != "room":
            self.separator = ""

    def _is_label(self, noun: Noun) -> bool:
        """Whether the first noun says what kind of room it is: "Chess club, 7 m x 6 m: ..."."""
        if self.draft.things or self.draft.room or self.front or self.draft.excluded:
            return False
        after = self.peek()
        if noun.room:
            self._room(replace(noun, kind="room", value=noun.room))
            return True
        introduces = isinstance(after, Measured) or self._is_link(after, "mark", "colon", "open")
        introduces |= self._is_link(after, "mark", "comma") and isinstance(self.peek(1), Measured)
        roomish = noun.text.lower().split()[-1] in _ROOMISH
        whole = self._next_noun(1) if self._is_link(after, "prepositions", "of") and not noun.det else None
        if whole is not None and self._is_link(self.peek(2), "mark", "comma") and isinstance(self.peek(3), Measured):
            self.at += 2
            self._room(replace(noun, kind="room", value="room"))
            return True
        with_ = self._is_link(after, "prepositions", "with", "for", "of") or self._is_link(after, "joins", "stop")
        named_room = self._is_link(after, "mark", "colon") and noun.text.lower().split()[-1] in _ROOMISH
        sized = self._is_link(after, "mark", "comma", "open") and isinstance(size := self.peek(1), Measured)
        large = sized and isinstance(size, Measured) and self._is_room_size(size.size)
        large &= not noun.det or not noun.named
        if not noun.det and not noun.many and (self._colon_ahead() or large):
            named_room = True
        named_room |= large
        if named_room and noun.det in ("a", "") and not noun.many:
            self._room(replace(noun, kind="room", value="room"))
            return True
        if not noun.named and (roomish or introduces or with_ or self._is_link(after, "mark")) and not noun.many:
            self._room(replace(noun, kind="room", value="room"))
            return True
        return False

    def _is_room_size(self, size: Size) -> bool:
        """Whether a size is that of a room rather than of a thing."""
        sides = [length.metres for length in size.lengths]
        square = isinstance(said := self.peek(2), Adjective) and said.attributes == ["square"]
        return size.area is not None or ((len(sides) > 1 or square) and min(sides) > 1.0)

    def _colon_ahead(self) -> bool:
        """Whether a colon ends what was begun, before any other mark."""
        marks = (c for c in self.chunks[self.at :] if isinstance(c, Link) and c.sort == "mark")
        first = next(marks, None)
        return first is not None and first.value == "colon"

    def _room(self, noun: Noun) -> None:
        if self._is_another_room(noun):
            self.draft.rooms.append(noun.text)
            return
        if not self.draft.room or self.draft.room == "room":
            self.draft.room = noun.value
        self.draft.room_attributes += noun.attributes
        self.draft.empty |= "empty" in noun.attributes or "empty" in noun.states
        if noun.size:
            self.draft.sizes.append(noun.size)
        if not self.draft.things:
            self.frontier = []

    def _is_another_room(self, noun: Noun) -> bool:
        """Whether a second room is asked for: "an apartment with a kitchen and a bathroom"."""
        if not self.draft.room or noun.value == "room" or noun.definite or self.negating or self.excluding:
            return False
        zone = noun.text.lower().split()[-1] in ("area", "corner", "nook", "space", "zone", "section", "side", "set")
        listed = (
            noun.det in ("a", "another") or noun.count is not None or self.separator in ("comma", "and", "comma_and")
        )
        return listed and not zone and noun.value != self.draft.room

    def _people(self, noun: Noun) -> None:
        if noun.count and not self.draft.things and not noun.each:
            self.draft.people = noun.count
        if noun.count and not self.frontier and not self.clause.members:
            self.crowd = noun.count

    def _place(self, noun: Noun) -> None:
        if self.leaving or "empty" in (*noun.attributes, *noun.states) or "free" in noun.text.lower().split():
            self._free(noun.value)
            return
        name = noun.value.split()[0]
        if (name in ("window", "door") and noun.det == "no") or (self.excluding and name in ("window", "door")):
            self.draft.openings.append(Gap(name, 0))
        elif name in ("window", "door") and not noun.definite:
            self.opening = Gap(name, noun.count or (2 if noun.plural else 1))
            self.draft.openings.append(self.opening)
            for front in self.front:
                if front.anchors and isinstance(front.anchors[0], str) and front.anchors[0].endswith("_wall"):
                    self.opening.wall = front.anchors[0]
            self.frontier = []
        elif not self.separator:
            self.frontier = []

    def _free(self, place: str) -> None:
        self.draft.free.append(place.split()[0])

    def _bare_part(self, noun: Noun) -> None:
        if self.leaving and noun.value == "middle":
            self._free("centre")
            return
        self.subject = None
        self.frontier = []

    def _abstract(self, noun: Noun) -> None:
        if noun.det == "each" or noun.definite:
            group = self.groups.get(singular(noun.value.rpartition(" ")[2]))
            if group is not None:
                self._take_known(noun, [group])
                return
        word = singular(noun.text.rpartition(" ")[2].lower())
        if word in _GROUPS and (noun.count or 0) > 1:
            self._take(self._new(noun), noun)
            return
        if not self.clause.members and self.separator != "and":
            self.frontier = [Node()]

    def _thing(self, noun: Noun) -> None:
        if noun.det == "no" or (self.excluding and not self.excepting):
            self._exclude(noun)
            return
        if self._is_capacity(noun):
            return
        if not noun.det and not noun.named and noun.count is None and self._is_link(self.peek(), "mark", "colon"):
            return
        word = noun.text.rpartition(" ")[2].lower()
        if noun.definite and word in PARTS_OF_THINGS and self._is_link(self.peek(), "prepositions", "of"):
            whole = self._next_noun(1)
            if whole is not None and whole.kind == "thing":
                self.at = self.chunks.index(whole, self.at) + 1
                noun = whole
        if self._is_adjective(noun):
            self._adjective(Adjective(noun.start, noun.end, noun.text, [noun.material]))
            return
        if self.separator and self._is_new_clause(noun):
            kept = self.separator
            topic = self.clause.members[:1] or (self.subject.things[:1] if self.subject else [])
            self.referents.topics += topic
            self._begin()
            self.separator = kept
        known = self._known(noun)
        if known:
            self._take_known(noun, known)
            self.negating = noun.det == "none"
            return
        thing = self._new(noun)
        self._take(thing, noun)

    def _is_capacity(self, noun: Noun) -> bool:
        """Whether "(3 seats)" only says how large the sofa before it is."""
        last = self.chunks[self.at - 2] if self.at >= 2 else None
        thing = self.frontier[-1].thing if self.frontier else None
        if not self._is_link(last, "mark", "open") or thing is None or not noun.count:
            return False
        if noun.text.lower().split()[-1] not in ("seats", "seat", "seater"):
            return False
        thing.attributes.append(f"{noun.count}-seat")
        return True

    def _is_adjective(self, noun: Noun) -> bool:
        """Whether a noun without an article says what something is made of: "the second is glass"."""
        last = self.chunks[self.at - 2] if self.at >= 2 else None
        bare = not noun.det and noun.count is None and not noun.plural and noun.material != ""
        return bare and self._is_link(last, "verbs", "be") and self.predicate

    def _is_new_clause(self, noun: Noun) -> bool:
        """Whether a verb of its own follows the noun: ", and two guitars hang on the wall"."""
        fresh = not self.predicate and not self.existential
        if (self.separator == "and" and fresh) or (self.separator == "comma" and fresh and not self.front):
            return False
        index = self.at
        while index < len(self.chunks):
            chunk = self.chunks[index]
            if isinstance(chunk, Link):
                if chunk.sort == "verbs":
                    text = chunk.text.lower()
                    return chunk.value != "put" and not text.startswith("there")
                if chunk.sort == "mark" or (chunk.sort == "joins" and chunk.value != "and") or chunk.sort == "mutual":
                    return False
                if chunk.sort == "joins" and not isinstance(self.chunks[min(index + 1, len(self.chunks) - 1)], Noun):
                    return False
                if chunk.sort in ("inverses", "participles") and chunk.value not in ("stand", "hang"):
                    return False
                if chunk.sort == "prepositions" and chunk.value == "with":
                    return False
            elif isinstance(chunk, (Measured, Stray)):
                return False
            index += 1
        return False

    def _known(self, noun: Noun) -> list[Mention]:
        """The things that a noun phrase points back to."""
        if noun.det == "each" and noun.every:
            return self._every(noun)
        if noun.det == "each" or (noun.det in ("all", "both") and noun.plural):
            found_all = self.referents.every(noun)
            exact = [t for t in found_all if noun.count is not None and self.referents.total(t) == noun.count]
            if found_all and (noun.count is None or sum(self.referents.total(t) for t in found_all) >= noun.count):
                return exact[:1] or found_all
            return []
        if noun.of_known or noun.ordinal or noun.side or noun.det == "other":
            found = self.some_of(noun, besides=[])
            return [found] if found is not None else []
        bare = not noun.det and noun.count is None and not noun.plural and noun.named
        if not (noun.definite or (bare and self._is_repeated(noun))):
            return self._one_and_other(noun)
        first = self.referents.named(noun)
        if first is None:
            return []
        if noun.plural and noun.definite:
            every = self.referents.every(noun)
            total = sum(t.count or 1 for t in every)
            if noun.count is None or noun.count == total:
                return every
            if noun.count < total:
                return [first]
            return []
        if noun.count and first.count and noun.count > first.count:
            return []
        if not noun.plural and first.many and noun.det == "the" and first.count:
            return [first]
        return [first]

    def _one_and_other(self, noun: Noun) -> list[Mention]:
        """ "One cot has a bag on it, the other has not": one of those that were named."""
        if not noun.text.lower().startswith("one ") or self.separator:
            return []
        for chunk in self.chunks[self.at :]:
            if self._is_link(chunk, "mark", "stop"):
                return []
            if isinstance(chunk, Noun) and (chunk.det == "other" or chunk.value == "other"):
                break
        else:
            return []
        whole = self.referents.named(noun)
        family = self.referents.family(whole) if whole is not None else []
        if len(family) > 1:
            self.referents.parted = family[-1]
            return family[:1]
        return self._one_named(noun)

    def _one_named(self, noun: Noun) -> list[Mention]:
        """ "One side table" of two that were named: "on one side table stands a lamp"."""
        text = noun.text.lower().split()
        if text[:1] != ["one"] or noun.count != 1:
            return []
        whole = self.referents.named(noun)
        if whole is None or self.referents.total(whole) < 2:
            return []
        return [self.referents.part(whole, 1)]

    def _is_repeated(self, noun: Noun) -> bool:
        first = self.referents.named(noun)
        if first is None or first in self.clause.members or first.many:
            return False
        return first.noun == noun.value and not noun.attributes and not noun.owner and not noun.unshown

    def _every(self, noun: Noun) -> list[Mention]:
        """ "every second chair", "every two loungers": so many of them, or groups of so many."""
        whole = self.referents.named(noun)
        if whole is None or not whole.count:
            return []
        self.referents.settle(whole)
        if noun.counted:
            self.each_of = noun.every
            return [whole]
        return [self.referents.part(whole, max(1, whole.count // noun.every))]

    def anchors(self, noun: Noun, besides: list[Mention]) -> tuple[tuple[Mention, ...], bool]:
        """The things that a noun phrase after a preposition means, and whether they were known."""
        if (noun.det == "each" and not noun.named) or noun.value.rpartition(" ")[2] in _GROUPS:
            group = self.groups.get(singular(noun.text.rpartition(" ")[2].lower()))
            if group is not None:
                return (group,), True
        if noun.value == "seat" or (noun.det == "each" and singular(noun.text.rpartition(" ")[2].lower()) in _SEATS):
            if (seats := self._seats()) and self.referents.named(noun) is None:
                return tuple(seats), True
        known = [t for t in self._known(noun) or self._one_named(noun) if t not in besides or noun.plural]
        if known:
            for thing in known:
                self.referents.speak(thing)
            return tuple(known), True
        if not noun.det and noun.plural and noun.count is None and not noun.attributes:
            every = [t for t in self.referents.every(noun) if t not in besides and t.noun == noun.value]
            if every:
                return tuple(every), True
        if noun.det in ("a", "") and not noun.plural and noun.count in (None, 1):
            found = self.referents.named(noun, besides)
            modest = found is not None and set(noun.attributes) <= set(found.attributes) and not noun.unshown
            if found is not None and modest and found.noun == noun.value and (found.many or not noun.det):
                self.referents.speak(found)
                return (found,), True
        thing = self._new(noun)
        if not noun.definite:
            self.fresh.add(id(thing))
        return (thing,), False

    def _seats(self) -> list[Mention]:
        return [t for t in self.draft.things if self.habits.is_in(t.noun, "seats", "chairs") and t.asked]

    def some_of(self, noun: Noun, besides: list[Mention]) -> Mention | None:
        """The part of some known things that a number, "the left one" or "the other" means."""
        if noun.kind == "thing":
            whole = self.referents.named(noun, besides)
            parts = [*self.referents.parts.get(id(whole), ())] if whole else []
        else:
            whole = self._whole(besides)
            parts = [*self.referents.parts.get(id(whole), ())] if whole else []
        if whole is None:
            return None
        if noun.ordinal:
            return self._ordinal(noun, whole)
        told = [t for t in [*parts, whole] if noun.side and noun.side in getattr(t, "_sides", ())]
        if told:
            return told[0]
        if noun.det == "other":
            self.referents.parted = None
            return whole
        self.referents.settle(whole)
        count = self._how_many(noun, whole)
        part = self.referents.part(whole, count)
        if noun.side:
            self._set_side(part, whole, noun.side)
        return part

    def _ordinal(self, noun: Noun, whole: Mention) -> Mention:
        """The first, second, ... of several."""
        family = self.referents.family(whole)
        whole = next((t for t in family if t.many), whole)
        order = self.ordinals.setdefault(id(family[0]) if len(family) > 1 else id(whole), {})
        for known in self.ordinals.values():
            if noun.ordinal in known and known[noun.ordinal] in family:
                return known[noun.ordinal]
        taken = [t for known in self.ordinals.values() for t in known.values()]
        free = [t for t in family if t not in taken and not t.many]
        part = self.referents.part(whole, 1) if whole.many else (free[-1] if free else whole)
        order[noun.ordinal] = part
        return part

    def _how_many(self, noun: Noun, whole: Mention) -> int:
        total = whole.count or 2
        if noun.det == "half":
            total += sum(p.count or 0 for p in self.referents.parts.get(id(whole), ()))
            return max(1, total // 2)
        if noun.det in ("each", "all", "none", "both") and noun.count is None:
            return total
        return noun.count or (total if noun.plural and not noun.side else 1)

    def _set_side(self, part: Mention, whole: Mention, side: str) -> None:
        """The left one of two that flank something stands at its left."""
        other = {"left": "right", "right": "left"}.get(side, "")
        part._sides = (side,)  # type: ignore[attr-defined]
        if part is not whole:
            whole._sides = (other,)  # type: ignore[attr-defined]
        if not other:
            return
        for thing, where in ((part, side), (whole, other)):
            for bond in self.draft.bonds_of(thing):
                if (
                    bond.kind == "next_to"
                    and bond.anchors
                    and isinstance(bond.anchors[0], Mention)
                    and part is not whole
                ):
                    bond.kind = relation_kind(f"{where}_of")

    def _whole(self, besides: Sequence[Mention]) -> Mention | None:
        """The several things that a number now parts."""
        if self.referents.parted is not None and self.referents.parted not in besides:
            return self.referents.parted
        if self.whole is not None and self.whole in self.draft.things:
            return self.whole
        family = next((f for t in reversed(self.draft.things) if len(f := self.referents.family(t)) > 1), [])
        near = [n.things[-1] for n in reversed(self.frontier) if n.things]
        near += self.clause.members[::-1]
        many = [t for t in near if t.many and t not in besides]
        found = next(iter(many), None) or next((t for t in self.referents.plural() if t not in besides), None)
        return found or next((t for t in reversed(family) if t not in besides), None)

    def _new(self, noun: Noun) -> Mention:
        """Add the thing that a phrase asks for."""
        count = noun.count if noun.count is not None else (None if noun.plural else 1)
        if noun.value == "seat" and not noun.named:
            noun.value = "chair"
        if noun.share:
            count = self._share_of(noun)
        cornered = "corner" in noun.text.lower().split()[:-1] and not noun.value.startswith("corner")
        noun.attributes = [a for a in noun.attributes if a != "corner" or not cornered]
        thing = Mention(noun.value, count, noun.vague, noun.plural, noun.rows, [*noun.attributes], noun.text)
        thing.least, thing.most = noun.least, noun.most
        thing.vague |= noun.share > 0
        thing.unshown, thing.states = [*noun.unshown], [*noun.states]
        thing.seats, thing.size = noun.seats, noun.size
        thing.groups, thing.group = noun.groups, noun.group
        self.draft.things.append(thing)
        word = singular(noun.text.rpartition(" ")[2].lower())
        if word in _GROUPS:
            self.groups[word] = thing
        if cornered:
            self.draft.bonds.append(Bond("in_corner", thing, ("corner",)))
        if noun.rows:
            self.draft.bonds.append(Bond("in_rows", thing, rows=max(noun.rows, 0)))
        if self.wanting_only:
            self.draft.empty, self.wanting_only = True, False
        self.referents.speak(thing)
        return thing

    def _share_of(self, noun: Noun) -> int | None:
        """ "half as many dryers", "as many glasses as there are stools"."""
        other: Mention | None = None
        for index in range(self.at, min(self.at + 8, len(self.chunks))):
            if self._is_link(self.chunks[index], "prepositions", "as"):
                said = next((c for c in self.chunks[index + 1 : index + 4] if isinstance(c, Noun)), None)
                other = self.referents.named(said) if said is not None and said.kind == "thing" else None
                if said is not None:
                    del self.chunks[index : self.chunks.index(said, index) + 1]
                break
        other = other or next((t for t in self.referents.plural() if t.count), None)
        return max(1, int(self.referents.total(other) * noun.share)) if other is not None else None

    def _take_known(self, noun: Noun, known: list[Mention]) -> None:
        """Speak again of things named before: as the subject, or as what a list names."""
        for thing in known:
            self.referents.speak(thing)
            thing.attributes += [a for a in noun.attributes if a not in thing.attributes]
            thing.unshown += [a for a in noun.unshown if a not in thing.unshown]
            thing.states += [a for a in noun.states if a not in thing.states]
        frame = self._frame_for(known[0], noun) if self.separator and self.frontier else None
        node = Node(list(known), frame or self.clause, known=True, each=noun.each)
        pending, self.pending = self.pending, None
        if pending is not None and pending.head is not None:
            self._member(known[0], pending)
            node.frame = pending
            self._push(node)
            return
        if frame is not None and frame.head is not None:
            self._push(node)
            return
        self.clause.members += [t for t in known if t not in self.clause.members]
        self.frontier = [node]
        self._apply_front(known)
        self.each |= noun.each
        word = singular(noun.text.rpartition(" ")[2].lower())
        self.per_group = known[0].groups if noun.each and known[0].group == word else 0

    def _take(self, thing: Mention, noun: Noun) -> None:
        """Take a new thing into the list it belongs to."""
        pending, self.pending = self.pending, None
        frame = pending
        if frame is None:
            frame = self._frame_for(thing, noun) if self.separator and self.frontier else self.clause
        self._member(thing, frame)
        self._push(Node([thing], frame, each=noun.each))
        if frame.head is None:
            self.subject, self.predicate = None, False
            self._apply_front([thing])

    def _push(self, node: Node) -> None:
        head = node.frame.head if node.frame is not None else None
        if head is not None and head in self.frontier:
            del self.frontier[self.frontier.index(head) + 1 :]
        elif head is None:
            self.frontier = []
        self.frontier.append(node)

    def _frame_for(self, thing: Mention, noun: Noun) -> Frame:
        """The list that a thing after a comma or "and" goes on with: the innermost that it belongs to."""
        nodes = [node for node in reversed(self.frontier) if node.frame is not None]
        for node in nodes:
            frame = node.frame
            if frame is None or frame.head is None:
                continue
            if self._goes_on(frame, thing, noun):
                frame.closing |= self.separator in ("and", "comma_and")
                return frame
        if self.separator in ("and", "comma_and"):
            self.clause.closing = True
        return self.clause

    def _goes_on(self, frame: Frame, thing: Mention, noun: Noun) -> bool:
        head = frame.head.thing if frame.head is not None else None
        told = self._told_of(frame)
        if told is not None:
            return told
        if head is None:
            return frame.times > 1
        tie = self._tie(thing, frame)
        if frame.closing and self.separator in ("comma", "comma_and"):
            return False
        if self.separator == "comma_and" and len(frame.members) <= 1 and not frame.each:
            return False
        if tie is None or (tie == "next_to" and not self.habits.tie(thing.noun, head.noun) and frame.members):
            return False
        if frame.told and self.separator == "comma":
            return frame.each and tie in _CARRIED
        if frame.told and tie not in _CARRIED:
            return False
        if self.separator == "comma_and" and tie not in _CARRIED and not frame.each:
            return False
        return True

    def _told_of(self, frame: Frame) -> bool | None:
        """Whether what follows the noun ties it to the head of a list in words, or to something else."""
        link = self.peek()
        if not isinstance(link, Link) or link.sort not in ("prepositions", "participles"):
            return None
        index = 0
        if link.sort == "participles":
            index, link = 1, self.peek(1)
            if not isinstance(link, Link) or link.sort != "prepositions":
                return None
        noun = self._next_noun(index + 1)
        if noun is None or link.value in ("with", "of", "for"):
            return None
        if frame.head is None:
            return frame.times > 1
        if noun.kind == "pronoun" or (noun.kind == "part" and self._is_mine(noun, index)):
            return True
        if noun.kind == "thing" and noun.definite:
            return self._is_of(frame, noun)
        if noun.kind == "part":
            whole = self._next_noun(index + 3)
            if whole is not None and whole.kind == "thing":
                return self._is_of(frame, whole)
        if noun.kind == "place" and noun.value.split()[0] in ("corner", "window", "door", "wall", "ceiling", "floor"):
            return None if frame.each and noun.value.split()[0] == "wall" else False
        return None

    def _is_of(self, frame: Frame, noun: Noun) -> bool | None:
        if frame.head is not None and self.referents.named(noun) in frame.head.things:
            return True
        return None if frame.each else False

    def _is_mine(self, noun: Noun, index: int) -> bool:
        after = self.peek(index + 2)
        return not self._is_link(after, "prepositions", "of")

    def _apply_front(self, things: list[Mention]) -> None:
        """Give things the relation that stood before them ("on the desk a lamp and a vase")."""
        for front in list(self.front):
            listed = len(self.clause.members) > len(things)
            thing = things[-1]
            off = front.kind == "on" and not self.habits.is_in(thing.noun, "small", "fitted")
            wall = front.anchors and isinstance(front.anchors[0], str)
            if listed and (off and not wall) and not self.clause.closing:
                self.front.remove(front)
                continue
            if listed and self._is_told_next():
                continue
            if listed and front.kind not in (
                "on",
                "inside",
                "above",
                "against_wall",
                "next_to",
                "near",
                "behind",
                "in_front_of",
                "in_corner",
                "at",
                "per",
                "around",
            ):
                continue
            self._relate(things, replace(front.meaning), negated=front.where.negated)

    # --- lists of what things have

    def _open(self, kind: str) -> None:
        """Begin a list of what something has: "with", "surrounded by", "carrying"."""
        self.negating = False
        noun = self._next_noun()
        if noun is not None and noun.kind == "abstract" and kind == "with":
            return
        if kind in ("inside", "on") and isinstance(said := self.peek(), Adjective):
            self.chunks[self.at] = Noun("thing", said.text.lower(), said.start, said.end, said.text, named=False)
        if noun is not None and self._is_feature(noun) and kind == "with":
            node = next((n for n in reversed(self.frontier) if n.things), None)
            if node is not None:
                node.things[-1].unshown.append(f"with {noun.text}")
                self.at = self.chunks.index(noun, self.at) + 1
                return
        head = self._head_for(noun, kind)
        if head is None:
            return
        if kind == "inside" and noun is not None and self._is_described(noun, head):
            head.things[-1].attributes.append("filled")
            self.at = self.chunks.index(noun, self.at) + 1
            return
        if noun is not None and noun.kind == "part" and noun.det == "my" and kind == "with":
            self.at = self.chunks.index(noun, self.at) + 1
            self.frontier = self.frontier[: self.frontier.index(head) + 1] if head in self.frontier else [head]
            return
        thing = head.thing
        if kind == "with" and thing is not None and thing in self.groups.values() and (self.each or head.each):
            self._dissolve(thing)
            return
        frame = Frame(head, kind, each=self.each or head.each or (head.frame is not None and head.frame.times > 1))
        self.each = False
        if head in self.frontier:
            del self.frontier[self.frontier.index(head) + 1 :]
        else:
            self.frontier.append(head)
        self.pending = frame
        self.separator = ""

    def _is_described(self, noun: Noun, head: Node) -> bool:
        """Whether "a bookcase full of books" only describes it, where "shelves filled with jars" asks for jars."""
        thing = head.things[-1]
        if noun.kind != "thing" or noun.count is not None:
            return noun.kind in ("abstract", "people")
        return self.habits.is_in(noun.value, "fills_shelves") and self.habits.is_in(thing.noun, "takes_books")

    def _is_feature(self, noun: Noun) -> bool:
        """Whether it is a part that furniture comes with: "a cabinet with three drawers"."""
        return singular(noun.text.rpartition(" ")[2].lower()) in _FEATURES and not self.each

    def _head_for(self, noun: Noun | None, kind: str) -> Node | None:
        nodes = [node for node in reversed(self.frontier) if node.things]
        if not nodes:
            return self.subject if self.subject is not None and self.subject.things else None
        if self.each:
            return next((n for n in nodes if any(t.many for t in n.things)), nodes[0])
        if self.separator in ("comma", "comma_and", "and") and len(nodes) > 1:
            outer = [n for n in nodes if n.frame is not None]
            return outer[-1] if outer else nodes[-1]
        if noun is not None and noun.kind == "thing":
            for node in nodes[:3]:
                if node.frame is None and node.known and len(nodes) > 1:
                    continue
                return node
        return nodes[0]

    def _participle(self, kind: str) -> None:
        match kind:
            case "hold" | "carry":
                self._open(kind)
            case "surround":
                self._where(self._read_where(Link("prepositions", "around", 0, 0)))
            case "flank":
                self._flank()
            case "line":
                self._where(self._read_where(Link("prepositions", "along", 0, 0)))
            case "hang":
                if (
                    self._is_link(self.peek(), "prepositions", "from")
                    and (n := self._next_noun(1))
                    and n.kind == "thing"
                ):
                    self.at += 1
                    self._where(self._read_where(Link("prepositions", "next_to", 0, 0)))

    def _member(self, thing: Mention, frame: Frame) -> None:
        """Take a thing into a list: relate it to the head."""
        first = not frame.members
        if frame.times > 1 and thing not in frame.members:
            thing.count = (thing.count or 1) * frame.times
        if thing not in frame.members:
            frame.members.append(thing)
        if frame.head is None or not frame.head.things:
            return
        head = frame.head.things[-1]
        if thing is head:
            return
        if not thing.owner:
            thing.owner = head
        tie = self._tie(thing, frame, first=first)
        if tie is None:
            tie = "next_to" if frame.each or frame.grouped or frame.kind != "with" else None
        thing.host = head
        if tie is None:
            thing.owner = None
            return
        if "shared" in thing.attributes and tie == "next_to" and head.many:
            tie = "between"
        told = frame.kind not in ("with",)
        anchors = tuple(frame.head.things)
        if len(anchors) > 1 and any(a.noun != head.noun for a in anchors):
            anchors = (head,)
        each = tie != "between" and not frame.grouped and (frame.each or self._shares(thing, head, tie, frame))
        if frame.kind in ("around", "next_to") and thing.count == 1:
            each = False
        implied = not told or self._is_told_next()
        bond = Bond(relation_kind(tie), thing, anchors, each=each, implied=implied, distributed=frame.each)
        bind(self.draft, bond)

    def _is_told_next(self) -> bool:
        """Whether the relation of the thing just named to something is told in words."""
        link = self.peek()
        return self._is_link(link, "prepositions") and not self._is_link(link, "prepositions", "with", "of", "for")

    def _shares(self, thing: Mention, head: Mention, tie: str, frame: Frame) -> bool:
        """Whether "two desks with a chair" means a chair at each."""
        if head.count is None or head.count < 2 or thing.vague or "shared" in thing.attributes:
            return False
        if frame.kind in ("hold", "carry"):
            return False
        if thing.count is None:
            return tie in ("on", "at", "around")
        few = thing.count < 2 * head.count and thing.noun != head.noun
        return thing.count == 1 or (tie in ("around", "at") and few)

    def _tie(self, thing: Mention, frame: Frame, *, first: bool = False) -> str | None:
        """How a listed thing belongs to the head; None when it does not, which ends the list."""
        head = frame.head.thing if frame.head is not None else None
        if head is None:
            return None
        first = first or not frame.members
        usual = self.habits.tie(thing.noun, head.noun)
        small = self._belongs(thing.noun, "small")
        small |= self.habits.is_in(thing.noun, "fitted") and (first or frame.kind in ("carry", "hold", "on"))
        shelves = (
            self.habits.is_in(head.noun, "shelves", "containers")
            if "containers" in self._groups()
            else self.habits.is_in(head.noun, "shelves")
        )
        match frame.kind:
            case "hold" | "carry" | "inside" if usual in ("at", "around"):
                return usual
            case "hold" | "carry":
                if not (small or first or usual == "on"):
                    return None
                within = self._contains(head, shelves=shelves) if frame.kind == "hold" else shelves
                return "inside" if within else "on"
            case "inside":
                return "inside" if small or first else None
            case "on":
                return "on" if small or first or usual == "on" else None
            case "with":
                if usual == "on" and shelves and small:
                    return "inside"
                if usual:
                    return str(usual)
                surfaces = self.habits.is_in(head.noun, "surfaces", "beds", "lounges")
                contains = self._contains(head, shelves=shelves)
                seats = (first or frame.each) and self.habits.is_in(head.noun, "seats")
                flat = singular(head.text.rpartition(" ")[2].lower()) in _FLAT
                laid = small and (surfaces or contains or seats or flat) and thing.noun != "tv"
                if laid:
                    return "inside" if contains else "on"
                return "next_to" if frame.each else None
        return frame.kind if frame.kind != "list" else None

    def _groups(self) -> Sequence[str]:
        return tuple(self.habits.groups)

    def _contains(self, head: Mention, *, shelves: bool) -> bool:
        word = singular(head.text.rpartition(" ")[2].lower())
        return shelves or word in _CONTAINERS

    # --- verbs

    def _verb(self, link: Link) -> None:
        text = link.text.lower()
        if link.value == "put":
            self.existential |= not self.clause.members
            if not self.clause.members and not self.front:
                return
            if self.subject is None and self.clause.members and not self.separator:
                self.subject = self._whole_subject()
                self._open_of_subject("with")
            return
        if link.value == "other":
            self.frontier, self.subject, self.pending = [], None, None
            return
        if link.value == "leave":
            self.leaving = True
            return
        if text.startswith(("there", "here", "you ", "we ")):
            if self.clause.members:
                self._begin_again()
            self.existential = True
            return
        last = self.chunks[self.at - 2] if self.at >= 2 else None
        if self.outer is not None and self._is_link(last, "mark", "comma", "close") and not self.front_only():
            self.subject, self.outer = self.outer, None
        elif self.relative is not None:
            self.subject = self.relative
            self.relative = None
        elif self.subject is None or (self.clause.members and not self.predicate):
            self.subject = self._whole_subject()
        if self.subject is None and link.value in ("be", "stand", "hang", "serve"):
            return
        self._predicate(link)

    def front_only(self) -> bool:
        """Whether only a relation, and nothing that it is about, has been read."""
        return bool(self.front) and not self.clause.members

    def _begin_again(self) -> None:
        topic = self.clause.members[:1]
        self.referents.topics += topic
        self._begin()

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

    def _predicate(self, link: Link) -> None:
        self.predicate = True
        self.verb = link.value
        if self.subject is not None:
            self.frontier = [self.subject]
        self.separator = ""
        match link.value:
            case "have" | "consist":
                self._have(link.value)
            case "hold" | "carry":
                self._open_of_subject(link.value)
            case "face":
                self._where(self._read_where(Link("prepositions", "facing", 0, 0)))
            case "surround":
                self._where(self._read_where(Link("prepositions", "around", 0, 0)))
            case "flank":
                self._flank()
            case "line":
                self._where(self._read_where(Link("prepositions", "along", 0, 0)))
            case "share":
                self._have_shared()
            case "serve":
                self._as()
            case "seat":
                self._seat()
            case "hang":
                if (
                    self._is_link(self.peek(), "prepositions", "from")
                    and (n := self._next_noun(1))
                    and n.kind == "thing"
                ):
                    self.at += 1
                    self._where(self._read_where(Link("prepositions", "next_to", 0, 0)))

    def _seat(self) -> None:
        """ "a table that seats ten"."""
        noun = self._next_noun()
        thing = self.subject.thing if self.subject is not None else None
        if noun is not None and noun.count and noun.kind in ("number", "people") and thing is not None:
            thing.seats = noun.count
            self.at = self.chunks.index(noun, self.at) + 1

    def _open_of_subject(self, kind: str) -> None:
        if self.subject is None:
            return
        self.pending = Frame(self.subject, kind, each=self.each or self.subject.each)
        if self.per_group:
            self.pending.each, self.pending.times, self.per_group = False, self.per_group, 0
            self.pending.grouped = True
        self.each = False

    def _have(self, kind: str) -> None:
        if self.subject is None and self.crowd:
            self.pending = self.clause = Frame(None, "list", times=self.crowd, each=True)
            self.crowd = 0
            return
        if self.subject is None:
            return
        following = self.peek()
        if isinstance(following, Noun) and following.kind == "abstract":
            self.at += 1
            return
        thing = self.subject.thing
        if thing is not None and thing in self.groups.values() and (kind == "consist" or self.subject.each):
            self._dissolve(thing)
            return
        self._open_of_subject("with")

    def _have_shared(self) -> None:
        if self.subject is None or self.subject.thing is None:
            return
        every = getattr(self, "each_of", 0)
        frame = Frame(self.subject, "next_to")
        if every:
            frame.times = max(1, (self.subject.thing.count or every) // every)
            self.each_of = 0
        self.pending = frame

    def _flank(self) -> None:
        where = self._read_where(Link("prepositions", "next_to", 0, 0))
        self._where(where)

    def _dissolve(self, group: Mention) -> None:
        """Let the members of a list stand for a group that is no thing itself: each member as often as the group."""
        frame = Frame(None, "list", times=group.count or 1, each=True)
        moved = [b for b in self.draft.bonds_of(group) if not any(isinstance(a, Mention) for a in b.anchors)]
        self.draft.drop(group)
        self.groups = {word: thing for word, thing in self.groups.items() if thing is not group}
        frame.moved = moved  # type: ignore[attr-defined]
        self.clause = frame
        self.frontier = []
        self.subject = None
        self.pending = frame
        self.each = False

    def _drop_groups(self) -> None:
        """A group of which nobody says what it is is not understood."""
        for thing in self.groups.values():
            if thing in self.draft.things and thing.noun not in self.habits.known():
                self.draft.drop(thing)
                self.draft.unknown.append(thing.text)

    # --- parts, pronouns, numbers

    def _pronoun(self, noun: Noun) -> None:
        following = self.peek()
        match noun.value:
            case "each":
                self._each(following)
            case "former" | "latter":
                found = self.referents.of_two(noun.value)
                self._resume([found] if found is not None else [], noun)
            case "it":
                found = self.referents.single(None, "", self._spoken_of())
                self._resume([found] if found is not None else [], noun)
            case "them":
                self._resume(list(self.referents.several([], "")), noun)
                if noun.text.lower().startswith("both") and self.frontier:
                    self.frontier[0].each = self.each = True
            case "all":
                things = [t for t in self.clause.members if t in self.draft.things]
                if things:
                    self.frontier = [Node(things, self.clause, known=True)]
                    self.separator = ""
            case "one" | "other" | "half" | "none":
                count = noun.count or 1
                if noun.value == "one" and (before := self._one_before()) is not None:
                    self._take(self._copy_of(before), noun)
                    return
                whole = self._whole([])
                if whole is None:
                    return
                if noun.value == "none":
                    self._resume([whole], noun)
                    self.negating = True
                    return
                if noun.text.lower() == "another" and self.referents.parted is None and self._repeat():
                    return
                if noun.value == "other" and noun.text.lower() == "another":
                    said = self.verb
                    self._part_of(whole, 1, noun)
                    self._again(said)
                    return
                if noun.value == "other":
                    self.referents.parted = None
                    said = self.said or self.verb
                    self._resume([whole], noun)
                    self._again(said)
                    return
                count = max(1, (whole.count or 2) // 2) if noun.value == "half" else count
                self._part_of(whole, count)

    def _repeat(self) -> bool:
        """Read "a rack on the left and another on the right": one more of what was named last."""
        node = self.frontier[-1] if self.frontier else None
        thing = node.thing if node is not None else None
        if node is None or node.frame is None or thing is None or thing.many:
            return False
        copy = self._copy_of(thing)
        self._member(copy, node.frame)
        self._push(Node([copy], node.frame))
        return True

    def _again(self, verb: str) -> None:
        """Let the verb before stand for one left out: "one holds a bust, another a horse"."""
        comma = self._is_link(self.peek(), "mark", "comma")
        after = self.peek(1) if comma else self.peek()
        if verb in ("hold", "carry", "have") and isinstance(after, Noun) and after.kind == "thing":
            self.at += comma
            self.subject = self.frontier[0]
            self._open_of_subject("with" if verb == "have" else verb)
            self.verb = verb

    def _one_before(self) -> Mention | None:
        """The single thing that "one" repeats: "one bin on its left and one on its right"."""
        if self.referents.parted is not None or not self.clause.members:
            return None
        last = self.clause.members[-1]
        return last if last.count == 1 and last.text.lower().startswith("one ") else None

    def another(self, thing: Mention) -> Mention:
        """One more of a kind."""
        return self._copy_of(thing)

    def _copy_of(self, thing: Mention) -> Mention:
        """Another of the same kind."""
        copy = Mention(thing.noun, 1, attributes=[*thing.attributes], unshown=[*thing.unshown], text=thing.text)
        copy.states, copy.size = [*thing.states], thing.size
        self.draft.things.append(copy)
        self.referents.speak(copy)
        return copy

    def _spoken_of(self) -> list[Mention]:
        return [t for t in (*self.referents.topics[-1:],) if not t.many]

    def _each(self, following: Chunk | None) -> None:
        if self.crowd:
            return
        if isinstance(following, Noun) and following.kind == "thing" and following.det == "a":
            group = next((t for t in self.groups.values() if t in self.draft.things), None)
            if group is not None:
                self._dissolve(group)
                return
        nodes = [n for n in reversed(self.frontier) if any(t.many for t in n.things)]
        begins = not self.frontier and not self.clause.members
        if not nodes and not begins and self._all_parts():
            begins = False
        elif begins or not nodes:
            found = [t for t in self.referents.several([], "each") if t.many]
            if begins and found:
                self.frontier = [Node(found, self.clause, known=True, each=True)]
                self.clause.members += found
                self.each = True
                return
        trailing = following is None or (isinstance(following, Link) and following.sort in ("mark", "joins"))
        if trailing:
            self._trailing_each()
            return
        if nodes:
            del self.frontier[self.frontier.index(nodes[0]) + 1 :]
            self.each = True
        elif parts := self._all_parts():
            self.frontier = [Node(parts, self.clause, known=True, each=True)]
            self.each = True

    def _all_parts(self) -> list[Mention]:
        """The parts of what was parted in this sentence."""
        node = self.frontier[-1] if self.frontier else None
        for whole, parts in self.referents.parts.items():
            things = [t for t in self.draft.things if id(t) == whole or t in parts]
            if node is not None and set(map(id, node.things)) & set(map(id, things)):
                return things
        return []

    def _trailing_each(self) -> None:
        """ "two bins with five balls each", "four chairs each"."""
        node = self.frontier[-1] if self.frontier else None
        if node is None or node.frame is None:
            return
        for thing in node.frame.members if node.frame.head is not None else node.things:
            for bond in self.draft.bonds_of(thing):
                if any(isinstance(a, Mention) for a in bond.anchors):
                    bond.each = True

    def _resume(self, things: list[Mention], noun: Noun) -> None:
        """Go back to things named before."""
        if not things:
            return
        separated = self.separator
        if separated and self.clause.members:
            self._begin()
        self.subject, self.predicate = None, False
        self.clause.members += [t for t in things if t not in self.clause.members]
        self.frontier = [Node(list(things), self.clause, known=True, each=noun.value == "each")]
        self._apply_front(things)

    def _number(self, noun: Noun) -> None:
        """A number that stands for some of several: "two by the window", "three of them chrome"."""
        if noun.rows and not noun.of_known:
            self._arrange(noun)
            return
        bounded = noun.least is not None or noun.most is not None
        if bounded and not noun.of_known and not self._is_link(self.peek(), "prepositions"):
            return
        told = self._is_link(self.peek(), "prepositions") and (each := self._next_noun(1)) is not None
        if self.bracket is not None and told and each is not None and each.kind == "pronoun" and each.value == "each":
            self.at += 2
            return
        whole = self._whole([])
        if whole is None:
            if noun.count and not self.draft.things:
                self.draft.people = noun.count
            return
        if self._is_total(noun, whole):
            return
        if noun.det in ("none",):
            self._resume([whole], noun)
            self.negating = True
            return
        if noun.det == "other" and not noun.attributes:
            self.referents.parted = None
            self._resume([whole], noun)
            return
        if noun.det == "other":
            self._look(whole, noun)
            self.referents.parted = None
            self._resume([whole], noun)
            return
        if noun.ordinal > 2 and noun.det == "a" and self.whole is whole:
            self.referents.settle(whole)
            self._part_of(whole, max(1, (whole.count or 0) // noun.ordinal), noun)
            return
        if noun.side or noun.ordinal:
            part = self.some_of(noun, [])
            if part is not None:
                self._look(part, noun)
                self._resume([part], noun)
                self._again(self.verb)
                if self.said in ("hold", "carry", "have") and self._is_link(self.peek(), "mark", "comma"):
                    self.at += 1
                    self.subject = self.frontier[0]
                    self._open_of_subject("with" if self.said == "have" else self.said)
            return
        self._part_of(whole, self._how_many(noun, whole), noun)

    def _is_total(self, noun: Noun, whole: Mention) -> bool:
        """Whether a number only sums up: "as many mats as there are machines, five"."""
        after = self.peek()
        plain = not (noun.attributes or noun.unshown or noun.states or noun.of_known or noun.side or noun.ordinal)
        if not plain or isinstance(after, (Adjective, Noun)):
            return False
        ends = after is None or self._is_link(after, "mark") or self._is_link(after, "fillers")
        if ends and noun.count and self.separator and self.frontier:
            thing = self.frontier[-1].thing
            if thing is not None and (thing.count is None or thing.vague):
                thing.count, thing.vague = noun.count, False
            return True
        return False

    def _arrange(self, noun: Noun) -> None:
        """ "(six shelving units stand) in two rows of three"."""
        thing = self._whole([])
        if thing is not None:
            bind(self.draft, Bond("in_rows", thing, rows=max(noun.rows, 0)))

    def _part_of(self, whole: Mention, count: int, noun: Noun | None = None) -> None:
        """Set so many of `whole` apart and speak of them."""
        times = self._times_next()
        if self._is_more(whole, noun):
            part = self._copy(whole, count * times)
            self._speak_of_part(part, noun)
            return
        if whole.count is not None and count * times == whole.count and whole is not self.referents.parted:
            self._resume([whole], noun or Noun("number", "", 0, 0))
            whole._told = True  # type: ignore[attr-defined]
            return
        self.referents.settle(whole)
        if times > 1 and whole.count is not None and count * times > whole.count and whole is not self.referents.parted:
            whole.count = count * times
        total = count * times
        if whole.count is None and whole is not self.referents.parted:
            whole.count = total
            whole.vague = False
            self._more = whole  # type: ignore[attr-defined]
            part = whole
        elif getattr(self, "_more", None) is whole and whole.count is not None and not self.referents.parted:
            part = self._copy(whole, total)
        else:
            part = self.referents.part(whole, min(total, whole.count or total))
        self._speak_of_part(part, noun)

    def _is_more(self, whole: Mention, noun: Noun | None) -> bool:
        """Whether a number adds to what was placed: "two chairs on each side and one at each end"."""
        if self.separator != "and" or whole is self.referents.parted or whole is self.whole:
            return False
        if noun is not None and (noun.of_known or noun.attributes or noun.unshown):
            return False
        return any(not bond.implied for bond in self.draft.bonds_of(whole)) and self._is_link(
            self.peek(), "prepositions"
        )

    def _speak_of_part(self, part: Mention, noun: Noun | None) -> None:
        if noun is not None:
            self._look(part, noun)
        part._told = True  # type: ignore[attr-defined]
        frame = Frame(None, "list")
        self.frontier = [Node([part], frame, known=True)]
        frame.members.append(part)
        self.clause = frame
        self.subject = None
        self.predicate = False

    def _copy(self, whole: Mention, count: int) -> Mention:
        part = replace(
            whole, count=count, attributes=[*whole.attributes], unshown=[*whole.unshown], states=[*whole.states]
        )
        part.per = [*whole.per]
        anchors = [a for b in self.draft.bonds_of(whole) for a in b.anchors if isinstance(a, Mention)]
        part.host = part.host or next(iter(anchors), None)
        self.draft.things.append(part)
        self.draft.bonds += [replace(b, subject=part) for b in self.draft.bonds_of(whole) if b.implied]
        self.referents.speak(part)
        return part

    def _times_next(self) -> int:
        """How many sides are named next, where a number is that of each: "three on each long side"."""
        link = self.peek()
        noun = self._next_noun(1) if self._is_link(link, "prepositions") else None
        if noun is not None and noun.kind == "part" and self._is_link(link, "prepositions", "per"):
            self.at = self.chunks.index(noun, self.at) + 1
            return 2
        if noun is None or noun.kind not in ("part", "place") or noun.det not in ("each", "either", "both"):
            return 1
        if noun.kind == "part":
            return 2
        return 4 if noun.value in ("wall", "corner") else 2

    def _look(self, thing: Mention, noun: Noun) -> None:
        thing.attributes += noun.attributes
        thing.unshown += noun.unshown
        thing.states += noun.states

    def _adjective(self, said: Adjective) -> None:
        """ "the sofa is red", "three of them chrome", "leave the middle free"."""
        self.draft.style += said.styles if not self.predicate else []
        if self.leaving or (self.predicate and self.subject is not None and self.subject.thing is None):
            return
        node = self.frontier[-1] if self.frontier else None
        if node is None or not node.things:
            if self.draft.things == []:
                self.draft.room_attributes += said.attributes
            return
        for thing in (self.subject or node).things if self.predicate else node.things:
            thing.attributes += said.attributes if not self.negating else []
            thing.unshown += said.unshown if not self.negating else []
            thing.states += said.states if not self.negating else []
            thing.attributes += said.styles if False else []

    def _mutual(self, kind: str) -> None:
        """ "facing each other", "side by side", "in a row": of one plural thing, or of two that were joined."""
        nodes = [n for n in reversed(self.frontier) if n.things]
        if not nodes:
            return
        node = next((n for n in nodes if any(t.many for t in n.things)), None)
        things = node.things if node is not None else list(self.clause.members)
        if self.predicate and self.subject is not None:
            things = self.subject.things
        if kind in ("in_rows", "in_row"):
            for thing in things[-1:]:
                bind(self.draft, Bond("in_rows", thing, rows=1 if kind == "in_row" else 0))
        elif len(things) > 1:
            for one, other in pairwise(things[-2:]):
                bind(self.draft, Bond(relation_kind(kind), other, (one,)))
        elif things and things[-1].many and kind != "around":
            bind(self.draft, Bond(relation_kind(kind), things[-1], (things[-1],)))

    # --- negation

    def _negation(self, link: Link) -> None:
        match link.value:
            case "not":
                self._not(link)
            case "nothing":
                self._nothing()
            case "only":
                self._only()
            case "exclude":
                self.excluding = True
            case "gone":
                self._gone()

    def _not(self, link: Link) -> None:
        noun = self.peek()
        before = self.chunks[self.at - 2] if self.at >= 2 else None
        if link.text.lower() == "no" and isinstance(before, Noun) and (noun is None or self._is_link(noun, "mark")):
            thing = self.frontier[-1].thing if self.frontier else None
            if thing is not None:
                self.draft.drop(thing)
                self.draft.excluded.add(thing.noun)
            return
        if isinstance(noun, Noun) and noun.kind == "thing" and not noun.definite:
            self.excluding = True
            return
        text = link.text.lower()
        if " be" in text or text in ("is not", "are not", "isnt", "arent", "not", "never"):
            if self.subject is None:
                self.subject = self._whole_subject()
                self.predicate = self.subject is not None
        self.negating = True

    def _gone(self) -> None:
        """ "The popcorn machine is gone": it must not be there."""
        things = self.subject.things if self.subject is not None and self.predicate else []
        for thing in things:
            self.draft.drop(thing)
            self.draft.excluded.add(thing.noun)

    def _nothing(self) -> None:
        after = self.peek()
        but = self.peek(2)
        besides = self._is_link(but, "joins", "but") or self._is_link(but, "prepositions", "except")
        if self._is_link(after, "prepositions", "on") and besides and self.subject is not None:
            self.at += 3
            self._open_of_subject("carry")
            return
        if self._is_link(after, "prepositions", "except"):
            self.draft.empty = True
        elif self._is_link(after, "prepositions", "on"):
            noun = self._next_noun(1)
            if noun is not None and noun.kind == "place" and "wall" in noun.value:
                self.draft.excluded.update(("picture", "poster", "mirror"))
                self.at += 2
                self.excluding = False
            elif noun is not None and noun.kind == "thing":
                link = after
                self.at += 1
                where = self._read_where(link)  # type: ignore[arg-type]
                self._set_front(where)
        elif after is None or self._is_link(after, "mark") or self._is_link(after, "prepositions", "in"):
            self.draft.empty = True

    def _only(self) -> None:
        noun = self._next_noun()
        if noun is not None and noun.kind == "thing" and not self.clause.members and self.pending is None:
            self.draft.empty = True

    def _exclude_next(self) -> None:
        self.excluding = True

    def _exclude(self, noun: Noun) -> None:
        after = self._next_noun(1) if self._is_link(self.peek(), "prepositions", "except") else None
        if after is not None and after.kind in ("number", "pronoun"):
            self.at = self.chunks.index(after, self.at) + 1
            self._take(self._new(replace(noun, det="a", count=after.count or 1, plural=False)), noun)
            return
        self.draft.excluded.add(noun.value)
        if noun.det == "no" and not self.excluding:
            self.frontier = [*self.frontier]
        self.pending = None

    # --- of, for, as

    def _of(self) -> None:
        """ "shelves of bottles", "a vase of tulips", "the drawers of the cabinet"."""
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
        if contents and (word in _BOXES or self.habits.is_in(head.noun, "shelves")):
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
            kept, self.leaving = self.leaving, False
            found = self._new(noun)
            self.frontier = [Node([found], self.clause)]
            self.clause.members.append(found)
            self.at = index + 1
            self.leaving = kept and False
        else:
            self.at = index + 1

    def _as(self) -> None:
        noun = self._next_noun()
        if noun is not None and noun.kind in ("thing", "room", "abstract") and noun.count in (None, 1):
            self.at = self.chunks.index(noun, self.at) + 1

    # --- sizes

    def _measured(self, size: Size) -> None:
        """Read a size: of the thing just before or after it, or of the room."""
        before = self.chunks[self.at - 2] if self.at >= 2 else None
        if (
            isinstance(before, Link)
            and before.sort in ("mark", "fillers")
            and before.value in ("open", "comma")
            and self.at >= 3
        ):
            before = self.chunks[self.at - 3]
        if self._is_link(before, "prepositions", "of") and self.at >= 3:
            before = self.chunks[self.at - 3]
        following = self.peek()
        single = len(size.lengths) == 1 and size.area is None
        roomy = not single and size.area is None and min(length.metres for length in size.lengths) > _ROOMY
        if single and isinstance(following, Adjective) and following.attributes == ["square"]:
            size = replace(size, lengths=size.lengths * 2)
            single = False
        thing = self.frontier[-1].thing if self.frontier else None
        ceiling = isinstance(following, Noun) and following.value == "ceiling"
        if roomy and not self.draft.sizes:
            self.draft.sizes.append(size)
        elif (
            isinstance(following, Link)
            and following.sort == "prepositions"
            and following.value in ("from", "far", "away")
        ):
            self.draft.unknown.append(f"{size.text} {following.text}")
        elif isinstance(following, Noun) and following.kind == "thing" and not following.size:
            following.size = size
        elif isinstance(before, Noun) and before.kind == "thing" and thing is not None and not ceiling:
            thing.size = thing.size or size
        elif (isinstance(before, Noun) and before.kind == "room") or not self.draft.things:
            self.draft.sizes.append(size)
        elif thing is not None and single and size.area is None and not ceiling:
            thing.size = thing.size or size
        else:
            self.draft.sizes.append(size)


_ROOMISH = (
    "club", "hall", "lab", "laboratory", "surgery", "cell", "cabin", "centre", "center", "aisle", "corridor", "store",
    "shop", "salon", "van", "practice", "ward", "nook", "cinema", "closet", "lounge", "den", "lobby", "room", "studio",
    "theatre", "theater", "court", "arena", "base", "station", "depot", "cafeteria", "cottage", "hut", "shed", "barn",
    "container", "chalet", "bar", "pub", "restaurant", "bistro", "cafe", "diner", "stage", "set", "cockpit", "hostel", "bunker", "booth", "greenhouse", "office", "area", "corner", "space", "parlour", "sauna",
    "spa", "kiosk", "stall", "garage", "attic", "basement", "cellar", "vault", "tent", "boat", "ship", "train", "bus",
)  # fmt: skip
"""Last words of the names of rooms."""
_FLAT = ("tray", "plate", "board", "saucer", "mat", "cart", "trolley", "platter", "cushion", "pouf", "rug", "blanket")
"""Last words of the names of what carries things though it is small itself."""
_FEATURES = (
    "drawer", "door", "leg", "wheel", "handle", "castor", "caster", "compartment", "burner", "tier", "armrest", "arm",
    "lid", "back", "backrest", "headboard", "footrest", "knob", "frame", "top", "pattern", "stripe", "pane",
)  # fmt: skip
"""Parts that things come with, rather than things of their own."""
_SEATS = ("seat", "place", "setting", "cover")
_CONTAINERS = (
    "rack", "shelf", "bookcase", "bookshelf", "basket", "bin", "crate", "box", "bucket", "bowl", "fridge",
    "refrigerator", "wardrobe", "cupboard", "closet", "drawer", "stand", "case", "freezer", "container", "tub", "locker",
    "hutch", "cabinet", "pantry", "unit", "vitrine", "chest", "trunk", "dishwasher", "oven", "microwave", "safe", "sack",
    "bag", "jar", "holder",
)  # fmt: skip
"""Last words of the names of what holds things within itself rather than on top."""
_BOXES = (
    "crate", "box", "basket", "bin", "sack", "bag", "rack", "shelf", "shelving", "case", "bucket", "carton", "tray",
    "drawer", "trolley", "cart", "bookcase", "cabinet", "unit", "chest", "bookshelf",
)  # fmt: skip
"""Last words of the names of containers whose many contents are things to be made."""
