"""Sites where a hand takes hold, and rooms that fall asleep."""

import mujoco
import numpy as np

from tests.sim_rooms import asset, put, scene, wardrobe
from thinkblox import to_mjmodel
from thinkblox.assets import make_asset
from thinkblox.exporters.grips import grasp_of, handle_of
from thinkblox.exporters.stocktaking import inventory_of


def test_handles_are_the_bars_of_doors_and_drawers() -> None:
    kind = make_asset("wardrobe", seed=0)
    model = to_mjmodel(scene(None, (put(kind, 1.0, 2.0), kind)))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    doors = [model.body(i).name for i in range(1, model.nbody) if model.body_parentid[i] > 0]
    assert doors
    for door in doors:
        place = data.site(f"{door}_handle").xpos
        assert place[0] > 1.0 + kind.size[0] / 2 - 0.06, "in front of the doors"
        away = np.abs(place[:2] - data.body(door).xpos[:2])
        assert away[1] > 0.3, "far from the hinge"


def test_a_door_without_a_bar_is_pulled_at_its_edge() -> None:
    inventory = inventory_of(scene(None, (put(wardrobe(), 1.0, 2.0), wardrobe())))
    first, left, _ = inventory.objects[0].bodies
    assert handle_of(first) is None
    place = handle_of(left)
    assert place is not None
    np.testing.assert_allclose(place[:2], (0.02, -0.498), atol=0.01)


def test_pulling_at_a_handle_opens() -> None:
    for name in ("cabinet", "fridge", "nightstand"):
        kind = make_asset(name, seed=0)
        model = to_mjmodel(scene(None, (put(kind, 1.0, 2.0), kind)))
        data = mujoco.MjData(model)
        for joint in range(1, model.njnt):
            mujoco.mj_resetData(model, data)
            mujoco.mj_forward(model, data)
            door = model.joint(joint).name
            site, body = data.site(f"{door}_handle"), model.body(door).id
            jacobian, turning = np.zeros((3, model.nv)), np.zeros((3, model.nv))
            mujoco.mj_jacSite(model, data, jacobian, turning, site.id)
            assert np.linalg.norm(jacobian[:, model.jnt_dofadr[joint]]) > 0.1, (name, door, body)


def test_small_things_have_a_grasp_across_their_narrow_side() -> None:
    pen = asset("pen", (0.15, 0.02, 0.02), mass=0.02, mount="surface")
    grasp = grasp_of(pen)
    assert grasp is not None
    assert grasp == ((0.0, 0.0, 0.01), (1.0, 0.0, 0.0, 0.0))
    turned = grasp_of(asset("pen", (0.02, 0.15, 0.02), mass=0.02, mount="surface"))
    assert turned is not None
    assert turned[1][3] > 0.7
    assert grasp_of(wardrobe()) is None
    model = to_mjmodel(scene(None, (put(pen, 1.0, 1.0), pen)))
    assert model.site("pen_1_grasp").pos[2] == 0.01


def test_a_room_at_rest_falls_asleep() -> None:
    stand, lamp = make_asset("nightstand", seed=0), make_asset("table_lamp", seed=0)
    room = scene(None, (put(stand, 1.0, 2.0), stand), (put(lamp, 1.0, 2.0, stand.size[2], on="nightstand_1"), lamp))
    model = to_mjmodel(room)
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    mujoco.mj_step(model, data, nstep=500)
    assert (data.tree_asleep >= 0).all()
