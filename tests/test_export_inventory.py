"""The inventory that every writer reads, held against the model that was measured."""

import mujoco
import numpy as np
import pytest

from tests.export_rooms import L_ROOM, sample_scene
from tests.textured import crate_scene
from thinkblox.exporters.inventory import Inventory, InventoryBody
from thinkblox.exporters.stocktaking import inventory_of
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import GEOM_TYPES, build_spec
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.settle import settle


@pytest.fixture(scope="module")
def inventory() -> Inventory:
    return inventory_of(sample_scene())


@pytest.fixture(scope="module")
def model() -> mujoco.MjModel:
    return build_spec(sample_scene()).compile()


def bodies(inventory: Inventory) -> list[InventoryBody]:
    return [body for item in inventory.objects for body in item.bodies]


def origin(body: InventoryBody) -> np.ndarray:
    """Where the frame of a body begins in the frame that was measured."""
    return np.zeros(3) if body.joint is None else np.array(body.joint.anchor)


def test_objects_and_bodies_are_those_of_the_model(inventory: Inventory, model: mujoco.MjModel) -> None:
    assert [item.id for item in inventory.objects] == [p.id for p in sample_scene().placements]
    names = [model.body(i).name for i in range(1, model.nbody)]
    assert [body.source for body in bodies(inventory)] == names
    assert [body.name for body in bodies(inventory)] == [name.replace("/", "_") for name in names]
    assert [item.free for item in inventory.objects] == [True, True, True, True, False, False, False]
    for item in inventory.objects:
        assert [body.parent for body in item.bodies] == [None] + [item.id] * (len(item.bodies) - 1)
        assert [body.joint is None for body in item.bodies] == [True] + [False] * (len(item.bodies) - 1)


def test_masses_and_inertias_are_those_of_the_model(inventory: Inventory, model: mujoco.MjModel) -> None:
    for body in bodies(inventory):
        number = model.body(body.source).id
        assert body.mass == model.body_mass[number]
        np.testing.assert_allclose(np.add(body.centre, origin(body)), model.body_ipos[number], atol=1e-12)
        np.testing.assert_array_equal(body.inertia, model.body_inertia[number])
        np.testing.assert_array_equal(body.axes, model.body_iquat[number])
        assert sum(geom.mass for geom in body.geoms) == pytest.approx(body.mass)


def test_geoms_are_those_of_the_model(inventory: Inventory, model: mujoco.MjModel) -> None:
    for body in bodies(inventory):
        numbers = np.flatnonzero(model.geom_bodyid == model.body(body.source).id)
        there = [geom for geom in body.geoms if geom.collides or geom.mass]
        assert len(there) == len(numbers)
        for geom, number in zip(there, numbers, strict=True):
            assert geom.shape is not None
            assert int(GEOM_TYPES[geom.shape.kind]) == model.geom_type[number]
            if geom.collides:
                np.testing.assert_array_equal(geom.friction, model.geom_friction[number])
                assert model.geom_contype[number] == 1
            if geom.shape.kind != "hull":
                np.testing.assert_allclose(
                    np.add(geom.shape.position, origin(body)), model.geom_pos[number], atol=1e-12
                )


def test_poses_are_the_proposed_and_the_settled_ones(inventory: Inventory, model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    data.qpos[:] = settle(sample_scene()).qpos
    mujoco.mj_kinematics(model, data)
    for placement, item in zip(sample_scene().placements, inventory.objects, strict=True):
        np.testing.assert_allclose(item.bodies[0].proposed[0], placement.position, atol=1e-12)
        position, quat_wxyz = item.bodies[0].in_object
        assert position == (0.0, 0.0, 0.0)
        assert quat_wxyz[0] == pytest.approx(1.0)
    for body in bodies(inventory):
        position, quat_wxyz = body.settled
        found = data.body(body.source)
        np.testing.assert_allclose(position, found.xpos + found.xmat.reshape(3, 3) @ origin(body), atol=1e-12)
        np.testing.assert_allclose(quat_wxyz, found.xquat, atol=1e-12)
    assert inventory.state.qpos == tuple(data.qpos)


def test_joints_have_the_limits_and_the_friction_of_the_model(inventory: Inventory, model: mujoco.MjModel) -> None:
    joints = [(body.source, body.joint) for body in bodies(inventory) if body.joint is not None]
    assert len(joints) == 4
    for name, joint in joints:
        found = model.joint(name)
        limits = np.radians([joint.lower, joint.upper]) if joint.kind == "hinge" else [joint.lower, joint.upper]
        np.testing.assert_allclose(found.range, limits, atol=1e-12)
        np.testing.assert_allclose(found.axis, joint.axis, atol=1e-12)
        np.testing.assert_allclose(found.pos, joint.anchor, atol=1e-12)
        assert (found.frictionloss[0], found.damping[0]) == (joint.friction, joint.damping)
        assert joint.friction > 0.0 < joint.damping


def test_floor_and_walls(inventory: Inventory, model: mujoco.MjModel) -> None:
    assert [wall.name for wall in inventory.walls] == ["floor", *(wall.name for wall in L_ROOM.walls)]
    assert [wall.label for wall in inventory.walls] == ["floor"] + ["wall"] * 6
    boxes = [geom for wall in inventory.walls for geom in wall.geoms]
    assert len(boxes) == model.body_geomnum[0]
    floor = inventory.walls[0].geoms[0].shape
    assert floor is not None
    assert floor.size == pytest.approx((6.2, 5.2, Physics().floor_thickness))


def test_every_look_is_listed(inventory: Inventory) -> None:
    used = {geom.look for body in bodies(inventory) for geom in body.geoms} | {wall.look for wall in inventory.walls}
    assert used == set(inventory.looks)
    glass = next(look for name, look in inventory.looks.items() if name.startswith("glass"))
    assert glass.opacity < 1.0
    assert all(0.0 <= look.roughness <= 1.0 and name.isidentifier() for name, look in inventory.looks.items())


def test_what_a_part_is_called_has_no_number(inventory: Inventory) -> None:
    labels = {body.source: body.label for body in bodies(inventory)}
    assert labels["wardrobe_1"] == "wardrobe"
    assert labels["cupboard_1/flap"] == "flap"
    assert labels["wardrobe_1/door_left"] == "door left"


def test_meshes_are_seen_and_shapes_under_them_are_not() -> None:
    body, lid = inventory_of(crate_scene()).objects[0].bodies
    assert [(geom.collides, geom.look is None, geom.mesh is None) for geom in body.geoms] == [
        (True, True, True), (False, True, True), (False, False, False),
    ]  # fmt: skip
    assert [geom.mass > 0.0 for geom in body.geoms] == [True, False, False]
    assert lid.geoms[-1].mesh is not None


def test_an_empty_room_has_an_inventory() -> None:
    inventory = inventory_of(Scene(room=L_ROOM))
    assert inventory.objects == ()
    assert set(inventory.looks) == {wall.look for wall in inventory.walls}


def test_items_of_wikidata_are_of_categories_that_exist() -> None:
    from thinkblox.assets import CATALOGUE
    from thinkblox.exporters.wikidata import _items

    items = _items()
    assert not set(items) - set(CATALOGUE) - {"door", "window"}
    assert all(item[0] == "Q" and item[1:].isdigit() for item in items.values())
