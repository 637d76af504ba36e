"""What stands together is planned together: places counted off over all requests, and what carries small things."""

from msgspec.structs import replace

from thinkblox.assets import facts_of
from thinkblox.plan import Tie, carries
from thinkblox.planning.members import Member, Members

_COUNTED = ("around", "at_long_side", "at_short_side", "at", "in_front_of")
"""Relations whose members take places of their own about one anchor."""
_CLOSE = ("next_to", "near", "left_of", "right_of")
"""Relations to a thing on a counter that are those to the counter, for what stands on the floor."""


_PLACED = ("against_wall", "in_corner", "near")
_AT_WALL = ("against_wall", "in_corner")
_BY, _OPENINGS = ("near", "next_to"), (("window",), ("door",))
_FURNITURE = ("surfaces", "tables", "desks", "counters", "worktops", "storage", "shelves", "beds", "seats", "seating")
"""What is turned by its own place and use, whatever is on it."""


def lower(members: Members) -> None:
    """What stands on the floor next to a thing on a counter stands next to the counter, and the thing near it."""
    for member in members.all:
        if member.mount == "floor":
            for place, tie in enumerate(member.ties):
                _lower(members, member, place, tie)


def _lower(members: Members, member: Member, place: int, tie: Tie) -> None:
    upper = members.by_id.get(tie.anchors[0]) if len(tie.anchors) == 1 else None
    support = members.support(upper) if upper else None
    if tie.kind not in _CLOSE or upper is None or support is None or support is member or upper.mount != "surface":
        return
    if members.depends(support, member) or _may_stand_elsewhere(upper):
        return
    members.owe(member, tie)
    member.ties[place] = replace(tie, anchors=(support.id,), means=True)
    if not members.depends(member, upper):
        bring_near(upper, member)


def _may_stand_elsewhere(upper: Member) -> bool:
    """Whether nobody asked for it to be on what usually carries it, but for a place of its own in the room."""
    asked = [tie for tie in upper.ties if tie.asked]
    return any(tie.kind in _PLACED for tie in asked) and not any(map(carries, asked))


def bring_along(members: Members) -> None:
    """What is let into a counter that is only there for it is on the side of that by which it is asked to be."""
    for member in members.all:
        support = members.support(member) if facts_of(member.category).is_in("built_in") else None
        if support is None or support.request.asked:
            continue
        for tie in [t for t in support.ties if t.asked and t.kind in _CLOSE and len(t.anchors) == 1]:
            other = members.by_id.get(tie.anchors[0])
            if other is not None and other.mount == "floor" and not members.depends(other, member):
                bring_near(member, other)


def carry_to_wall(members: Members) -> None:
    """What is only assumed to carry a thing stands at the very wall, or in the corner, where that is asked to be."""
    for member in members.all:
        support = members.support(member) if member.mount == "surface" else None
        if support is None or support.request.asked or support.request.count > 1:
            continue
        placed = [tie for tie in member.ties if tie.asked and tie.kind in _AT_WALL and tie.anchors != ("wall",)]
        if placed:
            kept = [tie for tie in support.ties if tie.kind not in _PLACED]
            support.ties[:] = [replace(placed[0], index=0, count=1, asked=False), *kept]


def carry_to_opening(members: Members) -> None:
    """What usually carries a thing stands by the window or door that this is asked to be by, where any wall will do."""
    for member in members.all:
        on = next((tie for tie in member.ties if carries(tie)), None)
        support = members.support(member) if member.mount == "surface" and on and not on.asked else None
        if support is None or support.mount != "floor" or support.request.count > 1:
            continue
        by = [tie for tie in member.ties if tie.asked and tie.kind in _BY and tie.anchors in _OPENINGS]
        if by and all((tie.kind, tie.anchors) == ("against_wall", ("wall",)) for tie in support.ties):
            support.ties.append(replace(by[0], index=0, count=1, asked=False))


def turn_stands(members: Members) -> None:
    """A stand looks where what is on it is asked to look, as a tripod does with its camera, where nobody turns it."""
    for member in members.all:
        support = members.support(member) if member.mount == "surface" else None
        if support is None or support.mount != "floor" or facts_of(support.category).is_in(*_FURNITURE):
            continue
        looks = [tie for tie in member.ties if tie.asked and tie.kind == "facing" and tie.anchors]
        turned = any(tie.kind in ("facing", "facing_away", "opposite", *_AT_WALL) for tie in support.ties)
        anchors = [members.by_id[a] for tie in looks for a in tie.anchors if a in members.by_id]
        if looks and not turned and not any(members.depends(anchor, support) for anchor in anchors):
            support.ties.append(replace(looks[0], index=0, count=1, asked=False))


def bring_near(upper: Member, member: Member) -> None:
    """Have a thing on a counter put where `member`, that stands on the floor, is next to it."""
    if not any(member.id in tie.anchors for tie in upper.ties):
        upper.ties.append(Tie(kind="next_to", anchors=(member.id,), means=True))


def count_off(members: Members) -> None:
    """Number those that share an anchor and a relation, whatever they were asked for with."""
    groups: dict[tuple[str, tuple[str, ...]], list[tuple[Member, int]]] = {}
    for member in members.all:
        for place, tie in enumerate(member.ties):
            if not member.flat and tie.kind in _COUNTED and len(tie.anchors) == 1 and tie.anchors[0] in members.by_id:
                groups.setdefault((tie.kind, tie.anchors), []).append((member, place))
    for group in groups.values():
        for index, (member, place) in enumerate(group):
            member.ties[place] = replace(member.ties[place], index=index, count=len(group))
