"""`thinkblox assets`: what there is to furnish with."""

import argparse
from typing import TYPE_CHECKING

from thinkblox.cli.terminal import say, write_json

if TYPE_CHECKING:
    from thinkblox.cli.options import Commands

STATUS = "exit status: 0 printed; 2 there is no such category"


def add_command(commands: "Commands") -> None:
    """Add the command and its options."""
    parser = commands.add_parser("assets", help="what there is to furnish with", epilog=STATUS)
    asked = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    listing = asked.add_parser("list", help="the categories of the catalogue, with sizes and masses", epilog=STATUS)
    listing.add_argument("--category", metavar="NAME", help="all about one of them")
    listing.add_argument("--json", action="store_true", help="print as JSON: everything about each")
    listing.set_defaults(run=_list)


def _list(arguments: argparse.Namespace) -> int:
    from thinkblox import printing
    from thinkblox.assets import CATALOGUE, category_of
    from thinkblox.listing import listed
    from thinkblox.value import all_to_json

    one = arguments.category is not None
    entries = [listed(kind) for kind in ([category_of(arguments.category)] if one else CATALOGUE.values())]
    if arguments.json:
        write_json(all_to_json(entries))
    else:
        say(printing.category(entries[0]) if one else printing.categories(entries))
    return 0
