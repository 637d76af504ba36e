"""Reading an XML file element by element: nothing is kept, no entity is expanded, and every element knows its line."""

import re
from codecs import BOM_UTF8
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from xml.parsers import expat

from thinkblox.errors import InputError
from thinkblox.plain_text import escaped
from thinkblox.sim.foreign.local_files import read_limited

LARGEST_FILE = 100 * 2**20
"""Of one XML file [bytes]."""
DEEPEST = 400
"""Nesting of elements; the engine's own parser gives up at 500."""
_TOKENS = re.compile(
    rb"""<!--(?:(?!-->).)*+(?:-->|\Z)|<\?xml[^?<>]*\?>|<[^!?](?:[^<>"']|"[^"<]*"|'[^'<]*')*+>|<.*""", re.DOTALL
)
"""Comments, the XML declaration, tags with their quoted values; or else all that is left, which is then kept as it is.
Linear in time, and nothing that looks like a comment inside a tag is taken for one."""


@dataclass(frozen=True)
class Element:
    """One opening tag: where it is, its name in lower case and as written, and its attributes."""

    file: Path
    line: int
    tag: str
    written: str
    attributes: Mapping[str, str]
    depth: int

    def __str__(self) -> str:
        name = escaped(self.attributes.get("name", ""))
        return f"{self.file}:{self.line}: <{self.tag}" + (f' name="{name}">' if name else ">")


Visit = Callable[[Element], None]


def read_bytes(path: Path) -> bytes:
    """A file's bytes, without zeros at its end; raises InputError as `read_limited`, or when it is empty."""
    data = read_limited(path, path, LARGEST_FILE).rstrip(b"\0")
    if not data.strip():
        raise InputError(f"{path}: the file is empty.")
    return data


def clean(path: Path) -> bytes:
    """A file's XML as a strict parser reads it.

    Like the engine's own parser this bears dashes inside comments and blanks before the XML declaration; unlike it,
    it refuses everything else that is not well-formed, and every DOCTYPE, as parsers disagree on where one ends. Lines
    stay where they are.

    Raises:
        InputError: as `read_bytes`, or not XML; names file, line and column.
    """
    data = read_bytes(path)
    if not _well_formed(path, data):
        data = _without_comments(data)
        _parse(path, _parser(path), data)
    return data


def walk(path: Path, enter: Visit, leave: Visit | None = None) -> None:
    """Call `enter` at every opening tag of a file and `leave` at every closing one, in the order of the file.

    Raises:
        InputError: as `clean`, or elements nested too deep.
    """
    data, parser = clean(path), _parser(path)
    open_elements: list[Element] = []

    def start(tag: str, attributes: dict[str, str]) -> None:
        element = Element(path, parser.CurrentLineNumber, tag.lower(), tag, attributes, len(open_elements))
        if element.depth >= DEEPEST:
            raise InputError(f"{element} is nested more than {DEEPEST} deep.")
        open_elements.append(element)
        enter(element)

    def end(_tag: str) -> None:
        element = open_elements.pop()
        if leave:
            leave(element)

    parser.StartElementHandler, parser.EndElementHandler = start, end
    _parse(path, parser, data)


def _well_formed(path: Path, data: bytes) -> bool:
    try:
        _parser(path).Parse(data, True)
    except expat.ExpatError:
        return False
    return True


def _parser(path: Path) -> expat.XMLParserType:
    parser = expat.ParserCreate("utf-8")

    def doctype(*_declaration: object) -> None:
        raise InputError(f"{path}:{parser.CurrentLineNumber}: it has a DOCTYPE, which no model needs: take it out.")

    parser.StartDoctypeDeclHandler = doctype
    return parser


def _without_comments(data: bytes) -> bytes:
    return _TOKENS.sub(lambda token: _blank(token[0]), data.removeprefix(BOM_UTF8))


def _blank(token: bytes) -> bytes:
    """A comment or declaration as nothing but its line ends; a tag as it is."""
    return re.sub(rb"[^\n]", b" ", token) if token.startswith((b"<!--", b"<?xml")) else token


def _parse(path: Path, parser: expat.XMLParserType, data: bytes) -> None:
    try:
        parser.Parse(data, True)
    except expat.ExpatError as error:
        what = expat.ErrorString(error.code)
        raise InputError(f"{path}:{error.lineno}:{error.offset + 1}: not well-formed XML: {what}") from error
