import math

import mujoco
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.suite_subjects import subject
from thinkblox.sim.foreign.triangles import (
    CHORD,
    Triangles,
    collision_model,
    first_hits,
    geom_triangles,
    sides,
    triangles_of,
)
from thinkblox.sim.subject import Subject, thing_of

radius = st.floats(0.01, 1.0)


def meshed(world: str) -> Triangles:
    made = subject(world)
    return triangles_of(made.model, made.data(), made.things[0])


def body(geom: str, pose: str = "") -> str:
    return f'<body name="a" {pose}>{geom}</body>'


def volume(mesh: Triangles) -> float:
    a, b, c = (mesh.corners[:, k] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def closed(mesh: Triangles) -> bool:
    """Whether every edge is passed once in each direction."""
    edges = np.vstack([mesh.faces[:, [0, 1]], mesh.faces[:, [1, 2]], mesh.faces[:, [2, 0]]])
    keys = {tuple(edge) for edge in edges.tolist()}
    return len(keys) == len(edges) and all((b, a) in keys for a, b in keys)


def test_a_box_is_twelve_triangles_of_its_volume_and_surface() -> None:
    mesh = meshed(body('<geom type="box" size="0.1 0.2 0.3"/>', 'pos="1 2 3" euler="10 20 30"'))
    assert closed(mesh)
    assert volume(mesh) == pytest.approx(8 * 0.1 * 0.2 * 0.3)
    assert mesh.areas.sum() == pytest.approx(8 * (0.1 * 0.2 + 0.1 * 0.3 + 0.2 * 0.3))
    assert mesh.centroid == pytest.approx([1.0, 2.0, 3.0])


@settings(max_examples=30, deadline=None)
@given(radius, radius)
def test_a_cylinder_lies_within_a_millimetre_of_its_circle(r: float, half: float) -> None:
    mesh = meshed(body(f'<geom type="cylinder" size="{r} {half}"/>'))
    assert closed(mesh)
    n = sides(r)
    assert volume(mesh) == pytest.approx(n / 2 * r * r * math.sin(2 * math.pi / n) * 2 * half)
    assert r * (1 - math.cos(math.pi / n)) <= CHORD * 1.0001


@pytest.mark.slow
@settings(max_examples=30, deadline=None)
@given(radius, radius, radius)
def test_an_ellipsoid_is_closed_and_nearly_its_volume(a: float, b: float, c: float) -> None:
    mesh = meshed(body(f'<geom type="ellipsoid" size="{a} {b} {c}"/>'))
    exact = 4 / 3 * math.pi * a * b * c
    assert closed(mesh)
    assert exact * (1 - 3 * CHORD / min(a, b, c)) <= volume(mesh) <= exact


def test_no_triangle_of_a_sphere_is_more_than_a_millimetre_inside_it() -> None:
    mesh = meshed(body('<geom size="0.5"/>'))
    assert np.linalg.norm(mesh.corners.mean(axis=1), axis=1).min() >= 0.5 - CHORD
    assert np.linalg.norm(mesh.vertices, axis=1) == pytest.approx(np.full(len(mesh.vertices), 0.5))


def test_a_capsule_is_a_cylinder_and_a_ball() -> None:
    mesh = meshed(body('<geom type="capsule" size="0.2 0.3"/>'))
    assert closed(mesh)
    assert volume(mesh) == pytest.approx(math.pi * 0.04 * 0.6 + 4 / 3 * math.pi * 0.008, rel=0.01)
    assert mesh.bounds[1][2] == pytest.approx(0.5)


HOLLOW = "0 0 0  1 0 0  1 1 0  0 1 0  0 0 1  1 0 1  1 1 1  0 1 1  0.5 0.5 0.5"
"""A cube with a dent in its top."""
DENTED = "0 3 2  0 2 1  0 1 5  0 5 4  1 2 6  1 6 5  2 3 7  2 7 6  3 0 4  3 4 7  4 5 8  5 6 8  6 7 8  7 4 8"


def dented(kind: str = "mesh") -> Subject:
    text = (
        f'<mujoco><asset><mesh name="m" vertex="{HOLLOW}" face="{DENTED}"/></asset>'
        f'<worldbody><body name="a"><geom type="{kind}" mesh="m"/></body></worldbody></mujoco>'
    )
    model = mujoco.MjModel.from_xml_string(text)
    return Subject(model=model, start=np.array(model.qpos0), things=(thing_of(model, 1),))


def test_a_mesh_is_its_convex_hull_as_the_engine_collides_with_it() -> None:
    made = dented()
    mesh = triangles_of(made.model, made.data(), made.things[0])
    assert volume(mesh) == pytest.approx(1.0, rel=1e-5)
    assert closed(mesh)


def test_planes_and_what_does_not_collide_are_left_out() -> None:
    assert meshed(body('<geom type="box" size="1 1 1" contype="0" conaffinity="0"/>')).empty
    made = subject('<geom name="floor" type="plane" size="0 0 1"/>' + body('<geom size="0.1"/>'))
    data = made.data()
    assert geom_triangles(made.model, data, [0]).empty
    assert geom_triangles(made.model, data, [0], plane=5.0).areas.sum() == pytest.approx(100.0)


def test_the_parts_of_a_thing_are_where_its_joints_are() -> None:
    made = subject(
        '<body name="a"><geom type="box" size="0.1 0.1 0.1"/><body name="b" pos="1 0 0">'
        '<joint type="slide" axis="0 1 0"/><geom type="box" size="0.1 0.1 0.1"/></body></body>'
    )
    made.start[0] = 0.5
    mesh = triangles_of(made.model, made.data(), made.things[0])
    assert len(mesh.faces) == 24
    assert mesh.bounds[1] == pytest.approx([1.1, 0.6, 0.1])


def test_samples_are_spread_by_area() -> None:
    mesh = meshed(body('<geom type="box" size="0.5 0.5 0.05"/>'))
    points = mesh.sample(20_000, np.random.default_rng(0))
    top = np.mean(np.abs(points[:, 2] - 0.05) < 1e-9)
    assert top == pytest.approx(1.0 / 2.4, abs=0.02)
    assert np.all(np.abs(points) <= [0.5 + 1e-9, 0.5 + 1e-9, 0.05 + 1e-9])


def test_rays_meet_the_first_triangle() -> None:
    mesh = meshed(body('<geom type="box" size="0.5 0.5 0.05"/>', 'pos="100 0 0"'))
    origins = np.array([[100.0, 0.0, 1.05], [100.0, 0.2, 0.06], [102.0, 0.0, 1.0]])
    distances = first_hits(mesh, origins, np.array([0.0, 0.0, -1.0]))
    assert distances[:2] == pytest.approx([1.0, 0.01], abs=1e-6)
    assert math.isinf(distances[2])
    assert math.isinf(first_hits(Triangles(np.zeros((0, 3)), np.zeros((0, 3), np.int32)), origins, origins[0])[0])


def test_the_fcl_model_is_of_all_triangles() -> None:
    mesh = meshed(body('<geom type="box" size="0.5 0.5 0.05"/>'))
    assert collision_model(mesh).num_tries_() == 12
