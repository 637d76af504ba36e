"""How a thing is to look, or that a place is to be free."""

from thinkblox.editing.grammar import means
from thinkblox.editing.reading.draft import OrderDraft
from thinkblox.reading.english.chunks import Adjective, Connector, Noun


def read_adjective(draft: OrderDraft, said: Adjective) -> None:
    """Take an adjective that stands alone."""
    order, free = draft.order, bool(means("clear", said.text.lower()))
    spot = draft.places()[-1].noun if draft.places() else None
    if free and draft.mode != "so" and order.doing in ("put", "add", "ensure") and spot is not None:
        if spot.kind == "place" and order.things and not order.things[-1].noun.definite:
            spot.states = ["empty"]
        else:
            order.lost.append(said.text)
    elif free and draft.mode == "so":
        order.free += [phrase.noun for phrase in draft.so]
    elif free and order.doing in ("keep", "put", "make", "ensure"):
        order.doing = "free"
        order.free += [phrase.noun for phrase in order.things if phrase.noun.kind in ("place", "part")]
        order.places += [where for phrase in order.things for where in phrase.places]
        things = [phrase for phrase in order.things if phrase.noun.kind not in ("place", "part")]
        draft.clears = bool(things) and not order.free
        order.things[:] = things
    elif (new := draft.new_thing()) is not None and said.attributes and not said.unshown:
        new.attributes += said.attributes
    elif order.doing in ("make", "put") and draft.negated and said.attributes:
        draft.negated = False
        order.ruled_out += said.attributes
    elif order.doing in ("make", "put") and order.things and said.attributes and not said.unshown:
        order.looks += said.attributes
    else:
        draft.lose(said)


def pass_look(draft: OrderDraft, noun: Noun) -> None:
    """Go past "the colour of" in "change the colour of the sofa to blue", "the width of" in "to 2 m"."""
    axis = means("looks", noun.word)
    draft.order.change = f"{axis}=" if axis != "words" else draft.order.change
    link = draft.ahead()
    draft.at += isinstance(link, Connector) and link.value == "of"
    draft.order.doing = "make"
