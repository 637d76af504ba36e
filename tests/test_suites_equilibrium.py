"""SceneSmith's bars and the simulation fork of SceneEval."""

import math
from dataclasses import replace

import pytest

from tests.sim_rooms import asset, box, put, scene, table, vase
from tests.suite_subjects import EXPLODING, FLOOR, failed, failures, fixed_box, free_box, of, stuck_box, subject
from thinkblox.scene.room import rectangle
from thinkblox.sim.subject import Subject, subject_of
from thinkblox.sim.suites import run_suite

SUITES = ("scenesmith", "sceneeval_sim")
TILTED = 'timestep="0.005" gravity="{} 0 -9.81"'


def furnished() -> Subject:
    rug = asset("rug", (1.0, 1.0, 0.01), box((1.0, 1.0, 0.01), (0.0, 0.0, 0.005), collide=False))
    things = (put(table(), 2, 2), table()), (put(vase(), 2, 2, 0.75, on="table_1"), vase()), (put(rug, 2, 2), rug)
    return subject_of(scene(None, *things))


@pytest.mark.parametrize("suite", SUITES)
def test_a_vase_on_a_table_passes_and_the_rug_is_exempt(suite: str) -> None:
    result = run_suite(suite, furnished())
    assert result.passed
    assert all(c.passed for c in result.criteria)
    exempt = {f.object for c in result.criteria for f in c.findings if f.passed is None}
    assert exempt == {"rug_1"}


@pytest.mark.parametrize(("depth", "passes"), [(0.0008, True), (0.0012, False)])
def test_a_millimetre_is_the_limit_of_penetration(depth: float, passes: bool) -> None:
    world = fixed_box("wall", "0 0 0.5") + stuck_box("a", f"{0.2 - depth} 0 0.5")
    collision = of(run_suite("sceneeval_sim", subject(world)), "collision")
    assert collision.value == pytest.approx(depth, abs=1e-6)
    assert failures(collision) == (set() if passes else {"a + wall"})
    rate = of(run_suite("scenesmith", subject(world)), "collision_rate")
    assert rate.value == (0.0 if passes else 1.0)


def test_things_that_are_both_fixed_are_measured_too() -> None:
    made = subject(fixed_box("a", "0 0 1") + fixed_box("b", "0.19 0 1") + fixed_box("c", "5 0 1"))
    collision = of(run_suite("sceneeval_sim", made), "collision")
    assert collision.value == pytest.approx(0.01, abs=1e-6)
    assert failures(collision) == {"a + b"}
    assert of(run_suite("sceneeval_sim", made), "displacement").passed is None


def test_what_is_sunk_into_the_floor_is_told_apart_from_what_is_in_another_thing() -> None:
    crate = asset("crate", (0.5, 0.5, 0.5))
    made = subject_of(scene(None, (put(crate, 2, 2, -0.004), crate)))
    result = run_suite("sceneeval_sim", made)
    assert of(result, "floor_collision").value == pytest.approx(0.004, abs=1e-4)
    assert failures(of(result, "floor_collision")) == {"crate_1 + floor"}
    assert of(result, "collision").passed


@pytest.mark.parametrize(("pull", "passes"), [(0.0007, True), (0.0009, False)])
def test_displacement_is_half_a_t_squared(pull: float, passes: bool) -> None:
    result = run_suite("sceneeval_sim", subject(FLOOR + free_box("a"), options=TILTED.format(pull)))
    moved = of(result, "displacement")
    assert moved.value == pytest.approx(pull * 5.0**2 / 2, rel=0.02)
    assert failed(result) == (set() if passes else {"displacement"})


@pytest.mark.parametrize(("angle", "passes"), [(0.09, True), (0.11, False)])
def test_rotation_is_measured_in_radians(angle: float, passes: bool) -> None:
    """Springs draw a free body back, overdamped (a time constant of about 0.1 s), from where it starts."""
    world = (
        '<body name="a"><joint type="free" stiffness="4" damping="0.4"/><inertial pos="0 0 0" mass="0.001" '
        'diaginertia="1e-4 1e-4 1e-4"/><geom size="0.1"/></body>'
    )
    made = subject(world, options='gravity="0 0 0" integrator="implicitfast"')
    start = made.start.copy()
    start[3], start[6] = math.cos(angle / 2), math.sin(angle / 2)
    result = run_suite("sceneeval_sim", replace(made, start=start))
    turned = of(result, "rotation")
    assert turned.value == pytest.approx(angle, abs=0.001)
    assert failures(turned) == (set() if passes else {"a"})
    assert failed(result) == (set() if passes else {"rotation"})


@pytest.mark.parametrize(("count", "passes"), [(25, True), (24, False)])
def test_96_percent_must_be_stable(count: int, passes: bool) -> None:
    still = [
        free_box(f"still_{k}", f"0 {0.5 * k} 0.1", geom='friction="1"').replace('condim="1"', 'condim="3"')
        for k in range(count - 1)
    ]
    world = FLOOR.replace('condim="1"', 'condim="1"') + free_box("slider", "0 -1 0.1") + "".join(still)
    result = run_suite("scenesmith", subject(world, options=TILTED.format(0.002)))
    stability = of(result, "stability")
    assert stability.value == pytest.approx((count - 1) / count, abs=1e-6)
    assert failures(stability) == {"slider"}
    assert failed(result) == (set() if passes else {"stability"})


@pytest.mark.parametrize(("count", "passes"), [(101, True), (100, False)])
def test_two_in_a_hundred_is_the_limit_of_the_collision_rate(count: int, passes: bool) -> None:
    crate = asset("crate", (0.2, 0.2, 0.2))
    placed = [
        (put(crate, 0.5 + 0.4 * (k % 11), 0.5 + 0.4 * (k // 11), id=f"crate_{k}"), crate) for k in range(count - 1)
    ]
    placed.append((put(crate, 0.5, 0.5, 0.197, id="sunk"), crate))
    result = run_suite("scenesmith", subject_of(scene(rectangle(6.0, 6.0), *placed)))
    rate = of(result, "collision_rate")
    assert rate.value == pytest.approx(2 / count, abs=1e-6)
    assert rate.passed is passes
    assert "crate_0 + sunk" in failures(rate)


@pytest.mark.parametrize("suite", SUITES)
def test_what_blows_up_fails_and_is_named(suite: str) -> None:
    result = run_suite(suite, subject(FLOOR + free_box("bystander", "2 0 0.1") + EXPLODING))
    assert not result.passed
    broken = result.criteria[-1]
    assert failures(broken) == {"spring"}
    assert broken.value is None
    assert "broke down" in broken.note
