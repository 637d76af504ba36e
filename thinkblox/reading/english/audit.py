"""What was passed over without becoming anything, and things of which nothing is known: both are said."""

from itertools import pairwise

from thinkblox.assets import CATALOGUE
from thinkblox.assets.catalogue import GENERAL_WORDS
from thinkblox.assets.palette import COLOURS, without_general
from thinkblox.assets.repaint import LOOKS
from thinkblox.assets.stand_ins import stand_in
from thinkblox.knowledge.rooms import room_type
from thinkblox.reading.adjectives import adjective_kinds
from thinkblox.reading.draft import MISSING, Mention
from thinkblox.reading.english.across import settle_opposite_walls
from thinkblox.reading.english.chunks import Connector, Noun
from thinkblox.reading.english.doubts import Doubts
from thinkblox.reading.english.front import settle_front
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.hanging import hang_up
from thinkblox.reading.english.second import SecondOpinion
from thinkblox.reading.english.sequences import settle_sequences

_SPELLED = 0.93
"""How alike two spellings of one name are at least."""
_ENDINGS = ("ed", "ing", "ly", "less", "able", "ible", "ous", "ful")
"""How words end that are no names of things, where nobody knows such a thing."""


class Audit(Doubts):
    """Looks over what was read."""

    def _audit(self) -> None:
        """List what nothing was made of, and what nobody knows."""
        for chunk in self.chunks:
            if not isinstance(chunk, Noun) or chunk.kind != "thing" or (chunk.start, chunk.end) in self.spent:
                continue
            if not self.account.is_lost(chunk.start, chunk.end):
                self._lose(chunk.start, chunk.end)
        for thing in self.draft.things:
            self._find_each(thing)
        for link in (c for c in self.chunks if isinstance(c, Connector) and c.sort == "sequences"):
            if not any(link is told for told, _ in self.ordered):
                self._lose(link.start, link.end)
        settle_sequences(self.draft, [bond for _, bond in self.ordered])
        self._allow_asked()
        settle_opposite_walls(self.draft)
        hang_up(self.draft, self.cut, self.meant)
        self._doubts()
        self._ask_again()
        settle_front(self.draft)
        for thing in list(self.draft.things):
            self._look_otherwise(thing)
            self._contradicts(thing)
            noun = self.named_by.get(thing)
            if noun is not None and not _is_known(thing):
                self._doubt(thing, noun)

    def _allow_asked(self) -> None:
        """Say of what is both asked for and not to be there that nobody knows where it is not to be.

        A mirror may hang where there is to be nothing but it on the walls.
        """
        asked = {thing.noun for thing in self.draft.things if thing.asked}
        self.draft.excluded -= asked & grammar().lists["on_walls"] - self.excluded_by.keys()
        for name, noun in self.excluded_by.items():
            if name in asked and name in self.draft.excluded:
                self.draft.excluded.discard(name)
                self._lose(max(noun.start - (noun.det != "no"), 0), noun.end)

    def _ask_again(self) -> None:
        """Say where a second look at the words disagrees with what was read, unless these are said already."""
        for found in SecondOpinion(self.draft, self.referents, self.meant).disagreements(self.cut):
            text = self.account.text(found.start, found.end)
            told = self.account.is_any_lost(found.start, found.end)
            if not told and not any(text in unknown or unknown in text for unknown in self.draft.unknown):
                self.account.mark(found.doubtful.start, found.doubtful.stop, "not_understood")
                self.draft.unknown.append(f"{text} ({found.question})")

    def _find_each(self, thing: Mention) -> None:
        """Take "each nightstand" for as many as such a room has; where it has none, say that none was named."""
        noun = self.named_by.get(thing)
        counted = noun is not None and noun.count is not None
        if noun is not None and noun.det == "each" and not counted and thing not in self.told_later:
            usual = (usual.count for usual in room_type(self.draft.room).usual if usual.category == thing.noun)
            alike = [other for other in self.draft.things if other.noun == thing.noun]
            if (count := next(usual, 0)) > 1 and alike == [thing]:
                thing.count, thing.plural = count, True
                return
            self.account.mark(noun.start, noun.end, "not_understood")
            self.draft.unknown.append(f"{noun.text} (none named)")

    def _look_otherwise(self, thing: Mention) -> None:
        """Give the one of "six blue chairs, one of which is red" the colour, material or shape told of it alone."""
        before = self.referents.inherited.get(thing, [])
        own = thing.attributes[len(before) :]
        if thing.attributes[: len(before)] != before:
            return
        kinds = (COLOURS.keys(), LOOKS - COLOURS.keys(), grammar().lists["shapes"])
        told = [kind for kind in kinds if any(look in kind for look in own)]
        thing.attributes = [look for look in before if not any(look in kind for kind in told)] + own

    def _contradicts(self, thing: Mention) -> None:
        """Say of a thing that was given two colours at different places that it cannot have both."""
        colours = [a for a in without_general(thing.attributes) if a in COLOURS]
        noun = self.named_by.get(thing)
        if len(colours) < 2 or (noun is not None and set(colours) <= set(noun.attributes)):
            return
        text = " ".join(token.lower() for token in self.account.all_words())
        if not any(
            f"{a} and {b}" in text or f"{b} and {a}" in text or f"{a} {b}" in text for a, b in pairwise(colours)
        ):
            self.draft.unknown.append(f"{thing.text}: {' or '.join(colours)}")

    def _doubt(self, thing: Mention, noun: Noun) -> None:
        """Say that nothing is known of a thing; what is plainly no name of one is not made."""
        word = noun.text.rpartition(" ")[2].lower()
        self.account.mark(noun.start, noun.end, "not_understood")
        self.draft.unknown.append(f"{noun.text} (no such thing is known)")
        if word.endswith(_ENDINGS) or adjective_kinds(word):
            self.draft.drop(thing)


def _is_known(thing: Mention) -> bool:
    """Whether anything is known of such a thing: its shape, its size, or what it is a kind of."""
    if thing.noun in CATALOGUE or thing.noun in GENERAL_WORDS or thing.noun == MISSING:
        return True
    found = stand_in(thing.noun)
    match found.how:
        case "plain":
            return False
        case "spelling":
            return found.similarity >= _SPELLED
        case _:
            return True
