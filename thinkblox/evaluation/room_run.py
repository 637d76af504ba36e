"""Making a room for each annotated prompt, or taking those that are there, and judging them in several processes.

A room is judged by its files, so whatever writes them can be judged: what makes the rooms is the one place to put
another policy, or several runs of one prompt.
"""

import re
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import msgspec

from thinkblox.crew import Done, work_through
from thinkblox.errors import InputError
from thinkblox.evaluation.annotations import Annotation
from thinkblox.evaluation.results import Judgement
from thinkblox.evaluation.room_file import RoomRecord, SceneRecord, read_report, read_scene
from thinkblox.evaluation.room_judge import judge_room
from thinkblox.evaluation.tallies import JudgedRow
from thinkblox.holding import note_placed

GRACE = 300.0
"""How much longer than the budget for placing one room may take in all [s]."""
_FOLDER = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]{0,79}")


class Making(NamedTuple):
    """How rooms are made.

    Attributes:
        seed: of every room.
        budget: for placing the objects of one [s].
        rooms: folder that gets a folder for each; None for rooms that are forgotten once they are judged.
        pictures: whether each gets its pictures.
    """

    seed: int = 0
    budget: float = 900.0
    rooms: Path | None = None
    pictures: bool = False


class _Task(NamedTuple):
    annotation: Annotation
    making: Making | None
    finished: Path | None


def judge_new_rooms(annotations: Sequence[Annotation], making: Making, *, jobs: int = 1) -> Iterator[Judgement]:
    """Make a room for each prompt and judge it; in the order in which they are done.

    Raises:
        InputError: an id that cannot be the name of a folder, where the rooms are kept.
    """
    if making.rooms is not None:
        _check_names(annotations)
    return _judgements([_Task(a, making, None) for a in annotations], jobs, making.budget + GRACE)


def judge_rooms(annotations: Sequence[Annotation], rooms: Path, *, jobs: int = 1) -> Iterator[Judgement]:
    """Judge the rooms in `rooms`, each in the folder that its prompt's id names; a missing one counts as refused.

    Raises:
        InputError: there is no such folder, or an id that cannot be the name of one in it.
    """
    _check_names(annotations)
    if not rooms.is_dir():
        raise InputError(f"{rooms}: there is no such folder")
    return _judgements([_Task(a, None, rooms / a.id) for a in annotations], jobs, GRACE)


def _check_names(annotations: Sequence[Annotation]) -> None:
    for annotation in annotations:
        if not _FOLDER.fullmatch(annotation.id):
            raise InputError(f"the id {annotation.id!r} cannot name a folder; letters, digits, '_', '.', '-' can")


def _judgements(tasks: Sequence[_Task], jobs: int, limit: float) -> Iterator[Judgement]:
    for done in work_through(_judged, tasks, jobs=jobs, seconds=limit):
        task = tasks[done.number]
        judgement = _outcome(task.annotation, done)
        if task.making is not None and task.making.rooms is not None and not judgement.refused:
            note_placed(task.making.rooms / task.annotation.id)
        yield judgement


def _outcome(annotation: Annotation, done: Done[Judgement]) -> Judgement:
    return done.result if done.result is not None else refusal(annotation, f"a fault: {done.fault}")


def _judged(task: _Task) -> Judgement:
    """What one process does with one prompt."""
    try:
        if task.finished is not None:
            return judge_folder(task.annotation, task.finished)
        with tempfile.TemporaryDirectory() as nowhere:
            making = task.making or Making()
            folder = (making.rooms or Path(nowhere)) / (task.annotation.id if making.rooms else "room")
            began = time.perf_counter()
            _make(task.annotation.prompt, making, folder)
            return judge_folder(task.annotation, folder, seconds=time.perf_counter() - began)
    except InputError as error:
        return refusal(task.annotation, str(error))


def _make(prompt: str, making: Making, folder: Path) -> None:
    from thinkblox.generate import generate_room
    from thinkblox.placing import Effort
    from thinkblox.saving import save_room

    result = generate_room(prompt, seed=making.seed, effort=Effort(seconds=making.budget))
    save_room(result, folder, pictures=making.pictures, overwrite=True)


def judge_folder(annotation: Annotation, folder: Path, *, seconds: float = 0.0) -> Judgement:
    """Judge a finished room by the files in its folder; raises InputError where they cannot be read."""
    report = read_report(folder)
    return Judgement(
        id=annotation.id,
        style=annotation.style,
        prompt=annotation.prompt,
        rows=judge_room(annotation, read_scene(folder)),
        complete=None if report is None else report.complete,
        valid=None if report is None else report.valid,
        seconds=seconds,
    )


def refusal(annotation: Annotation, why: str) -> Judgement:
    """The judgement on a prompt without a room: nothing that it demands is met."""
    nothing = SceneRecord(room=RoomRecord(floor=((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))))
    return Judgement(
        id=annotation.id,
        style=annotation.style,
        prompt=annotation.prompt,
        rows=tuple(_unmet(row) for row in judge_room(annotation, nothing)),
        refused=why,
    )


def _unmet(row: JudgedRow) -> JudgedRow:
    return row if row.met is None else msgspec.structs.replace(row, met=False, says="there is no room")
