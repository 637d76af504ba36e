"""Criteria made of findings: the worst value, and whether all that the criterion applies to passed."""

import math
from collections.abc import Iterable, Sequence

from thinkblox.suite import Criterion, Finding, SuiteResult

DIGITS = 6
"""To which values are rounded, so that the last bits of an engine's arithmetic do not reach the JSON."""


def number(value: float) -> float | None:
    """A value fit for JSON: rounded, and None when it is not finite."""
    return round(float(value), DIGITS) + 0.0 if math.isfinite(value) else None


def above(object: str, value: float, limit: float, *, note: str = "", inclusive: bool = True) -> Finding:
    """What fails when it reaches a limit (`inclusive`) or passes it; a value that is not finite fails."""
    passed = value < limit if inclusive else value <= limit
    return Finding(object=object, value=number(value), passed=bool(passed) and math.isfinite(value), note=note)


def exempt(object: str, note: str, value: float | None = None) -> Finding:
    """What a criterion does not apply to, and why."""
    return Finding(object=object, value=value, passed=None, note=note)


def criterion(
    name: str,
    says: str,
    findings: Iterable[Finding],
    *,
    unit: str,
    limit: float | None,
    least: bool = False,
    value: float | None = None,
    note: str = "",
    unfinished: str = "",
) -> Criterion:
    """A criterion and its verdict.

    Args:
        name: as its source calls it.
        says: what passes.
        findings: object by object; the criterion fails if one of them does.
        unit: of the values.
        limit: that they are held against.
        least: the worst value is the smallest.
        value: the scene's own score, where it is not the worst finding.
        note: what a reader should know.
        unfinished: why the measurement was broken off; what has not failed by then is not known to pass.
    """
    found = tuple(findings)
    values = [f.value for f in found if f.value is not None and f.passed is not None]
    if value is None and values:
        value = min(values) if least else max(values)
    passed = _together([f.passed for f in found])
    if unfinished and passed:
        passed = None
    if passed is None and not (note or unfinished):
        note = "there is nothing here that it applies to"
    text = "; ".join(part for part in (note, unfinished) if part)
    return Criterion(
        name=name, says=says, unit=unit, limit=limit, value=value, passed=passed, findings=found, note=text
    )


def result(suite: str, source: str, criteria: Sequence[Criterion], notes: Iterable[str]) -> SuiteResult:
    """All criteria of a source, in its order."""
    passed = _together([c.passed for c in criteria])
    return SuiteResult(suite=suite, source=source, passed=bool(passed), criteria=tuple(criteria), notes=tuple(notes))


def paragraphs(text: str) -> tuple[str, ...]:
    """Notes written as paragraphs, each on one line."""
    return tuple(" ".join(part.split()) for part in text.split("\n\n"))


def _together(verdicts: Sequence[bool | None]) -> bool | None:
    if any(verdict is False for verdict in verdicts):
        return False
    return True if any(verdicts) else None
