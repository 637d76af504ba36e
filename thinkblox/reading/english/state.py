"""What the reader of clauses has in mind, and what comes next."""

from collections.abc import Sequence

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.draft import Draft, Gap, Mention
from thinkblox.reading.english.chunks import Adjective, Chunk, Link, Noun
from thinkblox.reading.english.meaning import Meanings, Namer
from thinkblox.reading.english.nodes import Frame, Front, Node
from thinkblox.reading.english.referents import Referents


class State(Namer):
    """The chunks of one text, how far they are read, and what is open."""

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
        self.sides: dict[Mention, str] = {}
        self.counted: set[Mention] = set()
        self.summed: Mention | None = None
        self.each_of = 0

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

    def _belongs(self, noun: str, group: str) -> bool:
        """Whether a noun belongs to a group of things; what nobody knows counts as small."""
        return self.habits.is_in(noun, group)
