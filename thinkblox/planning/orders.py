"""Other orders than the plan's, for comparison: large things first, or any."""

import math
from collections.abc import Callable

import numpy as np
from msgspec.structs import replace

from thinkblox.orders import Order
from thinkblox.plan import Plan, Target, carries, in_order
from thinkblox.scene.asset import Mount
from thinkblox.value import Vec3

Known = Callable[[Target], tuple[Vec3, Mount] | None]
"""Size [m] and mount of an ordinary thing such as a target is; None where it is not known."""


def reordered(plan: Plan, order: Order, known: Known, seed: int) -> Plan:
    """The plan with its objects in another order, none before what it depends on.

    What may stand on any surface depends on all that stands on the floor.
    """
    if order == "plan":
        return plan
    usual = {target.id: known(target) for target in plan.targets}
    if order == "size":
        preferred = sorted(plan.targets, key=lambda target: -_volume(target, usual[target.id]))
    else:
        places = np.random.default_rng((seed, len(plan.targets))).permutation(len(plan.targets))
        preferred = [plan.targets[int(place)] for place in places]
    late = {target.id for target in plan.targets if _floats(target, usual[target.id])}
    return replace(plan, targets=tuple(in_order(sorted(preferred, key=lambda target: target.id in late))))


def _volume(target: Target, usual: tuple[Vec3, Mount] | None) -> float:
    """Volume of its box [m3]."""
    sizes = zip(target.size, usual[0] if usual else (0.0, 0.0, 0.0), strict=True)
    return math.prod(wanted or ordinary for wanted, ordinary in sizes)


def _floats(target: Target, usual: tuple[Vec3, Mount] | None) -> bool:
    """Whether it stands on something, and no relation says on what."""
    return usual is not None and usual[1] == "surface" and not any(map(carries, target.ties))
