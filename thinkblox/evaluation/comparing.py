"""Measuring several policies on the same prompts, and where the tables are written."""

from collections.abc import Callable, Sequence
from pathlib import Path

from thinkblox.errors import InputError
from thinkblox.evaluation.comparison import Comparison, ContenderResult, comparison_json, comparison_markdown
from thinkblox.evaluation.contenders import Contender
from thinkblox.evaluation.folder import JSON, MARKDOWN, make_folder
from thinkblox.evaluation.kept_rooms import KeptRooms
from thinkblox.evaluation.policy_run import Trial, measured_rooms
from thinkblox.evaluation.ratings import RoomRater
from thinkblox.evaluation.room_tally import RoomTally
from thinkblox.players import EXPERT
from thinkblox.regular_file import read_lines
from thinkblox.whole_file import write_whole

ROOMS = "rooms"
"""Folder of a file for each room that was measured, so that a run that was stopped goes on."""
MOST = 100_000
"""Prompts of a file."""
Told = Callable[[Contender, RoomTally], None]


def read_prompts(file: Path) -> tuple[str, ...]:
    """Prompts, one a line; raises InputError."""
    prompts = read_lines(file)
    if not 0 < len(prompts) <= MOST:
        raise InputError(f"{file}: holds {len(prompts) or 'no'} prompts; give one a line, at most {MOST}")
    return prompts


def checked_judge(spec: str | None) -> str:
    """The name of a judge that answers; empty where there is none. Raises InputError before hours are spent."""
    if spec is None:
        return ""
    rater = RoomRater(spec)
    rater.check()
    return rater.name


def measured(contender: Contender, trial: Trial, *, jobs: int, on_room: Told) -> ContenderResult:
    """All rooms of a contender; raises NoPolicyError where it cannot be had, or is gone."""
    rooms = []
    for room in measured_rooms(contender, trial, jobs=jobs):
        on_room(contender, room)
        rooms.append(room)
    rooms.sort(key=lambda room: (room.run, room.prompt))
    return ContenderResult(contender=contender, rooms=tuple(rooms))


def try_out(contenders: Sequence[Contender], trial: Trial) -> None:
    """Let each model furnish the first room, so that one that cannot is found out before the others take hours.

    Raises:
        NoPolicyError: it cannot be had, or is gone.
    """
    once = trial._replace(prompts=trial.prompts[:1], runs=1)
    for contender in contenders if len(contenders) > 1 else ():
        if contender.policy != EXPERT:
            list(measured_rooms(contender, once))


def named_apart(contenders: Sequence[Contender]) -> None:
    """Raise InputError where two have one name."""
    names = [contender.name for contender in contenders]
    if twice := next((name for name in names if names.count(name) > 1), ""):
        raise InputError(f"{twice} is named twice; each policy is measured once")


def kept_rooms(out: Path | None, *, anew: bool) -> KeptRooms | None:
    """What is measured in a run that is written to `out`, taken down room by room; None where nothing is written."""
    return None if out is None else KeptRooms(out / ROOMS, anew=anew)


def write_comparison(comparison: Comparison, out: Path) -> None:
    """Write both files, and make their folder; raises InputError."""
    make_folder(out)
    write_whole(out / JSON, comparison_json(comparison))
    write_whole(out / MARKDOWN, comparison_markdown(comparison).encode("utf-8", "replace"))
