"""The same as a Gymnasium environment, registered as "ThinkBLOX/Reach-v0", "Drive-v0", "Open-v0" and "Carry-v0"."""

from collections.abc import Iterable, Sequence
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thinkblox.errors import InputError
from thinkblox.scene.scene import MAX_PLACEMENTS
from thinkblox.sim.environment.extra import needed
from thinkblox.sim.environment.making import make_environment
from thinkblox.sim.environment.pictures import FARTHEST, NOTHING_SEEN, Pictures, Picturing
from thinkblox.sim.environment.registration import NAMES, register_environments
from thinkblox.sim.environment.room_source import RoomLike, RoomSource, rooms_of

FULL = 1000.0
"""No number that is told is larger, in metres, radians and seconds."""


def make_gym_environment(
    room: RoomLike | Iterable[RoomLike], *, task: str, render_mode: str | None = None, **options: Any
) -> Any:
    """A room as a `gymnasium.Env`.

    Actions are -1 to 1 for each actuator, over its range. Observations are a dictionary of arrays, numbers as float32.
    `terminated` says that the goal is reached, as does `info["success"]`; `truncated` that the time is up.

    Args:
        room: one room, or several, of which each episode has another one.
        task: "reach", "drive", "open" or "carry".
        render_mode: None or "rgb_array", from the camera "overview".
        options: as of `make_environment`.

    Raises:
        InputError: as `make_environment`, or an unknown `render_mode`.
    """
    return _class()(room, task, render_mode, options)


def vector_environment(
    rooms: RoomLike | Iterable[RoomLike], task: str, *, count: int | None = None, parallel: bool = False, **options: Any
) -> Any:
    """Environments side by side, each in rooms of its own, as a `gymnasium.vector.VectorEnv`.

    Args:
        rooms: a folder of rooms, or several rooms; they are dealt out in turn.
        task: of all of them.
        count: how many environments; when None, one for each room in which the task can be done, and `skipped` of what
            is returned says why it cannot in the others.
        parallel: each in a process of its own.
        options: as of `make_environment`.

    Raises:
        InputError: there are fewer rooms than environments; or as `make_environment`.
    """
    vector = needed("gymnasium.vector")
    if task not in NAMES:
        raise InputError(f"no task {task!r}; there are {', '.join(NAMES)}")
    sources, tried, skipped = rooms_of(rooms), list[Any](), dict[str, str]()
    if count is None and len(sources) > 1:
        sources, tried, skipped = _doable(sources, task, options)
    count = len(sources) if count is None else count
    if count < 1:
        raise InputError(f"{count} environments are none; give at least 1")
    if count > len(sources):
        raise InputError(f"{count} environments need as many rooms; there are {len(sources)}")
    shares = [[source.home for source in sources[i::count]] for i in range(count)]
    makers = [_maker(share, task, options) for share in shares]
    if parallel:
        for env in tried:
            env.close()
        made = vector.AsyncVectorEnv(makers)
    else:
        made = vector.SyncVectorEnv([lambda env=env: env for env in tried] or makers)
    made.skipped = skipped
    return made


def _doable(
    sources: Sequence[RoomSource], task: str, options: dict[str, Any]
) -> tuple[tuple[RoomSource, ...], list[Any], dict[str, str]]:
    """The rooms in which the task can be done, an environment of each, and why not in the others.

    Raises:
        InputError: it can be done in none of them.
    """
    found: list[tuple[RoomSource, Any]] = []
    skipped: dict[str, str] = {}
    for source in sources:
        try:
            found.append((source, _maker([source.home], task, options)()))
        except InputError as error:
            skipped[source.name] = str(error)
    if not found:
        raise InputError(f"the task can be done in none of the rooms: {'; '.join(dict.fromkeys(skipped.values()))}")
    return tuple(source for source, _ in found), [env for _, env in found], skipped


def _maker(rooms: Sequence[RoomLike], task: str, options: dict[str, Any]) -> Any:
    def make() -> Any:
        gymnasium = needed("gymnasium")
        register_environments()
        return gymnasium.make(NAMES[task], room=rooms, **options)

    return make


@cache
def _class() -> Any:
    gymnasium = needed("gymnasium")
    base: Any = gymnasium.Env

    class RoomEnv(base):  # type: ignore[misc]
        """A dm_env environment of a room as Gymnasium has it; `inner` is that one."""

        metadata = {"render_modes": ["rgb_array"], "render_fps": 25}

        def __init__(self, room: Any, task: str, render_mode: str | None, options: dict[str, Any]) -> None:
            _check_mode(render_mode)
            self.render_mode = render_mode
            self.inner = make_environment(room, task, **options)  # type: ignore[arg-type]
            self.metadata = {**self.metadata, "render_fps": round(1.0 / self.inner.control_timestep())}
            self._actions = ActionScale(self.inner.action_spec())
            self.action_space = gymnasium.spaces.Box(-1.0, 1.0, self._actions.low.shape, np.float32)
            self.observation_space = _observation_space(gymnasium.spaces, self.inner.observation_spec())
            self._closed = False

        def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, Any]:
            super().reset(seed=seed)
            if seed is not None:
                _seed(self.inner, int(self.np_random.integers(2**32)))
            return _observed(self.inner.reset(), self.observation_space), _info(self.inner)

        def step(self, action: Any) -> tuple[Any, float, bool, bool, Any]:
            told = self.inner.step(self._actions.scaled(action))
            done = bool(told.last() and told.discount == 0.0)
            seen = _observed(told, self.observation_space)
            return seen, float(told.reward), done, bool(told.last() and not done), _info(self.inner)

        def render(self) -> Any:
            return None if self.render_mode is None else _picture(self.inner)

        def close(self) -> None:
            if not self._closed:
                self._closed = True
                self.inner.close()

    return RoomEnv


class ActionScale:
    """Actions from -1 to 1, and what the actuators take; where these have no range, it is the same."""

    def __init__(self, spec: Any) -> None:
        low, high = np.asarray(spec.minimum), np.asarray(spec.maximum)
        bounded = np.isfinite(low) & np.isfinite(high)
        self.low, self.high = np.where(bounded, low, -1.0), np.where(bounded, high, 1.0)

    def scaled(self, action: Any) -> NDArray[np.float64]:
        """What the actuators are given."""
        share = (np.clip(np.asarray(action, np.float64), -1.0, 1.0) + 1.0) / 2.0
        return np.asarray(self.low + share * (self.high - self.low))

    def unscaled(self, action: NDArray[np.float64]) -> NDArray[np.float32]:
        """The other way round."""
        return np.asarray(2.0 * (action - self.low) / (self.high - self.low) - 1.0, np.float32)


def _check_mode(render_mode: str | None) -> None:
    if render_mode not in (None, "rgb_array"):
        raise InputError(f"no render_mode {render_mode!r}; there is rgb_array")


def _seed(inner: Any, seed: int) -> None:
    inner.random_state.seed(seed)
    if hasattr(inner, "rotation"):
        inner.rotation.begin_anew()


def _observation_space(spaces: Any, specs: Any) -> Any:
    return spaces.Dict({name: _space(spaces, name, spec.shape) for name, spec in specs.items()})


def _space(spaces: Any, name: str, shape: tuple[int, ...]) -> Any:
    if name.endswith("_rgb"):
        return spaces.Box(0, 255, shape, np.uint8)
    if name.endswith("_depth"):
        return spaces.Box(0.0, FARTHEST, shape, np.float32)
    if name.endswith("_segmentation"):
        return spaces.Box(NOTHING_SEEN, MAX_PLACEMENTS + 1, shape, np.int32)
    return spaces.Box(-FULL, FULL, shape, np.float32)


def _observed(told: Any, space: Any) -> dict[str, Any]:
    return {
        name: np.clip(told.observation[name], each.low, each.high).astype(each.dtype)
        for name, each in space.spaces.items()
    }


def _info(inner: Any) -> dict[str, Any]:
    errand = inner.task.errand
    return {"success": bool(errand.goal.reached()), "room": errand.room.name, "goal": errand.goal.says()}


def _picture(inner: Any) -> Any:
    errand = inner.task.errand
    looks = Pictures(size=(360, 480), renderer=errand.pictures.renderer)
    return Picturing(inner.physics, errand.index, looks).draw("overview", "rgb")
