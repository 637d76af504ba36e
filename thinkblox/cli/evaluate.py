"""`thinkblox evaluate`: judge rooms, or the reading of prompts, by annotations of what the prompts demand."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.cli.options import natural, seconds, whole
from thinkblox.cli.terminal import say, write_json

if TYPE_CHECKING:
    from collections.abc import Sequence

    from thinkblox.cli.options import Commands
    from thinkblox.evaluation.annotations import Annotation
    from thinkblox.evaluation.results import Evaluation

STATUS = (
    "exit status: 0 every demand is met; 1 judged, but not all are met; 2 the input cannot be used; 70 a fault of ours;"
    " 130 stopped, it says what was written"
)


def add_command(commands: "Commands") -> None:
    """Add the command and its options."""
    parser = commands.add_parser("evaluate", help="judge rooms by what their prompts demand", epilog=STATUS)
    parser.add_argument(
        "--annotations", metavar="FILE", type=Path, required=True, help="SceneEval's CSV, or JSON: see the guide"
    )
    parser.add_argument(
        "--reading", action="store_true", help="judge the reading of the prompts alone, and make no room"
    )
    parser.add_argument("--rooms", metavar="DIR", type=Path, help="judge the rooms in DIR/<id> instead of making them")
    parser.add_argument(
        "--out", metavar="DIR", type=Path, help="write evaluation.json and evaluation.md, and new rooms"
    )
    parser.add_argument("--only", metavar="ID", action="append", default=[], help="only this prompt (may be repeated)")
    parser.add_argument("--limit", metavar="N", type=_limit, help="only the first N prompts")
    parser.add_argument("--jobs", metavar="N", type=_jobs, default=1, help="rooms made at the same time (1)")
    parser.add_argument("--seed", metavar="N", type=natural, default=0, help="of every room (0)")
    parser.add_argument(
        "--budget", metavar="S", type=seconds, default=900.0, help="for placing the objects of one (900)"
    )
    parser.add_argument("--json", action="store_true", help="print the evaluation as JSON")
    parser.set_defaults(run=_evaluate)


def _limit(text: str) -> int:
    return whole(text, 1, 1_000_000)


def _jobs(text: str) -> int:
    return whole(text, 1, 256)


def _evaluate(arguments: argparse.Namespace) -> int:
    from thinkblox.evaluation.annotation_file import read_annotations
    from thinkblox.evaluation.document import as_json, as_text, failure_lines
    from thinkblox.evaluation.selecting import selected

    chosen = selected(read_annotations(arguments.annotations), only=arguments.only, limit=arguments.limit)
    evaluation = _reading(arguments, chosen)
    if arguments.json:
        write_json(as_json(evaluation))
    else:
        for judgement in evaluation.judgements:
            for line in failure_lines(judgement):
                say(line)
        say(f"\n{as_text(evaluation)}")
    return 0 if all(judgement.whole for judgement in evaluation.judgements) else 1


def _reading(arguments: argparse.Namespace, chosen: "Sequence[Annotation]") -> "Evaluation":
    from thinkblox.evaluation.read_run import judge_reading
    from thinkblox.evaluation.results import Evaluation
    from thinkblox.reading import GrammarBriefer

    judged = judge_reading(chosen, GrammarBriefer())
    return Evaluation(of="reading", annotations=arguments.annotations.name, judgements=judged)
