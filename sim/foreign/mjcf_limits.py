"""Looking through MJCF before the engine does: includes put in place, bodies counted, and what is refused."""

import math
from dataclasses import dataclass, field
from pathlib import Path

from thinkblox.errors import InputError
from thinkblox.plain_text import escaped
from thinkblox.sim.foreign.asset_limits import MOST_PIXELS
from thinkblox.sim.foreign.local_files import is_absolute, locate
from thinkblox.sim.foreign.xml_elements import Element, walk
from thinkblox.sim.foreign.xml_tree import Node, Tree

MOST_BODIES = 20_000
MOST_ELEMENTS = 500_000
"""Elements of all kinds, repeated ones counted as often as they are repeated."""
MOST_FILES = 2_000
DEEPEST_INCLUDE = 50
FILES = ("file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback")
_WORDS = frozenset({"name", "class", "childclass", "prefix", "data", "model", "content_type", *FILES})
"""Attributes that are text, in which "nan" is a word."""
_PRODUCTS = {
    "hfield": (("nrow", "ncol"), 25_000_000),
    "texture": (("width", "height"), MOST_PIXELS),
    "numeric": (("size",), 1_000_000),
}
"""Numbers that ask for memory: element, attributes and the most that their product may be."""
_LARGEST_SIZE = 10_000_000
_LARGEST_MEMORY = 8 * 2**30
_UNITS = {"K": 2**10, "M": 2**20, "G": 2**30, "T": 2**40, "P": 2**50, "E": 2**60}


@dataclass(frozen=True)
class NamedFile:
    """An attribute that names a file: the node to be changed, where it stands, and the folder of its XML file."""

    node: Node
    element: Element
    attribute: str
    here: Path


@dataclass
class Scan:
    """One model that was looked through, with everything that it includes put in its place.

    Attributes:
        path: of its file.
        folder: what no named file may lie outside of.
        within: the models that attach it, the outermost first, and itself.
        tree: its elements.
        files: what it names but XML.
        models: what it attaches: the node that names each, and the model.
        dirs: where the engine would look for files, by the attribute of <compiler> that says so.
        strip: whether only the last part of a path counts.
        bodies: that the engine would build, without those of attached models.
    """

    path: Path
    folder: Path
    within: tuple[Path, ...]
    tree: Tree = field(default_factory=Tree)
    copies: list[int] = field(default_factory=lambda: [1])
    included: dict[Path, None] = field(default_factory=dict)
    open_includes: list[Path] = field(default_factory=list)
    dirs: dict[str, tuple[str, Element]] = field(default_factory=dict)
    files: list[NamedFile] = field(default_factory=list)
    models: dict[str, tuple[Node, "Scan"]] = field(default_factory=dict)
    attached: list[tuple[str, int]] = field(default_factory=list)
    strip: bool = False
    bodies: int = 0
    elements: int = 0


def look_through(path: Path, folder: Path, within: tuple[Path, ...] = ()) -> Scan:
    """Look through an MJCF file and all that it includes or attaches, without the engine.

    Args:
        path: of the file.
        folder: what no named file may lie outside of.
        within: the models that attach it, the outermost first.

    Raises:
        InputError: not XML or not MJCF; XML files that are missing or outside the folder; includes in a circle;
            plugins; numbers that are not numbers; too many bodies, elements or files. Names file, line and element.
    """
    if path in within:
        raise InputError(f"{path}: it attaches itself: {' -> '.join(p.name for p in (*within, path))}.")
    scan = Scan(path=path, folder=folder, within=(*within, path))
    scan.open_includes.append(path)
    _walk_file(scan, path)
    return scan


def _walk_file(scan: Scan, path: Path) -> None:
    walk(path, lambda element: _enter(scan, element), lambda element: _leave(scan, element))


def _enter(scan: Scan, element: Element) -> None:
    if element.depth == 0:
        if len(scan.open_includes) > 1:
            return
        if element.tag != "mujoco":
            raise InputError(f"{element}: the root of an MJCF file is <mujoco>.")
        scan.tree.enter(element)
        return
    _count(scan, element)
    check_values(element)
    if element.tag in ("plugin", "extension"):
        raise InputError(f"{element}: engine plugins are code, and models that need them are not read.")
    if element.tag == "include":
        _include(scan, element)
        return
    node = scan.tree.enter(element)
    if element.tag == "compiler":
        _note_dirs(scan, element)
    elif element.tag == "model" and "file" in element.attributes:
        _attach(scan, element, node)
    else:
        here = scan.open_includes[-1].parent
        scan.files += [NamedFile(node, element, name, here) for name in FILES if element.attributes.get(name)]


def _leave(scan: Scan, element: Element) -> None:
    if element.tag == "replicate":
        scan.copies.pop()
    if element.tag != "include" and (element.depth > 0 or len(scan.open_includes) == 1):
        scan.tree.leave()


def _count(scan: Scan, element: Element) -> None:
    copies, tag = scan.copies[-1], element.tag
    if tag == "replicate":
        scan.copies.append(copies * _product(element, "count", 1))
    elif tag == "body":
        scan.bodies += copies
    elif tag in ("composite", "flexcomp"):
        nodes = copies * _product(element, "count", 1)
        scan.elements += nodes
        scan.bodies += nodes if element.attributes.get("dof", "full") == "full" else copies
    elif tag == "attach":
        scan.attached.append((element.attributes.get("model", ""), copies))
    scan.elements += copies
    if scan.bodies > MOST_BODIES:
        raise InputError(too_many(str(element), scan.bodies))
    if scan.elements > MOST_ELEMENTS:
        raise InputError(f"{element}: the model has at least {scan.elements} elements; at most {MOST_ELEMENTS}.")


def too_many(where: str, bodies: int) -> str:
    """What to say of a model with too many bodies."""
    return f"{where}: the model has at least {bodies} bodies; at most {MOST_BODIES} are read."


def bodies_of(scan: Scan) -> int:
    """How many bodies the engine would build of a model and all that it attaches; raises InputError when too many."""
    own = {name: bodies_of(model) for name, (_, model) in scan.models.items()}
    most = max(own.values(), default=0)
    total = scan.bodies + sum(copies * own.get(name, most) for name, copies in scan.attached)
    if total > MOST_BODIES:
        raise InputError(too_many(str(scan.path), total))
    return total


def _product(element: Element, attribute: str, otherwise: int) -> int:
    numbers = [_number(word) for word in element.attributes.get(attribute, "").split()]
    return int(math.prod(max(1.0, n) for n in numbers)) if numbers else otherwise


def _number(word: str) -> float:
    """A number, or 0 where there is none: the engine then says what is wrong."""
    try:
        number = float(word)
    except ValueError:
        return 0.0
    return min(number, 1e18) if number == number else 0.0


def check_values(element: Element) -> None:
    """Refuse an element whose value holds a control character, is not a number, or asks for too much memory.

    Raises:
        InputError: naming file, line and element.
    """
    for name, text in element.attributes.items():
        if escaped(text) != text:
            raise InputError(f'{element}: {name}="{escaped(text[:60])}" holds a control character.')
        if "nan" in text.lower() and name not in _WORDS and any(_is_nan(word) for word in text.split()):
            raise InputError(f'{element}: {name}="{text[:60]}" is not a number.')
    names, most = _PRODUCTS.get(element.tag, ((), 0))
    asked = math.prod(_number(element.attributes.get(name, "1")) for name in names)
    if names and asked > most:
        raise InputError(f"{element}: {' x '.join(names)} is {asked:g}; at most {most}.")
    if element.tag == "size":
        _check_sizes(element)


def _is_nan(word: str) -> bool:
    return word.lower().lstrip("+-") == "nan"


def _check_sizes(element: Element) -> None:
    for name, text in element.attributes.items():
        unit = _UNITS.get(text[-1:].upper(), 1)
        asked = _number(text[:-1] if unit > 1 else text) * unit
        if asked > (_LARGEST_MEMORY if name == "memory" else _LARGEST_SIZE):
            raise InputError(f'{element}: {name}="{text}" is more than can be given.')


def _note_dirs(scan: Scan, element: Element) -> None:
    for name in ("assetdir", "meshdir", "texturedir"):
        if name in element.attributes:
            scan.dirs[name] = (element.attributes[name], element)
            if is_absolute(element.attributes[name]):
                raise InputError(
                    f'{element}: {name}="{element.attributes[name]}" is an absolute path: only files inside'
                    f" {scan.folder} are read."
                )
    scan.strip = element.attributes.get("strippath", str(scan.strip)).lower() == "true"


def _include(scan: Scan, element: Element) -> None:
    here, text = scan.open_includes[-1].parent, element.attributes.get("file", "")
    path = locate(text, element, bases=(scan.path.parent, here), folder=scan.folder)
    if path in scan.open_includes:
        circle = " -> ".join(p.name for p in (*scan.open_includes, path))
        raise InputError(f"{element} includes itself: {circle}.")
    if path in scan.included:
        raise InputError(f'{element}: "{text}" is included twice, which MuJoCo does not allow.')
    if len(scan.included) >= MOST_FILES or len(scan.open_includes) >= DEEPEST_INCLUDE:
        raise InputError(f"{element}: more than {MOST_FILES} includes, or more than {DEEPEST_INCLUDE} deep.")
    scan.included[path] = None
    scan.open_includes.append(path)
    _walk_file(scan, path)
    scan.open_includes.pop()


def _attach(scan: Scan, element: Element, node: Node) -> None:
    here, text = scan.open_includes[-1].parent, element.attributes["file"]
    path = locate(text, element, bases=(scan.path.parent, here), folder=scan.folder)
    name = element.attributes.get("name", path.stem)
    if len(scan.models) >= MOST_FILES:
        raise InputError(f"{element}: more than {MOST_FILES} attached models.")
    scan.models[name] = (node, look_through(path, scan.folder, scan.within))


def place_of(scan: Scan, named: NamedFile) -> Path:
    """Where a file is that a model names, looked for as the engine does; raises InputError as `locate`."""
    text = named.element.attributes[named.attribute]
    if scan.strip:
        text = text.replace("\\", "/").rsplit("/", 1)[-1]
    bases = _bases(scan, named.element, named.here)
    return locate(text, named.element, bases=bases, folder=scan.folder)


def _bases(scan: Scan, element: Element, here: Path) -> tuple[Path, ...]:
    """Where the engine looks for a file of an element: in the model's folder, and for included ones in theirs."""
    root = scan.path.parent
    kind = "texturedir" if element.tag == "texture" else "meshdir"
    own = scan.dirs.get(kind, scan.dirs.get("assetdir", ("", element)))[0].replace("\\", "/")
    asset = scan.dirs.get("assetdir", ("", element))[0].replace("\\", "/")
    local = here.relative_to(root) if here.is_relative_to(root) else Path()
    return (
        (root / own, root / own / local, root / asset) if element.tag == "hfield" else (root / own, root / own / local)
    )
