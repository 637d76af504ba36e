import json

import pytest

from thinkblox.errors import InputError
from thinkblox.evaluation.annotation_file import read_annotations

HEADER = "ID,Difficulty,Description,ObjCount,ObjAttr,OORel,OARel\n"
ROW = (
    '0,easy,"A bedroom with a bed, and two nightstands.","eq,1,bed;eq,2,nightstand","eq,1,bed,white,wooden",'
    '"eq,2,next_to,0,bed,nightstand;eq,1,surround,0,table,chair:0,chair:1,chair:2",'
    '"eq,1,against,bed,wall;\n"\n'
)


def written(path, text):
    path.write_text(text, encoding="utf-8")
    return path


def test_the_published_csv(tmp_path):
    (found,) = read_annotations(written(tmp_path / "annotations.csv", HEADER + ROW))
    assert (found.id, found.style, found.prompt) == ("0", "easy", "A bedroom with a bed, and two nightstands.")
    assert [str(row) for row in found.counts] == ["eq 1 bed", "eq 2 nightstand"]
    assert found.attributes[0].attributes == ("white", "wooden")
    beside, around = found.object_relations
    assert (beside.relation, beside.anchor, beside.subjects) == ("next_to", "bed", ("nightstand",))
    assert around.subjects == ("chair", "chair", "chair")
    assert (found.element_relations[0].relation, found.element_relations[0].element) == ("against", "wall")
    assert found.categories == ("bed", "nightstand", "table", "chair")


def test_json_with_what_else_a_prompt_demands(tmp_path):
    entry = {
        "id": "n01",
        "style": "negation",
        "prompt": "a room",
        "count": [["ge", 1, "sofa"]],
        "oo": [["eq", 1, "on_top", 1, "candle", "stool"]],
        "absent": ["rug"],
        "room": {"kind": "living room", "size": [5, 6], "shape": "L"},
    }
    (found,) = read_annotations(written(tmp_path / "a.json", json.dumps([entry])))
    assert (found.object_relations[0].anchor, found.object_relations[0].subjects) == ("stool", ("candle",))
    assert found.absent == ("rug",)
    assert (found.room.size, found.room.shape) == ((5.0, 6.0), "L")


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"count": [["eq", 1, "bed"], ["eq", "two", "bed"]]}, "entry 1 (x), count, row 2: the number is 'two'"),
        ({"count": [["about", 1, "bed"]]}, "begins with 'about'; a quantifier is one of eq, ge, gt, le, lt"),
        ({"count": [["eq", -1, "bed"]]}, "the number is -1"),
        ({"count": [["eq", 1]]}, "has 2 fields; the form is: q, n, category"),
        ({"count": [["eq", 1, ""]]}, "has '' where a word is needed"),
        ({"oo": [["eq", 1, "on_top", 2, "a", "b"]]}, "entry 1 (x), oo, row 1: the index of the anchor is 2"),
        ({"oa": [["eq", 1, "near", "desk"]]}, "oa, row 1: has 4 fields"),
        ({"attr": [["eq", 1, "desk"]]}, "attr, row 1: has 3 fields"),
        ({"colour": "red"}, "colour"),
        ({"count": "eq,1,bed"}, "count"),
        ({"prompt": None}, "prompt"),
    ],
)
def test_a_broken_entry_is_named_with_its_column_and_row(tmp_path, change, says):
    entry = {"id": "x", "prompt": "a room"} | change
    with pytest.raises(InputError) as error:
        read_annotations(written(tmp_path / "a.json", json.dumps([entry])))
    assert says in str(error.value)
    assert str(tmp_path / "a.json") in str(error.value)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("ID,Description\n1,a room\n", "has no column Difficulty, ObjCount"),
        (HEADER + '7,easy,"a room","eq,1,bed;eq,x,bed",,,\n', "line 2 (7), ObjCount, row 2: the number is 'x'"),
        (HEADER + "7,easy,,,,,\n", "the column Description is empty"),
        (HEADER, "holds no annotated prompt"),
        (HEADER + "7,easy,a room,,,,\n7,easy,a room,,,,\n", "two entries have the id '7'"),
    ],
)
def test_a_broken_csv(tmp_path, text, says):
    with pytest.raises(InputError) as error:
        read_annotations(written(tmp_path / "a.csv", text))
    assert says in str(error.value)


@pytest.mark.parametrize("text", ["", "{}", "[1]", '[{"id": "x"', "[" * 100_000])
def test_what_is_no_list_of_prompts(tmp_path, text):
    with pytest.raises(InputError, match="list of annotated prompts"):
        read_annotations(written(tmp_path / "a.json", text))


def test_bytes_that_are_no_text(tmp_path):
    (tmp_path / "a.csv").write_bytes(b"\xff\xfe\x00ID")
    with pytest.raises(InputError, match="UTF-8"):
        read_annotations(tmp_path / "a.csv")
