"""Looking through MJCF before the engine does: how much it would build, which files it names, and what is refused."""

import math
from dataclasses import dataclass, field
from pathlib import Path

from thinkblox.errors import InputError
from thinkblox.sim.foreign.asset_limits import MOST_PIXELS, check_mesh, check_other
from thinkblox.sim.foreign.local_files import is_absolute, locate
from thinkblox.sim.foreign.xml_elements import Element, walk

MOST_BODIES = 20_000
MOST_ELEMENTS = 500_000
"""Elements of all kinds, repeated ones counted as often as they are repeated."""
MOST_FILES = 2_000
MOST_TRIANGLES_IN_ALL = 20_000_000
DEEPEST_INCLUDE = 50
_MESHES = ("mesh", "flexcomp")
_FILES = ("file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback")
_WORDS = frozenset({"name", "class", "childclass", "prefix", "data", "model", "content_type", *_FILES})
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
class MjcfFiles:
    """What a model is made of.

    Attributes:
        bodies: that the engine would build.
        meshes: file of each mesh, by the mesh's name.
    """

    bodies: int
    meshes: dict[str, Path]


@dataclass
class _Scan:
    """The state of looking through one model, with everything that it includes."""

    path: Path
    folder: Path
    within: tuple[Path, ...]
    copies: list[int] = field(default_factory=lambda: [1])
    included: dict[Path, None] = field(default_factory=dict)
    open_includes: list[Path] = field(default_factory=list)
    dirs: dict[str, tuple[str, Element]] = field(default_factory=dict)
    files: list[tuple[Element, str, Path]] = field(default_factory=list)
    models: dict[str, "_Scan"] = field(default_factory=dict)
    attached: list[tuple[str, int]] = field(default_factory=list)
    strip: bool = False
    bodies: int = 0
    elements: int = 0


def check_mjcf(path: Path, *, folder: Path | None = None) -> MjcfFiles:
    """Look through an MJCF file and all that it includes or attaches, without the engine.

    Args:
        path: of the file.
        folder: what no named file may lie outside of; the file's own folder unless told otherwise.

    Raises:
        InputError: not XML or not MJCF; files that are missing, too large or outside the folder; includes in a circle;
            plugins; numbers that are not numbers; too many bodies, elements, files, triangles or pixels. Names file,
            line and element.
    """
    path = path.absolute()
    scan = _look_through(path, (folder or path.parent).absolute(), ())
    meshes, triangles = {}, 0
    for element, attribute, found in _named_files(scan):
        if element.tag in _MESHES:
            triangles += check_mesh(found, element)
            meshes[element.attributes.get("name") or Path(element.attributes[attribute]).stem] = found
        else:
            check_other(found, element)
    if triangles > MOST_TRIANGLES_IN_ALL:
        raise InputError(f"{path}: its meshes have {triangles} triangles together; at most {MOST_TRIANGLES_IN_ALL}.")
    return MjcfFiles(bodies=_bodies(scan), meshes=meshes)


def _look_through(path: Path, folder: Path, within: tuple[Path, ...]) -> _Scan:
    if path in within:
        raise InputError(f"{path}: it attaches itself: {' -> '.join(p.name for p in (*within, path))}.")
    scan = _Scan(path=path, folder=folder, within=(*within, path))
    scan.open_includes.append(path)
    _walk_file(scan, path)
    return scan


def _walk_file(scan: _Scan, path: Path) -> None:
    walk(path, lambda element: _enter(scan, element), lambda element: _leave(scan, element))


def _enter(scan: _Scan, element: Element) -> None:
    if element.depth == 0:
        if len(scan.open_includes) == 1 and element.tag != "mujoco":
            raise InputError(f"{element}: the root of an MJCF file is <mujoco>.")
        return
    _count(scan, element)
    check_values(element)
    if element.tag in ("plugin", "extension"):
        raise InputError(f"{element}: engine plugins are code, and models that need them are not read.")
    if element.tag == "compiler":
        _note_dirs(scan, element)
    elif element.tag == "include":
        _include(scan, element)
    elif element.tag == "model" and "file" in element.attributes:
        _attach(scan, element)
    else:
        here = scan.open_includes[-1].parent
        scan.files += [(element, name, here) for name in _FILES if element.attributes.get(name)]


def _leave(scan: _Scan, element: Element) -> None:
    if element.tag == "replicate":
        scan.copies.pop()


def _count(scan: _Scan, element: Element) -> None:
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


def _bodies(scan: _Scan) -> int:
    """Of a model with all that it attaches."""
    own = {name: _bodies(model) for name, model in scan.models.items()}
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
    """Refuse an element with a value that is not a number, or that asks for too much memory; raises InputError."""
    for name, text in element.attributes.items():
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


def _note_dirs(scan: _Scan, element: Element) -> None:
    for name in ("assetdir", "meshdir", "texturedir"):
        if name in element.attributes:
            scan.dirs[name] = (element.attributes[name], element)
            if is_absolute(element.attributes[name]):
                raise InputError(
                    f'{element}: {name}="{element.attributes[name]}" is an absolute path: only files inside'
                    f" {scan.folder} are read."
                )
    scan.strip = element.attributes.get("strippath", str(scan.strip)).lower() == "true"


def _include(scan: _Scan, element: Element) -> None:
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


def _attach(scan: _Scan, element: Element) -> None:
    here, text = scan.open_includes[-1].parent, element.attributes["file"]
    path = locate(text, element, bases=(scan.path.parent, here), folder=scan.folder)
    name = element.attributes.get("name", path.stem)
    if len(scan.models) >= MOST_FILES:
        raise InputError(f"{element}: more than {MOST_FILES} attached models.")
    scan.models[name] = _look_through(path, scan.folder, scan.within)


def _named_files(scan: _Scan) -> list[tuple[Element, str, Path]]:
    """Every file but XML that a model and what it attaches name: element, attribute and where it is."""
    found = []
    for element, attribute, here in scan.files:
        text = element.attributes[attribute]
        if scan.strip:
            text = text.replace("\\", "/").rsplit("/", 1)[-1]
        found.append((element, attribute, locate(text, element, bases=_bases(scan, element, here), folder=scan.folder)))
    for model in scan.models.values():
        found += _named_files(model)
    return found


def _bases(scan: _Scan, element: Element, here: Path) -> tuple[Path, ...]:
    """Where the engine looks for a file of an element: in the model's folder, and for included ones in theirs."""
    root = scan.path.parent
    kind = "texturedir" if element.tag == "texture" else "meshdir"
    own = scan.dirs.get(kind, scan.dirs.get("assetdir", ("", element)))[0].replace("\\", "/")
    asset = scan.dirs.get("assetdir", ("", element))[0].replace("\\", "/")
    local = here.relative_to(root) if here.is_relative_to(root) else Path()
    return (
        (root / own, root / own / local, root / asset) if element.tag == "hfield" else (root / own, root / own / local)
    )
