"""Verdicts on actions: what rides along and what is left is measured too; what is settled is at rest."""

import pytest
from msgspec import structs

from tests.sim_rooms import asset, box, put, scene, table, vase
from thinkblox.errors import InputError
from thinkblox.scene import Shape, rectangle
from thinkblox.scene.actions import Add, Move, Remove, Replace, Swap, Turn
from thinkblox.scene.scene import Scene
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.world import World

TABLE, VASE = table(), vase()
CRATE = asset("crate", (0.4, 0.4, 0.4), mass=8.0)


@pytest.fixture(scope="module")
def room() -> Scene:
    return scene(
        rectangle(5.0, 4.0), (put(TABLE, 1.5, 1.5), TABLE), (put(VASE, 1.5, 1.5, 0.75), VASE),
        (put(CRATE, 3.5, 3.0), CRATE),
    )  # fmt: skip


def test_what_stands_on_a_moved_table_is_measured_with_it(room: Scene) -> None:
    verdict = World(room).measure(Move(id="table_1", position=(3.0, 1.5, 0.0), yaw=90.0))
    assert verdict.valid
    assert [rider.id for rider in verdict.riders] == ["vase_1"]
    assert [support.by for support in verdict.riders[0].supports] == ["table_1"]


def test_a_rider_that_hits_something_fails_the_move(room: Scene) -> None:
    tall = scene(
        rectangle(5.0, 4.0), (put(TABLE, 1.5, 1.5), TABLE), (put(VASE, 1.95, 1.5, 0.75), VASE),
        (put(CRATE, 3.5, 3.0, 0.8), CRATE),
    )  # fmt: skip
    verdict = World(tall).measure(Move(id="table_1", position=(3.0, 3.0, 0.0)))
    assert verdict.reasons == ("riders",)
    assert verdict.riders[0].reasons == ("collision",)
    assert "vase_1" in str(verdict)
    assert "crate_1" in str(verdict)


def test_removing_a_table_from_under_its_vase_is_not_valid(room: Scene) -> None:
    verdict = World(room).measure(Remove(id="table_1"))
    assert verdict.reasons == ("riders",)
    assert "drop" in verdict.riders[0].reasons
    assert World(room).measure(Remove(id="crate_1")).valid


def test_a_table_taken_from_under_its_vase_by_hand_is_found_out(room: Scene) -> None:
    apart = room.moved("table_1", position=(3.4, 1.5, 0.0))
    assert "drop" in World(apart).check([apart["vase_1"]], VASE)[0].reasons


def test_a_candidate_of_a_carrier_takes_its_riders_along(room: Scene) -> None:
    there = structs.replace(room["table_1"], position=(3.0, 1.5, 0.0))
    (verdict,) = World(room).check([there], TABLE)
    assert verdict == World(room).measure(Move(id="table_1", position=(3.0, 1.5, 0.0), yaw=0.0))
    lower = table(height=0.5, name="bench")
    (replaced,) = World(room).check([structs.replace(room["table_1"], asset=lower.id, size=lower.size)], lower)
    assert replaced == World(room).measure(Replace(id="table_1", asset=lower, position=(1.5, 1.5, 0.0), yaw=0.0))


def test_a_swap_measures_both(room: Scene) -> None:
    verdict = World(room).measure(Swap(id="table_1", other="crate_1"))
    assert verdict.valid
    assert [rider.id for rider in verdict.riders] == ["crate_1", "vase_1"]
    low = World(room).measure(Swap(id="vase_1", other="crate_1"))
    assert low.id == "vase_1"
    assert low.valid


def test_adding_and_turning_are_measured_like_any_candidate(room: Scene) -> None:
    world = World(room)
    added = world.measure(Add(id="crate_2", asset=CRATE, position=(3.5, 3.0, 0.4), yaw=0.0))
    assert [support.by for support in added.supports] == ["crate_1"]
    assert world.measure(Turn(id="crate_1", yaw=45.0)).valid


def test_what_is_put_down_from_a_little_above_settles_and_says_where(room: Scene) -> None:
    (verdict,) = World(room).check([put(CRATE, 3.0, 2.0, 0.002, 30.0, id="crate_2")], CRATE)
    assert verdict.valid
    assert verdict.settled_pose is not None
    assert verdict.settled_pose.position == pytest.approx((3.0, 2.0, 0.0), abs=2e-4)
    assert verdict.settled_pose.yaw == pytest.approx(30.0, abs=0.01)


def test_a_pole_that_topples_slowly_is_never_valid() -> None:
    """Its middle is 3 mm past the edge of its foot: after a second it has hardly moved."""
    foot, mast = box((0.1, 0.1, 0.05), (0.0, 0.0, 0.025)), box((0.06, 0.06, 1.95), (0.053, 0.0, 1.025))
    pole = asset("pole", (0.18, 0.1, 2.0), structs.replace(foot, collide=True), mast, mass=10.0)
    empty = scene(rectangle(6.0, 6.0))
    (verdict,) = World(empty).check([put(pole, 3.0, 3.0)], pole)
    assert not verdict.valid
    assert verdict.settled_pose is None
    (early,) = World(empty, physics=Physics(settle_time=0.3)).check([put(pole, 3.0, 3.0)], pole)
    assert early.reasons == ("restless",)
    assert "rest" in str(early)


def test_what_rolls_on_for_ever_is_restless() -> None:
    ball = asset(
        "ball", (0.2, 0.2, 0.2), Shape(kind="sphere", size=(0.2, 0.2, 0.2), position=(0.0, 0.0, 0.1)), mass=0.5
    )
    (verdict,) = World(scene(rectangle(6.0, 6.0))).check([put(ball, 3.0, 3.0)], ball)
    assert verdict.valid or "restless" in verdict.reasons


def test_what_stands_on_two_is_measured_when_one_of_them_goes() -> None:
    """A tray across the gap of two stools rests on neither by its middle, and on both in fact."""
    stool, tray = asset("stool", (0.4, 0.4, 0.5), mass=5.0), asset("tray", (0.3, 0.6, 0.02), mass=1.0, mount="surface")
    room = scene(
        rectangle(4.0, 4.0), (put(stool, 2.0, 1.75, id="stool_1"), stool), (put(stool, 2.0, 2.25, id="stool_2"), stool),
        (put(tray, 2.0, 2.0, 0.5), tray),
    )  # fmt: skip
    assert room["tray_1"].support == "floor"
    world = World(room)
    assert world.check([room["tray_1"]], tray)[0].valid
    assert world.measure(Remove(id="stool_2")).reasons == ("riders",)
    away = structs.replace(room["stool_2"], position=(3.5, 3.5, 0.0))
    assert world.check([away], stool)[0].reasons == ("riders",)


def test_an_action_that_changes_nothing_has_the_verdict_of_what_stands(room: Scene) -> None:
    there = room["table_1"]
    (standing,) = World(room).check([there], TABLE)
    assert World(room).measure(Move(id="table_1", position=there.position)) == standing
    assert World(room).measure(Turn(id="table_1", yaw=360.0)) == standing
    assert World(room).measure(Replace(id="table_1", asset=TABLE)) == standing


def test_requirements_are_functions() -> None:
    class Callable:
        def __call__(self, scene, placement):
            return "no"

    room = scene(rectangle(4.0, 4.0))
    (verdict,) = World(room, requirements=[Callable()]).check([put(CRATE, 2.0, 2.0, id="crate_1")], CRATE)
    assert verdict.reasons == ("requirement",)
    assert "Callable: no" in str(verdict)
    for wrong in (lambda s, p: "", [3], 7):
        with pytest.raises(InputError, match="function"):
            World(room, requirements=wrong)  # type: ignore[arg-type]
