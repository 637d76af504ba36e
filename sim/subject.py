"""A scene as the engine sees it, whoever made it: a compiled model, its start, and which bodies are its objects."""

from dataclasses import dataclass, field

import mujoco
import numpy as np
from numpy.typing import NDArray

from thinkblox.scene.room import Room
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec, compiled
from thinkblox.sim.settings import Physics


@dataclass(frozen=True)
class Thing:
    """One object of a model: a body under the world, with all that hangs on it.

    Attributes:
        id: its name.
        root: index of its body.
        bodies: indices of its body and of every descendant.
        free: whether it has a freejoint.
    """

    id: str
    root: int
    bodies: tuple[int, ...]
    free: bool


@dataclass(frozen=True)
class Subject:
    """What the suites measure.

    Attributes:
        model: compiled, with its own options.
        start: qpos from which it is simulated: keyframe "settled", else its only keyframe, else the model's reference.
        things: its objects; the world's own geoms (floor, walls) belong to none.
        room: floor polygon, height and openings where they are known.
        scene: what the model was built of, where it is one of ours or was converted into one.
        source: "thinkblox", "mjcf", "urdf", or the generator whose layout it is.
        unusual: options that make it stand better than it would, in sentences.
        substituted: ids of things that are boxes for want of a mesh.
        notes: what a reader should know of how it was read, in sentences.
        keyframe: whose controls and mocap poses hold at the start, None for the model's own.
        robots: things that are there and are not judged.
    """

    model: mujoco.MjModel
    start: NDArray[np.float64]
    things: tuple[Thing, ...]
    room: Room | None = None
    scene: Scene | None = None
    source: str = "thinkblox"
    unusual: tuple[str, ...] = ()
    substituted: tuple[str, ...] = ()
    notes: tuple[str, ...] = field(default=())
    keyframe: int | None = None
    robots: tuple[Thing, ...] = ()

    def data(self) -> mujoco.MjData:
        """A fresh state at the start, nothing moving, with everything computed that depends on it."""
        data = mujoco.MjData(self.model)
        if self.keyframe is not None:
            mujoco.mj_resetDataKeyframe(self.model, data, self.keyframe)
            data.qvel[:], data.time = 0.0, 0.0
        data.qpos[:] = self.start
        mujoco.mj_forward(self.model, data)
        return data


def subject_of(
    scene: Scene, *, physics: Physics | None = None, source: str = "thinkblox", substituted: tuple[str, ...] = ()
) -> Subject:
    """A scene as a subject, at its proposed poses; `source` and `substituted` as for `Subject`."""
    model = compiled(build_spec(scene, physics=physics))
    return Subject(
        model=model,
        start=np.array(model.qpos0),
        things=tuple(thing_of(model, int(model.body(placement.id).id)) for placement in scene.placements),
        room=scene.room,
        scene=scene,
        source=source,
        substituted=substituted,
    )


def thing_of(model: mujoco.MjModel, root: int) -> Thing:
    """The thing whose root is a body of a model."""
    bodies = [root]
    for body in range(root + 1, model.nbody):
        if int(model.body_parentid[body]) in bodies:
            bodies.append(body)
    joint = int(model.body_jntadr[root])
    free = joint >= 0 and int(model.jnt_type[joint]) == int(mujoco.mjtJoint.mjJNT_FREE)
    return Thing(id=str(model.body(root).name), root=root, bodies=tuple(bodies), free=free)
