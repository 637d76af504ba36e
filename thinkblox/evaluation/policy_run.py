"""Letting policies furnish rooms with their own first answers, in several processes, and taking it down."""

import time
from collections.abc import Iterator, Sequence
from functools import lru_cache
from hashlib import sha256
from typing import NamedTuple

import msgspec
from msgspec import structs

from thinkblox.crew import work_through
from thinkblox.errors import InputError, UnavailableError
from thinkblox.evaluation.contenders import Contender, NoPolicyError, Player, Spent
from thinkblox.evaluation.kept_rooms import KeptRooms
from thinkblox.evaluation.ratings import RoomRater
from thinkblox.evaluation.room_tally import RoomTally, tally_of
from thinkblox.furnishing import BrokenOffError, Generation
from thinkblox.generate import generate_room
from thinkblox.orders import Order
from thinkblox.placing import Effort

GRACE = 600.0
"""How much longer than the budget for placing one room may take in all, a model being loaded before it [s]."""


class Trial(NamedTuple):
    """How contenders are measured.

    Attributes:
        prompts: each is furnished.
        runs: how often.
        seed: of the first run; each other has the next one.
        budget: for placing the objects of a room [s].
        judge: who rates pictures; empty for nobody.
        kept: where what is measured is taken down, and not measured again; nowhere when None.
    """

    prompts: tuple[str, ...]
    runs: int = 1
    seed: int = 0
    budget: float = 900.0
    judge: str = ""
    kept: KeptRooms | None = None


class _Task(NamedTuple):
    contender: Contender
    text: str
    prompt: int
    run: int
    seed: int
    budget: float
    judge: str


class _Answer(NamedTuple):
    tally: RoomTally | None = None
    unusable: str = ""


def measured_rooms(contender: Contender, trial: Trial, *, jobs: int = 1) -> Iterator[RoomTally]:
    """Furnish every prompt, and give what was measured; what is done already comes first.

    Raises:
        NoPolicyError: the policy or the judge cannot be had, or is gone; what is done is kept.
    """
    left = []
    for task in _tasks(contender, trial):
        before = None if trial.kept is None else trial.kept.read(_name(task))
        if before is None:
            left.append(task)
        else:
            yield structs.replace(before, prompt=task.prompt, run=task.run)
    for done in work_through(_measured, left, jobs=jobs, seconds=trial.budget + GRACE):
        task = left[done.number]
        answer = done.result or _Answer(RoomTally(prompt=task.prompt, run=task.run, refused=f"a fault: {done.fault}"))
        if answer.tally is None:
            raise NoPolicyError(f"{contender.name}: {answer.unusable}")
        if done.result is not None and trial.kept is not None:
            trial.kept.keep(_name(task), answer.tally)
        yield answer.tally


def _tasks(contender: Contender, trial: Trial) -> Sequence[_Task]:
    return [
        _Task(contender, text, number, run, trial.seed + run - 1, trial.budget, trial.judge)
        for run in range(1, trial.runs + 1)
        for number, text in enumerate(trial.prompts, 1)
    ]


def _name(task: _Task) -> str:
    """A name by all that decides on the room, and not by the name of the row or the prompt's number."""
    contender = structs.replace(task.contender, name="")
    said = (contender, contender.stamp, task.text, task.seed, task.budget, task.judge)
    return sha256(msgspec.json.encode(said)).hexdigest()[:16]


def _measured(task: _Task) -> _Answer:
    """What one process does with one prompt."""
    try:
        player = _player(structs.replace(task.contender, name=""))
        rater = _rater(task.judge) if task.judge else None
    except InputError as error:
        return _Answer(unusable=str(error))
    try:
        return _Answer(_furnished(task, player, rater))
    except (BrokenOffError, UnavailableError) as error:
        return _Answer(unusable=str(error))
    except InputError as error:
        return _Answer(RoomTally(prompt=task.prompt, run=task.run, refused=str(error)))


def _furnished(task: _Task, player: Player, rater: RoomRater | None) -> RoomTally:
    before, began = player.spent, time.perf_counter()
    made = first_answers(task.text, player, order=task.contender.order, seed=task.seed, budget=task.budget)
    tally = structs.replace(
        tally_of(made, prompt=task.prompt, run=task.run), seconds=round(time.perf_counter() - began, 3)
    )
    if before is not None and (after := player.spent) is not None:
        spent = Spent(after.read - before.read, after.written - before.written)
        tally = structs.replace(tally, read=spent.read, written=spent.written)
    rating = None if rater is None else rater.rating(made.scene)
    return tally if rating is None else structs.replace(tally, **structs.asdict(rating))


def first_answers(text: str, player: Player, *, order: Order, seed: int, budget: float) -> Generation:
    """A room of a policy's first answers alone: one for each object, and what is not valid is left out.

    Who reads the prompt and who plans is the same for all policies.
    """
    effort = Effort(candidates=1, rounds=1, repairs=0, revisions=0, restarts=0, resort=False, seconds=budget)
    return generate_room(
        text,
        seed=seed,
        policy=player.policy(),
        briefer="expert",
        planner="expert",
        order=order,
        effort=effort,
    )


@lru_cache(maxsize=1)
def _player(contender: Contender) -> Player:
    return Player(contender)


@lru_cache(maxsize=1)
def _rater(spec: str) -> RoomRater:
    return RoomRater(spec)
