"""What holds for every suite: names, bad models, bounds, JSON."""

import json
import subprocess
import sys
from dataclasses import replace

import mujoco
import numpy as np
import pytest

from tests.bench.suites import room
from tests.sim_rooms import asset, box, put, scene
from tests.suite_subjects import EXPLODING, FLOOR, free_box, subject
from thinkblox.errors import InputError
from thinkblox.generate import generate_room
from thinkblox.sim.subject import Subject, subject_of
from thinkblox.sim.suites import SUITES, run_suite, running, usable
from thinkblox.sim.suites.equilibrium import motions
from thinkblox.suite import SuiteResult
from thinkblox.value import from_json, to_json

each_suite = pytest.mark.parametrize("suite", SUITES)


def test_an_unknown_suite_lists_those_that_exist() -> None:
    with pytest.raises(InputError, match=r"no suite 'sage'; there are molmospaces, litereality, scenesmith, sceneeval"):
        run_suite("sage", subject(free_box("a")))


def test_the_names_cost_no_engine() -> None:
    code = "import sys, thinkblox.sim.suites as s; sys.exit('mujoco' in sys.modules or len(s.SUITES) != 5)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@each_suite
def test_an_empty_scene_fails_and_says_why(suite: str) -> None:
    for empty in (subject(FLOOR), subject_of(scene())):
        result = run_suite(suite, empty)
        assert not result.passed
        assert [c.note for c in result.criteria] == ["the scene has no objects"]


@each_suite
def test_a_start_that_is_not_a_number_fails_and_names_the_thing(suite: str) -> None:
    made = subject(FLOOR + free_box("a") + free_box("b", "1 0 0.1"))
    start = made.start.copy()
    start[8] = np.nan
    result = run_suite(suite, replace(made, start=start))
    assert not result.passed
    assert {f.object for c in result.criteria for f in c.findings if f.passed is False} == {"b"}
    assert b"NaN" not in to_json(result)


@each_suite
def test_a_model_that_blows_up_ends_in_numbers_or_none(suite: str) -> None:
    made = subject(FLOOR + free_box("a", "2 0 0.1") + EXPLODING + free_box("hurled", "0 1 0.1", geom='solref="-1e9 0"'))
    result = run_suite(suite, made)
    decoded = json.loads(to_json(result), parse_constant=lambda name: pytest.fail(name))
    assert decoded["suite"] == suite
    if suite != "sceneeval":
        assert not result.passed


@each_suite
def test_things_without_geometry_are_exempt(suite: str) -> None:
    rug = asset("rug", (1.0, 1.0, 0.01), box((1.0, 1.0, 0.01), (0.0, 0.0, 0.005), collide=False))
    result = run_suite(suite, subject_of(scene(None, (put(rug, 2, 2), rug))))
    assert all(f.object != "rug_1" or f.passed is not False for c in result.criteria for f in c.findings)


@each_suite
def test_a_result_survives_json(suite: str) -> None:
    result = run_suite(suite, subject(FLOOR + free_box("a")))
    assert from_json(to_json(result), SuiteResult) == result
    assert result.suite == suite
    assert "http" in result.source
    assert result.notes


@each_suite
def test_the_subject_stays_as_it_is(suite: str) -> None:
    made = subject_of(room(6, 0))
    before, start = _bytes(made.model), made.start.copy()
    first = run_suite(suite, made, seed=3)
    assert _bytes(made.model) == before
    assert np.array_equal(start, made.start)
    assert to_json(run_suite(suite, made, seed=3)) == to_json(first)


def _bytes(model: mujoco.MjModel) -> bytes:
    buffer = np.empty(mujoco.mj_sizeModel(model), np.uint8)
    mujoco.mj_saveModel(model, None, buffer)
    return buffer.tobytes()


@each_suite
def test_too_many_bodies_are_refused(suite: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(usable, "MOST_BODIES", 2)
    result = run_suite(suite, subject(FLOOR + free_box("a") + free_box("b", "1 0 0.1")))
    assert not result.passed
    assert result.criteria[0].name == "size"
    assert result.criteria[0].value == 3.0


@pytest.mark.parametrize("suite", [s for s in SUITES if s != "sceneeval"])
def test_what_is_broken_off_does_not_pass(suite: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(running, "MOST_WORK", 1000.0)
    result = run_suite(suite, subject(FLOOR + free_box("a")))
    assert any("broken off after" in c.note and c.passed is None for c in result.criteria)


def test_ending_early_changes_the_outcome_by_less_than_it_may() -> None:
    made, creep = subject_of(room(18, 0)), 0.0001
    early, whole = running.Run(made, 15.0, creep=creep), running.Run(made, 15.0, creep=-1.0)
    short, full = motions(made, early, 15.0), motions(made, whole, 15.0)
    assert early.stopped == "still"
    assert early.seconds < 15.0
    assert whole.seconds == pytest.approx(15.0)
    for first, second in zip(short, full, strict=True):
        assert first.moved == pytest.approx(second.moved, abs=creep)
        assert first.turned == pytest.approx(second.turned, abs=10 * creep)


@each_suite
def test_a_model_without_names_is_reported(suite: str) -> None:
    world = '<geom type="plane" size="0 0 1"/><body pos="0 0 0.1"><freejoint/><geom size="0.1"/></body>'
    made = subject(world)
    named = replace(made, things=tuple(replace(thing, id="body 1") for thing in made.things))
    assert run_suite(suite, named).criteria


@pytest.mark.slow
@each_suite
def test_a_generated_room_passes(suite: str) -> None:
    result = run_suite(suite, _bedroom())
    assert result.passed, [c for c in result.criteria if c.passed is False]


def _bedroom() -> Subject:
    return subject_of(generate_room("A bedroom, 4 m by 5 m, with a double bed, a wardrobe and a desk.", seed=0).scene)


@pytest.mark.slow
def test_the_suite_of_molmospaces_on_60_objects_takes_less_than_3_seconds_of_cpu() -> None:
    from tests.bench.suites import measured

    assert measured("molmospaces", room(60, 0))[1] < 3.0
