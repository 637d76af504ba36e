"""A room, a plan and a layout in the words of a prompt: compact JSON, a line for each thing, to the millimetre."""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import msgspec
from shapely import Polygon

from thinkblox.brief import Relation
from thinkblox.plan import Due, Target, Tie, carries
from thinkblox.scene.arrangement import Arrangement
from thinkblox.scene.asset import Mount
from thinkblox.scene.free_spots import free_spots
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.value import Vec3

SPOTS = 3
"""Free spots that are named for each surface."""
MOST_SURFACES = 12
"""Surfaces whose free spots are named."""
_GROUPS = 12
"""Kinds of things that are counted where they are not listed."""


def compact(value: object) -> str:
    """JSON without spaces; whole numbers without a point."""
    return msgspec.json.encode(value).decode()


def describe_tie(tie: Tie | Due | Relation) -> str:
    """A relation as a term, "next_to(bed_1)": no phrase of the step language, for it says what is wanted, not where.

    What is due of another thing begins with that: "chair_1 next_to(bed_1)".
    """
    if isinstance(tie, Due):
        return f"{tie.subject} {describe_tie(tie.tie)}"
    return f"{tie.kind}({', '.join(tie.anchors)})" if tie.anchors else tie.kind


def room_words(room: Room) -> str:
    """Floor, height, names of the walls, and openings."""
    openings = [
        {
            "id": o.id,
            "kind": o.kind,
            "wall": room.walls[o.wall].name,
            "offset": shortened(o.offset),
            "width": shortened(o.width),
            "sill": shortened(o.sill),
            "height": shortened(o.height),
        }
        for o in room.openings
    ]
    said = {
        "floor": [_all(point) for point in room.floor],
        "height": shortened(room.height),
        "walls": [wall.name for wall in room.walls],
        "openings": openings,
    }
    return compact(said)


def planned_line(target: Target, size: Vec3 | None, mount: Mount | None) -> str:
    """One object of a plan: its id, its usual size, what it is placed on, what is wanted of it."""
    planned: dict[str, object] = {"id": target.id}
    if size is not None:
        planned["size"] = _all(given or usual for given, usual in zip(target.size, size, strict=True))
    if mount not in (None, "floor"):
        planned["mount"] = mount
    if target.ties:
        planned["wanted"] = [describe_tie(tie) for tie in target.wanted]
    return compact(planned)


def placed_line(arrangement: Arrangement, placement: Placement) -> str:
    """One object of a layout, as long as it stays where it is: nothing in it depends on what else is there."""
    p, known = placement, arrangement.asset_of(placement)
    seen: dict[str, object] = {
        "id": p.id,
        "position": _all(p.position),
        "yaw": shortened(p.yaw, 1),
        "size": _all(p.size),
    }
    if p.support != "floor":
        seen["on"] = p.support
    opens = getattr(known, "opens", ())
    if opens:
        seen["opens"] = opens
    if known.surfaces:
        seen["surfaces"] = [_all((p.position[2] + s.position[2], *s.size)) for s in known.surfaces]
    return compact(seen)


@dataclass(frozen=True)
class LayoutText:
    """A layout in lines.

    Attributes:
        head: objects in the order of placement, as far as half the budget goes: it only ever grows at its end.
        rest: the others that are listed: all of them in the same order where the budget allows, else those that
            matter most for the target, and last what is not listed, in numbers.
    """

    head: str
    rest: str

    @property
    def whole(self) -> str:
        """Both."""
        return "\n".join(part for part in (self.head, self.rest) if part)


def layout_text(arrangement: Arrangement, target: Target | None, budget: int) -> LayoutText:
    """The objects of a layout within about so many characters, what is not listed being counted.

    The first ones are listed whatever the target is, so that the text of one step begins that of the next.
    """
    placements = arrangement.placements
    lines = [placed_line(arrangement, p) for p in placements]
    first = _fitting(lines, budget // 2)
    head = "\n".join(lines[:first])
    if _fitting(lines, budget) == len(lines):
        return LayoutText(head, "\n".join(lines[first:]))
    matter = sorted(range(first, len(lines)), key=lambda n: _distance(arrangement, placements[n], target))
    left = budget - len(head)
    chosen = matter[: _fitting([lines[n] for n in matter], left)]
    missing = [placements[n] for n in matter[len(chosen) :]]
    listed = [lines[n] for n in sorted(chosen)]
    return LayoutText(head, "\n".join([*listed, _counted(missing)]))


def free_words(arrangement: Arrangement, target: Target) -> dict[str, list[list[float | list[float]]]]:
    """Free circles of the surfaces that a small target may stand on: by id, [z, [x, y, radius], ...] for each.

    Those of what it is to stand on where that is said, else of the largest surfaces.
    """
    carriers = [a for tie in target.ties if carries(tie) for a in tie.anchors if a in arrangement]
    of = [arrangement[id] for id in dict.fromkeys(carriers)] or list(arrangement.placements)
    found = [(p, s) for p in of for s in arrangement.asset_of(p).surfaces]
    found.sort(key=lambda pair: -pair[1].size[0] * pair[1].size[1])
    words: dict[str, list[list[float | list[float]]]] = {}
    for placement, surface in found[:MOST_SURFACES]:
        z = shortened(placement.position[2] + surface.position[2])
        spots = free_spots(arrangement, placement, surface, count=SPOTS)
        words.setdefault(placement.id, []).append([z, *(_all((*s.position[:2], s.clear)) for s in spots)])
    return words


def shortened(value: float, digits: int = 3) -> float:
    """A number to the millimetre, or to some digits; a whole one as an int, which JSON writes without a point."""
    rounded = round(value, digits)
    return int(rounded) if rounded == int(rounded) else rounded


def _all(values: Iterable[float]) -> list[float]:
    return [shortened(value) for value in values]


def _fitting(lines: Sequence[str], budget: int) -> int:
    """How many lines have at most so many characters together."""
    used = 0
    for number, line in enumerate(lines):
        used += len(line) + 1
        if used > budget:
            return number
    return len(lines)


def _distance(arrangement: Arrangement, placement: Placement, target: Target | None) -> tuple[int, float, float]:
    """How little a placement matters for a target: what it depends on first, then what stands on that, then the rest
    by distance from it; large before small where it depends on nothing.
    """
    area = -placement.size[0] * placement.size[1]
    anchors = [arrangement[id] for id in target.depends_on if id in arrangement] if target else []
    if not anchors:
        return (0 if placement.support == "floor" else 1, 0.0, area)
    ids = {anchor.id for anchor in anchors}
    below = {id for anchor in anchors for id in arrangement.carriers(anchor.id)}
    if placement.id in ids | below:
        return (0, 0.0, area)
    footprint = Polygon(placement.corners)
    near = min(footprint.distance(Polygon(anchor.corners)) for anchor in anchors)
    return (1 if placement.support in ids else 2, round(near, 3), area)


def _counted(missing: Sequence[Placement]) -> str:
    groups = Counter((p.category, p.support) for p in missing).most_common()
    said = [f"{count} {category} on {support}" for (category, support), count in groups[:_GROUPS]]
    others = sum(count for _, count in groups[_GROUPS:])
    said += [f"{others} others"] if others else []
    return f"Not listed, {len(missing)} that matter less here: {'; '.join(said)}"


__all__ = [
    "LayoutText",
    "compact",
    "describe_tie",
    "free_words",
    "layout_text",
    "placed_line",
    "planned_line",
    "room_words",
    "shortened",
]
