import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import thinkblox
from tests.sim_rooms import asset, box, put, scene, table, vase
from thinkblox.errors import InputError
from thinkblox.mending import mend
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.sim.verdict.world import World
from thinkblox.verdict import MendingMove, Verdict

CRATE = asset("crate", (0.5, 0.5, 0.5))
HEAVY = asset("safe", (0.6, 0.6, 0.8), mass=80.0)
PICTURE = asset("picture", (0.03, 0.6, 0.4), mount="wall", mass=2.0)
L_ROOM = Room(floor=((0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)))
DOOR = Opening(id="door_1", kind="door", wall=0, offset=1.0, width=0.9, height=2.05)


def verdicts(where: Scene) -> dict[str, Verdict]:
    world = World(where)
    return {p.id: world.check([p], where.asset_of(p))[0] for p in where.placements}


def failing(where: Scene) -> set[str]:
    return {id for id, verdict in verdicts(where).items() if not verdict.valid}


def shifted(where: Scene, id: str, *by: float) -> Scene:
    x, y, z = (round(a + b, 6) for a, b in zip(where[id].position, by, strict=True))
    return where.moved(id, position=(x, y, z))


def only_move(where: Scene, *, furthest: float = 0.3) -> MendingMove:
    """The one move that mends a scene whole."""
    mended, moves = mend(where, furthest=furthest)
    assert not failing(mended), [str(v) for v in verdicts(mended).values()]
    assert len(moves) == 1, moves
    move = moves[0]
    assert move.mended
    assert move.turn == 0.0
    assert move.distance == pytest.approx(math.hypot(*move.by), abs=1e-6)
    assert mended[move.id].position == pytest.approx(np.add(where[move.id].position, move.by), abs=2e-6)
    assert all(mended[p.id] == p for p in where.placements if p.id != move.id)
    return move


def mm(move: MendingMove) -> list[float]:
    return [1000 * c for c in move.by]


@pytest.fixture(scope="module")
def office() -> Scene:
    prompt = "A small office with a desk, a chair, a lamp on the desk, a bookcase with three books and two pictures"
    made = thinkblox.generate_room(prompt, seed=3).scene
    assert not failing(made)
    return made


def test_what_is_valid_stays_as_it_is() -> None:
    room = scene(None, (put(CRATE, 2.0, 2.0), CRATE), (put(table(), 3.0, 4.0), table()))
    assert mend(room) == (room, ())
    assert mend(scene()) == (scene(), ())


def test_out_of_the_wall_by_what_it_is_in_it() -> None:
    move = only_move(scene(None, (put(CRATE, 0.21, 0.235), CRATE)))
    assert mm(move) == pytest.approx([40.0, 15.0, 0.0], abs=0.5)
    assert move.why == ("outside",)


def test_round_the_inner_corner_of_an_l_shaped_room() -> None:
    move = only_move(scene(L_ROOM, (put(CRATE, 1.80, 1.85), CRATE)))
    assert mm(move) == pytest.approx([-50.0, 0.0, 0.0], abs=0.5)


def test_up_out_of_the_floor_and_down_from_the_ceiling() -> None:
    assert mm(only_move(scene(None, (put(CRATE, 2.0, 2.0, -0.02), CRATE)))) == pytest.approx([0, 0, 20.0], abs=0.5)
    pendant = asset("pendant", (0.3, 0.3, 0.6), mount="ceiling", mass=2.0)
    above = scene(None, (put(pendant, 2.0, 2.0, 2.03, on="ceiling"), pendant))
    assert mm(only_move(above)) == pytest.approx([0, 0, -30.0], abs=0.5)


def test_the_lighter_of_two_is_moved_out_by_the_depth() -> None:
    room = scene(None, (put(HEAVY, 2.0, 2.0), HEAVY), (put(CRATE, 2.5, 2.1), CRATE))
    move = only_move(room)
    assert move.id == "crate_1"
    assert mm(move) == pytest.approx([50.0, 0.0, 0.0], abs=0.5)


def test_the_heavier_is_moved_where_the_lighter_cannot_be() -> None:
    stuck = asset("closet", (0.5, 0.5, 2.6))
    between = [(put(HEAVY, x, y, id=f"safe_{i}"), HEAVY) for i, (x, y) in enumerate([(0.82, 0.3), (0.3, 0.85)])]
    room = scene(rectangle(1.9, 2.0), (put(stuck, 0.25, 0.25), stuck), *between)
    mended, moves = mend(room)
    assert not failing(mended)
    assert all(move.mended for move in moves)


def test_a_lamp_sunk_by_three_millimetres_goes_up_by_three() -> None:
    room = scene(None, (put(table(), 2.0, 2.0), table()), (put(vase(), 2.1, 2.0, 0.747, on="table_1"), vase()))
    move = only_move(room)
    assert move.id == "vase_1"
    assert mm(move) == pytest.approx([0.0, 0.0, 3.0], abs=0.5)
    assert move.why == ("collision",)


@pytest.mark.parametrize("height", [0.02, 0.3, 1.2])
def test_what_floats_is_put_on_what_is_below_it(height: float) -> None:
    room = scene(None, (put(table(), 2.0, 2.0), table()))
    on_table = room.with_placement(put(vase(), 2.1, 2.0, 0.75 + height, on="table_1"), vase())
    assert mm(only_move(on_table, furthest=2.0)) == pytest.approx([0.0, 0.0, -1000 * height], abs=0.5)
    on_floor = room.with_placement(put(CRATE, 2.0, 3.5, height), CRATE)
    assert mm(only_move(on_floor, furthest=2.0)) == pytest.approx([0.0, 0.0, -1000 * height], abs=0.5)


def test_what_falls_over_the_edge_is_moved_inwards_until_it_stands() -> None:
    room = scene(None, (put(table(), 2.0, 2.0), table()), (put(vase(), 2.63, 2.0, 0.75, on="table_1"), vase()))
    move = only_move(room)
    assert 25.0 < move.distance * 1000 < 45.0
    assert move.by[0] < 0.0
    assert abs(move.by[1]) + abs(move.by[2]) < 0.001


def test_what_lies_beside_its_table_takes_the_support_that_it_gets() -> None:
    room = scene(None, (put(table(), 2.0, 2.0), table()), (put(CRATE, 2.0, 3.5, 0.75, on="table_1"), CRATE))
    mended, _ = mend(room, furthest=1.0)
    assert not failing(mended)
    assert mended["crate_1"].support == "floor"


@pytest.mark.parametrize("gap", [0.02, 0.3, -0.015])
def test_a_picture_goes_to_its_wall(gap: float) -> None:
    hung = put(PICTURE, 2.0, 5.0 - 0.015 - gap, 1.4, yaw=270.0, on="north_wall")
    assert mm(only_move(scene(None, (hung, PICTURE)))) == pytest.approx([0.0, 1000 * gap, 0.0], abs=0.5)


def test_two_pictures_in_one_place_are_moved_apart_along_the_wall() -> None:
    pair = [(put(PICTURE, x, 4.985, z, yaw=270.0, on="north_wall", id=f"picture_{x}"), PICTURE)
            for x, z in ((2, 1.4), (3, 1.5))]  # fmt: skip
    move = only_move(shifted(scene(None, *pair), "picture_3", -0.45, 0.0, 0.0))
    assert mm(move) in (pytest.approx([50.0, 0.0, 0.0], abs=0.5), pytest.approx([-50.0, 0.0, 0.0], abs=0.5))


def test_a_blocked_door_is_freed_by_the_least_shift() -> None:
    room = rectangle(4.0, 5.0, openings=(DOOR,))
    move = only_move(scene(room, (put(CRATE, 1.5, 1.0), CRATE)))
    assert move.why == ("blocks_door",)
    assert mm(move) == pytest.approx([0.0, 150.0, 0.0], abs=2.0)


def test_what_rests_on_a_moved_object_moves_with_it() -> None:
    cup = asset("cup", (0.08, 0.08, 0.1), mass=0.3, mount="surface")
    tray = asset("tray", (0.4, 0.3, 0.02), mass=1.0, mount="surface")
    room = scene(
        None, (put(table(), 0.5, 2.0), table()), (put(tray, 0.6, 2.0, 0.75, on="table_1"), tray),
        (put(cup, 0.6, 2.05, 0.77, on="tray_1"), cup), (put(CRATE, 3.0, 3.0), CRATE),
    )  # fmt: skip
    mended, moves = mend(room)
    assert not failing(mended)
    assert {move.id for move in moves} == {"table_1", "tray_1", "cup_1"}
    assert all(mm(move) == pytest.approx([100.0, 0.0, 0.0], abs=0.5) for move in moves)
    assert {move.id: move.why for move in moves}["table_1"] == ("outside",)
    assert mended["crate_1"] == room["crate_1"]


def test_what_hovers_and_is_collided_with_is_put_down_first() -> None:
    room = scene(None, (put(table(), 2.0, 2.0, 0.03), table()), (put(vase(), 2.0, 2.0, 0.77, on="table_1"), vase()))
    mended, _ = mend(room)
    assert not failing(mended)
    assert mended["table_1"].position == pytest.approx((2.0, 2.0, 0.0), abs=1e-3)
    assert mended["vase_1"].position == pytest.approx((2.0, 2.0, 0.75), abs=1e-3)


def test_what_cannot_be_mended_stays_and_is_named() -> None:
    tall = asset("pole", (0.3, 0.3, 3.0))
    room = scene(None, (put(tall, 2.0, 2.0), tall), (put(CRATE, 0.2, 3.0), CRATE))
    mended, moves = mend(room)
    by_id = {move.id: move for move in moves}
    assert by_id["pole_1"] == MendingMove(
        id="pole_1", by=(0.0, 0.0, 0.0), turn=0.0, distance=0.0, why=("outside",), mended=False
    )
    assert by_id["crate_1"].mended
    assert mended["pole_1"] == room["pole_1"]
    assert failing(mended) == {"pole_1"}


NIGHTSTAND = asset("nightstand", (0.4, 0.45, 0.5), mass=12.0)


def test_what_rests_over_its_edge_moves_with_it() -> None:
    """The lamp's middle is past the edge of the nightstand, which is 4.6 mm in the wall; its foot is on it."""
    foot, arm = box((0.16, 0.2, 0.3), (-0.12, 0.0, 0.15)), box((0.4, 0.04, 0.02), (0.0, 0.0, 0.31))
    lamp, bed = asset("lamp", (0.4, 0.2, 0.32), foot, arm, mass=2.0), asset("bed", (2.0, 1.6, 0.5), mass=60.0)
    room = scene(
        None, (put(NIGHTSTAND, 0.1954, 2.0), NIGHTSTAND), (put(lamp, 0.42, 2.0, 0.5, on="nightstand_1"), lamp),
        (put(bed, 1.0, 3.05), bed),
    )  # fmt: skip
    assert room["lamp_1"].support == "floor", "its middle is over nothing"
    mended, moves = mend(room)
    by_id = {move.id: move for move in moves}
    assert mm(by_id["nightstand_1"]) == pytest.approx([4.6, 0.0, 0.0], abs=1.0)
    assert by_id["lamp_1"].by == by_id["nightstand_1"].by
    assert mended["bed_1"] == room["bed_1"]


def test_a_small_fault_is_mended_by_little_where_there_is_hardly_room() -> None:
    """A nightstand 4.6 mm in the wall, with a wardrobe 4 mm before it: 0.6 mm of contact are tolerated."""
    closet = asset("closet", (0.6, 1.2, 2.0), mass=80.0)
    room = scene(None, (put(NIGHTSTAND, 0.1954, 2.0), NIGHTSTAND), (put(closet, 0.6994, 2.0), closet))
    move = only_move(room)
    assert move.id == "nightstand_1"
    assert mm(move) == pytest.approx([4.1, 0.0, 0.0], abs=0.6)


@pytest.mark.parametrize("furthest", [0.05, 0.9])
def test_nothing_is_moved_further_than_it_may_be(furthest: float) -> None:
    deep = scene(None, (put(HEAVY, 2.0, 2.0), HEAVY), (put(CRATE, 2.1, 2.05), CRATE))
    mended, moves = mend(deep, furthest=furthest)
    (move,) = [move for move in moves if move.id == "crate_1"]
    if furthest > 0.5:
        assert move.mended
        assert move.needs is None
        assert 0.44 < move.distance < 0.5
    else:
        assert mended == deep
        assert not move.mended
        assert move.distance == 0.0
        assert move.needs == pytest.approx(0.45, abs=0.03)


def test_two_are_moved_apart_together_where_one_alone_would_go_too_far() -> None:
    other = put(HEAVY, 0.5, 4.0, id="safe_2")
    room = scene(None, (put(HEAVY, 2.0, 2.0), HEAVY), (put(CRATE, 2.1, 2.05), CRATE), (other, HEAVY))
    mended, moves = mend(room)
    assert not failing(mended)
    assert {move.id for move in moves} == {"crate_1", "safe_1"}
    assert all(move.mended and move.distance <= 0.3 for move in moves)
    assert moves == mend(room)[1]


def test_a_neighbour_makes_room_with_all_that_it_carries() -> None:
    """The bench is in the safe, and the chest where it could go: nothing is wrong with the chest."""
    bench = asset("bench", (0.5, 1.9, 0.5))
    chest = asset("chest", (0.6, 1.9, 0.5), mass=20.0)
    room = scene(
        rectangle(1.9, 2.0),
        (put(HEAVY, 0.31, 1.0, id="safe_1"), HEAVY),
        (put(bench, 0.7, 1.0, id="bench_1"), bench),
        (put(chest, 1.3, 1.0, id="chest_1"), chest),
        (put(vase(), 1.3, 1.0, 0.5, on="chest_1"), vase()),
    )
    mended, moves = mend(room)
    assert not failing(mended)
    assert all(move.distance <= 0.3 for move in moves)
    by = {move.id: move.by for move in moves}
    assert by["vase_1"] == by["chest_1"]
    assert mended["vase_1"].support == "chest_1"


def test_what_floats_far_above_something_is_not_taken_down_to_it() -> None:
    room = scene(None, (put(table(), 2.0, 2.0), table()), (put(vase(), 2.1, 2.0, 1.95, on="table_1"), vase()))
    mended, (move,) = mend(room)
    assert mended == room
    assert not move.mended
    assert move.needs == pytest.approx(1.2, abs=0.01)


def test_what_stands_on_one_table_is_not_put_on_another() -> None:
    other = put(table(), 2.0, 2.81, id="table_2")
    room = scene(None, (put(table(), 2.0, 2.0), table()), (other, table()))
    crates = [(put(CRATE, x, 2.0, 0.75, on="table_1", id=f"crate_{i}"), CRATE) for i, x in ((1, 1.65), (2, 2.05))]
    for placement, made in crates:
        room = room.with_placement(placement, made)
    mended, _ = mend(room)
    assert {p.id: p.support for p in mended.placements} == {p.id: p.support for p in room.placements}


def test_a_distance_that_is_none_is_refused() -> None:
    for furthest in (0.0, -1.0, math.inf, math.nan):
        with pytest.raises(InputError, match="furthest"):
            mend(scene(), furthest=furthest)


def test_a_room_too_small_for_both_is_left_alone() -> None:
    room = scene(rectangle(1.0, 1.0), (put(HEAVY, 0.3, 0.3), HEAVY), (put(CRATE, 0.6, 0.6), CRATE))
    mended, moves = mend(room)
    assert mended == room
    assert [(move.mended, move.distance) for move in moves] == [(False, 0.0), (False, 0.0)]


def test_out_of_reach_is_left_alone() -> None:
    mended, moves = mend(scene(None, (put(CRATE, -900.0, 900.0, 40.0), CRATE)))
    assert [move.mended for move in moves] in ([True], [False])
    assert len(mended.placements) == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    ("id", "by", "least", "most"),
    [
        ("desk_lamp_1", (0.0, 0.0, -0.003), 2.0, 4.0),
        ("desk_lamp_1", (0.0, 0.0, 0.15), 149.0, 151.0),
        ("picture_1", "off the wall", 19.0, 25.0),
        ("bookcase_1", (0.0, 0.0, -0.01), 9.0, 11.0),
        ("bookcase_1", "into the wall", 5.0, 30.0),
    ],
)
def test_known_disturbances_of_a_generated_room_are_undone(
    office: Scene, id: str, by: object, least: float, most: float
) -> None:
    x, y = office[id].front
    named = {"off the wall": (0.02 * x, 0.02 * y, 0.0), "into the wall": (-0.03 * x, -0.03 * y, 0.0)}
    vector = named[by] if isinstance(by, str) else by
    assert isinstance(vector, tuple)
    disturbed = shifted(office, id, *vector)
    group = {id} | {p.id for p in office.resting_on(id)}
    for rider in group - {id}:
        disturbed = shifted(disturbed, rider, *vector)
    assert id in failing(disturbed)
    mended, moves = mend(disturbed)
    assert not failing(mended)
    move = next(move for move in moves if move.id == id)
    assert least <= move.distance * 1000 <= most
    assert float(np.dot(move.by, vector)) < 0.0
    assert {move.id for move in moves} <= group


def test_many_faults_at_once(office: Scene) -> None:
    disturbed = shifted(office, "desk_lamp_1", 0.0, 0.0, -0.003)
    x, y = office["picture_1"].front
    disturbed = shifted(disturbed, "picture_1", 0.02 * x, 0.02 * y, 0.0)
    desk = office["desk_1"].position
    disturbed = disturbed.moved("chair_1", position=(desk[0], desk[1], 0.0))
    mended, moves = mend(disturbed)
    assert not failing(mended)
    assert all(move.mended for move in moves)
    untouched = {p.id for p in office.placements} - {move.id for move in moves}
    assert all(mended[id] == disturbed[id] for id in untouched)


def test_mending_is_deterministic() -> None:
    """Where not all can be mended, too: then everything is also tried moved apart."""
    objects = ((put(table(), 2.0, 2.0), table()), (put(CRATE, 2.5, 2.3), CRATE), (put(vase(), 2.9, 3.3, 0.8), vase()))
    disturbed = scene(None, *objects)
    mended, moves = mend(disturbed)
    assert {move.id: move.mended for move in moves} == {"crate_1": True, "vase_1": False}
    assert mend(disturbed) == (mended, moves)


coordinate = st.floats(-0.2, 0.2).map(lambda value: round(value, 3))


@settings(max_examples=12, deadline=None)
@given(a=st.tuples(coordinate, coordinate, coordinate), b=st.tuples(coordinate, coordinate, coordinate))
@pytest.mark.slow
def test_nothing_gets_worse(a: tuple[float, float, float], b: tuple[float, float, float]) -> None:
    legless = asset("chest", (0.8, 0.5, 0.6), box((0.8, 0.5, 0.6), (0.0, 0.0, 0.3)), mass=30.0)
    room = scene(
        rectangle(3.0, 2.5, openings=(DOOR,)), (put(CRATE, 0.3, 2.2), CRATE), (put(legless, 2.5, 0.8), legless),
        (put(vase(), 2.5, 0.8, 0.6, on="chest_1"), vase()), (put(CRATE, 0.3, 1.5, id="crate_2"), CRATE),
    )  # fmt: skip
    disturbed = shifted(shifted(room, "chest_1", *a), "crate_2", *b)
    before, (mended, moves) = failing(disturbed), mend(disturbed)
    after = failing(mended)
    assert after <= before
    moved = {move.id for move in moves if move.distance > 0.0}
    assert all(mended[p.id].position == p.position for p in disturbed.placements if p.id not in moved)
    assert moved <= before | {"vase_1"}
    assert {move.id for move in moves if not move.mended} == after
