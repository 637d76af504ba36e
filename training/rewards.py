"""The rewards of the ThinkBLOX paper, and two of the settle: pure functions of what became of each rollout.

Each has the signature of a reward function of TRL: called with the columns of a batch, among them "outcome" (an
`Rollout` for each completion, from `thinkblox.training.outcome.outcomes`), it gives a number for each, None where it
does not apply to the object. A text that cannot be used gets the floor of every reward that does: a policy must not do
better by saying nothing.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any

from thinkblox.training.outcome import Rollout
from thinkblox.verdict import Verdict

Reward = Callable[..., list[float | None]]
DRIFT, DROP, TILT = 0.05, 0.05, 30.0
"""Motions in the settle that count fully against a placement [m, m, degrees]."""
NEVER = 1.0
"""What reasoning that says nothing of the pose counts as: as far from the answer as it can be."""


def r_format(*, outcome: Sequence[Rollout], **_: Any) -> list[float | None]:
    """0 for a text that can be used, -1 otherwise (ThinkBLOX, R_format)."""
    return [0.0 if each.parsed else -1.0 for each in outcome]


def r_coll(*, outcome: Sequence[Rollout], **_: Any) -> list[float | None]:
    """-tanh(5 sum of rho), rho being the share of its volume that is in each other object (ThinkBLOX, R_coll)."""
    return [_measured(each, lambda verdict: verdict.r_coll) for each in outcome]


def r_layout(*, outcome: Sequence[Rollout], **_: Any) -> list[float | None]:
    """-tanh of how far it reaches out of the room in metres (ThinkBLOX, R_layout)."""
    return [_measured(each, lambda verdict: verdict.r_layout) for each in outcome]


def r_support(*, outcome: Sequence[Rollout], **_: Any) -> list[float | None]:
    """0 for what something carries where it is put, or the floor; -1 for what falls, or hangs at nothing."""
    return [_measured(each, _support) for each in outcome]


def r_settle(*, outcome: Sequence[Rollout], **_: Any) -> list[float | None]:
    """-tanh(drift / 5 cm + drop / 5 cm + tilt / 30 degrees) in the settle; -1 for what is not settled or restless."""
    return [_measured(each, _settle) for each in outcome]


def r_valid(*, outcome: Sequence[Rollout], **_: Any) -> list[float | None]:
    """0 for a placement that nothing speaks against, -1 for any other: the gate of the generator itself."""
    return [_measured(each, lambda verdict: 0.0 if verdict.valid else -1.0) for each in outcome]


def r_align(*, outcome: Sequence[Rollout], **_: Any) -> list[float | None]:
    """Cosine between the front and the direction to what the object serves (ThinkBLOX, R_align); None without one.

    A desk that is worked at from its front serves what one sees from there: its back counts.
    """
    return [None if each.case.served is None else -1.0 if not each.parsed else each.alignment for each in outcome]


def r_rules(*, outcome: Sequence[Rollout], **_: Any) -> list[float | None]:
    """Share of the relations wanted of the object that hold, 0 to 1; None where none can be told: a judge by rules."""
    return [
        None if not each.case.told else 0.0 if each.holds is None else sum(each.holds) / len(each.holds)
        for each in outcome
    ]


def r_cons(*, outcome: Sequence[Rollout], **_: Any) -> list[float | None]:
    """-dist(planned(reasoning), action) (ThinkBLOX, R_cons), at least -1.

    The distance is the mean over what the reasoning says of the pose, each at most 1: metres, or degrees by 90.
    Reasoning that says nothing of the pose gets -1.
    """
    return [-_distance(each) for each in outcome]


REWARDS: dict[str, Reward] = {
    "format": r_format,
    "coll": r_coll,
    "layout": r_layout,
    "support": r_support,
    "settle": r_settle,
    "valid": r_valid,
    "align": r_align,
    "rules": r_rules,
    "cons": r_cons,
}
"""Every reward that needs no judge besides, by name."""


def _measured(each: Rollout, reward: Callable[[Verdict], float]) -> float:
    verdict = each.tried.verdict
    return -1.0 if verdict is None or "error" in verdict.reasons else reward(verdict)


def _support(verdict: Verdict) -> float:
    fails = {"unsupported", "drop"}.intersection(verdict.reasons)
    return -1.0 if fails or not (verdict.settled or verdict.valid) else 0.0


def _settle(verdict: Verdict) -> float:
    if verdict.valid and not verdict.settled:
        return 0.0  # what is fixed to the room
    if not verdict.settled or verdict.rest is None or "restless" in verdict.reasons:
        return -1.0
    return 0.0 - math.tanh(verdict.drift / DRIFT + verdict.drop / DROP + verdict.tilt / TILT)


def _distance(each: Rollout) -> float:
    if each.distances is None:
        return NEVER
    return sum(min(d, NEVER) for d in each.distances) / len(each.distances) if each.distances else NEVER
