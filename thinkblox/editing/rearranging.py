"""Orders on many things at once: keep a part of the room free, rearrange the room or a region of it."""

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

from thinkblox.assets import facts_of
from thinkblox.editing.acting import moved_words, related
from thinkblox.editing.carrying import place_anew, put_back, take, usual_ties
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import Goal, Region, Related, Within
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.reaching import Reaching, ties_of
from thinkblox.editing.removing import left_over
from thinkblox.editing.room_for import room_for
from thinkblox.editing.telling import named, spare
from thinkblox.editing.wheres import bound, corner_near
from thinkblox.editing.work import Work
from thinkblox.editing.zones import PlaceZone, Zone, place_named, zones_of
from thinkblox.errors import InputError
from thinkblox.judging import asset_for
from thinkblox.knowledge.rooms import Usual, room_types
from thinkblox.knowledge.things import counts_as
from thinkblox.plan import Tie
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.free_parts import parts
from thinkblox.scene.landmarks import corners, things
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.room import turn_between
from thinkblox.scene.scene import Scene

CORNER_REACH = 1.7
"""How far from its corner a thing's middle may be to belong to that corner of the room [m]."""
SAME, SAME_YAW = 0.1, 5.0
"""How far something has moved [m] and turned [degrees] at most that stands as it did."""
ABOUT = 1.0
"""How far beyond a thing its surroundings reach [m]."""
AMID = ("in_centre",)
GoalsOf = Callable[[str], Sequence[Goal]]


def rearrange(work: Work, finder: Finder, order: Order) -> None:
    """Rearrange the room, a region of it or some things; keep free what is to stay free."""
    with _sparing(work, finder, order):
        _rearrange(work, finder, order)


@contextmanager
def _sparing(work: Work, finder: Finder, order: Order) -> Iterator[None]:
    """Nothing that the order excepts is touched meanwhile."""
    kept, everything = work.kept, [p.id for p in work.scene.placements]
    work.kept |= {*everything} - {*spare(finder, everything, order.spared)}
    yield
    work.kept = kept


def _rearrange(work: Work, finder: Finder, order: Order) -> None:
    """As `rearrange`, of what is not excepted.

    Raises:
        InputError: things are to stand to each other in a way that is no formation.
    """
    if order.mutual:
        raise InputError(
            f"'{order.text}': how they stand to each other is followed of two things, or of two rows of seats"
        )
    region = _region(work, finder, order)
    if order.free:
        if region is not None:
            raise InputError(f"'{order.text}' names {region[0].name} and what is to stay free; give two orders")
        free(work, finder, order)
        return
    if region is not None:
        _rearrange_region(work, region[0], region[1], order)
        return
    if order.things:
        ids = [id for phrase in order.things for id in named(finder, phrase, ())]
        places = [where for phrase in order.things for where in phrase.places]
        goals = {id: [_related(work, finder, id, w, n, len(ids)) for w in places] for n, id in enumerate(ids)}
        _arranged(work, ids, lambda id: goals.get(id, ()), "them")
        return
    movers = [id for id in _standing(work.scene) if id not in work.kept]
    if order.rest and order.places:
        there = left_over(work, finder, order)
        movers = [id for id in movers if id in there]
        if not movers:
            raise InputError(f"'{order.text}': nothing stands there that could be moved")
        goals = {id: [_related(work, finder, id, w, n, 1) for w in order.places] for n, id in enumerate(movers)}
        _arranged(work, movers, lambda id: goals.get(id, ()), "them")
        return
    _arranged(work, movers, lambda id: (), "the room")


def _related(work: Work, finder: Finder, id: str, where: Where, number: int, count: int) -> Goal:
    category = work.scene[id].category
    return related(bound(where, category, finder), category, number, count)


def _standing(scene: Scene) -> list[str]:
    """Everything on the floor that is not walked on."""
    return [p.id for p in scene.placements if p.support == "floor" and scene.asset_of(p).collides]


# --- keeping free


def free(work: Work, finder: Finder, order: Order) -> None:
    """Move what stands in stretches of the floor that are to be free out of them, and nothing else if that will do.

    Raises:
        InputError: the order names none, or one that the room does not have.
    """
    if room_for(work, order):
        return
    places = [place_named(noun) for noun in order.free]
    zones: list[Zone] = [PlaceZone(place) for place in places]
    zones += [zone for where in order.places for zone in zones_of(work.scene, finder, where, _depth(order))]
    if not zones:
        raise InputError(f"'{order.text}' does not say which part of the room is to be free")
    for zone in zones:
        if isinstance(zone, PlaceZone) and not parts(work.scene.room, zone.place):
            raise InputError(f"the room has no {zone.place.replace('_', ' ')} that could be kept free")
    with _sparing(work, finder, order):
        vacate(work, zones)


def _depth(order: Order) -> float | None:
    """How far what is to be free reaches [m]; None where that is not said.

    Raises:
        InputError: several lengths are said, or of what has its own size.
    """
    if len(order.lengths) > 1 or (order.lengths and (order.free or not order.places)):
        raise InputError(f"'{order.text}': how far is followed of the space before a window or a thing alone")
    return order.lengths[0][0] if order.lengths else None


def vacate(work: Work, zones: Sequence[Zone]) -> None:
    """Move what stands in some stretches of floor out of them."""
    work.freed = tuple(dict.fromkeys((*work.freed, *(zone.place for zone in zones if isinstance(zone, PlaceZone)))))
    goals = [zone.goal for zone in zones]
    there = list(dict.fromkeys(id for zone in zones for id in zone.takers(work.scene)))
    movers = [id for id in there if id not in work.kept]
    if len(movers) < len(there):
        stuck = ", ".join(id for id in there if id in work.kept)
        work.failed.append(f"{zones[0].measure(work.scene)[1]}: {stuck} was to stay where it is")
        return
    if not movers:
        work.done.append(f"{'; '.join(zone.measure(work.scene)[1] for zone in zones)}: it is so already")
        return
    if _moved_aside(work, movers, goals) and all(zone.measure(work.scene)[0] for zone in zones):
        work.done.append("; ".join(zone.measure(work.scene)[1] for zone in zones))
        return
    why = ""
    everything = [id for id in _standing(work.scene) if id not in work.kept]
    for group in (movers, _with_company(work.scene, movers), list(dict.fromkeys([*movers, *everything]))):
        before = work.scene
        why = _replaced(work, group, lambda id: goals)
        if not why:
            _say_moved(work, before, group)
            break
    held = [zone.measure(work.scene) for zone in zones]
    says = "; ".join(text for _, text in held)
    (work.failed if why or not all(h for h, _ in held) else work.done).append(f"{says}{f'; {why}' if why else ''}")


def _moved_aside(work: Work, movers: Sequence[str], goals: Sequence[Goal]) -> bool:
    """Move single things, with all that rests on them, just out of the way; where one cannot, all is as before."""
    before, saved = work.scene, work.saved()
    for id in movers:
        planned = tuple(tie for tie in work.usual_ties(id) if tie.kind not in AMID)
        for ties in dict.fromkeys((planned, ())):
            asset = work.asset_of(id)
            target = work.target(id, before[id].category, ties, asset.attributes)
            if Reaching(work, target, asset, goals, begin=(before[id].position, before[id].yaw)).run():
                break
        else:
            work.restore(saved)
            return False
    _say_moved(work, before, movers)
    return True


def _with_company(scene: Scene, ids: Sequence[str]) -> list[str]:
    """These, and the seats that are drawn up to them."""
    seats = [p.id for p in scene.placements if p.support == "floor" and facts_of(p.category).is_in("seating")]
    drawn_up = [
        seat
        for id in ids
        for seat in seats
        if seat != id and measure(scene, "at", seat, (id,)).holds and _is_table(scene, id)
    ]
    return list(dict.fromkeys([*ids, *drawn_up]))


def _is_table(scene: Scene, id: str) -> bool:
    return facts_of(scene[id].category).is_in("tables", "desks", "counters")


# --- everything anew


def _arranged(work: Work, ids: Sequence[str], goals_of: GoalsOf, what: str) -> None:
    movers = [id for id in ids if id not in work.kept]
    before = work.scene
    why = _replaced(work, movers, goals_of)
    if why:
        work.failed.append(f"no other arrangement was found for {what}: {why}")
        return
    if not all(_is_as_good_as(before[id], work.scene[id]) for id in movers):
        _say_moved(work, before, movers)
    else:
        work.world = work.world.with_scene(before)
        work.failed.append("the arrangement is the same as before; another seed may find another one")


def _is_as_good_as(old: Placement, new: Placement) -> bool:
    """Whether something stands about where it stood."""
    return math.dist(old.position, new.position) < SAME and turn_between(old.yaw, new.yaw) < SAME_YAW


def _say_moved(work: Work, before: Scene, ids: Sequence[str]) -> None:
    for id in ids:
        if work.scene[id] != before[id]:
            work.done.append(moved_words(before[id], work.scene[id]))


def _replaced(work: Work, ids: Sequence[str], goals_of: GoalsOf) -> str:
    """Take things out and place each anew, large ones first; why not, where that cannot be, and all is as before."""
    before, saved = work.scene, work.saved()
    company = {id: _table_of(before, id, ids) for id in ids}
    taken = take(work, ids)
    ordered = sorted(ids, key=lambda id: (bool(company[id]), -before[id].size[0] * before[id].size[1]))
    for id in ordered:
        why = _placed(work, before, id, company, goals_of(id))
        if why:
            work.restore(saved)
            return why
    for id in ordered:
        lost = put_back(work, before[id], [p for p in taken if p.id not in ids], before)
        for rider in (p for p in taken if p.id in lost):
            if not place_anew(work, rider, carriers=(id,)):
                work.restore(saved)
                return f"{rider.id} found no place on {id} any more"
    return ""


def _table_of(scene: Scene, id: str, among: Sequence[str]) -> str:
    """The table that a seat is drawn up to, of these."""
    if not facts_of(scene[id].category).is_in("seating"):
        return ""
    tables = (other for other in among if other != id and _is_table(scene, other))
    return next((table for table in tables if measure(scene, "at", id, (table,)).holds), "")


def _placed(work: Work, before: Scene, id: str, company: dict[str, str], goals: Sequence[Goal]) -> str:
    old, asset, table = before[id], work.assets[before[id].asset], company[id]
    mates = [other for other, at in company.items() if at and at == table]
    planned = tuple(tie for tie in work.usual_ties(id) if tie.kind not in AMID or not work.freed)
    ties: tuple[Tie, ...] = ties_of(goals) or planned or usual_ties(work.scene, old.category)
    wanted = list(goals)
    if table:
        ties = (Tie(kind="around", anchors=(table,), index=mates.index(id), count=len(mates)),)
        wanted.append(Related("near", (table,)))
    carriers = before.carriers(id)
    if carriers and carriers[-1] in work.scene:
        wanted.append(Related("on", (carriers[-1],)))
    if work.freed:
        ties = tuple(tie for tie in ties if tie.kind not in AMID)
    why = ""
    for told in dict.fromkeys((ties, ())):
        target = work.target(id, old.category, told, asset.attributes)
        reaching = Reaching(work, target, asset, wanted, begin=(old.position, old.yaw))
        if reaching.run():
            return ""
        why = reaching.why
    return why


# --- a region


def _region(work: Work, finder: Finder, order: Order) -> tuple[Region, tuple[str, ...]] | None:
    """The region that an order names, and the walls of its corner; None for the whole room."""
    place = next((phrase for phrase in order.things if phrase.noun.kind == "place"), None)
    if place is not None and place.noun.value.split()[0] == "corner":
        names = tuple(place.noun.value.split()[1:])
        for where in place.places:
            if where.noun is not None:
                mark = where.noun.value.split()[0] if where.noun.kind == "place" else ""
                names = corner_near(work.scene, mark or finder.ids(NounPhrase(where.noun))[0])
        found = corners(work.scene.room, names)
        if not found:
            raise InputError("the room has no such corner")
        corner = (
            min(found, key=lambda c: sum(_near(p, c.centre) for p in work.scene.placements)) if not names else found[0]
        )
        walls = tuple(corner.name.removeprefix("corner of ").split(" and "))
        return Region(corner.centre, CORNER_REACH, f"the {corner.name}"), walls
    if place is not None:
        marks = things(work.scene, place.noun.value.split()[0])
        if not marks:
            raise InputError(f"the room has no {place.noun.value.replace('_', ' ')}")
        return Region(marks[0].centre, CORNER_REACH, f"the part by {marks[0].name}"), ()
    about = [where for where in order.places if where.noun is not None and where.noun.kind == "thing"]
    for other in about[1:]:
        names = finder.ids(NounPhrase(other.noun)) if other.noun is not None else ()
        raise InputError(
            f"'{order.text}': a part of the room is not rearranged about {', '.join(names)}; move what is to go there"
        )
    if about and about[0].noun is not None:
        thing = work.scene[finder.ids(NounPhrase(about[0].noun))[0]]
        reach = max(thing.size[:2]) / 2 + ABOUT
        return Region(thing.position[:2], reach, f"the surroundings of {thing.id}"), ()
    return None


def _near(placement: Placement, point: tuple[float, float]) -> bool:
    return abs(placement.position[0] - point[0]) + abs(placement.position[1] - point[1]) < CORNER_REACH


def _rearrange_region(work: Work, region: Region, walls: tuple[str, ...], order: Order) -> None:
    movers = [id for id in _standing(work.scene) if id not in work.kept and region.holds(things(work.scene, id)[0])]
    if not order.into:
        if not movers:
            work.failed.append(f"nothing stands in {region.name}")
            return
        _arranged(work, movers, lambda id: (Within(region),), region.name)
        return
    zone = room_types().get(order.into)
    if zone is None:
        raise InputError(f"it is not known what a {order.into.replace('_', ' ')} is made of")
    before, saved = work.scene, work.saved()
    why = _furnished(work, region, walls, movers, zone.expected or zone.usual)
    if why:
        work.restore(saved)
        work.failed.append(f"{region.name} did not become a {order.into.replace('_', ' ')}: {why}")
        return
    _say_moved(work, before, [id for id in movers if id in work.scene])
    new = [p.id for p in work.scene.placements if p.id not in before]
    work.done += [f"{id} added at ({work.scene[id].position[0]:.2f}, {work.scene[id].position[1]:.2f})" for id in new]


def _furnished(
    work: Work, region: Region, walls: tuple[str, ...], movers: Sequence[str], wanted: Sequence[Usual]
) -> str:
    """Make a zone of a region: what belongs there comes first, then what stood there; why not, where it cannot be."""
    before = work.scene
    taken = take(work, movers)
    placed: dict[str, str] = {}
    for usual in wanted:
        for _ in range(usual.count):
            old = next((id for id in movers if id not in placed.values() and _is(before, id, usual.category)), "")
            why = _zone_piece(work, region, walls, usual, old, before, placed)
            if why:
                return why
    for id in (i for i in movers if i not in work.scene):
        if not _where_it_was(work, before[id]) and not place_anew(work, before[id]):
            return f"{id}, which stood there, finds no other place"
    for id in movers:
        lost = put_back(work, before[id], [p for p in taken if p.id not in movers], before)
        for rider in (p for p in taken if p.id in lost):
            if not place_anew(work, rider, carriers=(id,)):
                return f"{rider.id}, which rested on {id}, finds no other place"
    return ""


def _is(scene: Scene, id: str, category: str) -> bool:
    return counts_as(scene[id].category, category)


def _where_it_was(work: Work, old: Placement) -> bool:
    asset = work.assets[old.asset]
    if not work.world.check([old], asset)[0].valid:
        return False
    work.world = work.world.with_placement(old, asset)
    return True


def _zone_piece(
    work: Work,
    region: Region,
    walls: tuple[str, ...],
    usual: Usual,
    old: str,
    before: Scene,
    placed: dict[str, str],
) -> str:
    goals: list[Goal] = []
    for kind, anchor, _ in usual.relations:
        if anchor in placed:
            goals.append(Related(kind, (placed[anchor],)))  # type: ignore[arg-type]
        elif kind == "in_corner" and walls:
            goals.append(Related("in_corner", walls))
    goals.append(Within(Region(region.centre, region.reach + 0.5, region.name)))
    category = before[old].category if old else usual.category
    id = old or work.new_id(category)
    target = work.target(id, category, ties_of(goals))
    asset = work.assets[before[old].asset] if old else asset_for(target, work.scene, work.source)
    reaching = Reaching(work, target, asset, goals, begin=((*region.centre, 0.0), 0.0))
    if not reaching.run():
        return reaching.why
    placed[usual.category] = id
    return ""
