"""Pictures: of the right size, the same every time, and showing what is there."""

import math
from itertools import combinations

import numpy as np
import pytest
from msgspec import structs

from thinkblox.assets.palette import MIRROR
from thinkblox.scene.asset import Asset, Link, Shape, Surface
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.scene.surfaces import Covering, Surfaces
from thinkblox.sim.render import (
    NOTHING,
    ROOM,
    Marking,
    best_view,
    cast,
    contact_sheet,
    plan_of,
    render_asset,
    render_preview,
    render_top,
    room_views,
)
from thinkblox.sim.render.curtains import curtains_at
from thinkblox.sim.render.foreground import in_the_way
from thinkblox.sim.render.labels import Labelled, laid_out, names_of
from thinkblox.sim.render.legend import MOST_NAMED, legend_of, numbered
from thinkblox.sim.render.materials import SILVER
from thinkblox.sim.render.picture import Settings, _spread_over_pixel
from thinkblox.sim.render.plan_view import plan_labels, plan_numbers, text_size
from thinkblox.value import Vec3

L_SHAPE = Room(floor=((0.0, 0.0), (5.0, 0.0), (5.0, 2.5), (2.5, 2.5), (2.5, 5.0), (0.0, 5.0)))
OPEN = rectangle(
    4.0,
    3.0,
    openings=(
        Opening(id="door_1", kind="door", wall=0, offset=0.4, width=0.9, height=2.0),
        Opening(id="window_1", kind="window", wall=2, offset=1.0, width=1.5, height=1.2, sill=0.9),
    ),
)


def asset(category: str, size: Vec3, colour: Vec3 = (0.7, 0.3, 0.2), **options: object) -> Asset:
    box = Shape(kind="box", size=size, position=(0.0, 0.0, size[2] / 2), colour=colour, material="paper")
    links = (Link(name="body", shapes=(box,)),)
    fields = {"mount": "floor", "links": links} | options
    return Asset(id=f"{category}-1", category=category, description="", size=size, mass=1, friction=1, **fields)  # type: ignore[arg-type]


BOX = asset("box", (0.6, 0.4, 0.5))
PICTURE = asset("picture", (0.04, 1.0, 0.8), (0.1, 0.1, 0.9), mount="wall")
LAMP = asset("pendant_lamp", (0.5, 0.5, 0.6), mount="ceiling")


def put(scene: Scene, thing: Asset, position: Vec3, yaw: float = 0.0, support: str = "floor") -> Scene:
    number = 1 + sum(p.category == thing.category for p in scene.placements)
    placement = Placement(
        id=f"{thing.category}_{number}", category=thing.category, asset=thing.id, position=position, yaw=yaw,
        size=thing.size, support=support,
    )  # fmt: skip
    return scene.with_placement(placement, thing)


def pixels(picture: object) -> np.ndarray:
    return np.asarray(picture).astype(int)


@pytest.mark.parametrize("room", [OPEN, L_SHAPE, Room(floor=((0.0, 0.0), (4.0, 0.0), (0.0, 3.0)))])
@pytest.mark.parametrize("furnished", [True, False])
def test_pictures_have_their_size_and_show_something(room: Room, furnished: bool) -> None:
    scene = Scene(room=room)
    if furnished:
        scene = put(scene, BOX, (1.0, 1.0, 0.0))
    for render in (render_preview, render_top):
        picture = render(scene, size=96)
        assert picture.size == (96, 96)
        assert picture.mode == "RGB"
        assert pixels(picture).std() > 10


def test_the_same_scene_gives_the_same_bytes() -> None:
    scene = put(put(Scene(room=OPEN, seed=3), BOX, (1.0, 1.0, 0.0), 30.0), LAMP, (2.0, 1.5, 2.0), 0.0, "ceiling")
    for render in (render_preview, render_top):
        assert render(scene, size=128).tobytes() == render(scene, size=128).tobytes()


def test_the_seed_chooses_the_colours() -> None:
    pictures = {render_preview(Scene(room=OPEN, seed=seed), size=64).tobytes() for seed in range(4)}
    assert len(pictures) > 1


def test_ids_and_depth_are_those_of_the_objects_seen_from_above() -> None:
    scene = put(put(Scene(room=OPEN), BOX, (1.0, 1.0, 0.0), 90.0), BOX, (3.0, 2.0, 0.0))
    camera = plan_of(OPEN)
    frame = cast(scene, camera, size=256)
    assert frame.names == ("box_1", "box_2")
    for number, placement in enumerate(scene.placements):
        rows, columns = np.nonzero(frame.ids == number)
        expected = camera.project(np.array([placement.position]), 256)[0]
        assert (columns.mean() + 0.5, rows.mean() + 0.5) == pytest.approx(expected, abs=0.6)
        metres = 2 * camera.reach / 256
        assert len(rows) * metres**2 == pytest.approx(0.24, rel=0.05)
        assert frame.depth[rows, columns] == pytest.approx(50.0 - 0.5, abs=0.01)
    x, y = camera.project(np.array([[2.0, 0.5, 0.0]]), 256)[0].astype(int)
    assert frame.ids[y, x] == ROOM
    assert frame.depth[y, x] == pytest.approx(50.0, abs=1e-3)
    assert frame.ids[0, 0] == NOTHING
    assert math.isinf(frame.depth[0, 0])


def test_glass_is_seen_through_and_keeps_its_id() -> None:
    pane = Shape(kind="box", size=(0.6, 0.4, 0.5), position=(0.0, 0.0, 0.25), colour=(0.5, 0.8, 0.9), material="glass")
    glass = asset("tank", (0.6, 0.4, 0.5), links=(Link(name="body", shapes=(pane,)),))
    scene = put(Scene(room=OPEN), glass, (2.0, 1.5, 0.0))
    frame = cast(scene, plan_of(OPEN), size=128)
    inside = frame.ids == 0
    assert inside.sum() > 50
    assert frame.depth[inside] == pytest.approx(50.0, abs=1e-3)
    assert np.abs(frame.colour[inside].mean(0) - frame.colour[frame.ids == ROOM].mean(0)).max() < 90


def test_walls_between_the_eye_and_the_room_are_cut() -> None:
    scene = put(Scene(room=OPEN), BOX, (2.0, 1.5, 0.0))
    view = best_view(scene)
    eye = view.camera.position
    for wall, stands in zip(OPEN.walls, view.standing, strict=True):
        assert stands == (wall.coordinates((eye[0], eye[1]))[1] > 0.3)
    assert sum(view.standing) == 2
    assert (cast(scene, view.camera, size=128).ids == 0).sum() > 30


def test_the_window_is_on_the_far_side() -> None:
    assert best_view(Scene(room=OPEN)).standing[2]


def test_a_picture_on_a_cut_wall_does_not_float_before_the_view() -> None:
    empty = Scene(room=OPEN)
    view = best_view(empty)
    wall = next(w for w, stands in zip(OPEN.walls, view.standing, strict=True) if not stands)
    x, y = wall.point(wall.length / 2, 0.02)
    hung = put(empty, PICTURE, (x, y, 1.4), wall.yaw, wall.name)
    if best_view(hung).azimuth == view.azimuth:
        assert render_preview(hung, size=96).tobytes() == render_preview(empty, size=96).tobytes()


def test_the_room_fills_the_picture_and_stays_inside() -> None:
    for room in (OPEN, L_SHAPE, rectangle(9.0, 2.0), rectangle(0.6, 0.6)):
        corners = np.array([(x, y, z) for x, y in room.floor for z in (0.0, room.height)])
        view = best_view(Scene(room=room))
        standing = [view.standing[i] or view.standing[i - 1] for i in range(len(room.floor))]
        seen = view.camera.project(corners[np.repeat(standing, 2) | (corners[:, 2] == 0)], 100)
        assert seen.min() > 2
        assert seen.max() < 98
        assert np.ptp(seen, axis=0).max() > 75


def test_poses_go_before_the_scene() -> None:
    scene = put(Scene(room=OPEN), BOX, (1.0, 1.0, 0.0))
    moved = put(Scene(room=OPEN), BOX, (3.0, 2.0, 0.0))
    poses = {"box_1": ((3.0, 2.0, 0.0), (1.0, 0.0, 0.0, 0.0))}
    ids = cast(scene, plan_of(OPEN), size=96, poses=poses).ids
    assert (ids == cast(moved, plan_of(OPEN), size=96).ids).all()


def test_a_link_that_moved_is_drawn_where_it_is() -> None:
    door = Shape(kind="box", size=(0.05, 0.4, 0.5), position=(0.3, 0.0, 0.25))
    case = asset("case", (0.6, 0.4, 0.5))
    case = asset("case", (0.6, 0.4, 0.5), links=(*case.links, Link(name="drawer", shapes=(door,))))
    scene = put(Scene(room=OPEN), case, (2.0, 1.5, 0.0))
    shut = (cast(scene, plan_of(OPEN), size=256).ids == 0).sum()
    poses = {"case_1/drawer": ((2.3, 1.5, 0.0), (1.0, 0.0, 0.0, 0.0))}
    assert (cast(scene, plan_of(OPEN), size=256, poses=poses).ids == 0).sum() > shut + 20


def test_what_hangs_from_the_ceiling_hides_nothing_in_the_plan() -> None:
    scene = put(Scene(room=OPEN), BOX, (2.0, 1.5, 0.0))
    lit = put(scene, LAMP, (2.0, 1.5, 2.0), 0.0, "ceiling")
    middle = slice(62, 66)
    bare = Marking(grid=False, ids=False, fronts=False)
    without, under = (pixels(room_views(s, size=128, count=1, marking=bare)[0].picture) for s in (scene, lit))
    assert (without[middle, middle] == under[middle, middle]).all()


def test_every_object_has_a_label_and_they_hardly_overlap() -> None:
    scene = Scene(room=OPEN)
    for i in range(12):
        scene = put(scene, BOX, (0.6 + 0.9 * (i % 4), 0.5 + 0.9 * (i // 4), 0.0))
    scene = put(scene, LAMP, (2.0, 1.5, 2.0), 0.0, "ceiling")
    labels = plan_labels(scene, plan_of(OPEN), 512)
    assert {label.id for label in labels} == {p.id for p in scene.placements}
    assert all(label.text for label in labels)


def test_names_are_short_for_many_of_a_kind_and_plain_for_one() -> None:
    scene = put(put(Scene(room=OPEN), LAMP, (1.0, 1.0, 2.0), 0.0, "ceiling"), BOX, (1.0, 1.0, 0.0))
    names = names_of(scene.placements)
    assert names["box_1"] == ("box",)
    assert names["pendant_lamp_1"][0] == "pendant lamp"
    for _ in range(8):
        scene = put(scene, LAMP, (1.0, 1.0, 2.0), 0.0, "ceiling")
    assert names_of(scene.placements)["pendant_lamp_4"] == ("lamp 4", "4")


def test_labels_of_neighbours_do_not_cover_each_other() -> None:
    things = [Labelled(f"t_{i}", ("a long name", "short"), (50 + 12.0 * i, 100, 60 + 12.0 * i, 110)) for i in range(6)]
    labels = laid_out(things, lambda text, font: (len(text) * font / 2, float(font)), size=400, fonts=(12, 10))
    boxes = [
        (
            at[0] - len(label.text) * label.font / 4,
            at[1] - label.font / 2,
            at[0] + len(label.text) * label.font / 4,
            at[1] + label.font / 2,
        )
        for label in labels
        for at in [label.at]
    ]
    for i, (left, top, right, bottom) in enumerate(boxes):
        for other in boxes[i + 1 :]:
            assert min(right, other[2]) <= max(left, other[0]) or min(bottom, other[3]) <= max(top, other[1])


def test_portraits_and_contact_sheets() -> None:
    picture = render_asset(BOX, size=64)
    assert picture.size == (64, 64)
    assert pixels(picture).std() > 10
    assert render_asset(BOX, size=64).tobytes() == picture.tobytes()
    sheet = contact_sheet([BOX, PICTURE, LAMP], columns=2, size=64)
    assert sheet.width == 128
    assert sheet.height > 128


TALL_BOX = asset("wardrobe", (0.6, 1.0, 2.0), front="one")
LIVED_IN = Surfaces(
    floor=Covering(laying="planks", colour=(0.7, 0.6, 0.5)),
    walls=Covering(laying="paint", colour=(0.9, 0.9, 0.9)),
    curtains=(0.2, 0.3, 0.6),
)


def test_a_tall_piece_on_a_cut_wall_is_seen_through() -> None:
    for wall in OPEN.walls:
        x, y = wall.point(wall.length / 2, 0.31)
        scene = put(Scene(room=OPEN), TALL_BOX, (x, y, 0.0), wall.yaw)
        view = best_view(scene)
        cut = not view.standing[OPEN.walls.index(wall)]
        assert in_the_way(scene, view.standing) == (frozenset({"wardrobe_1"}) if cut else frozenset())
        solid = cast(scene, view.camera, size=128, standing=view.standing).ids == 0
        empty, full = (pixels(render_preview(s, size=128))[solid] for s in (scene.without("wardrobe_1"), scene))
        if best_view(scene.without("wardrobe_1")).azimuth == view.azimuth:
            assert (np.abs(full - empty).mean() < 45) == cut


def test_what_a_tall_piece_on_a_cut_wall_carries_is_seen_through_with_it() -> None:
    wall = OPEN.walls[0]
    x, y = wall.point(2.5, 0.31)
    scene = put(Scene(room=OPEN), TALL_BOX, (x, y, 0.0), wall.yaw)
    scene = put(scene, asset("vase", (0.1, 0.1, 0.3), mount="surface"), (x, y, 2.0), 0.0, "wardrobe_1")
    low = put(scene, BOX, (1.8, 0.3, 0.0))
    assert in_the_way(low, (False, True, True, True)) - {"vase_1"} == {"wardrobe_1"}


def test_curtains_hang_where_nothing_stands_in_their_way() -> None:
    scene = Scene(room=structs.replace(OPEN, surfaces=LIVED_IN))
    wall, window = OPEN.walls[2], OPEN.openings[1]
    assert curtains_at(scene)["window_1"].bottom == pytest.approx(0.02)
    x, y = wall.point(window.offset - 0.1, 0.2)
    beside = curtains_at(put(scene, BOX, (x, y, 0.0), wall.yaw))["window_1"]
    x, y = wall.point(window.offset - 0.1 - TALL_BOX.size[1] / 2, 0.31)
    before = curtains_at(put(scene, TALL_BOX, (x, y, 0.0), wall.yaw))["window_1"]
    assert beside.bottom == pytest.approx(0.78)
    assert beside.beyond > before.beyond
    assert before.over > beside.over
    assert curtains_at(put(scene, asset("curtain", (0.1, 1.0, 2.0)), (1.0, 1.0, 0.0))) == {}
    assert curtains_at(Scene(room=OPEN)) == {}
    assert difference(render_preview(scene, size=128), render_preview(Scene(room=scene.room), size=128)) == 0
    bare = Scene(room=structs.replace(OPEN, surfaces=structs.replace(LIVED_IN, curtains=None)))
    assert difference(render_preview(scene, size=128), render_preview(bare, size=128)) > 0.2


def test_a_crowded_plan_has_numbers_and_a_list_of_what_they_mean() -> None:
    scene = Scene(room=rectangle(8.0, 8.0))
    for number in range(26):
        scene = put(scene, BOX, (1.0 + number % 6, 1.0 + number // 6, 0.0))
    scene = put(scene, TALL_BOX, (7.0, 7.0, 0.0))
    legend = legend_of(scene.placements, text_size, 1024, 15)
    assert legend.entries == ("1  box (26)", "2  wardrobe")
    labels = plan_numbers(scene, plan_of(scene.room), 1024, legend, ())
    assert sorted(label.text for label in labels) == ["1"] * 26 + ["2"]
    boxes = [(*label.at, *text_size(label.text, label.font)) for label in labels]
    assert not any(
        abs(a[0] - b[0]) < (a[2] + b[2]) / 2 and abs(a[1] - b[1]) < (a[3] + b[3]) / 2 for a, b in combinations(boxes, 2)
    )
    assert render_top(scene, size=256).size == (256, 256)
    assert MOST_NAMED == 25


def test_many_small_things_of_a_kind_on_one_share_a_number() -> None:
    shelf = asset("shelf", (2.0, 1.0, 1.0), surfaces=(Surface(name="top", position=(0.0, 0.0, 1.0), size=(2.0, 1.0)),))
    scene = put(Scene(room=rectangle(8.0, 8.0)), shelf, (4.0, 4.0, 0.0))
    for number in range(8):
        scene = put(scene, asset("jar", (0.1, 0.1, 0.2)), (3.2 + 0.2 * number, 4.0, 1.0), 0.0, "shelf_1")
    legend = legend_of(scene.placements, text_size, 512, 12)
    assert sorted(text for text, _ in numbered(scene.placements, legend)) == ["1", "2"]


def difference(first: object, second: object) -> float:
    return float(np.abs(pixels(first) - pixels(second)).mean())


def test_thin_lines_along_the_edges_of_a_room_are_no_dashes() -> None:
    """The number of rays that a line meets varies little with where it crosses the pixel."""
    places = _spread_over_pixel(Settings.edge_rays) - 0.5
    for slope in (-0.5, 0.5):
        across = (places[:, 1] - slope * places[:, 0]) / math.hypot(1.0, slope)
        met = [(np.abs(across - at) < 0.15).sum() for at in np.linspace(-0.4, 0.4, 41)]
        assert min(met) >= 1
        assert np.std(met) < 0.3 * np.mean(met)


def test_mirrors_show_what_is_before_them() -> None:
    assert MIRROR.colour == SILVER

    def redness(material: str) -> float:
        glass = Shape(kind="box", size=(0.02, 1.0, 1.0), position=(-0.5, 0.0, 0.5), colour=SILVER)
        red = Shape(
            kind="box", size=(0.6, 0.8, 0.1), position=(0.1, 0.0, 0.05), colour=(0.8, 0.1, 0.1), material="paper"
        )
        links = (Link(name="body", shapes=(structs.replace(glass, material=material), red)),)
        picture = np.asarray(render_asset(asset("mirror", (1.0, 1.0, 1.0), links=links), size=96)).astype(float)
        return float((picture[..., 0] - picture[..., 2] > 60).sum())

    assert redness("metal") > 1.2 * redness("paper")


def test_alike_things_over_each_other_have_one_label() -> None:
    scene = put(Scene(room=OPEN), BOX, (1.0, 1.0, 0.0))
    for x, z in ((1.0, 0.5), (1.0, 0.9), (1.3, 0.5)):
        scene = put(scene, LAMP, (x, 1.0, z), 0.0, "box_1")
    texts = [label.text.replace("\n", " ") for label in plan_labels(scene, plan_of(OPEN), 512)]
    assert len(texts) == 3
    assert any("1, 2" in text for text in texts)
