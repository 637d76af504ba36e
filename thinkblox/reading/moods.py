"""What a prompt tells without naming it: its themes, and the emphasis of a word said three times over."""

from collections.abc import Iterator, Mapping

from msgspec.structs import replace

from thinkblox.assets.stand_ins import stand_in
from thinkblox.brief import Word
from thinkblox.knowledge.rooms import room_type
from thinkblox.knowledge.themes import Found, Theme, themes_in
from thinkblox.reading.draft import Draft

_REACH = 4
"""So many words after a "no", at most, are denied by it."""
_NEGATIONS = frozenset(
    "no not without never nothing nor minus isn't except don't hates allergic forbid forbids vetoed".split()
)
_ARTICLES = frozenset({"a", "an", "the", "my", "our", "his", "her", "their", "some", "old", "little", "two"})
_HOUSEHOLD = 5
"""More people than this use a room, and do not live in it."""
_FACING = ("the", "facing", "face", "faces")
"""What comes before those who are in a room and not whom it is for."""
_SEATED = ("sit", "sitting", "learn", "listen")
"""What several do who only come to a room."""
_IDLE = ("filler", "not_understood", "requested")
"""Fates of words of which no thing was made."""
FEW = 5
"""A prompt with so many kinds of things says what it wants; with fewer, what goes without saying is assumed."""
_MANY = 5
"""Who says a word three times in a row wants so many at least."""


def read_moods(draft: Draft) -> None:
    """Note the themes of a draft whose words are accounted for, and settle which type of room they mean."""
    _drop_misnamed(draft)
    _drop_parts(draft)
    words = draft.account
    taken = _in_names(draft)
    few = len({thing.noun for thing in draft.things}) < FEW
    for found in themes_in([word.text for word in words]):
        told = range(found.start, found.end)
        if taken & set(told) or _is_denied(words, found.start) or _is_of_thing(words, found.start, taken):
            continue
        if _is_crowd(draft, words, found):
            continue
        draft.themes.append(found.theme)
        _account(draft, found.start, found.end)
        if few or (draft.room in found.theme.refines and room_type(draft.room).sleeps):
            _choose_room(draft, found.theme)


def emphasise(draft: Draft) -> None:
    """Take "shoes shoes shoes" for many."""
    said = [word.text.lower() for word in draft.account]
    repeated = {a for a, b, c in zip(said, said[1:], said[2:], strict=False) if a == b == c}
    for thing in [t for t in draft.things if t.count is None]:
        if set(_words(thing.text)) & repeated:
            thing.count = _MANY


def _drop_misnamed(draft: Draft) -> None:
    """Forget the things that are none: "a bookworm", "a football fan", "fire crackling"."""
    for thing in list(draft.things):
        name = [word for word in _words(thing.text) if word not in _ARTICLES]
        found = themes_in(name)
        whole = bool(found) and found[0].start == 0 and found[0].end == len(name)
        if whole and thing.asked and not _is_known(name):
            draft.drop(thing)


def _drop_parts(draft: Draft) -> None:
    """Forget what was not understood and only names a part of the room: the coffee of a coffee corner."""
    said = [word.text.lower() for word in draft.account]
    for found in themes_in(said):
        part = said[found.start : found.end]
        lost = [word for word in draft.account[found.start : found.end] if word.fate == "not_understood"]
        if not found.theme.unless or not lost:
            continue
        for thing in list(draft.things):
            name = [word for word in _words(thing.text) if word not in _ARTICLES]
            if thing.asked and 0 < len(name) < len(part) and set(name) <= set(part):
                draft.drop(thing)
                draft.unknown = [u for u in draft.unknown if u.partition(" (")[0].split()[-1:] != name[-1:]]


def _is_known(name: list[str]) -> bool:
    """Whether a name is that of a thing that we know, as a whole."""
    made = stand_in(" ".join(name))
    return made.how in ("catalogue", "table")


def _choose_room(draft: Draft, theme: Theme) -> None:
    if draft.room in theme.refines:
        draft.room = theme.refines[draft.room]
    elif theme.room and (not draft.room or (draft.room == "room" and not theme.unless)):
        draft.room = theme.room


def _account(draft: Draft, start: int, end: int) -> None:
    """Say of words that nothing was made of that they told a mood."""
    words = list(draft.account)
    lost = " ".join(word.text for word in words[start:end])
    for at in range(start, end):
        if words[at].fate in _IDLE:
            words[at] = replace(words[at], fate="style")
    draft.account = tuple(words)
    draft.unknown = [unknown for unknown in draft.unknown if unknown != lost]


def _in_names(draft: Draft) -> set[int]:
    """Which words name things: their places in the account."""
    said = [word.text.lower() for word in draft.account]
    begins: dict[str, list[int]] = {}
    for at, word in enumerate(said):
        begins.setdefault(word, []).append(at)
    names = {tuple(_words(thing.text)) for thing in draft.things} - {()}
    return {at for name in names for at in _places(said, list(name), begins)}


def _places(said: list[str], name: list[str], begins: Mapping[str, list[int]]) -> Iterator[int]:
    ahead = min(range(len(name)), key=lambda at: len(begins.get(name[at], ())))
    for start in (at - ahead for at in begins.get(name[ahead], ()) if at >= ahead):
        if said[start : start + len(name)] == name:
            yield from range(start, start + len(name))


def _words(text: str) -> list[str]:
    return text.lower().split()


def _is_crowd(draft: Draft, words: tuple[Word, ...], found: Found) -> bool:
    """Whether it is who the room is for, too many to live there: "a lab for 20 students", "students sit in pairs"."""
    plural = found.end - found.start == 1 and words[found.start].text.lower().endswith("s")
    seated = found.end < len(words) and words[found.end].text.lower() in _SEATED
    seated |= found.start > 0 and words[found.start - 1].text.lower() in _FACING
    return plural and (seated or draft.people > _HOUSEHOLD)


def _is_denied(words: tuple[Word, ...], start: int) -> bool:
    before = words[max(0, start - _REACH) : start]
    return words[start].fate == "constraint" or any(word.text.lower() in _NEGATIONS for word in before)


def _is_of_thing(words: tuple[Word, ...], start: int, taken: set[int]) -> bool:
    """Whether it only says what a thing is of or for: "a picture of a cat"."""
    at = start - 1
    while at >= 0 and words[at].text.lower() in _ARTICLES:
        at -= 1
    return at > 0 and words[at].text.lower() in ("of", "with") and at - 1 in taken
