"""Relations as a table of small rooms, and their invariance when the whole room is moved and turned."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec import structs

from thinkblox.brief import RelationKind
from thinkblox.scene.asset import Asset, Link, Shape, Surface
from thinkblox.scene.landmarks import corners, things, walls
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec3

BED, NIGHTSTAND, CHAIR, TABLE = (2.0, 1.6, 0.5), (0.4, 0.45, 0.5), (0.5, 0.5, 0.9), (0.8, 1.6, 0.75)
WINDOW = Opening(id="window_1", kind="window", wall=1, offset=1.5, width=1.2, height=1.2, sill=0.9)
DOOR = Opening(id="door_1", kind="door", wall=0, offset=4.0, width=0.9, height=2.0)
ROOM = rectangle(6.0, 4.0, openings=(WINDOW, DOOR))


def thing(
    id: str,
    size: Vec3,
    x: float,
    y: float,
    yaw: float = 0.0,
    *,
    z: float = 0.0,
    front: str = "one",
    mount: str = "floor",
    collide: bool = True,
) -> tuple[Placement, Asset]:
    category = id.rpartition("_")[0]
    shape = Shape(kind="box", size=size, position=(0.0, 0.0, size[2] / 2), collide=collide)
    asset = Asset(
        id=f"{id}-asset",
        category=category,
        description=category,
        size=size,
        mass=5.0,
        friction=0.6,
        mount=mount,  # type: ignore[arg-type]
        front=front,  # type: ignore[arg-type]
        gaze="back" if category == "desk" else "front",
        links=(Link(name="body", shapes=(shape,)),),
        surfaces=(Surface(name="top", position=(0.0, 0.0, size[2]), size=size[:2]),),
    )
    placement = Placement(
        id=id, category=category, asset=asset.id, position=(x, y, z), yaw=yaw, size=size, support="floor"
    )
    return placement, asset


def scene_of(*objects: tuple[Placement, Asset], room: Room = ROOM) -> Scene:
    return Scene(room=room, placements=tuple(p for p, _ in objects), assets={a.id: a for _, a in objects})


# The bed's head is at the west wall, its own left is north.
BEDROOM = scene_of(
    thing("bed_1", BED, 1.02, 2.0),
    thing("nightstand_1", NIGHTSTAND, 0.22, 3.075),
    thing("nightstand_2", NIGHTSTAND, 0.22, 0.925),
    thing("lamp_1", (0.2, 0.2, 0.4), 0.22, 3.075, z=0.5, front="any", mount="surface"),
    thing("bench_1", (0.4, 1.2, 0.45), 2.3, 2.0, front="two"),
    thing("rug_1", (2.0, 2.4, 0.01), 1.6, 2.0, front="two", collide=False),
    thing("picture_1", (0.03, 0.8, 0.6), 0.015, 2.0, z=1.2, mount="wall"),
    thing("tv_1", (0.05, 1.2, 0.7), 5.975, 2.0, 180.0, z=1.0, mount="wall"),
    thing("mirror_1", (0.03, 1.0, 0.8), 5.98, 0.51, 180.0, z=1.0, mount="wall"),
    thing("plant_1", (0.4, 0.4, 1.0), 5.5, 3.5, front="any"),
    thing("desk_1", (0.6, 1.2, 0.75), 4.5, 3.65, -90.0),
    thing("chair_1", CHAIR, 4.5, 3.15, 90.0),
    thing("pendant_1", (0.3, 0.3, 0.3), 3.0, 2.0, z=2.3, front="any", mount="ceiling"),
)

HOLDS: list[tuple[RelationKind, str, tuple[str, ...]]] = [
    ("next_to", "nightstand_1", ("bed_1",)),
    ("left_of", "nightstand_1", ("bed_1",)),
    ("right_of", "nightstand_2", ("bed_1",)),
    ("on", "lamp_1", ("nightstand_1",)),
    ("on", "lamp_1", ("nightstand_2", "nightstand_1")),
    ("on", "bed_1", ("rug_1",)),
    ("at_foot_of", "bench_1", ("bed_1",)),
    ("in_front_of", "bench_1", ("bed_1",)),
    ("under", "rug_1", ("bed_1",)),
    ("above", "picture_1", ("bed_1",)),
    ("against_wall", "bed_1", ("wall",)),
    ("against_wall", "bed_1", ("west_wall",)),
    ("against_wall", "bed_1", ("short_wall",)),
    ("against_wall", "desk_1", ("long_wall",)),
    ("against_wall", "nightstand_1", ()),
    ("on", "tv_1", ("wall",)),
    ("on", "mirror_1", ("east_wall",)),
    ("on", "picture_1", ("short_wall",)),
    ("facing", "bed_1", ("tv_1",)),
    ("facing", "chair_1", ("desk_1",)),
    ("facing", "desk_1", ("north_wall",)),
    ("facing", "bed_1", ("window",)),
    ("facing", "plant_1", ("bed_1",)),
    ("opposite", "tv_1", ("bed_1",)),
    ("opposite", "tv_1", ("picture_1",)),
    ("in_corner", "plant_1", ("corner",)),
    ("in_corner", "plant_1", ("north_wall", "east_wall")),
    ("in_corner", "plant_1", ("north_wall",)),
    ("on", "plant_1", ("floor",)),
    ("at", "chair_1", ("desk_1",)),
    ("near", "plant_1", ("window",)),
    ("next_to", "desk_1", ("window_1", "plant_1")),
    ("between", "bench_1", ("picture_1", "tv_1")),
    ("in_centre", "pendant_1", ("centre",)),
    ("near", "chair_1", ("plant_1",)),
]
FAILS: list[tuple[RelationKind, str, tuple[str, ...]]] = [
    ("next_to", "plant_1", ("bed_1",)),
    ("next_to", "lamp_1", ("nightstand_1",)),
    ("left_of", "nightstand_2", ("bed_1",)),
    ("on", "lamp_1", ("nightstand_2",)),
    ("on", "chair_1", ("desk_1",)),
    ("on", "bed_1", ("wall",)),
    ("on", "mirror_1", ("south_wall",)),
    ("at_foot_of", "nightstand_1", ("bed_1",)),
    ("behind", "bench_1", ("bed_1",)),
    ("under", "bed_1", ("rug_1",)),
    ("above", "lamp_1", ("bed_1",)),
    ("against_wall", "bed_1", ("long_wall",)),
    ("against_wall", "bench_1", ("wall",)),
    ("facing", "chair_1", ("bed_1",)),
    ("opposite", "bench_1", ("bed_1",)),
    ("in_corner", "bench_1", ("corner",)),
    ("in_corner", "plant_1", ("south_wall", "east_wall")),
    ("in_corner", "plant_1", ("west_wall",)),
    ("on", "lamp_1", ("floor",)),
    ("at", "chair_1", ("bed_1",)),
    ("between", "plant_1", ("picture_1", "tv_1")),
    ("between", "bench_1", ("bed_1",)),
    ("in_centre", "plant_1", ("centre",)),
    ("near", "plant_1", ("bed_1",)),
    ("near", "plant_1", ("wardrobe_1",)),
    ("next_to", "sofa_1", ("bed_1",)),
    ("around", "sofa_1", ("bed_1",)),
]


@pytest.mark.parametrize(("kind", "subject", "anchors"), HOLDS)
def test_holds(kind: RelationKind, subject: str, anchors: tuple[str, ...]) -> None:
    result = measure(BEDROOM, kind, subject, anchors)
    assert result.holds, result.measured


@pytest.mark.parametrize(("kind", "subject", "anchors"), FAILS)
def test_fails(kind: RelationKind, subject: str, anchors: tuple[str, ...]) -> None:
    result = measure(BEDROOM, kind, subject, anchors)
    assert not result.holds, result.measured


@pytest.mark.parametrize(
    ("x", "y", "holds", "denied"), [(4.5, 3.5, True, False), (3.3, 3.2, True, False), (2.6, 3.1, False, False)]
)
def test_in_the_middle_is_about_the_middle(x: float, y: float, holds: bool, denied: bool) -> None:
    barrow = thing("barrow_1", (1.25, 0.55, 0.6), x, y)
    scene = scene_of(barrow, room=rectangle(9.0, 7.0))
    assert measure(scene, "in_centre", "barrow_1", ()).holds == holds
    assert measure(scene, "in_centre", "barrow_1", (), negated=True).holds == denied


@pytest.mark.parametrize(("aside", "holds"), [(0.0, True), (0.25, True), (0.4, False)])
def test_in_the_middle_of_a_long_top_is_near_its_middle(aside: float, holds: bool) -> None:
    bench = thing("bench_1", (0.7, 2.4, 0.8), 3.0, 2.0)
    tray = thing("tray_1", (0.3, 0.4, 0.05), 3.0, 2.0 + aside, z=0.8, mount="surface")
    assert measure(scene_of(bench, tray), "in_centre", "tray_1", ("bench_1",)).holds == holds


@pytest.mark.parametrize(
    ("x", "y", "yaw", "holds"), [(0.015, 2.6, 0.0, True), (1.5, 0.015, 90.0, False), (1.1, 0.015, 90.0, False)]
)
def test_behind_a_desk_on_the_wall_is_on_that_at_its_back(x: float, y: float, yaw: float, holds: bool) -> None:
    desk = thing("counter_1", (1.0, 2.2, 1.1), 1.5, 1.12)
    clock = thing("clock_1", (0.03, 0.3, 0.3), x, min(y, 1.9), yaw, z=1.8, mount="wall")
    assert measure(scene_of(desk, clock), "behind", "clock_1", ("counter_1",)).holds == holds


def test_says_what_was_measured() -> None:
    assert (
        measure(BEDROOM, "next_to", "nightstand_1", ["bed_1"]).measured
        == "gap 0.05 m, nightstand_1 to the left of bed_1"
    )
    assert measure(BEDROOM, "near", "plant_1", ["wardrobe_1"]).measured == "wardrobe_1 is not in the room"


def test_a_whole_request_holds_only_when_every_member_does() -> None:
    assert measure(BEDROOM, "next_to", ["nightstand_1", "nightstand_2"], ["bed_1"]).holds
    assert not measure(BEDROOM, "next_to", ["nightstand_1", "plant_1"], ["bed_1"]).holds


def test_each_wants_one_for_every_anchor() -> None:
    assert measure(BEDROOM, "on", "lamp_1", ["nightstand_1", "nightstand_2"]).holds
    assert not measure(BEDROOM, "on", "lamp_1", ["nightstand_1", "nightstand_2"], each=True).holds
    assert not measure(BEDROOM, "in_corner", "plant_1", ["corner"], each=True).holds


def chairs_round(angles: list[float], distance: float = 0.9, *, turned: float = 180.0) -> Scene:
    table = thing("table_1", (1.2, 1.2, 0.75), 3.0, 2.0, front="any")
    chairs = [
        thing(
            f"chair_{i}",
            CHAIR,
            3.0 + distance * math.cos(math.radians(a)),
            2.0 + distance * math.sin(math.radians(a)),
            a + turned,
        )
        for i, a in enumerate(angles, 1)
    ]
    return scene_of(table, *chairs)


@pytest.mark.parametrize(
    ("angles", "distance", "turned", "holds"),
    [
        ([0, 90, 180, 270], 0.9, 180.0, True),
        ([0, 120, 240], 0.9, 180.0, True),
        ([0, 90, 180], 0.9, 180.0, True),
        ([0, 180], 0.9, 180.0, True),
        ([0, 90], 0.9, 180.0, True),
        ([0, 20], 0.9, 180.0, False),
        ([0, 45, 90], 0.9, 180.0, False),
        ([0, 90, 180, 270], 1.6, 180.0, False),
        ([0, 90, 180, 270], 0.9, 0.0, False),
    ],
)
def test_around(angles: list[float], distance: float, turned: float, holds: bool) -> None:
    scene = chairs_round(angles, distance, turned=turned)
    ids = [p.id for p in scene.placements[1:]]
    assert measure(scene, "around", ids, ["table_1"]).holds is holds


def test_around_shares_seats_between_several_tables() -> None:
    near, far = (thing(f"table_{i}", (0.8, 0.8, 0.75), 1.5 * i, 2.0, front="two") for i in (1, 3))
    chairs = [
        thing(f"chair_{2 * i + j}", CHAIR, 1.5 * (1, 3)[i], 2.0 + (j * 2 - 1) * 0.6, 90.0 - (j * 2 - 1) * 180.0)
        for i in (0, 1)
        for j in (0, 1)
    ]
    ids = [p.id for p, _ in chairs]
    assert not measure(scene_of(near, far, *chairs), "around", ids, ["table_1", "table_3"]).holds
    mended = [(structs.replace(p, yaw=90.0 if p.position[1] < 2.0 else -90.0), a) for p, a in chairs]
    assert measure(scene_of(near, far, *mended), "around", ids, ["table_1", "table_3"]).holds
    assert not measure(scene_of(near, far, *mended[:2]), "around", ids[:2], ["table_1", "table_3"]).holds


def grid(columns: list[float], lines: list[float], yaw: float = 90.0) -> Scene:
    desks = [
        thing(f"desk_{i}", (0.5, 0.6, 0.7), x, y, yaw)
        for i, (x, y) in enumerate(((x, y) for y in lines for x in columns), 1)
    ]
    return scene_of(*desks)


@pytest.mark.parametrize(
    ("columns", "lines", "rows", "holds"),
    [
        ([1.0, 2.0, 3.0, 4.0], [0.5, 1.5, 2.5], 3, True),
        ([1.0, 2.0, 3.5, 4.5], [0.5, 1.5, 2.5], 3, True),
        ([1.0, 2.0, 3.0, 4.0], [0.5, 1.5, 2.5], 0, True),
        ([1.0, 2.0, 3.0, 4.0], [0.5, 1.5, 2.5], 2, False),
        ([1.0, 1.7, 3.0, 4.4], [0.5, 1.5], 2, False),
        ([1.0, 2.0, 3.0], [1.0], 1, True),
    ],
)
def test_in_rows(columns: list[float], lines: list[float], rows: int, holds: bool) -> None:
    scene = grid(columns, lines)
    assert measure(scene, "in_rows", [p.id for p in scene.placements], (), rows=rows).holds is holds


def test_scattered_things_make_no_rows() -> None:
    spots = [(1.0, 1.0), (1.4, 2.6), (3.1, 0.7), (4.2, 1.9), (5.0, 3.1), (2.4, 3.4)]
    scene = scene_of(*(thing(f"desk_{i}", (0.5, 0.6, 0.7), x, y) for i, (x, y) in enumerate(spots, 1)))
    assert not measure(scene, "in_rows", [p.id for p in scene.placements], ()).holds


def test_between_two_rows_of_chairs() -> None:
    rows = [thing(f"chair_{i}", CHAIR, 1.0 + 0.6 * i, 1.0, 90.0) for i in range(5)]
    rows += [thing(f"chair_{i + 5}", CHAIR, 1.0 + 0.6 * i, 3.0, -90.0) for i in range(5)]
    scene = scene_of(
        *rows, thing("table_1", (0.5, 1.0, 0.4), 2.2, 2.0, 90.0), thing("plant_1", (0.3, 0.3, 1), 5.0, 2.0)
    )
    ids = [p.id for p, _ in rows]
    assert measure(scene, "between", "table_1", ids).holds
    assert not measure(scene, "between", "plant_1", ids).holds
    assert measure(scene, "facing", ids, ids).holds
    assert measure(scene, "facing", ids, ()).holds
    assert not measure(scene.moved("chair_0", yaw=0.0), "facing", ids, ()).holds


def test_every_class_desk_faces_the_board_that_it_does_not_look_past() -> None:
    scene = grid([1.7, 2.5, 3.5, 4.3], [0.5, 1.5], yaw=-90.0)  # sat at from the south
    board = thing("whiteboard_1", (0.05, 2.0, 1.2), 3.0, 3.975, -90.0, z=0.9, mount="wall")
    scene = scene.with_placement(*board)
    ids = [p.id for p in scene.placements[:-1]]
    assert measure(scene, "facing", ids, ["whiteboard_1"]).holds
    assert not measure(scene.moved("desk_1", yaw=90.0), "facing", ids, ["whiteboard_1"]).holds
    aside = scene.moved("desk_1", position=(0.4, 3.2, 0.0))
    assert not measure(aside, "facing", ids, ["whiteboard_1"]).holds


def test_an_inner_corner_is_no_corner() -> None:
    room = Room(floor=((0, 0), (5, 0), (5, 2), (2, 2), (2, 5), (0, 5)))
    assert [c.centre for c in corners(room)] == [(0, 0), (5, 0), (5, 2), (2, 5), (0, 5)]
    assert [w.length for w in walls(room, "long_wall")] == [5.0, 5.0]
    assert [w.name for w in walls(room, "north_wall")] == ["north_wall", "north_wall_2"]
    assert things(Scene(room=room), "cellar") == ()


def turned(scene: Scene, angle: float) -> Scene:
    """The whole room turned and put back with its bounding box at the origin."""
    cos, sin = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    floor = [(x * cos - y * sin, x * sin + y * cos) for x, y in scene.room.floor]
    x0, y0 = min(x for x, _ in floor), min(y for _, y in floor)
    room = structs.replace(scene.room, floor=tuple((x - x0, y - y0) for x, y in floor))
    placements = tuple(
        structs.replace(
            p,
            position=(
                p.position[0] * cos - p.position[1] * sin - x0,
                p.position[0] * sin + p.position[1] * cos - y0,
                p.position[2],
            ),
            yaw=p.yaw + angle,
        )
        for p in scene.placements
    )
    return structs.replace(scene, room=room, placements=placements)


COMPASS = ("north_wall", "east_wall", "south_wall", "west_wall", "in_centre")


@given(angle=st.floats(-360.0, 360.0))
def test_turning_the_whole_room_changes_nothing(angle: float) -> None:
    other = turned(BEDROOM, angle)
    for kind, subject, anchors in (*HOLDS, *FAILS):
        if not {kind, *anchors} & set(COMPASS):
            before, after = measure(BEDROOM, kind, subject, anchors), measure(other, kind, subject, anchors)
            assert before.holds == after.holds, (before.measured, after.measured)


@given(x=st.floats(0.5, 5.5), y=st.floats(0.5, 3.5), yaw=st.floats(-180.0, 180.0), angle=st.floats(0.0, 360.0))
def test_rows_turn_with_their_room(x: float, y: float, yaw: float, angle: float) -> None:
    scene = grid([1.0, 2.0, 3.0], [0.5, 1.5], yaw=0.0).with_placement(*thing("desk_7", (0.5, 0.6, 0.7), x, y, yaw))
    ids = [p.id for p in scene.placements[:-1]]
    assert (
        measure(scene, "in_rows", ids, (), rows=2).holds
        == measure(turned(scene, angle), "in_rows", ids, (), rows=2).holds
    )


@pytest.mark.parametrize(
    ("kind", "depth", "height", "x", "y", "holds"),
    [
        ("under", 0.6, 0.75, 5.6, 2.1, True),
        ("under", 0.6, 0.75, 5.6, 3.2, False),  # More of it beside the window than below.
        ("under", 0.6, 0.75, 4.6, 2.1, False),  # Away from the wall.
        ("under", 0.6, 1.80, 5.6, 2.1, False),  # It hides the window.
        ("in_front_of", 0.6, 1.80, 5.6, 2.1, True),
        ("in_front_of", 0.6, 1.80, 5.2, 3.2, False),
        ("in_front_of", 0.6, 0.75, 4.0, 2.1, False),
    ],
)
def test_what_is_under_a_window_is_before_more_of_it_than_beside(
    kind: RelationKind, depth: float, height: float, x: float, y: float, holds: bool
) -> None:
    scene = scene_of(thing("chest_1", (depth, 1.0, height), x, y, 180.0))
    assert measure(scene, kind, "chest_1", ("window",)).holds is holds


def test_what_is_opposite_looks_about_at_the_middle_of_the_other() -> None:
    across = thing("bench_1", (0.4, 1.2, 0.45), 0.2, 1.0)
    for y, holds in ((1.0, True), (2.4, True), (3.2, False)):
        scene = scene_of(across, thing("cabinet_1", (0.4, 1.0, 1.8), 2.2, y, 180.0))
        assert measure(scene, "opposite", "cabinet_1", ("bench_1",)).holds is holds


def test_nothing_of_what_must_not_be_under_a_thing_is_under_it() -> None:
    bed, rug = thing("bed_1", BED, 1.02, 2.0), (2.0, 2.4, 0.01)
    for x, free in ((3.1, True), (2.9, False)):
        scene = scene_of(bed, thing("rug_1", rug, x, 2.0, front="two", collide=False))
        assert measure(scene, "under", "rug_1", ("bed_1",), negated=True).holds is free


@pytest.mark.parametrize(("yaw", "holds"), [(180.0, True), (0.0, True), (90.0, False)])
def test_what_is_across_from_a_thing_faces_it_or_has_its_back_to_it(yaw: float, holds: bool) -> None:
    """A treadmill that faces a wall is across from the rack that faces it; one that stands askew is not."""
    rack = thing("rack_1", (0.4, 1.2, 0.9), 0.2, 2.0)
    scene = scene_of(rack, thing("treadmill_1", (1.6, 0.8, 1.3), 3.4, 2.0, yaw))
    assert measure(scene, "opposite", "treadmill_1", ("rack_1",)).holds is holds


def test_what_looks_past_the_middle_of_a_thing_does_not_face_it() -> None:
    backdrop = thing("backdrop_1", (0.3, 2.6, 2.1), 0.2, 2.0)
    for y, holds in ((2.0, True), (3.2, True), (4.2, False)):
        scene = scene_of(backdrop, thing("lamp_1", (0.4, 0.4, 1.8), 2.4, y, 180.0))
        assert measure(scene, "facing", "lamp_1", ("backdrop_1",)).holds is holds


def test_a_rug_under_a_bean_bag_is_under_half_of_it() -> None:
    bag = thing("bean_bag_1", (0.8, 0.8, 0.7), 1.0, 2.0)
    for x, holds in ((1.9, True), (2.2, False)):
        scene = scene_of(bag, thing("rug_1", (2.0, 2.4, 0.01), x, 2.0, front="two", collide=False))
        assert measure(scene, "under", "rug_1", ("bean_bag_1",)).holds is holds
