"""XML as it was read and checked, to be changed and given to the engine, which then reads nothing from the disk."""

import re
from dataclasses import dataclass, field
from xml.etree import ElementTree
from xml.sax.saxutils import quoteattr

from thinkblox.errors import InputError
from thinkblox.sim.foreign.xml_elements import DEEPEST, Element

Node = ElementTree.Element
_LINE = re.compile(r",? line (\d+)")


@dataclass
class Tree:
    """Elements that grow into a tree while they are read, from one file or several.

    Attributes:
        open: the nodes that are not closed yet, the root first.
        where: where each node stands in its file.
        root: the first node, once there is one.
    """

    open: list[Node] = field(default_factory=list)
    where: dict[Node, Element] = field(default_factory=dict)
    root: Node | None = None

    def enter(self, element: Element) -> Node:
        """Add an element to the innermost open one, and leave it open; raises InputError when that is too deep."""
        if len(self.open) >= DEEPEST:
            raise InputError(f"{element} is nested more than {DEEPEST} deep.")
        node = Node(element.written, dict(element.attributes))
        if self.open:
            self.open[-1].append(node)
        self.root = node if self.root is None else self.root
        self.open.append(node)
        self.where[node] = element
        return node

    def leave(self) -> None:
        """Close the innermost open element."""
        self.open.pop()

    def text(self) -> "CheckedText":
        """All of it as XML, an opening tag on each line; text between tags, which no model has, is left out."""
        lines: list[str] = []
        places: list[Element | None] = []
        if self.root is not None:
            self._write(self.root, lines, places)
        return CheckedText("\n".join(lines), tuple(places))

    def _write(self, node: Node, lines: list[str], places: list[Element | None]) -> None:
        attributes = "".join(f" {name}={quoteattr(value)}" for name, value in node.attrib.items())
        places.append(self.where.get(node))
        lines.append(f"<{node.tag}{attributes}{'' if len(node) else '/'}>")
        for child in node:
            self._write(child, lines, places)
        if len(node):
            lines[-1] += f"</{node.tag}>"


@dataclass(frozen=True)
class CheckedText:
    """XML for the engine, and which element of which file stands on each of its lines."""

    xml: str
    places: tuple[Element | None, ...]

    def placed(self, said: str) -> str:
        """What the engine said of a line, with the file and the line that it comes from."""
        return _LINE.sub(self._place, said)

    def _place(self, found: re.Match[str]) -> str:
        number = int(found[1]) - 1
        place = self.places[number] if 0 <= number < len(self.places) else None
        return "" if place is None else f" at {place.file.name}:{place.line}"
