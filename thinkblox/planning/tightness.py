"""A room of a given size may be too small for all that goes without saying: what matters less comes smaller or not."""

from collections.abc import Iterator

from msgspec.structs import replace

from thinkblox.assets import kind_of
from thinkblox.brief import Brief, Request
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import room_type
from thinkblox.knowledge.things import are_alike
from thinkblox.planning.rooms import is_open
from thinkblox.planning.space import furniture_area

_DRAWN_UP = ("at", "around", "behind")
_TIGHT = 1.8
"""How much more floor than there is things may take by the handbook: people turn sideways in small rooms."""


def fitted(brief: Brief) -> Brief:
    """The brief with so much of what it assumes left out, or smaller, that the floor it gives holds the rest.

    What the prompt names stays, with what that needs, and what every such room has; of the others those go first that
    are told last of such a room.
    """
    if is_open(brief) or brief.empty:
        return brief
    while is_tight(brief) and (less := relieved(brief)) is not None:
        brief = less
    return brief


def is_tight(brief: Brief) -> bool:
    """Whether a room has a size for which its things are too many, or too large."""
    area = brief.area or (brief.width or 0.0) * (brief.depth or 0.0)
    return bool(area) and not is_open(brief) and furniture_area(brief) > _TIGHT * area


def relieved(brief: Brief) -> Brief | None:
    """The brief with the last of what it assumes, and no such room must have, smaller or left out; None without it."""
    gone = next((request for request in reversed(brief.requests) if _is_loose(brief, request)), None)
    return None if gone is None else _smaller(brief, gone) or _without(brief, gone)


def is_essential(category: str, room: str) -> bool:
    """Whether everybody expects such a thing in a type of room."""
    return any(are_alike(usual.category, category) for usual in room_type(room).expected)


def _is_loose(brief: Brief, request: Request) -> bool:
    """Whether it is assumed, stands on the floor, no such room must have it, and nothing that is asked for needs it."""
    kind = kind_of(request.category)
    essential = is_essential(request.category, brief.room_type)
    if request.asked or kind.mount != "floor" or kind.flat or essential:
        return False
    asked = {r.key: r.category for r in brief.requests if r.asked}
    ties = [r for r in brief.relations if request.key in (r.subject, *r.anchors)]
    if any(r.asked or (r.subject in asked) or (r.kind in _DRAWN_UP and r.anchors[0] in asked) for r in ties):
        return False
    habits = (habit for category in asked.values() for habit in load_habits().of(category))
    return not any(habit.kind == "on" and request.category in habit.anchors for habit in habits)


def _smaller(brief: Brief, large: Request) -> Brief | None:
    """The brief with what does as well and takes less floor; None where there is nothing such."""
    instead = room_type(brief.room_type).instead.get(large.category)
    others = (request.category for request in brief.requests if request.key != large.key)
    if instead is None or instead in brief.excluded or any(are_alike(category, instead) for category in others):
        return None
    requests = tuple(replace(r, category=instead) if r.key == large.key else r for r in brief.requests)
    return replace(brief, requests=requests)


def _without(brief: Brief, gone: Request) -> Brief:
    """The brief without something and what is only assumed to belong to it; it says so."""
    keys = {gone.key, *_belonging(brief, gone.key)}
    noun = kind_of(gone.category).noun
    said = f"no {noun}: the room is too small for it" if gone.count == 1 else f"no {noun}s: the room is too small"
    return replace(
        brief,
        requests=tuple(r for r in brief.requests if r.key not in keys),
        relations=tuple(r for r in brief.relations if r.subject not in keys and keys.isdisjoint(r.anchors)),
        left_out=(*brief.left_out, said),
    )


def _belonging(brief: Brief, key: str) -> Iterator[str]:
    assumed = {request.key for request in brief.requests if not request.asked}
    for relation in brief.relations:
        if key in relation.anchors and relation.subject in assumed and relation.subject != key:
            yield relation.subject
            yield from _belonging(brief, relation.subject)
