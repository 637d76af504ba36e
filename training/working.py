"""The way from what is wanted to a pose, in numbers that can be copied: a small model learns to follow it."""

from thinkblox.compact import IT, number
from thinkblox.free_places import Stretch, free_places
from thinkblox.observe import Observation
from thinkblox.phrases import planned_constraints, wall_words
from thinkblox.plan import is_object
from thinkblox.scene.placement import Placement
from thinkblox.steps import Step, write_step
from thinkblox.value import Vec3

NEAR = 0.06
"""How far a placement may be from the line of a free stretch that it is said to be in [m]."""


def worked_out(seen: Observation, step: Step, placement: Placement) -> str:
    """A step's text in whole centimetres and degrees: why, where there is space, and the place there.

    The object is called as compact words call it.
    The height keeps its millimetres: what stands on something must neither sink into it nor fall onto it.
    """
    x, y, z = placement.position
    position = (round(x, 2), round(y, 2), round(z, 3))
    yaw = round(placement.yaw) % 360
    size = (round(placement.size[0], 2), round(placement.size[1], 2), round(placement.size[2], 2))
    said = [line.partition(". ")[2] or line for line in step.think.splitlines() if line.strip()]
    why = said[1] if len(said) > 2 else said[0]
    lines = [why, _space(seen, placement), _so(step, placement, position, yaw)]
    return spaced(write_step(lines, id=IT, position=position, yaw=yaw, size=size))


def spaced(text: str) -> str:
    """A step's text with a space before every number of its answer, as numbers have it everywhere else."""
    think, tag, answer = text.partition("<answer>")
    return think + tag + answer.replace("[", "[ ").replace(",", ", ").replace(":", ": ")


def _space(seen: Observation, placement: Placement) -> str:
    """Which of the free stretches that a policy is told of the placement is in."""
    found = _stretch(free_places(seen.layout, seen.target, seen.asset), placement)
    if found is None:
        return "None of the free lines is taken."
    ends = dict.fromkeys(f"( {number(x)}, {number(y)})" for x, y, _ in (found.start, found.end))
    return f"Free {found.by}: {' to '.join(ends)}."


def _stretch(stretches: tuple[Stretch, ...], placement: Placement) -> Stretch | None:
    def turned(stretch: Stretch) -> bool:
        return abs((stretch.yaw - placement.yaw + 180.0) % 360.0 - 180.0) > 1.0

    fit = [s for s in stretches if s.distance(placement.position) <= NEAR]
    return min(fit, key=lambda s: (turned(s), s.distance(placement.position)), default=None)


def _so(step: Step, placement: Placement, position: Vec3, yaw: float) -> str:
    """The pose in phrases that can be read back."""
    x, y, z = position
    walls = [constraint.anchors[0] for constraint in planned_constraints(step) if constraint.kind == "against"]
    held = "".join(f"against {wall_words(wall)}, " for wall in walls[:1])
    if is_object(placement.support):
        held = f"on {placement.support}, "
    above = "" if z <= 0.0 else f", {number(z, 3)} m above the floor"
    return f"So it goes {held}at ( {number(x)}, {number(y)}), turned to {number(yaw)} degrees{above}."
