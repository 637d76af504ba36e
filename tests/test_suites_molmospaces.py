import mujoco
import numpy as np
import pytest

from tests.sim_rooms import asset, put, scene, table, vase, wardrobe
from tests.suite_subjects import (
    EXPLODING,
    FLOOR,
    failed,
    failures,
    fixed_box,
    free_box,
    of,
    started,
    stuck_box,
    subject,
)
from thinkblox.sim.subject import subject_of
from thinkblox.sim.suites import run_suite
from thinkblox.suite import SuiteResult

SLIPPERY = 'timestep="0.002" gravity="{} 0 -9.81"'


def molmo(world: str, options: str = "") -> SuiteResult:
    return run_suite("molmospaces", subject(world, options=options))


def test_a_furnished_room_passes_every_criterion() -> None:
    kinds = (put(table(), 2.0, 2.0), table()), (put(wardrobe(), 0.35, 4.0), wardrobe())
    result = run_suite("molmospaces", subject_of(scene(None, *kinds, (put(vase(), 2, 2, 0.75, on="table_1"), vase()))))
    assert result.passed
    assert all(c.passed for c in result.criteria)
    assert {f.object for f in of(result, "articulation").findings} == {"wardrobe_1/door_left", "wardrobe_1/door_right"}


@pytest.mark.parametrize(("pull", "passes"), [(0.004, True), (0.008, False)])
def test_drift_without_friction_is_that_of_uniform_acceleration(pull: float, passes: bool) -> None:
    result = molmo(FLOOR + free_box("a", mass=50.0), SLIPPERY.format(pull))
    drift = of(result, "body_drift")
    assert drift.value == pytest.approx(pull * (4.0**2 - 1.0**2) / 2, rel=0.01)
    assert drift.passed is passes
    assert failed(result) == (set() if passes else {"body_drift"})
    assert failures(drift) == (set() if passes else {"a"})


@pytest.mark.parametrize(("amplitude", "passes"), [(0.005, True), (0.02, False)])
def test_jitter_is_the_length_of_the_path(amplitude: float, passes: bool) -> None:
    world = (
        '<body name="a"><joint type="free" stiffness="1973.92" damping="0" frictionloss="0"/>'
        '<geom size="0.1" mass="50"/></body>'
    )
    swinging = started(subject(world, options='gravity="0 0 0" timestep="0.002"'), x=(0, amplitude))
    result = run_suite("molmospaces", swinging)
    assert of(result, "body_jitter").value == pytest.approx(4 * amplitude * 3.0, rel=0.03)
    assert of(result, "body_jitter").passed is passes
    assert of(result, "body_drift").passed


@pytest.mark.parametrize(("pull", "passes"), [(0.01, True), (0.02, False)])
def test_a_drawer_that_slides_open_by_itself(pull: float, passes: bool) -> None:
    world = (
        '<body name="chest"><geom type="box" size="0.1 0.1 0.1"/><body name="drawer"><joint name="slide" type="slide" '
        'axis="1 0 0" limited="true" range="0 1"/><geom size="0.05" contype="0" conaffinity="0"/></body></body>'
    )
    result = molmo(world, SLIPPERY.format(pull))
    drift = of(result, "joint_drift")
    assert drift.value == pytest.approx(pull * 4.0**2 / 2, rel=0.01)
    assert failures(drift) == (set() if passes else {"slide"})
    assert of(result, "body_drift").passed is None


@pytest.mark.parametrize(("depth", "passes"), [(0.008, True), (0.012, False)])
def test_penetration_names_the_pair_and_its_depth(depth: float, passes: bool) -> None:
    result = molmo(fixed_box("wall", "0 0 0.5") + stuck_box("a", f"{0.2 - depth} 0 0.5"), 'gravity="0 0 0"')
    penetration = of(result, "penetration")
    assert penetration.value == pytest.approx(depth, abs=1e-5)
    assert failures(penetration) == (set() if passes else {"a + wall"})
    assert not of(result, "articulation").passed  # what is stuck has a joint without limits


def test_contacts_of_sleepers_are_seen() -> None:
    world = FLOOR + free_box("a", "0 0 0.085", geom='solref="5 1" solimp="0.1 0.1 0.1"')
    model = subject(world, options='gravity="0 0 0"')
    assert of(run_suite("molmospaces", model), "penetration").value == pytest.approx(0.015, abs=0.002)


def test_what_is_under_a_shelf_is_lifted_up_to_the_shelf() -> None:
    world = FLOOR + free_box("free", "1 0 0.1") + free_box("under", "0 0 0.1") + fixed_box("shelf", "0 0 0.32")
    lift = of(molmo(world), "lift")
    values = {f.object: f.value for f in lift.findings}
    assert failures(lift) == {"under"}
    assert values["under"] == pytest.approx(0.02, abs=0.003)
    assert values["free"] is not None
    assert values["free"] >= 0.05
    assert values["shelf"] is None
    assert lift.value == values["under"]


@pytest.mark.parametrize(("mass", "applies"), [(2.9, True), (2.95, False)])
def test_what_takes_more_than_30_newtons_is_not_picked_up(mass: float, applies: bool) -> None:
    (finding,) = of(molmo(FLOOR + free_box("a", mass=mass)), "lift").findings
    assert finding.passed is (True if applies else None)


def test_a_door_that_meets_a_post_opens_as_far_as_that() -> None:
    drawer = (
        '<body name="{0}" pos="0 {1} 0.5"><geom type="box" size="0.1 0.1 0.1"/><body name="{0}_front" pos="0.12 0 0">'
        '<joint name="{0}_slide" type="slide" axis="1 0 0" limited="true" range="0 0.4"/>'
        '<geom type="box" size="0.01 0.1 0.1" mass="1"/></body></body>'
    )
    world = drawer.format("free", 1) + drawer.format("barred", 0) + fixed_box("post", "0.33 0 0.5")
    result = molmo(world)
    opened = of(result, "articulation")
    values = {f.object: f.value for f in opened.findings}
    assert failures(opened) == {"barred_slide"}
    assert values["barred_slide"] == pytest.approx(0.1 / 0.4, abs=0.04)  # and a little, as it runs into a soft contact
    assert failed(result) == {"articulation"}


def test_a_joint_that_others_bar_only_when_they_move_too_passes_alone() -> None:
    """Two drawers in a corner: the one pulled alone comes out, both at once meet."""
    world = (
        '<body name="a" pos="0 0 0.5"><geom type="box" size="0.1 0.1 0.1"/><body pos="0.15 0 0">'
        '<joint name="east" type="slide" axis="1 0 0" limited="true" range="0 0.3"/>'
        '<geom type="box" size="0.03 0.1 0.1" mass="5"/></body></body>'
        '<body name="b" pos="0.4 0.4 0.5"><geom type="box" size="0.1 0.1 0.1"/><body pos="0 -0.15 0">'
        '<joint name="south" type="slide" axis="0 -1 0" limited="true" range="0 0.3"/>'
        '<geom type="box" size="0.1 0.03 0.1" mass="5"/></body></body>'
    )
    assert of(molmo(world), "articulation").passed


def test_joints_without_limits_are_exempt() -> None:
    world = '<body name="fan"><joint name="spin" type="hinge"/><geom size="0.1" mass="1"/></body>'
    result = molmo(world)
    assert of(result, "articulation").passed is None
    assert of(result, "joint_drift").passed is None
    assert of(result, "solver_warnings").passed


def test_a_joint_without_limits_that_moves_fails_as_in_the_source() -> None:
    world = '<body name="arm"><joint name="elbow" type="hinge" axis="0 1 0"/><geom pos="0.3 0 0" size="0.1"/></body>'
    drift = of(molmo(world), "joint_drift")
    assert failures(drift) == {"elbow"}
    assert "its range has no end, and it moved by" in drift.findings[0].note


def test_a_body_on_six_slides_and_hinges_is_watched_as_a_free_one() -> None:
    joints = "".join(
        f'<joint type="{kind}" axis="{axis}"/>' for kind in ("slide", "hinge") for axis in ("1 0 0", "0 1 0", "0 0 1")
    )
    world = f'<body name="a" pos="0 0 0.1">{joints}<geom type="box" size="0.1 0.1 0.1" mass="50" condim="1"/></body>'
    result = molmo(FLOOR + world, SLIPPERY.format(0.008))
    assert failures(of(result, "body_drift")) == {"a"}
    assert of(result, "lift").passed is None


def test_what_blows_up_fails_and_is_named() -> None:
    result = molmo(FLOOR + free_box("bystander", "2 0 0.1") + EXPLODING)
    drift = of(result, "body_drift")
    assert not result.passed
    assert failures(drift) == {"spring"}
    assert "BADQ" in drift.note
    assert drift.value is None
    assert not of(result, "solver_warnings").passed


def test_the_subject_stays_as_it_is() -> None:
    made = subject(FLOOR + free_box("a"), options='timestep="0.01"')
    before = made.start.copy()
    first = run_suite("molmospaces", made)
    assert made.model.opt.timestep == 0.01
    assert not made.model.opt.enableflags & int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    assert np.array_equal(before, made.start)
    assert first == run_suite("molmospaces", made)


def test_sleep_and_the_early_end_change_nothing_that_is_reported() -> None:
    """The same four seconds by plain MuJoCo, everything awake, step by step."""
    crate = asset("crate", (0.3, 0.3, 0.3), mass=4.0)
    made = subject_of(scene(None, (put(table(), 2, 2), table()), (put(crate, 2.7, 2.0, 0.75, on="table_1"), crate)))
    result = run_suite("molmospaces", made)
    model = made.model
    model.opt.timestep = 0.002
    data = made.data()
    mujoco.mj_step(model, data, nstep=500)
    body = model.body("crate_1").id
    before = data.xpos[body].copy()
    mujoco.mj_step(model, data, nstep=1500)
    drift = float(np.linalg.norm(data.xpos[body] - before))
    value = next(f.value for f in of(result, "body_drift").findings if f.object == "crate_1")
    assert value == pytest.approx(drift, abs=0.002)


def test_other_integrators_are_simulated_without_sleep() -> None:
    assert molmo(FLOOR + free_box("a"), 'integrator="RK4"').passed
