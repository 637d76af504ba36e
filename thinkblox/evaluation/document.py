"""An evaluation as text for a terminal, as Markdown, and as JSON."""

from collections.abc import Iterable

import msgspec

from thinkblox.evaluation.results import Evaluation, Judgement
from thinkblox.evaluation.summary import tables
from thinkblox.evaluation.table import cell, markdown_table, text_table
from thinkblox.evaluation.tallies import JudgedRow


def as_text(evaluation: Evaluation) -> str:
    """The tables, columns under one another."""
    return "\n\n".join(text_table(table) for table in tables(evaluation) if table.rows)


def failure_lines(judgement: Judgement) -> Iterable[str]:
    """A line for every demand that is not met: the prompt's id, the kind, the demand, and what was found."""
    if judgement.refused:
        yield f"{judgement.id} refused: {judgement.refused}"
    for row in judgement.failures:
        yield f"{judgement.id} {_label(row)}: {row.demand} | {row.says}"


def verdict_line(judgement: Judgement) -> str:
    """One line on a prompt: how long its room took, how many demands are met, and whether its report says otherwise."""
    judged = [row for row in judgement.rows if row.met is not None]
    met = sum(row.met is True for row in judged)
    mark = f"; {opinions(judgement)}" if judgement.disagrees else ""
    return f"{judgement.id} in {judgement.seconds:.1f} s: {met} of {len(judged)} demands met{mark}"


def as_json(evaluation: Evaluation) -> bytes:
    """All rows, the met ones too, with the tables."""
    shown = [{"title": t.title, "header": t.header, "rows": t.rows} for t in tables(evaluation)]
    whole = msgspec.to_builtins(evaluation) | {"tables": shown}
    whole["judgements"] = [
        msgspec.to_builtins(j) | {"whole": j.whole, "disagrees": j.disagrees} for j in evaluation.judgements
    ]
    return msgspec.json.format(msgspec.json.encode(whole), indent=2) + b"\n"


def as_markdown(evaluation: Evaluation) -> str:
    """The tables and every failure."""
    what = "Rooms" if evaluation.of == "rooms" else "The reading of the prompts"
    parts = [f"# {what}, judged by {cell(evaluation.annotations)}"]
    parts += [f"## {table.title}\n\n{markdown_table(table)}" for table in tables(evaluation) if table.rows]
    parts.append("## Every demand that is not met")
    parts += [_failures(judgement) for judgement in evaluation.judgements if judgement.failures or judgement.refused]
    parts += _disagreements(evaluation)
    return "\n\n".join(parts) + "\n"


def _disagreements(evaluation: Evaluation) -> list[str]:
    differing = [judgement for judgement in evaluation.judgements if judgement.disagrees]
    if not differing:
        return []
    lines = [f"- {cell(j.id)}: {opinions(j)}" for j in differing]
    return ["## Where the report and the judge disagree", "\n".join(lines)]


def opinions(judgement: Judgement) -> str:
    """In what the room's report and the judge differ."""
    if judgement.complete:
        return f'the report says "all as asked", the judge finds {len(judgement.failures)} demands not met'
    return 'the report does not say "all as asked", the judge finds nothing amiss'


def _failures(judgement: Judgement) -> str:
    mark = " **(the report says otherwise)**" if judgement.disagrees else ""
    head = f"**{cell(judgement.id)}** {cell(judgement.prompt)}{mark}\n"
    lines = [f"- refused: {cell(judgement.refused)}"] if judgement.refused else []
    lines += [f"- {_label(row)}: {cell(row.demand)}: {cell(row.says)}" for row in judgement.failures]
    return "\n".join([head, *lines])


def _label(row: JudgedRow) -> str:
    return f"{row.kind} {row.about}".rstrip()
