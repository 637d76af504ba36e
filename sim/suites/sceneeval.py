"""SceneEval's geometric metrics: collision, out of bound, support, navigability, accessibility, opening clearance."""

import numpy as np

from thinkblox.sim.subject import Subject
from thinkblox.sim.suites.clearance import clearance
from thinkblox.sim.suites.collision import collision
from thinkblox.sim.suites.criteria import paragraphs, result
from thinkblox.sim.suites.floorplan import accessibility, navigability
from thinkblox.sim.suites.inside import out_of_bound
from thinkblox.sim.suites.meshes import Meshes
from thinkblox.sim.suites.standing import support
from thinkblox.suite import SuiteResult

SOURCE = (
    "Tam et al., SceneEval: Evaluating Semantic Coherence in Text-Conditioned 3D Indoor Scene Synthesis, 2025, "
    "https://arxiv.org/abs/2503.14756; as in metrics/ of https://github.com/3dlg-hcvc/SceneEval"
)
NOTES = paragraphs(
    """
    Measured at the start, on what the engine collides with (convex hulls of meshes; round shapes to 1 mm); the source
    measures visual meshes. Things without colliding geometry (rugs) are left out; in the source they count.

    Metrics that need a language model's judgement of meaning are not part of this suite. Where the source asks one for
    the support type, it is what the scene says that the object rests on, and in models that say nothing: down, for
    whatever is free.

    Where it asks one for the functional sides, it is the front for what has one, front, left and right for beds, and
    all four sides for chairs, stools and whatever has no front; only for what stands on the floor.

    Navigability and accessibility are scores without a threshold in the source; the limits of 0.9 and 0.25 are ours.

    Areas of strips and openings are exact instead of counted in pixels, navigability is counted in 256 pixels as there.
    A floor is 5 cm thick, and its edge belongs to it. It lies where the scene has it; in the source it is laid under
    the lowest vertex of all objects, so that nothing there is sunk into it and one sunken thing makes all others float.
    """
)


def run(subject: Subject, *, seed: int = 0) -> SuiteResult:
    """All geometric criteria of SceneEval; the seed is of the points sampled on surfaces."""
    meshes = Meshes(subject)
    generator = np.random.default_rng(seed)
    criteria = [
        collision(meshes),
        support(meshes, generator),
        navigability(meshes),
        accessibility(meshes),
        out_of_bound(meshes, generator),
        clearance(meshes),
    ]
    return result("sceneeval", SOURCE, criteria, NOTES)
