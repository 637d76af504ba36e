"""A compiled MuJoCo model, whoever made it, as triangles to be pictured."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from thinkblox.sim.render.materials import MATERIALS, Colour, linear
from thinkblox.sim.render.soup import ROOM, Patch, Soup
from thinkblox.sim.render.tessellate import Ints, Mesh, capsule, cylinder, ellipsoid, rounded_box

if TYPE_CHECKING:
    import mujoco

    from thinkblox.sim.subject import Thing

SHOWN_GROUPS = 3
"""Geoms of groups 0, 1 and 2 are what MuJoCo's viewer shows; most models keep collision geoms in group 3."""
MOST_FACES = 500_000
"""So many faces of meshes are pictured at most; meshes with more than their share are pictured as their hulls."""
FAR = 25.0
"""Half the side of a plane without limits [m]."""
CLEAR = 0.5
"""What lets more light through than this is pictured as glass."""


def add_model(soup: Soup, model: "mujoco.MjModel", data: "mujoco.MjData", things: "Sequence[Thing]") -> None:
    """Add what a model shows at a state; a thing's number is its place among `things`, all else is the room.

    Args:
        soup: what it is added to.
        model: compiled.
        data: a state whose positions have been computed.
        things: the objects.
    """
    owners = {body: number for number, thing in enumerate(things) for body in thing.bodies}
    by_owner: dict[int, list[int]] = {}
    for geom, body in enumerate(model.geom_bodyid.tolist()):
        by_owner.setdefault(owners.get(body, ROOM), []).append(geom)
    seen = [(owner, geom) for owner, geoms in sorted(by_owner.items()) for geom in seen_geoms(model, geoms)]
    most = _fair_share([_face_count(model, geom) for _, geom in seen])
    for owner, geom in seen:
        mesh = geom_mesh(model, geom, most=most)
        if mesh is not None:
            soup.add(mesh, _patch(model, data, geom, owner, mesh))


def _face_count(model: "mujoco.MjModel", geom: int) -> int:
    import mujoco

    number = int(model.geom_dataid[geom]) if int(model.geom_type[geom]) == mujoco.mjtGeom.mjGEOM_MESH else -1
    return int(model.mesh_facenum[number]) if number >= 0 else 0


def _fair_share(counts: Sequence[int]) -> int:
    """The largest mesh that is pictured as it is, so that all that are have no more than MOST_FACES together."""
    total = 0
    for count in sorted(counts):
        total += count
        if total > MOST_FACES:
            return count - 1
    return MOST_FACES


def seen_geoms(model: "mujoco.MjModel", geoms: Sequence[int]) -> list[int]:
    """Those geoms of an object that are there to be looked at; the ones that collide where there are none.

    A geom that collides is left out when others are there for looks only, in a group of their own.
    """
    shown = [g for g in geoms if model.geom_group[g] < SHOWN_GROUPS and geom_colour(model, g)[3] > 0.0]
    looks = {int(model.geom_group[g]) for g in shown if not _collides(model, g)}
    if looks:
        shown = [g for g in shown if int(model.geom_group[g]) in looks]
    return shown or [g for g in geoms if _collides(model, g)] or list(geoms)


def _collides(model: "mujoco.MjModel", geom: int) -> bool:
    return bool(model.geom_contype[geom] or model.geom_conaffinity[geom])


def geom_mesh(model: "mujoco.MjModel", geom: int, *, most: int = MOST_FACES) -> Mesh | None:
    """A geom as triangles in its own frame, a mesh of more than `most` faces as its hull; None without any faces."""
    import mujoco

    kind, (x, y, z) = int(model.geom_type[geom]), (float(c) for c in model.geom_size[geom])
    kinds = mujoco.mjtGeom
    if kind == kinds.mjGEOM_PLANE:
        return _plane(x or FAR, y or FAR)
    if kind == kinds.mjGEOM_BOX:
        return rounded_box((2 * x, 2 * y, 2 * z), 0.0)
    if kind == kinds.mjGEOM_SPHERE:
        return ellipsoid((2 * x, 2 * x, 2 * x))
    if kind == kinds.mjGEOM_ELLIPSOID:
        return ellipsoid((2 * x, 2 * y, 2 * z))
    if kind == kinds.mjGEOM_CYLINDER:
        return cylinder((2 * x, 2 * x, 2 * y))
    if kind == kinds.mjGEOM_CAPSULE:
        return capsule((2 * x, 2 * x, 2 * (x + y)))
    if kind == kinds.mjGEOM_HFIELD:
        return _hfield(model, int(model.geom_dataid[geom]))
    return _mesh(model, int(model.geom_dataid[geom]), most)


def _plane(half_x: float, half_y: float) -> Mesh:
    corners = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]) * [half_x, half_y, 0.0]
    return _flat(corners, np.array([(0, 1, 2), (0, 2, 3)], np.int32))


def _hfield(model: "mujoco.MjModel", number: int) -> Mesh:
    rows, columns = int(model.hfield_nrow[number]), int(model.hfield_ncol[number])
    start = int(model.hfield_adr[number])
    x, y, top, _ = (float(c) for c in model.hfield_size[number])
    heights = model.hfield_data[start : start + rows * columns].reshape(rows, columns) * top
    across, along = np.meshgrid(np.linspace(-x, x, columns), np.linspace(-y, y, rows))
    points = np.stack([across, along, heights], -1).reshape(-1, 3)
    i, j = (index.ravel() for index in np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij"))
    a = i * columns + j
    faces = np.concatenate([np.stack([a, a + 1, a + columns + 1], 1), np.stack([a, a + columns + 1, a + columns], 1)])
    return _flat(points, faces.astype(np.int32))


def _mesh(model: "mujoco.MjModel", number: int, most: int) -> Mesh | None:
    if number < 0:
        return None
    start, count = int(model.mesh_vertadr[number]), int(model.mesh_vertnum[number])
    first, total = int(model.mesh_faceadr[number]), int(model.mesh_facenum[number])
    points = np.asarray(model.mesh_vert[start : start + count], np.float64)
    if total == 0 or total > most:
        return _hull(points)
    return _flat(points, np.asarray(model.mesh_face[first : first + total], np.int32))


def _hull(points: NDArray[np.float64]) -> Mesh | None:
    from manifold3d import Manifold

    solid = Manifold.hull_points(points).to_mesh()
    corners = np.asarray(solid.vert_properties, np.float64)[:, :3]
    return _flat(corners, np.asarray(solid.tri_verts, np.int32)) if len(corners) else None


def _flat(points: NDArray[np.float64], faces: Ints) -> Mesh:
    """Triangles with one normal for each face."""
    corners = points[faces]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = cross / np.maximum(np.linalg.norm(cross, axis=1, keepdims=True), 1e-20)
    index = np.arange(3 * len(faces), dtype=np.int32).reshape(-1, 3)
    return Mesh(corners.reshape(-1, 3).astype(np.float32), np.repeat(normals, 3, axis=0).astype(np.float32), index)


def _patch(model: "mujoco.MjModel", data: "mujoco.MjData", geom: int, owner: int, mesh: Mesh) -> Patch:
    rgba = geom_colour(model, geom)
    red, green, blue = (float(np.clip(c, 0.0, 1.0)) for c in rgba[:3])
    colour: Colour = (red, green, blue)
    extent = np.ptp(mesh.vertices, axis=0) if len(mesh.vertices) else np.zeros(3)
    x, y, z = (max(float(c), 1e-4) for c in extent)
    return Patch(
        linear(colour),
        MATERIALS.index("glass" if rgba[3] < CLEAR and owner != ROOM else "plastic"),
        owner,
        np.array(data.geom_xmat[geom]).reshape(3, 3),
        np.array(data.geom_xpos[geom]),
        (x, y, z),
    )


def geom_colour(model: "mujoco.MjModel", geom: int) -> NDArray[np.float64]:
    """A geom's colour, times the mean of its texture where it has one."""
    import mujoco

    material = int(model.geom_matid[geom])
    own = np.asarray(model.geom_rgba[geom], np.float64)
    if material < 0:
        return own
    colour = np.array(model.mat_rgba[material], np.float64)
    if not np.allclose(own, (0.5, 0.5, 0.5, 1.0)):
        colour = own.copy()
    texture = int(model.mat_texid[material, int(mujoco.mjtTextureRole.mjTEXROLE_RGB)])
    if texture >= 0:
        colour[:3] *= _mean_texel(model, texture)
    return colour


def _mean_texel(model: "mujoco.MjModel", texture: int) -> NDArray[np.float64]:
    start, channels = int(model.tex_adr[texture]), int(model.tex_nchannel[texture])
    count = int(model.tex_height[texture]) * int(model.tex_width[texture])
    texels = model.tex_data[start : start + count * channels].reshape(-1, channels)
    mean = texels[:: max(len(texels) // 4096, 1)].mean(0) / 255.0
    return np.asarray(mean[:3] if channels >= 3 else np.repeat(mean[:1], 3))
