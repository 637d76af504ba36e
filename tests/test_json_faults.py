"""What a user is told of a file that is not what it should be: where, and what there could be."""

import json
from pathlib import Path

import pytest

from tests.layout_rooms import write
from thinkblox.cli import main
from thinkblox.errors import InputError
from thinkblox.evaluation.annotation_file import read_annotations
from thinkblox.evaluation.room_file import read_scene
from thinkblox.importing import read_layout
from thinkblox.importing.sizes import read_sizes
from thinkblox.scene.asset import Asset
from thinkblox.scene.room import Room, rectangle
from thinkblox.scene.scene import Scene, load_scene
from thinkblox.steps import Rejection, parse
from thinkblox.value import from_json, read_json, to_json

BROKEN = "{\n\n  room: 1}\n"


def _scene(folder: Path) -> Scene:
    return load_scene(folder / "scene.json")


READERS = [
    lambda path: read_json(path, Room),
    lambda path: _scene(path.parent),
    lambda path: read_scene(path.parent),
    read_annotations,
    read_sizes,
    read_layout,
]


@pytest.mark.parametrize("reader", READERS)
@pytest.mark.parametrize("begins", ["", "\ufeff"])
def test_broken_json_has_a_line_and_a_column(tmp_path, reader, begins):
    path = tmp_path / "scene.json"
    path.write_text(begins + (BROKEN if reader is not read_annotations else BROKEN.replace("{", "[{")), "utf-8")
    with pytest.raises(InputError, match=r"scene\.json: .*line 3,? column 3"):
        reader(path)


@pytest.mark.parametrize("reader", READERS[1:])
def test_bytes_that_are_no_text_have_a_line_and_a_column(tmp_path, reader):
    path = tmp_path / "scene.json"
    path.write_bytes(b'{\n  "prompt": "\xc3\xa9\xff"}')
    with pytest.raises(InputError, match=r"scene\.json: .*not UTF-8: line 2, column 15"):
        reader(path)


@pytest.mark.parametrize(
    ("text", "where"),
    [
        ('{"floor": [[0, 0],\n [1, 0]', "ends too early, line 2, column 8"),
        ("", "ends too early, line 1, column 1"),
        ('{"floor": [[0, 0], [4, 0], [0, 3]]}\n\n}', "trailing characters, line 3, column 2"),
        ('{"height":\r\n NaN}', "invalid character, line 2, column 2"),
        ('{"floor":\n "\u00e9\u00e9\\q"}', "in string, line 2, column 7"),
        ("[" * 100_000, "array"),
    ],
)
def test_where_a_text_stops_being_json(text, where):
    with pytest.raises(InputError, match=where):
        from_json(text, Room)


ROOM = json.loads(to_json(rectangle(4.0, 3.0)))
OPENING = "`id`, `kind`, `wall`, `offset`, `width`, `height`"


@pytest.mark.parametrize(
    ("kind", "document", "listed"),
    [
        (Room, {"flor": []}, "unknown field `flor`; there are `floor`, `height`, `openings`, `surfaces`"),
        (Room, ROOM | {"openings": [{"doors": 1}]}, rf"`doors` - at `\$.openings\[0\]`; there are {OPENING}"),
        (Room, ROOM | {"surfaces": {"flor": 1}}, r"`flor` - at `\$.surfaces`; there are `palette`, `floor`, `walls`"),
        (Scene, {"room": ROOM, "objects": []}, "`objects`; there are `version`, `prompt`, `seed`, `room`"),
        (Scene, {"assets": {"a": {"colour": 1}}}, r"`colour` - at `\$.assets\[...\]`; there are `id`, `category`"),
        (Asset, {"links": [{"shapes": [{"form": 1}]}]}, r"shapes\[0\]`; there are `kind`, `size`, `position`"),
        (Asset, {"links": [{"joint": {"form": 1}}]}, r"joint`; there are `kind`, `axis`, `anchor`, `lower`"),
    ],
)
def test_an_unknown_field_lists_those_that_there_are(kind, document, listed):
    with pytest.raises(InputError, match=listed):
        from_json(json.dumps(document), kind)


def test_an_unknown_field_with_control_characters_is_shown_harmless():
    with pytest.raises(InputError) as raised:
        from_json(json.dumps({"fl\x1b[31m`oor": 1}), Room)
    assert "\x1b" not in str(raised.value)


def test_an_unknown_field_of_an_annotation_lists_those_that_there_are(tmp_path):
    path = tmp_path / "annotations.json"
    path.write_text('[{"id": "a", "prompt": "a bed", "counts": []}]')
    with pytest.raises(InputError, match=r"entry 1 \(a\): .*`counts`; there are `id`, `prompt`, `style`, `count`"):
        read_annotations(path)
    path.write_text('[{"id": "a", "prompt": "a bed", "room": {"kinds": []}}]')
    with pytest.raises(InputError, match=r"`kinds` - at `\$.room`; there are `"):
        read_annotations(path)


def test_an_unknown_field_of_an_answer_is_told_to_the_policy():
    told = parse('<think>1. Here.</think><answer>{"id": "a_1", "pose": [1, 2, 0]}</answer>')
    assert isinstance(told, Rejection)
    assert "`pose`; there are `action`, `id`, `position`, `yaw`, `size`" in told.message


def test_a_command_says_where_a_room_file_is_broken(tmp_path, capsys):
    room = tmp_path / "room.json"
    room.write_text(BROKEN)
    assert main(["generate", "a bed", "--room", str(room), "--out", str(tmp_path / "out")]) == 2
    assert "room.json: is not JSON: object keys must be strings, line 3, column 3" in capsys.readouterr().err


def test_a_layout_that_is_no_text_is_refused_by_command(tmp_path, capsys):
    path = write(tmp_path, "holodeck")
    path.write_bytes(path.read_bytes().replace(b'"', b"\xff", 1))
    assert main(["verify", str(path)]) == 2
    assert "not UTF-8" in capsys.readouterr().err
