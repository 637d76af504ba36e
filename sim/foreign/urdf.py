"""Any URDF as an engine's spec: meshes found, link names kept, and what no body can weigh mended."""

import math
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import mujoco

from thinkblox.errors import InputError
from thinkblox.sim.engine_errors import ENGINE_ERRORS, said
from thinkblox.sim.foreign.asset_limits import check_amount, read_mesh
from thinkblox.sim.foreign.inertias import mend_inertias
from thinkblox.sim.foreign.mjcf_limits import MOST_BODIES, MOST_ELEMENTS, check_values, too_many
from thinkblox.sim.foreign.names import listed
from thinkblox.sim.foreign.urdf_files import mesh_file, package_folder
from thinkblox.sim.foreign.xml_elements import Element, walk
from thinkblox.sim.foreign.xml_tree import CheckedText, Node, Tree
from thinkblox.value import Vec3

WORLD = "world"
"""A root link of this name is the world itself; the engine, Gazebo and Drake know it too."""
GEOMETRY_NUMBERS = {"xyz": 3, "rpy": 3, "scale": 3}
"""Of how many numbers an attribute consists; other readers pass over more."""
PLANE = (100.0, 100.0, 1.0)
"""The slab that is made of a plane without end [m]."""
ONCE = ("origin", "axis", "limit", "dynamics")


@dataclass(frozen=True)
class UrdfFiles:
    """A URDF made ready for the engine.

    Attributes:
        text: its XML, every mesh renamed to a key of `meshes`.
        meshes: where each mesh is.
        data: the bytes of each mesh.
        free_roots: links that nothing holds: each gets a freejoint.
        notes: what a reader should know, in sentences.
        room: links that are the room itself, of a URDF of ours: fixed to the world and no object.
    """

    text: CheckedText
    meshes: dict[str, Path]
    data: dict[str, bytes]
    free_roots: tuple[str, ...]
    notes: tuple[str, ...]
    room: frozenset[str] = frozenset()

    def refusal(self, path: Path, error: BaseException) -> str:
        """What the engine said, with the files' own names and the line in the URDF."""
        told = self.text.placed(said(error))
        for name, file in self.meshes.items():
            told = told.replace(f"'{name}'", f"'{file}'").replace(f"'{Path(name).stem}'", f"'{file}'")
        hint = ": a link that moves needs a mass and an inertia above 0" if "mjMINVAL" in told else ""
        return f"{path}: MuJoCo cannot read it: {told}{hint}"


def urdf_spec(path: Path, *, folder: Path | None = None, fixed_base: bool = False) -> tuple[mujoco.MjSpec, UrdfFiles]:
    """The spec of a URDF, and what it was made of.

    A root link that is not called "world" is free, as in other readers of URDF: it gets a freejoint. A root without
    mass, inertia and shape that carries several links is a frame, and fixed, and so is one whose <inertial> says that
    it weighs nothing, as in Bullet. Visual geometry is left out: it weighs nothing. Masses and inertias that no body
    can have are mended, with a note.

    Args:
        path: of the file.
        folder: as for `read_urdf`.
        fixed_base: hold every root link to the world.

    Raises:
        InputError: as `read_urdf`, or the engine cannot read it.
    """
    files = read_urdf(path, folder=folder, fixed_base=fixed_base)
    try:
        spec = mujoco.MjSpec.from_string(files.text.xml, assets=files.data)
        for root in files.free_roots:
            spec.body(root).add_freejoint()
    except ENGINE_ERRORS as error:
        raise InputError(files.refusal(path, error)) from error
    return spec, files


def read_urdf(path: Path, *, folder: Path | None = None, fixed_base: bool = False) -> UrdfFiles:
    """Look through a URDF without the engine, and make it ready for it.

    Args:
        path: of the file.
        folder: what no mesh may lie outside of; the package's folder, or else the file's own, unless told otherwise.
        fixed_base: hold every root link to the world.

    Raises:
        InputError: not XML or not URDF; xacro that is not expanded; meshes that are missing, too large or outside the
            folder; numbers that are not numbers; too many links; nothing that can be touched.
    """
    tree = _look_through(path)
    root = tree.open[0]
    folder = (folder or package_folder(path)).absolute()
    meshes, data = _rename_meshes(path, folder, tree, root)
    _drop_visuals(root)
    _name_shapes(root)
    _set_compiler(root)
    cut = (*_read_commas(root), *_cut_numbers(root), *_lay_planes(root), *_keep_first(root))
    if root.find("link/collision") is None:
        raise InputError(f"{path}: no link has collision geometry, so there is nothing to measure.")
    _check_inertials(tree, root)
    roots = _roots(path, root)
    free = () if fixed_base else tuple(name for name in roots if not _is_fixed(root, name))
    mended = mend_inertias(root, free)
    held = _held(root)
    objects = {named.get("name", "") for named in root.iterfind("thinkblox")}
    notes = (*_notes(root, free, roots, held), *cut, *mended.notes())
    return UrdfFiles(tree.text(), meshes, data, free, notes, frozenset(held - objects if objects else ()))


def _look_through(path: Path) -> Tree:
    """The URDF as a tree whose root is its only open element."""
    tree, links = Tree(), 0

    def enter(element: Element) -> None:
        nonlocal links
        if tree.root is None and element.tag != "robot":
            raise InputError(f"{element}: the root of a URDF file is <robot>.")
        if element.tag.startswith("xacro:") or any("${" in value for value in element.attributes.values()):
            raise InputError(f"{element}: this is xacro; expand it first: xacro IN.xacro > OUT.urdf.")
        check_values(element)
        tree.enter(element)
        links += element.tag == "link"
        if links > MOST_BODIES:
            raise InputError(too_many(str(element), links))
        if len(tree.where) > MOST_ELEMENTS:
            raise InputError(f"{element}: the file has at least {len(tree.where)} elements; at most {MOST_ELEMENTS}.")

    walk(path, enter, lambda element: tree.leave() if element.depth else None)
    return tree


def _check_inertials(tree: Tree, root: Node) -> None:
    """Refuse a mass or an inertia that is infinite: the engine would make 0 of some."""
    for inertial in root.iterfind("link/inertial"):
        for node in inertial.iter():
            for name, text in node.attrib.items():
                if _is_infinite(text):
                    raise InputError(f'{tree.where[node]}: {name}="{text}" is not a finite number.')


def _is_infinite(text: str) -> bool:
    try:
        return any(math.isinf(float(word)) for word in text.split())
    except ValueError:
        return False


def _rename_meshes(path: Path, folder: Path, tree: Tree, root: Node) -> tuple[dict[str, Path], dict[str, bytes]]:
    """Give every colliding mesh a name of its own, and say where its file is; two files may share a name."""
    compiler = root.find("mujoco/compiler")
    meshdir = "" if compiler is None else compiler.get("meshdir", compiler.get("assetdir", ""))
    names: dict[Path, str] = {}
    data: dict[str, bytes] = {}
    triangles = 0
    for mesh in root.iterfind("link/collision/geometry/mesh"):
        where = tree.where[mesh]
        file = mesh_file(mesh.get("filename", ""), where, path=path, folder=folder, meshdir=meshdir)
        if file not in names:
            names[file] = f"{len(names)}_{file.stem}{file.suffix.lower()}"
            data[names[file]], more = read_mesh(file, where)
            triangles += more
        mesh.set("filename", names[file])
    check_amount(path, triangles, data)
    return {name: file for file, name in names.items()}, data


def _read_commas(root: Node) -> tuple[str, ...]:
    """Take the commas out from between numbers, as other readers do, and say so."""
    found = 0
    for node in root.iter():
        for name in (*GEOMETRY_NUMBERS, "size"):
            if "," in node.get(name, ""):
                node.set(name, node.get(name, "").replace(",", " "))
                found += 1
    return (f"Commas between the numbers of a position, angles or a scale are read as spaces, {found} times.",) * (
        found > 0
    )


def _lay_planes(root: Node) -> tuple[str, ...]:
    """Make a slab of every level plane, which is Bullet's own word for a floor, and say so."""
    found = 0
    for shape in root.iterfind("link/collision"):
        plane, origin = shape.find("geometry/plane"), shape.find("origin")
        level = plane is not None and _numbers(plane, "normal", (0.0, 0.0, 1.0)) == (0.0, 0.0, 1.0)
        if not level or _numbers(origin, "rpy", (0.0,) * 3) != (0.0,) * 3:
            continue
        x, y, z = _numbers(origin, "xyz", (0.0,) * 3)
        for node in (*shape.findall("origin"), *shape.findall("geometry")):
            shape.remove(node)
        ElementTree.SubElement(shape, "origin", xyz=f"{x} {y} {z - PLANE[2] / 2}")
        ElementTree.SubElement(ElementTree.SubElement(shape, "geometry"), "box", size=" ".join(map(str, PLANE)))
        found += 1
    return (f"A plane is read as a slab of {PLANE[0]:g} by {PLANE[1]:g} m under it, {found} times.",) * (found > 0)


def _numbers(node: Node | None, name: str, otherwise: Vec3) -> Vec3:
    """Three numbers of an attribute; those of `otherwise` where it is not there, and NaN where they are none."""
    if node is None or node.get(name) is None:
        return otherwise
    try:
        x, y, z = map(float, node.get(name, "").split())
    except ValueError:
        return (math.nan,) * 3
    return (x, y, z)


def _cut_numbers(root: Node) -> tuple[str, ...]:
    """Leave out numbers that are one too many, as other readers do, and say so."""
    found = 0
    for node in root.iter():
        for name, count in GEOMETRY_NUMBERS.items():
            words = node.get(name, "").split()
            if len(words) > count:
                node.set(name, " ".join(words[:count]))
                found += 1
    return (
        (f"Of a position, angles or a scale with more than 3 numbers the first 3 count, {found} times.",)
        if found
        else ()
    )


def _keep_first(root: Node) -> tuple[str, ...]:
    """Of what a joint says twice keep the first, as other readers do, and say so."""
    twice: list[str] = []
    for joint in root.iterfind("joint"):
        for tag in ONCE:
            for node in joint.findall(tag)[1:]:
                joint.remove(node)
                twice.append(joint.get("name", ""))
    return (f"The joint {listed(list(dict.fromkeys(twice)))} says something twice; the first counts.",) if twice else ()


def _drop_visuals(root: Node) -> None:
    """Take the geometry out of what is only looked at; the colours stay."""
    for visual in root.iterfind("link/visual"):
        for geometry in visual.findall("geometry"):
            visual.remove(geometry)


def _name_shapes(root: Node) -> None:
    for link in root.iterfind("link"):
        for number, shape in enumerate(link.iterfind("collision")):
            shape.set("name", f"{link.get('name')}#{number}")


def _set_compiler(root: Node) -> None:
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


def _roots(path: Path, root: Node) -> list[str]:
    children = {child.get("link") for child in root.iterfind("joint/child")}
    names = [link.get("name", "") for link in root.iterfind("link")]
    roots = [name for name in names if name not in children]
    if names and not roots:
        raise InputError(f"{path}: every link is the child of a joint, so the links hang in a circle.")
    return roots


def _is_fixed(root: Node, name: str) -> bool:
    """Whether a root link is the world, a mere frame, or said to weigh nothing, so that what hangs on it is fixed."""
    link = next(link for link in root.iterfind("link") if link.get("name", "") == name)
    carried = sum(parent.get("link") == name for parent in root.iterfind("joint/parent"))
    empty = link.find("inertial") is None and link.find("collision") is None
    return name == WORLD or (empty and carried != 1) or _is_weightless(link)


def _is_weightless(link: Node) -> bool:
    mass = link.find("inertial/mass")
    try:
        return mass is not None and float(mass.get("value", "")) == 0.0
    except ValueError:
        return False


def _held(root: Node) -> set[str]:
    """Links that are fixed to the world."""
    held = set()
    for joint in root.iterfind("joint[@type='fixed']"):
        parent, child = joint.find("parent"), joint.find("child")
        if parent is not None and child is not None and parent.get("link") == WORLD:
            held.add(child.get("link", ""))
    return held


def _notes(root: Node, free: tuple[str, ...], roots: list[str], held: set[str]) -> tuple[str, ...]:
    found = []
    if free:
        found.append(
            f"Nothing holds the root link {listed(free)}, so it stands free; --fixed-base holds it, or a root link"
            f" called {WORLD}."
        )
    static = [link.get("name", "") for link in root.iterfind("link") if _is_weightless(link)]
    static = [name for name in roots if name in static and name not in free]
    if static:
        found.append(f"The root link {listed(static)} has the mass 0, so it is fixed, as Bullet reads it.")
    light = [link.get("name", "") for link in root.iterfind("link") if _weighed_by_shape(link)]
    light = [name for name in light if name not in held]
    if light:
        found.append(f"Without inertial, {listed(light)} weighs what its collision shapes do at 1000 kg/m3.")
    mimics = [joint.get("name", "") for joint in root.iterfind("joint") if joint.find("mimic") is not None]
    if mimics:
        found.append(f"The engine does not know mimic joints: {listed(mimics)} moves by itself.")
    return tuple(found)


def _weighed_by_shape(link: Node) -> bool:
    return link.find("inertial") is None and link.find("collision") is not None
