"""The command line.

Exit status 0: all as asked; 1: done, but something was not placed or did not pass; 2: unusable input; 130: stopped.
"""

import argparse
import signal
import sys
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from thinkblox.generate import Progress

EXAMPLE = 'thinkblox generate "A calm bedroom, 4 m by 5 m, with a double bed and two nightstands" --out out/bedroom'


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status."""
    from thinkblox.errors import InputError

    arguments = _parser().parse_args(argv)
    stops: list[int] = []
    try:
        with _stoppable(stops):
            status: int = arguments.run(arguments)
    except InputError as error:
        print(f"thinkblox: {error}", file=sys.stderr)
        return 2
    except (KeyboardInterrupt, ImportError):
        # A compiled module that is stopped while it loads makes an ImportError of it.
        if not stops:
            raise
        print("thinkblox: stopped; nothing was written", file=sys.stderr)
        return 130
    return status


@contextmanager
def _stoppable(stops: list[int]) -> Iterator[None]:
    """Let Ctrl-C and SIGTERM end a command as KeyboardInterrupt, so that nothing half-written stays behind.

    The signals that came are appended to `stops`.
    """

    def stop(number: int, frame: object) -> None:
        stops.append(number)
        raise KeyboardInterrupt

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    signals = (signal.SIGINT, signal.SIGTERM)
    before = [signal.signal(number, stop) for number in signals]
    try:
        yield
    finally:
        for number, handler in zip(signals, before, strict=True):
            signal.signal(number, handler)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="thinkblox",
        description="A sentence in, a physics-verified room out.",
        epilog=f"example: {EXAMPLE}",
    )
    parser.add_argument("--version", action="version", version=f"thinkblox {_version()}")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    _add_generate(commands)
    _add_verify(commands)
    _add_render(commands)
    _add_schema(commands)
    return parser


def _version() -> str:
    from importlib.metadata import version

    return version("thinkblox")


def _add_generate(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    parser = commands.add_parser("generate", help="furnish a room from a prompt")
    parser.add_argument("prompt", metavar="PROMPT", help="what the room should be")
    parser.add_argument("--out", metavar="DIR", type=Path, required=True, help="folder to write; whole or not at all")
    parser.add_argument("--seed", metavar="N", type=_natural, default=0, help="same prompt, same seed, same room (0)")
    parser.add_argument(
        "--room", metavar="FILE", type=Path, help="furnish this room: JSON with floor, height, openings"
    )
    parser.add_argument("--candidates", metavar="N", type=_positive, default=8, help="poses proposed per round (8)")
    parser.add_argument("--no-pictures", action="store_true", help="leave out preview.png and top.png")
    parser.add_argument("--overwrite", action="store_true", help="replace an output folder of an earlier run")
    parser.add_argument("--json", action="store_true", help="print the report as JSON")
    parser.set_defaults(run=_generate)


def _add_verify(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    parser = commands.add_parser("verify", help="measure a scene, ours or anybody's, object by object")
    parser.add_argument(
        "scene", metavar="PATH", type=Path, help="an output folder, a scene.json, MJCF, URDF, or somebody's layout"
    )
    parser.add_argument("--suite", metavar="A,B", type=_names, default=(), help="published criteria; 'all' for all")
    parser.add_argument("--html", metavar="FILE", type=Path, help="write a page with pictures and the faults in them")
    parser.add_argument("--fix", action="store_true", help="move what fails by the least that mends it")
    parser.add_argument("--out", metavar="FILE", type=Path, help="write the (mended) scene as a scene.json")
    parser.add_argument("--format", metavar="NAME", help="of a layout whose keys do not tell whose it is")
    parser.add_argument("--assets", metavar="DIR", type=Path, help="folder with the meshes that a layout names")
    parser.add_argument("--height", metavar="M", type=float, help="of the room, where a layout has none (2.6)")
    parser.add_argument("--room", metavar="ID", help="which room of a file that holds several")
    parser.add_argument("--short-side", metavar="M", type=float, help="of the room, for a layout in pixels")
    parser.add_argument("--seed", metavar="N", type=_natural, default=0, help="of what suites sample (0)")
    parser.add_argument("--timeout", metavar="S", type=_seconds, default=600.0, help="for a foreign file (600)")
    parser.add_argument("--json", action="store_true", help="print the report as JSON")
    parser.set_defaults(run=_verify)


def _add_render(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    parser = commands.add_parser("render", help="draw preview.png and top.png of a scene")
    parser.add_argument("scene", metavar="SCENE", type=Path, help="an output folder or a scene.json")
    parser.add_argument("--out", metavar="DIR", type=Path, help="folder for the pictures (that of the scene)")
    parser.add_argument("--size", metavar="PX", type=_picture_size, default=1024, help="pixels along a side (1024)")
    parser.add_argument("--json", action="store_true", help="print the paths as JSON")
    parser.set_defaults(run=_render)


def _add_schema(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    parser = commands.add_parser("schema", help="print the JSON Schema of a file")
    parser.add_argument("name", metavar="NAME", nargs="?", help="scene, room, report, ...; all names when left out")
    parser.set_defaults(run=_schema)


def _whole(text: str, least: int, most: int) -> int:
    try:
        number = int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number") from None
    if not least <= number <= most:
        raise argparse.ArgumentTypeError(f"{number} is not between {least} and {most}")
    return number


def _natural(text: str) -> int:
    return _whole(text, 0, 2**63 - 1)


def _positive(text: str) -> int:
    return _whole(text, 1, 256)


def _names(text: str) -> tuple[str, ...]:
    from thinkblox.sim.suites import SUITES

    names = tuple(dict.fromkeys(name.strip() for name in text.split(",") if name.strip()))
    return SUITES if names == ("all",) else names


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of seconds") from None
    if not 0.0 < seconds <= 86400.0:
        raise argparse.ArgumentTypeError(f"{text} is not between 0 and 86400 seconds")
    return seconds


def _picture_size(text: str) -> int:
    return _whole(text, 64, 8192)


def _generate(arguments: argparse.Namespace) -> int:
    from thinkblox import printing
    from thinkblox.exporters.folder import check_folder, save_room
    from thinkblox.generate import generate_room
    from thinkblox.placing import Effort
    from thinkblox.scene.room import Room
    from thinkblox.value import read_json, to_json

    check_folder(arguments.out, overwrite=arguments.overwrite)
    room = None if arguments.room is None else read_json(arguments.room, Room)
    with _Progress(quiet=arguments.json) as progress:
        result = generate_room(
            arguments.prompt,
            seed=arguments.seed,
            room=room,
            effort=Effort(candidates=arguments.candidates),
            on_object=progress.tell,
        )
    save_room(result, arguments.out, pictures=not arguments.no_pictures, overwrite=arguments.overwrite)
    if arguments.json:
        sys.stdout.write(to_json(result.report).decode())
    else:
        print(printing.summary(result.report, placed=len(result.scene.placements)))
        print(printing.outcome(result.report))
        print(f"written to {arguments.out}")
    return 0 if result.report.complete else 1


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
        suites=arguments.suite,
        seed=arguments.seed,
        fix=arguments.fix,
        out=_text(arguments.out),
        page=_text(arguments.html),
    )
    report = verify_file(arguments.scene, reading, timeout=arguments.timeout)
    passed = report.valid and all(suite.passed for suite in report.suites)
    if arguments.json:
        sys.stdout.write(to_json(report).decode())
        return 0 if passed else 1
    print(printing.summary(report, placed=len(report.objects)))
    if arguments.fix:
        print(f"\n{printing.moves(report)}")
    for result in report.suites:
        print(f"\n{printing.suite(result)}")
    print("all passed" if passed else "not all passed")
    return 0 if passed else 1


def _text(path: Path | None) -> str | None:
    return None if path is None else str(path)


def _render(arguments: argparse.Namespace) -> int:
    import msgspec

    from thinkblox.exporters.folder import save_pictures
    from thinkblox.scene.scene import load_scene

    scene = load_scene(arguments.scene)
    home = arguments.scene if arguments.scene.is_dir() else arguments.scene.parent
    paths = save_pictures(scene, arguments.out or home, size=arguments.size)
    if arguments.json:
        print(msgspec.json.encode([str(path) for path in paths]).decode())
    else:
        print("\n".join(f"written to {path}" for path in paths))
    return 0


def _schema(arguments: argparse.Namespace) -> int:
    import json

    from thinkblox.schemas import SCHEMAS, published_schema

    if arguments.name is None:
        print("\n".join(SCHEMAS))
        return 0
    print(json.dumps(published_schema(arguments.name), indent=2))
    return 0


class _Progress:
    """A bar per object on a terminal, a plain line elsewhere, nothing when a machine reads along."""

    def __init__(self, *, quiet: bool) -> None:
        self._quiet = quiet
        self._bar: Any = None

    def __enter__(self) -> "_Progress":
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()

    def tell(self, progress: "Progress") -> None:
        """Show one object more."""
        if self._quiet:
            return
        outcome = "placed" if progress.placed else "not placed"
        if progress.number == 1 and progress.attempt > 0:
            self._begin_anew(progress)
        if not sys.stderr.isatty():
            print(f"{progress.number}/{progress.total} {progress.target.id} {outcome}", file=sys.stderr)
            return
        from tqdm import tqdm

        if self._bar is None:
            self._bar = tqdm(total=progress.total, unit="object", file=sys.stderr)
        self._bar.set_description_str(f"{progress.target.id} {outcome}")
        self._bar.update()

    def _begin_anew(self, progress: "Progress") -> None:
        if self._bar is None:
            print(f"not all as asked; begun anew ({progress.attempt})", file=sys.stderr)
        else:
            self._bar.reset()
