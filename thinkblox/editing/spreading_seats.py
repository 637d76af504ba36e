"""Seats spread evenly along the sides of the table or counter that they are drawn up to."""

import math
from collections.abc import Sequence
from itertools import combinations

from thinkblox.assets import facts_of
from thinkblox.editing.acting import moved_words
from thinkblox.editing.goals import At, Related
from thinkblox.editing.scattering import moved_to
from thinkblox.editing.work import Work
from thinkblox.scene.bearings import ground_gap
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2

OFF, THERE = 0.12, 0.05
"""How far from its share of a side a seat may come to stand, and how far one is left that is there already [m]."""
LEG = 0.13
"""How far from the ends of a side seats are at least, where the legs may be [m]."""


def host_of(scene: Scene, ids: Sequence[str]) -> str:
    """The one table, desk or counter that all of some seats are drawn up to; empty where they are not."""
    if not all(facts_of(scene[id].category).is_in("seating") for id in ids):
        return ""
    tables = [p.id for p in scene.placements if facts_of(p.category).is_in("tables", "desks", "counters")]
    if not tables:
        return ""
    marks = {id: things(scene, id)[0] for id in (*tables, *ids)}
    nearest = {min(tables, key=lambda table: ground_gap(marks[id], marks[table])) for id in ids}
    (host, *more) = nearest
    drawn_up = not more and all(measure(scene, "at", id, (host,)).holds for id in ids)
    return host if drawn_up else ""


def spread_seats(work: Work, ids: Sequence[str], host: str) -> None:
    """Share each side of a table out evenly to the seats at it; notes what became of them."""
    before, table = work.scene, work.scene[host]
    sides: dict[tuple[int, int], list[str]] = {}
    for id in ids:
        sides.setdefault(_side(table, before[id]), []).append(id)
    spots = {id: spot for side, there in sides.items() for id, spot in _shares(before, table, side, there).items()}
    near, was = _nearest(list(spots.values())), _nearest([before[id].position[:2] for id in ids])
    if max(math.dist(spots[id], before[id].position[:2]) for id in ids) <= THERE:
        work.done.append(f"{', '.join(ids)} stay: they are spread along {host} already")
        return
    if why := moved_to(work, ids, spots, off=OFF):
        work.world = work.world.with_scene(before)
        work.failed.append(f"{', '.join(ids)} were left where they are: {why}")
        return
    for id in ids:
        work.wish(id, [At(spots[id], OFF), Related("at", (host,))])
    work.done += [moved_words(before[id], work.scene[id]) for id in ids if work.scene[id] != before[id]]
    says = f"{', '.join(ids)} are spread along {host}, at least {near:.2f} m from each other ({was:.2f} m before)"
    work.done.append(says)


def _side(table: Placement, seat: Placement) -> tuple[int, int]:
    """Before (1, 0), behind (-1, 0), left (0, 1) or right (0, -1) of a table, by how far beyond its outline that is."""
    ahead, left = table.to_local(seat.position[:2])
    if abs(ahead) - table.size[0] / 2 >= abs(left) - table.size[1] / 2:
        return (1 if ahead > 0 else -1, 0)
    return (0, 1 if left > 0 else -1)


def _shares(scene: Scene, table: Placement, side: tuple[int, int], ids: Sequence[str]) -> dict[str, Vec2]:
    """The middles of equal parts of a side, as far out as each seat is, in the order in which they stand there."""
    along = 1 if side[0] else 0
    places = {id: table.to_local(scene[id].position[:2]) for id in ids}
    found: dict[str, Vec2] = {}
    length, widest = table.size[along], max(scene[id].size[1] for id in ids)
    reach = max(0.0, min(length * (1 - 1 / len(ids)), length - widest - 2 * LEG))
    for number, id in enumerate(sorted(ids, key=lambda id: places[id][along])):
        share = (number / max(len(ids) - 1, 1) - 0.5) * reach
        ahead, left = (places[id][0], share) if along else (share, places[id][1])
        x, y = table.to_room((ahead, left))
        found[id] = (round(x, 4), round(y, 4))
    return found


def _nearest(spots: Sequence[Vec2]) -> float:
    return min(math.dist(one, other) for one, other in combinations(spots, 2))
