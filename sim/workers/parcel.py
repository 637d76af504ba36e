"""Jobs of a verdict pool, made ready to be sent to whichever worker turns out to be free.

A scene goes by its content key. The key of a scene is that of the scene without its last object, hashed together with
that object; so all its beginnings have keys too, and a worker that knows one of them is sent the rest alone.
"""

from collections import OrderedDict
from collections.abc import Sequence
from concurrent.futures import Future
from hashlib import blake2b

from msgspec import Raw

from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.workers.wire import Reply, Task, encode, unmeasured
from thinkblox.verdict import Verdict

_REMEMBERED = 4096
"""Assets whose content keys are remembered."""


class Keys:
    """Content keys; those of assets are remembered, as they go into many scenes, and those of the last scene."""

    def __init__(self) -> None:
        self._assets: OrderedDict[int, tuple[Asset, bytes]] = OrderedDict()
        self._last: tuple[Scene, list[bytes]] | None = None

    def of_asset(self, asset: Asset) -> bytes:
        """Key of an asset; two that share an id and differ have different keys."""
        known = self._assets.get(id(asset))
        if known is not None:
            return known[1]
        key = _hash(encode(asset))
        # The asset is kept with its key, for its identity to stay its own.
        self._assets[id(asset)] = (asset, key)
        if len(self._assets) > _REMEMBERED:
            self._assets.popitem(last=False)
        return key

    def of_scene(self, scene: Scene) -> list[bytes]:
        """Keys of the empty room, of the room with the first object, and so on to the whole scene."""
        last = self._last
        if last is not None and last[0] is scene:
            return last[1]
        keys = [_hash(encode(scene.room))]
        for placement in scene.placements:
            keys.append(_hash(keys[-1], self.of_asset(scene.asset_of(placement)), encode(placement)))
        self._last = scene, keys
        return keys


def _hash(*parts: bytes) -> bytes:
    return blake2b(b"".join(parts), digest_size=16).digest()


class Parcel:
    """A job, encoded as far as it can be before it is known to whom it goes.

    Attributes:
        keys: of the scene's beginnings, from the empty room to the whole.
        ids: of the candidates.
        answer: where the verdicts will be.
        lost: whether a worker was lost over it already.
        passed: how often it was passed over for a later one.
    """

    def __init__(self, keys: Keys, scene: Scene, asset: Asset, candidates: Sequence[Placement], way: bool) -> None:
        self.keys = keys.of_scene(scene)
        self.ids = [candidate.id for candidate in candidates]
        self.answer: Future[list[Verdict]] = Future()
        self.lost = False
        self.passed = 0
        self._room = scene.room
        self._placed = [(placement, keys.of_asset(scene.asset_of(placement))) for placement in scene.placements]
        self._asset = keys.of_asset(asset)
        self._used = {key: scene.asset_of(placement) for placement, key in self._placed} | {self._asset: asset}
        self._candidates = [Raw(encode(candidate)) for candidate in candidates]
        self._way = way
        self._needed: set[bytes] = set()

    def begin(self) -> bool:
        """Whether it is still wanted; from then on it can no more be cancelled."""
        return self.answer.running() or self.answer.set_running_or_notify_cancel()

    def fail(self, error: Exception) -> None:
        """Let whoever waits for the answer have an error instead, unless nobody does any more."""
        if self.begin():
            self.answer.set_exception(error)

    def task(self, known: set[bytes], chosen: Sequence[int]) -> bytes:
        """The message to a worker that has the `known` scenes and assets, for the candidates at the `chosen` places."""
        start = next((n for n in reversed(range(len(self.keys))) if self.keys[n] in known), None)
        placed = self._placed[start or 0 :]
        self._needed = {key for _, key in placed} | {self._asset}
        return encode(
            Task(
                key=self.keys[-1],
                base=b"" if start is None else self.keys[start],
                room=self._room if start is None else None,
                placed=placed,
                assets=[(key, self._used[key]) for key in sorted(self._needed - known)],
                asset=self._asset,
                candidates=[(self.ids[n], self._candidates[n]) for n in chosen],
                way=self._way,
            )
        )

    def verdicts(self, answer: Reply, known: set[bytes], chosen: Sequence[int]) -> list[Verdict]:
        """What a worker answered to the last task, its `known` being brought up to date."""
        known.difference_update(answer.forgotten)
        if answer.error:
            return [unmeasured(self.ids[n], answer.error) for n in chosen]
        known.update(key for key in (self.keys[-1], *self._needed) if key not in answer.forgotten)
        return answer.verdicts
