"""What stands on a rug: rugs are walked on and collide with nothing, so it is measured on the floor under them."""

from collections.abc import Sequence
from dataclasses import replace

from shapely import Point, Polygon, affinity, box

from thinkblox.importing.body import ItemBody
from thinkblox.importing.usual import is_rug
from thinkblox.scene.asset import Mount

ON = 0.01
"""How far a base may be from the top of what it stands on [m]."""
THIN = 0.005
"""What stands on a rug no thicker than this is left as high as it is [m]."""


def off_rugs(bodies: Sequence[ItemBody], mounts: Sequence[Mount]) -> tuple[list[ItemBody], tuple[int, ...]]:
    """The bodies with those that stand on a rug, and all that they carry, lower by its thickness; and which these are.

    Args:
        bodies: at their poses in the room.
        mounts: theirs, in the same order; what hangs stays.
    """
    areas = [_area(body) for body in bodies]
    rugs = [k for k, body in enumerate(bodies) if is_rug(body.item.kind, body.size[2]) and body.size[2] > THIN]
    lower: dict[int, float] = {}
    for k in sorted(range(len(bodies)), key=lambda k: bodies[k].position[2]):
        if k in rugs or mounts[k] in ("wall", "ceiling"):
            continue
        x, y, base = bodies[k].position
        under = [r for r in rugs if abs(base - _top(bodies[r])) <= ON and areas[r].intersects(areas[k])]
        if under:
            # A rug that is sunk into the floor takes nothing along.
            lower[k] = base - max(0.0, min(bodies[r].position[2] for r in under))
            continue
        carriers = [c for c in lower if bodies[c].position[2] < base <= _top(bodies[c]) + ON]
        carried = [lower[c] for c in carriers if areas[c].contains(Point(x, y))]
        if carried:
            lower[k] = carried[0]
    return [_lowered(body, lower.get(k, 0.0)) for k, body in enumerate(bodies)], tuple(sorted(lower))


def _lowered(body: ItemBody, by: float) -> ItemBody:
    x, y, z = body.position
    return replace(body, position=(x, y, z - by)) if by else body


def _top(body: ItemBody) -> float:
    return body.position[2] + body.size[2]


def _area(body: ItemBody) -> Polygon:
    """The box round it, seen from above."""
    x, y, _ = body.position
    dx, dy = body.size[0] / 2, body.size[1] / 2
    return affinity.rotate(box(x - dx, y - dy, x + dx, y + dy), body.yaw, origin=(x, y))
