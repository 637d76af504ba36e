"""`thinkblox mcp`: let an agent furnish rooms, over the Model Context Protocol."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from thinkblox.cli.options import Commands

STATUS = "exit status: 0 the agent is gone; 2 there is no such folder, or no SDK; 70 a fault of ours; 130 stopped"


def add_command(commands: "Commands") -> None:
    """Add the command and its options."""
    says = "serve rooms to an agent (MCP, on stdin and stdout)"
    parser = commands.add_parser("mcp", help=says, epilog=STATUS)
    root = "the folder in which the agent's files are read and written; nothing outside of it is"
    parser.add_argument("--root", metavar="DIR", type=Path, required=True, help=root)
    parser.set_defaults(run=_serve)


def _serve(arguments: argparse.Namespace) -> int:
    from thinkblox.serving.root import Root

    root = Root(arguments.root)
    from thinkblox.serving.server import serve

    serve(root)
    return 0
