"""Moving things on the floor apart together, each by a little, where no single move is short enough.

Every two pieces that overlap are pushed apart along the direction in which they do so least, every piece that is in a
wall out of it, again and again, each thing by the more the lighter it is and none further than it may go: position
based dynamics (M. Mueller et al., J. Visual Communication and Image Representation 18, 2007) of things without speed.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.geometry.free_space import SKIN, FlatPiece, floor_plane, pieces_of, zone_pieces
from thinkblox.sim.settings import Walking

Array = NDArray[np.float64]
ROUNDS = 150
"""How often all that overlaps is pushed apart."""
DRAWN = 0.6
"""For this share of the rounds everything is drawn back to where it was, so that it moves no further than it must."""
BACK = 0.005
"""By how much [share of the way]."""
GAP = 0.0004
"""What is pushed apart is left so far apart [m]."""
NEGLIGIBLE = 5e-5
"""Less than this is left over where it went well [m]."""


@dataclass(frozen=True)
class _Pair:
    """Two pieces of which at least one can move: the directions from one to the other, and the gaps along them.

    Attributes:
        one, other: the groups that they belong to; None for what stays.
        directions: unit vectors (n, 2) square to the edges of both.
        gaps: between them along each direction, as everything was; negative where they overlap [m].
    """

    one: int | None
    other: int | None
    directions: Array
    gaps: Array


@dataclass(frozen=True)
class _Bound:
    """A piece of a group and a wall: the wall's direction into the room, and how far inside the piece is [m]."""

    group: int
    inward: Array
    inside: float


def parted(scene: Scene, groups: Sequence[Sequence[str]], walking: Walking, *, furthest: float) -> dict[str, Array]:
    """By how much each group is to be moved on the floor so that nothing overlaps any more, where that can be [m].

    Args:
        scene: with things in each other or in the walls.
        groups: ids of what moves as one: a thing on the floor, first, and all that it carries. All else stays.
        walking: says which zones of doors and windows stay free.
        furthest: how far each is moved at most [m].

    Returns:
        (east, north) for the first of each group that moves. What could not be parted is as little in the other as may
        be, so that what comes out is to be measured.
    """
    owner = {id: number for number, group in enumerate(groups) for id in group}
    weights = np.array([1.0 / np.sqrt(sum(scene.asset_of(scene[id]).mass for id in group)) for group in groups])
    pieces = [(owner.get(p.id), piece) for p in scene.placements for piece in _pieces(scene, p)]
    zones = [(None, piece) for piece in zone_pieces(scene.room, walking, windows=True)]
    pairs = [
        pair
        for number, (one, piece) in enumerate(pieces)
        for other, against in (*pieces[:number], *zones)
        if one != other and (pair := _pair(one, piece, other, against, furthest)) is not None
    ]
    bounds = [bound for one, piece in pieces if one is not None for bound in _bounds(scene.room, one, piece)]
    moved = _pushed(np.zeros((len(groups), 2)), pairs, bounds, weights, furthest)
    return {group[0]: by for group, by in zip(groups, moved, strict=True) if np.linalg.norm(by) > NEGLIGIBLE}


def _pieces(scene: Scene, placement: Placement) -> Sequence[FlatPiece]:
    asset = scene.asset_of(placement)
    return pieces_of(floor_plane(scene.room), placement, asset) if asset.collides else ()


def _pair(one: int | None, a: FlatPiece, other: int | None, b: FlatPiece, furthest: float) -> _Pair | None:
    """Two pieces that could come to overlap, one of which can move."""
    if min(a.high, b.high) - max(a.low, b.low) <= SKIN:
        return None
    mine, theirs = _corners(a), _corners(b)
    directions = np.concatenate([_normals(mine), -_normals(theirs)])
    gaps = (directions @ theirs.T).min(1) - (directions @ mine.T).max(1)
    return None if gaps.max() > 2 * furthest else _Pair(one, other, directions, gaps)


def _corners(piece: FlatPiece) -> Array:
    return np.asarray(shapely.get_coordinates(shapely.convex_hull(shapely.MultiPoint(piece.corners)))[:-1])


def _normals(corners: Array) -> Array:
    """Outward unit normals of the edges of a convex polygon, whichever way round it is."""
    edges = np.roll(corners, -1, axis=0) - corners
    normals = np.stack([edges[:, 1], -edges[:, 0]], 1) / np.linalg.norm(edges, axis=1)[:, None]
    inwards = ((corners - corners.mean(0)) * normals).sum(1) < 0.0
    return np.asarray(np.where(inwards[:, None], -normals, normals), np.float64)


def _bounds(room: Room, group: int, piece: FlatPiece) -> list[_Bound]:
    """The walls that a piece is beside."""
    found = []
    for wall in room.walls:
        ahead, across = np.array(wall.along), np.array(wall.inward)
        along = (piece.corners - np.array(wall.start)) @ ahead
        if along.max() > 0.0 and along.min() < wall.length:
            found.append(_Bound(group, across, float(((piece.corners - np.array(wall.start)) @ across).min())))
    return found


def _pushed(moved: Array, pairs: Sequence[_Pair], bounds: Sequence[_Bound], weights: Array, furthest: float) -> Array:
    for number in range(ROUNDS):
        if number < DRAWN * ROUNDS:
            moved *= 1.0 - BACK
        left = max(
            [_pushed_in(moved, b) for b in bounds] + [_pushed_apart(moved, p, weights) for p in pairs], default=0
        )
        lengths = np.linalg.norm(moved, axis=1)
        moved *= np.minimum(1.0, furthest / np.maximum(lengths, 1e-12))[:, None]
        if left < NEGLIGIBLE:
            break
    return moved


def _pushed_in(moved: Array, bound: _Bound) -> float:
    """Push a piece out of a wall; returns by how much it was in it."""
    inside = bound.inside + float(bound.inward @ moved[bound.group])
    if inside < 0.0:
        moved[bound.group] -= inside * bound.inward
    return -inside


def _pushed_apart(moved: Array, pair: _Pair, weights: Array) -> float:
    """Push two pieces apart along the direction in which they overlap least; returns by how much they did."""
    one, other = pair.one, pair.other
    by = np.zeros(2)
    if other is not None:
        by = by + moved[other]
    if one is not None:
        by = by - moved[one]
    gaps = pair.gaps + pair.directions @ by
    widest = int(np.argmax(gaps))
    short = GAP - float(gaps[widest])
    if short > 0.0:
        mine, theirs = (0.0 if group is None else weights[group] for group in (one, other))
        push = pair.directions[widest] * short / (mine + theirs)
        if one is not None:
            moved[one] -= push * mine
        if other is not None:
            moved[other] += push * theirs
    return short
