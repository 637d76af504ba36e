"""What a verdict pool and its worker processes say to each other: MessagePack messages."""

import numbers
from typing import Any

import msgspec
from msgspec import Raw

from thinkblox.errors import InputError
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room
from thinkblox.sim.settings import Physics, Tolerances, Walking
from thinkblox.verdict import Verdict


class WorkerSettings(msgspec.Struct, frozen=True, array_like=True):
    """What a worker is started with: `timeout` of a task [s], `worlds` that it keeps, `memory` [bytes]."""

    tolerances: Tolerances
    physics: Physics
    walking: Walking
    timeout: float
    worlds: int
    memory: int


class Task(msgspec.Struct, frozen=True, array_like=True):
    """Candidates for one object more in a scene.

    Attributes:
        key: of the scene.
        base: key of a scene that the worker has a world of; empty when it has to begin with `room`.
        placed: what the scene has besides, in order, each with the key of its asset.
        assets: those that the worker does not have yet, by key.
        asset: key of what the candidates place.
        candidates: ids and placements, each encoded by itself, so that a wrong one spoils no other.
        way: as World.check takes it.
    """

    key: bytes
    base: bytes
    room: Room | None
    placed: list[tuple[Placement, bytes]]
    assets: list[tuple[bytes, Asset]]
    asset: bytes
    candidates: list[tuple[str, Raw]]
    way: bool


class Reply(msgspec.Struct, frozen=True, array_like=True):
    """What a worker says to a task.

    Attributes:
        verdicts: one a candidate; none when there is an `error`.
        error: why nothing could be measured.
        forgotten: keys of scenes and assets that the worker has no longer.
        full: it holds more memory than it may, and is to be replaced.
    """

    verdicts: list[Verdict]
    error: str = ""
    forgotten: list[bytes] = []
    full: bool = False


def _number(value: object) -> float:
    """Numbers of numpy are taken for what they are."""
    if isinstance(value, numbers.Real):
        return float(value)
    raise InputError(f"{value!r} is a {type(value).__name__}; scenes, assets and placements hold none")


_encoder = msgspec.msgpack.Encoder(enc_hook=_number)


def encode(value: Any) -> bytes:
    """A value as MessagePack; raises InputError for what is not made of plain values."""
    return _encoder.encode(value)


def unmeasured(id: str, message: str) -> Verdict:
    """The verdict on a candidate that could not be measured."""
    return Verdict(id=id, valid=False, reasons=("error",), message=message)
