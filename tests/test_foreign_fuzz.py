"""Whatever a model's text holds, it is measured or refused: nothing crashes, hangs or raises anything else."""

import math
import re
import shutil
from pathlib import Path

import mujoco
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.foreign_models import MODELS
from tests.mutants import mutated_xml
from thinkblox.errors import InputError
from thinkblox.sim.engine_errors import ENGINE_ERRORS
from thinkblox.sim.foreign.model_report import model_report
from thinkblox.sim.foreign.opening import open_model
from thinkblox.sim.quiet import quiet_engine
from thinkblox.sim.workers.guard import guarded

TABLE_FILE = "table_description/urdf/table.urdf"
RICH = (MODELS / "rich.xml").read_text()
TABLE = re.sub(r"<mesh filename=[^>]*scale[^>]*>", '<box size=".1 .1 .1"/>', (MODELS / TABLE_FILE).read_text())


def outcomes(file: Path, texts: tuple[str, ...], opened: Path | None = None) -> list[str]:
    """ "measured" or "refused" for every text, each written to the same file; else what was wrong.

    Args:
        file: that is written.
        texts: that are tried.
        opened: the model that is opened, which includes the file; the file itself unless told otherwise.
    """
    found = []
    for text in texts:
        file.write_text(text, errors="surrogatepass")
        try:
            found.append(_outcome(opened or file))
        except InputError as error:
            found.append("refused" if str(error).strip().isprintable() else f"raw: {error}")
    return found


def _outcome(path: Path) -> str:
    subject = open_model(path)
    report = model_report(subject, seconds=0.05)
    if not all(map(math.isfinite, (report.depth, report.drift, report.tilt, report.simulated))):
        return "not finite"
    plain = any(note.startswith(("A picture", "pictures")) for note in report.notes)
    if subject.source == "mjcf" and not plain and not _engine_takes(path):
        return "measured what the engine refuses"
    return "measured"


@quiet_engine()
def _engine_takes(path: Path) -> bool:
    try:
        mujoco.MjModel.from_xml_path(str(path))
    except ENGINE_ERRORS:
        return False
    return True


@pytest.mark.slow
@pytest.mark.parametrize("name", ["room.xml", "table.urdf"])
@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture], derandomize=True)
@given(seeds=st.lists(st.integers(0, 2**32), min_size=40, max_size=40), times=st.integers(1, 6))
def test_mutated_models_are_measured_or_refused(tmp_path: Path, name: str, seeds: list[int], times: int) -> None:
    seed_text = RICH if name == "room.xml" else TABLE
    texts = tuple(mutated_xml(seed_text, seed, times) for seed in seeds)
    found = guarded(outcomes, tmp_path / name, texts, seconds=120.0)
    assert set(found) <= {"measured", "refused"}


def test_the_texts_that_are_mutated_are_good(tmp_path: Path) -> None:
    assert outcomes(tmp_path / "room.xml", (RICH, TABLE)) == ["measured", "measured"]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["room.xml", "parts/assets.xml", "parts/table.xml"])
@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture], derandomize=True)
@given(seeds=st.lists(st.integers(0, 2**32), min_size=40, max_size=40), times=st.integers(1, 4))
def test_models_of_several_files_are_measured_or_refused(
    tmp_path: Path, name: str, seeds: list[int], times: int
) -> None:
    room = tmp_path / "room"
    shutil.copytree(MODELS / "room", room, dirs_exist_ok=True)
    text = (MODELS / "room" / name).read_text()
    texts = tuple(mutated_xml(text, seed, times) for seed in seeds)
    found = guarded(outcomes, room / name, texts, room / "room.xml", seconds=120.0)
    assert set(found) <= {"measured", "refused"}


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture], derandomize=True)
@given(share=st.floats(0.0, 0.999), urdf=st.booleans())
def test_no_part_of_a_file_is_taken_for_a_model(tmp_path: Path, share: float, urdf: bool) -> None:
    text = (TABLE if urdf else RICH).rstrip()
    file = tmp_path / ("table.urdf" if urdf else "room.xml")
    file.write_text(text[: int(share * len(text))])
    with pytest.raises(InputError, match=re.escape(file.name)):
        open_model(file)


@pytest.mark.slow
@settings(max_examples=200, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.binary(max_size=300))
def test_any_bytes_are_refused(tmp_path: Path, data: bytes) -> None:
    file = tmp_path / "room.xml"
    file.write_bytes(data)
    with pytest.raises(InputError, match=r"room\.xml"):
        open_model(file)
