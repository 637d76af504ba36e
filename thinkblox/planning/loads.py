"""What the objects of a plan have on, in and under them, and how large and of which form they are to be for that."""

from collections.abc import Sequence
from math import pi, sqrt

import numpy as np

from thinkblox.assets import facts_of, kind_of, room_under, stand_in
from thinkblox.assets.category import Category
from thinkblox.assets.facts import Role
from thinkblox.assets.make import make_thing
from thinkblox.assets.open_forms import FOR_LONG, TIERED
from thinkblox.assets.sizing import UPRIGHT, is_stood, size_for, sizes_of
from thinkblox.assets.states import words_for
from thinkblox.brief import Measures
from thinkblox.knowledge.things import is_surface
from thinkblox.planning.members import Member, Members
from thinkblox.scene.asset import Asset
from thinkblox.value import Vec2, Vec3

GROWTH, SLIGHT = (1.25, 1.6), (1.15, 1.3)
"""How much deeper and wider than usual a top is made at most for what stands on it, and what is no table or case."""
FREELY = (2.2, 2.5)
"""The same for what nobody sits or works at: a tray, a plate, a small stand, a board on a wall."""
SMALL = 0.7
"""What is no longer than this grows as tables do, whatever it is: a stool [m]."""
MOSTLY_TOP = 0.4
"""Least share of its outline that the top of a thing takes which grows with it."""
TOO_LARGE = 1.6
"""Times the longer side of a top from which a thing is none of those that it is made larger for."""
RAISED = 1.15
"""How much higher than usual a thing is made at most for what stands under it."""
APART = 0.04
"""Left about a thing on a top [m]."""
FEW = 4
"""So many things at most are thought of as standing in one line."""
PACKED = 1.25
"""How much larger a top is than the things on it together: they differ, and stand in lines."""
UNDER = 0.03
"""Air left above and beside what stands under a thing [m]."""
_CIRCLE = 0.9
"""Share of a round top's length from which its width makes it a circle, which stays one; an oval grows as oblong."""
_VARIED = 1.1
"""How much larger than usual a thing may come out."""
_STEP = 0.02
"""To which heights are tried [m]."""


def on_it(member: Member, members: Members) -> list[Member]:
    """What is to stand or lie on it."""
    return _tied(member, members, "on", "in_centre")


def in_it(member: Member, members: Members) -> list[Member]:
    """What is to be inside it."""
    return _tied(member, members, "inside")


def under_it(member: Member, members: Members) -> list[Member]:
    """What is to stand on the floor under it."""
    return [m for m in _tied(member, members, "under") if not m.flat and m.mount in ("floor", "surface")]


def _tied(member: Member, members: Members, *kinds: str) -> list[Member]:
    return [m for m in members.all if any(t.kind in kinds and member.id in t.anchors for t in m.ties)]


def words_of(member: Member, members: Members) -> tuple[str, ...]:
    """Its attributes, and the words for the form that suits what it has on, in or under it, or that it is in."""
    roles: dict[Role, bool] = {
        "holds": bool(in_it(member, members)),
        "carries": _is_topped(member, members),
        "over": bool(under_it(member, members)),
        "inside": any(tie.kind == "inside" for tie in member.ties),
        "below": any(m.mount == "wall" for m in _tied(member, members, "above")),
        "under": any(_stands_over(members.by_id.get(a)) for t in member.ties if t.kind == "under" for a in t.anchors),
    }
    forms = facts_of(member.category).forms
    found = [
        *(_form(member, members, r) for r in forms if roles[r]),
        *words_for(member.category, member.request.states),
    ]
    long = kind_of(member.category).long_axis is not None
    open_ones = (holder for holder in _holders(member, members) if not _holders(holder, members))
    if long and any(_is_too_narrow(holder, member, members) for holder in open_ones):
        found.append(UPRIGHT)
    return tuple(dict.fromkeys((*member.request.attributes, *found)))


def _is_topped(member: Member, members: Members) -> bool:
    """Whether it carries what its form is about: one with a basin of its own has that unless others are let into it."""
    on = on_it(member, members)
    built_in = (facts_of(m.category).is_in("built_in") for m in on)
    return any(built_in) if facts_of(member.category).is_in("basins") else bool(on)


def _form(member: Member, members: Members, role: Role) -> str:
    """The word for the form that a thing has in a role; a rack of long things is none with boards over one another."""
    form = facts_of(member.category).forms[role]
    held = [kind_of(m.category) for m in (*in_it(member, members), *on_it(member, members))]
    wide = max(kind_of(member.category).size[:2])
    long = all(kind.long_axis is not None and max(kind.size[:2]) > wide for kind in held)
    return FOR_LONG if form == TIERED and held and long else form


def _holders(member: Member, members: Members) -> list[Member]:
    inside = (a for tie in member.ties if tie.kind == "inside" for a in tie.anchors)
    return [members.by_id[a] for a in inside if a in members.by_id]


def _is_too_narrow(holder: Member, member: Member, members: Members) -> bool:
    """Whether a thing as it lies by itself has no room on the floor of an open holder."""
    made = make_thing(holder.category, seed=0, attributes=words_of(holder, members))
    floors = [s.size for s in made.surfaces if s.within and s.headroom is None]
    lying = size_for(kind_of(member.category), frozenset(member.request.attributes), np.random.default_rng(0))
    return bool(floors) and max(lying[:2]) > max(map(max, floors))


def _stands_over(anchor: Member | None) -> bool:
    """Whether something can be under it on the floor: it stands there itself."""
    return anchor is not None and anchor.mount == "floor" and not anchor.flat


def sizes_given(member: Member, members: Members) -> tuple[Measures, Measures]:
    """What the prompt and the seed give for the size of the form that it has [m].

    The seed gives none where that form has a size of its own; what stands on its end has its length upwards.
    """
    kind, words = kind_of(member.category), words_of(member, members)
    asked, drawn = member.request.size, member.request.drawn
    if is_stood(kind, words):
        return _stood(asked, kind), _stood(drawn, kind)
    own = (word for word in words if word not in member.request.attributes)
    return asked, (None, None, None) if any(word in kind.variants for word in own) else drawn


def _stood(size: Measures, kind: Category) -> Measures:
    x, y, z = size
    return (z, y, x) if kind.long_axis == 0 else (x, z, y)


def usual_size(member: Member, members: Members) -> Vec3:
    """Its size by the seed or by its words, where the prompt gives no other [m]."""
    usual = size_for(kind_of(member.category), frozenset(words_of(member, members)), np.random.default_rng(0))
    sizes = zip(*sizes_given(member, members), size_of_unknown(member, members) or usual, strict=True)
    x, y, z = (asked or own or general for asked, own, general in sizes)
    return (x, y, z)


def size_of_unknown(member: Member, members: Members) -> Vec3 | None:
    """The size at which something that nobody knows has room in or on what the prompt puts it with others [m].

    None for what is known, and where there is room for it as it is usually made.
    """
    anchors = [a for t in member.ties if t.asked and t.kind in ("inside", "on", "in_centre") for a in t.anchors]
    holder = next((members.by_id[a] for a in anchors if a in members.by_id), None)
    if holder is None or stand_in(member.category).how != "plain":
        return None
    company = len({m.id for m in (*in_it(holder, members), *on_it(holder, members))})
    made = make_thing(holder.category, seed=0, attributes=words_of(holder, members))
    area = max((s.size[0] * s.size[1] * (pi / 4 if s.round else 1.0) for s in made.surfaces), default=0.0)
    kind = kind_of(member.category)
    least = max(a / b for a, b in zip(kind.size_range[0], kind.size, strict=True))
    share = max(sqrt(area / company) / PACKED / (max(kind.size[:2]) + APART), least)
    if share >= 1.0 or not area:
        return None
    x, y, z = (round(share * side, 3) for side in kind.size)
    return (x, y, z)


def width_of(member: Member, members: Members) -> float:
    """The diameter of the disc that it needs whichever way it is turned [m]."""
    x, y, z = usual_size(member, members)
    return max(x, y) if asset_of(member, members, (x, y, z)).front == "any" else float(np.hypot(x, y))


def top_for_loads(member: Member, members: Members) -> Vec2 | None:
    """Depth and width at which all that is to be on it has room side by side [m]; None where it has that as it is."""
    loads = on_it(member, members)
    kind = kind_of(member.category)
    if not loads or kind.flat or member.mount == "ceiling" or kind.is_in("built_in"):
        return None
    usual = usual_size(member, members)
    open_ = [s for s in asset_of(member, members, usual).surfaces if not s.within]
    tops = [s for s in open_ if s.headroom is None]
    if not tops or (len(open_) > 1 and kind.is_in("shelves")):
        return None
    top = max(tops, key=lambda s: s.size[0] * s.size[1])
    if top.size[0] * top.size[1] < MOSTLY_TOP * usual[0] * usual[1]:
        return None
    lined = kind.is_in("built_in_line")
    areas = [
        (max(x, top.size[0] * lined), y + APART * lined)  # What is let into a worktop leaves nothing before or behind.
        if facts_of(load.category).is_in("built_in")
        else (x * _VARIED + APART, y * _VARIED + APART)
        for load in loads
        if min((size := usual_size(load, members))[:2]) < TOO_LARGE * max(top.size)
        for x, y, _ in [size]
    ]
    if not areas:
        return None
    long = 1 if usual[1] >= usual[0] or kind.front == "one" else 0
    circle = top.round and min(top.size) > _CIRCLE * max(top.size)
    even, small = not lined and (circle or usual[0] == usual[1]), max(usual[:2]) < SMALL
    furniture = kind.is_in("surfaces", "tables", "counters", "worktops")
    free = member.mount == "wall" or not (furniture or kind.is_in("seats", "seating"))
    growth = FREELY if free and (small or member.mount == "wall") else GROWTH if furniture or small else SLIGHT
    if lined:  # A worktop is as long as it is laid out, a cabinet not.
        growth = (1.0, FREELY[1] if is_surface(member.request.called) else growth[1])
    factors = (sqrt(growth[0] * growth[1]),) * 2 if even else (growth if long else growth[::-1])
    rim = (usual[0] - top.size[0], usual[1] - top.size[1])
    most = [
        max(side, min(factor * whole, high) - edge)
        for side, factor, whole, high, edge in zip(top.size, factors, usual, kind.size_range[1], rim, strict=False)
    ]
    ahead = sum(usual_size(m, members)[1] * _VARIED + APART for m in loads if facts_of(m.category).is_in("screens"))
    share = pi / 4 if top.round else 1.0
    sides = _grown(top.size, most, areas, long=long, even=even, share=share, ahead=ahead)
    if all(side <= own + 1e-3 for side, own in zip(sides, top.size, strict=True)):
        return None
    return (round(sides[0] + rim[0], 3), round(sides[1] + rim[1], 3))


def _grown(
    top: Vec2, most: Sequence[float], loads: Sequence[Vec2], *, long: int, even: bool, share: float, ahead: float
) -> Vec2:
    """The sides of a top on which things of some depths and widths have room, no longer than `most` [m].

    Args:
        top: its usual sides [m].
        most: its longest sides [m].
        loads: their depths and widths, with air [m].
        long: which of the sides grows first.
        even: both sides are equally long.
        share: of the box round the top that is top.
        ahead: width of those that look over its front side by side [m].
    """
    needed = (PACKED if len(loads) > 1 else 1.0) * sum(x * y for x, y in loads) / share
    shorts, longs = [min(load) for load in loads], [max(load) for load in loads]
    if even:
        side = min(max(*top, sqrt(needed), max(longs)), *most)
        return (side, side)
    across = min(max(top[1 - long], max(shorts)), most[1 - long])
    in_line = sum(shorts if max(longs) <= across else longs) if len(loads) <= FEW else 0.0
    along = min(
        max(
            top[long], ahead if long else 0.0, needed / across, in_line / max(1, int(across / max(shorts))), max(longs)
        ),
        most[long],
    )
    across = min(max(across, needed / along), most[1 - long])
    return (across, along) if long else (along, across)


def asset_of(member: Member, members: Members, size: Vec3) -> Asset:
    """One such thing of a size, as near as it can be made [m]."""
    words = words_of(member, members)
    low, high = sizes_of(kind_of(member.category), words)
    x, y, z = (min(max(s, a), b) for s, a, b in zip(size, low, high, strict=True))
    return make_thing(member.category, seed=0, attributes=words, size=(x, y, z))


def height_over(member: Member, members: Members) -> float | None:
    """The height at which it stands clear over all that is to be under it [m]; None where its own will do."""
    below = under_it(member, members)
    if not below:
        return None
    usual, most = usual_size(member, members), kind_of(member.category).size_range[1][2]
    if all(_fits_under(member, members, usual, usual_size(m, members)) for m in below):
        return None
    top = min(most, RAISED * usual[2])
    return round(top, 3) if top > usual[2] else None


def size_under(member: Member, members: Members) -> Vec3 | None:
    """The size, in its own proportions, at which it fits under what it is to be under [m]; None for its own."""
    over = [members.by_id[a] for t in member.ties if t.kind == "under" for a in t.anchors if a in members.by_id]
    over = [anchor for anchor in over if anchor.mount == "floor"]
    if not over or member not in under_it(over[0], members):
        return None
    anchor, own = over[0], usual_size(member, members)
    x, y, z = usual_size(anchor, members)
    frame = (x, y, anchor.request.size[2] or height_over(anchor, members) or z)
    least = kind_of(member.category).size_range[0]
    for share in (1.0, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4):
        a, b, c = (max(side * share, low) for side, low in zip(own, least, strict=True))
        if _fits_under(anchor, members, frame, (a, b, c)):
            return None if share == 1.0 else (round(a, 3), round(b, 3), round(c, 3))
    return None


def _fits_under(anchor: Member, members: Members, frame: Vec3, size: Vec3) -> bool:
    place = room_under(asset_of(anchor, members, frame).links, size[2] * _VARIED + UNDER)
    if place is None:
        return False
    (x, y), room = sorted((size[0] + UNDER, size[1] + UNDER)), sorted(place)
    return x <= room[0] and y <= room[1]
