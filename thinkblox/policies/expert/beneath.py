"""Ideas under an anchor: on the floor between its legs, or against the wall below what hangs there."""

from collections.abc import Iterator

from thinkblox.assets import facts_of
from thinkblox.phrases import Constraint
from thinkblox.plan import Tie
from thinkblox.policies.expert.beside import beside_at
from thinkblox.policies.expert.idea import WALL_GAP, Idea
from thinkblox.policies.expert.situation import Situation
from thinkblox.scene.placement import Placement

STEP = 0.06
"""Between places that are tried [m]."""
PLACES = 9
"""Most places that are tried along each side."""
HIDDEN = 0.3
"""Cost of looking out to those who are served, rather than to who serves and opens it."""


def under_standing(situation: Situation, anchor: Placement, tie: Tie) -> Iterator[Idea]:
    """Between its legs, within its outline: several side by side along its longer side, one in the middle first."""
    served = facts_of(anchor.category).is_in("served_over")
    turns = {"any": (0.0,), "two": (0.0, 90.0)}.get(situation.asset.front, (0.0, 90.0, 180.0, 270.0))
    for turn in turns:
        depth, width = situation.size[:2] if turn % 180.0 == 0.0 else (situation.size[1], situation.size[0])
        free = ((anchor.size[0] - depth) / 2, (anchor.size[1] - width) / 2)
        if min(free) < 0.0:
            continue
        long = 1 if anchor.size[1] >= anchor.size[0] else 0
        wanted = [0.0, 0.0]
        wanted[long] = ((tie.index + 0.5) / tie.count * 2 - 1) * anchor.size[long] / 2 if tie.count > 1 else 0.0
        for x in _places(free[0]):
            for y in _places(free[1]):
                cost = 0.8 * (abs(x - wanted[0]) + abs(y - wanted[1])) + (0.3 if turn % 180.0 else 0.0)
                cost += HIDDEN * (served and turn == 0.0)
                yield beside_at(
                    situation,
                    anchor,
                    (x, y),
                    yaw=anchor.yaw + turn,
                    words=(Constraint(kind="under", anchors=(anchor.id,)),),
                    why=f"there is room under {anchor.id}",
                    cost=cost,
                    ignore=(anchor.id,),
                )


def _places(free: float) -> tuple[float, ...]:
    count = max(1, min(PLACES, 1 + 2 * round(free / STEP)))
    return tuple(free * (2 * n / (count - 1) - 1) if count > 1 else 0.0 for n in range(count))


def under_hung(situation: Situation, anchor: Placement) -> Iterator[Idea]:
    """Against the wall below it, middle under middle first."""
    out = WALL_GAP + (situation.size[0] - anchor.size[0]) / 2
    for rank, aside in enumerate((0.0, 0.08, -0.08, 0.16, -0.16, 0.3, -0.3)):
        yield beside_at(
            situation,
            anchor,
            (out, aside),
            yaw=anchor.yaw,
            words=(Constraint(kind="under", anchors=(anchor.id,)),),
            why=f"it belongs under {anchor.id}",
            cost=0.1 * rank,
        )
