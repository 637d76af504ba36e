"""At rest is what stays: things that walk, tremble, rock or sway, against 5 s of the whole room in plain MuJoCo.

Each verdict here was once false.
"""

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.bench.adversary_truth import simulated, truth
from tests.sim_rooms import asset, box, put, scene, table
from tests.whole_room import whole_room
from thinkblox.assets import make_asset
from thinkblox.scene.asset import Asset, Shape
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import rectangle
from thinkblox.scene.scene import Scene
from thinkblox.sim.verdict.stillness import Quiet, stayed
from thinkblox.sim.verdict.world import World
from thinkblox.value import Vec3
from thinkblox.verdict import Verdict

INTERVAL = 0.04


def judged(room: Scene, place: Placement, kind: Asset) -> tuple[Verdict, float]:
    """The verdict, and what the simulation says as a share of what is tolerated."""
    return World(room).check([place], kind, way=False)[0], truth(room, simulated(room), place, kind).share


def disc(name: str, wide: float, high: float, *, mass: float, friction: float) -> Asset:
    shape = Shape(kind="cylinder", size=(wide, wide, high), position=(0.0, 0.0, high / 2))
    return asset(name, (wide, wide, high), shape, mass=mass, friction=friction)


def test_a_bust_whose_contacts_jump_walks_on_a_slab() -> None:
    """At rest at most looks, it jumps by 0.03 mm and 0.03 degrees every 60 ms, always the same way round."""
    slab = asset("slab", (0.1888, 0.1364, 0.0108), mass=73.43, friction=0.573)
    foot, mast = (
        box((0.0512, 0.3882, 0.0365), (-0.0073, 0.0, 0.01825)),
        box((0.0394,) * 2 + (0.1094,), (0.0132, -0.0947, 0.0911)),
    )
    bust = asset("bust", (0.0658, 0.3882, 0.1458), foot, mast, mass=4.705, friction=0.969)
    room = scene(None, (put(slab, 2.0, 2.0), slab))
    verdict, share = judged(room, put(bust, 2.0024, 2.0109, 0.0108, 79.3), bust)
    assert share > 1.0
    assert "tilt" in verdict.reasons


def test_a_block_near_the_edge_of_a_table_walks_round() -> None:
    top, body = box((0.8492, 0.8492, 0.03), (0.0, 0.0, 0.9034)), box((0.6134, 0.6134, 0.8884), (0.0, 0.0, 0.4442))
    desk = asset("desk", (0.8492, 0.8492, 0.9184), top, body, mass=5.598)
    foot, mast = (
        box((0.0379, 0.1254, 0.027), (0.0029, 0.0, 0.0135)),
        box((0.0201, 0.0201, 0.081), (-0.0118, 0.0492, 0.0675)),
    )
    bust = asset("bust", (0.0437, 0.1254, 0.108), foot, mast, mass=1.502, friction=0.247)
    room = scene(None, (put(desk, 2.0, 2.0), desk))
    verdict, share = judged(room, put(bust, 1.5874, 1.9665, 0.9184, 215.9), bust)
    assert share > 1.0
    assert "tilt" in verdict.reasons


def test_what_hops_is_still_between_two_hops() -> None:
    """A heavy block on three slabs, each of which lies on less than itself: after 1.4 s they hop on for 2 s more."""
    first = asset("slab0", (0.1063998, 0.2273136, 0.0081568), mass=13.477149, friction=0.5680058)
    second = asset("slab1", (0.2920978, 0.1194879, 0.0623097), mass=1.5621619, friction=0.6397147)
    third = asset("slab2", (0.3701738, 0.1114093, 0.0155345), mass=0.8242795, friction=0.5085650)
    foot = box((0.1354567, 0.0523832, 0.05), (0.0, 0.0, 0.025))
    mast = box((0.0121359, 0.0121359, 0.1921701), (0.0315155, -0.0060065, 0.1460851))
    bust = asset("bust", (0.1354567, 0.0523832, 0.2421701), foot, mast, mass=0.2003114, friction=0.9137924)
    places = (put(first, 2.0, 2.0, 0.0077363, 14.3705532), put(second, 2.0003192, 1.9910081, 0.0187413, 38.8662214))
    room = scene(
        None, (places[0], first), (places[1], second), (put(third, 1.9967634, 2.0001631, 0.081576, 37.2256375), third)
    )
    verdict, share = judged(room, put(bust, 1.9896463, 2.0077671, 0.0971105, 308.2726867), bust)
    assert share > 1.0
    assert not verdict.valid


def test_what_hops_from_the_beginning_is_not_still_when_it_is_slow_once() -> None:
    """160 kg across a narrow block: it hops by 0.1 mm, and turns by 16 degrees a minute."""
    narrow = asset("narrow", (0.36761, 0.08736, 0.39696), mass=200.0, friction=0.7911696)
    foot = box((0.3672338, 0.0501208, 0.05), (0.0158937, 0.0, 0.025))
    mast = box((0.0293467, 0.0293467, 0.2175524), (-0.1848372, -0.0052311, 0.1587762))
    bust = asset("bust", (0.3990211, 0.0501208, 0.2675524), foot, mast, mass=159.3674278, friction=0.2867535)
    room = scene(None, (put(narrow, 2.0, 2.0), narrow))
    verdict, share = judged(room, put(bust, 1.9903714, 1.9900123, 0.39696, 295.3356075), bust)
    assert share > 1.0
    assert not verdict.valid


def test_what_rocks_is_not_read_where_it_turns_round() -> None:
    """A heavy pole rocks on a light slab; for an instant it lies still on one side, and presses the slab in less."""
    slab = asset("slab", (0.201, 0.2772, 0.0133), mass=0.24, friction=0.263)
    foot, mast = box((0.1988, 0.1329, 0.05), (0.0, 0.0, 0.025)), box((0.065, 0.065, 0.95), (-0.0621, -0.0153, 0.525))
    pole = asset("pole", (0.1988, 0.1329, 1.0), foot, mast, mass=22.823, friction=0.49)
    room = scene(None, (put(slab, 2.0, 2.0), slab))
    verdict, share = judged(room, put(pole, 2.0002, 2.0007, 0.0169, 358.4), pole)
    assert share > 1.0
    assert verdict.reasons == ("collision",)
    assert [collision.other for collision in verdict.collisions] == ["slab_1"]


def test_what_sleepers_do_to_it_is_looked_at_again_awake() -> None:
    """The stack sinks together under the box; things that stand in the air until they are touched tilt it by more."""
    first = asset("first", (0.3298, 0.0942, 0.072), mass=29.46, friction=0.96)
    second = asset("second", (0.1416, 0.3866, 0.0427), mass=0.069, friction=0.441)
    third = disc("third", 0.1534, 0.0661, mass=0.553, friction=0.998)
    room = scene(
        None,
        (put(first, 2.0, 2.0, 0.0021, 8.3), first),
        (put(second, 1.9481, 1.9812, 0.0779, 53.3), second),
        (put(third, 1.9512, 2.0052, 0.1257, 35.8), third),
    )
    crate = asset("crate", (0.1238, 0.2284, 0.1219), mass=0.113, friction=0.696)
    verdict, share = judged(room, put(crate, 1.9258, 1.9491, 0.1915, 332.4), crate)
    assert share < 1.0
    assert verdict.valid, str(verdict)


def test_a_bowl_on_a_toy_stays_on_it() -> None:
    desk, toy, bowl = make_asset("desk", seed=0), make_asset("toy", seed=0), make_asset("bowl", seed=0)
    room = scene(
        None,
        (put(desk, 2.0, 2.0, 0.0, 17.9, id="desk_1"), desk),
        (put(toy, 1.7006, 2.0571, desk.size[2], 147.8, id="toy_1"), toy),
    )
    verdict, share = judged(room, put(bowl, 1.701, 2.0338, room["toy_1"].top, 353.9), bowl)
    assert share < 1.0
    assert verdict.valid, str(verdict)


def test_what_rocks_by_nineteen_degrees_may_come_back() -> None:
    drum = disc("drum", 0.08062, 0.03016, mass=13.461, friction=0.672)
    shape = box((0.05293, 0.05241, 0.06403), (0.0, 0.0, 0.03202))
    block = asset("block", (0.05293, 0.05241, 0.06403), shape, mass=2.955, friction=0.805)
    room = scene(None, (put(drum, 2.0, 2.0, 0.0, 81.1), drum))
    verdict, share = judged(room, put(block, 1.96964, 1.98413, 0.03576, 13.3), block)
    assert share < 1.0
    assert verdict.valid, str(verdict)


def test_a_tall_stand_that_sways_out_comes_to_rest() -> None:
    leg: Vec3 = (0.01, 0.01, 1.5686)
    places = ((-0.0136, -0.0036), (0.0099, -0.01), (0.0037, 0.0136))
    head = box((0.0633, 0.0745, 0.1743), (0.0, 0.0, 1.6558))
    stand = asset(
        "stand", (0.0633, 0.0745, 1.7429), head, *(box(leg, (x, y, 0.7843)) for x, y in places),
        mass=11.857, friction=0.98,
    )  # fmt: skip
    foot, mast = (
        box((0.0324, 0.1601, 0.0272), (0.0072, 0.0, 0.0136)),
        box((0.0233, 0.0233, 0.0816), (-0.0118, -0.0498, 0.068)),
    )
    bust = asset("bust", (0.0469, 0.1601, 0.1088), foot, mast, mass=6.158, friction=0.513)
    room = scene(None, (put(stand, 2.0, 2.0), stand))
    verdict, share = judged(room, put(bust, 2.0145, 1.9999, 1.7429, 170.7), bust)
    assert share < 1.0
    assert verdict.valid, str(verdict)


def test_what_never_rests_without_it_is_not_left_moving_by_it() -> None:
    """A desk stands in the wall, and never comes to rest; the ball under it has no part in that."""
    desk, ball = (
        table(),
        asset("ball", (0.2, 0.2, 0.2), Shape(kind="sphere", size=(0.2,) * 3, position=(0.0, 0.0, 0.1))),
    )
    crate = asset("crate", (0.4, 0.4, 0.4), mass=8.0)
    room = scene(rectangle(3.0, 3.0), (put(crate, 1.0, 2.0), crate), (put(desk, 0.5, 1.0), desk))
    place = put(ball, 1.0, 1.0)
    whole = whole_room(room).check([place], ball, way=False)[0]
    assert whole.valid, str(whole)
    assert whole.reasons == World(room).check([place], ball, way=False)[0].reasons


def looks(motion: NDArray[np.float64]) -> Quiet:
    """Two seconds of looks at one body that moves so along x [m]."""
    quiet = Quiet(INTERVAL)
    for x in motion:
        quiet.look(np.array([[x, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]]))
    return quiet


SECONDS = np.arange(0.0, 2.0 + INTERVAL / 2, INTERVAL)


@pytest.mark.parametrize(
    ("motion", "rests"),
    [
        (0.0 * SECONDS, True),
        (0.0005 * SECONDS, True),
        (0.0008 * SECONDS, False),
        (0.0001 * np.exp(1.2 * SECONDS), False),
        (0.0008 * np.exp(-0.7 * SECONDS) * np.cos(2 * np.pi * SECONDS / 1.3), True),
        (0.0008 * np.cos(2 * np.pi * SECONDS / 1.3), False),
        (0.0004 * np.cos(2 * np.pi * SECONDS / 0.07), True),
    ],
    ids=["still", "creeps", "walks", "topples", "sways out", "sways on", "trembles"],
)
def test_at_rest_is_what_goes_nowhere(motion: NDArray[np.float64], rests: bool) -> None:
    assert looks(motion).lasted.tolist() == [rests]


def test_less_than_a_second_shows_no_rest() -> None:
    assert looks(np.zeros(20)).lasted.tolist() == [False]


@pytest.mark.parametrize(
    ("shift", "turn", "still"), [(1.9e-5, 0.0, True), (2.1e-5, 0.0, False), (0.0, 4e-5, True), (0.0, 6e-5, False)]
)
def test_a_jump_between_two_looks_is_seen(shift: float, turn: float, still: bool) -> None:
    before = np.array([[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]])
    now = np.array([[shift, 0.0, 0.0, np.cos(turn / 2), 0.0, 0.0, np.sin(turn / 2)]])
    assert stayed(before, now, INTERVAL) == still
