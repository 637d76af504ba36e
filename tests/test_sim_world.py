import math

import mujoco
import pytest
from msgspec import structs

from tests.sim_rooms import asset, box, put, scene, table, vase, wardrobe
from thinkblox.scene.actions import Move
from thinkblox.scene.asset import Asset, Shape
from thinkblox.scene.placement import Placement
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.sim.settings import Physics
from thinkblox.sim.verdict.world import World
from thinkblox.verdict import Verdict

CRATE = asset("crate", (0.5, 0.5, 0.5))
L_ROOM = Room(floor=((0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)))
DOOR = Opening(id="door_1", kind="door", wall=0, offset=1.0, width=0.9, height=2.05)
WINDOW = Opening(id="window_1", kind="window", wall=2, offset=1.0, width=1.5, height=1.2, sill=0.9)


def check(where: Scene, candidate: Placement, kind: Asset, *, way: bool = True) -> Verdict:
    return World(where).check([candidate], kind, way=way)[0]


def test_a_box_that_stands_free_is_valid_and_carried_by_the_floor() -> None:
    verdict = check(scene(), put(CRATE, 2.0, 2.0), CRATE)
    assert verdict.valid
    assert verdict.settled
    assert {s.by: s.share for s in verdict.supports} == pytest.approx({"floor": 1.0}, abs=0.01)
    assert max(verdict.drift, verdict.drop) < 1e-4


@pytest.mark.parametrize("depth", [0.002, 0.01, 0.1])
def test_overlap_is_measured_in_depth_and_volume(depth: float) -> None:
    other = put(CRATE, 2.0, 2.0, id="crate_1")
    verdict = check(scene(None, (other, CRATE)), put(CRATE, 2.5 - depth, 2.0, id="crate_2"), CRATE)
    assert verdict.reasons == ("collision",)
    assert not verdict.settled
    assert verdict.depth == pytest.approx(depth, abs=0.0005)
    assert verdict.overlap == pytest.approx(depth / 0.5, rel=0.01)
    assert verdict.collisions[0].other == "crate_1"


def test_a_collision_within_the_tolerance_is_a_touch() -> None:
    other = put(CRATE, 2.0, 2.0, id="crate_1")
    verdict = check(scene(None, (other, CRATE)), put(CRATE, 2.4995, 2.0, id="crate_2"), CRATE)
    assert verdict.valid
    assert verdict.depth == 0.0


@pytest.mark.parametrize(
    ("x", "y", "z", "outside"),
    [(0.245, 2.0, 0.0, 0.005), (2.0, 4.76, 0.0, 0.01), (2.0, 2.0, 2.2, 0.1), (2.0, 2.0, -0.02, 0.02)],
)
def test_reaching_out_of_the_room_is_measured(x: float, y: float, z: float, outside: float) -> None:
    verdict = check(scene(), put(CRATE, x, y, z), CRATE)
    assert "outside" in verdict.reasons
    assert verdict.outside == pytest.approx(outside, abs=1e-6)


def test_far_away_is_outside_and_nothing_worse() -> None:
    verdict = check(scene(), put(CRATE, -900.0, 900.0, 40.0), CRATE)
    assert verdict.reasons == ("outside",)


def test_the_inner_corner_of_an_l_shaped_room() -> None:
    assert check(scene(L_ROOM), put(CRATE, 1.75, 1.75), CRATE).valid
    assert check(scene(L_ROOM), put(CRATE, 1.749, 2.25), CRATE).valid
    verdict = check(scene(L_ROOM), put(CRATE, 1.80, 1.80), CRATE)
    assert verdict.reasons == ("outside",)
    assert verdict.outside == pytest.approx(0.05, abs=1e-6)
    edge_on = check(scene(L_ROOM), put(CRATE, 1.85, 1.85, yaw=45.0), CRATE)
    assert edge_on.outside == pytest.approx(0.25 - 0.15 * 2**0.5, abs=1e-6)


def test_a_lamp_on_a_table_is_carried_by_it() -> None:
    room = scene(None, (put(table(), 2.0, 2.0), table()))
    verdict = check(room, put(vase(), 2.0, 2.0, 0.751, on="table_1"), vase())
    assert verdict.valid
    assert {s.by: s.share for s in verdict.supports} == pytest.approx({"table_1": 1.0}, abs=0.02)


def test_sunk_into_the_table_is_a_collision() -> None:
    room = scene(None, (put(table(), 2.0, 2.0), table()))
    verdict = check(room, put(vase(), 2.0, 2.0, 0.747, on="table_1"), vase())
    assert verdict.reasons == ("collision",)
    assert verdict.depth == pytest.approx(0.003, abs=0.0005)
    assert verdict.overlap == pytest.approx(0.01, rel=0.01)


def test_over_the_edge_by_one_centimetre_tilts() -> None:
    room = scene(None, (put(table(), 2.0, 2.0), table()))
    assert check(room, put(vase(), 2.59, 2.0, 0.75, on="table_1"), vase()).valid
    verdict = check(room, put(vase(), 2.61, 2.0, 0.75, on="table_1"), vase())
    assert "tilt" in verdict.reasons
    assert verdict.tilt > 10.0


def test_floating_drops() -> None:
    assert check(scene(), put(CRATE, 2.0, 2.0, 0.012), CRATE).valid
    verdict = check(scene(), put(CRATE, 2.0, 2.0, 0.03), CRATE)
    assert verdict.reasons == ("drop",)
    assert verdict.drop == pytest.approx(0.03, abs=0.001)
    assert check(scene(), put(CRATE, 2.0, 2.0, 1.0), CRATE).reasons == ("drop",)


def test_a_plank_on_two_blocks_is_carried_by_halves() -> None:
    plank = asset("plank", (1.4, 0.2, 0.04), mass=5.0, mount="surface")
    blocks = [(put(CRATE, x, 2.0, id=f"crate_{i}"), CRATE) for i, x in enumerate((1.5, 2.5))]
    verdict = check(scene(None, *blocks), put(plank, 2.0, 2.0, 0.5, on="crate_0"), plank)
    assert verdict.valid
    assert {s.by: s.share for s in verdict.supports} == pytest.approx({"crate_0": 0.5, "crate_1": 0.5}, abs=0.02)


PICTURE = asset("picture", (0.03, 0.6, 0.4), mount="wall", mass=2.0)


@pytest.mark.parametrize(("gap", "valid"), [(0.0, True), (0.005, True), (0.02, False)])
def test_a_picture_must_touch_its_wall(gap: float, valid: bool) -> None:
    on_north_wall = put(PICTURE, 2.0, 5.0 - 0.015 - gap, 1.4, yaw=270.0, on="north_wall")
    verdict = check(scene(), on_north_wall, PICTURE)
    assert verdict.valid is valid
    assert verdict.reasons == (() if valid else ("unsupported",))
    assert [s.by for s in verdict.supports] == (["north_wall"] if valid else [])


def test_a_picture_names_the_wall_it_hangs_on() -> None:
    assert check(scene(), put(PICTURE, 2.0, 4.985, 1.4, yaw=270.0, on="east_wall"), PICTURE).reasons == ("unsupported",)
    assert check(scene(), put(PICTURE, 2.0, 4.985, 1.4, yaw=270.0, on="floor"), PICTURE).reasons == ("unsupported",)


@pytest.mark.parametrize(("yaw", "faces"), [(90.0, True), (33.0, True), (27.0, False), (180.0, False)])
def test_a_clock_has_its_face_to_the_room(yaw: float, faces: bool) -> None:
    clock = asset("clock", (0.3, 0.3, 0.3), mount="wall", mass=1.0)
    away = 0.15 * (abs(math.cos(math.radians(yaw))) + abs(math.sin(math.radians(yaw))))
    there = put(clock, 2.0, 5.0 - away, 1.4, yaw=yaw, on="north_wall")
    verdict = check(scene(), there, clock)
    assert verdict.reasons == (("faces_wall",) if faces else ())
    assert ("its front to the wall" in str(verdict)) is faces
    for either in (structs.replace(clock, front="two"), structs.replace(clock, front="any")):
        assert check(scene(), there, either).valid, "whichever way round, it looks the same"
    assert check(scene(), there, structs.replace(clock, flags=("front_unknown",))).valid


def test_two_pictures_do_not_hang_in_one_place() -> None:
    room = scene(None, (put(PICTURE, 2.0, 4.985, 1.4, yaw=270.0, on="north_wall"), PICTURE))
    verdict = check(room, put(PICTURE, 2.2, 4.985, 1.5, yaw=270.0, on="north_wall", id="picture_2"), PICTURE)
    assert verdict.reasons == ("collision",)


def test_a_pendant_touches_the_ceiling() -> None:
    pendant = asset("pendant_lamp", (0.3, 0.3, 0.6), mount="ceiling", mass=2.0)
    assert check(scene(), put(pendant, 2.0, 2.0, 2.0, on="ceiling"), pendant).valid
    assert check(scene(), put(pendant, 2.0, 2.0, 1.9, on="ceiling"), pendant).reasons == ("unsupported",)


def test_a_rug_lies_under_everything() -> None:
    rug = asset("rug", (2.0, 1.4, 0.01), box((2.0, 1.4, 0.01), (0.0, 0.0, 0.005), collide=False))
    room = scene(None, (put(CRATE, 2.0, 2.0), CRATE))
    verdict = check(room, put(rug, 2.0, 2.0), rug)
    assert verdict.valid
    assert [s.by for s in verdict.supports] == ["floor"]
    assert check(room, put(rug, 0.9, 2.0), rug).reasons == ("outside",)


def test_doors_keep_their_swing() -> None:
    room = rectangle(4.0, 5.0, openings=(DOOR,))
    verdict = check(scene(room), put(CRATE, 1.5, 0.6), CRATE)
    assert verdict.reasons[0] == "blocks_door"
    assert verdict.blocked[0] == "door_1"
    assert check(scene(room), put(CRATE, 1.5, 1.16), CRATE).valid
    high = asset("picture", (0.03, 0.6, 0.3), mount="wall", mass=2.0)
    assert check(scene(room), put(high, 1.5, 0.015, 2.1, yaw=90.0, on="south_wall"), high).valid


def test_windows_are_not_covered() -> None:
    room = rectangle(4.0, 5.0, openings=(WINDOW,))
    tall = asset("bookcase", (0.3, 0.9, 1.9), mass=30.0)
    low = asset("bookcase_low", (0.3, 0.9, 0.9), mass=20.0)
    lamp = asset("floor_lamp", (0.3, 0.3, 1.7), mass=5.0)
    assert check(scene(room), put(tall, 2.2, 4.8, yaw=270.0), tall).reasons == ("blocks_window",)
    assert check(scene(room), put(tall, 0.5, 4.8, yaw=270.0), tall).valid
    assert check(scene(room), put(low, 2.2, 4.8, yaw=270.0), low).valid
    assert check(scene(room), put(lamp, 2.2, 4.8, yaw=270.0), lamp).valid


def test_what_cuts_a_large_object_off_blocks_the_way() -> None:
    narrow = rectangle(
        2.0, 6.0, openings=(Opening(id="door_1", kind="door", wall=0, offset=0.5, width=0.9, height=2.0),)
    )
    bed = asset("bed", (1.9, 0.9, 0.5), mass=50.0)
    barrier = asset("sideboard", (0.4, 1.8, 0.8), mass=35.0)
    room = scene(narrow, (put(bed, 0.5, 5.0, yaw=270.0), bed))
    across = put(barrier, 1.0, 3.0, yaw=90.0)
    verdict = check(room, across, barrier)
    assert verdict.reasons == ("blocks_way",)
    assert verdict.blocked == ("bed_1",)
    assert check(room, across, barrier, way=False).valid
    assert check(room, put(barrier, 1.79, 3.0, yaw=180.0), barrier).valid


def test_a_size_that_the_asset_cannot_have() -> None:
    wide = Placement(
        id="crate_1",
        category="crate",
        asset=CRATE.id,
        position=(2.0, 2.0, 0.0),
        yaw=0.0,
        size=(0.5, 0.6, 0.5),
        support="floor",
    )
    assert check(scene(), wide, CRATE).reasons == ("size",)


def test_candidates_do_not_influence_each_other() -> None:
    world = World(scene(None, (put(table(), 2.0, 2.0), table())))
    poses = [
        put(vase(), x, 2.0, z, on="table_1")
        for x, z in ((2.0, 0.75), (2.61, 0.75), (2.0, 0.7), (2.2, 0.75), (2.0, 0.75))
    ]
    together = world.check(poses, vase())
    assert together == [World(world.scene).check([pose], vase())[0] for pose in poses]
    assert together[0] == together[-1]


def test_a_world_grown_object_by_object_is_the_world_of_the_scene() -> None:
    picture = put(PICTURE, 2.0, 4.985, 1.4, yaw=270.0, on="north_wall")
    objects = [(put(table(), 2.0, 2.0), table()), (put(wardrobe(), 0.301, 4.0), wardrobe()), (picture, PICTURE)]
    grown = World(scene())
    for placement, kind in objects:
        grown = grown.with_placement(placement, kind)
    fresh = World(scene(None, *objects))
    assert grown.scene == fresh.scene
    poses = [put(vase(), x, 2.0, z, on="table_1") for x, z in ((2.0, 0.751), (2.61, 0.75), (2.0, 0.7), (0.3, 0.0))]
    assert grown.check(poses, vase()) == fresh.check(poses, vase())


def test_an_object_already_in_the_scene_is_looked_past() -> None:
    room = scene(None, (put(CRATE, 2.0, 2.0), CRATE))
    assert check(room, put(CRATE, 2.1, 2.0), CRATE).valid


def test_a_hull_stands_on_a_hull() -> None:
    points = tuple((x * s, y * s, z) for z, s in ((0.0, 0.3), (0.4, 0.2)) for x in (-1, 1) for y in (-1, 1))
    shape = Shape(kind="hull", size=(0.6, 0.6, 0.4), position=(0.0, 0.0, 0.0), points=points)
    frustum = asset("pouffe", (0.6, 0.6, 0.4), shape, mass=6.0)
    room = scene(None, (put(frustum, 2.0, 2.0), frustum))
    small = asset("tray", (0.3, 0.3, 0.03), mass=1.0, mount="surface")
    verdict = check(room, put(small, 2.0, 2.0, 0.4, on="pouffe_1"), small)
    assert verdict.valid
    assert verdict.supports[0].by == "pouffe_1"


def test_a_wardrobe_among_neighbours_keeps_its_doors_to_itself() -> None:
    kind = wardrobe()
    verdict = check(scene(), put(kind, 0.3, 2.0), kind)
    assert verdict.valid, str(verdict)


def test_what_stands_near_an_edge_is_watched_for_all_of_the_time(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    steps: list[int] = []
    step = mujoco.mj_step

    def counted(model: mujoco.MjModel, data: mujoco.MjData, nstep: int = 1) -> None:
        steps.append(nstep)
        step(model, data, nstep=nstep)

    monkeypatch.setattr(mujoco, "mj_step", counted)
    verdict = check(scene(None, (put(table(), 2.0, 2.0), table())), put(vase(), 2.597, 2.0, 0.75), vase())
    assert verdict.valid
    assert sum(steps) * Physics().timestep >= Physics().settle_time - 1e-9


def test_what_outlines_rule_out_needs_no_measure_and_the_measure_agrees() -> None:
    desk, jar, shelf = table(), vase(), asset("shelf", (0.4, 0.4, 0.2), mount="wall")
    where = scene(
        None,
        (put(desk, 1.0, 2.0, id="table_1"), desk),
        (put(jar, 1.5, 2.0, 0.75, id="vase_1", on="table_1"), jar),
        (put(CRATE, 2.5, 2.36, id="crate_1"), CRATE),
        (put(shelf, 3.5, 4.0, 0.9, on="east_wall"), shelf),
    )
    world = World(where)
    for x, y, reasons in ((2.0, 2.0, ("collision",)), (1.0, 0.2, ("outside",)), (1.0, 3.0, ())):
        action = Move(id="table_1", position=(x, y, 0.0))
        ruled_out, measured = world.ruled_out(action), world.measure(action)
        assert measured.valid is not bool(reasons)
        assert (ruled_out.reasons if ruled_out is not None else ()) == reasons
    rider = world.ruled_out(Move(id="table_1", position=(3.0, 4.0, 0.0)))
    assert rider is not None
    assert rider.reasons == ("riders",)
