"""`thinkblox train`: a policy learns from demonstrations and from what is measured; what came of it is told."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.cli.terminal import say

if TYPE_CHECKING:
    from thinkblox.cli.options import Commands

STATUS = (
    "exit status: 0 trained; 2 the configuration, the dataset or the model cannot be used; 70 a fault of ours or of the"
    " system; 130 stopped: the same command goes on from the last checkpoint"
)


def add_command(commands: "Commands") -> None:
    """Add the command and its options."""
    train = commands.add_parser("train", help="train a policy")
    ways = train.add_subparsers(title="ways", required=True, metavar="WAY")
    for way, says in (("sft", "supervised, on demonstrations"), ("gdpo", "by rewards measured in simulation")):
        parser = ways.add_parser(way, help=says, epilog=STATUS)
        config = f"YAML with a section `{way}`; training/configs has some"
        parser.add_argument("--config", metavar="FILE", type=Path, required=True, help=config)
        parser.set_defaults(run=_train, way=way)
    score = ways.add_parser("score", help="let somebody answer the steps of held-out rooms, and measure that")
    score.add_argument(
        "who", metavar="WHO", nargs="+", help="expert, usual, anywhere, first-free, or NAME=MODEL_FOLDER"
    )
    score.add_argument("--data", metavar="DIR", type=Path, required=True, help="a dataset of `thinkblox data build`")
    score.add_argument("--out", metavar="FILE", type=Path, required=True, help="scores.json; is added to")
    score.add_argument("--split", choices=("train", "validation", "test"), default="test")
    score.add_argument("--most", metavar="N", type=int, default=0, help="rows, evenly spread; all when 0")
    score.add_argument(
        "--temperature", metavar="T", type=float, default=0.0, help="of models; 0 is the likeliest answer"
    )
    score.add_argument("--workers", metavar="N", type=int, default=2, help="processes that measure")
    score.set_defaults(run=_score)
    report = ways.add_parser("report", help="tables and curves of runs and scores")
    report.add_argument(
        "results", metavar="DIR", type=Path, help="NAME/config.json, NAME/trainer_state.json, scores.json"
    )
    report.add_argument(
        "--out", metavar="FILE", type=Path, required=True, help="Markdown; between its two marks it is made"
    )
    report.add_argument("--pictures", metavar="DIR", type=Path, required=True, help="where loss.png and reward.png go")
    report.set_defaults(run=_report)


def _score(arguments: argparse.Namespace) -> int:
    from thinkblox.training.scoring import score_all

    for scored in score_all(
        arguments.who,
        arguments.data,
        arguments.out,
        split=arguments.split,
        most=arguments.most,
        temperature=arguments.temperature,
        workers=arguments.workers,
    ):
        s = scored.score
        say(f"{scored.who}: {s.steps} steps, {s.parsed:.1%} read, {s.valid:.1%} valid, soft {s.soft:.3f}")
    return 0


def _report(arguments: argparse.Namespace) -> int:
    from thinkblox.training.report import report, write_between

    write_between(arguments.out, report(arguments.results, arguments.pictures))
    say(f"written to {arguments.out} and {arguments.pictures}")
    return 0


def _train(arguments: argparse.Namespace) -> int:
    from thinkblox.training.config import section
    from thinkblox.training.running import finished

    config = section(arguments.config, arguments.way)
    if (done := finished(config)) is not None:
        say(f"finished before, all {config.steps} steps; nothing was done; the model is in {done}")
        return 0
    if arguments.way == "sft":
        from thinkblox.training.sft import train_sft

        folder = train_sft(config)
    else:
        from thinkblox.training.gdpo import train_gdpo

        folder = train_gdpo(config)
    say(f"written to {folder}; --policy hf:{folder} lets it place objects")
    return 0
