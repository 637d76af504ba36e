"""Rooms of objects made of eight convex meshes each, with eight candidates for one more, of which four stand."""

import math
from typing import NamedTuple

import numpy as np

from thinkblox.scene.asset import Asset, Link, Shape, Surface
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec2, Vec3

KINDS = 12
"""Different pieces of furniture in a room; what stands there is drawn from them."""
PITCH = 1.7
"""Distance from one object to the next [m]."""
EIGHT = (0, 1, 2, 3, 4, 5, 6, 7)


class Step(NamedTuple):
    """A scene, what is to be placed next, and eight poses for it: the first four are meant to stand."""

    scene: Scene
    asset: Asset
    candidates: tuple[Placement, ...]


def step(objects: int, seed: int) -> Step:
    """A room of `objects` things, a third of them on top of others, drawn from a seed."""
    rng = np.random.default_rng(seed)
    kinds = [_furniture(f"kind{k}", rng) for k in range(KINDS)]
    small = [_small(f"small{k}", rng) for k in range(KINDS)]
    standing = math.ceil(objects * 2 / 3)
    columns = math.ceil(math.sqrt(standing * 1.25))
    side = columns * PITCH
    spots = [((i % columns + 0.5) * PITCH, (i // columns + 0.5) * PITCH) for i in range(columns * columns)]
    order = rng.permutation(len(spots))
    taken, free = order[:standing], order[standing:]
    scene = Scene(room=rectangle(side, side), seed=seed)
    for number, spot in enumerate(taken):
        asset = kinds[int(rng.integers(KINDS))]
        x, y = spots[spot]
        scene = scene.with_placement(_put(asset, f"thing_{number}", (x, y, 0.0), float(rng.uniform(0, 360))), asset)
    carriers = scene.placements
    for number in range(objects - standing):
        carrier, asset = carriers[number], small[int(rng.integers(KINDS))]
        place = (*carrier.position[:2], round(carrier.top, 6))
        scene = scene.with_placement(_put(asset, f"small_{number}", place, 10.0 * number, on=carrier.id), asset)
    chair = _furniture("chair", rng)
    return Step(scene, chair, _candidates(chair, [spots[i] for i in free], carriers, side, rng))


def _candidates(
    chair: Asset, free: list[Vec2], taken: tuple[Placement, ...], side: float, rng: np.random.Generator
) -> tuple[Placement, ...]:
    yaw = [float(a) for a in rng.uniform(0, 360, 8)]
    good = [(*free[i % len(free)], 0.001) for i in range(4)]
    (x, y, _), (u, v, _) = taken[0].position, taken[1].position
    sunk = [(x + 0.1, y, taken[0].top - 0.03), (u, v + 0.15, taken[1].top - 0.05)]
    bad = [*sunk, (side - 0.1, side / 2, 0.0), (*free[0], 0.6)]
    return tuple(_put(chair, "chair_1", place, turn) for place, turn in zip(good + bad, yaw, strict=True))


def _put(asset: Asset, id: str, position: Vec3, yaw: float, *, on: str = "floor") -> Placement:
    return Placement(
        id=id, category=asset.category, asset=asset.id, position=position, yaw=yaw, size=asset.size, support=on
    )


def _furniture(name: str, rng: np.random.Generator) -> Asset:
    """A table of eight hulls: four legs, three boards under the top, and the top."""
    x, y, z = (float(v) for v in rng.uniform((0.5, 0.5, 0.45), (0.8, 0.8, 0.9)))
    legs = [
        _block((sx * (x / 2 - 0.04), sy * (y / 2 - 0.04), (z - 0.04) / 2), (0.06, 0.06, z - 0.04), rng)
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    boards = [_block((0.0, dy, z - 0.08), (x - 0.2, 0.04, 0.06), rng) for dy in (-y / 4, 0.0, y / 4)]
    top = _block((0.0, 0.0, z - 0.02), (x, y, 0.04), rng)
    return _asset(name, (x, y, z), [*legs, *boards, top], mass=18.0, mount="floor")


def _small(name: str, rng: np.random.Generator) -> Asset:
    """Eight blocks in a ring, a bowl of sorts."""
    size = float(rng.uniform(0.18, 0.26))
    blocks = []
    for i in EIGHT:
        angle = i * math.pi / 4
        arm = size / 2 - 0.03
        blocks.append(_block((arm * math.cos(angle), arm * math.sin(angle), 0.04), (0.06, 0.06, 0.08), rng))
    return _asset(name, (size, size, 0.08), blocks, mass=0.8, mount="surface")


def _block(centre: Vec3, size: Vec3, rng: np.random.Generator) -> Shape:
    """A hull of 16 corners that fills its box's height: a prism over an octagon that is not quite regular."""
    angles = np.arange(8) * math.pi / 4 + math.pi / 8 + rng.uniform(-0.1, 0.1, 8)
    ring = np.stack([np.cos(angles), np.sin(angles)], 1)
    ring = ring / np.abs(ring).max(0) * (np.array(size[:2]) / 2)
    points = [(float(px), float(py), float(pz)) for pz in (-size[2] / 2, size[2] / 2) for px, py in ring]
    return Shape(kind="hull", size=size, position=centre, points=tuple(points))


def _asset(name: str, size: Vec3, shapes: list[Shape], *, mass: float, mount: str) -> Asset:
    return Asset(
        id=f"{name}-0",
        category=name,
        description=name,
        size=size,
        mass=mass,
        friction=0.6,
        mount=mount,  # type: ignore[arg-type]
        links=(Link(name="body", shapes=tuple(shapes)),),
        surfaces=(Surface(name="top", position=(0.0, 0.0, size[2]), size=size[:2]),),
    )
