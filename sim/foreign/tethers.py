"""What holds things besides contact: welds, ball joints made of constraints, and tendons."""

import mujoco
import numpy as np

from thinkblox.sim.foreign.unusual import equality_bodies
from thinkblox.sim.subject import Subject

_HOLDING = (int(mujoco.mjtEq.mjEQ_WELD), int(mujoco.mjtEq.mjEQ_CONNECT))


def tethers(subject: Subject, data: mujoco.MjData) -> list[str]:
    """For every thing what it is tied to: a thing's id, "world", or a tendon's name; "" where nothing ties it."""
    model = subject.model
    owner = {body: number for number, thing in enumerate(subject.things) for body in thing.bodies}
    found = [""] * len(subject.things)
    for bodies, name in _ties(model, data):
        things = {owner.get(body, -1) for body in bodies}
        if len(things) < 2:
            continue
        for number in things - {-1}:
            other = next((subject.things[n].id for n in sorted(things) if n not in (number, -1)), "world")
            found[number] = found[number] or name or other
    return found


def _ties(model: mujoco.MjModel, data: mujoco.MjData) -> list[tuple[tuple[int, ...], str]]:
    """The bodies that each tie holds together, and its name where the tie is a thing of its own."""
    equalities = np.flatnonzero(np.isin(model.eq_type, _HOLDING) & np.asarray(data.eq_active, dtype=bool))
    ties: list[tuple[tuple[int, ...], str]] = [(equality_bodies(model, int(eq)), "") for eq in equalities]
    for tendon in range(model.ntendon):
        start, count = int(model.tendon_adr[tendon]), int(model.tendon_num[tendon])
        wraps = slice(start, start + count)
        sites = model.wrap_objid[wraps][model.wrap_type[wraps] == int(mujoco.mjtWrap.mjWRAP_SITE)]
        if len(sites):
            name = str(model.tendon(tendon).name) or f"tendon_{tendon}"
            ties.append((tuple(model.site_bodyid[sites].tolist()), name))
    return ties
