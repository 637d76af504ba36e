"""Places for things: "somewhere to hang coats" asks for what they are kept in, not for them."""

from thinkblox.knowledge.keepers import keeping_openings, load_keepers
from thinkblox.reading.draft import Draft, Mention

_BETWEEN = frozenset({"and", "or", "the", "my", "our", "his", "her", "their", "your", "all", "all the"})
"""Words that stand between things that one place is for."""
_LONGEST = 4
"""Words of the longest opening, "somewhere to hang up"."""


def keep_things(draft: Draft) -> None:
    """Ask for what the things are kept in for which a prompt wants a place, instead of for them."""
    said = [word.text.lower() for word in draft.account]
    at, thing = 0, None
    while at < len(said):
        length = _opening(said, at)
        at += length or 1
        while length and (thing := _kept_at(draft, said, at + _between(said, at))) is not None:
            at += _between(said, at) + len(_name(thing))
            _hand_to_keeper(draft, thing)


def _opening(said: list[str], at: int) -> int:
    """How many words at `at` say that there is to be a place for what comes next."""
    ways = keeping_openings().get(said[at], ())
    return next((n for n in range(_LONGEST, 1, -1) if tuple(said[at + 1 : at + n]) in ways), 0) if ways else 0


def _between(said: list[str], at: int) -> int:
    end = at
    while end < len(said) and said[end] in _BETWEEN:
        end += 1
    return end - at


def _kept_at(draft: Draft, said: list[str], at: int) -> Mention | None:
    """The thing that is named at `at` without a number, where we know what it is kept in."""
    for thing in draft.things:
        words = _name(thing)
        known = thing.asked and words and thing.noun in load_keepers().keepers
        if known and (thing.count is None or thing.noun.endswith("s")) and said[at : at + len(words)] == words:
            return thing
    return None


def _name(thing: Mention) -> list[str]:
    """The words that name it, without those before them."""
    words = thing.text.lower().split()
    return words[_between(words, 0) :]


def _hand_to_keeper(draft: Draft, thing: Mention) -> None:
    keeper = load_keepers().keepers[thing.noun]
    bonds = [bond for bond in draft.bonds_of(thing) if all(isinstance(anchor, str) for anchor in bond.anchors)]
    if any(other.noun == keeper for other in draft.things):
        draft.drop(thing)
        return
    made = Mention(keeper, text=thing.text)
    for bond in bonds:
        draft.hand_over(bond, made)
    draft.things[draft.things.index(thing)] = made
    draft.bonds = [b for b in draft.bonds if b.subject is not thing and thing not in b.anchors]
