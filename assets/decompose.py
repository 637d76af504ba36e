"""From a triangle soup to convex pieces that an engine can collide.

Each connected part that is convex as it is becomes its own hull, without any decomposition; the others go through CoACD
(Wei et al. 2022, "Approximate Convex Decomposition for 3D Meshes with Collision-Aware Concavity and Tree Search", ACM
Transactions on Graphics 41:4), at concavity 0.05: shelf openings fill from 0.08 on.
"""

import hashlib
from collections import OrderedDict

import coacd
import numpy as np
from manifold3d import Manifold
from numpy.typing import NDArray

from thinkblox.assets.components import components, edges_of, welded
from thinkblox.assets.mesh_file import MeshFile
from thinkblox.errors import InputError

Array = NDArray[np.float64]
Pieces = tuple[Array, ...]
CONCAVITY = 0.05
"""CoACD's threshold."""
MOST_PIECES = 64
"""Pieces of one mesh; one of more parts is decomposed as a whole."""
MOST_CORNERS = 128
"""Corners of one piece."""
HEAVY = 20_000
"""Triangles from which a part is remeshed before it is decomposed."""
FULL = 0.97
"""Share of its hull that a closed part fills to count as convex."""
THIN = 1e-3
"""Thickness given to a flat part, as a share of the mesh's diagonal."""
FLAT = 1e-4
"""What is thinner than this share of its part's diagonal is flat: the decomposition cuts off such slivers."""
_CACHE: OrderedDict[bytes, Pieces] = OrderedDict()
_CACHED = 256


class FlatMeshError(InputError):
    """A mesh that spans no volume."""


def convex_pieces(mesh: MeshFile) -> Pieces:
    """Corner points (n, 3) of convex pieces, in the mesh's own axes; together they fill exactly its bounding box.

    The pieces of the last 256 different meshes are kept.

    Raises:
        FlatMeshError: all of it lies in one plane.
    """
    key = hashlib.sha256(mesh.vertices.tobytes() + mesh.faces.tobytes()).digest()
    if key not in _CACHE:
        _CACHE[key] = _pieces(mesh)
        while len(_CACHE) > _CACHED:
            _CACHE.popitem(last=False)
    _CACHE.move_to_end(key)
    return _CACHE[key]


def _pieces(mesh: MeshFile) -> Pieces:
    soup = welded(mesh)
    diagonal = float(np.linalg.norm(np.ptp(mesh.vertices, axis=0)))
    if not len(soup.faces) or _thinness(soup.vertices) < 1e-5 * diagonal:
        raise FlatMeshError("the mesh spans no volume: all of it lies in one plane")
    parts = components(soup)
    if len(parts) > MOST_PIECES:
        return _filling(mesh, _decomposed(soup, remesh=True))
    return _filling(mesh, [piece for part in parts for piece in _part_pieces(part, diagonal)])


def _part_pieces(part: MeshFile, diagonal: float) -> list[Array]:
    if _thinness(part.vertices) < THIN * diagonal:
        return [_thickened(part.vertices, THIN * diagonal)]
    if is_convex(part):
        return [_reduced(part.vertices)]
    return _decomposed(part, remesh=len(part.faces) > HEAVY)


def _decomposed(part: MeshFile, *, remesh: bool) -> list[Array]:
    coacd.set_log_level("off")
    found = coacd.run_coacd(
        coacd.Mesh(part.vertices, part.faces.astype(np.int32)),
        threshold=CONCAVITY,
        max_convex_hull=MOST_PIECES // 2,
        preprocess_mode="on" if remesh else "auto",
        preprocess_resolution=40,
        resolution=500,
        mcts_nodes=10,
        mcts_iterations=20,
        seed=0,
    )
    least = FLAT * float(np.linalg.norm(np.ptp(part.vertices, axis=0)))
    pieces = [np.asarray(vertices, dtype=np.float64) for vertices, _ in found]
    solid = [_sound(piece, least) for piece in pieces if len(piece) >= 3 and _extents(piece)[1] >= least]
    return solid or [_sound(part.vertices, least)]


def _sound(piece: Array, least: float) -> Array:
    """Corners of a piece with a volume: one that is flat is thickened to what a flat part gets."""
    return _reduced(piece) if _thinness(piece) >= least else _thickened(piece, least * THIN / FLAT)


def is_convex(part: MeshFile) -> bool:
    """Whether a connected part fills its convex hull: by volume when it is closed, else when it covers it all round."""
    hull = Manifold.hull_points(part.vertices)
    if _closed(part):
        return _volume(part) >= FULL * float(hull.volume())
    outside = _area(part) >= FULL * float(hull.surface_area())
    return outside and _depth(part.vertices, hull) < 0.01 * float(np.linalg.norm(np.ptp(part.vertices, axis=0)))


def _closed(part: MeshFile) -> bool:
    _, counts = np.unique(edges_of(part.faces), axis=0, return_counts=True)
    return bool((counts == 2).all())


def _volume(part: MeshFile) -> float:
    a, b, c = (part.vertices[part.faces[:, k]] - part.vertices[0] for k in range(3))
    return abs(float(np.einsum("ij,ij->", a, np.cross(b, c)))) / 6.0


def _area(part: MeshFile) -> float:
    a, b, c = (part.vertices[part.faces[:, k]] for k in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()) / 2.0


def _depth(points: Array, hull: Manifold) -> float:
    """How far the deepest of the points is under the surface of their hull, as seen from a hull of few faces."""
    faces = hull.to_mesh()
    corners = np.asarray(faces.vert_properties, dtype=np.float64)[:, :3][np.asarray(faces.tri_verts)[:256]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-20)
    offsets = np.einsum("ij,ij->i", normals, corners[:, 0])
    blocks = [block for block in np.array_split(points, 16) if len(block)]
    return max(float((offsets - block @ normals.T).min(axis=1).max()) for block in blocks)


def _extents(points: Array) -> list[float]:
    """Extents along the principal axes of the points, the least first."""
    centred = points - points.mean(axis=0)
    _, axes = np.linalg.eigh(centred.T @ centred)
    return sorted(np.ptp(centred @ axes, axis=0).tolist())


def _thinness(points: Array) -> float:
    """Extent along the direction in which the points extend least."""
    return _extents(points)[0]


def _thickened(points: Array, thickness: float) -> Array:
    centred = points - points.mean(axis=0)
    _, axes = np.linalg.eigh(centred.T @ centred)
    normal = axes[:, 0] * thickness / 2
    return _reduced(np.vstack([points - normal, points + normal]))


def _reduced(points: Array) -> Array:
    """Corners of the points' hull, at most about MOST_CORNERS of them: the furthest in evenly spread directions."""
    hull = Manifold.hull_points(points).to_mesh()
    corners: Array = np.asarray(hull.vert_properties, dtype=np.float64)[:, :3]
    if len(corners) <= MOST_CORNERS:
        return corners
    chosen = np.unique((corners @ _directions().T).argmax(axis=0))
    kept: Array = corners[chosen]
    return kept


def _directions() -> Array:
    """The axes, and points of a Fibonacci lattice on the sphere."""
    count = MOST_CORNERS - 6
    height = 1 - (2 * np.arange(count) + 1) / count
    angle = np.arange(count) * np.pi * (3 - np.sqrt(5))
    ring = np.sqrt(1 - height**2)
    return np.vstack([np.eye(3), -np.eye(3), np.column_stack([ring * np.cos(angle), ring * np.sin(angle), height])])


def _filling(mesh: MeshFile, pieces: list[Array]) -> Pieces:
    """The pieces, stretched by what their approximation lost, so that they fill the mesh's bounding box."""
    low, high = mesh.bounds
    have = np.vstack(pieces)
    least, most = have.min(axis=0), have.max(axis=0)
    scale = (high - low) / np.maximum(most - least, 1e-12)
    return tuple((piece - least) * scale + low for piece in pieces)
