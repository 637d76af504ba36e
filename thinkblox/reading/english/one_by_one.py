"""What is counted first and told one by one later: "two lamps. ... A lamp is on the desk and a lamp is by the door"."""

from collections.abc import Mapping, Sequence

from thinkblox.assets.palette import COLOURS
from thinkblox.reading.draft import Draft, Mention
from thinkblox.reading.english.chunks import Chunk
from thinkblox.reading.english.referents import last_word
from thinkblox.reading.english.said import is_link

_ARTICLES = ("a", "an", "one")
_MORE = (*_ARTICLES, "another", "the")


def join_one_by_one(draft: Draft, chunks: Sequence[Chunk], meant: Mapping[int, Sequence[Mention]]) -> None:
    """Forget what is only counted, where just as many are named singly and placed in later sentences.

    Args:
        draft: what was read.
        chunks: the text.
        meant: what the noun phrase at each token was taken for.
    """
    first: dict[Mention, int] = {}
    for start, things in sorted(meant.items()):
        for thing in things:
            first.setdefault(thing, start)
    stops = [chunk.start for chunk in chunks if is_link(chunk, "mark", "stop", "semicolon", "colon")]
    placed = {bond.subject for bond in draft.bonds}
    bound = {*placed, *(a for bond in draft.bonds for a in bond.anchors if isinstance(a, Mention))}
    for at, whole in enumerate(list(draft.things)):
        if whole in bound or not _is_only_counted(whole):
            continue
        told = [thing for thing in draft.things[at + 1 :] if _is_alike(thing, whole)]
        words = [thing.text.lower().split()[0] for thing in told if thing.text]
        single = len(words) == len(told) and words[:1] and words[0] in _ARTICLES and set(words) <= set(_MORE)
        apart = whole in first and any(first[whole] < stop < first.get(t, 0) for t in told[:1] for stop in stops)
        bare = len(told) == 1 and told[0].count is None and not told[0].vague
        counted = single and sum(_total(draft, thing) for thing in told) == whole.count
        if not (counted or bare) or not apart or not placed.issuperset(told):
            continue
        if bare:
            told[0].count = whole.count
        for thing in told:
            thing.noun = whole.noun if thing.noun.startswith("any_") else thing.noun
            thing.attributes += [look for look in whole.attributes if look not in thing.attributes]
            thing.unshown += [look for look in whole.unshown if look not in thing.unshown]
            thing.states += [state for state in whole.states if state not in thing.states]
        draft.drop(whole)


def _is_only_counted(thing: Mention) -> bool:
    """Whether nothing but how many there are, and what they look like, is told of it."""
    more = thing.owner or thing.host or thing.rows or thing.groups or thing.per or thing.size or thing.seats
    more = more or thing.least is not None or thing.most is not None or thing.vague or thing.general
    return thing.asked and bool(thing.count) and not more


def _is_alike(thing: Mention, whole: Mention) -> bool:
    general = thing.noun.startswith("any_") and last_word(thing) == last_word(whole)
    colours = [{look for look in t.attributes if look in COLOURS} for t in (thing, whole)]
    return (thing.noun == whole.noun or general) and (not all(colours) or colours[0] == colours[1])


def _total(draft: Draft, thing: Mention) -> int:
    """How many one is of which something is told of each."""
    shares = [b for b in draft.bonds_of(thing) if b.each or b.distributed]
    anchors = [a for b in shares[:1] for a in b.anchors if isinstance(a, Mention)]
    return (thing.count or 1) * (sum(anchor.count or 1 for anchor in anchors) or 1)
