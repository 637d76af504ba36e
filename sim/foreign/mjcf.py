"""Any MJCF as an engine's spec: made of the very text and files that were checked, with a floor where it has none."""

from dataclasses import dataclass, field
from pathlib import Path

import mujoco

from thinkblox.errors import InputError
from thinkblox.sim.engine_errors import ENGINE_ERRORS, said
from thinkblox.sim.foreign.asset_limits import check_amount, is_picture, read_mesh, read_other
from thinkblox.sim.foreign.mjcf_limits import FILES, NamedFile, Scan, bodies_of, look_through, place_of
from thinkblox.sim.foreign.names import listed
from thinkblox.sim.foreign.xml_tree import CheckedText, Node

_MESHES = ("mesh", "flexcomp")
_CALLED_AFTER_FILES = ("mesh", "texture", "hfield", "skin")
"""What is named after its file where it has no name."""
_DIRS = ("assetdir", "meshdir", "texturedir", "strippath")
_PLAIN = {"builtin": "flat", "width": "1", "height": "1", "rgb1": ".8 .8 .8"}


@dataclass
class NamedFiles:
    """What the engine is given beside the text of a model.

    Attributes:
        data: bytes of each file, by the name that the text has for it.
        paths: where each was read.
        meshes: where the mesh of each name was read.
        triangles: of all meshes.
        plain: pictures that were not read, as the model names them.
        texts: what it attaches, by the name that the text has for it.
    """

    data: dict[str, bytes] = field(default_factory=dict)
    paths: dict[str, Path] = field(default_factory=dict)
    meshes: dict[str, Path] = field(default_factory=dict)
    triangles: int = 0
    plain: list[str] = field(default_factory=list)
    texts: dict[str, CheckedText] = field(default_factory=dict)

    def named(self, said: str) -> str:
        """What the engine said, with the files' own names."""
        for name, path in self.paths.items():
            said = said.replace(f"'{name}'", f"'{path}'")
        return said


def mjcf_spec(path: Path, *, folder: Path | None = None) -> tuple[mujoco.MjSpec, CheckedText, NamedFiles]:
    """The spec of an MJCF file, the text that it was made of, and the files.

    Includes are put in their places and every file is read once, so that the engine reads nothing from the disk.
    Pictures are only looked at: one that is missing, elsewhere or of a kind that the engine does not read is left
    plain.

    Args:
        path: of the file.
        folder: what no named file may lie outside of; the file's own folder unless told otherwise.

    Raises:
        InputError: not XML or not MJCF; files that are missing, too large or outside the folder; includes in a circle;
            plugins; numbers that are not numbers; too many bodies, elements, files, triangles or pixels; or the engine
            cannot read it. Names file, line and element.
    """
    path = path.absolute()
    scan = look_through(path, (folder or path.parent).absolute())
    bodies_of(scan)
    files = NamedFiles()
    text = _ready(scan, files)
    return _read(path, text, files), text, files


def plain_note(files: NamedFiles) -> tuple[str, ...]:
    """What to say of pictures that were not read."""
    found = list(dict.fromkeys(files.plain))
    if not found:
        return ()
    what = "A picture is" if len(found) == 1 else f"{len(found)} pictures are"
    return (
        f"{what} missing, outside the folder, or no PNG or KTX, and left plain, as physics sees none: {listed(found)}.",
    )


def _ready(scan: Scan, files: NamedFiles) -> CheckedText:
    """The text of a model, in which every file has the name that the engine is given it by."""
    for named in scan.files:
        if named.element.tag == "texture":
            _give_picture(scan, named, files)
        else:
            _give(scan, named, files)
    for node, model in scan.models.values():
        name = f"model_{len(files.texts)}_{model.path.stem}.xml"
        files.texts[name] = _ready(model, files)
        files.paths[name] = model.path
        node.set("file", name)
    for node in scan.tree.where:
        if node.tag == "compiler":
            for name in _DIRS:
                node.attrib.pop(name, None)
    return scan.tree.text()


def _give(scan: Scan, named: NamedFile, files: NamedFiles) -> None:
    found, element = place_of(scan, named), named.element
    if element.tag in _MESHES:
        data, triangles = read_mesh(found, element)
        files.triangles += triangles
    else:
        data = read_other(found, element)
    _take(scan, named, found, data, files)


def _give_picture(scan: Scan, named: NamedFile, files: NamedFiles) -> None:
    if named.attribute not in named.node.attrib:
        return  # another side of it was missing
    try:
        found = place_of(scan, named)
    except InputError:
        found = None
    data = b"" if found is None else read_other(found, named.element)
    if found is None or not is_picture(data):
        files.plain.append(named.element.attributes[named.attribute])
        _make_plain(named.node)
    else:
        _take(scan, named, found, data, files)


def _make_plain(node: Node) -> None:
    for name in (*FILES, "gridsize", "gridlayout", "content_type"):
        node.attrib.pop(name, None)
    node.attrib |= _PLAIN


def _take(scan: Scan, named: NamedFile, found: Path, data: bytes, files: NamedFiles) -> None:
    """Put a file among those that the engine is given; two elements may name one file."""
    name = next((name for name, path in files.paths.items() if path == found), "")
    if not name:
        name = f"{len(files.paths)}_{found.stem}{found.suffix.lower()}"
        files.paths[name], files.data[name] = found, data
    check_amount(scan.path, files.triangles, files.data)
    if named.element.tag in _CALLED_AFTER_FILES and not named.node.get("name"):
        last = named.element.attributes[named.attribute].replace("\\", "/").rsplit("/", 1)[-1]
        named.node.set("name", last.rsplit(".", 1)[0])
    named.node.set(named.attribute, name)
    if named.element.tag in _MESHES:
        files.meshes[named.node.get("name", "")] = found


def _read(path: Path, text: CheckedText, files: NamedFiles) -> mujoco.MjSpec:
    texts = {name: part.xml.encode() for name, part in files.texts.items()}
    for name, part in files.texts.items():
        _parsed(files.paths[name], part, texts, files)
    return _parsed(path, text, texts, files)


def _parsed(path: Path, text: CheckedText, texts: dict[str, bytes], files: NamedFiles) -> mujoco.MjSpec:
    try:
        return mujoco.MjSpec.from_string(text.xml, include=texts, assets=files.data)
    except ENGINE_ERRORS as error:
        raise InputError(refusal(path, error, text, files)) from error


def refusal(path: Path, error: BaseException, text: CheckedText, files: NamedFiles) -> str:
    """What the engine said, with the file and line of the element that it speaks of, and the mesh's own file."""
    engine = said(error)
    mesh = next((str(file) for name, file in files.meshes.items() if f"Element name '{name}'" in engine), "")
    told = files.named(text.placed(engine))
    if "keyframe" in engine and "size" in engine:
        told += " (bodies or joints came or went since the keyframes were written: take the <key> elements out)"
    return f"{path}: MuJoCo cannot read it: {told}" + (f" (mesh file {mesh})" if mesh and mesh not in told else "")
