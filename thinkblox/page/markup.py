"""HTML put together from elements, so that no text of a file that was read can be taken for markup."""

import re
from html import escape

from thinkblox.plain_text import is_harmful

VOID = frozenset({"img", "wbr", "meta", "br", "image", "circle", "path", "line", "polygon", "rect"})
"""Elements that hold nothing; those of SVG are closed by a slash, which HTML ignores."""


class Markup(str):
    """Text that is markup already; any other text is escaped."""

    __slots__ = ()


def element(name: str, /, *children: str, **attributes: str | float | bool | None) -> Markup:
    """One element.

    Args:
        name: of its tag.
        children: markup as it is, other text escaped.
        attributes: a trailing underscore is dropped and other ones become dashes (`class_`, `data_n`); None and False
            leave an attribute out, True gives it no value.
    """
    opened = name + "".join(_attribute(key, value) for key, value in attributes.items())
    if name in VOID:
        return Markup(f"<{opened}/>")
    return Markup(f"<{opened}>{joined(*children)}</{name}>")


def joined(*parts: str) -> Markup:
    """Parts one after the other."""
    return Markup("".join(part if isinstance(part, Markup) else escape(_printable(part)) for part in parts))


def id_of(name: str) -> Markup:
    """A name that may be broken after its underscores, dots, dashes, slashes and colons, and nowhere else."""
    parts = re.split(r"(?<=[_.:/-])(?=[^_.:/-])", name)
    return Markup("<wbr/>".join(joined(part) for part in parts))


def _attribute(key: str, value: str | float | bool | None) -> str:
    if value is None or value is False:
        return ""
    name = key.removesuffix("_").replace("_", "-")
    if value is True:
        return f" {name}"
    text = f"{value:g}" if isinstance(value, float) else str(value)
    return f' {name}="{escape(_printable(text))}"'


def _printable(text: str) -> str:
    """Without what no page may hold, and without what turns the direction of the text after it."""
    return "".join("\N{REPLACEMENT CHARACTER}" if is_harmful(c) and c not in "\n\t" else c for c in text)
