"""What a committed action changes, and what it leaves to the last bit."""

from tests.sim_rooms import asset, put, scene, table, vase
from thinkblox.committing import commit
from thinkblox.judging import Proposal
from thinkblox.scene.actions import Replace
from thinkblox.sim.verdict.world import World

LOW_VASE = asset("low_vase", (0.1, 0.1, 0.2), mass=1.0, mount="surface")
HIGH = 0.7502


def test_what_stands_beside_what_is_exchanged_stays_to_the_last_bit() -> None:
    box = asset("box", (0.1, 0.1, 0.1), mass=0.5, mount="surface")
    before = scene(
        None,
        (put(table(), 2.0, 2.0), table()),
        (put(vase(), 2.0, 2.0, 0.75, on="table_1"), vase()),
        (put(box, 2.115, 2.0, HIGH, on="table_1"), box),
    )
    world, proposal = World(before), Proposal("", Replace(id="vase_1", asset=LOW_VASE), None, LOW_VASE)
    verdict = world.measure(proposal.action)
    beside = next(rider for rider in verdict.riders if rider.id == "box_1")
    assert verdict.valid
    assert beside.settled_pose is not None
    assert beside.settled_pose.position[2] < HIGH
    grown, placements = commit(world, proposal, verdict)
    assert [p.id for p in placements] == ["vase_1"]
    assert grown.scene["box_1"] == before["box_1"]


def test_what_rests_on_what_is_exchanged_stands_where_it_comes_to_rest() -> None:
    lower = table(height=0.748)
    before = scene(None, (put(table(), 2.0, 2.0), table()), (put(vase(), 2.0, 2.0, 0.75, on="table_1"), vase()))
    world, proposal = World(before), Proposal("", Replace(id="table_1", asset=lower), None, lower)
    grown, placements = commit(world, proposal, world.measure(proposal.action))
    assert {p.id for p in placements} >= {"table_1"}
    assert grown.scene["vase_1"].position[2] == 0.748
