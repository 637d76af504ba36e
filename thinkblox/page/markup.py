"""HTML put together from elements, so that no text of a file that was read can be taken for markup."""

import re
from html import escape
from unicodedata import category

VOID = frozenset({"img", "wbr", "meta", "br", "image", "circle", "path", "line", "polygon", "rect"})
"""Elements that hold nothing; those of SVG are closed by a slash, which HTML ignores."""


TURNING = frozenset("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")
"""Characters that make text run the other way, and so let one name look like another."""


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
    return "".join("\N{REPLACEMENT CHARACTER}" if _forbidden(c) else c for c in text)


def _forbidden(character: str) -> bool:
    return (category(character) in ("Cc", "Cs") and character not in "\n\t") or character in TURNING
