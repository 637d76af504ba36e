"""What is named by its number first and told one by one then: "two mirrors. Above each sink hangs a mirror"."""

from collections.abc import Mapping, MutableMapping

from thinkblox.reading.draft import Draft, Mention
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.referents import Referents


def join_named_again(
    draft: Draft,
    referents: Referents,
    named_by: Mapping[Mention, Noun],
    meant: MutableMapping[int, list[Mention]],
) -> None:
    """Take one for each of several for those of the same kind that were counted before, if there are as many of them.

    Nothing else may have been said of where these are.
    """
    for thing in [bond.subject for bond in draft.bonds if bond.each and not bond.negated and bond.anchors]:
        noun = named_by.get(thing)
        one = noun is not None and (noun.det == "a" or noun.text.lower().startswith("one "))
        if not one or thing.many or thing not in draft.things:
            continue
        number = referents.total(thing)
        before = draft.things[: draft.things.index(thing)]
        counted = next((t for t in before if number > 1 and _is_same(draft, t, thing, number)), None)
        if counted is None:
            continue
        thing.attributes = [*counted.attributes]
        thing.unshown, thing.states = [*counted.unshown], [*counted.states]
        thing.size, thing.called = counted.size or thing.size, counted.called or thing.called
        for start, things in meant.items():
            meant[start] = [thing if t is counted else t for t in things]
        draft.drop(counted)


def _is_same(draft: Draft, counted: Mention, thing: Mention, number: int) -> bool:
    """Whether so many were counted of which no more was told than of one for each."""
    if counted.noun != thing.noun or counted.count != number or not counted.asked or counted.owner is not None:
        return False
    said = {*thing.attributes, *thing.unshown, *thing.states} - {
        *counted.attributes,
        *counted.unshown,
        *counted.states,
    }
    return not said and not any(b.subject is counted or counted in b.anchors for b in draft.bonds)
