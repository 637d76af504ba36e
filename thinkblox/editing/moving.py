"""Orders on things that are there: move them, turn them, let them change places."""

import math
from collections.abc import Iterator, Sequence
from itertools import chain

from shapely.ops import nearest_points

from thinkblox.assets import facts_of
from thinkblox.brief import RelationKind
from thinkblox.committing import commit
from thinkblox.editing.carrying import place_anew, put_back, take, usual_ties
from thinkblox.editing.finding import Finder, Picks, nearest_to
from thinkblox.editing.goals import (
    ELSEWHERE,
    ELSEWHERE_SMALL,
    Along,
    Apart,
    At,
    Elsewhere,
    Goal,
    IntoRoom,
    Nearing,
    Related,
    Turned,
)
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.reaching import Reaching, ties_of, without
from thinkblox.editing.spots import Pose, spots
from thinkblox.editing.wheres import Bound, bound, named
from thinkblox.editing.work import Work
from thinkblox.episode import Round
from thinkblox.errors import InputError
from thinkblox.judging import Proposal, Try
from thinkblox.plan import Tie
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.actions import Swap
from thinkblox.scene.bearings import bearing, place_of
from thinkblox.scene.landmarks import Landmark, things
from thinkblox.scene.nearby import nearest_poses
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import turn_between
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import placed_at
from thinkblox.steps import write_step
from thinkblox.value import Vec2, Vec3

STEPS = (0.3, 0.5, 0.2, 0.4, 0.7, 1.0, 0.1, 0.05)
"""How far something is moved where nobody says it [m]."""
SHARES = (0.5, 0.65, 0.35, 0.8, 0.2, 0.95)
"""Which share of a gap is closed where nobody says it."""
SWAP_TRIES = 60
"""Poses around the other's place that are looked at for one of two that change places."""
SWAPPED = 0.5
"""How far from the other's place something may stand that has changed places with it, besides half their sizes [m]."""


def move(work: Work, finder: Finder, order: Order) -> None:
    """Move things to where an order says, or by as much, or nearer to or away from something."""
    if order.together:
        _together(work, finder, order)
        return
    seen: set[tuple[str, str]] = set()
    for ids, places in _moved(finder, order):
        _check_says_where(order, places)
        for index, id in enumerate(ids):
            said = (id, " ".join(f"{w.text} {w.noun.text if w.noun else ''}" for w in places))
            if said in seen:
                continue
            seen.add(said)
            goals = _goals(work, finder, order, id, places, index, len(ids))
            _move_one(work, order, id, goals)
        finder.recent = list(ids)


def _check_says_where(order: Order, places: Sequence[Where]) -> None:
    if not (places or order.closer or order.direction or order.facing):
        raise InputError(f"'{order.text}' does not say where to; say a place, such as 'next to the bed'")


def _moved(finder: Finder, order: Order) -> Iterator[tuple[tuple[str, ...], list[Where]]]:
    """What is moved, with what is said of where it goes."""
    if not order.things:
        raise InputError(f"'{order.text}' does not say what; there {finder.listed()}")
    for number, phrase in enumerate(order.things):
        later = next((p.places for p in order.things[number:] if p.places), order.places)
        places = phrase.places or later
        if phrase.noun.kind in ("place", "part"):
            raise InputError(f"'{phrase.noun.text}' is no thing that can be moved; there {finder.listed()}")
        qualifiers, destination = _split(finder, order, phrase, places)
        yield named(finder, phrase, qualifiers, picks=_picks(finder, order, phrase, destination)), destination


def _split(
    finder: Finder, order: Order, phrase: NounPhrase, places: Sequence[Where]
) -> tuple[list[Where], list[Where]]:
    """Where the thing is said to be now, and where it is to go."""
    here = [w for w in places if w.word == "from"]
    rest = [w for w in places if w.word != "from"]
    if phrase.places is not places and not phrase.places:
        return here, rest
    if order.closer or order.direction or order.doing == "resite":
        return [*here, *rest], []
    directed = next((n for n, w in enumerate(rest) if w.text.lower() in ("to", "into", "onto", "over to")), None)
    if directed is not None and directed > 0:
        return [*here, *rest[:directed]], rest[directed:]
    wanted = [w for w in rest if not w.negated]
    if len(wanted) > 1 and directed is None and phrase.noun.kind == "thing":
        several = len(finder.matching(phrase.noun)) > 1 and not phrase.noun.many
        if several or (wanted[0].word in ("next_to", "on", "in", "by", "at") and wanted[1].word in ("to", "next_to")):
            return [*here, *rest[:1]] if several else here, rest[1:] if several else rest
    return here, rest


def _picks(finder: Finder, order: Order, phrase: NounPhrase, places: Sequence[Where]) -> tuple[Picks, ...]:
    """Of several that fit, those of which an order makes sense: what is not yet where it is to go."""

    def left_there(found: Sequence[Placement]) -> Sequence[Placement]:
        for where in (w for w in places if w.negated):
            away = bound(where, found[0].category, finder)
            found = [p for p in found if not away.holds(finder.scene, p.id)]
        return found

    def not_yet(found: Sequence[Placement]) -> Sequence[Placement]:
        wanted = [bound(w, found[0].category, finder) for w in places if not w.negated]
        return [p for p in found if not all(b.holds(finder.scene, p.id) for b in wanted if not b.of_room)]

    picks: list[Picks] = [left_there] if any(w.negated for w in places) else []
    if any(not w.negated for w in places):
        picks.append(not_yet)
    for _, anchor in order.closer:
        name = anchor.noun.value if anchor.noun.kind == "place" else ""
        if not name:
            name = finder.ids(anchor)[0]
        count = 2 if phrase.noun.det == "both" else phrase.noun.count or 0
        if count > 1:
            picks.append(nearest_to(finder.scene, name, count))
    return tuple(picks)


def _goals(
    work: Work, finder: Finder, order: Order, id: str, places: Sequence[Where], index: int, count: int
) -> list[Goal]:
    category = work.scene[id].category
    goals: list[Goal] = []
    for where in places:
        there = bound(where, category, finder)
        if id in there.anchors and not there.negated:
            raise InputError(f"{id} cannot be put where it is itself: '{where.text} {where.noun and where.noun.text}'")
        goals.append(related(there, category, index, count))
    for nearer, phrase in order.closer:
        anchors = mark_names(finder, phrase)
        goals.append(Nearing(anchors, nearer, order.lengths[0][0] if order.lengths else None))
    goals += [Apart(mark_names(finder, phrase), away) for away, phrase in order.apart]
    return goals + [looking(finder, noun) for noun in order.facing]


def related(there: Bound, category: str, index: int = 0, count: int = 1) -> Goal:
    """A relation as a goal; of several around a thing each is by it, and seats are drawn up to it."""
    if there.of_room:
        return IntoRoom()
    measured: RelationKind | None = None
    if there.kind == "around":
        measured = "at" if facts_of(category).is_in("seating") else "near"
    return Related(there.kind, there.anchors, there.negated, index, count, measured)


def mark_names(finder: Finder, phrase: NounPhrase) -> tuple[str, ...]:
    """What distances are measured to: ids, or a part of the room."""
    noun = phrase.noun
    if noun.kind == "place":
        if not things(finder.scene, noun.value.split()[0]):
            raise InputError(f"the room has no {noun.value.replace('_', ' ')}")
        return (noun.value.split()[0],)
    if noun.kind == "part" and noun.value == "middle":
        return ("centre",)
    return named(finder, phrase, phrase.places)


def looking(finder: Finder, noun: Noun) -> Goal:
    """What something is to face, as a goal."""
    if noun.kind == "room":
        return IntoRoom()
    if noun.kind == "part" and noun.value == "middle":
        return Related("facing", ("centre",))
    return Related("facing", mark_names(finder, NounPhrase(noun)))


def _move_one(work: Work, order: Order, id: str, goals: Sequence[Goal]) -> None:
    before = work.scene[id]
    if goals and all(goal.check(work.before, work.scene, id)[0] for goal in goals):
        work.done.append(f"{id} stays: it is so already ({'; '.join(_findings(work, goals, id))})")
        return
    gap = next((goal for goal in goals if isinstance(goal, Nearing)), None)
    if gap is not None:
        direct: Iterator[Pose] = _by_gap(work.scene, before, gap)
        done = _reach(work, id, goals, direct=direct, ask=True)
    elif order.direction and not order.closer:
        direct, more = _by_step(work, order, before)
        goals = [*goals, *more]
        done = _reach(work, id, goals, direct=direct, ask=False, search=not order.lengths)
    else:
        direct = chain(_in_line(work.scene, before, goals), _so_far(work.scene, before, goals), _spots(work, id, goals))
        done = _reach(work, id, goals, direct=direct, ask=True)
    _say(work, id, before, done, goals)


def _spots(work: Work, id: str, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Places that the goals name, seen without the object and what rests on it."""
    empty = without(work.scene, [id, *(rider.id for rider in work.scene.riders(id))])
    yield from spots(empty, work.asset_of(id), goals)


def _findings(work: Work, goals: Sequence[Goal], id: str) -> Iterator[str]:
    for goal in goals:
        yield goal.check(work.before, work.scene, id)[1]


def _reach(
    work: Work,
    id: str,
    goals: Sequence[Goal],
    *,
    direct: Iterator[Pose],
    ask: bool,
    search: bool = True,
    ties: Sequence[Tie] | None = None,
    begin: Pose | None = None,
) -> Reaching | None:
    """Bring an object to its goals; returns None when that is done, or what was tried."""
    told = ties_of(goals) if ties is None else tuple(ties)
    target = work.target(id, work.scene[id].category, told, work.asset_of(id).attributes)
    reaching = Reaching(
        work, target, work.asset_of(id), goals, direct=direct, ask=ask and bool(told), search=search, begin=begin
    )
    return None if reaching.run() else reaching


def _say(work: Work, id: str, before: Placement, failed: Reaching | None, goals: Sequence[Goal]) -> None:
    if failed is not None:
        work.failed.append(f"{id} was left where it is: {failed.why}")
        return
    text = "; ".join(dict.fromkeys(_findings(work, goals, id)))
    work.done.append(f"{moved_words(before, work.scene[id])}{f' ({text})' if text else ''}")


def moved_words(before: Placement, after: Placement) -> str:
    """How something has moved and turned, in words."""
    away = math.dist(before.position, after.position)
    turn = turn_between(before.yaw, after.yaw)
    x, y, z = after.position
    parts = [f"moved {away:.2f} m to ({x:.2f}, {y:.2f}{f', {z:.2f}' if z > 0.02 else ''})"] if away >= 0.005 else []
    parts += [f"turned by {turn:.0f} degrees to yaw {after.yaw:g}"] if turn > 0.5 else []
    return f"{after.id} {' and '.join(parts) or 'stays where it is'}"


def _in_line(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """The place as it is, where only the front is to point elsewhere."""
    if goals and all(
        isinstance(goal, IntoRoom) or (isinstance(goal, Related) and goal.kind == "facing") for goal in goals
    ):
        yield from _turns(scene, before, goals)


def _so_far(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Before, behind and beside a thing, at the distance that is wanted and turned to it."""
    for goal in (g for g in goals if isinstance(g, Apart)):
        for anchor in (scene[name] for name in goal.anchors if name in scene):
            for turn in (0.0, 180.0, 90.0, 270.0):
                way = math.radians(anchor.yaw + turn)
                deep = anchor.size[0] if turn in (0.0, 180.0) else anchor.size[1]
                reach = (deep + before.size[0]) / 2 + goal.away
                x, y = anchor.position[0] + reach * math.cos(way), anchor.position[1] + reach * math.sin(way)
                yaw = (anchor.yaw + turn + 180.0) % 360.0
                yield (round(x, 4), round(y, 4), before.position[2]), yaw


# --- nearer and further, by so much


def _by_gap(scene: Scene, placement: Placement, gap: Nearing) -> Iterator[Pose]:
    """Towards the nearest of the anchors, or away from it."""
    mark = things(scene, placement.id)[0]
    marks = [m for name in gap.anchors for m in things(scene, name)]
    anchor = min(marks, key=lambda m: float(mark.footprint.distance(m.footprint)))
    now = gap.of(scene, placement.id)
    x, y = _nearest_way(mark, anchor)
    if gap.by is not None:
        lengths: tuple[float, ...] = (gap.by,)
    elif gap.nearer:
        lengths = tuple(share * now for share in SHARES) if now > 0.005 else ()
    else:
        lengths = STEPS
    sign = 1.0 if gap.nearer else -1.0
    for length in lengths:
        yield _shifted(placement, (sign * x * length, sign * y * length, 0.0)), placement.yaw


def _nearest_way(mark: Landmark, anchor: Landmark) -> Vec2:
    """Unit vector from the outline of one thing to the nearest point of another's."""
    one, other = nearest_points(mark.footprint, place_of(anchor))
    dx, dy = other.x - one.x, other.y - one.y
    if math.hypot(dx, dy) < 1e-6:
        dx, dy = anchor.centre[0] - mark.centre[0], anchor.centre[1] - mark.centre[1]
    length = math.hypot(dx, dy) or 1.0
    return (dx / length, dy / length)


def _shifted(placement: Placement, by: Vec3) -> Vec3:
    x, y, z = (round(a + b, 4) for a, b in zip(placement.position, by, strict=True))
    return (x, y, z)


def _by_step(work: Work, order: Order, placement: Placement) -> tuple[Iterator[Pose], list[Goal]]:
    """In a direction: its own left, right, front and back; up and down; or by the compass."""
    (fx, fy), (lx, ly) = placement.front, placement.left
    ways: dict[str, Vec3] = {
        "left": (lx, ly, 0.0),
        "right": (-lx, -ly, 0.0),
        "forward": (fx, fy, 0.0),
        "back": (-fx, -fy, 0.0),
        "up": (0.0, 0.0, 1.0),
        "down": (0.0, 0.0, -1.0),
        "north": (0.0, 1.0, 0.0),
        "south": (0.0, -1.0, 0.0),
        "east": (1.0, 0.0, 0.0),
        "west": (-1.0, 0.0, 0.0),
    }
    way = ways[order.direction]
    if order.direction in ("up", "down") and work.asset_of(placement.id).free:
        raise InputError(
            f"{placement.id} stands on {placement.support}; only what hangs can be moved {order.direction}"
        )
    if not order.lengths:
        return iter([(_shifted(placement, _scaled(way, s)), placement.yaw) for s in STEPS]), [Along(way)]
    goal = _shifted(placement, _scaled(way, order.lengths[0][0]))
    return iter([(goal, placement.yaw)]), [At(goal[:2], height=goal[2] if way[2] else None)]


def _scaled(way: Vec3, length: float) -> Vec3:
    return (way[0] * length, way[1] * length, way[2] * length)


def _together(work: Work, finder: Finder, order: Order) -> None:
    ids = list(dict.fromkeys(id for ids, _ in _moved(finder, order) for id in ids))
    if len(ids) < 2:
        raise InputError(f"'{order.text}' names one thing; say what it is to come closer to")
    fixed, *rest = sorted(ids, key=lambda id: -work.scene[id].size[0] * work.scene[id].size[1])
    for id in rest:
        _move_one(work, order, id, [Nearing((fixed,), nearer=True)])
    finder.recent = ids


# --- turning


def turn(work: Work, finder: Finder, order: Order) -> None:
    """Turn things by an angle, or until they face something."""
    seen: set[str] = set()
    for ids, places in _turned(finder, order):
        for id in (i for i in ids if i not in seen):
            seen.add(id)
            placement = work.scene[id]
            looks = [looking(finder, noun) for noun in order.facing]
            looks += [related(bound(w, placement.category, finder), placement.category) for w in places]
            if looks:
                _turn_to(work, id, looks)
            else:
                _turn_by(work, id, order)
        finder.recent = list(ids)


def _turned(finder: Finder, order: Order) -> Iterator[tuple[tuple[str, ...], list[Where]]]:
    if not order.things:
        raise InputError(f"'{order.text}' does not say what; there {finder.listed()}")
    for phrase in order.things:
        looks = [w for w in phrase.places if w.word in ("facing", "opposite")]
        said = [w for w in phrase.places if w not in looks]
        yield named(finder, phrase, said), looks


def _turn_by(work: Work, id: str, order: Order) -> None:
    before = work.scene[id]
    angle, sense = order.turn, order.sense
    if order.direction in ("left", "right"):
        angle, sense = angle or 90.0, 1 if order.direction == "left" else -1
    if order.direction in ("back", "forward"):
        angle = angle or 180.0
    if angle is None and sense:
        angle = 90.0
    if angle is None:
        raise InputError(f"'{order.text}' does not say how far, or what it is to face; say 'by 90 degrees'")
    senses = (1, -1) if not sense else (sense,)
    yaws = tuple(dict.fromkeys(round((before.yaw + s * angle) % 360.0, 4) % 360.0 for s in senses))
    goal = Turned(yaws)
    poses = iter([(before.position, yaw) for yaw in yaws])
    failed = _reach(work, id, [goal], direct=poses, ask=False, begin=(before.position, yaws[0]))
    _say(work, id, before, failed, [goal])


def _turn_to(work: Work, id: str, goals: Sequence[Goal]) -> None:
    before = work.scene[id]
    if all(goal.check(work.before, work.scene, id)[0] for goal in goals):
        work.done.append(f"{id} stays: it is so already ({'; '.join(_findings(work, goals, id))})")
        return
    failed = _reach(work, id, goals, direct=_turns(work.scene, before, goals), ask=False)
    _say(work, id, before, failed, goals)


def _turns(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """The place as it is with every yaw that may do: square to the walls first, then straight at what it faces."""
    square = sorted((wall.yaw for wall in scene.room.walls), key=lambda yaw: turn_between(yaw, before.yaw))
    away = 180.0 if scene.asset_of(before).gaze == "back" else 0.0
    names = [n for goal in goals for n in (goal.anchors if isinstance(goal, Related) else ("centre",))]
    marks = [mark for name in names for mark in things(scene, name)]
    straight = [round((bearing(before.position[:2], mark.centre) + away) % 360.0, 1) % 360.0 for mark in marks]
    for yaw in dict.fromkeys([*square, *straight]):
        yield before.position, yaw


# --- another place, and each other's places


def resite(work: Work, finder: Finder, order: Order) -> None:
    """Find another place for things."""
    for ids, _ in _moved(finder, order):
        for id in ids:
            before = work.scene[id]
            goal = Elsewhere(ELSEWHERE if before.support == "floor" else ELSEWHERE_SMALL)
            planned = work.usual_ties(id) or usual_ties(work.scene, before.category)
            failed: Reaching | None = None
            for ties in (planned, ()):
                failed = _anywhere(work, id, goal, ties)
                if failed is None:
                    break
            _say(work, id, before, failed, [goal])
        finder.recent = list(ids)


def _anywhere(work: Work, id: str, goal: Goal, ties: Sequence[Tie]) -> Reaching | None:
    target = work.target(id, work.scene[id].category, ties, work.asset_of(id).attributes)
    reaching = Reaching(work, target, work.asset_of(id), [goal])
    return None if reaching.run() else reaching


def swap(work: Work, finder: Finder, order: Order) -> None:
    """Let two things change places."""
    ids = [id for phrase in order.things for id in named(finder, phrase, phrase.places)]
    ids = list(dict.fromkeys(ids))
    if len(ids) != 2:
        raise InputError(f"'{order.text}' must name two things that change places; it names {', '.join(ids) or 'none'}")
    one, other = ids
    before = work.scene
    action = Swap(id=one, other=other)
    after = before.apply(action)
    verdict = work.world.measure(action)
    text = write_step([f"{one} and {other} change places."], action="swap", id=one, other=other)
    proposal = Proposal(text, action, after[one], after.asset_of(after[one]))
    tried = Try(text=text, placement=after[one], verdict=verdict)
    if verdict.valid:
        work.world, placements = commit(work.world, proposal, verdict)
    else:
        placements = ()
    work.rounds.append(
        Round(
            id=one,
            number=0,
            kind="repair",
            asset=before[one].asset,
            tries=(tried,),
            chosen=0 if verdict.valid else None,
            committed=placements,
        )
    )
    for id in ids:
        work.assets[before[id].asset] = before.asset_of(before[id])
    if not verdict.valid:
        why = _swap_nearby(work, one, other)
        if why:
            work.failed.append(f"{one} and {other} were left where they are: {why}; exactly exchanged, {verdict}")
            return
    for id in ids:
        work.done.append(f"{moved_words(before[id], work.scene[id])}, to where {other if id == one else one} was")
    finder.recent = ids


def _swap_nearby(work: Work, one: str, other: str) -> str:
    """Put each as near to the other's place as it can stand; says why where that is not near enough."""
    before, saved = work.scene, work.saved()
    exchanged = before.apply(Swap(id=one, other=other))
    taken = take(work, (one, other))
    order = sorted((one, other), key=lambda id: -before[id].size[0] * before[id].size[1])
    for id in order:
        partner = before[other if id == one else one]
        reach = SWAPPED + abs(max(before[id].size[:2]) - min(partner.size[:2])) / 2
        asset, pose = work.assets[before[id].asset], exchanged[id]
        goals: list[Goal] = [At(partner.position[:2], reach)]
        target = work.target(id, before[id].category, (), asset.attributes)
        poses = _about(work, id, pose)
        reaching = Reaching(work, target, asset, goals, direct=poses, ask=False, tries=SWAP_TRIES)
        if not reaching.run():
            why = reaching.why
            work.restore(saved)
            return why
    for id in order:
        lost = put_back(work, before[id], taken, before)
        for rider in (p for p in taken if p.id in lost):
            if not place_anew(work, rider, carriers=(id,)):
                work.restore(saved)
                return f"{rider.id} could not go along with {id}"
    return ""


def _about(work: Work, id: str, pose: Placement) -> Iterator[Pose]:
    """The pose and the nearest free ones, as they are turned first."""
    asset = work.assets[pose.asset]
    yield pose.position, pose.yaw
    placed = placed_at(work.scene, asset, id=id, position=pose.position, yaw=pose.yaw)
    for near in nearest_poses(work.scene, asset, placed):
        yield near.position, near.yaw
