"""`thinkblox evaluate`: judge rooms by annotations of what their prompts demand, or measure policies on prompts."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.cli.measuring import add_policies, check_options, measure_policies
from thinkblox.cli.options import natural, seconds, whole
from thinkblox.cli.stopping import heed_stops
from thinkblox.cli.terminal import say, write_json

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from thinkblox.cli.options import Commands
    from thinkblox.evaluation.annotations import Annotation
    from thinkblox.evaluation.results import Evaluation, Judgement

STATUS = (
    "exit status: 0 every demand is met, or every room of every policy is measured; 1 judged or measured, but not so; 2"
    " the input cannot be used; 70 a fault of ours; 130 stopped, it says what was written"
)


def add_command(commands: "Commands") -> None:
    """Add the command and its options."""
    parser = commands.add_parser("evaluate", help="judge rooms by their prompts, or measure policies", epilog=STATUS)
    annotations = "what each prompt demands: CSV as SceneEval publishes it, or JSON; see the guide"
    by = parser.add_mutually_exclusive_group(required=True)
    by.add_argument("--annotations", metavar="FILE", type=Path, help=annotations)
    by.add_argument("--prompts", metavar="FILE", type=Path, help="measure policies on these prompts, one a line")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--reading", action="store_true", help="judge the reading of the prompts alone, without rooms")
    what.add_argument("--rooms", metavar="DIR", type=Path, help="judge the rooms in DIR/<id> instead of making them")
    out = "write evaluation.json and evaluation.md there, and in rooms what is made or measured"
    parser.add_argument("--out", metavar="DIR", type=Path, help=out)
    parser.add_argument("--only", metavar="ID", action="append", default=[], help="only this prompt (may be repeated)")
    parser.add_argument("--limit", metavar="N", type=_limit, help="only the first N prompts")
    parser.add_argument("--jobs", metavar="N", type=_jobs, default=1, help="processes that make and judge rooms (1)")
    parser.add_argument("--seed", metavar="N", type=natural, default=0, help="of every room (0)")
    parser.add_argument("--budget", metavar="S", type=seconds, default=900.0, help="for placing a room's objects (900)")
    parser.add_argument("--pictures", action="store_true", help="make the pictures of every room too")
    parser.add_argument("--overwrite", action="store_true", help="replace an evaluation that is there")
    parser.add_argument("--json", action="store_true", help="print the evaluation as JSON")
    add_policies(parser)
    parser.set_defaults(run=_evaluate)


def _limit(text: str) -> int:
    return whole(text, 1, 1_000_000)


def _jobs(text: str) -> int:
    return whole(text, 1, 256)


def _evaluate(arguments: argparse.Namespace) -> int:
    check_options(arguments)
    return measure_policies(arguments) if arguments.prompts is not None else _judge(arguments)


def _judge(arguments: argparse.Namespace) -> int:
    from thinkblox.evaluation.annotation_file import read_annotations
    from thinkblox.evaluation.document import as_json, as_text
    from thinkblox.evaluation.folder import check_evaluation, write_evaluation
    from thinkblox.evaluation.selecting import selected

    chosen = selected(read_annotations(arguments.annotations), only=arguments.only, limit=arguments.limit)
    if arguments.out is not None:
        check_evaluation(arguments.out, overwrite=arguments.overwrite)
    evaluation = _evaluated(arguments, chosen)
    if arguments.out is not None:
        write_evaluation(evaluation, arguments.out)
    if arguments.json:
        write_json(as_json(evaluation))
    else:
        say(f"\n{as_text(evaluation)}")
        if arguments.out is not None:
            say(f"written to {arguments.out}")
    return 0 if all(judgement.whole for judgement in evaluation.judgements) else 1


def _evaluated(arguments: argparse.Namespace, chosen: "Sequence[Annotation]") -> "Evaluation":
    from thinkblox.evaluation.results import Evaluation

    order = {annotation.id: number for number, annotation in enumerate(chosen)}
    judgements: list[Judgement] = []
    for judgement in _judgements(arguments, chosen):
        heed_stops()
        judgements.append(judgement)
        if not arguments.json:
            _tell(judgement, timed=not arguments.reading)
    return Evaluation(
        of="reading" if arguments.reading else "rooms",
        annotations=arguments.annotations.name,
        seed=arguments.seed,
        judgements=tuple(sorted(judgements, key=lambda judgement: order[judgement.id])),
    )


def _judgements(arguments: argparse.Namespace, chosen: "Sequence[Annotation]") -> "Iterable[Judgement]":
    if arguments.reading:
        from thinkblox.evaluation.read_run import judge_reading
        from thinkblox.reading import GrammarBriefer

        return judge_reading(chosen, GrammarBriefer())
    from thinkblox.evaluation.room_run import Making, judge_new_rooms, judge_rooms

    if arguments.rooms is not None:
        return judge_rooms(chosen, arguments.rooms, jobs=arguments.jobs)
    making = Making(
        seed=arguments.seed,
        budget=arguments.budget,
        rooms=None if arguments.out is None else arguments.out / "rooms",
        pictures=arguments.pictures,
    )
    return judge_new_rooms(chosen, making, jobs=arguments.jobs)


def _tell(judgement: "Judgement", *, timed: bool) -> None:
    from thinkblox.evaluation.document import failure_lines, verdict_line

    if timed:
        say(verdict_line(judgement))
    for line in failure_lines(judgement):
        say(line)
