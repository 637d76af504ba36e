"""Every measure of a verdict against a closed form or an exact construction, through `World.check`."""

import itertools
import math

import numpy as np
import pytest
import shapely
from manifold3d import Manifold
from numpy.typing import NDArray

from tests.sim_rooms import asset, box, put, scene
from thinkblox.scene.asset import Asset, Shape
from thinkblox.scene.corners import rotation
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.sim.geometry.solid import pose, solid_of
from thinkblox.sim.verdict.world import World
from thinkblox.value import Quat
from thinkblox.verdict import Verdict

Array = NDArray[np.float64]
SIDES = 96
"""Of the polygon that stands for a circle: 0.11 mm are lost of a radius of 0.2 m."""
KINDS = ("box", "cylinder", "hull")
LEVEL: Quat = (1.0, 0.0, 0.0, 0.0)


def check(where: Scene, candidate: Placement, kind: Asset) -> Verdict:
    return World(where).check([candidate], kind, way=False)[0]


def one_shape(name: str, shape: Shape) -> Asset:
    return asset(name, (0.4, 0.4, 0.4), shape)


def random_shape(kind: str, rng: np.random.Generator, *, upright: bool) -> Shape:
    x, y, z = rng.uniform(0.04, 0.4, 3).tolist()
    turned = rng.normal(size=4)
    w, i, j, k = (turned / np.linalg.norm(turned)).tolist()
    quat = LEVEL if upright else (w, i, j, k)
    if kind == "cylinder":
        return Shape(kind="cylinder", size=(x, x, z), position=(0.0, 0.0, 0.2), quat_wxyz=quat)
    if kind == "hull":
        points = rng.uniform(-0.5, 0.5, (int(rng.integers(6, 30)), 3)) * (x, y, z)
        sx, sy, sz = np.ptp(points, axis=0).tolist()
        corners = tuple((a, b, c) for a, b, c in points.tolist())
        return Shape(kind="hull", size=(sx, sy, sz), position=(0.0, 0.0, 0.2), quat_wxyz=quat, points=corners)
    return Shape(kind="box", size=(x, y, z), position=(0.0, 0.0, 0.2), quat_wxyz=quat)


def corners_of(shape: Shape) -> Array:
    half = np.asarray(shape.size) / 2
    if shape.kind == "hull":
        local = np.asarray(shape.points)
    elif shape.kind == "box":
        local = np.array(list(itertools.product((-1.0, 1.0), repeat=3))) * half
    else:
        turns = np.arange(SIDES) * (2 * math.pi / SIDES)
        ring = np.column_stack([np.cos(turns), np.sin(turns)]) * half[:2]
        local = np.vstack([np.column_stack([ring, np.full(SIDES, z)]) for z in (-half[2], half[2])])
    placed: Array = local @ rotation(shape.quat_wxyz).T + np.asarray(shape.position)
    return placed


def in_room(kind: Asset, placement: Placement) -> Array:
    matrix = pose(placement)
    placed: Array = corners_of(kind.links[0].shapes[0]) @ matrix[:, :3].T + matrix[:, 3]
    return placed


def penetration(first: Array, second: Array) -> float:
    """Least translation that parts two convex polyhedra [m]: the distance of the origin to the nearest face of their
    Minkowski difference; below 0 when they are apart."""
    differences = (first[:, None] - second[None]).reshape(-1, 3)
    mesh = Manifold.hull_points(differences).to_mesh64()
    corners, faces = np.asarray(mesh.vert_properties)[:, :3], np.asarray(mesh.tri_verts)
    a, b, c = (corners[faces[:, i]] for i in range(3))
    normals = np.cross(b - a, c - a)
    areas = np.linalg.norm(normals, axis=1)
    real = areas > 1e-12
    return float((np.einsum("ij,ij->i", normals[real], a[real]) / areas[real]).min())


def overlapping_pairs(count: int) -> list[tuple[Asset, Placement, Asset, Placement, float]]:
    """Pairs of shapes at random poses with their exact depth, 2 to 80 mm."""
    rng = np.random.default_rng(7)
    found = []
    for first, second in itertools.islice(itertools.cycle(itertools.product(KINDS, KINDS)), count):
        depth = 0.0
        while not 0.002 < depth < 0.08:
            one = one_shape("one", random_shape(first, rng, upright=bool(rng.random() < 0.3)))
            other = one_shape("other", random_shape(second, rng, upright=bool(rng.random() < 0.3)))
            x, y, z = rng.uniform(-0.25, 0.25, 3).tolist()
            here = put(one, 2.0, 2.0, 1.0, rng.uniform(0.0, 360.0))
            there = put(other, 2.0 + x, 2.0 + y, 1.0 + z, rng.uniform(0.0, 360.0))
            coarse = np.linalg.norm((x, y, z)) < 0.25
            depth = penetration(in_room(one, here), in_room(other, there)) if coarse else 0.0
        found.append((one, here, other, there, depth))
    return found


PAIRS = [
    pytest.param(*pair, id=f"{a}-{b}-{n}")
    for n, (pair, (a, b)) in enumerate(
        zip(overlapping_pairs(72), itertools.cycle(itertools.product(KINDS, KINDS)), strict=False)
    )
]


@pytest.mark.parametrize(("one", "here", "other", "there", "depth"), PAIRS)
def test_depth_within_half_a_millimetre(
    one: Asset, here: Placement, other: Asset, there: Placement, depth: float
) -> None:
    verdict = check(scene(None, (there, other)), here, one)
    assert verdict.depth == pytest.approx(depth, abs=0.0005)


CUBE = tuple((x, y, z) for x in (-0.1, 0.1) for y in (-0.1, 0.1) for z in (-0.1, 0.1))
ALIGNED = (
    Shape(kind="box", size=(0.2, 0.2, 0.2), position=(0.0, 0.0, 0.1)),
    Shape(kind="cylinder", size=(0.2, 0.2, 0.2), position=(0.0, 0.0, 0.1)),
    Shape(kind="hull", size=(0.2, 0.2, 0.2), position=(0.0, 0.0, 0.1), points=CUBE),
)


ON_A_GRID = [
    pytest.param(a, b, id=f"{a.kind}-{b.kind}") for a, b in itertools.combinations_with_replacement(ALIGNED, 2)
]


@pytest.mark.parametrize(("first", "second"), ON_A_GRID)
def test_depth_of_shapes_on_a_grid(first: Shape, second: Shape) -> None:
    """Things are placed at round numbers: beside, over and in each other, with faces and axes in line."""
    steps = (-0.15, -0.125, -0.1, 0.0, 0.025, 0.1)
    one, other = one_shape("one", first), one_shape("other", second)
    there = put(other, 2.0, 2.0, 1.0)
    world, wrong = World(scene(None, (there, other))), []
    for x, y, z in itertools.product(steps, steps, (-0.15, -0.1, 0.0, 0.075)):
        here = put(one, 2.0 + x, 2.0 + y, 1.0 + z)
        depth = penetration(in_room(one, here), in_room(other, there))
        found = world.check([here], one, way=False)[0] if depth > 0.002 else None
        if found is not None and abs(found.depth - depth) > 0.0005:
            wrong.append((x, y, z, depth, found.depth))
    assert not wrong


@pytest.mark.parametrize("shift", [0.005, 0.05, 0.2, 0.39])
@pytest.mark.parametrize("yaw", [0.0, 30.0, 45.0])
def test_overlap_of_boxes_within_a_hundredth(shift: float, yaw: float) -> None:
    crate = asset("crate", (0.5, 0.4, 0.3))
    here, there = put(crate, 2.5 - shift, 2.0, yaw=yaw), put(crate, 2.0, 2.0, 0.1, id="crate_2")
    shared = shapely.intersection(here.footprint, there.footprint).area * 0.2
    verdict = check(scene(None, (there, crate)), here, crate)
    if shared > 1e-4:
        assert verdict.overlap == pytest.approx(shared / 0.06, rel=0.01)


@pytest.mark.parametrize("sunk", [0.01, 0.1, 0.3])
def test_overlap_of_a_cylinder_sunk_into_a_box(sunk: float) -> None:
    drum = one_shape("drum", Shape(kind="cylinder", size=(0.4, 0.4, 0.4), position=(0.0, 0.0, 0.2)))
    block = asset("block", (1.0, 1.0, 0.5))
    verdict = check(scene(None, (put(block, 2.0, 2.0), block)), put(drum, 2.0, 2.0, 0.5 - sunk), drum)
    assert verdict.overlap == pytest.approx(sunk / 0.4, rel=0.01)
    assert verdict.depth == pytest.approx(sunk, abs=0.0005)


@pytest.mark.parametrize("into", [0.02, 0.1, 0.2, 0.3])
def test_overlap_of_a_cylinder_beside_a_box(into: float) -> None:
    """The share of a circle's segment of height h: (r2 acos(1 - h/r) - (r - h) sqrt(2rh - h2)) / (pi r2)."""
    drum = one_shape("drum", Shape(kind="cylinder", size=(0.4, 0.4, 0.4), position=(0.0, 0.0, 0.2)))
    block, r = asset("block", (1.0, 1.0, 0.5)), 0.2
    segment = r * r * math.acos(1 - into / r) - (r - into) * math.sqrt(2 * r * into - into * into)
    verdict = check(scene(None, (put(block, 2.0, 2.0), block)), put(drum, 2.7 - into, 2.0), drum)
    assert verdict.overlap == pytest.approx(segment / (math.pi * r * r), rel=0.01)


@pytest.mark.parametrize("into", [0.05, 0.1, 0.2, 0.35, 0.4])
def test_overlap_of_a_ball_in_a_box(into: float) -> None:
    """The share of a ball's cap of height h: h2 (3r - h) / (4 r3)."""
    ball = one_shape("ball", Shape(kind="sphere", size=(0.4, 0.4, 0.4), position=(0.0, 0.0, 0.2)))
    block = asset("block", (1.0, 1.0, 1.0))
    verdict = check(scene(None, (put(block, 2.0, 2.0), block)), put(ball, 2.7 - into, 2.0, 0.3), ball)
    assert verdict.overlap == pytest.approx(into**2 * (0.6 - into) / (4 * 0.008), rel=0.01)


L_ROOM = Room(floor=((0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)))
DIAMOND = Room(floor=((2.0, 0.0), (4.0, 2.0), (2.0, 4.0), (0.0, 2.0)))
CRATE = asset("crate", (0.5, 0.5, 0.5))
DRUM = asset("drum", (0.5, 0.5, 0.5), Shape(kind="cylinder", size=(0.5, 0.5, 0.5), position=(0.0, 0.0, 0.25)))


@pytest.mark.parametrize(
    ("room", "kind", "x", "y", "z", "yaw", "expected"),
    [
        (rectangle(4.0, 5.0), CRATE, 0.2, 0.1, 0.0, 0.0, math.hypot(0.05, 0.15)),
        (rectangle(4.0, 5.0), CRATE, 3.9, 2.5, 0.0, 45.0, math.hypot(0.25, 0.25) - 0.1),
        (rectangle(4.0, 5.0), CRATE, 1.0, 2.0, 0.0, 30.0, 0.25 * (math.cos(math.pi / 6) + 0.5) - 1.0),
        (rectangle(4.0, 5.0), DRUM, 0.2, 2.0, 0.0, 17.0, 0.05),
        (rectangle(4.0, 5.0), CRATE, 0.2, 2.0, 2.22, 0.0, math.hypot(0.05, 0.12)),
        (L_ROOM, CRATE, 1.85, 1.85, 0.0, 45.0, 0.25 - 0.15 * 2**0.5),
        (L_ROOM, DRUM, 1.9, 1.95, 0.0, 0.0, 0.25 - math.hypot(0.1, 0.05)),
        (L_ROOM, DRUM, 1.2, 1.4, 0.0, 0.0, 0.25 - 1.0),
        (DIAMOND, CRATE, 1.0, 1.0, 0.0, 45.0, 0.25),
        (DIAMOND, CRATE, 2.0, 2.0, 0.0, 0.0, 0.5 / 2**0.5 - 2**0.5),
    ],
)
def test_boundary_within_a_micrometre(
    room: Room, kind: Asset, x: float, y: float, z: float, yaw: float, expected: float
) -> None:
    if room is L_ROOM and (x, y) == (1.2, 1.4):
        expected = 0.25 - min(math.hypot(0.8, 0.6), 1.2)
    assert check(scene(room), put(kind, x, y, z, yaw), kind).boundary == pytest.approx(expected, abs=1e-6)


def ridge(height: float = 0.5) -> Asset:
    """A block that carries on a ridge 1 cm wide."""
    return asset(
        "ridge", (0.3, 0.5, height), box((0.3, 0.5, height - 0.02), (0.0, 0.0, (height - 0.02) / 2)),
        box((0.01, 0.5, 0.02), (0.0, 0.0, height - 0.01)), mass=20.0,
    )  # fmt: skip


@pytest.mark.parametrize(("left", "right"), [(0.5, 0.5), (0.3, 0.6), (0.2, 0.65), (0.1, 0.6)])
def test_shares_of_a_plank_on_two_ridges(left: float, right: float) -> None:
    """The lever: each bears in proportion to the other's distance from the middle."""
    plank = asset("plank", (1.5, 0.2, 0.04), mass=8.0, mount="surface")
    ridges = [(put(ridge(), 3.0 + x, 2.0, id=id), ridge()) for id, x in (("left_1", -left), ("right_1", right))]
    verdict = check(scene(rectangle(6.0, 4.0), *ridges), put(plank, 3.0, 2.0, 0.5, on="left_1"), plank)
    assert verdict.valid, str(verdict)
    shares = {s.by: s.share for s in verdict.supports}
    assert shares == pytest.approx({"left_1": right / (left + right), "right_1": left / (left + right)}, abs=0.02)


@pytest.mark.parametrize("load", [(0.0, 0.0), (0.1, 0.0), (-0.1, 0.1), (0.05, -0.15)])
def test_shares_of_a_table_on_three_legs_with_a_load(load: tuple[float, float]) -> None:
    """Each leg bears the barycentric coordinate of the centre of mass."""
    feet = [(0.4, 0.0), (-0.3, 0.35), (-0.3, -0.35)]
    top = box((1.0, 0.9, 0.02), (0.0, 0.0, 0.41))
    legs = [box((0.02, 0.02, 0.4), (x, y, 0.2)) for x, y in feet]
    weight = box((0.3, 0.3, 0.3), (*load, 0.57))
    table = asset("table", (1.0, 0.9, 0.72), top, *legs, weight, mass=30.0)
    middle = np.average([(0.0, 0.0), *feet, load], axis=0, weights=solid_of(table).masses[0])
    stands: list[tuple[Placement, Asset]] = []
    for number, (x, y) in enumerate(feet):
        stand = asset("stand", (0.2, 0.2, 0.3), mass=20.0)
        stands.append((put(stand, 2.0 + x, 2.0 + y, id=f"stand_{number}"), stand))
    verdict = check(scene(None, *stands), put(table, 2.0, 2.0, 0.3, on="stand_0"), table)
    assert verdict.valid, str(verdict)
    system = np.vstack([np.array(feet).T, np.ones(3)])
    expected = np.linalg.solve(system, [*middle, 1.0])
    shares = {s.by: s.share for s in verdict.supports}
    assert shares == pytest.approx({f"stand_{i}": float(share) for i, share in enumerate(expected)}, abs=0.02)


def test_shares_of_a_box_on_two_boxes() -> None:
    crates = [(put(CRATE, 2.0, 2.0 + y, id=f"crate_{i}"), CRATE) for i, y in enumerate((-0.3, 0.3))]
    chest = asset("chest", (0.4, 1.0, 0.4), mass=20.0, mount="surface")
    verdict = check(scene(None, *crates), put(chest, 2.0, 2.0, 0.5, on="crate_0"), chest)
    assert {s.by: s.share for s in verdict.supports} == pytest.approx({"crate_0": 0.5, "crate_1": 0.5}, abs=0.02)


def test_shares_between_a_floor_and_a_step() -> None:
    """A bench with one leg on the floor and one on a thin step, its middle nearer to the step."""
    bench = asset(
        "bench", (1.2, 0.4, 0.5), box((1.2, 0.4, 0.05), (0.0, 0.0, 0.475)), box((0.02, 0.4, 0.45), (-0.5, 0.0, 0.225)),
        box((0.02, 0.4, 0.44), (0.3, 0.0, 0.23)), mass=12.0,
    )  # fmt: skip
    step = asset("step", (0.3, 0.6, 0.01), mass=5.0)
    verdict = check(scene(None, (put(step, 2.3, 2.0), step)), put(bench, 2.0, 2.0), bench)
    volumes, middles = (0.024, 0.0036, 0.00352), (0.0, -0.5, 0.3)
    x = np.average(middles, weights=volumes)
    assert verdict.valid, str(verdict)
    shares = {s.by: s.share for s in verdict.supports}
    assert shares == pytest.approx({"floor": (0.3 - x) / 0.8, "step_1": (x + 0.5) / 0.8}, abs=0.02)


def test_where_it_falls_from_is_how_far_it_drops() -> None:
    for height in (0.02, 0.05, 0.09):
        verdict = check(scene(), put(CRATE, 2.0, 2.0, height), CRATE)
        assert verdict.drop == pytest.approx(height, abs=0.001)
