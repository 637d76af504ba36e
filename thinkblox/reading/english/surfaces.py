"""What a text says of floors and walls: "white walls", "the floor is oak parquet", "a tiled kitchen"."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from thinkblox.brief import SurfaceRequest
from thinkblox.knowledge.surfaces import Part, shaded, surface_words
from thinkblox.layings import Colour, Laying
from thinkblox.reading.english.grammar import grammar
from thinkblox.reading.tokens import Token

_HEADS: dict[str, Part] = {
    "wall": "walls",
    "walls": "walls",
    "floor": "floor",
    "floors": "floor",
    "flooring": "floor",
    "floorboards": "floor",
}
_MASSES: dict[str, Part] = {
    "wallpaper": "walls",
    "panelling": "walls",
    "paneling": "walls",
    "wainscoting": "walls",
    "brickwork": "walls",
    "parquet": "floor",
    "linoleum": "floor",
    "lino": "floor",
    "terrazzo": "floor",
    "carpeting": "floor",
    "flooring": "floor",
    "floorboards": "floor",
}
"""Words for a surface that need no floor or wall after them."""
_EXPOSED = ("walls", "brick")
"""What is said of walls without naming them."""
_FINISHED = ("carpeted", "tiled", "panelled", "paneled", "wallpapered", "whitewashed", "walled", "floored")
"""What a room can be called by its surfaces."""
_ARTICLES = ("a", "an", "the", "its", "all", "some", "four", "three", "two", "one")
_LAID = "painted papered wallpapered tiled panelled paneled carpeted covered clad lined finished done made laid".split()
_OF_ROOM = 3
"""Words of "of the room"."""
_IN = ("in", "with", "of", "from")
_DENIED = ("no", "not", "without", "non", "never", "instead")
_DARK, _LIGHT = "charcoal", "cream"
_DARK_WOOD, _LIGHT_WOOD = "walnut", "ash"
_TWO_COLOURS = ("checker", "stripes", "motifs", "flowers")
_CHECKERED = (None, "tiles")
"""What a floor of two colours may be called besides."""
_GENERAL: tuple[Laying, ...] = ("planks", "panels", "tiles", "paint", "motifs")
"""What other words tell more closely: "oak parquet", "subway tiles", "striped wallpaper"."""


@dataclass
class _Look:
    """Words for what a surface is like, up to before token `end`."""

    end: int
    layings: list[Laying] = field(default_factory=list)
    colours: list[str] = field(default_factory=list)
    shades: list[float] = field(default_factory=list)

    def request(self, part: Part, *, one: bool, phrase: str) -> SurfaceRequest | None:
        """What is asked for; None for words that ask for nothing, or for two colours that nothing lays together."""
        own = [laying for laying in self.layings if laying not in _GENERAL]
        laying = next(iter(own or self.layings), None)
        names = list(dict.fromkeys(self.colours))
        if len(names) > 1 and laying not in _TWO_COLOURS:
            woods = [name for name in names if name in surface_words().woods]
            names = [name for name in names if name not in woods] if len(woods) < len(names) else names
        if part == "floor" and len(names) == 2 and laying in _CHECKERED:
            laying = "checker"
        if len(names) > 2 or (len(names) == 2 and laying not in _TWO_COLOURS):
            return None
        colour = self._colour(names, laying)
        if laying is None and colour is None:
            return None
        second = surface_words().colours[names[1]] if len(names) == 2 else None
        where = "wall" if part == "walls" and one else part
        return SurfaceRequest(part=where, laying=laying, colour=colour, second=second, phrase=phrase)

    def _colour(self, names: list[str], laying: Laying | None) -> Colour | None:
        shade = next((s for s in self.shades if s), 0.0)
        known = surface_words().colours
        if names:
            return shaded(known[names[0]], shade) if shade else known[names[0]]
        if not shade:
            return None
        wooden = laying in ("planks", "parquet", "herringbone", "panels")
        return known[(_DARK_WOOD if wooden else _DARK) if shade < 0 else (_LIGHT_WOOD if wooden else _LIGHT)]


@dataclass(frozen=True)
class SurfaceFinding:
    """A request, and before which token its words end."""

    end: int
    request: SurfaceRequest


def surface_at(tokens: Sequence[Token], at: int, is_room: Callable[[int], bool]) -> SurfaceFinding | None:
    """What is asked of a floor or of walls by words that begin at `at`; None where they ask for something else.

    `is_room` says whether the name of a room begins at a token.
    """
    before = tokens[at - 1].text if at else ""
    if before in _DENIED or tokens[at].kind != "word":
        return None
    start = at + 1 if tokens[at].text in _ARTICLES else at
    if not _may_begin(_text(tokens, start)):
        return _said_of_room(tokens, start, is_room)
    for reader in (_said_before, _said_after, _said_by_itself):
        if (found := reader(tokens, at, start)) is not None:
            return found
    return _said_of_room(tokens, start, is_room)


def _may_begin(word: str) -> bool:
    """Whether a word can be the first that says what a floor or walls are like."""
    words = surface_words()
    said = word in words.colours or word in words.shades or word in words.fillers
    return said or word in _HEADS or word in words.walls or word in words.floor


def _said_before(tokens: Sequence[Token], at: int, start: int) -> SurfaceFinding | None:
    """Read "white walls", "a dark oak floor", "tiles on the floor"."""
    for part in ("walls", "floor"):
        look = _look(tokens, start, part)
        head = _text(tokens, look.end)
        if look.end == start or (head in _HEADS and _HEADS[head] != part):
            continue
        end = look.end + 1
        if head in ("on", "for") and look.layings:
            end = look.end + 2 + (_text(tokens, look.end + 1) in ("the", "all", "its"))
            head = _text(tokens, end - 1)
        if _HEADS.get(head) == part and _is_over(tokens, end):
            # "Floorboards" are said to be of wood by themselves.
            own = surface_words().layings(part).get(head)
            look.layings += [own] if own else []
            one = head == "wall" and _text(tokens, at) != "all"
            request = look.request(part, one=one, phrase=_shown(tokens, start, end))
            if request is not None:
                return SurfaceFinding(end, request)
    return None


def _said_after(tokens: Sequence[Token], at: int, start: int) -> SurfaceFinding | None:
    """Read "the walls are painted green", "floor covered in grey linoleum", "walls of brick"."""
    head = _text(tokens, start)
    part = _HEADS.get(head)
    if part is None:
        return None
    place = start + 1
    place += _OF_ROOM if [_text(tokens, place + n) for n in range(2)] == ["of", "the"] and _says(tokens, place) else 0
    said = _text(tokens, place) in ("is", "are")
    place += said
    laid = _text(tokens, place) in _LAID
    verb = place
    place += laid
    joined = _text(tokens, place) in _IN
    place += joined
    place += _text(tokens, place) in ("a", "an")
    if not (said or laid or joined):
        return None
    look = _look(tokens, place, part)
    own = surface_words().layings(part).get(_text(tokens, verb)) if laid else None
    if not _is_over(tokens, look.end) or (look.end == place and not said) or (joined and look.end == place):
        return None
    look.layings += [own] if own else []
    request = look.request(part, one=head == "wall", phrase=_shown(tokens, start, look.end))
    return None if request is None else SurfaceFinding(look.end, request)


def _said_by_itself(tokens: Sequence[Token], at: int, start: int) -> SurfaceFinding | None:
    """Read "striped wallpaper", "oak parquet", "white wall tiles", "wall-to-wall carpet"."""
    if [_text(tokens, start + n) for n in range(3)] == ["wall", "to", "wall"]:
        look = _look(tokens, start + 3, "floor")
        request = look.request("floor", one=False, phrase=_shown(tokens, start, look.end))
        return SurfaceFinding(look.end, request) if request is not None and "carpet" in look.layings else None
    for part in ("walls", "floor"):
        look = _look(tokens, start, part)
        end = look.end
        last = _text(tokens, end - 1)
        found = end > start and (_MASSES.get(last) == part or ((part, last) == _EXPOSED and _bares(tokens, start)))
        if not found and _HEADS.get(_text(tokens, end)) == part and _text(tokens, end + 1) in ("tile", "tiles"):
            look.layings.append("tiles")
            end, found = end + 2, True
        if found and _is_over(tokens, end):
            request = look.request(part, one=False, phrase=_shown(tokens, start, end))
            if request is not None:
                return SurfaceFinding(end, request)
    return None


def _says(tokens: Sequence[Token], at: int) -> bool:
    """Whether "are" comes after "of the room"."""
    return _text(tokens, at + _OF_ROOM) in ("is", "are")


def _bares(tokens: Sequence[Token], start: int) -> bool:
    """Whether a wall is said to show what it is built of: "exposed brick"."""
    return _text(tokens, start) in ("exposed", "bare")


def _said_of_room(tokens: Sequence[Token], start: int, is_room: Callable[[int], bool]) -> SurfaceFinding | None:
    """Read "carpeted" in "a carpeted office", "brick-walled" in "a brick-walled cafe"; the room itself is left."""
    end = next((n for n, token in enumerate(tokens[start : start + 3], start) if token.text in _FINISHED), None)
    if end is None or not is_room(end + 1):
        return None
    said = _text(tokens, end)
    part: Part = "floor" if said in ("carpeted", "tiled", "floored") else "walls"
    look = _look(tokens, start, part)
    if look.end != (end if said in ("walled", "floored") else end + 1):
        return None
    request = look.request(part, one=False, phrase=_shown(tokens, start, end + 1))
    return None if request is None else SurfaceFinding(end + 1, request)


def _look(tokens: Sequence[Token], start: int, part: Part) -> _Look:
    """The longest run of words for what a part of the room is like."""
    words, found, at = surface_words(), _Look(start), start
    layings = words.layings(part)
    while at < len(tokens):
        word = _text(tokens, at)
        joins = word == "and" and found.colours and _text(tokens, at + 1) in words.colours and at > start
        if not joins:
            if word in layings:
                found.layings.append(layings[word])
            if word in words.colours:
                found.colours.append(word)
            elif word in words.shades:
                found.shades.append(words.shades[word])
            elif word not in layings and word not in words.fillers:
                break
        at += 1
    found.end = at
    return found


def _is_over(tokens: Sequence[Token], at: int) -> bool:
    """Whether nothing follows of which the words could be a part, as in "a wooden floor lamp"."""
    if at >= len(tokens) or tokens[at].kind != "word":
        return True
    if tokens[at - 1].owner:
        return False
    return grammar().at(tokens, at, "joins", "prepositions", "verbs", "fillers", "inverses", "participles") is not None


def _text(tokens: Sequence[Token], at: int) -> str:
    return tokens[at].text if 0 <= at < len(tokens) else ""


def _shown(tokens: Sequence[Token], start: int, end: int) -> str:
    return " ".join(token.shown for token in tokens[start:end])
