"""How strictly a pose is measured: as usual, so that it is still, or so that it just touches."""

from dataclasses import dataclass

from msgspec import structs

from thinkblox.scene.scene import Scene
from thinkblox.sim.settings import Physics, Tolerances, Walking
from thinkblox.sim.verdict.world import World

TIGHT = 0.0005
"""What was moved is left within this of touching what it rests on or hangs on [m]."""
STILL = 0.1
"""What was moved tilts less than this while settling [degrees]: nothing is left on the brink."""


@dataclass(frozen=True)
class Rules:
    """The settings of a mending; `tries` poses are measured at most for one object, which goes `furthest` [m]."""

    tolerances: Tolerances
    physics: Physics
    walking: Walking
    tries: int
    furthest: float

    @property
    def still(self) -> Tolerances:
        """Tolerances for what is moved, so that it is not left on the brink."""
        usual = self.tolerances
        return structs.replace(usual, drift=min(usual.drift, TIGHT), tilt=min(usual.tilt, STILL))

    @property
    def tight(self) -> Tolerances:
        """Besides, so that it just touches what it rests on, hangs on and stands beside."""
        usual = self.still
        return structs.replace(
            usual,
            penetration=min(usual.penetration, TIGHT / 5),
            outside=min(usual.outside, TIGHT / 5),
            touching=min(usual.touching, TIGHT),
            clearance=min(usual.clearance, TIGHT),
            drop=min(usual.drop, TIGHT),
        )

    def world(self, scene: Scene, tolerances: Tolerances | None = None) -> World:
        """The scene, ready to measure in."""
        return World(scene, tolerances=tolerances or self.tolerances, physics=self.physics, walking=self.walking)
