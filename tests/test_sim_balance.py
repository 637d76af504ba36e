"""What is believed at once is what a second of simulation says."""

import mujoco
import pytest
from hypothesis import HealthCheck, assume, given, settings

from tests.sim_rooms import asset, put, scene, table, vase
from tests.test_sim_cut import calm, nothing_is_flung
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.scene import Scene
from thinkblox.sim.verdict import stage
from thinkblox.sim.verdict.balance import at_rest
from thinkblox.sim.verdict.world import World

CRATE = asset("crate", (0.4, 0.4, 0.4), mass=8.0)


def test_what_stands_squarely_rests_within_a_tenth_of_a_second() -> None:
    verdict = World(scene()).check([put(CRATE, 2.0, 2.0)], CRATE)[0]
    assert verdict.valid
    assert verdict.rest is not None
    assert verdict.rest < 0.1


def test_a_stack_is_believed_when_each_thing_in_it_stands_squarely() -> None:
    room = scene(None, (put(table(), 2.0, 2.0), table()))
    middle = World(room).check([put(vase(), 2.0, 2.0, 0.75, on="table_1")], vase())[0]
    assert middle.rest is not None
    assert middle.rest < 0.2


def test_a_drawer_on_a_wall_that_moves_is_not_at_rest() -> None:
    """A tree of one joint, where a free body has six."""
    model = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><body><joint type="slide"/><geom size=".1"/></body></worldbody></mujoco>'
    )
    data = mujoco.MjData(model)
    assert at_rest(model, data, 1)
    data.qvel[0] = 1.0
    assert not at_rest(model, data, 1)


@pytest.mark.parametrize("over", [-0.004, 0.004])
def test_near_an_edge_nothing_is_believed(over: float) -> None:
    """Within millimetres of falling over the edge a settle is run for long enough to see it begin."""
    room = scene(None, (put(table(), 2.0, 2.0), table()))
    verdict = World(room).check([put(vase(), 2.6 + over, 2.0, 0.75, on="table_1")], vase())[0]
    assert verdict.valid == (over < 0)
    assert verdict.rest is None or verdict.rest > 0.04 or verdict.tilt < 0.01


@settings(max_examples=8, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(calm())
def test_any_room_gives_the_same_reasons_without_it(case: tuple[Scene, Placement, Asset]) -> None:
    same_without_it(*case)


@pytest.mark.slow
@settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(calm())
def test_hundreds_of_rooms_give_the_same_reasons_without_it(case: tuple[Scene, Placement, Asset]) -> None:
    same_without_it(*case)


def same_without_it(room: Scene, placement: Placement, kind: Asset) -> None:
    assume(nothing_is_flung(room))
    quick = World(room).check([placement], kind)[0]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(stage, "unsteady", lambda model, data, suspect: suspect)
        slow = World(room).check([placement], kind)[0]
    assert quick.reasons == slow.reasons, f"{quick}\n{slow}"
