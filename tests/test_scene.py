import json
import math

import jsonschema
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec import structs

from tests.conftest import unit_box
from thinkblox.errors import InputError
from thinkblox.scene.asset import Asset
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.scene.scene import Scene, load_scene
from thinkblox.value import from_json, json_schema, to_json

L_SHAPE = ((0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (3.0, 2.0), (3.0, 4.0), (0.0, 4.0))


def at(box_asset, id="box_1", x=1.0, y=1.0, yaw=0.0):
    return Placement(
        id=id, category="box", asset=box_asset.id, position=(x, y, 0.0), yaw=yaw, size=box_asset.size, support="floor"
    )


def test_a_change_gives_a_new_scene_and_keeps_the_old(box_asset):
    empty = Scene(room=rectangle(4.0, 3.0))
    one = empty.with_placement(at(box_asset), box_asset)
    two = one.with_placement(at(box_asset, "box_2", x=3.0), box_asset)
    moved = two.moved("box_1", yaw=90.0)
    assert [len(s.placements) for s in (empty, one, two, moved)] == [0, 1, 2, 2]
    assert (two["box_1"].yaw, moved["box_1"].yaw) == (0.0, 90.0)
    assert [p.id for p in two.without("box_1").placements] == ["box_2"]
    assert two.without("box_1").without("box_2").assets == {}


def test_an_object_replaced_keeps_its_place_in_the_order(box_asset):
    scene = Scene(room=rectangle(4.0, 3.0))
    for id in ("box_1", "box_2"):
        scene = scene.with_placement(at(box_asset, id), box_asset)
    assert [p.id for p in scene.with_placement(at(box_asset, "box_1", x=2.0), box_asset).placements] == [
        "box_1",
        "box_2",
    ]


def test_an_unknown_id_lists_the_ones_that_exist(box_asset):
    scene = Scene(room=rectangle(4.0, 3.0)).with_placement(at(box_asset), box_asset)
    with pytest.raises(KeyError, match="box_1"):
        scene["sofa_1"]


@settings(max_examples=40)
@given(
    st.lists(st.tuples(st.floats(0, 10), st.floats(0, 10), st.floats(-720, 720), st.text(max_size=20)), max_size=6),
    st.integers(0, 2**40),
)
def test_json_round_trip(rows, seed):
    asset = unit_box()
    scene = Scene(room=rectangle(4.0, 3.0), prompt=" ".join(text for *_, text in rows), seed=seed)
    for number, (x, y, yaw, _) in enumerate(rows):
        scene = scene.with_placement(at(asset, f"box_{number}", x, y, yaw), asset)
    data = to_json(scene)
    assert from_json(data, Scene) == scene
    assert to_json(from_json(data, Scene)) == data
    jsonschema.validate(json.loads(data), json_schema(Scene))


def test_text_that_looks_like_a_vector_is_left_alone():
    scene = Scene(room=rectangle(4.0, 3.0), prompt="a [1, 2,\n  3] b")
    assert from_json(to_json(scene), Scene).prompt == "a [1, 2,\n  3] b"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"version": 99}, "version 99"),
        ({"rooom": {}}, "rooom"),
        ({"room": {"floor": [[0, 0], [1, 1]]}}, "2 corners"),
        ({"room": {"floor": [[0, 0], [4, 3], [4, 0], [0, 3]]}}, "simple polygon"),
        ({"room": {"floor": [[0, 0], [0, 3], [4, 3], [4, 0]]}}, "clockwise"),
        ({"room": {"floor": [[0, 0], [0, 0], [4, 3], [0, 3]]}}, "closer than 1 cm"),
        ({"room": {"floor": [[0, 0], [0.2, 0], [0.2, 3], [0, 3]]}}, "0.2 m by 3 m"),
        ({"room": {"floor": [[0, 0], [900, 0], [900, 3], [0, 3]]}}, "900 m by 3 m"),
        ({"room": {"floor": [[0, 0], [1e300, 0], [4, 3], [0, 3]]}}, r"floor\[1\]\[0\]"),
        ({"room": {"floor": [[0, 0], ["4", 0], [4, 3]]}}, r"room.floor\[1\]\[0\]"),
        (
            {"room": {"floor": [[0, 0], [4, 0], [4, 3], [0, 3]], "openings": [
                {"id": "door_1", "kind": "door", "wall": 9, "offset": 0, "width": 1, "height": 2}]}},
            "wall 9",
        ),
        (
            {"room": {"floor": [[0, 0], [4, 0], [4, 3], [0, 3]], "openings": [
                {"id": "door_1", "kind": "door", "wall": 0, "offset": 3.5, "width": 1, "height": 2}]}},
            "past the end",
        ),
        ({"placements": [{"id": "a_1", "category": "a", "asset": "gone", "position": [0, 0, 0], "yaw": 0,
                          "size": [1, 1, 1], "support": "floor"}]}, "no asset 'gone'"),
    ],
)  # fmt: skip
def test_a_wrong_scene_says_what_is_wrong(change, message):
    document = json.loads(to_json(Scene(room=rectangle(4.0, 3.0)))) | change
    with pytest.raises(InputError, match=message):
        from_json(json.dumps(document), Scene)


def test_two_objects_of_one_id_are_refused(box_asset):
    placement = at(box_asset)
    with pytest.raises(InputError, match="box_1"):
        Scene(room=rectangle(4.0, 3.0), placements=(placement, placement), assets={box_asset.id: box_asset})


def test_a_file_that_is_not_there_or_not_json_is_named(tmp_path):
    with pytest.raises(InputError, match="nothing"):
        load_scene(tmp_path / "nothing.json")
    (tmp_path / "scene.json").write_bytes(b"\xff\xfe not json")
    with pytest.raises(InputError, match=r"scene\.json"):
        load_scene(tmp_path)


def test_a_file_whose_things_rest_on_nothing_that_is_there_is_refused(box_asset, tmp_path):
    scene = Scene(room=rectangle(4.0, 3.0)).with_placement(at(box_asset), box_asset)
    scene = scene.with_placement(at(box_asset, "box_2", x=3.0), box_asset)
    text = to_json(scene).decode()
    for support in ("nobody", "box_3", "Floor"):
        (tmp_path / "scene.json").write_text(text.replace('"support": "floor"', f'"support": "{support}"', 1))
        with pytest.raises(InputError, match=rf"scene\.json: .*'box_1' rests on '{support}'.*floor.*south_wall.*box_2"):
            load_scene(tmp_path)
    for support in ("", "ceiling", "west_wall", "box_2"):
        (tmp_path / "scene.json").write_text(text.replace('"support": "floor"', f'"support": "{support}"', 1))
        assert load_scene(tmp_path) == scene


def test_walls_are_named_by_the_side_they_bound():
    assert [w.name for w in rectangle(4.0, 3.0).walls] == ["south_wall", "east_wall", "north_wall", "west_wall"]
    names = [w.name for w in Room(floor=L_SHAPE).walls]
    assert names == ["south_wall", "east_wall", "north_wall", "east_wall_2", "north_wall_2", "west_wall"]
    assert {w.name: w.yaw for w in rectangle(4.0, 3.0).walls} == {
        "south_wall": 90.0, "east_wall": 180.0, "north_wall": 270.0, "west_wall": 0.0,
    }  # fmt: skip


@given(st.floats(0.1, 3.9), st.floats(-2, 2), st.integers(0, 5))
def test_wall_coordinates_are_the_inverse_of_its_points(along, inward, number):
    wall = Room(floor=L_SHAPE).walls[number]
    assert wall.coordinates(wall.point(along, inward)) == pytest.approx((along, inward), abs=1e-9)


@given(st.floats(-400, 400), st.floats(-3, 3), st.floats(-3, 3))
def test_placement_frames_are_inverse_and_front_is_x(yaw, x, y):
    placement = Placement(
        id="a_1", category="a", asset="", position=(1.0, 2.0, 0.0), yaw=yaw, size=(2.0, 1.0, 1.0), support="floor"
    )
    assert placement.to_local(placement.to_room((x, y))) == pytest.approx((x, y), abs=1e-9)
    ahead = placement.to_room((1.0, 0.0))
    turn = math.degrees(math.atan2(ahead[1] - 2.0, ahead[0] - 1.0)) - yaw
    assert (turn + 180.0) % 360.0 == pytest.approx(180.0, abs=1e-6)
    assert placement.footprint.area == pytest.approx(2.0)


def test_an_opening_is_kept():
    door = Opening(id="door_1", kind="door", wall=1, offset=0.5, width=0.9, height=2.1)
    assert from_json(to_json(rectangle(4.0, 3.0, openings=(door,))), Room).openings == (door,)


def test_the_parts_of_all_objects_together_are_bounded(box_asset: Asset) -> None:
    (link,) = box_asset.links
    heap = structs.replace(box_asset, links=(structs.replace(link, shapes=link.shapes * 2048),))
    assert heap.made_of == (1, 2048, 0)
    placed = [Placement(id=f"box_{n}", category="box", asset="box-0", position=(0, 0, n), yaw=0, size=(1, 1, 1))
              for n in range(20)]  # fmt: skip
    with pytest.raises(InputError, match="40960 shapes together; at most 40000 are read"):
        Scene(room=rectangle(4.0, 4.0), placements=tuple(placed), assets={"box-0": heap})
