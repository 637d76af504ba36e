"""Any URDF as an engine's spec: meshes found, link names kept, and a floor under what would fall for ever."""

from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import mujoco
import numpy as np

from thinkblox.errors import InputError
from thinkblox.sim.build import GROUND
from thinkblox.sim.engine_errors import ENGINE_ERRORS, said
from thinkblox.sim.foreign.asset_limits import check_mesh
from thinkblox.sim.foreign.geom_volumes import lowest_point
from thinkblox.sim.foreign.mjcf_limits import MOST_BODIES, MOST_ELEMENTS, MOST_TRIANGLES_IN_ALL, check_values, too_many
from thinkblox.sim.foreign.names import listed
from thinkblox.sim.foreign.triangles import colliding
from thinkblox.sim.foreign.urdf_files import mesh_file, package_folder
from thinkblox.sim.foreign.xml_elements import Element, clean, walk

WORLD = "world"
"""A root link of this name is the world itself; the engine, Gazebo and Drake know it too."""
FLOOR_MARGIN, FLOOR_DEPTH = 5.0, 0.5
"""How far the floor reaches beyond what stands on it, and how thick it is [m]."""


@dataclass(frozen=True)
class UrdfFiles:
    """A URDF made ready for the engine.

    Attributes:
        text: its XML, every mesh renamed to a key of `meshes`.
        meshes: where each mesh is.
        free_roots: links that nothing holds: each gets a freejoint.
        notes: what a reader should know, in sentences.
    """

    text: str
    meshes: dict[str, Path]
    free_roots: tuple[str, ...]
    notes: tuple[str, ...]


def urdf_spec(path: Path, *, folder: Path | None = None) -> tuple[mujoco.MjSpec, tuple[str, ...]]:
    """The spec of a URDF, and notes on what was added.

    A root link that is not called "world" is free, as in other readers of URDF: it gets a freejoint. A root without
    mass, inertia and shape that carries several links is a frame, and fixed. Where then nothing that stands still can
    be touched, a floor is put under the lowest point of what moves. Visual geometry is left out: it weighs nothing.

    Raises:
        InputError: as `read_urdf`, or the engine cannot read it.
    """
    files = read_urdf(path, folder=folder)
    try:
        assets = {name: file.read_bytes() for name, file in files.meshes.items()}
        spec = mujoco.MjSpec.from_string(files.text, assets=assets)
        for root in files.free_roots:
            spec.body(root).add_freejoint()
        height = add_floor(spec)
    except ENGINE_ERRORS as error:
        raise InputError(f"{path}: MuJoCo cannot read it: {_with_files(said(error), files.meshes)}") from error
    if height is None:
        return spec, files.notes
    return spec, (*files.notes, f"The URDF has no floor: one was put under its lowest point, at z = {height:.3f} m.")


def read_urdf(path: Path, *, folder: Path | None = None) -> UrdfFiles:
    """Look through a URDF without the engine, and make it ready for it.

    Args:
        path: of the file.
        folder: what no mesh may lie outside of; the package's folder, or else the file's own, unless told otherwise.

    Raises:
        InputError: not XML or not URDF; xacro that is not expanded; meshes that are missing, too large or outside the
            folder; numbers that are not numbers; too many links; nothing that can be touched.
    """
    elements = _look_through(path)
    root = ElementTree.fromstring(clean(path))
    folder = (folder or package_folder(path)).absolute()
    meshes = _rename_meshes(path, folder, root, elements)
    _drop_visuals(root)
    _name_shapes(root)
    _set_compiler(root)
    if root.find("link/collision") is None:
        raise InputError(f"{path}: no link has collision geometry, so there is nothing to measure.")
    free = tuple(name for name in _roots(path, root) if not _is_frame(root, name))
    return UrdfFiles(ElementTree.tostring(root, encoding="unicode"), meshes, free, _notes(root, free))


def _look_through(path: Path) -> list[Element]:
    elements: list[Element] = []
    links = 0

    def enter(element: Element) -> None:
        nonlocal links
        if not elements and element.tag != "robot":
            raise InputError(f"{element}: the root of a URDF file is <robot>.")
        if element.tag.startswith("xacro:") or any("${" in value for value in element.attributes.values()):
            raise InputError(f"{element}: this is xacro; expand it first: xacro IN.xacro > OUT.urdf.")
        check_values(element)
        elements.append(element)
        links += element.tag == "link"
        if links > MOST_BODIES:
            raise InputError(too_many(str(element), links))
        if len(elements) > MOST_ELEMENTS:
            raise InputError(f"{element}: the file has at least {len(elements)} elements; at most {MOST_ELEMENTS}.")

    walk(path, enter)
    return elements


def _rename_meshes(path: Path, folder: Path, root: ElementTree.Element, elements: list[Element]) -> dict[str, Path]:
    """Give every colliding mesh a name of its own, and say where its file is; two files may share a name."""
    seen = {id(node): element for node, element in zip(root.iter(), elements, strict=True)}
    compiler = root.find("mujoco/compiler")
    meshdir = "" if compiler is None else compiler.get("meshdir", compiler.get("assetdir", ""))
    names: dict[Path, str] = {}
    triangles = 0
    for mesh in root.iterfind("link/collision/geometry/mesh"):
        where = seen[id(mesh)]
        file = mesh_file(mesh.get("filename", ""), where, path=path, folder=folder, meshdir=meshdir)
        if file not in names:
            triangles += check_mesh(file, where)
            names[file] = f"{len(names)}_{file.stem}{file.suffix.lower()}"
        mesh.set("filename", names[file])
    if triangles > MOST_TRIANGLES_IN_ALL:
        raise InputError(f"{path}: its meshes have {triangles} triangles together; at most {MOST_TRIANGLES_IN_ALL}.")
    return {name: file for file, name in names.items()}


def _drop_visuals(root: ElementTree.Element) -> None:
    """Take the geometry out of what is only looked at; the colours stay."""
    for visual in root.iterfind("link/visual"):
        for geometry in visual.findall("geometry"):
            visual.remove(geometry)


def _name_shapes(root: ElementTree.Element) -> None:
    for link in root.iterfind("link"):
        for number, shape in enumerate(link.iterfind("collision")):
            shape.set("name", f"{link.get('name')}#{number}")


def _set_compiler(root: ElementTree.Element) -> None:
    """Keep the engine's own settings in the file, but for those that would lose links or look for files."""
    extension = root.find("mujoco")
    if extension is None:
        extension = ElementTree.SubElement(root, "mujoco")
    compiler = extension.find("compiler")
    if compiler is None:
        compiler = ElementTree.SubElement(extension, "compiler")
    for name in ("meshdir", "assetdir", "texturedir"):
        compiler.attrib.pop(name, None)
    compiler.attrib |= {"strippath": "false", "fusestatic": "false", "discardvisual": "true"}


def _roots(path: Path, root: ElementTree.Element) -> list[str]:
    children = {child.get("link") for child in root.iterfind("joint/child")}
    names = [link.get("name", "") for link in root.iterfind("link")]
    roots = [name for name in names if name not in children]
    if names and not roots:
        raise InputError(f"{path}: every link is the child of a joint, so the links hang in a circle.")
    return roots


def _is_frame(root: ElementTree.Element, name: str) -> bool:
    """Whether a root link is the world or a mere frame, so that what hangs on it is fixed."""
    link = next(link for link in root.iterfind("link") if link.get("name", "") == name)
    carried = sum(parent.get("link") == name for parent in root.iterfind("joint/parent"))
    empty = link.find("inertial") is None and link.find("collision") is None
    return name == WORLD or (empty and carried != 1)


def _notes(root: ElementTree.Element, free: tuple[str, ...]) -> tuple[str, ...]:
    found = []
    if free:
        found.append(
            f"Nothing holds the root link {listed(free)}, so it stands free; a root link called {WORLD} would hold it."
        )
    light = [link.get("name", "") for link in root.iterfind("link") if _weighed_by_shape(link)]
    if light:
        found.append(f"Without inertial, {listed(light)} weighs what its collision shapes do at 1000 kg/m3.")
    mimics = [joint.get("name", "") for joint in root.iterfind("joint") if joint.find("mimic") is not None]
    if mimics:
        found.append(f"The engine does not know mimic joints: {listed(mimics)} moves by itself.")
    return tuple(found)


def _weighed_by_shape(link: ElementTree.Element) -> bool:
    return link.find("inertial") is None and link.find("collision") is not None


def add_floor(spec: mujoco.MjSpec) -> float | None:
    """Put a floor under what is free where nothing fixed can be touched.

    It is a box, as in our own rooms: the engine's plane throws upright cylinders up.

    Returns:
        Its height [m]; None where none is needed.
    """
    model = spec.compile()
    free = model.jnt_type == int(mujoco.mjtJoint.mjJNT_FREE)
    touchable = colliding(model)
    fixed = model.body_weldid[model.geom_bodyid] == 0
    if not free.any() or (touchable & fixed).any() or not touchable.any():
        return None
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    geoms = np.flatnonzero(touchable)
    height = min(lowest_point(model, data, int(geom)) for geom in geoms)
    reach = (np.abs(data.geom_xpos[geoms, :2]) + model.geom_rbound[geoms, None]).max() + FLOOR_MARGIN
    floor = spec.worldbody.add_geom(name=GROUND, type=mujoco.mjtGeom.mjGEOM_BOX)
    floor.size, floor.pos = (reach, reach, FLOOR_DEPTH / 2), (0.0, 0.0, height - FLOOR_DEPTH / 2)
    return height


def _with_files(text: str, meshes: dict[str, Path]) -> str:
    """What the engine said, with the files' own names."""
    for name, file in meshes.items():
        text = text.replace(f"'{name}'", f"'{file}'").replace(f"'{Path(name).stem}'", f"'{file}'")
    hint = ": a link that moves needs a mass and an inertia above 0" if "mjMINVAL" in text else ""
    return text + hint
