"""The report on any model: what collides at its start, where everything goes when it is let go, and who carries it."""

import math
from dataclasses import dataclass
from typing import get_args

import mujoco
import numpy as np

from thinkblox.errors import InputError
from thinkblox.sim.engine_errors import said
from thinkblox.sim.foreign.geom_volumes import Volumes
from thinkblox.sim.foreign.model_contacts import ModelContacts, Pair
from thinkblox.sim.foreign.model_motion import Motions, awake, let_go, upwards, warned
from thinkblox.sim.foreign.model_notes import ModelFacts, model_notes
from thinkblox.sim.foreign.model_room import boundary_of
from thinkblox.sim.foreign.structure import is_structure
from thinkblox.sim.foreign.tethers import tethers
from thinkblox.sim.quiet import quiet_engine
from thinkblox.sim.settings import Tolerances
from thinkblox.sim.subject import Subject
from thinkblox.sim.verdict.contacts import shares
from thinkblox.verdict import Collision, Reason, Report, Support, Verdict
from thinkblox.version import package_version

SECONDS = 5.0
ORDER: tuple[Reason, ...] = get_args(Reason)


@dataclass(frozen=True)
class _Start:
    """What is true of a subject before anything moves: depths of all pairs [m], and what they fill."""

    depths: dict[Pair, float]
    volumes: Volumes
    boundaries: tuple[float, ...]
    masked: tuple[int, dict[Pair, float]]
    unstable: tuple[str, ...]


def model_report(subject: Subject, *, tolerances: Tolerances | None = None, seconds: float = SECONDS) -> Report:
    """Measure any model as it is, with its own options.

    At its start: how deep every pair of things is in one another, and things in the floor and walls; two fixed things
    are only compared where both are furniture, as walls are built into one another (see `structure`). Then everything
    is let go at once: where each thing that can move goes, when it rests, and who carries which share of its weight
    then. A free thing that nothing carries is unsupported; what holds it by a weld or a tendon carries it too.

    Contacts that the model switches off are not seen, as the engine does not see them: a note counts them and says
    which of those pairs overlap.

    Args:
        subject: any model.
        tolerances: where the lines are drawn.
        seconds: how long it is let go [s].

    Raises:
        InputError: the engine cannot make a state of it, for want of the memory that <size memory> allows.
    """
    tolerances = tolerances or Tolerances()
    contacts = ModelContacts(subject)
    try:
        start = _start(subject, contacts)
        motions = let_go(subject, seconds)
    except mujoco.FatalError as error:
        raise InputError(f"MuJoCo cannot simulate the model: {said(error)}") from error
    supports = _supports(subject, contacts, motions)
    objects = tuple(
        _verdict(subject, n, contacts, start, motions, supports[n], tolerances) for n in range(len(supports))
    )
    unstable = start.unstable or motions.unstable
    facts = ModelFacts(subject, contacts, start.depths, start.masked, motions, unstable, tolerances)
    valid = all(v.valid for v in objects) and not unstable
    return Report(
        valid=valid,
        complete=valid,
        versions={"thinkblox": package_version(), "mujoco": mujoco.__version__},
        objects=objects,
        depth=round(max((d for (a, b), d in start.depths.items() if a != b), default=0.0), 6),
        drift=round(float(motions.drift.max(initial=0.0)), 6),
        tilt=round(float(motions.tilt.max(initial=0.0)), 4),
        simulated=round(motions.seconds, 6),
        source=subject.source,
        unusual=subject.unusual,
        substituted=subject.substituted,
        notes=model_notes(facts),
    )


@quiet_engine()
def _start(subject: Subject, contacts: ModelContacts) -> _Start:
    with awake(subject.model):
        data = subject.data()
    low, high = contacts.bounds(data)
    furniture = {n for n, t in enumerate(subject.things) if not is_structure(subject.model, t, low, high)}
    count, blind = contacts.masked()
    fixed = contacts.fixed_depths(data, furniture)
    return _Start(
        depths=contacts.depths(data) | fixed,
        volumes=Volumes(subject.model, data, contacts.of_geom),
        boundaries=boundary_of(subject, data),
        masked=(count, contacts.overlaps(data, blind)),
        unstable=warned(data),
    )


def _supports(subject: Subject, contacts: ModelContacts, motions: Motions) -> list[tuple[Support, ...]]:
    """Who carries each free thing at the end; nobody where there is no gravity or the numbers mean nothing."""
    model, up = subject.model, upwards(subject.model)
    if up is None or motions.unstable:
        return [() for _ in subject.things]
    forces, held = contacts.carried(motions.data, up), tethers(subject, motions.data)
    strength = float(np.linalg.norm(model.opt.gravity))
    found = []
    for number, thing in enumerate(subject.things):
        weight = float(model.body_mass[list(thing.bodies)].sum()) * strength
        by = {contacts.names[other]: force for other, force in forces.get(number, {}).items()}
        missing = weight - sum(by.values())
        if held[number] and missing > 0.0:
            by[held[number]] = by.get(held[number], 0.0) + missing
        found.append(shares(by, weight) if thing.free and weight > 0.0 else ())
    return found


def _verdict(
    subject: Subject,
    number: int,
    contacts: ModelContacts,
    start: _Start,
    motions: Motions,
    supports: tuple[Support, ...],
    tolerances: Tolerances,
) -> Verdict:
    thing = subject.things[number]
    collisions = _collisions(number, contacts, start, tolerances)
    drift, drop, tilt = (float(values[number]) for values in (motions.drift, motions.drop, motions.tilt))
    boundary, moves, broken = start.boundaries[number], bool(motions.moves[number]), motions.broken
    unstable = moves and bool(start.unstable or motions.unstable)
    moved = {
        "drift": drift > tolerances.drift,
        "drop": drop > tolerances.drop + tolerances.clearance,
        "tilt": tilt > tolerances.tilt,
    }
    carried = sum(support.share for support in supports)
    judged = thing.free and not unstable and not broken and upwards(subject.model) is not None
    found: dict[str, bool] = moved | {
        "collision": bool(collisions),
        "outside": boundary > tolerances.outside,
        "unsupported": judged and carried < tolerances.carried and not (supports and any(moved.values())),
        "unstable": unstable,
        "error": moves and bool(broken),
    }
    reasons = tuple(reason for reason in ORDER if found.get(reason))
    rest = float(motions.rest[number])
    return Verdict(
        id=thing.id,
        valid=not reasons,
        reasons=reasons,
        depth=max((c.depth for c in collisions), default=0.0),
        overlap=round(sum(c.overlap for c in collisions), 6),
        boundary=round(boundary, 6),
        collisions=collisions,
        supports=supports,
        settled=moves and not unstable,
        drift=round(drift, 6),
        drop=round(drop, 6),
        tilt=round(tilt, 4),
        rest=round(rest, 6) if moves and not unstable and math.isfinite(rest) else None,
        message=broken if moves else "",
    )


def _collisions(number: int, contacts: ModelContacts, start: _Start, tolerances: Tolerances) -> tuple[Collision, ...]:
    found = []
    for (first, second), depth in start.depths.items():
        if number in (first, second) and first != second and depth > tolerances.penetration:
            other = second if first == number else first
            overlap = round(start.volumes.overlap(number, other), 6)
            found.append(Collision(other=contacts.names[other], depth=round(depth, 6), overlap=overlap))
    return tuple(sorted(found, key=lambda c: (-c.depth, c.other)))
