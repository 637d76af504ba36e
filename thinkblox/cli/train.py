"""`thinkblox train`: a policy learns from demonstrations, then from what is measured of its own placements."""

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


def _train(arguments: argparse.Namespace) -> int:
    from thinkblox.training.config import section

    config = section(arguments.config, arguments.way)
    if arguments.way == "sft":
        from thinkblox.training.sft import train_sft

        folder = train_sft(config)
    else:
        from thinkblox.training.gdpo import train_gdpo

        folder = train_gdpo(config)
    say(f"written to {folder}; --policy hf:{folder} lets it place objects")
    return 0
