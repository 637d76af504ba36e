"""Tables as they are shown: in a terminal, and in Markdown."""

from typing import NamedTuple


class Table(NamedTuple):
    """Cells as they are shown; the first column names the row."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def text_table(table: Table) -> str:
    """For a terminal: the title, and columns under one another."""
    lines = [table.header, *table.rows]
    widths = [max(len(line[column]) for line in lines) for column in range(len(table.header))]
    shown = ["  ".join(text.ljust(width) for text, width in zip(line, widths, strict=True)).rstrip() for line in lines]
    return "\n".join([table.title, *(line for line in shown if line)])


def markdown_table(table: Table) -> str:
    """The table without its title."""
    lines = [table.header, ("---",) * len(table.header), *table.rows]
    return "\n".join(f"| {' | '.join(cell(text) for text in line)} |" for line in lines)


def cell(text: str) -> str:
    """A text from outside that can end neither a cell nor a line."""
    return " ".join(text.split()).replace("|", "\\|").replace("<", "&lt;")
