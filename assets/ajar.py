"""Doors that stand open: the same thing, with what swings swung out, in a box that has room for it."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from msgspec import structs

from thinkblox.assets.facts import Facts
from thinkblox.assets.part import Build, MovingParts, bounds, turned
from thinkblox.assets.sizing import OPEN
from thinkblox.scene.asset import Link
from thinkblox.value import Vec3

_WIDE = 90.0
"""How far a door that stands open is swung, at most [degrees]."""
_MOST = 2
"""Doors of one thing that stand open at most: the pair of a wardrobe."""
_LEAST = 0.3
"""Least share of its depth that is left to what the doors belong to."""


def stands_open(kind: Facts, words: frozenset[str]) -> bool:
    """Whether words ask for a thing with its doors open, which is made so by itself."""
    return OPEN in words and OPEN in kind.states


def ajar(make: Callable[[Vec3], Build], size: Vec3) -> Build:
    """The build of a thing with doors, or the first of its doors, swung out within a box of that size [m]."""
    shut = make(size)
    if not _doors(shut):
        return shut
    reach = bounds(_swung(shut).parts)[1][0] - bounds(shut.parts)[1][0]
    return _swung(make((max(size[0] - reach, _LEAST * size[0]), size[1], size[2])))


def has_open_door(links: Sequence[Link]) -> bool:
    """Whether a door of it stands open: it can be swung back further than on."""
    return any(link.joint is not None and link.joint.lower < -link.joint.upper for link in links)


def depth_before(links: Sequence[Link], size: Vec3) -> float:
    """How much of the depth of a thing its open doors take; 0 where none stands open [m]."""
    if not has_open_door(links):
        return 0.0
    front = max(shape.position[0] + shape.size[0] / 2 for shape in links[0].shapes)
    return max(0.0, round(size[0] / 2 - front, 4))


def _doors(build: Build) -> list[MovingParts]:
    """What opens of it: a pair of doors, or the first."""
    hinged = [moving for moving in build.moving if moving.joint.kind == "hinge"]
    first = hinged[:1]
    pair = [m for m in hinged[1:] if first and _is_pair(first[0], m)]
    return [*first, *pair][:_MOST]


def _is_pair(one: MovingParts, other: MovingParts) -> bool:
    """Whether two doors are hung at opposite sides, at one height."""
    level = abs(one.joint.anchor[2] - other.joint.anchor[2]) < 0.05
    return level and one.joint.axis[2] == -other.joint.axis[2] != 0.0


def _swung(build: Build) -> Build:
    doors = {door.name for door in _doors(build)}
    moving = [_swung_out(m) if m.name in doors else m for m in build.moving]
    return replace(build, moving=moving)


def _swung_out(door: MovingParts) -> MovingParts:
    joint = door.joint
    wide = min(_WIDE, joint.upper)
    axis = max(range(3), key=lambda k: abs(joint.axis[k]))
    turn = wide if joint.axis[axis] > 0 else -wide
    parts = tuple(turned(part, axis, turn, joint.anchor) for part in door.parts)
    swung = structs.replace(joint, lower=joint.lower - wide, upper=joint.upper - wide)
    return MovingParts(door.name, parts, swung)
