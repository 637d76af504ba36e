"""What orders on things that are there have in common: goals of their words, and what became of each."""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import tee

from thinkblox.assets import facts_of
from thinkblox.brief import RelationKind
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import (
    Across,
    AcrossEnd,
    Amid,
    AtHead,
    BackTo,
    BySmall,
    DrawnUp,
    Goal,
    IntoRoom,
    Laid,
    Level,
    MidOf,
    MidWall,
    Midway,
    OnPart,
    OnWall,
    Related,
    ToWall,
)
from thinkblox.editing.orders import NounPhrase
from thinkblox.editing.reaching import Reaching, ties_of, without
from thinkblox.editing.spots import Pose, likely
from thinkblox.editing.telling import named
from thinkblox.editing.wheres import Bound, bound, opening_named
from thinkblox.editing.work import Saved, Work
from thinkblox.errors import InputError
from thinkblox.plan import Tie, is_object
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.landmarks import things, walls
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.room import turn_between
from thinkblox.scene.scene import Scene


def _closely(there: Bound) -> Goal | None:
    """The goal of a place that is held more closely than prompts hold it; None of any other."""
    if there.kind == "between" and len(there.anchors) == 2 and not there.negated:
        return Amid("between", there.anchors)
    if there.kind == "opposite" and len(there.anchors) == 1 and not there.negated and is_object(there.anchors[0]):
        return Across("opposite", there.anchors)
    if there.kind in _ENDS and len(there.anchors) == 1 and is_object(there.anchors[0]) and not there.negated:
        return AcrossEnd(there.kind, there.anchors)
    close = there.upon and there.kind in ("next_to", *_SIDES)
    return BySmall(there.kind, there.anchors) if close else None


def related(there: Bound, category: str, index: int = 0, count: int = 1) -> Goal:
    """A relation as a goal; of several around a thing each is by it, and seats are drawn up to it."""
    if there.of_room:
        return IntoRoom()
    if there.part:
        return OnPart("on", there.anchors, part=there.part, end=there.end)
    if there.kind == "on" and there.anchors and all(name.endswith("_wall") for name in there.anchors):
        return OnWall("on", there.anchors, there.negated)
    if there.seat:
        return Laid("on", there.anchors, seat=there.seat)
    if there.head:
        return AtHead("next_to", there.anchors)
    if there.middle:
        return MidWall("against_wall", there.anchors)
    if there.side is not None:
        return DrawnUp("at", there.anchors, side=there.side)
    if (closely := _closely(there)) is not None:
        return closely
    measured: RelationKind | None = None
    if there.kind == "around":
        measured = "at" if facts_of(category).is_in("seating") else "near"
    return Related(there.kind, there.anchors, there.negated, index, count, measured)


_SIDES: tuple[RelationKind, ...] = ("left_of", "right_of")
_ENDS: tuple[RelationKind, ...] = ("in_front_of", "behind")
_ABOUT = ("under", "on")


def centred(scene: Scene, there: Bound) -> tuple[Bound, list[Goal]]:
    """A place with what being at the middle of it asks besides: the middle of a wall, or of the side of a thing."""
    if there.kind == "against_wall" or (there.kind == "on" and there.anchors[:1] and there.anchors[0].endswith("wall")):
        return replace(there, kind="against_wall", middle=True), []
    if there.kind == "between" and len(there.anchors) == 2 and not there.negated:
        return there, [Midway("between", there.anchors)]
    single = len(there.anchors) == 1 and len(things(scene, there.anchors[0])) == 1
    if not single or there.of_room or there.negated or there.kind == "in_centre":
        return there, []
    anchor = there.anchors[0]
    hung = anchor in scene and scene.asset_of(scene[anchor]).mount == "wall"
    if there.kind in _ABOUT and not hung:
        return there, [MidOf(anchor), MidOf(anchor, across=True)]
    there = replace(there, kind="in_front_of") if hung and there.kind == "on" else there
    return there, [MidOf(anchor, across=there.kind in _SIDES)]


def _sideways(scene: Scene, goals: Sequence[Goal]) -> list[list[Goal]]:
    """The same goals with what is to be beside a thing at its left and at its right, where that has sides."""
    beside = [goal for goal in goals if type(goal) is Related and goal.kind == "next_to" and not goal.negated]
    if len(beside) != 1 or len(beside[0].anchors) != 1 or beside[0].anchors[0] not in scene:
        return []
    anchor = scene[beside[0].anchors[0]]
    if scene.asset_of(anchor).front != "one" or anchor.support != "floor":
        return []
    return [[*goals, Related(kind, (anchor.id,))] for kind in _SIDES]


def _stands_before(scene: Scene, id: str, goals: Sequence[Goal]) -> bool:
    """Whether something that is to be beside a thing stands before or behind it."""
    at = [goal.anchors[0] for goal in goals if type(goal) is Related and goal.kind == "next_to" and goal.anchors]
    return any(measure(scene, kind, id, (name,)).holds for name in at if name in scene for kind in _ENDS)


def prefer_sides(
    work: Work, id: str, goals: Sequence[Goal], saved: Saved, reach: Callable[[Sequence[Goal]], bool]
) -> None:
    """Let what came beside a thing, and stands before or behind it, stand at its left or right where it can.

    Args:
        work: the edit.
        id: of what came there.
        goals: what it met.
        saved: the work before that.
        reach: brings it to other goals; whether it could.
    """
    if not _stands_before(work.scene, id, goals):
        return
    first = work.world
    work.restore(saved)
    if not any(reach(other) for other in _sideways(work.scene, goals)):
        work.world = first
        beside = [g.anchors[0] for g in goals if isinstance(g, Related) and g.kind == "next_to" and g.anchors]
        work.notes += [f"{id} stands before or behind {name}, at whose sides there is no room." for name in beside[:1]]


def mark_names(finder: Finder, phrase: NounPhrase) -> tuple[str, ...]:
    """What distances are measured to: ids, or a part of the room."""
    noun = phrase.noun
    told = next((w.noun for w in phrase.places if w.word == "with"), None)
    if noun.kind == "place" and noun.value == "wall" and told is not None:
        wall = replace(noun, text="the wall with")
        return bound(Where("against", wall, whole=told, text="against"), "", finder).anchors
    if noun.kind == "place":
        if not things(finder.scene, noun.value.split()[0]):
            raise InputError(f"the room has no {noun.value.replace('_', ' ')}")
        return (opening_named(finder.scene, noun),)
    if noun.kind == "part" and noun.value == "middle":
        return ("centre",)
    return named(finder, phrase, phrase.places)


def looking(finder: Finder, noun: Noun) -> Goal:
    """What something is to face, as a goal."""
    if noun.kind == "room":
        return IntoRoom()
    if noun.kind == "people":
        return Related("facing", bound(Where("facing", noun, text="facing"), "", finder).anchors)
    if noun.kind == "part" and noun.value == "middle":
        return Related("facing", ("centre",))
    if noun.kind == "place" and "wall" in noun.value and finder.about in finder.scene:
        return ToWall(_wall_meant(finder, noun))
    if noun.kind == "place" and noun.degree and finder.about in finder.scene:
        return Related("facing", bound(Where("near", noun, text="near"), "", finder).anchors)
    return Related("facing", mark_names(finder, NounPhrase(noun)))


def level(finder: Finder, noun: Noun, text: str) -> Goal:
    """As high up as something that hangs, as a goal.

    Raises:
        InputError: that could be several, or hangs nowhere.
    """
    ids = finder.ids(NounPhrase(noun, id=noun.id))
    if len(ids) != 1 or finder.scene.asset_of(finder.scene[ids[0]]).mount != "wall":
        raise InputError(f"'{text}': as high as what? {', '.join(ids)} is not one thing that hangs on a wall")
    return Level(ids[0])


def backing(finder: Finder, noun: Noun) -> Goal:
    """What something is to have its back to, as a goal."""
    if noun.kind == "place" and "wall" in noun.value and finder.about in finder.scene:
        return BackTo((_wall_meant(finder, noun),))
    return BackTo(mark_names(finder, NounPhrase(noun)))


def _wall_meant(finder: Finder, noun: Noun) -> str:
    """The wall that a thing is to look at: the nearest, where it is not said which."""
    scene, spot = finder.scene, finder.scene[finder.about].position[:2]
    found = [wall.name for name in bound(Where("against", noun, text="against"), "", finder).anchors
             for wall in walls(scene.room, name)]  # fmt: skip
    return min(found, key=lambda name: abs(scene.room.wall(name).coordinates(spot)[1]))


def reach_goals(
    work: Work,
    id: str,
    goals: Sequence[Goal],
    *,
    direct: Iterator[Pose],
    ask: bool = False,
    search: bool = True,
    ties: Sequence[Tie] | None = None,
    begin: Pose | None = None,
) -> Reaching | None:
    """Bring an object to its goals; returns None when that is done, or what was tried."""
    if more := work.standing(id, goals):
        direct, again = tee(direct)
        wanted = [*goals, *more]
        if _reaching(work, id, wanted, ties_of(wanted) if ties is None else ties, again, ask, search, begin).run():
            return None
    reaching = _reaching(work, id, goals, ties_of(goals) if ties is None else ties, direct, ask, search, begin)
    return None if reaching.run() else reaching


def _reaching(
    work: Work,
    id: str,
    goals: Sequence[Goal],
    told: Sequence[Tie],
    direct: Iterator[Pose],
    ask: bool,
    search: bool,
    begin: Pose | None,
) -> Reaching:
    target = work.target(id, work.scene[id].category, told, work.asset_of(id).attributes)
    return Reaching(
        work,
        target,
        work.asset_of(id),
        goals,
        direct=direct,
        ask=ask and bool(told),
        search=search,
        begin=begin,
        more=likely(_without(work, id), work.asset_of(id), goals),
    )


def _without(work: Work, id: str) -> Scene:
    """The room without an object and what rests on it."""
    return without(work.scene, [id, *(rider.id for rider in work.scene.riders(id))])


def say(work: Work, id: str, before: Placement, failed: Reaching | None, goals: Sequence[Goal]) -> None:
    """Note what became of one object."""
    if failed is not None:
        work.failed.append(f"{id} was left where it is: {bears_nothing(work, goals) or failed.why}")
        return
    work.wish(id, goals)
    text = "; ".join(dict.fromkeys(findings(work, goals, id)))
    work.done.append(f"{moved_words(before, work.scene[id])}{f' ({text})' if text else ''}")


def bears_nothing(work: Work, goals: Sequence[Goal]) -> str:
    """What something is to be put on that carries nothing; empty where there is no such thing."""
    on = [goal for goal in goals if isinstance(goal, Related) and goal.kind == "on" and not goal.negated]
    names = [name for goal in on for name in goal.anchors if name in work.scene and not work.asset_of(name).surfaces]
    bare = [name for name in names if not facts_of(work.scene[name].category).is_in("covers")]
    return f"{bare[0]} has no flat top that could carry anything" if bare else ""


def findings(work: Work, goals: Sequence[Goal], id: str) -> Iterator[str]:
    """What is measured of each goal."""
    for goal in goals:
        yield goal.check(work.before, work.scene, id)[1]


def moved_words(before: Placement, after: Placement) -> str:
    """How something has moved and turned, in words."""
    away = math.dist(before.position, after.position)
    turn = turn_between(before.yaw, after.yaw)
    x, y, z = after.position
    parts = [f"moved {away:.2f} m to ({x:.2f}, {y:.2f}{f', {z:.2f}' if z > 0.02 else ''})"] if away >= 0.005 else []
    parts += [f"turned by {turn:.0f} degrees to yaw {after.yaw:g}"] if turn > 0.5 else []
    return f"{after.id} {' and '.join(parts) or 'stays where it is'}"
