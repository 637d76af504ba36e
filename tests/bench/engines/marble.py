"""A marble that is dropped into a mug: what is hollow must be hollow in every engine."""

from pathlib import Path
from typing import Any

import numpy as np

from tests.bench.engines.case import write_case
from thinkblox.assets import make_asset
from thinkblox.scene.asset import Asset, Link, Shape
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import placed_at

MUG, MARBLE = "cup_1", "marble_1"
_WIDE, _WEIGHS = 0.016, 0.0054
"""A marble of glass [m, kg]."""
_OVER = 0.01
"""From so far over the rim it is let go [m]."""


def marble_case(folder: Path) -> dict[str, Any]:
    """The case of a mug on the floor and a marble over it."""
    mug, scene = make_asset("cup", seed=0), Scene(room=rectangle(2.0, 2.0))
    scene = scene.with_placement(placed_at(scene, mug, id=MUG, position=(1.0, 1.0, 0.0), yaw=0.0), mug)
    x, y = _hollow(mug)
    start = (1.0 + x, 1.0 + y, mug.size[2] + _OVER)
    scene = scene.with_placement(placed_at(scene, _marble(), id=MARBLE, position=start, yaw=0.0), _marble())
    return write_case(scene, folder, {MARBLE: start})


def _hollow(mug: Asset) -> tuple[float, float]:
    """The middle of its bottom in its frame [m]: beside the handle it is round."""
    surface = mug.surfaces[0] if mug.surfaces else None
    return (0.0, 0.0) if surface is None else (surface.position[0], surface.position[1])


def _marble() -> Asset:
    ball = Shape(kind="sphere", size=(_WIDE,) * 3, position=(0.0, 0.0, _WIDE / 2), material="glass")
    return Asset(
        id="marble-0", category="marble", description="a marble", size=(_WIDE,) * 3, mass=_WEIGHS, friction=0.5,
        mount="surface", links=(Link(name="body", shapes=(ball,)),),
    )  # fmt: skip


def marble_told(case: dict[str, Any], poses: dict[str, Any]) -> str:
    """How high the marble ends over the bottom of the mug [mm], or that it is no longer in it."""
    rests = {thing["name"]: np.asarray(thing["rests"]) for thing in case["things"]}
    wanted = rests[MARBLE] - rests[MUG]
    found = np.subtract(poses[MARBLE][0], poses[MUG][0])
    beside = float(np.hypot(*(found - wanted)[:2]))
    return f"{1000.0 * found[2]:.1f}" if beside < 0.03 and abs(found[2] - wanted[2]) < 0.02 else "not in the mug"
