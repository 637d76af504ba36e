"""What the last noun of a phrase makes of it; phrases without a noun."""

from collections.abc import Mapping

from thinkblox.assets.names import identifier_of
from thinkblox.assets.plurals import singular
from thinkblox.assets.stand_ins import noun_of
from thinkblox.knowledge.vocabulary import is_abstract, is_person, name_of, thing_called
from thinkblox.reading.adjectives import adjective_kinds
from thinkblox.reading.english.chunks import Noun, NounKind
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.english.modifiers import Modifiers
from thinkblox.reading.english.words import Known, Unit, Units
from thinkblox.reading.lexicon import Sort

_KINDS: Mapping[Sort, NounKind] = {"room": "room", "place": "place"}
"""What phrases of the lexicon are that are no things."""

_SMALL = {"small", "tiny"}
"""What makes things of what is none: "six little houses"."""
_ADJECTIVAL = (
    "ed",
    "able",
    "ible",
    "ous",
    "ful",
    "less",
    "ish",
    "like",
    "style",
    "shaped",
    "sized",
    "coloured",
    "colored",
)
"""Endings of words that describe a thing rather than say of which kind it is."""
ARTICLES = ("a", "an")
"""Articles with which a name of the catalogue may begin: "a single bed", which is no single "bed"."""


class Heads(Modifiers):
    """Reads the heads of phrases."""

    def _head(self, noun: Noun, units: Units) -> None:
        nouns = units.nouns
        self._leave_out(noun, nouns)
        for unit in nouns[:-1]:
            if unit.owner and unit.known is not None and unit.known.entry.sort == "object":
                noun.owner = unit.known.entry.value
        last = nouns[-1]
        part = grammar().phrases.get(tuple(last.text.lower().split()), ())
        if len(nouns) > 1 and nouns[-2].owner and nouns[-2].known is not None and dict(part).get("parts"):
            noun.kind, noun.value, noun.owner = "part", dict(part)["parts"], nouns[-2].known.entry.value
            return
        whole = nouns[-2].known if len(nouns) > 1 and last.text.lower() in grammar().lists["parts"] else None
        if whole is not None and whole.entry.sort == "object":
            plural = noun.plural
            self._known_head(noun, whole)
            noun.plural = plural if nouns[-2].owner else noun.plural
            noun.within = True
            return
        if self._is_columns(noun, nouns):
            return
        named = [unit for unit in nouns if not unit.owner] or [last]
        people = "people" in dict(grammar().phrases.get((last.text.lower(),), ()))
        if people and noun.det in ("the", "my", "") and noun.count is None:
            noun.kind, noun.value = "people", "people"
            noun.count = grammar().people([last.text.lower()]) or None
            return
        if last.known is not None:
            self._known_head(noun, self._kind_of_room(nouns) or last.known)
            self._no_hallway(noun, nouns)
            self._modifiers(noun, named[:-1])
            self._kind_of_its_own(noun, named[:-1], last)
            return
        words = list(dict.fromkeys(word for unit in named for word in unit.text.lower().split()))
        if self._people_or_abstract(noun, words):
            return
        noun.kind, noun.named = "thing", False
        noun.plural |= singular(words[-1]) != words[-1]
        noun.value = identifier_of(noun_of(" ".join([*words[:-1], singular(words[-1])])))

    def _leave_out(self, noun: Noun, nouns: list[Unit]) -> None:
        """Take off what is no part of the name: whose it is, and what several things do."""
        while len(nouns) > 1 and nouns[-1].owner and not _is_room(nouns[-1]):
            nouns.pop()
        if self._are_doing(nouns):
            nouns.pop()
            noun.end -= 1

    @staticmethod
    def _are_doing(nouns: list[Unit]) -> bool:
        """Whether the last word says what several things do: "gloves | drying everywhere"."""
        things = nouns[-2].known if len(nouns) > 1 else None
        several = things is not None and things.entry.sort == "object" and nouns[-2].text.endswith("s")
        return several and nouns[-1].known is None and nouns[-1].text.lower().endswith("ing")

    def _called(self, noun: Noun, units: Units) -> str:
        """What the phrase calls one of them: "treatment table" of "two white treatment tables"."""
        looks = (*noun.attributes, *noun.unshown, *noun.states, *noun.styles)
        told = {word for look in looks for word in look.replace("-", " ").split()}
        words = [word for unit in units.nouns for word in unit.text.lower().split()]
        words = words[1:] if len(words) > 1 and words[0] in ARTICLES else words
        head = words.index("of") - 1 if "of" in words[1:] else len(words) - 1
        words[head] = singular(words[head]) if noun.plural else words[head]
        name = " ".join(word for at, word in enumerate(words) if at >= head or not told.issuperset(word.split("-")))
        return self._with_matter(noun, units, name)

    def _with_matter(self, noun: Noun, units: Units, name: str) -> str:
        """The name with the look before it where both are one name of the thing: "rubber stamp"."""
        before = noun.end - len(" ".join(unit.text for unit in units.nouns).split()) - 1
        look = self._text(before, before + 1).lower() if before >= noun.start else ""
        whole = thing_called(f"{look} {name}", 1 + len(name.split())) if look else None
        return f"{look} {name}" if whole is not None and whole.category.endswith(noun.value) else name

    def _no_hallway(self, noun: Noun, nouns: list[Unit]) -> None:
        """Take a hall of some kind that we do not know for a room: a village hall is no hallway."""
        if noun.kind == "room" and nouns[-1].text.lower() == "hall" and len(nouns) > 1:
            noun.value = noun.value if self._kind_of_room(nouns) else "room"

    def _kind_of_room(self, nouns: list[Unit]) -> Known | None:
        """The gym of "a gym room"."""
        last, kind = nouns[-1].known, nouns[-2].known if len(nouns) > 1 else None
        general = last is not None and (last.entry.value == "room" or nouns[-1].text.lower() == "hall")
        of_room = general and kind is not None and kind.entry.sort == "room"
        return kind if of_room else None

    def _is_columns(self, noun: Noun, nouns: list[Unit]) -> bool:
        """Read "in two columns" as rows."""
        within = self._text(noun.start - 1, noun.start).lower() == "in" and not noun.det and bool(noun.count)
        if not within or len(nouns) > 1 or nouns[0].text.lower() not in ("columns", "rows", "lines"):
            return False
        noun.kind, noun.rows, noun.count = "number", noun.count or 0, None
        return True

    def _known_head(self, noun: Noun, known: Known) -> None:
        entry = known.entry
        noun.value = entry.value
        noun.plural |= entry.plural
        noun.kind = _KINDS.get(entry.sort, "thing")
        if entry.sort == "missing":
            words = self._text(noun.end - known.length, noun.end).lower().split()
            noun.value = identifier_of(noun_of(" ".join([*words[:-1], singular(words[-1])])))
            noun.plural |= singular(words[-1]) != words[-1]
            noun.named = False
        if entry.attribute:
            noun.attributes.append(entry.attribute)
        elif (said := self._said_within(noun.end - known.length, known)) and said not in noun.attributes:
            noun.attributes.append(said)
        noun.material = next((other.value for other in known.others if other.sort == "attribute"), "")
        noun.room = next((other.value for other in known.others if other.sort == "room"), "")

    def _said_within(self, at: int, known: Known) -> str:
        """What a name says of the thing besides naming it: "plastic" in "plastic chair", where a chair is a chair."""
        said = self._known(at, "attribute") if known.length > 1 and known.entry.sort == "object" else None
        if said is None or said.length >= known.length:
            return ""
        rest = self._known(at + said.length, "object")
        same = rest is not None and rest.length == known.length - said.length and rest.entry.value == known.entry.value
        return said.entry.value if same else ""

    def _modifiers(self, noun: Noun, units: list[Unit]) -> None:
        """Nouns before the head tell what it is for, or what is in it; a word that nobody knows may change it."""
        held = noun.kind == "thing" and self._text(noun.end - 1, noun.end).lower() in grammar().lists["holding"]
        for unit in units if not held else ():
            words = unit.text.lower().split()
            if unit.known is None and not grammar().phrases.get(tuple(words)) and not is_purpose(words[-1]):
                noun.unshown.append(unit.text.lower())

    def _kind_of_its_own(self, noun: Noun, units: list[Unit], head: Unit) -> None:
        """Let "a vessel sink" be a thing of that name: its kind is said by a noun that nobody knows."""
        words = [word for unit in units if unit.known is None for word in unit.text.lower().split()]
        types = [word for word in words if not adjective_kinds(word) and not word.endswith(_ADJECTIVAL)]
        types = [word for word in types if not is_purpose(word)]
        if noun.kind != "thing" or not types or len(types) < len(units):
            return
        last = head.text.lower().split()
        noun.value = identifier_of(noun_of(" ".join([*types, *last[:-1], singular(last[-1])])))

    def _people_or_abstract(self, noun: Noun, words: list[str]) -> bool:
        if noun.det == "the" and self._is_row_told_of(noun):
            noun.kind, noun.rows = "number", -1
            return True
        if words[-1] in ("rows", "row", "lines", "columns") and len(words) == 1:
            noun.kind, noun.rows, noun.count = "number", noun.count or -1, None
            return True
        for key in (tuple(words), (words[-1],), *(((words[0],),) if self._trails(noun, words[-1]) else ())):
            found = dict(grammar().phrases.get(key, ()))
            if "people" in found and (key != (words[0],) or len(words) == 1):
                noun.kind, noun.value = "people", "people"
                noun.count = noun.count or grammar().people(words) or None
                return True
            if "abstract" in found and self._is_thing_alone(noun, words):
                noun.kind, noun.value = "thing", f"paint_{words[0]}"
                return True
            if "abstract" in found and not (noun.count and _SMALL & set(noun.attributes)):
                noun.kind, noun.value = "abstract", " ".join(words)
                return True
        if is_person(words[-1]):
            noun.kind, noun.value = "people", "people"
            return True
        if is_abstract(words[-1]) and noun.count is None:
            noun.kind, noun.value = "abstract", " ".join(words)
            return True
        return False

    def _is_row_told_of(self, noun: Noun) -> bool:
        """Whether a row is named of which more is told: "the back row | raised"; goes no further then."""
        at = next((n for n in range(noun.start + 1, noun.end - 1) if self.tokens[n].text == "row"), 0)
        noun.end = at + 1 if at else noun.end
        return bool(at)

    def _is_thing_alone(self, noun: Noun, words: list[str]) -> bool:
        """Whether it is a painter's palette, rather than the colours of a room: nothing is said of it."""
        said = noun.attributes or noun.unshown or noun.styles or self._text(noun.end, noun.end + 1).lower() == "of"
        return words == ["palette"] and noun.det in ("a", "each") and not said

    def _trails(self, noun: Noun, word: str) -> bool:
        """Whether the last word of a name only goes on about the first: "sunlight streaming", not "a safety pole"."""
        named = noun.det in ("a", "another", "each") or noun.count is not None
        return word.endswith(("ing", "ed")) or not (named or name_of([word]) or word in grammar().lists["heads"])

    def _size_after(self, noun: Noun) -> None:
        """Read the count of "armchair x2"."""
        at = noun.end
        if at + 1 < len(self.tokens) and self.tokens[at].text == "x" and self.tokens[at + 1].kind == "number":
            noun.count, noun.end = int(self.tokens[at + 1].value), at + 2

    def _headless(self, noun: Noun, at: int, end: int, units: Units) -> Noun | None:
        """A number, "the left one", or a pronoun."""
        if (some := self._told_apart(noun, at, end)) is not None:
            return some
        if self._is_one(end) and (noun.det or units.adjectives) and not noun.of_known:
            noun.kind, noun.end = "number", end + 1
            noun.plural = self.tokens[end].text == "ones"
            noun.count = noun.count or (None if noun.plural else 1)
            return self._finished(noun)
        if noun.det == "each" and noun.count == 1 and not units.adjectives:
            noun.kind, noun.value, noun.end = "pronoun", "each", max(end, at)
            return self._finished(noun)
        pronoun = grammar().at(self.tokens, noun.start, "pronouns")
        longest = max(end, at)
        if pronoun is not None and noun.start + pronoun.length >= longest and not units.adjectives:
            counted = noun.count is not None and pronoun.value not in ("one", "other", "them")
            if not counted or pronoun.length > 1:
                noun.kind, noun.value, noun.end = "pronoun", pronoun.value, noun.start + pronoun.length
                return self._finished(noun)
        if noun.count is not None or noun.rows or noun.of_known or noun.share:
            noun.kind, noun.end = "number", longest
            return self._finished(noun)
        if noun.det in ("other", "half") and units.adjectives:
            noun.kind, noun.end = "number", longest
            return self._finished(noun)
        if noun.det == "each":
            noun.kind, noun.value, noun.end = "pronoun", "each", longest
            return self._finished(noun)
        return self._named_by_look(noun, longest, units)

    def _named_by_look(self, noun: Noun, end: int, units: Units) -> Noun | None:
        """Read "a white cloth", whose last word is a matter, and "a green" before "and a black chair"."""
        word = self.tokens[end - 1].text
        if noun.det in ("a", "another") and word in grammar().lists["cloths"] and noun.attributes[:-1]:
            noun.attributes = noun.attributes[:-1]
        elif noun.det in ("a", "the", "another", "no", "my") and units.adjectives == 1 and len(noun.attributes) == 1:
            noun.looks, noun.attributes = noun.attributes, []
        else:
            return None
        noun.kind, noun.named, noun.end = "thing", False, end
        noun.value = identifier_of(noun_of(word))
        return self._finished(noun)

    def _told_apart(self, noun: Noun, at: int, end: int) -> Noun | None:
        """Read "the larger one", "every other one", "each one"."""
        if noun.degree and noun.det in ("the", "my"):
            return self._one_by_degree(noun, max(at, end))
        if noun.every and not noun.counted and noun.det == "each":
            noun.kind, noun.end = "number", end + self._is_one(end)
            return self._finished(noun)
        if self._is_one(end) and noun.det == "each":
            noun.kind, noun.value, noun.end = "pronoun", "each", end + 1
            return self._finished(noun)
        return None

    def _one_by_degree(self, noun: Noun, end: int) -> Noun:
        """Read "the larger one", "the smallest of them", "the older of which"."""
        end += self._is_one(end)
        noun.plural = self._text(end - 1, end) == "ones"
        if self._text(end, end + 1) == "of":
            end += {"which": 2, "them": 2, "these": 2, "those": 2}.get(self._text(end + 1, end + 2), 0)
            end += 3 if self._text(end + 1, end + 3) in ("the two", "the three", "these two") else 0
        noun.kind, noun.end, noun.of_known = "number", end, True
        noun.count = noun.count or (None if noun.plural else 1)
        return self._finished(noun)

    def _sorted_out(self, noun: Noun) -> None:
        """Keep of the modifiers that nobody knows those that change what one sees."""
        for word in [*noun.unshown]:
            kinds = adjective_kinds(word)
            if kinds == {"filler"} or kinds == {"style"} or "state" in kinds:
                noun.unshown.remove(word)
                noun.styles += [word] if kinds == {"style"} else []
                noun.states += [word] if "state" in kinds else []

    def _finished(self, noun: Noun) -> Noun:
        self._sorted_out(noun)
        noun.text = self._text(noun.start, noun.end)
        if noun.every and noun.counted:
            noun.count = None
        return noun


def is_purpose(word: str) -> bool:
    """Whether a word before a noun only says whom or what it is for: "a client chair", "a demonstration bench"."""
    return is_person(word) or is_abstract(word) or grammar().knows(word, "people", "abstract")


def _is_room(unit: Unit) -> bool:
    """Whether it is named after whose it is: "an old school barber's"."""
    return unit.known is not None and unit.known.entry.sort == "room"
