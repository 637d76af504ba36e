"""The engine is silent while anybody wants it to be, and speaks as before once nobody does."""

import threading
from collections.abc import Iterator

import mujoco
import pytest

from thinkblox.sim.quiet import quiet_engine

BURSTS = '<mujoco><worldbody><body><freejoint/><geom type="sphere" size=".1"/></body></worldbody></mujoco>'


@pytest.fixture
def heard() -> Iterator[list[str]]:
    """What the engine says to the handler that was there before."""
    texts: list[str] = []
    mujoco.set_mju_user_warning(texts.append)
    yield texts
    mujoco.set_mju_user_warning(None)


def warn() -> int:
    """Make the engine warn; how many warnings it counted."""
    model = mujoco.MjModel.from_xml_string(BURSTS)
    data = mujoco.MjData(model)
    data.qvel[:] = 1e20
    mujoco.mj_step(model, data)
    return int(data.warning[int(mujoco.mjtWarning.mjWARN_BADQVEL)].number)


def test_within_it_warnings_are_counted_and_not_said(heard: list[str]) -> None:
    with quiet_engine():
        assert warn() > 0
    assert heard == []
    warn()
    assert heard


def test_it_can_be_nested(heard: list[str]) -> None:
    with quiet_engine():
        with quiet_engine():
            pass
        warn()
        assert heard == []
    warn()
    assert heard


def test_two_threads_that_overlap_leave_the_handler_as_it_was(heard: list[str]) -> None:
    first_is_in, second_is_in, first_is_out = (threading.Event() for _ in range(3))

    def first() -> None:
        with quiet_engine():
            first_is_in.set()
            assert second_is_in.wait(10.0)
        first_is_out.set()

    thread = threading.Thread(target=first)
    thread.start()
    assert first_is_in.wait(10.0)
    with quiet_engine():
        second_is_in.set()
        assert first_is_out.wait(10.0)
        warn()
        assert heard == [], "the first to leave must not let the engine speak while another wants it silent"
    thread.join()
    warn()
    assert heard, "the last to leave gives back the handler that was there before either came"


def test_it_is_left_when_something_fails_within(heard: list[str]) -> None:
    with pytest.raises(LookupError), quiet_engine():
        raise LookupError
    warn()
    assert heard
