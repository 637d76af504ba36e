"""A number has one form in a verdict: no zero is negative, none is an int, and who measured it makes no difference."""

import math
import re
from collections.abc import Iterator

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.sim_rooms import asset, put, scene, table, vase, wardrobe
from thinkblox.scene.asset import Asset
from thinkblox.sim.verdict.verify import verify
from thinkblox.sim.verdict.world import World
from thinkblox.sim.workers.pool import VerdictPool
from thinkblox.suite import Criterion, Finding
from thinkblox.value import from_json, to_json
from thinkblox.verdict import Collision, MendingMove, Report, Swing, Verdict

CRATE = asset("crate", (0.5, 0.5, 0.5))
KINDS: tuple[Asset, ...] = (CRATE, table(), vase(), wardrobe())
NEGATIVE_ZERO = re.compile(rb"-0\.?0*(?![\d.e])")


@pytest.fixture(scope="module")
def pool() -> Iterator[VerdictPool]:
    with VerdictPool(workers=1) as shared:
        yield shared


@pytest.mark.parametrize(
    ("value", "same"),
    [
        (Verdict(id="a", valid=True, boundary=-0.0, drop=-0.0), Verdict(id="a", valid=True)),
        (Verdict(id="a", valid=True, overlap=0, depth=1, rest=0), Verdict(id="a", valid=True, depth=1.0, rest=0.0)),
        (Collision(other="b", depth=1, overlap=-0.0), Collision(other="b", depth=1.0, overlap=0.0)),
        (Swing(of="a", link="door", opens=1), Swing(of="a", link="door", opens=1.0)),
        (
            MendingMove(id="a", by=(-0.0, 0, 1), turn=-0.0, distance=1, why=("drop",), mended=True),
            MendingMove(id="a", by=(0.0, 0.0, 1.0), turn=0.0, distance=1.0, why=("drop",), mended=True),
        ),
        (Report(valid=True, depth=-0.0, drift=0), Report(valid=True)),
        (Finding(object="a", value=0, passed=True), Finding(object="a", value=-0.0, passed=True)),
        (
            Criterion(name="a", says="b", unit="m", limit=1, value=None, passed=None),
            Criterion(name="a", says="b", unit="m", limit=1.0, value=None, passed=None),
        ),
    ],
    ids=lambda value: type(value).__name__,
)
def test_however_a_number_was_computed_its_bytes_are_the_same(value: Verdict, same: Verdict) -> None:
    assert to_json(value) == to_json(same)
    assert not NEGATIVE_ZERO.search(to_json(value))
    assert to_json(from_json(to_json(value), type(value))) == to_json(value)


def test_a_reward_of_nothing_is_no_negative_zero() -> None:
    verdict = Verdict(id="a", valid=True, boundary=-1.0)
    assert [math.copysign(1.0, reward) for reward in (verdict.r_coll, verdict.r_layout)] == [1.0, 1.0]
    wrong = Verdict(id="a", valid=False, overlap=0.1, boundary=0.2)
    assert (wrong.r_coll, wrong.r_layout) == (-math.tanh(0.5), -math.tanh(0.2))


coordinate = st.sampled_from((0, 1, 2, 0.25, 0.25 + 1e-9, 0.3, 1.6, 2.0, 3.75, 3.75 + 1e-9, 4.75)) | st.floats(0.0, 5.0)
height = st.sampled_from((0, 0.0, -0.0, 0.5, 0.75, 0.75 + 1e-9, 0.7501, -0.1, 0.1, 2.1))


@settings(max_examples=40, deadline=None, derandomize=True)
@given(st.sampled_from(KINDS), coordinate, coordinate, height, st.sampled_from((0, 90.0, -0.0, 45.0, 359.9)))
def test_a_verdict_is_the_same_to_the_byte_directly_and_from_a_worker(
    pool: VerdictPool, kind: Asset, x: float, y: float, z: float, yaw: float
) -> None:
    room = scene(None, (put(table(), 2.0, 2.0), table()), (put(CRATE, 0.25, 0.25), CRATE))
    candidate = put(kind, x, y, z, yaw, id="new_1")
    (direct,) = World(room).check([candidate], kind)
    (pooled,) = pool.check_one(room, kind, [candidate])
    assert to_json(direct) == to_json(pooled)
    assert not NEGATIVE_ZERO.search(to_json(direct))


def test_a_report_has_no_negative_zero_either() -> None:
    flush = scene(None, (put(CRATE, 0.25 - 1e-9, 2, 0), CRATE), (put(table(), 2, 2, -0.0), table()))
    assert not NEGATIVE_ZERO.search(to_json(verify(flush)))
