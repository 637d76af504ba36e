"""What a brief asks for besides relations, held against the room: numbers, sizes, looks, exclusions, free parts."""

from collections.abc import Collection, Iterator, Sequence

from thinkblox.assets import CATALOGUE, kind_of
from thinkblox.assets.showing import realised
from thinkblox.assets.states import EMPTY, STACKED, meant_by, shows_state
from thinkblox.brief import Brief, Look, Measures, Request
from thinkblox.knowledge.habits import load_habits
from thinkblox.knowledge.rooms import room_type
from thinkblox.knowledge.things import counts_as
from thinkblox.plan import Plan, Tie
from thinkblox.planning import openings_wanted
from thinkblox.scene.asset import Asset
from thinkblox.scene.free_parts import measure_free
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec3
from thinkblox.verdict import Demand

SIZE_SLACK, SIZE_SHARE = 0.01, 0.02
"""A thing is as large as asked within this much [m], or this share of it, whichever is more."""
ROOM_SLACK = 0.05
"""The same for the sides of a room [m]."""
AREA_SHARE = 0.03
"""The same for a room's floor, as a share."""
_AXES = ("deep", "wide", "high")


def demands_of(scene: Scene, plan: Plan) -> tuple[Demand, ...]:
    """Everything that the prompt asks for and that is no relation, in the order of the brief."""
    brief = plan.brief
    found = [*_of_room(scene.room, brief), *_of_openings(scene.room, brief), *_of_people(scene, brief)]
    for request in brief.requests:
        if request.asked:
            found += _of_request(scene, request, placed_of(scene, plan, request.key))
    found += [_of_furniture(scene, look) for look in brief.looks]
    found += [_excluded(scene, category) for category in brief.excluded]
    meant = plan.free if len(plan.free) == len(brief.free) else brief.free
    found += [_free(scene, plan, place, part) for place, part in zip(brief.free, meant, strict=True)]
    return tuple(found)


def _of_people(scene: Scene, brief: Brief) -> Iterator[Demand]:
    """Seats for all whom a room is for, where they sit down together or each has a place of their own."""
    room = room_type(brief.room_type)
    if not brief.people or not (room.seats_at or room.place):
        return
    seats = (p.category for p in scene.placements if load_habits().is_in(p.category, "seats", "seating"))
    count = sum(max(1, kind_of(category).seats) for category in seats)
    measured = f"{count} of {brief.people}"
    yield Demand(kind="count", subject="seat", wanted=f"{brief.people}", holds=count >= brief.people, measured=measured)


def placed_of(scene: Scene, plan: Plan, request: str) -> tuple[Placement, ...]:
    """What stands in the room of a request."""
    return tuple(scene[t.id] for t in plan.targets if t.request == request and t.id in scene)


def _noun(category: str) -> str:
    kind = CATALOGUE.get(category)
    return kind.noun if kind else category.replace("_", " ")


def _of_request(scene: Scene, request: Request, placed: Sequence[Placement]) -> Iterator[Demand]:
    noun = _noun(request.category)
    yield _count(request, noun, len(placed))
    if any(request.size):
        yield _size(request, noun, placed)
    assets = [scene.asset_of(p) for p in placed]
    for word in request.attributes:
        yield _attribute(noun, word, assets)
    for word in request.unshown:
        shown = bool(assets) and all(shows_state(asset, word) for asset in assets)
        says = "shown" if shown else "no shape, colour or material shows it"
        yield Demand(kind="attribute", subject=noun, wanted=word, holds=shown, measured=says)
    for state in request.states:
        shown, says = _state(scene, state, placed)
        yield Demand(kind="state", subject=noun, wanted=state, holds=shown, measured=says)


def _state(scene: Scene, state: str, placed: Sequence[Placement]) -> tuple[bool, str]:
    """Whether all that is placed of a request is in a state, and what was measured."""
    word = meant_by(state)
    shown = bool(placed) and all(shows_state(scene.asset_of(p), state) for p in placed)
    if word == EMPTY and shown:
        ids = {p.id for p in placed}
        held = sum(p.support in ids for p in scene.placements)
        return not held, f"{held} in or on it" if len(placed) == 1 else f"{held} in or on them"
    if word == STACKED and not shown and placed:
        stacked = sum(_is_stacked(scene, one) for one in placed)
        return stacked == len(placed), f"{stacked} of {len(placed)} on or under another one"
    return shown, "that is how it is shown" if shown else "noted, not shown"


def _is_stacked(scene: Scene, one: Placement) -> bool:
    """Whether a thing rests on another of its kind, or carries one."""
    alike = {p.id for p in scene.placements if p.category == one.category}
    return one.support in alike or any(scene[id].support == one.id for id in alike)


def _count(request: Request, noun: str, count: int) -> Demand:
    least, most = request.bounds
    wanted = (
        f"{least}"
        if least == most
        else " and ".join(
            part
            for part in (
                f"at least {request.least}" if request.least is not None else "",
                f"at most {request.most}" if request.most is not None else "",
            )
            if part
        )
    )
    return Demand(
        kind="count", subject=noun, wanted=wanted, holds=least <= count <= most, measured=f"{count} of {wanted}"
    )


def _size(request: Request, noun: str, placed: Sequence[Placement]) -> Demand:
    wanted = _lengths(request.size)
    wrong = [p.size for p in placed if not _fits(p.size, request.size)]
    asked = tuple(axis if length is not None else None for axis, length in enumerate(request.size))
    shown = wrong[0] if wrong else placed[0].size if placed else (0.0, 0.0, 0.0)
    measured = _lengths(tuple(shown[axis] if axis is not None else None for axis in asked))
    return Demand(
        kind="size",
        subject=noun,
        wanted=wanted,
        holds=bool(placed) and not wrong,
        measured=measured if placed else "not in the room",
    )


def _fits(size: Vec3, wanted: Measures) -> bool:
    return all(
        want is None or abs(have - want) <= max(SIZE_SLACK, SIZE_SHARE * want)
        for have, want in zip(size, wanted, strict=True)
    )


def _lengths(measures: Sequence[float | None]) -> str:
    return ", ".join(
        f"{length:.2f} m {axis}" for length, axis in zip(measures, _AXES, strict=True) if length is not None
    )


def _attribute(noun: str, word: str, assets: Sequence[Asset]) -> Demand:
    shown = sum(realised(asset, word) for asset in assets)
    says = f"{shown} of {len(assets)} show it" if len(assets) > 1 else "shown" if shown else "not shown"
    holds = bool(assets) and shown == len(assets)
    return Demand(kind="attribute", subject=noun, wanted=word, holds=holds, measured=says)


def _of_furniture(scene: Scene, look: Look) -> Demand:
    """Whether some of the furniture is as is said of all of it."""
    assets = [scene.asset_of(p) for p in scene.placements]
    shown = sum(all(realised(asset, word) for word in look) for asset in assets)
    measured = f"{shown} of {len(assets)} show it"
    return Demand(kind="attribute", subject="furniture", wanted=" ".join(look), holds=shown > 0, measured=measured)


def _of_room(room: Room, brief: Brief) -> Iterator[Demand]:
    (x, y), area = room.extent, room.polygon.area
    if brief.width is not None and brief.depth is not None:
        fits = _near(sorted((x, y)), sorted((brief.width, brief.depth)))
        yield _room(f"{brief.width:g} m by {brief.depth:g} m", fits, f"{x:g} m by {y:g} m")
    elif (side := brief.width or brief.depth) is not None:
        fits = any(_near([of_room], [side]) for of_room in (x, y))
        yield _room(f"{side:g} m on one side", fits, f"{x:g} m by {y:g} m")
    elif brief.area is not None:
        fits = abs(area - brief.area) <= AREA_SHARE * brief.area
        yield _room(f"{brief.area:g} m2", fits, f"{area:.2f} m2")
    if brief.height is not None:
        yield _room(f"{brief.height:g} m high", _near([room.height], [brief.height]), f"{room.height:g} m high")
    if brief.shape == "L":
        shaped = area < 0.97 * room.polygon.convex_hull.area
        yield _room("L-shaped", shaped, "a corner is missing" if shaped else "no corner is missing")


def _room(wanted: str, holds: bool, measured: str) -> Demand:
    return Demand(kind="room", subject="room", wanted=wanted, holds=holds, measured=measured)


def _near(have: Sequence[float], wanted: Sequence[float]) -> bool:
    return all(abs(a - b) <= ROOM_SLACK for a, b in zip(have, wanted, strict=True))


def _of_openings(room: Room, brief: Brief) -> Iterator[Demand]:
    for kind, where, count, have in openings_wanted(brief, room):
        yield Demand(
            kind="opening",
            subject=f"{kind}{where}",
            wanted=str(count) if count else "none",
            holds=have == count if not count else have >= count,
            measured=f"{have} of {count}" if count else str(have),
        )


def _excluded(scene: Scene, category: str) -> Demand:
    there = [p.id for p in scene.placements if counts_as(p.category, category)]
    measured = ", ".join(there) or "none is there"
    return Demand(kind="excluded", subject=_noun(category), wanted="none", holds=not there, measured=measured)


def _free(scene: Scene, plan: Plan, place: str, part: str) -> Demand:
    holds, measured = measure_free(scene, part, besides=frozenset(_called_to(plan, (place, part))))
    return Demand(kind="free", subject=place.replace("_", " "), wanted="free", holds=holds, measured=measured)


def _called_to(plan: Plan, places: Collection[str]) -> Iterator[str]:
    """Who the prompt puts into the very part that is otherwise to be free: the screen on the empty wall."""
    for target in plan.targets:
        if any(_goes_to(tie, places) for tie in target.ties):
            yield target.id


def _goes_to(tie: Tie, places: Collection[str]) -> bool:
    return tie.asked and not set(places).isdisjoint(tie.anchors) and "wall" not in tie.anchors
