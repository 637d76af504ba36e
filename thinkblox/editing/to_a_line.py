"""More of what stands beside each other at a wall."""

from collections.abc import Sequence
from dataclasses import replace

from thinkblox.editing.adding_one import MOST, add_one
from thinkblox.editing.finding import Finder
from thinkblox.editing.goals import Abreast, Goal, Related
from thinkblox.editing.rows import rows_of
from thinkblox.editing.work import Work
from thinkblox.reading.english.chunks import Noun
from thinkblox.reading.english.nodes import Where
from thinkblox.scene.relations import measure


def line_said(work: Work, finder: Finder, noun: Noun, places: Sequence[Where]) -> list[str]:
    """Those of its kind that stand beside each other at a wall, which "to the row (along the wall)" names."""
    row = next((w.noun for w in places if w.noun is not None and w.noun.kind == "thing" and w.noun.rows == -1), None)
    if row is None or row.value != noun.value or row.text.lower().split()[-1] != "row":
        return []
    found = finder.matching(replace(row, rows=0, plural=True, count=None))
    walls = [[w.name for w in work.scene.room.walls if measure(work.scene, "against_wall", p.id, (w.name,)).holds]
             for p in found]  # fmt: skip
    first = next((names[0] for names in walls if names), "")
    kept = [p for p, names in zip(found, walls, strict=True) if first and first in names]
    if len(kept) < 2 or len(rows_of(work.scene, kept)) != 1:
        return []
    way = kept[0].left
    return [p.id for p in sorted(kept, key=lambda p: p.position[0] * way[0] + p.position[1] * way[1])]


def add_to_line(work: Work, noun: Noun, line: list[str]) -> list[str]:
    """Add so many more at either end of those that stand beside each other at a wall."""
    added: list[str] = []
    count = noun.count or (2 if noun.plural else 1)
    for _ in range(min(count, MOST)):
        saved, said = work.saved(), len(work.failed)
        for end in (0, -1):
            goals: list[Goal] = [Abreast("next_to", (line[end],)), Related("against_wall", ("wall",))]
            if id := add_one(work, work.scene[line[end]].category, noun, goals):
                del work.failed[said:]
                line.insert(0 if end == 0 else len(line), id)
                added.append(id)
                break
            work.restore(saved)
        else:
            del work.failed[said + 1 :]
            break
    return added
