"""Opening and measuring whatever a path holds: one of our scenes, a model, or the layout of another generator."""

import math
import sys
from collections.abc import Container
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import msgspec
from msgspec import structs

from thinkblox.errors import InputError
from thinkblox.given import names_given, seed_given
from thinkblox.regular_file import opened_regular, read_text
from thinkblox.suite import SuiteResult
from thinkblox.value import Value, read_json
from thinkblox.verdict import Absence, Report
from thinkblox.whole_file import check_file, write_whole

if TYPE_CHECKING:
    from thinkblox.room_score import RoomScore
    from thinkblox.sim.subject import Subject

OURS = "thinkblox"
"""The format of our own scene.json."""
DEMANDS = "What the prompt asks for is not looked at here; of our own rooms, the report of `generate` says it."
MODELS = ("mjcf", "urdf", "usd")
USD_SUFFIXES = (".usd", ".usda", ".usdc", ".usdz")
MODEL_SUFFIXES = (".xml", ".mjcf", ".urdf", *USD_SUFFIXES)
LAYOUT_OPTIONS = ("assets", "height", "room", "short_side", "sizes", "room_size")
"""Attributes of VerifyOptions that say what a layout of another generator leaves open."""
RANGES = {"height": (1.5, 50.0), "short_side": (0.5, 100.0), "max_move": (0.0, 100.0)}
"""Between what a length of VerifyOptions must be [m]; above 0 in any case."""
SIDES = (0.5, 100.0)
"""Between what each length of a room must be [m]."""
LISTED = 5
"""So many of the files in a folder are named in a message."""
LATER = 60.0
"""A file that is so much newer than another was not written together with it [s]."""
TIMEOUT = 600.0
"""How long the measuring of a file may take unless told otherwise [s]."""
_PAGE = b'<meta name="generator" content="ThinkBLOX"'
"""What stands near the beginning of every page of ours."""


class VerifyOptions(Value, frozen=True, kw_only=True):
    """How a file is to be read and what is to be made of it.

    Attributes:
        format: "thinkblox", "mjcf", "urdf" or one of `thinkblox.importing.FORMATS`; None to tell by the file.
        assets: folder with the meshes that a layout names.
        height: of the room, for a layout that has none [m]; None for the usual, or more where something is higher.
        room: which one, of a file that holds several.
        short_side: of the room, for a layout in pixels [m].
        sizes: JSON file with sizes of objects by name, for a layout that has none.
        room_size: (east, north) or (east, north, up), for a scene graph without walls [m].
        suites: names of the published criteria to measure by.
        seed: of what the suites sample.
        fix: move what fails by the least that mends it, and measure what comes out.
        max_move: how far anything is moved at most [m]; None for the usual.
        out: file to which the scene is written, as our scene.json; None to write none.
        page: HTML file to write; None for none.
        root: folder in which all files lie that a model names; None for the model's own, or its package's.
        fixed_base: hold the root links of a URDF to the world.
        exclude: names of things of a model, or patterns such as "target*", that are left out of it.
        robot: names or patterns of things of a model that are robots: they stay where they are, and are not judged.
        overwrite: let `out` and `page` replace any file, not just one that we wrote.
    """

    format: str | None = None
    assets: str | None = None
    height: float | None = None
    room: str | None = None
    short_side: float | None = None
    sizes: str | None = None
    room_size: tuple[float, ...] | None = None
    suites: tuple[str, ...] = ()
    seed: int = 0
    fix: bool = False
    max_move: float | None = None
    out: str | None = None
    page: str | None = None
    root: str | None = None
    fixed_base: bool = False
    exclude: tuple[str, ...] = ()
    robot: tuple[str, ...] = ()
    overwrite: bool = False


def verify_file(path: str | Path, reading: VerifyOptions | None = None, *, timeout: float = TIMEOUT) -> Report:
    """Measure the scene in a file or folder.

    Our own scenes are measured as `thinkblox.verify` does. Models keep their own options. Layouts of other
    generators become scenes first. Whatever it is, it is read and simulated in a process of its own; what is to be
    written is written by this one, whole or not at all.

    Args:
        path: a scene.json or the folder that holds one, an MJCF, URDF or USD file, or a layout.
        reading: how it is read, and what is made of it.
        timeout: how long it may take [s], without the start of the process.

    Raises:
        InputError: an option that cannot be; it cannot be read, or takes too long; or `out` or `page` cannot be
            written, or is a file that we did not write; says what was wrong, where, and what to do.
    """
    path, reading = Path(path), VerifyOptions() if reading is None else reading
    if not isinstance(reading, VerifyOptions):
        raise InputError(f"a {type(reading).__name__} does not say how to read a file; give VerifyOptions(...)")
    reading = structs.replace(reading, seed=seed_given(reading.seed))
    _check_names(reading)
    _check_numbers(reading, timeout)
    _check_targets(reading)
    kind = _format_of(path, reading.format)
    _check_purpose(path, kind, reading)
    from thinkblox.sim.workers.guard import guarded

    # This process loads no more than it takes to read the answer: the child is what a caller waits for.
    done = guarded(_measured, str(path), kind, reading, seconds=timeout, doing=f"measuring {path}")
    if reading.out is not None:
        from thinkblox.exporters.saving import write_files

        write_files(done.scene, Path(reading.out).parent)
    if reading.page is not None:
        write_whole(Path(reading.page), done.page)
    return done.report


class _Done(NamedTuple):
    """A report, and what is to be written: the files of the scene by relative path, and the page."""

    report: Report
    scene: dict[str, bytes]
    page: bytes


def _check_targets(reading: VerifyOptions) -> None:
    """Refuse before any work what cannot be written at its end."""
    targets = {name: Path(path) for name, path in (("out", reading.out), ("page", reading.page)) if path is not None}
    if len({path.absolute() for path in targets.values()}) < len(targets):
        raise InputError(f"{reading.out}: the scene and the page cannot be one file")
    for name, path in targets.items():
        check_file(path, ours=_is_scene if name == "out" else _is_page, overwrite=reading.overwrite)


def _is_scene(path: Path) -> bool:
    from thinkblox.scene.scene import Scene

    try:
        read_json(path, Scene)
    except InputError:
        return False
    return True


def _is_page(path: Path) -> bool:
    with opened_regular(path, most=sys.maxsize) as file:
        return _PAGE in file.read(2000)


def _check_names(reading: VerifyOptions) -> None:
    from thinkblox.importing import FORMATS
    from thinkblox.sim.suites import SUITES

    for what in ("suites", "exclude", "robot"):
        names_given(getattr(reading, what), what)
    for name in reading.suites:
        if name not in SUITES:
            raise InputError(f"there is no suite {name!r}; there are {', '.join(SUITES)}")
    known = (OURS, *MODELS, *FORMATS)
    if reading.format is not None and reading.format not in known:
        raise InputError(f"no format {reading.format!r}; there are {', '.join(known)}")


def _check_numbers(reading: VerifyOptions, timeout: object) -> None:
    for name, (least, most) in RANGES.items():
        value = getattr(reading, name)
        if value is not None and not (_is_length(value) and least <= value <= most):
            bounds = f"{least:g} to {most:g} m" if least else f"above 0 and at most {most:g} m"
            raise InputError(f"{name.replace('_', ' ')}: {value!r}; it must be {bounds}")
    size = reading.room_size
    if size is not None and not (
        len(size) in (2, 3) and all(_is_length(side) and SIDES[0] <= side <= SIDES[1] for side in size)
    ):
        said = " x ".join(map(str, size))
        raise InputError(f"a room of {said} m; give two or three lengths of {SIDES[0]:g} to {SIDES[1]:g} m")
    if not _is_length(timeout):
        raise InputError(f"a timeout of {timeout!r} s is none; give seconds, more than 0")


def _check_purpose(path: Path, kind: str, reading: VerifyOptions) -> None:
    """Refuse options that a file of this kind has no use for."""
    if kind not in MODELS and (reading.root or reading.fixed_base or reading.exclude or reading.robot):
        raise InputError(
            f"{path}: --root, --fixed-base, --exclude and --robot are for models, which are MJCF, URDF or USD"
        )
    if kind not in (OURS, *MODELS):
        return
    useless = [f"--{name.replace('_', '-')}" for name in LAYOUT_OPTIONS if getattr(reading, name) is not None]
    if useless:
        what = "one of our own scenes" if kind == OURS else "a model"
        raise InputError(f"{path}: {', '.join(useless)}: only for layouts of other generators, and this is {what}")


def _is_length(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and 0.0 < value < math.inf


def _format_of(path: Path, wanted: str | None) -> str:
    """Which reader a path is for; "layout" where the document itself must tell whose it is."""
    if wanted is not None:
        return wanted
    if path.is_dir():
        if not (path / "scene.json").is_file():
            raise InputError(f"{path}: holds no scene.json; name the file in it that is to be measured{_models(path)}")
        return OURS
    if not path.exists():
        raise InputError(f"{path}: there is no such file")
    if path.suffix.lower() in MODEL_SUFFIXES:
        return "usd" if path.suffix.lower() in USD_SUFFIXES else "mjcf"
    if path.suffix.lower() == ".json":
        return OURS if _is_ours(path) else "layout"
    raise InputError(
        f"{path}: {path.suffix or 'a file without suffix'} is not read; scenes and layouts are .json,"
        f" models are {', '.join(MODEL_SUFFIXES)}"
    )


def _models(folder: Path) -> str:
    """What there is in a folder that could be meant."""
    found = _files(folder, (*MODEL_SUFFIXES, ".json"))
    more = f" and {len(found) - LISTED} more" if len(found) > LISTED else ""
    return f": there are {', '.join(found[:LISTED])}{more}" if found else ""


def _files(folder: Path, suffixes: Container[str]) -> list[str]:
    """The names of a folder's files with one of some endings."""
    return sorted(path.name for path in folder.iterdir() if path.suffix.lower() in suffixes and path.is_file())


class _Floor(msgspec.Struct):
    floor: msgspec.Raw


class _Ours(msgspec.Struct):
    """The keys by which one of our scenes is told from another generator's layout."""

    room: _Floor


def _is_ours(path: Path) -> bool:
    try:
        msgspec.json.decode(read_text(path), type=_Ours)
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError):
        return False
    return True


def _measured(path: str, format: str, reading: VerifyOptions) -> _Done:
    """Read, mend and measure, all as asked."""
    subject, notes, unplaced = _opened(Path(path), format, reading)
    report = _report(subject)
    if reading.fix:
        subject, report = _mended(path, subject, report, reading.max_move)
    absent = tuple(Absence(id=name, category="", asked=True, reason="the layout gives it no pose") for name in unplaced)
    report = structs.replace(
        report,
        valid=report.valid and not absent,
        complete=report.complete and not absent,
        source=subject.source,
        unusual=subject.unusual,
        substituted=subject.substituted,
        absent=(*report.absent, *absent),
        notes=(*notes, *((DEMANDS,) if report.prompt else ()), *report.notes),
        suites=_suites(subject, reading),
        score=_score(subject),
    )
    return _Done(report, _scene_files(path, subject, reading), _page(path, subject, report, reading))


def _opened(path: Path, format: str, reading: VerifyOptions) -> tuple["Subject", tuple[str, ...], tuple[str, ...]]:
    """What is to be measured, notes on how it was read, and the names of what it does not place."""
    from thinkblox.scene.scene import load_scene
    from thinkblox.sim.subject import subject_of

    if format == OURS:
        return subject_of(load_scene(path)), _newer(path), ()
    if format in MODELS:
        return _model(path, reading), (), ()
    from thinkblox.importing import read_layout

    layout = read_layout(
        path,
        format=None if format == "layout" else format,
        assets=reading.assets,
        height=reading.height,
        room=reading.room,
        short_side=reading.short_side,
        sizes=reading.sizes,
        room_size=reading.room_size,
    )
    subject = subject_of(layout.scene, source=layout.format, substituted=layout.substituted)
    return subject, layout.notes, layout.unplaced


def _newer(path: Path) -> tuple[str, ...]:
    """A note on models beside a scene.json that were written long after it: they may be what is meant."""
    if not path.is_dir():
        return ()
    written = (path / "scene.json").stat().st_mtime
    newer = [name for name in _files(path, MODEL_SUFFIXES) if (path / name).stat().st_mtime > written + LATER]
    if not newer:
        return ()
    verb = "is" if len(newer) == 1 else "are"
    return (f"This is scene.json; {', '.join(newer)} {verb} newer, and measured when named instead of the folder.",)


def _model(path: Path, reading: VerifyOptions) -> "Subject":
    from thinkblox.sim.foreign.opening import open_model

    root = None if reading.root is None else Path(reading.root)
    if root is not None and not root.is_dir():
        raise InputError(f"{root}: there is no such folder to read a model's files from")
    return open_model(path, folder=root, fixed_base=reading.fixed_base, exclude=reading.exclude, robots=reading.robot)


def _report(subject: "Subject") -> Report:
    if subject.scene is not None:
        from thinkblox.sim.verdict.verify import verify

        return verify(subject.scene)
    from thinkblox.sim.foreign.model_report import model_report

    return model_report(subject)


def _mended(path: str, subject: "Subject", report: Report, max_move: float | None) -> tuple["Subject", Report]:
    """The same with what fails moved, and the report on that."""
    from thinkblox.mending import FURTHEST, mend
    from thinkblox.sim.subject import subject_of

    if subject.scene is None:
        raise InputError(f"{path}: a model is measured, not mended; scenes and layouts are what --fix moves things in")
    scene, moves = mend(subject.scene, furthest=FURTHEST if max_move is None else max_move)
    again = report
    if any(move.mended for move in moves):
        subject = subject_of(scene, source=subject.source, substituted=subject.substituted)
        again = _report(subject)
    return subject, structs.replace(again, moves=moves)


def _score(subject: "Subject") -> "RoomScore | None":
    from thinkblox.scoring import score

    return None if subject.scene is None else score(subject.scene)


def _suites(subject: "Subject", reading: VerifyOptions) -> tuple[SuiteResult, ...]:
    from thinkblox.sim.suites import run_suite

    return tuple(run_suite(name, subject, seed=reading.seed) for name in reading.suites)


def _scene_files(path: str, subject: "Subject", reading: VerifyOptions) -> dict[str, bytes]:
    if reading.out is None:
        return {}
    if subject.scene is None:
        raise InputError(f"{path}: a model has no scene.json; --out is for scenes and layouts")
    from thinkblox.exporters.saving import scene_files

    return scene_files(subject.scene, Path(reading.out).name)


def _page(path: str, subject: "Subject", report: Report, reading: VerifyOptions) -> bytes:
    if reading.page is None:
        return b""
    from thinkblox.page import page_of

    return page_of(report, subject, title=report.prompt or Path(path).name).encode("utf-8", "replace")
