import mujoco
import numpy as np
import pytest
from shapely import Point

from tests.sim_rooms import asset, put, scene, table, wardrobe
from thinkblox.scene.asset import Shape
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec
from thinkblox.sim.geometry.walls import wall_slabs

POINTS = ((0.0, 0.0, 0.0), (0.3, 0.0, 0.0), (0.0, 0.3, 0.0), (0.0, 0.0, 0.3))


def every_kind() -> Scene:
    shapes = [
        Shape(kind="box", size=(0.2, 0.2, 0.2), position=(0.0, 0.0, 0.1)),
        Shape(kind="cylinder", size=(0.2, 0.2, 0.2), position=(0.0, 0.0, 0.3)),
        Shape(kind="capsule", size=(0.2, 0.2, 0.4), position=(0.0, 0.0, 0.6)),
        Shape(kind="sphere", size=(0.2, 0.2, 0.2), position=(0.0, 0.0, 0.9)),
        Shape(kind="ellipsoid", size=(0.2, 0.1, 0.2), position=(0.0, 0.0, 1.1)),
        Shape(kind="hull", size=(0.3, 0.3, 0.3), position=(0.0, 0.0, 1.2), points=POINTS, smooth=True),
        Shape(kind="hull", size=(0.3, 0.3, 0.3), position=(0.2, 0.0, 1.2), points=POINTS, smooth=True),
        Shape(kind="box", size=(0.3, 0.3, 0.01), position=(0.0, 0.0, 1.5), collide=False),
    ]
    totem = asset("totem", (0.5, 0.5, 1.6), *shapes, mass=7.0)
    return scene(None, (put(totem, 1.234567, 2.0, yaw=33.0), totem))


def test_mass_is_the_assets_and_spread_by_what_parts_are_of() -> None:
    model = build_spec(every_kind()).compile()
    assert model.body("totem_1").subtreemass[0] == pytest.approx(7.0)
    blocks = [
        Shape(kind="box", size=(0.03, 0.3, 0.3), position=(0.0, 0.0, 0.15)),
        Shape(kind="box", size=(0.03, 0.6, 0.3), position=(0.0, 0.0, 0.45)),
        Shape(kind="box", size=(0.002, 0.3, 0.3), position=(0.0, 0.0, 0.75), material="metal"),
    ]
    sign = asset("sign", (0.03, 0.6, 0.9), *blocks, mass=5.0)
    board, wide, plate = build_spec(scene(None, (put(sign, 2.0, 2.0), sign))).body("sign_1").geoms
    assert wide.mass == pytest.approx(2 * board.mass)
    assert plate.mass / board.mass == pytest.approx(0.002 * 7800 / (0.03 * 650), rel=0.2)
    assert board.mass + wide.mass + plate.mass == pytest.approx(5.0)


def test_equal_hulls_share_one_mesh() -> None:
    assert build_spec(every_kind()).compile().nmesh == 1


def test_names_of_bodies_and_joints() -> None:
    room = scene(None, (put(wardrobe(), 0.301, 4.0), wardrobe()), (put(table(), 2.0, 2.0), table()))
    model = build_spec(room).compile()
    assert [model.body(i).name for i in range(1, model.nbody)] == [
        "wardrobe_1", "wardrobe_1/door_left", "wardrobe_1/door_right", "table_1",
    ]  # fmt: skip
    assert [model.joint(i).name for i in range(model.njnt)] == [
        "wardrobe_1_free", "wardrobe_1/door_left", "wardrobe_1/door_right", "table_1_free",
    ]  # fmt: skip
    assert np.degrees(model.joint("wardrobe_1/door_left").range[1]) == pytest.approx(110.0)
    assert model.nexclude == 3


def test_doors_open_outwards() -> None:
    room = scene(None, (put(wardrobe(), 1.0, 2.0), wardrobe()))
    model = build_spec(room).compile()
    data = mujoco.MjData(model)
    for side in ("left", "right"):
        data.joint(f"wardrobe_1/door_{side}").qpos[0] = np.radians(90.0)
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    assert data.body("wardrobe_1/door_left").xipos[0] > 1.4
    assert data.body("wardrobe_1/door_right").xipos[0] > 1.4


def test_fixed_things_have_no_joint_and_rugs_no_mass_to_fall() -> None:
    picture = asset("picture", (0.03, 0.6, 0.4), mount="wall", mass=2.0)
    model = build_spec(scene(None, (put(picture, 2.0, 4.985, 1.4, on="north_wall"), picture))).compile()
    assert model.njnt == 0


def test_walls_leave_openings_open() -> None:
    door = Opening(id="door_1", kind="door", wall=0, offset=1.0, width=0.9, height=2.0)
    window = Opening(id="window_1", kind="window", wall=0, offset=2.5, width=1.0, height=1.2, sill=0.9)
    slabs = [s for s in wall_slabs(rectangle(4.0, 5.0, openings=(door, window)), 0.1) if s.name.startswith("south")]
    solid = sum(s.size[0] * s.size[2] for s in slabs)
    assert solid == pytest.approx(4.0 * 2.6 - 0.9 * 2.0 - 1.0 * 1.2)
    assert all(s.position[1] == pytest.approx(-0.05) for s in slabs)


def test_walls_stay_out_of_the_floor_of_any_shape() -> None:
    notched = Room(
        floor=((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.05, 3.0), (2.05, 1.0), (2.0, 1.0), (2.0, 3.0), (0.0, 3.0))
    )
    model = build_spec(scene(notched)).compile()
    for geom in range(1, model.ngeom):
        x, y = model.geom_pos[geom][:2]
        assert not notched.polygon.buffer(-1e-6).contains(Point(x, y))
    assert all(s.size[1] <= 0.1 for s in wall_slabs(notched, 0.1))
