import numpy as np
import pytest
from msgspec import structs

from tests.conftest import unit_box
from thinkblox.assets import make_asset
from thinkblox.scene.asset import Asset
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.scene.support import placed_at
from thinkblox.sim.render import Marking, RoomView, layers, render_target, room_views
from thinkblox.sim.render.layers import canvas, viewpoint


def with_chairs(count: int, room: Room) -> Scene:
    asset, scene = make_asset("chair", seed=1), Scene(room=room)
    across = int(room.extent[0] / 0.85)
    for n in range(count):
        at = (0.6 + n % across * 0.82, 0.6 + n // across * 0.82, 0.0)
        scene = scene.with_placement(
            placed_at(scene, asset, id=f"chair_{n + 1}", position=at, yaw=90.0 * (n % 4)), asset
        )
    return scene


def pixels(view: RoomView) -> np.ndarray:
    return np.asarray(view.picture).astype(int)


@pytest.mark.parametrize(("count", "size"), [(4, 336), (80, 336), (80, 168)])
def test_marks_never_hide_each_other(count, size):
    for view in room_views(with_chairs(count, rectangle(9.0, 8.0)), size=size):
        covered = np.zeros((size, size), int)
        for left, top, right, bottom in view.boxes:
            covered[max(top, 0) : bottom, max(left, 0) : right] += 1
        assert covered.max() == 1


def test_of_eighty_objects_each_has_its_number_and_the_legend_says_what_it_means():
    above, *corners = room_views(with_chairs(80, rectangle(9.0, 8.0)), size=336)
    assert above.legend == ("1-80 chair_1 to chair_80",)
    assert len(above.boxes) >= 80
    assert above.unmarked == ()
    assert all(len(view.unmarked) < 16 for view in corners)
    assert room_views(with_chairs(4, rectangle(9.0, 8.0)), size=336)[0].legend == ()


def test_where_a_picture_is_too_small_for_all_marks_it_says_what_has_none():
    above = room_views(with_chairs(80, rectangle(9.0, 8.0)), size=112, count=1)[0]
    assert above.unmarked
    assert set(above.unmarked) < {f"chair_{n}" for n in range(1, 81)}


def test_each_kind_of_mark_can_be_left_out():
    scene = with_chairs(3, rectangle(4.0, 3.0))
    bare = room_views(scene, size=224, count=2, marking=Marking(grid=False, ids=False, fronts=False))
    assert all(view.boxes == () for view in bare)
    for name in ("grid", "ids", "fronts"):
        marking = Marking(**{kind: kind == name for kind in ("grid", "ids", "fronts")})
        for view, without in zip(room_views(scene, size=224, count=2, marking=marking), bare, strict=True):
            assert view.boxes
            assert (pixels(view) != pixels(without)).any()


def test_what_was_drawn_before_makes_no_difference():
    grown = with_chairs(12, rectangle(5.0, 4.0))
    stepwise = []
    for n in range(1, 13):
        part = structs.replace(grown, placements=grown.placements[:n])
        stepwise = room_views(part, size=168)
    layers._layer.cache_clear()
    layers._bare.cache_clear()
    for once, again in zip(room_views(grown, size=168), stepwise, strict=True):
        assert (pixels(once) == pixels(again)).all()


def test_a_layer_is_where_the_camera_projects_the_object():
    room = rectangle(4.0, 3.0)
    asset = unit_box()
    scene = Scene(room=room)
    scene = scene.with_placement(placed_at(scene, asset, id="box_1", position=(2.5, 1.0, 0.0), yaw=30.0), asset)
    for azimuth in (None, 225.0, 45.0):
        view = viewpoint(room, azimuth)
        seen = canvas(scene, view, 200)
        x, y = view.camera.project(np.array([[2.5, 1.0, 1.0]]), 200)[0]
        assert seen.ids[int(y), int(x)] == 0
        assert not seen.floor[int(y), int(x)]
        corner = view.camera.project(np.array([[0.3, 2.7, 0.0]]), 200)[0]
        assert seen.floor[int(corner[1]), int(corner[0])]


def test_the_nearer_of_two_hides_the_other():
    room, box = rectangle(4.0, 4.0), unit_box()
    scene = Scene(room=room)
    for n, z in ((1, 1.0), (2, 0.0)):
        at = placed_at(scene, box, id=f"box_{n}", position=(2.0, 2.0, z), yaw=0.0)
        scene = scene.with_placement(at, box)
    assert canvas(scene, viewpoint(room, None), 128).ids[64, 64] == 0


def test_an_object_has_an_arrow_at_its_front_where_it_has_one():
    def orange(asset: Asset, **options: bool) -> int:
        red, green, blue = np.moveaxis(np.asarray(render_target(asset, size=96, **options)).astype(int), -1, 0)
        return int(((red > 220) & (green < 110) & (blue < 60)).sum())

    chair, stool = make_asset("chair", seed=1), make_asset("stool", seed=1)
    assert orange(chair) > 20
    assert orange(chair, front=False) == 0
    assert orange(stool) == 0


def test_doors_are_drawn_from_above_and_what_hangs_on_a_wall_that_is_cut_away_is_not():
    door = Opening(id="door_1", kind="door", wall=0, offset=0.3, width=0.9, height=2.1)
    with_door, without = rectangle(4.0, 3.0, openings=(door,)), rectangle(4.0, 3.0)
    a, b = (room_views(Scene(room=room), size=160, count=1)[0] for room in (with_door, without))
    assert (pixels(a) != pixels(b)).sum() > 200
    picture = make_asset("picture", seed=1)
    scene = Scene(room=without)
    at = placed_at(scene, picture, id="picture_1", position=(2.0, 0.02, 1.4), yaw=90.0)
    scene = scene.with_placement(at, picture)
    assert not (canvas(scene, viewpoint(without, 225.0), 128).ids == 0).any()
    assert (canvas(scene, viewpoint(without, 45.0), 128).ids == 0).any()
