"""The search that tries to fool the verdict finds nothing in a small part of itself, and would find what is there."""

import pytest

from tests.bench.adversary import plan, run, table
from tests.bench.adversary_cases import FAMILIES
from tests.bench.adversary_hunt import candidates, hunt
from thinkblox.sim.verdict import stage


def test_a_hunt_is_the_same_twice() -> None:
    assert hunt("edge", 3) == hunt("edge", 3)


def test_a_verdict_that_believes_at_once_is_fooled(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(stage, "stands_squarely", lambda model, data: True)
    monkeypatch.setattr(stage, "at_rest", lambda model, data, body: True)
    monkeypatch.setattr(stage, "stayed", lambda before, now, interval: True)
    assert any(judged is not None and judged.outcome == "false valid" for judged in candidates("edge", 0))


@pytest.mark.slow
def test_no_candidate_of_some_hundred_fools_the_verdict() -> None:
    found = list(run(plan(24 * 2 * len(FAMILIES), 1000, ""), 1))
    assert not [line for one in found for line in one.false if "false valid" in line], "\n".join(table(found))
    judged = sum(sum(one.counts.values()) for one in found)
    assert sum(one.counts["false invalid"] for one in found) <= 0.02 * judged, "\n".join(table(found))
