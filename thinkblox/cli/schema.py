"""`thinkblox schema`: what the files that are read and written hold."""

import argparse
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from thinkblox.cli.options import Commands

STATUS = "exit status: 0 printed; 2 there is no such schema"


def add_command(commands: "Commands") -> None:
    """Add the command and its options."""
    parser = commands.add_parser("schema", help="print the JSON Schema of a file", epilog=STATUS)
    parser.add_argument("name", metavar="NAME", nargs="?", help="scene, room, report, ...; all names when left out")
    parser.set_defaults(run=_schema)


def _schema(arguments: argparse.Namespace) -> int:
    import json

    from thinkblox.schemas import SCHEMAS, published_schema

    if arguments.name is None:
        print("\n".join(SCHEMAS))
        return 0
    print(json.dumps(published_schema(arguments.name), indent=2))
    return 0
