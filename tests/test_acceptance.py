"""The figures that the main job must reach, over every prompt of the benchmark."""

from pathlib import Path

import pytest

from tests.bench.rooms import PROMPTS, Row, run


@pytest.mark.slow
@pytest.mark.parametrize("seed", [0, 1])
def test_every_prompt_is_placed_related_and_still(tmp_path: Path, seed: int) -> None:
    prompts = PROMPTS.read_text().splitlines()
    rows = [run((prompt, seed, "essentials", tmp_path / str(number))) for number, prompt in enumerate(prompts)]
    done = [row for row in rows if isinstance(row, Row)]
    assert len(done) == len(prompts) == 22
    assert all(row.listed for row in done)
    assert sum(row.placed for row in done) >= 0.97 * sum(row.asked for row in done)
    assert sum(row.hold for row in done) >= 0.95 * sum(row.relations for row in done)
    assert max(row.depth for row in done) < 1.0
    assert max(row.drift for row in done) < 10.0
    assert max(row.tilt for row in done) < 2.0
