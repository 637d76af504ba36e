"""What is counted first and told one by one later: "two lamps. ... A lamp is on the desk and a lamp is by the door"."""

from collections.abc import Collection, Mapping, Sequence

from thinkblox.reading.draft import Bond, Draft, Mention
from thinkblox.reading.english.chunks import Chunk
from thinkblox.reading.english.referents import last_word
from thinkblox.reading.english.said import is_link

_SEVERAL = 2
"""So many of a plural are there at least."""
_ONE = (["a"], ["an"], ["one"])
_MORE = (["another"], ["more"], ["other"])
"""With what word more begins than there was before."""


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
    for thing in list(draft.things):
        if (same := _told_before(draft, thing)) is not None and _is_apart(first, stops, same, thing):
            same.count = thing.count if same.count is None else same.count
            draft.drop(thing)
    for whole in list(draft.things):
        if whole not in draft.things or draft.bonds_of(whole) or not _is_only_counted(whole):
            continue
        told = [t for t in draft.things[draft.things.index(whole) + 1 :] if _is_alike(t, whole)]
        placed = [thing for thing in told if draft.bonds_of(thing)]
        begun = min((first[thing] for thing in told if thing in first), default=-1)
        if placed and whole in first and any(first[whole] < stop < begun for stop in stops):
            _join(draft, whole, placed, [thing for thing in told if thing not in placed])


def _is_apart(first: Mapping[Mention, int], stops: Sequence[int], one: Mention, other: Mention) -> bool:
    """Whether a sentence ends between what was named first and the other."""
    return one in first and other in first and any(first[one] < stop < first[other] for stop in stops)


def _told_before(draft: Draft, thing: Mention) -> Mention | None:
    """What a thing is that is only counted after all ("books on the shelf ... ten books"), or told of once more."""
    bonds = draft.bonds_of(thing)
    again = any(bond.each for bond in bonds)
    if not thing.count or not (again or (not bonds and thing.count > 1 and _is_only_counted(thing))):
        return None
    if thing.text.lower().split()[:1] in _MORE or any(thing in bond.anchors for bond in draft.bonds):
        return None
    before = [t for t in draft.things[: draft.things.index(thing)] if _is_alike(t, thing) and draft.bonds_of(t)]
    if len(before) != 1:
        return None
    if not again:
        return before[0] if before[0].count is None and not before[0].vague else None
    known = {(bond.kind, bond.anchors) for bond in draft.bonds_of(before[0])}
    same = {(bond.kind, bond.anchors) for bond in bonds} <= known and _total(draft, thing) == before[0].count
    return before[0] if same else None


def _join(draft: Draft, whole: Mention, placed: Sequence[Mention], pointed: Sequence[Mention]) -> None:
    """Take things that are placed, and those that others are `pointed` at, for some or all of a whole."""
    more = placed[0].text.lower().split()[:1] in _MORE
    if more or _takes_some(draft, placed, whole) or not _are_all(draft, placed, whole):
        return
    for thing in placed:
        _take(thing, whole, alone=len(placed) == 1)
    besides = {whole, *pointed}
    for bond in draft.bonds:
        if not besides.isdisjoint(a for a in bond.anchors if isinstance(a, Mention)):
            _point_at(bond, whole, placed, besides)
    draft.things = [thing for thing in draft.things if thing not in besides]
    draft.dropped |= besides


def _takes_some(draft: Draft, placed: Sequence[Mention], whole: Mention) -> bool:
    """Leave so many fewer of those that are only counted, if some are named again by nothing but their name."""
    bare = all(thing.text.lower().split()[:1] in _ONE and not (thing.attributes or thing.unshown) for thing in placed)
    left = (whole.count or 0) - sum(_total(draft, thing) for thing in placed)
    if not bare or left < 1 or any(whole in bond.anchors for bond in draft.bonds):
        return False
    whole.count, whole.plural = left, left > 1
    for thing in placed:
        _take(thing, whole, alone=False)
    return True


def _are_all(draft: Draft, placed: Sequence[Mention], whole: Mention) -> bool:
    """Whether things are as many as the whole; of which nobody knows how many it is, they are all."""
    alone = placed[0] if len(placed) == 1 else None
    if alone is not None and alone.count is None and not alone.vague:
        return True
    number = sum(_total(draft, thing) for thing in placed)
    return number == whole.count if whole.count is not None else number > 1


def _take(thing: Mention, whole: Mention, *, alone: bool) -> None:
    """Tell of a thing what was told of the whole."""
    thing.noun = whole.noun if thing.noun.startswith("any_") else thing.noun
    thing.count = whole.count if alone and thing.count is None else thing.count
    thing.attributes += [look for look in whole.attributes if look not in thing.attributes]
    thing.unshown += [look for look in whole.unshown if look not in thing.unshown]
    thing.states += [state for state in whole.states if state not in thing.states]


def _point_at(bond: Bond, whole: Mention, placed: Sequence[Mention], besides: Collection[Mention]) -> None:
    """Relate to the things that are placed what was related to the whole, or to one of them by its name alone."""
    meant = [*placed] if whole in bond.anchors else [*placed[:1]]
    rest = [a for a in bond.anchors if not (isinstance(a, Mention) and (a in besides or a in meant))]
    bond.anchors = (*meant, *rest)


def _is_only_counted(thing: Mention) -> bool:
    """Whether nothing but how many there are, and what they look like, is told of it."""
    more = thing.owner or thing.host or thing.rows or thing.groups or thing.per or thing.size or thing.seats
    more = more or thing.least is not None or thing.most is not None or thing.vague or thing.general
    return thing.asked and (bool(thing.count) or thing.plural) and not more


def _is_alike(thing: Mention, whole: Mention) -> bool:
    """Whether a thing may be one of those: of their kind, and not of other looks."""
    general = thing.noun.startswith("any_") and last_word(thing) == last_word(whole)
    return (thing.noun == whole.noun or general) and (
        not whole.attributes or set(thing.attributes) <= {*whole.attributes}
    )


def _total(draft: Draft, thing: Mention) -> int:
    """How many one is of which something is told of each."""
    bonds = draft.bonds_of(thing)
    shares = [bond for bond in bonds if bond.each or bond.distributed]
    anchors = [a for bond in shares[:1] for a in bond.anchors if isinstance(a, Mention)]
    spread = max((bond.spread for bond in bonds), default=0)
    return (thing.count or 1) * (sum(anchor.count or _SEVERAL for anchor in anchors) or spread or 1)
