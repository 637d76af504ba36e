"""The hinges and slides of a subject: the doors, drawers and lids of its things."""

from dataclasses import dataclass

import mujoco

from thinkblox.sim.subject import Subject

_KINDS = (int(mujoco.mjtJoint.mjJNT_HINGE), int(mujoco.mjtJoint.mjJNT_SLIDE))


@dataclass(frozen=True)
class Hinged:
    """One hinge or slide.

    Attributes:
        id: its name, or that of its thing and its number.
        qpos, dof: where its coordinate and its velocity are.
        lower, upper: its range [rad or m]; both 0 when it has no limits.
    """

    id: str
    qpos: int
    dof: int
    lower: float
    upper: float

    @property
    def range(self) -> float:
        """How far it can move [rad or m]; 0 when it has no limits."""
        return abs(self.upper - self.lower)


def hinged(subject: Subject) -> tuple[Hinged, ...]:
    """Every hinge and slide of a subject's things, in the order of the model."""
    model = subject.model
    owners = {body: thing.id for thing in subject.things for body in thing.bodies}
    found = []
    for joint in range(model.njnt):
        owner = owners.get(int(model.jnt_bodyid[joint]))
        if int(model.jnt_type[joint]) not in _KINDS or owner is None:
            continue
        lower, upper = model.jnt_range[joint] if model.jnt_limited[joint] else (0.0, 0.0)
        found.append(
            Hinged(
                id=str(model.joint(joint).name) or f"{owner} joint {joint}",
                qpos=int(model.jnt_qposadr[joint]),
                dof=int(model.jnt_dofadr[joint]),
                lower=float(lower),
                upper=float(upper),
            )
        )
    return tuple(found)
