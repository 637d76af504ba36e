"""Measured policies beside one another, as tables and as JSON."""

from collections.abc import Iterable, Sequence

import msgspec

from thinkblox.evaluation.contenders import Contender
from thinkblox.evaluation.measures import COST, RATED, ROOMS, STEPS, Figure, Measure, Rooms, figure
from thinkblox.evaluation.room_tally import RoomTally
from thinkblox.evaluation.table import Table, cell, markdown_table, text_table
from thinkblox.value import Value

ALL = "all"
COMPARISON_VERSION = 1
BY_TYPE = ("parsed", "valid", "relations", "orientation")
"""Measures of single steps in the table by type of room."""


class ContenderResult(Value, frozen=True, kw_only=True):
    """A contender and its rooms.

    Attributes:
        missing: why it could not be measured; empty where it was.
        published: PSA in the paper, where it has such a row.
    """

    contender: Contender
    rooms: tuple[RoomTally, ...] = ()
    missing: str = ""
    published: float | None = None


class Comparison(Value, frozen=True, kw_only=True):
    """What was measured of several policies, on the same prompts.

    Attributes:
        prompts: name of the file.
        count: how many prompts.
        judge: the model that rated pictures; empty where none did.
    """

    prompts: str
    count: int
    runs: int
    seed: int
    judge: str = ""
    rows: tuple[ContenderResult, ...]
    version: int = COMPARISON_VERSION


def comparison_tables(comparison: Comparison) -> list[Table]:
    """Single steps, rooms, types of room, cost, ratings, and what is missing."""
    there = [row for row in comparison.rows if not row.missing]
    found = [
        _table("Single steps: the first answer for each object, in %", STEPS, there),
        _table("Rooms of first answers, in %", ROOMS, there),
        _by_type(there),
        _table("Cost", COST, there),
    ]
    if comparison.judge:
        found.append(_rated(comparison, there))
    gone = tuple((row.contender.name, row.contender.policy, row.missing) for row in comparison.rows if row.missing)
    if gone:
        found.append(Table("Missing", ("", "policy", "why"), gone))
    return found


def _rated(comparison: Comparison, rows: Sequence[ContenderResult]) -> Table:
    table = _table(f"Rated by {comparison.judge}: a reconstruction of LayoutVLM's measures", RATED, rows)
    if all(row.published is None for row in rows):
        return table
    paper = ["-" if row.published is None else f"{row.published:.1f}" for row in rows]
    cells = tuple((*line, said) for line, said in zip(table.rows, paper, strict=True))
    return Table(table.title, (*table.header, "PSA in the paper"), cells)


def _table(title: str, measures: Sequence[Measure], rows: Sequence[ContenderResult]) -> Table:
    cells = tuple((row.contender.name, *(_shown(measure, row.rooms) for measure in measures)) for row in rows)
    return Table(title, ("", *(measure.name for measure in measures)), cells)


def _by_type(rows: Sequence[ContenderResult]) -> Table:
    measures = [*ROOMS[:1], *(each for each in STEPS if each.name in BY_TYPE), *ROOMS[2:7]]
    cells = [
        (kind, row.contender.name, *(_shown(measure, rooms) for measure in measures))
        for kind in kinds_of_rooms(rows)
        for row in rows
        if (rooms := [room for room in row.rooms if kind in (ALL, room.kind)])
    ]
    return Table("By type of room, in %", ("room", "", *(measure.name for measure in measures)), tuple(cells))


def kinds_of_rooms(rows: Iterable[ContenderResult]) -> list[str]:
    """Every type of room that there is, and all together."""
    return [*sorted({room.kind for row in rows for room in row.rooms if room.kind}), ALL]


def _shown(measure: Measure, rooms: Rooms) -> str:
    found = figure(measure.of, rooms)
    if found is None:
        return "-"
    spread = "" if found.spread is None or not measure.digits else f" ± {found.spread:.{measure.digits}f}"
    return f"{found.mean:.{measure.digits}f}{spread}"


def comparison_text(comparison: Comparison) -> str:
    """For a terminal, without the types of room."""
    found = comparison_tables(comparison)
    return "\n\n".join(text_table(table) for table in found if not table.title.startswith("By type"))


def comparison_markdown(comparison: Comparison) -> str:
    """All tables, and what they were measured on."""
    runs = f"{comparison.runs} run{'s' * (comparison.runs != 1)}"
    spread = "the mean and the standard deviation over the runs" if comparison.runs > 1 else "no spread is known"
    said = f"{comparison.count} prompts of {cell(comparison.prompts)}, {runs} from seed {comparison.seed}: {spread}."
    parts = ["# Policies, measured by their first answers", said]
    parts += [f"## {cell(table.title)}\n\n{markdown_table(table)}" for table in comparison_tables(comparison)]
    return "\n\n".join(parts) + "\n"


def comparison_json(comparison: Comparison) -> bytes:
    """Every figure by contender and type of room, with every run and every step that they come from."""
    whole = msgspec.to_builtins(comparison)
    for row, shown in zip(comparison.rows, whole["rows"], strict=True):
        shown["figures"] = {kind: _figures(comparison, row.rooms, kind) for kind in kinds_of_rooms([row])}
    return msgspec.json.format(msgspec.json.encode(whole), indent=2) + b"\n"


def _figures(comparison: Comparison, rooms: Rooms, kind: str) -> dict[str, dict[str, Figure]]:
    chosen = [room for room in rooms if kind in (ALL, room.kind)]
    groups = {"steps": STEPS, "rooms": ROOMS, "cost": COST} | ({"rated": RATED} if comparison.judge else {})
    return {
        name: {measure.name: found for measure in measures if (found := figure(measure.of, chosen)) is not None}
        for name, measures in groups.items()
    }
