"""Relations that sentences ask for besides the usual ones, each true and false in rooms put together by hand."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec import structs

from tests.test_relations import CHAIR, ROOM, scene_of, thing, turned
from thinkblox.assets.make import make_asset
from thinkblox.brief import RelationKind
from thinkblox.scene.asset import Asset, Surface
from thinkblox.scene.free_parts import measure_free
from thinkblox.scene.placement import Placement
from thinkblox.scene.relations import measure
from thinkblox.scene.room import Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.value import Vec3

TABLE = (0.8, 1.6, 0.75)
SIDES: tuple[RelationKind, ...] = ("at_long_side", "at_short_side")


def case(id: str, size: Vec3, x: float, y: float, yaw: float = 0.0) -> tuple[Placement, Asset]:
    """A bookcase with one inner shelf at half its height."""
    placement, asset = thing(id, size, x, y, yaw)
    shelf = Surface(name="shelf", position=(0.0, 0.0, size[2] / 2), size=size[:2], headroom=0.4)
    return placement, structs.replace(asset, surfaces=(shelf, *asset.surfaces))


CUP: Vec3 = (0.1, 0.1, 0.1)
SHELVED = scene_of(
    case("bookcase_1", (0.3, 0.8, 1.0), 0.17, 2.0),
    thing("cup_1", CUP, 0.17, 2.0, z=0.5, front="any", mount="surface"),
    thing("cup_2", CUP, 0.17, 2.0, z=1.0, front="any", mount="surface"),
    thing("cup_3", CUP, 0.17, 2.3, z=0.0, front="any", mount="surface"),
    thing("cup_4", CUP, 0.5, 2.0, z=0.0, front="any", mount="surface"),
    thing("cup_5", CUP, 1.5, 2.0, z=0.0, front="any", mount="surface"),
    thing("lamp_1", (0.3, 0.3, 0.3), 3.0, 2.0, z=2.3, front="any", mount="ceiling"),
    thing("lamp_2", (0.3, 0.3, 0.3), 3.0, 2.0, z=2.2, front="any", mount="ceiling"),
    thing("clock_1", (0.2, 0.2, 0.2), 0.17, 2.0, z=1.0, front="any", mount="surface"),
    thing("stool_1", (0.3, 0.3, 0.4), 0.6, 2.0, front="any"),
    thing("plant_1", (0.3, 0.3, 0.5), 5.8, 0.2, front="any"),
)
HOLDS: list[tuple[RelationKind, str, tuple[str, ...]]] = [
    ("inside", "cup_1", ("bookcase_1",)),
    ("on", "cup_2", ("bookcase_1",)),
    ("outside", "cup_4", ("bookcase_1",)),
    ("on", "lamp_1", ("ceiling",)),
    ("far", "plant_1", ("bookcase_1",)),
    ("far", "bookcase_1", ("door",)),
    ("next_to", "cup_4", ("bookcase_1",)),
    ("in_centre", "cup_2", ("bookcase_1",)),
    ("in_centre", "bookcase_1", ("west_wall",)),
]
FAILS: list[tuple[RelationKind, str, tuple[str, ...]]] = [
    ("inside", "cup_2", ("bookcase_1",)),
    ("inside", "cup_3", ("bookcase_1",)),
    ("inside", "cup_4", ("bookcase_1",)),
    ("inside", "cup_1", ("stool_1",)),
    ("inside", "cup_1", ("door",)),
    ("outside", "cup_1", ("bookcase_1",)),
    ("outside", "cup_5", ("bookcase_1",)),
    ("on", "lamp_2", ("ceiling",)),
    ("on", "cup_2", ("ceiling",)),
    ("far", "stool_1", ("bookcase_1",)),
    ("far", "plant_1", ("door",)),
    ("next_to", "clock_1", ("stool_1",)),
    ("in_centre", "cup_4", ("bookcase_1",)),
    ("in_centre", "plant_1", ("east_wall",)),
]


@pytest.mark.parametrize(("kind", "subject", "anchors"), HOLDS)
def test_holds(kind: RelationKind, subject: str, anchors: tuple[str, ...]) -> None:
    assert (found := measure(SHELVED, kind, subject, anchors)).holds, found.measured
    assert not measure(SHELVED, kind, subject, anchors, negated=True).holds


@pytest.mark.parametrize(("kind", "subject", "anchors"), FAILS)
def test_fails(kind: RelationKind, subject: str, anchors: tuple[str, ...]) -> None:
    assert not (found := measure(SHELVED, kind, subject, anchors)).holds, found.measured
    if subject != "clock_1":  # right above, which is too close for what must not be next to it
        assert measure(SHELVED, kind, subject, anchors, negated=True).holds


@given(angle=st.floats(-360.0, 360.0))
def test_turning_the_whole_room_changes_nothing(angle: float) -> None:
    other = turned(SHELVED, angle)
    for kind, subject, anchors in (*HOLDS, *FAILS):
        if not {"west_wall", "east_wall"} & set(anchors):
            before, after = measure(SHELVED, kind, subject, anchors), measure(other, kind, subject, anchors)
            assert before.holds == after.holds, (before.measured, after.measured)


@given(x=st.floats(-3.0, 3.0), y=st.floats(-2.0, 2.0), yaw=st.floats(0.0, 360.0))
def test_a_thing_is_at_one_kind_of_side_at_most(x: float, y: float, yaw: float) -> None:
    scene = at_table((x, y, yaw))
    long, short = (measure(scene, kind, "chair_1", ["table_1"]).holds for kind in SIDES)
    assert not (long and short)
    assert not ((long or short) and measure(scene, "far", "chair_1", ["table_1"]).holds)


def at_table(*seats: tuple[float, float, float]) -> Scene:
    """Chairs by a table of 0.8 by 1.6 m in the middle of the room, its long sides to the east and west."""
    chairs = [thing(f"chair_{n}", CHAIR, 3.0 + x, 2.0 + y, yaw) for n, (x, y, yaw) in enumerate(seats, 1)]
    return scene_of(thing("table_1", TABLE, 3.0, 2.0, front="two"), *chairs)


EAST, WEST, NORTH = (0.6, 0.4, 180.0), (-0.6, -0.4, 0.0), (0.0, 1.0, -90.0)


@pytest.mark.parametrize(
    ("seats", "kind", "holds"),
    [
        ([EAST, WEST], "at_long_side", True),
        ([EAST, WEST, (0.6, -0.4, 180.0)], "at_long_side", True),
        ([EAST, (0.6, -0.4, 180.0)], "at_long_side", False),
        ([EAST, NORTH], "at_long_side", False),
        ([EAST], "at_long_side", True),
        ([NORTH], "at_long_side", False),
        ([NORTH], "at_short_side", True),
        ([EAST], "at_short_side", False),
        ([(1.4, 0.4, 180.0)], "at_long_side", False),
        ([(0.9, 1.2, 180.0)], "at_long_side", False),
    ],
)
def test_sides_of_a_table(seats: list[tuple[float, float, float]], kind: RelationKind, holds: bool) -> None:
    scene = at_table(*seats)
    found = measure(scene, kind, [p.id for p in scene.placements[1:]], ["table_1"])
    assert found.holds is holds, found.measured


@pytest.mark.parametrize(
    ("apart", "turn", "holds"), [(0.7, 0.0, True), (1.2, 0.0, False), (0.7, 180.0, False), (0.7, 90.0, False)]
)
def test_back_to_back(apart: float, turn: float, holds: bool) -> None:
    scene = scene_of(thing("sofa_1", CHAIR, 3.0, 2.0, 180.0), thing("sofa_2", CHAIR, 3.0 + apart, 2.0, turn))
    assert measure(scene, "back_to_back", ["sofa_1", "sofa_2"], ()).holds is holds
    assert measure(scene, "back_to_back", "sofa_1", ["sofa_2"]).holds is holds


@pytest.mark.parametrize(("turn", "holds"), [(180.0, True), (140.0, True), (90.0, False), (0.0, False)])
def test_a_back_is_to_what_one_does_not_face(turn: float, holds: bool) -> None:
    scene = scene_of(thing("chair_1", CHAIR, 3.0, 2.0, turn), thing("chair_2", CHAIR, 4.2, 2.0, 0.0))
    assert measure(scene, "facing_away", "chair_1", ["chair_2"]).holds is holds


def shelves(*spots: tuple[float, float, float]) -> Scene:
    return scene_of(*(thing(f"shelf_{n}", (0.3, 0.8, 1.8), x, y, yaw) for n, (x, y, yaw) in enumerate(spots, 1)))


def test_over_so_many_walls() -> None:
    two = shelves((0.15, 2.0, 0.0), (0.15, 3.0, 0.0), (3.0, 3.85, -90.0))
    ids = [p.id for p in two.placements]
    assert measure(two, "against_wall", ids, ["wall"], spread=2).holds
    assert not measure(two, "against_wall", ids, ["wall"], spread=3).holds
    assert not measure(two, "against_wall", ids[:2], ["wall"], spread=2).holds
    assert not measure(two, "against_wall", ids, ["one_wall"]).holds
    assert measure(two, "against_wall", ids[:2], ["one_wall"]).holds


def test_denied_of_a_wall_is_stricter_than_asked_for() -> None:
    turned = shelves((0.5, 2.0, 90.0))
    assert not measure(turned, "against_wall", "shelf_1", ["wall"]).holds
    assert not measure(turned, "against_wall", "shelf_1", ["wall"], negated=True).holds


def test_what_is_not_in_the_room_is_not_next_to_anything() -> None:
    bare = shelves((0.15, 2.0, 0.0))
    assert measure(
        Scene(room=rectangle(4, 4), placements=bare.placements, assets=bare.assets),
        "near",
        "shelf_1",
        ["window"],
        negated=True,
    ).holds
    assert not measure(bare, "near", "shelf_9", ["door"], negated=True).holds


def test_far_is_less_far_in_a_small_room() -> None:
    plant, stool = thing("plant_1", (0.3, 0.3, 1.0), 0.2, 0.2), thing("stool_1", (0.3, 0.3, 0.4), 2.8, 1.8)
    small, large = rectangle(3.0, 2.0), ROOM
    assert measure(scene_of(plant, stool, room=small), "far", "plant_1", ["stool_1"]).holds
    assert not measure(scene_of(plant, stool, room=large), "far", "plant_1", ["stool_1"]).holds


@pytest.mark.parametrize(("x", "holds"), [(1.2, True), (2.6, False)])
def test_in_front_of_ends_soon(x: float, holds: bool) -> None:
    scene = scene_of(thing("bed_1", (2.0, 1.6, 0.5), 1.0, 2.0), thing("chest_1", CHAIR, 2.25 + x, 2.0))
    assert measure(scene, "in_front_of", "chest_1", ["bed_1"]).holds is holds


def test_visitors_sit_before_a_desk_too() -> None:
    desk = thing("desk_1", (0.7, 1.6, 0.75), 3.0, 2.0, -90.0)  # worked at from the south, looking north
    visitor, stray = thing("chair_1", CHAIR, 3.0, 3.0, -90.0), thing("chair_2", CHAIR, 3.0, 3.0, 90.0)
    assert measure(scene_of(desk, visitor), "in_front_of", "chair_1", ["desk_1"]).holds
    assert not measure(scene_of(desk, stray), "in_front_of", "chair_2", ["desk_1"]).holds


@pytest.mark.parametrize(
    ("spot", "place", "free"),
    [
        ((3.0, 2.0), "centre", False),
        ((0.5, 2.0), "centre", True),
        ((0.5, 2.0), "west_wall", False),
        ((0.8, 2.0), "west_wall", True),
        ((0.5, 2.0), "wall", True),
        ((5.7, 2.1), "window", False),
        ((4.4, 0.5), "door", False),
        ((0.5, 0.5), "corner", True),
    ],
)
def test_parts_that_stay_free(spot: tuple[float, float], place: str, free: bool) -> None:
    scene = scene_of(thing("chair_1", (0.5, 0.5, 1.2), *spot))
    holds, says = measure_free(scene, place)
    assert holds is free, says
    assert measure_free(scene, place, besides=frozenset({"chair_1"}))[0]


def test_rugs_and_lamps_leave_the_middle_free() -> None:
    rug = thing("rug_1", (2.0, 3.0, 0.01), 3.0, 2.0, collide=False)
    lamp = thing("lamp_1", (0.3, 0.3, 0.3), 3.0, 2.0, z=2.3, mount="ceiling")
    assert measure_free(scene_of(rug, lamp), "centre")[0]


def test_a_cupboard_has_an_inside_behind_its_doors() -> None:
    wardrobe = make_asset("wardrobe", seed=1)
    assert any(surface.within for surface in wardrobe.surfaces)
    assert Room(floor=((0, 0), (4, 0), (4, 4), (0, 4))).height > wardrobe.size[2]
