"""Goals of a robot: "the robot must put the mug on the shelf".

A goal names things that are there. Where they are to be in the end is not asked of the room; where they are now is:
"the mug on the desk", "from the shelf", "the table, which has four chairs around it".
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from thinkblox.reading.english.chunks import Adjective, Chunk, Connector, Noun
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.said import is_link, is_spatial

GOAL = "goal"
"""What stands before the names of things that a goal speaks of."""
_MOST = 3
"""Most chunks between who does something and what is done."""
_ENDS = ("stop", "semicolon")


def with_goals(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Chunks in which a goal only names what is to be moved and what it is moved to, and tells where things are."""
    made: list[Chunk] = []
    at = 0
    while at < len(chunks):
        length = _goal(chunks, at)
        if not length:
            made.append(_there(chunks, at))
            at += 1
            continue
        who = chunks[at]
        new = isinstance(who, Noun) and who.kind == "thing" and who.det == "a"
        made += [chunk if new and chunk is who else _filler(chunk) for chunk in chunks[at : at + length]]
        at += length
        end = next((n for n in range(at, len(chunks)) if is_link(chunks[n], "mark", *_ENDS)), len(chunks))
        made += _Aims(chunks[at - 1 : end]).read()
        at = end
    return made


def _there(chunks: Sequence[Chunk], at: int) -> Chunk:
    """A robot of which it is told where it stands, as a thing of the room; any other chunk as it is."""
    who, stands, link = (*chunks[at : at + 3], None, None)[:3]
    assert who is not None
    robot = isinstance(who, Noun) and who.kind == "people" and who.word in grammar().lists["robots"]
    placed = is_link(stands, "verbs", "be", "stand") and isinstance(link, Connector) and is_spatial(link)
    return replace(who, kind="thing", value=who.word) if robot and placed and isinstance(who, Noun) else who


def _goal(chunks: Sequence[Chunk], at: int) -> int:
    """How many chunks say that a goal comes, with its verb: "the robot must put", "task: move"; 0 where none does."""
    who = chunks[at]
    again = is_link(who, "joins", "and") and _is_of_robot(chunks[:at])
    if not (again or isinstance(who, Noun)) or (at and is_link(chunks[at - 1], "prepositions")):
        return 0
    robot = again or (isinstance(who, Noun) and who.word in grammar().lists["robots"])
    goal = isinstance(who, Noun) and who.word in grammar().lists["goals"]
    if robot and _does(chunks, at + 1):
        return 2
    end = at + 1
    while end < len(chunks) and end - at <= _MOST and (robot or goal) and not _is_act(chunks[end]):
        if not _leads(chunks[end], goal=goal):
            return 0
        end += 1
    return end - at + 1 if at + 1 < end < len(chunks) and _is_act(chunks[end]) else 0


def _is_of_robot(before: Sequence[Chunk]) -> bool:
    """Whether a sentence begins with a robot: "the robot is by the door and must put ..."."""
    ends = (n for n in range(len(before) - 1, -1, -1) if is_link(before[n], "mark", *_ENDS))
    first = next(iter(before[next(ends, -1) + 1 :]), None)
    return isinstance(first, Noun) and first.word in grammar().lists["robots"]


def _does(chunks: Sequence[Chunk], at: int) -> bool:
    """Whether it is told what somebody does with a thing that is known: "the robot takes the cup"."""
    said = chunks[at : at + 2]
    acts = len(said) > 1 and isinstance(said[0], Connector) and said[0].sort == "verbs"
    return acts and _is_act(said[0], "es", "s") and isinstance(said[1], Noun) and said[1].det == "the"


def _leads(chunk: Chunk, *, goal: bool) -> bool:
    """Whether a chunk stands between who does something, or the word for a goal, and what is to be done."""
    if is_link(chunk, "verbs", "be", "have") or is_link(chunk, "fillers") or is_link(chunk, "prepositions", "to"):
        return True
    return (goal and is_link(chunk, "mark", "colon")) or _words(chunk) in grammar().lists["modals"]


def _is_act(chunk: Chunk, *endings: str) -> bool:
    """Whether it is a word for doing something with things."""
    lists = grammar().lists
    word = _words(chunk).partition(" ")[0]
    return any(word.removesuffix(end) in lists[name] for end in ("", *endings) for name in ("moving", "handling"))


class _Aims:
    """Reads what is to be done, up to the end of a sentence; its first chunk is the verb.

    Attributes:
        handled: things stay where they are ("open"), so that nothing but "to" says where to.
        aimed: it was said where to.
        told: what comes tells of a thing how it is now.
    """

    def __init__(self, chunks: Sequence[Chunk]) -> None:
        self.chunks = chunks
        self.at = 1
        self._begin(chunks[0])

    def read(self) -> list[Chunk]:
        """What the chunks after the verb are read as."""
        made: list[Chunk] = []
        while self.at < len(self.chunks):
            made += self._next(self.chunks[self.at])
            self.at += 1
        return made

    def _begin(self, verb: Chunk) -> None:
        word = _words(verb).partition(" ")[0]
        forms = {word, word.removesuffix("s"), word.removesuffix("es")}
        self.taken = not forms.isdisjoint(grammar().lists["taking"])
        self.handled = self.taken or not forms.isdisjoint(grammar().lists["handling"])
        self.aimed = self.told = False

    def _next(self, chunk: Chunk) -> Iterator[Chunk]:
        before, after = self.chunks[self.at - 1], self._after()
        if _is_act(chunk, "es", "s") and (not isinstance(chunk, Noun) or isinstance(after, Noun)):
            self._begin(chunk)
            yield _filler(chunk)
        elif isinstance(chunk, Noun):
            yield from self._noun(chunk, before)
        elif is_link(chunk, "joins", "which"):
            self.told = True
            yield chunk
        elif is_link(chunk, "joins", "and") or is_link(chunk, "mark", "comma") or is_link(chunk, "joins", "but"):
            yield from self._joined(chunk, after)
        elif isinstance(chunk, Connector) and chunk.sort == "prepositions":
            yield from self._preposition(chunk, before)
        elif isinstance(chunk, Adjective) or (self.told and isinstance(chunk, Connector)):
            yield chunk
        else:
            yield chunk if is_link(chunk, "participles") and not self._is_aim(after) else _filler(chunk)

    def _after(self) -> Chunk | None:
        return self.chunks[self.at + 1] if self.at + 1 < len(self.chunks) else None

    def _noun(self, noun: Noun, before: Chunk) -> Iterator[Chunk]:
        """A thing is named, as part of what tells of another or by itself; "it" is what was named."""
        if self.told or is_link(before, "joins", "and") or is_link(before, "mark", "comma"):
            yield noun
        elif noun.kind == "thing":
            bare = not noun.det and noun.plural and noun.count is None
            stop = Connector("mark", "stop", noun.start, noun.start)
            yield from (stop, Connector("fillers", GOAL, noun.start, noun.start))
            yield replace(noun, det="the") if bare else noun
        else:
            yield _filler(noun)

    def _joined(self, chunk: Chunk, after: Chunk | None) -> Iterator[Chunk]:
        """What is listed with a thing is named with it, and what comes after a goal's end is a goal again."""
        listed = isinstance(after, Noun) and after.kind == "thing"
        pronoun = is_link(after, "joins", "which")
        if listed and self.aimed and not self.told:
            self.aimed = False
            self.chunks = [*self.chunks[: self.at], _filler(chunk), *self.chunks[self.at + 1 :]]
            yield _filler(chunk)
        elif self.told or listed or pronoun:
            yield chunk
        else:
            yield _filler(chunk)

    def _preposition(self, link: Connector, before: Chunk) -> Iterator[Chunk]:
        if self._is_aim(link):
            self.aimed, self.told = True, False
            yield _filler(link)
            return
        after = self._after()
        counted = isinstance(after, Noun) and (after.det in ("a", "no") or after.count is not None or after.plural)
        now = is_spatial(link) or link.value in ("from", "of") or (link.value == "with" and counted)
        if (isinstance(before, Noun) and before.kind == "thing") or self.told or is_link(before, "participles"):
            self.told |= now
        yield (replace(link, value="on") if link.value == "from" else link) if self.told else _filler(link)

    def _is_aim(self, link: Chunk | None) -> bool:
        """Whether it is said where to: with "to" and "into", or the first time where, after a verb of putting."""
        if not isinstance(link, Connector) or link.sort != "prepositions" or self.aimed:
            return False
        if link.text.lower() in grammar().lists["directions"]:
            return True
        ahead = (_words(c) for c in self.chunks[self.at + 1 :] if is_link(c, "prepositions"))
        later = not grammar().lists["directions"].isdisjoint(ahead)
        return is_spatial(link) and not self.handled and not self.told and not later


def _filler(chunk: Chunk) -> Connector:
    return Connector("fillers", "words", chunk.start, chunk.end, _words(chunk))


def _words(chunk: Chunk) -> str:
    return str(getattr(chunk, "text", "")).lower()
