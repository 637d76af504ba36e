"""Rooms of unknown height, and what hangs in them."""

import json
from pathlib import Path
from typing import Any

import pytest

from tests.layout_rooms import Plan, Thing, write
from thinkblox.importing import ForeignLayout, read_layout
from thinkblox.importing.usual import hangs, is_lamp, usual
from thinkblox.sim.verdict.verify import verify
from thinkblox.value import Vec3


def _read(folder: Path, *things: Thing, format: str = "layoutgpt", **options: Any) -> ForeignLayout:
    return read_layout(write(folder, format, Plan(4.0, 5.0, 2.8, things)), format=format, **options)


def _hung(name: str, top: float, height: float = 0.4, at: Vec3 = (2.0, 2.0, 0.0)) -> Thing:
    return Thing(name, (at[0], at[1], top - height), 0.0, (0.3, 0.3, height))


@pytest.mark.parametrize(
    "name", ["pendant_lamp", "ceiling_lamp", "Chandelier", "pendant light", "hanging_lamp_2", "chandeliers"]
)
@pytest.mark.parametrize("format", ["layoutgpt", "il3d"])
@pytest.mark.parametrize("top", [1.9, 2.4, 2.6, 2.75, 3.4])
def test_hanging_lamps_hang_whatever_the_height_of_the_room(tmp_path: Path, name: str, format: str, top: float) -> None:
    layout = _read(tmp_path, _hung(name, top), format=format)
    (lamp,) = layout.scene.placements
    assert lamp.support == "ceiling"
    assert layout.scene.room.height == pytest.approx(max(2.6, top), abs=1e-6)
    assert lamp.position[2] == pytest.approx(top - 0.4)
    report = verify(layout.scene)
    assert report.valid, [str(v) for v in report.objects]
    assert any("cord" in note for note in layout.notes) == (top < 2.6)


def test_lamps_of_different_heights_all_hang(tmp_path: Path) -> None:
    layout = _read(
        tmp_path, _hung("pendant_lamp", 2.9), _hung("ceiling_lamp", 2.2, 0.1, (1.0, 1.0, 0.0)),
        Thing("wardrobe", (3.0, 4.0, 0.0), 0.0, (0.6, 1.2, 2.1)),
    )  # fmt: skip
    assert layout.scene.room.height == pytest.approx(2.9)
    assert verify(layout.scene).valid
    assert [p.top for p in layout.scene.placements] == pytest.approx([2.9, 2.9, 2.1])


def test_a_room_of_unknown_height_is_as_high_as_what_stands_in_it(tmp_path: Path) -> None:
    layout = _read(tmp_path, Thing("wardrobe", (2.0, 3.0, 0.0), 0.0, (0.6, 1.2, 2.95)))
    assert layout.scene.room.height == pytest.approx(2.95)
    assert verify(layout.scene).valid
    assert any("2.95 m" in note for note in layout.notes)


def test_a_height_that_is_given_holds(tmp_path: Path) -> None:
    tall = Thing("wardrobe", (2.0, 3.0, 0.0), 0.0, (0.6, 1.2, 2.95))
    lamp = _hung("pendant_lamp", 2.0)
    report = verify(_read(tmp_path, tall, lamp, height=2.6).scene)
    assert [v.reasons for v in report.objects] == [("outside",), ("unsupported",)]
    assert not verify(_read(tmp_path, lamp, format="holodeck").scene).valid, "2.8 m stands in the file"


def test_what_is_no_lamp_does_not_hang_from_a_ceiling_that_nobody_gave(tmp_path: Path) -> None:
    layout = _read(
        tmp_path, _hung("chair", 3.0), _hung("lamp", 2.3, at=(1.0, 1.0, 0.0)), _hung("lamp", 0.9, at=(3.0, 1.0, 0.0))
    )
    assert [layout.scene.asset_of(p).mount for p in layout.scene.placements] == ["floor", "ceiling", "floor"]
    assert [v.valid for v in verify(layout.scene).objects] == [False, True, False]


def test_what_is_on_the_floor_stands_there_whatever_it_is_called(tmp_path: Path) -> None:
    (lamp,) = _read(tmp_path, _hung("pendant_lamp", 0.4)).scene.placements
    assert lamp.support == "floor"


def test_the_layouts_own_word_goes_before_the_catalogues(tmp_path: Path) -> None:
    path = write(tmp_path, "idesign", Plan(4.0, 5.0, 2.8, (_hung("chandelier", 0.4),)))
    graph = json.loads(path.read_text())
    assert graph[0]["is_on_the_floor"]
    assert read_layout(path).scene.placements[0].support == "floor"


def test_words_of_the_catalogue_name_its_categories() -> None:
    assert hangs("brass chandelier")
    assert not hangs("floor_lamp")
    assert not hangs("thing")
    assert is_lamp("a green lamp")
    assert not is_lamp("lamp table")
    end = usual("round_end_table")
    assert end is not None
    assert end.name == "side_table"
