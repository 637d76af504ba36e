import json
import re
from pathlib import Path

import jsonschema
import pytest

from thinkblox.cli import main
from thinkblox.generate import generate_room
from thinkblox.scene.scene import SCENE_VERSION
from thinkblox.schemas import SCHEMAS, published_schema
from thinkblox.value import Value, json_schema, to_json

PUBLISHED = Path(__file__).parent.parent / "docs" / "schema"


@pytest.mark.parametrize("name", SCHEMAS)
def test_what_is_published_is_what_the_code_reads(name):
    document = json.loads((PUBLISHED / f"{name}.schema.json").read_text())
    assert document == json.loads(json.dumps(published_schema(name))), "run make schemas"
    jsonschema.Draft202012Validator.check_schema(document)


@pytest.mark.parametrize("name", SCHEMAS)
def test_a_schema_says_what_it_is_and_where_it_is_known(name):
    document = published_schema(name)
    assert document["$id"] == f"https://github.com/thinkblox/thinkblox/schema/v{SCENE_VERSION}/{name}.schema.json"
    assert document["title"] == f"ThinkBLOX {name}"
    assert document["description"]


def test_patterns_are_ones_that_every_validator_reads():
    texts = [json.dumps(published_schema(name)) for name in SCHEMAS]
    patterns = [pattern for text in texts for pattern in re.findall(r'"pattern": "(.*?)"', text)]
    assert patterns
    assert all(pattern.endswith("$") for pattern in patterns)
    assert not any(pattern.endswith("Z$") for pattern in patterns)


def test_descriptions_have_no_indents_of_the_source():
    assert not any("\\n        Raises" in json.dumps(published_schema(name)) for name in SCHEMAS)


def test_a_real_room_is_valid_by_its_schemas():
    result = generate_room("A dining room with a table with two chairs and a vase on it.")
    documents: dict[str, Value] = {
        "scene": result.scene,
        "room": result.scene.room,
        "report": result.report,
        "verdict": result.report.objects[0],
        "trace": result.trace[0],
        "brief": result.plan.brief,
        "plan": result.plan,
    }
    for name, value in documents.items():
        jsonschema.validate(json.loads(to_json(value)), json_schema(SCHEMAS[name]))


def test_the_command_lists_and_prints(capsys):
    assert main(["schema"]) == 0
    assert capsys.readouterr().out.split() == list(SCHEMAS)
    assert main(["schema", "room"]) == 0
    assert json.loads(capsys.readouterr().out)["$schema"].endswith("2020-12/schema")
    assert main(["schema", "sofa"]) == 2
    assert "scene" in capsys.readouterr().err
