"""Orders on the distance between two things: so much, at least so much, or more of it than there is."""

from collections.abc import Iterator, Sequence
from functools import partial

from thinkblox.editing.acting import mark_names, reach_goals, say
from thinkblox.editing.company import with_company
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import Apart, Goal, Nearing, Related, Turned
from thinkblox.editing.grammar import means
from thinkblox.editing.moving import move
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.reaching import Reaching
from thinkblox.editing.rearranging import vacate
from thinkblox.editing.rows import MIDDLE_ROW
from thinkblox.editing.scattering import scatter
from thinkblox.editing.spots import Pose, at_wall, by_gap
from thinkblox.editing.work import Work
from thinkblox.editing.zones import PASSAGE, between
from thinkblox.errors import InputError
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene

STEPS = (0.1, 0.2, 0.3)
"""By how much a distance changes where nobody says it [m]."""
_LESS = ("narrower", "smaller", "shorter", "lower")


def space(work: Work, finder: Finder, order: Order) -> None:
    """Let two things stand so far apart; room between them is a way that somebody can go.

    Raises:
        InputError: it does not name two things, or a thing and a part of the room.
    """
    if several := _several(finder, order):
        scatter(work, several, by=None, slight=order.slight)
        finder.recent = list(several)
        return
    if rows := _rows(order):
        _space_rows(work, finder, order, rows)
        return
    one, other = _two(finder, order)
    if not order.lengths and not order.change:
        zone = between(work.scene, one, other)
        if zone.takers(work.scene):
            vacate(work, [zone])
            if one in work.before and other in work.before and _gap(work, one, other) >= PASSAGE:
                return
    if one not in work.scene:
        one, other = other, one
    gap = _gap(work, one, other)
    goals = [_goal(order, gap, other)]
    finder.recent = [id for id in (one, other) if id in work.scene]
    holds, says = goals[0].check(work.before, work.scene, one)
    if holds:
        work.done.append(f"it is so already ({says})")
        return
    why, said, saved = "", len(work.failed), work.saved()
    for id, mark in _movers(work, one, other):
        wanted = Apart((mark,), goals[0].away, goals[0].bound)
        with_company(work, finder, order, id, partial(_move_off, work, id, mark, wanted, gap))
        if len(work.failed) == said:
            return
        why = work.failed[-1]
        work.restore(saved)
        del work.failed[said:]
    why = why or f"{one} and {other} are to stay where they are"
    work.failed.append(f"{one} and {other} were left where they are, {gap:.2f} m apart: {why}")


def _move_off(work: Work, id: str, mark: str, goal: Apart, gap: float) -> None:
    """Move a thing to a distance from another; notes what became of it."""
    before = work.scene[id]
    failed = _moved_off(work, id, mark, goal, gap)
    if failed is None:
        say(work, id, before, None, [goal])
    else:
        work.failed.append(failed.why)


def _moved_off(work: Work, id: str, mark: str, goal: Apart, gap: float) -> Reaching | None:
    """Move a thing to a distance from another, as it is turned and at its wall where that can be; what was tried."""
    turned, behind = (
        Turned((work.scene[id].yaw,)),
        [
            Related("against_wall", (wall.name,))
            for wall in work.scene.room.walls
            if at_wall(work.scene, id) and measure(work.scene, "against_wall", id, (wall.name,)).holds
        ],
    )
    failed: Reaching | None = None
    for kept in ([turned, *behind], [turned], []):
        poses = _poses(work.scene, id, mark, goal, gap)
        failed = reach_goals(work, id, [goal, *kept], direct=poses)
        if failed is None:
            return None
    return failed


def _rows(order: Order) -> list[NounPhrase]:
    """The two rows between which the distance is; none where it is between other things."""
    nouns = [order.places[0].noun, order.places[0].second]
    rows = [NounPhrase(noun) for noun in nouns if noun is not None and noun.rows and noun.ordinal]
    return rows if len(rows) == len(nouns) else []


def _space_rows(work: Work, finder: Finder, order: Order, rows: Sequence[NounPhrase]) -> None:
    """Move the row that is further to the front forward as a whole, or the other one back; less is the other way."""
    ids = [finder.ids(row) for row in rows]
    gap = min(_gap(work, one, other) for one in ids[0] for other in ids[1])
    goal = _goal(order, gap, ids[1][0])
    by = goal.away - gap
    if goal.bound and (by <= 0.0) == (goal.bound == "ge"):
        work.done.append(f"it is so already ({gap:.2f} m between the two rows)")
        return
    saved, said = work.saved(), (len(work.done), len(work.failed))
    numbers = [row.noun.ordinal for row in rows]
    ahead = min((0, 1), key=lambda n: numbers[n] if numbers[n] > 0 else MIDDLE_ROW + 1)
    for row, way in ((rows[ahead], "forward"), (rows[1 - ahead], "back")):
        way = way if by > 0.0 else {"forward": "back", "back": "forward"}[way]
        step = Order("move", order.text, things=[row], direction=way, lengths=[(abs(by), "")])
        finder.scene = work.scene
        move(work, finder, step)
        if len(work.failed) == said[1]:
            return
        why = work.failed[said[1]]
        work.restore(saved)
        del work.done[said[0] :], work.failed[said[1] :]
    work.failed.append(f"the two rows were left {gap:.2f} m apart: {why}")


def _several(finder: Finder, order: Order) -> tuple[str, ...]:
    """The things that are to be further apart, where they are more than two: "more space between the tables"."""
    where = order.places[0]
    if where.second is not None or where.noun is None or order.lengths or order.change.removesuffix("=") in _LESS:
        return ()
    found = finder.ids(NounPhrase(where.noun)) if where.noun.kind == "thing" and where.noun.many else ()
    return found if len(found) > 2 else ()


def _gap(work: Work, one: str, other: str) -> float:
    return Nearing((other,), nearer=False).of(work.scene, one)


def _goal(order: Order, gap: float, other: str) -> Apart:
    less = order.change.removesuffix("=") in _LESS
    if not order.lengths:
        if not order.change:
            return Apart((other,), PASSAGE, "ge")
        return Apart((other,), max(0.0, gap - STEPS[0]), "le") if less else Apart((other,), gap + STEPS[0], "ge")
    length = order.lengths[0][0]
    if order.by:
        return Apart((other,), max(0.0, gap + (-length if less else length)))
    if not order.bound and any(means("ways", word) for word in order.text.lower().split()[:3]):
        return Apart((other,), length, "ge")
    return Apart((other,), length, order.bound)


def _poses(scene: Scene, id: str, mark: str, goal: Goal, gap: float) -> Iterator[Pose]:
    wanted = goal.away if isinstance(goal, Apart) else gap
    for more in (0.0, *STEPS) if isinstance(goal, Apart) and goal.bound == "ge" else (0.0,):
        yield from by_gap(scene, scene[id], (mark,), (wanted + more - gap,))


def _two(finder: Finder, order: Order) -> tuple[str, str]:
    """The two between which the distance is."""
    where = order.places[0]
    names: list[str] = []
    for noun in (where.noun, where.second):
        if noun is not None:
            names += mark_names(finder, NounPhrase(noun, id=noun.id))
    names = list(dict.fromkeys(names))
    if len(names) != 2 or not any(name in finder.scene for name in names):
        raise InputError(
            f"'{order.text}' must name two things, or a thing and a part of the room; it names {', '.join(names)}"
        )
    return (names[0], names[1]) if names[0] in finder.scene else (names[1], names[0])


def _movers(work: Work, one: str, other: str) -> Sequence[tuple[str, str]]:
    """Which of the two is moved from the other, the smaller first."""
    scene = work.scene
    pairs = [(a, b) for a, b in ((one, other), (other, one)) if a in scene and a not in work.kept]
    return sorted(pairs, key=lambda pair: scene[pair[0]].size[0] * scene[pair[0]].size[1])
