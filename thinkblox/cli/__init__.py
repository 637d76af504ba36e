"""The command line: `thinkblox COMMAND`, a module for each command.

Exit status 0: all as asked; 1: done, but something was not placed or did not pass; 2: unusable input; 130: stopped;
141: nobody read the output to its end.
"""

import argparse
import os
import sys
from collections.abc import Sequence
from typing import Any

from thinkblox.cli import assets, generate, render, schema, verify
from thinkblox.cli.stopping import stoppable
from thinkblox.cli.terminal import complain

EXAMPLE = 'thinkblox generate "A calm bedroom, 4 m by 5 m, with a double bed and two nightstands" --out out/bedroom'
STATUS = "exit status of every command: 0 done; 1 done, but not all is as it should be; 2 unusable input; 130 stopped"


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status."""
    arguments = _parser().parse_args(argv)
    stops: list[int] = []
    try:
        with stoppable(stops):
            return _run(arguments)
    except (KeyboardInterrupt, Exception):
        # A compiled function that is stopped while it loads or is called makes another error of it.
        if not stops:
            raise
        print("thinkblox: stopped; nothing was written", file=sys.stderr)
        return 130


def _run(arguments: argparse.Namespace) -> int:
    from thinkblox.errors import InputError

    try:
        status: int = arguments.run(arguments)
        sys.stdout.flush()
    except InputError as error:
        complain(str(error))
        return 2
    except BrokenPipeError:
        # Whoever read the output, such as `head`, has had enough; the last flush at exit must not fail too.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 141
    return status


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="thinkblox",
        description="A sentence in, a physics-verified room out.",
        epilog=f"{STATUS}\n\nexample: {EXAMPLE}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action=_ShowVersion, nargs=0, help="print the version and exit")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    for command in (generate, verify, render, assets, schema):
        command.add_command(commands)
    return parser


class _ShowVersion(argparse.Action):
    """Looks the version up only when it is asked for."""

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> None:
        from thinkblox.version import package_version

        print(f"thinkblox {package_version()}")
        parser.exit()
