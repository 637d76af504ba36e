"""Measures of the rooms of a policy: means over the rooms of a run, and their spread over the runs."""

from collections.abc import Callable, Iterable, Sequence
from statistics import fmean, stdev
from typing import NamedTuple

from thinkblox.evaluation.room_tally import RoomTally, StepTally

IB_OF_PSA = 0.01
"""How far out of the room things may reach in a room that counts for PSA [m]."""
Rooms = Sequence[RoomTally]
Taken = Callable[[Rooms], float | None]


class Figure(NamedTuple):
    """A measure: its mean over the runs, the standard deviation of that (None of one run), and each run's."""

    mean: float
    spread: float | None
    runs: tuple[float, ...]


class Measure(NamedTuple):
    """A column: its name, what it says of rooms (None where there is nothing to say), and decimals that are shown."""

    name: str
    of: Taken
    digits: int = 1


def _steps(holds: Callable[[StepTally], float | None], scale: float = 100.0) -> Taken:
    return lambda rooms: _mean((holds(step) for room in rooms for step in room.steps), scale)


def _rooms(holds: Callable[[RoomTally], float | None], scale: float = 100.0) -> Taken:
    return lambda rooms: _mean((holds(room) for room in rooms), scale)


def _per(top: Callable[[RoomTally], float | None], bottom: Callable[[RoomTally], int], scale: float = 1.0) -> Taken:
    def found(rooms: Rooms) -> float | None:
        counted = [(above, bottom(room)) for room in rooms if (above := top(room)) is not None]
        total = sum(below for _, below in counted)
        return scale * sum(above for above, _ in counted) / total if total else None

    return found


def _mean(values: Iterable[float | None], scale: float) -> float | None:
    known = [value for value in values if value is not None]
    return scale * fmean(known) if known else None


def psa(room: RoomTally) -> float | None:
    """The mean of both ratings where everything is free and inside, and 0 elsewhere; None where there is no rating."""
    if not room.free or not room.inside(IB_OF_PSA):
        return 0.0
    if room.position is None or room.rotation is None:
        return None
    return (room.position + room.rotation) / 2


STEPS = (
    Measure("steps", lambda rooms: float(sum(len(room.steps) for room in rooms)), 0),
    Measure("parsed", _steps(lambda step: step.parsed)),
    Measure("free", _steps(lambda step: step.free)),
    Measure("in 1 mm", _steps(lambda step: _within(step, 0.001))),
    Measure("in 1 cm", _steps(lambda step: _within(step, 0.01))),
    Measure("in 5 cm", _steps(lambda step: _within(step, 0.05))),
    Measure("supported", _steps(lambda step: step.supported)),
    Measure("stable", _steps(lambda step: step.stable)),
    Measure("valid", _steps(lambda step: step.valid)),
    Measure("relations", _steps(lambda step: step.relations)),
    Measure("orientation", _steps(lambda step: step.orientation, 1.0), 2),
)
ROOMS = (
    Measure("rooms", lambda rooms: float(len(rooms)), 0),
    Measure("refused", lambda rooms: float(sum(bool(room.refused) for room in rooms)), 0),
    Measure("CF", _rooms(lambda room: room.free)),
    Measure("IB 1 mm", _rooms(lambda room: room.inside(0.001))),
    Measure("IB 1 cm", _rooms(lambda room: room.inside(0.01))),
    Measure("IB 5 cm", _rooms(lambda room: room.inside(0.05))),
    Measure("placed", _per(lambda room: room.placed, lambda room: room.planned, 100.0)),
    Measure("relations", _per(lambda room: room.held, lambda room: room.told, 100.0)),
    Measure("passed", _rooms(lambda room: room.valid)),
    Measure("as asked", _rooms(lambda room: room.complete)),
)
COST = (
    Measure("s a room", _rooms(lambda room: None if room.refused else room.seconds, 1.0), 2),
    Measure("s an answer", _per(lambda room: room.answering, lambda room: len(room.steps)), 3),
    Measure("tokens read", _per(lambda room: room.read, lambda room: len(room.steps)), 0),
    Measure("tokens written", _per(lambda room: room.written, lambda room: len(room.steps)), 0),
)
RATED = (
    Measure("rated", lambda rooms: float(sum(room.position is not None for room in rooms)), 0),
    Measure("Pos", _rooms(lambda room: room.position, 1.0)),
    Measure("Rot", _rooms(lambda room: room.rotation, 1.0)),
    Measure("PSA", _rooms(psa, 1.0)),
)


def _within(step: StepTally, tolerance: float) -> bool:
    return step.outside is not None and step.outside <= tolerance


def figure(measure: Taken, rooms: Rooms) -> Figure | None:
    """A measure over runs; None where no run has it."""
    by_run = [[room for room in rooms if room.run == run] for run in sorted({room.run for room in rooms})]
    found = [value for run in by_run if (value := measure(run)) is not None]
    if not found:
        return None
    return Figure(fmean(found), stdev(found) if len(found) > 1 else None, tuple(found))
