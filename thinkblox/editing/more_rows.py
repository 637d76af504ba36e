"""One more row of what stands in rows: like the one that it comes behind or before, as far from it as they stand."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Literal

from thinkblox.assets import facts_of
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import At
from thinkblox.editing.orders import NounPhrase, Order
from thinkblox.editing.reaching import Reaching
from thinkblox.editing.rows import rows_of, rows_of_all
from thinkblox.editing.work import Work
from thinkblox.errors import InputError
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.landmarks import things
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2

End = Literal["front", "back"]
_ENDS: dict[str, End] = {"back": "back", "behind": "back", "front": "front", "in_front_of": "front"}
NEARER = (1.0, 0.9, 0.8)
"""At how many times the distance of the others a row is tried."""
OFF = 0.1
"""How far from its place in the row a thing may come to stand [m]."""
MOST = 5
"""Most rows that one order adds."""


def is_row(noun: Noun) -> bool:
    """Whether it is one row or more that is to be added: "another row of desks"."""
    return noun.rows > 0 and not noun.groups and noun.kind in ("thing", "number")


def add_rows(work: Work, finder: Finder, order: Order, phrase: NounPhrase, places: Sequence[Where]) -> list[str]:
    """Add rows behind the last one, or before the first; the seats of the last one are copied where that is said.

    Args:
        work: the edit.
        finder: finds what stands in rows.
        order: the order.
        phrase: of the row; `is_row` is so of its noun.
        places: of what the rows are, what comes along, and where they go.

    Raises:
        InputError: such things do not stand in rows, or the order says of the row what is not followed.
    """
    kind = next((w.noun for w in places if w.word == "of" and w.noun is not None and w.noun.kind == "thing"), None)
    noun = phrase.noun if phrase.noun.kind == "thing" else kind
    found = finder.matching(replace(noun, rows=1, count=None, plural=True)) if noun is not None else []
    rows = rows_of(work.scene, found) if noun is not None else rows_of_all(work.scene)
    rows = [row for row in rows if len(row) > 1 or len(rows) > 2]
    if len(rows) < 2:
        raise InputError(f"'{phrase.noun.text}': nothing stands in rows like that; say how many, and where each goes")
    end = _end(order, places)
    seated = noun is None or any(w.word == "with" for w in places)
    added: list[str] = []
    for _ in range(min(phrase.noun.rows, MOST)):
        first, last = rows[::-1][:2][::-1] if end == "back" else rows[:2][::-1]
        wanted = noun.count if noun is not None and noun.count and noun.count > 1 else None
        new = _add_row(work, first, last, count=wanted, seated=seated)
        if not new:
            break
        added += new
        row = [work.scene[id] for id in new if work.scene[id].category == last[0].category]
        rows = [*rows, row] if end == "back" else [row, *rows]
    finder.scene = work.scene
    return added


def _end(order: Order, places: Sequence[Where]) -> End:
    """At which end the row comes: at the back, where nothing else is said.

    Raises:
        InputError: it is to stand elsewhere.
    """
    for where in (w for w in places if w.word not in ("of", "with")):
        value = where.noun.value if where.noun is not None and where.noun.kind == "part" else where.word
        if value not in _ENDS:
            raise InputError(f"'{order.text}': a row is added at the back or at the front; say one of them")
        return _ENDS[value]
    return "back"


def _add_row(
    work: Work, before: Sequence[Placement], last: Sequence[Placement], *, count: int | None, seated: bool
) -> list[str]:
    """Copy a row as far from it as it is from the one before; the ids, none where there is no room, which is noted."""
    desks = [p for p in last if not facts_of(p.category).is_in("seating")] or list(last)
    if count is not None and count > len(desks):
        work.failed.append(f"a row of {count} was not added: the one that it would be like has {len(desks)}")
        return []
    desks = desks[:count] if count is not None else desks
    seats = [p for p in work.scene.placements if facts_of(p.category).is_in("seating") and p not in desks]
    at = [p for p in seats if any(measure(work.scene, "at", p.id, (d.id,)).holds for d in desks)] if seated else []
    x, y = _step(work.scene, before, last)
    saved, why = work.saved(), ""
    for share in NEARER:
        added: list[str] = []
        for placement in (*desks, *at):
            id, failed = _copy(work, placement, (x * share, y * share))
            if failed:
                why = why or failed
                work.restore(saved)
                break
            added.append(id)
        else:
            ids = ", ".join(added)
            work.done.append(f"{ids} added as a row {math.hypot(x, y) * share:.2f} m from that of {desks[0].id}")
            return added
    work.failed.append(f"another row was not added: {why}")
    return []


def _step(scene: Scene, before: Sequence[Placement], last: Sequence[Placement]) -> Vec2:
    """From one row to the next, along the way that they look [m]."""
    way = math.radians(things(scene, last[0].id)[0].gaze)
    ahead = [_mean(row, (math.cos(way), math.sin(way))) for row in (before, last)]
    off = ahead[1] - ahead[0]
    return (off * math.cos(way), off * math.sin(way))


def _mean(row: Sequence[Placement], way: Vec2) -> float:
    alike = [p for p in row if p.category == row[0].category]
    return sum(p.position[0] * way[0] + p.position[1] * way[1] for p in alike) / len(alike)


def _copy(work: Work, placement: Placement, by: Vec2) -> tuple[str, str]:
    """Another one of a thing so far from it; its id, and why it cannot stand there."""
    id, asset = work.new_id(placement.category), work.asset_of(placement.id)
    x, y, z = placement.position
    spot = (round(x + by[0], 4), round(y + by[1], 4))
    goals = [At(spot, OFF)]
    poses: Iterator[tuple[tuple[float, float, float], float]] = iter([((*spot, z), placement.yaw)])
    target = work.target(id, placement.category, (), asset.attributes)
    reaching = Reaching(work, target, asset, goals, direct=poses, ask=False, begin=((*spot, z), placement.yaw))
    if not reaching.run():
        return id, reaching.why
    work.wish(id, goals)
    return id, ""
