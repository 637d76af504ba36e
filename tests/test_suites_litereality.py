from dataclasses import replace

import pytest

from tests.sim_rooms import put, scene, table, vase
from tests.suite_subjects import EXPLODING, FLOOR, failed, failures, fixed_box, free_box, of, stuck_box, subject
from thinkblox.sim.subject import subject_of
from thinkblox.sim.suites import run_suite
from thinkblox.suite import SuiteResult

COARSE = 'timestep="0.01" gravity="{} 0 -9.81"'


def lite(world: str, options: str = COARSE.format(0), more: str = "") -> SuiteResult:
    return run_suite("litereality", subject(world, options=options, more=more))


def test_a_vase_on_a_table_passes_and_the_seed_decides_the_resets() -> None:
    room = scene(None, (put(table(), 2.0, 2.0), table()), (put(vase(), 2, 2, 0.75, on="table_1"), vase()))
    made = subject_of(room)
    result = run_suite("litereality", made, seed=1)
    assert result.passed
    assert result == run_suite("litereality", made, seed=1)
    assert result != run_suite("litereality", made, seed=2)


@pytest.mark.parametrize(("depth", "passes"), [(0.009, True), (0.011, False)])
def test_ten_millimetres_at_the_start_are_the_limit(depth: float, passes: bool) -> None:
    result = lite(fixed_box("wall", "0 0 0.5") + stuck_box("a", f"{0.2 - depth} 0 0.5"))
    found = of(result, "initial_penetration")
    assert found.value == pytest.approx(depth, abs=1e-6)
    assert failures(found) == (set() if passes else {"a + wall"})
    assert failed(result) == (set() if passes else {"initial_penetration"})


@pytest.mark.parametrize(("pull", "passes"), [(0.0015, True), (0.004, False)])
def test_what_slides_away_escapes_by_half_a_t_squared(pull: float, passes: bool) -> None:
    result = lite(FLOOR + free_box("slider") + free_box("far", "0 3 0.1"), COARSE.format(pull))
    escape = of(result, "escape")
    assert escape.value == pytest.approx(pull * 30.0**2 / 2, abs=0.06)
    assert failures(escape) == (set() if passes else {"slider", "far"})
    assert failed(result) == (set() if passes else {"escape"})


@pytest.mark.parametrize(("torque", "passes"), [(4900.0, True), (5100.0, False)])
def test_the_peak_acceleration_is_torque_over_inertia(torque: float, passes: bool) -> None:
    wheel = (
        '<body name="wheel" pos="0 0 1"><joint name="axle" type="hinge" damping="50"/><inertial pos="0 0 0" mass="1" '
        'diaginertia="1 1 1"/><geom size="0.1"/></body>'
    )
    motor = f'<actuator><general joint="axle" biastype="affine" biasprm="{torque} 0 0"/></actuator>'
    result = lite(wheel, 'timestep="0.01" integrator="implicitfast"', motor)
    found = of(result, "peak_acceleration")
    assert found.value == pytest.approx(torque, rel=0.001)
    assert failures(found) == (set() if passes else {"wheel"})
    assert failed(result) == (set() if passes else {"peak_acceleration"})


def test_what_blows_up_fails_and_is_named() -> None:
    result = lite(FLOOR + free_box("bystander", "2 0 0.1") + EXPLODING)
    assert failures(of(result, "solver_warnings")) == {"scene", "spring"}
    assert failures(of(result, "escape")) == {"spring"}
    assert not result.passed


def test_substitutions_are_listed() -> None:
    made = replace(subject(FLOOR + free_box("a") + free_box("b", "1 0 0.1")), substituted=("b",))
    listed = of(run_suite("litereality", made), "substitutions_listed")
    assert listed.passed
    assert listed.value == 1.0
    assert "b" in {f.object for f in listed.findings}


def test_what_is_fixed_has_no_acceleration() -> None:
    result = lite(fixed_box("a", "0 0 1"))
    assert of(result, "peak_acceleration").passed is None
    assert of(result, "escape").passed
