"""What collides: hulls that every engine takes whole, and weights that are where they are in real things."""

from pathlib import Path

import mujoco
import numpy as np
import pytest
from manifold3d import Manifold
from pxr import Usd, UsdPhysics

from tests.sim_rooms import put, scene
from thinkblox.assets import CATALOGUE, make_asset
from thinkblox.exporters.mjcf import write_mjcf
from thinkblox.exporters.stocktaking import inventory_of
from thinkblox.exporters.usd import write_usd
from thinkblox.scene.asset import Asset, Shape
from thinkblox.sim.geometry.collider import MOST_CORNERS, collider
from thinkblox.sim.geometry.materials import STUFF, usual_weight
from thinkblox.sim.geometry.solid import shape_area, shape_points, shape_volume, solid_of, weighing
from thinkblox.value import Vec3


def ball(count: int, size: Vec3 = (1.0, 1.0, 1.0)) -> Shape:
    """A hull of `count` corners on an ellipsoid, cut off flat at its foot."""
    height = 1 - (2 * np.arange(count) + 1) / count
    angle, ring = np.arange(count) * np.pi * (3 - np.sqrt(5)), np.sqrt(1 - height**2)
    points = np.column_stack([ring * np.cos(angle), ring * np.sin(angle), np.maximum(height, -0.8)]) * size
    corners = tuple((float(x), float(y), float(z)) for x, y, z in points)
    x, y, z = np.ptp(points, axis=0).tolist()
    return Shape(kind="hull", size=(x, y, z), position=(0.0, 0.0, 0.0), points=corners)


def corners_left(shape: Shape) -> int:
    return int(Manifold.hull_points(np.asarray(shape.points)).num_vert())


def share(asset: Asset, *materials: str) -> float:
    """The share of an asset's mass in parts of some materials."""
    shapes = [shape for link in asset.links for shape in weighing(link)]
    masses = [mass for link in solid_of(asset).masses for mass in link]
    return sum(m for shape, m in zip(shapes, masses, strict=True) if shape.material in materials) / sum(masses)


@pytest.mark.parametrize("count", [20, 64, 65, 300, 3000])
@pytest.mark.parametrize("size", [(0.03, 0.03, 0.03), (0.5, 0.3, 0.05), (3.0, 2.0, 1.0)])
def test_hulls_have_at_most_64_corners_and_stay_as_large(count: int, size: Vec3) -> None:
    shape = ball(count, size)
    found = collider(shape)
    before, after = np.asarray(shape.points), np.asarray(found.points)
    assert len(after) <= MOST_CORNERS
    assert found is shape or count > MOST_CORNERS
    assert set(found.points) <= set(shape.points)
    np.testing.assert_array_equal(np.ptp(after, axis=0), np.ptp(before, axis=0))
    assert shape_volume(found) > 0.85 * shape_volume(shape)


def test_flat_sides_stay_flat_and_wide() -> None:
    shape = ball(2000)
    low = [np.asarray(s.points)[np.asarray(s.points)[:, 2] < -0.79, :2] for s in (shape, collider(shape))]
    assert [np.ptp(side, axis=0).min() > 1.1 for side in low] == [True, True]
    assert 10 <= len(low[1]) < len(low[0])


def test_what_cannot_be_touched_keeps_its_corners() -> None:
    shape = Shape(kind="hull", size=(2.0, 2.0, 1.8), position=(0.0, 0.0, 0.0), points=ball(300).points, collide=False)
    assert collider(shape) is shape


@pytest.mark.slow
def test_every_thing_of_the_catalogue_collides_with_few_corners() -> None:
    for name in CATALOGUE:
        for link in make_asset(name, seed=1).links:
            for shape in link.shapes:
                if shape.kind == "hull" and shape.collide:
                    found = collider(shape)
                    assert corners_left(found) <= MOST_CORNERS
                    before, after = (np.ptp(np.asarray(s.points), axis=0) for s in (shape, found))
                    np.testing.assert_allclose(after, before, atol=1e-6)


@pytest.mark.parametrize("name", ["ball", "pillow", "globe", "orange"])
def test_solids_are_those_that_collide(name: str) -> None:
    kind = make_asset(name, seed=0)
    hulls = [s for link in kind.links for s in link.shapes if s.kind == "hull" and s.collide]
    assert all(corners_left(collider(shape)) <= MOST_CORNERS for shape in hulls)
    low, high = solid_of(kind).low, solid_of(kind).high
    np.testing.assert_allclose(high - low, kind.size, atol=2e-3)


def test_shades_and_leaves_are_light_and_feet_are_not() -> None:
    lamp = make_asset("table_lamp", seed=0)
    assert share(lamp, "light") < 0.15
    assert share(make_asset("floor_lamp", seed=0), "light") < 0.3
    assert share(make_asset("potted_plant", seed=0), "leaf") < 0.2
    bed = make_asset("bed", seed=0)
    legs = [
        mass
        for shape, mass in zip(weighing(bed.links[0]), solid_of(bed).masses[0], strict=True)
        if shape.material == "wood" and shape.size[2] < 0.2
    ]
    assert legs
    assert all(0.05 < mass < 1.0 for mass in legs)
    assert sum(map(sum, solid_of(bed).masses)) == pytest.approx(bed.mass)


def test_weights_of_walls_and_fillings() -> None:
    cube = Shape(kind="box", size=(0.1, 0.1, 0.1), position=(0.0, 0.0, 0.0))
    assert (shape_volume(cube), shape_area(cube)) == pytest.approx((1e-3, 0.06))
    assert usual_weight("glass", 1e-3, 0.06) == pytest.approx(0.06 * 0.004 * 2500)
    assert usual_weight("wood", 1e-3, 0.06) == pytest.approx(0.65)
    assert usual_weight("metal", 1e-6, 0.06) == pytest.approx(7.8e-3)
    assert all(stuff.skin > 0 and stuff.density > stuff.filling for stuff in STUFF.values())


@pytest.mark.parametrize("kind", ["box", "cylinder", "capsule", "sphere", "ellipsoid"])
def test_surfaces_of_round_shapes(kind: str) -> None:
    size = (0.2, 0.2, 0.2) if kind == "sphere" else (0.2, 0.2, 0.5)
    shape = Shape(kind=kind, size=size, position=(0.0, 0.0, 0.0))  # type: ignore[arg-type]
    drawn = Manifold.hull_points(shape_points(shape)).surface_area()
    assert shape_area(shape) == pytest.approx(drawn, rel=0.03)


def test_every_hull_that_an_export_lets_collide_has_few_corners(tmp_path: Path) -> None:
    kinds = [make_asset(name, seed=0) for name in ("ball", "pillow", "potted_plant", "office_chair")]
    room = scene(None, *((put(kind, 0.8 + 0.8 * i, 2.0), kind) for i, kind in enumerate(kinds)))
    inventory = inventory_of(room)
    write_mjcf(inventory, tmp_path / "scene.xml")
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "scene.xml"))
    solid = {int(mesh) for mesh, on in zip(model.geom_dataid, model.geom_contype, strict=True) if on and mesh >= 0}
    assert max(int(model.mesh_vertnum[mesh]) for mesh in solid) <= MOST_CORNERS
    assert max(model.mesh_vertnum) > MOST_CORNERS, "what is seen keeps its corners"
    write_usd(inventory, tmp_path / "scene.usda")
    stage = Usd.Stage.Open(str(tmp_path / "scene.usda"))
    hulls = [prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.MeshCollisionAPI)]
    assert hulls
    assert max(len(prim.GetAttribute("points").Get()) for prim in hulls) <= MOST_CORNERS
