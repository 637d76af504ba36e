"""What a reader of a model's report should know besides its numbers, in sentences."""

from dataclasses import dataclass

import mujoco
import numpy as np

from thinkblox.sim.foreign.model_contacts import ModelContacts, Pair
from thinkblox.sim.foreign.model_motion import Motions, upwards
from thinkblox.sim.foreign.names import listed
from thinkblox.sim.settings import Tolerances
from thinkblox.sim.subject import Subject

SWUNG = 0.1
"""Share of its range, or radians or metres where it has none, past which a joint's motion is told."""
_ONE = (int(mujoco.mjtJoint.mjJNT_HINGE), int(mujoco.mjtJoint.mjJNT_SLIDE))


@dataclass(frozen=True)
class ModelFacts:
    """What the notes are made of."""

    subject: Subject
    contacts: ModelContacts
    depths: dict[Pair, float]
    masked: tuple[int, dict[Pair, float]]
    motions: Motions
    unstable: tuple[str, ...]
    tolerances: Tolerances


def model_notes(facts: ModelFacts) -> tuple[str, ...]:
    """All notes on a model, those of how it was read first."""
    broken = facts.motions.broken
    return (
        *facts.subject.notes,
        *facts.unstable,
        *((f"{broken} It was let go for {facts.motions.seconds:.3g} s.",) if broken else ()),
        *_masked(facts),
        *_cut(facts),
        *_within(facts),
        *_swung(facts),
        *_weightless(facts),
        *_fixed(facts),
    )


def _masked(facts: ModelFacts) -> list[str]:
    count, overlaps = facts.masked
    if not count:
        return []
    pairs = "1 pair of things" if count == 1 else f"{count} pairs of things"
    told = f"The model switches off the contacts between {pairs}"
    deep = {pair: depth for pair, depth in overlaps.items() if depth > facts.tolerances.penetration}
    if not deep:
        return [f"{told}; none of those overlap at the start."]
    worst = sorted(deep, key=lambda pair: -deep[pair])
    names = [f"{facts.contacts.names[a]} and {facts.contacts.names[b]} ({deep[a, b] * 1000:.1f} mm)" for a, b in worst]
    return [f"{told}, {len(deep)} of which overlap at the start: {listed(names)}."]


def _cut(facts: ModelFacts) -> list[str]:
    if not facts.contacts.cut:
        return []
    return ["So many fixed or masked geoms are close together that not all of them were compared."]


def _within(facts: ModelFacts) -> list[str]:
    """Things whose own parts push each other apart."""
    deep = {a: d for (a, b), d in facts.depths.items() if a == b and d > facts.tolerances.penetration}
    if not deep:
        return []
    names = [f"{facts.contacts.names[a]} ({deep[a] * 1000:.1f} mm)" for a in sorted(deep, key=lambda a: -deep[a])]
    return [f"Parts of one thing are inside one another and push each other apart: {listed(names)}."]


def _swung(facts: ModelFacts) -> list[str]:
    """Doors, drawers and arms that did not stay where they were."""
    model, subject = facts.subject.model, facts.subject
    if facts.unstable:
        return []
    joints = np.flatnonzero(np.isin(model.jnt_type, _ONE))
    address = model.jnt_qposadr[joints]
    away = np.abs(facts.motions.data.qpos[address] - subject.start[address])
    span = np.where(model.jnt_limited[joints].astype(bool), np.ptp(model.jnt_range[joints], axis=1), 1.0)
    owner = {body: thing.id for thing in subject.things for body in thing.bodies}
    soft = _vertex_bodies(model)
    moved = joints[away > SWUNG * np.maximum(span, 1e-9)].tolist()
    bodies = [int(model.jnt_bodyid[joint]) for joint in moved]
    names = [
        f"{str(model.joint(joint).name) or f'joint {joint}'} of {owner.get(body, 'the world')}"
        for joint, body in zip(moved, bodies, strict=True)
        if body not in soft
    ]
    return [f"Joints moved by more than {SWUNG:.0%} of their range: {listed(names)}."] if names else []


def _vertex_bodies(model: mujoco.MjModel) -> frozenset[int]:
    return frozenset(model.flex_vertbodyid.tolist()) if model.nflex else frozenset()


def _weightless(facts: ModelFacts) -> list[str]:
    if upwards(facts.subject.model) is not None:
        return []
    return ["Without gravity nothing falls, so nothing can be said of what carries what."]


def _fixed(facts: ModelFacts) -> list[str]:
    moves = facts.motions.moves
    if not len(moves) or moves.any():
        return []
    if np.isin(facts.subject.model.jnt_type, _ONE).any():
        return ["Nothing in the model can move as a whole: letting go tells of its joints alone."]
    return ["Nothing in the model can move, so letting go tells nothing: only collisions are measured."]
