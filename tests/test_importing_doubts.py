"""What is said of a layout whose numbers cannot be meant as they stand, or whose names are not kept."""

import json
from pathlib import Path
from typing import Any

import pytest

from thinkblox.errors import InputError
from thinkblox.importing import read_layout

THINGS = {
    "sofa-0": ("sofa", (0.6, 1.5, 0.42), (0.9, 2.0, 0.84)),
    "table-0": ("coffee table", (1.7, 1.5, 0.22), (0.6, 1.1, 0.44)),
    "vase-0": ("vase", (1.7, 1.5, 0.59), (0.15, 0.15, 0.3)),
    "lamp-0": ("pendant lamp", (2.0, 1.0, 2.3), (0.4, 0.4, 0.6)),
}


def _layout(position=1.0, size=1.0, room=1.0, order=(0, 1, 2), names=None) -> dict[str, Any]:
    assets = {
        (names or {}).get(name, name): {
            "category": kind,
            "position": [at[k] * position for k in order],
            "rotation": [0, 0, 0],
            "assetMetadata": {"boundingBox": dict(zip("xyz", (s * size for s in extent), strict=True))},
        }
        for name, (kind, at, extent) in THINGS.items()
    }
    corners = [[x * room, y * room, 0] for x, y in ((0, 0), (4, 0), (4, 3), (0, 3))]
    return {"boundary": {"floor_vertices": corners, "wall_height": 2.6 * room}, "assets": assets}


def _written(folder: Path, value: Any) -> Path:
    path = folder / "layout.json"
    path.write_text(value if isinstance(value, str) else json.dumps(value))
    return path


def test_units_and_axes_that_cannot_be_meant_are_named(tmp_path):
    def notes(**changes):
        return " ".join(read_layout(_written(tmp_path, _layout(**changes))).notes)

    assert notes() == ""
    assert "4 of 4 objects are outside the room; in it would be 4, were their positions in centimetres" in notes(
        position=100
    )
    assert "in millimetres" in notes(position=1000 / 3)
    assert "2 of 4 would: is another axis up" in notes(order=(0, 2, 1))
    assert "More than 20 times as large as usual: sofa-0, table-0, vase-0 and 1 more; sizes" in notes(size=40)
    assert "less than 1/20 as large" in notes(size=0.01)


def test_turns_in_radians_are_named(tmp_path):
    for turns, told in (((1.5708, 0, 3.14), True), ((1.5708, 30, 0), False), ((0, 90, 180), False)):
        layout = _layout()
        for asset, turn in zip(layout["assets"].values(), turns, strict=False):
            asset["rotation"] = [0, 0, turn]
        assert ("in radians" in " ".join(read_layout(_written(tmp_path, layout)).notes)) is told


def test_what_stands_on_a_rug_is_measured_on_the_floor_with_all_that_it_carries(tmp_path):
    layout = _layout()
    layout["assets"]["rug-0"] = {
        "category": "rug",
        "position": [1.7, 1.5, 0.01],
        "rotation": [0, 0, 0],
        "assetMetadata": {"boundingBox": {"x": 1.4, "y": 2.0, "z": 0.02}},
    }
    for name in ("table-0", "vase-0"):
        layout["assets"][name]["position"][2] += 0.02
    read = read_layout(_written(tmp_path, layout))
    bases = {p.id: round(p.position[2], 6) for p in read.scene.placements}
    assert bases == {"sofa-0": 0.0, "table-0": 0.0, "vase-0": 0.44, "lamp-0": 2.0, "rug-0": 0.0}
    assert read.notes == (
        "On a rug, which nothing collides with, and so measured on the floor under it: table-0, vase-0.",
    )


def test_numbers_out_of_range_are_told_with_place_value_and_unit(tmp_path):
    for changes, match in (
        ({"room": 100}, r"<= 100\.0, not 260; lengths are read in metres - at `\$\.boundary\.wall_height`"),
        (
            {"size": 100},
            r"not 200; lengths are read in metres - at `\$\.assets\.sofa-0\.assetMetadata\.boundingBox\.y`",
        ),
        ({"size": -1}, r"> 0\.0, not -0\.9 - at `\$\.assets\.sofa-0\.assetMetadata\.boundingBox\.x`"),
    ):
        with pytest.raises(InputError, match=match):
            read_layout(_written(tmp_path, _layout(**changes)))
    for text, match in (
        ('{"a":\n [1, NaN]}', "can hold, line 2, column 6"),
        (" ", "it is empty"),
        ('{"walls": 1, "furniture": []}', r"no layout that is read \('walls', 'furniture'\); say"),
    ):
        with pytest.raises(InputError, match=match):
            read_layout(_written(tmp_path, text))
    with pytest.raises(InputError, match=r"field `boundary`; there are `room` - at `\$`"):
        read_layout(_written(tmp_path, {"room": {}}), format="layoutvlm")


def test_what_is_called_otherwise_than_in_the_file_is_said(tmp_path):
    names = {"sofa-0": "Björn's sofa/bed", "table-0": "floor", "vase-0": "a vase"}
    layout = read_layout(_written(tmp_path, _layout(names=names)))
    assert [p.id for p in layout.scene.placements] == ["Bjorn_s_sofa_bed", "floor_2", "a_vase", "lamp-0"]
    assert layout.notes == ("Called otherwise here: \"Björn's sofa/bed\" is Bjorn_s_sofa_bed, 'floor' is floor_2.",)
    # In the scene they keep what they were called.
    assert "Björn's sofa/bed" in {asset.description for asset in layout.scene.assets.values()}


def test_a_layout_of_nothing_says_so(tmp_path):
    empty = _layout() | {"assets": {}}
    assert read_layout(_written(tmp_path, empty)).notes == (
        "The layout has nothing in it, so there is nothing that could fail.",
    )


def test_a_hole_in_no_wall_is_told() -> None:
    from thinkblox.importing.holodeck import _Hole, _lacks

    hole = _Hole(id="door", wall0="nope", wall1="", holePolygon=[])
    assert _lacks(hole, {"wall"}) == "no wall nope"
    assert _lacks(hole, {"nope"}) == "no two corners of it"
