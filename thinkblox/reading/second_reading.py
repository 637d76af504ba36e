"""A brief that somebody else has read, held against what the grammar reads of the same prompt.

Where the two differ over what the prompt says in so many words (sizes, numbers, what is to be there and what not, and
what stands by what) nobody knows which is right, so that those words are not understood.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence

from msgspec import structs

from thinkblox.assets import CATALOGUE
from thinkblox.brief import Brief, Relation, Request
from thinkblox.errors import InputError
from thinkblox.knowledge.things import are_alike, counts_as
from thinkblox.reading.language import lexicon_of
from thinkblox.reading.lexicon import Lexicon
from thinkblox.reading.reader import read_brief

_SHARE = 0.02
"""By how much two readings of one length or area may differ."""
_OPPOSITE = {"left_of": "right_of", "right_of": "left_of", "in_front_of": "behind", "behind": "in_front_of"}
"""Relations that are never read for each other."""
_GENERAL = {"wall", "corner", "centre"}
"""Places that the kind of a relation says as well."""


def seconded(brief: Brief) -> Brief:
    """A brief with what it has otherwise than its prompt says, or not at all, as not understood.

    It gets the surfaces that the grammar has read, if it has none. Only things of the catalogue are looked at: of
    others the grammar knows no more than their noun. Where the grammar cannot read the prompt, all stays as it is.
    """
    try:
        read = read_brief(brief.prompt, fill="named")
    except InputError:
        return brief
    found = dict.fromkeys((*brief.unknown, *_of_room(brief, read), *_Things(brief, read).doubts()))
    return structs.replace(brief, unknown=tuple(found), surfaces=brief.surfaces or read.surfaces)


def _of_room(brief: Brief, read: Brief) -> Iterator[str]:
    if read.width and read.depth:
        sides = (brief.width, brief.depth) if brief.width and brief.depth else None
        if sides is None or not _same(sorted(sides), sorted((read.width, read.depth))):
            yield _doubt(f"{read.width:g} m by {read.depth:g} m", f"{sides[0]:g} m by {sides[1]:g} m" if sides else "")
    if read.area:
        area = brief.area or (brief.width or 0.0) * (brief.depth or 0.0)
        if not _same((area,), (read.area,)):
            yield _doubt(f"{read.area:g} m2", f"{area:g} m2" if area else "")
    if read.height and not _same((brief.height or 0.0,), (read.height,)):
        yield _doubt(f"{read.height:g} m high", f"{brief.height:g} m" if brief.height else "")
    if read.shape == "L" and brief.shape != "L":
        yield _doubt("L-shaped")
    for kind in ("door", "window"):
        said = [opening.count for opening in read.openings if opening.kind == kind]
        have = [opening.count for opening in brief.openings if opening.kind == kind]
        if said and sum(said) != sum(have):
            yield _doubt(f"{sum(said)} {kind}{'' if sum(said) == 1 else 's'}", f"{sum(have)}" if have else "")


class _Things:
    """What two briefs have, by category."""

    def __init__(self, brief: Brief, read: Brief) -> None:
        self._brief, self._read, self._lexicon = brief, read, lexicon_of(brief.prompt)
        self._said: dict[str, list[Request]] = defaultdict(list)
        for request in read.requests:
            if request.asked and request.phrase and _is_known(request.category):
                self._said[request.category].append(request)
        self._meant = {category: self._alike(category) for category in self._said}

    def doubts(self) -> Iterator[str]:
        for category, said in self._said.items():
            yield from self._of_number(said, self._meant[category])
            yield from _of_looks(said, self._meant[category], self._brief.prompt.lower())
        meant = {request.category for request in self._brief.requests}
        for category in self._read.excluded:
            if category in meant or not any(counts_as(category, name) for name in self._brief.excluded):
                yield _doubt(f"no {category.replace('_', ' ')}")
        for relation in self._read.relations:
            yield from self._of_relation(relation)

    def _of_number(self, said: Sequence[Request], meant: Sequence[Request]) -> Iterator[str]:
        count, counted = sum(r.count for r in meant), all(_is_counted(r, self._lexicon) for r in said)
        least, most = sum(r.bounds[0] for r in said), sum(r.bounds[1] for r in said)
        if not count or (counted and not least <= count <= most):
            yield _doubt(", ".join(r.phrase for r in said), f"{count}" if count else "")

    def _alike(self, category: str) -> list[Request]:
        """What the brief has of a category, and of such as are none of those that the prompt names besides."""
        said = self._said[category]
        asked = [r for r in self._brief.requests if r.asked]
        return [
            r
            for r in asked
            if r.category == category
            or (r.category not in self._said and (_is_alike(r.category, category) or _is_called_so(r.category, said)))
        ]

    def _of_relation(self, relation: Relation) -> Iterator[str]:
        """Say of a relation that there is none of the kind between those two."""
        subject, anchors = self._keys(relation.subject), [self._keys(anchor) for anchor in relation.anchors]
        if not relation.asked or not subject or not all(anchors):
            return
        if not any(self._is_meant(relation, other, subject, anchors) for other in self._brief.relations):
            denied = "not " if relation.negated else ""
            words = (relation.subject, f"{denied}{relation.kind}", " and ".join(relation.anchors))
            yield _doubt(" ".join(" ".join(words).replace("_", " ").split()))

    def _keys(self, name: str) -> set[str]:
        """The keys in the brief of a request of the grammar's; a place is its own."""
        request = next((r for r in self._read.requests if r.key == name), None)
        return {name} if request is None else {r.key for r in self._meant.get(request.category, ())}

    @staticmethod
    def _is_meant(relation: Relation, other: Relation, subject: set[str], anchors: Sequence[set[str]]) -> bool:
        if other.negated != relation.negated or other.kind == _OPPOSITE.get(relation.kind):
            return False
        ties = {other.subject, *other.anchors}
        if _GENERAL.issuperset(relation.anchors):
            return bool(subject & ties) and (other.kind == relation.kind or not ties.isdisjoint(relation.anchors))
        return bool(subject & ties) and all(anchor & ties for anchor in anchors)


def _is_counted(request: Request, lexicon: Lexicon) -> bool:
    """Whether the prompt says how many: "two chairs", "a chair", but not "chairs" or "some chairs"."""
    tokens = lexicon.tokens(request.phrase)
    meanings = [lexicon.longest(tokens, at) for at in range(len(tokens))]
    one = bool(meanings) and meanings[0].entry("word", value="indefinite") is not None
    return one or any(meaning.entry("count") is not None for meaning in meanings)


def _of_looks(said: Sequence[Request], meant: Sequence[Request], prompt: str) -> Iterator[str]:
    """What nothing that is meant by requests of one category has of their looks and sizes."""
    words = {word.lower() for r in meant for word in (*r.attributes, *r.unshown, *r.states)}
    for request in said if meant else ():
        told = (*request.attributes, *request.unshown, *request.states)
        told = tuple(word.lower() for word in told)
        if lost := [word for word in told if word in prompt and not any(word in each for each in words)]:
            yield f"{request.phrase} (read without {', '.join(lost)})"
        if not any(_is_of_size(other, request) for other in meant):
            yield f"{request.phrase} (read with another size)"


def _is_of_size(request: Request, said: Request) -> bool:
    lengths = [(have or 0.0, want) for have, want in zip(request.size, said.size, strict=True) if want is not None]
    return _same([have for have, _ in lengths], [want for _, want in lengths])


def _is_known(category: str) -> bool:
    return category in CATALOGUE and not CATALOGUE[category].plain


def _is_alike(one: str, other: str) -> bool:
    return are_alike(one, other) or counts_as(one, other) or counts_as(other, one)


def _is_called_so(category: str, said: Sequence[Request]) -> bool:
    """Whether a <bistro_table> is what the prompt calls just "tables", of which the grammar has its own idea."""
    head = category.rpartition("_")[2]
    phrases = [request.phrase.lower() for request in said if request.category.replace("_", " ") not in request.phrase]
    return any(phrase.rpartition(" ")[2].startswith(head) for phrase in phrases)


def _same(have: Sequence[float], said: Sequence[float]) -> bool:
    return all(abs(a - b) <= _SHARE * b for a, b in zip(have, said, strict=True))


def _doubt(words: str, read: str = "") -> str:
    return f"{words} (read as {read})" if read else f"{words} (not read)"
