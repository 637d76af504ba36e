"""Shapes as triangles: closed, of the right volume, facing outwards, wherever they are put."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from thinkblox.scene.asset import Asset, Link, Shape
from thinkblox.sim.render.soup import Soup, quat_matrix
from thinkblox.sim.render.tessellate import Mesh, edge_radius, rounded_box, tessellate
from thinkblox.value import Vec3

CUBE = tuple(itertools.product((-0.1, 0.3), (-0.2, 0.2), (0.0, 0.5)))


def shape(kind: str, size: Vec3, **options: object) -> Shape:
    return Shape(kind=kind, size=size, position=(0.0, 0.0, 0.0), **options)  # type: ignore[arg-type]


CASES = [
    (shape("box", (0.4, 0.6, 0.3)), 0.072, 0.01),
    (shape("box", (1.0, 0.5, 0.004)), 0.002, 0.01),
    (shape("cylinder", (0.4, 0.4, 0.7)), math.pi * 0.04 * 0.7, 0.02),
    (shape("cylinder", (0.4, 0.2, 0.7)), math.pi * 0.02 * 0.7, 0.02),
    (shape("sphere", (0.5, 0.5, 0.5)), math.pi / 6 * 0.125, 0.03),
    (shape("ellipsoid", (0.5, 0.2, 0.8)), math.pi / 6 * 0.08, 0.03),
    (shape("capsule", (0.2, 0.2, 0.8)), math.pi * 0.01 * 0.6 + math.pi / 6 * 0.008, 0.03),
    (shape("hull", (0.4, 0.4, 0.5), points=CUBE), 0.08, 1e-5),
    (shape("hull", (0.4, 0.4, 0.5), points=CUBE, smooth=True), 0.08, 1e-5),
]


def volume(mesh: Mesh) -> float:
    a, b, c = (mesh.vertices[mesh.faces[:, k]].astype(np.float64) for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def corners(mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Faces by corners that are told apart by place only."""
    grid = np.round(mesh.vertices.astype(np.float64), 5)
    _, index = np.unique(grid, axis=0, return_inverse=True)
    return grid, index.ravel()[mesh.faces]


@pytest.mark.parametrize(("solid", "expected", "tolerance"), CASES)
def test_volume_is_that_of_the_shape(solid: Shape, expected: float, tolerance: float) -> None:
    assert volume(tessellate(solid)) == pytest.approx(expected, rel=tolerance)


@pytest.mark.parametrize(("solid", "_", "__"), CASES)
def test_mesh_is_closed(solid: Shape, _: float, __: float) -> None:
    faces = corners(tessellate(solid))[1]
    real = faces[(faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])]
    edges = np.concatenate([real[:, [0, 1]], real[:, [1, 2]], real[:, [2, 0]]])
    forward = sorted(map(tuple, edges.tolist()))
    assert forward == sorted(map(tuple, edges[:, ::-1].tolist()))
    assert len(set(forward)) == len(forward)


@pytest.mark.parametrize(("solid", "_", "__"), CASES)
def test_extents_are_those_of_the_shape(solid: Shape, _: float, __: float) -> None:
    mesh = tessellate(solid)
    assert np.ptp(mesh.vertices, axis=0) == pytest.approx(solid.size, abs=2e-3)


@pytest.mark.parametrize(("solid", "_", "__"), CASES)
def test_normals_point_outwards_and_have_unit_length(solid: Shape, _: float, __: float) -> None:
    mesh = tessellate(solid)
    a, b, c = (mesh.vertices[mesh.faces[:, k]].astype(np.float64) for k in range(3))
    flat = np.cross(b - a, c - a)
    solid_faces = np.linalg.norm(flat, axis=1) > 1e-12
    for k in range(3):
        normals = mesh.normals[mesh.faces[:, k]]
        assert (np.einsum("ij,ij->i", normals, flat)[solid_faces] > 0).all()
    assert np.linalg.norm(mesh.normals, axis=1) == pytest.approx(1.0, abs=1e-5)


def test_smooth_hulls_share_normals_where_faces_meet_gently() -> None:
    ring = tuple(
        (0.2 * math.cos(t), 0.2 * math.sin(t), z)
        for t in np.linspace(0, 2 * math.pi, 16, endpoint=False)
        for z in (0, 0.3)
    )
    mesh = tessellate(shape("hull", (0.4, 0.4, 0.3), points=ring, smooth=True))
    radial = mesh.vertices[:, :2] / 0.2
    sides = np.abs(mesh.normals[:, 2]) < 0.5
    assert np.abs(mesh.normals[sides, :2] - radial[sides]).max() < 0.02
    assert np.abs(mesh.normals[~sides, 2]).min() > 0.999


def test_cushions_are_rounder_than_boards() -> None:
    size = (0.5, 0.5, 0.15)
    assert edge_radius(size, soft=True) > 5 * edge_radius(size, soft=False)
    assert volume(rounded_box(size, edge_radius(size, soft=True))) > 0.9 * 0.5 * 0.5 * 0.15


quats = (
    st.tuples(*[st.floats(-1, 1, allow_nan=False)] * 4)
    .filter(lambda q: sum(c * c for c in q) > 0.01)
    .map(lambda q: tuple(c / math.hypot(*q) for c in q))
)
places = st.tuples(*[st.floats(-5, 5, allow_nan=False)] * 3)


@settings(max_examples=40, deadline=None)
@given(quats, places, quats, places)
def test_a_pose_keeps_volume_and_moves_the_centre(
    quat: tuple[float, float, float, float], at: Vec3, own: tuple[float, float, float, float], inner: Vec3
) -> None:
    part = Shape(kind="box", size=(0.4, 0.6, 0.3), position=inner, quat_wxyz=own)
    asset = Asset(
        id="x-1", category="x", description="", size=(1, 1, 1), mass=1, friction=1, mount="floor",
        links=(Link(name="body", shapes=(part,)),),
    )  # fmt: skip
    soup = Soup()
    soup.add_asset(asset, (at, quat), 3)
    triangles = soup.triangles()
    centre = quat_matrix(quat) @ np.array(inner) + np.array(at)
    moved = Mesh(triangles.vertices - centre.astype(np.float32), triangles.normals, triangles.faces)
    assert volume(moved) == pytest.approx(0.072, rel=0.01)
    assert (triangles.vertices.min(0) + triangles.vertices.max(0)) / 2 == pytest.approx(centre, abs=1e-3)
    assert triangles.patches[0].owner == 3
