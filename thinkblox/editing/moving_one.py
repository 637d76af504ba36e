"""One thing moved to where its goals are met, or as near to that as can be."""

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain

from thinkblox.assets import facts_of
from thinkblox.editing.acting import (
    findings,
    prefer_sides,
    reach_goals,
    say,
)
from thinkblox.editing.beside_at_wall import beside_at_wall
from thinkblox.editing.carrying import usual_carriers
from thinkblox.editing.goals import (
    Apart,
    At,
    Goal,
    Level,
    Midway,
    Nearing,
    OnSide,
    Raised,
    Related,
)
from thinkblox.editing.into_corners import into_corner
from thinkblox.editing.lengthwise import beside_wall
from thinkblox.editing.moving_poses import (
    along_wall_to,
    by_so_much,
    half_poses,
    in_line,
    midway,
    moved_aside,
    onto_line,
    so_far_off,
    spots_for,
)
from thinkblox.editing.off_floor import lifted
from thinkblox.editing.orders import Order
from thinkblox.editing.parting import with_room_between
from thinkblox.editing.reaching import Reaching, without
from thinkblox.editing.spots import (
    Pose,
    levelled,
    likely,
    middle_off,
)
from thinkblox.editing.stepping import by_step
from thinkblox.editing.taking_place import THERE, at_spot, is_there
from thinkblox.editing.turning import make_legroom, straighten, turn_by
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.scene import Scene

OTHER_CORNER = 1.5
"""How far from where it was something stands at least that goes to another corner [m]."""
LEFT = 0.3
"""How far from where it was something stands at least that is said to leave a part of the room [m]."""
MIDDLE = 0.3
"""How far from the middle that is asked for something may stand that is left where it is [m]."""
TOUCHING = 0.005
"""A gap that cannot be made smaller [m]."""


def seats_among(work: Work, ids: Iterable[str]) -> set[str]:
    """Those of the objects that somebody sits on."""
    return {id for id in ids if facts_of(work.scene[id].category).is_in("seating")}


def move_and_turn(work: Work, order: Order, id: str, goals: Sequence[Goal]) -> None:
    """Move one thing, and turn it where the same order says by how much."""
    if goals or order.direction:
        move_one(work, order, id, goals)
    if order.facing and order.turn is None and id in work.scene:
        straighten(work, id, goals)
        make_legroom(work, work.scene[id], goals)
    if order.turn is not None:
        turn_by(work, id, order)


def move_one(work: Work, order: Order, id: str, goals: Sequence[Goal]) -> None:
    """Move one object to where it meets the goals, and the order's direction; notes what became of it."""
    before = work.scene[id]
    if not order.direction and into_corner(work, id, goals):
        return
    if goals and not order.direction and all(_is_so(work, goal, id) for goal in goals):
        work.done.append(f"{id} stays: it is so already ({'; '.join(findings(work, goals, id))})")
        work.wish(id, goals)
        return
    if order.direction in ("up", "down") and work.asset_of(id).free and not (goals or order.lengths):
        _to_other_height(work, order, id)
        return
    gap = next((goal for goal in goals if isinstance(goal, Nearing)), None)
    if gap is not None and gap.nearer and gap.by is None and gap.of(work.scene, id) < TOUCHING:
        work.done.append(f"{id} stays: it is at {', '.join(gap.anchors)} already")
        return
    if gap is not None:
        direct: Iterator[Pose] = chain(along_wall_to(work, id, gap), by_so_much(work.scene, before, gap))
        done = reach_goals(work, id, goals, direct=direct, ask=True)
    elif order.direction and not order.closer:
        direct, more = by_step(work, order, before)
        goals = [*goals, *more]
        done = reach_goals(work, id, goals, direct=direct, ask=False, search=not order.lengths)
    else:
        done, goals = _to_place(work, order, id, goals)
    if done is None or not _with_its_worktop(work, id, goals):
        say(work, id, before, done, goals)


def _to_place(work: Work, order: Order, id: str, goals: Sequence[Goal]) -> tuple[Reaching | None, Sequence[Goal]]:
    """Move one object to a place that is said; what was tried where that failed, and the goals that were met."""

    def reach(other: Sequence[Goal]) -> bool:
        return reach_goals(work, id, other, direct=spots_for(work, id, other)) is None

    if (upon := lifted(work, id, goals, reach)) is not None:
        return None, upon
    if (walled := beside_at_wall(work, id, goals)) is not None:
        return None, walled
    before = work.scene[id]
    direct: Iterator[Pose] = chain(
        at_spot(work, id, goals),
        midway(work.scene, before, goals),
        onto_line(work.scene, before, goals),
        beside_wall(work.scene, work.asset_of(id), before, goals),
        in_line(work.scene, before, goals),
        so_far_off(work.scene, before, goals),
        spots_for(work, id, goals),
    )
    if any(isinstance(goal, Related) and goal.kind == "against_wall" and goal.count > 1 for goal in goals):
        direct = chain(direct, likely(without(work.scene, [id]), work.asset_of(id), goals))
    if any(isinstance(goal, Apart) for goal in goals):
        direct = chain(moved_aside(work.scene, before, goals), direct)
    here = [(before.position, before.yaw)]
    direct = levelled(work.scene, work.asset_of(id), goals, chain(here if _is_level(goals) else (), direct))
    done = _reach_beside(work, id, goals, direct)
    if done is not None and (half := _in_half(order, goals)):
        goals = half
        done = reach_goals(work, id, goals, direct=half_poses(work, id, half), ask=False)
    if done is not None and _with_others(work, id, goals):
        done = None
    return done, goals


def _is_level(goals: Sequence[Goal]) -> bool:
    """Whether how high up something is to be is all that is asked."""
    return bool(goals) and all(isinstance(goal, Level) for goal in goals)


def _with_others(work: Work, id: str, goals: Sequence[Goal]) -> bool:
    """Move one thing to between two others that are moved apart for it."""
    return with_room_between(
        work, id, goals, lambda: reach_goals(work, id, goals, direct=spots_for(work, id, goals)) is None
    )


def _with_its_worktop(work: Work, id: str, goals: Sequence[Goal]) -> bool:
    """Move the cabinet that a sink or hob is let into, with that and all else on it, to where that is to be."""
    carrier = work.scene[id].support
    if not facts_of(work.scene[id].category).is_in("built_in") or carrier not in work.scene:
        return False
    if carrier in work.kept or any(carrier in getattr(goal, "anchors", ()) for goal in goals):
        return False
    before = work.scene[carrier]
    if reach_goals(work, carrier, goals, direct=spots_for(work, carrier, goals)) is not None:
        return False
    say(work, carrier, before, None, goals)
    work.notes.append(f"{id} is let into {carrier}, and goes where that goes")
    return True


def _in_half(order: Order, goals: Sequence[Goal]) -> list[Goal]:
    """The goals with the half of the room at a wall in place of that wall, where a side of the room is said."""
    nouns = [w.noun for w in (*order.places, *(w for p in order.things for w in p.places)) if w.noun is not None]
    sided = any(noun.kind == "place" and "side" in noun.text.lower().split() for noun in nouns)
    walled = [g for g in goals if type(g) is Related and g.kind == "against_wall" and len(g.anchors) == 1]
    if not sided or len(walled) != 1 or walled[0].negated:
        return []
    return [OnSide(walled[0].anchors[0]) if goal is walled[0] else goal for goal in goals]


def _reach_beside(work: Work, id: str, goals: Sequence[Goal], direct: Iterator[Pose]) -> Reaching | None:
    """As `reach_goals`; what is to be beside a thing stands at its left or right where it can."""
    saved = work.saved()
    done = reach_goals(work, id, goals, direct=direct, ask=True)
    if done is None:
        prefer_sides(
            work,
            id,
            goals,
            saved,
            lambda other: reach_goals(work, id, other, direct=spots_for(work, id, other)) is None,
        )
    return done


def _is_so(work: Work, goal: Goal, id: str) -> bool:
    """Whether a goal is met as it is: of what is to be in the middle or between things not only about so."""
    near = (
        not isinstance(goal, Related)
        or isinstance(goal, Midway)
        or middle_off(work.scene, id, goal.kind, goal.anchors) <= MIDDLE
    )
    if isinstance(goal, At) and goal.reach >= THERE:
        near = is_there(work, goal, id)
    if isinstance(goal, Related) and goal.kind in ("at", "around") and id in seats_among(work, [id]):
        near = _sits_at(work.scene, id) in goal.anchors
    return near and goal.check(work.before, work.scene, id)[0]


def _sits_at(scene: Scene, id: str) -> str:
    """The table or counter that a seat is nearest to."""
    tables = [p.id for p in scene.placements if facts_of(p.category).is_in("tables", "desks", "counters")]
    mark = things(scene, id)[0]
    return min(tables, key=lambda name: ground_gap(mark, things(scene, name)[0]), default="")


def _to_other_height(work: Work, order: Order, id: str) -> None:
    """Put what rests on something on what is higher, or lower, and carries it: what usually does first."""
    before, up = work.scene[id], order.direction == "up"
    usual = usual_carriers(work.scene, before.category)
    others = [p for p in work.scene.placements if p.id not in usual and work.asset_of(p.id).surfaces and p.id != id]
    near = [p.id for p in sorted(others, key=lambda p: math.dist(p.position, before.position))]
    failed: Reaching | None = None
    for carrier in [*usual, *near]:
        tops = [work.scene[carrier].position[2] + s.position[2] for s in work.asset_of(carrier).surfaces]
        if carrier == before.support or (max(tops) > before.position[2] + TOUCHING) != up:
            continue
        goals: list[Goal] = [Related("on", (carrier,)), Raised(up)]
        if (why := reach_goals(work, id, goals, direct=spots_for(work, id, goals), ask=True)) is None:
            say(work, id, before, None, goals)
            return
        failed = failed or why
    if failed is not None:
        say(work, id, before, failed, ())
        return
    raise InputError(f"'{order.text}': nothing that is {'higher' if up else 'lower'} than {id} carries such a thing")
