"""A judge of pictures as a reward: what it is asked, how long it may take, and what becomes of its failures."""

import math
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from tests.sim_rooms import asset, put, scene, table
from tests.stub_server import Body, Reply, Stub, error, stub
from thinkblox import InputError
from thinkblox.errors import UnavailableError
from thinkblox.plan import Target, Tie
from thinkblox.policies.openai_server import Asking
from thinkblox.sim.workers.pool import VerdictPool
from thinkblox.steps import write_step
from thinkblox.training.outcome import Asked, Rollout, outcomes
from thinkblox.training.picture_judge import PictureJudge
from thinkblox.training.render_reward import RenderReward

pytest.importorskip("openai")
YES = {"Yes": math.log(0.8), "No": math.log(0.2)}
PATIENT = Asking(temperature=0.0, seconds=60.0, retries=0, at_once=3)
QUICK = replace(PATIENT, seconds=0.5)


@pytest.fixture(scope="module")
def rollouts() -> list[Rollout]:
    """Two chairs at a table, one that is in it, and a text that cannot be read."""
    chair, board = asset("chair", (0.5, 0.5, 0.9), mass=5.0), table()
    room = scene(None, (put(board, 2.0, 2.5), board))
    target = Target(id="chair_1", category="chair", request="chair", ties=(Tie(kind="at", anchors=("table_1",)),))
    texts = [write_step(["Here."], id="chair_1", position=(x, 2.5, 0.0), yaw=0.0, size=chair.size) for x in (1, 0.5, 2)]
    with VerdictPool(workers=0) as pool:
        return outcomes(pool, [(Asked(room, target, chair), [*texts, "nowhere"])])[0]


@pytest.fixture
def server() -> Iterator[Stub]:
    with stub(lambda body: "Yes", logprobs=YES) as made:
        yield made


def rewards(server: Stub, rollouts: list[Rollout], asking: Asking = PATIENT) -> list[float | None]:
    return RenderReward(PictureJudge(server.spec, asking=asking), size=64)(outcome=rollouts)


def test_the_reward_is_the_probability_of_yes(server: Stub, rollouts: list[Rollout]) -> None:
    assert rewards(server, rollouts) == pytest.approx([0.8, 0.8, 0.8, 0.0])
    (content,) = (message["content"] for message in server.seen[0]["messages"])
    assert [part["type"] for part in content] == ["text", "image_url", "image_url"]
    assert "Is chair_1 well placed?" in content[0]["text"]
    assert "table_1" in content[0]["text"]
    assert RenderReward(PictureJudge(server.spec)).name == "render:stub"


def test_no_more_requests_than_allowed_are_under_way(rollouts: list[Rollout]) -> None:
    with stub(lambda body: "Yes", logprobs=YES) as made:
        reply = made.reply

        def late(body: Body) -> Reply:
            time.sleep(0.05)
            return reply(body)

        made.reply = late  # type: ignore[method-assign]
        assert rewards(made, rollouts[:3] * 4) == pytest.approx([0.8] * 12)
    assert 1 < made.busiest <= PATIENT.at_once


def test_what_is_not_answered_has_no_reward(server: Stub, rollouts: list[Rollout]) -> None:
    server.first = [error(500, "no")]
    logged: dict[str, float] = {}
    judge = RenderReward(PictureJudge(server.spec, asking=PATIENT), size=64)
    found = judge(outcome=rollouts, log_metric=logged.__setitem__)
    assert sorted(found, key=str) == pytest.approx([0.0, 0.8, 0.8, None])
    assert logged == {"unanswered/render:stub": pytest.approx(1 / 3)}


def test_a_judge_that_hangs_ends_the_training_instead_of_it(server: Stub, rollouts: list[Rollout]) -> None:
    server.first = [Reply(seconds=30.0)] * 20
    judge = RenderReward(PictureJudge(server.spec, asking=QUICK), size=64)
    start = time.monotonic()
    assert judge(outcome=rollouts) == [None, None, None, 0.0]
    assert judge(outcome=rollouts) == [None, None, None, 0.0]
    with pytest.raises(UnavailableError, match=r"in time.*all of 3, 3 times in a row"):
        judge(outcome=rollouts)
    assert time.monotonic() - start < 25.0


def test_a_judge_that_cannot_judge_is_found_out_at_once(server: Stub) -> None:
    PictureJudge(server.spec).check()
    server.logprobs = None
    with pytest.raises(UnavailableError, match="no logprobs"):
        PictureJudge(server.spec).check()
    server.first = [error(400, "this model cannot see pictures")]
    with pytest.raises(InputError, match="cannot see"):
        PictureJudge(server.spec).check()
    with pytest.raises(InputError, match=r"openai:BASE_URL#MODEL"):
        PictureJudge("rules")


def test_training_asks_the_judge_before_it_reads_anything(server: Stub, tmp_path: Path) -> None:
    from thinkblox.training.config import GdpoConfig
    from thinkblox.training.gdpo import train_gdpo

    server.logprobs = None
    nowhere = str(tmp_path / "nothing")
    config = GdpoConfig(data=nowhere, out=nowhere, steps=1, soft=("align", "render"), judge=server.spec)
    with pytest.raises(UnavailableError, match="no logprobs"):
        train_gdpo(config)
    with pytest.raises(InputError, match="no tier has its reward"):
        GdpoConfig(data=nowhere, out=nowhere, steps=1, judge=server.spec)
