"""`thinkblox verify`: measure a scene, ours or anybody's."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from thinkblox.cli.options import length, lengths, natural, seconds
from thinkblox.cli.terminal import say, write_json
from thinkblox.importing import FORMATS
from thinkblox.sim.suites import SUITES

if TYPE_CHECKING:
    from thinkblox.cli.options import Commands

STATUS = (
    "exit status: 0 everything passed; 1 measured, but not all passed, the output says what; 2 the input cannot be"
    " used; 70 a fault of ours; 130 stopped"
)


def add_command(commands: "Commands") -> None:
    """Add the command and its options."""
    parser = commands.add_parser("verify", help="measure a scene, ours or anybody's, object by object", epilog=STATUS)
    parser.add_argument(
        "scene",
        metavar="PATH",
        type=Path,
        help="an output folder, or a file: scene.json, MJCF, URDF, USD, or somebody's layout; of a folder with several"
        " models name the one that is meant",
    )
    suites = f"published criteria, any of {', '.join(SUITES)}; 'all' for all"
    parser.add_argument("--suite", metavar="A,B", type=_suites, default=(), help=suites)
    parser.add_argument("--html", metavar="FILE", type=Path, help="write a page with pictures and the faults in them")
    parser.add_argument("--fix", action="store_true", help="move what fails by the least that mends it")
    cap = "how far --fix moves anything at most (0.3); what needs more is listed with the distance"
    parser.add_argument("--max-move", metavar="M", type=length, help=cap)
    parser.add_argument("--out", metavar="FILE", type=Path, help="write the (mended) scene as a scene.json")
    formats = f"of a file that does not tell whose it is: thinkblox, mjcf, urdf, usd, {', '.join(FORMATS)}"
    parser.add_argument("--format", metavar="NAME", help=formats)
    parser.add_argument("--assets", metavar="DIR", type=Path, help="folder with the meshes that a layout names")
    parser.add_argument(
        "--height", metavar="M", type=length, help="of the room, where a layout has none (2.6, or what is highest)"
    )
    parser.add_argument("--room", metavar="ID", help="which room of a file that holds several")
    parser.add_argument("--short-side", metavar="M", type=length, help="of the room, for a layout in pixels")
    sizes = "JSON file, name -> [along the front, across, up] in m, for a layout without sizes"
    parser.add_argument("--sizes", metavar="FILE", type=Path, help=sizes)
    room_size = "of the room in m, for a scene graph without walls"
    parser.add_argument("--room-size", metavar="X,Y[,Z]", type=lengths, help=room_size)
    model = parser.add_argument_group("models (MJCF, URDF and USD)")
    model.add_argument(
        "--root",
        metavar="DIR",
        type=Path,
        help="folder in which all files lie that a model names (the model's own, or a URDF's package); what leads out"
        " of it, by .. or a link, is not read",
    )
    model.add_argument("--fixed-base", action="store_true", help="hold the root links of a URDF to the world")
    model.add_argument(
        "--exclude",
        metavar="NAME",
        action="append",
        default=[],
        help="leave this out, or all like 'target*' (may be repeated)",
    )
    model.add_argument(
        "--robot",
        metavar="NAME",
        action="append",
        default=[],
        help="this, or all like 'robot0*', is no furniture: it stays where it is, and is not judged (may be repeated)",
    )
    parser.add_argument("--seed", metavar="N", type=natural, default=0, help="of what suites sample (0)")
    parser.add_argument(
        "--timeout",
        metavar="S",
        type=seconds,
        default=600.0,
        help="for reading and measuring (600); loading the engine before that, a second or two, may take 120 s more",
    )
    parser.add_argument("--overwrite", action="store_true", help="replace any file with --out and --html")
    parser.add_argument("--json", action="store_true", help="print the report as JSON")
    parser.set_defaults(run=_verify)


def _suites(text: str) -> tuple[str, ...]:
    names = tuple(dict.fromkeys(name.strip() for name in text.split(",") if name.strip()))
    return SUITES if names == ("all",) else names


def _verify(arguments: argparse.Namespace) -> int:
    from thinkblox import printing
    from thinkblox.checking import VerifyOptions, verify_file
    from thinkblox.value import to_json

    reading = VerifyOptions(
        format=arguments.format,
        assets=_text(arguments.assets),
        height=arguments.height,
        room=arguments.room,
        short_side=arguments.short_side,
        sizes=_text(arguments.sizes),
        room_size=arguments.room_size,
        suites=arguments.suite,
        seed=arguments.seed,
        fix=arguments.fix,
        max_move=arguments.max_move,
        out=_text(arguments.out),
        page=_text(arguments.html),
        root=_text(arguments.root),
        fixed_base=arguments.fixed_base,
        exclude=tuple(arguments.exclude),
        robot=tuple(arguments.robot),
        overwrite=arguments.overwrite,
    )
    report = verify_file(arguments.scene, reading, timeout=arguments.timeout)
    passed = report.valid and all(suite.passed for suite in report.suites)
    if arguments.json:
        write_json(to_json(report))
        return 0 if passed else 1
    say(printing.summary(report, placed=len(report.objects)))
    if arguments.fix:
        say(f"\n{printing.moves(report)}")
    for result in report.suites:
        say(f"\n{printing.suite(result)}")
    say("all passed" if passed else "not all passed")
    return 0 if passed else 1


def _text(path: Path | None) -> str | None:
    return None if path is None else str(path)
