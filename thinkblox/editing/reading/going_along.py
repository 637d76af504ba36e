"""What goes along with what an order is done to: "the table with its chairs"."""

from dataclasses import replace

from thinkblox.editing.orders import NounPhrase
from thinkblox.editing.reading.draft import WITH_ALONG, OrderDraft, is_it, is_theirs
from thinkblox.reading.english.chunks import Connector, Noun
from thinkblox.reading.english.nodes import Where


def as_theirs(draft: OrderDraft, noun: Noun) -> Noun:
    """What goes along as that of what was named before, also where its "its" is said of another: "its vase"."""
    if is_theirs(noun) or not draft.order.company:
        return noun
    return replace(noun, det="my", text=f"{draft.order.company[-1].noun.text.split()[0]} {noun.text}")


def is_theirs_too(draft: OrderDraft, noun: Noun) -> bool:
    """Whether a bare noun belongs to what was named before as well: "(with its chairs and) vase"."""
    before = draft.before()
    joined = isinstance(before, Connector) and before.text.lower() == "and"
    bare = noun.kind == "thing" and not (noun.det or noun.count or noun.id)
    theirs = bool(draft.order.company) and is_theirs(draft.order.company[-1].noun)
    return joined and bare and theirs and draft.order.doing in (*WITH_ALONG, "remove")


def takes_rider(draft: OrderDraft, where: Where) -> bool:
    """Take "the cabinet and the printer on it" as the cabinet, with which the printer goes along."""
    order = draft.order
    if where.word not in ("on", "in", "inside") or order.doing not in WITH_ALONG or len(order.things) != 2:
        return False
    head, rider = order.things
    if rider.places or head.places or not rider.noun.definite or where.noun is not head.noun:
        return False
    order.company.append(order.things.pop())
    return True


def takes_all_on_it(draft: OrderDraft, said: Connector, noun: Noun) -> bool:
    """Whether "with everything on it" says that what rests on the thing is meant too."""
    everything = said.value == "with" and noun.kind == "pronoun" and noun.value == "all"
    link, it = (draft.ahead(1), draft.ahead(2))
    on_it = isinstance(link, Connector) and link.value == "on" and isinstance(it, Noun) and is_it(it)
    if not everything or not on_it or not draft.order.things:
        return False
    draft.at += 3
    for phrase in draft.order.things:
        phrase.laden = True
    return True


def takes_along(draft: OrderDraft, where: Where) -> bool:
    """Take "with its chairs", "and the chairs with it" as what goes along."""
    order, noun = draft.order, where.noun
    if where.word != "with" or noun is None or order.doing not in (*WITH_ALONG, "remove") or not order.things:
        return False
    if is_it(noun) and len(order.things) > 1:
        order.company.append(order.things.pop())
        return True
    if is_it(noun) and order.company and is_theirs(order.company[-1].noun):
        return True
    if noun.kind == "thing":
        order.company.append(NounPhrase(noun, id=noun.id))
        return True
    return False
