import math
from dataclasses import replace

import numpy as np
import pytest

from tests.sim_rooms import asset, box, put, scene, table, vase
from tests.suite_subjects import failed, failures, fixed_box, free_box, of, subject
from thinkblox.scene.room import Opening, Room, rectangle
from thinkblox.scene.scene import Scene
from thinkblox.sim.subject import subject_of
from thinkblox.sim.suites import run_suite
from thinkblox.sim.suites.floorplan import components
from thinkblox.suite import SuiteResult

CRATE = asset("crate", (1.0, 1.0, 1.0))
DOOR = Opening(id="door_1", kind="door", wall=0, offset=1.0, width=1.0, height=2.0)
WINDOW = Opening(id="window_1", kind="window", wall=2, offset=1.0, width=2.0, height=1.0, sill=1.0)


def evaluated(room: Scene, seed: int = 0) -> SuiteResult:
    return run_suite("sceneeval", subject_of(room), seed=seed)


def test_a_plain_room_passes_every_criterion_and_its_rug_is_exempt() -> None:
    rug = asset("rug", (1.0, 1.0, 0.01), box((1.0, 1.0, 0.01), (0.0, 0.0, 0.005), collide=False))
    room = rectangle(4.0, 5.0, openings=(DOOR, WINDOW))
    things = (put(table(), 2, 3), table()), (put(vase(), 2, 3, 0.75, on="table_1"), vase()), (put(rug, 2, 2), rug)
    result = evaluated(scene(room, *things))
    assert result.passed
    assert all(c.passed for c in result.criteria)
    assert all(f.passed is None for c in result.criteria for f in c.findings if f.object == "rug_1")


# Collision


@pytest.mark.parametrize(("overlap", "collides"), [(-0.001, False), (0.004, False), (0.006, True)])
def test_what_comes_free_when_moved_5_mm_does_not_collide(overlap: float, collides: bool) -> None:
    result = evaluated(
        scene(None, (put(CRATE, 1, 2, yaw=180, id="a"), CRATE), (put(CRATE, 2 - overlap, 2, id="b"), CRATE))
    )
    collision = of(result, "collision")
    assert failures(collision) == ({"a + b"} if collides else set())
    assert collision.value == (2.0 if collides else 0.0)
    assert failed(result) == ({"collision"} if collides else set())


def test_a_cup_inside_an_open_box_does_not_collide_with_it() -> None:
    """Triangles, not hulls of things: the box is five boards."""
    board = 0.02
    sides = [box((board, 0.4, 0.3), (x, 0.0, 0.17)) for x in (-0.19, 0.19)]
    sides += [box((0.4, board, 0.3), (0.0, y, 0.17)) for y in (-0.19, 0.19)]
    crate = asset("bin", (0.4, 0.4, 0.32), box((0.4, 0.4, board), (0.0, 0.0, board / 2)), *sides)
    cup = asset("cup", (0.1, 0.1, 0.1), mount="surface", mass=0.2)
    result = evaluated(scene(None, (put(crate, 2, 2), crate), (put(cup, 2, 2, 0.02, on="bin_1"), cup)))
    assert of(result, "collision").passed
    sunk = evaluated(scene(None, (put(crate, 2, 2), crate), (put(cup, 2.137, 2, 0.02, on="bin_1"), cup)))
    assert failures(of(sunk, "collision")) == {"bin_1 + cup_1"}


# OutOfBound


@pytest.mark.parametrize("out", [0.0, 0.1, 0.25, 0.5])
def test_the_share_out_of_bound_is_that_of_a_cubes_surface(out: float) -> None:
    result = evaluated(scene(rectangle(4.0, 5.0), (put(CRATE, 0.5 - out, 2), CRATE)))
    found = of(result, "out_of_bound")
    share = 1.0 if out == 0.0 else (1.0 + 4.0 * (1.0 - out)) / 6.0
    assert found.value == pytest.approx(share, abs=0.025)  # 5000 points: a standard deviation of 0.007
    assert failures(found) == (set() if out == 0.0 else {"crate_1"})


def test_the_notch_of_an_l_shaped_floor_is_out_of_bound() -> None:
    room = Room(floor=((0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0)))
    inside = evaluated(scene(room, (put(CRATE, 1.5, 3), CRATE)))
    notch = evaluated(scene(room, (put(CRATE, 3, 3), CRATE)))
    assert of(inside, "out_of_bound").value == 1.0
    assert of(notch, "out_of_bound").value == 0.0


def test_what_is_under_the_floor_does_not_see_it() -> None:
    assert of(evaluated(scene(None, (put(CRATE, 2, 2, -1.1), CRATE))), "out_of_bound").value == 0.0


# Support


@pytest.mark.parametrize(("gap", "carried"), [(0.0, True), (0.004, True), (0.006, False), (-0.004, True), (0.5, False)])
def test_what_is_within_a_centimetre_of_its_raised_self_is_carried(gap: float, carried: bool) -> None:
    support = of(evaluated(scene(None, (put(CRATE, 2, 2, gap), CRATE))), "support")
    assert failures(support) == (set() if carried else {"crate_1"})
    assert support.value is not None
    assert (support.value >= 4) is carried


@pytest.mark.parametrize(("over", "carried"), [(-0.05, True), (0.02, False)])
def test_the_centre_must_be_above_what_carries(over: float, carried: bool) -> None:
    """A book over the edge of a table whose top ends at x = 2.6."""
    book = asset("book", (0.3, 0.2, 0.04), mount="surface", mass=0.5)
    room = scene(None, (put(table(), 2, 2), table()), (put(book, 2.6 + over, 2, 0.75, on="table_1"), book))
    support = of(evaluated(room), "support")
    assert failures(support) == (set() if carried else {"book_1"})
    note = next(f.note for f in support.findings if f.object == "book_1")
    if not carried:
        beside = float(note.removeprefix("the centre of its surface is ").split()[0])
        assert 20.0 <= beside <= 45.0  # the hull of 64 random points does not quite reach the edge


@pytest.mark.parametrize(("gap", "held"), [(0.0, True), (0.004, True), (0.02, False)])
def test_pictures_are_held_by_the_wall_behind_them(gap: float, held: bool) -> None:
    picture = asset("picture", (0.03, 0.6, 0.4), mount="wall")
    placed = put(picture, 0.015 + gap, 2, 1.4, yaw=0, on="west_wall")
    support = of(evaluated(scene(None, (placed, picture))), "support")
    assert failures(support) == (set() if held else {"picture_1"})


@pytest.mark.parametrize(("gap", "held"), [(0.0, True), (0.004, True), (0.03, False)])
def test_lamps_are_held_by_the_ceiling(gap: float, held: bool) -> None:
    lamp = asset("pendant", (0.3, 0.3, 0.4), mount="ceiling")
    support = of(evaluated(scene(None, (put(lamp, 2, 2, 2.2 - gap, on="ceiling"), lamp))), "support")
    assert failures(support) == (set() if held else {"pendant_1"})


def test_of_somebody_elses_model_only_what_is_free_must_be_carried() -> None:
    plane = '<geom name="floor" type="plane" size="0 0 1"/>'
    world = plane + free_box("stands", "0 0 0.1") + free_box("floats", "2 0 0.3") + fixed_box("shelf", "4 0 1")
    support = of(run_suite("sceneeval", subject(world)), "support")
    assert failures(support) == {"floats"}
    assert {f.object for f in support.findings if f.passed is None} == {"shelf"}
    standing = of(
        run_suite("sceneeval", subject(plane + free_box("a", "0 0 0.1") + fixed_box("b", "4 0 1"))), "support"
    )
    assert standing.value is not None
    assert standing.value >= 4.0


# Navigability


def test_a_room_split_by_a_block_is_navigable_in_its_larger_part() -> None:
    """Free for the middle of a robot 0.2 m wide: 1.7 m on one side of the block and 2.7 m on the other."""
    block = asset("block", (4.0, 0.2, 1.0))
    result = evaluated(scene(rectangle(4.0, 5.0), (put(block, 2.0, 2.0), block)))
    found = of(result, "navigability")
    assert found.value == pytest.approx(2.7 / 4.4, abs=0.01)
    assert found.passed is False


def test_a_gap_of_the_robots_width_joins_the_parts() -> None:
    for length, joined in ((3.7, True), (3.85, False)):
        block = asset("block", (length, 0.2, 1.0))
        result = evaluated(scene(rectangle(4.0, 5.0), (put(block, length / 2, 2.0), block)))
        assert of(result, "navigability").passed is joined


def test_what_is_overhead_is_in_nobodys_way() -> None:
    beam = asset("beam", (4.0, 0.2, 0.3), mount="ceiling")
    result = evaluated(scene(rectangle(4.0, 5.0), (put(beam, 2.0, 2.0, 2.3, on="ceiling"), beam)))
    assert of(result, "navigability").value == 1.0


def test_a_room_that_is_full_has_no_free_floor() -> None:
    block = asset("block", (3.9, 4.9, 1.0))
    assert of(evaluated(scene(rectangle(4.0, 5.0), (put(block, 2.0, 2.5), block))), "navigability").value == 0.0


def test_parts_of_a_picture_hang_together_at_corners() -> None:
    picture = np.array([[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 0, 0], [1, 1, 0, 1]], bool)
    assert components(picture) == [2, 2, 2, 1]
    assert components(np.array([[1, 0, 1], [1, 0, 1], [1, 1, 1]], bool)) == [7]
    assert components(np.zeros((3, 3), bool)) == []


def test_components_agree_with_a_flood_fill() -> None:
    rng = np.random.default_rng(3)
    for density in (0.3, 0.5, 0.7):
        picture = rng.random((40, 40)) < density
        assert components(picture) == _flooded(picture.copy())


def _flooded(picture: np.ndarray) -> list[int]:
    sizes = []
    while picture.any():
        todo = [tuple(np.argwhere(picture)[0])]
        picture[todo[0]] = False
        size = 0
        while todo:
            i, j = todo.pop()
            size += 1
            for a in range(max(i - 1, 0), min(i + 2, len(picture))):
                for b in range(max(j - 1, 0), min(j + 2, len(picture))):
                    if picture[a, b]:
                        picture[a, b] = False
                        todo.append((a, b))
        sizes.append(size)
    return sorted(sizes, reverse=True)


# Accessibility


@pytest.mark.parametrize(("covered", "passes"), [(0.3, True), (0.8, False)])
def test_the_front_strip_is_free_but_for_what_stands_in_it(covered: float, passes: bool) -> None:
    """A chest faces east; a block stands 0.1 m before it, over a share of its front."""
    chest, block = asset("chest", (0.4, 1.0, 0.8)), asset("block", (0.3, covered, 0.5))
    placed = put(chest, 0.2, 2.0), chest
    room = scene(None, placed, (put(block, 0.4 + 0.1 + 0.15, 1.5 + covered / 2), block))
    found = of(evaluated(room), "accessibility")
    value = next(f.value for f in found.findings if f.object == "chest_1")
    assert value == pytest.approx(1.0 - covered * 0.15 / 0.2, abs=1e-4)
    narrow = scene(None, placed, (put(block, 0.4 + 0.05 + 0.15, 1.5 + covered / 2), block))
    value = next(f.value for f in of(evaluated(narrow), "accessibility").findings if f.object == "chest_1")
    assert value == pytest.approx(1.0 - covered, abs=1e-4)
    assert failures(of(evaluated(narrow), "accessibility")) == (set() if passes else {"chest_1"})


def test_the_best_side_counts_for_what_has_no_front() -> None:
    stool = replace_front(asset("stool", (0.4, 0.4, 0.5)))
    found = of(evaluated(scene(None, (put(stool, 0.2, 2.0, yaw=180), stool))), "accessibility")
    assert found.value == 1.0
    faced = asset("chest", (0.4, 0.4, 0.5))
    walled = of(evaluated(scene(None, (put(faced, 0.2, 2.0, yaw=180), faced))), "accessibility")
    assert walled.value == 0.0
    assert failures(walled) == {"chest_1"}


def replace_front(kind):
    import msgspec

    return msgspec.structs.replace(kind, front="any")


def test_what_stands_on_a_table_has_no_functional_sides() -> None:
    room = scene(None, (put(table(), 2, 2), table()), (put(vase(), 2, 2, 0.75, on="table_1"), vase()))
    found = of(evaluated(room), "accessibility")
    assert {f.object for f in found.findings if f.passed is None} == {"vase_1"}


# OpeningClearance


@pytest.mark.parametrize(
    ("along", "away", "share"), [(1.5, 0.5, 0.25), (1.0, 0.5, 0.125), (1.5, 1.3, 0.0), (3.0, 0.5, 0.0)]
)
def test_the_share_of_a_door_that_a_chest_hides(along: float, away: float, share: float) -> None:
    """The door is 1 m by 2 m and its box 1 m deep; the chest is 0.5 m wide, 0.5 m deep and 1 m high."""
    chest = asset("chest", (0.5, 0.5, 1.0))
    result = evaluated(scene(rectangle(4.0, 5.0, openings=(DOOR,)), (put(chest, along, away), chest)))
    found = of(result, "opening_clearance")
    assert found.value == pytest.approx(share, abs=1e-6)
    assert failures(found) == ({"door_1 + chest_1"} if share else set())


@pytest.mark.parametrize(("height", "share"), [(0.9, 0.0), (1.5, 0.5 * 0.5), (2.4, 0.5)])
def test_windows_are_hidden_by_what_is_higher_than_the_sill(height: float, share: float) -> None:
    """The window is 2 m by 1 m, its sill at 1 m; a chest of 1 m stands before it, on the north wall."""
    chest = asset("chest", (0.4, 1.0, height))
    wall = rectangle(4.0, 5.0).walls[2]
    x, y = wall.point(2.0, 0.2)
    room = scene(rectangle(4.0, 5.0, openings=(WINDOW,)), (put(chest, x, y, yaw=wall.yaw), chest))
    found = of(evaluated(room), "opening_clearance")
    assert found.value == pytest.approx(share, abs=1e-6)
    away = scene(rectangle(4.0, 5.0, openings=(WINDOW,)), (put(chest, *wall.point(2.0, 0.71), yaw=wall.yaw), chest))
    assert of(evaluated(away), "opening_clearance").value == 0.0


# What is not known


def test_without_a_floor_plan_what_needs_one_is_not_applied() -> None:
    result = run_suite("sceneeval", subject('<geom type="plane" size="0 0 1"/>' + free_box("a")))
    unknown = {c.name for c in result.criteria if c.passed is None}
    assert unknown == {"navigability", "accessibility", "out_of_bound", "opening_clearance"}
    assert all(c.note for c in result.criteria if c.passed is None)
    assert result.passed


def test_a_turned_room_measures_the_same() -> None:
    """Everything is turned by 30 degrees in the wall's own frame: boxes turn with their things."""
    made = subject_of(scene(rectangle(6.0, 6.0), (put(CRATE, 3, 3, yaw=30), CRATE)))
    found = of(run_suite("sceneeval", made), "navigability")
    assert found.value == 1.0
    from thinkblox.sim.suites.meshes import Meshes

    (body,) = Meshes(made).bodies
    assert body.footprint.area == pytest.approx(1.0)
    assert math.degrees(body.yaw) == pytest.approx(30.0)
    assert body.box_volume == pytest.approx(1.0)


def test_samples_depend_on_the_seed_alone() -> None:
    room = scene(rectangle(4.0, 5.0), (put(CRATE, 0.4, 2), CRATE))
    assert evaluated(room, 1) == evaluated(room, 1)
    assert evaluated(room, 1) != evaluated(room, 2)


def test_a_start_other_than_the_models_own_is_measured() -> None:
    made = subject_of(scene(None, (put(CRATE, 2, 2), CRATE)))
    start = made.start.copy()
    start[2] += 0.5
    assert failures(of(run_suite("sceneeval", replace(made, start=start)), "support")) == {"crate_1"}
