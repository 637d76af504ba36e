"""What actions do to a scene, and what they leave alone."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec import structs

from tests.sim_rooms import asset, box, put
from thinkblox.errors import InputError
from thinkblox.scene import Room, Scene, Surface, rectangle
from thinkblox.scene.actions import Add, Move, Remove, Replace, Swap, Turn, outcome
from thinkblox.scene.asset import Asset
from thinkblox.scene.support import placed_at
from thinkblox.value import from_json, to_json

ROOM = rectangle(5.0, 4.0)


def table(name: str, height: float, size: float = 1.0) -> Asset:
    made = asset(name, (size, size, height), box((size, size, height), (0.0, 0.0, height / 2)), mass=20.0)
    top = Surface(name="top", position=(0.0, 0.0, height), size=(size, size))
    return structs.replace(made, surfaces=(top,))


HIGH, LOW = table("table", 0.8), table("bench", 0.5, 0.6)
CUP = asset("cup", (0.1, 0.1, 0.1), box((0.1, 0.1, 0.1), (0.0, 0.0, 0.05)), mass=0.3, mount="surface")
PICTURE = asset("picture", (0.02, 0.6, 0.4), box((0.02, 0.6, 0.4), (0.0, 0.0, 0.2)), mass=2.0, mount="wall")


def furnished() -> Scene:
    scene = Scene(room=ROOM)
    for id, kind, position, yaw in (
        ("table_1", HIGH, (1.0, 1.0, 0.0), 0.0),
        ("cup_1", CUP, (1.3, 1.0, 0.8), 10.0),
        ("cup_2", CUP, (1.3, 1.0, 0.9), 0.0),
        ("bench_1", LOW, (4.0, 3.0, 0.0), 90.0),
        ("picture_1", PICTURE, (2.5, 3.99, 1.4), 270.0),
    ):
        scene = scene.apply(Add(id=id, asset=kind, position=position, yaw=yaw))
    return scene


def same(before: Scene, after: Scene, *but: str) -> bool:
    return all(after[p.id] == p for p in before.placements if p.id not in but)


def test_support_is_what_lies_under_it() -> None:
    scene = furnished()
    assert {p.id: p.support for p in scene.placements} == {
        "table_1": "floor", "cup_1": "table_1", "cup_2": "cup_1", "bench_1": "floor", "picture_1": "north_wall",
    }  # fmt: skip


def test_a_picture_moved_to_another_wall_hangs_on_that_wall() -> None:
    scene = furnished().apply(Move(id="picture_1", position=(4.99, 2.0, 1.4), yaw=180.0))
    assert scene["picture_1"].support == "east_wall"


def test_support_in_a_file_or_from_a_caller_is_not_believed() -> None:
    scene = furnished()
    lying = structs.replace(scene, placements=tuple(structs.replace(p, support="ceiling") for p in scene.placements))
    assert lying == scene
    assert from_json(to_json(scene).replace(b'"support": "table_1"', b'"support": "moon"'), Scene) == scene


def test_another_room_gives_other_walls() -> None:
    turned = Room(floor=((0.0, 0.0), (5.0, 1.0), (5.0, 5.0), (0.0, 5.0)))
    scene = structs.replace(furnished(), room=turned)
    assert scene["picture_1"].support in {wall.name for wall in turned.walls}


def test_what_rests_on_a_moved_thing_rides_along() -> None:
    scene = furnished()
    after, carried, left = outcome(scene, Move(id="table_1", position=(2.0, 2.0, 0.0), yaw=90.0))
    assert (carried, left) == (("cup_1", "cup_2"), ())
    assert after["cup_1"].position == pytest.approx((2.0, 2.3, 0.8))
    assert after["cup_2"].position == pytest.approx((2.0, 2.3, 0.9))
    assert (after["cup_1"].yaw, after["cup_1"].support, after["cup_2"].support) == (100.0, "table_1", "cup_1")
    assert same(scene, after, "table_1", "cup_1", "cup_2")


def test_turning_is_about_its_own_middle() -> None:
    after = furnished().apply(Turn(id="table_1", yaw=180.0))
    assert after["table_1"].position == (1.0, 1.0, 0.0)
    assert after["cup_1"].position == pytest.approx((0.7, 1.0, 0.8))


def test_what_rested_on_a_removed_thing_is_reported_and_left() -> None:
    scene = furnished()
    after, carried, left = outcome(scene, Remove(id="table_1"))
    assert (carried, left) == ((), ("cup_1",))
    assert after["cup_1"].support == "floor"
    assert same(scene, after, "table_1", "cup_1")


def test_a_replacement_takes_the_place_and_what_has_room_on_it() -> None:
    scene = furnished().apply(Add(id="cup_3", asset=CUP, position=(0.55, 1.0, 0.8), yaw=0.0))
    assert scene["cup_3"].support == "table_1"
    after, carried, left = outcome(scene, Replace(id="table_1", asset=LOW))
    assert after["table_1"].asset == LOW.id
    assert math.isclose(after["table_1"].position[0] - LOW.size[0] / 2, 1.0 - HIGH.size[0] / 2)
    assert left == ("cup_1",)
    assert carried == ("cup_3",)
    assert after["cup_3"].position == (0.55, 1.0, 0.5)
    assert HIGH.id not in after.assets


def test_a_hung_replacement_keeps_its_wall_and_its_middle() -> None:
    mirror = asset("mirror", (0.06, 0.5, 1.0), box((0.06, 0.5, 1.0), (0.0, 0.0, 0.5)), mass=5.0, mount="wall")
    after = furnished().apply(Replace(id="picture_1", asset=mirror))["picture_1"]
    assert after.position == pytest.approx((2.5, 3.97, 1.1))
    assert after.support == "north_wall"


def test_a_swap_takes_riders_along_and_keeps_the_rest() -> None:
    scene = furnished()
    after, carried, left = outcome(scene, Swap(id="table_1", other="bench_1"))
    assert (after["table_1"].yaw, after["bench_1"].yaw) == (90.0, 0.0)
    assert (carried, left) == (("cup_1", "cup_2"), ())
    assert after["cup_1"].support == "table_1"
    assert same(scene, after, "table_1", "bench_1", "cup_1", "cup_2")


@pytest.mark.parametrize(
    ("action", "error", "says"),
    [
        (Add(id="cup_1", asset=CUP, position=(1.0, 1.0, 0.0), yaw=0.0), InputError, "already|has an object"),
        (Move(id="sofa_1", position=(1.0, 1.0, 0.0)), InputError, "table_1"),
        (Remove(id="sofa_1"), InputError, "no object 'sofa_1'; there are .*table_1"),
        (Swap(id="table_1", other="sofa_1"), InputError, "sofa_1"),
        (Swap(id="table_1", other="cup_2"), InputError, "rests on it"),
        (Swap(id="table_1", other="table_1"), InputError, "one is the other"),
    ],
)
def test_what_cannot_be_done_says_why(action, error, says) -> None:
    with pytest.raises(error, match=says):
        furnished().apply(action)


place = st.tuples(st.floats(0.2, 4.8), st.floats(0.2, 3.8), st.sampled_from([0.0, 0.5, 0.8, 0.9, 1.3]))
step = st.tuples(
    st.sampled_from(["move", "turn", "remove", "add", "swap"]), st.integers(0, 30), place, st.floats(0, 359)
)


@settings(max_examples=60, deadline=None)
@given(st.lists(step, max_size=12))
def test_supports_kept_up_step_by_step_are_those_derived_anew(steps) -> None:
    scene = furnished()
    for number, (kind, pick, position, yaw) in enumerate(steps):
        ids = [p.id for p in scene.placements]
        id, other = ids[pick % len(ids)] if ids else "", ids[(pick * 7 + 1) % len(ids)] if ids else ""
        try:
            if kind == "add" or not ids:
                made = (HIGH, CUP, LOW)[pick % 3]
                scene = scene.apply(Add(id=f"new_{number}", asset=made, position=position, yaw=yaw))
            elif kind == "move":
                scene = scene.apply(Move(id=id, position=position, yaw=yaw))
            elif kind == "turn":
                scene = scene.apply(Turn(id=id, yaw=yaw))
            elif kind == "remove":
                scene = scene.apply(Remove(id=id))
            else:
                scene = scene.apply(Swap(id=id, other=other))
        except InputError:
            continue
    assert scene == structs.replace(scene, placements=tuple(scene.placements))
    assert [p.support for p in scene.placements] == [
        placed_at(scene, scene.asset_of(p), id=p.id, position=p.position, yaw=p.yaw).support for p in scene.placements
    ]


def test_what_is_put_is_put() -> None:
    scene = Scene(room=ROOM).with_placement(put(CUP, 1.0, 1.0), CUP)
    assert scene.placements[0].support == "floor"


def test_two_assets_of_one_id_are_refused() -> None:
    other = structs.replace(CUP, mass=5.0)
    with pytest.raises(InputError, match="cup_1"):
        furnished().apply(Add(id="cup_9", asset=other, position=(3.0, 1.0, 0.0), yaw=0.0))
    alone = Scene(room=ROOM).apply(Add(id="cup_1", asset=CUP, position=(1.0, 1.0, 0.0), yaw=0.0))
    assert alone.apply(Replace(id="cup_1", asset=other)).asset_of(alone["cup_1"]).mass == 5.0


def test_lists_and_ints_are_poses_and_rubbish_is_none() -> None:
    scene = furnished()
    assert scene.apply(Move(id="bench_1", position=[2, 3, 0], yaw=450)) == scene.apply(  # type: ignore[arg-type]
        Move(id="bench_1", position=(2.0, 3.0, 0.0), yaw=90.0)
    )
    for position in (None, "abc", (1.0, 2.0), (1.0, 2.0, "x"), (math.nan, 1.0, 0.0)):
        with pytest.raises(InputError, match="bench_1"):
            scene.apply(Move(id="bench_1", position=position))  # type: ignore[arg-type]
    for action in ("move", None, 7):
        with pytest.raises(InputError, match="no action"):
            scene.apply(action)  # type: ignore[arg-type]
