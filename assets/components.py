"""The connected parts of a triangle soup."""

import numpy as np
from numpy.typing import NDArray

from thinkblox.assets.mesh_file import MeshFile

Indices = NDArray[np.int64]


def welded(mesh: MeshFile) -> MeshFile:
    """The same mesh with corners at one place made one, to a millionth of its size.

    MeshFile without area, and those with the same corners as another (the other side of a double one), are left out.
    """
    span = float(np.ptp(mesh.vertices, axis=0).max())
    keys = np.round((mesh.vertices - mesh.vertices.min(axis=0)) / max(span * 1e-6, 1e-12)).astype(np.int64)
    _, first, index = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    faces = index.reshape(-1)[mesh.faces]
    a, b, c = faces.T
    faces = faces[(a != b) & (b != c) & (c != a)]
    _, once = np.unique(np.sort(faces, axis=1), axis=0, return_index=True)
    return MeshFile(mesh.vertices[first], faces[np.sort(once)])


def edges_of(faces: Indices) -> Indices:
    """The edges of triangles (m, 3) as sorted pairs of corners (3 m, 2), those of face i at i, i + m and i + 2 m."""
    return np.sort(np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)


def components(mesh: MeshFile) -> list[MeshFile]:
    """The parts whose triangles hang together by edges that just two of them share, in the order of first triangles.

    So two closed boxes that touch along an edge or at a corner are two parts.
    """
    if not len(mesh.faces):
        return []
    labels = _labels(len(mesh.faces), _neighbours(mesh.faces))
    order = np.argsort(labels, kind="stable")
    starts = np.flatnonzero(np.diff(labels[order])) + 1
    return [_part(mesh, chosen) for chosen in np.split(order, starts)]


def _neighbours(faces: Indices) -> Indices:
    """Pairs of triangles (n, 2) that are the only two at an edge."""
    _, edge, counts = np.unique(edges_of(faces), axis=0, return_inverse=True, return_counts=True)
    edge = edge.reshape(-1)
    shared = np.flatnonzero(counts[edge] == 2)
    by_edge = shared[np.argsort(edge[shared], kind="stable")]
    return (by_edge % len(faces)).reshape(-1, 2)


def _labels(count: int, pairs: Indices) -> Indices:
    """For each of `count` nodes the lowest node that it hangs together with."""
    label = np.arange(count)
    while True:
        lowest = label[pairs].min(axis=1)
        hooked = label.copy()
        for node in pairs.T:
            np.minimum.at(hooked, label[node], lowest)
        while not np.array_equal(hooked, hooked[hooked]):
            hooked = hooked[hooked]
        if np.array_equal(hooked, label):
            return label
        label = hooked


def _part(mesh: MeshFile, chosen: Indices) -> MeshFile:
    used, faces = np.unique(mesh.faces[chosen], return_inverse=True)
    return MeshFile(mesh.vertices[used], faces.reshape(-1, 3))
