"""Several things further apart: every two neighbours of them, each moved away from the middle of all."""

import math
from collections.abc import Mapping, Sequence
from itertools import combinations

from thinkblox.editing.acting import moved_words
from thinkblox.editing.carrying import put_back, take
from thinkblox.editing.goals import EXACT, LEAST, At
from thinkblox.editing.reaching import Reaching
from thinkblox.editing.rows import looks_to
from thinkblox.editing.work import Work
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2

WIDER = (0.3, 0.2, 0.15, 0.1, 0.05)
"""By which share of its distance from the middle each is moved where nobody says how far."""
SLIGHTLY = (0.15, 0.1, 0.05)
"""The same for "a bit"."""
NEAR = 1.25
"""Two of them are neighbours where their middles are at most so many times as far apart as the nearest other is."""
OFF = 0.1
"""How far from there a thing may come to stand [m]."""


ROWS_WIDER, ROWS_SLIGHTLY = (0.4, 0.3, 0.2, 0.1), (0.15, 0.1, 0.05)
"""By how much rows are further apart where nobody says it, the most first [m]; the same for "a bit"."""


def scatter(work: Work, ids: Sequence[str], *, by: float | None, slight: bool) -> None:
    """Move things away from the middle of them all, until all neighbours are further apart; notes what became of it.

    Args:
        work: the edit.
        ids: three or more that are there.
        by: how much further apart neighbours are to be [m].
        slight: it is to be a little.
    """
    before, pairs = work.scene, _neighbours(work.scene, ids)
    x, y = (sum(before[id].position[axis] for id in ids) / len(ids) for axis in (0, 1))
    nearest = min(math.dist(before[a].position[:2], before[b].position[:2]) for a, b in pairs)
    why = ""
    for share in (by / nearest,) if by is not None else SLIGHTLY if slight else WIDER:
        spots = {
            id: (x + (before[id].position[0] - x) * (1 + share), y + (before[id].position[1] - y) * (1 + share))
            for id in ids
        }
        why = moved_to(work, ids, spots) or _closer(before, work.scene, pairs, LEAST if by is None else by - OFF)
        if not why:
            work.done += [moved_words(before[id], work.scene[id]) for id in ids if before[id] != work.scene[id]]
            return
        work.world = work.world.with_scene(before)
    work.failed.append(f"{', '.join(ids)} were left where they are: {why}")


def scatter_rows(work: Work, rows: Sequence[Sequence[Placement]], *, by: float | None, slight: bool) -> None:
    """Move rows away from the middle of them all, each as one; notes what became of it.

    Args:
        work: the edit.
        rows: two or more, the front one first, each with the seats that are drawn up to it.
        by: how much further apart each two are to be [m].
        slight: it is to be a little.
    """
    before, ids = work.scene, [p.id for row in rows for p in row]
    way = math.radians(looks_to(before, rows[0][0]))
    why = ""
    for step in (by,) if by is not None else ROWS_SLIGHTLY if slight else ROWS_WIDER:
        spots: dict[str, Vec2] = {}
        for number, row in enumerate(rows):
            ahead = ((len(rows) - 1) / 2 - number) * step
            spots |= {p.id: (p.position[0] + ahead * math.cos(way), p.position[1] + ahead * math.sin(way)) for p in row}
        why = moved_to(work, ids, spots, off=EXACT)
        if not why:
            work.done += [moved_words(before[id], work.scene[id]) for id in ids if before[id] != work.scene[id]]
            work.done.append(f"the {len(rows)} rows are {step:.2f} m further apart")
            return
        work.world = work.world.with_scene(before)
    work.failed.append(f"the rows were left where they are: {why}")


def _neighbours(scene: Scene, ids: Sequence[str]) -> list[tuple[str, str]]:
    away = {pair: math.dist(scene[pair[0]].position[:2], scene[pair[1]].position[:2]) for pair in combinations(ids, 2)}
    nearest = {id: min(far for pair, far in away.items() if id in pair) for id in ids}
    return [(a, b) for (a, b), far in away.items() if far <= NEAR * max(nearest[a], nearest[b])]


def moved_to(work: Work, ids: Sequence[str], spots: Mapping[str, Vec2], *, off: float = OFF) -> str:
    """Put each at its spot, all of them at once with what rests on them; why not, where one cannot stand there."""
    before = work.scene
    taken = take(work, ids)
    for id in ids:
        old, asset = before[id], work.assets[before[id].asset]
        pose = ((round(spots[id][0], 4), round(spots[id][1], 4), old.position[2]), old.yaw)
        target = work.target(id, old.category, (), asset.attributes)
        reaching = Reaching(work, target, asset, [At(spots[id], off)], direct=(pose,), ask=False, begin=pose)
        if not reaching.run():
            return reaching.why
        if lost := put_back(work, old, [p for p in taken if p.id not in ids], before):
            return f"{', '.join(lost)} could not go along with {id}"
    return ""


def _closer(before: Scene, after: Scene, pairs: Sequence[tuple[str, str]], least: float) -> str:
    """Which two neighbours are not so much further apart; empty where all are."""
    for one, other in pairs:
        old, new = (ground_gap(things(scene, one)[0], things(scene, other)[0]) for scene in (before, after))
        if new < old + least:
            return f"{one} and {other} would be {new:.2f} m apart, {old:.2f} m before"
    return ""
