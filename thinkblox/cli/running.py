"""Running one command, and what its end is called."""

import argparse
import contextlib
import traceback
from collections.abc import Sequence
from typing import Any

from thinkblox.cli import ablate, assets, data, edit, evaluate, export, generate, mcp, render, schema, train, verify
from thinkblox.cli.output import UnwrittenError, written_output
from thinkblox.cli.terminal import complain
from thinkblox.errors import InputError, ThinkBloxError
from thinkblox.holding import forget_placed

EXAMPLE = 'thinkblox generate "A calm bedroom, 4 m by 5 m, with a double bed and two nightstands" --out out/bedroom'
STATUS = (
    "exit status of every command: 0 done; 1 done, but not all is as it should be; 2 unusable input; 70 a fault of ours"
    " or of the system; 74 the output could not be written; 130 stopped"
)
REPORT_TO = "https://github.com/thinkblox/thinkblox/issues"
UNUSABLE, FAULT, UNWRITTEN, UNREAD = 2, 70, 74, 141


def run(argv: Sequence[str] | None, stops: list[int]) -> int:
    """Run one command; returns the exit status.

    Args:
        argv: what stands behind `thinkblox`; that of the process when None.
        stops: the signals that came so far: whatever is raised after one is a stop.
    """
    forget_placed()
    try:
        return _ended(_read(_parser(), argv))
    except Exception as error:
        if stops:
            raise
        return _fault(error)


def _read(parser: argparse.ArgumentParser, argv: Sequence[str] | None) -> argparse.Namespace:
    """The arguments, where the last of a command that may be left out can also stand behind its options."""
    arguments, left = parser.parse_known_args(argv)
    late = getattr(arguments, "late", "")
    if len(left) == 1 and not left[0].startswith("-") and late and getattr(arguments, late) is None:
        setattr(arguments, late, left.pop())
    if left:
        parser.error(f"unrecognized arguments: {' '.join(left)}")
    return arguments


def _ended(arguments: argparse.Namespace) -> int:
    try:
        with written_output():
            status: int = arguments.run(arguments)
    except InputError as error:
        _say(str(error))
        return UNUSABLE
    except UnwrittenError as error:
        if error.unread:
            return UNREAD  # whoever read the output, such as `head`, has had enough
        _say(f"the output could not be written: {error.why}")
        return UNWRITTEN
    return status


def _fault(error: Exception) -> int:
    if isinstance(error, ThinkBloxError):
        _say(str(error))
        return FAULT
    with contextlib.suppress(OSError):
        traceback.print_exception(error)
    _say(
        f"this is a fault of ours, and says nothing about your input: {type(error).__name__}: {error}\n"
        f"please report it with the command and the lines above, to {REPORT_TO}"
    )
    return FAULT


def _say(text: str) -> None:
    with contextlib.suppress(OSError):
        complain(text)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="thinkblox",
        description="A sentence in, a physics-verified room out.",
        epilog=f"{STATUS}\n\nexample: {EXAMPLE}",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action=_ShowVersion, nargs=0, help="print the version and exit")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    for command in (generate, edit, verify, evaluate, ablate, data, train, export, render, mcp, assets, schema):
        command.add_command(commands)
    return parser


class _ShowVersion(argparse.Action):
    """Looks the version up only when it is asked for."""

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> None:
        from thinkblox.version import package_version

        print(f"thinkblox {package_version()}")
        parser.exit()
