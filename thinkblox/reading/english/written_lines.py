"""Texts that are written as lines: "- Bed: against the wall", "* Chairs (4) - around the table", "1. **Rug** ..."."""

import re
from collections import Counter

_BULLET = r"(?P<bullet>[ \t]*(?:[-*\u2022\u00b7\u2023\u25e6\u2013\u2014]|\d{1,2}[.)])[ \t]+)?"
_ENTRY = re.compile(
    rf"^{_BULLET}(?P<label>[^\n:;.!?]{{1,48}}?)(?P<sep>:(?= )| (?:[-=\u2013\u2014\u2192|]|->|=>) )(?P<rest>.*\S.*)$"
)
"""A thing, or what it is about, and after a mark what is told of it."""
_STARRED = re.compile(r"^([ \t]*)[*\u2022\u00b7\u2023\u25e6](?=[ \t]+\S)")
_BOLD = re.compile(r"(\*\*|__)(?=\S)([^*_\n]{1,60}?)(?<=\S)\1")
_ENDED = ".;:!?,"
_ALIKE = 2
"""So many lines that are marked alike are entries."""
_LINES, _LONGEST = 3, 70
"""So many lines that all begin with a capital, none longer than that, are one sentence each [characters]."""


def with_lines(text: str) -> str:
    """The text with a full stop after each entry of a list, and a colon between a thing and what is told of it.

    It is as long as it was, and every character that stays keeps its place.
    """
    if "\n" not in text:
        return text
    text = _BOLD.sub(lambda match: f"  {match[2]}  ", text)
    lines = [_STARRED.sub(r"\1-", line) for line in text.split("\n")]
    found = [_ENTRY.match(line) for line in lines]
    marks = Counter(match["sep"].strip() for match in found if match)
    entries = [match if match and marks[match["sep"].strip()] >= _ALIKE else None for match in found]
    lines = [_entry(match) if match else line for match, line in zip(entries, lines, strict=True)]
    said = [line for line in lines if line.strip()]
    alone = len(said) >= _LINES and all(_is_sentence(line) for line in said)
    whole = lines[0]
    for match, before, line in zip(entries[1:], entries, lines[1:], strict=False):
        stops = alone or match is not None or before is not None
        ended = not whole.strip() or whole.rstrip()[-1] in _ENDED
        whole += f"{'.' if stops and not ended and line.strip() else chr(10)}{line}"
    return whole


def _entry(match: re.Match[str]) -> str:
    """The line of an entry, without its bullet and with a colon."""
    mark = ":".ljust(len(match["sep"]))
    return f"{' ' * len(match['bullet'] or '')}{match['label']}{mark}{match['rest']}"


def _is_sentence(line: str) -> bool:
    begins = line.lstrip()[:1]
    return len(line) <= _LONGEST and (begins.isupper() or begins.isdigit())
