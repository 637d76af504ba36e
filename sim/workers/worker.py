"""A worker process of a verdict pool: keeps worlds, reads tasks from a socket and writes answers to it.

Started by thinkblox.sim.workers.process as a `Child`.
"""

import faulthandler
import mmap
import signal
import sys
from collections import OrderedDict
from collections.abc import Sequence
from pathlib import Path

import msgspec

from thinkblox.errors import ThinkBloxError
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.verdict.world import World
from thinkblox.sim.workers.frames import receive_frame, send_frame
from thinkblox.sim.workers.inside import attached, go_first, wait_for_message
from thinkblox.sim.workers.wire import Reply, Task, WorkerSettings, encode, unmeasured
from thinkblox.verdict import Verdict

ASSETS = 4096
"""Assets that are kept beside those of the worlds."""
GRACE = 5.0
"""How long after its time limit a task ends this process by itself, should nobody have ended it [s]."""


class Worlds:
    """Worlds of the scenes that were asked for last, and the assets that were sent."""

    def __init__(self, settings: WorkerSettings) -> None:
        self._settings = settings
        self._worlds: OrderedDict[bytes, World] = OrderedDict()
        self._assets: OrderedDict[bytes, Asset] = OrderedDict()
        self._tasks = msgspec.msgpack.Decoder(Task)
        self._placements = msgspec.msgpack.Decoder(Placement)

    def answer(self, message: bytes) -> bytes:
        """The encoded Answer to an encoded Task; whatever fails in between is told in it."""
        try:
            task = self._tasks.decode(message)
            self._assets.update(task.assets)
            verdicts, error = self._verdicts(task), ""
        except Exception as failure:  # what a caller's scene or mesh set off must not end the process
            verdicts, error = [], _told(failure)
        forgotten = self._forget()
        return encode(Reply(verdicts, error, forgotten, full=self._full))

    def _verdicts(self, task: Task) -> list[Verdict]:
        world, asset = self._world(task), self._assets[task.asset]
        candidates = [self._placement(id, raw) for id, raw in task.candidates]
        readable = [candidate for candidate in candidates if isinstance(candidate, Placement)]
        verdicts = iter(_checked(world, readable, asset, task.way))
        return [next(verdicts) if isinstance(c, Placement) else c for c in candidates]

    def _placement(self, id: str, raw: msgspec.Raw) -> Placement | Verdict:
        try:
            return self._placements.decode(raw)
        except msgspec.MsgspecError as error:
            return unmeasured(id, f"{id} is no placement: {error}")

    def _world(self, task: Task) -> World:
        if task.base in self._worlds:
            self._worlds.move_to_end(task.base)
        if task.key not in self._worlds:
            self._worlds[task.key] = self._made(task)
        return self._worlds[task.key]

    def _made(self, task: Task) -> World:
        placed = [(placement, self._assets[key]) for placement, key in task.placed]
        if task.base and len(placed) == 1:
            return self._worlds[task.base].with_placement(*placed[0])
        base = self._worlds[task.base].scene if task.base else None
        assets = {asset.id: asset for _, asset in placed}
        if base is not None:
            placements = (*base.placements, *(p for p, _ in placed))
            return self._new(Scene(room=base.room, placements=placements, assets=base.assets | assets))
        if task.room is None:
            raise ThinkBloxError("the task has neither a room nor a scene to begin with")
        return self._new(Scene(room=task.room, placements=tuple(p for p, _ in placed), assets=assets))

    def _new(self, scene: Scene) -> World:
        settings = self._settings
        return World(scene, tolerances=settings.tolerances, physics=settings.physics, walking=settings.walking)

    def _forget(self) -> list[bytes]:
        """Let go of the oldest worlds and assets past what may be kept; their keys."""
        gone: list[bytes] = []
        while len(self._assets) > ASSETS:
            gone.append(self._assets.popitem(last=False)[0])
        while len(self._worlds) > self._settings.worlds:
            gone.append(self._worlds.popitem(last=False)[0])
        while self._worlds and self._full:
            gone.append(self._worlds.popitem(last=False)[0])
        return gone

    @property
    def _full(self) -> bool:
        """Whether it holds more memory than it may."""
        return _resident() > self._settings.memory


def _checked(world: World, candidates: Sequence[Placement], asset: Asset, way: bool) -> list[Verdict]:
    """All candidates at once or, should that fail, each by itself, so that only those at fault go without."""
    try:
        return world.check(candidates, asset, way=way)
    except Exception as failure:  # as in Worlds.answer
        if len(candidates) == 1:
            return [unmeasured(candidates[0].id, _told(failure))]
    return [verdict for candidate in candidates for verdict in _checked(world, [candidate], asset, way)]


def _told(failure: Exception) -> str:
    return str(failure) if isinstance(failure, ThinkBloxError) else f"{type(failure).__name__}: {failure}"


def _resident() -> int:
    """Memory that this process holds [bytes]; 0 where the system does not tell."""
    try:
        return int(Path("/proc/self/statm").read_bytes().split()[1]) * mmap.PAGESIZE
    except OSError:
        return 0


def main(arguments: Sequence[str]) -> None:
    """Read the settings, say that all is ready, and answer tasks until nobody is there to ask any more."""
    faulthandler.enable()
    channel, parent = attached(arguments)
    try:
        settings = msgspec.msgpack.decode(receive_frame(channel), type=WorkerSettings)
        go_first()
        worlds = Worlds(settings)
        send_frame(channel, b"")
        while wait_for_message(channel, parent):
            message = receive_frame(channel)
            # The default action of this signal needs no interpreter: it works in the midst of the engine too.
            signal.setitimer(signal.ITIMER_REAL, settings.timeout + GRACE)
            answer = worlds.answer(message)
            signal.setitimer(signal.ITIMER_REAL, 0.0)
            send_frame(channel, answer)
    except (EOFError, OSError):
        return


if __name__ == "__main__":
    main(sys.argv[1:])
