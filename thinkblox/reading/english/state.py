"""What the reader of clauses has in mind, and what comes next."""

from collections.abc import Sequence

from thinkblox.knowledge.habits import load_habits
from thinkblox.reading.draft import Bond, Draft, Gap, Mention
from thinkblox.reading.english.account import Account
from thinkblox.reading.english.antecedents import Antecedents
from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun
from thinkblox.reading.english.meaning import Meanings, Namer
from thinkblox.reading.english.nodes import Awaited, Listed, Node, Where
from thinkblox.reading.english.referents import Referents
from thinkblox.reading.tokens import Token

LOOKAHEAD = 60
"""How many chunks ahead the reader looks at most."""


class State(Namer):
    """The chunks of one text, how far they are read, and what is open.

    Attributes:
        cut: the chunks as they were before any was read.
        account: what becomes of every word.
        named_by: the phrases that things were first named by.
        spent: the phrases, as their first and last tokens, of which something was made.
        draft: what was understood.
        groups: things that stand for several together ("station"), by that word.
        opening: the door or window that was named last.
        whole: the several whose parts a colon or dash begins to tell.
        fresh: what the sentence named for the first time as an anchor.
        verb, said: the verb of this clause, and of the one that a semicolon ended.
        holding: how what is held stood to its holder, where that was said last.
        bracket: what was spoken of before an open bracket.
        dashed: whether that bracket is a dash.
        ordinals: which of a family is the first, the second, ...
        sides: which of two is the left one, which the right one.
        counted: things whose number was told as a part of several, and is not that of each side.
        multiplied: things of which so many were asked for at each of several places.
        told_later: what "every" named first and whose number came after.
        singled: what is left of several since one was called "the one by the window".
        summed: several without a number, whose parts are being counted.
        summed_looks: what was said of all of these before.
        each_of: of how many "every two" were the last.
        frontier: what the next words can be about, the outermost first.
        front: relations whose subject is still to come; `held`: the same, outside of a relative clause.
        clause: what the clause names.
        subject, predicate: what the verb of the clause is said of, and whether it was read.
        relative: what "which" stands for; `outer`: what the sentence goes on with after "on which".
        pending: the list that the next thing begins.
        separator: "comma", "and" or "comma_and", when that was read last.
        negating, excluding, excepting, leaving, existential: "not", "without", "except", "leave", "there is" hold.
        each: what comes is said of each.
        per_group, crowd: so many of what comes, for so many groups, or people.
        together: with what that was said to be somewhere what comes is ("along with three candles").
        of_room: the clause lists what the room has.
        adding: "three of roses" added to "five buckets of tulips", so that what comes may add more.
        aside: the owner of a list that goes on after its member's parts were told ("four chairs, two on each side").
        barred: what was said not to be there last; `excluded_by`: by which phrase each such thing was.
        placed_barred: where the words end that say of it where it is not to be; -1 where these are of something else.
        laid: what was said last lies where it was said to lie before.
        meant: what the phrase at a token was taken for; `antecedents` weighs what pronouns point back to by it.
        unsure: phrases for one thing that several were named by, and these.
        at_ends: what was said to lie at the left or right end of what carries it.
        circles: things that were said to stand in a circle.
        numbers: how many of each member of a list were said.
        tables: things that serve as tables.
        spoken_of: what a pronoun of this sentence meant.
        untied: things that others were said to have, and no relation of ours says how, with their owners.
        places: seats that were just named as places at a table ("each place is laid with a plate").
        sequence: on which side each of the things that come is of the one before ("from left to right").
        ordered: what was said of things by such words, with these.
    """

    def __init__(self, tokens: Sequence[Token], chunks: Sequence[Chunk]) -> None:
        self.chunks = list(chunks)
        self.cut = tuple(chunks)
        self.account = Account(tokens, chunks)
        self.named_by: dict[Mention, Noun] = {}
        self.at = 0
        self.draft = Draft()
        self.referents = Referents(self.draft)
        self.meant: dict[int, list[Mention]] = {}
        self.antecedents = Antecedents(self.draft, self.referents, self.meant, self.cut)
        self.meanings = Meanings(self.referents, self.antecedents, self)
        self.habits = load_habits()
        self.groups: dict[str, Mention] = {}
        self.opening: Gap | None = None
        self.whole: Mention | None = None
        self._began = 0
        self.fresh: set[Mention] = set()
        self.clause = Listed()
        self.said = ""
        self.verb = ""
        self.holding = "hold"
        self.bracket: tuple[list[Node], Listed, Node | None, bool] | None = None
        self.dashed = False
        self.ordinals: dict[Mention, dict[int, Mention]] = {}
        self.sides: dict[Mention, str] = {}
        self.counted: set[Mention] = set()
        self.multiplied: set[Mention] = set()
        self.told_later: set[Mention] = set()
        self.singled: Mention | None = None
        self.summed: Mention | None = None
        self.summed_looks: tuple[list[str], list[str], list[str]] = ([], [], [])
        self.each_of = 0
        self.front: list[Awaited] = []
        self.held: list[Awaited] = []
        self.barred: Noun | None = None
        self.placed_barred = -1
        self.excluded_by: dict[str, Noun] = {}
        self.laid = False
        self.spoken_of: Mention | None = None
        self.at_ends: list[tuple[Mention, Mention, Where]] = []
        self.circles: list[tuple[Mention, Connector]] = []
        self.numbers: set[int] = set()
        self.ordered: list[tuple[Connector, Bond]] = []
        self.tables: set[Mention] = set()
        self.unsure: list[tuple[Noun, Mention]] = []
        self.untied: list[tuple[Mention, Mention]] = []
        self.spent: set[tuple[int, int]] = set()
        self._begin()

    def _spend(self, noun: Noun) -> None:
        """Note that something was made of a phrase, or that it asks for nothing by itself."""
        self.spent.add((noun.start, noun.end))

    def _begin(self) -> None:
        """Begin a clause; relations for which no subject came are lost."""
        for front in (*self.front, *self.held):
            if not front.used and front.is_known:
                self._lose_where(front.where)
        if self.clause.members:
            self.referents.joined = self.clause.last_joined() or self._joined_within()
            self.referents.listed = self.clause.last_listed()
        self.frontier: list[Node] = []
        self.front = []
        self.clause = Listed()
        self.subject: Node | None = None
        self.relative: Node | None = None
        self.pending: Listed | None = None
        self.separator = ""
        self.predicate = False
        self.negating = False
        self.excluding = False
        self.leaving = False
        self.each = False
        self.excepting = False
        self.of_room = False
        self.existential = False
        self.per_group = 0
        self.outer: Node | None = None
        self.crowd = 0
        self.held = []
        self.sequence: Connector | None = None
        self.places: list[Mention] = []
        self.together: Node | None = None
        self.adding = False
        self.aside: tuple[Node, Listed] | None = None

    def _joined_within(self) -> list[Mention]:
        """What "and" joined last of what a thing has: "a bed with a pillow and a blanket"."""
        frames = (node.frame for node in reversed(self.frontier) if node.frame is not None)
        return next((joined for frame in frames if (joined := frame.last_joined())), [])

    def _lose(self, start: int, end: int) -> None:
        """Note words that name or change a thing and that nothing is made of."""
        self.account.mark(start, end, "not_understood")
        self.draft.unknown.append(self.account.text(start, end))

    def _lose_where(self, where: Where) -> None:
        """Note a relation to a thing or place that could not be made out."""
        nouns = [noun for noun in (where.noun, where.whole, where.second) if noun is not None and noun.start < noun.end]
        kinds = ("thing", "part", "place", "number")
        other = bool(nouns) and nouns[0].kind == "pronoun" and nouns[0].text.lower() not in ("this", "that")
        other &= bool(self.draft.things) or where.word != "in"
        if where.noun is None and (where.word == "outside" or where.text.lower() == "inside") and where.text:
            self._lose(where.start, where.start + len(where.text.split()))
        if nouns and (nouns[0].kind in kinds or other) and where.text:
            self._lose(where.start, nouns[-1].end)

    def peek(self, ahead: int = 0) -> Chunk | None:
        """The chunk so many after the next one."""
        index = self.at + ahead
        return self.chunks[index] if 0 <= index < len(self.chunks) else None

    def _next_noun(self, ahead: int = 0) -> Noun | None:
        """The noun that comes next, past fillers."""
        index = self._skip_fillers(self.at + ahead)
        chunk = self.chunks[index] if index < len(self.chunks) else None
        return chunk if isinstance(chunk, Noun) else None

    def _is_filler(self, chunk: Chunk) -> bool:
        if isinstance(chunk, Connector):
            return chunk.sort == "fillers"
        return isinstance(chunk, Adjective) and not chunk.attributes

    def _is_link(self, chunk: Chunk | None, sort: str, *values: str) -> bool:
        return isinstance(chunk, Connector) and chunk.sort == sort and (not values or chunk.value in values)

    def _skip_fillers(self, index: int) -> int:
        """The first index from `index` on that is no filler."""
        while index < len(self.chunks) and self._is_filler(self.chunks[index]):
            index += 1
        return index

    def _before(self, back: int = 1) -> Chunk | None:
        """The chunk so many before the one that is being read."""
        index = self.at - 1 - back
        return self.chunks[index] if index >= 0 else None

    def _clause_start(self) -> int:
        """The chunk after the last mark that ended a sentence."""
        ends = (n for n in range(self.at - 2, -1, -1) if self._is_link(self.chunks[n], "mark", "stop", "semicolon"))
        return next(ends, -1) + 1

    def _go_past(self, noun: Noun) -> None:
        """Go on after a noun that was found ahead."""
        while self.at < len(self.chunks):
            self.at += 1
            if self.chunks[self.at - 1] is noun:
                return

    def _belongs(self, noun: str, group: str) -> bool:
        """Whether a noun belongs to a group of things; what nobody knows counts as small."""
        return self.habits.is_in(noun, group)
