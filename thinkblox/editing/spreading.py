"""Several things spread evenly: over the floor of the room, or along a wall."""

import math
from collections.abc import Iterator, Sequence
from itertools import chain, combinations, permutations

import numpy as np
from msgspec import structs

from thinkblox.assets import facts_of
from thinkblox.editing.acting import moved_words, reach_goals
from thinkblox.editing.company import bring_together, seats_at
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import At, Goal, OnWall, Related
from thinkblox.editing.grammar import longest
from thinkblox.editing.orders import Order
from thinkblox.editing.reaching import without
from thinkblox.editing.spots import BACK, Pose, hides_opening, whole_floor
from thinkblox.editing.spreading_seats import host_of, spread_seats
from thinkblox.editing.telling import named
from thinkblox.editing.wheres import bound
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.reading.english.nodes import Where
from thinkblox.reading.tokens import tokenise
from thinkblox.scene.nearby import BACK_GAP
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.room import Wall
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2

OFF = 0.6
"""How far from its share of the floor something may stand [m]."""
OFF_WALL = 0.25
"""The same along a wall [m]."""
ASIDE = tuple(sign * 0.1 * n for n in range(20) for sign in (1.0, -1.0))
"""How far from its share of the wall something is tried [m]."""
TURNS = 12
"""How often the middles of the shares are taken anew."""
FEW = 6
"""Most things of which every way to share out the places is looked at."""


def spread(work: Work, finder: Finder, order: Order) -> None:
    """Move things so that they are spread evenly over the room, or along the wall that the order names.

    Raises:
        InputError: it names no things that stand or hang, fewer than two, or another place than a wall.
    """
    if not order.things:
        raise InputError(f"'{order.text}' does not say what; there {finder.listed()}")
    walled = [w for phrase in order.things for w in phrase.places if w.word in ("along", "on", "against", "at")]
    ids = list(
        dict.fromkeys(id for p in order.things for id in named(finder, p, [w for w in p.places if w not in walled]))
    )
    ids = list(work.touched(_told_by_wall(work, order, ids, walled, finder)))
    if len(ids) < 2 or any(work.scene[id].support in work.scene for id in ids):
        raise InputError(
            f"'{order.text}': things that stand or hang in the room can be spread; it names {', '.join(ids)}"
        )
    finder.about = ids[0]
    host = host_of(work.scene, ids) if "room" not in order.text.lower() else ""
    if host and (not walled or _is_along(finder, walled, host)):
        spread_seats(work, ids, host)
        finder.recent = ids
        return
    names = bound(walled[0], work.scene[ids[0]].category, finder).anchors if walled else ()
    wall = next((wall for wall in work.scene.room.walls if wall.name in names), None)
    if walled and (len(names) != 1 or wall is None):
        raise InputError(f"'{order.text}': things are spread over the room or along one wall; say which")
    spots = _along(wall, len(ids)) if wall is not None else _over(work, ids)
    _bring(work, ids, _shared(work.scene, ids, spots), wall)
    finder.recent = ids


def _told_by_wall(
    work: Work, order: Order, ids: Sequence[str], walled: Sequence[Where], finder: Finder
) -> Sequence[str]:
    """Those at a wall, where that says which are meant: "space the chairs along the north wall evenly"."""
    words = order.text.lower().split()
    if len(walled) != 1 or not longest("all_over", tokenise(words[-1]), 0):
        return ids
    names = bound(walled[0], work.scene[ids[0]].category, finder).anchors
    held = [id for id in ids if any(measure(work.scene, "against_wall", id, (name,)).holds for name in names)]
    return held if len(held) > 1 else ids


def _is_along(finder: Finder, places: Sequence[Where], host: str) -> bool:
    """Whether the one place that is said is the table or counter at which the things stand."""
    noun = places[0].noun if len(places) == 1 else None
    return noun is not None and noun.kind == "thing" and host in [p.id for p in finder.matching(noun)]


def _bring(work: Work, ids: Sequence[str], spots: dict[str, Vec2], wall: Wall | None) -> None:
    """Bring each to its place with the seats that are drawn up to it; all of them or none."""
    before, saved, said = work.scene, work.saved(), (len(work.done), len(work.failed))
    left, why = list(ids), ""
    while left:
        again = []
        for id in left:
            goals, poses = _wanted(work, id, spots[id], wall)
            seats = seats_at(work.scene, id, besides={*ids, *work.kept})
            bring_together(work, id, seats, lambda id=id, goals=goals, poses=poses: _reach(work, id, goals, poses))  # type: ignore[misc]
            if len(work.failed) > said[1]:
                again.append(id)
                why = work.failed[said[1]]
                del work.failed[said[1] :]
            else:
                work.wish(id, goals)
        if len(again) == len(left):
            work.restore(saved)
            work.failed.append(f"{', '.join(ids)} were left where they are: {why}")
            return
        left = again
    del work.done[said[0] :]
    work.done += [moved_words(before[p.id], p) for p in work.scene.placements if p != before[p.id]]
    near, was = (_nearest([scene[id].position[:2] for id in ids]) for scene in (work.scene, before))
    if wall is None and near <= was:
        work.restore(saved)
        work.done.append(f"{', '.join(ids)} stay: they are at least {was:.2f} m from each other already")
        return
    where = f"along the {wall.name.replace('_', ' ')}" if wall is not None else "over the room"
    work.done.append(f"{', '.join(ids)} are spread {where}, at least {near:.2f} m from each other ({was:.2f} m before)")


def _reach(work: Work, id: str, goals: Sequence[Goal], poses: Iterator[Pose]) -> None:
    failed = reach_goals(work, id, goals, direct=poses)
    if failed is not None:
        work.failed.append(failed.why)


def _nearest(spots: Sequence[Vec2]) -> float:
    return min(math.dist(one, other) for one, other in combinations(spots, 2))


def _wanted(work: Work, id: str, spot: Vec2, wall: Wall | None) -> tuple[list[Goal], Iterator[Pose]]:
    """What a thing is to meet at its place, and the poses that are tried there: at a wall with the back to it."""
    old, asset = work.scene[id], work.asset_of(id)
    if wall is not None:
        hung = asset.mount == "wall"
        at: Goal = OnWall("on", (wall.name,)) if hung else Related("against_wall", (wall.name,))
        poses = [_at_wall(old, wall, wall.coordinates(spot)[0] + off, hung=hung) for off in ASIDE]
        poses = [pose for pose in poses if not (hung and hides_opening(work.scene, asset, wall, pose))]
        first = poses[0][0] if poses else spot
        return [At((first[0], first[1]), OFF_WALL), at], iter(poses)
    empty = without(work.scene, [id, *(rider.id for rider in work.scene.riders(id))])
    start = structs.replace(old, position=(*spot, old.position[2]))
    about = whole_floor(empty, asset, start) if asset.mount == "floor" else ()
    return [At(spot, OFF)], chain([(start.position, old.yaw)], about)


def _at_wall(old: Placement, wall: Wall, along: float, *, hung: bool) -> Pose:
    """With the back to a wall, so far from where it begins."""
    x, y = wall.point(along, old.size[0] / 2 + (BACK_GAP if hung else BACK[0]))
    return (round(x, 4), round(y, 4), old.position[2]), wall.yaw


def _along(wall: Wall, count: int) -> list[Vec2]:
    """The middles of so many equal parts of a wall."""
    return [wall.point((n + 0.5) * wall.length / count, 0.0) for n in range(count)]


def _over(work: Work, ids: Sequence[str]) -> list[Vec2]:
    """Places of which each has about the same share of the floor that is free; small things far from each other."""
    gone = [seat for id in ids for seat in seats_at(work.scene, id, besides=ids)]
    gone = [r for id in dict.fromkeys((*ids, *gone)) for r in (*(rider.id for rider in work.scene.riders(id)), id)]
    empty = without(work.scene, dict.fromkeys(gone))
    widest = max((work.scene[id] for id in ids), key=lambda p: p.size[0] * p.size[1])
    poses = whole_floor(empty, work.asset_of(widest.id), widest)
    free = np.array(sorted({pose[0][:2] for pose in poses}))
    if len(free) < len(ids):
        raise InputError(f"there is no room to spread {', '.join(ids)}")
    chosen = _farthest(free, np.array(widest.position[:2]), len(ids))
    if facts_of(widest.category).is_in("tables", "desks", "seating"):
        for _ in range(TURNS):
            nearest = np.linalg.norm(free[:, None] - chosen[None], axis=-1).argmin(-1)
            means = [free[nearest == n].mean(0) for n in range(len(chosen))]
            chosen = np.array([free[np.linalg.norm(free - mean, axis=-1).argmin()] for mean in means])
    return [(round(float(x), 4), round(float(y), 4)) for x, y in chosen]


def _farthest(free: np.ndarray, begin: np.ndarray, count: int) -> np.ndarray:
    """So many of some points, each as far as can be from those before it; the first as far as can be from the start."""
    chosen = [free[np.linalg.norm(free - begin, axis=-1).argmax()]]
    while len(chosen) < count:
        away = np.linalg.norm(free[:, None] - np.array(chosen)[None], axis=-1).min(-1)
        chosen.append(free[away.argmax()])
    return np.array(chosen)


def _shared(scene: Scene, ids: Sequence[str], spots: Sequence[Vec2]) -> dict[str, Vec2]:
    """Which of the places each goes to, so that they move as little as can be together."""
    if len(ids) <= FEW:
        best = min(
            permutations(spots),
            key=lambda some: sum(math.dist(scene[i].position[:2], s) for i, s in zip(ids, some, strict=True)),
        )
        return dict(zip(ids, best, strict=True))
    left, shared = list(spots), {}
    for id in ids:
        shared[id] = min(left, key=lambda spot: math.dist(scene[id].position[:2], spot))
        left.remove(shared[id])
    return shared
