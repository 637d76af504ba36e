"""The tables of an evaluation: met demands by style and kind of demand, and by relation."""

from collections.abc import Callable, Iterable, Sequence
from functools import partial
from typing import NamedTuple

from thinkblox.evaluation.results import Evaluation, Judgement
from thinkblox.evaluation.table import Table
from thinkblox.evaluation.tallies import JudgedRow, Kind

TOTAL = "all"
_UNNAMED = "(none)"


class Share(NamedTuple):
    """How many of how many."""

    met: int
    total: int

    def __str__(self) -> str:
        """Such as "88/168 (52 %)"."""
        return f"{self.met}/{self.total} ({self.met / self.total:.0%})".replace("%", " %") if self.total else "-"


def tables(evaluation: Evaluation) -> tuple[Table, ...]:
    """The tables by style, by relation, and of what decides on the whole."""
    judged = evaluation.judgements
    return (
        _by_style(evaluation),
        _by_relation("Relations between objects", judged, "object relation"),
        _by_relation("Relations to parts of the room", judged, "architecture"),
        *([_by_relation("Attributes", judged, "attribute")] if evaluation.of == "rooms" else []),
        _by_relation("The room", judged, "room"),
        _facts(evaluation),
    )


def share(rows: Iterable[JudgedRow]) -> Share:
    """The met ones of those that can be judged."""
    judged = [row for row in rows if row.met is not None]
    return Share(sum(row.met is True for row in judged), len(judged))


def rows_of(judgements: Iterable[Judgement], kind: Kind) -> list[JudgedRow]:
    """Every row of a kind."""
    return [row for judgement in judgements for row in judgement.rows if row.kind == kind]


def _by_style(evaluation: Evaluation) -> Table:
    styles = dict.fromkeys(judgement.style for judgement in evaluation.judgements)
    groups = [(s or _UNNAMED, [j for j in evaluation.judgements if j.style == s]) for s in styles]
    groups.append((TOTAL, list(evaluation.judgements)))
    columns = _columns(evaluation)
    header = ("style", "prompts", *columns)
    cells = tuple(
        (name, str(len(group)), *(str(measure(group)) for measure in columns.values())) for name, group in groups
    )
    return Table("Demands met, by style", header, cells)


def _columns(evaluation: Evaluation) -> dict[str, Callable[[Sequence[Judgement]], object]]:
    columns: dict[str, Callable[[Sequence[Judgement]], object]] = {
        "counts": partial(_met, "count"),
        "objects": _objects,
        "too many": lambda group: sum(row.extra for row in rows_of(group, "count")),
        "attributes": partial(_met, "attribute"),
        "object-object": partial(_met, "object relation"),
        "object-architecture": partial(_met, "architecture"),
        "absent": partial(_met, "absent"),
        "room": partial(_met, "room"),
        "whole prompts": lambda group: Share(sum(j.whole for j in group), len(group)),
    }
    if evaluation.of == "reading":
        del columns["attributes"]
    return columns


def _met(kind: Kind, group: Sequence[Judgement]) -> Share:
    return share(rows_of(group, kind))


def _objects(group: Sequence[Judgement]) -> Share:
    counts = rows_of(group, "count")
    return Share(sum(row.found for row in counts), sum(row.asked for row in counts))


def _by_relation(title: str, judgements: Sequence[Judgement], kind: Kind) -> Table:
    rows = rows_of(judgements, kind)
    names = sorted({row.about for row in rows}, key=lambda name: (-sum(row.about == name for row in rows), name))
    cells = [(name, [row for row in rows if row.about == name]) for name in names] + [(TOTAL, rows)]
    return Table(
        title,
        ("", "met", "not judged"),
        tuple((name, str(share(of)), str(sum(row.met is None for row in of))) for name, of in cells),
    )


def _facts(evaluation: Evaluation) -> Table:
    judged = evaluation.judgements
    facts: list[tuple[str, object]] = [("refused", sum(bool(j.refused) for j in judged))]
    times = sorted(j.seconds for j in judged)
    if evaluation.of == "rooms":
        facts += [
            ("rooms that are not valid", sum(j.valid is False for j in judged)),
            ('called "all as asked"', sum(j.complete is True for j in judged)),
            ('called "all as asked", and not so', sum(j.complete is True and not j.whole for j in judged)),
            ('not called "all as asked", though so', sum(j.complete is False and j.whole for j in judged)),
        ]
    if any(times):
        facts.append(("seconds for one, median", f"{times[len(times) // 2]:.2f}"))
        facts.append(("seconds for one, longest", f"{times[-1]:.2f}"))
    return Table("The whole", ("", ""), tuple((name, str(value)) for name, value in facts))
