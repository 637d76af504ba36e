"""`thinkblox ablate`: the table of the paper's ablations over models of one's own."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.cli.measuring import shown, teller
from thinkblox.cli.options import seconds, whole
from thinkblox.cli.terminal import say

if TYPE_CHECKING:
    from thinkblox.cli.options import Commands

STATUS = (
    "exit status: 0 every row is measured; 1 some rows are missing, or rooms were refused; 2 the input cannot be used;"
    " 70 a fault of ours; 130 stopped: the same command goes on"
)


def add_command(commands: "Commands") -> None:
    """Add the command and its options."""
    parser = commands.add_parser("ablate", help="measure the models of the paper's ablations", epilog=STATUS)
    config = "YAML that names the prompts and the models; see docs/evaluation.md"
    parser.add_argument("--config", metavar="FILE", type=Path, required=True, help=config)
    parser.add_argument("--out", metavar="DIR", type=Path, help="write evaluation.json, evaluation.md and rooms there")
    parser.add_argument("--limit", metavar="N", type=_count, help="only the first N prompts")
    parser.add_argument("--jobs", metavar="N", type=_count, default=1, help="processes that furnish rooms (1)")
    parser.add_argument("--budget", metavar="S", type=seconds, default=900.0, help="for placing a room's objects (900)")
    parser.add_argument("--overwrite", action="store_true", help="replace an evaluation that is there")
    parser.add_argument("--json", action="store_true", help="print the evaluation as JSON")
    parser.set_defaults(run=_ablate)


def _count(text: str) -> int:
    return whole(text, 1, 1_000_000)


def _ablate(arguments: argparse.Namespace) -> int:
    from thinkblox.evaluation.ablation import ablation_rows, measured_row, read_ablation
    from thinkblox.evaluation.comparing import checked_judge, kept_rooms, read_prompts
    from thinkblox.evaluation.folder import check_evaluation
    from thinkblox.evaluation.policy_run import Trial

    ablation, home = read_ablation(arguments.config), arguments.config.parent.absolute()
    prompts = read_prompts(home / ablation.prompts)[: arguments.limit]
    if arguments.out is not None:
        check_evaluation(arguments.out, overwrite=arguments.overwrite)
    judge = checked_judge(ablation.judge)
    trial = Trial(
        prompts=prompts,
        runs=ablation.runs,
        seed=ablation.seed,
        budget=arguments.budget,
        judge=ablation.judge or "",
        kept=kept_rooms(arguments.out, anew=arguments.overwrite),
    )
    tell, rows = teller(trial, quiet=arguments.json), []
    for row in ablation_rows():
        rows.append(measured_row(row, ablation, home, trial, jobs=arguments.jobs, on_room=tell))
        if rows[-1].missing and not arguments.json:
            say(f"{row.name}: missing: {rows[-1].missing}")
    return shown(arguments, trial, Path(ablation.prompts).name, judge, rows)
