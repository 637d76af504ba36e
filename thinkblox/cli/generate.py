"""`thinkblox generate`: furnish a room from a prompt."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.cli.options import MARKS, natural, seconds, whole
from thinkblox.cli.progress import ObjectBar
from thinkblox.cli.stopping import heed_stops
from thinkblox.cli.terminal import say, write_json
from thinkblox.errors import InputError
from thinkblox.fills import FILLS
from thinkblox.modes import MODES
from thinkblox.orders import ORDERS

if TYPE_CHECKING:
    from thinkblox.cli.options import Commands
    from thinkblox.furnishing import BrokenOffError
    from thinkblox.observe import Sight

STATUS = (
    "exit status: 0 all as asked; 1 written, but something asked for was not placed, does not stand as asked or did not"
    " pass; 2 the input cannot be used, nothing was written, or a model"
    " cannot go on, and what was tried is kept; 70 a fault of ours; 130 stopped, it says what was written"
)


def add_command(commands: "Commands") -> None:
    """Add the command and its options."""
    parser = commands.add_parser("generate", help="furnish a room from a prompt", epilog=STATUS)
    parser.add_argument("prompt", metavar="PROMPT", help="what the room should be")
    parser.add_argument("--out", metavar="DIR", type=Path, required=True, help="folder to write; whole or not at all")
    parser.add_argument("--seed", metavar="N", type=natural, default=0, help="same prompt, same seed, same room (0)")
    parser.add_argument(
        "--room", metavar="FILE", type=Path, help="furnish this room: JSON with floor, height, openings"
    )
    parser.add_argument("--candidates", metavar="N", type=_candidates, default=8, help="poses proposed per round (8)")
    parser.add_argument(
        "--fill",
        choices=FILLS,
        default="essentials",
        help="what is added: only what carries things, what makes such a room (essentials), or a lived-in room",
    )
    add_roles(parser)
    parser.add_argument(
        "--order",
        choices=ORDERS,
        default="plan",
        help="what is placed first: as planned, large things, or by chance; never before what it depends on (plan)",
    )
    budget = "for placing objects (900); the measurement under way is finished, and the whole room measured, after it"
    parser.add_argument("--budget", metavar="S", type=seconds, default=900.0, help=budget)
    parser.add_argument("--no-pictures", action="store_true", help="leave out preview.png and top.png")
    parser.add_argument("--overwrite", action="store_true", help="replace an output folder of an earlier run")
    parser.add_argument("--json", action="store_true", help="print the report as JSON")
    parser.set_defaults(run=_generate)


def add_roles(parser: argparse.ArgumentParser) -> None:
    """Add the options that say who plays which role."""
    who = "expert, learned[:FOLDER], hf:PATH_OR_ID[+ADAPTER], openai:BASE_URL#MODEL or replay:TRACE"
    roles = parser.add_argument_group("who furnishes", f"WHO is {who}")
    roles.add_argument("--policy", metavar="WHO", default="expert", help="who says where things go (expert)")
    roles.add_argument("--reader", metavar="WHO", help="who understands the prompt (as --policy)")
    roles.add_argument("--planner", metavar="WHO", help="who decides what is placed when (as --policy)")
    asks = "ask a model for one object after the other (progressive), or once for the whole room"
    roles.add_argument("--mode", choices=MODES, default="progressive", help=asks)
    less = "do not show a model this (pictures, for one that cannot see); may be repeated"
    roles.add_argument("--without", choices=MARKS, action="append", default=[], help=less)


def _candidates(text: str) -> int:
    return whole(text, 1, 256)


def _generate(arguments: argparse.Namespace) -> int:
    from thinkblox import printing
    from thinkblox.exporters.folder import check_folder
    from thinkblox.furnishing import BrokenOffError
    from thinkblox.generate import generate_room
    from thinkblox.placing import Effort
    from thinkblox.saving import save_room
    from thinkblox.scene.room import Room
    from thinkblox.value import read_json, to_json

    check_folder(arguments.out, overwrite=arguments.overwrite)
    room = None if arguments.room is None else read_json(arguments.room, Room)
    places = _is_model(arguments.policy)
    reads = _is_model(arguments.reader or arguments.policy)
    with ObjectBar(quiet=arguments.json, reads=reads, places=places) as progress:
        try:
            result = generate_room(
                arguments.prompt,
                seed=arguments.seed,
                room=room,
                policy=arguments.policy,
                briefer=arguments.reader,
                planner=arguments.planner,
                mode=arguments.mode,
                effort=Effort(candidates=arguments.candidates, seconds=arguments.budget),
                fill=arguments.fill,
                order=arguments.order,
                sight=_sight(arguments),
                on_plan=progress.begin,
                on_object=progress.tell,
                on_round=progress.hear,
            )
        except BrokenOffError as error:
            raise _kept(error, arguments.out) from error
        progress.end(result)
    heed_stops()
    save_room(result, arguments.out, pictures=not arguments.no_pictures, overwrite=arguments.overwrite)
    if arguments.json:
        write_json(to_json(result.report))
    else:
        say(printing.summary(result.report, placed=len(result.scene.placements)))
        if places:
            say(printing.whose(result.trace))
        say(printing.outcome(result.report))
        say(f"written to {arguments.out}")
    return 0 if result.report.complete else 1


def _is_model(who: str) -> bool:
    return who.partition(":")[0] in ("hf", "openai")


def _sight(arguments: argparse.Namespace) -> "Sight | None":
    """What a model is shown, where something is left out."""
    if not arguments.without:
        return None
    from thinkblox.evaluation.contenders import Contender

    if not _is_model(arguments.policy):
        raise InputError("--without is for models; give one as the policy")
    shown = Contender(
        name="--without",
        policy=arguments.policy,
        mode=arguments.mode,
        without=tuple(dict.fromkeys(arguments.without)),
    )
    shown.check()
    return shown.sight()


def _kept(error: "BrokenOffError", out: Path) -> InputError:
    """Write what was tried beside the folder of a room that did not come about; returns the error that says where."""
    from thinkblox.exporters.folder import made_parents
    from thinkblox.whole_file import write_whole

    trace = out.with_name(f"{out.name}.trace.jsonl")
    with made_parents(trace):
        write_whole(trace, error.episode.to_jsonl())
    return InputError(f"{error}; the room was broken off, and what was tried until then is in {trace}")
