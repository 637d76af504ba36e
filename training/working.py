"""The sums between reasoning and answer, written out: a small model that is shown them learns to do them."""

from collections.abc import Iterator

from thinkblox.phrases import Constraint, planned_constraints
from thinkblox.scene.agreement import wall_gap
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.steps import Step, write_step
from thinkblox.value import Vec3

_LETTERS = "xyz"


def worked_out(scene: Scene, step: Step, placement: Placement) -> str:
    """A step's text in whole centimetres and degrees, with a line of sums before the answer.

    The height keeps its millimetres: what stands on something must neither sink into it nor fall onto it.
    """
    x, y, z = placement.position
    position = (round(x, 2), round(y, 2), round(z, 3))
    lines = [line.partition(". ")[2] or line for line in step.think.splitlines() if line.strip()]
    sums = [f"{_LETTERS[axis]} = {_sum(scene, step, placement, axis, position)}" for axis in (0, 1)]
    lines.append(", ".join([*sums, f"z = {_number(position[2], 3)}"]) + ".")
    size = (round(placement.size[0], 2), round(placement.size[1], 2), round(placement.size[2], 2))
    return write_step(lines, id=step.id, position=position, yaw=round(placement.yaw) % 360, size=size)


def _sum(scene: Scene, step: Step, placement: Placement, axis: int, position: Vec3) -> str:
    """The terms of one coordinate, from the first phrase that gives it; the number alone where none does."""
    for constraint in planned_constraints(step):
        terms = [round(term, 2) for term in _terms(scene, constraint, placement, axis)]
        if len(terms) > 1:
            terms[-1] = round(position[axis] - sum(terms[:-1]), 2)
            said = "".join(f" {'-' if term < 0 else '+'} {_number(abs(term))}" for term in terms[1:])
            return f"{_number(terms[0])}{said} = {_number(position[axis])}"
    return _number(position[axis])


def _terms(scene: Scene, c: Constraint, placement: Placement, axis: int) -> Iterator[float]:
    """What adds up to a coordinate by one phrase; nothing where the phrase does not give that coordinate."""
    middle = placement.position[axis]
    if c.kind in ("from_wall", "against"):
        wall = scene.room.wall(c.anchors[0])
        if abs(wall.inward[axis]) > 0.999:
            sign, line = wall.inward[axis], wall.start[axis]
            gap = wall_gap(wall, placement)
            yield from (line, sign * gap, middle - line - sign * gap)
    elif c.kind == "beside":
        anchor = scene[c.anchors[0]]
        ahead = anchor.front if c.side in ("front", "back") else anchor.left
        if abs(ahead[axis]) > 0.999:
            half = anchor.size[0 if c.side in ("front", "back") else 1] / 2
            sign = 1.0 if middle > anchor.position[axis] else -1.0
            rest = middle - anchor.position[axis] - sign * (half + c.values[0])
            yield from (anchor.position[axis], sign * half, sign * c.values[0], rest)
    elif c.kind in ("offset", "centred"):
        anchor = scene[c.anchors[0]]
        yield from (anchor.position[axis], middle - anchor.position[axis])


def _number(value: float, digits: int = 2) -> str:
    return f"{value + 0.0:.{digits}f}"
