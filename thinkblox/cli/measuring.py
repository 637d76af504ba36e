"""Measuring policies on prompts: `thinkblox evaluate --policy P --prompts FILE`."""

import argparse
from collections.abc import Sequence
from typing import TYPE_CHECKING

from thinkblox.cli.options import MARKS, whole
from thinkblox.cli.stopping import heed_stops
from thinkblox.cli.terminal import say, write_json
from thinkblox.errors import InputError
from thinkblox.modes import MODES
from thinkblox.orders import ORDERS

if TYPE_CHECKING:
    from thinkblox.evaluation.comparing import Told
    from thinkblox.evaluation.comparison import ContenderResult
    from thinkblox.evaluation.contenders import Contender
    from thinkblox.evaluation.policy_run import Trial
    from thinkblox.evaluation.room_tally import RoomTally

_OF_POLICIES = ("policy", "runs", "judge", "mode", "order", "without")
_OF_ANNOTATIONS = ("reading", "rooms", "only", "pictures")


def add_policies(parser: argparse.ArgumentParser) -> None:
    """Add the options for measuring policies."""
    group = parser.add_argument_group("policies", "with --prompts; each gives one answer for each object")
    who = "expert, learned[:FOLDER], hf:PATH_OR_ID[+ADAPTER] or openai:BASE_URL#MODEL (may be repeated)"
    group.add_argument("--policy", metavar="WHO", action="append", default=[], help=who)
    group.add_argument("--runs", metavar="N", type=_runs, help="how often each prompt is furnished, seeds one up (3)")
    rates = "openai:BASE_URL#MODEL: rates pictures of the rooms, for Pos, Rot and PSA"
    group.add_argument("--judge", metavar="WHO", help=rates)
    group.add_argument("--mode", choices=MODES, help="ask models object by object (progressive), or once for a room")
    group.add_argument("--order", choices=ORDERS, help="what is placed first (plan)")
    less = "do not show models this; may be repeated"
    group.add_argument("--without", choices=MARKS, action="append", default=[], help=less)


def _runs(text: str) -> int:
    return whole(text, 1, 1000)


def check_options(arguments: argparse.Namespace) -> None:
    """Raise InputError for options that are for the other kind of evaluation."""
    by, names = ("--prompts", _OF_ANNOTATIONS) if arguments.prompts is not None else ("--annotations", _OF_POLICIES)
    stray = [name for name in names if getattr(arguments, name)]
    if stray:
        raise InputError(f"--{stray[0]} does not go with {by}")
    if arguments.prompts is not None and not arguments.policy:
        raise InputError("which policies? Give --policy expert, hf:PATH or openai:BASE_URL#MODEL, once for each")


def measure_policies(arguments: argparse.Namespace) -> int:
    """Measure, print and write; returns the exit status."""
    from thinkblox.evaluation.comparing import (
        checked_judge,
        kept_rooms,
        measured,
        named_apart,
        read_prompts,
        try_out,
    )
    from thinkblox.evaluation.contenders import Contender
    from thinkblox.evaluation.folder import check_evaluation
    from thinkblox.evaluation.policy_run import Trial

    contenders = [
        Contender(
            name=policy,
            policy=policy,
            mode=arguments.mode or "progressive",
            order=arguments.order or "plan",
            without=tuple(dict.fromkeys(arguments.without)),
        )
        for policy in arguments.policy
    ]
    named_apart(contenders)
    for contender in contenders:
        contender.check()
    prompts = read_prompts(arguments.prompts)[: arguments.limit]
    if arguments.out is not None:
        check_evaluation(arguments.out, overwrite=arguments.overwrite)
    judge = checked_judge(arguments.judge)
    trial = Trial(
        prompts=prompts,
        runs=arguments.runs or 3,
        seed=arguments.seed,
        budget=arguments.budget,
        judge=arguments.judge or "",
        kept=kept_rooms(arguments.out, anew=arguments.overwrite),
    )
    try_out(contenders, trial)
    tell = teller(trial, quiet=arguments.json)
    rows = [measured(contender, trial, jobs=arguments.jobs, on_room=tell) for contender in contenders]
    return shown(arguments, trial, arguments.prompts.name, judge, rows)


def shown(
    arguments: argparse.Namespace, trial: "Trial", prompts: str, judge: str, rows: "Sequence[ContenderResult]"
) -> int:
    """Write and print what was measured; returns the exit status."""
    from thinkblox.evaluation.comparing import write_comparison
    from thinkblox.evaluation.comparison import Comparison, comparison_json, comparison_text

    comparison = Comparison(
        prompts=prompts, count=len(trial.prompts), runs=trial.runs, seed=trial.seed, judge=judge, rows=tuple(rows)
    )
    if arguments.out is not None:
        write_comparison(comparison, arguments.out)
    if arguments.json:
        write_json(comparison_json(comparison))
    else:
        say(f"\n{comparison_text(comparison)}")
        if arguments.out is not None:
            say(f"written to {arguments.out}")
    return 0 if all(_whole(row) for row in rows) else 1


def _whole(row: "ContenderResult") -> bool:
    return not row.missing and not any(room.refused for room in row.rooms)


def teller(trial: "Trial", *, quiet: bool) -> "Told":
    """Says a line for each room."""

    def tell(contender: "Contender", room: "RoomTally") -> None:
        heed_stops()
        if quiet:
            return
        where = f"{contender.name}, prompt {room.prompt} of {len(trial.prompts)}, run {room.run}"
        valid = sum(step.valid for step in room.steps)
        says = (
            f"refused: {room.refused}" if room.refused else f"{valid} of {room.planned} valid in {room.seconds:.1f} s"
        )
        say(f"{where}: {says}")

    return tell
