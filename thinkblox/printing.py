"""A report as a person reads it on a terminal: the outcome, every fault with its numbers, and tables of suites."""

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from thinkblox.episode import Round
from thinkblox.headline import headline, in_short, relation_words, shortfall, shortfalls
from thinkblox.suite import Criterion, SuiteResult
from thinkblox.value import Vec3
from thinkblox.verdict import MendingMove, Report

if TYPE_CHECKING:
    from thinkblox.listing import CategoryEntry

MARKS = {True: "passed", False: "FAILED", None: "-"}
UNITS = {"m": ("mm", 1000.0)}
"""What is printed in other units than it is measured in."""


def outcome(report: Report) -> str:
    """In a few words how a prompt was met."""
    if report.complete:
        return "all as asked"
    short = shortfalls(report)
    says = f": {in_short(short)}" if short else ""
    return f"passed, but not all as asked{says}" if report.valid else "not all passed"


def summary(report: Report, *, placed: int) -> str:
    """The measures of the whole, and every fault with its numbers, a line each."""
    return "\n".join([_whole(report, placed), *_faults(report), *_score(report), *report.notes])


def in_figures(report: Report, *, placed: int) -> str:
    """The measures of the whole, and what does not pass, a line each."""
    failing = [f"  {verdict}" for verdict in report.objects if not verdict.valid]
    return "\n".join(["; ".join((f"{placed} object{'' if placed == 1 else 's'}", *headline(report))), *failing])


def no_use(done: Round) -> str:
    """A round of answers of which none could be taken: how many, in what time, and what is wrong with the last."""
    last = done.tries[-1] if done.tries else None
    against = last.rejection.message if last and last.rejection else f"{last.verdict}" if last else "there is none"
    answers = f"{len(done.tries)} answer{'' if len(done.tries) == 1 else 's'}"
    return f"{done.id}: {answers} in {done.propose_seconds:.0f} s, none of use; of the last: {against}"


def whose(rounds: Sequence[Round]) -> str:
    """What of a room stands where its policy said, what was found by a search, and which answers were no use."""
    kept = [done for done in rounds if done.kept]
    placed = {done.id: done.kind for done in kept if done.chosen is not None}
    searched = [id for id, kind in placed.items() if kind != "policy"]
    answers = [tried for done in kept if done.kind == "policy" for tried in done.tries]
    unread = Counter(tried.rejection.reason for tried in answers if tried.rejection is not None)
    count = len({done.id for done in kept})
    says = f"where the model said: {len(placed) - len(searched)} of {count} object{'' if count == 1 else 's'}"
    says += f"; by a search instead: {in_short(searched)}" if searched else ""
    reasons = ", ".join(f"{reason} {count}" for reason, count in unread.most_common())
    return says + (f"; not readable: {unread.total()} of {len(answers)} answers ({reasons})" if unread else "")


def _whole(report: Report, placed: int) -> str:
    counts = f"{placed} object{'' if placed == 1 else 's'} placed, {len(report.absent)} not"
    return "; ".join((counts, *headline(report)))


def _faults(report: Report) -> Iterator[str]:
    yield from (f"  not placed: {a.id}{'' if a.asked else ' (assumed)'}: {a.reason}" for a in report.absent)
    yield from (f"  {verdict}" for verdict in report.objects if not verdict.valid)
    held = [r for r in report.relations if r.holds]
    if report.relations:
        yield f"relations asked for: {len(held)} of {len(report.relations)} hold"
    yield from (f"  not so: {r.subject} {relation_words(r)}: {r.measured}" for r in report.relations if not r.holds)
    yield from (f"  {shortfall(demand)}" for demand in report.demands if not demand.holds)
    kept_out = [demand.subject for demand in report.demands if demand.kind == "excluded" and demand.holds]
    if kept_out:
        yield f"kept out, as asked: {', '.join(kept_out)}"
    if report.walker is not None and report.walker.unreachable:
        yield f"no walkable way to: {', '.join(report.walker.unreachable)}"
    if report.robot is not None and report.robot.unreachable:
        yield f"out of a robot's reach, {report.robot.width:g} m wide: {', '.join(report.robot.unreachable)}"
    if report.unknown:
        yield f"words not understood: {', '.join(report.unknown)}"
    if report.substituted:
        yield f"measured as boxes, for want of a mesh: {', '.join(report.substituted)}"
    if report.stand_ins:
        yield f"as plain stand-ins: {', '.join(map(str, report.stand_ins))}"
    yield from (f"unusual: {sentence}" for sentence in report.unusual)


def _score(report: Report) -> Iterator[str]:
    """The score by guidelines, and what costs most in each part."""
    if report.score is not None and report.score.total is not None:
        yield f"interior guidelines, 0 to 1: {report.score}"


def moves(report: Report) -> str:
    """What was moved to mend faults, a line each."""
    if not report.moves:
        return "nothing had to be moved"
    return "\n".join(_move(move) for move in report.moves)


def _move(move: MendingMove) -> str:
    why = ", ".join(move.why) or "for what it rests on or stands beside"
    if not move.mended:
        needs = f"; it would have to be moved {move.needs * 1000:.0f} mm" if move.needs is not None else ""
        return f"{move.id}: not mended ({why}){needs}"
    x, y, z = (1000 * part for part in move.by)
    return f"{move.id}: moved {move.distance * 1000:.1f} mm ({x:+.1f}, {y:+.1f}, {z:+.1f}) ({why})"


def suite(result: SuiteResult) -> str:
    """A table of the criteria of one suite, and one of its objects."""
    heading = f"{result.suite}: {MARKS[result.passed]} ({result.source})"
    criteria = [("criterion", "worst", "limit", ""), *(_criterion_row(c) for c in result.criteria)]
    notes = [f"  {criterion.name}: {criterion.note}" for criterion in result.criteria if criterion.note]
    return "\n".join([heading, _table(criteria), *notes, _table(_object_rows(result)), *result.notes])


def _criterion_row(criterion: Criterion) -> tuple[str, ...]:
    worst, limit = (_number(value, criterion.unit) for value in (criterion.value, criterion.limit))
    return (criterion.name, worst, limit, MARKS[criterion.passed])


def _object_rows(result: SuiteResult) -> list[tuple[str, ...]]:
    """For each object how many criteria it passed, and which ones it did not with the value."""
    passed: dict[str, int] = {}
    failed: dict[str, list[str]] = {}
    for criterion in result.criteria:
        for finding in criterion.findings:
            passed.setdefault(finding.object, 0)
            if finding.passed is False:
                value = _number(finding.value, criterion.unit)
                failed.setdefault(finding.object, []).append(f"{criterion.name} {value}".strip())
            elif finding.passed:
                passed[finding.object] += 1
    rows = [(id, str(count), "; ".join(failed.get(id, []))) for id, count in passed.items()]
    return [("object", "passed", "failed"), *rows] if rows else []


def _number(value: float | None, unit: str) -> str:
    if value is None:
        return "-"
    shown, factor = UNITS.get(unit, (unit, 1.0))
    return f"{value * factor:.4g} {shown}".strip()


def categories(entries: Sequence["CategoryEntry"]) -> str:
    """A table of the catalogue, a line for each category."""
    heading = ("category", "stands on", "size [m]", "mass [kg]", "attributes")
    rows = [(e.name, e.mount, _lengths(e.size), f"{e.mass:g}", ", ".join(e.attributes)) for e in entries]
    return f"{_table([heading, *rows])}\n{len(entries)} categories; size is depth x width x height"


def category(entry: "CategoryEntry") -> str:
    """All about one category of the catalogue, a line for each fact."""
    return f"{entry.name}: {entry.noun}\n" + _table(
        [
            ("stands on", entry.mount),
            ("size", f"{_lengths(entry.size)} m (depth x width x height)"),
            ("smallest", f"{_lengths(entry.smallest)} m"),
            ("largest", f"{_lengths(entry.largest)} m"),
            ("mass", f"{entry.mass:g} kg"),
            ("attributes", ", ".join(entry.attributes) or "none that change its size"),
            ("words", ", ".join(entry.words) or "none"),
        ]
    )


def _lengths(size: Vec3) -> str:
    return " x ".join(f"{length:g}" for length in size)


def _table(rows: Sequence[Sequence[str]]) -> str:
    if not rows:
        return ""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return "\n".join("  " + "  ".join(c.ljust(w) for c, w in zip(row, widths, strict=True)).rstrip() for row in rows)
