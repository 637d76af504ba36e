"""What things are to face, and what their backs and sides are to be at."""

from dataclasses import replace

from thinkblox.editing.reading.cutting import Item, OrderMark
from thinkblox.editing.reading.draft import ASIDE, TO_WALL, OrderDraft
from thinkblox.editing.reading.phrasing import merged
from thinkblox.reading.english.chunks import Connector, Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.english.rooms import COMPASS

_AT_BACK = (*ASIDE, "on", "against", "under")


def is_back(item: Item | None) -> bool:
    """Whether it is the back of what is spoken of."""
    named = isinstance(item, Noun) and item.det == "my" and item.value in ("back", "head")
    return named and isinstance(item, Noun) and item.kind in ("part", "thing")


def is_head(draft: OrderDraft, noun: Noun) -> bool:
    """Whether it is the head or the back of what is turned: "so that the head is at the wall"."""
    return draft.mode == "so" and draft.order.doing == "turn" and noun.det == "the" and noun.value in ("back", "head")


def read_behind(draft: OrderDraft) -> Where | None:
    """Read "(its back) is to the window", "against the wall"."""
    at = draft.at
    verb = draft.items[at] if at < len(draft.items) else None
    at += isinstance(verb, Connector) and verb.sort in ("verbs", "participles")
    link, noun = (draft.items[n] if n < len(draft.items) else None for n in (at, at + 1))
    if not isinstance(link, Connector) or link.value not in _AT_BACK or not isinstance(noun, Noun):
        return None
    draft.at = at + 2
    return Where(link.value, merged(draft, noun), text=link.text.lower().removeprefix("up ").removeprefix("right "))


def read_facing(draft: OrderDraft) -> None:
    """Read "to face the room", "so that it faces the door", "(the wardrobe,) not at the bed"."""
    following = draft.ahead()
    if draft.negated and draft.order.things and isinstance(following, Noun):
        draft.at += 1
        take_not_faced(draft, following)
        return
    if isinstance(following, OrderMark) and following.key == "farther":
        return
    if takes_compass(draft, following):
        return
    noun = draft.next_noun()
    if noun is None:
        draft.order.lost.append("face")
    elif noun.kind == "pronoun" and noun.value == "each":
        draft.order.mutual = "facing"
    else:
        draft.order.facing.append(_sided(draft, merged(draft, noun)))
        draft.anchors = draft.order.facing[-1:]


def take_not_faced(draft: OrderDraft, noun: Noun) -> None:
    """Take "(so that it faces the wardrobe,) not the bed" as what it is not to face."""
    draft.negated = False
    for phrase in draft.order.things:
        phrase.places.append(Where("facing", merged(draft, noun), negated=True, text="not facing"))


def _sided(draft: OrderDraft, noun: Noun) -> Noun:
    """Take "(towards) the chair on the right" as the right one."""
    link, side = (draft.ahead(), draft.ahead(1))
    on = isinstance(link, Connector) and link.value == "on"
    if noun.kind != "thing" or not on or not isinstance(side, Noun) or side.kind != "part":
        return noun
    if side.value not in ("left", "right") or side.det != "the" or side.owner:
        return noun
    draft.at += 2
    return replace(noun, side=side.value)


def takes_compass(draft: OrderDraft, following: Item | None) -> bool:
    """Take "(facing) north" as the wall that is there; whether it is that."""
    if not isinstance(following, OrderMark) or following.key not in COMPASS:
        return False
    draft.at += 1
    draft.order.facing.append(Noun("place", f"{following.key}_wall", 0, 0, following.key))
    return True


def takes_with_side(draft: OrderDraft, said: Noun) -> bool:
    """Take "with its long side along the west wall"; whether it was that."""
    link, wall = (draft.ahead(1), draft.ahead(2))
    if said.kind != "part" or not isinstance(link, Connector) or not isinstance(wall, Noun):
        return False
    if not takes_lengthwise(draft, said, Where(link.value, wall, text=link.text)):
        return False
    draft.at += 3
    return True


def takes_lengthwise(draft: OrderDraft, said: Noun, where: Where) -> bool:
    """Take "(so that) its long side is along the west wall" as how it comes to stand there; whether it was that."""
    order, wall = draft.order, where.noun
    at_wall = wall is not None and wall.kind == "place" and ("wall" in wall.value or wall.value == "window")
    at_wall = at_wall and where.word in (*_AT_BACK, "along")
    if said.value not in ("long_side", "short_side") or not at_wall or order.doing not in TO_WALL or where.negated:
        return False
    if len(order.things) != 1 or order.turn is not None:
        return False
    order.doing = "move"
    order.things[0].places.append(replace(where, word="along", text=said.value))
    return True
