"""What a policy is told of its answers: a line for each, with its pose, what was measured, and what would help."""

import math

from thinkblox.judging import Try
from thinkblox.scene.asset import Asset
from thinkblox.scene.nearby import nearest_shift
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.verdict import Reason, Verdict

HELPED: frozenset[Reason] = frozenset({"collision", "outside", "blocks_door", "blocks_window", "unsupported", "drop"})
"""What a shift may mend."""
FELT = 0.0005
"""Parts of a shift below this are not named [m]."""


def feedback_line(scene: Scene, id: str, tried: Try, asset: Asset) -> str:
    """One line on one try: "chair_1 at (0.10, 1.50, 0.00) turned to 0 degrees: reaches ...; move at least ...".

    Args:
        scene: in which it was tried.
        id: of the object that was asked about.
        tried: rejected or measured.
        asset: what its placement shows, where it has one.
    """
    if tried.rejection is not None:
        return f"{id}: not used: {tried.rejection.message}"
    if tried.verdict is None or tried.placement is None:
        return ""
    x, y, z = tried.placement.position
    measured = str(tried.verdict).removeprefix(f"{id}: ")
    pose = f"{id} at ({x:.2f}, {y:.2f}, {z:.2f}) turned to {tried.placement.yaw:g} degrees"
    help_ = "" if tried.valid else _help(scene, tried.placement, asset, tried.verdict)
    return f"{pose}: {measured}" + (f"; {help_}" if help_ else "")


def _help(scene: Scene, placement: Placement, asset: Asset, verdict: Verdict) -> str:
    """The turn and the shift that would help, in words; empty where nothing of that kind is wrong."""
    turn = f"turn it to {scene.room.wall(placement.support).yaw:g} degrees" if "faces_wall" in verdict.reasons else ""
    return "; ".join(words for words in (turn, _shift(scene, placement, asset, verdict)) if words)


def _shift(scene: Scene, placement: Placement, asset: Asset, verdict: Verdict) -> str:
    """The nearest place that seems free, as a shift in words."""
    if not HELPED.intersection(verdict.reasons):
        return ""
    found = nearest_shift(scene, asset, placement, clear_of=verdict.blocked)
    if found is None:
        return _no_place(scene, asset, placement)
    parts = [
        f"{math.ceil(abs(part) * 100 - 1e-6) / 100:.2f} m towards {'+' if part > 0 else '-'}{axis}"
        for axis, part in zip("xyz", found, strict=True)
        if abs(part) >= FELT
    ]
    return f"move at least {' and '.join(parts)}" if parts else ""


def _no_place(scene: Scene, asset: Asset, placement: Placement) -> str:
    """That the search found nothing, where it looked, and where it did not."""
    if asset.mount == "wall":
        walls = {wall.name for wall in scene.room.walls}
        where = f"along {placement.support}" if placement.support in walls else "along the wall"
        return f"no free place was found {where} at this height; another height or another wall may have one"
    if asset.mount == "surface":
        return "no free place was found at this height within 10 m, turned as it is; another surface may have one"
    return "no free place was found within 10 m, turned as it is; another turn may find one"
