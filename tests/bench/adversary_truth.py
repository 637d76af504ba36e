"""What becomes of a case: the whole room, everything free and awake, in plain MuJoCo for 5 s from the proposed pose.

It is judged here by code of its own: nothing of `thinkblox.sim.verdict` is used but the names of the tolerances.
"""

import math
from typing import NamedTuple

import mujoco
import numpy as np
from msgspec import structs
from numpy.typing import NDArray

from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec
from thinkblox.sim.settings import Tolerances

SECONDS, LOOK = 5.0, 0.1
"""How long it is simulated, and how often it is looked at [s]."""
FAR = 0.3
"""What has come so far has fallen, and need not be watched further [m]."""
STILL, STILL_TURN, LAST = 0.0005, 0.2, 10
"""What moved and turned less at all of the last looks has come to rest [m, degrees]."""
RUNS, NUDGE = 20, 1e-6
"""How often a case is run again, and about how far its candidate is nudged along x, y and z each time [m]."""

Poses = dict[str, NDArray[np.float64]]


class End(NamedTuple):
    """How a room was after 5 s.

    Attributes:
        start, poses: of every free body, by its name: position and quaternion wxyz.
        first, depths: deepest contact of every two bodies at the start, and on average over the last looks [m].
        stir: how far anything was from its end at the last looks, as a share of what counts as still.
        mild: the engine gave no warning, and nothing went far.
    """

    start: Poses
    poses: Poses
    first: dict[tuple[str, str], float]
    depths: dict[tuple[str, str], float]
    stir: float
    mild: bool


class Truth(NamedTuple):
    """What became of a candidate, as shares of what is tolerated: more than 1 is too much.

    Attributes:
        share: the largest of all; `what` it is of, in words with its number.
        first: depth of the candidate's deepest contact at the start.
        stir: how much anything still moved in the end; more than 1 is too much for what has come to rest.
    """

    share: float
    what: str
    first: float
    stir: float


def simulated(scene: Scene) -> End:
    """A room after 5 s."""
    model = build_spec(scene).compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    free = {
        str(model.body(int(b)).name): int(b) for b in model.jnt_bodyid[model.jnt_type == mujoco.mjtJoint.mjJNT_FREE]
    }
    begin, first = _poses(data, free), _depths(model, data)
    history, deep = [begin], [first]
    for _ in range(round(SECONDS / LOOK)):
        mujoco.mj_step(model, data, nstep=round(LOOK / model.opt.timestep))
        history.append(_poses(data, free))
        deep.append(_depths(model, data))
        if not _mild(data, begin, history[-1]):
            return End(begin, history[-1], first, {}, math.inf, False)
    last, end = history[-LAST:], history[-1]
    depths = {pair: sum(look.get(pair, 0.0) for look in deep[-LAST:]) / LAST for pair in deep[-1]}
    stir = [max(_shift(p[b], end[b]) / STILL, _turn(p[b], end[b]) / STILL_TURN) for p in last for b in free]
    return End(begin, end, first, depths, max(stir, default=0.0), True)


def stands(before: End) -> bool:
    """Whether a room is worth putting something into: nothing in it falls, topples or wobbles on by itself."""
    slid = all(math.dist(before.start[b][:2], pose[:2]) < 0.005 for b, pose in before.poses.items())
    level = all(_turn(before.start[b], pose) < 2.0 for b, pose in before.poses.items())
    apart = max((*before.first.values(), *before.depths.values()), default=0.0) < Tolerances().penetration
    return before.mild and before.stir < 1.0 and slid and level and apart


def truth(scene: Scene, before: End, placement: Placement, asset: Asset) -> Truth:
    """What becomes of a candidate in a room, against what becomes of the room without it."""
    limits = Tolerances()
    after = simulated(scene.with_placement(placement, asset))
    found: list[tuple[float, str]] = [(0.0, "nothing")]
    if placement.id in after.poses:
        begin, end = after.start[placement.id], after.poses[placement.id]
        found += [
            _measure("drift", math.dist(begin[:2], end[:2]), limits.drift),
            _measure("drop", float(begin[2] - end[2]), limits.drop + limits.clearance),
            _measure("tilt", _turn(begin, end), limits.tilt),
        ]
    for id, pose in before.poses.items():
        # What stays where it was put is not pushed, though it had leaned over without the candidate upon it.
        ends = (pose, before.start[id])
        found.append(_measure(f"shift of {id}", min(_shift(end, after.poses[id]) for end in ends), limits.pushed))
        found.append(_measure(f"turn of {id}", min(_turn(end, after.poses[id]) for end in ends), limits.tilt))
    for pair, depth in after.depths.items():
        if depth > before.depths.get(pair, 0.0) + limits.penetration / 10:
            found.append(_measure(f"depth of {' in '.join(pair)}", depth, limits.penetration))
    first = max((depth for pair, depth in after.first.items() if placement.id in pair), default=0.0)
    share, what = max(found)
    if not after.mild:
        share, what = max(share, 10.0), f"{what}, far away"
    return Truth(share, what, first / limits.penetration, after.stir)


def falls(scene: Scene, before: End, placement: Placement, asset: Asset) -> int:
    """In how many of RUNS runs from very nearly the same pose it does not stand: chance decides where some do.

    Where faces lie in one plane, the engine's contacts depend on the last bit of a pose.
    """
    rng = np.random.default_rng(0)
    nudged = [np.add(placement.position, rng.normal(0.0, NUDGE, 3)).tolist() for _ in range(RUNS)]
    runs = [truth(scene, before, structs.replace(placement, position=tuple(place)), asset) for place in nudged]
    return sum(run.share > 1.0 or run.stir > 1.0 for run in runs)


def _measure(what: str, value: float, limit: float) -> tuple[float, str]:
    return value / limit, f"{what} {value:.4g}"


def _poses(data: mujoco.MjData, free: dict[str, int]) -> Poses:
    return {name: np.concatenate([data.xpos[body], data.xquat[body]]) for name, body in free.items()}


def _mild(data: mujoco.MjData, begin: Poses, now: Poses) -> bool:
    warned = any(data.warning[i].number for i in range(len(data.warning)))
    return not warned and all(np.isfinite(now[b]).all() and _shift(begin[b], now[b]) < FAR for b in now)


def _depths(model: mujoco.MjModel, data: mujoco.MjData) -> dict[tuple[str, str], float]:
    found: dict[tuple[str, str], float] = {}
    for index in range(data.ncon):
        contact = data.contact[index]
        bodies = sorted(str(model.body(int(model.body_rootid[model.geom_bodyid[geom]])).name) for geom in contact.geom)
        pair = (bodies[0], bodies[1])
        found[pair] = max(found.get(pair, 0.0), -float(contact.dist))
    return found


def _shift(first: NDArray[np.float64], second: NDArray[np.float64]) -> float:
    return float(np.linalg.norm(second[:3] - first[:3]))


def _turn(first: NDArray[np.float64], second: NDArray[np.float64]) -> float:
    """Angle between two orientations [degrees]."""
    return math.degrees(2 * math.acos(min(1.0, abs(float(first[3:] @ second[3:])))))
