"""Opening and measuring whatever a path holds: one of our scenes, a model, or the layout of another generator."""

from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
from msgspec import structs

from thinkblox.errors import InputError
from thinkblox.exporters.saving import write_scene
from thinkblox.regular_file import read_regular
from thinkblox.scene.scene import load_scene
from thinkblox.suite import SuiteResult
from thinkblox.value import Value
from thinkblox.verdict import Absence, Report

if TYPE_CHECKING:
    from thinkblox.sim.subject import Subject

OURS = "thinkblox"
"""The format of our own scene.json."""
MODELS = ("mjcf", "urdf")
MODEL_SUFFIXES = (".xml", ".mjcf", ".urdf")
TIMEOUT = 600.0
"""How long the measuring of a foreign file may take unless told otherwise [s]."""


class VerifyOptions(Value, frozen=True, kw_only=True):
    """How a file is to be read and what is to be made of it.

    Attributes:
        format: "thinkblox", "mjcf", "urdf" or one of `thinkblox.importing.FORMATS`; None to tell by the file.
        assets: folder with the meshes that a layout names.
        height: of the room, for a layout that has none [m]; None for the usual.
        room: which one, of a file that holds several.
        short_side: of the room, for a layout in pixels [m].
        suites: names of the published criteria to measure by.
        seed: of what the suites sample.
        fix: move what fails by the least that mends it, and measure what comes out.
        out: file to which the scene is written, as our scene.json; None to write none.
        page: HTML file to write; None for none.
    """

    format: str | None = None
    assets: str | None = None
    height: float | None = None
    room: str | None = None
    short_side: float | None = None
    suites: tuple[str, ...] = ()
    seed: int = 0
    fix: bool = False
    out: str | None = None
    page: str | None = None


def verify_file(path: str | Path, reading: VerifyOptions | None = None, *, timeout: float = TIMEOUT) -> Report:
    """Measure the scene in a file or folder.

    Our own scenes are measured as `thinkblox.verify` does. Models keep their own options. Layouts of other
    generators become scenes first. What is not ours is read and simulated in a process of its own.

    Args:
        path: a scene.json or the folder that holds one, an MJCF or URDF file, or a layout.
        reading: how it is read, and what is made of it.
        timeout: how long a foreign file may take [s].

    Raises:
        InputError: it cannot be read, or takes too long; says what was wrong, where, and what to do.
    """
    path, reading = Path(path), reading or VerifyOptions()
    _check_names(reading)
    kind = _format_of(path, reading.format)
    if kind == OURS:
        return _measured(str(path), kind, reading)
    from thinkblox.sim.workers.guard import guarded

    return guarded(_measured, str(path), kind, reading, seconds=timeout, doing=f"measuring {path}")


def _check_names(reading: VerifyOptions) -> None:
    from thinkblox.importing import FORMATS
    from thinkblox.sim.suites import SUITES

    for name in reading.suites:
        if name not in SUITES:
            raise InputError(f"there is no suite {name!r}; there are {', '.join(SUITES)}")
    known = (OURS, *MODELS, *FORMATS)
    if reading.format is not None and reading.format not in known:
        raise InputError(f"no format {reading.format!r}; there are {', '.join(known)}")


def _format_of(path: Path, wanted: str | None) -> str:
    """Which reader a path is for; "layout" where the document itself must tell whose it is."""
    if wanted is not None:
        return wanted
    if path.is_dir():
        if not (path / "scene.json").is_file():
            raise InputError(f"{path}: holds no scene.json; name the file in it that is to be measured")
        return OURS
    if not path.exists():
        raise InputError(f"{path}: there is no such file")
    if path.suffix.lower() in MODEL_SUFFIXES:
        return "mjcf"
    if path.suffix.lower() == ".json":
        return OURS if _is_ours(path) else "layout"
    raise InputError(
        f"{path}: {path.suffix or 'a file without suffix'} is not read; scenes and layouts are .json,"
        f" models are {', '.join(MODEL_SUFFIXES)}"
    )


class _Floor(msgspec.Struct):
    floor: msgspec.Raw


class _Ours(msgspec.Struct):
    """The keys by which one of our scenes is told from another generator's layout."""

    room: _Floor


def _is_ours(path: Path) -> bool:
    try:
        msgspec.json.decode(read_regular(path), type=_Ours)
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError):
        return False
    return True


def _measured(path: str, format: str, reading: VerifyOptions) -> Report:
    """Read, mend, measure and write, all as asked."""
    subject, notes, unplaced = _opened(Path(path), format, reading)
    report = _report(subject)
    if reading.fix:
        subject, report = _mended(path, subject, report)
    absent = tuple(Absence(id=name, category="", asked=True, reason="the layout gives it no pose") for name in unplaced)
    report = structs.replace(
        report,
        valid=report.valid and not absent,
        complete=report.complete and not absent,
        source=subject.source,
        unusual=subject.unusual,
        substituted=subject.substituted,
        absent=(*report.absent, *absent),
        notes=(*notes, *report.notes),
        suites=_suites(subject, reading),
    )
    _write(path, subject, report, reading)
    return report


def _opened(path: Path, format: str, reading: VerifyOptions) -> tuple["Subject", tuple[str, ...], tuple[str, ...]]:
    """What is to be measured, notes on how it was read, and the names of what it does not place."""
    from thinkblox.sim.subject import subject_of

    if format == OURS:
        return subject_of(load_scene(path)), (), ()
    if format in MODELS:
        from thinkblox.sim.foreign.opening import open_model

        return open_model(path), (), ()
    from thinkblox.importing import read_layout
    from thinkblox.importing.layout import HEIGHT

    layout = read_layout(
        path,
        format=None if format == "layout" else format,
        assets=reading.assets,
        height=HEIGHT if reading.height is None else reading.height,
        room=reading.room,
        short_side=reading.short_side,
    )
    subject = subject_of(layout.scene, source=layout.format, substituted=layout.substituted)
    return subject, layout.notes, layout.unplaced


def _report(subject: "Subject") -> Report:
    if subject.scene is not None:
        from thinkblox.sim.verdict.verify import verify

        return verify(subject.scene)
    from thinkblox.sim.foreign.model_report import model_report

    return model_report(subject)


def _mended(path: str, subject: "Subject", report: Report) -> tuple["Subject", Report]:
    """The same with what fails moved, and the report on that."""
    from thinkblox.mending import mend
    from thinkblox.sim.subject import subject_of

    if subject.scene is None:
        raise InputError(f"{path}: a model is measured, not mended; scenes and layouts are what --fix moves things in")
    scene, moves = mend(subject.scene)
    again = report
    if any(move.mended for move in moves):
        subject = subject_of(scene, source=subject.source, substituted=subject.substituted)
        again = _report(subject)
    return subject, structs.replace(again, moves=moves)


def _suites(subject: "Subject", reading: VerifyOptions) -> tuple[SuiteResult, ...]:
    from thinkblox.sim.suites import run_suite

    return tuple(run_suite(name, subject, seed=reading.seed) for name in reading.suites)


def _write(path: str, subject: "Subject", report: Report, reading: VerifyOptions) -> None:
    if reading.out is not None:
        if subject.scene is None:
            raise InputError(f"{path}: a model has no scene.json; --out is for scenes and layouts")
        write_scene(subject.scene, Path(reading.out))
    if reading.page is not None:
        from thinkblox.page import write_page

        write_page(report, subject, Path(reading.page), title=report.prompt or Path(path).name)
