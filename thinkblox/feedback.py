"""What a policy is told of its answers: a line for each, with its pose, what was measured, and what would help."""

import math

from thinkblox.judging import Try
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.geometry.shifts import shifts
from thinkblox.sim.settings import Walking
from thinkblox.verdict import Reason

HELPED: frozenset[Reason] = frozenset({"collision", "outside", "blocks_door", "blocks_window", "unsupported", "drop"})
"""What a shift may mend."""
FELT = 0.0005
"""Parts of a shift below this are not named [m]."""


def feedback_line(scene: Scene, id: str, tried: Try, asset: Asset, walking: Walking) -> str:
    """One line on one try: "chair_1 at (0.10, 1.50, 0.00) turned to 0 degrees: reaches ...; move at least ...".

    Args:
        scene: in which it was tried.
        id: of the object that was asked about.
        tried: rejected or measured.
        asset: what its placement shows, where it has one.
        walking: which zones before doors and windows stay free.
    """
    if tried.rejection is not None:
        return f"{id}: not used: {tried.rejection.message}"
    if tried.verdict is None or tried.placement is None:
        return ""
    x, y, z = tried.placement.position
    measured = str(tried.verdict).removeprefix(f"{id}: ")
    pose = f"{id} at ({x:.2f}, {y:.2f}, {z:.2f}) turned to {tried.placement.yaw:g} degrees"
    help_ = "" if tried.valid else _help(scene, tried.placement, asset, walking, tried.verdict.reasons)
    return f"{pose}: {measured}" + (f"; {help_}" if help_ else "")


def _help(scene: Scene, placement: Placement, asset: Asset, walking: Walking, reasons: tuple[Reason, ...]) -> str:
    """The nearest place that seems free, as a shift in words; empty where there is none nearby."""
    if not HELPED.intersection(reasons):
        return ""
    there = scene.with_placement(placement, asset)
    riders = scene.riders(placement.id) if placement.id in scene else ()
    near = shifts(there, placement, riders, walking)
    if not near:
        return "nothing within 2 m of there is free"
    by = (b - a for a, b in zip(placement.position, near[0].placement.position, strict=True))
    parts = [
        f"{math.ceil(abs(part) * 100 - 1e-6) / 100:.2f} m towards {'+' if part > 0 else '-'}{axis}"
        for axis, part in zip("xyz", by, strict=True)
        if abs(part) >= FELT
    ]
    return f"move at least {' and '.join(parts)}" if parts else ""
