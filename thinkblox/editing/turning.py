"""Orders that turn things: by an angle, until they face something, or to each other."""

import dataclasses
import math
from collections.abc import Iterator, Sequence
from itertools import chain

from msgspec import structs
from shapely import LineString

from thinkblox.assets import facts_of
from thinkblox.editing.acting import backing, findings, looking, mark_names, moved_words, reach_goals, related, say
from thinkblox.editing.company import gathered, with_company
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import EXACT, STRAIGHT, At, BackTo, Goal, Related, SeatRoom, Straight, Turned
from thinkblox.editing.grammar import means
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.reaching import without
from thinkblox.editing.remarks import LEGS, legroom
from thinkblox.editing.spots import Pose, at_wall, free, near_offsets
from thinkblox.editing.telling import named, spare
from thinkblox.editing.wheres import bound
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.bearings import bearing
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.room import turn_between
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2

TURNED = 1.5
"""How far something may be moved that is turned, besides half the difference of its sides [m]."""
PULLED = (0.45, 0.6, 0.75, 0.9, 1.05, 1.2)
"""How far something is pulled out from its wall where what turns with it has no room [m]."""
STEPPED = 0.35
"""How far something may be moved so that it looks straight at a thing, rather than only about [m]."""
SHIFTED = 0.1
"""How far it may be moved without saying so [m]."""
ABOUT = 15.0
"""How far past a thing something may look that is to face it and does so already [degrees]."""
FAR = 50.0
"""Further than anything in a room [m]."""
SLIGHT_TURN = 15.0
"""How far something is turned that is turned a bit [degrees]."""


def turn(work: Work, finder: Finder, order: Order) -> None:
    """Turn things by an angle, or until they face something."""
    seen: set[str] = set()
    order = _with_seats(gathered(work, finder, order))
    aimed = _is_aimed(order)
    for ids, places in _turned(work, finder, order):
        order = _to_one_opening(work, order, ids)
        ids = tuple(id for id in ids if not (order.company and facts_of(work.scene[id].category).is_in("seating")))
        for id in (i for i in ids if i not in seen):
            seen.add(id)
            placement = work.scene[id]
            finder.scene, finder.about = work.scene, id
            looks = [looking(finder, noun) for noun in order.facing]
            looks += [backing(finder, noun) for noun in order.backs]
            looks += [_look(finder, w, placement.category) for w in places]
            if looks and (order.turn is not None or order.slight) and (sense := _way_to(work, id, looks)):
                by = dataclasses.replace(order, sense=sense, direction="", facing=[])
                with_company(work, finder, order, id, lambda id=id, by=by: turn_by(work, id, by))  # type: ignore[misc]
                continue
            if looks and order.turn is not None and (sense := _sense_met(work, id, order.turn, looks)):
                by = dataclasses.replace(order, sense=sense, direction="", facing=[], backs=[])
                with_company(work, finder, order, id, lambda id=id, by=by: turn_by(work, id, by))  # type: ignore[misc]
                continue
            if looks and order.turn is not None:
                raise InputError(f"'{order.text}' says both how far and what to face; say one of them")
            if order.backs and work.asset_of(id).gaze == "back":
                looks.append(SeatRoom())
            if looks:
                with_company(work, finder, order, id, lambda id=id, looks=looks: _turn_to(work, id, looks, aimed=aimed))  # type: ignore[misc]
            elif order.mutual != "facing":
                _with_room(work, finder, order, id)
        finder.recent = list(ids)
    if order.mutual == "facing":
        face_each_other(work, finder, order)


def _to_one_opening(work: Work, order: Order, ids: Sequence[str]) -> Order:
    """The order, where several things that face "the window" all face the one that is nearest to all of them."""
    kinds = ("window", "door")
    if len(ids) < 2 or not any(
        noun.kind == "place" and noun.value in kinds and not noun.degree for noun in order.facing
    ):
        return order
    here = [work.scene[id].position[:2] for id in ids]

    def one(noun: Noun) -> Noun:
        found = [o.id for o in work.scene.room.openings if o.kind == noun.value]
        if noun.kind != "place" or len(found) < 2 or noun.each or noun.plural:
            return noun
        marks = {id: things(work.scene, id)[0].centre for id in found}
        nearest = min(found, key=lambda id: sum(math.dist(marks[id], spot) for spot in here))
        return dataclasses.replace(noun, value=nearest)

    return dataclasses.replace(order, facing=[one(noun) for noun in order.facing])


def _with_room(work: Work, finder: Finder, order: Order, id: str) -> None:
    """Turn a thing with what goes along; it is pulled out from its wall where its seats need the room behind it."""
    before, saved, said = work.scene[id], work.saved(), (len(work.failed), len(work.notes))
    with_company(work, finder, order, id, lambda: turn_by(work, id, order))
    if len(work.failed) == said[0] or not (order.company and at_wall(work.scene, id)):
        return
    first, notes = work.failed[said[0] :], work.notes[said[1] :]
    walls = [w for w in work.scene.room.walls if measure(work.scene, "against_wall", id, (w.name,)).holds]
    for step in PULLED:
        work.restore(saved)
        del work.failed[said[0] :], work.notes[said[1] :]
        x, y = walls[0].inward if walls else before.front
        there = (before.position[0] + step * x, before.position[1] + step * y)
        with_company(work, finder, order, id, lambda spot=there: turn_by(work, id, order, spot=spot))  # type: ignore[misc]
        if len(work.failed) == said[0]:
            return
    work.restore(saved)
    work.failed[said[0] :], work.notes[said[1] :] = first, notes


def _with_seats(order: Order) -> Order:
    """An order on rows as such, in which the seats of each desk or table turn with it."""
    if order.company or not any(phrase.noun.rows and phrase.noun.kind == "number" for phrase in order.things):
        return order
    seats = Noun("thing", "seat", 0, 0, "its seats", det="my", plural=True)
    return dataclasses.replace(order, company=[NounPhrase(seats)])


def _way_to(work: Work, id: str, looks: Sequence[Goal]) -> int:
    """Which way round a thing comes to look at another: 1 counter-clockwise, -1 clockwise, 0 where none is known."""
    names = [name for goal in looks if isinstance(goal, Related) and goal.kind == "facing" for name in goal.anchors]
    marks = [mark for name in names for mark in things(work.scene, name)]
    if len(looks) != 1 or not marks:
        return 0
    here = things(work.scene, id)[0]
    off = (bearing(work.scene[id].position[:2], marks[0].centre) - here.gaze + 180.0) % 360.0 - 180.0
    return 1 if off > 0 else -1


def _sense_met(work: Work, id: str, angle: float, looks: Sequence[Goal]) -> int:
    """Which way round a thing has to be turned by an angle to look as it is to; 0 where neither will do."""
    scene, old = work.scene, work.scene[id]
    for sense in (1, -1):
        turned = structs.replace(old, yaw=(old.yaw + sense * angle) % 360.0)
        after = scene.without(id).with_placement(turned, scene.asset_of(old)) if not scene.riders(id) else scene
        if id in after and after[id] != old and all(goal.check(scene, after, id)[0] for goal in looks):
            return sense
    return 0


def _look(finder: Finder, where: Where, category: str) -> Goal:
    """What a place says of what a thing is to face."""
    if where.word == "facing" and where.noun is not None and where.noun.kind == "place" and not where.negated:
        return looking(finder, where.noun)
    return related(bound(where, category, finder), category)


def face_each_other(work: Work, finder: Finder, order: Order) -> None:
    """Turn two things to each other.

    Raises:
        InputError: they are not two.
    """
    ids = finder.recent if len(order.things) < 2 else [i for p in order.things for i in named(finder, p, ())]
    ids = list(dict.fromkeys(ids))
    if len(ids) != 2:
        raise InputError(f"'{order.text}': two things can face each other; it names {', '.join(ids) or 'none'}")
    for id, other in ((ids[0], ids[1]), (ids[1], ids[0])):
        _turn_to(work, id, [Related("facing", (other,))])
    sight = LineString([work.scene[id].position[:2] for id in ids])
    for name in (name for noun in order.across for name in mark_names(finder, NounPhrase(noun, id=noun.id))):
        if not any(sight.intersects(mark.footprint) for mark in things(work.scene, name)):
            work.failed.append(f"{name} is not between {ids[0]} and {ids[1]}, which were turned to each other")
    finder.recent = ids


def _turned(work: Work, finder: Finder, order: Order) -> Iterator[tuple[tuple[str, ...], list[Where]]]:
    if order.rest and not order.things:
        everything = [p.id for p in work.scene.placements if p.support == "floor" and work.scene.asset_of(p).collides]
        yield work.touched(spare(finder, everything, order.spared)), []
        return
    if not order.things:
        raise InputError(f"'{order.text}' does not say what; there {finder.listed()}")
    for number, phrase in enumerate(order.things):
        later = next((p.places for p in order.things[number:] if p.places), ())
        looks = [w for w in (phrase.places or later) if w.word in ("facing", "opposite")]
        said = [w for w in phrase.places if w not in looks]
        yield work.touched(named(finder, phrase, said)), looks


def turn_by(work: Work, id: str, order: Order, *, spot: Vec2 | None = None) -> None:
    """Turn one object by the angle of an order, or a quarter turn the way that it says; at a spot, if one is given."""
    before = work.scene[id]
    angle, sense = order.turn, order.sense
    if order.direction in ("left", "right"):
        angle, sense = angle or (SLIGHT_TURN if order.slight else 90.0), 1 if order.direction == "left" else -1
    if order.direction in ("back", "forward"):
        angle = angle or 180.0
    if angle is None and (sense or order.slight):
        angle = SLIGHT_TURN if order.slight else 90.0
    if angle is None:
        raise InputError(f"'{order.text}' does not say how far, or what it is to face; say 'by 90 degrees'")
    senses = (1, -1) if not sense else (sense,)
    yaws = tuple(dict.fromkeys(round((before.yaw + s * angle) % 360.0, 4) % 360.0 for s in senses))
    reach = TURNED + abs(before.size[0] - before.size[1]) / 2
    goal = Turned(yaws)
    position = (*spot, before.position[2]) if spot is not None else before.position
    poses = iter([(position, yaw) for yaw in yaws])
    there = At(position[:2], reach if spot is None else EXACT)
    failed = reach_goals(work, id, [goal, there], direct=poses, begin=(position, yaws[0]), search=spot is None)
    say(work, id, before, failed, [goal])
    _say_moved(work, before)


def _is_aimed(order: Order) -> bool:
    """Whether a verb or word says that a thing is to look straight at something: "angle the armchair towards it"."""
    return any(means("aiming", word) for word in order.text.lower().split())


def _turn_to(work: Work, id: str, goals: Sequence[Goal], *, aimed: bool = False) -> None:
    """Turn one object to what it is to face: straight to it where that is said, or where it is so only about."""
    before = work.scene[id]
    so = all(goal.check(work.before, work.scene, id)[0] for goal in goals)
    about = so and not all(
        _is_before_it(work.scene, id, goal) or goal.check(work.before, work.scene, id)[0]
        for goal in _straight(goals, ABOUT)
    )
    straight = _straight(goals, STRAIGHT)
    held = so and all(goal.check(work.before, work.scene, id)[0] for goal in straight)
    if straight != list(goals) and (aimed or about) and not held:
        there = At(before.position[:2], TURNED + abs(before.size[0] - before.size[1]) / 2)
        begun = chain(turns(work.scene, before, straight), _aimed_about(work, id, straight))
        failed = reach_goals(work, id, [*straight, there], direct=begun)
        if failed is None or not so:
            say(work, id, before, failed, straight)
            _say_moved(work, before)
            return
        work.notes.append(
            f"{id} was not turned straight to {', '.join(straight[0].tie.anchors if straight[0].tie else ())}"
        )
    if so:
        work.done.append(f"{id} stays: it is so already ({'; '.join(findings(work, goals, id))})")
        work.wish(id, goals)
        return
    there = At(before.position[:2], TURNED + abs(before.size[0] - before.size[1]) / 2)
    poses = list(turns(work.scene, before, goals))
    right = [pose for pose in poses if _looks_right(work, id, pose, goals)]
    near = (
        pose
        for pose in _aimed_about(work, id, _straight(goals, ABOUT))
        if math.dist(pose[0], before.position) <= STEPPED
    )
    begun = chain(right, near, poses)
    if any(isinstance(goal, SeatRoom) for goal in goals):
        poses += list(free(without(work.scene, [id]), work.asset_of(id), _pulled_out(work.scene, before, poses)))
        begun = chain(poses)
    failed = reach_goals(work, id, [*goals, there], direct=begun)
    say(work, id, before, failed, goals)
    make_legroom(work, before, [*goals, there])
    _say_moved(work, before)
    now = work.scene[id]
    if failed is None and not _looks_right(work, id, (now.position, now.yaw), goals):
        marks = [name for goal in goals if isinstance(goal, Related) for name in goal.anchors]
        work.notes.append(f"{id} was not turned straight to {', '.join(marks)}")


def make_legroom(work: Work, before: Placement, goals: Sequence[Goal]) -> None:
    """Let a seat that has come to look right at a wall, and did not before, stand off that where it can."""
    id, scene = before.id, work.scene
    seat = facts_of(before.category).is_in("seating") and not any(isinstance(goal, SeatRoom) for goal in goals)
    if not seat or legroom(scene, id) >= LEGS or legroom(work.start, id) < LEGS:
        return
    saved, now = work.saved(), scene[id]
    bare = without(scene, [id, *(rider.id for rider in scene.riders(id))])
    pulled = free(bare, work.asset_of(id), _pulled_out(scene, now, [(now.position, now.yaw)]))
    if reach_goals(work, id, [*goals, SeatRoom()], direct=pulled) is None:
        work.done.append(f"{moved_words(now, work.scene[id])}, so that somebody can sit down on it")
    else:
        work.restore(saved)


def straighten(work: Work, id: str, goals: Sequence[Goal]) -> None:
    """Turn what has come to where its goals are met straight to what it only about faces, where that can be."""
    before = work.scene[id]
    so = all(goal.check(work.before, work.scene, id)[0] for goal in goals)
    about = [goal for goal in _straight(goals, ABOUT) if isinstance(goal, Straight)]
    if not so or not about or all(goal.check(work.before, work.scene, id)[0] for goal in about):
        return
    straight = _straight(goals, STRAIGHT)
    there = At(before.position[:2], TURNED)
    if reach_goals(work, id, [*straight, there], direct=turns(work.scene, before, straight), search=False) is None:
        work.done.append(f"{id} turned straight to {', '.join(about[0].anchors)}")
    else:
        work.notes.append(f"{id} was not turned straight to {', '.join(about[0].anchors)}")


def _looks_right(work: Work, id: str, pose: Pose, goals: Sequence[Goal]) -> bool:
    """Whether a thing that is turned so looks right at what it is to face, or straight within ABOUT degrees."""
    bare = without(work.scene, [id, *(rider.id for rider in work.scene.riders(id))])
    turned = bare.with_placement(structs.replace(work.scene[id], yaw=pose[1]), work.asset_of(id))
    straight = [goal for goal in _straight(goals, ABOUT) if isinstance(goal, Straight)]
    return all(_is_before_it(turned, id, goal) or goal.check(work.scene, turned, id)[0] for goal in straight)


def _is_before_it(scene: Scene, id: str, goal: Goal) -> bool:
    """Whether a thing looks right at another, wherever on it: a desk below a wide window does."""
    if not isinstance(goal, Straight):
        return False
    mark = things(scene, id)[0]
    (x, y), way = mark.centre, math.radians(mark.gaze)
    sight = LineString([(x, y), (x + FAR * math.cos(way), y + FAR * math.sin(way))])
    return any(sight.intersects(m.footprint) for name in goal.anchors for m in things(scene, name))


def _pulled_out(scene: Scene, before: Placement, poses: Sequence[Pose]) -> list[Pose]:
    """The same turns further out from the wall that a thing is nearest to, as somebody is to sit between."""
    wall = min(scene.room.walls, key=lambda wall: wall.coordinates(before.position[:2])[1])
    (x, y, z), (dx, dy) = before.position, wall.inward
    return [((round(x + s * dx, 4), round(y + s * dy, 4), z), yaw) for s in PULLED for _, yaw in poses]


def _straight(goals: Sequence[Goal], within: float) -> list[Goal]:
    """The goals with what is to be looked at straight, within so many degrees."""
    return [
        Straight(g.kind, g.anchors, within=within) if type(g) is Related and g.kind == "facing" and not g.negated else g
        for g in goals
    ]


def _aimed_about(work: Work, id: str, goals: Sequence[Goal]) -> Iterator[Pose]:
    """Free places about where a thing stands, the nearest first, from each of which it looks straight at its mark."""
    before, asset = work.scene[id], work.asset_of(id)
    away = 180.0 if asset.gaze == "back" else 0.0
    marks = [m for goal in goals if isinstance(goal, Straight) for n in goal.anchors for m in things(work.scene, n)]
    if not marks or asset.mount != "floor":
        return
    x, y, z = before.position
    mark = min(marks, key=lambda m: math.dist(m.centre, (x, y)))
    poses: list[Pose] = []
    for dx, dy in near_offsets(TURNED):
        spot = (round(x + dx, 4), round(y + dy, 4))
        poses.append(((*spot, z), round((bearing(spot, mark.centre) + away) % 360.0, 1) % 360.0))
    yield from free(without(work.scene, [id, *(rider.id for rider in work.scene.riders(id))]), asset, poses)


def _say_moved(work: Work, before: Placement) -> None:
    """Note that a thing that was only to be turned has been moved for that."""
    away = math.dist(before.position, work.scene[before.id].position)
    if away > SHIFTED:
        work.notes.append(f"{before.id} was moved {away:.2f} m, as it cannot be turned where it stood.")


def turns(scene: Scene, before: Placement, goals: Sequence[Goal]) -> Iterator[Pose]:
    """The place as it is with every yaw that may do: square to the walls first, then straight at what it faces."""
    square = sorted((wall.yaw for wall in scene.room.walls), key=lambda yaw: turn_between(yaw, before.yaw))
    away = 180.0 if scene.asset_of(before).gaze == "back" else 0.0
    away += 180.0 if any(isinstance(goal, BackTo) for goal in goals) else 0.0
    names = [n for goal in goals for n in (goal.anchors if isinstance(goal, Related | BackTo) else ("centre",))]
    marks = [mark for name in names for mark in things(scene, name)]
    straight = [round((bearing(before.position[:2], mark.centre) + away) % 360.0, 1) % 360.0 for mark in marks]
    for yaw in dict.fromkeys([*square, *straight]):
        yield before.position, yaw
