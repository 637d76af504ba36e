"""Layouts with something wrong in them, through to the verdict: no traceback, and no pass on garbage."""

import copy
import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from tests.layout_rooms import write
from tests.test_importing_hostile import _mutated, _places
from thinkblox.cli import main
from thinkblox.errors import InputError
from thinkblox.importing import FORMATS, ForeignLayout, read_layout
from thinkblox.mending import mend
from thinkblox.sim.verdict.verify import verify

pytestmark = pytest.mark.slow
GENERATE = (Phase.explicit, Phase.generate)
SOME = settings(max_examples=6, deadline=None, phases=GENERATE, suppress_health_check=list(HealthCheck))
MANY = settings(SOME, max_examples=100)


def _read(path: Path, format: str) -> ForeignLayout | None:
    try:
        return read_layout(path, format=format, short_side=3.0)
    except InputError:
        return None


def _put(raw: Any, place: tuple[Any, ...], value: Any) -> Any:
    changed = copy.deepcopy(raw)
    target = changed
    for step in place[:-1]:
        target = target[step]
    target[place[-1]] = value
    return changed


def _at(raw: Any, place: tuple[Any, ...]) -> Any:
    for step in place:
        raw = raw[step]
    return raw


@pytest.mark.parametrize("format", FORMATS)
@MANY
@given(data=st.data())
def test_a_number_that_is_none_is_refused_or_of_no_account(
    tmp_path_factory: pytest.TempPathFactory, format: str, data: st.DataObject
) -> None:
    path = write(tmp_path_factory.mktemp("numbers"), format)
    raw, whole = json.loads(path.read_text()), _read(path, format)
    numbers = [place for place in _places(raw) if isinstance(_at(raw, place), float)]
    numbers = numbers or [place for place in _places(raw) if type(_at(raw, place)) is int]
    garbage = data.draw(st.sampled_from(["1.0", "garbage", [], {}, [1.0], True, 1e17, -1e17]))
    path.write_text(json.dumps(_put(raw, data.draw(st.sampled_from(numbers)), garbage)))
    found = _read(path, format)
    assert found is None or found == whole


@pytest.mark.parametrize("format", FORMATS)
@SOME
@given(data=st.data())
def test_mutations_are_measured_and_mended_or_refused(
    tmp_path_factory: pytest.TempPathFactory, format: str, data: st.DataObject
) -> None:
    path = write(tmp_path_factory.mktemp("mutated"), format)
    path.write_text(json.dumps(_mutated(json.loads(path.read_text()), data.draw)))
    layout = _read(path, format)
    if layout is not None:
        verify(layout.scene)
        mended, moves = mend(layout.scene, tries=10)
        assert all(move.distance <= 0.301 for move in moves)
        assert {p.id for p in mended.placements} == {p.id for p in layout.scene.placements}


@pytest.mark.parametrize("format", FORMATS)
@pytest.mark.parametrize("share", [0.0, 0.5, 0.999])
def test_half_a_file_is_status_2(tmp_path: Path, capsys: pytest.CaptureFixture[str], format: str, share: float) -> None:
    path = write(tmp_path, format)
    text = path.read_text()
    path.write_text(text[: int(share * len(text))])
    assert main(["verify", str(path)]) == 2
    printed = capsys.readouterr()
    assert path.name in printed.err
    assert "Traceback" not in printed.err + printed.out


@pytest.mark.parametrize("format", FORMATS)
def test_a_layout_without_its_objects_is_refused_or_says_so(tmp_path: Path, format: str) -> None:
    path = write(tmp_path, format)
    raw = json.loads(path.read_text())
    for place in [p for p in _places(raw) if p and isinstance(_at(raw, p), list | dict)]:
        path.write_text(json.dumps(_put(raw, place, "gone")))
        layout = _read(path, format)
        assert layout is None or len(layout.scene.placements) + len(layout.unplaced) >= 4
