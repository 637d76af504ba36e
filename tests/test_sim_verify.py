from pathlib import Path

import mujoco
import numpy as np
import pytest
from msgspec import structs

from tests.sim_rooms import asset, put, scene, table, vase, wardrobe
from thinkblox.scene.asset import Shape
from thinkblox.scene.room import Opening, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.sim.build import build_spec
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.settle import settle
from thinkblox.sim.verdict.verify import verify
from thinkblox.sim.verdict.world import World
from thinkblox.value import to_json

CRATE = asset("crate", (0.5, 0.5, 0.5))
PICTURE = asset("picture", (0.03, 0.6, 0.4), mount="wall", mass=2.0)


def furnished() -> Scene:
    return scene(
        rectangle(4.0, 5.0, openings=(Opening(id="door_1", kind="door", wall=0, offset=0.2, width=0.9, height=2.0),)),
        (put(table(), 2.0, 2.0), table()),
        (put(vase(), 2.2, 2.0, 0.751, on="table_1"), vase()),
        (put(wardrobe(), 0.301, 4.0), wardrobe()),
        (put(PICTURE, 2.0, 4.985, 1.4, yaw=270.0, on="north_wall"), PICTURE),
    )


def test_a_good_scene_is_valid_as_a_whole() -> None:
    report = verify(furnished())
    assert report.valid, [str(v) for v in report.objects]
    assert report.depth < 0.001
    assert report.drift < 0.001
    assert report.tilt < 0.1
    assert report.simulated >= 5.0
    assert report.walker is not None
    assert report.walker.reach == 1.0
    assert report.versions["mujoco"] == mujoco.__version__


@pytest.mark.parametrize(
    ("x", "y", "z"),
    [(2.0, 2.0, 0.75), (2.61, 2.0, 0.75), (2.0, 2.0, 0.74), (2.0, 2.0, 1.5), (0.02, 2.0, 0.0), (3.0, 3.0, 0.0)],
)
def test_verify_agrees_with_check(x: float, y: float, z: float) -> None:
    before = furnished().without("vase_1")
    candidate = put(vase(), x, y, z, on="table_1")
    checked = World(before).check([candidate], vase())[0]
    verified = verify(before.with_placement(candidate, vase()))
    of_vase = next(v for v in verified.objects if v.id == "vase_1")
    assert (of_vase.valid, of_vase.reasons) == (checked.valid, checked.reasons)
    assert (of_vase.depth, of_vase.outside) == (checked.depth, checked.outside)
    assert [s.by for s in of_vase.supports] == [s.by for s in checked.supports]
    assert of_vase.tilt == pytest.approx(checked.tilt, rel=0.05, abs=0.01)


def test_a_fall_that_is_not_followed_to_its_end_is_told_as_the_least() -> None:
    """What is lost is given up; what comes to rest is measured."""
    high, low = (World(furnished()).check([put(CRATE, 3.0, 2.0, z)], CRATE)[0] for z in (1.5, 0.05))
    assert high.rest is None
    assert f"fell at least {high.drop * 1000:.1f} mm" in str(high)
    assert low.rest is not None
    assert f"fell {low.drop * 1000:.1f} mm" in str(low)


def test_one_bad_object_does_not_spoil_the_others() -> None:
    bad = furnished().with_placement(put(CRATE, 2.4, 2.3), CRATE)
    by_id = {v.id: v for v in verify(bad).objects}
    assert by_id["crate_1"].reasons == ("collision",)
    assert by_id["table_1"].reasons == ("collision",)
    assert by_id["wardrobe_1"].valid
    assert by_id["picture_1"].valid


def test_two_fixed_things_in_one_place_are_found() -> None:
    twice = furnished().with_placement(
        put(PICTURE, 2.1, 4.985, 1.5, yaw=270.0, on="north_wall", id="picture_2"), PICTURE
    )
    assert [v.reasons for v in verify(twice).objects][-1] == ("collision",)


def test_the_doors_of_a_wardrobe_stay_shut() -> None:
    room = furnished()
    model = build_spec(room).compile()
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=1250)
    for side in ("left", "right"):
        assert abs(np.degrees(data.joint(f"wardrobe_1/door_{side}").qpos[0])) < 0.5


def test_settle_names_every_moving_body() -> None:
    state = settle(furnished())
    assert state.rested
    assert set(state.poses) == {"table_1", "vase_1", "wardrobe_1", "wardrobe_1/door_left", "wardrobe_1/door_right"}
    assert state.poses["vase_1"][0] == pytest.approx((2.2, 2.0, 0.75), abs=2e-4)


def test_a_simulation_that_fails_is_a_verdict_and_no_log(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    violent = Physics(gravity=(0.0, 0.0, -1e12))
    verdict = World(scene(), physics=violent).check([put(CRATE, 2.0, 2.0, 0.01)], CRATE)[0]
    assert verdict.reasons == ("unstable",)
    report = verify(scene(None, (put(CRATE, 2.0, 2.0, 0.01), CRATE)), physics=violent)
    assert not report.valid
    assert to_json(report)
    assert list(tmp_path.iterdir()) == []
    assert capfd.readouterr().err == ""


def test_an_empty_room_is_valid() -> None:
    report = verify(scene())
    assert report.valid
    assert report.objects == ()


def test_unreachable_objects_are_reported_and_blamed() -> None:
    narrow = rectangle(
        2.0, 6.0, openings=(Opening(id="door_1", kind="door", wall=0, offset=0.5, width=0.9, height=2.0),)
    )
    bed = asset("bed", (1.9, 0.9, 0.5), mass=50.0)
    barrier = asset("sideboard", (0.4, 1.8, 0.8), mass=35.0)
    room = scene(narrow, (put(bed, 0.5, 5.0, yaw=270.0), bed), (put(barrier, 1.0, 3.0, yaw=90.0), barrier))
    report = verify(room)
    assert report.walker is not None
    assert report.walker.unreachable == ("bed_1",)
    assert {v.id: v.reasons for v in report.objects} == {"bed_1": ("blocks_way",), "sideboard_1": ("blocks_way",)}
    without_blame = verify(room, way=False)
    assert without_blame.valid
    assert without_blame.notes == ("There is no way 0.5 m wide from the door to bed_1.",)


def test_the_same_scene_gives_the_same_report_and_state() -> None:
    room = furnished()
    assert verify(room) == verify(structs.replace(room))
    assert settle(room) == settle(structs.replace(room))


def test_what_is_known_of_a_scene_at_rest_is_of_that_scene_and_its_physics_alone() -> None:
    room = furnished()
    before = settle(room)
    lifted = structs.replace(room["vase_1"], position=(2.2, 2.0, 0.7501))
    moved = structs.replace(room, placements=tuple(lifted if p.id == "vase_1" else p for p in room.placements))
    assert settle(moved).poses["vase_1"] != before.poses["vase_1"]
    assert settle(room, physics=Physics(gravity=(0.0, 0.0, -1.0))) != before
    assert settle(room, physics=Physics()) is before


def test_a_cylinder_upright_to_the_last_digit_is_not_thrown_up() -> None:
    """A lamp on a disc whose tilt is 1e-15: MuJoCo 3.17's plane-cylinder contact is 12 mm deep there."""
    disc = Shape(kind="cylinder", size=(0.12, 0.12, 0.006), position=(0.0, 0.0, 0.003))
    pole = Shape(kind="cylinder", size=(0.02, 0.02, 0.4), position=(0.0, 0.0, 0.206))
    lamp = asset("lamp", (0.12, 0.12, 0.406), disc, pole, mass=2.0)
    model = build_spec(scene(None, (put(lamp, 1.62004401541329, 4.0), lamp))).compile()
    data = mujoco.MjData(model)
    data.qpos[3:7] = (8.9894744178818861e-02, 5.0408028705924324e-16, 1.7053427700885192e-16, 9.9595127138280448e-01)
    data.qpos[2] = -2.3302452546253785e-05
    mujoco.mj_forward(model, data)
    assert -data.contact.dist.min() < 1e-4
