"""Every situation of the gallery has the verdict that a person would give."""

import pytest

from tests.situations import FALLS, SITUATIONS, Situation
from thinkblox.sim.verdict.world import World


def row(situation: Situation) -> object:
    marks = pytest.mark.xfail(reason=situation.pending, strict=True) if situation.pending else ()
    return pytest.param(situation, id=situation.name, marks=marks)


@pytest.mark.parametrize("situation", [row(situation) for situation in SITUATIONS])
def test_the_verdict_is_that_of_a_person(situation: Situation) -> None:
    scene, placement, kind = situation.build()
    verdict = World(scene).check([placement], kind)[0]
    if situation.falls:
        assert verdict.reasons, "it stays where it is"
        assert set(verdict.reasons) <= FALLS, str(verdict)
    else:
        assert verdict.reasons == situation.reasons, str(verdict)
    if situation.supports is not None:
        assert tuple(support.by for support in verdict.supports) == situation.supports
    assert verdict.blocked == situation.blocked


def test_the_gallery_is_large_and_every_situation_has_its_name() -> None:
    assert len(SITUATIONS) >= 60
    assert len({situation.name for situation in SITUATIONS}) == len(SITUATIONS)
