"""Subjects for the tests of the suites: from MJCF text, as somebody else's model would come."""

from dataclasses import replace

import mujoco
import numpy as np

from thinkblox.sim.subject import Subject, thing_of
from thinkblox.suite import Criterion, SuiteResult

FLOOR = '<geom name="floor" type="plane" size="0 0 1" condim="1"/>'


def subject(world: str, *, options: str = "", more: str = "") -> Subject:
    """Everything directly under the world body is a thing."""
    text = f"<mujoco><option {options}/><worldbody>{world}</worldbody>{more}</mujoco>"
    model = mujoco.MjModel.from_xml_string(text)
    roots = [b for b in range(1, model.nbody) if model.body_parentid[b] == 0]
    things = tuple(thing_of(model, root) for root in roots)
    return Subject(model=model, start=np.array(model.qpos0), things=things, source="mjcf")


def free_box(name: str, position: str = "0 0 0.1", size: str = "0.1 0.1 0.1", mass: float = 1.0, geom: str = "") -> str:
    return (
        f'<body name="{name}" pos="{position}"><freejoint/>'
        f'<geom type="box" size="{size}" mass="{mass}" condim="1" {geom}/></body>'
    )


def fixed_box(name: str, position: str, size: str = "0.1 0.1 0.1") -> str:
    return f'<body name="{name}" pos="{position}"><geom type="box" size="{size}"/></body>'


def stuck_box(name: str, position: str, size: str = "0.1 0.1 0.1") -> str:
    """A box on slides with so much armature that no contact moves it: it stays as deep as it is."""
    return (
        f'<body name="{name}" pos="{position}"><joint type="slide" axis="1 0 0" armature="1e9"/>'
        f'<geom type="box" size="{size}" mass="1"/></body>'
    )


EXPLODING = (
    '<body name="spring" pos="0 0 3"><joint type="slide" axis="1 0 0" stiffness="1e9" springref="0.1"/>'
    '<geom size="0.1" mass="0.01"/></body>'
)
"""A spring so stiff that no usual step follows it."""


def started(subject: Subject, **values: tuple[int, float]) -> Subject:
    """The subject with some coordinates of its start set: name=(index, value)."""
    start = subject.start.copy()
    for index, value in values.values():
        start[index] = value
    return replace(subject, start=start)


def of(result: SuiteResult, name: str) -> Criterion:
    """The criterion called `name`."""
    return next(c for c in result.criteria if c.name == name)


def failures(criterion: Criterion) -> set[str]:
    """The objects that a criterion says failed."""
    return {f.object for f in criterion.findings if f.passed is False}


def failed(result: SuiteResult) -> set[str]:
    """The criteria that failed."""
    return {c.name for c in result.criteria if c.passed is False}
