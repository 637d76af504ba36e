"""Results of suites of published criteria: a table of criteria, and under each one what was found of every object."""

from thinkblox.measurement import Measurement
from thinkblox.value import Value


class Finding(Measurement, frozen=True, kw_only=True):
    """What a criterion found of one object or pair.

    Attributes:
        object: its id, or "a + b" for a pair, or "scene" for the whole.
        value: what was measured, in the criterion's unit; None when it could not be.
        passed: None when the criterion does not apply to it.
        note: what a reader should know of it.
    """

    object: str
    value: float | None
    passed: bool | None
    note: str = ""


class Criterion(Measurement, frozen=True, kw_only=True):
    """One published criterion, applied to a scene.

    Attributes:
        name: as its source calls it, in snake_case.
        says: what passes, in a sentence with its numbers.
        unit: of the values, such as "m", "degrees", "share", "count"; "" for a yes or no.
        limit: the number that the values are held against; None when there is none.
        value: the worst value, or the scene's score; None when nothing was measured.
        passed: None when it could not be applied; `note` then says why.
        findings: object by object.
    """

    name: str
    says: str
    unit: str
    limit: float | None
    value: float | None
    passed: bool | None
    findings: tuple[Finding, ...] = ()
    note: str = ""


class SuiteResult(Value, frozen=True, kw_only=True):
    """All criteria of one source.

    Attributes:
        suite: its name on the command line.
        source: the publication, with year and address.
        passed: every criterion that could be applied did pass, and at least one could.
        criteria: in the order of the source.
        notes: where this differs from its source, in sentences.
    """

    suite: str
    source: str
    passed: bool
    criteria: tuple[Criterion, ...]
    notes: tuple[str, ...] = ()
