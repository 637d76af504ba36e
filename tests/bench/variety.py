"""How much rooms of one prompt differ from seed to seed: mean distances of all pairs.

python -m tests.bench.variety [--seeds N] [--prompt TEXT ...]

The room is compared by its sides, what stands on the floor by where it stands once the one room has been turned and
mirrored to be most like the other, things of one category by size and by what they are made of, the whole by its
categories and its surfaces.
"""

import argparse
import itertools
import math
import statistics
from collections import Counter
from typing import Any, NamedTuple

import msgspec

from thinkblox.generate import generate_room
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene

PROMPTS = (
    "A cosy living room",
    "A bedroom with a double bed, two nightstands and a wardrobe",
    "A kitchen",
    "A home office with a desk, a chair and a bookcase",
    "A dining room for six",
    "A kids room with a bed, a desk, a chair and a toy box",
)
ALONE = 1.5
"""Distance that counts for a thing that the other room has nothing like [m]."""
PARTS = ("floor", "walls", "accent", "accent_wall", "dado", "trim", "door", "curtains")
TURNS = tuple(itertools.product((0, 90, 180, 270), (False, True)))


class Distance(NamedTuple):
    """Between two rooms of one prompt.

    Attributes:
        room: mean difference of the longer and of the shorter sides, as a share.
        poses: mean distance of things of one category that stand on the floor, their rooms laid over each other
            in the likest of eight ways, and a metre for a half turn [m].
        seen: the same, as they stand [m].
        openings: mean distance of doors and windows of the rooms, as they are [m].
        sizes: mean difference of a side of things of one category, as a share.
        forms: share of things of one category that are made otherwise: of other shapes, materials or colours.
        kinds: share of all things that are only in one of the two.
        surfaces: share of what floor and walls are finished with that differs.
    """

    room: float
    poses: float
    seen: float
    openings: float
    sizes: float
    forms: float
    kinds: float
    surfaces: float


def distance(a: Scene, b: Scene) -> Distance:
    """How much two rooms differ."""
    sides = [abs(math.log(x / y)) for x, y in zip(sorted(a.room.extent), sorted(b.room.extent), strict=True)]
    ours, theirs = _standing(a), _standing(b)
    laid = [_apart(ours, [_laid(spot, turn, mirrored) for spot in theirs]) for turn, mirrored in TURNS]
    pairs = list(_pairs(a, b))
    kinds = [Counter(p.category for p in scene.placements) for scene in (a, b)]
    common, all_of = (kinds[0] & kinds[1]).total(), (kinds[0] | kinds[1]).total()
    return Distance(
        room=statistics.mean(sides),
        poses=min(laid),
        seen=_apart(ours, theirs),
        openings=_apart(_openings(a), _openings(b)),
        sizes=_mean(abs(math.log(x / y)) for p, q in pairs for x, y in zip(p.size, q.size, strict=True)),
        forms=_mean(float(_made(a, p) != _made(b, q)) for p, q in pairs),
        kinds=1.0 - common / all_of if all_of else 0.0,
        surfaces=_mean(float(x != y) for x, y in zip(_finish(a), _finish(b), strict=True)),
    )


class _Spot(NamedTuple):
    """Something on the floor, seen from the middle of its room [m, degrees]."""

    category: str
    x: float
    y: float
    yaw: float


def _standing(scene: Scene) -> list[_Spot]:
    middle = [side / 2 for side in scene.room.extent]
    on_floor = [p for p in scene.placements if p.support == "floor"]
    return [_Spot(p.category, p.position[0] - middle[0], p.position[1] - middle[1], p.yaw) for p in on_floor]


def _openings(scene: Scene) -> list[_Spot]:
    walls, (width, depth) = scene.room.walls, scene.room.extent
    spots = []
    for opening in scene.room.openings:
        wall = walls[opening.wall]
        x, y = wall.point(opening.offset + opening.width / 2)
        spots.append(_Spot(opening.kind, x - width / 2, y - depth / 2, wall.yaw))
    return spots


def _laid(spot: _Spot, turn: int, mirrored: bool) -> _Spot:
    c, s = round(math.cos(math.radians(turn))), round(math.sin(math.radians(turn)))
    x, y, yaw = spot.x, (-spot.y if mirrored else spot.y), (-spot.yaw if mirrored else spot.yaw)
    return _Spot(spot.category, c * x - s * y, s * x + c * y, yaw + turn)


def _apart(ours: list[_Spot], theirs: list[_Spot]) -> float:
    """Mean distance of things of one category, the nearest first; ALONE for what is left over."""
    together = [
        (math.hypot(p.x - q.x, p.y - q.y) + abs((p.yaw - q.yaw + 180) % 360 - 180) / 180, i, j)
        for i, p in enumerate(ours)
        for j, q in enumerate(theirs)
        if p.category == q.category
    ]
    met, found = (set[int](), set[int]()), list[float]()
    for away, i, j in sorted(together):
        if i not in met[0] and j not in met[1]:
            met[0].add(i)
            met[1].add(j)
            found.append(away)
    return _mean([*found, *[ALONE] * (max(len(ours), len(theirs)) - len(found))])


def _pairs(a: Scene, b: Scene) -> "list[tuple[Placement, Placement]]":
    """Things of one category, in the order of their ids."""
    groups = [
        {
            category: sorted((p for p in scene.placements if p.category == category), key=lambda p: p.id)
            for category in {p.category for p in scene.placements}
        }
        for scene in (a, b)
    ]
    shared = sorted(groups[0].keys() & groups[1].keys())
    return [pair for category in shared for pair in zip(groups[0][category], groups[1][category], strict=False)]


def _made(scene: Scene, placement: Placement) -> Any:
    shapes = (shape for link in scene.asset_of(placement).links for shape in link.shapes)
    return Counter((shape.kind, shape.material, shape.colour) for shape in shapes)


def _finish(scene: Scene) -> list[Any]:
    made = msgspec.to_builtins(getattr(scene, "surfaces", None)) or {}
    return [made.get(part) for part in PARTS]


def _mean(values: Any) -> float:
    found = list(values)
    return statistics.mean(found) if found else 0.0


def main() -> int:
    """Print a row for each prompt and the means."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--prompt", action="append")
    arguments = parser.parse_args()
    rows = []
    print("| prompt | " + " | ".join(Distance._fields) + " |\n|---|" + "---:|" * len(Distance._fields))
    for prompt in arguments.prompt or PROMPTS:
        scenes = [generate_room(prompt, seed=seed).scene for seed in range(arguments.seeds)]
        between = [distance(a, b) for a, b in itertools.combinations(scenes, 2)]
        rows.append(Distance(*(statistics.mean(column) for column in zip(*between, strict=True))))
        print(f"| {prompt} | " + " | ".join(f"{value:.3f}" for value in rows[-1]) + " |", flush=True)
    means = [statistics.mean(column) for column in zip(*rows, strict=True)]
    print("| mean | " + " | ".join(f"{value:.3f}" for value in means) + " |")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
