"""`thinkblox edit`: change a finished room by an instruction."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.cli.options import natural
from thinkblox.cli.stopping import heed_stops
from thinkblox.cli.terminal import say, write_json

if TYPE_CHECKING:
    from thinkblox.cli.options import Commands
    from thinkblox.editing import Edit

STATUS = (
    "exit status: 0 all done as asked, and everything passed; 1 written, but something could not be done, was not"
    " understood or does not pass; 2 the room or the instruction cannot be used, nothing was written"
)


def add_command(commands: "Commands") -> None:
    """Add the command and its options."""
    parser = commands.add_parser("edit", help="change a finished room by an instruction", epilog=STATUS)
    parser.add_argument("scene", metavar="SCENE", type=Path, help="folder of a room, or its scene.json")
    parser.add_argument("instruction", metavar="INSTRUCTION", nargs="?", help="what to change; see docs/editing.md")
    parser.add_argument("--out", metavar="DIR", type=Path, required=True, help="folder to write; whole or not at all")
    parser.add_argument("--undo", action="store_true", help="take the last edit back instead")
    parser.add_argument("--seed", metavar="N", type=natural, default=0, help="other choices (0)")
    parser.add_argument(
        "--policy", metavar="WHO", default="expert", help="who says where things go; docs/models.md (expert)"
    )
    parser.add_argument("--no-pictures", action="store_true", help="leave out preview.png and top.png")
    parser.add_argument("--overwrite", action="store_true", help="replace a room that is there, such as SCENE itself")
    parser.add_argument("--json", action="store_true", help="print the report as JSON")
    parser.set_defaults(run=_edit, late="instruction")


def _edit(arguments: argparse.Namespace) -> int:
    from thinkblox.errors import InputError
    from thinkblox.exporters.folder import check_folder
    from thinkblox.saving import save_room
    from thinkblox.value import to_json

    if arguments.undo == (arguments.instruction is not None):
        raise InputError("give an instruction, or --undo without one")
    check_folder(arguments.out, overwrite=arguments.overwrite)
    result = _edited(arguments)
    heed_stops()
    save_room(result, arguments.out, pictures=not arguments.no_pictures, overwrite=arguments.overwrite)
    if arguments.json:
        write_json(to_json(result.report))
    else:
        _tell(result)
        say(f"written to {arguments.out}")
    return 0 if result.report.complete else 1


def _edited(arguments: argparse.Namespace) -> "Edit":
    from thinkblox.editing import edit_room, undo_edit

    if arguments.undo:
        return undo_edit(arguments.scene)
    return edit_room(arguments.scene, arguments.instruction, seed=arguments.seed, policy=arguments.policy)


def _tell(result: "Edit") -> None:
    from thinkblox import printing

    for text in result.done:
        say(text)
    for text in result.failed:
        say(f"not done: {text}")
    for text in result.notes:
        say(f"note: {text}")
    if result.unknown:
        say(f"words not understood: {', '.join(result.unknown)}")
    say(printing.in_figures(result.report, placed=len(result.scene.placements)))
    changed = {change.id for change in result.changes}
    kept = sum(placement.id not in changed for placement in result.scene.placements)
    say(f"{len(changed)} changed, {kept} as they were")
    say(
        "done as asked"
        if result.report.complete
        else "done as asked; some of what the room was made for is not so, as before"
        if result.report.valid and not result.failed and not result.unknown
        else "not all done as asked"
        if result.report.valid
        else "not all passed"
    )
