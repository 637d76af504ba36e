"""The search that tries to fool the verdict finds nothing in a small part of itself, and would find what is there."""

import pytest

from tests.bench.adversary import plan, run, table
from tests.bench.adversary_cases import FAMILIES, Case
from tests.bench.adversary_hunt import Judged, candidates, hunt
from tests.bench.adversary_truth import Truth
from tests.sim_rooms import asset, put, scene
from thinkblox.sim.verdict import stage
from thinkblox.verdict import Verdict

CRATE = asset("crate", (0.4, 0.4, 0.4), mass=8.0)


@pytest.mark.slow
def test_a_hunt_is_the_same_twice() -> None:
    assert hunt("edge", 3) == hunt("edge", 3)


def test_a_verdict_that_believes_at_once_is_fooled(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(stage, "unsteady", lambda model, data, suspect: None)
    monkeypatch.setattr(stage, "at_rest", lambda model, data, body: True)
    monkeypatch.setattr(stage, "stayed", lambda before, now, interval: True)
    assert any(judged is not None and judged.outcome == "false valid" for judged in candidates("edge", 0))


@pytest.mark.parametrize(
    ("valid", "share", "falls", "outcome"),
    [
        (True, 0.5, None, "agree"),
        (True, 1.05, None, "at the line"),
        (True, 2.0, 20, "false valid"),
        (True, 2.0, 3, "false valid"),
        (True, 2.0, 2, "by chance"),
        (False, 2.0, None, "agree"),
        (False, 0.95, None, "at the line"),
        (False, 0.5, 0, "false invalid"),
        (False, 0.5, 1, "by chance"),
    ],
)
def test_chance_excuses_hardly_anything_that_is_called_valid(
    valid: bool, share: float, falls: int | None, outcome: str
) -> None:
    verdict = Verdict(id="new_1", valid=valid, reasons=() if valid else ("tilt",))
    case = Case(scene(), put(CRATE, 2.0, 2.0), CRATE)
    assert Judged(case, verdict, Truth(share, "tilt", 0.0, 0.0), falls).outcome == outcome


@pytest.mark.slow
def test_no_candidate_of_some_hundred_fools_the_verdict() -> None:
    found = list(run(plan(24 * 2 * len(FAMILIES), 1000, ""), 1))
    assert not [line for one in found for line in one.false if "false valid" in line], "\n".join(table(found))
    judged = sum(sum(one.counts.values()) for one in found)
    assert sum(one.counts["false invalid"] for one in found) <= 0.02 * judged, "\n".join(table(found))


def test_a_shelf_that_pushes_something_over_is_not_valid() -> None:
    found = [judged for judged in candidates("mounted", 40047) if judged is not None]
    assert not any(judged.outcome == "false valid" for judged in found)
    assert any("pushes" in judged.verdict.reasons and not judged.verdict.settled for judged in found)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("family", "seed"), [("apart", 70031), ("apart", 70047), ("leaning", 70067), ("rug", 81021), ("unequal", 81012)]
)
def test_hunts_that_once_found_a_hole_find_none(family: str, seed: int) -> None:
    found = hunt(family, seed)
    assert found.counts["false valid"] == 0, found.false
