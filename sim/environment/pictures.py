"""What a camera in a room sees: colours, distances, and which object is where; by OpenGL or by casting rays."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.errors import InputError
from thinkblox.sim.environment.model_index import ModelIndex
from thinkblox.sim.render.model_soup import geom_colour

PictureKind = Literal["rgb", "depth", "segmentation"]
KINDS: tuple[PictureKind, ...] = ("rgb", "depth", "segmentation")
NOTHING_SEEN = -1
"""The label of a pixel that shows nothing of the model."""
FARTHEST = 100.0
"""What is farther is seen as this far [m]."""
_SHOWN = np.array([1, 1, 1, 0, 0, 0], np.uint8)
"""The groups of geoms that are looked at."""
_GEOM = int(mujoco.mjtObj.mjOBJ_GEOM)


@dataclass(frozen=True)
class Pictures:
    """Pictures as observations, called "<camera>_<kind>".

    Attributes:
        cameras: the robot's ("eye", "side"), or the room's ("corner_1", "overview", "top").
        kinds: "rgb" (uint8, height, width, 3), "depth" (float32 [m], height, width), "segmentation" (int32, height,
            width: -1 is nothing, 0 the room, then the objects in their order, then the robot).
        size: height and width [pixels].
        renderer: "gl" draws with textures and shadows, by OpenGL; "rays" needs no graphics at all, has plain colours
            and is the same on every machine.

    Raises:
        InputError: a kind or a renderer that there is not, or a size out of range.
    """

    cameras: tuple[str, ...] = ()
    kinds: tuple[PictureKind, ...] = ("rgb",)
    size: tuple[int, int] = (84, 84)
    renderer: Literal["gl", "rays"] = "gl"

    def __post_init__(self) -> None:
        if unknown := [kind for kind in self.kinds if kind not in KINDS]:
            raise InputError(f"no pictures of the kind {unknown[0]!r}; there are {', '.join(KINDS)}")
        if self.renderer not in ("gl", "rays"):
            raise InputError(f"no renderer {self.renderer!r}; there are gl, rays")
        if not all(1 <= side <= 1080 for side in self.size):
            raise InputError(f"pictures of {self.size} pixels cannot be drawn; height and width are 1 to 1080")


class Picturing:
    """Draws what cameras of a compiled model see.

    Attributes:
        labels: what the labels of a segmentation from 0 on mean: "room", the objects by id, "robot".
    """

    def __init__(self, physics: Any, index: ModelIndex, pictures: Pictures) -> None:
        self._physics, self._index, self._pictures = physics, index, pictures
        self.labels, self._owner = index.owners()

    @cached_property
    def _colours(self) -> NDArray[np.float64]:
        return np.array([geom_colour(self._index.model, geom)[:3] for geom in range(self._index.model.ngeom)])

    def camera(self, name: str) -> str:
        """The name in the model of a camera, the robot's or the room's; raises InputError for an unknown one."""
        model, own = self._index.model, self._index.robot.cameras
        every = [str(model.camera(number).name) for number in range(model.ncam)]
        found = own.get(name, name)
        if found not in every:
            raise InputError(f"no camera {name!r}; there are {', '.join((*own, *(c for c in every if '/' not in c)))}")
        return found

    def draw(self, camera: str, kind: PictureKind) -> NDArray[Any]:
        """What a camera sees, as `Pictures` says; raises InputError where it cannot be drawn."""
        name = self.camera(camera)
        return self._rays(name, kind) if self._pictures.renderer == "rays" else self._drawn(name, kind)

    def _drawn(self, camera: str, kind: PictureKind) -> NDArray[Any]:
        height, width = self._pictures.size
        how = {"depth": kind == "depth", "segmentation": kind == "segmentation"}
        try:
            seen = self._physics.render(height=height, width=width, camera_id=camera, **how)
        except (RuntimeError, ImportError, AttributeError, mujoco.FatalError) as error:
            raise InputError(
                f"pictures cannot be drawn by OpenGL here ({error}); set MUJOCO_GL to egl or osmesa and install it, or"
                " use Pictures(renderer='rays')"
            ) from error
        if kind == "segmentation":
            return self._labelled(np.where(seen[..., 1] == _GEOM, seen[..., 0], -1))
        return np.minimum(seen, FARTHEST).astype(np.float32) if kind == "depth" else np.array(seen)

    def _labelled(self, geoms: NDArray[Any]) -> NDArray[np.int32]:
        return np.where(geoms < 0, NOTHING_SEEN, self._owner[geoms]).astype(np.int32)

    def _rays(self, camera: str, kind: PictureKind) -> NDArray[Any]:
        model, data = self._index.model, self._index.data
        (height, width), number = self._pictures.size, int(model.camera(camera).id)
        rays = _directions(float(model.cam_fovy[number]), height, width)
        turn = data.cam_xmat[number].reshape(3, 3)
        count = height * width
        geoms, away, normal = np.zeros(count, np.int32), np.zeros(count), np.zeros(3 * count)
        to = np.ascontiguousarray(rays @ turn.T)
        mujoco.mj_multiRay(
            model, data, data.cam_xpos[number], to.ravel(), _SHOWN, 1, -1, geoms, away, normal, count, FARTHEST
        )
        seen = geoms.reshape(height, width)
        if kind == "segmentation":
            return self._labelled(seen)
        if kind == "depth":
            # As OpenGL has it: along the camera's axis, not along the ray.
            ahead = np.where(away < 0, FARTHEST, away * -rays[:, 2])
            return np.minimum(ahead, FARTHEST).astype(np.float32).reshape(height, width)
        return self._shaded(seen, normal.reshape(height, width, 3), to.reshape(height, width, 3))

    def _shaded(self, geoms: NDArray[Any], normal: NDArray[Any], to: NDArray[Any]) -> NDArray[np.uint8]:
        facing = np.abs(np.einsum("hwi,hwi->hw", normal, to))
        light = 0.45 + 0.35 * facing + 0.2 * np.clip(normal[..., 2], 0.0, 1.0)
        seen = np.where((geoms < 0)[..., None], (0.85, 0.9, 0.95), self._colours[geoms] * light[..., None])
        return np.asarray(np.rint(np.clip(seen, 0.0, 1.0) * 255.0), np.uint8)


def _directions(fovy: float, height: int, width: int) -> NDArray[np.float64]:
    """Unit directions (n, 3) of the pixels, row by row, in the frame of a camera that looks along its -z."""
    reach = np.tan(np.radians(fovy) / 2)
    y = (1.0 - (2.0 * np.arange(height) + 1.0) / height) * reach
    x = ((2.0 * np.arange(width) + 1.0) / width - 1.0) * reach * width / height
    across, up = np.meshgrid(x, y)
    rays = np.stack([across, up, -np.ones_like(up)], -1).reshape(-1, 3)
    return np.asarray(rays / np.linalg.norm(rays, axis=1, keepdims=True))
