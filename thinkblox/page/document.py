"""The page: the outcome first, then what was read, the pictures, and every number that was measured."""

import base64
import hashlib
from collections.abc import Collection, Mapping, Sequence
from importlib.resources import files
from pathlib import Path

from thinkblox.headline import headline, in_short, shortfalls
from thinkblox.page.figures import figure, legend, patterns
from thinkblox.page.markup import Markup, element, joined
from thinkblox.page.tables import (
    absent_table,
    demands_table,
    moves_table,
    objects_table,
    relations_table,
    score_table,
    suite_section,
)
from thinkblox.sim.render.drawn import FaultPicture
from thinkblox.sim.render.fault_pictures import fault_pictures
from thinkblox.sim.settings import Walking
from thinkblox.sim.subject import Subject
from thinkblox.verdict import Report
from thinkblox.whole_file import write_whole

SIZE = 900
"""Width and height of the pictures before they are trimmed [pixels]."""


def write_page(
    report: Report, subject: Subject, path: Path, *, title: str = "", walking: Walking | None = None, size: int = SIZE
) -> None:
    """Write a report as one HTML file that needs nothing else, whole or not at all.

    Args:
        report: what was measured.
        subject: what it was measured of.
        path: of the file; one that is there is replaced.
        title: heads the page; the prompt, or the name of the file, when empty.
        walking: as it was measured with.
        size: of the pictures before they are trimmed [pixels].

    Raises:
        InputError: the file cannot be written.
    """
    page = page_of(report, subject, title=title or report.prompt or path.stem, walking=walking, size=size)
    write_whole(path, page.encode("utf-8", "replace"))


def page_of(report: Report, subject: Subject, *, title: str, walking: Walking | None = None, size: int = SIZE) -> str:
    """The text of the page."""
    style, script = _asset("style.css"), _asset("script.js")
    policy = (
        f"default-src 'none'; img-src data:; style-src 'sha256-{_digest(style)}'; script-src 'sha256-{_digest(script)}'"
    )
    head = element(
        "head",
        element("meta", charset="utf-8"),
        element("meta", name="generator", content="ThinkBLOX"),
        element("meta", http_equiv="Content-Security-Policy", content=policy),
        element("meta", name="viewport", content="width=device-width, initial-scale=1"),
        element("title", f"{title} – ThinkBLOX"),
        element("style", Markup(style)),
    )
    body = element(
        "body",
        element("header", element("h1", title), _outcome(report)),
        element("main", *_sections(report, subject, walking, size)),
        _footer(report),
        element("script", Markup(script)),
    )
    return f"<!DOCTYPE html>\n{element('html', head, body, lang='en')}\n"


def _asset(name: str) -> str:
    return files("thinkblox.page").joinpath(name).read_text("utf-8")


def _digest(content: str) -> str:
    return base64.b64encode(hashlib.sha256(content.encode()).digest()).decode()


def _sections(report: Report, subject: Subject, walking: Walking | None, size: int) -> list[Markup]:
    failing = [v.id for v in report.objects if not v.valid]
    cut_off = [id for access in (report.walker, report.robot) if access is not None for id in access.unreachable]
    known = {v.id for v in report.objects}
    numbered = dict.fromkeys([*failing, *(id for id in cut_off if id in known)])
    numbers = {id: number for number, id in enumerate(numbered, 1)}
    ordered = sorted(report.objects, key=lambda v: numbers.get(v.id, len(known) + 1))
    rows = {v.id: at for at, v in enumerate(ordered, 1)}
    only_cut_off = set(numbered) - set(failing)
    pictures = fault_pictures(report, subject, numbers, walking=walking, size=size)
    sections = [
        _section("What was read", _facts(report, subject)),
        _section("Pictures", *_pictures(pictures, numbers, rows, only_cut_off)),
        _section("Objects", objects_table(ordered, numbers, rows)),
        _section("Interior guidelines", score_table(report.score) if report.score else Markup()),
        _section("Published criteria", *(suite_section(suite) for suite in report.suites)),
        _section("Moved to mend faults", moves_table(report.moves) if report.moves else Markup()),
        _section("What the prompt asks for", relations_table(report.relations) if report.relations else Markup()),
        _section("What else it asks for", demands_table(report.demands) if report.demands else Markup()),
        _section("Not in the room", absent_table(report.absent) if report.absent else Markup()),
    ]
    return [section for section in sections if section]


def _section(title: str, *content: Markup) -> Markup:
    return element("section", element("h2", title), *content) if any(content) else Markup()


def _outcome(report: Report) -> Markup:
    count, failing = len(report.objects), sum(not v.valid for v in report.objects)
    things = "1 object" if count == 1 else f"{count} objects"
    suites = [suite.suite for suite in report.suites if not suite.passed]
    if not report.valid:
        says = f"{failing} of {things} {'fails' if failing == 1 else 'fail'}" if failing else "The whole does not hold"
    else:
        says = "All of it passes" if not suites else "Every object passes"
    details = [f"{things} measured."] if count else ["There is nothing in it."]
    details += [f"{phrase[:1].upper()}{phrase[1:]}." for phrase in headline(report)]
    if report.suites:
        details.append(f"Suites failed: {', '.join(suites)}." if suites else "All suites passed.")
    short = shortfalls(report)
    if short:
        details.append(f"Not all as asked: {in_short(short)}.")
    passes = report.valid and not suites
    lines = [element("strong", says), " ".join(details)]
    return element("div", *lines, class_=f"outcome {'passes' if passes else 'fails'}", role="status")


def _facts(report: Report, subject: Subject) -> Markup:
    source = {"thinkblox": "a ThinkBLOX scene", "mjcf": "an MJCF model", "urdf": "a URDF model"}
    facts = [("Source", source.get(report.source, f"a layout of {report.source}"))]
    facts.append(("Versions", _versions(report)))
    if subject.room is not None:
        width, depth = subject.room.extent
        facts.append(("Room", f"{width:.2f} m by {depth:.2f} m, {subject.room.height:.2f} m high"))
    if report.prompt:
        facts.append(("Prompt", f"{report.prompt} (seed {report.seed})"))
    for access, who in ((report.walker, "Walkable"), (report.robot, "Drivable")):
        if access is not None:
            far = f"; no way to {', '.join(access.unreachable)}" if access.unreachable else ""
            facts.append((who, f"{access.reach:.0%} of the free floor, {access.width:g} m wide{far}"))
    facts += [("Unusual", sentence) for sentence in report.unusual]
    if report.substituted:
        facts.append(("Boxes for want of a mesh", ", ".join(report.substituted)))
    if report.stand_ins:
        facts.append(("Plain stand-ins", ", ".join(map(str, report.stand_ins))))
    if report.unknown:
        facts.append(("Words not understood", ", ".join(report.unknown)))
    facts += [("Note", note) for note in report.notes]
    return element("dl", *(joined(element("dt", name), element("dd", value)) for name, value in facts if value))


def _pictures(
    pictures: Sequence[FaultPicture], numbers: Mapping[str, int], rows: Mapping[str, int], cut_off: Collection[str]
) -> list[Markup]:
    """Both pictures with their captions and the legend; `cut_off` fail in nothing but that nobody gets there."""
    listed = ", ".join(f"{number} {id}" for id, number in numbers.items())
    marked = f" Marked: {listed}." if listed else " Nothing in it fails."
    views = (
        (
            "The room from above one of its corners, near walls cut away.",
            "From above a corner; near walls are cut away.",
        ),
        ("The plan of the room, seen from straight above, north up.", "From straight above, north up."),
    )
    figures = [
        figure(picture, rows, cut_off, alt=alt + marked, says=says)
        for picture, (alt, says) in zip(pictures, views, strict=True)
    ]
    absent = set(numbers) - {outline.id for picture in pictures for outline in picture.outlines}
    far = f"Too far out to be in the pictures: {', '.join(sorted(absent))}." if absent else ""
    notes = [element("p", far)] if far else []
    return [patterns(), element("div", *figures, class_="pictures"), legend(pictures), *notes]


def _versions(report: Report) -> str:
    return ", ".join(f"{name} {version}" for name, version in sorted(report.versions.items()))


def _footer(report: Report) -> Markup:
    return element("footer", element("p", f"Measured by {_versions(report) or 'ThinkBLOX'}.", class_="soft"))
