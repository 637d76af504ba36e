"""The tables of a page: objects, suites and their criteria, moves, relations, and what is not there."""

from collections.abc import Iterable, Mapping, Sequence

from thinkblox.headline import relation_words
from thinkblox.page.markup import Markup, element, id_of, joined
from thinkblox.room_score import RoomScore
from thinkblox.suite import Criterion, Finding, SuiteResult
from thinkblox.verdict import Absence, Demand, MendingMove, RelationResult, Verdict

Cell = tuple[str, str]
"""Content and class of a table cell."""
MOST_FINDINGS = 500
"""Findings that are listed for one criterion, those that fail first."""


def word(passed: bool | None) -> Markup:
    """Whether something passes, in a word."""
    says, kind = (
        ("does not apply", "none") if passed is None else ("passes", "passes") if passed else ("fails", "fails")
    )
    return element("span", says, class_=f"word {kind}")


def table(caption: str, columns: Sequence[Cell], rows: Iterable[Markup]) -> Markup:
    """A table with a caption and a row of headings; `columns` are their texts and classes."""
    heads = [element("th", name, scope="col", class_=kind or None) for name, kind in columns]
    body = element("tbody", *rows)
    whole = element("table", element("caption", caption), element("thead", element("tr", *heads)), body)
    return element("div", whole, class_="scroll")


def row(head: str, cells: Iterable[Cell], *, before: Sequence[Cell] = (), **attributes: str | int | None) -> Markup:
    """A row whose heading names what it is about."""
    first = [element("td", content, class_=kind or None) for content, kind in before]
    rest = [element("td", content, class_=kind or None) for content, kind in cells]
    return element("tr", *first, element("th", id_of(head), scope="row"), *rest, **attributes)


def objects_table(verdicts: Sequence[Verdict], numbers: Mapping[str, int], rows: Mapping[str, int]) -> Markup:
    """Every object with its verdict and all its numbers."""
    names = ("Depth, mm", "Overlap, %", "Outside, mm", "Drift, mm", "Drop, mm", "Tilt, °", "Rest, s")
    columns = [
        ("No.", ""),
        ("Object", ""),
        ("Verdict", ""),
        ("Why", ""),
        *((n, "number") for n in names),
        ("Carried by", ""),
    ]
    lines = [_object(verdict, numbers.get(verdict.id), rows[verdict.id]) for verdict in verdicts]
    caption = "Numbers are those in the pictures. A dash stands for what was not measured."
    return table(caption, columns, lines)


def _object(verdict: Verdict, number: int | None, at: int) -> Markup:
    disc = element("span", str(number), class_="disc") if number is not None else Markup()
    why = str(verdict).removeprefix(f"{verdict.id}: ") if not verdict.valid else Markup()
    shares = [joined(id_of(s.by), f" {s.share:.0%}") for s in verdict.supports]
    carried = Markup(", ".join(shares))
    cells = [(word(verdict.valid), ""), (why, "why"), *_measures(verdict), (carried, "")]
    return row(verdict.id, cells, before=[(disc, "")], id=f"object-{at}", data_n=at)


def _measures(verdict: Verdict) -> list[Cell]:
    def cell(value: float | None, digits: int, reason: str) -> Cell:
        shown = "–" if value is None else f"{value:.{digits}f}"
        return shown, "number beyond" if reason in verdict.reasons else "number"

    settled = verdict.settled
    return [
        cell(verdict.depth * 1000, 1, "collision"),
        cell(verdict.overlap * 100, 1, "collision"),
        cell(verdict.outside * 1000, 1, "outside"),
        cell(verdict.drift * 1000 if settled else None, 1, "drift"),
        cell(verdict.drop * 1000 if settled else None, 1, "drop"),
        cell(verdict.tilt if settled else None, 1, "tilt"),
        cell(verdict.rest, 2, "unstable"),
    ]


def score_table(score: RoomScore) -> Markup:
    """Every part of a score with its weight, what made it, and the worst case."""
    columns = [("Guideline", ""), ("Score", "number"), ("Weight", "number"), ("Measured", ""), ("Worst", "")]
    lines = []
    for part in score.parts:
        shown = "–" if part.score is None else f"{part.score:.2f}"
        numbers = ", ".join(f"{name.replace('_', ' ')} {value:g}" for name, value in part.numbers.items())
        lines.append(
            row(part.name, [(shown, "number"), (f"{part.weight:g}", "number"), (numbers, ""), (part.worst, "")])
        )
    total = "nothing to score" if score.total is None else f"{score.total:.2f} of 1"
    return table(f"{total}: the weighted mean of the parts that the room has something for.", columns, lines)


def suite_section(suite: SuiteResult) -> Markup:
    """One suite: its source, its criteria, and under each what was found."""
    columns = [
        ("Criterion", ""),
        ("Result", ""),
        ("What passes", ""),
        ("Worst", "number"),
        ("Limit", "number"),
        ("Found", ""),
    ]
    lines = [_criterion(criterion) for criterion in suite.criteria]
    return element(
        "section",
        element("h3", suite.suite, " ", word(suite.passed)),
        element("p", suite.source, class_="source"),
        table("Every criterion in the order of its source; details of each object fold out.", columns, lines),
        *(element("p", note, class_="soft") for note in suite.notes),
    )


def _criterion(criterion: Criterion) -> Markup:
    unit = f" {criterion.unit}" if criterion.unit else ""
    found: str = criterion.note
    if criterion.findings:
        found = element("div", found, _findings(criterion))
    return row(
        criterion.name.replace("_", " "),
        [
            (word(criterion.passed), ""),
            (criterion.says, ""),
            (_number(criterion.value) + (unit if criterion.value is not None else ""), "number"),
            (_number(criterion.limit) + (unit if criterion.limit is not None else ""), "number"),
            (found, ""),
        ],
    )


def _findings(criterion: Criterion) -> Markup:
    order = sorted(criterion.findings, key=lambda finding: (finding.passed is not False, finding.passed is None))
    failing = sum(finding.passed is False for finding in order)
    says = f"{len(order)} measured, {failing} fail" if failing else f"{len(order)} measured"
    lines = [_finding(finding) for finding in order[:MOST_FINDINGS]]
    if len(order) > MOST_FINDINGS:
        says += f", {MOST_FINDINGS} listed"
    columns = [
        ("Object", ""),
        (f"Value{f', {criterion.unit}' if criterion.unit else ''}", "number"),
        ("Result", ""),
        ("Note", ""),
    ]
    return element(
        "details",
        element("summary", says),
        table(f"{criterion.name.replace('_', ' ')}, object by object; what fails comes first.", columns, lines),
    )


def _finding(finding: Finding) -> Markup:
    return row(finding.object, [(_number(finding.value), "number"), (word(finding.passed), ""), (finding.note, "")])


def _number(value: float | None) -> str:
    return "–" if value is None else f"{value:.4g}"


def moves_table(moves: Sequence[MendingMove]) -> Markup:
    """What was moved to mend faults, and what could not be."""
    lengths = ("Distance, mm", "East, mm", "North, mm", "Up, mm", "Turned, °")
    columns = [("Object", ""), ("Result", ""), *((name, "number") for name in lengths), ("Because of", "")]

    def line(move: MendingMove) -> Markup:
        far = f", needs {move.needs * 1000:.0f} mm" if move.needs is not None else ""
        said = "mended" if move.mended else f"not mended{far}"
        says = element("span", said, class_=f"word {'passes' if move.mended else 'fails'}")
        numbers = (move.distance * 1000, *(c * 1000 for c in move.by), move.turn)
        cells = [(f"{number:.1f}", "number") for number in numbers]
        return row(move.id, [(says, ""), *cells, (", ".join(r.replace("_", " ") for r in move.why), "")])

    return table(
        "Each by the least that mends it; what rests on an object moves with it.", columns, [line(m) for m in moves]
    )


def relations_table(relations: Sequence[RelationResult]) -> Markup:
    """Relations that the prompt names."""

    def line(relation: RelationResult) -> Markup:
        cells = [(relation_words(relation), ""), (_is_so(relation.holds), ""), (relation.measured, "")]
        return row(relation.subject, cells)

    columns = [("Object", ""), ("Asked for", ""), ("Result", ""), ("Measured", "")]
    return table("Relations that the prompt names.", columns, [line(relation) for relation in relations])


def demands_table(demands: Sequence[Demand]) -> Markup:
    """Numbers, sizes, looks and whatever else the prompt asks for."""

    def line(demand: Demand) -> Markup:
        cells = [(demand.kind, ""), (demand.wanted, ""), (_is_so(demand.holds), ""), (demand.measured, "")]
        return row(demand.subject, cells)

    columns = [("Of", ""), ("What", ""), ("Asked for", ""), ("Result", ""), ("Found", "")]
    return table("What the prompt asks for besides.", columns, [line(demand) for demand in demands])


def _is_so(holds: bool) -> Markup:
    return element("span", "is so" if holds else "is not so", class_=f"word {'passes' if holds else 'fails'}")


def absent_table(absent: Sequence[Absence]) -> Markup:
    """What is not in the room, and why."""
    columns = [("Not placed", ""), ("Asked for", ""), ("Why", "")]
    lines = [row(a.id, [("yes" if a.asked else "assumed", ""), (a.reason, "")]) for a in absent]
    return table("What could not be placed, or is not known.", columns, lines)
