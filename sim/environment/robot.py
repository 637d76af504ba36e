"""Robots: our mobile ones, the Jaco arm that comes with dm_control, or the user's own MJCF."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.errors import InputError
from thinkblox.sim.build import compiled
from thinkblox.sim.environment.extra import needed
from thinkblox.sim.environment.room_source import TIMESTEP

HOME = Path(__file__).parent / "robots"
OURS = ("base", "picker")
JACO = "jaco"
PREFIX = "robot"
"""What all names of a robot's elements begin with in a room, and a "/"."""
_TOOLS = ("tool", "pinchsite", "pinch", "attachment_site", "grip_site", "ee_site")
"""Sites that are taken for a robot's tool, the first that it has."""
_FOOT = 0.15
"""What of an arm is lower than this stands where it is mounted [m]."""
_TOP_ONLY = ("option", "visual", "statistic", "size")
"""Parts of a model that are the room's to say."""


@dataclass(frozen=True)
class Robot:
    """A robot that can be attached to a room.

    Attributes:
        name: "base", "picker", "jaco" or the name of its file.
        entity: for dm_control.
        mobile: whether it stands free; it is mounted otherwise.
        radius: of the circle about its origin that it needs on the floor [m].
        height: what is above its foot [m].
        lift: how far its origin is above what it stands on [m].
        tool: name of the site that it works with, in the room; None for one that only drives.
        cameras: names of its cameras, in the room, by their own.
        timestep: that it asks for [s].
    """

    name: str
    entity: Any
    mobile: bool
    radius: float
    height: float
    lift: float
    tool: str | None
    cameras: dict[str, str]
    timestep: float


def load_robot(robot: str | Path, *, tool: str | None = None) -> Robot:
    """A robot by its name or by the path of its MJCF file.

    A file's robot stands free where its one top body has a free joint, and is mounted otherwise.

    Args:
        robot: "base", "picker", "jaco", or a path.
        tool: name of the site it works with; "tool", "pinchsite", "attachment_site" and the like are found.

    Raises:
        InputError: neither is it known nor a file, the file cannot be read, or it has no such site.
    """
    if robot == JACO:
        return _jaco()
    file = HOME / f"{robot}.xml" if robot in OURS else Path(robot)
    if not file.is_file():
        if Path(robot).suffix:
            raise InputError(f"{robot}: there is no such file to read a robot from")
        raise InputError(
            f"no robot {str(robot)!r}; there are {', '.join((*OURS, JACO))}, or give the path of an MJCF file"
        )
    return _from_file(str(robot) if robot in OURS else file.stem, file, tool)


def _jaco() -> Robot:
    composer = needed("dm_control.entities.manipulators.kinova")
    arm, hand = composer.JacoArm(name=PREFIX), composer.JacoHand(name="hand")
    arm.attach(hand)
    site = f"{PREFIX}/{hand.tool_center_point.full_identifier.removeprefix(PREFIX + '/')}"
    sized = _measured(
        mujoco.MjModel.from_xml_string(arm.mjcf_model.to_xml_string(), arm.mjcf_model.get_assets()), False
    )
    return Robot(JACO, arm, False, *sized, site, {}, TIMESTEP)


def _from_file(name: str, file: Path, tool: str | None) -> Robot:
    composer, mjcf = needed("dm_control.composer"), needed("dm_control.mjcf")
    try:
        spec = mujoco.MjSpec.from_file(str(file))
        model = compiled(spec)
        # The engine writes radians and no includes, whatever the file has.
        root = mjcf.from_xml_string(spec.to_xml(), model_dir=str(file.parent), assets=dict(spec.assets) or None)
    except (ValueError, KeyError, FileNotFoundError, InputError) as error:
        raise InputError(f"{file}: cannot be read as a robot: {' '.join(str(error).split())}") from error
    if not model.nu:
        raise InputError(f"{file}: the robot has no actuators")
    root.model = PREFIX
    for part in _TOP_ONLY:
        getattr(root, part).remove()
    for key in list(root.keyframe.all_children()):
        key.remove()
    mobile = _let_go(root, file)
    sized = _measured(model, mobile)
    sites = [str(model.site(number).name) for number in range(model.nsite)]
    cameras = [str(model.camera(number).name) for number in range(model.ncam)]
    return Robot(
        name,
        composer.ModelWrapperEntity(root),
        mobile,
        *sized,
        None if name == "base" else _tool(file, sites, tool),
        {camera: f"{PREFIX}/{camera}" for camera in cameras if camera},
        min(float(model.opt.timestep), TIMESTEP),
    )


def _tool(file: Path, sites: list[str], tool: str | None) -> str | None:
    if tool is not None and tool not in sites:
        raise InputError(f"{file}: the robot has no site {tool!r}; it has {', '.join(sites) or 'none'}")
    found = tool or next((name for name in _TOOLS if name in sites), None)
    return None if found is None else f"{PREFIX}/{found}"


def _let_go(root: Any, file: Path) -> bool:
    """Take the free joint from the one body at the top, to be given to where it is attached; whether it had one."""
    tops = root.worldbody.body
    if not tops:
        raise InputError(f"{file}: the robot has no body")
    free = [top.freejoint for top in tops if top.freejoint is not None]
    free += [joint for top in tops for joint in top.joint if joint.type == "free"]
    if len(tops) > 1 and free:
        raise InputError(
            f"{file}: a robot that stands free is one body with its parts; this has {len(tops)} at its top"
        )
    for joint in free:
        joint.remove()
        tops[0].pos, tops[0].quat = None, None
    return bool(free)


def _measured(model: mujoco.MjModel, mobile: bool) -> tuple[float, float, float]:
    """Radius, height, and height of the origin over the ground, of what of a robot collides [m]."""
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    origin = np.array(data.xpos[1]) if mobile else np.zeros(3)
    touching = [g for g in range(model.ngeom) if model.geom_contype[g] or model.geom_conaffinity[g]]
    corners = np.vstack([_corners(model, data, geom) for geom in touching] or [np.zeros((1, 3))]) - origin
    low, high = float(corners[:, 2].min()), float(corners[:, 2].max())
    foot = corners if mobile else corners[corners[:, 2] < low + _FOOT]
    return float(np.hypot(foot[:, 0], foot[:, 1]).max()), high - low, -low


def _corners(model: mujoco.MjModel, data: mujoco.MjData, geom: int) -> NDArray[np.float64]:
    middle, half = model.geom_aabb[geom, :3], model.geom_aabb[geom, 3:]
    if int(model.geom_type[geom]) in (mujoco.mjtGeom.mjGEOM_CYLINDER, mujoco.mjtGeom.mjGEOM_SPHERE):
        # The box round a round thing reaches farther than it does.
        ring = np.radians(np.arange(0, 360, 15))
        flat = np.column_stack([np.cos(ring), np.sin(ring)]) * half[0]
        local = np.vstack([np.column_stack([flat, np.full(len(ring), z)]) for z in (-half[2], half[2])])
    else:
        local = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * half
    placed: NDArray[np.float64] = (local + middle) @ data.geom_xmat[geom].reshape(3, 3).T + data.geom_xpos[geom]
    return placed
